//! The C99 header of a machine.

use std::fmt::Write as _;

use crate::kinematics::{AnyMachine, Axis, AxisKind, CSource, Side};

use super::math::PREFIX;
use super::{NotExpressible, complete, math};

/// Forward and inverse kinematics of a machine as a C99 header; all its names begin with `prefix` (see `identifier`).
///
/// Lengths in mm, angles in rad, axes in chain order:
///
/// ```c
/// typedef struct { double part_origin[3], gauge_length; /* dimensions by name */ } p_machine;
/// void p_default(p_machine *m);
/// void p_forward(const p_machine *m, const double *axes, double tip[3], double axis[3]);
/// int p_inverse(const p_machine *m, const double tip[3], const double axis[3], const double *held,
///               double *axes /* [2][n] */);                            /* number of branches */
/// int p_linear_axes(const p_machine *m, const double tip[3], double *axes);    /* 0: no solution */
/// ```
///
/// `p_default` sets the dimensions of this machine, as declared or as set.
///
/// # Errors
/// The machine was not made by `machine!`, or its dimensions are missing or invalid ([`Machine::validate`]).
///
/// [`Machine::validate`]: crate::kinematics::Machine::validate
pub fn c_header(machine: &dyn AnyMachine, prefix: &str) -> Result<String, NotExpressible> {
    complete(machine)?;
    let functions = functions(machine, prefix, &math::own())?;
    let name = machine.name();
    let guard = format!("{}_H", prefix.to_uppercase());
    let mut text = String::new();
    let _ = write!(
        text,
        "/* {name}: kinematics of a machine tool, generated from its declaration; change the declaration, not this file.\n \
         *\n \
         * Chain from workpiece to tool: {chain}.\n \
         * Millimetres and radians. The workpiece frame is at the part zero, along the machine's axes with all of them at\n \
         * zero; with all axes at zero the tool tip is at the part zero. {name} explains the formulas with `explain`.\n \
         */\n\
         #ifndef {guard}\n#define {guard}\n\n#include <math.h>\n#include <stdint.h>\n\n{functions}\n#endif\n",
        chain = chain(machine),
    );
    Ok(text)
}

/// The functions alone, with their prefix; `math` defines sine, cosine and arc tangent.
///
/// # Errors
/// The machine was not made by `machine!`.
pub(super) fn functions(machine: &dyn AnyMachine, prefix: &str, math: &str) -> Result<String, NotExpressible> {
    let CSource { text, fields } = machine.c_source();
    if text.is_empty() {
        return Err(NotExpressible(format!(
            "{} was not declared with `machine!`: its kinematics exist in Rust only",
            machine.name()
        )));
    }
    let dimensions: Vec<(&str, f64)> =
        fields.iter().enumerate().map(|(index, field)| (*field, machine.dimension(index))).collect();
    let mut functions = math.to_owned();
    for line in text.split_inclusive('\n') {
        match assigned(line, &dimensions) {
            Some(assignment) => functions += &assignment,
            None => functions += line,
        }
    }
    Ok(functions.replace(PREFIX, prefix))
}

/// The line that sets a dimension, with the value of this machine.
fn assigned(line: &str, dimensions: &[(&str, f64)]) -> Option<String> {
    let (start, rest) = line.split_once("m->")?;
    let (field, _) = rest.split_once(" = ").filter(|_| start.trim().is_empty())?;
    let (_, value) = dimensions.iter().find(|(name, value)| *name == field && value.is_finite())?;
    Some(format!("{start}m->{field} = {value:?};\n"))
}

/// `C B | X Y Z (C rad, B rad, X mm, Y mm, Z mm)`
pub(super) fn chain(machine: &dyn AnyMachine) -> String {
    let kind = |axis: &Axis| if axis.kind == AxisKind::Linear { "mm" } else { "rad" };
    let units: Vec<String> = machine.axes().iter().map(|axis| format!("{} {}", axis.letter, kind(axis))).collect();
    format!("{} ({})", letters(machine), units.join(", "))
}

/// `C B | X Y Z`
pub(super) fn letters(machine: &dyn AnyMachine) -> String {
    let of = |side: Side| {
        let axes = machine.axes().iter().filter(|axis| axis.side == side);
        axes.map(|axis| axis.letter.to_string()).collect::<Vec<_>>().join(" ")
    };
    format!("{} | {}", of(Side::Workpiece), of(Side::Tool)).trim().to_owned()
}

/// A C identifier from the stem of a file name: letters, digits and `_`; every other character becomes `_`.
///
/// # Errors
/// The name is empty, begins with a digit, or holds no letter.
pub(crate) fn identifier(stem: &str) -> Result<String, NotExpressible> {
    let name: String = stem.chars().map(|letter| if letter.is_ascii_alphanumeric() { letter } else { '_' }).collect();
    let begins_with_a_letter = name.starts_with(|letter: char| letter.is_ascii_alphabetic());
    if begins_with_a_letter {
        return Ok(name);
    }
    Err(NotExpressible(format!("`{stem}` is the prefix of names in C, so it must begin with a letter A to Z")))
}

/// A C identifier from the name of a machine: `spinner_u5620` for `SpinnerU5620`.
///
/// # Errors
/// The name begins with no letter A to Z.
pub(crate) fn machine_identifier(machine: &dyn AnyMachine) -> Result<String, NotExpressible> {
    identifier(&snake_case(machine.name()))
}

/// Words that begin with a capital, joined by `_`; capitals in a row are one word.
fn snake_case(name: &str) -> String {
    let mut snake = String::new();
    let mut before = '_';
    for letter in name.chars() {
        if letter.is_uppercase() && before.is_lowercase() {
            snake.push('_');
        }
        snake.extend(letter.to_lowercase());
        before = letter;
    }
    snake
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_name_of_a_machine_becomes_an_identifier() {
        for (name, identifier) in
            [("SpinnerU5620", "spinner_u5620"), ("DMU70E", "dmu70e"), ("LolaXoyzba", "lola_xoyzba")]
        {
            assert_eq!(snake_case(name), identifier);
        }
    }

    #[test]
    fn a_file_name_becomes_an_identifier() {
        assert_eq!(identifier("spinner-u5-620"), Ok("spinner_u5_620".to_owned()));
        assert_eq!(identifier("Fräse 1"), Ok("Fr_se_1".to_owned()));
        for wrong in ["", "5axis", "-a", "_b", "é"] {
            assert!(identifier(wrong).is_err(), "{wrong}");
        }
    }
}
