//! Designs of the parts as triangles: the surfaces that their tools touch.
//!
//! Lengths are in mm, in the coordinates of the CL data. A design is a closed body: [`TOLERANCE_MM`] is the largest
//! distance of its triangles from the surface. `cargo run -p examples --bin generate_designs` writes the STL files.

use core::f64::consts::TAU;
use std::io::{self, Write};

use crate::parts::{GROOVE_TURNS, GrooveShape, Surface};

/// Largest distance of the triangles from the surface.
pub const TOLERANCE_MM: f64 = 0.02;

/// Ends of the bar of the groove along X: the tool begins and ends beside it.
pub const BAR_MM: [f64; 2] = [8.0, 72.0];

/// Material on a blank that has the form of its design.
pub const BLANK_MM: f64 = 1.0;

/// A closed body of triangles, counter-clockwise from outside.
#[derive(Debug, Clone, Default)]
pub struct Solid {
    /// Corners.
    pub vertices: Vec<[f64; 3]>,
    /// Triangles, as numbers of corners.
    pub faces: Vec<[u32; 3]>,
}

impl Solid {
    /// Writes a binary STL file.
    ///
    /// # Errors
    /// Errors of the output.
    pub fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        let mut bytes = vec![b' '; 80];
        bytes.extend((self.faces.len() as u32).to_le_bytes());
        for face in &self.faces {
            // Readers compute the normals.
            bytes.extend([0_u8; 12]);
            for corner in face.map(|index| self.vertices[index as usize]) {
                bytes.extend(corner.iter().flat_map(|value| (*value as f32).to_le_bytes()));
            }
            bytes.extend([0_u8; 2]);
        }
        out.write_all(&bytes)
    }

    fn quad(&mut self, [a, b, c, d]: [u32; 4]) {
        // At the ends of a bar some corners are one.
        let halves = [[a, b, c], [a, c, d]];
        self.faces.extend(halves.into_iter().filter(|[a, b, c]| a != b && b != c && c != a));
    }
}

/// Number of chords of a length on a circle so that they are within a distance of it.
fn chords(length: f64, radius: f64, distance: f64) -> usize {
    (length / (8.0 * radius * distance).sqrt()).ceil().max(1.0) as usize
}

/// A block with a free-form surface on top, raised by a distance, between `-half` and `half` of the surface, down to
/// `floor`.
#[must_use]
pub fn under_surface(surface: &Surface, raised: f64, floor: f64) -> Solid {
    let half = surface.half_mm;
    // A cell has half the tolerance along each axis.
    let counts: [usize; 2] =
        core::array::from_fn(|axis| chords(2.0 * half[axis], surface.radii_mm[axis], 0.5 * TOLERANCE_MM));
    let [nx, ny] = counts;
    let mut solid = Solid::default();
    let at = |i: usize, count: usize, half: f64| half * (2.0 * i as f64 / count as f64 - 1.0);
    for level in 0..2 {
        for j in 0..=ny {
            for i in 0..=nx {
                let (x, y) = (at(i, nx, half[0]), at(j, ny, half[1]));
                solid.vertices.push([x, y, if level == 0 { surface.height(x, y) + raised } else { floor }]);
            }
        }
    }
    let node = |i: usize, j: usize, level: usize| (level * (nx + 1) * (ny + 1) + j * (nx + 1) + i) as u32;
    for j in 0..ny {
        for i in 0..nx {
            solid.quad([node(i, j, 0), node(i + 1, j, 0), node(i + 1, j + 1, 0), node(i, j + 1, 0)]);
            solid.quad([node(i, j, 1), node(i, j + 1, 1), node(i + 1, j + 1, 1), node(i + 1, j, 1)]);
        }
    }
    for i in 0..nx {
        solid.quad([node(i, 0, 1), node(i + 1, 0, 1), node(i + 1, 0, 0), node(i, 0, 0)]);
        solid.quad([node(i + 1, ny, 1), node(i, ny, 1), node(i, ny, 0), node(i + 1, ny, 0)]);
    }
    for j in 0..ny {
        solid.quad([node(0, j + 1, 1), node(0, j, 1), node(0, j, 0), node(0, j + 1, 0)]);
        solid.quad([node(nx, j, 1), node(nx, j + 1, 1), node(nx, j + 1, 0), node(nx, j, 0)]);
    }
    solid
}

/// Radius of the bar at a place along X and an angle from Z towards Y: what the ball of the groove leaves.
#[must_use]
pub fn groove_radius(shape: &GrooveShape, x: f64, angle: f64) -> f64 {
    let last = TAU * f64::from(GROOVE_TURNS);
    let centre = shape.bottom_mm + shape.ball_mm;
    // Smallest square of the distance of the point at a radius from the path of the centre.
    let distance = |radius: f64| {
        let (sine, cosine) = angle.sin_cos();
        let point = [x, radius * sine, radius * cosine];
        let square = |turn: f64| {
            let (sine, cosine) = turn.sin_cos();
            let at = [shape.pitch_mm * turn / TAU, centre * sine, centre * cosine];
            (0..3).map(|axis| (point[axis] - at[axis]).powi(2)).sum::<f64>()
        };
        let near = (x / shape.pitch_mm - angle / TAU).round();
        let turns = [-1.0, 0.0, 1.0].map(|by| (angle + TAU * (near + by)).clamp(0.0, last));
        let least = turns.into_iter().map(|start| {
            let (mut from, mut to) = ((start - 0.3).max(0.0), (start + 0.3).min(last));
            for _ in 0..30 {
                let third = (to - from) / 3.0;
                if square(from + third) < square(to - third) { to -= third } else { from += third }
            }
            square(0.5 * (from + to))
        });
        least.fold(f64::INFINITY, f64::min).sqrt()
    };
    if distance(shape.bar_mm) >= shape.ball_mm {
        return shape.bar_mm;
    }
    let (mut inside, mut outside) = (shape.bottom_mm - 1.0, shape.bar_mm);
    for _ in 0..24 {
        let middle = 0.5 * (inside + outside);
        if distance(middle) >= shape.ball_mm { inside = middle } else { outside = middle }
    }
    inside
}

/// The bar with its groove: rings of corners that follow the groove, so that its crests are edges.
#[must_use]
pub fn grooved_bar(shape: &GrooveShape) -> Solid {
    const AROUND: usize = 60;
    const ACROSS: usize = 8;
    let step = shape.pitch_mm / ACROSS as f64;
    let [low, high] = BAR_MM;
    // Corners of a line along the bar; the next line is shifted by a part of the pitch.
    let before = ((1.5 * shape.pitch_mm - low) / step).ceil();
    let along = (before + high / step).ceil() as usize;
    let mut solid = Solid::default();
    for i in 0..AROUND {
        let angle = TAU * i as f64 / AROUND as f64;
        let shift = shape.pitch_mm * i as f64 / AROUND as f64;
        for j in 0..=along {
            let x = ((j as f64 - before) * step + 0.5 * shape.pitch_mm + shift).clamp(low, high);
            let radius = groove_radius(shape, x, angle);
            solid.vertices.push([x, radius * angle.sin(), radius * angle.cos()]);
        }
    }
    // After one revolution a line is that of the first one, a pitch further.
    let node = |i: usize, j: usize| {
        let (i, j) = if i == AROUND { (0, j + ACROSS) } else { (i, j) };
        (i * (along + 1) + j.min(along)) as u32
    };
    for i in 0..AROUND {
        for j in 0..along {
            solid.quad([node(i, j), node(i, j + 1), node(i + 1, j + 1), node(i + 1, j)]);
        }
    }
    // The ends: corners there lie on one plane.
    for (x, first) in [(low, true), (high, false)] {
        let centre = solid.vertices.len() as u32;
        solid.vertices.push([x, 0.0, 0.0]);
        let rim = |i: usize| if first { node(i, 0) } else { node(i, along) };
        for i in 0..AROUND {
            let (a, b) = (rim(i), rim(i + 1));
            solid.faces.push(if first { [centre, a, b] } else { [centre, b, a] });
        }
        if first {
            // From the last line back to the first one, along the end.
            for j in 0..ACROSS {
                solid.faces.push([centre, node(0, j + 1), node(0, j)]);
            }
        }
    }
    solid
}

/// Every design, and a blank: the name of the file, and the body.
#[must_use]
pub fn designs() -> Vec<(&'static str, Solid)> {
    vec![
        ("convex.stl", under_surface(&Surface::CONVEX, 0.0, -40.0)),
        ("concave.stl", under_surface(&Surface::CONCAVE, 0.0, -15.0)),
        ("concave_blank.stl", under_surface(&Surface::CONCAVE, BLANK_MM, -15.0)),
        ("trough.stl", under_surface(&Surface::TROUGH, 0.0, -15.0)),
        ("groove.stl", grooved_bar(&GrooveShape::SPIRAL)),
    ]
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::*;

    fn volume(solid: &Solid) -> f64 {
        let six = solid.faces.iter().map(|face| {
            let [a, b, c] = face.map(|index| solid.vertices[index as usize]);
            a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])
        });
        six.sum::<f64>() / 6.0
    }

    #[test]
    fn designs_are_closed_bodies_of_their_volume() {
        let block = |surface: &Surface, raised: f64, floor: f64| {
            let [a, b] = surface.half_mm;
            let [rx, ry] = surface.radii_mm;
            4.0 * a * b * (surface.bend * (a * a / (6.0 * rx) + b * b / (6.0 * ry)) + raised - floor)
        };
        // A bar that is cut to the mean of its groove.
        let shape = GrooveShape::SPIRAL;
        let mean: f64 =
            (0..400).map(|step| groove_radius(&shape, 40.0 + 4.0 * f64::from(step) / 400.0, 0.0).powi(2)).sum();
        let bar = core::f64::consts::PI * (BAR_MM[1] - BAR_MM[0]) * mean / 400.0;
        let wanted = [
            block(&Surface::CONVEX, 0.0, -40.0),
            block(&Surface::CONCAVE, 0.0, -15.0),
            block(&Surface::CONCAVE, BLANK_MM, -15.0),
            block(&Surface::TROUGH, 0.0, -15.0),
            bar,
        ];
        for ((name, solid), wanted) in designs().into_iter().zip(wanted) {
            let mut edges: BTreeMap<[u32; 2], i32> = BTreeMap::new();
            for [a, b, c] in &solid.faces {
                for [from, to] in [[*a, *b], [*b, *c], [*c, *a]] {
                    *edges.entry([from.min(to), from.max(to)]).or_default() += if from < to { 1 } else { -1 };
                }
            }
            assert!(edges.values().all(|count| *count == 0), "{name} is open");
            let found = volume(&solid);
            assert!((found - wanted).abs() < 5e-3 * wanted, "{name}: {found} {wanted}");
            assert!(solid.faces.len() < 30_000, "{name}: {} triangles", solid.faces.len());
        }
    }

    #[test]
    fn the_groove_has_its_depth_and_its_crests() {
        let shape = GrooveShape::SPIRAL;
        // In the middle of the groove, and between two turns: a circle of 4 mm about a radius of 27 mm.
        assert!((groove_radius(&shape, 41.0, TAU / 4.0) - 23.0).abs() < 1e-4);
        let crest = groove_radius(&shape, 43.0, TAU / 4.0);
        assert!((crest - (27.0 - 12.0_f64.sqrt())).abs() < 5e-3, "{crest}");
        assert!((groove_radius(&shape, -8.0, 1.0) - 25.0).abs() < 1e-12);
    }
}
