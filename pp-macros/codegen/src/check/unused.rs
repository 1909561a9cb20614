//! Dimensions that nothing depends on: a centre line or a direction has been forgotten.

use crate::model::{Dimension, Quantity};
use crate::report::Errors;
use crate::syntax::{Declaration, Direction, Expr, Offsets, Vector};

/// Reports every dimension that no centre line and no direction mentions.
pub(crate) fn check_dimensions(declaration: &Declaration, dimensions: &[Dimension], errors: &mut Errors) {
    let used = expressions(declaration);
    let unknown = |name: &&str| !dimensions.iter().any(|dimension| dimension.name == *name);
    // A name that is misspelt where it is used has its own message.
    let misspelt = used.iter().flat_map(|expr| expr.names()).any(|name| unknown(&name));
    if misspelt || ["d", "axes", "tool_axis"].iter().any(|field| declaration.unreadable.has_part_of(field)) {
        return;
    }
    for dimension in dimensions {
        let name = &dimension.name;
        let Some(entry) = declaration.dimensions.iter().find(|entry| entry.key.name == *name) else { continue };
        if used.iter().any(|expr| expr.mentions(name)) {
            continue;
        }
        let example = match dimension.quantity {
            Quantity::Length(_) => format!("a point of a centre line: `d = (0, 0, {name});`"),
            Quantity::Angle(..) => format!("a direction: `axes = {{ B: Rx({name}) * Y }};`"),
        };
        let text = format!("the dimension `{name}` is used nowhere");
        errors.push(
            entry.key.phrase,
            text,
            format!("use it in {example}; a name that only equations need is given there by `where {name} = ...;`"),
        );
    }
}

/// All expressions that make the machine.
fn expressions(declaration: &Declaration) -> Vec<&Expr> {
    let mut found: Vec<&Expr> = Vec::new();
    match &declaration.offsets {
        None => {}
        Some(Offsets::Common(Vector { parts, .. })) => found.extend(parts),
        Some(Offsets::Each(entries)) => found.extend(entries.iter().flat_map(|entry| &entry.value.parts)),
    }
    let directions = declaration.directions.iter().map(|entry| &entry.value).chain(&declaration.tool_axis);
    for Direction { rotations, base, .. } in directions {
        found.extend(rotations.iter().map(|(_, angle)| angle));
        if let crate::syntax::Base::Vector(vector) = base {
            found.extend(&vector.parts);
        }
    }
    found
}
