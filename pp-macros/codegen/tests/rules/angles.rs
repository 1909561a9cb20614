//! Rules of the sine and the cosine.

use super::*;

mod exact_sine {
    use super::*;
    use pp_codegen::symbolic::exact_sin_cos;

    proptest! {
        #[test]
        fn agrees_with_the_float_or_does_not_apply(numerator in -4000_i64..4000, denominator in 1_i64..4) {
            let angle = degrees(numerator, denominator);
            let float = numerator as f64 / denominator as f64;
            match exact_sin_cos(&angle) {
                None => prop_assert!(numerator % (15 * denominator) != 0),
                Some((sine, cosine)) => {
                    assert_close(sine.to_f64(), float.to_radians().sin());
                    assert_close(cosine.to_f64(), float.to_radians().cos());
                }
            }
        }
    }

    #[test]
    fn does_not_apply_near_a_multiple_of_fifteen_degrees() {
        assert_eq!(exact_sin_cos(&degrees(45, 2)), None);
        assert_eq!(exact_sin_cos(&degrees(30_000_000_001, 1_000_000_000)), None);
    }
}

mod quarter_turn {
    use super::*;
    use pp_codegen::symbolic::sin_cos_of_degrees;

    proptest! {
        #[test]
        fn keeps_the_value_and_shares_the_constants(tenths in -9000_i64..9000, quarters in -9_i64..9) {
            let mut ring = Ring::default();
            let (angle, turned) = (degrees(tenths, 10), degrees(tenths + quarters * 900, 10));
            let complement = degrees(900 - tenths, 10);
            let (sine, cosine) = sin_cos_of_degrees(&angle, &mut ring);
            let float = (tenths as f64 / 10.0).to_radians();
            assert_close(value(&ring, &sine, &[]), float.sin());
            assert_close(value(&ring, &cosine, &[]), float.cos());
            prop_assert_eq!(sin_cos_of_degrees(&complement, &mut ring), (cosine.clone(), sine.clone()));
            let expected = match quarters.rem_euclid(4) {
                0 => (sine, cosine),
                1 => (cosine, -&sine),
                2 => (-&sine, -&cosine),
                _ => (-&cosine, sine),
            };
            prop_assert_eq!(sin_cos_of_degrees(&turned, &mut ring), expected);
        }
    }

    #[test]
    fn does_not_join_angles_that_differ() {
        let mut ring = Ring::default();
        let (sine, cosine) = sin_cos_of_degrees(&degrees(10, 1), &mut ring);
        let other = sin_cos_of_degrees(&degrees(11, 1), &mut ring);
        assert!(sine != other.0 && cosine != other.1);
        // Nor if they are the same float.
        let near = &degrees(10, 1) + &BigRational::new(1.into(), num_bigint::BigInt::from(10).pow(40));
        assert_ne!(sin_cos_of_degrees(&near, &mut ring).0, sine);
    }
}

mod angle_sum {
    use super::*;
    use pp_codegen::symbolic::angle_sum;

    proptest! {
        #[test]
        fn keeps_the_value(a in -7.0..7.0, b in -7.0..7.0) {
            let mut ring = Ring::default();
            let ((s, c), (t, d)) = (ring.sin_cos("s", "c"), ring.sin_cos("t", "d"));
            let poly = |(sine, cosine): (Symbol, Symbol)| (Poly::from(sine), Poly::from(cosine));
            let (sine, cosine) = angle_sum(&poly((s, c)), &poly((t, d)), &ring);
            let values = [(s, f64::sin(a)), (c, f64::cos(a)), (t, f64::sin(b)), (d, f64::cos(b))];
            assert_close(value(&ring, &sine, &values), f64::sin(a + b));
            assert_close(value(&ring, &cosine, &values), f64::cos(a + b));
            let square = &ring.mul(&sine, &sine) + &ring.mul(&cosine, &cosine);
            prop_assert!(square.is_one());
        }
    }

    #[test]
    fn does_not_make_a_circle_of_a_pair_that_is_none() {
        let mut ring = Ring::default();
        let (s, _) = ring.sin_cos("s", "c");
        let (_, d) = ring.sin_cos("t", "d");
        let mixed = (Poly::from(s), Poly::from(d));
        let (sine, cosine) = angle_sum(&mixed, &mixed, &ring);
        let square = &ring.mul(&sine, &sine) + &ring.mul(&cosine, &cosine);
        assert!(!ring.is_zero(&(&square - &Poly::one())));
    }
}
