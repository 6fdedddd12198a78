//! Complex modes about steady sliding along a key, and what is told of them.

use super::AssemblySweep;
use super::solved::SolvedSweep;
use crate::assembly::AssemblySubject;
use crate::assembly::swept::{SweptAssembly, beyond_laws};
use crate::axis::Curves;
use crate::error::ModelError;
use crate::structure::eigen_sweep::branches::SweptBranches;
use crate::structure::eigen_sweep::kept_points::KeptPoints;
use crate::structure::eigen_sweep::onsets::{LocatedOnsets, ToldDoubt, ToldOnset};
use judder_store::Results;
use judder_structure::onset::Onset;
use judder_study::axis::SweptAxis;
use judder_study::kept::KeptLines;
use judder_study::outcome::Outcome;
use judder_study::{Progress, StudyError, Untold};

/// What is told of a sweep beside its eigenvalues.
#[derive(Results)]
pub(super) struct ToldSweep {
    /// the swept key
    key: String,
    /// its unit
    unit: String,
    /// the unit in which the case has its values, in which tables, figures and messages show them
    shown_unit: String,
    /// `full` or `projected`
    method: String,
    /// contact points that are closed, at each value
    closed: Vec<Option<usize>>,
    /// where modes begin or cease to grow if every contact point is held closed; none where all are closed anyway
    onsets_all_closed: Option<Vec<ToldOnset>>,
    /// between which values those may be others
    #[result(optional)]
    onsets_all_closed_in_doubt: Option<Vec<ToldDoubt>>,
    /// of reduced bodies how far each onset lies from that of the whole ones, by a step of Newton's method; none where it is not known
    #[result(unit = "1")]
    onset_reduction_errors: Option<Vec<Option<f64>>>,
    /// values without steady sliding
    failures: Vec<ToldFailure>,
}

/// A value without eigenvalues.
#[derive(Results)]
struct ToldFailure {
    value: f64,
    reason: String,
}

pub(super) fn run(
    of: &AssemblySubject<'_>,
    settings: &AssemblySweep,
    (kept, progress): (KeptLines<'_>, &dyn Progress),
) -> Result<Outcome, ModelError> {
    let asked = settings.sought.region();
    let region = asked.rectangle();
    let sweep = &settings.sweep;
    let family = SweptAssembly::new(of, vec![sweep], settings.damping);
    let method = settings.method.method();
    let solved_of = |family: &SweptAssembly<'_>, part: &'static str, progress: &dyn Progress| {
        let kept = KeptPoints::of(part, kept);
        SolvedSweep::new(family, &sweep.values, method, &region, (&kept, progress))
    };
    let solved = solved_of(&family, "points", progress)?;
    let all_closed = match solved.has_open_points() {
        true => {
            let held = solved_of(&family.all_closed(), "points all closed", &Untold(progress))?;
            Some(held.onsets.asked_of(&asked))
        }
        false => None,
    };
    let axis = sweep.axis("value");
    let of_reduction = match of.case.is_reduced() {
        true => Some(reduction_errors(&family.whole()?, &solved.onsets.onsets, progress)?),
        false => None,
    };
    let told = ToldSweep::new(settings, &axis, &solved, all_closed.as_ref(), of_reduction);
    let mut values_by_reason: Vec<(&str, Vec<String>)> = Vec::new();
    for ToldFailure { value, reason } in &told.failures {
        let value = sweep.text(*value);
        match values_by_reason.iter_mut().find(|(known, _)| known == reason) {
            Some((_, values)) => values.push(value),
            None => values_by_reason.push((reason, vec![value])),
        }
    }
    let failed = values_by_reason
        .iter()
        .map(|(reason, values)| format!("{} = {}: {reason}", sweep.path, values.join(", ")));
    let mut warnings: Vec<String> = failed.chain(family.doubts(solved.states.iter().flatten())).collect();
    let held_in_doubt = all_closed.as_ref().and_then(|own| own.warning(&|value| sweep.text(value)));
    warnings.extend(held_in_doubt.map(|doubt| format!("with every contact point held closed, {doubt}")));
    let has_modes_beyond = solved.states.iter().zip(&solved.sweep.points).filter(|(state, point)| {
        let mut own = point.eigenvalues.iter().map(|tracked| &tracked.eigenvalue);
        state.as_ref().is_ok_and(|state| own.any(|eigenvalue| state.is_beyond_laws(eigenvalue)))
    });
    let beyond = has_modes_beyond.count();
    warnings.extend(beyond_laws(beyond, solved.states.len(), "values, for modes of the region"));
    let branches = SweptBranches::new(&asked, axis, Curves::alone(), vec![solved.sweep], vec![solved.onsets]);
    warnings.extend(branches.warnings());
    let missing = branches.incomplete() + told.failures.len();
    let mut scalars = branches.scalars();
    scalars.extend(told.scalars());
    Ok(Outcome {
        scalars,
        dataset: branches.dataset()?,
        table: Some(branches.table()?),
        checks: vec![branches.completeness()],
        missing,
        warnings,
        files: Vec::new(),
        ..Outcome::default()
    })
}

impl ToldSweep {
    fn new(
        settings: &AssemblySweep,
        axis: &SweptAxis,
        solved: &SolvedSweep,
        all_closed: Option<&LocatedOnsets>,
        onset_reduction_errors: Option<Vec<Option<f64>>>,
    ) -> Self {
        let failures = axis.values.iter().zip(&solved.states).filter_map(|(value, state)| {
            Some(ToldFailure { value: *value, reason: state.as_ref().err()?.clone() })
        });
        Self {
            key: settings.sweep.path.clone(),
            unit: axis.quantity.unit.clone(),
            shown_unit: settings.sweep.shown_unit(),
            method: settings.method.method().to_string(),
            closed: solved.states.iter().map(|state| Some(state.as_ref().ok()?.closed_points())).collect(),
            onsets_all_closed: all_closed.map(LocatedOnsets::told),
            onsets_all_closed_in_doubt: all_closed
                .map(LocatedOnsets::doubts)
                .filter(|doubts| !doubts.is_empty()),
            onset_reduction_errors,
            failures: failures.collect(),
        }
    }
}

/// How far each onset lies from that of the whole bodies; `None` where these have none to compare with.
fn reduction_errors(
    whole: &SweptAssembly<'_>,
    onsets: &[Onset],
    progress: &dyn Progress,
) -> Result<Vec<Option<f64>>, StudyError> {
    let of_one = |onset: &Onset| {
        let crossing = onset.crossing.as_ref()?;
        let state = whole.state(&[onset.value]).ok()?;
        let solved = whole.solved_alone(&state, &crossing.within).ok()?;
        let shift = crossing.shift(&solved.stability(state.pieces));
        Some(shift.abs()).filter(|shift| shift.is_finite())
    };
    onsets.iter().map(|onset| progress.go_on().map(|()| of_one(onset))).collect()
}
