//! Random parts and set-ups.

use nalgebra::{Point3, UnitVector3};
use pp_runtime::config::{Config, Mode, TcpFrame, starting_point};
use pp_runtime::control::Control;
use pp_runtime::kinematics::{AxisKind, Machine, Pose};
use pp_runtime::program::{Event, Feed, MachineFunction, Move, NewStart, Rotation, Spindle, ToolCall, ToolMotion};
use pp_runtime::set_up::GivenTool;
use tests::oracle::Oracle;
use tests::random::Random;

use super::LENGTH;

/// Operations, each with its own tool axis, and cuts in which the axis changes unless `hold` is set.
pub(crate) fn events<M: Machine>(machine: &M, random: &mut Random, hold: bool) -> Vec<Event<'static>> {
    let mut events = vec![
        Event::NewStart(NewStart::Tool(ToolCall { number: 1, length_mm: Some(LENGTH), ..ToolCall::default() })),
        Event::Function(MachineFunction::Spindle(Spindle::On {
            speed_rev_per_min: Some(9000.0),
            rotation: Some(Rotation::Clockwise),
        })),
    ];
    for _ in 0..6 {
        events.push(Event::NewStart(NewStart::Operation(b"OPERATION")));
        let axis = |random: &mut Random| {
            let values: Vec<f64> = M::AXES
                .iter()
                .map(|axis| match (axis.kind, axis.limits) {
                    (AxisKind::Linear, _) => 0.0,
                    (_, Some(limits)) => random.between(limits.lower.max(-1.0), limits.upper.min(1.0)),
                    (_, None) => random.between(-3.0, 3.0),
                })
                .collect();
            Oracle::of(machine).forward(&values).axis
        };
        let start = axis(random);
        for point in 0..5 {
            let tip = Point3::new(random.between(-50.0, 50.0), random.between(-50.0, 50.0), random.between(0.0, 30.0));
            // Near enough to the start to stay on the branch.
            let share = random.between(0.0, 0.1);
            let tilted = axis(random).into_inner() * share + start.into_inner() * (1.0 - share);
            let within = machine.reach(&UnitVector3::new_normalize(tilted), &M::HELD).is_ok();
            let axis = if hold || point == 0 || !within { start } else { UnitVector3::new_normalize(tilted) };
            let pose = Pose { tip, axis };
            events.push(Event::Motion(ToolMotion::Move(Move {
                pose,
                rapid: point == 0,
                feed: Some(Feed::PerMinute(750.0)),
            })));
        }
    }
    events
}

pub(crate) fn set_up(mode: Mode, tcp_frame: Option<TcpFrame>, control: &dyn Control, random: &mut Random) -> Config {
    let mut config = starting_point(control);
    config.motion.mode = mode;
    config.motion.tip.tcp_frame = tcp_frame;
    config.set_up.part_origin = [random.between(-40.0, 40.0), random.between(-40.0, 40.0), random.between(-20.0, 90.0)];
    config.motion.retract.distance_mm = Some(40.0);
    config.motion.guards.length_guard = Some(false);
    config.motion.feed.largest_mm_per_min = Some(30_000.0);
    config.motion.tip.tcp_confirmed = true;
    config.set_up.tools.insert(1, GivenTool { length_mm: Some(LENGTH), ..GivenTool::default() });
    config
}
