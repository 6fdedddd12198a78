//! The locus over any key of the case, with the contact held.

use super::conditions::conditions;
use super::doubt::doubted;
use super::rest_state::RestState;
use super::traced::{Traced, TracedFamily, TracedRange, trace};
use crate::error::ModelError;
use crate::key_sweep::KeySweep;
use crate::sliding::case::SlidingCase;
use crate::sliding::locus::settings::LocusAnalysis;
use crate::sliding::system::{ReducedPair, Uncoupled};
use judder_sliding::SlidingError;
use judder_sliding::characteristic::PairCharacteristic;
use judder_sliding::locus::{Conditions, characteristic, contact};
use judder_sliding::pair::Pair;
use judder_study::Progress;
use judder_study::axis::SweptAxis;
use judder_study::kept::KeptLines;
use judder_study::outcome::CheckRecord;

/// Zones are searched down to this share of the swept range.
const RESOLUTION: f64 = 1e-5;
/// Pieces in which a range is searched at most, side by side.
const PIECES: usize = 16;

/// A case whose key takes any value.
struct Values<'a> {
    case: &'a SlidingCase,
    system: &'a ReducedPair,
    settings: &'a LocusAnalysis,
    sweep: &'a KeySweep,
    /// s, m.
    held: f64,
}

impl Values<'_> {
    /// The pair at a value, or why there is none.
    fn pair(&self, value: f64) -> Result<(Pair, Conditions), String> {
        let case = self.case.at(self.sweep, value).map_err(|problem| problem.to_string())?;
        let system =
            self.system.swept(&case, &[self.sweep.path.as_str()]).map_err(|uncoupled| match uncoupled {
                Uncoupled::Structure(unbuilt) => unbuilt.problem.to_string(),
                Uncoupled::Pair { problem, .. } => problem.to_string(),
                Uncoupled::Interrupted => ModelError::Interrupted.to_string(),
            })?;
        Ok((system.pair, conditions(&case, self.settings)))
    }

    fn known(&self, value: f64) -> Result<(Pair, Conditions), SlidingError> {
        self.pair(value).map_err(|_| SlidingError::InvalidNumber {
            name: format!("`{}`", self.sweep.path),
            value,
            requirement: "one at which there is a pair",
        })
    }
}

impl TracedFamily for Values<'_> {
    fn at(&self, value: f64) -> Result<PairCharacteristic, SlidingError> {
        let (pair, conditions) = self.known(value)?;
        characteristic(&pair, &conditions, self.held)
    }

    fn state(&self, value: f64) -> Result<RestState, SlidingError> {
        let (pair, conditions) = self.known(value)?;
        RestState::new(&pair, &conditions, self.held)
    }

    fn reason(&self, value: f64) -> Option<String> {
        match self.pair(value) {
            Err(reason) => Some(reason),
            Ok((pair, conditions)) => {
                contact(&pair, &conditions, self.held).err().map(|error| error.to_string())
            }
        }
    }
}

pub(super) fn run(
    case: &SlidingCase,
    system: &ReducedPair,
    settings: &LocusAnalysis,
    held: f64,
    sweep: &KeySweep,
    way: (KeptLines<'_>, &dyn Progress),
) -> Result<(SweptAxis, Traced, Vec<CheckRecord>), ModelError> {
    let falls = sweep.values.first() > sweep.values.last();
    let mut values = sweep.values.clone();
    if falls {
        values.reverse();
    }
    system.pair.edge_point(held)?;
    let pieces = |[from, to]: [f64; 2]| Ok(parts(&values, [from, to]));
    let span = values.last().copied().unwrap_or_default() - values.first().copied().unwrap_or_default();
    let range = TracedRange { values: &values, pieces: &pieces, resolution: RESOLUTION * span };
    let family = Values { case, system, settings, sweep, held };
    let mut traced = trace(&family, &range, settings.count, way)?;
    let at = |value: f64| -> Result<_, SlidingError> {
        let (pair, conditions) = family.known(value)?;
        Ok((contact(&pair, &conditions, held)?.0, pair.eigenvalues(), pair.damping()))
    };
    let checks = doubted(&at, &traced, settings, &values)?;
    if falls {
        traced.rows.reverse();
    }
    Ok((sweep.axis("value"), traced, checks))
}

/// The range from one value to another in a few parts, with ends among the values.
fn parts(values: &[f64], [from, to]: [f64; 2]) -> Vec<[f64; 2]> {
    let inner: Vec<f64> = values.iter().copied().filter(|value| *value >= from && *value <= to).collect();
    let intervals = inner.len().saturating_sub(1);
    let count = intervals.min(PIECES);
    (0..count).map(|k| [inner[k * intervals / count], inner[(k + 1) * intervals / count]]).collect()
}
