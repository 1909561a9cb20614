//! Links, the rapids that rotate the tool between cuts that rotate it as well: on the path of the CL data where every
//! block keeps to it, else by the safe sequence.
//!
//! The blocks of a link are executed by the foreign interpreter, their axes moved evenly, and tip and tool axis
//! computed by the oracle.

use std::fmt::Write;
use std::io::Cursor;

use machines::{Dmu70e, LolaXoyzba, SpinnerU5620};
use nalgebra::{Point3, UnitVector3, Vector3};
use pp_runtime::config::{Config, Mode, starting_point};
use pp_runtime::control as product;
use pp_runtime::kinematics::{AxisKind, Machine, Pose};
use pp_runtime::post::{Job, Report, post};
use tests::block::{angle_to_arc, distance_to_line};
use tests::foreign::{Control, Effect, Executed, Feed, Options, run};
use tests::oracle::Oracle;
use tests::posting::findings;

/// Samples of a block.
const POINTS: usize = 200;
const LENGTH: f64 = 100.0;
const RATE: f64 = 5000.0;

const KEYS: &str = "part_origin = [0.0, 0.0, 60.0]\n[retract]\ndistance = 40.0\n";

/// A pass around a post with a rotating tool axis.
fn pass(number: u32) -> Vec<Pose> {
    let pose = |step: u32| {
        let ((sine, cosine), (across, up)) = (
            (12.0 * f64::from(step)).to_radians().sin_cos(),
            (25.0 + 2.0 * f64::from(number + step)).to_radians().sin_cos(),
        );
        let axis = UnitVector3::new_normalize(Vector3::new(across * cosine, across * sine, up));
        Pose { tip: Point3::new(30.0 * cosine, 30.0 * sine, 5.0 - f64::from(number)), axis }
    };
    (0..6).map(pose).collect()
}

/// A pose further out along its tool axis.
fn out(pose: &Pose, distance: f64) -> Pose {
    Pose { tip: pose.tip + pose.axis.into_inner() * distance, axis: pose.axis }
}

/// The poses as rounded in CL data.
fn as_written(pose: &Pose) -> Pose {
    let rounded = |value: f64, digits: f64| (value * digits).round() / digits;
    Pose {
        tip: pose.tip.map(|value| rounded(value, 1e6)),
        axis: UnitVector3::new_normalize(pose.axis.map(|value| rounded(value, 1e9))),
    }
}

/// CL data of three passes in one sense, and both ends of each link.
fn passes() -> (String, Vec<(Pose, Pose)>) {
    let mut cl = format!("UNITS/MM\nTOOL PATH/PASSES\nLOADTL/1,LENGTH,{LENGTH}\nSPINDL/RPM,5000,CLW\n");
    let mut goto = |pose: &Pose, words: &str| {
        let Pose { tip, axis } = as_written(pose);
        writeln!(cl, "{words}GOTO/{:.6},{:.6},{:.6},{:.9},{:.9},{:.9}", tip.x, tip.y, tip.z, axis.x, axis.y, axis.z)
            .expect("memory");
    };
    let (mut links, mut left) = (Vec::new(), None);
    for number in 0..3 {
        let pass = pass(number);
        let (first, last) = (&pass[0], &pass[pass.len() - 1]);
        let (above, away) = (as_written(&out(first, 20.0)), as_written(&out(last, 20.0)));
        goto(&above, "RAPID\n");
        links.extend(left.map(|from| (from, above)));
        for pose in &pass {
            goto(pose, "FEDRAT/MMPM,900\n");
        }
        goto(&away, "RAPID\n");
        left = Some(away);
    }
    (cl + "END-OF-PATH\nFINI\n", links)
}

fn config<M: Machine>(control: Control, mode: Mode, keys: &str) -> Config {
    let mut text = format!("{keys}\n{KEYS}");
    if control == Control::LinuxCnc {
        text += "[control]\ntip_control = [\"M428\", \"M429\"]\n";
    }
    if control == Control::Siemens {
        text += "[control]\nswivel_data = \"TABLE\"\n";
    }
    let product = product::by_name(control.name()).expect("a control");
    let mut config = starting_point(product).read_over(&M::default(), &text).expect("valid keys");
    config.motion.mode = mode;
    config
}

/// Whether all axes of a rapid arrive together.
fn with_rapids(mut config: Config, together: bool) -> Config {
    config.control.linear_rapids = Some(together);
    config
}

/// The program, which has passed its check, and its report.
fn posted<M: Machine>(control: Control, config: &Config, cl: &str) -> (Report, String) {
    let control = product::by_name(control.name()).expect("a control");
    let job = Job { cl_name: "links.cls", config, control, units: None };
    let mut program = Vec::new();
    let report = post::<M>(&job, &mut Cursor::new(cl), &mut program).expect("it can run");
    assert!(!report.failed, "{}: {:?}", control.spellings().title, report.diagnostics);
    let text = String::from_utf8(program).expect("ASCII");
    let found = findings::<M>(config, control, cl, &text);
    assert!(found.is_empty(), "{text}\n{found:?}");
    (report, text)
}

/// Tip and tool axis of words.
fn pose_of<M: Machine>(oracle: &Oracle, block: &Executed, words: &[f64]) -> Pose {
    let on = oracle.forward(words);
    if !block.state.under_tip_control() {
        return on;
    }
    let linear = |letter: char| {
        let index = M::AXES.iter().position(|axis| axis.letter == letter).expect("a linear axis");
        oracle.sign(index) * words[index]
    };
    Pose { tip: Point3::from(['X', 'Y', 'Z'].map(linear)), axis: on.axis }
}

/// Words of a block in chain order, mm and rad.
fn words_of<M: Machine>(block: &Executed) -> Option<Vec<f64>> {
    let word = |axis: &pp_runtime::kinematics::Axis| {
        let word = block.state.position.get(axis.letter)?;
        Some(if axis.kind == AxisKind::Rotary { word.to_radians() } else { word })
    };
    M::AXES.iter().map(word).collect()
}

/// Number of blocks of the links, each compared with its path.
fn follow<M: Machine>(control: Control, config: &Config, text: &str, links: &[(Pose, Pose)], at_feed: bool) -> usize {
    let mut machine = M::default();
    machine.set_up(config.set_up.part_origin.into(), LENGTH);
    let oracle = Oracle::of(&machine);
    let trace = run(text, &Options::of(control)).unwrap_or_else(|refused| panic!("{refused}\n{text}"));
    let motions: Vec<&Executed> = trace.motions().collect();
    let at = |block: &Executed, pose: &Pose| {
        words_of::<M>(block).is_some_and(|words| {
            let on = pose_of::<M>(&oracle, block, &words);
            (on.tip - pose.tip).norm() < 2e-3 && (on.axis.into_inner() - pose.axis.into_inner()).norm() < 3e-5
        })
    };
    let mut count = 0;
    for (start, end) in links {
        let first = motions
            .iter()
            .position(|block| at(block, start))
            .unwrap_or_else(|| panic!("no block ends where the link begins: {start:?}\n{text}"));
        let last = motions.iter().position(|block| at(block, end)).expect("a block ends where the link ends");
        assert!(last > first, "{text}");
        for pair in motions[first..=last].windows(2) {
            let (from, to) = (words_of::<M>(pair[0]).expect("known"), words_of::<M>(pair[1]).expect("known"));
            assert_eq!(pair[1].effect, if at_feed { Effect::Feed } else { Effect::Rapid }, "line {}", pair[1].line);
            if let Some(Feed::PerMinute(rate)) = pair[1].feed().filter(|_| pair[1].state.under_tip_control()) {
                assert!((rate - RATE).abs() < 1e-6, "line {}: F{rate}", pair[1].line);
            }
            for point in 0..=POINTS {
                let share = point as f64 / POINTS as f64;
                let words: Vec<f64> = from.iter().zip(&to).map(|(a, b)| a + (b - a) * share).collect();
                let on = pose_of::<M>(&oracle, pair[1], &words);
                let tip = distance_to_line(&on.tip, &start.tip, &end.tip);
                let axis = angle_to_arc(&on.axis, &start.axis, &end.axis);
                assert!(
                    tip <= config.motion.tolerance_mm && axis <= config.motion.axis_tolerance_path_rad,
                    "line {}: {tip} mm, {axis} rad\n{text}",
                    pair[1].line
                );
            }
            count += 1;
        }
    }
    count
}

fn assert_links_follow<M: Machine>() {
    let (cl, links) = passes();
    for control in Control::ALL {
        let together = matches!(control, Control::LinuxCnc | Control::Siemens | Control::Heidenhain);
        for mode in [Mode::Axes, Mode::Tcp] {
            let rate = format!("rapid_feed = {RATE}\n");
            let at_feed = format!("rapid = \"feed\"\n{rate}");
            let frame = if control == Control::Fanuc { "tcp_frame = \"table_at_zero\"\n" } else { "" };
            for (keys, follows, feeds) in [
                ("", together, false),
                (&*rate, true, !together),
                (&*at_feed, true, true),
                ("links = \"safe\"\n", false, false),
            ] {
                let config = config::<M>(control, mode, &format!("{keys}{frame}"));
                let (report, text) = posted::<M>(control, &config, &cl);
                let (sequences, followed) = (report.statistics.sequences, report.statistics.links);
                let expected = if follows { (1, 2) } else { (3, 0) };
                assert_eq!((sequences, followed), expected, "{control:?} {mode:?} {keys}\n{text}");
                if follows {
                    let count = follow::<M>(control, &config, &text, &links, feeds);
                    assert!(count > 2 * links.len(), "{control:?} {mode:?} {keys}: {count} blocks");
                }
            }
        }
    }
}

#[test]
fn a_link_keeps_to_the_path_of_the_cl_data_on_two_rotary_axes_in_the_table() {
    assert_links_follow::<SpinnerU5620>();
}

#[test]
fn a_link_keeps_to_the_path_of_the_cl_data_on_head_and_table() {
    assert_links_follow::<Dmu70e>();
}

#[test]
fn a_link_keeps_to_the_path_of_the_cl_data_on_two_rotary_axes_in_the_head() {
    assert_links_follow::<LolaXoyzba>();
}

#[test]
fn where_axes_of_a_rapid_do_not_arrive_together_a_link_is_no_rapid() {
    let (cl, _) = passes();
    for control in Control::ALL {
        let config = with_rapids(config::<SpinnerU5620>(control, Mode::Axes, ""), false);
        let (report, _) = posted::<SpinnerU5620>(control, &config, &cl);
        assert_eq!((report.statistics.sequences, report.statistics.links), (3, 0), "{control:?}");
    }
    let config = with_rapids(config::<SpinnerU5620>(Control::Fanuc, Mode::Axes, ""), true);
    let (report, _) = posted::<SpinnerU5620>(Control::Fanuc, &config, &cl);
    assert_eq!((report.statistics.sequences, report.statistics.links), (1, 2));
}

#[test]
fn indexed_cuts_are_not_linked() {
    let face = |degrees: f64| {
        let (sine, cosine) = degrees.to_radians().sin_cos();
        let axis = format!("{sine:.7},0,{cosine:.7}");
        format!("RAPID\nGOTO/0,0,60,{axis}\nFEDRAT/MMPM,300\nGOTO/0,0,20\nGOTO/0,20,20\nRAPID\nGOTO/0,20,60\n")
    };
    let cl = format!(
        "UNITS/MM\nTOOL PATH/FACES\nLOADTL/1,LENGTH,100\nSPINDL/RPM,2000,CLW\n{}{}END-OF-PATH\nFINI\n",
        face(20.0),
        face(35.0)
    );
    for mode in [Mode::Axes, Mode::Tcp] {
        let config = config::<SpinnerU5620>(Control::LinuxCnc, mode, "rapid_feed = 5000.0\n");
        let (report, _) = posted::<SpinnerU5620>(Control::LinuxCnc, &config, &cl);
        assert_eq!((report.statistics.sequences, report.statistics.links), (2, 0), "{mode:?}");
    }
}

/// No rapid is indexed, each is a feed motion: all must keep to their paths.
#[test]
fn without_an_index_angle_every_rapid_at_feed_keeps_to_its_path() {
    let cl =
        std::fs::read_to_string(tests::binaries::workspace().join("examples/cl/concave.aptsource")).expect("a sample");
    let keys = "index_angle = 360.0\nrapid = \"feed\"\nrapid_feed = 5000.0\nfeed.largest = 20000.0\n";
    for control in Control::ALL {
        let frame = if control == Control::Fanuc { "tcp_frame = \"table_at_zero\"\n" } else { "" };
        for mode in [Mode::Axes, Mode::Tcp] {
            let config = config::<SpinnerU5620>(control, mode, &format!("{keys}{frame}"));
            let (report, text) = posted::<SpinnerU5620>(control, &config, &cl);
            assert_eq!(report.statistics.sequences, 1, "{text}");
        }
    }
}

/// Around a post and back to its start: the table goes on, or where its limit is in between, rotates back at the
/// retract position.
#[test]
fn a_link_that_leads_over_a_limit_is_a_safe_sequence() {
    let mut cl = format!("UNITS/MM\nTOOL PATH/ROUND\nLOADTL/1,LENGTH,{LENGTH}\nSPINDL/RPM,5000,CLW\n");
    let mut goto = |degrees: f64, radius: f64, words: &str| {
        let (sine, cosine) = degrees.to_radians().sin_cos();
        let (x, y) = (0.5 * cosine, 0.5 * sine);
        writeln!(cl, "{words}GOTO/{:.6},{:.6},5,{x:.9},{y:.9},0.866025404", radius * cosine, radius * sine)
            .expect("memory");
    };
    for _ in 0..2 {
        goto(0.0, 40.0, "RAPID\n");
        (0..=11).for_each(|step| goto(30.0 * f64::from(step), 30.0, "FEDRAT/MMPM,900\n"));
        goto(330.0, 40.0, "RAPID\n");
    }
    let cl = cl + "END-OF-PATH\nFINI\n";
    for (limits, expected) in [("", (1, 1)), ("limits = { C = [-350.0, 350.0] }\n", (2, 0))] {
        let config = config::<SpinnerU5620>(Control::LinuxCnc, Mode::Axes, limits);
        let (report, text) = posted::<SpinnerU5620>(Control::LinuxCnc, &config, &cl);
        assert_eq!((report.statistics.sequences, report.statistics.links), expected, "{limits}\n{text}");
    }
}

/// The check finds a link that leaves its path, and one that the control would not follow.
#[test]
fn a_link_off_its_path_is_found() {
    let (cl, links) = passes();
    for (control, mode) in
        [(Control::Siemens, Mode::Tcp), (Control::LinuxCnc, Mode::Axes), (Control::Heidenhain, Mode::Tcp)]
    {
        let config = config::<SpinnerU5620>(control, mode, "");
        let (_, text) = posted::<SpinnerU5620>(control, &config, &cl);
        let product = product::by_name(control.name()).expect("a control");
        let found = |program: &str| findings::<SpinnerU5620>(&config, product, &cl, program);
        let lines: Vec<&str> = text.lines().collect();
        let trace = run(&text, &Options::of(control)).expect("a program");
        let rotates = |block: &&Executed| {
            block.effect == Effect::Rapid
                && [" X", " B", " C"].iter().all(|word| format!(" {}", lines[block.line - 1]).contains(word))
        };
        let inside: Vec<usize> = trace.motions().filter(rotates).map(|block| block.line).collect();
        let run_of = inside.windows(4).find(|four| four[3] == four[0] + 3).expect("blocks of a link");
        let at = run_of[1] - 1;
        let without = |gone: &[usize]| {
            let kept = lines.iter().enumerate().filter(|(index, _)| !gone.contains(index));
            kept.map(|(_, line)| format!("{line}\n")).collect::<String>()
        };
        // Two blocks in one turn the tool off its great circle.
        assert!(!found(&without(&[at])).is_empty(), "{}: {}", control.name(), lines[at]);
        assert_eq!(links.len(), 2);
        // The control moves each axis on its own.
        let uncoordinated = with_rapids(self::config::<SpinnerU5620>(control, mode, ""), false);
        assert!(!findings::<SpinnerU5620>(&uncoordinated, product, &cl, &text).is_empty());
        // The shop wants no links.
        let safe = self::config::<SpinnerU5620>(control, mode, "links = \"safe\"\n");
        assert!(!findings::<SpinnerU5620>(&safe, product, &cl, &text).is_empty());
    }
}
