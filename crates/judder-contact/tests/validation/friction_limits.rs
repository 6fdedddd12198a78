//! The friction of slow and of fast sliding in closed form, and the two ways to compute it.

use crate::questions::{assert_close, paraboloid};
use judder_contact::kernel::substrate::{SlidingSubstrate, WakeTerm};
use judder_contact::unilateral::Loading;

/// v → 0: the elastic answer lags by (1 − E0/E∞) v τ, so μ = (1 − E0/E∞) v τ/R for any contact of curvature 1/R.
#[test]
fn slow_friction_is_the_lag_of_the_elastic_answer() {
    for (contrast, length) in [(10.0, 1e-3), (10.0, 1e-5), (1000.0, 1e-3), (2.0, 1e-4)] {
        let contact = paraboloid(&SlidingSubstrate::single(contrast, length), Loading::Indentation(1.0), 128);
        assert_close(contact.finest.friction, (1.0 - 1.0 / contrast) * length, 1e-2);
    }
}

/// v → ∞: creep during the passage, μ = 0.8 (E∞/E0 − 1) δ/(v τ), approached as ln z/z.
#[test]
fn fast_friction_is_the_creep_during_one_passage() {
    for contrast in [2.0, 10.0] {
        let length = 1e6;
        let contact = paraboloid(&SlidingSubstrate::single(contrast, length), Loading::Indentation(1.0), 128);
        assert_close(contact.finest.friction, 0.8 * (contrast - 1.0) / length, 1e-2);
    }
}

/// What the indenter does against its slope the substrate dissipates in its bulk.
#[test]
fn the_two_frictions_agree_to_one_per_cent() {
    for length in [0.03, 0.3, 3.0, 30.0, 300.0] {
        let contact = paraboloid(&SlidingSubstrate::single(10.0, length), Loading::Indentation(1.0), 64);
        assert!(contact.friction_difference() < 1e-2, "{length}: {}", contact.friction_difference());
    }
}

/// Two retardation times of half the strength each that are equal are one.
#[test]
fn two_equal_terms_are_one() {
    let one = SlidingSubstrate::single(10.0, 0.7);
    let half = WakeTerm { compliance: 0.45, length: 0.7 };
    let two = SlidingSubstrate { instantaneous: 0.1, terms: vec![half, half], layer: None };
    let (one, two) =
        (paraboloid(&one, Loading::Indentation(1.0), 64), paraboloid(&two, Loading::Indentation(1.0), 64));
    assert_close(two.finest.force, one.finest.force, 1e-9);
    assert_close(two.finest.friction, one.finest.friction, 1e-9);
}
