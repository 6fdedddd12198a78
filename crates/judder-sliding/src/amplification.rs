//! What a zone of growth does to a vibration that passes through it.

use crate::SlidingError;
use crate::locus::{Conditions, Settings, locus, spectrum};
use crate::pair::Pair;
use crate::spectrum::Wanted;
use crate::zones::Zone;
use rayon::prelude::*;
use std::f64::consts::PI;

/// An unstable zone, and how far a vibration grows in it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Amplification {
    /// The zone, by positions in m.
    pub zone: Zone,
    /// ∫ max(σ, 0) dt while the contact passes the zone, nepers: ln of how much larger a vibration leaves it than it came.
    pub nepers: f64,
}

/// Points in a zone at which the growth rate is taken.
const POINTS: usize = 24;

/// The unstable zones of the `count` lowest branches between two positions in m, with the growth of a vibration that passes them at the
/// speed of the conditions: ∫ max(σ, 0) ds/|v|, as if the pair were frozen at every position.
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
    let found = locus(pair, &Settings { conditions: *conditions, count, positions })?;
    let of = |zone: &Zone| -> Result<Amplification, SlidingError> {
        let width = zone.to - zone.from;
        let step = PI / POINTS as f64;
        let terms = (0..POINTS).map(|k| {
            let angle = (k as f64 + 0.5) * step;
            let position = zone.from + 0.5 * width * (1.0 - angle.cos());
            Ok(growth_rate(pair, conditions, position, (zone, count))?.max(0.0)
                * 0.5
                * width
                * angle.sin()
                * step)
        });
        let sum = terms.sum::<Result<f64, SlidingError>>()?;
        Ok(Amplification { zone: *zone, nepers: sum / conditions.velocity.abs() })
    };
    found.followed.zones.par_iter().map(of).collect()
}

/// The largest growth rate at a position of an eigenvalue near the frequency of a zone.
fn growth_rate(
    pair: &Pair,
    conditions: &Conditions,
    position: f64,
    (zone, count): (&Zone, usize),
) -> Result<f64, SlidingError> {
    const NEAR: f64 = 0.05;
    let spectrum = spectrum(pair, conditions, position, Wanted::Lowest(count))?;
    let frequency = 2.0 * PI * zone.frequency_hz;
    let near = spectrum.eigenvalues.iter().filter(|value| (value.im - frequency).abs() <= NEAR * frequency);
    Ok(near.map(|value| value.re).fold(0.0, f64::max))
}
