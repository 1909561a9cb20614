//! Tools of revolution as convex pieces.
//!
//! A piece is described in the meridian plane: `rho`, the distance from the tool axis, and `h`, the height above the
//! tip. It is a wedge of two lines that meet in a vertex, grown by a rounding radius, between two heights:
//!
//! ```text
//! f(rho, h) = max(wedge(rho - vertex, h - vertex) - round, low - h, h - high)
//! ```
//!
//! `wedge` is the signed distance from the wedge. `f` never falls with `rho`, it is convex and changes by no more than
//! the distance: so is the function of space that it makes when it is rotated about the axis. Where `f` is zero the
//! surface is exact; outside a corner between the wedge and a height, or at the point of a cone, `f` is less than the
//! distance from the body, by no more than the factor [`Profile::sharpness`].
//!
//! A tool that is not convex is the union of its pieces, and its sweep is the union of theirs.

use std::f64::consts::FRAC_PI_2;

/// Smallest half angle of a point, rad.
const SHARPEST: f64 = 0.017;

/// A tool cannot be smaller than this, mm.
const SMALLEST_MM: f64 = 1e-3;

/// A convex piece of a tool.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Profile {
    /// Vertex of the wedge.
    pub(super) vertex: [f64; 2],
    /// Outward normals of its two lines, the lower one first.
    pub(super) normals: [[f64; 2]; 2],
    /// Directions of these lines from the vertex into the wedge.
    pub(super) edges: [[f64; 2]; 2],
    pub(super) round: f64,
    /// Height below which the piece has nothing, or -∞.
    pub(super) low: f64,
    /// Height above which it has nothing.
    pub(super) high: f64,
    /// Largest distance of its points from the axis.
    pub(super) radius: f64,
    /// Lowest height of its points.
    pub(super) bottom: f64,
    /// Largest distance of its points from the tip.
    pub(crate) reach: f64,
    /// Smallest ratio of `f` to the distance from the body, outside it.
    pub(super) sharpness: f64,
}

/// Shape of the cutting part of a tool, lengths in mm, angles in rad.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Cutter {
    /// Flat (`corner` 0), bull or ball end (`corner` is the radius); its side may be inclined.
    Mill {
        /// Radius at the end of the tool: for a tapered mill that of the circle in which the lines of end and side
        /// meet.
        radius: f64,
        /// Corner radius.
        corner: f64,
        /// Angle of the side from the axis; above 0 the tool is thicker above.
        taper: f64,
        /// Length of the cutting edges.
        length: f64,
    },
    /// A drill, a countersink, or an engraving tool.
    Drill {
        /// Radius.
        radius: f64,
        /// Angle of the point, between its two sides.
        point: f64,
        /// Length of the cutting edges, point included.
        length: f64,
    },
    /// A disc on a thinner neck: T-slot, side mill.
    Disc {
        /// Radius of the disc.
        radius: f64,
        /// Radius of its lower corner.
        corner: f64,
        /// Thickness.
        length: f64,
    },
    /// A ball on a thinner neck.
    Lollipop {
        /// Radius of the ball.
        radius: f64,
    },
    /// A side of a large radius over a ball or bull end.
    Barrel {
        /// Largest radius of the tool.
        radius: f64,
        /// Radius of the end.
        corner: f64,
        /// Radius of the side in the meridian plane.
        side: f64,
        /// Length of the cutting edges.
        length: f64,
    },
}

/// The reason why a tool has no shape.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct ShapeFault(String);

impl Profile {
    const UNMEASURED: Self = Self {
        vertex: [0.0; 2],
        normals: [[0.0; 2]; 2],
        edges: [[0.0; 2]; 2],
        round: 0.0,
        low: f64::NEG_INFINITY,
        high: 0.0,
        radius: 0.0,
        bottom: 0.0,
        reach: 0.0,
        sharpness: 1.0,
    };

    fn wedge(vertex: [f64; 2], normals: [[f64; 2]; 2], round: f64, [low, high]: [f64; 2]) -> Self {
        let [first, second] = normals;
        let edges = [[first[1], -first[0]], [-second[1], second[0]]];
        Self { vertex, normals, edges, round, low, high, ..Self::UNMEASURED }.measured()
    }

    /// A circle about a point of the meridian plane, of which no more than the part between two heights is there.
    fn disc(centre: [f64; 2], round: f64, heights: [f64; 2]) -> Self {
        let inwards = [-1.0, 0.0];
        let normals = [[0.0, -1.0], [0.0, 1.0]];
        let [low, high] = heights;
        Self { vertex: centre, normals, edges: [inwards; 2], round, low, high, ..Self::UNMEASURED }.measured()
    }

    /// A cylinder.
    #[must_use]
    pub fn cylinder(radius: f64, heights: [f64; 2]) -> Self {
        let [low, high] = heights;
        Self::wedge([radius, low], [[0.0, -1.0], [1.0, 0.0]], 0.0, [f64::NEG_INFINITY, high])
    }

    /// A frustum: radii at two heights.
    #[must_use]
    pub fn frustum(radii: [f64; 2], heights: [f64; 2]) -> Self {
        let ([r0, r1], [low, high]) = (radii, heights);
        let length = (r1 - r0).hypot(high - low);
        let normal = [(high - low) / length, (r0 - r1) / length];
        if r0 > 0.0 || r1 <= 0.0 {
            Self::wedge([r0, low], [[0.0, -1.0], normal], 0.0, [f64::NEG_INFINITY, high])
        } else {
            Self::wedge([r1, high], [normal, [1.0, 0.0]], 0.0, [f64::NEG_INFINITY, high])
        }
    }

    /// Largest distance of its points from the axis, mm.
    pub(crate) fn radius(&self) -> f64 {
        self.radius
    }

    /// The outline as a convex polygon of radii and heights from the axis to the axis, no farther from it than a
    /// distance.
    pub(crate) fn polygon(&self, chord_mm: f64) -> Vec<[f64; 2]> {
        let at = |h: f64| [self.outline(h).unwrap_or(0.0), h];
        let ends = [at(self.bottom), at(self.high)];
        let mut polygon = vec![[0.0, self.bottom], ends[0]];
        self.refine(ends[0], ends[1], chord_mm, 14, &mut polygon);
        polygon.push([0.0, self.high]);
        polygon.dedup_by(|a, b| (a[0] - b[0]).abs() < 1e-9 && (a[1] - b[1]).abs() < 1e-9);
        polygon
    }

    /// Adds the outline between two of its points. It is concave: nowhere is it farther from the chord than twice as
    /// far as in the middle.
    fn refine(&self, from: [f64; 2], to: [f64; 2], chord_mm: f64, halvings: u32, polygon: &mut Vec<[f64; 2]>) {
        let h = f64::midpoint(from[1], to[1]);
        let middle = [self.outline(h).unwrap_or(0.0), h];
        let length = (to[0] - from[0]).hypot(to[1] - from[1]);
        let off = (middle[0] - f64::midpoint(from[0], to[0])).abs() * (to[1] - from[1]) / length.max(1e-12);
        if 2.0 * off > chord_mm && halvings > 0 {
            self.refine(from, middle, chord_mm, halvings - 1, polygon);
            self.refine(middle, to, chord_mm, halvings - 1, polygon);
        } else {
            polygon.push(to);
        }
    }

    /// Fills in what follows from the shape.
    fn measured(mut self) -> Self {
        self.bottom = self.lowest();
        self.radius = self.widest();
        self.reach = self.radius.hypot(self.high.abs().max(self.bottom.abs()));
        self.sharpness = self.sharpest();
        self
    }

    /// Radius of the outline at a height; `None` where there is nothing.
    fn outline(&self, h: f64) -> Option<f64> {
        if h < self.low || h > self.high || self.distance(0.0, h).0 > 0.0 {
            return None;
        }
        let (mut inside, mut outside) = (0.0, 1.0);
        while self.distance(outside, h).0 <= 0.0 {
            outside *= 2.0;
        }
        for _ in 0..60 {
            let middle = f64::midpoint(inside, outside);
            if self.distance(middle, h).0 <= 0.0 { inside = middle } else { outside = middle }
        }
        Some(outside)
    }

    /// Lowest height of the piece.
    fn lowest(&self) -> f64 {
        // On the axis, where a convex body of revolution is lowest.
        let (mut outside, mut inside) = (self.high - 1e4, self.high);
        for _ in 0..80 {
            let middle = f64::midpoint(outside, inside);
            if self.distance(0.0, middle).0 > 0.0 { outside = middle } else { inside = middle }
        }
        inside
    }

    fn widest(&self) -> f64 {
        let (mut from, mut to) = (self.bottom, self.high);
        let at = |h: f64| self.outline(h).unwrap_or(0.0);
        let ends = at(from).max(at(to));
        // The outline is concave.
        for _ in 0..80 {
            let third = (to - from) / 3.0;
            if at(from + third) < at(to - third) { from += third } else { to -= third }
        }
        at(from).max(at(to)).max(ends) + 1e-9
    }

    /// The sharpest corner: where the normals of two faces that meet differ by `d`, the distance from the corner is at
    /// most `1 / cos(d/2)` times the larger distance from the faces.
    fn sharpest(&self) -> f64 {
        let half = |a: [f64; 2], b: [f64; 2]| ((1.0 + a[0] * b[0] + a[1] * b[1]) / 2.0).max(0.0).sqrt();
        let normal = |rho: f64, h: f64| {
            let (_, along, up) = self.wedge_distance(rho, h);
            [along, up]
        };
        let mut least: f64 = 1.0;
        if let Some(rho) = self.outline(self.high) {
            least = least.min(half(normal(rho, self.high), [0.0, 1.0]));
        }
        if let Some(rho) = Some(self.low).filter(|low| low.is_finite()).and_then(|low| self.outline(low)) {
            least = least.min(half(normal(rho, self.low), [0.0, -1.0]));
        }
        let [along, up] = normal(1e-9, self.bottom);
        // The point of a cone: its normal and the mirrored one.
        least = least.min(half([along, up], [-along, up]));
        least.max(SHARPEST.sin())
    }

    /// Distance from the rounded wedge, and its gradient.
    #[inline]
    fn wedge_distance(&self, rho: f64, h: f64) -> (f64, f64, f64) {
        let (x, y) = (rho - self.vertex[0], h - self.vertex[1]);
        let [first, second] = self.normals;
        let beyond = |edge: [f64; 2]| x * edge[0] + y * edge[1] < 0.0;
        if beyond(self.edges[0]) && beyond(self.edges[1]) {
            let size = x.hypot(y).max(1e-12);
            return (size - self.round, x / size, y / size);
        }
        let [d0, d1] = [first, second].map(|normal| x * normal[0] + y * normal[1]);
        if d0 > d1 { (d0 - self.round, first[0], first[1]) } else { (d1 - self.round, second[0], second[1]) }
    }

    /// `f` with its derivatives by `rho` and by `h`.
    #[must_use]
    #[inline]
    pub fn distance(&self, rho: f64, h: f64) -> (f64, f64, f64) {
        let (mut value, mut along, mut up) = self.wedge_distance(rho, h);
        if h - self.high > value {
            (value, along, up) = (h - self.high, 0.0, 1.0);
        }
        if self.low - h > value {
            (value, along, up) = (self.low - h, 0.0, -1.0);
        }
        (value, along, up)
    }
}

impl Cutter {
    /// The convex pieces of the cutting part.
    ///
    /// # Errors
    /// A sentence about numbers that describe no tool.
    pub fn pieces(&self) -> Result<Vec<Profile>, ShapeFault> {
        let fault = |text: String| Err(ShapeFault(text));
        let none = f64::NEG_INFINITY;
        let (radius, length) = (self.radius(), self.length());
        if !(radius >= SMALLEST_MM && radius.is_finite()) {
            return fault(format!("a radius of {radius} mm is no tool"));
        }
        if !(length >= SMALLEST_MM && length.is_finite()) {
            return fault(format!("a cutting length of {length} mm is no tool"));
        }
        Ok(match *self {
            Self::Mill { corner, .. } if !(corner >= 0.0 && corner.is_finite()) => {
                return fault(format!("{corner} mm is no corner radius"));
            }
            Self::Disc { corner, .. } | Self::Barrel { corner, .. }
                if !(0.0..=radius * (1.0 + 1e-9)).contains(&corner) =>
            {
                return fault(format!("a corner radius of {corner} mm does not fit a radius of {radius} mm"));
            }
            Self::Mill { taper, .. } if taper.is_nan() || taper.abs() >= FRAC_PI_2 - SHARPEST => {
                return fault(format!("a side inclined by {} degrees is none", taper.to_degrees()));
            }
            Self::Mill { corner, taper, .. } if corner > length => {
                return fault(format!(
                    "a cutting length of {length} mm is less than the corner radius of {corner} mm (taper {} degrees)",
                    taper.to_degrees()
                ));
            }
            Self::Mill { corner, taper, .. } => {
                let (sine, cosine) = taper.sin_cos();
                // The circle that touches the end and the side.
                let centre = radius - corner * (1.0 - sine) / cosine;
                if centre < -1e-9 {
                    return fault(format!(
                        "a corner radius of {corner} mm does not fit a radius of {radius} mm with a taper of {} degrees",
                        taper.to_degrees()
                    ));
                }
                let normals = [[0.0, -1.0], [cosine, -sine]];
                vec![Profile::wedge([centre.max(0.0), corner], normals, corner, [none, length])]
            }
            Self::Drill { point, .. } if !(2.0 * SHARPEST..=std::f64::consts::PI).contains(&point) => {
                return fault(format!("a point of {} degrees is none", point.to_degrees()));
            }
            Self::Drill { point, .. } => {
                let (sine, cosine) = (point / 2.0).sin_cos();
                vec![Profile::wedge(
                    [radius, radius * cosine / sine],
                    [[cosine, -sine], [1.0, 0.0]],
                    0.0,
                    [none, length],
                )]
            }
            Self::Disc { corner, .. } if corner > length => {
                return fault(format!("a disc of {length} mm has no corner radius of {corner} mm"));
            }
            Self::Disc { corner, .. } => {
                vec![Profile::wedge([radius - corner, corner], [[0.0, -1.0], [1.0, 0.0]], corner, [none, length])]
            }
            Self::Lollipop { .. } => vec![Profile::disc([0.0, radius], radius, [none, 2.0 * radius])],
            Self::Barrel { corner, side, .. } if side < radius || side <= corner => {
                return fault(format!("a side of {side} mm is no barrel on a radius of {radius} mm"));
            }
            Self::Barrel { corner, side, .. } => {
                // The circle of the side touches that of the end from outside, and is widest at the radius of the tool.
                let (end, across) = (radius - side, side - corner);
                let from_end = (across * across - end * end).max(0.0).sqrt();
                let centre = [end, corner + from_end];
                // They touch on the line through both centres; that of the end is on the axis.
                let touch = corner - corner * from_end / across;
                let nose = Profile::disc([0.0, corner], corner, [none, length.min(2.0 * corner)]);
                if length <= touch {
                    return fault(format!("a cutting length of {length} mm ends below the side of the barrel"));
                }
                vec![nose, Profile::disc(centre, side, [touch, length])]
            }
        })
    }

    /// Largest radius of the cutting part at its end.
    #[must_use]
    pub fn radius(&self) -> f64 {
        match *self {
            Self::Mill { radius, .. }
            | Self::Drill { radius, .. }
            | Self::Disc { radius, .. }
            | Self::Lollipop { radius }
            | Self::Barrel { radius, .. } => radius,
        }
    }

    /// Height of the cutting part above the tip.
    #[must_use]
    pub fn length(&self) -> f64 {
        match *self {
            Self::Mill { length, .. }
            | Self::Drill { length, .. }
            | Self::Disc { length, .. }
            | Self::Barrel { length, .. } => length,
            Self::Lollipop { radius } => 2.0 * radius,
        }
    }
}
