//! Elementary 4×4 transformations and their products, as the papers write them.

use super::poly::Poly;
use super::ring::Ring;

/// Three components.
pub type PolyVector = [Poly; 3];

/// Homogeneous 4×4 matrix, rows first.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Matrix(pub [[Poly; 4]; 4]);

impl Matrix {
    /// The unit matrix.
    #[must_use]
    pub fn identity() -> Self {
        Self(std::array::from_fn(|row| {
            std::array::from_fn(|column| if row == column { Poly::one() } else { Poly::zero() })
        }))
    }

    /// `self · other`.
    #[must_use]
    pub fn times(&self, other: &Self, ring: &Ring) -> Self {
        Self(std::array::from_fn(|row| {
            std::array::from_fn(|column| {
                let factors: [Poly; 4] = std::array::from_fn(|index| other.0[index][column].clone());
                ring.dot(&self.0[row], &factors)
            })
        }))
    }

    /// Image of a direction: `self · (v, 0)`.
    #[must_use]
    pub fn rotate(&self, direction: &PolyVector, ring: &Ring) -> PolyVector {
        std::array::from_fn(|row| ring.dot(&self.0[row][..3], direction))
    }

    /// The translation column: `self · (0, 0, 0, 1)`.
    #[must_use]
    pub fn origin(&self) -> PolyVector {
        std::array::from_fn(|row| self.0[row][3].clone())
    }
}

/// `Trans(a, b, c)`.
#[must_use]
pub fn translation(by: &PolyVector) -> Matrix {
    let mut matrix = Matrix::identity();
    for (row, component) in by.iter().enumerate() {
        matrix.0[row][3] = component.clone();
    }
    matrix
}

/// `Rot(n, t)` about a unit vector `n`, with the sine and cosine of `t`:
/// `n nᵀ + (1 - n nᵀ) cos t + [n]× sin t`. For `n` = x, y, z these are the papers' three matrices.
#[must_use]
pub fn rotation(n: &PolyVector, sine: &Poly, cosine: &Poly, ring: &Ring) -> Matrix {
    let mut matrix = Matrix::identity();
    for row in 0..3 {
        for column in 0..3 {
            let along = ring.mul(&n[row], &n[column]);
            let unit = if row == column { Poly::one() } else { Poly::zero() };
            let mut entry = &along + &ring.mul(&(&unit - &along), cosine);
            if row != column {
                // [n]× has -n_z at (x, y), +n_y at (x, z), ...
                let third = 3 - row - column;
                let term = ring.mul(&n[third], sine);
                entry = if (row + 1) % 3 == column { &entry - &term } else { &entry + &term };
            }
            matrix.0[row][column] = entry;
        }
    }
    matrix
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rotation_about_y_is_the_papers_matrix() {
        let mut ring = Ring::default();
        let (s, c) = ring.sin_cos("s", "c");
        let (s, c) = (Poly::from(s), Poly::from(c));
        let y = [Poly::zero(), Poly::one(), Poly::zero()];
        let Matrix(m) = rotation(&y, &s, &c, &ring);
        assert_eq!(m[0][..3], [c.clone(), Poly::zero(), s.clone()]);
        assert_eq!(m[1][..3], y);
        assert_eq!(m[2][..3], [-&s, Poly::zero(), c]);
    }
}
