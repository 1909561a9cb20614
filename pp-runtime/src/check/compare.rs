//! A program beside its CL data: each block finds the motion that it serves, or the place in the safe sequence that it
//! takes.
//!
//! Every block that ends a feed or a rapid at the part has to end on the path of the CL data, in order; several blocks may
//! share a motion, and each is looked at along its way. What leads from one operation to the next is worked out from the
//! specification: out along the tool axis, the retract axis to its machine position, rotary axes alone, the other linear
//! axes, down to the approach point. The state of the control is compared at each block that moves.
//!
//! A block that serves nothing is reported, and the place where the program goes on is sought among the motions ahead.

use std::io::{self, Read};

use super::Checked;
use super::chain::Placed;
use super::expect::{Expect, Item, Kind, Wanted};
use super::feed::FeedLaw;
use super::path::Segment;
use super::read::{Action, Block, Family, Length, MAX_AXES, WorkOffset, WorkPlane};
use super::report::{Shown, Tally};
use super::steps::{Done, Steps};
use super::travel::Travel;
use super::words::Words;
use crate::cl;
use crate::config::Config;
use crate::kinematics::{AnyMachine, AxisKind, Side};
use crate::motion::{Mode, Rapid};
use crate::program::Location;
use crate::program::Units;

/// Tool axes of CL data are rounded to seven digits: near the pole they are put there, rad.
const AXIS_NOISE: f64 = 2e-6;

/// Where the tool is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Phase {
    /// Nobody knows.
    Unknown,
    /// On the path of the CL data.
    Path,
    /// Led out along its axis, on the way to the retract.
    Out,
    /// At the retract position; steps of the approach that have been taken.
    Clear(u8),
}

/// How far things may be off.
#[derive(Debug, Clone, Copy)]
pub(super) struct Slack {
    /// One unit of linear words, mm.
    pub(super) unit: f64,
    /// Ends of blocks, mm.
    pub(super) tip: f64,
    /// Their tool axes, rad.
    pub(super) axis: f64,
    /// Those that are put at the pole, rad.
    pub(super) pole: f64,
    /// Tool axes of rotary words alone, rad: the angles of a tilted plane are coarser.
    pub(super) rotary: f64,
    /// One unit of rotary words, rad.
    pub(super) angle: f64,
}

/// Compares blocks with items.
pub(super) struct Checker<'a, R> {
    pub(super) config: &'a Config,
    pub(super) family: Family,
    pub(super) machine: Box<dyn AnyMachine>,
    pub(super) words: Words,
    pub(super) expect: Expect<'a, R>,
    pub(super) law: FeedLaw,
    pub(super) travel: Travel,
    pub(super) slack: Slack,
    pub(super) units: Units,
    pub(super) offsets: Vec<(u32, WorkOffset)>,
    pub(super) tally: Tally,
    pub(super) phase: Phase,
    /// Words behind the last block, and which of them are known.
    pub(super) before: ([f64; MAX_AXES], u16),
    /// The same words with the rotary axes as the control has turned them, where that is known.
    pub(super) stands: Option<[f64; MAX_AXES]>,
    /// Where the tool stands by the program.
    pub(super) here: Option<Placed>,
    /// Where it stands on the CL data: the end of the last motion, or the approach point.
    pub(super) reached: Option<Placed>,
    /// Share of the motion ahead that has been travelled.
    pub(super) along: f64,
    /// The way back to where the rotary axes were rewound.
    pub(super) back: Option<Segment>,
    pub(super) rewound: Option<Placed>,
    /// How far it was led out there, and where it comes back to.
    pub(super) rewound_out: Option<Placed>,
    /// How far the last motions have led out along the tool axis, mm.
    pub(super) led_out: f64,
    /// Chords of the arcs that have ended by their angle since words said where the tool is, in diameters.
    pub(super) by_angle: f64,
    /// From where the next motion leads out.
    pub(super) out_from: Option<Placed>,
    /// The last block served nothing: where the next begins is not to be judged.
    pub(super) lost: bool,
    /// A retract stands in the program since a complete state began.
    pub(super) retracted: bool,
    /// A complete state has begun since the last motion on the path.
    pub(super) restarted: bool,
    /// The rapid that the last block at the part has done, where it may have been the way out before it as well.
    pub(super) left: Option<Item>,
    /// The rapid that the last block was a step of.
    pub(super) steps: Option<Steps>,
    /// The motion that the last block has ended.
    pub(super) done: Option<Done>,
    /// The state of the last motion.
    pub(super) last: Option<(Location, Wanted)>,
    pub(super) ended: bool,
    /// The record that was to be served when the last block that moves began.
    pub(super) served: Location,
    /// The approach to the motion ahead has been made.
    pub(super) approached: bool,
    /// Plane of the last arc of this operation.
    pub(super) arc_plane: Option<WorkPlane>,
    /// Axes that have been parked: bits.
    pub(super) parked: u16,
    /// Length compensation behind the last block.
    pub(super) length: Option<Length>,
    /// The program has stopped with the spindle still, and no approach has begun since.
    pub(super) stopped: bool,
    /// A plane is tilted behind the last block.
    pub(super) tilted: bool,
    /// The axes may go to their parking places.
    pub(super) parks: bool,
    /// Along the first rotary axis, where it is free.
    pub(super) pole: Option<nalgebra::Vector3<f64>>,
    /// No rotary axis is in the head, and the tool stands along the retract axis.
    pub(super) straight: bool,
}

impl<'a, R: Read> Checker<'a, R> {
    pub(super) fn new(
        machine: Box<dyn AnyMachine>,
        config: &'a Config,
        family: Family,
        units: Units,
        offsets: Vec<(u32, WorkOffset)>,
        reader: cl::ClReader<R>,
    ) -> Self {
        let words = Words::new(&*machine, config);
        let decimals = |digits: u32| 10_f64.powi(-(digits as i32));
        let unit = decimals(config.formats.linear(units)) * units.in_mm();
        let angle = decimals(config.formats.rotary).to_radians();
        let rotaries = words.rotary_mask.count_ones();
        // Three angles of a plane, half a unit each: thousandths of a degree, or what rotary words have if that is coarser.
        let in_plane = 1.5 * decimals(config.formats.rotary.min(3)).to_radians();
        let in_plane = if config.motion.mode == Mode::Plane { in_plane } else { 0.0 };
        let rotary = 0.5 * angle * f64::from(rotaries) * 1.01 + AXIS_NOISE;
        let pole = rotary.max(rotary - AXIS_NOISE + config.motion.course.axis_tolerance_rad);
        let tip = 0.5 * unit * corner(&*machine) + 1e-6;
        let slack = Slack { unit, tip, axis: rotary + in_plane, rotary, pole: pole + in_plane, angle };
        let masks = (words.linear_mask, words.rotary_mask);
        let mut tally = Tally::default();
        tally.outcome.tolerance_mm = config.motion.tolerance_mm;
        let travel = Travel::new(&*machine, config, &words);
        tally.outcome.limits_declared = travel.limited();
        Self {
            law: FeedLaw::new(&*machine, config, family, units, masks, (unit, angle)),
            travel,
            expect: Expect::new(&*machine, reader, config, family, unit),
            config,
            family,
            words,
            slack,
            units,
            offsets,
            tally,
            phase: Phase::Unknown,
            before: ([0.0; MAX_AXES], 0),
            stands: None,
            here: None,
            reached: None,
            along: 0.0,
            back: None,
            rewound: None,
            rewound_out: None,
            led_out: 0.0,
            by_angle: 0.0,
            out_from: None,
            lost: false,
            retracted: false,
            restarted: false,
            left: None,
            steps: None,
            done: None,
            last: None,
            ended: false,
            served: Location::default(),
            approached: false,
            parks: false,
            arc_plane: None,
            parked: 0,
            length: None,
            pole: (0..machine.axes().len())
                .find(|&index| machine.axes()[index].kind == AxisKind::Rotary && !machine.axes()[index].held)
                .map(|index| machine.joint(index).direction.into_inner()),
            stopped: false,
            tilted: false,
            straight: straight(&*machine),
            machine,
        }
    }

    /// Looks at one block.
    pub(super) fn block(&mut self, block: &Block, text: &[u8]) -> io::Result<()> {
        let shown = Shown { line: block.line, text };
        self.expect.fill(2)?;
        if self.raw(block, shown) {
            return Ok(());
        }
        for fault in &block.faults {
            self.tally.found(self.location(), shown, &fault.text, None);
        }
        if self.ended && block.action != Action::Nothing {
            self.tally.found(self.location(), shown, "block after the end code of the program", None);
            return Ok(());
        }
        if block.restart {
            self.retracted = false;
            self.restarted = true;
        }
        if let Some(guard) = block.guard {
            self.guard(guard, shown);
        }
        self.length_given_up(block, shown);
        self.plane_given_up(block, shown);
        match block.action {
            Action::Nothing => {}
            Action::ToolChange => self.change(block, shown)?,
            Action::Dwell(seconds) => self.dwell(seconds, shown)?,
            Action::Stop => self.stop(block, false, shown)?,
            Action::OptionalStop => self.stop(block, true, shown)?,
            Action::End => self.end(block, shown)?,
            _ => self.moves(block, shown)?,
        }
        Ok(())
    }

    /// The figures and findings, behind the last line of the program.
    pub(super) fn conclude(mut self, lines: u64) -> Checked {
        if !self.ended {
            let cut = self.expect.get(0).is_some_and(|item| matches!(item.kind, Kind::Motion(_)));
            let text = if cut {
                "the program breaks off before the end of the CL data"
            } else {
                "the program has no end code"
            };
            self.found(Shown { line: lines, text: b"" }, text);
        }
        self.tally.outcome.lines = lines;
        let fault = self.expect.fault();
        Checked { outcome: self.tally.conclude(), fault }
    }

    /// The line of the CL data that comes next, or that came last.
    pub(super) fn location(&self) -> Location {
        let next = self.expect.get(0).map(|item| item.at);
        next.or(self.last.map(|(at, _)| at)).unwrap_or_default()
    }

    fn moves(&mut self, block: &Block, shown: Shown<'_>) -> io::Result<()> {
        self.tally.outcome.blocks += 1;
        self.served = self.location();
        self.take_tool();
        match block.action {
            Action::Machine => self.machine_block(block, shown)?,
            Action::Reference => {
                if block.written & !(1 << self.words.retract) != 0 {
                    self.found(shown, "motion to the reference position of other axes than the retract axis");
                }
                self.phase = Phase::Clear(0);
                self.here = None;
            }
            Action::Orient => self.orient(shown),
            Action::Rapid if matches!(self.phase, Phase::Clear(_)) => self.approach(block, shown)?,
            Action::Cycle(cycle) => self.cycle(block, &cycle, shown)?,
            _ => self.part(block, shown)?,
        }
        self.follow_angles(block);
        if !matches!(block.action, Action::Machine | Action::Reference) {
            self.limits_on_way(block, shown);
            self.limits(block, shown);
        } else if block.known & self.words.rotary_mask != self.words.rotary_mask {
            self.stands = None;
        }
        self.before = (block.values, block.known);
        Ok(())
    }

    /// The control turns the rotary axes into a tilted plane.
    fn orient(&mut self, shown: Shown<'_>) {
        if self.config.motion.mode != Mode::Plane || !matches!(self.phase, Phase::Clear(_)) {
            self.found(shown, "the control positions the rotary axes to a tilted plane where none is expected");
        }
    }

    pub(super) fn found(&mut self, shown: Shown<'_>, text: &str) {
        let at = self.location();
        self.tally.found(at, shown, text, None);
    }

    /// The tool of the motion that comes gives the chain its length.
    pub(super) fn take_tool(&mut self) {
        let next = self.expect.get(0).filter(|_| matches!(self.phase, Phase::Clear(_) | Phase::Unknown));
        let Some(item) = next else { return };
        let length = item.wanted.length.unwrap_or(0.0);
        if self.words.length_differs(length) {
            self.words.set_tool(&mut *self.machine, self.config, length);
        }
    }

    /// Axes whose place has to be known for tip and tool axis to be.
    pub(super) fn solved(&self, block: &Block) -> u16 {
        let rotary = if block.state.vector.is_some() { 0 } else { self.words.rotary_mask };
        self.words.linear_mask | rotary
    }

    /// A block at the part: a motion of the CL data, the way out, or nothing that is known.
    fn part(&mut self, block: &Block, shown: Shown<'_>) -> io::Result<()> {
        let solved = self.solved(block);
        if block.known & solved != solved {
            self.found(shown, "the position of an axis is unknown at this block");
            return Ok(());
        }
        let end = self.words.place(&block.values, &block.state);
        if matches!(self.phase, Phase::Unknown | Phase::Clear(_) | Phase::Out) {
            let text = match self.phase {
                Phase::Out => "machine retract expected after the retract along the tool axis",
                _ => "motion at the part without an approach before it",
            };
            self.found(shown, text);
            self.phase = Phase::Path;
            self.lost = true;
        }
        let rapid = block.action == Action::Rapid;
        let lifts = |checker: &mut Self| {
            (rapid || checker.config.motion.rapids.rapid == Rapid::Feed) && checker.lifts_for_cycle(block, &end, shown)
        };
        // Where rapids of the CL data are run at feed, or it asks for coolant, a dry rapid at the part is none of them.
        let dry = self.expect.get(0).is_some_and(|item| item.wanted.coolant != 0) && block.state.coolant == Some(0);
        if self.back.is_none() {
            self.left = if rapid { self.rapid_or_way_out(&end) } else { None };
        }
        let out = rapid && (dry || self.config.motion.rapids.rapid == Rapid::Feed) && !self.approached;
        if out && self.leads_out(block, &end, shown)? {
            self.here = Some(end);
            return Ok(());
        }
        // Motions that need no block may stand before the hole.
        if lifts(self) || self.serve(block, &end, shown)? || lifts(self) {
            self.here = Some(end);
            return Ok(());
        }
        if !(rapid && self.leads_out(block, &end, shown)?) {
            self.resume(block, &end, shown)?;
        }
        self.here = Some(end);
        Ok(())
    }
}

/// Largest distance of the corner of a box from its middle, in halves of its edges: what rounding of every linear word may
/// add up to.
fn corner(machine: &dyn AnyMachine) -> f64 {
    let linear = (0..machine.axes().len())
        .filter(|&index| machine.axes()[index].kind == AxisKind::Linear && !machine.axes()[index].held);
    let directions: Vec<_> = linear.map(|index| machine.joint(index).direction.into_inner()).collect();
    let signs = (0..8_u8).map(|bits| {
        let signed = directions.iter().enumerate().map(|(index, d)| if bits & (1 << index) == 0 { *d } else { -d });
        signed.sum::<nalgebra::Vector3<f64>>().norm()
    });
    signs.fold(0.0, f64::max)
}

/// The machine retract leads along the tool axis.
fn straight(machine: &dyn AnyMachine) -> bool {
    let axes = || (0..machine.axes().len()).filter(|&index| !machine.axes()[index].held);
    let head =
        axes().any(|index| machine.axes()[index].kind == AxisKind::Rotary && machine.axes()[index].side == Side::Tool);
    let tool = machine.tool_axis();
    let along = |index: usize| {
        machine.axes()[index].kind == AxisKind::Linear && machine.joint(index).direction.dot(&tool).abs() > 1.0 - 1e-12
    };
    !head && axes().any(along)
}
