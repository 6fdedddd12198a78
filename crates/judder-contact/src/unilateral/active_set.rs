//! The primal-dual active set: guess the cells in contact, solve there, let pressures and gaps correct the guess.

use super::problem::{
    Loading, UnilateralError, UnilateralErrors, UnilateralLimits, UnilateralProblem, UnilateralSolution,
};
use crate::surface::operator::SurfaceOperator;
use judder_numerics::gmres::{GmresError, GmresLimits, PreconditionedOperator, gmres};
use judder_numerics::order::sort_numbers;

/// Directions kept by the linear solver.
const RESTART: usize = 60;
/// Residual of the first linear solves from nothing: the contact set is still a guess.
const COLD: f64 = 1e-2;
/// Residual of the first linear solve from the pressure of a coarser grid.
const WARM: f64 = 1e-4;
/// The mean residual of the last linear solve over the largest that is allowed: it peaks at the edge of the contact.
const LINEAR: f64 = 0.05;
/// By how much the linear residual falls from one contact set to the next.
const STEP: f64 = 0.05;
/// The part of the contact set below which its changes are worth a smaller residual.
const SETTLED: f64 = 0.03;
/// Contact sets tried without progress before fewer cells are changed at a time.
const PATIENCE: usize = 8;

/// A pressure and a depth to start from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct UnilateralStart<'a> {
    /// Pressure on every cell; cells with a positive pressure are taken to be in contact.
    pub pressure: &'a [f64],
    /// δ to start from under an imposed load; an imposed indentation overrides it.
    pub indentation: f64,
}

/// Solves the unilateral problem for any positive definite operator, symmetric or not.
///
/// On the guessed contact set the pressure solves K p = δ − h by GMRES, preconditioned by the operator's symbol; cells
/// that pull leave the set, cells that penetrate enter it (Hintermüller, Ito and Kunisch 2002). Under an imposed load
/// the depth is one unknown more, the force balance one equation more. The linear residual tightens as the set comes
/// to rest. Where the set stops coming to rest only the worst cells change.
///
/// # Errors
/// [`UnilateralError`] for heights or a loading that cannot be served, and where products overflow. A solution
/// that did not converge is no error: it says so.
pub fn solve(
    operator: &mut dyn SurfaceOperator,
    problem: &UnilateralProblem<'_>,
    start: UnilateralStart<'_>,
    limits: UnilateralLimits,
) -> Result<UnilateralSolution, UnilateralError> {
    problem.check(operator.grid())?;
    let mut iterate = ActiveSetIterate::new(operator, problem, start);
    let mut progress = SolverProgress::new();
    let mut finest = LINEAR * limits.tolerance;
    let mut tolerance = if start.pressure.iter().any(|p| *p > 0.0) { WARM } else { COLD }.max(finest);
    let mut converged = false;
    while progress.iterations < limits.iterations && iterate.products < limits.products {
        progress.iterations += 1;
        iterate.solve_on_contact(operator, tolerance, limits.products)?;
        let violations = iterate.violations(operator, limits.tolerance);
        if violations.is_empty() {
            if tolerance <= finest {
                converged = iterate.errors(operator).worst() <= limits.tolerance;
                if converged {
                    break;
                }
                finest *= STEP;
            }
            // A set at rest is most often the last: no more residuals on the way.
            tolerance = finest;
            continue;
        }
        progress.note(violations.len());
        tolerance = progress.tighter(tolerance, violations.len(), iterate.contact_size()).max(finest);
        iterate.change(&violations, progress.share_to_change());
    }
    if !converged {
        // The last change of the set left a pressure that the gap does not belong to.
        iterate.update_gap(operator);
    }
    let errors = iterate.errors(operator);
    Ok(iterate.into_solution(errors, progress.iterations, converged))
}

/// How the count of changed cells develops, and what follows from it.
struct SolverProgress {
    iterations: usize,
    fewest: usize,
    since_fewest: usize,
    careful: u32,
}

impl SolverProgress {
    fn new() -> Self {
        Self { iterations: 0, fewest: usize::MAX, since_fewest: 0, careful: 0 }
    }

    fn note(&mut self, changes: usize) {
        if changes < self.fewest {
            self.fewest = changes;
            self.since_fewest = 0;
            self.careful = self.careful.saturating_sub(1);
        } else {
            self.since_fewest += 1;
            if self.since_fewest >= PATIENCE {
                self.since_fewest = 0;
                self.fewest = usize::MAX;
                self.careful += 1;
            }
        }
    }

    /// The next linear residual: the same while much of the set still changes, a step smaller when little does.
    fn tighter(&self, tolerance: f64, changes: usize, contact: usize) -> f64 {
        let settled = (changes as f64) < SETTLED * contact as f64;
        if settled || self.since_fewest > 1 { tolerance * STEP } else { tolerance }
    }

    /// The part of the violating cells that may change, worst first.
    fn share_to_change(&self) -> f64 {
        0.5_f64.powi(i32::try_from(self.careful.min(30)).unwrap_or(30))
    }
}

/// A cell on the wrong side, and by how much (as a displacement over the depth).
struct Violation {
    cell: usize,
    size: f64,
}

/// The current guess.
struct ActiveSetIterate<'a> {
    heights: &'a [f64],
    loading: Loading,
    pressure: Vec<f64>,
    gap: Vec<f64>,
    in_contact: Vec<bool>,
    indentation: f64,
    products: usize,
}

impl<'a> ActiveSetIterate<'a> {
    fn new(
        operator: &dyn SurfaceOperator,
        problem: &UnilateralProblem<'a>,
        start: UnilateralStart<'_>,
    ) -> Self {
        let cells = operator.grid().len();
        let indentation = match problem.loading {
            Loading::Indentation(depth) => depth,
            Loading::Load(_) => start.indentation,
        };
        let pressure: Vec<f64> = start.pressure.iter().map(|value| value.max(0.0)).collect();
        let mut in_contact: Vec<bool> = pressure.iter().map(|value| *value > 0.0).collect();
        if !in_contact.contains(&true) {
            in_contact = problem.heights.iter().map(|height| *height < indentation).collect();
        }
        let gap = vec![0.0; cells];
        Self {
            heights: problem.heights,
            loading: problem.loading,
            pressure,
            gap,
            in_contact,
            indentation,
            products: 0,
        }
    }

    fn contact_size(&self) -> usize {
        self.in_contact.iter().filter(|inside| **inside).count()
    }

    /// Solves K p = δ − h on the contact set, from the pressure of the last set.
    fn solve_on_contact(
        &mut self,
        operator: &mut dyn SurfaceOperator,
        tolerance: f64,
        products: usize,
    ) -> Result<(), UnilateralError> {
        if !self.in_contact.contains(&true) {
            self.in_contact[lowest(self.heights)] = true;
        }
        let cells: Vec<usize> = (0..self.in_contact.len()).filter(|cell| self.in_contact[*cell]).collect();
        let mut restricted = Restricted::new(operator, &cells, matches!(self.loading, Loading::Load(_)));
        let right = restricted.right_hand_side(self.heights, self.loading);
        let mut unknowns: Vec<f64> = cells.iter().map(|cell| self.pressure[*cell]).collect();
        if restricted.loaded {
            unknowns.push(self.indentation);
        }
        let left = products.saturating_sub(self.products).max(1);
        let outcome = gmres(
            &mut restricted,
            &right,
            &mut unknowns,
            GmresLimits { tolerance, products: left, restart: RESTART },
        )
        .map_err(|GmresError::NotFinite { products }| UnilateralError::NotFinite {
            products: self.products + products,
        })?;
        self.products += outcome.products;
        self.pressure.fill(0.0);
        for (cell, value) in cells.iter().zip(&unknowns) {
            self.pressure[*cell] = *value;
        }
        if restricted.loaded {
            self.indentation = unknowns[cells.len()];
        }
        Ok(())
    }

    /// g = K p + h − δ of the pressure as it is.
    fn update_gap(&mut self, operator: &mut dyn SurfaceOperator) {
        operator.displacement(&self.pressure, &mut self.gap);
        self.products += 1;
        for (gap, height) in self.gap.iter_mut().zip(self.heights) {
            *gap += height - self.indentation;
        }
    }

    /// The cells in contact that pull and the open cells that penetrate.
    fn violations(&mut self, operator: &mut dyn SurfaceOperator, tolerance: f64) -> Vec<Violation> {
        self.update_gap(operator);
        let per_pressure = operator.self_displacement() / self.indentation.abs();
        let per_gap = 1.0 / self.indentation.abs();
        (0..self.gap.len())
            .filter_map(|cell| {
                let size = if self.in_contact[cell] {
                    -self.pressure[cell] * per_pressure
                } else {
                    -self.gap[cell] * per_gap - 0.5 * tolerance
                };
                (size > 0.0).then_some(Violation { cell, size })
            })
            .collect()
    }

    /// Moves the worst part of the violating cells to the other side.
    fn change(&mut self, violations: &[Violation], share: f64) {
        let threshold = if share < 1.0 {
            let mut sizes: Vec<f64> = violations.iter().map(|violation| violation.size).collect();
            sort_numbers(&mut sizes);
            let keep = ((share * sizes.len() as f64).ceil() as usize).clamp(1, sizes.len());
            sizes[sizes.len() - keep]
        } else {
            0.0
        };
        for violation in violations.iter().filter(|violation| violation.size >= threshold) {
            self.in_contact[violation.cell] = !self.in_contact[violation.cell];
            self.pressure[violation.cell] = 0.0;
        }
    }

    fn errors(&self, operator: &dyn SurfaceOperator) -> UnilateralErrors {
        let load = match self.loading {
            Loading::Indentation(_) => 0.0,
            Loading::Load(force) => {
                (self.pressure.iter().sum::<f64>() * operator.grid().cell_area() / force - 1.0).abs()
            }
        };
        UnilateralErrors::of(&self.pressure, &self.gap, self.indentation, load)
    }

    fn into_solution(
        self,
        errors: UnilateralErrors,
        iterations: usize,
        converged: bool,
    ) -> UnilateralSolution {
        let Self { pressure, gap, indentation, products, .. } = self;
        UnilateralSolution { pressure, gap, indentation, errors, converged, iterations, products }
    }
}

fn lowest(heights: &[f64]) -> usize {
    (0..heights.len()).min_by(|a, b| heights[*a].total_cmp(&heights[*b])).unwrap_or(0)
}

/// The operator between the cells in contact; with an imposed load the depth is the last unknown, the force balance
/// the last equation.
struct Restricted<'a> {
    operator: &'a mut dyn SurfaceOperator,
    cells: &'a [usize],
    loaded: bool,
    /// Turns a sum of pressures into a displacement, so that all equations weigh alike.
    balance: f64,
    /// K⁻¹ 1 on the contact set, approximately: the pressure of a flat punch.
    punch: Vec<f64>,
    full_in: Vec<f64>,
    full_out: Vec<f64>,
}

impl<'a> Restricted<'a> {
    fn new(operator: &'a mut dyn SurfaceOperator, cells: &'a [usize], loaded: bool) -> Self {
        let size = operator.grid().len();
        let balance = 0.5 * operator.self_displacement();
        let (full_in, full_out) = (vec![0.0; size], vec![0.0; size]);
        let mut restricted = Self { operator, cells, loaded, balance, punch: Vec::new(), full_in, full_out };
        if loaded {
            let mut punch = vec![0.0; cells.len()];
            restricted.precondition_pressure(&vec![1.0; cells.len()], &mut punch);
            restricted.punch = punch;
        }
        restricted
    }

    fn right_hand_side(&self, heights: &[f64], loading: Loading) -> Vec<f64> {
        match loading {
            Loading::Indentation(depth) => self.cells.iter().map(|cell| depth - heights[*cell]).collect(),
            Loading::Load(force) => {
                let mut right: Vec<f64> = self.cells.iter().map(|cell| -heights[*cell]).collect();
                right.push(self.balance * force / self.operator.grid().cell_area());
                right
            }
        }
    }

    fn scatter(&mut self, values: &[f64]) {
        self.full_in.fill(0.0);
        for (cell, value) in self.cells.iter().zip(values) {
            self.full_in[*cell] = *value;
        }
    }

    fn gather(&self, values: &mut [f64]) {
        for (value, cell) in values.iter_mut().zip(self.cells) {
            *value = self.full_out[*cell];
        }
    }

    fn precondition_pressure(&mut self, displacement: &[f64], pressure: &mut [f64]) {
        self.scatter(displacement);
        self.operator.precondition(&self.full_in, &mut self.full_out);
        self.gather(pressure);
    }
}

impl PreconditionedOperator for Restricted<'_> {
    fn apply(&mut self, x: &[f64], y: &mut [f64]) {
        let inside = self.cells.len();
        self.scatter(&x[..inside]);
        self.operator.displacement(&self.full_in, &mut self.full_out);
        self.gather(&mut y[..inside]);
        if self.loaded {
            let depth = x[inside];
            for displacement in &mut y[..inside] {
                *displacement -= depth;
            }
            y[inside] = self.balance * x[..inside].iter().sum::<f64>();
        }
    }

    fn precondition(&mut self, x: &[f64], y: &mut [f64]) {
        let inside = self.cells.len();
        self.precondition_pressure(&x[..inside], &mut y[..inside]);
        if self.loaded {
            let carried: f64 = y[..inside].iter().sum();
            let stiffness: f64 = self.punch.iter().sum();
            let depth = (x[inside] / self.balance - carried) / stiffness;
            for (pressure, punch) in y[..inside].iter_mut().zip(&self.punch) {
                *pressure += depth * punch;
            }
            y[inside] = depth;
        }
    }
}
