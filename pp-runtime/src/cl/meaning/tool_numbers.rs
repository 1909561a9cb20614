//! Meaning of the numbers of a tool call that have no word before them.
//!
//! CATIA writes the number of the tool compensation after that of the tool: `LOADTL/%MFG_TL_NUMBER,%MFG_TOOL_COMP` (*PP
//! Word Tables and Syntaxes*, NC_COMPENSATION). The posts of Autodesk and HSMWorks (*Common ISO 4343 APT*, *CAMplete
//! APT*) write 0, the length of the tool's body and the length offset, and *Generative Machining APT* the same with
//! words, after IN. The body is a part of the gauge length only, so it is not used. In NCL the second number is the
//! length: without a CAM system that is known, a configuration states the meaning.

use super::options::{ReadingOptions, ToolArg};
use crate::cl::dialect::Dialect;
use crate::cl::record::ToolCallRecord;
use crate::cl::text::{ClFault, Span};
use crate::diag::code::cl;

/// Numbers of CATIA.
const OF_CATIA: [ToolArg; 1] = [ToolArg::Offset];

/// Numbers of Autodesk and HSMWorks.
const OF_AUTODESK: [ToolArg; 3] = [ToolArg::Ignored, ToolArg::Ignored, ToolArg::Offset];

fn fault(at: Span, text: impl Into<String>, help: impl Into<String>) -> ClFault {
    cl::TOOL_NUMBER.cl_fault("number after the tool", at, text, help)
}

/// Returns the call with its numbers under their meaning.
pub(crate) fn with_names(
    call: &ToolCallRecord,
    options: &ReadingOptions,
    dialect: Dialect,
) -> Result<ToolCallRecord, ClFault> {
    let mut tool = *call;
    if call.magazine.is_some() {
        tool.length = None;
    }
    let numbers = &call.numbers[..call.count];
    let configured = options.tool_args.as_slice();
    let known: &[ToolArg] = if !configured.is_empty() {
        configured
    } else if numbers.iter().all(|value| is_whole(*value) == Some(call.number)) {
        // Some CAM systems repeat the tool number.
        return Ok(tool);
    } else {
        match dialect {
            Dialect::Catia => &OF_CATIA,
            Dialect::Autodesk => &OF_AUTODESK,
            Dialect::Generic | Dialect::Nx | Dialect::Creo | Dialect::SolidWorks | Dialect::Iso => &[],
        }
    };
    if numbers.is_empty() {
        return Ok(tool);
    }
    if numbers.len() != known.len() {
        return Err(unknown(call, configured.len()));
    }
    for (arg, value) in known.iter().zip(numbers) {
        match arg {
            ToolArg::Ignored => {}
            ToolArg::Length => {
                if *value <= 0.0 || tool.length.replace(*value).is_some() {
                    let text = format!("the gauge length of tool {} is stated twice, or is not above 0", call.number);
                    return Err(fault(call.at, text, "check `[cl.loadtl] args`: is this number the gauge length?"));
                }
            }
            ToolArg::Offset => {
                let register = is_whole(*value).filter(|register| *register > 0);
                let other = tool.offset.filter(|other| Some(*other) != register);
                let (Some(register), None) = (register, other) else {
                    let text = format!("{value} is no length offset register for tool {}", call.number);
                    let help =
                        "without effect it is `[cl.loadtl] args = [\"ignored\"]`, then the register is the tool number";
                    return Err(fault(call.at, text, help));
                };
                tool.offset = Some(register);
            }
        }
    }
    Ok(tool)
}

/// The number, if it is whole and in the range of registers.
fn is_whole(value: f64) -> Option<u32> {
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // In range, and checked to be whole.
    let whole = (0.0..=f64::from(u32::MAX)).contains(&value) && value.fract().abs() < f64::MIN_POSITIVE;
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    whole.then_some(value as u32)
}

fn unknown(call: &ToolCallRecord, configured: usize) -> ClFault {
    let found = if call.count == 1 { "1 number".to_owned() } else { format!("{} numbers", call.count) };
    let text = match configured {
        0 => format!("LOADTL has {found} without a word after tool {}, whose meaning is unknown", call.number),
        stated => {
            format!("LOADTL has {found} without a word after tool {}, and `[cl.loadtl] args` has {stated}", call.number)
        }
    };
    let example = match call.count {
        1 => "[\"offset\"]",
        2 => "[\"ignored\", \"offset\"]",
        3 => "[\"ignored\", \"ignored\", \"offset\"]",
        _ => "[\"ignored\", \"ignored\", \"offset\", \"ignored\"]",
    };
    let posts =
        if call.count == 3 { "a post of Autodesk or HSMWorks wrote it: `--dialect autodesk`; else " } else { "" };
    let help = format!(
        "{posts}state their meaning in the configuration: `[cl.loadtl]`, `args = {example}` (\"offset\" register, gauge \
         \"length\", \"ignored\")"
    );
    fault(call.at, text, help)
}
