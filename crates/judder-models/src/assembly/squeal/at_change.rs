//! The modes with a number of the case changed as far as a cure asks: a whole solution there, the mode followed to it.

use crate::assembly::AssemblySubject;
use crate::assembly::eigen::band;
use crate::assembly::swept::SweptAssembly;
use crate::error::ModelError;
use crate::key_sweep::KeySweep;
use judder_numerics::complex::ElementaryComplex;
use judder_numerics::parallel;
use judder_structure::complex_modes::{Eigenvalue, Verdict};
use judder_structure::eigen_sweep::{NothingFollowed, SolvedPoint, SweptEigenvalues, followed};
use judder_study::Progress;
use judder_study::text::short;
use num_complex::Complex64;
use std::f64::consts::TAU;

/// Changes on the way at which the mode is looked for, at most, the whole one among them, and by how much of itself the number changes from one to the next where these suffice.
pub(super) const MOST: usize = 8;
const STEP: f64 = 0.1;
/// Frequencies around the mode in which it is followed, where that is more than the band.
const AROUND: [f64; 2] = [0.8, 1.25];
/// What the mode may differ by from itself as it was solved before, of its eigenvalue.
const SAME: f64 = 1e-3;

/// The mode whose cures are sought, among those of its band.
#[derive(Debug, Clone, Copy)]
pub(super) struct ModeInBand {
    pub(super) value: Complex64,
    /// Between which frequencies modes are asked for.
    pub(super) band: [f64; 2],
    /// How many of them grow with the case as it is.
    pub(super) unstable: usize,
}

/// What the modes are with a number changed.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct ModesAtChange {
    /// The growth rate of the mode, in 1/s; none where it was not found again.
    pub(super) growth: Option<f64>,
    /// Whether it decays; none where that is not known, or within its error.
    pub(super) cured: Option<bool>,
    /// Modes of the band that grow; none where not all of them are known.
    pub(super) unstable: Option<usize>,
    pub(super) words: String,
}

impl ModesAtChange {
    fn unknown(reason: &str) -> Self {
        Self { growth: None, cured: None, unstable: None, words: format!("unknown: {reason}") }
    }
}

impl ModeInBand {
    /// The modes with a number that has this value changed by a share of itself.
    pub(super) fn at_change(
        &self,
        of: &AssemblySubject<'_>,
        sweep: &KeySweep,
        (value, change): (f64, f64),
        progress: &dyn Progress,
    ) -> Result<ModesAtChange, ModelError> {
        let steps = ((change.abs() / STEP).ceil() as usize).clamp(1, MOST);
        let [from, to] = self.band;
        let region = band(from.min(AROUND[0] * self.value.im), to.max(AROUND[1] * self.value.im));
        let family = SweptAssembly::new(of, vec![sweep], true);
        let solve = |step: usize| -> Result<Result<SolvedPoint, String>, ModelError> {
            progress.go_on()?;
            let changed = value * (1.0 + change * step as f64 / steps as f64);
            let solved = family.state(&[changed]).and_then(|state| {
                let solved = family.solved_alone(&state, &region)?;
                family.expanded(&state, solved)
            });
            match solved {
                Err(ModelError::Interrupted) => Err(ModelError::Interrupted),
                solved => Ok(solved.map_err(|error| error.to_string())),
            }
        };
        let solved = parallel::try_each_place(steps + 1, solve)?;
        if let Err(reason) = &solved[steps] {
            return Ok(ModesAtChange::unknown(reason));
        }
        let known = |step: usize| Ok(solved[step].clone().unwrap_or_else(|_| SolvedPoint::unsolved()));
        let swept = followed::<ModelError>(0..steps + 1, &region, &known, &NothingFollowed)?;
        Ok(self.told(&swept, steps))
    }

    fn told(&self, swept: &SweptEigenvalues, last: usize) -> ModesAtChange {
        let off = |own: &Eigenvalue| (own.value - self.value).modulus();
        let first = swept.points[0].eigenvalues.iter();
        let branch = first
            .min_by(|a, b| off(&a.eigenvalue).total_cmp(&off(&b.eigenvalue)))
            .filter(|own| off(&own.eigenvalue) < SAME * self.value.modulus())
            .map(|own| own.branch);
        let at_change = &swept.points[last];
        let found = at_change.eigenvalues.iter().find(|own| Some(own.branch) == branch);
        let found = found.map(|own| own.eigenvalue);
        let [from, to] = self.band;
        let grows = |own: &&Eigenvalue| {
            own.verdict() == Verdict::Unstable && own.value.im > 0.0 && (from..=to).contains(&own.value.im)
        };
        let all = at_change.eigenvalues.iter().map(|own| &own.eigenvalue);
        let unstable = at_change.gaps.is_empty().then(|| all.filter(grows).count());
        let of_mode = match &found {
            Some(own) => self.words(own),
            None => "unknown: the mode was not found again".to_owned(),
        };
        let of_band = unstable.map_or_else(
            || "it is not proven that no other modes of the band grow then".to_owned(),
            |count| self.count_words(count),
        );
        ModesAtChange {
            growth: found.map(|own| own.value.re),
            cured: found.and_then(|own| match own.verdict() {
                Verdict::Stable => Some(true),
                Verdict::Unstable => Some(false),
                Verdict::Marginal => None,
            }),
            unstable,
            words: format!("{of_mode}; {of_band}"),
        }
    }

    /// What becomes of the mode.
    fn words(&self, own: &Eigenvalue) -> String {
        let rate = short(own.value.re.abs());
        match own.verdict() {
            Verdict::Stable => format!("cured: it decays with {rate} 1/s"),
            Verdict::Marginal => "undecided: it neither grows nor decays within its error".to_owned(),
            Verdict::Unstable if own.value.re > self.value.re => {
                format!("not cured: it grows faster, with {rate} 1/s")
            }
            Verdict::Unstable => format!("not cured: it still grows, with {rate} 1/s"),
        }
    }

    /// How many modes of the band grow then.
    fn count_words(&self, count: usize) -> String {
        let [from, to] = self.band.map(|omega| short(omega / TAU));
        let modes = if count == 1 { "mode grows" } else { "modes grow" };
        format!("from {from} to {to} Hz {count} {modes} then, {} without the change", self.unstable)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use judder_structure::eigen_sweep::{PointEigenvalues, Tracked};

    const MODE: ModeInBand =
        ModeInBand { value: Complex64::new(10.0, 1000.0), band: [900.0, 1100.0], unstable: 2 };

    fn told(growth: [f64; 2]) -> ModesAtChange {
        let tracked = |re: f64, im: f64, branch: usize| Tracked {
            eigenvalue: Eigenvalue {
                value: Complex64::new(re, im),
                residual: 0.0,
                left_residual: 0.0,
                condition: 1.0,
                error: 1e-6,
                defective: false,
            },
            branch,
        };
        let point = |growth: f64| PointEigenvalues {
            eigenvalues: vec![tracked(20.0, 850.0, 0), tracked(growth, 1000.0, 1), tracked(5.0, 1050.0, 2)],
            gaps: Vec::new(),
            full: true,
        };
        let points = growth.map(point).to_vec();
        MODE.told(&SweptEigenvalues { points, branches: 3, basis: None, samples: Vec::new() }, 1)
    }

    #[test]
    fn a_mode_that_decays_more_than_asked_is_cured_and_one_that_grows_faster_is_not() {
        let cured = told([10.0, -101.0]);
        assert_eq!((cured.growth, cured.cured, cured.unstable), (Some(-101.0), Some(true), Some(1)));
        assert!(cured.words.starts_with("cured: it decays with 101 1/s; from 143.2"), "{}", cured.words);
        let worse = told([10.0, 101.0]);
        assert_eq!((worse.cured, worse.unstable), (Some(false), Some(2)));
        assert!(worse.words.starts_with("not cured: it grows faster, with 101 1/s"), "{}", worse.words);
        assert!(told([10.0, 2.0]).words.starts_with("not cured: it still grows, with 2 1/s"));
    }

    #[test]
    fn another_mode_is_not_taken_for_it() {
        let other = told([11.5, -101.0]);
        assert_eq!((other.growth, other.cured, other.unstable), (None, None, Some(1)));
        assert!(other.words.starts_with("unknown: the mode was not found again"), "{}", other.words);
    }
}
