//! What a part of a case says of itself when it is wrong.

pub(crate) mod words;

pub use words::Problem;

use crate::cause::Cause;
use crate::error::{Fault, Place};

impl<P: Problem> From<P> for Cause {
    fn from(problem: P) -> Self {
        Self::Problem(Box::new(problem))
    }
}

/// Problems at their places.
pub trait Placed {
    /// At this place of a case.
    fn at(self, place: Place) -> Fault;
}

impl<P: Problem> Placed for P {
    fn at(self, place: Place) -> Fault {
        Cause::from(self).at(place)
    }
}
