//! The sliding case: one structure slides along another, and the coupling moves with the contact point.
//!
//! - [`structure`]: `[[structure]]`, the two structures.
//! - [`contact`]: `[contact]`, who slides on what, and friction.
//! - [`motion`]: `[motion]`, path, velocity, load, and how they begin.
//! - [`observe`]: `[observe]`, points and signals.
//! - [`signals`]: what is kept of a march.
//! - [`plain_name`]: names of structures and points.
//! - [`problem`]: what can be wrong with all of it, beyond types, units and ranges.

pub mod contact;
pub mod motion;
pub mod observe;
pub mod plain_name;
pub mod problem;
pub mod signals;
pub mod structure;

use std::path::Path;
use std::sync::Arc;

use crate::REGISTRY;
use crate::entries::Scope;
use crate::key_sweep::{KeySweep, KeySweepProblem, Origin};
use crate::parameters::{Parameter, Parameters};
use crate::sliding::{KINDS, MODEL};
use contact::SlidingContact;
use judder_keys::Settings;
use judder_keys::declared::{Setting, both};
use judder_keys::document::Node;
use judder_keys::error::Fault;
use judder_keys::file_reference::FileReference;
use judder_keys::schema::object;
use judder_keys::section::Section;
use judder_study::case::analysis::{Planned, read_analyses};
use judder_study::case::root::{document, read_root};
use judder_study::model::Analysis;
use motion::SliderMotion;
use observe::{ObservedPoint, ObservedPoints};
use serde_json::Value as Json;
use structure::{SlidingStructure, Structures};

/// A validated sliding case.
#[derive(Debug, Clone)]
pub struct SlidingCase {
    /// The title; empty where the case gives none.
    pub title: String,
    /// The parameters in the order of the case file; only factors of matrices use them.
    pub parameters: Vec<Parameter>,
    /// The two structures in the order of the case file.
    pub structures: Box<[SlidingStructure; 2]>,
    /// Who slides on what.
    pub contact: SlidingContact,
    /// Where the slider goes, under which load.
    pub motion: SliderMotion,
    /// The points whose motion is kept.
    pub points: Vec<ObservedPoint>,
    /// The analyses in the order of the case file.
    pub analyses: Vec<Planned<Arc<dyn Analysis<SlidingCase>>>>,
    /// What the case was read from, to read it anew with another value.
    origin: Arc<Origin>,
}

impl SlidingCase {
    /// The structure that slides.
    pub fn slider(&self) -> &SlidingStructure {
        &self.structures[*self.contact.slider.structure]
    }

    /// The structure along which it slides.
    pub fn track(&self) -> &SlidingStructure {
        &self.structures[*self.contact.track.structure]
    }

    /// The values of all parameters, in their order.
    pub fn values(&self) -> Vec<f64> {
        self.parameters.iter().map(|parameter| parameter.value).collect()
    }

    /// The files that the case names.
    pub fn files(&self) -> Vec<&FileReference> {
        let of_structures = self.structures.iter().flat_map(|structure| structure.source.files());
        of_structures.chain(self.contact.friction.file()).collect()
    }

    /// The canonical form.
    pub(super) fn resolved(&self) -> Json {
        let mut json = document(MODEL.name, &self.title, &self.analyses, |kind, json| kind.write(json));
        json.extend(object([
            ("parameters", Parameters(self.parameters.clone()).write(&())),
            ("structure", self.structures.iter().map(SlidingStructure::written).collect()),
            ("contact", self.contact.write(&())),
            ("motion", self.motion.write(&())),
            ("observe", ObservedPoints { points: self.points.clone() }.write(&())),
        ]));
        Json::Object(json)
    }

    /// The case with a swept key at `value`, in SI units, without analyses: read anew, so that every key can be swept.
    ///
    /// # Errors
    /// [`KeySweepProblem::SweptKey`] where the case has no such key, [`KeySweepProblem::SweptValue`] where there is no such case.
    pub fn at(&self, sweep: &KeySweep, value: f64) -> Result<Self, KeySweepProblem> {
        self.origin.at(&[(sweep, value)], |root, folder| read_system(root, folder).and_then(|(_, case)| case))
    }
}

/// Reads a sliding case from the root of its tree; files are relative to `folder`. What its analyses name is not sought here.
pub(crate) fn read(node: &Node, folder: &Path) -> Result<SlidingCase, Fault> {
    let (root, case) = read_system(node, folder)?;
    let analyses = read_analyses(&root, &case.as_ref().ok().cloned(), &KINDS, REGISTRY);
    let (case, analyses) = both(case, analyses)?;
    Ok(SlidingCase { analyses, ..case })
}

/// What a case says beside its analyses.
#[derive(Debug, Settings)]
#[settings(title = "a sliding case")]
pub(crate) struct SlidingSections {
    /// Numbers that factors of matrices use and sweeps vary.
    parameters: Parameters,
    /// The two structures.
    #[key(example = "[[structure]], one table for each of the two structures")]
    structure: Structures,
    /// Who slides on what, and friction.
    #[key(example = "[contact] with slider = { … } and track = { … }")]
    contact: SlidingContact,
    /// Path, velocity and load of the slider.
    #[key(example = "[motion] with load = { set = \"start\" }")]
    motion: SliderMotion,
    /// Points whose motion is kept; none where left out.
    observe: Option<ObservedPoints>,
}

/// A root, and everything but its analyses.
type ReadSystem<'a> = (Section<'a>, Result<SlidingCase, Fault>);

/// Everything but the analyses.
fn read_system<'a>(node: &'a Node, folder: &Path) -> Result<ReadSystem<'a>, Fault> {
    let (root, sections) = read_root::<SlidingSections>(node)?;
    let origin = || Arc::new(Origin::new(node, folder));
    let case = sections.and_then(|(title, sections)| sections.found(title, &root, origin()));
    Ok((root, case))
}

impl SlidingSections {
    /// The case of what was read, without its analyses.
    fn found(self, title: String, root: &Section<'_>, origin: Arc<Origin>) -> Result<SlidingCase, Fault> {
        let Self { parameters, structure, mut contact, motion, mut observe } = self;
        let (names, values) = (parameters.names(), parameters.values());
        let scope = Scope { names: &names, values: &values, swept: &[] };
        let structures = structure.found(root, &scope, &origin.folder)?;
        let observed = match (&mut observe, root.inner("observe")?) {
            (Some(observe), Some(section)) => observe.admit(&section, &structures),
            _ => Ok(()),
        };
        let coupled = match (root.inner("contact")?, root.inner("motion")?) {
            (Some(of_contact), Some(of_motion)) => {
                let slides = contact.admit(&of_contact, &structures, &origin.folder);
                slides.and_then(|()| motion.admit(&of_motion, &structures[*contact.slider.structure]))
            }
            _ => Ok(()),
        };
        both(coupled, observed)?;
        let points = observe.map_or_else(Vec::new, |observe| observe.points);
        let (structures, parameters, analyses) = (Box::new(structures), parameters.0, Vec::new());
        Ok(SlidingCase { title, parameters, structures, contact, motion, points, analyses, origin })
    }
}
