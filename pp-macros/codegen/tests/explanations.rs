//! The explanation of a machine: jog sheet, proven equations, width of lines.

use pp_codegen::compile;
use pp_codegen::explain::Explanation;

fn explained(text: &str) -> Explanation {
    let tokens = format!("pub struct M; {text}").parse().expect("Rust tokens");
    compile(tokens).unwrap_or_else(|refused| panic!("{text}: {refused:?}")).explanation
}

/// The lines of the jog sheet that are ticked off, each in one piece.
fn jogs(text: &str) -> Vec<String> {
    let sheet = explained(text).jog_sheet.text.join("\n").replace("\n    ", " ");
    sheet.lines().filter_map(|line| line.strip_prefix("[ ] ")).map(ToString::to_string).collect()
}

// Expectations are written by hand, from the right-hand rule and ISO 841: + moves the tool relative to the workpiece,
// so a table moves in the opposite direction.

#[test]
fn the_spinner_is_jogged_table_against_the_word() {
    assert_eq!(
        jogs("chain: C B | X Y Z; d = (0, 0, d); dims = { d: 150.0 }; limits = { B: -5..110, C: free };"),
        [
            "C+90: the table rotates clockwise seen from above; the side that faced you (-Y) now faces left (-X)",
            "B+90: the table rotates counterclockwise seen from the front; the table's top, which faced up (+Z), now faces left (-X)",
            "X+100: the spindle moves right (+X)",
            "Y+100: the spindle moves away from you (+Y)",
            "Z+100: the spindle moves up (+Z)",
        ]
    );
}

#[test]
fn lola_is_jogged_head_with_the_word() {
    assert_eq!(
        jogs("chain: X | Y Z B A;"),
        [
            "X+100: the table moves left (-X)",
            "Y+100: the spindle moves away from you (+Y)",
            "Z+100: the spindle moves up (+Z)",
            "B+90: the spindle head rotates clockwise seen from the front; the tool, which pointed down (-Z), now points left (-X)",
            "A+90: the spindle head rotates counterclockwise seen from the right; the tool, which pointed down (-Z), now points away from you (+Y)",
            "B at 90, Z+100: the spindle moves up (+Z), as before",
            "A at 90, Y+100: the spindle moves away from you (+Y), as before",
            "A at 90, Z+100: the spindle moves up (+Z), as before",
        ]
    );
}

#[test]
fn an_inclined_table_is_jogged_by_two_markers() {
    // Half of the paper's 90° tilt at B180: the right side moves up and to the back, the top leans to the left.
    assert_eq!(
        jogs("chain: C B | X Y Z; axes = { B: Rx(-45 deg) * Y }; limits = { B: 0..180, C: free };")[..2],
        [
            "C+90: the table rotates clockwise seen from above; the side that faced you (-Y) now faces left (-X)",
            "B+90: the side that faced right (+X) now faces away from you and up (+Y +Z); the table's top, which faced up (+Z), \
             now leans 60 degrees to the left and towards you (-X -Y)",
        ]
    );
}

#[test]
fn multiprodesk_is_jogged_table_with_the_word() {
    assert_eq!(
        jogs("chain: A Y | X Z; signs = { A: -, Y: - };"),
        [
            "A+90: the table rotates counterclockwise seen from the right; the table's top, which faced up (+Z), now faces you (-Y)",
            "Y+100: the table moves away from you (+Y)",
            "X+100: the spindle moves right (+X)",
            "Z+100: the spindle moves up (+Z)",
            "A at 90, Y+100: the table moves away from you (+Y), as before",
        ]
    );
}

#[test]
fn a_horizontal_tool_points_into_the_machine() {
    let text = "chain: B X | Y Z A; tool_axis = (0, -1, 0);";
    assert_eq!(
        jogs(text),
        [
            "B+90: the table rotates counterclockwise seen from the front; the table's top, which faced up (+Z), now faces left (-X)",
            "X+100: the table moves left (-X)",
            "Y+100: the spindle moves away from you (+Y)",
            "Z+100: the spindle moves up (+Z)",
            "A+90: the spindle head rotates counterclockwise seen from the right; the tool, which pointed away from you (+Y), now points up (+Z)",
            "B at 90, X+100: the table moves left (-X), as before",
            "A at 90, Y+100: the spindle moves away from you (+Y), as before",
            "A at 90, Z+100: the spindle moves up (+Z), as before",
        ]
    );
    let sheet = explained(text).jog_sheet.text.join("\n");
    assert!(sheet.contains("At the start the tool points away from you (+Y)."), "{sheet}");
}

/// A step that would leave the travel has the other direction; where zero is not in the travel the start is the end
/// nearest to it, and what the sheet states of the top, and of axes that this one carries, is seen from there.
#[test]
fn no_jog_leaves_the_travel() {
    let first = |limits: &str| jogs(&format!("chain: C B | X Y Z; limits = {{ B: {limits}, C: free }};"))[1].clone();
    for (limits, step) in
        [("0..180", "B+90"), ("-110..0", "B-90"), ("-110..5", "B-90"), ("-110..30", "B+30"), ("-2..5", "B+5")]
    {
        assert!(first(limits).starts_with(&format!("{step}: ")), "{limits}: {}", first(limits));
    }
    let raised = "chain: C B | X Y Z; limits = { B: 90..150, C: free };";
    let lines = jogs(raised);
    assert!(
        lines[1].starts_with("B+45: ") && lines[1].contains("the table's top, which faced left (-X),"),
        "{lines:?}"
    );
    // C is horizontal now, along +X of the bed: seen from the left its table rotates clockwise.
    assert!(lines[0].contains("the table rotates counterclockwise seen from the right"), "{lines:?}");
    let sheet = explained(raised).jog_sheet.text.join(" ");
    assert!(sheet.contains("rotary axes at zero, but B at 90: zero is"), "{sheet}");
    assert!(sheet.contains("(Z up)") && sheet.contains("middle of their travel"), "{sheet}");
}

/// A horizontal machining centre as it is programmed: Y is up, and the spindle is along Z.
#[test]
fn a_horizontal_machine_is_jogged_as_it_stands() {
    let text = "chain: B Z | X Y; up = Y;";
    assert_eq!(
        jogs(text),
        [
            "B+90: the table rotates clockwise seen from above; the side that faced you (+Z) now faces left (-X)",
            "Z+100: the table moves away from you (-Z)",
            "X+100: the spindle moves right (+X)",
            "Y+100: the spindle moves up (+Y)",
            "B at 90, Z+100: the table moves away from you (-Z), as before",
        ]
    );
    let sheet = explained(text).jog_sheet.text.join("\n");
    assert!(sheet.contains("X points right (+X), Y up (+Y), Z towards you (+Z)."), "{sheet}");
    assert!(sheet.contains("At the start the tool points away from you (-Z)."), "{sheet}");
    // Upside down, and a lathe whose X is up.
    assert_eq!(jogs("chain: X Y | Z; up = -Z;")[2], "Z+100: the spindle moves down (+Z)");
    assert_eq!(jogs("chain: X Y | Z; up = -Z;")[1], "Y+100: the table moves away from you (-Y)");
    let lathe = jogs("chain: C | X Z Y B; up = X;");
    assert_eq!(
        lathe[1..4],
        [
            "X+100: the spindle moves up (+X)",
            "Z+100: the spindle moves right (+Z)",
            "Y+100: the spindle moves towards you (+Y)",
        ]
    );
}

#[test]
fn a_flipped_sign_changes_its_sentence_and_no_other() {
    for chain in ["C B | X Y Z", "X | Y Z B A", "A Y | X Z", "C X | B Y Z"] {
        let right = jogs(&format!("chain: {chain};"));
        for (index, letter) in chain.split_whitespace().filter(|word| *word != "|").enumerate() {
            let wrong = jogs(&format!("chain: {chain}; signs = {{ {letter}: - }};"));
            assert_eq!(right.len(), wrong.len(), "{chain}, {letter}");
            for (place, (right, wrong)) in right.iter().zip(&wrong).enumerate() {
                // A line of two axes names them both, `A at 90, Y+100: ...`; the first counts where it carries the
                // second.
                let own = right.split_once(" at ").map_or(place == index, |(rotary, line)| {
                    let moved = line.split_once(", ").is_some_and(|(_, moved)| moved.starts_with(letter));
                    moved || rotary == letter && !right.ends_with("as before")
                });
                assert_eq!(right != wrong, own, "{chain}, {letter}: {right} / {wrong}");
            }
        }
    }
}

#[test]
fn jogs_stay_inside_the_travel_and_are_negative_where_it_has_no_positive_part() {
    let first = |limits: &str| jogs(&format!("chain: C B | X Y Z; limits = {{ {limits} }};"));
    assert!(first("B: -5..60")[1].starts_with("B+45: "));
    assert_eq!(
        first("B: -110..0.5")[1],
        "B-90: the table rotates clockwise seen from the front; the table's top, which faced up (+Z), now faces right (+X)"
    );
    assert_eq!(
        first("B: -5..12")[1],
        "B+10: the table rotates counterclockwise seen from the front; the table's top, which faced up (+Z), now leans 10 degrees to the left (-X)"
    );
    assert!(first("X: -30..30")[2].starts_with("X+10: "));
}

#[test]
fn held_axes_are_jogged_too_and_rotate_the_axes_they_carry() {
    let jogs = jogs("chain: C W B | X Y Z A; hold = { W: 0, A: 30 };");
    assert_eq!(jogs[1], "W+100 (held): the table moves down (-Z)");
    assert!(jogs[6].starts_with("A+90 (held): "), "{jogs:?}");
    // C at 180°, between B and the bed, reverses the direction of B.
    let turned = self::jogs("chain: B C | X Y Z A; hold = { C: 180 };");
    assert!(turned[0].starts_with("B+90: the table rotates clockwise seen from the front"), "{turned:?}");
}

#[test]
fn lines_of_text_are_short() {
    for text in [
        "chain: C B | X Y Z; axes = { B: Rx(-45 deg) * Y };",
        "chain: C B | X Y Z; axes = { B: (1, 2, 3), C: (3, 5, 8) };",
    ] {
        let explanation = explained(text);
        let sections = [
            explanation.chain,
            explanation.parameters,
            explanation.matrices,
            explanation.forward,
            explanation.formulas,
            explanation.branches,
            explanation.singular_set,
            explanation.reachable,
            explanation.degenerate,
            explanation.proofs,
            explanation.operations,
            explanation.jog_sheet,
            explanation.verify,
        ];
        for line in sections.iter().flat_map(|section| &section.text) {
            assert!(line.chars().count() <= 96, "{line}");
        }
    }
}

#[test]
fn proven_equations_name_their_source_and_where_they_hold() {
    let machine = "chain: C B | X Y Z; verify \"A paper, eq. (2)\" { B = acos(k); }";
    let proofs = explained(machine).proofs;
    let last = proofs.text.len() - 3;
    let expected =
        ["A paper, eq. (2), with gauge = 0, part = 0:", "B = acos(k)", "    holds where sin B >= 0 (the first branch)"];
    assert_eq!(proofs.text[last..], expected);
    assert_eq!(proofs.latex[proofs.latex.len() - 2], r"$\displaystyle B = \arccos(k)$");
}

#[test]
fn every_parameter_has_its_place_in_declaration_configuration_and_kinematics_for_a_control() {
    let text = "dims = { d: 150, Bed_1: required, alpha: -45 deg }; chain: C B | X Y Z; axes = { B: Rx(alpha) * Y };
        d = { C: (0, 0, d), B: (0, Bed_1, d) };";
    let parameters = explained(text).parameters.text.join("\n").replace("\n    ", " ");
    for line in [
        "d: a length of the machine, declared as 150 mm; `dimensions.d` of the configuration.",
        "Enters: centre lines of C B.",
        "Bed_1: a length of the machine, not declared: each machine has its own; `dimensions.Bed_1` of the configuration.",
        "Enters: centre lines of B.",
        "alpha: an angle of the machine, declared as -45°; `dimensions.alpha` of the configuration.",
        "Enters: directions of B.",
        "part_x, part_y, part_z: the part zero from the table's reference point; `part_origin` of the configuration.",
        "pins: d, bed-1, alpha, part-origin-x to -z, tool-offset.",
        "members of the structure: d, Bed_1, alpha, part_origin, gauge_length.",
    ] {
        assert!(parameters.contains(line), "{line}\n{parameters}");
    }
    assert!(!parameters.contains("gauge: "), "{parameters}");
    let head = explained("chain: | X Y Z C B;").parameters.text;
    assert!(head.iter().any(|line| line.starts_with("gauge: the tool tip from the gauge line of the spindle;")));
}

#[test]
fn lengths_of_which_only_the_sum_counts_are_named() {
    let parameters = |text: &str| explained(text).parameters.text.join("\n").replace("\n    ", " ");
    let sum = parameters(
        "chain: C B | X Y Z; dims = { table: 40, riser: 60, side: 1 }; d = { C: (0, 0, 0), B: (side, 0, table + riser) };",
    );
    assert!(sum.contains("Only the sum table + riser counts: measure one of the two as zero"), "{sum}");
    assert!(!sum.contains("side counts") && !sum.contains("does not move the tip"), "{sum}");
    let difference = parameters("chain: C B | X Y Z; dims = { top: 40, axis: 60 }; d = (0, 0, axis - top);");
    assert!(difference.contains("Only the difference top - axis counts"), "{difference}");
    let along = parameters("chain: C B | X Y Z; dims = { along: 40, h: 5 }; d = { C: (0, 0, 0), B: (0, along, h) };");
    assert!(along.contains("along does not move the tip: any value of it makes the same programs."), "{along}");
    let both = parameters("chain: C B | X Y Z; dims = { h: 40, r: 60 }; d = { C: (r, 0, 0), B: (0, 0, h) };");
    assert!(!both.contains("counts") && !both.contains("does not move"), "{both}");
}

#[test]
fn conditions_are_angles_or_words_where_their_factors_are_long() {
    let machine = "chain: C B | X Y Z; axes = { B: Rx(alpha) * Y }; dims = { alpha: -45 deg }; verify \"a paper\" {
        C = atan2(cos(alpha) * sin(B) * j - sin(alpha) * cos(alpha) * (1 - cos(B)) * i,
            cos(alpha) * sin(B) * i + sin(alpha) * cos(alpha) * (1 - cos(B)) * j); }";
    let tokens = format!("pub struct M; {machine}").parse().expect("Rust tokens");
    let verified = compile(tokens).expect("holds").verified;
    let proven = &verified[0].equations[0];
    assert_eq!(proven.holds, ["(1 - cos B) cos alpha · (2 - (1 - cos B) cos² alpha) != 0"]);
    assert_eq!(proven.holds_in_words, ["B != 0", "cos alpha != 0", "2 - (1 - cos B) cos² alpha != 0"]);
}
