//! Arcs, curves and holes into straight motions.
//!
//! Planner, scout and the survey of a file all see a program through an expander, so that they agree on its motions.
//! Arcs and curves become chords that leave them by no more than the tolerance; their ends are exact. A hole becomes the
//! rapids and feeds of its cycle, level by level along the tool axis.

use crate::config::Config;
use crate::diag::{Diagnostic, Severity};
use crate::kinematics::Pose;
use crate::nalgebra::{Point3, UnitVector3, Vector3};
use crate::program::{Arc, Drilling, Event, Feed, Hole, Location, Move, Spline, ToolCall};

use super::fault::Fault;

/// More steps than this are no drilling.
const MOST_STEPS: u32 = 10_000;

/// More chords than this in one piece of a curve are a fault of the file.
const MOST_CHORDS: f64 = 1e6;

/// Levels closer than this are the same, mm.
const SAME_LEVEL: f64 = 1e-9;

/// Turns events into events without arcs, curves and holes.
#[derive(Debug, Clone, Default)]
pub struct Expander {
    tolerance: f64,
    stated: Option<f64>,
    allow_stated: bool,
    peck_gap: f64,
    default_tool: Option<u32>,
    /// A tool has been called, or none is assumed.
    armed: bool,
    here: Option<Pose>,
    /// What follows begins with the safe sequence.
    fresh: bool,
    warnings: Vec<Diagnostic>,
}

/// Takes straight events; an error ends the expansion.
type Out<'o, E> = &'o mut dyn FnMut(Location, &Event<'_>) -> Result<(), E>;

impl Expander {
    /// With the tolerance and the tool of a configuration.
    #[must_use]
    pub fn new(config: &Config) -> Self {
        Self {
            tolerance: config.tolerance,
            allow_stated: config.allow_lintol,
            peck_gap: config.defaults.peck_gap,
            default_tool: config.defaults.tool,
            armed: config.defaults.tool.is_none(),
            fresh: true,
            ..Self::default()
        }
    }

    /// Whether a motion needs nothing but to be remembered; remembers it then.
    #[inline]
    pub(super) fn passes(&mut self, motion: &Move) -> bool {
        if self.armed {
            self.here = Some(motion.pose);
            self.fresh = false;
        }
        self.armed
    }

    /// Takes the remarks that have come up.
    pub(super) fn take_warnings(&mut self) -> Vec<Diagnostic> {
        std::mem::take(&mut self.warnings)
    }

    /// Hands on one event, or the straight events that it stands for.
    ///
    /// # Errors
    /// Those of `out`, and what cannot be expanded faithfully.
    pub fn event<E: From<Diagnostic>>(&mut self, at: Location, event: &Event<'_>, out: Out<'_, E>) -> Result<(), E> {
        match event {
            Event::Move(motion) => {
                self.arm(at, out)?;
                self.passes(motion);
                return out(at, event);
            }
            Event::Arc(arc) => {
                self.arm(at, out)?;
                return self.arc(at, arc, out);
            }
            Event::Spline(spline) => {
                self.arm(at, out)?;
                return self.spline(at, spline, out);
            }
            Event::Hole(hole) => {
                self.arm(at, out)?;
                return self.hole(at, hole, out);
            }
            Event::Tolerance(tolerance) => {
                self.state_tolerance(at, *tolerance);
                return Ok(());
            }
            Event::Tool(_) => {
                self.armed = true;
                self.fresh = true;
            }
            Event::Operation(_)
            | Event::SafeSequence
            | Event::Frame(_)
            | Event::Home
            | Event::Stop
            | Event::OptionalStop
            | Event::Insert(_)
            | Event::Code { .. } => self.fresh = true,
            Event::From(pose) if self.fresh => self.here = Some(*pose),
            _ => {}
        }
        out(at, event)
    }

    /// Calls the tool of the configuration before the first motion of a program that calls none.
    fn arm<E>(&mut self, at: Location, out: Out<'_, E>) -> Result<(), E> {
        if !self.armed
            && let Some(number) = self.default_tool
        {
            self.armed = true;
            out(at, &Event::Tool(ToolCall { number, ..ToolCall::default() }))?;
        }
        Ok(())
    }

    fn state_tolerance(&mut self, at: Location, tolerance: Option<f64>) {
        self.stated = tolerance.filter(|stated| self.allow_stated || *stated <= self.tolerance);
        if let Some(stated) = tolerance
            && self.stated.is_none()
        {
            let fault = Fault::new(format_args!(
                "LINTOL/{stated} mm is more than the tolerance of {} mm, which stays in force",
                self.tolerance
            ))
            .help("give `--allow-lintol` if the CL data may widen the tolerance");
            self.warnings.push(fault.at(at, Severity::Warning));
        }
    }

    fn chord_tolerance(&self) -> f64 {
        self.stated.unwrap_or(self.tolerance)
    }

    fn go<E>(&mut self, at: Location, pose: Pose, rapid: bool, feed: Option<Feed>, out: Out<'_, E>) -> Result<(), E> {
        self.here = Some(pose);
        self.fresh = false;
        out(at, &Event::Move(Move { pose, rapid, feed }))
    }

    /// Behind a tool change or a stop the tool first comes back to where the path goes on.
    fn resume<E>(&mut self, at: Location, start: Pose, feed: Option<Feed>, out: Out<'_, E>) -> Result<(), E> {
        if self.fresh { self.go(at, start, false, feed, out) } else { Ok(()) }
    }

    fn arc<E>(&mut self, at: Location, arc: &Arc, out: Out<'_, E>) -> Result<(), E> {
        self.resume(at, arc.start, arc.feed, out)?;
        let normal = arc.normal.into_inner();
        let along = |point: Point3<f64>| (point - arc.centre).dot(&normal);
        let flat = |point: Point3<f64>| (point - arc.centre) - normal * along(point);
        let (first, last) = (flat(arc.start.tip), flat(arc.end.tip));
        let (first_radius, last_radius) = (first.norm(), last.norm());
        let radius = first_radius.max(last_radius);
        // A chord over the angle t is off by r (1 - cos t/2), which is at most r t²/8.
        let step = (8.0 * self.chord_tolerance() / radius).sqrt().min(std::f64::consts::FRAC_PI_2);
        let chords = (arc.angle / step).ceil().max(1.0);
        let (u, v) = (first / first_radius, normal.cross(&first) / first_radius);
        let (start, rise) = (along(arc.start.tip), along(arc.end.tip) - along(arc.start.tip));
        let mut index = 1.0;
        while index < chords {
            let part = index / chords;
            let (sine, cosine) = (arc.angle * part).sin_cos();
            let radius = first_radius + (last_radius - first_radius) * part;
            let tip = arc.centre + (u * cosine + v * sine) * radius + normal * (start + rise * part);
            self.go(at, Pose { tip, axis: arc.start.axis }, false, arc.feed, out)?;
            index += 1.0;
        }
        self.go(at, arc.end, false, arc.feed, out)
    }

    fn spline<E: From<Diagnostic>>(&mut self, at: Location, spline: &Spline<'_>, out: Out<'_, E>) -> Result<(), E> {
        let Spline { knots, points, axis, feed } = *spline;
        let (Some(&first), Some(&last)) = (points.first(), points.last()) else { return Ok(()) };
        self.resume(at, Pose { tip: first, axis }, feed, out)?;
        for span in 3..points.len() {
            let (from, to) = (knots[span], knots[span + 1]);
            if from >= to {
                continue;
            }
            let piece =
                [[from; 3], [from, from, to], [from, to, to], [to; 3]].map(|at| blossom(knots, points, span, at));
            let [a, b, c, d] = piece;
            // A chord over 1/n of the parameter is off by at most |f''| / (8 n²), and f'' by 6 times these differences.
            let bend = (a - b * 2.0 + c).norm().max((b - c * 2.0 + d).norm());
            let chords = (6.0 * bend / (8.0 * self.chord_tolerance())).sqrt().ceil().max(1.0);
            if chords.is_nan() || chords > MOST_CHORDS {
                let fault = Fault::new("this curve cannot be cut into chords").help("check its knots");
                return Err(fault.at(at, Severity::Error).into());
            }
            let mut index = 1.0;
            while index <= chords {
                let t = index / chords;
                let s = 1.0 - t;
                let tip = a * (s * s * s) + b * (3.0 * s * s * t) + c * (3.0 * s * t * t) + d * (t * t * t);
                // The last point is written below, as the file has it.
                if index < chords || span + 1 < points.len() {
                    self.go(at, Pose { tip: Point3::from(tip), axis }, false, feed, out)?;
                }
                index += 1.0;
            }
        }
        self.go(at, Pose { tip: last, axis }, false, feed, out)
    }

    fn hole<E: From<Diagnostic>>(&mut self, at: Location, hole: &Hole, out: Out<'_, E>) -> Result<(), E> {
        let refuse = |fault: Fault| Err(fault.at(at, Severity::Error).into());
        if let Drilling::Tap { .. } = hole.drilling {
            return refuse(
                Fault::new("a thread needs spindle and feed in step, and no tapping cycle of a control is written yet")
                    .help("take the tapping out of the CL data and program it at the control"),
            );
        }
        let (tip, axis) = (hole.top.tip, hole.top.axis);
        let level = |height: f64| Pose { tip: tip + axis.into_inner() * height, axis };
        // Over to the hole at the level of the tool or at that of the clearance, whichever is higher.
        let before = self.here.filter(|_| !self.fresh);
        let before =
            before.filter(|pose| (pose.axis.into_inner() - axis.into_inner()).norm() <= super::planner::SAME_AXIS);
        if let Some(before) = before {
            let height = (before.tip - tip).dot(&axis);
            let lift = hole.clearance - height;
            if lift > SAME_LEVEL {
                let tip = before.tip + axis.into_inner() * lift;
                self.go(at, Pose { tip, axis }, true, hole.feed, out)?;
            } else if lift < -SAME_LEVEL {
                self.go(at, level(height), true, hole.feed, out)?;
            }
        }
        self.go(at, level(hole.clearance), true, hole.feed, out)?;
        let mut done = 0.0;
        let mut steps = 0;
        while done < hole.depth {
            let step = match hole.drilling {
                Drilling::Peck { first, .. } if steps == 0 => first,
                Drilling::Peck { later: step, .. } | Drilling::ChipBreak { step, .. } => step,
                _ => hole.depth,
            };
            steps += 1;
            if steps > MOST_STEPS {
                let text =
                    format!("a hole {} mm deep in steps of {step} mm takes more than {MOST_STEPS} steps", hole.depth);
                return refuse(Fault::new(text).help("check the step of the cycle and its unit"));
            }
            if steps > 1 {
                let approach = (self.peck_gap - done).min(hole.clearance);
                match hole.drilling {
                    Drilling::Peck { .. } => self.go(at, level(approach), true, hole.feed, out)?,
                    Drilling::ChipBreak { back, .. } => {
                        let height = (back.unwrap_or(self.peck_gap) - done).min(hole.clearance);
                        self.go(at, level(height), true, hole.feed, out)?;
                    }
                    _ => {}
                }
            }
            done += step;
            // A last step of nothing but rounding is part of the one before.
            if done > hole.depth - SAME_LEVEL {
                done = hole.depth;
            }
            self.go(at, level(-done), false, hole.feed, out)?;
            if done < hole.depth && matches!(hole.drilling, Drilling::Peck { .. }) {
                self.go(at, level(hole.clearance), true, hole.feed, out)?;
            }
        }
        if let Some(dwell) = hole.dwell {
            out(at, &Event::Delay(dwell))?;
        }
        if hole.drilling == Drilling::Ream {
            self.go(at, level(hole.clearance), false, hole.feed, out)?;
            if hole.back_to - hole.clearance <= SAME_LEVEL {
                return Ok(());
            }
        }
        self.go(at, level(hole.back_to), true, hole.feed, out)
    }
}

/// The polar form of a cubic B-spline over one span of its knots.
fn blossom(knots: &[f64], points: &[Point3<f64>], span: usize, at: [f64; 3]) -> Vector3<f64> {
    let mut d = [0, 1, 2, 3].map(|index| points[span - 3 + index].coords);
    for (round, u) in at.into_iter().enumerate() {
        for index in (round + 1..=3).rev() {
            let (left, right) = (knots[span - 3 + index], knots[span + index - round]);
            let part = (u - left) / (right - left);
            d[index] = d[index - 1] * (1.0 - part) + d[index] * part;
        }
    }
    d[3]
}

/// The height of a point above a plane along a direction, mm; `None` if it does not lead there.
pub(super) fn distance_to(plane: &crate::program::Plane, tip: &Point3<f64>, axis: &UnitVector3<f64>) -> Option<f64> {
    let along = axis.dot(&plane.normal);
    (along > 1e-3).then(|| (plane.distance - tip.coords.dot(&plane.normal)) / along)
}
