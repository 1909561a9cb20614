//! What a job may set about its control, and what of a job the control reads.

use std::collections::BTreeMap;

use serde_json::{Map, Value as Json, json};

use crate::keys::{
    AxisSet, Bound, KeyKind, KeyReader, KeyScope, ListOf, Measure, OneLine, OneOf, PerAxis, Printed, TomlValue, Truth,
    Whole, list, nearest, options,
};
use crate::motion::{self, PathNorm, Policy};
use crate::nc::Formats;
use crate::set_up::SetUp;

use super::template::{self, BadTemplate, Field, OF_PROGRAM, OF_TOOL};

/// What a job asks of a control: everything that encoding and the fit of the two may read.
#[derive(Debug, Clone, Copy)]
pub struct Demands<'a> {
    /// Machine, part and shop.
    pub set_up: &'a SetUp,
    /// How motion is planned.
    pub motion: &'a motion::MotionOptions,
    /// What differs from the table of the control.
    pub options: &'a Options,
    /// Digits of the words.
    pub formats: &'a Formats,
}

impl<'a> Demands<'a> {
    /// What of it the planner reads.
    #[must_use]
    pub fn policy(self) -> Policy<'a> {
        Policy { set_up: self.set_up, options: self.motion, formats: self.formats }
    }
}

options! {
    /// Where the control differs from what is usual for it. Blocks hold fields in braces: {name}, {number}, {units},
    /// {work_offset}, {path_tolerance}; those of a tool change {tool}, {next}, {offset} and {speed} besides. A word
    /// whose field has no value is left out, a block with {next} where no tool follows, too.
    pub struct Options in "control" {
        /// How far the control may leave the programmed path where it blends blocks.
        path_tolerance: f64 = 0.01, key("path_tolerance", Measure::length(Bound::Positive).unless(nearly_zero));
        /// Number and name of the program. Without them 1, and the name in the CL data.
        program_number: Option<u32> = None, key("control.program_number", Whole(1..=99_999), "1234");
        /// Name of the program.
        program_name: Option<String> = None, also("control.program_name", OneLine, "\"BRACKET\"");
        /// The program begins with the name of its file, as a Siemens archive wants it: `%_N_NAME_MPF`.
        file_header: bool = false, key("control.file_header", Truth);
        /// Blocks of a restart point, and of a tool change.
        safety: Option<Vec<String>> = None,
            key("control.safety", ListOf(TemplateBlock(OF_PROGRAM)),
                "[\"{units} G17 G40 G49 G80 G90 G94 {work_offset}\"]");
        /// Blocks of a tool change.
        tool_change: Option<Vec<String>> = None,
            also("control.tool_change", ListOf(TemplateBlock(OF_TOOL)), "[\"T{tool} M6\", \"T{next}\"]");
        /// Call the tool after the next up while the next one cuts.
        preselect: Option<bool> = None, key("control.preselect", Truth, "true");
        /// Codes of a kind of coolant: on, off.
        ///
        /// In the order flood, mist, coolant through the spindle, air.
        coolant: [Option<[String; 2]>; 4] = [const { None }; 4], key("control.coolant", CoolantCodes);
        /// Smoothing by the control within `path_tolerance`: "none", "rough", "medium" or "finish".
        smoothing: Smoothing = Smoothing::None, key("control.smoothing", OneOf(&Smoothing::NAMES));
        /// Largest turn of the tool axis while the control smooths.
        smoothing_angle: Option<f64> = None, also("control.smoothing_angle", Measure::angle(Bound::Positive), "0.1");
        /// What F counts along where a rotary axis moves: "xyz", "xyz+deg", "g93_min" (1/min) or "g93_s" (1/s).
        path_norm: Option<PathNorm> = None, key("control.path_norm", OneOf(&PATH_NORMS), "\"xyz+deg\"");
        /// Whole numbers end with a point.
        point: Option<bool> = None, key("control.point", Truth, "true");
        /// Codes that switch tip control on and off, in mode "tcp".
        tip_control: Option<[String; 2]> = None, key("control.tip_control", OnAndOff, "[\"M428\", \"M429\"]");
        /// Name of the swivel data of CYCLE800.
        swivel_data: Option<String> = None, key("control.swivel_data", OneLine, "\"TABLE\"");
        /// All axes of a rapid arrive together under tip control (Fanuc: parameter 1401#1): the check of limits asks
        /// for it.
        linear_rapids: Option<bool> = None, key("control.linear_rapids", Truth, "true");
        /// Every word in every block.
        every_word: bool = false, key("control.every_word", Truth);
        /// Names of axes where they are not their letters.
        axes: BTreeMap<char, String> = BTreeMap::new(), key("control.axes", AXIS_NAMES);
        /// Blocks around the program.
        program: ProgramBlocks = ProgramBlocks::default(), keys();
    }
}

options! {
    /// Blocks after the header and before the end code, with fields as in `[control]`.
    pub struct ProgramBlocks in "program" {
        /// Blocks after the header.
        start: Vec<String> = Vec::new(), also("program.start", ListOf(TemplateBlock(OF_PROGRAM)));
        /// Blocks before the end code.
        end: Vec<String> = Vec::new(), also("program.end", ListOf(TemplateBlock(OF_PROGRAM)));
        /// Machining times as comments at the end.
        times: bool = false, key("program.times", Truth);
        /// The figures of the check of the program as a comment at the end, or that it was not checked.
        checked: bool = false, key("program.checked", Truth);
        /// Step of the block numbers. Without it there are none.
        line_numbers: Option<u32> = None, key("program.line_numbers", Whole(1..=1000), "10");
    }
}

/// How much the control smooths the path.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Smoothing {
    /// Not by the program.
    #[default]
    None,
    /// Speed first.
    Rough,
    /// Between the two.
    Medium,
    /// Surface first.
    Finish,
}

impl Smoothing {
    const NAMES: [(&'static str, Self); 4] =
        [("none", Self::None), ("rough", Self::Rough), ("medium", Self::Medium), ("finish", Self::Finish)];
}

const PATH_NORMS: [(&str, PathNorm); 4] = [
    ("xyz", PathNorm::Xyz),
    ("xyz+deg", PathNorm::XyzDegrees),
    ("g93_min", PathNorm::G93Minutes),
    ("g93_s", PathNorm::G93Seconds),
];

/// Kinds of coolant in the order of their codes.
const COOLANTS: [&str; 4] = ["flood", "mist", "through", "air"];

/// Smallest path tolerance, mm: in inches it is still no zero with six decimals.
const SMALLEST_PATH_TOLERANCE: f64 = 0.0001;

fn nearly_zero(tolerance: f64) -> Option<String> {
    (tolerance < SMALLEST_PATH_TOLERANCE).then(|| {
        format!(
            "less than {SMALLEST_PATH_TOLERANCE} mm could be written as 0, which lets the control leave the path \
             without bound"
        )
    })
}

/// Names of axes on the control.
const AXIS_NAMES: PerAxis<String> = PerAxis {
    axes: AxisSet::All,
    section: false,
    read: |r, entry| r.line(entry.value),
    printed: |scope, axis| {
        let last = scope.axes.last().is_some_and(|last| last.letter == axis.letter);
        last.then(|| Printed::Example(format!("\"{}1\"", axis.letter)))
    },
    schema: || json!({ "type": "string" }),
};

/// Two codes: on, off.
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
            r.fault(value.span(), "two codes are needed here: [on, off]", None);
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

/// `through = ["M88", "M89"]`.
#[derive(Debug, Clone, Copy)]
struct CoolantCodes;

impl KeyKind for CoolantCodes {
    type Value = [Option<[String; 2]>; 4];

    fn read(&self, r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<Self::Value> {
        let mut codes = [const { None }; 4];
        for (key, span, value) in r.entries(value) {
            let Some(kind) = COOLANTS.iter().position(|kind| *kind == key) else {
                let help = match nearest(key, COOLANTS.into_iter()) {
                    Some(near) => format!("did you mean `{near}`?"),
                    None => format!("the kinds are {}", list(COOLANTS.into_iter(), '`')),
                };
                r.fault(span, format!("`{key}` is no kind of coolant"), Some(help));
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
            COOLANTS.iter().map(|kind| ((*kind).to_owned(), OnAndOff.schema(scope))).collect();
        json!({ "type": "object", "properties": kinds, "additionalProperties": false })
    }

    fn printed(&self, _scope: &KeyScope) -> Option<Printed> {
        Some(Printed::Example("{ through = [\"M88\", \"M89\"] }".to_owned()))
    }
}

/// A block with named fields: those that may be in it.
#[derive(Debug, Clone, Copy)]
struct TemplateBlock(&'static [Field]);

impl KeyKind for TemplateBlock {
    type Value = String;

    fn read(&self, r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<String> {
        let block = r.line(value)?;
        if let Err(bad) = template::check(&block, self.0) {
            let names = self.0.iter().map(|field| field.name());
            let help = match &bad {
                BadTemplate::Brace => "fields stand in braces: {name}".to_owned(),
                BadTemplate::Field(name) => match nearest(name, names.clone()) {
                    Some(near) => format!("did you mean `{{{near}}}`?"),
                    None => format!("the fields here are {}", list(names, '`')),
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
