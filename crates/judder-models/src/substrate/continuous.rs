//! A continuous creep spectrum of the substrate: its density, and how few retardation times stand for it.

use crate::contact::problem::ContactProblem;
use crate::oscillator::inputs::OscillatorInputs;
use crate::substrate::{TERM_LIMIT, TIME, Timed, are_terms};
use judder_keys::Settings;
use judder_keys::cause::Cause;
use judder_keys::declared::{Number, Several, Whole, both};
use judder_keys::dimension::Dimension;
use judder_keys::error::Fault;
use judder_keys::numeric_key::Range;
use judder_keys::section::Section;
use judder_keys::span::ascending;

/// A continuous spectrum, and into how many terms it is taken apart.
#[derive(Debug, Clone, PartialEq, Settings)]
#[settings(check = ContinuousSource::complete)]
pub struct ContinuousSource {
    /// τ𝒞 is a Gaussian in log₁₀ τ, scaled to both moduli.
    #[key(omitted)]
    log_normal: Option<LogNormal>,
    /// 𝒞 ∝ τ^(m − 1) between two times, scaled to both moduli.
    #[key(omitted)]
    power_law: Option<PowerLaw>,
    /// Samples, ascending; between them τ𝒞 is linear in ln τ. The glassy modulus follows.
    #[key(rule = SAMPLES, omitted)]
    samples: Option<Vec<DensitySample>>,
    /// How many retardation times stand for it.
    #[key(rule = Whole { from: 1, to: TERM_LIMIT }, omitted)]
    terms: Option<usize>,
    /// Relative error of E(ω) that the terms may make at any frequency, in place of their number.
    #[key(rule = ACCURACY, symbol = "ε", usual = SPECTRUM_ACCURACY, omitted)]
    accuracy: Option<f64>,
}

/// τ𝒞 is a Gaussian in log₁₀ τ.
#[derive(Debug, Clone, Copy, PartialEq, Settings)]
pub struct LogNormal {
    /// Median of the retardation times.
    #[key(rule = TIME, symbol = "τ_m")]
    pub median: f64,
    /// Standard deviation in decades of time.
    #[key(rule = WIDTH, symbol = "w", example = "1.5")]
    pub width: f64,
}

/// 𝒞 ∝ τ^(m − 1) between two times.
#[derive(Debug, Clone, Copy, PartialEq, Settings)]
#[settings(check = PowerLaw::ascends)]
pub struct PowerLaw {
    /// Shortest retardation time.
    #[key(rule = TIME, symbol = "τ_1")]
    pub from: f64,
    /// Longest retardation time.
    #[key(rule = TIME, symbol = "τ_2")]
    pub to: f64,
    /// Exponent of the compliance, which grows as t^m; at 0 the spectrum is even in ln τ.
    #[key(rule = Number::any(Dimension::NUMBER), symbol = "m", example = "1.5")]
    pub exponent: f64,
}

/// 𝒞 at one retardation time.
#[derive(Debug, Clone, Copy, PartialEq, Settings)]
#[settings(title = "a sample of the spectrum")]
pub struct DensitySample {
    /// Retardation time of a sample.
    #[key(rule = TIME, symbol = "τ")]
    pub time: f64,
    /// Spectrum at this time.
    #[key(rule = Number::non_negative(Dimension::COMPLIANCE_RATE), symbol = "𝒞")]
    pub density: f64,
}

/// The density 𝒞(τ) of retardation times, 1/E(ω) = 1/E∞ + ∫ 𝒞(τ)/(1 + iωτ) dτ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Density<'a> {
    /// τ𝒞 is a Gaussian in log₁₀ τ, scaled to both moduli.
    LogNormal(LogNormal),
    /// 𝒞 ∝ τ^(exponent − 1) between two times, scaled to both moduli.
    PowerLaw(PowerLaw),
    /// Samples, ascending; between them τ𝒞 is linear in ln τ. The glassy modulus follows.
    Samples(&'a [DensitySample]),
}

/// How many terms stand for a continuous spectrum.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum TermChoice {
    /// This many.
    Given(usize),
    /// As few as keep E(ω) within this relative error at every frequency.
    Within(f64),
}

const SPECTRUM_ACCURACY: f64 = 1e-3;
const ACCURACY: Number =
    Number { dimension: Dimension::NUMBER, range: Range::Interval { above: 0.0, up_to: 0.2 } };
const WIDTH: Number =
    Number { dimension: Dimension::NUMBER, range: Range::Interval { above: 0.0, up_to: 10.0 } };
const SAMPLES: Several<()> = Several { of: (), length: [2, TERM_LIMIT] };

impl Timed for DensitySample {
    fn time(&self) -> f64 {
        self.time
    }
}

impl PowerLaw {
    /// Refuses times that do not ascend.
    fn ascends(&mut self, section: &Section<'_>) -> Result<(), Fault> {
        let (from, to) = (self.from, self.to);
        let written = || [section.written("from", from), section.written("to", to)];
        ascending([from, to], written, section.place)
    }
}

impl ContinuousSource {
    /// Refuses two densities or none, two choices of terms, samples that are no spectrum; fills in the accuracy that is left out.
    fn complete(&mut self, section: &Section<'_>) -> Result<(), Fault> {
        let one_of_two = |first: &str, second: &str| match (section.get(first), section.get(second)) {
            (Some(_), Some(node)) => {
                let (first, second) = (section.path(first), section.path(second));
                Err(Cause::OneOfTwo { first, second }.at(node.place))
            }
            _ => Ok(()),
        };
        let one_density = one_of_two("log_normal", "power_law")
            .and_then(|()| one_of_two("log_normal", "samples"))
            .and_then(|()| one_of_two("power_law", "samples"));
        if self.terms.is_none() {
            self.accuracy.get_or_insert(SPECTRUM_ACCURACY);
        }
        both(one_of_two("terms", "accuracy"), one_density)?;
        match (&self.samples, section.get("samples")) {
            (Some(samples), Some(node)) => {
                are_terms(section, "substrate.continuous.samples", Some(samples))?;
                is_spectrum(samples).map_err(|cause| cause.at(node.place))
            }
            _ if self.log_normal.is_none() && self.power_law.is_none() => {
                let forms = "log_normal = { median = \"10 ms\", width = 1 }, or power_law = { … }, or samples = [ … ]";
                Err(section.missing("samples", forms))
            }
            _ => Ok(()),
        }
    }

    /// 𝒞(τ).
    pub fn density(&self) -> Density<'_> {
        match (self.log_normal, self.power_law, &self.samples) {
            (Some(own), ..) => Density::LogNormal(own),
            (_, Some(own), _) => Density::PowerLaw(own),
            (.., samples) => Density::Samples(samples.as_deref().unwrap_or_default()),
        }
    }

    /// The number of terms, or the error that decides it.
    pub fn terms(&self) -> TermChoice {
        match self.terms {
            Some(terms) => TermChoice::Given(terms),
            None => TermChoice::Within(self.accuracy.unwrap_or(SPECTRUM_ACCURACY)),
        }
    }

    /// Sets the glassy modulus and a time where samples decide them: their integral is what lies between 1/E0 and 1/E∞.
    pub(crate) fn decide(&self, inputs: &mut OscillatorInputs) {
        if let Some(samples) = &self.samples {
            let compliance = integral(samples, |_| 1.0);
            inputs.set_prony(integral(samples, |time| time) / compliance, compliance);
        }
    }
}

/// Refuses one sample alone, two at one time, and samples that are zero throughout.
fn is_spectrum(samples: &[DensitySample]) -> Result<(), Cause> {
    let key = "substrate.continuous.samples";
    if samples.len() < 2 {
        let (key, found) = (format!("the number of samples of {key}"), samples.len() as i64);
        return Err(Cause::Count { key, from: 2, to: TERM_LIMIT, found });
    }
    if let Some([before, next]) = samples.array_windows().find(|[before, next]| before.time >= next.time) {
        let (before, time) = (before.time, next.time);
        return Err(ContactProblem::UnsortedTimes { key, before, time }.into());
    }
    match integral(samples, |_| 1.0) {
        0.0 => Err(ContactProblem::NoSpectrum.into()),
        _ => Ok(()),
    }
}

/// ∫ f 𝒞 dτ = ∫ f τ𝒞 d ln τ: exact for f = 1, where the integrand is linear.
fn integral(samples: &[DensitySample], weight: fn(f64) -> f64) -> f64 {
    let value = |sample: &DensitySample| weight(sample.time) * sample.time * sample.density;
    let part = |pair: &[DensitySample]| {
        0.5 * (value(&pair[0]) + value(&pair[1])) * libm::log(pair[1].time / pair[0].time)
    };
    samples.windows(2).map(part).sum()
}
