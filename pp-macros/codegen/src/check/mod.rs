//! Rules of the language: [`Declaration`] to [`Checked`]. All mistakes are collected before compilation stops.

mod axis;
mod chain;
mod defaults;
mod item;
mod names;
mod order;
mod quantity;
mod unused;

use syn::ext::IdentExt;

use crate::model::{Axis, AxisKind, Dimension, LOCALS, Model, ModelSymbols, Quantity, Side, is_word_of_c, kind_of};
use crate::report::{Errors, Phrase, Refused};
use crate::solve::Refusal;
use crate::symbolic::Ring;
use crate::syntax::{Assign, Declaration, DimensionValue, Offsets, SpannedName, Unit, Unreadable};
use axis::{axis, coordinate, unit_direction};
use chain::check_chain;
use defaults::defaults;
pub use item::Item;
pub(crate) use names::is_reserved;
pub(crate) use quantity::{DimensionNames, Fault, angle, length};

/// Source locations of the chain and its letters, for refusals of the solver.
#[derive(Debug)]
pub struct ChainPhrases {
    chain: Phrase,
    axes: Vec<SpannedName>,
}

/// A declaration that keeps all rules: no later stage but `verify` reads the declaration itself.
#[derive(Debug)]
pub struct Checked {
    /// The machine, without syntax.
    pub model: Model,
    /// The struct, for generated code.
    pub item: Item,
    /// Places of the chain, for messages.
    pub phrases: ChainPhrases,
}

/// Checks a declaration.
///
/// # Errors
/// Every rule that it breaks.
pub fn check(declaration: &Declaration, errors: &mut Errors) -> Result<Checked, Refused> {
    let mut ring = Ring::default();
    let symbols = model_symbols(&mut ring);
    let mut unreadable = declaration.unreadable.clone();
    let dimensions = dimensions(declaration, &mut ring, &mut unreadable, errors);
    let Some(chain) = &declaration.chain else {
        if !declaration.unreadable.has_part_of("chain") {
            let name = &declaration.name;
            let phrase = Phrase::new(name.span(), name.span(), 0);
            errors.push(phrase, "the machine has no `chain`", "list its axes: `chain: C B | X Y Z;`");
        }
        return Err(errors.refused());
    };
    check_chain(chain, declaration, errors);
    let known: Vec<&str> = chain.axes.iter().map(|axis| axis.name.as_str()).collect();
    check_letters(declaration, &known, errors);
    let names = DimensionNames { dimensions: &dimensions, unreadable: &unreadable };
    let tool_axis = match &declaration.tool_axis {
        Some(direction) => unit_direction(direction, &names, &mut ring, errors),
        None => coordinate(2),
    };
    let bar = chain.bars.first().map_or(0, |(place, _)| *place);
    let mut axes = Vec::new();
    for (place, spot) in chain.axes.iter().enumerate() {
        let side = if place < bar { Side::Workpiece } else { Side::Tool };
        axes.extend(axis(spot, side, declaration, &names, &mut ring, errors));
    }
    check_offsets(declaration, &axes, errors);
    unused::check_dimensions(declaration, &dimensions, errors);
    check_required_angles(declaration, &dimensions, errors);
    check_derives(declaration, errors);
    errors.propagate()?;
    let item = Item::of(declaration);
    let name = declaration.name.unraw().to_string();
    let phrases = ChainPhrases { chain: chain.phrase, axes: chain.axes.clone() };
    let up = declaration.up.unwrap_or_default();
    let defaults = defaults(&axes, &dimensions, &mut ring);
    let model = Model { name, axes, dimensions, tool_axis, up, symbols, defaults, ring };
    Ok(Checked { model, item, phrases })
}

/// Reports refusals of the solver at the letters that they name.
pub fn refused(refusals: &[Refusal], model: &Model, phrases: &ChainPhrases, errors: &mut Errors) -> Refused {
    for refusal in refusals {
        match *refusal {
            Refusal::DependentLinears => errors.push(
                phrases.chain,
                format!(
                    "the linear axes {} cannot move the tip in every direction",
                    model.letters(model.solved_linears())
                ),
                "their directions lie in one plane, always or at the defaults of `dims` and `hold`: give one of them another direction in `axes`",
            ),
            Refusal::CannotTilt(axis) => {
                let letter = model.axes[axis].letter;
                errors.push(
                    phrases.axes[axis].phrase,
                    format!("`{letter}` rotates about the tool axis, so it cannot tilt the tool"),
                    order::or_hold(model, axis),
                );
            }
            Refusal::SameDirection(first, second) => {
                let (first, letter) = (model.axes[first].letter, model.axes[second].letter);
                errors.push(
                    phrases.axes[second].phrase,
                    format!("`{first}` and `{letter}` rotate about the same direction, so they act as one axis"),
                    format!(
                        "give one of them another direction in `axes`, or put {letter} in `hold`: `hold = {{ {letter}: 0 }};`"
                    ),
                );
            }
        }
    }
    errors.refused()
}

/// Reports a claim that could not be proven: a fault of the engine, not of the declaration.
pub fn unproven(claim: &str, phrases: &ChainPhrases, errors: &mut Errors) -> Refused {
    errors.push(
        phrases.chain,
        format!("the formulas of this machine could not be proven; not shown: {claim}"),
        "this is a bug in the generator, not in the declaration: please report it with the declaration",
    );
    errors.refused()
}

fn model_symbols(ring: &mut Ring) -> ModelSymbols {
    ModelSymbols {
        tip: ["x", "y", "z"].map(|name| ring.symbol(name)),
        axis: ring.unit_vector(["i", "j", "k"]),
        part: ["part_x", "part_y", "part_z"].map(|name| ring.symbol(name)),
        gauge: ring.symbol("gauge"),
    }
}

/// Checks that the keys of fields with axis letters are axes of the chain, each given once.
fn check_letters(declaration: &Declaration, known: &[&str], errors: &mut Errors) {
    fn check<T>(field: &str, entries: &[Assign<T>], known: &[&str], errors: &mut Errors) {
        for (place, entry) in entries.iter().enumerate() {
            let name = entry.key.name.as_str();
            if !known.contains(&name) {
                let upper = name.to_uppercase();
                let help = if known.contains(&upper.as_str()) {
                    format!("axis letters are capitals: write `{upper}`")
                } else {
                    format!("the axes are {}", known.join(" "))
                };
                let text = format!("`{name}` in `{field}` is not an axis of the chain");
                errors.push(entry.key.phrase, text, help);
            } else if entries[..place].iter().any(|earlier| earlier.key.name == name) {
                errors.push(entry.key.phrase, format!("`{name}` is given twice in `{field}`"), "keep one of the two");
            }
        }
    }
    check("signs", &declaration.signs, known, errors);
    check("axes", &declaration.directions, known, errors);
    check("hold", &declaration.hold, known, errors);
    check("limits", &declaration.limits, known, errors);
    check("speeds", &declaration.speeds, known, errors);
    if let Some(Offsets::Each(entries)) = &declaration.offsets {
        check("d", entries, known, errors);
        for entry in entries.iter().filter(|entry| kind_of(&entry.key.name) == Some(AxisKind::Linear)) {
            errors.push(
                entry.key.phrase,
                format!("`{}` is a linear axis: it has no centre line", entry.key.name),
                "`d` gives a point on the centre line of a rotary axis",
            );
        }
    }
}

fn check_offsets(declaration: &Declaration, axes: &[Axis], errors: &mut Errors) {
    let Some(Offsets::Common(vector)) = &declaration.offsets else { return };
    let mut sides = axes.iter().filter(|axis| axis.kind == AxisKind::Rotary).map(|axis| axis.side);
    let Some(first) = sides.next() else {
        errors.push(vector.phrase, "`d` is given, but the chain has no rotary axis", "remove `d`");
        return;
    };
    if sides.any(|side| side != first) {
        errors.push(
            vector.phrase,
            "one `d` for rotary axes on both sides of `|`",
            "give a point for each rotary axis, on the workpiece side from the reference point of the table, on the tool side from the gauge line of the spindle: for example `d = { C: (0, 0, 0), B: (0, 0, 60) };`",
        );
    }
}

/// Refuses an angle of unknown size that a rotary axis or the tool depends on: the order of the two solutions is fixed
/// at its default or approximate value.
fn check_required_angles(declaration: &Declaration, dimensions: &[Dimension], errors: &mut Errors) {
    for dimension in dimensions.iter().filter(|dimension| dimension.known().is_none()) {
        let name = &dimension.name;
        let rotary = |key: &SpannedName| kind_of(&key.name) == Some(AxisKind::Rotary);
        let directions = declaration.directions.iter().filter(|entry| rotary(&entry.key)).map(|entry| &entry.value);
        let mut angles = directions.chain(&declaration.tool_axis).flat_map(|direction| &direction.rotations);
        let Some(entry) = declaration.dimensions.iter().find(|entry| entry.key.name == *name) else { continue };
        if matches!(dimension.quantity, Quantity::Angle(..)) && angles.any(|(_, angle)| angle.mentions(name)) {
            errors.push(
                entry.key.phrase,
                format!("the angle `{name}` needs an approximate value"),
                format!("a rotary axis or the tool depends on it, and the order of the two solutions is fixed there: write `{name}: required near 45 deg` with the angle of the drawing, or `{name}: 45 deg` if all machines have it"),
            );
        }
    }
}

/// Refuses `derive` of traits that are generated.
fn check_derives(declaration: &Declaration, errors: &mut Errors) {
    for attribute in declaration.attributes.iter().filter(|attribute| attribute.path().is_ident("derive")) {
        // rustc reports a `derive` that cannot be parsed here.
        let _ = attribute.parse_nested_meta(|meta| {
            if let Some(last) = meta.path.segments.last()
                && ["Clone", "Debug", "Default"].iter().any(|name| last.ident == name)
            {
                let phrase = Phrase::new(last.ident.span(), last.ident.span(), 0);
                errors.push(
                    phrase,
                    format!("`{}` is already generated by `machine!`", last.ident),
                    "remove it from `derive`",
                );
            }
            Ok(())
        });
    }
}

/// The dimensions; names of those that are refused are added to `unreadable`.
fn dimensions(
    declaration: &Declaration,
    ring: &mut Ring,
    unreadable: &mut Unreadable,
    errors: &mut Errors,
) -> Vec<Dimension> {
    let mut dimensions: Vec<Dimension> = Vec::new();
    for Assign { key, value } in &declaration.dimensions {
        let name = &key.name;
        let ascii = name.is_ascii();
        if !ascii || is_reserved(name) || syn::parse_str::<syn::Ident>(name).is_err() {
            errors.push(
                key.phrase,
                format!("`{name}` cannot be the name of a dimension"),
                if ascii {
                    "the name is reserved by `machine!` or by Rust: choose another, such as `pivot` or `tilt`"
                } else {
                    "it is also a key of the configuration and a name in C: use the letters a to z, digits and `_`"
                },
            );
            unreadable.add_entry("dims", name);
            continue;
        }
        if dimensions.iter().any(|known| known.name == *name) {
            errors.push(key.phrase, format!("`{name}` is given twice in `dims`"), "keep one of the two");
            continue;
        }
        let declared = match value {
            DimensionValue::RequiredLength => Ok((None, None, Some(Unit::Millimetre))),
            DimensionValue::RequiredAngle(None) => Ok((None, None, Some(Unit::Degree))),
            DimensionValue::Given(value) => {
                quantity::default(value, declaration).map(|(number, unit)| (Some(number), None, unit))
            }
            DimensionValue::RequiredAngle(Some(value)) => match quantity::default(value, declaration) {
                Ok((number, Some(Unit::Degree))) => Ok((None, Some(number), Some(Unit::Degree))),
                Ok(_) => Err(Fault::new(
                    value.phrase,
                    "only a required angle has an approximate value",
                    format!("write `{name}: required` for a length, `{name}: required near 45 deg` for an angle"),
                )),
                Err(fault) => Err(fault),
            },
        };
        let (default, near, unit) = match declared {
            Ok(declared) => declared,
            Err(fault) => {
                fault.report(errors);
                unreadable.add_entry("dims", name);
                continue;
            }
        };
        let quantity = if unit == Some(Unit::Degree) {
            let (sine, cosine) = ring.sin_cos(format!("sin_{name}"), format!("cos_{name}"));
            Quantity::Angle(sine, cosine)
        } else {
            Quantity::Length(ring.symbol(local_name(name)))
        };
        dimensions.push(Dimension { name: name.clone(), default, near, quantity });
    }
    dimensions
}

/// Name of a length inside generated functions: its own, or with `dim_` in front where a local variable or a word of C
/// has that name. The ring keeps all other names distinct.
fn local_name(name: &str) -> String {
    if LOCALS.contains(&name) || is_word_of_c(name) { format!("dim_{name}") } else { name.to_string() }
}
