//! The policy of a check, from a configuration and its control.

use crate::check::faults_of_lines;
use crate::check::policy::{
    CheckPolicy, Decimals, FeedPath, FeedPolicy, LinearMeaning, LinkPolicy, OperationRule, OperationSelection,
    RapidForm, RetractRule, RuledOperation, ShopBlocks, ShopLine, SmoothingLevel, StateDefaults, StopRule, TipFrame,
    Tolerances, WordPolicy,
};
use crate::check::read::{Effect, Family, OwnPlace, RolloverRule, coolant};
use crate::cl::{ReadingOptions, StatedTool};
use crate::control::{self, BlockNumbers, Control, LineEffect, Messages, RetractForm, Spellings, ToolSpindle};
use crate::kinematics::{AnyMachine, AxisKind, Machine, Side};
use crate::motion::rotaries_of;
use crate::options::{
    BoreRetract, CutterPath, Links, Mode, OperationChoice, OperationEntry, Operations, OptionalStops, PathNorm, Rapid,
    Rewind, Smoothing, StretchMode, TcpFrame, TcpWords, ThreadFeed, ToolPosture, Transition, Wrap,
};
use crate::program::Units;
use crate::set_up::LengthMode;

use super::Config;

/// The reason why programs of a job cannot be checked. One sentence per line.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct NotCheckable(String);

impl Config {
    /// Policy of the check of programs that are posted with this configuration. `cl_units`: unit of CL data that states
    /// none; takes precedence over that of the configuration.
    ///
    /// # Errors
    /// [`NotCheckable`] if the configuration does not suit control or machine, or programs of the control cannot be
    /// read.
    pub fn check_policy<M: Machine>(
        &self,
        control: &dyn Control,
        cl_units: Option<Units>,
    ) -> Result<CheckPolicy, NotCheckable> {
        self.check_policy_for(&M::default(), control, cl_units)
    }

    /// [`check_policy`](Self::check_policy) for a machine whose type is known at run time only.
    ///
    /// # Errors
    /// Those of [`check_policy`](Self::check_policy).
    pub fn check_policy_for(
        &self,
        machine: &dyn AnyMachine,
        control: &dyn Control,
        cl_units: Option<Units>,
    ) -> Result<CheckPolicy, NotCheckable> {
        let family = Family::of_control(control.family()).ok_or_else(|| {
            NotCheckable(format!(
                "the check cannot read programs of {}: its base or its family must be a control that it reads",
                control.spellings().title
            ))
        })?;
        let unfit = self.unfit(machine, control);
        if !unfit.is_empty() {
            return Err(NotCheckable(unfit.join("\n")));
        }
        Ok(self.for_control(control).policy_of_check(machine, control, family, cl_units))
    }

    /// How the CL data of a job is read. `cl_units`: its unit, where the job gives it.
    pub(crate) fn reading(&self, cl_units: Option<Units>) -> ReadingOptions {
        let tools = self.set_up.tools.iter().map(|(&number, given)| {
            let tool = StatedTool {
                diameter_mm: given.diameter_mm,
                corner_radius_mm: given.corner_radius_mm,
                length_mm: given.length_mm,
                offset: given.offset,
                path_diameter_mm: given.path_diameter_mm,
                is_one: given.one_tool,
            };
            (number, tool)
        });
        ReadingOptions {
            units: cl_units.or(self.cl_units),
            tools: tools.collect(),
            default_tool: self.motion.defaults.tool,
            compensates_centre: self.motion.compensation.map(|path| path == CutterPath::Centre),
            ..self.cl.clone()
        }
    }

    /// The policy, of a configuration that suits its control.
    fn policy_of_check(
        &self,
        machine: &dyn AnyMachine,
        control: &dyn Control,
        family: Family,
        cl_units: Option<Units>,
    ) -> CheckPolicy {
        CheckPolicy {
            family,
            reading: self.reading(cl_units),
            output_units: self.output_units,
            set_up: self.set_up.clone(),
            words: self.word_policy(),
            digits: self.digits(),
            tolerances: self.tolerances(),
            links: self.link_policy(machine, control.spellings()),
            feed: self.feed_policy(),
            defaults: self.state_defaults(),
            selection: self.motion.selected.as_ref().map(|operations| match operations {
                Operations::Range(first, last) => OperationSelection::Range(*first, *last),
                Operations::From(name) => OperationSelection::From(name.clone()),
            }),
            shop: self.shop_blocks(machine, control),
            operations: self.motion.operations.entries.iter().map(rule).collect(),
            edits: self.check.policy(),
        }
    }

    fn word_policy(&self) -> WordPolicy {
        let (tip, control) = (&self.motion.tip, &self.control);
        let rollover = |wrap: Wrap| match wrap {
            Wrap::Positive | Wrap::Symmetric => RolloverRule::Shortest,
            Wrap::Sign => RolloverRule::Sign,
        };
        WordPolicy {
            linear: meaning(self.motion.mode),
            tip_frame: match tip.tcp_frame {
                None | Some(TcpFrame::TableAtZero) => TipFrame::TableAtZero,
                Some(TcpFrame::TableAtStart) => TipFrame::TableAtStart,
                Some(TcpFrame::NotTurning) => TipFrame::Machine,
            },
            axis_in_plane: tip.tool_posture == ToolPosture::Plane,
            posture_word: control.posture_word,
            tool_axis_vectors: tip.tcp_words == TcpWords::Vectors,
            own_tip_codes: control.tip_control_codes().is_some(),
            axis_names: control.axes.clone(),
            rollover: self.motion.rotaries.wrap.iter().map(|(letter, wrap)| (*letter, rollover(*wrap))).collect(),
            plain_numbers: control.point == Some(false),
        }
    }

    fn digits(&self) -> Decimals {
        let formats = &self.formats;
        Decimals {
            linear_mm: formats.linear(Units::Millimetres),
            linear_inch: formats.linear(Units::Inches),
            rotary: formats.rotary,
            speed: formats.speed,
            feed_mm: formats.feed_decimals(Units::Millimetres),
            feed_inch: formats.feed_decimals(Units::Inches),
            pitch_mm: formats.pitch_decimals(Units::Millimetres),
            pitch_inch: formats.pitch_decimals(Units::Inches),
            feed_whole: formats.feed_whole,
            inverse_time: formats.inverse_time,
        }
    }

    fn tolerances(&self) -> Tolerances {
        Tolerances {
            path_mm: self.motion.tolerance_mm,
            axis_path_rad: self.motion.axis_tolerance_path_rad,
            pole_rad: self.motion.course.axis_tolerance_rad,
            has_steps: !self.motion.rotaries.grid.is_empty(),
            stated_may_be_larger: self.motion.allow_lintol,
            blending_mm: self.control.path_tolerance_mm,
        }
    }

    fn link_policy(&self, machine: &dyn AnyMachine, codes: &Spellings) -> LinkPolicy {
        let (motion, control) = (&self.motion, &self.control);
        LinkPolicy {
            rapid: match motion.rapids.rapid {
                Rapid::Direct => RapidForm::OneBlock,
                Rapid::Split => RapidForm::TwoBlocks,
                Rapid::Feed => RapidForm::Feed,
            },
            rapid_feed_mm_per_min: motion.rapids.rapid_feed_mm_per_min,
            follows_links: motion.rapids.links == Links::Follow,
            direct: motion.rapids.transition == Transition::Direct,
            over_clearance: motion.rapids.transition == Transition::Auto
                && rotaries_of(machine.axes(), Side::Tool).next().is_none(),
            index_angle_rad: motion.rapids.index_angle_rad,
            retract_mm: motion.retract.position_mm(),
            retract: match (control.retract_form(codes), control.own_retract()) {
                (_, Some(blocks)) => RetractRule::OwnBlocks(blocks.len()),
                (Some(RetractForm::ReferencePosition { .. }), None) => RetractRule::ReferencePosition,
                (Some(RetractForm::AlongTool { .. }), None) => RetractRule::AlongTool,
                (Some(RetractForm::MachineCoordinate) | None, None) => RetractRule::MachineCoordinate,
            },
            home_mm: motion.retract.home_on_indexing.then(|| {
                let others = machine.axes().iter().filter(|axis| axis.kind == AxisKind::Linear && !axis.held);
                others.map(|axis| (axis.letter, motion.retract.home_mm(axis.letter))).collect()
            }),
            retract_distance_mm: motion.retract.distance_mm,
            clearance: motion.retract.clearance,
            rewinds_in_cut: motion.retract.rewind == Rewind::Follow,
            entry_feed_mm_per_min: motion.retract.entry_feed_mm_per_min,
            rewinds_dry: motion.retract.rewind_dry,
            approach_mm: motion.approach.distance_mm,
            retracts_for_stop: motion.stop_retract,
            optional_stops: match motion.optional_stops {
                OptionalStops::None => StopRule::None,
                OptionalStops::ToolChanges => StopRule::ToolChanges,
                OptionalStops::Operations => StopRule::Operations,
            },
            through_dwell_s: motion.coolant.through_dwell_s,
            spindle_dwell_s: motion.spindle_dwell_s,
            park: motion.park.clone(),
            tool_change_position: motion.retract.tool_change_position.clone(),
            tool_position: motion.tool_position.clone(),
            dry_lift_mm: motion.lift_mm,
        }
    }

    fn feed_policy(&self) -> FeedPolicy {
        FeedPolicy {
            path: self.control.path_norm.map(|norm| match norm {
                PathNorm::Xyz => FeedPath::Linear,
                PathNorm::XyzDegrees => FeedPath::LinearAndDegrees,
                PathNorm::G93Minutes => FeedPath::InverseMinutes,
                PathNorm::G93Seconds => FeedPath::InverseSeconds,
            }),
            keeps_axis_speeds: self.motion.feed.keep_speeds,
            largest_mm_per_min: self.motion.feed.largest_mm_per_min,
            largest_inverse_time: self.motion.feed.largest_inverse_time,
            shortest_block_s: self.motion.feed.shortest_block_s,
            reorient_rad_per_min: self.motion.rapids.reorient_rad_per_min,
            rapids_interpolated: self.control.linear_rapids,
        }
    }

    fn state_defaults(&self) -> StateDefaults {
        let defaults = &self.motion.defaults;
        StateDefaults {
            tool: defaults.tool,
            speed_rev_per_min: defaults.speed_rev_per_min,
            rotation: defaults.rotation,
            coolant: defaults.coolant,
            peck_gap_mm: defaults.peck_gap_mm,
        }
    }

    fn shop_blocks(&self, machine: &dyn AnyMachine, of_job: &dyn Control) -> ShopBlocks {
        let abilities = control::abilities(of_job, self.demands());
        let enters_by_axes = abilities.enters_tip_control_by_axes();
        let control = &self.control;
        let rotary_head = rotaries_of(machine.axes(), Side::Tool).next().is_some();
        // A rotary axis in the head makes axis positions depend on the length.
        let guarded = self.motion.guards.length_guard.unwrap_or(
            rotary_head
                && match self.motion.mode_of_all() {
                    None | Some(StretchMode::Axes) => true,
                    Some(StretchMode::Tcp) => enters_by_axes,
                    Some(StretchMode::Plane) => false,
                },
        );
        ShopBlocks {
            own_safety: control.safety.is_some(),
            length_guard_mm: (guarded && self.set_up.length_mode == LengthMode::Tip)
                .then_some(self.motion.guards.length_tolerance_mm),
            has_planes: abilities.has_planes(machine.axes()),
            guards_tip_control: enters_by_axes,
            guards_rotated_axes_only: self.motion.guards.length_guard.is_none() && self.motion.mode_of_all().is_none(),
            guards_planes: self.motion.guards.plane_guard,
            guards_offset: self.motion.guards.offset_guard,
            functions: control
                .functions
                .as_ref()
                .map(|names| names.iter().map(|function| function.name().to_owned()).collect()),
            smoothing: smoothing_level(control.smoothing),
            smoothing_levels: control.smoothing_levels,
            smoothing_angle_rad: control.smoothing_angle_rad,
            compensated_centre: self.motion.compensation == Some(CutterPath::Centre),
            largest_wear_mm: self.motion.largest_wear_mm,
            rigid_tapping: self.motion.cycles.rigid,
            thread_per_revolution: self.motion.cycles.thread_feed == ThreadFeed::PerRevolution,
            bore_direction: match self.motion.cycles.bore_retract {
                None => [0.0, 0.0],
                Some(BoreRetract::PlusX) => [1.0, 0.0],
                Some(BoreRetract::MinusX) => [-1.0, 0.0],
                Some(BoreRetract::PlusY) => [0.0, 1.0],
                Some(BoreRetract::MinusY) => [0.0, -1.0],
            },
            bore_shift_mm: self.motion.cycles.bore_shift_mm,
            lines: self.shop_lines(machine, of_job),
            // What the job declares takes precedence over its control.
            effects: control
                .effects
                .iter()
                .map(|(text, effect)| (text.clone(), declared(*effect)))
                .chain(of_job.effects().iter().map(|(text, effect)| ((*text).to_owned(), declared(*effect))))
                .chain(self.probing_lines().map(|line| (line.clone(), Effect::Measures)))
                .collect(),
            measuring: control.measure_tool.iter().chain(&control.check_tool).cloned().collect(),
            displays_messages: control.program.messages == Messages::Display,
            tool_names: control.tool_names,
            swivel_data: control.swivel_data.clone().unwrap_or_default(),
            spindle_number: control.tool_spindle().and_then(|spindle| match spindle {
                ToolSpindle::Number(number) => Some(*number),
                ToolSpindle::Master | ToolSpindle::Codes(_) => None,
            }),
            restarts_numbered: control.program.line_numbers == BlockNumbers::Restarts,
            states: control.states.iter().map(|(name, value)| (name.clone(), *value)).collect(),
        }
    }

    /// Lines of the shop whose declared effect or whose motion contradicts the control's own language.
    pub(super) fn unfit_lines(&self, machine: &dyn AnyMachine, control: &dyn Control) -> Vec<String> {
        let Some(family) = Family::of_control(control.family()) else { return Vec::new() };
        let policy = self.for_control(control).policy_of_check(machine, control, family, None);
        let of_config = self.control.effects.iter().map(|(text, effect)| (text.as_str(), declared(*effect)));
        let of_control = control.effects().iter().map(|(text, effect)| (*text, declared(*effect)));
        let statements = self
            .cl
            .own_statements
            .iter()
            .flat_map(|own| own.blocks().iter().map(|block| (own.statement(), block.as_str())));
        faults_of_lines(machine, &policy, of_config.chain(of_control), statements)
    }

    /// The lines with which a probe measures, whatever their codes do.
    fn probing_lines(&self) -> impl Iterator<Item = &String> {
        self.cl.probes.iter().flat_map(|probe| probe.blocks())
    }

    /// The lines that the configuration brings into a program, and those of its control that its family does not have.
    fn shop_lines(&self, machine: &dyn AnyMachine, of_job: &dyn Control) -> Vec<ShopLine> {
        let control = &self.control;
        let mut lines = Vec::new();
        let mut add = |text: &str, place: OwnPlace, coolant: Option<(u8, bool)>| {
            lines.push(ShopLine { text: text.trim().to_owned(), place, coolant });
        };
        control.program.start.iter().for_each(|line| add(line, OwnPlace::Start, None));
        control.program.end.iter().for_each(|line| add(line, OwnPlace::End, None));
        control.program.operation_start.iter().for_each(|line| add(line, OwnPlace::OperationStart, None));
        control.program.operation_end.iter().for_each(|line| add(line, OwnPlace::OperationEnd, None));
        control.safety.iter().flatten().for_each(|line| add(line, OwnPlace::Safety, None));
        control.mill_turn_blocks().for_each(|line| add(line, OwnPlace::MillTurn, None));
        for (code, rotation) in control.tool_spindle().into_iter().flat_map(ToolSpindle::rotations) {
            add(&code, OwnPlace::Spindle { rotation }, None);
        }
        control.tool_change.iter().flatten().for_each(|line| add(line, OwnPlace::ToolChange, None));
        for (index, line) in control.own_retract().into_iter().flatten().enumerate() {
            add(line, OwnPlace::Retract { index }, None);
        }
        control.measure_tool.iter().for_each(|line| add(line, OwnPlace::MeasureTool, None));
        control.check_tool.iter().for_each(|line| add(line, OwnPlace::CheckTool, None));
        for (number, tool) in &self.set_up.tools {
            tool.start.iter().for_each(|line| add(line, OwnPlace::ToolStart { tool: *number }, None));
            tool.end.iter().for_each(|line| add(line, OwnPlace::ToolEnd { tool: *number }, None));
        }
        for (letter, codes) in &self.motion.rotaries.clamp {
            if let Some(axis) = machine.axes().iter().position(|axis| axis.letter == *letter) {
                add(&codes.on, OwnPlace::Clamp { axis, on: true }, None);
                add(&codes.off, OwnPlace::Clamp { axis, on: false }, None);
            }
        }
        let kinds = [coolant::FLOOD, coolant::MIST, coolant::THROUGH, coolant::AIR];
        if let Some(family) = control::by_name(of_job.family()) {
            let (own, known) = (of_job.spellings(), family.spellings());
            let differing =
                |own: &'static [&str], known: &'static [&str]| own.iter().filter(|line| !known.contains(line));
            differing(own.opening, known.opening).for_each(|line| add(line, OwnPlace::Start, None));
            differing(own.safety, known.safety).for_each(|line| add(line, OwnPlace::Safety, None));
            differing(own.tool_change, known.tool_change).for_each(|line| add(line, OwnPlace::ToolChange, None));
            differing(own.closing, known.closing).for_each(|line| add(line, OwnPlace::End, None));
            // What the configuration has takes the place of the codes of its control.
            let replaced = control.coolant.iter().map(Option::is_some);
            for (((codes, known), bit), replaced) in own.coolant.into_iter().zip(known.coolant).zip(kinds).zip(replaced)
            {
                if let Some([on, off]) = codes.filter(|codes| Some(*codes) != known && !replaced) {
                    add(on, OwnPlace::Coolant, Some((bit, true)));
                    add(off, OwnPlace::Coolant, Some((bit, false)));
                }
            }
        }
        for (codes, bit) in control.coolant.iter().zip(kinds.into_iter().chain(coolant::PRESSURES)) {
            if let Some([on, off]) = codes {
                add(on, OwnPlace::Coolant, Some((bit, true)));
                add(off, OwnPlace::Coolant, Some((bit, false)));
            }
        }
        if let Some([on, off]) = control.tip_control_codes() {
            add(on, OwnPlace::TipControl { on: true }, None);
            add(off, OwnPlace::TipControl { on: false }, None);
        }
        self.cl.auxfun.iter().for_each(|code| add(&format!("M{code}"), OwnPlace::Insert, None));
        self.cl.prefun.iter().for_each(|code| add(&format!("G{code}"), OwnPlace::Insert, None));
        for own in self.cl.own_statements.iter().chain(&self.cl.probes) {
            let is_clear = own.is_harmless() || own.probes() || own.code().is_some();
            let place = if is_clear { OwnPlace::Insert } else { OwnPlace::Unconfirmed };
            own.blocks().iter().for_each(|block| add(block, place, None));
        }
        lines
    }
}

/// Meaning of linear words in a mode; `None` where the program decides.
fn meaning(mode: Mode) -> Option<LinearMeaning> {
    match mode {
        Mode::Auto => None,
        Mode::Axes => Some(LinearMeaning::AxisPositions),
        Mode::Tcp => Some(LinearMeaning::TipCoordinates),
        Mode::Plane => Some(LinearMeaning::PlaneCoordinates),
    }
}

fn smoothing_level(smoothing: Smoothing) -> Option<SmoothingLevel> {
    match smoothing {
        Smoothing::None => None,
        Smoothing::Rough => Some(SmoothingLevel::Rough),
        Smoothing::Medium => Some(SmoothingLevel::Medium),
        Smoothing::Finish => Some(SmoothingLevel::Finish),
    }
}

/// The rule of an entry of `[operations]`. The angle of a free axis is none: the cut is the same at every angle.
fn rule(OperationEntry { of, settings }: &OperationEntry) -> OperationRule {
    OperationRule {
        of: match of {
            OperationChoice::Number(number) => RuledOperation::Number(*number),
            OperationChoice::Name(name) => RuledOperation::Name(name.clone()),
            OperationChoice::Pattern(pattern) => RuledOperation::Like(pattern.clone()),
        },
        linear: settings.mode.map(meaning),
        smoothing: settings.smoothing.map(smoothing_level),
        blending_mm: settings.path_tolerance_mm,
        path_mm: settings.tolerance_mm,
        largest_feed_mm_per_min: settings.largest_feed_mm_per_min,
        allowance_mm: settings.allowance_mm,
    }
}

fn declared(effect: LineEffect) -> Effect {
    match effect {
        LineEffect::None => Effect::None,
        LineEffect::Clamp => Effect::Clamp,
        LineEffect::Chuck => Effect::Chuck,
        LineEffect::Door => Effect::Door,
        LineEffect::Pallet => Effect::Pallet,
        LineEffect::Coolant => Effect::Coolant,
        LineEffect::Spindle => Effect::Spindle,
        LineEffect::ToolChange => Effect::ToolChange,
        LineEffect::Stop => Effect::Stop,
        LineEffect::PositionLost => Effect::PositionLost,
        LineEffect::StateLost => Effect::StateLost,
        LineEffect::Measures => Effect::Measures,
    }
}
