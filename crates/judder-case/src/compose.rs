//! Cases composed of a text, options and one analysis: the case file that says by itself what text and options say together.

use serde_json::{Map, Value};
use toml_edit::{ArrayOfTables, DocumentMut, Item};

use crate::case_file::{CaseFile, given_error, read_tree};
use crate::cause::Cause;
use crate::edited::{self, table_of};
use crate::error::{CaseError, Fault, Place, Sources};

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
    CaseFile::parse(name, &document.to_string(), &[]).map_err(|composed| {
        let replaced: &[&str] = if analysis.is_some() { &["analysis", "sweep"] } else { &[] };
        given_error((name, text, set), replaced).unwrap_or(composed)
    })
}

/// The contact case of an oscillator case with the options `set`: its substrate and its indenter, without analyses.
///
/// # Errors
/// Those of [`CaseFile::parse`] with these options; [`Cause::OtherModel`] of a case that is of no oscillator.
pub fn contact_case_of(name: &str, text: &str, set: &[String]) -> Result<CaseFile, CaseError> {
    const KEPT: [&str; 4] = ["title", "model", "substrate", "indenter"];
    let mut document = with_options(name, text, set)?;
    let model = document.get("model").and_then(Item::as_str).unwrap_or_default().to_owned();
    if model != "oscillator" {
        let cause = Cause::UnknownName { what: "model", name: model, known: vec!["oscillator".to_owned()] };
        return Err(CaseError::without_place(cause, name));
    }
    document.retain(|key, _| KEPT.contains(&key));
    let title = document.get("title").and_then(Item::as_str).map(|title| format!("{title}: its contact"));
    for (key, value) in [("title", title), ("model", Some("contact".to_owned()))] {
        if let Some(value) = value {
            edited::set(document.as_item_mut(), &[key], value.into());
        }
    }
    CaseFile::parse(name, &document.to_string(), &[]).map_err(|composed| {
        let dropped = ["contact", "oscillator", "operation", "analysis", "sweep"];
        given_error((name, text, set), &dropped).unwrap_or(composed)
    })
}

/// The case of `file` with its options written into it, and of its analyses and sweeps only `name` and what `name` is made of: a
/// spectrogram of its march and its locus, a sweep of every analysis.
///
/// # Errors
/// [`Cause::UnknownName`] where the case has neither an analysis nor a sweep of this name.
pub fn alone(file: &CaseFile, name: &str) -> Result<CaseFile, CaseError> {
    let analyses = file.case.analysis_names();
    let sweeps: Vec<&str> = file.sweeps.iter().map(|sweep| sweep.name.as_str()).collect();
    let is_sweep = sweeps.contains(&name);
    if !is_sweep && !analyses.contains(&name) {
        let known = analyses.iter().chain(&sweeps).map(|name| (*name).to_owned()).collect();
        let cause = Cause::UnknownName { what: "analysis or sweep", name: name.to_owned(), known };
        return Err(CaseError::without_place(cause, &file.origin));
    }
    let needed = [vec![name], file.case.made_of(name)].concat();
    let only = |names: &[&str]| names.iter().map(|name| needed.contains(name)).collect::<Vec<_>>();
    let mut document = with_options(&file.origin, &file.text, &file.overrides)?;
    edited::keep(document.as_table_mut(), "sweep", &only(&sweeps));
    if !is_sweep {
        edited::keep(document.as_table_mut(), "analysis", &only(&analyses));
    }
    CaseFile::parse(&file.origin, &document.to_string(), &[])
}

/// The text with the options written into it.
fn with_options(name: &str, text: &str, set: &[String]) -> Result<DocumentMut, CaseError> {
    let sources = Sources::new(name, text, set);
    // what cannot be set is refused by the tree, in the same words as ever
    read_tree(name, text, set).map_err(|fault| sources.error(fault))?;
    let mut document: DocumentMut = text.parse().map_err(|error| sources.error(syntax(&error)))?;
    for (index, option) in set.iter().enumerate() {
        edited::apply_option(document.as_item_mut(), index + 1, option)
            .map_err(|fault| sources.error(fault))?;
    }
    Ok(document)
}

fn syntax(error: &toml_edit::TomlError) -> Fault {
    let span = error.span().unwrap_or(0..0);
    let place = Place { source: 0, start: span.start, end: span.end };
    Cause::Syntax { message: error.message().to_owned() }.at(place)
}
