//! What every computed law is made of.

use crate::law::knots::Knots;
use crate::law::origin::LawOrigin;
use crate::law::quantities::{KnotValues, LawErrors};

/// The numbers behind a computed law.
#[derive(Debug, Clone, PartialEq)]
pub struct LawData {
    pub(crate) origin: LawOrigin,
    pub(crate) speeds: Knots,
    pub(crate) values: KnotValues,
    pub(crate) errors: LawErrors,
}

impl LawData {
    /// What it was computed for.
    #[must_use]
    pub fn origin(&self) -> &LawOrigin {
        &self.origin
    }

    /// The knots of ln z.
    #[must_use]
    pub fn ln_speeds(&self) -> &Knots {
        &self.speeds
    }

    /// f, g, m at the knots, speed fastest.
    #[must_use]
    pub fn values(&self) -> &KnotValues {
        &self.values
    }

    /// Its errors, relative.
    #[must_use]
    pub fn errors(&self) -> &LawErrors {
        &self.errors
    }
}
