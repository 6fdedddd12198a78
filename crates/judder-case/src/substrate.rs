//! The substrate of a case: moduli and one time, a series of terms, or measured data; and its temperature.

use std::path::Path;

use crate::cause::Cause;
use crate::contact_keys::ContactKey;
use crate::contact_problem::ContactProblem;
use crate::continuous::{ContinuousSource, Density, read_continuous};
use crate::document::{Data, Node};
use crate::error::Fault;
use crate::file_reference::{FileReference, read_file_reference};
use crate::inputs::OscillatorInputs;
use crate::keys::{KEYS, Key, OscillatorKey, Value};
use crate::section::{Section, list, wrong_type};
use crate::swept_keys::read_value;

/// What `[substrate]` says beside its numeric keys.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Substrate {
    /// How the relaxation was given.
    pub source: RelaxationSource,
    /// The temperature, where it is not that at which the times hold.
    pub temperature: Option<Temperature>,
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
                OscillatorKey::GlassyModulus => matches!(source.density, Density::Samples(_)),
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
    Prony(Vec<PronyTerm>),
    /// Terms of the relaxation modulus: E∞ = E0 + Σ E_j.
    Relaxation(Vec<RelaxationTerm>),
    /// A continuous spectrum, which is taken apart into terms.
    Continuous(ContinuousSource),
    /// A series fitted to measured moduli, which decides the numeric keys as well.
    Dma {
        /// The measured data.
        file: FileReference,
        /// The number of terms.
        terms: TermCount,
        /// E0 where the case gives it, Pa; otherwise the data decide.
        rubbery_modulus: Option<f64>,
    },
}

impl RelaxationSource {
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

/// A term of the creep compliance, C (1 − e^{−t/τ}).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PronyTerm {
    /// τ, retardation (creep) time, s.
    pub retardation_time: f64,
    /// C, 1/Pa.
    pub compliance: f64,
}

/// A term of the relaxation modulus, E e^{−t/ρ}.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RelaxationTerm {
    /// ρ, relaxation time, s.
    pub relaxation_time: f64,
    /// E, Pa.
    pub modulus: f64,
}

/// How many terms a fit has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TermCount {
    /// As few as describe the data.
    Auto,
    /// This many.
    Given(usize),
}

/// A temperature and the rule by which it moves all times.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Temperature {
    /// T, K.
    pub temperature: f64,
    /// The rule.
    pub shift: Shift,
}

/// How temperature moves all times of a spectrum.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Shift {
    /// log₁₀ a_T = −C1 (T − T_ref)/(C2 + T − T_ref).
    Wlf {
        /// C1.
        first: f64,
        /// C2, K.
        second: f64,
        /// T_ref, K.
        reference: f64,
    },
    /// ln a_T = E_a/R_gas (1/T − 1/T_ref).
    Arrhenius {
        /// E_a, J/mol.
        activation_energy: f64,
        /// T_ref, K.
        reference: f64,
    },
}

/// The most terms that a series or a fit may have.
pub const TERM_LIMIT: usize = 60;

/// The keys of `[substrate]` that are not numeric.
pub(crate) const OTHER_KEYS: [&str; 6] = ["prony", "relaxation", "continuous", "dma", "temperature", "shift"];

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

/// Reads `[substrate]`: its numeric keys into `inputs`, the rest as it is; files are relative to `folder`.
///
/// A series sets the glassy modulus and the mean retardation time, Σ C_k τ_k/Σ C_k, which is the τ of the groups then.
pub(crate) fn read_substrate(
    node: &Node,
    inputs: &mut OscillatorInputs,
    folder: &Path,
) -> Result<Substrate, Fault> {
    let entries = || KEYS.iter().filter(|entry| entry.section() == "substrate");
    let known: Vec<_> = entries().map(Key::name).chain(OTHER_KEYS).collect();
    let section = Section::open(node, "substrate", "[substrate]", &known)?;
    for entry in entries() {
        if let Some(node) = section.get(entry.name()) {
            inputs.set(entry.key, read_value(entry, entry.path, node)?);
        }
    }
    for (first, second) in CONFLICTS {
        if let (Some(_), Some(node)) = (section.get(first), section.get(second)) {
            let (first, second) = (section.path(first), section.path(second));
            return Err(Cause::Conflict { first, second }.at(node.place));
        }
    }
    let source = read_source(&section, inputs, folder)?;
    Ok(Substrate { source, temperature: read_temperature(&section)? })
}

fn read_source(
    section: &Section<'_>,
    inputs: &mut OscillatorInputs,
    folder: &Path,
) -> Result<RelaxationSource, Fault> {
    if let Some(node) = section.get("prony") {
        let terms = read_terms(node, [ContactKey::PronyTime, ContactKey::PronyCompliance])?;
        let compliance: f64 = terms.iter().map(|[_, compliance]| compliance).sum();
        let moment: f64 = terms.iter().map(|[time, compliance]| time * compliance).sum();
        match terms.as_slice() {
            [[time, compliance]] => inputs.set_prony(*time, *compliance),
            _ => inputs.set_prony(moment / compliance, compliance),
        }
        let term = |[retardation_time, compliance]: [f64; 2]| PronyTerm { retardation_time, compliance };
        return Ok(RelaxationSource::Prony(terms.into_iter().map(term).collect()));
    }
    if let Some(node) = section.get("relaxation") {
        let terms = read_terms(node, [ContactKey::RelaxationTime, ContactKey::RelaxationModulus])?;
        set_relaxation(inputs, &terms);
        let term = |[relaxation_time, modulus]: [f64; 2]| RelaxationTerm { relaxation_time, modulus };
        return Ok(RelaxationSource::Relaxation(terms.into_iter().map(term).collect()));
    }
    if let Some(node) = section.get("continuous") {
        let source = read_continuous(node, inputs)?;
        if let (Density::Samples(_), Some(node)) = (&source.density, section.get("glassy_modulus")) {
            let (first, second) = (section.path("continuous"), section.path("glassy_modulus"));
            return Err(Cause::Conflict { first, second }.at(node.place));
        }
        return Ok(RelaxationSource::Continuous(source));
    }
    let Some(node) = section.get("dma") else { return Ok(RelaxationSource::OneTime) };
    let table = Section::open(node, "substrate.dma", "`substrate.dma`", &["file", "terms"])?;
    let file = read_file_reference(&table, "file", folder)?;
    let terms = match table.get("terms") {
        None => TermCount::Auto,
        Some(Node { data: Data::Text(word), .. }) if word == "auto" => TermCount::Auto,
        Some(Node { data: Data::Number { .. }, .. }) => {
            TermCount::Given(table.whole("terms", 1, TERM_LIMIT)?.unwrap_or(1))
        }
        Some(node) => return Err(wrong_type(&table.path("terms"), "a number of terms or \"auto\"", node)),
    };
    let rubbery = section.get("rubbery_modulus").map(|_| inputs.number(OscillatorKey::RubberyModulus));
    Ok(RelaxationSource::Dma { file, terms, rubbery_modulus: rubbery })
}

/// Sets E∞ = E0 + Σ E_j and the mean retardation time: both forms have one moment, Σ C_k τ_k = Σ E_j ρ_j/E0².
fn set_relaxation(inputs: &mut OscillatorInputs, terms: &[[f64; 2]]) {
    let rubbery = inputs.number(OscillatorKey::RubberyModulus);
    let glassy = rubbery + terms.iter().map(|[_, modulus]| modulus).sum::<f64>();
    let moment = terms.iter().map(|[time, modulus]| time * modulus / rubbery).sum::<f64>() / rubbery;
    inputs.set(OscillatorKey::GlassyModulus, Value::si(glassy));
    inputs.set(OscillatorKey::RetardationTime, Value::si(moment / (1.0 / rubbery - 1.0 / glassy)));
}

/// Reads a list of terms, a time and a weight each, in the order of their times.
pub(crate) fn read_terms(node: &Node, [time, weight]: [ContactKey; 2]) -> Result<Vec<[f64; 2]>, Fault> {
    let (time, weight) = (time.entry(), weight.entry());
    let (key, _) = time.path.rsplit_once('.').unwrap_or_default();
    let items = list(key, node)?;
    let mut terms: Vec<[f64; 2]> = Vec::with_capacity(items.len());
    for item in items {
        let word = match time.key {
            ContactKey::PronyTime => "a prony term",
            ContactKey::RelaxationTime => "a relaxation term",
            _ => "a sample of the spectrum",
        };
        let section = Section::open(item, key, word, &[time.name(), weight.name()])?;
        let read = |entry: &Key<ContactKey>| {
            let expected = format!("{} = \"{}\"", entry.name(), entry.example());
            read_value(entry, entry.path, section.required(entry.name(), &expected)?)
        };
        let term = [read(time)?.number, read(weight)?.number];
        if let Some([before, _]) = terms.last().filter(|[before, _]| *before > term[0]) {
            let problem = ContactProblem::UnsortedTimes { key, before: *before, time: term[0] };
            return Err(Cause::Contact { problem }.at(item.place));
        }
        terms.push(term);
    }
    match terms.len() {
        0 => Err(Cause::EmptyList { key: key.to_owned() }.at(node.place)),
        1..=TERM_LIMIT => Ok(terms),
        found => {
            let key = format!("the number of terms of {key}");
            let problem = ContactProblem::Count { key, from: 1, to: TERM_LIMIT, found: found as i64 };
            Err(Cause::Contact { problem }.at(node.place))
        }
    }
}

/// Reads `temperature` and `shift`, which stand together or not at all.
fn read_temperature(section: &Section<'_>) -> Result<Option<Temperature>, Fault> {
    if section.get("temperature").is_none() && section.get("shift").is_none() {
        return Ok(None);
    }
    let node =
        section.required("temperature", "temperature = \"25 degC\", at which the substrate is used")?;
    let temperature = read_value(ContactKey::Temperature.entry(), "substrate.temperature", node)?.number;
    let expected = "shift = { wlf = { c1 = …, c2 = \"… K\", reference_temperature = \"… degC\" } } or shift = { arrhenius = { … } }";
    let node = section.required("shift", expected)?;
    let rule = Section::open(node, "substrate.shift", "`substrate.shift`", &["wlf", "arrhenius"])?;
    let shift = match (rule.get("wlf"), rule.get("arrhenius")) {
        (Some(_), Some(second)) => {
            let (first, key) = (rule.path("wlf"), rule.path("arrhenius"));
            return Err(Cause::Conflict { first, second: key }.at(second.place));
        }
        (Some(node), None) => {
            let keys = [ContactKey::WlfFirst, ContactKey::WlfSecond, ContactKey::WlfReference];
            let [first, second, reference] = read_numbers(node, keys)?;
            Shift::Wlf { first, second, reference }
        }
        (None, Some(node)) => {
            let keys = [ContactKey::ActivationEnergy, ContactKey::ArrheniusReference];
            let [activation_energy, reference] = read_numbers(node, keys)?;
            Shift::Arrhenius { activation_energy, reference }
        }
        (None, None) => {
            let (key, section) = ("wlf".to_owned(), "`substrate.shift`".to_owned());
            let expected = "wlf = { … } or arrhenius = { … }".to_owned();
            return Err(Cause::MissingKey { key, section, expected }.at(node.place));
        }
    };
    Ok(Some(Temperature { temperature, shift }))
}

/// Reads a table that holds exactly these numbers.
pub(crate) fn read_numbers<const N: usize>(node: &Node, keys: [ContactKey; N]) -> Result<[f64; N], Fault> {
    let names = keys.map(|key| key.entry().name());
    let (path, _) = keys[0].entry().path.rsplit_once('.').unwrap_or_default();
    let section = Section::open(node, path, &format!("`{path}`"), &names)?;
    let mut numbers = [0.0; N];
    for (number, key) in numbers.iter_mut().zip(keys) {
        let entry = key.entry();
        let example =
            if entry.dimension.is_number() { "1.5".to_owned() } else { format!("\"{}\"", entry.example()) };
        let node = section.required(entry.name(), &format!("{} = {example}", entry.name()))?;
        *number = read_value(entry, entry.path, node)?.number;
    }
    Ok(numbers)
}
