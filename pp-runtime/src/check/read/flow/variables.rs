//! Variables of a program, and how each form of programs writes them.

use std::collections::HashMap;

use super::super::facts::{Facts, LineForm};

/// Largest number of variables that a program may set.
const MOST: usize = 100_000;

/// Names of LinuxCNC that no program sets, after `#<_`: predefined named parameters, LinuxCNC 2.9 G-code overview.
const PREDEFINED: [&[u8]; 57] = [
    b"A",
    b"ABSOLUTE",
    b"ABS_A",
    b"ABS_B",
    b"ABS_C",
    b"ABS_U",
    b"ABS_V",
    b"ABS_W",
    b"ABS_X",
    b"ABS_Y",
    b"ABS_Z",
    b"ADAPTIVE_FEED",
    b"B",
    b"C",
    b"CALL_LEVEL",
    b"CCOMP",
    b"COORD_SYSTEM",
    b"CURRENT_POCKET",
    b"CURRENT_TOOL",
    b"FEED",
    b"FEED_HOLD",
    b"FEED_OVERRIDE",
    b"FLOOD",
    b"IJK_ABSOLUTE_MODE",
    b"IMPERIAL",
    b"INCREMENTAL",
    b"INVERSE_TIME",
    b"LATHE_DIAMETER_MODE",
    b"LATHE_RADIUS_MODE",
    b"LINE",
    b"METRIC",
    b"MIST",
    b"MOTION_MODE",
    b"PLANE",
    b"REMAP_LEVEL",
    b"RETRACT_OLD_Z",
    b"RETRACT_R_PLANE",
    b"RPM",
    b"SELECTED_POCKET",
    b"SELECTED_TOOL",
    b"SPEED_OVERRIDE",
    b"SPINDLE_CSS_MODE",
    b"SPINDLE_CW",
    b"SPINDLE_ON",
    b"SPINDLE_RPM_MODE",
    b"TASK",
    b"TOOL_OFFSET",
    b"U",
    b"UNITS_PER_MINUTE",
    b"UNITS_PER_REV",
    b"V",
    b"VALUE",
    b"VALUE_RETURNED",
    b"VMAJOR",
    b"VMINOR",
    b"W",
    b"X",
];

/// A value of an expression; `None`: it depends on what the program does not state.
pub(super) type Value = Option<f64>;

/// A variable by its name: `#5`, `#<DEPTH>`, `R5`, `Q5`, `QL5`; blanks and case do not count.
pub(super) type Variable = Vec<u8>;

/// Values of the variables that the program has set.
#[derive(Debug, Clone)]
pub(super) struct Variables {
    form: LineForm,
    /// Fanuc and Haas: parameters and settings say what numbers without a point and some angles are.
    by_settings: bool,
    values: HashMap<Variable, Value>,
    /// Names that a program has defined (DEF).
    defined: Vec<Variable>,
}

impl Variables {
    pub(super) fn new(facts: &Facts) -> Self {
        Self { form: facts.form, by_settings: facts.least_increments, values: HashMap::new(), defined: Vec::new() }
    }

    pub(super) fn form(&self) -> LineForm {
        self.form
    }

    /// Whether settings of the control say what numbers without a point and some angles are.
    pub(super) fn by_settings(&self) -> bool {
        self.by_settings
    }

    /// The value of a variable; `None` where the program has not set it, or to what is not known.
    pub(super) fn value(&self, variable: &Variable) -> Value {
        self.values.get(variable).copied().flatten()
    }

    /// Sets a variable; `false` where there are too many.
    pub(super) fn set(&mut self, variable: Variable, value: Value) -> bool {
        if self.values.len() >= MOST && !self.values.contains_key(&variable) {
            return false;
        }
        self.values.insert(variable, value);
        true
    }

    /// Gives the local variables of LinuxCNC, Fanuc and Haas the values of the caller of a subprogram.
    pub(super) fn restore_locals(&mut self, caller: &Self) {
        for number in 1..=33 {
            let variable = format!("#{number}").into_bytes();
            let value = caller.value(&variable);
            self.values.insert(variable, value);
        }
    }

    /// Whether a program has defined a name.
    pub(super) fn is_defined(&self, name: &Variable) -> bool {
        self.defined.contains(name)
    }

    /// Defines a name.
    pub(super) fn define(&mut self, name: Variable) {
        self.defined.push(name);
    }

    /// Whether a program may set a variable: others belong to the control, or outlast the program.
    pub(super) fn is_of_program(&self, variable: &Variable) -> bool {
        match self.form {
            LineForm::Letters => {
                let digits = variable.strip_prefix(b"#").unwrap_or_default();
                match std::str::from_utf8(digits).ok().and_then(|digits| digits.parse::<u32>().ok()) {
                    // From #500 on they outlast the program on Fanuc and Haas, and probing macros keep their
                    // calibration there. To the control belong those from #1000 on, on LinuxCNC those from #5061 on.
                    Some(number) => (1..if self.by_settings { 500 } else { 1000 }).contains(&number),
                    None => !variable.strip_prefix(b"#<_").is_some_and(|name| PREDEFINED.contains(&name)),
                }
            }
            LineForm::Keywords => true,
            // Cycles read Q200 and up, the control sets Q100 and up; QR outlasts the program.
            LineForm::Statements => match variable.strip_prefix(b"Q") {
                Some(digits) if digits.first().is_some_and(u8::is_ascii_digit) => digits.len() <= 2,
                _ => !variable.starts_with(b"QR"),
            },
        }
    }
}
