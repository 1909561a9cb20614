//! Keys of solids.
#![expect(unreachable_pub, reason = "the table of the keys of a solid makes a public struct")]

use nalgebra::Rotation3;
use serde_json::{Value as Json, json};

use crate::keys::{
    Bound, KeyKind, KeyList, KeyReader, KeyScope, KeyTable, Keys, LengthPoint, ListOf, Measure, OneLine, OneOf,
    Printed, TomlValue, Whole, list, options, printed_number,
};
use crate::kinematics::Axis;
use crate::program::Units;

use super::super::MOST_FRAMES;
use super::super::part_rotation::PartRotation;
use super::{Solid, SolidShape, Solids};

options! {
    /// Keys of a solid.
    pub struct SolidKeys {
        /// Name for findings and `allow`.
        name: Option<String> = None, key("name", OneLine, "\"vise\"");
        /// STL file; its name counts from the folder of this file.
        stl: Option<String> = None, key("stl", OneLine, "\"vise.stl\"");
        /// Unit of the STL file: "mm" or "in".
        unit: Units = Units::Millimetres, key("unit", OneOf(&Units::NAMES));
        /// Largest distance of the triangles of the STL file from the real surface.
        tolerance_mm: f64 = 0.0, key("tolerance", Measure::length(Bound::NotNegative));
        /// Two opposite corners of a box.
        corners: Vec<[f64; 3]> = Vec::new(), key("box", ListOf(LengthPoint));
        /// Diameter and height of a cylinder along Z, from Z0 up.
        cylinder: Vec<f64> = Vec::new(), key("cylinder", ListOf(Measure::length(Bound::Positive)));
        /// Closed outline that is rotated about Z: diameter and height of each corner.
        turned: Vec<Vec<f64>> = Vec::new(), key("turned", ListOf(ListOf(Measure::length(Bound::Any))));
        /// Rotation of the solid, `[rx, ry, rz]` in degrees, or a matrix.
        rotation: Rotation3<f64> = Rotation3::identity(), key("rotate", PartRotation);
        /// Place of its zero, after the rotation.
        at_mm: [f64; 3] = [0.0; 3], key("at", LengthPoint);
        /// Set-ups in which it is on the table; without them in all.
        set_ups: Vec<u32> = Vec::new(), key("set_ups", ListOf(Whole(1..=MOST_FRAMES)));
    }
}

/// Kind of key: one solid; with the name of the key.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SolidKind(pub(super) &'static str);

impl KeyKind for SolidKind {
    type Value = Solid;

    fn read(&self, r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<Solid> {
        read_solid(r, self.0, value)
    }

    fn print(&self, _value: &Solid) -> String {
        "{}".to_owned()
    }

    fn schema(&self, scope: &KeyScope) -> Json {
        json!({ "anyOf": solid_schemas(scope) })
    }
}

/// Kind of key: solids, one or a list; with the name of the key and an example.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SolidList(pub(super) &'static str, pub(super) &'static str);

impl KeyKind for SolidList {
    type Value = Vec<Solid>;

    fn read(&self, r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<Vec<Solid>> {
        if value.get_ref().is_array() {
            let values = r.list(value)?;
            return Some(values.into_iter().filter_map(|value| read_solid(r, self.0, value)).collect());
        }
        Some(read_solid(r, self.0, value).into_iter().collect())
    }

    fn print(&self, _value: &Vec<Solid>) -> String {
        "[]".to_owned()
    }

    fn schema(&self, scope: &KeyScope) -> Json {
        let [name, table] = solid_schemas(scope);
        let list = json!({ "type": "array", "items": { "anyOf": [name, table] } });
        json!({ "anyOf": [name, table, list] })
    }

    fn printed(&self, _scope: &KeyScope) -> Option<Printed> {
        Some(Printed::Example(self.1.to_owned()))
    }
}

/// Kind of key: pairs of names.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Pairs;

impl KeyKind for Pairs {
    type Value = Vec<[String; 2]>;

    fn read(&self, r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<Vec<[String; 2]>> {
        let mut pairs = Vec::new();
        for pair in r.list(value)? {
            let names = r.list(pair)?;
            let &[one, two] = names.as_slice() else {
                r.fault(pair.span(), "two names are needed here, `[\"C\", \"B\"]`", None);
                return None;
            };
            let [one, two] = [one, two].map(|name| r.line(name));
            pairs.push([one?, two?]);
        }
        Some(pairs)
    }

    fn print(&self, value: &Vec<[String; 2]>) -> String {
        let pairs: Vec<String> = value.iter().map(|[one, two]| format!("[\"{one}\", \"{two}\"]")).collect();
        format!("[{}]", pairs.join(", "))
    }

    fn schema(&self, _scope: &KeyScope) -> Json {
        let pair = json!({ "type": "array", "items": { "type": "string" }, "minItems": 2, "maxItems": 2 });
        json!({ "type": "array", "items": pair })
    }
}

/// Kind of key: the table of solids, with a key for each axis of the machine.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SolidTable;

impl KeyKind for SolidTable {
    type Value = Solids;

    fn read(&self, r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<Solids> {
        let mut table = KeyTable::of(r, "solids", Some(value));
        let mut solids = Solids::default();
        solids.read(&mut table, r);
        for axis in r.scope().axes {
            let kind = axis_solids(axis.letter);
            if let Some(value) = table.get(kind.0, r)
                && let Some(read) = kind.read(r, value)
            {
                solids.axes.insert(axis.letter, read);
            }
        }
        table.close(r);
        let known = known_names(&solids, r.scope());
        if let Some(pairs) = table.get("allow", r) {
            for name in solids.allow.iter().flatten().filter(|name| !known.contains(name)) {
                let help = format!("names are {}", list(known.iter().map(String::as_str), '"'));
                r.fault(pairs.span(), format!("\"{name}\" is no solid"), Some(help));
            }
        }
        let set_ups =
            solids.frame.iter().chain(&solids.spindle).chain(&solids.table).chain(solids.axes.values().flatten());
        if set_ups.chain(&solids.stock).chain(&solids.design).any(|solid| !solid.set_ups.is_empty()) {
            r.fault(value.span(), "`set_ups` is for `fixtures` only", None);
        }
        Some(solids)
    }

    fn print(&self, _value: &Solids) -> String {
        "{}".to_owned()
    }

    fn schema(&self, scope: &KeyScope) -> Json {
        let mut schema = KeyList::of(&Solids::default(), *scope).schema();
        if let Some(properties) = schema.get_mut("properties").and_then(Json::as_object_mut) {
            for axis in scope.axes {
                let mut solids = axis_solids(axis.letter).schema(scope);
                solids["description"] = json!(format!("Solids that {} moves.", axis.letter));
                properties.insert(axis.letter.to_string(), solids);
            }
        }
        Json::Object(schema)
    }

    fn printed(&self, scope: &KeyScope) -> Option<Printed> {
        let list = KeyList::of(&Solids::default(), *scope);
        let rows = list.rows().iter().map(|row| (row.path.to_owned(), row.printed.clone()));
        let axis = |axis: &Axis| {
            let file = format!("\"{}.stl\"", axis.letter.to_lowercase());
            (axis.letter.to_string(), Printed::Example(file))
        };
        Some(Printed::Section(rows.chain(scope.axes.iter().map(axis)).collect()))
    }

    fn counts(&self) -> bool {
        false
    }
}

/// Kind of the key of an axis.
fn axis_solids(letter: char) -> SolidList {
    let keys = ["X", "Y", "Z", "U", "V", "W", "A", "B", "C"];
    SolidList(keys.into_iter().find(|key| key.starts_with(letter)).unwrap_or_default(), "")
}

/// Names that `allow` may have.
fn known_names(solids: &Solids, scope: KeyScope) -> Vec<String> {
    let fixed = ["frame", "table", "fixtures", "spindle", "stock", "tool", "cutter", "shank", "holder"];
    let axes = scope.axes.iter().map(|axis| axis.letter.to_string());
    let own = solids.of_machine().filter_map(|(_, solid)| solid.own_name());
    fixed.into_iter().map(str::to_owned).chain(axes).chain(own).collect()
}

/// Schemas of a solid: the name of a file, or a table.
fn solid_schemas(scope: &KeyScope) -> [Json; 2] {
    [json!({ "type": "string" }), Json::Object(KeyList::of(&SolidKeys::default(), *scope).schema())]
}

/// Reads a solid: a table, or the name of an STL file.
fn read_solid(r: &mut KeyReader<'_>, key: &str, value: TomlValue<'_>) -> Option<Solid> {
    let mut keys = SolidKeys::default();
    if value.get_ref().is_str() {
        keys.stl = Some(r.line(value)?);
    } else {
        let mut table = KeyTable::of(r, format!("solids.{key}"), Some(value));
        keys.read(&mut table, r);
        table.close(r);
    }
    let mut fault = |text: &str, help: &str| {
        r.fault(value.span(), text.to_owned(), Some(help.to_owned()));
        None
    };
    let given = [keys.stl.is_some(), !keys.corners.is_empty(), !keys.cylinder.is_empty(), !keys.turned.is_empty()];
    if given.iter().filter(|given| **given).count() != 1 {
        return fault("a solid has one shape", "give one of `stl`, `box`, `cylinder` and `turned`");
    }
    let shape = if let Some(file) = keys.stl {
        SolidShape::Stl { file, unit_mm: keys.unit.in_mm() }
    } else if !keys.corners.is_empty() {
        let &[one, two] = keys.corners.as_slice() else {
            return fault("a box has two corners", "box = [[-90.0, -60.0, 0.0], [90.0, 60.0, 40.0]]");
        };
        let (low, high) = (
            std::array::from_fn(|axis| one[axis].min(two[axis])),
            std::array::from_fn(|axis| one[axis].max(two[axis])),
        );
        if (0..3).any(|axis| low[axis] >= high[axis]) {
            return fault("this box is empty", "its corners must differ in X, Y and Z");
        }
        SolidShape::Box([low, high])
    } else if !keys.cylinder.is_empty() {
        let &[diameter, height] = keys.cylinder.as_slice() else {
            return fault("a cylinder has a diameter and a height", "cylinder = [320.0, 60.0]");
        };
        SolidShape::Cylinder { diameter, height }
    } else {
        let corners: Option<Vec<[f64; 2]>> =
            keys.turned.iter().map(|corner| corner.as_slice().try_into().ok()).collect();
        let Some(corners) = corners.filter(|corners| corners.len() > 2) else {
            return fault(
                "an outline has at least three corners, each a diameter and a height",
                "turned = [[0.0, 0.0], [60.0, 0.0], [60.0, 80.0], [0.0, 80.0]]",
            );
        };
        if let Some(what) = wrong_outline(&corners) {
            return fault(
                &what,
                "diameters are not negative, and the outline is a closed line that does not cross itself",
            );
        }
        SolidShape::Turned(corners)
    };
    let SolidKeys { name, rotation, at_mm, tolerance_mm, set_ups, .. } = keys;
    Some(Solid { name, shape, rotation, at_mm, tolerance_mm, set_ups })
}

/// The reason why corners are no outline.
fn wrong_outline(corners: &[[f64; 2]]) -> Option<String> {
    if let Some([diameter, height]) = corners.iter().find(|corner| corner[0] < 0.0) {
        let [diameter, height] = [*diameter, *height].map(printed_number);
        return Some(format!("the corner [{diameter}, {height}] has a negative diameter"));
    }
    let side = |a: [f64; 2], b: [f64; 2], c: [f64; 2]| (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    let count = corners.len();
    let edge = |index: usize| (corners[index], corners[(index + 1) % count]);
    for one in 0..count {
        for two in one + 2..count {
            if one == 0 && two == count - 1 {
                continue;
            }
            let ((a, b), (c, d)) = (edge(one), edge(two));
            if side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0 {
                return Some(format!("edges {} and {} of this outline cross", one + 1, two + 1));
            }
        }
    }
    let area: f64 = (0..count).map(edge).map(|(a, b)| a[0] * b[1] - b[0] * a[1]).sum();
    (area.abs() < 1e-9).then(|| "this outline has no area".to_owned())
}
