//! The cycle of a mode in a band, or why there is none.

use crate::assembly::AssemblySubject;
use crate::assembly::build::WatchedRow;
use crate::assembly::limit_cycle::checks::INSTANTS;
use crate::assembly::limit_cycle::search::{CycleOfMode, acceleration_mean_square};
use crate::assembly::limit_cycle::stability::KnownStability;
use crate::assembly::march::levels::level;
use crate::error::ModelError;
use judder_cycles::cycle::AssemblyCycle;
use judder_cycles::stability::HILL_ROWS;
use judder_study::Progress;
use num_complex::Complex64;
use std::f64::consts::TAU;

/// What a cycle is told of in a list of them.
pub(super) struct CycleInBand {
    pub(super) frequency: f64,
    pub(super) levels: Vec<(String, Option<f64>)>,
    pub(super) shares: [f64; 3],
    pub(super) attracts: Option<bool>,
    pub(super) stable: Option<bool>,
    pub(super) stability: String,
    pub(super) second_opinion: String,
    pub(super) harmonics: usize,
    pub(super) left_out: f64,
    /// Why the harmonics leave more out than they may.
    pub(super) unconverged: Option<String>,
    pub(super) residual: f64,
    pub(super) imbalance: f64,
}

/// A mode with what became of it: its cycle, or why there is none.
pub(super) type SoughtMode = (Complex64, Result<CycleInBand, String>);

impl CycleInBand {
    pub(super) fn new(
        of: &AssemblySubject<'_>,
        sought: &CycleOfMode<'_>,
        cycle: &AssemblyCycle<'_>,
        is_asked: bool,
        progress: &dyn Progress,
    ) -> Result<Self, ModelError> {
        let stability = KnownStability::of(&cycle.balance, &cycle.motion, is_asked, progress)?.and_by_hill(
            &cycle.balance,
            &cycle.motion,
            HILL_ROWS,
            progress,
        )?;
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
            stability: stability.in_full(),
            second_opinion: stability.second_opinion(),
            harmonics: cycle.balance.series().harmonics(),
            left_out: cycle.quality.left_out,
            unconverged: sought.unconverged(),
            residual: cycle.motion.residual,
            imbalance: cycle.power(INSTANTS)?.imbalance(),
        })
    }

    /// That of the observed point that is loudest.
    pub(super) fn level(&self) -> Option<f64> {
        self.levels.iter().filter_map(|(_, level)| *level).reduce(f64::max)
    }

    /// How loud that is, where it is anything.
    pub(super) fn loudness(&self) -> Option<CycleLoudness> {
        self.level().map(|level| CycleLoudness { level, is_left: self.stable == Some(false) })
    }
}

/// What cycles are ranked by.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct CycleLoudness {
    level: f64,
    /// Whether motions nearby leave it, so that it is not heard.
    is_left: bool,
}

impl CycleLoudness {
    /// Whether it stands before another.
    pub(super) fn is_ahead(self, other: Self) -> bool {
        match self.is_left == other.is_left {
            true => self.level > other.level,
            false => other.is_left,
        }
    }
}
