//! Cycles of the event-driven engine of the oscillator, which assemblies are held against.

use faer::c64;
use judder_assembly::row::Row;
use judder_cycles::cycle::AssemblyCycle;
use judder_numerics::piecewise::{PiecewiseMarch, StepSettings};
use judder_numerics::quadrature::gauss_legendre;
use judder_oscillator::cycle::shooting::{Cycle, Shooting, from_simulation};
use judder_oscillator::motion::SlidingSystem;
use judder_oscillator::motion::attractor::Patience;
use std::f64::consts::TAU;

/// What is compared: the period, and the root mean square of each displacement and then of each velocity about its mean.
#[derive(Debug)]
pub(super) struct Known {
    pub(super) period: f64,
    pub(super) rms: Vec<f64>,
}

pub(super) fn shooting<const N: usize>(system: &impl SlidingSystem<N>) -> Shooting<N> {
    const TOLERANCE: f64 = 1e-12;
    let absolute = system.scales().map(|scale| TOLERANCE * scale);
    let settings = StepSettings { relative: TOLERANCE, absolute, longest_step: 1.0, steps: 10_000_000 };
    Shooting { settings, tolerance: 100.0 * TOLERANCE, iterations: 20, longest: 2000.0 }
}

/// The cycle that a motion from this state settles to.
pub(super) fn settled<const N: usize>(system: &impl SlidingSystem<N>, start: [f64; N]) -> Cycle<N> {
    from_simulation(system, start, &shooting(system), &Patience::default(), &|| false).unwrap()
}

pub(super) fn known<const N: usize>(system: &impl SlidingSystem<N>, cycle: &Cycle<N>) -> Known {
    let settings = shooting(system).settings;
    let mut march =
        PiecewiseMarch::new(system, system.starting_mode(&cycle.start), cycle.start, settings).unwrap();
    let (mut first, mut second) = ([0.0; N], [0.0; N]);
    while march.time() < cycle.period() {
        let Some(leg) = system.advance(&mut march, cycle.period()).unwrap().leg else { continue };
        for (node, weight) in gauss_legendre::<5>() {
            let state = leg.at(node);
            for k in 0..N {
                first[k] += weight * leg.step * state[k] / cycle.period();
                second[k] += weight * leg.step * state[k] * state[k] / cycle.period();
            }
        }
    }
    let rms = first.iter().zip(second).map(|(first, second)| (second - first * first).sqrt()).collect();
    Known { period: cycle.period(), rms }
}

impl Known {
    /// By how much the period and the displacements of a cycle by harmonics are off, relatively.
    pub(super) fn errors(&self, cycle: &AssemblyCycle<'_>) -> Vec<f64> {
        let displacements = self.rms.len() / 2;
        let rms = (0..displacements).map(|k| {
            let own = cycle.followed(&Row::new(vec![(k, 1.0)])).unwrap();
            own[1..].iter().map(|part| 0.5 * part * part).sum::<f64>().sqrt() / self.rms[k] - 1.0
        });
        std::iter::once(TAU / cycle.frequency() / self.period - 1.0).chain(rms).collect()
    }
}

/// The largest error.
pub(super) fn worst(errors: &[f64]) -> f64 {
    errors.iter().fold(0.0, |most, own| most.max(own.abs()))
}

/// How far the multiplier that is off most lies from the nearest of others, of which there are as many.
pub(super) fn off_nearest(multipliers: &[c64], others: &[c64]) -> f64 {
    assert_eq!(multipliers.len(), others.len());
    let off = |own: &c64| others.iter().map(|other| (own - other).norm()).fold(f64::INFINITY, f64::min);
    multipliers.iter().map(off).fold(0.0, f64::max)
}

/// p of errors that fall as n⁻ᵖ.
pub(super) fn order([few, many]: [(usize, f64); 2]) -> f64 {
    (few.1 / many.1).ln() / (many.0 as f64 / few.0 as f64).ln()
}

/// Errors in two digits.
pub(super) fn told(errors: &[f64]) -> String {
    errors.iter().map(|own| format!("{own:9.1e}")).collect()
}
