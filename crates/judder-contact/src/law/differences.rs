//! How far every knot is from the polynomial through its neighbours.

use judder_numerics::order::sort_numbers;

/// Knots to each side whose differences count for a knot: one difference alone may be small by chance.
const REACH: usize = 2;

/// For each knot the largest of the differences about it between a knot and the polynomial through its neighbours, two to each side (one
/// where there are fewer than five knots), and no less than half of all differences are; `None` of fewer than three knots.
pub(crate) fn differences(places: &[f64], values: &[f64]) -> Option<Vec<f64>> {
    let count = places.len();
    let side = if count < 5 { 1 } else { 2 };
    if count < 3 {
        return None;
    }
    let inner = side..count - side;
    let of = |k: usize| {
        let others: Vec<usize> = (k - side..=k + side).filter(|other| *other != k).collect();
        (values[k] - through(places, values, &others, places[k])).abs()
    };
    let all: Vec<f64> = inner.clone().map(of).collect();
    let mut sorted = all.clone();
    sort_numbers(&mut sorted);
    let median = sorted[sorted.len() / 2];
    let about = |k: usize| {
        // what stands nearer to an end than any difference takes those nearest to it
        let nearest = k.clamp(inner.start, inner.end - 1) - inner.start;
        let near = nearest.saturating_sub(REACH)..(nearest + REACH + 1).min(all.len());
        all[near].iter().copied().fold(median, f64::max)
    };
    Some((0..count).map(about).collect())
}

/// Lagrange's polynomial through some of the knots, at a place.
fn through(places: &[f64], values: &[f64], knots: &[usize], at: f64) -> f64 {
    let weight = |own: usize| -> f64 {
        let factor = |other: usize| (at - places[other]) / (places[own] - places[other]);
        knots.iter().filter(|other| **other != own).map(|other| factor(*other)).product()
    };
    knots.iter().map(|own| values[*own] * weight(*own)).sum()
}
