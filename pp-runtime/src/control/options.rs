//! Settings of a job for its control, and the data of a job that the control reads.

use std::collections::BTreeMap;

use serde_json::{Map, Value as Json, json};

use crate::keys::{
    AxisSet, Blocks, Bound, KeyKind, KeyReader, KeyScope, ListOf, Measure, OneLine, OneOf, PerAxis, Printed, TomlValue,
    Whole, YesNo, list, nearest, options,
};
use crate::kinematics::AxisKind;
use crate::motion::Policy;
use crate::nc::Formats;
use crate::options::{MotionOptions, PathNorm, Smoothing, nearly_zero};
use crate::program::Coolant;
use crate::set_up::SetUp;

use super::dialects::{ControlFunction, LineEffect, MachineRetract, RetractForm, Spellings};
use super::mill_turn::{MillTurn, MillTurnKey, ToolSpindle};
use super::state_values::States;
use super::template::{self, BadTemplate, Field, OF_PROGRAM, OF_TOOL};

/// The data of a job that a control may read: for the encoder, and to find settings that it does not support.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Demands<'a> {
    /// Set-up of machine, part and tools.
    pub set_up: &'a SetUp,
    /// Settings of motion planning.
    pub motion: &'a MotionOptions,
    /// Settings that replace codes and values of the control.
    pub options: &'a ControlOptions,
    /// Digits of the numbers in words.
    pub formats: &'a Formats,
}

impl<'a> Demands<'a> {
    /// The part that the planner reads.
    #[must_use]
    pub(crate) fn policy(self) -> Policy<'a> {
        Policy { set_up: self.set_up, options: self.motion, formats: self.formats }
    }
}

options! {
    /// Settings of this control that differ from its standard codes. Blocks may hold fields in braces: {name},
    /// {number}, {units}, {work_offset}, {path_tolerance}; in a tool change also {tool} (where tools are called by name
    /// the name, with its quotation marks), {tool_number}, {next}, {offset}, {speed} and {radius_delta} (Heidenhain,
    /// with `compensation.path = "centre"`).
    /// A word whose field has no value is left out; a block with {next} is left out where no tool follows. A cycle of
    /// several lines (Heidenhain) has each line as an element, ending in `~` where the next one continues it.
    pub struct ControlOptions in "control" {
        /// Largest deviation from the programmed path where the control blends blocks.
        path_tolerance_mm: f64 = 0.01, key("path_tolerance", Measure::length(Bound::Positive).unless(nearly_zero));
        /// Control for which this file is: the default of `--control`. With another `--control` it is refused; a file
        /// that serves several controls leaves the key out.
        name: Option<String> = None, key("control.name", OneLine, "\"haas\"");
        /// Program number. Without this key it is 1.
        program_number: Option<u32> = None, key("control.program_number", Whole(1..=99_999), "1234");
        /// Program name. Without this key it is the name in the CL data.
        program_name: Option<String> = None, key("control.program_name", OneLine, "\"BRACKET\"");
        /// The file begins with the program name, as a Siemens archive needs it: `%_N_NAME_MPF`.
        file_header: bool = false, key("control.file_header", YesNo);
        /// Safety blocks of a restart point, instead of those of the control.
        safety: Option<Vec<String>> = None,
            key("control.safety", Blocks(TemplateBlock(OF_PROGRAM)),
                "[\"{units} G17 G40 G49 G80 G90 G94 {work_offset}\"]");
        /// Blocks of a tool change, instead of those of the control.
        tool_change: Option<Vec<String>> = None,
            key("control.tool_change", Blocks(TemplateBlock(OF_TOOL)), "[\"T{tool} M6\", \"T{next}\"]");
        /// Call tools by the names in `[tools.N] name`, as they are in the tool table (Siemens, Heidenhain). Not with
        /// `length_guard` where that reads the length by the number of the tool.
        tool_names: bool = false, key("control.tool_names", YesNo);
        /// Preselect the next tool at each tool change.
        preselect: Option<bool> = None, key("control.preselect", YesNo, "true");
        /// On and off code of each kind of coolant: flood, mist, through (the spindle), air; and of its pressures
        /// (COOLNT/THRU,HIGH): through_low, through_medium, through_high. They take the place of those of the control,
        /// and the check refuses the codes that they replace. Each kind is switched off by its own code; where it is
        /// unknown which are on, flood and mist are switched off.
        coolant: [Option<[String; 2]>; 7] = [const { None }; 7], key("control.coolant", CoolantCodes);
        /// Smoothing by the control within `path_tolerance`: "none", "rough", "medium" or "finish".
        smoothing: Smoothing = Smoothing::None, key("control.smoothing", OneOf(&Smoothing::NAMES));
        /// Numbers of the levels "rough", "medium" and "finish" where they are a word of their own (Fanuc: R of G05.1
        /// Q1, 1 for speed to 10 for accuracy, an option of the control). Without it the word is left out, and all
        /// levels are one.
        smoothing_levels: Option<[u32; 3]> = None,
            key("control.smoothing_levels", ThreeLevels, "[1, 5, 10]");
        /// Largest deviation of the tool axis while the control smooths; in degrees in the file (Heidenhain: TA of
        /// cycle 32).
        smoothing_angle_rad: Option<f64> = None,
            key("control.smoothing_angle", Measure::angle(Bound::Positive), "0.1");
        /// Meaning of F where a rotary axis moves: speed along "xyz" or "xyz+deg", or inverse time in "g93_min" (1/min)
        /// or "g93_s" (1/s).
        path_norm: Option<PathNorm> = None, key("control.path_norm", OneOf(&PATH_NORMS), "\"xyz+deg\"");
        /// Whole numbers end with a decimal point.
        point: Option<bool> = None, key("control.point", YesNo, "true");
        /// Functions of the control that are installed: "tip_control", "planes", "dynamic_offset" (Haas: G254). All are
        /// options at many makers. Without this key it has those three, as far as it can have them. A program ends a
        /// function at each restart point where it is installed. Those of "scaling", "rotation", "polar",
        /// "setting_error" and "smoothing" are ended where this list has them only: their codes raise an alarm on a
        /// control without them, and the header names the condition.
        functions: Option<Vec<ControlFunction>> = None,
            key("control.functions", ListOf(OneOf(&ControlFunction::NAMES)), "[\"tip_control\", \"planes\"]");
        /// Codes that switch tip control on and off in mode "tcp", or "none" where the control has no kinematics with
        /// tip control. LinuxCNC may begin in such kinematics: with codes a program switches them off at each restart
        /// point, and without this key "none" is assumed.
        tip_control: Option<TipControlSwitch> = None, key("control.tip_control", TipControlKey, "[\"M428\", \"M429\"]");
        /// Frame of the words in mode "plane" (Haas): "dynamic_offset" (G254: along the axes of the machine, from a
        /// zero that follows the table; not with a rotary axis in the head, nor with `rotary_offset`), or
        /// "tilted_plane" (G268). Without this key it is G254 where `functions` and the machine have it.
        plane_by: Option<PlaneBy> = None, key("control.plane_by", OneOf(&PlaneBy::NAMES), "\"tilted_plane\"");
        /// On a turning machine, at each restart point: `radius`, the block after which words of X are radii, or
        /// "parameter" where they are by a setting; `modes`, blocks after which C is an axis and the tool is driven;
        /// and `spindle` of the tool, as three codes (clockwise, counter-clockwise, off), as its number (Siemens: 3 for
        /// `S3=` and `M3=`), or "master" for that of M3. Words of X are never diameters. Threads by a cycle need
        /// "master": the cycle runs that spindle.
        mill_turn: Option<MillTurn> = None, key("control.mill_turn", MillTurnKey);
        /// Name of the swivel data record of CYCLE800.
        swivel_data: Option<String> = None, key("control.swivel_data", OneLine, "\"TABLE\"");
        /// Write the word of `tool_posture` where tip control is switched on (Fanuc: P of G43.4, an option of the
        /// control). Without it a setting of the control decides (Fanuc: parameter 19604#0), which must be the same.
        posture_word: bool = true, key("control.posture_word", YesNo);
        /// Rapids are interpolated: all axes arrive together (Fanuc: parameter 1401#1; Siemens: RTLION). Links and the
        /// check of travel limits and clearance geometry use this. Without it as the control is delivered: together on
        /// LinuxCNC, Siemens and Heidenhain.
        linear_rapids: Option<bool> = None, key("control.linear_rapids", YesNo, "true");
        /// Blocks that measure the tool in the spindle, for tools with `measured = true`: after the tool change, with
        /// the machine retracted before and after them, and before the length guard; where the axes are then:
        /// `tool_position`. Fields as in a tool change. After them the modes of the safety line, work offset, position,
        /// spindle, coolant and length are stated anew, as after those of `check_tool`.
        measure_tool: Vec<String> = Vec::new(),
            key("cycles.measure_tool", Blocks(TemplateBlock(OF_TOOL)), "[\"G65 P9023 A12. T{tool}\"]");
        /// Blocks that look for breakage of the tool in the spindle, for tools with `checked = true`: with the machine
        /// retracted and the spindle off, before the next tool and at the end of the program.
        check_tool: Vec<String> = Vec::new(),
            key("cycles.check_tool", Blocks(TemplateBlock(OF_TOOL)), "[\"G65 P9023 A22. T{tool}\"]");
        /// Write every word in every block, modal words included.
        every_word: bool = false, key("control.every_word", YesNo);
        /// Effect of lines and words that the check does not know, by their text: lines of `[program]`, `safety`,
        /// `tool_change` and INSERT, and codes in them. "none", "coolant", "spindle", "stop", "position lost", "state
        /// lost", "measures", or "tool change" for a line with the field {tool}: that tool is in the spindle
        /// afterwards, as after the tool change of the control (`"G65 P9001 T{tool}" = "tool change"`). A code with
        /// words of its own is declared as its whole line: `"M68 E0 Q1" = "none"`. The check refuses them without it.
        /// After "state lost" a safety line must state every mode again; on Heidenhain write `M137` (F per minute)
        /// after such a line.
        effects: BTreeMap<String, LineEffect> = BTreeMap::new(), key("control.effects", LineEffects);
        /// Settings and parameters of the control on which the meaning of words depends, by the control's own names:
        /// Haas "setting 22" (retract of G73, gap of G83) and "setting 52" (rise of G83 above R), Fanuc "5114" (retract
        /// of G73) and "5115" (gap of G83). Lengths. Cycles that read one which is not given are named with the value
        /// that they need.
        states: BTreeMap<String, f64> = BTreeMap::new(), key("control.states", States);
        /// Axis names that differ from the axis letters.
        axes: BTreeMap<char, String> = BTreeMap::new(), key("control.axes", AxisNames);
        /// Machine retract: by a code of the control, "G53" or "G91 G28" (LinuxCNC, Fanuc, Haas), "SUPA" (Siemens),
        /// "M91" or "M140" (Heidenhain: along the tool axis to the end of the travel), or by blocks of your own, as a
        /// list (without M140). Without it the first of these. The reference position of G28 and the end of the travel
        /// must be `position`. Out of tip control that ends with the length offset (Fanuc, Haas) the retract is always
        /// that of G53.
        retract_method: Option<RetractMethod> = None, key("retract.method", RetractMethods, "\"G91 G28\"");
        /// Blocks around the program.
        program: ProgramBlocks = ProgramBlocks::default(), keys();
    }
}

options! {
    /// Blocks and comments at the start and the end of the program and of its operations. Blocks may hold fields as in
    /// `[control]`.
    pub struct ProgramBlocks in "program" {
        /// Blocks at the start of the program, after the comments and before the first restart point (N1): before any
        /// code, retract and tool change, with the machine where the operator left it. A warm-up needs the tool away
        /// from the part: call a program of the shop that retracts first, with the effect "state lost" (on Heidenhain
        /// with `M137` after it), or position the machine by hand. It ends with the spindle off.
        start: Vec<String> = Vec::new(), key("program.start", Blocks(TemplateBlock(OF_PROGRAM)));
        /// Blocks before the end code. Positions of the axes at the end: `park`. Their effect is not "state lost":
        /// spindle and coolant are off where the program ends, as far as is known.
        end: Vec<String> = Vec::new(), key("program.end", Blocks(TemplateBlock(OF_PROGRAM)));
        /// Blocks at the start of each operation: after the tool change, before length offset, spindle and approach.
        /// Fields as in a tool change. The machine retracts after them, and position, spindle, coolant and length are
        /// stated anew; they must leave G90, plane and work offset as they are ("state lost" is for `start`).
        operation_start: Vec<String> = Vec::new(),
            key("program.operation_start", Blocks(TemplateBlock(OF_TOOL)), "[\"M31\"]");
        /// Blocks at the end of each operation, at the machine retract with the coolant off. Fields as in a tool
        /// change.
        operation_end: Vec<String> = Vec::new(),
            key("program.operation_end", Blocks(TemplateBlock(OF_TOOL)), "[\"M33\"]");
        /// Write machining times as comments at the end.
        times: bool = false, key("program.times", YesNo);
        /// Write the result of the check as a comment at the end, or that the program was not checked.
        checked: bool = false, key("program.checked", YesNo);
        /// Blocks with a number: every block, in steps of this number (10), the "restarts" (the first block of each
        /// operation), the "tool_changes" (that of an operation that changes the tool), or "none".
        line_numbers: BlockNumbers = BlockNumbers::Restarts, key("program.line_numbers", NumberedBlocks);
        /// Texts of PPRINT: a "comment", or "display" where the control displays a text while the program runs
        /// (LinuxCNC, Siemens).
        messages: Messages = Messages::Comment, key("program.messages", OneOf(&Messages::NAMES));
        /// Comments at the start: "full", or "short" (set-up and tools, without axis directions, reading of the CL data
        /// and assumptions, which the summary of posting still has).
        header: ProgramHeader = ProgramHeader::Full, key("program.header", OneOf(&ProgramHeader::NAMES));
    }
}

/// The machine retract as the configuration selects it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum RetractMethod {
    /// One of the control, by its name.
    Named(String),
    /// These blocks.
    Blocks(Vec<String>),
}

/// Blocks with a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BlockNumbers {
    /// Every block, in this step.
    Step(u32),
    /// The first block of each restart point.
    Restarts,
    /// The first block of each tool change.
    ToolChanges,
    /// None.
    None,
}

impl BlockNumbers {
    const NAMES: [(&'static str, Self); 3] =
        [("restarts", Self::Restarts), ("tool_changes", Self::ToolChanges), ("none", Self::None)];

    /// Whether every block has a number.
    pub(crate) fn are_on_every_block(self) -> bool {
        matches!(self, Self::Step(_))
    }
}

/// Texts for the operator.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Messages {
    /// Comments in the program.
    Comment,
    /// Texts that the control displays.
    Display,
}

impl Messages {
    const NAMES: [(&'static str, Self); 2] = [("comment", Self::Comment), ("display", Self::Display)];
}

/// Comments at the start of a program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ProgramHeader {
    /// All.
    Full,
    /// Set-up and tools.
    Short,
}

impl ProgramHeader {
    const NAMES: [(&'static str, Self); 2] = [("full", Self::Full), ("short", Self::Short)];
}

/// Frame of the words in mode "plane", on a control that has both.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PlaneBy {
    /// Along the axes of the machine, from a zero that has moved with the table.
    DynamicOffset,
    /// In the tilted plane.
    TiltedPlane,
}

impl PlaneBy {
    const NAMES: [(&'static str, Self); 2] =
        [("dynamic_offset", Self::DynamicOffset), ("tilted_plane", Self::TiltedPlane)];
}

impl ControlOptions {
    /// Blocks that take the place of the machine retract of the control.
    pub(crate) fn own_retract(&self) -> Option<&Vec<String>> {
        match &self.retract_method {
            Some(RetractMethod::Blocks(blocks)) => Some(blocks),
            Some(RetractMethod::Named(_)) | None => None,
        }
    }

    /// Form of the machine retract on a control; `None` for blocks of the configuration, and for a name that the
    /// control does not have.
    pub(crate) fn retract_form(&self, codes: &Spellings) -> Option<RetractForm> {
        let form = |retract: &MachineRetract| retract.form;
        match &self.retract_method {
            None => codes.retracts.first().map(form),
            Some(RetractMethod::Named(name)) => codes.retracts.iter().find(|retract| retract.name == name).map(form),
            Some(RetractMethod::Blocks(_)) => None,
        }
    }

    /// Codes that switch tip control on and off.
    pub(crate) fn tip_control_codes(&self) -> Option<&[String; 2]> {
        match &self.tip_control {
            Some(TipControlSwitch::Codes(codes)) => Some(codes),
            Some(TipControlSwitch::None) | None => None,
        }
    }

    /// Blocks that a turning machine needs at each restart point.
    pub(crate) fn mill_turn_blocks(&self) -> impl Iterator<Item = &String> {
        self.mill_turn.iter().flat_map(MillTurn::blocks)
    }

    /// Spindle of the tool, where it is not that of M3.
    pub(crate) fn tool_spindle(&self) -> Option<&ToolSpindle> {
        self.mill_turn.as_ref().map(|mill_turn| &mill_turn.spindle).filter(|spindle| **spindle != ToolSpindle::Master)
    }

    /// Whether a function of the control is installed, as far as is known.
    pub(crate) fn has(&self, function: ControlFunction) -> bool {
        self.functions.as_ref().is_none_or(|installed| installed.contains(&function))
    }
}

const PATH_NORMS: [(&str, PathNorm); 4] = [
    ("xyz", PathNorm::Xyz),
    ("xyz+deg", PathNorm::XyzDegrees),
    ("g93_min", PathNorm::G93Minutes),
    ("g93_s", PathNorm::G93Seconds),
];

/// Kind of key: names of axes on the control. An axis without one has its letter as its name.
#[derive(Debug, Clone, Copy)]
struct AxisNames;

/// The names as a table, each on its own.
const AXIS_NAMES: PerAxis<String> = PerAxis {
    axes: AxisSet::All,
    section: false,
    read: |r, entry| r.line(entry.value),
    printed: |scope, axis| {
        let rotaries = || scope.axes.iter().filter(|axis| axis.kind == AxisKind::Rotary);
        let last = rotaries().next_back().or(scope.axes.last()).is_some_and(|last| last.letter == axis.letter);
        // A letter that no axis of the machine has.
        let other = "CBAWVU".chars().find(|letter| scope.axes.iter().all(|axis| axis.letter != *letter))?;
        last.then(|| Printed::Example(format!("\"{other}\"")))
    },
    schema: || json!({ "type": "string" }),
};

/// Value of a key: numbers of the three levels of smoothing.
#[derive(Debug, Clone, Copy)]
struct ThreeLevels;

impl KeyKind for ThreeLevels {
    type Value = [u32; 3];

    fn read(&self, r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<[u32; 3]> {
        let levels = ListOf(Whole(1..=10)).read(r, value)?;
        let levels = <[u32; 3]>::try_from(levels).ok();
        if levels.is_none() {
            r.fault(value.span(), "expected three numbers: [rough, medium, finish]", None);
        }
        levels
    }

    fn print(&self, levels: &[u32; 3]) -> String {
        format!("{levels:?}")
    }

    fn schema(&self, scope: &KeyScope) -> Json {
        let mut schema = ListOf(Whole(1..=10)).schema(scope);
        schema["minItems"] = json!(3);
        schema["maxItems"] = json!(3);
        schema
    }
}

impl KeyKind for AxisNames {
    type Value = BTreeMap<char, String>;

    fn read(&self, r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<BTreeMap<char, String>> {
        let names = AXIS_NAMES.read(r, value)?;
        let mut axis_of = BTreeMap::new();
        for axis in r.scope().axes {
            let name = names.get(&axis.letter).cloned().unwrap_or_else(|| axis.letter.to_string());
            if let Some(other) = axis_of.insert(name.clone(), axis.letter) {
                let text = format!("{other} and {} would both be named `{name}` on the control", axis.letter);
                r.conflict(value.span(), text, None);
            }
        }
        Some(names)
    }

    fn print(&self, value: &BTreeMap<char, String>) -> String {
        AXIS_NAMES.print(value)
    }

    fn schema(&self, scope: &KeyScope) -> Json {
        AXIS_NAMES.schema(scope)
    }

    fn printed(&self, scope: &KeyScope) -> Option<Printed> {
        AXIS_NAMES.printed(scope)
    }

    fn counts(&self) -> bool {
        AXIS_NAMES.counts()
    }
}

/// Value of a key: two codes, on and off.
#[derive(Debug, Clone, Copy)]
struct OnAndOff;

impl KeyKind for OnAndOff {
    type Value = [String; 2];

    fn read(&self, r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<[String; 2]> {
        let codes = r.list(value).unwrap_or_default();
        let codes: Vec<String> = codes.into_iter().filter_map(|code| r.line(code)).collect();
        let codes =
            <[String; 2]>::try_from(codes).ok().filter(|codes| codes.iter().all(|code| !code.trim().is_empty()));
        if codes.is_none() {
            r.fault(value.span(), "expected two codes: [on, off]", None);
        }
        codes
    }

    fn print(&self, [on, off]: &[String; 2]) -> String {
        format!("[\"{on}\", \"{off}\"]")
    }

    fn schema(&self, _scope: &KeyScope) -> Json {
        json!({ "type": "array", "items": { "type": "string" }, "minItems": 2, "maxItems": 2 })
    }
}

/// How tip control is switched, where the codes are those of the machine.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum TipControlSwitch {
    /// There is none: linear words are positions of the axes at any time.
    None,
    /// Codes that switch it on and off.
    Codes([String; 2]),
}

/// Value of a key: two codes, or "none".
#[derive(Debug, Clone, Copy)]
struct TipControlKey;

impl KeyKind for TipControlKey {
    type Value = TipControlSwitch;

    fn read(&self, r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<TipControlSwitch> {
        match value.get_ref().as_str() {
            Some("none") => Some(TipControlSwitch::None),
            Some("always") => {
                r.fault(
                    value.span(),
                    "in kinematics that are always in tip control G53 and G28 lead the tip, not the axes of the machine: no block \
                     retracts them",
                    Some("load kinematics that codes switch (LinuxCNC 2.9), and give the codes, or trivial kinematics with \"none\"".to_owned()),
                );
                None
            }
            Some(_) => {
                r.fault(value.span(), "expected two codes, [on, off], or \"none\"", None);
                None
            }
            None => OnAndOff.read(r, value).map(TipControlSwitch::Codes),
        }
    }

    fn print(&self, switch: &TipControlSwitch) -> String {
        match switch {
            TipControlSwitch::None => "\"none\"".to_owned(),
            TipControlSwitch::Codes(codes) => OnAndOff.print(codes),
        }
    }

    fn schema(&self, scope: &KeyScope) -> Json {
        json!({ "anyOf": [{ "const": "none" }, OnAndOff.schema(scope)] })
    }
}

/// Value of a key: on and off code of each kind of coolant, `{ through = ["M88", "M89"] }`.
#[derive(Debug, Clone, Copy)]
struct CoolantCodes;

impl KeyKind for CoolantCodes {
    type Value = [Option<[String; 2]>; 7];

    fn read(&self, r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<Self::Value> {
        let mut codes = [const { None }; 7];
        for (key, span, value) in r.entries(value) {
            let Some(kind) = Coolant::NAMES.iter().position(|kind| *kind == key) else {
                let help = match nearest(key, Coolant::NAMES.into_iter()) {
                    Some(near) => format!("did you mean `{near}`?"),
                    None => format!("kinds of coolant: {}", list(Coolant::NAMES.into_iter(), '`')),
                };
                r.unknown_key(span, format!("unknown kind of coolant `{key}`"), Some(help));
                continue;
            };
            codes[kind] = OnAndOff.read(r, value);
        }
        Some(codes)
    }

    fn print(&self, _value: &Self::Value) -> String {
        "{}".to_owned()
    }

    fn schema(&self, scope: &KeyScope) -> Json {
        let kinds: Map<String, Json> =
            Coolant::NAMES.iter().map(|kind| ((*kind).to_owned(), OnAndOff.schema(scope))).collect();
        json!({ "type": "object", "properties": kinds, "additionalProperties": false })
    }

    fn printed(&self, _scope: &KeyScope) -> Option<Printed> {
        Some(Printed::Example("{ through = [\"M88\", \"M89\"] }".to_owned()))
    }
}

/// Value of a key: effects of lines and words, `{ "M77" = "none" }`.
#[derive(Debug, Clone, Copy)]
struct LineEffects;

impl KeyKind for LineEffects {
    type Value = BTreeMap<String, LineEffect>;

    fn read(&self, r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<Self::Value> {
        let mut effects = BTreeMap::new();
        for (key, span, value) in r.entries(value) {
            let text = key.trim();
            if text.is_empty() || text.chars().any(char::is_control) {
                r.fault(span, "expected the text of a line or a word", None);
                continue;
            }
            if let Some(effect) = r.choice(value, &LineEffect::NAMES) {
                if let Some(reason) = effect.refusal(text) {
                    let help = "write the line as it is in the configuration: \"G65 P9001 T{tool}\" = \"tool change\"";
                    r.fault(span, reason, Some(help.to_owned()));
                }
                effects.insert(text.to_owned(), effect);
            }
        }
        Some(effects)
    }

    fn print(&self, _value: &Self::Value) -> String {
        "{}".to_owned()
    }

    fn schema(&self, scope: &KeyScope) -> Json {
        json!({ "type": "object", "additionalProperties": OneOf(&LineEffect::NAMES).schema(scope) })
    }

    fn printed(&self, _scope: &KeyScope) -> Option<Printed> {
        Some(Printed::Example("{ \"M77\" = \"none\" }".to_owned()))
    }
}

/// Value of a key: the step of block numbers, or the blocks that have one.
#[derive(Debug, Clone, Copy)]
struct NumberedBlocks;

impl NumberedBlocks {
    const STEP: Whole = Whole(1..=1000);
    const NAMES: OneOf<BlockNumbers> = OneOf(&BlockNumbers::NAMES);
}

impl KeyKind for NumberedBlocks {
    type Value = BlockNumbers;

    fn read(&self, r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<BlockNumbers> {
        match value.get_ref().is_str() {
            true => Self::NAMES.read(r, value),
            false => Self::STEP.read(r, value).map(BlockNumbers::Step),
        }
    }

    fn print(&self, value: &BlockNumbers) -> String {
        match value {
            BlockNumbers::Step(step) => Self::STEP.print(step),
            BlockNumbers::Restarts | BlockNumbers::ToolChanges | BlockNumbers::None => Self::NAMES.print(value),
        }
    }

    fn schema(&self, scope: &KeyScope) -> Json {
        json!({ "anyOf": [Self::STEP.schema(scope), Self::NAMES.schema(scope)] })
    }
}

/// Value of a key: the name of a machine retract, or its blocks.
#[derive(Debug, Clone, Copy)]
struct RetractMethods;

impl KeyKind for RetractMethods {
    type Value = RetractMethod;

    fn read(&self, r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<RetractMethod> {
        if value.get_ref().as_array().is_none() {
            return r.line(value).map(|name| RetractMethod::Named(name.trim().to_owned()));
        }
        let blocks = Blocks(TemplateBlock(OF_PROGRAM)).read(r, value)?;
        if blocks.is_empty() {
            r.fault(value.span(), "a retract needs a block", None);
        }
        Some(RetractMethod::Blocks(blocks))
    }

    fn print(&self, value: &RetractMethod) -> String {
        match value {
            RetractMethod::Named(name) => OneLine.print(name),
            RetractMethod::Blocks(blocks) => Blocks(OneLine).print(blocks),
        }
    }

    fn schema(&self, scope: &KeyScope) -> Json {
        json!({ "anyOf": [OneLine.schema(scope), Blocks(OneLine).schema(scope)] })
    }
}

/// Value of a key: a block with the fields that are permitted in it.
#[derive(Debug, Clone, Copy)]
struct TemplateBlock(&'static [Field]);

impl KeyKind for TemplateBlock {
    type Value = String;

    fn read(&self, r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<String> {
        let block = r.line(value)?;
        if let Err(bad) = template::check(&block, self.0) {
            let names = self.0.iter().map(|field| field.name());
            let help = match &bad {
                BadTemplate::Brace => "write a field as its name between braces: {name}".to_owned(),
                BadTemplate::Field(name) => match nearest(name, names.clone()) {
                    Some(near) => format!("did you mean `{{{near}}}`?"),
                    None => format!("fields of this block: {}", list(names, '`')),
                },
            };
            r.fault(value.span(), bad.to_string(), Some(help));
        }
        Some(block)
    }

    fn print(&self, value: &String) -> String {
        OneLine.print(value)
    }

    fn schema(&self, scope: &KeyScope) -> Json {
        OneLine.schema(scope)
    }
}
