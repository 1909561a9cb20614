//! The page of a program, read as a browser reads it: its data decoded, and the machine of its head multiplied out.

use std::collections::BTreeMap;
use std::io::Read as _;

use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use flate2::read::DeflateDecoder;
use nalgebra::{Matrix4, Vector3, Vector4};
use serde_json::Value;

use crate::oracle::{rotation_about, translation};

/// Data of a page.
#[derive(Debug)]
pub struct Page {
    /// The head, as JSON.
    pub head: Value,
    /// Columns by name.
    pub columns: BTreeMap<String, Vec<f64>>,
    /// The program.
    pub program: String,
    /// The CL data.
    pub cl: String,
}

/// Content of the element with an id.
fn element<'h>(html: &'h str, id: &str) -> &'h str {
    let (_, rest) = html.split_once(&format!("id=\"{id}\">")).unwrap_or_else(|| panic!("no element {id}"));
    rest.split_once("</script>").expect("it ends").0
}

fn unpacked(base64: &str) -> Vec<u8> {
    let bytes = BASE64_STANDARD.decode(base64).expect("base64");
    let mut plain = Vec::new();
    DeflateDecoder::new(&*bytes).read_to_end(&mut plain).expect("DEFLATE");
    plain
}

/// A number of the head.
///
/// # Panics
/// If it is none.
#[must_use]
pub fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

fn vector(value: &Value) -> Vector3<f64> {
    Vector3::from_fn(|row, _| number(&value[row]))
}

impl Page {
    /// Decodes a page.
    ///
    /// # Panics
    /// If it is not a page.
    #[must_use]
    pub fn decoded(html: &str) -> Self {
        let head: Value = serde_json::from_str(element(html, "program-head")).expect("JSON");
        let bytes = unpacked(element(html, "program-columns"));
        let count = number(&head["points"]) as usize;
        let (mut columns, mut rest) = (BTreeMap::new(), &*bytes);
        for column in head["columns"].as_array().expect("columns") {
            let name = column["name"].as_str().expect("a name").to_owned();
            let width = match column["type"].as_str() {
                Some("u8") => 1,
                Some("u16") => 2,
                Some("f32" | "q32") => 4,
                other => panic!("{other:?} is no type of a column"),
            };
            let (these, others) = rest.split_at(count * width);
            rest = others;
            let mut sum = 0;
            let mut value = |bytes: &[u8]| match (width, column["type"] == "q32") {
                (1, _) => f64::from(bytes[0]),
                (2, _) => f64::from(u16::from_le_bytes([bytes[0], bytes[1]])),
                (_, false) => f64::from(f32::from_le_bytes(bytes.try_into().expect("four bytes"))),
                (_, true) => {
                    sum += i32::from_le_bytes(bytes.try_into().expect("four bytes"));
                    f64::from(sum) * number(&column["scale"])
                }
            };
            // A column has the lowest bytes of all its values first.
            let values = (0..count).map(|index| these.iter().skip(index).step_by(count).copied().collect::<Vec<u8>>());
            columns.insert(name, values.map(|bytes| value(&bytes)).collect());
        }
        assert!(rest.is_empty(), "{} bytes after the last column", rest.len());
        let text = |id: &str| String::from_utf8_lossy(&unpacked(element(html, id))).into_owned();
        Self { program: text("program-text"), cl: text("cl-text"), head, columns }
    }

    /// Number of points.
    #[must_use]
    pub fn points(&self) -> usize {
        self.columns["line"].len()
    }

    /// Value of a column at a point.
    #[must_use]
    pub fn at(&self, column: &str, point: usize) -> f64 {
        self.columns[column][point]
    }

    /// Line of the program of a point.
    #[must_use]
    pub fn line(&self, point: usize) -> u64 {
        self.at("line", point) as u64
    }

    /// Name of the kind of a point.
    ///
    /// # Panics
    /// If the kind has no name.
    #[must_use]
    pub fn kind(&self, point: usize) -> &str {
        self.head["kinds"][self.at("kind", point) as usize].as_str().expect("a name")
    }

    /// Why a point is there; `None` if it is unknown.
    #[must_use]
    pub fn reason(&self, point: usize) -> Option<&str> {
        self.head["reasons"][self.at("reason", point) as usize].as_str()
    }

    /// Tip at a point, mm.
    #[must_use]
    pub fn tip(&self, point: usize) -> Vector3<f64> {
        Vector3::from_iterator(["tip.x", "tip.y", "tip.z"].map(|name| self.at(name, point)))
    }

    /// Tool axis at a point.
    #[must_use]
    pub fn tool_axis(&self, point: usize) -> Vector3<f64> {
        Vector3::from_iterator(["tool.i", "tool.j", "tool.k"].map(|name| self.at(name, point)))
    }

    /// Point of the CL data that a feed block ends on; `None` where the block is an inserted one, or its record no
    /// GOTO.
    ///
    /// # Panics
    /// If the CL data is not understood.
    #[must_use]
    pub fn record_of(&self, point: usize) -> Option<Vector3<f64>> {
        let ends = point + 1 == self.points() || self.line(point) < self.line(point + 1);
        let is_record = self.kind(point) == "feed" && self.reason(point) == Some("record");
        let record = self.cl.lines().nth(self.at("cl_line", point) as usize - 1)?.strip_prefix("GOTO/")?;
        let numbers = record.split(',').take(3).map(|text| text.trim().parse().expect("a number"));
        (ends && is_record).then(|| Vector3::from_iterator(numbers))
    }

    /// Axis values at a point in the order of the joints, mm and degrees.
    ///
    /// # Panics
    /// If the head is not that of a page.
    #[must_use]
    pub fn axes(&self, point: usize) -> Vec<f64> {
        let joints = self.head["machine"]["joints"].as_array().expect("joints");
        let letters = joints.iter().map(|joint| joint["letter"].as_str().expect("a letter"));
        letters.map(|letter| self.at(&format!("axis.{letter}"), point)).collect()
    }

    /// Tip and tool axis of the machine at a point: the product of its joints as the head has them.
    ///
    /// # Panics
    /// If the head is not that of a page.
    #[must_use]
    pub fn multiplied(&self, point: usize) -> (Vector3<f64>, Vector3<f64>) {
        let machine = &self.head["machine"];
        let points = &self.head["placements"][self.at("placement", point) as usize]["points"];
        let joints = machine["joints"].as_array().expect("joints");
        let mut product = Matrix4::identity();
        for (index, (joint, value)) in joints.iter().zip(self.axes(point)).enumerate() {
            let (direction, value) = (vector(&joint["direction"]), number(&joint["sign"]) * value);
            product *= if joint["rotary"] == true {
                rotation_about(&vector(&points[index]), &direction, value.to_radians())
            } else {
                translation(&(direction * value))
            };
        }
        let tip = product * Vector4::new(0.0, 0.0, 0.0, 1.0);
        let axis = product * vector(&machine["tool_axis"]).push(0.0);
        (tip.xyz(), axis.xyz())
    }
}
