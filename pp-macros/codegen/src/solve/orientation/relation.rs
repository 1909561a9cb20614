//! Angles of the second solution (branch) that are computed from those of the first, such as `-B` or `C + 180°`,
//! without another `atan2`.

use std::collections::BTreeMap;

use crate::solve::derivation::Derivation;
use crate::symbolic::{Id, Interpreter, SineCosine, Symbol};

/// Relation of an angle to that of the first branch.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AngleRelation {
    /// None: computed from its own sine and cosine.
    Own,
    /// Equal to that of the first branch.
    Same,
    /// Opposite sine, same cosine as in the first branch.
    Negated,
    /// Half a revolution from the first branch.
    HalfTurn,
    /// Same sine, opposite cosine.
    Mirrored,
}

/// Relation of the second angle to the first.
pub(crate) fn relation(derivation: &Derivation<'_>, first: SineCosine, second: SineCosine) -> AngleRelation {
    let sample = derivation.model.sample();
    match (same(derivation, &sample, first.sine, second.sine), same(derivation, &sample, first.cosine, second.cosine)) {
        (Some(true), Some(true)) => AngleRelation::Same,
        (Some(false), Some(true)) => AngleRelation::Negated,
        (Some(false), Some(false)) => AngleRelation::HalfTurn,
        (Some(true), Some(false)) => AngleRelation::Mirrored,
        (None, _) | (_, None) => AngleRelation::Own,
    }
}

/// True if the nodes are proven to be equal, false if proven to be opposite, `None` otherwise.
///
/// One numeric point refutes most relations at once; what it does not refute must be proven exactly.
fn same(derivation: &Derivation<'_>, sample: &BTreeMap<Symbol, f64>, first: Id, second: Id) -> Option<bool> {
    derivation.graph.with(|graph| {
        let of = |symbol: Symbol| sample.get(&symbol).copied();
        let [a, b] = [first, second].map(|node| graph.evaluate(node, &of));
        let differs = |a: f64, b: f64| (a - b).abs() > 1e-6;
        let mut reader = Interpreter::new(graph, BTreeMap::new());
        if !differs(a, b) {
            let (a, b) = (reader.value(first), reader.value(second));
            if reader.equal(&a, &b) {
                return Some(true);
            }
        }
        if !differs(a, -b) {
            let (a, b) = (reader.value(first), reader.value(second));
            if reader.equal(&a, &-&b) {
                return Some(false);
            }
        }
        None
    })
}
