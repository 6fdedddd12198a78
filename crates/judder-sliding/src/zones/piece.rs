//! The search for unstable eigenvalues over a piece of a parameter's range, halved until its samples foretell what lies between them.

use super::branch::{PartBranch, TooCoarse};
use super::meeting::{EigenvalueGroup, SAMPLES, alone};
use super::strip::{Strip, strips};
use super::{PairFamily, SpectrumSample};
use crate::SlidingError;
use crate::spectrum::Spectrum;
use crate::tracking::{continued, reach};
use judder_numerics::complex::ElementaryComplex;
use judder_numerics::order::sort_by_number;
use num_complex::Complex64;

/// What a search over a piece leaves.
#[derive(Debug, Clone, Default)]
pub(super) struct SearchedPiece {
    /// Where spectra were taken, in order.
    pub(super) samples: Vec<SpectrumSample>,
    /// Of each part of the piece, in order, where an eigenvalue is unstable.
    pub(super) strips: Vec<Vec<Strip>>,
    /// Unstable eigenvalues of the samples of parts that are not smooth down to the resolution.
    pub(super) seeds: Vec<(f64, Complex64)>,
}

/// A search over one piece.
pub(super) struct PieceSearch<'a> {
    family: &'a dyn PairFamily,
    count: usize,
    /// A part so short is not halved any more.
    resolution: f64,
    done: SearchedPiece,
}

/// Two eigenvalues may meet where they come nearer than this share of what their distance changes from sample to sample.
const MEETING: f64 = 1.2;

impl<'a> PieceSearch<'a> {
    pub(super) fn over(
        family: &'a dyn PairFamily,
        count: usize,
        [from, to]: [f64; 2],
        resolution: f64,
    ) -> Result<SearchedPiece, SlidingError> {
        let mut search = Self { family, count, resolution, done: SearchedPiece::default() };
        let mut samples = Vec::with_capacity(SAMPLES);
        for k in 0..SAMPLES {
            let share = k as f64 / (SAMPLES - 1) as f64;
            samples.push(search.sample(from + share * (to - from))?);
        }
        search.part(&samples)?;
        sort_by_number(&mut search.done.samples, |own| own.at);
        Ok(search.done)
    }

    /// The place of a new sample in the list.
    fn sample(&mut self, at: f64) -> Result<usize, SlidingError> {
        let Spectrum { mut eigenvalues, limit, .. } = self.family.spectrum(at, self.count)?;
        sort_by_number(&mut eigenvalues, |own| reach(*own));
        self.done.samples.push(SpectrumSample { at, eigenvalues, limit });
        Ok(self.done.samples.len() - 1)
    }

    /// Searches between the first and the last of five even samples, halving where they are too coarse.
    fn part(&mut self, places: &[usize]) -> Result<(), SlidingError> {
        let samples: Vec<&SpectrumSample> = places.iter().map(|place| &self.done.samples[*place]).collect();
        let ends = [samples[0].at, samples[SAMPLES - 1].at];
        let is_last = ends[1] - ends[0] <= self.resolution * (SAMPLES - 1) as f64;
        let found = match grouped(&samples, self.count) {
            Ok(groups) => self.strips_of(&groups, &samples)?,
            Err(TooCoarse) => None,
        };
        if let Some(found) = found {
            self.done.strips.push(found);
            return Ok(());
        }
        if is_last {
            let is_conservative = self.family.at(ends[0])?.is_conservative();
            let counted = |sample: &&SpectrumSample| {
                let (at, last) = (sample.at, self.count.min(sample.eigenvalues.len()));
                sample.eigenvalues[..last].iter().map(|value| (at, *value)).collect::<Vec<_>>()
            };
            let grows = |seed: &(f64, Complex64)| alone(seed.1, is_conservative).value > 0.0;
            let seeds: Vec<(f64, Complex64)> = samples.iter().flat_map(counted).filter(grows).collect();
            self.done.seeds.extend(seeds);
            self.done.strips.push(Vec::new());
            return Ok(());
        }
        let mut halves = Vec::with_capacity(2 * SAMPLES - 1);
        for pair in places.windows(2) {
            let middle = 0.5 * (self.done.samples[pair[0]].at + self.done.samples[pair[1]].at);
            halves.extend([pair[0], self.sample(middle)?]);
        }
        halves.push(places[SAMPLES - 1]);
        self.part(&halves[..SAMPLES])?;
        self.part(&halves[SAMPLES - 1..])
    }

    /// `None` where the part is to be halved.
    fn strips_of(
        &self,
        groups: &[EigenvalueGroup],
        samples: &[&SpectrumSample],
    ) -> Result<Option<Vec<Strip>>, SlidingError> {
        let ends = [samples[0].at, samples[SAMPLES - 1].at];
        let is_conservative = self.family.at(ends[0])?.is_conservative();
        let mut all = Vec::new();
        for group in groups {
            for sheet in group.sheets() {
                let branch = PartBranch { group: *group, sheet: *sheet, ends, is_conservative };
                match strips(self.family, &branch) {
                    Ok(strips) => all.extend(strips),
                    Err(TooCoarse) => return Ok(None),
                }
            }
        }
        for strip in &mut all {
            strip.is_counted = self.is_counted(strip, samples);
        }
        Ok(Some(all))
    }

    /// Whether a strip's eigenvalue is among those counted at any sample within it, or at the one nearest to its middle.
    fn is_counted(&self, strip: &Strip, samples: &[&SpectrumSample]) -> bool {
        let middle = 0.5 * (strip.from.at + strip.to.at);
        let away = |k: &usize| (samples[*k].at - middle).abs();
        let nearest = (0..SAMPLES).min_by(|a, b| away(a).total_cmp(&away(b)));
        let within = |k: &usize| samples[*k].at >= strip.from.at && samples[*k].at <= strip.to.at;
        (0..SAMPLES).filter(within).chain(nearest).any(|k| {
            let value = strip.branch.foretold(k as f64 / (SAMPLES - 1) as f64).eigenvalue;
            let distance = |rank: &usize| (samples[k].eigenvalues[*rank] - value).norm_sqr();
            let rank = (0..samples[k].eigenvalues.len()).min_by(|a, b| distance(a).total_cmp(&distance(b)));
            rank.is_some_and(|rank| rank < self.count)
        })
    }
}

/// Eigenvalues that are alone, and two that may meet.
fn grouped(samples: &[&SpectrumSample], count: usize) -> Result<Vec<EigenvalueGroup>, TooCoarse> {
    let branches = matched(samples, count)?;
    let mut partner: Vec<Option<usize>> = vec![None; branches.len()];
    for i in 0..branches.len() {
        let mirror = branches[i].values.map(|value| value.conj());
        if branches[i].is_counted && may_meet(&branches[i].values, &mirror) && !branches[i].is_real() {
            return Err(TooCoarse);
        }
        for j in i + 1..branches.len() {
            let is_counted = branches[i].is_counted || branches[j].is_counted;
            if !(is_counted && may_meet(&branches[i].values, &branches[j].values)) {
                continue;
            }
            if partner[i].is_none() && partner[j].is_none() {
                (partner[i], partner[j]) = (Some(j), Some(i));
            } else {
                return Err(TooCoarse);
            }
        }
    }
    let group = |(i, branch): (usize, &Matched)| match partner[i] {
        Some(j) if i < j => Some(EigenvalueGroup::two(branch.values, branches[j].values)),
        None if branch.is_counted => Some(EigenvalueGroup::alone(branch.values)),
        _ => None,
    };
    let groups: Vec<EigenvalueGroup> = branches.iter().enumerate().filter_map(group).collect();
    if groups.iter().any(|group| !group.is_smooth()) {
        return Err(TooCoarse);
    }
    Ok(groups)
}

/// An eigenvalue through five samples.
struct Matched {
    values: [Complex64; SAMPLES],
    /// Whether it is among those counted at any of them.
    is_counted: bool,
}

impl Matched {
    fn is_real(&self) -> bool {
        self.values.iter().all(|value| value.im == 0.0)
    }
}

/// Follows the eigenvalues of the first sample to the last.
fn matched(samples: &[&SpectrumSample], count: usize) -> Result<Vec<Matched>, TooCoarse> {
    let mut branches: Vec<Vec<usize>> = (0..samples[0].eigenvalues.len()).map(|rank| vec![rank]).collect();
    for next in 1..SAMPLES {
        let value = |branch: &[usize], back: usize| samples[next - back].eigenvalues[branch[next - back]];
        let foretold: Vec<Complex64> = branches
            .iter()
            .map(|branch| if next < 2 { value(branch, 1) } else { 2.0 * value(branch, 1) - value(branch, 2) })
            .collect();
        let found = continued(&foretold, &samples[next].eigenvalues);
        for (branch, rank) in branches.iter_mut().zip(found) {
            branch.extend(rank);
        }
        branches.retain(|branch| branch.len() == next + 1);
    }
    let covered = |k: usize| branches.iter().filter(|branch| branch[k] < count).count();
    let least = |k: usize| count.min(samples[k].eigenvalues.len());
    if (0..SAMPLES).any(|k| covered(k) < least(k)) {
        return Err(TooCoarse);
    }
    let follow = |branch: &Vec<usize>| Matched {
        values: std::array::from_fn(|k| samples[k].eigenvalues[branch[k]]),
        is_counted: branch.iter().any(|rank| *rank < count),
    };
    Ok(branches.iter().map(follow).collect())
}

/// Whether the difference may pass through zero between samples.
fn may_meet(a: &[Complex64; SAMPLES], b: &[Complex64; SAMPLES]) -> bool {
    let apart = |k: usize| a[k] - b[k];
    let nearest = (0..SAMPLES).map(|k| apart(k).modulus()).fold(f64::INFINITY, f64::min);
    let change = (1..SAMPLES).map(|k| (apart(k) - apart(k - 1)).modulus()).fold(0.0, f64::max);
    nearest < MEETING * change
}
