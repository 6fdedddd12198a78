//! From `[substrate]` to a viscoelastic material, and from groups to quantities of a contact case.

use crate::contact::case::ContactCase;
use crate::error::ModelError;
use crate::oscillator::inputs::OscillatorInputs;
use crate::oscillator::keys::OscillatorKey;
use crate::spectrum_source::{FoundSpectrum, shift};
use crate::substrate::Substrate;
use judder_contact::kernel::substrate::SlidingSubstrate;
use judder_contact::law::material::{LawMaterial, LawTerm};
use judder_contact::material::{CreepSpectrum, CreepTerm, Discretisation, DmaData, PronyFit};
use judder_contact::transient::CreepingSubstrate;
use judder_keys::numeric_key::{Form, Value};
use judder_keys::span::Span;
use judder_oscillator::groups::Scales;
use judder_store::content_hash;
use judder_study::input_file;
use serde_json::{Value as Json, json};

/// The substrate of a case.
#[derive(Debug, Clone, PartialEq)]
pub struct Material {
    /// At the temperature of the case.
    pub spectrum: CreepSpectrum,
    /// The measured data and the series fitted to them, at the reference temperature, where data were given.
    pub fit: Option<(DmaData, PronyFit)>,
    /// How well the terms stand for a continuous spectrum, where one was given; at the reference temperature.
    pub discretisation: Option<Discretisation>,
    /// a_T, by which the times were multiplied; 1 without a temperature.
    pub time_factor: f64,
}

impl Material {
    /// The substrate of a case.
    ///
    /// # Errors
    /// Data that cannot be read or fitted, a spectrum that cannot be, a temperature out of reach of its shift.
    pub(crate) fn new(substrate: &Substrate, inputs: &OscillatorInputs) -> Result<Self, ModelError> {
        let found = FoundSpectrum::of(substrate, inputs)?;
        let time_factor = match &substrate.temperature {
            Some(at) => shift(&at.shift).factor(at.temperature)?,
            None => 1.0,
        };
        let spectrum = found.spectrum.with_times_multiplied(time_factor)?;
        Ok(Self { spectrum, fit: found.fit, discretisation: found.discretisation, time_factor })
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
    pub fn of_law(&self) -> LawMaterial {
        let mean = self.mean_time().unwrap_or(1.0);
        let (_, terms) = self.spectrum.sliding_terms();
        let term = |(compliance, time): (f64, f64)| LawTerm { retardation_time: time / mean, compliance };
        LawMaterial { modulus_ratio: self.spectrum.contrast(), terms: terms.into_iter().map(term).collect() }
    }

    /// What computations take of the substrate of a case, where a series, data or a temperature decide it: moduli, times at the temperature,
    /// terms, and the file they come from.
    fn used(&self, substrate: &Substrate) -> Result<Json, ModelError> {
        let si = |value: f64, unit: &str| json!({ "value": value, "unit": unit });
        let term = |term: &CreepTerm| json!({ "time": si(term.retardation_time, "s"), "compliance": si(term.compliance, "1/Pa") });
        let mut used = json!({
            "rubbery_modulus": si(self.spectrum.rubbery_modulus(), "Pa"),
            "glassy_modulus": si(self.spectrum.glassy_modulus(), "Pa"),
            "retardation_time": self.mean_time().map(|time| si(time, "s")),
            "terms": self.spectrum.terms().iter().map(term).collect::<Vec<_>>(),
        });
        if substrate.temperature.is_some() {
            used["time_factor"] = json!(self.time_factor);
        }
        if let Some(file) = substrate.file() {
            used["file"] =
                json!({ "name": file.given, "hash": content_hash(&input_file::bytes(&file.path)?) });
        }
        Ok(used)
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

/// A resolved case of a substrate with what is used in place of its numeric keys, where a series, data or a temperature decide it.
///
/// It is no part of any hash: two fits to the same data on different machines differ by rounding.
///
/// # Errors
/// Data that cannot be read or fitted.
pub(crate) fn with_used(
    substrate: &Substrate,
    inputs: &OscillatorInputs,
    mut resolved: Json,
) -> Result<Json, ModelError> {
    if substrate.decided_by().is_some() {
        resolved["substrate"]["used"] = Material::new(substrate, inputs)?.used(substrate)?;
        resolved.sort_all_objects();
    }
    Ok(resolved)
}

/// A contact case with the scales of its groups.
#[derive(Debug, Clone)]
pub struct ContactScales {
    /// The substrate.
    pub material: Material,
    /// E0*, R, and a frequency that no contact has.
    pub(crate) scales: Scales,
    /// τ, s.
    pub(crate) time: f64,
}

impl ContactScales {
    /// Those of a contact case.
    ///
    /// # Errors
    /// A substrate whose data cannot be read or fitted.
    pub fn new(case: &ContactCase) -> Result<Self, ModelError> {
        let material = Material::new(&case.substrate, &case.inputs)?;
        // an elastic substrate has no time: that of the case makes the groups
        let time = material.mean_time().unwrap_or(case.inputs.number(OscillatorKey::RetardationTime));
        let scales = material.told_to(&case.inputs).scales();
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

    /// The upper end of a range of lengths, over R.
    pub(crate) fn length_of_span(&self, span: &Span) -> f64 {
        self.length(Value { number: span.to, form: span.form })
    }

    /// The substrate as a transient contact knows it, times over τ.
    pub(crate) fn creeping(&self) -> CreepingSubstrate {
        let mut substrate = CreepingSubstrate::of(&self.material.spectrum);
        substrate.terms.iter_mut().for_each(|term| term.time /= self.time);
        substrate
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
