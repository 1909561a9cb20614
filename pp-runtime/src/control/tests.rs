//! Steps in the codes of each control, and programs read back.

mod arcs;
mod comments;
mod cycles;
mod fit;
mod length_guard;
mod modal_words;
mod programs;
mod reader;
mod spindle_coolant;
mod tables;

use std::collections::BTreeMap;
use std::io;

use super::*;
use crate::motion::{AxisWords, FeedWord, MAX_AXES, Step};
use crate::nc::Decimal;
use crate::options::Mode;
use crate::program::{Coolant, Rotation, Units};

type Buffer<'b> = Encoder<'b>;

fn layout() -> Layout {
    Layout {
        axes: vec![('C', 4), ('A', 4), ('Z', 3), ('X', 3)],
        linear: 3,
        work_offset: "G55".into(),
        path_tolerance: 0.01,
        name: b"Part 7".to_vec(),
        ..Layout::default()
    }
}

fn written_by(
    control: &dyn Control,
    layout: &Layout,
    write: impl Fn(&mut Buffer<'_>) -> io::Result<()>,
) -> Vec<String> {
    let mut out = Vec::new();
    let mut encoder = Encoder::new(control, layout, &mut out);
    write(&mut encoder).expect("memory takes everything");
    encoder.finish().expect("memory takes everything");
    drop(encoder);
    String::from_utf8(out).expect("ASCII").lines().map(str::to_owned).collect()
}

fn steps(control: &dyn Control, layout: &Layout, steps: &[Step<'_>]) -> Vec<String> {
    written_by(control, layout, |encoder| steps.iter().try_for_each(|step| encoder.encode(step)))
}

/// Words of C A Z X.
fn words(units: [i64; 4]) -> AxisWords {
    only(0b1111, units)
}

fn only(mask: u16, units: [i64; 4]) -> AxisWords {
    let mut words = AxisWords { units: [0; MAX_AXES], mask, vector: None };
    words.units[..4].copy_from_slice(&units);
    words
}

fn per_minute(units: i64) -> FeedWord {
    FeedWord::PerMinute(Decimal { units, decimals: 0 })
}

const SPEED: Decimal = Decimal { units: 3000, decimals: 0 };

/// From a restart point to a cut, retract, and optional stop.
fn short_program() -> Vec<Step<'static>> {
    let (z, x) = (0b0100, 0b1000);
    vec![
        Step::Restart { number: 1, changes_tool: false },
        Step::CoolantOff,
        Step::Machine { words: only(z, [0; 4]) },
        Step::Tool { number: 5, offset: 6, next: Some(7), speed: Some(SPEED), radius_delta: None, change: true },
        Step::Machine { words: only(z, [0; 4]) },
        Step::Length { offset: 6 },
        Step::Spindle { speed: SPEED, rotation: Rotation::Clockwise },
        Step::Dwell { seconds: 2.0 },
        Step::Rapid { words: only(0b0011, [300_000, 0, 0, 0]) },
        Step::Rapid { words: only(x, [0, 0, 0, 10_000]) },
        Step::Rapid { words: only(z, [0, 0, 50_500, 0]) },
        Step::Coolant { kind: Coolant::On },
        Step::Feed { words: words([300_000, 0, -1_000, 10_000]), feed: per_minute(800) },
        Step::Feed { words: words([310_000, 0, -1_000, 12_000]), feed: per_minute(800) },
        Step::CoolantOff,
        Step::Machine { words: only(z, [0; 4]) },
        Step::Rapid { words: only(z, [0, 0, 50_500, 0]) },
        Step::SpindleOff,
        Step::Stop { optional: true },
    ]
}

fn whole(control: &dyn Control, layout: &Layout) -> Vec<String> {
    written_by(control, layout, |encoder| {
        encoder.open(None)?;
        encoder.comment(b"a (b)")?;
        encoder.encode(&Step::Operation { name: b"Face 1" })?;
        short_program().iter().try_for_each(|step| encoder.encode(step))?;
        encoder.end(&[])
    })
}

fn layout_with(options: ControlOptions) -> Layout {
    Layout { options, ..layout() }
}

/// X Y Z, millimetres.
fn milling() -> Layout {
    Layout { axes: vec![('X', 3), ('Y', 3), ('Z', 3)], ..layout() }
}

/// Position of X Y Z, whole units.
type Place = [i64; 3];

fn linear(to: Place) -> AxisWords {
    let mut words = AxisWords { mask: 0b111, ..AxisWords::default() };
    words.units[..3].copy_from_slice(&to);
    words
}

const FEED: Decimal = Decimal { units: 500, decimals: 0 };
