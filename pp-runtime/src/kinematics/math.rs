//! Mathematical functions that `core` does not have, from `std` or libm.

/// Square root.
#[must_use]
#[inline]
pub fn sqrt(x: f64) -> f64 {
    #[cfg(feature = "std")]
    return x.sqrt();
    #[cfg(not(feature = "std"))]
    return libm::sqrt(x);
}

/// Four-quadrant arc tangent of `y / x`, in \[-π, π\].
#[must_use]
#[inline]
pub fn atan2(y: f64, x: f64) -> f64 {
    #[cfg(feature = "std")]
    return y.atan2(x);
    #[cfg(not(feature = "std"))]
    return libm::atan2(y, x);
}

/// Sine and cosine.
#[must_use]
#[inline]
pub fn sin_cos(x: f64) -> (f64, f64) {
    #[cfg(feature = "std")]
    return x.sin_cos();
    #[cfg(not(feature = "std"))]
    return libm::sincos(x);
}

/// Magnitude.
#[must_use]
#[inline]
pub fn abs(x: f64) -> f64 {
    x.abs()
}

/// Length of the plane vector `(x, y)`, without protection against overflow.
#[must_use]
#[inline]
pub fn hypot(x: f64, y: f64) -> f64 {
    sqrt(x * x + y * y)
}

/// The angle with the given sine and cosine (any common factor above zero), in (-π, π].
///
/// `atan2` returns -π for a sine of minus zero; here a half turn is always π.
#[must_use]
#[inline]
pub fn angle(sine: f64, cosine: f64) -> f64 {
    let angle = atan2(sine, cosine);
    named_once(angle)
}

/// Replaces -π, and any value that rounds to it, by π.
#[inline]
fn named_once(angle: f64) -> f64 {
    if angle <= -core::f64::consts::PI { core::f64::consts::PI } else { angle }
}

/// The angle half a turn away, in (-π, π].
#[must_use]
#[inline]
pub fn half_turn(angle: f64) -> f64 {
    named_once(if angle > 0.0 { angle - core::f64::consts::PI } else { angle + core::f64::consts::PI })
}

/// The angle with the same sine and the opposite cosine, in (-π, π].
#[must_use]
#[inline]
pub fn mirrored(angle: f64) -> f64 {
    named_once(if angle >= 0.0 { core::f64::consts::PI - angle } else { -core::f64::consts::PI - angle })
}

/// The angle with the same cosine and the opposite sine, in (-π, π].
#[must_use]
#[inline]
pub fn negated(angle: f64) -> f64 {
    if angle >= core::f64::consts::PI { angle } else { -angle }
}
