//! Lines of the user: executed by their declared effect, in their places.

use super::*;

fn own(text: &str, place: OwnPlace) -> OwnText {
    OwnText { text: text.as_bytes().to_vec(), place, coolant: None }
}

fn with(family: Family, own: Vec<OwnText>, effects: &[(&str, Effect)], program: &str) -> Vec<Block> {
    let effects = effects.iter().map(|(text, effect)| (text.as_bytes().to_vec(), *effect)).collect();
    let mut reader = Reader::new(program.as_bytes(), Vocabulary { own, effects, ..vocabulary(family) });
    let mut blocks = Vec::new();
    while let Some((block, _)) = reader.next_block().expect("text in memory") {
        blocks.push(block.clone());
    }
    blocks
}

fn places(block: &Block) -> &[OwnPlace] {
    block.own.as_ref().map_or(&[], |own| &own.places)
}

const HEAD: &str = "G21 G17 G40 G49 G80 G90 G94 G54\nS500 M3\nM8\nG0 X1. Y2. Z3. B0. C0.\n";

#[test]
fn a_line_without_a_declared_effect_is_a_fault_that_names_it() {
    for (family, line, program) in [
        (Family::Fanuc, "M77", "M77\n"),
        (Family::Haas, "M77", "N5 M77\n"),
        (Family::Siemens, "WARM_UP(5)", "WARM_UP(5)\n"),
        (Family::Heidenhain, "M77", "0 M77\n"),
    ] {
        let blocks = with(family, vec![own(line, OwnPlace::Start)], &[], program);
        let fault = &blocks[0].faults[0].text;
        assert!(blocks[0].faults.len() == 1 && fault.contains(line) && fault.contains("[control] effects"), "{fault}");
        let blocks = with(family, vec![own(line, OwnPlace::Start)], &[(line, Effect::None)], program);
        assert_eq!(blocks[0].faults, [], "{family:?}");
        assert_eq!(
            blocks[0].own,
            Some(OwnLine {
                places: vec![OwnPlace::Start],
                effect: Some(Effect::None),
                needs_standstill: false,
                values: OwnValues::default()
            }),
            "{family:?}"
        );
        // A line that is not in the configuration stays a fault.
        let blocks = with(family, Vec::new(), &[], program);
        assert!(blocks[0].faults[0].text.contains("is not known"), "{family:?}");
    }
}

#[test]
fn a_declared_effect_is_executed() {
    let after = |effect: Effect| {
        let program = format!("{HEAD}M77\n");
        let blocks = with(Family::Fanuc, vec![own("M77", OwnPlace::End)], &[("M77", effect)], &program);
        blocks.iter().for_each(|block| assert_eq!(block.faults, []));
        blocks.last().cloned().expect("a block")
    };
    let untouched = after(Effect::None);
    assert_eq!((untouched.known, untouched.state.coolant), (0b11111, Some(coolant::FLOOD)));
    assert_eq!(after(Effect::Coolant).state.coolant, None);
    assert_eq!(after(Effect::Coolant).stated & stated::COOLANT, 0);
    let spindle = after(Effect::Spindle).state;
    assert_eq!((spindle.spindle, spindle.speed), (None, None));
    assert_eq!((after(Effect::Stop).action, after(Effect::Stop).known), (Action::Stop, 0));
    assert_eq!((after(Effect::PositionLost).known, after(Effect::Measures).known), (0, 0));
    let lost = after(Effect::StateLost);
    let state = State { lost_at: Some(lost.line), ..State::default() };
    assert_eq!((lost.known, lost.state, lost.stated), (0, state, 0));
}

#[test]
fn a_declared_word_stands_beside_codes_that_are_read() {
    let lines =
        vec![own("T{tool} M6 M77", OwnPlace::ToolChange), own("{units} G90 M78 {work_offset}", OwnPlace::Safety)];
    let effects = [("M77", Effect::None), ("M78", Effect::Coolant)];
    let program = "M8\nT5 M6 M77\nG21 G90 M78 G54.1 P3\n";
    let blocks = with(Family::Fanuc, lines.clone(), &effects, program);
    blocks.iter().for_each(|block| assert_eq!(block.faults, []));
    assert_eq!((blocks[1].action, blocks[1].state.tool), (Action::ToolChange, Some(5)));
    assert_eq!(places(&blocks[1]), [OwnPlace::ToolChange]);
    assert_eq!(blocks[2].state.work_offset, Some(WorkOffset::Further(3)));
    assert_eq!((blocks[1].state.coolant, blocks[2].state.coolant), (Some(coolant::FLOOD), None));
    // The word in a line of another form is a fault, and so is a word that has no effect.
    for program in ["T5 M77\n", "T5 M6 M77 M55\n", "G0 X5. M77\n", "T[5] M6 M77\n"] {
        let blocks = with(Family::Fanuc, lines.clone(), &effects, program);
        assert!(!blocks[0].faults.is_empty(), "{program}");
    }
}

#[test]
fn clamps_are_known_once_their_codes_have_come() {
    let clamp = |text: &str, axis: usize, on: bool| own(text, OwnPlace::Clamp { axis, on });
    let lines = vec![clamp("M10", 0, true), clamp("M11", 0, false), clamp("M10", 1, true), clamp("M69", 1, false)];
    let blocks = with(Family::Haas, lines, &[], "M10\nM11\nM69\n");
    let clamps: Vec<_> = blocks.iter().map(|block| (block.state.clamped, block.state.clamps_known)).collect();
    assert_eq!(clamps, [(3, 3), (2, 3), (0, 3)]);
    blocks.iter().for_each(|block| assert_eq!(block.faults, []));
    assert_eq!(places(&blocks[0]), [0, 1].map(|axis| OwnPlace::Clamp { axis, on: true }));
}

#[test]
fn a_text_of_insert_has_the_effect_that_is_declared_for_it() {
    let blocks = with(Family::Fanuc, Vec::new(), &[("G65 P9000", Effect::Measures)], &format!("{HEAD}G65 P9000\n"));
    let last = blocks.last().expect("a block");
    let measures = OwnLine {
        places: vec![OwnPlace::Insert],
        effect: Some(Effect::Measures),
        needs_standstill: false,
        values: OwnValues::default(),
    };
    assert_eq!((&last.faults[..], last.known, &last.own), (&[][..], 0, &Some(measures)));
}

#[test]
fn a_line_number_that_does_not_follow_is_a_fault_of_a_line_of_the_user_too() {
    let blocks =
        with(Family::Heidenhain, vec![own("M77", OwnPlace::Clamp { axis: 0, on: true })], &[], "0 M8\n5 M77\n");
    assert!(blocks[1].faults[0].text.contains("line number"), "{:?}", blocks[1].faults);
}

#[test]
fn a_line_of_the_shop_is_known_by_its_words_whatever_its_number_and_comments() {
    let lines = |unlock: &str| {
        vec![
            own("M10", OwnPlace::Clamp { axis: 0, on: true }),
            own(unlock, OwnPlace::Clamp { axis: 0, on: false }),
            own("M77  P5", OwnPlace::Insert),
        ]
    };
    let iso = ["N117 M10", "M10 (X)", "N5 M10 (LOCK)", "(A) M10", "N5 (A) M10 (B)", "  M10  ", "N5M10", "M10 (A) (B)"];
    let marks = ["M10 ; clamp", "N5 M10 ; clamp", "N5 M10;clamp", "  M10"];
    let cases = [
        (Family::LinuxCnc, "", &[&iso[..], &marks].concat()),
        (Family::Fanuc, "", &[&iso[..], &["M10;", "N5 M10 (A);"]].concat()),
        (Family::Haas, "", &iso.to_vec()),
        (Family::Siemens, "", &marks.to_vec()),
        (Family::Heidenhain, "0 ", &vec!["M10 ; clamp", "M10;clamp", " M10"]),
    ];
    for (family, number, texts) in cases {
        let brackets = matches!(family, Family::LinuxCnc | Family::Fanuc | Family::Haas);
        let unlock = if brackets { "M11 (UNLOCK C)" } else { "M11 ;UNLOCK C" };
        for text in texts {
            let of =
                |text: &str| with(family, lines(unlock), &[("M77 P5", Effect::Measures)], &format!("{number}{text}\n"));
            let blocks = of(text);
            assert_eq!(blocks[0].faults, [], "{family:?}: {text}");
            assert_eq!((blocks[0].state.clamped, blocks[0].state.clamps_known), (1, 1), "{family:?}: {text}");
            // The text of the configuration may have a comment of its own, and one with a declared effect too.
            let off = of(&text.replace("M10", "M11"));
            assert_eq!(
                (&off[0].faults[..], off[0].state.clamps_known, off[0].state.clamped),
                (&[][..], 1, 0),
                "{text}"
            );
            let measured = of(&text.replace("M10", "M77 P5"));
            let wanted = OwnLine {
                places: vec![OwnPlace::Insert],
                effect: Some(Effect::Measures),
                needs_standstill: false,
                values: OwnValues::default(),
            };
            assert_eq!((&measured[0].faults[..], &measured[0].own), (&[][..], &Some(wanted)), "{family:?}: {text}");
            // Another code is no line of the shop.
            assert!(!of(&text.replace("M10", "M12"))[0].faults.is_empty(), "{family:?}: {text}");
        }
    }
}

#[test]
fn comments_and_numbers_hide_nothing_of_a_line_of_the_shop() {
    let lines = || vec![own("M10", OwnPlace::Clamp { axis: 0, on: true })];
    let wrong = [
        (Family::Fanuc, &["(M10)", "M10 ; G0 X500.", "M10 N5", "N5.5 M10", "M10 (A", "M10 A)", "N5 N6 M10"][..]),
        (Family::LinuxCnc, &["M10 (PROBEOPEN a)", "M10 ;py,x()", "(A) N5 M10", "; M10 X"]),
        (Family::Siemens, &["M10 N5", "M10 (A)", "N5.5 M10"]),
        (Family::Heidenhain, &["0M10", "0 M10 (A)", "0 M10 ~"]),
    ];
    for (family, texts) in wrong {
        for text in texts {
            let blocks = with(family, lines(), &[], &format!("{text}\n0 M8\n"));
            let comment = text.starts_with(['(', ';']) && !text.contains(") ");
            assert!(comment || !blocks[0].faults.is_empty(), "{family:?}: {text}");
            assert!(!comment || blocks[0].state.clamps_known == 0, "{family:?}: {text}");
        }
    }
    // A word with a declared effect is not looked for in a comment.
    let lines = vec![own("T{tool} M6 M77", OwnPlace::ToolChange)];
    let of = |text: &str| with(Family::Fanuc, lines.clone(), &[("M77", Effect::Coolant)], text);
    let (inside, beside) = (of("T5 M6 (M77 )\n"), of("N5 T5 (MILL) M6 M77 (M78)\n"));
    assert_eq!((&inside[0].faults[..], &inside[0].own), (&[][..], &None));
    assert_eq!((&beside[0].faults[..], places(&beside[0])), (&[][..], &[OwnPlace::ToolChange][..]));
}

#[test]
fn after_a_lost_state_tip_control_and_plane_are_unknown_until_they_are_programmed() {
    const ISO: &str = "G21 G17 G40 G49 G80 G90 G94 G54\n";
    const HEIDENHAIN: &str = "0 BEGIN PGM A MM\n1 M77\n";
    let lines = |family: Family| {
        let [on, off] = [true, false].map(|on| OwnPlace::TipControl { on });
        let mut lines = vec![own("M77", OwnPlace::ToolChange)];
        if family == Family::LinuxCnc {
            lines.extend([own("M428", on), own("M429", off)]);
        }
        lines
    };
    let of = |family: Family, program: &str| {
        let blocks = with(family, lines(family), &[("M77", Effect::StateLost)], program);
        let faults: Vec<String> =
            blocks.iter().flat_map(|block| &block.faults).map(|fault| fault.text.clone()).collect();
        (blocks.last().expect("a block").known, faults)
    };
    let motion = "G0 X1. Y2. Z3. B0. C0.\n";
    let plane = "G68.2 X0. Y0. Z0. I0. J30. K0.\nG69\n";
    // The safety lines of a posted program: those of planes and tip control are options on Fanuc, Haas and LinuxCNC.
    for (family, program) in [
        (Family::LinuxCnc, format!("M77\n{ISO}{motion}")),
        (Family::LinuxCnc, format!("{ISO}M428\nM429\nM77\n{ISO}M429\n{motion}")),
        (Family::Fanuc, format!("M77\n{ISO}{motion}")),
        (Family::Haas, format!("M77\n{ISO}{motion}")),
        (Family::Fanuc, format!("{ISO}{plane}M77\n{ISO}G69\n{motion}")),
        (Family::Fanuc, format!("{ISO}G43.4 H1\nG49\nM77\n{ISO}{motion}")),
        (Family::Siemens, "M77\nTRAFOOF\nCYCLE800()\nG710 G17 G40 G64 G90 G94 G54\nG0 X1 Y2 Z3 B0 C0\n".to_owned()),
    ] {
        assert_eq!(of(family, &program), (0b11111, Vec::new()), "{family:?}: {program}");
    }
    let safe = "2 M129\n3 PLANE RESET STAY\n4 L X+1 Y+2 Z+3 B+0 C+0 R0 FMAX\n";
    assert_eq!(of(Family::Heidenhain, &format!("{HEIDENHAIN}{safe}")), (0b11111, Vec::new()));
    // One of the two is missing.
    for (family, program) in [
        (Family::LinuxCnc, format!("{ISO}M428\nM429\nM77\n{ISO}{motion}")),
        (Family::Fanuc, format!("{ISO}{plane}M77\n{ISO}{motion}")),
        (Family::Fanuc, format!("{ISO}G43.4 H1\nM77\n{}G69\n{motion}", ISO.replace("G49 ", ""))),
        (Family::Fanuc, format!("{ISO}M77\n{motion}")),
        (Family::Siemens, "M77\nTRAFOOF\nG710 G17 G40 G64 G90 G94 G54\nG0 X1 Y2 Z3 B0 C0\n".to_owned()),
        (Family::Siemens, "M77\nCYCLE800()\nG710 G17 G40 G64 G90 G94 G54\nG0 X1 Y2 Z3 B0 C0\n".to_owned()),
        (Family::Heidenhain, format!("{HEIDENHAIN}2 M129\n3 L X+1 Y+2 Z+3 B+0 C+0 R0 FMAX\n")),
        (Family::Heidenhain, format!("{HEIDENHAIN}2 PLANE RESET STAY\n3 L X+1 Y+2 Z+3 B+0 C+0 R0 FMAX\n")),
    ] {
        let (known, faults) = of(family, &program);
        assert_eq!(known, 0, "{family:?}: {program}");
        assert!(faults.iter().any(|text| text.contains("state lost")), "{family:?}: {program}: {faults:?}");
    }
    // The retract in machine coordinates needs neither.
    assert_eq!(of(Family::Fanuc, &format!("{ISO}{plane}M77\n{ISO}G53 G0 Z0.\n")), (0, Vec::new()));
}

#[test]
fn a_line_that_changes_the_tool_has_the_tool_of_its_field() {
    let of = |family: Family, template: &str, by_name: bool, program: &str| {
        let vocabulary = Vocabulary {
            own: vec![own(template, OwnPlace::ToolChange)],
            effects: vec![(template.as_bytes().to_vec(), Effect::ToolChange)],
            tools_by_name: by_name,
            ..vocabulary(family)
        };
        let mut reader = Reader::new(program.as_bytes(), vocabulary);
        let mut last = None;
        while let Some((block, _)) = reader.next_block().expect("text in memory") {
            last = Some(block.clone());
        }
        last.expect("a block")
    };
    let macro_call = "G65 P9001 T{tool} H{offset}";
    for (family, template, by_name, line, tool) in [
        (Family::Fanuc, macro_call, false, "N5 G65 P9001 T12 H3 (DRILL)", 12),
        (Family::Haas, macro_call, false, "G65  P9001 T12", 12),
        (Family::LinuxCnc, "O<change> CALL [{tool}]", false, "O<change> CALL [12]", 12),
        (Family::Siemens, "L9001({tool})", false, "L9001(12)", 12),
        (Family::Siemens, "CHANGE T{tool} D1", true, "CHANGE T=\"MILL 10\" D1", 7),
        (Family::Heidenhain, "CALL PGM CHANGE Q{tool}", false, "1 CALL PGM CHANGE Q12", 12),
        (Family::Heidenhain, "CALL PGM CHANGE {tool}", true, "1 CALL PGM CHANGE \"MILL 10\"", 7),
    ] {
        let head = if family == Family::Heidenhain { "0 M8\n".to_owned() } else { HEAD.to_owned() };
        let block = of(family, template, by_name, &format!("{head}{line}\n"));
        assert_eq!(block.faults, [], "{line}");
        assert_eq!((block.action, block.state.tool, block.state.spindle), (Action::ToolChange, Some(tool), Some(None)));
        assert_eq!((block.known, places(&block)), (0, &[OwnPlace::ToolChange][..]), "{line}");
        let length = if family == Family::Heidenhain { Some(Length::Register(tool)) } else { None };
        assert_eq!(block.state.length, length, "{line}");
    }
    // No tool, no tool of the configuration, and a tool that is called in the other way.
    for (by_name, line, text) in [
        (false, "G65 P9001", "without a tool number"),
        (false, "G65 P9001 T5.", "no tool of the configuration"),
        (true, "G65 P9001 T5", "expected its name"),
        (false, "G65 P9001 T=\"7\"", "expected its number"),
        (true, "G65 P9001 T=\"MILL\"", "no tool of the configuration"),
    ] {
        let block = of(Family::Fanuc, macro_call, by_name, &format!("{line}\n"));
        assert!(block.faults.iter().any(|fault| fault.text.contains(text)), "{line}: {:?}", block.faults);
    }
}

#[test]
fn the_unit_of_a_program_in_statements_cannot_be_lost() {
    let of = |family: Family, program: &str| {
        let blocks = with(family, vec![own("M77", OwnPlace::Start)], &[("M77", Effect::StateLost)], program);
        blocks.last().expect("a block").state
    };
    let state = of(Family::Heidenhain, "0 BEGIN PGM A MM\n1 M77\n");
    assert_eq!((state.units, state.incremental), (Some(Units::Millimetres), Some(false)));
    assert_eq!((state.feed_mode, state.lost_at), (None, Some(2)));
    assert_eq!(of(Family::Heidenhain, "0 BEGIN PGM A MM\n1 M77\n2 M137\n").feed_mode, Some(FeedMode::PerMinute));
    assert_eq!(of(Family::Fanuc, &format!("{HEAD}M77\n")).units, None);
}
