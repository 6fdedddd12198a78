//! The contact case: a substrate, an indenter, and what is computed of their contact.

use std::path::Path;

use crate::REGISTRY;
use crate::contact::settings::ContactScope;
use crate::contact::shape::Shape;
use crate::contact::{Exciting, KINDS};
use crate::oscillator::case::moduli_place;
use crate::oscillator::inputs::{LawName, OscillatorInputs};
use crate::oscillator::keys::OscillatorKey;
use crate::substrate::{RelaxationSource, Substrate, SubstrateKeys, read_substrate};
use judder_keys::Settings;
use judder_keys::declared::{Allowed, Declaration, Settings};
use judder_keys::document::Node;
use judder_keys::error::Fault;
use judder_keys::file_reference::FileReference;
use judder_keys::memory::Memory;
use judder_keys::numeric_key::read_value;
use judder_keys::section::Section;
use judder_study::case::analysis::{Planned, read_analyses};
use std::sync::Arc;

/// A validated contact case.
#[derive(Debug, Clone)]
pub struct ContactCase {
    /// The title; empty where the case gives none.
    pub title: String,
    /// The numeric keys of substrate and indenter; those of an oscillator keep their defaults and mean nothing.
    pub inputs: OscillatorInputs,
    /// What else is said of the substrate.
    pub substrate: Substrate,
    /// The shape of the indenter.
    pub shape: Shape,
    /// The analyses in the order of the case file.
    pub analyses: Vec<Planned<Arc<dyn Exciting>>>,
}

/// What a case has beside its tables.
#[derive(Debug, Clone, PartialEq, Settings)]
pub(crate) struct ContactKeys {
    /// The title.
    #[key(default = String::new())]
    title: String,
    /// What the largest grid of one contact may take; an analysis may say it for itself.
    memory_limit: Memory,
}

/// What an indenter has beside its radius.
#[derive(Debug, Clone, PartialEq, Settings)]
pub(crate) struct IndenterKeys {
    /// The shape of the indenter.
    shape: Shape,
}

impl ContactCase {
    /// The numeric keys that a contact case has.
    pub const KEYS: [OscillatorKey; 6] = [
        OscillatorKey::RubberyModulus,
        OscillatorKey::GlassyModulus,
        OscillatorKey::RetardationTime,
        OscillatorKey::RelaxationTime,
        OscillatorKey::PoissonRatio,
        OscillatorKey::Radius,
    ];

    /// The files that the case names.
    pub fn files(&self) -> Vec<&FileReference> {
        let heights = match &self.shape {
            Shape::Heights(heights) => Some(&heights.file),
            _ => None,
        };
        self.substrate.file().into_iter().chain(heights).collect()
    }
}

/// The dotted paths of the numbers of substrate and indenter beside those in [`KEYS`](crate::oscillator::keys::KEYS).
pub fn contact_numbers() -> Vec<String> {
    fn numbers(prefix: &str, keys: &[Declaration]) -> Vec<String> {
        let of_key = |key: &Declaration| {
            let path = format!("{prefix}.{}", key.name);
            match &key.form {
                Allowed::Number(_) => vec![path],
                // of what tells of itself, a quantity has examples
                Allowed::Told { schema, .. } if schema.get("examples").is_some() => vec![path],
                Allowed::Table { keys, .. } | Allowed::Told { keys, .. } => numbers(&path, keys),
                _ => Vec::new(),
            }
        };
        keys.iter().flat_map(of_key).collect()
    }
    let substrate = numbers("substrate", &SubstrateKeys::declarations());
    substrate.into_iter().chain(numbers("indenter", &IndenterKeys::declarations())).collect()
}

/// Reads a contact case from the root of its tree; files are relative to `folder`.
pub(crate) fn read(root: &Node, folder: &Path) -> Result<ContactCase, Fault> {
    let known = ["title", "model", "memory_limit", "substrate", "indenter", "analysis", "sweep"];
    let root = Section::open(root, "", "a contact case", &known)?;
    let keys = ContactKeys::read_table(&root)?;
    let mut case = ContactCase {
        title: keys.title,
        inputs: OscillatorInputs::default(),
        substrate: Substrate::default(),
        shape: Shape::Paraboloid,
        analyses: Vec::new(),
    };
    if let Some(node) = root.get("substrate") {
        case.substrate = read_substrate(node, &mut case.inputs, folder)?;
    }
    if let Some(node) = root.get("indenter") {
        let entry = OscillatorKey::Radius.entry();
        let indenter = Section::of_table(node, "indenter", "[indenter]")?;
        indenter.refuse_others(&[entry.name(), IndenterKeys::KEYS[0]])?;
        if let Some(node) = indenter.get(entry.name()) {
            case.inputs.set(entry.key, read_value(entry, entry.path, node)?);
        }
        case.shape = IndenterKeys::read_table(&indenter)?.shape.found(&indenter, folder)?;
    }
    let moduli_known = !matches!(case.substrate.source, RelaxationSource::Dma { .. });
    if moduli_known {
        // an elastic substrate is in order: it is the limit
        case.inputs.check(LawName::Hertz).map_err(|cause| cause.at(moduli_place(&root)))?;
    }
    let memory = keys.memory_limit;
    let scope = ContactScope { shape: case.shape.clone(), inputs: case.inputs, moduli_known, memory };
    case.analyses = read_analyses(&root, &scope, &KINDS, REGISTRY)?;
    Ok(case)
}
