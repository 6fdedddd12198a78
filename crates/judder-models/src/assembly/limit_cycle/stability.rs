//! Whether a cycle draws all motions nearby, by its Floquet multipliers.

use crate::assembly::AssemblySubject;
use crate::error::ModelError;
use judder_cycles::backbone::PeriodicMotion;
use judder_cycles::balance::HarmonicBalance;
use judder_cycles::stability::{
    CircleCrossing, CycleStability, FLOQUET_STEPS, FLOQUET_WIDER, FloquetMultipliers, HillMultipliers,
    HillRefusal, floquet_multipliers, hill_multipliers,
};
use judder_numerics::complex::ElementaryComplex;
use judder_store::{Dataset, Variable};
use judder_study::Progress;
use num_complex::Complex64;

/// What is known of it; nothing where it was not asked for.
pub(in crate::assembly) struct KnownStability {
    /// By steps.
    by_steps: Option<Result<FloquetMultipliers, CycleStability>>,
    /// By Hill's method, where it was asked.
    by_hill: Option<Result<HillMultipliers, HillRefusal>>,
}

/// What one of two ways says beside the other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::assembly) enum SecondOpinion {
    Same,
    Contrary,
    /// One finds a multiplier within its error of the unit circle, and the other does not.
    OneDecides,
}

impl KnownStability {
    /// That of a cycle, where it is asked for.
    pub(in crate::assembly) fn of(
        balance: &HarmonicBalance<'_>,
        motion: &PeriodicMotion,
        is_asked: bool,
        progress: &dyn Progress,
    ) -> Result<Self, ModelError> {
        let found = is_asked.then(|| floquet_multipliers(balance, motion, &|| !progress.interrupted()));
        Ok(Self { by_steps: found.transpose()?, by_hill: None })
    }

    /// With the opinion of Hill's method, up to so many rows of its eigenvalue problem; where stability was asked for.
    pub(in crate::assembly) fn and_by_hill(
        mut self,
        balance: &HarmonicBalance<'_>,
        motion: &PeriodicMotion,
        rows: usize,
        progress: &dyn Progress,
    ) -> Result<Self, ModelError> {
        if self.is_asked() {
            self.by_hill = Some(hill_multipliers(balance, motion, rows, &|| !progress.interrupted())?);
        }
        Ok(self)
    }

    /// Whether it was asked for.
    pub(in crate::assembly) fn is_asked(&self) -> bool {
        self.by_steps.is_some()
    }

    /// The multipliers with their error, where they are known.
    pub(in crate::assembly) fn known(&self) -> Option<&FloquetMultipliers> {
        self.by_steps.as_ref()?.as_ref().ok()
    }

    /// Those by Hill's method, where they are known.
    pub(in crate::assembly) fn by_hill(&self) -> Option<&HillMultipliers> {
        self.by_hill.as_ref()?.as_ref().ok()
    }

    /// All multipliers, that of the phase among them, the largest first.
    pub(in crate::assembly) fn multipliers(&self) -> Option<Vec<Complex64>> {
        self.known().map(|own| with_phase(&own.values, own.phase))
    }

    /// The same by Hill's method.
    pub(in crate::assembly) fn hill_multipliers(&self) -> Option<Vec<Complex64>> {
        self.by_hill().map(|own| with_phase(&own.values, own.phase))
    }

    /// How far the largest by either way lie from the nearest by the other.
    pub(in crate::assembly) fn apart(&self) -> Option<f64> {
        Some(self.known()?.apart_from(self.by_hill()?))
    }

    /// What the largest but that of the phase may be off.
    pub(in crate::assembly) fn error(&self) -> Option<f64> {
        self.known().map(|known| known.error)
    }

    fn verdict(&self) -> Option<CycleStability> {
        let by_steps = match self.by_steps.as_ref()? {
            Ok(known) => known.verdict(),
            Err(hindered) => return Some(*hindered),
        };
        Some(self.by_hill().map_or(by_steps, |hill| by_steps.agreed(hill.verdict())))
    }

    /// What Hill's method says beside what steps say, where both apply.
    pub(in crate::assembly) fn opinion(&self) -> Option<SecondOpinion> {
        let both = [self.known()?.verdict(), self.by_hill()?.verdict()];
        let decided = both.iter().filter(|own| **own != CycleStability::Undecided).count();
        Some(match decided {
            _ if both[0] == both[1] => SecondOpinion::Same,
            2 => SecondOpinion::Contrary,
            _ => SecondOpinion::OneDecides,
        })
    }

    /// What steps and Hill's method say, where that is not the same.
    fn disagreement(&self) -> Option<[CycleStability; 2]> {
        let both = [self.known()?.verdict(), self.by_hill()?.verdict()];
        (both[0] != both[1]).then_some(both)
    }

    /// What Hill's method adds to what steps say, in words.
    pub(in crate::assembly) fn second_opinion(&self) -> String {
        match (&self.by_steps, &self.by_hill) {
            (Some(Ok(_)), Some(Ok(hill))) => match self.disagreement() {
                None => "Hill's method says the same".to_owned(),
                Some(_) => format!("Hill's method says otherwise: {}", said(hill.verdict())),
            },
            (Some(Ok(_)), Some(Err(refusal))) => format!("steps alone: {refusal}"),
            (Some(Err(_)), _) => "neither steps nor Hill's method apply".to_owned(),
            _ => "not asked for".to_owned(),
        }
    }

    /// Whether it is stable, where that is known.
    pub(in crate::assembly) fn is_stable(&self) -> Option<bool> {
        match self.verdict()? {
            CycleStability::Stable => Some(true),
            CycleStability::Unstable => Some(false),
            CycleStability::Undecided | CycleStability::Impacts | CycleStability::TooLarge => None,
        }
    }

    /// What motions nearby become, as far as multipliers tell: periodic, or unknown with what it may be.
    pub(in crate::assembly) fn motion(&self) -> &'static str {
        match (self.is_stable(), self.known().and_then(|own| own.values.first())) {
            (Some(true), _) => "periodic: they come to the cycle",
            (Some(false), Some(one)) if one.im != 0.0 => {
                "unknown: they leave it turning about it, to quasi-periodic motion or elsewhere; a march tells"
            }
            (Some(false), Some(one)) if one.re < 0.0 => {
                "unknown: they leave it to either side in turns, to one of twice the period or elsewhere; a march tells"
            }
            (Some(false), _) => "unknown: they leave it; a march tells",
            (None, _) => "unknown, as the stability is",
        }
    }

    /// The same in words, with what hinders it.
    fn words(&self) -> &'static str {
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

    /// The same with what steps and Hill's method say where they disagree.
    pub(in crate::assembly) fn in_full(&self) -> String {
        match self.disagreement() {
            None => self.words().to_owned(),
            Some(both) => {
                let [steps, hill] = both.map(said);
                format!("undecided: by steps the cycle is {steps}, by Hill's method {hill}")
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
            _ => Some(format!("whether motions nearby are drawn to the cycle is {}", self.in_full())),
        }
    }
}

/// What a way says of a cycle.
fn said(stability: CycleStability) -> &'static str {
    match stability {
        CycleStability::Stable => "stable",
        CycleStability::Unstable => "unstable",
        _ => "on the unit circle, as far as it is known",
    }
}

/// All multipliers, the largest first, that of the phase among them.
pub(super) fn with_phase(values: &[Complex64], phase: Option<Complex64>) -> Vec<Complex64> {
    let mut all = values.to_vec();
    if let Some(phase) = phase {
        let place = all.partition_point(|own| own.modulus() > phase.modulus());
        all.insert(place, phase);
    }
    all
}

/// What the multipliers of a motion are reckoned from, in words, with Hill's method up to so many rows where it is asked; nothing where they are not asked for.
pub(in crate::assembly) fn multipliers_estimated(
    of: &AssemblySubject<'_>,
    is_asked: bool,
    hill_rows: Option<usize>,
) -> String {
    if !is_asked {
        return String::new();
    }
    let ([least, most], motions) = (FLOQUET_STEPS, 2 * of.built.assembly.size());
    let hill = hill_rows.map_or_else(String::new, |rows| format!(", and by Hill's method up to {rows} rows"));
    format!(
        ", Floquet multipliers by {} to {most} steps of up to {motions} small motions, once more with {FLOQUET_WIDER} times the harmonics{hill}",
        2 * least,
    )
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
    let apart: Vec<f64> = stabilities.iter().map(|own| own.apart().unwrap_or(f64::NAN)).collect();
    let dataset = match apart.iter().any(|own| own.is_finite()) {
        true => dataset.with(
            Variable::new("multipliers_apart", &[along], &[count], apart).units("1").long_name(
                "how far the largest by steps and by Hill's method lie from the nearest of the other",
            ),
        )?,
        false => dataset,
    };
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

#[cfg(test)]
mod tests {
    use super::*;

    fn known(steps: f64, hill: Result<f64, HillRefusal>) -> KnownStability {
        let values = |own: f64| vec![Complex64::new(own, 0.0)];
        let by_steps = FloquetMultipliers { values: values(steps), phase: None, steps: 512, error: 1e-2 };
        let by_hill = hill.map(|own| HillMultipliers { values: values(own), phase: None, error: 1e-4 });
        KnownStability { by_steps: Some(Ok(by_steps)), by_hill: Some(by_hill) }
    }

    #[test]
    fn two_ways_say_it_together_or_not_at_all() {
        let same = known(-1.2, Ok(-1.199));
        assert_eq!((same.is_stable(), same.opinion()), (Some(false), Some(SecondOpinion::Same)));
        assert_eq!(same.second_opinion(), "Hill's method says the same");
        assert!(same.motion().starts_with("unknown: they leave it to either side in turns"));
        let other = known(0.98, Ok(1.01));
        assert_eq!((other.is_stable(), other.opinion()), (None, Some(SecondOpinion::Contrary)));
        assert_eq!(other.in_full(), "undecided: by steps the cycle is stable, by Hill's method unstable");
        assert_eq!(other.second_opinion(), "Hill's method says otherwise: unstable");
        let finer = known(0.995, Ok(0.995));
        assert_eq!(
            finer.in_full(),
            "undecided: by steps the cycle is on the unit circle, as far as it is known, by Hill's method stable"
        );
        assert!((other.apart().unwrap_or_default() - 0.03).abs() < 1e-12);
    }

    /// Where one of them does not apply the other says it, and why it is alone.
    #[test]
    fn steps_alone_say_why() {
        let alone = known(0.9, Err(HillRefusal::NotSmooth { point: 2 }));
        assert_eq!((alone.is_stable(), alone.apart()), (Some(true), None));
        assert_eq!(
            alone.second_opinion(),
            "steps alone: contact point 3 sticks, turns, or is rigid: its force does not follow smoothly from its motion"
        );
        let hindered = KnownStability { by_steps: Some(Err(CycleStability::Impacts)), by_hill: None };
        assert_eq!(hindered.second_opinion(), "neither steps nor Hill's method apply");
        // a pair outside the circle leads to quasi-periodic motion or anywhere: that is not guessed
        assert!(alone.motion().starts_with("periodic") && hindered.motion().starts_with("unknown"));
        let values = vec![Complex64::new(0.9, 0.8), Complex64::new(0.9, -0.8)];
        let pair = FloquetMultipliers { values, phase: None, steps: 512, error: 1e-2 };
        let pair = KnownStability { by_steps: Some(Ok(pair)), by_hill: None };
        assert!(pair.motion().starts_with("unknown: they leave it turning about it, to quasi-periodic"));
    }
}
