//! Table of a control: its codes, the form of its numbers and comments, and its functions.
//!
//! Texts with braces are [templates](crate::control::template).

use crate::motion::{CycleAbilities, PlaneAngles, PoseRule, Registers, StraightCorners};
use crate::nc::Formats;
use crate::nc::Numerals;
use crate::options::PathNorm;
use crate::program::Rotation;

use super::functions::ControlFunction;

/// M functions that every control has, and what they do.
pub(crate) const STANDARD_M: [(u16, &str); 7] = [
    (0, "program stop"),
    (1, "optional stop"),
    (2, "end of program"),
    (3, "spindle on, clockwise"),
    (4, "spindle on, counterclockwise"),
    (5, "spindle off"),
    (6, "tool change"),
];

/// Codes of a control.
#[derive(Debug, Clone)]
pub struct Spellings {
    /// Name on the command line.
    pub name: &'static str,
    /// Name in messages.
    pub title: &'static str,
    /// Digits of the numbers in its words.
    pub formats: Formats,
    /// Form of its numbers: decimal point, sign.
    pub numerals: Numerals,
    /// Length of the longest line that the control reads, bytes without the line end.
    pub line_length: usize,
    /// Every line has a number, counted from 0 and written without N.
    pub numbers_every_line: bool,
    /// Form of comments.
    pub comment: CommentStyle,
    /// Text before and after the name of an operation; `None` if the name is written as a comment.
    pub operation: Option<[&'static str; 2]>,
    /// Form of a text that the control displays while the program runs; `None` if it displays none without a stop.
    pub message: Option<MessageStyle>,
    /// Guards may be in blocks with the mark of block skip.
    pub skips_guards: bool,
    /// First lines of the program.
    pub opening: &'static [&'static str],
    /// Last block.
    pub end: &'static str,
    /// Lines after the last block.
    pub closing: &'static [&'static str],
    /// Digits of the program number; 0 if programs have no number.
    pub number_digits: usize,
    /// The program name may only hold capitals, digits and `_`.
    pub plain_name: bool,
    /// Value of `{units}` for millimetres and for inches.
    pub units: [&'static str; 2],
    /// Safety blocks of a restart point: cancel all modal functions; absolute mode, feed per minute, work offset.
    pub safety: &'static [&'static str],
    /// Blocks that end functions which the control may have.
    pub cancels: &'static [Cancel],
    /// Code of feed per minute.
    pub per_minute: &'static str,
    /// Code of feed per revolution, for threads; empty where their cycle takes the pitch.
    pub per_revolution: &'static str,
    /// M functions of the control itself beside those of every control (`STANDARD_M`), and what they do: they cannot be
    /// those of a clamp, of coolant or of tip control.
    pub own_m: &'static [(u16, &'static str)],
    /// A work offset has the machine coordinates of its zero point. Otherwise it is a preset, set by touching off or
    /// probing.
    pub offset_has_coordinates: bool,
    /// Text before the word of a work offset in the program header.
    pub offset_title: &'static str,
    /// Code of inverse-time feed, F in 1/min; `None` if the control has none.
    pub inverse_time: Option<&'static str>,
    /// Largest F of inverse-time feed.
    pub largest_inverse_time: f64,
    /// Whether all axes of a rapid arrive together.
    pub linear_rapids: LinearRapids,
    /// It takes the time of a block from its linear axes alone, however little they move.
    pub times_faint_moves: bool,
    /// Under tip control it slows down where an axis would exceed its speed.
    pub tip_control_holds_axis_speeds: bool,
    /// Path to which F applies where a rotary axis moves.
    pub path_norm: PathNorm,
    /// Number of units of F in one inch, in an inch program.
    pub feed_per_inch: f64,
    /// Code of a rapid.
    pub rapid: &'static str,
    /// Codes after the words of a rapid.
    pub rapid_end: &'static str,
    /// Code of a straight motion at feed.
    pub feed: &'static str,
    /// Codes of arcs.
    pub arcs: ArcCodes,
    /// Hole cycles; `None` if the control has none.
    pub cycles: Option<HoleCycles>,
    /// The motion code is modal.
    pub motion_modal: bool,
    /// Modal code after the axis words for a path without cutter compensation.
    pub no_compensation: &'static str,
    /// Cutter compensation left, right and off, as templates.
    pub compensation: [&'static str; 3],
    /// Required content of the radius data of the control for a path of the contour, and for one of the tool centre;
    /// printed in the program header.
    pub radius_data: [&'static str; 2],
    /// Corners that the control takes as straight on with cutter compensation.
    pub straight_corners: Option<StraightCorners>,
    /// Codes before and after the words of a rapid in machine coordinates.
    pub machine: [&'static str; 2],
    /// Machine retracts that the control has, by the names of `retract.method`; the first one where the configuration
    /// names none.
    pub retracts: &'static [MachineRetract],
    /// Tool change, and preselection of the next tool.
    pub tool_change: &'static [&'static str],
    /// What is assumed where tool 0 is called, which leaves the spindle empty; without a text the manual of the control
    /// has it.
    pub empty_spindle_note: &'static str,
    /// Text before and after the name of a tool that is called by name, in the place of `{tool}`; `None` if tools have
    /// numbers only. An equals sign before is written after an address only: `T="MILL 10"`, but `L9001("MILL 10")`.
    pub tool_name: Option<[&'static str; 2]>,
    /// Whether a name of a tool may have this byte.
    pub tool_name_byte: fn(u8) -> bool,
    /// The next tool is preselected unless the configuration sets otherwise.
    pub preselect: bool,
    /// Codes of the length offset.
    pub length: LengthCodes,
    /// Block that sets the spindle speed; `None` if the block of `spindle` holds it.
    pub speed: Option<&'static str>,
    /// Spindle on, clockwise and counter-clockwise.
    pub spindle: [&'static str; 2],
    /// Spindle stop.
    pub spindle_off: &'static str,
    /// Coolant off where it is unknown which kinds are on, for a control that has codes for neither flood nor mist:
    /// theirs are written otherwise.
    pub coolant_off: &'static str,
    /// On and off codes of flood, mist, coolant through the spindle, and air. Those of the configuration take their
    /// place, and codes for a pressure are those of the configuration alone. Each kind is switched off by its own code.
    pub coolant: [Option<[&'static str; 2]>; 4],
    /// Program stop, and optional stop.
    pub stop: [&'static str; 2],
    /// Dwell.
    pub dwell: &'static [&'static str],
    /// Longest dwell of one block, ms; a longer one is written as several blocks.
    pub longest_dwell: u32,
    /// Smoothing on, for roughing, medium and finishing; empty if only `safety` can switch it on.
    pub smoothing: [&'static [&'static str]; 3],
    /// Smoothing on with a tolerance for rotary axes; empty where it is a word of these blocks, or smoothing has none.
    pub smoothing_with_angle: [&'static [&'static str]; 3],
    /// Smoothing off.
    pub smoothing_off: &'static [&'static str],
    /// Blocks that state the tolerance of blending, where the safety blocks do; empty where blocks are not blended
    /// within one.
    pub blending: &'static [&'static str],
    /// Codes for rotary axes that rotate as their words state, and by the shortest path.
    pub rotary_path: [&'static str; 2],
    /// Text before and after the number of a rotary word that the control reaches by the shortest path: `=DC(` and `)`;
    /// `None` if the word does not say so.
    pub shortest_word: Option<[&'static str; 2]>,
    /// Settings with which the control moves a rotary axis to every angle by the shortest path.
    pub shortest_note: &'static str,
    /// The control may be in kinematics with tip control from its start on.
    pub may_begin_in_tip_control: bool,
    /// Codes of tip control; `None` if only the configuration can state them.
    pub tip: Option<TipControlCodes>,
    /// Codes of tilted planes.
    pub plane: Option<TiltedPlaneCodes>,
    /// Condition on the rotary axes of the machine where words go beyond 360°; printed in the program header.
    pub rotary_note: &'static str,
    /// Where the numbers of a set-up file are found at the control; printed with their keys by `config`.
    pub found_at: &'static [FoundAt],
    /// Examples of keys of the set-up file where the general ones are not those of the control: key, and value as TOML.
    /// `clamp` has one for each rotary axis, in order; `start` and `end` are those of a tool.
    pub examples: &'static [(&'static str, &'static str)],
    /// Keys of the set-up file that the control refuses or does not read: `config` does not print them.
    pub unused_keys: &'static [&'static str],
}

/// Block that ends a function at a restart point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Cancel {
    /// The function.
    pub of: ControlFunction,
    /// Its block.
    pub block: &'static str,
    /// It is written before the safety blocks unless the configuration lists the functions without it; otherwise after
    /// them, and only where the configuration lists it.
    pub usual: bool,
}

impl Cancel {
    pub(crate) const fn usual(of: ControlFunction, block: &'static str) -> Self {
        Self { of, block, usual: true }
    }

    pub(crate) const fn listed(of: ControlFunction, block: &'static str) -> Self {
        Self { of, block, usual: false }
    }

    /// Whether it is written, as the configuration lists the functions.
    pub(crate) fn is_due(&self, functions: Option<&[ControlFunction]>) -> bool {
        functions.map_or(self.usual, |listed| listed.contains(&self.of))
    }
}

/// Where a number of the set-up file is found at the control.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FoundAt {
    /// Key of the number, as in the file: `machine_zero`, `control.swivel_data`.
    pub key: &'static str,
    /// Page, parameter or softkey of the control.
    pub place: &'static str,
    /// Document and page; empty if it is from memory, because no public page was found.
    pub source: &'static str,
}

impl FoundAt {
    /// The comment that is printed with the key.
    #[must_use]
    pub fn comment(&self) -> String {
        let Self { place, source, .. } = self;
        match *source {
            "" => format!("At the machine: {place} (from memory: no public page was found)."),
            source => format!("At the machine: {place} ({source})."),
        }
    }
}

/// Codes of arcs and helices.
#[derive(Debug, Clone, Copy)]
pub struct ArcCodes {
    /// Codes of a clockwise and a counter-clockwise arc.
    pub senses: [&'static str; 2],
    /// Modal codes of the planes perpendicular to X, Y and Z, written before an arc; `None` if no arc is written in it.
    pub planes: [Option<&'static str>; 3],
    /// Form of the centre.
    pub centre: ArcCentre,
    /// Address of the radius, where it is written instead of the centre.
    pub radius: &'static str,
    /// Largest permitted difference between the radii at both ends of an arc, mm.
    pub radius_tolerance_mm: f64,
}

/// Hole cycles of a control.
#[derive(Debug, Clone, Copy)]
pub struct HoleCycles {
    /// Cycles that the planner may use.
    pub abilities: CycleAbilities,
    /// Form of the cycles.
    pub form: CycleForm,
}

/// Form of hole cycles.
#[derive(Debug, Clone, Copy)]
pub enum CycleForm {
    /// A code with X Y Z R and further words, modal until it is cancelled.
    Codes(CycleCodes),
    /// Blocks that define the cycle, then one block for each position.
    Definitions(CycleDefinitions),
}

/// Codes of hole cycles.
#[derive(Debug, Clone, Copy)]
pub struct CycleCodes {
    /// Return to the R plane, and return to the initial level.
    pub returns: [&'static str; 2],
    /// Drilling without and with dwell at the bottom.
    pub drill: [&'static str; 2],
    /// Pecking: full retract to the R plane after each step.
    pub peck: &'static str,
    /// Chip breaking: short retract after each step.
    pub chip_break: &'static str,
    /// Reaming (retract at feed) without and with dwell at the bottom.
    pub ream: [&'static str; 2],
    /// Tapping.
    pub thread: ThreadCodes,
    /// Boring with an oriented spindle.
    pub fine_bore: &'static str,
    /// Setting of the control that has the direction off the wall, where the program does not state it.
    pub bore_setting: &'static str,
    /// Its shift off the wall is I or J; otherwise Q, in the direction that is set in the control.
    pub bore_shift_by_axis: bool,
    /// Word of the dwell, as a template.
    pub dwell: &'static str,
    /// Code that cancels the cycle.
    pub end: &'static str,
}

/// Blocks of hole cycles, as templates.
#[derive(Debug, Clone, Copy)]
pub struct CycleDefinitions {
    /// Drilling with dwell at the bottom, which may be 0.
    pub drill: &'static [&'static str],
    /// Drilling without dwell, where that is another cycle.
    pub plain_drill: Option<&'static [&'static str]>,
    /// Pecking: full retract to the clearance level after each step.
    pub peck: &'static [&'static str],
    /// Chip breaking: short retract after each step.
    pub chip_break: &'static [&'static str],
    /// Reaming: retract at feed.
    pub ream: &'static [&'static str],
    /// Boring with an oriented spindle.
    pub fine_bore: &'static [&'static str],
    /// Tapping.
    pub thread: &'static [&'static str],
    /// Code after the words of a position that calls the cycle. The definition then survives other motions. Empty if
    /// every motion calls the cycle.
    pub call: &'static str,
    /// Block that ends the cycle, where every motion calls it.
    pub end: &'static str,
}

/// Tapping in controls whose cycles are codes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ThreadCodes {
    /// Cycle with F.
    Cycle {
        /// Codes of a right-hand and a left-hand thread.
        codes: [&'static str; 2],
        /// Block that switches rigid tapping on, as a template.
        rigid: &'static str,
    },
    /// Motion with the pitch as K, which returns to its start.
    Motion(&'static str),
}

/// Form of the centre of an arc.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ArcCentre {
    /// I J K in the block of the arc, relative to its start.
    Offsets,
    /// Block `CC` with absolute coordinates before the arc; a helix is programmed by its angle.
    Pole,
}

/// Form of comments.
#[derive(Debug, Clone, Copy)]
pub struct CommentStyle {
    /// Marks before and after the text.
    pub marks: [&'static str; 2],
    /// Largest number of bytes of text in one line.
    pub length: usize,
    /// Byte written for a byte of the text.
    pub byte: fn(u8) -> u8,
}

/// Form of a text that the control displays.
#[derive(Debug, Clone, Copy)]
pub struct MessageStyle {
    /// Marks before and after the text.
    pub marks: [&'static str; 2],
    /// Largest number of bytes of text in one line.
    pub length: usize,
}

/// Codes that call and cancel the length offset.
#[derive(Debug, Clone, Copy)]
pub struct LengthCodes {
    /// Code that calls it.
    pub code: &'static str,
    /// Block in which it is called.
    pub call: LengthCall,
    /// Code that cancels it in a block of machine coordinates.
    pub off: &'static str,
    /// A block of machine coordinates cancels it.
    pub cancelled_by_machine_coordinates: bool,
    /// Meaning of the register.
    pub registers: Registers,
    /// Address of the register in the program header.
    pub address: &'static str,
}

/// Codes of tip control.
#[derive(Debug, Clone, Copy)]
pub struct TipControlCodes {
    /// Blocks that switch it on; empty if the call of the length offset does.
    pub on: &'static [&'static str],
    /// Code instead of that of the length offset, which switches on both.
    pub with_length: Option<&'static str>,
    /// Blocks that switch it off; empty if the code that cancels the length offset does, in the block of machine
    /// coordinates after it.
    pub off: &'static [&'static str],
    /// Blocks of a restart point in addition to those of `safety`.
    pub reset: &'static [&'static str],
    /// Switching it off may cancel the work offset.
    pub may_cancel_offset: bool,
    /// Dynamic work offset on and off: the zero of the words follows the table, without tip control.
    pub dynamic_offset: Option<[&'static str; 2]>,
    /// Value of `{posture}`: the tool axis follows the rotary axes, or rotates in the plane of its start and end.
    pub posture: [&'static str; 2],
    /// Setting of the control that has the effect of `posture`, where the block may do without `{posture}`; empty where
    /// it may not.
    pub posture_setting: [&'static str; 2],
    /// Words for the tool axis as a vector; `None` if the control takes none.
    pub vectors: Option<ToolAxisWords>,
    /// A machine parameter selects the frame of its coordinates.
    pub frame_is_set: bool,
    /// Settings for a frame of the table at zero, of the table at the start, and one that does not rotate; for the
    /// header.
    pub frame_settings: [&'static str; 3],
    /// It can rotate the tool axis in the plane of its start and end.
    pub turns_in_plane: bool,
    /// Condition on the machine, printed in the program header; empty if there is none.
    pub note: &'static str,
}

/// Words for the tool axis as a vector.
#[derive(Debug, Clone, Copy)]
pub struct ToolAxisWords {
    /// Addresses of its components.
    pub words: [&'static str; 3],
    /// Code instead of that of the length offset, which switches on both.
    pub with_length: Option<&'static str>,
    /// Code of a straight motion with a vector, at rapid and at feed; `None` if the usual codes apply.
    pub motion: Option<&'static str>,
    /// Codes after the words of a rapid with a vector.
    pub rapid_end: &'static str,
    /// As [`TipControlCodes::posture`].
    pub posture: [&'static str; 2],
}

/// Codes of tilted planes.
#[derive(Debug, Clone, Copy)]
pub struct TiltedPlaneCodes {
    /// Blocks that tilt the plane.
    pub on: &'static [&'static str],
    /// The length offset is called before these blocks.
    pub length_first: bool,
    /// Blocks that cancel the plane.
    pub off: &'static [&'static str],
    /// Blocks of a restart point in addition to those of `safety`.
    pub reset: &'static [&'static str],
    /// Value of `{pose}` for the pose with the lower, and with the higher angle.
    pub poses: [&'static str; 2],
    /// Meaning of its angles.
    pub angles: PlaneAngles,
    /// Decimals of its angles; `None` if as many as rotary words have.
    pub decimals: Option<u32>,
    /// Rule by which the control selects the pose of the rotary axes.
    pub pose: PoseRule,
    /// The plane is cancelled after the machine retract, not before.
    pub cancelled_after_retract: bool,
    /// Condition on the machine, printed in the program header; empty if there is none.
    pub note: &'static str,
}

/// A machine retract of a control.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct MachineRetract {
    /// Name in the configuration: its code.
    pub name: &'static str,
    /// Form of its blocks.
    pub form: RetractForm,
}

/// Form of a machine retract.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RetractForm {
    /// To a machine coordinate, with the codes of [`Spellings::machine`].
    MachineCoordinate,
    /// To the reference position, whose machine coordinate is a setting of the control.
    ReferencePosition {
        /// Codes before the axis words, which are 0: distances to the point that the axes pass.
        code: &'static str,
        /// Block after it.
        after: &'static str,
        /// It cancels the length offset.
        cancels_length: bool,
    },
    /// Out along the tool axis to the end of the travel, which takes a tool call before it.
    AlongTool {
        /// Block.
        block: &'static str,
    },
}

impl MachineRetract {
    /// To a machine coordinate by the code of this name.
    pub const fn to_machine_coordinate(name: &'static str) -> Self {
        Self { name, form: RetractForm::MachineCoordinate }
    }

    /// To the reference position by G28, in incremental mode so that the axes pass no other point.
    pub const fn to_reference_position(cancels_length: bool) -> Self {
        let form = RetractForm::ReferencePosition { code: "G91 G28", after: "G90", cancels_length };
        Self { name: "G91 G28", form }
    }
}

/// Block in which a length offset is called.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LengthCall {
    /// Block of its own, because the call moves nothing.
    Alone,
    /// Block that moves Z, because the call may move Z.
    WithZ,
    /// The tool call, which includes it.
    WithTool,
}

/// Whether all axes of a rapid arrive together, as those of a feed motion do.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LinearRapids {
    /// Each axis moves at its own speed.
    No,
    /// Together, as the control is delivered.
    AsDelivered,
    /// Always.
    Always,
}

impl Spellings {
    /// Code that switches the spindle on in this sense of rotation.
    #[must_use]
    pub fn rotation(&self, rotation: Rotation) -> &'static str {
        match rotation {
            Rotation::Clockwise => self.spindle[0],
            Rotation::CounterClockwise => self.spindle[1],
        }
    }
}

/// Printable ASCII byte that does not close a comment in brackets.
pub(crate) fn ascii_in_brackets(byte: u8) -> u8 {
    match byte {
        b'(' => b'[',
        b')' => b']',
        b'%' => b'_',
        _ => printable(byte),
    }
}

/// Printable ASCII byte.
pub(crate) fn printable(byte: u8) -> u8 {
    match byte {
        b'\t' => b' ',
        0x20..=0x7e => byte,
        _ => b'?',
    }
}
