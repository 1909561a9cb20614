//! Solids of the configuration as triangles where they are.

use std::fs::File;
use std::io;

use nalgebra::{Isometry3, Translation3};

use super::centre_line::CentreLine;
use super::mesh::{Mesh, MeshFault};
use super::shapes::{self, Triangles, chord_of};
use crate::set_up::{Solid, SolidShape};

/// A solid as triangles.
#[derive(Debug, Clone)]
pub(crate) struct SolidBody {
    pub(crate) mesh: Mesh,
    /// Largest distance of the real surface from the triangles, mm.
    pub(crate) tolerance_mm: f64,
    /// Its axis, if it is a body of revolution.
    pub(crate) axis: Option<CentreLine>,
    /// Fault of the file that does not prevent its use: it is open, or inside out.
    pub(crate) flaw: Option<String>,
}

/// The reason why a solid cannot be used.
#[derive(Debug, thiserror::Error)]
pub(crate) enum SolidFault {
    /// Its file cannot be read.
    #[error("cannot read {0}: {1}")]
    Unreadable(String, #[source] io::Error),
    /// Its file is no body.
    #[error("{0} is no solid: {1}")]
    NoBody(String, #[source] MeshFault),
}

/// Opens the file of a name.
pub(crate) type OpenFile<'a> = &'a dyn Fn(&str) -> io::Result<File>;

impl SolidBody {
    /// The triangles of a solid; `open` opens its file. `chord_mm`: largest distance of round surfaces from their
    /// triangles.
    ///
    /// # Errors
    /// [`SolidFault`].
    pub(crate) fn of(solid: &Solid, chord_mm: f64, open: OpenFile<'_>) -> Result<Self, SolidFault> {
        let (mesh, shape_mm, flaw) = match &solid.shape {
            SolidShape::Stl { file, unit_mm } => {
                let mut input = open(file).map_err(|error| SolidFault::Unreadable(file.clone(), error))?;
                let mesh = Mesh::read_surface(&mut input).map_err(|fault| SolidFault::NoBody(file.clone(), fault))?;
                let flaw = mesh.flaw();
                (mesh.scaled(*unit_mm), 0.0, flaw)
            }
            SolidShape::Box(corners) => (surface(shapes::block(*corners)), 0.0, None),
            SolidShape::Cylinder { diameter, height } => {
                let radius = diameter / 2.0;
                turned(&[[0.0, 0.0], [radius, 0.0], [radius, *height], [0.0, *height]], chord_mm)
            }
            SolidShape::Turned(corners) => {
                let outline: Vec<[f64; 2]> =
                    corners.iter().map(|[diameter, height]| [diameter / 2.0, *height]).collect();
                turned(&outline, chord_mm)
            }
        };
        let axis = match &solid.shape {
            SolidShape::Cylinder { .. } | SolidShape::Turned(_) => {
                let place = Isometry3::from_parts(Translation3::from(solid.at_mm), solid.rotation.into());
                Some(CentreLine::z().placed(&place))
            }
            SolidShape::Stl { .. } | SolidShape::Box(_) => None,
        };
        let mesh = mesh.moved(|point| solid.placed(point));
        Ok(Self { mesh, tolerance_mm: shape_mm + solid.tolerance_mm, axis, flaw })
    }
}

fn surface((vertices, faces): Triangles) -> Mesh {
    Mesh::of_checked(vertices, faces)
}

fn turned(outline: &[[f64; 2]], chord_mm: f64) -> (Mesh, f64, Option<String>) {
    let largest = outline.iter().fold(0.0_f64, |largest, corner| largest.max(corner[0]));
    (surface(shapes::turned(outline, chord_mm)), chord_of(largest, chord_mm), None)
}
