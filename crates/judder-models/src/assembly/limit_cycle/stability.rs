//! Whether a cycle draws all motions nearby, by its Floquet multipliers.

use crate::error::ModelError;
use judder_cycles::backbone::PeriodicMotion;
use judder_cycles::balance::HarmonicBalance;
use judder_cycles::stability::{CircleCrossing, CycleStability, FloquetMultipliers, floquet_multipliers};
use judder_store::{Dataset, Variable};
use judder_study::Progress;
use num_complex::Complex64;

/// What is known of it; nothing where it was not asked for.
pub(in crate::assembly) struct KnownStability(Option<Result<FloquetMultipliers, CycleStability>>);

impl KnownStability {
    /// That of a cycle, where it is asked for.
    pub(in crate::assembly) fn of(
        balance: &HarmonicBalance<'_>,
        motion: &PeriodicMotion,
        is_asked: bool,
        progress: &dyn Progress,
    ) -> Result<Self, ModelError> {
        let found = is_asked.then(|| floquet_multipliers(balance, motion, &|| !progress.interrupted()));
        Ok(Self(found.transpose()?))
    }

    /// Whether it was asked for.
    pub(in crate::assembly) fn is_asked(&self) -> bool {
        self.0.is_some()
    }

    /// The multipliers with their error, where they are known.
    pub(in crate::assembly) fn known(&self) -> Option<&FloquetMultipliers> {
        self.0.as_ref()?.as_ref().ok()
    }

    /// All multipliers, that of the phase among them, the largest first.
    pub(in crate::assembly) fn multipliers(&self) -> Option<Vec<Complex64>> {
        let known = self.known()?;
        let mut all = known.values.clone();
        if let Some(phase) = known.phase {
            let place = all.partition_point(|own| own.norm() > phase.norm());
            all.insert(place, phase);
        }
        Some(all)
    }

    /// What the largest but that of the phase may be off.
    pub(in crate::assembly) fn error(&self) -> Option<f64> {
        self.known().map(|known| known.error)
    }

    fn verdict(&self) -> Option<CycleStability> {
        self.0.as_ref().map(|found| match found {
            Ok(known) => known.verdict(),
            Err(hindered) => *hindered,
        })
    }

    /// Whether it is stable, where that is known.
    pub(in crate::assembly) fn is_stable(&self) -> Option<bool> {
        match self.verdict()? {
            CycleStability::Stable => Some(true),
            CycleStability::Unstable => Some(false),
            CycleStability::Undecided | CycleStability::Impacts | CycleStability::TooLarge => None,
        }
    }

    /// The same in words, with what hinders it.
    pub(in crate::assembly) fn words(&self) -> &'static str {
        match self.verdict() {
            None => "not asked for",
            Some(CycleStability::Stable) => "stable",
            Some(CycleStability::Unstable) => "unstable",
            Some(CycleStability::Undecided) => {
                "undecided: the largest multiplier lies on the unit circle, as far as it is known"
            }
            Some(CycleStability::Impacts) => {
                "unknown: rigid points open and close, and what their impacts do to small motions is not followed"
            }
            Some(CycleStability::TooLarge) => {
                "unknown: the bodies have too many coordinates for a monodromy matrix; reduce them"
            }
        }
    }

    /// What has to be said of it.
    pub(in crate::assembly) fn doubt(&self) -> Option<String> {
        match self.verdict()? {
            CycleStability::Stable => None,
            CycleStability::Unstable => {
                let largest = self.known().map_or(f64::NAN, FloquetMultipliers::largest);
                Some(format!(
                    "motions nearby leave the cycle, with a Floquet multiplier of modulus {largest:.4}: no march comes to it"
                ))
            }
            _ => Some(format!("whether motions nearby are drawn to the cycle is {}", self.words())),
        }
    }
}

/// Whether motions along a branch are stable, and their largest multipliers where they are known, with what the largest may be off.
pub(in crate::assembly) fn with_multipliers(
    dataset: Dataset,
    along: &str,
    stabilities: &[&KnownStability],
) -> Result<Dataset, ModelError> {
    /// Multipliers of a motion.
    const LARGEST: usize = 10;
    let count = stabilities.len();
    let stable: Vec<u8> = stabilities.iter().map(|own| own.is_stable().map_or(2, u8::from)).collect();
    let words = format!("whether motions nearby are drawn to the {along}: 0 no, 1 yes, 2 unknown");
    let dataset = dataset.with(Variable::new("stable", &[along], &[count], stable).long_name(&words))?;
    let all: Vec<Option<Vec<Complex64>>> = stabilities.iter().map(|own| own.multipliers()).collect();
    let most = all.iter().flatten().map(Vec::len).max().unwrap_or(0).min(LARGEST);
    if most == 0 {
        return Ok(dataset);
    }
    let missing = Complex64::new(f64::NAN, f64::NAN);
    let of = |own: &Option<Vec<Complex64>>| -> Vec<Complex64> {
        (0..most).map(|k| own.as_ref().and_then(|own| own.get(k)).copied().unwrap_or(missing)).collect()
    };
    let values: Vec<Complex64> = all.iter().flat_map(of).collect();
    let errors: Vec<f64> = stabilities.iter().map(|own| own.error().unwrap_or(f64::NAN)).collect();
    Ok(dataset
        .with(
            Variable::new("floquet_multipliers", &[along, "multiplier"], &[count, most], values)
                .units("1")
                .long_name(
                    "Floquet multipliers, the largest first, with that of the phase where nothing drives",
                ),
        )?
        .with(
            Variable::new("floquet_error", &[along], &[count], errors)
                .units("1")
                .long_name("what the largest of them but that of the phase may be off"),
        )?)
}

/// How multipliers crossed the unit circle, in words.
pub(in crate::assembly) fn crossing_words(crossing: CircleCrossing) -> &'static str {
    match crossing {
        CircleCrossing::AtOne => "fold or branch point",
        CircleCrossing::AtMinusOne => "period doubling",
        CircleCrossing::Pair => "Neimark–Sacker bifurcation",
        CircleCrossing::Unknown => "change of stability of unknown kind",
    }
}
