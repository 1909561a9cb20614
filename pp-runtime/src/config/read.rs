//! Reads a configuration file (TOML) into [`Config`] and reports all its faults.

use toml::de::DeTable;

use crate::cl::SetUpBegins;
use crate::control::{CONTROLS, Control};
use crate::diag::Diagnostics;
use crate::diag::code::config;
use crate::keys::{KeyReader, KeyScope, KeyTable, Keys};
use crate::kinematics::{AnyMachine, Machine};
use crate::options::Rapid;
use crate::program::Units;
use crate::set_up::{LengthMode, along_axes};

use super::{Config, EditOptions, starting_point};

/// Reads a file with the table `[check]` alone, and its faults.
pub(crate) fn read_edits(machine: &dyn AnyMachine, text: &str) -> Result<EditOptions, Diagnostics> {
    let mut reader = KeyReader::new(text, scope(machine));
    let (root, errors) = DeTable::parse_recoverable(text);
    for error in &errors {
        reader.report(config::SYNTAX, error.span().unwrap_or(0..0), error.message(), None);
    }
    let mut edits = EditOptions::default();
    if !reader.has_faults() {
        let mut file = KeyTable::new("", Some(root.get_ref()));
        edits.read(&mut file, &mut reader);
        file.close(&mut reader);
        reader.report_unknown(&[]);
    }
    if reader.has_faults() { Err(reader.into_faults()) } else { Ok(edits) }
}

impl Config {
    /// Reads a configuration file for the machine `M` and a control, which has number formats of its own: the
    /// configuration with which the command line posts. A job has the same control.
    ///
    /// # Errors
    /// All faults of the file, in the order of the text.
    pub fn read<M: Machine>(text: &str, control: &dyn Control) -> Result<Self, Diagnostics> {
        starting_point(control).read_over(&M::default(), text)
    }

    /// Reads a configuration file for `machine` over the values of `self`: those of a control are its
    /// [`starting_point`].
    ///
    /// # Errors
    /// All faults of the file, in the order of the text.
    pub fn read_over(mut self, machine: &dyn AnyMachine, text: &str) -> Result<Self, Diagnostics> {
        let mut reader = KeyReader::new(text, scope(machine));
        let (root, errors) = DeTable::parse_recoverable(text);
        for error in &errors {
            reader.report(config::SYNTAX, error.span().unwrap_or(0..0), error.message(), None);
        }
        if reader.has_faults() {
            return Err(reader.into_faults());
        }
        self.read_file(machine, &mut reader, &mut KeyTable::new("", Some(root.get_ref())));
        if reader.has_faults() { Err(reader.into_faults()) } else { Ok(self) }
    }

    /// Reads every key; the faults stay in the reader.
    pub(crate) fn read_file(&mut self, machine: &dyn AnyMachine, r: &mut KeyReader<'_>, file: &mut KeyTable<'_>) {
        // The unit of the file is read first: all lengths depend on it.
        let units = file.get("units", r);
        if let Some(value) = units {
            r.mark_given("units");
            if let Some(units) = r.choice(value, &Units::NAMES) {
                r.set_units(units);
            }
        }
        self.read(file, r);
        file.close(r);
        self.set_machine_zero(machine, r, file);
        self.given.extend(r.given());
        self.file_units_assumed = r.has_lengths() && units.is_none();
        let points = self.set_up.tools.iter().filter_map(|(&tool, given)| Some((tool, given.cl_point?)));
        self.cl.cl_point_of.extend(points);
        let begins = self.set_up.set_ups.iter().map(|(&number, set_up)| SetUpBegins {
            number,
            frames: set_up.frames.clone(),
            operation: set_up.begins.clone(),
        });
        self.cl.set_ups.extend(begins);
        self.check(machine, r, file);
    }

    /// The machine coordinates of the part zero from those of the reference point of the table.
    fn set_machine_zero(&mut self, machine: &dyn AnyMachine, r: &mut KeyReader<'_>, file: &mut KeyTable<'_>) {
        if self.set_up.table_zero.is_empty() || r.has_faults() {
            return;
        }
        if !self.set_up.machine_zero.is_empty() {
            let span = file.get("machine_zero", r).map_or(0..0, |value| value.span());
            let help = "`machine_zero` follows from `table_zero` and `part_origin`: give one of the two".to_owned();
            r.report(config::CONFLICT, span, "`machine_zero` beside `table_zero`", Some(help));
            return;
        }
        // Without its required dimensions nothing is posted.
        let machine = self.set_up.machine_for(machine).unwrap_or_else(|_| machine.to_boxed());
        let moved_mm = along_axes(&*machine, &self.set_up.part_origin.into());
        let letters = machine.axes().iter().map(|axis| axis.letter).zip(moved_mm);
        let of_part = letters.filter_map(|(letter, mm)| Some((letter, self.set_up.table_zero.get(&letter)? + mm)));
        self.set_up.machine_zero = of_part.collect();
    }

    /// Refuses a frame that is in two set-ups, and a work offset of two.
    fn check_set_ups(&self, r: &mut KeyReader<'_>, file: &mut KeyTable<'_>) {
        let mut frames: Vec<u32> = self.set_up.set_ups.values().flat_map(|set_up| set_up.frames.clone()).collect();
        let mut offsets: Vec<&str> = self.set_up.clampings().map(|(_, part)| part.work_offset).collect();
        frames.sort_unstable();
        offsets.sort_unstable();
        let twice = frames.windows(2).find(|pair| pair[0] == pair[1]).map(|pair| format!("frame {}", pair[0]));
        let twice = twice.or_else(|| {
            offsets.windows(2).find(|pair| pair[0] == pair[1]).map(|pair| format!("work offset {}", pair[0]))
        });
        if let Some(what) = twice.filter(|_| !r.has_faults()) {
            let span = file.get("set_ups", r).map_or(0..0, |value| value.span());
            let help = "each set-up has frames and a work offset of its own".to_owned();
            r.report(config::CONFLICT, span, format!("{what} belongs to two set-ups"), Some(help));
        }
    }

    /// Checks that concern several keys.
    fn check(&self, machine: &dyn AnyMachine, r: &mut KeyReader<'_>, file: &mut KeyTable<'_>) {
        self.check_set_ups(r, file);
        if self.motion.guards.length_guard == Some(true) && self.set_up.length_mode == LengthMode::Gauge {
            let span = file.get("length_guard", r).map_or(0..0, |value| value.span());
            let help = "in that mode no length offset is active: remove `length_guard`".to_owned();
            r.report(config::CONFLICT, span, "`length_guard = true` beside `length_mode = \"gauge\"`", Some(help));
        }
        let rapids = &self.motion.rapids;
        if rapids.rapid == Rapid::Feed && rapids.rapid_feed_mm_per_min.is_none() && !r.is_given("rapid_feed") {
            let help = "give it per minute: `rapid_feed = 10000`".to_owned();
            r.report(config::MISSING, 0..0, "rapid = \"feed\" needs `rapid_feed`", Some(help));
        }
        if !r.has_faults()
            && let Err(invalid) = self.set_up.machine_for(machine)
        {
            let span = file.get("dimensions", r).map_or(0..0, |value| value.span());
            let (text, help) = self.set_up.refusal(machine, &invalid);
            r.report(config::DIMENSIONS, span, text, Some(help));
        }
    }
}

/// Context of the keys for a machine.
pub(crate) fn scope(machine: &dyn AnyMachine) -> KeyScope {
    KeyScope::of(machine, |word| CONTROLS.iter().any(|control| control.work_offset(word).is_some()))
}
