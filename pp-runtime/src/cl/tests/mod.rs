//! Tests of the CL reader, from bytes to events. The name of a test is the statement that it checks.

mod arcs;
mod faults;
mod frames;
mod holes;
mod input;
mod machine_state;
mod meaning;
mod motions;
mod options;
mod round_trip;
mod subprograms;
mod systems;
mod texts;
mod tools;

use super::{ClReader, ReadingOptions};
use crate::diag::{Diagnostic, Severity};
use crate::program::{Event, Interruption, Location, NewStart, ReferenceGeometry, TextKind, ToolMotion, Units};
use std::io::Read;

const MM: Option<Units> = Some(Units::Millimetres);
const UNSTATED: Option<Units> = None;

impl From<Option<Units>> for ReadingOptions {
    fn from(units: Option<Units>) -> Self {
        ReadingOptions { units, ..ReadingOptions::default() }
    }
}

/// Events as text with their places, and diagnostics.
#[derive(Debug)]
struct Outcome {
    events: Vec<String>,
    diagnostics: Vec<Diagnostic>,
}

fn read_from(input: impl Read, options: impl Into<ReadingOptions>) -> Outcome {
    let mut reader = ClReader::new(input, options.into());
    let mut events = Vec::new();
    while let Some((Location { line, column }, event)) = reader.next_event().unwrap() {
        let event = match event {
            Event::Motion(ToolMotion::Move(motion)) => {
                let (tip, axis) = (motion.pose.tip, motion.pose.axis);
                let kind = if motion.rapid { "rapid" } else { "feed" };
                format!("{kind} {} {} {} axis {} {} {} {:?}", tip.x, tip.y, tip.z, axis.x, axis.y, axis.z, motion.feed)
            }
            Event::Reference(ReferenceGeometry::From(pose)) => {
                format!("from {} {} {} axis {}", pose.tip.x, pose.tip.y, pose.tip.z, pose.axis.z)
            }
            Event::NewStart(NewStart::Operation(text)) => format!("operation {}", String::from_utf8_lossy(text)),
            Event::Motion(ToolMotion::Arc(arc)) => format!(
                "arc to {} {} {} about {} {} {} through {:.3}",
                arc.end.tip.x,
                arc.end.tip.y,
                arc.end.tip.z,
                arc.normal.x,
                arc.normal.y,
                arc.normal.z,
                arc.angle_rad.to_degrees()
            ),
            Event::Motion(ToolMotion::Spline(spline)) => format!("spline {:?} {}", spline.knots, spline.points.len()),
            Event::Motion(ToolMotion::Hole(hole)) => format!(
                "hole {} {} {} deep {} from {} to {} {:?} {:?} {:?}",
                hole.top.tip.x,
                hole.top.tip.y,
                hole.top.tip.z,
                hole.depth_mm,
                hole.clearance_mm,
                hole.return_mm,
                hole.drilling,
                hole.feed,
                hole.dwell
            ),
            Event::Interruption(Interruption::Insert(text, _)) => format!("insert {}", String::from_utf8_lossy(text)),
            Event::NewStart(start) => format!("{start:?}"),
            Event::Interruption(interruption) => format!("{interruption:?}"),
            Event::Function(function) => format!("{function:?}"),
            Event::Reference(geometry) => format!("{geometry:?}"),
            Event::Text(kind, text) => {
                let kind = match kind {
                    TextKind::Name => "name",
                    TextKind::MachineName => "machine",
                    TextKind::Message => "message",
                };
                format!("{kind} {}", String::from_utf8_lossy(text))
            }
        };
        events.push(format!("{line}:{column} {event}"));
    }
    Outcome { events, diagnostics: reader.diagnostics().to_vec() }
}

/// Events of a file in millimetres that has no fault.
#[track_caller]
fn events(text: &str) -> Vec<String> {
    events_with(text, MM)
}

#[track_caller]
fn events_with(text: &str, options: impl Into<ReadingOptions>) -> Vec<String> {
    let outcome = read_from(text.as_bytes(), options);
    assert_eq!(outcome.diagnostics, [], "in {text:?}");
    outcome.events
}

/// Every error of a file as `line:column+length text`.
fn errors(text: &str) -> Vec<String> {
    errors_with(text, MM)
}

fn errors_with(text: &str, options: impl Into<ReadingOptions>) -> Vec<String> {
    let diagnostics = read_from(text.as_bytes(), options).diagnostics;
    let errors = diagnostics.iter().filter(|diagnostic| diagnostic.severity == Severity::Error);
    errors
        .map(|Diagnostic { location: Location { line, column }, length, text, .. }| {
            format!("{line}:{column}+{length} {text}")
        })
        .collect()
}

/// Asserts that a file has exactly this error, with a help line.
#[track_caller]
fn refused(text: &str, expected: &str) {
    refused_with(text, MM, expected);
}

#[track_caller]
fn refused_with(text: &str, options: impl Into<ReadingOptions>, expected: &str) {
    let options = options.into();
    assert_eq!(errors_with(text, options.clone()), [expected], "in {text:?}");
    let diagnostics = read_from(text.as_bytes(), options).diagnostics;
    assert!(diagnostics.iter().all(|diagnostic| diagnostic.help.as_ref().is_some_and(|help| !help.is_empty())));
}

fn mm() -> ReadingOptions {
    ReadingOptions::from(MM)
}

/// Events without their places.
#[track_caller]
fn events_without_places(text: &str, options: impl Into<ReadingOptions>) -> Vec<String> {
    events_with(text, options).iter().map(|event| event.split_once(' ').unwrap().1.to_owned()).collect()
}
