//! How far beyond the onset of a mode its cycles reach: the global margin.

use super::known_margin::MarginOfOnset;
use super::margin_stability::StabilityOnBranch;
use super::margin_told::{CycleReach, MarginEnd};
use super::settings::AssemblySqueal;
use crate::assembly::AssemblySubject;
use crate::assembly::branch_checks::ShrunkAt;
use crate::assembly::cycles_along_key::{CyclesAlongKey, FirstCycle};
use crate::assembly::eigen::band;
use crate::assembly::eigen_sweep::solved::SolvedSweep;
use crate::assembly::meant_mode::near_frequency;
use crate::assembly::swept::{ALL_FRICTION, SlidingState, SweptAssembly};
use crate::error::ModelError;
use crate::key_sweep::KeySweep;
use crate::structure::eigen_sweep::kept_points::KeptPoints;
use judder_cycles::CyclesError;
use judder_cycles::backbone::BackboneSettings;
use judder_cycles::balance::HarmonicBalance;
use judder_cycles::branch::{AssemblyCycleBranch, CycleAtKey, CycleBranchEnd};
use judder_numerics::complex::ElementaryComplex;
use judder_numerics::order::sort_numbers;
use judder_numerics::parallel;
use judder_structure::complex_modes::Verdict;
use judder_structure::eigen_sweep::{SweepMethod, SweptEigenvalues};
use judder_structure::onset::{Onset, OnsetKind};
use judder_study::kept::KeptLines;
use judder_study::{Progress, Untold};
use num_complex::Complex64;
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
    (kept, progress): (KeptLines<'_>, &dyn Progress),
) -> Result<SoughtMargins, ModelError> {
    let kept = KeptPoints::of("points of the margin", kept);
    let own = own_value(of, sweep).unwrap_or(f64::NAN);
    let mut values = sweep.values.clone();
    sort_numbers(&mut values);
    let range = [values[0], values[values.len() - 1]];
    if range[0] < own && own < range[1] && !values.contains(&own) {
        values.insert(values.partition_point(|value| *value < own), own);
    }
    let family = SweptAssembly::new(of, vec![sweep], true);
    let region = band(asked.band[0], asked.band[1]);
    let solved = SolvedSweep::new(&family, &values, SweepMethod::Full, &region, (&kept, &Untold(progress)))?;
    let along = CyclesAlongKey {
        family: &family,
        sweep,
        harmonics: asked.margin_harmonics(),
        samples: asked.solver.samples,
        backbone: BackboneSettings { largest: asked.solver.largest_amplitude, ..BackboneSettings::default() },
        most: CYCLES,
        progress,
    };
    let along = AlongMarginKey { along, range, own, is_stability_asked: asked.solver.stability };
    let branches = FollowedModes { values: &values, sweep: &solved.sweep, own, modes };
    let flutter = solved.onsets.onsets.iter().filter(|own| own.kind == OnsetKind::Flutter);
    let onsets: Vec<(&Onset, Option<usize>)> =
        flutter.map(|onset| (onset, branches.mode_of(onset))).collect();
    let onsets = parallel::try_each(&onsets, |(onset, mode)| {
        progress.go_on()?;
        let reach = along.reach(onset, mode.map(|mode| modes[mode]))?;
        Ok::<_, ModelError>(MarginOfOnset::new(onset, *mode, reach, own))
    })?;
    Ok(SoughtMargins { own, onsets, doubt: solved.onsets.warning(&|value| sweep.text(value)) })
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
        let beside = |mode: usize| (self.modes[mode] - value).modulus();
        let nearest = (0..self.modes.len()).min_by(|a, b| beside(*a).total_cmp(&beside(*b)))?;
        (beside(nearest) < 1e-3 * value.modulus()).then_some(nearest)
    }
}

/// What is followed along the key.
struct AlongMarginKey<'a> {
    along: CyclesAlongKey<'a>,
    range: [f64; 2],
    own: f64,
    /// Whether it is told of cycles if motions nearby are drawn to them.
    is_stability_asked: bool,
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
            let chosen = |state: &SlidingState| match own {
                Some(own) => Ok(own),
                None => {
                    let about = self.along.family.about(state)?;
                    Ok(near_frequency(&about, TAU * onset.frequency_hz)?.eigenvalue.value)
                }
            };
            match self.along.of_mode(value, chosen)? {
                Ok(first) => {
                    let reach = self.followed(onset, &first, partly.is_none())?;
                    if reach.end.is_whole() {
                        return Ok(reach);
                    }
                    // one that turns before the onset is not the branch that begins there
                    partly.get_or_insert(reach);
                }
                Err(reason) => reasons.push(self.along.told(value, &reason)),
            }
        }
        let none = || {
            let words = "no limit cycle was found to begin with".to_owned();
            CycleReach::unknown(std::iter::once(words).chain(reasons).collect::<Vec<_>>().join("; "))
        };
        Ok(partly.unwrap_or_else(none))
    }

    /// The branch through a cycle towards the side on which steady sliding is stable; with the stability of its cycles where it is whole, or told even if it is not.
    fn followed(&self, onset: &Onset, first: &FirstCycle, is_told: bool) -> Result<CycleReach, ModelError> {
        let balance = self.along.balance(first)?;
        match self.along.branch(first, &balance, onset.gains) {
            Ok(branch) => {
                let mut reach = self.with_fold_error(&balance, &branch, self.read(onset, &branch))?;
                if self.is_stability_asked && (is_told || reach.end.is_whole()) {
                    let sign = if onset.gains { 1.0 } else { -1.0 };
                    let beyond = |value: f64| sign * (value - onset.value) - onset.error;
                    reach.stability =
                        StabilityOnBranch::of(&self.along, &balance, &branch, self.range, beyond)?;
                }
                Ok(reach)
            }
            Err(CyclesError::Stopped) => Err(ModelError::Interrupted),
            Err(error) => Ok(CycleReach::unknown(format!("the branch of cycles was not begun: {error}"))),
        }
    }

    /// With what the fold may be off.
    fn with_fold_error(
        &self,
        balance: &HarmonicBalance<'_>,
        branch: &AssemblyCycleBranch,
        mut reach: CycleReach,
    ) -> Result<CycleReach, ModelError> {
        let Some([fold, error]) = &mut reach.fold else { return Ok(reach) };
        if let Some(place) = branch.folds.iter().position(|(_, own)| own == fold) {
            *error = self.along.fold_error(balance, branch, place)?;
        }
        Ok(reach)
    }

    /// What a branch says of the margin, but for what its fold may be off.
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
        let folds = branch.folds.iter().map(|(_, fold)| *fold);
        let outermost = folds.max_by(|a, b| beyond(*a).total_cmp(&beyond(*b)));
        let fold = match reaches.filter(|_| end.is_whole() && is_beyond) {
            // one that turns at its first cycle has no fold there
            Some(reached) => {
                outermost.filter(|fold| beyond(*fold) >= beyond(reached) - least).or(Some(reached))
            }
            None => None,
        };
        CycleReach {
            fold: fold.map(|fold| [fold, f64::NAN]),
            reaches,
            end,
            residuals: branch.cycles.iter().map(|own| own.motion.residual).collect(),
            shrunk: ShrunkAt::of(self.along.family, branch),
            stability: StabilityOnBranch::default(),
        }
    }
}
