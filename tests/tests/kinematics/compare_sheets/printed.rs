//! A sheet, read back from its text.

use pp_runtime::nalgebra::Vector3;

/// Longest line of a sheet.
pub(crate) const WIDTH: usize = 96;

/// A row of a sheet.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Row {
    pub(crate) number: String,
    pub(crate) name: String,
    pub(crate) expected: String,
    pub(crate) unverified: bool,
}

impl Row {
    /// Its number.
    pub(crate) fn value(&self) -> f64 {
        self.expected.parse().unwrap_or_else(|_| panic!("{self:?} is a number"))
    }
}

/// The rows of a sheet.
#[derive(Debug)]
pub(crate) struct Printed {
    pub(crate) rows: Vec<Row>,
}

impl Printed {
    /// Reads the lines that end with a blank to be filled in.
    pub(crate) fn read(text: &str) -> Self {
        let rows =
            text.lines().filter(|line| line.ends_with("________________") && !line.starts_with(char::is_alphabetic));
        let row = |line: &str| {
            let field =
                |from: usize, to: usize| line.chars().skip(from).take(to - from).collect::<String>().trim().to_owned();
            Row {
                number: field(2, 17),
                name: field(18, 51),
                expected: field(52, 72),
                unverified: line.starts_with('?'),
            }
        };
        Self { rows: rows.map(row).collect() }
    }

    /// The row of a number in the control.
    pub(crate) fn row(&self, number: &str) -> &Row {
        let mut found = self.rows.iter().filter(|row| row.number == number);
        let row = found.next().unwrap_or_else(|| panic!("no row {number} in {:#?}", self.rows));
        assert!(found.next().is_none(), "{number} is in the sheet twice");
        row
    }

    /// The value of a number in the control.
    pub(crate) fn value(&self, number: &str) -> f64 {
        self.row(number).value()
    }

    /// Three values in a row.
    pub(crate) fn vector(&self, number: impl Fn(usize) -> String) -> Vector3<f64> {
        Vector3::from_fn(|component, _| self.value(&number(component)))
    }
}
