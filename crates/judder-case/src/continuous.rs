//! A continuous creep spectrum of the substrate: its density, and how few retardation times stand for it.

use crate::cause::Cause;
use crate::contact_keys::ContactKey;
use crate::contact_problem::ContactProblem;
use crate::document::Node;
use crate::error::Fault;
use crate::inputs::OscillatorInputs;
use crate::section::Section;
use crate::substrate::{TERM_LIMIT, read_numbers, read_terms};
use crate::swept_keys::read_value;

/// A continuous spectrum, and into how many terms it is taken apart.
#[derive(Debug, Clone, PartialEq)]
pub struct ContinuousSource {
    /// 𝒞(τ).
    pub density: Density,
    /// The number of terms, or the error that decides it.
    pub terms: TermChoice,
}

/// The density 𝒞(τ) of retardation times, 1/E(ω) = 1/E∞ + ∫ 𝒞(τ)/(1 + iωτ) dτ.
#[derive(Debug, Clone, PartialEq)]
pub enum Density {
    /// τ𝒞 is a Gaussian in log₁₀ τ, scaled to both moduli.
    LogNormal {
        /// Its middle, s.
        median: f64,
        /// Its standard deviation, decades.
        width: f64,
    },
    /// 𝒞 ∝ τ^(exponent − 1) between two times, scaled to both moduli.
    PowerLaw {
        /// The shortest time, s.
        from: f64,
        /// The longest time, s.
        to: f64,
        /// The exponent of the compliance.
        exponent: f64,
    },
    /// Samples, ascending; between them τ𝒞 is linear in ln τ. The glassy modulus follows.
    Samples(Vec<DensitySample>),
}

/// 𝒞 at one retardation time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DensitySample {
    /// τ, s.
    pub time: f64,
    /// 𝒞, 1/(Pa s).
    pub density: f64,
}

/// How many terms stand for a continuous spectrum.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum TermChoice {
    /// This many.
    Given(usize),
    /// As few as keep E(ω) within this relative error at every frequency.
    Within(f64),
}

/// The keys that each give the density.
pub(crate) const DENSITIES: [&str; 3] = ["log_normal", "power_law", "samples"];

/// Reads `continuous` of `[substrate]`; samples set the glassy modulus and a time of `inputs`.
pub(crate) fn read_continuous(node: &Node, inputs: &mut OscillatorInputs) -> Result<ContinuousSource, Fault> {
    let name = "substrate.continuous";
    let known = [DENSITIES[0], DENSITIES[1], DENSITIES[2], "terms", "accuracy"];
    let section = Section::open(node, name, &format!("`{name}`"), &known)?;
    one_of_two(&section, "terms", "accuracy")?;
    for (first, second) in [("log_normal", "power_law"), ("log_normal", "samples"), ("power_law", "samples")]
    {
        one_of_two(&section, first, second)?;
    }
    let density = if let Some(node) = section.get("log_normal") {
        let keys = [ContactKey::SpectrumMedian, ContactKey::SpectrumWidth];
        let [median, width] = read_numbers(node, keys)?;
        Density::LogNormal { median, width }
    } else if let Some(node) = section.get("power_law") {
        let keys = [ContactKey::SpectrumFrom, ContactKey::SpectrumTo, ContactKey::SpectrumExponent];
        let [from, to, exponent] = read_numbers(node, keys)?;
        if from >= to {
            return Err(Cause::Backwards { from, to }.at(node.place));
        }
        Density::PowerLaw { from, to, exponent }
    } else {
        let expected =
            "log_normal = { median = \"10 ms\", width = 1 }, or power_law = { … }, or samples = [ … ]";
        let node = section.required("samples", expected)?;
        read_samples(node, inputs)?
    };
    let terms = match section.whole("terms", 1, TERM_LIMIT)? {
        Some(terms) => TermChoice::Given(terms),
        None => TermChoice::Within(read_accuracy(&section)?),
    };
    Ok(ContinuousSource { density, terms })
}

fn one_of_two(section: &Section<'_>, first: &str, second: &str) -> Result<(), Fault> {
    let (Some(_), Some(node)) = (section.get(first), section.get(second)) else { return Ok(()) };
    let (first, second) = (section.path(first), section.path(second));
    Err(Cause::Contact { problem: ContactProblem::OneOfTwo { first, second } }.at(node.place))
}

fn read_accuracy(section: &Section<'_>) -> Result<f64, Fault> {
    let entry = ContactKey::SpectrumAccuracy.entry();
    match section.get(entry.name()) {
        Some(node) => Ok(read_value(entry, entry.path, node)?.number),
        None => Ok(entry.default.map_or(0.0, |(_, value)| value.number)),
    }
}

/// Reads the samples, whose integral is what lies between 1/E0 and 1/E∞.
fn read_samples(node: &Node, inputs: &mut OscillatorInputs) -> Result<Density, Fault> {
    let samples = read_terms(node, [ContactKey::SampleTime, ContactKey::SampleDensity])?;
    if samples.len() < 2 {
        let key = "the number of samples of substrate.continuous.samples".to_owned();
        let (to, found) = (TERM_LIMIT, samples.len() as i64);
        return Err(
            Cause::Contact { problem: ContactProblem::Count { key, from: 2, to, found } }.at(node.place)
        );
    }
    if let Some(pair) = samples.windows(2).find(|pair| pair[0][0] >= pair[1][0]) {
        let (key, before, time) = ("substrate.continuous.samples", pair[0][0], pair[1][0]);
        return Err(
            Cause::Contact { problem: ContactProblem::UnsortedTimes { key, before, time } }.at(node.place)
        );
    }
    // ∫ f 𝒞 dτ = ∫ f τ𝒞 d ln τ: exact for f = 1, where the integrand is linear
    let integral = |weight: fn(f64) -> f64| -> f64 {
        let value = |[time, density]: [f64; 2]| weight(time) * time * density;
        let part =
            |pair: &[[f64; 2]]| 0.5 * (value(pair[0]) + value(pair[1])) * (pair[1][0] / pair[0][0]).ln();
        samples.windows(2).map(part).sum()
    };
    let compliance = integral(|_| 1.0);
    if compliance == 0.0 {
        return Err(Cause::Contact { problem: ContactProblem::NoSpectrum }.at(node.place));
    }
    inputs.set_prony(integral(|time| time) / compliance, compliance);
    let sample = |[time, density]: [f64; 2]| DensitySample { time, density };
    Ok(Density::Samples(samples.into_iter().map(sample).collect()))
}
