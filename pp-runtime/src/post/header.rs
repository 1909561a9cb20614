//! The header of a program: comments that state machine, set-up, CL file, tools, axis directions and assumptions.
//!
//! Part of it is shown in the summary as well: `assumptions`, `set_up`, `reading` and `unchecked_limits`.

use std::f64::consts::TAU;
use std::io;

use crate::cl::{ArcVote, Dialect, FrameVote, Insert};
use crate::config::Config;
use crate::control::{
    self, BlankWords, Control, ControlState, CycleForm, Encoder, LengthGuard, LinearRapids, ProgramHeader, ProgramUses,
    RetractForm, StepCycles, TipControlSwitch,
};
use crate::kinematics::{AnyMachine, Axis, AxisKind, DimensionKind, Limits, Side, Sign, digest};
use crate::motion::{StretchModes, TipStart, rotaries_of};
use crate::nc::{Decimal, write_decimal};
use crate::options::{CutterPath, CycleOutput, Links, StretchMode, TcpFrame, ToolPosture, Wrap};
use crate::program::{Rotation, Shown, Units};
use crate::set_up::{AxisBounds, ClPoint, GivenTool};
use crate::set_up::{LengthMode, ProgramZero, Stock, part_angles};

use super::survey::{Survey, ToolUse, UsedModes};
use super::{Job, operations};
use crate::diag::counted;
use crate::tolerance::writer::{CONVERTED_NOISE, THINNEST_BLANK};

/// The header and the data that it is written from.
pub(crate) struct Header<'a> {
    pub(crate) job: &'a Job<'a>,
    pub(crate) survey: &'a Survey,
    pub(crate) units: Units,
    pub(crate) machine: &'a dyn AnyMachine,
    /// Linear axes whose limits are not checked, with the reason.
    pub(crate) unchecked: Vec<(char, &'static str)>,
}

fn rotaries(machine: &dyn AnyMachine, side: Side) -> impl Iterator<Item = &'static Axis> {
    rotaries_of(machine.axes(), side).map(|index| &machine.axes()[index])
}

/// Name of the work offset of the first set-up, as the control writes it.
pub(crate) fn work_offset(control: &dyn Control, config: &Config) -> String {
    offset_name(control, &config.set_up.work_offset)
}

fn offset_name(control: &dyn Control, word: &str) -> String {
    let spelled = control.work_offset(word).unwrap_or_else(|| word.to_owned());
    format!("{}{spelled}", control.spellings().offset_title)
}

/// Whether words of the program depend on the place of the part on the table.
fn depends_on_part_origin(machine: &dyn AnyMachine, control: &dyn Control, config: &Config, survey: &Survey) -> bool {
    // A control that takes tip coordinates in the frame of the part needs no part origin: the work offset holds it.
    // Where X and Y come as axis positions over the approach point of tip control, it is needed as well.
    let abilities = control::abilities(control, config.demands());
    let by_axes = abilities.enters_tip_control_by_axes() || abilities.plane.is_none();
    let positions = survey.modes.has(StretchMode::Axes) || survey.modes.has(StretchMode::Tcp) && by_axes;
    (positions || !is_part_frame(config)) && rotaries(machine, Side::Workpiece).next().is_some()
}

/// Whether a bound of a linear axis under a rotary table is compared with positions that the control computes: its
/// travel, or its speed under tip control.
fn bounds_depend_on_part_origin(machine: &dyn AnyMachine, config: &Config, survey: &Survey) -> bool {
    let axes = machine.axes();
    let AxisBounds { limits, speeds } = config.set_up.travel(axes);
    let tip_control = survey.modes.has(StretchMode::Tcp);
    let compared = axes.iter().zip(limits).zip(speeds).any(|((axis, limits), speed)| {
        let travel = limits.is_some() && config.set_up.machine_zero.contains_key(&axis.letter);
        axis.kind == AxisKind::Linear && !axis.held && (travel || tip_control && speed.is_some())
    });
    compared && rotaries(machine, Side::Workpiece).next().is_some()
}

/// Whether words of the program are positions of the axes, or coordinates in a frame that does not go with the part, on
/// a machine with a rotary axis in the table.
pub(crate) fn has_positions(machine: &dyn AnyMachine, control: &dyn Control, config: &Config, survey: &Survey) -> bool {
    let abilities = control::abilities(control, config.demands());
    let moved_zero = TipStart::WithMotion { dynamic_offset: true };
    let comes_by_axes = abilities.enters_tip_control_by_axes()
        && abilities.plane.is_none()
        && abilities.tip.is_some_and(|tip| tip.start != moved_zero);
    let tip = survey.modes.has(StretchMode::Tcp) && (comes_by_axes || !is_part_frame(config));
    (survey.modes.has(StretchMode::Axes) || tip) && rotaries(machine, Side::Workpiece).next().is_some()
}

/// Whether coordinates under tip control are in the frame of the part.
fn is_part_frame(config: &Config) -> bool {
    config.motion.tip.tcp_frame.is_none_or(|frame| frame == TcpFrame::TableAtZero)
}

/// States of the control that cycles of the program read.
fn states(control: &dyn Control, config: &Config, survey: &Survey) -> impl Iterator<Item = &'static ControlState> {
    let native = config.motion.cycles.output == CycleOutput::Native && config.motion.lift_mm.is_none();
    let cycles = if native { survey.step_cycles } else { StepCycles::default() };
    ControlState::used(control.spellings().name, cycles)
}

/// Settings that were assumed because they were not given, one sentence each.
pub(crate) fn assumptions(
    machine: &dyn AnyMachine,
    control: &dyn Control,
    config: &Config,
    survey: &Survey,
) -> Vec<String> {
    let mut list = Vec::new();
    if !survey.file.states_frame {
        list.push("points of the CL data are coordinates from the part zero".to_owned());
    }
    let abilities = control::abilities(control, config.demands());
    if config.part_origin_is_assumed() {
        let words = depends_on_part_origin(machine, control, config, survey);
        let purpose = if words { "" } else { " for travel and speeds of the axes" };
        if words || bounds_depend_on_part_origin(machine, config, survey) {
            list.push(format!("part_origin 0, 0, 0{purpose}: the part zero is the reference point of the table"));
        }
    }
    if !config.is_given("work_offset") {
        list.push(format!("work offset {}", work_offset(control, config)));
    }
    let units = units_of(config, survey);
    if !config.is_given("retract.position") {
        list.push(format!("retract to machine coordinate {}", units.length(config.motion.retract.position_mm())));
    }
    if !config.is_given("approach.distance") {
        list.push(format!(
            "approach distance {} along the tool axis",
            units.length(config.motion.approach.distance_mm)
        ));
    }
    let links = survey.stretches.linked > 0 && config.motion.rapids.links == Links::Follow;
    let delivered = control.spellings().linear_rapids == LinearRapids::AsDelivered;
    if links && delivered && config.control.linear_rapids.is_none() {
        list.push("all axes of a rapid arrive together, as the control is delivered".to_owned());
    }
    if units == Units::Inches && abilities.feed_per_inch > 1.0 && control.spellings().cycles.is_some() {
        let per_inch = abilities.feed_per_inch;
        list.push(format!("F is in 1/{per_inch} inch/min, in cycles (Q206) as well"));
    }
    let rotary = machine.axes().iter().any(|axis| axis.kind == AxisKind::Rotary && !axis.held);
    if rotary && control.spellings().may_begin_in_tip_control && config.control.tip_control.is_none() {
        list.push(
            "the control has no kinematics with tip control in force, from its start (`control.tip_control`)"
                .to_owned(),
        );
    }
    for state in states(control, config, survey).filter(|state| !config.control.states.contains_key(state.key)) {
        list.push(format!("{} is {}", state.title(), state.needed));
    }
    list.extend(assumed_spindles(config, survey));
    let empties = control.spellings().empty_spindle_note;
    if survey.empties_spindle && !empties.is_empty() {
        list.push(empties.to_owned());
    }
    list.extend(config.motion.rotaries.wrap.iter().map(|(letter, wrap)| rolling_over(control, *letter, *wrap)));
    for tool in &survey.tools {
        let number = tool.call.number;
        if gauge_length_mm(tool, config).is_none() {
            list.push(format!("gauge length of T{number} unknown: its length offset must hold the true length"));
        }
    }
    list
}

/// Spindles that the CL data leaves to the configuration.
fn assumed_spindles(config: &Config, survey: &Survey) -> impl Iterator<Item = String> {
    survey.tools.iter().filter(|tool| tool.spindle_assumed).filter_map(|tool| {
        let (number, defaults) = (tool.call.number, &config.motion.defaults);
        let given = config.set_up.tools.get(&number);
        let speed = given.and_then(|tool| tool.speed_rev_per_min).or(defaults.speed_rev_per_min)?;
        let sense = match given.and_then(|tool| tool.rotation).or(defaults.rotation)? {
            Rotation::Clockwise => "CLW",
            Rotation::CounterClockwise => "CCLW",
        };
        Some(format!("spindle of T{number} from the configuration where the CL data has none: S{speed} {sense}"))
    })
}

/// How the control moves an axis whose words are reduced to one revolution.
fn rolling_over(control: &dyn Control, letter: char, wrap: Wrap) -> String {
    match wrap {
        Wrap::Positive | Wrap::Symmetric => {
            let note = control.spellings().shortest_note;
            let note = if note.is_empty() { String::new() } else { format!(": {note}") };
            format!("{letter} rolls over, and the control moves it to every angle by the shortest path{note}")
        }
        Wrap::Sign => format!("{letter} rolls over, and the control rotates it in the direction of the sign"),
    }
}

/// Settings of the set-up that differ from the plain case, one sentence each.
pub(crate) fn set_up(machine: &dyn AnyMachine, control: &dyn Control, config: &Config, survey: &Survey) -> Vec<String> {
    let units = units_of(config, survey);
    let mut list = Vec::new();
    if let Some(Ok(selected)) = &survey.selected {
        let (first, last, all) = (selected.start(), selected.end().min(&survey.operations), survey.operations);
        list.push(format!(
            "only operations {first} to {last} of {all}; the program begins with a complete restart: modal codes, tool, \
             offset, spindle"
        ));
    }
    list.extend(config.left_out.iter().cloned());
    list.extend(operations::settings(config, &survey.settings));
    for (&number, further) in &config.set_up.set_ups {
        let begins = match &further.begins {
            Some(name) => format!("from operation {name}"),
            None => {
                let frames: Vec<String> = further.frames.iter().map(u32::to_string).collect();
                format!("frame {} of the CL data", frames.join(", "))
            }
        };
        let offset = offset_name(control, further.work_offset.as_deref().unwrap_or_default());
        let [x, y, z] = further.part_origin;
        let [x, y, z] = [x, y, z].map(|mm| units.length(mm).number());
        let unit = units.name();
        let mut line = format!("set-up {number}, {begins}: work offset {offset}, part origin X{x} Y{y} Z{z} {unit}");
        let [rx, ry, rz] = part_angles(&further.part_rotation);
        if [rx, ry, rz].iter().any(|angle| angle.abs() > 0.0) {
            line += &format!(", part rotation {rx}, {ry}, {rz} degrees");
        }
        list.push(line);
    }
    let [x, y, z] = part_angles(&config.set_up.part_rotation);
    if [x, y, z].iter().any(|angle| angle.abs() > 0.0) {
        list.push(format!(
            "part rotation {x}, {y}, {z}: the CL data is rotated by these degrees about X, then Y, then Z of the table"
        ));
    }
    list.extend(config.set_up.wider_limits(machine.axes()));
    let options = &config.control;
    let measures = !options.measure_tool.is_empty() || !options.check_tool.is_empty() || !config.cl.probes.is_empty();
    if units == Units::Inches && measures {
        list.push("blocks of `cycles` are written as they are: their lengths are inches in this program".to_owned());
    }
    for state in states(control, config, survey) {
        if let Some(value) = config.control.states.get(state.key) {
            list.push(format!("{} must be {}", state.title(), units.length(*value)));
        }
    }
    list.extend(retract(control, config, units));
    if let Some(lift) = config.motion.lift_mm {
        list.push(format!(
            "DRY RUN: every point is {} further out along the tool axis, spindle and coolant off",
            units.length(lift)
        ));
    }
    if config.set_up.program_zero == ProgramZero::Table {
        list.push(
            "program zero is the reference point of the table: set the work offset there, not at the part".to_owned(),
        );
    }
    if config.set_up.length_mode == LengthMode::Gauge {
        list.push(
            "length mode: linear words are coordinates of the gauge line; no length offset may be active".to_owned(),
        );
    }
    list
}

/// Conditions on the states of the control, one sentence each.
pub(crate) fn conditions(
    machine: &dyn AnyMachine,
    control: &dyn Control,
    config: &Config,
    survey: &Survey,
) -> Vec<String> {
    let rotary = machine.axes().iter().any(|axis| axis.kind == AxisKind::Rotary && !axis.held);
    let native = config.motion.cycles.output == CycleOutput::Native && config.motion.lift_mm.is_none();
    let abilities = control::abilities(control, config.demands());
    let uses = ProgramUses {
        rotary,
        frames: control::FramesUsed::of(machine, &abilities, &survey.modes),
        compensation: config.motion.compensation.is_some(),
        cycles: native && survey.holes,
        offset_guard: abilities.guards_offset,
        length_guard: config.motion.guards.length_guard == Some(true),
    };
    let mut list = control::conditions(control, &config.control, &uses);
    if survey.skips {
        list.push("block skip is as meant for this part: where it is on, the blocks with / are left out".to_owned());
    }
    if rotary && config.control.tip_control == Some(TipControlSwitch::None) {
        list.push("the control has no kinematics with tip control in force, from its start".to_owned());
    }
    list
}

/// Unit of the program.
pub(crate) fn units_of(config: &Config, survey: &Survey) -> Units {
    config.output_units.or(survey.file.units).unwrap_or_default()
}

/// What the machine retract needs where it is no motion to a machine coordinate, and the home positions.
fn retract(control: &dyn Control, config: &Config, units: Units) -> Vec<String> {
    let (retract, position) = (&config.motion.retract, units.length(config.motion.retract.position_mm()));
    let method = match (config.control.own_retract(), config.control.retract_form(control.spellings())) {
        (Some(blocks), _) => {
            Some(format!("machine retract by {}: it must end at machine coordinate {position}", blocks.join(", ")))
        }
        (None, Some(RetractForm::ReferencePosition { .. })) => {
            Some(format!("machine retract to the reference position, which must be machine coordinate {position}"))
        }
        (None, Some(RetractForm::AlongTool { .. })) => {
            Some(format!("machine retract to the end of the travel, which must be machine coordinate {position}"))
        }
        (None, Some(RetractForm::MachineCoordinate) | None) => None,
    };
    let given: Vec<String> =
        retract.xy_mm.iter().map(|(letter, mm)| format!("{letter} {}", units.length(*mm))).collect();
    let home = retract.home_on_indexing.then(|| {
        let positions = if given.is_empty() { String::new() } else { format!("{}, else ", given.join(", ")) };
        format!(
            "before the rotary axes rotate the other linear axes go to machine coordinate {positions}{}",
            units.length(0.0)
        )
    });
    method.into_iter().chain(home).collect()
}

/// Required rotary entries of the work offset, those of the table first.
fn rotary_entries(machine: &dyn AnyMachine, control: &dyn Control, config: &Config) -> Vec<String> {
    let offsets: Vec<String> =
        config.set_up.clampings().map(|(_, part)| offset_name(control, part.work_offset)).collect();
    let entries_of = offsets.join(" and ");
    let axes = [Side::Workpiece, Side::Tool].into_iter().flat_map(|side| rotaries(machine, side));
    let letters = axes.map(|axis| axis.letter);
    let (mut list, mut zero) = (Vec::new(), String::new());
    for letter in letters {
        match config.set_up.rotary_offset.get(&letter) {
            Some(offset) => list.push(format!(
                "words of {letter} are the axis value minus {0}: its entry in {1} must be {0}",
                rounded(offset.to_degrees()),
                entries_of
            )),
            None => zero.push(letter),
        }
    }
    if !zero.is_empty() {
        list.push(format!("the entries of {} in {entries_of} must be zero", joined_by_and(&zero)));
    }
    list
}

/// An angle in degrees without the rounding error of its conversion from radians.
fn rounded(degrees: f64) -> f64 {
    (degrees * 1e9).round() / 1e9 + 0.0
}

/// How the points after frames other than the first were read.
fn frames(vote: &FrameVote, config: &Config) -> Vec<String> {
    let by = match (vote.given, vote.confirmed) {
        (0, 0) => String::new(),
        (0, confirmed) => format!(", confirmed by {}", counted(confirmed, "point")),
        (_, 0) => ", as given".to_owned(),
        (_, confirmed) => format!(", as given, confirmed by {}", counted(confirmed, "point")),
    };
    let into =
        if config.set_up.set_ups.is_empty() { "transformed into the first" } else { "transformed within its set-up" };
    [(vote.mapped, into), (vote.in_first, "points in the first already")]
        .into_iter()
        .filter(|(count, _)| *count > 0)
        .map(|(count, how)| format!("{}: {how}{by}", counted(count, "further frame")))
        .collect()
}

/// How the CL data was read: CAM system, arcs, frames, words that were ignored. One sentence each.
pub(crate) fn reading(config: &Config, survey: &Survey) -> Vec<String> {
    let units = units_of(config, survey);
    let how = match (config.cl.dialect, survey.file.dialect) {
        (Some(_), _) => ", as given",
        (None, Dialect::Generic) => "",
        (None, _) => ", recognised from the file",
    };
    let mut list = vec![format!("CL data of {}{how}", survey.file.dialect.title())];
    if survey.file.units_only_given {
        let unit = survey.file.units.map_or("", Units::name);
        list.push(format!("unit of the CL data is {unit}, as given; the CL file states none"));
    }
    let ArcVote { arcs, agree, against, given } = survey.file.arcs;
    let decided = agree + against;
    if arcs > 0 {
        let arcs = counted(arcs, "arc");
        list.push(match (given, decided) {
            (true, _) => format!("{arcs}, sense as given"),
            (false, 0) => format!("{arcs}, sense by form, not confirmed by a neighbouring line"),
            (false, decided) => {
                format!("{arcs}, sense by form, confirmed by {agree} of {decided} neighbouring lines")
            }
        });
    }
    list.extend(frames(&survey.file.frames, config));
    if survey.file.setup_changes > 0 {
        let times = counted(survey.file.setup_changes, "time");
        list.push(format!("CSYS changes {times}: all points are read in one common frame"));
    }
    if !config.cl.inert.is_empty() {
        list.push(format!("words ignored as inert: {}", config.cl.inert.join(" ")));
    }
    if !config.cl.own_statements.is_empty() {
        let meanings = config
            .cl
            .own_statements
            .iter()
            .map(|own| format!("{} is {}{}", own.statement(), own.blocks().join(" "), own.place().phrase()));
        list.push(format!("statements of the shop: {}", meanings.collect::<Vec<_>>().join(", ")));
    }
    if !config.cl.probes.is_empty() {
        let statements: Vec<&str> = config.cl.probes.iter().map(|probe| probe.statement()).collect();
        list.push(format!("statements of probes: {}", statements.join(" ")));
    }
    let of_tool = |(number, tool): (&u32, &GivenTool)| match (tool.one_tool, tool.path_diameter_mm) {
        (true, _) => {
            Some(format!("T{number} is one tool with the sizes of the configuration, whatever the CL data states"))
        }
        (false, Some(path)) => {
            Some(format!("T{number} follows paths for a diameter of {} on purpose", units.length(path)))
        }
        (false, None) => None,
    };
    list.extend(config.set_up.tools.iter().filter_map(of_tool));
    if let Some(feed) = config.cl.default_feed_mm_per_min {
        list.push(format!("feed until the first FEDRAT: {}, as configured", units.feed(feed)));
    }
    if config.cl.insert == Insert::Write {
        list.push("the text of INSERT is written without a check".to_owned());
    }
    if survey.file.inverse_time {
        list.push("the CL data asks for inverse-time feed: written wherever a rotary axis moves".to_owned());
    }
    list
}

/// Gauge length of a tool, from the configuration, else from the CL data.
fn gauge_length_mm(tool: &ToolUse, config: &Config) -> Option<f64> {
    tool.call.length_mm.or_else(|| config.set_up.tools.get(&tool.call.number)?.length_mm)
}

/// Whether the program can compare the tool length in the control's offset with the posted one (`length_guard`).
pub(crate) fn can_guard_length(job: &Job<'_>, tool: &ToolUse) -> bool {
    let (config, number) = (job.config, tool.call.number);
    let given = config.set_up.tools.get(&number).and_then(|given| given.offset);
    let registers = &job.control.spellings().length.registers;
    let guard = || {
        let offset = registers.of_tool(number, tool.call.length_offset.or(given))?;
        let length_mm = gauge_length_mm(tool, config)?;
        let tolerance_mm = config.motion.guards.length_tolerance_mm;
        // Which unit the program has does not matter.
        let units = Units::Millimetres;
        Some(job.control.length_guard(&LengthGuard { label: 1, tool: number, offset, length_mm, tolerance_mm, units }))
    };
    guard().is_some_and(|blocks| !blocks.is_empty())
}

/// One sentence for each reason why limits of linear axes were not checked, with the axes.
pub(crate) fn unchecked_limits(axes: &[(char, &'static str)]) -> Vec<String> {
    let mut lines: Vec<(&str, String)> = Vec::new();
    for &(letter, why) in axes {
        match lines.iter_mut().find(|(reason, _)| *reason == why) {
            Some((_, letters)) => {
                letters.push(' ');
                letters.push(letter);
            }
            None => lines.push((why, letter.to_string())),
        }
    }
    lines.into_iter().map(|(why, letters)| format!("linear limits not checked: {why} ({letters})")).collect()
}

impl Header<'_> {
    pub(crate) fn write(&self, assumptions: &[String], encoder: &mut Encoder<'_>) -> io::Result<()> {
        let blank = self.blank();
        let config = self.job.config;
        let given = config.set_up.stock.is_some();
        encoder.open(blank.as_ref().map(|blank| (blank, given)))?;
        let mut name = b"PROGRAM ".to_vec();
        name.extend_from_slice(if self.survey.name.is_empty() { b"without name" } else { &self.survey.name });
        encoder.comment(&name)?;
        let lines = match config.control.program.header {
            ProgramHeader::Full => self.full(assumptions, blank.as_ref()),
            ProgramHeader::Short => self.short(),
        };
        // Not every control prints the marks of keys; a blank in their place would be two.
        let marks = (self.job.control.spellings().comment.byte)(b'`') == b'`';
        for line in lines {
            let line = if marks { line } else { line.replace('`', "") };
            encoder.comment(line.as_bytes())?;
        }
        encoder.start()
    }

    /// Lines of the header after the name of the program. `blank`: that of the program, for the graphics of the
    /// control.
    fn full(&self, assumptions: &[String], blank: Option<&Stock>) -> Vec<String> {
        let config = self.job.config;
        let mut lines = vec![
            format!("CL FILE {}", self.job.cl_name),
            format!(
                "MACHINE {}, CONTROL {}, MODE {}",
                self.machine.name(),
                self.job.control.spellings().title,
                UsedModes::of(config, self.survey)
            ),
            format!("UNITS {}, WORK OFFSET {}", self.units.name(), work_offset(self.job.control, config)),
            format!("PART ORIGIN {} from the reference point of the table", self.point(config.set_up.part_origin)),
            format!("PROGRAMMED POINT {}", programmed_point(config)),
            format!("TOLERANCE {} for arcs and curves", self.length(config.motion.tolerance_mm)),
        ];
        let given = config.set_up.stock.is_some();
        if blank.is_some() && !given && !self.job.control.blank(&BlankWords::default()).is_empty() {
            lines.push("BLANK is the box around all cuts, without [stock] in the configuration".to_owned());
            // BLK FORM FILE of newer Heidenhain controls: no public page with its words was found.
            if config.set_up.solids.stock.is_some() {
                lines.push(
                    "the solid `stock` of [solids] is for the simulation, and not passed to the control".to_owned(),
                );
            }
        }
        if config.set_up.stock.is_some_and(|stock| stock.round) && blank.is_some_and(|blank| !blank.round) {
            lines.push(
                "BLANK is the box around the cylinder of [stock], which is not about X0 Y0 of the program".to_owned(),
            );
        }
        lines.extend(set_up(self.machine, self.job.control, config, self.survey));
        lines.extend(self.compensation());
        lines.extend(self.fine_boring());
        lines.extend(reading(config, self.survey));
        let has_rotaries =
            rotaries(self.machine, Side::Workpiece).chain(rotaries(self.machine, Side::Tool)).next().is_some();
        let tolerances = (has_rotaries && self.rotates_in_cuts()).then(|| {
            format!(
                "WHILE A ROTARY AXIS MOVES the tip stays within {} of its line at feed, the tool axis within {} deg of \
                 its great circle",
                self.length(config.motion.tolerance_mm),
                (config.motion.axis_tolerance_path_rad.to_degrees() * 1e6).round() / 1e6
            )
        });
        lines.extend(self.machine_lines(tolerances));
        lines.extend(
            conditions(self.machine, self.job.control, config, self.survey)
                .into_iter()
                .map(|condition| format!("CONDITION {condition}")),
        );
        lines.extend(assumptions.iter().map(|assumption| format!("ASSUMED {assumption}")));
        lines
    }

    /// Lines of the header with what the operator needs for this job alone: set-up, offsets and tools.
    fn short(&self) -> Vec<String> {
        let (config, control) = (self.job.config, self.job.control);
        let mut lines = vec![
            format!("MACHINE {}, MODE {}", self.machine.name(), UsedModes::of(config, self.survey)),
            format!("UNITS {}, WORK OFFSET {}", self.units.name(), work_offset(control, config)),
        ];
        lines.extend(set_up(self.machine, control, config, self.survey));
        lines.extend(self.compensation());
        lines.extend(self.fine_boring());
        lines.extend(self.set_up_lines());
        lines
    }

    /// What the radius data of the control must hold.
    fn compensation(&self) -> Option<String> {
        let data = &self.job.control.spellings().radius_data;
        self.job.config.motion.compensation.map(|path| match path {
            CutterPath::Centre => format!("CUTTER COMPENSATION of the centre path: {}", data[1]),
            CutterPath::Contour => format!("CUTTER COMPENSATION of the contour: {}", data[0]),
        })
    }

    /// How the tool leaves the wall of a bore where the spindle has stopped at its angle.
    fn fine_boring(&self) -> Option<String> {
        let cycles = &self.job.config.motion.cycles;
        let direction = cycles.bore_retract?.name();
        let setting = match &self.job.control.spellings().cycles.as_ref()?.form {
            CycleForm::Codes(codes) if codes.fine_bore.is_empty() => return None,
            CycleForm::Codes(codes) => codes.bore_setting,
            CycleForm::Definitions(_) => "",
        };
        let setting = if setting.is_empty() { String::new() } else { format!(": {setting} must be {direction}") };
        Some(format!(
            "FINE BORING: the tool leaves the wall along {direction} by {}{setting}",
            self.units.length(cycles.bore_shift_mm)
        ))
    }

    /// Whether rotary axes move in cuts.
    fn rotates_in_cuts(&self) -> bool {
        self.survey.modes.has(StretchMode::Axes) || self.survey.modes.has(StretchMode::Tcp)
    }

    /// The blank in the coordinates of the program, mm: that of the configuration, or else a box around all cuts and
    /// the tool's radius. A cylinder that is not about X0 Y0 becomes the box around it. None where all cuts lie in one
    /// plane, and none in length mode `gauge`.
    fn blank(&self) -> Option<Stock> {
        let config = self.job.config;
        let mut blank = config.set_up.stock.or_else(|| self.around_cuts())?;
        if config.set_up.program_zero == ProgramZero::Table {
            for (index, origin) in config.set_up.part_origin.into_iter().enumerate() {
                blank.lower[index] += origin;
                blank.upper[index] += origin;
            }
            let [x, y, _] = config.set_up.part_origin;
            blank.round &= x.abs() <= 0.0 && y.abs() <= 0.0;
        }
        let flat = (0..3).any(|index| blank.upper[index] - blank.lower[index] < THINNEST_BLANK);
        Some(blank).filter(|_| !flat && config.set_up.length_mode == LengthMode::Tip)
    }

    /// Box around all cuts, widened in X and Y by the radius of each tool, mm.
    fn around_cuts(&self) -> Option<Stock> {
        let boxes = self.survey.tools.iter().filter_map(|tool| {
            let radius = tool.radius_mm(self.job.config).unwrap_or(0.0);
            let [lower, upper] = tool.cuts_mm?;
            let margin = [radius, radius, 0.0];
            Some((std::array::from_fn(|i| lower[i] - margin[i]), std::array::from_fn(|i| upper[i] + margin[i])))
        });
        let around = |one: ([f64; 3], [f64; 3]), other: ([f64; 3], [f64; 3])| {
            (std::array::from_fn(|i| one.0[i].min(other.0[i])), std::array::from_fn(|i| one.1[i].max(other.1[i])))
        };
        boxes.reduce(around).map(|(lower, upper)| Stock { lower, upper, round: false })
    }

    /// Lines about kinematics, axes, limits, work offset and tools. `tolerances`: the line about motions with rotary
    /// axes.
    pub(crate) fn machine_lines(&self, tolerances: Option<String>) -> Vec<String> {
        let mut lines =
            vec![format!("KINEMATICS {} of pp-runtime {}", digest(self.machine), env!("CARGO_PKG_VERSION"))];
        lines.extend(self.dimensions());
        lines.extend((0..self.machine.axes().len()).map(|index| self.axis_line(index)));
        lines.extend(tolerances);
        lines.extend(self.meanings());
        lines.extend(unchecked_limits(&self.unchecked));
        lines.extend(self.set_up_lines());
        lines
    }

    /// Lines about what the words of axes mean, and the settings of the control for that.
    fn meanings(&self) -> Vec<String> {
        let mut lines: Vec<String> = self.rotary_words().into_iter().collect();
        lines.extend(mode_lines(self.machine, self.job.control, self.job.config, &self.survey.modes));
        lines
    }

    /// Lines that the set-up sheet has as well: what the control must hold for this program besides its conditions.
    pub(crate) fn settings(&self) -> Vec<String> {
        let mut lines = self.meanings();
        lines.extend(rotary_entries(self.machine, self.job.control, self.job.config));
        lines.extend(self.compensation());
        lines.extend(self.fine_boring());
        lines
    }

    /// Lines about part origin, work offset and tools.
    fn set_up_lines(&self) -> Vec<String> {
        let config = self.job.config;
        let mut lines = Vec::new();
        if self.survey.modes.has(StretchMode::Axes) && rotaries(self.machine, Side::Workpiece).next().is_some() {
            for (number, part) in config.set_up.clampings() {
                let which = if config.set_up.set_ups.is_empty() { String::new() } else { format!("SET-UP {number}: ") };
                lines.push(format!(
                    "{which}valid only for part origin {} from the reference point of the table; do not touch off again",
                    self.point(part.part_origin)
                ));
            }
        }
        for (number, part) in config.set_up.clampings() {
            let entries = config.set_up.work_offset_mm(self.machine, number);
            if entries.is_empty() {
                continue;
            }
            let entries: String = entries.iter().map(|(letter, mm)| format!(" {letter}{}", self.length(*mm))).collect();
            let offset = offset_name(self.job.control, part.work_offset);
            lines.push(match self.job.control.spellings().offset_has_coordinates {
                true => format!("{offset} must hold{entries}"),
                false => format!(
                    "the zero of {offset} must be at{entries} in the display REF, gauge line, rotary axes at zero"
                ),
            });
        }
        lines.extend(rotary_entries(self.machine, self.job.control, config));
        lines.extend(self.survey.tools.iter().flat_map(|tool| self.tool_lines(tool)));
        lines
    }

    /// The dimensions in force; none where the machine has no dimensions.
    fn dimensions(&self) -> Option<String> {
        let values = self.machine.dimensions().iter().enumerate().map(|(index, dimension)| {
            let value = self.machine.dimension(index);
            match dimension.kind {
                DimensionKind::Length => format!("{} = {} mm", dimension.name, Shown(value)),
                DimensionKind::Angle => format!("{} = {} deg", dimension.name, rounded(value.to_degrees())),
            }
        });
        let values: Vec<String> = values.collect();
        (!values.is_empty()).then(|| format!("DIMENSIONS {}", values.join(", ")))
    }

    /// Required setting of the control for rotary words below 0 or beyond 360; none where every rotary axis rolls over
    /// or has its travel between them, or none has words.
    fn rotary_words(&self) -> Option<String> {
        let (wrap, codes) = (&self.job.config.motion.rotaries.wrap, self.job.control.spellings());
        let axes = self.machine.axes();
        let limits = self.job.config.set_up.travel(axes).limits;
        let rotary = axes.iter().zip(limits).filter(|(axis, _)| axis.kind == AxisKind::Rotary && !axis.held);
        let (counting, others): (Vec<_>, Vec<_>) = rotary.partition(|(axis, limits)| {
            !wrap.contains_key(&axis.letter) && !limits.is_some_and(is_within_one_revolution)
        });
        let letters: String = counting.iter().map(|(axis, _)| axis.letter).collect();
        if letters.is_empty() || !self.rotates_in_cuts() {
            return None;
        }
        let of = if others.is_empty() { String::new() } else { format!(" of {}", joined_by_and(&letters)) };
        let shortest = codes.rotary_path[1];
        let note = match wrap.values().any(|wrap| *wrap != Wrap::Sign) && !shortest.is_empty() {
            true => format!("{shortest} is active, so these axes must not be displayed within one revolution"),
            false => codes.rotary_note.to_owned(),
        };
        Some(format!("ROTARY WORDS{of} are absolute and may go below 0 or beyond 360: {note}"))
    }

    /// A point in the unit of the program.
    pub(crate) fn point(&self, point_mm: [f64; 3]) -> String {
        let [x, y, z] = point_mm.map(|value| self.length(value));
        format!("X{x} Y{y} Z{z}")
    }

    /// A length in the unit of the program.
    pub(crate) fn length(&self, length_mm: f64) -> String {
        let decimals = self.job.config.formats.linear(self.units);
        let mut text = Vec::new();
        write_decimal(&mut text, Decimal::fixed(length_mm / self.units.in_mm(), decimals).unwrap_or_default());
        String::from_utf8_lossy(&text).into_owned()
    }

    /// Positive direction of an axis in words; for a held axis its required position.
    fn axis_line(&self, index: usize) -> String {
        let axis = &self.machine.axes()[index];
        let letter = axis.letter;
        if axis.held {
            let value = self.machine.held()[index];
            let value = if axis.kind == AxisKind::Rotary { value.to_degrees() } else { value / self.units.in_mm() };
            return format!("AXIS {letter} is not moved and must be at {value}");
        }
        let direction = direction_name(self.machine.joint(index).direction.into_inner().into());
        let word = match axis.sign {
            Sign::Plus => "as in ISO 841",
            Sign::Minus => "opposite to ISO 841",
        };
        let moves = match (axis.kind, axis.side, axis.sign) {
            (AxisKind::Linear, Side::Tool, Sign::Plus) => format!("+ moves the tool along {direction}"),
            (AxisKind::Linear, Side::Tool, Sign::Minus) => format!("+ moves the tool against {direction}"),
            (AxisKind::Linear, Side::Workpiece, Sign::Plus) => format!("+ moves the table against {direction}"),
            (AxisKind::Linear, Side::Workpiece, Sign::Minus) => format!("+ moves the table along {direction}"),
            (AxisKind::Rotary, Side::Tool, Sign::Plus) => format!("+ rotates the tool right-handed about {direction}"),
            (AxisKind::Rotary, Side::Tool, Sign::Minus) => format!("+ rotates the tool left-handed about {direction}"),
            (AxisKind::Rotary, Side::Workpiece, Sign::Plus) => {
                format!("+ rotates the table left-handed about {direction}")
            }
            (AxisKind::Rotary, Side::Workpiece, Sign::Minus) => {
                format!("+ rotates the table right-handed about {direction}")
            }
        };
        format!("AXIS {letter}{moves}, {word}")
    }

    /// Data and use of a tool; a second line where the program is valid for its posted length only.
    fn tool_lines(&self, tool: &ToolUse) -> Vec<String> {
        let config = self.job.config;
        let number = tool.call.number;
        let given = config.set_up.tools.get(&number);
        let mut text = format!("T{number}");
        if let Some(name) = given.and_then(|given| given.name.as_deref()) {
            text += &format!(" {name}");
        }
        let [diameter, corner] = GivenTool::size_mm(given, &tool.call);
        if let Some(diameter) = diameter {
            text += &format!(" DIA {}", self.length(diameter));
        }
        if let Some(radius) = corner {
            text += &format!(" R{}", self.length(radius));
        }
        let length = gauge_length_mm(tool, config);
        text += &length.map_or_else(|| " L unknown".to_owned(), |length| format!(" L{}", self.length(length)));
        let registers = &self.job.control.spellings().length;
        let offset = tool.call.length_offset.or(given.and_then(|given| given.offset));
        let register = match registers.registers.of_tool(number, offset) {
            Some(offset) if !registers.address.is_empty() => format!("{}{offset}", registers.address),
            _ => "the tool table".to_owned(),
        };
        if !registers.address.is_empty() && config.set_up.length_mode == LengthMode::Tip {
            text += &format!(" {register}");
        }
        text += &format!(", {}", counted(tool.operations, "operation"));
        if let Some((low, high)) = tool.tip_z_mm {
            text += &format!(", tip Z {} to {}", self.length(low), self.length(high));
        }
        let mut lines = vec![text];
        let gauge_line = config.set_up.length_mode == LengthMode::Gauge;
        if let Some(length) = length
            && (gauge_line
                || self.survey.modes.has(StretchMode::Axes) && rotaries(self.machine, Side::Tool).next().is_some())
        {
            let mut held = format!("{register} must hold exactly this");
            if config.motion.guards.length_guard != Some(false) && !can_guard_length(self.job, tool) {
                held += "; no block of this program compares it";
            }
            let length = self.length(length);
            let who = if gauge_line { "the tool must be exactly this long" } else { &held };
            lines.push(format!("T{number} posted with L = {length}: {who}"));
        }
        lines
    }
}

/// Meaning of the linear words under tip control and in planes, and required settings of the control.
fn mode_lines(machine: &dyn AnyMachine, control: &dyn Control, config: &Config, modes: &StretchModes) -> Vec<String> {
    let codes = control.spellings();
    let table = rotaries(machine, Side::Workpiece).next().is_some();
    let abilities = control::abilities(control, config.demands());
    let compared = match abilities.guards_planes {
        true => "",
        false => "no block of this program compares the rotary axes after a plane call",
    };
    let mixed = modes.used().count() > 1;
    let mut lines = Vec::new();
    let mut add = |mode: StretchMode, words: &str, notes: &[&str]| {
        let which = match mode {
            _ if !mixed => "LINEAR WORDS",
            StretchMode::Axes => "LINEAR WORDS elsewhere",
            StretchMode::Tcp => "LINEAR WORDS under tip control",
            StretchMode::Plane => "LINEAR WORDS in planes",
        };
        lines.push(format!("{which} are {words}"));
        let notes = notes.iter().filter(|note| !note.is_empty());
        lines.extend(notes.map(|note| format!("MODE {}: {note}", mode.name())));
    };
    if modes.has(StretchMode::Tcp) {
        let frame = match config.motion.tip.tcp_frame {
            None | Some(TcpFrame::TableAtZero) => {
                "fixed to the table, aligned with the machine axes when its rotary axes are at zero"
            }
            Some(TcpFrame::TableAtStart) => {
                "fixed to the table, aligned with the machine axes at the start of tip control"
            }
            Some(TcpFrame::NotTurning) => "that does not rotate with the table",
        };
        let posture = match config.motion.tip.tool_posture {
            ToolPosture::Axes => "rotary axes move evenly",
            ToolPosture::Plane => "the tool axis rotates in the plane of its start and end",
        };
        let words = format!("tip coordinates in a frame {frame}; {posture}");
        let tip = codes.tip.as_ref();
        let start = abilities.tip.filter(|_| table && abilities.plane.is_some()).map(|tip| tip.start);
        let calls = start.is_some_and(TipStart::is_over_tilted_table);
        let frame = tip.filter(|_| table).map_or("", |tip| match config.motion.tip.tcp_frame {
            None | Some(TcpFrame::TableAtZero) => tip.frame_settings[0],
            Some(TcpFrame::TableAtStart) => tip.frame_settings[1],
            Some(TcpFrame::NotTurning) => tip.frame_settings[2],
        });
        let setting = tip.filter(|_| !config.control.posture_word);
        let setting =
            setting.map(|tip| tip.posture_setting[usize::from(config.motion.tip.tool_posture == ToolPosture::Plane)]);
        add(
            StretchMode::Tcp,
            &words,
            &[tip.map_or("", |tip| tip.note), frame, setting.unwrap_or(""), if calls { compared } else { "" }],
        );
    }
    if modes.has(StretchMode::Plane) {
        if abilities.moves_zero_in_planes(machine.axes()) {
            let words = "tip coordinates along the axes of the machine, from the zero that has moved with the table";
            add(StretchMode::Plane, words, &[]);
        } else {
            let words = "tip coordinates in the tilted plane, from the same zero";
            add(StretchMode::Plane, words, &[codes.plane.as_ref().map_or("", |plane| plane.note), compared]);
        }
    }
    if mixed && modes.has(StretchMode::Axes) {
        add(StretchMode::Axes, "positions of the axes", &[]);
    }
    lines
}

/// The point of the tool that the CL data describes.
fn programmed_point(config: &Config) -> String {
    let name = |point: ClPoint| match point {
        ClPoint::Tip => "tool tip",
        ClPoint::Centre => "centre of the corner radius",
    };
    let mut text = name(config.cl.cl_point).to_owned();
    for (tool, point) in &config.cl.cl_point_of {
        text += &format!(", for T{tool} {}", name(*point));
    }
    text
}

/// Whether the angles of a rotary axis with this travel are those that a control displays within one revolution, from 0
/// to 360°.
fn is_within_one_revolution(travel: Limits) -> bool {
    // Degrees of a declaration are rounded in rad.
    travel.lower >= -CONVERTED_NOISE && travel.upper <= TAU + CONVERTED_NOISE
}

/// `C and B`.
fn joined_by_and(letters: &str) -> String {
    let letters: Vec<String> = letters.chars().map(String::from).collect();
    letters.join(" and ")
}

/// Name of a direction: `+Z`, or its components where it is not along a coordinate axis.
fn direction_name(direction: [f64; 3]) -> String {
    for (index, letter) in ['X', 'Y', 'Z'].into_iter().enumerate() {
        if (direction[index].abs() - 1.0).abs() < 1e-12 {
            return format!("{}{letter}", if direction[index] > 0.0 { '+' } else { '-' });
        }
    }
    let [x, y, z] = direction;
    format!("[{x:.4}, {y:.4}, {z:.4}]")
}
