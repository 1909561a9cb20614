//! Cutter compensation: its beginning, its end, its side, and the records that it refuses.

use super::*;
use crate::config::Config;
use crate::control::{Control, Encoder, Haas, Heidenhain, Layout, Siemens};
use crate::kinematics::machines::{Cb, Mirrored, Xyz};
use crate::motion::tests::{Run, config, feed, plan, pose, rapid, run, spindle, tool};
use crate::options::Mode;
use crate::program::Units;
use crate::program::{Arc, BlockPlace, Feed, Interruption, MachineFunction, NewStart, TextKind, ToolMotion};
use crate::set_up::GivenTool;

const UP: [f64; 3] = [0.0, 0.0, 1.0];

fn set_up(path: Option<CutterPath>) -> Config {
    let mut config = config();
    config
        .set_up
        .tools
        .insert(1, GivenTool { length_mm: Some(100.0), diameter_mm: Some(10.0), ..GivenTool::default() });
    config.motion.retract.distance_mm = Some(20.0);
    config.motion.compensation = path;
    config
}

fn asked(side: CutterSide) -> Event<'static> {
    Event::Function(MachineFunction::Compensation(Compensation { side, register: None, in_xy_plane: true }))
}

/// A quarter circle about a centre, counter-clockwise.
fn quarter(start: [f64; 3], end: [f64; 3], centre: [f64; 3]) -> Event<'static> {
    Event::Motion(ToolMotion::Arc(Arc {
        start: pose(start, UP),
        end: pose(end, UP),
        centre: centre.into(),
        normal: nalgebra::UnitVector3::new_normalize(UP.into()),
        angle_rad: std::f64::consts::FRAC_PI_2,
        feed: Some(Feed::PerMinute(500.0)),
    }))
}

/// A program that comes down to X0 Y-20, followed by these events.
fn from_below(events: &[Event<'static>]) -> Vec<Event<'static>> {
    [&[tool(1), spindle(), rapid([0.0, -20.0, 9.0], UP), feed([0.0, -20.0, 0.0], UP)], events].concat()
}

/// Lead-in, a line and a quarter circle, and lead-out.
fn contour(side: CutterSide) -> Vec<Event<'static>> {
    from_below(&[
        asked(side),
        feed([0.0, 0.0, 0.0], UP),
        feed([30.0, 0.0, 0.0], UP),
        quarter([30.0, 0.0, 0.0], [40.0, 10.0, 0.0], [30.0, 10.0, 0.0]),
        asked(CutterSide::Off),
        feed([40.0, 30.0, 0.0], UP),
        feed([40.0, 30.0, 9.0], UP),
    ])
}

fn cuts(run: &Run) -> Vec<String> {
    let first = run.lines.iter().position(|line| line.starts_with("G1 ")).expect("the first cut");
    let last = run.lines.iter().rposition(|line| line == "G53 G0 Z0").expect("the retract") - 1;
    run.lines[first..last].to_vec()
}

fn posted(control: &dyn Control, config: &Config, events: &[Event<'_>]) -> Vec<String> {
    let layout = Layout::new(
        &Xyz::default(),
        config.demands(),
        &crate::control::abilities(control, config.demands()),
        &crate::motion::StretchModes::all(crate::options::StretchMode::Axes),
        Units::Millimetres,
        b"",
    );
    let mut out = Vec::new();
    let mut encoder = Encoder::new(control, &layout, &mut out);
    let (diagnostics, _) = plan::<Xyz>(control, config, events, &mut encoder);
    assert_eq!(diagnostics, []);
    encoder.finish().expect("memory takes everything");
    drop(encoder);
    let text = String::from_utf8(out).expect("ASCII");
    text.lines().filter(|line| line.contains(['X', 'Y'])).map(str::to_owned).collect()
}

fn refused(events: &[Event<'static>]) -> String {
    run::<Xyz>(&set_up(Some(CutterPath::Centre)), events).error().text.clone()
}

#[test]
fn compensation_begins_with_the_line_after_it_and_ends_with_the_line_after_off() {
    for (side, code) in [(CutterSide::Left, "G41"), (CutterSide::Right, "G42")] {
        let run = run::<Xyz>(&set_up(Some(CutterPath::Centre)), &contour(side));
        assert_eq!(run.diagnostics, []);
        let on = format!("{code} D1 Y0");
        assert_eq!(cuts(&run), ["G1 Z0 F500", &on, "X30", "G3 X40 Y10 I0 J10", "G1 G40 Y30", "Z9"]);
    }
}

#[test]
fn in_mirrored_coordinates_left_is_right() {
    for (side, code) in [(CutterSide::Left, "G42 D1"), (CutterSide::Right, "G41 D1")] {
        let run = run::<Mirrored>(&set_up(Some(CutterPath::Centre)), &contour(side));
        assert!(run.lines.iter().any(|line| line.contains(code)), "{:?} {:?}", run.lines, run.diagnostics);
    }
}

#[test]
fn each_control_has_its_own_words_and_register() {
    let mut config = set_up(Some(CutterPath::Contour));
    let lines = posted(&Siemens, &config, &contour(CutterSide::Left));
    assert_eq!(lines[lines.len() - 4..], ["G41 Y0", "X30", "G3 X40 Y10 I0 J10", "G1 G40 Y30"]);
    let lines = posted(&Heidenhain, &config, &contour(CutterSide::Right));
    let ends: Vec<&str> = lines.iter().map(|line| line.split_once(' ').expect("a number").1).collect();
    assert_eq!(
        ends[ends.len() - 7..ends.len() - 2],
        ["L Y+0 RR", "L X+30", "CC X+30 Y+10", "C X+40 Y+10 DR+", "L Y+30 R0"]
    );
    config.set_up.tools.get_mut(&1).expect("the tool").radius_offset = Some(31);
    assert!(posted(&Haas, &config, &contour(CutterSide::Left)).iter().any(|line| line == "G41 D31 Y0."));
    let (found, _) = plan::<Xyz>(&Heidenhain, &config, &contour(CutterSide::Left), &mut crate::motion::DiscardSteps);
    assert!(found[0].text.contains("register 31"), "{found:?}");
}

#[test]
fn on_takes_the_side_and_the_register_that_were_given_last() {
    let left = Event::Function(MachineFunction::Compensation(Compensation {
        side: CutterSide::Left,
        register: Some(7),
        in_xy_plane: true,
    }));
    let events = from_below(&[
        left,
        feed([0.0, 0.0, 0.0], UP),
        asked(CutterSide::Off),
        feed([0.0, 9.0, 0.0], UP),
        asked(CutterSide::On),
        feed([0.0, 20.0, 0.0], UP),
        asked(CutterSide::Off),
        feed([0.0, 30.0, 0.0], UP),
    ]);
    let found = cuts(&run::<Xyz>(&set_up(Some(CutterPath::Centre)), &events));
    assert_eq!(found, ["G1 Z0 F500", "G41 D7 Y0", "G40 Y9", "G41 D7 Y20", "G40 Y30"]);
    assert!(refused(&from_below(&[asked(CutterSide::On)])).contains("without a side"));
}

#[test]
fn a_point_rounded_out_of_the_plane_counts_as_in_it_with_fine_words_as_well() {
    let mut config = set_up(Some(CutterPath::Centre));
    config.formats.linear_mm = 5;
    let events = from_below(&[
        asked(CutterSide::Left),
        feed([0.0, 0.0, 0.0001], UP),
        feed([30.0, 0.0, 0.0], UP),
        asked(CutterSide::Off),
        feed([40.0, 30.0, 0.0], UP),
    ]);
    let found = cuts(&run::<Xyz>(&config, &events));
    assert!(found.iter().any(|line| line.starts_with("G41 ") && line.contains("Y0")), "{found:?}");
}

#[test]
fn the_tool_may_be_led_to_the_start_of_the_line() {
    let events = from_below(&[
        asked(CutterSide::Left),
        rapid([5.0, -20.0, 0.0], UP),
        feed([5.0, -20.0, -3.0], UP),
        feed([5.0, 0.0, -3.0], UP),
        asked(CutterSide::Off),
        feed([5.0, 9.0, -3.0], UP),
    ]);
    let run = run::<Xyz>(&set_up(Some(CutterPath::Centre)), &events);
    assert_eq!(cuts(&run)[1..], ["G0 X5", "G1 Z-3", "G41 D1 Y0", "G40 Y9"]);
}

#[test]
fn records_that_interrupt_the_look_ahead_are_refused() {
    let on = |event: Event<'static>| refused(&from_below(&[asked(CutterSide::Left), feed([0.0, 0.0, 0.0], UP), event]));
    for (event, why) in [
        (rapid([0.0, 9.0, 0.0], UP), "a rapid follows"),
        (feed([0.0, 0.0, 5.0], UP), "leaves its plane"),
        (feed([0.0, 9.0, 5.0], UP), "leaves its plane"),
        (quarter([0.0; 3], [10.0, 10.0, 2.0], [0.0, 10.0, 0.0]), "an arc leaves its plane"),
        (asked(CutterSide::Right), "the other side"),
        (Event::Interruption(Interruption::Stop), "the program stops"),
        (Event::NewStart(NewStart::Home), "GOHOME follows"),
        (Event::Interruption(Interruption::Insert(b"M64", BlockPlace::InOrder)), "NC text"),
        (tool(1), "a tool is called"),
        (Event::NewStart(NewStart::Operation(b"NEXT")), "another operation"),
        (Event::Text(TextKind::Message, b"the end"), "the program ends"),
    ] {
        let text = on(event);
        assert!(text.contains("still active") && text.contains(why), "{event:?}: {text}");
    }
    let first = |event| refused(&from_below(&[asked(CutterSide::Left), event]));
    assert!(
        first(quarter([0.0, -20.0, 0.0], [10.0, -10.0, 0.0], [0.0, -10.0, 0.0])).contains("begins with a straight")
    );
    assert!(first(Event::Text(TextKind::Message, b"the end")).contains("no straight feed motion in the plane follows"));
    let last = |event| {
        let up = [asked(CutterSide::Left), feed([0.0; 3], UP), asked(CutterSide::Off), event];
        refused(&from_below(&up))
    };
    assert!(last(rapid([0.0, 0.0, 9.0], UP)).contains("ends with a straight"));
    assert!(last(feed([0.0, 0.0, 9.0], UP)).contains("ends with a straight"));
}

#[test]
fn an_arc_that_would_be_chords_is_refused() {
    let mut config = set_up(Some(CutterPath::Centre));
    config.motion.arcs.output = crate::options::ArcOutput::Lines;
    assert!(run::<Xyz>(&config, &contour(CutterSide::Left)).error().text.contains("is written as chords"));
}

#[test]
fn a_lead_in_is_longer_than_the_radius_that_d_holds() {
    let short = from_below(&[asked(CutterSide::Left), feed([0.0, -15.5, 0.0], UP), feed([9.0, -15.5, 0.0], UP)]);
    let text = |path| run::<Xyz>(&set_up(Some(path)), &short).error().text.clone();
    assert!(text(CutterPath::Contour).contains("4.5 mm long, shorter than the tool radius of 5 mm"));
    assert!(text(CutterPath::Centre).contains("the program ends"));
}

/// A quarter circle with a radius of 3 mm to the left of a contour.
fn tight(side: CutterSide) -> Vec<Event<'static>> {
    from_below(&[
        asked(side),
        feed([0.0, 0.0, 0.0], UP),
        feed([30.0, 0.0, 0.0], UP),
        quarter([30.0, 0.0, 0.0], [33.0, 3.0, 0.0], [30.0, 3.0, 0.0]),
        feed([33.0, 20.0, 0.0], UP),
        asked(CutterSide::Off),
        feed([60.0, 30.0, 0.0], UP),
    ])
}

#[test]
fn an_arc_around_the_tool_is_larger_than_the_tool_in_mirrored_words_as_well() {
    let config = set_up(Some(CutterPath::Contour));
    for found in [
        run::<Xyz>(&config, &tight(CutterSide::Left)).error().text.clone(),
        run::<Mirrored>(&config, &tight(CutterSide::Left)).error().text.clone(),
    ] {
        assert_eq!(found, "the tool radius of 5 mm does not fit into this arc with a radius of 3 mm");
    }
    assert_eq!(run::<Xyz>(&config, &tight(CutterSide::Right)).diagnostics, []);
    assert_eq!(run::<Mirrored>(&config, &tight(CutterSide::Right)).diagnostics, []);
}

#[test]
fn an_arc_by_its_radius_is_the_same_contour() {
    let mut config = set_up(Some(CutterPath::Contour));
    config.motion.arcs.form = crate::options::ArcForm::Radius;
    assert_eq!(run::<Xyz>(&config, &contour(CutterSide::Left)).diagnostics, []);
    assert!(run::<Xyz>(&config, &tight(CutterSide::Left)).error().text.contains("with a radius of 3 mm"));
}

#[test]
fn wear_is_compared_to_both_sides() {
    let mut config = set_up(Some(CutterPath::Centre));
    config.motion.largest_wear_mm = 3.5;
    let text = |side| run::<Xyz>(&config, &tight(side)).error().text.clone();
    assert!(text(CutterSide::Left).starts_with("a wear of 3.5 mm does not fit"));
    assert!(text(CutterSide::Right).starts_with("a wear of -3.5 mm does not fit"));
    config.motion.largest_wear_mm = 2.5;
    assert_eq!(run::<Xyz>(&config, &tight(CutterSide::Right)).diagnostics, []);
}

#[test]
fn corners_leave_a_part_of_every_line() {
    let slot = |width: f64| {
        from_below(&[
            asked(CutterSide::Left),
            feed([0.0, 0.0, 0.0], UP),
            feed([0.0, 20.0, 0.0], UP),
            feed([-width, 20.0, 0.0], UP),
            feed([-width, 0.0, 0.0], UP),
            asked(CutterSide::Off),
            feed([-width, -20.0, 0.0], UP),
        ])
    };
    let config = set_up(Some(CutterPath::Contour));
    assert_eq!(run::<Xyz>(&config, &slot(10.1)).diagnostics, []);
    let text = run::<Xyz>(&config, &slot(9.9)).error().text.clone();
    assert!(text.contains("would be 9.9 mm long, and its corners would take 10 mm of it"), "{text}");
}

#[test]
fn a_contour_of_an_unknown_radius_is_posted_and_counted() {
    let mut config = set_up(Some(CutterPath::Contour));
    config.set_up.tools.get_mut(&1).expect("the tool").diameter_mm = None;
    assert_eq!(run::<Xyz>(&config, &tight(CutterSide::Left)).diagnostics, []);
}

#[test]
fn compensation_needs_the_plane_of_x_and_y_and_no_tip_control() {
    let other = Event::Function(MachineFunction::Compensation(Compensation {
        side: CutterSide::Left,
        register: None,
        in_xy_plane: false,
    }));
    assert!(refused(&from_below(&[other])).contains("plane of X and Y only"));
    let mut config = set_up(Some(CutterPath::Centre));
    config.motion.mode = Mode::Tcp;
    assert!(run::<Xyz>(&config, &contour(CutterSide::Left)).error().text.contains("under tip control"));
}

#[test]
fn a_rotary_axis_that_rotates_is_refused() {
    let config = set_up(Some(CutterPath::Centre));
    let tilted = [0.1, 0.0, 1.0];
    let text = |events: &[Event<'static>]| run::<Cb>(&config, events).error().text.clone();
    let on = from_below(&[asked(CutterSide::Left), feed([0.0; 3], UP), feed([9.0, 0.0, 0.0], tilted)]);
    assert!(text(&on).contains("not Z of the program"));
    let entry = from_below(&[asked(CutterSide::Left), feed([0.0; 3], tilted)]);
    assert!(text(&entry).contains("not Z of the program"));
}
