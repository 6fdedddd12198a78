//! The structure case: one linear structure alone, from a generator, a mesh file or the matrices of another program.
//!
//! - [`body`]: what elements, materials and supports make: `[structure]`.
//! - [`matrices`]: what other programs assembled: `[matrices]`, sums of files with factors.
//! - [`damping`]: `[damping]` of a body.
//! - [`reduction`]: `[reduction]`, which freedoms and modes are kept.
//! - `scope`: what the analyses need to know of the case.
//! - [`problem`]: what can be wrong with all of it, beyond types, units and ranges.

pub mod body;
pub mod damping;
pub(crate) mod lists;
pub mod matrices;
pub mod problem;
pub mod reduction;
pub(crate) mod scope;

use std::path::Path;

use crate::REGISTRY;
use crate::parameters::{Parameter, Parameters};
use crate::swept_keys::ParameterKeys;
use body::{Body, BodyKeys, Geometry, read_body};
use damping::Damping;
use judder_keys::cause::Cause;
use judder_keys::declared::{Settings, both, read_settings};
use judder_keys::document::Node;
use judder_keys::error::Fault;
use judder_keys::file_reference::FileReference;
use judder_keys::problem::Placed;
use judder_keys::section::Section;
use judder_study::case::analysis::{Planned, read_analyses};
use judder_study::model::Analysis;
use matrices::{MatrixSums, read_matrices};
use problem::StructureProblem;
use reduction::Reduction;
use scope::StructureScope;
use std::sync::Arc;

/// A validated structure case.
#[derive(Debug, Clone)]
pub struct StructureCase {
    /// The title; empty where the case gives none.
    pub title: String,
    /// The parameters in the order of the case file; only factors of matrices use them.
    pub parameters: Vec<Parameter>,
    /// Where the structure comes from.
    pub source: StructureSource,
    /// The damping of a body; matrices have their own.
    pub damping: Damping,
    /// Which freedoms and modes a reduction keeps.
    pub reduction: Option<Reduction>,
    /// The analyses in the order of the case file.
    pub analyses: Vec<Planned<Arc<dyn Analysis<StructureCase>>>>,
}

/// Where a structure comes from.
#[derive(Debug, Clone)]
pub enum StructureSource {
    /// `[structure]`: elements with materials and supports.
    Body(Box<Body>),
    /// `[matrices]`: what another program assembled.
    Matrices(Box<MatrixSums>),
}

impl StructureCase {
    /// The values of all parameters, in their order: what a sweep starts from.
    pub fn values(&self) -> Vec<f64> {
        self.parameters.iter().map(|parameter| parameter.value).collect()
    }

    /// The files that the case names.
    pub fn files(&self) -> Vec<&FileReference> {
        self.source.files()
    }
}

impl StructureSource {
    /// The files that the source names.
    pub fn files(&self) -> Vec<&FileReference> {
        match self {
            Self::Body(body) => match &body.geometry {
                Geometry::Mesh(file) => vec![file],
                Geometry::Beam(_) | Geometry::Block(_) => Vec::new(),
            },
            Self::Matrices(sums) => sums.files(),
        }
    }
}

/// Reads a structure case from the root of its tree; files are relative to `folder`.
pub(crate) fn read(root: &Node, folder: &Path) -> Result<StructureCase, Fault> {
    let known = [
        "title",
        "model",
        "parameters",
        "structure",
        "matrices",
        "damping",
        "reduction",
        "analysis",
        "sweep",
    ];
    let root = Section::open(root, "", "a structure case", &known)?;
    let parameters = Parameters::of(&root)?.0;
    let keys = ParameterKeys(parameters.iter().map(|parameter| parameter.name.clone()).collect());
    let damping = root.get("damping").map(|node| read_settings(node, "damping", "[damping]"));
    let damping = damping.unwrap_or_else(|| Ok(Damping::default()));
    let (source, damping) = both(read_source(&root, &keys, folder), damping)?;
    let reduction = root.get("reduction").map(|node| {
        let section = Section::of_table(node, "reduction", "[reduction]")?;
        let kept = section.required("kept", "kept = [{ set = \"end\" }], the freedoms that are kept");
        both(kept, Reduction::of(&section, &source)).map(|(_, reduction)| reduction)
    });
    let values: Vec<f64> = parameters.iter().map(|parameter| parameter.value).collect();
    let scope = StructureScope { keys, source: source.clone(), values, has_reduction: reduction.is_some() };
    let (reduction, analyses) =
        both(reduction.transpose(), read_analyses(&root, &scope, &super::KINDS, REGISTRY))?;
    let title = root.text("title")?.unwrap_or_default().to_owned();
    Ok(StructureCase { title, parameters, source, damping, reduction, analyses })
}

/// Reads `[structure]` or `[matrices]`.
fn read_source(root: &Section<'_>, keys: &ParameterKeys, folder: &Path) -> Result<StructureSource, Fault> {
    match (root.get("structure"), root.get("matrices")) {
        (Some(node), None) => {
            refuse(root, "parameters", "[structure]")?;
            let section = Section::of_table(node, "structure", "[structure]")?;
            let body = both(section.refuse_others(&BodyKeys::keys()), read_body(&section, folder));
            body.map(|((), body)| StructureSource::Body(Box::new(body)))
        }
        (None, Some(node)) => {
            refuse(root, "damping", "[matrices]")?;
            let section = Section::open(node, "matrices", "[matrices]", &matrices::KEYS)?;
            Ok(StructureSource::Matrices(Box::new(read_matrices(&section, &keys.0, folder)?)))
        }
        (None, None) => Err(StructureProblem::NoStructure.at(root.place)),
        (Some(_), Some(node)) => {
            let (first, second) = ("structure".to_owned(), "matrices".to_owned());
            Err(Cause::Conflict { first, second }.at(node.place))
        }
    }
}

/// Refuses a section that has no meaning beside another.
fn refuse(root: &Section<'_>, key: &'static str, beside: &str) -> Result<(), Fault> {
    match root.get(key) {
        None => Ok(()),
        Some(node) => {
            let problem = Cause::Meaningless { key, with: beside.to_owned() };
            Err(problem.at(node.place))
        }
    }
}
