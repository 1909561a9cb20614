//! The derived formulas as `verify` blocks: a declaration with them compiles.
//!
//! Formulas that are computed step by step, because they are too long for a line, are left out with a comment.

use super::chain::{letter, named, vector};
use super::inverse::InverseFormulas;
use super::linear::LinearFormulas;
use super::section::Section;
use crate::formula::Formula;
use crate::model::Model;
use crate::solve::{Orientation, Solved};

type Equations = Vec<(Formula, Formula)>;

/// A block for each branch: pose and linear axes in the first.
pub(crate) fn verify_blocks(model: &Model, solved: &Solved, inverse: &InverseFormulas) -> Section {
    let product = model.product();
    let axis = product.rotate(&model.tool_axis, &model.ring);
    let mut first = named(["i", "j", "k"], vector(model, &axis));
    first.extend(named(["x", "y", "z"], vector(model, &product.origin())));
    let branches = rotary_equations(model, solved, inverse);
    first.extend(branches.first().cloned().unwrap_or_default());
    let linears = inverse.linear.as_ref().map(LinearFormulas::equations);
    first.extend(linears.clone().unwrap_or_default());
    let mut left_out = Vec::new();
    if branches.is_empty() && model.solved_rotaries().next().is_some() {
        left_out.push(model.letters(model.solved_rotaries()));
    }
    if linears.is_none() {
        left_out.push(model.letters(model.solved_linears()));
    }
    let mut section = Section::default();
    let name = if branches.len() > 1 { ", first branch" } else { "" };
    section.block(&format!("derived from the chain of {}{name}", model.name), &first, &left_out);
    if let [_, second] = &branches[..] {
        section.block(&format!("derived from the chain of {}, second branch", model.name), second, &[]);
    }
    section
}

/// The rotary axes of each branch; empty where they are too long for a line.
fn rotary_equations(model: &Model, solved: &Solved, inverse: &InverseFormulas) -> Vec<Equations> {
    match &solved.orientation {
        Orientation::Fixed { .. } => Vec::new(),
        Orientation::One(one) => {
            inverse.one.iter().map(|angle| vec![(letter(model, one.rotary), angle.clone())]).collect()
        }
        Orientation::Two(two) => match inverse.two.clone() {
            None => Vec::new(),
            Some(closed) => {
                let letters = two.rotaries.map(|axis| letter(model, axis));
                let of_branch = |angles: [Formula; 2]| letters.clone().into_iter().zip(angles).collect();
                closed.roots_in_place().map(of_branch).into()
            }
        },
    }
}
