//! The locus over positions of the contact.

use super::conditions::conditions;
use super::doubt::doubted;
use super::rest_state::RestState;
use super::traced::{Traced, TracedFamily, TracedRange, trace};
use crate::error::ModelError;
use crate::sliding::case::SlidingCase;
use crate::sliding::locus::settings::{LocusAnalysis, Positions};
use crate::sliding::system::ReducedPair;
use judder_sliding::SlidingError;
use judder_sliding::characteristic::PairCharacteristic;
use judder_sliding::locus::{Conditions, characteristic, contact, smooth_pieces};
use judder_sliding::pair::Pair;
use judder_study::Progress;
use judder_study::axis::SweptAxis;
use judder_study::case::scale::Spacing;
use judder_study::kept::KeptLines;
use judder_study::labels::SweptQuantity;
use judder_study::outcome::CheckRecord;

/// Zones are searched down to this share of a segment of the track.
const RESOLUTION: f64 = 1e-3;

/// The pair with its contact at any place.
struct Places<'a> {
    pair: &'a Pair,
    conditions: Conditions,
}

impl TracedFamily for Places<'_> {
    fn at(&self, position: f64) -> Result<PairCharacteristic, SlidingError> {
        characteristic(self.pair, &self.conditions, position)
    }

    fn state(&self, position: f64) -> Result<RestState, SlidingError> {
        RestState::new(self.pair, &self.conditions, position)
    }

    fn reason(&self, position: f64) -> Option<String> {
        contact(self.pair, &self.conditions, position).err().map(|error| error.to_string())
    }
}

pub(super) fn run(
    case: &SlidingCase,
    system: &ReducedPair,
    settings: &LocusAnalysis,
    positions: &Positions,
    way: (KeptLines<'_>, &dyn Progress),
) -> Result<(SweptAxis, Traced, Vec<CheckRecord>), ModelError> {
    let Positions { from, to, points } = *positions;
    let step = (to - from) / (points - 1) as f64;
    let mut values: Vec<f64> = (0..points).map(|k| from + step * k as f64).collect();
    values[points - 1] = to;
    let (pair, conditions) = (&system.pair, conditions(case, settings));
    for end in [from, to] {
        pair.edge_point(end)?;
    }
    let segment = pair.node_positions().last().copied().unwrap_or_default() / (pair.edge().nodes - 1) as f64;
    let pieces = |[from, to]: [f64; 2]| smooth_pieces(pair, &conditions, [from, to]);
    let range = TracedRange { values: &values, pieces: &pieces, resolution: RESOLUTION * segment };
    let family = Places { pair, conditions };
    let traced = trace(&family, &range, settings.count, way)?;
    let at = |position: f64| -> Result<_, SlidingError> {
        Ok((contact(pair, &conditions, position)?.0, pair.eigenvalues(), pair.damping()))
    };
    let checks = doubted(&at, &traced, settings, &values)?;
    let quantity = SweptQuantity {
        name: "position".to_owned(),
        label: "Contact position $s$ (m)".to_owned(),
        symbol: "$s$".to_owned(),
        unit: "m".to_owned(),
    };
    Ok((SweptAxis { quantity, values, scale: Spacing::Linear, shown: None }, traced, checks))
}
