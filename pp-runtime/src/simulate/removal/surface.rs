//! The surface of a stock as triangles: surface nets.
//!
//! Where three lines cross there is a node, in material or not. A cell between eight nodes that are not alike has a vertex: the
//! mean of the places at which its edges, which are parts of lines, enter or leave the material. Every such edge makes a
//! face of the vertices of the four cells around it, so the surface is closed. On planes it is exact; edges of the material
//! are cut off by about a third of the pitch.

use super::stock::{Filled, TriDexel};

/// Vertices and triangles, counter-clockwise from outside.
type Triangles = (Vec<[f64; 3]>, Vec<[u32; 3]>);

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
    vertices: Vec<[f64; 3]>,
    faces: Vec<[u32; 3]>,
}

impl TriDexel {
    /// Its surface as triangles.
    pub(crate) fn surface(&self) -> Triangles {
        let counts = self.counts();
        let mut nets = Nets { stock: self, counts, vertices: Vec::new(), faces: Vec::new() };
        let mut below = nets.layer(0);
        let mut cells_below: Vec<u32> = Vec::new();
        for k in 0..=counts[2] {
            let above = nets.layer(k + 1);
            let cells = nets.cells(k, [&below, &above]);
            nets.faces_of(k, [&below, &above], &cells, &cells_below);
            (below, cells_below) = (above, cells);
        }
        (nets.vertices, nets.faces)
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

    /// Where an edge leaves the material: `node` is the lower one, `inside` whether that is the one in material.
    fn crossing(&self, axis: usize, node: [usize; 3], inside: bool) -> f64 {
        let (low, high) = (self.node(axis, node[axis]), self.node(axis, node[axis] + 1));
        let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
        let spans = self.stock.spans(axis, [node[u] - 1, node[v] - 1]);
        let ends = spans.iter().map(|span: &Filled| f64::from(if inside { span.high } else { span.low }));
        let found = ends.filter(|end| (low..=high).contains(end));
        // The one next to the node in material; families may differ about a node on the surface.
        found.reduce(if inside { f64::min } else { f64::max }).unwrap_or(f64::midpoint(low, high))
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
                let (mut sum, mut crossings) = ([0.0; 3], 0);
                for axis in 0..3 {
                    for corner in (0..8_usize).filter(|corner| corner >> axis & 1 == 0) {
                        if solid(corner) == solid(corner | 1 << axis) {
                            continue;
                        }
                        let node = [i + (corner & 1), j + (corner >> 1 & 1), k + (corner >> 2)];
                        let mut place: [f64; 3] = std::array::from_fn(|other| self.node(other, node[other]));
                        place[axis] = self.crossing(axis, node, solid(corner));
                        (0..3).for_each(|other| sum[other] += place[other]);
                        crossings += 1;
                    }
                }
                cells[j * across + i] = self.vertices.len() as u32;
                self.vertices.push(sum.map(|sum| sum / f64::from(crossings)));
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
            let [p, q] = [one, two].map(|index| self.vertices[index as usize]);
            (0..3).map(|axis| (p[axis] - q[axis]).powi(2)).sum::<f64>()
        };
        // By the shorter diagonal.
        let halves = if square(a, c) <= square(b, d) { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] };
        self.faces.extend(halves);
    }
}
