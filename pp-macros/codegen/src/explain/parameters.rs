//! Where each quantity of the formulas comes from that is neither pose nor axis value.

use num_rational::BigRational;

use super::section::{Line, Section, line};
use crate::formula::Formula;
use crate::model::{AxisKind, Dimension, Model, Quantity, Side};
use crate::symbolic::{PolyVector, Surd, Symbol};

/// Dimensions, part origin and tool length, each with its place in the declaration, the configuration and the
/// kinematics for a control.
pub(crate) fn parameters(model: &Model) -> Section {
    let mut section = Section::default();
    for dimension in &model.dimensions {
        section.line(dimension_line(dimension));
        section.words(&format!("    Enters: {}.", places(model, dimension)));
    }
    redundant(model).iter().for_each(|sentence| section.words(sentence));
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

/// Lengths that do not move the tip, and pairs of which only the sum or the difference does: a measurement cannot tell
/// them apart, and one of them is enough.
fn redundant(model: &Model) -> Vec<String> {
    let tip = model.product().origin();
    // Lengths enter the tip linearly: the motion of the tip for one mm.
    let lengths: Vec<(&str, PolyVector)> = model
        .dimensions
        .iter()
        .filter_map(|dimension| match dimension.quantity {
            Quantity::Length(symbol) => {
                Some((dimension.name.as_str(), tip.each_ref().map(|part| part.coefficient(symbol, 1))))
            }
            Quantity::Angle(..) => None,
        })
        .collect();
    let vanishes = |vector: &PolyVector| vector.iter().all(|part| model.ring.is_zero(part));
    let mut sentences = Vec::new();
    for (place, (name, motion)) in lengths.iter().enumerate() {
        if vanishes(motion) {
            sentences.push(format!("{name} does not move the tip: any value of it makes the same programs."));
            continue;
        }
        for (other, its_motion) in &lengths[place + 1..] {
            let sum: PolyVector = std::array::from_fn(|index| &motion[index] - &its_motion[index]);
            let difference: PolyVector = std::array::from_fn(|index| &motion[index] + &its_motion[index]);
            let only = match (vanishes(&sum), vanishes(&difference)) {
                (true, _) => format!("sum {name} + {other}"),
                (_, true) => format!("difference {name} - {other}"),
                (false, false) => continue,
            };
            sentences
                .push(format!("Only the {only} counts: measure one of the two as zero, or declare one dimension."));
        }
    }
    sentences
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
