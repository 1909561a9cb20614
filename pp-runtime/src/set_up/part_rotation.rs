//! Kind of key: orientation of the part on the table, as three angles or as a rotation matrix.

use nalgebra::{Matrix3, Rotation3};
use serde_json::{Value as Json, json};

use crate::keys::{Bound, KeyKind, KeyReader, KeyScope, QuantityKind, TomlValue, printed_number};
use crate::kinematics::math;

/// Largest permitted deviation of a matrix from a rotation: rounding to seven digits.
const ROUNDED: f64 = 1e-6;

const ROTATION: &str =
    "write three angles in degrees, `[rx, ry, rz]`, or the three rows of a matrix, `[[1, 0, 0], [0, 1, 0], [0, 0, 1]]`";

/// Kind of key: three angles, or the rows of a rotation matrix.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PartRotation;

impl KeyKind for PartRotation {
    type Value = Rotation3<f64>;

    fn read(&self, r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<Rotation3<f64>> {
        part_rotation(r, value)
    }

    fn print(&self, value: &Rotation3<f64>) -> String {
        format!("[{}]", angles(value).map(printed_number).join(", "))
    }

    fn schema(&self, _scope: &KeyScope) -> Json {
        let row = json!({ "type": "array", "items": { "type": "number" }, "minItems": 3, "maxItems": 3 });
        json!({ "type": "array", "minItems": 3, "maxItems": 3, "items": { "anyOf": [{ "type": "number" }, row] } })
    }
}

/// Reads `[rx, ry, rz]` in degrees for `Rz·Ry·Rx`, or the rows of a matrix.
fn part_rotation(r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<Rotation3<f64>> {
    let entries = r.list(value)?;
    let [x, y, z] = entries[..] else {
        let text = format!("three angles or three rows are needed here, found {}", entries.len());
        r.fault(value.span(), text, Some(ROTATION.to_owned()));
        return None;
    };
    if entries.iter().all(|entry| entry.get_ref().is_array()) {
        return matrix(r, value, [x, y, z]);
    }
    let [x, y, z] = [x, y, z].map(|angle| r.degrees(angle));
    let [(sx, cx), (sy, cy), (sz, cz)] = [x?, y?, z?].map(sine_and_cosine);
    let about_x = Matrix3::new(1.0, 0.0, 0.0, 0.0, cx, -sx, 0.0, sx, cx);
    let about_y = Matrix3::new(cy, 0.0, sy, 0.0, 1.0, 0.0, -sy, 0.0, cy);
    let about_z = Matrix3::new(cz, -sz, 0.0, sz, cz, 0.0, 0.0, 0.0, 1.0);
    Some(Rotation3::from_matrix_unchecked(about_z * about_y * about_x))
}

/// Sine and cosine of an angle in degrees; exact at multiples of 90 degrees.
fn sine_and_cosine(degrees: f64) -> (f64, f64) {
    let rest = degrees.rem_euclid(360.0);
    match [0.0, 90.0, 180.0, 270.0].iter().position(|quarter| (rest - quarter).abs() < f64::EPSILON) {
        Some(0) => (0.0, 1.0),
        Some(1) => (1.0, 0.0),
        Some(2) => (0.0, -1.0),
        Some(_) => (-1.0, 0.0),
        None => math::sin_cos(rest.to_radians()),
    }
}

fn matrix(r: &mut KeyReader<'_>, value: TomlValue<'_>, rows: [TomlValue<'_>; 3]) -> Option<Rotation3<f64>> {
    let mut matrix = Matrix3::zeros();
    for (index, row) in rows.into_iter().enumerate() {
        let numbers = r.list(row)?;
        let [x, y, z] = numbers[..] else {
            let text = format!("three numbers are needed in a row, found {}", numbers.len());
            r.fault(row.span(), text, Some(ROTATION.to_owned()));
            return None;
        };
        let [x, y, z] = [x, y, z].map(|number| r.number(number, QuantityKind::Plain, Bound::Any));
        matrix.set_row(index, &[x?, y?, z?].into());
    }
    let off = (matrix * matrix.transpose() - Matrix3::identity()).abs().max();
    let wrong = match matrix.determinant() {
        _ if off.is_nan() || off > ROUNDED => {
            Some(format!("this matrix is no rotation: its rows differ from perpendicular unit vectors by {off:.1e}"))
        }
        determinant if determinant < 0.0 => {
            Some("this matrix mirrors the part: one of its rows has the wrong sign".to_owned())
        }
        _ => None,
    };
    if let Some(wrong) = wrong {
        r.fault(value.span(), wrong, Some(ROTATION.to_owned()));
        return None;
    }
    // The nearest rotation, by the polar decomposition: M <- (M + M^-T) / 2, which converges quadratically; two steps
    // are enough from `ROUNDED`.
    let inverse = |matrix: Matrix3<f64>| matrix.try_inverse().unwrap_or(matrix);
    let nearest = (0..2).fold(matrix, |matrix, _| (matrix + inverse(matrix.transpose())) * 0.5);
    Some(Rotation3::from_matrix_unchecked(if off > 0.0 { nearest } else { matrix }))
}

/// Angles `[rx, ry, rz]` of a rotation, degrees, rounded to nine decimals.
pub(crate) fn angles(rotation: &Rotation3<f64>) -> [f64; 3] {
    let (x, y, z) = rotation.euler_angles();
    [x, y, z].map(|angle| (angle.to_degrees() * 1e9).round() / 1e9 + 0.0)
}
