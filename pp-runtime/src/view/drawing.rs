//! Drawing of a machine at its zero position: which lengths its dimensions are, and which way each rotary axis turns.
//!
//! The table is at its reference point, and the spindle above it with a tool of [`GAUGE_LENGTH`], so that centre lines
//! of the workpiece side are measured from the one and those of the tool side from the other. The views are not to
//! scale where a dimension has no value yet.

use std::f64::consts::PI;
use std::io;

use nalgebra::{Point3, Vector3};
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use crate::kinematics::{AnyMachine, Axis, AxisKind, Side, Sign};

use super::picture::{CENTRE_LINE, Chart, ChartPoint, LIMIT, PART, TITLE, failed, svg, view};

/// Height of the drawing.
const HEIGHT: u32 = 760;

/// Gauge length of the drawn tool, mm.
const GAUGE_LENGTH: f64 = 120.0;

/// Lengths in the place of required dimensions without a value, mm; each has another one.
const PLACE_HOLDERS: [f64; 4] = [45.0, 70.0, 95.0, 120.0];

/// Shortest offset that is drawn, mm.
const NO_OFFSET: f64 = 1e-6;

/// Share of a direction along the line of sight from which an axis is seen end on.
const END_ON: f64 = 0.9;

/// A direction of sight.
struct Sight {
    title: &'static str,
    /// Names of the directions across and up, and their indices.
    names: [&'static str; 2],
    directions: [usize; 2],
    /// Towards the eye.
    eye: Vector3<f64>,
}

const VIEWS: [Sight; 3] = [
    Sight { title: "looking along -Z", names: ["X", "Y"], directions: [0, 1], eye: Vector3::new(0.0, 0.0, 1.0) },
    Sight { title: "looking along +Y", names: ["X", "Z"], directions: [0, 2], eye: Vector3::new(0.0, -1.0, 0.0) },
    Sight { title: "looking along -X", names: ["Y", "Z"], directions: [1, 2], eye: Vector3::new(1.0, 0.0, 0.0) },
];

/// Draws a machine with its dimensions.
///
/// # Errors
/// Those of the picture.
pub(crate) fn drawing(machine: &dyn AnyMachine) -> io::Result<String> {
    let drawn = Drawn::of(machine);
    svg(HEIGHT, |area| {
        let areas = area.split_evenly((1, VIEWS.len()));
        areas.iter().zip(VIEWS).try_for_each(|(area, Sight { title, names, directions, eye })| {
            let points = drawn.points().map(|point| directions.map(|index| point[index]));
            let mut chart = view(area, &format!("{}, {title}", machine.name()), names, points)?;
            drawn.draw(&mut chart, directions, &eye)
        })
    })
}

/// A rotary axis of the drawing.
struct DrawnCentreLine {
    axis: Axis,
    direction: Vector3<f64>,
    point: Point3<f64>,
    /// From where it is measured: the reference point of the table, or the gauge line.
    from: Point3<f64>,
    /// What its offset is along each direction, if it has one.
    lengths: [Option<String>; 3],
}

struct Drawn {
    lines: Vec<DrawnCentreLine>,
    gauge: Point3<f64>,
}

impl Drawn {
    fn of(machine: &dyn AnyMachine) -> Self {
        let mut drawn = machine.to_boxed();
        let dimensions = machine.dimensions();
        for index in (0..dimensions.len()).filter(|index| !machine.dimension(*index).is_finite()) {
            drawn.set_dimension(index, PLACE_HOLDERS[index % PLACE_HOLDERS.len()]);
        }
        drawn.set_up(Vector3::zeros(), GAUGE_LENGTH);
        let gauge = Point3::origin() + drawn.tool_axis().into_inner() * GAUGE_LENGTH;
        let is_rotary = |index: &usize| machine.axes()[*index].kind == AxisKind::Rotary;
        let lines = (0..machine.axes().len()).filter(is_rotary).map(|index| {
            let (axis, joint) = (machine.axes()[index], drawn.joint(index));
            let from = if axis.side == Side::Workpiece { Point3::origin() } else { gauge };
            let offset = joint.point - from;
            let lengths = std::array::from_fn(|component| {
                (offset[component].abs() > NO_OFFSET)
                    .then(|| length(machine, &*drawn, index, component, offset[component]))
            });
            DrawnCentreLine { axis, direction: joint.direction.into_inner(), point: joint.point, from, lengths }
        });
        Self { lines: lines.collect(), gauge }
    }

    fn points(&self) -> impl Iterator<Item = Point3<f64>> {
        let size = self.size();
        let around = move |point: Point3<f64>| {
            let sides = [Vector3::x(), Vector3::y(), Vector3::z()].map(|side| side * (0.35 * size));
            sides.into_iter().flat_map(move |side| [point + side, point - side])
        };
        let ends = self.lines.iter().map(|line| line.point).chain([Point3::origin(), self.gauge]);
        ends.flat_map(around)
    }

    /// Extent of the drawing, mm.
    fn size(&self) -> f64 {
        let points = || self.lines.iter().map(|line| line.point).chain([Point3::origin(), self.gauge]);
        points().flat_map(|one| points().map(move |other| (one - other).norm())).fold(GAUGE_LENGTH, f64::max)
    }

    fn draw(&self, chart: &mut Chart<'_, '_>, directions: [usize; 2], eye: &Vector3<f64>) -> io::Result<()> {
        let size = self.size();
        let flat = |point: &Point3<f64>| (point[directions[0]], point[directions[1]]);
        let half = 0.3 * size;
        if directions == [0, 1] {
            // The face of the table.
            let face = Rectangle::new([(-half, -half), (half, half)], PART.mix(0.12).filled());
            chart.draw_series([face]).map_err(failed)?;
        } else {
            let face = [(-half, 0.0), (half, 0.0)];
            chart.draw_series(LineSeries::new(face, PART.stroke_width(8))).map_err(failed)?;
            let tool = [flat(&Point3::origin()), flat(&self.gauge)];
            chart.draw_series(LineSeries::new(tool, PART.stroke_width(3))).map_err(failed)?;
            let (x, z) = flat(&self.gauge);
            let nose = [(x - 0.12 * size, z), (x + 0.12 * size, z)];
            chart.draw_series(LineSeries::new(nose, PART.stroke_width(8))).map_err(failed)?;
            text(chart, (x - 0.14 * size, z), "gauge line", BLACK, HPos::Right)?;
            text(chart, (-half - 0.02 * size, 0.0), "table", BLACK, HPos::Right)?;
        }
        chart.draw_series([Cross::new((0.0, 0.0), 14, BLACK.stroke_width(3))]).map_err(failed)?;
        for (index, line) in self.lines.iter().enumerate() {
            let (x, z) = flat(&line.point);
            let (dx, dz) = (line.direction[directions[0]], line.direction[directions[1]]);
            let towards = line.direction.dot(eye);
            let name = line.axis.letter.to_string();
            if towards.abs() > END_ON {
                let radius = 0.09 * size;
                chart.draw_series([Circle::new((x, z), 10, CENTRE_LINE.stroke_width(3))]).map_err(failed)?;
                let turn = line.turn() * towards.signum();
                let at = |angle: f64| (x + radius * angle.cos(), z + radius * angle.sin());
                let arc = (0..=30).map(|step| at(turn * 1.5 * PI * f64::from(step) / 30.0));
                chart.draw_series(LineSeries::new(arc, CENTRE_LINE.stroke_width(4))).map_err(failed)?;
                // Head of the arrow: at its end, back along the arc.
                let end = turn * 1.5 * PI;
                for share in [0.75, 1.25] {
                    let back = end - turn * 0.35;
                    let side = (x + share * radius * back.cos(), z + share * radius * back.sin());
                    chart.draw_series(LineSeries::new([at(end), side], CENTRE_LINE.stroke_width(4))).map_err(failed)?;
                }
                let what = if line.axis.side == Side::Workpiece { "table" } else { "head" };
                text(
                    chart,
                    (x + 1.1 * radius, z + 0.9 * radius),
                    &format!("{name}+, {what}"),
                    CENTRE_LINE,
                    HPos::Left,
                )?;
            } else {
                let reach = 0.32 * size;
                let ends = [(x - reach * dx, z - reach * dz), (x + reach * dx, z + reach * dz)];
                chart.draw_series(DashedLineSeries::new(ends, 24, 10, CENTRE_LINE.stroke_width(3))).map_err(failed)?;
                text(chart, (ends[1].0 + 0.02 * size, ends[1].1), &name, CENTRE_LINE, HPos::Left)?;
            }
            // Dimension lines, each beside the ones before.
            let aside = 0.12 * size * (index as f64 + 1.0);
            let from = flat(&line.from);
            if let Some(length) = &line.lengths[directions[0]] {
                let at = from.1.min(z) - aside;
                dimension(chart, [(from.0, at), (x, at)])?;
                text(chart, (0.5 * (from.0 + x), at - 0.05 * size), length, LIMIT, HPos::Center)?;
            }
            if let Some(length) = &line.lengths[directions[1]] {
                let at = from.0.min(x) - aside;
                dimension(chart, [(at, from.1), (at, z)])?;
                text(chart, (at - 0.02 * size, 0.5 * (from.1 + z)), length, LIMIT, HPos::Right)?;
            }
        }
        Ok(())
    }
}

impl DrawnCentreLine {
    /// `1.0` where the positive word turns the table or the head right-handed about the direction, else `-1.0`.
    fn turn(&self) -> f64 {
        // A positive word rotates the tool, seen from the part: a table goes the other way.
        let of_side = if self.axis.side == Side::Workpiece { -1.0 } else { 1.0 };
        let of_sign = if self.axis.sign == Sign::Plus { 1.0 } else { -1.0 };
        of_side * of_sign
    }
}

/// A dimension line.
fn dimension(chart: &mut Chart<'_, '_>, ends: [ChartPoint; 2]) -> io::Result<()> {
    chart.draw_series(LineSeries::new(ends, LIMIT.stroke_width(3))).map_err(failed)?;
    chart.draw_series(ends.map(|end| Circle::new(end, 6, LIMIT.filled()))).map(drop).map_err(failed)
}

/// A text at a point, from it to the right or the left, or on both sides of it.
fn text(chart: &mut Chart<'_, '_>, at: ChartPoint, text: &str, colour: RGBColor, side: HPos) -> io::Result<()> {
    let style = ("sans-serif", TITLE).into_font().color(&colour).pos(Pos::new(side, VPos::Center));
    chart.draw_series([Text::new(text.to_owned(), at, style)]).map(drop).map_err(failed)
}

/// Name and value of an offset: the dimension that it is, or its number.
fn length(machine: &dyn AnyMachine, drawn: &dyn AnyMachine, axis: usize, component: usize, offset: f64) -> String {
    // How the offset changes with each dimension.
    let changes = |dimension: usize| {
        let mut changed = drawn.to_boxed();
        changed.set_dimension(dimension, drawn.dimension(dimension) + 1.0);
        changed.set_up(Vector3::zeros(), GAUGE_LENGTH);
        changed.joint(axis).point[component] - drawn.joint(axis).point[component]
    };
    let named: Vec<(usize, f64)> = (0..machine.dimensions().len())
        .map(|dimension| (dimension, changes(dimension)))
        .filter(|(_, change)| change.abs() > NO_OFFSET)
        .collect();
    match named[..] {
        [(dimension, change)]
            if (change.abs() - 1.0).abs() < NO_OFFSET
                && (offset - change * drawn.dimension(dimension)).abs() < NO_OFFSET =>
        {
            let (name, value) = (machine.dimensions()[dimension].name, machine.dimension(dimension));
            let sign = if change < 0.0 { "-" } else { "" };
            if value.is_finite() {
                format!("{sign}{name} = {:.3}", change * value)
            } else {
                format!("{sign}{name} = ?")
            }
        }
        _ if named.iter().any(|(dimension, _)| !machine.dimension(*dimension).is_finite()) => {
            let names: Vec<&str> = named.iter().map(|(dimension, _)| machine.dimensions()[*dimension].name).collect();
            format!("of {}", names.join(", "))
        }
        _ => format!("{offset:.3}"),
    }
}
