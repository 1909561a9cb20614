//! A configuration file (TOML) to [`Config`]: every fault is reported at once.

use toml::de::DeTable;

use crate::control::CONTROLS;
use crate::diag::Diagnostic;
use crate::keys::{KeyReader, KeyScope, KeyTable, Keys};
use crate::kinematics::{AnyMachine, Machine};

use super::{Config, Rapid, UNITS};

impl Config {
    /// Reads a configuration file for the machine `M`.
    ///
    /// # Errors
    /// Every fault of the file, in its order.
    pub fn read<M: Machine>(text: &str) -> Result<Self, Vec<Diagnostic>> {
        Self::default().read_over(&M::default(), text)
    }

    /// Reads a configuration file for the machine `M` on top of what is in here, the defaults of a control.
    ///
    /// # Errors
    /// Every fault of the file, in its order.
    pub fn read_over(mut self, machine: &dyn AnyMachine, text: &str) -> Result<Self, Vec<Diagnostic>> {
        let mut reader = KeyReader::new(text, scope(machine));
        let (root, errors) = DeTable::parse_recoverable(text);
        for error in &errors {
            reader.fault(error.span().unwrap_or(0..0), error.message(), None);
        }
        if reader.has_faults() {
            return Err(reader.into_faults());
        }
        self.read_file(machine, &mut reader, &mut KeyTable::new("", Some(root.get_ref())));
        if reader.has_faults() { Err(reader.into_faults()) } else { Ok(self) }
    }

    /// Reads every key; what is wrong stays with the reader.
    pub(crate) fn read_file(&mut self, machine: &dyn AnyMachine, r: &mut KeyReader<'_>, file: &mut KeyTable<'_>) {
        // The file's unit first: it decides what every length below means.
        let units = file.get("units", r);
        if let Some(value) = units {
            r.give("units");
            if let Some(units) = r.choice(value, &UNITS) {
                r.count_in(units);
            }
        }
        self.read(file, r);
        file.close(r);
        self.given.extend(r.given());
        self.file_units_assumed = r.has_lengths() && units.is_none();
        let points = self.set_up.tools.iter().filter_map(|(&tool, given)| Some((tool, given.cl_point?)));
        self.cl.cl_point_of.extend(points);
        self.check(machine, r, file);
    }

    /// What no key says by itself.
    fn check(&self, machine: &dyn AnyMachine, r: &mut KeyReader<'_>, file: &mut KeyTable<'_>) {
        let rapids = &self.motion.rapids;
        if rapids.rapid == Rapid::Feed && rapids.rapid_feed_mm_per_min.is_none() && !r.is_given("rapid_feed") {
            let help = "give it per minute: `rapid_feed = 10000`".to_owned();
            r.fault(0..0, "rapid = \"feed\" needs `rapid_feed`", Some(help));
        }
        if !r.has_faults()
            && let Err(invalid) = self.set_up.machine_for(machine)
        {
            let span = file.get("dimensions", r).map_or(0..0, |value| value.span());
            r.fault(span, format!("{} cannot be built like this: {invalid}", machine.name()), None);
        }
    }
}

/// What keys of the machine `M` depend on.
pub(crate) fn scope(machine: &dyn AnyMachine) -> KeyScope {
    KeyScope::of(machine, |word| CONTROLS.iter().any(|control| control.work_offset(word).is_some()))
}
