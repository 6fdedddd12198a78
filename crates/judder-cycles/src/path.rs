//! Solutions of equations with one unknown more than there are of them, one after the other.
//!
//! Pseudo-arclength continuation (H. B. Keller, 1977): a step along the tangent, then Newton's method on the equations and the plane that the
//! step ends in.

mod kink;
mod newton;

use crate::CyclesError;
use faer::MatMut;

use kink::{KINK, Trail};
pub(crate) use newton::Newton;

/// n equations of n + 1 unknowns, which are of the order of one.
pub(crate) trait PathEquations {
    /// What is left at a guess.
    fn residual(&mut self, at: &[f64]) -> Result<&[f64], CyclesError>;

    /// The derivative by the unknowns, in place of whatever the n × n + 1 matrix has.
    fn derivative(&mut self, at: &[f64], out: MatMut<'_, f64>) -> Result<(), CyclesError>;

    /// What each unknown counts in the length of a step.
    fn weights(&self) -> &[f64];

    /// Between which values the last unknown stays: a path that comes to one of them ends there.
    fn ends(&self) -> [f64; 2] {
        [f64::NEG_INFINITY, f64::INFINITY]
    }

    /// Whether a solution is of the kind that is sought, beside one that is.
    fn is_sought(&mut self, at: &[f64]) -> Result<bool, CyclesError>;

    /// A solution is taken: what the equations refer to may follow it.
    fn accept(&mut self, at: &[f64]) -> Result<(), CyclesError>;
}

/// A solution, with the direction in which the path goes on.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct PathPoint {
    /// The unknowns.
    pub(crate) at: Vec<f64>,
    /// Of length one in the weights.
    pub(crate) tangent: Vec<f64>,
    /// The sign of the determinant of the equations under the tangent: another one across a branch point.
    pub(crate) orientation: f64,
    /// The largest residual.
    pub(crate) residual: f64,
    /// Steps of Newton's method.
    iterations: usize,
}

/// The equation that picks one solution: r·z = c.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct ClosingEquation {
    /// r.
    pub(crate) row: Vec<f64>,
    /// c.
    pub(crate) value: f64,
}

/// How solutions are sought.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PathRule {
    /// The first, the longest and the shortest step along the path.
    pub steps: [f64; 3],
    /// The most steps of Newton's method.
    pub iterations: usize,
    /// What may be left of an equation.
    pub tolerance: f64,
}

impl Default for PathRule {
    fn default() -> Self {
        Self { steps: [0.05, 0.5, 1e-6], iterations: 30, tolerance: 1e-9 }
    }
}

impl PathPoint {
    /// The same on a path that goes the other way.
    fn turned(mut self) -> Self {
        self.tangent.iter_mut().for_each(|own| *own = -*own);
        Self { orientation: -self.orientation, ..self }
    }
}

impl ClosingEquation {
    /// One unknown has this value.
    pub(crate) fn fixed(unknown: usize, of: usize, value: f64) -> Self {
        let mut row = vec![0.0; of];
        row[unknown] = 1.0;
        Self { row, value }
    }

    /// The plane across a direction, through a place.
    pub(crate) fn across(direction: &[f64], weights: &[f64], place: &[f64]) -> Self {
        let row: Vec<f64> = direction.iter().zip(weights).map(|(own, weight)| own * weight).collect();
        let value = dot(&row, place);
        Self { row, value }
    }

    /// r·z − c.
    fn left(&self, at: &[f64]) -> f64 {
        dot(&self.row, at) - self.value
    }
}

/// Asked again and again by what takes long: where it says no, that ends as [`CyclesError::Stopped`].
pub type GoOn<'g> = dyn Fn() -> bool + Sync + 'g;

/// Σ a b.
fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Σ a b w.
fn weighted(a: &[f64], b: &[f64], weights: &[f64]) -> f64 {
    (0..a.len()).map(|k| a[k] * weights[k] * b[k]).sum()
}

/// Steps of Newton's method that do not halve what is left after which a shorter step along the path is the better one.
const PATIENCE: usize = 6;

/// The cosine below which a path turns sharply.
const SHARP: f64 = 0.5;

/// How far two places lie apart.
pub(crate) fn distance(a: &[f64], b: &[f64], weights: &[f64]) -> f64 {
    let squares = a.iter().zip(b).zip(weights).map(|((a, b), weight)| (a - b) * (a - b) * weight);
    squares.sum::<f64>().sqrt()
}

/// Follows a path from a solution on until a judge, who sees the last solution and the next one, ends it; nothing where there are as many solutions as were asked for.
///
/// # Errors
/// Why no next solution was found, and what the judge says.
pub(crate) fn follow<E: PathEquations, End>(
    newton: &mut Newton<'_>,
    equations: &mut E,
    first: PathPoint,
    most: usize,
    mut judge: impl FnMut(&mut E, &mut Newton<'_>, [&PathPoint; 2]) -> Result<Option<End>, CyclesError>,
) -> Result<Option<End>, CyclesError> {
    let mut path = Path {
        point: first,
        step: newton.rule.steps[0],
        keeps_orientation: newton.keeps_orientation,
        trail: Trail::default(),
    };
    for _ in 1..most {
        let next = path.next(newton, equations)?;
        equations.accept(&next.at)?;
        let before = path.trail.left(std::mem::replace(&mut path.point, next));
        if let Some(end) = judge(equations, newton, [before, &path.point])? {
            return Ok(Some(end));
        }
    }
    Ok(None)
}

/// How a path ended, where it was not stopped: `most` where there are as many solutions as were asked for, `lost` where no next one was found.
pub(crate) fn ended<End>(
    followed: Result<Option<End>, CyclesError>,
    most: End,
    lost: impl FnOnce(CyclesError) -> End,
) -> Result<End, CyclesError> {
    match followed {
        Ok(end) => Ok(end.unwrap_or(most)),
        Err(CyclesError::Stopped) => Err(CyclesError::Stopped),
        Err(error) => Ok(lost(error)),
    }
}

/// Where a path stands.
struct Path {
    point: PathPoint,
    step: f64,
    /// Whether the next solution has the same sign of the determinant.
    keeps_orientation: bool,
    trail: Trail,
}

impl Path {
    /// The next solution; where none keeps the sign of the determinant as it should, there is a branch point after all, or a kink at which the path turns back beside itself.
    ///
    /// # Errors
    /// The last reason where none is found with the shortest step.
    fn next<E: PathEquations>(
        &mut self,
        newton: &mut Newton<'_>,
        equations: &mut E,
    ) -> Result<PathPoint, CyclesError> {
        let begun = self.step;
        let found = match self.found(newton, equations) {
            Err(error) if self.keeps_orientation && error.is_of_the_motion() => {
                (self.step, self.keeps_orientation) = (begun, false);
                let found = self.found(newton, equations);
                self.keeps_orientation = true;
                found
            }
            found => found,
        };
        let next = found?;
        let turns = next.orientation != self.point.orientation && self.goes_back(&next, newton, equations)?;
        Ok(if turns { next.turned() } else { next })
    }

    /// The next solution; the step shortens until one is found. Where equations have kinks, the path may turn at one.
    fn found<E: PathEquations>(
        &mut self,
        newton: &mut Newton<'_>,
        equations: &mut E,
    ) -> Result<PathPoint, CyclesError> {
        let [_, longest, shortest] = newton.rule.steps;
        let mut rounded = false;
        loop {
            let error = match self.tried((&self.point, self.step), newton, equations) {
                Ok(next) => {
                    let stretch = match next.iterations {
                        ..=3 => 1.5,
                        4 | 5 => 1.0,
                        _ => 0.6,
                    };
                    self.step = (stretch * self.step).min(longest);
                    return Ok(next);
                }
                Err(CyclesError::Stopped) => return Err(CyclesError::Stopped),
                Err(error) => error,
            };
            if self.step < KINK && !rounded {
                rounded = true;
                if let Some((next, step)) = self.round_the_kink(newton, equations)? {
                    self.step = step;
                    return Ok(next);
                }
            }
            if 0.4 * self.step < shortest {
                return Err(error);
            }
            self.step *= 0.4;
        }
    }

    /// The solution a step ahead of a point.
    fn tried<E: PathEquations>(
        &self,
        ahead: (&PathPoint, f64),
        newton: &mut Newton<'_>,
        equations: &mut E,
    ) -> Result<PathPoint, CyclesError> {
        let (point, step) = ahead;
        let (guess, found) = solved(ahead, newton, equations)?;
        // a solution far off the guess is one of another path
        let off = distance(&found.at, &guess, equations.weights());
        if off > step || !equations.is_sought(&found.at)? {
            return Err(CyclesError::NotConverged { iterations: found.iterations, residual: off });
        }
        // behind a kink at which a path turns sharply it goes on the way that keeps the sign of the determinant
        if self.keeps_orientation && found.orientation != point.orientation {
            if weighted(&point.tangent, &found.tangent, equations.weights()) > SHARP {
                return Err(CyclesError::NotConverged { iterations: found.iterations, residual: off });
            }
            return Ok(found.turned());
        }
        Ok(found)
    }
}

/// A guess a step ahead of a point and the solution near it; a step that leads beyond an end of the last unknown is shortened onto that.
fn solved<E: PathEquations>(
    (PathPoint { at, tangent, .. }, step): (&PathPoint, f64),
    newton: &mut Newton<'_>,
    equations: &mut E,
) -> Result<(Vec<f64>, PathPoint), CyclesError> {
    let last = at.len() - 1;
    let ends = equations.ends();
    let ahead = |step: f64| -> Vec<f64> { at.iter().zip(tangent).map(|(own, t)| own + step * t).collect() };
    let guess = ahead(step);
    let end = match beyond(guess[last], ends) {
        Some(end) => end,
        None => {
            let closing = ClosingEquation::across(tangent, equations.weights(), &guess);
            let found = newton.corrected_within(equations, &guess, &closing, tangent, PATIENCE)?;
            match beyond(found.at[last], ends) {
                Some(end) => end,
                None => return Ok((guess, found)),
            }
        }
    };
    let guess = ahead((end - at[last]) / tangent[last]);
    let closing = ClosingEquation::fixed(last, guess.len(), end);
    let mut found = newton.corrected_within(equations, &guess, &closing, tangent, PATIENCE)?;
    found.at[last] = end;
    Ok((guess, found))
}

/// The end beyond which a value lies.
fn beyond(value: f64, [low, high]: [f64; 2]) -> Option<f64> {
    if value < low {
        Some(low)
    } else if value > high {
        Some(high)
    } else {
        None
    }
}
