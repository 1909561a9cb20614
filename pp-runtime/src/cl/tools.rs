//! Records that call or describe a tool: LOADTL, LOAD/TOOL, CUTTER, TLDATA, TOOLNO.

use super::args::Args;
use super::fault::{Fault, Span, quoted};
use super::parse::{argument_not_yet, needed, turning, wrong_count};
use super::record::{Cutter, Record, Tool};

/// `n[,n..][,LENGTH,l][,OSETNO,o][,ADJUST,h]`, the part that LOADTL and LOAD/TOOL share.
pub(super) fn call(name: &'static str, args: &mut Args<'_>) -> Result<Tool, Fault> {
    let first = needed(name, args)?;
    let number = first.integer()?;
    if number == 0 {
        return Err(Fault::new(
            "tool 0",
            first.at,
            "0 is not the number of a tool",
            "give every tool its number in the CAM system; two tools with the number 0 would be taken for one",
        ));
    }
    let mut tool = Tool { number, length: None, offset: None };
    while let Some(arg) = args.next()? {
        if arg.looks_numeric() {
            // Some systems repeat the number of the tool; any other number could be a length or an offset.
            if arg.integer().ok() != Some(number) {
                return Err(Fault::new(
                    "number behind the tool",
                    arg.at,
                    format!("{} behind tool {number}: its meaning is not stated", quoted(arg.text)),
                    format!("write {name} with LENGTH, OSETNO or ADJUST in front of the number"),
                ));
            }
        } else if arg.is("LENGTH") {
            let value = needed(name, args)?;
            let length = value.number()?;
            if length <= 0.0 {
                return Err(Fault::new(
                    "gauge length",
                    value.at,
                    format!("the gauge length {} is not above 0", quoted(value.text)),
                    "give the real length, or leave LENGTH out and state it in the configuration",
                ));
            }
            tool.length = Some(length);
        } else if arg.is("OSETNO") || arg.is("ADJUST") {
            let value = needed(name, args)?;
            let offset = value.integer()?;
            if offset == 0 || tool.offset.is_some_and(|other| other != offset) {
                return Err(Fault::new(
                    "length offset",
                    value.at,
                    if offset == 0 {
                        format!("{} 0 would switch the length offset off", quoted(arg.text))
                    } else {
                        "two different length offsets for one tool".to_string()
                    },
                    "give one register above 0, or none to use the one with the tool's number",
                ));
            }
            tool.offset = Some(offset);
        } else {
            return Err(argument_not_yet(name, arg));
        }
    }
    Ok(tool)
}

/// `d[,r[,e,f,a,b,h]]`, the cutter of APT.
pub(super) fn cutter(name: &'static str, args: &mut Args<'_>) -> Result<Cutter, Fault> {
    let mut numbers = [0.0; 7];
    match args.numbers(&mut numbers)? {
        found @ 1..=7 => cutter_of(numbers[0], (found > 1).then_some(numbers[1]), args.all()),
        found => Err(wrong_count(name, "1 to 7 numbers", found, args)),
    }
}

/// `TLDATA/MILL,d,r,..` or `TLDATA/DRILL[,word],d,..`.
pub(super) fn data<'a>(name: &'static str, args: &mut Args<'_>) -> Result<Record<'a>, Fault> {
    let kind = needed(name, args)?;
    let is_mill = kind.is("MILL");
    if ["TURN", "GROOVE", "THREAD"].iter().any(|word| kind.is(word)) {
        return Err(turning(kind.at));
    }
    if !is_mill && !kind.is("DRILL") {
        return Err(argument_not_yet(name, kind));
    }
    let mut behind_word = args.clone();
    if !is_mill && behind_word.next()?.is_some_and(|arg| !arg.looks_numeric()) {
        *args = behind_word;
    }
    let mut numbers = [0.0; 2];
    let found = args.numbers(&mut numbers)?;
    if found < if is_mill { 2 } else { 1 } {
        return Err(wrong_count(name, "at least the diameter and, for MILL, the corner radius", found, args));
    }
    cutter_of(numbers[0], is_mill.then_some(numbers[1]), args.all()).map(Record::Cutter)
}

fn cutter_of(diameter: f64, corner_radius: Option<f64>, at: Span) -> Result<Cutter, Fault> {
    if diameter < 0.0 || corner_radius.is_some_and(|radius| radius < 0.0) {
        return Err(Fault::new(
            "size of the cutter",
            at,
            "diameter and corner radius of a cutter are not negative",
            "check the tool's description in the CAM system",
        ));
    }
    Ok(Cutter { diameter, corner_radius })
}

/// TOOLNO describes a tool and changes nothing, unless the tool is a turning tool.
pub(super) fn description<'a>(mut args: Args<'_>) -> Result<Record<'a>, Fault> {
    while let Some(arg) = args.next()? {
        if arg.is("TURN") {
            return Err(turning(arg.at));
        }
    }
    Ok(Record::Inert)
}
