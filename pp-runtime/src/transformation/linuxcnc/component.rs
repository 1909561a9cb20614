//! The component: C around the kinematics, compiled by `halcompile`.
//!
//! Only `hal_pin_*_newf` makes pins, which LinuxCNC 2.9 and later have. Pins are read when the kinematics are switched:
//! a value that changes under tip control would be a step of the joints.

use std::fmt::Write as _;

use crate::kinematics::{AxisKind, DimensionKind};
use crate::transformation::c::{chain, functions};
use crate::transformation::{NotExpressible, math};

use super::Module;

/// Text of the component.
pub(super) fn component(module: &Module<'_>) -> Result<String, NotExpressible> {
    let core = functions(module.machine, &module.stem, &math::of_library())?;
    let (name, stem, pins) = (&module.name, &module.stem, module.pin_prefix());
    let machine = module.machine.name();
    let mut text = String::new();
    let _ = write!(
        text,
        r#"component {name} "Kinematics of the machine {machine}: joints as axes, and tip control";

description """
Switchable kinematics for one machine, generated from its declaration.
Chain from workpiece to tool: {chain}.

Type 0 has the joints as axes. In type 1, tip control, X Y Z are coordinates
of the tool tip in a frame that moves with the workpiece{backwards}; rotary axes
{held}are positions of their joints in both.

Joints are in the order {order}. All lengths are mm (LINEAR_UNITS = mm), all
angles degrees. Pins take effect when type 1 is switched on.
""";
pin out s32 unused = 0 "a component has at least one pin of its own; those of the kinematics are made by kinematicsType";
option period no;
license "GPL";
author "generated from the declaration of {machine}";
;;

#include <rtapi_math.h>
#include <kinematics.h>

{core}
/* Pins, and their values since tip control was switched on. */
static struct {{
    hal_float_t *part_origin[3];
    hal_float_t *zero[3];
    hal_float_t *tool_offset;
{fields}    hal_bit_t *is_0;
    hal_bit_t *is_1;
}} *pins;

static {stem}_machine machine;
static double zero[3];
static int switchkins_type;

#define TO_RADIANS (3.14159265358979323846 / 180.0)

static int make_pins(void)
{{
    int failed = 0;
    if (comp_id < 0 || hal_set_unready(comp_id)) return -1;
    pins = hal_malloc(sizeof(*pins));
    if (!pins) return -1;
"#,
        chain = chain(module.machine),
        held = held(module),
        backwards = backwards(module),
        order = module.joints.iter().map(|(_, axis)| axis.letter).collect::<String>(),
        fields = fields(module),
    );
    make_pins(module, &pins, &mut text);
    let _ = write!(
        text,
        r#"    failed |= hal_pin_bit_newf(HAL_OUT, &pins->is_0, comp_id, "kinstype.is-0");
    failed |= hal_pin_bit_newf(HAL_OUT, &pins->is_1, comp_id, "kinstype.is-1");
    if (failed) return -1;
{defaults}    *pins->is_0 = 1;
    *pins->is_1 = 0;
    {stem}_default(&machine);
    return hal_ready(comp_id);
}}

EXPORT_SYMBOL(kinematicsType);
EXPORT_SYMBOL(kinematicsSwitchable);
EXPORT_SYMBOL(kinematicsSwitch);
EXPORT_SYMBOL(kinematicsForward);
EXPORT_SYMBOL(kinematicsInverse);

KINEMATICS_TYPE kinematicsType(void)
{{
    static int made;
    if (!made) {{
        made = 1;
        if (make_pins()) rtapi_print_msg(RTAPI_MSG_ERR, "{name}: its pins cannot be made\n");
    }}
    return KINEMATICS_BOTH;
}}

int kinematicsSwitchable(void)
{{
    return 1;
}}

/* Reads the pins; 0, and nothing is changed, if one of them is not a number. */
static int read_pins(void)
{{
    {stem}_machine given;
    double sum = 0.0;
    int index;
    {stem}_default(&given);
    for (index = 0; index < 3; index++) {{
        given.part_origin[index] = *pins->part_origin[index];
        sum += *pins->part_origin[index] + *pins->zero[index];
    }}
    given.gauge_length = *pins->tool_offset;
{reads}    if (!isfinite(sum + given.gauge_length)) return 0;
    for (index = 0; index < 3; index++) zero[index] = *pins->zero[index];
    machine = given;
    return 1;
}}

int kinematicsSwitch(int type)
{{
    if (!pins || type < 0 || type > 1) {{
        rtapi_print_msg(RTAPI_MSG_ERR, "{name}: there are types 0 and 1 only\n");
        return -1;
    }}
    if (type == 1 && !read_pins()) {{
        rtapi_print_msg(RTAPI_MSG_ERR, "{name}: a pin is not a number\n");
        return -1;
    }}
    switchkins_type = type;
    *pins->is_0 = type == 0;
    *pins->is_1 = type == 1;
    return 0;
}}

int kinematicsForward(const double *j, struct EmcPose *pos,
                      const KINEMATICS_FORWARD_FLAGS *fflags, KINEMATICS_INVERSE_FLAGS *iflags)
{{
    (void)fflags; (void)iflags;
{forward}    return 0;
}}

int kinematicsInverse(const struct EmcPose *pos, double *j,
                      const KINEMATICS_INVERSE_FLAGS *iflags, KINEMATICS_FORWARD_FLAGS *fflags)
{{
    (void)iflags; (void)fflags;
{inverse}    return 0;
}}
"#,
        defaults = defaults(module),
        reads = reads(module),
        forward = forward(module),
        inverse = inverse(module),
    );
    Ok(text)
}

/// `and held axes `, if there are any.
fn held(module: &Module<'_>) -> &'static str {
    if module.joints.iter().any(|(_, axis)| axis.held) { "and held axes " } else { "" }
}

/// The coordinates that count backwards.
fn backwards(module: &Module<'_>) -> String {
    let letters: Vec<String> = "XYZ".chars().filter(|letter| module.is_reversed(*letter)).map(String::from).collect();
    match letters.is_empty() {
        true => String::new(),
        false => format!(",\nof which {} counts against ISO 841 as its axis does", letters.join(" and ")),
    }
}

/// Fields of the dimensions.
fn fields(module: &Module<'_>) -> String {
    module.machine.c_source().fields.iter().map(|field| format!("    hal_float_t *{field};\n")).collect()
}

fn make_pins(module: &Module<'_>, prefix: &str, text: &mut String) {
    let mut pin = |field: &str, name: &str| {
        let _ =
            writeln!(text, "    failed |= hal_pin_float_newf(HAL_IN, &pins->{field}, comp_id, \"{prefix}.{name}\");");
    };
    for (group, name) in [("part_origin", "part-origin"), ("zero", "zero")] {
        for (index, letter) in ["x", "y", "z"].into_iter().enumerate() {
            pin(&format!("{group}[{index}]"), &format!("{name}-{letter}"));
        }
    }
    pin("tool_offset", "tool-offset");
    for (field, dimension) in module.machine.c_source().fields.iter().zip(module.machine.dimensions()) {
        pin(field, &Module::dimension_pin(dimension.name));
    }
}

/// First values of the pins.
fn defaults(module: &Module<'_>) -> String {
    let mut text = String::new();
    for index in 0..3 {
        let _ = writeln!(text, "    *pins->part_origin[{index}] = *pins->zero[{index}] = 0.0;");
    }
    text.push_str("    *pins->tool_offset = 0.0;\n");
    for (index, (field, dimension)) in dimensions(module).enumerate() {
        let value = in_degrees(dimension.kind, module.machine.dimension(index));
        let _ = writeln!(text, "    *pins->{field} = {value:?};");
    }
    text
}

/// The dimensions as `read_pins` takes them.
fn reads(module: &Module<'_>) -> String {
    let mut text = String::new();
    for (field, dimension) in dimensions(module) {
        let factor = match dimension.kind {
            DimensionKind::Length => "",
            DimensionKind::Angle => " * TO_RADIANS",
        };
        let _ = writeln!(text, "    given.{field} = *pins->{field}{factor};\n    sum += given.{field};");
    }
    text
}

fn dimensions<'a>(
    module: &'a Module<'_>,
) -> impl Iterator<Item = (&'static str, &'static crate::kinematics::Dimension)> + 'a {
    module.machine.c_source().fields.iter().copied().zip(module.machine.dimensions())
}

pub(super) fn in_degrees(kind: DimensionKind, value: f64) -> f64 {
    match kind {
        DimensionKind::Length => value,
        DimensionKind::Angle => value.to_degrees(),
    }
}

/// Component of `EmcPose` for an axis.
fn of_pose(letter: char) -> String {
    match letter {
        'X' | 'Y' | 'Z' => format!("tran.{}", letter.to_ascii_lowercase()),
        _ => letter.to_ascii_lowercase().to_string(),
    }
}

/// Index of X, Y and Z.
fn component_of(letter: char) -> Option<usize> {
    "XYZ".find(letter)
}

/// `- zero[2] - machine.gauge_length`: what LinuxCNC has added to the words of an axis.
fn added(module: &Module<'_>, letter: char, sign: char) -> String {
    let mut text = String::new();
    if let Some(index) = component_of(letter) {
        let _ = write!(text, " {sign} zero[{index}]");
    }
    if letter == module.length {
        let _ = write!(text, " {sign} machine.gauge_length");
    }
    text
}

/// Statements of `kinematicsForward`.
fn forward(module: &Module<'_>) -> String {
    let mut text = String::new();
    let of_joints = |text: &mut String, skip_tip: bool| {
        for letter in super::LETTERS.chars() {
            let joint = module.joints.iter().position(|(_, axis)| axis.letter == letter);
            if skip_tip && component_of(letter).is_some() {
                continue;
            }
            let value = joint.map_or("0.0".to_owned(), |joint| format!("j[{joint}]"));
            let _ = writeln!(text, "    pos->{} = {value};", of_pose(letter));
        }
    };
    let count = module.joints.len();
    let _ = writeln!(text, "    if (switchkins_type == 1) {{\n        double axes[{count}], tip[3], axis[3];");
    for (joint, (index, axis)) in module.joints.iter().enumerate() {
        let _ = match axis.kind {
            AxisKind::Linear => {
                let added = if axis.held { String::new() } else { added(module, axis.letter, '-') };
                writeln!(text, "        axes[{index}] = j[{joint}]{added};")
            }
            AxisKind::Rotary => writeln!(text, "        axes[{index}] = j[{joint}] * TO_RADIANS;"),
        };
    }
    let _ = writeln!(text, "        {}_forward(&machine, axes, tip, axis);", module.stem);
    for (index, letter) in "XYZ".chars().enumerate() {
        let sign = if module.is_reversed(letter) { "-" } else { "" };
        let _ = writeln!(text, "        pos->{} = {sign}tip[{index}]{};", of_pose(letter), added(module, letter, '+'));
    }
    text.push_str("    } else {\n");
    for (index, letter) in "XYZ".chars().enumerate() {
        let _ = writeln!(text, "        pos->{} = j[{index}];", of_pose(letter));
    }
    text.push_str("    }\n");
    of_joints(&mut text, true);
    text
}

/// Statements of `kinematicsInverse`.
fn inverse(module: &Module<'_>) -> String {
    let mut text = String::new();
    let count = module.joints.len();
    let _ = writeln!(text, "    if (switchkins_type == 1) {{\n        double axes[{count}];\n        double tip[3];");
    for (index, letter) in "XYZ".chars().enumerate() {
        let word = format!("pos->{}{}", of_pose(letter), added(module, letter, '-'));
        let _ = match module.is_reversed(letter) {
            true => writeln!(text, "        tip[{index}] = -({word});"),
            false => writeln!(text, "        tip[{index}] = {word};"),
        };
    }
    for (index, axis) in &module.joints {
        let _ = match (axis.kind, axis.held) {
            (AxisKind::Linear, false) => writeln!(text, "        axes[{index}] = 0.0;"),
            (AxisKind::Linear, true) => writeln!(text, "        axes[{index}] = pos->{};", of_pose(axis.letter)),
            (AxisKind::Rotary, _) => {
                writeln!(text, "        axes[{index}] = pos->{} * TO_RADIANS;", of_pose(axis.letter))
            }
        };
    }
    let _ = writeln!(text, "        if (!{}_linear_axes(&machine, tip, axes)) return -1;", module.stem);
    let solved = |axis: &crate::kinematics::Axis| axis.kind == AxisKind::Linear && !axis.held;
    let sum: Vec<String> =
        module.joints.iter().filter(|(_, axis)| solved(axis)).map(|(index, _)| format!("axes[{index}]")).collect();
    let _ = writeln!(text, "        if (!isfinite({})) return -1;", sum.join(" + "));
    for (joint, (index, axis)) in module.joints.iter().enumerate().filter(|(_, (_, axis))| solved(axis)) {
        let _ = writeln!(text, "        j[{joint}] = axes[{index}]{};", added(module, axis.letter, '+'));
    }
    text.push_str("    } else {\n");
    for (joint, (_, axis)) in module.joints.iter().enumerate().filter(|(_, (_, axis))| solved(axis)) {
        let _ = writeln!(text, "        j[{joint}] = pos->{};", of_pose(axis.letter));
    }
    text.push_str("    }\n");
    for (joint, (_, axis)) in module.joints.iter().enumerate().filter(|(_, (_, axis))| !solved(axis)) {
        let _ = writeln!(text, "    j[{joint}] = pos->{};", of_pose(axis.letter));
    }
    text
}
