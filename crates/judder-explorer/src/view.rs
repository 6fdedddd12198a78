//! A request as a case file, and what a request may set.

use crate::limits::check_analysis;
use crate::refusal::RequestRefusal;
use crate::subject::ViewedCase;
use judder_models::oscillator::contact_case::contact_case_of;
use judder_models::{REGISTRY, compose, is_number, worded};
use judder_study::case::file::CaseFile;
use serde::Deserialize;
use serde_json::{Map, Value};

/// Options that one view sets, at most.
const MOST_OPTIONS: usize = 64;
/// The longest option, bytes.
const LONGEST_OPTION: usize = 256;
/// The longest name of a slot, bytes.
const LONGEST_SLOT: usize = 64;

/// What is looked at: the base case with these options, and this analysis in place of its own.
#[derive(Debug, Clone, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct View {
    /// `"key=value"`, as `--set` takes them.
    #[serde(default)]
    pub(crate) set: Vec<String>,
    /// A table of `[[analysis]]`.
    #[serde(default)]
    pub(crate) analysis: Option<Map<String, Value>>,
    /// Another model of the same substrate and indenter: `contact` of an oscillator case.
    #[serde(default)]
    pub(crate) model: Option<String>,
    /// The slot in which a newer request cancels this one.
    #[serde(default)]
    pub(crate) slot: Option<String>,
}

impl View {
    /// Refuses what a page has no business to set, before anything reads it: an option may give a number, a quantity or one of a few
    /// words, and nothing that could name a file.
    ///
    /// # Errors
    /// The first option that is not let in.
    pub(crate) fn check(&self) -> Result<(), RequestRefusal> {
        if self.set.len() > MOST_OPTIONS {
            let given = self.set.len();
            return Err(RequestRefusal::too_large(format!(
                "{given} options are set; at most {MOST_OPTIONS} may be"
            )));
        }
        if self.slot.as_ref().is_some_and(|slot| slot.len() > LONGEST_SLOT) {
            return Err(RequestRefusal::wrong(format!(
                "the name of the slot is longer than {LONGEST_SLOT} bytes"
            )));
        }
        self.set.iter().try_for_each(|option| check_option(option))?;
        self.analysis.as_ref().map_or(Ok(()), check_analysis)
    }

    /// The case file of the view: its text is what the page exports.
    ///
    /// # Errors
    /// What [`View::check`] refuses, and what `judder check` would.
    pub(crate) fn case(&self, subject: &ViewedCase) -> Result<CaseFile, RequestRefusal> {
        self.check()?;
        let base = subject.needed()?;
        let set = [&base.overrides[..], &self.set].concat();
        let analysis = self.analysis.as_ref();
        let file = match self.model.as_deref() {
            Some(model) if model != base.case.model() => {
                if model != "contact" {
                    return Err(RequestRefusal::wrong(format!(
                        "a view of model `{model}` is not made from this case; leave `model` out"
                    )));
                }
                let contact = contact_case_of(&base.origin, &base.text, &set)?;
                compose(&base.origin, &contact.text, &[], analysis)?
            }
            _ => compose(&base.origin, &base.text, &set, analysis)?,
        };
        let known = base.case.files();
        match file.case.files().iter().find(|file| known.iter().all(|known| known.path != file.path)) {
            None => Ok(file),
            Some(foreign) => Err(RequestRefusal::wrong(format!(
                "the case does not name the file `{}`; a page reads no other",
                foreign.given
            ))),
        }
    }
}

fn check_option(option: &str) -> Result<(), RequestRefusal> {
    if option.len() > LONGEST_OPTION {
        let shown = &option[..option.floor_char_boundary(40)];
        return Err(RequestRefusal::too_large(format!(
            "the option `{shown}…` has {} bytes; at most {LONGEST_OPTION} may be",
            option.len()
        )));
    }
    let Some((key, value)) = option.split_once('=') else {
        return Err(RequestRefusal::wrong(format!("`{option}` sets nothing; an option is `key=value`")));
    };
    let (key, value) = (key.trim(), value.trim().trim_matches(['"', '\'']));
    let is_number = is_number(key) || key.strip_prefix("parameters.").is_some_and(|name| !name.contains('.'));
    if is_number && !value.contains(['{', '[', '\n']) {
        return Ok(());
    }
    if is_number {
        return Err(RequestRefusal::wrong(format!("`{key}` takes a number or a quantity here")));
    }
    let of_any = REGISTRY.models().iter().flat_map(|model| worded(model.name));
    let words: Vec<&str> = of_any.filter(|own| own.path == key).flat_map(|own| own.words()).collect();
    if words.is_empty() {
        return Err(RequestRefusal::wrong(format!(
            "`{key}` cannot be set from the page; set it in the case file"
        )));
    }
    match words.contains(&value) {
        true => Ok(()),
        false => Err(RequestRefusal::wrong(format!("`{key}` takes one of these here; {}", words.join(", ")))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_and_words_are_let_in() {
        let allowed = [
            "operation.velocity=1e-3",
            "operation.velocity = 30 mm/s",
            "contact.law=hertz",
            "contact.law=\"bem\"",
            "contact.friction_load=contact-force",
            "parameters.mu=0.3",
        ];
        for option in allowed {
            assert!(check_option(option).is_ok(), "{option}");
        }
    }

    #[test]
    fn whatever_could_name_a_file_is_kept_out() {
        let refused = [
            "contact.law={ file = \"/etc/passwd\" }",
            "contact.law=/etc/passwd",
            "contact.law.file=/etc/passwd",
            "contact={ law = { file = \"/etc/passwd\" } }",
            "substrate.dma=/etc/passwd",
            "substrate={ dma = \"x\" }",
            "indenter.shape={ heights = \"/etc/passwd\" }",
            "structure.body.mesh=/etc/passwd",
            "matrices.folder=/",
            "operation.velocity={ a = 1 }",
            "operation.velocity=[1]",
            "operation.velocity=\"1\"\ncontact.law.file=\"x\"",
            "parameters.a.b=1",
            "model=structure",
            "operation.velocity",
            "",
        ];
        for option in refused {
            assert!(check_option(option).is_err(), "{option}");
        }
        assert!(check_option(&format!("operation.velocity={}", "1".repeat(300))).is_err());
        let view = View { set: vec!["operation.velocity=1".to_owned(); 65], ..View::default() };
        assert!(view.check().is_err());
    }
}
