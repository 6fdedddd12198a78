//! What a zone of growth does to a vibration that passes through it.

use crate::SlidingError;
use crate::locus::{Conditions, LocusSettings, characteristic, locus};
use crate::pair::Pair;
use crate::zones::Zone;
use rayon::prelude::*;
use std::f64::consts::PI;

/// An unstable zone, and how far a vibration grows in it.
#[derive(Debug, Clone, PartialEq)]
pub struct Amplification {
    /// The zone, by positions in m.
    pub zone: Zone,
    /// ∫ max(σ, 0) dt while the contact passes the zone, nepers: ln of how much larger a vibration leaves it than it came.
    pub nepers: f64,
    /// How far that may be off, nepers: the error of the growth rate at its peak, all the way.
    pub error: f64,
}

/// Points in a zone at which the growth rate is taken.
const POINTS: usize = 24;

/// The unstable zones of the `count` lowest branches between two positions in m, with the growth of a vibration that passes them at the
/// speed of the conditions: ∫ max(σ, 0) ds/|v| of the zone's own eigenvalue, as if the pair were frozen at every position.
///
/// The growth rate vanishes at both ends of a zone, undamped as a root: the points lie as cosines, which both take.
///
/// # Errors
/// Those of [`locus`].
pub fn amplifications(
    pair: &Pair,
    conditions: &Conditions,
    path: [f64; 2],
    count: usize,
) -> Result<Vec<Amplification>, SlidingError> {
    let positions = vec![path[0].min(path[1]), path[0].max(path[1])];
    let found = locus(pair, &LocusSettings { conditions: *conditions, count, positions })?;
    let family = |position: f64| characteristic(pair, conditions, position);
    let of = |zone: Zone| {
        let width = zone.to - zone.from;
        let step = PI / POINTS as f64;
        let term = |k: usize| {
            let angle = (k as f64 + 0.5) * step;
            let position = zone.from + 0.5 * width * (1.0 - libm::cos(angle));
            // the width of its part of the zone: together they are the zone
            let part = width * libm::sin(angle) * libm::sin(0.5 * step);
            zone.eigenvalue_at(&family, position).re.max(0.0) * part
        };
        let speed = conditions.velocity.abs();
        let nepers = (0..POINTS).map(term).sum::<f64>() / speed;
        let error = zone.error * width / speed;
        Amplification { zone, nepers, error }
    };
    Ok(found.followed.zones.into_par_iter().map(of).collect())
}
