//! `asperity` of a contact: a sphere, or a cylinder, on the substrate of the case, with the keys of an oscillator case.

use super::problem::AssemblyProblem;
use crate::oscillator::case::{ContactSection, IndenterSection, OscillatorCase, check_terms};
use crate::oscillator::inputs::OscillatorInputs;
use crate::oscillator::keys::OscillatorKey;
use crate::substrate::blame::moduli_place;
use crate::substrate::{Substrate, SubstrateKeys};
use judder_keys::Settings;
use judder_keys::declared::Setting;
use judder_keys::error::Fault;
use judder_keys::keys::Keys;
use judder_keys::numeric_key::{Scaled, Value};
use judder_keys::problem::Placed;
use judder_keys::section::Section;
use serde_json::{Map, Value as Json};
use std::path::Path;

/// A sphere on the substrate of the case.
#[derive(Debug, Clone, Settings)]
pub struct AsperitySettings {
    #[key(flatten)]
    indenter: IndenterSection,
    #[key(flatten)]
    contact: ContactSection,
    /// Force that presses the sphere where the case has no loads; where it has, what they press with, from which it follows.
    #[key(rule = NORMAL_LOAD, symbol = "F_n", omitted)]
    pub normal_load: Option<Value>,
}

const NORMAL_LOAD: Scaled = OscillatorKey::ALL[OscillatorKey::NormalLoad as usize].rule;

/// `[substrate]`, with its numbers.
#[derive(Debug, Clone)]
pub struct SphereSubstrate {
    /// What is said of it beside its numeric keys.
    pub substrate: Substrate,
    /// Its numeric keys; all others mean nothing.
    pub inputs: OscillatorInputs,
}

impl SphereSubstrate {
    /// That of what was read; files are relative to `folder`.
    pub(super) fn found(keys: SubstrateKeys, root: &Section<'_>, folder: &Path) -> Result<Self, Fault> {
        let mut inputs = OscillatorInputs::default();
        let substrate = keys.found(root, &mut inputs, folder)?;
        Ok(Self { substrate, inputs })
    }

    /// Puts it into a canonical form.
    pub(super) fn written(&self, mut json: Map<String, Json>) -> Json {
        json.insert("substrate".to_owned(), self.substrate.keys(&self.inputs).write(&()));
        self.substrate.written(json, self.inputs.time_form())
    }
}

impl AsperitySettings {
    /// The sphere as an oscillator case has it, without an oscillator; fills in the numbers that were left out.
    pub(super) fn found(
        &mut self,
        section: &Section<'_>,
        substrate: Option<&SphereSubstrate>,
        root: &Section<'_>,
        folder: &Path,
    ) -> Result<OscillatorCase, Fault> {
        let Some(SphereSubstrate { substrate, inputs }) = substrate else {
            return Err(AssemblyProblem::NoSubstrate { key: section.own_path().to_owned() }.at(section.place));
        };
        let mut case =
            OscillatorCase { substrate: substrate.clone(), inputs: *inputs, ..OscillatorCase::default() };
        self.contact.tell(&mut case, Some(section), folder)?;
        self.indenter.tell(&mut case, Some(section), root)?;
        if let Some(load) = self.normal_load {
            case.inputs.set(OscillatorKey::NormalLoad, load);
        }
        self.indenter = IndenterSection::of(&case);
        self.contact = ContactSection::of(&case);
        check_terms(&case).map_err(|cause| cause.at(moduli_place(root)))?;
        Ok(case)
    }
}
