//! Pictures without a script: the path in three views, the axes over time, the part on the table.
//!
//! Views are parallel projections along the axes of the workpiece, with one scale for both directions.

use std::collections::HashSet;
use std::io;
use std::ops::Range;

use nalgebra::{Point3, Vector3};
use plotters::coord::types::RangedCoordf64;
use plotters::prelude::*;

use crate::kinematics::{AxisKind, Side};

use super::ViewedProgram;
use super::executed::{ExecutedPoint, PointKind};

/// Width of a picture; it is shown at half of it, so that lines are fine.
const WIDTH: u32 = 2000;

/// Height of a view, and of the plot of one axis.
const VIEW_HEIGHT: u32 = 760;
const PLOT_HEIGHT: u32 = 260;

/// Heights of text.
pub(super) const TITLE: u32 = 30;
const LABEL: u32 = 22;

/// Largest number of points of all lines of one colour in a view or a plot; more would not be seen.
const MOST_POINTS: usize = 8000;

/// First distance between a line and the points left out of it.
const FINEST: f64 = 0.25;

/// Share of a view that stays free on each side.
const MARGIN: f64 = 0.06;

/// Smallest extent of a view, mm.
const SMALLEST_MM: f64 = 1.0;

/// Length of an arrow of an axis, as a share of the view.
const ARROW: f64 = 0.12;

const FEED: RGBColor = RGBColor(0x0b, 0x5c, 0xad);
const RAPID: RGBColor = RGBColor(0xd9, 0x7b, 0x1c);
pub(super) const LIMIT: RGBColor = RGBColor(0xc6, 0x28, 0x28);
pub(super) const CENTRE_LINE: RGBColor = RGBColor(0x2e, 0x7d, 0x32);
pub(super) const PART: RGBColor = RGBColor(0x60, 0x60, 0x60);

/// Drawing area of an SVG.
type Area<'a> = DrawingArea<SVGBackend<'a>, plotters::coord::Shift>;

/// A point of a chart: its coordinates to the right and up.
pub(super) type ChartPoint = (f64, f64);

/// Chart with numbers along both axes.
pub(super) type Chart<'a, 'b> = ChartContext<'b, SVGBackend<'a>, Cartesian2d<RangedCoordf64, RangedCoordf64>>;

/// Projections: title, names of the two directions, and the directions.
const VIEWS: [(&str, [&str; 2], [usize; 2]); 3] = [
    ("from above", ["X", "Y"], [0, 1]),
    ("from the front", ["X", "Z"], [0, 2]),
    ("from the right", ["Y", "Z"], [1, 2]),
];

pub(super) fn failed(error: impl std::fmt::Display) -> io::Error {
    io::Error::other(format!("picture: {error}"))
}

/// Draws an SVG of this height.
pub(super) fn svg(height: u32, draw: impl FnOnce(&Area<'_>) -> io::Result<()>) -> io::Result<String> {
    let mut text = String::new();
    {
        let area = SVGBackend::with_string(&mut text, (WIDTH, height)).into_drawing_area();
        area.fill(&WHITE).map_err(failed)?;
        draw(&area)?;
        area.present().map_err(failed)?;
    }
    Ok(text)
}

/// The path of each set-up in three views, and the axes over time.
pub(crate) fn path_and_axes(program: &ViewedProgram<'_>) -> io::Result<String> {
    let set_ups: Vec<u32> = program.moving_set_ups().collect();
    let views_height = VIEW_HEIGHT * u32::try_from(set_ups.len()).unwrap_or(1);
    svg(views_height + plot_heights(program), |area| {
        let (views, axes) = area.split_vertically(views_height);
        let views = views.split_evenly((set_ups.len(), 1));
        views.iter().zip(&set_ups).try_for_each(|(area, set_up)| draw_path(program, *set_up, area))?;
        draw_axes(program, &axes)
    })
}

/// The path of a set-up in three views.
pub(crate) fn path(program: &ViewedProgram<'_>, set_up: u32) -> io::Result<String> {
    svg(VIEW_HEIGHT, |area| draw_path(program, set_up, area))
}

/// The axes over time.
pub(crate) fn axes(program: &ViewedProgram<'_>) -> io::Result<String> {
    svg(plot_heights(program), |area| draw_axes(program, area))
}

/// The part of a set-up on the table, from above and from the front.
pub(crate) fn part_on_table(program: &ViewedProgram<'_>, set_up: u32) -> io::Result<String> {
    svg(VIEW_HEIGHT, |area| {
        let areas = area.split_evenly((1, 2));
        areas.iter().zip(&VIEWS[..2]).try_for_each(|(area, view)| draw_table(program, set_up, area, *view))
    })
}

/// Positions to be drawn: runs of one kind, each from the end of the one before.
fn runs<'p>(
    points: &'p [ExecutedPoint],
    shown: &dyn Fn(&ExecutedPoint) -> bool,
) -> Vec<(PointKind, Vec<&'p ExecutedPoint>)> {
    let mut runs: Vec<(PointKind, Vec<&ExecutedPoint>)> = Vec::new();
    let mut last: Option<&ExecutedPoint> = None;
    for point in points.iter().filter(|point| shown(point)) {
        match (runs.last_mut(), last) {
            _ if point.kind == PointKind::Start => {}
            (Some((kind, run)), Some(last))
                if *kind == point.kind && run.last().is_some_and(|end| std::ptr::eq(*end, last)) =>
            {
                run.push(point);
            }
            (_, Some(last)) => runs.push((point.kind, vec![last, point])),
            (_, None) => {}
        }
        last = Some(point);
    }
    runs
}

/// Smallest and largest coordinates, with a margin, in the ratio of an area.
fn ranges(points: impl Iterator<Item = [f64; 2]>, (width, height): (u32, u32)) -> [Range<f64>; 2] {
    let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for point in points {
        for index in 0..2 {
            (low[index], high[index]) = (low[index].min(point[index]), high[index].max(point[index]));
        }
    }
    if low[0] > high[0] {
        (low, high) = ([0.0; 2], [0.0; 2]);
    }
    let extent = [0, 1].map(|index| (high[index] - low[index]).max(SMALLEST_MM) * (1.0 + 2.0 * MARGIN));
    let scale = (extent[0] / f64::from(width)).max(extent[1] / f64::from(height));
    [(0, width), (1, height)].map(|(index, pixels)| {
        let (middle, half) = (f64::midpoint(low[index], high[index]), 0.5 * scale * f64::from(pixels));
        middle - half..middle + half
    })
}

/// Leaves points out that are near to the lines without them; as many as needed. Of straight lines at the same place
/// one stays.
fn simplified(lines: &[Vec<(f64, f64)>], finest: f64) -> Vec<Vec<(f64, f64)>> {
    let mut distance = finest;
    let mut simpler = simplified_once(lines, distance);
    // Each round begins with the lines of the round before: all rounds together leave no point out that is farther from
    // the lines than twice the last distance.
    while simpler.iter().map(Vec::len).sum::<usize>() > MOST_POINTS {
        distance *= 2.0;
        simpler = simplified_once(&simpler, distance);
    }
    simpler
}

fn simplified_once(lines: &[Vec<(f64, f64)>], distance: f64) -> Vec<Vec<(f64, f64)>> {
    let place = |point: &(f64, f64)| [point.0, point.1].map(|along| (along / distance).round() as i64);
    let mut simpler: Vec<Vec<(f64, f64)>> =
        lines.iter().map(|line| straightened(&spaced(line, distance), distance)).collect();
    let mut taken = HashSet::new();
    simpler.retain(|line| line.len() > 2 || taken.insert((line.first().map(place), line.last().map(place))));
    simpler
}

/// The parts of a line that are inside a rectangle, by the parameters at which each piece enters and leaves it (Liang
/// and Barsky).
fn clipped(line: &[(f64, f64)], [across, up]: &[Range<f64>; 2]) -> Vec<Vec<(f64, f64)>> {
    let mut parts: Vec<Vec<(f64, f64)>> = Vec::new();
    let mut joined = false;
    for (from, to) in line.iter().zip(line.iter().skip(1)) {
        let (mut enters, mut leaves) = (0.0_f64, 1.0_f64);
        for (range, start, change) in [(across, from.0, to.0 - from.0), (up, from.1, to.1 - from.1)] {
            for (over, towards) in [(range.start - start, change), (start - range.end, -change)] {
                if towards > 0.0 {
                    enters = enters.max(over / towards);
                } else if towards < 0.0 {
                    leaves = leaves.min(over / towards);
                } else if over > 0.0 {
                    leaves = f64::NEG_INFINITY;
                }
            }
        }
        if enters > leaves {
            joined = false;
            continue;
        }
        let at = |share: f64| (from.0 + share * (to.0 - from.0), from.1 + share * (to.1 - from.1));
        match parts.last_mut().filter(|_| joined && enters <= 0.0) {
            Some(part) => part.push(at(leaves)),
            None => parts.push(vec![at(enters), at(leaves)]),
        }
        joined = leaves >= 1.0;
    }
    parts
}

/// Points that are at least this far from the one kept before; the last is kept.
fn spaced(points: &[ChartPoint], distance: f64) -> Vec<ChartPoint> {
    let mut kept: Vec<ChartPoint> = Vec::new();
    let near = |a: &ChartPoint, b: &ChartPoint| (a.0 - b.0).powi(2) + (a.1 - b.1).powi(2) < distance * distance;
    for (index, point) in points.iter().enumerate() {
        if index + 1 == points.len() || !kept.last().is_some_and(|last| near(last, point)) {
            kept.push(*point);
        }
    }
    kept
}

/// The line without the points that are nearer to it than a distance (Douglas and Peucker).
fn straightened(points: &[ChartPoint], distance: f64) -> Vec<ChartPoint> {
    let Some(last) = points.len().checked_sub(1) else { return Vec::new() };
    let mut kept = vec![false; points.len()];
    (kept[0], kept[last]) = (true, true);
    let mut open = vec![(0, last)];
    while let Some((from, to)) = open.pop() {
        let off = (from + 1..to).map(|index| (off_line(points[index], points[from], points[to]), index));
        let farthest = off.max_by(|(a, _), (b, _)| a.total_cmp(b));
        if let Some((_, farthest)) = farthest.filter(|(square, _)| *square > distance * distance) {
            kept[farthest] = true;
            open.extend([(from, farthest), (farthest, to)]);
        }
    }
    points.iter().zip(&kept).filter(|(_, kept)| **kept).map(|(point, _)| *point).collect()
}

/// Square of the distance of a point from a line between two points.
fn off_line(point: ChartPoint, from: ChartPoint, to: ChartPoint) -> f64 {
    let (x, y) = (to.0 - from.0, to.1 - from.1);
    let (a, b) = (point.0 - from.0, point.1 - from.1);
    let square = x * x + y * y;
    let share = if square > 0.0 { ((a * x + b * y) / square).clamp(0.0, 1.0) } else { 0.0 };
    (a - share * x).powi(2) + (b - share * y).powi(2)
}

fn draw_path(program: &ViewedProgram<'_>, set_up: u32, area: &Area<'_>) -> io::Result<()> {
    let executed = &program.executed;
    let runs = runs(&executed.points, &|point| executed.placements[point.placement].set_up == set_up);
    for (area, (title, names, directions)) in area.split_evenly((1, 3)).iter().zip(VIEWS) {
        let at = |point: &ExecutedPoint| directions.map(|index| point.pose.tip[index]);
        let cuts = runs.iter().filter(|(kind, _)| *kind == PointKind::Feed).flat_map(|(_, run)| run);
        let mut chart = view(area, title, names, cuts.map(|point| at(point)))?;
        for (kind, colour) in [(PointKind::Rapid, RAPID), (PointKind::Feed, FEED)] {
            draw_runs(&mut chart, &runs, kind, &|point| at(point).into(), colour)?;
        }
    }
    Ok(())
}

/// Draws the runs of one kind.
fn draw_runs(
    chart: &mut Chart<'_, '_>,
    runs: &[(PointKind, Vec<&ExecutedPoint>)],
    kind: PointKind,
    at: &dyn Fn(&ExecutedPoint) -> (f64, f64),
    colour: RGBColor,
) -> io::Result<()> {
    let frame = [chart.x_range(), chart.y_range()];
    let (pixels, _) = chart.plotting_area().dim_in_pixel();
    let pixel = (frame[0].end - frame[0].start) / f64::from(pixels.max(1));
    let of_kind = runs.iter().filter(|(of, _)| *of == kind);
    let lines: Vec<Vec<(f64, f64)>> =
        of_kind.flat_map(|(_, run)| clipped(&run.iter().map(|point| at(point)).collect::<Vec<_>>(), &frame)).collect();
    simplified(&lines, FINEST * pixel)
        .into_iter()
        .try_for_each(|line| chart.draw_series(LineSeries::new(line, colour.stroke_width(2))).map(drop).map_err(failed))
}

/// Begins a view whose range holds these points.
pub(super) fn view<'a, 'b>(
    area: &'b Area<'a>,
    title: &str,
    names: [&str; 2],
    points: impl Iterator<Item = [f64; 2]>,
) -> io::Result<Chart<'a, 'b>> {
    let (margin, labels) = (12, 70);
    let (width, height) = area.dim_in_pixel();
    let inside = (width.saturating_sub(2 * margin + labels), height.saturating_sub(2 * margin + labels + 2 * TITLE));
    let [across, up] = ranges(points, inside);
    let mut chart = ChartBuilder::on(area)
        .caption(title, ("sans-serif", TITLE))
        .margin(margin)
        .x_label_area_size(labels)
        .y_label_area_size(labels)
        .build_cartesian_2d(across, up)
        .map_err(failed)?;
    chart
        .configure_mesh()
        .x_desc(format!("{} mm", names[0]))
        .y_desc(format!("{} mm", names[1]))
        .label_style(("sans-serif", LABEL))
        .axis_desc_style(("sans-serif", LABEL))
        .light_line_style(TRANSPARENT)
        .x_labels(6)
        .y_labels(6)
        .draw()
        .map_err(failed)?;
    Ok(chart)
}

fn plot_heights(program: &ViewedProgram<'_>) -> u32 {
    let moved = program.machine.axes().iter().filter(|axis| !axis.held).count();
    PLOT_HEIGHT * u32::try_from(moved).unwrap_or(1)
}

fn draw_axes(program: &ViewedProgram<'_>, area: &Area<'_>) -> io::Result<()> {
    let axes = program.machine.axes();
    let moved: Vec<usize> = (0..axes.len()).filter(|index| !axes[*index].held).collect();
    let limits = program.policy.set_up.travel(axes).limits;
    let mut elapsed = 0.0;
    let times: Vec<f64> = program
        .executed
        .points
        .iter()
        .map(|point| {
            elapsed += point.seconds.unwrap_or(0.0);
            elapsed
        })
        .collect();
    for (area, index) in area.split_evenly((moved.len(), 1)).iter().zip(moved) {
        let axis = &axes[index];
        let (unit, scale) = if axis.kind == AxisKind::Rotary { ("°", 1_f64.to_degrees()) } else { ("mm", 1.0) };
        let coordinates = program.coordinates(index);
        let values = || coordinates.iter().map(|value| value * scale);
        let (low, high) =
            values().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
        let (low, high) = if low > high { (0.0, 0.0) } else { (low, high) };
        let room = (0.08 * (high - low)).max(0.5);
        let mut chart = ChartBuilder::on(area)
            .margin(10)
            .x_label_area_size(44)
            .y_label_area_size(110)
            .build_cartesian_2d(0.0..elapsed.max(1.0), low - room..high + room)
            .map_err(failed)?;
        chart
            .configure_mesh()
            .x_desc("s")
            .y_desc(format!("{} {unit}", axis.letter))
            .label_style(("sans-serif", LABEL))
            .axis_desc_style(("sans-serif", LABEL))
            .light_line_style(TRANSPARENT)
            .y_labels(5)
            .draw()
            .map_err(failed)?;
        let span = (elapsed.max(1.0), high - low + 2.0 * room);
        let (width, height) = chart.plotting_area().dim_in_pixel();
        // In pixels, in which both directions count alike.
        let pixels = (f64::from(width) / span.0, f64::from(height) / span.1);
        let placed: Vec<_> =
            times.iter().zip(values()).map(|(time, value)| (time * pixels.0, value * pixels.1)).collect();
        let lines: Vec<_> = program.executed.paths().map(|path| placed[path].to_vec()).collect();
        for line in simplified(&lines, FINEST) {
            let line = line.into_iter().map(|(time, value)| (time / pixels.0, value / pixels.1));
            chart.draw_series(LineSeries::new(line, FEED.stroke_width(2))).map_err(failed)?;
        }
        if let Some(limits) = limits[index].filter(|_| program.has_coordinates(index)) {
            for limit in [limits.lower, limits.upper].map(|limit| limit * scale) {
                if (low - room..=high + room).contains(&limit) {
                    let ends = [(0.0, limit), (elapsed.max(1.0), limit)];
                    chart.draw_series(LineSeries::new(ends, LIMIT.stroke_width(3))).map_err(failed)?;
                }
            }
        }
    }
    Ok(())
}

/// One view of the table: its reference point, the centre lines of its rotary axes, the part with its zero, and the
/// path.
fn draw_table(
    program: &ViewedProgram<'_>,
    set_up: u32,
    area: &Area<'_>,
    (title, names, directions): (&str, [&str; 2], [usize; 2]),
) -> io::Result<()> {
    let executed = &program.executed;
    let Some(clamping) = program.policy.set_up.clamping(set_up) else { return Ok(()) };
    let origin = Vector3::from(clamping.part_origin);
    let on_table = |point: &Point3<f64>| {
        let point = point + origin;
        directions.map(|index| point[index])
    };
    let is_shown = |point: &ExecutedPoint| executed.placements[point.placement].set_up == set_up;
    let runs = runs(&executed.points, &is_shown);
    let cuts: Vec<&ExecutedPoint> =
        runs.iter().filter(|(kind, _)| *kind == PointKind::Feed).flat_map(|(_, run)| run.iter().copied()).collect();
    let corners = program.part_corners(set_up, &cuts);
    let part: Vec<[f64; 2]> = corners.iter().flatten().map(&on_table).collect();
    let zero = on_table(&Point3::origin());
    let reference = [0.0, 0.0];
    let title = format!("set-up {set_up} {title}; 0 is the reference point of the table");
    let mut chart = view(area, &title, names, part.iter().copied().chain([zero, reference]))?;
    let size = (chart.x_range().end - chart.x_range().start) * ARROW;
    if let [low, high] = part[..] {
        let box_of = Rectangle::new([low.into(), high.into()], PART.mix(0.18).filled());
        chart.draw_series([box_of]).map_err(failed)?;
    }
    draw_runs(&mut chart, &runs, PointKind::Feed, &|point| on_table(&point.pose.tip).into(), FEED)?;
    let placement = executed.placements.iter().find(|placement| placement.set_up == set_up);
    let machine = placement.map_or(&*program.machine, |placement| &*placement.machine);
    for (index, axis) in machine.axes().iter().enumerate() {
        if axis.kind != AxisKind::Rotary || axis.side != Side::Workpiece {
            continue;
        }
        let joint = machine.joint(index);
        let point = on_table(&joint.point);
        let along = directions.map(|index| joint.direction[index]);
        let (x, y) = (point[0], point[1]);
        let (dx, dy) = (along[0] * 4.0 * size, along[1] * 4.0 * size);
        if dx.hypot(dy) < size {
            chart.draw_series([Circle::new((x, y), 14, CENTRE_LINE.stroke_width(3))]).map_err(failed)?;
        } else {
            let line = [(x - dx, y - dy), (x + dx, y + dy)];
            chart.draw_series(DashedLineSeries::new(line, 24, 10, CENTRE_LINE.stroke_width(3))).map_err(failed)?;
        }
        label(&mut chart, (x, y), &axis.letter.to_string(), CENTRE_LINE)?;
    }
    chart.draw_series([Cross::new((0.0, 0.0), 16, BLACK.stroke_width(3))]).map_err(failed)?;
    for (index, name) in names.into_iter().enumerate() {
        let mut end = zero;
        end[index] += size;
        chart.draw_series(LineSeries::new([zero.into(), end.into()], LIMIT.stroke_width(4))).map_err(failed)?;
        label(&mut chart, end.into(), name, LIMIT)?;
    }
    Ok(())
}

fn label(chart: &mut Chart<'_, '_>, at: ChartPoint, text: &str, colour: RGBColor) -> io::Result<()> {
    let style = ("sans-serif", TITLE).into_font().color(&colour);
    chart.draw_series([Text::new(text.to_owned(), at, style)]).map(drop).map_err(failed)
}

#[cfg(test)]
mod tests {
    use super::*;

    const FRAME: [Range<f64>; 2] = [0.0..10.0, 0.0..5.0];

    #[test]
    fn a_line_is_drawn_inside_the_frame_only_and_in_its_own_direction() {
        // Leaves at the right, and comes back along another line.
        let parts = clipped(&[(1.0, 1.0), (3.0, 1.0), (23.0, 11.0), (12.0, 4.0), (2.0, 4.0)], &FRAME);
        assert_eq!(parts, [vec![(1.0, 1.0), (3.0, 1.0), (10.0, 4.5)], vec![(10.0, 4.0), (2.0, 4.0)]]);
    }

    #[test]
    fn a_line_through_the_frame_is_drawn_though_its_ends_are_outside() {
        assert_eq!(clipped(&[(-5.0, 2.0), (15.0, 2.0)], &FRAME), [vec![(0.0, 2.0), (10.0, 2.0)]]);
        assert!(clipped(&[(-5.0, 6.0), (15.0, 6.0), (15.0, -6.0)], &FRAME).is_empty());
    }

    #[test]
    fn lines_have_a_number_of_points_together_that_can_be_drawn_and_cross_at_their_ends() {
        // A grid: the ends of its lines along Y are on those along X.
        let grid: Vec<Vec<(f64, f64)>> = (0..=10)
            .flat_map(|index| {
                let at = f64::from(index);
                [vec![(0.0, at), (10.0, at)], vec![(at, 0.0), (at, 10.0)]]
            })
            .collect();
        assert_eq!(simplified(&grid, 0.1).len(), 22);
        let holes: Vec<Vec<(f64, f64)>> =
            (0..40_000).map(|index| vec![(f64::from(index % 200), f64::from(index / 200)); 2]).collect();
        let drawn = simplified(&holes, 0.1);
        assert!(
            drawn.iter().map(Vec::len).sum::<usize>() <= MOST_POINTS && drawn.len() > MOST_POINTS / 16,
            "{}",
            drawn.len()
        );
        let twice = [holes[..9].to_vec(), holes[..9].to_vec()].concat();
        assert_eq!(simplified(&twice, 0.1).len(), 9);
    }
}
