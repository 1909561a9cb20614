//! Tokens to [`Declaration`]: the only place that knows how `machine!` is written, and where.

mod arithmetic;
mod ast;
mod expr;
mod parse;
mod source;

pub use ast::{Assign, Base, Chain, Declaration, Direction, Equation, Limits, Offsets, SpannedName, Vector, Verify};
pub use expr::{Expr, ExprKind, Unit};
pub use parse::parse;
