//! From the way in which a case gives the relaxation of its substrate to a creep spectrum.

use crate::error::ModelError;
use crate::oscillator::inputs::OscillatorInputs;
use crate::oscillator::keys::OscillatorKey;
use crate::substrate::continuous::{ContinuousSource, Density, TermChoice};
use crate::substrate::temperature::{Arrhenius, Shift, Wlf};
use crate::substrate::{FitTerms, RelaxationSource, Substrate};
use judder_contact::material::{
    ContinuousSpectrum, CreepSpectrum, Discretisation, DmaData, DmaError, DmaMeasurement, MaterialError,
    PronyFit, RelaxationSpectrum, TemperatureShift, TermCount,
};
use judder_exchange::dma_table::{DmaTable, read_dma_table};
use judder_keys::file_reference::FileReference;
use judder_study::input_file::{self, unusable};
use std::path::Path;
use std::sync::{Mutex, PoisonError};

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
    pub(crate) fn of(substrate: &Substrate, inputs: &OscillatorInputs) -> Result<Self, ModelError> {
        let (rubbery, glassy) =
            (inputs.number(OscillatorKey::RubberyModulus), inputs.number(OscillatorKey::GlassyModulus));
        let spectrum = match &substrate.source {
            RelaxationSource::OneTime if glassy == rubbery => CreepSpectrum::elastic(rubbery)?,
            RelaxationSource::OneTime => {
                CreepSpectrum::single(rubbery, glassy, inputs.number(OscillatorKey::RetardationTime))?
            }
            RelaxationSource::Prony(terms) => CreepSpectrum::new(glassy, terms.clone())?,
            RelaxationSource::Relaxation(terms) => {
                RelaxationSpectrum::new(rubbery, terms.clone())?.creep_form()?
            }
            RelaxationSource::Continuous(source) => {
                return Ok(Self::continuous(source, rubbery, glassy)?);
            }
            RelaxationSource::Dma { file, terms, rubbery_modulus } => {
                return Self::measured(file, *terms, *rubbery_modulus, substrate);
            }
        };
        Ok(Self { spectrum, fit: None, discretisation: None })
    }

    fn continuous(source: &ContinuousSource, rubbery: f64, glassy: f64) -> Result<Self, MaterialError> {
        let whole = match source.density() {
            Density::LogNormal(own) => {
                ContinuousSpectrum::log_normal(rubbery, glassy, own.median, own.width)?
            }
            Density::PowerLaw(own) => {
                ContinuousSpectrum::power_law(rubbery, glassy, own.from, own.to, own.exponent)?
            }
            Density::Samples(samples) => {
                let samples: Vec<_> = samples.iter().map(|sample| (sample.time, sample.density)).collect();
                ContinuousSpectrum::sampled(glassy, &samples)?
            }
        };
        let found = match source.terms() {
            TermChoice::Given(terms) => whole.discretised(terms)?,
            TermChoice::Within(accuracy) => whole.discretised_within(accuracy)?,
        };
        Ok(Self { spectrum: found.spectrum.clone(), fit: None, discretisation: Some(found) })
    }

    fn measured(
        file: &FileReference,
        terms: FitTerms,
        rubbery_modulus: Option<f64>,
        substrate: &Substrate,
    ) -> Result<Self, ModelError> {
        let unusable_curve = |error: MaterialError| match error {
            MaterialError::Dma(DmaError::SeveralTemperatures { .. }) => {
                unusable(&file.path, &format!("{error}; give `temperature` and `shift` in [substrate]"))
            }
            MaterialError::NoPlateau { .. } => {
                unusable(&file.path, &format!("{error}, `rubbery_modulus` in [substrate]"))
            }
            error => unusable(&file.path, &error),
        };
        let moduli = read_measured(&file.path)?;
        // one sweep at one temperature is moved as a whole: so is its fit, which the rule of the shift then does not decide
        let as_measured = match (&moduli, &substrate.temperature) {
            (DmaMeasurement::Sweeps(sweeps), Some(at)) => match sweeps.sweeps.as_slice() {
                [(measured, data)] => Some((data.clone(), shift(&at.shift).factor(*measured))),
                _ => None,
            },
            _ => None,
        };
        let data = one_curve(moduli, substrate).map_err(unusable_curve)?;
        let terms = match terms {
            FitTerms::Given(count) => TermCount::Exactly(count),
            FitTerms::Auto => TermCount::Within {
                deviation: AUTO_DEVIATION,
                most: judder_contact::material::prony_fit::MOST_TERMS,
            },
        };
        let fit = match as_measured {
            Some((data, factor)) => {
                remembered_fit(&data, terms, rubbery_modulus).and_then(|fit| fit.moved_by(factor?))
            }
            None => remembered_fit(&data, terms, rubbery_modulus),
        }
        .map_err(unusable_curve)?;
        Ok(Self { spectrum: fit.creep.clone(), fit: Some((data, fit)), discretisation: None })
    }
}

/// What a fit depends on, and the fit.
struct Fitted {
    data: DmaData,
    terms: TermCount,
    rubbery_modulus: Option<f64>,
    fit: PronyFit,
}

/// The fits that were made last: a fit takes half a second, and what a sweep moves is seldom its data.
static FITS: Mutex<Vec<Fitted>> = Mutex::new(Vec::new());

/// The series fitted to data, made once for the same data.
fn remembered_fit(
    data: &DmaData,
    terms: TermCount,
    rubbery_modulus: Option<f64>,
) -> Result<PronyFit, MaterialError> {
    /// As many as cases have substrates, and a few more.
    const KEPT: usize = 8;
    let known = || FITS.lock().unwrap_or_else(PoisonError::into_inner);
    let is_same =
        |own: &Fitted| own.data == *data && own.terms == terms && own.rubbery_modulus == rubbery_modulus;
    if let Some(own) = known().iter().find(|own| is_same(own)) {
        return Ok(own.fit.clone());
    }
    let fit = PronyFit::new(data, terms, rubbery_modulus)?;
    let mut fits = known();
    if !fits.iter().any(is_same) {
        if fits.len() == KEPT {
            fits.remove(0);
        }
        fits.push(Fitted { data: data.clone(), terms, rubbery_modulus, fit: fit.clone() });
    }
    Ok(fit)
}

/// The temperature of measured data that nothing of the case moves, in words.
///
/// # Errors
/// Data that cannot be read.
pub(crate) fn temperature_warning(substrate: &Substrate) -> Result<Option<String>, ModelError> {
    let (RelaxationSource::Dma { file, .. }, None) = (&substrate.source, &substrate.temperature) else {
        return Ok(None);
    };
    match read_measured(&file.path)? {
        DmaMeasurement::Sweeps(sweeps) if sweeps.sweeps.len() == 1 => Ok(sweeps.sweeps.first().map(|(at, _)| {
            format!(
                "the moduli of `{}` were measured at {at:.2} K, and so the substrate is at {at:.2} K: another one needs \
                 `temperature` and `shift`",
                file.given
            )
        })),
        _ => Ok(None),
    }
}

/// The moduli of a file.
///
/// # Errors
/// A file that cannot be read or used.
fn read_measured(path: &Path) -> Result<DmaMeasurement, ModelError> {
    let table = read_dma_table(&input_file::text(path)?).map_err(|error| unusable(path, &error))?;
    Ok(moduli_of(&table).map_err(|error| unusable(path, &error))?)
}

fn moduli_of(table: &DmaTable) -> Result<DmaMeasurement, DmaError> {
    let (frequency, storage, loss) = (&table.angular_frequency, &table.storage_modulus, &table.loss_modulus);
    DmaMeasurement::of_columns(frequency, storage, loss, table.temperature.as_deref())
}

/// Data with temperatures as one master curve at the reference temperature.
fn one_curve(measured: DmaMeasurement, substrate: &Substrate) -> Result<DmaData, MaterialError> {
    match (measured, &substrate.temperature) {
        // one sweep was measured at a temperature as well
        (DmaMeasurement::Sweeps(sweeps), Some(at)) => sweeps.master_curve(&shift(&at.shift)),
        (measured, _) => Ok(measured.single()?),
    }
}

/// The rule by which temperature moves all times.
pub(crate) fn shift(rule: &Shift) -> TemperatureShift {
    match *rule {
        Shift::Wlf(Wlf { first, second, reference }) => TemperatureShift::WilliamsLandelFerry {
            first_constant: first,
            second_constant: second.0,
            reference,
        },
        Shift::Arrhenius(Arrhenius { activation_energy, reference }) => {
            TemperatureShift::Arrhenius { activation_energy, reference }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::substrate::temperature::TemperatureDifference;
    use judder_contact::material::CreepTerm;

    fn moduli(text: &str) -> DmaMeasurement {
        moduli_of(&read_dma_table(text).unwrap()).unwrap()
    }

    /// log₁₀ a_T is one decade at 5 K below the reference: −C1 (−5)/(C2 − 5) = 1.
    #[test]
    fn one_sweep_is_shifted_to_the_reference_as_several_are() {
        let at = |temperature: f64| {
            let shift =
                Shift::Wlf(Wlf { first: 10.0, second: TemperatureDifference(55.0), reference: 300.0 });
            Substrate {
                temperature: Some(crate::substrate::temperature::Temperature { temperature, shift }),
                ..Substrate::default()
            }
        };
        let measured = || moduli("f [Hz],T [K],E' [MPa],E'' [MPa]\n1,295,1,0.1\n2,295,2,0.2\n");
        let moved = one_curve(measured(), &at(310.0)).unwrap();
        let plain = one_curve(measured(), &Substrate::default()).unwrap();
        for (moved, plain) in moved.points().iter().zip(plain.points()) {
            assert!((moved.angular_frequency / plain.angular_frequency / 10.0 - 1.0).abs() < 1e-12);
        }
    }

    /// A sweep of moduli over four decades, at a temperature.
    fn dma(temperature: f64) -> String {
        let line = |k: i32| {
            let frequency = 10_f64.powf(f64::from(k) / 4.0);
            let slow = CreepTerm { retardation_time: 1e-1, compliance: 5e-7 };
            let fast = CreepTerm { retardation_time: 1e-3, compliance: 3e-7 };
            let modulus = CreepSpectrum::new(1e7, vec![slow, fast])
                .unwrap()
                .complex_modulus(std::f64::consts::TAU * frequency);
            format!("{frequency:e},{temperature},{:e},{:e}\n", modulus.re, modulus.im)
        };
        format!("f [Hz],T [K],E' [Pa],E'' [Pa]\n{}", (-8..=16).map(line).collect::<String>())
    }

    /// The fit of moved data is the moved fit, whatever the rule moves them by.
    #[test]
    fn a_shifted_fit_is_a_fit_to_shifted_data() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("dma.csv");
        std::fs::write(&path, dma(295.0)).unwrap();
        let file = FileReference { given: "dma.csv".to_owned(), path };
        let source = RelaxationSource::Dma { file, terms: FitTerms::Auto, rubbery_modulus: None };
        for second in [55.0, 80.0, 200.0] {
            let shift =
                Shift::Wlf(Wlf { first: 10.0, second: TemperatureDifference(second), reference: 300.0 });
            let temperature = Some(crate::substrate::temperature::Temperature { temperature: 310.0, shift });
            let substrate = Substrate { source: source.clone(), temperature, ..Substrate::default() };
            let moved = FoundSpectrum::of(&substrate, &OscillatorInputs::default()).unwrap();
            let data = one_curve(moduli(&dma(295.0)), &substrate).unwrap();
            let most = judder_contact::material::prony_fit::MOST_TERMS;
            let anew =
                PronyFit::new(&data, TermCount::Within { deviation: AUTO_DEVIATION, most }, None).unwrap();
            assert_eq!(moved.fit.unwrap().0, data);
            assert_eq!(moved.spectrum.terms().len(), anew.creep.terms().len());
            for (moved, anew) in moved.spectrum.terms().iter().zip(anew.creep.terms()) {
                assert!((moved.retardation_time / anew.retardation_time - 1.0).abs() < 1e-9);
                assert!((moved.compliance / anew.compliance - 1.0).abs() < 1e-9);
            }
        }
    }

    /// What is remembered is told apart by all that a fit depends on.
    #[test]
    fn another_fit_is_not_taken_for_one_that_was_made() {
        let data = |temperature: f64| moduli(&dma(temperature)).single().unwrap();
        let terms = |count: usize| TermCount::Exactly(count);
        let first = remembered_fit(&data(295.0), terms(3), None).unwrap();
        assert_eq!(first, PronyFit::new(&data(295.0), terms(3), None).unwrap());
        assert_eq!(remembered_fit(&data(295.0), terms(3), None).unwrap(), first);
        assert_ne!(remembered_fit(&data(295.0), terms(4), None).unwrap(), first);
        assert_ne!(remembered_fit(&data(295.0), terms(3), Some(9e5)).unwrap(), first);
    }
}
