//! Rotations of tilted planes, each as the manual of its control has it.
//!
//! Matrices are rows; they take coordinates of the plane to those of the work offset. Angles in degrees.

type Matrix = [[f64; 3]; 3];

/// Rotation about X (0), Y (1) or Z (2).
fn about(axis: usize, degrees: f64) -> Matrix {
    let (sine, cosine) = degrees.to_radians().sin_cos();
    let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
    let mut matrix = [[0.0; 3]; 3];
    matrix[axis][axis] = 1.0;
    matrix[next][next] = cosine;
    matrix[last][last] = cosine;
    matrix[next][last] = -sine;
    matrix[last][next] = sine;
    matrix
}

fn product(left: Matrix, right: Matrix) -> Matrix {
    let entry = |row: usize, column: usize| (0..3).map(|index| left[row][index] * right[index][column]).sum();
    [0, 1, 2].map(|row| [0, 1, 2].map(|column| entry(row, column)))
}

fn product_of([first, second, third]: [Matrix; 3]) -> Matrix {
    product(product(first, second), third)
}

/// G68.2 of Fanuc (B-63784EN, tilted working plane command): I about Z, J about the new X, K about the new Z.
pub(super) fn euler([i, j, k]: [f64; 3]) -> Matrix {
    product_of([about(2, i), about(0, j), about(2, k)])
}

/// G268 of Haas with Q123: about the fixed X, then the fixed Y, then the fixed Z. `PLANE SPATIAL` of Heidenhain is the
/// same.
pub(super) fn fixed([a, b, c]: [f64; 3]) -> Matrix {
    product_of([about(2, c), about(1, b), about(0, a)])
}

/// CYCLE800 of Siemens axis by axis: two bits of the mode name the axis of each angle (1 X, 2 Y, 3 Z), the first angle
/// in the lowest; each rotation is about the axes as the rotations before it have left them.
pub(super) fn axis_by_axis(mode: u32, angles: [f64; 3]) -> Option<Matrix> {
    let axes = [mode & 3, mode >> 2 & 3, mode >> 4 & 3];
    let mut sorted = axes;
    sorted.sort_unstable();
    if sorted != [1, 2, 3] || mode >> 6 != 0 {
        return None;
    }
    Some(product_of([0, 1, 2].map(|index| about(axes[index] as usize - 1, angles[index]))))
}

/// A vector, rotated.
pub(super) fn rotated(matrix: &Matrix, vector: [f64; 3]) -> [f64; 3] {
    matrix.map(|row| row.iter().zip(vector).map(|(entry, component)| entry * component).sum())
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

    fn assert_near(found: [f64; 3], wanted: [f64; 3]) {
        assert_abs_diff_eq!(found[..], wanted[..], epsilon = 1e-12);
    }

    #[test]
    fn a_quarter_turn_about_each_axis_is_right_handed() {
        assert_near(rotated(&about(0, 90.0), [0.0, 1.0, 0.0]), [0.0, 0.0, 1.0]);
        assert_near(rotated(&about(1, 90.0), [0.0, 0.0, 1.0]), [1.0, 0.0, 0.0]);
        assert_near(rotated(&about(2, 90.0), [1.0, 0.0, 0.0]), [0.0, 1.0, 0.0]);
    }

    #[test]
    fn the_conventions_differ_in_their_order() {
        let normal = [0.0, 0.0, 1.0];
        assert_near(rotated(&euler([90.0, 90.0, 0.0]), normal), [1.0, 0.0, 0.0]);
        assert_near(rotated(&fixed([90.0, 0.0, 90.0]), normal), [1.0, 0.0, 0.0]);
        let x_y_z = axis_by_axis(57, [90.0, 0.0, 90.0]).expect("X, the new Y, the new Z");
        assert_near(rotated(&x_y_z, normal), [0.0, -1.0, 0.0]);
        assert_eq!(axis_by_axis(21, [0.0; 3]), None);
    }
}
