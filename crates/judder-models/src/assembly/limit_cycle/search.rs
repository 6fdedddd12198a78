//! The cycles of a mode, and in words why there is none.

use crate::error::ModelError;
use judder_assembly::assembly::Assembly;
use judder_assembly::row::Row;
use judder_assembly::steady::SteadySliding;
use judder_cycles::CyclesError;
use judder_cycles::backbone::BackboneEnd;
use judder_cycles::cycle::{AssemblyCycle, CycleSearch, CycleSettings, HarmonicCount, limit_cycles};
use judder_study::Progress;
use num_complex::Complex64;

/// What became of a mode.
pub(in crate::assembly) struct CycleOfMode<'a> {
    /// Its eigenvalue about steady sliding.
    pub(in crate::assembly) eigenvalue: Complex64,
    /// Its motions and cycles, or why not even a small motion was found.
    found: Result<CycleSearch<'a>, CyclesError>,
    /// How they were sought.
    settings: CycleSettings,
}

impl<'a> CycleOfMode<'a> {
    /// Seeks the cycle of a mode.
    pub(in crate::assembly) fn new(
        assembly: &'a Assembly,
        steady: &SteadySliding,
        eigenvalue: Complex64,
        settings: &CycleSettings,
        progress: &dyn Progress,
    ) -> Result<Self, ModelError> {
        let found = match limit_cycles(assembly, steady, eigenvalue, settings, &|| !progress.interrupted()) {
            Err(error @ (CyclesError::NotConverged { .. } | CyclesError::Shrunk | CyclesError::Singular)) => {
                Err(error)
            }
            other => Ok(other?),
        };
        Ok(Self { eigenvalue, found, settings: *settings })
    }

    /// The cycle.
    pub(in crate::assembly) fn cycle(&self) -> Option<&AssemblyCycle<'a>> {
        self.found.as_ref().ok()?.cycles.first()
    }

    /// Amplitude, of that at which the contact first changes its state, with σ in 1/s and ω in rad/s of each motion that was found.
    pub(in crate::assembly) fn motions(&self) -> Vec<[f64; 3]> {
        let Ok(found) = &self.found else { return Vec::new() };
        let backbone = &found.backbone;
        let of = |amplitude: f64| amplitude / backbone.first_change;
        let told = backbone.motions.iter();
        told.map(|own| [of(own.amplitude), own.turning.growth, own.turning.frequency]).collect()
    }

    /// The amplitude of the cycle as few harmonics have it, of that at which the contact first changes its state.
    pub(in crate::assembly) fn amplitude(&self) -> Option<f64> {
        let backbone = &self.found.as_ref().ok()?.backbone;
        backbone.cycles.first().map(|(own, _)| own.amplitude / backbone.first_change)
    }

    /// Why the cycle has fewer harmonics than it should.
    pub(in crate::assembly) fn held_back(&self) -> Option<String> {
        let (cycle, count) = (self.cycle()?, self.settings.harmonics);
        let why = match (&cycle.held_back, count) {
            (Some(error), _) => format!("with more it was not found ({error})"),
            (None, HarmonicCount::Adaptive { left_out, most }) if cycle.quality.left_out > left_out => {
                format!("{most} are the most that are taken where `harmonics` is not given")
            }
            _ => return None,
        };
        Some(format!(
            "the cycle has {} harmonics, which leave {:.2} % of the swing of the contact forces out: {why}",
            cycle.balance.series().harmonics(),
            100.0 * cycle.quality.left_out,
        ))
    }

    /// Why there is no cycle.
    pub(in crate::assembly) fn reason(&self) -> Option<String> {
        let found = match &self.found {
            Ok(found) if !found.cycles.is_empty() => return None,
            Ok(found) => found,
            Err(error) => return Some(format!("not even a small motion of the mode was found: {error}")),
        };
        let backbone = &found.backbone;
        let reached = backbone.motions.iter().map(|own| own.amplitude / backbone.first_change);
        let reached = reached.fold(0.0, f64::max);
        let all = match self.eigenvalue.re > 0.0 {
            true => "grow, with three harmonics, at every amplitude",
            false => "decay, with three harmonics, at every amplitude",
        };
        Some(match &backbone.end {
            BackboneEnd::Found | BackboneEnd::Largest => format!(
                "motions of the mode {all} up to {:.3} times that at which the contact first changes its state",
                self.settings.backbone.largest,
            ),
            BackboneEnd::Points => format!(
                "motions of the mode {all} of {} that were followed, up to {reached:.3} times that at which the contact first changes its state",
                backbone.motions.len(),
            ),
            BackboneEnd::Shrunk => format!(
                "motions of the mode {all} up to {reached:.3} times that at which the contact first changes its state, and come back to small ones"
            ),
            BackboneEnd::Lost(error) => format!(
                "motions of the mode {all} up to {reached:.3} times that at which the contact first changes its state, and were lost there: {error}"
            ),
        })
    }
}

/// That harmonics, of a number that was asked for, leave much out.
pub(in crate::assembly) fn left_out(share: f64) -> Option<String> {
    /// Of the swing of the contact forces.
    const MUCH: f64 = 0.1;
    (share > MUCH).then(|| {
        format!(
            "the harmonics leave {:.0} % of the swing of the contact forces out: give more of them",
            100.0 * share
        )
    })
}

/// The harmonics of a signal from the first on, differentiated so many times, once or twice.
pub(in crate::assembly) fn differentiated(
    cycle: &AssemblyCycle<'_>,
    coefficients: &[f64],
    times: usize,
) -> Vec<f64> {
    let harmonics = coefficients[1..].chunks_exact(2).zip(1..);
    let turned = harmonics.flat_map(|(own, harmonic)| {
        let omega = f64::from(harmonic) * cycle.frequency();
        match times {
            1 => [omega * own[1], -omega * own[0]],
            _ => [own[0], own[1]].map(|part| -omega * omega * part),
        }
    });
    turned.collect()
}

/// The mean square of the acceleration along a form on the freedoms, in m²/s⁴.
pub(in crate::assembly) fn acceleration_mean_square(
    cycle: &AssemblyCycle<'_>,
    row: &Row,
) -> Result<f64, ModelError> {
    let acceleration = differentiated(cycle, &cycle.followed(row)?, 2);
    Ok(acceleration.iter().map(|own| 0.5 * own * own).sum())
}
