//! The contact case: a substrate, an indenter, and what is computed of their contact.

use std::path::Path;

use crate::REGISTRY;
use crate::contact::problem::ContactProblem;
use crate::contact::settings::ContactScope;
use crate::contact::shape::ShapeSettings;
use crate::contact::{Exciting, KINDS, MODEL};
use crate::error::ModelError;
use crate::oscillator::inputs::OscillatorInputs;
use crate::oscillator::keys::OscillatorKey;
use crate::oscillator::law_name::LawName;
use crate::substrate::blame::moduli_place;
use crate::substrate::time_unit::time_unit;
use crate::substrate::{RelaxationSource, Substrate, SubstrateKeys, refuse_conflicts};
use judder_contact::kernel::layer::BondedLayer;
use judder_contact::steady::SteadyError;
use judder_keys::Settings;
use judder_keys::declared::{Number, Settings, both};
use judder_keys::dimension::Dimension;
use judder_keys::document::Node;
use judder_keys::error::Fault;
use judder_keys::file_reference::FileReference;
use judder_keys::keys::Numbers;
use judder_keys::memory::Memory;
use judder_keys::problem::Placed;
use judder_keys::quantity::WrittenUnit;
use judder_keys::section::Section;
use judder_study::case::analysis::{Planned, read_analyses};
use judder_study::case::root::{document, read_root};
use serde_json::Value as Json;
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
    pub shape: ShapeSettings,
    /// In which unit the case has the times of the substrate.
    pub time_unit: WrittenUnit,
    /// L in m, across the sliding, of a cylinder.
    pub length: Option<f64>,
    /// The analyses in the order of the case file.
    pub analyses: Vec<Planned<Arc<dyn Exciting>>>,
}

/// What a case says beside its analyses.
#[derive(Debug, Settings)]
#[settings(title = "a contact case")]
pub(crate) struct ContactSections {
    /// What the largest grid of one contact may take; an analysis may say it for itself.
    #[key(unwritten)]
    memory_limit: Memory,
    /// The material that the indenter slides on.
    #[key(default)]
    substrate: SubstrateKeys,
    /// The rigid body that slides.
    #[key(default)]
    indenter: IndenterKeys,
}

/// `[indenter]`.
#[derive(Debug, Clone, PartialEq, Settings)]
struct IndenterKeys {
    #[key(flatten, rule = "indenter")]
    numbers: Numbers<OscillatorKey>,
    /// The shape of the indenter.
    shape: ShapeSettings,
    /// Length of a cylinder across the sliding; all is told per length where left out.
    #[key(rule = Number::positive(Dimension::LENGTH), symbol = "L", omitted)]
    length: Option<f64>,
}

impl ContactCase {
    /// The layer under a cylinder, with lengths in the radius (in m); `None` for a half-space.
    ///
    /// # Errors
    /// A layer that cannot be.
    pub(crate) fn layer(&self, radius: f64) -> Result<Option<BondedLayer>, ModelError> {
        let poisson_ratio = self.inputs.number(OscillatorKey::PoissonRatio);
        let layer =
            self.substrate.thickness.map(|thickness| BondedLayer::new(thickness / radius, poisson_ratio));
        Ok(layer.transpose().map_err(SteadyError::from)?)
    }

    /// The files that the case names.
    pub fn files(&self) -> Vec<&FileReference> {
        let heights = match &self.shape {
            ShapeSettings::Heights(heights) => Some(&heights.file),
            _ => None,
        };
        self.substrate.file().into_iter().chain(heights).collect()
    }
}

impl ContactCase {
    /// The case of what was read, without its analyses; files are relative to `folder`.
    fn of(
        title: String,
        sections: ContactSections,
        root: &Section<'_>,
        folder: &Path,
    ) -> Result<Self, Fault> {
        let ContactSections { substrate, indenter: IndenterKeys { numbers, shape, length }, .. } = sections;
        let mut inputs = OscillatorInputs::default();
        inputs.set_all(&numbers);
        let shape = match root.inner("indenter")? {
            Some(section) => shape.found(&section, folder),
            None => Ok(shape),
        };
        let (substrate, shape) = both(substrate.found(root, &mut inputs, folder), shape)?;
        if shape != ShapeSettings::Cylinder {
            let refused = |section: &str, key: &'static str| line_key(root, section, key, shape.name());
            both(refused("substrate", "thickness"), refused("indenter", "length"))?;
        }
        let time_unit = time_unit(root);
        let case = Self { title, inputs, substrate, shape, time_unit, length, analyses: Vec::new() };
        if case.knows_moduli() {
            // an elastic substrate is in order: it is the limit
            inputs.check(LawName::Hertz).map_err(|cause| cause.at(moduli_place(root)))?;
        }
        Ok(case)
    }

    /// Whether the case says the moduli, and no measured data.
    fn knows_moduli(&self) -> bool {
        !matches!(self.substrate.source, RelaxationSource::Dma { .. })
    }

    /// The canonical form.
    pub(super) fn resolved(&self) -> Json {
        let mut json = document(MODEL.name, &self.title, &self.analyses, |kind, json| kind.write(json));
        let numbers = self.inputs.numbers("indenter", |_| true);
        let sections = ContactSections {
            memory_limit: Memory::DEFAULT,
            substrate: self.substrate.keys(&self.inputs),
            indenter: IndenterKeys { numbers, shape: self.shape.clone(), length: self.length },
        };
        sections.write_table(&mut json);
        self.substrate.written(json, self.inputs.time_form())
    }
}

/// Refuses a key that only a cylinder has.
pub(crate) fn line_key(
    root: &Section<'_>,
    section: &str,
    key: &'static str,
    shape: &'static str,
) -> Result<(), Fault> {
    match root.inner(section)?.and_then(|section| section.get(key)) {
        Some(node) => Err(ContactProblem::LineKey { key, shape }.at(node.place)),
        None => Ok(()),
    }
}

/// Reads a contact case from the root of its tree; files are relative to `folder`.
pub(crate) fn read(node: &Node, folder: &Path) -> Result<ContactCase, Fault> {
    let (root, sections) = read_root::<ContactSections>(node)?;
    let case = both(sections, refuse_conflicts(&root)).and_then(|((title, sections), ())| {
        let memory = sections.memory_limit;
        ContactCase::of(title, sections, &root, folder).map(|case| (case, memory))
    });
    let scope = case.as_ref().ok().map(|(case, memory)| ContactScope {
        shape: case.shape.clone(),
        length: case.length,
        inputs: case.inputs,
        is_layer: case.substrate.thickness.is_some(),
        moduli_known: case.knows_moduli(),
        memory: *memory,
    });
    let ((case, _), analyses) = both(case, read_analyses(&root, &scope, &KINDS, REGISTRY))?;
    Ok(ContactCase { analyses, ..case })
}
