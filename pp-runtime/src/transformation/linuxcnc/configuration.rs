//! The simulated machine: INI and HAL file, tool table, and the subroutines of the switch codes.

use std::fmt::Write as _;

use crate::kinematics::{AxisKind, DimensionKind, Limits};

use super::Module;

/// Speed of an axis of which none is known, mm/s and deg/s.
const SPEED: [f64; 2] = [100.0, 30.0];
/// Acceleration of every axis, mm/s² and deg/s².
const ACCELERATION: [f64; 2] = [500.0, 500.0];
/// Limit of the coordinates X, Y and Z, mm.
const COORDINATES: f64 = 10_000.0;
/// Analog output that selects the kinematics, as in the documentation of switchable kinematics.
const OUTPUT: u32 = 3;

/// The INI file.
pub(super) fn ini(module: &Module<'_>) -> String {
    let letters: Vec<String> = module.joints.iter().map(|(_, axis)| axis.letter.to_string()).collect();
    let mut ini = format!(
        "# {machine}, simulated. The README next to this file has the steps to try it and to set it up at the machine.\n\
         [EMC]\nVERSION = 1.1\nMACHINE = {machine}\nDEBUG = 0\n\n\
         [DISPLAY]\nDISPLAY = axis\nGEOMETRY = XYZ\nPOSITION_OFFSET = RELATIVE\nPOSITION_FEEDBACK = ACTUAL\n\
         MAX_FEED_OVERRIDE = 1.2\nDEFAULT_LINEAR_VELOCITY = {speed}\nDEFAULT_ANGULAR_VELOCITY = {rotary_speed}\n\n\
         [RS274NGC]\nPARAMETER_FILE = {stem}.var\nSUBROUTINE_PATH = .\nHAL_PIN_VARS = 1\n\
         # M428 switches tip control on, M429 off.\n\
         REMAP = M428 modalgroup=10 ngc=m428\nREMAP = M429 modalgroup=10 ngc=m429\n\n\
         [TASK]\nTASK = milltask\nCYCLE_TIME = 0.001\n\n\
         [EMCMOT]\nEMCMOT = motmod\nCOMM_TIMEOUT = 1.0\nSERVO_PERIOD = 1000000\n\n\
         [EMCIO]\nEMCIO = io\nCYCLE_TIME = 0.1\nTOOL_TABLE = tool.tbl\n\n\
         [HAL]\nHALFILE = {stem}.hal\n\n\
         [KINS]\nKINEMATICS = {kins}\nJOINTS = {count}\n\n\
         [TRAJ]\nCOORDINATES = {coordinates}\nLINEAR_UNITS = mm\nANGULAR_UNITS = degree\n\
         DEFAULT_LINEAR_VELOCITY = {speed}\n\
         # The speed of the slowest of X, Y and Z: under tip control a rapid along any of them may move any joint.\n\
         MAX_LINEAR_VELOCITY = {most}\n\
         DEFAULT_ANGULAR_VELOCITY = {rotary_speed}\nMAX_ANGULAR_VELOCITY = {rotary_most}\n\
         DEFAULT_LINEAR_ACCELERATION = {acceleration}\nMAX_LINEAR_ACCELERATION = {acceleration}\n",
        machine = module.machine.name(),
        stem = module.stem,
        kins = module.name,
        count = module.joints.len(),
        coordinates = letters.join(" "),
        speed = SPEED[0].min(speeds(module, AxisKind::Linear).fold(f64::INFINITY, f64::min)),
        rotary_speed = SPEED[1],
        most = speeds(module, AxisKind::Linear).fold(f64::INFINITY, f64::min),
        rotary_most = speeds(module, AxisKind::Rotary).fold(SPEED[1], f64::max),
        acceleration = ACCELERATION[0],
    );
    let bounds = module.config.set_up.travel(module.machine.axes());
    for (joint, (index, axis)) in module.joints.iter().enumerate() {
        let (limits, speed) = (bounds.limits[*index], bounds.speeds[*index]);
        let coordinate = "XYZ".contains(axis.letter);
        let of_axis = match coordinate {
            true => Some(Limits { lower: -COORDINATES, upper: COORDINATES }),
            false => limits,
        };
        let kind = match axis.kind {
            AxisKind::Linear => "LINEAR",
            AxisKind::Rotary => "ANGULAR",
        };
        if joint == 0 {
            ini.push_str(
                "\n# The limits of X, Y and Z are those of coordinates of the tip as well, which leave the travel of the joints:\n\
                 # they are wide, and the limits of the joints hold in both types of kinematics.\n",
            );
        }
        let dynamics = format!(
            "{}MAX_VELOCITY = {}\nMAX_ACCELERATION = {}\n",
            if speed.is_none() { "# Not declared: assumed.\n" } else { "" },
            per_second(axis.kind, speed),
            ACCELERATION[kind_index(axis.kind)]
        );
        let _ = write!(
            ini,
            "\n[AXIS_{letter}]\n{dynamics}{of_axis}\n[JOINT_{joint}]\nTYPE = {kind}\nHOME = {home}\nHOME_SEQUENCE = 0\n\
             HOME_SEARCH_VEL = 0\n{dynamics}{of_joint}FERROR = 1.0\nMIN_FERROR = 0.1\n",
            letter = axis.letter,
            of_axis = limit_lines(axis.kind, of_axis),
            of_joint = limit_lines(axis.kind, limits),
            home = home(axis.kind, limits),
        );
    }
    ini
}

fn kind_index(kind: AxisKind) -> usize {
    match kind {
        AxisKind::Linear => 0,
        AxisKind::Rotary => 1,
    }
}

/// In mm/s or deg/s, from mm/min or rad/min.
fn per_second(kind: AxisKind, speed: Option<f64>) -> f64 {
    speed.map_or(SPEED[kind_index(kind)], |speed| printed(kind, speed) / 60.0)
}

/// Speeds of the axes of a kind that are solved for.
fn speeds(module: &Module<'_>, kind: AxisKind) -> impl Iterator<Item = f64> {
    let speeds = module.config.set_up.travel(module.machine.axes()).speeds;
    let of_kind = module.joints.iter().filter(move |(_, axis)| axis.kind == kind && !axis.held);
    of_kind.map(move |(index, _)| per_second(kind, speeds[*index]))
}

/// A value in mm or degrees.
fn printed(kind: AxisKind, value: f64) -> f64 {
    match kind {
        AxisKind::Linear => value,
        // Limits are given in degrees: their conversion to radians and back is rounded away.
        AxisKind::Rotary => (value.to_degrees() * 1e9).round() / 1e9,
    }
}

fn limit_lines(kind: AxisKind, limits: Option<Limits>) -> String {
    limits.map_or(String::new(), |Limits { lower, upper }| {
        format!("MIN_LIMIT = {}\nMAX_LIMIT = {}\n", printed(kind, lower), printed(kind, upper))
    })
}

/// Zero, or the limit next to it where zero is outside.
fn home(kind: AxisKind, limits: Option<Limits>) -> f64 {
    limits.map_or(0.0, |Limits { lower, upper }| printed(kind, 0.0_f64.max(lower).min(upper)))
}

/// The HAL file.
pub(super) fn hal(module: &Module<'_>) -> String {
    let pins = module.pin_prefix();
    let mut hal = format!(
        "# {machine}, simulated: the joints are where they are commanded.\n\
         loadrt [KINS]KINEMATICS\n\
         loadrt [EMCMOT]EMCMOT servo_period_nsec=[EMCMOT]SERVO_PERIOD num_joints=[KINS]JOINTS\n\
         addf motion-command-handler servo-thread\naddf motion-controller servo-thread\n\n",
        machine = module.machine.name(),
    );
    for joint in 0..module.joints.len() {
        let _ = writeln!(hal, "net joint-{joint} joint.{joint}.motor-pos-cmd => joint.{joint}.motor-pos-fb");
    }
    let _ = write!(
        hal,
        "\nnet estop iocontrol.0.user-enable-out => iocontrol.0.emc-enable-in\n\
         net tool-prepare iocontrol.0.tool-prepare => iocontrol.0.tool-prepared\n\
         net tool-change iocontrol.0.tool-change => iocontrol.0.tool-changed\n\
         setp spindle.0.at-speed 1\n\n\
         # Kinematics: 0 joints as axes, 1 tip control.\n\
         net kinematics motion.analog-out-0{OUTPUT} => motion.switchkins-type\n\
         net tool-length motion.tooloffset.{length} => {pins}.tool-offset\n",
        length = module.length.to_ascii_lowercase(),
    );
    let zero = |letter: char| module.config.set_up.machine_zero.get(&letter).copied();
    if "XYZ".chars().all(|letter| zero(letter).is_none()) {
        hal.push_str(
            "# `machine_zero` is not given: the zero position is at machine zero until these values are measured.\n",
        );
    }
    for (index, letter) in "XYZ".chars().enumerate() {
        let small = letter.to_ascii_lowercase();
        let _ = writeln!(hal, "setp {pins}.zero-{small} {}", zero(letter).unwrap_or(0.0));
        let _ = writeln!(hal, "setp {pins}.part-origin-{small} {}", module.config.set_up.part_origin[index]);
    }
    for (index, dimension) in module.machine.dimensions().iter().enumerate() {
        let value = module.machine.dimension(index);
        let value = match dimension.kind {
            DimensionKind::Length => value,
            DimensionKind::Angle => printed(AxisKind::Rotary, value),
        };
        let _ = writeln!(hal, "setp {pins}.{} {value}", Module::dimension_pin(dimension.name));
    }
    hal
}

/// The tool table, from the tools of the configuration.
pub(super) fn tools(module: &Module<'_>) -> String {
    let mut table = String::new();
    for (number, tool) in &module.config.set_up.tools {
        let letter = module.length;
        let length = tool.length_mm.map_or(String::new(), |length| format!(" {letter}{length}"));
        let diameter = tool.diameter_mm.map_or(String::new(), |diameter| format!(" D{diameter}"));
        let name = tool.name.as_deref().map_or(String::new(), |name| format!(" ;{name}"));
        let _ = writeln!(table, "T{number} P{number}{length}{diameter}{name}");
    }
    table
}

/// Subroutine of a switch code.
pub(super) fn switch(code: &str, kinematics: u32) -> String {
    let title = code.to_uppercase();
    let what = if kinematics == 1 { "tip control" } else { "joints as axes" };
    format!(
        "({title}: {what})\n\
         o<{code}>sub\n\
         (the joints come to rest: the switch takes their momentary positions)\n\
         M66 E0 L0\n\
         G4 P0.05\n\
         M68 E{OUTPUT} Q{kinematics}\n\
         (a second command: it is accepted one cycle after the switch)\n\
         M68 E{OUTPUT} Q{kinematics}\n\
         M66 E0 L0\n\
         o1 if [#<_task> EQ 1]\n\
         o2 if [#<_hal[kinstype.is-{kinematics}]> NE 1]\n\
         (abort, {title}: the kinematics have not been switched)\n\
         o2 endif\n\
         o1 endif\n\
         o<{code}>endsub\n\
         M2\n"
    )
}
