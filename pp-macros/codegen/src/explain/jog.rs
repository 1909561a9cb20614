//! The jog sheet: the visible motion that each axis must make for a positive word.
//!
//! A proof cannot find a wrongly declared sign, because the formulas follow from it. So each axis is jogged alone at
//! the machine and compared with a sentence. The sentences are computed from the chain: a positive word with sign `+`
//! moves the tool relative to the workpiece along the direction, or right-handed about it (ISO 841). Hence an axis that
//! carries the tool moves along the direction, and one that carries the workpiece moves against it. Directions are
//! rotated by the held axes between the axis and the bed.

use num_traits::Zero;

use super::section::{Section, line};
use super::view::{View, Xyz, dot, opposite, rotated, scaled};
use crate::model::{Axis, AxisId, AxisKind, Model, Side, to_f64};
use crate::symbolic::{Poly, PolyVector};

/// Angles to jog by, largest first; degrees.
const ANGLES_DEG: [f64; 6] = [90.0, 45.0, 30.0, 10.0, 5.0, 1.0];

/// Distances to jog by, largest first; mm.
const DISTANCES_MM: [f64; 5] = [100.0, 50.0, 10.0, 5.0, 1.0];

/// Rotation that is plainly visible; degrees.
const VISIBLE_DEG: f64 = 10.0;

/// Cosine of 3 degrees: two directions closer than that count as the same.
const ALONG_COSINE: f64 = 0.998_6;

/// Components of a unit vector below this are left out of its description.
const FAINT_SHARE: f64 = 0.2;

/// Rotation from which a marker faces a new direction in the text; a smaller one makes it lean. Degrees.
const FACING_DEG: f64 = 80.0;

/// One line for every axis of the chain, held ones included.
pub(crate) fn sheet(model: &Model) -> Section {
    let machine = MachineAtDefaults::of(model);
    let mut section = Section::default();
    let up = ["X", "Y", "Z"][model.up.coordinate];
    let up = if model.up.negated { format!("-{up}") } else { up.to_string() };
    section.words(&format!(
        "No proof can find a wrongly declared sign. Clear the table. {}. Jog each axis alone and back to the start, and \
         tick each line that is true; move the tool clear ({up} up) before a rotary axis is jogged. If a line is false, \
         the sign of that axis is wrong: correct it in the declaration before the first cut.",
        machine.start(),
    ));
    let view = machine.view;
    let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|direction| heading(view, direction));
    section.words(&format!("Seen from the front of the machine: X points {x}, Y {y}, Z {z}."));
    section.words(&format!("At the start the tool points {}.", heading(view, opposite(machine.tool))));
    let other = if up == "Y" { "Z" } else { "Y" };
    section.words(&format!("If {up} is not up at your machine, declare the direction that is: `up = {other};`."));
    if model.axes.iter().any(|axis| axis.held.is_some()) {
        section.words("Held axes stay at their defaults while the others are jogged.");
    }
    section.gap();
    for id in 0..model.axes.len() {
        let sentence = machine.sentence(id);
        section.line(line("").both("[ ] ", "$\\square$ ").words(&sentence));
    }
    let pairs = machine.pairs();
    if !pairs.is_empty() {
        section.gap();
        section.words(
            "Which axis carries which: leave the rotary axis there, jog the linear one, then bring both back. If a line is false, \
             the order of the chain is wrong.",
        );
        section.gap();
    }
    for sentence in pairs {
        section.line(line("").both("[ ] ", "$\\square$ ").words(&sentence));
    }
    section
}

/// A chain as numbers, at the defaults of dimensions and held axes.
struct MachineAtDefaults<'a> {
    model: &'a Model,
    directions: Vec<Xyz>,
    /// Axes whose direction depends on an angle without default.
    unknown: Vec<AxisId>,
    tool: Xyz,
    /// Where the top of the table faces.
    top: Xyz,
    view: View,
}

impl<'a> MachineAtDefaults<'a> {
    fn of(model: &'a Model) -> Self {
        let Model { ring, defaults, .. } = model;
        let number = |poly: &Poly| ring.value(&ring.substitute(poly, defaults)).unwrap_or_default();
        let vector = |vector: &PolyVector| vector.each_ref().map(number);
        let declared: Vec<Xyz> = model.axes.iter().map(|axis| vector(&axis.direction)).collect();
        let known =
            |axis: &Axis| axis.direction.iter().all(|part| ring.value(&ring.substitute(part, defaults)).is_some());
        let unknown = (0..model.axes.len()).filter(|id| !known(&model.axes[*id])).collect();
        let (tool, view) = (vector(&model.tool_axis), View::of(model.up));
        let mut machine = Self { model, directions: declared.clone(), unknown, tool, top: view.up, view };
        for (id, axis) in model.axes.iter().enumerate() {
            // In the frame of the bed: axes between this one and the bed that are not at zero rotate it, in the table
            // against their words.
            let between: Vec<AxisId> = match axis.side {
                Side::Workpiece => {
                    (id + 1..model.axes.len()).filter(|other| model.axes[*other].side == Side::Workpiece).collect()
                }
                Side::Tool => (0..id).rev().filter(|other| model.axes[*other].side == Side::Tool).collect(),
            };
            let turned = between.into_iter().fold(declared[id], |direction, other| {
                rotated(declared[other], machine.start_deg(other) * machine.visible_sign(other), direction)
            });
            machine.directions[id] = turned;
        }
        let head = (0..model.axes.len()).rev().filter(|id| model.axes[*id].side == Side::Tool);
        machine.tool = head.fold(machine.tool, |tool, id| {
            rotated(declared[id], machine.start_deg(id) * machine.visible_sign(id), tool)
        });
        let table = (0..model.axes.len()).filter(|id| model.axes[*id].side == Side::Workpiece);
        machine.top = table
            .fold(machine.top, |top, id| rotated(declared[id], machine.start_deg(id) * machine.visible_sign(id), top));
        machine
    }

    /// Angle at which a rotary axis is before any axis is jogged, degrees: the default of a held one, zero or the end
    /// of the travel nearest to it for others.
    fn start_deg(&self, id: AxisId) -> f64 {
        let axis = &self.model.axes[id];
        match (&axis.held, axis.kind, &axis.limits) {
            (_, AxisKind::Linear, _) | (None, AxisKind::Rotary, None) => 0.0,
            (Some(value), AxisKind::Rotary, _) => to_f64(value),
            (None, AxisKind::Rotary, Some((lower, upper))) => 0.0_f64.max(to_f64(lower)).min(to_f64(upper)),
        }
    }

    /// Where all axes are before one is jogged, in words.
    fn start(&self) -> String {
        let rotary = |axis: &Axis| axis.kind == AxisKind::Rotary && axis.held.is_none();
        let mut start = "Start with the linear axes in the middle of their travel".to_owned();
        if self.model.axes.iter().any(rotary) {
            start += " and the rotary axes at zero";
        }
        for (id, axis) in self.model.axes.iter().enumerate() {
            if rotary(axis) && self.start_deg(id) != 0.0 {
                start += &format!(", but {} at {}: zero is not in its travel", axis.letter, self.start_deg(id));
            }
        }
        start
    }

    /// `1` if what the axis carries moves along its direction for a positive word, `-1` if against it.
    fn visible_sign(&self, id: AxisId) -> f64 {
        let Axis { side, reversed, .. } = &self.model.axes[id];
        if (*side == Side::Tool) == *reversed { -1.0 } else { 1.0 }
    }

    /// A line for each linear axis and each rotary axis on its side that would rotate it, or does.
    fn pairs(&self) -> Vec<String> {
        let axes = &self.model.axes;
        let solved =
            |kind: AxisKind| (0..axes.len()).filter(move |id| axes[*id].kind == kind && axes[*id].held.is_none());
        let mut sentences = Vec::new();
        for rotary in solved(AxisKind::Rotary) {
            for linear in solved(AxisKind::Linear).filter(|linear| axes[*linear].side == axes[rotary].side) {
                let direction = self.directions[linear];
                if self.unknown.contains(&linear) || dot(direction, self.directions[rotary]).abs() > ALONG_COSINE {
                    continue;
                }
                let start = self.start_deg(rotary);
                let by = jog_angle_deg(&axes[rotary], start);
                // The chain leads from the workpiece to the tool: in the head the axis nearer to the bed comes first.
                let carried = (axes[rotary].side == Side::Tool) == (rotary < linear);
                let turned = rotated(self.directions[rotary], by * self.visible_sign(rotary), direction);
                let way = scaled(if carried { turned } else { direction }, self.visible_sign(linear));
                let thing = if axes[linear].side == Side::Workpiece { "table" } else { "spindle" };
                let same = if carried { "" } else { ", as before" };
                sentences.push(format!(
                    "{} at {}, {}+{}: the {thing} moves {}{same}",
                    axes[rotary].letter,
                    start + by,
                    axes[linear].letter,
                    jog_distance_mm(&axes[linear]),
                    heading(self.view, way)
                ));
            }
        }
        sentences
    }

    fn sentence(&self, id: AxisId) -> String {
        let axis = &self.model.axes[id];
        let held = if axis.held.is_some() { " (held)" } else { "" };
        match axis.kind {
            AxisKind::Linear if self.unknown.contains(&id) => {
                let names = self.model.dimensions.iter().filter(|dimension| dimension.known().is_none());
                let names: Vec<&str> = names.map(|dimension| dimension.name.as_str()).collect();
                format!("{}{held}: its direction depends on {}", axis.letter, names.join(", "))
            }
            AxisKind::Linear => {
                let value = jog_distance_mm(axis);
                let thing = if axis.side == Side::Workpiece { "table" } else { "spindle" };
                let way = scaled(self.directions[id], self.visible_sign(id));
                format!("{}+{value}{held}: the {thing} moves {}", axis.letter, heading(self.view, way))
            }
            AxisKind::Rotary => {
                let value = jog_angle_deg(axis, self.start_deg(id));
                format!("{}{value:+}{held}: {}", axis.letter, self.rotation_seen(id, value * self.visible_sign(id)))
            }
        }
    }

    /// The visible motion when the axis rotates by `degrees`, right-handed about its direction.
    fn rotation_seen(&self, id: AxisId, degrees: f64) -> String {
        let about = self.directions[id];
        let table = self.model.axes[id].side == Side::Workpiece;
        let thing = if table { "table" } else { "spindle head" };
        let markers = if table { self.table_markers() } else { self.head_markers() };
        let moved: Vec<(&(String, Xyz), Xyz, f64)> = markers
            .iter()
            .map(|marker| {
                let after = rotated(about, degrees, marker.1);
                (marker, after, dot(marker.1, after).clamp(-1.0, 1.0).acos().to_degrees())
            })
            .collect();
        // The marker that moves most; among equals the one that ends nearest a coordinate direction; then the first.
        let rank = |(_, after, angle): &(&(String, Xyz), Xyz, f64)| {
            let nearest = after.iter().fold(0.0_f64, |most, part| most.max(part.abs()));
            (angle.round(), (nearest * 100.0).round())
        };
        let best = moved.iter().fold(&moved[0], |best, marker| if rank(marker) > rank(best) { marker } else { best });
        let sense = rotation_sense(self.view, about, degrees)
            .map(|sense| format!("the {thing} rotates {sense}; "))
            .unwrap_or_default();
        let mut sentence = format!("{sense}{}", marker_motion(self.view, best));
        // About an inclined axis one marker does not determine the motion.
        if sense.is_empty() && best.0.0 != moved[0].0.0 && moved[0].2 > 1.0 {
            sentence += &format!("; {}", marker_motion(self.view, &moved[0]));
        }
        sentence
    }

    fn table_markers(&self) -> Vec<(String, Xyz)> {
        let View { right, away, .. } = self.view;
        let (top, front) = (self.top, opposite(away));
        vec![
            (format!("the table's top, which faced {},", heading(self.view, top)), top),
            (format!("the side that faced you ({})", letter_of(front)), front),
            (format!("the side that faced {}", heading(self.view, right)), right),
        ]
    }

    fn head_markers(&self) -> Vec<(String, Xyz)> {
        let View { right, away, up } = self.view;
        let (points, front) = (opposite(self.tool), opposite(away));
        vec![
            (format!("the tool, which pointed {},", heading(self.view, points)), points),
            (format!("the side of the head that faced you ({})", letter_of(front)), front),
            (format!("the side of the head that faced {}", heading(self.view, right)), right),
            (format!("the side of the head that faced {}", heading(self.view, up)), up),
        ]
    }
}

/// The motion of a marker, in words.
fn marker_motion(view: View, ((name, before), after, angle): &(&(String, Xyz), Xyz, f64)) -> String {
    let tool = name.starts_with("the tool");
    if *angle >= FACING_DEG {
        let verb = if tool { "points" } else { "faces" };
        return format!("{name} now {verb} {}", heading(view, *after)).replace("faces towards you", "faces you");
    }
    // Direction of its motion, perpendicular to its old direction.
    let along = dot(*before, *after);
    let across: Xyz = std::array::from_fn(|index| after[index] - along * before[index]);
    let length = dot(across, across).sqrt();
    if length < 1e-9 {
        return format!("{name} stays");
    }
    let way = in_words(view, scaled(across, length.recip()), true);
    let verb = if tool { "has swung" } else { "now leans" };
    format!("{name} {verb} {angle:.0} degrees {way}")
}

/// Clockwise or counterclockwise, with the side it is seen from; for coordinate directions only.
fn rotation_sense(view: View, about: Xyz, degrees: f64) -> Option<String> {
    let views = [("above", view.up), ("the front", opposite(view.away)), ("the right", view.right)];
    views.into_iter().find_map(|(from, to_the_eye)| {
        let along = dot(about, to_the_eye);
        // Right-handed about a direction towards the observer is counterclockwise.
        let word = if along * degrees > 0.0 { "counterclockwise" } else { "clockwise" };
        (along.abs() > ALONG_COSINE).then(|| format!("{word} seen from {from}"))
    })
}

/// The largest angle of [`ANGLES_DEG`] within the travel from the start: positive, unless only the other direction has
/// room for a visible rotation.
fn jog_angle_deg(axis: &Axis, start_deg: f64) -> f64 {
    let Some((lower, upper)) = &axis.limits else { return ANGLES_DEG[0] };
    let largest = |room: f64| ANGLES_DEG.into_iter().find(|angle| *angle <= room).unwrap_or(0.0);
    let (plus, minus) = (largest(to_f64(upper) - start_deg), largest(start_deg - to_f64(lower)));
    match plus >= VISIBLE_DEG.min(minus) {
        true if plus > 0.0 => plus,
        true => ANGLES_DEG[ANGLES_DEG.len() - 1],
        false => -minus,
    }
}

/// The largest distance of [`DISTANCES_MM`] within half the travel; limits of linear axes are machine coordinates.
fn jog_distance_mm(axis: &Axis) -> f64 {
    let Some((lower, upper)) = &axis.limits else { return DISTANCES_MM[0] };
    let span = upper - lower;
    if span.is_zero() {
        return DISTANCES_MM[4];
    }
    let room = to_f64(&span) / 2.0;
    DISTANCES_MM.into_iter().find(|distance| *distance <= room).unwrap_or(DISTANCES_MM[4])
}

fn heading(view: View, direction: Xyz) -> String {
    in_words(view, direction, false)
}

/// The letter of a coordinate direction, with its sign.
fn letter_of(direction: Xyz) -> String {
    let index = (0..3).find(|index| direction[*index].abs() > ALONG_COSINE).unwrap_or_default();
    format!("{}{}", if direction[index] < 0.0 { '-' } else { '+' }, ['X', 'Y', 'Z'][index])
}

/// A direction in words, with its letters in brackets.
fn in_words(view: View, direction: Xyz, leaning: bool) -> String {
    let words = |word: &'static str| match word {
        "right" | "left" if leaning => format!("to the {word}"),
        "up" | "down" if leaning => format!("{word}wards"),
        word => word.to_string(),
    };
    // Component, word and letter along each direction of the view.
    let parts = view.directions().map(|(axis, [positive, negative])| {
        let component = dot(direction, axis);
        let minus = component < 0.0;
        let letter = letter_of(if minus { opposite(axis) } else { axis });
        (component.abs(), words(if minus { negative } else { positive }), letter)
    });
    let mut parts: Vec<_> = parts.into_iter().filter(|(component, ..)| *component > FAINT_SHARE).collect();
    // The largest first; equal ones in the order of the view.
    parts.sort_by(|(a, ..), (b, ..)| (b * 100.0).round().total_cmp(&(a * 100.0).round()));
    if parts.first().is_some_and(|(component, ..)| *component > ALONG_COSINE) {
        parts.truncate(1);
    }
    let words: Vec<&str> = parts.iter().map(|(_, word, _)| word.as_str()).collect();
    let letters: Vec<&str> = parts.iter().map(|(.., letter)| letter.as_str()).collect();
    format!("{} ({})", words.join(" and "), letters.join(" "))
}
