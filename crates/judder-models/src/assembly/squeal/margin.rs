//! How far beyond the onset of a mode its cycles reach: the global margin.

use super::margin_told::{CycleReach, MarginEnd, MarginOfOnset};
use super::settings::AssemblySqueal;
use crate::assembly::AssemblySubject;
use crate::assembly::eigen::band;
use crate::assembly::eigen_sweep::solved::SolvedSweep;
use crate::assembly::limit_cycle::search::CycleOfMode;
use crate::assembly::meant_mode::near_frequency;
use crate::assembly::swept::{ALL_FRICTION, SweptAssembly};
use crate::error::ModelError;
use crate::key_sweep::KeySweep;
use judder_assembly::assembly::Assembly;
use judder_assembly::steady::SteadySliding;
use judder_cycles::CyclesError;
use judder_cycles::backbone::{BackboneSettings, PeriodicMotion};
use judder_cycles::balance::HarmonicBalance;
use judder_cycles::branch::{AssemblyCycleBranch, BranchSettings, CycleAtKey, CycleBranchEnd, cycle_branch};
use judder_cycles::cycle::{CycleSettings, HarmonicCount};
use judder_cycles::path::PathRule;
use judder_cycles::series::Series;
use judder_structure::complex_modes::Verdict;
use judder_structure::eigen_sweep::{SweepMethod, SweptEigenvalues};
use judder_structure::onset::{Onset, OnsetKind};
use judder_study::{Progress, Untold};
use num_complex::Complex64;
use rayon::prelude::*;
use std::f64::consts::TAU;

/// Margins of all onsets of a band.
pub(super) struct SoughtMargins {
    /// The value of the key in the case.
    pub(super) own: f64,
    /// By rising value of the onset.
    pub(super) onsets: Vec<MarginOfOnset>,
    /// Why there may be other onsets.
    pub(super) doubt: Option<String>,
}

/// Between the onset and the farthest value on the growing side, where a first cycle is sought, the farthest first; the last ones lie on the other side.
const TRIED: [f64; 6] = [1.0, 0.5, 0.25, 0.1, -0.02, -0.1];
/// The most cycles of a branch.
const CYCLES: usize = 400;

/// The value of the swept key in the case.
fn own_value(of: &AssemblySubject<'_>, sweep: &KeySweep) -> Option<f64> {
    match sweep.path.as_str() {
        ALL_FRICTION => Some(1.0),
        path => of.case.number(path).map(|(value, _)| value),
    }
}

/// The margin of every onset over the range, those of these modes, which grow with the case as it is, among them.
pub(super) fn margins(
    of: &AssemblySubject<'_>,
    asked: &AssemblySqueal,
    sweep: &KeySweep,
    modes: &[Complex64],
    progress: &dyn Progress,
) -> Result<SoughtMargins, ModelError> {
    let own = own_value(of, sweep).unwrap_or(f64::NAN);
    let mut values = sweep.values.clone();
    values.sort_by(f64::total_cmp);
    let range = [values[0], values[values.len() - 1]];
    if range[0] < own && own < range[1] && !values.contains(&own) {
        values.insert(values.partition_point(|value| *value < own), own);
    }
    let family = SweptAssembly::new(of, vec![sweep], true);
    let region = band(asked.band[0], asked.band[1]);
    let solved = SolvedSweep::new(&family, &values, SweepMethod::Full, &region, &Untold(progress))?;
    let along = AlongMarginKey { progress, asked, sweep, family: &family, range, own };
    let branches = FollowedModes { values: &values, sweep: &solved.sweep, own, modes };
    let flutter = solved.onsets.onsets.iter().filter(|own| own.kind == OnsetKind::Flutter);
    let onsets: Vec<(&Onset, Option<usize>)> =
        flutter.map(|onset| (onset, branches.mode_of(onset))).collect();
    // all of them, so that of several errors the first is told
    let onsets: Vec<Result<MarginOfOnset, ModelError>> = onsets
        .par_iter()
        .map(|(onset, mode)| {
            progress.go_on()?;
            let reach = along.reach(onset, mode.map(|mode| modes[mode]))?;
            Ok(MarginOfOnset::new(onset, *mode, reach, own))
        })
        .collect();
    let onsets = onsets.into_iter().collect::<Result<_, _>>()?;
    Ok(SoughtMargins { own, onsets, doubt: solved.onsets.warning() })
}

/// Modes followed along the key.
struct FollowedModes<'a> {
    values: &'a [f64],
    sweep: &'a SweptEigenvalues,
    own: f64,
    modes: &'a [Complex64],
}

impl FollowedModes<'_> {
    /// Which of the modes that grow with the case as it is begins to grow at an onset, without ceasing to in between.
    fn mode_of(&self, onset: &Onset) -> Option<usize> {
        let above = self.values.partition_point(|value| *value <= onset.value);
        let first = if onset.gains { above.checked_sub(1)? } else { above };
        let last = self.values.iter().position(|value| *value == self.own)?;
        let grows = |verdict: Verdict| verdict == Verdict::Unstable;
        let off = |value: Complex64| (value.im - TAU * onset.frequency_hz).abs();
        let at_first = self.sweep.points.get(first)?.eigenvalues.iter();
        let branch = at_first
            .filter(|own| grows(own.eigenvalue.verdict()))
            .min_by(|a, b| off(a.eigenvalue.value).total_cmp(&off(b.eigenvalue.value)))?
            .branch;
        let between = if onset.gains { last..=first } else { first..=last };
        let value_at = |place: usize| {
            let own = self.sweep.points[place].eigenvalues.iter().find(|own| own.branch == branch)?;
            grows(own.eigenvalue.verdict()).then_some(own.eigenvalue.value)
        };
        if between.is_empty() || !between.clone().all(|place| value_at(place).is_some()) {
            return None;
        }
        let value = value_at(last)?;
        let beside = |mode: usize| (self.modes[mode] - value).norm();
        let nearest = (0..self.modes.len()).min_by(|a, b| beside(*a).total_cmp(&beside(*b)))?;
        (beside(nearest) < 1e-3 * value.norm()).then_some(nearest)
    }
}

/// What is followed along the key.
struct AlongMarginKey<'a> {
    progress: &'a dyn Progress,
    asked: &'a AssemblySqueal,
    sweep: &'a KeySweep,
    family: &'a SweptAssembly<'a>,
    range: [f64; 2],
    own: f64,
}

/// Where a branch begins.
struct OnsetCycle {
    value: f64,
    assembly: Assembly,
    steady: SteadySliding,
    frequency: f64,
    motion: PeriodicMotion,
}

impl AlongMarginKey<'_> {
    /// How far the cycles of the mode of an onset reach; that mode has this eigenvalue with the case as it is, where it grows there.
    fn reach(&self, onset: &Onset, mode: Option<Complex64>) -> Result<CycleReach, ModelError> {
        let grows_above = !onset.gains;
        let farthest = match mode {
            Some(_) => self.own,
            None => self.range[usize::from(grows_above)],
        };
        let mut reasons = Vec::new();
        let mut partly: Option<CycleReach> = None;
        for share in TRIED {
            let value = onset.value + share * (farthest - onset.value);
            if value < self.range[0] || value > self.range[1] {
                continue;
            }
            let own = mode.filter(|_| share == 1.0);
            match self.first(value, TAU * onset.frequency_hz, own)? {
                Ok(first) => {
                    let reach = self.followed(onset, &first)?;
                    if reach.end.is_whole() {
                        return Ok(reach);
                    }
                    // one that turns before the onset is not the branch that begins there
                    partly.get_or_insert(reach);
                }
                Err(reason) => {
                    reasons.push(format!("{} = {}: {reason}", self.sweep.path, self.sweep.text(value)));
                }
            }
        }
        let none = || {
            let words = "no limit cycle was found to begin with".to_owned();
            CycleReach::unknown(std::iter::once(words).chain(reasons).collect::<Vec<_>>().join("; "))
        };
        Ok(partly.unwrap_or_else(none))
    }

    /// The cycle at a value of the mode near a frequency, or of that with an eigenvalue; in words why there is none.
    fn first(
        &self,
        value: f64,
        frequency: f64,
        mode: Option<Complex64>,
    ) -> Result<Result<OnsetCycle, String>, ModelError> {
        let found = self.family.state(&[value]).and_then(|state| {
            let mode = match mode {
                Some(own) => own,
                None => near_frequency(&self.family.about(&state)?, frequency)?.eigenvalue.value,
            };
            Ok((state.steady, mode, self.family.assembly(&[value])?))
        });
        let (steady, mode, assembly) = match found {
            Ok(found) => found,
            Err(ModelError::Interrupted) => return Err(ModelError::Interrupted),
            Err(error) => return Ok(Err(error.to_string())),
        };
        let backbone =
            BackboneSettings { largest: self.asked.solver.largest_amplitude, ..BackboneSettings::default() };
        let harmonics = HarmonicCount::Fixed(self.asked.margin_harmonics());
        let settings = CycleSettings { harmonics, samples: self.asked.solver.samples, backbone };
        let sought = CycleOfMode::new(&assembly, &steady, mode, &settings, self.progress)?;
        let motion = match sought.cycle() {
            None => return Ok(Err(sought.reason().unwrap_or_default())),
            Some(_) if sought.held_back().is_some() => {
                return Ok(Err(sought.held_back().unwrap_or_default()));
            }
            Some(cycle) => cycle.motion.clone(),
        };
        drop(sought);
        Ok(Ok(OnsetCycle { value, assembly, steady, frequency: mode.im, motion }))
    }

    /// The branch through a cycle towards the side on which steady sliding is stable.
    fn followed(&self, onset: &Onset, first: &OnsetCycle) -> Result<CycleReach, ModelError> {
        let [from, to] = self.range;
        let harmonics = self.asked.margin_harmonics();
        let series = Series::new(harmonics, self.asked.solver.samples * harmonics);
        let balance = HarmonicBalance::new(&first.assembly, &first.steady, first.frequency, series, &[])?;
        let at = |value: f64| {
            let built = self.family.assembly(&[value]);
            built.map_err(|error| CyclesError::NoAssembly { value, reason: error.to_string() })
        };
        let longest = 1.0 / self.sweep.values.len().max(10) as f64;
        let rule = PathRule { steps: [0.2 * longest, longest, 1e-7], tolerance: 1e-8, ..PathRule::default() };
        let settings =
            BranchSettings { rule, range: [from, to], unit: to - from, rises: onset.gains, points: CYCLES };
        let go_on = || !self.progress.interrupted();
        let begins = (first.value, &first.motion);
        let branch = match cycle_branch(&at, &balance, begins, &settings, &go_on) {
            Ok(branch) => branch,
            Err(CyclesError::Stopped) => return Err(ModelError::Interrupted),
            Err(error) => {
                return Ok(CycleReach::unknown(format!("the branch of cycles was not begun: {error}")));
            }
        };
        Ok(self.read(onset, &branch))
    }

    /// What a branch says of the margin.
    fn read(&self, onset: &Onset, branch: &AssemblyCycleBranch) -> CycleReach {
        /// What the end of a branch may be off the onset, and what reaches beyond it at least, of the range.
        const SAME: f64 = 0.01;
        /// What their frequencies may differ by, of that of the onset.
        const ALIKE: f64 = 0.02;
        const SMALLEST: f64 = 1e-6;
        let [from, to] = self.range;
        // rising towards the side on which steady sliding is stable
        let sign = if onset.gains { 1.0 } else { -1.0 };
        let beyond = |value: f64| sign * (value - onset.value);
        let inside = branch.cycles.iter().map(|own| own.parameter).filter(|own| (from..=to).contains(own));
        let reaches = inside.max_by(|a, b| beyond(*a).total_cmp(&beyond(*b)));
        let last = branch.cycles.last().map_or(f64::NAN, |own| own.parameter);
        let off = |own: &CycleAtKey| (own.motion.turning.frequency / (TAU * onset.frequency_hz) - 1.0).abs();
        let is_alike = branch.cycles.last().is_some_and(|own| off(own) <= ALIKE);
        let end = match &branch.end {
            CycleBranchEnd::SteadySliding if is_alike && beyond(last).abs() <= SAME * (to - from) => {
                MarginEnd::Onset
            }
            CycleBranchEnd::SteadySliding => MarginEnd::OtherOnset(last),
            CycleBranchEnd::Range if beyond(last) < 0.0 => match reaches.map(beyond) {
                Some(most) if most > 0.0 => MarginEnd::Growing,
                _ => MarginEnd::Before(reaches.unwrap_or(last)),
            },
            CycleBranchEnd::Range => MarginEnd::Range,
            CycleBranchEnd::Points => MarginEnd::Points,
            CycleBranchEnd::Lost(error) => MarginEnd::Lost(error.to_string()),
        };
        let least = onset.error.max(SMALLEST * (to - from));
        let is_beyond = reaches.is_some_and(|value| beyond(value) > least);
        let fold = if end.is_whole() && is_beyond { outermost(branch, beyond) } else { None };
        CycleReach { fold, reaches, end }
    }
}

/// Where a branch reaches farthest beyond an onset, by a parabola over the amplitude through the cycles around the outermost one, and what that may be off. Where contact
/// points change what they do the branch has kinks, at which its direction does not tell that it turns.
fn outermost(branch: &AssemblyCycleBranch, beyond: impl Fn(f64) -> f64) -> Option<(f64, f64)> {
    /// Of the differences to both neighbours: what is less alike is no parabola.
    const KINK: f64 = 20.0;
    let value = |place: usize| branch.cycles[place].parameter;
    let middle = (0..branch.cycles.len()).max_by(|a, b| beyond(value(*a)).total_cmp(&beyond(value(*b))))?;
    let own = value(middle);
    let (Some(before), Some(after)) = (middle.checked_sub(1), branch.cycles.get(middle + 1)) else {
        return Some((own, f64::NAN));
    };
    let before = &branch.cycles[before];
    let amplitude = branch.cycles[middle].motion.amplitude;
    let [a, b] = [before, after].map(|own| own.motion.amplitude - amplitude);
    let [p, q] = [before, after].map(|other| other.parameter - own);
    // p(x) = s x + c x² through both neighbours
    let curvature = (p / a - q / b) / (a - b);
    let slope = p / a - curvature * a;
    let rise = -0.25 * slope * slope / curvature;
    let is_turn = rise.is_finite() && a * b < 0.0 && beyond(own + rise) >= beyond(own);
    // at a kink the branch goes on from one side as a line at most to the amplitude of the other
    let [least, most] = [p.abs().min(q.abs()), p.abs().max(q.abs())];
    let line = (p / a * b).abs().min((q / b * a).abs());
    Some(if is_turn && most < KINK * least { (own + rise, rise.abs()) } else { (own, line) })
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use judder_cycles::balance::CycleRate;

    /// x = 0.3 + (a − 1.7)², whose turn is known.
    #[test]
    fn a_turn_is_that_of_the_parabola() {
        let at = |amplitude: f64| {
            let parameter = 0.3 + (amplitude - 1.7) * (amplitude - 1.7);
            let turning = CycleRate { frequency: 1.0, growth: 0.0 };
            let motion = PeriodicMotion { unknown: Vec::new(), turning, amplitude, residual: 0.0 };
            CycleAtKey { parameter, motion, rises: amplitude < 1.7 }
        };
        let cycles: Vec<CycleAtKey> = [2.4, 2.0, 1.8, 1.5, 1.0].map(at).to_vec();
        let branch = AssemblyCycleBranch {
            branch_points: Vec::new(),
            folds: vec![(2, cycles[2].parameter)],
            cycles,
            end: CycleBranchEnd::Range,
        };
        let (fold, error) = outermost(&branch, |value| 0.5 - value).unwrap();
        assert!((fold - 0.3).abs() < 1e-12 && (error - 0.01).abs() < 1e-12, "{fold} {error}");
    }
}
