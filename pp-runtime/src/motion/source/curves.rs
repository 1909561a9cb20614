//! NURBS curves into straight motions.
//!
//! The chords deviate from a curve by no more than the tolerance; its ends are exact. Arcs and holes stay one motion
//! each: their tool axis is constant, and the planner decides whether the control interpolates them.

use crate::diag::code::plan;
use crate::kinematics::Pose;
use crate::motion::policy::Policy;
use crate::nalgebra::{Point3, Vector3};
use crate::program::{Move, Shown, Spline};

use crate::motion::fault::Fault;
use crate::tolerance::writer::MOST_CHORDS;

/// The chord tolerance in force.
#[derive(Debug, Clone)]
pub(crate) struct Curves {
    /// Tolerance of the configuration for the whole program.
    whole_program_mm: f64,
    /// That for the operation.
    configured_mm: f64,
    /// Tolerance of LINTOL.
    stated_mm: Option<f64>,
    /// LINTOL may exceed the tolerance of the configuration.
    may_widen: bool,
}

impl Curves {
    pub(crate) fn new(policy: Policy<'_>) -> Self {
        let configured_mm = policy.options.tolerance_mm;
        let may_widen = policy.options.allow_lintol;
        Self { whole_program_mm: configured_mm, configured_mm, stated_mm: None, may_widen }
    }

    /// The tolerance in force, mm.
    pub(crate) fn tolerance(&self) -> f64 {
        self.stated_mm.filter(|stated| self.may_state(*stated)).unwrap_or(self.configured_mm)
    }

    /// Whether LINTOL may state a tolerance.
    fn may_state(&self, stated_mm: f64) -> bool {
        self.may_widen || stated_mm <= self.configured_mm
    }

    /// Sets the tolerance of the configuration for an operation, mm; `None`: that for the whole program.
    pub(crate) fn configure(&mut self, tolerance_mm: Option<f64>) {
        self.configured_mm = tolerance_mm.unwrap_or(self.whole_program_mm);
    }

    /// Takes the tolerance of LINTOL, mm.
    ///
    /// # Errors
    /// A warning if it is wider than allowed: then the tolerance of the configuration stays in force.
    pub(crate) fn state_tolerance(&mut self, tolerance: Option<f64>) -> Result<(), Fault> {
        self.stated_mm = tolerance;
        match tolerance {
            Some(stated) if !self.may_state(stated) => Err(plan::TOLERANCE
                .fault(format_args!(
                    "LINTOL/{} mm exceeds the tolerance of {} mm in the configuration, which stays in force",
                    Shown(stated),
                    Shown(self.configured_mm)
                ))
                .help("use `--allow-lintol` to let the CL data widen the tolerance")),
            Some(_) | None => Ok(()),
        }
    }
}

/// Motion to the start of a curve; `None` if it has no points.
pub(crate) fn start(spline: &Spline<'_>) -> Option<Move> {
    spline.points.first().map(|first| to_point(*first, spline))
}

fn to_point(tip: Point3<f64>, spline: &Spline<'_>) -> Move {
    Move { pose: Pose { tip, axis: spline.axis }, rapid: false, feed: spline.feed }
}

/// Hands on the chords of a curve from its start to its end, or a fault if it cannot be cut into chords; `tolerance` in
/// mm.
pub(crate) fn chords<E>(
    spline: &Spline<'_>,
    tolerance: f64,
    mut out: impl FnMut(Result<Move, Fault>) -> Result<(), E>,
) -> Result<(), E> {
    let Spline { knots, points, .. } = *spline;
    let Some(&last) = points.last() else { return Ok(()) };
    for span in 3..points.len() {
        let (from, to) = (knots[span], knots[span + 1]);
        if from >= to {
            continue;
        }
        let piece = [[from; 3], [from, from, to], [from, to, to], [to; 3]].map(|at| blossom(knots, points, span, at));
        let [a, b, c, d] = piece;
        // A chord over 1/n of the parameter deviates by at most |f''| / (8 n²), and |f''| is at most 6 times the larger
        // of these differences.
        let bend = (a - b * 2.0 + c).norm().max((b - c * 2.0 + d).norm());
        let chords = (6.0 * bend / (8.0 * tolerance)).sqrt().ceil().max(1.0);
        if chords.is_nan() || chords > MOST_CHORDS {
            return out(Err(plan::ARC
                .fault("this curve cannot be cut into chords")
                .help("check its knots, its points and LINTOL")));
        }
        let mut index = 1.0;
        while index <= chords {
            let t = index / chords;
            let s = 1.0 - t;
            let tip = a * (s * s * s) + b * (3.0 * s * s * t) + c * (3.0 * s * t * t) + d * (t * t * t);
            // The last point is handed on below, exactly as in the file.
            if index < chords || span + 1 < points.len() {
                out(Ok(to_point(Point3::from(tip), spline)))?;
            }
            index += 1.0;
        }
    }
    out(Ok(to_point(last, spline)))
}

/// Polar form (blossom) of a cubic B-spline over one span of its knots, at three parameters.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::config::Config;
    use crate::diag::Diagnostic;
    use crate::kinematics::machines::Xyz;
    use crate::motion::source::{ItemAction, ProgramItem, Source, Stage};
    use crate::program::{Arc, Event, Interruption, Location, MachineFunction, NewStart, ToolCall, ToolMotion};

    const AT: Location = Location { line: 1, column: 1 };

    fn up(tip: [f64; 3]) -> Pose {
        Pose { tip: Point3::from(tip), axis: Vector3::z_axis() }
    }

    /// Tip and rapid.
    type Motion = ([f64; 3], bool);

    /// Motions of some events, and every other item as text.
    fn expanded(config: &Config, events: &[Event<'_>]) -> Result<(Vec<Motion>, Vec<String>), Diagnostic> {
        let mut source = Source::new(&Xyz::default(), config.policy());
        let mut seen = Seen::default();
        for event in events {
            source.event(AT, event, &mut seen)?;
        }
        source.finish(&mut seen)?;
        Ok((seen.motions, seen.others))
    }

    /// Items that have been handed on.
    #[derive(Default)]
    struct Seen {
        motions: Vec<Motion>,
        others: Vec<String>,
    }

    impl Stage for Seen {
        type Stop = Diagnostic;

        fn take(&mut self, item: &ProgramItem<'_>) -> Result<(), Diagnostic> {
            match item.action {
                ItemAction::Line { motion, .. } => self.motions.push((motion.pose.tip.into(), motion.rapid)),
                other => self.others.push(format!("{other:?}")),
            }
            Ok(())
        }
    }

    fn go(tip: [f64; 3]) -> Event<'static> {
        Event::Motion(ToolMotion::Move(Move { pose: up(tip), rapid: false, feed: None }))
    }

    fn arc(start: [f64; 3], end: [f64; 3], angle: f64) -> Event<'static> {
        let (start, end) = (up(start), up(end));
        Event::Motion(ToolMotion::Arc(Arc {
            start,
            end,
            centre: Point3::origin(),
            normal: Vector3::z_axis(),
            angle_rad: angle,
            feed: None,
        }))
    }

    /// Distance of a point from the line between two others.
    fn off_line(point: [f64; 3], from: [f64; 3], to: [f64; 3]) -> f64 {
        let (p, a, b) = (Point3::from(point), Point3::from(from), Point3::from(to));
        let t = ((p - a).dot(&(b - a)) / (b - a).norm_squared()).clamp(0.0, 1.0);
        (p - (a + (b - a) * t)).norm()
    }

    #[test]
    fn chords_deviate_from_a_curve_by_the_tolerance_at_most() {
        let points: Vec<Point3<f64>> = [[0.0, 0.0], [5.0, 12.0], [14.0, -8.0], [20.0, 9.0], [31.0, 2.0]]
            .iter()
            .map(|p| Point3::new(p[0], p[1], 1.0))
            .collect();
        let knots = [0.0, 0.0, 0.0, 0.0, 0.4, 1.0, 1.0, 1.0, 1.0];
        let spline = Event::Motion(ToolMotion::Spline(Spline {
            knots: &knots,
            points: &points,
            axis: Vector3::z_axis(),
            feed: None,
        }));
        let (motions, _) = expanded(&Config::default(), &[go([0.0, 0.0, 1.0]), spline]).expect("faithful");
        assert_eq!(motions.last().map(|(tip, _)| *tip), Some([31.0, 2.0, 1.0]));
        // The curve by its basis functions (Cox and de Boor), which share no code with the polar form.
        fn basis(knots: &[f64], index: usize, degree: usize, t: f64) -> f64 {
            if degree == 0 {
                return f64::from(u8::from(knots[index] <= t && t < knots[index + 1]));
            }
            let share = |a: f64, b: f64| if b > 0.0 { a / b } else { 0.0 };
            share(t - knots[index], knots[index + degree] - knots[index]) * basis(knots, index, degree - 1, t)
                + share(knots[index + degree + 1] - t, knots[index + degree + 1] - knots[index + 1])
                    * basis(knots, index + 1, degree - 1, t)
        }
        for step in 0..2000 {
            let t = f64::from(step) / 2000.0;
            let mut at = Vector3::zeros();
            for (index, point) in points.iter().enumerate() {
                at += point.coords * basis(&knots, index, 3, t);
            }
            let nearest =
                motions.windows(2).map(|pair| off_line(at.into(), pair[0].0, pair[1].0)).fold(f64::MAX, f64::min);
            assert!(nearest <= 0.01, "{nearest} at {t}");
        }
        assert!(motions.len() < 100, "{}", motions.len());
    }

    #[test]
    fn an_arc_after_a_stop_begins_with_the_motion_back_to_its_start() {
        let events = [
            go([20.0, 0.0, 0.0]),
            Event::Interruption(Interruption::Stop),
            arc([20.0, 0.0, 0.0], [0.0, 20.0, 0.0], 1.57),
        ];
        let (motions, _) = expanded(&Config::default(), &events).expect("faithful");
        assert_eq!(motions[1..], [([20.0, 0.0, 0.0], false)], "the arc itself is no straight motion");
    }

    #[test]
    fn lintol_narrows_the_tolerance_and_widens_it_only_if_allowed() {
        let count = |config: &Config, stated: Option<f64>| {
            let points = [[20.0, 0.0], [20.0, 11.0], [11.0, 20.0], [0.0, 20.0]].map(|[x, y]| Point3::new(x, y, 0.0));
            let knots = [0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0];
            let spline = Event::Motion(ToolMotion::Spline(Spline {
                knots: &knots,
                points: &points,
                axis: Vector3::z_axis(),
                feed: None,
            }));
            let events = [go([20.0, 0.0, 0.0]), Event::Function(MachineFunction::Tolerance(stated)), spline];
            expanded(config, &events).expect("faithful").0.len()
        };
        let config = Config::default();
        let usual = count(&config, None);
        assert!(count(&config, Some(0.001)) > 2 * usual);
        assert_eq!(count(&config, Some(1.0)), usual);
        let mut config = config;
        config.motion.allow_lintol = true;
        assert!(count(&config, Some(1.0)) < usual);
    }

    #[test]
    fn the_tool_of_the_configuration_is_called_where_the_cl_data_calls_none() {
        let mut config = Config::default();
        config.motion.defaults.tool = Some(7);
        let (_, others) = expanded(&config, &[go([0.0; 3]), go([1.0, 0.0, 0.0])]).expect("faithful");
        assert_eq!(others.len(), 1);
        assert!(others[0].contains("number: 7"), "{others:?}");
        let called = Event::NewStart(NewStart::Tool(ToolCall { number: 3, ..ToolCall::default() }));
        let (_, others) = expanded(&config, &[called, go([0.0; 3])]).expect("faithful");
        assert_eq!(others.len(), 1);
    }
}
