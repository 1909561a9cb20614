//! Bodies of triangles and the lines inside.

use super::Mesh;
use crate::simulate::testing::barrel;

#[test]
fn a_mesh_fills_the_lines_that_are_inside() {
    let (vertices, faces) = barrel(12, 48);
    let mesh = Mesh::new(vertices, faces).expect("a closed body");
    let stock = mesh.stock(0.1).expect("a stock");
    for volume in stock.volumes() {
        assert!((volume - mesh.volume()).abs() < 2e-3 * mesh.volume(), "{volume} {}", mesh.volume());
    }
    // Lines that meet vertices and edges exactly: those of a double pyramid, in each direction.
    let tip = |axis: usize, size: f64| std::array::from_fn(|index| if index == axis { size } else { 0.0 });
    let vertices: Vec<[f64; 3]> = (0..6).map(|index| tip(index / 2, if index % 2 == 0 { 6.0 } else { -6.0 })).collect();
    let faces = (0..8_u32).map(|side| {
        let [x, y, z] = [0, 1, 2].map(|axis| 2 * axis + (side >> axis & 1));
        if side.count_ones().is_multiple_of(2) { [x, y, z] } else { [x, z, y] }
    });
    let mesh = Mesh::new(vertices, faces.collect()).expect("a closed body");
    for lines in [1.0, 2.0, 3.0, 4.0, 6.0, 9.0, 12.0, 21.0] {
        let stock = mesh.stock(12.0 / lines).expect("a stock");
        for family in 0..3 {
            stock.each(family, |[u, v], spans| {
                let half = 6.0 - u.abs() - v.abs();
                assert!(spans.len() <= usize::from(half >= 0.0), "{lines} {family} {u} {v}: {spans:?}");
                let length: f64 = spans.iter().map(|span| f64::from(span.high) - f64::from(span.low)).sum();
                assert!((length - 2.0 * half.max(0.0)).abs() < 1e-5, "{lines} {family} {u} {v}: {spans:?}");
            });
        }
    }
}

#[test]
fn a_mesh_that_is_open_inside_out_or_empty_is_refused() {
    let (vertices, faces) = barrel(4, 8);
    let fault = |faces: Vec<[u32; 3]>| Mesh::new(vertices.clone(), faces).expect_err("no body").to_string();
    assert!(fault(faces[1..].to_vec()).contains("it is open: 3 edges have triangles on one side only"));
    assert!(fault(faces.iter().map(|[a, b, c]| [*a, *c, *b]).collect()).contains("face inwards"));
    assert!(fault(Vec::new()).contains("no triangle"));
    assert!(fault(vec![[0, 1, 9999]]).contains("not there"));
    let read = |bytes: &[u8]| Mesh::read(&mut std::io::Cursor::new(bytes)).expect_err("no body").to_string();
    assert!(read(b"PARTNO A").contains("no STL file"));
    let announced = [&[0; 80][..], &4_u32.to_le_bytes(), &[0; 50]].concat();
    assert!(read(&announced).contains("ends before its last triangle"));
    assert!(read(b"").contains("ends before its last triangle"));
    assert!(read(&[0; 84]).contains("no triangle"));
}
