//! Where the part of one set-up is in another one.
//!
//! Points of the part are `p' = R p` where it lies on the table, with `p` in the coordinates of the CL data and `R` the
//! `part_rotation` of the set-up. With `F` the frames that the CL data states in the model, `p₁ = F₁⁻¹ Fₙ pₙ`.

use std::collections::BTreeMap;

use nalgebra::{Isometry3, Matrix3, Rotation3, Translation3, UnitQuaternion, Vector3};

use crate::set_up::SetUp;
use crate::simulate::bodies::Mesh;
use crate::simulate::removal::{StockFault, TriDexel};
use crate::view::ClFacts;

/// Largest difference of a rotation from quarter turns.
const QUARTER: f64 = 1e-9;

/// Places of the part in all set-ups.
#[derive(Debug, Clone, Default)]
pub(crate) struct PartPlaces {
    /// From the part as it lies in a set-up to the coordinates of the CL data of the first one.
    to_first: BTreeMap<u32, Isometry3<f64>>,
    /// Sentences about what is assumed.
    pub(crate) assumed: Vec<String>,
    /// Set-ups of which it is not known.
    pub(crate) unknown: Vec<u32>,
}

fn rotation(rotation: &Rotation3<f64>) -> Isometry3<f64> {
    Isometry3::from_parts(Translation3::identity(), UnitQuaternion::from_rotation_matrix(rotation))
}

/// A frame of the CL data: from its coordinates to the model.
fn frame(origin: [f64; 3], axes: [[f64; 3]; 3]) -> Isometry3<f64> {
    let matrix = Matrix3::from_columns(&axes.map(Vector3::from));
    let rotation =
        UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_eps(&matrix, 1e-15, 100, Rotation3::identity()));
    Isometry3::from_parts(Translation3::from(Vector3::from(origin)), rotation)
}

impl PartPlaces {
    /// The places in the set-ups of a job.
    pub(crate) fn of(set_up: &SetUp, facts: &ClFacts) -> Self {
        let mut places = Self::default();
        let frames = &facts.set_up_frames;
        for (number, clamping) in set_up.clampings() {
            let given = set_up.set_ups.get(&number).and_then(|further| {
                let at = further.cl_origin?;
                Some(Translation3::from(Vector3::from(at)) * rotation(&further.cl_rotation))
            });
            let stated = || {
                let [first, this] = [1, number].map(|number| frames.get(&number));
                let [first, this] = [first?, this?].map(|stated| frame(stated.0, stated.1));
                Some(first.inverse() * this)
            };
            let to_first = match given.or_else(|| (number == 1).then(Isometry3::identity)).or_else(stated) {
                Some(known) => known,
                None if facts.different_frames <= 1 => {
                    places.assumed.push(format!(
                        "the CL data of set-up {number} is in the coordinates of the first one (it states no frame of its own)"
                    ));
                    Isometry3::identity()
                }
                None => {
                    places.unknown.push(number);
                    continue;
                }
            };
            places.to_first.insert(number, to_first * rotation(&clamping.part_rotation).inverse());
        }
        places
    }

    /// From the part as it lies in one set-up to that in another one; `None`: not known.
    pub(crate) fn between(&self, from: u32, to: u32) -> Option<Isometry3<f64>> {
        let [from, to] = [from, to].map(|number| self.to_first.get(&number));
        Some(to?.inverse() * from?)
    }

    /// The part cannot be where a set-up has it: not known from here on.
    pub(super) fn forget(&mut self, set_up: u32) {
        self.to_first.remove(&set_up);
    }
}

/// A stock moved. By quarter turns about the axes its lines stay lines; otherwise it is made anew of its surface, with
/// an error of a part of the pitch at edges, and without the names of the pieces that cut it.
///
/// # Errors
/// [`StockFault`]: nothing is left of it.
pub(super) fn moved(stock: &TriDexel, place: &Isometry3<f64>) -> Result<TriDexel, StockFault> {
    let matrix = place.rotation.to_rotation_matrix().into_inner();
    let whole = matrix.map(f64::round);
    if (matrix - whole).abs().max() < QUARTER {
        let from = [0, 1, 2].map(|axis| (0..3).find(|other| whole[(axis, *other)].abs() > 0.5).unwrap_or(axis));
        let signs = [0, 1, 2].map(|axis| whole[(axis, from[axis])]);
        return Ok(stock.turned(from, signs, place.translation.vector.into()));
    }
    let pitch = stock.pitch().into_iter().fold(f64::INFINITY, f64::min);
    let (vertices, faces) = stock.surface();
    let mesh = Mesh::new(vertices, faces).map_err(|fault| StockFault::new(format!("the machined stock: {fault}")))?;
    Ok(mesh.placed(place).stock(pitch)?.unnamed())
}
