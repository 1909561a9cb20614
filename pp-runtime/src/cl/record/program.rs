//! Records of the program as a whole: names, operations, messages, stops, literal NC text, and records that are only
//! checked.

use std::fmt::{self, Display, Formatter};

use super::Record;
use super::values::{Text, write_on_off};
use crate::cl::text::{Args, ClFault, Span};

/// A record that is neither a motion nor a state of the machine.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ProgramRecord<'a> {
    /// `PARTNO text`, `PARTNO/text`, `PARTNO/'text'`.
    PartName(Text<'a>),
    /// `MACHIN/name,n[,..]`: the name.
    MachineName(Text<'a>),
    /// `TOOL PATH/name,TOOL,toolname`, `OPNAME/'name'`: the name.
    ToolPath {
        /// Name of the operation.
        name: Text<'a>,
        /// Name of the tool, where the record states one.
        tool: Option<&'a [u8]>,
    },
    /// `END-OF-PATH`.
    EndOfPath,
    /// `PPRINT text`.
    Message(Text<'a>),
    /// `INSERT text`.
    Insert(Text<'a>),
    /// `AUXFUN/n[,NEXT|NOW]`, `PREFUN/n`.
    Code {
        /// `M` or `G`.
        letter: u8,
        /// Number after the letter.
        number: u32,
        /// Place of the number, for messages.
        at: Span,
    },
    /// `OPSTOP`.
    OptionalStop,
    /// `STOP`.
    Stop,
    /// `OPSKIP/ON`, `OPSKIP/OFF`.
    BlockSkip {
        /// ON.
        on: bool,
    },
    /// `END`.
    End,
    /// `FINI`.
    Fini,
    /// `REWIND`, `REWIND/n`.
    Rewind,
}

impl ProgramRecord<'_> {
    /// Whether the record takes the rest of its statement as text.
    pub(crate) fn takes_anything(&self) -> bool {
        match self {
            Self::PartName(_) | Self::MachineName(_) | Self::ToolPath { .. } | Self::Message(_) | Self::Insert(_) => {
                true
            }
            Self::Code { .. } | Self::OptionalStop | Self::Stop | Self::BlockSkip { .. } => false,
            Self::EndOfPath | Self::End | Self::Fini | Self::Rewind => false,
        }
    }
}

/// MACHIN: the name up to the first comma. The other arguments are meant for one particular postprocessor and are
/// passed over. Without a name it has no effect.
pub(crate) fn machine_name<'a>(args: &mut Args<'a>) -> Result<Record<'a>, ClFault> {
    let name = args.next_place().flatten();
    args.skip_rest();
    Ok(name
        .map_or(Record::Inert, |arg| Record::Program(ProgramRecord::MachineName(Text { bytes: arg.text, at: arg.at }))))
}

/// TOOL PATH, `/name,TOOL,toolname`. A name may contain commas, so the last `,TOOL,` ends it. The slash is part of the
/// word: see [`major_word`](super::parse::major_word).
pub(crate) fn tool_path<'a>(args: &mut Args<'a>) -> Result<ProgramRecord<'a>, ClFault> {
    const TOOL: &[u8] = b",TOOL,";
    let (mut name, mut tool) = (Text::rest(args), None);
    if let Some(length) = name.bytes.windows(TOOL.len()).rposition(|bytes| bytes.eq_ignore_ascii_case(TOOL)) {
        tool = Some(name.bytes[length + TOOL.len()..].trim_ascii());
        name.bytes = &name.bytes[..length];
        name.at.end = name.at.start + length;
    }
    Ok(ProgramRecord::ToolPath { name, tool: tool.filter(|tool| !tool.eq_ignore_ascii_case(b"NONE")) })
}

/// AUXFUN (letter `M`) and PREFUN (letter `G`).
pub(crate) fn code<'a>(letter: u8, args: &mut Args<'_>) -> Result<ProgramRecord<'a>, ClFault> {
    let arg = args.needed()?;
    let number = arg.integer()?;
    if let Some(when) = args.next()?
        && !when.is("NOW")
        && !when.is("NEXT")
    {
        return Err(args.not_understood(when));
    }
    Ok(ProgramRecord::Code { letter, number, at: arg.at })
}

/// OPSKIP.
pub(crate) fn block_skip<'a>(args: &mut Args<'_>) -> Result<ProgramRecord<'a>, ClFault> {
    let arg = args.needed()?;
    let on = arg.among(&[("ON", true), ("OFF", false)]).ok_or_else(|| args.not_understood(arg))?;
    Ok(ProgramRecord::BlockSkip { on })
}

/// REWIND.
pub(crate) fn rewind<'a>(args: &mut Args<'_>) -> Result<ProgramRecord<'a>, ClFault> {
    if let Some(arg) = args.next()? {
        arg.number()?;
    }
    Ok(ProgramRecord::Rewind)
}

/// MODE, APPLY: a word of `permitted`, which has no effect; turning is refused.
pub(crate) fn mode(args: &mut Args<'_>, permitted: &[&str]) -> Result<(), ClFault> {
    let arg = args.needed()?;
    if arg.is("TURN") {
        return Err(ClFault::lathe_record(arg.at));
    }
    if permitted.iter().any(|word| arg.is(word)) { Ok(()) } else { Err(args.not_understood(arg)) }
}

/// OPNAME: the name of the operation that begins (script of *Mori APT*).
pub(crate) fn operation_name<'a>(args: &mut Args<'a>) -> ProgramRecord<'a> {
    ProgramRecord::ToolPath { name: Text::rest(args), tool: None }
}

impl Display for ProgramRecord<'_> {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::PartName(text) => write!(out, "PARTNO {text}"),
            Self::MachineName(text) => write!(out, "MACHIN/{text}"),
            Self::ToolPath { name, tool } => {
                write!(out, "TOOL PATH/{name},TOOL,{}", String::from_utf8_lossy(tool.unwrap_or(b"NONE")))
            }
            Self::EndOfPath => out.write_str("END-OF-PATH"),
            Self::Message(text) => write!(out, "PPRINT {text}"),
            Self::Insert(text) => write!(out, "INSERT {text}"),
            Self::Code { letter, number, .. } => {
                write!(out, "{}/{number}", if *letter == b'M' { "AUXFUN" } else { "PREFUN" })
            }
            Self::OptionalStop => out.write_str("OPSTOP"),
            Self::Stop => out.write_str("STOP"),
            Self::BlockSkip { on } => write_on_off("OPSKIP", *on, out),
            Self::End => out.write_str("END"),
            Self::Fini => out.write_str("FINI"),
            Self::Rewind => out.write_str("REWIND/0"),
        }
    }
}
