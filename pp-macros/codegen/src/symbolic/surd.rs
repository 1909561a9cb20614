//! Exact numbers: sums of square roots of square-free numbers with rational factors.
//!
//! `q1·√n1 + q2·√n2 + ...` is closed under `+ - * /`, and holds every direction with rational components after
//! normalisation and every rotation by a multiple of 15°. Rationals are of any size: random directions overflow any
//! fixed width.
//!
//! Radicands are made square-free by trial division up to [`TRIAL_LIMIT`] and a test for perfect squares. Where that is
//! not conclusive (a radicand above the cube of the limit) no surd is returned, and the caller takes an algebraic
//! symbol with the root's square as its relation.

use std::borrow::Cow;
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
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Surd(Coefficient);

/// Square-free radicands with their factors.
type Terms = BTreeMap<BigUint, BigRational>;

/// Most coefficients are small whole numbers, whose arithmetic needs no memory.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
enum Coefficient {
    Whole(i64),
    /// Any other number: never a whole one of this size.
    Sum(Terms),
}

impl Default for Surd {
    fn default() -> Self {
        Self(Coefficient::Whole(0))
    }
}

impl Ord for Surd {
    /// Order of the sums, term by term.
    fn cmp(&self, other: &Self) -> Ordering {
        match (&self.0, &other.0) {
            // The empty sum comes first.
            (Coefficient::Whole(a), Coefficient::Whole(b)) => (*a != 0, a).cmp(&(*b != 0, b)),
            _ => self.sum().cmp(&other.sum()),
        }
    }
}

impl PartialOrd for Surd {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
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
        match &self.0 {
            Coefficient::Whole(whole) => Some(BigRational::from(BigInt::from(*whole))),
            Coefficient::Sum(terms) if terms.len() == 1 => terms.get(&BigUint::one()).cloned(),
            Coefficient::Sum(_) => None,
        }
    }

    /// Square-free radicands with their factors, smallest radicand first.
    pub fn terms(&self) -> impl Iterator<Item = (BigUint, BigRational)> + use<> {
        self.sum().into_owned().into_iter()
    }

    /// True for the empty sum.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.0 == Coefficient::Whole(0)
    }

    /// True for exactly 1.
    #[must_use]
    pub fn is_one(&self) -> bool {
        self.0 == Coefficient::Whole(1)
    }

    /// The number as a sum.
    fn sum(&self) -> Cow<'_, Terms> {
        match &self.0 {
            Coefficient::Whole(0) => Cow::Owned(Terms::new()),
            Coefficient::Whole(whole) => {
                Cow::Owned(Terms::from([(BigUint::one(), BigRational::from(BigInt::from(*whole)))]))
            }
            Coefficient::Sum(terms) => Cow::Borrowed(terms),
        }
    }

    /// The number that is a sum.
    fn of(terms: Terms) -> Self {
        let whole = match terms.len() {
            0 => Some(0),
            1 => terms
                .get(&BigUint::one())
                .filter(|factor| factor.is_integer())
                .and_then(|factor| factor.numer().to_i64()),
            _ => None,
        };
        Self(whole.map_or(Coefficient::Sum(terms), Coefficient::Whole))
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
        let (mut a, mut c) = (Terms::new(), Terms::new());
        for (radicand, factor) in &*self.sum() {
            let (quotient, remainder) = radicand.div_rem(&base);
            if remainder.is_zero() {
                c.insert(quotient, factor.clone());
            } else {
                a.insert(radicand.clone(), factor.clone());
            }
        }
        Some((Self::of(a), base, Self::of(c)))
    }

    /// Nearest float.
    #[must_use]
    pub fn to_f64(&self) -> f64 {
        let mut sum = BigRational::zero();
        let scale = BigInt::one() << FLOAT_DIGITS;
        for (radicand, factor) in &*self.sum() {
            let root = (radicand << (2 * FLOAT_DIGITS)).sqrt();
            sum += factor * BigRational::new(root.into(), scale.clone());
        }
        sum.to_f64().unwrap_or(f64::NAN)
    }

    fn term(radicand: BigUint, factor: BigRational) -> Self {
        let mut terms = Terms::new();
        if !factor.is_zero() && !radicand.is_zero() {
            terms.insert(radicand, factor);
        }
        Self::of(terms)
    }

    /// Pairwise coprime numbers above 1 of which every radicand is a product.
    fn coprime_base(&self) -> Vec<BigUint> {
        let mut base: Vec<BigUint> = Vec::new();
        for radicand in self.sum().keys() {
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

fn add_term(terms: &mut Terms, radicand: BigUint, factor: BigRational) {
    use std::collections::btree_map::Entry;
    match terms.entry(radicand) {
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
        Self(Coefficient::Whole(value))
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
        if let (Coefficient::Whole(a), Coefficient::Whole(b)) = (&self.0, &other.0)
            && let Some(sum) = a.checked_add(*b)
        {
            return Surd(Coefficient::Whole(sum));
        }
        let mut sum = self.sum().into_owned();
        for (radicand, factor) in &*other.sum() {
            add_term(&mut sum, radicand.clone(), factor.clone());
        }
        Surd::of(sum)
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
        if let Coefficient::Whole(whole) = &self.0
            && let Some(negative) = whole.checked_neg()
        {
            return Surd(Coefficient::Whole(negative));
        }
        Surd::of(self.sum().iter().map(|(radicand, factor)| (radicand.clone(), -factor)).collect())
    }
}

impl Mul for &Surd {
    type Output = Surd;
    fn mul(self, other: &Surd) -> Surd {
        if let (Coefficient::Whole(a), Coefficient::Whole(b)) = (&self.0, &other.0)
            && let Some(product) = a.checked_mul(*b)
        {
            return Surd(Coefficient::Whole(product));
        }
        let mut product = Terms::new();
        for (n, p) in &*self.sum() {
            for (m, q) in &*other.sum() {
                if n.is_one() || m.is_one() {
                    add_term(&mut product, n * m, p * q);
                    continue;
                }
                // Rule `product-of-roots`: gcd·√(n/gcd · m/gcd), square-free again.
                let common = n.gcd(m);
                let rest = (n / &common) * (m / &common);
                add_term(&mut product, rest, p * q * BigRational::from(BigInt::from(common)));
            }
        }
        Surd::of(product)
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
    fn whole_numbers_of_any_size_are_one_number_however_they_arise() {
        let (largest, one) = (Surd::from(i64::MAX), Surd::one());
        let beyond = &largest + &one;
        assert_eq!(&beyond - &one, largest);
        assert_eq!(&-&Surd::from(i64::MIN) - &one, largest);
        assert_eq!(&(&largest * &largest) * &largest.inverse().expect("not zero"), largest);
        assert_eq!(&Surd::ratio(1, 2) + &Surd::ratio(3, 2), Surd::from(2));
        assert!((&root(2) - &root(2)).is_zero() && (&Surd::ratio(1, 3) * &Surd::from(3)).is_one());
        // The order is that of the sums: the empty one first, whatever the others hold.
        let mut all = [beyond, Surd::from(-3), root(2), Surd::zero(), Surd::ratio(1, 2), largest, one];
        let mut sums = all.each_ref().map(|number| number.sum().into_owned());
        all.sort();
        sums.sort();
        assert_eq!(all.map(|number| number.sum().into_owned()), sums);
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
