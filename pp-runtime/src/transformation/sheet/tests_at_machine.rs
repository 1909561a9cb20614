//! Tests that settle at the machine what a comparison of numbers cannot.

use crate::kinematics::{AnyMachine, AxisKind};

use super::chain::held_axes;
use super::print::BOX;

/// Words of a control for the tests.
pub(super) struct ControlWords {
    /// Name in `--control`.
    pub(super) control: &'static str,
    /// Code that switches tip control on.
    pub(super) tip_control: &'static str,
    /// Function for a tilted plane.
    pub(super) plane: &'static str,
}

/// The three tests: directions, tip control, tilted plane.
pub(super) fn tests(machine: &dyn AnyMachine, words: &ControlWords) -> Vec<Vec<String>> {
    let ControlWords { control, tip_control, plane } = words;
    vec![
        directions(machine),
        vec![
            format!(
                "The tip stays. Clamp a mandrel whose length from the gauge line is in the tool table. Fix a dial gauge or a ball to \
                 the table, and bring the tip to it. Switch {tip_control} on, and rotate one rotary axis alone: a few degrees at first \
                 with the feed override in hand, because a wrong sign moves the slides the wrong way, then through its travel, the \
                 others at zero, then at another angle. The tip must stay where it is, within the accuracy of the machine. With \
                 `mode = \"tcp\"` in the configuration, `explain --proof-program --control {control}` prints a program that does so; \
                 without it the program moves the same axes with the transformation off, and shows whether the declaration is right."
            ),
            "The tip leaves at once, by twice the expected motion: the direction of that axis is wrong. It goes round a circle: the \
             centre line is wrong by the radius. It stays with one length of the mandrel only: the distance along the tool is wrong."
                .to_owned(),
        ],
        vec![format!(
            "The plane is where it should be. Touch the ball on the table at two rotary positions, once with all rotary axes at zero \
             and once tilted with {plane}: its centre must have the same coordinates in the workpiece."
        )],
    ]
}

/// Lines of the jog sheet.
fn directions(machine: &dyn AnyMachine) -> Vec<String> {
    let mut lines = vec![
        "Directions. Switch the transformation off, clear the table, and start as on the jog sheet of `explain`: linear axes in \
         mid-travel, tool clear. Jog each axis alone. A line that is false: the sign in the declaration or the direction of that axis in the control is wrong; correct it before anything else is compared."
            .to_owned(),
    ];
    let held = held_axes(machine);
    let mut wanted = false;
    for line in machine.explanation().jog_sheet.text {
        // `[ ] C+90: the table rotates ..`, and lines that continue it.
        match line.strip_prefix(BOX) {
            Some(rest) => wanted = !rest.starts_with(&held[..]),
            None if !line.starts_with(' ') => wanted = false,
            None => {}
        }
        if !wanted {
            continue;
        }
        match line.strip_prefix(BOX) {
            Some(_) => lines.push((*line).to_owned()),
            None => {
                if let Some(last) = lines.last_mut() {
                    last.push(' ');
                    last.push_str(line.trim());
                }
            }
        }
    }
    if lines.len() == 1 {
        let letters: Vec<String> = machine
            .axes()
            .iter()
            .filter(|axis| axis.kind == AxisKind::Rotary)
            .map(|axis| axis.letter.to_string())
            .collect();
        lines.push(format!("This machine has no jog sheet: see that {} move as declared.", letters.join(" and ")));
    }
    lines
}
