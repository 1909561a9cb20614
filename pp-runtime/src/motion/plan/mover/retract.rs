//! Motion between cuts: machine retract, motion to the approach point, tip control and planes on and off, parking.

use std::collections::BTreeMap;

use crate::diag::code::plan;
use crate::kinematics::AxisKind;
use crate::options::StretchMode;

use crate::motion::fault::{Fault, ItemError, Planned};
use crate::motion::place::{AxisPosition, TipEntry};
use crate::motion::plan::mover::Mover;
use crate::motion::step::{AxisWords, MAX_AXES, Sink, Step};

/// Positions in the chain of the axes of a mask.
fn indices(mask: u16) -> impl Iterator<Item = usize> {
    (0..MAX_AXES).filter(move |index| mask & (1 << index) != 0)
}

impl<S: Sink> Mover<'_, S> {
    /// Writes a safety line, at which the program can be entered. `changes_tool`: a tool change follows.
    pub(crate) fn restart(&mut self, changes_tool: bool) -> Planned {
        self.restarts += 1;
        self.output.restart(self.restarts, changes_tool)?;
        self.clamps.forget();
        self.position.leave_frame();
        Ok(())
    }

    /// Blocks that may be skipped begin or end: clamps are as those have left them, or not.
    pub(crate) fn skip_clamps(&mut self) {
        self.clamps.forget();
    }

    /// Moves the retract axis to its machine position, unless it is there; ends tip control and tilted planes.
    pub(crate) fn machine_retract(&mut self) -> Planned {
        if self.position.is_retracted() {
            return Ok(());
        }
        self.output.cancel_inverse_time()?;
        if self.restarts == 0 {
            self.restart(false)?;
        }
        if self.abilities.retracts_along_tool && !self.placer.retracts_along_tool() {
            let fault = plan::RETRACT.fault(
                "the machine retract leads along the tool axis (M140), which a rotary axis in the head tilts, or which is not \
                 parallel to the retract axis",
            );
            return Err(fault.help("set `retract.method` to a retract in machine coordinates").into());
        }
        // Away from the part, too, its place is known until something else may have moved it, as the rotary axes.
        if self.position.knows_rotary_axes() {
            self.check_below_retract(self.position.place(), "the tool")?;
        }
        let words = self.placer.retract_words(self.policy.options.retract.position_mm())?;
        let off = match (self.placer.mode(), self.abilities.plane) {
            _ if !self.position.is_in_frame() => None,
            (StretchMode::Plane, _) if self.moves_zero() => Some((Step::DynamicOffset { on: false }, true)),
            (StretchMode::Plane, Some(plane)) => Some((Step::PlaneOff, plane.ends_after_retract)),
            (StretchMode::Plane, None) | (StretchMode::Axes, _) => None,
            (StretchMode::Tcp, _) => Some((Step::TipControl { on: false }, false)),
        };
        if let Some((off, false)) = off {
            self.output.step(&off)?;
        }
        self.output.step(&Step::Retract { words })?;
        if let Some((off, true)) = off {
            self.output.step(&off)?;
        }
        self.position.retract();
        Ok(())
    }

    /// A place in the frame of the following motions, and the step that sets this frame; no plane is set that is not
    /// tilted, with the rotary axes at zero. The frame may depend on the rotary angles of the place. Moves nothing.
    pub(crate) fn framed_at(&mut self, place: AxisPosition) -> Result<(AxisPosition, Option<Step<'static>>), Fault> {
        match (self.placer.mode(), self.abilities.plane) {
            (StretchMode::Axes, _) => Ok((place, None)),
            (StretchMode::Tcp, _) => Ok((self.placer.in_tip_frame(place)?, Some(Step::TipControl { on: true }))),
            (StretchMode::Plane, _) if self.moves_zero() => {
                let place = self.placer.in_moved_zero(place)?;
                let step = (!self.placer.is_plain(&place)).then_some(Step::DynamicOffset { on: true });
                Ok((place, step))
            }
            (StretchMode::Plane, Some(ability)) => {
                let (place, tilt) = self.placer.tilted(place, &ability)?;
                if tilt.is_plain() && self.placer.is_plain(&place) {
                    return Ok((place, None));
                }
                let pose = self.placer.pose_of_plane(&place, ability.pose);
                Ok((place, Some(Step::Plane { angles: tilt.words, pose })))
            }
            (StretchMode::Plane, None) => Ok((place, None)),
        }
    }

    /// Whether the zero of the words moves with the table where the mode is "plane".
    pub(crate) fn moves_zero(&self) -> bool {
        self.abilities.moves_zero_in_planes(self.placer.chain())
    }

    /// Counts an approach for the clamps.
    pub(crate) fn begin_approach(&mut self) {
        self.clamps.approach();
    }

    /// Moves from the machine retract to the approach point: unclamp, the rotary axes alone, tip control or tilted
    /// plane, clamp, the other linear axes, the retract axis. The caller sets the position.
    pub(crate) fn approach_from_retract(&mut self, above: &AxisPosition, frame: Option<Step<'static>>) -> Planned {
        self.check_below_retract(above, "the approach point")?;
        let (linear, rotary) = (self.placer.linear_mask(), self.placer.rotary_mask());
        let entry = match self.placer.mode() {
            StretchMode::Tcp => self.placer.tip_entry(above, self.abilities.tip, self.abilities.plane)?,
            StretchMode::Axes | StretchMode::Plane => None,
        };
        let by_plane = entry.is_some_and(|entry| entry.is_in_plane());
        // Under a zero that follows the table only words rotate an axis.
        let plane = self.placer.mode() == StretchMode::Plane && !self.moves_zero() || by_plane;
        self.home_before_rotation(above, false)?;
        // Where an axis is elsewhere than known, its word in the block rotates it.
        let all = plane || !self.position.knows_rotary_axes();
        self.clamps.open(&self.position.place().words, &above.words, all, &mut self.output)?;
        self.rotate_alone(above, rotary)?;
        if let Some(TipEntry { words, frame: of_words }) = entry {
            if let Some([on, _]) = of_words {
                self.output.step(&on)?;
                self.guard_plane(&on, above)?;
            }
            self.rapid_across(above, words)?;
            if let Some([_, off]) = of_words {
                self.output.step(&off)?;
            }
            if by_plane {
                // The control may have positioned the rotary axes in another revolution.
                self.restate(above, rotary)?;
            }
        }
        if let Some(frame) = frame {
            self.output.step(&frame)?;
            self.guard_plane(&frame, above)?;
            self.position.enter_frame();
        }
        self.clamps.close(&mut self.output)?;
        let last = match (self.placer.mode(), entry) {
            (StretchMode::Axes, _) | (StretchMode::Tcp, None) => 1 << self.placer.retract_axis(),
            // Along the tool axis of the plane.
            (StretchMode::Plane, _) => 1 << self.placer.frame_letters()[2],
            // The others have arrived; in words of the tip they change as well.
            (StretchMode::Tcp, Some(_)) => linear,
        };
        self.rapid_alone(above, linear & !last)?;
        self.rapid(above, last)
    }

    /// Moves the linear axes other than the retract axis to their home positions, where the rotary axes may rotate on
    /// the way to a place and the configuration asks for it; `unsure`: they may rotate although the place has their
    /// angles.
    fn home_before_rotation(&mut self, to: &AxisPosition, unsure: bool) -> Planned {
        let (retract, rotary) = (&self.policy.options.retract, self.placer.rotary_mask());
        let rotates = |index: usize| self.position.place().words[index] != to.words[index];
        let rests = !unsure && self.position.knows_rotary_axes() && !indices(rotary).any(rotates);
        if !retract.home_on_indexing || rotary == 0 || rests {
            return Ok(());
        }
        let mut words = AxisWords::default();
        for index in indices(self.placer.linear_mask() & !(1 << self.placer.retract_axis())) {
            words.add(&self.placer.machine_words(index, retract.home_mm(self.placer.chain()[index].letter))?);
        }
        Ok(self.output.step(&Step::Home { words })?)
    }

    /// Compares the rotary axes with their positions after a tilted plane, whose call may choose another solution.
    fn guard_plane(&mut self, frame: &Step<'_>, at: &AxisPosition) -> Planned {
        let Some(ability) = self.abilities.plane.filter(|_| matches!(frame, Step::Plane { .. })) else { return Ok(()) };
        let mask = self.placer.directing_axes(at, ability.decimals);
        if self.abilities.guards_planes && mask != 0 {
            self.plane_guards += 1;
            let words = self.placer.words(at, mask);
            self.output.guard(&Step::PlaneGuard { label: self.plane_guards, words })?;
        }
        Ok(())
    }

    /// Whether the way between a place and the retract position leads away from the part, as far as `machine_zero` is
    /// known.
    fn check_below_retract(&self, place: &AxisPosition, what: &str) -> Result<(), Fault> {
        let retract = self.policy.options.retract.position_mm();
        match self.placer.below_retract(place, retract) {
            Some(below) if below < -self.placer.unit_mm() => {
                let axis = self.placer.chain()[self.placer.retract_axis()].letter;
                Err(plan::RETRACT
                    .fault(format_args!(
                        "{what} is {} above the retract position {axis} = {} (machine coordinate)",
                        self.placer.units().coordinate(-below),
                        self.placer.units().length(retract)
                    ))
                    .help("mount the part lower, reduce `approach.distance`, or raise `retract.position`"))
            }
            Some(_) | None => Ok(()),
        }
    }

    /// Moves the axes to their parking positions, where they are not there.
    pub(crate) fn park(&mut self) -> Planned {
        if self.position.is_parked() {
            return Ok(());
        }
        if let Some(parked) = self.take_axes_to(&self.policy.options.park)? {
            self.position.park_rotary(parked);
        }
        Ok(())
    }

    /// Moves the axes to their positions for the blocks that measure a tool.
    pub(crate) fn take_axes_to_tool_position(&mut self) -> Planned {
        self.take_axes_to(&self.policy.options.tool_position).map(|_| ())
    }

    /// Moves the axes to their positions for a tool change.
    pub(crate) fn take_axes_to_tool_change(&mut self) -> Planned {
        self.take_axes_to(&self.policy.options.retract.tool_change_position).map(|_| ())
    }

    /// Moves axes from the machine retract to positions of the configuration: the rotary axes first, the retract axis
    /// last. Returns the place where the rotary axes then are, if any of them has moved. The course goes on from where
    /// they were: blocks of the shop follow, or a tool change, after which their angles are unknown.
    fn take_axes_to(&mut self, positions: &BTreeMap<char, f64>) -> Result<Option<AxisPosition>, ItemError> {
        self.position.leave_parking();
        let (turned, mask) = self.placer.parked(positions, self.position.place())?;
        if mask != 0 {
            // Behind tool vectors the control has the angles, and these words may rotate the axes.
            self.home_before_rotation(&turned, self.placer.writes_vectors())?;
            self.clamps.switch(mask, false, &mut self.output)?;
            self.rotate_alone(&turned, mask)?;
            self.clamps.switch(mask, true, &mut self.output)?;
        }
        let mut others = AxisWords::default();
        let mut last = None;
        let linear =
            self.placer.chain().iter().enumerate().filter(|(_, axis)| axis.kind == AxisKind::Linear && !axis.held);
        for (index, coordinate) in linear.filter_map(|(index, axis)| Some((index, *positions.get(&axis.letter)?))) {
            let words = self.placer.machine_words(index, coordinate)?;
            if index == self.placer.retract_axis() {
                last = Some(words);
            } else {
                others.add(&words);
            }
        }
        if others.mask != 0 {
            self.output.step(&Step::Machine { words: others })?;
        }
        if let Some(words) = last {
            self.output.step(&Step::Machine { words })?;
        }
        Ok((mask != 0).then_some(turned))
    }
}
