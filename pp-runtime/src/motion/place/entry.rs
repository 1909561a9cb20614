//! Entry of tip control: how the tool comes over its approach point before the retract axis moves.
//!
//! From the machine retract the axes across the retract axis move first, in words that do not move the retract axis. A
//! rapid need not be straight: if all linear axes moved together, the tool could be down next to a tilted table before
//! it is over the part. Under tip control itself the words X and Y are such words only where the rotary axes of the
//! table leave the direction of the retract axis alone; over a tilted table they come before tip control, in a frame of
//! the control that knows where the part is, or as axis positions.

use nalgebra::UnitVector3;

use crate::diag::code::plan;
use crate::motion::fault::Fault;
use crate::motion::step::{AxisWords, MAX_AXES, Step};
use crate::nc::whole_units;

use super::frame::{TipAbility, TipStart, WordMap, no_plane, orientation, table};
use super::tilted_plane::{PlaneAbility, plane_across};
use super::{AxisPosition, Placer, too_large};
use crate::tolerance::writer::PARALLEL;

/// Motion of the axes across the retract axis before tip control is switched on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct TipEntry {
    /// Words of these axes.
    pub(crate) words: AxisWords,
    /// The steps that begin and end the frame of these words; `None`: axis positions.
    pub(crate) frame: Option<[Step<'static>; 2]>,
}

impl TipEntry {
    /// Whether the control positions the rotary axes to a tilted plane.
    pub(crate) fn is_in_plane(&self) -> bool {
        matches!(self.frame, Some([Step::Plane { .. }, _]))
    }
}

impl Placer {
    /// What moves before tip control is switched on for the approach point `above`; `None` if the words of the tip
    /// alone can bring the tool over it.
    pub(crate) fn tip_entry(
        &self,
        above: &AxisPosition,
        ability: Option<TipAbility>,
        plane: Option<PlaneAbility>,
    ) -> Result<Option<TipEntry>, Fault> {
        let start = ability.map_or(TipStart::Configured, |ability| ability.start);
        if start == TipStart::Alone && self.tip_words_spare_retract(above) {
            return Ok(None);
        }
        let tool_along_retract = self.tool_is_along_retract(above);
        let before = |words, frame| Ok(Some(TipEntry { words, frame }));
        match (start, plane.filter(|_| tool_along_retract && !self.table_is_level(above))) {
            _ if self.is_plain(above) => before(self.axis_words_across(above)?, None),
            (TipStart::WithMotion { dynamic_offset: true }, _) if !self.head => {
                let map = self.frame.moved_zero_map(&*self.machine, &above.axes);
                let [on, off] = [true, false].map(|on| Step::DynamicOffset { on });
                before(self.mapped_words_across(above, &map)?, Some([on, off]))
            }
            (TipStart::WithMotion { .. }, Some(PlaneAbility { length_first: true, .. })) => Err(plan::MODE.fault(
                "the table is rotated where tip control begins: X and Y come over the part in the dynamic offset (G254), which is \
                 not among `control.functions`, or is not for this `rotary_offset`",
            )
            .help("add \"dynamic_offset\" if the control has it, or use `mode = \"axes\"`")),
            (TipStart::Configured, _) | (_, None) => before(self.axis_words_across(above)?, None),
            (_, Some(ability)) => {
                let plane = plane_across(&self.axis_of_plane(above)?);
                let (map, tilt) = self.frame.plane_map(&ability, &plane).ok_or_else(no_plane)?;
                let pose = self.pose_of_plane(above, ability.pose);
                let on = Step::Plane { angles: tilt.words, pose };
                before(self.mapped_words_across(above, &map)?, Some([on, Step::PlaneOff]))
            }
        }
    }

    /// Axes across the retract axis: bits.
    pub(crate) fn across_mask(&self) -> u16 {
        self.linear.mask & !(1 << self.linear.retract_axis)
    }

    /// Whether words of the tip other than that of the retract axis do not move the retract axis.
    fn tip_words_spare_retract(&self, at: &AxisPosition) -> bool {
        let Some((solved, map)) = self.axis_map(at) else { return false };
        let Some(row) = solved.iter().position(|&index| index == self.linear.retract_axis) else { return false };
        let Some(words) = self.frame.map(&*self.machine, &at.axes) else { return false };
        // Share of each word in the motion of the retract axis.
        let shares = map.row(row) * words.rotation.transpose();
        let letters = self.frame.letters();
        (0..3).all(|word| letters[word] == self.linear.retract_axis || shares[word].abs() < PARALLEL)
    }

    /// Whether the rotary axes of the table leave the direction of the tool at zero alone.
    fn table_is_level(&self, at: &AxisPosition) -> bool {
        let up = self.machine.tool_axis().into_inner();
        (table(&*self.machine, &at.axes).0 * up - up).norm() < PARALLEL
    }

    /// Whether the tool, in the machine, is parallel to the retract axis.
    fn tool_is_along_retract(&self, at: &AxisPosition) -> bool {
        let in_workpiece = orientation(&*self.machine, &at.axes) * self.machine.tool_axis().into_inner();
        let tool = UnitVector3::new_normalize(table(&*self.machine, &at.axes).0 * in_workpiece);
        let retract = self.machine.joint(self.linear.retract_axis).direction;
        !self.head || tool.cross(&retract).norm() < PARALLEL
    }

    /// Words of the axes across the retract axis that are axis positions.
    fn axis_words_across(&self, at: &AxisPosition) -> Result<AxisWords, Fault> {
        if self.head && self.travel.gauge_length_mm().is_none() && !self.is_plain(at) {
            return Err(plan::TOOL_LENGTH.fault(
                "X and Y come as axis positions before tip control here, and the gauge length of the tool is unknown",
            )
            .help("give `[tools.N] length` in the configuration, or LENGTH in LOADTL"));
        }
        let values = |index: usize| at.axes[index] + self.datum.linear_shift_mm(index);
        self.words_across(values)
    }

    /// Words of the axes across the retract axis in a frame of the control.
    fn mapped_words_across(&self, at: &AxisPosition, map: &WordMap) -> Result<AxisWords, Fault> {
        let words = map.words(&at.pose.tip);
        let letters = self.frame.letters();
        let value = |index: usize| letters.iter().position(|&letter| letter == index).map_or(0.0, |word| words[word]);
        self.words_across(value)
    }

    fn words_across(&self, value_mm: impl Fn(usize) -> f64) -> Result<AxisWords, Fault> {
        let mut words = AxisWords { mask: self.across_mask(), ..AxisWords::default() };
        for index in (0..MAX_AXES).filter(|index| words.mask & (1 << index) != 0) {
            let units = whole_units(value_mm(index), self.linear.scale.units_per_mm).ok();
            words.units[index] = units
                .filter(|units| units.abs() < self.bounds[index])
                .ok_or_else(|| too_large(self.chain[index].letter))?;
        }
        Ok(words)
    }
}
