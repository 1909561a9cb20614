//! The same kinematics as C99: a structure, its defaults, forward and inverse kinematics, and the linear axes.
//!
//! The formulas are the nodes that are printed as Rust; only the guards around them are written here again, and
//! compared with those of Rust by running both. The text is a part of the machine, since the graph exists while it is
//! compiled only; [`PREFIX`] in it becomes the name that a caller gives. Functions are `static inline`, allocate
//! nothing and contain no loop; they call `sqrt`, `fabs` and `isfinite`, and `sin`, `cos` and `atan2` with the prefix,
//! which the caller defines.

mod branch;
mod code;
mod edge;
mod functions;
mod inverse;
mod shared;
mod structure;

use crate::model::Model;
use crate::solve::Solved;
use code::Code;

/// The prefix of all names of the text; a character that C does not have.
const PREFIX: &str = "@";

/// Names of the dimensions in the structure, and the text.
pub(crate) fn source(model: &Model, solved: &Solved) -> (Vec<String>, String) {
    let mut code = Code::default();
    structure::structure(model, &mut code);
    structure::default(model, &mut code);
    functions::angles(&mut code);
    functions::forward(model, solved, &mut code);
    functions::position(model, solved, &mut code);
    functions::linear_axes(model, solved, &mut code);
    inverse::inverse(model, solved, &mut code);
    (model.dimensions.iter().map(|dimension| model.c_field(&dimension.name)).collect(), code.text())
}
