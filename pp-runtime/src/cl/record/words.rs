//! Table of the major words of CL data and their handling.
//!
//! A word is read by the function of its row; or it is inert (it moves no axis and changes no state) and passed over;
//! or it is refused with a reason. An unknown word is refused, too: it might move the tool. `explain --cl` prints this
//! table.

use std::cmp::Ordering;
use std::io::{self, Write};

use super::Record::{self, Arc, Coordinates, Cycle, Machine, Motion, Nurbs, Program, Subprogram, Tool};
use super::values::{Point, Text};
use super::vocabulary::vocabulary;
use super::{ArcRecord, MachineRecord, MotionRecord, NurbsRecord, ProgramRecord, SubprogramRecord, ToolRecord};
use super::{arc, comment, coordinates, cycle, machine, motion, nurbs, program, spindle, subprogram, tool};
use crate::cl::text::{Args, ClFault, MajorWord, Span, skip_blanks, trimmed, whole_number};

/// Function that reads the arguments of a word.
type ReadArgs = for<'a> fn(&mut Args<'a>) -> Result<Record<'a>, ClFault>;

/// Handling of a major word.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Handling {
    /// The arguments after the slash are read; an argument that is not taken is a fault.
    Read(ReadArgs),
    /// The rest of the statement is read as text.
    ReadText(ReadArgs),
    /// Passed over: no effect on motion or state of the machine.
    Inert,
    /// Refused for this reason; the user may declare it inert.
    Refused(&'static str),
    /// Refused for this reason: the postprocessor writes it itself. The user may declare it inert, but no block takes
    /// its place. The forms of the row have no effect.
    Automatic(&'static str),
    /// Refused for this reason and never inert: without it the motion after it would be wrong.
    Hazard(&'static str),
    /// Refused: it belongs to turning.
    Lathe,
}

impl Handling {
    pub(crate) fn is_read(self) -> bool {
        match self {
            Read(_) | ReadText(_) => true,
            Inert | Refused(_) | Automatic(_) | Hazard(_) | Lathe => false,
        }
    }
}

/// A major word and its handling.
#[derive(Debug)]
pub(crate) struct WordRow {
    pub(crate) word: MajorWord,
    pub(crate) handling: Handling,
}

const fn row(name: &'static str, handling: Handling, forms: &'static str) -> WordRow {
    WordRow { word: MajorWord { name, forms }, handling }
}

use Handling::{Automatic, Hazard, Inert, Lathe, Read, ReadText, Refused};

const MOVES_COORDINATES: &str = "it changes the coordinates of all points after it";
const FRAME: &str = "it states a frame, and what its numbers mean for the points after it is not known";
const OFFSET: &str = "it selects a zero point, and its place on the machine is not stated";
const TIP_CONTROL: &str = "it switches between points of the tool tip and positions of axes";
const NOT_CUT: &str = "the motions between DNTCUT and CUT are not to be made";
const REDEFINES: &str = "it changes the meaning of other records";
const MACHINE_AXES: &str = "it commands machine axes, which the postprocessor computes itself";
const CLAMPS: &str =
    "the postprocessor clamps the rotary axes itself, with the codes of `[clamp]` in the configuration";
const OWN_MEANING: &str = "its meaning depends on the postprocessor that it was written for";
const TOLERANCE: &str = "it sets a tolerance of another postprocessor";

/// GOTO: nearly every record. While no arc, curve or cycle is open it is read without a search in the table.
pub(crate) const GOTO: MajorWord = MajorWord { name: "GOTO", forms: "/x,y,z[,i,j,k]; /x,y,z / x,y,z .." };

/// CIRCLE, which is read without a search, too, where it is on one line.
pub(crate) const CIRCLE: MajorWord = MajorWord {
    name: "CIRCLE",
    forms: "/x,y,z,i,j,k[,r[,CLW|CCLW|,t,f,d,e][,TIMES,n]]; /x,y,z,r and the GOTO that ends it",
};

/// The table, sorted by name, in capitals. The third column lists the forms that are read.
#[rustfmt::skip] // One row in one line.
static TABLE: &[WordRow] = &[
    row("ALIGN", Hazard(MACHINE_AXES), ""),
    // Script of *Mori APT* of Autodesk, as are MCSYS, OPNAME, TCP, `MOVARC/CENTER`, `CUTCOM/ON,LENGTH` and
    // `TOOLNO/..,OSETNO`.
    row("APPLY", Read(|args| program::mode(args, &["MILL"]).map(|()| Record::Inert)), "/MILL"),
    row("ARCSLP", Read(|args| arc::slope(args).map(Arc)), "/h before an arc: height of the helix"),
    row("AUTOPS", Read(|_| Ok(Arc(ArcRecord::AutomaticPlane))), "before TLON"),
    row("AUXFUN", Read(|args| program::code(b'M', args).map(Program)), "/n[,NEXT|NOW]; only codes that `[cl] auxfun` allows"),
    row("BEGIN", Inert, ""),
    row("BREAK", Refused(OWN_MEANING), ""),
    // Names: *Supported CL Data Commands* of PTC.
    row("CALSUB", Read(|args| subprogram::call(args).map(Subprogram)), "/name"),
    // Files for G-POST: it comes where the other format has `$$-> CSYS`, with the same numbers.
    row("CAMERA", Read(|args| coordinates::matrix(args).map(Coordinates)), "/12 numbers, as `$$-> CSYS`"),
    row("CHECK", Inert, ""),
    // x,y,z,r: *Supported CL Data Commands*; 6 numbers: files of SolidWorks CAM; 11: help of NX, script of *CAMplete
    // APT*. Words of the sense: `arc`.
    WordRow { word: CIRCLE, handling: Read(|args| arc::circle(args).map(Arc)) },
    row("CLAMP", Automatic(CLAMPS), "/TABLE,ALL,AUTO|OFF leaves the clamps to the postprocessor"),
    row("CLEARP", Read(|args| coordinates::clearance_plane(args).map(Coordinates)), "/XYPLAN|YZPLAN|ZXPLAN,d; /a,b,c,d"),
    row("CLRSRF", Refused("it sets a clearance surface that is not a plane"), ""),
    row("CNTRL", Read(|args| nurbs::control_point(args).map(Nurbs)), "/x,y,z of a NURBS"),
    // Pressures of every kind: *Supported CL Data Commands*.
    row("COOLNT", Read(|args| machine::coolant(args).map(Machine)), "/ON|OFF|FLOOD|MIST|THRU|AIR[,LOW|MEDIUM|HIGH]"),
    row("COPY", Hazard(MOVES_COORDINATES), ""),
    row("COUPLE", Lathe, ""),
    row("CSYS", Read(|args| coordinates::setup(args).map(Coordinates)), "/12 numbers, after TRNTYP/WORLD,0,0,0"),
    row("CUT", Hazard(NOT_CUT), ""),
    // ON before the side: script of *Common ISO 4343 APT*; ON,LEFT,n: that of *Generative Machining APT*.
    row("CUTCOM", Read(cutcom), "/[ON,]LEFT|RIGHT[,[OSETNO,]n][,XYPLAN]; /ON before or after them; /OFF; /ON,LENGTH,n as SET/OFSETL"),
    row("CUTTER", Read(|args| tool::cutter(args).map(|cutter| Tool(ToolRecord::Cutter(cutter)))), "/d[,r[,e,f,a,b,h]]"),
    // ON with words: files of NX. Levels: `meaning/holes`.
    row("CYCLE", Read(|args| cycle::cycle(args).map(Cycle)), "/DRILL|FACE|CSINK|THRU|DEEP|BRKCHP|BORE|REAM|TAP|RIGID|..; /OFF; /ON[,words to change]"),
    row("DATUM", Hazard(OFFSET), ""),
    row("DEFSUB", Read(|args| subprogram::define(args).map(Subprogram)), "/name, up to ENDSUB"),
    row("DELAY", Read(|args| machine::delay(args).map(Machine)), "/seconds; /n,REV"),
    row("DISPLAY", Inert, ""),
    row("DISPLY", Inert, ""),
    row("DNTCUT", Hazard(NOT_CUT), ""),
    row("END", Read(|_| Ok(Program(ProgramRecord::End))), "records after it are still read"),
    row("END-OF-PATH", Read(|_| Ok(Program(ProgramRecord::EndOfPath))), ""),
    row("ENDSUB", Read(|_| Ok(Subprogram(SubprogramRecord::End))), ""),
    // FPM, FPR, INVERS,OFF: *Supported CL Data Commands*.
    row("FEDRAT", Read(|args| machine::feed(args).map(Machine)), "/v[,unit]; /unit,v; /RAPID; /INVERS,AUTO|OFF; MMPM MMPR IPM IPR FPM FPR PERMIN PERREV"),
    row("FINI", Read(|_| Ok(Program(ProgramRecord::Fini))), ""),
    row("FROM", Read(|args| Point::parse(args).map(|point| Motion(MotionRecord::From(point)))), "/x,y,z[,i,j,k]"),
    row("GODLTA", Read(|args| motion::increment(args).map(Motion)), "/dx,dy,dz[,i,j,k]; /d along the tool axis"),
    row("GOHOME", Read(|args| motion::home(args).map(Motion)), "[/x,y,z[,i,j,k]]"),
    WordRow { word: GOTO, handling: Read(|args| motion::goto(args).map(Motion)) },
    row("HEAD", Hazard(MACHINE_AXES), ""),
    row("INDEX", Hazard(MOVES_COORDINATES), ""),
    row("INDIRV", Read(|args| arc::direction(args).map(Arc)), "/i,j,k before TLON"),
    row("INSERT", ReadText(|args| Ok(Program(ProgramRecord::Insert(Text::rest(args))))), "text; only with `--insert comment` or `--allow-insert`"),
    row("INTOL", Inert, ""),
    row("INVERSE", Read(|args| machine::inverse_time(args).map(Machine)), "/ON|OFF"),
    row("KNOT", Read(|args| nurbs::knots(args).map(Nurbs)), "/k,k.. of a NURBS"),
    row("LEADER", Inert, ""),
    row("LETTER", Inert, ""),
    row("LIMIT", Refused("it sets limits of axes, which belong in the configuration"), ""),
    row("LINTOL", Read(|args| machine::tolerance(args).map(Machine)), "/t; /OFF"),
    row("LOAD", Read(|args| tool::load(args).map(Tool)), "/TOOL,n[,..] as LOADTL"),
    // Numbers without a word: `meaning/tool_numbers`.
    row("LOADTL", Read(|args| tool::call(args).map(Tool)), "/n[,n..][,IN,m][,LENGTH,l][,OSETNO,o][,ADJUST,h][,SPINDL,s][,MILL][,'comment'][,NEXTTL,n]"),
    row("LOCALCS", Hazard(FRAME), ""),
    row("LOOP", Hazard("it may repeat motion"), ""),
    row("MACHIN", Read(program::machine_name), "[/name[,..]]"),
    row("MATERL", Inert, ""),
    row("MATRIX", Hazard(MOVES_COORDINATES), ""),
    row("MCHTOL", Refused(TOLERANCE), ""),
    // Scripts of *CAMplete APT* and *MANUSnc APT*.
    row("MCS", Read(|args| coordinates::work_plane(args).map(Coordinates)), "/12 numbers: X, Y, Z and origin of the work plane"),
    row("MCS2", Hazard(FRAME), ""),
    row("MCSYS", Read(|args| coordinates::numbered_work_plane(args).map(Coordinates)), "/NUM,1,POINT,x,y,z,VECTOR,i,j,k,VECTOR,i,j,k: origin, X, Y"),
    row("MIRROR", Hazard(MOVES_COORDINATES), ""),
    row("MODE", Read(|args| program::mode(args, &["MILL", "ABSOL"]).map(|()| Record::Inert)), "/MILL; /ABSOL"),
    row("MODSYS", Hazard(FRAME), ""),
    // ANGLE, and a helix with its centre at the start: script of *Common ISO 4343 APT*.
    row("MOVARC", Read(|args| arc::move_arc(args).map(Arc)), "/x,y,z,i,j,k,r,ANGLE,degrees and the GOTO that ends it; /CENTER,x,y,z,AXIS,i,j,k,RADIUS,r and the GOTO"),
    // In files whose writer is not known; no manual has it.
    row("MOVE_ATTRIB", Refused(OWN_MEANING), ""),
    row("MSYS", Read(|args| coordinates::machine_system(args).map(Coordinates)), "/x,y,z,i1,j1,k1,i2,j2,k2"),
    row("MULTAX", Read(|args| coordinates::multi_axis(args).map(Coordinates)), "[/ON|OFF]"),
    row("NURBS", Read(|_| Ok(Nurbs(NurbsRecord::Begin))), "/ and KNOT and CNTRL after it"),
    // Name of operation and feature around the records of each operation of CAMWorks, the same twice (8 of 8).
    row("OPFEATEND", Inert, ""),
    row("OPFEATSTART", Inert, ""),
    row("OPNAME", ReadText(|args| Ok(Program(program::operation_name(args)))), "/name, as TOOL PATH"),
    row("OPSKIP", Read(|args| program::block_skip(args).map(Program)), "/ON|OFF; the blocks between begin with the mark of block skip"),
    row("OPSTOP", Read(|_| Ok(Program(ProgramRecord::OptionalStop))), ""),
    row("ORIGIN", Read(|args| coordinates::origin(args).map(Coordinates)), "/x,y,z; /NOMORE; /0"),
    row("OUTTOL", Inert, ""),
    row("PAINT", Inert, ""),
    row("PARTNO", ReadText(|args| Ok(Program(ProgramRecord::PartName(Text::rest(args))))), "text"),
    row("PATTERN", Hazard(MOVES_COORDINATES), ""),
    row("PITCH", Lathe, ""),
    row("PIVOTZ", Hazard(MACHINE_AXES), ""),
    row("PLANE", Hazard(FRAME), ""),
    row("POLAR", Hazard(REDEFINES), ""),
    row("POSITN", Hazard(MACHINE_AXES), ""),
    row("PPFUN", Hazard(REDEFINES), ""),
    row("PPRINT", ReadText(|args| Ok(Program(ProgramRecord::Message(Text::rest(args))))), "text"),
    row("PPTOL", Refused(TOLERANCE), ""),
    // Files for G-POST; no manual of it is public.
    row("PPWORD", Read(vocabulary), "/word,n.. states numbers of words in the vocabulary of another postprocessor: no effect"),
    row("PREFUN", Read(|args| program::code(b'G', args).map(Program)), "/n; only codes that `[cl] prefun` allows"),
    row("RAPID", Read(|_| Ok(Machine(MachineRecord::Rapid))), "the next motion only"),
    row("REFSYS", Hazard(FRAME), ""),
    row("REMARK", ReadText(comment::remark), "text; `-> CSYS / ..` and `-> CUTTER / ..` are read"),
    row("RESET", Refused(OWN_MEANING), ""),
    row("RETRCT", Read(|_| Ok(Motion(MotionRecord::Retract))), "along the tool axis to the plane of CLEARP"),
    row("REWIND", Read(|args| program::rewind(args).map(Program)), "[/n]"),
    row("ROTABL", Read(|args| machine::rotary_direction(args).map(Machine)), "/SHORT; /NEXT,CLW|CCLW"),
    row("ROTATE", Hazard(MOVES_COORDINATES), ""),
    row("ROTHED", Hazard(MACHINE_AXES), ""),
    row("RTCP", Hazard(TIP_CONTROL), ""),
    row("SAFETY", Refused(OWN_MEANING), ""),
    row("SCALE", Hazard(MOVES_COORDINATES), ""),
    row("SELCTL", Read(|args| tool::preselect(args).map(Tool)), "/n"),
    row("SELECT", Read(|args| tool::select(args).map(Tool)), "/TOOL,n"),
    row("SEQNO", Inert, ""),
    row("SET", Read(|args| tool::set(args).map(|found| found.map_or(Record::Inert, Tool))), "/MODE,ABSOL; /OFSETL,n"),
    row("SETUP", Inert, ""),
    row("SPINDL", Read(|args| spindle::spindle(args).map(|spindle| Machine(MachineRecord::Spindle(spindle)))), "/RPM, n, CLW|CCLW, ON|OFF in any order"),
    row("STOP", Read(|_| Ok(Program(ProgramRecord::Stop))), ""),
    row("SWITCH", Lathe, ""),
    row("SYN", Hazard(REDEFINES), ""),
    row("SYS", Read(|args| coordinates::machine_system(args).map(Coordinates)), "/ as MSYS"),
    row("TCP", Read(|args| coordinates::tip_control(args).map(Coordinates)), "/ON|OFF beside MULTAX: the points are those of the tip in any case"),
    row("TCPCTL", Hazard(TIP_CONTROL), ""),
    row("THREAD", Lathe, ""),
    row("TLAXIS", Read(|args| coordinates::tool_axis(args).map(Coordinates)), "/i,j,k"),
    row("TLDATA", Read(|args| tool::data(args).map(Tool)), "/MILL,d,r,..; /DRILL[,word],d,.."),
    row("TLON", ReadText(|args| arc::tangent_arc(args).map(Arc)), ",GOFWD/ (CIRCLE/ c,r),ON,[2,INTOF,](LINE/ c,e)"),
    row("TMARK", Inert, ""),
    row("TOLER", Inert, ""),
    row("TOOL PATH", ReadText(|args| program::tool_path(args).map(Program)), "/name,TOOL,name"),
    row("TOOLNO", Read(|args| tool::description(args).map(|found| found.map_or(Record::Inert, Tool))), "/n,MILL,OSETNO,h,d before its calls; any other describes a tool and has no effect"),
    row("TPRINT", Inert, ""),
    row("TRACUT", Read(|args| coordinates::transformation(args).map(Coordinates)), "/12 numbers of a rigid motion; /NOMORE; /0"),
    row("TRANS", Read(|args| coordinates::translation(args).map(Coordinates)), "/x,y,z; /NOMORE; /0"),
    row("TRAORI", Hazard(TIP_CONTROL), ""),
    row("TRNTYP", Read(|args| coordinates::world(args).map(Coordinates)), "/WORLD,0,0,0"),
    row("TURRET", Lathe, ""),
    row("UNCLAMP", Automatic(CLAMPS), ""),
    row("UNIT", Read(|args| coordinates::units(args).map(Coordinates)), "/MM|INCH"),
    row("UNITS", Read(|args| coordinates::units(args).map(Coordinates)), "/MM|INCH|INCHES"),
    row("UNLOAD", Read(|args| tool::unload(args).map(Tool)), "[/TOOL[,n]]"),
    row("WCS", Hazard(OFFSET), ""),
    row("WPLANE", Hazard(FRAME), ""),
    row("ZERO", Hazard(OFFSET), ""),
    row("ZSURF", Hazard(MOVES_COORDINATES), ""),
];

/// CUTCOM: cutter compensation, or the register of the tool length.
fn cutcom<'a>(args: &mut Args<'a>) -> Result<Record<'a>, ClFault> {
    match tool::length_compensation(args)? {
        Some(register) => Ok(Tool(register)),
        None => machine::compensation(args).map(Machine),
    }
}

/// Words that are read for notes in the program (names, messages, sizes of cutters). Without them a note is missing,
/// and what needs the size of a cutter is refused, so they may be declared inert.
const NOTES: [&str; 6] = ["CUTTER", "MACHIN", "PARTNO", "PPRINT", "TLDATA", "TOOLNO"];

impl WordRow {
    /// Whether the word is read for notes only.
    pub(crate) fn is_note(&self) -> bool {
        NOTES.contains(&self.word.name)
    }
}

/// Prefix of the words with which SolidWorks CAM describes a tool (`CSI_SET_FLUTE_LENGTH/70.`).
const TOOL_DESCRIPTION: &[u8] = b"CSI_";

/// Row of all words with that prefix.
static TOOL_DESCRIBED: WordRow = row("CSI_", Inert, "");

/// Finds the row of a major word, in capitals or small letters.
pub(crate) fn look_up(word: &[u8]) -> Option<&'static WordRow> {
    match TABLE.binary_search_by(|row| compare(row.word.name.as_bytes(), word)) {
        Ok(index) => Some(&TABLE[index]),
        Err(_) => {
            let described = word.get(..TOOL_DESCRIPTION.len())?.eq_ignore_ascii_case(TOOL_DESCRIPTION);
            described.then_some(&TOOL_DESCRIBED)
        }
    }
}

/// Whether a text can be a major word.
pub(super) fn is_word(text: &str) -> bool {
    let of_word = |byte: u8| byte.is_ascii_alphanumeric() || matches!(byte, b'-' | b'_' | b' ');
    !text.is_empty() && text.bytes().all(of_word)
}

/// Reason why a word cannot be declared inert; `None` if it can.
#[must_use]
pub(crate) fn not_inert(word: &str) -> Option<String> {
    if !is_word(word) {
        return Some(format!("`{word}` is not a word of CL data"));
    }
    let row = look_up(word.as_bytes())?;
    match row.handling {
        Read(_) | ReadText(_) if row.is_note() => None,
        Read(_) | ReadText(_) => Some(format!("{word} is read, so it cannot be inert")),
        Hazard(reason) => Some(format!("{word} cannot be inert: {reason}")),
        Lathe => Some(format!("{word} cannot be inert: it belongs to turning")),
        Inert | Refused(_) | Automatic(_) => None,
    }
}

/// Writes the table of words, by handling.
///
/// # Errors
/// Those of the output.
pub(crate) fn list(out: &mut dyn Write) -> io::Result<()> {
    writeln!(
        out,
        "Words of CL data. A word that is not listed is refused, unless `--inert WORD` declares it inert\nor `[cl.words]` of the configuration states the block of its statement."
    )?;
    list_section(out, "Read", |WordRow { word: MajorWord { name, forms }, handling }| {
        let glue = if forms.starts_with(['/', ',', '[']) || forms.is_empty() { "" } else { " " };
        handling.is_read().then(|| format!("{name}{glue}{forms}"))
    })?;
    writeln!(out, "\n`--inert WORD` passes over these, too, which are notes: {}", NOTES.join(" "))?;
    list_section(out, "Inert: no motion and no change of state", |row| match row.handling {
        Inert => Some(row.word.name.to_string()),
        Read(_) | ReadText(_) | Refused(_) | Automatic(_) | Hazard(_) | Lathe => None,
    })?;
    writeln!(out, "    CSI_..")?;
    list_section(out, "Refused, unless `--inert WORD` permits to skip the word", |row| match row.handling {
        Automatic(reason) if !row.word.forms.is_empty() => {
            Some(format!("{0:<11} {reason}; {0}{1}", row.word.name, row.word.forms))
        }
        Refused(reason) | Automatic(reason) => Some(format!("{:<11} {reason}", row.word.name)),
        Read(_) | ReadText(_) | Inert | Hazard(_) | Lathe => None,
    })?;
    list_section(out, "Always refused", |row| match row.handling {
        Hazard(reason) => Some(format!("{:<11} {reason}", row.word.name)),
        Lathe => Some(format!("{:<11} it belongs to turning", row.word.name)),
        Read(_) | ReadText(_) | Inert | Refused(_) | Automatic(_) => None,
    })
}

/// Writes a heading and a line for each row of which `line` makes one.
fn list_section(out: &mut dyn Write, heading: &str, line: impl Fn(&WordRow) -> Option<String>) -> io::Result<()> {
    writeln!(out, "\n{heading}")?;
    TABLE.iter().filter_map(line).try_for_each(|line| writeln!(out, "    {line}"))
}

fn compare(name: &[u8], word: &[u8]) -> Ordering {
    name.iter().copied().cmp(word.iter().map(u8::to_ascii_uppercase))
}

/// Known word nearest to a misspelt one, if it is near enough.
pub(crate) fn nearest_word(word: &str) -> Option<&'static str> {
    /// Largest number of typing errors; with more the suggestion would be a guess.
    const MOST_TYPING_ERRORS: usize = 2;
    if word.len() > 16 {
        return None;
    }
    let word = word.to_ascii_uppercase();
    let allowed = MOST_TYPING_ERRORS.min(word.len() / 3);
    // Words of another length are left out first: the search is the most expensive part of a fault.
    let similar = TABLE.iter().map(|row| row.word.name).filter(|name| name.len().abs_diff(word.len()) <= allowed);
    let (distance, name) =
        similar.map(|name| (strsim::damerau_levenshtein(&word, name), name)).min_by_key(|(distance, _)| *distance)?;
    (distance <= allowed).then_some(name)
}

/// Whether a statement has at least as many numbers as a frame or a point with a tool axis.
pub(super) fn has_numbers_of_a_frame(text: &[u8]) -> bool {
    let pieces = text.split(|byte| matches!(byte, b',' | b'/'));
    pieces.filter(|piece| whole_number(trimmed(piece)).is_some()).count() >= NUMBERS_OF_A_FRAME
}

/// Place of the major word; it may contain `-` and `_`. TOOL PATH is one word with a blank inside, if a slash follows:
/// a listing of NX ends in `Tool Path Listing has 17 lines.`
pub(super) fn major_word(text: &[u8]) -> Span {
    let length = |text: &[u8]| {
        text.iter().take_while(|byte| byte.is_ascii_alphanumeric() || matches!(byte, b'-' | b'_')).count()
    };
    let end = length(text);
    if text[..end].eq_ignore_ascii_case(b"TOOL") {
        let next = skip_blanks(text, end);
        let path = next + length(&text[next..]);
        // The table spells the word with exactly one blank.
        let has_slash = text.get(skip_blanks(text, path)) == Some(&b'/');
        if next == end + 1 && has_slash && text[next..path].eq_ignore_ascii_case(b"PATH") {
            return Span { start: 0, end: path };
        }
    }
    Span { start: 0, end }
}

/// Count of numbers from which on a statement of an unknown word may be a frame or a point with a tool axis.
const NUMBERS_OF_A_FRAME: usize = 6;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cl::text::Span;

    #[test]
    fn the_table_is_sorted_and_has_no_word_twice() {
        assert!(TABLE.windows(2).all(|pair| pair[0].word.name < pair[1].word.name));
    }

    #[test]
    fn words_are_found_in_any_case() {
        let point = Point { tip: [1.0, 2.0, 3.0], axis: None, at: Span { start: 0, end: 5 } };
        for (word, name, record) in [
            ("goto", "GOTO", Motion(MotionRecord::Goto(point))),
            ("End-Of-Path", "END-OF-PATH", Program(ProgramRecord::EndOfPath)),
        ] {
            let row = look_up(word.as_bytes()).unwrap();
            assert_eq!(row.word.name, name);
            let Read(read) = row.handling else { panic!("{word} is read") };
            assert_eq!(read(&mut Args::new(&row.word, b"1,2,3", 0)).unwrap(), record);
        }
        let described = look_up(b"csi_set_flute_length").unwrap();
        assert!(described.word.name == "CSI_" && matches!(described.handling, Inert));
        assert!(look_up(b"CSI").is_none());
        assert!(look_up(b"").is_none());
    }

    #[test]
    fn only_what_moves_nothing_can_be_declared_inert() {
        let frames =
            ["CAMERA", "CSYS", "LOCALCS", "MCS", "MCS2", "mcsys", "MODSYS", "MSYS", "PLANE", "REFSYS", "WPLANE"];
        let modes = ["APPLY", "DATUM", "MODE", "POLAR", "ROTHED", "RTCP", "TCP", "TCPCTL", "TRAORI", "WCS", "ZERO"];
        for word in ["GOTO", "LOOP", "SYN", "COPY", "TURRET", "DNTCUT", "SCALE", "", "A/B"]
            .into_iter()
            .chain(frames)
            .chain(modes)
        {
            assert!(not_inert(word).is_some(), "{word}");
        }
        for word in
            ["AICC", "FIXOFTCO", "BREAK", "MOVE_ATTRIB", "OPFEATSTART", "PAINT", "TOOLNO", "tldata", "CLAMP", "unclamp"]
        {
            assert_eq!(not_inert(word), None, "{word}");
        }
    }

    #[test]
    fn the_list_names_every_word_once() {
        let mut text = Vec::new();
        list(&mut text).unwrap();
        let text = String::from_utf8(text).unwrap();
        for WordRow { word: MajorWord { name, .. }, .. } in TABLE {
            let listed = text.lines().filter(|line| {
                let word = line.trim_start().split(['/', ',', '[']).next().unwrap();
                line.starts_with("    ") && (word == *name || word.starts_with(&format!("{name} ")))
            });
            assert_eq!(listed.count(), 1, "{name}");
        }
    }

    #[test]
    fn a_typing_error_finds_the_word_and_gibberish_finds_none() {
        assert_eq!(nearest_word("GOTTO"), Some("GOTO"));
        assert_eq!(nearest_word("fedart"), Some("FEDRAT"));
        assert_eq!(nearest_word("SPINDLE"), Some("SPINDL"));
        assert_eq!(nearest_word("sfsdfsdf"), None);
        assert_eq!(nearest_word("X"), None);
    }
}
