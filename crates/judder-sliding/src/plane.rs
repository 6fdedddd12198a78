//! Vectors of the plane, and places that follow each other in it.

use crate::SlidingError;

/// A place or direction of the plane.
pub type PlaneVector = [f64; 2];

/// a·b.
#[inline(always)]
#[must_use]
pub fn dot(a: PlaneVector, b: PlaneVector) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// a + factor b.
#[inline(always)]
#[must_use]
pub fn plus(a: PlaneVector, factor: f64, b: PlaneVector) -> PlaneVector {
    [a[0] + factor * b[0], a[1] + factor * b[1]]
}

/// a − b.
#[inline(always)]
#[must_use]
pub fn minus(a: PlaneVector, b: PlaneVector) -> PlaneVector {
    [a[0] - b[0], a[1] - b[1]]
}

/// |a|.
#[inline(always)]
#[must_use]
pub fn length(a: PlaneVector) -> f64 {
    dot(a, a).sqrt()
}

/// Turned by 90°, counter-clockwise.
#[inline(always)]
#[must_use]
pub fn turned(a: PlaneVector) -> PlaneVector {
    [-a[1], a[0]]
}

/// Distances of an edge's nodes from the first along the line to the last, in m, and that line's direction.
///
/// # Errors
/// [`SlidingError::ShortTrack`]; [`SlidingError::Unordered`] where a node does not lie beyond the one before.
pub fn along_chord(places: &[PlaneVector]) -> Result<(Vec<f64>, PlaneVector), SlidingError> {
    let [first, .., last] = places else {
        return Err(SlidingError::ShortTrack { found: places.len() });
    };
    let chord = minus(*last, *first);
    let direction = [chord[0] / length(chord), chord[1] / length(chord)];
    for (node, pair) in places.windows(2).enumerate() {
        let step = minus(pair[1], pair[0]);
        let along = dot(step, direction);
        if along <= 0.0 || along.is_nan() {
            let angle_deg = libm::atan2(dot(step, turned(direction)), along).to_degrees().abs();
            let [x, y] = pair[0];
            return Err(SlidingError::Unordered { node, angle_deg, x, y });
        }
    }
    Ok((places.iter().map(|place| dot(minus(*place, *first), direction)).collect(), direction))
}
