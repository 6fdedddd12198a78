//! From value to value: straight between places, and half a cosine.

use std::f64::consts::PI;

/// Value and slope of a table whose places ascend, straight between them and constant outside; at a corner the slope of the piece above it.
///
/// # Panics
/// Of an empty table, and of one with fewer values than places.
#[must_use]
pub fn straight(places: &[f64], values: &[f64], at: f64) -> (f64, f64) {
    let above = places.partition_point(|place| *place <= at);
    if above == 0 {
        return (values[0], 0.0);
    }
    if above == places.len() {
        return (values[above - 1], 0.0);
    }
    let slope = (values[above] - values[above - 1]) / (places[above] - places[above - 1]);
    (values[above - 1] + slope * (at - places[above - 1]), slope)
}

/// (1 − cos π t/T)/2, from 0 to 1 over the time T, and 1 after it.
#[must_use]
pub fn half_cosine(time: f64, duration: f64) -> f64 {
    if time >= duration { 1.0 } else { 0.5 - 0.5 * libm::cos(PI * time / duration) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_are_straight_between_their_places() {
        let (places, values) = ([0.0, 1.0, 3.0], [1.0, 2.0, 0.0]);
        assert_eq!(straight(&places, &values, -1.0), (1.0, 0.0));
        assert_eq!(straight(&places, &values, 0.5), (1.5, 1.0));
        assert_eq!(straight(&places, &values, 1.0), (2.0, -1.0));
        assert_eq!(straight(&places, &values, 2.0), (1.0, -1.0));
        assert_eq!(straight(&places, &values, 3.0), (0.0, 0.0));
    }

    #[test]
    fn half_a_cosine_rises_from_zero_to_one() {
        assert_eq!((half_cosine(0.0, 2.0), half_cosine(2.0, 2.0), half_cosine(9.0, 2.0)), (0.0, 1.0, 1.0));
        assert!((half_cosine(1.0, 2.0) - 0.5).abs() < 1e-15);
        assert_eq!(half_cosine(0.0, 0.0), 1.0);
    }
}
