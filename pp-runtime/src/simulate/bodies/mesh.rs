//! Bodies as triangles: STL files, and the lines that are inside.
//!
//! A body must be closed and its triangles must face outwards. Whether a line meets a triangle is decided by the side
//! of each edge on which it is. An edge has the same side for both of its triangles, and a line that meets an edge
//! exactly is moved aside by less than any number, so that a closed body is entered as often as it is left.

use std::cmp::Reverse;
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::ops::Range;

use nalgebra::{Isometry3, Point3, Rotation3};

use crate::simulate::groups::Groups;
use crate::simulate::removal::{StockFault, TriDexel};

/// Largest number of triangles.
const MOST_TRIANGLES: u64 = 20_000_000;

/// Bytes of a binary file before its triangles, and of each triangle.
const HEAD_BYTES: u64 = 84;
const TRIANGLE_BYTES: u64 = 50;

/// A closed body.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Mesh {
    vertices: Vec<[f64; 3]>,
    faces: Vec<[u32; 3]>,
}

/// The reason why a file is no body.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub(crate) struct MeshFault(String);

impl Mesh {
    /// Reads an STL file, binary or text.
    ///
    /// # Errors
    /// A sentence about a file that is no STL file, or a body that is open, inside out or too large.
    #[cfg(test)]
    pub(crate) fn read(input: &mut (impl Read + Seek)) -> Result<Self, MeshFault> {
        let mesh = Self::read_surface(input)?;
        mesh.flaw().map_or(Ok(mesh), |flaw| Err(MeshFault(flaw)))
    }

    /// Reads an STL file with a surface that may be open or inside out.
    ///
    /// # Errors
    /// A sentence about a file that is no STL file, or too large.
    pub(crate) fn read_surface(input: &mut (impl Read + Seek)) -> Result<Self, MeshFault> {
        let size = input.seek(SeekFrom::End(0)).and_then(|size| input.rewind().map(|()| size));
        let size = size.map_err(|error| MeshFault(error.to_string()))?;
        if size > HEAD_BYTES + TRIANGLE_BYTES * MOST_TRIANGLES {
            return Err(MeshFault(format!("it has {size} bytes: more than {MOST_TRIANGLES} triangles")));
        }
        let read = stl_io::read_stl(input).map_err(|error| match error.kind() {
            io::ErrorKind::UnexpectedEof => MeshFault("it is no STL file, or ends before its last triangle".to_owned()),
            _ => MeshFault(format!("it is no STL file: {error}")),
        })?;
        let vertices: Vec<[f64; 3]> = read.vertices.iter().map(|vertex| vertex.0.map(f64::from)).collect();
        let faces = read.faces.iter().map(|face| face.vertices.map(|index| index as u32)).collect();
        Self::surface(vertices, faces)
    }

    /// A body of triangles; each has the numbers of its three vertices, counter-clockwise from outside.
    ///
    /// # Errors
    /// A sentence about a body that is empty, open or inside out.
    pub(crate) fn new(vertices: Vec<[f64; 3]>, faces: Vec<[u32; 3]>) -> Result<Self, MeshFault> {
        let mesh = Self::surface(vertices, faces)?;
        mesh.flaw().map_or(Ok(mesh), |flaw| Err(MeshFault(flaw)))
    }

    /// Triangles that are known to be a closed body.
    pub(crate) fn of_checked(vertices: Vec<[f64; 3]>, faces: Vec<[u32; 3]>) -> Self {
        Self { vertices, faces }
    }

    /// Triangles that may be open or inside out.
    fn surface(vertices: Vec<[f64; 3]>, faces: Vec<[u32; 3]>) -> Result<Self, MeshFault> {
        // A triangle of two points has no area and two opposite edges.
        let flat = |face: &[u32; 3]| face[0] == face[1] || face[1] == face[2] || face[2] == face[0];
        let faces: Vec<[u32; 3]> = faces.into_iter().filter(|face| !flat(face)).collect();
        if faces.is_empty() {
            return Err(MeshFault("it has no triangle".to_owned()));
        }
        if let Some(vertex) = vertices.iter().find(|vertex| !vertex.iter().all(|value| value.is_finite())) {
            return Err(MeshFault(format!("it has a point that is none: {vertex:?}")));
        }
        if faces.iter().flatten().any(|index| *index as usize >= vertices.len()) {
            return Err(MeshFault("it has a triangle of points that are not there".to_owned()));
        }
        Ok(Self { vertices, faces })
    }

    /// The reason why the triangles are no body: they are open or inside out.
    pub(crate) fn flaw(&self) -> Option<String> {
        let volume = self.volume();
        let inwards =
            || (volume <= 0.0).then(|| format!("its triangles face inwards: its volume is {volume:.3} mm\u{b3}"));
        self.open_edges().or_else(inwards)
    }

    /// Writes a binary STL file.
    ///
    /// # Errors
    /// Errors of the output.
    pub(crate) fn write(&self, out: &mut impl Write) -> io::Result<()> {
        let triangle = |face: &[u32; 3]| {
            let corners = face.map(|index| self.vertices[index as usize]);
            let [a, b, c] = corners.map(nalgebra::Vector3::from);
            let normal = (b - a).cross(&(c - a)).try_normalize(0.0).unwrap_or_default();
            stl_io::Triangle {
                normal: stl_io::Vector(<[f64; 3]>::from(normal).map(|value| value as f32)),
                vertices: corners.map(|corner| stl_io::Vector(corner.map(|value| value as f32))),
            }
        };
        let triangles: Vec<stl_io::Triangle> = self.faces.iter().map(triangle).collect();
        stl_io::write_stl(out, triangles.iter())
    }

    /// Each edge must be passed as often in one direction as in the other.
    fn open_edges(&self) -> Option<String> {
        let edges = self.faces.iter().flat_map(|[a, b, c]| [[*a, *b], [*b, *c], [*c, *a]]);
        let mut edges: Vec<([u32; 2], i32)> =
            edges.map(|[a, b]| if a < b { ([a, b], 1) } else { ([b, a], -1) }).collect();
        edges.sort_unstable();
        let (mut open, mut first) = (0, None);
        for same in edges.chunk_by(|one, other| one.0 == other.0) {
            if same.iter().map(|(_, sense)| sense).sum::<i32>() != 0 {
                open += 1;
                first.get_or_insert(same[0].0[0]);
            }
        }
        let [x, y, z] = self.vertices[first? as usize];
        Some(format!("it is open: {open} edges have triangles on one side only, the first at X{x:.3} Y{y:.3} Z{z:.3}"))
    }

    /// Volume, mm³.
    #[must_use]
    pub(crate) fn volume(&self) -> f64 {
        let origin = self.vertices[0];
        let from = |index: u32| -> [f64; 3] {
            let vertex = self.vertices[index as usize];
            std::array::from_fn(|axis| vertex[axis] - origin[axis])
        };
        let six = self.faces.iter().map(|face| {
            let [a, b, c] = face.map(from);
            a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])
        });
        six.sum::<f64>() / 6.0
    }

    /// Number of triangles.
    #[must_use]
    pub(crate) fn triangles(&self) -> usize {
        self.faces.len()
    }

    /// Corners of the box around it.
    #[must_use]
    pub(crate) fn corners(&self) -> [[f64; 3]; 2] {
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for vertex in self.faces.iter().flatten().map(|index| self.vertices[*index as usize]) {
            for axis in 0..3 {
                (low[axis], high[axis]) = (low[axis].min(vertex[axis]), high[axis].max(vertex[axis]));
            }
        }
        [low, high]
    }

    /// The body rotated about the origin.
    #[must_use]
    pub(crate) fn rotated(self, rotation: &Rotation3<f64>) -> Self {
        self.moved(|vertex| (rotation * nalgebra::Vector3::from(vertex)).into())
    }

    /// The body in another unit.
    pub(crate) fn scaled(self, by: f64) -> Self {
        self.moved(|vertex| vertex.map(|value| by * value))
    }

    /// The body where a place is the origin of its coordinates.
    pub(crate) fn placed(self, place: &Isometry3<f64>) -> Self {
        self.moved(|vertex| (place * Point3::from(vertex)).into())
    }

    /// The body with its points elsewhere.
    pub(crate) fn moved(mut self, place: impl Fn([f64; 3]) -> [f64; 3]) -> Self {
        self.vertices.iter_mut().for_each(|vertex| *vertex = place(*vertex));
        self
    }

    /// The points that its triangles have.
    pub(crate) fn used_vertices(&self) -> Vec<[f64; 3]> {
        let mut used = vec![false; self.vertices.len()];
        self.faces.iter().flatten().for_each(|index| used[*index as usize] = true);
        self.vertices.iter().zip(used).filter(|(_, used)| *used).map(|(vertex, _)| *vertex).collect()
    }

    /// A point of each part whose triangles hang together.
    pub(crate) fn points_of_parts(&self) -> Vec<[f64; 3]> {
        let mut parts = Groups::of(self.vertices.len());
        for [a, b, c] in &self.faces {
            [b, c].into_iter().for_each(|other| parts.join(*a as usize, *other as usize));
        }
        let mut firsts: Vec<usize> = self.faces.iter().map(|face| parts.first(face[0] as usize)).collect();
        firsts.sort_unstable();
        firsts.dedup();
        firsts.into_iter().map(|first| self.vertices[first]).collect()
    }

    /// Whether a point is inside: the triangles are seen from there all round. `point` is not on the surface.
    pub(crate) fn has_inside(&self, point: [f64; 3]) -> bool {
        let from = |index: u32| -> nalgebra::Vector3<f64> {
            let vertex = self.vertices[index as usize];
            std::array::from_fn::<f64, 3, _>(|axis| vertex[axis] - point[axis]).into()
        };
        let angle = |face: &[u32; 3]| {
            let [a, b, c] = face.map(from);
            let (la, lb, lc) = (a.norm(), b.norm(), c.norm());
            2.0 * a.dot(&b.cross(&c)).atan2(la * lb * lc + a.dot(&b) * lc + b.dot(&c) * la + c.dot(&a) * lb)
        };
        self.faces.iter().map(angle).sum::<f64>().abs() > std::f64::consts::TAU
    }

    /// Its points.
    pub(crate) fn vertices(&self) -> &[[f64; 3]] {
        &self.vertices
    }

    /// Its triangles, as numbers of points.
    pub(crate) fn faces(&self) -> &[[u32; 3]] {
        &self.faces
    }

    /// The body as a stock.
    ///
    /// # Errors
    /// Those of [`TriDexel::empty`], and a body that is entered and left a different number of times.
    pub(crate) fn stock(&self, pitch_mm: f64) -> Result<TriDexel, StockFault> {
        let corners = self.corners();
        let empty = TriDexel::empty(corners, pitch_mm)?;
        let mut lines = [0, 1, 2].map(|family| self.lines_through(&empty, family));
        let mut unequal = None;
        let stock = TriDexel::filled(corners, pitch_mm, |family, line, across, parts| {
            if !lines[family].parts(line, parts) {
                unequal.get_or_insert((family, across));
            }
        })?;
        match unequal {
            None => Ok(stock),
            Some((family, [u, v])) => {
                let names = ["X", "Y", "Z"];
                let text = format!(
                    "a line along {} at {}{u:.4} {}{v:.4} enters the body more often than it leaves it",
                    names[family],
                    names[(family + 1) % 3],
                    names[(family + 2) % 3]
                );
                Err(StockFault::new(text))
            }
        }
    }

    /// The corners of each triangle.
    pub(crate) fn corners_of_triangles(&self) -> Vec<[[f64; 3]; 3]> {
        self.faces.iter().map(|face| face.map(|index| self.vertices[index as usize])).collect()
    }

    /// The lines of a family of a stock, with the parts of them that are inside.
    pub(crate) fn lines_through<'m>(&'m self, stock: &'m TriDexel, family: usize) -> LinesThrough<'m> {
        let lines = MeshLines { mesh: self, stock, family };
        let mut waiting: Vec<u32> = (0..self.faces.len() as u32).filter(|face| !lines.rows(*face).is_empty()).collect();
        waiting.sort_by_cached_key(|face| Reverse(lines.rows(*face).start));
        LinesThrough { lines, waiting, met: Vec::new(), end: 0, crossings: Vec::new(), next: 0 }
    }

    /// Whether a point is to the left of an edge: the same for an edge in both directions but for the sign.
    fn side(&self, [a, b]: [u32; 2], [u, v]: [usize; 2], at: [f64; 2]) -> bool {
        let (first, second) = if a < b { (a, b) } else { (b, a) };
        let [p, q] = [first, second].map(|index| self.vertices[index as usize]);
        let (du, dv) = (q[u] - p[u], q[v] - p[v]);
        let area = du * (at[1] - p[v]) - dv * (at[0] - p[u]);
        // On the edge: as if the point were moved along u, and by less along v.
        let signed = if area.abs() > 0.0 {
            area
        } else if dv.abs() > 0.0 {
            -dv
        } else {
            du
        };
        (signed > 0.0) == (a < b)
    }
}

/// A line passes through a triangle.
#[derive(Debug, Clone, Copy)]
struct Crossing {
    line: [usize; 2],
    at: f64,
    enters: i32,
}

/// Rows of lines whose crossings are held at a time.
const ROWS: usize = 16;

/// Lines through a body, row by row.
pub(crate) struct LinesThrough<'m> {
    lines: MeshLines<'m>,
    /// Triangles that no row has met so far, those of the first rows last.
    waiting: Vec<u32>,
    /// Triangles that the rows held have met, and those that follow may.
    met: Vec<u32>,
    /// The first row that is not held.
    end: usize,
    /// Those of the rows held, line by line.
    crossings: Vec<Crossing>,
    next: usize,
}

impl LinesThrough<'_> {
    /// Adds the parts of the next line that are inside; returns whether it leaves the body as often as it enters it.
    /// Lines are asked for row by row.
    pub(crate) fn parts(&mut self, line: [usize; 2], parts: &mut Vec<[f64; 2]>) -> bool {
        if line[1] >= self.end {
            self.hold_rows(line[1]);
        }
        let (mut depth, mut begin) = (0, 0.0);
        while let Some(crossing) = self.crossings.get(self.next).filter(|found| found.line == line) {
            self.next += 1;
            let before = depth;
            depth += crossing.enters;
            if before <= 0 && depth > 0 {
                begin = crossing.at;
            } else if before > 0 && depth <= 0 {
                parts.push([begin, crossing.at]);
            }
        }
        depth == 0
    }

    /// Finds the crossings of the rows from one on.
    fn hold_rows(&mut self, first: usize) {
        let Self { lines, waiting, met, end, crossings, next } = self;
        (*end, *next) = (first + ROWS, 0);
        while let Some(face) = waiting.pop_if(|face| lines.rows(*face).start < *end) {
            met.push(face);
        }
        met.retain(|face| lines.rows(*face).end > first);
        crossings.clear();
        met.iter().for_each(|face| lines.cross(*face, first..*end, crossings));
        crossings.sort_by(|a, b| (a.line[1], a.line[0]).cmp(&(b.line[1], b.line[0])).then(a.at.total_cmp(&b.at)));
    }
}

/// A body and the lines of a family of a stock.
#[derive(Clone, Copy)]
struct MeshLines<'m> {
    mesh: &'m Mesh,
    stock: &'m TriDexel,
    family: usize,
}

impl MeshLines<'_> {
    /// Both directions across the lines.
    fn across(&self) -> [usize; 2] {
        [(self.family + 1) % 3, (self.family + 2) % 3]
    }

    /// Corners of a triangle.
    fn corners(&self, face: u32) -> [[f64; 3]; 3] {
        self.mesh.faces[face as usize].map(|index| self.mesh.vertices[index as usize])
    }

    /// Lines that may pass through a triangle: their numbers in the first or the second direction across.
    fn numbers(&self, face: u32, direction: usize) -> Range<usize> {
        let (axis, count) = (self.across()[direction], self.stock.lines(self.family)[direction]);
        let (low, pitch) = (self.stock.corners()[0][axis], self.stock.pitch()[axis]);
        let ends = self.corners(face).map(|corner| (corner[axis] - low) / pitch - 0.5);
        let (first, last) = (ends[0].min(ends[1]).min(ends[2]), ends[0].max(ends[1]).max(ends[2]));
        (first - 1e-6).ceil().max(0.0) as usize..((last + 1e-6).floor() + 1.0).clamp(0.0, count as f64) as usize
    }

    /// Rows with lines that may pass through a triangle.
    fn rows(&self, face: u32) -> Range<usize> {
        self.numbers(face, 1)
    }

    /// Where the lines of some rows pass through a triangle.
    fn cross(&self, number: u32, rows: Range<usize>, crossings: &mut Vec<Crossing>) {
        let (corners, [u, v]) = (self.corners(number), self.across());
        let [a, b, c] = self.mesh.faces[number as usize];
        let (columns, of_face) = (self.numbers(number, 0), self.rows(number));
        for j in of_face.start.max(rows.start)..of_face.end.min(rows.end) {
            for i in columns.clone() {
                let at = self.stock.across(self.family, [i, j]);
                let side = |a: u32, b: u32| self.mesh.side([a, b], [u, v], at);
                let left = side(a, b);
                if side(b, c) == left && side(c, a) == left {
                    crossings.push(Crossing {
                        line: [i, j],
                        at: height(&corners, [u, v, self.family], at),
                        // Seen along the line a triangle that faces back is entered.
                        enters: if left { -1 } else { 1 },
                    });
                }
            }
        }
    }
}

/// Height of a plane over a point.
fn height(corners: &[[f64; 3]; 3], [u, v, w]: [usize; 3], at: [f64; 2]) -> f64 {
    let [a, b, c] = corners;
    let (bu, bv, bw) = (b[u] - a[u], b[v] - a[v], b[w] - a[w]);
    let (cu, cv, cw) = (c[u] - a[u], c[v] - a[v], c[w] - a[w]);
    let area = bu * cv - bv * cu;
    let (x, y) = (at[0] - a[u], at[1] - a[v]);
    let heights = [a[w], b[w], c[w]];
    let (low, high) = (heights[0].min(heights[1]).min(heights[2]), heights[0].max(heights[1]).max(heights[2]));
    let found = a[w] + ((x * cv - y * cu) * bw + (bu * y - bv * x) * cw) / area;
    // A triangle that is nearly along the line.
    if found.is_nan() { f64::midpoint(low, high) } else { found.clamp(low, high) }
}
