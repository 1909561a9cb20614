//! The README of the module.

use std::fmt::Write as _;

use super::{LETTERS, Module};
use crate::transformation::c::chain;

/// Text of the README.
pub(super) fn readme(module: &Module<'_>) -> String {
    let (machine, name, stem, pins) = (module.machine.name(), &module.name, &module.stem, module.pin_prefix());
    let mut text = format!(
        "# {machine} on LinuxCNC\n\n\
         Kinematics generated from the declaration of the machine, chain from workpiece to tool: {chain}. Tip control on LinuxCNC\n\
         needs them in the control. Change the declaration and generate again rather than these files.\n\n\
         | file | |\n|---|---|\n\
         | `{name}.comp` | the kinematics module, C for `halcompile` |\n\
         | `{stem}.ini`, `{stem}.hal` | a simulated machine to try it, and the lines to copy into your own configuration |\n\
         | `m428.ngc`, `m429.ngc` | tip control on and off, as remapped codes |\n\
         | `tool.tbl` | tools of `[tools]` in the set-up file; lengths that only the CL data has are not in it: enter these |\n\n\
         ## Try it\n\n\
         ```sh\n\
         sudo apt install linuxcnc-uspace linuxcnc-uspace-dev\n\
         sudo halcompile --install {name}.comp\n\
         linuxcnc {stem}.ini\n\
         ```\n\n\
         Home, switch tip control on with `M428` (MDI), and rotate an axis: the coordinates of the tip stay, the linear axes move.\n\
         `M429` switches it off. Programs for this configuration are posted with\n\n\
         ```toml\n\
         [control]\n\
         tip_control = [\"M428\", \"M429\"]\n\
         ```\n\n\
         ## At the machine\n\n\
         1. Copy the lines `KINEMATICS`, `JOINTS`, `COORDINATES`, `REMAP`, `SUBROUTINE_PATH` and `HAL_PIN_VARS` of the INI file, and\n\
         the part from \"Kinematics\" on of the HAL file. Analog output 3 selects the kinematics: it must be free.\n\
         2. Joints are in the order {order}, one joint for each axis. `LINEAR_UNITS` must be mm.\n\
         3. The machine starts with the joints as axes (type 0); the modules of LinuxCNC itself start in tip control unless they get\n\
         `sparm=identityfirst`. Tip control is type 1. `kinstype.is-0` and `kinstype.is-1` show which is in force.\n\
         4. Set the pins:\n\n\
         | pin of `{pins}` | value |\n|---|---|\n\
         | `zero-x` `-y` `-z` | `machine_zero` of the set-up file: machine coordinates of the zero position, without tool; that is the \
         work offset of the part |\n\
         | `part-origin-x` `-y` `-z` | `part_origin` of the set-up file: the part zero from the reference point of the table |\n\
         | `tool-offset` | length of the tool, connected to `motion.tooloffset.{length}` |\n",
        chain = chain(module.machine),
        order = module.joints.iter().map(|(_, axis)| axis.letter).collect::<String>(),
        length = module.length.to_ascii_lowercase(),
    );
    for (index, dimension) in module.machine.dimensions().iter().enumerate() {
        let value = super::component::in_degrees(dimension.kind, module.machine.dimension(index));
        let _ = writeln!(
            text,
            "| `{}` | dimension `{}`, now {value} |",
            Module::dimension_pin(dimension.name),
            dimension.name
        );
    }
    let _ = write!(
        text,
        "\n\
         Only the difference of the first two counts: where the axes are as declared, another work offset than `zero` needs no other\n\
         pins{other}.\n\
         Pins are read when tip control is switched on: a change takes effect at the next `M428`. Switch tip control off before a\n\
         tool change, as posted programs do.\n\
         5. The limits `[AXIS_X]`, `[AXIS_Y]` and `[AXIS_Z]` count coordinates of the tip under tip control; keep them wide. The\n\
         limits of the joints hold in both.\n\
         6. LinuxCNC does not hold the speeds of the joints under tip control (its issue 97: following errors). Give `[speeds]` in\n\
         the set-up file: posted programs then hold them in every block that rotates, and `MAX_LINEAR_VELOCITY` of `[TRAJ]` holds\n\
         them in rapids along X, Y and Z. It must not exceed the speed of the slowest of the three joints.\n\
         7. A declared sign or dimension that is wrong is wrong here as well. Go through the jog sheet (`explain`) first; then switch\n\
         tip control on over a fixed point, rotate each axis, and see the tip stay there.\n\n\
         The letters of LinuxCNC are {LETTERS}; what the chain does not have is zero. Licence of the component: GPL, as LinuxCNC\n\
         requires of its modules.\n",
        other = if module.is_canonical() {
            ""
        } else {
            ". This machine has a linear axis that is not parallel to its coordinate: there the work offset of a part must be `zero`, \
             in both kinematics"
        },
    );
    text
}
