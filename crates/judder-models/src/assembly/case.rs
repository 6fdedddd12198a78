//! The assembly case: bodies that touch at many points.
//!
//! - [`structure`]: `[[structure]]`, the bodies.
//! - [`contact`]: `[[contact]]`, who slides on what, and what presses and drags between them.
//! - [`asperity`]: of a contact that is a sphere on `[substrate]`.
//! - [`joint`]: `[[spring]]` and `[[tie]]`, what else joins bodies.
//! - [`rotation`]: `rotation` of a structure, a body that turns.
//! - [`load`]: `[[load]]`, forces, pressures, imposed displacements.
//! - `watched`: `[observe]`, points whose motion a march keeps.
//! - `named_list`: lists whose items keys call by their names.
//! - [`problem`]: what can be wrong with all of it, beyond types, units and ranges.

pub mod asperity;
pub mod contact;
pub mod joint;
pub mod load;
mod named_list;
pub mod normal_law;
pub mod problem;
pub mod rotation;
pub mod structure;
mod vector;
pub(crate) mod watched;

use super::spectrogram::settings::check_references;
use super::{KINDS, MODEL};
use crate::REGISTRY;
use crate::entries::Scope;
use crate::key_sweep::{KeySweep, KeySweepProblem, Origin};
use crate::oscillator::case::OscillatorCase;
use crate::parameters::{Parameter, Parameters};
use crate::substrate::{SubstrateKeys, refuse_conflicts};
use asperity::SphereSubstrate;
use contact::{ContactForceSettings, ContactInterface};
use joint::{SpringSettings, Tie};
use judder_keys::Settings;
use judder_keys::declared::{
    Declaration, EvaluatedTree, ExpressionScope, NumberExpression, Setting, Settings as _, Several, all, both,
};
use judder_keys::dimension::Dimension;
use judder_keys::document::{Data, Node, PARAMETERS};
use judder_keys::error::Fault;
use judder_keys::file_reference::FileReference;
use judder_keys::problem::Placed;
use judder_keys::quantity::WrittenUnit;
use judder_keys::schema::object;
use judder_keys::section::Section;
use judder_study::case::analysis::{Planned, read_analyses};
use judder_study::case::root::{document, read_root};
use judder_study::model::Analysis;
use load::Load;
use named_list::{NamedItem, NamedList, item_section};
use problem::AssemblyProblem;
use serde_json::{Value as Json, json};
use std::path::Path;
use std::sync::{Arc, LazyLock};
use structure::{AssemblyStructure, BodyReduction, ReducedBody};
use watched::{WatchedPoint, WatchedPoints};

/// A validated assembly case.
#[derive(Debug, Clone)]
pub struct AssemblyCase {
    /// The title; empty where the case gives none.
    pub title: String,
    /// The parameters in the order of the case file.
    pub parameters: Vec<Parameter>,
    /// What stands in the place of numbers.
    pub expressions: Vec<NumberExpression>,
    /// The bodies in the order of the case file.
    pub structures: Vec<AssemblyStructure>,
    /// Where they touch.
    pub contacts: Vec<ContactInterface>,
    /// Springs between them, or to the ground.
    pub springs: Vec<SpringSettings>,
    /// Where they are bonded.
    pub ties: Vec<Tie>,
    /// What acts on them.
    pub loads: Vec<Load>,
    /// Points whose motion a march keeps.
    pub watched: Vec<WatchedPoint>,
    /// What spheres slide on, where there are any.
    pub substrate: Option<SphereSubstrate>,
    /// The sphere of each contact that is one, as an oscillator case has it.
    pub spheres: Vec<Option<OscillatorCase>>,
    /// The analyses in the order of the case file.
    pub analyses: Vec<Planned<Arc<dyn Analysis<AssemblyCase>>>>,
    /// What the case was read from, to read it anew with another value.
    origin: Arc<Origin>,
}

/// What a case says beside its analyses.
#[derive(Debug, Settings)]
#[settings(title = "an assembly case")]
pub(crate) struct AssemblySections {
    /// Numbers that expressions use and sweeps vary.
    parameters: Parameters,
    /// The bodies.
    #[key(example = "[[structure]], one table for each body")]
    structure: NamedList<AssemblyStructure>,
    /// Where they touch; nowhere where left out.
    #[key(default = NamedList(Vec::new()), example = "[[contact]], one table for each contact interface")]
    contact: NamedList<ContactInterface>,
    /// Springs with dampers between them, or to the ground.
    #[key(default = NamedList(Vec::new()), example = "[[spring]], one table for each spring")]
    spring: NamedList<SpringSettings>,
    /// Where they are bonded.
    #[key(default = NamedList(Vec::new()), example = "[[tie]], one table for each bond")]
    tie: NamedList<Tie>,
    /// What acts on them.
    #[key(rule = LOADS, default = Vec::new())]
    load: Vec<Load>,
    /// Points whose motion a march keeps; none where left out.
    observe: Option<WatchedPoints>,
    /// What the spheres of contacts slide on; its keys are those of an oscillator case.
    #[key(omitted)]
    substrate: Option<SubstrateKeys>,
}

/// The keys of a case: of all but the parameters themselves numbers may be expressions of these.
pub(super) fn declared() -> Vec<Declaration> {
    let own = |key: Declaration| if key.name == PARAMETERS { key } else { key.with_expressions() };
    AssemblySections::declarations().into_iter().map(own).collect()
}

/// The tree of a case with numbers in the place of expressions.
fn evaluated(root: &Node) -> Result<EvaluatedTree, Fault> {
    static KEYS: LazyLock<Vec<Declaration>> = LazyLock::new(declared);
    let given = |node: &Node| Parameters::read(&Section::of_case(root, "")?, PARAMETERS, node, &());
    let parameters = root.entry(PARAMETERS).map_or_else(|| Ok(Parameters::default()), given);
    let known = parameters.as_ref().map_or_else(|_| Parameters::default(), Parameters::clone);
    let (names, values) = (known.names(), known.values());
    let evaluated = ExpressionScope { names: &names, values: &values }.evaluated(root, &KEYS);
    match (parameters, evaluated) {
        // without expressions what is wrong with the parameters is told beside what is wrong with other keys
        (Err(_), Ok(own)) if own.expressions.is_empty() => Ok(own),
        (Err(fault), _) => Err(fault),
        (Ok(_), evaluated) => evaluated,
    }
}

const LOADS: Several<()> = Several { of: (), length: [0, usize::MAX] };

impl AssemblyCase {
    /// The values of all parameters, in their order.
    pub fn values(&self) -> Vec<f64> {
        self.parameters.iter().map(|parameter| parameter.value).collect()
    }

    /// Whether a body is reduced.
    pub(super) fn is_reduced(&self) -> bool {
        self.structures.iter().any(|structure| structure.reduction != BodyReduction::None)
    }

    /// The case with whole bodies.
    pub(super) fn whole(mut self) -> Self {
        for structure in &mut self.structures {
            structure.reduction = BodyReduction::None;
        }
        self
    }

    /// Whether freedoms of contacts are reduced.
    pub(super) fn has_interface_modes(&self) -> bool {
        let has = |own: &AssemblyStructure| {
            matches!(own.reduction, BodyReduction::Modes(ReducedBody { interface_modes: Some(_), .. }))
        };
        self.structures.iter().any(has)
    }

    /// The case with all freedoms of contacts kept.
    pub(super) fn with_interface_freedoms(mut self) -> Self {
        for structure in &mut self.structures {
            if let BodyReduction::Modes(reduced) = &mut structure.reduction {
                reduced.interface_modes = None;
            }
        }
        self
    }

    /// The files that the case names.
    pub fn files(&self) -> Vec<&FileReference> {
        let of_structures = self.structures.iter().flat_map(|structure| structure.source.files());
        let of_substrate = self.substrate.iter().flat_map(|own| own.substrate.file());
        let of_laws = self.spheres.iter().flatten().flat_map(|sphere| &sphere.law_file);
        let of_contacts = self.contacts.iter().flat_map(|own| own.forces.files());
        let of_analyses = self.analyses.iter().flat_map(|own| own.kind.files());
        of_structures.chain(of_contacts).chain(of_substrate).chain(of_laws).chain(of_analyses).collect()
    }

    /// The folder to which its files are relative.
    pub(super) fn folder(&self) -> &Path {
        &self.origin.folder
    }

    /// The case with swept keys at these values, in SI units, without analyses: read anew, so that every key can be swept.
    ///
    /// # Errors
    /// [`KeySweepProblem::SweptKey`] where the case has no such key, [`KeySweepProblem::SweptValue`] where there is no such case.
    pub fn at(&self, swept: &[(&KeySweep, f64)]) -> Result<Self, KeySweepProblem> {
        self.origin
            .at(swept, |root, folder| read_bodies(root, &evaluated(root)?, folder).and_then(|(_, case)| case))
    }

    /// A number that the case gives at a dotted path, in SI units, with its dimension.
    pub(super) fn number(&self, path: &str) -> Option<(f64, Dimension)> {
        self.origin.number(path)
    }

    /// The unit in which the case gives it.
    pub(super) fn unit(&self, path: &str) -> Option<WrittenUnit> {
        self.origin.unit(path)
    }

    /// The dotted paths of all numbers that the case gives, items of lists by their names.
    pub(super) fn numbers(&self) -> Vec<String> {
        self.origin.numbers()
    }

    /// The canonical form.
    pub(super) fn resolved(&self) -> Json {
        let mut json = document(MODEL.name, &self.title, &self.analyses, |kind, json| kind.write(json));
        json.extend(object([
            ("parameters", Parameters(self.parameters.clone()).write(&())),
            ("structure", self.structures.iter().map(NamedItem::written).collect()),
            ("contact", self.contacts.iter().map(NamedItem::written).collect()),
            ("load", self.loads.write(&LOADS)),
        ]));
        // without any the form is that of cases from before there were any
        if !self.expressions.is_empty() {
            let own = self.expressions.iter();
            let written = own.map(|own| json!({ "key": own.path, "expression": own.text, "unit": own.unit }));
            json.insert("expressions".to_owned(), written.collect());
        }
        let springs = self.springs.iter().map(NamedItem::written).collect::<Vec<_>>();
        let ties = self.ties.iter().map(NamedItem::written).collect::<Vec<_>>();
        if !self.watched.is_empty() {
            let observe = WatchedPoints { points: NamedList(self.watched.clone()) };
            json.insert("observe".to_owned(), observe.write(&()));
        }
        for (key, written) in [("spring", springs), ("tie", ties)] {
            if !written.is_empty() {
                json.insert(key.to_owned(), written.into());
            }
        }
        match &self.substrate {
            Some(own) => own.written(json),
            None => Json::Object(json),
        }
    }
}

/// Reads an assembly case from the root of its tree; files are relative to `folder`.
pub(crate) fn read(node: &Node, folder: &Path) -> Result<AssemblyCase, Fault> {
    let evaluated = evaluated(node)?;
    let (root, case) = read_bodies(node, &evaluated, folder)?;
    let analyses = read_analyses(&root, &case.as_ref().ok().cloned(), &KINDS, REGISTRY);
    let (case, analyses) = both(case, analyses)?;
    if let Some(Node { data: Data::List(nodes), .. }) = node.entry("analysis") {
        check_references(&analyses, nodes)?;
    }
    Ok(AssemblyCase { analyses, ..case })
}

/// A root, and everything but its analyses.
type ReadAssembly<'a> = (Section<'a>, Result<AssemblyCase, Fault>);

/// Everything but the analyses.
fn read_bodies<'a>(
    node: &Node,
    evaluated: &'a EvaluatedTree,
    folder: &Path,
) -> Result<ReadAssembly<'a>, Fault> {
    let EvaluatedTree { root, expressions } = evaluated;
    let origin = Origin::new(node, folder);
    let origin = if expressions.is_empty() { origin } else { origin.with_evaluated(root.clone()) };
    let (root, sections) = read_root::<AssemblySections>(root)?;
    let case = both(sections, refuse_conflicts(&root)).and_then(|((title, sections), ())| {
        let case = sections.found(title, &root, &Arc::new(origin))?;
        Ok(AssemblyCase { expressions: expressions.clone(), ..case })
    });
    Ok((root, case))
}

impl AssemblySections {
    /// The case of what was read, without its analyses.
    fn found(self, title: String, root: &Section<'_>, origin: &Arc<Origin>) -> Result<AssemblyCase, Fault> {
        let Self {
            parameters,
            structure,
            mut contact,
            mut spring,
            mut tie,
            mut load,
            mut observe,
            substrate,
        } = self;
        let folder = origin.folder.as_path();
        let substrate = substrate.map(|keys| SphereSubstrate::found(keys, root, folder)).transpose();
        let (names, values) = (parameters.names(), parameters.values());
        let scope = Scope { names: &names, values: &values, swept: &[] };
        let found = items(root, "structure")
            .zip(structure.0)
            .map(|(node, own)| own.found(&item_section::<AssemblyStructure>(node)?, &scope, folder));
        let structures = all(found)?;
        let contacts = items(root, "contact")
            .zip(&mut contact.0)
            .map(|(node, own)| own.admit(&item_section::<ContactInterface>(node)?, &structures, folder));
        let contacts = all(contacts);
        let springs = items(root, "spring")
            .zip(&mut spring.0)
            .map(|(node, own)| own.admit(&item_section::<SpringSettings>(node)?, &structures));
        let ties = items(root, "tie")
            .zip(&mut tie.0)
            .map(|(node, own)| own.admit(&item_section::<Tie>(node)?, &structures));
        let joints = both(all(springs), all(ties));
        let loads = items(root, "load")
            .zip(&mut load)
            .map(|(node, own)| own.admit(&Section::of_table(node, "load", "a load")?, &structures));
        let watched = match (&mut observe, root.inner("observe")?) {
            (Some(observe), Some(section)) => observe.admit(&section, &structures),
            _ => Ok(()),
        };
        let joints = both(joints, watched);
        let admitted =
            both(both(contacts, substrate), both(joints, all(loads))).and_then(|((_, substrate), _)| {
                let spheres = spheres(root, &mut contact.0, substrate.as_ref(), !load.is_empty(), folder)?;
                Ok((substrate, spheres))
            });
        let (substrate, spheres) = admitted?;
        let (contacts, springs, ties, loads) = (contact.0, spring.0, tie.0, load);
        let (parameters, expressions, analyses) = (parameters.0, Vec::new(), Vec::new());
        Ok(AssemblyCase {
            title,
            parameters,
            expressions,
            structures,
            contacts,
            springs,
            ties,
            loads,
            watched: observe.map_or_else(Vec::new, |own| own.points.0),
            substrate,
            spheres,
            analyses,
            origin: Arc::clone(origin),
        })
    }
}

/// The sphere of each contact that is one; refuses a substrate without any.
fn spheres(
    root: &Section<'_>,
    contacts: &mut [ContactInterface],
    substrate: Option<&SphereSubstrate>,
    has_loads: bool,
    folder: &Path,
) -> Result<Vec<Option<OscillatorCase>>, Fault> {
    let found = items(root, "contact").zip(contacts).map(|(node, own)| {
        let (section, name) = (item_section::<ContactInterface>(node)?, &own.name);
        match (&mut own.forces, section.inner("asperity")?) {
            (ContactForceSettings::Asperity(sphere), Some(section)) => {
                if sphere.normal_load.is_none() && !has_loads {
                    let contact = name.to_string();
                    return Err(AssemblyProblem::NothingPresses { contact }.at(section.place));
                }
                sphere.found(&section, substrate, root, folder).map(Some)
            }
            _ => Ok(None),
        }
    });
    let spheres = all(found)?;
    match root.get("substrate") {
        Some(node) if spheres.iter().all(Option::is_none) => Err(AssemblyProblem::NoSphere.at(node.place)),
        _ => Ok(spheres),
    }
}

/// The tables of a list of the case.
fn items<'a>(root: &Section<'a>, key: &str) -> impl Iterator<Item = &'a Node> + use<'a> {
    match root.get(key) {
        Some(Node { data: Data::List(nodes), .. }) => nodes.iter(),
        _ => [].iter(),
    }
}
