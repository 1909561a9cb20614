//! The modes `axes`, `tcp` and `plane` program the same motion: at every point of the CL data the words of `tcp` and
//! `plane` put the tool where those of `axes` do.
//!
//! The meaning of words is defined here a second time, with the oracle's matrices and the conventions of the controls
//! written out; the tests compare steps, not text.

mod frames;
mod listener;
mod parts;

use machines::{Dmu70e, LolaXoyzba, MultiProDesk, SpinnerU5620};
use nalgebra::{Point3, UnitVector3, Vector3};
use pp_runtime::config::{Config, Mode, TcpFrame, TcpWords, ToolPosture, starting_point};
use pp_runtime::control::{self, Control, PlaneBy, TipControlSwitch};
use pp_runtime::inside;
use pp_runtime::kinematics::{AxisKind, Machine, Pose};
use pp_runtime::machine;
use pp_runtime::program::{Event, Feed, MachineFunction, Move, NewStart, Rotation, Spindle, ToolCall, ToolMotion};
use tests::block::{angle_to_arc, distance_to_line};
use tests::by_name;
use tests::further::{HeadTable, Trunnion};
use tests::oracle::{Oracle, angle_between};
use tests::posting::written;
use tests::random::Random;

use frames::commanded_pose;
use listener::{ProgramState, posted};
use parts::{events, set_up};

machine! {
    /// A table of two rotaries under a spindle with a quill.
    pub struct Quill;
    chain: C B | X Y W Z;
    axes = { W: Z };
    hold = { W: 0 };
}

const LENGTH: f64 = 87.25;

/// One unit of linear words, mm.
const UNIT: f64 = 1e-3;

/// A control in a mode, with the form of its tool axes and its frame.
#[derive(Clone, Copy)]
struct Variant {
    control: &'static dyn Control,
    mode: Mode,
    words: TcpWords,
    frame: Option<TcpFrame>,
    plane_by: Option<PlaneBy>,
}

/// Expected refusals of a control or a machine that does not support a variant; any other refusal is a fault.
const REFUSED: [&str; 7] = [
    "has no tip control",
    "has no tilted work plane",
    "give `tcp_frame`",
    "has its tip coordinates in",
    "does not rotate",
    "not accept the tool axis as a vector",
    "has no meaning",
];

fn moves<'e>(events: &'e [Event<'_>]) -> Vec<&'e Move> {
    let motion = |event: &'e Event<'_>| match event {
        Event::Motion(ToolMotion::Move(motion)) => Some(motion),
        _ => None,
    };
    events.iter().filter_map(motion).collect()
}

/// Compares a variant with mode `axes`; returns the number of points compared, zero if the variant is refused.
fn compare_variant<M: Machine>(variant: Variant, seed: u64) -> usize {
    let Variant { control, mode, words, frame, plane_by } = variant;
    let name = control.spellings().name;
    let (mut random, mut same) = (Random::new(seed), Random::new(seed));
    let mut config = set_up(mode, frame, control, &mut random);
    config.motion.tip.tcp_words = words;
    config.control.plane_by = plane_by;
    let axes = set_up(Mode::Axes, None, control, &mut same);
    let mut machine = config.set_up.machine::<M>().expect("valid");
    let events = events(&machine, &mut random, mode == Mode::Plane);
    let plain = posted::<M>(&axes, control, &events).unwrap_or_else(|fault| panic!("{name}: {fault}"));
    let framed = match posted::<M>(&config, control, &events) {
        Ok(framed) => framed,
        Err(fault) => {
            assert!(REFUSED.iter().any(|known| fault.contains(known)), "{name} {mode:?}: {fault}");
            return 0;
        }
    };
    machine.set_up(config.set_up.part_origin.into(), LENGTH);
    let mut compared = 0;
    let cuts = moves(&events).into_iter().zip(framed.iter().zip(&plain)).filter(|(motion, _)| !motion.rapid);
    for (index, (motion, (framed, plain))) in cuts.enumerate() {
        let context = format!("{} {name} {mode:?} {frame:?} cut {index}", M::NAME);
        for (config, state) in [(&config, framed), (&axes, plain)] {
            let off = (commanded_pose(&machine, config, name, state).0 - motion.pose.tip).norm();
            assert!(off <= 2.0 * UNIT, "{context}: tip {off} in mode {:?}\n{state:?}", config.motion.mode);
        }
        let off = angle_between(&commanded_pose(&machine, &config, name, framed).1, &motion.pose.axis);
        match (mode, words) {
            (Mode::Plane, _) => {
                let decimals = inside::abilities(control, &config).plane.expect("it tilts").decimals;
                let half_unit = 0.5 * 10_f64.powi(-decimals.cast_signed()).to_radians();
                assert!(off <= 3.0 * half_unit + 1e-12, "{context}: axis {off}");
            }
            (_, TcpWords::Vectors) => assert!(framed.vector.is_some() && off <= 1e-7, "{context}: axis {off}"),
            (_, TcpWords::Angles) => {
                assert_eq!(angles::<M>(framed), angles::<M>(plain), "{context}");
                assert!(
                    framed.rotary_per_minute > 0 || index < 2,
                    "F is the feed of the tip, not inverse time: {context}"
                );
            }
        }
        compared += 1;
    }
    compared
}

/// Words of the rotary axes.
fn angles<M: Machine>(state: &ProgramState) -> Vec<f64> {
    let rotary = |index: &usize| M::AXES[*index].kind == AxisKind::Rotary;
    (0..M::AXES.len()).filter(rotary).map(|index| state.words[index]).collect()
}

/// Compares every control in every mode and frame; returns the number of points compared.
fn compare<M: Machine>(seed: u64) -> usize {
    let frames = [None, Some(TcpFrame::TableAtZero), Some(TcpFrame::TableAtStart), Some(TcpFrame::NotTurning)];
    let modes = [
        (Mode::Tcp, TcpWords::Angles, None),
        (Mode::Tcp, TcpWords::Vectors, None),
        (Mode::Plane, TcpWords::Angles, None),
        (Mode::Plane, TcpWords::Angles, Some(PlaneBy::TiltedPlane)),
    ];
    let mut compared = 0;
    for &control in control::CONTROLS {
        for (mode, words, plane_by) in modes {
            for (round, frame) in frames.into_iter().enumerate() {
                compared +=
                    compare_variant::<M>(Variant { control, mode, words, frame, plane_by }, seed + round as u64);
            }
        }
    }
    compared
}

/// Checks the path of the tool between points, with 200 samples of every block of the cuts; returns the number of
/// blocks.
fn between_points<M: Machine>(seed: u64, frame: TcpFrame) -> usize {
    let mut random = Random::new(seed);
    let config = set_up(Mode::Tcp, Some(frame), &control::Fanuc, &mut random);
    let mut machine = config.set_up.machine::<M>().expect("valid");
    let events = events(&machine, &mut random, false);
    let states = posted::<M>(&config, &control::Fanuc, &events).expect("posted");
    machine.set_up(config.set_up.part_origin.into(), LENGTH);
    let motions = moves(&events);
    let mut blocks = 0;
    for (index, pair) in motions.windows(2).enumerate().filter(|(_, pair)| !pair[0].rapid && !pair[1].rapid) {
        let (start, end) = (pair[0].pose, pair[1].pose);
        let mut from = states[index].words;
        for to in &states[index + 1].blocks {
            for place in 0..=200 {
                let share = f64::from(place) / 200.0;
                let words = std::array::from_fn(|axis| from[axis] + (to[axis] - from[axis]) * share);
                let now = ProgramState { words, ..states[index + 1].clone() };
                let (tip, axis) = commanded_pose(&machine, &config, "fanuc", &now);
                let off = distance_to_line(&tip, &start.tip, &end.tip);
                assert!(off <= config.motion.tolerance_mm, "{} {frame:?} motion {index}: tip {off}", M::NAME);
                let off = angle_to_arc(&axis, &start.axis, &end.axis);
                assert!(
                    off <= config.motion.axis_tolerance_path_rad,
                    "{} {frame:?} motion {index}: axis {off}",
                    M::NAME
                );
            }
            from = *to;
            blocks += 1;
        }
    }
    blocks
}

#[test]
fn between_points_tip_and_axis_keep_to_their_path() {
    for (seed, frame) in [TcpFrame::TableAtZero, TcpFrame::TableAtStart, TcpFrame::NotTurning].into_iter().enumerate() {
        let seed = seed as u64 + 20;
        assert!(between_points::<SpinnerU5620>(seed, frame) >= 18);
        assert!(between_points::<Dmu70e>(seed, frame) >= 18);
        assert!(between_points::<MultiProDesk>(seed, frame) >= 18);
        if frame != TcpFrame::NotTurning {
            assert!(between_points::<LolaXoyzba>(seed, frame) >= 18);
            assert!(between_points::<HeadTable>(seed, frame) >= 18);
        }
    }
}

#[test]
fn both_rotaries_in_the_table() {
    assert!(compare::<SpinnerU5620>(1) > 300);
    assert!(compare::<Trunnion>(2) > 300);
}

#[test]
fn an_inclined_axis_in_the_table() {
    assert!(compare::<Dmu70e>(3) > 300);
}

#[test]
fn both_rotaries_in_the_head() {
    assert!(compare::<LolaXoyzba>(4) > 300);
}

#[test]
fn one_rotary_in_the_table_and_an_axis_with_negative_sign() {
    assert!(compare::<MultiProDesk>(5) > 300);
}

#[test]
fn one_rotary_in_the_table_and_one_in_the_head() {
    assert!(compare::<HeadTable>(6) > 300);
}

/// Operations of a rapid and a cut, one for each pair of rotary values in steps of 10°; tool axes with nine digits, as
/// CAM writes them.
fn operations_at_round_angles<M: Machine>(machine: &M) -> Vec<Event<'static>> {
    let mut events = vec![
        Event::NewStart(NewStart::Tool(ToolCall { number: 1, length_mm: Some(LENGTH), ..ToolCall::default() })),
        Event::Function(MachineFunction::Spindle(Spindle::On {
            speed_rev_per_min: Some(9000.0),
            rotation: Some(Rotation::Clockwise),
        })),
    ];
    let rotaries: Vec<usize> =
        (0..M::AXES.len()).filter(|index| M::AXES[*index].kind == AxisKind::Rotary && !M::AXES[*index].held).collect();
    for step in 0..64 {
        let mut values = vec![0.0; M::AXES.len()];
        values[rotaries[0]] = f64::from(10 * (step % 8)).to_radians();
        values[rotaries[1]] = f64::from(10 * (step / 8)).to_radians();
        let axis = Oracle::of(machine).forward(&values).axis.map(|part| (part * 1e9).round() / 1e9);
        events.push(Event::NewStart(NewStart::Operation(b"OPERATION")));
        for rapid in [true, false] {
            let tip = Point3::new(10.0, 20.0, if rapid { 30.0 } else { 5.0 });
            let pose = Pose { tip, axis: UnitVector3::new_normalize(axis) };
            events.push(Event::Motion(ToolMotion::Move(Move { pose, rapid, feed: Some(Feed::PerMinute(750.0)) })));
        }
    }
    events
}

fn assert_planes_at_round_angles<M: Machine>() {
    for control in control::CONTROLS.iter().filter(|control| control.spellings().plane.is_some()) {
        let config = set_up(Mode::Plane, None, *control, &mut Random::new(11));
        let machine = config.set_up.machine::<M>().expect("valid");
        let events = operations_at_round_angles(&machine);
        let motions = posted::<M>(&config, *control, &events).map(|motions| motions.len());
        assert_eq!(motions, Ok(128), "{} {}", M::NAME, control.spellings().name);
    }
}

#[test]
fn a_plane_is_tilted_at_round_axis_values_too() {
    assert_planes_at_round_angles::<LolaXoyzba>();
    assert_planes_at_round_angles::<SpinnerU5620>();
    assert_planes_at_round_angles::<HeadTable>();
}

/// A cut from a tilt about Y through the vertical to a tilt about X: the table rotates by 90° about the tool axis.
fn through_the_pole() -> Vec<Event<'static>> {
    let axes = [[0.5, 0.0], [0.25, 0.0], [0.0, 0.0], [0.0, 0.25]];
    let motion = |(index, [i, j]): (usize, [f64; 2])| {
        let axis = UnitVector3::new_normalize(Vector3::new(i, j, 1.0));
        let pose = Pose { tip: Point3::new(0.0, 5.0 * index as f64, 10.0), axis };
        Event::Motion(ToolMotion::Move(Move { pose, rapid: index == 0, feed: Some(Feed::PerMinute(750.0)) }))
    };
    let mut events = vec![
        Event::NewStart(NewStart::Tool(ToolCall { number: 1, length_mm: Some(LENGTH), ..ToolCall::default() })),
        Event::Function(MachineFunction::Spindle(Spindle::On {
            speed_rev_per_min: Some(9000.0),
            rotation: Some(Rotation::Clockwise),
        })),
    ];
    events.extend(axes.into_iter().enumerate().map(motion));
    events
}

#[test]
fn with_tool_vectors_a_rotation_at_the_pole_is_left_to_the_block_that_leaves_it() {
    let motions = |words: TcpWords, tool_posture: ToolPosture| {
        let mut config = set_up(Mode::Tcp, None, &control::Siemens, &mut Random::new(12));
        config.motion.tip.tcp_words = words;
        config.motion.tip.tool_posture = tool_posture;
        posted::<SpinnerU5620>(&config, &control::Siemens, &through_the_pole()).map(|motions| motions.len())
    };
    assert_eq!(motions(TcpWords::Angles, ToolPosture::Axes), Ok(4));
    // The control rotates the table as needed.
    for posture in [ToolPosture::Plane, ToolPosture::Axes] {
        assert_eq!(motions(TcpWords::Vectors, posture), Ok(4));
    }
}

#[test]
fn unsupported_modes_are_refused_with_the_alternative() {
    let mut random = Random::new(9);
    let mut refused = |control: &dyn Control, mode: Mode, change: &dyn Fn(&mut Config)| {
        let mut config = set_up(mode, None, control, &mut random);
        config.motion.tip.tcp_confirmed = false;
        change(&mut config);
        config.unfit(&SpinnerU5620::default(), control).join("\n")
    };
    let (linuxcnc, fanuc, haas) = (&control::LinuxCnc, &control::Fanuc, &control::Haas);
    assert!(
        refused(linuxcnc, Mode::Plane, &|_| {})
            .contains("has no tilted work plane, or not among its `functions`; mode axes works on any control")
    );
    assert!(refused(linuxcnc, Mode::Tcp, &|_| {}).contains("`[control] tip_control = [on, off]`"));
    assert!(refused(fanuc, Mode::Tcp, &|_| {}).contains("give `tcp_frame`"));
    let frame = |config: &mut Config| config.motion.tip.tcp_frame = Some(TcpFrame::TableAtStart);
    assert!(refused(haas, Mode::Tcp, &frame).contains("leave `tcp_frame` out"));
    let posture = |config: &mut Config| config.motion.tip.tool_posture = ToolPosture::Plane;
    assert!(refused(haas, Mode::Tcp, &posture).contains("leave `tool_posture` at \"axes\""));
    let fixed = |config: &mut Config| {
        config.motion.tip.tcp_frame = Some(TcpFrame::NotTurning);
        config.motion.tip.tool_posture = ToolPosture::Plane;
    };
    assert!(refused(fanuc, Mode::Tcp, &fixed).contains("does not rotate"));
    let offset = |config: &mut Config| config.set_up.rotary_offset = [('C', 12.5_f64.to_radians())].into();
    for mode in [Mode::Tcp, Mode::Plane] {
        assert!(refused(haas, mode, &offset).contains("`part_rotation` instead of `rotary_offset`"));
    }
    let confirmed = |config: &mut Config| {
        offset(config);
        config.motion.tip.tcp_confirmed = true;
    };
    assert_eq!(refused(haas, Mode::Plane, &confirmed), "");
    let codes = |config: &mut Config| {
        config.control.tip_control = Some(TipControlSwitch::Codes(["M428".to_owned(), "M429".to_owned()]))
    };
    assert_eq!(refused(linuxcnc, Mode::Tcp, &codes), "");
    let config = set_up(Mode::Tcp, None, haas, &mut random);
    let mut unconfirmed = config;
    unconfirmed.motion.tip.tcp_confirmed = false;
    assert_eq!(unconfirmed.unfit(&SpinnerU5620::default(), haas), Vec::<String>::new());
    let quill = unconfirmed.unfit(&Quill::default(), haas).join("\n");
    assert!(quill.contains("a held axis") && quill.contains("`tcp_confirmed = true`"), "{quill}");
    let mut config = unconfirmed;
    config.motion.tip.tcp_confirmed = true;
    assert_eq!(config.unfit(&Quill::default(), haas), Vec::<String>::new());
}

#[test]
fn tip_control_of_haas_over_a_rotated_table_needs_the_dynamic_offset() {
    let haas = by_name::control("haas");
    let cl = "UNITS/MM\nTOOL PATH/OP10,TOOL,T\nLOADTL/1,LENGTH,100\nSPINDL/RPM,2000,CLW\nRAPID\nGOTO/0,0,90,0.5,0,0.8660254\n\
              FEDRAT/MMPM,300\nGOTO/0,0,20\nGOTO/0,20,20,0,0.5,0.8660254\nRAPID\nGOTO/0,20,90\nFINI\n";
    let run = |functions: &str| {
        let keys = format!("mode = 'tcp'\n[retract]\ndistance = 50.0\n[control]\nfunctions = [{functions}]\n");
        let config = starting_point(haas).read_over(&SpinnerU5620::default(), &keys).expect("read");
        written::<SpinnerU5620>(&config, haas, cl).expect("it can run").1
    };
    let refused = run("'tip_control', 'planes'");
    assert!(refused.failed && refused.diagnostics[0].text.contains("the dynamic offset (G254)"), "{refused:?}");
    let posted = run("'tip_control', 'planes', 'dynamic_offset'");
    assert!(!posted.failed, "{posted:?}");
}
