//! Rules of the normal form: circles, unit vectors, roots and divisors.

use super::*;

mod circle {
    use super::*;

    proptest! {
        #[test]
        fn keeps_the_value(angle in -4.0_f64..4.0, m in 0_u32..6, n in 0_u32..6) {
            let mut ring = Ring::default();
            let (s, c) = ring.sin_cos("s", "c");
            let product = ring.mul(&power(&ring, &Poly::from(s), m), &power(&ring, &Poly::from(c), n));
            prop_assert!(product.degree(c) <= 1);
            let expected = angle.sin().powi(m.cast_signed()) * angle.cos().powi(n.cast_signed());
            assert_close(value(&ring, &product, &[(s, angle.sin()), (c, angle.cos())]), expected);
        }
    }

    #[test]
    fn does_not_join_the_sine_of_one_angle_and_the_cosine_of_another() {
        let mut ring = Ring::default();
        let (s, _) = ring.sin_cos("s", "c");
        let (_, other) = ring.sin_cos("sin", "cos");
        let sum = &power(&ring, &Poly::from(s), 2) + &power(&ring, &Poly::from(other), 2);
        assert!(!ring.is_zero(&(&sum - &Poly::one())));
    }
}

mod unit_vector {
    use super::*;

    proptest! {
        #[test]
        fn keeps_the_value(v in prop::array::uniform3(0.1_f64..1.0), powers in prop::array::uniform3(0_u32..5)) {
            let mut ring = Ring::default();
            let axis = ring.unit_vector(["i", "j", "k"]);
            let length = v.iter().map(|part| part * part).sum::<f64>().sqrt();
            let v = v.map(|part| part / length);
            let (mut product, mut expected) = (Poly::one(), 1.0);
            for index in 0..3 {
                product = ring.mul(&product, &power(&ring, &Poly::from(axis[index]), powers[index]));
                expected *= v[index].powi(powers[index].cast_signed());
            }
            prop_assert!(product.degree(axis[2]) <= 1);
            assert_close(value(&ring, &product, &std::array::from_fn::<_, 3, _>(|index| (axis[index], v[index]))), expected);
        }
    }

    #[test]
    fn does_not_touch_the_third_component_of_another_vector() {
        let mut ring = Ring::default();
        let [i, j, _] = ring.unit_vector(["i", "j", "k"]);
        let [.., other] = ring.unit_vector(["u", "v", "w"]);
        let sum = [i, j, other].iter().fold(Poly::zero(), |sum, part| &sum + &power(&ring, &Poly::from(*part), 2));
        assert!(!ring.is_zero(&(&sum - &Poly::one())));
    }

    #[test]
    fn does_not_give_two_components_the_length_one() {
        let mut ring = Ring::default();
        let [i, j, _] = ring.unit_vector(["i", "j", "k"]);
        let sum = &power(&ring, &Poly::from(i), 2) + &power(&ring, &Poly::from(j), 2);
        assert!(!ring.is_zero(&(&sum - &Poly::one())));
    }
}

mod root {
    use super::*;

    proptest! {
        #[test]
        fn keeps_the_value(x in 0.0_f64..9.0, y in -2.0_f64..2.0, exponent in 0_u32..7) {
            let mut ring = Ring::default();
            let (a, b) = (ring.symbol("x"), ring.symbol("y"));
            // √(x + y² + 1)
            let radicand = &(&Poly::from(a) + &power(&ring, &Poly::from(b), 2)) + &Poly::one();
            let r = ring.root("r", radicand);
            let product = power(&ring, &Poly::from(r), exponent);
            prop_assert!(product.degree(r) <= 1);
            let expected = (x + y * y + 1.0_f64).sqrt();
            let values = [(a, x), (b, y), (r, expected)];
            assert_close(value(&ring, &product, &values), expected.powi(exponent.cast_signed()));
        }
    }

    #[test]
    fn does_not_decide_the_sign() {
        let mut ring = Ring::default();
        let x = Poly::from(ring.symbol("x"));
        let square = ring.mul(&x, &x);
        let r = Poly::from(ring.root("r", square));
        assert!(!ring.is_zero(&(&r - &x)));
        assert!(!ring.is_zero(&(&r + &x)));
    }

    #[test]
    fn does_not_touch_a_root_of_something_else() {
        let mut ring = Ring::default();
        let (x, y) = (Poly::from(ring.symbol("x")), Poly::from(ring.symbol("y")));
        let r = Poly::from(ring.root("r", x.clone()));
        let q = Poly::from(ring.root("q", y));
        assert!(!ring.is_zero(&(&ring.mul(&r, &q) - &x)));
    }
}

mod one_root {
    use super::*;

    proptest! {
        #[test]
        fn has_the_value_of_the_root(n in 0_i64..1000, d in 1_i64..1000) {
            let mut ring = Ring::default();
            let radicand = Poly::from(&Surd::ratio(n, d) + &super::root(2));
            let first = ring.root("r", radicand.clone());
            prop_assert_eq!(first, ring.root("again", radicand));
            assert_close(value(&ring, &Poly::from(first), &[]), (n as f64 / d as f64 + 2.0_f64.sqrt()).sqrt());
        }
    }

    #[test]
    fn does_not_join_roots_of_different_numbers_or_of_unknowns() {
        let mut ring = Ring::default();
        let number = |n: i64| Poly::from(&Surd::from(n) + &super::root(2));
        assert_ne!(ring.root("r", number(3)), ring.root("r", number(4)));
        // Of an unknown the two roots may be meant with opposite signs.
        let x = Poly::from(ring.symbol("x"));
        let (r, q) = (Poly::from(ring.root("r", x.clone())), Poly::from(ring.root("q", x)));
        assert!(!ring.is_zero(&(&r - &q)));
    }
}

mod clear {
    use super::*;

    proptest! {
        #[test]
        fn decides_what_is_true_and_what_is_not(a in 1_i64..50, b in 1_i64..50, x in 0.1..9.0, y in 0.1..9.0) {
            // a/x + b/y = (a y + b x)/(x y)
            let mut ring = Ring::default();
            let symbols = [ring.symbol("x"), ring.symbol("y")];
            let [p, q] = symbols.map(Poly::from);
            let reciprocals = [("u", p.clone()), ("v", q.clone()), ("w", ring.mul(&p, &q))]
                .map(|(name, divisor)| ring.reciprocal(name, divisor));
            let [u, v, w] = reciprocals.map(Poly::from);
            let (a, b) = (Surd::from(a), Surd::from(b));
            let left = &u.scaled(&a) + &v.scaled(&b);
            let right = ring.mul(&(&q.scaled(&a) + &p.scaled(&b)), &w);
            let wrong = ring.mul(&(&q.scaled(&a) - &p.scaled(&b)), &w);
            let values: Vec<(Symbol, f64)> =
                symbols.into_iter().chain(reciprocals).zip([x, y, 1.0 / x, 1.0 / y, 1.0 / (x * y)]).collect();
            assert_close(value(&ring, &left, &values), value(&ring, &right, &values));
            prop_assert!(ring.is_zero(&(&left - &right)));
            prop_assert!(!ring.is_zero(&(&left - &wrong)));
        }
    }

    #[test]
    fn does_not_prove_anything_from_a_divisor_that_vanishes() {
        // d = 1/(x+1) · (x+1) - 1 is zero without looking like it.
        let mut graph = Graph::default();
        let [(_, x)] = inputs(&mut graph, ["x"]);
        let one = graph.integer(1);
        let sum = graph.add(x, one);
        let inverse = graph.div(one, sum);
        let product = graph.mul(inverse, sum);
        let nothing = graph.sub(product, one);
        let quotient = graph.div(nothing, nothing);
        let mut reader = Interpreter::new(&mut graph, BTreeMap::new());
        let quotient = reader.value(quotient);
        assert!(!reader.equal(&quotient, &Poly::one()));
        assert!(!reader.equal(&Poly::one(), &Poly::one()));
    }
}

mod claimed_root {
    use super::*;

    proptest! {
        #[test]
        fn has_the_value_of_the_root(x in 0.0..9.0, y in 0.0..9.0) {
            let (mut graph, root, [(a, _), (b, _)]) = root_of_the_square_of_a_sum();
            let expected = evaluate(&graph, root, &[(a, x), (b, y)]);
            let mut reader = Interpreter::new(&mut graph, BTreeMap::new());
            let sum = &Poly::from(a) + &Poly::from(b);
            prop_assert!(reader.claim(root, &sum));
            let found = reader.value(root);
            assert_close(value(graph.ring(), &found, &[(a, x), (b, y)]), expected);
        }
    }

    #[test]
    fn does_not_take_what_has_another_square() {
        let (mut graph, root, [(a, _), (b, _)]) = root_of_the_square_of_a_sum();
        let mut reader = Interpreter::new(&mut graph, BTreeMap::new());
        let difference = &Poly::from(a) - &Poly::from(b);
        assert!(!reader.claim(root, &difference));
        assert_ne!(reader.value(root), difference);
    }

    fn root_of_the_square_of_a_sum() -> (Graph, Id, [(Symbol, Id); 2]) {
        let mut graph = Graph::default();
        let [x, y] = inputs(&mut graph, ["x", "y"]);
        let sum = graph.add(x.1, y.1);
        let square = graph.square(sum);
        let root = graph.sqrt(square);
        (graph, root, [x, y])
    }
}
