//! Bodies of triangles: files, and the lines of a stock that are inside.

mod mesh;
#[cfg(test)]
mod tests;

pub use mesh::{Mesh, MeshFault};
