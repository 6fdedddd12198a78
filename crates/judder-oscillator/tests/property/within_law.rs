//! What a law says of its own errors covers what they do to steady sliding: a law in closed form, and laws through values of it that are off.

use judder_contact::law::{LawSamples, PerQuantity, SampledLaw};
use judder_contact::{ContactLaw, ContactResponse, FittedLaw, Law, LawPoint};
use judder_oscillator::characteristic::Characteristic;
use judder_oscillator::critical::{ParameterRange, RangeScale, thresholds};
use judder_oscillator::equilibrium::equilibrium;
use judder_oscillator::linear_system::ReducedSystem;
use judder_oscillator::linearisation::Linearisation;
use judder_oscillator::undecided::undecided;
use judder_oscillator::within_law::WithinLaw;
use judder_oscillator::{Coefficients, Contact, FrictionLoad, Groups, Verdict};
use std::sync::Arc;

fn contact(law: Law) -> Contact {
    Contact { law, friction_load: FrictionLoad::ContactForce }
}

fn exact() -> Contact {
    contact(Law::Fitted(FittedLaw::oscillator_paper()))
}

/// An error between −1 and 1 for each place, the same for the same seed.
fn noise(seed: u64, place: usize) -> f64 {
    let bits =
        (seed ^ (place as u64).wrapping_mul(0xD6E8_FEB8_6659_FD93)).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    let bits = (bits ^ (bits >> 32)).wrapping_mul(0xD6E8_FEB8_6659_FD93);
    (bits >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
}

/// The exact law through values that are off by up to `error`, each on its own.
fn noisy(error: f64, seed: u64) -> Contact {
    let logarithmic = |from: f64, to: f64, count: usize| -> Vec<f64> {
        (0..count).map(|k| from * (to / from).powf(k as f64 / (count - 1) as f64)).collect()
    };
    let (velocities, indentations) = (logarithmic(1e-9, 1e3, 61), logarithmic(1e-9, 1e-1, 33));
    let law = FittedLaw::oscillator_paper();
    let points = indentations.iter().flat_map(|y| velocities.iter().map(move |v| LawPoint::new(*v, *y)));
    let responses: Vec<ContactResponse> = points.map(|at| law.evaluate(&at)).collect();
    let of = |quantity: usize, value: fn(&ContactResponse) -> f64| {
        let off =
            |(k, r): (usize, &ContactResponse)| value(r) * (1.0 + error * noise(seed, 3 * k + quantity));
        responses.iter().enumerate().map(off).collect()
    };
    let values = PerQuantity {
        force: of(0, |r| r.force.value),
        area: of(1, |r| r.area.value),
        friction: of(2, |r| r.friction.value),
    };
    let samples = LawSamples { source: "test".to_owned(), velocities, indentations, values };
    contact(Law::Sampled(Arc::new(SampledLaw::new(samples).unwrap())))
}

fn oscillators() -> Vec<Coefficients> {
    let mut all = Vec::new();
    for k in 0..40 {
        for shear_strength in [1e-3, 3e-2, 0.3] {
            let velocity = 10_f64.powf(-7.0 + 8.0 * f64::from(k) / 39.0);
            all.push(Groups { velocity, shear_strength, ..Groups::default() }.resolve());
        }
    }
    all
}

fn linearised(contact: &Contact, c: &Coefficients) -> Option<(Linearisation, Verdict)> {
    let state = equilibrium(contact, c).ok()?;
    let l = Linearisation::new(contact.friction_load, c, &state.response);
    let reduced = ReducedSystem { damping: l.damping(), stiffness: l.stiffness() };
    Some((l, Characteristic::new(&reduced).verdict()))
}

/// The class of the wiper's flipped verdict: of two laws whose values agree to an accuracy, one says stable, the other unstable.
#[test]
fn a_verdict_that_the_law_decides_is_that_of_the_exact_law() {
    let (mut all, mut flipped, mut contradicted, mut outside, mut undecided) = (0, 0, 0, 0, 0);
    for error in [3e-4, 3e-3, 3e-2] {
        for seed in 0..3 {
            let law = noisy(error, seed);
            for c in oscillators() {
                let (Some((own, verdict)), Some((right, expected))) =
                    (linearised(&law, &c), linearised(&exact(), &c))
                else {
                    continue;
                };
                all += 1;
                flipped += usize::from(verdict != expected);
                let state = equilibrium(&law, &c).unwrap();
                let Some(within) = WithinLaw::new(&law, &c, &state) else {
                    undecided += 1;
                    continue;
                };
                undecided += usize::from(!within.is_decided());
                contradicted += usize::from(within.is_decided() && verdict != expected);
                let off = (own.equivalent_damping() - right.equivalent_damping()).abs();
                outside += usize::from(off > within.equivalent_damping_error());
            }
        }
    }
    let told = format!(
        "{all} points: {flipped} flipped, {contradicted} of them decided, {outside} outside, {undecided} undecided"
    );
    println!("{told}");
    assert!(flipped > 10, "nothing to tell: {told}");
    assert!(20 * contradicted <= flipped && 50 * outside <= all, "{told}");
    assert!(undecided < all * 9 / 10, "what is never decided is never wrong: {told}");
}

#[test]
fn a_formula_has_no_errors() {
    for c in oscillators() {
        let Ok(state) = equilibrium(&exact(), &c) else { continue };
        let within = WithinLaw::new(&exact(), &c, &state).unwrap();
        assert_eq!(within.equivalent_damping_error(), 0.0);
        let (least, most) = within.growth_rates().unwrap();
        assert!(within.is_decided() && within.is_merging_decided() && least == most);
    }
}

/// Thresholds of the exact law lie where a law through its values does not decide.
#[test]
fn thresholds_lie_in_the_ranges_that_the_law_leaves_open() {
    let (law, mut found) = (noisy(3e-3, 1), 0);
    let range = ParameterRange { from: 1e-4, to: 1e1, scale: RangeScale::Logarithmic };
    for velocity in [1e-5, 1e-4, 1e-3, 1e-2] {
        let at = |shear_strength: f64| Groups { velocity, shear_strength, ..Groups::default() }.resolve();
        let [right, own] = [exact(), law.clone()].map(|contact| thresholds(&contact, &range, 101, at));
        let open = undecided(&law, &range, 101, [&own.full, &own.conservative], at);
        for (roots, ranges) in [(&right.full, &open.full), (&right.conservative, &open.conservative)] {
            for root in roots {
                found += 1;
                assert!(
                    ranges.iter().any(|[from, to]| from <= root && root <= to),
                    "{velocity}: {root} {ranges:?}"
                );
            }
        }
        assert_eq!(undecided(&exact(), &range, 101, [&right.full, &[]], at), Default::default());
    }
    assert!(found > 3, "{found}");
}
