//! The errors that a law gives for its slopes cover those that it has.

use crate::synthetic::{contact, material, speeds};
use judder_contact::law::{KnotValues, LawIndenter, LawMaterial, PerQuantity};
use judder_contact::{CollapsedLaw, ContactLaw, ContactResponse, LawPoint, WithDerivatives};
use proptest::prelude::*;

const DEPTH: f64 = 1e-2;

/// An error between −1 and 1 for each place, the same for the same seed.
fn noise(seed: u64, place: usize) -> f64 {
    let bits =
        (seed ^ (place as u64).wrapping_mul(0xD6E8_FEB8_6659_FD93)).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    let bits = (bits ^ (bits >> 32)).wrapping_mul(0xD6E8_FEB8_6659_FD93);
    (bits >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
}

/// A law whose contacts are off by up to `error`, each on its own.
fn noisy(count: usize, error: f64, seed: u64) -> CollapsedLaw {
    let speeds = speeds(count);
    let mut values = KnotValues::default();
    for (k, ln_z) in speeds.iter().enumerate() {
        let exact = contact(LawIndenter::Paraboloid, ln_z.exp() * DEPTH.sqrt(), DEPTH);
        let off = |quantity: usize| 1.0 + error * noise(seed, 3 * k + quantity);
        values.force.push(exact.force / DEPTH.powf(1.5) * off(0));
        values.area.push(exact.area / DEPTH * off(1));
        values.friction.push(exact.friction / DEPTH.sqrt() * off(2));
    }
    CollapsedLaw::new(material(), "test".to_owned(), speeds, values, PerQuantity::uniform(error)).unwrap()
}

fn at(z: f64) -> LawPoint {
    LawPoint::new(z * DEPTH.sqrt(), DEPTH)
}

/// d ln q/d ln v of the closed form, by differences.
fn exact_slopes(z: f64) -> [f64; 3] {
    const STEP: f64 = 1e-4;
    let logarithms = |by: f64| {
        let here = contact(LawIndenter::Paraboloid, z * by.exp() * DEPTH.sqrt(), DEPTH);
        here.into_array().map(f64::ln)
    };
    let (up, down) = (logarithms(STEP), logarithms(-STEP));
    [0, 1, 2].map(|k| (up[k] - down[k]) / (2.0 * STEP))
}

fn quantities(r: &ContactResponse) -> [WithDerivatives; 3] {
    [r.force, r.area, r.friction]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    /// The class of the flipped verdicts: values within the accuracy, slopes far outside it. At 97 of 100 places, in a law of any seed, error and number of knots.
    #[test]
    fn slopes_are_within_their_errors(seed in any::<u64>(), ln_error in -9.0..-4.0_f64, fineness in 1_usize..4) {
        let law = noisy(16 * fineness + 1, ln_error.exp(), seed);
        let (mut outside, mut all) = (0, 0);
        for k in 0..200 {
            let z = (-8.0 + 16.0 * f64::from(k) / 199.0_f64).exp();
            let (here, doubt) = (law.evaluate(&at(z)), law.doubt(&at(z)).unwrap());
            for ((found, doubt), exact) in quantities(&here).iter().zip(quantities(&doubt)).zip(exact_slopes(z)) {
                let exact = exact * found.value / at(z).velocity;
                all += 1;
                outside += usize::from((found.by_velocity - exact).abs() > doubt.by_velocity);
            }
        }
        prop_assert!(100 * outside <= 3 * all, "{outside} of {all}");
    }
}

/// An error that is always large would cover everything.
#[test]
fn errors_of_slopes_are_of_the_size_of_the_slopes_own() {
    for error in [3e-3, 1e-2] {
        let mut ratios: Vec<f64> = Vec::new();
        for seed in 0..20 {
            let law = noisy(65, error, seed);
            for k in 0..40 {
                let z = (-2.0 + 6.0 * f64::from(k) / 39.0_f64).exp();
                let (here, doubt) = (law.evaluate(&at(z)), law.doubt(&at(z)).unwrap());
                let exact = exact_slopes(z)[1] * here.area.value / at(z).velocity;
                ratios.push(doubt.area.by_velocity / (here.area.by_velocity - exact).abs());
            }
        }
        ratios.sort_by(f64::total_cmp);
        let median = ratios[ratios.len() / 2];
        assert!(median > 2.0 && median < 12.0, "{error}: {median}");
    }
}

/// Finer contacts leave smaller errors, formulas none, too few knots tell none.
#[test]
fn errors_fall_with_those_of_the_contacts_and_are_unknown_where_nothing_tells_them() {
    let of = |error: f64| noisy(65, error, 7).doubt(&at(1.0)).unwrap().area.by_velocity;
    assert!(of(1e-2) > 5.0 * of(1e-3) && of(1e-3) > 0.0);
    let hertz = judder_contact::HertzLaw::default();
    assert_eq!(hertz.doubt(&at(1.0)), Some(ContactResponse::default()));
    assert!(crate::synthetic::tabulated(LawIndenter::Sphere, 33, 5).doubt(&at(1.0)).is_some());
    assert!(crate::synthetic::tabulated(LawIndenter::Sphere, 33, 2).doubt(&at(1.0)).is_none());
    let below = LawPoint::new(1.0, 0.31);
    assert!(crate::synthetic::tabulated(LawIndenter::Sphere, 33, 5).doubt(&below).is_none());
}

/// Below the first knot the slope of the area is the exact one, whatever the contacts have in common.
#[test]
fn in_slow_sliding_the_area_falls_linearly_whatever_all_contacts_share() {
    let substrate: LawMaterial = material();
    let speeds = speeds(33);
    let mut values = KnotValues::default();
    for ln_z in speeds.iter() {
        let exact = contact(LawIndenter::Paraboloid, ln_z.exp() * DEPTH.sqrt(), DEPTH);
        values.force.push(exact.force / DEPTH.powf(1.5));
        values.area.push(exact.area / DEPTH * 1.01);
        values.friction.push(exact.friction / DEPTH.sqrt());
    }
    let law =
        CollapsedLaw::new(substrate.clone(), "test".to_owned(), speeds, values, PerQuantity::uniform(1e-2))
            .unwrap();
    for z in [1e-5, 1e-3, 5e-3, 1e-2, 2e-2] {
        let area = law.evaluate(&at(z)).area;
        let ratio = area.by_velocity * at(z).velocity / area.value / (substrate.slow_area_slope() * z);
        assert!((ratio - 1.0).abs() < 0.3, "{z}: {ratio}");
    }
}
