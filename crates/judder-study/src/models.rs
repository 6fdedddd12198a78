//! The models, a folder each, in it a folder an analysis. Here is the only list of them.

mod axis;
pub mod belt;
pub mod contact;
pub mod motion;
pub mod oscillator;
pub(crate) mod read_sweep;
pub mod sliding;
pub mod structure;
pub mod substrate;
pub mod sweep;
pub(crate) mod swept_keys;
pub mod two_degrees;

pub(crate) use axis::Axis;
pub use motion::MotionBlock;

use crate::case::analysis::{Kind, Picture};
use crate::case::file::{Case, CaseFile};
use crate::error::StudyError;
use crate::model::Place;
use judder_keys::document::Node;
use judder_keys::error::Fault;
use serde_json::Value as Json;
use std::path::Path;

/// A model: how its cases are read, and what they may say.
pub(crate) struct ModelKind {
    /// Its name in a case file.
    pub(crate) name: &'static str,
    /// Reads a case from the root of its tree; files are relative to the folder.
    pub(crate) read: fn(&Node, &Path) -> Result<Case, Fault>,
    /// The schema of a case.
    pub(crate) schema: fn() -> Json,
    /// What that names besides.
    pub(crate) definitions: fn() -> Vec<(String, Json)>,
    /// Its section of the book's reference.
    pub(crate) reference: fn() -> String,
    /// Its kinds of analyses, and how their results are drawn.
    pub(crate) kinds: fn() -> Vec<(&'static str, Option<&'static Picture>)>,
}

/// The models, in the order of the book.
pub(crate) static MODELS: [&ModelKind; 6] = [
    &oscillator::MODEL,
    &contact::MODEL,
    &belt::MODEL,
    &two_degrees::MODEL,
    &structure::MODEL,
    &sliding::MODEL,
];

/// The names of some kinds, and how their results are drawn.
fn drawn<S, T>(kinds: &'static [Kind<S, T>]) -> Vec<(&'static str, Option<&'static Picture>)> {
    kinds.iter().map(|kind| (kind.name, kind.picture.as_ref())).collect()
}

/// Every kind of analysis of any model, and how its results are drawn.
pub(crate) fn all_kinds() -> impl Iterator<Item = (&'static str, Option<&'static Picture>)> {
    MODELS.into_iter().flat_map(|model| (model.kinds)())
}

/// What stands at an axis of a quantity of operating points, by its name.
pub(crate) fn operating_label(name: &str) -> Option<&'static str> {
    oscillator::operating_points::QUANTITIES.iter().find(|own| own.name == name)?.label
}

/// What a run found wrong with an analysis, at its place in the case file where a key is to blame.
pub(crate) fn placed(error: StudyError, file: &CaseFile, index: usize) -> StudyError {
    let names = file.case.analysis_names();
    let Some(name) = names.get(index) else { return error };
    file.case.blamed(&error, Place { file, index, name }).map_or(error, StudyError::from)
}
