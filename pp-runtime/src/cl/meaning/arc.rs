//! Arcs: a CIRCLE with the GOTO that ends it, and a TLON with the AUTOPS and INDIRV before it.
//!
//! CAM systems disagree on the sign of the axis of a CIRCLE. The count of its numbers decides: 6 and 7 mean
//! counter-clockwise about the axis, 11 mean clockwise. After 7 a word may state the sense (CAMWorks). With 4
//! (*Supported CL Data Commands* of PTC: i, j, k may be absent) the axis is that of the tool, and the points between
//! the ends or `--circle-sense` decide.

use std::f64::consts::TAU;

use super::options::Sense;
use super::permitted::Permitted;
use super::transform::Transforms;
use crate::cl::record::{CircleForm, CircleRecord, TangentArc};
use crate::cl::text::{ClFault, Span};
use crate::cl::vector::{points_up, within_a_kilometre};
use crate::diag::code::cl;
use crate::kinematics::{Pose, math};
use crate::nalgebra::{Point3, UnitVector3, Vector3};
use crate::program::{Arc, Feed, Rotation, Units};

/// Sine of the largest permitted angle between INDIRV and the tangent of its circle.
const TANGENT: f64 = 1e-2;

/// Largest permitted distance of the end of an arc from the radius or the plane of its circle. Real files stay below a
/// tenth of it.
pub(crate) const ARC_TOLERANCE_MM: f64 = 0.005;

/// Distance below which two points are the same.
const SAME_POINT_MM: f64 = 1e-6;

/// Chord length below which the ends of an arc may differ by rounding alone: the arc may be empty or a full circle.
const SHORTEST_CHORD_MM: f64 = 5e-4;

/// Product of the radii at both ends less the dot product of the two: above it no chord is short. The square of the
/// chord is at least twice as much; around the centre, times the quotient of the radii, which differ by
/// [`ARC_TOLERANCE_MM`] each and are not below it, at least two thirds.
const CLEAR_MM2: f64 = 1e-6;

/// Largest part of the product that is rounding of this difference.
const ROUNDED: f64 = 1e-12;

/// A circle in the workpiece frame whose end is not read yet.
#[derive(Debug, Clone, Copy)]
pub(crate) struct WaitingCircle {
    centre: Point3<f64>,
    /// Axis as in the file; `sense` is about this axis.
    axis: UnitVector3<f64>,
    /// `None`: the record does not state it.
    sense: Option<Sense>,
    /// A word of the record states it.
    is_sense_stated: bool,
    radius_mm: Option<f64>,
    /// The start of a helix may be at the level of the centre, not only its end.
    may_begin_at_centre: bool,
    times: u32,
    /// Angle that the arc must have (MOVARC).
    angle_rad: Option<f64>,
    /// Height that the helix must have, up or down (ARCSLP).
    height_mm: Option<f64>,
    /// Unit of the file.
    units: Units,
    line: u64,
}

/// Coordinates of the file: their unit, and how they become those of the workpiece.
#[derive(Debug, Clone, Copy)]
pub(crate) struct FileCoordinates<'t> {
    /// mm in one unit of the file.
    pub(crate) unit_mm: f64,
    pub(crate) transforms: &'t Transforms,
}

impl FileCoordinates<'_> {
    /// A point of the file in the workpiece frame, mm.
    fn point(&self, point: [f64; 3]) -> Point3<f64> {
        self.transforms.point(Point3::from(point.map(|value| value * self.unit_mm)))
    }
}

impl WaitingCircle {
    /// Circle of a CIRCLE or MOVARC in line `line`. `sense`: overrides the sense
    /// of the form; `camplete`: with 11 numbers the eighth is the angle (*CAMplete APT* of Autodesk); `tool_axis` in
    /// the workpiece frame: axis of a circle that states none.
    pub(crate) fn new(
        circle: &CircleRecord,
        file: FileCoordinates<'_>,
        tool_axis: UnitVector3<f64>,
        sense: Option<Sense>,
        camplete: bool,
        line: u64,
    ) -> Result<WaitingCircle, ClFault> {
        let FileCoordinates { unit_mm, transforms } = file;
        let axis = Vector3::from(circle.axis);
        let length = axis.norm();
        let has_axis = circle.form != CircleForm::Four;
        if has_axis && (length - 1.0).abs() > 1e-3 {
            return Err(cl::ARC.cl_fault(
                "circle",
                circle.at,
                format!("the axis of this circle has length {length:.6}, not 1"),
                "i, j, k must be a unit vector",
            ));
        }
        let of_form = match circle.form {
            CircleForm::Four => None,
            CircleForm::Six | CircleForm::Seven => Some(Sense::CounterClockwise),
            CircleForm::Eleven => Some(Sense::Clockwise),
        };
        // The angle of MOVARC counts counter-clockwise about its axis, whatever the sense of a CIRCLE.
        let sense = sense.filter(|_| circle.angle_deg.is_none());
        let stated = stated_sense(circle, sense)?;
        let centre = file.point(circle.centre);
        Ok(WaitingCircle {
            centre: within_a_kilometre(centre, circle.at)?,
            axis: if has_axis { transforms.direction(UnitVector3::new_normalize(axis)) } else { tool_axis },
            sense: stated.or(sense).or(of_form),
            is_sense_stated: stated.is_some(),
            radius_mm: circle.radius.map(|radius| radius * unit_mm),
            may_begin_at_centre: camplete || matches!(circle.form, CircleForm::Four | CircleForm::Seven),
            times: circle.times,
            angle_rad: circle.angle_deg.or(circle.eighth.filter(|_| camplete)).map(f64::to_radians),
            height_mm: None,
            units: Units::of_length(unit_mm),
            line,
        })
    }

    /// The circle with the sense in which its arc passes the points, for one that states none. Of the two arcs only one
    /// passes a point between the ends.
    pub(crate) fn through(
        mut self,
        points: impl Iterator<Item = Point3<f64>> + Clone,
        start: &Pose,
        end: &Pose,
    ) -> Self {
        let passes = |sense: &Sense| {
            let circle = WaitingCircle { sense: Some(*sense), ..self };
            arc_of(&circle, start, end, None, Span::WHOLE).is_ok_and(|arc| passes_in_order(&arc, points.clone()))
        };
        let mut senses = [Sense::CounterClockwise, Sense::Clockwise].into_iter().filter(passes);
        self.sense = senses.next().filter(|_| senses.next().is_none());
        self
    }

    /// Whether a word of the record states the sense.
    pub(crate) fn is_sense_stated(&self) -> bool {
        self.is_sense_stated
    }

    /// Whether the sense of the arc is known.
    pub(crate) fn has_sense(&self) -> bool {
        self.sense.is_some()
    }

    pub(crate) fn axis(&self) -> &UnitVector3<f64> {
        &self.axis
    }

    /// Line of the CIRCLE or MOVARC.
    pub(crate) fn line(&self) -> u64 {
        self.line
    }
}

/// Sense that a word of a CIRCLE states. `option`: sense given by an option, which may not be another.
fn stated_sense(circle: &CircleRecord, option: Option<Sense>) -> Result<Option<Sense>, ClFault> {
    let sense = match circle.sense {
        None => return Ok(None),
        Some(Rotation::Clockwise) => Sense::Clockwise,
        Some(Rotation::CounterClockwise) => Sense::CounterClockwise,
    };
    if option.is_some_and(|option| option != sense) {
        return Err(cl::ARC.cl_fault(
            "circle",
            circle.at,
            "this CIRCLE states its sense by a word, and `circle_sense` is the other one",
            "a setting never replaces what the file states: delete `--circle-sense`, `[cl] circle_sense`",
        ));
    }
    // About an axis that points down, it may be meant as seen from the tool.
    if !points_up(circle.axis) {
        return Err(cl::ARC.cl_fault(
            "circle",
            circle.at,
            "a word states the sense of this CIRCLE, and its axis points against X, Y or Z: whether it is seen along or against \
             the axis is not known",
            "write the opposite axis with the sense that is seen against it: i, j, k = 0, 0, 1 and CCLW is counter-clockwise from above",
        ));
    }
    Ok(Some(sense))
}

/// Returns the circle and the end point of a TLON. The arc begins at `start` in `direction`; its plane contains the
/// radius to the start and the direction.
pub(crate) fn tangent_circle(
    record: &TangentArc,
    start: &Pose,
    direction: Vector3<f64>,
    file: FileCoordinates<'_>,
    line: u64,
) -> Result<(WaitingCircle, Point3<f64>), ClFault> {
    let at = record.at;
    let fault = |text: String| tlon_fault(at, text);
    let point = |p: [f64; 3]| within_a_kilometre(file.point(p), at);
    let (centre, radius) = (point(record.centre)?, record.radius * file.unit_mm);
    let (from, end) = (point(record.line[0])?, point(record.line[1])?);
    let off = ((end - centre).norm() - radius).abs();
    if off > ARC_TOLERANCE_MM {
        let off = Units::of_length(file.unit_mm).deviation(off);
        return Err(fault(format!("the end of the line is {off} off the circle, so the end of the arc is unknown")));
    }
    if record.second && (end - from).dot(&(centre - from)) > 0.0 && (end - centre).dot(&(end - from)) < 0.0 {
        return Err(fault("the end of the line is the first intersection with the circle, not the second".into()));
    }
    let arm = start.tip - centre;
    let across = direction.dot(&arm).abs() / radius.max(f64::MIN_POSITIVE);
    if across > TANGENT {
        return Err(fault("INDIRV is not tangent to the circle at the start of the arc".into()));
    }
    let Some(axis) = UnitVector3::try_new(arm.cross(&direction), 1e-9) else {
        return Err(fault("the start of this arc and INDIRV define no plane".into()));
    };
    let circle = WaitingCircle {
        centre,
        axis,
        sense: Some(Sense::CounterClockwise),
        is_sense_stated: false,
        radius_mm: Some(radius),
        may_begin_at_centre: false,
        times: 1,
        angle_rad: None,
        height_mm: None,
        units: Units::of_length(file.unit_mm),
        line,
    };
    Ok((circle, end))
}

/// Fault of a TLON.
pub(crate) fn tlon_fault(at: Span, text: String) -> ClFault {
    cl::ARC.cl_fault("TLON", at, text, "check this arc in the CAM system, or have it output lines instead of arcs")
}

#[cold]
fn tangent_without_arc() -> ClFault {
    cl::ARC.cl_fault(
        "TLON",
        Span::WHOLE,
        "expected TLON after AUTOPS or INDIRV, found another motion",
        "write the TLON that belongs to it; without an arc delete AUTOPS and INDIRV",
    )
}

#[cold]
fn slope_without_arc() -> ClFault {
    cl::ARC.cl_fault(
        "ARCSLP",
        Span::WHOLE,
        "expected MOVARC after ARCSLP, found another motion",
        "write ARCSLP directly before the MOVARC of its helix; without a helix delete it",
    )
}

/// The arc whose end is not read yet.
#[derive(Debug, Default)]
pub(crate) struct OpenArc {
    circle: Option<WaitingCircle>,
    /// Direction of INDIRV, in the workpiece frame.
    direction: Option<Vector3<f64>>,
    /// AUTOPS or INDIRV was read: a TLON must follow.
    tangent_begun: bool,
    /// Height of ARCSLP, mm, for the circle that must follow.
    slope: Option<f64>,
}

impl OpenArc {
    pub(crate) fn is_open(&self) -> bool {
        self.circle.is_some() || self.tangent_begun || self.slope.is_some()
    }

    /// Checks that a record may come while an arc is open; a record that may not discards the arc.
    #[inline]
    pub(crate) fn admit(&mut self, permitted: Permitted) -> Result<(), ClFault> {
        if permitted.begins_motion && std::mem::take(&mut self.tangent_begun) {
            self.direction = None;
            return Err(tangent_without_arc());
        }
        if permitted.in_arc || self.circle.is_none() { Ok(()) } else { self.refuse_open_circle() }
    }

    #[cold]
    fn refuse_open_circle(&mut self) -> Result<(), ClFault> {
        match self.circle.take() {
            Some(circle) => Err(cl::ARC.cl_fault(
                "circle",
                Span::WHOLE,
                format!("the circle of line {} has no end: this record comes before its GOTO", circle.line),
                "write the GOTO that ends the arc directly after CIRCLE",
            )),
            None => Ok(()),
        }
    }

    /// CIRCLE: its GOTO must follow.
    pub(crate) fn open_circle(&mut self, circle: WaitingCircle) {
        self.circle = Some(WaitingCircle { height_mm: self.slope.take().or(circle.height_mm), ..circle });
    }

    /// ARCSLP.
    pub(crate) fn set_slope(&mut self, height_mm: f64) {
        self.slope = Some(height_mm);
    }

    /// Refuses a motion other than an arc after ARCSLP.
    #[inline]
    pub(crate) fn refuse_slope(&mut self) -> Result<(), ClFault> {
        if self.slope.take().is_none() { Ok(()) } else { Err(slope_without_arc()) }
    }

    /// The circle whose end is not read yet.
    pub(crate) fn circle(&self) -> Option<WaitingCircle> {
        self.circle
    }

    /// Its end has been read.
    pub(crate) fn close_circle(&mut self) {
        self.circle = None;
    }

    /// AUTOPS.
    pub(crate) fn begin_tangent(&mut self) {
        self.tangent_begun = true;
    }

    /// INDIRV, in the workpiece frame.
    pub(crate) fn set_direction(&mut self, direction: Vector3<f64>, at: Span) -> Result<(), ClFault> {
        if direction.norm() < 1e-9 {
            return Err(cl::ARC.cl_fault(
                "INDIRV",
                at,
                "INDIRV is 0, 0, 0 and has no direction",
                "INDIRV is the direction of the path at the start of the arc",
            ));
        }
        self.direction = Some(direction.normalize());
        self.tangent_begun = true;
        Ok(())
    }

    /// TLON: takes the direction of its INDIRV.
    pub(crate) fn end_tangent(&mut self, at: Span) -> Result<Vector3<f64>, ClFault> {
        self.tangent_begun = false;
        let direction = self.direction.take();
        direction.ok_or_else(|| {
            tlon_fault(at, "no INDIRV comes before this TLON: the direction of the arc is unknown".into())
        })
    }

    /// End of the file: refuses a circle without an end.
    pub(crate) fn finish(&mut self) -> Result<(), ClFault> {
        match self.circle.take() {
            Some(circle) => Err(cl::ARC.cl_fault(
                "circle",
                Span::WHOLE,
                format!("the file ends before the GOTO that ends the arc of line {}", circle.line),
                "check whether the CAM system wrote the file completely",
            )),
            None => Ok(()),
        }
    }
}

/// Arc on a circle from `start` to `end`.
///
/// Refused if the tool axis changes, an end lies off the circle, the ends are too near to tell an empty arc from a full
/// circle, or the angle is not that of MOVARC.
#[inline(always)]
pub(crate) fn arc_of(
    circle: &WaitingCircle,
    start: &Pose,
    end: &Pose,
    feed: Option<Feed>,
    at: Span,
) -> Result<Arc, ClFault> {
    let (normal, angle_rad) = normal_and_angle(circle, start, end, at)?;
    Ok(Arc { start: *start, end: *end, centre: circle.centre, normal, angle_rad, feed })
}

/// Normal of that arc, and its angle, rad.
fn normal_and_angle(
    circle: &WaitingCircle,
    start: &Pose,
    end: &Pose,
    at: Span,
) -> Result<(UnitVector3<f64>, f64), Box<ClFault>> {
    let fault = |text: String| {
        let text = format!("{text} (circle of line {})", circle.line);
        let help = "check the arc in the CAM system, or have it output lines instead of arcs";
        Box::new(cl::ARC.cl_fault("circle", at, text, help))
    };
    let shown = |mm: f64| circle.units.deviation(mm);
    if start.axis != end.axis && (start.axis.into_inner() - end.axis.into_inner()).norm() > 1e-6 {
        return Err(fault("the tool axis changes on an arc".into()));
    }
    let normal = match circle.sense {
        Some(Sense::CounterClockwise) => circle.axis,
        Some(Sense::Clockwise) => -circle.axis,
        None => {
            let text =
                format!("CIRCLE with 4 numbers does not state the sense of its arc (circle of line {})", circle.line);
            let help = "state it: `--circle-sense ccw` or `cw`, about the tool axis; a GOTO with points between the ends states \
                        it, too";
            return Err(Box::new(cl::ARC.cl_fault("circle", at, text, help)));
        }
    };
    let n = normal.into_inner();
    let flat = |point: Point3<f64>| {
        let from_centre = point - circle.centre;
        from_centre - n * from_centre.dot(&n)
    };
    let (u, v) = (flat(start.tip), flat(end.tip));
    let (first, last) = (u.norm(), v.norm());
    let above_centre = |point: Point3<f64>| (point - circle.centre).dot(&n).abs();
    // The centre of a helix is at the level of its end (NX), or of its start (Creo, *CL Output for Circular
    // Interpolation*, and MOVARC of the posts of Autodesk).
    let off_end = above_centre(end.tip);
    let off_plane = if circle.may_begin_at_centre { off_end.min(above_centre(start.tip)) } else { off_end };
    if off_plane > ARC_TOLERANCE_MM {
        return Err(fault(format!("the end of an arc is {} off the plane of its circle", shown(off_plane))));
    }
    let height = (end.tip - start.tip).dot(&n).abs();
    if let Some(stated) = circle.height_mm.filter(|stated| (stated - height).abs() > ARC_TOLERANCE_MM) {
        return Err(fault(format!(
            "an arc rises or falls by {}, and its ARCSLP states {}",
            shown(height),
            shown(stated)
        )));
    }
    let radius = circle.radius_mm.unwrap_or(first);
    let off_radius = |found: f64| (found - radius).abs();
    let off_circle = |which: &str, off: f64| {
        fault(format!("the {which} of an arc is {} off its radius of {}", shown(off), shown(radius)))
    };
    if off_radius(first) > ARC_TOLERANCE_MM {
        return Err(off_circle("start", off_radius(first)));
    }
    if off_radius(last) > ARC_TOLERANCE_MM {
        return Err(off_circle("end", off_radius(last)));
    }
    if first <= ARC_TOLERANCE_MM || last <= ARC_TOLERANCE_MM {
        return Err(fault(format!("an arc has no radius: it begins {} from its centre", shown(first))));
    }
    let part = angle_within_revolution(u, v, n, end.tip - start.tip, circle.angle_rad.is_some()).map_err(|chord| {
        fault(format!("the ends of an arc are {} apart: the arc may be empty or a full circle", shown(chord)))
    })?;
    let Some(stated) = circle.angle_rad else {
        return Ok((normal, part + f64::from(circle.times - 1) * TAU));
    };
    let turns = ((stated - part) / TAU).round().max(0.0);
    let angle = part + turns * TAU;
    if angle <= 0.0 {
        return Err(fault(format!("the ends of an arc are {} apart: the arc is empty", shown((v - u).norm()))));
    }
    if (angle - stated).abs() * radius > ARC_TOLERANCE_MM {
        return Err(fault(format!(
            "the end of an arc is at {:.4} degrees, its record states {:.4} degrees",
            angle.to_degrees(),
            stated.to_degrees()
        )));
    }
    Ok((normal, angle))
}

/// Angle about `n` from the radius vector `u` to the radius vector `v`, whose ends are `apart`, rad, 0 to 2π; the
/// distance of ends that are too near to tell.
#[inline(always)]
fn angle_within_revolution(
    u: Vector3<f64>,
    v: Vector3<f64>,
    n: Vector3<f64>,
    apart: Vector3<f64>,
    angle_is_stated: bool,
) -> Result<f64, f64> {
    let (product, along) = (u.norm() * v.norm(), u.dot(&v));
    // Nearly every chord is far from short.
    if product - along <= CLEAR_MM2 + ROUNDED * product {
        // Distance of the ends, and the same around the centre: their radii differ within tolerance.
        let (chord, around) = ((v - u).norm(), (v * (u.norm() / v.norm()) - u).norm());
        // A helix that ends above its start has made a full revolution.
        let rise_mm = apart.dot(&n).abs();
        if chord <= SAME_POINT_MM || (around < SHORTEST_CHORD_MM && rise_mm > ARC_TOLERANCE_MM) {
            return Ok(TAU);
        }
        if around < SHORTEST_CHORD_MM && !angle_is_stated {
            return Err(chord);
        }
    }
    Ok(math::from_zero(math::atan2(n.dot(&u.cross(&v)), along)))
}

/// Whether an arc passes the points in their order. A point at either end states no order.
fn passes_in_order(arc: &Arc, mut points: impl Iterator<Item = Point3<f64>>) -> bool {
    let rounding = ARC_TOLERANCE_MM / (arc.start.tip - arc.centre).norm().max(ARC_TOLERANCE_MM);
    let mut last = 0.0;
    points.all(|point| {
        let Some(angle) = angle_on(arc, point) else { return false };
        let at_end = angle <= rounding || angle >= arc.angle_rad.min(TAU) - rounding;
        let in_order = at_end || angle >= last;
        last = if at_end { last } else { angle };
        in_order
    })
}

/// Whether a point lies on the arc, seen along its normal; the coordinate along the normal is not compared.
pub(crate) fn is_on(arc: &Arc, point: Point3<f64>) -> bool {
    angle_on(arc, point).is_some()
}

/// Angle from the start to a point that lies on the arc, seen along its normal; the coordinate along the normal is not
/// compared.
fn angle_on(arc: &Arc, point: Point3<f64>) -> Option<f64> {
    let n = arc.normal.into_inner();
    let flat = |point: Point3<f64>| {
        let from_centre = point - arc.centre;
        from_centre - n * from_centre.dot(&n)
    };
    let (u, p) = (flat(arc.start.tip), flat(point));
    let radius = u.norm();
    let angle = math::from_zero(math::atan2(n.dot(&u.cross(&p)), u.dot(&p)));
    // By rounding, points at the ends may lie a little before the start or after the end.
    let rounding = ARC_TOLERANCE_MM / radius;
    let on_circle = (p.norm() - radius).abs() <= ARC_TOLERANCE_MM;
    (on_circle && (angle <= arc.angle_rad + rounding || angle >= TAU - rounding)).then_some(angle)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// [`angle_within_revolution`] without the test of chords that are clearly not short.
    fn angle_by_chord(u: Vector3<f64>, v: Vector3<f64>, n: Vector3<f64>, rise_mm: f64, stated: bool) -> Option<f64> {
        let (chord, around) = ((v - u).norm(), (v * (u.norm() / v.norm()) - u).norm());
        let short = around < SHORTEST_CHORD_MM;
        if chord <= SAME_POINT_MM || (short && rise_mm > ARC_TOLERANCE_MM) {
            return Some(TAU);
        }
        (!short || stated).then(|| math::from_zero(math::atan2(n.dot(&u.cross(&v)), u.dot(&v))))
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4000))]
        /// Ends on radii as different as the tolerance permits, and as near as a chord is short.
        #[test]
        fn a_chord_is_short_where_it_is_so_by_its_length(
            radius in prop_oneof![0.0051_f64..0.05, 0.05_f64..5.0, 1e3_f64..1e6],
            wider in -2.0 * ARC_TOLERANCE_MM..2.0 * ARC_TOLERANCE_MM,
            chord in prop_oneof![Just(0.0), 0.0_f64..2.0 * SAME_POINT_MM, 0.0_f64..4.0 * SHORTEST_CHORD_MM, 0.0_f64..1.0],
            turned in prop_oneof![Just(0.0), 0.0_f64..TAU],
            (rise_mm, stated) in (prop::sample::select(vec![0.0, 1.0]), any::<bool>()),
        ) {
            let last = (radius + wider).max(1.01 * ARC_TOLERANCE_MM);
            let angle = turned + chord / radius;
            let (u, v) = (Vector3::x() * radius, Vector3::new(last * angle.cos(), last * angle.sin(), 0.0));
            let found = angle_within_revolution(u, v, Vector3::z(), v - u + Vector3::z() * rise_mm, stated).ok();
            prop_assert_eq!(found, angle_by_chord(u, v, Vector3::z(), rise_mm, stated));
        }
    }
}
