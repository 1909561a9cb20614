//! Fanuc: parameters of five-axis machining, which tool center point control (G43.4) and tilted planes (G68.2) use.
//!
//! Points with all axes at zero: A on the first, B on the second rotary axis of the table; D on the tool axis, tool
//! length and tool holder offset (19666) above the tip; E on the rotary axis next to the tool, F on that next to the
//! bed. 19700 to 19702 are A in machine coordinates, 19703 to 19705 the vector from A to B, 19709 to 19711 that from D
//! to E, 19712 to 19714 that from E to F.
//!
//! Sources: Additional Manual A-79348E (Series 30i, 01/2004): p. 70 (19665), p. 72 (19680: types, master and slave), p.
//! 75 (19684, 19685: directions, hypothetical axes), p. 78 (19696), p. 82 (19703; A in a figure in machine
//! coordinates), p. 83 (19709; D and E), p. 84 (19712; E and F). Connection Manual B-63943EN-1/02 p. 1099 repeats the
//! last. A-78712E p. 61-62 (16i, 18i) has D, E and F, too. A-79976E p. 5 names 19697. The codes of 19682, 19687 and
//! 19697 are from general knowledge: their pages (A-79348E p. 73, 74 and 79) were not found in public.

use nalgebra::Vector3;

use crate::config::{Config, TcpFrame};
use crate::kinematics::{AnyMachine, AxisKind, Side};

use super::super::NotExpressible;
use super::chain::{Arrangement, RotaryAtZero, machine_coordinates, tool_coordinate};
use super::rows::{Expected, Group, ParameterSection, Row, Sheet, XYZ, known_lengths, lengths};
use super::tests_at_machine::{ControlWords, tests};

const MODEL: &str = "five-axis machining (G43.4, G68.2)";

const AXIS_CODES: &str = "the codes are from general knowledge; no public page of 19682 and 19683 was found. Tests 1 and 2 settle \
                          them.";

/// Place of a rotary axis as 19682 to 19684 state it.
struct Inclination {
    /// 1 X, 2 Y, 3 Z; 4 from X to Y, 5 from Y to Z, 6 from Z to X.
    code: u32,
    degrees: f64,
    /// 0: table or head rotates right-handed about that axis for positive words. 1: left-handed.
    direction: u32,
}

impl Inclination {
    /// Of an axis along a coordinate or in a plane of two.
    fn of(axis: &RotaryAtZero) -> Result<Self, NotExpressible> {
        let rotation = &axis.rotation;
        if let Some(index) = axis.coordinate() {
            let direction = u32::from(rotation[index] < 0.0);
            return Ok(Self { code: [1, 2, 3][index], degrees: 0.0, direction });
        }
        // From X to Y, from Y to Z, from Z to X.
        let plane = (0..3).find(|&from| rotation[(from + 2) % 3].abs() < 1e-12);
        let Some(from) = plane else {
            return Err(NotExpressible(format!(
                "{} has components along X, Y and Z, and parameters 19682 and 19683 incline an axis in the plane of two of them only",
                axis.letter
            )));
        };
        let angle = rotation[(from + 1) % 3].atan2(rotation[from]).to_degrees();
        // The same line with the opposite direction of rotation.
        let (degrees, direction) = match angle {
            _ if angle > 90.0 => (angle - 180.0, 1),
            _ if angle <= -90.0 => (angle + 180.0, 1),
            _ => (angle, 0),
        };
        Ok(Self { code: [4, 5, 6][from], degrees, direction })
    }
}

/// The sheet.
pub(super) fn sheet(machine: &dyn AnyMachine, config: &Config) -> Result<Sheet, NotExpressible> {
    let arrangement = Arrangement::of(machine, MODEL)?;
    let tool = tool_coordinate(machine, MODEL)?;
    let (first, second) = arrangement.axes();
    let Some(second) = second else {
        return Err(NotExpressible(format!(
            "types 2, 12 and 21 of parameter 19680 have two rotary axes, {} has one: a hypothetical axis may take the place of the \
             other (19696#0, #1), but no public manual settles its parameters. Test at the machine: with G43.4 active the tip must \
             stay on a fixed point while {} rotates",
            machine.name(),
            first.letter
        )));
    };
    let mut groups = vec![kind(&arrangement)];
    groups.extend(rotary_axis(first, "first", 19681)?);
    groups.extend(rotary_axis(second, "second", 19686)?);
    groups.push(hypothetical());
    groups.extend(reference_direction(tool));
    match &arrangement {
        Arrangement::Table(..) => groups.extend(table(machine, config, first, Some(second))),
        Arrangement::Mixed { head, table: axis } => {
            groups.extend(table(machine, config, axis, None));
            groups.extend(head_offsets(head, None, tool));
        }
        Arrangement::Head(..) => groups.extend(head_offsets(second, Some(first), tool)),
    }
    if matches!(arrangement, Arrangement::Table(..)) {
        groups.push(Group::new(
            "Tool holder offset: it is added to every tool length, and a table does not need it.",
            "A-79348E p. 83",
            vec![Row::new("19666", "tool holder offset", Expected::Millimetres(0.0))],
        ));
    } else {
        groups.push(controlled_point());
    }
    if !matches!(arrangement, Arrangement::Head(..)) {
        groups.push(programming_frame(config));
    }
    Ok(Sheet {
        control: "Fanuc Series 30i, 31i (and 16i, 18i)",
        introduction: vec![format!(
            "Parameters of the path (SYSTEM, PARAM). First rotary axis: {}, {}; second: {}, {}. Of two axes on one side the first \
             (master) is next to the bed and carries the second (slave); of a head and a table the head is the first \
             (A-79348E p. 72).",
            first.letter,
            place(first),
            second.letter,
            place(second)
        )],
        sections: vec![ParameterSection { title: "Parameters of five-axis machining".to_owned(), groups }],
        differences: differences(&arrangement),
        tests: tests(machine, &ControlWords { control: "fanuc", tip_control: "G43.4", plane: "G68.2 and G53.1" }),
        sources: vec![
            "A-79348E: Series 30i-MODEL A, Tool center point control for 5-axis machining, additional manual, 01/2004",
            "B-63943EN-1/02: Series 30i/31i/32i-MODEL A, Connection Manual (Function)",
            "A-78712E: Series 16i, 18i-MB, Tilted working plane command, specifications",
            "A-79976E: Series 30i, 31i, Specifying tilted working plane based on the tool axis direction, 02/2005",
        ],
    })
}

fn place(axis: &RotaryAtZero) -> &'static str {
    match axis.side {
        Side::Workpiece => "in the table",
        Side::Tool => "in the head",
    }
}

fn kind(arrangement: &Arrangement) -> Group {
    let (code, meaning) = match arrangement {
        Arrangement::Head(..) => (2, "two rotary axes of the tool"),
        Arrangement::Table(..) => (12, "two rotary axes of the table"),
        Arrangement::Mixed { .. } => (21, "one rotary axis of the tool, one of the table"),
    };
    Group::new(
        format!("Type of the machine: {meaning}."),
        "A-79348E p. 72",
        vec![Row::code("19680", "mechanical unit type", code)],
    )
}

/// 19681 to 19684, or 19686 to 19689.
fn rotary_axis(axis: &RotaryAtZero, rank: &str, number: u32) -> Result<[Group; 3], NotExpressible> {
    let Inclination { code, degrees, direction } = Inclination::of(axis)?;
    let sense = if direction == 0 { "right-handed" } else { "left-handed" };
    let body = match axis.side {
        Side::Workpiece => "table",
        Side::Tool => "head",
    };
    let along = match code {
        1..=3 => format!("along {}", XYZ[code as usize - 1]),
        _ => {
            let from = code as usize - 4;
            format!("inclined from +{} towards +{}", XYZ[from], XYZ[(from + 1) % 3])
        }
    };
    Ok([
        Group::new(
            format!("{} is the {rank} rotary axis: its number in the path.", axis.letter),
            "A-79348E p. 75",
            vec![Row::code(
                number.to_string(),
                format!("axis number, {rank} rotary axis"),
                format!("number of {}", axis.letter),
            )],
        ),
        Group::new(
            format!("Centre line of {}: {along}.", axis.letter),
            "A-79348E p. 73-74",
            vec![
                Row::code((number + 1).to_string(), format!("direction of the {rank} axis"), code),
                Row::new(
                    (number + 2).to_string(),
                    format!("inclination of the {rank} axis"),
                    Expected::Degrees(degrees),
                ),
            ],
        )
        .unverified(AXIS_CODES),
        Group::new(
            format!(
                "Sense of {}: for positive words the {body} itself rotates {sense} about that direction.",
                axis.letter
            ),
            "A-79348E p. 75",
            vec![Row::code((number + 3).to_string(), format!("rotation of the {rank} axis"), direction)],
        ),
    ])
}

fn hypothetical() -> Group {
    Group::new(
        "Both rotary axes exist.",
        "A-79348E p. 75, 78",
        vec![
            Row::code("19696#0", "IA1, first axis hypothetical", 0),
            Row::code("19696#1", "IA2, second axis hypothetical", 0),
            Row::new("19685", "angle if hypothetical, first", Expected::Degrees(0.0)),
            Row::new("19690", "angle if hypothetical, second", Expected::Degrees(0.0)),
        ],
    )
}

fn reference_direction(tool: usize) -> [Group; 1] {
    let group = Group::new(
        format!("Direction of the tool with all rotary axes at zero: +{}, not inclined.", XYZ[tool]),
        "A-79348E p. 79; A-79976E p. 5",
        vec![
            Row::code("19697", "reference tool axis direction", [1, 2, 3][tool]),
            Row::new("19698", "inclination RA", Expected::Degrees(0.0)),
            Row::new("19699", "inclination RB", Expected::Degrees(0.0)),
        ],
    );
    [group.unverified(
        "the codes are from general knowledge; no public page of 19697 to 19699 was found. Test 2 settles them.",
    )]
}

/// 19700 to 19705.
fn table(machine: &dyn AnyMachine, config: &Config, first: &RotaryAtZero, second: Option<&RotaryAtZero>) -> Vec<Group> {
    let point = machine_coordinates(config, &first.point);
    let mut position = Group::new(
        format!(
            "Point A on the centre line of {}, in machine coordinates: the position of the linear axes at which the gauge point (no \
             tool) is on it.",
            first.letter
        ),
        "A-79348E p. 82 (figure)",
        known_lengths("rotary table position", |component| (19700 + component).to_string(), &point),
    );
    let carried =
        machine.axes().iter().find(|axis| axis.side == Side::Workpiece && axis.kind == AxisKind::Linear && !axis.held);
    if let Some(slide) = carried {
        position = position.unverified(format!(
            "{} moves the table, and no public page states at which position of {} its place counts; here that is machine zero. \
             Test 2 settles it.",
            slide.letter, slide.letter
        ));
    }
    let mut groups = vec![position];
    if let Some(second) = second {
        groups.push(Group::new(
            format!("From A on the centre line of {} to B on that of {}.", first.letter, second.letter),
            "A-79348E p. 82",
            lengths(
                "offset first to second",
                |component| (19703 + component).to_string(),
                &(second.point - first.point),
            ),
        ));
    }
    groups
}

/// 19666 and 19709 to 19714. `slave` is the axis next to the tool.
fn head_offsets(slave: &RotaryAtZero, master: Option<&RotaryAtZero>, tool: usize) -> Vec<Group> {
    let holder = slave.point[tool];
    let mut along = Vector3::zeros();
    along[tool] = holder;
    let mut groups = vec![
        Group::new(
            format!(
                "From the gauge line along the tool to point D, at the height of the centre line of {}.",
                slave.letter
            ),
            "A-79348E p. 83",
            vec![Row::new("19666", "tool holder offset", Expected::Millimetres(holder))],
        ),
        Group::new(
            format!("From D on the tool axis to E on the centre line of {}.", slave.letter),
            "A-79348E p. 83; A-78712E p. 61",
            lengths("offset tool to axis", |component| (19709 + component).to_string(), &(slave.point - along)),
        ),
    ];
    if let Some(master) = master {
        groups.push(Group::new(
            format!("From E on the centre line of {} to F on that of {}.", slave.letter, master.letter),
            "A-79348E p. 84; A-78712E p. 62",
            lengths(
                "offset second to first",
                |component| (19712 + component).to_string(),
                &(master.point - slave.point),
            ),
        ));
    }
    groups
}

fn controlled_point() -> Group {
    Group::new(
        "Controlled point: which point of the head the machine coordinates belong to. It shifts machine coordinates and work \
         offsets by one vector, and does not change the path of the tip. Write down what is set.",
        "A-79348E p. 70",
        vec![
            Row::new("19665#5", "SVC, controlled point is shifted", Expected::Any),
            Row::new("19665#4", "SPR, by parameter 19667", Expected::Any),
        ],
    )
}

/// 19696#5.
fn programming_frame(config: &Config) -> Group {
    let expected = match config.motion.tip.tcp_frame {
        None => Expected::Needs("tcp_frame"),
        Some(TcpFrame::NotTurning) => Expected::Code("1".to_owned()),
        Some(TcpFrame::TableAtZero | TcpFrame::TableAtStart) => Expected::Code("0".to_owned()),
    };
    Group::new(
        "Coordinate system of the program under G43.4: 0 rotates with the table, 1 does not. It must agree with `tcp_frame` of the \
         set-up file, with which programs are posted.",
        "A-79348E p. 78",
        vec![Row::new("19696#5", "WKP", expected)],
    )
}

fn differences(arrangement: &Arrangement) -> Vec<String> {
    let mut lines = vec![
        "An inclination that differs by 180 degrees, with the other value for the rotation of that axis (19684, 19689), is the same \
         machine."
            .to_owned(),
    ];
    match arrangement {
        Arrangement::Table(..) => lines.push(
            "A may be anywhere on the centre line of the first axis, B on that of the second: a difference along the first axis in \
             19700 to 19702 with the opposite one in 19703 to 19705, and any difference of 19703 to 19705 along the second axis, are \
             the same machine."
                .to_owned(),
        ),
        Arrangement::Head(..) => lines.push(
            "D may be anywhere on the tool axis: only the sum of 19666 and the component of 19709 to 19711 along the tool counts. E \
             and F may be anywhere on their centre lines: a difference along the second axis in 19709 to 19711 with the opposite one \
             in 19712 to 19714, and any difference of 19712 to 19714 along the first axis, are the same machine."
                .to_owned(),
        ),
        Arrangement::Mixed { .. } => lines.push(
            "D may be anywhere on the tool axis: only the sum of 19666 and the component of 19709 to 19711 along the tool counts. \
             Any difference of 19709 to 19711 along the first axis, and of 19700 to 19702 along the second, is the same machine."
                .to_owned(),
        ),
    }
    lines.push(
        "Parameters of the 16i and 18i are integers in units of 0.001 mm (IS-B) or 0.0001 mm (IS-C): A-78712E p. 61. Radius values, \
         also on a diameter axis."
            .to_owned(),
    );
    lines.push(
        "Any other difference: measure the centre line again, and correct the parameter, or the dimensions and `d` of the \
         declaration. The post and the control must have the same numbers."
            .to_owned(),
    );
    lines
}
