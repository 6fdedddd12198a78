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
use crate::model::{Model, Place};

/// The model of a case.
pub(crate) fn model(case: &Case) -> &dyn Model {
    match case {
        Case::Oscillator(case) => case,
        Case::Contact(case) => case,
        Case::Belt(case) => case,
        Case::TwoDegrees(case) => case,
        Case::Structure(case) => case,
        Case::Sliding(case) => case,
    }
}

/// Every kind of analysis of any model, and how its results are drawn.
pub(crate) fn all_kinds() -> impl Iterator<Item = (&'static str, Option<&'static Picture>)> {
    fn of<S, T>(
        kinds: &'static [Kind<S, T>],
    ) -> impl Iterator<Item = (&'static str, Option<&'static Picture>)> {
        kinds.iter().map(|kind| (kind.name, kind.picture.as_ref()))
    }
    let oscillators =
        of(&oscillator::KINDS).chain(of(&belt::case::KINDS)).chain(of(&two_degrees::case::KINDS));
    oscillators.chain(of(&contact::KINDS)).chain(of(&structure::KINDS)).chain(of(&sliding::KINDS))
}

/// What stands at an axis of a quantity of operating points, by its name.
pub(crate) fn operating_label(name: &str) -> Option<&'static str> {
    oscillator::operating_points::QUANTITIES.iter().find(|own| own.name == name)?.label
}

/// What a run found wrong with an analysis, at its place in the case file where a key is to blame.
pub(crate) fn placed(error: StudyError, file: &CaseFile, index: usize) -> StudyError {
    let names = file.case.analysis_names();
    let Some(name) = names.get(index) else { return error };
    model(&file.case).blamed(&error, Place { file, index, name }).map_or(error, StudyError::from)
}
