//! The cycles of a mode, and in words why there is none.

use crate::error::ModelError;
use judder_assembly::assembly::Assembly;
use judder_assembly::row::Row;
use judder_assembly::steady::SteadySliding;
use judder_cycles::CyclesError;
use judder_cycles::backbone::BackboneEnd;
use judder_cycles::cycle::{AssemblyCycle, CycleSearch, CycleSettings, HarmonicCount, limit_cycles};
use judder_study::Progress;
use judder_study::text::short;
use num_complex::Complex64;

/// What became of a mode.
pub(in crate::assembly) struct CycleOfMode<'a> {
    /// Its eigenvalue about steady sliding.
    pub(in crate::assembly) eigenvalue: Complex64,
    found: Found<'a>,
    /// How they were sought.
    settings: CycleSettings,
}

/// What was found, and where.
enum Found<'a> {
    /// Motions and cycles of the mode, or why not even a small motion was found.
    AlongMode(Result<CycleSearch<'a>, CyclesError>),
    /// The cycle near a motion that was known from elsewhere, or why there is none.
    Near(Result<Box<AssemblyCycle<'a>>, CyclesError>),
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
            Err(error) if error.is_of_the_motion() => Err(error),
            other => Ok(other?),
        };
        Ok(Self { eigenvalue, found: Found::AlongMode(found), settings: *settings })
    }

    /// A cycle that was found elsewhere, or why none was, beside a mode.
    pub(in crate::assembly) fn near(
        eigenvalue: Complex64,
        found: Result<AssemblyCycle<'a>, CyclesError>,
        settings: &CycleSettings,
    ) -> Self {
        Self { eigenvalue, found: Found::Near(found.map(Box::new)), settings: *settings }
    }

    /// Whether motions of the mode were followed.
    pub(in crate::assembly) fn follows_a_mode(&self) -> bool {
        matches!(self.found, Found::AlongMode(_))
    }

    /// The motions of the mode, where these were followed.
    fn search(&self) -> Option<&CycleSearch<'a>> {
        match &self.found {
            Found::AlongMode(found) => found.as_ref().ok(),
            Found::Near(_) => None,
        }
    }

    /// The cycle.
    pub(in crate::assembly) fn cycle(&self) -> Option<&AssemblyCycle<'a>> {
        match &self.found {
            Found::AlongMode(found) => found.as_ref().ok()?.cycles.first(),
            Found::Near(found) => found.as_deref().ok(),
        }
    }

    /// Amplitude, of that at which the contact first changes its state, with σ in 1/s and ω in rad/s of each motion that was found.
    pub(in crate::assembly) fn motions(&self) -> Vec<[f64; 3]> {
        let Some(found) = self.search() else { return Vec::new() };
        let backbone = &found.backbone;
        let of = |amplitude: f64| amplitude / backbone.first_change;
        let told = backbone.motions.iter();
        told.map(|own| [of(own.amplitude), own.turning.growth, own.turning.frequency]).collect()
    }

    /// The amplitude of the cycle, of that at which the contact first changes its state along the motions of the mode.
    pub(in crate::assembly) fn amplitude(&self) -> Option<f64> {
        let search = self.search()?;
        search.cycles.first().map(|own| own.motion.amplitude / search.backbone.first_change)
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

    /// Why the harmonics of the cycle leave more out than they may; nothing where there is none.
    pub(in crate::assembly) fn unconverged(&self) -> Option<String> {
        self.held_back().or_else(|| left_out(self.cycle()?.quality.left_out))
    }

    /// Why there is no cycle.
    pub(in crate::assembly) fn reason(&self) -> Option<String> {
        let found = match &self.found {
            Found::Near(found) => return found.as_ref().err().map(ToString::to_string),
            Found::AlongMode(Ok(found)) if !found.cycles.is_empty() => return None,
            Found::AlongMode(Ok(found)) => found,
            Found::AlongMode(Err(error)) => {
                return Some(format!("not even a small motion of the mode was found: {error}"));
            }
        };
        let backbone = &found.backbone;
        let reached = backbone.motions.iter().map(|own| own.amplitude / backbone.first_change);
        let reached = short(reached.fold(0.0, f64::max));
        let does = if self.eigenvalue.re > 0.0 { "grow" } else { "decay" };
        let all = format!("{does}, {}, at every amplitude", with_harmonics(&found.followed_with));
        Some(match &backbone.end {
            BackboneEnd::Found | BackboneEnd::Largest => format!(
                "motions of the mode {all} up to {} times that at which the contact first changes its state",
                short(self.settings.backbone.largest),
            ),
            BackboneEnd::Points => format!(
                "motions of the mode {all} of {} that were followed, up to {reached} times that at which the contact first changes its state",
                backbone.motions.len(),
            ),
            BackboneEnd::Shrunk => format!(
                "motions of the mode {all} up to {reached} times that at which the contact first changes its state, and come back to small ones"
            ),
            BackboneEnd::Lost(error) => format!(
                "motions of the mode {all} up to {reached} times that at which the contact first changes its state, and were lost there: {error}"
            ),
        })
    }
}

/// With how many harmonics motions were followed last, and with how many before.
fn with_harmonics(counts: &[usize]) -> String {
    let told: Vec<String> = counts.iter().map(ToString::to_string).collect();
    match told.as_slice() {
        [before @ .., last] if !before.is_empty() => {
            format!("with {last} harmonics (no cycle with {} either)", before.join(" and "))
        }
        all => format!("with {} harmonics", all.concat()),
    }
}

/// The share of the swing of the contact forces that harmonics of a number that was asked for may leave out.
const MUCH: f64 = 0.1;

/// Whether harmonics of a number that was asked for leave no more out than they may.
pub(in crate::assembly) fn is_converged(share: f64) -> bool {
    share <= MUCH
}

/// That they leave more out.
pub(in crate::assembly) fn left_out(share: f64) -> Option<String> {
    (!is_converged(share)).then(|| {
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
