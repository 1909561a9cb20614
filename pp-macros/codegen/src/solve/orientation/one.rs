//! The angle of a single rotary axis from a tool axis.
//!
//! With `n` the direction of the rotary, `t` the tool axis and `a` the wanted axis, the rotated tool describes a cone
//! about `n`. The angle is that from `t` to `a`, seen along `n`: sine `(n×t)·a`, cosine `((n×t)×n)·a`, both times the
//! length of `n×t`. The distance of `a` from the cone is the deviation.

use std::collections::BTreeMap;

use super::tilt::{Tilt, in_workpiece};
use crate::model::AxisId;
use crate::solve::derivation::Derivation;
use crate::solve::refusal::{PARALLEL_SINE_SQUARED, Refusal};
use crate::symbolic::{Id, Poly, SineCosine, Symbol, TermVector};

/// One solved rotary axis.
#[derive(Debug, Clone)]
pub struct OneRotary {
    /// The axis.
    pub rotary: AxisId,
    /// Sine and cosine of its word.
    pub word: SineCosine,
    /// Distance from the wanted axis to the reachable cone.
    pub deviation: Id,
    /// The root whose exact value on the cone is `length_claim`.
    pub length: Id,
    /// Common factor of sine and cosine of the word, `1 / length`.
    pub inverse: Id,
    /// `|n×t|²`, the exact value of `length` on the cone.
    pub length_claim: Id,
    /// Angles to the rotary axis, for diagnostics.
    pub tilt: Tilt,
}

pub(crate) fn solve<'g>(
    derivation: &'g Derivation<'_>,
    rotary: AxisId,
    axis: TermVector<'g>,
    tool: TermVector<'g>,
    defaults: &BTreeMap<Symbol, Poly>,
) -> Result<OneRotary, Vec<Refusal>> {
    let graph = &derivation.graph;
    let n = derivation.direction(rotary);
    let across = n.cross(tool);
    if across.squared_at(defaults) <= PARALLEL_SINE_SQUARED {
        return Err(vec![Refusal::CannotTilt(rotary)]);
    }
    let across_squared = across.dot(across).settled();
    let level = n.dot(tool);
    let outwards = across.cross(n);
    let sine = across.dot(axis).named("sine");
    let cosine = outwards.dot(axis).named("cosine");
    let length = (sine.square() + cosine.square()).sqrt().named("length");
    let inverse = 1 / length;
    let (word_sine, word_cosine) = (sine * inverse, cosine * inverse);
    // Distance in the plane of the rotary and the wanted axis: along the rotary, and perpendicular to it.
    let along = n.dot(axis);
    let radius = across_squared.sqrt();
    let wanted_radius = length / radius;
    let (gap_along, gap_across) = (along - level, wanted_radius - radius);
    let deviation = (gap_along.square() + gap_across.square()).sqrt().named("deviation");
    let wanted_sine = n.cross(axis).norm();
    let word_sine = word_sine.signed(!derivation.model.axes[rotary].reversed);
    Ok(OneRotary {
        rotary,
        word: SineCosine::of(word_sine, word_cosine),
        deviation: deviation.id(),
        length: length.id(),
        inverse: inverse.id(),
        length_claim: across_squared.id(),
        tilt: Tilt {
            wanted: SineCosine::of(wanted_sine, along),
            between: SineCosine::of(graph.integer(0), graph.integer(1)),
            tool: SineCosine::of(radius, level),
            direction: in_workpiece(derivation, rotary).ids(),
        },
    })
}
