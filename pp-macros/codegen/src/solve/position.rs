//! Linear axes from the tip and the sines and cosines of all rotary axes.
//!
//! The chain is cut at one place: joints before the cut are undone on the wanted tip, joints behind it are applied to
//! the tool point, and what is left between the two is `Σ q_i w_i` with the directions `w_i` of the linear axes as seen
//! at the cut. Axes in the group that is cut have constant directions. Every cut gives the same answer; the one with
//! the fewest operations is kept.

use super::{Chain, Point};
use crate::model::{AxisId, Kind, Model};
use crate::symbolic::{Id, Operations, V3};

/// Nodes of the linear axes.
#[derive(Debug, Clone)]
pub struct Position {
    /// Solved linear axes in chain order, with their values.
    pub values: Vec<(AxisId, Id)>,
    /// Determinant of their unit directions.
    pub determinant: Id,
    /// Place in the chain where it was cut.
    pub cut: usize,
}

pub(super) fn solve(chain: &mut Chain<'_>) -> Position {
    (0..=chain.model.axes.len())
        .map(|cut| {
            let position = solve_at(chain, cut);
            let outputs: Vec<Id> = position.values.iter().map(|(_, node)| *node).collect();
            let cost = Operations::of(&chain.graph, &outputs).total();
            (cost, cut, position)
        })
        .min_by_key(|(cost, cut, _)| (*cost, *cut))
        .map(|(_, _, position)| position)
        .expect("a chain has at least one place to cut")
}

fn solve_at(chain: &mut Chain<'_>, cut: usize) -> Position {
    let model: &Model = chain.model;
    let tip = model.frame.tip.map(|symbol| chain.graph.input(symbol));
    let mut wanted = Point { from: None, offset: tip };
    let mut columns: Vec<(AxisId, V3)> = Vec::new();
    for id in 0..cut {
        let axis = &model.axes[id];
        match axis.kind {
            Kind::Linear if axis.held.is_some() => {
                let by = chain.displacement(id);
                wanted.offset = chain.graph.sub_vectors(wanted.offset, by);
            }
            Kind::Linear => columns.push((id, chain.step(id))),
            Kind::Rotary => {
                wanted = chain.seen_from(wanted, Some(id));
                chain.name("tip_from", id, wanted.offset);
                wanted.offset = chain.turn_back(id, wanted.offset);
                chain.name("tip_on", id, wanted.offset);
                for (_, column) in &mut columns {
                    *column = chain.turn_back(id, *column);
                }
            }
        }
    }
    let before = columns.len();
    let mut tool = chain.origin();
    for id in (cut..model.axes.len()).rev() {
        let axis = &model.axes[id];
        match axis.kind {
            Kind::Linear if axis.held.is_some() => {
                let by = chain.displacement(id);
                tool.offset = chain.graph.add_vectors(tool.offset, by);
            }
            Kind::Linear => columns.insert(before, (id, chain.step(id))),
            Kind::Rotary => {
                tool = chain.seen_from(tool, Some(id));
                tool.offset = chain.turn(id, tool.offset);
                chain.name("tool_on", id, tool.offset);
                for (_, column) in &mut columns[before..] {
                    *column = chain.turn(id, *column);
                }
            }
        }
    }
    let tool = chain.seen_from(tool, wanted.from);
    let gap = chain.graph.sub_vectors(wanted.offset, tool.offset);
    let [a, b, c] = columns[..] else { unreachable!("the check lets exactly three solved linear axes pass") };
    let (values, determinant) = solve_three(chain, [a.1, b.1, c.1], gap);
    Position { values: [a.0, b.0, c.0].into_iter().zip(values).collect(), determinant, cut }
}

/// `q` with `Σ q_i w_i = gap`, and the determinant of the `w_i`.
fn solve_three(chain: &mut Chain<'_>, w: [V3; 3], gap: V3) -> (V3, Id) {
    let graph = &mut chain.graph;
    let varies: Vec<usize> =
        (0..3).filter(|index| w[*index].iter().any(|id| graph.constant_of(*id).is_none())).collect();
    let zero = graph.integer(0);
    if varies.len() > 1 {
        // Cramer: q_a = gap · (w_b × w_c) / det, and cyclic.
        let faces: [V3; 3] = std::array::from_fn(|index| graph.cross(w[(index + 1) % 3], w[(index + 2) % 3]));
        let determinant = graph.dot(w[0], faces[0]);
        graph.name(determinant, "determinant");
        let one = graph.integer(1);
        if graph.is_zero(determinant) {
            return ([zero; 3], determinant);
        }
        let inverse = graph.div(one, determinant);
        let values = faces.map(|face| {
            let volume = graph.dot(gap, face);
            graph.mul(volume, inverse)
        });
        return (values, determinant);
    }
    // Two fixed directions a, b: first along c, seen square to both, then within their plane by the dual vectors.
    let c = varies.first().copied().unwrap_or(2);
    let (a, b) = ((c + 1) % 3, (c + 2) % 3);
    let normal = graph.cross(w[a], w[b]);
    let determinant = graph.dot(normal, w[c]);
    let area = graph.dot(normal, normal);
    if graph.is_zero(determinant) || graph.is_zero(area) {
        return ([zero; 3], zero);
    }
    graph.name(determinant, "determinant");
    let height = graph.dot(normal, gap);
    let along_c = graph.div(height, determinant);
    let by = graph.scale_vector(along_c, w[c]);
    let rest = graph.sub_vectors(gap, by);
    let across_b = graph.cross(w[b], normal);
    let across_a = graph.cross(normal, w[a]);
    let mut values = [along_c; 3];
    for (index, across) in [(a, across_b), (b, across_a)] {
        let dual = across.map(|component| graph.div(component, area));
        values[index] = graph.dot(dual, rest);
    }
    (values, determinant)
}
