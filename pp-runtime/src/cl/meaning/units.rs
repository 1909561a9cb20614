//! Unit of length of a file: stated in it, or given by the caller.

use crate::cl::text::{ClFault, Span};
use crate::diag::code::cl;
use crate::program::{Location, Units};

/// Unit of length of a file. The first one stated holds for the whole file.
#[derive(Debug, Default)]
pub(crate) struct FileUnits {
    given: Option<Units>,
    found: Option<(Units, Location)>,
    /// The missing unit has been reported.
    missing_reported: bool,
}

impl FileUnits {
    pub(crate) fn new(given: Option<Units>) -> Self {
        FileUnits { given, ..Self::default() }
    }

    /// Unit as stated in the file, else as given.
    pub(crate) fn known(&self) -> Option<Units> {
        self.found.map(|(units, _)| units).or(self.given)
    }

    /// Whether the unit is given by the caller and not stated in the file.
    pub(crate) fn are_only_given(&self) -> bool {
        self.found.is_none() && self.given.is_some()
    }

    /// Length of one unit of the file in mm, for the number at `at`. A missing unit is reported once; then mm is
    /// assumed.
    #[inline]
    pub(crate) fn millimetres(&mut self, at: Span) -> Result<f64, ClFault> {
        match self.known() {
            Some(units) => Ok(units.in_mm()),
            None => self.assume_millimetres(at),
        }
    }

    #[cold]
    fn assume_millimetres(&mut self, at: Span) -> Result<f64, ClFault> {
        if std::mem::replace(&mut self.missing_reported, true) {
            return Ok(1.0);
        }
        Err(cl::UNITS.cl_fault(
            "units",
            at,
            "the unit of the file is unknown: no UNITS/MM, UNITS/INCH or UNIT/.. comes before this number",
            "add `--units mm` or `--units in`, the unit of the part in the CAM system",
        ))
    }

    /// UNITS, UNIT: sets the unit; refused if it contradicts the one stated or given before.
    pub(crate) fn take(&mut self, units: Units, here: Location) -> Result<(), ClFault> {
        let fault = |text: String, help: &str| Err(cl::UNITS.cl_fault("units", Span::WHOLE, text, help));
        if let Some((before, line)) = self.found {
            if before != units {
                let text = format!("this unit differs from that of line {}", line.line);
                return fault(
                    text,
                    "if this record is wrong, delete it; else post the parts in mm and in inch as two files",
                );
            }
            return Ok(());
        }
        self.found = Some((units, here));
        if self.given.is_some_and(|given| given != units) {
            let text = "the unit of the file contradicts `--units` or `cl_units`".to_string();
            return fault(text, "if the file is right, leave `--units` and `cl_units` out; if not, delete this record");
        }
        Ok(())
    }
}
