//! SINUMERIK: the swivel data record `$TC_CARR` of CYCLE800, and the machine data of TRAORI.
//!
//! With `l1` to `l4` the offsets, `R1` and `R2` right-handed rotations about `v1` and `v2` by the axis values, `L` the
//! vector from the tip to the gauge line and `w` a point of the workpiece (machine coordinates at the zero position),
//! the control computes, of the part that the data record describes,
//!
//! - the vector from the tip to the machine, type T: `l1 + R1 (l2 + R2 (l3 + L))`, type M: `l1 + R1 (l2 + L)`;
//! - the position of the workpiece point, type P: `l2 + R1 (l3 + R2 (l4 + w))`, type M: `l3 + R2 (l4 + w)`.
//!
//! Sources: Function Manual Tool Compensation (W1), 08/2005, 6FC5397-0BP10-0BA0: p. 2-88 (offsets of a head count from
//! the tip to the reference point), p. 2-89 (offsets of a table count from the machine reference point to the table;
//! types), p. 2-92 (right-handed rotation; example of a head), p. 4-3 (example of a table with its result).
//! Commissioning Manual SINUMERIK Operate (IM9): 03/2013, 6FC5397-1DP40-3BA1, p. 502 (points between which the offsets
//! count, closed chains); 12/2017, 6FC5397-1DP40-6BA1, p. 572 (machine data of each offset), p. 581 (example of a
//! head), section 21.7.2 (which axis is the first; the vector of an axis that moves the workpiece is reversed).
//! Function Manual Transformations, 06/2019, A5E47435470B, p. 148 (MD24100, order of the axes).
//!
//! IM9 p. 572 gives offset `l3` of a table to MD24558 under the name of MD24560. A public list made from the machine
//! data manual 6FC5397-7AP40-6BA3 (12/2019) has MD24558 for mixed kinematics only, and MD24560 between the two rotary
//! axes.

mod carrier;
mod record;
mod traori;

use crate::config::Config;
use crate::kinematics::{AnyMachine, Side};

use super::super::NotExpressible;
use super::chain::{Arrangement, RotaryAtZero, tool_coordinate};
use super::rows::{ParameterSection, Sheet};
use super::tests_at_machine::{ControlWords, tests};

use carrier::carrier;
use record::DataRecord;
use traori::transformation;

const MODEL: &str = "TRAORI and CYCLE800";

const IM9_POINTS: &str = "IM9 03/2013 p. 502; IM9 12/2017 p. 572";

/// The sheet.
pub(super) fn sheet(machine: &dyn AnyMachine, config: &Config) -> Result<Sheet, NotExpressible> {
    let arrangement = Arrangement::of(machine, MODEL)?;
    let tool = tool_coordinate(machine, MODEL)?;
    let record = DataRecord::of(&arrangement, config);
    let (first, second) = arrangement.axes();
    let introduction = vec![
        "SINUMERIK 840D sl and 828D, and ONE where it uses these data. Swivel data record: Commissioning, NC, Transformations \
         (Setup, Swivel). TRAORI: channel machine data. Where TRAORI or CYCLE800 is defined by kinematic chains ($NT_, $NK_), these \
         data are not read and this sheet does not apply: no public manual settles the signs there, and tests 1 to 3 decide."
            .to_owned(),
        format!("{}.", order(first, second)),
    ];
    let mut differences = vec![
        record.free.to_owned(),
        "V1 and V2 may have any length: only their direction counts (IM9 12/2017 p. 581).".to_owned(),
        "A sum of the offsets that is not zero is right for a head or a table that can be exchanged (IM9 03/2013 p. 502): then the \
         work offsets contain that sum."
            .to_owned(),
    ];
    if record.kind != 'T' {
        differences.push(
            "The machine reference point of the manual, from which the offsets of a table count, is the machine zero point here, \
             because work offsets count from it. Offsets from another point rotate the table about a centre that is off by the \
             distance of the two: test 2 finds it."
                .to_owned(),
        );
    }
    differences.push(
        "Any other difference: measure the centre line again (for example with CYCLE996), and correct the control, or the dimensions \
         and `d` of the declaration. The post and the control must have the same numbers."
            .to_owned(),
    );
    Ok(Sheet {
        control: "Siemens SINUMERIK",
        introduction,
        sections: vec![
            ParameterSection {
                title: "Swivel data record (CYCLE800), number m of the record".to_owned(),
                groups: carrier(&record, first, second, tool),
            },
            ParameterSection {
                title: "Five-axis transformation (TRAORI), transformation 1".to_owned(),
                groups: transformation(&record, first, second, tool),
            },
        ],
        differences,
        tests: tests(machine, &ControlWords { control: "siemens", tip_control: "TRAORI", plane: "CYCLE800" }),
        sources: vec![
            "IM9: Commissioning Manual SINUMERIK Operate (IM9), 03/2013, 6FC5397-1DP40-3BA1, and 12/2017, 6FC5397-1DP40-6BA1",
            "W1: Function Manual Tool Compensation, 08/2005, 6FC5397-0BP10-0BA0",
            "F2: Function Manual Transformations, 06/2019, A5E47435470B",
            "NC programming: Programming Manual, 12/2019, 6FC5398-2EP40-0BA0; Job planning: Programming Manual, 06/2009, \
             6FC5398-2BP20-0BA0",
            "Machine data list: 12/2019, 6FC5397-7AP40-6BA3, as quoted in a public list of its names",
        ],
    })
}

/// Which axis is the first, and where it is.
fn order(first: &RotaryAtZero, second: Option<&RotaryAtZero>) -> String {
    let place = |axis: &RotaryAtZero| match axis.side {
        Side::Workpiece => "in the table",
        Side::Tool => "in the head",
    };
    let text = format!("First rotary axis: {}, {}", first.letter, place(first));
    match second {
        Some(second) if second.side == first.side => {
            format!(
                "{text}, next to the bed; it carries the second one, {} (IM9 12/2017, section 21.7.2)",
                second.letter
            )
        }
        Some(second) => format!(
            "{text}; second rotary axis: {}, {}. With one of each the axis of the head is the first (IM9 12/2017, section 21.7.2)",
            second.letter,
            place(second)
        ),
        None => format!("{text}. A single rotary axis is always the first one (IM9 03/2013 p. 502)"),
    }
}

fn vector_meaning(index: usize, axis: Option<&RotaryAtZero>) -> String {
    let Some(axis) = axis else { return format!("V{}: zero, because there is no such axis.", index + 1) };
    let carried = match axis.side {
        Side::Workpiece => "the table",
        Side::Tool => "the head",
    };
    format!(
        "V{}: direction about which {carried} itself rotates right-handed (clockwise seen along the vector) for positive words of \
         {}. An axis that moves the workpiece has the vector reversed.",
        index + 1,
        axis.letter
    )
}
