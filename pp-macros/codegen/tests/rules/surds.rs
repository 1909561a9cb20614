//! Rules of numbers with square roots.

use super::*;

mod square_out_of_root {
    use super::*;

    proptest! {
        #[test]
        fn keeps_the_value(a in 0_i64..3000, b in 1_i64..3000, d in 1_i64..3000) {
            let number = Surd::from(degrees(a * a * b, d));
            let root = number.sqrt().expect("its square-free part is small");
            assert_close(root.to_f64(), ((a * a * b) as f64 / d as f64).sqrt());
            prop_assert_eq!(&root * &root, number);
        }
    }

    #[test]
    fn does_not_apply_to_a_negative_number_nor_to_a_sum_of_roots() {
        assert_eq!(Surd::from(-4).sqrt(), None);
        assert_eq!((&Surd::one() + &super::root(2)).sqrt(), None);
    }

    #[test]
    fn does_not_apply_where_the_square_free_part_is_not_found() {
        let (p, q) = (1_000_000_007_i64, 1_000_000_009_i64);
        let number = [p, q, q].iter().fold(Surd::from(2), |product, factor| &product * &Surd::from(*factor));
        assert_eq!(number.sqrt(), None);
    }
}

mod product_of_roots {
    use super::*;

    proptest! {
        #[test]
        fn keeps_the_value(n in 0_i64..5000, m in 0_i64..5000) {
            let product = &super::root(n) * &super::root(m);
            assert_close(product.to_f64(), (n as f64).sqrt() * (m as f64).sqrt());
            prop_assert_eq!(product, super::root(n * m));
        }
    }

    #[test]
    fn does_not_put_a_sum_under_one_root() {
        assert_ne!(&super::root(2) + &super::root(3), super::root(5));
        assert_ne!(&super::root(2) * &super::root(3), super::root(5));
    }
}

mod conjugate {
    use super::*;

    proptest! {
        #[test]
        fn multiplies_back_to_one(parts in prop::collection::vec((-9_i64..9, 1_i64..9, 1_i64..40), 1..4)) {
            let terms = parts.iter().map(|&(q, d, n)| (&Surd::ratio(q, d) * &super::root(n), q as f64 / d as f64 * (n as f64).sqrt()));
            let (mut number, mut float) = (Surd::zero(), 0.0);
            for (term, value) in terms {
                number = &number + &term;
                float += value;
            }
            match number.inverse() {
                None => prop_assert!(float.abs() < 1e-9),
                Some(inverse) => {
                    prop_assert!((&number * &inverse).is_one());
                    assert_close(inverse.to_f64() * float, 1.0);
                }
            }
        }
    }

    #[test]
    fn does_not_apply_to_zero_however_it_is_written() {
        assert_eq!((&super::root(8) - &(&Surd::from(2) * &super::root(2))).inverse(), None);
    }
}
