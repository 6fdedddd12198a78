//! Where an unknown of a path changes its sign between two solutions.

use crate::CyclesError;
use crate::path::{Newton, PathEquations, PathPoint, PathRule, distance, follow};

/// A guess of the solution at a share of the way between two: Hermite's cubic, with the directions in which the path leaves one and comes to the other.
pub(crate) fn between([first, last]: [&PathPoint; 2], share: f64, weights: &[f64]) -> Vec<f64> {
    let (way, back) = (distance(&first.at, &last.at, weights), 1.0 - share);
    let of = |k: usize| {
        let [from, to] = [back * back * (1.0 + 2.0 * share), share * share * (3.0 - 2.0 * share)];
        let [leaving, coming] = [way * share * back * back, -way * share * share * back];
        from * first.at[k] + to * last.at[k] + leaving * first.tangent[k] + coming * last.tangent[k]
    };
    (0..first.at.len()).map(of).collect()
}

/// The solutions between which an unknown changes its sign, on the path from one to another that is followed in steps of a sixteenth of the way.
///
/// # Errors
/// Why no next solution was found; [`CyclesError::NotConverged`] where the unknown keeps its sign.
pub(crate) fn sign_change<E: PathEquations>(
    equations: &mut E,
    newton: &mut Newton<'_>,
    [first, last]: [&PathPoint; 2],
    unknown: usize,
) -> Result<[PathPoint; 2], CyclesError> {
    const STEPS: usize = 16;
    let step = distance(&first.at, &last.at, equations.weights()) / STEPS as f64;
    let rule = |rule: PathRule| PathRule { steps: [step, step, rule.steps[2].min(1e-3 * step)], ..rule };
    let mut newton = newton.with_rule(rule);
    equations.accept(&first.at)?;
    let found = follow(&mut newton, equations, first.clone(), 4 * STEPS, |_, _, [before, next]| {
        let changes = before.at[unknown] * next.at[unknown] <= 0.0;
        Ok(changes.then(|| [before.clone(), next.clone()]))
    })?;
    found.ok_or(CyclesError::NotConverged { iterations: 4 * STEPS, residual: last.at[unknown].abs() })
}
