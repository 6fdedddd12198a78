//! The oscillator case: the paper's values, then whatever the case file says otherwise.

use std::path::Path;

use crate::REGISTRY;
use crate::contact::settings::{ACCURACY, LAW_ACCURACY};
use crate::oscillator::inputs::{FrictionLoad, LawName, OscillatorInputs, TimeForm};
use crate::oscillator::keys::KEYS;
use crate::oscillator::problem::OscillatorProblem;
use crate::oscillator::{KINDS, Operated};
use crate::substrate::{RelaxationSource, Substrate, read_substrate};
use crate::swept_keys::OscillatorKeys;
use judder_keys::cause::Cause;
use judder_keys::declared::Setting;
use judder_keys::document::{Data, Node};
use judder_keys::error::{Fault, Place};
use judder_keys::file_reference::{FileReference, read_file_reference};
use judder_keys::numeric_key::Key;
use judder_keys::numeric_key::read_value;
use judder_keys::problem::Placed;
use judder_keys::section::Section;
use judder_study::case::analysis::{Planned, read_analyses};
use std::sync::Arc;

/// A validated oscillator case.
#[derive(Debug, Clone)]
pub struct OscillatorCase {
    /// The title; empty where the case gives none.
    pub title: String,
    /// The contact law.
    pub law: LawName,
    /// The file of the law, for [`LawName::File`].
    pub law_file: Option<FileReference>,
    /// The relative accuracy of the law, for [`LawName::Bem`].
    pub law_accuracy: f64,
    /// The force that the viscoelastic friction coefficient multiplies.
    pub friction_load: FrictionLoad,
    /// The value of every numeric key at the operating point of the case.
    pub inputs: OscillatorInputs,
    /// What is said of the substrate beside its numeric keys.
    pub substrate: Substrate,
    /// The analyses in the order of the case file.
    pub analyses: Vec<Planned<Arc<dyn Operated>>>,
}

impl Default for OscillatorCase {
    /// The oscillator paper's values, without analyses.
    fn default() -> Self {
        Self {
            title: String::new(),
            law: LawName::OscillatorPaper,
            law_file: None,
            law_accuracy: LAW_ACCURACY,
            friction_load: FrictionLoad::NormalLoad,
            inputs: OscillatorInputs::default(),
            substrate: Substrate::default(),
            analyses: Vec::new(),
        }
    }
}

impl OscillatorCase {
    /// Whether the other has the same oscillator in the same contact, whatever its analyses are.
    pub(crate) fn is_like(&self, other: &Self) -> bool {
        let Self { title, inputs, law, law_file, law_accuracy, friction_load, substrate, analyses: _ } = self;
        let of_contact = (law, law_file, law_accuracy, friction_load);
        (title, inputs, substrate) == (&other.title, &other.inputs, &other.substrate)
            && of_contact == (&other.law, &other.law_file, &other.law_accuracy, &other.friction_load)
    }

    /// How the relaxation of the substrate was given.
    pub fn time_form(&self) -> TimeForm {
        self.inputs.time_form()
    }

    /// The files that the case names.
    pub fn files(&self) -> Vec<&FileReference> {
        self.substrate.file().into_iter().chain(&self.law_file).collect()
    }
}

/// The sections of numeric keys, in the order of the case file.
pub(crate) const SECTIONS: [&str; 5] = ["substrate", "indenter", "contact", "oscillator", "operation"];

/// The keys of a section that are not numeric.
fn other_keys(section: &str) -> &'static [&'static str] {
    match section {
        "contact" => &["law", "friction_load"],
        _ => &[],
    }
}

/// Reads an oscillator case from the root of its tree; files are relative to `folder`.
pub(crate) fn read(root: &Node, folder: &Path) -> Result<OscillatorCase, Fault> {
    let known: Vec<_> = ["title", "model"].into_iter().chain(SECTIONS).chain(["analysis", "sweep"]).collect();
    let root = Section::open(root, "", "an oscillator case", &known)?;
    let mut case = OscillatorCase::default();
    if let Some(title) = root.text("title")? {
        title.clone_into(&mut case.title);
    }
    for name in SECTIONS {
        let Some(node) = root.get(name) else { continue };
        if name == "substrate" {
            case.substrate = read_substrate(node, &mut case.inputs, folder)?;
            continue;
        }
        let entries = || KEYS.iter().filter(|entry| entry.section() == name);
        let known: Vec<_> = entries().map(Key::name).chain(other_keys(name).iter().copied()).collect();
        let section = Section::open(node, name, &format!("[{name}]"), &known)?;
        for entry in entries() {
            if let Some(node) = section.get(entry.name()) {
                case.inputs.set(entry.key, read_value(entry, entry.path, node)?);
            }
        }
        if name == "contact" {
            read_contact(&section, &mut case, folder)?;
        }
    }
    check_terms(&case).map_err(|cause| cause.at(moduli_place(&root)))?;
    let keys = OscillatorKeys { inputs: case.inputs, law: case.law, decided_by: case.substrate.decided_by() };
    case.analyses = read_analyses(&root, &keys, &KINDS, REGISTRY)?;
    Ok(case)
}

/// Where the ratio of the moduli was given: the key that says most about it.
pub(crate) fn moduli_place(root: &Section<'_>) -> Place {
    let node = match root.get("substrate").map(|node| &node.data) {
        Some(Data::Table(table)) => {
            ["prony", "relaxation", "continuous", "dma", "glassy_modulus", "rubbery_modulus"]
                .into_iter()
                .find_map(|key| table.get(key))
        }
        _ => None,
    };
    node.map_or(root.place, |entry| entry.node.place)
}

/// Checks the moduli, and that a fitted law is asked about one retardation time alone.
fn check_terms(case: &OscillatorCase) -> Result<(), Cause> {
    let terms = match &case.substrate.source {
        RelaxationSource::OneTime => 1,
        RelaxationSource::Prony(terms) => terms.len(),
        RelaxationSource::Relaxation(terms) => terms.len(),
        RelaxationSource::Continuous(_) => 2,
        // measured data decide the moduli, and the number of terms
        RelaxationSource::Dma { .. } if case.law.is_fitted() => 2,
        RelaxationSource::Dma { .. } => return Ok(()),
    };
    if terms > 1 && case.law.is_fitted() {
        return Err(OscillatorProblem::SeveralTimes { law: case.law }.into());
    }
    case.inputs.check(case.law)
}

/// The keys of a law that is a table: a file, or a computation with its accuracy.
const LAW_KEYS: [&str; 3] = ["file", "computed", "accuracy"];

/// Reads a law that is a table.
fn read_law_table(table: &Section<'_>, case: &mut OscillatorCase, folder: &Path) -> Result<(), Fault> {
    let Some(node) = table.get("computed") else {
        if let Some(accuracy) = table.get("accuracy") {
            let requirement =
                "left out, or stand beside `computed = true`: a file has the accuracy that it has";
            return Err(OscillatorProblem::LawTable { key: "accuracy", requirement }.at(accuracy.place));
        }
        case.law_file = Some(read_file_reference(table, "file", folder)?);
        case.law = LawName::File;
        return Ok(());
    };
    if table.boolean("computed")? != Some(true) {
        let requirement = "true, or left out";
        return Err(OscillatorProblem::LawTable { key: "computed", requirement }.at(node.place));
    }
    if let Some(file) = table.get("file") {
        let requirement = "left out beside `computed = true`: a law is computed or read";
        return Err(OscillatorProblem::LawTable { key: "file", requirement }.at(file.place));
    }
    case.law = LawName::Bem;
    if let Some(node) = table.get("accuracy") {
        case.law_accuracy = Setting::read(table, "accuracy", node, &ACCURACY)?;
    }
    Ok(())
}

/// Reads the contact law and the friction load.
fn read_contact(section: &Section<'_>, case: &mut OscillatorCase, folder: &Path) -> Result<(), Fault> {
    if let Some(node @ Node { data: Data::Table(_), .. }) = section.get("law") {
        read_law_table(&Section::open(node, "contact.law", "`contact.law`", &LAW_KEYS)?, case, folder)?;
    } else if let Some(law) = section.choice("law", "contact law", &LawName::ALL)? {
        case.law = law;
    }
    if let Some(load) = section.choice("friction_load", "friction load", &FrictionLoad::ALL)? {
        case.friction_load = load;
    }
    Ok(())
}
