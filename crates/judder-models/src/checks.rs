//! Every number doubted by another number: the comparisons that a run makes of itself.

use crate::bridge;
use crate::oscillator::inputs::OscillatorInputs;
use crate::oscillator::steady_states::SteadyState;
use judder_numerics::complex::ElementaryComplex;
use judder_oscillator::characteristic::{Characteristic, MARGINAL_BAND};
use judder_oscillator::conservative::discriminant_share;
use judder_oscillator::critical::Thresholds;
use judder_oscillator::equilibrium::equilibrium;
use judder_oscillator::linear_system::ReducedSystem;
use judder_oscillator::linearisation::Linearisation;
use judder_oscillator::map::StabilityMap;
use judder_oscillator::mechanism::StabilityClass;
use judder_oscillator::motion::accelerations;
use judder_oscillator::spectrum::{eigenvalues, growth_rate};
use judder_oscillator::{Contact, LinearSystem};
use judder_study::outcome::{CheckRecord, Disagreement};

/// At most so many points of an analysis are checked.
const MOST: usize = 400;
/// Growth rates below this share of |λ| are left out where signs are compared: there an eigenvalue is rounding.
const EIGENVALUE_BAND: f64 = 1e-7;

/// The checks of steady sliding and its linearisation, on (a sample of) these states.
pub(crate) fn steady_sliding(contact: &Contact, states: &[SteadyState]) -> Vec<CheckRecord> {
    let sample: Vec<&SteadyState> = states.iter().step_by(states.len().div_ceil(MOST).max(1)).collect();
    if sample.is_empty() {
        return Vec::new();
    }
    let count = sample.len();
    let largest = |figure: &dyn Fn(&SteadyState) -> f64| sample.iter().map(|s| figure(s)).collect();
    let decided = sample.iter().filter_map(|s| disagrees(&s.linearisation.system()));
    vec![
        CheckRecord::new(
            "steady sliding satisfies the equations of motion",
            format!("both rows of (12) at rest, over the normal load, at {count} points"),
            largest(&|s| imbalance(contact, s)),
            1e-10,
        ),
        CheckRecord::new(
            "C and K are the Jacobian of the equations of motion",
            format!("central differences of (12) against (20), at {count} points"),
            largest(&|s| jacobian_error(contact, s)),
            1e-6,
        ),
        CheckRecord::new(
            "the eigenvalues are those of the matrices",
            format!("det(λ² M + λ C + K) over its terms, four eigenvalues at {count} points"),
            largest(&|s| determinant_residual(&s.linearisation.system())),
            1e-12,
        ),
        CheckRecord::new(
            "Hurwitz decides as the eigenvalues do",
            format!("number of disagreements beyond |Re λ| = 1e-7 |λ|, at {count} points"),
            Disagreement::exceptions(decided),
            0.0,
        ),
    ]
}

fn at_rest(state: &SteadyState) -> [f64; 4] {
    [state.equilibrium.x, state.equilibrium.y, 0.0, 0.0]
}

/// The accelerations at the equilibrium, over the largest force that acts there.
fn imbalance(contact: &Contact, state: &SteadyState) -> f64 {
    let c = &state.coefficients;
    let [x, y] = accelerations(contact, c, &at_rest(state));
    let scale = 1.0 + (c.k11 * state.equilibrium.x).abs() + (c.k12 * state.equilibrium.y).abs();
    x.abs().max(y.abs()) / scale
}

/// The largest departure of C and K from central differences, each over the entry and a unit force per step unit.
fn jacobian_error(contact: &Contact, state: &SteadyState) -> f64 {
    const STEP: f64 = 1e-5;
    let c = &state.coefficients;
    let speed = c.velocity * c.radius() / c.retardation_time;
    let rest = at_rest(state);
    let column = |place: usize, scale: f64| -> [f64; 2] {
        let moved = |by: f64| {
            let mut state = rest;
            state[place] += by;
            accelerations(contact, c, &state)
        };
        let step = STEP * scale;
        let (plus, minus) = (moved(step), moved(-step));
        [0, 1].map(|row| -(plus[row] - minus[row]) / (2.0 * step))
    };
    let [damping, stiffness] = [state.linearisation.damping(), state.linearisation.stiffness()];
    let [x, y, ..] = rest;
    let along_x = x.abs().max(y);
    let columns = [
        (&stiffness, 0, along_x, column(0, along_x)),
        (&stiffness, 1, y, column(1, y)),
        (&damping, 0, speed, column(2, speed)),
        (&damping, 1, speed, column(3, speed)),
    ];
    let force = 1.0 + (c.k11 * x).abs() + (c.k12 * y).abs();
    columns
        .iter()
        .flat_map(|(matrix, index, scale, slopes)| {
            (0..2).map(move |row| {
                let exact = matrix[row][*index];
                (slopes[row] - exact).abs() / (exact.abs() + force / scale)
            })
        })
        .fold(0.0, f64::max)
}

/// Whether the Hurwitz conditions and the eigenvalues differ on a system; `None` within a marginal band, where neither decides.
fn disagrees(system: &LinearSystem) -> Option<bool> {
    let reduced = system.reduced().ok()?;
    let Ok(values) = eigenvalues(&reduced) else { return Some(true) };
    let growth = growth_rate(&values);
    let size = values.iter().map(|l| l.modulus()).fold(0.0, f64::max);
    let margin = Characteristic::new(&reduced).margin();
    let clear = growth.abs() > EIGENVALUE_BAND * size && margin.abs() > MARGINAL_BAND;
    clear.then_some((growth > 0.0) != (margin < 0.0))
}

/// The eigenvalues of a system against its matrices, which the characteristic polynomial no longer sees: the largest
/// |det(λ² M + λ C + K)| over the magnitudes of its terms.
fn determinant_residual(system: &LinearSystem) -> f64 {
    let Some(values) = system.reduced().ok().and_then(|reduced| eigenvalues(&reduced).ok()) else {
        return f64::NAN;
    };
    let LinearSystem { mass, damping, stiffness } = system;
    values
        .iter()
        .map(|value| {
            let entry = |i: usize, j: usize| (value * mass[i][j] + damping[i][j]) * value + stiffness[i][j];
            let size = |i: usize, j: usize| {
                let r = value.modulus();
                (r * mass[i][j].abs() + damping[i][j].abs()) * r + stiffness[i][j].abs()
            };
            let determinant = entry(0, 0) * entry(1, 1) - entry(0, 1) * entry(1, 0);
            determinant.modulus() / (size(0, 0) * size(1, 1) + size(0, 1) * size(1, 0))
        })
        .fold(0.0, f64::max)
}

/// Whether each system is unstable, as a map says, against its eigenvalues.
pub(crate) fn unstable_as_eigenvalues_say(systems: &[(LinearSystem, bool)]) -> CheckRecord {
    let decided = systems.iter().filter_map(|(system, unstable)| {
        let values = eigenvalues(&system.reduced().ok()?).ok()?;
        let (growth, size) = (growth_rate(&values), values.iter().map(|l| l.modulus()).fold(0.0, f64::max));
        (growth.abs() > EIGENVALUE_BAND * size).then_some((growth > 0.0) != *unstable)
    });
    CheckRecord::new(
        "the map agrees with the eigenvalues",
        format!("number of points whose verdict differs beyond |Re λ| = 1e-7 |λ|, of {}", systems.len()),
        Disagreement::exceptions(decided),
        0.0,
    )
}

/// A map, made by the vector path, against points solved alone by the bracketed scalar path.
pub(crate) fn map_against_points(
    states: &[(SteadyState, (usize, usize))],
    map: &StabilityMap,
) -> CheckRecord {
    let decided = states.iter().filter_map(|(state, (column, row))| {
        let Ok(reduced) = state.linearisation.system().reduced() else { return Some(true) };
        let clear = StabilityClass::clearance(&reduced) > 1e-9;
        clear.then(|| StabilityClass::of(&reduced) != map.class(*column, *row))
    });
    CheckRecord::new(
        "the map agrees with points solved alone",
        format!("number of points whose class differs, of {} over the whole map", states.len()),
        Disagreement::exceptions(decided),
        0.0,
    )
}

/// Growth rates that should vanish: the largest found, over the largest |λ|, and what it may be.
#[derive(Debug, Clone, Copy)]
pub(crate) struct VanishingGrowth {
    /// The largest |max Re λ| over max |λ|, infinite where a system had no eigenvalues, and of how many.
    pub(crate) found: Disagreement,
    /// 1e-8; 1e-6 once a system without damping was among them: there two eigenvalues coincide, and their parting is as the root
    /// of rounding.
    pub(crate) limit: f64,
}

impl Default for VanishingGrowth {
    fn default() -> Self {
        Self { found: Disagreement::default(), limit: 1e-8 }
    }
}

impl VanishingGrowth {
    /// Looks at one more system; `None` stands for a point without steady sliding.
    pub(crate) fn add(&mut self, system: Option<ReducedSystem>) {
        let Some((system, values)) = system.and_then(|system| Some((system, eigenvalues(&system).ok()?)))
        else {
            self.found.add(f64::INFINITY);
            return;
        };
        if system.damping.iter().flatten().all(|entry| *entry == 0.0) {
            self.limit = 1e-6;
        }
        let size = values.iter().map(|l| l.modulus()).fold(0.0, f64::max);
        self.found.add(growth_rate(&values).abs() / size);
    }
}

/// Thresholds against the eigenvalues at them: the growth rate, and the coalescence of the undamped modes.
pub(crate) fn thresholds(
    contact: &Contact,
    found: &[(OscillatorInputs, &Thresholds)],
    set: impl Fn(&OscillatorInputs, f64) -> OscillatorInputs,
) -> Vec<CheckRecord> {
    let system_at = |inputs: &OscillatorInputs, value: f64| {
        let c = bridge::coefficients(&set(inputs, value));
        let state = equilibrium(contact, &c).ok()?;
        Linearisation::new(contact.friction_load, &c, &state.response).system().reduced().ok()
    };
    let (mut growth, mut merging) = (VanishingGrowth::default(), Disagreement::default());
    for (inputs, roots) in found {
        for root in &roots.full {
            growth.add(system_at(inputs, *root));
        }
        for root in &roots.conservative {
            let share =
                system_at(inputs, *root).map_or(f64::INFINITY, |s| discriminant_share(&s.stiffness).abs());
            merging.add(share);
        }
    }
    let full = CheckRecord::new(
        "growth rate vanishes at the thresholds of the full system",
        format!("|max Re λ| over max |λ| from the eigenvalues, at {} thresholds", growth.found.numbers()),
        growth.found,
        growth.limit,
    );
    let conservative = CheckRecord::new(
        "the undamped modes merge at the conservative thresholds",
        format!("discriminant of (24), (25) over its terms, at {} thresholds", merging.numbers()),
        merging,
        1e-9,
    );
    // where there is no threshold, there is nothing to check
    [full, conservative].into_iter().filter(|check| !check.compared_nothing()).collect()
}
