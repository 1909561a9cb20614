//! Golden programs with their CL data and their configuration, observed while they are checked.

use std::fs;
use std::io::Cursor;
use std::path::Path;

use pp_runtime::check::{Checked, ExecutedBlock, check_observed};
use pp_runtime::config::{Config, Mode, Operations, starting_point};
use pp_runtime::control::Control;
use pp_runtime::kinematics::Machine;

use crate::binaries::{part_and_mode, workspace};
use crate::by_name;

/// A golden program with all that its check needs.
pub struct Golden {
    /// Part, machine, control and mode.
    pub name: String,
    /// Name of the machine's binary.
    pub machine: String,
    /// The control.
    pub control: &'static dyn Control,
    /// Mode with which it was posted.
    pub mode: Mode,
    /// Configuration file with which it was posted.
    pub keys: String,
    /// Its CL data.
    pub cl: String,
    /// Its text.
    pub program: String,
}

impl Golden {
    /// Reads a golden program.
    ///
    /// # Panics
    /// If the path is not that of a golden program.
    #[must_use]
    pub fn read(path: &Path) -> Self {
        let name = path.file_stem().expect("a name").to_string_lossy().into_owned();
        let (machine, control) = name.split_once('.').expect("machine and control");
        let (folder, mode) = part_and_mode(path);
        let part = folder.file_name().expect("a name").to_string_lossy().into_owned();
        let keys = if part == "works" && machine != "lola-xoyzba" { "table" } else { &part };
        let endings = ["cls", "ncl", "apt", "aptsource"].map(|ending| folder.join(format!("{part}.{ending}")));
        let sample = workspace().join(format!("examples/cl/{part}.cls"));
        let cl = endings.into_iter().chain([sample]).find(|file| file.is_file()).expect("CL data");
        Self {
            name: format!("{part} {name} {}", mode.name()),
            machine: machine.to_owned(),
            control: by_name::control(control),
            mode,
            keys: fs::read_to_string(folder.join(format!("{keys}.toml"))).unwrap_or_default(),
            cl: fs::read_to_string(cl).expect("ASCII"),
            program: fs::read_to_string(path).expect("ASCII"),
        }
    }

    /// Configuration with which it was posted.
    ///
    /// # Panics
    /// If the configuration does not suit the machine.
    #[must_use]
    pub fn config<M: Machine>(&self) -> Config {
        let config = starting_point(self.control).read_over(&M::default(), &self.keys);
        let mut config = config.unwrap_or_else(|faults| panic!("{}: {faults:?}", self.name));
        config.motion.mode = self.mode;
        config.motion.selected = self.last_operation().map(|last| Operations::Range(1, Some(last)));
        config
    }

    /// Number of the last operation that was posted; `None` for all.
    #[must_use]
    pub fn last_operation(&self) -> Option<u64> {
        let of_works = |(mode, _): &(&str, &str)| self.name.starts_with("works") && *mode == self.mode.name();
        let (_, operations) = by_name::WORKS.into_iter().find(of_works)?;
        operations.rsplit('.').next()?.parse().ok()
    }

    /// Checks a program in its place, block by block.
    ///
    /// # Panics
    /// If it cannot be checked.
    pub fn observed<M: Machine>(&self, program: &str, mut see: impl FnMut(&ExecutedBlock<'_>)) -> Checked {
        let policy = self.config::<M>().check_policy::<M>(self.control, None).expect("it can be checked");
        let (mut cl, mut program) = (Cursor::new(&self.cl), program.as_bytes());
        check_observed(&M::default(), &policy, &mut cl, &mut program, &mut see).expect("it can be read")
    }

    /// Length of a tool, mm: of the configuration, or else of the CL data.
    #[must_use]
    pub fn length_mm(&self, config: &Config, tool: Option<u32>) -> f64 {
        let Some(tool) = tool else { return 0.0 };
        if let Some(length) = config.set_up.tools.get(&tool).and_then(|tool| tool.length_mm) {
            return length;
        }
        let numbers = self.cl.lines().find_map(|line| {
            let line = line.replace(' ', "");
            let call = line.strip_prefix("LOADTL/")?.strip_prefix(&format!("{tool},LENGTH,"))?.to_owned();
            call.trim().parse::<f64>().ok()
        });
        let inches = self.cl.replace(' ', "").contains("UNITS/IN");
        numbers.map_or(0.0, |length| if inches { 25.4 * length } else { length })
    }
}
