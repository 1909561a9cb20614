//! Expressions as people write them: with the names of the declaration, factored, as text, source and LaTeX.
//!
//! A formula is for reading only. A [`Poly`] proves, a [`Graph`] computes; both can be converted into a formula.

mod closed_form;
mod expression;
mod factor;
mod names;
mod node;
mod print;

use crate::model::Model;
use crate::symbolic::{Graph, Id, Poly, Ring};
pub(crate) use closed_form::{ClosedForm, angle_of_one, first_branch, is_readable};
pub use expression::Formula;
pub(crate) use factor::common_number;
pub use node::NamedNodes;

impl Formula {
    /// A polynomial, factored: common factors first, then Horner's scheme by the most frequent sine or cosine.
    ///
    /// `ring` is the model's, or one that grew out of it (that of a solved graph).
    #[must_use]
    pub fn of_poly(model: &Model, ring: &Ring, poly: &Poly) -> Self {
        factor::of_poly(model, ring, poly)
    }

    /// A node of a graph, its structure kept; nodes in `known` are written by their names there.
    #[must_use]
    pub fn of_node(model: &Model, graph: &Graph, node: Id, known: &NamedNodes) -> Self {
        node::of_node(model, graph, node, known)
    }

    /// Mathematical text: `(x cos C + y sin C) cos B - (z - d) sin B`.
    #[must_use]
    pub fn text(&self) -> String {
        print::text(self)
    }

    /// In the language of the macro: `(x * cos(C) + y * sin(C)) * cos(B) - (z - d) * sin(B)`.
    #[must_use]
    pub fn source(&self) -> String {
        print::source(self)
    }

    /// For LaTeX, in mathematical mode: `(x\cos C + y\sin C)\cos B - (z - d)\sin B`.
    #[must_use]
    pub fn latex(&self) -> String {
        print::latex(self)
    }
}
