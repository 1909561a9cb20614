//! Rules of the kinematic chain: one machine frame (`|`), letters of axes, three linear and at most two rotary axes
//! that are solved for; further axes are in `hold`.

use crate::model::{AxisKind, kind_of};
use crate::report::Errors;
use crate::syntax::{Assign, Chain, Declaration, Expr, SpannedName};

/// Reports every rule of the chain that is broken.
pub(crate) fn check_chain(chain: &Chain, declaration: &Declaration, errors: &mut Errors) {
    check_bars(chain, errors);
    check_axes(chain, errors);
    check_linears(chain, declaration, &solved(chain, declaration, AxisKind::Linear), errors);
    check_rotaries(&solved(chain, declaration, AxisKind::Rotary), errors);
}

fn check_bars(chain: &Chain, errors: &mut Errors) {
    match &chain.bars[..] {
        [_] => {}
        [] => errors.push(
            chain.phrase,
            "missing `|` in the kinematic chain",
            "list the workpiece-side axes, then `|`, then the tool-side axes: `chain: C B | X Y Z;`",
        ),
        [_, rest @ ..] => errors.push(
            rest[0].1,
            "double `|` in the kinematic chain",
            "the machine frame (the bed) is in the chain once: write one `|`, between the axes of the workpiece side and those of the tool side",
        ),
    }
}

fn check_axes(chain: &Chain, errors: &mut Errors) {
    let mut seen: Vec<&str> = Vec::new();
    for axis in &chain.axes {
        let name = axis.name.as_str();
        if kind_of(name).is_none() {
            errors.push(
                axis.phrase,
                format!("`{name}` is not an axis letter"),
                if name.chars().count() > 1 {
                    "the chain has axis letters only; the workpiece is before the first, the tool after the last"
                } else {
                    "linear axes are X Y Z U V W, rotary axes A B C"
                },
            );
        } else if seen.contains(&name) {
            errors.push(
                axis.phrase,
                format!("`{name}` is listed twice in the chain"),
                "list each axis once, each with its own letter",
            );
        }
        seen.push(name);
    }
}

/// Axes of a kind that are not held; a letter that is repeated counts once.
fn solved<'a>(chain: &'a Chain, declaration: &Declaration, kind: AxisKind) -> Vec<&'a SpannedName> {
    let held = |name: &str| {
        declaration.hold.iter().any(|entry| entry.key.name == name) || declaration.unreadable.has_entry("hold", name)
    };
    let mut solved: Vec<&SpannedName> = Vec::new();
    for axis in &chain.axes {
        let repeated = solved.iter().any(|known| known.name == axis.name);
        if kind_of(&axis.name) == Some(kind) && !held(&axis.name) && !repeated {
            solved.push(axis);
        }
    }
    solved
}

fn check_linears(chain: &Chain, declaration: &Declaration, linears: &[&SpannedName], errors: &mut Errors) {
    let all_known = chain.axes.iter().all(|axis| kind_of(&axis.name).is_some());
    if linears.len() < 3 && all_known && !declaration.unreadable.has_part_of("hold") {
        let found: Vec<&str> = linears.iter().map(|axis| axis.name.as_str()).collect();
        let found = if found.is_empty() { "none".into() } else { found.join(" ") };
        let text = format!("a machine needs three solved linear axes, found {found}");
        let held = |entry: &&Assign<Expr>| {
            let name = entry.key.name.as_str();
            kind_of(name) == Some(AxisKind::Linear) && chain.axes.iter().any(|axis| axis.name == name)
        };
        match declaration.hold.iter().find(held) {
            Some(Assign { key, .. }) => errors.push(
                key.phrase,
                text,
                format!("`{0}` is held, so it is not solved for: remove {0} from `hold`", key.name),
            ),
            None => errors.push(chain.phrase, text, "add the missing letters to the chain"),
        }
    }
    for axis in linears.iter().skip(3) {
        errors.push(
            axis.phrase,
            format!("`{}` is a fourth linear axis, but exactly three are solved for", axis.name),
            format!("put {} in `hold`: `hold = {{ {}: 0 }};`", axis.name, axis.name),
        );
    }
}

fn check_rotaries(rotaries: &[&SpannedName], errors: &mut Errors) {
    for axis in rotaries.iter().skip(2) {
        errors.push(
            axis.phrase,
            format!("`{}` is a third rotary axis, but at most two are solved for", axis.name),
            format!("put {} in `hold`: `hold = {{ {}: 0 }};`", axis.name, axis.name),
        );
    }
}
