//! Tests of limit cycles, by kind of evidence.
#![allow(clippy::unwrap_used)]

#[path = "../../judder-nonsmooth/tests/common/mod.rs"]
#[allow(dead_code)]
mod common;
mod convergence;
mod property;
mod validation;

use faer::c64;
use judder_assembly::assembly::Assembly;
use judder_assembly::compliance::Compliance;
use judder_assembly::linearised::{Linearised, LinearisedTerms};
use judder_assembly::steady::{SteadySliding, steady_sliding};
use judder_structure::complex_modes::{ComplexModeSettings, Region, complex_modes};

/// Steady sliding, and the eigenvalues about it that grow, of a band in rad/s.
fn growing(case: &Assembly, band: [f64; 2]) -> (SteadySliding, Vec<c64>) {
    let steady = steady_sliding(case, &Compliance::new(case).unwrap()).unwrap();
    let about = Linearised::new(case, &steady, LinearisedTerms::default()).unwrap();
    let region = Region { re: [0.0, band[1]], im: band };
    let found = complex_modes(&about.problem, &region, &ComplexModeSettings::default()).unwrap();
    let values = found.modes.iter().map(|mode| mode.eigenvalue.value);
    (steady, values.map(|value| c64::new(value.re, value.im)).collect())
}
