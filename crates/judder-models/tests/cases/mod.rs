//! Case files from outside: what is read, what is refused and in which words.

mod any_text;
mod bad_analysis;
mod bad_assembly;
mod bad_assembly_motion;
mod bad_chamfer;
mod bad_contact;
mod bad_contacts;
mod bad_expressions;
mod bad_family;
mod bad_key;
mod bad_motion;
mod bad_probabilities;
mod bad_quantity;
mod bad_sliding;
mod bad_sliding_analysis;
mod bad_source;
mod bad_sphere;
mod bad_structure;
mod bad_study_sweep;
mod bad_sweep;
mod bad_swept_keys;
mod bad_turning;
mod bad_two_degrees;
mod compose;
mod contact;
mod declared;
mod editors;
mod many_faults;
mod motion;
mod oscillator;
mod sliding;
mod structure;
mod study_sweep;
mod two_degrees;

use judder_keys::error::CaseError;
use judder_keys::keys::Keys;
use judder_models::oscillator::keys::OscillatorKey;
use judder_study::case::file::CaseFile;
use judder_study::model::Case;
use miette::Diagnostic;

/// Checks that a case is refused with this message, place and help.
fn refused(text: &str, message: &str, place: &str, help: &str) {
    refused_with(text, &[], message, place, help);
}

/// Checks that a case with `--set` options is refused; a place in an option begins with `--set `.
fn refused_with(text: &str, overrides: &[&str], message: &str, place: &str, help: &str) {
    let error = parse(text, overrides).expect_err("the case must be refused");
    assert!(error.labels().is_some_and(|labels| labels.count() == 1), "one labelled place");
    assert!(error.source_code().is_some(), "the text to point into");
    let source = if error.source_name() == "--set" { "--set " } else { "" };
    let found = (error.to_string(), format!("{source}{}", error.place()), help_of(&error));
    assert_eq!(found, (message.to_owned(), place.to_owned(), help.to_owned()));
}

/// The help line, in which `KEYS` stands for the list of all numeric keys.
fn help_of(error: &CaseError) -> String {
    let keys = OscillatorKey::paths().join(", ");
    error.help().map(|help| help.to_string().replace(&keys, "KEYS")).unwrap_or_default()
}

/// Reads a case that must be valid.
fn with_file(text: &str) -> CaseFile {
    judder_models::parse("case.toml", text, &[])
        .unwrap_or_else(|error| panic!("{error}: {}", help_of(&error)))
}

fn parse(text: &str, overrides: &[&str]) -> Result<Case, CaseError> {
    let overrides: Vec<_> = overrides.iter().map(|option| (*option).to_owned()).collect();
    judder_models::parse("case.toml", text, &overrides).map(|file| file.case)
}
