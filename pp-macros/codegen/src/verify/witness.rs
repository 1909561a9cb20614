//! Witnesses: poses at which equations hold together.
//!
//! A witness is a rational point of the circles `sin² + cos² = 1`. It is looked for among points that are the same in
//! every build, so that the regions of several equations can be compared: equations that describe one solution have one
//! in common.

use std::collections::BTreeMap;

use super::scope::Scope;
use crate::model::{AxisKind, Quantity, to_f64};
use crate::symbolic::{Poly, Ring, Symbol};

/// Number of points that are searched.
const POINTS: usize = 4_000;

/// Rounding error of a sum, as a share of the sum of the absolute values of its terms.
const ROUNDING: f64 = 1e-9;

type WitnessPoint = BTreeMap<Symbol, f64>;

/// Signs that an equation needs, as polynomials.
#[derive(Debug, Clone, Default)]
pub(crate) struct Claims {
    pub(crate) positive: Vec<Poly>,
    pub(crate) not_negative: Vec<Poly>,
}

/// How a symbol follows from a polynomial.
#[derive(Debug, Clone, Copy)]
enum Dependence {
    Reciprocal,
    Root,
}

/// The poses at which an equation holds.
#[derive(Debug, Clone)]
pub(crate) struct Region {
    ring: Ring,
    /// Roots with their radicands, and reciprocals with their divisors, in the order in which they depend on each
    /// other.
    dependent: Vec<(Symbol, Dependence, Poly)>,
    claims: Claims,
}

impl Region {
    /// Where all claims hold, and all divisors and roots of the equation exist.
    pub(crate) fn new(ring: Ring, divisors: Vec<(Poly, Symbol)>, roots: Vec<Symbol>, claims: Claims) -> Self {
        let reciprocals = divisors.into_iter().map(|(divisor, symbol)| (symbol, Dependence::Reciprocal, divisor));
        let roots = roots.into_iter().map(|root| (root, Dependence::Root, ring.square_of(root)));
        let mut dependent: Vec<(Symbol, Dependence, Poly)> = reciprocals.chain(roots).collect();
        // One may contain an earlier one.
        dependent.sort_by_key(|(symbol, ..)| *symbol);
        Self { ring, dependent, claims }
    }

    /// True if the equation holds at every pose at which its divisors and roots exist.
    pub(crate) fn is_everywhere(&self) -> bool {
        self.claims.positive.is_empty() && self.claims.not_negative.is_empty()
    }

    /// True if all claims hold at a point: by more than rounding where they are strict.
    fn contains(&self, point: &WitnessPoint) -> bool {
        let mut point = point.clone();
        self.add_dependent_values(&mut point)
            && self.claims.positive.iter().all(|poly| self.is_positive(poly, &point, true))
            && self.claims.not_negative.iter().all(|poly| self.is_positive(poly, &point, false))
    }

    /// Adds the values of reciprocals and roots; false where one does not exist.
    fn add_dependent_values(&self, point: &mut WitnessPoint) -> bool {
        for (symbol, dependence, of) in &self.dependent {
            let Some((value, rounding)) = self.value_at(of, point) else { return false };
            let value = match dependence {
                Dependence::Reciprocal if value.abs() <= rounding => return false,
                Dependence::Reciprocal => value.recip(),
                Dependence::Root if value.abs() <= rounding => 0.0,
                Dependence::Root => value.sqrt(),
            };
            if !value.is_finite() {
                return false;
            }
            point.insert(*symbol, value);
        }
        true
    }

    fn is_positive(&self, poly: &Poly, point: &WitnessPoint, strictly: bool) -> bool {
        let Some((value, rounding)) = self.value_at(poly, point) else { return false };
        if strictly { value > rounding } else { value >= -rounding }
    }

    /// Value of a polynomial, and a bound of its rounding error.
    fn value_at(&self, poly: &Poly, point: &WitnessPoint) -> Option<(f64, f64)> {
        let of = |symbol: Symbol| point.get(&symbol).copied();
        Some((self.ring.evaluate(poly, &of)?, ROUNDING * self.ring.magnitude(poly, &of)?))
    }
}

/// True if there is a point in all regions.
pub(crate) fn has_witness(scope: &Scope<'_>, regions: &[&Region]) -> bool {
    let fixed = defaults(scope);
    let model = scope.model();
    let dimensions = model.dimensions.iter().map(|dimension| match dimension.quantity {
        Quantity::Length(symbol) | Quantity::Angle(symbol, _) => symbol,
    });
    let axes = model.axes.iter().flat_map(|axis| [axis.word, axis.sin_cos.0, axis.sin_cos.1]);
    let known = axes.chain(model.symbols.part).chain([model.symbols.gauge]).chain(dimensions);
    let symbols: Vec<Symbol> = known.chain(scope.free_symbols()).collect();
    let sines: BTreeMap<Symbol, Symbol> = scope.circles().into_iter().collect();
    let mut state = 0x9e37_79b9_u64;
    let mut next = |range: u64| {
        // An arbitrary sequence that visits all quadrants, the same in every build.
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) % range
    };
    (0..POINTS).any(|_| {
        let mut point = fixed.clone();
        for (place, symbol) in symbols.iter().enumerate() {
            if point.contains_key(symbol) {
                continue;
            }
            // Each symbol has a grid of its own, so that no two symbols are equal by chance.
            let offset = place as f64 / 64.0 + 1.0 / 128.0;
            match sines.get(symbol) {
                Some(cosine) => {
                    // t = n/4 gives ((2t)/(1+t²), (1-t²)/(1+t²)), in all four quadrants.
                    let t = (next(32) as f64 - 16.0 + offset) / 4.0;
                    point.insert(*symbol, 2.0 * t / (1.0 + t * t));
                    point.insert(*cosine, (1.0 - t * t) / (1.0 + t * t));
                }
                None => drop(point.insert(*symbol, next(400) as f64 - 200.0 + offset)),
            }
        }
        regions.iter().all(|region| region.contains(&point))
    })
}

/// Default values of dimensions and of held linear axes.
fn defaults(scope: &Scope<'_>) -> WitnessPoint {
    let mut values = WitnessPoint::new();
    for dimension in &scope.model().dimensions {
        let Some(default) = dimension.known().map(to_f64) else { continue };
        match dimension.quantity {
            Quantity::Length(symbol) => drop(values.insert(symbol, default)),
            Quantity::Angle(sine, cosine) => {
                let (s, c) = default.to_radians().sin_cos();
                values.insert(sine, s);
                values.insert(cosine, c);
            }
        }
    }
    for axis in scope.model().axes.iter().filter(|axis| axis.kind == AxisKind::Linear) {
        if let Some(held) = &axis.held {
            values.insert(axis.word, to_f64(held));
        }
    }
    values
}
