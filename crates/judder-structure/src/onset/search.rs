//! The search for onsets between two values.

mod smooth;

use super::{Onset, OnsetDoubt, OnsetKind, OnsetsBetween, StabilityAt};
use crate::complex_modes::{Eigenvalue, Region, Verdict};
use judder_numerics::complex::ElementaryComplex;
use judder_numerics::order::sort_by_number;
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// Onsets are located to so much of the range of values.
const PRECISION: f64 = 1e-10;
/// Frequencies of one mode at two values differ by less than this share; where they differ by more, values between show that nothing
/// has changed.
const SAME_MODE: f64 = 0.01;
/// Around changes so much of their frequencies is looked at, and so much of the region.
const AROUND: [f64; 2] = [0.05, 0.01];
/// Where an exchange hides, the range is searched in pieces of so much of it,
const PIECE: f64 = 1.0 / 64.0;
/// unless a growing mode has moved by less than so much of its distance to those that do not grow.
const APART: f64 = 0.1;
/// Where no root is found it is sought again in so much of the interval.
const AGAIN: f64 = 1.0 / 8.0;
/// An eigenvalue this near to the edge of the region, by the size of the region, is on it.
const EDGE: f64 = 1e-6;

/// Stability at a value, as far as a region goes.
pub type StabilityOf<'a, E> = dyn FnMut(f64, &Region) -> Result<StabilityAt, E> + 'a;

/// The onsets between two values, the lower one first, at which stability in a region is known; `at` tells it at any other.
///
/// # Errors
/// Those of `at`.
pub fn onsets_between<E>(
    low: &(f64, StabilityAt),
    high: &(f64, StabilityAt),
    region: &Region,
    at: &mut StabilityOf<'_, E>,
) -> Result<OnsetsBetween, E> {
    let found = OnsetsBetween::default();
    let range = high.0 - low.0;
    let mut search = OnsetSearch {
        at,
        range,
        region,
        hides: false,
        narrows: true,
        has_strayed: false,
        sought: range,
        found,
    };
    let [low, high] = [low, high].map(|(value, stability)| search.taken(*value, stability.clone()));
    let (exchanged, seen) = (low.exchanged(&high), low.changes(&high).seen);
    search.hides = exchanged.iter().any(|change| !seen.contains(change));
    search.between(&low, &high, region)?;
    if let Some(change) = exchanged.iter().find(|change| search.lacks(&exchanged, change.gains)) {
        search.doubt(low.value, high.value, change.frequency);
    }
    Ok(search.found)
}

/// A value and what is known of stability there.
struct StabilitySample {
    value: f64,
    stability: StabilityAt,
}

/// A mode that grows at one end of an interval alone.
#[derive(Clone, Copy, PartialEq)]
struct ModeChange {
    /// Its frequency there, in Hz.
    frequency: f64,
    /// Whether that is the lower end.
    gains: bool,
}

/// What differs between two values.
struct ModeChanges {
    /// The modes that grow at one of them alone.
    seen: Vec<ModeChange>,
    /// The frequencies in Hz of modes that grow at both of them, or of two modes that have changed places.
    alike: Vec<f64>,
}

impl StabilitySample {
    /// The modes that grow, or that do not.
    fn those_that_grow(&self, grow: bool) -> impl Iterator<Item = &Eigenvalue> {
        let own = self.stability.eigenvalues.iter();
        own.filter(move |own| (own.verdict() == Verdict::Unstable) == grow)
    }

    /// Its modes in a region.
    fn within(&self, region: &Region) -> Self {
        let eigenvalues =
            self.stability.eigenvalues.iter().filter(|own| region.contains(own.value, 0.0)).copied();
        let stability = StabilityAt {
            eigenvalues: eigenvalues.collect(),
            branches: Vec::new(),
            complete: self.stability.complete,
            pieces: self.stability.pieces.clone(),
        };
        Self { value: self.value, stability }
    }

    /// The branches that are followed from here to a higher value and grow at one of them alone.
    fn exchanged(&self, high: &Self) -> Vec<ModeChange> {
        let grows = |own: &Eigenvalue| own.verdict() == Verdict::Unstable;
        let followed = |sample: &Self| -> BTreeMap<usize, Eigenvalue> {
            let StabilityAt { eigenvalues, branches, .. } = &sample.stability;
            branches.iter().copied().zip(eigenvalues.iter().copied()).collect()
        };
        let there = followed(high);
        let pairs = followed(self).into_iter().filter_map(|(branch, own)| Some((own, there.get(&branch)?)));
        let changed = pairs.filter(|(own, other)| grows(own) != grows(other));
        let change = |(own, other): (Eigenvalue, &Eigenvalue)| match grows(&own) {
            true => ModeChange { frequency: own.frequency_hz(), gains: true },
            false => ModeChange { frequency: other.frequency_hz(), gains: false },
        };
        changed.map(change).collect()
    }

    /// The modes that grow here or at a higher value alone: of all pairs of frequencies the nearest are those of one mode.
    fn changes(&self, high: &Self) -> ModeChanges {
        let [here, there] = [self, high].map(|sample| sample.those_that_grow(true).collect::<Vec<_>>());
        let [f_here, f_there] =
            [&here, &there].map(|own| own.iter().map(|own| own.frequency_hz()).collect::<Vec<f64>>());
        let mut pairs: Vec<(f64, usize, usize)> = Vec::new();
        for (i, own) in f_here.iter().enumerate() {
            let alike = f_there
                .iter()
                .enumerate()
                .filter(|(_, other)| (*other - own).abs() <= SAME_MODE * own.max(**other));
            pairs.extend(alike.map(|(j, other)| ((other - own).abs(), i, j)));
        }
        sort_by_number(&mut pairs, |own| own.0);
        let mut paired = [vec![false; here.len()], vec![false; there.len()]];
        let mut alike = Vec::new();
        for (_, i, j) in pairs {
            if !paired[0][i] && !paired[1][j] {
                (paired[0][i], paired[1][j]) = (true, true);
                let moved = (there[j].value - here[i].value).modulus();
                let is_apart = |sample: &Self, own: &Eigenvalue| {
                    sample
                        .those_that_grow(false)
                        .all(|other| moved < APART * (other.value - own.value).modulus())
                };
                if !is_apart(self, here[i]) && !is_apart(high, there[j]) {
                    alike.push(f_here[i]);
                }
            }
        }
        let alone = |frequencies: &[f64], paired: &[bool], gains: bool| {
            let own = frequencies.iter().zip(paired).filter(|(_, paired)| !**paired);
            own.map(|(frequency, _)| ModeChange { frequency: *frequency, gains }).collect::<Vec<_>>()
        };
        let seen = [alone(&f_here, &paired[0], true), alone(&f_there, &paired[1], false)].concat();
        ModeChanges { seen, alike }
    }

    /// Whether the growing mode of a frequency lies on the edge of the region, over which it comes or goes; eigenvalues without an
    /// imaginary part come and go along the edge Im λ = 0.
    fn leaves(&self, region: &Region, frequency: f64) -> bool {
        let distance = |own: &Eigenvalue| (own.frequency_hz() - frequency).abs();
        let growing = self.those_that_grow(true);
        let Some(own) = growing.min_by(|a, b| distance(a).total_cmp(&distance(b))) else { return false };
        let (re, im) = (own.value.re, own.value.im);
        let near = |value: f64, edge: f64, [from, to]: [f64; 2]| (edge - value).abs() <= EDGE * (to - from);
        let is_low = region.im[0] > 0.0 && near(im, region.im[0], region.im);
        is_low || near(im, region.im[1], region.im) || near(re, region.re[1], region.re)
    }
}

struct OnsetSearch<'a, 'b, E> {
    at: &'a mut StabilityOf<'b, E>,
    range: f64,
    region: &'a Region,
    /// Whether branches begin and cease to grow whose frequencies hide it.
    hides: bool,
    /// Whether only the part of the region around changes is looked at,
    narrows: bool,
    /// and whether a mode has left that part.
    has_strayed: bool,
    /// Roots are sought in intervals up to this width.
    sought: f64,
    found: OnsetsBetween,
}

impl<E> OnsetSearch<'_, '_, E> {
    fn sample(&mut self, value: f64, within: &Region) -> Result<StabilitySample, E> {
        let stability = (self.at)(value, within)?;
        Ok(self.taken(value, stability))
    }

    /// A value at which growing modes may be missing is told.
    fn taken(&mut self, value: f64, stability: StabilityAt) -> StabilitySample {
        if !stability.complete {
            self.found.doubts.push(OnsetDoubt::Missing { at: value });
        }
        StabilitySample { value, stability }
    }

    /// Finds the onsets between two values in a part of the region.
    fn between(&mut self, low: &StabilitySample, high: &StabilitySample, within: &Region) -> Result<(), E> {
        let ModeChanges { seen, alike } = low.changes(high);
        let (width, middle) = (high.value - low.value, 0.5 * (low.value + high.value));
        // at the ends of the range nothing need tell them apart
        if self.hides && (!alike.is_empty() || width >= self.range) {
            if width > PIECE * self.range {
                return self.halves(low, middle, high, within);
            }
            alike.into_iter().for_each(|frequency| self.doubt(low.value, high.value, frequency));
        }
        if seen.is_empty() {
            return Ok(());
        }
        self.of_changes(low, high, &seen, within)
    }

    /// Whether fewer onsets, or ends of growth, are found than branches show, and no modes are in doubt.
    fn lacks(&self, exchanged: &[ModeChange], gains: bool) -> bool {
        let shown = exchanged.iter().filter(|change| change.gains == gains).count();
        let found = self.found.onsets.iter().filter(|onset| onset.gains == gains).count();
        found < shown && !self.found.doubts.iter().any(|doubt| matches!(doubt, OnsetDoubt::Alike { .. }))
    }

    /// That two modes of a frequency may change places between two values, which may lie beside others.
    fn doubt(&mut self, low: f64, high: f64, frequency: f64) {
        if let Some(OnsetDoubt::Alike { to, frequency_hz, .. }) = self.found.doubts.last_mut()
            && *to == low
            && (*frequency_hz - frequency).abs() <= SAME_MODE * frequency
        {
            *to = high;
            return;
        }
        self.found.doubts.push(OnsetDoubt::Alike { from: low, to: high, frequency_hz: frequency });
    }

    /// Finds the onsets of changes that are seen.
    fn of_changes(
        &mut self,
        low: &StabilitySample,
        high: &StabilitySample,
        changes: &[ModeChange],
        within: &Region,
    ) -> Result<(), E> {
        let (width, middle) = (high.value - low.value, 0.5 * (low.value + high.value));
        if width <= PRECISION * self.range || !(middle > low.value && middle < high.value) {
            changes.iter().for_each(|change| self.keep(low, high, *change, within));
            return Ok(());
        }
        let has_jumped = low.stability.pieces != high.stability.pieces;
        if self.narrows && self.of_narrower(low, high, changes, within)? {
            return Ok(());
        }
        if let ([change], false) = (changes, has_jumped)
            && width <= self.sought
        {
            if let Some(onset) = self.root(low, high, *change, within)? {
                self.found.onsets.push(onset);
                return Ok(());
            }
            self.sought = AGAIN * width;
        }
        self.halves(low, middle, high, within)
    }

    /// Finds the onsets of changes in the part of the region around them; false where that is no narrower, or where modes leave it.
    fn of_narrower(
        &mut self,
        low: &StabilitySample,
        high: &StabilitySample,
        changes: &[ModeChange],
        within: &Region,
    ) -> Result<bool, E> {
        let around = self.around(changes);
        let near = [low.within(&around), high.within(&around)];
        let [here, there] = near.each_ref().map(|sample| sample.stability.eigenvalues.len());
        let has_jumped = low.stability.pieces != high.stability.pieces;
        let is_narrower = around.im[1] - around.im[0] < within.im[1] - within.im[0];
        if !is_narrower
            || near[0].changes(&near[1]).seen.len() != changes.len()
            || (here != there && !has_jumped)
        {
            return Ok(false);
        }
        let before = self.found.clone();
        self.of_changes(&near[0], &near[1], changes, &around)?;
        if !std::mem::take(&mut self.has_strayed) {
            return Ok(true);
        }
        // what was found where a mode left the part is no onset: the same again, without parts
        self.found = before;
        self.narrows = false;
        let found = self.of_changes(low, high, changes, within);
        self.narrows = true;
        found.map(|()| true)
    }

    fn halves(
        &mut self,
        low: &StabilitySample,
        middle: f64,
        high: &StabilitySample,
        within: &Region,
    ) -> Result<(), E> {
        let middle = self.sample(middle, within)?;
        self.between(low, &middle, within)?;
        self.between(&middle, high, within)
    }

    /// The part of the region around changes.
    fn around(&self, changes: &[ModeChange]) -> Region {
        let Region { re, im: [from, to] } = *self.region;
        let frequencies = changes.iter().map(|change| TAU * change.frequency);
        let [low, high] =
            [frequencies.clone().fold(f64::INFINITY, f64::min), frequencies.fold(0.0, f64::max)];
        let margin = AROUND[1] * (to - from);
        let im = [(low * (1.0 - AROUND[0]) - margin).max(from), (high * (1.0 + AROUND[0]) + margin).min(to)];
        Region { re, im }
    }

    /// Keeps what lies between two values that cannot be told apart, if it is no mode that comes or goes over the edge of the region.
    fn keep(&mut self, low: &StabilitySample, high: &StabilitySample, change: ModeChange, within: &Region) {
        let growing = if change.gains { low } else { high };
        if growing.leaves(self.region, change.frequency) {
            return;
        }
        self.has_strayed |= growing.leaves(within, change.frequency);
        self.found.onsets.push(Onset {
            value: 0.5 * (low.value + high.value),
            error: 0.5 * (high.value - low.value),
            jumps: low.stability.pieces != high.stability.pieces,
            ..change.onset()
        });
    }
}

impl ModeChange {
    /// What it is, wherever it lies.
    fn onset(self) -> Onset {
        let Self { frequency, gains } = self;
        let kind = if frequency == 0.0 { OnsetKind::Divergence } else { OnsetKind::Flutter };
        Onset {
            value: f64::NAN,
            error: f64::NAN,
            frequency_hz: frequency,
            kind,
            gains,
            jumps: false,
            crossing: None,
        }
    }
}
