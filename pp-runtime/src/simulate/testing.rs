//! Machines, tools and random motions of the tests of virtual machining.
//!
//! Each of these changes was made, and the tests named failed:
//!
//! | change | tests that fail |
//! |---|---|
//! | slope along the line at the best sample, not of the mixed tangent planes | random, grazing, swinging, stock, machines |
//! | rotation of the axis left out of the step along the line | the same |
//! | rotation of the axis left out of the bound along the block | random, swinging, stock, machines |
//! | a line given up after a few steps, not divided | random, grazing, swinging, stock, machines |
//! | a step that gets no further taken for no contact | random, grazing, stock, machines |
//! | a block that cannot be certified left as it is, not divided | random, grazing, swinging, stock, machines |
//! | the sweep taken for whole between its two entries | swinging |
//! | distance from the programmed line instead of the motion in step with the block | machines |
//! | length along a line of the stock instead of the distance from the closest point | `design`, scallops of a raster, posting, set-ups |
//! | tolerance of the design's triangles not added, to gouges or to rest | `the_tolerance_of_the_triangles_of_the_design_is_added` |
//! | a rapid whose axes arrive in any order taken for straight | `the_box_of_a_rapid_whose_axes_arrive_in_any_order_is_compared` |
//! | a concave tool by its first piece alone | `a_barrel_leaves_its_flank_on_a_wall` |
//!
//! random, grazing, swinging, stock: tests of `removal` by these words; machines: `what_blocks_of_four_machines_cut_..`
//! of `program`; posting, set-ups: files of `cli/tests/simulate`.

use std::f64::consts::{PI, TAU};

use nalgebra::{Point3, UnitVector3, Vector3};

use super::bodies::{Mesh, block};
use super::removal::{Contact, Cutter, SweptPiece, TriDexel};
use crate::kinematics::{AnyMachine, Pose};

/// Tolerance of the removal, mm.
pub(super) const EPS: f64 = 1e-3;

/// One shape of each kind.
pub(super) const CUTTERS: [Cutter; 9] = [
    Cutter::Mill { radius: 3.0, corner: 0.0, taper: 0.0, length: 14.0 },
    Cutter::Mill { radius: 3.0, corner: 0.8, taper: 0.0, length: 14.0 },
    Cutter::Mill { radius: 3.0, corner: 3.0, taper: 0.0, length: 14.0 },
    Cutter::Mill { radius: 1.5, corner: 0.5, taper: 0.15, length: 12.0 },
    Cutter::Drill { radius: 2.5, point: 118.0 * PI / 180.0, length: 15.0 },
    Cutter::Drill { radius: 3.0, point: PI / 3.0, length: 6.0 },
    Cutter::Disc { radius: 5.0, corner: 0.4, length: 2.0 },
    Cutter::Lollipop { radius: 2.5 },
    Cutter::Barrel { radius: 4.0, corner: 1.0, side: 40.0, length: 16.0 },
];

crate::machine! {
    struct Spinner;
    chain: C B | X Y Z;
    d = (0, 0, 50);
}

crate::machine! {
    struct Inclined;
    chain: C B | X Y Z;
    axes = { B: Rx(-45 deg) * Y };
    d = (0, 0, 40);
}

crate::machine! {
    struct TestHead;
    chain: X | Y Z B A;
}

crate::machine! {
    struct FourAxes;
    chain: A Y | X Z;
    signs = { A: -, Y: - };
}

/// A table, a table with an inclined axis, a head, and four axes with reversed signs.
pub(super) fn machines() -> [Box<dyn AnyMachine>; 4] {
    [
        Box::new(Spinner::default()),
        Box::new(Inclined::default()),
        Box::new(TestHead::default()),
        Box::new(FourAxes::default()),
    ]
}

/// Number of random sweeps: so many, or `PP_SWEEPS`.
pub(super) fn rounds(few: usize) -> usize {
    std::env::var("PP_SWEEPS").ok().and_then(|count| count.parse().ok()).unwrap_or(few)
}

/// Places of a block that are sampled: so many, or 2000 with `PP_SWEEPS`.
pub(super) fn places(few: u32) -> u32 {
    if std::env::var_os("PP_SWEEPS").is_some() { 2000 } else { few }
}

/// Random numbers, the same in each run.
pub(super) struct Random(pub(super) u64);

impl Random {
    pub(super) fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub(super) fn within(&mut self, size: f64) -> f64 {
        size * (2.0 * self.unit() - 1.0)
    }

    pub(super) fn direction(&mut self) -> Vector3<f64> {
        loop {
            let v = Vector3::new(self.within(1.0), self.within(1.0), self.within(1.0));
            if v.norm() > 0.2 && v.norm() < 1.0 {
                return v.normalize();
            }
        }
    }
}

pub(super) fn pose(tip: [f64; 3], axis: Vector3<f64>) -> Pose {
    Pose { tip: Point3::from(tip), axis: UnitVector3::new_normalize(axis) }
}

pub(super) fn upright(tip: [f64; 3]) -> Pose {
    pose(tip, Vector3::z())
}

pub(super) fn cut_by_two_threads(stock: &mut TriDexel, pieces: &[SweptPiece], cutter: &Cutter) -> f64 {
    let contacts = stock.cut(pieces, &cutter.pieces().expect("a tool"), EPS, 2);
    contacts.iter().map(Contact::volume).sum()
}

/// A body of revolution about Z with rounded sides, as triangles.
pub(super) fn barrel(rings: u32, sides: u32) -> (Vec<[f64; 3]>, Vec<[u32; 3]>) {
    let (mut vertices, mut faces) = (vec![[0.0, 0.0, -5.0], [0.0, 0.0, 5.0]], Vec::new());
    let at = |ring: u32, side: u32| 2 + ring * sides + side % sides;
    for ring in 0..=rings {
        let z = -5.0 + 10.0 * f64::from(ring) / f64::from(rings);
        let radius = 6.0 - 0.04 * z * z;
        for side in 0..sides {
            let (sine, cosine) = (TAU * f64::from(side) / f64::from(sides)).sin_cos();
            vertices.push([radius * cosine, radius * sine, z]);
        }
    }
    for side in 0..sides {
        faces.push([0, at(0, side + 1), at(0, side)]);
        faces.push([1, at(rings, side), at(rings, side + 1)]);
        for ring in 0..rings {
            faces.push([at(ring, side), at(ring, side + 1), at(ring + 1, side + 1)]);
            faces.push([at(ring, side), at(ring + 1, side + 1), at(ring + 1, side)]);
        }
    }
    (vertices, faces)
}

pub(super) fn box_mesh(corners: [[f64; 3]; 2]) -> Mesh {
    let (vertices, faces) = block(corners);
    Mesh::new(vertices, faces).expect("a closed body")
}
