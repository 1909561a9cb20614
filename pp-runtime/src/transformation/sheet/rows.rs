//! Parameters of a sheet, without their layout.

use nalgebra::Vector3;

/// Key of the set-up file without which a machine coordinate has no expected value.
pub(super) const MACHINE_ZERO: &str = "machine_zero";

/// A sheet.
pub(super) struct Sheet {
    /// Control and function, for the title.
    pub(super) control: &'static str,
    /// Where the parameters are found in the control, and conditions of the sheet; one paragraph each.
    pub(super) introduction: Vec<String>,
    pub(super) sections: Vec<ParameterSection>,
    /// Which differences mean the same machine, and what to do about others; one paragraph each.
    pub(super) differences: Vec<String>,
    /// Tests at the machine, numbered from 1; one paragraph each line.
    pub(super) tests: Vec<Vec<String>>,
    /// Manuals, by the short names that the groups use.
    pub(super) sources: Vec<&'static str>,
}

/// Parameters of one function.
pub(super) struct ParameterSection {
    pub(super) title: String,
    pub(super) groups: Vec<Group>,
}

/// Parameters with one meaning.
pub(super) struct Group {
    pub(super) meaning: String,
    /// Manual and page.
    pub(super) source: &'static str,
    /// What no public manual settles, with the test that does.
    pub(super) unverified: Option<String>,
    pub(super) rows: Vec<Row>,
}

impl Group {
    pub(super) fn new(meaning: impl Into<String>, source: &'static str, rows: Vec<Row>) -> Self {
        Self { meaning: meaning.into(), source, unverified: None, rows }
    }

    /// The same group, marked.
    pub(super) fn unverified(self, reason: impl Into<String>) -> Self {
        Self { unverified: Some(reason.into()), ..self }
    }
}

/// One parameter.
pub(super) struct Row {
    /// Number in the control: `MD24500[0]`.
    pub(super) number: String,
    pub(super) name: String,
    pub(super) expected: Expected,
}

/// The value that a parameter must have.
pub(super) enum Expected {
    Millimetres(f64),
    Degrees(f64),
    /// Component of a direction.
    Component(f64),
    /// A number or a word that is no measure.
    Code(String),
    /// A machine coordinate whose key of the set-up file is not given.
    Needs(&'static str),
    /// Any value: the chain does not determine it.
    Any,
}

impl Row {
    pub(super) fn new(number: impl Into<String>, name: impl Into<String>, expected: Expected) -> Self {
        Self { number: number.into(), name: name.into(), expected }
    }

    pub(super) fn code(number: impl Into<String>, name: impl Into<String>, code: impl ToString) -> Self {
        Self::new(number, name, Expected::Code(code.to_string()))
    }
}

/// Rows of X, Y and Z. `number` is called with 0, 1 and 2.
pub(super) fn components(
    name: &str,
    number: impl Fn(usize) -> String,
    expected: impl Fn(usize) -> Expected,
) -> Vec<Row> {
    let row = |component| Row::new(number(component), format!("{name}, {}", XYZ[component]), expected(component));
    (0..3).map(row).collect()
}

/// Rows of a length in mm.
pub(super) fn lengths(name: &str, number: impl Fn(usize) -> String, vector: &Vector3<f64>) -> Vec<Row> {
    components(name, number, |component| Expected::Millimetres(vector[component]))
}

/// Rows of a length in mm, of which some components may need a key of the set-up file.
pub(super) fn known_lengths(name: &str, number: impl Fn(usize) -> String, vector: &[Option<f64>; 3]) -> Vec<Row> {
    components(name, number, |component| known(vector[component]))
}

/// A length in mm that may need `machine_zero`.
pub(super) fn known(length: Option<f64>) -> Expected {
    length.map_or(Expected::Needs(MACHINE_ZERO), Expected::Millimetres)
}

/// Rows of a direction.
pub(super) fn direction(name: &str, number: impl Fn(usize) -> String, vector: &Vector3<f64>) -> Vec<Row> {
    components(name, number, |component| Expected::Component(vector[component]))
}

/// Names of the coordinates.
pub(super) const XYZ: [char; 3] = ['X', 'Y', 'Z'];
