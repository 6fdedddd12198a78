//! Newton's method on equations and the one that closes them.

use super::{ClosingEquation, GoOn, PathEquations, PathPoint, PathRule, dot, weighted};
use crate::CyclesError;
use crate::reduced::solve;
use faer::Mat;

/// Newton's method, with what it works in: assembled, solved and written over again in the same place.
pub(crate) struct Newton<'g> {
    go_on: &'g GoOn<'g>,
    pub(super) rule: PathRule,
    /// Whether a path keeps the sign of the determinant at sharp turns: there are no branch points on it.
    pub(super) keeps_orientation: bool,
    /// The derivative, and the closing equation in its last row.
    matrix: Mat<f64>,
    right: Mat<f64>,
}

impl<'g> Newton<'g> {
    pub(crate) fn new(rule: PathRule, go_on: &'g GoOn<'g>) -> Self {
        let [matrix, right] = [(); 2].map(|()| Mat::new());
        Self { go_on, rule, keeps_orientation: false, matrix, right }
    }

    /// The same along paths without branch points.
    pub(crate) fn without_branches(self) -> Self {
        Self { keeps_orientation: true, ..self }
    }

    /// Another of the same kind with another rule.
    pub(crate) fn with_rule(&self, rule: impl FnOnce(PathRule) -> PathRule) -> Self {
        Self { keeps_orientation: self.keeps_orientation, ..Self::new(rule(self.rule), self.go_on) }
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
        self.corrected_within(equations, guess, closing, towards, self.rule.iterations)
    }

    /// The same; after so many steps that do not halve what is left it gives up.
    ///
    /// # Errors
    /// As [`Newton::corrected`].
    pub(super) fn corrected_within<E: PathEquations>(
        &mut self,
        equations: &mut E,
        guess: &[f64],
        closing: &ClosingEquation,
        towards: &[f64],
        patience: usize,
    ) -> Result<PathPoint, CyclesError> {
        /// The step of Newton's method, and the tangent.
        const SIDES: usize = 2;
        let size = guess.len();
        let mut at = guess.to_vec();
        let [mut most, mut norm] = left(equations, closing, &at)?;
        let (mut least, mut since, mut iteration) = (norm, 0, 0);
        while iteration < self.rule.iterations && since < patience {
            iteration += 1;
            if !(self.go_on)() {
                return Err(CyclesError::Stopped);
            }
            self.assemble(equations, &at, &closing.row, SIDES)?;
            let step = self.right.col_as_slice_mut(0);
            step.iter_mut().zip(equations.residual(&at)?).for_each(|(own, residual)| *own = -residual);
            step[size - 1] = -closing.left(&at);
            let sign = self.solve()?;
            (at, [most, norm]) = self.shortened(equations, closing, &at, norm)?;
            if most <= self.rule.tolerance {
                let (tangent, turned) = unit(self.right.col_as_slice(1), equations.weights(), towards);
                let orientation = sign * turned;
                return Ok(PathPoint { at, tangent, orientation, residual: most, iterations: iteration });
            }
            (least, since) = if norm < 0.5 * least { (norm, 0) } else { (least, since + 1) };
        }
        Err(CyclesError::NotConverged { iterations: iteration, residual: most })
    }

    /// Where the part of the step that leaves least leads to, and what is left there: none need leave less where points change their states.
    fn shortened<E: PathEquations>(
        &self,
        equations: &mut E,
        closing: &ClosingEquation,
        at: &[f64],
        norm: f64,
    ) -> Result<(Vec<f64>, [f64; 2]), CyclesError> {
        let step = self.right.col_as_slice(0);
        let mut best: Option<(Vec<f64>, [f64; 2])> = None;
        for share in [1.0, 0.5, 0.25, 0.1] {
            let tried: Vec<f64> = at.iter().zip(step).map(|(own, step)| own + share * step).collect();
            let Ok(now) = left(equations, closing, &tried) else { continue };
            if best.as_ref().is_none_or(|(_, best)| now[1] < best[1]) {
                best = Some((tried, now));
            }
            if now[1] < (1.0 - 0.3 * share) * norm {
                break;
            }
        }
        best.ok_or(CyclesError::Singular)
    }

    /// The tangent that the equations have at a place.
    pub(super) fn tangent_at<E: PathEquations>(
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

/// What is left of the equations and of the closing one: the largest, and the root of the sum of squares.
fn left<E: PathEquations>(
    equations: &mut E,
    closing: &ClosingEquation,
    at: &[f64],
) -> Result<[f64; 2], CyclesError> {
    let (residual, own) = (equations.residual(at)?, closing.left(at));
    Ok([largest(residual).max(largest(&[own])), (dot(residual, residual) + own * own).sqrt()])
}

/// A direction of length one in the weights that points as another does, and −1 where that turned it.
fn unit(direction: &[f64], weights: &[f64], towards: &[f64]) -> (Vec<f64>, f64) {
    let length = weighted(direction, direction, weights).sqrt();
    let sign = if weighted(direction, towards, weights) < 0.0 { -1.0 } else { 1.0 };
    (direction.iter().map(|own| sign * own / length).collect(), sign)
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, own| if own.is_nan() { f64::INFINITY } else { most.max(own.abs()) })
}
