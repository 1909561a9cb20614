//! A short name for the kinematics in force, by which a program is traced to the post that wrote it.

use std::fmt::Write as _;

use nalgebra::Vector3;
use sha2::{Digest as _, Sha256};

use super::AnyMachine;

/// Bytes of the digest that are printed.
const PRINTED: usize = 8;

/// Digest of a machine: its axes and the formulas as declared, its joints for the dimensions in force, and the version
/// of this crate; sixteen hexadecimal digits.
///
/// Two posts with the same digest have the same kinematics. Name, part origin and gauge length have no influence. It
/// traces programs; it is no protection against intent.
#[must_use]
pub(crate) fn digest(machine: &dyn AnyMachine) -> String {
    let printed = Sha256::digest(canonical(machine));
    printed.iter().take(PRINTED).fold(String::new(), |mut text, byte| {
        // Writing to a string cannot fail.
        let _ = write!(text, "{byte:02x}");
        text
    })
}

/// The machine as text; numbers with as many digits as tell them apart.
fn canonical(machine: &dyn AnyMachine) -> String {
    let mut machine = machine.to_boxed();
    machine.set_up(Vector3::zeros(), 0.0);
    let mut text = format!("pp-runtime {}\n", env!("CARGO_PKG_VERSION"));
    for (index, (axis, held)) in machine.axes().iter().zip(machine.held()).enumerate() {
        let joint = machine.joint(index);
        let [direction, point] = [joint.direction.into_inner(), joint.point.coords].map(components);
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{axis:?} at {:?}: {direction:?} {point:?}", held + 0.0);
    }
    let _ = writeln!(text, "tool axis {:?}", components(machine.tool_axis().into_inner()));
    text + machine.c_source().text
}

/// Components of a vector; negative zero is zero.
fn components(vector: Vector3<f64>) -> [f64; 3] {
    vector.add_scalar(0.0).into()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kinematics::Machine;

    /// A trunnion in a module of its own, with one part that differs.
    macro_rules! trunnion {
        ($module:ident, $name:ident, $($differs:tt)*) => {
            mod $module {
                crate::machine! {
                    pub(super) struct $name;
                    chain: C A | X Y Z;
                    dims = { d: 50 };
                    d = { C: (0, d, 0) };
                    $($differs)*
                }
            }
        };
    }

    trunnion!(declared, Trunnion, limits = { A: -30..110 };);
    trunnion!(renamed, Same, limits = { A: -30..110 };);
    trunnion!(reversed, Trunnion, limits = { A: -30..110 }; signs = { C: - };);
    trunnion!(longer, Trunnion, limits = { A: -30..120 };);

    #[test]
    fn each_part_of_the_kinematics_changes_the_digest_and_nothing_else_does() {
        let machine = declared::Trunnion::default();
        let printed = digest(&machine);
        assert_eq!(printed.len(), 2 * PRINTED);
        assert_eq!(printed, digest(&renamed::Same::default()), "the name");
        let mut placed = machine.clone();
        Machine::set_up(&mut placed, Vector3::new(1.0, 2.0, 3.0), 150.0);
        assert_eq!(printed, digest(&placed), "part origin and gauge length");

        let others = [
            digest(&declared::Trunnion { d: 50.000_1, ..machine }),
            digest(&reversed::Trunnion::default()),
            digest(&longer::Trunnion::default()),
        ];
        for other in others {
            assert_ne!(printed, other);
        }
    }
}
