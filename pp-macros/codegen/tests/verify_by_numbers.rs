//! Verdicts against numbers: an accepted equation is true wherever its printed conditions hold and false or undefined
//! elsewhere; a refused one is true at no pose. No code is shared with the engine: texts are parsed and evaluated in
//! floating point, and the pose comes from a product of rotations written out here.

use std::collections::BTreeMap;

use pp_codegen::compile;

type Values = BTreeMap<String, f64>;

/// Reads and evaluates both the language of the macro and the printed form (`sin² B cos C`, `√(1 - k²)`).
struct Reader<'t> {
    rest: &'t str,
    values: &'t Values,
}

fn evaluate(text: &str, values: &Values) -> f64 {
    let mut reader = Reader { rest: text, values };
    let value = reader.sum();
    assert!(reader.rest.trim().is_empty(), "`{}` is left of `{text}`", reader.rest);
    value
}

impl Reader<'_> {
    fn eat(&mut self, token: &str) -> bool {
        let rest = self.rest.trim_start();
        rest.strip_prefix(token).map(|rest| self.rest = rest).is_some()
    }

    fn peek(&self) -> char {
        self.rest.trim_start().chars().next().unwrap_or('\0')
    }

    fn sum(&mut self) -> f64 {
        let mut sum = self.product();
        loop {
            if self.eat("+") {
                sum += self.product();
            } else if self.eat("-") {
                sum -= self.product();
            } else {
                return sum;
            }
        }
    }

    fn product(&mut self) -> f64 {
        if self.eat("-") {
            return -self.product();
        }
        let mut product = self.power();
        loop {
            let next = self.peek();
            if self.eat("*") || self.eat("·") {
                product *= self.signed();
            } else if self.eat("/") {
                product /= self.signed();
            } else if next.is_alphanumeric() || next == '(' || next == '√' {
                product *= self.power();
            } else {
                return product;
            }
        }
    }

    fn signed(&mut self) -> f64 {
        if self.eat("-") { -self.signed() } else { self.power() }
    }

    fn exponent(&mut self) -> Option<i32> {
        const DIGITS: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹";
        if self.eat("^") {
            return self.number().parse().ok();
        }
        let digit = |c: char| DIGITS.chars().position(|known| known == c);
        let digits: String = self.rest.chars().map_while(digit).map(|digit| digit.to_string()).collect();
        self.rest = self.rest.trim_start_matches(|c| digit(c).is_some());
        digits.parse().ok()
    }

    fn power(&mut self) -> f64 {
        let base = self.atom();
        self.exponent().map_or(base, |exponent| base.powi(exponent))
    }

    fn number(&mut self) -> String {
        let rest = self.rest.trim_start();
        let end = rest.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(rest.len());
        self.rest = &rest[end..];
        rest[..end].into()
    }

    fn atom(&mut self) -> f64 {
        if self.eat("(") {
            let inner = self.sum();
            assert!(self.eat(")"), "`)` is missing at `{}`", self.rest);
            return inner;
        }
        if self.eat("√") {
            return self.atom().sqrt();
        }
        if self.peek().is_ascii_digit() {
            let number: f64 = self.number().parse().expect("a number");
            return if self.eat("deg") || self.eat("°") { number.to_radians() } else { number };
        }
        let rest = self.rest.trim_start();
        let end = rest.find(|c: char| !c.is_ascii_alphanumeric() && c != '_').unwrap_or(rest.len());
        let name = &rest[..end];
        self.rest = &rest[end..];
        if !["sin", "cos", "asin", "acos", "atan2", "sqrt"].contains(&name) {
            return *self.values.get(name).unwrap_or_else(|| panic!("`{name}` at `{rest}` is unknown"));
        }
        let exponent = self.exponent().unwrap_or(1);
        let first = if self.peek() == '(' && name == "atan2" {
            self.eat("(");
            self.sum()
        } else {
            self.atom()
        };
        let value = match name {
            "sin" => first.sin(),
            "cos" => first.cos(),
            "asin" => first.asin(),
            "acos" => first.acos(),
            "sqrt" => first.sqrt(),
            _ => {
                assert!(self.eat(","));
                let second = self.sum();
                assert!(self.eat(")"));
                // Where both are zero there is no angle.
                if first.hypot(second) < 1e-12 { f64::NAN } else { first.atan2(second) }
            }
        };
        value.powi(exponent)
    }
}

/// Random numbers; the same in every run.
struct Random(u64);

impl Random {
    fn below(&mut self, end: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % end
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.below(1 << 30) as f64 / f64::from(1 << 30)
    }
}

struct Machine {
    declaration: &'static str,
    pose: fn(&mut Values),
    /// Equations that are true, on one branch at least.
    formulas: &'static [&'static str],
}

fn turned(values: &Values, letter: &str, [a, b]: [f64; 2]) -> [f64; 2] {
    let (s, c) = values[letter].sin_cos();
    [c * a - s * b, s * a + c * b]
}

fn insert(values: &mut Values, names: [&str; 3], vector: [f64; 3]) {
    values.extend(names.into_iter().map(String::from).zip(vector));
}

/// `C B | X Y Z` through (0, 0, d).
fn spinner(values: &mut Values) {
    let d = values["d"];
    for (names, [x, y, z], d) in
        [(["x", "y", "z"], [values["X"], values["Y"], values["Z"]], d), (["i", "j", "k"], [0.0, 0.0, 1.0], 0.0)]
    {
        let [z, x] = turned(values, "B", [z - d, x]);
        let [x, y] = turned(values, "C", [x, y]);
        insert(values, names, [x, y, z + d]);
    }
}

/// `X | Y Z B A`, the centre at the gauge line.
fn lola(values: &mut Values) {
    let gauge = values["gauge"];
    let [y, z] = turned(values, "A", [0.0, 1.0]);
    let [z, x] = turned(values, "B", [z, 0.0]);
    insert(values, ["i", "j", "k"], [x, y, z]);
    let tip = [values["X"] - gauge * x, values["Y"] - gauge * y, values["Z"] + gauge - gauge * z];
    insert(values, ["x", "y", "z"], tip);
}

const MACHINES: [Machine; 2] = [
    Machine {
        declaration: "chain: C B | X Y Z; d = (0, 0, d); dims = { d: 150 };",
        pose: spinner,
        formulas: &[
            "C = atan2(j, i)",
            "C = atan2(-j, -i)",
            "C = atan2(j * sin(B), i * sin(B))",
            "C = acos(i / sqrt(i^2 + j^2))",
            "C = -acos(i / sin(B))",
            "C = asin(j / sin(B))",
            "B = acos(k)",
            "B = -acos(k)",
            "B = atan2(sqrt(1 - k^2), k)",
            "B = atan2(-sqrt(i^2 + j^2), k)",
            "B = 2 * atan2(sqrt(1 - k), sqrt(1 + k))",
            "B = 2 * asin(sqrt((1 - k) / 2))",
            "2 * B = acos(2 * k^2 - 1)",
            "2 * C = atan2(2 * i * j, i^2 - j^2)",
            "C + B = atan2(j, i) + acos(k)",
            "B - C = acos(k) - atan2(j, i)",
            "asin(k) = 90 deg - acos(k)",
            "sin(B) = sqrt(1 - k^2)",
            "sqrt(i^2) = i",
            "sqrt(i) * sqrt(j) = sqrt(i * j)",
            "sqrt(sqrt(k^4)) = -k",
            "i + j = sqrt(1 - k^2) * (cos(C) + sin(C))",
            "0 = (sqrt(k^2) - k) * sqrt(i)",
            "k = sqrt(1 - i^2 - j^2)",
            "X = x * cos(B) * cos(C) + y * cos(B) * sin(C) - z * sin(B) + d * sin(B)",
            "Y = -x * sin(C) + y * cos(C)",
            "Y = (y * i - x * j) / sqrt(i^2 + j^2)",
            "Z = x * i + y * j + z * k - d * k + d",
        ],
    },
    Machine {
        declaration: "chain: X | Y Z B A;",
        pose: lola,
        formulas: &[
            "A = asin(-j)",
            "A = -asin(j)",
            "B = atan2(i, k)",
            "A = atan2(-j, sqrt(i^2 + k^2))",
            "A = 180 deg + asin(j)",
            "B = asin(i / cos(A))",
            "B = acos(k / sqrt(1 - j^2))",
            "X = x + gauge * i",
            "Y = y + gauge * j",
            "Z = z + gauge * k - gauge",
            "i^2 + k^2 = 1 - j^2",
        ],
    },
];

/// An equation in another form with the same meaning, or with a mistake.
fn variant(equation: &str, random: &mut Random) -> String {
    let (left, right) = equation.split_once(" = ").expect("an equation");
    let swap = |from: &str, to: &str| format!("{left} = {}", right.replacen(from, to, 1));
    match random.below(14) {
        0 => format!("{right} = {left}"),
        1 => format!("{left} + 0 = {right}"),
        2 => format!("{left} = -(-({right}))"),
        3 => format!("sin({left}) = sin({right})"),
        4 => format!("cos(2 * ({left})) = cos(2 * ({right}))"),
        5 => swap("sin(", "cos("),
        6 => swap("cos(", "sin("),
        7 => swap(" - ", " + "),
        8 => swap(" + ", " - "),
        9 => swap("i", "(i * k / k)"),
        10 => swap("k", "(-k)"),
        11 => swap("j", "(-j)"),
        12 => swap("sqrt(", "-sqrt("),
        _ => swap("acos(", "asin("),
    }
}

/// True if an equation is true at a point; angles modulo 360 degrees.
fn is_true(equation: &str, values: &Values) -> bool {
    let (left, right) = equation.split_once(" = ").expect("an equation");
    let gap = evaluate(left, values) - evaluate(right, values);
    // Two lengths never differ by a whole turn by chance.
    let turn = gap - std::f64::consts::TAU * (gap / std::f64::consts::TAU).round();
    turn.abs() < 2e-6
}

/// True if a printed condition holds; `None` within rounding.
fn holds(condition: &str, values: &Values) -> Option<bool> {
    let condition = condition.split(" (the ").next().unwrap_or(condition);
    let (operator, at) = [" >= 0", " <= 0", " != 0", " > 0", " < 0"]
        .into_iter()
        .find_map(|operator| Some((operator, condition.strip_suffix(operator)?)))
        .expect("a condition");
    let value = evaluate(at, values);
    let clear = value.abs() > 1e-3;
    match operator {
        " >= 0" | " > 0" => clear.then_some(value > 0.0),
        " <= 0" | " < 0" => clear.then_some(value < 0.0),
        _ => clear.then_some(true),
    }
}

/// The error in the verdict on an equation.
fn fault(machine: &Machine, equation: &str, random: &mut Random) -> Option<String> {
    let text = format!("pub struct M; {} verify \"here\" {{ {equation}; }}", machine.declaration);
    let verdict = compile(text.parse().expect("tokens"));
    let verdict = match &verdict {
        Ok(compiled) => Ok(&compiled.verified[0].equations[0].holds),
        // Not decided: an angle compared with a number, or a division by zero.
        Err(refused) => {
            let message = refused.0[0].to_string();
            let decided =
                ["does not follow", "at no pose", "at every pose\n"].iter().any(|text| message.contains(text));
            if !decided {
                return None;
            }
            Err(message)
        }
    };
    let mut true_points = 0;
    for _ in 0..60 {
        let mut values = Values::new();
        for letter in ["A", "B", "C"] {
            values.insert(letter.into(), random.between(-3.1, 3.1));
        }
        for length in ["X", "Y", "Z"] {
            values.insert(length.into(), random.between(-2.0, 2.0));
        }
        values.insert("d".into(), 150.0);
        // Set-up symbols that are not mentioned are zero.
        let gauge = if equation.contains("gauge") { random.between(0.5, 2.0) } else { 0.0 };
        values.insert("gauge".into(), gauge);
        (machine.pose)(&mut values);
        let found = is_true(equation, &values);
        match &verdict {
            Err(message) => {
                // One may be a coincidence of rounding.
                true_points += usize::from(found);
                if true_points == 3 {
                    return Some(format!("`{equation}` is true at {values:?}, but refused: {message}"));
                }
            }
            Ok(conditions) => {
                let all: Vec<Option<bool>> = conditions.iter().map(|condition| holds(condition, &values)).collect();
                if all.contains(&Some(false)) && found && !all.contains(&None) {
                    return Some(format!("`{equation}` is true outside of {conditions:?}, at {values:?}"));
                }
                if all.iter().all(|known| *known == Some(true)) && !found {
                    return Some(format!("`{equation}` is false within {conditions:?}, at {values:?}"));
                }
            }
        }
    }
    None
}

#[test]
fn verdicts_agree_with_numbers() {
    let mut random = Random(7);
    let mut faults = Vec::new();
    let mut count = 0;
    for machine in &MACHINES {
        for formula in machine.formulas {
            faults.extend(fault(machine, formula, &mut random));
            for _ in 0..12 {
                let once = variant(formula, &mut random);
                let equation = if random.below(3) == 0 { variant(&once, &mut random) } else { once };
                faults.extend(fault(machine, &equation, &mut random));
                count += 1;
            }
        }
    }
    println!("{count} variants");
    assert!(faults.is_empty(), "{} faults:\n{}", faults.len(), faults.join("\n"));
}
