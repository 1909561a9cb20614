//! Conventions of the controls, written out: pose of the tool for the words of a mode.

use nalgebra::{Matrix3, Point3, Vector3, Vector4};
use pp_runtime::config::{Config, Mode, TcpFrame};
use pp_runtime::kinematics::{AxisKind, Machine, Side};
use tests::oracle::{Oracle, rotation, rotation_about};

use super::listener::ProgramState;

/// Rotation about a coordinate direction.
pub(crate) fn about(axis: usize, degrees: f64) -> Matrix3<f64> {
    rotation(&[Vector3::x(), Vector3::y(), Vector3::z()][axis], degrees.to_radians())
        .fixed_view::<3, 3>(0, 0)
        .into_owned()
}

/// Orientation of a tilted plane from its angles, as in the manual of each control.
///
/// Fanuc, B-63784EN "tilted working plane command": Euler angles I about Z, J about the new X, K about the new Z.
/// Siemens, CYCLE800 mode 57: about X, the new Y, the new Z. Heidenhain, PLANE SPATIAL: about the fixed X, then Y, then
/// Z.
pub(crate) fn orientation(control: &str, [a, b, c]: [f64; 3]) -> Matrix3<f64> {
    match control {
        "fanuc" => about(2, a) * about(0, b) * about(2, c),
        "siemens" => about(0, a) * about(1, b) * about(2, c),
        _ => about(2, c) * about(1, b) * about(0, a),
    }
}

/// Signs of the words X Y Z.
pub(crate) fn signs<M: Machine>(machine: &M) -> Matrix3<f64> {
    let index = |letter: char| M::AXES.iter().position(|axis| axis.letter == letter).expect("an axis of this letter");
    Matrix3::from_diagonal(&Vector3::from(['X', 'Y', 'Z'].map(|letter| machine.joint(index(letter)).sign)))
}

pub(crate) fn linear_words<M: Machine>(words: &[f64; 9]) -> Vector3<f64> {
    let word = |letter: char| words[M::AXES.iter().position(|axis| axis.letter == letter).expect("an axis")];
    Vector3::new(word('X'), word('Y'), word('Z'))
}

pub(crate) fn axis_values<M: Machine>(words: &[f64; 9]) -> Vec<f64> {
    let value = |(index, axis): (usize, &pp_runtime::kinematics::Axis)| match axis.kind {
        AxisKind::Linear => words[index],
        AxisKind::Rotary => words[index].to_radians(),
    };
    M::AXES.iter().enumerate().map(value).collect()
}

/// Point of the workpiece that is at `at` in the machine with the table rotated as in `words`; workpiece frame, mm.
pub(crate) fn on_table<M: Machine>(machine: &M, at: &Vector3<f64>, words: &[f64; 9]) -> Point3<f64> {
    let mut point = Vector4::new(at.x, at.y, at.z, 1.0);
    for (index, axis) in M::AXES.iter().enumerate().rev() {
        if axis.kind == AxisKind::Rotary && axis.side == Side::Workpiece {
            let joint = machine.joint(index);
            let angle = joint.sign * words[index].to_radians();
            point = rotation_about(&joint.point.coords, &joint.direction, angle) * point;
        }
    }
    Point3::new(point.x, point.y, point.z)
}

/// Tip and tool axis that the words of a mode command, in the workpiece frame.
pub(crate) fn commanded_pose<M: Machine>(
    machine: &M,
    config: &Config,
    control: &str,
    state: &ProgramState,
) -> (Point3<f64>, Vector3<f64>) {
    let oracle = Oracle::of(machine);
    let words = signs(machine).transpose() * linear_words::<M>(&state.words);
    let axis = oracle.forward(&axis_values::<M>(&state.words)).axis.into_inner();
    match config.motion.mode {
        Mode::Auto => panic!("the mode of a stretch is needed"),
        Mode::Axes => (oracle.forward(&axis_values::<M>(&state.words)).tip, axis),
        Mode::Tcp => {
            let start = state.start.expect("under tip control");
            let tip = match config.motion.tip.tcp_frame.unwrap_or(TcpFrame::TableAtZero) {
                TcpFrame::TableAtZero => Point3::from(words),
                TcpFrame::TableAtStart => on_table(machine, &words, &start),
                TcpFrame::NotTurning => on_table(machine, &words, &state.words),
            };
            let Some(vector) = state.vector else { return (tip, axis) };
            let vector = signs(machine).transpose() * Vector3::from(vector);
            let axis = match config.motion.tip.tcp_frame {
                Some(TcpFrame::TableAtStart) => {
                    on_table(machine, &vector, &start) - on_table(machine, &Vector3::zeros(), &start)
                }
                _ => vector,
            };
            (tip, axis)
        }
        // Haas, page of G254: along the axes of the machine, from a zero that has moved with the table.
        Mode::Plane if state.moved_zero => {
            let tip = on_table(machine, &words, &state.words) - on_table(machine, &Vector3::zeros(), &state.words);
            (Point3::from(tip), axis)
        }
        Mode::Plane => {
            let (signs, plane) = (signs(machine), orientation(control, state.plane.expect("a plane")));
            let tip = signs * plane * linear_words::<M>(&state.words);
            (Point3::from(tip), signs * plane.column(2))
        }
    }
}
