//! A rigid indenter on a viscoelastic substrate.
//!
//! - `size`, `fields`: how large grids will be; what lies on them.
//! - `blame`: which key is to blame for what an analysis found.
//! - `check`: what `judder check` shows.
//! - A folder each: `single` (kind `contact`), `law` (`contact-law`), `fit`, `modulus`, `transient`.

mod blame;
pub mod case;
mod check;
mod drawn_unit;
mod fields;
pub mod fit;
mod in_si;
pub mod law;
pub(crate) mod memory;
pub mod modulus;
pub mod problem;
pub mod settings;
pub mod shape;
pub mod single;
pub(crate) mod size;
mod tables;
pub mod transient;

use crate::contact::case::{ContactCase, ContactSections};
use crate::contact::settings::{ContactScope, LawMethod};
use crate::error::ModelError;
use crate::indenter::profile;
use crate::material::{self, ContactScales};
use crate::measured_band::MeasuredBand;
use crate::oscillator::inputs::OscillatorInputs;
use crate::oscillator::keys::OscillatorKey;
use crate::spectrum_source::temperature_warning;
use crate::substrate::RelaxationSource;
use check::ContactEstimate;
use judder_contact::material::Discretisation;
use judder_contact::steady::profile::Profile;
use judder_contact::unilateral::Loading;
use judder_keys::declared::Settings;
use judder_keys::file_reference::FileReference;
use judder_keys::keys::lines;
use judder_store::{Declared, Results};
use judder_study::StudyError;
use judder_study::case::analysis::{Kinds, Planned};
use judder_study::case::text::CaseText;
use judder_study::model::{Analysed, Analysis, Case, Model, Prepared, Refusal, Task, admit};
use judder_study::outcome::{CheckRecord, Outcome};
use judder_study::registry::{KindTables, ModelKind, Template};
use judder_study::resolve::Resolved;
use std::cell::OnceCell;
use std::rc::Rc;
use std::sync::Arc;

/// The kinds of analyses.
pub(crate) static KINDS: Kinds<Option<ContactScope>, Arc<dyn Exciting>> =
    Kinds::new(&[single::KIND, law::KIND, fit::KIND, modulus::KIND, transient::KIND]);

/// An analysis that excites the substrate.
pub trait Exciting: Analysis<ContactCase> {
    /// ω τ = v τ/a of what is asked, with a = √(R δ) of the depth that is asked or that an elastic contact has; of a periodic surface
    /// 2π v τ/λ of its longest and, where it is known, its shortest wave.
    ///
    /// # Errors
    /// An indenter that cannot be read.
    fn excited(&self, of: &ContactSubject<'_>) -> Result<Vec<f64>, ModelError>;
}

/// An indenter on a substrate, and the name of an analysis of them.
pub struct ContactSubject<'a> {
    case: &'a ContactCase,
    scales: &'a ContactScales,
    name: &'a str,
    profile: Rc<OnceCell<Box<dyn Profile>>>,
}

impl<'a> ContactSubject<'a> {
    fn new(case: &'a ContactCase, scales: &'a ContactScales, name: &'a str) -> Self {
        Self { case, scales, name, profile: Rc::default() }
    }

    /// Another analysis of the same surface.
    fn of(&self, name: &'a str) -> Self {
        Self { name, profile: Rc::clone(&self.profile), ..*self }
    }

    /// The surface that presses.
    fn profile(&self) -> Result<&dyn Profile, ModelError> {
        if let Some(profile) = self.profile.get() {
            return Ok(&**profile);
        }
        let made = profile(&self.case.shape, self.scales.scales.radius)?;
        Ok(&**self.profile.get_or_init(|| made))
    }

    /// Half the length of a contact that is pressed like this, were it elastic, over R.
    fn half_length(&self, pressed: Loading) -> Result<f64, ModelError> {
        let depth = match pressed {
            Loading::Indentation(depth) => depth,
            Loading::Load(force) => self.profile()?.elastic_depth(force),
        };
        Ok(depth.sqrt())
    }

    /// That an analysis excites what was not measured, in words.
    fn band_warning(&self, analysis: &dyn Exciting) -> Result<Option<String>, ModelError> {
        let Some(band) = MeasuredBand::of(&self.scales.material) else { return Ok(None) };
        Ok(band.warning(analysis.excited(self)?))
    }

    /// Refuses a depth at which the indenter has ended.
    fn is_not_too_deep(&self, indentation: f64) -> Result<Result<(), Refusal>, ModelError> {
        let thickness = self.case.substrate.thickness.map(|thickness| thickness / self.scales.scales.radius);
        Ok(blame::deep(indentation, self.profile()?.deepest(), thickness))
    }
}

impl Analysed for ContactCase {
    const NAME: &'static str = MODEL.name;
    const LIMITS: &'static [&'static str] = &["memory_limit"];

    type Asked = dyn Exciting;
    type Subject<'a> = ContactSubject<'a>;
    type Known<'a> = ContactSubject<'a>;
    type Estimate = ContactEstimate;
    type Error = ModelError;

    fn analyses(&self) -> &[Planned<Arc<Self::Asked>>] {
        &self.analyses
    }

    fn common_summary_keys(&self) -> Vec<Declared> {
        match self.substrate.source {
            RelaxationSource::Continuous(_) => ToldTerms::declared(),
            _ => Vec::new(),
        }
    }

    fn blame(error: &ModelError) -> Option<Refusal> {
        blame::blame(error)
    }
}

/// The model.
pub const MODEL: ModelKind = ModelKind {
    name: "contact",
    read: |root, folder| case::read(root, folder).map(Case::new),
    doc: "a rigid indenter that slides on a viscoelastic substrate",
    declared: ContactSections::declarations,
    swept: Vec::new,
    prose: include_str!("reference.md"),
    template: Template {
        name: "contact",
        text: include_str!("template.toml"),
        lines: |section| lines(section, |key: OscillatorKey| OscillatorInputs::default().number(key)),
    },
    kinds: || KINDS.entries(),
    operating_quantities: &[],
    tables: &[
        KindTables::new(single::KIND.name, tables::single),
        KindTables::new(transient::KIND.name, |told| transient::tables(told.results)),
        KindTables::new(law::KIND.name, tables::law),
        KindTables::new(fit::KIND.name, tables::fit),
        KindTables::new(modulus::KIND.name, tables::modulus),
    ],
};

impl Model for ContactCase {
    fn files(&self) -> Vec<&FileReference> {
        ContactCase::files(self)
    }

    fn resolved(&self) -> serde_json::Value {
        ContactCase::resolved(self)
    }

    fn with_used(&self, resolved: serde_json::Value) -> Result<serde_json::Value, StudyError> {
        Ok(material::with_used(&self.substrate, &self.inputs, resolved)?)
    }

    /// Looks at the files of the case, then at depth and memory of what is wanted.
    fn preflight(&self, file: &CaseText, is_wanted: &dyn Fn(&str) -> bool) -> Result<Prepared, StudyError> {
        let scales = ContactScales::new(self)?;
        let subject = ContactSubject::new(self, &scales, "");
        subject.profile()?;
        admit(self, file, is_wanted, |name| subject.of(name))?;
        Ok(Prepared::NOTHING)
    }

    fn run(&self, index: usize, task: Task<'_>) -> Result<Outcome, StudyError> {
        let own = &self.analyses[index];
        let scales = ContactScales::new(self)?;
        let subject = ContactSubject::new(self, &scales, &own.name);
        let mut outcome = own.kind.run(&subject, task)?;
        outcome.warnings.extend(temperature_warning(&self.substrate)?);
        outcome.warnings.extend(subject.band_warning(&*own.kind)?);
        if let Some(found) = &scales.material.discretisation {
            tell_discretisation(&mut outcome, found);
        }
        Ok(outcome)
    }

    fn resolve(&self, file: &CaseText, resolved: serde_json::Value) -> Result<Resolved, StudyError> {
        Ok(check::resolve(file, self, resolved)?)
    }
}

/// What the terms of a continuous spectrum may leave of its modulus.
const SPECTRUM_LIMIT: f64 = 1e-2;

/// Contacts that a law usually takes, for an estimate: how many it is depends on where they are needed.
pub(crate) fn usual_contacts(method: LawMethod) -> usize {
    match method {
        LawMethod::Collapse => 65,
        LawMethod::Sweep => 99,
    }
}

/// What is told of the terms that stand for a continuous spectrum.
#[derive(Results)]
struct ToldTerms {
    spectrum_terms: usize,
    #[result(unit = "1")]
    spectrum_error: f64,
}

/// Says how well the terms stand for a continuous spectrum.
fn tell_discretisation(outcome: &mut Outcome, found: &Discretisation) {
    let terms = found.spectrum.terms().len();
    outcome.scalars.extend(ToldTerms { spectrum_terms: terms, spectrum_error: found.error }.scalars());
    outcome.checks.push(CheckRecord::new(
        "the terms stand for the continuous spectrum",
        format!("E(ω) of {terms} retardation times against that of the spectrum, the largest relative error"),
        found.error.into(),
        SPECTRUM_LIMIT,
    ));
}
