//! The table of a control: what its codes look like.
//!
//! Texts with braces are [templates](crate::control::template).

use crate::motion::PathNorm;
use crate::motion::{CycleAbilities, PlaneAngles, PoseRule, Registers};
use crate::nc::Formats;
use crate::nc::Numerals;
use crate::program::{Coolant, Rotation};

/// Codes of a control.
#[derive(Debug)]
pub struct Spellings {
    /// Name on the command line.
    pub name: &'static str,
    /// Name for people.
    pub title: &'static str,
    /// Digits of its words.
    pub formats: Formats,
    /// What its numbers look like.
    pub numerals: Numerals,
    /// Longest line the control reads, line end not counted.
    pub line_length: usize,
    /// Every line has a number, from 0 on and without N.
    pub numbers_every_line: bool,
    /// Comments.
    pub comment: CommentStyle,
    /// Before and after the name of an operation, where that is no comment.
    pub operation: Option<[&'static str; 2]>,
    /// Lines before everything else.
    pub opening: &'static [&'static str],
    /// Last block.
    pub end: &'static str,
    /// Lines after the last block.
    pub closing: &'static [&'static str],
    /// Digits of the program number; 0: programs have none.
    pub number_digits: usize,
    /// The program's name is one word of capitals, digits and `_`.
    pub plain_name: bool,
    /// `{units}` for millimetres and for inches.
    pub units: [&'static str; 2],
    /// Safety blocks of a restart point: everything cancelled, absolute, feed per minute, work offset.
    pub safety: &'static [&'static str],
    /// Feed per minute.
    pub per_minute: &'static str,
    /// Title of a work offset for people, before its word.
    pub offset_title: &'static str,
    /// Inverse time, F in 1/min; `None` if the control has none.
    pub inverse_time: Option<&'static str>,
    /// The path along which F counts where a rotary axis moves.
    pub path_norm: PathNorm,
    /// Units of F in one unit of length of an inch program.
    pub feed_per_inch: f64,
    /// Rapid.
    pub rapid: &'static str,
    /// After the words of a rapid.
    pub rapid_end: &'static str,
    /// Feed.
    pub feed: &'static str,
    /// Arcs.
    pub arcs: ArcCodes,
    /// Cycles of holes.
    pub cycles: Option<HoleCycles>,
    /// The motion code stays in force.
    pub motion_modal: bool,
    /// Path without cutter compensation, after the axis words; stays in force.
    pub no_compensation: &'static str,
    /// Cutter compensation left, right and off, as templates.
    pub compensation: [&'static str; 3],
    /// Around the words of a rapid in machine coordinates.
    pub machine: [&'static str; 2],
    /// Tool call, and the tool after it.
    pub tool_change: &'static [&'static str],
    /// The tool after it is called up unless the configuration sets otherwise.
    pub preselect: bool,
    /// Length offset.
    pub length: LengthCodes,
    /// Speed in a block of its own, where that of the spindle cannot hold it.
    pub speed: Option<&'static str>,
    /// Spindle clockwise and counter-clockwise.
    pub spindle: [&'static str; 2],
    /// Spindle stop.
    pub spindle_off: &'static str,
    /// Coolant off.
    pub coolant_off: &'static str,
    /// Flood, mist, through the spindle and air: on and off.
    pub coolant: [Option<[&'static str; 2]>; 4],
    /// Stop, and stop where the operator has asked for it.
    pub stop: [&'static str; 2],
    /// Dwell.
    pub dwell: &'static [&'static str],
    /// Longest dwell that it can hold, milliseconds; a longer one is written as several.
    pub longest_dwell: u32,
    /// Smoothing on, for roughing, medium and finishing; empty if only `safety` can ask for it.
    pub smoothing: [&'static [&'static str]; 3],
    /// Smoothing off.
    pub smoothing_off: &'static [&'static str],
    /// Rotary axes rotate as their words state, or by the shortest path.
    pub rotary_path: [&'static str; 2],
    /// Tip control; `None` if only the configuration can state how it is switched.
    pub tip: Option<TipControlCodes>,
    /// Tilted planes.
    pub plane: Option<TiltedPlaneCodes>,
    /// Assumption about the rotary axes of this control where words go beyond 360°.
    pub rotary_note: &'static str,
}

/// How arcs look.
#[derive(Debug)]
pub struct ArcCodes {
    /// Clockwise and counter-clockwise.
    pub senses: [&'static str; 2],
    /// The planes perpendicular to X, to Y and to Z, stated before an arc and in force from there on; `None`: no arcs in it.
    pub planes: [Option<&'static str>; 3],
    /// How the centre is written.
    pub centre: ArcCentre,
    /// Address of a radius in the place of the centre.
    pub radius: &'static str,
    /// Largest difference of the distances of both ends from the centre, mm.
    pub radius_tolerance_mm: f64,
}

/// How cycles of holes look.
#[derive(Debug)]
pub struct HoleCycles {
    /// Cycles that the planner may use.
    pub abilities: CycleAbilities,
    /// How they are written.
    pub form: CycleForm,
}

/// How a cycle is written.
#[derive(Debug)]
pub enum CycleForm {
    /// A code with X Y Z R and what belongs to it, in force until it is cancelled.
    Codes(CycleCodes),
    /// Blocks that define it, and each place in a block of its own.
    Definitions(CycleDefinitions),
}

/// A cycle by a code.
#[derive(Debug)]
pub struct CycleCodes {
    /// Back to the clearance level, and to the level before.
    pub returns: [&'static str; 2],
    /// In and out; the same with a wait at the bottom.
    pub drill: [&'static str; 2],
    /// With a retreat to the clearance level after each step.
    pub peck: &'static str,
    /// With a short retreat after each step.
    pub chip_break: &'static str,
    /// Out at feed; the same with a wait at the bottom.
    pub ream: [&'static str; 2],
    /// Threads.
    pub thread: ThreadCodes,
    /// The wait, as a template.
    pub dwell: &'static str,
    /// Cancels it.
    pub end: &'static str,
}

/// A cycle by blocks that are templates.
#[derive(Debug)]
pub struct CycleDefinitions {
    /// In and out, with a wait at the bottom that may be 0.
    pub drill: &'static [&'static str],
    /// The same where nothing is waited for, if that is another one.
    pub plain_drill: Option<&'static [&'static str]>,
    /// With a retreat to the clearance level after each step.
    pub peck: &'static [&'static str],
    /// With a short retreat after each step.
    pub chip_break: &'static [&'static str],
    /// Out at feed.
    pub ream: &'static [&'static str],
    /// A thread.
    pub thread: &'static [&'static str],
    /// After the words of a place, where each calls the cycle by itself and the definition outlives other motions.
    pub call: &'static str,
    /// Ends it, where every motion calls it.
    pub end: &'static str,
}

/// How a thread is cut, where cycles are codes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ThreadCodes {
    /// By a cycle with F.
    Cycle {
        /// Right-hand and left-hand.
        codes: [&'static str; 2],
        /// Brings the spindle under control of its angle, as a template.
        rigid: &'static str,
    },
    /// By a motion with the pitch as K, which returns to its start.
    Motion(&'static str),
}

/// How the centre of an arc is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ArcCentre {
    /// In the block, as I J K counted from the start.
    Offsets,
    /// In a block of its own, `CC` with coordinates; a helix counts its angle.
    Pole,
}

/// How comments look.
#[derive(Debug)]
pub struct CommentStyle {
    /// Before and after the text.
    pub marks: [&'static str; 2],
    /// Most bytes of text in one line.
    pub length: usize,
    /// The byte that is written for one of the text.
    pub byte: fn(u8) -> u8,
}

/// How a length offset is called and cancelled.
#[derive(Debug)]
pub struct LengthCodes {
    /// The code.
    pub code: &'static str,
    /// The block in which it is called.
    pub call: LengthCall,
    /// Cancels it in a block of machine coordinates.
    pub off: &'static str,
    /// A block of machine coordinates ends it.
    pub machine_ends: bool,
    /// The meaning of the register.
    pub registers: Registers,
    /// Address of the register, for people.
    pub address: &'static str,
}

/// How tip control is switched.
#[derive(Debug)]
pub struct TipControlCodes {
    /// Blocks that switch it on; empty if it comes with the length offset.
    pub on: &'static [&'static str],
    /// The code in the place of the length offset.
    pub with_length: Option<&'static str>,
    /// Blocks that switch it off.
    pub off: &'static [&'static str],
    /// Blocks of a restart point besides those of `safety`.
    pub reset: &'static [&'static str],
    /// It goes together with the length offset, which has to be called again.
    pub ends_length: bool,
    /// Words for a tool axis that follows the rotary axes, and for one that rotates in the plane of its ends.
    pub posture: [&'static str; 2],
    /// How it takes the tool axis as a vector, if it does.
    pub vectors: Option<ToolAxisWords>,
    /// The frame in which it counts is a setting of the machine.
    pub frame_is_set: bool,
    /// It can rotate the tool axis in the plane of its ends.
    pub turns_in_plane: bool,
    /// Its assumption about the machine.
    pub note: &'static str,
}

/// How a tool axis is written as a vector.
#[derive(Debug)]
pub struct ToolAxisWords {
    /// Addresses of its components.
    pub words: [&'static str; 3],
    /// The code in the place of the length offset.
    pub with_length: Option<&'static str>,
    /// Codes of a straight motion that holds one, rapid and at feed, where they are codes of their own.
    pub motion: Option<&'static str>,
    /// The end of a rapid that holds one.
    pub rapid_end: &'static str,
    /// As [`TipControlCodes::posture`].
    pub posture: [&'static str; 2],
}

/// How a plane is tilted.
#[derive(Debug)]
pub struct TiltedPlaneCodes {
    /// Blocks that tilt it.
    pub on: &'static [&'static str],
    /// The length offset is called before it.
    pub length_first: bool,
    /// Blocks that cancel it.
    pub off: &'static [&'static str],
    /// Blocks of a restart point besides those of `safety`.
    pub reset: &'static [&'static str],
    /// Words for the pose with the lower, and with the higher angle.
    pub poses: [&'static str; 2],
    /// The meaning of its words.
    pub angles: PlaneAngles,
    /// Decimals of its angles; `None`: as many as rotary words have.
    pub decimals: Option<u32>,
    /// How the control chooses its pose.
    pub pose: PoseRule,
    /// It is cancelled after the machine retract.
    pub cancelled_after_retract: bool,
    /// Its assumption about the machine.
    pub note: &'static str,
}

/// The block in which a length offset is called.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LengthCall {
    /// In a block of its own: it moves nothing.
    Alone,
    /// In the block that moves Z: it may move by itself.
    WithZ,
    /// The tool call has done it.
    WithTool,
}

/// The index of a kind of coolant in a table.
pub(crate) fn coolant_index(coolant: Coolant) -> Option<usize> {
    match coolant {
        Coolant::On | Coolant::Flood => Some(0),
        Coolant::Mist => Some(1),
        Coolant::Through => Some(2),
        Coolant::Air => Some(3),
        Coolant::Off => None,
    }
}

impl Spellings {
    /// The code of a sense of rotation.
    #[must_use]
    pub fn rotation(&self, rotation: Rotation) -> &'static str {
        match rotation {
            Rotation::Clockwise => self.spindle[0],
            Rotation::CounterClockwise => self.spindle[1],
        }
    }
}

/// A printable byte of ASCII that closes no comment in brackets.
pub(crate) fn ascii_in_brackets(byte: u8) -> u8 {
    match byte {
        b'(' => b'[',
        b')' => b']',
        b'%' => b'_',
        _ => printable(byte),
    }
}

/// A printable byte of ASCII.
pub(crate) fn printable(byte: u8) -> u8 {
    match byte {
        b'\t' => b' ',
        0x20..=0x7e => byte,
        _ => b'?',
    }
}
