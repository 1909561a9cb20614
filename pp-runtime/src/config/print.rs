//! The defaults as a file to edit.

use std::fmt::Write as _;

use crate::kinematics::{Axis, AxisKind, DimensionKind, Machine};
use crate::program::Coolant;

use super::{Config, Rapid, Transition};

/// A configuration file for the machine `M` in which every default stands, switched off. `config`: the defaults of the
/// control, or [`Config::default`].
///
/// A line that begins with `#` and a key is a default; a line that begins with `# e.g.` shows a key without default.
/// Read back as it stands the file gives [`Config::default`], so what nobody changes stays marked as assumed.
#[must_use]
pub fn print<M: Machine>(config: &Config) -> String {
    let mut text = String::new();
    // Writing to a string cannot fail.
    let _ = write_top::<M>(&mut text, config);
    let _ = write_tables::<M>(&mut text, config);
    text
}

fn write_top<M: Machine>(out: &mut String, config: &Config) -> std::fmt::Result {
    let [x, y, z] = config.set_up.part_origin.map(number);
    let [rx, ry, rz] = config.set_up.part_angles().map(number);
    let transition = match config.motion.rapids.transition {
        Transition::Safe => "safe",
        Transition::Direct => "direct",
    };
    write!(
        out,
        r#"# Set-up for {name}.
#
# A line that begins with `#` and a key shows a default: remove the `#` and change the value.
# A line that begins with `# e.g.` shows a key that has no default.
# What is not set here is marked as assumed in the summary and in the header of the program.
# Angles are in degrees, speeds per minute, lengths in the unit of this file.

# Unit of length of this file: "mm" or "in".
units = "mm"

# Unit of CL data that does not state its own. Without it such data is refused.
# e.g. cl_units = "mm"
# The point that the CL data programs: "tip", or "centre" of the corner radius.
#cl_point = "tip"
# Unit of the program. Without it that of the CL data.
# e.g. output_units = "mm"

# Part zero from the table's reference point, along the table's directions.
#part_origin = [{x}, {y}, {z}]
# How the part lies on the table: the CL data is turned by [rx, ry, rz] degrees about X, then Y, then Z of the table, or by
# the rows of a matrix. `floor`, `retract.clearance` and the tips in the header count in the part as it lies.
#part_rotation = [{rx}, {ry}, {rz}]
# The written word of a rotary axis is its value minus this; limits hold for the value. The other rotary entries of the
# work offset must be zero.
# e.g. rotary_offset = {{ {rotary_offset} }}
# Linear words count from the "part" zero, or from the reference point of the "table".
#program_zero = "part"
# Linear words say where the "tip" is with all rotary axes at zero and the length offset active, or where the "gauge" line
# is, without length offset.
#length_mode = "tip"
# What the words of a motion say: where every one of the "axes" goes (works on any control), where the tip goes while the
# control keeps it there ("tcp"), or where it goes in a tilted "plane" (3+2).
#mode = "{mode}"
# The frame of tip coordinates where a table turns under them: fixed to the table as it stands at zero ("table_at_zero"),
# or where tip control begins ("table_at_start"), or standing still ("not_turning"). Fanuc: parameter 19696#5.
# e.g. tcp_frame = "table_at_zero"
# Blocks of mode "tcp" hold the "angles" of the rotary axes, or the tool axis as "vectors" and the control chooses the angles.
#tcp_words = "angles"
# How the control moves the tool axis in mode "tcp": rotary "axes" evenly, or in the "plane" of its ends.
#tool_posture = "axes"
# In mode "tcp" the control knows held axes and linear axes between rotary ones; in modes "tcp" and "plane" its frame stays
# where `rotary_offset` has entries in the work offset.
#tcp_confirmed = {tcp_confirmed}
# Compare the posted length of a tool with the control's tool table at the tool call, where the control can. Without it
# where a rotary axis in the head makes the length matter.
# e.g. length_guard = true
#length_tolerance = {length_tolerance}
# Work offset of the control: "G54", and "G59.1" (LinuxCNC), "G54.1 P3" (Fanuc), "G154 P3" (Haas), "G505" (Siemens) or
# the row of the datum table, "3" (Heidenhain; G54 to G59 are rows 1 to 6).
#work_offset = "{work_offset}"
# Machine coordinate of each linear axis at the zero position, without tool. Without it linear limits are not checked.
# e.g. machine_zero = {{ {machine_zero} }}

# Where axes go at the end of the program: degrees, and machine coordinates for linear axes. Without it they stay.
# e.g. park = {{ {park} }}
# Transition between operations: "safe" (retract, turn, approach) or "direct" (as the CL data has it).
#transition = "{transition}"
# Rapids in which a rotary axis turns more than this go through the safe sequence.
#index_angle = {index_angle}
# Rapids inside an operation: "direct" (one block), "split" (out along the tool, across, in along the tool) or "feed"
# (a feed motion at `rapid_feed`, on a certified path).
#rapid = "{rapid}"
# e.g. rapid_feed = 10000.0
# Speed of rotary axes where only the direction of the tool changes.
#reorient_speed = {reorient_speed}
# Retract before STOP and OPSTOP.
#stop_retract = {stop_retract}

# How far arcs and chords may leave the arcs and curves of the CL data, and the tip its line while a rotary axis moves.
#tolerance = {tolerance}
# How far the tool axis may leave its even turn from one point to the next.
#axis_tolerance_path = {axis_tolerance_path}
# How far the control may leave the programmed path where it blends blocks.
#path_tolerance = {path_tolerance}
# Wait for the spindle, seconds.
#spindle_dwell = {spindle_dwell}
# Largest spindle speed. Without it speeds are not checked.
# e.g. spindle_max = 12000
# Lowest Z of the tool tip, in the part as it lies on the table. Without it depths are not checked.
# e.g. floor = 0.0
# Refuse CL data in which the tool points into the table throughout.
#table_check = {table_check}
"#,
        name = M::NAME,
        mode = config.motion.mode.name(),
        tcp_confirmed = config.motion.tip.tcp_confirmed,
        length_tolerance = number(config.motion.guards.length_tolerance),
        work_offset = config.set_up.work_offset,
        rotary_offset = axes::<M>(|axis| axis.kind == AxisKind::Rotary && !axis.held),
        machine_zero = axes::<M>(|axis| axis.kind == AxisKind::Linear),
        park = axes::<M>(|axis| axis.kind == AxisKind::Rotary),
        index_angle = degrees(config.motion.rapids.index_angle),
        rapid = match config.motion.rapids.rapid {
            Rapid::Direct => "direct",
            Rapid::Split => "split",
            Rapid::Feed => "feed",
        },
        reorient_speed = degrees(config.motion.rapids.reorient_speed),
        stop_retract = config.motion.stop_retract,
        tolerance = number(config.motion.tolerance),
        axis_tolerance_path = degrees(config.motion.axis_tolerance_path),
        path_tolerance = number(config.control.path_tolerance),
        spindle_dwell = number(config.motion.spindle_dwell),
        table_check = config.motion.guards.table_check,
    )
}

fn write_tables<M: Machine>(out: &mut String, config: &Config) -> std::fmt::Result {
    let coolant = match config.motion.defaults.coolant {
        Coolant::On | Coolant::Off | Coolant::Flood => "flood",
        Coolant::Mist => "mist",
        Coolant::Through => "through",
        Coolant::Air => "air",
    };
    let formats = &config.formats;
    write!(
        out,
        r#"
# What the CL data may leave out.
[defaults]
# e.g. speed = 8000
# CLW (M3) or CCLW (M4).
# e.g. direction = "CLW"
# What COOLNT/ON means: "flood", "mist", "through" or "air".
#coolant = "{coolant}"
# The tool of CL data that calls none before it moves. Without it such data is refused.
# e.g. tool = 1
# How far above the bottom a rapid ends in a hole that is drilled in steps.
#peck_gap = {peck_gap}

# How the CL data is read; `explain --cl` lists its words.
[cl]
# CAM system where the file does not tell, or tells wrongly: "nx", "catia", "creo", "solidworks" or "iso".
# e.g. dialect = "nx"
# Columns of a line that count, for cards with numbers behind them. Without it all of them.
# e.g. columns = 72
# Words that are passed over.
#inert = []
# A second frame: "refuse", "main" (mapped into the first) or "offset" (a work offset of its own, see [frames]).
#frames = "refuse"
# Sense of every CIRCLE about its axis, whatever its form says: "cw" or "ccw".
# e.g. circle_sense = "ccw"
# INSERT: "refuse", "comment" or "write" (as NC text that nobody checks).
#insert = "refuse"
# INSERT/STOP is STOP.
#insert_stop = false
# Codes that AUXFUN and PREFUN may write.
#auxfun = []
#prefun = []
# A feed labelled in mm in a file in inches: "refuse", "trust" or "file-units".
#feed_label = "refuse"
# FROM: "reference" (nothing moves) or "move".
#from = "reference"
# LINTOL may be wider than `tolerance`.
#allow_lintol = false
# Numbers of a CYCLE that have no word: depth, clearance, return, step, dwell, pitch, feed.
# e.g. cycle.TAP.args = ["depth", "pitch"]

# Work offsets of frames other than the first, with frames = "offset".
[frames]
# e.g. 2 = "G55"

# Branch and whole turns of the rotary axes are chosen for the whole program: the fewest rewinds, then these wishes, then
# the least time at the largest axis speeds, then the least travel.
[course]
# Operations begin on this branch of `explain` where they can: "first" or "second".
# e.g. start_branch = "first"
# Operations begin with this axis on this side of zero where they can.
# e.g. prefer = "{prefer}"
# Choose motion by motion, without a view ahead.
#greedy = {greedy}
# Within this angle of the direction that leaves the first rotary free, the tool axis is put there.
#axis_tolerance = {axis_tolerance}

[retract]
# Machine coordinate of the retract axis.
#position = {position}
# Distance along the tool axis. Without it to the clearance geometry of the CL data.
# e.g. distance = 100.0
# Or, in the part as it lies on the table, a plane above, a box or a cylinder around the part that the tool has to leave.
# e.g. clearance = {{ cylinder = {{ radius = 120.0, lower = -50.0, upper = 80.0 }} }}
# Where rotary axes have to be rewound in a cut: "leave" (out along the tool axis and back), or "follow" (the tip stays in
# place, and the tool swings about it in the part).
#rewind = "leave"
# Coolant off while the rotary axes are rewound out of the part.
#rewind_dry = false

# Arcs of the control: where the rotary axes stand still, in a plane of the program, within `tolerance` of the CL data.
[arcs]
# "native", or "lines" throughout.
#output = "native"
# What says where the centre is: "centre", or "radius" (whole turns and arcs close to half a turn have their centre still).
#form = "centre"
# Arcs that are smaller or larger become lines.
#smallest_radius = {smallest_radius}
#largest_radius = {largest_radius}

# Cycles of the control: where the tool axis is Z of the program and a cycle means just what the CL data says.
[cycles]
# "native", or "expanded" into single motions throughout; a thread is never expanded.
#output = "native"
# Threads with the spindle under control of its angle, where that has a code of its own (M29 of Fanuc).
#rigid = {rigid}

# Cutter compensation by the control (CUTCOM: G41, G42, RL, RR). Without `path` CUTCOM is refused.
[compensation]
# What the CL data under CUTCOM is: "centre" (D holds wear only), or "contour" (D holds the radius).
# e.g. path = "centre"

[feed]
# Blocks in which an axis would be faster than its speed run longer.
#keep_speeds = {keep_speeds}
# Largest F of the control. Without it none.
# e.g. largest = 20000.0
# Shortest time of a block, seconds.
#shortest_block = {shortest_block}

[approach]
# The approach point lies this far from the first point along the tool axis.
#distance = {distance}

# Corners of the blank as it lies on the table, for the pictures of a Heidenhain control (BLK FORM). Without them a box
# around all cuts.
[stock]
# e.g. lower = [-50.0, -40.0, -30.0]
# e.g. upper = [50.0, 40.0, 0.0]

# Tools by number. `length` is from the gauge line to the tip, `offset` and `radius_offset` the registers of
# length and radius where they are not the tool's number; `speed`, `direction` and `coolant` as in [defaults].
[tools]
# e.g. 12 = {{ length = 148.32, diameter = 10.0, offset = 12, radius_offset = 12, name = "ball 10", left_handed = false, speed = 8000, direction = "CLW", coolant = "flood", cl_point = "tip" }}

# Decimals of the words; significant digits for inverse-time feed.
[formats]
#linear_mm = {linear_mm}
#linear_inch = {linear_inch}
#rotary = {rotary}
#feed = {feed}
#inverse_time = {inverse_time}
#speed = {speed}
# Digits before the point: a number with more is refused.
#linear_whole = {linear_whole}
#rotary_whole = {rotary_whole}
#feed_whole = {feed_whole}
#speed_whole = {speed_whole}

# Where the control differs from what is usual for it. Blocks hold fields in braces: {{name}}, {{number}}, {{units}},
# {{work_offset}}, {{path_tolerance}}; those of a tool change {{tool}}, {{next}}, {{offset}} and {{speed}} besides. A word
# whose field has no value is left out, a block with {{next}} where no tool follows, too.
[control]
# Number and name of the program. Without them 1, and the name in the CL data.
# e.g. program_number = 1234
# e.g. program_name = "BRACKET"
# The program begins with the name of its file, as a Siemens archive wants it: `%_N_NAME_MPF`.
#file_header = {file_header}
# Blocks of a restart point, and of a tool change.
# e.g. safety = ["{{units}} G17 G40 G49 G80 G90 G94 {{work_offset}}"]
# e.g. tool_change = ["T{{tool}} M6", "T{{next}}"]
# Call the tool after the next up while the next one cuts.
# e.g. preselect = true
# Codes of a kind of coolant: on, off.
# e.g. coolant = {{ through = ["M88", "M89"] }}
# Smoothing by the control within `path_tolerance`: "none", "rough", "medium" or "finish".
#smoothing = "none"
# e.g. smoothing_angle = 0.1
# What F counts along where a rotary axis moves: "xyz", "xyz+deg", "g93_min" (1/min) or "g93_s" (1/s).
# e.g. path_norm = "xyz+deg"
# Whole numbers end with a point.
# e.g. point = true
# Codes that switch tip control on and off, in mode "tcp".
# e.g. tip_control = ["M428", "M429"]
# Name of the swivel data of CYCLE800.
# e.g. swivel_data = "TABLE"
# All axes of a rapid arrive together under tip control (Fanuc: parameter 1401#1): the check of limits asks for it.
# e.g. linear_rapids = true
# Every word in every block.
#every_word = {every_word}
# Names of axes where they are not their letters.
# e.g. axes = {{ {axis_names} }}

# Blocks after the header and before the end code, with fields as in [control].
[program]
#start = []
#end = []
# Machining times as comments at the end.
#times = false
# The figures of the check of the program as a comment at the end, or that it was not checked.
#checked = false
# Step of the block numbers. Without it there are none.
# e.g. line_numbers = {step}
"#,
        peck_gap = number(config.motion.defaults.peck_gap),
        prefer = sample_preference::<M>(),
        greedy = config.motion.course.greedy,
        axis_tolerance = degrees(config.motion.course.axis_tolerance),
        position = number(config.motion.retract.position()),
        rigid = config.motion.cycles.rigid,
        smallest_radius = number(config.motion.arcs.smallest_radius),
        largest_radius = number(config.motion.arcs.largest_radius),
        keep_speeds = config.motion.feed.keep_speeds,
        shortest_block = number(config.motion.feed.shortest_block),
        distance = number(config.motion.approach.distance),
        linear_mm = formats.linear_mm,
        linear_inch = formats.linear_inch,
        rotary = formats.rotary,
        feed = formats.feed,
        inverse_time = formats.inverse_time,
        speed = formats.speed,
        linear_whole = formats.linear_whole,
        rotary_whole = formats.rotary_whole,
        feed_whole = formats.feed_whole,
        speed_whole = formats.speed_whole,
        every_word = config.control.every_word,
        file_header = config.control.file_header,
        axis_names = sample_names::<M>(),
        step = Config::LINE_NUMBER_STEP,
    )?;
    write_machine::<M>(out)
}

/// The last axis under a name of Siemens.
fn sample_names<M: Machine>() -> String {
    M::AXES.last().map_or_else(String::new, |axis| format!("{0} = \"{0}1\"", axis.letter))
}

/// The last rotary axis at or above zero.
fn sample_preference<M: Machine>() -> String {
    let rotary = M::AXES.iter().rev().find(|axis| axis.kind == AxisKind::Rotary && !axis.held);
    format!("{}+", rotary.map_or('B', |axis| axis.letter))
}

fn write_machine<M: Machine>(out: &mut String) -> std::fmt::Result {
    if !M::DIMENSIONS.is_empty() {
        writeln!(out, "\n# Dimensions of the machine where they differ from its declaration.\n[dimensions]")?;
        for dimension in M::DIMENSIONS {
            let value = match dimension.kind {
                DimensionKind::Length => number(dimension.default),
                DimensionKind::Angle => degrees(dimension.default),
            };
            writeln!(out, "#{} = {value}", dimension.name)?;
        }
    }
    writeln!(
        out,
        "\n# Travel of the axes where it differs from the machine's declaration: [lowest, highest], or \"free\" for an\n\
         # endless axis. Linear axes in machine coordinates.\n[limits]"
    )?;
    for axis in M::AXES {
        match axis.limits {
            Some(limits) => {
                let [lower, upper] = [limits.lower, limits.upper].map(|value| shown(axis, value));
                writeln!(out, "#{} = [{lower}, {upper}]", axis.letter)?;
            }
            None => writeln!(out, "#{} = \"free\"", axis.letter)?,
        }
    }
    writeln!(out, "\n# Largest speeds of the axes where they differ from the machine's declaration.\n[speeds]")?;
    for axis in M::AXES {
        match (axis.speed, axis.kind) {
            (Some(speed), _) => writeln!(out, "#{} = {}", axis.letter, shown(axis, speed))?,
            (None, AxisKind::Linear) => writeln!(out, "# e.g. {} = 20000.0", axis.letter)?,
            (None, AxisKind::Rotary) => writeln!(out, "# e.g. {} = 3600.0", axis.letter)?,
        }
    }
    writeln!(
        out,
        "\n# Words of endless rotary axes: \"none\" (370 is ten degrees past a turn), \"0..360\" or \"+-180\" (the control\n\
         # goes the short way), \"sign\" (0..360, the sense of the motion as sign).\n[wrap]"
    )?;
    for axis in M::AXES.iter().filter(|axis| axis.kind == AxisKind::Rotary && !axis.held && axis.limits.is_none()) {
        writeln!(out, "#{} = \"none\"", axis.letter)?;
    }
    writeln!(
        out,
        "\n# Steps of indexed rotary axes (Hirth): they turn between cuts only, and to these angles only.\n[grid]"
    )?;
    for axis in M::AXES.iter().filter(|axis| axis.kind == AxisKind::Rotary && !axis.held) {
        writeln!(out, "# e.g. {} = 1.0", axis.letter)?;
    }
    writeln!(
        out,
        "\n# Codes that hold a rotary axis where it stays still between two approaches, and that let it turn.\n[clamp]"
    )?;
    for axis in M::AXES.iter().filter(|axis| axis.kind == AxisKind::Rotary && !axis.held) {
        writeln!(out, "# e.g. {} = {{ on = \"M10\", off = \"M11\" }}", axis.letter)?;
    }
    Ok(())
}

/// `X = 0.0, Y = 0.0` for the axes wanted, all of them if none is.
fn axes<M: Machine>(wanted: impl Fn(&Axis) -> bool) -> String {
    let any = M::AXES.iter().any(&wanted);
    let entries: Vec<String> =
        M::AXES.iter().filter(|axis| !any || wanted(axis)).map(|axis| format!("{} = 0.0", axis.letter)).collect();
    entries.join(", ")
}

fn shown(axis: &Axis, value: f64) -> String {
    match axis.kind {
        AxisKind::Linear => number(value),
        AxisKind::Rotary => degrees(value),
    }
}

/// Radians in degrees without the noise of the last binary digits.
fn degrees(radians: f64) -> String {
    number((radians.to_degrees() * 1e9).round() / 1e9)
}

/// A TOML float.
fn number(value: f64) -> String {
    format!("{:?}", value + 0.0)
}
