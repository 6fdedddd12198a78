//! What a pair is like at rest, at one value of a locus.

use judder_sliding::SlidingError;
use judder_sliding::coupling::SteadyFriction;
use judder_sliding::locus::{Conditions, Configuration};
use judder_sliding::pair::Pair;
use judder_sliding::statics::PairEquilibrium;
use serde::{Deserialize, Serialize};

/// What a pair is like at rest.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(super) struct RestState {
    /// N, N.
    pub(super) normal_force: f64,
    /// By how much the edge climbs at the contact, over the line from the track's first node to its last.
    pub(super) slope: f64,
}

impl RestState {
    pub(super) fn new(pair: &Pair, conditions: &Conditions, position: f64) -> Result<Self, SlidingError> {
        let Conditions { configuration, velocity, load, .. } = *conditions;
        let sliding = SteadyFriction::at(pair.friction(), velocity);
        let rest = match configuration {
            Configuration::Undeformed => PairEquilibrium::undeformed(pair, position, load, sliding)?,
            Configuration::Deformed => PairEquilibrium::new(pair, position, load, sliding)?,
        };
        let ([x, y], [along, up]) = (pair.direction(), rest.touch.tangent);
        let slope = (x * up - y * along) / (x * along + y * up);
        Ok(Self { normal_force: rest.normal_force, slope })
    }
}
