//! Formulas for reading: equal to their polynomial, and in the form in which people write them.

use std::collections::BTreeMap;

use pp_codegen::check::check;
use pp_codegen::formula::Formula;
use pp_codegen::model::{Model, Quantity};
use pp_codegen::report::Errors;
use pp_codegen::symbolic::{Poly, Ring, Surd, Symbol};
use pp_codegen::syntax::parse;
use proptest::prelude::*;

fn model(text: &str) -> Model {
    let tokens = format!("pub struct M; {text}").parse().expect("Rust tokens");
    let mut errors = Errors::default();
    let declaration = parse(tokens, &mut errors).expect("syntax");
    check(&declaration, &mut errors).expect("rules").model
}

const SPINNER: &str = "chain: C B | X Y Z; d = (0, 0, d); dims = { d: 150.0 };";
const DMU: &str = "chain: C B | X Y Z; axes = { B: Rx(-45 deg) * Y }; d = (0, 0, d); dims = { d: 150.0 };";
const ALPHA: &str = "chain: C B | X Y Z; axes = { B: Rx(alpha) * Y }; dims = { alpha: -45 deg };";
const LOLA: &str = "chain: X | Y Z B A;";
const SKEW: &str =
    "chain: C B | X Y Z; axes = { B: Rx(-33 deg) * Y, X: (3, 1, 2) }; d = (1.5, 0, d); dims = { d: 150.0 };";

/// Rows of the product of all joints, and of its inverse.
fn entries(text: &str) -> (Model, Vec<Poly>) {
    let model = model(text);
    let product = model.product();
    let undone = model.product_of((0..model.axes.len()).rev().map(|axis| model.joint_inverse(axis)));
    let entries = product.0.into_iter().chain(undone.0).flatten().collect();
    (model, entries)
}

/// Values of symbols, and of their names in formulas.
fn point(model: &Model, values: &[f64]) -> (BTreeMap<Symbol, f64>, BTreeMap<String, f64>) {
    let (mut symbols, mut names) = (BTreeMap::new(), BTreeMap::new());
    let mut values = values.iter().copied().cycle();
    let mut next = || values.next().expect("endless");
    let named = &model.symbols;
    let given = [(named.tip, ["x", "y", "z"]), (named.part, ["part_x", "part_y", "part_z"])];
    for (symbol, name) in given.into_iter().flat_map(|(symbols, names)| symbols.into_iter().zip(names)) {
        let value = next();
        symbols.insert(symbol, value);
        names.insert(name.to_string(), value);
    }
    let axis = [next(), next(), next() + 2.0];
    let length = axis.iter().map(|part| part * part).sum::<f64>().sqrt();
    for ((symbol, name), part) in named.axis.into_iter().zip(["i", "j", "k"]).zip(axis) {
        symbols.insert(symbol, part / length);
        names.insert(name.to_string(), part / length);
    }
    let gauge = next();
    symbols.insert(named.gauge, gauge);
    names.insert("gauge".into(), gauge);
    let axes = model.axes.iter().map(|axis| (axis.letter.to_string(), Some(axis.word), Some(axis.sin_cos)));
    let dimensions = model.dimensions.iter().map(|dimension| match dimension.quantity {
        Quantity::Length(symbol) => (dimension.name.clone(), Some(symbol), None),
        Quantity::Angle(sine, cosine) => (dimension.name.clone(), None, Some((sine, cosine))),
    });
    for (name, length, turn) in axes.chain(dimensions) {
        let value = next();
        symbols.extend(length.map(|symbol| (symbol, value)));
        symbols.extend(turn.into_iter().flat_map(|(sine, cosine)| [(sine, value.sin()), (cosine, value.cos())]));
        names.insert(name, value);
    }
    (symbols, names)
}

fn agrees(model: &Model, ring: &Ring, poly: &Poly, values: &[f64]) -> Result<(), TestCaseError> {
    let (symbols, names) = point(model, values);
    let formula = Formula::of_poly(model, ring, poly);
    let expected = ring.evaluate(poly, &|symbol| symbols.get(&symbol).copied()).expect("all symbols");
    let found = formula.value(&|name| names.get(name).copied()).expect("all names");
    prop_assert!(
        (expected - found).abs() < 1e-9 * (1.0 + expected.abs()),
        "{} = {found}, not {expected}",
        formula.text()
    );
    Ok(())
}

proptest! {
    #[test]
    fn a_formula_has_the_value_of_its_polynomial(values in prop::collection::vec(-3.0..3.0_f64, 21)) {
        for text in [SPINNER, DMU, ALPHA, LOLA, SKEW] {
            let (model, entries) = entries(text);
            for poly in &entries {
                agrees(&model, &model.ring, poly, &values)?;
            }
        }
    }

    #[test]
    fn so_has_that_of_any_polynomial(
        terms in prop::collection::vec((prop::collection::vec(0..16_usize, 0..5), -4..5_i64, 1..4_i64, 1..4_i64), 0..9),
        values in prop::collection::vec(-3.0..3.0_f64, 21),
    ) {
        let model = model(ALPHA);
        let axes = [model.axes[0].sin_cos, model.axes[1].sin_cos];
        let Quantity::Angle(sine, cosine) = model.dimensions[0].quantity else { unreachable!("alpha is an angle") };
        let named = &model.symbols;
        let mut symbols: Vec<Symbol> = named.tip.into_iter().chain(named.axis).chain(named.part).collect();
        symbols.extend(axes.into_iter().flat_map(|(sine, cosine)| [sine, cosine]));
        symbols.extend([sine, cosine, named.gauge]);
        let mut sum = Poly::zero();
        for (factors, above, below, radicand) in terms {
            let number = &Surd::ratio(above, below) * &Surd::from(radicand).sqrt().expect("a root");
            let product = factors.into_iter().fold(Poly::from(number), |product, index| {
                model.ring.mul(&product, &Poly::from(symbols[index % symbols.len()]))
            });
            sum = &sum + &product;
        }
        agrees(&model, &model.ring, &sum, &values)?;
    }
}

/// A polynomial in the names of the declaration.
fn written(model: &Model, poly: &Poly) -> String {
    Formula::of_poly(model, &model.ring, poly).text()
}

/// The linear axes after both table axes: the tip in the frame of the bed, part origin zero.
fn tip_on_bed(text: &str) -> (Model, [Poly; 3]) {
    let model = model(text);
    let tip: [Poly; 3] = model.symbols.tip.map(Poly::from);
    let undone = model.product_of((0..2).rev().map(|axis| model.joint_inverse(axis)));
    let turned = undone.rotate(&tip, &model.ring);
    let none = model.symbols.part.into_iter().map(|symbol| (symbol, Poly::zero())).collect();
    let origin = undone.origin();
    let sums = std::array::from_fn(|row| model.ring.substitute(&(&turned[row] + &origin[row]), &none));
    (model, sums)
}

#[test]
fn the_spinner_reads_as_in_its_paper() {
    let (model, tip) = tip_on_bed(SPINNER);
    assert_eq!(
        tip.each_ref().map(|poly| written(&model, poly)),
        [
            "(x cos C + y sin C) cos B - (z - d) sin B",
            "-x sin C + y cos C",
            "(x cos C + y sin C) sin B + (z - d) cos B + d",
        ]
    );
    let formula = Formula::of_poly(&model, &model.ring, &tip[0]);
    assert_eq!(formula.source(), "(x * cos(C) + y * sin(C)) * cos(B) - (z - d) * sin(B)");
    assert_eq!(formula.latex(), r"(x\cos C + y\sin C)\cos B - (z - d)\sin B");
}

#[test]
fn an_inclined_table_reads_as_in_its_paper() {
    let (model, tip) = tip_on_bed(DMU);
    assert_eq!(
        tip.each_ref().map(|poly| written(&model, poly)),
        [
            "(√2/2) (x sin C - y cos C - z + d) sin B + (x cos C + y sin C) cos B",
            "(√2/2) (x cos C + y sin C) sin B - (1/2) (x sin C - y cos C) (1 + cos B) - (1/2) (z - d) (1 - cos B)",
            "(√2/2) (x cos C + y sin C) sin B + (1/2) (x sin C - y cos C + d) (1 - cos B) + (1/2) z (1 + cos B)",
        ]
    );
    let model = self::model(ALPHA);
    let axis = model.product().rotate(&model.tool_axis, &model.ring);
    assert_eq!(
        axis.each_ref().map(|poly| written(&model, poly)),
        [
            "(sin B cos C - (1 - cos B) sin C sin alpha) cos alpha",
            "(sin B sin C + (1 - cos B) sin alpha cos C) cos alpha",
            "cos B cos² alpha + sin² alpha",
        ]
    );
    let k = Formula::of_poly(&model, &model.ring, &axis[2]);
    assert_eq!(k.source(), "cos(B) * cos(alpha)^2 + sin(alpha)^2");
    assert_eq!(k.latex(), r"\cos B\cos^{2} \alpha + \sin^{2} \alpha");
}

#[test]
fn a_factor_that_one_term_lacks_stays_inside() {
    let model = model("chain: C B | X Y Z;");
    let [x, y, z] = model.symbols.tip.map(Poly::from);
    let (s, c) = model.axes[1].sin_cos;
    let (s, c) = (Poly::from(s), Poly::from(c));
    let times = |a: &Poly, b: &Poly| model.ring.mul(a, b);
    let half = Surd::ratio(1, 2);
    for (poly, expected) in [
        (&times(&x, &c) + &y, "x cos B + y"),
        (&times(&x, &c) + &times(&y, &c), "(x + y) cos B"),
        // Not (1 - cos B): y has no counterpart.
        (&(&x - &times(&x, &c)) + &times(&y, &c), "x - (x - y) cos B"),
        (&(&x - &times(&x, &c)) + &y, "x (1 - cos B) + y"),
        (&x + &Poly::from(Surd::ratio(3, 2)), "x + 1.5"),
        (&x.scaled(&half) + &y.scaled(&half), "(x + y)/2"),
        (&x.scaled(&half) + &y.scaled(&Surd::from(2).sqrt().expect("a root")), "x/2 + √2 y"),
        // 1 - cos² is sin², 1 + cos² is not.
        (&Poly::one() - &times(&c, &c), "sin² B"),
        (&Poly::one() + &times(&c, &c), "2 - sin² B"),
        (times(&times(&s, &s), &z), "z sin² B"),
        (Poly::zero(), "0"),
    ] {
        assert_eq!(written(&model, &poly), expected);
    }
}

#[test]
fn numbers_are_exact_and_long_ones_are_rounded_for_people() {
    let root = |n: i64| Surd::from(n).sqrt().expect("a root");
    let long = &Surd::ratio(123_456_789_012, 987_654_321_013) * &root(2);
    for (number, text, source, latex) in [
        (Surd::ratio(1, 2), "1/2", "1/2", r"\frac{1}{2}"),
        (Surd::ratio(-121, 2), "-60.5", "-60.5", "-60.5"),
        (&root(2) * &Surd::ratio(1, 2), "√2/2", "sqrt(2)/2", r"\frac{\sqrt{2}}{2}"),
        (
            &(&root(6) - &root(2)) * &Surd::ratio(1, 4),
            "(-√2 + √6)/4",
            "(-sqrt(2) + sqrt(6)) / 4",
            r"\frac{-\sqrt{2} + \sqrt{6}}{4}",
        ),
        (&root(3) * &Surd::from(-2), "-2√3", "-2*sqrt(3)", r"-2\sqrt{3}"),
        (long, "0.176776694", "123456789012*sqrt(2)/987654321013", "0.176776694"),
    ] {
        let formula = Formula::Number(number);
        assert_eq!((&*formula.text(), &*formula.source(), &*formula.latex()), (text, source, latex));
    }
}

#[test]
fn brackets_are_written_where_they_are_needed() {
    let name = |name: &str| Formula::name(name);
    let sum = Formula::Sum(vec![name("x"), name("y").negated()]);
    let cosine = Formula::call("cos", [name("B")]);
    for (formula, text, source, latex) in [
        (
            Formula::Product(vec![cosine.clone(), sum.clone()]),
            "cos B · (x - y)",
            "cos(B) * (x - y)",
            r"\cos B\cdot (x - y)",
        ),
        (Formula::Power(Box::new(sum.clone()), 2), "(x - y)²", "(x - y)^2", "(x - y)^{2}"),
        (Formula::Power(Box::new(cosine.clone()), 2), "cos² B", "cos(B)^2", r"\cos^{2} B"),
        (
            Formula::Quotient(Box::new(cosine), Box::new(sum.clone())),
            "(cos B)/(x - y)",
            "cos(B)/(x - y)",
            r"\frac{\cos B}{x - y}",
        ),
        (sum.clone().negated(), "-(x - y)", "-(x - y)", "-(x - y)"),
        (
            Formula::call("atan2", [name("j"), Formula::call("sqrt", [sum])]),
            "atan2(j, √(x - y))",
            "atan2(j, sqrt(x - y))",
            r"\operatorname{atan2}(j,\allowbreak \sqrt{x - y})",
        ),
        (
            Formula::call("sin", [Formula::Degrees(num_rational::BigRational::from_integer(33.into()))]),
            "sin 33°",
            "sin(33 deg)",
            r"\sin 33^{\circ}",
        ),
        (
            Formula::Product(vec![name("beta_max"), name("L_t"), name("gauge")]),
            "beta_max L_t gauge",
            "beta_max * L_t * gauge",
            r"\beta_{\mathit{max}}\,L_{t}\,\mathit{gauge}",
        ),
    ] {
        assert_eq!((&*formula.text(), &*formula.source(), &*formula.latex()), (text, source, latex));
    }
}
