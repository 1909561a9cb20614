//! Values of symbols that the declaration gives.

use std::collections::BTreeMap;

use crate::model::{Axis, AxisKind, Dimension, Quantity};
use crate::symbolic::{Poly, Ring, Surd, Symbol, sin_cos_of_degrees};

/// Default values of `hold` and `dims`, for their symbols, and approximate values of required angles; what else is
/// required keeps its symbols.
pub(crate) fn defaults(axes: &[Axis], dimensions: &[Dimension], ring: &mut Ring) -> BTreeMap<Symbol, Poly> {
    let mut values = BTreeMap::new();
    let mut angles = Vec::new();
    for axis in axes {
        if let Some(value) = &axis.held {
            match axis.kind {
                AxisKind::Linear => drop(values.insert(axis.word, Poly::from(Surd::from(value.clone())))),
                AxisKind::Rotary => angles.push((axis.sin_cos, value)),
            }
        }
    }
    for dimension in dimensions {
        let Some(default) = dimension.known() else { continue };
        match dimension.quantity {
            Quantity::Length(symbol) => {
                values.insert(symbol, Poly::from(Surd::from(default.clone())));
            }
            Quantity::Angle(sine, cosine) => angles.push(((sine, cosine), default)),
        }
    }
    for ((sine, cosine), degrees) in angles {
        let (s, c) = sin_cos_of_degrees(degrees, ring);
        values.insert(sine, s);
        values.insert(cosine, c);
    }
    values
}
