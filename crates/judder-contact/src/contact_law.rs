//! What every contact law answers: its values, their errors, and where it should not be trusted.

use crate::response::{ContactResponse, LawPoint};
use judder_numerics::words::plain;
use std::fmt;

/// Normal force, contact area and viscoelastic friction as functions of speed and depth, with exact first derivatives.
pub trait ContactLaw: Sync {
    /// F̃_k, Ã, μ_visc and their derivatives at a point; finite for every finite point, limits at v̂ → 0 and ŷ → 0.
    fn evaluate(&self, at: &LawPoint) -> ContactResponse;

    /// How far each number of [`evaluate`](Self::evaluate) may be from the contact that the law stands for, absolute: an estimate. Nothing for a formula,
    /// which is its own law; `None` where it is not known.
    fn doubt(&self, at: &LawPoint) -> Option<ContactResponse>;

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
    /// The indentation is less than that of any computed contact of a cylinder.
    TooShallow {
        /// ŷ at the point.
        indentation: f64,
        /// The smallest ŷ of the table.
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
            Self::TooShallow { indentation, limit } => write!(
                f,
                "indentation y/R = {} is below {}, where the computed table begins: how it goes on is assumed",
                plain(*indentation),
                plain(*limit)
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
