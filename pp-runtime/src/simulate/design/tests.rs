//! Comparison with a design, with known answers.

use nalgebra::Vector3;

use super::comparison::{ComparisonLimits, Design, DesignComparison, Origin, limits_of};
use super::nearest::TriangleSurface;
use crate::simulate::bodies::Mesh;
use crate::simulate::removal::{Cutter, SweptPiece, TriDexel};
use crate::simulate::testing::{Random, barrel, box_mesh, cut_by_two_threads, upright};

/// A comparison without allowances.
fn against(design: &Design, stock: &TriDexel, tolerances: (f64, f64)) -> DesignComparison {
    let limits = ComparisonLimits { gouge_mm: tolerances.0, rest_mm: tolerances.1, thin_mm: 0.0 };
    design.compare(stock, limits, &|_| 0.0)
}

/// A block on Z0 with another one on it, as one closed body; the upper one is narrower on all sides.
fn stepped([lower, upper]: [[f64; 3]; 2], height: f64) -> Mesh {
    let mut vertices = Vec::new();
    for [half_x, half_y, z] in
        [[lower[0], lower[1], 0.0], lower, [upper[0], upper[1], lower[2]], [upper[0], upper[1], height]]
    {
        vertices.extend([[-half_x, -half_y, z], [half_x, -half_y, z], [half_x, half_y, z], [-half_x, half_y, z]]);
    }
    let mut faces = vec![[0, 2, 1], [0, 3, 2], [12, 13, 14], [12, 14, 15]];
    for level in [0, 4, 8] {
        for side in 0..4 {
            let [a, b] = [level + side, level + (side + 1) % 4];
            faces.extend([[a, b, b + 4], [a, b + 4, a + 4]]);
        }
    }
    Mesh::new(vertices, faces).expect("a closed body")
}

#[test]
fn the_distance_from_a_surface_is_that_of_its_closest_triangle() {
    let (vertices, faces) = barrel(4, 12);
    let corners = |face: &[u32; 3]| face.map(|index| vertices[index as usize]);
    let surface = TriangleSurface::new(faces.iter().map(corners).collect());
    let mut random = Random(7);
    for _ in 0..40 {
        let point = [random.within(9.0), random.within(9.0), random.within(9.0)];
        // Each triangle on its own: the best of a grid of its points, each of which is refined around the best.
        let mut least = f64::INFINITY;
        for [a, b, c] in faces.iter().map(corners) {
            let (a, ab, ac) =
                (Vector3::from(a), Vector3::from(b) - Vector3::from(a), Vector3::from(c) - Vector3::from(a));
            let (mut best, mut size) = ([1.0 / 3.0; 2], 0.5);
            let distance = |[s, t]: [f64; 2]| (a + ab * s + ac * t - Vector3::from(point)).norm();
            for _ in 0..24 {
                let [s, t] = best;
                for step in 0..25 {
                    let s = (s + size * (f64::from(step % 5) / 2.0 - 1.0)).clamp(0.0, 1.0);
                    let t = (t + size * (f64::from(step / 5) / 2.0 - 1.0)).clamp(0.0, 1.0 - s);
                    if distance([s, t]) < distance(best) {
                        best = [s, t];
                    }
                }
                size *= 0.7;
            }
            least = least.min(distance(best));
        }
        let found = surface.distance(point, f64::INFINITY);
        assert!((found - least).abs() < 1e-3 && found < least + 1e-9, "{point:?}: {found} {least}");
        assert!((surface.distance(point, found + 1e-6) - found).abs() < 1e-12);
    }
}

#[test]
fn the_rest_of_a_ball_raster_is_its_scallop() {
    let (radius, step) = (4.0, 1.0);
    let ball = Cutter::Mill { radius, corner: radius, taper: 0.0, length: 20.0 };
    let mut stock = TriDexel::block([[-1.5, -1.5, -2.0], [1.5, 1.5, 2.0]], 0.2).expect("a stock");
    let pass = |pass: u32, z: f64| {
        let y = step * (f64::from(pass) - 3.5);
        SweptPiece::new(&upright([-6.0, y, z]), &upright([6.0, y, z]), 0, pass + 1)
    };
    let passes: Vec<SweptPiece> = (0..8).map(|number| pass(number, 0.0)).collect();
    cut_by_two_threads(&mut stock, &passes, &ball);
    let design = Design::new(box_mesh([[-1.5, -1.5, -2.0], [1.5, 1.5, 0.0]]));
    let height = radius - (radius * radius - step * step / 4.0).sqrt();
    let compared = against(&design, &stock, (0.002, 0.002));
    assert!((compared.rest.largest_mm - height).abs() < 2e-3, "{compared:?} {height}");
    // The deepest of a pass is on the plane.
    assert!(compared.gouge.largest_mm < 2e-3 && compared.gouge.count == 0, "{:?}", compared.gouge);
    // Three crests across the block, and none where the tolerance is larger.
    assert_eq!(compared.rest.count, 3, "{:?}", compared.rest);
    assert_eq!(against(&design, &stock, (0.002, height + 0.002)).rest.count, 0);

    // A pass 0.3 mm too low: its depth, its place and its name.
    cut_by_two_threads(&mut stock, &[pass(4, -0.3)], &ball);
    let gouge = against(&design, &stock, (0.002, 0.1)).gouge;
    let [region] = gouge.regions.as_slice() else { panic!("{gouge:?}") };
    assert!(region.deviation_mm <= 0.3 + 1e-3 && region.deviation_mm > 0.3 - 4e-3, "{region:?}");
    assert_eq!(region.origin, Origin::Line(5));
    assert!((region.place_mm[1] - 0.5).abs() < 0.11 && (region.place_mm[2] + 0.3).abs() < 4e-3, "{region:?}");
}

#[test]
fn a_part_of_the_design_that_is_cut_off_is_a_gouge() {
    // A rib, 2 mm wide and 6 mm high on a plate: a mill takes all of it.
    let sizes = [[10.0, 10.0, 4.0], [1.0, 8.0, 0.0]];
    let design = Design::new(stepped(sizes, 10.0));
    let mut stock = TriDexel::block([[-10.0, -10.0, 0.0], [10.0, 10.0, 10.0]], 0.5).expect("a stock");
    let whole = against(&design, &stock, (0.01, 0.01));
    assert_eq!((whole.gouge.count, whole.rest.count), (0, 1), "{whole:?}");
    let mill = Cutter::Mill { radius: 20.0, corner: 0.0, taper: 0.0, length: 30.0 };
    let piece = SweptPiece::new(&upright([-40.0, 0.0, 4.0]), &upright([40.0, 0.0, 4.0]), 0, 7);
    cut_by_two_threads(&mut stock, &[piece], &mill);
    let cut = against(&design, &stock, (0.01, 0.01));
    assert_eq!((cut.gouge.count, cut.rest.count), (1, 0), "{cut:?}");
    let region = cut.gouge.regions[0];
    // Half its width, in the lines across it and those along it.
    assert!((region.deviation_mm - 1.0).abs() < 1e-6, "{region:?}");
    let wanted = [2.0, 16.0, 6.0];
    assert!((0..3).all(|axis| (region.size_mm[axis] - wanted[axis]).abs() <= 0.5), "{region:?}");
    assert_eq!(region.origin, Origin::Line(7), "{region:?}");
}

#[test]
fn the_histogram_has_each_end_in_its_class() {
    let stock = TriDexel::block([[0.0; 3], [4.0, 4.0, 4.0]], 1.0).expect("a stock");
    // 0.03 mm of material too much on top, 0.3 mm missing on the left.
    let design = Design::new(box_mesh([[-0.3, 0.0, 0.0], [4.0, 4.0, 3.97]]));
    let compared = against(&design, &stock, (0.01, 0.01));
    let ends = |from: f64, to: f64| {
        let is = |class: usize| limits_of(class).iter().zip([from, to]).all(|(limit, end)| (limit - end).abs() < 1e-12);
        compared.histogram[(0..compared.histogram.len()).find(|class| is(*class)).expect("a class")]
    };
    assert_eq!(compared.histogram.iter().sum::<u64>(), 96);
    assert_eq!((ends(0.02, 0.05), ends(-0.5, -0.2)), (16, 16), "{:?}", compared.histogram);
    assert!((compared.exceeds_mm - 0.3).abs() < 1e-9);
    let [gouge, rest] = [&compared.gouge, &compared.rest].map(|found| found.regions[0]);
    assert_eq!((compared.gouge.count, compared.rest.count), (1, 1), "{compared:?}");
    assert_eq!((gouge.origin, rest.origin), (Origin::Blank, Origin::Blank));
}

#[test]
fn each_vertex_of_the_surface_has_the_distance_of_the_ends_around_it() {
    let design = Design::new(box_mesh([[0.0; 3], [20.0, 20.0, 10.0]]));
    let at = |x: f64| upright([x, 10.0, 9.9]);
    let slot = Cutter::Mill { radius: 2.0, corner: 0.0, taper: 0.0, length: 20.0 };
    let mut stock = TriDexel::block([[0.0; 3], [20.0, 20.0, 10.3]], 0.25).expect("a stock");
    cut_by_two_threads(&mut stock, &[SweptPiece::new(&at(-5.0), &at(25.0), 0, 7)], &slot);
    // All lines, and every third one of them.
    for thinned in [stock.thinned(1), stock.thinned(3)] {
        let surface = thinned.marked_surface(&design.deviations(&thinned));
        assert_eq!(surface.values.len(), surface.vertices.len());
        let (mut left, mut cut) = (0, 0);
        for (index, [_, y, z]) in surface.vertices.iter().enumerate() {
            let (value, id) = (surface.values[index], surface.ids[index]);
            let inner = (2.0..18.0).contains(&surface.vertices[index][0]);
            if inner && (y - 10.0).abs() < 1.0 && *z > 5.0 {
                assert!((value + 0.1).abs() < 2e-3 && id == 7, "{y} {z}: {value} by {id}");
                cut += 1;
            }
            if inner && (4.0..7.0).contains(y) && *z > 5.0 {
                assert!((value - 0.3).abs() < 1e-4 && id == 0, "{y} {z}: {value} by {id}");
                left += 1;
            }
        }
        assert!(left > 40 && cut > 40, "{left} {cut}");
    }
}
