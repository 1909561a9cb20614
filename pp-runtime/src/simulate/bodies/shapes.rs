//! Boxes, cylinders and turned outlines as triangles.

use std::f64::consts::{PI, TAU};

/// Largest distance of the triangles of a round surface from it, mm.
pub(crate) const CHORD_MM: f64 = 0.02;

/// Smallest and largest number of sides of a round surface.
const SIDES: [f64; 2] = [12.0, 720.0];

/// Vertices and faces, counter-clockwise from outside.
pub(crate) type Triangles = (Vec<[f64; 3]>, Vec<[u32; 3]>);

/// A box.
pub(crate) fn block([low, high]: [[f64; 3]; 2]) -> Triangles {
    let vertices = (0..8_usize).map(|corner| std::array::from_fn(|axis| [low, high][corner >> axis & 1][axis]));
    let ends = [[0, 2, 3], [0, 3, 1], [4, 5, 7], [4, 7, 6], [0, 1, 5], [0, 5, 4], [2, 6, 7], [2, 7, 3]];
    let sides = [[0, 4, 6], [0, 6, 2], [1, 3, 7], [1, 7, 5]];
    (vertices.collect(), ends.into_iter().chain(sides).collect())
}

/// A closed outline of radii and heights, rotated about Z; corners of radius 0 are on the axis. Round surfaces are no
/// farther than a distance from their triangles.
pub(crate) fn turned(outline: &[[f64; 2]], chord_mm: f64) -> Triangles {
    let count = outline.len();
    let next = |index: usize| outline[(index + 1) % count];
    let area: f64 =
        (0..count).map(|index| outline[index][0] * next(index)[1] - next(index)[0] * outline[index][1]).sum();
    // Counter-clockwise in the half plane of radius and height, so that the faces look outwards.
    let outline: Vec<[f64; 2]> = if area < 0.0 { outline.iter().rev().copied().collect() } else { outline.to_vec() };
    let largest = outline.iter().fold(0.0_f64, |largest, corner| largest.max(corner[0]));
    let sides = sides(largest, chord_mm);
    let (mut vertices, mut faces) = (Vec::new(), Vec::new());
    // First vertex of each corner, and whether it is a ring.
    let rings: Vec<(u32, bool)> = outline
        .iter()
        .map(|[radius, height]| {
            let first = vertices.len() as u32;
            if *radius <= 0.0 {
                vertices.push([0.0, 0.0, *height]);
                return (first, false);
            }
            vertices.extend((0..sides).map(|side| {
                let (sine, cosine) = (TAU * f64::from(side) / f64::from(sides)).sin_cos();
                [radius * cosine, radius * sine, *height]
            }));
            (first, true)
        })
        .collect();
    for index in 0..count {
        let (one, two) = (rings[index], rings[(index + 1) % count]);
        let at = |(first, ring): (u32, bool), side: u32| if ring { first + side % sides } else { first };
        for side in 0..sides {
            let [a, b, c, d] = [at(one, side), at(one, side + 1), at(two, side + 1), at(two, side)];
            faces.extend([[a, b, c], [a, c, d]].into_iter().filter(|[a, b, c]| a != b && b != c && c != a));
        }
    }
    (vertices, faces)
}

/// Sides of a circle whose chords are within a distance of it.
fn sides(radius: f64, chord_mm: f64) -> u32 {
    let half = (1.0 - (chord_mm / radius).min(0.9)).acos();
    let [fewest, most] = SIDES;
    (PI / half).ceil().clamp(fewest, most) as u32
}

/// Largest distance of a circle from its chords, mm.
pub(crate) fn chord_of(radius: f64, chord_mm: f64) -> f64 {
    radius * (1.0 - (PI / f64::from(sides(radius, chord_mm))).cos())
}
