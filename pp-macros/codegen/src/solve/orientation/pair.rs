//! The formulas of two solved rotary axes, as nodes.

use super::geometry::Pole;
use super::relation::AngleRelation;
use super::tilt::Tilt;
use crate::model::{AxisId, Model};
use crate::symbolic::{Id, Interpreter, Poly, SineCosine, Symbol};

/// Two solved rotary axes.
#[derive(Debug, Clone)]
pub struct TwoRotaries {
    /// First and second from the workpiece.
    pub rotaries: [AxisId; 2],
    /// Parts of the second angle that both branches share.
    pub second: SecondAngle,
    /// Parts of the first angle that both branches share.
    pub first: FirstAngle,
    /// The branches in their order.
    pub branches: [Branch; 2],
    /// Formulas of the cold path: at the pole, at the rim, just beyond the rim.
    pub edge: Edge,
    /// Directions in which the tool axis can be parallel to the first rotary axis.
    pub pole: Pole,
    /// Angles to the first rotary axis, for diagnostics.
    pub tilt: Tilt,
}

impl TwoRotaries {
    /// True if `σ` is plus on the first branch.
    #[must_use]
    pub fn first_is_plus(&self) -> bool {
        self.branches[0].plus
    }

    /// `α1 sin - α2 cos` of the second joint: it has the sign `σ`, and is the root on the branch with plus.
    #[must_use]
    pub fn side(&self, model: &Model, reader: &mut Interpreter<'_>) -> Poly {
        let second = self.rotaries[1];
        let [sine_factor, cosine_factor] = self.second.alpha.map(|node| reader.value(node));
        let (ring, cosine) = (reader.ring(), Poly::from(model.axes[second].sin_cos.1));
        &ring.mul(&sine_factor, &model.joint_sine(second)) - &ring.mul(&cosine_factor, &cosine)
    }
}

/// The second angle solves `α1 cos + α2 sin = height`.
#[derive(Debug, Clone, Copy)]
pub struct SecondAngle {
    /// `α1`, `α2`.
    pub alpha: [Id; 2],
    /// `D = α1² + α2²`, the divisor of sine and cosine.
    pub capacity: Id,
    /// `√D`.
    pub rim: Id,
    /// `w`.
    pub height: Id,
    /// `r`, the same on both branches.
    pub root: Id,
    /// `r² = D - w²`, as it is computed.
    pub root_squared: Id,
}

/// The first angle takes the rotated tool to the wanted axis, in the plane perpendicular to the first rotary.
#[derive(Debug, Clone, Copy)]
pub struct FirstAngle {
    /// `1-p²`.
    pub between_squared: Id,
    /// `g² + e² = (1-p²)|n×a|²`.
    pub spread: Id,
    /// `|n×a|²`.
    pub sine_squared: Id,
    /// The root by which the angle is normalised, where it has one of its own; its exact value is `spread`.
    pub length: Option<Id>,
    /// A positive factor that sine and cosine have in common.
    pub inverse: Id,
}

/// One branch.
#[derive(Debug, Clone, Copy)]
pub struct Branch {
    /// `σ` is plus.
    pub plus: bool,
    /// Sine and cosine of the words, first and second rotary.
    pub words: [SineCosine; 2],
    /// Relations of the angles to those of the first branch.
    pub angles: [AngleRelation; 2],
}

/// Formulas of the first branch with `w` and `r` as inputs.
#[derive(Debug, Clone, Copy)]
pub struct Edge {
    /// `w`.
    pub height: Symbol,
    /// `r`.
    pub root: Symbol,
    /// Sine and cosine of the second word.
    pub second: SineCosine,
    /// Sine and cosine of the first word times a common factor.
    pub first: SineCosine,
    /// Square of that factor.
    pub first_squared: Id,
    /// `|n×b|²` of the reached axis.
    pub reached_squared: Id,
    /// `n·a` of the wanted and `n·b` of the reached axis.
    pub along: (Id, Id),
}
