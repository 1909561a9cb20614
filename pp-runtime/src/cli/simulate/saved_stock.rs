//! `--save-stock`: the machined stock as the stock of the next program.

use std::io::{self, BufWriter, Write as _};
use std::path::Path;

use crate::set_up::SetUp;
use crate::simulate::{Mesh, TriDexel, TriangleSurface};

use super::super::outcome::Failure;
use super::super::output_file::OutputFile;

/// Writes the stock, in the coordinates of the CL data of the set-up in which it lies; returns a sentence about the
/// file.
pub(super) fn save(set_up: &SetUp, number: u32, stock: &TriDexel, path: &Path) -> Result<String, Failure> {
    let unwritable = |error| Failure::unwritable(path, error);
    let (vertices, faces) = stock.surface();
    let mesh = Mesh::new(vertices, faces).map_err(|fault| {
        Failure::unwritable(path, io::Error::other(format!("the machined stock is no body: {fault}")))
    })?;
    let farthest_mm = farthest(&mesh, stock);
    let triangles = mesh.triangles();
    let mut target = OutputFile::create(path).map_err(unwritable)?;
    let mut out = BufWriter::new(target.writer());
    let rotation = set_up.clamping(number).map_or(set_up.part_rotation, |part| part.part_rotation);
    mesh.rotated(&rotation.inverse()).write(&mut out).map_err(unwritable)?;
    out.flush().map_err(unwritable)?;
    drop(out);
    target.finish(|_| false).map_err(unwritable)?;
    Ok(format!(
        "machined stock: {}, {triangles} triangles, mm in the coordinates of the CL data; within {farthest_mm:.3} mm of the \
         ends of its lines, walls thinner than the pitch left out",
        path.display()
    ))
}

/// Largest distance of an end of the stock from its surface, mm. Parts thinner than the pitch are left out.
fn farthest(mesh: &Mesh, stock: &TriDexel) -> f64 {
    let surface = TriangleSurface::new(mesh.corners_of_triangles());
    let mut farthest: f64 = 0.0;
    for (family, pitch) in stock.pitch().into_iter().enumerate() {
        stock.each(family, |across, spans| {
            for span in spans.iter().filter(|span| f64::from(span.high - span.low) > pitch) {
                for end in [span.low, span.high] {
                    let mut place = [0.0; 3];
                    (place[family], place[(family + 1) % 3], place[(family + 2) % 3]) =
                        (f64::from(end), across[0], across[1]);
                    farthest = farthest.max(surface.distance(place, f64::INFINITY));
                }
            }
        });
    }
    farthest
}
