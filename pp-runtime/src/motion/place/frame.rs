//! Frame of the linear words of a block: axis values, or coordinates of the tip in a frame of the control.
//!
//! In mode `tcp` the control moves the axes so that the tip is at the X Y Z of the block; in mode `plane` X Y Z are
//! coordinates in a tilted plane. In both modes the words are an isometry of the workpiece frame,
//!
//! ```text
//! word = S · R · (p + o) + shift
//! ```
//!
//! where `S` contains the signs of the words (-1 for a word that runs backwards, so that with all rotary axes at zero
//! the words are those of mode `axes`), `o` is the part zero if the words are measured from the table, and `R` is the
//! rotation of the frame: the identity for a frame fixed to the table at zero, the rotation of the table for a frame
//! fixed to the table where tip control begins, the rotation of the plane for a tilted plane.
//!
//! For a mirrored control (an odd number of backward words) the part is mirrored: a rotation `R` of the part is `S·R·S`
//! in its words.

use nalgebra::{Matrix3, Point3, Vector3};

use crate::diag::code::plan;
use crate::kinematics::{AnyMachine, AxisKind, AxisValues, MotionBound, Side};
use crate::motion::policy::Policy;
use crate::options::{StretchMode, TcpFrame, ToolPosture};
use crate::set_up::ProgramZero;

use super::tilted_plane::{PlaneAbility, TiltedPlane};
use crate::motion::fault::Fault;

/// How tip control (TCP) is switched on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TipStart {
    /// By a block of its own, which moves nothing.
    Alone,
    /// With the first motion.
    WithMotion {
        /// The control has a dynamic work offset: the zero of its words follows the table, whose axes are not rotated.
        dynamic_offset: bool,
    },
    /// By codes of the configuration; it is not known whether they move anything.
    Configured,
}

impl TipStart {
    /// Whether X and Y come over a tilted table in a plane of the control, where it has planes.
    #[must_use]
    pub fn is_over_tilted_table(self) -> bool {
        matches!(self, Self::Alone | Self::WithMotion { dynamic_offset: false })
    }
}

/// Abilities of the tip control (TCP) of a control.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TipAbility {
    /// How it is switched on.
    pub start: TipStart,
    /// A parameter of the machine selects the frame of its coordinates.
    pub frame_is_parameter: bool,
    /// It can rotate the tool axis in the plane of the tool axes at both ends of a block.
    pub rotates_axis_in_plane: bool,
    /// It accepts the tool axis as a vector.
    pub takes_vectors: bool,
    /// It slows down where an axis would exceed its speed.
    pub holds_axis_speeds: bool,
}

/// An isometry of the workpiece frame: `word = rotation · p + shift`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct WordMap {
    pub(crate) rotation: Matrix3<f64>,
    pub(crate) shift_mm: Vector3<f64>,
}

impl WordMap {
    /// The words X Y Z of a tip, mm.
    pub(crate) fn words(&self, tip: &Point3<f64>) -> Vector3<f64> {
        self.rotation * tip.coords + self.shift_mm
    }

    /// The tip of the words X Y Z, mm.
    pub(crate) fn tip(&self, words: &Vector3<f64>) -> Point3<f64> {
        Point3::from(self.rotation.transpose() * (words - self.shift_mm))
    }
}

/// Meaning of the linear words.
#[derive(Debug, Clone, PartialEq)]
enum LinearWords {
    /// Axis values.
    Axes,
    /// Coordinates of the tip in a frame that is fixed until the next change.
    Fixed(WordMap),
    /// Coordinates of the tip in a frame that does not rotate with the table.
    Turning,
}

/// Frame of the linear words for one machine and set-up.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct WordFrame {
    meaning: LinearWords,
    mode: StretchMode,
    tcp_frame: TcpFrame,
    posture: ToolPosture,
    /// Signs of the words X Y Z.
    signs: Matrix3<f64>,
    /// Words are measured from the reference point of the table.
    from_table: bool,
    /// Part zero measured from the zero of the words.
    zero_mm: Vector3<f64>,
    /// Positions of X Y Z in the chain.
    letters: [usize; 3],
}

impl WordFrame {
    pub(crate) fn new(machine: &dyn AnyMachine, policy: Policy<'_>) -> Self {
        let position = |letter: char| machine.axes().iter().position(|axis| axis.letter == letter);
        let letters = ['X', 'Y', 'Z'].map(|letter| position(letter).unwrap_or_default());
        let sign = letters.map(|index| machine.joint(index).sign);
        let zero_mm = match policy.set_up.program_zero {
            ProgramZero::Part => Vector3::zeros(),
            ProgramZero::Table => policy.set_up.part_origin.into(),
        };
        // Where no table rotates the frames are one.
        let table_rotates =
            machine.axes().iter().any(|axis| axis.kind == AxisKind::Rotary && axis.side == Side::Workpiece);
        let tcp_frame = policy.options.tip.tcp_frame.filter(|_| table_rotates);
        Self {
            meaning: LinearWords::Axes,
            mode: StretchMode::Axes,
            tcp_frame: tcp_frame.unwrap_or(TcpFrame::TableAtZero),
            posture: policy.options.tip.tool_posture,
            signs: Matrix3::from_diagonal(&Vector3::from(sign)),
            from_table: policy.set_up.program_zero == ProgramZero::Table,
            zero_mm,
            letters,
        }
    }

    /// Sets the position of the part zero from the reference point of the table.
    pub(crate) fn set_part_origin(&mut self, origin: &Vector3<f64>) {
        if self.from_table {
            self.zero_mm = *origin;
            self.set_mode(self.mode);
        }
    }

    /// Mode of the present stretch.
    pub(crate) fn mode(&self) -> StretchMode {
        self.mode
    }

    /// Sets the mode of the stretch that begins. A frame that depends on rotary angles is set when these are known.
    pub(crate) fn set_mode(&mut self, mode: StretchMode) {
        self.mode = mode;
        self.meaning = LinearWords::Axes;
        match (mode, self.tcp_frame) {
            (StretchMode::Tcp, TcpFrame::TableAtZero) => self.fix(&Matrix3::identity(), Vector3::zeros()),
            (StretchMode::Tcp, TcpFrame::NotTurning) => self.meaning = LinearWords::Turning,
            (StretchMode::Axes | StretchMode::Plane, _) | (StretchMode::Tcp, TcpFrame::TableAtStart) => {}
        }
    }

    /// Positions of X Y Z in the chain.
    pub(crate) fn letters(&self) -> [usize; 3] {
        self.letters
    }

    /// Whether the linear words are coordinates of the tip, not axis values.
    #[inline(always)]
    pub(crate) fn counts_tip(&self) -> bool {
        !matches!(self.meaning, LinearWords::Axes)
    }

    /// Whether the control rotates the tool axis in the plane of the tool axes at both ends; the rotary axes follow.
    pub(crate) fn rotates_axis_in_plane(&self) -> bool {
        self.posture == ToolPosture::Plane
    }

    /// Whether the frame depends on the rotary angles at which it is switched on.
    pub(crate) fn is_set_at_angles(&self) -> bool {
        self.mode == StretchMode::Plane || self.mode == StretchMode::Tcp && self.tcp_frame == TcpFrame::TableAtStart
    }

    fn fix(&mut self, table_rotation: &Matrix3<f64>, moved_mm: Vector3<f64>) {
        let rotation = self.signs * table_rotation;
        let shift_mm = rotation * self.zero_mm + self.signs * moved_mm;
        self.meaning = LinearWords::Fixed(WordMap { rotation, shift_mm });
    }

    /// Fixes the frame to the table at its present angles.
    pub(crate) fn start(&mut self, machine: &dyn AnyMachine, axes: &AxisValues) {
        let (rotation, moved_mm) = table(machine, axes);
        // The zero of the words on the table rotates with it, about the same centre lines.
        self.fix(&rotation, moved_mm - rotation * self.zero_mm + self.zero_mm);
    }

    /// Sets the frame to the plane of an orientation in the workpiece frame, as the control computes it from rounded
    /// angles.
    pub(crate) fn tilt(&mut self, ability: &PlaneAbility, orientation: &Matrix3<f64>) -> Option<TiltedPlane> {
        let tilt = ability.tilt(&(self.signs * orientation * self.signs))?;
        let rotation = tilt.orientation.transpose() * self.signs;
        self.meaning = LinearWords::Fixed(WordMap { rotation, shift_mm: rotation * self.zero_mm });
        Some(tilt)
    }

    /// Map to words X Y Z in the tilted plane of an orientation, and that plane; the frame of the words stays as it is.
    pub(crate) fn plane_map(
        &self,
        ability: &PlaneAbility,
        orientation: &Matrix3<f64>,
    ) -> Option<(WordMap, TiltedPlane)> {
        let mut frame = self.clone();
        let tilt = frame.tilt(ability, orientation)?;
        let LinearWords::Fixed(map) = frame.meaning else { return None };
        Some((map, tilt))
    }

    /// Map to words X Y Z in the directions of the machine, from a zero that has moved with the table.
    pub(crate) fn moved_zero_map(&self, machine: &dyn AnyMachine, axes: &AxisValues) -> WordMap {
        let rotation = self.signs * table(machine, axes).0;
        WordMap { rotation, shift_mm: rotation * self.zero_mm }
    }

    /// Sets the frame to a zero that has moved with the table, as it is at these axis values.
    pub(crate) fn move_zero(&mut self, machine: &dyn AnyMachine, axes: &AxisValues) {
        self.meaning = LinearWords::Fixed(self.moved_zero_map(machine, axes));
    }

    /// Map from the workpiece frame to the words; `None` if the words are axis values.
    #[inline(always)]
    pub(crate) fn map(&self, machine: &dyn AnyMachine, axes: &AxisValues) -> Option<WordMap> {
        match &self.meaning {
            LinearWords::Axes => None,
            LinearWords::Fixed(map) => Some(*map),
            LinearWords::Turning => Some(self.map_of_table(machine, axes)),
        }
    }

    /// Map to words in a frame that turns with the table.
    fn map_of_table(&self, machine: &dyn AnyMachine, axes: &AxisValues) -> WordMap {
        let (rotation, moved_mm) = table(machine, axes);
        WordMap { rotation: self.signs * rotation, shift_mm: self.signs * (moved_mm + self.zero_mm) }
    }

    /// Certified bound of the deviation in a block; `bound` is that of a block in which all axes move linearly. Where
    /// the control leads the tip itself, it keeps the feed as well: no speed of the tip is given.
    pub(crate) fn bound(&self, bound: MotionBound) -> MotionBound {
        match (&self.meaning, self.posture) {
            (LinearWords::Axes | LinearWords::Turning, _) => bound,
            (LinearWords::Fixed(_), ToolPosture::Axes) => {
                MotionBound { tip: 0.0, tip_rate: 0.0, tip_step: 0.0, ..bound }
            }
            (LinearWords::Fixed(_), ToolPosture::Plane) => MotionBound::default(),
        }
    }

    /// The speed of the tip in such a block alone.
    #[inline(always)]
    pub(crate) fn tip_rate(&self, tip_rate: f64) -> f64 {
        if let LinearWords::Fixed(_) = self.meaning { 0.0 } else { tip_rate }
    }
}

/// Rotation and displacement of the part by the rotary axes of the table: a point `p` of the workpiece is at
/// `rotation · p + moved_mm`, measured from the part zero with all axes at zero.
pub(crate) fn table(machine: &dyn AnyMachine, axes: &AxisValues) -> (Matrix3<f64>, Vector3<f64>) {
    let (mut rotation, mut moved_mm) = (Matrix3::identity(), Vector3::zeros());
    for (index, axis) in machine.axes().iter().enumerate() {
        if axis.kind == AxisKind::Rotary && axis.side == Side::Workpiece {
            let joint = machine.joint(index);
            let back = joint_rotation(&joint, -axes[index]);
            let centre = joint.point.coords;
            rotation = back * rotation;
            moved_mm = back * (moved_mm - centre) + centre;
        }
    }
    (rotation, moved_mm)
}

/// Orientation of the tool in the workpiece frame from all rotary axes together.
pub(crate) fn orientation(machine: &dyn AnyMachine, axes: &AxisValues) -> Matrix3<f64> {
    let rotaries = machine.axes().iter().enumerate().filter(|(_, axis)| axis.kind == AxisKind::Rotary);
    rotaries
        .fold(Matrix3::identity(), |product, (index, _)| product * joint_rotation(&machine.joint(index), axes[index]))
}

fn joint_rotation(joint: &crate::kinematics::Joint, angle_rad: f64) -> Matrix3<f64> {
    nalgebra::Rotation3::from_axis_angle(&joint.direction, joint.sign * angle_rad).into_inner()
}

/// The fault that the angles of a tilted plane do not give its orientation.
pub(crate) fn no_plane() -> Fault {
    plan::INTERNAL
        .fault("the angles of the tilted plane do not give the orientation of the tool")
        .help("this is a fault of the postprocessor, not of the CL data: use mode axes")
}
