//! From `[substrate]` to a viscoelastic material, and from groups to quantities of a contact case.

use crate::bridge;
use crate::error::StudyError;
use judder_case::{
    ContactCase, Form, OscillatorInputs, OscillatorKey, RelaxationSource, Shift, Substrate, TermCount, Value,
};
use judder_contact::kernel::substrate::SlidingSubstrate;
use judder_contact::law::material::{LawMaterial, LawTerm};
use judder_contact::material::{
    CreepSpectrum, CreepTerm, DmaData, DmaError, DmaTable, MaterialError, PronyFit, RelaxationSpectrum,
    RelaxationTerm, TemperatureShift, TermCount as FitTerms,
};
use judder_oscillator::groups::Scales;
use std::path::Path;

/// The deviation at every point that a fit with `terms = "auto"` aims at.
const AUTO_DEVIATION: f64 = 0.02;

/// The substrate of a case.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Material {
    /// At the temperature of the case.
    pub(crate) spectrum: CreepSpectrum,
    /// The measured data and the series fitted to them, at the reference temperature, where data were given.
    pub(crate) fit: Option<(DmaData, PronyFit)>,
    /// a_T, by which the times were multiplied; 1 without a temperature.
    pub(crate) time_factor: f64,
}

impl Material {
    /// The substrate of a case.
    ///
    /// # Errors
    /// Data that cannot be read or fitted, a temperature out of reach of its shift.
    pub(crate) fn new(substrate: &Substrate, inputs: &OscillatorInputs) -> Result<Self, StudyError> {
        let (rubbery, glassy) =
            (inputs.number(OscillatorKey::RubberyModulus), inputs.number(OscillatorKey::GlassyModulus));
        let mut fit = None;
        let spectrum = match &substrate.source {
            RelaxationSource::OneTime if glassy == rubbery => CreepSpectrum::elastic(rubbery)?,
            RelaxationSource::OneTime => {
                CreepSpectrum::single(rubbery, glassy, inputs.number(OscillatorKey::RetardationTime))?
            }
            RelaxationSource::Prony(terms) => {
                let term = |term: &judder_case::PronyTerm| CreepTerm {
                    retardation_time: term.retardation_time,
                    compliance: term.compliance,
                };
                CreepSpectrum::new(glassy, terms.iter().map(term).collect())?
            }
            RelaxationSource::Relaxation(terms) => {
                let term = |term: &judder_case::RelaxationTerm| RelaxationTerm {
                    relaxation_time: term.relaxation_time,
                    modulus: term.modulus,
                };
                RelaxationSpectrum::new(rubbery, terms.iter().map(term).collect())?.creep_form()?
            }
            RelaxationSource::Dma { file, terms, rubbery_modulus } => {
                let unusable = |reason: String| StudyError::File { path: file.path.clone(), reason };
                let unusable_curve = |error: MaterialError| match error {
                    MaterialError::Dma(DmaError::SeveralTemperatures { .. }) => {
                        unusable(format!("{error}; give `temperature` and `shift` in [substrate]"))
                    }
                    error => unusable(error.to_string()),
                };
                let data = one_curve(read_table(&file.path)?, substrate).map_err(unusable_curve)?;
                let terms = match terms {
                    TermCount::Given(count) => FitTerms::Exactly(*count),
                    TermCount::Auto => FitTerms::Within {
                        deviation: AUTO_DEVIATION,
                        most: judder_contact::material::prony_fit::MOST_TERMS,
                    },
                };
                let found = PronyFit::new(&data, terms, *rubbery_modulus)
                    .map_err(|error| unusable(error.to_string()))?;
                let creep = found.creep.clone();
                fit = Some((data, found));
                creep
            }
        };
        let time_factor = match &substrate.temperature {
            Some(at) => shift(&at.shift).factor(at.temperature)?,
            None => 1.0,
        };
        Ok(Self { spectrum: spectrum.with_times_multiplied(time_factor)?, fit, time_factor })
    }

    /// τ = Σ C_k τ_k/Σ C_k, the mean retardation time, s: the time of the groups. `None` for an elastic substrate.
    pub(crate) fn mean_time(&self) -> Option<f64> {
        match self.spectrum.terms() {
            [] => None,
            [term] => Some(term.retardation_time),
            terms => {
                let total: f64 = terms.iter().map(|term| term.compliance).sum();
                let moment: f64 = terms.iter().map(|term| term.compliance * term.retardation_time).sum();
                Some(moment / total)
            }
        }
    }

    /// The substrate at v̂ = v τ/R.
    pub(crate) fn sliding(&self, velocity: f64) -> SlidingSubstrate {
        self.of_law().sliding(velocity)
    }

    /// The substrate as a law knows it: times over the mean time, compliances over the rubbery one.
    pub(crate) fn of_law(&self) -> LawMaterial {
        let mean = self.mean_time().unwrap_or(1.0);
        let (_, terms) = self.spectrum.sliding_terms();
        let term = |(compliance, time): (f64, f64)| LawTerm { retardation_time: time / mean, compliance };
        LawMaterial { modulus_ratio: self.spectrum.contrast(), terms: terms.into_iter().map(term).collect() }
    }

    /// Inputs that say of the substrate what the material is: moduli and mean time.
    pub(crate) fn told_to(&self, inputs: &OscillatorInputs) -> OscillatorInputs {
        let mut told = *inputs;
        told.set(OscillatorKey::RubberyModulus, Value::si(self.spectrum.rubbery_modulus()));
        told.set(OscillatorKey::GlassyModulus, Value::si(self.spectrum.glassy_modulus()));
        if let Some(time) = self.mean_time() {
            told.set(OscillatorKey::RetardationTime, Value::si(time));
        }
        told
    }
}

/// The temperature of measured data that nothing of the case moves, in words.
///
/// # Errors
/// Data that cannot be read.
pub(crate) fn temperature_warning(substrate: &Substrate) -> Result<Option<String>, StudyError> {
    let (RelaxationSource::Dma { file, .. }, None) = (&substrate.source, &substrate.temperature) else {
        return Ok(None);
    };
    match read_table(&file.path)? {
        DmaTable::Sweeps(sweeps) if sweeps.sweeps.len() == 1 => Ok(sweeps.sweeps.first().map(|(at, _)| {
            format!(
                "the moduli of `{}` were measured at {at:.2} K, and so the substrate is at {at:.2} K: another one needs \
                 `temperature` and `shift`",
                file.given
            )
        })),
        _ => Ok(None),
    }
}

fn read_table(path: &Path) -> Result<DmaTable, StudyError> {
    let unusable = |reason: String| StudyError::File { path: path.to_owned(), reason };
    let text = std::fs::read_to_string(path).map_err(|error| unusable(error.to_string()))?;
    DmaTable::parse(&text).map_err(|error| unusable(error.to_string()))
}

/// Data with temperatures as one master curve at the reference temperature.
fn one_curve(table: DmaTable, substrate: &Substrate) -> Result<DmaData, MaterialError> {
    match (table, &substrate.temperature) {
        // one sweep was measured at a temperature as well
        (DmaTable::Sweeps(sweeps), Some(at)) => sweeps.master_curve(&shift(&at.shift)),
        (table, _) => Ok(table.single()?),
    }
}

fn shift(rule: &Shift) -> TemperatureShift {
    match *rule {
        Shift::Wlf { first, second, reference } => TemperatureShift::WilliamsLandelFerry {
            first_constant: first,
            second_constant: second,
            reference,
        },
        Shift::Arrhenius { activation_energy, reference } => {
            TemperatureShift::Arrhenius { activation_energy, reference }
        }
    }
}

/// A contact case with the scales of its groups.
#[derive(Debug, Clone)]
pub(crate) struct ContactScales {
    /// The substrate.
    pub(crate) material: Material,
    /// E0*, R, and a frequency that no contact has.
    pub(crate) scales: Scales,
    /// τ, s.
    pub(crate) time: f64,
}

impl ContactScales {
    pub(crate) fn new(case: &ContactCase) -> Result<Self, StudyError> {
        let material = Material::new(&case.substrate, &case.inputs)?;
        // an elastic substrate has no time: that of the case makes the groups
        let time = material.mean_time().unwrap_or(case.inputs.number(OscillatorKey::RetardationTime));
        let scales = bridge::scales(&material.told_to(&case.inputs));
        Ok(Self { material, scales, time })
    }

    /// v̂ = v τ/R.
    pub(crate) fn velocity(&self, value: Value) -> f64 {
        group(value, self.time / self.scales.radius)
    }

    /// A length over R.
    pub(crate) fn length(&self, value: Value) -> f64 {
        group(value, 1.0 / self.scales.radius)
    }

    /// t/τ.
    pub(crate) fn over_time(&self, value: Value) -> f64 {
        group(value, 1.0 / self.time)
    }

    /// ω τ.
    pub(crate) fn angular_frequency(&self, value: Value) -> f64 {
        group(value, self.time)
    }

    /// F/(E0* R²).
    pub(crate) fn force(&self, value: Value) -> f64 {
        group(value, 1.0 / self.force_unit())
    }

    /// F/(E0* R), of a line contact.
    pub(crate) fn line_force(&self, value: Value) -> f64 {
        group(value, 1.0 / (self.scales.reduced_modulus * self.scales.radius))
    }

    /// E0* R², N.
    pub(crate) fn force_unit(&self) -> f64 {
        self.scales.reduced_modulus * self.scales.radius * self.scales.radius
    }
}

fn group(value: Value, per_unit: f64) -> f64 {
    match value.form {
        Form::Group => value.number,
        Form::Si => value.number * per_unit,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// log₁₀ a_T is one decade at 5 K below the reference: −C1 (−5)/(C2 − 5) = 1.
    #[test]
    fn one_sweep_is_shifted_to_the_reference_as_several_are() {
        let at = |temperature: f64| {
            let shift = Shift::Wlf { first: 10.0, second: 55.0, reference: 300.0 };
            Substrate {
                temperature: Some(judder_case::Temperature { temperature, shift }),
                ..Substrate::default()
            }
        };
        let table =
            || DmaTable::parse("f [Hz],T [K],E' [MPa],E'' [MPa]\n1,295,1,0.1\n2,295,2,0.2\n").unwrap();
        let moved = one_curve(table(), &at(310.0)).unwrap();
        let plain = one_curve(table(), &Substrate::default()).unwrap();
        for (moved, plain) in moved.points().iter().zip(plain.points()) {
            assert!((moved.angular_frequency / plain.angular_frequency / 10.0 - 1.0).abs() < 1e-12);
        }
    }
}
