//! The oscillator case: the paper's values, then whatever the case file says otherwise.

use crate::analysis::{Analysis, read_analyses};
use crate::cause::Cause;
use crate::dimension::Dimension;
use crate::document::{Data, Node};
use crate::error::{Fault, Place};
use crate::inputs::{FrictionLoad, LawName, OscillatorInputs, TimeForm};
use crate::keys::{KEYS, Key, OscillatorKey};
use crate::oscillator_analysis::{KINDS, OscillatorAnalysis};
use crate::section::{Section, list};
use crate::swept_keys::{OscillatorKeys, read_value};

/// A validated oscillator case.
#[derive(Debug, Clone, PartialEq)]
pub struct OscillatorCase {
    /// The title; empty where the case gives none.
    pub title: String,
    /// The contact law.
    pub law: LawName,
    /// The force that the viscoelastic friction coefficient multiplies.
    pub friction_load: FrictionLoad,
    /// The value of every numeric key at the operating point of the case.
    pub inputs: OscillatorInputs,
    /// The analyses in the order of the case file.
    pub analyses: Vec<Analysis<OscillatorAnalysis>>,
}

impl Default for OscillatorCase {
    /// The oscillator paper's values, without analyses.
    fn default() -> Self {
        Self {
            title: String::new(),
            law: LawName::OscillatorPaper,
            friction_load: FrictionLoad::NormalLoad,
            inputs: OscillatorInputs::default(),
            analyses: Vec::new(),
        }
    }
}

impl OscillatorCase {
    /// How the relaxation of the substrate was given.
    pub fn time_form(&self) -> TimeForm {
        self.inputs.time_form()
    }
}

/// The sections of numeric keys, in the order of the case file.
pub(crate) const SECTIONS: [&str; 5] = ["substrate", "indenter", "contact", "oscillator", "operation"];

/// The keys of a section that are not numeric.
fn other_keys(section: &str) -> &'static [&'static str] {
    match section {
        "substrate" => &["prony"],
        "contact" => &["law", "friction_load"],
        _ => &[],
    }
}

/// Reads an oscillator case from the root of its tree.
pub(crate) fn read(root: &Node) -> Result<OscillatorCase, Fault> {
    let known: Vec<_> = ["title", "model"].into_iter().chain(SECTIONS).chain(["analysis"]).collect();
    let root = Section::open(root, "", "an oscillator case", &known)?;
    let mut case = OscillatorCase::default();
    if let Some(title) = root.text("title")? {
        title.clone_into(&mut case.title);
    }
    for name in SECTIONS {
        let Some(node) = root.get(name) else { continue };
        let entries = || KEYS.iter().filter(|entry| entry.section() == name);
        let known: Vec<_> = entries().map(Key::name).chain(other_keys(name).iter().copied()).collect();
        let section = Section::open(node, name, &format!("[{name}]"), &known)?;
        for entry in entries() {
            if let Some(node) = section.get(entry.name()) {
                case.inputs.set(entry.key, read_value(entry, entry.path, node)?);
            }
        }
        match name {
            "substrate" => read_time_form(&section, &mut case.inputs)?,
            "contact" => read_contact(&section, &mut case)?,
            _ => (),
        }
    }
    case.inputs.check(case.law).map_err(|cause| cause.at(moduli_place(&root)))?;
    let keys = OscillatorKeys { inputs: case.inputs, law: case.law };
    case.analyses = read_analyses(&root, &keys, &KINDS)?;
    Ok(case)
}

/// Where the ratio of the moduli was given: the key that says most about it.
fn moduli_place(root: &Section<'_>) -> Place {
    let node = match root.get("substrate").map(|node| &node.data) {
        Some(Data::Table(table)) => {
            ["prony", "glassy_modulus", "rubbery_modulus"].into_iter().find_map(|key| table.get(key))
        }
        _ => None,
    };
    node.map_or(root.place, |entry| entry.node.place)
}

/// Reads a Prony term and refuses two ways of saying the same thing.
fn read_time_form(section: &Section<'_>, inputs: &mut OscillatorInputs) -> Result<(), Fault> {
    const PAIRS: [(&str, &str); 4] = [
        ("retardation_time", "relaxation_time"),
        ("retardation_time", "prony"),
        ("relaxation_time", "prony"),
        ("glassy_modulus", "prony"),
    ];
    for (first, second) in PAIRS {
        if let (Some(_), Some(node)) = (section.get(first), section.get(second)) {
            let (first, second) = (section.path(first), section.path(second));
            return Err(Cause::Conflict { first, second }.at(node.place));
        }
    }
    let Some(node) = section.get("prony") else { return Ok(()) };
    let terms = list("substrate.prony", node)?;
    let read = terms.iter().map(read_prony_term).collect::<Result<Vec<_>, Fault>>()?;
    match read.as_slice() {
        [(time, compliance)] => {
            inputs.set_prony(*time, *compliance);
            Ok(())
        }
        _ => Err(Cause::PronyTerms { terms: read.len() }.at(node.place)),
    }
}

/// Reads `{ time, compliance }` of one Prony term, s and 1/Pa.
fn read_prony_term(node: &Node) -> Result<(f64, f64), Fault> {
    let section = Section::open(node, "substrate.prony", "a prony term", &["time", "compliance"])?;
    let time = section.required("time", "time = \"10 ms\"")?;
    let compliance = section.required("compliance", "compliance = \"9e-7 1/Pa\"")?;
    let entry = OscillatorKey::RetardationTime.entry();
    let time = read_value(entry, "substrate.prony.time", time)?;
    let entry = Key { dimension: Dimension::COMPLIANCE, ..*entry };
    let compliance = read_value(&entry, "substrate.prony.compliance", compliance)?;
    Ok((time.number, compliance.number))
}

/// Reads the contact law and the friction load.
fn read_contact(section: &Section<'_>, case: &mut OscillatorCase) -> Result<(), Fault> {
    let known = || LawName::ALL.iter().map(|(name, _)| (*name).to_owned()).collect();
    let later =
        |name: &str| Cause::LaterVersion { what: "contact law", name: name.to_owned(), known: known() };
    match section.get("law") {
        Some(node) if matches!(&node.data, Data::Text(text) if text == "bem") => {
            return Err(later("bem").at(node.part(0..3)));
        }
        Some(node) if matches!(&node.data, Data::Table(table) if table.get("file").is_some()) => {
            return Err(later("{ file = … }").at(node.place));
        }
        _ => (),
    }
    if let Some(law) = section.choice("law", "contact law", &LawName::ALL)? {
        case.law = law;
    }
    if let Some(load) = section.choice("friction_load", "friction load", &FrictionLoad::ALL)? {
        case.friction_load = load;
    }
    Ok(())
}
