//! Haas: settings of the rotary zero point. Their meaning is from general knowledge; the numbers agree with the
//! declaration.

use pp_runtime::machine;
use pp_runtime::nalgebra::Vector3;
use pp_runtime::transformation::SheetControl::Haas;

use super::chains::TableCb;
use super::printed::Printed;
use super::{Position, agrees, rotated, sheet};

machine! {
    /// A table as on the UMC: the centre line of C over that of B.
    pub struct Umc;
    chain: C B | X Y Z;
    d = { C: (0, 2.5, 0), B: (0, 0, d) };
    dims = { d: 50.0 };
}

/// A tilting table about Y carries a rotary table about Z; both rotate left-handed, as ISO 841 has it for tables.
fn tilting_table(b: Vector3<f64>, c: Vector3<f64>, position: &Position) -> Vector3<f64> {
    let rotary = c + rotated(&-Vector3::z(), position.angle('C'), &(position.point - c));
    b + rotated(&-Vector3::y(), position.angle('B'), &(rotary - b)) + position.length
}

/// By settings 255 to 257.
fn older(printed: &Printed, position: &Position) -> Vector3<f64> {
    let [x, y, z] = ["255", "256", "257"].map(|number| printed.value(number));
    tilting_table(Vector3::new(x, 0.0, z), Vector3::new(x, y, 0.0), position)
}

#[test]
fn older_settings_agree() {
    agrees::<Umc>(Haas, older);
    agrees::<machines::SpinnerU5620>(Haas, older);
}

#[test]
fn newer_settings_agree() {
    agrees::<TableCb>(Haas, |printed, position| {
        let b = Vector3::new(printed.value("300"), 0.0, printed.value("302"));
        let c = Vector3::new(printed.value("303"), printed.value("304"), 0.0);
        tilting_table(b, c, position)
    });
}

#[test]
fn a_distance_that_older_settings_do_not_have_is_refused() {
    let zero = "machine_zero = { X = -300, Y = -200, Z = -400 }\n";
    let text = sheet::<TableCb>(Haas, zero).expect("a sheet");
    let words = text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(words.contains("Refused: the centre line of C is 0.5000 mm from that of B along X"), "{text}");
    assert!(!sheet::<Umc>(Haas, zero).expect("a sheet").contains("Refused"));
}

#[test]
fn every_row_is_marked() {
    let text = sheet::<Umc>(Haas, "").expect("a sheet");
    assert!(Printed::read(&text).rows.iter().all(|row| row.unverified));
}
