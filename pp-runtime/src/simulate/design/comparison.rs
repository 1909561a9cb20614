//! The machined stock against the design: gouges and rest material.
//!
//! The design is cut by the lines of the stock. Where a line has design and no material there is a gouge, where it has
//! material and no design there is rest. The size of either is the distance from the surface of the design to its
//! closest point. It is largest at an end of the material, or in the middle of a part of the design that is missing
//! from one side to the other (and of material that fills a gap of the design), which is searched along the line.
//!
//! Memory depends on the stock and the design. Neighbouring places beyond the tolerance are one region.

use std::collections::HashMap;

use nalgebra::Isometry3;

use super::nearest::TriangleSurface;
use crate::simulate::bodies::Mesh;
use crate::simulate::groups::Groups;
use crate::simulate::removal::{EndValues, FilledPart, TriDexel};

/// Regions that are kept; all are counted.
pub(crate) const MOST_REGIONS: usize = 100;

/// Places at which a part between two surfaces is measured: at most.
const MOST_PLACES: u32 = 64;

/// Limits of the histogram on either side of zero, mm.
pub(crate) const LIMITS_MM: [f64; 9] = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0];

/// Classes of the histogram.
const CLASSES: usize = 2 * (LIMITS_MM.len() + 1);

/// A design.
#[derive(Debug, Clone)]
pub(crate) struct Design {
    mesh: Mesh,
    surface: TriangleSurface,
}

/// A line of the program, or the blank.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Origin {
    /// The blank: no motion has cut there.
    Blank,
    /// A line of the program.
    Line(u32),
    /// Not known.
    Unknown,
}

impl Origin {
    fn of(id: u32) -> Self {
        match id {
            0 => Self::Blank,
            // Lines from here on have this name together.
            u32::MAX => Self::Unknown,
            line => Self::Line(line),
        }
    }
}

/// Neighbouring places beyond the tolerance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Region {
    /// Largest distance from the surface of the design, mm, and its place.
    pub(crate) deviation_mm: f64,
    pub(crate) place_mm: [f64; 3],
    /// Size of the box around the region, mm.
    pub(crate) size_mm: [f64; 3],
    /// What has cut the place.
    pub(crate) origin: Origin,
}

/// Deviations to one side.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Deviations {
    /// The largest, mm; 0: none.
    pub(crate) largest_mm: f64,
    pub(crate) place_mm: [f64; 3],
    /// Regions beyond the tolerance, the largest first.
    pub(crate) regions: Vec<Region>,
    /// Number of all regions.
    pub(crate) count: u64,
}

/// Result of a comparison.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct DesignComparison {
    pub(crate) gouge: Deviations,
    pub(crate) rest: Deviations,
    /// Number of ends of the material by their distance from the design, from deepest inside to farthest outside.
    pub(crate) histogram: [u64; CLASSES],
    /// Largest distance by which the design exceeds the box of the stock, mm: it is not compared there.
    pub(crate) exceeds_mm: f64,
    /// Lines that enter the design more often than they leave it: they are not compared.
    pub(crate) uneven: u64,
}

impl DesignComparison {
    /// Lines of the program that have cut the regions.
    pub(crate) fn lines(&self) -> impl Iterator<Item = u32> {
        self.gouge.regions.iter().chain(&self.rest.regions).filter_map(|region| match region.origin {
            Origin::Line(line) => Some(line),
            Origin::Blank | Origin::Unknown => None,
        })
    }
}

/// Class of a distance, which is negative inside the design.
fn class(distance: f64) -> usize {
    let above = LIMITS_MM.iter().filter(|limit| distance.abs() > **limit).count();
    if distance < 0.0 { LIMITS_MM.len() - above } else { LIMITS_MM.len() + 1 + above }
}

/// Lower and upper limit of a class, mm.
pub(crate) fn limits_of(class: usize) -> [f64; 2] {
    let at = |edge: usize| match edge.checked_sub(1) {
        None => f64::NEG_INFINITY,
        Some(edge) if edge < LIMITS_MM.len() => -LIMITS_MM[LIMITS_MM.len() - 1 - edge],
        Some(edge) if edge == LIMITS_MM.len() => 0.0,
        Some(edge) => LIMITS_MM.get(edge - LIMITS_MM.len() - 1).copied().unwrap_or(f64::INFINITY),
    };
    [at(class), at(class + 1)]
}

/// An end of a part: a coordinate, and what cut it, or the surface that the part is measured from.
#[derive(Debug, Clone, Copy)]
struct End {
    at: f64,
    /// `None`: the surface of the design.
    origin: Option<Origin>,
}

/// A part of a line with a deviation beyond the tolerance.
#[derive(Debug, Clone, Copy)]
struct Hit {
    deviation: f64,
    at: f64,
    ends: [f64; 2],
    family: usize,
    across: [f64; 2],
    origin: Origin,
}

impl Hit {
    fn place(&self, at: f64) -> [f64; 3] {
        place(self.family, self.across, at)
    }
}

fn place(family: usize, across: [f64; 2], at: f64) -> [f64; 3] {
    let mut place = [0.0; 3];
    (place[family], place[(family + 1) % 3], place[(family + 2) % 3]) = (at, across[0], across[1]);
    place
}

/// The parts of one side, joined to regions while the lines are followed.
struct Parts {
    tolerance: f64,
    found: Deviations,
    hits: Vec<Hit>,
    /// Hits of the same region.
    regions: Groups,
    /// Hits of the last line of each column.
    columns: Vec<Vec<usize>>,
}

impl Parts {
    fn new(tolerance: f64) -> Self {
        Self {
            tolerance,
            found: Deviations::default(),
            hits: Vec::new(),
            regions: Groups::default(),
            columns: Vec::new(),
        }
    }

    fn begin_family(&mut self, columns: usize) {
        self.columns = vec![Vec::new(); columns];
    }

    /// Adds the parts of a line. `slack`: distance along the line at which neighbouring parts are one region.
    fn add_line(&mut self, column: usize, hits: &[Hit], slack: f64, allowance: &dyn Fn(Origin) -> f64) {
        let first = self.hits.len();
        for hit in hits {
            if hit.deviation > self.found.largest_mm {
                (self.found.largest_mm, self.found.place_mm) = (hit.deviation, hit.place(hit.at));
            }
            if hit.deviation > self.tolerance + allowance(hit.origin) {
                self.regions.push();
                self.hits.push(*hit);
            }
        }
        let before = std::mem::replace(&mut self.columns[column], (first..self.hits.len()).collect());
        let beside = if column > 0 { self.columns[column - 1].clone() } else { Vec::new() };
        for hit in first..self.hits.len() {
            for other in before.iter().chain(&beside) {
                let ([low, high], [from, to]) = (self.hits[hit].ends, self.hits[*other].ends);
                if low <= to + slack && from <= high + slack {
                    self.regions.join(hit, *other);
                }
            }
        }
    }

    /// Joins parts of lines in different directions, whose ends are in neighbouring cells.
    fn join_families(&mut self, cell: f64) {
        let mut cells: HashMap<[i64; 3], usize> = HashMap::new();
        for index in 0..self.hits.len() {
            let hit = self.hits[index];
            for at in [hit.at, hit.ends[0], hit.ends[1]] {
                let key = hit.place(at).map(|value| (value / cell).floor() as i64);
                let first = *cells.entry(key).or_insert(index);
                self.regions.join(first, index);
            }
        }
        let keys: Vec<([i64; 3], usize)> = cells.iter().map(|(key, hit)| (*key, *hit)).collect();
        for ([x, y, z], hit) in keys {
            for side in 14..27 {
                let next = [x + side % 3 - 1, y + side / 3 % 3 - 1, z + side / 9 - 1];
                if let Some(other) = cells.get(&next).copied() {
                    self.regions.join(hit, other);
                }
            }
        }
    }

    fn finish(mut self, cell: f64) -> Deviations {
        self.join_families(cell);
        let mut boxes: HashMap<usize, (Hit, [[f64; 3]; 2])> = HashMap::new();
        for index in 0..self.hits.len() {
            let (root, hit) = (self.regions.first(index), self.hits[index]);
            let [low, high] = hit.ends.map(|at| hit.place(at));
            let (worst, size) = boxes.entry(root).or_insert((hit, [low, high]));
            for axis in 0..3 {
                (size[0][axis], size[1][axis]) = (size[0][axis].min(low[axis]), size[1][axis].max(high[axis]));
            }
            // The place is that of the largest; a part without a block of its own has that of the next largest.
            let origin = match (worst.origin, hit.origin) {
                (Origin::Unknown, known) => known,
                (known, Origin::Unknown) => known,
                (_, larger) if hit.deviation > worst.deviation => larger,
                (known, _) => known,
            };
            if hit.deviation > worst.deviation {
                *worst = hit;
            }
            worst.origin = origin;
        }
        let mut regions: Vec<Region> = boxes
            .into_values()
            .map(|(hit, [low, high])| Region {
                deviation_mm: hit.deviation,
                place_mm: hit.place(hit.at),
                size_mm: std::array::from_fn(|axis| high[axis] - low[axis]),
                origin: hit.origin,
            })
            .collect();
        regions.sort_by(|a, b| {
            let place = |region: &Region| region.place_mm;
            let order = place(a).iter().zip(&place(b)).map(|(a, b)| a.total_cmp(b)).find(|order| order.is_ne());
            b.deviation_mm.total_cmp(&a.deviation_mm).then(order.unwrap_or(std::cmp::Ordering::Equal))
        });
        self.found.count = regions.len() as u64;
        regions.truncate(MOST_REGIONS);
        self.found.regions = regions;
        self.found
    }
}

/// Limits of a comparison, mm.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ComparisonLimits {
    /// Depth from which there is a gouge.
    pub(crate) gouge_mm: f64,
    /// Thickness from which there is rest material.
    pub(crate) rest_mm: f64,
    /// Material that is not thicker may be none.
    pub(crate) thin_mm: f64,
}

impl Design {
    /// Number of triangles.
    pub(crate) fn triangles(&self) -> usize {
        self.mesh.triangles()
    }

    /// The design elsewhere.
    pub(crate) fn moved(self, place: &Isometry3<f64>) -> Self {
        Self::new(self.mesh.placed(place))
    }

    pub(crate) fn new(mesh: Mesh) -> Self {
        let surface = TriangleSurface::new(mesh.corners_of_triangles());
        Self { mesh, surface }
    }

    /// Compares a stock. `allowance`: what a cut leaves besides, mm.
    pub(crate) fn compare(
        &self,
        stock: &TriDexel,
        limits: ComparisonLimits,
        allowance: &dyn Fn(Origin) -> f64,
    ) -> DesignComparison {
        let ComparisonLimits { gouge_mm: gouge, rest_mm: rest, thin_mm: thin } = limits;
        let ([low, high], [from, to]) = (stock.corners(), self.mesh.corners());
        let exceeds = (0..3).map(|axis| (low[axis] - from[axis]).max(to[axis] - high[axis])).fold(0.0, f64::max);
        let (mut histogram, mut uneven) = ([0; CLASSES], 0);
        let (mut gouges, mut rests) = (Parts::new(gouge), Parts::new(rest));
        let none = |_: Origin| 0.0;
        let (mut solid, mut hits, mut thick): (Vec<[f64; 2]>, Vec<Hit>, Vec<FilledPart>) = <_>::default();
        for (family, pitch) in stock.pitch().into_iter().enumerate() {
            let mut crossings = self.mesh.lines_through(stock, family);
            let columns = stock.lines(family)[0];
            gouges.begin_family(columns);
            rests.begin_family(columns);
            let mut number = 0;
            stock.each(family, |across, spans| {
                let line = [number % columns, number / columns];
                number += 1;
                solid.clear();
                if !crossings.parts(line, &mut solid) {
                    uneven += 1;
                    return;
                }
                thick.clear();
                thick.extend(spans.iter().filter(|span| f64::from(span.high - span.low) > thin));
                let spans = &thick[..];
                let line_of = StockLine { design: self, family, across, pitch };
                for end in spans.iter().flat_map(|span| [span.low, span.high]) {
                    histogram[class(line_of.signed(f64::from(end), &solid))] += 1;
                }
                hits.clear();
                line_of.missing(spans, &solid, &mut hits);
                gouges.add_line(line[0], &hits, pitch, &none);
                hits.clear();
                line_of.left(spans, &solid, &mut hits);
                rests.add_line(line[0], &hits, pitch, allowance);
            });
        }
        let cell = stock.pitch().into_iter().fold(0.0, f64::max);
        DesignComparison {
            gouge: gouges.finish(cell),
            rest: rests.finish(cell),
            histogram,
            exceeds_mm: exceeds,
            uneven,
        }
    }
}

impl Design {
    /// Distance of each end of a stock from the surface, negative inside; unknown where a line enters more often than
    /// it leaves.
    pub(crate) fn deviations(&self, stock: &TriDexel) -> EndValues {
        let (mut ends, mut solid) = (EndValues::default(), Vec::new());
        for (family, pitch) in stock.pitch().into_iter().enumerate() {
            let mut crossings = self.mesh.lines_through(stock, family);
            let columns = stock.lines(family)[0];
            let mut number = 0;
            stock.each(family, |across, spans| {
                let line = [number % columns, number / columns];
                number += 1;
                solid.clear();
                let even = crossings.parts(line, &mut solid);
                let line_of = StockLine { design: self, family, across, pitch };
                let value = |end: f32| if even { line_of.signed(f64::from(end), &solid) as f32 } else { f32::NAN };
                ends.add(family, spans.iter().flat_map(|span| [span.low, span.high]).map(value));
            });
        }
        ends
    }

    /// Its triangles.
    pub(crate) fn mesh(&self) -> &Mesh {
        &self.mesh
    }
}

/// A line of the stock.
struct StockLine<'a> {
    design: &'a Design,
    family: usize,
    across: [f64; 2],
    pitch: f64,
}

impl StockLine<'_> {
    /// Distance from the surface of the design.
    fn distance(&self, at: f64, solid: &[[f64; 2]]) -> f64 {
        let along = solid.iter().flatten().map(|end| (end - at).abs()).fold(f64::INFINITY, f64::min);
        self.design.surface.distance(place(self.family, self.across, at), along)
    }

    /// Distance from the surface of the design, negative inside.
    fn signed(&self, at: f64, solid: &[[f64; 2]]) -> f64 {
        let inside = solid.iter().any(|[low, high]| *low < at && at < *high);
        let distance = self.distance(at, solid);
        if inside { -distance } else { distance }
    }

    /// Parts of the design without material.
    fn missing(&self, spans: &[FilledPart], solid: &[[f64; 2]], hits: &mut Vec<Hit>) {
        for [low, high] in solid {
            let mut begin = End { at: *low, origin: None };
            // What has cut the line below.
            let mut below = None;
            for span in spans {
                let (from, to) = (f64::from(span.low), f64::from(span.high));
                if from >= *high {
                    if begin.at < *high {
                        let next = Some((from, Origin::of(span.low_id)));
                        self.add([begin, End { at: *high, origin: None }], [below, next], solid, hits);
                        begin.at = *high;
                    }
                    break;
                }
                if to > *low && from > begin.at {
                    let end = End { at: from, origin: Some(Origin::of(span.low_id)) };
                    self.add([begin, end], [below, None], solid, hits);
                }
                below = Some((to, Origin::of(span.high_id)));
                if to > begin.at {
                    begin = End { at: to, origin: Some(Origin::of(span.high_id)) };
                }
            }
            if begin.at < *high {
                self.add([begin, End { at: *high, origin: None }], [below, None], solid, hits);
            }
        }
    }

    /// Parts of the material without design.
    fn left(&self, spans: &[FilledPart], solid: &[[f64; 2]], hits: &mut Vec<Hit>) {
        for span in spans {
            let (from, to) = (f64::from(span.low), f64::from(span.high));
            let ends = [(from, Origin::of(span.low_id)), (to, Origin::of(span.high_id))];
            let mut begin = End { at: from, origin: Some(ends[0].1) };
            let beyond = ends.map(Some);
            for [low, high] in solid.iter().filter(|part| part[1] > from && part[0] < to) {
                if *low > begin.at {
                    self.add([begin, End { at: *low, origin: None }], beyond, solid, hits);
                }
                begin = End { at: *high, origin: None };
            }
            if begin.at < to {
                self.add([begin, End { at: to, origin: Some(ends[1].1) }], beyond, solid, hits);
            }
        }
    }

    /// Adds a part. `beyond`: the ends of material below and above it, for a part that has none of its own.
    fn add(&self, ends: [End; 2], beyond: [Option<(f64, Origin)>; 2], solid: &[[f64; 2]], hits: &mut Vec<Hit>) {
        let [low, high] = ends;
        let distances = ends.map(|end| if end.origin.is_some() { self.distance(end.at, solid) } else { 0.0 });
        let nearer = || {
            let gap = |side: usize| beyond[side].map_or(f64::INFINITY, |(at, _)| (at - ends[side].at).abs());
            let side = usize::from(gap(1) < gap(0));
            beyond[side].map_or(Origin::Unknown, |(_, origin)| origin)
        };
        let (deviation, at, origin) = match (low.origin, high.origin) {
            (None, None) => {
                let (deviation, at) = self.middle([low.at, high.at], solid);
                (deviation, at, nearer())
            }
            (Some(origin), _) if distances[0] >= distances[1] => (distances[0], low.at, origin),
            (Some(origin), None) => (distances[0], low.at, origin),
            (_, Some(origin)) => (distances[1], high.at, origin),
        };
        let ends = [low.at, high.at];
        hits.push(Hit { deviation, at, ends, family: self.family, across: self.across, origin });
    }

    /// Largest distance from the surface between two places on it: a place is not nearer to it by more than its
    /// distance from another, so parts that cannot have a larger one are left out.
    fn middle(&self, [low, high]: [f64; 2], solid: &[[f64; 2]]) -> (f64, f64) {
        let mut open = vec![[low, 0.0, high, 0.0]];
        let (mut best, mut best_at) = (0.0, f64::midpoint(low, high));
        let most = |[from, one, to, two]: &[f64; 4]| 0.5 * (one + two + to - from);
        for count in 0..MOST_PLACES {
            let Some(index) = (0..open.len()).max_by(|a, b| most(&open[*a]).total_cmp(&most(&open[*b]))) else { break };
            let [from, one, to, two] = open.swap_remove(index);
            let slack = (0.25 * self.pitch).max(0.05 * best);
            if count > 0 && most(&[from, one, to, two]) <= best + slack {
                break;
            }
            let at = 0.5 * (from + to + two - one);
            let distance = self.distance(at, solid);
            if distance > best {
                (best, best_at) = (distance, at);
            }
            open.extend([[from, one, at, distance], [at, distance, to, two]]);
        }
        (best, best_at)
    }
}
