//! The laws by name, and the computed ones.
//!
//! - [`collapsed`]: a law that is one curve: a paraboloid's.
//! - [`table`]: a law on a plane of speed and depth.
//! - [`limits`], [`material`], [`origin`]: what is known exactly about both, and what they were computed for.
//! - [`data`], [`knots`], [`quantities`]: their axes and values.
//! - `scatter`, `slow`: how far values and slopes may be off, and slow sliding, where theory knows more than contacts.
//! - [`sweep`]: both made from a contact solver, knot by knot, as fine as it takes.
//! - [`boundary_elements`]: the points of a sweep from the contact of steady sliding.
//! - [`sampled`]: a law through values that somebody gives.
//! - [`mod@file`]: all of them in a JSON file.

pub mod boundary_elements;
pub mod collapsed;
pub mod data;
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
pub use error::LawError;
use judder_numerics::words::plain;
pub use knots::Knots;
pub use limits::LawIndenter;
pub use material::{LawMaterial, LawTerm};
pub use origin::LawOrigin;
pub use quantities::{KnotValues, LawErrors, PerQuantity};
pub use sampled::{SampledLaw, Samples};
pub use table::TabulatedLaw;

use crate::fitted::FittedLaw;
use crate::hertz::HertzLaw;
use crate::response::{ContactPoint, ContactResponse};
use std::fmt;
use std::sync::Arc;

/// Normal force, contact area and viscoelastic friction as functions of speed and depth, with exact first derivatives.
pub trait ContactLaw: Sync {
    /// F̃_k, Ã, μ_visc and their derivatives at a point; finite for every finite point, limits at v̂ → 0 and ŷ → 0.
    fn evaluate(&self, at: &ContactPoint) -> ContactResponse;

    /// How far each number of [`evaluate`](Self::evaluate) may be from the contact that the law stands for, absolute: an estimate. Nothing for a formula,
    /// which is its own law; `None` where it is not known.
    fn doubt(&self, at: &ContactPoint) -> Option<ContactResponse>;

    /// What makes the law doubtful at v̂, ŷ; `None` inside its range of validity.
    fn concern(&self, velocity: f64, indentation: f64) -> Option<ValidityConcern>;
}

/// Why a law should not be trusted at a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ValidityConcern {
    /// The indentation is too large for a half-space and a shallow contact.
    TooDeep {
        /// ŷ at the point.
        indentation: f64,
        /// The largest ŷ of the range of validity.
        limit: f64,
    },
    /// The speed is in the tail of the fitted friction bell, which falls faster than the true friction.
    FrictionTail {
        /// v̂ at the point.
        velocity: f64,
        /// Distance from the centre of the bell in its widths.
        widths: f64,
        /// The largest such distance of the range of validity.
        limit: f64,
    },
    /// The speed is beyond a computed table, where the law goes to its exact limit by an assumed power.
    SpeedBeyondTable {
        /// v̂ at the point.
        velocity: f64,
        /// How far the law still is from what is known of its way to the limit, relative: more than its own error.
        distance: f64,
    },
    /// The point is beyond the values that a law was given.
    BeyondSamples {
        /// Speed or indentation, with its symbol.
        name: &'static str,
        /// Its value at the point.
        value: f64,
        /// The first value given.
        from: f64,
        /// The last value given.
        to: f64,
    },
}

impl fmt::Display for ValidityConcern {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooDeep { indentation, limit } => write!(
                f,
                "indentation y/R = {} is beyond {limit}, where the contact is no longer shallow",
                plain(*indentation)
            ),
            Self::FrictionTail { velocity, widths, limit } => write!(
                f,
                "speed v τ/R = {} is {widths:.1} widths from the peak of the fitted friction (trusted to {limit}): \
                 the Gaussian tail is far below the true friction, which falls only as v and 1/v",
                plain(*velocity)
            ),
            Self::SpeedBeyondTable { velocity, distance } => write!(
                f,
                "speed v τ/R = {} is beyond the computed table, still {:.2} % from what is known exactly: \
                 the way there is assumed",
                plain(*velocity),
                100.0 * distance
            ),
            Self::BeyondSamples { name, value, from, to } => write!(
                f,
                "{name} = {} is beyond the values that the law was given, from {} to {}: how it goes on is assumed",
                plain(*value),
                plain(*from),
                plain(*to)
            ),
        }
    }
}

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
    fn evaluate(&self, at: &ContactPoint) -> ContactResponse {
        match self {
            Self::Fitted(law) => law.evaluate(at),
            Self::Hertz(law) => law.evaluate(at),
            Self::Collapsed(law) => law.evaluate(at),
            Self::Tabulated(law) => law.evaluate(at),
            Self::Sampled(law) => law.evaluate(at),
        }
    }

    fn doubt(&self, at: &ContactPoint) -> Option<ContactResponse> {
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
