//! Compare sheets: their numbers, put into the model that the manuals of each control describe, give the positions of
//! the machine's own matrices; the worked examples of the manuals; refusals; and the sheets of the papers' machines,
//! line by line.
//!
//! The sheets are read as they are printed. The models here are written from the manuals and share no code with the
//! sheets.
//!
//! `PP_BLESS=1 cargo test --workspace --test kinematics compare_sheets::` rewrites the sheets in tests/data/kinematics;
//! read every changed line before it is committed.

mod chains;
mod examples;
mod fanuc;
mod golden;
mod haas;
mod heidenhain;
mod linuxcnc;
mod printed;
mod refusals;
mod siemens;

use nalgebra::{Point3, Vector3};
use pp_runtime::config::{Config, starting_point};
use pp_runtime::kinematics::{AxisKind, DimensionKind, Machine};
use pp_runtime::nalgebra;
use pp_runtime::transformation::{NotExpressible, SheetControl, compare_sheet};
use tests::by_name;
use tests::oracle::Oracle;
use tests::random::Random;

use printed::Printed;

/// Deviation allowed by unit vectors of seven decimals and lengths of four, mm, at the distances of these tests.
const ROUNDING: f64 = 0.001;

/// A set-up file for a control.
fn config<M: Machine>(control: SheetControl, keys: &str) -> Config {
    let control = by_name::control(control.name());
    starting_point(control).read_over(&M::default(), keys).unwrap_or_else(|faults| panic!("{faults:?}"))
}

/// The sheet of a machine in the set-up of a file.
fn sheet<M: Machine>(control: SheetControl, keys: &str) -> Result<String, NotExpressible> {
    let config = config::<M>(control, keys);
    let machine: M = config.set_up.machine().expect("a valid set-up");
    compare_sheet(&machine, &config, control)
}

/// The reason for which a sheet is refused.
fn refusal<M: Machine>(control: SheetControl) -> String {
    match sheet::<M>(control, "") {
        Ok(text) => panic!("{}: not refused:\n{text}", M::NAME),
        Err(reason) => reason.to_string(),
    }
}

/// One position of a machine, as a control has it.
struct Position {
    /// Values of the solved rotary axes by letter, rad.
    angles: Vec<(char, f64)>,
    /// The tip in machine coordinates of the zero position: work offset plus words under tip control.
    point: Vector3<f64>,
    /// From the tip to the gauge line.
    length: Vector3<f64>,
    /// Machine coordinates of X, Y and Z, by the matrices of the declaration.
    machine: Vector3<f64>,
}

impl Position {
    fn angle(&self, letter: char) -> f64 {
        self.angles.iter().find(|(name, _)| *name == letter).map_or(0.0, |(_, angle)| *angle)
    }
}

/// Compares the machine coordinates of a model with those of the declaration in random set-ups and positions.
///
/// `model` gets the printed sheet and a position.
fn agrees<M: Machine>(control: SheetControl, model: impl Fn(&Printed, &Position) -> Vector3<f64>) {
    let mut random = Random::new(M::NAME.len() as u64 + 7);
    for _ in 0..20 {
        // Quarters of a millimetre are printed without rounding.
        let mut quarter = |lowest: f64, highest: f64| (random.between(lowest, highest) * 4.0).round() / 4.0;
        let (origin, zero) = ([0; 3].map(|_| quarter(-200.0, 200.0)), [0; 3].map(|_| quarter(-900.0, 100.0)));
        let mut keys = format!(
            "units = \"mm\"\npart_origin = {origin:?}\nmachine_zero = {{ X = {:?}, Y = {:?}, Z = {:?} }}\n",
            zero[0], zero[1], zero[2]
        );
        let lengths = M::DIMENSIONS.iter().filter(|dimension| dimension.kind == DimensionKind::Length);
        let lengths: String =
            lengths.map(|dimension| format!("{} = {:?}\n", dimension.name, quarter(-250.0, 250.0))).collect();
        keys.push_str(&format!("[dimensions]\n{lengths}"));
        let text = sheet::<M>(control, &keys).unwrap_or_else(|reason| panic!("{}: {reason}", M::NAME));
        let printed = Printed::read(&text);
        let config = config::<M>(control, &keys);
        let mut machine: M = config.set_up.machine().expect("a valid set-up");
        for _ in 0..50 {
            let gauge = random.between(0.0, 300.0);
            machine.set_up(Vector3::from(origin), gauge);
            let oracle = Oracle::of(&machine);
            let mut values: Vec<f64> = M::HELD.as_ref().to_vec();
            for index in oracle.rotary() {
                values[index] = random.between(-3.1, 3.1);
            }
            let tip = Point3::from(Vector3::from_fn(|_, _| random.between(-300.0, 300.0)));
            oracle.bring_tip_to(&tip, &mut values);
            let length = machine.tool_axis().into_inner() * gauge;
            let linear = Vector3::from(["X", "Y", "Z"].map(|letter| {
                let place = M::AXES.iter().position(|axis| letter.starts_with(axis.letter)).expect("X, Y and Z");
                values[place]
            }));
            let rotary = M::AXES.iter().enumerate().filter(|(_, axis)| axis.kind == AxisKind::Rotary && !axis.held);
            let position = Position {
                angles: rotary.map(|(index, axis)| (axis.letter, values[index])).collect(),
                point: Vector3::from(zero) + tip.coords,
                length,
                machine: Vector3::from(zero) + linear + length,
            };
            let found = model(&printed, &position);
            let off = (found - position.machine).norm();
            assert!(
                off <= ROUNDING,
                "{}: {off} mm between the model, {found:?}, and the declaration, {:?}; {:?}\n{keys}\n{text}",
                M::NAME,
                position.machine,
                position.angles
            );
        }
    }
}

/// Right-handed rotation of a vector about a direction of any length; a direction of zero does not rotate.
fn rotated(direction: &Vector3<f64>, angle: f64, vector: &Vector3<f64>) -> Vector3<f64> {
    match direction.try_normalize(1e-9) {
        Some(unit) => (tests::oracle::rotation(&unit, angle) * vector.push(0.0)).xyz(),
        None => *vector,
    }
}
