//! Operations that are posted alone, and clamps of rotary axes.

use super::*;
use crate::options::Operations;

const FOUR: &str = "\
UNITS/MM
TOOL PATH/ROUGH,TOOL,D10
LOADTL/1
SPINDL/RPM,6000,CLW
COOLNT/ON
FEDRAT/MMPM,800
GOTO/0,0,2,0,0,1
GOTO/9,0,2
TOOL PATH/SIDE,TOOL,D10
GOTO/25,0,0,-0.5,0,0.8660254
GOTO/25,8,0
STOP
PPRINT NOW THE FINISH
TOOL PATH/FINISH,TOOL,D6
LOADTL/2
SPINDL/RPM,9000,CLW
GOTO/25,9,0,0.6,0,0.8
GOTO/25,19,0
RAPID
GOTO/25,19,80
TOOL PATH/CHAMFER,TOOL,D6
GOTO/5,9,0,0,0.6,0.8
GOTO/5,19,0
FINI
";

/// The blocks of each operation by its number: from its restart point to that of the next.
fn by_operation(text: &str) -> std::collections::BTreeMap<u64, Vec<&str>> {
    let mut operations = std::collections::BTreeMap::new();
    let mut number = 0;
    for line in text.lines() {
        let restart = line.strip_prefix('N').and_then(|rest| rest.split(' ').next()?.parse().ok());
        number = restart.unwrap_or(number);
        operations.entry(number).or_insert_with(Vec::new).push(line);
    }
    operations
}

/// Blocks that move the tool in the coordinates of the program.
fn moving<'l>(lines: &[&'l str]) -> Vec<&'l str> {
    let moves = |line: &&&str| line.contains(['X', 'Y', 'Z', 'B', 'C']) && !line.contains('(') && !line.contains("G53");
    lines.iter().filter(moves).copied().collect()
}

#[test]
fn an_operation_that_is_posted_alone_moves_as_it_does_in_the_whole_program() {
    let (whole, report) = posted::<Cb>(&Config::default(), FOUR);
    assert!(!report.failed, "{report:?}");
    let all = by_operation(&whole);
    for (first, last) in [(1, 1), (1, 2), (2, 2), (2, 3), (3, 4), (4, 4)] {
        let operations = Some(Operations::Range(first, Some(last)));
        let mut config = Config::default();
        config.motion.selected = operations;
        let (text, report) = posted::<Cb>(&config, FOUR);
        assert!(!report.failed && text.ends_with("M5\nM2\n"), "{report:?}\n{text}");
        assert!(text.contains(&format!("only operations {first} to {last} of 4")), "{text}");
        assert_eq!(report.tools.len(), if (first, last) == (2, 3) { 2 } else { 1 });
        let some = by_operation(&text);
        let restarts: Vec<u64> = some.keys().copied().filter(|number| *number > 0).collect();
        assert_eq!(restarts, (first..=last).collect::<Vec<_>>(), "{text}");
        for (number, blocks) in some.iter().filter(|(number, _)| **number > 0) {
            assert_eq!(moving(blocks), moving(&all[number]), "N{number} of {first}..{last}\n{text}\n{whole}");
            assert!(blocks.contains(&"M8"), "the coolant that was asked for before");
        }
        assert_eq!(report.statistics.motions, 2 * (last - first + 1) + u64::from(first <= 3 && last >= 3));
        let top: Vec<&str> = blocks(&text).into_iter().filter(|block| !block.starts_with('(')).collect();
        assert!(top[0].starts_with('N') && top[3].ends_with(" M6"), "{top:?}");
    }
}

#[test]
fn without_transitions_an_operation_that_is_posted_alone_is_entered_and_left_safely() {
    let operations = Some(Operations::Range(2, Some(2)));
    let transition = crate::options::Transition::Direct;
    let mut config = Config::default();
    config.motion.selected = operations;
    config.motion.rapids.transition = transition;
    let (text, report) = posted::<Cb>(&config, FOUR);
    assert!(!report.failed, "{report:?}");
    let blocks = blocks(&text);
    assert!(blocks[0].starts_with("N2 G21") && blocks.contains(&"T1 M6"), "{text}");
    assert!(text.ends_with("G53 G0 Z0\nM5\nM2\n"), "{text}");
    let moving: Vec<&str> = moving(&blocks).into_iter().filter(|block| block.contains(['X', 'Y'])).collect();
    assert_eq!(moving.len(), 2, "above the first point, and to the second: {text}");
}

#[test]
fn records_between_operations_belong_to_the_operation_they_refer_to() {
    let some = |first, last| {
        let operations = Some(Operations::Range(first, Some(last)));
        let mut config = Config::default();
        config.motion.selected = operations;
        posted::<Cb>(&config, FOUR).0
    };
    let second = some(2, 2);
    assert!(second.contains("(OPERATION SIDE)") && second.contains("M0") && !second.contains("FINISH"), "{second}");
    assert!(second.contains("S6000 M3") && second.contains("T1 M6"), "{second}");
    let third = some(3, 4);
    assert!(third.contains("(NOW THE FINISH)\n(OPERATION FINISH)\nN3 "), "{third}");
    assert!(!third.contains("M0\n") && !third.contains("SIDE"), "{third}");
}

#[test]
fn operations_are_found_by_name_and_a_missing_one_is_reported() {
    let post = |operations| {
        let mut config = Config::default();
        config.motion.selected = Some(operations);
        let job = Job { cl_name: "a", config: &config, control: &LinuxCnc, units: None };
        let mut out = Vec::new();
        post::<Cb>(&job, &mut Cursor::new(FOUR.as_bytes()), &mut out).map(|_| String::from_utf8(out).expect("ASCII"))
    };
    let named = |name: &str| post(Operations::From(name.to_owned()));
    assert_eq!(named("finish").expect("there"), post(Operations::Range(3, None)).expect("there"));
    let said = |result: Result<String, PostError>| result.expect_err("not there").to_string();
    assert_eq!(said(named("FINISHH")), "no operation of the CL data is called `FINISHH`: did you mean `FINISH`?");
    assert!(said(named("x")).contains("its operations are `ROUGH`, `SIDE`, `FINISH`, `CHAMFER`"));
    assert_eq!(said(post(Operations::Range(3, Some(5)))), "the CL data has 4 operations: there is no operation 5");
    assert!(said(post(Operations::Range(7, None))).contains("no operation 7"));
}

#[test]
fn clamps_hold_the_axes_of_an_operation_that_does_not_turn_them() {
    let mut config = Config::default();
    let codes = crate::options::ClampCodes { on: "M10".to_owned(), off: "M11".to_owned() };
    config.motion.rotaries.clamp.insert('C', codes);
    let (text, report) = posted::<Cb>(&config, FOUR);
    assert!(!report.failed, "{report:?}");
    assert_eq!(text.matches("\nM11\nG0 B").count(), 4, "{text}");
    assert_eq!(text.matches("\nM10\n").count(), 4, "{text}");
    let (plain, _) = posted::<Cb>(&Config::default(), FOUR);
    assert_eq!(text.replace("M10\n", "").replace("M11\n", ""), plain);
}

#[test]
fn the_last_operation_that_is_posted_is_left_along_the_tool() {
    let mut config = Config::default();
    config.motion.selected = Some(Operations::Range(1, Some(1)));
    config.motion.rapids.transition = crate::options::Transition::Direct;
    config.motion.retract.distance_mm = Some(12.0);
    let (text, report) = posted::<Cb>(&config, FOUR);
    assert!(!report.failed, "{report:?}");
    assert!(text.ends_with("\nM9\nG0 Z14\nG53 G0 Z0\nM5\nM2\n"), "{text}");
}

#[test]
fn a_rapid_before_the_first_tool_is_no_operation() {
    let early = FOUR.replace("TOOL PATH/ROUGH", "RAPID\nGOTO/0,0,90,0,0,1\nTOOL PATH/ROUGH");
    let operations = Some(Operations::Range(4, None));
    let mut config = Config::default();
    config.motion.selected = operations;
    let (text, report) = posted::<Cb>(&config, &early);
    assert!(!report.failed && report.set_up[0].contains("4 to 4 of 4"), "{report:?}");
    assert!(text.contains("(OPERATION CHAMFER)\nN4 "), "{text}");
}

/// The last operation holds B, which the one before it rotates at feed.
const TURNS_THEN_HOLDS: &str = "\
UNITS/MM
LOADTL/1
SPINDL/RPM,6000,CLW
FEDRAT/MMPM,800
TOOL PATH/FIRST,TOOL,D10
RAPID
GOTO/0,0,20,0,0,1
GOTO/0,0,0
TOOL PATH/TURNS,TOOL,D10
GOTO/5,0,0,0.1,0,0.99498743710662
GOTO/10,0,0,0.2,0,0.9797958971132712
GOTO/12,0,30
LOADTL/2
SPINDL/RPM,6000,CLW
TOOL PATH/HOLDS,TOOL,D6
RAPID
GOTO/0,0,20,0,0,1
GOTO/0,0,0
GOTO/9,0,0
";

#[test]
fn clamps_of_some_operations_are_open_where_these_turn_an_axis() {
    let mut config = Config::default();
    let codes = crate::options::ClampCodes { on: "M12".to_owned(), off: "M13".to_owned() };
    config.motion.rotaries.clamp.insert('B', codes);
    config.motion.rapids.transition = crate::options::Transition::Direct;
    config.motion.retract.distance_mm = Some(50.0);
    for operations in [None, Some(Operations::Range(2, Some(3)))] {
        config.motion.selected = operations;
        let (text, report) = posted::<Cb>(&config, TURNS_THEN_HOLDS);
        assert!(!report.failed, "{report:?}");
        let (mut on, mut here, mut turns) = (None, None, 0);
        for line in text.lines().filter(|line| !line.starts_with('(')) {
            match line {
                "M12" => on = Some(true),
                "M13" => on = Some(false),
                _ => {}
            }
            let word = line.split(' ').find_map(|word| word.strip_prefix('B'));
            if let Some(there) = word.filter(|there| here != Some(*there)) {
                assert_eq!(on, Some(false), "B turns under its clamp in `{line}`:\n{text}");
                (here, turns) = (Some(there), turns + 1);
            }
        }
        assert!(turns > 3, "{text}");
    }
}
