//! Fit of a configuration to a control: settings that the control does not support and a program is not safe without,
//! and the functions that the planner may use (the [`Abilities`] of `motion`).

use super::dialects::{
    ArcCentre, Control, ControlFunction, CycleCodes, CycleForm, LengthCall, LinearRapids, PlaneGuard, RadiusGuard,
    RetractForm, STANDARD_M, Spellings, ThreadCodes, TipControlCodes,
};
use super::foreign::of_another_control;
use super::mill_turn::ToolSpindle;
use super::options::{Demands, PlaneBy, RetractMethod};
use super::state_values::ControlState;
use super::template::{self, OF_TOOL};
use crate::keys::list;
use crate::kinematics::{AnyMachine, Side};
use crate::motion::{
    self, Abilities, CutterRadius, CycleAbilities, OperationBlocks, PlaneAbility, Registers, TipAbility, TipStart,
    UnusedCycles, UsableModes, rotaries_of,
};
use crate::options::{StretchMode, ThreadFeed, Transition, Wrap};
use crate::program::{Coolant, Units};
use crate::set_up::LengthMode;
use crate::tolerance::writer::INDEX_STEP_NOISE;

/// Largest number of characters of a tool name.
const LONGEST_TOOL_NAME: usize = 32;

/// Settings that the control does not support and a program is not safe without, and reasons why machine, control and
/// configuration do not suit the mode. One sentence each; empty if a program can be written. In mode `auto` a setting
/// may still be missing for a stretch. What a program does without is in [`take_out_lacking`](super::take_out_lacking).
#[must_use]
pub(crate) fn unfit(machine: &dyn AnyMachine, control: &dyn Control, demands: Demands<'_>) -> Vec<String> {
    let mut faults = unsupported(control, demands);
    faults.extend(unsuited_names(machine, control.spellings(), demands));
    faults.extend(unreadable_axis(control, demands));
    faults.extend(needs_linear_names(demands));
    faults.extend(unwritable_steps(demands));
    let abilities = abilities(control, demands);
    if demands.options.plane_by == Some(PlaneBy::DynamicOffset)
        && rotaries_of(machine.axes(), Side::Tool).next().is_some()
    {
        faults.push(
            "`control.plane_by = \"dynamic_offset\"`: G254 does not allow for a rotary axis in the head: leave the key out"
                .to_owned(),
        );
    }
    let (title, has_planes) = (control.spellings().title, abilities.has_planes(machine.axes()));
    faults.append(&mut motion::unsuited(machine, demands.policy(), title, abilities.tip, has_planes));
    faults
}

/// The modes that mode `auto` chooses from.
#[must_use]
pub(crate) fn usable_modes(machine: &dyn AnyMachine, control: &dyn Control, demands: Demands<'_>) -> UsableModes {
    let abilities = abilities(control, demands);
    let has_planes = abilities.has_planes(machine.axes());
    UsableModes::of(machine, demands.policy(), control.spellings().title, abilities.tip, has_planes)
}

/// Steps of indexed axes that the rotary words cannot state exactly: multiples of the rounded step would be other
/// angles.
fn unwritable_steps(demands: Demands<'_>) -> impl Iterator<Item = String> {
    let policy = demands.policy();
    let units_per_degree = 10_f64.powi(policy.formats.rotary.cast_signed());
    policy.options.rotaries.grid.iter().filter_map(move |(letter, step)| {
        let units = step.to_degrees() * units_per_degree;
        let exact = units.round() >= 1.0 && (units - units.round()).abs() <= INDEX_STEP_NOISE * units;
        (!exact).then(|| {
            let last = 1.0 / units_per_degree;
            format!(
                "the indexing step of {letter} is not a multiple of {last} degrees, the last digit of rotary words: correct \
                 `grid` or `formats.rotary`"
            )
        })
    })
}

/// Settings of the configuration that the control does not support, one sentence each.
fn unsupported(control: &dyn Control, demands: Demands<'_>) -> Vec<String> {
    let (codes, options) = (control.spellings(), &demands.options);
    let title = codes.title;
    let mut faults = Vec::new();
    if let Some(name) = options.name.as_ref().filter(|name| *name != codes.name) {
        faults.push(format!(
            "this configuration is for `{name}`, and the program for `{}`: leave `--control` out, or `control.name` of a file that \
             serves several controls",
            codes.name
        ));
    }
    faults.extend(unknown_words(control, demands));
    let digits = codes.number_digits;
    if digits > 0 && options.program_number.is_some_and(|number| number.to_string().len() > digits) {
        faults.push(format!("`control.program_number` has too many digits: {title} permits at most {digits}"));
    }
    if codes.length.call == LengthCall::WithTool && demands.set_up.length_mode == LengthMode::Gauge {
        faults.push(format!("{title} activates the tool length in every tool call: set `length_mode = \"tip\"`"));
    }
    let by_sign = demands.motion.rotaries.wrap.iter().filter(|(_, wrap)| **wrap == Wrap::Sign);
    faults.extend(by_sign.filter(|_| codes.shortest_word.is_some()).map(|(letter, _)| {
        format!("{title} takes no direction from the sign of a rotary word: set `wrap.{letter} = \"0..360\"`")
    }));
    if demands.motion.cycles.thread_feed == ThreadFeed::PerRevolution && codes.per_revolution.is_empty() {
        faults.push(format!("threads of {title} take their pitch in any case: leave `cycles.thread_feed` out"));
    }
    let with_length = codes.tip.as_ref().and_then(|tip| tip.with_length).is_some();
    if with_length && demands.options.tip_control_codes().is_some() {
        faults.push(format!(
            "{title} switches tip control on with the length of the tool, and a length called after another code would end it: leave \
             `control.tip_control` out"
        ));
    }
    if demands.options.tool_spindle().is_some() && codes.tool_change.iter().any(|block| block.contains("{speed}")) {
        faults.push(format!(
            "{title} takes the speed in the tool call, for the spindle of M3: set `spindle = \"master\"` in `control.mill_turn`"
        ));
    }
    if matches!(demands.options.tool_spindle(), Some(ToolSpindle::Number(_))) && control.family() != "siemens" {
        faults.push(format!("{title} calls no spindle by its number: give three codes in `control.mill_turn`"));
    }
    let named =
        |key: &str, codes: &[String; 2]| codes.iter().map(|code| (key.to_owned(), code.clone())).collect::<Vec<_>>();
    let clamps = demands.motion.rotaries.clamp.iter();
    let of_shop = clamps
        .flat_map(|(letter, codes)| named(&format!("clamp.{letter}"), &[codes.on.clone(), codes.off.clone()]))
        .chain(options.coolant.iter().flatten().flat_map(|codes| named("control.coolant", codes)))
        .chain(options.tip_control_codes().into_iter().flat_map(|codes| named("control.tip_control", codes)));
    for (key, code) in of_shop {
        let known = || STANDARD_M.iter().chain(codes.own_m);
        let own = m_function(&code).and_then(|number| known().find(|(own, _)| *own == number));
        faults.extend(own.map(|(_, effect)| {
            format!(
                "`{code}` of `{key}` is an M function of {title} itself ({effect}): enter that of the machine builder"
            )
        }));
    }
    // A line with a declared effect is executed by that alone.
    let ends = |text: &str| {
        text.split_whitespace().any(|word| m_function(word).is_some_and(|number| PROGRAM_ENDS.contains(&number)))
    };
    let declared = options.effects.keys().map(String::as_str).chain(control.effects().iter().map(|(text, _)| *text));
    let measuring = options.measure_tool.iter().chain(&options.check_tool).map(String::as_str);
    for text in declared.chain(measuring).filter(|text| ends(text)) {
        faults.push(format!(
            "`{text}` ends the program: it can have no other effect, and nothing after it would be executed"
        ));
    }
    // The check could not tell the pressures from each other.
    let through = |index: usize| options.coolant[index].as_ref().map(|[on, _]| on.as_str());
    let plain = through(2).or(codes.coolant[2].map(|[on, _]| on));
    let pressures = [plain, through(4), through(5), through(6)];
    for (index, code) in pressures.iter().enumerate() {
        if let Some(code) = code.filter(|_| pressures[..index].contains(code)) {
            faults.push(format!(
                "two pressures of coolant through the spindle have the code {code}: leave one of them out of \
                 `control.coolant`"
            ));
        }
    }
    if options.plane_by == Some(PlaneBy::TiltedPlane) && !options.has(ControlFunction::Planes) {
        faults.push("`control.plane_by = \"tilted_plane\"`: \"planes\" is not among `control.functions`".to_owned());
    }
    if options.plane_by == Some(PlaneBy::DynamicOffset) {
        let reason = no_moved_zero(codes, demands);
        faults.extend(reason.map(|reason| format!("`control.plane_by = \"dynamic_offset\"`: {reason}")));
    }
    faults.extend(unsupported_retract(codes, options.retract_method.as_ref()));
    faults.extend(control.effects().iter().filter_map(|(text, effect)| effect.refusal(text)));
    for (number, tool) in &demands.set_up.tools {
        for (wanted, blocks, key, of_tool) in [
            (tool.measured, &options.measure_tool, "measure_tool", "measured"),
            (tool.checked, &options.check_tool, "check_tool", "checked"),
        ] {
            if wanted && blocks.is_empty() {
                faults.push(format!(
                    "T{number} has `{of_tool} = true`, but `cycles.{key}` has no blocks for it: give those of the machine"
                ));
            }
        }
        faults.extend(tool.start.iter().chain(&tool.end).filter_map(|block| {
            let fault = template::check(block, OF_TOOL).err()?;
            Some(format!("in the block `{block}` of `[tools.{number}]` {fault}"))
        }));
    }
    let program = &options.program;
    let of_operations = [
        ("program.operation_start", program.operation_start.is_empty()),
        ("program.operation_end", program.operation_end.is_empty()),
    ];
    if demands.motion.rapids.transition == Transition::Direct {
        faults.extend(of_operations.iter().filter(|(_, empty)| !empty).map(|(key, _)| {
            format!(
                "with `transition = \"direct\"` operations follow each other at the part, where no blocks of the shop \
                 belong: remove `transition`, or `{key}`"
            )
        }));
    }
    let lists: Vec<&Vec<String>> = [&program.start, &program.end, &program.operation_start, &program.operation_end]
        .into_iter()
        .chain(options.own_retract())
        .chain([&options.measure_tool, &options.check_tool])
        .chain(demands.set_up.tools.values().flat_map(|tool| [&tool.start, &tool.end]))
        .chain(&options.tool_change)
        .chain(&options.safety)
        .collect();
    faults.extend(lists.iter().filter_map(|blocks| unfinished_cycle(codes, blocks)));
    let blocks: Vec<&String> = lists.into_iter().flatten().collect();
    let is_too_long = |line: &&str| line.len() > codes.line_length || !line.is_ascii();
    for line in blocks.iter().flat_map(|block| block.split('\n')).filter(is_too_long) {
        faults.push(format!(
            "a line of {title} has at most {} characters, ASCII only: correct the block `{line}`",
            codes.line_length
        ));
    }
    faults.extend(blocks.into_iter().filter_map(|block| of_another_control(codes, block)));
    faults
}

/// A cycle of several lines that is not written as one: its parameters are alone, or all in one line.
fn unfinished_cycle(codes: &Spellings, blocks: &[String]) -> Option<String> {
    let is_parameter = |text: &str| {
        let digits =
            text.trim_start().strip_prefix('Q').map(|rest| rest.trim_start_matches(|of: char| of.is_ascii_digit()));
        digits.is_some_and(|rest| rest.trim_start().starts_with('='))
    };
    // Those of the form `CYCL DEF 32.1` have no parameters of their own lines.
    let is_cycle = |text: &str| {
        let number = ["TCH PROBE ", "CYCL DEF "].into_iter().find_map(|word| text.strip_prefix(word));
        number.is_some_and(|rest| !rest.trim_start_matches(|of: char| of.is_ascii_digit()).starts_with('.'))
    };
    let separate = blocks.windows(2).find(|pair| is_cycle(&pair[0]) && is_parameter(&pair[1])).map(|pair| &pair[0]);
    let joined = || {
        let mut lines = blocks.iter().filter(|block| is_cycle(block));
        lines.find(|block| block.split('\n').any(|line| line.split('~').skip(1).any(is_parameter)))
    };
    let block = separate.or_else(joined).filter(|_| codes.numbers_every_line)?;
    let first = block.split(['~', '\n']).next().unwrap_or_default().trim();
    Some(format!(
        "the parameters of the cycle `{first}` follow it line by line: give each line as an element of the list, all but the \
         last with `~` at the end"
    ))
}

/// M functions that end a program or a subprogram.
const PROGRAM_ENDS: [u16; 3] = [2, 17, 30];

/// Number of the M function with which a block begins.
fn m_function(block: &str) -> Option<u16> {
    let number = block.trim().strip_prefix('M')?;
    let end = number.find(|letter: char| !letter.is_ascii_digit()).unwrap_or(number.len());
    number[..end].parse().ok()
}

/// Reason why the control has no such machine retract.
fn unsupported_retract(codes: &Spellings, method: Option<&RetractMethod>) -> Option<String> {
    let title = codes.title;
    let name = match method? {
        RetractMethod::Named(name) if codes.retracts.iter().any(|retract| retract.name == name) => return None,
        RetractMethod::Named(name) => name,
        // The check knows each block by its text.
        RetractMethod::Blocks(blocks) => {
            let repeated = (1..blocks.len()).find(|&index| blocks[..index].contains(&blocks[index]))?;
            return Some(format!("`retract.method` has the block `{}` twice: write it once", blocks[repeated]));
        }
    };
    let names = list(codes.retracts.iter().map(|retract| retract.name), '"');
    let instead = format!("`retract.method` may be {names}, or a list of blocks");
    Some(match name.as_str() {
        "G28" => format!("in absolute mode G28 leads through the point of its words, which is at the part: {instead}"),
        "clearance" => format!(
            "a tool at the clearance geometry is clear of the part in one position of the rotary axes only, and at a restart \
             point its position is unknown: {instead}; a nearer `retract.position` shortens the retract"
        ),
        name => format!("{title} has no machine retract `{name}`: {instead}"),
    })
}

/// Tip control: that of the control, or the codes of the configuration.
fn tip_ability(control: &dyn Control, demands: Demands<'_>) -> Option<TipAbility> {
    if !demands.options.has(ControlFunction::TipControl) || renamed_linear_axis(demands).is_some() {
        return None;
    }
    let configured = demands.options.tip_control_codes().is_some();
    let start = |tip: &TipControlCodes| match tip.with_length {
        _ if configured => TipStart::Configured,
        None => TipStart::Alone,
        Some(_) => TipStart::WithMotion { dynamic_offset: no_moved_zero(control.spellings(), demands).is_none() },
    };
    let own = control.spellings().tip.as_ref().map(|tip| TipAbility {
        start: start(tip),
        frame_is_parameter: tip.frame_is_set,
        rotates_axis_in_plane: tip.turns_in_plane,
        takes_vectors: tip.vectors.is_some() && !configured,
        holds_axis_speeds: control.spellings().tip_control_holds_axis_speeds,
    });
    let plain = TipAbility {
        start: TipStart::Configured,
        frame_is_parameter: false,
        rotates_axis_in_plane: false,
        takes_vectors: false,
        holds_axis_speeds: control.spellings().tip_control_holds_axis_speeds,
    };
    own.or_else(|| configured.then_some(plain))
}

/// Work offsets and axis names that the control cannot have.
fn unknown_words(control: &dyn Control, demands: Demands<'_>) -> Vec<String> {
    let (title, options) = (control.spellings().title, &demands.options);
    let mut faults = Vec::new();
    let own = std::iter::once(("work_offset", &demands.set_up.work_offset));
    let further = demands.set_up.set_ups.values().filter_map(|set_up| set_up.work_offset.as_ref());
    for (key, offset) in own.chain(further.map(|offset| ("set_ups", offset))) {
        if control.work_offset(offset).is_none() {
            faults.push(format!("{title} has no work offset `{offset}`: correct `{key}`"));
        }
    }
    for (letter, name) in &options.axes {
        if control.axis_word(name).is_none() {
            faults
                .push(format!("{title} permits no axis name `{name}`: correct the name of {letter} in `control.axes`"));
        }
    }
    faults
}

/// Why the zero of the words cannot follow the table in mode "plane".
fn no_moved_zero(codes: &Spellings, demands: Demands<'_>) -> Option<String> {
    let Some([code, _]) = codes.tip.as_ref().and_then(|tip| tip.dynamic_offset) else {
        return Some(format!("{} has no dynamic work offset", codes.title));
    };
    if !demands.options.has(ControlFunction::DynamicOffset) {
        return Some(format!("{code} is not among `control.functions`: add \"dynamic_offset\" if the control has it"));
    }
    let (letter, _) = demands.set_up.rotary_offset.iter().find(|(_, offset)| **offset != 0.0)?;
    Some(format!(
        "{code} needs 0 for the rotary axes in the work offset, and `rotary_offset.{letter}` is another value"
    ))
}

/// A linear axis whose word is not its letter. Arcs, cycles, planes, tip control and cutter compensation of a control
/// count in X, Y and Z.
fn renamed_linear_axis(demands: Demands<'_>) -> Option<(char, &str)> {
    let renamed = demands.options.axes.iter().map(|(letter, name)| (*letter, name.as_str()));
    renamed.into_iter().find(|(letter, name)| "XYZ".contains(*letter) && !name.chars().eq([*letter]))
}

/// What needs the names X, Y and Z, where a linear axis has another one.
fn needs_linear_names(demands: Demands<'_>) -> Option<String> {
    let (letter, name) = renamed_linear_axis(demands)?;
    let mode = demands.motion.mode_of_all().filter(|mode| *mode != StretchMode::Axes);
    let (what, remedy) = match demands.motion.compensation {
        Some(_) => ("cutter compensation (`compensation.path`)".to_owned(), "leave `compensation.path` out"),
        None => (format!("`mode = \"{}\"`", mode?.name()), "set `mode = \"axes\"`"),
    };
    Some(format!(
        "{what} counts in X, Y and Z, and `control.axes` gives {letter} the name {name}: {remedy}, or rename no linear axis"
    ))
}

/// A renamed rotary axis whose position the guard of planes cannot read.
fn unreadable_axis(control: &dyn Control, demands: Demands<'_>) -> Option<String> {
    let mut renamed = demands.options.axes.iter().filter(|(letter, _)| "ABC".contains(**letter));
    let is_unreadable = |(_, name): &(&char, &String)| {
        let guard = PlaneGuard { label: 1, axes: vec![((*name).clone(), 0.0)] };
        let guards = control.compares_rotary_positions() && control.axis_word(name).is_some();
        guards && control.plane_guard(&guard).is_empty()
    };
    let (_, name) = renamed.find(is_unreadable).filter(|_| demands.motion.guards.plane_guard)?;
    let title = control.spellings().title;
    Some(format!("{title} cannot read the position of an axis named {name}: set `plane_guard = false`"))
}

/// Reasons why tools cannot be called by their names.
fn unsuited_names(machine: &dyn AnyMachine, codes: &Spellings, demands: Demands<'_>) -> Vec<String> {
    let (title, set_up) = (codes.title, demands.set_up);
    if !demands.options.tool_names || codes.tool_name.is_none() {
        return Vec::new();
    }
    let mut faults = Vec::new();
    let names = || set_up.tools.iter().filter_map(|(number, tool)| Some((number, tool.name.as_ref()?)));
    for (number, name) in names() {
        if name.len() > LONGEST_TOOL_NAME || name.is_empty() || !name.bytes().all(codes.tool_name_byte) {
            faults.push(format!("{title} permits no tool name `{name}`: correct `[tools.{number}] name`"));
        }
        if let Some((other, _)) = names().find(|(other, known)| *other < number && known.eq_ignore_ascii_case(name)) {
            faults.push(format!(
                "T{other} and T{number} have the same name `{name}`: with `control.tool_names` they are one tool"
            ));
        }
    }
    // The guard of a control whose registers are rows reads the row of this number.
    let head = rotaries_of(machine.axes(), Side::Tool).next().is_some();
    let needed = demands.motion.mode_of_all().is_none_or(|mode| mode == StretchMode::Axes) && head;
    if codes.length.registers == Registers::Rows && demands.motion.guards.length_guard.unwrap_or(needed) {
        faults.push(format!(
            "the length guard of {title} reads the row of the tool number: set `length_guard = false` with `control.tool_names`"
        ));
    }
    faults
}

/// Radius that cutter compensation takes. The blocks of a tool change may be those of the configuration.
fn cutter_radius(control: &dyn Control, demands: Demands<'_>) -> CutterRadius {
    let codes = control.spellings();
    let has_delta = |block: &str| block.contains("{radius_delta}");
    let guard = RadiusGuard { tool: 1, largest_wear_mm: 1.0, units: Units::Millimetres };
    if codes.compensation[1].contains("{radius}") {
        CutterRadius::Register
    } else if codes.tool_change.iter().any(|block| has_delta(block)) {
        let own = demands.options.tool_change.as_ref();
        CutterRadius::WithDelta { written: own.is_none_or(|blocks| blocks.iter().any(|block| has_delta(block))) }
    } else {
        CutterRadius::OfTool { guarded: !control.radius_guard(&guard).is_empty() }
    }
}

/// Whether the components of the tool axis have the letters of an arc centre, I J K.
fn vectors_take_arc_words(codes: &Spellings) -> bool {
    let vectors = codes.tip.as_ref().and_then(|tip| tip.vectors.as_ref());
    codes.arcs.centre == ArcCentre::Offsets && vectors.is_some_and(|vectors| vectors.words[0] == "I")
}

/// A thread that is not in step with the spindle does not stop it.
fn cycle_abilities(codes: &Spellings, demands: Demands<'_>) -> CycleAbilities {
    let Some(cycles) = &codes.cycles else { return CycleAbilities::default() };
    let floats = match &cycles.form {
        CycleForm::Codes(CycleCodes { thread: ThreadCodes::Cycle { rigid, .. }, .. }) => {
            !rigid.is_empty() && !demands.motion.cycles.rigid
        }
        CycleForm::Codes(_) | CycleForm::Definitions(_) => false,
    };
    if renamed_linear_axis(demands).is_some() {
        let unused = (cycles.abilities != CycleAbilities::default()).then_some(UnusedCycles::AxisNames);
        return CycleAbilities { unused, ..CycleAbilities::default() };
    }
    // A cycle runs the spindle of M3.
    let master = demands.options.tool_spindle().is_none();
    let threads = cycles.abilities.tap || cycles.abilities.fine_bore.is_some();
    CycleAbilities {
        unused: (!master && threads).then_some(UnusedCycles::OtherSpindle),
        tap: cycles.abilities.tap && master,
        fine_bore: cycles.abilities.fine_bore.filter(|_| master),
        tap_is_motion: matches!(cycles.form, CycleForm::Codes(CycleCodes { thread: ThreadCodes::Motion(_), .. })),
        tap_stops_spindle: cycles.abilities.tap_stops_spindle && !floats,
        tap_per_revolution: cycles.abilities.tap_uses_feed && !codes.per_revolution.is_empty(),
        ..cycles.abilities
    }
}

/// Functions of the control that the planner may use.
#[must_use]
pub(crate) fn abilities(control: &dyn Control, demands: Demands<'_>) -> Abilities {
    let codes = control.spellings();
    let has = |kind: &Coolant| {
        kind.index().is_some_and(|index| {
            demands.options.coolant[index].is_some() || codes.coolant.get(index).copied().flatten().is_some()
        })
    };
    let has_planes = demands.options.has(ControlFunction::Planes) && renamed_linear_axis(demands).is_none();
    Abilities {
        coolants: Coolant::KINDS.into_iter().filter(has).collect(),
        length_call_may_move: codes.length.call == LengthCall::WithZ,
        registers: codes.length.registers,
        linear_rapids: demands.options.linear_rapids.unwrap_or(codes.linear_rapids != LinearRapids::No),
        path_norm: demands.options.path_norm.unwrap_or(codes.path_norm),
        largest_inverse_time: demands.motion.feed.largest_inverse_time.unwrap_or(codes.largest_inverse_time),
        feed_per_inch: codes.feed_per_inch,
        cycles: cycle_abilities(codes, demands),
        cycle_gaps_mm: ControlState::gaps_mm(codes.name, &demands.options.states),
        cutter_radius: cutter_radius(control, demands),
        straight_corners: codes.straight_corners,
        tools_by_name: demands.options.tool_names,
        arc_planes: codes.arcs.planes.map(|plane| plane.is_some() && renamed_linear_axis(demands).is_none()),
        vectors_take_arc_words: vectors_take_arc_words(codes),
        arc_radius_tolerance_mm: codes.arcs.radius_tolerance_mm,
        helix_by_angle: codes.arcs.centre == ArcCentre::Pole,
        tip: tip_ability(control, demands),
        plane: codes.plane.as_ref().filter(|_| has_planes).map(|plane| PlaneAbility {
            angles: plane.angles,
            decimals: plane.decimals.unwrap_or(demands.formats.rotary),
            pose: plane.pose,
            ends_after_retract: plane.cancelled_after_retract,
            length_first: plane.length_first,
        }),
        plane_by_moved_zero: demands.options.plane_by != Some(PlaneBy::TiltedPlane)
            && no_moved_zero(codes, demands).is_none(),
        retracts_along_tool: matches!(demands.options.retract_form(codes), Some(RetractForm::AlongTool { .. })),
        retract_keeps_length: codes.length.call == LengthCall::WithZ
            && matches!(demands.options.retract_form(codes), Some(RetractForm::ReferencePosition { .. })),
        guards_planes: demands.motion.guards.plane_guard && control.compares_rotary_positions(),
        times_faint_moves: codes.times_faint_moves,
        guards_offset: demands.motion.guards.offset_guard && !control.offset_guard(1).is_empty(),
        skips_guards: codes.skips_guards,
        operation_blocks: OperationBlocks {
            at_start: !demands.options.program.operation_start.is_empty(),
            at_end: !demands.options.program.operation_end.is_empty(),
            stop_spindle: [&demands.options.program.operation_start, &demands.options.program.operation_end]
                .map(|lines| lines.iter().any(|line| demands.motion.standstill.iter().any(|word| word.is_in(line)))),
        },
    }
}
