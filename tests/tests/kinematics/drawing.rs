//! `explain --drawing`: each dimension is in the drawing of its machine, and each arc turns as the jog sheet says.

use machine_library::{HaasTrunnion, HaasUmc, Max5, PocketNcV2, XyzabTdr, XyzacTrt, XyzbcTrt};
use machines::{LolaXoyzba, MultiProDesk, SpinnerU5620};
use pp_runtime::cli::{App, Status, Streams};
use pp_runtime::kinematics::{AxisKind, Machine};

fn printed<M: Machine>(options: &[&str]) -> String {
    let args: Vec<_> = [M::NAME, "explain"].iter().chain(options).map(Into::into).collect();
    let (mut output, mut errors) = (Vec::new(), Vec::new());
    let streams = Streams { input: &mut &b""[..], output: &mut output, errors: &mut errors, terminal: false };
    let status = App::new().run_with::<M>(&args, streams);
    assert_eq!(status, Status::Done, "{}", String::from_utf8_lossy(&errors));
    String::from_utf8(output).expect("text")
}

/// Points of an arc have this many pairs.
const ARC: usize = 31;

/// Where the eye is in the three views, as the jog sheet names it, of a machine whose Z is up, and of one whose Y is.
const FROM: [&str; 3] = ["above", "the front", "the right"];
const FROM_WITH_Y_UP: [&str; 3] = ["the front", "below", "the right"];

/// Letter, view, and whether it turns clockwise, of each arc in a drawing.
fn arcs(drawing: &str) -> Vec<(char, usize, bool)> {
    let width = 2000.0 / 3.0;
    let mut found = Vec::new();
    let mut arc = None;
    for line in drawing.lines() {
        if let Some((_, points)) = line.split_once("points=\"") {
            let points = points.split('"').next().expect("an end");
            let points: Vec<[f64; 2]> = points
                .split_whitespace()
                .filter_map(|pair| pair.split_once(','))
                .map(|(x, y)| [x, y].map(|number| number.parse().expect("a number")))
                .collect();
            if points.len() == ARC {
                // Twice the area that the arc encloses with its chord; y of a picture goes down.
                let next = points.iter().cycle().skip(1);
                let area: f64 = points.iter().zip(next).map(|(one, other)| one[0] * other[1] - other[0] * one[1]).sum();
                arc = Some(((points[0][0] / width) as usize, area > 0.0));
            }
        } else if let Some((letter, _)) = line.split_once("+, ")
            && let Some((view, clockwise)) = arc.take()
        {
            found.push((letter.chars().last().expect("a letter"), view, clockwise));
        }
    }
    found
}

/// What the jog sheet says of a rotary axis: clockwise or not, and seen from where.
fn jogged(jog: &str, letter: char) -> (bool, String) {
    let text = jog.split_whitespace().collect::<Vec<_>>().join(" ");
    let line = text.split("[ ] ").find(|line| line.starts_with(&format!("{letter}+"))).expect("a line of the axis");
    let (before, after) = line.split_once("clockwise seen from ").expect("a sense");
    (!before.ends_with("counter"), after.split([';', '.']).next().expect("a side").to_owned())
}

fn is_drawn_as_it_is_jogged<M: Machine>(eyes: [&str; 3]) {
    let (drawing, jog) = (printed::<M>(&["--drawing"]), printed::<M>(&[]));
    let arcs = arcs(&drawing);
    let rotary = M::AXES.iter().filter(|axis| axis.kind == AxisKind::Rotary);
    for axis in rotary.clone() {
        let (_, view, clockwise) =
            *arcs.iter().find(|arc| arc.0 == axis.letter).unwrap_or_else(|| panic!("{}: {}", M::NAME, axis.letter));
        let (jogged, from) = jogged(&jog, axis.letter);
        let opposite = [("above", "below"), ("below", "above"), ("the front", "the back"), ("the right", "the left")];
        let same = from == eyes[view];
        assert!(same || opposite.contains(&(eyes[view], &*from)), "{}: {} from {from}", M::NAME, axis.letter);
        assert_eq!(clockwise == jogged, same, "{}: {} from {from}", M::NAME, axis.letter);
    }
    assert_eq!(arcs.len(), rotary.count(), "{}: {arcs:?}", M::NAME);
    for dimension in M::DIMENSIONS {
        assert!(drawing.contains(&format!("{} = ", dimension.name)), "{}: {}", M::NAME, dimension.name);
    }
}

#[test]
fn every_arc_turns_as_the_jog_sheet_says() {
    is_drawn_as_it_is_jogged::<SpinnerU5620>(FROM);
    is_drawn_as_it_is_jogged::<LolaXoyzba>(FROM);
    is_drawn_as_it_is_jogged::<MultiProDesk>(FROM);
    is_drawn_as_it_is_jogged::<HaasUmc>(FROM);
    is_drawn_as_it_is_jogged::<HaasTrunnion>(FROM);
    is_drawn_as_it_is_jogged::<PocketNcV2>(FROM_WITH_Y_UP);
    is_drawn_as_it_is_jogged::<Max5>(FROM);
    is_drawn_as_it_is_jogged::<XyzacTrt>(FROM);
    is_drawn_as_it_is_jogged::<XyzbcTrt>(FROM);
    is_drawn_as_it_is_jogged::<XyzabTdr>(FROM);
}
