//! Onsets: where along a parameter modes begin or cease to grow.
//!
//! Between two values at which not the same modes grow lies an onset. It is halved until it holds one change alone, then the function
//! that vanishes there is followed to its root: of a mode that loses its damping the growth rate; of two undamped modes that lock in
//! the square of the difference of their eigenvalues, which runs smoothly through zero where the eigenvalues themselves have a
//! branch point; of one that diverges without damping the square of its eigenvalue. Where the closed points change in between, the
//! spectrum may jump, and what is found is a jump.

use judder_numerics::root::bracketed_root;
use judder_structure::complex_modes::{Eigenvalue, EigenvalueVerdict};
use std::f64::consts::TAU;
use std::fmt;

/// What is known of stability at one value.
#[derive(Debug, Clone, PartialEq)]
pub struct StabilityAt {
    /// The eigenvalues of the region, Im λ ≥ 0.
    pub eigenvalues: Vec<Eigenvalue>,
    /// Which contact points are closed.
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

/// Onsets are located to so much of the range of values, or of themselves where that is less.
const PRECISION: f64 = 1e-10;
/// Intervals in which more than one mode changes are halved down to so much of the range.
const TOGETHER: f64 = 1e-6;
/// Frequencies of one mode at two values differ by less than this share.
const SAME_MODE: f64 = 0.1;
/// The spectrum is taken to run smoothly over so much of the range.
const COARSE: f64 = 1e-3;

/// The onsets between ascending values at which stability is known, by rising value; `at` tells it at any other.
///
/// # Errors
/// Those of `at`.
pub fn onsets<E>(
    known: &[(f64, StabilityAt)],
    at: &mut dyn FnMut(f64) -> Result<StabilityAt, E>,
) -> Result<Vec<Onset>, E> {
    let range = match (known.first(), known.last()) {
        (Some((from, _)), Some((to, _))) => (to - from).abs(),
        _ => return Ok(Vec::new()),
    };
    let mut search = Search { at, range, found: Vec::new() };
    for pair in known.windows(2) {
        search.between(
            &Sample::new(pair[0].0, pair[0].1.clone()),
            &Sample::new(pair[1].0, pair[1].1.clone()),
        )?;
    }
    Ok(search.found)
}

/// A value with the frequencies of the modes that grow there, ascending.
struct Sample {
    value: f64,
    stability: StabilityAt,
    growing: Vec<f64>,
}

impl Sample {
    fn new(value: f64, stability: StabilityAt) -> Self {
        let grows = |own: &&Eigenvalue| own.verdict() == EigenvalueVerdict::Unstable;
        let mut growing: Vec<f64> =
            stability.eigenvalues.iter().filter(grows).map(Eigenvalue::frequency_hz).collect();
        growing.sort_by(f64::total_cmp);
        Self { value, stability, growing }
    }

    /// The growing modes of this value that do not grow at the other.
    fn alone(&self, other: &Self) -> Vec<f64> {
        let mut partners = other.growing.clone();
        let mut alone = Vec::new();
        for own in &self.growing {
            let distance = |other: &f64| (other - own).abs();
            let nearest = (0..partners.len())
                .min_by(|a, b| distance(&partners[*a]).total_cmp(&distance(&partners[*b])));
            match nearest {
                Some(k) if distance(&partners[k]) <= SAME_MODE * own.max(partners[k]) => {
                    partners.remove(k);
                }
                _ => alone.push(*own),
            }
        }
        alone
    }
}

struct Search<'a, E> {
    at: &'a mut dyn FnMut(f64) -> Result<StabilityAt, E>,
    range: f64,
    found: Vec<Onset>,
}

impl<E> Search<'_, E> {
    fn sample(&mut self, value: f64) -> Result<Sample, E> {
        (self.at)(value).map(|stability| Sample::new(value, stability))
    }

    /// Finds the onsets between two values.
    fn between(&mut self, low: &Sample, high: &Sample) -> Result<(), E> {
        let (lost, gained) = (low.alone(high), high.alone(low));
        let changes = lost.len() + gained.len();
        let width = high.value - low.value;
        let middle = 0.5 * (low.value + high.value);
        if changes == 0 || !(middle > low.value && middle < high.value) {
            return Ok(());
        }
        if changes == 1 || width <= TOGETHER * self.range {
            for frequency in lost {
                self.locate(low, high, frequency, true)?;
            }
            for frequency in gained {
                self.locate(low, high, frequency, false)?;
            }
            return Ok(());
        }
        let middle = self.sample(middle)?;
        self.between(low, &middle)?;
        self.between(&middle, high)
    }

    /// Locates the onset of a mode that grows at one end alone; `gains` where that is the lower.
    fn locate(&mut self, low: &Sample, high: &Sample, frequency: f64, gains: bool) -> Result<(), E> {
        let mut onset = Bracket {
            low: low.value,
            high: high.value,
            closed: [low.stability.closed.clone(), high.stability.closed.clone()],
            frequency,
            gains,
        };
        let precision = PRECISION * self.range;
        while !onset.is_narrow(precision) && !onset.is_smooth(COARSE * self.range) {
            let sample = self.sample(onset.middle())?;
            onset.halve(&sample);
        }
        if !onset.is_narrow(precision) {
            self.follow(&mut onset, precision)?;
        }
        self.found.push(onset.located());
        Ok(())
    }

    /// Follows the function that vanishes at an onset to its root; halves on where it does not vanish, or the closed points change.
    fn follow(&mut self, onset: &mut Bracket, precision: f64) -> Result<(), E> {
        let (frequency, closed) = (onset.frequency, onset.closed[0].clone());
        let ends = [self.sample(onset.low)?, self.sample(onset.high)?];
        let stable = &ends[usize::from(onset.gains)].stability;
        let vanishing = Vanishing::of(stable, frequency);
        let mut failure = None;
        let found = bracketed_root(
            |value| match (self.at)(value) {
                Ok(stability) if stability.closed == closed => vanishing.value(&stability, frequency),
                Ok(_) => f64::NAN,
                Err(error) => {
                    failure = Some(error);
                    f64::NAN
                }
            },
            onset.low,
            onset.high,
            precision,
        );
        if let Some(error) = failure {
            return Err(error);
        }
        if let Ok(root) = found {
            (onset.low, onset.high) = (root - 0.5 * precision, root + 0.5 * precision);
            return Ok(());
        }
        while !onset.is_narrow(precision) {
            let sample = self.sample(onset.middle())?;
            onset.halve(&sample);
        }
        Ok(())
    }
}

/// Two values between which a mode begins or ceases to grow.
struct Bracket {
    low: f64,
    high: f64,
    /// The closed points at both.
    closed: [Vec<bool>; 2],
    /// Of the mode, in Hz.
    frequency: f64,
    /// Whether it grows at the lower.
    gains: bool,
}

impl Bracket {
    fn middle(&self) -> f64 {
        0.5 * (self.low + self.high)
    }

    fn is_narrow(&self, precision: f64) -> bool {
        let middle = self.middle();
        self.high - self.low <= precision || !(middle > self.low && middle < self.high)
    }

    /// Whether the spectrum runs smoothly from end to end.
    fn is_smooth(&self, width: f64) -> bool {
        self.closed[0] == self.closed[1] && self.high - self.low <= width
    }

    fn halve(&mut self, sample: &Sample) {
        let near = |own: &f64| (own - self.frequency).abs() <= SAME_MODE * self.frequency.max(*own);
        let distance = |own: &f64| (own - self.frequency).abs();
        let own =
            sample.growing.iter().copied().filter(near).min_by(|a, b| distance(a).total_cmp(&distance(b)));
        self.frequency = own.unwrap_or(self.frequency);
        let closed = sample.stability.closed.clone();
        if own.is_some() == self.gains {
            (self.low, self.closed[0]) = (sample.value, closed);
        } else {
            (self.high, self.closed[1]) = (sample.value, closed);
        }
    }

    fn located(&self) -> Onset {
        Onset {
            value: self.middle(),
            error: 0.5 * (self.high - self.low),
            frequency_hz: self.frequency,
            kind: if self.frequency == 0.0 { OnsetKind::Divergence } else { OnsetKind::Flutter },
            gains: self.gains,
            jumps: self.closed[0] != self.closed[1],
        }
    }
}

/// What vanishes at an onset.
#[derive(Clone, Copy)]
enum Vanishing {
    /// The growth rate of a damped mode.
    Growth,
    /// (λ₁ − λ₂)² of two undamped modes, whose eigenvalues meet: below zero before they do.
    Difference,
    /// λ² of an undamped mode whose eigenvalue comes to zero.
    Square,
}

impl Vanishing {
    /// By what is known beside the onset, where the mode does not grow.
    fn of(stable: &StabilityAt, frequency: f64) -> Self {
        let is_damped = |own: &&Eigenvalue| own.verdict() == EigenvalueVerdict::Stable;
        let decays = nearest(stable, frequency, 1).first().is_some_and(is_damped);
        match (decays, frequency > 0.0) {
            (true, _) => Self::Growth,
            (false, true) => Self::Difference,
            (false, false) => Self::Square,
        }
    }

    /// Its value; NaN where the modes are not there.
    fn value(self, stability: &StabilityAt, frequency: f64) -> f64 {
        match (self, &nearest(stability, frequency, 2)[..]) {
            (Self::Growth, own) => own.iter().map(|own| own.value.re).fold(f64::NAN, f64::max),
            (Self::Difference, [one, other]) => {
                let apart = one.value - other.value;
                (apart * apart).re
            }
            (Self::Square, [one, ..]) => (one.value * one.value).re,
            _ => f64::NAN,
        }
    }
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
    use faer::sparse::Triplet;
    use judder_structure::StructureError;
    use judder_structure::assembly::Sparse;
    use judder_structure::complex_modes::{ComplexModeSettings, Region, complex_modes};
    use judder_structure::quadratic::Quadratic;

    fn matrix(rows: [[f64; 2]; 2]) -> Sparse {
        let entries = [(0, 0), (0, 1), (1, 0), (1, 1)].map(|(i, j)| Triplet::new(i, j, rows[i][j]));
        Sparse::try_new_from_triplets(2, 2, &entries).unwrap()
    }

    /// M = 1, C = diag(c₁, c₂), and a stiffness of the parameter.
    fn found(damping: [f64; 2], values: &[f64], stiffness: fn(f64) -> [[f64; 2]; 2]) -> Vec<Onset> {
        let mut at = |value: f64| -> Result<StabilityAt, StructureError> {
            let [a, b] = damping;
            let problem = Quadratic::new(
                matrix([[1.0, 0.0], [0.0, 1.0]]),
                matrix([[a, 0.0], [0.0, b]]),
                matrix(stiffness(value)),
            )?;
            let region = Region { re: [-5.0, 5.0], im: [-1e-9, 10.0] };
            let found = complex_modes(&problem, &region, &ComplexModeSettings::default())?;
            let eigenvalues = found.modes.iter().map(|mode| mode.eigenvalue).collect();
            Ok(StabilityAt { eigenvalues, closed: Vec::new() })
        };
        let known: Vec<_> = values.iter().map(|value| (*value, at(*value).unwrap())).collect();
        onsets(&known, &mut at).unwrap()
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
}
