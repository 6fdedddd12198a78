//! The contacts of an oscillator case whose numbers move: material and law are found once, and stay while what they depend on does.

use crate::bridge::{self, CaseContact};
use crate::error::ModelError;
use crate::known_substrate::KnownSubstrate;
use crate::material::Material;
use crate::oscillator::case::OscillatorCase;
use crate::oscillator::keys::OscillatorKey;
use crate::oscillator::point::{self, AnalysedPoint};
use judder_contact::{ContactLaw, LawPoint};
use judder_numerics::parallel;
use judder_oscillator::Contact;
use judder_study::Progress;
use judder_study::input_file::KnownFile;
use std::sync::{Mutex, PoisonError};

/// Entries of a cache: a page, what was before, and as much again for another page.
const ENTRIES: usize = 4;

/// An oscillator case whose material and law are known.
#[derive(Debug, Clone)]
pub struct ReadyCase {
    /// The case, with the moduli and the time that its series, data and temperature say.
    pub case: OscillatorCase,
    /// Its contact.
    pub contact: CaseContact,
    /// What is to be said of its substrate.
    pub(crate) substrate: KnownSubstrate,
}

impl ReadyCase {
    /// The operating point of the case, as [`point::point`] gives it.
    ///
    /// # Errors
    /// A group out of range, no (or more than one) equilibrium.
    pub fn point(&self) -> Result<AnalysedPoint, ModelError> {
        let point = point::analyse(&self.contact.contact, bridge::groups(&self.case.inputs))?;
        Ok(point.in_contact(&self.case.inputs, &self.contact, &self.substrate))
    }
}

/// Materials and laws of the cases that were asked for last; for many threads.
#[derive(Debug, Default)]
pub struct LawCache(Mutex<Vec<CachedLaw>>);

#[derive(Debug, Clone)]
struct CachedLaw {
    key: String,
    /// The files that were read, as they were then.
    files: Vec<KnownFile>,
    /// `None` where the numeric keys of the case say all.
    material: Option<Material>,
    contact: CaseContact,
    substrate: KnownSubstrate,
}

impl LawCache {
    /// Without entries.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// A case with its material and its law. What was found before for the same substrate, law and accuracy is given at once, without
    /// reading a file, as long as the system tells of no change of the files that it was read from.
    ///
    /// # Errors
    /// As of [`bridge::with_material`] and [`bridge::contact_of`], [`ModelError::Interrupted`] among them.
    pub fn ready(&self, case: &OscillatorCase, progress: &dyn Progress) -> Result<ReadyCase, ModelError> {
        let key = key(case);
        let found = self.find(&key).filter(|entry| entry.files.iter().all(|file| file.check().is_ok()));
        let entry = match found {
            Some(entry) => entry,
            None => {
                let entry = CachedLaw::new(key, case, progress)?;
                self.keep(entry.clone());
                entry
            }
        };
        Ok(entry.of(case))
    }

    /// Whether the law of a case was found before, so that [`LawCache::ready`] has it at once.
    #[must_use]
    pub fn knows(&self, case: &OscillatorCase) -> bool {
        self.find(&key(case)).is_some()
    }

    fn find(&self, key: &str) -> Option<CachedLaw> {
        let mut entries = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let place = entries.iter().position(|entry| entry.key == key)?;
        // the last is the one that was asked for last
        entries[place..].rotate_left(1);
        entries.last().cloned()
    }

    fn keep(&self, entry: CachedLaw) {
        let mut entries = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        entries.retain(|other| other.key != entry.key);
        if entries.len() == ENTRIES {
            entries.remove(0);
        }
        entries.push(entry);
    }
}

impl CachedLaw {
    fn new(key: String, case: &OscillatorCase, progress: &dyn Progress) -> Result<Self, ModelError> {
        // looked at before they are read: a change in between is seen next time
        let files =
            case.files().into_iter().map(|file| KnownFile::new(&file.path)).collect::<Result<_, _>>()?;
        let found = Material::new(&case.substrate, &case.inputs)?;
        let substrate = KnownSubstrate::with_material(case, &found)?;
        let material = case.substrate.decided_by().map(|_| found);
        let told = told(case, material.as_ref());
        let contact = bridge::contact_of(&told, progress)?;
        Ok(Self { key, files, material, contact, substrate })
    }

    fn of(self, case: &OscillatorCase) -> ReadyCase {
        let Self { material, contact, substrate, .. } = self;
        ReadyCase { case: told(case, material.as_ref()), contact, substrate }
    }
}

/// The case with what its material says.
fn told(case: &OscillatorCase, material: Option<&Material>) -> OscillatorCase {
    let inputs = material.map_or(case.inputs, |material| material.told_to(&case.inputs));
    OscillatorCase { inputs, ..case.clone() }
}

/// All that material, law and what is to be said of them depend on, but for the content of files.
fn key(case: &OscillatorCase) -> String {
    let numbers =
        [OscillatorKey::RubberyModulus, OscillatorKey::GlassyModulus, OscillatorKey::RetardationTime]
            .map(|key| case.inputs.number(key));
    let OscillatorCase { law, law_file, law_accuracy, friction_load, substrate, length, .. } = case;
    let of_line = length.map(|length| {
        [OscillatorKey::Radius, OscillatorKey::PoissonRatio]
            .map(|key| case.inputs.number(key))
            .map(|n| (length, n))
    });
    format!("{substrate:?} {numbers:?} {law:?} {law_file:?} {law_accuracy:?} {friction_load:?} {of_line:?}")
}

/// A contact law over speeds and depths: each array has a row a depth, a column a speed.
#[derive(Debug, Clone, PartialEq)]
pub struct LawSurface {
    /// F_k/(E0* R²).
    pub force: Vec<f64>,
    /// A/R².
    pub area: Vec<f64>,
    /// μ_visc.
    pub friction: Vec<f64>,
}

/// The law of a contact at speeds v τ/R and depths y/R; NaN where one of them is negative or not finite.
/// Zeros stand for limits.
#[must_use]
pub fn law_surface(contact: &Contact, velocities: &[f64], indentations: &[f64]) -> LawSurface {
    let at = |indentation: f64, velocity: f64| {
        let can_be = |value: f64| value.is_finite() && value >= 0.0;
        if !(can_be(velocity) && can_be(indentation)) {
            return [f64::NAN; 3];
        }
        let response = contact.law.evaluate(&LawPoint::new(velocity, indentation));
        [response.force.value, response.area.value, response.friction.value]
    };
    let row = |y: &f64| velocities.iter().map(|v| at(*y, *v)).collect::<Vec<_>>();
    let rows: Vec<[f64; 3]> = parallel::each(indentations, row).concat();
    let column = |k: usize| rows.iter().map(|values| values[k]).collect();
    LawSurface { force: column(0), area: column(1), friction: column(2) }
}
