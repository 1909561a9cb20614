//! Every word and every parameter of a cycle is executed, or is a fault.

use super::*;

const AT: &str = "G21 G17 G40 G49 G80 G90 G94 G54\nG0 X0. Y0. Z25. B0. C0.\nS500 M3\n";

fn holes(family: Family, text: &str) -> Vec<CycleMove> {
    let blocks = read(family, text);
    blocks.iter().for_each(|block| assert_eq!(block.faults, [], "{family:?}: {text}"));
    let cycles = blocks.iter().filter_map(|block| match block.action {
        Action::Cycle(cycle) => Some(cycle),
        _ => None,
    });
    cycles.collect()
}

#[test]
fn any_axis_word_or_r_drills_again_while_a_cycle_is_in_force() {
    for family in [Family::LinuxCnc, Family::Fanuc, Family::Haas] {
        let bottoms = |more: &str| -> Vec<f64> {
            let found = holes(family, &format!("{AT}G98 G81 X1. Y2. Z-10. R2. F100.\n{more}\nG80\n"));
            found.iter().map(|cycle| cycle.bottom).collect()
        };
        assert_eq!(bottoms(""), [-10.0]);
        assert_eq!(bottoms("Z-40."), [-10.0, -40.0], "{family:?}");
        assert_eq!(bottoms("G98 Z-40."), [-10.0, -40.0], "{family:?}");
        assert_eq!(bottoms("R-8."), [-10.0, -10.0], "{family:?}");
        match family {
            // It takes no word of a rotary axis in the block of a cycle: interp_cycles.cc, convert_cycle.
            Family::LinuxCnc => {
                let found = faults(family, &format!("{AT}G98 G81 X1. Y2. Z-10. R2. F100.\nC5.\n"));
                assert!(found[0].contains("a word of a rotary axis"), "{found:?}");
            }
            _ => assert_eq!(bottoms("C5."), [-10.0, -10.0], "{family:?}"),
        }
        assert_eq!(bottoms("M8"), [-10.0], "{family:?}");
        // Without X and Y it drills where the tool is, unless a setting of the control is otherwise.
        let here = faults(family, &format!("{AT}G98 G81 Z-10. R2. F100.\nX5.\n"));
        assert_eq!(here.len(), usize::from(family == Family::Haas), "{family:?}: {here:?}");
    }
}

#[test]
fn repeat_counts_and_words_that_a_cycle_does_not_take_are_faults() {
    for family in [Family::LinuxCnc, Family::Fanuc, Family::Haas] {
        let texts = [
            "G81 X1. Y2. Z-10. R2. F9. L0",
            "G81 X1. Y2. Z-10. R2. F9. L3",
            "G81 X1. Y2. Z-10. R2. F9. K0",
            "G81 X1. Y2. Z-10. R2. P500 F9.",
            "G81 X1. Y2. Z-10. R2. Q1. F9.",
            "G83 X1. Y2. Z-10. R2. Q1. P500 F9.",
            "G83 X1. Y2. Z-10. R2. F9.",
            "G82 X1. Y2. Z-10. R2. F9.",
            "G81 X1. Y2. Z-10. F9.",
            "G81 X1. Y2. R2. F9.",
            "G83 X1. Y2. Z-10. R2. Q0. F9.",
            "G83 X1. Y2. Z-10. R2. Q1. I1. J1. K1. F9.",
            "G85 X1. Y2. Z-10. R2. P1 F9.",
            "G81 X1. Y2. Z10. R2. F9.",
            "G82 X1. Y2. Z-10. R2. P-5 F9.",
            "G82 X1. Y2. Z-10. R2. P5 F9.\nP7",
        ];
        for text in texts {
            assert!(!faults(family, &format!("{AT}G98 {text}\n")).is_empty(), "{family:?}: {text}");
        }
        for text in
            ["G81 X1. Y2. Z-10. R2. F9.", "G82 X1. Y2. Z-10. R2. P5 F9.\nX7. P7", "G83 X1. Y2. Z-10. R2. Q1. F9."]
        {
            let found = faults(family, &format!("{AT}G98 {text}\n"));
            assert!(found.is_empty(), "{family:?}: {text}: {found:?}");
        }
    }
}

#[test]
fn a_return_to_an_unknown_level_is_a_fault() {
    for family in [Family::LinuxCnc, Family::Fanuc, Family::Haas] {
        let cycle = |code: &str| faults(family, &format!("{AT}G53 G0 Z0.\n{code} G81 X1. Y2. Z-10. R2. F9.\n"));
        assert_eq!((cycle("G98").len(), cycle("G99").len()), (1, 0), "{family:?}");
    }
}

#[test]
fn a_thread_is_in_step_with_the_spindle_only_after_m29_on_fanuc() {
    let kind = |family: Family, text: &str| holes(family, &format!("{AT}{text}")).last().map(|cycle| cycle.kind);
    let thread = "G98 G84 X1. Y2. Z-10. R2. F500.\nX5.\nG80\n";
    assert_eq!(kind(Family::Fanuc, thread), Some(CycleKind::FloatingTap(1.0)));
    assert_eq!(kind(Family::Fanuc, &format!("M29 S500\n{thread}")), Some(CycleKind::Tap(1.0)));
    assert_eq!(kind(Family::Fanuc, &format!("M29 S500\n{thread}{thread}")), Some(CycleKind::FloatingTap(1.0)));
    assert_eq!(kind(Family::Haas, thread), Some(CycleKind::Tap(1.0)));
    assert_eq!(kind(Family::Haas, &thread.replace("G84", "G74")), Some(CycleKind::Tap(-1.0)));
    assert_eq!(kind(Family::LinuxCnc, thread), Some(CycleKind::FloatingTap(1.0)));
    assert!(!faults(Family::Haas, "M29 S500").is_empty());
}

#[test]
fn the_pitch_of_each_thread_is_that_of_the_f_in_force_in_its_block() {
    let pitches = |family: Family, text: &str| -> Vec<f64> {
        let found = holes(family, &format!("{AT}{text}G80\n"));
        let pitch = |cycle: &CycleMove| match cycle.kind {
            CycleKind::Tap(pitch) | CycleKind::FloatingTap(pitch) => pitch,
            other => panic!("{other:?}"),
        };
        found.iter().map(pitch).collect()
    };
    for family in [Family::LinuxCnc, Family::Fanuc, Family::Haas] {
        let thread = |more: &str| pitches(family, &format!("G98 G84 X1. Y2. Z-10. R2. F500.\n{more}"));
        assert_eq!(thread("X5.\nX6. F250.\nX7.\nS1000 X8.\nX9.\n"), [1.0, 1.0, 0.5, 0.5, 0.25, 0.25], "{family:?}");
        // F of an inverse-time feed is none of a thread, and holds for its block.
        let inverse = pitches(family, "G93 G98 G84 X1. Y2. Z-10. R2. F500.\nX5.\nX6. F500.\nG94 X7.\nX8.\n");
        assert_eq!(inverse, [0.0; 5], "{family:?}");
        assert_eq!(thread("G95 X5.\nX6.\nX7. F1.5\nX8.\n"), [1.0, 0.0, 0.0, 1.5, 1.5], "{family:?}");
        // LinuxCNC loses F with each code of a feed mode.
        let same = if family == Family::LinuxCnc { 0.0 } else { 1.0 };
        assert_eq!(thread("G94 X5.\nX6.\n"), [1.0, same, same], "{family:?}");
    }
}

#[test]
fn a_hole_that_is_drilled_again_keeps_its_levels_and_its_modes() {
    for family in [Family::LinuxCnc, Family::Fanuc, Family::Haas] {
        let blocks = read(
            family,
            &format!("{AT}G99 G83 X1. Y2. Z-10. R2. Q3. F100.\nX5.\n X6. Y7.\nX7. Z-11.\nX8. F50.\nX9.\n"),
        );
        let holes: Vec<_> = blocks
            .iter()
            .filter_map(|block| match block.action {
                Action::Cycle(cycle) => Some((cycle.bottom, cycle.back_to, block.only_moves, block.state.feed)),
                _ => None,
            })
            .collect();
        let expected = [
            (-10.0, false, 100.0),
            (-10.0, true, 100.0),
            (-10.0, true, 100.0),
            (-11.0, true, 100.0),
            (-11.0, true, 50.0),
            (-11.0, true, 50.0),
        ];
        let expected: Vec<_> = expected.map(|(bottom, again, feed)| (bottom, 2.0, again, Some(feed))).to_vec();
        assert_eq!(holes, expected, "{family:?}");
    }
}

#[test]
fn after_a_cycle_that_may_have_been_skipped_none_is_known() {
    for family in [Family::LinuxCnc, Family::Fanuc, Family::Haas] {
        let text = format!("{AT}G98 G81 X1. Y2. Z-10. R2. F100.\n/ X5. Z-6.\nX6.\n");
        assert_eq!(faults(family, &text).len(), 1, "{family:?}");
        let same = format!("{AT}G98 G81 X1. Y2. Z-10. R2. F100.\n/ X5.\nX6.\n");
        assert_eq!(faults(family, &same).len(), 0, "{family:?}");
    }
}

const PECKING: &str = "CYCL DEF 205 UNIVERSAL PECKING ~\n Q200=+2 ~\n Q201=-10 ~\n Q206=+100 ~\n Q202=+3 ~\n Q203=+0 ~\n \
    Q204=+25 ~\n Q212=+0 ~\n Q205=+0 ~\n Q258=+0.5 ~\n Q259=+0.5 ~\n Q257=+0 ~\n Q256=+0.2 ~\n Q211=+1 ~\n Q379=+0 ~\n Q253=+99999";
const BREAKING: &str = "CYCL DEF 203 UNIVERSAL DRILLING ~\n Q200=+2 ~\n Q201=-10 ~\n Q206=+100 ~\n Q202=+3 ~\n Q210=+0 ~\n \
    Q203=+0 ~\n Q204=+25 ~\n Q212=+0 ~\n Q213=+4 ~\n Q205=+0 ~\n Q211=+1 ~\n Q208=+99999 ~\n Q256=+0.4";

fn called(definition: &str) -> String {
    format!("{TNC}2 L X+0 Y+0 Z+25 R0 FMAX\n3 {definition}\n4 L X+1 Y+2 R0 FMAX M99\n")
}

#[test]
fn every_parameter_of_a_heidenhain_cycle_is_executed_or_must_have_its_value() {
    let wanted = CycleMove {
        kind: CycleKind::Peck(3.0),
        over: Some(25.0),
        reference: 2.0,
        bottom: -10.0,
        back_to: 25.0,
        dwell: 1.0,
        feed: Some(100.0),
        gap: Some(0.5),
    };
    assert_eq!(holes(Family::Heidenhain, &called(PECKING)), [wanted]);
    let breaking = CycleMove { kind: CycleKind::ChipBreak(3.0), gap: Some(0.4), ..wanted };
    assert_eq!(holes(Family::Heidenhain, &called(BREAKING)), [breaking]);
    let changes = [
        (PECKING, "Q379=+0", "Q379=+5", "Q379"),
        (PECKING, "Q259=+0.5", "Q259=+3", "Q259 is 3"),
        (PECKING, "Q205=+0", "Q205=+1", "Q205"),
        (PECKING, "Q212=+0", "Q212=+0.5", "Q212 (decrement) of CYCL DEF 205 is 0.5, expected 0"),
        (PECKING, "Q257=+0", "Q257=+2", "Q257"),
        (PECKING, "Q253=+99999", "Q253=+10", "Q253"),
        (PECKING, " Q211=+1 ~\n", "", "Q211 (dwell at depth) of CYCL DEF 205 is missing"),
        (PECKING, "Q202=+3", "Q202=+Q5", "expected Q and a number"),
        (PECKING, "Q202=+3", "Q202=+3 Q202=+4", "twice"),
        (PECKING, "Q202=+3", "Q999=+3", "Q999"),
        (PECKING, "Q201=-10", "Q201=+10", "not negative"),
        (BREAKING, "Q208=+99999", "Q208=+50", "Q208"),
        (BREAKING, "Q213=+4", "Q213=+1", "fewer chip breaks"),
        (BREAKING, "Q210=+0", "Q210=+1", "Q210"),
        (BREAKING, "203", "207", "Q206"),
    ];
    for (definition, from, to, text) in changes {
        let found = faults(Family::Heidenhain, &called(&definition.replacen(from, to, 1)));
        assert!(found.iter().any(|fault| fault.contains(text)), "{to}: {found:?}");
    }
    // A comment ends at the mark that continues the line.
    let commented = PECKING.replace("Q202=+3 ~", "Q202=+3 ;Q201=-50 ~");
    assert_eq!(holes(Family::Heidenhain, &called(&commented)), [wanted]);
}

#[test]
fn parameters_of_the_cycle_in_force_cannot_be_changed() {
    for text in ["FN 0: Q201 = -50", "FN 1: Q201 = -5 + -5", "FN 18: SYSREAD Q201 = ID50 NR1 IDX3", "Q201 = -50"] {
        let program = called(PECKING).replace("4 L", &format!("4 {text}\n5 L"));
        assert!(!faults(Family::Heidenhain, &program).is_empty(), "{text}");
    }
}

#[test]
fn every_argument_of_a_siemens_cycle_is_executed_or_must_have_its_value() {
    let called = |call: &str| format!("{SIEMENS}F100\nS500 M3\nMCALL {call}\nG0 X1 Y2\nMCALL\n");
    let deep = "CYCLE83(25,0,2,-10,,,3,0,0,0,1,1,,,,1.5,0.5)";
    let wanted = CycleMove {
        kind: CycleKind::Peck(3.0),
        over: None,
        reference: 2.0,
        bottom: -10.0,
        back_to: 25.0,
        dwell: 1.5,
        feed: None,
        gap: Some(0.5),
    };
    assert_eq!(holes(Family::Siemens, &called(deep)), [wanted]);
    let breaking = "CYCLE83(25,0,2,-10,,,3,0,0,0,1,0,,,0.4,1.5)";
    let broken = CycleMove { kind: CycleKind::ChipBreak(3.0), gap: Some(0.4), ..wanted };
    assert_eq!(holes(Family::Siemens, &called(breaking)), [broken]);
    let thread = "CYCLE84(25,0,2,-10,,0,3,,1.5,0,500,500,,1)";
    assert_eq!(holes(Family::Siemens, &called(thread))[0].kind, CycleKind::Tap(1.5));
    let inch = called(thread).replace("G710", "G700").replace(",1)", ",3)");
    assert_eq!(holes(Family::Siemens, &inch)[0].kind, CycleKind::Tap(1.5 * 25.4));
    let wrong = [
        (deep, "3,0,0,0,1,1", "3,1,0,0,1,1", "DAM of CYCLE83 is 1, expected 0"),
        (deep, "3,0,0,0,1,1", "3,0,2,0,1,1", "DTB"),
        (deep, "3,0,0,0,1,1", "3,0,0,2,1,1", "DTS"),
        (deep, "3,0,0,0,1,1", "3,0,0,0,0.5,1", "FRF of CYCLE83 is 0.5, expected 1"),
        (deep, "3,0,0,0,1,1", "3,0,0,0,1,2", "VARI"),
        (deep, ",,,3,", ",,5,3,", "FDEP"),
        (deep, "0.5)", "0.5,7)", "arguments of CYCLE83"),
        (deep, "25,0", "R1,0", "arguments of CYCLE83"),
        (deep, "25,0", ",0", "RTP"),
        (deep, "-10,,", "-10,10,", "DP or DPR"),
        (thread, "0,3,", "0,4,", "SDAC"),
        (thread, "500,500", "500,800", "SST"),
        (thread, "500,500", "600,600", "SST"),
        (thread, "1.5,0,", "1.5,90,", "POSS"),
        (thread, ",1)", ",2)", "_PITA"),
        (thread, ",1)", ",0)", "_PITA"),
        ("CYCLE85(25,0,2,-10,,0,100,100)", "100,100", "100,300", "RFF of CYCLE85 is 300, expected 100"),
        ("CYCLE81(25,0,2,-10)", "-10)", "-10,,3)", "arguments of CYCLE81"),
    ];
    for (call, from, to, text) in wrong {
        let changed = call.replacen(from, to, 1);
        assert_ne!(changed, call);
        let found = faults(Family::Siemens, &called(&changed));
        assert!(found.iter().any(|fault| fault.contains(text)), "{changed}: {found:?}");
    }
    let plane = "CYCLE800(0,\"TC\",0,57,0,0,0,30,0,0,0,0,0,-1,0)";
    assert_eq!(faults(Family::Siemens, &format!("{SIEMENS}{plane}\n")), [""; 0]);
    let changes = [
        ("(0,\"TC\"", "(1,\"TC\""),
        ("\"TC\"", "\"HEAD\""),
        ("\"TC\",0", "\"TC\",1"),
        (",57,", ",192,"),
        (",57,", ",57.5,"),
        (",-1,0)", ",-2,0)"),
        (",-1,0)", ",-1,5)"),
        (",-1,0)", ",-1,0,1)"),
        ("30,0,0", "30,,0"),
    ];
    for (from, to) in changes {
        let changed = plane.replacen(from, to, 1);
        assert!(!faults(Family::Siemens, &format!("{SIEMENS}{changed}\n")).is_empty(), "{changed}");
    }
}
