//! The oscillator case: the paper's values, then whatever the case file says otherwise.

pub(crate) mod swept_keys;

use std::path::Path;

use crate::REGISTRY;
use crate::contact::case::line_key;
use crate::contact::problem::ContactProblem;
use crate::contact::settings::{ACCURACY, LAW_ACCURACY};
use crate::oscillator::inputs::{OscillatorInputs, TimeForm};
use crate::oscillator::keys::OscillatorKey;
use crate::oscillator::law_name::LawName;
use crate::oscillator::problem::OscillatorProblem;
use crate::oscillator::{KINDS, MODEL, Operated};
use crate::spectrum_source::FoundSpectrum;
use crate::substrate::blame::moduli_place;
use crate::substrate::{RelaxationSource, Substrate, SubstrateKeys, refuse_conflicts};
use judder_keys::cause::Cause;
use judder_keys::declared::{Allowed, Number, Setting, Settings, both};
use judder_keys::dimension::Dimension;
use judder_keys::document::{Data, Node};
use judder_keys::error::Fault;
use judder_keys::file_reference::{FileReference, read_file_reference};
use judder_keys::keys::Numbers;
use judder_keys::problem::Placed;
use judder_keys::section::{Section, word};
use judder_keys::{Choice, Settings};
use judder_oscillator::FrictionLoad;
use judder_study::case::analysis::{Planned, read_analyses};
use judder_study::case::root::{document, read_root};
use serde_json::{Value as Json, json};
use std::sync::Arc;
use swept_keys::OscillatorKeys;

/// A validated oscillator case.
#[derive(Debug, Clone)]
pub struct OscillatorCase {
    /// The title; empty where the case gives none.
    pub title: String,
    /// The contact law.
    pub law: LawName,
    /// The file of the law, for [`LawName::File`].
    pub law_file: Option<FileReference>,
    /// The relative accuracy of the law, for [`LawName::Bem`].
    pub law_accuracy: f64,
    /// The force that the viscoelastic friction coefficient multiplies.
    pub friction_load: FrictionLoad,
    /// The value of every numeric key at the operating point of the case.
    pub inputs: OscillatorInputs,
    /// What is said of the substrate beside its numeric keys.
    pub substrate: Substrate,
    /// L in m, across the sliding, of a cylinder on the layer that the substrate is then; a paraboloid has none.
    pub length: Option<f64>,
    /// The analyses in the order of the case file.
    pub analyses: Vec<Planned<Arc<dyn Operated>>>,
}

impl Default for OscillatorCase {
    /// The oscillator paper's values, without analyses.
    fn default() -> Self {
        Self {
            title: String::new(),
            law: LawName::OscillatorPaper,
            law_file: None,
            law_accuracy: LAW_ACCURACY,
            friction_load: FrictionLoad::NormalLoad,
            inputs: OscillatorInputs::default(),
            substrate: Substrate::default(),
            length: None,
            analyses: Vec::new(),
        }
    }
}

impl OscillatorCase {
    /// Whether the other has the same oscillator in the same contact, whatever its analyses are.
    pub(crate) fn is_like(&self, other: &Self) -> bool {
        let Self {
            title,
            inputs,
            law,
            law_file,
            law_accuracy,
            friction_load,
            substrate,
            length,
            analyses: _,
        } = self;
        let of_contact = (law, law_file, law_accuracy, friction_load);
        (title, inputs, substrate, length) == (&other.title, &other.inputs, &other.substrate, &other.length)
            && of_contact == (&other.law, &other.law_file, &other.law_accuracy, &other.friction_load)
    }

    /// How the relaxation of the substrate was given.
    pub fn time_form(&self) -> TimeForm {
        self.inputs.time_form()
    }

    /// The files that the case names.
    pub fn files(&self) -> Vec<&FileReference> {
        self.substrate.file().into_iter().chain(&self.law_file).collect()
    }
}

/// What a case says beside its analyses.
#[derive(Debug, Settings)]
#[settings(title = "an oscillator case")]
pub(crate) struct OscillatorSections {
    /// What the indenter slides on.
    #[key(default)]
    substrate: SubstrateKeys,
    /// What slides.
    #[key(default)]
    indenter: IndenterSection,
    /// The forces of the contact.
    #[key(default)]
    contact: ContactSection,
    /// What carries the indenter.
    #[key(rule = "oscillator")]
    oscillator: Numbers<OscillatorKey>,
    /// Speed and load.
    #[key(rule = "operation")]
    operation: Numbers<OscillatorKey>,
}

/// `[indenter]`; of an assembly what a contact says of it.
#[derive(Debug, Clone, Settings)]
pub(crate) struct IndenterSection {
    #[key(flatten, rule = "indenter")]
    numbers: Numbers<OscillatorKey>,
    /// Shape of the indenter, a paraboloid where left out; a cylinder takes `length`, the law `bem` and a `substrate.thickness`.
    #[key(omitted)]
    shape: Option<LawShape>,
    /// Length of a cylinder across the sliding.
    #[key(rule = Number::positive(Dimension::LENGTH), symbol = "L", omitted)]
    length: Option<f64>,
}

/// The shape of an indenter that has a law.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Choice)]
#[choice(what = "shape")]
pub(crate) enum LawShape {
    /// h = r²/2R.
    Paraboloid,
    /// h = x²/2R for all of its length: a line contact.
    Cylinder,
}

impl IndenterSection {
    /// Puts it into a case whose substrate and law are told; `section` is where it stands, `root` the whole case.
    pub(crate) fn tell(
        &self,
        case: &mut OscillatorCase,
        section: Option<&Section<'_>>,
        root: &Section<'_>,
    ) -> Result<(), Fault> {
        case.inputs.set_all(&self.numbers);
        let (Some(LawShape::Cylinder), Some(section)) = (self.shape, section) else {
            let shape = LawShape::Paraboloid.name();
            let length = match section.and_then(|section| section.get("length")) {
                Some(node) => Err(ContactProblem::LineKey { key: "length", shape }.at(node.place)),
                None => Ok(()),
            };
            return both(length, line_key(root, "substrate", "thickness", shape)).map(drop);
        };
        let refused = |problem: OscillatorProblem| Err(problem.at(section.place_of(&["shape"])));
        let layer = match case.substrate.thickness {
            Some(_) => Ok(()),
            None => refused(OscillatorProblem::LineOnHalfSpace),
        };
        let law = match case.law {
            LawName::Bem | LawName::File => Ok(()),
            law => refused(OscillatorProblem::LawOfLine { law }),
        };
        let length =
            self.length.ok_or_else(|| section.missing("length", "length = \"0.6 m\", across the sliding"));
        let (length, _) = both(length, both(layer, law))?;
        case.length = Some(length);
        Ok(())
    }

    /// The same as a case says it, every number filled in.
    pub(crate) fn of(case: &OscillatorCase) -> Self {
        let numbers = case.inputs.numbers("indenter", |_| true);
        Self { numbers, shape: case.length.map(|_| LawShape::Cylinder), length: case.length }
    }
}

/// `[contact]`; of an assembly what a contact says of a sphere.
#[derive(Debug, Clone, Settings)]
pub(crate) struct ContactSection {
    #[key(flatten, rule = "contact")]
    numbers: Numbers<OscillatorKey>,
    /// Contact law.
    #[key(default = GivenLaw::Word(LawName::OscillatorPaper))]
    law: GivenLaw,
    /// The force that μ_visc multiplies.
    #[key(default = FrictionLoad::NormalLoad)]
    friction_load: FrictionLoad,
}

/// A law as a case gives it.
#[derive(Debug, Clone)]
enum GivenLaw {
    /// By its name.
    Word(LawName),
    Table(LawTable),
}

/// A law that is a table.
#[derive(Debug, Clone, Settings)]
#[settings(check = LawTable::is_one)]
enum LawTable {
    /// A law that was computed earlier; a path relative to the case file.
    #[key(example = "\"…\", a path relative to the case file")]
    File(FileReference),
    Computed {
        /// The law `bem`.
        computed: bool,
        /// Its relative accuracy.
        #[key(rule = ACCURACY, symbol = "ε", default = LAW_ACCURACY)]
        accuracy: f64,
    },
}

impl LawTable {
    /// Refuses keys of both, an accuracy alone, and a law that is not computed.
    fn is_one(section: &Section<'_>) -> Result<(), Fault> {
        let refused = |key: &'static str, requirement: &'static str| match section.get(key) {
            Some(node) => {
                let table = section.own_path().to_owned();
                Err(OscillatorProblem::LawTable { table, key, requirement }.at(node.place))
            }
            None => Ok(()),
        };
        if section.get("computed").is_none() {
            return refused(
                "accuracy",
                "left out, or stand beside `computed = true`: a file has the accuracy that it has",
            );
        }
        if section.boolean("computed")? != Some(true) {
            return refused("computed", "true, or left out");
        }
        refused("file", "left out beside `computed = true`: a law is computed or read")
    }
}

impl Setting for GivenLaw {
    type Rule = ();

    fn form((): &()) -> Allowed {
        Allowed::Either(vec![Allowed::Choice { words: &LawName::WORDS }, LawTable::form(&())])
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, (): &()) -> Result<Self, Fault> {
        match node.data {
            Data::Table(_) => LawTable::read(section, key, node, &()).map(Self::Table),
            _ => word(&section.path(key), "contact law", node, &LawName::ALL).map(Self::Word),
        }
    }

    fn write(&self, (): &()) -> Json {
        match self {
            Self::Word(law) => json!(law.name()),
            Self::Table(table) => table.write(&()),
        }
    }
}

impl ContactSection {
    /// Puts it into a case; `section` is where it stands, its file is relative to `folder`.
    pub(crate) fn tell(
        &self,
        case: &mut OscillatorCase,
        section: Option<&Section<'_>>,
        folder: &Path,
    ) -> Result<(), Fault> {
        case.inputs.set_all(&self.numbers);
        case.friction_load = self.friction_load;
        match &self.law {
            GivenLaw::Word(law) => case.law = *law,
            GivenLaw::Table(LawTable::Computed { accuracy, .. }) => {
                (case.law, case.law_accuracy) = (LawName::Bem, *accuracy);
            }
            GivenLaw::Table(LawTable::File(_)) => case.law = LawName::File,
        }
        let table = match (case.law, section) {
            (LawName::File, Some(section)) => section.inner("law")?,
            _ => None,
        };
        case.law_file = table.map(|law| read_file_reference(&law, "file", folder)).transpose()?;
        Ok(())
    }

    /// The same as a case says it, every number filled in.
    pub(crate) fn of(case: &OscillatorCase) -> Self {
        let law = match (&case.law_file, case.law) {
            (Some(file), _) => GivenLaw::Table(LawTable::File(file.clone())),
            (None, LawName::Bem) => {
                GivenLaw::Table(LawTable::Computed { computed: true, accuracy: case.law_accuracy })
            }
            (None, word) => GivenLaw::Word(word),
        };
        let numbers = case.inputs.numbers("contact", |_| true);
        Self { numbers, law, friction_load: case.friction_load }
    }
}

impl OscillatorCase {
    /// The case of what was read; files are relative to `folder`.
    fn of(
        title: String,
        sections: OscillatorSections,
        root: &Section<'_>,
        folder: &Path,
    ) -> Result<Self, Fault> {
        let OscillatorSections { substrate, indenter, contact, oscillator, operation } = sections;
        let mut case = Self { title, ..Self::default() };
        let substrate = substrate.found(root, &mut case.inputs, folder);
        let contact = contact.tell(&mut case, root.inner("contact")?.as_ref(), folder);
        (case.substrate, ()) = both(substrate, contact)?;
        indenter.tell(&mut case, root.inner("indenter")?.as_ref(), root)?;
        for numbers in [&oscillator, &operation] {
            case.inputs.set_all(numbers);
        }
        check_terms(&case).map_err(|cause| cause.at(moduli_place(root)))?;
        Ok(case)
    }

    /// The same as a case says it, every number filled in.
    fn sections(&self) -> OscillatorSections {
        let numbers = |section| self.inputs.numbers(section, |_| true);
        OscillatorSections {
            substrate: self.substrate.keys(&self.inputs),
            indenter: IndenterSection::of(self),
            contact: ContactSection::of(self),
            oscillator: numbers("oscillator"),
            operation: numbers("operation"),
        }
    }

    /// The canonical form.
    pub(super) fn resolved(&self) -> Json {
        let mut json = document(MODEL.name, &self.title, &self.analyses, |kind, json| kind.write(json));
        self.sections().write_table(&mut json);
        self.substrate.written(json, self.inputs.time_form())
    }
}

/// Reads an oscillator case from the root of its tree; files are relative to `folder`.
pub(crate) fn read(node: &Node, folder: &Path) -> Result<OscillatorCase, Fault> {
    let (root, sections) = read_root::<OscillatorSections>(node)?;
    let case = both(sections, refuse_conflicts(&root))
        .and_then(|((title, sections), ())| OscillatorCase::of(title, sections, &root, folder));
    let keys = case.as_ref().map_or(OscillatorKeys::UNKNOWN, OscillatorKeys::of);
    let (mut case, analyses) = both(case, read_analyses(&root, &keys, &KINDS, REGISTRY))?;
    case.analyses = analyses;
    Ok(case)
}

/// Checks the moduli, and that a fitted law is asked about one retardation time alone.
pub(crate) fn check_terms(case: &OscillatorCase) -> Result<(), Cause> {
    let terms = match &case.substrate.source {
        RelaxationSource::OneTime => 1,
        RelaxationSource::Prony(terms) => terms.len(),
        RelaxationSource::Relaxation(terms) => terms.len(),
        RelaxationSource::Continuous(_) => 2,
        // measured data decide the moduli, and the number of terms; a fault of theirs is told where they are read
        RelaxationSource::Dma { .. }
            if case.law.is_fitted() && FoundSpectrum::of(&case.substrate, &case.inputs).is_ok() =>
        {
            2
        }
        RelaxationSource::Dma { .. } => return Ok(()),
    };
    if terms > 1 && case.law.is_fitted() {
        return Err(OscillatorProblem::SeveralTimes { law: case.law }.into());
    }
    case.inputs.check(case.law)
}
