//! Whether a tool fits along a contour in the plane, on one side of it.
//!
//! Think of the tool growing from nothing. At a concave corner its centre begins at the corner and moves off both
//! sides, always equally far from both; what it leaves behind of either side it never touches. Between two lines, a
//! line and a circle, or two circles, the centre is the corner of a triangle whose sides are known, so each side loses
//! the difference between two angles of such triangles. A side fits if it loses less than it has. A convex corner loses
//! nothing, and an arc around the tool must be larger than the tool.

use std::f64::consts::PI;

use nalgebra::Vector2;

use crate::check::tolerances::{SPENT_SIDE, STRAIGHT_ON, TOUCHING};

/// A side of a contour.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ContourSide {
    pub(crate) from: Vector2<f64>,
    pub(crate) to: Vector2<f64>,
    /// Centre and angle of an arc, + counter-clockwise, rad.
    pub(crate) round: Option<(Vector2<f64>, f64)>,
}

/// Why a tool does not fit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum NoFit {
    /// Into an arc of this radius, mm.
    Arc(f64),
    /// Into the corner before a side.
    Corner,
    /// A side that loses more than it has, mm; `earlier`: the one before the corner.
    Side { earlier: bool, has: f64, loses: f64 },
    /// A side after a corner of this angle, rad, that the control takes as straight on: the side does not end where it
    /// should.
    Straight(f64),
    /// A line onto or off the contour of this length, mm.
    Line(f64),
}

/// The last side of a contour, and what it has lost at its start.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct FittedSide {
    side: ContourSide,
    lost: f64,
    /// Corner before it that the control takes as straight on, and length of the path by which the control begins it
    /// late.
    straight: Option<(f64, f64)>,
}

/// The tool, and the corners that its control takes as straight on: the largest one, and the angle by which an arc
/// after one may become longer, rad; 0 where it takes none.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct FitTool {
    pub(crate) radius: f64,
    pub(crate) left: bool,
    pub(crate) straight: [f64; 2],
}

/// Radius of a side as the tool goes round it: + with the tool inside, - outside; infinite for a line.
type RoundTool = f64;

impl ContourSide {
    /// Unit vectors along it at its start and its end.
    fn along(&self) -> [Vector2<f64>; 2] {
        match self.round {
            None => [(self.to - self.from).normalize(); 2],
            Some((centre, angle)) => [self.from, self.to].map(|point| {
                let out = (point - centre).normalize();
                Vector2::new(-out.y, out.x) * angle.signum()
            }),
        }
    }

    /// Radii at its start and its end for a tool on the `left` or the right.
    fn radii(&self, left: bool) -> [RoundTool; 2] {
        match self.round {
            None => [f64::INFINITY; 2],
            Some((centre, angle)) => {
                let inside = if (angle > 0.0) == left { 1.0 } else { -1.0 };
                [self.from, self.to].map(|point| inside * (point - centre).norm())
            }
        }
    }

    /// Length of the path of the centre of a tool along all of it.
    fn tool_length(&self, radius: f64, left: bool) -> f64 {
        match self.round {
            None => (self.to - self.from).norm(),
            Some((_, angle)) => {
                let [from, to] = self.radii(left);
                angle.abs() * (0.5 * (from + to) - radius).abs()
            }
        }
    }
}

impl FittedSide {
    /// The line onto the contour of a tool of this radius.
    pub(crate) fn first(line: ContourSide, radius: f64) -> Result<Self, NoFit> {
        let has = (line.to - line.from).norm();
        (has > radius + SPENT_SIDE).then_some(Self { side: line, lost: 0.0, straight: None }).ok_or(NoFit::Line(has))
    }

    /// The side after this one.
    pub(crate) fn next(&self, side: ContourSide, tool: FitTool) -> Result<Self, NoFit> {
        let FitTool { radius, left, straight: [largest, _] } = tool;
        let [start, end] = side.radii(left);
        if start > 0.0 && start.min(end) <= radius + SPENT_SIDE {
            return Err(NoFit::Arc(start.min(end)));
        }
        let [earlier, lost] = self.losses(&side, radius, left).ok_or(NoFit::Corner)?;
        let sides = [(true, &self.side, self.lost + earlier), (false, &side, lost)];
        for (earlier, side, loses) in sides {
            let has = side.tool_length(radius, left);
            if loses >= has - SPENT_SIDE {
                return Err(NoFit::Side { earlier, has, loses });
            }
        }
        let turn = self.turn(&side, left);
        if turn > largest || turn < -largest && side.round.is_none() {
            self.ends(earlier, tool)?;
        }
        let late = || match side.round {
            None => radius * turn.sin(),
            Some(_) => {
                let centre_off = start - radius * turn.cos();
                (radius * turn.sin()).atan2(centre_off.abs()) * (start - radius).abs()
            }
        };
        Ok(Self { side, lost, straight: (turn.abs() <= largest).then(|| (turn, late())) })
    }

    /// The line off the contour. It takes nothing of the contour, whose last side ends at its end on every control.
    pub(crate) fn last(&self, line: &ContourSide, tool: FitTool) -> Result<(), NoFit> {
        let FitTool { radius, left, .. } = tool;
        self.ends(0.0, tool)?;
        let has = (line.to - line.from).norm();
        if has <= radius + SPENT_SIDE {
            return Err(NoFit::Line(has));
        }
        let [_, loses] = self.losses(line, radius, left).ok_or(NoFit::Corner)?;
        if loses < has - SPENT_SIDE { Ok(()) } else { Err(NoFit::Side { earlier: false, has, loses }) }
    }

    /// Whether the control ends this side, which loses some of its end, where it should.
    fn ends(&self, loses: f64, tool: FitTool) -> Result<(), NoFit> {
        let Some((turn, late)) = self.straight else { return Ok(()) };
        let has = self.side.tool_length(tool.radius, tool.left);
        let fits = match self.side.round {
            None => late + loses <= has,
            Some((_, angle)) => late + loses < has && -late - loses <= tool.straight[1] * has / angle.abs(),
        };
        if fits { Ok(()) } else { Err(NoFit::Straight(turn)) }
    }

    /// Angle towards the tool at the corner after this side.
    fn turn(&self, next: &ContourSide, left: bool) -> f64 {
        let (before, after) = (self.side.along()[1], next.along()[0]);
        let angle = before.perp(&after).atan2(before.dot(&after));
        if left { angle } else { -angle }
    }

    /// What the path of the centre along this side and along the next one loses at their corner; `None` if it has no
    /// place there.
    fn losses(&self, next: &ContourSide, radius: f64, left: bool) -> Option<[f64; 2]> {
        let turn = self.turn(next, left);
        if turn <= STRAIGHT_ON || turn >= PI - STRAIGHT_ON {
            return Some([0.0; 2]);
        }
        let ([_, before], [after, _]) = (self.side.radii(left), next.radii(left));
        match (before.is_finite(), after.is_finite()) {
            (false, false) => Some([radius / (0.5 * (PI - turn)).tan(); 2]),
            (false, true) => line_and_round(after, turn, radius),
            (true, false) => line_and_round(before, turn, radius).map(|[line, round]| [round, line]),
            (true, true) => {
                let centres = [self.side.round?.0, next.round?.0];
                rounds([before, after], (centres[1] - centres[0]).norm(), radius)
            }
        }
    }
}

/// Losses of a line and of an arc that meet at an angle.
fn line_and_round(round: RoundTool, turn: f64, radius: f64) -> Option<[f64; 2]> {
    let inside = round.signum();
    let (arc, path) = (round.abs(), (round - radius).abs());
    let height = arc * turn.cos() - inside * radius;
    let angle = arc_cosine(height / path)?;
    let line = arc * turn.sin() - path * angle.sin();
    Some([(inside * line).max(0.0), (angle - turn).abs() * path])
}

/// Losses of two arcs whose centres are `apart`.
fn rounds(rounds: [RoundTool; 2], apart: f64, radius: f64) -> Option<[f64; 2]> {
    let arcs = rounds.map(f64::abs);
    let paths = rounds.map(|round| (round - radius).abs());
    let at_centres = |[one, other]: [f64; 2]| {
        let cosine = |one: f64, other: f64| 0.5 * (apart + (one - other) * (one + other) / apart) / one;
        Some([arc_cosine(cosine(one, other))?, arc_cosine(cosine(other, one))?])
    };
    let (corner, tool) = (at_centres(arcs)?, at_centres(paths)?);
    Some([0, 1].map(|index| (tool[index] - corner[index]).abs() * paths[index]))
}

/// Arc cosine; `None` outside -1 to 1 by more than rounding.
fn arc_cosine(cosine: f64) -> Option<f64> {
    (cosine.abs() <= 1.0 + TOUCHING).then(|| cosine.clamp(-1.0, 1.0).acos())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(from: [f64; 2], to: [f64; 2]) -> ContourSide {
        ContourSide { from: from.into(), to: to.into(), round: None }
    }

    fn round(from: [f64; 2], to: [f64; 2], centre: [f64; 2], degrees: f64) -> ContourSide {
        ContourSide { round: Some((centre.into(), degrees.to_radians())), ..line(from, to) }
    }

    /// What is wrong with a tool on the left of a lead-in from the left and these sides.
    fn fit(radius: f64, sides: &[ContourSide]) -> Result<(), NoFit> {
        let start = sides[0].from;
        let along = sides[0].along()[0];
        let lead_in = ContourSide { from: start - along * 50.0, to: start, round: None };
        let mut last = FittedSide::first(lead_in, radius)?;
        for side in sides {
            last = last.next(*side, FitTool { radius, left: true, straight: [0.0; 2] })?;
        }
        Ok(())
    }

    #[test]
    fn a_pocket_between_three_lines_is_wider_than_the_tool() {
        let pocket = |width: f64| {
            [line([0.0, 0.0], [20.0, 0.0]), line([20.0, 0.0], [20.0, width]), line([20.0, width], [0.0, width])]
        };
        assert_eq!(fit(5.0, &pocket(10.1)), Ok(()));
        assert!(matches!(fit(5.0, &pocket(9.9)), Err(NoFit::Side { earlier: true, .. })));
        assert_eq!(fit(5.0, &pocket(-0.1)), Ok(()));
    }

    #[test]
    fn an_arc_around_the_tool_is_larger_than_the_tool() {
        let arc = |radius: f64| [round([0.0, 0.0], [radius, radius], [0.0, radius], 90.0)];
        assert_eq!(fit(5.0, &arc(5.1)), Ok(()));
        assert_eq!(fit(5.0, &arc(5.0)), Err(NoFit::Arc(5.0)));
        let outer = [round([0.0, 0.0], [1.0, -1.0], [0.0, -1.0], -90.0)];
        assert_eq!(fit(5.0, &outer), Ok(()));
    }

    #[test]
    fn a_line_and_an_arc_lose_what_the_tool_cannot_reach() {
        // The centre of the tool is 1 above the line, and 3 from the centre of an arc with a radius of 4, which is 3
        // above it.
        let [lost_line, lost_arc] = line_and_round(4.0, 0.75_f64.acos(), 1.0).expect("it fits");
        assert!((lost_line - (7.0_f64.sqrt() - 5.0_f64.sqrt())).abs() < 1e-12, "{lost_line}");
        assert!((lost_arc - 3.0 * ((2.0_f64 / 3.0).acos() - 0.75_f64.acos())).abs() < 1e-12, "{lost_arc}");
        assert_eq!(line_and_round(4.0, 3.0, 2.0), None);
    }

    #[test]
    fn two_arcs_lose_what_the_tool_cannot_reach() {
        // Both arcs have a radius of 5 and their centres 6 apart: the corner is 4 above the middle, the tool sqrt 7 of
        // it.
        let lost = rounds([5.0, 5.0], 6.0, 1.0).expect("it fits");
        let expected = 4.0 * (0.6_f64.acos() - 0.75_f64.acos());
        assert!(lost.iter().all(|lost| (lost - expected).abs() < 1e-12), "{lost:?} {expected}");
        assert_eq!(rounds([5.0, 5.0], 6.0, 2.5), None);
    }
}
