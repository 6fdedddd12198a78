//! Solutions of equations with one unknown more than there are of them, one after the other.
//!
//! Pseudo-arclength continuation (H. B. Keller, 1977): a step along the tangent, then Newton's method on the equations and the plane that the
//! step ends in.

use crate::CyclesError;
use crate::reduced::solve;
use faer::{Mat, MatMut};

/// n equations of n + 1 unknowns, which are of the order of one.
pub(crate) trait PathEquations {
    /// What is left at a guess.
    fn residual(&mut self, at: &[f64]) -> Result<&[f64], CyclesError>;

    /// The derivative by the unknowns, in place of whatever the n × n + 1 matrix has.
    fn derivative(&mut self, at: &[f64], out: MatMut<'_, f64>) -> Result<(), CyclesError>;

    /// What each unknown counts in the length of a step.
    fn weights(&self) -> &[f64];

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
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, own| if own.is_nan() { f64::INFINITY } else { most.max(own.abs()) })
}

/// Asked again and again by what takes long: where it says no, that ends as [`CyclesError::Stopped`].
pub type GoOn<'g> = dyn Fn() -> bool + Sync + 'g;

/// Newton's method, with what it works in: assembled, solved and written over again in the same place.
pub(crate) struct Newton<'g> {
    go_on: &'g GoOn<'g>,
    rule: PathRule,
    /// After how many steps that do not halve what is left it gives up.
    patience: usize,
    /// Whether a path keeps the sign of the determinant at sharp turns: there are no branch points on it.
    keeps_orientation: bool,
    /// The derivative, and the closing equation in its last row.
    matrix: Mat<f64>,
    right: Mat<f64>,
}

impl<'g> Newton<'g> {
    pub(crate) fn new(rule: PathRule, go_on: &'g GoOn<'g>) -> Self {
        let [matrix, right] = [(); 2].map(|()| Mat::new());
        Self { go_on, rule, patience: rule.iterations, keeps_orientation: false, matrix, right }
    }

    /// The same along paths without branch points.
    pub(crate) fn without_branches(self) -> Self {
        Self { keeps_orientation: true, ..self }
    }

    /// The linear system at a place, of so many right sides that are zero but for the closing equation, which is one.
    fn assemble<E: PathEquations>(
        &mut self,
        equations: &mut E,
        at: &[f64],
        closing: &[f64],
        sides: usize,
    ) -> Result<(), CyclesError> {
        let size = at.len();
        if self.matrix.nrows() != size {
            self.matrix = Mat::zeros(size, size);
        }
        equations.derivative(at, self.matrix.as_mut().submatrix_mut(0, 0, size - 1, size))?;
        closing.iter().enumerate().for_each(|(j, own)| self.matrix[(size - 1, j)] = *own);
        self.right.resize_with(size, sides, |_, _| 0.0);
        self.right.fill(0.0);
        (0..sides).for_each(|side| self.right[(size - 1, side)] = 1.0);
        Ok(())
    }

    /// In place of the right sides the solutions; the sign of the determinant.
    fn solve(&mut self) -> Result<f64, CyclesError> {
        solve(self.matrix.as_mut(), self.right.as_mut()).ok_or(CyclesError::Singular)
    }

    /// The solution near a guess on which the closing equation holds; the tangent points as `towards` does.
    ///
    /// # Errors
    /// [`CyclesError::NotConverged`], [`CyclesError::Singular`], and what the equations say.
    pub(crate) fn corrected<E: PathEquations>(
        &mut self,
        equations: &mut E,
        guess: &[f64],
        closing: &ClosingEquation,
        towards: &[f64],
    ) -> Result<PathPoint, CyclesError> {
        /// The step of Newton's method, and the tangent.
        const SIDES: usize = 2;
        let size = guess.len();
        let mut at = guess.to_vec();
        let closed = |at: &[f64]| dot(&closing.row, at) - closing.value;
        let left = |equations: &mut E, at: &[f64]| -> Result<[f64; 2], CyclesError> {
            let (residual, own) = (equations.residual(at)?, closed(at));
            Ok([largest(residual).max(largest(&[own])), (dot(residual, residual) + own * own).sqrt()])
        };
        let [mut most, mut norm] = left(equations, &at)?;
        let (mut tried, mut least, mut since) = (at.clone(), norm, 0);
        let mut iteration = 0;
        while iteration < self.rule.iterations && since < self.patience {
            iteration += 1;
            if !(self.go_on)() {
                return Err(CyclesError::Stopped);
            }
            self.assemble(equations, &at, &closing.row, SIDES)?;
            let step = self.right.col_as_slice_mut(0);
            step.iter_mut().zip(equations.residual(&at)?).for_each(|(own, residual)| *own = -residual);
            step[size - 1] = -closed(&at);
            let sign = self.solve()?;
            // the part of a step that leaves least: none need leave less where points change their states
            let mut best: Option<(f64, f64, f64)> = None;
            let step = self.right.col_as_slice(0);
            let along = |share: f64, tried: &mut Vec<f64>| {
                tried.clear();
                tried.extend(at.iter().zip(step).map(|(own, step)| own + share * step));
            };
            for share in [1.0, 0.5, 0.25, 0.1] {
                along(share, &mut tried);
                let Ok([now_most, now_norm]) = left(equations, &tried) else { continue };
                if best.is_none_or(|best| now_norm < best.2) {
                    best = Some((share, now_most, now_norm));
                }
                if now_norm < (1.0 - 0.3 * share) * norm {
                    break;
                }
            }
            let share;
            (share, most, norm) = best.ok_or(CyclesError::Singular)?;
            along(share, &mut tried);
            std::mem::swap(&mut at, &mut tried);
            if most <= self.rule.tolerance {
                let (tangent, turned) = unit(self.right.col_as_slice(1), equations.weights(), towards);
                let orientation = sign * turned;
                return Ok(PathPoint { at, tangent, orientation, residual: most, iterations: iteration });
            }
            (least, since) = if norm < 0.5 * least { (norm, 0) } else { (least, since + 1) };
        }
        Err(CyclesError::NotConverged { iterations: iteration, residual: most })
    }

    /// The tangent that the equations have at a place.
    fn tangent_at<E: PathEquations>(
        &mut self,
        equations: &mut E,
        at: &[f64],
        towards: &[f64],
    ) -> Result<Vec<f64>, CyclesError> {
        let closing = ClosingEquation::across(towards, equations.weights(), at);
        self.assemble(equations, at, &closing.row, 1)?;
        self.solve()?;
        Ok(unit(self.right.col_as_slice(0), equations.weights(), towards).0)
    }
}

/// Σ a b w.
fn weighted(a: &[f64], b: &[f64], weights: &[f64]) -> f64 {
    (0..a.len()).map(|k| a[k] * weights[k] * b[k]).sum()
}

/// A direction of length one in the weights that points as another does, and −1 where that turned it.
fn unit(direction: &[f64], weights: &[f64], towards: &[f64]) -> (Vec<f64>, f64) {
    let length = weighted(direction, direction, weights).sqrt();
    let sign = if weighted(direction, towards, weights) < 0.0 { -1.0 } else { 1.0 };
    (direction.iter().map(|own| sign * own / length).collect(), sign)
}

/// Steps of Newton's method that do not halve what is left after which a shorter step along the path is the better one.
const PATIENCE: usize = 6;

/// A step that fails below it stands before a kink of the path.
const KINK: f64 = 1e-4;

/// The cosine below which a path turns sharply.
const SHARP: f64 = 0.5;

/// How far two places lie apart.
pub(crate) fn distance(a: &[f64], b: &[f64], weights: &[f64]) -> f64 {
    let squares = a.iter().zip(b).zip(weights).map(|((a, b), weight)| (a - b) * (a - b) * weight);
    squares.sum::<f64>().sqrt()
}

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
    let mut path = Path { point: first, step: newton.rule.steps[0] };
    for _ in 1..most {
        let next = path.next(newton, equations)?;
        equations.accept(&next.at)?;
        let before = std::mem::replace(&mut path.point, next);
        if let Some(end) = judge(equations, newton, [&before, &path.point])? {
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
}

impl Path {
    /// The next solution; the step shortens until one is found. Where equations have kinks, the path may turn at one.
    ///
    /// # Errors
    /// The last reason where none is found with the shortest step.
    fn next<E: PathEquations>(
        &mut self,
        newton: &mut Newton<'_>,
        equations: &mut E,
    ) -> Result<PathPoint, CyclesError> {
        let [_, longest, shortest] = newton.rule.steps;
        let mut rounded = false;
        loop {
            let error = match self.tried(newton, equations) {
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

    /// A solution beyond a kink that is just ahead: the path goes on along the tangent that the equations have behind it, one way or the other.
    fn round_the_kink<E: PathEquations>(
        &self,
        newton: &mut Newton<'_>,
        equations: &mut E,
    ) -> Result<Option<(PathPoint, f64)>, CyclesError> {
        let PathPoint { at, tangent, .. } = &self.point;
        let first = newton.rule.steps[0];
        for ahead in [4.0, 40.0] {
            let beyond: Vec<f64> =
                at.iter().zip(tangent).map(|(own, t)| own + ahead * self.step * t).collect();
            let Ok(behind) = newton.tangent_at(equations, &beyond, tangent) else { continue };
            for step in [first, 0.1 * first, 0.01 * first, 10.0 * KINK] {
                for sign in [1.0, -1.0] {
                    let tangent: Vec<f64> = behind.iter().map(|own| sign * own).collect();
                    let there = Self { point: PathPoint { tangent, ..self.point.clone() }, step };
                    if let Ok(next) = there.tried(newton, equations)
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
        let (along, length) = (weighted(&way, tangent, weights), weighted(&way, &way, weights).sqrt());
        along < 0.0 && (length * length - along * along).max(0.0).sqrt() < NARROW * length
    }

    fn tried<E: PathEquations>(
        &self,
        newton: &mut Newton<'_>,
        equations: &mut E,
    ) -> Result<PathPoint, CyclesError> {
        let PathPoint { at, tangent, .. } = &self.point;
        let guess: Vec<f64> = at.iter().zip(tangent).map(|(own, t)| own + self.step * t).collect();
        let closing = ClosingEquation::across(tangent, equations.weights(), &guess);
        newton.patience = PATIENCE;
        let found = newton.corrected(equations, &guess, &closing, tangent);
        newton.patience = newton.rule.iterations;
        let mut found = found?;
        // a solution far off the guess is one of another path
        let off = distance(&found.at, &guess, equations.weights());
        if off > self.step || !equations.is_sought(&found.at)? {
            return Err(CyclesError::NotConverged { iterations: found.iterations, residual: off });
        }
        // behind a kink at which a path turns sharply it goes on the way that keeps the sign of the determinant
        let ahead = weighted(tangent, &found.tangent, equations.weights());
        if newton.keeps_orientation && ahead < SHARP && found.orientation * self.point.orientation < 0.0 {
            found.tangent.iter_mut().for_each(|own| *own = -*own);
            found.orientation = -found.orientation;
        }
        Ok(found)
    }
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
    let rule = PathRule { steps: [step, step, newton.rule.steps[2].min(1e-3 * step)], ..newton.rule };
    let mut newton = Newton::new(rule, newton.go_on);
    equations.accept(&first.at)?;
    let found = follow(&mut newton, equations, first.clone(), 4 * STEPS, |_, _, [before, next]| {
        let changes = before.at[unknown] * next.at[unknown] <= 0.0;
        Ok(changes.then(|| [before.clone(), next.clone()]))
    })?;
    found.ok_or(CyclesError::NotConverged { iterations: 4 * STEPS, residual: last.at[unknown].abs() })
}
