//! There is one state of steady sliding, and the solver finds it.

use crate::page::vertical_imbalance;
use crate::panels::paper;
use crate::sampling::{any_groups, any_load, any_structure, for_each};
use judder_oscillator::equilibrium::equilibrium;
use judder_oscillator::{FrictionLoad, Groups, OscillatorError};
use proptest::prelude::*;
use std::cell::Cell;

/// ŷ at which the page's (15) changes sign, bracketed: a scan of `samples` points, evenly in ln ŷ.
fn sign_changes(
    groups: &Groups,
    load: FrictionLoad,
    (from, to): (f64, f64),
    samples: usize,
) -> Vec<(f64, f64)> {
    let at = |k: usize| (from.ln() + (to / from).ln() * k as f64 / samples as f64).exp();
    let mut before = (at(0), vertical_imbalance(groups, load, at(0)));
    let mut found = Vec::new();
    for k in 1..=samples {
        let here = (at(k), vertical_imbalance(groups, load, at(k)));
        if before.1 * here.1 <= 0.0 {
            found.push((before.0, here.0));
        }
        before = here;
    }
    found
}

/// Where steady sliding is looked for: the solver may start no lower, and above a depth of 1e3 radii no law means anything.
const DEPTHS: (f64, f64) = (1e-30, 1e3);

#[test]
fn exactly_one_root_and_the_solver_is_at_it() {
    for_each(5_000, (any_groups(), any_load()), |(groups, load)| {
        let found = sign_changes(&groups, load, DEPTHS, 1500);
        prop_assert_eq!(found.len(), 1, "{:?}", found);
        let y = equilibrium(&paper(load), &groups.coefficients().unwrap()).unwrap().indentation;
        let around = [1.0 - 1e-9, 1.0 + 1e-9].map(|f| vertical_imbalance(&groups, load, f * y));
        prop_assert!(around[0] < 0.0 && around[1] > 0.0, "{y:e}: {around:?}");
        Ok(())
    });
}

/// Where the coupling lifts (k12 < 0), friction pulls the indenter in: there may be no root, or several, and the solver says so.
#[test]
fn roots_are_counted_where_friction_pulls_in() {
    let lifting = any_structure(std::f64::consts::FRAC_PI_2, std::f64::consts::PI);
    let counts = Cell::new([0; 3]);
    for_each(300, (lifting, any_load()), |(groups, load)| {
        let found = sign_changes(&groups, load, DEPTHS, 20_000).len();
        let solved = match equilibrium(&paper(load), &groups.coefficients().unwrap()) {
            Ok(_) => 1,
            Err(OscillatorError::NoEquilibrium { .. }) => 0,
            Err(OscillatorError::SeveralEquilibria { indentations }) => indentations.len(),
            Err(other) => return Err(TestCaseError::fail(other.to_string())),
        };
        prop_assert_eq!(solved, found);
        let mut tally = counts.get();
        tally[solved.min(2)] += 1;
        counts.set(tally);
        Ok(())
    });
    assert!(counts.get().iter().all(|count| *count > 0), "none, one, several: {counts:?}");
}
