//! Options of reading CL data: from the command line and from `[cl]` of the configuration.

use std::collections::BTreeMap;
use std::ops::RangeInclusive;

use serde_json::{Map, Value as Json, json};

use super::holes::CycleArg;
use super::tool_table::StatedTool;
use crate::cl::dialect::Dialect;
use crate::cl::record::{ClCycleKind, GivenMeanings, OwnStatement, not_inert};
use crate::keys::{
    Blocks, Bound, KeyKind, KeyReader, KeyScope, KeyTable, ListOf, Measure, OneLine, OneOf, Printed, TomlValue, Whole,
    YesNo, options,
};
use crate::program::{BlockPlace, Units};
use crate::set_up::ClPoint;

/// Sense in which a circle is traversed about its axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sense {
    /// Clockwise.
    Clockwise,
    /// Counter-clockwise.
    CounterClockwise,
}

/// In which frame the points after a frame are that differs from the first, where no tool axis states it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Frames {
    /// In it: they are mapped into the first.
    Main,
    /// In the first frame of the file.
    First,
}

impl Frames {
    const NAMES: [(&'static str, Self); 2] = [("main", Self::Main), ("first", Self::First)];
}

/// Where a set-up after the first begins in the CL data.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct SetUpBegins {
    /// Number of the set-up.
    pub number: u32,
    /// Numbers of its frames, in the order in which the CL data first states them.
    pub frames: Vec<u32>,
    /// Name of its first operation (TOOL PATH).
    pub operation: Option<String>,
}

/// Handling of INSERT.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Insert {
    /// Refuse it.
    #[default]
    Refuse,
    /// Write it as a comment.
    Comment,
    /// Write it as NC text.
    Write,
}

impl Insert {
    const NAMES: [(&'static str, Self); 3] =
        [("refuse", Self::Refuse), ("comment", Self::Comment), ("write", Self::Write)];
}

/// Meaning of a feed labelled MMPM or MMPR in a file in inches.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum FeedLabel {
    /// Refuse it.
    #[default]
    Refuse,
    /// The feed is in millimetres, as labelled.
    Trust,
    /// The feed is in the unit of the file, whatever its label.
    FileUnits,
}

impl FeedLabel {
    const NAMES: [(&'static str, Self); 3] =
        [("refuse", Self::Refuse), ("trust", Self::Trust), ("file-units", Self::FileUnits)];
}

options! {
    /// Reading of CL data. `explain --cl` lists the words that are read.
    pub struct ReadingOptions in "cl" {
        /// Unit of CL data that does not state its own (`--units`). Without it such data is refused.
        units: Option<Units> = None;
        /// The unit is given for this file (`--units`), so cutters that look like those of a file in inch are only
        /// warned of.
        units_confirmed: bool = false;
        /// Point of the tool that the CL data programs: "tip", or "centre" of the corner radius.
        cl_point: ClPoint = ClPoint::Tip, key("cl_point", OneOf(&ClPoint::NAMES));
        /// Programmed point by tool number, where it differs.
        cl_point_of: BTreeMap<u32, ClPoint> = BTreeMap::new();
        /// Tool that cuts before the first tool call.
        default_tool: Option<u32> = None;
        /// Whether a path with CUTCOM is that of the centre of the tool, where the configuration states it.
        compensates_centre: Option<bool> = None;
        /// What the configuration states about tools, by tool number.
        tools: BTreeMap<u32, StatedTool> = BTreeMap::new();
        /// CAM system of the CL data, if the file does not identify it or identifies it wrongly: "nx", "catia", "creo",
        /// "solidworks", "iso" or "autodesk" (posts of Fusion, Inventor CAM, HSMWorks).
        dialect: Option<Dialect> = None, key("cl.dialect", OneOf(&Dialect::NAMES), "\"nx\"");
        /// Number of columns of a line that are read, for cards with sequence numbers after them. Without it all
        /// columns are read.
        columns: Option<u32> = None, key("cl.columns", Whole(COLUMNS), "72");
        /// Words of CL data that are passed over, because they move no axis and change no state.
        inert: Vec<String> = Vec::new(), key("cl.inert", ListOf(InertWord));
        /// Statements of the shop, and the block that is written for each. Its effect on the machine is that of its
        /// codes; that of a code which the control does not have itself is declared in `[control] effects`. `at` states
        /// the place of a block after the call of a tool: "before_change", "after_change" or "at_approach"; AUXFUN and
        /// PREFUN can have it, too: `"AUXFUN/10" = { at = "after_change" }`. A block whose codes are declared "none"
        /// comes at the machine retract with the spindle off, unless `harmless = true` confirms that they move nothing.
        own_statements: Vec<OwnStatement> = Vec::new(), key("cl.words", OwnStatements);
        /// Statements at which a probe measures from where the tool is, and their blocks: macros of the probe. A rapid
        /// leads there; spindle and coolant are off; after the blocks the machine retracts, and everything is stated
        /// anew. Their effect needs no declaration.
        probes: Vec<OwnStatement> = Vec::new(), key("cycles.probe", Probes);
        /// In which frame the points after a frame are that differs from the first: "main" (in it; they are mapped into
        /// the first one of their set-up) or "first" (in the first frame of the file). Tool axes state it where its Z
        /// is tilted; a key that they contradict is an error.
        frames: Option<Frames> = None, key("cl.frames", OneOf(&Frames::NAMES), "\"main\"");
        /// Set-ups after the first.
        set_ups: Vec<SetUpBegins> = Vec::new();
        /// Sense of every CIRCLE about its axis, "cw" or "ccw". Without it the count of its numbers decides.
        circle_sense: Option<Sense> = None, key("cl.circle_sense", OneOf(&SENSES), "\"ccw\"");
        /// INSERT: "refuse", "comment" or "write" (as NC text, which is not checked).
        insert: Insert = Insert::Refuse, key("cl.insert", OneOf(&Insert::NAMES));
        /// Treat INSERT/STOP as STOP.
        insert_stop: bool = false, key("cl.insert_stop", YesNo);
        /// M codes that AUXFUN may output, and G codes that PREFUN may output. As for the blocks of `words`, the effect
        /// of a code that the control does not have itself is declared in `[control] effects`.
        auxfun: Vec<u32> = Vec::new(), key("cl.auxfun", ListOf(Whole(0..=LARGEST_CODE)));
        /// G codes that PREFUN may output.
        prefun: Vec<u32> = Vec::new(), also("cl.prefun", ListOf(Whole(0..=LARGEST_CODE)));
        /// Feed labelled in mm in a file in inch: "refuse", "trust" (it is in mm) or "file-units" (it is in inch).
        feed_label: FeedLabel = FeedLabel::Refuse, key("cl.feed_label", OneOf(&FeedLabel::NAMES));
        /// FROM: "reference" (start point, no motion) or "move" (a rapid to this point, as first approach).
        from_move: bool = false, key("cl.from", OneOf(&FROMS));
        /// TRANS of Creo: "refuse", or "add" (its numbers are added to all points after it, as in other CL data).
        trans_adds: bool = false, key("cl.trans", OneOf(&TRANS));
        /// Feed until the first FEDRAT, per minute. Without it CL data with a feed motion before is refused.
        default_feed_mm_per_min: Option<f64> = None, key("defaults.feed", Measure::length(Bound::Positive), "500.0");
        /// Meaning of the numbers after the tool number of LOADTL that have no word before them, in order: "offset"
        /// (length offset register), "length" (gauge length), "ignored".
        tool_args: Vec<ToolArg> = Vec::new(), key("cl.loadtl", ToolNumbers);
        /// Meaning of the numbers of a CYCLE that have no word before them, in order: depth, clearance, return, step,
        /// dwell, pitch, feed.
        cycle_args: Vec<(ClCycleKind, Vec<CycleArg>)> = Vec::new(), key("cl.cycle", CycleNumbers);
    }
}

impl ReadingOptions {
    /// What the user says about words that are not read.
    pub(crate) fn given_meanings(&self) -> GivenMeanings<'_> {
        GivenMeanings { inert: &self.inert, own: &self.own_statements, probes: &self.probes }
    }

    /// Whether the CL data programs the tip of every tool.
    #[inline]
    pub(crate) fn always_tip(&self) -> bool {
        self.cl_point == ClPoint::Tip && self.cl_point_of.is_empty()
    }
}

const SENSES: [(&str, Sense); 2] = [("cw", Sense::Clockwise), ("ccw", Sense::CounterClockwise)];
const TRANS: [(&str, bool); 2] = [("refuse", false), ("add", true)];
const FROMS: [(&str, bool); 2] = [("reference", false), ("move", true)];

/// Permitted values of `cl.columns`.
const COLUMNS: RangeInclusive<u32> = 8..=4096;

/// Largest number of an M or G code.
const LARGEST_CODE: u32 = 9999;

/// Kind of key: a word of CL data that may be declared inert.
#[derive(Debug, Clone, Copy)]
struct InertWord;

impl KeyKind for InertWord {
    type Value = String;

    fn read(&self, r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<String> {
        let name = r.line(value)?;
        if let Some(why) = not_inert(&name) {
            r.fault(value.span(), why, None);
            return None;
        }
        Some(name.to_ascii_uppercase())
    }

    fn print(&self, value: &String) -> String {
        OneLine.print(value)
    }

    fn schema(&self, scope: &KeyScope) -> Json {
        OneLine.schema(scope)
    }
}

/// Reads a table of statements, each of them once. `read` makes one of its key and its value; `None` where the value
/// has a fault, which is told.
fn statements<'v>(
    r: &mut KeyReader<'_>,
    value: TomlValue<'v>,
    read: impl Fn(&mut KeyReader<'_>, &str, TomlValue<'v>) -> Option<Result<OwnStatement, String>>,
) -> Vec<OwnStatement> {
    let mut found: Vec<OwnStatement> = Vec::new();
    for (key, span, value) in r.entries(value) {
        match read(r, key, value) {
            Some(Ok(own)) if found.iter().any(|known| known.statement() == own.statement()) => {
                r.fault(span, format!("`{key}` is stated twice"), None);
            }
            Some(Ok(own)) => found.push(own),
            Some(Err(why)) => r.fault(span, why, None),
            None => {}
        }
    }
    found
}

/// Kind of key: statements of the shop with their blocks: `"CHUCK/OPEN" = "M68"`, or with a place:
/// `"CHUCK/OPEN" = { blocks = "M68", at = "before_change" }`, `"AUXFUN/10" = { at = "at_approach" }`.
#[derive(Debug, Clone, Copy)]
struct OwnStatements;

impl KeyKind for OwnStatements {
    type Value = Vec<OwnStatement>;

    fn read(&self, r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<Self::Value> {
        Some(statements(r, value, |r, key, value| match value.get_ref().as_table() {
            Some(_) => placed_statement(r, key, value),
            None => Some(OwnStatement::new(key, &r.line(value)?)),
        }))
    }

    fn print(&self, _value: &Self::Value) -> String {
        "{}".to_owned()
    }

    fn schema(&self, scope: &KeyScope) -> Json {
        let lines = json!({ "anyOf": [OneLine.schema(scope), ListOf(OneLine).schema(scope)] });
        let places: Vec<&str> = BlockPlace::NAMES.iter().map(|(name, _)| *name).collect();
        let placed = json!({
            "type": "object",
            "additionalProperties": false,
            "properties": { "blocks": lines, "at": { "enum": places }, "harmless": { "type": "boolean" } },
        });
        json!({ "type": "object", "additionalProperties": { "anyOf": [OneLine.schema(scope), placed] } })
    }

    fn printed(&self, _scope: &KeyScope) -> Option<Printed> {
        let example = "{ \"CHUCK/OPEN\" = { blocks = \"M68\", at = \"before_change\" } }";
        Some(Printed::Example(example.to_owned()))
    }
}

/// A statement with `blocks`, `at` and `harmless`.
fn placed_statement(r: &mut KeyReader<'_>, key: &str, value: TomlValue<'_>) -> Option<Result<OwnStatement, String>> {
    let mut table = KeyTable::of(r, format!("cl.words.{key}"), Some(value));
    let blocks = match table.get("blocks", r) {
        Some(lines) if lines.get_ref().is_array() => Blocks(OneLine).read(r, lines)?,
        Some(line) => vec![r.line(line)?],
        None => Vec::new(),
    };
    let place = match table.get("at", r) {
        Some(place) => r.choice(place, &BlockPlace::NAMES)?,
        None => BlockPlace::InOrder,
    };
    let harmless = match table.get("harmless", r) {
        Some(harmless) => r.boolean(harmless)?,
        None => false,
    };
    table.close(r);
    Some(OwnStatement::placed(key, &blocks, place, harmless))
}

/// Kind of key: statements at which a probe measures, with their blocks: `"PROBE/BORE,20" = ["G65 P9814 D20."]`.
#[derive(Debug, Clone, Copy)]
struct Probes;

impl KeyKind for Probes {
    type Value = Vec<OwnStatement>;

    fn read(&self, r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<Self::Value> {
        let blocks = Blocks(OneLine);
        Some(statements(r, value, |r, key, value| Some(OwnStatement::probing(key, &blocks.read(r, value)?))))
    }

    fn print(&self, _value: &Self::Value) -> String {
        "{}".to_owned()
    }

    fn schema(&self, scope: &KeyScope) -> Json {
        json!({ "type": "object", "additionalProperties": Blocks(OneLine).schema(scope) })
    }

    fn printed(&self, _scope: &KeyScope) -> Option<Printed> {
        Some(Printed::Example("{ \"PROBE/BORE,20\" = [\"G65 P9810 Z-5. F3000.\", \"G65 P9814 D20.\"] }".to_owned()))
    }
}

/// Kind of key: meaning of the numbers without a word, by kind of CYCLE: `TAP.args = ["depth", "pitch"]`.
#[derive(Debug, Clone, Copy)]
struct CycleNumbers;

impl KeyKind for CycleNumbers {
    type Value = Vec<(ClCycleKind, Vec<CycleArg>)>;

    fn read(&self, r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<Self::Value> {
        let mut read = Vec::new();
        for (key, span, value) in r.entries(value) {
            let Some((_, kind)) = ClCycleKind::WORDS.iter().find(|(word, _)| *word == key) else {
                r.fault(span, format!("`{key}` is not a kind of CYCLE"), None);
                continue;
            };
            let mut table = KeyTable::of(r, format!("cl.cycle.{key}"), Some(value));
            if let Some(args) = table.get("args", r) {
                read.extend(ListOf(OneOf(&CycleArg::NAMES)).read(r, args).map(|args| (*kind, args)));
            }
            table.close(r);
        }
        Some(read)
    }

    fn print(&self, _value: &Self::Value) -> String {
        "{}".to_owned()
    }

    fn schema(&self, scope: &KeyScope) -> Json {
        let args = ListOf(OneOf(&CycleArg::NAMES)).schema(scope);
        let kind = json!({ "type": "object", "properties": { "args": args }, "additionalProperties": false });
        let kinds: Map<String, Json> =
            ClCycleKind::WORDS.iter().map(|(word, _)| ((*word).to_owned(), kind.clone())).collect();
        json!({ "type": "object", "properties": kinds, "additionalProperties": false })
    }

    fn printed(&self, _scope: &KeyScope) -> Option<Printed> {
        Some(Printed::Example("{ TAP = { args = [\"depth\", \"pitch\"] } }".to_owned()))
    }
}

/// Kind of key: meaning of the numbers without a word of LOADTL: `args = ["offset"]`.
#[derive(Debug, Clone, Copy)]
struct ToolNumbers;

impl KeyKind for ToolNumbers {
    type Value = Vec<ToolArg>;

    fn read(&self, r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<Self::Value> {
        let mut table = KeyTable::of(r, "cl.loadtl", Some(value));
        let args = table.get("args", r).and_then(|args| ListOf(OneOf(&ToolArg::NAMES)).read(r, args));
        table.close(r);
        args
    }

    fn print(&self, _value: &Self::Value) -> String {
        "{}".to_owned()
    }

    fn schema(&self, scope: &KeyScope) -> Json {
        let args = ListOf(OneOf(&ToolArg::NAMES)).schema(scope);
        json!({ "type": "object", "properties": { "args": args }, "additionalProperties": false })
    }

    fn printed(&self, _scope: &KeyScope) -> Option<Printed> {
        Some(Printed::Example("{ args = [\"offset\"] }".to_owned()))
    }
}

/// Meaning of a number after the tool number (`[cl.loadtl] args`).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ToolArg {
    /// Length offset register (H).
    Offset,
    /// Gauge length.
    Length,
    /// It has no effect.
    Ignored,
}

impl ToolArg {
    /// Names as in configuration files.
    pub const NAMES: [(&'static str, ToolArg); 3] =
        [("offset", ToolArg::Offset), ("length", ToolArg::Length), ("ignored", ToolArg::Ignored)];
}
