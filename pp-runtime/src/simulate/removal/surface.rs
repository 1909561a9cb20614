//! The surface of a stock as triangles: surface nets.
//!
//! Where three lines cross there is a node, in material or not. A cell between eight nodes that are not alike has a
//! vertex: the mean of the places at which its edges, which are parts of lines, enter or leave the material. Every such
//! edge makes a face of the vertices of the four cells around it, so the surface is closed. On planes it is exact;
//! edges of the material are cut off by about a third of the pitch.

use super::stock::{FilledPart, TriDexel};

/// Vertices and triangles, counter-clockwise from outside.
type SurfaceTriangles = (Vec<[f64; 3]>, Vec<[u32; 3]>);

/// Values of the ends of all lines of a stock, by family: NaN where unknown.
#[derive(Debug, Clone, Default)]
pub(crate) struct EndValues {
    /// Number of ends before each line.
    first: [Vec<u32>; 3],
    values: [Vec<f32>; 3],
}

impl EndValues {
    /// Adds the next line of a family: the value of each of its ends, from the lowest up.
    pub(crate) fn add(&mut self, family: usize, values: impl Iterator<Item = f32>) {
        self.first[family].push(self.values[family].len() as u32);
        self.values[family].extend(values);
    }

    fn get(&self, family: usize, line: usize, end: usize) -> Option<f32> {
        let first = *self.first[family].get(line)? as usize;
        self.values[family].get(first + end).copied().filter(|value| !value.is_nan())
    }
}

/// A surface with what is known of each of its vertices.
#[derive(Debug, Clone, Default)]
pub(crate) struct MarkedSurface {
    pub(crate) vertices: Vec<[f64; 3]>,
    pub(crate) faces: Vec<[u32; 3]>,
    /// The value farthest from 0 among the ends around a vertex; NaN: unknown.
    pub(crate) values: Vec<f32>,
    /// Name of the piece that cut that end; 0: the blank, `u32::MAX`: unknown.
    pub(crate) ids: Vec<u32>,
}

const NONE: u32 = u32::MAX;

/// Nodes of one layer, with a border that is not material.
struct Layer {
    solid: Vec<bool>,
    width: usize,
}

impl Layer {
    fn at(&self, i: usize, j: usize) -> bool {
        self.solid[j * self.width + i]
    }
}

struct Nets<'a> {
    stock: &'a TriDexel,
    counts: [usize; 3],
    ends: &'a EndValues,
    surface: MarkedSurface,
}

impl TriDexel {
    /// Its surface as triangles.
    pub(crate) fn surface(&self) -> SurfaceTriangles {
        let MarkedSurface { vertices, faces, .. } = self.marked_surface(&EndValues::default());
        (vertices, faces)
    }

    /// Its surface as triangles, with values of the ends of its lines.
    pub(crate) fn marked_surface(&self, ends: &EndValues) -> MarkedSurface {
        let counts = self.counts();
        let mut nets = Nets { stock: self, counts, ends, surface: MarkedSurface::default() };
        let mut below = nets.layer(0);
        let mut cells_below: Vec<u32> = Vec::new();
        for k in 0..=counts[2] {
            let above = nets.layer(k + 1);
            let cells = nets.cells(k, [&below, &above]);
            nets.faces_of(k, [&below, &above], &cells, &cells_below);
            (below, cells_below) = (above, cells);
        }
        nets.surface
    }
}

impl Nets<'_> {
    /// Coordinate of a node; 0 is before the first one.
    fn node(&self, axis: usize, index: usize) -> f64 {
        let [low, _] = self.stock.corners();
        low[axis] + (index as f64 - 0.5) * self.stock.pitch()[axis]
    }

    fn layer(&self, k: usize) -> Layer {
        let width = self.counts[0] + 2;
        let mut solid = vec![false; width * (self.counts[1] + 2)];
        if k > 0 && k <= self.counts[2] {
            let z = self.node(2, k) as f32;
            for j in 1..=self.counts[1] {
                for i in 1..=self.counts[0] {
                    let spans = self.stock.spans(2, [i - 1, j - 1]);
                    solid[j * width + i] = spans.iter().any(|span| span.low <= z && z <= span.high);
                }
            }
        }
        Layer { solid, width }
    }

    /// Where an edge leaves the material: `node` is the lower one, `inside` whether that is the one in material. With
    /// value and name of the end there.
    fn crossing(&self, axis: usize, node: [usize; 3], inside: bool) -> (f64, f32, u32) {
        let (low, high) = (self.node(axis, node[axis]), self.node(axis, node[axis] + 1));
        let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
        let line = [node[u] - 1, node[v] - 1];
        let spans = self.stock.spans(axis, line).iter().enumerate();
        let ends = spans.map(|(number, span): (usize, &FilledPart)| match inside {
            true => (f64::from(span.high), span.high_id, 2 * number + 1),
            false => (f64::from(span.low), span.low_id, 2 * number),
        });
        // The one next to the node in material; families may differ about a node on the surface.
        let nearer = |one: &(f64, u32, usize), other: &(f64, u32, usize)| one.0.total_cmp(&other.0);
        let found = ends.filter(|(end, ..)| (low..=high).contains(end));
        let found = if inside { found.min_by(nearer) } else { found.max_by(nearer) };
        let Some((at, id, end)) = found else { return (f64::midpoint(low, high), f32::NAN, u32::MAX) };
        let number = line[1] * self.stock.lines(axis)[0] + line[0];
        (at, self.ends.get(axis, number, end).unwrap_or(f32::NAN), id)
    }

    /// The vertex of each cell of a layer.
    fn cells(&mut self, k: usize, layers: [&Layer; 2]) -> Vec<u32> {
        let [across, along] = [self.counts[0] + 1, self.counts[1] + 1];
        let mut cells = vec![NONE; across * along];
        for j in 0..along {
            for i in 0..across {
                let solid = |corner: usize| layers[corner >> 2].at(i + (corner & 1), j + (corner >> 1 & 1));
                let count = (0..8).filter(|corner| solid(*corner)).count();
                if count == 0 || count == 8 {
                    continue;
                }
                let (mut sum, mut crossings, mut mark) = ([0.0; 3], 0, (f32::NAN, u32::MAX));
                for axis in 0..3 {
                    for corner in (0..8_usize).filter(|corner| corner >> axis & 1 == 0) {
                        if solid(corner) == solid(corner | 1 << axis) {
                            continue;
                        }
                        let node = [i + (corner & 1), j + (corner >> 1 & 1), k + (corner >> 2)];
                        let mut place: [f64; 3] = std::array::from_fn(|other| self.node(other, node[other]));
                        let (at, value, id) = self.crossing(axis, node, solid(corner));
                        place[axis] = at;
                        if mark.0.is_nan() && (mark.1 == u32::MAX || !value.is_nan()) || value.abs() > mark.0.abs() {
                            mark = (value, id);
                        }
                        (0..3).for_each(|other| sum[other] += place[other]);
                        crossings += 1;
                    }
                }
                let surface = &mut self.surface;
                cells[j * across + i] = surface.vertices.len() as u32;
                surface.vertices.push(sum.map(|sum| sum / f64::from(crossings)));
                surface.values.push(mark.0);
                surface.ids.push(mark.1);
            }
        }
        cells
    }

    /// The faces of the edges between two layers of nodes, and of those in the lower one.
    fn faces_of(&mut self, k: usize, [below, above]: [&Layer; 2], cells: &[u32], cells_below: &[u32]) {
        let across = self.counts[0] + 1;
        let at = |cells: &[u32], i: usize, j: usize| cells[j * across + i];
        for j in 1..=self.counts[1] {
            for i in 1..=self.counts[0] {
                let here = below.at(i, j);
                if here != above.at(i, j) {
                    let corners = [at(cells, i - 1, j - 1), at(cells, i, j - 1), at(cells, i, j), at(cells, i - 1, j)];
                    self.face(corners, here);
                }
            }
        }
        if k == 0 {
            return;
        }
        for j in 1..=self.counts[1] {
            for i in 0..=self.counts[0] {
                let here = below.at(i, j);
                if here != below.at(i + 1, j) {
                    // Seen from X: Y to the right, Z up.
                    let [low, high] = [cells_below, cells];
                    self.face([at(low, i, j - 1), at(low, i, j), at(high, i, j), at(high, i, j - 1)], here);
                }
            }
        }
        for j in 0..=self.counts[1] {
            for i in 1..=self.counts[0] {
                let here = below.at(i, j);
                if here != below.at(i, j + 1) {
                    // Seen from Y: Z to the right, X up.
                    let [low, high] = [cells_below, cells];
                    self.face([at(low, i - 1, j), at(high, i - 1, j), at(high, i, j), at(low, i, j)], here);
                }
            }
        }
    }

    /// Two triangles; the surface looks along the axis if the material is below.
    fn face(&mut self, corners: [u32; 4], below: bool) {
        let [a, b, c, d] = if below { corners } else { [corners[0], corners[3], corners[2], corners[1]] };
        let square = |one: u32, two: u32| {
            let [p, q] = [one, two].map(|index| self.surface.vertices[index as usize]);
            (0..3).map(|axis| (p[axis] - q[axis]).powi(2)).sum::<f64>()
        };
        // By the shorter diagonal.
        let halves = if square(a, c) <= square(b, d) { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] };
        self.surface.faces.extend(halves);
    }
}
