//! Links: rapids that rotate the tool, on the path of the CL data.

use crate::kinematics::Pose;
use crate::motion::fault::Planned;
use crate::motion::place::{AxisPosition, Linearised};
use crate::motion::plan::mover::Mover;
use crate::motion::plan::rapid::LinkForm;
use crate::motion::step::{BlockReason, Sink};

impl<S: Sink> Mover<'_, S> {
    /// Whether the axes can follow the path of a rapid to a place: the rotary axes take the nearest angles, every piece
    /// is certified, and within the limits. Where the course has other angles, it rewinds an axis or changes the
    /// branch.
    pub(crate) fn follows(&mut self, pose: &Pose, place: &AxisPosition) -> bool {
        let (start, angle_rad) = (*self.position.place(), self.policy.options.axis_tolerance_path_rad);
        let mut pieces = Linearised::new(&start, place, self.tolerance, self.law);
        self.placer.attempt(|placer| {
            if placer.place(pose, &start, false, None)?.words != place.words {
                return Ok(false);
            }
            placer.check_passed_pole(&start, place)?;
            let mut here = start;
            while let Some(piece) = pieces.next(placer)? {
                placer.check_travel(&piece.place)?;
                placer.check_between(&here, &piece.place)?;
                placer.check_hidden_rotation(&here, &piece.place, angle_rad)?;
                here = piece.place;
            }
            Ok(true)
        })
    }

    /// Writes a link that the axes can follow.
    pub(crate) fn link(&mut self, place: &AxisPosition, form: LinkForm) -> Planned {
        self.output.statistics_mut().links += u64::from(self.indexes(place));
        let LinkForm::Feed(rate) = form else { return self.rapid_in_pieces(place) };
        self.feed_in_pieces(place, rate, self.tolerance)
    }

    fn rapid_in_pieces(&mut self, place: &AxisPosition) -> Planned {
        self.output.cancel_inverse_time()?;
        let mut pieces = Linearised::new(self.here(), place, self.tolerance, self.law);
        while let Some(piece) = pieces.next(&self.placer)? {
            if piece.place.words == self.here().words {
                continue;
            }
            self.note_rotation(&piece.place);
            let inserted = (piece.place.words != place.words).then_some(BlockReason::Tolerance);
            let reached = self.placer.state_at(&piece.place);
            self.rapid_words(&piece.place, self.block_axes(), reached, inserted)?;
            self.position.go_to(&piece.place);
        }
        Ok(())
    }
}
