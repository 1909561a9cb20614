//! Quantities from which both angles are computed; names as in the table of [`two`](super::two).

use std::collections::BTreeMap;

use crate::model::AxisId;
use crate::solve::refusal::{PARALLEL_SINE_SQUARED, Refusal};
use crate::symbolic::{GraphBuilder, Poly, Symbol, Term, TermVector};

/// Directions in which the tool axis can be parallel to the first rotary axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Pole {
    /// At `n` and `-n`: the rotaries are perpendicular to each other and to the tool.
    Orthogonal,
    /// At `n`.
    Plus,
    /// At `-n`.
    Minus,
    /// Nowhere, or only at particular values of held axes and dimensions.
    Elsewhere,
}

impl Pole {
    pub(crate) fn of(p: Term<'_>, q: Term<'_>) -> Self {
        p.read(|reader, p| {
            let (p, q) = (reader.value(p), reader.value(q.id()));
            if reader.equal(&p, &q) {
                if p.is_zero() { Self::Orthogonal } else { Self::Plus }
            } else if reader.equal(&p, &-&q) {
                Self::Minus
            } else {
                Self::Elsewhere
            }
        })
    }
}

/// Directions at the held values: both rotaries, the tool axis, the wanted axis.
#[derive(Clone, Copy)]
pub(crate) struct Directions<'g> {
    pub(crate) n: TermVector<'g>,
    pub(crate) m: TermVector<'g>,
    pub(crate) t: TermVector<'g>,
    pub(crate) a: TermVector<'g>,
}

/// Quantities that do not depend on the wanted axis.
pub(crate) struct Invariants<'g> {
    pub(crate) p: Term<'g>,
    pub(crate) q: Term<'g>,
    pub(crate) alpha: [Term<'g>; 2],
    pub(crate) capacity: Term<'g>,
    pub(crate) between_squared: Term<'g>,
    /// `|m×t|² = 1 - q²`.
    pub(crate) tool_squared: Term<'g>,
    /// `m×n`
    m_n: TermVector<'g>,
}

impl<'g> Invariants<'g> {
    pub(crate) fn of(
        Directions { n, m, t, .. }: Directions<'g>,
        rotaries: [AxisId; 2],
        defaults: &BTreeMap<Symbol, Poly>,
    ) -> Result<Self, Vec<Refusal>> {
        let (m_n, m_t) = (m.cross(n), m.cross(t));
        let (between_squared, tool_squared) = (m_n.dot(m_n), m_t.dot(m_t));
        let between_squared = between_squared.settled();
        let (between, tool) = (m_n.squared_at(defaults), m_t.squared_at(defaults));
        if between * tool <= PARALLEL_SINE_SQUARED {
            let [first, second] = rotaries;
            let same =
                (between <= PARALLEL_SINE_SQUARED || between <= tool).then_some(Refusal::SameDirection(first, second));
            let still = (tool <= PARALLEL_SINE_SQUARED || tool < between).then_some(Refusal::CannotTilt(second));
            return Err(same.into_iter().chain(still).collect());
        }
        let [p, q] = [n.dot(m), m.dot(t)].map(Term::settled);
        let alpha = [m_n.dot(m_t), n.dot(m_t)].map(Term::settled);
        let capacity = (alpha[0].square() + alpha[1].square()).settled().named("capacity");
        Ok(Self { p, q, alpha, capacity, between_squared, tool_squared, m_n })
    }

    /// `A` of a tool at a height.
    pub(crate) fn lean(&self, height: Term<'g>) -> Term<'g> {
        self.q * self.between_squared - self.p * height
    }
}

/// Coordinates of the wanted axis: its height along the first rotary, and two in the plane perpendicular to it.
pub(crate) struct Coordinates<'g> {
    pub(crate) along: Term<'g>,
    pub(crate) mean: Term<'g>,
    pub(crate) height: Term<'g>,
    pub(crate) g: Term<'g>,
    pub(crate) e: Term<'g>,
    pub(crate) spread: Term<'g>,
    pub(crate) sine_squared: Term<'g>,
}

impl<'g> Coordinates<'g> {
    pub(crate) fn of(Directions { n, a, .. }: Directions<'g>, machine: &Invariants<'g>) -> Self {
        let along = n.dot(a);
        let g = machine.m_n.dot(a);
        // n×(m×n) = m - p n
        let e = n.cross(machine.m_n).dot(a);
        let spread = (g * g + e * e).named("spread");
        let sine_squared = (spread / machine.between_squared).named("sine_squared");
        let mean = machine.p * machine.q;
        let height = (along - mean).named("height");
        Self { along, mean, height, g, e, spread, sine_squared }
    }

    /// `(|n×a|² + (1-k)²)/2`, which is `1-k` without the loss of digits; `k` is `n·a` or `-n·a`.
    fn one_minus(&self, k: Term<'g>) -> Term<'g> {
        (self.sine_squared + (1 - k).square()) / 2
    }
}

/// The root squared in its well-conditioned form, with rim and lean in the same form.
pub(crate) struct Radicand<'g> {
    pub(crate) rim: Term<'g>,
    pub(crate) squared: Term<'g>,
    pub(crate) lean: Term<'g>,
}

impl<'g> Radicand<'g> {
    pub(crate) fn of(graph: &'g GraphBuilder, pole: Pole, machine: &Invariants<'g>, wanted: &Coordinates<'g>) -> Self {
        match pole {
            Pole::Orthogonal => Self { rim: machine.between_squared, squared: wanted.spread, lean: graph.integer(0) },
            Pole::Plus => Self::with_pole(true, machine, wanted),
            Pole::Minus => Self::with_pole(false, machine, wanted),
            Pole::Elsewhere => Self::without_pole(machine, wanted),
        }
    }

    /// `q = ε p`, with `ε` plus or minus.
    fn with_pole(plus: bool, machine: &Invariants<'g>, wanted: &Coordinates<'g>) -> Self {
        let p = machine.p;
        let along = wanted.along.signed(plus);
        let near = wanted.one_minus(along).named("near");
        let p_squared = p.square();
        let far = (1 - (p_squared + p_squared) + along).named("far");
        Self { rim: machine.between_squared, squared: near * far, lean: (p * near).signed(plus) }
    }

    fn without_pole(machine: &Invariants<'g>, wanted: &Coordinates<'g>) -> Self {
        let Invariants { p, q, .. } = *machine;
        let (along, mean) = (wanted.along, wanted.mean);
        let rim = machine.capacity.sqrt().named("rim");
        let minus_along = -along;
        let sides = [(along, p - q, 1 - mean), (minus_along, p + q, 1 + mean)];
        let [near, far] = sides.map(|(k, gap, one_minus_mean)| {
            let clear = wanted.one_minus(k);
            let gap_squared = gap.square();
            clear - gap_squared / (one_minus_mean + rim)
        });
        let (near, far) = (near.named("near"), far.named("far"));
        Self { rim, squared: near * far, lean: machine.lean(wanted.height) }
    }
}

/// Common factor of sine and cosine of the first angle.
pub(crate) struct FirstScale<'g> {
    pub(crate) length: Option<Term<'g>>,
    pub(crate) inverse: Term<'g>,
}

impl<'g> FirstScale<'g> {
    pub(crate) fn of(pole: Pole, root: Term<'g>, lean: Term<'g>, spread: Term<'g>) -> Self {
        let (length, divisor) = match pole {
            Pole::Orthogonal => (None, root),
            Pole::Plus | Pole::Minus => (None, spread),
            Pole::Elsewhere => {
                let length = ((lean.square() + root.square()) * spread).sqrt().named("length");
                (Some(length), length)
            }
        };
        Self { length, inverse: (1 / divisor).named("inverse") }
    }
}
