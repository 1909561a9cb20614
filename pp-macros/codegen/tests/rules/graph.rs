//! Rules of the expression graph.

use super::*;

mod fold_numbers {
    use super::*;

    proptest! {
        #[test]
        fn keeps_the_value(a in -99_i64..99, b in -99_i64..99, d in 1_i64..99) {
            let mut graph = Graph::default();
            let (x, y) = (a as f64 / d as f64, b as f64);
            let first = graph.constant(Poly::from(Surd::ratio(a, d)));
            let second = graph.integer(b);
            let mut folded = vec![
                (graph.add(first, second), x + y),
                (graph.sub(first, second), x - y),
                (graph.mul(first, second), x * y),
                (graph.neg(first), -x),
            ];
            if b != 0 {
                folded.push((graph.div(first, second), x / y));
            }
            if a >= 0 {
                folded.push((graph.sqrt(first), x.sqrt()));
            }
            for (node, expected) in folded {
                prop_assert!(graph.constant_of(node).is_some());
                assert_close(evaluate(&graph, node, &[]), expected);
            }
        }
    }

    #[test]
    fn does_not_divide_by_zero_nor_take_the_root_of_a_negative_number() {
        let mut graph = Graph::default();
        let [zero, one, minus] = [0, 1, -1].map(|number| graph.integer(number));
        for node in [graph.div(one, zero), graph.div(zero, zero), graph.sqrt(minus)] {
            assert!(graph.constant_of(node).is_none());
            assert!(!evaluate(&graph, node, &[]).is_finite());
        }
        let quotient = graph.div(zero, zero);
        let mut reader = Interpreter::new(&mut graph, BTreeMap::new());
        let quotient = reader.value(quotient);
        assert!(!reader.equal(&quotient, &quotient), "nothing is proven by dividing by zero");
    }
}

mod neutral {
    use super::*;

    proptest! {
        #[test]
        fn keeps_the_value(x in -9.0..9.0) {
            let mut graph = Graph::default();
            let [(symbol, a)] = inputs(&mut graph, ["x"]);
            let (zero, one) = (graph.integer(0), graph.integer(1));
            let same = [graph.add(a, zero), graph.add(zero, a), graph.sub(a, zero), graph.mul(one, a), graph.div(a, one)];
            prop_assert_eq!(same, [a; 5]);
            let none = [graph.mul(zero, a), graph.div(zero, a)];
            prop_assert_eq!(none, [zero; 2]);
            let minus = graph.sub(zero, a);
            assert_close(evaluate(&graph, minus, &[(symbol, x)]), -x);
        }
    }

    #[test]
    fn does_not_take_nearly_one_for_one_nor_drop_a_division_by_zero() {
        let mut graph = Graph::default();
        let [(_, a)] = inputs(&mut graph, ["x"]);
        let nearly = graph.constant(Poly::from(&Surd::one() + &Surd::ratio(1, i64::MAX)));
        let tiny = graph.constant(Poly::from(Surd::ratio(1, i64::MAX)));
        let zero = graph.integer(0);
        assert_ne!(graph.mul(nearly, a), a);
        assert_ne!(graph.add(a, tiny), a);
        assert_ne!(graph.mul(tiny, a), zero);
        assert_ne!(graph.div(zero, zero), zero);
    }
}

mod cancel {
    use super::*;

    proptest! {
        #[test]
        fn keeps_the_value(x in -9.0..9.0, y in -9.0..9.0) {
            let mut graph = Graph::default();
            let [(p, a), (q, b)] = inputs(&mut graph, ["x", "y"]);
            let (left, right) = (graph.mul(a, b), graph.mul(b, a));
            let nothing = graph.sub(left, right);
            prop_assert!(graph.is_zero(nothing));
            let minus = graph.neg(left);
            let sum = graph.add(minus, right);
            prop_assert!(graph.is_zero(sum));
            assert_close(evaluate(&graph, left, &[(p, x), (q, y)]), x * y);
        }
    }

    #[test]
    fn does_not_apply_to_quotients_nor_to_what_is_only_equal() {
        let mut graph = Graph::default();
        let [(_, a), (_, b)] = inputs(&mut graph, ["x", "y"]);
        // x/x is not 1 at x = 0, and √(x²) is not x.
        let quotient = graph.div(a, a);
        assert!(graph.constant_of(quotient).is_none());
        let square = graph.square(a);
        assert_ne!(graph.sqrt(square), a);
        // Normal forms prove equality; the code keeps the formula as it was written.
        let sum = graph.add(a, b);
        let squared_sum = graph.square(sum);
        let twice = graph.mul(a, b);
        let gap = graph.sub(squared_sum, twice);
        assert!(!graph.is_zero(gap));
    }
}

mod signs_outwards {
    use super::*;

    proptest! {
        #[test]
        fn keeps_the_value(x in -9.0_f64..9.0, y in 0.1_f64..9.0) {
            let mut graph = Graph::default();
            let [(p, a), (q, b)] = inputs(&mut graph, ["x", "y"]);
            let (minus_a, minus_b) = (graph.neg(a), graph.neg(b));
            let two = graph.integer(-2);
            let nodes = [
                (graph.neg(minus_a), x),
                (graph.add(minus_a, minus_b), -x - y),
                (graph.add(a, minus_b), x - y),
                (graph.add(minus_a, b), y - x),
                (graph.sub(minus_a, b), -x - y),
                (graph.sub(a, minus_b), x + y),
                (graph.mul(minus_a, b), -x * y),
                (graph.mul(minus_a, minus_b), x * y),
                (graph.div(a, minus_b), -x / y),
                (graph.add(a, two), x - 2.0),
                (graph.sub(a, two), x + 2.0),
                (graph.mul(a, two), -2.0 * x),
            ];
            for (node, expected) in nodes {
                assert_close(evaluate(&graph, node, &[(p, x), (q, y)]), expected);
            }
            let difference = graph.sub(a, b);
            prop_assert_eq!(graph.neg(difference), graph.sub(b, a));
            let product = graph.mul(a, b);
            prop_assert_eq!(graph.mul(minus_a, b), graph.neg(product));
        }
    }

    #[test]
    fn does_not_move_out_of_a_root_nor_change_what_has_no_sign() {
        let mut graph = Graph::default();
        let [(_, a), (_, b)] = inputs(&mut graph, ["x", "y"]);
        let minus = graph.neg(a);
        let (root, of_minus) = (graph.sqrt(a), graph.sqrt(minus));
        assert_ne!(of_minus, graph.neg(root));
        assert_ne!(graph.sub(a, b), graph.sub(b, a));
        let two = graph.integer(2);
        assert_ne!(graph.add(a, two), graph.sub(a, two));
    }
}

mod merge_factors {
    use super::*;

    proptest! {
        #[test]
        fn keeps_the_value(p in -9_i64..9, q in 1_i64..9, x in -9.0..9.0) {
            let mut graph = Graph::default();
            let [(symbol, a)] = inputs(&mut graph, ["x"]);
            let (first, second) = (graph.integer(p), graph.constant(Poly::from(Surd::ratio(1, q))));
            let inner = graph.mul(second, a);
            let both = graph.mul(first, inner);
            assert_close(evaluate(&graph, both, &[(symbol, x)]), p as f64 / q as f64 * x);
            let at_once = graph.constant(Poly::from(Surd::ratio(p, q)));
            prop_assert_eq!(both, graph.mul(at_once, a));
        }
    }

    #[test]
    fn does_not_reach_into_sums_nor_take_an_unknown_for_a_number() {
        let mut graph = Graph::default();
        let [(_, a), (_, b)] = inputs(&mut graph, ["x", "y"]);
        let two = graph.integer(2);
        let sum = graph.add(a, b);
        let parts = [graph.mul(two, a), graph.mul(two, b)];
        assert_ne!(graph.mul(two, sum), graph.add(parts[0], parts[1]));
        let inner = graph.mul(a, b);
        let (left, product) = (graph.mul(a, inner), graph.square(a));
        assert_ne!(left, graph.mul(product, b));
    }
}
