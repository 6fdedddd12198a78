//! Solutions of equations with one unknown more than there are of them, one after the other.
//!
//! Pseudo-arclength continuation (H. B. Keller, 1977): a step along the tangent, then Newton's method on the equations and the plane that the
//! step ends in.

use crate::CyclesError;
use crate::reduced::solve;
use faer::Mat;

/// n equations of n + 1 unknowns, which are of the order of one.
pub trait PathEquations {
    /// What is left at a guess.
    ///
    /// # Errors
    /// Where the equations cannot be evaluated.
    fn residual(&mut self, at: &[f64]) -> Result<Vec<f64>, CyclesError>;

    /// What is left, and its derivative by the unknowns: n × n + 1.
    ///
    /// # Errors
    /// Where the equations cannot be evaluated.
    fn linearised(&mut self, at: &[f64]) -> Result<(Vec<f64>, Mat<f64>), CyclesError>;

    /// What each unknown counts in the length of a step.
    fn weights(&self) -> &[f64];

    /// Whether a solution is of the kind that is sought, beside one that is.
    ///
    /// # Errors
    /// Where the equations cannot be evaluated.
    fn is_sought(&mut self, at: &[f64]) -> Result<bool, CyclesError>;

    /// A solution is taken: what the equations refer to may follow it.
    ///
    /// # Errors
    /// Where the equations cannot be evaluated.
    fn accept(&mut self, at: &[f64]) -> Result<(), CyclesError>;
}

/// A solution, with the direction in which the path goes on.
#[derive(Debug, Clone, PartialEq)]
pub struct PathPoint {
    /// The unknowns.
    pub at: Vec<f64>,
    /// Of length one in the weights.
    pub tangent: Vec<f64>,
    /// The largest residual.
    pub residual: f64,
    /// Steps of Newton's method.
    pub iterations: usize,
}

/// The equation that picks one solution: r·z = c.
#[derive(Debug, Clone, PartialEq)]
pub struct ClosingEquation {
    /// r.
    pub row: Vec<f64>,
    /// c.
    pub value: f64,
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

impl ClosingEquation {
    /// One unknown has this value.
    #[must_use]
    pub fn fixed(unknown: usize, of: usize, value: f64) -> Self {
        let mut row = vec![0.0; of];
        row[unknown] = 1.0;
        Self { row, value }
    }

    /// The plane across a direction, through a place.
    #[must_use]
    pub fn across(direction: &[f64], weights: &[f64], place: &[f64]) -> Self {
        let row: Vec<f64> = direction.iter().zip(weights).map(|(own, weight)| own * weight).collect();
        let value = dot(&row, place);
        Self { row, value }
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, own| if own.is_nan() { f64::INFINITY } else { most.max(own.abs()) })
}

/// The solution near a guess on which the closing equation holds; the tangent points as `towards` does.
///
/// # Errors
/// [`CyclesError::NotConverged`], [`CyclesError::Singular`], and what the equations say.
pub fn corrected<E: PathEquations>(
    equations: &mut E,
    guess: &[f64],
    closing: &ClosingEquation,
    towards: &[f64],
    rule: &PathRule,
) -> Result<PathPoint, CyclesError> {
    let size = guess.len();
    let mut at = guess.to_vec();
    let closed = |at: &[f64]| dot(&closing.row, at) - closing.value;
    let left = |equations: &mut E, at: &[f64]| -> Result<[f64; 2], CyclesError> {
        let mut residual = equations.residual(at)?;
        residual.push(closed(at));
        Ok([largest(&residual), dot(&residual, &residual).sqrt()])
    };
    let [mut most, mut norm] = left(equations, &at)?;
    for iteration in 1..=rule.iterations {
        let (residual, derivative) = equations.linearised(&at)?;
        let matrix = Mat::from_fn(size, size, |i, j| match i + 1 == size {
            true => closing.row[j],
            false => derivative[(i, j)],
        });
        let mut right = Mat::from_fn(size, 2, |i, j| match (i + 1 == size, j) {
            (true, 0) => -closed(&at),
            (false, 0) => -residual[i],
            (true, _) => 1.0,
            (false, _) => 0.0,
        });
        solve(&matrix, &mut right).ok_or(CyclesError::Singular)?;
        // the part of a step that leaves least: none need leave less where points change their states
        let mut best: Option<(Vec<f64>, f64, f64)> = None;
        for share in [1.0, 0.5, 0.25, 0.1] {
            let tried: Vec<f64> = at.iter().enumerate().map(|(k, own)| own + share * right[(k, 0)]).collect();
            let Ok([now_most, now_norm]) = left(equations, &tried) else { continue };
            if best.as_ref().is_none_or(|best| now_norm < best.2) {
                best = Some((tried, now_most, now_norm));
            }
            if now_norm < (1.0 - 0.3 * share) * norm {
                break;
            }
        }
        (at, most, norm) = best.ok_or(CyclesError::Singular)?;
        if most <= rule.tolerance {
            let direction: Vec<f64> = (0..size).map(|k| right[(k, 1)]).collect();
            let tangent = unit(&direction, equations.weights(), towards);
            return Ok(PathPoint { at, tangent, residual: most, iterations: iteration });
        }
    }
    Err(CyclesError::NotConverged { iterations: rule.iterations, residual: most })
}

/// A direction of length one in the weights that points as another does.
fn unit(direction: &[f64], weights: &[f64], towards: &[f64]) -> Vec<f64> {
    let weighted: Vec<f64> = direction.iter().zip(weights).map(|(own, weight)| own * weight).collect();
    let length = dot(direction, &weighted).sqrt();
    let sign = if dot(&weighted, towards) < 0.0 { -1.0 } else { 1.0 };
    direction.iter().map(|own| sign * own / length).collect()
}

/// The tangent that the equations have at a place.
fn tangent_at<E: PathEquations>(
    equations: &mut E,
    at: &[f64],
    towards: &[f64],
) -> Result<Vec<f64>, CyclesError> {
    let size = at.len();
    let (_, derivative) = equations.linearised(at)?;
    let matrix = Mat::from_fn(size, size, |i, j| match i + 1 == size {
        true => towards[j] * equations.weights()[j],
        false => derivative[(i, j)],
    });
    let mut right = Mat::from_fn(size, 1, |i, _| if i + 1 == size { 1.0 } else { 0.0 });
    solve(&matrix, &mut right).ok_or(CyclesError::Singular)?;
    let direction: Vec<f64> = (0..size).map(|k| right[(k, 0)]).collect();
    Ok(unit(&direction, equations.weights(), towards))
}

/// A step that fails below it stands before a kink of the path.
const KINK: f64 = 1e-4;

/// A path, from solution to solution.
#[derive(Debug, Clone)]
pub struct Path {
    point: PathPoint,
    step: f64,
    rule: PathRule,
}

impl Path {
    /// From a solution on.
    #[must_use]
    pub fn from(point: PathPoint, rule: PathRule) -> Self {
        Self { point, step: rule.steps[0], rule }
    }

    /// The last solution.
    #[must_use]
    pub fn point(&self) -> &PathPoint {
        &self.point
    }

    /// Goes to the next solution; the step shortens until one is found. Where equations have kinks, the path may turn at one.
    ///
    /// # Errors
    /// The last reason where none is found with the shortest step.
    pub fn go_on<E: PathEquations>(&mut self, equations: &mut E) -> Result<&PathPoint, CyclesError> {
        let [_, longest, shortest] = self.rule.steps;
        let mut rounded = false;
        loop {
            let error = match self.tried(equations) {
                Ok(next) => {
                    let stretch = match next.iterations {
                        ..=3 => 1.5,
                        4 | 5 => 1.0,
                        _ => 0.6,
                    };
                    self.step = (stretch * self.step).min(longest);
                    return self.take(equations, next);
                }
                Err(error) => error,
            };
            if self.step < KINK && !rounded {
                rounded = true;
                if let Some((next, step)) = self.round_the_kink(equations)? {
                    self.step = step;
                    return self.take(equations, next);
                }
            }
            if 0.4 * self.step < shortest {
                return Err(error);
            }
            self.step *= 0.4;
        }
    }

    fn take<E: PathEquations>(
        &mut self,
        equations: &mut E,
        next: PathPoint,
    ) -> Result<&PathPoint, CyclesError> {
        equations.accept(&next.at)?;
        self.point = next;
        Ok(&self.point)
    }

    /// A solution beyond a kink that is just ahead: the path goes on along the tangent that the equations have behind it, one way or the other.
    fn round_the_kink<E: PathEquations>(
        &self,
        equations: &mut E,
    ) -> Result<Option<(PathPoint, f64)>, CyclesError> {
        let PathPoint { at, tangent, .. } = &self.point;
        for ahead in [4.0, 40.0] {
            let beyond: Vec<f64> =
                at.iter().zip(tangent).map(|(own, t)| own + ahead * self.step * t).collect();
            let Ok(behind) = tangent_at(equations, &beyond, tangent) else { continue };
            for step in [self.rule.steps[0], 0.1 * self.rule.steps[0], 0.01 * self.rule.steps[0], 10.0 * KINK]
            {
                for sign in [1.0, -1.0] {
                    let tangent: Vec<f64> = behind.iter().map(|own| sign * own).collect();
                    let from = PathPoint { tangent, ..self.point.clone() };
                    let there = Self { point: from, step, rule: self.rule };
                    if let Ok(next) = there.tried(equations)
                        && !self.lies_behind(&next.at, equations.weights())
                    {
                        return Ok(Some((next, step)));
                    }
                }
            }
        }
        Ok(None)
    }

    /// Whether a solution is one of those that the path came by.
    fn lies_behind(&self, other: &[f64], weights: &[f64]) -> bool {
        /// How far from the line back, of the way.
        const NARROW: f64 = 0.2;
        let PathPoint { at, tangent, .. } = &self.point;
        let way: Vec<f64> = other.iter().zip(at).map(|(a, b)| a - b).collect();
        let weighted = |a: &[f64], b: &[f64]| -> f64 { (0..a.len()).map(|k| a[k] * b[k] * weights[k]).sum() };
        let (along, length) = (weighted(&way, tangent), weighted(&way, &way).sqrt());
        along < 0.0 && (length * length - along * along).max(0.0).sqrt() < NARROW * length
    }

    fn tried<E: PathEquations>(&self, equations: &mut E) -> Result<PathPoint, CyclesError> {
        let PathPoint { at, tangent, .. } = &self.point;
        let guess: Vec<f64> = at.iter().zip(tangent).map(|(own, t)| own + self.step * t).collect();
        let closing = ClosingEquation::across(tangent, equations.weights(), &guess);
        let found = corrected(equations, &guess, &closing, tangent, &self.rule)?;
        // a solution far off the guess is one of another path
        let weights = equations.weights();
        let off = |k: usize| (found.at[k] - guess[k]) * (found.at[k] - guess[k]) * weights[k];
        let off = (0..guess.len()).map(off).sum::<f64>().sqrt();
        if off > self.step || !equations.is_sought(&found.at)? {
            return Err(CyclesError::NotConverged { iterations: found.iterations, residual: off });
        }
        Ok(found)
    }
}
