//! What is to be said of the substrate of an oscillator case: it stays while the operating point moves.

use crate::error::ModelError;
use crate::material::Material;
use crate::measured_band::{MeasuredBand, excited_at};
use crate::oscillator::case::OscillatorCase;
use crate::oscillator::inputs::OscillatorInputs;
use crate::spectrum_source::temperature_warning;
use judder_contact::law::material::LawTerm;
use judder_oscillator::Contact;

/// The substrate of an oscillator case, as far as results speak of it.
#[derive(Debug, Clone)]
pub(crate) struct KnownSubstrate {
    /// Its terms, as a law knows them; none of an elastic one.
    pub(crate) terms: Vec<LawTerm>,
    /// Where its moduli were measured; `None` where they were not.
    pub(crate) band: Option<MeasuredBand>,
    /// What is to be said of the temperature of its measured moduli.
    pub(crate) temperature_warning: Option<String>,
}

impl KnownSubstrate {
    /// That of a case.
    ///
    /// # Errors
    /// Data that cannot be read or fitted.
    pub(crate) fn of(case: &OscillatorCase) -> Result<Self, ModelError> {
        Self::with_material(case, &Material::new(&case.substrate, &case.inputs)?)
    }

    /// That of a case whose material is known.
    ///
    /// # Errors
    /// Data that cannot be read.
    pub(crate) fn with_material(case: &OscillatorCase, material: &Material) -> Result<Self, ModelError> {
        Ok(Self {
            terms: material.of_law().terms,
            band: MeasuredBand::of(material),
            temperature_warning: temperature_warning(&case.substrate)?,
        })
    }

    /// That sliding at these operating points, to which the material was told, excites what was not measured, in words. A formula was not made
    /// from measurements.
    pub(crate) fn band_warning(
        &self,
        contact: &Contact,
        points: impl IntoIterator<Item = OscillatorInputs>,
    ) -> Option<String> {
        let band = self.band.filter(|_| !contact.law.is_formula())?;
        band.warning(points.into_iter().filter_map(|inputs| excited_at(contact, &inputs)))
    }
}
