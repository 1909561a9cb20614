//! Every rewrite rule of the symbolic engine: true for random values, and not applied where its condition does not
//! hold.
//!
//! A module for each rule of the table in `symbolic`. Values are made with floats, independently of the rule.

use std::collections::BTreeMap;

use num_rational::BigRational;
use pp_codegen::symbolic::{Graph, Id, Interpreter, Poly, Ring, Surd, Symbol};
use proptest::prelude::*;

#[test]
fn every_rule_of_the_table_has_its_tests() {
    let rules: Vec<String> = include_str!("../src/symbolic/mod.rs")
        .lines()
        .filter_map(|line| line.strip_prefix("//! | `")?.split_once('`'))
        .map(|(rule, _)| rule.replace('-', "_"))
        .collect();
    let tests: Vec<&str> =
        include_str!("rules.rs").lines().filter_map(|line| line.strip_prefix("mod ")?.strip_suffix(" {")).collect();
    assert_eq!(rules, tests);
}

/// The value of `poly` in floats.
fn value(ring: &Ring, poly: &Poly, of: &[(Symbol, f64)]) -> f64 {
    let of: BTreeMap<Symbol, f64> = of.iter().copied().collect();
    ring.evaluate(poly, &|symbol| of.get(&symbol).copied()).expect("every symbol has a value")
}

#[track_caller]
fn assert_close(a: f64, b: f64) {
    assert!((a - b).abs() <= 1e-9 * (1.0 + a.abs().max(b.abs())), "{a} is not {b}");
}

fn power(ring: &Ring, base: &Poly, exponent: u32) -> Poly {
    (0..exponent).fold(Poly::one(), |product, _| ring.mul(&product, base))
}

fn degrees(numerator: i64, denominator: i64) -> BigRational {
    BigRational::new(numerator.into(), denominator.into())
}

fn root(number: i64) -> Surd {
    Surd::from(number).sqrt().expect("a small number")
}

/// Inputs named after the letters.
fn inputs<const N: usize>(graph: &mut Graph, names: [&str; N]) -> [(Symbol, Id); N] {
    names.map(|name| {
        let symbol = graph.symbol(name);
        (symbol, graph.input(symbol))
    })
}

fn evaluate(graph: &Graph, id: Id, of: &[(Symbol, f64)]) -> f64 {
    let of: BTreeMap<Symbol, f64> = of.iter().copied().collect();
    graph.evaluate(id, &|symbol| of.get(&symbol).copied())
}

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
