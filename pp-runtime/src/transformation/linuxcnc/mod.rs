//! A kinematics module of LinuxCNC for one machine, and a simulated machine that runs it.
//!
//! The pose of LinuxCNC has the rotary axes as angles, so its inverse is
//! [`linear_axes`](crate::kinematics::Machine::linear_axes) and its forward kinematics the tip: no branch, no pole.
//! Type 0 has the joints as axes, type 1 is tip control. LinuxCNC adds work offset and tool length to the words of a
//! program in both types; the module takes them away again, so that its formulas see what the post sees: words that are
//! zero with the tip at the part zero.
//!
//! Sources: kinematics.h and control.c (`handle_kinematicsSwitch`) of LinuxCNC 2.9 and 2.10, its documentation of
//! switchable kinematics, and its single-file components `millturn` and `xyzacb_trsrn` for the order of the calls.
//!
//! ```
//! use pp_runtime::config::Config;
//! use pp_runtime::transformation::linuxcnc;
//! # pp_runtime::machine! {
//! #     /// A table that rotates about Z on a table that tilts about X.
//! #     pub struct Trunnion;
//! #     chain: C A | X Y Z;
//! # }
//!
//! let files = linuxcnc::files(&Trunnion::default(), &Config::default())?;
//! assert!(files.iter().any(|file| file.name.ends_with(".comp") && file.text.contains("kinematicsInverse")));
//! # Ok::<(), pp_runtime::transformation::NotExpressible>(())
//! ```

mod component;
mod configuration;
mod guide;

use crate::config::Config;
use crate::kinematics::{AnyMachine, Axis, AxisKind, Sign};

use super::{NotExpressible, complete, machine_identifier};

/// Order of the axes in LinuxCNC, and of the joints of the module.
const LETTERS: &str = "XYZABCUVW";

/// A file to write.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ModuleFile {
    /// Its name, without a folder.
    pub name: String,
    /// Its text.
    pub text: String,
}

/// The module of a machine and its simulated machine: component, INI and HAL file, tool table, subroutines of the
/// switch codes, and a README.
///
/// Lengths in the files are mm, angles degrees.
///
/// # Errors
/// The reason why LinuxCNC cannot express the machine.
pub fn files(machine: &dyn AnyMachine, config: &Config) -> Result<Vec<ModuleFile>, NotExpressible> {
    complete(machine)?;
    let module = Module::of(machine, config)?;
    let file = |name: String, text: String| ModuleFile { name, text };
    let mut files = vec![
        file(format!("{}.comp", module.name), component::component(&module)?),
        file(format!("{}.ini", module.stem), configuration::ini(&module)),
        file(format!("{}.hal", module.stem), configuration::hal(&module)),
        file("tool.tbl".to_owned(), configuration::tools(&module)),
    ];
    for (code, kinematics) in [("m428", 1), ("m429", 0)] {
        files.push(file(format!("{code}.ngc"), configuration::switch(code, kinematics)));
    }
    files.push(file("README.md".to_owned(), guide::readme(&module)));
    Ok(files)
}

/// A machine that LinuxCNC can express.
struct Module<'a> {
    machine: &'a dyn AnyMachine,
    config: &'a Config,
    /// `spinner_u5620`
    stem: String,
    /// Name of the component: `spinner_u5620_kins`.
    name: String,
    /// Axes in the order of the joints, with their index in the chain.
    joints: Vec<(usize, &'static Axis)>,
    /// X, Y or Z: the axis along the tool.
    length: char,
}

impl<'a> Module<'a> {
    fn of(machine: &'a dyn AnyMachine, config: &'a Config) -> Result<Self, NotExpressible> {
        let stem = machine_identifier(machine)?;
        let name = format!("{stem}_kins");
        let mut joints: Vec<(usize, &Axis)> = machine.axes().iter().enumerate().collect();
        joints.sort_by_key(|(_, axis)| LETTERS.find(axis.letter));
        for letter in "XYZ".chars() {
            let solved = joints.iter().any(|(_, axis)| axis.letter == letter && !axis.held);
            if !solved {
                return Err(NotExpressible(format!(
                    "tip control of LinuxCNC moves X, Y and Z; {} has no {letter} that is solved for",
                    machine.name()
                )));
            }
        }
        let module = Self { machine, config, stem, name, joints, length: along_the_tool(machine)? };
        module.fits_names_of_pins()?;
        Ok(module)
    }

    /// Name of the module in HAL: `spinner-u5620-kins`.
    fn pin_prefix(&self) -> String {
        self.name.replace('_', "-")
    }

    /// Name of the pin of a dimension.
    fn dimension_pin(name: &str) -> String {
        name.to_lowercase().replace('_', "-")
    }

    /// Whether X, Y and Z with all axes at zero are parallel to their coordinates.
    fn is_canonical(&self) -> bool {
        let parallel = |(component, (index, _)): (usize, &(usize, &Axis))| {
            self.machine.joint(*index).direction[component] > 1.0 - 1e-12
        };
        self.joints.iter().take(3).enumerate().all(parallel)
    }

    /// Whether the words of an axis count against ISO 841. Its coordinate does so, too: the words of a program have one
    /// direction, and one work offset, in both types of kinematics.
    fn is_reversed(&self, letter: char) -> bool {
        self.joints.iter().any(|(_, axis)| axis.letter == letter && axis.sign == Sign::Minus)
    }

    /// HAL names have at most 47 characters of ASCII, and no two pins one name.
    fn fits_names_of_pins(&self) -> Result<(), NotExpressible> {
        let own = ["part-origin-x", "part-origin-y", "part-origin-z", "zero-x", "zero-y", "zero-z", "tool-offset"];
        let mut names: Vec<String> = own.map(str::to_owned).to_vec();
        for dimension in self.machine.dimensions() {
            let pin = Self::dimension_pin(dimension.name);
            if !pin.is_ascii() || names.contains(&pin) || self.pin_prefix().len() + 1 + pin.len() > LONGEST_PIN {
                return Err(NotExpressible(format!(
                    "the dimension `{}` cannot be a pin of LinuxCNC: names of pins are ASCII, differ from the others, and have \
                     {LONGEST_PIN} characters at most with the name of the module",
                    dimension.name
                )));
            }
            names.push(pin);
        }
        if self.pin_prefix().len() + 1 + "part-origin-x".len() > LONGEST_PIN {
            return Err(NotExpressible(format!("`{}` is too long for a module of LinuxCNC", self.machine.name())));
        }
        Ok(())
    }
}

/// HAL_NAME_LEN of LinuxCNC.
const LONGEST_PIN: usize = 47;

/// The axis along the tool. G43 adds the tool length to the words of an axis, so one axis has to move the tool along
/// itself, in its positive direction.
fn along_the_tool(machine: &dyn AnyMachine) -> Result<char, NotExpressible> {
    let tool = machine.tool_axis();
    let parallel = |index: usize| {
        let joint = machine.joint(index);
        joint.sign * joint.direction.dot(&tool) > 1.0 - 1e-12
    };
    let candidate = machine.axes().iter().enumerate().find(|(index, axis)| {
        let along = match axis.letter {
            'X' => tool.x,
            'Y' => tool.y,
            'Z' => tool.z,
            _ => 0.0,
        };
        axis.kind == AxisKind::Linear && !axis.held && along > 1.0 - 1e-12 && parallel(*index)
    });
    candidate.map(|(_, axis)| axis.letter).ok_or_else(|| {
        NotExpressible(format!(
            "LinuxCNC adds the tool length to an axis along the tool; {} has no axis X, Y or Z whose positive direction is that \
             from the tip to the spindle",
            machine.name()
        ))
    })
}
