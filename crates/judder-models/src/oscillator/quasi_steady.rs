//! Eq. (3) of the oscillator paper at the operating points of a case: its figures, and the one sentence that tells of them.

use super::steady_states::SteadyState;
use crate::bridge;
use crate::error::ModelError;
use crate::material::Material;
use crate::oscillator::case::OscillatorCase;
use crate::oscillator::inputs::OscillatorInputs;
use crate::oscillator::keys::OscillatorKey;
use judder_contact::law::material::LawTerm;
use judder_oscillator::Contact;
use judder_oscillator::quasi_steady::{QuasiSteady, Standing};
use judder_store::{Results, number};
use judder_study::text::short;
use serde_json::{Map, Value, json};

/// Eq. (3) at an operating point, with the frequency that turns its figures into times.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct QuasiSteadyCondition {
    /// The figures, to be small against 1.
    pub figures: QuasiSteady,
    /// ω_nx, or that of a mode, rad/s.
    pub natural_frequency: f64,
}

/// A contact that slides, as far as eq. (3) asks: v τ/R, and half its length a/R.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SlidingTimes {
    pub(crate) velocity: f64,
    /// Not a number where nothing is known of steady sliding.
    pub(crate) half_length: f64,
}

/// What is told of eq. (3) at the operating points of a case.
#[derive(Results)]
pub(crate) struct ToldCondition {
    #[result(unit = "1")]
    quasi_steady_figure: f64,
    #[result(unit = "1")]
    quasi_steady_longest: f64,
    #[result(unit = "1")]
    quasi_steady_memory: f64,
}

/// The terms of the substrate of a case, as a law knows them; none of an elastic one.
///
/// # Errors
/// Data that cannot be read or fitted.
pub(crate) fn terms(case: &OscillatorCase) -> Result<Vec<LawTerm>, ModelError> {
    Ok(Material::new(&case.substrate, &case.inputs)?.of_law().terms)
}

impl QuasiSteadyCondition {
    /// At these inputs, to which the material was told; `None` for an elastic substrate. The memory is not a number where nothing is known
    /// of steady sliding.
    pub(crate) fn at(
        inputs: &OscillatorInputs,
        contact: Option<&Contact>,
        terms: &[LawTerm],
    ) -> Option<Self> {
        let steady = contact.and_then(|contact| SteadyState::new(contact, inputs).ok());
        let half_length = steady.zip(contact).map_or(f64::NAN, |(steady, contact)| {
            contact.law.half_length(steady.equilibrium.response.area.value)
        });
        let sliding = SlidingTimes { velocity: bridge::groups(inputs).velocity, half_length };
        let frequency = inputs.number(OscillatorKey::NaturalFrequency);
        Self::of_motion(frequency, inputs, sliding, terms)
    }

    /// For small motions of this frequency, rad/s, on the substrate of these inputs.
    pub(crate) fn of_motion(
        frequency: f64,
        inputs: &OscillatorInputs,
        SlidingTimes { velocity, half_length }: SlidingTimes,
        terms: &[LawTerm],
    ) -> Option<Self> {
        let figure = frequency * inputs.number(OscillatorKey::RetardationTime);
        let figures = QuasiSteady::new(figure, velocity, half_length, terms)?;
        Some(Self { figures, natural_frequency: frequency })
    }

    /// Whether motions are beyond what a law of steady sliding holds for.
    pub(crate) fn is_broken(&self) -> bool {
        Standing::of(self.figures.figure) == Standing::Broken
    }

    /// The largest figures over operating points.
    pub(crate) fn worst(
        points: impl Iterator<Item = OscillatorInputs>,
        contact: Option<&Contact>,
        terms: &[LawTerm],
    ) -> Option<Self> {
        points.filter_map(|inputs| Self::at(&inputs, contact, terms)).reduce(|worst, other| {
            let [mut worst, other] =
                if other.figures.figure > worst.figures.figure { [other, worst] } else { [worst, other] };
            worst.figures.memory = worst.figures.memory.max(other.figures.memory);
            worst
        })
    }

    /// What `summary.json` shows.
    pub(crate) fn told(&self) -> ToldCondition {
        let QuasiSteady { figure, longest, memory } = self.figures;
        ToldCondition {
            quasi_steady_figure: figure,
            quasi_steady_longest: longest,
            quasi_steady_memory: memory,
        }
    }

    /// What `judder point --json` shows.
    #[must_use]
    pub fn json(&self) -> Value {
        let second = |figure: f64| number(figure / self.natural_frequency);
        let QuasiSteady { figure, longest, memory } = self.figures;
        json!({
            "figure": number(figure), "time_second": second(figure),
            "longest": number(longest), "longest_time_second": second(longest),
            "memory": number(memory), "memory_time_second": second(memory),
            "standing": Standing::of(figure).name(),
        })
    }

    /// Name and value of each figure, for the terminal.
    pub(crate) fn rows(&self) -> Vec<Vec<String>> {
        let QuasiSteady { figure, longest, memory } = self.figures;
        let time = |figure: f64| format!("{} s", short(figure / self.natural_frequency));
        let mut rows = vec![vec![
            "ω_nx τ, eq. (3) asks ≪ 1".to_owned(),
            format!("{}, {}", short(figure), Standing::of(figure).name()),
            time(figure),
        ]];
        if longest > figure {
            rows.push(vec!["  of the longest time".to_owned(), short(longest), time(longest)]);
        }
        if memory.is_finite() {
            rows.push(vec!["  by which the contact is behind".to_owned(), short(memory), time(memory)]);
        }
        rows
    }

    /// That eq. (3) is broken, in words, with its largest figure over the `motions` that were found; `None` where neither the figures
    /// nor the motions break it.
    pub(crate) fn warning(&self, motions: Option<f64>) -> Option<String> {
        let QuasiSteady { figure, longest, memory } = self.figures;
        if !self.is_broken() {
            let broken = motions.filter(|motions| Standing::of(*motions) == Standing::Broken)?;
            return Some(format!(
                "eq. (3), the condition of steady-sliding laws in motion, is broken by the motions: |(ω − v_d/A_x) τ| is up to {} where ≪ 1 is \
                 asked, although ω_nx τ = {}: while it is, the contact is not in step with them, and they are those of the law alone",
                short(broken),
                short(figure)
            ));
        }
        let time = |figure: f64| format!("{} s", short(figure / self.natural_frequency));
        let mut words = format!(
            "eq. (3), the condition of steady-sliding laws in motion, is broken: ω_nx τ = {} with τ = {}",
            short(figure),
            time(figure)
        );
        if longest > figure {
            let longest = (short(longest), time(longest));
            words.push_str(&format!(
                ", the mean retardation time ({} with the longest, {})",
                longest.0, longest.1
            ));
        }
        words.push_str(", where ≪ 1 is asked: the contact is not in step with the motion, so verdicts and motions are those of the law alone");
        if memory.is_finite() {
            let much = match Standing::of(memory) {
                Standing::Holds => "which is small",
                Standing::Borderline => "which is borderline",
                Standing::Broken => "which is no smaller than 1 either",
            };
            words.push_str(&format!(
                "; while it passes its own length it forgets, and is behind by T = {}, ω_nx T = {}, {much}",
                time(memory),
                short(memory)
            ));
        }
        if let Some(motions) = motions {
            words.push_str(&format!("; |(ω − v_d/A_x) τ| of the motions is up to {}", short(motions)));
        }
        Some(words)
    }
}

/// The largest magnitude of eq. (3) over the motions that an analysis found, where it tells of it.
pub(crate) fn of_motions(scalars: &Map<String, Value>) -> Option<f64> {
    if let Some(largest) = scalars.get("quasi_steady").and_then(|told| told.get("largest")) {
        return largest.as_f64();
    }
    let each = scalars.get("quasi_steady_condition")?.as_array()?;
    each.iter().filter_map(Value::as_f64).map(f64::abs).reduce(f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn condition(figure: f64, longest: f64, memory: f64) -> QuasiSteadyCondition {
        QuasiSteadyCondition { figures: QuasiSteady { figure, longest, memory }, natural_frequency: 100.0 }
    }

    #[test]
    fn what_is_broken_is_told_with_the_times_that_make_it() {
        assert_eq!(condition(0.4, 0.4, 0.4).warning(Some(0.9)), None);
        assert_eq!(condition(0.4, 0.4, 0.4).warning(None), None);
        let told = condition(0.4, 0.4, 0.4).warning(Some(157.0)).unwrap();
        assert!(told.contains("is up to 157") && told.contains("ω_nx τ = 0.4"), "{told}");
        let told = condition(164.0, 2125.0, 0.02).warning(None).unwrap();
        for part in
            ["ω_nx τ = 164", "τ = 1.64 s", "2125 with the longest, 21.25 s", "ω_nx T = 0.02, which is small"]
        {
            assert!(told.contains(part), "{part}: {told}");
        }
        let told = condition(2.0, 2.0, f64::NAN).warning(Some(7.5)).unwrap();
        assert!(told.ends_with("of the motions is up to 7.5") && !told.contains("longest"), "{told}");
    }
}
