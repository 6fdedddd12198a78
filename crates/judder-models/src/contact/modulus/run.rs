//! `modulus`: storage and loss modulus and loss tangent over frequency, beside measured ones where there are such.

use crate::contact::case::ContactCase;
use crate::contact::settings::FREQUENCIES;
use crate::error::ModelError;
use crate::material::{ContactScales, Material};
use judder_contact::material::{DmaData, PronyFit};
use judder_keys::numeric_key::Form;
use judder_keys::span::Span;
use judder_numerics::complex::ElementaryComplex;
use judder_numerics::decade::power_of_ten;
use judder_store::{Dataset, Results, Table, Variable};
use judder_study::outcome::{CheckRecord, Disagreement, Outcome};

/// Decades on both sides of the relaxation that are shown where no frequencies are asked for.
const BEYOND: f64 = 2.0;
/// What the two forms of one material may differ by.
const FORMS_LIMIT: f64 = 1e-9;
/// The deviation of a fit beyond which its numbers are to be doubted.
const POOR_FIT: f64 = 0.1;

pub(super) fn run(case: &ContactCase, frequency: Option<&Span>) -> Result<Outcome, ModelError> {
    let scales = ContactScales::new(case)?;
    let material = &scales.material;
    let frequencies = frequencies(frequency, &scales)?;
    let moduli: Vec<_> = frequencies.iter().map(|omega| material.spectrum.complex_modulus(*omega)).collect();
    let storage: Vec<f64> = moduli.iter().map(|modulus| modulus.re).collect();
    let loss: Vec<f64> = moduli.iter().map(|modulus| modulus.im).collect();
    let tangent: Vec<f64> = frequencies.iter().map(|omega| material.spectrum.loss_tangent(*omega)).collect();
    let count = frequencies.len();
    let over_frequency = |name: &str, values: &[f64], units: &str, long_name: &str| {
        Variable::new(name, &["frequency"], &[count], values.to_vec()).units(units).long_name(long_name)
    };
    let coordinate = Variable::coordinate("frequency", frequencies.clone())
        .units("rad/s")
        .long_name("angular frequency ω")
        .attribute("label", "Angular frequency $ω$ (rad s^{−1})")
        .attribute("scale", "log");
    let mut dataset = Dataset::new()
        .with(coordinate)?
        .with(over_frequency("storage_modulus", &storage, "Pa", "storage modulus E′"))?
        .with(over_frequency("loss_modulus", &loss, "Pa", "loss modulus E″"))?
        .with(over_frequency("loss_tangent", &tangent, "1", "loss tangent E″/E′"))?;
    dataset = with_terms(dataset, material)?;
    if let Some((data, fit)) = &material.fit {
        dataset = with_data(dataset, data, fit)?;
    }
    let mut outcome = Outcome {
        scalars: told(case, &scales, &frequencies, &tangent).scalars(),
        dataset,
        table: Some(
            Table::new()
                .column("frequency", "rad/s", frequencies.clone())?
                .column("storage_modulus", "Pa", storage)?
                .column("loss_modulus", "Pa", loss)?
                .column("loss_tangent", "1", tangent)?,
        ),
        checks: checks(material, &frequencies)?,
        ..Outcome::default()
    };
    outcome.warnings.extend(material.fit.as_ref().and_then(|(_, fit)| poor_fit(fit)));
    Ok(outcome)
}

/// The frequencies of the settings, or those between which the material relaxes; rad/s.
fn frequencies(span: Option<&Span>, scales: &ContactScales) -> Result<Vec<f64>, ModelError> {
    if let Some(span) = span {
        let unit = if span.form == Form::Group { 1.0 / scales.time } else { 1.0 };
        return Ok(span.values().into_iter().map(|value| value * unit).collect());
    }
    let spectrum = &scales.material.spectrum;
    // the slowest time is a retardation time, the fastest a relaxation time
    let slowest = spectrum.terms().last().map_or(scales.time, |term| term.retardation_time);
    let relaxation = spectrum.relaxation_form()?;
    let fastest = relaxation.terms().first().map_or(scales.time, |term| term.relaxation_time);
    let (first, last) = (-libm::log10(slowest) - BEYOND, -libm::log10(fastest) + BEYOND);
    let values = (0..FREQUENCIES)
        .map(|k| power_of_ten(first + (last - first) * k as f64 / (FREQUENCIES - 1) as f64))
        .collect();
    Ok(values)
}

/// The terms of both forms.
fn with_terms(dataset: Dataset, material: &Material) -> Result<Dataset, ModelError> {
    let creep = material.spectrum.terms();
    let (times, compliances): (Vec<f64>, Vec<f64>) =
        creep.iter().map(|term| (term.retardation_time, term.compliance)).unzip();
    let form = material.spectrum.relaxation_form()?;
    let (relaxation_times, moduli): (Vec<f64>, Vec<f64>) =
        form.terms().iter().map(|term| (term.relaxation_time, term.modulus)).unzip();
    if times.is_empty() {
        return Ok(dataset);
    }
    Ok(dataset
        .with(Variable::coordinate("retardation_time", times).units("s").long_name("retardation times τ_k"))?
        .with(
            Variable::new("creep_compliance", &["retardation_time"], &[compliances.len()], compliances)
                .units("1/Pa")
                .long_name("creep compliances C_k"),
        )?
        .with(
            Variable::coordinate("relaxation_time", relaxation_times)
                .units("s")
                .long_name("relaxation times ρ_j"),
        )?
        .with(
            Variable::new("relaxation_strength", &["relaxation_time"], &[moduli.len()], moduli)
                .units("Pa")
                .long_name("moduli E_j of the relaxation form"),
        )?)
}

/// The measured moduli, and how far the series is from them.
fn with_data(dataset: Dataset, data: &DmaData, fit: &PronyFit) -> Result<Dataset, ModelError> {
    let points = data.points();
    let over_data = |name: &str, values: Vec<f64>, units: &str, long_name: &str| {
        Variable::new(name, &["measurement"], &[values.len()], values).units(units).long_name(long_name)
    };
    let at =
        |value: fn(&judder_contact::material::DmaPoint) -> f64| points.iter().map(value).collect::<Vec<_>>();
    Ok(dataset
        .with(over_data("measured_frequency", at(|p| p.angular_frequency), "rad/s", "measured ω"))?
        .with(over_data("measured_storage_modulus", at(|p| p.storage_modulus), "Pa", "measured E′"))?
        .with(over_data("measured_loss_modulus", at(|p| p.loss_modulus), "Pa", "measured E″"))?
        .with(over_data(
            "storage_deviation",
            fit.residuals.iter().map(|r| r.storage).collect(),
            "1",
            "relative deviation of E′ of the series from the measured one",
        ))?
        .with(over_data(
            "loss_deviation",
            fit.residuals.iter().map(|r| r.loss).collect(),
            "1",
            "relative deviation of E″ of the series from the measured one",
        ))?)
}

/// What is told of a modulus.
#[derive(Results)]
pub(super) struct ToldModulus {
    rubbery_modulus_pascal: f64,
    glassy_modulus_pascal: f64,
    #[result(unit = "1")]
    contrast: f64,
    terms: usize,
    mean_retardation_time_second: f64,
    #[result(unit = "1")]
    largest_loss_tangent: f64,
    frequency_of_largest_loss_tangent: f64,
    /// the unit in which the case has its times, in which tables show them
    shown_unit: String,
    /// the terms of the creep form
    prony: Vec<ToldTerm>,
    /// what the temperature multiplies times by
    #[result(unit = "1", optional)]
    time_factor: Option<f64>,
    #[result(flatten)]
    fit: Option<ToldSeries>,
}

#[derive(Results)]
struct ToldTerm {
    time_second: f64,
    compliance_per_pascal: f64,
}

/// What is told of a series that was fitted to measured moduli.
#[derive(Results)]
struct ToldSeries {
    measurements: usize,
    #[result(unit = "1")]
    storage_r2: f64,
    #[result(unit = "1")]
    loss_r2: f64,
    #[result(unit = "1")]
    storage_deviation: f64,
    #[result(unit = "1")]
    loss_deviation: f64,
}

fn told(case: &ContactCase, scales: &ContactScales, frequencies: &[f64], tangent: &[f64]) -> ToldModulus {
    let spectrum = &scales.material.spectrum;
    let peak = frequencies.iter().zip(tangent).max_by(|a, b| a.1.total_cmp(b.1));
    let terms = spectrum.terms().iter();
    let prony =
        terms.map(|t| ToldTerm { time_second: t.retardation_time, compliance_per_pascal: t.compliance });
    let factor = scales.material.time_factor;
    ToldModulus {
        rubbery_modulus_pascal: spectrum.rubbery_modulus(),
        glassy_modulus_pascal: spectrum.glassy_modulus(),
        contrast: spectrum.contrast(),
        terms: spectrum.terms().len(),
        mean_retardation_time_second: scales.time,
        largest_loss_tangent: peak.map_or(0.0, |(_, tangent)| *tangent),
        frequency_of_largest_loss_tangent: peak.map_or(f64::NAN, |(at, _)| *at),
        shown_unit: case.time_unit.name.clone(),
        prony: prony.collect(),
        time_factor: (factor != 1.0).then_some(factor),
        fit: scales.material.fit.as_ref().map(|(data, fit)| ToldSeries {
            measurements: data.points().len(),
            storage_r2: fit.storage_r_squared,
            loss_r2: fit.loss_r_squared,
            storage_deviation: fit.storage_deviation,
            loss_deviation: fit.loss_deviation,
        }),
    }
}

fn poor_fit(fit: &PronyFit) -> Option<String> {
    let worst = fit.worst_deviation();
    (worst > POOR_FIT).then(|| {
        format!(
            "the series is up to {:.0} % from the measured moduli: give more terms, or look at the data",
            100.0 * worst
        )
    })
}

/// Both forms of the material against each other, and what every passive material obeys.
fn checks(material: &Material, frequencies: &[f64]) -> Result<Vec<CheckRecord>, ModelError> {
    let spectrum = &material.spectrum;
    let relaxation = spectrum.relaxation_form()?;
    let difference = |omega: &f64| {
        let (creep, other) = (spectrum.complex_modulus(*omega), relaxation.complex_modulus(*omega));
        (creep - other).modulus() / creep.modulus()
    };
    let moduli: Vec<_> = frequencies.iter().map(|omega| spectrum.complex_modulus(*omega)).collect();
    // rounding may let a plateau fall by its last digit
    let falls = |pair: &[num_complex::Complex64]| pair[1].re < pair[0].re * (1.0 - 1e-12);
    let falling = moduli.windows(2).map(falls);
    let negative = moduli.iter().map(|modulus| modulus.im < 0.0);
    Ok(vec![
        CheckRecord::new(
            "creep and relaxation form are one material",
            format!("E(ω) of both forms at {} frequencies, relative", frequencies.len()),
            frequencies.iter().map(difference).collect(),
            FORMS_LIMIT,
        ),
        CheckRecord::new(
            "the storage modulus rises and the loss modulus is positive",
            format!("number of exceptions at {} frequencies", frequencies.len()),
            Disagreement::exceptions(falling.chain(negative)),
            0.0,
        ),
    ])
}
