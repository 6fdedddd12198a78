//! The structure case: one linear structure alone, from a generator, a mesh file or the matrices of another program.
//!
//! - [`body`]: what elements, materials and supports make: `[structure]`; [`chamfer`]: what is cut off a block.
//! - [`matrices`]: what other programs assembled: `[matrices]`, sums of files with factors. [`arrays`]: the same as arrays in the case.
//! - [`damping`]: `[damping]` of a body.
//! - [`reduction`]: `[reduction]`, which freedoms and modes are kept.
//! - `scope`: what the analyses need to know of the case.
//! - [`problem`]: what can be wrong with all of it, beyond types, units and ranges.

pub mod arrays;
pub mod body;
pub mod chamfer;
pub mod damping;
pub mod disc;
pub mod extent;
pub(crate) mod lists;
pub mod matrices;
pub mod orientation;
pub mod problem;
pub mod reduction;
pub(crate) mod scope;

use std::path::Path;

use crate::REGISTRY;
use crate::entries::{EntryMatrix, Scope};
use crate::parameters::{Parameter, Parameters};
use crate::structure::MODEL;
use crate::swept_keys::ParameterKeys;
use arrays::MatrixArrays;
use body::{BodyGeometry, BodySettings};
use damping::Damping;
use judder_keys::Settings;
use judder_keys::cause::Cause;
use judder_keys::declared::{Allowed, Setting, Settings, both};
use judder_keys::document::{Data, Node};
use judder_keys::error::Fault;
use judder_keys::file_reference::{FileReference, read_file_reference};
use judder_keys::problem::Placed;
use judder_keys::section::Section;
use judder_study::case::analysis::{Planned, read_analyses};
use judder_study::case::root::{document, read_root};
use judder_study::model::Analysis;
use matrices::MatrixSums;
use problem::StructureProblem;
use reduction::{FixedModes, KEPT, KeptFreedoms, ReductionSettings};
use scope::StructureScope;
use serde_json::Value as Json;
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
    pub reduction: Option<ReductionSettings>,
    /// The analyses in the order of the case file.
    pub analyses: Vec<Planned<Arc<dyn Analysis<StructureCase>>>>,
}

/// Where a structure comes from; the keys of a body stand beside those of whatever has it.
#[derive(Debug, Clone, Settings)]
#[settings(check = StructureSource::is_one)]
pub enum StructureSource {
    /// Elements with materials and supports.
    #[key(flatten)]
    Body(BodySettings),
    /// M, C and K: sums of files with factors, or arrays of numbers and expressions.
    Matrices(Matrices),
}

/// M, C and K that a case gives.
#[derive(Debug, Clone)]
pub enum Matrices {
    /// What another program assembled, in files.
    Files(MatrixSums),
    /// Arrays in the case itself.
    Arrays(MatrixArrays),
}

impl StructureCase {
    /// One structure of a case that has several, without a reduction.
    pub(crate) fn alone(
        title: &str,
        parameters: &[Parameter],
        source: &StructureSource,
        damping: Damping,
    ) -> Self {
        let (title, parameters, source) = (title.to_owned(), parameters.to_vec(), source.clone());
        Self { title, parameters, source, damping, reduction: None, analyses: Vec::new() }
    }

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
    /// Refuses a body beside matrices, and neither.
    fn is_one(section: &Section<'_>) -> Result<(), Fault> {
        if section.get("matrices").is_none() {
            if BodyGeometry::KEYS.iter().any(|key| section.get(key).is_some()) {
                return Ok(());
            }
            let expected =
                "beam = { … }, block = { … }, disc = { … }, mesh = \"file.msh\" or matrices = { … }";
            return Err(section.missing("beam", expected));
        }
        for key in BodySettings::keys().into_iter().chain(["damping"]) {
            if let Some(node) = section.get(key) {
                let problem = Cause::Meaningless { key, with: section.path("matrices") };
                return Err(problem.at(node.place));
            }
        }
        Ok(())
    }

    /// Finds the files, which are relative to `folder`, and compiles factors and entries, which are expressions of the parameters; the
    /// keys of `section` are those of a body, or `matrices`.
    pub(crate) fn found(
        self,
        section: &Section<'_>,
        scope: &Scope<'_>,
        folder: &Path,
    ) -> Result<Self, Fault> {
        match (self, section.inner("matrices")?) {
            (Self::Body(body), _) => body.found(section, folder).map(Self::Body),
            (Self::Matrices(matrices), Some(own)) => matrices.found(&own, scope, folder).map(Self::Matrices),
            (Self::Matrices(matrices), None) => Ok(Self::Matrices(matrices)),
        }
    }

    /// The files that the source names.
    pub fn files(&self) -> Vec<&FileReference> {
        match self {
            Self::Body(body) => match &body.geometry {
                BodyGeometry::Mesh(file) => vec![file],
                BodyGeometry::Beam(_) | BodyGeometry::Block(_) | BodyGeometry::Disc(_) => Vec::new(),
            },
            Self::Matrices(Matrices::Files(sums)) => sums.files(),
            Self::Matrices(Matrices::Arrays(_)) => Vec::new(),
        }
    }
}

impl Setting for Matrices {
    type Rule = ();

    fn form((): &()) -> Allowed {
        Allowed::Either(vec![MatrixSums::form(&()), MatrixArrays::form()])
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, (): &()) -> Result<Self, Fault> {
        // files are tables, rows of arrays lists
        let is_array = |key: &str| match node.entry(key).map(|node| &node.data) {
            Some(Data::List(items)) => {
                !matches!(items.first(), Some(Node { data: Data::Table(_), .. }) | None)
            }
            _ => false,
        };
        match ["mass", "damping", "stiffness", "freedoms"].into_iter().any(is_array) {
            true => MatrixArrays::read(section, key, node).map(Self::Arrays),
            false => MatrixSums::read(section, key, node, &()).map(Self::Files),
        }
    }

    fn write(&self, (): &()) -> Json {
        match self {
            Self::Files(sums) => sums.write(&()),
            Self::Arrays(arrays) => arrays.written(),
        }
    }
}

impl Matrices {
    fn found(self, section: &Section<'_>, scope: &Scope<'_>, folder: &Path) -> Result<Self, Fault> {
        match self {
            Self::Files(sums) => sums.found(section, scope.names, folder).map(Self::Files),
            Self::Arrays(arrays) => arrays.found(section, scope).map(Self::Arrays),
        }
    }

    /// Whether a factor or an entry depends on the parameter at `index`.
    pub(crate) fn depends_on(&self, index: usize) -> bool {
        match self {
            Self::Files(sums) => {
                sums.sums().iter().flat_map(|(_, terms)| *terms).any(|term| term.factor.depends_on(index))
            }
            Self::Arrays(arrays) => arrays.matrices().iter().any(|matrix| matrix.depends_on(index)),
        }
    }

    /// Refuses factors and entries that are not finite where the parameters are `values`.
    pub(crate) fn check(&self, values: &[f64]) -> Result<(), Cause> {
        match self {
            Self::Files(sums) => sums.check(values),
            Self::Arrays(arrays) => {
                let mut entries = arrays.matrices().iter().flat_map(EntryMatrix::entries);
                entries.try_for_each(|entry| entry.evaluate(values).map(drop))
            }
        }
    }
}

/// What a case says beside its analyses.
#[derive(Debug, Settings)]
#[settings(title = "a structure case")]
pub(crate) struct StructureSections {
    /// Numbers that factors of matrices use and sweeps vary.
    parameters: Parameters,
    #[key(flatten)]
    source: SourceSections,
    /// The damping of a body; none where left out.
    #[key(omitted)]
    damping: Option<Damping>,
    /// What a reduction keeps.
    #[key(omitted)]
    reduction: Option<ReductionSection>,
}

/// Where a structure comes from, in sections.
#[derive(Debug, Settings)]
#[settings(check = SourceSections::is_given)]
enum SourceSections {
    /// A body of elements.
    Structure(BodySettings),
    /// M, C and K: sums of files with factors, or arrays of numbers and expressions.
    Matrices(Matrices),
}

/// `[reduction]`, which says what is kept.
#[derive(Debug, Settings)]
struct ReductionSection {
    /// Freedoms that are kept.
    #[key(rule = KEPT, example = "[{ set = \"end\" }], the freedoms that are kept")]
    kept: Vec<KeptFreedoms>,
    #[key(flatten)]
    modes: FixedModes,
}

impl SourceSections {
    /// Refuses none, and what has no meaning beside the one that is given.
    fn is_given(root: &Section<'_>) -> Result<(), Fault> {
        let refuse = |key: &'static str, beside: &str| match root.get(key) {
            Some(node) => Err(Cause::Meaningless { key, with: beside.to_owned() }.at(node.place)),
            None => Ok(()),
        };
        match (root.get("structure"), root.get("matrices")) {
            (Some(_), None) => refuse("parameters", "[structure]"),
            (None, Some(_)) => refuse("damping", "[matrices]"),
            (None, None) => Err(StructureProblem::NoStructure.at(root.place)),
            (Some(_), Some(_)) => Ok(()),
        }
    }

    /// The source, whose files are relative to `folder` and whose factors and entries are expressions of the parameters.
    fn found(self, root: &Section<'_>, scope: &Scope<'_>, folder: &Path) -> Result<StructureSource, Fault> {
        match (self, root.inner("structure")?) {
            (Self::Structure(body), Some(section)) => {
                StructureSource::Body(body).found(&section, scope, folder)
            }
            (Self::Structure(body), None) => Ok(StructureSource::Body(body)),
            (Self::Matrices(matrices), _) => StructureSource::Matrices(matrices).found(root, scope, folder),
        }
    }
}

/// The file under a key, which has one of these endings.
fn file_of_format(
    section: &Section<'_>,
    key: &str,
    folder: &Path,
    endings: &[&str],
) -> Result<FileReference, Fault> {
    let file = read_file_reference(section, key, folder)?;
    let ending = file.path.extension().map(|ending| ending.to_string_lossy().to_ascii_lowercase());
    if endings.iter().any(|known| known.strip_prefix('.') == ending.as_deref()) {
        return Ok(file);
    }
    let (place, key, known) = (section.place_of(&[key]), section.path(key), endings.join(", "));
    Err(StructureProblem::Format { key, path: file.path, known }.at(place))
}

/// Reads a structure case from the root of its tree; files are relative to `folder`.
pub(crate) fn read(node: &Node, folder: &Path) -> Result<StructureCase, Fault> {
    let (root, sections) = read_root::<StructureSections>(node)?;
    let case = sections.and_then(|(title, sections)| StructureCase::of(title, sections, &root, folder));
    let admitted = case.as_ref().map_or(Ok(()), |case| case.admit_reduction(&root));
    let scope = StructureScope {
        keys: ParameterKeys(Parameters::given(&root)),
        source: case.as_ref().ok().map(|case| case.source.clone()),
        values: case.as_ref().map(StructureCase::values).unwrap_or_default(),
        has_reduction: root.get("reduction").is_some(),
    };
    let analyses = read_analyses(&root, &scope, &super::KINDS, REGISTRY);
    let ((case, ()), analyses) = both(both(case, admitted), analyses)?;
    Ok(StructureCase { analyses, ..case })
}

impl StructureCase {
    /// The case of what was read, without its analyses; files are relative to `folder`.
    fn of(
        title: String,
        sections: StructureSections,
        root: &Section<'_>,
        folder: &Path,
    ) -> Result<Self, Fault> {
        let StructureSections { parameters, source, damping, reduction } = sections;
        let (names, values) = (parameters.names(), parameters.values());
        // which parameters analyses vary is not known yet: they judge entries
        let swept: Vec<usize> = (0..values.len()).collect();
        let scope = Scope { names: &names, values: &values, swept: &swept };
        let source = source.found(root, &scope, folder)?;
        let reduction = reduction.map(|ReductionSection { kept, modes }| ReductionSettings { kept, modes });
        let (parameters, damping) = (parameters.0, damping.unwrap_or_default());
        Ok(Self { title, parameters, source, damping, reduction, analyses: Vec::new() })
    }

    /// Refuses kept freedoms that the structure cannot have.
    fn admit_reduction(&self, root: &Section<'_>) -> Result<(), Fault> {
        match (&self.reduction, root.inner("reduction")?) {
            (Some(own), Some(section)) => own.admit(&section, &self.source),
            _ => Ok(()),
        }
    }

    /// The canonical form.
    pub(super) fn resolved(&self) -> Json {
        let mut json = document(MODEL.name, &self.title, &self.analyses, |kind, json| kind.write(json));
        match &self.source {
            StructureSource::Body(body) => {
                json.insert("structure".to_owned(), body.written(body.write(&())));
                json.insert("damping".to_owned(), self.damping.write(&()));
            }
            StructureSource::Matrices(matrices) => {
                json.insert("parameters".to_owned(), Parameters(self.parameters.clone()).write(&()));
                json.insert("matrices".to_owned(), matrices.write(&()));
            }
        }
        if let Some(kept) = &self.reduction {
            json.insert("reduction".to_owned(), kept.write(&()));
        }
        Json::Object(json)
    }
}
