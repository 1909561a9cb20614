//! Tokens to [`Declaration`]: the grammar of `machine!`, and the source locations of its parts.

mod arithmetic;
mod ast;
mod chain;
mod entries;
mod equations;
mod expr;
mod fields;
mod parse;
mod source;
mod values;

pub use ast::{
    Assign, Base, Chain, Declaration, DimensionValue, Direction, Equation, Limits, Offsets, SpannedName, Unreadable,
    Vector, Verify,
};
pub use expr::{Expr, ExprKind, Unit};
pub use parse::parse;
