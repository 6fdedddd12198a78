//! The substrate of a case: moduli and one time, a series of terms, or measured data; and its temperature.

pub(crate) mod blame;
pub mod continuous;
pub mod temperature;
pub(crate) mod time_unit;

use std::path::Path;

use crate::contact::problem::ContactProblem;
use crate::oscillator::inputs::{OscillatorInputs, TimeForm};
use crate::oscillator::keys::OscillatorKey;
use crate::substrate::continuous::{ContinuousSource, Density};
use crate::substrate::temperature::{Shift, Temperature};
use judder_contact::material::{CreepTerm, RelaxationTerm};
use judder_keys::Settings;
use judder_keys::cause::Cause;
use judder_keys::declared::{Allowed, Number, Setting, Several, both, conflict};
use judder_keys::dimension::Dimension;
use judder_keys::document::{Data, Node};
use judder_keys::error::Fault;
use judder_keys::file_reference::{FileReference, read_file_reference};
use judder_keys::keys::Numbers;
use judder_keys::numeric_key::Value;
use judder_keys::problem::Placed;
use judder_keys::section::{Section, list, whole, wrong_type};
use serde_json::{Map, Value as Json, json};

/// What `[substrate]` says beside its numeric keys.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Substrate {
    /// How the relaxation was given.
    pub source: RelaxationSource,
    /// The temperature, where it is not that at which the times hold.
    pub temperature: Option<Temperature>,
    /// h in m, of a layer on a rigid base; a half-space has none.
    pub thickness: Option<f64>,
}

impl Substrate {
    /// Whether the key has a value: several retardation times have a mean, but no one relaxation time.
    pub fn has(&self, key: OscillatorKey) -> bool {
        key != OscillatorKey::RelaxationTime || self.source == RelaxationSource::OneTime
    }

    /// Whether the value of a numeric key is the one that is taken: not where data or a continuous spectrum decide in its place.
    pub(crate) fn takes(&self, key: OscillatorKey) -> bool {
        let decided = match &self.source {
            RelaxationSource::Dma { rubbery_modulus, .. } => match key {
                OscillatorKey::RubberyModulus => rubbery_modulus.is_none(),
                OscillatorKey::GlassyModulus | OscillatorKey::RetardationTime => true,
                _ => false,
            },
            RelaxationSource::Continuous(source) => match key {
                OscillatorKey::GlassyModulus => matches!(source.density(), Density::Samples(_)),
                OscillatorKey::RetardationTime => true,
                _ => false,
            },
            RelaxationSource::OneTime | RelaxationSource::Prony(_) | RelaxationSource::Relaxation(_) => false,
        };
        self.has(key) && !decided
    }

    /// The file that the substrate names, where it does.
    pub fn file(&self) -> Option<&FileReference> {
        match &self.source {
            RelaxationSource::Dma { file, .. } => Some(file),
            _ => None,
        }
    }

    /// The key of `[substrate]` that decides moduli and times together, so that none of them can be swept alone.
    pub fn decided_by(&self) -> Option<&'static str> {
        match &self.source {
            RelaxationSource::OneTime => self.temperature.map(|_| "substrate.temperature"),
            // the numeric keys say all of one term
            RelaxationSource::Prony(terms) if terms.len() == 1 => {
                self.temperature.map(|_| "substrate.temperature")
            }
            RelaxationSource::Prony(_) => Some("substrate.prony"),
            RelaxationSource::Relaxation(_) => Some("substrate.relaxation"),
            RelaxationSource::Continuous(_) => Some("substrate.continuous"),
            RelaxationSource::Dma { .. } => Some("substrate.dma"),
        }
    }
}

/// How the relaxation of a substrate was given.
#[derive(Debug, Clone, PartialEq, Default)]
pub enum RelaxationSource {
    /// One time with two moduli: the numeric keys say all.
    #[default]
    OneTime,
    /// Creep terms: 1/E∞ = 1/E0 − Σ C_k.
    Prony(Vec<CreepTerm>),
    /// Terms of the relaxation modulus: E∞ = E0 + Σ E_j.
    Relaxation(Vec<RelaxationTerm>),
    /// A continuous spectrum, which is taken apart into terms.
    Continuous(ContinuousSource),
    /// A series fitted to measured moduli, which decides the numeric keys as well.
    Dma {
        /// The measured data.
        file: FileReference,
        /// The number of terms.
        terms: FitTerms,
        /// E0 where the case gives it, Pa; otherwise the data decide.
        rubbery_modulus: Option<f64>,
    },
}

impl RelaxationSource {
    /// The key of `[substrate]` that says it, where the numeric keys do not.
    pub(crate) fn key(&self) -> Option<&'static str> {
        match self {
            Self::OneTime => None,
            Self::Prony(_) => Some("prony"),
            Self::Relaxation(_) => Some("relaxation"),
            Self::Continuous(_) => Some("continuous"),
            Self::Dma { .. } => Some("dma"),
        }
    }

    /// How many terms were given; `None` where measured data or a continuous spectrum decide.
    pub fn terms(&self) -> Option<usize> {
        match self {
            Self::OneTime => Some(1),
            Self::Prony(terms) => Some(terms.len()),
            Self::Relaxation(terms) => Some(terms.len()),
            Self::Dma { .. } | Self::Continuous(_) => None,
        }
    }
}

/// How many terms a fit has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FitTerms {
    /// As few as describe the data.
    Auto,
    /// This many.
    Given(usize),
}

/// `[substrate]`, as a case says it.
#[derive(Debug, Clone, PartialEq, Default, Settings)]
#[settings(check = SubstrateKeys::fit)]
pub(crate) struct SubstrateKeys {
    #[key(flatten, rule = "substrate")]
    numbers: Numbers<OscillatorKey>,
    /// Terms of the creep compliance: 1/E∞ = 1/E0 − Σ compliance.
    #[key(rule = TERMS, omitted)]
    prony: Option<Vec<CreepTerm>>,
    /// Terms of the relaxation modulus: E∞ = E0 + Σ modulus.
    #[key(rule = TERMS, omitted)]
    relaxation: Option<Vec<RelaxationTerm>>,
    /// A continuous spectrum, taken apart into retardation times.
    #[key(omitted)]
    continuous: Option<ContinuousSource>,
    /// A series fitted to measured moduli.
    #[key(omitted)]
    dma: Option<MeasuredModuli>,
    /// Temperature of the substrate; needs `shift`.
    #[key(rule = Number::positive(Dimension::TEMPERATURE), symbol = "T", omitted)]
    temperature: Option<f64>,
    /// The rule by which temperature moves all times.
    #[key(omitted)]
    shift: Option<Shift>,
    /// Thickness of the layer that a cylinder presses on, held by a rigid base; a half-space where left out.
    #[key(rule = Number::positive(Dimension::LENGTH), symbol = "h", omitted)]
    thickness: Option<f64>,
}

/// A series fitted to measured moduli.
#[derive(Debug, Clone, PartialEq, Settings)]
struct MeasuredModuli {
    /// CSV of frequency, storage and loss modulus; a path relative to the case file.
    #[key(example = "\"…\", a path relative to the case file")]
    file: FileReference,
    /// Number of terms of the fitted series.
    #[key(default = FitTerms::Auto)]
    terms: FitTerms,
}

/// The most terms that a series or a fit may have.
pub const TERM_LIMIT: usize = 60;

/// A time of a spectrum.
pub(crate) const TIME: Number = Number::positive(Dimension::TIME);
const TERMS: Several<()> = Several { of: (), length: [1, TERM_LIMIT] };

/// A term of a series, at a time of its own.
pub(crate) trait Timed {
    /// s.
    fn time(&self) -> f64;
}

impl Timed for CreepTerm {
    fn time(&self) -> f64 {
        self.retardation_time
    }
}

impl Timed for RelaxationTerm {
    fn time(&self) -> f64 {
        self.relaxation_time
    }
}

impl Setting for FitTerms {
    type Rule = ();

    fn form((): &()) -> Allowed {
        let schema = json!({
            "anyOf": [{ "type": "integer", "minimum": 1, "maximum": TERM_LIMIT }, { "const": "auto" }],
        });
        let words = format!("an integer from 1 to {TERM_LIMIT}, or `\"auto\"`");
        Allowed::Told { schema, words, keys: Vec::new() }
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, (): &()) -> Result<Self, Fault> {
        let path = section.path(key);
        match &node.data {
            Data::Text(word) if word == "auto" => Ok(Self::Auto),
            Data::Number { .. } => whole(&path, node, 1, TERM_LIMIT).map(Self::Given),
            _ => Err(wrong_type(&path, "a number of terms or \"auto\"", node)),
        }
    }

    fn write(&self, (): &()) -> Json {
        match self {
            Self::Auto => json!("auto"),
            Self::Given(count) => json!(count),
        }
    }
}

/// The keys that each say all of the relaxation, and those that follow from them.
const CONFLICTS: [(&str, &str); 18] = [
    ("retardation_time", "relaxation_time"),
    ("retardation_time", "prony"),
    ("retardation_time", "relaxation"),
    ("retardation_time", "dma"),
    ("relaxation_time", "prony"),
    ("relaxation_time", "relaxation"),
    ("relaxation_time", "dma"),
    ("glassy_modulus", "prony"),
    ("glassy_modulus", "relaxation"),
    ("glassy_modulus", "dma"),
    ("prony", "relaxation"),
    ("prony", "dma"),
    ("retardation_time", "continuous"),
    ("relaxation_time", "continuous"),
    ("prony", "continuous"),
    ("relaxation", "continuous"),
    ("relaxation", "dma"),
    ("continuous", "dma"),
];

/// Refuses keys of `[substrate]` that say the same, whatever is wrong with them.
pub(crate) fn refuse_conflicts(root: &Section<'_>) -> Result<(), Fault> {
    let Some(section) = root.inner("substrate")? else { return Ok(()) };
    CONFLICTS.iter().try_for_each(|(first, second)| conflict(&section, first, second))
}

impl SubstrateKeys {
    /// The substrate of what was read: its numbers go into `inputs`, files are relative to `folder`.
    ///
    /// A series sets the glassy modulus and the mean retardation time, Σ C_k τ_k/Σ C_k, which is the τ of the groups then.
    pub(crate) fn found(
        self,
        root: &Section<'_>,
        inputs: &mut OscillatorInputs,
        folder: &Path,
    ) -> Result<Substrate, Fault> {
        inputs.set_all(&self.numbers);
        let (temperature, thickness) = (self.temperature.zip(self.shift), self.thickness);
        let temperature = temperature.map(|(temperature, shift)| Temperature { temperature, shift });
        let source = match root.inner("substrate")? {
            Some(section) => read_source(self, &section, inputs, folder)?,
            None => RelaxationSource::OneTime,
        };
        Ok(Substrate { source, temperature, thickness })
    }
}

fn read_source(
    keys: SubstrateKeys,
    section: &Section<'_>,
    inputs: &mut OscillatorInputs,
    folder: &Path,
) -> Result<RelaxationSource, Fault> {
    if let Some(terms) = keys.prony {
        let compliance: f64 = terms.iter().map(|term| term.compliance).sum();
        let moment: f64 = terms.iter().map(|term| term.retardation_time * term.compliance).sum();
        match terms.as_slice() {
            [term] => inputs.set_prony(term.retardation_time, term.compliance),
            _ => inputs.set_prony(moment / compliance, compliance),
        }
        return Ok(RelaxationSource::Prony(terms));
    }
    if let Some(terms) = keys.relaxation {
        set_relaxation(inputs, &terms);
        return Ok(RelaxationSource::Relaxation(terms));
    }
    if let Some(source) = keys.continuous {
        if matches!(source.density(), Density::Samples(_)) {
            conflict(section, "continuous", "glassy_modulus")?;
        }
        source.decide(inputs);
        return Ok(RelaxationSource::Continuous(source));
    }
    let (Some(dma), Some(node)) = (keys.dma, section.get("dma")) else {
        return Ok(RelaxationSource::OneTime);
    };
    let table = Section::of_table(node, "substrate.dma", "`substrate.dma`")?;
    let file = read_file_reference(&table, "file", folder)?;
    let rubbery = section.get("rubbery_modulus").map(|_| inputs.number(OscillatorKey::RubberyModulus));
    Ok(RelaxationSource::Dma { file, terms: dma.terms, rubbery_modulus: rubbery })
}

/// Sets E∞ = E0 + Σ E_j and the mean retardation time: both forms have one moment, Σ C_k τ_k = Σ E_j ρ_j/E0².
fn set_relaxation(inputs: &mut OscillatorInputs, terms: &[RelaxationTerm]) {
    let rubbery = inputs.number(OscillatorKey::RubberyModulus);
    let glassy = rubbery + terms.iter().map(|term| term.modulus).sum::<f64>();
    let moment =
        terms.iter().map(|term| term.relaxation_time * term.modulus / rubbery).sum::<f64>() / rubbery;
    inputs.set(OscillatorKey::GlassyModulus, Value::si(glassy));
    inputs.set(OscillatorKey::RetardationTime, Value::si(moment / (1.0 / rubbery - 1.0 / glassy)));
}

/// Refuses terms that do not ascend in time, none and too many; the path is that of their list.
pub(crate) fn are_terms<T: Timed>(
    section: &Section<'_>,
    path: &'static str,
    terms: Option<&Vec<T>>,
) -> Result<(), Fault> {
    let (_, key) = path.rsplit_once('.').unwrap_or_default();
    let (Some(terms), Some(node)) = (terms, section.get(key)) else { return Ok(()) };
    for (pair, item) in terms.windows(2).zip(list(path, node)?.iter().skip(1)) {
        let (before, time) = (pair[0].time(), pair[1].time());
        if before > time {
            let problem = ContactProblem::UnsortedTimes { key: path, before, time };
            return Err(problem.at(item.place));
        }
    }
    match terms.len() {
        0 => Err(Cause::EmptyList { key: path.to_owned() }.at(node.place)),
        1..=TERM_LIMIT => Ok(()),
        found => {
            let key = format!("the number of terms of {path}");
            let problem = Cause::Count { key, from: 1, to: TERM_LIMIT, found: found as i64 };
            Err(problem.at(node.place))
        }
    }
}

impl SubstrateKeys {
    /// Refuses series that are none, and a temperature without its shift, or a shift alone.
    fn fit(&mut self, section: &Section<'_>) -> Result<(), Fault> {
        let series = both(
            are_terms(section, "substrate.prony", self.prony.as_ref()),
            are_terms(section, "substrate.relaxation", self.relaxation.as_ref()),
        );
        let temperature = match (self.temperature, self.shift) {
            (None, Some(_)) => Err(section
                .missing("temperature", "temperature = \"25 degC\", at which the substrate is used")),
            (Some(_), None) => Err(section.missing(
                "shift",
                "shift = { wlf = { c1 = …, c2 = \"… K\", reference_temperature = \"… degC\" } } or shift = { arrhenius = { … } }",
            )),
            _ => Ok(()),
        };
        both(series, temperature).map(drop)
    }
}

impl Substrate {
    /// What a case says of it, with the numbers in use.
    pub(crate) fn keys(&self, inputs: &OscillatorInputs) -> SubstrateKeys {
        let numbers = inputs.numbers("substrate", |key| self.takes(key));
        let mut keys = SubstrateKeys { numbers, ..SubstrateKeys::default() };
        match self.source.clone() {
            RelaxationSource::OneTime => (),
            RelaxationSource::Prony(terms) => keys.prony = Some(terms),
            RelaxationSource::Relaxation(terms) => keys.relaxation = Some(terms),
            RelaxationSource::Continuous(source) => keys.continuous = Some(source),
            RelaxationSource::Dma { file, terms, .. } => keys.dma = Some(MeasuredModuli { file, terms }),
        }
        keys.temperature = self.temperature.map(|own| own.temperature);
        keys.shift = self.temperature.map(|own| own.shift);
        keys.thickness = self.thickness;
        keys
    }

    /// A canonical form that says how the relaxation was given besides.
    pub(crate) fn written(&self, json: Map<String, Json>, time_form: TimeForm) -> Json {
        let mut json = Json::Object(json);
        json["substrate"]["given_as"] = json!(self.source.key().unwrap_or(time_form.name()));
        json
    }
}
