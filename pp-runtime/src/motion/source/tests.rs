//! Tests of the items of a program: their order, their numbers, and the decisions made once for every pass.

use nalgebra::{Point3, UnitVector3, Vector3};

use super::*;
use crate::config::Config;
use crate::kinematics::machines::{Head, Xyz};
use crate::kinematics::{Machine, Pose};
use crate::options::Transition;
use crate::program::{Coolant, Drilling, Feed, Interruption, Spindle, TextKind};

const UP: [f64; 3] = [0.0, 0.0, 1.0];
const TILTED: [f64; 3] = [0.6, 0.0, 0.8];

fn pose(x: f64, axis: [f64; 3]) -> Pose {
    Pose { tip: Point3::new(x, 0.0, 0.0), axis: UnitVector3::new_normalize(Vector3::from(axis)) }
}

fn rapid(x: f64, axis: [f64; 3]) -> Event<'static> {
    Event::Motion(ToolMotion::Move(Move { pose: pose(x, axis), rapid: true, feed: None }))
}

fn feed(x: f64, axis: [f64; 3]) -> Event<'static> {
    Event::Motion(ToolMotion::Move(Move { pose: pose(x, axis), rapid: false, feed: Some(Feed::PerMinute(100.0)) }))
}

fn hole(x: f64, axis: [f64; 3]) -> Event<'static> {
    let (drilling, feed) = (Drilling::Drill, Some(Feed::PerMinute(100.0)));
    let top = pose(x, axis);
    Event::Motion(ToolMotion::Hole(Hole {
        top,
        depth_mm: 5.0,
        clearance_mm: 2.0,
        return_mm: 2.0,
        drilling,
        feed,
        dwell: None,
    }))
}

fn tool(number: u32) -> Event<'static> {
    Event::NewStart(NewStart::Tool(ToolCall { number, ..ToolCall::default() }))
}

/// Items as text, and the indices of motions.
#[derive(Default)]
struct Seen {
    items: Vec<String>,
    indices: Vec<MotionIndex>,
    remarks: usize,
}

impl Stage for Seen {
    type Stop = Diagnostic;

    fn take(&mut self, item: &ProgramItem<'_>) -> Result<(), Diagnostic> {
        let x = |pose: &Pose| pose.tip.x;
        self.items.push(match item.action {
            ItemAction::Line { motion, index, next, .. } => {
                self.indices.push(index);
                let next = match next {
                    Next::Motion(next) => format!("{}", x(&next)),
                    Next::None => "-".to_owned(),
                    Next::Unknown => "?".to_owned(),
                };
                format!("to {} next {next}", x(&motion.pose))
            }
            ItemAction::Arc { .. } => "arc".to_owned(),
            ItemAction::Hole { hole, index } => {
                self.indices.push(index);
                format!("hole at {}", x(&hole.top))
            }
            ItemAction::Operation(start) => {
                format!("operation {} {} within {}", start.number, start.name, start.tolerance_mm)
            }
            ItemAction::Record { event: Event::Text(TextKind::Message, text), .. } => {
                String::from_utf8_lossy(text).into_owned()
            }
            ItemAction::Record { event: Event::NewStart(NewStart::Tool(call)), .. } => format!("T{}", call.number),
            ItemAction::Record { event: Event::Reference(ReferenceGeometry::From(pose)), .. } => {
                format!("from {}", x(pose))
            }
            ItemAction::Record { between, .. } => if between { "between" } else { "within" }.to_owned(),
        });
        Ok(())
    }

    fn remark(&mut self, _: Diagnostic) {
        self.remarks += 1;
    }
}

fn seen<M: Machine>(config: &Config, events: &[Event<'_>]) -> Seen {
    let mut source = Source::new(&M::default(), config.policy());
    let mut seen = Seen::default();
    for (index, event) in events.iter().enumerate() {
        source.event(Location { line: index as u64 + 1, column: 1 }, event, &mut seen).expect("nothing is refused");
    }
    source.finish(&mut seen).expect("nothing is refused");
    seen
}

#[test]
fn a_first_motion_waits_for_the_next_and_the_records_between_them_keep_their_order() {
    let events = [
        tool(1),
        Event::Function(MachineFunction::Spindle(Spindle::Off)),
        rapid(1.0, UP),
        Event::Text(TextKind::Message, b"A"),
        Event::Function(MachineFunction::Coolant(Coolant::Flood)),
        Event::Text(TextKind::Message, b"B"),
        feed(2.0, UP),
        feed(3.0, UP),
        rapid(4.0, UP),
        Event::NewStart(NewStart::Operation(b"NEXT")),
    ];
    let items = seen::<Xyz>(&Config::default(), &events).items;
    let expected =
        ["T1", "between", "to 1 next 2", "A", "within", "B", "to 2 next -", "to 3 next -", "to 4 next -", "between"];
    assert_eq!(items, expected);
}

#[test]
fn the_motion_after_a_first_one_may_be_the_rapid_over_to_a_hole() {
    let items = seen::<Xyz>(&Config::default(), &[tool(1), rapid(1.0, UP), hole(7.0, UP)]).items;
    assert_eq!(items, ["T1", "to 1 next 7", "hole at 7"]);
}

#[test]
fn more_records_than_can_be_held_back_are_handed_on_and_the_next_motion_is_unknown() {
    let mut events = vec![tool(1), rapid(1.0, UP)];
    events.extend(std::iter::repeat_n(Event::Text(TextKind::Message, b"M"), 20_000));
    events.push(feed(2.0, UP));
    let items = seen::<Xyz>(&Config::default(), &events).items;
    assert_eq!(items.len(), 20_003);
    assert_eq!([&items[1], &items[20_002]], ["to 1 next ?", "to 2 next -"]);
}

#[test]
fn a_rapid_before_the_first_tool_is_from_unless_the_tool_is_in_a_head() {
    let events = [rapid(1.0, UP), rapid(2.0, UP), tool(1), rapid(3.0, UP)];
    let table = seen::<Xyz>(&Config::default(), &events);
    assert_eq!(
        (&table.items[..], table.remarks),
        (&["from 1", "from 2", "T1", "to 3 next -"].map(str::to_owned)[..], 1)
    );
    let head = seen::<Head>(&Config::default(), &events);
    assert_eq!((&head.items[0][..], head.remarks), ("to 1 next 2", 0));
}

#[test]
fn operations_begin_after_a_boundary_and_are_linked_only_where_nothing_interrupts() {
    let events = [
        tool(1),
        feed(1.0, UP),
        Event::NewStart(NewStart::Operation(b"A")),
        Event::NewStart(NewStart::Operation(b"B")),
        feed(2.0, UP),
        Event::NewStart(NewStart::Operation(b"C")),
        Event::Interruption(Interruption::OptionalStop),
        feed(3.0, UP),
        feed(4.0, UP),
    ];
    let mut config = Config::default();
    let begins = |config: &Config| seen::<Xyz>(config, &events).indices.iter().map(|i| i.begins).collect::<Vec<_>>();
    assert_eq!(begins(&config), [Begins::Operation, Begins::Operation, Begins::Operation, Begins::Nothing]);
    config.motion.rapids.transition = Transition::Direct;
    assert_eq!(begins(&config), [Begins::Operation, Begins::Linked, Begins::Operation, Begins::Nothing]);
    let counted: Vec<_> = seen::<Xyz>(&config, &events).indices.iter().map(|i| (i.motion, i.operation)).collect();
    assert_eq!(counted, [(0, 1), (1, 2), (2, 3), (3, 3)]);
}

#[test]
fn a_stretch_ends_where_the_tool_axis_changes_in_the_air() {
    let events = [
        tool(1),
        rapid(1.0, UP),
        feed(2.0, UP),
        // A change of the tool axis in the air: another stretch.
        rapid(3.0, TILTED),
        feed(4.0, TILTED),
        // A change at feed: the same stretch, and `rotates_axis` is set; it stays set where the tool axis comes back.
        feed(5.0, UP),
        feed(5.5, TILTED),
        rapid(5.7, TILTED),
        feed(5.8, TILTED),
        rapid(6.0, UP),
        hole(7.0, TILTED),
        hole(8.0, TILTED),
        Event::Interruption(Interruption::Stop),
        feed(9.0, TILTED),
    ];
    let indices = seen::<Xyz>(&Config::default(), &events).indices;
    let stretches: Vec<_> = indices.iter().map(|index| (index.stretch, index.rotates_axis)).collect();
    let held = |stretch| (stretch, false);
    let rotates = |stretch| (stretch, true);
    assert_eq!(
        stretches,
        [
            held(1),
            held(1),
            held(2),
            held(2),
            rotates(2),
            rotates(2),
            held(2),
            rotates(2),
            held(3),
            held(4),
            held(4),
            held(5)
        ]
    );
}

#[test]
fn a_linked_operation_that_begins_with_a_rotation_at_feed_is_marked() {
    let mut config = Config::default();
    config.motion.rapids.transition = Transition::Direct;
    let events = [tool(1), feed(1.0, UP), Event::NewStart(NewStart::Operation(b"A")), feed(2.0, TILTED)];
    let indices = seen::<Xyz>(&config, &events).indices;
    assert_eq!(
        indices.iter().map(|index| (index.stretch, index.rotates_axis)).collect::<Vec<_>>(),
        [(1, false), (2, true)]
    );
}

#[test]
fn a_motion_before_a_curve_that_cannot_be_cut_is_handed_on() {
    let points = [0.0, 1e20, 0.0, 1.0].map(|x| Point3::new(x, 0.0, 0.0));
    let knots = [0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0];
    let curve = Event::Motion(ToolMotion::Spline(Spline {
        knots: &knots,
        points: &points,
        axis: Vector3::z_axis(),
        feed: None,
    }));
    let config = Config::default();
    let mut source = Source::new(&Xyz::default(), config.policy());
    let mut seen = Seen::default();
    for event in [tool(1), feed(1.0, UP), rapid(2.0, UP)] {
        source.event(Location::default(), &event, &mut seen).expect("nothing is refused");
    }
    assert!(source.event(Location::default(), &curve, &mut seen).is_err());
    assert_eq!(seen.items, ["T1", "to 1 next 2", "to 2 next -"]);
}
