//! One module a kind of answer.

pub(crate) mod analysis;
pub(crate) mod case;
pub(crate) mod export;
pub(crate) mod law;
pub(crate) mod map;
pub(crate) mod motion;
pub(crate) mod point;
pub(crate) mod session;
pub(crate) mod study;

use crate::refusal::RequestRefusal;
use judder_models::bridge;
use judder_models::contact::case::ContactCase;
use judder_models::oscillator::case::OscillatorCase;
use judder_models::oscillator::inputs::OscillatorInputs;
use judder_study::case::file::CaseFile;
use judder_study::model::Case;

/// The numeric keys of a case that has them, with what its material says: an oscillator, or a contact's substrate and indenter.
pub(crate) fn inputs(file: &CaseFile) -> Result<OscillatorInputs, RequestRefusal> {
    let with_material = match file.case.of::<ContactCase>() {
        Some(case) => {
            let substrate = case.substrate.clone();
            bridge::with_material(&OscillatorCase {
                inputs: case.inputs,
                substrate,
                ..OscillatorCase::default()
            })
        }
        None => bridge::with_material(oscillator(file)?),
    };
    Ok(with_material?.inputs)
}

/// The sections of numeric keys that a case has; none where its model has other keys.
pub(crate) fn sections(case: &Case) -> &'static [&'static str] {
    if case.of::<OscillatorCase>().is_some() {
        &["substrate", "indenter", "contact", "oscillator", "operation"]
    } else if case.of::<ContactCase>().is_some() {
        &["substrate", "indenter"]
    } else {
        &[]
    }
}

/// The oscillator of a case.
pub(crate) fn oscillator(file: &CaseFile) -> Result<&OscillatorCase, RequestRefusal> {
    file.case.of().ok_or_else(|| {
        RequestRefusal::wrong(format!(
            "this needs an oscillator case, the one explored is of model `{}`; `judder explore` without a case takes the paper's oscillator",
            file.case.model()
        ))
    })
}
