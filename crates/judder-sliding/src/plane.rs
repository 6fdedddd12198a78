//! Vectors of the plane.

/// A place or direction of the plane.
pub type PlaneVector = [f64; 2];

#[inline(always)]
pub(crate) fn dot(a: PlaneVector, b: PlaneVector) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// a + factor b.
#[inline(always)]
pub(crate) fn plus(a: PlaneVector, factor: f64, b: PlaneVector) -> PlaneVector {
    [a[0] + factor * b[0], a[1] + factor * b[1]]
}

#[inline(always)]
pub(crate) fn minus(a: PlaneVector, b: PlaneVector) -> PlaneVector {
    [a[0] - b[0], a[1] - b[1]]
}

#[inline(always)]
pub(crate) fn length(a: PlaneVector) -> f64 {
    dot(a, a).sqrt()
}

/// Turned by 90°, counter-clockwise.
#[inline(always)]
pub(crate) fn turned(a: PlaneVector) -> PlaneVector {
    [-a[1], a[0]]
}
