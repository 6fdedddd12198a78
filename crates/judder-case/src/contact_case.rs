//! The contact case: a substrate, an indenter, and what is computed of their contact.

use std::path::Path;

use crate::analysis::{Analysis, read_analyses};
use crate::contact_analysis::{ContactAnalysis, ContactScope, KINDS};
use crate::document::Node;
use crate::error::Fault;
use crate::file_reference::FileReference;
use crate::inputs::{LawName, OscillatorInputs};
use crate::keys::OscillatorKey;
use crate::memory::{MEMORY_LIMIT, Memory, read_memory_limit};
use crate::oscillator_case::moduli_place;
use crate::section::Section;
use crate::shape::{Shape, read_shape};
use crate::substrate::{RelaxationSource, Substrate, read_substrate};
use crate::swept_keys::read_value;

/// A validated contact case.
#[derive(Debug, Clone, PartialEq)]
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
    pub analyses: Vec<Analysis<ContactAnalysis>>,
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

/// Reads a contact case from the root of its tree; files are relative to `folder`.
pub(crate) fn read(root: &Node, folder: &Path) -> Result<ContactCase, Fault> {
    let known = ["title", "model", MEMORY_LIMIT, "substrate", "indenter", "analysis", "sweep"];
    let root = Section::open(root, "", "a contact case", &known)?;
    let mut case = ContactCase {
        title: root.text("title")?.unwrap_or_default().to_owned(),
        inputs: OscillatorInputs::default(),
        substrate: Substrate::default(),
        shape: Shape::Paraboloid,
        analyses: Vec::new(),
    };
    if let Some(node) = root.get("substrate") {
        case.substrate = read_substrate(node, &mut case.inputs, folder)?;
    }
    if let Some(node) = root.get("indenter") {
        let indenter = Section::open(node, "indenter", "[indenter]", &["radius", "shape"])?;
        let entry = OscillatorKey::Radius.entry();
        if let Some(node) = indenter.get(entry.name()) {
            case.inputs.set(entry.key, read_value(entry, entry.path, node)?);
        }
        case.shape = read_shape(&indenter, folder)?;
    }
    let moduli_known = !matches!(case.substrate.source, RelaxationSource::Dma { .. });
    if moduli_known {
        // an elastic substrate is in order: it is the limit
        case.inputs.check(LawName::Hertz).map_err(|cause| cause.at(moduli_place(&root)))?;
    }
    let memory = read_memory_limit(&root)?.unwrap_or(Memory::DEFAULT);
    let scope = ContactScope { shape: case.shape.clone(), inputs: case.inputs, moduli_known, memory };
    case.analyses = read_analyses(&root, &scope, &KINDS)?;
    Ok(case)
}
