//! The laws by name, and the computed ones.
//!
//! - [`collapsed`]: a law that is one curve: a paraboloid's.
//! - [`table`]: a law on a plane of speed and depth.
//! - [`limits`], [`material`], [`origin`]: what is known exactly about both, and what they were computed for.
//! - [`data`], [`knots`], [`quantities`]: their axes and values.
//! - `differences`, `scatter`, `slow`: how far values and slopes may be off, and slow sliding, where theory knows more than contacts.
//! - [`sweep`]: both made from a contact solver, knot by knot, as fine as it takes.
//! - [`boundary_elements`]: the points of a sweep from the contact of steady sliding.
//! - [`sampled`]: a law through values that somebody gives.
//! - [`mod@file`]: all of them in a JSON file.

pub mod boundary_elements;
pub mod collapsed;
pub mod data;
mod differences;
mod error;
pub mod file;
pub mod knots;
pub mod limits;
pub mod material;
pub mod origin;
pub mod quantities;
pub mod sampled;
mod scaled;
mod scatter;
mod slow;
mod spline;
pub mod sweep;
pub mod table;

pub use collapsed::CollapsedLaw;
pub use data::LawData;
pub use error::{FailedPoint, LawError};
pub use knots::Knots;
pub use limits::{LawIndenter, LawLayer};
pub use material::{LawMaterial, LawTerm};
pub use origin::LawOrigin;
pub use quantities::{KnotValues, LawErrors, PerQuantity};
pub use sampled::{LawSamples, SampledLaw};
pub use table::TabulatedLaw;

use crate::contact_law::{ContactLaw, ValidityConcern};
use crate::fitted::FittedLaw;
use crate::hertz::HertzLaw;
use crate::response::{ContactResponse, LawPoint};
use std::f64::consts::PI;
use std::sync::Arc;

/// A contact law that a case can name.
#[derive(Debug, Clone, PartialEq)]
pub enum Law {
    /// Eqs. (34)–(39) as printed or with the corrected velocity axis, or any other fit of that form.
    Fitted(FittedLaw),
    /// The elastic contact.
    Hertz(HertzLaw),
    /// A computed curve for a paraboloid.
    Collapsed(Arc<CollapsedLaw>),
    /// A computed table.
    Tabulated(Arc<TabulatedLaw>),
    /// Values that somebody gives.
    Sampled(Arc<SampledLaw>),
}

impl Law {
    /// Whether it is a formula, which is its own law: nothing in it is an error.
    #[must_use]
    pub fn is_formula(&self) -> bool {
        matches!(self, Self::Fitted(_) | Self::Hertz(_))
    }

    /// Whether anything is known of its errors: not of one with fewer than three knots along an axis.
    #[must_use]
    pub fn knows_its_errors(&self) -> bool {
        match self {
            Self::Fitted(_) | Self::Hertz(_) => true,
            Self::Collapsed(law) => law.knows_its_errors(),
            Self::Tabulated(law) => law.knows_its_errors(),
            Self::Sampled(law) => law.knows_its_errors(),
        }
    }

    /// The law for a length L/R across the sliding, where it is one per length: [`TabulatedLaw::over_length`].
    #[must_use]
    pub fn over_length(self, length: f64) -> Self {
        match self {
            Self::Tabulated(law) => Self::Tabulated(Arc::new(law.as_ref().clone().over_length(length))),
            other => other,
        }
    }

    /// a/R, half the length along the sliding of a contact of area Ã: the radius of a circle, or half the width of a line contact.
    #[must_use]
    pub fn half_length(&self, area: f64) -> f64 {
        match self {
            Self::Tabulated(law) => law.half_length(area),
            _ => (area / PI).sqrt(),
        }
    }

    /// What a computed law is made of; `None` for a law that is a formula or was given.
    #[must_use]
    pub fn data(&self) -> Option<&LawData> {
        match self {
            Self::Fitted(_) | Self::Hertz(_) | Self::Sampled(_) => None,
            Self::Collapsed(law) => Some(law.data()),
            Self::Tabulated(law) => Some(law.data()),
        }
    }
}

impl ContactLaw for Law {
    #[inline(always)]
    fn evaluate(&self, at: &LawPoint) -> ContactResponse {
        match self {
            Self::Fitted(law) => law.evaluate(at),
            Self::Hertz(law) => law.evaluate(at),
            Self::Collapsed(law) => law.evaluate(at),
            Self::Tabulated(law) => law.evaluate(at),
            Self::Sampled(law) => law.evaluate(at),
        }
    }

    fn doubt(&self, at: &LawPoint) -> Option<ContactResponse> {
        match self {
            Self::Fitted(law) => law.doubt(at),
            Self::Hertz(law) => law.doubt(at),
            Self::Collapsed(law) => law.doubt(at),
            Self::Tabulated(law) => law.doubt(at),
            Self::Sampled(law) => law.doubt(at),
        }
    }

    fn concern(&self, velocity: f64, indentation: f64) -> Option<ValidityConcern> {
        match self {
            Self::Fitted(law) => law.concern(velocity, indentation),
            Self::Hertz(law) => law.concern(velocity, indentation),
            Self::Collapsed(law) => law.concern(velocity, indentation),
            Self::Tabulated(law) => law.concern(velocity, indentation),
            Self::Sampled(law) => law.concern(velocity, indentation),
        }
    }
}
