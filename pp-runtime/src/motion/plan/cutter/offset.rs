//! The contour of the program, offset as the control offsets it, in the words of the program.
//!
//! Where D holds the radius, the offset is the radius of the tool. Where it holds the wear, this may have either sign
//! up to `compensation.largest_wear`, so both are compared.

use std::collections::BTreeSet;

use crate::diag::code::plan;
use crate::kinematics::math;
use crate::motion::fault::Fault;
use crate::motion::geometry::{Circle, ContourArc, ContourElement, InPlane, OffsetContour, OffsetMisfit};
use crate::motion::place::AxisPosition;
use crate::motion::plan::cutter::CutterSite;
use crate::options::CutterPath;
use crate::program::Units;

/// Offsets of the contour in force.
#[derive(Debug, Default)]
pub(crate) struct Offsets {
    /// Distances to the left of the path in words, mm.
    left_mm: [Option<f64>; 2],
    contours: [Option<OffsetContour>; 2],
    /// Line of the CL data with the last element.
    last_line: u64,
    /// Tools whose radius D holds, and is unknown.
    unknown: BTreeSet<u32>,
}

impl Offsets {
    /// Tools whose contours could not be offset.
    pub(crate) fn unknown(&self) -> &BTreeSet<u32> {
        &self.unknown
    }

    /// Takes the distances of the offset where compensation begins; `left`: to the left of the path in words.
    pub(super) fn select(&mut self, left: bool, site: &CutterSite<'_>) {
        let options = site.policy.options;
        let tool = site.tooling.current();
        let sign = if left { 1.0 } else { -1.0 };
        let radius = tool.and_then(|tool| tool.radius_mm);
        self.left_mm = match options.compensation {
            Some(CutterPath::Centre) => [1.0, -1.0].map(|wear| Some(wear * sign * options.largest_wear_mm)),
            Some(CutterPath::Contour) => [radius.filter(|radius| *radius > 0.0).map(|radius| sign * radius), None],
            None => [None; 2],
        };
        if options.compensation == Some(CutterPath::Contour) && radius.is_none() {
            self.unknown.extend(tool.map(|tool| tool.number));
        }
    }

    /// The lead-in has been written.
    pub(super) fn begin(&mut self, from: &AxisPosition, site: &CutterSite<'_>) -> Result<(), Fault> {
        let Some(lead_in) = written(from, site) else { return Ok(()) };
        let in_inches = usize::from(site.placer.units() == Units::Inches);
        let straight = site.abilities.straight_corners;
        let straight_rad = straight.map_or([0.0; 2], |corners| [corners.largest_rad, corners.longer_rad[in_inches]]);
        for index in 0..2 {
            let Some(left_mm) = self.left_mm[index] else { continue };
            let begun = OffsetContour::begin(left_mm, &lead_in);
            let begun = begun.map_err(|misfit| self.fault(index, Lead::In, misfit, site))?;
            self.contours[index] = Some(begun.with_straight_corners(straight_rad));
        }
        self.last_line = site.line;
        Ok(())
    }

    /// A line has been written.
    pub(super) fn line(&mut self, from: &AxisPosition, site: &CutterSite<'_>) -> Result<(), Fault> {
        written(from, site).map_or(Ok(()), |line| self.add(&line, site))
    }

    /// An arc, or a piece of one, is being written.
    pub(super) fn arc_piece(&mut self, circle: &Circle, to: &AxisPosition, site: &CutterSite<'_>) -> Result<(), Fault> {
        let (unit_mm, words, [first, second, _]) =
            (site.placer.unit_mm(), site.placer.written(to), circle.plane.axes());
        let in_mm = |units: [i64; 2]| units.map(|units| units as f64 * unit_mm);
        let (start, end) = (in_mm(circle.start), in_mm([words[circle.chain[first]], words[circle.chain[second]]]));
        let sense = if circle.clockwise { -1.0 } else { 1.0 };
        let centre = match circle.radius {
            Some(radius) => centre_of(start, end, radius as f64 * unit_mm * sense),
            None => in_mm(circle.centre),
        };
        let arc = Some(ContourArc { centre, sweep_rad: sense * circle.sweep_rad });
        self.add(&ContourElement { start, end, arc }, site)
    }

    /// The lead-out has been written.
    pub(super) fn end(&mut self, from: &AxisPosition, site: &CutterSite<'_>) -> Result<(), Fault> {
        let Some(lead_out) = written(from, site) else { return Ok(()) };
        for index in 0..2 {
            if let Some(contour) = self.contours[index].take() {
                contour.end(&lead_out).map_err(|misfit| self.fault(index, Lead::Out, misfit, site))?;
            }
        }
        Ok(())
    }

    /// Takes the next element.
    fn add(&mut self, element: &ContourElement, site: &CutterSite<'_>) -> Result<(), Fault> {
        for index in 0..2 {
            if let Some(contour) = &mut self.contours[index] {
                let added = contour.add(element);
                added.map_err(|misfit| self.fault(index, Lead::In, misfit, site))?;
            }
        }
        self.last_line = site.line;
        Ok(())
    }

    /// Fault: the tool does not fit into the contour.
    #[cold]
    fn fault(&self, index: usize, lead: Lead, misfit: OffsetMisfit, site: &CutterSite<'_>) -> Fault {
        let Self { left_mm, last_line, .. } = self;
        let by_mm = left_mm[index].unwrap_or_default().abs();
        let units = site.placer.units();
        let shown = units.length(by_mm);
        let of_centre = site.policy.options.compensation == Some(CutterPath::Centre);
        let by = match (of_centre, index) {
            (false, _) => format!("the tool radius of {shown}"),
            (true, 0) => format!("a wear of {shown}"),
            (true, _) => format!("a wear of -{shown}"),
        };
        let fault = match misfit {
            OffsetMisfit::ShortLead { length_mm } => {
                let than = if length_mm < by_mm { "shorter than" } else { "no longer than" };
                let (verb, name) = if lead == Lead::In { ("begins", "lead-in") } else { ("ends", "lead-out") };
                let length = units.length(length_mm);
                let text = format!("compensation {verb} with a line {length} long, {than} {by}");
                return plan::CUTTER_COMPENSATION.fault(text).help(match (of_centre, lead) {
                    (true, _) => format!("make the {name} longer than `compensation.largest_wear`"),
                    (false, Lead::In) => "make the lead-in longer than the radius".to_owned(),
                    (false, Lead::Out) => "make the lead-out longer than the radius".to_owned(),
                });
            }
            OffsetMisfit::InnerArc { radius_mm } => {
                let radius = units.length(radius_mm);
                plan::CUTTER_COMPENSATION
                    .fault(format_args!("{by} does not fit into this arc with a radius of {radius}"))
            }
            OffsetMisfit::StraightCorner { corner_rad } => {
                let degrees = corner_rad.abs().to_degrees();
                let largest = site.abilities.straight_corners.map_or(0.0, |corners| corners.largest_rad.to_degrees());
                return plan::CUTTER_COMPENSATION.fault(format_args!(
                    "this control takes the corner of {degrees:.3} degrees before the motion of line {last_line} as straight on, and stops \
                     at the end of that motion with {by}"
                ))
                .help(format_args!("let CAM output this corner tangential, or larger than {largest:.1} degrees"));
            }
            OffsetMisfit::Apart => plan::CUTTER_COMPENSATION.fault(format_args!(
                "{by} does not fit into the corner before this motion: the offsets of both motions do not meet"
            )),
            OffsetMisfit::Trimmed { before, length_mm, trim_mm } => {
                let which = match before {
                    true => format!("the motion of line {last_line}"),
                    false => "this motion".to_owned(),
                };
                let (length, trim) = (units.length(length_mm), units.length(trim_mm));
                plan::CUTTER_COMPENSATION.fault(format_args!(
                    "offset by {by}, {which} would be {length} long, and its corners would take {trim} of it"
                ))
            }
        };
        fault.help(match of_centre {
            true => "set `compensation.largest_wear` to the largest that occurs, or change the path in CAM",
            false => {
                "use a tool with a smaller radius, or let CAM output the path of the tool centre: `compensation.path = \"centre\"`"
            }
        })
    }
}

/// Centre of an arc with a radius word, + for less than 180° counter-clockwise.
fn centre_of(start: InPlane, end: InPlane, radius: f64) -> InPlane {
    let chord = [end[0] - start[0], end[1] - start[1]];
    let length = math::hypot(chord[0], chord[1]);
    let height = math::larger(radius * radius - 0.25 * length * length, 0.0).sqrt() * radius.signum() / length;
    [0.5 * (start[0] + end[0]) - chord[1] * height, 0.5 * (start[1] + end[1]) + chord[0] * height]
}

/// The line in words from a position to where the tool is.
fn written(from: &AxisPosition, site: &CutterSite<'_>) -> Option<ContourElement> {
    let ([first, second, _], _) = site.placer.orthogonal_map(from)?;
    let in_mm = |place: &AxisPosition| {
        let words = site.placer.written(place);
        [words[first], words[second]].map(|units| units as f64 * site.placer.unit_mm())
    };
    Some(ContourElement { start: in_mm(from), end: in_mm(site.here), arc: None })
}

/// Which of the two lines at the ends of a contour.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Lead {
    In,
    Out,
}
