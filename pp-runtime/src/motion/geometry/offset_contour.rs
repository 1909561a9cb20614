//! A contour that a control offsets: whether the exact offset keeps a part of every element.
//!
//! Elements are lines and arcs in the plane of the program, mm. The exact offset of a line is a line, that of an arc an
//! arc about the same centre. Around a convex corner the tool rolls, and nothing is lost. At a concave corner both
//! offsets end where they meet: each loses a piece, the *trim*. An element is refused where its offset has no length
//! left, or none at all: a control leaves it out, stops, or cuts into the part.
//!
//! A control may take a small corner as straight on: the element after it begins where the one before has ended, and an
//! arc that becomes longer by that stops the program.
//!
//! The lead-in is an element like others, since LinuxCNC begins the contour where both offsets meet. No control
//! lets the lead-out trim the contour, so it loses its own piece only. Elements that are not neighbours are not
//! compared.

use std::f64::consts::{PI, TAU};

use crate::kinematics::math;
use crate::tolerance::writer::{LEAST_OFFSET, STRAIGHT_ON};

/// Point or vector in the plane, mm.
pub(crate) type InPlane = [f64; 2];

/// A line or an arc of a contour.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ContourElement {
    pub(crate) start: InPlane,
    pub(crate) end: InPlane,
    pub(crate) arc: Option<ContourArc>,
}

/// Circle of an arc.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ContourArc {
    pub(crate) centre: InPlane,
    /// Angle, + counter-clockwise.
    pub(crate) sweep_rad: f64,
}

/// Corners that a control takes as straight on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StraightCorners {
    /// Largest angle of such a corner.
    pub largest_rad: f64,
    /// Angle by which an arc after one may become longer, in a program in millimetres and in one in inches.
    pub longer_rad: [f64; 2],
}

/// Why the tool does not fit a contour.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum OffsetMisfit {
    /// A lead-in or lead-out that is not longer than the offset.
    ShortLead { length_mm: f64 },
    /// An arc around the tool, no larger than the offset.
    InnerArc { radius_mm: f64 },
    /// The offsets of both elements at a corner do not meet.
    Apart,
    /// An element after a corner that the control takes as straight on cannot end where it should.
    StraightCorner { corner_rad: f64 },
    /// The offset of an element has no length left; `before`: of the one before the corner.
    Trimmed { before: bool, length_mm: f64, trim_mm: f64 },
}

/// The offset of a contour, element by element.
#[derive(Debug, Clone, Copy)]
pub(crate) struct OffsetContour {
    /// Distance to the left.
    left_mm: f64,
    /// Largest corner that the control takes as straight on, and angle by which an arc may become longer; 0 where it
    /// takes none.
    straight_rad: [f64; 2],
    last: Option<OffsetElement>,
}

/// The offset of one element.
#[derive(Debug, Clone, Copy)]
struct OffsetElement {
    element: ContourElement,
    /// Its radii at both ends, 0 for a line.
    radii_mm: [f64; 2],
    length_mm: f64,
    /// Piece that is lost at its start.
    trim_mm: f64,
    /// Corner before it that the control takes as straight on, and place on the offset where it begins.
    after_corner: Option<(f64, f64)>,
}

impl ContourElement {
    fn chord(&self) -> InPlane {
        minus(self.end, self.start)
    }

    /// Length of a line.
    fn length(&self) -> f64 {
        norm(self.chord())
    }

    /// Unit vector along the element at its start or end.
    fn direction(&self, at: InPlane) -> InPlane {
        match self.arc {
            None => unit(self.chord()),
            Some(arc) => unit(left_of(minus(at, arc.centre))).map(|component| component * arc.sweep_rad.signum()),
        }
    }
}

impl OffsetContour {
    /// A contour offset by a distance to the left of its direction, or to the right if it is negative, begins with its
    /// lead-in.
    pub(crate) fn begin(left_mm: f64, lead_in: &ContourElement) -> Result<Self, OffsetMisfit> {
        check_lead(lead_in, left_mm)?;
        let mut contour = Self { left_mm, straight_rad: [0.0; 2], last: None };
        contour.last = Some(contour.offset(lead_in)?);
        Ok(contour)
    }

    /// This contour on a control that takes corners as straight on: the largest one, and the angle by which an arc may
    /// become longer.
    pub(crate) fn with_straight_corners(mut self, straight_rad: [f64; 2]) -> Self {
        self.straight_rad = straight_rad;
        self
    }

    /// The next element.
    pub(crate) fn add(&mut self, element: &ContourElement) -> Result<(), OffsetMisfit> {
        if element.arc.is_none() && element.length() <= 0.0 {
            return Ok(());
        }
        let mut next = self.offset(element)?;
        if let Some(last) = self.last {
            let [before, after] = self.trims(&last, &next)?;
            keeps(&last, true, last.trim_mm + before)?;
            keeps(&next, false, after)?;
            next.trim_mm = after;
            let (turn, [largest, _]) = (self.turn(&last.element, element), self.straight_rad);
            if turn > largest || turn < -largest && element.arc.is_none() {
                self.reaches_end(&last, before)?;
            }
            if turn.abs() <= largest {
                let [from, to] = self.ends(&last, &next);
                next.after_corner = Some((turn, next.ahead(to, from)));
            }
        }
        self.last = Some(next);
        Ok(())
    }

    /// The lead-out.
    pub(crate) fn end(&self, lead_out: &ContourElement) -> Result<(), OffsetMisfit> {
        check_lead(lead_out, self.left_mm)?;
        let lead_out = self.offset(lead_out)?;
        let Some(last) = self.last else { return Ok(()) };
        self.reaches_end(&last, 0.0)?;
        keeps(&lead_out, false, self.trims(&last, &lead_out)?[1])
    }

    /// The offset of an element.
    fn offset(&self, element: &ContourElement) -> Result<OffsetElement, OffsetMisfit> {
        let element = *element;
        let Some(ContourArc { centre, sweep_rad }) = element.arc else {
            return Ok(OffsetElement {
                element,
                radii_mm: [0.0; 2],
                length_mm: element.length(),
                trim_mm: 0.0,
                after_corner: None,
            });
        };
        let radii = [element.start, element.end].map(|point| norm(minus(point, centre)));
        let radii_mm = radii.map(|radius| radius - self.left_mm * sweep_rad.signum());
        if math::smaller(radii_mm[0], radii_mm[1]) <= LEAST_OFFSET {
            return Err(OffsetMisfit::InnerArc { radius_mm: math::smaller(radii[0], radii[1]) });
        }
        let length_mm = 0.5 * (radii_mm[0] + radii_mm[1]) * sweep_rad.abs();
        Ok(OffsetElement { element, radii_mm, length_mm, trim_mm: 0.0, after_corner: None })
    }

    /// Refuses an element that does not end where it should, from where the control begins it.
    fn reaches_end(&self, last: &OffsetElement, trim_mm: f64) -> Result<(), OffsetMisfit> {
        let Some((corner_rad, begins_mm)) = last.after_corner else { return Ok(()) };
        let left_mm = last.length_mm - trim_mm - begins_mm;
        let reaches = match last.element.arc {
            None => left_mm >= 0.0,
            Some(arc) => {
                let radius = last.length_mm / arc.sweep_rad.abs();
                let drawn_mm = if left_mm > 0.0 { left_mm } else { left_mm + TAU * radius };
                drawn_mm <= last.length_mm + self.straight_rad[1] * radius
            }
        };
        if reaches { Ok(()) } else { Err(OffsetMisfit::StraightCorner { corner_rad }) }
    }

    /// The offsets of a corner: the end of the element before, and the start of the one after it.
    fn ends(&self, before: &OffsetElement, after: &OffsetElement) -> [InPlane; 2] {
        [(before, before.element.end), (after, after.element.start)].map(|(offset, at)| {
            let normal = left_of(offset.element.direction(at));
            [at[0] + normal[0] * self.left_mm, at[1] + normal[1] * self.left_mm]
        })
    }

    /// Change of direction at a corner, + towards the tool: a concave corner.
    fn turn(&self, before: &ContourElement, after: &ContourElement) -> f64 {
        let (from, to) = (before.direction(before.end), after.direction(after.start));
        math::atan2(cross(from, to), dot(from, to)) * self.left_mm.signum()
    }

    /// The trims at a corner of the offset before it and of the one after it.
    fn trims(&self, before: &OffsetElement, after: &OffsetElement) -> Result<[f64; 2], OffsetMisfit> {
        let turn = self.turn(&before.element, &after.element);
        // Back along the element before is around its end.
        if turn <= STRAIGHT_ON || turn >= PI - STRAIGHT_ON {
            return Ok([0.0; 2]);
        }
        let ends = self.ends(before, after);
        let along = |element: &ContourElement| element.direction(element.start);
        let circle = |arc: ContourArc, radius_mm| OffsetCircle { centre: arc.centre, radius_mm };
        let [[_, before_mm], [after_mm, _]] = [before.radii_mm, after.radii_mm];
        let points = match (before.element.arc, after.element.arc) {
            (None, None) => return Ok([self.left_mm.abs() * tangent_of_half(turn); 2]),
            (None, Some(arc)) => on_line_and_circle(ends[0], along(&before.element), circle(arc, after_mm)),
            (Some(arc), None) => on_line_and_circle(ends[1], along(&after.element), circle(arc, before_mm)),
            (Some(one), Some(other)) => on_circles(circle(one, before_mm), circle(other, after_mm)),
        };
        let trims = |point| [before.between(point, ends[0]), after.between(ends[1], point)];
        let cuts =
            points.into_iter().flatten().map(trims).filter(|trims| trims.iter().all(|trim| *trim >= -LEAST_OFFSET));
        let nearest = cuts.min_by(|one, other| (one[0] + one[1]).total_cmp(&(other[0] + other[1])));
        Ok(nearest.ok_or(OffsetMisfit::Apart)?.map(|trim| math::larger(trim, 0.0)))
    }
}

impl OffsetElement {
    /// Length of the offset from a point of it to another, + in its direction; at most half a revolution.
    fn ahead(&self, from: InPlane, to: InPlane) -> f64 {
        let Some(ContourArc { centre, sweep_rad }) = self.element.arc else {
            return dot(minus(to, from), self.element.direction(from));
        };
        let (from, to) = (minus(from, centre), minus(to, centre));
        math::atan2(cross(from, to), dot(from, to)) * self.length_mm / sweep_rad
    }

    /// Length of the offset from a point of it to another, in its direction: up to a revolution.
    fn between(&self, from: InPlane, to: InPlane) -> f64 {
        let ahead = self.ahead(from, to);
        match self.element.arc {
            // Back by rounding is not a revolution ahead.
            Some(arc) if ahead < -LEAST_OFFSET => ahead + TAU * self.length_mm / arc.sweep_rad.abs(),
            _ => ahead,
        }
    }
}

/// Refuses a lead-in or lead-out that is not longer than the offset.
fn check_lead(lead: &ContourElement, left_mm: f64) -> Result<(), OffsetMisfit> {
    let length_mm = lead.length();
    if length_mm > left_mm.abs() + LEAST_OFFSET { Ok(()) } else { Err(OffsetMisfit::ShortLead { length_mm }) }
}

/// Refuses an offset of which a trim leaves nothing.
fn keeps(offset: &OffsetElement, before: bool, trim_mm: f64) -> Result<(), OffsetMisfit> {
    let length_mm = offset.length_mm;
    match trim_mm < length_mm - LEAST_OFFSET {
        true => Ok(()),
        false => Err(OffsetMisfit::Trimmed { before, length_mm, trim_mm }),
    }
}

fn minus(one: InPlane, other: InPlane) -> InPlane {
    [one[0] - other[0], one[1] - other[1]]
}

fn dot(one: InPlane, other: InPlane) -> f64 {
    one[0] * other[0] + one[1] * other[1]
}

fn cross(one: InPlane, other: InPlane) -> f64 {
    one[0] * other[1] - one[1] * other[0]
}

fn norm(vector: InPlane) -> f64 {
    math::hypot(vector[0], vector[1])
}

fn unit(vector: InPlane) -> InPlane {
    let length = norm(vector);
    vector.map(|component| component / length)
}

fn left_of(vector: InPlane) -> InPlane {
    [-vector[1], vector[0]]
}

fn tangent_of_half(angle_rad: f64) -> f64 {
    let (sine, cosine) = math::sin_cos(0.5 * angle_rad);
    sine / cosine
}

/// Circle of the offset of an arc.
#[derive(Clone, Copy)]
struct OffsetCircle {
    centre: InPlane,
    radius_mm: f64,
}

/// Where a line, through a point along a direction, crosses a circle.
fn on_line_and_circle(point: InPlane, along: InPlane, circle: OffsetCircle) -> [Option<InPlane>; 2] {
    let OffsetCircle { centre, radius_mm: radius } = circle;
    let to_centre = minus(centre, point);
    let (foot, distance) = (dot(to_centre, along), cross(along, to_centre).abs());
    let squared = (radius - distance) * (radius + distance);
    let at = |length: f64| [point[0] + along[0] * length, point[1] + along[1] * length];
    [-1.0, 1.0].map(|sign| (squared >= 0.0).then(|| at(foot + sign * squared.sqrt())))
}

/// Where two circles cross.
fn on_circles(one: OffsetCircle, other: OffsetCircle) -> [Option<InPlane>; 2] {
    let (OffsetCircle { centre: one, radius_mm: one_mm }, OffsetCircle { centre: other, radius_mm: other_mm }) =
        (one, other);
    let step = minus(other, one);
    let distance = norm(step);
    let foot = 0.5 * (distance + (one_mm - other_mm) * (one_mm + other_mm) / distance);
    let squared = (one_mm - foot) * (one_mm + foot);
    let (along, across) = (unit(step), left_of(unit(step)));
    let at = |height: f64| [0, 1].map(|axis| one[axis] + along[axis] * foot + across[axis] * height);
    [-1.0, 1.0].map(|sign| (distance > 0.0 && squared >= 0.0).then(|| at(sign * squared.sqrt())))
}

#[cfg(test)]
mod tests;
