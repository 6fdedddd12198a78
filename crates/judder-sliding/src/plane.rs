//! Vectors of the plane.

/// A place or direction of the plane.
pub type Vector = [f64; 2];

#[inline(always)]
pub(crate) fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// a + factor b.
#[inline(always)]
pub(crate) fn plus(a: Vector, factor: f64, b: Vector) -> Vector {
    [a[0] + factor * b[0], a[1] + factor * b[1]]
}

#[inline(always)]
pub(crate) fn minus(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1]]
}

#[inline(always)]
pub(crate) fn length(a: Vector) -> f64 {
    dot(a, a).sqrt()
}

/// Turned by 90°, counter-clockwise.
#[inline(always)]
pub(crate) fn turned(a: Vector) -> Vector {
    [-a[1], a[0]]
}
