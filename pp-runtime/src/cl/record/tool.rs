//! Records that call or describe a tool: LOADTL, LOAD/TOOL, SELECT, CUTTER, TLDATA, SET/OFSETL, TOOLNO.

use std::fmt::{self, Display, Formatter};

use super::values::ClNumber;
use crate::cl::text::{Arg, Args, ClFault, Span, quoted};
use crate::diag::code::cl;

/// Size of a cutter, in units of the file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CutterRecord {
    /// Diameter.
    pub diameter: f64,
    /// Corner radius, if the record gives one.
    pub corner_radius: Option<f64>,
    /// Kind of the tool, if the record gives one: TLDATA.
    pub kind: Option<CutterKind>,
}

/// Kind of a tool in TLDATA.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CutterKind {
    /// `TLDATA/MILL,..`.
    Mill,
    /// `TLDATA/DRILL,..`.
    Drill,
}

impl CutterKind {
    /// Its word in TLDATA.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Mill => "MILL",
            Self::Drill => "DRILL",
        }
    }
}

/// A tool call, lengths in units of the file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ToolCallRecord {
    /// Tool number.
    pub number: u32,
    /// LENGTH: gauge length.
    pub length: Option<f64>,
    /// ADJUST or OSETNO: length offset register (H).
    pub offset: Option<u32>,
    /// IN: magazine. LENGTH beside it is the length of the tool's body.
    pub magazine: Option<u32>,
    /// Numbers after the tool number without a word before them, in order.
    pub numbers: [f64; MOST_TOOL_NUMBERS],
    /// Count of these numbers.
    pub count: usize,
    /// Place of these numbers, for messages.
    pub at: Span,
}

/// Largest count of numbers without a word after the tool number.
pub(crate) const MOST_TOOL_NUMBERS: usize = 4;

impl ToolCallRecord {
    /// A call of this tool without any other word.
    #[must_use]
    pub fn new(number: u32) -> Self {
        let at = Span::default();
        ToolCallRecord { number, length: None, offset: None, magazine: None, numbers: [0.0; 4], count: 0, at }
    }

    /// Takes a number without a word before it.
    fn take_number(&mut self, arg: Arg<'_>, args: &Args<'_>) -> Result<(), ClFault> {
        let value = arg.number()?;
        let Some(place) = self.numbers.get_mut(self.count) else { return Err(args.not_understood(arg)) };
        *place = value;
        self.at = if self.count == 0 { arg.at } else { Span { end: arg.at.end, ..self.at } };
        self.count += 1;
        Ok(())
    }
}

/// A record that calls, preselects or describes a tool.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ToolRecord {
    /// `LOADTL/n[,n..][,IN,m][,LENGTH,l][,OSETNO,o][,ADJUST,h][,SPINDL,s][,MILL][,'comment'][,NEXTTL,n]`,
    /// `LOAD/TOOL,n[,..]`; tool 0, and `UNLOAD[/TOOL[,n]]`, leave the spindle empty.
    Call(ToolCallRecord),
    /// `SELECT/TOOL,n`, `SELCTL/n`.
    Preselect(u32),
    /// `CUTTER/d[,r[,e,f,a,b,h]]`, `TLDATA/MILL,d,r,..`, `TLDATA/DRILL[,word],d,..`: of the tool called next.
    Cutter(CutterRecord),
    /// `$$-> CUTTER / d`: of the tool called last.
    CutterOfLastTool(CutterRecord),
    /// `SET/OFSETL,n`, `CUTCOM/ON,LENGTH,n`: length offset register of the tool called last.
    LengthOffset {
        /// Register.
        register: u32,
        /// Place of the number, for messages.
        at: Span,
    },
    /// `TOOLNO/n,MILL,OSETNO,h,d`: length offset register of tool n in the calls after it.
    OffsetOf {
        /// Tool number.
        number: u32,
        /// Register.
        register: u32,
    },
}

/// UNLOAD: `[TOOL[,n]]`. The tool goes back to the magazine: tool 0 is an empty spindle.
pub(crate) fn unload(args: &mut Args<'_>) -> Result<ToolRecord, ClFault> {
    if let Some(arg) = args.next()? {
        if !arg.is("TOOL") {
            return Err(args.not_understood(arg));
        }
        if let Some(number) = args.next()? {
            number.integer()?;
        }
    }
    Ok(ToolRecord::Call(ToolCallRecord::new(0)))
}

/// LOADTL: `n[,n..][,IN,m][,LENGTH,l][,OSETNO,o][,ADJUST,h][,SPINDL,s][,MILL][,'comment'][,NEXTTL,n]`.
///
/// SPINDL and MILL are words of a table of CATIA (`LOADTL/%n,ADJUST,%h,SPINDL,%s,MILL`; TURN for a turning tool): the
/// speed has no effect until SPINDL starts the spindle. IN is written by the post *Generative Machining APT* of
/// HSMWorks.
pub(crate) fn call(args: &mut Args<'_>) -> Result<ToolRecord, ClFault> {
    let first = args.needed()?;
    let mut tool = ToolCallRecord::new(first.integer()?);
    while let Some(arg) = args.next()? {
        if arg.looks_numeric() {
            tool.take_number(arg, args)?;
        } else if arg.is("IN") {
            tool.magazine = Some(args.number_after(arg)?.integer()?);
        } else if arg.is("SPINDL") {
            args.number_after(arg)?.number()?;
        } else if arg.is("TURN") {
            return Err(ClFault::lathe_record(arg.at));
        } else if arg.is("MILL") {
            // A milling tool.
        } else if arg.text[0] == b'\'' {
            skip_quoted(arg, args)?;
        } else if arg.is("NEXTTL") {
            // The tool after this one: whether it is preselected is configured.
            args.needed()?.integer()?;
        } else if arg.is("LENGTH") {
            let value = args.number_after(arg)?;
            let length = value.number()?;
            if length <= 0.0 {
                return Err(cl::TOOL.cl_fault(
                    "gauge length",
                    value.at,
                    format!("the gauge length (LENGTH) must be above 0, found {}", quoted(value.text)),
                    "program the real length, or leave LENGTH out and set `length` in `[tools.N]` of the configuration",
                ));
            }
            tool.length = Some(length);
        } else if arg.is("OSETNO") || arg.is("ADJUST") {
            let value = args.number_after(arg)?;
            let offset = length_offset(arg, value)?;
            if tool.offset.is_some_and(|other| other != offset) {
                let text = "two different length offset registers for one tool";
                return Err(cl::TOOL.cl_fault("length offset", value.at, text, ONE_REGISTER));
            }
            tool.offset = Some(offset);
        } else {
            return Err(args.not_understood(arg));
        }
    }
    Ok(ToolRecord::Call(tool))
}

const ONE_REGISTER: &str = "program one register above 0; without one the tool number is used";

/// The length offset register after a word.
fn length_offset(word: Arg<'_>, value: Arg<'_>) -> Result<u32, ClFault> {
    match value.integer()? {
        0 => {
            let text = format!("{} 0 would cancel the length offset", quoted(word.text));
            Err(cl::TOOL.cl_fault("length offset", value.at, text, ONE_REGISTER))
        }
        register => Ok(register),
    }
}

/// Skips a text in quotes that begins with `first`, the comment on a tool of *Mori APT*; it may contain commas.
fn skip_quoted(first: Arg<'_>, args: &mut Args<'_>) -> Result<(), ClFault> {
    let mut ends = first.text.len() > 1 && first.text.ends_with(b"'");
    while !ends {
        let Some(place) = args.next_place() else {
            let text = "the quote that begins here does not end";
            return Err(cl::SYNTAX.cl_fault("quote", first.at, text, "write a `'` after the text, or delete the text"));
        };
        ends = place.is_some_and(|arg| arg.text.ends_with(b"'"));
    }
    Ok(())
}

/// CUTTER of APT: `d[,r[,e,f,a,b,h]]`.
pub(crate) fn cutter(args: &mut Args<'_>) -> Result<CutterRecord, ClFault> {
    let (numbers, size): ([f64; 2], usize) = args.first_numbers()?;
    match size + args.numbers_without_effect()? {
        1..=7 => cutter_of(None, numbers[0], (size > 1).then_some(numbers[1]), args.all()),
        found => Err(args.wrong_count("1 to 7 numbers", found)),
    }
}

/// TLDATA: `MILL,d,r,..` or `DRILL[,word],d,..`.
pub(crate) fn data(args: &mut Args<'_>) -> Result<ToolRecord, ClFault> {
    let kind = args.needed()?;
    let is_mill = kind.is("MILL");
    if ["TURN", "GROOVE", "THREAD"].iter().any(|word| kind.is(word)) {
        return Err(ClFault::lathe_record(kind.at));
    }
    if !is_mill && !kind.is("DRILL") {
        return Err(args.not_understood(kind));
    }
    let mut after_word = args.clone();
    if !is_mill && after_word.next()?.is_some_and(|arg| !arg.looks_numeric()) {
        *args = after_word;
    }
    let (numbers, found): ([f64; 2], usize) = args.first_numbers()?;
    args.numbers_without_effect()?;
    if found < if is_mill { 2 } else { 1 } {
        return Err(args.wrong_count("at least the diameter and, for MILL, the corner radius", found));
    }
    let kind = Some(if is_mill { CutterKind::Mill } else { CutterKind::Drill });
    cutter_of(kind, numbers[0], is_mill.then_some(numbers[1]), args.all()).map(ToolRecord::Cutter)
}

fn cutter_of(
    kind: Option<CutterKind>,
    diameter: f64,
    corner_radius: Option<f64>,
    at: Span,
) -> Result<CutterRecord, ClFault> {
    if diameter < 0.0 || corner_radius.is_some_and(|radius| radius < 0.0) {
        return Err(cl::TOOL.cl_fault(
            "size of the cutter",
            at,
            "diameter and corner radius of a cutter must not be negative",
            "check the tool's description in the CAM system",
        ));
    }
    Ok(CutterRecord { diameter, corner_radius, kind })
}

/// LOAD/TOOL.
pub(crate) fn load(args: &mut Args<'_>) -> Result<ToolRecord, ClFault> {
    args.keyword("TOOL")?;
    call(args)
}

/// SELCTL.
pub(crate) fn preselect(args: &mut Args<'_>) -> Result<ToolRecord, ClFault> {
    args.needed()?.integer().map(ToolRecord::Preselect)
}

/// SELECT/TOOL.
pub(crate) fn select(args: &mut Args<'_>) -> Result<ToolRecord, ClFault> {
    args.keyword("TOOL")?;
    preselect(args)
}

/// SET/OFSETL; SET/MODE,ABSOL has no effect.
pub(crate) fn set(args: &mut Args<'_>) -> Result<Option<ToolRecord>, ClFault> {
    let arg = args.needed()?;
    if arg.is("OFSETL") {
        let register = args.needed()?;
        return Ok(Some(ToolRecord::LengthOffset { register: register.integer()?, at: register.at }));
    }
    if arg.is("MODE") {
        args.keyword("ABSOL")?;
        return Ok(None);
    }
    Err(args.not_understood(arg))
}

/// TOOLNO: describes a tool and has no effect; refused for a turning tool. CATIA leaves places empty for parameters
/// that a tool does not have. `n,MILL,OSETNO,h,d` has its registers (script of *Mori APT*); that of the diameter is in
/// CUTCOM, too.
pub(crate) fn description(args: &mut Args<'_>) -> Result<Option<ToolRecord>, ClFault> {
    let mut places = args.clone();
    let [number, kind, word] = [(); 3].map(|()| places.next_place().flatten());
    if let (Some(number), Some(word)) = (number, word)
        && kind.is_some_and(|kind| kind.is("MILL"))
        && word.is("OSETNO")
    {
        let register = length_offset(word, places.needed()?)?;
        places.first_numbers::<1>()?;
        *args = places;
        return Ok(Some(ToolRecord::OffsetOf { number: number.integer()?, register }));
    }
    while let Some(place) = args.next_place() {
        if let Some(arg) = place.filter(|arg| arg.is("TURN")) {
            return Err(ClFault::lathe_record(arg.at));
        }
    }
    Ok(None)
}

/// CUTCOM/ON,LENGTH: the register of the tool length (script of *Mori APT*), not cutter compensation; `None` for
/// another CUTCOM.
pub(crate) fn length_compensation(args: &mut Args<'_>) -> Result<Option<ToolRecord>, ClFault> {
    let mut ahead = args.clone();
    let is_of_length =
        ahead.next()?.is_some_and(|arg| arg.is("ON")) && ahead.next()?.is_some_and(|arg| arg.is("LENGTH"));
    if !is_of_length {
        return Ok(None);
    }
    let register = ahead.needed()?;
    *args = ahead;
    Ok(Some(ToolRecord::LengthOffset { register: register.integer()?, at: register.at }))
}

impl Display for ToolCallRecord {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "LOADTL/{}", self.number)?;
        for value in &self.numbers[..self.count.min(MOST_TOOL_NUMBERS)] {
            write!(out, ",{}", ClNumber(*value))?;
        }
        if let Some(magazine) = self.magazine {
            write!(out, ",IN,{magazine}")?;
        }
        if let Some(length) = self.length {
            write!(out, ",LENGTH,{}", ClNumber(length))?;
        }
        self.offset.map_or(Ok(()), |offset| write!(out, ",ADJUST,{offset}"))
    }
}

impl Display for CutterRecord {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        match self.kind {
            None => write!(out, "CUTTER/{}", ClNumber(self.diameter))?,
            Some(kind) => write!(out, "TLDATA/{},{}", kind.word(), ClNumber(self.diameter))?,
        }
        self.corner_radius.map_or(Ok(()), |radius| write!(out, ",{}", ClNumber(radius)))
    }
}

impl Display for ToolRecord {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Call(call) => call.fmt(out),
            Self::Preselect(number) => write!(out, "SELCTL/{number}"),
            Self::Cutter(cutter) => cutter.fmt(out),
            Self::CutterOfLastTool(cutter) => write!(out, "$$-> {cutter}"),
            Self::LengthOffset { register, .. } => write!(out, "SET/OFSETL,{register}"),
            Self::OffsetOf { number, register } => write!(out, "TOOLNO/{number},MILL,OSETNO,{register}"),
        }
    }
}
