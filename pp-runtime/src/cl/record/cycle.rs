//! `CYCLE/..`: its words as written, in any order. Their meaning depends on the CAM system and is in `meaning/holes`.

use std::fmt::{self, Display, Formatter};

use super::feed::FeedUnit;
use super::values::{ClNumber, word_of};
use crate::cl::text::{Arg, Args, ClFault, Span, quoted};
use crate::diag::code::cl;
use crate::program::{Dwell, MOST_GAPS};

/// Kind of CYCLE: the word after `CYCLE/`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ClCycleKind {
    /// DRILL.
    Drill,
    /// FACE: with a dwell at the bottom.
    Face,
    /// CSINK.
    Csink,
    /// THRU.
    Thru,
    /// DEEP, DEEP2, and DRILL,DEEP of NX.
    Deep,
    /// BRKCHP.
    Brkchp,
    /// BORE.
    Bore,
    /// BACK.
    Back,
    /// REAM.
    Ream,
    /// TAP, and RIGID of *CAMplete APT*, whose PITCH is that of the thread.
    Tap,
    /// CBORE.
    Cbore,
}

impl ClCycleKind {
    /// Words and kinds; of several words of a kind the first is written.
    pub const WORDS: [(&'static str, ClCycleKind); 13] = [
        ("DRILL", ClCycleKind::Drill),
        ("FACE", ClCycleKind::Face),
        ("CSINK", ClCycleKind::Csink),
        ("THRU", ClCycleKind::Thru),
        ("DEEP", ClCycleKind::Deep),
        ("DEEP2", ClCycleKind::Deep),
        ("BRKCHP", ClCycleKind::Brkchp),
        ("BORE", ClCycleKind::Bore),
        ("BACK", ClCycleKind::Back),
        ("REAM", ClCycleKind::Ream),
        ("TAP", ClCycleKind::Tap),
        ("RIGID", ClCycleKind::Tap),
        ("CBORE", ClCycleKind::Cbore),
    ];

    /// The word that is written for this kind.
    #[must_use]
    pub fn word(self) -> &'static str {
        word_of(&Self::WORDS, &self)
    }
}

/// Return level as written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Return {
    /// RTRCTO,AUTO: the level of the tool before the cycle.
    Auto,
    /// `RTRCTO,v[,MANUAL]` or `RETURN,v`.
    Level(f64),
}

/// Largest number of numbers without a word in a CYCLE. They are as many as the depths of THRU after the first, two for
/// each plate after the first.
pub(crate) const MOST_POSITIONAL: usize = 2 * MOST_GAPS;

/// Pitch of a thread as written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ThreadPitch {
    /// PITCH: units of the file per revolution.
    PerRevolution(f64),
    /// TPI: threads per inch.
    ThreadsPerInch(f64),
}

/// The words of a CYCLE as written, lengths in units of the file; their meaning depends on the CAM system.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CycleCall {
    /// Kind of the cycle.
    pub kind: ClCycleKind,
    /// FEDTO: level of the bottom along the tool axis (NX), or depth, positive into the part (SolidWorks CAM).
    pub fedto: Option<f64>,
    /// DEPTH: depth, positive into the part.
    pub depth: Option<f64>,
    /// DIAMET: diameter of a countersink at the top of the hole.
    pub diameter: Option<f64>,
    /// TLANGL: included angle of the tool that makes it, degrees.
    pub tool_angle_deg: Option<f64>,
    /// Feed with its unit.
    pub feed: Option<(f64, FeedUnit)>,
    /// RAPTO: clearance level.
    pub rapto: Option<f64>,
    /// CLEAR: clearance level.
    pub clear: Option<f64>,
    /// RTRCTO or RETURN: return level.
    pub back_to: Option<Return>,
    /// STEP, INCR or SUBPECK: depth of each step.
    pub step: Option<f64>,
    /// 1STPECK: depth of the first step.
    pub first_step: Option<f64>,
    /// `DWELL,n`; `DWELL,REV,n` or `REV,n`.
    pub dwell: Option<Dwell>,
    /// BACK,g of BRKCHP: retract after each step.
    pub back: Option<f64>,
    /// ORIENT,a: angle at which the spindle stops.
    pub orient_deg: Option<f64>,
    /// Pitch of a thread.
    pub pitch: Option<ThreadPitch>,
    /// Numbers without a word, in order, or further depths.
    pub positional: [f64; MOST_POSITIONAL],
    /// Count of the numbers without a word.
    pub positionals: u8,
    /// Count of the numbers directly after that of DEPTH in THRU: top and bottom of each further plate. A record has no
    /// other numbers without a word then.
    pub further_depths: u8,
    /// Place of the arguments, for messages.
    pub at: Span,
    /// Place of the depth, for messages.
    pub depth_at: Span,
}

impl CycleCall {
    /// A cycle of this kind without any other word.
    #[must_use]
    pub const fn new(kind: ClCycleKind, at: Span) -> Self {
        CycleCall {
            kind,
            fedto: None,
            depth: None,
            diameter: None,
            tool_angle_deg: None,
            feed: None,
            rapto: None,
            clear: None,
            back_to: None,
            step: None,
            first_step: None,
            dwell: None,
            back: None,
            orient_deg: None,
            pitch: None,
            positional: [0.0; MOST_POSITIONAL],
            positionals: 0,
            further_depths: 0,
            at,
            depth_at: at,
        }
    }
}

/// State that `CYCLE/..` without a kind sets.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CycleState {
    /// OFF: GOTOs are motions again.
    Off,
    /// ON: the last cycle is in force again.
    On,
    /// INIT: the next cycle returns to the level of its RTRCTO (SolidWorks CAM).
    Initial,
    /// CLEAR: the next cycle returns to its clearance level (SolidWorks CAM).
    Clear,
}

impl CycleState {
    const WORDS: [(&'static str, CycleState); 4] =
        [("OFF", CycleState::Off), ("ON", CycleState::On), ("INIT", CycleState::Initial), ("CLEAR", CycleState::Clear)];
}

/// A record that begins, ends or resumes a cycle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CycleRecord {
    /// `CYCLE/kind,..`.
    Define(CycleCall),
    /// `CYCLE/ON,..`: the cycle before it with these words in place of its own (NX). The kind is not used.
    Change(CycleCall),
    /// `CYCLE/OFF`, `CYCLE/ON`, `CYCLE/INIT`, `CYCLE/CLEAR`.
    Switch {
        /// New state.
        state: CycleState,
        /// Place of the word, for messages.
        at: Span,
    },
}

/// CYCLE.
pub(crate) fn cycle(args: &mut Args<'_>) -> Result<CycleRecord, ClFault> {
    let at = args.all();
    let first = args.needed()?;
    if let Some(state) = first.among(&CycleState::WORDS) {
        if state != CycleState::On || args.clone().next()?.is_none() {
            return Ok(CycleRecord::Switch { state, at: first.at });
        }
        let mut change = CycleCall::new(ClCycleKind::Drill, at);
        while let Some(arg) = args.next()? {
            change.take(arg, args)?;
            if change.positionals > 0 {
                // Numbers without a word have a place in a whole record only.
                return Err(args.not_understood(arg));
            }
        }
        return Ok(CycleRecord::Change(change));
    }
    let kind = first.among(&ClCycleKind::WORDS).ok_or_else(|| args.not_understood(first))?;
    let mut cycle = CycleCall::new(kind, at);
    let mut only_kind = true;
    while let Some(arg) = args.next()? {
        match arg.among(&ClCycleKind::WORDS) {
            // NX writes DRILL,DEEP for deep drilling.
            Some(kind) if only_kind && cycle.kind == ClCycleKind::Drill => cycle.kind = kind,
            _ => cycle.take(arg, args)?,
        }
        only_kind = false;
    }
    Ok(CycleRecord::Define(cycle))
}

/// Field of a cycle that holds the number after a word.
type NumberOf = fn(&mut CycleCall) -> &mut Option<f64>;

/// Words that are followed by one number. DIAMET, TLANGL: *CL Output for Holemaking Cycles* of PTC.
const NUMBER_AFTER: [(&str, NumberOf); 10] = [
    ("1STPECK", |cycle| &mut cycle.first_step),
    ("RAPTO", |cycle| &mut cycle.rapto),
    ("CLEAR", |cycle| &mut cycle.clear),
    ("STEP", |cycle| &mut cycle.step),
    ("INCR", |cycle| &mut cycle.step),
    ("SUBPECK", |cycle| &mut cycle.step),
    ("BACK", |cycle| &mut cycle.back),
    ("ORIENT", |cycle| &mut cycle.orient_deg),
    ("DIAMET", |cycle| &mut cycle.diameter),
    ("TLANGL", |cycle| &mut cycle.tool_angle_deg),
];

impl CycleCall {
    /// Depths after the first, in order.
    pub(crate) fn further_depths(&self) -> &[f64] {
        &self.positional[..usize::from(self.further_depths).min(MOST_POSITIONAL)]
    }

    /// This cycle with the words of `change` in place of its own.
    pub(crate) fn changed_by(&self, change: &CycleCall) -> CycleCall {
        let depth_is_changed = change.fedto.is_some() || change.depth.is_some();
        CycleCall {
            kind: self.kind,
            fedto: if depth_is_changed { change.fedto } else { self.fedto },
            depth: if depth_is_changed { change.depth } else { self.depth },
            further_depths: if depth_is_changed { 0 } else { self.further_depths },
            diameter: change.diameter.or(self.diameter),
            tool_angle_deg: change.tool_angle_deg.or(self.tool_angle_deg),
            feed: change.feed.or(self.feed),
            rapto: change.rapto.or(self.rapto),
            clear: change.clear.or(self.clear),
            back_to: change.back_to.or(self.back_to),
            step: change.step.or(self.step),
            first_step: change.first_step.or(self.first_step),
            dwell: change.dwell.or(self.dwell),
            back: change.back.or(self.back),
            orient_deg: change.orient_deg.or(self.orient_deg),
            pitch: change.pitch.or(self.pitch),
            positional: self.positional,
            positionals: self.positionals,
            at: change.at,
            depth_at: if depth_is_changed { change.depth_at } else { change.at },
        }
    }

    /// Reads one word with its arguments, or a number without a word.
    fn take(&mut self, arg: Arg<'_>, args: &mut Args<'_>) -> Result<(), ClFault> {
        if let Some(place) = arg.among(&NUMBER_AFTER) {
            return put(place(self), arg, args);
        }
        if arg.looks_numeric() {
            return self.take_number(arg, args);
        }
        if let Some(unit) = arg.among(&FeedUnit::WORDS) {
            let value = args.number_after(arg)?.number()?;
            return once(self.feed.replace((value, unit)).is_none(), arg);
        }
        if arg.is("FEDTO") || arg.is("DEPTH") {
            return self.take_depth(arg, args);
        }
        if arg.is("RTRCTO") || arg.is("RETURN") {
            return self.take_return(arg, args);
        }
        if arg.is("DWELL") || arg.is("REV") {
            let in_revolutions = arg.is("REV") || follows(args, "REV")?;
            let value = args.number_after(arg)?.number()?;
            let dwell = if in_revolutions { Dwell::Revolutions(value) } else { Dwell::Seconds(value) };
            return one_of_two(self.dwell.replace(dwell).is_none(), arg, "dwells", "DWELL and REV");
        }
        // PITCH: script of *CAMplete APT*; TPI: *CL Output for Holemaking Cycles* of PTC.
        if arg.is("PITCH") || arg.is("TPI") {
            let value = args.number_after(arg)?.number()?;
            let pitch =
                if arg.is("TPI") { ThreadPitch::ThreadsPerInch(value) } else { ThreadPitch::PerRevolution(value) };
            return one_of_two(self.pitch.replace(pitch).is_none(), arg, "pitches", "PITCH and TPI");
        }
        Err(args.not_understood(arg))
    }

    fn take_number(&mut self, arg: Arg<'_>, args: &Args<'_>) -> Result<(), ClFault> {
        let value = arg.number()?;
        let place = self.positional.get_mut(usize::from(self.positionals));
        let Some(place) = place.filter(|_| self.further_depths == 0) else {
            return Err(args.not_understood(arg));
        };
        if self.positionals == 0 {
            self.depth_at = arg.at;
        }
        *place = value;
        self.positionals += 1;
        Ok(())
    }

    fn take_depth(&mut self, word: Arg<'_>, args: &mut Args<'_>) -> Result<(), ClFault> {
        let depth = args.number_after(word)?;
        once(self.fedto.is_none() && self.depth.is_none(), word)?;
        let place = if word.is("FEDTO") { &mut self.fedto } else { &mut self.depth };
        *place = Some(depth.number()?);
        self.depth_at = depth.at;
        if self.kind == ClCycleKind::Thru && word.is("DEPTH") { self.take_further_depths(args) } else { Ok(()) }
    }

    /// Numbers directly after that of DEPTH in THRU.
    fn take_further_depths(&mut self, args: &mut Args<'_>) -> Result<(), ClFault> {
        let mut ahead = args.clone();
        while let Some(arg) = ahead.next()?.filter(|arg| arg.looks_numeric()) {
            *args = ahead.clone();
            if self.positionals > 0 {
                return Err(args.not_understood(arg));
            }
            let value = arg.number()?;
            let Some(place) = self.positional.get_mut(usize::from(self.further_depths)) else {
                let text = format!("THRU with more than {} plates", MOST_GAPS + 1);
                return Err(cl::HOLE.cl_fault("CYCLE", arg.at, text, "drill this hole in two cycles"));
            };
            *place = value;
            self.further_depths += 1;
            self.depth_at.end = arg.at.end;
        }
        Ok(())
    }

    fn take_return(&mut self, word: Arg<'_>, args: &mut Args<'_>) -> Result<(), ClFault> {
        let auto = follows(args, "AUTO")?;
        let level = if auto { Return::Auto } else { Return::Level(args.number_after(word)?.number()?) };
        // *CAMplete APT* writes RTRCTO and RETURN, with one level.
        let again = self.back_to == Some(level);
        once(self.back_to.replace(level).is_none() || again, word)?;
        follows(args, "MANUAL")?;
        Ok(())
    }
}

/// Takes the next argument if it is this word; returns whether it is.
fn follows(args: &mut Args<'_>, word: &str) -> Result<bool, ClFault> {
    let mut ahead = args.clone();
    let found = ahead.next()?.is_some_and(|next| next.is(word));
    if found {
        *args = ahead;
    }
    Ok(found)
}

/// Reads the number after a word into its field.
fn put(place: &mut Option<f64>, word: Arg<'_>, args: &mut Args<'_>) -> Result<(), ClFault> {
    let value = args.number_after(word)?.number()?;
    once(place.replace(value).is_none(), word)
}

/// Refuses a word that is written a second time.
fn once(first: bool, word: Arg<'_>) -> Result<(), ClFault> {
    if first {
        return Ok(());
    }
    let text = format!("{} is programmed twice in this cycle", quoted(word.text));
    Err(cl::HOLE.cl_fault("CYCLE", word.at, text, "program each word of a CYCLE once"))
}

/// Refuses the second of two words that state the same.
fn one_of_two(first: bool, word: Arg<'_>, what: &str, words: &str) -> Result<(), ClFault> {
    if first {
        return Ok(());
    }
    let text = format!("this cycle states two {what}");
    Err(cl::HOLE.cl_fault("CYCLE", word.at, text, format!("program one of {words}, once")))
}

impl Display for CycleCall {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "CYCLE/{}", self.kind.word())?;
        self.write_words(out)
    }
}

impl CycleCall {
    /// Writes all words after the first.
    fn write_words(&self, out: &mut Formatter<'_>) -> fmt::Result {
        for value in &self.positional[..usize::from(self.positionals).min(MOST_POSITIONAL)] {
            write!(out, ",{}", ClNumber(*value))?;
        }
        for (word, value) in [
            ("FEDTO", self.fedto),
            ("DIAMET", self.diameter),
            ("TLANGL", self.tool_angle_deg),
            ("STEP", self.step),
            ("1STPECK", self.first_step),
            ("RAPTO", self.rapto),
            ("CLEAR", self.clear),
            ("BACK", self.back),
            ("ORIENT", self.orient_deg),
        ] {
            if let Some(value) = value {
                write!(out, ",{word},{}", ClNumber(value))?;
            }
        }
        match self.dwell {
            Some(Dwell::Seconds(value)) => write!(out, ",DWELL,{}", ClNumber(value))?,
            Some(Dwell::Revolutions(value)) => write!(out, ",REV,{}", ClNumber(value))?,
            None => {}
        }
        match self.pitch {
            Some(ThreadPitch::PerRevolution(value)) => write!(out, ",PITCH,{}", ClNumber(value))?,
            Some(ThreadPitch::ThreadsPerInch(value)) => write!(out, ",TPI,{}", ClNumber(value))?,
            None => {}
        }
        if let Some(depth) = self.depth {
            write!(out, ",DEPTH,{}", ClNumber(depth))?;
            for depth in self.further_depths() {
                write!(out, ",{}", ClNumber(*depth))?;
            }
        }
        match self.back_to {
            Some(Return::Auto) => out.write_str(",RTRCTO,AUTO")?,
            Some(Return::Level(level)) => write!(out, ",RTRCTO,{}", ClNumber(level))?,
            None => {}
        }
        self.feed.map_or(Ok(()), |(value, unit)| write!(out, ",{},{}", unit.word(), ClNumber(value)))
    }
}

impl Display for CycleRecord {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Define(words) => words.fmt(out),
            Self::Change(words) => {
                out.write_str("CYCLE/ON")?;
                words.write_words(out)
            }
            Self::Switch { state, .. } => write!(out, "CYCLE/{}", word_of(&CycleState::WORDS, state)),
        }
    }
}
