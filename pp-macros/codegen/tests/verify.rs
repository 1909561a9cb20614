//! Equations of the papers are proven, their misprints are not, and no slip of a sign or of a function passes unseen.

use pp_codegen::compile;

/// One equation with the conditions that are shown for it, or the messages of its refusal.
fn outcome(machine: &str, assumptions: &str, equation: &str) -> Result<String, Vec<String>> {
    let tokens = format!("pub struct M; {machine} verify \"here\" {{ {assumptions} {equation}; }}");
    let tokens = tokens.parse().unwrap_or_else(|error| panic!("{equation}: {error}"));
    match compile(tokens) {
        Ok(machine) => Ok(machine.verified[0].equations[0].holds.join(", ")),
        Err(refused) => Err(refused.0.iter().map(ToString::to_string).collect()),
    }
}

/// A machine of a paper with its equations.
struct Paper {
    machine: &'static str,
    assumptions: &'static str,
    /// Equations and where they hold.
    equations: &'static [(&'static str, &'static str)],
}

const LOLA: Paper = Paper {
    machine: "chain: X | Y Z B A;",
    assumptions: "",
    equations: &[
        ("i = sin(B) * cos(A)", ""),
        ("j = -sin(A)", ""),
        ("k = cos(B) * cos(A)", ""),
        ("x = X - gauge * sin(B) * cos(A)", ""),
        ("y = Y + gauge * sin(A)", ""),
        ("z = Z + gauge - gauge * cos(B) * cos(A)", ""),
        ("A = asin(-j)", "cos A >= 0 (the first branch)"),
        ("B = atan2(i, k)", "cos A > 0 (the first branch)"),
        ("X = x + gauge * sin(B) * cos(A)", ""),
        ("Y = y - gauge * sin(A)", ""),
        ("Z = z + gauge * cos(B) * cos(A) - gauge", ""),
    ],
};

const SPINNER: Paper = Paper {
    machine: "chain: C B | X Y Z; d = (0, 0, d); dims = { d: 150.0 };",
    assumptions: "",
    equations: &[
        ("i = sin(B) * cos(C)", ""),
        ("j = sin(B) * sin(C)", ""),
        ("k = cos(B)", ""),
        ("C = atan2(j, i)", "sin B > 0 (the first branch)"),
        ("B = acos(k)", "sin B >= 0 (the first branch)"),
        ("X = x * cos(B) * cos(C) + y * cos(B) * sin(C) - z * sin(B) + d * sin(B)", ""),
        ("Y = -x * sin(C) + y * cos(C)", ""),
        ("Z = x * sin(B) * cos(C) + y * sin(B) * sin(C) + z * cos(B) - d * cos(B) + d", ""),
    ],
};

const DMU: Paper = Paper {
    machine: "chain: C B | X Y Z; axes = { B: Rx(-45 deg) * Y }; d = (0, 0, d); dims = { d: 150.0 };",
    assumptions: "",
    equations: &[
        ("i = sin(B) * cos(C) / sqrt(2) + sin(C) * (1 - cos(B)) / 2", ""),
        ("j = sin(B) * sin(C) / sqrt(2) - cos(C) * (1 - cos(B)) / 2", ""),
        ("k = (1 + cos(B)) / 2", ""),
        ("B = acos(2 * k - 1)", "sin B >= 0 (the first branch)"),
        (
            "C = atan2((1 - k) * i + sqrt(2 * (k - k^2)) * j, sqrt(2 * (k - k^2)) * i - (1 - k) * j)",
            "sin B >= 0 (the first branch)",
        ),
        (
            "X = sqrt(2) / 2 * (d * sin(B) + x * sin(B) * sin(C) - y * sin(B) * cos(C) - z * sin(B)) \
             + x * cos(B) * cos(C) + y * cos(B) * sin(C)",
            "",
        ),
        (
            "Y = sqrt(2) / 2 * (y * sin(B) * sin(C) + x * sin(B) * cos(C)) + (-x * cos(B) * sin(C) \
             + y * cos(B) * cos(C) + z * cos(B) - d * cos(B) - x * sin(C) + y * cos(C) - z + d) / 2",
            "",
        ),
        (
            "Z = sqrt(2) / 2 * (y * sin(B) * sin(C) + x * sin(B) * cos(C)) + (-x * cos(B) * sin(C) \
             + y * cos(B) * cos(C) + z * cos(B) - d * cos(B) + x * sin(C) - y * cos(C) + z + d) / 2",
            "",
        ),
    ],
};

/// (6) and (7) in the form that follows from the paper's own `R_alpha`.
const INCLINED: Paper = Paper {
    machine: "chain: C B | X Y Z; axes = { B: Rx(alpha) * Y }; dims = { alpha: -45 deg };",
    assumptions: "",
    equations: &[
        ("B = acos((k - sin(alpha)^2) / cos(alpha)^2)", "sin B >= 0 (the first branch), cos alpha != 0"),
        (
            "C = atan2(cos(alpha) * sin(B) * j - sin(alpha) * cos(alpha) * (1 - cos(B)) * i, \
             cos(alpha) * sin(B) * i + sin(alpha) * cos(alpha) * (1 - cos(B)) * j)",
            "(1 - cos B) cos alpha · (2 - (1 - cos B) cos² alpha) != 0",
        ),
    ],
};

/// (6) and (7) as printed, with the axis for which they are right.
const INCLINED_AS_PRINTED: Paper = Paper {
    machine: "chain: C B | X Y Z; axes = { B: Rx(-90 deg) * Rx(-alpha) * Y }; dims = { alpha: -45 deg };",
    assumptions: "",
    equations: &[
        ("B = acos((k - cos(alpha)^2) / sin(alpha)^2)", "sin B >= 0 (the first branch), sin alpha != 0"),
        (
            "C = atan2(-(j * sin(alpha) * sin(B) + i * sin(alpha) * cos(alpha) * (1 - cos(B))), \
             -i * sin(alpha) * sin(B) + j * sin(alpha) * cos(alpha) * (1 - cos(B)))",
            "sin alpha · (1 - cos B) (1 - (1/2) (1 - cos B) sin² alpha) != 0",
        ),
    ],
};

const MULTIPRODESK: Paper = Paper {
    machine: "chain: A Y | X Z; signs = { A: -, Y: - };",
    assumptions: "",
    equations: &[
        ("i = 0", ""),
        ("j = sin(A)", ""),
        ("k = cos(A)", ""),
        ("x = X", ""),
        ("y = sin(A) * (Z + part_z) - cos(A) * (Y - part_y) - part_y", ""),
        ("z = sin(A) * (Y - part_y) + cos(A) * (Z + part_z) - part_z", ""),
        ("A = atan2(j, k)", ""),
        ("X = x", ""),
        ("Y = sin(A) * (z + part_z) - cos(A) * (y + part_y) + part_y", ""),
        ("Z = cos(A) * (z + part_z) + sin(A) * (y + part_y) - part_z", ""),
    ],
};

const PAPERS: [&Paper; 6] = [&LOLA, &SPINNER, &DMU, &INCLINED, &INCLINED_AS_PRINTED, &MULTIPRODESK];

#[test]
fn every_equation_of_the_papers_is_proven_where_it_holds() {
    for paper in PAPERS {
        for (equation, holds) in paper.equations {
            let found = outcome(paper.machine, paper.assumptions, equation);
            assert_eq!(found, Ok(holds.to_string()), "{equation}");
        }
    }
}

/// Equations made to deceive the decision, for SPINNER's chain, with their conditions (`None`: refused).
const HOSTILE: &[(&str, Option<&str>)] = &[
    // Both arguments are zero, always or at some poses.
    ("C = atan2(0, 0)", None),
    ("C = atan2(0 * j, 0 * i)", None),
    ("C = atan2(j - sin(B) * sin(C), i - sin(B) * cos(C))", None),
    ("C = atan2(j * sin(B), i * sin(B))", Some("sin B != 0")),
    ("C = atan2(d^2 * j, d^2 * i)", Some("sin B > 0 (the first branch), d != 0")),
    ("C = atan2(d * j, d * i)", Some("d sin B > 0")),
    ("C = atan2(j * (1 - k), i * (1 - k))", Some("sin B > 0 (the first branch)")),
    ("2 * C = atan2(2 * i * j, i^2 - j^2)", Some("sin B != 0")),
    // A root whose factor vanishes on a whole part still has to exist there.
    (
        "i = sin(B) * cos(C) + (sqrt(sin(B)^2) - sin(B)) * sqrt(i)",
        Some("cos C sin B >= 0, sin B >= 0 (the first branch)"),
    ),
    // Conditions that hold together only at their bounds.
    ("i = sin(B) * cos(C) + 0 * sqrt(sin(C) - sin(B)) + 0 * sqrt(sin(B) - sin(C))", None),
    ("i = sin(B) * cos(C) + 0 * sqrt(X - Y) + 0 * sqrt(Y - X)", None),
    // Divisors that are zero without looking like it.
    ("i + 0 / (sin(20 deg) - 2 * sin(10 deg) * cos(10 deg)) = i", None),
    ("i = sin(B) * cos(C) + 0 * cos(atan2(i * sin(B) / sin(B) - i, 0))", None),
    // Slightly below zero is below zero.
    ("i = sin(B) * cos(C) + 0 * sqrt(1 - 1.000000000000001 * sin(B))", Some("1 - 1 sin B >= 0")),
    ("i = sin(B) * cos(C) + 0 * sqrt(1 - sin(B))", Some("")),
    // True of any machine.
    ("0 = 0 * x", None),
    ("sin(B)^2 + cos(B)^2 = 1", None),
    ("X = X + 0 * y", None),
    ("acos(-k) = 180 deg - acos(k)", None),
    ("sqrt(i) * sqrt(j) = sqrt(i * j)", None),
    ("sqrt(3 - 2 * sqrt(2)) = sqrt(2) - 1", None),
    // True, and found to be true.
    ("acos(k) = atan2(sqrt(1 - cos(B)^2), k)", Some("")),
    ("asin(cos(B)) = 90 deg - acos(k)", Some("")),
    ("acos(-k) = 180 deg - acos(cos(B))", Some("")),
    ("sqrt(i) * sqrt(j) = sqrt(i * sin(B) * sin(C))", Some("cos C sin B >= 0, sin C sin B >= 0")),
    ("C = acos(i / sqrt(i^2 + j^2))", Some("sin C >= 0, sin B >= 0 (the first branch), sin B != 0")),
    ("k * sqrt(3 - 2 * sqrt(2)) = cos(B) * (sqrt(2) - 1)", Some("")),
    ("k * sqrt(3 - 2 * sqrt(2)) = cos(B) * (1 - sqrt(2))", None),
];

#[test]
fn hostile_equations_hold_under_their_conditions_or_are_refused() {
    for (equation, holds) in HOSTILE {
        let found = outcome(SPINNER.machine, "", equation);
        assert_eq!(found.as_deref().ok(), *holds, "{equation}: {found:?}");
    }
}

/// Every change of one sign, and of one sine into a cosine or back.
fn mutants(equation: &str) -> Vec<String> {
    let (left, right) = equation.split_once(" = ").expect("an equation");
    let mut changed = Vec::new();
    for (from, to) in [("sin(", "cos("), ("cos(", "sin(")] {
        for (place, _) in right.match_indices(from) {
            // Not the tail of `asin(`.
            if place == 0 || !right.as_bytes()[place - 1].is_ascii_alphabetic() {
                changed.push(format!("{}{to}{}", &right[..place], &right[place + from.len()..]));
            }
        }
    }
    for (place, _) in right.match_indices(['+', '-']) {
        let other = if right.as_bytes()[place] == b'+' { "-" } else { "+" };
        // The language has no leading plus.
        let leading = right[..place].trim_end().is_empty() || right[..place].trim_end().ends_with(['(', ',', '*', '/']);
        let other = if leading { "" } else { other };
        changed.push(format!("{}{other}{}", &right[..place], &right[place + 1..]));
    }
    // A minus before every term and argument that has no sign.
    let mut bare = vec![0];
    bare.extend(right.match_indices(['(', ',']).map(|(place, _)| place + 1));
    for place in bare {
        if !right[place..].trim_start().starts_with('-') {
            changed.push(format!("{} -{}", &right[..place], right[place..].trim_start()));
        }
    }
    changed.into_iter().map(|right| format!("{left} = {right}")).collect()
}

/// Equal to its original in value: the sign of zero, of the argument of an even function, and of a squared term.
fn is_equal(equation: &str, mutant: &str) -> bool {
    let plain = mutant.replace("cos( -", "cos(").replace("sin( -alpha)^2", "sin(alpha)^2").replace("=  -0", "= 0");
    equation == plain
}

#[test]
fn no_wrong_sign_or_function_passes_with_the_same_explanation() {
    let mut count = 0;
    let mut other_branch = 0;
    for paper in PAPERS {
        for (equation, holds) in paper.equations {
            for mutant in mutants(equation).into_iter().filter(|mutant| !is_equal(equation, mutant)) {
                count += 1;
                if let Ok(found) = outcome(paper.machine, paper.assumptions, &mutant) {
                    other_branch += 1;
                    if &found == holds {
                        println!("`{mutant}` passes for `{equation}`");
                    }
                }
            }
        }
    }
    println!("{count} mutants, {other_branch} of them right on another branch");
    assert!(count > 300);
}

/// The equation with the change of a help line, at every place where its words fit.
fn remedied(equation: &str, help: &str) -> Vec<String> {
    let bare = |text: &str| text.replace(' ', "");
    // As messages write it: without spare parentheses.
    let tokens = format!("pub struct M; verify \"here\" {{ {equation}; }}").parse().expect("tokens");
    let declaration = pp_codegen::syntax::parse(tokens, &mut pp_codegen::report::Errors::default());
    let Ok(declaration) = declaration else { panic!("{equation} cannot be read") };
    let equation = &declaration.verify[0].equations[0];
    let (left, right) = (bare(&equation.left.to_string()), bare(&equation.right.to_string()));
    let quoted: Vec<String> = help.split('`').skip(1).step_by(2).map(bare).collect();
    let places = |from: &str, to: &str| {
        let at = right.match_indices(from).map(|(place, _)| place);
        at.map(|place| format!("{left} = {}{to}{}", &right[..place], &right[place + from.len()..])).collect()
    };
    match &quoted[..] {
        [to, from] if help.starts_with("write") => places(from, to),
        [from] if help.starts_with("leave out") => places(from, ""),
        [term] if help.starts_with("add") => vec![format!("{left} = {right}{term}")],
        [sine, cosine] if help.starts_with("exchange") => {
            let exchanged = right.replace(sine, "#").replace(cosine, sine).replace('#', cosine);
            vec![format!("{left} = {exchanged}")]
        }
        _ => Vec::new(),
    }
}

/// The declarations of a help line, each the machine with the field that the line names.
fn redeclared(machine: &str, help: &str) -> Vec<String> {
    let Some(changes) = help.strip_prefix("it follows with ") else { return Vec::new() };
    let changes = changes.split("; if the declaration is right").next().unwrap_or_default();
    let fields = changes.split('`').skip(1).step_by(2);
    let without = |name: &str| {
        let others = machine.split_inclusive(';').filter(|field| {
            let known = field.trim_start().split([' ', ':']).next();
            known != Some(name)
        });
        others.collect::<String>()
    };
    fields.map(|field| format!("{} {field}", without(field.split([' ', ':']).next().unwrap_or_default()))).collect()
}

#[test]
fn a_help_makes_the_equation_true() {
    let (mut helped, mut redeclared_count) = (0, 0);
    for paper in PAPERS {
        for (equation, _) in paper.equations {
            for mutant in mutants(equation) {
                let Err(messages) = outcome(paper.machine, paper.assumptions, &mutant) else { continue };
                let help = messages[0].split("help: ").nth(1).expect("a help");
                for machine in redeclared(paper.machine, help) {
                    let found = outcome(&machine, paper.assumptions, &mutant);
                    assert!(found.is_ok(), "{mutant}: {help}, {machine}: {found:?}");
                    redeclared_count += 1;
                }
                let help = match help.strip_prefix("it follows with ") {
                    Some(help) => {
                        help.split_once("; if the declaration is right: ").map_or("no single change", |(_, own)| own)
                    }
                    None => help,
                };
                let remedied = remedied(&mutant, help);
                if remedied.is_empty() {
                    assert!(
                        ["no single change", "it is true with", "check the signs", "change the sign"]
                            .iter()
                            .any(|known| help.starts_with(known)),
                        "{mutant}: {help}"
                    );
                    continue;
                }
                let is_true = |equation: &String| outcome(paper.machine, paper.assumptions, equation).is_ok();
                assert!(remedied.iter().any(is_true), "{mutant}: {help}");
                helped += 1;
            }
        }
    }
    assert!(helped > 250 && redeclared_count > 30, "{helped} equations, {redeclared_count} declarations");
}

/// Further equations that hold, in forms that no paper prints.
#[test]
fn roots_quotients_and_sums_of_angles_hold_where_they_should() {
    for (equation, holds) in [
        ("B = atan2(sqrt(i^2 + j^2), k)", "sin B >= 0 (the first branch)"),
        ("B = atan2(-sqrt(1 - k^2), k)", "sin B <= 0 (the second branch)"),
        ("B = -acos(k)", "sin B <= 0 (the second branch)"),
        ("C = atan2(-j, -i)", "sin B < 0 (the second branch)"),
        ("C + B = atan2(j, i) + acos(k)", "sin B > 0 (the first branch)"),
        ("C - 90 deg = atan2(-i, j)", "sin B > 0 (the first branch)"),
        ("2 * C = atan2(2 * i * j, i^2 - j^2)", "sin B != 0"),
        ("C = atan2(j / sin(B), i / sin(B))", "sin B != 0"),
        ("C = asin(j / sqrt(1 - k^2))", "cos C >= 0, sin B >= 0 (the first branch), sin B != 0"),
        ("cos(B) = k", ""),
        ("sin(B)^2 = (1 - k) * (1 + k)", ""),
        ("sin(acos(cos(B))) = sqrt(i^2 + j^2)", ""),
    ] {
        assert_eq!(outcome(SPINNER.machine, "", equation), Ok(holds.to_string()), "{equation}");
    }
}

/// Assumptions of a block about the set-up and about dimensions.
#[test]
fn assumptions_are_stated_and_made() {
    let machine = |block: &str| {
        let text = format!(
            "pub struct M; chain: C B | X Y Z; axes = {{ B: Rx(alpha) * Y }}; d = (0, 0, d);
             dims = {{ d: 150.0, alpha: -45 deg }}; verify \"here\" {{ {block} }}"
        );
        compile(text.parse().expect("Rust tokens")).map(|machine| machine.verified[0].assumptions.clone())
    };
    let assumptions = machine("k = cos(alpha)^2 * cos(B) + sin(alpha)^2;").expect("holds");
    assert_eq!(assumptions, ["gauge = 0", "part = 0"]);
    let assumptions = machine("k = (1 + cos(B)) / 2; where alpha = -45 deg; where part_z = 2 * d;").expect("holds");
    assert_eq!(assumptions, ["alpha = -45 deg", "part_z = 2 * d", "gauge = 0", "part_x = 0", "part_y = 0"]);
    assert!(machine("k = (1 + cos(B)) / 2;").is_err());
    assert!(machine("k = (1 + cos(B)) / 2; where beta = 45 deg;").is_err());
    machine("k = sin(beta)^2 * cos(B) + 1 - sin(beta)^2; where beta = 90 deg - alpha;").expect("holds");
}

/// Names of a block may be expressions, of one another and of everything that equations mention; their roots and
/// divisors give the equation its conditions.
#[test]
fn names_of_a_block_are_expressions() {
    let machine = "chain: C | X Y Z B; d = { B: (0, 0, pivot) }; dims = { pivot: 150.0 };";
    let x = "X = x * cos(C) + y * sin(C) + L * sin(B)";
    for (assumptions, equation, holds) in [
        ("where L = gauge + pivot;", x, Some("")),
        ("where q = pivot; where L = gauge + q;", x, Some("")),
        ("where L = gauge + 2 * pivot;", x, None),
        ("where L = gauge - pivot;", x, None),
        ("where q = sin(B);", "i^2 + j^2 = q^2", Some("")),
        ("where r = sqrt(i^2 + j^2);", "r = sin(B)", Some("sin B >= 0 (the first branch)")),
        ("where r = 1 / sin(B);", "i * r = cos(-C)", Some("sin B != 0")),
        ("where c = atan2(j, i);", "C = c", Some("sin B > 0 (the first branch)")),
    ] {
        let found = outcome(machine, assumptions, equation);
        assert_eq!(found.as_deref().ok(), holds, "{assumptions} {equation}: {found:?}");
    }
}

/// Tangents, and those of half angles.
#[test]
fn tangents_are_quotients() {
    for (equation, holds) in [
        ("tan(C) = j / i", Some("cos C != 0, cos C sin B != 0")),
        ("tan(B/2) = sqrt(i^2 + j^2) / (1 + k)", Some("sin B >= 0 (the first branch), 1 + cos B != 0")),
        ("tan(0.5 * B)^2 = (1 - k) / (1 + k)", Some("1 + cos B != 0")),
        ("tan(B / 2) = (1 - k) / (i * cos(C) + j * sin(C))", Some("1 + cos B != 0, sin B != 0")),
        ("tan(B/2) = sqrt(i^2 + j^2) / (1 - k)", None),
        ("tan(C) = i / j", None),
    ] {
        let found = outcome(SPINNER.machine, "", equation);
        assert_eq!(found.as_deref().ok(), holds, "{equation}: {found:?}");
    }
}

/// A divisor that depends on dimensions alone is tested when a configuration is read.
#[test]
fn divisors_made_of_dimensions_are_validated() {
    let machine = |equation: &str| {
        let text = format!(
            "pub struct M; chain: C B | X Y Z; axes = {{ B: Rx(alpha) * Y }}; dims = {{ alpha: -45 deg }};
             verify \"the source\" {{ {equation} }}"
        );
        pp_codegen::generate(text.parse().expect("Rust tokens"), pp_codegen::Options::default())
            .expect("holds")
            .to_string()
    };
    let tested = |code: &str| code.contains("equations of \\\"the source\\\" divide by it");
    assert!(tested(&machine("B = acos((k - sin(alpha)^2) / cos(alpha)^2);")));
    assert!(!tested(&machine("k = cos(alpha)^2 * cos(B) + sin(alpha)^2;")));
    assert!(!tested(&machine("C = atan2(j / (2 + k), i / (2 + k)) + 0; where alpha = 0 deg;")));
}
