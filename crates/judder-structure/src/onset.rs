//! Onsets: where along a parameter modes begin or cease to grow.
//!
//! Between two values at which not the same modes grow lies an onset. It is halved until it holds one change alone, then the function
//! that vanishes there is followed to its root: of a mode that loses its damping the growth rate; of two undamped modes that lock in
//! the square of the difference of their eigenvalues, which runs smoothly through zero where the eigenvalues themselves have a
//! branch point; of one that diverges without damping the square of its eigenvalue. Where contact points open or close in between, the
//! spectrum may jump, and what is found is a jump. A mode that leaves the region over its edge has no onset there.

use crate::complex_modes::{Eigenvalue, EigenvalueVerdict, Region};
use judder_numerics::root::bracketed_root;
use std::f64::consts::TAU;
use std::fmt;

/// What is known of stability at one value.
#[derive(Debug, Clone, PartialEq)]
pub struct StabilityAt {
    /// The eigenvalues of the region, Im λ ≥ 0.
    pub eigenvalues: Vec<Eigenvalue>,
    /// Which contact points are closed; empty where nothing touches.
    pub closed: Vec<bool>,
}

/// What happens at an onset.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OnsetKind {
    /// An oscillation begins to grow.
    Flutter,
    /// A motion without oscillation begins to grow.
    Divergence,
}

/// Where modes begin or cease to grow.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Onset {
    /// The value of the parameter.
    pub value: f64,
    /// How far the onset may be from it.
    pub error: f64,
    /// The frequency there in Hz; zero of a divergence.
    pub frequency_hz: f64,
    /// What happens.
    pub kind: OnsetKind,
    /// Whether stability is gained with rising values.
    pub gains: bool,
    /// Whether the spectrum jumps there, for contact points open or close.
    pub jumps: bool,
    /// The function that vanishes there; `None` where none does.
    pub crossing: Option<Crossing>,
}

/// A function of the eigenvalues that vanishes at an onset.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Crossing {
    vanishing: Vanishing,
    /// Of the mode, in Hz.
    frequency: f64,
    /// By which the function changes with the parameter.
    slope: f64,
    /// The region whose eigenvalues it is of.
    pub within: Region,
}

impl Crossing {
    /// By how much the onset of a problem that differs little lies higher, by a step of Newton's method; `stability` is what is known of
    /// that problem in the crossing's region, at the value of the onset.
    #[must_use]
    pub fn shift(&self, stability: &StabilityAt) -> f64 {
        -self.vanishing.value(stability, self.frequency) / self.slope
    }
}

impl OnsetKind {
    /// The word in summaries.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Flutter => "flutter",
            Self::Divergence => "divergence",
        }
    }
}

impl fmt::Display for OnsetKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// Onsets are located to so much of the range of values.
const PRECISION: f64 = 1e-10;
/// Frequencies of one mode at two values differ by less than this share; where they differ by more, values between show that nothing
/// has changed.
const SAME_MODE: f64 = 0.01;
/// Around changes so much of their frequencies is looked at, and so much of the region.
const AROUND: [f64; 2] = [0.05, 0.01];
/// The spectrum is taken to run smoothly over so much of the range.
const COARSE: f64 = 1e-3;
/// An eigenvalue this near to the edge of the region, by the size of the region, is on it.
const EDGE: f64 = 1e-6;

/// Stability at a value, as far as a region goes.
pub type StabilityOf<'a, E> = dyn FnMut(f64, &Region) -> Result<StabilityAt, E> + 'a;

/// The onsets between ascending values at which stability in a region is known, by rising value; `at` tells it at any other.
///
/// # Errors
/// Those of `at`.
pub fn onsets<E>(
    known: &[(f64, StabilityAt)],
    region: &Region,
    at: &mut StabilityOf<'_, E>,
) -> Result<Vec<Onset>, E> {
    let range = match (known.first(), known.last()) {
        (Some((from, _)), Some((to, _))) => (to - from).abs(),
        _ => return Ok(Vec::new()),
    };
    let mut search = OnsetSearch { at, range, region, found: Vec::new() };
    for pair in known.windows(2) {
        let [low, high] = [0, 1].map(|k| StabilitySample { value: pair[k].0, stability: pair[k].1.clone() });
        search.between(&low, &high, region)?;
    }
    Ok(search.found)
}

/// A value and what is known of stability there.
struct StabilitySample {
    value: f64,
    stability: StabilityAt,
}

/// A mode that grows at one end of an interval alone.
#[derive(Clone, Copy)]
struct ModeChange {
    /// Its frequency there, in Hz.
    frequency: f64,
    /// Whether that is the lower end.
    gains: bool,
}

impl StabilitySample {
    /// The frequencies of the modes that grow, in Hz.
    fn growing(&self) -> Vec<f64> {
        let grows = |own: &&Eigenvalue| own.verdict() == EigenvalueVerdict::Unstable;
        self.stability.eigenvalues.iter().filter(grows).map(Eigenvalue::frequency_hz).collect()
    }

    /// Its modes in a region.
    fn within(&self, region: &Region) -> Self {
        let eigenvalues =
            self.stability.eigenvalues.iter().filter(|own| region.contains(own.value, 0.0)).copied();
        let (eigenvalues, closed) = (eigenvalues.collect(), self.stability.closed.clone());
        Self { value: self.value, stability: StabilityAt { eigenvalues, closed } }
    }

    /// The modes that grow here or at a higher value alone: of all pairs of frequencies the nearest are those of one mode.
    fn changes(&self, high: &Self) -> Vec<ModeChange> {
        let (here, there) = (self.growing(), high.growing());
        let mut pairs: Vec<(f64, usize, usize)> = Vec::new();
        for (i, own) in here.iter().enumerate() {
            let alike = there
                .iter()
                .enumerate()
                .filter(|(_, other)| (*other - own).abs() <= SAME_MODE * own.max(**other));
            pairs.extend(alike.map(|(j, other)| ((other - own).abs(), i, j)));
        }
        pairs.sort_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
        let mut paired = [vec![false; here.len()], vec![false; there.len()]];
        for (_, i, j) in pairs {
            if !paired[0][i] && !paired[1][j] {
                (paired[0][i], paired[1][j]) = (true, true);
            }
        }
        let alone = |frequencies: &[f64], paired: &[bool], gains: bool| {
            let own = frequencies.iter().zip(paired).filter(|(_, paired)| !**paired);
            own.map(|(frequency, _)| ModeChange { frequency: *frequency, gains }).collect::<Vec<_>>()
        };
        [alone(&here, &paired[0], true), alone(&there, &paired[1], false)].concat()
    }

    /// Whether the growing mode of a frequency lies on the edge of the region, over which it comes or goes; eigenvalues without an
    /// imaginary part come and go along the edge Im λ = 0.
    fn leaves(&self, region: &Region, frequency: f64) -> bool {
        let grows = |own: &&Eigenvalue| own.verdict() == EigenvalueVerdict::Unstable;
        let distance = |own: &Eigenvalue| (own.frequency_hz() - frequency).abs();
        let growing = self.stability.eigenvalues.iter().filter(grows);
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
    found: Vec<Onset>,
}

impl<E> OnsetSearch<'_, '_, E> {
    fn sample(&mut self, value: f64, within: &Region) -> Result<StabilitySample, E> {
        (self.at)(value, within).map(|stability| StabilitySample { value, stability })
    }

    /// Finds the onsets between two values in a part of the region.
    fn between(&mut self, low: &StabilitySample, high: &StabilitySample, within: &Region) -> Result<(), E> {
        let changes = low.changes(high);
        if changes.is_empty() {
            return Ok(());
        }
        let (width, middle) = (high.value - low.value, 0.5 * (low.value + high.value));
        let precision = PRECISION * self.range;
        if width <= precision || !(middle > low.value && middle < high.value) {
            for change in changes {
                self.keep(low, high, change);
            }
            return Ok(());
        }
        let around = self.around(&changes);
        let near = [low.within(&around), high.within(&around)];
        let narrower = around.im[1] - around.im[0] < within.im[1] - within.im[0];
        if narrower && near[0].changes(&near[1]).len() == changes.len() {
            return self.between(&near[0], &near[1], &around);
        }
        let is_smooth = low.stability.closed == high.stability.closed && width <= COARSE * self.range;
        if let ([change], true) = (&changes[..], is_smooth)
            && let Some(onset) = self.root(low, high, *change, within)?
        {
            self.found.push(onset);
            return Ok(());
        }
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
    fn keep(&mut self, low: &StabilitySample, high: &StabilitySample, change: ModeChange) {
        let growing = if change.gains { low } else { high };
        if growing.leaves(self.region, change.frequency) {
            return;
        }
        self.found.push(Onset {
            value: 0.5 * (low.value + high.value),
            error: 0.5 * (high.value - low.value),
            jumps: low.stability.closed != high.stability.closed,
            ..change.onset()
        });
    }

    /// The root of the function that vanishes at an onset; `None` where it does not vanish, or the closed points change.
    fn root(
        &mut self,
        low: &StabilitySample,
        high: &StabilitySample,
        change: ModeChange,
        within: &Region,
    ) -> Result<Option<Onset>, E> {
        let (stable, unstable) = if change.gains { (high, low) } else { (low, high) };
        let vanishing = Vanishing::of(&stable.stability, unstable.growing().len(), change.frequency);
        let value_of = |sample: &StabilitySample| match sample.stability.closed == low.stability.closed {
            true => vanishing.value(&sample.stability, change.frequency),
            false => f64::NAN,
        };
        let precision = PRECISION * self.range;
        let mut failure = None;
        let found = bracketed_root(
            |value| match self.sample(value, within) {
                Ok(sample) => value_of(&sample),
                Err(error) => {
                    failure = Some(error);
                    f64::NAN
                }
            },
            low.value,
            high.value,
            precision,
        );
        if let Some(error) = failure {
            return Err(error);
        }
        let Ok(value) = found else { return Ok(None) };
        let at = self.sample(value, within)?;
        let slope = (value_of(high) - value_of(low)) / (high.value - low.value);
        // beside the root, where eigenvalues that meet are well conditioned
        let unknown = vanishing.error(&stable.stability, change.frequency) / slope.abs();
        let near = nearest(&at.stability, change.frequency, 1);
        let frequency = near.first().map_or(change.frequency, |own| own.frequency_hz());
        let error = if unknown.is_finite() { unknown.max(0.5 * precision) } else { high.value - low.value };
        let crossing = Some(Crossing { vanishing, frequency, slope, within: *within });
        Ok(Some(Onset { value, error, crossing, ..ModeChange { frequency, ..change }.onset() }))
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

/// What vanishes at an onset.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Vanishing {
    /// Among damped modes the growth rate that so many reach: as many as grow beyond the onset.
    Growth(usize),
    /// (λ₁ − λ₂)² of two undamped modes, whose eigenvalues meet: below zero before they do.
    Difference,
    /// λ² of an undamped mode whose eigenvalue comes to zero.
    Square,
}

impl Vanishing {
    /// By what is known beside the onset, where the mode does not grow, and by how many modes grow where it does.
    fn of(stable: &StabilityAt, growing: usize, frequency: f64) -> Self {
        let is_damped = |own: &&Eigenvalue| own.verdict() == EigenvalueVerdict::Stable;
        let decays = nearest(stable, frequency, 1).first().is_some_and(is_damped);
        match (decays, frequency > 0.0) {
            (true, _) => Self::Growth(growing),
            (false, true) => Self::Difference,
            (false, false) => Self::Square,
        }
    }

    /// Its value; NaN where the modes are not there.
    fn value(self, stability: &StabilityAt, frequency: f64) -> f64 {
        match (self, &nearest(stability, frequency, 2)[..]) {
            (Self::Growth(growing), _) => ranked(stability, growing).map_or(f64::NAN, |own| own.value.re),
            (Self::Difference, [one, other]) => {
                let apart = one.value - other.value;
                (apart * apart).re
            }
            (Self::Square, [one, ..]) => (one.value * one.value).re,
            _ => f64::NAN,
        }
    }

    /// How far it may be off, by the errors of the eigenvalues.
    fn error(self, stability: &StabilityAt, frequency: f64) -> f64 {
        match (self, &nearest(stability, frequency, 2)[..]) {
            (Self::Growth(growing), _) => ranked(stability, growing).map_or(f64::NAN, |own| own.error),
            (Self::Difference, [one, other]) => {
                let (apart, error) = ((one.value - other.value).norm(), one.error + other.error);
                (2.0 * apart + error) * error
            }
            (Self::Square, [one, ..]) => (2.0 * one.value.norm() + one.error) * one.error,
            _ => f64::NAN,
        }
    }
}

/// The eigenvalue of the so many-th largest growth rate.
fn ranked(stability: &StabilityAt, rank: usize) -> Option<&Eigenvalue> {
    let mut all: Vec<&Eigenvalue> = stability.eigenvalues.iter().collect();
    all.sort_by(|a, b| b.value.re.total_cmp(&a.value.re));
    all.get(rank.checked_sub(1)?).copied()
}

/// The eigenvalues whose frequencies are nearest to one in Hz.
fn nearest(stability: &StabilityAt, frequency: f64, count: usize) -> Vec<&Eigenvalue> {
    let mut all: Vec<&Eigenvalue> = stability.eigenvalues.iter().collect();
    let distance = |own: &Eigenvalue| (own.value.im / TAU - frequency).abs();
    all.sort_by(|a, b| distance(a).total_cmp(&distance(b)));
    all.truncate(count);
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::StructureError;
    use crate::assembly::Sparse;
    use crate::complex_modes::{ComplexModeSettings, complex_modes};
    use crate::quadratic::Quadratic;
    use faer::sparse::Triplet;

    fn matrix(rows: [[f64; 2]; 2]) -> Sparse {
        let entries = [(0, 0), (0, 1), (1, 0), (1, 1)].map(|(i, j)| Triplet::new(i, j, rows[i][j]));
        Sparse::try_new_from_triplets(2, 2, &entries).unwrap()
    }

    /// M = 1, C = diag(c₁, c₂), and a stiffness of the parameter.
    fn found(damping: [f64; 2], values: &[f64], stiffness: fn(f64) -> [[f64; 2]; 2]) -> Vec<Onset> {
        let region = Region { re: [-5.0, 5.0], im: [-1e-9, 10.0] };
        let mut at = |value: f64, within: &Region| -> Result<StabilityAt, StructureError> {
            let [a, b] = damping;
            let problem = Quadratic::new(
                matrix([[1.0, 0.0], [0.0, 1.0]]),
                matrix([[a, 0.0], [0.0, b]]),
                matrix(stiffness(value)),
            )?;
            let found = complex_modes(&problem, within, &ComplexModeSettings::default())?;
            let eigenvalues = found.modes.iter().map(|mode| mode.eigenvalue).collect();
            Ok(StabilityAt { eigenvalues, closed: Vec::new() })
        };
        let known: Vec<_> = values.iter().map(|value| (*value, at(*value, &region).unwrap())).collect();
        onsets(&known, &region, &mut at).unwrap()
    }

    /// Two modes of stiffness 1 and 2 with a skew coupling s meet where s = 1/2.
    #[test]
    fn a_lock_in_without_damping_is_located() {
        let found = found([0.0; 2], &[0.0, 0.3, 0.9], |s| [[1.0, s], [-s, 2.0]]);
        let [onset] = found[..] else { panic!("{found:?}") };
        assert!((onset.value - 0.5).abs() < 1e-9, "{}", onset.value);
        assert!(onset.kind == OnsetKind::Flutter && !onset.gains && !onset.jumps);
        assert!((onset.frequency_hz * TAU - 1.5_f64.sqrt()).abs() < 1e-3);
    }

    /// With dampings c₁ and c₂ Routh and Hurwitz have the Hopf point of (s² + c₁ s + 1)(s² + c₂ s + 2) + S² at
    /// a₁ a₂ a₃ = a₃² + a₁² a₄.
    #[test]
    fn a_hopf_point_is_located() {
        let (c1, c2): (f64, f64) = (0.02, 0.05);
        let found = found([c1, c2], &[0.0, 0.4, 0.8], |s| [[1.0, s], [-s, 2.0]]);
        let [onset] = found[..] else { panic!("{found:?}") };
        let (a1, a2, a3) = (c1 + c2, 3.0 + c1 * c2, 2.0 * c1 + c2);
        let expected = ((a1 * a2 * a3 - a3 * a3) / (a1 * a1) - 2.0).sqrt();
        assert!((onset.value - expected).abs() < 1e-9, "{} {expected}", onset.value);
    }

    /// A stiffness 1 − p becomes negative at p = 1, with damping and without.
    #[test]
    fn a_divergence_is_located_and_one_that_ends_gains() {
        for damping in [[0.0; 2], [0.1, 0.1]] {
            let found = found(damping, &[0.0, 1.7, 4.0], |p| [[(p - 1.0) * (p - 3.0), 0.0], [0.0, 50.0]]);
            let [begins, ends] = found[..] else { panic!("{found:?}") };
            assert!((begins.value - 1.0).abs() < 1e-9 && (ends.value - 3.0).abs() < 1e-9, "{found:?}");
            assert!(begins.kind == OnsetKind::Divergence && !begins.gains && ends.gains);
        }
    }

    /// An unstable mode whose frequency rises over the upper edge of the region.
    #[test]
    fn a_mode_that_leaves_the_region_has_no_onset() {
        let found = found([-0.1, 0.1], &[0.0, 1.0], |p| [[81.0 + 40.0 * p, 0.0], [0.0, 2.0]]);
        assert!(found.is_empty(), "{found:?}");
    }
}
