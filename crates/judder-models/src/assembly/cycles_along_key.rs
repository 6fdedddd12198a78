//! Cycles along a key: the first one, of a mode or near a march, and the branch through it.

use super::limit_cycle::search::CycleOfMode;
use super::limit_cycle::start::CycleStart;
use super::swept::{SlidingState, SweptAssembly};
use crate::error::ModelError;
use crate::key_sweep::KeySweep;
use judder_assembly::assembly::Assembly;
use judder_assembly::steady::SteadySliding;
use judder_cycles::CyclesError;
use judder_cycles::backbone::{BackboneSettings, PeriodicMotion};
use judder_cycles::balance::HarmonicBalance;
use judder_cycles::branch::{
    AssemblyCycleBranch, BranchSettings, CycleAtKey, CycleBranchPoint, cycle_branch,
};
use judder_cycles::cycle::{AssemblyCycle, CycleSettings, HarmonicCount};
use judder_cycles::fold::refined_fold;
use judder_cycles::path::PathRule;
use judder_cycles::series::Series;
use judder_study::Progress;
use judder_study::case::scale::Spacing;
use num_complex::Complex64;

/// What is followed along which key, and how.
pub(super) struct CyclesAlongKey<'a> {
    pub(super) family: &'a SweptAssembly<'a>,
    pub(super) sweep: &'a KeySweep,
    /// Harmonics of the cycles.
    pub(super) harmonics: usize,
    /// Instants of a period a harmonic.
    pub(super) samples: usize,
    /// How the motions of a mode are followed to its cycle.
    pub(super) backbone: BackboneSettings,
    /// The most cycles of a branch.
    pub(super) most: usize,
    pub(super) progress: &'a dyn Progress,
}

/// Where a branch begins.
pub(super) struct FirstCycle {
    value: f64,
    assembly: Assembly,
    steady: SteadySliding,
    /// In rad/s, by which its equations are scaled.
    frequency: f64,
    motion: PeriodicMotion,
}

impl CyclesAlongKey<'_> {
    fn settings(&self) -> CycleSettings {
        let harmonics = HarmonicCount::Fixed(self.harmonics);
        CycleSettings { harmonics, samples: self.samples, backbone: self.backbone }
    }

    /// The smallest and the largest value.
    pub(super) fn range(&self) -> [f64; 2] {
        let values = || self.sweep.values.iter().copied();
        [values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max)]
    }

    /// What is to be said of a value.
    pub(super) fn told(&self, value: f64, words: &str) -> String {
        format!("{} = {}: {words}", self.sweep.path, self.sweep.text(value))
    }

    /// The assembly at a value.
    pub(super) fn assembly(&self, value: f64) -> Result<Assembly, CyclesError> {
        let built = self.family.assembly(&[value]);
        built.map_err(|error| CyclesError::NoAssembly { value, reason: error.to_string() })
    }

    /// The cycle at a value of the mode with the eigenvalue that is chosen there; in words why there is none.
    pub(super) fn of_mode(
        &self,
        value: f64,
        chosen: impl FnOnce(&SlidingState) -> Result<Complex64, ModelError>,
    ) -> Result<Result<FirstCycle, String>, ModelError> {
        let found = self.family.state(&[value]).and_then(|state| {
            let eigenvalue = chosen(&state)?;
            Ok((state.steady, eigenvalue, self.family.assembly(&[value])?))
        });
        let (steady, eigenvalue, assembly) = match in_words(found)? {
            Ok(found) => found,
            Err(reason) => return Ok(Err(reason)),
        };
        let sought = CycleOfMode::new(&assembly, &steady, eigenvalue, &self.settings(), self.progress)?;
        let none = || sought.reason().unwrap_or_default();
        let motion = sought.cycle().ok_or_else(none).and_then(whole);
        drop(sought);
        Ok(motion.map(|motion| FirstCycle { value, assembly, steady, frequency: eigenvalue.im, motion }))
    }

    /// The cycle at a value to which a march leads; in words why there is none.
    pub(super) fn near_march(
        &self,
        value: f64,
        start: &CycleStart,
    ) -> Result<Result<FirstCycle, String>, ModelError> {
        let found = self.family.state(&[value]);
        let found = found.and_then(|state| Ok((state.steady, self.family.built(&[value])?)));
        let (steady, built) = match in_words(found)? {
            Ok(found) => found,
            Err(reason) => return Ok(Err(reason)),
        };
        let subject = self.family.subject(&built);
        let found = start.cycle(&subject, &steady, &self.settings(), self.progress)?;
        let motion = found.map_err(|error| error.to_string()).and_then(|cycle| whole(&cycle));
        Ok(motion.map(|motion| {
            let frequency = motion.turning.frequency;
            FirstCycle { value, assembly: built.assembly, steady, frequency, motion }
        }))
    }

    /// The equations of all cycles of the branch through the first.
    pub(super) fn balance<'f>(&self, first: &'f FirstCycle) -> Result<HarmonicBalance<'f>, CyclesError> {
        let series = Series::new(self.harmonics, self.samples * self.harmonics);
        HarmonicBalance::new(&first.assembly, &first.steady, first.frequency, series, &[])
    }

    fn branch_settings(&self, rises: bool) -> BranchSettings {
        let measure = KeyMeasure::of(self.sweep);
        let range = self.range().map(|value| measure.of_value(value));
        let longest = 1.0 / self.sweep.values.len().max(10) as f64;
        let rule =
            PathRule { steps: [0.2 * longest, longest, 1e-7], tolerance: SOLVED, ..PathRule::default() };
        BranchSettings { rule, range, unit: range[1] - range[0], rises, points: self.most }
    }

    /// What a fold of this place of the list may be off, by the path and by what the harmonics leave out; not a number where it is not found with twice as many.
    pub(super) fn fold_error(
        &self,
        balance: &HarmonicBalance<'_>,
        branch: &AssemblyCycleBranch,
        place: usize,
    ) -> Result<f64, CyclesError> {
        let measure = KeyMeasure::of(self.sweep);
        let (cycle, _) = branch.folds[place];
        let around = [cycle - 1, cycle, cycle + 1].map(|k| {
            let own = &branch.cycles[k];
            CycleAtKey { parameter: measure.of_value(own.parameter), ..own.clone() }
        });
        let at = |measured: f64| self.assembly(measure.value(measured));
        let (settings, go_on) = (self.branch_settings(true), || !self.progress.interrupted());
        match refined_fold(&at, balance, around.each_ref(), &settings, &go_on) {
            Ok(refined) => {
                let left_out = branch.fold_error(place, measure.value(refined));
                let (cycle, fold) = branch.folds[place];
                let [_, of_the_path] = with_error(branch, fold, cycle - 1, 3);
                Ok(if left_out.is_nan() { left_out } else { left_out.max(of_the_path) })
            }
            Err(CyclesError::Stopped) => Err(CyclesError::Stopped),
            Err(_) => Ok(f64::NAN),
        }
    }

    /// The branch through the first cycle, to where the key rises at first or falls.
    pub(super) fn branch(
        &self,
        first: &FirstCycle,
        balance: &HarmonicBalance<'_>,
        rises: bool,
    ) -> Result<AssemblyCycleBranch, CyclesError> {
        let (measure, settings) = (KeyMeasure::of(self.sweep), self.branch_settings(rises));
        let begins = (measure.of_value(first.value), &first.motion);
        let at = |measured: f64| self.assembly(measure.value(measured));
        let go_on = || !self.progress.interrupted();
        Ok(measure.in_values(cycle_branch(&at, balance, begins, &settings, &go_on)?, self.range()))
    }
}

/// What was found, or in words why it was not, which an interruption is not.
fn in_words<T>(found: Result<T, ModelError>) -> Result<Result<T, String>, ModelError> {
    match found {
        Err(ModelError::Interrupted) => Err(ModelError::Interrupted),
        found => Ok(found.map_err(|error| error.to_string())),
    }
}

/// The motion of a cycle that has all harmonics.
fn whole(cycle: &AssemblyCycle<'_>) -> Result<PeriodicMotion, String> {
    match &cycle.held_back {
        Some(error) => Err(format!("its cycle was not found with all harmonics: {error}")),
        None => Ok(cycle.motion.clone()),
    }
}

/// How well the equations of cycles are solved, over the largest normal force.
pub(super) const SOLVED: f64 = 1e-8;
/// What a place of a branch may be off, of the way of the key to the cycles around it: it is known to a thousandth of the way along the branch, which at a kink is no steeper than ten
/// times as steep as it is on average; where it turns smoothly that is far more than it is off.
const WAY: f64 = 0.01;

/// A place of a branch near so many of its cycles from one on, and what it may be off.
fn with_error(branch: &AssemblyCycleBranch, value: f64, first: usize, count: usize) -> [f64; 2] {
    let around = branch.cycles.iter().skip(first).take(count);
    [value, WAY * around.map(|own| (own.parameter - value).abs()).fold(0.0, f64::max)]
}

/// Where cycles of another branch may cross, and what that may be off.
pub(super) fn branch_point_with_error(branch: &AssemblyCycleBranch, point: &CycleBranchPoint) -> [f64; 2] {
    with_error(branch, point.parameter, point.cycle, 2)
}

/// How lengths along a key are measured: by its logarithm where its `scale` is that.
#[derive(Clone, Copy)]
struct KeyMeasure {
    /// That of all values, where they are measured by the logarithm of their magnitude.
    sign: Option<f64>,
}

impl KeyMeasure {
    fn of(sweep: &KeySweep) -> Self {
        let sign = sweep.values.first().map_or(1.0, |own| own.signum());
        let has_one = sweep.values.iter().all(|own| own * sign > 0.0);
        Self { sign: (sweep.scale == Spacing::Log && has_one).then_some(sign) }
    }

    fn of_value(self, value: f64) -> f64 {
        self.sign.map_or(value, |sign| sign * libm::log(sign * value))
    }

    fn value(self, measured: f64) -> f64 {
        self.sign.map_or(measured, |sign| sign * libm::exp(sign * measured))
    }

    /// A branch with the values of the key in place of their measures; those of cycles at an end of the range are that itself.
    fn in_values(self, mut branch: AssemblyCycleBranch, [from, to]: [f64; 2]) -> AssemblyCycleBranch {
        let folds = branch.folds.iter_mut().map(|(_, own)| own);
        let points = branch.branch_points.iter_mut().map(|own| &mut own.parameter);
        folds.chain(points).for_each(|own| *own = self.value(*own));
        for cycle in &mut branch.cycles {
            let end = [from, to].into_iter().find(|end| self.of_value(*end) == cycle.parameter);
            cycle.parameter = end.unwrap_or_else(|| self.value(cycle.parameter));
        }
        branch
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn measures_rise_with_values_and_lead_back() {
        for (sign, values) in [(None, [-2.0, 3.0]), (Some(1.0), [0.5, 2.0]), (Some(-1.0), [-2.0, -0.5])] {
            let measure = KeyMeasure { sign };
            let [from, to] = values.map(|value| measure.of_value(value));
            assert!(from < to);
            for value in values {
                assert!((measure.value(measure.of_value(value)) - value).abs() < 1e-15 * value.abs());
            }
        }
    }
}
