//! From the way in which a case gives the relaxation of its substrate to a creep spectrum.

use crate::error::StudyError;
use crate::input_file::{self, unusable};
use judder_case::{
    ContinuousSource, Density, FileReference, OscillatorInputs, OscillatorKey, RelaxationSource, Shift,
    Substrate, TermChoice, TermCount,
};
use judder_contact::material::{
    ContinuousSpectrum, CreepSpectrum, CreepTerm, Discretisation, DmaData, DmaError, DmaTable, MaterialError,
    PronyFit, RelaxationSpectrum, RelaxationTerm, TemperatureShift, TermCount as FitTerms,
};
use std::path::Path;

/// The deviation at every point that a fit with `terms = "auto"` aims at.
const AUTO_DEVIATION: f64 = 0.02;

/// The spectrum of a substrate at its reference temperature, and where it comes from.
pub(crate) struct FoundSpectrum {
    /// The terms.
    pub(crate) spectrum: CreepSpectrum,
    /// The measured data and the series fitted to them, where data were given.
    pub(crate) fit: Option<(DmaData, PronyFit)>,
    /// How well the terms stand for a continuous spectrum, where one was given.
    pub(crate) discretisation: Option<Discretisation>,
}

impl FoundSpectrum {
    /// The spectrum of a case.
    ///
    /// # Errors
    /// Data that cannot be read or fitted, a spectrum that cannot be.
    pub(crate) fn of(substrate: &Substrate, inputs: &OscillatorInputs) -> Result<Self, StudyError> {
        let (rubbery, glassy) =
            (inputs.number(OscillatorKey::RubberyModulus), inputs.number(OscillatorKey::GlassyModulus));
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
            RelaxationSource::Continuous(source) => {
                return Ok(Self::continuous(source, (rubbery, glassy))?);
            }
            RelaxationSource::Dma { file, terms, rubbery_modulus } => {
                return Self::measured(file, *terms, *rubbery_modulus, substrate);
            }
        };
        Ok(Self { spectrum, fit: None, discretisation: None })
    }

    fn continuous(source: &ContinuousSource, moduli: (f64, f64)) -> Result<Self, MaterialError> {
        let whole = match &source.density {
            Density::LogNormal { median, width } => ContinuousSpectrum::log_normal(moduli, *median, *width)?,
            Density::PowerLaw { from, to, exponent } => {
                ContinuousSpectrum::power_law(moduli, *from, *to, *exponent)?
            }
            Density::Samples(samples) => {
                let samples: Vec<_> = samples.iter().map(|sample| (sample.time, sample.density)).collect();
                ContinuousSpectrum::sampled(moduli.1, &samples)?
            }
        };
        let found = match source.terms {
            TermChoice::Given(terms) => whole.discretised(terms)?,
            TermChoice::Within(accuracy) => whole.discretised_within(accuracy)?,
        };
        Ok(Self { spectrum: found.spectrum.clone(), fit: None, discretisation: Some(found) })
    }

    fn measured(
        file: &FileReference,
        terms: TermCount,
        rubbery_modulus: Option<f64>,
        substrate: &Substrate,
    ) -> Result<Self, StudyError> {
        let unusable_curve = |error: MaterialError| match error {
            MaterialError::Dma(DmaError::SeveralTemperatures { .. }) => {
                unusable(&file.path, &format!("{error}; give `temperature` and `shift` in [substrate]"))
            }
            MaterialError::NoPlateau { .. } => {
                unusable(&file.path, &format!("{error}, `rubbery_modulus` in [substrate]"))
            }
            error => unusable(&file.path, &error),
        };
        let data = one_curve(read_table(&file.path)?, substrate).map_err(unusable_curve)?;
        let terms = match terms {
            TermCount::Given(count) => FitTerms::Exactly(count),
            TermCount::Auto => FitTerms::Within {
                deviation: AUTO_DEVIATION,
                most: judder_contact::material::prony_fit::MOST_TERMS,
            },
        };
        let fit = PronyFit::new(&data, terms, rubbery_modulus).map_err(unusable_curve)?;
        Ok(Self { spectrum: fit.creep.clone(), fit: Some((data, fit)), discretisation: None })
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
    DmaTable::parse(&input_file::text(path)?).map_err(|error| unusable(path, &error))
}

/// Data with temperatures as one master curve at the reference temperature.
fn one_curve(table: DmaTable, substrate: &Substrate) -> Result<DmaData, MaterialError> {
    match (table, &substrate.temperature) {
        // one sweep was measured at a temperature as well
        (DmaTable::Sweeps(sweeps), Some(at)) => sweeps.master_curve(&shift(&at.shift)),
        (table, _) => Ok(table.single()?),
    }
}

/// The rule by which temperature moves all times.
pub(crate) fn shift(rule: &Shift) -> TemperatureShift {
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
