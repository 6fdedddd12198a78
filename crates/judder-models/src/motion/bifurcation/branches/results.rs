//! What branches leave: scalars, arrays, a check, warnings.

use super::{Branches, DiagramBranch};
use crate::error::ModelError;
use crate::motion::si::SiUnits;
use judder_oscillator::motion::ContactState;
use judder_store::{Dataset, Results, Variable};
use judder_study::outcome::{CheckRecord, Disagreement};

/// What is told of branches.
#[derive(Results)]
pub(crate) struct ToldBranches {
    hopf_points: Vec<ToldHopf>,
    branches: Vec<ToldBranch>,
}

/// Where steady sliding loses its stability.
#[derive(Results)]
struct ToldHopf {
    value: f64,
    #[result(unit = "1")]
    frequency: f64,
    #[result(unit = "1")]
    lyapunov_coefficient: f64,
    criticality: &'static str,
    #[result(optional, unit = "Hz")]
    frequency_hz: Option<f64>,
}

/// The cycles of a branch, one after the other.
#[derive(Results)]
struct ToldBranch {
    /// where it starts, in words
    from: String,
    oscillations: Option<usize>,
    value: Vec<f64>,
    #[result(unit = "1")]
    rms: Vec<f64>,
    #[result(unit = "1")]
    period: Vec<f64>,
    stable: Vec<bool>,
    folds: Vec<f64>,
    pattern_changes: Vec<PatternChangeRow>,
    /// where it ends, in words
    end: String,
    #[result(optional, unit = "m")]
    rms_m: Option<Vec<f64>>,
    #[result(optional, unit = "s")]
    period_s: Option<Vec<f64>>,
}

/// Where neighbours have different patterns: both values and both patterns.
#[derive(Results)]
struct PatternChangeRow {
    between: [f64; 2],
    from: Vec<String>,
    to: Vec<String>,
}

/// A cycle of a branch as results tell it; the Hopf point where a branch begins is the first, with no amplitude.
struct BranchCycle {
    value: f64,
    rms: f64,
    period: f64,
    is_stable: bool,
    largest_multiplier: f64,
}

impl<const N: usize> DiagramBranch<N> {
    fn told(&self) -> Vec<BranchCycle> {
        let first_stable = self.points.first().is_some_and(|point| point.cycle.is_stable());
        let hopf = self.hopf.map(|(value, period)| BranchCycle {
            value,
            rms: 0.0,
            period,
            is_stable: first_stable,
            largest_multiplier: 1.0,
        });
        let cycles = self.points.iter().map(|point| BranchCycle {
            value: point.parameter,
            rms: point.cycle.around.measures.rms(),
            period: point.cycle.period(),
            is_stable: point.cycle.is_stable(),
            largest_multiplier: point.cycle.largest_multiplier(),
        });
        hopf.into_iter().chain(cycles).collect()
    }

    /// Where neighbours have different patterns.
    fn pattern_changes(&self) -> Vec<PatternChangeRow> {
        let words =
            |pattern: &[ContactState]| pattern.iter().map(ToString::to_string).collect::<Vec<String>>();
        let changes = self.points.windows(2).filter_map(|pair| {
            let (before, behind) = (&pair[0].cycle.around.pattern, &pair[1].cycle.around.pattern);
            (before != behind).then(|| PatternChangeRow {
                between: [pair[0].parameter, pair[1].parameter],
                from: words(before),
                to: words(behind),
            })
        });
        changes.collect()
    }

    fn told_branch(&self, units: impl Fn(f64) -> Option<SiUnits>) -> ToldBranch {
        let told = self.told();
        let numbers = |of: fn(&BranchCycle) -> f64| told.iter().map(of).collect::<Vec<f64>>();
        let in_si = |of: fn(&BranchCycle, SiUnits) -> f64| {
            told.iter().map(|own| Some(of(own, units(own.value)?))).collect::<Option<Vec<f64>>>()
        };
        ToldBranch {
            from: self.from.clone(),
            oscillations: self.points.first().map(|point| point.cycle.oscillations),
            value: numbers(|t| t.value),
            rms: numbers(|t| t.rms),
            period: numbers(|t| t.period),
            stable: told.iter().map(|t| t.is_stable).collect(),
            folds: self.folds.iter().map(|fold| fold.parameter).collect(),
            pattern_changes: self.pattern_changes(),
            end: self.end.clone(),
            rms_m: in_si(|own, units| own.rms * units.metre),
            period_s: in_si(|own, units| own.period * units.second),
        }
    }

    /// Value and rms of each fold, the latter between its neighbours.
    fn turns(&self) -> impl Iterator<Item = (f64, f64)> {
        self.folds.iter().map(|fold| {
            let nearest = |a: &&_, b: &&_| {
                let away = |point: &judder_oscillator::cycle::BranchPoint<N>| {
                    (point.parameter - fold.parameter).abs()
                };
                away(a).total_cmp(&away(b))
            };
            let rms = self.points.iter().min_by(nearest).map(|point| point.cycle.around.measures.rms());
            (fold.parameter, rms.unwrap_or(f64::NAN))
        })
    }
}

impl<const N: usize> Branches<N> {
    /// What is told; `units` are those at a value of the swept key.
    pub(crate) fn told(&self, units: impl Fn(f64) -> Option<SiUnits>) -> ToldBranches {
        let hopf_points = self.hopf_points.iter().map(|point| ToldHopf {
            value: point.value,
            frequency: point.hopf.frequency,
            lyapunov_coefficient: point.hopf.coefficient,
            criticality: match (point.hopf.is_degenerate(), point.hopf.is_subcritical()) {
                (true, _) => "degenerate",
                (false, true) => "subcritical",
                (false, false) => "supercritical",
            },
            frequency_hz: units(point.value).map(|units| units.hertz(point.hopf.frequency)),
        });
        ToldBranches {
            hopf_points: hopf_points.collect(),
            branches: self.branches.iter().map(|branch| branch.told_branch(&units)).collect(),
        }
    }

    pub(crate) fn add_arrays(&self, dataset: Dataset) -> Result<Dataset, ModelError> {
        let turns: Vec<(f64, f64)> = self.branches.iter().flat_map(DiagramBranch::turns).collect();
        let hopf = self.hopf_points.iter().map(|point| point.value).collect();
        let marks = [
            along("steady_point", "steady_value", "swept value", self.growth.iter().map(|g| g.0).collect()),
            along(
                "steady_point",
                "growth_rate",
                "growth rate of steady sliding",
                self.growth.iter().map(|g| g.1).collect(),
            ),
            along("fold", "fold_value", "swept value at a fold", turns.iter().map(|t| t.0).collect()),
            along(
                "fold",
                "fold_rms",
                "rms of the cycle nearest to a fold",
                turns.iter().map(|t| t.1).collect(),
            ),
            along("hopf_point", "hopf_value", "swept value at a Hopf point", hopf),
        ];
        self.cycle_arrays()
            .into_iter()
            .chain(marks)
            .try_fold(dataset, |dataset, variable| Ok(dataset.with(variable)?))
    }

    /// The cycles of all branches, one branch after the other.
    fn cycle_arrays(&self) -> Vec<Variable> {
        let told: Vec<(usize, BranchCycle)> = self
            .branches
            .iter()
            .enumerate()
            .flat_map(|(k, branch)| branch.told().into_iter().map(move |told| (k, told)))
            .collect();
        let of = |pick: fn(&BranchCycle) -> f64| told.iter().map(|(_, t)| pick(t)).collect::<Vec<f64>>();
        let point = "branch_point";
        let stable: Vec<u8> = told.iter().map(|(_, t)| u8::from(t.is_stable)).collect();
        let number: Vec<i64> = told.iter().map(|(k, _)| *k as i64).collect();
        let meanings = [(0, "unstable"), (1, "stable")];
        vec![
            along(point, "branch_value", "swept value of a cycle on a branch", of(|t| t.value)),
            along(point, "branch_rms", "rms of x about its mean", of(|t| t.rms)),
            along(point, "branch_period", "period", of(|t| t.period)),
            along(
                point,
                "branch_multiplier",
                "magnitude of the largest Floquet multiplier",
                of(|t| t.largest_multiplier),
            ),
            Variable::classes("branch_stable", &[point], &[told.len()], stable, &meanings)
                .long_name("whether the cycle is stable"),
            Variable::new("branch_number", &[point], &[told.len()], number)
                .long_name("which branch, in the order of the summary"),
        ]
    }

    /// That what simulation finds is stable by its Floquet multipliers; `None` where no simulated cycle lies on a branch.
    pub(crate) fn check(&self) -> Option<CheckRecord> {
        let known: Vec<bool> = self.simulated.iter().flatten().copied().collect();
        let compared = format!(
            "number of {} simulated cycles that lie on a branch (rms and period to 3 %) where its multipliers say unstable",
            known.len()
        );
        (!known.is_empty()).then(|| {
            CheckRecord::new(
                "simulated cycles are stable on their branches",
                compared,
                Disagreement::exceptions(known.iter().map(|stable| !*stable)),
                0.0,
            )
        })
    }

    /// Starts from which no branch could be followed, and simulated cycles that lie on no branch.
    pub(crate) fn warnings(&self) -> Vec<String> {
        let failed = self
            .failed
            .first()
            .map(|first| format!("no branch from {} of the starts, for one: {first}", self.failed.len()));
        let alone = self.simulated.iter().filter(|stable| stable.is_none()).count();
        let alone = (alone > 0).then(|| {
            format!(
                "{alone} of {} simulated cycles lie on no branch that was followed; the ends of the branches say why",
                self.simulated.len()
            )
        });
        failed.into_iter().chain(alone).collect()
    }
}

fn along(dimension: &str, name: &str, long_name: &str, values: Vec<f64>) -> Variable {
    Variable::new(name, &[dimension], &[values.len()], values).units("1").long_name(long_name)
}
