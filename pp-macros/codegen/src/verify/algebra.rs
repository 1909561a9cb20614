//! The algebra of one equation: products with a limit on the work, and the equation's roots and reciprocals.

use std::cell::Cell;

use num_rational::BigRational;
use num_traits::ToPrimitive;

use super::value::Angle;
use crate::check::Fault;
use crate::formula::Formula;
use crate::model::Model;
use crate::symbolic::{Poly, Ring, Symbol};
use crate::syntax::Expr;

/// Products of more monomials than this are not multiplied out; no paper prints one.
const MOST_MONOMIALS: usize = 200_000;

/// Sums of more terms are not shown: they are too long to read, and factoring them is slow.
const MOST_TERMS: usize = 100;

/// Products of monomials allowed for one equation: a second or two.
const MOST_WORK: usize = 50_000;

/// Monomials that a polynomial may have when all divisors are multiplied out, before like terms are added.
const MOST_CLEARED: usize = 20_000;

/// Largest power of one divisor.
const MOST_DIVISIONS: u32 = 8;

/// Symbols of an equation, and the work spent on it.
#[derive(Debug, Clone)]
pub(crate) struct Algebra<'a> {
    model: &'a Model,
    ring: Ring,
    /// Divisors of the current equation, with their reciprocals.
    divisors: Vec<(Poly, Symbol)>,
    /// Roots of the current equation.
    roots: Vec<Symbol>,
    /// Products of monomials computed for the current equation.
    work: Cell<usize>,
}

impl<'a> Algebra<'a> {
    /// Over the symbols of a ring.
    pub(crate) fn new(model: &'a Model, ring: Ring) -> Self {
        Self { model, ring, divisors: Vec::new(), roots: Vec::new(), work: Cell::new(0) }
    }

    /// The machine.
    pub(crate) fn model(&self) -> &'a Model {
        self.model
    }

    /// Symbols and their relations.
    pub(crate) fn ring(&self) -> &Ring {
        &self.ring
    }

    /// The ring, for adding symbols.
    pub(crate) fn ring_mut(&mut self) -> &mut Ring {
        &mut self.ring
    }

    /// Divisors with their reciprocals.
    pub(crate) fn divisors(&self) -> &[(Poly, Symbol)] {
        &self.divisors
    }

    /// Roots that are not eliminated; one may be in the radicand of a later one.
    pub(crate) fn roots(&self) -> Vec<Symbol> {
        let mut roots = self.roots.clone();
        roots.sort();
        roots
    }

    /// Removes roots that need not be eliminated.
    pub(crate) fn drop_roots(&mut self, roots: &[Symbol]) {
        self.roots.retain(|root| !roots.contains(root));
    }

    /// Products of monomials computed for the current equation.
    pub(crate) fn work(&self) -> usize {
        self.work.get()
    }

    /// Begins an equation: clears divisors, roots and work.
    pub(crate) fn begin(&mut self) {
        self.divisors.clear();
        self.roots.clear();
        self.work.set(0);
    }

    /// One part of an angle divided by the length of its direction.
    pub(crate) fn unit_part(&mut self, angle: &Angle, part: &Poly, expr: &Expr) -> Result<Poly, Fault> {
        let squares = [self.times(&angle.cosine, &angle.cosine, expr)?, self.times(&angle.sine, &angle.sine, expr)?];
        let square = &squares[0] + &squares[1];
        if self.ring.is_zero(&(&square - &Poly::one())) {
            return Ok(part.clone());
        }
        let length = self.root(square, expr)?;
        let inverse = self.reciprocal(length, expr)?;
        self.times(part, &inverse, expr)
    }

    /// Rule `angle-sum`.
    pub(crate) fn sum(&self, a: &Angle, b: &Angle, expr: &Expr) -> Result<Angle, Fault> {
        let cosine = &self.times(&a.cosine, &b.cosine, expr)? - &self.times(&a.sine, &b.sine, expr)?;
        let sine = &self.times(&a.sine, &b.cosine, expr)? + &self.times(&a.cosine, &b.sine, expr)?;
        Ok(Angle { cosine, sine, inverse: None })
    }

    /// An angle times a whole number.
    pub(crate) fn multiple(&self, angle: &Angle, factor: &Poly, expr: &Expr) -> Result<Angle, Fault> {
        let whole = factor.as_number().and_then(|number| number.as_rational()).filter(BigRational::is_integer);
        let Some(times) = whole.and_then(|times| times.to_integer().to_i32()).filter(|times| times.abs() <= 24) else {
            return Err(Fault::new(
                expr.phrase,
                "an angle can be multiplied only by a whole number up to 24",
                "take sin or cos of it: `x * cos(C)`",
            ));
        };
        let step = if times < 0 { angle.clone().negated() } else { angle.clone() };
        if times.abs() == 1 {
            return Ok(step);
        }
        let mut sum = Angle::zero();
        for _ in 0..times.abs() {
            sum = self.sum(&sum, &step, expr)?;
        }
        Ok(sum)
    }

    /// Product; refuses one larger than any printed formula.
    pub(crate) fn times(&self, a: &Poly, b: &Poly, expr: &Expr) -> Result<Poly, Fault> {
        let work = a.monomials() * b.monomials();
        self.work.set(self.work.get() + work);
        if work > MOST_MONOMIALS || self.work.get() > MOST_WORK {
            return Err(too_large(expr));
        }
        let product = self.ring.mul(a, b);
        self.affordable(&product, expr)?;
        Ok(product)
    }

    /// Refuses a polynomial that would become too large when its divisors are multiplied out.
    pub(crate) fn affordable(&self, poly: &Poly, expr: &Expr) -> Result<(), Fault> {
        let mut size = poly.monomials();
        for (divisor, symbol) in &self.divisors {
            let degree = poly.degree(*symbol);
            let growth = divisor.monomials().checked_pow(degree).unwrap_or(usize::MAX);
            size = size.saturating_mul(growth);
            if degree > MOST_DIVISIONS {
                return Err(too_large(expr));
            }
        }
        if size > MOST_CLEARED { Err(too_large(expr)) } else { Ok(()) }
    }

    /// A polynomial as people write it; for one that is too long, only the number of its terms.
    pub(crate) fn formula(&self, poly: &Poly) -> Formula {
        match poly.monomials() {
            terms if terms > MOST_TERMS => Formula::Sum(vec![Formula::name(format!("a sum of {terms} terms"))]),
            _ => Formula::of_poly(self.model, &self.ring, poly),
        }
    }

    /// A root: a number, one that is known, or a new one.
    pub(crate) fn root(&mut self, radicand: Poly, expr: &Expr) -> Result<Poly, Fault> {
        let number = radicand.as_number();
        if number.as_ref().is_some_and(|number| number.sign().is_lt())
            || self.ring.value(&radicand).is_some_and(|value| value < 0.0)
        {
            return Err(Fault::new(
                expr.phrase,
                "the number under the root is negative",
                "check the signs under the root",
            ));
        }
        if let Some(root) = number.and_then(|number| number.sqrt()) {
            return Ok(Poly::from(root));
        }
        if self.ring.is_zero(&radicand) {
            return Ok(Poly::zero());
        }
        if let Some(known) = self.roots.iter().find(|root| self.ring.square_of(**root) == radicand) {
            return Ok(Poly::from(*known));
        }
        let name = format!("sqrt({})", self.formula(&radicand).source());
        let root = self.ring.root(name, radicand);
        self.roots.push(root);
        Ok(Poly::from(root))
    }

    /// A reciprocal: a number, one that is known, or a new one.
    pub(crate) fn reciprocal(&mut self, divisor: Poly, expr: &Expr) -> Result<Poly, Fault> {
        if let Some(number) = divisor.as_number()
            && let Some(inverse) = number.inverse()
        {
            return Ok(Poly::from(inverse));
        }
        if self.ring.is_zero(&divisor) {
            return Err(Fault::new(
                expr.phrase,
                format!("the divisor `{expr}` is zero at every pose of this machine"),
                "check the divisor: division by zero has no value",
            ));
        }
        if let (Some(value), Some(size)) = (self.ring.value(&divisor), self.ring.magnitude(&divisor, &|_| None))
            && value.abs() <= 1e-12 * size
        {
            return Err(Fault::new(
                expr.phrase,
                format!("the divisor `{expr}` is a constant that cannot be distinguished from zero"),
                "check the divisor: division by zero has no value",
            ));
        }
        if let Some((_, known)) = self.divisors.iter().find(|(known, _)| *known == divisor) {
            return Ok(Poly::from(*known));
        }
        if divisor.monomials() > 64 {
            return Err(too_large(expr));
        }
        let number = self.divisors.len() + 1;
        let symbol = self.ring.reciprocal(format!("inverse_{number}"), divisor.clone());
        self.divisors.push((divisor, symbol));
        Ok(Poly::from(symbol))
    }
}

pub(super) fn too_large(expr: &Expr) -> Fault {
    Fault::new(
        expr.phrase,
        "this expression is too large to be decided",
        "split the equation into shorter ones, or write it in factors",
    )
}
