//! Slow sliding, where theory knows more than contacts that are solved.
//!
//! At rest value and slope over z are exact ([`crate::law::limits`]): the area falls linearly. A contact that is off by a few parts in ten thousand
//! says little of a fall by as much, and a common error of all slow contacts stands against the exact value at rest as a wave of the slope, which the
//! division by the speed makes as large as one likes. So the slowest knots take
//!
//! rest + slope z + b z²,   b from one knot further on,
//!
//! as long as what this leaves out, a term in z³, is less than the error that the slowest contact shows: how far it is from what is exact, beyond a term in z². The error
//! of b's knot falls as z² towards rest.

use crate::law::differences::differences;
use crate::law::knots::Knots;
use crate::law::limits::SpeedLimits;
use crate::law::material::LawMaterial;
use crate::law::quantities::{KnotValues, PerQuantity};

/// For each row the errors of its slowest knots, those that theory gives.
pub(crate) type SlowErrors = PerQuantity<Vec<Vec<f64>>>;

/// Factors of the terms in z² and z³, of the size of the moments of the substrate that go with them.
#[derive(Clone, Copy)]
struct Beyond {
    square: f64,
    cubic: f64,
}

/// Puts theory into the slowest knots of area and friction, and tells its errors there; `limits` are those of each row. The force has no term
/// in z, and solvers know it far better.
pub(crate) fn put_theory(
    scaled: &mut KnotValues,
    speeds: &Knots,
    limits: &[PerQuantity<SpeedLimits>],
    material: &LawMaterial,
) -> SlowErrors {
    let places: Vec<f64> = speeds.iter().collect();
    let [first, second, third, fourth] = [1, 2, 3, 4].map(|power| material.moment(power));
    let rows = |list: &mut Vec<f64>, of: fn(&PerQuantity<SpeedLimits>) -> SpeedLimits, beyond: Beyond| {
        let rows = list.chunks_mut(places.len()).zip(limits);
        rows.map(|(row, limits)| put_into(row, &places, of(limits), beyond)).collect()
    };
    let of_area = Beyond { square: second, cubic: third };
    let of_friction = Beyond { square: third / first, cubic: fourth / first };
    PerQuantity {
        force: Vec::new(),
        area: rows(&mut scaled.area, |limits| limits.area, of_area),
        friction: rows(&mut scaled.friction, |limits| limits.friction, of_friction),
    }
}

fn put_into(row: &mut [f64], places: &[f64], limits: SpeedLimits, beyond: Beyond) -> Vec<f64> {
    let Some(scatter) = differences(places, row) else { return Vec::new() };
    let z = |k: usize| libm::exp(places[k]);
    let first_terms = |k: usize| limits.rest + limits.slope * z(k);
    let of_slowest = (row[0] - first_terms(0)).abs() - beyond.square * z(0) * z(0);
    let is_less = |k: &usize| beyond.cubic * z(*k).powi(3) <= of_slowest;
    let Some(join) = (0..row.len()).take_while(is_less).last() else { return Vec::new() };
    let square = (row[join] - first_terms(join)) / (z(join) * z(join));
    // one contact may be right by chance
    let of_join = scatter[join].max(of_slowest);
    let errors = (0..join).map(|k| of_join * (z(k) / z(join)).powi(2)).collect();
    for (k, value) in row.iter_mut().enumerate().take(join) {
        *value = first_terms(k) + square * z(k) * z(k);
    }
    errors
}

#[cfg(test)]
mod tests {
    use super::*;

    /// −0.64 z + 0.3 z² − 0.1 z³ with an error that all contacts share: the slowest knots have the slope at rest again.
    #[test]
    fn a_common_error_of_slow_contacts_makes_no_wave() {
        let knots = Knots::new("x", 1e-3_f64.ln(), 10_f64.ln(), 29).unwrap();
        let places: Vec<f64> = knots.iter().collect();
        let exact = |x: &f64| {
            let z = x.exp();
            -0.64 * z / (1.0 + 0.5 * z + 0.1 * z * z)
        };
        let limits = SpeedLimits { rest: 0.0, slope: -0.64, infinite: 0.0 };
        let mut row: Vec<f64> = places.iter().map(|x| exact(x) + 1e-3).collect();
        let errors = put_into(&mut row, &places, limits, Beyond { square: 0.35, cubic: 1.0 });
        // as far as the term in z³ is below 1e-3
        assert_eq!(errors.len(), 13);
        for (k, error) in errors.iter().enumerate() {
            assert!((row[k] - exact(&places[k])).abs() < *error, "{k}: {} {}", row[k], exact(&places[k]));
        }
        assert!(row[0] < 0.0 && row[2] < row[1]);
    }

    #[test]
    fn exact_contacts_stay_as_exact() {
        let knots = Knots::new("x", 1e-3_f64.ln(), 10_f64.ln(), 57).unwrap();
        let places: Vec<f64> = knots.iter().collect();
        let exact = |x: &f64| -0.64 * x.exp() / (1.0 + 0.5 * x.exp());
        let limits = SpeedLimits { rest: 0.0, slope: -0.64, infinite: 0.0 };
        let mut row: Vec<f64> = places.iter().map(exact).collect();
        let before = row.clone();
        assert!(put_into(&mut row, &places, limits, Beyond { square: 0.35, cubic: 1.0 }).is_empty());
        assert_eq!(row, before);
    }
}
