//! Siemens: swivel data record and machine data.

use approx::abs_diff_eq;
use pp_runtime::kinematics::Machine;
use pp_runtime::nalgebra::Vector3;
use pp_runtime::transformation::SheetControl::Siemens;

use super::chains::{
    HeadAbReversed, HeadCa, HeadInXy, HeadTable, HeadTableInclined, Horizontal, NutatingHead, NutatingTable, Quill,
    SingleHead, SingleTable, TableAb, TableCaReversed, TableCb, TableInZx,
};
use super::printed::Printed;
use super::{Position, agrees, rotated, sheet};

/// Kinematic type, offsets `l1` to `l4` and vectors `v1`, `v2` of a toolholder that can be oriented.
pub(crate) struct Carrier {
    pub(crate) kind: char,
    pub(crate) l: [Vector3<f64>; 4],
    pub(crate) v: [Vector3<f64>; 2],
}

impl Carrier {
    /// `$TC_CARR1` to `$TC_CARR23` by NC programming 12/2019 p. 779.
    pub(crate) fn of_record(printed: &Printed) -> Self {
        let vector = |first: usize| printed.vector(|component| format!("$TC_CARR{}[m]", first + component));
        Self {
            kind: printed.row("$TC_CARR23[m]").expected.chars().next().expect("a type"),
            l: [1, 4, 15, 18].map(vector),
            v: [7, 10].map(vector),
        }
    }

    /// Machine data of TRAORI by IM9 12/2017 p. 572, with MD24560 between the two axes of a table.
    pub(crate) fn of_machine_data(printed: &Printed) -> Self {
        let array = |number: u32| printed.vector(|component| format!("MD{number}[{component}]"));
        let none = Vector3::zeros();
        let (kind, l) = match printed.value("MD24100") as u32 {
            24 => ('T', [array(24500), array(24560), array(24550), none]),
            40 => ('P', [none, array(24550), array(24560), array(24500)]),
            56 => ('M', [array(24560), array(24550), array(24558), array(24500)]),
            other => panic!("type {other}"),
        };
        Self { kind, l, v: [24570, 24572].map(array) }
    }

    /// From the tip to the reference point of the toolholder: W1 08/2005 p. 2-88, fig. 2-42.
    pub(crate) fn tool(&self, angles: [f64; 2], length: &Vector3<f64>) -> Vector3<f64> {
        let [l1, l2, l3, _] = self.l;
        match self.kind {
            'T' => l1 + self.first(angles, &(l2 + self.second(angles, &(l3 + length)))),
            'M' => l1 + self.first(angles, &(l2 + length)),
            _ => *length,
        }
    }

    /// Position of a workpiece point that is at `point` in the initial setting: W1 08/2005 p. 2-89, fig. 2-43.
    pub(crate) fn workpiece(&self, angles: [f64; 2], point: &Vector3<f64>) -> Vector3<f64> {
        let [_, l2, l3, l4] = self.l;
        match self.kind {
            'P' => l2 + self.first(angles, &(l3 + self.second(angles, &(l4 + point)))),
            'M' => l3 + self.second(angles, &(l4 + point)),
            _ => *point,
        }
    }

    fn first(&self, angles: [f64; 2], vector: &Vector3<f64>) -> Vector3<f64> {
        rotated(&self.v[0], angles[0], vector)
    }

    fn second(&self, angles: [f64; 2], vector: &Vector3<f64>) -> Vector3<f64> {
        rotated(&self.v[1], angles[1], vector)
    }

    fn machine(&self, angles: [f64; 2], position: &Position) -> Vector3<f64> {
        self.workpiece(angles, &position.point) + self.tool(angles, &position.length)
    }
}

/// Values of the axes that the record names.
fn angles(printed: &Printed, position: &Position) -> [f64; 2] {
    ["$TC_CARR21[m]", "$TC_CARR22[m]"]
        .map(|number| position.angle(printed.row(number).expected.chars().next().expect("an axis")))
}

fn both_agree<M: Machine>() {
    agrees::<M>(Siemens, |printed, position| {
        let (record, data) = (Carrier::of_record(printed), Carrier::of_machine_data(printed));
        let angles = angles(printed, position);
        let found = record.machine(angles, position);
        let own = data.machine(angles, position);
        assert!(abs_diff_eq!(found, own, epsilon = 5e-7), "{}: CYCLE800 and TRAORI differ", M::NAME);
        found
    });
}

#[test]
fn tables_agree() {
    both_agree::<TableCb>();
    both_agree::<TableCaReversed>();
    both_agree::<TableAb>();
    both_agree::<NutatingTable>();
    both_agree::<TableInZx>();
    both_agree::<machines::SpinnerU5620>();
    both_agree::<machines::Dmu70e>();
    both_agree::<Horizontal>();
    both_agree::<Quill>();
}

#[test]
fn heads_agree() {
    both_agree::<HeadCa>();
    both_agree::<HeadAbReversed>();
    both_agree::<NutatingHead>();
    both_agree::<HeadInXy>();
    both_agree::<machines::LolaXoyzba>();
}

#[test]
fn a_head_with_a_table_agrees() {
    both_agree::<HeadTable>();
    both_agree::<HeadTableInclined>();
}

#[test]
fn single_axes_agree() {
    both_agree::<SingleTable>();
    both_agree::<SingleHead>();
}

/// F2 06/2019 p. 148: types with axes parallel to the coordinates, the fourth axis first.
#[test]
fn types_of_md24100_are_those_of_the_manual() {
    fn types<M: Machine>() -> (f64, String) {
        let text = sheet::<M>(Siemens, "").expect("a sheet");
        let words = text.split_whitespace().collect::<Vec<_>>().join(" ");
        let other = words.split("; or ").nth(2).map_or("none", |rest| rest.split(',').next().expect("a number"));
        (Printed::read(&text).value("MD24100"), other.to_owned())
    }
    // Machine type 1: CA 20. Type 2: BC 35, AC 33, BA 34. Type 3: BC 51.
    assert_eq!(types::<HeadCa>(), (24.0, "20".to_owned()));
    assert_eq!(types::<HeadAbReversed>(), (24.0, "16".to_owned()));
    assert_eq!(types::<machines::LolaXoyzba>(), (24.0, "18".to_owned()));
    assert_eq!(types::<TableCb>(), (40.0, "35".to_owned()));
    assert_eq!(types::<TableCaReversed>(), (40.0, "33".to_owned()));
    assert_eq!(types::<TableAb>(), (40.0, "34".to_owned()));
    assert_eq!(types::<HeadTable>(), (56.0, "51".to_owned()));
    assert_eq!(types::<NutatingHead>(), (24.0, "none".to_owned()));
    assert_eq!(types::<NutatingTable>(), (40.0, "none".to_owned()));
    assert_eq!(types::<SingleTable>(), (40.0, "none".to_owned()));
}

#[test]
fn machine_coordinates_are_not_guessed() {
    let text = sheet::<TableCb>(Siemens, "units = \"mm\"\nmachine_zero = { X = -310.5, Z = -20 }\n").expect("a sheet");
    let printed = Printed::read(&text);
    let expected = |number: &str| printed.row(number).expected.as_str().to_owned();
    assert_eq!(expected("$TC_CARR4[m]"), "-310.5000");
    assert_eq!(expected("$TC_CARR5[m]"), "needs machine_zero");
    assert_eq!(expected("$TC_CARR19[m]"), "needs machine_zero");
    assert_eq!(expected("MD24500[1]"), "needs machine_zero");
    assert_eq!(expected("$TC_CARR16[m]"), "-12.0000", "a distance of the machine needs nothing");
}

#[test]
fn what_no_manual_settles_is_marked() {
    let printed = Printed::read(&sheet::<TableCb>(Siemens, "").expect("a sheet"));
    let marked: Vec<&str> = printed.rows.iter().filter(|row| row.unverified).map(|row| row.number.as_str()).collect();
    let arrays = ["MD24510", "MD24520", "MD24558", "MD24560", "MD24574"];
    assert!(marked.iter().all(|number| arrays.iter().any(|array| number.starts_with(array))), "{marked:?}");
    assert!(arrays.iter().all(|array| marked.iter().any(|number| number.starts_with(array))), "{marked:?}");
    // With a head MD24560 is as the manual prints it.
    let head = Printed::read(&sheet::<HeadCa>(Siemens, "").expect("a sheet"));
    assert!(!head.row("MD24560[0]").unverified && head.rows.iter().all(|row| !row.number.starts_with("MD24558")));
}
