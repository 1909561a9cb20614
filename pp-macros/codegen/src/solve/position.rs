//! Linear axes from the tip and the sines and cosines of all rotary axes.
//!
//! The chain is cut at one place: the inverses of the joints before the cut are applied to the wanted tip, the joints
//! after it to the tool point. The difference between the two is `Σ q_i w_i` with the directions `w_i` of the linear
//! axes in the frame at the cut. Axes with no rotary axis between them and the cut have constant directions. Every cut
//! gives the same values; the one with the fewest operations is kept.

use super::derivation::{Derivation, Point};
use crate::model::{AxisId, AxisKind};
use crate::symbolic::{Id, Operations, Term, TermVector};

/// Nodes of the linear axes.
#[derive(Debug, Clone)]
pub struct Position {
    /// Solved linear axes in chain order, with their values.
    pub values: Vec<(AxisId, Id)>,
    /// Determinant of their unit directions.
    pub determinant: Id,
    /// Index of the first axis after the cut.
    pub cut: usize,
}

pub(crate) fn solve(derivation: &Derivation<'_>) -> Position {
    let cost = |position: &Position| {
        let outputs: Vec<Id> = position.values.iter().map(|(_, node)| *node).collect();
        derivation.graph.with(|graph| Operations::of(graph, &outputs).total())
    };
    let first = solve_at(derivation, 0);
    let others = (1..=derivation.model.axes.len()).map(|cut| solve_at(derivation, cut));
    // The earlier cut where two cost the same.
    others.fold(first, |best, other| if cost(&other) < cost(&best) { other } else { best })
}

/// A solved linear axis, and its direction in the frame at the cut.
type Column<'g> = (AxisId, TermVector<'g>);

#[expect(clippy::unreachable, reason = "the front end refuses a chain without exactly three solved linear axes")]
fn solve_at(derivation: &Derivation<'_>, cut: usize) -> Position {
    let (wanted, before) = wanted_at(derivation, cut);
    let (tool, after) = tool_at(derivation, cut);
    let tool = derivation.seen_from(tool, wanted.from);
    let gap = wanted.offset - tool.offset;
    let columns = [before, after].concat();
    let [a, b, c] = columns[..] else { unreachable!("the check lets exactly three solved linear axes pass") };
    let (values, determinant) = solve_three([a.1, b.1, c.1], gap);
    let values = [a.0, b.0, c.0].into_iter().zip(values.map(Term::id)).collect();
    Position { values, determinant: determinant.id(), cut }
}

/// The wanted tip after the inverses of the joints before the cut, and the linear axes among these joints.
fn wanted_at<'g>(derivation: &'g Derivation<'_>, cut: usize) -> (Point<'g>, Vec<Column<'g>>) {
    let model = derivation.model;
    let mut wanted = Point { from: None, offset: derivation.graph.inputs(model.symbols.tip) };
    let mut columns: Vec<Column<'g>> = Vec::new();
    for (id, axis) in model.axes.iter().enumerate().take(cut) {
        match axis.kind {
            AxisKind::Linear if axis.held.is_some() => wanted.offset = wanted.offset - derivation.displacement(id),
            AxisKind::Linear => columns.push((id, derivation.step(id))),
            AxisKind::Rotary => {
                wanted = derivation.seen_from(wanted, Some(id));
                derivation.name("tip_from", id, wanted.offset);
                wanted.offset = derivation.rotated_back(id, wanted.offset);
                derivation.name("tip_on", id, wanted.offset);
                for (_, column) in &mut columns {
                    *column = derivation.rotated_back(id, *column);
                }
            }
        }
    }
    (wanted, columns)
}

/// The tool point after the joints from the cut on, and the linear axes among these joints.
fn tool_at<'g>(derivation: &'g Derivation<'_>, cut: usize) -> (Point<'g>, Vec<Column<'g>>) {
    let mut tool = derivation.origin();
    let mut columns: Vec<Column<'g>> = Vec::new();
    for (id, axis) in derivation.model.axes.iter().enumerate().skip(cut).rev() {
        match axis.kind {
            AxisKind::Linear if axis.held.is_some() => tool.offset = tool.offset + derivation.displacement(id),
            AxisKind::Linear => columns.insert(0, (id, derivation.step(id))),
            AxisKind::Rotary => {
                tool = derivation.seen_from(tool, Some(id));
                tool.offset = derivation.rotated(id, tool.offset);
                derivation.name("tool_on", id, tool.offset);
                for (_, column) in &mut columns {
                    *column = derivation.rotated(id, *column);
                }
            }
        }
    }
    (tool, columns)
}

/// `q` with `Σ q_i w_i = gap`, and the determinant of the `w_i`.
fn solve_three<'g>(w: [TermVector<'g>; 3], gap: TermVector<'g>) -> ([Term<'g>; 3], Term<'g>) {
    let is_fixed = |w: TermVector<'_>| w.components().into_iter().all(Term::is_constant);
    let varying: Vec<usize> = (0..3).filter(|index| !is_fixed(w[*index])).collect();
    if varying.len() > 1 {
        return by_volumes(w, gap);
    }
    by_planes(w, varying.first().copied().unwrap_or(2), gap)
}

/// Cramer's rule: `q_a = gap · (w_b × w_c) / det`, and cyclic.
fn by_volumes<'g>(w: [TermVector<'g>; 3], gap: TermVector<'g>) -> ([Term<'g>; 3], Term<'g>) {
    let faces: [TermVector<'g>; 3] = std::array::from_fn(|index| w[(index + 1) % 3].cross(w[(index + 2) % 3]));
    let determinant = w[0].dot(faces[0]).named("determinant");
    if determinant.is_zero() {
        return ([determinant; 3], determinant);
    }
    let inverse = 1 / determinant;
    (faces.map(|face| gap.dot(face) * inverse), determinant)
}

/// Solution where all directions but `w_c` are fixed: first `q_c`, along the normal of the other two, then these two in
/// their plane by dual vectors.
fn by_planes<'g>(w: [TermVector<'g>; 3], c: usize, gap: TermVector<'g>) -> ([Term<'g>; 3], Term<'g>) {
    let (a, b) = ((c + 1) % 3, (c + 2) % 3);
    let normal = w[a].cross(w[b]);
    let determinant = normal.dot(w[c]);
    let area = normal.dot(normal);
    if determinant.is_zero() || area.is_zero() {
        return ([determinant; 3], determinant);
    }
    let determinant = determinant.named("determinant");
    let along_c = normal.dot(gap) / determinant;
    let rest = gap - along_c * w[c];
    let (across_b, across_a) = (w[b].cross(normal), normal.cross(w[a]));
    let mut values = [along_c; 3];
    for (index, across) in [(a, across_b), (b, across_a)] {
        values[index] = (across / area).dot(rest);
    }
    (values, determinant)
}
