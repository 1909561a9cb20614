//! Set-up of the part: how it lies on the table, and what words count from.

use std::collections::BTreeMap;

use nalgebra::{Matrix3, Rotation3};

use crate::kinematics::Machine;

use super::axes::solved_rotaries;
use super::read::read_point;
use super::value::{Bound, Quantity, Reader, Section, Shape, Value};
use super::{ClampCodes, LengthMode, ProgramZero, Stock};

pub(super) const PROGRAM_ZEROS: [(&str, ProgramZero); 2] = [("part", ProgramZero::Part), ("table", ProgramZero::Table)];
pub(super) const LENGTH_MODES: [(&str, LengthMode); 2] = [("tip", LengthMode::Tip), ("gauge", LengthMode::Gauge)];

/// A matrix may miss a rotation by this much: seven digits.
const ROUNDED: f64 = 1e-6;

/// Finer than the words of the guard, or wider than any tool is measured, mm.
const LENGTH_TOLERANCE: std::ops::RangeInclusive<f64> = 0.0001..=1.0;

/// A whole turn more or less is none, rad.
const LARGEST_OFFSET: f64 = std::f64::consts::TAU * (1.0 + 1e-12);

const CLAMP: &str = "write `C = { on = \"M10\", off = \"M11\" }`";

const ROTATION: &str =
    "write three angles in degrees, `[rx, ry, rz]`, or the three rows of a matrix, `[[1, 0, 0], [0, 1, 0], [0, 0, 1]]`";

/// Three angles, or three rows of three numbers.
const ROTATIONS: &str = r#"{
    "type": "array", "minItems": 3, "maxItems": 3,
    "items": {
        "anyOf": [
            { "type": "number" },
            { "type": "array", "items": { "type": "number" }, "minItems": 3, "maxItems": 3 }
        ]
    }
}"#;

/// `[rx, ry, rz]`, degrees, for `Rz·Ry·Rx`, or the rows of a matrix.
pub(super) fn part_rotation(r: &mut Reader<'_>, value: Value<'_>) -> Option<Rotation3<f64>> {
    r.note(value, || Shape::Schema(ROTATIONS));
    let entries = r.list(value)?;
    let [x, y, z] = entries[..] else {
        let text = format!("three angles or three rows are needed here, found {}", entries.len());
        r.fault(value.span(), text, Some(ROTATION.to_owned()));
        return None;
    };
    if entries.iter().all(|entry| entry.get_ref().is_array()) {
        return matrix(r, value, [x, y, z]);
    }
    let [x, y, z] = [x, y, z].map(|angle| r.number(angle, Quantity::Plain, Bound::Any));
    let [(sx, cx), (sy, cy), (sz, cz)] = [x?, y?, z?].map(sine_and_cosine);
    let about_x = Matrix3::new(1.0, 0.0, 0.0, 0.0, cx, -sx, 0.0, sx, cx);
    let about_y = Matrix3::new(cy, 0.0, sy, 0.0, 1.0, 0.0, -sy, 0.0, cy);
    let about_z = Matrix3::new(cz, -sz, 0.0, sz, cz, 0.0, 0.0, 0.0, 1.0);
    Some(Rotation3::from_matrix_unchecked(about_z * about_y * about_x))
}

/// Codes that switch the clamps of rotary axes.
pub(super) fn clamps<M: Machine>(r: &mut Reader<'_>, value: Option<Value<'_>>) -> BTreeMap<char, ClampCodes> {
    let mut clamps = BTreeMap::new();
    for (axis, value) in solved_rotaries::<M>(r, value) {
        let mut section = Section::of(r, format!("clamp.{}", axis.letter), Some(value));
        let [on, off] = ["on", "off"].map(|key| section.get(key).and_then(|value| clamp_code(r, value)));
        section.finish(r);
        match (on, off) {
            (Some(on), Some(off)) if on != off => drop(clamps.insert(axis.letter, ClampCodes { on, off })),
            _ => r.fault(value.span(), "two different codes are needed here", Some(CLAMP.to_owned())),
        }
    }
    clamps
}

/// An M code, perhaps with parameters that move nothing.
fn clamp_code(r: &mut Reader<'_>, value: Value<'_>) -> Option<String> {
    let code = r.line(value)?;
    let number = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    let mut words = code.split(' ');
    let first = words.next().and_then(|word| word.strip_prefix('M')).is_some_and(number);
    if first && words.all(|word| word.strip_prefix(['P', 'Q', 'L', 'E']).is_some_and(number)) {
        return Some(code);
    }
    r.fault(value.span(), format!("\"{code}\" is not an M code"), Some(CLAMP.to_owned()));
    None
}

/// The box around the blank: both corners, or none.
pub(super) fn stock(r: &mut Reader<'_>, section: &mut Section<'_>, table: Option<Value<'_>>) -> Option<Stock> {
    let [lower, upper] = ["stock.lower", "stock.upper"].map(|key| section.get(key));
    let corners = [lower, upper].map(|corner| corner.and_then(|corner| read_point(r, corner)));
    let [Some(lower), Some(upper)] = corners else {
        if lower.is_some() != upper.is_some() {
            let help = "lower = [-50, -40, -30] and upper = [50, 40, 0]".to_owned();
            r.fault(table.map_or(0..0, |table| table.span()), "both corners of the blank are needed", Some(help));
        }
        return None;
    };
    if (0..3).any(|index| lower[index] >= upper[index]) {
        r.fault(table.map_or(0..0, |table| table.span()), "this blank is empty: `lower` is its lowest corner", None);
        return None;
    }
    Some(Stock { lower, upper })
}

/// By how much the length in the control's table may differ.
pub(super) fn length_tolerance(r: &mut Reader<'_>, value: Value<'_>) -> Option<f64> {
    let tolerance = r.length(value, Bound::Positive)?;
    if !LENGTH_TOLERANCE.contains(&tolerance) {
        let (low, high) = (LENGTH_TOLERANCE.start(), LENGTH_TOLERANCE.end());
        r.fault(value.span(), format!("a tolerance of {low} to {high} mm is needed here"), None);
    }
    Some(tolerance)
}

/// What the words of rotary axes count from.
pub(super) fn rotary_offset<M: Machine>(r: &mut Reader<'_>, value: Option<Value<'_>>) -> BTreeMap<char, f64> {
    let mut offsets = BTreeMap::new();
    for (axis, value) in solved_rotaries::<M>(r, value) {
        let Some(offset) = r.number(value, Quantity::Angle, Bound::Any) else { continue };
        if offset.abs() > LARGEST_OFFSET {
            r.fault(value.span(), "an offset of at most 360 degrees is needed here", None);
        }
        offsets.insert(axis.letter, offset);
    }
    offsets
}

/// Sine and cosine of an angle in degrees; exact where the table is turned by quarters.
fn sine_and_cosine(degrees: f64) -> (f64, f64) {
    let rest = degrees.rem_euclid(360.0);
    match [0.0, 90.0, 180.0, 270.0].iter().position(|quarter| (rest - quarter).abs() < f64::EPSILON) {
        Some(0) => (0.0, 1.0),
        Some(1) => (1.0, 0.0),
        Some(2) => (0.0, -1.0),
        Some(_) => (-1.0, 0.0),
        None => rest.to_radians().sin_cos(),
    }
}

fn matrix(r: &mut Reader<'_>, value: Value<'_>, rows: [Value<'_>; 3]) -> Option<Rotation3<f64>> {
    let mut matrix = Matrix3::zeros();
    for (index, row) in rows.into_iter().enumerate() {
        let numbers = r.list(row)?;
        let [x, y, z] = numbers[..] else {
            let text = format!("three numbers are needed in a row, found {}", numbers.len());
            r.fault(row.span(), text, Some(ROTATION.to_owned()));
            return None;
        };
        let [x, y, z] = [x, y, z].map(|number| r.number(number, Quantity::Plain, Bound::Any));
        matrix.set_row(index, &[x?, y?, z?].into());
    }
    let off = (matrix * matrix.transpose() - Matrix3::identity()).abs().max();
    let wrong = match matrix.determinant() {
        _ if off.is_nan() || off > ROUNDED => {
            Some(format!("this matrix is no rotation: its rows miss unit length or right angles by {off:.1e}"))
        }
        determinant if determinant < 0.0 => {
            Some("this matrix mirrors the part: one of its rows points the other way".to_owned())
        }
        _ => None,
    };
    if let Some(wrong) = wrong {
        r.fault(value.span(), wrong, Some(ROTATION.to_owned()));
        return None;
    }
    // The nearest rotation: half of what is left is taken away twice as fast with every step.
    let inverse = |matrix: Matrix3<f64>| matrix.try_inverse().unwrap_or(matrix);
    let nearest = (0..2).fold(matrix, |matrix, _| (matrix + inverse(matrix.transpose())) * 0.5);
    Some(Rotation3::from_matrix_unchecked(if off > 0.0 { nearest } else { matrix }))
}

#[cfg(test)]
mod tests {
    use super::super::Config;
    use super::super::sample::Sample;
    use super::*;

    fn rotation(text: &str) -> Rotation3<f64> {
        let config = Config::read::<Sample>(&format!("part_rotation = {text}\n"));
        config.unwrap_or_else(|faults| panic!("{faults:#?}")).set_up.part_rotation
    }

    fn fault(text: &str) -> String {
        let faults = Config::read::<Sample>(&format!("part_rotation = {text}\n")).expect_err("it is wrong");
        assert_eq!(faults.len(), 1);
        faults[0].text.clone()
    }

    #[test]
    fn the_part_is_turned_about_x_first_and_about_z_last() {
        let turned = rotation("[30, 45, 60]").into_inner();
        let about = |axis, degrees: f64| Rotation3::from_axis_angle(&axis, degrees.to_radians());
        let (x, y, z) = (nalgebra::Vector3::x_axis(), nalgebra::Vector3::y_axis(), nalgebra::Vector3::z_axis());
        let product = about(z, 60.0) * about(y, 45.0) * about(x, 30.0);
        assert!((turned - product.into_inner()).abs().max() < 1e-15);
    }

    #[test]
    fn quarters_of_a_turn_are_exact() {
        // Ry(-90)·Rx(180): X goes to Z, Y to -Y, Z to X.
        let exact = Matrix3::new(0.0, 0.0, 1.0, 0.0, -1.0, 0.0, 1.0, 0.0, 0.0);
        assert_eq!(rotation("[180, -90, 0]").into_inner(), exact);
    }

    #[test]
    fn a_matrix_of_seven_digits_becomes_the_rotation_it_was_rounded_from() {
        let turned = rotation("[[0.8660254, -0.5, 0], [0.5, 0.8660254, 0], [0, 0, 1]]").into_inner();
        assert!((turned * turned.transpose() - Matrix3::identity()).abs().max() < 1e-15);
        assert!((turned[(0, 0)] - 0.75_f64.sqrt()).abs() < 1e-7);
        assert_eq!(
            rotation("[[0, 0, 1], [1, 0, 0], [0, 1, 0]]").into_inner(),
            Matrix3::new(0., 0., 1., 1., 0., 0., 0., 1., 0.)
        );
    }

    #[test]
    fn a_matrix_that_is_no_rotation_is_refused() {
        assert!(fault("[[1, 0, 0], [0, 1, 0], [0, 0, 1.001]]").contains("no rotation"));
        assert!(fault("[[1, 0, 0], [0.1, 1, 0], [0, 0, 1]]").contains("no rotation"));
        assert!(fault("[[1e300, 0, 0], [0, 1, 0], [0, 0, 1]]").contains("no rotation"));
        assert!(fault("[[-1, 0, 0], [0, 1, 0], [0, 0, 1]]").contains("mirrors"));
        assert!(fault("[[1, 0], [0, 1, 0], [0, 0, 1]]").contains("in a row"));
        assert!(fault("[1, 2]").contains("three angles or three rows"));
        assert!(fault("90").contains("a list"));
    }

    #[test]
    fn program_zero_and_length_mode_are_words() {
        let config = Config::read::<Sample>("program_zero = 'table'\nlength_mode = 'gauge'\n").expect("right");
        assert_eq!((config.set_up.program_zero, config.set_up.length_mode), (ProgramZero::Table, LengthMode::Gauge));
        assert!(Config::read::<Sample>("length_mode = 'spindle'\n").is_err());
    }

    #[test]
    fn the_length_guard_can_be_forced_and_widened() {
        let read = |text: &str| Config::read::<Sample>(text);
        let config = read("length_guard = true\nlength_tolerance = 0.05\n").expect("right");
        assert_eq!((config.motion.guards.length_guard, config.motion.guards.length_tolerance), (Some(true), 0.05));
        assert!(read("length_tolerance = 0.00001\n").is_err() && read("length_tolerance = 5\n").is_err());
    }

    #[test]
    fn a_blank_has_two_corners() {
        let read = |text: &str| Config::read::<Sample>(&format!("[stock]\n{text}\n"));
        let config = read("lower = [-5, -4, -3]\nupper = [5, 4, 0]").expect("right");
        assert_eq!(config.set_up.stock, Some(Stock { lower: [-5.0, -4.0, -3.0], upper: [5.0, 4.0, 0.0] }));
        assert_eq!(read("").expect("right").set_up.stock, None);
        for wrong in ["lower = [-5, -4, -3]", "lower = [-5, -4, 0]\nupper = [5, 4, 0]", "lower = 5\nupper = [5, 4, 0]"]
        {
            assert_eq!(read(wrong).expect_err("wrong").len(), 1, "{wrong}");
        }
    }

    #[test]
    fn a_clamp_has_two_m_codes() {
        let read = |text: &str| Config::read::<Sample>(&format!("[clamp]\n{text}\n"));
        let config = read("C = { on = 'M10', off = 'M64 P1' }").expect("right");
        assert_eq!(config.motion.rotaries.clamp[&'C'], ClampCodes { on: "M10".to_owned(), off: "M64 P1".to_owned() });
        for wrong in [
            "C = { on = 'M10' }",
            "C = { on = 'M10', off = 'M10' }",
            "C = { on = 'G0 X5', off = 'M11' }",
            "C = { on = 'M10 X5', off = 'M11' }",
            "X = { on = 'M10', off = 'M11' }",
            "C = 'M10'",
        ] {
            assert!(read(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn an_offset_belongs_to_a_rotary_axis_that_is_solved() {
        let read = |text: &str| Config::read::<Sample>(&format!("[rotary_offset]\n{text}\n"));
        let config = read("C = 12.5").expect("right");
        assert!((config.set_up.rotary_offset[&'C'].to_degrees() - 12.5).abs() < 1e-12);
        assert_eq!(read("X = 1").expect_err("linear")[0].text, "X is no rotary axis that is solved");
        assert!(read("C = 361").is_err() && read("C = 360").is_ok());
    }
}
