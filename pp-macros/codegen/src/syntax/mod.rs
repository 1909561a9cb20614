//! Tokens to [`Declaration`]: the grammar of `machine!`, and the source locations of its parts.

mod arithmetic;
mod ast;
mod expr;
mod parse;
mod source;

pub use ast::{Assign, Base, Chain, Declaration, Direction, Equation, Limits, Offsets, SpannedName, Vector, Verify};
pub use expr::{Expr, ExprKind, Unit};
pub use parse::parse;
