//! The sign of a polynomial, as a product of factors that can be checked by hand.
//!
//! Only the *text* of conditions depends on this module: that a formula holds is proven by remainders, and where it
//! holds is stated by the polynomial that comes in. Five rules; none changes the sign:
//! - `clear-even`: a reciprocal is cleared by an even power of its divisor;
//! - `content`: positive numbers and even powers are left out;
//! - `factor`: `sin T`, `cos T`, `1 ± sin T` and `1 ± cos T` are divided out where they divide exactly; the last two
//!   are never negative;
//! - `root`: a root is never negative;
//! - `vertices`: a polynomial of first degree in each of several bounded quantities takes its extremes at their bounds.

use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};

use super::poly::{Monomial, Poly, Symbol};
use super::ring::Ring;
use super::surd::Surd;

/// Largest number of bounded quantities for the rule `vertices`.
const MOST_BOUNDS: usize = 12;

/// A sign: that of the product of `factors`, times -1 if `negative`. The polynomial never has the opposite sign, but
/// may be zero at more places.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Sign {
    /// One factor of -1.
    pub negative: bool,
    /// Factors whose sign may change; empty if the sign is constant.
    pub factors: Vec<Poly>,
}

/// The sign of a polynomial that is not identically zero. `circles` are pairs (sine, cosine).
#[must_use]
pub fn sign_of(ring: &Ring, poly: &Poly, circles: &[(Symbol, Symbol)]) -> Sign {
    let Factors { mut negative, list, rest } = factorise(ring, poly, circles);
    let mut factors: Vec<Poly> =
        list.into_iter().filter(|factor| factor.odd && !factor.bounded).map(|factor| factor.poly).collect();
    match bounds(ring, &rest, circles) {
        Some(Bounds { negative: true, .. }) => negative = !negative,
        Some(_) => {}
        None => factors.push(rest),
    }
    Sign { negative, factors }
}

/// Zeros of a polynomial that its [`Sign`] does not show: factors of even powers, and those that are never negative.
///
/// Left out is what vanishes only where a factor of the sign does: `1 ± cos T` next to `sin T`, `1 ± sin T` next to
/// `cos T`.
#[must_use]
pub fn hidden_zeros_of(ring: &Ring, poly: &Poly, circles: &[(Symbol, Symbol)]) -> Vec<Poly> {
    let Factors { list, rest, .. } = factorise(ring, poly, circles);
    let shown: Vec<&Poly> =
        list.iter().filter(|factor| factor.odd && !factor.bounded).map(|factor| &factor.poly).collect();
    let hidden = list.iter().filter(|factor| !shown.contains(&&factor.poly)).map(|factor| &factor.poly);
    let implied = |zero: &Poly| {
        circles.iter().any(|&(sine, cosine)| {
            divisors(sine, cosine).iter().any(|(divisor, bounded)| {
                let [_, of_sine, _] = divisor.parts;
                let partner = Poly::from(if of_sine == 0 { sine } else { cosine });
                *bounded && divisor.poly() == *zero && list.iter().any(|factor| factor.poly == partner)
            })
        })
    };
    let mut zeros: Vec<Poly> = hidden.filter(|zero| !implied(zero)).cloned().collect();
    if let Some(Bounds { touches_zero: true, .. }) = bounds(ring, &rest, circles) {
        zeros.push(rest);
    }
    zeros
}

/// Zeros of a polynomial: it is zero where one of these is, and nowhere else.
#[must_use]
pub fn zeros_of(ring: &Ring, poly: &Poly, circles: &[(Symbol, Symbol)]) -> Vec<Poly> {
    let Factors { list, rest, .. } = factorise(ring, poly, circles);
    let rest = Some(rest).filter(|rest| ring.value(rest).is_none());
    list.into_iter().map(|factor| factor.poly).chain(rest).collect()
}

/// A product of powers and what is left.
struct Factors {
    negative: bool,
    list: Vec<Factor>,
    rest: Poly,
}

struct Factor {
    poly: Poly,
    /// Its power is odd.
    odd: bool,
    /// It is never negative.
    bounded: bool,
}

fn factorise(ring: &Ring, poly: &Poly, circles: &[(Symbol, Symbol)]) -> Factors {
    let mut factors = Factors { negative: false, list: Vec::new(), rest: Poly::zero() };
    let mut rest = without_content(ring, &ring.clear_even(poly), &mut factors);
    for &(sine, cosine) in circles {
        for (divisor, bounded) in divisors(sine, cosine) {
            let mut power = 0;
            while rest.as_number().is_none()
                && let Some(quotient) = divisor.divide(ring, &rest)
            {
                power += 1;
                rest = quotient;
            }
            if power > 0 {
                factors.list.push(Factor { poly: divisor.poly(), odd: power % 2 == 1, bounded });
            }
        }
    }
    factors.rest = without_content(ring, &rest, &mut factors);
    factors
}

/// Rule `content`: a number and single symbols common to all monomials.
fn without_content(ring: &Ring, poly: &Poly, factors: &mut Factors) -> Poly {
    let Some((first, _)) = poly.terms.first_key_value() else { return poly.clone() };
    let mut common: BTreeMap<Symbol, u32> = first.iter().copied().collect();
    for monomial in poly.terms.keys() {
        let powers: BTreeMap<Symbol, u32> = monomial.iter().copied().collect();
        common = common
            .into_iter()
            .filter_map(|(symbol, power)| powers.get(&symbol).map(|other| (symbol, power.min(*other))))
            .collect();
    }
    for (&symbol, power) in &common {
        let own = Poly::from(symbol);
        match ring.value(&own) {
            Some(value) => factors.negative ^= value < 0.0 && power % 2 == 1,
            // Rule `root`: a root is never negative.
            None => factors.list.push(Factor { poly: own, odd: power % 2 == 1, bounded: ring.is_root(symbol) }),
        }
    }
    // The leading number becomes ±1 if all are rational multiples of it; then the first term is made positive.
    let mut rest = Poly::zero();
    let lead = poly.terms.values().next().cloned().unwrap_or_default();
    let scale = lead.inverse().unwrap_or_else(Surd::one);
    factors.negative ^= lead.sign() == Ordering::Less;
    for (monomial, factor) in &poly.terms {
        let left: Monomial = monomial
            .iter()
            .filter_map(|&(symbol, power)| {
                let power = power - common.get(&symbol).copied().unwrap_or_default();
                (power > 0).then_some((symbol, power))
            })
            .collect();
        rest.add_term(left, factor * &scale);
    }
    rest
}

/// A candidate for a factor, `a + b·s` or `a + b·c`.
struct Divisor {
    sine: Symbol,
    cosine: Symbol,
    /// Coefficients of 1, sine, cosine.
    parts: [i64; 3],
}

/// Divisors in the order of trying, and whether they are never negative.
fn divisors(sine: Symbol, cosine: Symbol) -> [(Divisor, bool); 6] {
    let of = |parts: [i64; 3], bounded: bool| (Divisor { sine, cosine, parts }, bounded);
    [
        of([0, 1, 0], false),
        of([0, 0, 1], false),
        of([1, 0, -1], true),
        of([1, 0, 1], true),
        of([1, -1, 0], true),
        of([1, 1, 0], true),
    ]
}

impl Divisor {
    fn poly(&self) -> Poly {
        let [number, sine, cosine] = self.parts.map(Surd::from);
        let sum = &Poly::from(number) + &Poly::from(self.sine).scaled(&sine);
        &sum + &Poly::from(self.cosine).scaled(&cosine)
    }

    /// Rule `factor`: times the conjugate the divisor is a polynomial in the sine alone, and elements of the
    /// ring are polynomials in the sine over the basis 1, cosine: division with remainder decides.
    fn divide(&self, ring: &Ring, poly: &Poly) -> Option<Poly> {
        let [number, sine, cosine] = self.parts;
        if cosine == 0 {
            return divide_by_univariate(poly, self.sine, &[number, sine]);
        }
        let conjugate = Self { parts: [number, 0, -cosine], ..*self };
        // (a + b c)(a - b c) = a² - b² + b² s²
        let norm = [number * number - cosine * cosine, 0, cosine * cosine];
        divide_by_univariate(&ring.mul(poly, &conjugate.poly()), self.sine, &norm)
    }
}

/// Quotient by `Σ divisor[n] x^n` with a leading coefficient ±1, if nothing remains.
fn divide_by_univariate(poly: &Poly, x: Symbol, divisor: &[i64]) -> Option<Poly> {
    let degree = divisor.len() - 1;
    let top = poly.degree(x) as usize;
    if top < degree {
        return poly.is_zero().then(Poly::zero);
    }
    let mut left: Vec<Poly> =
        (0..=top).map(|power| poly.coefficient(x, u32::try_from(power).unwrap_or(u32::MAX))).collect();
    let mut quotient = Poly::zero();
    for power in (degree..=top).rev() {
        let lead = left[power].scaled(&Surd::from(divisor[degree]));
        for (offset, factor) in divisor.iter().enumerate() {
            let place = power - degree + offset;
            left[place] = &left[place] - &lead.scaled(&Surd::from(*factor));
        }
        let raised = u32::try_from(power - degree).unwrap_or(u32::MAX);
        for (monomial, factor) in &lead.terms {
            let mut monomial = monomial.clone();
            if raised > 0 {
                let place = monomial.partition_point(|(symbol, _)| *symbol < x);
                monomial.insert(place, (x, raised));
            }
            quotient.add_term(monomial, factor.clone());
        }
    }
    left.iter().all(Poly::is_zero).then_some(quotient)
}

/// Result of the rule `vertices`.
struct Bounds {
    /// Never positive; otherwise never negative.
    negative: bool,
    /// Zero at a vertex: it may be zero somewhere.
    touches_zero: bool,
}

/// Rule `vertices`: `None` if the sign changes or is unknown.
///
/// Every power of a sine or cosine counts as a quantity of its own, even powers between 0 and 1, odd ones between -1
/// and 1: the tested points include all that exist, so a sign that holds for them holds. The sums are exact unless
/// constants without an exact value occur.
fn bounds(ring: &Ring, poly: &Poly, circles: &[(Symbol, Symbol)]) -> Option<Bounds> {
    let round: BTreeSet<Symbol> = circles.iter().flat_map(|(s, c)| [*s, *c]).collect();
    let mut quantities: Vec<(Symbol, u32)> = Vec::new();
    let mut exact = true;
    for &(symbol, power) in poly.terms.keys().flatten() {
        if ring.value(&Poly::from(symbol)).is_some() {
            exact = false;
            continue;
        }
        if !round.contains(&symbol) {
            return None;
        }
        if !quantities.contains(&(symbol, power)) {
            quantities.push((symbol, power));
        }
    }
    if quantities.len() > MOST_BOUNDS {
        return None;
    }
    let mut signs = BTreeSet::new();
    for vertex in 0..1_u32 << quantities.len() {
        let mut sum = 0.0;
        let mut exact_sum = Surd::zero();
        for (monomial, factor) in &poly.terms {
            let mut value = 1.0;
            for (symbol, power) in monomial {
                value *= match quantities.iter().position(|known| known == &(*symbol, *power)) {
                    Some(place) if vertex & (1 << place) != 0 => 1.0,
                    Some(_) if power % 2 == 0 => 0.0,
                    Some(_) => -1.0,
                    None => ring.value(&Poly::from(*symbol))?.powi((*power).cast_signed()),
                };
            }
            sum += value * factor.to_f64();
            if exact && value > 0.0 {
                exact_sum = &exact_sum + factor;
            } else if exact && value < 0.0 {
                exact_sum = &exact_sum - factor;
            }
        }
        // Without an exact value a sum within rounding counts as zero.
        let inexact = if sum.abs() < 1e-12 { Ordering::Equal } else { sum.total_cmp(&0.0) };
        signs.insert(if exact { exact_sum.sign() } else { inexact });
        if signs.contains(&Ordering::Less) && signs.contains(&Ordering::Greater) {
            return None;
        }
    }
    Some(Bounds { negative: signs.contains(&Ordering::Less), touches_zero: signs.contains(&Ordering::Equal) })
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Circle {
        ring: Ring,
        pair: (Symbol, Symbol),
        s: Poly,
        c: Poly,
    }

    fn circle() -> Circle {
        let mut ring = Ring::default();
        let pair = ring.sin_cos("s", "c");
        Circle { ring, pair, s: Poly::from(pair.0), c: Poly::from(pair.1) }
    }

    #[test]
    fn even_powers_and_positive_numbers_have_no_sign() {
        let Circle { ring, pair, s, c } = circle();
        // 3 s³ c² (1 - c) has the sign of s.
        let cube = ring.mul(&ring.mul(&s, &s), &s);
        let product = ring.mul(&ring.mul(&cube, &ring.mul(&c, &c)), &(&Poly::from(3) - &c.scaled(&Surd::from(3))));
        let sign = sign_of(&ring, &product, &[pair]);
        assert_eq!((sign.negative, &sign.factors[..]), (false, &[s.clone()][..]));
        let sign = sign_of(&ring, &-&product, &[pair]);
        assert!(sign.negative);
        assert_eq!(sign.factors, [s]);
    }

    #[test]
    fn a_sum_that_changes_its_sign_stays() {
        let Circle { ring, pair, s, c } = circle();
        let sum = &s + &c;
        assert_eq!(sign_of(&ring, &sum, &[pair]).factors, std::slice::from_ref(&sum));
        let positive = &sum + &Poly::from(3);
        assert_eq!(sign_of(&ring, &positive, &[pair]).factors, []);
    }

    #[test]
    fn a_sum_slightly_below_zero_keeps_its_factor() {
        let Circle { ring, pair, s, .. } = circle();
        let trifle = Surd::ratio(1_000_000_000_000_001, 1_000_000_000_000_000);
        let sum = &Poly::one() - &s.scaled(&trifle);
        assert_eq!(sign_of(&ring, &sum, &[pair]).factors, [sum]);
    }

    #[test]
    fn a_root_has_no_sign() {
        let Circle { mut ring, pair, s, .. } = circle();
        let r = Poly::from(ring.root("r", &Poly::one() + &s));
        let product = ring.mul(&r, &s);
        assert_eq!(sign_of(&ring, &product, &[pair]).factors, [s]);
        assert_eq!(hidden_zeros_of(&ring, &product, &[pair]), [r]);
    }

    #[test]
    fn zeros_without_a_sign_are_not_lost() {
        let Circle { ring, pair, s, c } = circle();
        let [one, two] = [1, 2].map(Poly::from);
        // s² (2 + c): zero with s, where the sign is zero anyway; 2 + c is never zero.
        let square = ring.mul(&ring.mul(&s, &s), &(&two + &c));
        assert_eq!(sign_of(&ring, &square, &[pair]).factors, []);
        assert_eq!(hidden_zeros_of(&ring, &square, &[pair]), std::slice::from_ref(&s));
        // 1 - c is zero only where s is.
        let product = ring.mul(&s, &(&one - &c));
        assert_eq!(hidden_zeros_of(&ring, &product, &[pair]), []);
        assert_eq!(hidden_zeros_of(&ring, &(&one - &c), &[pair]), [&one - &c]);
    }

    #[test]
    fn a_free_symbol_has_no_bounds() {
        let Circle { mut ring, pair, c, .. } = circle();
        let d = Poly::from(ring.symbol("d"));
        let sum = &(&d + &c) + &Poly::from(100);
        assert_eq!(sign_of(&ring, &sum, &[pair]).factors.len(), 1);
    }

    #[test]
    fn division_by_a_factor_leaves_no_remainder_or_is_refused() {
        let Circle { ring, pair, s, c } = circle();
        let [one, ..] = [1].map(Poly::from);
        let of = |parts| Divisor { sine: pair.0, cosine: pair.1, parts };
        let product = ring.mul(&(&one + &c), &(&s - &c));
        assert_eq!(of([1, 0, 1]).divide(&ring, &product), Some(&s - &c));
        assert_eq!(of([1, 0, -1]).divide(&ring, &product), None);
        // 1 - s² = c².
        assert_eq!(of([0, 0, 1]).divide(&ring, &(&one - &ring.mul(&s, &s))), Some(c));
    }

    #[test]
    fn the_sign_of_a_divisor_counts_once() {
        let Circle { mut ring, pair, s, c } = circle();
        let d = Poly::from(ring.symbol("d"));
        let v = Poly::from(ring.reciprocal("v", d.clone()));
        // s c / d
        let quotient = ring.mul(&ring.mul(&s, &c), &v);
        let Sign { mut factors, .. } = sign_of(&ring, &quotient, &[pair]);
        factors.sort();
        let mut expected = [d, s, c];
        expected.sort();
        assert_eq!(factors, expected);
    }
}
