//! The shares of the growth rate sum to the growth rate.

use crate::sampling::{any_contact, any_groups, for_each, linearised};
use judder_oscillator::growth::growth_shares;
use judder_oscillator::spectrum::{eigenvalues, leading, mode};
use proptest::prelude::*;

#[test]
fn shares_of_the_oscillator_sum_to_its_growth_rate() {
    for_each(20_000, (any_contact(), any_groups()), |(contact, groups)| {
        let system = linearised(&contact, &groups.coefficients().unwrap()).system();
        let value = leading(&eigenvalues(&system.reduced().unwrap()).unwrap());
        let shares = growth_shares(&system, &mode(&system, value));
        let size: f64 = shares.damping.iter().chain(&shares.stiffness).flatten().map(|s| s.abs()).sum();
        prop_assert!(
            (shares.sum() - value.re).abs() <= 1e-9 * size,
            "{} against {} of {size}",
            shares.sum(),
            value.re
        );
        Ok(())
    });
}
