//! Distance of a point from the surface of a body: a tree of boxes around triangles.

use nalgebra::Vector3;

type SurfacePoint = Vector3<f64>;

/// Triangles of a leaf.
const LEAF: usize = 4;

/// A box of the tree.
#[derive(Debug, Clone, Copy)]
struct TreeNode {
    low: [f64; 3],
    high: [f64; 3],
    /// First triangle of a leaf, or second child; the first child comes next.
    first: u32,
    /// Number of triangles of a leaf; 0: a box with two children.
    count: u32,
}

impl TreeNode {
    /// Square of the distance of a point from the box, mm².
    fn square(&self, point: &SurfacePoint) -> f64 {
        (0..3).map(|axis| (self.low[axis] - point[axis]).max(point[axis] - self.high[axis]).max(0.0).powi(2)).sum()
    }
}

/// A surface of triangles.
#[derive(Debug, Clone)]
pub(crate) struct TriangleSurface {
    triangles: Vec<[SurfacePoint; 3]>,
    nodes: Vec<TreeNode>,
}

impl TriangleSurface {
    pub(crate) fn new(mut triangles: Vec<[[f64; 3]; 3]>) -> Self {
        let mut nodes = Vec::with_capacity(triangles.len());
        if !triangles.is_empty() {
            let count = triangles.len();
            build(&mut triangles, [0, count], &mut nodes);
        }
        let triangles = triangles.into_iter().map(|triangle| triangle.map(SurfacePoint::from)).collect();
        Self { triangles, nodes }
    }

    /// Distance of a point from the surface, mm. `within`: a distance that is known not to be exceeded, or infinity.
    pub(crate) fn distance(&self, point: [f64; 3], within: f64) -> f64 {
        let point = SurfacePoint::from(point);
        let mut best = within * within;
        let mut open: Vec<(u32, f64)> = Vec::with_capacity(64);
        if let Some(root) = self.nodes.first() {
            open.push((0, root.square(&point)));
        }
        while let Some((index, square)) = open.pop() {
            if square >= best {
                continue;
            }
            let node = &self.nodes[index as usize];
            if node.count > 0 {
                for triangle in &self.triangles[node.first as usize..(node.first + node.count) as usize] {
                    best = best.min(square_from_triangle(&point, triangle));
                }
                continue;
            }
            let children = [index + 1, node.first].map(|child| (child, self.nodes[child as usize].square(&point)));
            // The nearer one is looked at first.
            let [one, two] = children;
            open.extend(if one.1 < two.1 { [two, one] } else { [one, two] });
        }
        best.sqrt()
    }
}

/// Adds the boxes of a range of triangles, which are sorted.
fn build(triangles: &mut [[[f64; 3]; 3]], [from, to]: [usize; 2], nodes: &mut Vec<TreeNode>) {
    let part = &mut triangles[from..to];
    let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for corner in part.iter().flatten() {
        for axis in 0..3 {
            (low[axis], high[axis]) = (low[axis].min(corner[axis]), high[axis].max(corner[axis]));
        }
    }
    let here = nodes.len();
    let leaf = part.len() <= LEAF;
    nodes.push(TreeNode { low, high, first: from as u32, count: if leaf { part.len() as u32 } else { 0 } });
    if leaf {
        return;
    }
    let size: [f64; 3] = std::array::from_fn(|axis| high[axis] - low[axis]);
    let axis = (0..3).max_by(|a, b| size[*a].total_cmp(&size[*b])).unwrap_or(0);
    let middle = |triangle: &[[f64; 3]; 3]| triangle[0][axis] + triangle[1][axis] + triangle[2][axis];
    let half = part.len() / 2;
    part.select_nth_unstable_by(half, |a, b| middle(a).total_cmp(&middle(b)));
    build(triangles, [from, from + half], nodes);
    nodes[here].first = nodes.len() as u32;
    build(triangles, [from + half, to], nodes);
}

/// Square of the distance from a triangle, mm²; it may be as narrow as a line.
fn square_from_triangle(point: &SurfacePoint, [a, b, c]: &[SurfacePoint; 3]) -> f64 {
    let (ab, ac, ap) = (b - a, c - a, point - a);
    let normal = ab.cross(&ac);
    let area = normal.norm_squared();
    if area > 0.0 {
        let second = ab.cross(&ap).dot(&normal);
        let third = ap.cross(&ac).dot(&normal);
        if second >= 0.0 && third >= 0.0 && second + third <= area {
            return ap.dot(&normal).powi(2) / area;
        }
    }
    let edges = [(a, b), (b, c), (c, a)].map(|(from, to)| square_from_edge(point, from, to));
    edges[0].min(edges[1]).min(edges[2])
}

fn square_from_edge(point: &SurfacePoint, from: &SurfacePoint, to: &SurfacePoint) -> f64 {
    let (edge, way) = (to - from, point - from);
    let length = edge.norm_squared();
    let share = if length > 0.0 { (way.dot(&edge) / length).clamp(0.0, 1.0) } else { 0.0 };
    (way - edge * share).norm_squared()
}
