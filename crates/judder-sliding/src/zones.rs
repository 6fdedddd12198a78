//! Zones of a parameter in which the pair is unstable: start, end and peak by roots and extremes of the growth rate itself.
//!
//! No zone is left to the luck of a sample. Over each piece of the parameter's range on which the pair is smooth, the eigenvalues at
//! five even places are followed; of two that may meet between them, the mean m and d = ((s₁ − s₂)/2)² are smooth through the meeting,
//! however narrow the zone of flutter where s = m ± √d grows. The piece is halved until the samples foretell m and d at the places
//! between, and wherever the sign of the growth rate is in doubt at an extreme, down to a resolution that the caller gives.

mod meeting;
mod piece;
mod strip;

use crate::SlidingError;
use crate::characteristic::Characteristic;
use crate::tracking::continued;
use num_complex::Complex64;
use piece::{Search, Searched};
use rayon::prelude::*;
use std::f64::consts::TAU;
use strip::Strip;

/// A coupled pair for each value of a parameter: contact position, friction coefficient, load, an angle.
pub trait Family: Sync {
    /// The characteristic function of the pair at a value of the parameter.
    ///
    /// # Errors
    /// Whatever keeps the pair from being there.
    fn at(&self, parameter: f64) -> Result<Characteristic, SlidingError>;
}

impl<F: Fn(f64) -> Result<Characteristic, SlidingError> + Sync> Family for F {
    fn at(&self, parameter: f64) -> Result<Characteristic, SlidingError> {
        self(parameter)
    }
}

/// A range of the parameter in which one eigenvalue is unstable.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Zone {
    /// Where it starts: there the growth rate is zero, or the range of the search begins.
    pub from: f64,
    /// Where it ends, likewise.
    pub to: f64,
    /// Where the growth rate is largest.
    pub peak: f64,
    /// The growth rate there, 1/s.
    pub growth_rate: f64,
    /// The frequency there, Hz.
    pub frequency_hz: f64,
}

/// Eigenvalues at one value of the parameter.
#[derive(Debug, Clone, PartialEq)]
pub struct Sample {
    /// The parameter.
    pub at: f64,
    /// The lowest eigenvalues, by imaginary, then real part, 1/s; a few more than were counted.
    pub eigenvalues: Vec<Complex64>,
}

/// Zones, with the samples by which they were found.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Zones {
    /// By where they start, then by frequency.
    pub zones: Vec<Zone>,
    /// In the order of the parameter.
    pub samples: Vec<Sample>,
}

/// Zones whose eigenvalues differ by less than this share where two pieces meet are one.
const CONTINUED: f64 = 1e-3;

/// All unstable zones of the `count` lowest eigenvalues by frequency, over pieces that follow each other, each smooth within.
///
/// Every zone wider than `resolution` is found, narrower ones too wherever eigenvalues are smooth. Where nothing damps, a zone is where two
/// eigenvalues have merged; growth rates below 10⁻⁶ of the eigenvalue are then rounding. Pieces are searched side by side; the answer does
/// not depend on the number of threads.
///
/// # Errors
/// Those of the family; [`SlidingError::Incomplete`]; [`SlidingError::InvalidNumber`] for a resolution that is not positive, a piece that
/// ends before it starts, or a count that is zero or not less than the modes of the pair.
pub fn zones(
    family: &impl Family,
    pieces: &[[f64; 2]],
    count: usize,
    resolution: f64,
) -> Result<Zones, SlidingError> {
    let refuse = |name: &str, value: f64, requirement| {
        Err(SlidingError::InvalidNumber { name: name.to_owned(), value, requirement })
    };
    if !(resolution.is_finite() && resolution > 0.0) {
        return refuse("the resolution of unstable zones", resolution, "finite and above zero");
    }
    if let Some([_, to]) = pieces.iter().find(|[from, to]| !(to.is_finite() && to > from)) {
        return refuse("the end of a piece of the range", *to, "finite and above its start");
    }
    let searched: Vec<Result<Searched, SlidingError>> =
        pieces.par_iter().map(|piece| Search::over(family, count, *piece, resolution)).collect();
    let mut samples = Vec::new();
    let mut parts = Vec::new();
    for searched in searched {
        let searched = searched?;
        samples.extend(searched.samples);
        parts.extend(searched.strips);
    }
    let mut zones: Vec<Zone> = joined(parts).par_iter().map(|chain| located(family, chain)).collect();
    zones.sort_by(|a, b| a.from.total_cmp(&b.from).then(a.frequency_hz.total_cmp(&b.frequency_hz)));
    Ok(Zones { zones, samples })
}

/// Strips that continue each other from part to part, as chains.
fn joined(parts: Vec<Vec<Strip>>) -> Vec<Vec<Strip>> {
    let mut closed = Vec::new();
    let mut open: Vec<Vec<Strip>> = Vec::new();
    for part in parts {
        let (cut, fresh): (Vec<Strip>, Vec<Strip>) = part.into_iter().partition(|strip| strip.from.is_cut);
        let ends: Vec<Complex64> =
            open.iter().filter_map(|chain| chain.last()).map(|strip| strip.to.eigenvalue).collect();
        let starts: Vec<Complex64> = cut.iter().map(|strip| strip.from.eigenvalue).collect();
        let mut by_start: Vec<Option<Vec<Strip>>> = vec![None; cut.len()];
        for ((chain, end), start) in
            std::mem::take(&mut open).into_iter().zip(&ends).zip(continued(&ends, &starts))
        {
            match start {
                Some(start) if (starts[start] - end).norm() <= CONTINUED * end.norm() => {
                    by_start[start] = Some(chain);
                }
                _ => closed.push(chain),
            }
        }
        let continued = by_start.into_iter().zip(cut).map(|(chain, strip)| {
            let mut chain = chain.unwrap_or_default();
            chain.push(strip);
            chain
        });
        for chain in continued.chain(fresh.into_iter().map(|strip| vec![strip])) {
            if chain.last().is_some_and(|strip| strip.to.is_cut) {
                open.push(chain);
            } else {
                closed.push(chain);
            }
        }
    }
    closed.extend(open);
    closed
}

/// The zone of a chain, with its peak.
fn located(family: &impl Family, chain: &[Strip]) -> Zone {
    let best =
        (1..chain.len()).fold(0, |best, k| if chain[k].peak.1 > chain[best].peak.1 { k } else { best });
    let (peak, eigenvalue) = strip::peak(family, &chain[best]);
    Zone {
        from: chain[0].from.at,
        to: chain[chain.len() - 1].to.at,
        peak,
        growth_rate: eigenvalue.re,
        frequency_hz: eigenvalue.im / TAU,
    }
}
