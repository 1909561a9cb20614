//! The verdict on an equation: it holds under stated conditions, or it does not hold.
//!
//! Both sides are polynomials in axis values, sines and cosines, in roots `r` with `r² = E` and reciprocals.
//! - Numbers are equal if their difference has remainder zero. After all roots are eliminated, only sines and cosines
//!   of unknown angles remain, and then any other remainder refutes. Fixed angles without exact values count as
//!   unknown: an equation that holds only because one angle is 11 deg and another 33 deg is refused.
//! - Angles `L`, `R` with directions `(cL, sL)`, `(cR, sR)` are equal where `sin(L-R) = sL cR - cL sR` is zero and
//!   `λ = cL cR + sL sR` is positive. With `asin(p)` or `acos(p)` on one side they are equal where `p` is the sine or
//!   cosine of the other side and the other part has the sign that the function gives it.
//! - `a + b r = 0` with `r >= 0` is equivalent to `a² - b² E = 0` and `-a b >= 0`. No root is extracted: the ring is
//!   not a unique factorisation domain.
//!
//! An equation is accepted only with a witness: a rational point of the circles at which every condition holds.

use super::algebra::too_large;
use super::scope::Scope;
use super::value::{Angle, Inverse, Value, zero_as_angle};
use super::witness::{Claims, Region, has_witness};
use crate::check::Fault;
use crate::formula::Formula;
use crate::symbolic::{Poly, Sign, Symbol, hidden_zeros_of, sign_of, zeros_of};
use crate::syntax::{Equation, Expr};

/// Monomials that may be reduced for one equation: two seconds where the macro is not optimised. The largest equation
/// of the papers takes 325.
const MOST_STEPS: usize = 500_000;

/// Longest condition that is read at a glance, in characters.
const LONGEST_CONDITION: usize = 40;

/// The verdict on an equation.
#[derive(Debug)]
pub(crate) enum Verdict {
    /// It holds where all of these are true, everywhere if there are none; the same as a region of poses.
    Holds(Vec<Condition>, Region),
    /// The angles differ by 180 deg at every pose at which both exist.
    Opposite,
    /// It is true at no pose at which its roots and conditions exist.
    Nowhere,
    /// It is false; the polynomial that should be zero.
    False(Poly),
}

/// A condition under which an equation holds.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Condition {
    /// `λ > 0`
    Positive(Sign),
    /// A radicand, or a sign that selects the right one of two roots.
    NotNegative(Sign),
    /// A divisor, as factors.
    NotZero(Vec<Poly>),
}

/// Decides an equation.
pub(crate) fn decide(scope: &mut Scope<'_>, equation: &Equation) -> Result<Verdict, Fault> {
    scope.begin();
    scope.algebra_mut().ring_mut().limit(MOST_STEPS);
    let verdict = decide_within(scope, equation);
    if scope.algebra_mut().ring_mut().end_limit() { Err(too_large(&equation.right)) } else { verdict }
}

fn decide_within(scope: &mut Scope<'_>, equation: &Equation) -> Result<Verdict, Fault> {
    let left = scope.value(&equation.left)?;
    let right = scope.value(&equation.right)?;
    Decision { scope, expr: &equation.right, eliminated: Vec::new() }.equal(left, right, equation)
}

/// `a + b r = 0`, used to eliminate the root `r`.
struct Eliminated {
    root: Symbol,
    a: Poly,
    b: Poly,
}

struct Decision<'s, 'a, 'e> {
    scope: &'s mut Scope<'a>,
    /// The expression that messages point to.
    expr: &'e Expr,
    eliminated: Vec<Eliminated>,
}

impl Decision<'_, '_, '_> {
    fn equal(mut self, left: Value, right: Value, equation: &Equation) -> Result<Verdict, Fault> {
        let (gap, claims) = match (left, right) {
            (Value::Number(left), Value::Number(right)) => (&left - &right, Claims::default()),
            (left, right) => {
                let (Some(left), Some(right)) = (zero_as_angle(&left), zero_as_angle(&right)) else {
                    return Err(Fault::new(
                        equation.phrase,
                        "one side is an angle, the other is a number",
                        "a rotary axis equals atan2, asin or acos of numbers, or a sum of angles",
                    ));
                };
                self.angles(&left, &right)?
            }
        };
        if !self.vanishes(gap.clone())? {
            return Ok(Verdict::False(gap));
        }
        self.conclude(claims)
    }

    /// The polynomial that has to vanish for two angles to be equal, and the signs that they need.
    fn angles(&mut self, left: &Angle, right: &Angle) -> Result<(Poly, Claims), Fault> {
        for (inverted, other) in [(right, left), (left, right)] {
            let Some(inverse) = &inverted.inverse else { continue };
            let squares = [&other.cosine, &other.sine].map(|part| self.scope.ring().mul(part, part));
            if other.inverse.is_some() || !self.scope.ring().is_zero(&(&(&squares[0] + &squares[1]) - &Poly::one())) {
                continue;
            }
            let (gap, sign) = match inverse {
                Inverse::Sine(part) => (part - &other.sine, other.cosine.clone()),
                Inverse::Cosine(part, false) => (part - &other.cosine, other.sine.clone()),
                Inverse::Cosine(part, true) => (part - &other.cosine, -&other.sine),
            };
            // The root in its other part needs no condition: its radicand equals a square.
            let own = |root: &Symbol| !gap.symbols().chain(sign.symbols()).any(|symbol| symbol == *root);
            let spent = if matches!(inverse, Inverse::Sine(_)) { &inverted.cosine } else { &inverted.sine };
            let spent: Vec<Symbol> = spent.symbols().filter(own).collect();
            self.scope.algebra_mut().drop_roots(&spent);
            return Ok((gap, Claims { not_negative: vec![sign], ..Claims::default() }));
        }
        let between = self.scope.algebra().sum(left, &right.clone().negated(), self.expr)?;
        Ok((between.sine, Claims { positive: vec![between.cosine], ..Claims::default() }))
    }

    /// True if a polynomial is zero on the part that `eliminated` describes.
    fn vanishes(&mut self, poly: Poly) -> Result<bool, Fault> {
        self.scope.algebra().affordable(&poly, self.expr)?;
        let poly = self.scope.ring().clear_even(&poly);
        if self.scope.ring().is_zero(&poly) {
            return Ok(true);
        }
        for root in self.scope.algebra().roots().into_iter().rev() {
            let (a, b) = (poly.coefficient(root, 0), poly.coefficient(root, 1));
            if self.scope.ring().is_zero(&b) {
                continue;
            }
            let radicand = self.scope.ring().square_of(root);
            let squares = [self.times(&a, &a)?, self.times(&b, &b)?];
            let product = self.times(&squares[1], &radicand)?;
            self.scope.algebra_mut().drop_roots(&[root]);
            self.eliminated.push(Eliminated { root, a, b });
            return self.vanishes(&squares[0] - &product);
        }
        Ok(false)
    }

    /// The verdict on an equation whose gap vanishes.
    fn conclude(&mut self, mut claims: Claims) -> Result<Verdict, Fault> {
        claims.not_negative.extend(self.signs_of_roots()?);
        let angles = !claims.positive.is_empty();
        let positive = self.resolved(claims.positive)?;
        if positive.iter().any(|poly| self.scope.ring().is_zero(poly)) {
            // Both arguments of an atan2 are zero.
            return Ok(Verdict::Nowhere);
        }
        let mut not_negative = self.resolved(claims.not_negative)?;
        not_negative.retain(|poly| !self.scope.ring().is_zero(poly));
        let region = self.region(Claims { positive: positive.clone(), not_negative: not_negative.clone() });
        if has_witness(self.scope, &[&region]) {
            return Ok(Verdict::Holds(self.conditions(&positive, &not_negative)?, region));
        }
        let negative: Vec<Poly> = positive.iter().map(|poly| -poly).collect();
        let opposite = angles && has_witness(self.scope, &[&self.region(Claims { positive: negative, not_negative })]);
        Ok(if opposite { Verdict::Opposite } else { Verdict::Nowhere })
    }

    /// The poses at which claims hold, with all roots and divisors of the equation.
    fn region(&self, claims: Claims) -> Region {
        let algebra = self.scope.algebra();
        let eliminated = self.eliminated.iter().map(|eliminated| eliminated.root);
        let roots = algebra.roots().into_iter().chain(eliminated).collect();
        Region::new(algebra.ring().clone(), algebra.divisors().to_vec(), roots, claims)
    }

    /// Polynomials that must not be negative: radicands, and the signs by which eliminated roots are the right ones.
    fn signs_of_roots(&self) -> Result<Vec<Poly>, Fault> {
        let mut not_negative = Vec::new();
        for Eliminated { root, a, b } in &self.eliminated {
            not_negative.push(-&self.times(a, b)?);
            // b² E = a² makes E not negative, unless b vanishes on a whole part, as `√(s²) - s` does.
            if b.symbols().any(|symbol| self.scope.ring().is_root(symbol)) {
                not_negative.push(self.scope.ring().square_of(*root));
            }
        }
        let roots = self.scope.algebra().roots();
        not_negative.extend(roots.into_iter().map(|root| self.scope.ring().square_of(root)));
        Ok(not_negative)
    }

    /// Claims and divisors as conditions, each once, without those that always hold.
    fn conditions(&self, positive: &[Poly], not_negative: &[Poly]) -> Result<Vec<Condition>, Fault> {
        let divisors = self.scope.algebra().divisors().iter().map(|(divisor, _)| self.norm(divisor));
        let divisors = divisors.collect::<Result<Vec<_>, Fault>>()?;
        let (circles, ring) = (self.scope.circles(), self.scope.ring());
        let mut conditions: Vec<Condition> = Vec::new();
        let mut add = |condition: Condition| {
            if !conditions.contains(&condition) {
                conditions.push(condition);
            }
        };
        let mut strict = Vec::new();
        for poly in positive {
            let sign = sign_of(ring, poly, &circles);
            if !sign.factors.is_empty() {
                strict.push(sign.clone());
                add(Condition::Positive(sign));
            }
            let zeros = self.zeros_of_claim(poly, &circles)?;
            if !zeros.is_empty() {
                add(Condition::NotZero(zeros));
            }
        }
        for poly in not_negative {
            let sign = sign_of(ring, poly, &circles);
            if !sign.factors.is_empty() && !strict.contains(&sign) {
                add(Condition::NotNegative(sign));
            }
        }
        for divisor in &divisors {
            let zeros = zeros_of(ring, divisor, &circles);
            if !zeros.is_empty() {
                add(Condition::NotZero(zeros));
            }
        }
        Ok(conditions)
    }

    /// Zeros of a strict claim that its sign does not show, without the factors that `resolved` has multiplied in.
    fn zeros_of_claim(&self, poly: &Poly, circles: &[(Symbol, Symbol)]) -> Result<Vec<Poly>, Fault> {
        let ring = self.scope.ring();
        let factors: Vec<Poly> =
            self.eliminated.iter().flat_map(|eliminated| zeros_of(ring, &eliminated.b, circles)).collect();
        let mut zeros = hidden_zeros_of(ring, poly, circles);
        zeros.retain(|zero| !factors.contains(zero));
        zeros.iter().map(|zero| self.norm(zero)).collect()
    }

    /// Polynomials of the same signs without the eliminated roots: with `r = -a/b`, `u + v r` has the sign of
    /// `(u b - v a) b`.
    fn resolved(&self, polys: Vec<Poly>) -> Result<Vec<Poly>, Fault> {
        let mut resolved = Vec::new();
        for poly in polys {
            let mut poly = self.scope.ring().clear_even(&poly);
            for Eliminated { root, a, b } in &self.eliminated {
                let (u, v) = (poly.coefficient(*root, 0), poly.coefficient(*root, 1));
                if v.is_zero() {
                    continue;
                }
                let sum = &self.times(&u, b)? - &self.times(&v, a)?;
                poly = self.times(&sum, b)?;
            }
            resolved.push(poly);
        }
        Ok(resolved)
    }

    /// A polynomial without roots that is zero wherever this one is: `u + v r` is a factor of `u² - v² E`.
    fn norm(&self, poly: &Poly) -> Result<Poly, Fault> {
        let mut norm = self.scope.ring().clear_even(poly);
        let eliminated = self.eliminated.iter().map(|eliminated| eliminated.root);
        let mut roots: Vec<Symbol> = self.scope.algebra().roots().into_iter().chain(eliminated).collect();
        roots.sort();
        // A root may be in the radicand of a later one.
        for root in roots.into_iter().rev() {
            let (u, v) = (norm.coefficient(root, 0), norm.coefficient(root, 1));
            if !v.is_zero() {
                let radicand = self.scope.ring().square_of(root);
                let squares = [self.times(&u, &u)?, self.times(&v, &v)?];
                norm = self.scope.ring().clear_even(&(&squares[0] - &self.times(&squares[1], &radicand)?));
            }
        }
        Ok(norm)
    }

    fn times(&self, a: &Poly, b: &Poly) -> Result<Poly, Fault> {
        self.scope.algebra().times(a, b, self.expr)
    }
}

impl Condition {
    /// Text with the names of the declaration: `sin B > 0`.
    pub(crate) fn text(&self, scope: &Scope<'_>) -> String {
        let product = |factors: &[Poly], negative: bool| {
            let factors: Vec<Formula> = factors.iter().map(|factor| scope.algebra().formula(factor)).collect();
            let product = if factors.len() == 1 { factors[0].text() } else { Formula::Product(factors).text() };
            (product, negative)
        };
        match self {
            Self::Positive(sign) => {
                let (product, negative) = product(&sign.factors, sign.negative);
                format!("{product} {} 0", if negative { "<" } else { ">" })
            }
            Self::NotNegative(sign) => {
                let (product, negative) = product(&sign.factors, sign.negative);
                format!("{product} {} 0", if negative { "<=" } else { ">=" })
            }
            Self::NotZero(zeros) => format!("{} != 0", product(zeros, false).0),
        }
    }

    /// The condition as a person reads it: an angle in place of `1 - cos B`, and words in place of long factors of
    /// divisors.
    pub(crate) fn words(&self, scope: &Scope<'_>) -> Vec<String> {
        let Self::NotZero(zeros) = self else { return vec![self.text(scope)] };
        let mut words: Vec<String> = Vec::new();
        for zero in zeros {
            let text = || Some(format!("{} != 0", scope.algebra().formula(zero).text()));
            let readable = scope.angle_at_which_zero(zero).or_else(text).filter(|text| text.len() <= LONGEST_CONDITION);
            let text = readable.unwrap_or_else(|| {
                "no divisor is zero, and no arc tangent has both arguments zero (long conditions)".into()
            });
            if !words.contains(&text) {
                words.push(text);
            }
        }
        words
    }
}
