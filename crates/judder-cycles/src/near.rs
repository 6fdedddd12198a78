//! Cycles near a periodic motion that is known from elsewhere: a march, a cycle of another study.

use crate::CyclesError;
use crate::backbone::{PeriodicMotion, refined};
use crate::balance::{CycleRate, HarmonicBalance};
use crate::cycle::{AssemblyCycle, CycleSettings};
use crate::path::GoOn;
use crate::phase::Phase;
use crate::series::Series;
use faer::{Mat, MatRef};
use judder_assembly::assembly::Assembly;
use judder_assembly::steady::SteadySliding;

/// What is known of a periodic motion.
#[derive(Debug, Clone, PartialEq)]
pub struct ForcesOverPeriod {
    /// ω in rad/s.
    pub frequency: f64,
    /// Of each contact point along normal, slip and in space across it, in N: a row for each of the even instants of a period, a column a component.
    pub forces: Mat<f64>,
    /// The mean gap of each point in m.
    pub gaps: Vec<f64>,
    /// How harmonics have found it, where they have.
    pub balanced: Option<BalancedBefore>,
}

/// How harmonics have found a motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BalancedBefore {
    /// How many there were.
    pub harmonics: usize,
    /// [`HarmonicBalance::scaled_at`].
    pub scaled_at: f64,
}

/// With how many harmonics a cycle is sought at first: with fewer it may be another, with more it is harder to find.
const TRIED: [usize; 4] = [7, 15, 31, 3];
/// By how much its frequency may differ, of itself; that of a cycle that is continued from elsewhere, where keys may have other values.
const SAME: f64 = 1e-2;
const CONTINUED: f64 = 0.2;

impl ForcesOverPeriod {
    /// A motion that harmonics have found, whose forces in N are known as coefficients, a column a component, as those of [`crate::series`].
    #[must_use]
    pub fn balanced(frequency: f64, scaled_at: f64, coefficients: MatRef<'_, f64>, gaps: Vec<f64>) -> Self {
        let harmonics = coefficients.nrows() / 2;
        let forces = Series::new(harmonics, 0).values(coefficients);
        Self { frequency, forces, gaps, balanced: Some(BalancedBefore { harmonics, scaled_at }) }
    }

    /// By how much the frequency of a cycle may differ, of itself.
    fn apart(&self) -> f64 {
        if self.balanced.is_some() { CONTINUED } else { SAME }
    }
}

/// The cycle near a periodic motion.
///
/// # Errors
/// What [`HarmonicBalance::new`] says; [`CyclesError::ForeignPoints`], [`CyclesError::OtherMotion`], and what the balance of harmonics says near it.
pub fn cycle_near<'a>(
    assembly: &'a Assembly,
    steady: &SteadySliding,
    known: &ForcesOverPeriod,
    settings: &CycleSettings,
    go_on: &GoOn<'_>,
) -> Result<AssemblyCycle<'a>, CyclesError> {
    let asked = settings.most();
    let scaled_at = known.balanced.map_or(known.frequency, |own| own.scaled_at);
    let mut tried: Vec<usize> = Vec::new();
    for harmonics in known.balanced.iter().map(|own| own.harmonics).chain(TRIED) {
        let harmonics = harmonics.min(asked).max(1);
        if !tried.contains(&harmonics) {
            tried.push(harmonics);
        }
    }
    let balance = HarmonicBalance::new(assembly, steady, scaled_at, settings.series(tried[0]), &[])?;
    let [found, expected] = [known.forces.ncols(), balance.components()];
    if found != expected {
        return Err(CyclesError::ForeignPoints { found, expected });
    }
    let mut failed = CyclesError::Singular;
    for harmonics in tried {
        let balance = balance.with_series(settings.series(harmonics));
        match near(balance, known, settings, go_on) {
            Err(error) if error.is_of_the_motion() => failed = error,
            other => return other,
        }
    }
    Err(failed)
}

fn near<'a>(
    balance: HarmonicBalance<'a>,
    known: &ForcesOverPeriod,
    settings: &CycleSettings,
    go_on: &GoOn<'_>,
) -> Result<AssemblyCycle<'a>, CyclesError> {
    let unknown = balance.unknown_over_period(&known.forces, &known.gaps);
    let turning = CycleRate { frequency: known.frequency, growth: 0.0 };
    let motions = balance.signals_at(&unknown, turning)?.motions;
    let phase = Phase::new(&balance, vec![1.0; 2 * balance.components()]);
    let guess =
        PeriodicMotion { amplitude: phase.amplitude(&motions), unknown, turning, residual: f64::INFINITY };
    let motion = refined(&balance, &guess, &settings.backbone.rule, go_on)?;
    let cycle = AssemblyCycle::of(balance, motion, None)?.with_enough(settings, go_on)?;
    let [found, sought] = [cycle.frequency(), known.frequency];
    if (found / sought - 1.0).abs() > known.apart() {
        return Err(CyclesError::OtherMotion { found, sought });
    }
    Ok(cycle)
}
