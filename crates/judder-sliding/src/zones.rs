//! Zones of a parameter in which the pair is unstable: start, end and peak by roots and extremes of the growth rate itself.
//!
//! No zone is left to the luck of a sample. Over each piece of the parameter's range on which the pair is smooth, the eigenvalues at
//! five even places are followed; of two that may meet between them, the mean m and d = ((s₁ − s₂)/2)² are smooth through the meeting,
//! however narrow the zone of flutter where s = m ± √d grows. The piece is halved until the samples foretell m and d at the places
//! between, and wherever the sign of the growth rate is in doubt at an extreme, down to a resolution that the caller gives. What is not smooth even then, or
//! leaves the eigenvalues that are counted while it grows, is followed by itself from eigenvalue to eigenvalue to where it turns stable.

mod branch;
mod follow;
mod highest;
mod meeting;
mod piece;
mod strip;

use crate::SlidingError;
use crate::characteristic::PairCharacteristic;
use crate::spectrum::Spectrum;
use crate::tracking::continued;
use branch::EigenvaluePath;
use follow::{is_on, onward};
use judder_numerics::complex::ElementaryComplex;
use judder_numerics::order::sort_by_numbers;
use judder_numerics::parallel;
use num_complex::Complex64;
use piece::PieceSearch;
use std::f64::consts::TAU;
use strip::Strip;

/// A coupled pair for each value of a parameter: contact position, friction coefficient, load, an angle.
pub trait PairFamily: Sync {
    /// The characteristic function of the pair at a value of the parameter.
    ///
    /// # Errors
    /// Whatever keeps the pair from being there.
    fn at(&self, parameter: f64) -> Result<PairCharacteristic, SlidingError>;

    /// Its `count` lowest eigenvalues there and a few more; for families that know them already.
    ///
    /// # Errors
    /// Those of [`at`](Self::at) and of [`Spectrum::with_more`].
    fn spectrum(&self, parameter: f64, count: usize) -> Result<Spectrum, SlidingError> {
        Spectrum::with_more(&self.at(parameter)?, parameter, count)
    }
}

impl<F: Fn(f64) -> Result<PairCharacteristic, SlidingError> + Sync> PairFamily for F {
    fn at(&self, parameter: f64) -> Result<PairCharacteristic, SlidingError> {
        self(parameter)
    }
}

/// A range of the parameter in which one eigenvalue is unstable.
#[derive(Debug, Clone, PartialEq)]
pub struct Zone {
    /// Where it starts, as `ends` has it.
    pub from: f64,
    /// Where it ends, likewise.
    pub to: f64,
    /// What start and end are.
    pub ends: [ZoneEnd; 2],
    /// Where the growth rate is largest.
    pub peak: f64,
    /// The growth rate there, 1/s.
    pub growth_rate: f64,
    /// The frequency there, Hz.
    pub frequency_hz: f64,
    /// How far the growth rate there may be off, 1/s; below it there is no zone.
    pub error: f64,
    /// The eigenvalue at places from its start to its end, the peak among them, in the order of the parameter.
    pub path: Vec<(f64, Complex64)>,
}

/// What the start or end of a zone is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ZoneEnd {
    /// The growth rate is zero there.
    Root,
    /// The range of the search ends there; the zone may go on beyond.
    Range,
    /// The pair is not smooth there, as at a node of an edge or of a table of friction: the growth rate jumps.
    Jump,
    /// Its eigenvalue meets its mirror image on the real axis: an oscillation that grows turns into two divergences, or these into it.
    Meeting,
    /// The eigenvalue could not be followed any farther; the zone goes on beyond.
    Lost,
}

impl ZoneEnd {
    /// As tables have it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Root => "root",
            Self::Range => "range",
            Self::Jump => "jump",
            Self::Meeting => "meeting",
            Self::Lost => "lost",
        }
    }
}

/// Eigenvalues at one value of the parameter.
#[derive(Debug, Clone, PartialEq)]
pub struct SpectrumSample {
    /// The parameter.
    pub at: f64,
    /// The lowest eigenvalues, 1/s, by the larger of imaginary and absolute real part; a few more than were counted.
    pub eigenvalues: Vec<Complex64>,
    /// Up to where of that size they are all, 1/s.
    pub limit: f64,
}

/// Zones, with the samples by which they were found.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Zones {
    /// By where they start, then by frequency.
    pub zones: Vec<Zone>,
    /// In the order of the parameter.
    pub samples: Vec<SpectrumSample>,
}

impl Zone {
    /// Whether it is another by no more than rounding.
    fn is_same(&self, other: &Self) -> bool {
        let near = |a: f64, b: f64| (a - b).abs() <= ROUNDING * b.abs();
        near(self.from, other.from)
            && near(self.to, other.to)
            && near(self.frequency_hz, other.frequency_hz)
            && (self.growth_rate - other.growth_rate).abs() <= self.error + other.error
    }

    /// Its own eigenvalue at a value of the parameter, polished from where its path has it; as the path has it where it is not found so near.
    #[must_use]
    pub fn eigenvalue_at(&self, family: &dyn PairFamily, at: f64) -> Complex64 {
        let within = at.clamp(self.from, self.to);
        follow::on_path(family, &self.path, within)
            .or_else(|| follow::foretold(&self.path, within))
            .unwrap_or(Complex64::new(self.growth_rate, TAU * self.frequency_hz))
    }
}

/// Zones whose ends and frequencies differ by no more than this share are one.
const ROUNDING: f64 = 1e-9;
/// Zones whose eigenvalues differ by less than this share where two pieces meet are one.
const CONTINUED: f64 = 1e-3;

/// All unstable zones that the `count` lowest eigenvalues by frequency enter, over pieces that follow each other, each smooth within.
///
/// A zone is that of a branch: it goes on where the branch is not among the lowest any more, followed by itself to its root.
///
/// Every zone wider than `resolution` is found, narrower ones too wherever eigenvalues are smooth. Where nothing damps, a zone is where two
/// eigenvalues have merged; growth rates below 10⁻⁶ of the eigenvalue are then rounding. What grows no faster than its own error is
/// marginal, and no zone. Pieces are searched side by side; the answer does
/// not depend on the number of threads.
///
/// # Errors
/// Those of the family; [`SlidingError::Incomplete`]; [`SlidingError::InvalidNumber`] for a resolution that is not positive, a piece that
/// ends before it starts, or a count that is zero or not less than the modes of the pair.
pub fn zones(
    family: &dyn PairFamily,
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
    let searched = parallel::try_each(pieces, |piece| PieceSearch::over(family, count, *piece, resolution))?;
    let (mut samples, mut parts, mut seeds) = (Vec::new(), Vec::new(), Vec::new());
    for searched in searched {
        samples.extend(searched.samples);
        parts.extend(searched.strips);
        seeds.extend(searched.seeds);
    }
    let mut chains = joined(parts);
    chains.retain(|chain| chain.iter().any(|strip| strip.is_counted));
    let mut branches: Vec<ZoneBranch> =
        parallel::each(&chains, |chain| ZoneBranch::of_chain(family, pieces, chain));
    // those that are whole first: a torn one may be a part of them
    branches.sort_by_key(|branch| branch.ends.iter().filter(|end| **end == ZoneEnd::Lost).count());
    let mut kept: Vec<ZoneBranch> = Vec::new();
    for branch in branches {
        if !kept.iter().any(|other| is_on(family, &other.path, branch.origin.0, branch.origin.1)) {
            kept.push(branch);
        }
    }
    for seed in seeds {
        if !kept.iter().any(|other| is_on(family, &other.path, seed.0, seed.1)) {
            kept.push(ZoneBranch::of_seed(family, pieces, seed));
        }
    }
    let mut zones = parallel::try_each(&kept, |branch| branch.zone(family))?;
    zones.retain(|zone| zone.growth_rate > zone.error);
    sort_by_numbers(&mut zones, |own| [own.from, own.frequency_hz]);
    // beside an eigenvalue that is nearly the same a branch may have been found by both
    zones.dedup_by(|next, kept| next.is_same(kept));
    Ok(Zones { zones, samples })
}

/// An unstable branch from end to end.
struct ZoneBranch {
    path: EigenvaluePath,
    ends: [ZoneEnd; 2],
    /// A place by which it was found.
    origin: (f64, Complex64),
    peak: (f64, Complex64),
}

impl ZoneBranch {
    /// Of strips that continue each other, gone on with where a part ended and not the instability.
    fn of_chain(family: &dyn PairFamily, pieces: &[[f64; 2]], chain: &[Strip]) -> Self {
        let mut path: EigenvaluePath = chain.iter().flat_map(|strip| strip::path(family, strip)).collect();
        let best =
            (1..chain.len()).fold(0, |best, k| if chain[k].peak.1 > chain[best].peak.1 { k } else { best });
        let origin = path[path.len() / 2];
        let located = strip::peak(family, &chain[best]).unwrap_or(origin);
        let cut = [chain[0].from.is_cut, chain[chain.len() - 1].to.is_cut];
        let ends = extended(family, pieces, &mut path, cut);
        // beyond the strips it may grow faster
        let highest = path.iter().fold(f64::NEG_INFINITY, |highest, point| highest.max(point.1.re));
        let peak = if highest > located.1.re { follow::peak(family, &path) } else { located };
        Self { path, ends, origin, peak }
    }

    /// Of one place at which an eigenvalue is unstable.
    fn of_seed(family: &dyn PairFamily, pieces: &[[f64; 2]], seed: (f64, Complex64)) -> Self {
        let mut path = vec![seed];
        let ends = extended(family, pieces, &mut path, [true; 2]);
        let peak = follow::peak(family, &path);
        Self { path, ends, origin: seed, peak }
    }

    fn zone(&self, family: &dyn PairFamily) -> Result<Zone, SlidingError> {
        let Self { ends, peak, .. } = *self;
        let mut path = self.path.clone();
        let error = family.at(peak.0)?.evaluator().error(peak.1);
        if let Err(place) = path.binary_search_by(|point| point.0.total_cmp(&peak.0)) {
            path.insert(place, peak);
        }
        Ok(Zone {
            from: path[0].0,
            to: path[path.len() - 1].0,
            ends,
            peak: peak.0,
            growth_rate: peak.1.re,
            frequency_hz: peak.1.im / TAU,
            error,
            path,
        })
    }
}

/// Goes on with a path at the ends that are cut; what its ends then are.
fn extended(
    family: &dyn PairFamily,
    pieces: &[[f64; 2]],
    path: &mut EigenvaluePath,
    cut: [bool; 2],
) -> [ZoneEnd; 2] {
    let mut ends = [ZoneEnd::Root; 2];
    if cut[0] {
        let (mut before, end) = onward(family, pieces, path[0], -1.0);
        before.reverse();
        before.extend(path.drain(1..));
        (*path, ends[0]) = (before, end);
    }
    if cut[1] {
        let (after, end) = onward(family, pieces, path[path.len() - 1], 1.0);
        path.extend(&after[1..]);
        ends[1] = end;
    }
    ends
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
                Some(start) if (starts[start] - end).modulus() <= CONTINUED * end.modulus() => {
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
