//! The general table of My et al.: five rotary orders in three groups, proven from declarations with general offsets.
//!
//! The equations are composed here from 3×3 matrices of expressions as text: an independent form of the table that
//! shares only the language with the engine. The paper measures `q` from the centre; in the zero position of this
//! product the linear axes are the coordinates of the tip, so `q - f` replaces the paper's `q` (`q + f` where both
//! rotaries carry the tool).

use pp_codegen::compile;

/// A vector of expressions.
type Vector = [String; 3];
/// A matrix of expressions, by rows.
type Matrix = [Vector; 3];

fn vector(components: [&str; 3]) -> Vector {
    components.map(String::from)
}

fn neg(a: &str) -> String {
    if a == "0" { a.into() } else { format!("(-{a})") }
}

fn add(a: &str, b: &str) -> String {
    match (a, b) {
        ("0", other) | (other, "0") => other.into(),
        _ => format!("({a} + {b})"),
    }
}

fn mul(a: &str, b: &str) -> String {
    match (a, b) {
        ("0", _) | (_, "0") => "0".into(),
        ("1", other) | (other, "1") => other.into(),
        _ => format!("{a} * {b}"),
    }
}

fn sum(a: &Vector, b: &Vector) -> Vector {
    std::array::from_fn(|n| add(&a[n], &b[n]))
}

fn minus(a: &Vector) -> Vector {
    std::array::from_fn(|n| neg(&a[n]))
}

fn apply(matrix: &Matrix, a: &Vector) -> Vector {
    std::array::from_fn(|row| (0..3).fold("0".into(), |total: String, n| add(&total, &mul(&matrix[row][n], &a[n]))))
}

fn transpose(matrix: &Matrix) -> Matrix {
    std::array::from_fn(|row| std::array::from_fn(|column| matrix[column][row].clone()))
}

fn times(a: &Matrix, b: &Matrix) -> Matrix {
    let columns = transpose(b).map(|column| apply(a, &column));
    transpose(&columns)
}

/// `Rot` about the coordinate direction of a rotary letter, by the named angle.
fn rotation(letter: char, angle: &str) -> Matrix {
    let (s, c) = (format!("sin({angle})"), format!("cos({angle})"));
    let m = neg(&s);
    match letter {
        'A' => [["1", "0", "0"], ["0", &c, &m], ["0", &s, &c]],
        'B' => [[&c, "0", &s], ["0", "1", "0"], [&m, "0", &c]],
        _ => [[&c, &m, "0"], [&s, &c, "0"], ["0", "0", "1"]],
    }
    .map(vector)
}

/// A row of the table: two rotary axes from the workpiece on, their formulas and the conditions for these.
struct Order {
    rotaries: [char; 2],
    inclined: bool,
    formulas: [(&'static str, &'static str); 2],
    /// A formula with one wrong sign, and the help text of its refusal.
    slip: (&'static str, &'static str),
}

const ORDERS: [Order; 5] = [
    Order {
        rotaries: ['A', 'B'],
        inclined: false,
        formulas: [
            ("A = atan2(-j, k)", "cos B > 0 (the first branch)"),
            ("B = asin(i)", "cos B >= 0 (the first branch)"),
        ],
        slip: ("A = atan2(j, k)", "write `-j` in place of `j`"),
    },
    Order {
        rotaries: ['B', 'A'],
        inclined: false,
        formulas: [
            ("A = asin(-j)", "cos A >= 0 (the first branch)"),
            ("B = atan2(i, k)", "cos A > 0 (the first branch)"),
        ],
        slip: ("A = asin(j)", "write `-j` in place of `j`"),
    },
    Order {
        rotaries: ['C', 'A'],
        inclined: false,
        formulas: [
            ("C = atan2(i, -j)", "sin A > 0 (the first branch)"),
            ("A = acos(k)", "sin A >= 0 (the first branch)"),
        ],
        slip: ("C = atan2(-i, -j)", "write `i` in place of `-i`"),
    },
    Order {
        rotaries: ['C', 'B'],
        inclined: false,
        formulas: [
            ("C = atan2(j, i)", "sin B > 0 (the first branch)"),
            ("B = acos(k)", "sin B >= 0 (the first branch)"),
        ],
        slip: ("C = atan2(-j, i)", "write `j` in place of `-j`"),
    },
    Order {
        rotaries: ['C', 'B'],
        inclined: true,
        formulas: [
            // (7), then (6), for the paper's own R_alpha.
            (
                "C = atan2(cos(alpha) * sin(B) * j - sin(alpha) * cos(alpha) * (1 - cos(B)) * i, \
                 cos(alpha) * sin(B) * i + sin(alpha) * cos(alpha) * (1 - cos(B)) * j)",
                "(1 - cos B) cos alpha · (2 - (1 - cos B) cos² alpha) != 0",
            ),
            ("B = acos((k - sin(alpha)^2) / cos(alpha)^2)", "sin B >= 0 (the first branch), cos alpha != 0"),
        ],
        slip: ("B = acos((k + sin(alpha)^2) / cos(alpha)^2)", "write `- sin(alpha)^2` in place of `+ sin(alpha)^2`"),
    },
];

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Group {
    /// RRTTT: both rotaries carry the workpiece.
    Table,
    /// TTTRR: both carry the tool.
    Head,
    /// RTTTR: one carries the workpiece, one the tool.
    Each,
}

const GROUPS: [Group; 3] = [Group::Table, Group::Head, Group::Each];

/// A machine of the table.
struct Machine<'a> {
    order: &'a Order,
    group: Group,
    /// Whether both centre lines pass through one point.
    one_centre: bool,
}

impl Machine<'_> {
    fn all() -> impl Iterator<Item = Machine<'static>> {
        let groups = GROUPS.into_iter().flat_map(|group| [(group, true), (group, false)]);
        // One point cannot be measured from the table and from the spindle.
        let groups = groups.filter(|(group, one_centre)| !(*group == Group::Each && *one_centre));
        groups.flat_map(|(group, one_centre)| ORDERS.iter().map(move |order| Machine { order, group, one_centre }))
    }

    fn name(&self) -> String {
        let [u, v] = self.order.rotaries;
        format!("{u}-{v} inclined: {}, {:?}, one centre: {}", self.order.inclined, self.group, self.one_centre)
    }

    fn declaration(&self) -> String {
        let [u, v] = self.order.rotaries;
        let chain = match self.group {
            Group::Table => format!("{u} {v} | X Y Z"),
            Group::Head => format!("| X Y Z {u} {v}"),
            Group::Each => format!("{u} | X Y Z {v}"),
        };
        let offsets =
            if self.one_centre { "(f1, f2, f3)".into() } else { format!("{{ {u}: (f1, f2, f3), {v}: (g1, g2, g3) }}") };
        let second = if self.one_centre { "" } else { "g1: 3, g2: 0.25, g3: -60.5," };
        let (direction, angle) = if self.order.inclined {
            (format!("axes = {{ {v}: Rx(alpha) * Y }};"), "alpha: -45 deg")
        } else {
            Default::default()
        };
        format!(
            "pub struct M; chain: {chain}; d = {offsets}; {direction}
             dims = {{ f1: 1.5, f2: -2, f3: 150, {second} {angle} }};"
        )
    }

    fn rotations(&self) -> [Matrix; 2] {
        let [u, v] = self.order.rotaries;
        let [ru, rv] = [u, v].map(|letter| rotation(letter, &letter.to_string()));
        if self.order.inclined {
            // (10): R_alpha rotates the axis of B into its direction.
            let tilt = rotation('A', "alpha");
            (ru, times(&times(&tilt, &rv), &transpose(&tilt))).into()
        } else {
            [ru, rv]
        }
    }

    /// Centres of both rotaries in the coordinates of the tip: `d - part` in the table, `d + gauge` in the head.
    fn centres(&self) -> [Vector; 2] {
        let first = vector(["f1", "f2", "f3"]);
        let second = if self.one_centre { first.clone() } else { vector(["g1", "g2", "g3"]) };
        let part = vector(["(-part_x)", "(-part_y)", "(-part_z)"]);
        let gauge = vector(["0", "0", "gauge"]);
        match self.group {
            Group::Table => [sum(&first, &part), sum(&second, &part)],
            Group::Head => [sum(&first, &gauge), sum(&second, &gauge)],
            Group::Each => [sum(&first, &part), sum(&second, &gauge)],
        }
    }

    /// `p` from the axes, and `q` from `p` and the rotary axes.
    fn position(&self) -> [Vector; 2] {
        let [ru, rv] = self.rotations();
        let [ru_t, rv_t] = [&ru, &rv].map(transpose);
        let [f, g] = self.centres();
        let (p, q) = (vector(["x", "y", "z"]), vector(["X", "Y", "Z"]));
        let from = |point: &Vector, origin: &Vector| sum(point, &minus(origin));
        match (self.group, self.one_centre) {
            // p = Ru Rv q + f, q = Rvᵀ Ruᵀ (p - f)
            (Group::Table, true) => {
                [sum(&apply(&times(&ru, &rv), &from(&q, &f)), &f), sum(&apply(&rv_t, &apply(&ru_t, &from(&p, &f))), &f)]
            }
            // The first axis carries the second centre.
            (Group::Table, false) => [
                sum(&apply(&ru, &sum(&apply(&rv, &from(&q, &g)), &from(&g, &f))), &f),
                sum(&apply(&rv_t, &from(&apply(&ru_t, &from(&p, &f)), &from(&g, &f))), &g),
            ],
            // p = Ru Rv d + q, q = p - Ru Rv d, with d from the centre to the tip.
            (Group::Head, true) => {
                let reach = apply(&times(&ru, &rv), &minus(&f));
                [sum(&reach, &sum(&q, &f)), from(&from(&p, &reach), &f)]
            }
            (Group::Head, false) => {
                let reach = apply(&ru, &sum(&apply(&rv, &minus(&g)), &from(&g, &f)));
                [sum(&reach, &sum(&q, &f)), from(&from(&p, &reach), &f)]
            }
            // p = Ru (Rv d + q) + f, q = Ruᵀ (p - f) - Rv d
            (Group::Each, _) => {
                let reach = apply(&rv, &minus(&g));
                let between = from(&g, &f);
                [
                    sum(&apply(&ru, &sum(&reach, &sum(&q, &between))), &f),
                    from(&from(&apply(&ru_t, &from(&p, &f)), &reach), &between),
                ]
            }
        }
    }

    /// All equations with the conditions under which they hold.
    fn equations(&self) -> Vec<(String, String)> {
        let [ru, rv] = self.rotations();
        let axis = apply(&ru, &apply(&rv, &vector(["0", "0", "1"])));
        let [p, q] = self.position();
        let mut equations = Vec::new();
        for (names, sides) in [(["i", "j", "k"], axis), (["x", "y", "z"], p), (["X", "Y", "Z"], q)] {
            let everywhere =
                names.into_iter().zip(sides).map(|(name, side)| (format!("{name} = {side}"), String::new()));
            equations.extend(everywhere);
        }
        equations.extend(self.order.formulas.map(|(formula, holds)| (formula.to_string(), holds.to_string())));
        equations
    }

    fn verify(&self, equations: &[&str]) -> Result<Vec<String>, Vec<String>> {
        let block: String = equations.iter().map(|equation| format!("{equation};\n")).collect();
        let text = format!("{} verify \"My et al., general table\" {{ {block} }}", self.declaration());
        match compile(text.parse().expect("tokens")) {
            Ok(machine) => {
                let proven = machine.verified[0].equations.iter();
                Ok(proven.map(|equation| equation.holds.join(", ")).collect())
            }
            Err(refused) => Err(refused.0.iter().map(ToString::to_string).collect()),
        }
    }
}

#[test]
fn the_general_table_is_proven_in_all_orders_and_groups() {
    let mut machines = 0;
    for machine in Machine::all() {
        let equations = machine.equations();
        let texts: Vec<&str> = equations.iter().map(|(text, _)| text.as_str()).collect();
        let expected: Vec<String> = equations.iter().map(|(_, holds)| holds.clone()).collect();
        let found =
            machine.verify(&texts).unwrap_or_else(|messages| panic!("{}: {}", machine.name(), messages.join("\n")));
        assert_eq!(found, expected, "{}", machine.name());
        machines += 1;
    }
    assert_eq!(machines, 25);
}

#[test]
fn one_wrong_sign_in_a_rotary_formula_is_refused_and_named() {
    for machine in Machine::all() {
        let (slip, help) = machine.order.slip;
        let messages = machine.verify(&[slip]).expect_err(slip);
        assert_eq!(messages.len(), 1, "{}", machine.name());
        // Or the declaration is wrong, where one change of it makes the equation follow.
        let (text, remedy) = messages[0].split_once("help: ").expect("a help");
        assert!(text.contains("does not follow from "), "{}: {}", machine.name(), messages[0]);
        let remedy = remedy.rsplit("if the declaration is right: ").next().expect("a remedy");
        assert_eq!(remedy, help, "{}: {}", machine.name(), messages[0]);
    }
}

#[test]
fn a_wrong_sign_anywhere_in_a_position_is_refused() {
    let mut slips = 0;
    for machine in Machine::all().filter(|machine| !machine.order.inclined) {
        for (equation, _) in machine.equations() {
            let (left, right) = equation.split_once(" = ").expect("an equation");
            if !"xyzXYZ".contains(left) {
                continue;
            }
            for (place, _) in right.match_indices("(-sin(") {
                let slip = format!("{left} = {}({}", &right[..place], &right[place + 2..]);
                let messages = machine.verify(&[&slip]).expect_err(&slip);
                assert_eq!(messages.len(), 1, "{slip}");
                let help = messages[0].split("help: ").nth(1).expect("a help");
                let remedy = help.rsplit("if the declaration is right: ").next().expect("a remedy");
                assert!(remedy.starts_with("write `") && remedy.contains("in place of"), "{slip}: {help}");
                slips += 1;
            }
        }
    }
    assert!(slips > 100, "{slips}");
}
