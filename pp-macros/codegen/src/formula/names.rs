//! Names of symbols in formulas: those of the declaration.

use std::collections::BTreeMap;

use num_rational::BigRational;

use super::expression::Formula;
use crate::model::{Model, Quantity};
use crate::symbolic::{Poly, Ring, Symbol};

/// Names of symbols, and the order in which they are written.
pub(crate) struct SymbolNames<'a> {
    model: &'a Model,
    ring: &'a Ring,
    known: BTreeMap<Symbol, (usize, Formula)>,
}

/// First sort key of linear words, after those of the pose.
const WORDS: usize = 20;

/// First sort key of sines and cosines.
const SIN_COS: usize = 1000;

impl<'a> SymbolNames<'a> {
    pub(crate) fn new(model: &'a Model, ring: &'a Ring) -> Self {
        let mut known = BTreeMap::new();
        let mut enter = |symbol: Symbol, place: usize, formula: Formula| {
            known.insert(symbol, (place, formula));
        };
        let symbols = &model.symbols;
        let vectors = [(symbols.tip, ["x", "y", "z"]), (symbols.axis, ["i", "j", "k"])];
        let vectors = vectors.into_iter().chain([(symbols.part, ["part_x", "part_y", "part_z"])]);
        for (index, (symbols, names)) in vectors.enumerate() {
            for (component, (symbol, name)) in symbols.into_iter().zip(names).enumerate() {
                enter(symbol, [0, 10, 60][index] + component, Formula::name(name));
            }
        }
        enter(symbols.gauge, 70, Formula::name("gauge"));
        let function_of = |function: &str, name: &str| Formula::call(function, [Formula::name(name)]);
        // The axis next to the tool comes first, and its sine before its cosine.
        let place = |order: usize, of: usize| SIN_COS + 2 * (of - order);
        let count = model.axes.len();
        for (index, axis) in model.axes.iter().enumerate() {
            let letter = axis.letter.to_string();
            enter(axis.word, WORDS + index, Formula::name(&letter));
            enter(axis.sin_cos.0, place(index, count), function_of("sin", &letter));
            enter(axis.sin_cos.1, place(index, count) + 1, function_of("cos", &letter));
        }
        for (index, dimension) in model.dimensions.iter().enumerate() {
            match dimension.quantity {
                Quantity::Length(symbol) => enter(symbol, 100 + index, Formula::name(&dimension.name)),
                Quantity::Angle(sine, cosine) => {
                    let first = SIN_COS + 1000 + 2 * index;
                    enter(sine, first, function_of("sin", &dimension.name));
                    enter(cosine, first + 1, function_of("cos", &dimension.name));
                }
            }
        }
        Self { model, ring, known }
    }

    /// The symbol as it is written.
    pub(crate) fn formula(&self, symbol: Symbol) -> Formula {
        if let Some((_, formula)) = self.known.get(&symbol) {
            return formula.clone();
        }
        let name = self.ring.name(symbol);
        if let Some((function, degrees)) = fixed_angle(name) {
            return Formula::call(function, [Formula::Degrees(degrees)]);
        }
        let constant = self.ring.value(&Poly::from(symbol)).is_some();
        if let (true, Some(radicand)) = (constant, self.ring.square(symbol)) {
            return Formula::call("sqrt", [Formula::of_poly(self.model, self.ring, radicand)]);
        }
        if let Some(divisor) = self.ring.divisor(symbol) {
            let below = Formula::of_poly(self.model, self.ring, divisor);
            return Formula::Quotient(Box::new(Formula::integer(1)), Box::new(below));
        }
        if self.ring.is_root(symbol) { Formula::Root(name.into()) } else { Formula::name(name) }
    }

    /// Sort key of a symbol.
    pub(crate) fn place(&self, symbol: Symbol) -> usize {
        let fixed = || if fixed_angle(self.ring.name(symbol)).is_some() { SIN_COS + 3000 } else { 80 };
        self.known.get(&symbol).map_or_else(fixed, |(place, _)| *place)
    }

    /// True for sines and cosines.
    pub(crate) fn is_sin_or_cos(&self, symbol: Symbol) -> bool {
        self.place(symbol) >= SIN_COS
    }

    /// True for symbols that may be factored out of a part of a sum; lengths may not.
    pub(crate) fn is_factor(&self, symbol: Symbol) -> bool {
        let symbols = &self.model.symbols;
        let length = match self.known.get(&symbol) {
            Some(_) => !symbols.axis.contains(&symbol),
            None => false,
        };
        self.is_sin_or_cos(symbol) || !length
    }

    /// Groups of symbols whose squares sum up to 1: sine and cosine, and `i j k`.
    pub(crate) fn circles(&self) -> Vec<Vec<Symbol>> {
        let axes = self.model.axes.iter().map(|axis| axis.sin_cos);
        let angles = self.model.dimensions.iter().filter_map(|dimension| match dimension.quantity {
            Quantity::Angle(sine, cosine) => Some((sine, cosine)),
            Quantity::Length(_) => None,
        });
        let mut circles: Vec<Vec<Symbol>> = axes.chain(angles).map(|(sine, cosine)| vec![sine, cosine]).collect();
        circles.push(self.model.symbols.axis.to_vec());
        let fixed = self.ring.symbols().filter(|symbol| fixed_angle(self.ring.name(*symbol)).is_some());
        circles.extend(fixed.filter_map(|symbol| {
            let square = self.ring.square(symbol)?;
            let mut circle: Vec<Symbol> = square.terms().flat_map(|(powers, _)| powers).map(|(s, _)| *s).collect();
            circle.push(symbol);
            Some(circle)
        }));
        circles
    }
}

/// `sin 33°` as function and angle.
fn fixed_angle(name: &str) -> Option<(&str, BigRational)> {
    let (function, angle) = name.strip_suffix('°')?.split_once(' ')?;
    let degrees = decimal(angle)?;
    ["sin", "cos"].contains(&function).then_some((function, degrees))
}

/// A decimal number, exactly.
fn decimal(text: &str) -> Option<BigRational> {
    let (whole, fraction) = text.split_once('.').unwrap_or((text, ""));
    let digits: num_bigint::BigInt = format!("{whole}{fraction}").parse().ok()?;
    let scale = num_bigint::BigInt::from(10).pow(u32::try_from(fraction.len()).ok()?);
    Some(BigRational::new(digits, scale))
}
