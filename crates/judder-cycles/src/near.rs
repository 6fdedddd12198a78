//! Cycles near a periodic motion that is known from elsewhere: a march, a cycle of another study.

use crate::CyclesError;
use crate::backbone::{PeriodicMotion, refined};
use crate::balance::{CycleRate, HarmonicBalance};
use crate::cycle::{AssemblyCycle, CycleSettings};
use crate::path::GoOn;
use crate::phase::Phase;
use faer::Mat;
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
}

/// With how many harmonics a cycle is sought at first: with fewer it may be another, with more it is harder to find.
const TRIED: [usize; 4] = [7, 15, 31, 3];
/// By how much its frequency may differ, of itself.
const SAME: f64 = 1e-2;

/// The cycle near a periodic motion.
///
/// # Errors
/// What [`HarmonicBalance::new`] says; [`CyclesError::OtherPoints`], [`CyclesError::OtherMotion`], and what the balance of harmonics says near it.
pub fn cycle_near<'a>(
    assembly: &'a Assembly,
    steady: &SteadySliding,
    known: &ForcesOverPeriod,
    settings: &CycleSettings,
    go_on: &GoOn<'_>,
) -> Result<AssemblyCycle<'a>, CyclesError> {
    let asked = settings.most();
    let balance =
        HarmonicBalance::new(assembly, steady, known.frequency, settings.series(TRIED[0].min(asked)), &[])?;
    let [found, expected] = [known.forces.ncols(), balance.components()];
    if found != expected {
        return Err(CyclesError::OtherPoints { found, expected });
    }
    let mut tried: Vec<usize> = TRIED.map(|harmonics| harmonics.min(asked)).to_vec();
    tried.dedup();
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
    if (found / sought - 1.0).abs() > SAME {
        return Err(CyclesError::OtherMotion { found, sought });
    }
    Ok(cycle)
}
