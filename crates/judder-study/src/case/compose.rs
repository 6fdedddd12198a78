//! Cases composed of a text, options and one analysis: the case file that says by itself what text and options say together.

use serde_json::{Map, Value};
use std::iter::once;
use toml_edit::{ArrayOfTables, DocumentMut, Item, Table, Value as Toml, value};

use crate::case::anywhere::settle;
use crate::case::file::{CaseFile, given_error};
use crate::case::options::{syntax, with_options};
use crate::case::study_sweep::StudySweep;
use crate::case::study_sweep::quantity_path::{QuantityPath, QuantitySource};
use crate::registry::Registry;
use judder_keys::cause::Cause;
use judder_keys::edited::{self, table_of};
use judder_keys::error::{CaseError, Sources};

/// The case of `text` with the options `set`, and with `analysis` in the place of all its analyses and sweeps; `None` keeps them.
///
/// The text of the result holds it all, its comments and its order kept: read without options, it is the case of `text` with them.
/// `name` is what errors call the text, and files are relative to its folder, as of [`CaseFile::parse`]. The analysis is the JSON form of
/// a table `[[analysis]]`; a key that is `null` is left out.
///
/// # Errors
/// Those of [`CaseFile::parse`] with these options, at their places; of an analysis that cannot be, at its place in the composed text.
/// What is wrong with analyses and sweeps that are replaced is no error.
pub fn compose(
    registry: Registry,
    name: &str,
    text: &str,
    set: &[String],
    analysis: Option<&Map<String, Value>>,
) -> Result<CaseFile, CaseError> {
    let mut document = with_options(name, text, set)?;
    if let Some(analysis) = analysis {
        document.remove("sweep");
        let mut analyses = ArrayOfTables::new();
        analyses.push(table_of(analysis));
        document.insert("analysis", Item::ArrayOfTables(analyses));
    }
    CaseFile::parse(registry, name, &document.to_string(), &[]).map_err(|composed| {
        let replaced: &[&str] = if analysis.is_some() { &["analysis", "sweep"] } else { &[] };
        given_error(registry, name, text, set, replaced).unwrap_or(composed)
    })
}

/// The case of `file` with its options written into it and its files by their whole paths, and of its analyses and sweeps only `name` and
/// what `name` is made of: a spectrogram of its march and its locus, a sweep of the analyses whose results it keeps.
///
/// # Errors
/// [`Cause::UnknownName`] where the case has neither an analysis nor a sweep of this name.
pub fn alone(file: &CaseFile, name: &str) -> Result<CaseFile, CaseError> {
    let analyses = file.case.analysis_names();
    let sweeps: Vec<&str> = file.sweeps.iter().map(|sweep| sweep.name.as_str()).collect();
    if !sweeps.contains(&name) && !analyses.contains(&name) {
        let known = analyses.iter().chain(&sweeps).map(|name| (*name).to_owned()).collect();
        let cause = Cause::UnknownName { what: "analysis or sweep", name: name.to_owned(), known };
        return Err(CaseError::without_place(cause, &file.origin));
    }
    let taken = match file.sweeps.iter().find(|sweep| sweep.name == name) {
        Some(sweep) => taken_by_sweep(sweep, &analyses),
        None => vec![name],
    };
    let taken_up = taken.iter().flat_map(|name| file.case.takes_up(name));
    let needed: Vec<&str> = taken.iter().copied().chain(taken_up).chain([name]).collect();
    let only = |names: &[&str]| names.iter().map(|name| needed.contains(name)).collect::<Vec<_>>();
    let mut document = with_options(&file.origin, &file.text, &file.overrides)?;
    edited::keep(document.as_table_mut(), "sweep", &only(&sweeps));
    edited::keep(document.as_table_mut(), "analysis", &only(&analyses));
    settle(&mut document, file);
    CaseFile::parse(file.registry(), &file.origin, &document.to_string(), &[])
}

/// The case of `file` with its options written into it, its files by their whole paths and one more analysis, of this kind and with the keys of a text
/// in TOML; and the name of that analysis: its kind, with a number behind it where something of the case goes by that name.
///
/// # Errors
/// Those of the analysis, at their places in the composed text.
pub fn joined_by(file: &CaseFile, kind: &str, keys: &str) -> Result<(CaseFile, String), CaseError> {
    let own: DocumentMut =
        keys.parse().map_err(|error| Sources::new(kind, keys, &[]).error(syntax(&error)))?;
    let mut taken = file.case.analysis_names();
    taken.extend(file.sweeps.iter().map(|sweep| sweep.name.as_str()));
    let is_free = |name: &String| !taken.iter().any(|other| other.eq_ignore_ascii_case(name));
    let numbered = (2..).map(|number: u64| format!("{kind}-{number}"));
    let name = once(kind.to_owned()).chain(numbered).find(is_free).unwrap_or_default();
    let mut analysis = Table::new();
    analysis.decor_mut().set_prefix("\n");
    analysis.extend([("kind", value(kind)), ("name", value(&name))]);
    analysis.extend(own.as_table().clone());
    let mut document = with_options(&file.origin, &file.text, &file.overrides)?;
    match document.entry("analysis").or_insert(Item::ArrayOfTables(ArrayOfTables::new())) {
        Item::ArrayOfTables(analyses) => analyses.push(analysis),
        Item::Value(Toml::Array(analyses)) => analyses.push(analysis.into_inline_table()),
        // a case with anything else is none
        _ => (),
    }
    settle(&mut document, file);
    Ok((CaseFile::parse(file.registry(), &file.origin, &document.to_string(), &[])?, name))
}

/// The analyses whose results a sweep keeps; all of them where it sweeps a key of an analysis, which may go by its number.
fn taken_by_sweep<'a>(sweep: &'a StudySweep, analyses: &[&'a str]) -> Vec<&'a str> {
    if sweep.axes.iter().any(|axis| axis.path.starts_with("analysis.")) {
        return analyses.to_vec();
    }
    let source = |quantity: &'a QuantityPath| match &quantity.source {
        QuantitySource::Analysis { name, .. } => Some(name.as_str()),
        QuantitySource::Point { .. } => None,
    };
    sweep.quantities.iter().filter_map(source).collect()
}
