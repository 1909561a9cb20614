//! Contours with cutter compensation: whether the tool fits along the path of the blocks.
//!
//! The path is that of the words, in their plane. Where it is the contour, the tool has its radius; where it is that of
//! the tool centre, the largest wear, and the wear may have either sign: smaller tools are offset to the other side.

use nalgebra::Vector2;

use super::super::geometry::{ContourSide, FitTool, FittedSide, NoFit};
use super::super::read::{Action, ArcMove, SideOfPath, WorkPlane};
use super::{Comparison, Current};
use crate::diag::code::check;
use crate::program::Units;

/// Contour that is being followed.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct ContourState {
    side: SideOfPath,
    /// The tool, or its largest wear to both sides; each with the last side.
    tools: [Option<(FitTool, Option<FittedSide>)>; 2],
    /// Line of the CL data with the last side.
    last_line: u64,
    /// Blocks since it that move nothing in its plane.
    idle: u8,
}

impl Comparison<'_> {
    /// Follows a contour by a block that moves.
    #[inline]
    pub(super) fn follow_contour(&mut self, current: &Current<'_>) {
        let side = current.block.state.side.unwrap_or_default();
        if side != SideOfPath::None || self.contour.side != SideOfPath::None {
            self.offset_contour(side, current);
        }
    }

    #[inline(never)]
    fn offset_contour(&mut self, side: SideOfPath, current: &Current<'_>) {
        let line_number = self.progress.location().line;
        let begins = self.contour.side == SideOfPath::None;
        if begins {
            self.contour = ContourState { side, tools: self.tools_on(side), last_line: line_number, idle: 0 };
        }
        let Some(path) = self.side_of(current) else {
            // Where words of its plane lead nowhere, Fanuc ends its look-ahead as after two blocks.
            let in_plane = current.block.state.plane.map_or(0, |plane| {
                let [first, second, _] =
                    plane.axes().map(|axis| self.rules.words().xyz()[axis].map_or(0, |index| 1 << index));
                first | second
            });
            let leads_nowhere = current.block.written & in_plane != 0;
            return self.idle_in_contour(if leads_nowhere { u8::MAX } else { 1 }, current);
        };
        self.contour.idle = 0;
        let mut faults = [const { None }; 2];
        for (tool, fault) in self.contour.tools.iter_mut().zip(&mut faults) {
            let Some((tool, last)) = tool else { continue };
            let tool = *tool;
            let fitted = match last {
                None if begins => FittedSide::first(path, tool.radius).map(Some),
                None => continue,
                Some(last) if side == SideOfPath::None => last.last(&path, tool).map(|()| None),
                Some(last) => last.next(path, tool).map(Some),
            };
            match fitted {
                Ok(fitted) => *last = fitted,
                Err(no_fit) => {
                    *last = None;
                    *fault = Some((no_fit, tool.radius));
                }
            }
        }
        for (index, fault) in faults.into_iter().enumerate() {
            let text = fault.map(|(no_fit, radius)| self.no_fit_text(no_fit, radius, index, begins));
            self.found_any(current, check::CUTTER_COMPENSATION, text);
        }
        self.contour.last_line = line_number;
        if side == SideOfPath::None {
            self.contour = ContourState::default();
        }
    }

    /// A block in a contour that moves nothing.
    pub(super) fn stands_in_contour(&mut self, current: &Current<'_>) {
        let block = current.block;
        if self.contour.side != SideOfPath::None && !block.goes_on {
            self.idle_in_contour(block.looked_over, current);
        }
    }

    /// Counts blocks between two motions of a contour, which the control looks ahead over.
    fn idle_in_contour(&mut self, blocks: u8, current: &Current<'_>) {
        let Some(most) = self.rules.facts().idle_in_contour else { return };
        let before = self.contour.idle;
        self.contour.idle = before.saturating_add(blocks);
        if before <= most && self.contour.idle > most {
            let text = match most {
                1 => "a further block without a motion, or one that leads nowhere, stands between two motions under cutter \
                      compensation: the control looks ahead over one, and cuts into the corner"
                    .to_owned(),
                _ => format!(
                    "more than {most} blocks without a motion stand between two motions under cutter compensation: the control looks \
                     ahead over no more, and cuts into the corner"
                ),
            };
            self.found(
                current,
                check::CUTTER_COMPENSATION,
                &format!("{text}; give coolant, spindle and other functions before CUTCOM or after it"),
            );
        }
    }

    /// The tools that have to fit.
    fn tools_on(&self, side: SideOfPath) -> [Option<(FitTool, Option<FittedSide>)>; 2] {
        let left = side == SideOfPath::Left;
        let in_inches = self.rules.units() == Units::Inches;
        let straight = self
            .rules
            .facts()
            .straight_corners
            .map_or([0.0; 2], |[largest, in_mm, in_inch]| [largest, if in_inches { in_inch } else { in_mm }]);
        let tool = |radius: f64, left: bool| Some((FitTool { radius, left, straight }, None));
        let shop = &self.rules.policy().shop;
        if shop.compensated_centre {
            return [left, !left].map(|left| tool(shop.largest_wear_mm, left));
        }
        let radius_mm = self.progress.next().and_then(|item| item.required.radius_mm);
        [radius_mm.filter(|radius| *radius > 0.0).and_then(|radius| tool(radius, left)), None]
    }

    /// The side of a contour along which a block moves; `None` if it moves along the tool, or from an unknown position.
    fn side_of(&self, current: &Current<'_>) -> Option<ContourSide> {
        let block = current.block;
        let [first, second, _] = WorkPlane::Xy.axes();
        let xyz = self.rules.words().xyz();
        let (first, second) = (xyz[first]?, xyz[second]?);
        let needed = 1 << first | 1 << second;
        if self.previous.known & block.known_before & needed != needed {
            return None;
        }
        let at = |words: &[f64]| Vector2::new(words[first], words[second]);
        let (from, to) = (at(&self.previous.words), at(&block.values));
        let round = match block.action {
            Action::Arc(ArcMove { centre: [x, y, _], sweep, .. }) => Some((Vector2::new(x, y), sweep)),
            _ => None,
        };
        (round.is_some() || from != to).then_some(ContourSide { from, to, round })
    }

    /// Why the tool does not fit. `radius_mm`: its radius, or its wear; `tool`: its index in [`ContourState`];
    /// `begins`: the compensation begins with this motion.
    fn no_fit_text(&self, no_fit: NoFit, radius_mm: f64, tool: usize, begins: bool) -> String {
        let units = self.rules.units();
        let radius = units.length(radius_mm);
        let tool = match (self.rules.policy().shop.compensated_centre, tool) {
            (false, _) => format!("the tool radius of {radius}"),
            (true, 0) => format!("a wear of {radius}"),
            (true, _) => format!("a wear of -{radius}"),
        };
        match no_fit {
            NoFit::Arc(arc) => format!("{tool} does not fit into this arc with a radius of {}", units.length(arc)),
            NoFit::Straight(turn) => {
                let (degrees, line) = (turn.abs().to_degrees(), self.contour.last_line);
                format!(
                    "the control takes the corner of {degrees:.3}° before the motion of CL line {line} as straight on, and stops at its end"
                )
            }
            NoFit::Corner => format!("{tool} does not fit into the corner before this block"),
            NoFit::Side { earlier, has, loses } => {
                let which = match earlier {
                    true => format!("the motion of CL line {}", self.contour.last_line),
                    false => "this motion".to_owned(),
                };
                let (has, loses) = (units.length(has), units.length(loses));
                format!("offset by {tool}, {which} has {has}, and loses {loses} in its corners")
            }
            NoFit::Line(has) => {
                let verb = if begins { "begins" } else { "ends" };
                format!("compensation {verb} with a line of {}, no longer than {tool}", units.length(has))
            }
        }
    }
}
