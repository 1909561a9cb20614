//! Polynomials over opaque symbols with exact coefficients.

use std::collections::BTreeMap;
use std::ops::{Add, Neg, Sub};

use super::surd::Surd;

/// A variable; its meaning is defined where it is made.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Symbol(pub(crate) u32);

/// Product of powers, sorted by symbol; the empty product is 1.
pub(crate) type Monomial = Vec<(Symbol, u32)>;

/// Sum of monomials with non-zero coefficients. Products need the relations of a [`Ring`](super::Ring).
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Default)]
pub struct Poly {
    pub(crate) terms: BTreeMap<Monomial, Surd>,
}

impl Poly {
    /// The zero polynomial.
    #[must_use]
    pub fn zero() -> Self {
        Self::default()
    }

    /// The constant 1.
    #[must_use]
    pub fn one() -> Self {
        Self::from(Surd::one())
    }

    /// True for the zero polynomial.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// True for the constant 1.
    #[must_use]
    pub fn is_one(&self) -> bool {
        self.as_number().is_some_and(|number| number.is_one())
    }

    /// The value, if no symbol occurs.
    #[must_use]
    pub fn as_number(&self) -> Option<Surd> {
        match self.terms.len() {
            0 => Some(Surd::zero()),
            1 => self.terms.get(&Monomial::new()).cloned(),
            _ => None,
        }
    }

    /// Number of monomials.
    #[must_use]
    pub fn monomials(&self) -> usize {
        self.terms.len()
    }

    /// Symbols that occur.
    pub fn symbols(&self) -> impl Iterator<Item = Symbol> + '_ {
        self.terms.keys().flatten().map(|(symbol, _)| *symbol)
    }

    /// Monomials as powers of symbols, sorted by symbol, with their factors.
    pub fn terms(&self) -> impl Iterator<Item = (&[(Symbol, u32)], &Surd)> + '_ {
        self.terms.iter().map(|(monomial, factor)| (monomial.as_slice(), factor))
    }

    /// Factors of the monomials.
    pub fn coefficients(&self) -> impl Iterator<Item = &Surd> + '_ {
        self.terms.values()
    }

    /// Highest power of a symbol.
    #[must_use]
    pub fn degree(&self, symbol: Symbol) -> u32 {
        self.terms.keys().flatten().filter(|(s, _)| *s == symbol).map(|(_, power)| *power).max().unwrap_or(0)
    }

    /// Coefficient of `symbol^power` as a polynomial in the other symbols.
    #[must_use]
    pub fn coefficient(&self, symbol: Symbol, power: u32) -> Self {
        let mut part = Self::zero();
        for (monomial, factor) in &self.terms {
            let found = monomial.iter().find(|(s, _)| *s == symbol).map_or(0, |(_, p)| *p);
            if found == power {
                let rest = monomial.iter().filter(|(s, _)| *s != symbol).copied().collect();
                part.terms.insert(rest, factor.clone());
            }
        }
        part
    }

    /// The same polynomial times a number.
    #[must_use]
    pub fn scaled(&self, factor: &Surd) -> Self {
        if factor.is_zero() {
            return Self::zero();
        }
        Self { terms: self.terms.iter().map(|(monomial, c)| (monomial.clone(), c * factor)).collect() }
    }

    pub(crate) fn add_term(&mut self, monomial: Monomial, factor: Surd) {
        use std::collections::btree_map::Entry;
        match self.terms.entry(monomial) {
            Entry::Vacant(entry) => {
                if !factor.is_zero() {
                    entry.insert(factor);
                }
            }
            Entry::Occupied(mut entry) => {
                let sum = entry.get() + &factor;
                if sum.is_zero() {
                    entry.remove();
                } else {
                    entry.insert(sum);
                }
            }
        }
    }
}

impl From<Surd> for Poly {
    fn from(value: Surd) -> Self {
        let mut poly = Self::zero();
        poly.add_term(Monomial::new(), value);
        poly
    }
}

impl From<i64> for Poly {
    fn from(value: i64) -> Self {
        Self::from(Surd::from(value))
    }
}

impl From<Symbol> for Poly {
    fn from(symbol: Symbol) -> Self {
        let mut poly = Self::zero();
        poly.add_term(vec![(symbol, 1)], Surd::one());
        poly
    }
}

impl Add for &Poly {
    type Output = Poly;
    fn add(self, other: &Poly) -> Poly {
        let mut sum = self.clone();
        for (monomial, factor) in &other.terms {
            sum.add_term(monomial.clone(), factor.clone());
        }
        sum
    }
}

impl Sub for &Poly {
    type Output = Poly;
    fn sub(self, other: &Poly) -> Poly {
        self + &-other
    }
}

impl Neg for &Poly {
    type Output = Poly;
    fn neg(self) -> Poly {
        Poly { terms: self.terms.iter().map(|(monomial, c)| (monomial.clone(), -c)).collect() }
    }
}
