//! Eigenvalues along a parameter as branches: what is told, stored and listed of them.

use super::super::eigen::run::{ToldMode, VERDICTS, code, gap_warnings, in_order};
use super::onsets::{LocatedOnsets, ToldDoubt, ToldOnset};
use crate::axis::Curves;
use crate::error::ModelError;
use judder_store::{Dataset, Results, Table, Variable};
use judder_structure::asked_region::AskedRegion;
use judder_structure::complex_modes::Verdict;
use judder_structure::eigen_sweep::{PointEigenvalues, SweptEigenvalues, Tracked};
use judder_study::axis::SweptAxis;
use judder_study::outcome::{CheckRecord, Disagreement};
use num_complex::Complex64;
use serde_json::{Map, Value, json};
use std::collections::BTreeSet;

/// Eigenvalues of a region along an axis.
pub(crate) struct SweptBranches<'a, I> {
    asked: &'a AskedRegion,
    axis: SweptAxis,
    curves: Curves<I>,
    /// One for each curve,
    pub(crate) sweeps: Vec<SweptEigenvalues>,
    /// and where modes begin or cease to grow along it.
    onsets: Vec<LocatedOnsets>,
}

/// What is told of one curve.
#[derive(Results)]
pub(crate) struct EigenvalueCurve {
    /// the values of the parameter
    value: Vec<f64>,
    /// the eigenvalues at each
    eigenvalues: Vec<Vec<OnBranch>>,
    /// whether it is proven that there are no more
    complete: bool,
    /// whether one grows, at each
    unstable: Vec<bool>,
    /// where modes begin or cease to grow
    onsets: Vec<ToldOnset>,
    /// between which values they may be others than those
    onsets_in_doubt: Vec<ToldDoubt>,
    branches: usize,
    /// values that were solved on the full matrices
    solved_in_full: usize,
}

/// An eigenvalue of a branch.
#[derive(Results)]
struct OnBranch {
    #[result(flatten)]
    mode: ToldMode,
    branch: usize,
}

impl EigenvalueCurve {
    /// What has the unit of the parameter, among what is told of it and of onsets.
    pub(crate) const OF_KEY: &[&str] = &["value", "error", "from", "to"];

    fn new(values: &[f64], sweep: &SweptEigenvalues, found: &LocatedOnsets) -> Self {
        let told = |own: &Tracked| OnBranch { mode: ToldMode::new(0, &own.eigenvalue), branch: own.branch };
        let is_unstable = |point: &PointEigenvalues| {
            point.eigenvalues.iter().any(|t| t.eigenvalue.verdict() == Verdict::Unstable)
        };
        Self {
            value: values.to_vec(),
            eigenvalues: sweep
                .points
                .iter()
                .map(|point| point.eigenvalues.iter().map(told).collect())
                .collect(),
            complete: sweep.points.iter().all(|point| point.gaps.is_empty()),
            unstable: sweep.points.iter().map(is_unstable).collect(),
            onsets: found.told(),
            onsets_in_doubt: found.doubts(),
            branches: sweep.branches,
            solved_in_full: sweep.points.iter().filter(|point| point.full).count(),
        }
    }
}

/// Numbers the branches that have eigenvalues, in the order in which they had been numbered.
fn renumber(sweep: &mut SweptEigenvalues) {
    let all = || sweep.points.iter().flat_map(|point| &point.eigenvalues);
    let numbers: BTreeSet<usize> = all().map(|tracked| tracked.branch).collect();
    let numbers: Vec<usize> = numbers.into_iter().collect();
    for tracked in sweep.points.iter_mut().flat_map(|point| &mut point.eigenvalues) {
        tracked.branch = numbers.binary_search(&tracked.branch).unwrap_or_default();
    }
    sweep.branches = numbers.len();
}

/// What stands where a branch has no eigenvalue.
const NONE: Complex64 = Complex64::new(f64::NAN, f64::NAN);
/// The code of a verdict where a branch has no eigenvalue.
const ABSENT: u8 = 3;

impl<'a, I> SweptBranches<'a, I> {
    /// Of the eigenvalues of every value those that are asked for, put in order.
    pub(crate) fn new(
        asked: &'a AskedRegion,
        axis: SweptAxis,
        curves: Curves<I>,
        mut sweeps: Vec<SweptEigenvalues>,
        onsets: Vec<LocatedOnsets>,
    ) -> Self {
        for point in sweeps.iter_mut().flat_map(|sweep| &mut sweep.points) {
            point.eigenvalues.retain(|tracked| asked.has(&tracked.eigenvalue));
            point.eigenvalues.sort_by(|a, b| in_order(&a.eigenvalue, &b.eigenvalue));
        }
        sweeps.iter_mut().for_each(renumber);
        let onsets = onsets.into_iter().map(|own| own.asked_of(asked)).collect();
        Self { asked, axis, curves, sweeps, onsets }
    }

    /// All points, curve by curve.
    pub(crate) fn points(&self) -> impl Iterator<Item = &PointEigenvalues> {
        self.sweeps.iter().flat_map(|sweep| &sweep.points)
    }

    /// At how many values eigenvalues may be missing.
    pub(crate) fn incomplete(&self) -> usize {
        self.points().filter(|point| !point.gaps.is_empty()).count()
    }

    /// That no eigenvalue is missing.
    pub(crate) fn completeness(&self) -> CheckRecord {
        CheckRecord::new(
            "no eigenvalue is missing",
            format!("values at which a check did not close, of {}", self.points().count()),
            Disagreement::exceptions(self.points().map(|point| !point.gaps.is_empty())),
            0.0,
        )
    }

    /// What is told of each curve.
    pub(crate) fn scalars(&self) -> Map<String, Value> {
        let curves = self.sweeps.iter().zip(&self.onsets);
        let curves =
            curves.map(|(sweep, found)| EigenvalueCurve::new(&self.axis.values, sweep, found).scalars());
        self.curves.scalars(curves.collect())
    }

    pub(crate) fn warnings(&self) -> Vec<String> {
        const SHOWN: usize = 3;
        let points = self.sweeps.iter().enumerate().flat_map(|(curve, sweep)| {
            self.axis.values.iter().zip(&sweep.points).map(move |(value, point)| (curve, value, point))
        });
        let open = points.filter(|(_, _, point)| !point.gaps.is_empty());
        let more = open.clone().count().saturating_sub(SHOWN);
        let mut warnings: Vec<String> = open
            .take(SHOWN)
            .flat_map(|(curve, value, point)| {
                let with = self.curves.told(curve).map_or_else(String::new, |told| format!(", {told}"));
                gap_warnings(&point.gaps).into_iter().map(move |gap| {
                    let at = self.axis.text(*value);
                    format!("at {at}{with}: {gap}")
                })
            })
            .collect();
        if more > 0 {
            warnings.push(format!("eigenvalues may be missing at {more} more values"));
        }
        warnings.extend(self.onsets.iter().filter_map(|own| own.warning(&|value| self.axis.text(value))));
        warnings
    }

    pub(crate) fn dataset(&self) -> Result<Dataset, ModelError> {
        let branches = self.sweeps.iter().map(|sweep| sweep.branches).max().unwrap_or(0);
        let (over, shape) = self.curves.dimensions(&self.axis, &[("branch", branches)]);
        let count = shape.iter().product();
        let mut values = vec![NONE; count];
        let (mut errors, mut verdicts) = (vec![f64::NAN; count], vec![ABSENT; count]);
        for (row, point) in self.sweeps.iter().flat_map(|sweep| &sweep.points).enumerate() {
            for Tracked { eigenvalue, branch } in &point.eigenvalues {
                let place = row * branches + branch;
                values[place] = eigenvalue.value;
                errors[place] = eigenvalue.error;
                verdicts[place] = code(eigenvalue.verdict());
            }
        }
        let region = self.asked.rectangle();
        let meanings: Vec<(u8, &str)> = VERDICTS.into_iter().chain([(ABSENT, "not in the region")]).collect();
        let mut dataset = Dataset::new().attribute("region", json!({ "re": region.re, "im": region.im }))?;
        if let Some(family) = self.curves.coordinate() {
            dataset = dataset.with(family)?;
        }
        Ok(dataset
            .with(self.axis.coordinate())?
            .with(
                Variable::new("eigenvalue", &over, &shape, values)
                    .units("1/s")
                    .long_name("eigenvalue λ of a branch, NaN where it is not in the region"),
            )?
            .with(
                Variable::new("error", &over, &shape, errors)
                    .units("1/s")
                    .long_name("how far the true eigenvalue may be"),
            )?
            .with(Variable::classes("verdict", &over, &shape, verdicts, &meanings).long_name("verdict"))?)
    }

    pub(crate) fn table(&self) -> Result<Table, ModelError> {
        let rows_of =
            |sweep: &SweptEigenvalues| sweep.points.iter().map(|point| point.eigenvalues.len()).sum();
        let rows_of_curve: Vec<usize> = self.sweeps.iter().map(rows_of).collect();
        let points = self.sweeps.iter().flat_map(|sweep| self.axis.values.iter().zip(&sweep.points));
        let rows: Vec<(f64, &Tracked)> = points
            .flat_map(|(value, point)| point.eigenvalues.iter().map(move |tracked| (*value, tracked)))
            .collect();
        let of = |pick: &dyn Fn(&Tracked) -> f64| -> Vec<f64> {
            rows.iter().map(|(_, tracked)| pick(tracked)).collect()
        };
        let words: Vec<String> = rows.iter().map(|(_, t)| t.eigenvalue.verdict().name().to_owned()).collect();
        let branches: Vec<i64> = rows.iter().map(|(_, tracked)| tracked.branch as i64).collect();
        let mut table = Table::new();
        if let Some((name, unit, values)) = self.curves.column(&rows_of_curve) {
            table = table.column(&name, &unit, values)?;
        }
        Ok(table
            .column(
                "value",
                &self.axis.quantity.unit,
                rows.iter().map(|(value, _)| *value).collect::<Vec<f64>>(),
            )?
            .column("branch", "1", branches)?
            .column("re", "1/s", of(&|t| t.eigenvalue.value.re))?
            .column("im", "1/s", of(&|t| t.eigenvalue.value.im))?
            .column("frequency", "Hz", of(&|t| t.eigenvalue.frequency_hz()))?
            .column("damping_ratio", "1", of(&|t| t.eigenvalue.damping_ratio()))?
            .column("error", "1/s", of(&|t| t.eigenvalue.error))?
            .column("verdict", "1", words)?)
    }
}
