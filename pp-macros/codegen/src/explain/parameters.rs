//! Where each quantity of the formulas comes from that is neither pose nor axis value.

use super::section::{Line, Section, line};
use num_rational::BigRational;

use crate::formula::Formula;
use crate::model::{AxisKind, Dimension, Model, Quantity, Side};
use crate::symbolic::{PolyVector, Surd, Symbol};

/// Dimensions, part origin and tool length, each with its place in the declaration, the configuration and the kinematics for a
/// control.
pub(crate) fn parameters(model: &Model) -> Section {
    let mut section = Section::default();
    for dimension in &model.dimensions {
        section.line(dimension_line(dimension));
        section.words(&format!("    Enters: {}.", places(model, dimension)));
    }
    section.words(
        "part_x, part_y, part_z: the part zero from the table's reference point; `part_origin` of the configuration.",
    );
    if model.axes.iter().any(|axis| axis.kind == AxisKind::Rotary && axis.side == Side::Tool) {
        section.words(
            "gauge: the tool tip from the gauge line of the spindle; the length of the tool in the CL data (LOADTL) or in the \
             configuration.",
        );
    }
    section.gap();
    let names: Vec<&str> = model.dimensions.iter().map(|dimension| dimension.name.as_str()).collect();
    let pins = names
        .iter()
        .map(|name| name.to_lowercase().replace('_', "-"))
        .chain(["part-origin-x to -z".into(), "tool-offset".into()]);
    let pins: Vec<String> = pins.collect();
    let fields = names.iter().map(|name| model.c_field(name)).chain(["part_origin", "gauge_length"].map(String::from));
    let fields: Vec<String> = fields.collect();
    section.words(&format!("Kinematics for LinuxCNC have them as pins: {}.", pins.join(", ")));
    section.words(&format!("In C they are members of the structure: {}.", fields.join(", ")));
    section
}

fn dimension_line(dimension: &Dimension) -> Line {
    let name = &dimension.name;
    let (what, unit) = match dimension.quantity {
        Quantity::Length(_) => ("a length of the machine", " mm"),
        Quantity::Angle(..) => ("an angle of the machine", "°"),
    };
    let line = line("").math(&Formula::name(name.clone())).words(&format!(": {what}, "));
    let number = |value: &BigRational| Formula::Number(Surd::from(value.clone()));
    let line = match (&dimension.default, &dimension.near) {
        (Some(value), _) => line.words("declared as ").math(&number(value)).words(&format!("{unit}; ")),
        (None, Some(value)) => {
            line.words("near ").math(&number(value)).words(&format!("{unit}, each machine has its own; "))
        }
        (None, None) => line.words("not declared: each machine has its own; "),
    };
    line.words(&format!("`dimensions.{name}` of the configuration."))
}

/// `centre lines of C B, direction of B`
fn places(model: &Model, dimension: &Dimension) -> String {
    let symbols: Vec<Symbol> = match dimension.quantity {
        Quantity::Length(symbol) => vec![symbol],
        Quantity::Angle(sine, cosine) => vec![sine, cosine],
    };
    let has = |vector: &PolyVector| vector.iter().any(|part| part.symbols().any(|symbol| symbols.contains(&symbol)));
    let axes = |of: &dyn Fn(usize) -> bool| model.letters((0..model.axes.len()).filter(|axis| of(*axis)));
    let centre_lines = axes(&|axis| has(&model.axes[axis].point));
    let directions = axes(&|axis| has(&model.axes[axis].direction));
    let mut places = Vec::new();
    for (place, letters) in [("centre lines of", centre_lines), ("directions of", directions)] {
        if !letters.is_empty() {
            places.push(format!("{place} {letters}"));
        }
    }
    if has(&model.tool_axis) {
        places.push("the tool axis".into());
    }
    places.join("; ")
}
