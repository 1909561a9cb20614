//! Functions that the configuration puts into a program: length guards, dwells of the spindle, smoothing, clamps, and
//! lines of the shop.

use std::collections::BTreeMap;

use nalgebra::Vector3;

use super::super::expect::{Required, RequiredSmoothing, SpindleState};
use super::super::policy::{LinearMeaning, SmoothingLevel};
use super::super::read::{
    Action, BlankPart, Block, Guard, GuardSource, Length, LengthSource, OwnPlace, PathMode, PathSmoothing,
    SmoothingWords, State,
};
use super::super::rules::Rules;
use super::phase::Phase;
use crate::check::tolerances::{ROUNDED_GUARD, ROUNDED_TOLERANCE, THINNEST_BLANK};
use crate::kinematics::Axis;
use crate::set_up::{LengthMode, ProgramZero};

/// State of the functions.
#[derive(Debug, Clone, Default)]
pub(super) struct FunctionState {
    /// Length guard since a complete state began.
    guard: Option<Guard>,
    /// Whether the first tool that can have a length guard has one.
    guards: Option<bool>,
    /// Largest radius that a guard allows since a complete state began, mm.
    radius_guard_mm: Option<f64>,
    /// Mode of the first cut, where blocks of the shop may select it.
    path_mode: Option<PathMode>,
    /// State of the spindle for a dwell before the approach.
    waits_with: Option<SpindleState>,
    /// Rotary axes whose clamps have been switched since a complete state began: bits.
    clamps_stated: u16,
    /// Tool axis of the last block at the part.
    tool_axis: Option<Vector3<f64>>,
    /// Rotary axes that have moved since the approach, and those that were not clamped in a cut: bits.
    moved: u16,
    unclamped: u16,
    /// The cuts before a retract that may be a rewind.
    interrupted: Option<InterruptedCuts>,
    /// Clamps at the machine retract, and rotary axes whose words have come since: bits.
    at_retract: Option<ClampsAtRetract>,
    /// Axes whose words have come since the complete state: bits.
    axes_stated: u16,
    /// Rotary axes whose words have come since, whatever the block was for: bits.
    rotary_stated: u16,
    /// The blank as far as the program has defined it, in its unit.
    blank: Blank,
    /// It has been compared with that of the configuration.
    blank_is_compared: bool,
}

/// Clamps at the machine retract: bits by axis.
#[derive(Debug, Clone, Copy)]
struct ClampsAtRetract {
    clamped: u16,
    known: u16,
    /// Rotary words have come since.
    rotated: u16,
}

/// What clamps must be where nothing rotates any more since the machine retract.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum ClampsDue {
    /// Those of axes that have not rotated are as they were.
    AsBefore,
    /// Besides, an axis that has been positioned is clamped.
    Positioned,
    /// And so is one with a parking position.
    Parked,
}

/// The blank of a program: corners, and whether it is a cylinder.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
struct Blank {
    lower: Option<[f64; 3]>,
    upper: Option<[f64; 3]>,
    round: bool,
}

impl FunctionState {
    /// The spindle runs for a dwell before the approach; `None`: no longer.
    pub(super) fn wait_with(&mut self, spindle: Option<SpindleState>) {
        self.waits_with = spindle;
    }

    pub(super) fn waits_with(&self) -> Option<SpindleState> {
        self.waits_with
    }

    /// A complete state begins.
    pub(super) fn restart(&mut self) {
        self.guard = None;
        self.radius_guard_mm = None;
        (self.clamps_stated, self.axes_stated, self.rotary_stated) = (0, 0, 0);
    }

    /// A block of an approach has words of axes.
    pub(super) fn state_axes(&mut self, written: u16) {
        self.axes_stated |= written;
    }

    /// What is wrong at the end of the first approach: the position of each axis is programmed after the complete
    /// state.
    pub(super) fn axes_unstated(&self, rules: &Rules<'_>) -> Option<String> {
        let solved = rules.words().linear_bits() | rules.words().rotary_bits();
        let axis = letter(rules, solved & !self.axes_stated);
        axis.map(|letter| {
            format!(
                "operation starts without the position of {letter}, which must be programmed after its restart point"
            )
        })
    }

    /// Whether a guard of the tool length has come since the complete state.
    pub(super) fn is_guarded(&self) -> bool {
        self.guard.is_some()
    }

    /// Takes the guard of a block; what is wrong with it.
    pub(super) fn guard(
        &mut self,
        guard: Guard,
        length: Option<Length>,
        rules: &Rules<'_>,
        required: Option<&Required>,
    ) -> Option<String> {
        self.guard = Some(guard);
        let required = required?;
        let expected = required.gauge_length_mm?;
        if guard.source == LengthSource::Edge && !matches!(length, Some(Length::Register(_))) {
            return Some("the length guard reads the length of the active edge, and none is active".to_owned());
        }
        if (expected - guard.length_mm).abs() > ROUNDED_GUARD {
            let [length, expected] = [guard.length_mm, expected].map(|mm| rules.units().length(mm));
            return Some(format!("the length guard compares with {length}, but the tool length is {expected}"));
        }
        if guard.source != guarded(rules, required)? {
            return Some("the length guard reads the length of another tool, register or edge".to_owned());
        }
        let largest = rules.policy().shop.length_guard_mm?;
        if guard.tolerance_mm > largest + ROUNDED_GUARD {
            let [tolerance, largest] = [guard.tolerance_mm, largest].map(|mm| rules.units().length(mm));
            return Some(format!("the length guard allows a difference of {tolerance}, expected {largest}"));
        }
        (!guard.stops).then(|| "the length guard does not stop the program".to_owned())
    }

    /// Takes the guard of the tool radius; it reads the active edge.
    pub(super) fn radius_guard(&mut self, largest_mm: f64, length: Option<Length>) -> Option<String> {
        if !matches!(length, Some(Length::Register(_))) {
            return Some("the guard reads the radius of the active edge, and none is active".to_owned());
        }
        self.radius_guard_mm = Some(largest_mm);
        None
    }

    /// What is wrong with the guard of the tool radius in a cut with cutter compensation.
    pub(super) fn cut_with_radius(&self, rules: &Rules<'_>) -> Option<String> {
        let shop = &rules.policy().shop;
        // Without length compensation (D0) no edge is active, and its radius is not taken.
        let edge = rules.policy().set_up.length_mode == LengthMode::Tip;
        if !rules.facts().radius_guard || !shop.compensated_centre || !edge {
            return None;
        }
        let largest = shop.largest_wear_mm;
        match self.radius_guard_mm {
            Some(allowed) if allowed <= largest + ROUNDED_GUARD => None,
            Some(allowed) => {
                let [allowed, largest] = [allowed, largest].map(|mm| rules.units().length(mm));
                Some(format!("the guard of the tool radius allows {allowed}, expected {largest}"))
            }
            None => Some("the guard of the tool radius, which must be wear only, is missing".to_owned()),
        }
    }

    /// Takes a part of the definition of the blank.
    pub(super) fn blank(&mut self, part: BlankPart) {
        match part {
            BlankPart::Lower(corner) => (self.blank.lower, self.blank.round) = (Some(corner), false),
            BlankPart::Upper(corner) => self.blank.upper = Some(corner),
            BlankPart::Whole { lower, upper, round } => {
                self.blank = Blank { lower: Some(lower), upper: Some(upper), round };
            }
        }
    }

    /// What is wrong with the blank, where the first operation begins; one around all cuts may have any size.
    pub(super) fn blank_fault(&mut self, rules: &Rules<'_>) -> Option<String> {
        if std::mem::replace(&mut self.blank_is_compared, true) || !rules.facts().blank {
            return None;
        }
        let set_up = &rules.policy().set_up;
        let mut stock = set_up.stock.filter(|_| set_up.length_mode == LengthMode::Tip)?;
        if (0..3).any(|index| stock.upper[index] - stock.lower[index] < THINNEST_BLANK) {
            return None;
        }
        if set_up.program_zero == ProgramZero::Table {
            let origin = set_up.part_origin;
            stock.round &= origin[0].abs() <= 0.0 && origin[1].abs() <= 0.0;
            for (index, origin) in origin.into_iter().enumerate() {
                stock.lower[index] += origin;
                stock.upper[index] += origin;
            }
        }
        let (Some(lower), Some(upper)) = (self.blank.lower, self.blank.upper) else {
            return Some("the blank of the configuration, [stock], is missing at the head of the program".to_owned());
        };
        let unit_mm = rules.units().in_mm();
        let near = |one: [f64; 3], other: [f64; 3]| {
            one.iter().zip(other).all(|(one, other)| (one * unit_mm - other).abs() <= rules.rounding().unit_mm)
        };
        let same = near(lower, stock.lower) && near(upper, stock.upper) && self.blank.round == stock.round;
        (!same).then(|| "the blank of the program differs from that of the configuration, [stock]".to_owned())
    }

    /// What is missing where an operation begins: a guard of the tool length.
    pub(super) fn length_guard(&mut self, rules: &Rules<'_>, required: &Required, block: &Block) -> Option<String> {
        let policy = rules.policy();
        // Where the program chooses the meaning of its words: positions of axes at zero may be coordinates in a plane
        // that is not tilted, and do not depend on the length.
        let positions = match rules.meaning() {
            LinearMeaning::AxisPositions => !policy.shop.has_planes || !rules.are_at_zero(block),
            LinearMeaning::TipCoordinates => policy.shop.guards_tip_control,
            LinearMeaning::PlaneCoordinates => false,
        };
        let guardable = required.gauge_length_mm.zip(required.tool).filter(|_| guarded(rules, required).is_some());
        let (length, tool) = guardable.filter(|_| policy.shop.length_guard_mm.is_some())?;
        // A program that guards one tool guards all whose length is known.
        let matters = !policy.shop.guards_rotated_axes_only || positions || self.guards == Some(true);
        let is_guarded = self.guard.is_some();
        let before = *self.guards.get_or_insert(is_guarded);
        match (is_guarded, matters) {
            (false, true) => {
                let length = rules.units().length(length);
                Some(format!("the length guard of T{tool}, length {length}, is missing after the restart point"))
            }
            (true, _) if !before => {
                Some(format!("T{tool} has a length guard, and the tools before it have none: theirs are missing"))
            }
            _ => None,
        }
    }

    /// What is missing where an operation begins: a clamp that is neither on nor off.
    pub(super) fn clamps_unstated(&self, rules: &Rules<'_>) -> Option<String> {
        let clamp = letter(rules, rules.clamps() & !self.clamps_stated);
        clamp.map(|letter| format!("the clamp of {letter} is neither on nor off after the restart point"))
    }

    /// What is wrong with the clamps where rotary words come for the first time after a restart point: entered there,
    /// they may rotate.
    pub(super) fn rotates_from_restart(&mut self, block: &Block, rules: &Rules<'_>) -> Option<String> {
        let first = block.written & rules.clamps() & !self.rotary_stated;
        self.rotary_stated |= block.written;
        let held = letter(rules, first & (!self.clamps_stated | block.state.clamped));
        held.map(|letter| format!("the clamp of {letter} has not been released after the restart point: entered there, {letter} may rotate here"))
    }

    /// What is wrong with the clamps where a probe measures.
    pub(super) fn loose(&self, state: &State, rules: &Rules<'_>) -> Option<String> {
        let loose = rules.clamps() & state.clamps_known & !state.clamped & !self.moved;
        letter(rules, loose).map(|letter| format!("{letter} is not clamped where a probe measures"))
    }

    /// A line of the shop has switched clamps.
    pub(super) fn forget_clamps(&mut self) {
        self.at_retract = None;
    }

    /// Notes a line of the shop.
    pub(super) fn line(&mut self, places: &[OwnPlace]) {
        for place in places {
            if let OwnPlace::Clamp { axis, .. } = place {
                self.clamps_stated |= 1 << axis;
            }
        }
    }

    /// What is wrong with smoothing and path mode in a cut; `expected`: its smoothing, off in a cycle of the control.
    pub(super) fn smoothing(
        &mut self,
        state: &State,
        rules: &Rules<'_>,
        expected: RequiredSmoothing,
    ) -> Option<String> {
        let blending = expected.blending_mm;
        let mode = self.path_mode(state, rules, blending);
        if mode.is_some() {
            return mode;
        }
        let policy = rules.policy();
        match (expected.level, state.smoothing) {
            (None, PathSmoothing::Off) => None,
            (None, PathSmoothing::On { .. }) => Some("smoothing is on, expected off".to_owned()),
            (Some(_), PathSmoothing::Off) => Some("smoothing is off, expected on".to_owned()),
            (Some(level), PathSmoothing::On { tolerance_mm, level: written }) => {
                let SmoothingWords { tolerance, levels } = rules.facts().smoothing;
                let index = match level {
                    SmoothingLevel::Rough => 0,
                    SmoothingLevel::Medium => 1,
                    SmoothingLevel::Finish => 2,
                };
                let level_word = levels[index].or(policy.shop.smoothing_levels.map(|levels| levels[index] as u8));
                if tolerance && !is_blending(tolerance_mm, blending, rules) {
                    return Some(format!(
                        "smoothing {}, expected {}",
                        shown(tolerance_mm, rules),
                        shown(Some(blending), rules)
                    ));
                }
                if level_word != written {
                    return Some("smoothing of another level than that of the configuration".to_owned());
                }
                let angles = [policy.shop.smoothing_angle_rad, state.smoothing_angle_rad];
                (!is_angle(angles)).then(|| {
                    let [expected, written] = angles.map(angle_shown);
                    format!("smoothing has {written} for rotary axes, expected {expected}")
                })
            }
        }
    }

    /// What is wrong with the motion from block to block.
    fn path_mode(&mut self, state: &State, rules: &Rules<'_>, blending: f64) -> Option<String> {
        let written = state.path_mode;
        let shop = &rules.policy().shop;
        if rules.facts().path_tolerance && (!shop.own_safety || shop.states_blending()) {
            // The shop may join lines within a distance of its own.
            let own =
                shop.selects_modes().then(|| *self.path_mode.get_or_insert(written.unwrap_or(PathMode::ExactPath)));
            let joining = own.and_then(PathMode::joining_mm);
            let tolerance = match written {
                Some(PathMode::Continuous { tolerance_mm, joining_mm })
                    if joining_mm == if shop.states_joining() { tolerance_mm } else { joining } =>
                {
                    tolerance_mm
                }
                _ => None,
            };
            return (!is_blending(tolerance, blending, rules)).then(|| {
                format!(
                    "blocks are blended {} (G64 P), expected {}",
                    shown(tolerance, rules),
                    shown(Some(blending), rules)
                )
            });
        }
        // Blending without a limit is the mode after switching on.
        let written = written.unwrap_or(PathMode::Continuous { tolerance_mm: None, joining_mm: None });
        let usual = PathMode::Continuous { tolerance_mm: None, joining_mm: None };
        let expected = if shop.selects_modes() { *self.path_mode.get_or_insert(written) } else { usual };
        (expected != written).then(|| "the motion from block to block (G61, G64) differs from that expected".to_owned())
    }

    /// What is wrong with the clamps of the rotary axes in a block that moves, on a machine that has some.
    pub(super) fn clamps(&mut self, block: &Block, moved: u16, rules: &Rules<'_>, at_part: bool) -> Option<String> {
        let clamps = rules.clamps();
        let state = &block.state;
        let released = state.clamps_known & !state.clamped;
        // The control may rotate any of them.
        let mut rotated = if block.action == Action::Orient { clamps } else { moved };
        if let Some(at_retract) = self.at_retract.as_mut().filter(|_| !at_part) {
            at_retract.rotated |= block.written;
        }
        if at_part {
            self.unclamped |= clamps & !state.clamped;
            let axis = state.vector.map(|_| rules.pose(block).axis);
            let before = std::mem::replace(&mut self.tool_axis, axis);
            self.moved |= moved;
            if let Some(to) = axis.filter(|_| before != axis) {
                // The first tool axis may be the one of the approach.
                let from = before.unwrap_or_else(|| rules.words().tool_axis_at(&block.values));
                if before.is_some() || !rules.is_axis_near(&from, &to, 1.0) {
                    self.moved = u16::MAX;
                    rotated |= rules.rotated_for(&from, &to);
                }
            }
        }
        if let Some(interrupted) = &mut self.interrupted {
            interrupted.rewound |= rotated;
        }
        let stuck = rotated & clamps & !released;
        letter(rules, stuck).map(|letter| match state.clamped & stuck {
            0 => format!("{letter} moves, and its clamp has not been released"),
            _ => format!("{letter} moves while it is clamped"),
        })
    }

    /// The machine has retracted.
    pub(super) fn retract(&mut self, state: &State) {
        self.at_retract = Some(ClampsAtRetract { clamped: state.clamped, known: state.clamps_known, rotated: 0 });
    }

    /// The approach has ended with this block.
    pub(super) fn arrive(&mut self, state: &State, rules: &Rules<'_>) {
        self.unclamped |= rules.clamps() & !state.clamped;
    }

    /// What is wrong with the clamps where nothing rotates any more since the machine retract.
    pub(super) fn clamps_left(&self, state: &State, rules: &Rules<'_>, due: ClampsDue) -> Option<String> {
        let ClampsAtRetract { clamped, known, rotated } = self.at_retract?;
        let links = &rules.policy().links;
        let with_place = |places: &[&BTreeMap<char, f64>]| {
            let axes = rules.axes().iter().enumerate();
            let with_place = axes.filter(|(_, axis)| places.iter().any(|places| places.contains_key(&axis.letter)));
            with_place.fold(0, |bits, (index, _)| bits | 1 << index)
        };
        let clamps = rules.clamps() & state.clamps_known;
        let held = match due {
            ClampsDue::AsBefore => 0,
            ClampsDue::Positioned => rotated,
            ClampsDue::Parked => rotated | with_place(&[&links.park]),
        };
        let loose = letter(rules, clamps & held & !state.clamped);
        if let Some(letter) = loose {
            return Some(format!("{letter} has been positioned since the machine retract, and is not clamped here"));
        }
        // One that is at its place already is clamped there.
        let placed = state.clamped & with_place(&[&links.park, &links.tool_position, &links.tool_change_position]);
        let switched = clamps & known & !rotated & !placed & (clamped ^ state.clamped);
        letter(rules, switched).map(|letter| {
            format!("the clamp of {letter} has been switched since the machine retract, and the axis has not rotated")
        })
    }

    /// The cuts may go on after a rewind.
    pub(super) fn interrupt_cuts(&mut self) {
        let (unclamped, moved) = (std::mem::take(&mut self.unclamped), std::mem::take(&mut self.moved));
        self.interrupted = Some(InterruptedCuts { unclamped, moved, rewound: 0 });
        self.tool_axis = None;
    }

    /// The cuts go on after a rewind.
    pub(super) fn resume_cuts(&mut self) {
        let InterruptedCuts { unclamped, moved, rewound } = self.interrupted.take().unwrap_or_default();
        self.unclamped |= unclamped;
        self.moved |= moved | rewound;
    }

    /// What is wrong with the clamps of cuts that did not go on.
    pub(super) fn end_of_interrupted(&mut self, rules: &Rules<'_>) -> Option<String> {
        let InterruptedCuts { unclamped, moved, .. } = self.interrupted.take()?;
        loose(rules, unclamped & !moved)
    }

    /// What is wrong with the clamps of the motions between two approaches.
    pub(super) fn end_of_cuts(&mut self, rules: &Rules<'_>) -> Option<String> {
        self.tool_axis = None;
        loose(rules, std::mem::take(&mut self.unclamped) & !std::mem::take(&mut self.moved))
    }
}

/// Rotary axes in the cuts before a retract that may be a rewind: bits.
#[derive(Debug, Clone, Copy, Default)]
struct InterruptedCuts {
    /// Not clamped in a cut.
    unclamped: u16,
    /// Moved since the approach.
    moved: u16,
    /// Moved since the retract: if the cuts go on, by the rewind.
    rewound: u16,
}

fn loose(rules: &Rules<'_>, bits: u16) -> Option<String> {
    letter(rules, bits).map(|letter| format!("{letter} has not moved since the approach, and was not clamped in a cut"))
}

fn letter(rules: &Rules<'_>, bits: u16) -> Option<char> {
    let found = |(index, _): &(usize, &Axis)| bits & (1 << index) != 0;
    rules.axes().iter().enumerate().find(found).map(|(_, axis)| axis.letter)
}

/// Whether tolerances of smoothing for rotary axes are the same, as far as they are rounded.
fn is_angle(angles: [Option<f64>; 2]) -> bool {
    match angles.map(|angle| angle.map(f64::to_degrees)) {
        [Some(expected), Some(written)] => (expected - written).abs() <= ROUNDED_TOLERANCE,
        [expected, written] => expected.is_none() && written.is_none(),
    }
}

/// Whether a programmed tolerance is the one that is required.
fn is_blending(tolerance_mm: Option<f64>, required_mm: f64, rules: &Rules<'_>) -> bool {
    let off = tolerance_mm.map(|written| (written - required_mm).abs());
    off.is_some_and(|off| off <= ROUNDED_TOLERANCE * rules.units().in_mm())
}

fn angle_shown(angle_rad: Option<f64>) -> String {
    angle_rad.map_or_else(|| "no tolerance".to_owned(), |angle| format!("a tolerance of {}°", angle.to_degrees()))
}

fn shown(tolerance_mm: Option<f64>, rules: &Rules<'_>) -> String {
    tolerance_mm.map_or_else(
        || "without a tolerance".to_owned(),
        |tolerance| format!("within {}", rules.units().length(tolerance)),
    )
}

/// The length that a guard must read; `None` where the control cannot read it.
fn guarded(rules: &Rules<'_>, required: &Required) -> Option<LengthSource> {
    match rules.facts().guard_source {
        GuardSource::Spindle => (required.tool == Some(required.register)).then_some(LengthSource::Spindle),
        GuardSource::Registers { largest } => {
            (1..=largest).contains(&required.register).then_some(LengthSource::Register(required.register))
        }
        GuardSource::Edge => Some(LengthSource::Edge),
        GuardSource::Row => required.tool.map(LengthSource::Tool),
    }
}

/// What is wrong with the place of a line of the shop with these places in the configuration: nothing if it may come
/// here for one of them; `ended`: the CL data is done.
pub(super) fn place_of_line(places: &[OwnPlace], phase: &Phase, motions: u64, ended: bool) -> Option<String> {
    let wrong = |place: &OwnPlace| match place {
        OwnPlace::Start => (motions > 0).then_some("after the first motion"),
        OwnPlace::End => (!ended || phase.is_at_part()).then_some("before the end of the CL data"),
        OwnPlace::MillTurn => match phase {
            Phase::Retracted(retracted) if retracted.step > 0 => Some("after the approach has begun"),
            _ => None,
        },
        OwnPlace::Safety
        | OwnPlace::ToolChange
        | OwnPlace::OperationStart
        | OwnPlace::OperationEnd
        | OwnPlace::MeasureTool
        | OwnPlace::CheckTool
        | OwnPlace::ToolStart { .. }
        | OwnPlace::ToolEnd { .. } => match phase {
            Phase::Retracted(retracted) if retracted.step > 0 => Some("after the approach has begun"),
            _ => phase.is_at_part().then_some("at the part"),
        },
        OwnPlace::Insert | OwnPlace::Unconfirmed => Some("that the CL data does not have here"),
        OwnPlace::Retract { .. }
        | OwnPlace::Clamp { .. }
        | OwnPlace::Coolant
        | OwnPlace::Spindle { .. }
        | OwnPlace::TipControl { .. } => None,
    };
    let mut faults = places.iter().map(|place| {
        let what = place.key().map_or_else(
            || "a block of INSERT, AUXFUN, PREFUN or a statement of the shop".to_owned(),
            |key| format!("a line of `{key}`"),
        );
        wrong(place).map(|wrong| format!("{what} {wrong}"))
    });
    let first = faults.next().flatten()?;
    faults.all(|fault| fault.is_some()).then_some(first)
}
