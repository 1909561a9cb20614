//! Settings that a control lacks and a program does without, so that one file serves several controls.
//!
//! Each is taken out and named with what the program has in its place. That holds for smoothing, for the form of the
//! program (number, file header, block numbers), for functions that are offered and not asked for, and for a meaning of
//! F that the control cannot have. What a program is not safe without is refused by [`unfit`](super::unfit): a work
//! offset, an axis name, a length that would be active, a program number with more digits than the control stores,
//! blocks that it cannot read.

use super::dialects::{Control, ControlFunction, Spellings};
use super::options::{BlockNumbers, ControlOptions, Messages};
use super::state_values::ControlState;
use crate::options::{OperationTable, PathNorm, Smoothing};

/// Takes the settings that the control lacks out of the options. Returns one sentence each: the setting, and what the
/// program has instead.
pub(crate) fn take_out_lacking(
    control: &dyn Control,
    options: &mut ControlOptions,
    operations: &mut OperationTable,
) -> Vec<String> {
    let codes = control.spellings();
    let title = codes.title;
    let mut lacking = smoothing(codes, options, operations);
    let mut add = |lacks: bool, sentence: &str| {
        if lacks {
            lacking.push(format!("{title} {sentence}"));
        }
        lacks
    };
    if add(
        codes.number_digits == 0 && options.program_number.is_some(),
        "has no program numbers: `control.program_number` is left out",
    ) {
        options.program_number = None;
    }
    if add(
        options.file_header && control.file_header("NAME").is_empty(),
        "has no file header: `control.file_header` is left out",
    ) {
        options.file_header = false;
    }
    if add(
        codes.numbers_every_line && options.program.line_numbers != BlockNumbers::Restarts,
        "numbers every line: `program.line_numbers` is left out",
    ) {
        options.program.line_numbers = BlockNumbers::Restarts;
    }
    if add(
        options.program.messages == Messages::Display && codes.message.is_none(),
        "displays a text only where the program stops: `program.messages` is left out, PPRINT is a comment",
    ) {
        options.program.messages = Messages::Comment;
    }
    if add(
        options.tool_names && codes.tool_name.is_none(),
        "calls tools by number: `control.tool_names` is left out, the numbers are those of the CL data",
    ) {
        options.tool_names = false;
    }
    let swivel = codes.plane.as_ref().is_some_and(|plane| plane.on.iter().any(|block| block.contains("{swivel_data}")));
    if add(options.swivel_data.is_some() && !swivel, "has no swivel data: `control.swivel_data` is left out") {
        options.swivel_data = None;
    }
    let dynamic_offset = ControlFunction::DynamicOffset.can_be_in(codes, false);
    if add(options.plane_by.is_some() && !dynamic_offset, "has no dynamic work offset: `control.plane_by` is left out")
    {
        options.plane_by = None;
    }
    let inverse = matches!(options.path_norm, Some(PathNorm::G93Minutes | PathNorm::G93Seconds));
    if add(
        inverse && codes.inverse_time.is_none(),
        "has no inverse-time feed: `control.path_norm` is left out, F is that of the control's own path",
    ) {
        options.path_norm = None;
    }
    let setting = codes.tip.as_ref().map_or("", |tip| tip.posture_setting[0]);
    if add(
        !options.posture_word && (setting.is_empty() || options.tip_control_codes().is_some()),
        "has no setting that takes the place of the word of the tool posture: `control.posture_word = false` is left out",
    ) {
        options.posture_word = true;
    }
    let own_tip_codes = options.tip_control_codes().is_some();
    options.states.retain(|key, _| {
        let has = ControlState::of(codes.name).any(|state| state.key == key);
        !add(!has, &format!("has no state `{key}`: it is left out of `control.states`"))
    });
    if let Some(functions) = &mut options.functions {
        functions.retain(|function| {
            let can = function.can_be_in(codes, own_tip_codes);
            let name = function.name();
            !add(!can, &format!("cannot have the function `{name}`: it is left out of `control.functions`"))
        });
    }
    lacking
}

/// Smoothing, and its tolerance for rotary axes.
fn smoothing(codes: &Spellings, options: &mut ControlOptions, operations: &mut OperationTable) -> Vec<String> {
    let title = codes.title;
    let mut lacking = Vec::new();
    let smooths = options.smoothing != Smoothing::None || operations.smooths();
    if smooths && codes.smoothing[0].is_empty() {
        lacking.push(format!("{title} has no smoothing levels: smoothing is left out, `path_tolerance` is in force"));
        options.smoothing = Smoothing::None;
        options.smoothing_angle_rad = None;
        for entry in &mut operations.entries {
            entry.settings.smoothing = None;
        }
    }
    let has_levels = codes.smoothing[0].iter().any(|block| block.contains("{smoothing_level}"));
    if options.smoothing_levels.is_some() && !has_levels {
        lacking.push(format!("{title} has no numbers of smoothing levels: `control.smoothing_levels` is left out"));
        options.smoothing_levels = None;
    }
    let mut blocks = codes.smoothing.iter().chain(&codes.smoothing_with_angle).copied().flatten();
    let states_angle = blocks.any(|block| block.contains("{angle}"));
    if smooths && options.smoothing_angle_rad.is_some() && !states_angle {
        lacking.push(format!(
            "smoothing of {title} has no tolerance for rotary axes: `control.smoothing_angle` is left out"
        ));
        options.smoothing_angle_rad = None;
    }
    lacking
}

impl ControlFunction {
    /// Whether a control can have the function. `own_tip_codes`: the configuration has codes of tip control.
    fn can_be_in(self, codes: &Spellings, own_tip_codes: bool) -> bool {
        match self {
            Self::TipControl => codes.tip.is_some() || own_tip_codes,
            Self::Planes => codes.plane.is_some(),
            Self::DynamicOffset => codes.tip.as_ref().is_some_and(|tip| tip.dynamic_offset.is_some()),
            Self::Scaling | Self::Rotation | Self::Polar | Self::SettingError | Self::Smoothing => {
                codes.cancels.iter().any(|cancel| cancel.of == self)
            }
        }
    }
}
