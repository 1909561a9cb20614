//! Errors in units of the last place, from sums of two numbers; signs and ends of quadrants; one result alone or in a
//! pair.

use core::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};
use std::vec::Vec;

use super::*;

/// Sum of two numbers, the second below the last place of the first: some 106 bits.
#[derive(Debug, Clone, Copy)]
struct Double(f64, f64);

/// `π/2` to 159 bits, in three numbers.
const QUARTER_TURN: [f64; 3] = [FRAC_PI_2, 6.123_233_995_736_766e-17, -1.497_384_904_859_168_8e-33];

impl Double {
    fn of_sum(a: f64, b: f64) -> Self {
        let sum = a + b;
        let part = sum - a;
        Self(sum, (a - (sum - part)) + (b - part))
    }

    fn of_product(a: f64, b: f64) -> Self {
        let product = a * b;
        Self(product, a.mul_add(b, -product))
    }

    fn plus(self, other: Self) -> Self {
        let (high, low) = (Self::of_sum(self.0, other.0), Self::of_sum(self.1, other.1));
        let sum = Self::of_sum(high.0, high.1 + low.0);
        Self::of_sum(sum.0, sum.1 + low.1)
    }

    fn times(self, other: Self) -> Self {
        let product = Self::of_product(self.0, other.0);
        Self::of_sum(product.0, product.1 + (self.0 * other.1 + self.1 * other.0))
    }

    fn over(self, divisor: f64) -> Self {
        let quotient = self.0 / divisor;
        let rest = self.plus(Self::of_product(-quotient, divisor));
        Self::of_sum(quotient, rest.0 / divisor)
    }

    fn negated(self) -> Self {
        Self(-self.0, -self.1)
    }

    /// Sine and cosine, by their series after whole quarter turns are taken off.
    fn sin_cos(angle: f64) -> (Self, Self) {
        let quarters = (angle / FRAC_PI_2).round();
        let off = QUARTER_TURN.iter().fold(Self(angle, 0.0), |off, part| off.plus(Self::of_product(-quarters, *part)));
        let (mut sums, mut term) = ([Self(0.0, 0.0); 2], Self(1.0, 0.0));
        for power in 0..40_u8 {
            let signed = if power % 4 < 2 { term } else { term.negated() };
            sums[usize::from(power % 2)] = sums[usize::from(power % 2)].plus(signed);
            term = term.times(off).over(f64::from(power + 1));
        }
        let [cosine, sine] = sums;
        match (quarters as i64).rem_euclid(4) {
            0 => (sine, cosine),
            1 => (cosine, sine.negated()),
            2 => (sine.negated(), cosine.negated()),
            _ => (cosine.negated(), sine),
        }
    }
}

/// Difference in units of the last place of the value.
fn units_off(value: f64, exact: Double) -> f64 {
    let unit = f64::from_bits(exact.0.abs().to_bits() + 1) - exact.0.abs();
    ((value - exact.0) - exact.1).abs() / unit
}

/// Numbers between -1 and 1.
fn random() -> impl FnMut() -> f64 {
    let mut state = 7_u64;
    move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

/// Angles of machines, near multiples of a quarter turn, tiny ones, and any.
fn some_angles() -> Vec<f64> {
    let mut random = random();
    let mut list: Vec<f64> = (-40..40).flat_map(|step| [f64::from(step) * FRAC_PI_2, f64::from(step) * 0.1]).collect();
    for round in 0..20_000 {
        let near = (20.0 * random()).round() * FRAC_PI_2 * (1.0 + random() * 0.5_f64.powi(round % 50));
        list.extend([4.0 * random(), 1000.0 * random(), random() * 0.5_f64.powi(round % 60), near]);
    }
    list
}

#[test]
fn sines_and_cosines_are_within_one_unit_of_the_last_place() {
    let mut most = 0.0_f64;
    for angle in some_angles() {
        let ((sine, cosine), exact) = (sin_cos(angle), Double::sin_cos(angle));
        let off = [units_off(sine, exact.0), units_off(cosine, exact.1)];
        assert!(off.iter().all(|off| *off < 0.85), "{angle}: {off:?}");
        most = most.max(off[0]).max(off[1]);
    }
    assert!(most > 0.6, "the measure sees errors: {most}");
}

#[test]
fn arc_tangents_are_within_one_unit_of_the_last_place() {
    let (mut random, mut most) = (random(), 0.0_f64);
    for round in 0..40_000 {
        let (a, b) = (random(), random());
        let near = 0.5_f64.powi(round % 60);
        for (y, x) in
            [(a, b), (a * near, b), (a, b * near), (a, a * (1.0 + b * near)), (0.414_213_56 * a, a + near * b)]
        {
            let angle = atan2(y, x);
            // The angle that is missing, from the cross product of both directions.
            let (sine, cosine) = Double::sin_cos(angle);
            let across = cosine.times(Double(y, 0.0)).plus(sine.times(Double(-x, 0.0)));
            let missing = across.0 / f64::hypot(x, y);
            let off = units_off(angle, Double::of_sum(angle, missing));
            assert!(off < 0.9, "atan2({y}, {x}): {off}");
            most = most.max(off);
        }
    }
    assert!(most > 0.6, "the measure sees errors: {most}");
}

#[test]
fn quadrants_end_where_ieee_754_has_their_ends() {
    let special = [0.0, -0.0, 1.0, -1.0, 1e-310, -1e-310, 1e305, -1e305, f64::INFINITY, f64::NEG_INFINITY];
    for y in special {
        for x in special {
            assert_eq!(atan2(y, x).to_bits(), libm::atan2(y, x).to_bits(), "atan2({y}, {x})");
        }
        assert!(atan2(y, f64::NAN).is_nan() && atan2(f64::NAN, y).is_nan());
    }
    for (angle, expected) in [(0.0, (0.0, 1.0)), (-0.0, (-0.0, 1.0)), (1e300, libm::sincos(1e300))] {
        assert_eq!(sin_cos(angle), expected);
    }
    assert!(sin_cos(-0.0).0.is_sign_negative());
    assert!(sin_cos(f64::INFINITY).0.is_nan() && sin_cos(f64::NAN).1.is_nan());
    let half_turns = [angle(-0.0, -1.0), angle(0.0, -1.0), angle(-1e-17, -1.0)].map(f64::to_bits);
    assert_eq!((half_turns, atan2(1.0, 1.0).to_bits()), ([PI.to_bits(); 3], FRAC_PI_4.to_bits()));
}

#[test]
fn a_result_does_not_depend_on_the_one_beside_it() {
    let list = some_angles();
    let others = [0.0, f64::NAN, 1e20, FRAC_PI_2, -0.7];
    for (index, &angle) in list.iter().enumerate() {
        let other = others[index % others.len()];
        let bits = |(sine, cosine): (f64, f64)| (sine.to_bits(), cosine.to_bits());
        let alone = bits(sin_cos(angle));
        assert_eq!([bits(turns([angle, other])[0]), bits(turns([other, angle, angle])[2])], [alone; 2], "{angle}");
        let turn = (angle, list[(7 * index) % list.len()]);
        let alone = super::angle(turn.0, turn.1).to_bits();
        let beside = |other: f64| angles([turn, (other, other)])[0].to_bits();
        assert_eq!([beside(other), beside(0.0), angles([(1.0, 2.0), turn])[1].to_bits()], [alone; 3], "{turn:?}");
    }
}

#[test]
fn the_bits_are_the_same_on_every_system() {
    let mut digest = 0xCBF2_9CE4_8422_2325_u64;
    let mut add = |value: f64| digest = (digest ^ value.to_bits()).wrapping_mul(0x0100_0000_01B3);
    for angle in some_angles() {
        let (sine, cosine) = sin_cos(angle);
        [sine, cosine, atan2(sine, angle), asin(sine)].into_iter().for_each(&mut add);
    }
    assert_eq!(digest, 9_918_279_111_622_414_005);
}
