//! The modes that grow, their cycles, their ranks.

use super::AssemblySqueal;
use crate::assembly::AssemblySubject;
use crate::assembly::build::WatchedRow;
use crate::assembly::eigen::band;
use crate::assembly::limit_cycle::checks::{INSTANTS, checks};
use crate::assembly::limit_cycle::search::{CycleOfMode, acceleration_mean_square};
use crate::assembly::limit_cycle::settings::{CycleMethod, components};
use crate::assembly::limit_cycle::stability::KnownStability;
use crate::assembly::march::levels::level;
use crate::error::ModelError;
use crate::structure::eigen::run::found;
use judder_assembly::linearised::{Linearised, LinearisedTerms};
use judder_cycles::cycle::AssemblyCycle;
use judder_store::{ByName, Results, Variable};
use judder_structure::complex_modes::{ComplexMode, Verdict};
use judder_study::Progress;
use judder_study::outcome::Outcome;
use num_complex::Complex64;
use rayon::prelude::*;
use std::f64::consts::TAU;

/// What is told of the modes that grow.
#[derive(Results)]
#[results(arrays(modes), columns(modes))]
pub(super) struct ToldSqueal {
    /// how cycles are computed
    method: &'static str,
    /// whether it is proven that the band has no other modes
    complete: bool,
    /// modes of the band that grow
    unstable: usize,
    /// those of which a cycle was found
    found: usize,
    /// the level of the loudest cycle, in dB re 1 µm/s²
    level_db: Option<f64>,
    /// its frequency, in Hz
    frequency_hz: Option<f64>,
    /// each mode that grows, by rising frequency
    #[result(rows)]
    modes: Vec<SquealingMode>,
}

/// A mode that grows, and its cycle, of which all is missing where none was found.
#[derive(Clone, Results)]
#[results(
    rows = "mode",
    arrays(mode, mode_frequency, growth_rate, frequency, level, left_out),
    columns(
        mode,
        place_by_level,
        rank_by_growth,
        mode_frequency,
        growth_rate,
        frequency,
        frequency_shift,
        level,
        stick_share,
        slip_share,
        open_share,
        stability,
        left_out,
        reason
    )
)]
pub(super) struct SquealingMode {
    /// number of the mode among those of the band that grow, by rising frequency
    mode: i64,
    /// its place from the loudest on
    rank_by_level: Option<usize>,
    #[result(hidden, column = "rank_by_level")]
    place_by_level: Option<f64>,
    /// its place from the fastest growing on
    rank_by_growth: i64,
    /// frequency of the mode about steady sliding
    #[result(summary = "mode_frequency_hz", unit = "Hz")]
    mode_frequency: f64,
    /// growth rate of the mode about steady sliding
    #[result(summary = "mode_growth_rate", unit = "1/s")]
    growth_rate: f64,
    /// frequency of the cycle
    #[result(summary = "frequency_hz", unit = "Hz")]
    frequency: Option<f64>,
    /// by how much that lies above the frequency of the mode, over it
    frequency_shift: Option<f64>,
    /// level of the acceleration of the cycle at the observed point that is loudest, re 1 µm/s²
    #[result(summary = "level_db", unit = "dB")]
    level: Option<f64>,
    /// the levels of all observed points along each direction, in dB re 1 µm/s²
    levels: ByName<Option<f64>>,
    /// share of the period in which contact points stick, on average over them
    stick_share: Option<f64>,
    /// in which they slide
    slip_share: Option<f64>,
    /// in which they have lifted off
    open_share: Option<f64>,
    /// whether motions of its shape nearby are drawn to it
    attracts: Option<bool>,
    /// whether all motions nearby are, where that is known
    stable: Option<bool>,
    /// the same in words, or why it is not known
    stability: &'static str,
    /// its harmonics
    harmonics: Option<usize>,
    /// the share of the swing of the contact forces beyond the harmonics of the cycle, as a root of energies
    #[result(unit = "1")]
    left_out: Option<f64>,
    /// why there is no cycle, or why it has no more harmonics
    reason: String,
}

/// What a cycle is told of in a list of them.
struct CycleInBand {
    frequency: f64,
    levels: Vec<(String, Option<f64>)>,
    shares: [f64; 3],
    attracts: bool,
    stable: Option<bool>,
    stability: &'static str,
    harmonics: usize,
    left_out: f64,
    held_back: Option<String>,
    residual: f64,
    imbalance: f64,
}

/// A mode with what became of it: its cycle, or why there is none.
type SoughtMode = (Complex64, Result<CycleInBand, String>);

pub(super) fn run(
    of: &AssemblySubject<'_>,
    asked: &AssemblySqueal,
    progress: &dyn Progress,
) -> Result<Outcome, ModelError> {
    let steady = of.steady_to_march()?;
    let about = Linearised::new(&of.built.assembly, &steady, LinearisedTerms::default())?;
    let all = found(&about.problem, &band(asked.band[0], asked.band[1]))?;
    let grows = |mode: &&ComplexMode| {
        mode.eigenvalue.verdict() == Verdict::Unstable && mode.eigenvalue.value.im > 0.0
    };
    let values: Vec<Complex64> = all.modes.iter().filter(grows).map(|mode| mode.eigenvalue.value).collect();
    let settings = asked.solver.settings(components(of)?);
    let sought = |value: &Complex64| -> Result<SoughtMode, ModelError> {
        progress.go_on()?;
        let sought = CycleOfMode::new(of, &steady, *value, &settings)?;
        let cycle = match sought.cycle() {
            Some(cycle) => Ok(CycleInBand::new(of, &sought, cycle, asked.solver.stability)?),
            None => Err(sought.reason().unwrap_or_default()),
        };
        Ok((*value, cycle))
    };
    let modes: Vec<SoughtMode> = values.par_iter().map(sought).collect::<Result<_, _>>()?;
    let told = ToldSqueal::new(all.complete(), ranked(&modes));
    let mut warnings = of.doubts(&steady);
    if !told.complete {
        warnings.push("it is not proven that the band has no other modes".to_owned());
    }
    for mode in told.modes.iter().filter(|mode| !mode.reason.is_empty()) {
        warnings.push(format!("mode at {:.1} Hz: {}", mode.mode_frequency, mode.reason));
    }
    let missing = told.unstable - told.found + usize::from(!told.complete);
    let cycles = || modes.iter().filter_map(|(_, cycle)| cycle.as_ref().ok());
    let checks = match told.found {
        0 => Vec::new(),
        found => checks(
            &format!("{found} cycles"),
            cycles().map(|own| own.residual).collect(),
            cycles().map(|own| own.imbalance).collect(),
        ),
    };
    let outcome = Outcome::of(&told)?;
    let dataset = outcome.dataset.clone().with(stabilities(&told.modes))?;
    Ok(Outcome { dataset, checks, warnings, missing, ..outcome })
}

/// Codes of what is known of the stability of cycles, in the order in which they are drawn.
pub(super) const STABILITIES: [(u8, &str); 4] =
    [(0, "stable cycle"), (1, "unstable cycle"), (2, "cycle of unknown stability"), (3, "no cycle found")];

fn stabilities(modes: &[SquealingMode]) -> Variable {
    let code = |mode: &SquealingMode| match (mode.frequency, mode.stable) {
        (None, _) => 3,
        (_, Some(true)) => 0,
        (_, Some(false)) => 1,
        (_, None) => 2,
    };
    let codes: Vec<u8> = modes.iter().map(code).collect();
    let variable = Variable::classes("stability", &["mode"], &[codes.len()], codes, &STABILITIES);
    variable.long_name("whether motions nearby are drawn to the cycle of a mode")
}

impl CycleInBand {
    fn new(
        of: &AssemblySubject<'_>,
        sought: &CycleOfMode<'_>,
        cycle: &AssemblyCycle<'_>,
        is_asked: bool,
    ) -> Result<Self, ModelError> {
        let stability = KnownStability::of(cycle, is_asked)?;
        let level_of = |own: &WatchedRow| -> Result<(String, Option<f64>), ModelError> {
            let level = level(acceleration_mean_square(cycle, &own.row)?);
            Ok((own.name.clone(), Some(level).filter(|level| level.is_finite())))
        };
        let points = cycle.points.len().max(1) as f64;
        let share = |k: usize| cycle.points.iter().map(|own| own.shares[k]).sum::<f64>() / points;
        Ok(Self {
            frequency: cycle.frequency() / TAU,
            levels: of.built.watched.iter().map(level_of).collect::<Result<_, _>>()?,
            shares: [share(0), share(1), share(2)],
            attracts: cycle.attracts,
            stable: stability.is_stable(),
            stability: stability.words(),
            harmonics: cycle.balance.series().harmonics(),
            left_out: cycle.quality.left_out,
            held_back: sought.held_back(),
            residual: cycle.motion.residual,
            imbalance: cycle.power(INSTANTS)?.imbalance(),
        })
    }

    /// That of the observed point that is loudest.
    fn level(&self) -> Option<f64> {
        self.levels.iter().filter_map(|(_, level)| *level).reduce(f64::max)
    }
}

/// The modes with their places by loudness and by growth.
fn ranked(modes: &[SoughtMode]) -> Vec<SquealingMode> {
    let level = |(_, cycle): &SoughtMode| cycle.as_ref().ok().and_then(CycleInBand::level);
    let louder = |than: f64| modes.iter().filter(|own| level(own).is_some_and(|own| own > than)).count();
    let faster = |than: f64| modes.iter().filter(|(value, _)| value.re > than).count();
    let told = modes.iter().enumerate().map(|(k, own)| {
        let (value, cycle) = own;
        let rank = level(own).map(|level| 1 + louder(level));
        let cycle_or_none = cycle.as_ref().ok();
        let share = |k: usize| cycle_or_none.map(|own| own.shares[k]);
        let frequency = cycle_or_none.map(|own| own.frequency);
        SquealingMode {
            mode: 1 + k as i64,
            rank_by_level: rank,
            place_by_level: rank.map(|rank| rank as f64),
            rank_by_growth: 1 + faster(value.re) as i64,
            mode_frequency: value.im / TAU,
            growth_rate: value.re,
            frequency,
            frequency_shift: frequency.map(|own| TAU * own / value.im - 1.0),
            level: level(own),
            levels: cycle_or_none.map(|own| own.levels.clone()).into_iter().flatten().collect(),
            stick_share: share(0),
            slip_share: share(1),
            open_share: share(2),
            attracts: cycle_or_none.map(|own| own.attracts),
            stable: cycle_or_none.and_then(|own| own.stable),
            stability: cycle_or_none.map_or("no cycle", |own| own.stability),
            harmonics: cycle_or_none.map(|own| own.harmonics),
            left_out: cycle_or_none.map(|own| own.left_out),
            reason: match cycle {
                Ok(own) => own.held_back.clone().unwrap_or_default(),
                Err(reason) => format!("no limit cycle: {reason}"),
            },
        }
    });
    told.collect()
}

impl ToldSqueal {
    fn new(complete: bool, modes: Vec<SquealingMode>) -> Self {
        let loudest = modes.iter().find(|mode| mode.rank_by_level == Some(1));
        Self {
            method: CycleMethod::HarmonicBalance.name(),
            complete,
            unstable: modes.len(),
            found: modes.iter().filter(|mode| mode.frequency.is_some()).count(),
            level_db: loudest.and_then(|mode| mode.level),
            frequency_hz: loudest.and_then(|mode| mode.frequency),
            modes,
        }
    }
}
