//! Haas: the settings of the machine rotary zero point, which G234 (TCPC) and G254 (DWO) use.
//!
//! They are the positions of the linear axes at which the spindle is over the centre lines of a tilting rotary table;
//! axes and directions are fixed in the control. Settings 255 to 257 have one point of B in X and Z and of C in Y,
//! settings 300 to 305 of newer software a point of each axis. All of it is from general knowledge: no public page of
//! the manual was found, so every row is marked unverified.

use crate::config::Config;
use crate::kinematics::AnyMachine;

use super::super::NotExpressible;
use super::chain::{Arrangement, RotaryAtZero, machine_coordinates, tool_coordinate};
use super::rows::{Expected, Group, ParameterSection, Row, Sheet, XYZ, known};
use super::tests_at_machine::{ControlWords, tests};

const MODEL: &str = "tip control of Haas (G234)";

const DOUBT: &str = "numbers, names and signs are from general knowledge; no public page of the manual was found. Test 2 settles \
                     them.";

/// The sheet.
pub(super) fn sheet(machine: &dyn AnyMachine, config: &Config) -> Result<Sheet, NotExpressible> {
    let arrangement = Arrangement::of(machine, MODEL)?;
    let tool = tool_coordinate(machine, MODEL)?;
    let [tilt, rotary] = tilting_table(&arrangement, tool)
        .ok_or_else(|| NotExpressible(format!(
            "{MODEL} knows a tilting rotary table as on the UMC only: B along Y, next to the bed, carries C along Z, both with \
             signs of ISO 841, and the spindle along Z. {} is declared differently. Test at the machine: with G234 active the tip \
             must stay on a fixed point while each rotary axis rotates",
            machine.name()
        )))?;
    Ok(Sheet {
        control: "Haas UMC",
        introduction: vec![
            "Settings of the control (SETTING). Software of either kind has one of the two sections: compare that one. Enter what the \
             control shows in mm; if it is set to inches, convert."
                .to_owned(),
        ],
        sections: vec![
            ParameterSection { title: "Machine rotary zero point, settings 255 to 257".to_owned(), groups: older(config, tilt, rotary) },
            ParameterSection { title: "Machine rotary zero point, settings 300 to 305".to_owned(), groups: newer(config, tilt, rotary) },
        ],
        differences: vec![
            "Settings 255 to 257 have no distance between B and C along X: if the centre line of C is not over that of B in X, newer \
             software is needed, or the distance is an error of every tilted position."
                .to_owned(),
            "Any other difference: measure the rotary zero point again, with the probe and the procedure of the machine's manual, and \
             correct the setting, or the dimensions and `d` of the declaration. The post and the control must have the same numbers."
                .to_owned(),
        ],
        tests: tests(machine, &ControlWords { control: "haas", tip_control: "G234", plane: "G254, or with G268 and G253" }),
        sources: vec!["No public page of these settings was found: everything here is from general knowledge."],
    })
}

/// B and C of a table as on the UMC.
fn tilting_table(arrangement: &Arrangement, tool: usize) -> Option<[&RotaryAtZero; 2]> {
    let Arrangement::Table(tilt, Some(rotary)) = arrangement else { return None };
    // A table with signs of ISO 841 rotates left-handed.
    let runs = |axis: &RotaryAtZero, letter: char, index: usize| {
        axis.letter == letter && axis.coordinate() == Some(index) && axis.rotation[index] < 0.0
    };
    (runs(tilt, 'B', 1) && runs(rotary, 'C', 2) && tool == 2).then_some([tilt, rotary])
}

fn older(config: &Config, tilt: &RotaryAtZero, rotary: &RotaryAtZero) -> Vec<Group> {
    let (of_b, of_c) = (machine_coordinates(config, &tilt.point), machine_coordinates(config, &rotary.point));
    let apart = rotary.point.x - tilt.point.x;
    let same = apart.abs() < 0.00005;
    let mut groups = vec![
        Group::new(
            "Machine coordinates X and Z of the centre line of B: the position of the axes at which the gauge point (no tool) is on it.",
            "general knowledge",
            vec![
                Row::new("255", "MRZP X offset", known(of_b[0])),
                Row::new("257", "MRZP Z offset", known(of_b[2])),
            ],
        )
        .unverified(DOUBT),
        Group::new(
            "Machine coordinate Y of the centre line of C.",
            "general knowledge",
            vec![Row::new("256", "MRZP Y offset", known(of_c[1]))],
        )
        .unverified(DOUBT),
    ];
    if !same {
        groups.push(Group::new(
            format!(
                "Refused: the centre line of C is {apart:.4} mm from that of B along X, and these settings have no parameter for that \
                 distance. Compare settings 300 to 305."
            ),
            "general knowledge",
            vec![],
        ));
    }
    groups
}

fn newer(config: &Config, tilt: &RotaryAtZero, rotary: &RotaryAtZero) -> Vec<Group> {
    [("master", tilt, 300), ("slave", rotary, 303)]
        .map(|(rank, axis, number)| {
            let point = machine_coordinates(config, &axis.point);
            let along = axis.coordinate();
            let row = |component: usize| {
                let expected = if along == Some(component) { Expected::Any } else { known(point[component]) };
                let name = format!("MRZP {} offset {rank}", XYZ[component]);
                Row::new((number + component).to_string(), name, expected)
            };
            Group::new(
                format!(
                    "Machine coordinates of the centre line of {}, the {rank} axis; a point may be anywhere along it.",
                    axis.letter
                ),
                "general knowledge",
                (0..3).map(row).collect(),
            )
            .unverified(DOUBT)
        })
        .into()
}
