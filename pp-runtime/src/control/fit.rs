//! Whether a configuration fits a control, and what the planner may ask of the two: the abilities of `motion`.

use crate::kinematics::AnyMachine;
use crate::motion::{self, Abilities, CycleAbilities, Mode, PathNorm, PlaneAbility, TcpWords, TipAbility};
use crate::program::Coolant;
use crate::set_up::LengthMode;

use super::dialects::{ArcCentre, Control, LengthCall, coolant_index};
use super::options::{Demands, Smoothing};

/// Demands of the configuration that the control cannot meet, and why machine, control and configuration do not suit the
/// mode that is asked for: one sentence each, none if a program can be written.
#[must_use]
pub fn unfit(machine: &dyn AnyMachine, control: &dyn Control, demands: Demands<'_>) -> Vec<String> {
    let Abilities { tip, plane, .. } = abilities(control, demands);
    let mut faults = beyond(control, demands);
    faults.append(&mut motion::unsuited(machine, demands.policy(), control.spellings().title, tip, plane));
    faults
}

/// Demands of the configuration that the control cannot meet.
fn beyond(control: &dyn Control, demands: Demands<'_>) -> Vec<String> {
    let (codes, setup) = (control.spellings(), &demands.options);
    let title = codes.title;
    let mut faults = Vec::new();
    for offset in std::iter::once(&demands.set_up.work_offset).chain(demands.set_up.frames.values()) {
        if control.work_offset(offset).is_none() {
            faults.push(format!("{title} has no work offset `{offset}`"));
        }
    }
    for (letter, name) in &setup.axes {
        if control.axis_word(name).is_none() {
            faults.push(format!("{title} cannot have an axis `{name}`, which is to be the name of {letter}"));
        }
    }
    if setup.program_number.is_some_and(|number| number.to_string().len() > codes.number_digits) {
        faults.push(match codes.number_digits {
            0 => format!("programs of {title} have no number"),
            digits => format!("programs of {title} have a number of at most {digits} digits"),
        });
    }
    if setup.file_header && control.file_header("NAME").is_empty() {
        faults.push(format!("programs of {title} do not begin with the name of their file: leave `file_header` out"));
    }
    if codes.length.call == LengthCall::WithTool && demands.set_up.length_mode == LengthMode::Gauge {
        faults.push(format!("{title} takes the length with every tool call: leave `length_mode` at \"tip\""));
    }
    if codes.counted && demands.options.program.line_numbers.is_some() {
        faults.push(format!("{title} counts every line by itself: leave `line_numbers` out"));
    }
    if setup.smoothing != Smoothing::None && codes.smoothing[0].is_empty() {
        faults.push(format!("{title} has no smoothing levels: give it `path_tolerance`"));
    }
    let inverse = matches!(setup.path_norm, Some(PathNorm::G93Minutes | PathNorm::G93Seconds));
    if inverse && codes.inverse_time.is_none() {
        faults.push(format!("{title} has no inverse-time feed: `path_norm` is \"xyz\" or \"xyz+deg\""));
    }
    let blocks = [&demands.options.program.start, &demands.options.program.end]
        .into_iter()
        .chain(&setup.tool_change)
        .chain(&setup.safety)
        .flatten();
    for block in blocks.filter(|block| block.len() > codes.line_length || !block.is_ascii()) {
        faults.push(format!("{title} reads lines of at most {} bytes of ASCII: `{block}`", codes.line_length));
    }
    faults
}

/// Tip control as the control has it, or as the configuration switches it.
fn tip_ability(control: &dyn Control, demands: Demands<'_>) -> Option<TipAbility> {
    let own = control.spellings().tip.as_ref().map(|tip| TipAbility {
        frame_is_set: tip.frame_is_set,
        turns_in_plane: tip.turns_in_plane,
        takes_vectors: tip.vectors.is_some() && demands.options.tip_control.is_none(),
    });
    let plain = TipAbility { frame_is_set: false, turns_in_plane: false, takes_vectors: false };
    own.or_else(|| demands.options.tip_control.is_some().then_some(plain))
}

/// The letters of a centre mean the tool axis, so that no arc can be written.
fn centre_is_axis(control: &dyn Control, demands: Demands<'_>) -> bool {
    let codes = control.spellings();
    let vectors = codes.tip.as_ref().and_then(|tip| tip.vectors.as_ref());
    let used = demands.motion.mode == Mode::Tcp && demands.motion.tip.tcp_words == TcpWords::Vectors;
    used && codes.arcs.centre == ArcCentre::Offsets && vectors.is_some_and(|vectors| vectors.words[0] == "I")
}

/// Abilities that the planner may use.
#[must_use]
pub fn abilities(control: &dyn Control, demands: Demands<'_>) -> Abilities {
    let codes = control.spellings();
    let has = |kind: Coolant| {
        let index = coolant_index(kind).unwrap_or_default();
        demands.options.coolant[index].is_some() || codes.coolant[index].is_some()
    };
    Abilities {
        flood: has(Coolant::Flood),
        mist: has(Coolant::Mist),
        through: has(Coolant::Through),
        air: has(Coolant::Air),
        length_call_may_move: codes.length.call == LengthCall::WithZ,
        registers: codes.length.registers,
        path_norm: demands.options.path_norm.unwrap_or(codes.path_norm),
        feed_per_inch: codes.feed_per_inch,
        cycles: codes.cycles.as_ref().map_or_else(CycleAbilities::default, |cycles| cycles.can),
        shared_radius_registers: codes.compensation[1].contains("{radius}"),
        arc_planes: codes.arcs.planes.map(|plane| plane.is_some() && !centre_is_axis(control, demands)),
        arc_radius_tolerance_mm: codes.arcs.radius_tolerance,
        tip: tip_ability(control, demands),
        plane: codes.plane.as_ref().map(|plane| PlaneAbility {
            angles: plane.angles,
            decimals: plane.decimals.unwrap_or(demands.formats.rotary),
            pose: plane.pose,
            ends_behind_retract: plane.ends_behind_retract,
        }),
    }
}
