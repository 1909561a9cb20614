//! Settings of single operations (`[operations]`): each changes the blocks of its operations alone, the check accepts
//! the program, and refuses one that was posted with other settings. Refusals, remarks and summaries are in
//! `tests/scenarios/operations.md`.

use machines::SpinnerU5620;
use pp_runtime::config::{Config, starting_point};
use pp_runtime::control::{self, Control};
use tests::posting::{findings, posted};

/// A tilted face, a blade with a curve, and holes with a thread: three operations with names, the second with a stop in
/// it.
const CL: &str = "UNITS/MM
TOOL PATH/ROUGH FACE,TOOL,D10
LOADTL/1,LENGTH,100
SPINDL/RPM,6000,CLW
RAPID
GOTO/0,0,30,0.5,0,0.8660254
FEDRAT/MMPM,800
GOTO/0,0,20
GOTO/0,20,20
RAPID
GOTO/0,20,80
TOOL PATH/Finish Blade,TOOL,D10
RAPID
GOTO/30,0,40,0.5,0,0.8660254
FEDRAT/MMPM,600
GOTO/30,0,20
GOTO/30,20,20,0.2588190,0,0.9659258
RAPID
GOTO/30,20,80
STOP
RAPID
GOTO/30,0,80,0.5,0,0.8660254
FEDRAT/MMPM,600
GOTO/30,0,22
GOTO/30,22,22,0.2588190,0,0.9659258
RAPID
GOTO/30,22,90
TOOL PATH/BOSS,TOOL,D8
LOADTL/2,LENGTH,110
SPINDL/RPM,500,CLW
RAPID
GOTO/0,0,60,0,0,1
CYCLE/DRILL,RAPTO,3,FEDTO,-8,RTRCTO,10,MMPM,200
GOTO/0,0,10
CYCLE/OFF
FEDRAT/MMPM,400
GOTO/0,5,30
GOTO/0,9,30
RAPID
GOTO/0,9,80
FINI
";

/// Names of the operations, as in the program.
const NAMES: [&str; 3] = ["ROUGH FACE", "FINISH BLADE", "BOSS"];

const KEYS: &str = "mode = 'axes'\ntcp_confirmed = true\n[retract]\ndistance = 40.0\n";

/// `keys`: keys of the file, then its sections.
fn config(control: &'static dyn Control, keys: &str) -> Config {
    let (top, sections) = keys.split_at(keys.find('[').unwrap_or(keys.len()));
    let name = control.spellings().name;
    let frame = if name == "fanuc" { "tcp_frame = 'table_at_zero'\n" } else { "" };
    let codes = if name == "linuxcnc" { "[control]\ntip_control = ['M428', 'M429']\n" } else { "" };
    let origin = "part_origin = [0.0, 0.0, 0.0]\n";
    let text = format!("{origin}{frame}{top}{KEYS}{codes}{sections}");
    let read = starting_point(control).read_over(&SpinnerU5620::default(), &text);
    read.unwrap_or_else(|faults| panic!("{text}: {faults:?}"))
}

/// Blocks of each operation, without numbers and without those of its safety line.
fn by_operation(program: &str) -> [Vec<String>; 3] {
    let mut operations: [Vec<String>; 3] = Default::default();
    let (mut present, mut safety) = (None, false);
    for line in program.lines() {
        let text = line.to_uppercase();
        let begins = |name: &&str| text.contains(*name) && !line.contains("operation");
        let found = NAMES.iter().position(begins);
        present = found.or(present);
        // It cancels what is on anywhere in the program.
        safety = match line.trim_start_matches(|c: char| c.is_ascii_digit()).trim() {
            "M9" | "M09" => false,
            text => safety || found.is_some() || text.ends_with("M0") || text.ends_with("M00"),
        };
        if let Some(index) = present.filter(|_| !safety) {
            operations[index].push(line.trim_start_matches(|c: char| c.is_ascii_digit()).trim_start().to_owned());
        }
    }
    assert!(operations.iter().all(|blocks| blocks.len() > 5), "{program}");
    operations
}

/// Posts with and without settings; only these operations differ, and each check refuses the program of the other.
fn differs(
    control: &'static dyn Control,
    (base, keys): (&str, &str),
    expected: [bool; 3],
    refused: [bool; 2],
) -> [String; 2] {
    let name = format!("{}: {keys}", control.spellings().name);
    let [plain, own] = [base.to_owned(), format!("{base}{keys}")].map(|keys| config(control, &keys));
    let [without, with] = [&plain, &own].map(|config| posted::<SpinnerU5620>(config, control, CL));
    let [one, other] = [&without, &with].map(|program| by_operation(program));
    let differ: Vec<bool> = one.iter().zip(&other).map(|(one, other)| one != other).collect();
    assert_eq!(differ, expected, "{name}\n{one:#?}\n{other:#?}");
    let found =
        [findings::<SpinnerU5620>(&own, control, CL, &without), findings::<SpinnerU5620>(&plain, control, CL, &with)];
    assert_eq!([!found[0].is_empty(), !found[1].is_empty()], refused, "{name}\n{without}\n{with}\n{found:?}");
    [without, with]
}

const BLADE_ALONE: [bool; 3] = [false, true, false];

/// Words that a fine tolerance needs; how far the tool axis leaves its great circle does not decide.
const FINE: &str = "axis_tolerance_path = 5.0\n[formats]\nlinear_mm = 4\n";

const BOTH: [bool; 2] = [true; 2];

#[test]
fn an_operation_has_a_mode_of_its_own() {
    for control in control::CONTROLS {
        differs(*control, ("", "[operations.'finish*']\nmode = 'tcp'\n"), BLADE_ALONE, BOTH);
        differs(
            *control,
            ("", "[operations.2]\nmode = 'tcp'\n[operations.'FINISH BLADE']\nmode = 'axes'\n"),
            BLADE_ALONE,
            BOTH,
        );
        if control.spellings().plane.is_some() {
            differs(*control, ("", "[operations.1]\nmode = 'plane'\n"), [true, false, false], BOTH);
            // At zero a plane has no code.
            differs(*control, ("", "[operations.boss]\nmode = 'plane'\n"), [false; 3], [false; 2]);
        }
    }
}

#[test]
fn an_operation_may_leave_the_mode_of_the_program_to_its_content() {
    for control in control::CONTROLS.iter().filter(|control| control.spellings().plane.is_some()) {
        let text = "[operations.'*']\nmode = 'auto'\n";
        let [_, chosen] = differs(*control, ("", text), [true, true, false], [false, true]);
        let mut auto = config(*control, "");
        auto.motion.mode = pp_runtime::config::Mode::Auto;
        assert_eq!(by_operation(&posted::<SpinnerU5620>(&auto, *control, CL)), by_operation(&chosen));
    }
}

#[test]
fn smoothing_is_that_of_the_operation() {
    for control in control::CONTROLS.iter().filter(|control| !control.spellings().smoothing[0].is_empty()) {
        let finish = "[operations.'Finish Blade']\nsmoothing = 'finish'\n";
        let [without, with] = differs(*control, ("", finish), BLADE_ALONE, BOTH);
        let code = control.spellings().smoothing_off[0];
        let has = |program: &str| tests::posting::bare(program).contains(&code);
        assert!(!has(&without) && has(&with), "{with}");
        // Off in one operation of a program that smooths.
        let rough = if control.spellings().name == "linuxcnc" { "" } else { "[control]\nsmoothing = 'rough'\n" };
        differs(*control, (rough, "[operations.2]\nsmoothing = 'none'\n"), BLADE_ALONE, BOTH);
        // Another level, where the control has levels.
        let levels = control.spellings().smoothing[0] != control.spellings().smoothing[2];
        let expected = [false, levels, false];
        differs(*control, (rough, "[operations.2]\nsmoothing = 'finish'\n"), expected, [levels; 2]);
    }
}

#[test]
fn a_level_of_smoothing_changes_between_operations_without_a_retract() {
    for control in control::CONTROLS.iter().filter(|control| !control.spellings().smoothing[0].is_empty()) {
        let cl = "UNITS/MM\nLOADTL/1,LENGTH,100\nSPINDL/RPM,6000,CLW\nTOOL PATH/ONE,TOOL,T\nRAPID\nGOTO/0,0,30,0,0,1\n\
                  FEDRAT/MMPM,300\nGOTO/0,0,20\nGOTO/9,0,20\nTOOL PATH/TWO,TOOL,T\nGOTO/9,9,20\nTOOL PATH/THREE,TOOL,T\n\
                  GOTO/0,9,20\nFINI\n";
        let keys = "[operations.'one']\nsmoothing = 'rough'\n[operations.2]\nsmoothing = 'finish'\n";
        let mut config = config(*control, keys);
        config.motion.rapids.transition = pp_runtime::config::Transition::Direct;
        let program = posted::<SpinnerU5620>(&config, *control, cl);
        let off = control.spellings().smoothing_off[0];
        let switched = program.lines().filter(|line| line.ends_with(off) || line.contains("CYCL DEF 32.0")).count();
        assert!(switched >= 1, "{program}");
        let blocks: Vec<&str> = program.lines().filter(|line| line.contains("Y9")).collect();
        assert!(blocks.len() <= 3, "no retract between them: {program}");
    }
}

#[test]
fn smoothing_that_is_on_before_a_copied_block_is_off_in_the_next_operation() {
    let control = control::by_name("haas").expect("a control");
    let mut config = config(control, "[cl]\nauxfun = [77]\n[operations.1]\nsmoothing = 'rough'\n");
    config.control.effects.insert("M77".to_owned(), pp_runtime::control::LineEffect::None);
    let cl = CL.replace("GOTO/0,20,20\n", "GOTO/0,20,20\nAUXFUN/77\n");
    let program = posted::<SpinnerU5620>(&config, control, &cl);
    let [before, after] = [program.find("M77"), program.find("\nG187\n")].map(|at| at.expect("both"));
    assert!(before < after, "{program}");
}

#[test]
fn the_path_keeps_to_the_tolerance_of_the_operation() {
    for control in control::CONTROLS {
        let [without, with] =
            differs(*control, (FINE, "[operations.'*blade']\ntolerance = 0.003\n"), BLADE_ALONE, [true, false]);
        assert!(with.lines().count() > without.lines().count() + 5, "{with}");
        let [without, with] =
            differs(*control, (FINE, "[operations.'*blade']\ntolerance = 0.8\n"), BLADE_ALONE, [false, true]);
        assert!(with.lines().count() < without.lines().count(), "{with}");
    }
}

#[test]
fn no_feed_motion_of_the_operation_is_faster_than_its_largest_feed() {
    for control in control::CONTROLS {
        differs(*control, ("", "[operations.'*blade']\nlargest_feed = 450.0\n"), BLADE_ALONE, BOTH);
        // A cycle, and a motion.
        let drill = "[operations.'Boss']\nlargest_feed = 150.0\n";
        let [_, with] = differs(*control, ("", drill), [false, false, true], BOTH);
        assert!(!with.contains("F200") && !with.contains("F400"), "{with}");
        // Above all feeds it changes nothing.
        differs(*control, ("", "[operations.'*']\nlargest_feed = 5000.0\n"), [false; 3], [false; 2]);
    }
}

#[test]
fn the_largest_feed_counts_in_inches_of_the_file() {
    let control = control::by_name("fanuc").expect("a control");
    let config = |keys: &str| {
        let keys = format!("units = 'in'\n{}{keys}", KEYS.replace("40.0", "2.0"));
        starting_point(control).read_over(&SpinnerU5620::default(), &keys).expect("valid keys")
    };
    assert_eq!(
        config("[operations.1]\nlargest_feed = 20.0\n").motion.operations.entries[0].settings.largest_feed_mm_per_min,
        Some(508.0)
    );
}

#[test]
fn a_free_axis_is_where_the_operation_has_it() {
    // A vertical operation after one that leaves C at another angle.
    let cl = CL.replace("0.5,0,0.8660254", "0.3,0.4,0.8660254").replace("0.2588190,0,", "0,0.2588190,");
    for control in control::CONTROLS {
        let [zero, previous] = ["", "[operations.boss]\nsingular = 'previous'\n"].map(|keys| config(*control, keys));
        let [at_zero, stays] = [&zero, &previous].map(|config| posted::<SpinnerU5620>(config, *control, &cl));
        let [one, other] = [&at_zero, &stays].map(|program| by_operation(program));
        assert_eq!((&one[0], &one[1]), (&other[0], &other[1]));
        assert_ne!(one[2], other[2], "{stays}");
        // The same the other way round.
        let back = config(*control, "singular = 'previous'\n[operations.boss]\nsingular = 'zero'\n");
        assert_eq!(by_operation(&posted::<SpinnerU5620>(&back, *control, &cl))[2], one[2]);
        // The cut is the same at every angle: the check accepts both.
        assert!(findings::<SpinnerU5620>(&previous, *control, &cl, &at_zero).is_empty());
    }
}

#[test]
fn a_free_axis_at_zero_in_the_next_operation_stays_in_this_one() {
    let last = "TOOL PATH/LAST,TOOL,T\nRAPID\nGOTO/40,0,60,0,0,1\nFEDRAT/MMPM,400\nGOTO/40,0,30\nGOTO/40,9,30\nFINI\n";
    let cl = CL.replace("0.5,0,0.8660254", "0.3,0.4,0.8660254").replace("0.2588190,0,", "0,0.2588190,");
    let control = control::by_name("haas").expect("a control");
    let config = config(control, "[operations.boss]\nsingular = 'previous'\n");
    let alone = by_operation(&posted::<SpinnerU5620>(&config, control, &cl));
    let program = posted::<SpinnerU5620>(&config, control, &cl.replace("FINI\n", last));
    let (boss, last) = program.split_at(program.find("LAST").expect("its comment"));
    let approach = alone[2].iter().find(|block| block.contains(" C")).expect("its angle");
    assert!(boss.contains(approach.as_str()) && !approach.ends_with(" C0."), "{approach}\n{program}");
    assert!(last.contains(" C0."), "{program}");
}

#[test]
fn blocks_of_the_shop_may_state_the_tolerance_of_blending_of_each_operation() {
    let linuxcnc = control::by_name("linuxcnc").expect("a control");
    let safety = "safety = ['{units} G17 G40 G49 G80 G90 G91.1 G94 {work_offset} G64 P{path_tolerance}";
    let starts = "[program]\noperation_start = ['G64 P{path_tolerance} Q0.005']\n";
    for own in [
        format!("[control]\n{safety}']\n"),
        format!("[control]\n{safety} Q0.005']\n"),
        format!("[control]\n{safety} Q{{path_tolerance}}']\n"),
        starts.to_owned(),
    ] {
        let text = format!(
            "part_origin = [0.0, 0.0, 0.0]\nmode = 'axes'\npath_tolerance = 0.01\n{own}[retract]\ndistance = 40.0\n\
             [operations]\n'*ROUGH*' = {{ path_tolerance = 0.05 }}\n'BOSS' = {{ path_tolerance = 0.005 }}\n"
        );
        let config = starting_point(linuxcnc).read_over(&SpinnerU5620::default(), &text).expect("read");
        let program = posted::<SpinnerU5620>(&config, linuxcnc, CL);
        for (written, other) in [("P0.05", "P0.01"), ("P0.01", "P0.05"), ("P0.005", "P0.01"), ("Q0.005", "Q0.02")] {
            // The last one of them.
            let Some(at) = program.rfind(&format!("G64 {written}")).or_else(|| program.rfind(&format!(" {written}\n")))
            else {
                continue;
            };
            let edited = format!("{}{}", &program[..at], program[at..].replacen(written, other, 1));
            assert!(
                !findings::<SpinnerU5620>(&config, linuxcnc, CL, &edited).is_empty(),
                "{written} {other}\n{edited}"
            );
        }
    }
}

/// An operation whose last motion is a hole has ended as any other.
#[test]
fn lines_at_the_end_come_after_a_hole_that_nothing_follows() {
    let cl = "UNITS/MM\nTOOL PATH/HOLE,TOOL,DRILL\nLOADTL/4\nSPINDL/RPM,2000,CLW\nRAPID\nGOTO/5,9,50,0,0,1\n\
        CYCLE/DRILL,DEPTH,5,CLEAR,3,MMPM,100\nGOTO/5,9,-4\nCYCLE/OFF\nFINI\n";
    for control in control::CONTROLS {
        let keys = "part_origin = [0.0, 0.0, 0.0]\nmode = 'axes'\ncl.dialect = 'iso'\nprogram.operation_end = ['M131']\n\
            control.effects = { 'M131' = 'none' }\n";
        let config = starting_point(*control).read_over(&SpinnerU5620::default(), keys);
        let config = config.unwrap_or_else(|faults| panic!("{faults:?}"));
        let program = posted::<SpinnerU5620>(&config, *control, cl);
        assert!(program.contains("M131"), "{program}");
    }
}
