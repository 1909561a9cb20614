//! Bodies of triangles: files, shapes of the configuration, and the lines of a stock that are inside.

mod centre_line;
mod mesh;
mod shapes;
mod solid;
#[cfg(test)]
mod tests;

pub(crate) use centre_line::CentreLine;
pub(crate) use mesh::Mesh;
#[cfg(test)]
pub(crate) use shapes::block;
pub(crate) use shapes::{CHORD_MM, chord_of, turned};
pub(crate) use solid::{OpenFile, SolidBody, SolidFault};
