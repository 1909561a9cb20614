//! Records that call or describe a tool: LOADTL, LOAD/TOOL, SELECT, CUTTER, TLDATA, SET/OFSETL, TOOLNO.

use std::fmt::{self, Display, Formatter};

use super::values::ClNumber;
use crate::cl::text::{Arg, Args, ClFault, Span, quoted};

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
pub const MOST_TOOL_NUMBERS: usize = 4;

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
    /// `LOADTL/n[,n..][,IN,m][,LENGTH,l][,OSETNO,o][,ADJUST,h][,SPINDL,s][,MILL]`, `LOAD/TOOL,n[,..]`.
    Call(ToolCallRecord),
    /// `SELECT/TOOL,n`, `SELCTL/n`.
    Preselect(u32),
    /// `CUTTER/d[,r[,e,f,a,b,h]]`, `TLDATA/MILL,d,r,..`, `TLDATA/DRILL[,word],d,..`: of the tool called next.
    Cutter(CutterRecord),
    /// `$$-> CUTTER / d`: of the tool called last.
    CutterOfLastTool(CutterRecord),
    /// `SET/OFSETL,n`: length offset register of the tool called last.
    LengthOffset {
        /// Register.
        register: u32,
        /// Place of the number, for messages.
        at: Span,
    },
}

/// LOADTL: `n[,n..][,IN,m][,LENGTH,l][,OSETNO,o][,ADJUST,h][,SPINDL,s][,MILL]`.
///
/// SPINDL and MILL are words of a table of CATIA (`LOADTL/%n,ADJUST,%h,SPINDL,%s,MILL`; TURN for a turning tool): the speed
/// has no effect until SPINDL starts the spindle. IN is written by the post *Generative Machining APT* of HSMWorks.
pub(crate) fn call(args: &mut Args<'_>) -> Result<ToolRecord, ClFault> {
    let first = args.needed()?;
    let number = first.integer()?;
    if number == 0 {
        return Err(ClFault::new(
            "tool 0",
            first.at,
            "tool number 0 is not permitted",
            "number every tool in the CAM system: two tools with number 0 would be the same tool",
        ));
    }
    let mut tool = ToolCallRecord::new(number);
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
        } else if arg.is("LENGTH") {
            let value = args.number_after(arg)?;
            let length = value.number()?;
            if length <= 0.0 {
                return Err(ClFault::new(
                    "gauge length",
                    value.at,
                    format!("the gauge length (LENGTH) must be above 0, found {}", quoted(value.text)),
                    "program the real length, or leave LENGTH out and set `length` in `[tools.N]` of the configuration",
                ));
            }
            tool.length = Some(length);
        } else if arg.is("OSETNO") || arg.is("ADJUST") {
            let value = args.number_after(arg)?;
            let offset = value.integer()?;
            if offset == 0 || tool.offset.is_some_and(|other| other != offset) {
                return Err(ClFault::new(
                    "length offset",
                    value.at,
                    if offset == 0 {
                        format!("{} 0 would cancel the length offset", quoted(arg.text))
                    } else {
                        "two different length offset registers for one tool".to_string()
                    },
                    "program one register above 0; without one the tool number is used",
                ));
            }
            tool.offset = Some(offset);
        } else {
            return Err(args.not_understood(arg));
        }
    }
    Ok(ToolRecord::Call(tool))
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
        return Err(ClFault::new(
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

/// TOOLNO: describes a tool and has no effect; refused for a turning tool. CATIA leaves places empty for parameters that a
/// tool does not have.
pub(crate) fn description(args: &mut Args<'_>) -> Result<(), ClFault> {
    while let Some(place) = args.next_place() {
        if let Some(arg) = place.filter(|arg| arg.is("TURN")) {
            return Err(ClFault::lathe_record(arg.at));
        }
    }
    Ok(())
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
        }
    }
}
