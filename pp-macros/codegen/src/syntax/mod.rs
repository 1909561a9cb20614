//! Tokens to [`Declaration`]: the only place that knows how `machine!` is written, and where.

mod ast;
mod expr;
mod parse;

pub use ast::{Assign, Axis, Base, Chain, Declaration, Direction, Equation, Limits, Offsets, Spot, Vector, Verify};
pub use expr::{Expr, ExprKind, Unit};
pub use parse::parse;
