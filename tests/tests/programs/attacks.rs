//! Edits that were, or could have been, overlooked by the check: each is made in posted programs of every control and
//! mode that has a place for it, and found; the programs before the edit have no findings.

use std::fs;

use pp_runtime::config::Mode::{self, Axes, Plane, Tcp};
use tests::binaries::workspace;
use tests::edits::{Case, Posted, Subject, Verdict, verdict};
use tests::foreign::{Effect, run};

/// Where an edit is made.
#[derive(Debug, Clone, Copy)]
enum Place {
    /// In a cut: at a straight cut after another one.
    Cut,
    /// The same in the operation whose plane is tilted.
    TiltedCut,
    /// At a hole after another one, the cycle in force.
    NextHole,
    /// At the block after the last hole of a cycle.
    AfterHoles,
    /// At the first dwell.
    Dwell,
    /// At the line with this text, counted from 0.
    Text(&'static str, usize),
}

use Place::{AfterHoles, Cut, Dwell, NextHole, Text, TiltedCut};

/// What becomes of the line.
#[derive(Debug, Clone, Copy)]
enum Change {
    /// Lines before it.
    Before(&'static str),
    /// Lines after it.
    After(&'static str),
    /// Text at its end.
    Append(&'static str),
    /// It is another line.
    Line(&'static str),
    /// A text in it is another text.
    Replace(&'static str, &'static str),
    /// It ends with another text, from this one on.
    From(&'static str, &'static str),
    /// It and the lines that follow are lost.
    Delete(usize),
    /// It and the line before it are lost.
    DeleteWithBefore,
    /// Every line that is this text, but for a block number, is lost.
    DeleteEvery(&'static str),
}

use Change::{After, Append, Before, Delete, DeleteEvery, DeleteWithBefore, From, Line, Replace};

/// Programs and the edits that are made in each of them.
struct Row {
    controls: &'static [&'static str],
    modes: &'static [Mode],
    /// Keys besides those of the part.
    config: &'static str,
    edits: &'static [(Place, Change)],
}

const ISO: &[&str] = &["linuxcnc", "fanuc", "haas"];
const HEIDENHAIN: &[&str] = &["heidenhain"];
const ALL: &[Mode] = &[Axes, Tcp, Plane];
const GUARD: &str = "length_guard = true\n";

/// The machines: rotary axes in the table, and in the head.
const MACHINES: [&str; 2] = ["spinner-u5-620", "lola-xoyzba"];

/// Keys of the part, and more of them before its first section.
fn config(machine: &str, control: &str, mode: Mode, more: &str) -> String {
    let file = if machine == "lola-xoyzba" { "works" } else { "table" };
    let part = fs::read_to_string(workspace().join(format!("tests/data/works/{file}.toml"))).expect("a configuration");
    let (keys, sections) = more.split_at(more.find('[').unwrap_or(more.len()));
    let tip = if control == "linuxcnc" && mode == Tcp { "[control]\ntip_control = [\"M428\", \"M429\"]\n" } else { "" };
    format!("{keys}{part}\n{sections}\n{tip}")
}

fn posted(machine: &str, control: &str, mode: Mode, more: &str) -> Option<Posted> {
    if control == "linuxcnc" && mode == Plane {
        return None;
    }
    let cl = fs::read(workspace().join("tests/data/works/works.cls")).expect("CL data");
    let name = format!("{machine} {control} {}", mode.name());
    let operations = Some((
        1,
        match mode {
            Axes | Mode::Auto => 5,
            Tcp => 4,
            Plane => 3,
        },
    ));
    let config = config(machine, control, mode, more);
    let case = Case {
        name: &name,
        machine,
        control,
        mode,
        operations,
        config: &config,
        cl: &cl,
        idle: &["M98 P9000", "L100"],
    };
    let posted = Posted::of(&case).unwrap_or_else(|why| panic!("{name}: {why}"));
    let findings = posted.findings(&posted.text);
    assert!(findings.is_empty(), "{name} before the edit: {findings:?}");
    Some(posted)
}

/// Index of the line at a place.
fn place(subject: &Subject, place: Place) -> Option<usize> {
    let blocks = &subject.trace.blocks;
    let pair = |from: usize, fits: fn(&Effect) -> bool| {
        let second = |pair: &&[tests::foreign::Executed]| pair[0].line >= from && pair.iter().all(|b| fits(&b.effect));
        blocks.windows(2).find(second).map(|pair| pair[1].line - 1)
    };
    let feed = |effect: &Effect| *effect == Effect::Feed;
    let hole = |effect: &Effect| matches!(effect, Effect::Hole(_));
    match place {
        Cut => pair(0, feed),
        TiltedCut => pair(subject.lines.iter().position(|line| line.contains("TILTED"))?, feed),
        NextHole => pair(0, hole),
        AfterHoles => {
            let last = |pair: &&[tests::foreign::Executed]| hole(&pair[0].effect) && !hole(&pair[1].effect);
            blocks.windows(2).find(last).map(|pair| pair[1].line - 1)
        }
        Dwell => blocks.iter().find(|block| matches!(block.effect, Effect::Dwell(_))).map(|block| block.line - 1),
        Text(text, number) => {
            let comment = |line: &str| line.starts_with(['(', ';', '*']) && !text.starts_with('(');
            let lines = subject.lines.iter().enumerate().filter(|(_, line)| line.contains(text) && !comment(line));
            lines.map(|(index, _)| index).nth(number)
        }
    }
}

/// Lines after an edit; `None` if it does not suit the line.
fn changed(subject: &Subject, index: usize, change: Change) -> Option<Vec<String>> {
    let mut lines = subject.lines.clone();
    let line = lines[index].clone();
    match change {
        Before(text) => lines.insert(index, text.to_owned()),
        After(text) => lines.insert(index + 1, text.to_owned()),
        Append(text) => lines[index] = format!("{line}{text}"),
        Line(text) => lines[index] = text.to_owned(),
        Replace(from, to) => lines[index] = line.contains(from).then(|| line.replacen(from, to, 1))?,
        From(from, to) => lines[index] = line[..line.find(from)?].to_owned() + to,
        Delete(count) => drop(lines.drain(index..index + count)),
        DeleteWithBefore => drop(lines.drain(index - 1..=index)),
        DeleteEvery(text) => lines.retain(|line| line != text),
    }
    (lines != subject.lines).then_some(lines)
}

/// Makes every edit of the rows, and panics with those that are not found.
fn all_are_found(rows: &[Row]) {
    let mut overlooked = Vec::new();
    for row in rows {
        let mut made = vec![0; row.edits.len()];
        for (machine, control, mode) in programs(row) {
            let Some(posted) = posted(machine, control, mode, row.config) else { continue };
            for ((at, change), made) in row.edits.iter().zip(&mut made) {
                let subject = &posted.subject;
                let Some(index) = place(subject, *at) else { continue };
                let Some(lines) = changed(subject, index, *change) else { continue };
                *made += 1;
                let text = subject.text(&lines);
                let harm = verdict(&subject.trace, &run(&text, &subject.options), subject.allowed);
                let harmful = matches!(harm, Verdict::Harmful(_) | Verdict::Refused(_));
                assert!(harmful, "{} {:?}: {at:?} {change:?} is {harm:?}", subject.name, subject.lines[index]);
                if posted.findings(&text).is_empty() {
                    overlooked.push(format!(
                        "{}, line {} `{}`: {change:?}",
                        subject.name,
                        index + 1,
                        subject.lines[index]
                    ));
                }
            }
        }
        for ((at, change), made) in row.edits.iter().zip(made) {
            assert!(made > 0, "no program of {:?} has a place for {at:?} {change:?}", row.controls);
        }
    }
    assert!(overlooked.is_empty(), "{} edits are not found:\n{}", overlooked.len(), overlooked.join("\n"));
}

fn programs(row: &Row) -> impl Iterator<Item = (&'static str, &'static str, Mode)> {
    let (controls, modes) = (row.controls, row.modes);
    let of_control = move |control: &'static str| modes.iter().map(move |mode| (control, *mode));
    let both = controls.iter().flat_map(move |control| of_control(control));
    both.flat_map(|(control, mode)| MACHINES.map(|machine| (machine, control, mode)))
}

/// Tests, each with its rows.
macro_rules! attacks {
    ($($(#[$meta:meta])* $name:ident: [$(($controls:expr, $modes:expr, $config:expr, $edits:expr)),* $(,)?];)*) => {
        $($(#[$meta])* #[test]
        fn $name() {
            all_are_found(&[$(Row { controls: $controls, modes: $modes, config: $config, edits: $edits }),*]);
        })*
    };
}

attacks! {
    a_reference_point_in_a_cut_or_between_holes_is_found: [
        (ISO, ALL, "", &[
            (Cut, Before("G28")), (Cut, Before("G30")), (NextHole, Before("G28")), (NextHole, Before("G30")),
            (Cut, Append(" G28")), (Cut, Before("G28 Z50.")), (Cut, Before("G91 G28 Z0.")),
        ]),
    ];
    a_reference_point_before_the_length_offset_or_the_tool_change_is_found: [
        (ISO, &[Axes, Plane], "", &[
            (Text("G43 H", 0), Before("G28 Z-200.")), (Text("G43 H", 1), Before("G28 Z-200.")),
            (Text("T1 M", 0), Before("G28 Z-100.")), (Text("T2 M", 0), Before("G28 Z-100.")),
        ]),
    ];
    a_plane_reset_that_moves_is_found: [
        (HEIDENHAIN, ALL, "", &[
            (Cut, Before("PLANE RESET TURN FMAX")), (Cut, Before("PLANE RESET TURN MB50 FMAX")),
            (Cut, Before("PLANE RESET MOVE DIST50 FMAX")), (TiltedCut, Before("PLANE RESET TURN FMAX")),
            (Text("PLANE RESET STAY", 0), Line("PLANE RESET TURN FMAX")),
            (Text("PLANE RESET STAY", 1), Line("PLANE RESET TURN MB50 FMAX")),
            (Text("PLANE RESET STAY", 2), Line("PLANE RESET MOVE DIST50 FMAX")),
        ]),
    ];
    a_rotary_word_in_a_tilted_plane_is_found: [
        (HEIDENHAIN, &[Plane], "", &[
            (TiltedCut, Before("L B+5 F500")), (TiltedCut, Before("L X+0 Y+0 B+5 F500")), (TiltedCut, Append(" B+5")),
        ]),
        (&["fanuc", "haas"], &[Plane], "", &[
            (TiltedCut, Before("G93 B5. F72.\nG94 F500.")), (TiltedCut, Before("B5.")), (TiltedCut, Append(" B5.")),
        ]),
        (&["siemens"], &[Plane], "", &[
            (TiltedCut, Before("G93 B5 F72\nG94 F500")), (TiltedCut, Before("B5")), (TiltedCut, Append(" B5")),
        ]),
    ];
    words_on_their_own_while_a_cycle_is_in_force_are_found: [
        (ISO, &[Axes, Plane], "", &[
            (AfterHoles, Before("Z-40.")), (AfterHoles, Before("R-8.")), (AfterHoles, Before("G98 Z-40.")),
            (NextHole, Before("Z-40.")), (NextHole, Before("R-8.")), (AfterHoles, Before("B5.")),
        ]),
    ];
    repeats_of_a_cycle_are_found: [
        (&["haas", "linuxcnc"], &[Axes], "", &[
            (AfterHoles, Before("X25. L0")), (AfterHoles, Before("X25. L3")), (NextHole, Append(" L3")),
            (NextHole, Append(" L0")),
        ]),
        (&["fanuc"], &[Axes], "", &[(NextHole, Append(" K3")), (NextHole, Append(" K0"))]),
    ];
    parameters_of_a_cycle_set_between_holes_are_found: [
        (HEIDENHAIN, &[Axes, Plane], "", &[
            (NextHole, Before("FN 0: Q201 = -50")), (NextHole, Before("FN 0: Q203 = +50")),
            (NextHole, Before("FN 0: Q200 = +20")), (NextHole, Before("FN 1: Q203 = +1 + +20")),
            (NextHole, Before("FN 18: SYSREAD Q201 = ID50 NR1 IDX1")), (NextHole, Before("Q201 = -50")),
        ]),
    ];
    every_parameter_of_a_cycle_is_compared: [
        (HEIDENHAIN, &[Axes, Plane], "", &[
            (Text("Q379=", 0), Replace("=+0", "=+5")), (Text("Q258=", 0), Replace("=+0.5", "=+9")),
            (Text("Q258=", 0), Replace("=+0.5", "=-9")), (Text("Q259=", 0), Replace("=+0.5", "=+9")),
            (Text("Q204=", 0), Replace("=+25", "=+40")), (Text("Q204=", 0), Replace("=+25", "=+3")),
            (Text("Q202=+4", 0), Replace("=+4", "=+2")), (Text("Q202=+6", 0), Replace("=+6", "=+3")),
            (Text("Q205=", 0), Replace("=+0", "=+1")), (Text("Q253=", 0), Replace("=+99999", "=+100")),
            (Text("Q210=", 0), Replace("=+0", "=+3")), (Text("Q211=", 0), Replace("=+0", "=+3")),
            (Text("Q212=", 0), Replace("=+0", "=+2")), (Text("Q257=", 0), Replace("=+0", "=+2")),
            (Text("Q208=+0", 0), Replace("=+0", "=+100")), (Text("Q213=", 0), Replace("=+3", "=+1")),
            (Text("Q256=+0.5", 0), Replace("=+0.5", "=+5")),
        ]),
    ];
    a_block_after_a_semicolon_is_found: [
        (&["fanuc", "haas"], ALL, "", &[
            (Cut, Append(";G0 Z-20.")), (Cut, Before(";X500.")), (Cut, Append(";M5")), (Cut, Before("M8;X0.")),
        ]),
    ];
    a_program_that_ends_in_the_middle_is_found: [
        (&["fanuc", "haas"], ALL, "", &[
            (Cut, Before("%")), (Cut, Before("O0002")), (Cut, Before("O0002 (OTHER)")), (Cut, Before("M30")),
            (Cut, Before("M2")), (Cut, Before("M99")),
        ]),
        (&["linuxcnc"], ALL, "", &[(Cut, Before("%")), (Cut, Before("M2")), (Cut, Before("M30"))]),
        (&["siemens"], ALL, "", &[
            (Cut, Before("RET")), (Cut, Before("M17")), (Cut, Before("M2")), (Cut, Before("M30")),
            (Cut, Append(" M30")),
        ]),
        (HEIDENHAIN, ALL, "", &[
            (Cut, Before("END PGM NONAME MM")), (Cut, Before("M2")), (Cut, Before("M30")), (Cut, Append(" M30")),
        ]),
    ];
    another_cycle_is_found: [
        (&["fanuc"], &[Axes], "", &[(Text("M29 S500", 0), Delete(1)), (Text("M29 S500", 0), Line("S500"))]),
        (&["fanuc", "haas", "linuxcnc"], &[Axes, Plane], "", &[(Text("G82", 0), Replace("G82", "G81"))]),
        (HEIDENHAIN, &[Axes], "", &[
            (Text("CYCL DEF 205", 0), Replace("205", "200")), (Text("CYCL DEF 205", 1), Replace("205", "203")),
            (Text("CYCL DEF 207", 0), Replace("207", "209")), (Text("CYCL DEF 201", 0), Replace("201", "200")),
        ]),
    ];
    another_tolerance_of_the_path_is_found: [
        (&["linuxcnc"], &[Axes, Tcp], "path_tolerance = 0.01\n", &[
            (Text("G64 P0.01", 0), Replace("G64 P0.01", "G64 P10")), (Text("G64 P0.01", 1), Replace("G64 P0.01", "G64")),
            (Text("G64 P0.01", 0), Replace(" G64 P0.01", "")), (Cut, Before("G64 P10")), (Cut, Before("G64")),
        ]),
        (&["siemens"], ALL, "path_tolerance = 0.01\n", &[
            (Cut, Before("CYCLE832(10,1,1)")), (Cut, Before("G641 ADIS=5")), (Cut, Before("G645")),
        ]),
        (&["siemens"], ALL, "path_tolerance = 0.01\n[control]\nsmoothing = \"finish\"\n", &[
            (Cut, Before("CYCLE832(10,1,1)")), (Text("CYCLE832(0.01", 0), Replace("0.01", "10")),
            (Text("CYCLE832(0.01", 0), Delete(1)),
        ]),
        (HEIDENHAIN, ALL, "path_tolerance = 0.01\n", &[(Cut, Before("CYCL DEF 32.0 TOLERANCE\nCYCL DEF 32.1 T5"))]),
        (HEIDENHAIN, ALL, "path_tolerance = 0.01\n[control]\nsmoothing = \"finish\"\n", &[
            (Cut, Before("CYCL DEF 32.0 TOLERANCE\nCYCL DEF 32.1 T5")),
            (Text("CYCL DEF 32.1 T0.01", 0), Replace("0.01", "5")),
        ]),
        (&["haas"], ALL, "path_tolerance = 0.01\n[control]\nsmoothing = \"finish\"\n", &[
            (Text("G187 P3 E0.01", 0), Replace("0.01", "0.5")), (Text("G187 P3 E0.01", 0), Delete(1)),
            (Cut, Before("G187 P1 E0.5")),
        ]),
        (&["fanuc"], ALL, "[control]\nsmoothing = \"finish\"\n", &[
            (Text("G05.1 Q1", 0), Delete(1)), (Cut, Before("G05.1 Q0")),
        ]),
    ];
    a_length_guard_that_guards_nothing_is_found: [
        (&["fanuc", "haas"], ALL, GUARD, &[
            (Text("IF [ABS", 0), Delete(1)), (Text("IF [ABS", 1), Delete(1)),
            (Text("IF [ABS", 0), Replace("GT 0.01", "GT 99")), (Text("IF [ABS", 0), From("THEN", "THEN #3000=0")),
            (Text("IF [ABS", 0), From("THEN", "GOTO 2")), (Text("IF [ABS", 1), From("THEN", "THEN #100=101")),
        ]),
        (&["fanuc"], ALL, GUARD, &[(Text("IF [ABS", 0), Replace("#10001+#11001", "#10002+#11002"))]),
        (&["haas"], ALL, GUARD, &[(Text("IF [ABS", 0), Replace("#2001 + #2201", "#2002 + #2202"))]),
        (&["linuxcnc"], &[Axes, Tcp], GUARD, &[
            (Text(" if [[ABS", 0), Delete(3)), (Text("(abort", 0), Replace("abort", "msg")),
            (Text(" if [[ABS", 0), From("GT 0.01] AND", "GT 99] AND [1 GT 2]]")), (Text(" if [[ABS", 0), Replace("GT 0.01] A", "GT 99] A")),
            (Text("(abort", 0), Delete(1)), (Text("(abort", 0), Replace("(abort", "/(abort")),
        ]),
        (&["siemens"], ALL, GUARD, &[
            (Text("IF ABS", 0), Delete(5)), (Text("IF ABS", 0), Replace(">0.01", ">99")),
            (Text("IF ABS", 0), Replace("P_TOOLL[1]", "P_TOOLL[2]")),
        ]),
        (HEIDENHAIN, ALL, GUARD, &[
            (Text("FN 18: SYSREAD QL1 = ID50", 0), Delete(9)), (Text("FN 18: SYSREAD QL1 = ID50", 0), Replace("IDX1", "IDX2")),
            (Text("FN 14: ERROR", 0), Delete(1)),
        ]),
    ];
    a_retract_by_a_distance_is_found: [
        (HEIDENHAIN, ALL, "", &[
            (Text("L Z+0 R0 FMAX M91", 0), Replace("L Z", "L IZ")), (Text("L Z+0 R0 FMAX M91", 1), Replace("L Z", "L IZ")),
            (Text("L Z+0 R0 FMAX M91", 2), Replace("L Z", "L IZ")), (Text("L Z+0 R0 FMAX M91", 3), Replace("L Z", "L IZ")),
        ]),
    ];
    coolant_on_and_off_in_one_block_is_found: [
        (&["linuxcnc", "fanuc", "siemens", "heidenhain"], ALL, "", &[
            (Text("M8", 0), Line("M8 M9")), (Cut, Before("M8 M9")), (Cut, Before("M9 M8")),
        ]),
        (&["haas"], ALL, "", &[(Text("M08", 0), Line("M08 M09")), (Cut, Before("M08 M09"))]),
    ];
    a_stray_motion_after_the_rotary_axes_of_an_approach_is_found: [
        (ISO, ALL, "", &[(Text("B25. ", 0), After("X500.")), (Text("B25 ", 0), After("X500")), (Text("B0", 0), After("X500."))]),
        (&["siemens"], ALL, "", &[(Text("B25", 0), After("X500")), (Text("B0", 0), After("X500"))]),
        (HEIDENHAIN, ALL, "", &[(Text("L B+25", 0), After("L X+500 R0 FMAX")), (Text("L A", 1), After("L X+500 R0 FMAX"))]),
    ];
    shortest_path_where_words_count_on_is_found: [
        (HEIDENHAIN, ALL, "", &[(Text("M127", 0), DeleteEvery("M127")), (Cut, Before("M126")), (Text("M127", 0), Line("M126"))]),
    ];
    a_lost_or_another_guard_of_rotary_positions_is_found: [
        (&["siemens"], &[Plane, Tcp], "", &[
            (Text("IF ABS(SIN", 0), Delete(5)), (Text("IF ABS(SIN", 0), Replace(">0.0009", ">0.9")),
            (Text("IF ABS(SIN", 0), Replace("/2))", "+40)/2))")), (Text("IF ABS(SIN", 0), Replace("-", "-1")),
        ]),
        (HEIDENHAIN, &[Plane, Tcp], "", &[
            (Text("FN 20: WAIT FOR SYNC", 0), Delete(8)), (Text("IF +QL3", 0), Replace("0.0009", "0.9")),
            (Text("QL3 =", 0), Replace("-", "+")), (Text("QL3 =", 0), Replace("QL2 ", "QL2 - 1 ")),
        ]),
    ];
    another_position_of_the_plane_is_found: [
        (HEIDENHAIN, &[Plane], "", &[
            (Text("SEQ+ COORD", 0), Replace("SEQ+", "SEQ-")),
            (Text("COORD ROT", 0), Replace("COORD ROT", "TABLE ROT")), (Text("COORD ROT", 1), Replace("COORD ROT", "TABLE ROT")),
        ]),
    ];
    the_work_offset_after_traori_is_required: [
        (&["siemens"], &[Tcp], "", &[(Text("TRAORI", 0), DeleteEvery("G54"))]),
    ];
    the_way_over_the_approach_point_of_tip_control_is_required: [
        (&["fanuc"], &[Tcp], "", &[
            (Text("G53.1", 0), Delete(2)), (Text("G53.1", 0), Delete(1)), (Text("G68.2", 0), Delete(2)), (Text("G68.2", 0), Delete(4)),
            (Text("G43.4", 0), DeleteWithBefore), (Text("G43.4", 0), Replace("G0 ", "G0 A0. B0. C0. ")),
        ]),
        (&["haas"], &[Tcp], "", &[
            (Text("G254", 0), Delete(1)), (Text("G254", 0), Delete(2)), (Text("G255", 2), Delete(1)), (Text("G254", 0), Delete(3)),
        ]),
        (&["siemens"], &[Tcp], "", &[
            (Text("CYCLE800(0", 0), Delete(1)), (Text("CYCLE800(0", 0), Delete(2)), (Text("CYCLE800(0", 0), Delete(3)),
            (Text("TRAORI", 0), Delete(1)),
        ]),
        (HEIDENHAIN, &[Tcp], "", &[(Text("PLANE SPATIAL", 0), Delete(1)), (Text("PLANE SPATIAL", 0), Delete(2))]),
    ];
    tip_control_is_ended_in_the_block_of_the_retract: [
        (&["fanuc", "haas"], &[Tcp], "", &[(Text("G49 G53", 1), Replace("G49 ", ""))]),
    ];
    the_dwell_after_spindle_start_is_required: [
        (&["linuxcnc", "fanuc", "haas", "siemens"], ALL, "spindle_dwell = 2.0\n", &[(Dwell, Delete(1))]),
        (HEIDENHAIN, ALL, "spindle_dwell = 2.0\n", &[(Dwell, DeleteWithBefore)]),
    ];
    a_block_of_the_start_of_the_program_is_found_in_a_cut: [
        (&["fanuc", "haas"], ALL, "[program]\nstart = [\"M98 P9000\"]\n[control]\neffects = { \"M98 P9000\" = \"state lost\" }\n", &[(Cut, Before("M98 P9000")), (Cut, Append(" M98 P9000"))]),
        (&["siemens"], ALL, "[program]\nstart = [\"L100\"]\n[control]\neffects = { L100 = \"state lost\" }\n", &[(Cut, Before("L100"))]),
    ];
}
