//! The models, a folder each, in it a folder an analysis. Here is the only list of them.
//!
//! In the order in which the data flows:
//!
//! - `swept_keys`, `read_sweep`, [`mod@sweep`]: what the analyses of a case vary. [`key_sweep`]: any number of a case, read anew at each value. `axis`, `labels`: how that is called. `swept_tables`: what tables along it have in common.
//! - [`substrate`], `spectrum_source`, [`material`], `indenter`: what substrate a case names, and the surface that presses.
//! - `measured_band`: the frequencies that sliding excites, against those of measured moduli. `known_substrate`: what is to be said of the
//!   substrate of an oscillator case.
//! - [`band`], [`bridge`]: from the keys of a case to the oscillator and its contact.
//! - [`computed_law`], [`law_cache`]: a law over speeds and depths; material and law of a case whose numbers move.
//! - `within_law`: what the errors of a contact law leave of results, in words.
//! - [`checks`]: every number doubted by another number.
//! - [`oscillator`], [`contact`], [`belt`], [`two_degrees`], [`structure`], [`sliding`], [`assembly`]: the models. [`motion`]: what oscillator and belt share. [`parameters`]:
//!   `[parameters]`. [`friction`]: the friction coefficient of all of them; `number_columns`: tables in files. `entries`, [`mass`]: matrices of numbers and expressions of them.
//! - `samples`: arrays of a march on their way into the study; [`mod@spectrogram`]: of any of them. `estimate`: what analyses would take. `written`: files of other programs, in memory.
//! - [`template`]: the commented cases of `judder new`.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod array_in_si;
pub mod assembly;
mod axis;
pub mod band;
pub mod belt;
pub mod bridge;
pub mod checks;
pub mod computed_law;
pub mod contact;
pub mod entries;
mod error;
mod estimate;
pub mod friction;
mod indenter;
pub mod key_sweep;
mod key_unit;
mod known_substrate;
mod labels;
pub mod law_cache;
mod made_once;
pub mod mass;
pub mod material;
mod measured_band;
mod measured_growth;
pub mod motion;
mod number_columns;
pub mod oscillator;
pub mod parameters;
mod read_family;
mod read_sweep;
mod samples;
pub mod sliding;
pub mod spectrogram;
mod spectrum_source;
pub mod structure;
pub mod substrate;
pub mod sweep;
mod swept_keys;
mod swept_tables;
pub mod template;
mod told_quantities;
pub mod two_degrees;
mod within_law;
mod written;
mod written_column;

pub use error::ModelError;
pub use oscillator::operating_points::arrays as point_arrays;
pub use oscillator::{key_plane, point, quasi_steady};
pub use sliding::{coupled_pair, shapes as sliding_shapes};

use judder_keys::declared::{Declaration, Listed};
use judder_keys::error::CaseError;
use judder_study::Registry;
use judder_study::case::analysis::KindEntry;
use judder_study::case::file::CaseFile;
use judder_study::case::{compose, keys, reference, schema};
use serde_json::{Map, Value};
use std::collections::BTreeSet;
use std::path::Path;
use std::sync::LazyLock;

/// The models, in the order of the book.
pub const REGISTRY: Registry = Registry::new(&[
    &oscillator::MODEL,
    &contact::MODEL,
    &belt::MODEL,
    &two_degrees::MODEL,
    &structure::MODEL,
    &sliding::MODEL,
    &assembly::MODEL,
]);

/// Reads and validates the case file at `path` with the options `--set key=value`.
///
/// # Errors
/// As of [`CaseFile::read`].
pub fn read(path: impl AsRef<Path>, overrides: &[String]) -> Result<CaseFile, CaseError> {
    CaseFile::read(REGISTRY, path, overrides)
}

/// Validates the text of a case file; `name`, a path or any word, is what errors call it.
///
/// # Errors
/// As of [`CaseFile::parse`].
pub fn parse(name: &str, text: &str, overrides: &[String]) -> Result<CaseFile, CaseError> {
    CaseFile::parse(REGISTRY, name, text, overrides)
}

/// The case file that a text, options and one analysis in the place of all say together.
///
/// # Errors
/// As of [`compose::compose`].
pub fn compose(
    name: &str,
    text: &str,
    set: &[String],
    analysis: Option<&Map<String, Value>>,
) -> Result<CaseFile, CaseError> {
    compose::compose(REGISTRY, name, text, set, analysis)
}

/// The JSON Schema of case files of all models.
#[must_use]
pub fn schema() -> Value {
    schema::schema(REGISTRY)
}

/// The kinds of analyses of the model of this name; none where there is no such model.
pub fn kinds_of(model: &str) -> impl Iterator<Item = KindEntry> {
    REGISTRY.kinds_of(model)
}

/// What cases of the model of this name say beside their analyses; nothing where there is no such model.
#[must_use]
pub fn declared_of(model: &str) -> Vec<Declaration> {
    let found = REGISTRY.models().iter().find(|own| own.name == model);
    found.map_or_else(Vec::new, |own| (own.declared)())
}

/// Every key of the cases of a model as data, as of [`keys::keys`].
#[must_use]
pub fn keys(model: &str) -> Option<Value> {
    keys::keys(REGISTRY, model)
}

/// Whether a dotted path is that of a number in a case of some model outside of its analyses, as of [`keys::number_paths`].
#[must_use]
pub fn is_number(path: &str) -> bool {
    static PATHS: LazyLock<BTreeSet<String>> = LazyLock::new(|| keys::number_paths(REGISTRY));
    PATHS.contains(path)
}

/// Keys of the cases of a model that take one of a few words, as of [`keys::worded`].
#[must_use]
pub fn worded(model: &str) -> Vec<Listed> {
    keys::worded(REGISTRY, model)
}

/// The reference page of the book, as Markdown.
#[must_use]
pub fn reference() -> String {
    reference::reference(REGISTRY, sweep::REFERENCE)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `JUDDER_GOLDEN=write` writes the page anew.
    #[test]
    fn the_golden_reference_of_the_book_is_this_one() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/src/case-files.md");
        if std::env::var("JUDDER_GOLDEN").is_ok_and(|mode| mode == "write") {
            std::fs::write(path, reference()).unwrap();
        }
        assert_eq!(
            std::fs::read_to_string(path).unwrap(),
            reference(),
            "run this test with JUDDER_GOLDEN=write"
        );
    }
}
