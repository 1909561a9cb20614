//! `retract.clearance`: a plane, a box or a cylinder around the part.

use nalgebra::{Point3, Vector3};

use crate::program::{Clearance, Plane};

use super::read::read_point;
use super::value::{Bound, Reader, Shape, Value};

const FORMS: &str = "write `{ plane = 80 }`, `{ box = [[-60, -60, -40], [60, 60, 30]] }` or \
                     `{ cylinder = { radius = 90, lower = -40, upper = 30 } }`";

const SCHEMA: &str = r#"{
    "type": "object", "minProperties": 1, "maxProperties": 1, "additionalProperties": false,
    "properties": {
        "plane": { "type": "number" },
        "box": {
            "type": "array", "minItems": 2, "maxItems": 2,
            "items": { "type": "array", "items": { "type": "number" }, "minItems": 3, "maxItems": 3 }
        },
        "cylinder": {
            "type": "object", "additionalProperties": false, "required": ["radius", "lower", "upper"],
            "properties": {
                "radius": { "type": "number", "exclusiveMinimum": 0 },
                "lower": { "type": "number" },
                "upper": { "type": "number" },
                "centre": { "type": "array", "items": { "type": "number" }, "minItems": 2, "maxItems": 2 }
            }
        }
    }
}"#;

/// Reads one geometry; what is wrong with it is told.
pub(super) fn read(r: &mut Reader<'_>, value: Value<'_>) -> Option<Clearance> {
    r.note(value, || Shape::Schema(SCHEMA));
    let entries = r.entries(value);
    let [(kind, span, value)] = &entries[..] else {
        if value.get_ref().as_table().is_some() {
            r.fault(value.span(), "one geometry is needed here", Some(FORMS.to_owned()));
        }
        return None;
    };
    match *kind {
        "plane" => {
            let distance = r.length(value, Bound::Any)?;
            Some(Clearance::Plane(Plane { normal: Vector3::z_axis(), distance }))
        }
        "box" => read_box(r, value),
        "cylinder" => read_cylinder(r, value),
        other => {
            r.fault(span.clone(), format!("`{other}` is not known here"), Some(FORMS.to_owned()));
            None
        }
    }
}

fn read_box(r: &mut Reader<'_>, value: Value<'_>) -> Option<Clearance> {
    let corners = r.list(value)?;
    let [lower, upper] = corners[..] else {
        r.fault(value.span(), "two corners are needed here", Some(FORMS.to_owned()));
        return None;
    };
    let [lower, upper] = [read_point(r, lower)?, read_point(r, upper)?];
    if (0..3).any(|i| lower[i] >= upper[i]) {
        r.fault(value.span(), "the box is empty: the lower corner comes first", None);
        return None;
    }
    Some(Clearance::Box { lower: Point3::from(lower), upper: Point3::from(upper) })
}

fn read_cylinder(r: &mut Reader<'_>, value: Value<'_>) -> Option<Clearance> {
    let (mut radius, mut lower, mut upper, mut centre) = (None, None, None, [0.0; 2]);
    for (key, span, value) in r.entries(value) {
        match key {
            "radius" => radius = r.length(value, Bound::Positive),
            "lower" => lower = r.length(value, Bound::Any),
            "upper" => upper = r.length(value, Bound::Any),
            "centre" => {
                let numbers = r.list(value)?;
                let [x, y] = numbers[..] else {
                    r.fault(value.span(), "X and Y are needed here", None);
                    return None;
                };
                centre = [r.length(x, Bound::Any)?, r.length(y, Bound::Any)?];
            }
            other => r.fault(span, format!("`{other}` is not known here"), Some(FORMS.to_owned())),
        }
    }
    match (radius, lower, upper) {
        (Some(radius), Some(lower), Some(upper)) if lower < upper => {
            Some(Clearance::Cylinder { centre, radius, lower, upper })
        }
        _ => {
            r.fault(value.span(), "radius, lower and a higher upper end are needed here", Some(FORMS.to_owned()));
            None
        }
    }
}
