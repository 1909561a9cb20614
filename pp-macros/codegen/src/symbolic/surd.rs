//! Exact numbers: sums of square roots of square-free numbers with rational factors.
//!
//! `q1·√n1 + q2·√n2 + ...` is closed under `+ - * /`, and holds every direction with rational components after
//! normalisation and every rotation by a multiple of 15°. Rationals are of any size: random directions overflow any
//! fixed width.
//!
//! Radicands are made square-free by trial division up to [`TRIAL_LIMIT`] and a test for perfect squares. Where that is
//! not conclusive (a radicand above the cube of the limit) no surd is returned, and the caller takes an algebraic
//! symbol with the root's square as its relation.

use std::cmp::Ordering;
use std::collections::BTreeMap;
use std::ops::{Add, Mul, Neg, Sub};

use num_bigint::{BigInt, BigUint};
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

/// Largest prime whose square is taken out of a radicand.
const TRIAL_LIMIT: u32 = 20_000;

/// Binary digits after the point in the conversion of a surd to a float.
const FLOAT_DIGITS: usize = 192;

/// A number `Σ q_n √n`, `n` square-free; the empty sum is zero.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct Surd {
    terms: BTreeMap<BigUint, BigRational>,
}

impl Surd {
    /// Zero.
    #[must_use]
    pub fn zero() -> Self {
        Self::default()
    }

    /// One.
    #[must_use]
    pub fn one() -> Self {
        Self::from(1)
    }

    /// `numerator / denominator`.
    ///
    /// # Panics
    /// If the denominator is zero.
    #[must_use]
    pub fn ratio(numerator: i64, denominator: i64) -> Self {
        Self::from(BigRational::new(numerator.into(), denominator.into()))
    }

    /// `√n` of a rational number; `None` for a negative one, or where the square-free part is not found.
    #[must_use]
    pub fn sqrt_of_rational(value: &BigRational) -> Option<Self> {
        if value.is_negative() {
            return None;
        }
        // Rule `square-out-of-root`, with √(p/q) = √(p·q) / q.
        let radicand = (value.numer() * value.denom()).magnitude().clone();
        let (outside, inside) = split_square(radicand)?;
        let factor = BigRational::new(outside.into(), value.denom().clone());
        Some(Self::term(inside, factor))
    }

    /// Square root, where it is a surd again: rational numbers only.
    #[must_use]
    pub fn sqrt(&self) -> Option<Self> {
        Self::sqrt_of_rational(&self.as_rational()?)
    }

    /// The number as a rational, if it is one.
    #[must_use]
    pub fn as_rational(&self) -> Option<BigRational> {
        match self.terms.len() {
            0 => Some(BigRational::zero()),
            1 => self.terms.get(&BigUint::one()).cloned(),
            _ => None,
        }
    }

    /// Square-free radicands with their factors, smallest radicand first.
    pub fn terms(&self) -> impl Iterator<Item = (&BigUint, &BigRational)> + '_ {
        self.terms.iter()
    }

    /// True for the empty sum.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// True for exactly 1.
    #[must_use]
    pub fn is_one(&self) -> bool {
        self.terms.len() == 1 && self.terms.get(&BigUint::one()).is_some_and(One::is_one)
    }

    /// `1 / self`, by conjugates; `None` for zero.
    #[must_use]
    pub fn inverse(&self) -> Option<Self> {
        if self.is_zero() {
            return None;
        }
        if let Some(rational) = self.as_rational() {
            return Some(Self::from(rational.recip()));
        }
        // Rule `conjugate`: self = a + √b·c with a and c free of √b: 1/self = (a - √b·c) / (a² - b·c²), one root less
        // below.
        let (a, base, c) = self.split()?;
        let b = Self::from(BigRational::from(BigInt::from(base.clone())));
        let norm = &(&a * &a) - &(&b * &(&c * &c));
        let conjugate = &a - &(&Self::term(base, BigRational::one()) * &c);
        Some(&conjugate * &norm.inverse()?)
    }

    /// Exact sign: `a + √b·c` has the sign of both, or else that of the larger square.
    #[must_use]
    pub fn sign(&self) -> Ordering {
        if let Some(rational) = self.as_rational() {
            return rational.cmp(&BigRational::zero());
        }
        let Some((a, base, c)) = self.split() else { return Ordering::Equal };
        let (first, second) = (a.sign(), c.sign());
        if first == second || second == Ordering::Equal {
            return first;
        }
        if first == Ordering::Equal {
            return second;
        }
        let b = Self::from(BigRational::from(BigInt::from(base)));
        let gap = &(&a * &a) - &(&b * &(&c * &c));
        if gap.sign() == Ordering::Greater { first } else { second }
    }

    /// `a`, `b`, `c` with the number `a + √b·c`, `a` and `c` free of `√b`; `None` for a rational number.
    fn split(&self) -> Option<(Self, BigUint, Self)> {
        let base = self.coprime_base().into_iter().next()?;
        let mut a = Self::zero();
        let mut c = Self::zero();
        for (radicand, factor) in &self.terms {
            let (quotient, remainder) = radicand.div_rem(&base);
            if remainder.is_zero() {
                c.terms.insert(quotient, factor.clone());
            } else {
                a.terms.insert(radicand.clone(), factor.clone());
            }
        }
        Some((a, base, c))
    }

    /// Nearest float.
    #[must_use]
    pub fn to_f64(&self) -> f64 {
        let mut sum = BigRational::zero();
        let scale = BigInt::one() << FLOAT_DIGITS;
        for (radicand, factor) in &self.terms {
            let root = (radicand << (2 * FLOAT_DIGITS)).sqrt();
            sum += factor * BigRational::new(root.into(), scale.clone());
        }
        sum.to_f64().unwrap_or(f64::NAN)
    }

    fn term(radicand: BigUint, factor: BigRational) -> Self {
        let mut terms = BTreeMap::new();
        if !factor.is_zero() && !radicand.is_zero() {
            terms.insert(radicand, factor);
        }
        Self { terms }
    }

    fn add_term(&mut self, radicand: BigUint, factor: BigRational) {
        use std::collections::btree_map::Entry;
        match self.terms.entry(radicand) {
            Entry::Vacant(entry) => {
                if !factor.is_zero() {
                    entry.insert(factor);
                }
            }
            Entry::Occupied(mut entry) => {
                *entry.get_mut() += factor;
                if entry.get().is_zero() {
                    entry.remove();
                }
            }
        }
    }

    /// Pairwise coprime numbers above 1 of which every radicand is a product.
    fn coprime_base(&self) -> Vec<BigUint> {
        let mut base: Vec<BigUint> = Vec::new();
        for radicand in self.terms.keys() {
            let mut pending = vec![radicand.clone()];
            while let Some(mut number) = pending.pop() {
                let mut index = 0;
                while index < base.len() && !number.is_one() {
                    let common = base[index].gcd(&number);
                    if !common.is_one() {
                        let rest = &base[index] / &common;
                        number /= &common;
                        base[index] = common;
                        if !rest.is_one() {
                            base.push(rest);
                        }
                    }
                    index += 1;
                }
                if !number.is_one() {
                    base.push(number);
                }
            }
        }
        base.sort();
        base
    }
}

/// `n = outside² · inside` with `inside` square-free; `None` if trial division up to the limit is not conclusive.
fn split_square(mut number: BigUint) -> Option<(BigUint, BigUint)> {
    let (mut outside, mut inside) = (BigUint::one(), BigUint::one());
    if number.is_zero() {
        return Some((outside, number));
    }
    let mut prime = 2_u32;
    // Beyond the cube root the rest is a prime, a product of two, or a square.
    let mut settled = false;
    while prime <= TRIAL_LIMIT {
        let cube = u128::from(prime).pow(3);
        settled = number.to_u64().is_some_and(|small| cube > u128::from(small));
        if settled {
            break;
        }
        let mut power = 0;
        while (&number % prime).is_zero() {
            number /= prime;
            power += 1;
        }
        outside *= BigUint::from(prime).pow(power / 2);
        inside *= BigUint::from(prime).pow(power % 2);
        prime += if prime == 2 { 1 } else { 2 };
    }
    let root = number.sqrt();
    if &root * &root == number {
        outside *= root;
    } else if settled {
        inside *= number;
    } else {
        return None;
    }
    Some((outside, inside))
}

impl From<i64> for Surd {
    fn from(value: i64) -> Self {
        Self::from(BigRational::from(BigInt::from(value)))
    }
}

impl From<BigRational> for Surd {
    fn from(value: BigRational) -> Self {
        Self::term(BigUint::one(), value)
    }
}

impl Add for &Surd {
    type Output = Surd;
    fn add(self, other: &Surd) -> Surd {
        let mut sum = self.clone();
        for (radicand, factor) in &other.terms {
            sum.add_term(radicand.clone(), factor.clone());
        }
        sum
    }
}

impl Sub for &Surd {
    type Output = Surd;
    fn sub(self, other: &Surd) -> Surd {
        self + &-other
    }
}

impl Neg for &Surd {
    type Output = Surd;
    fn neg(self) -> Surd {
        Surd { terms: self.terms.iter().map(|(radicand, factor)| (radicand.clone(), -factor)).collect() }
    }
}

impl Mul for &Surd {
    type Output = Surd;
    fn mul(self, other: &Surd) -> Surd {
        let mut product = Surd::zero();
        for (n, p) in &self.terms {
            for (m, q) in &other.terms {
                if n.is_one() || m.is_one() {
                    product.add_term(n * m, p * q);
                    continue;
                }
                // Rule `product-of-roots`: gcd·√(n/gcd · m/gcd), square-free again.
                let common = n.gcd(m);
                let rest = (n / &common) * (m / &common);
                product.add_term(rest, p * q * BigRational::from(BigInt::from(common)));
            }
        }
        product
    }
}

/// Rule `exact-sine`: sine and cosine of an angle in degrees, where both are surds, at multiples of 15°.
#[must_use]
pub fn exact_sin_cos(degrees: &BigRational) -> Option<(Surd, Surd)> {
    let steps = degrees / BigRational::from(BigInt::from(15));
    if !steps.is_integer() {
        return None;
    }
    let step = steps.to_integer().mod_floor(&BigInt::from(24)).to_i64()?;
    Some((sine_of_step(step), sine_of_step(step + 6)))
}

/// Sine of `step · 15°`.
fn sine_of_step(step: i64) -> Surd {
    let root =
        |n: i64, q: (i64, i64)| Surd::term(BigUint::from(n.unsigned_abs()), BigRational::new(q.0.into(), q.1.into()));
    let step = step.rem_euclid(24);
    if step > 12 {
        return -&sine_of_step(step - 12);
    }
    match step.min(12 - step) {
        0 => Surd::zero(),
        1 => &root(6, (1, 4)) - &root(2, (1, 4)),
        2 => Surd::ratio(1, 2),
        3 => root(2, (1, 2)),
        4 => root(3, (1, 2)),
        5 => &root(6, (1, 4)) + &root(2, (1, 4)),
        _ => Surd::one(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn root(n: i64) -> Surd {
        Surd::sqrt_of_rational(&BigRational::from(BigInt::from(n))).expect("not negative")
    }

    #[test]
    fn squares_come_out_of_a_root() {
        assert_eq!(root(72), &Surd::from(6) * &root(2));
        assert_eq!(root(49), Surd::from(7));
        let large_prime: i64 = 1_000_003;
        assert_eq!(root(large_prime * large_prime), Surd::from(large_prime));
    }

    #[test]
    fn a_radicand_beyond_reach_is_no_surd() {
        // (10^9 + 7)(10^9 + 9)² 2: the square is of a prime far above the limit.
        let (p, q) = (BigInt::from(1_000_000_007), BigInt::from(1_000_000_009));
        assert!(Surd::sqrt_of_rational(&BigRational::from(p * &q * &q * 2)).is_none());
        assert!(Surd::sqrt_of_rational(&BigRational::from(&q * &q)).is_some());
    }

    #[test]
    fn product_of_roots_uses_their_common_divisor() {
        assert_eq!(&root(6) * &root(10), &Surd::from(2) * &root(15));
        assert_eq!(&root(2) * &root(2), Surd::from(2));
    }

    #[test]
    fn inverse_of_a_sum_of_three_roots_multiplies_back_to_one() {
        let number = &(&Surd::ratio(1, 3) + &root(2)) + &(&root(15) - &root(6));
        let inverse = number.inverse().expect("not zero");
        assert!((&number * &inverse).is_one());
        assert!(Surd::zero().inverse().is_none());
    }

    #[test]
    fn sign_of_a_cancelling_sum_is_exact() {
        let near = &Surd::ratio(577, 408) - &root(2);
        assert_eq!(near.sign(), Ordering::Greater);
        assert_eq!((-&near).sign(), Ordering::Less);
        // (√2 + √3)² = 5 + 2√6: floats cannot distinguish the two.
        let sum = &root(2) + &root(3);
        let five = &(&Surd::from(5) + &(&Surd::from(2) * &root(6))) - &(&sum * &sum);
        assert_eq!(five.sign(), Ordering::Equal);
        let close = &(&root(2) + &root(3)) - &Surd::ratio(3_146_264_370, 1_000_000_000);
        assert_eq!(close.sign(), close.to_f64().partial_cmp(&0.0).expect("finite"));
    }

    #[test]
    fn sines_of_fifteen_degree_steps_agree_with_floats() {
        for step in -30..30 {
            let degrees = BigRational::from(BigInt::from(15 * step));
            let (sine, cosine) = exact_sin_cos(&degrees).expect("multiple of 15");
            let (s, c) = (15.0 * f64::from(step)).to_radians().sin_cos();
            assert!((sine.to_f64() - s).abs() < 1e-14, "{step}");
            assert!((cosine.to_f64() - c).abs() < 1e-14, "{step}");
            assert!((&(&sine * &sine) + &(&cosine * &cosine)).is_one());
        }
        assert!(exact_sin_cos(&BigRational::new(45.into(), 2.into())).is_none());
    }

    #[test]
    fn float_of_a_cancelling_sum_keeps_its_digits() {
        // 577/408 - √2 = 2.1239e-6: the difference of two floats keeps ten digits, the exact sum sixteen.
        let near = &Surd::ratio(577, 408) - &root(2);
        assert!((near.to_f64() / 2.123_901_414_755_121e-6 - 1.0).abs() < 1e-14);
    }
}
