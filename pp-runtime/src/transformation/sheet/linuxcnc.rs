//! LinuxCNC: pins and INI lines of its own kinematics modules, where one of them is the machine.
//!
//! The modules with tip control that LinuxCNC brings for five axes and that have been compared: two tilting tables
//! (`xyzac-trt-kins`, `xyzbc-trt-kins`), two rotary tables (`xyzab_tdr_kins`) and a fork head (`5axiskins`). Their
//! directions are fixed: where an axis counts the other way, the refusal has the signs and the mirrored travel of the
//! declaration that the module can run. Any other chain gets its own module, [`crate::transformation::linuxcnc`].
//!
//! A module counts from the machine zero, and its tip has the tool length in Z, as LinuxCNC adds it to the words.

use crate::config::Config;
use crate::kinematics::{AnyMachine, AxisKind, Limits, Sign};

use super::super::NotExpressible;
use super::chain::{Arrangement, RotaryAtZero, machine_coordinates, tool_coordinate};
use super::rows::{Expected, Group, ParameterSection, Row, Sheet, known};
use super::tests_at_machine::{ControlWords, tests};

const MODEL: &str = "the modules of LinuxCNC";

const TRT: &str = "trtfuncs.c";
const TDR: &str = "xyzab_tdr_kins.comp";
const FORK: &str = "5axiskins.c";
const SWITCHABLE: &str = "switchkins.adoc; 428remap.ngc, 429remap.ngc, 430remap.ngc";

/// Distance below which two centre lines are one, mm.
const SAME_MM: f64 = 0.000_05;

/// A module of LinuxCNC.
struct KinematicsModule {
    /// As in `KINEMATICS`, and the prefix of its pins.
    name: &'static str,
    /// It takes letters of its joints, and which kinematics are type 0.
    parameters: bool,
    /// Letters of its joints.
    joints: &'static str,
    /// The rotary axis next to the bed, and the one that it carries.
    axes: [Direction; 2],
    in_head: bool,
    pins: fn(&Config, &RotaryAtZero, &RotaryAtZero) -> Vec<Group>,
}

/// A rotary axis of a module: its letter, and about which coordinate it rotates right-handed (`1.0`) or left-handed.
struct Direction {
    letter: char,
    coordinate: usize,
    hand: f64,
}

static MODULES: [KinematicsModule; 4] = [
    KinematicsModule {
        name: "xyzac-trt-kins",
        parameters: true,
        joints: "XYZAC",
        axes: [
            Direction { letter: 'A', coordinate: 0, hand: 1.0 },
            Direction { letter: 'C', coordinate: 2, hand: 1.0 },
        ],
        in_head: false,
        pins: |config, tilt, rotary| {
            tilting_table(config, tilt, rotary, TiltPins { across: "y-offset", component: 1, unused: "x-offset" })
        },
    },
    KinematicsModule {
        name: "xyzbc-trt-kins",
        parameters: true,
        joints: "XYZBC",
        axes: [
            Direction { letter: 'B', coordinate: 1, hand: 1.0 },
            Direction { letter: 'C', coordinate: 2, hand: 1.0 },
        ],
        in_head: false,
        pins: |config, tilt, rotary| {
            tilting_table(config, tilt, rotary, TiltPins { across: "x-offset", component: 0, unused: "y-offset" })
        },
    },
    KinematicsModule {
        name: "xyzab_tdr_kins",
        parameters: false,
        joints: "XYZAB",
        axes: [
            Direction { letter: 'B', coordinate: 1, hand: -1.0 },
            Direction { letter: 'A', coordinate: 0, hand: -1.0 },
        ],
        in_head: false,
        pins: two_tables,
    },
    KinematicsModule {
        name: "5axiskins",
        parameters: true,
        joints: "XYZBCW",
        axes: [
            Direction { letter: 'C', coordinate: 2, hand: 1.0 },
            Direction { letter: 'B', coordinate: 1, hand: -1.0 },
        ],
        in_head: true,
        pins: |_, _, tilt| fork_head(tilt),
    },
];

/// The sheet.
pub(super) fn sheet(machine: &dyn AnyMachine, config: &Config) -> Result<Sheet, NotExpressible> {
    let arrangement = Arrangement::of(machine, MODEL)?;
    let tool = tool_coordinate(machine, MODEL)?;
    let (first, second, in_head) = match &arrangement {
        Arrangement::Table(first, Some(second)) => (first, second, false),
        Arrangement::Head(first, Some(second)) => (first, second, true),
        Arrangement::Table(_, None) | Arrangement::Head(_, None) | Arrangement::Mixed { .. } => {
            return Err(none(machine));
        }
    };
    let fits = |module: &&KinematicsModule| {
        let along =
            |axis: &RotaryAtZero, of: &Direction| axis.letter == of.letter && axis.coordinate() == Some(of.coordinate);
        module.in_head == in_head && tool == 2 && along(first, &module.axes[0]) && along(second, &module.axes[1])
    };
    let module = MODULES.iter().find(fits).ok_or_else(|| none(machine))?;
    let reversed = [first, second].into_iter().zip(&module.axes);
    let reversed: Vec<&RotaryAtZero> =
        reversed.filter(|(axis, of)| axis.rotation[of.coordinate] * of.hand < 0.0).map(|(axis, _)| axis).collect();
    if !reversed.is_empty() {
        return Err(counts_the_other_way(machine, config, module, &reversed));
    }
    if module.in_head {
        centred(first, second)?;
    }
    Ok(Sheet {
        control: "LinuxCNC, its own module",
        introduction: vec![
            format!(
                "LinuxCNC brings a module for this machine: {}. Pins are set in a HAL file, `setp {}.NAME VALUE`, and the lines in \
                 brackets are those of the INI file. Lengths are mm: `LINEAR_UNITS = mm`.",
                module.name, module.name
            ),
            "Type 1 is tip control, type 0 has the joints as axes. Post for it with `[control] tip_control = [\"M428\", \"M429\"]`."
                .to_owned(),
        ],
        sections: vec![
            ParameterSection { title: "Kinematics and codes".to_owned(), groups: lines(module) },
            ParameterSection { title: format!("Pins of {}", module.name), groups: (module.pins)(config, first, second) },
            ParameterSection { title: "Travel".to_owned(), groups: vec![travel(machine, config, module)] },
        ],
        differences: vec![
            "Only the sum of `z-rot-point` and `z-offset` counts: where the machine has another `z-rot-point`, the difference belongs \
             in `z-offset`."
                .to_owned(),
            "Other codes for the two types: give them in `tip_control`. Subroutines of another sample configuration may select the \
             types the other way round: read them."
                .to_owned(),
            "Any other difference: the post and the control describe two machines. Measure again, and correct the pin, or the \
             dimensions and `d` of the declaration."
                .to_owned(),
        ],
        tests: tests(
            machine,
            &ControlWords { control: "linuxcnc", tip_control: "M428", plane: "the rotary axes, in type 0 and in type 1" },
        ),
        sources: vec![
            "LinuxCNC, src/emc/kinematics/trtfuncs.c: xyzacKinematicsInverse, xyzbcKinematicsInverse.",
            "LinuxCNC, src/emc/kinematics/5axiskins.c: fiveaxis_KinematicsInverse.",
            "LinuxCNC, src/hal/components/xyzab_tdr_kins.comp: TCP kinematics inverse.",
            "LinuxCNC, docs/src/motion/switchkins.adoc: types, `sparm`, `motion.switchkins-type`, limits.",
            "LinuxCNC, configs/sim/axis/vismach/5axis: table-rotary-tilting/remap_subs, bridgemill/5axisgui.hal.",
        ],
    })
}

/// No module is this machine.
fn none(machine: &dyn AnyMachine) -> NotExpressible {
    NotExpressible(format!(
        "{} is none of the machines of LinuxCNC's own modules: C on A or C on B in the table (xyzac-trt-kins, xyzbc-trt-kins), A on \
         B in the table (xyzab_tdr_kins), B on C in the head (5axiskins), each along its coordinate, and the spindle along Z. \
         `kinematics --linuxcnc` makes a module for any chain",
        machine.name()
    ))
}

/// Axes that the module counts in the opposite direction: the declaration that it can run.
fn counts_the_other_way(
    machine: &dyn AnyMachine,
    config: &Config,
    module: &KinematicsModule,
    reversed: &[&RotaryAtZero],
) -> NotExpressible {
    let bounds = config.set_up.travel(machine.axes());
    let mut letters = Vec::new();
    let (mut signs, mut travel) = (Vec::new(), Vec::new());
    for (index, axis) in machine.axes().iter().enumerate() {
        if !reversed.iter().any(|reversed| reversed.letter == axis.letter) {
            continue;
        }
        letters.push(axis.letter.to_string());
        let opposite = match axis.sign {
            Sign::Plus => '-',
            Sign::Minus => '+',
        };
        signs.push(format!("{}: {opposite}", axis.letter));
        if let Some(Limits { lower, upper }) = bounds.limits[index] {
            let [lower, upper] = [-upper, -lower].map(|end| rounded(end.to_degrees()));
            travel.push(format!("{}: {lower}..{upper}", axis.letter));
        }
    }
    let mirrored = match travel.is_empty() {
        true => String::new(),
        false => format!(", with its travel mirrored, `limits = {{ {} }}`", travel.join(", ")),
    };
    NotExpressible(format!(
        "{name} counts {letters} in the opposite direction. Reverse {letters} in the control (the sign of `SCALE` of the joint), \
         declare `signs = {{ {signs} }}`{mirrored}, and post for that; or use a module of your own, `kinematics --linuxcnc`",
        name = module.name,
        letters = letters.join(" and "),
        signs = signs.join(", "),
    ))
}

/// Without the rounding of a conversion to degrees; `-0` is `0`.
fn rounded(value: f64) -> f64 {
    (value * 1e9).round() / 1e9 + 0.0
}

/// The module has one point for both centre lines of the head, on the tool axis.
fn centred(first: &RotaryAtZero, second: &RotaryAtZero) -> Result<(), NotExpressible> {
    let off = [(first.letter, first.point.x), (first.letter, first.point.y), (second.letter, second.point.x)];
    match off.into_iter().find(|(_, distance)| distance.abs() > SAME_MM) {
        None => Ok(()),
        Some((letter, distance)) => Err(NotExpressible(format!(
            "5axiskins has both centre lines of the head on the tool axis, and that of {letter} is {distance:.4} mm from it; \
             `kinematics --linuxcnc` makes a module that has the distance"
        ))),
    }
}

/// Lines of the INI file, and the codes.
fn lines(module: &KinematicsModule) -> Vec<Group> {
    let mut kinematics = vec![Row::code("[KINS]", "KINEMATICS", module.name)];
    if module.parameters {
        kinematics.push(Row::code("[KINS]", "KINEMATICS, sparm=", "identityfirst"));
        kinematics.push(Row::code("[KINS]", "KINEMATICS, coordinates=", module.joints));
    }
    kinematics.push(Row::code("[KINS]", "JOINTS", module.joints.len()));
    kinematics.push(Row::code("[TRAJ]", "COORDINATES", module.joints));
    let identity = match module.parameters {
        true => {
            "The module, on one line. Without sparm=identityfirst it starts in tip control, and type 1 has the joints as axes."
        }
        false => "The module; it starts with the joints as axes and has no parameters.",
    };
    vec![
        Group::new(identity, SWITCHABLE, kinematics),
        Group::new(
            "Codes, as remapped in the sample configuration of the tilting tables: each calls a subroutine that sets an analog output \
             and waits for it. `net kinstype motion.analog-out-03 motion.switchkins-type` connects it.",
            SWITCHABLE,
            vec![
                Row::code("[RS274NGC]", "HAL_PIN_VARS", 1),
                Row::code("[RS274NGC]", "REMAP=M428, modalgroup=10, type", 1),
                Row::code("[RS274NGC]", "REMAP=M429, modalgroup=10, type", 0),
                Row::code("[RS274NGC]", "REMAP=M430, modalgroup=10, type", "2, not used"),
            ],
        ),
    ]
}

/// Pins of a tilting table that its axes decide.
struct TiltPins {
    /// Pin of the distance between the centre lines of both axes.
    across: &'static str,
    /// Component of that distance: 0 for X, 1 for Y.
    component: usize,
    /// The pin that the module does not use.
    unused: &'static str,
}

/// Pins of a tilting table: the centre line of C, and from there that of the axis that tilts it.
fn tilting_table(config: &Config, tilt: &RotaryAtZero, rotary: &RotaryAtZero, pins: TiltPins) -> Vec<Group> {
    let TiltPins { across, component, unused } = pins;
    let (of_tilt, of_rotary) = (machine_coordinates(config, &tilt.point), machine_coordinates(config, &rotary.point));
    let offset = tilt.point[component] - rotary.point[component];
    let letter = tilt.letter;
    vec![
        Group::new(
            "Machine coordinates of the centre line of C with the gauge point (no tool) on it.",
            TRT,
            vec![
                Row::new("x-rot-point", "centre line of C, X", known(of_rotary[0])),
                Row::new("y-rot-point", "centre line of C, Y", known(of_rotary[1])),
                Row::new("z-rot-point", "any height: see z-offset", Expected::Millimetres(0.0)),
            ],
        ),
        Group::new(
            format!("The centre line of {letter}: from that of C, and its machine coordinate Z less `z-rot-point`."),
            TRT,
            vec![
                Row::new(across, format!("from C to {letter}"), Expected::Millimetres(offset)),
                Row::new("z-offset", format!("height of {letter}"), known(of_tilt[2])),
                Row::new(unused, "not used", Expected::Any),
            ],
        ),
        Group::new(
            "Length of the tool, as LinuxCNC has it.",
            TRT,
            vec![Row::code("tool-offset", "connected to motion.tooloffset", "z")],
        ),
        Group::new(
            "Newer versions have this pin; where it is missing, the directions are those of 0.",
            TRT,
            vec![Row::code("conventional-", "directions", 0)],
        ),
    ]
}

/// Pins of two rotary tables, A on B.
fn two_tables(config: &Config, b: &RotaryAtZero, a: &RotaryAtZero) -> Vec<Group> {
    let (of_b, of_a) = (machine_coordinates(config, &b.point), machine_coordinates(config, &a.point));
    vec![
        Group::new(
            "Machine coordinates of the centre line of B, in X and Z, and of A, in Y, with the gauge point (no tool) on it.",
            TDR,
            vec![
                Row::new("x-rot-point", "centre line of B, X", known(of_b[0])),
                Row::new("y-rot-point", "centre line of A, Y", known(of_a[1])),
                Row::new("z-rot-point", "centre line of B, Z", known(of_b[2])),
            ],
        ),
        Group::new(
            "From the centre line of B to that of A; along A any point of it is right.",
            TDR,
            vec![
                Row::new("x-offset", "from B along A", Expected::Any),
                Row::new("z-offset", "from B to A", Expected::Millimetres(a.point.z - b.point.z)),
            ],
        ),
        Group::new(
            "Length of the tool, as LinuxCNC has it.",
            TDR,
            vec![Row::code("tool-offset-z", "connected to motion.tooloffset", "z")],
        ),
    ]
}

/// The pin of a fork head.
fn fork_head(tilt: &RotaryAtZero) -> Vec<Group> {
    vec![
        Group::new(
            "From the centre line of B to the gauge line. The pin is the sum of this and of the tool length: connect it to a `sum2`, one \
             input with this value, the other with `motion.tooloffset.z`.",
            FORK,
            vec![Row::new("pivot-length", "without tool", Expected::Millimetres(tilt.point.z))],
        ),
        Group::new(
            "W is a joint of the module, the quill along the tool: a posted program leaves it at 0.",
            FORK,
            vec![Row::code("joint W", "position", 0)],
        ),
    ]
}

/// Limits of the joints, in the direction in which they are declared: that of the module.
fn travel(machine: &dyn AnyMachine, config: &Config, module: &KinematicsModule) -> Group {
    let bounds = config.set_up.travel(machine.axes());
    let mut rows = Vec::new();
    for (joint, letter) in module.joints.chars().enumerate() {
        let axis = machine.axes().iter().enumerate().find(|(_, axis)| axis.letter == letter);
        let Some((index, axis)) = axis else { continue };
        let Some(Limits { lower, upper }) = bounds.limits[index] else { continue };
        for (name, end) in [("MIN_LIMIT", lower), ("MAX_LIMIT", upper)] {
            let expected = match axis.kind {
                AxisKind::Linear => Expected::Millimetres(end),
                AxisKind::Rotary => Expected::Degrees(end.to_degrees()),
            };
            rows.push(Row::new(format!("[JOINT_{joint}]"), format!("{name}, {letter}"), expected));
        }
    }
    Group::new(
        "Ends of the travel of the joints; axes without limits in declaration and configuration are not listed. [AXIS_X], [AXIS_Y] and \
         [AXIS_Z] hold the coordinates of the tip under tip control: keep them wide.",
        SWITCHABLE,
        rows,
    )
}
