//! Rows of every kind of figure: branches, gaps, lists of roots, modes that swap their order.

mod contact;
mod motion;
mod oscillator;
mod structure;

pub(super) use motion::diagram;

use contact::{contact, contact_law, fit, modulus, transient};
use judder_store::{Dataset, Variable, VariableValues};
use motion::{basin, bifurcation, engines, limit_cycle, motion};
use num_complex::Complex64;
use oscillator::{critical, equivalent_damping, spectrum, stability_map};
use serde_json::{Value, json};
use std::f64::consts::TAU;
use structure::{
    assembly_cycle, assembly_map, assembly_march, assembly_response, assembly_squeal, cycle_branch, eigen,
    eigen_sweep, growth, locus, march, mode_growth, modes, receptance, reduction, spectrogram,
    steady_sliding, timed_spectrogram,
};

pub(super) type Point = (f64, f64);

/// A dataset, and what of it may be joined: neighbours of a run, both of which are.
pub(super) struct Planted {
    pub(super) dataset: Dataset,
    pub(super) runs: Vec<Vec<Point>>,
    /// Labels of lines and titles of panels that show no rows.
    pub(super) shapes: &'static [&'static str],
}

type Plant = fn(u64) -> Vec<Planted>;

pub(super) const PLANTED: [(&str, &str, Plant); 42] = [
    ("oscillator", "equivalent-damping", equivalent_damping),
    ("oscillator", "spectrum", spectrum),
    ("oscillator", "critical-shear-strength", critical),
    ("oscillator", "critical-load", critical),
    ("oscillator", "stability-map", stability_map),
    ("oscillator", "motion", motion),
    ("oscillator", "limit-cycle", limit_cycle),
    ("oscillator", "bifurcation", bifurcation),
    ("oscillator", "basin", basin),
    ("oscillator", "engines", engines),
    ("contact", "contact", contact),
    ("contact", "contact-law", contact_law),
    ("contact", "fit", fit),
    ("contact", "modulus", modulus),
    ("contact", "transient", transient),
    ("belt", "motion", motion),
    ("belt", "limit-cycle", limit_cycle),
    ("belt", "bifurcation", bifurcation),
    ("belt", "basin", basin),
    ("two-degrees", "spectrum", spectrum),
    ("two-degrees", "stability-map", stability_map),
    ("structure", "modes", modes),
    ("structure", "reduction", reduction),
    ("structure", "receptance", receptance),
    ("structure", "eigen", eigen),
    ("structure", "eigen-sweep", eigen_sweep),
    ("sliding", "modes", modes),
    ("sliding", "locus", locus),
    ("sliding", "growth", growth),
    ("sliding", "march", march),
    ("sliding", "spectrogram", spectrogram),
    ("assembly", "steady-sliding", steady_sliding),
    ("assembly", "eigen", eigen),
    ("assembly", "eigen-sweep", eigen_sweep),
    ("assembly", "stability-map", assembly_map),
    ("assembly", "growth", mode_growth),
    ("assembly", "march", assembly_march),
    ("assembly", "spectrogram", timed_spectrogram),
    ("assembly", "limit-cycle", assembly_cycle),
    ("assembly", "squeal", assembly_squeal),
    ("assembly", "bifurcation", cycle_branch),
    ("assembly", "frequency-response", assembly_response),
];

const NAN: f64 = f64::NAN;

/// Numbers between 0 and 1, the same for the same seed.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        // splitmix64
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn is(&mut self, share: f64) -> bool {
        self.next() < share
    }

    /// Values above `base`; one in six is none.
    fn gappy(&mut self, count: usize, base: f64) -> Vec<f64> {
        (0..count).map(|_| if self.is(0.17) { NAN } else { base + self.next() }).collect()
    }
}

fn steps(count: usize) -> Vec<f64> {
    (0..count).map(|k| 1.0 + k as f64).collect()
}

fn along(name: &str, dimension: &str, values: impl Into<VariableValues>) -> Variable {
    let values = values.into();
    Variable::new(name, &[dimension], &[values.len()], values)
}

fn over(name: &str, dimensions: &[&str], shape: &[usize], values: impl Into<VariableValues>) -> Variable {
    Variable::new(name, dimensions, shape, values)
}

fn dataset(variables: Vec<Variable>, attributes: &[(&str, Value)]) -> Dataset {
    let whole =
        variables.into_iter().fold(Dataset::new(), |dataset, variable| dataset.with(variable).unwrap());
    attributes.iter().fold(whole, |dataset, (name, value)| dataset.attribute(name, value.clone()).unwrap())
}

fn run(x: &[f64], y: &[f64]) -> Vec<Point> {
    x.iter().copied().zip(y.iter().copied()).collect()
}

fn alone(dataset: Dataset, runs: Vec<Vec<Point>>) -> Vec<Planted> {
    vec![Planted { dataset, runs, shapes: &[] }]
}
