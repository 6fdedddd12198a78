//! Conjugate gradients under p ≥ 0, for the symmetric operator of an elastic substrate.

use super::active_set::UnilateralStart;
use super::problem::{
    Loading, UnilateralError, UnilateralErrors, UnilateralLimits, UnilateralProblem, UnilateralSolution,
};
use crate::surface::operator::SurfaceOperator;

/// By how much the residual falls on a contact set before the set is chosen anew: the fewest products, by measurement.
const REDUCTION: f64 = 0.3;
/// The residual below which more steps on a set are lost: its root mean square over the error that is allowed.
const FAR_BELOW: f64 = 0.1;
/// The penetration, over the error that is allowed, from which an open cell joins the set.
const JOINS: f64 = 0.5;

/// Solves the unilateral problem for a symmetric operator: the least ½ p·K p − p·(δ − h) over all p ≥ 0.
///
/// Conjugate gradients run on the cells that press or penetrate, preconditioned by the operator's symbol restricted
/// to these cells. Once the residual has fallen, pressures that pull become zero and the cells are chosen anew.
/// Without the preconditioner and with a new choice after every step this is the method of Polonsky and Keer (1999).
/// Under an imposed load every direction keeps the load, and δ is the mean of K p + h where p > 0. On a periodic
/// surface whose mean displacement is zero an imposed δ means an imposed mean gap, that of h less δ.
///
/// # Errors
/// [`UnilateralError`] for heights or a loading that cannot be served, for an operator that is not symmetric, and
/// where products overflow. A solution that did not converge is no error: it says so.
pub fn solve(
    operator: &mut dyn SurfaceOperator,
    problem: &UnilateralProblem<'_>,
    start: UnilateralStart<'_>,
    limits: UnilateralLimits,
) -> Result<UnilateralSolution, UnilateralError> {
    problem.check(operator.grid())?;
    if !operator.is_symmetric() {
        return Err(UnilateralError::NotSymmetric);
    }
    let mut descent = Descent::new(operator, problem, start);
    let mut iterations = 0;
    loop {
        descent.update_gap(operator);
        let errors = descent.errors()?;
        let converged = errors.worst() <= limits.tolerance;
        let spent = iterations >= limits.iterations || descent.products >= limits.products;
        if converged || spent {
            return Ok(descent.into_solution(errors, converged, iterations));
        }
        iterations += 1;
        descent.choose_cells(limits.tolerance);
        if !descent.descend(operator, limits) {
            return Ok(descent.into_solution(errors, false, iterations));
        }
        descent.project();
    }
}

/// Pressures and gaps on the whole grid; on the chosen cells, in their order, what the conjugate gradients need.
struct Descent<'a> {
    heights: &'a [f64],
    /// Σ p under an imposed load.
    total: Option<f64>,
    indentation: f64,
    pressure: Vec<f64>,
    gap: Vec<f64>,
    products: usize,
    cells: Vec<usize>,
    values: Vec<f64>,
    residual: Vec<f64>,
    corrected: Vec<f64>,
    direction: Vec<f64>,
    image: Vec<f64>,
    full_in: Vec<f64>,
    full_out: Vec<f64>,
}

impl<'a> Descent<'a> {
    fn new(
        operator: &dyn SurfaceOperator,
        problem: &UnilateralProblem<'a>,
        start: UnilateralStart<'_>,
    ) -> Self {
        let grid = operator.grid();
        let size = grid.len();
        let (total, indentation) = match problem.loading {
            Loading::Load(force) => (Some(force / grid.cell_area()), start.indentation),
            Loading::Indentation(depth) => (None, depth),
        };
        let mut pressure: Vec<f64> = start.pressure.iter().map(|value| value.max(0.0)).collect();
        pressure.resize(size, 0.0);
        if let Some(total) = total {
            let sum: f64 = pressure.iter().sum();
            if sum > 0.0 {
                pressure.iter_mut().for_each(|value| *value *= total / sum);
            } else {
                pressure.fill(total / size as f64);
            }
        }
        Self {
            heights: problem.heights,
            total,
            indentation,
            pressure,
            gap: vec![0.0; size],
            products: 0,
            cells: Vec::with_capacity(size),
            values: Vec::with_capacity(size),
            residual: Vec::with_capacity(size),
            corrected: Vec::with_capacity(size),
            direction: Vec::with_capacity(size),
            image: Vec::with_capacity(size),
            full_in: vec![0.0; size],
            full_out: vec![0.0; size],
        }
    }

    /// g = K p + h − δ, with the δ that closes the gap on average under an imposed load.
    fn update_gap(&mut self, operator: &mut dyn SurfaceOperator) {
        operator.displacement(&self.pressure, &mut self.gap);
        self.products += 1;
        let (mut sum, mut pressing) = (0.0, 0_usize);
        for ((gap, height), pressure) in self.gap.iter_mut().zip(self.heights).zip(&self.pressure) {
            *gap += height;
            if *pressure > 0.0 {
                sum += *gap;
                pressing += 1;
            }
        }
        if self.total.is_some() {
            self.indentation = sum / pressing as f64;
        }
        let indentation = self.indentation;
        self.gap.iter_mut().for_each(|gap| *gap -= indentation);
    }

    fn errors(&self) -> Result<UnilateralErrors, UnilateralError> {
        let sum: f64 = self.pressure.iter().sum();
        if !(sum + self.gap.iter().sum::<f64>()).is_finite() {
            return Err(UnilateralError::NotFinite { products: self.products });
        }
        let load = self.total.map_or(0.0, |total| ((sum - total) / total).abs());
        Ok(UnilateralErrors::of(&self.pressure, &self.gap, self.indentation, load))
    }

    /// The cells that press or penetrate, and the residual −g there.
    fn choose_cells(&mut self, tolerance: f64) {
        let joins = -JOINS * tolerance * self.indentation.abs();
        self.cells.clear();
        self.values.clear();
        self.residual.clear();
        for (cell, (pressure, gap)) in self.pressure.iter().zip(&self.gap).enumerate() {
            if *pressure > 0.0 || *gap < joins {
                self.cells.push(cell);
                self.values.push(*pressure);
                self.residual.push(-gap);
            }
        }
        for vector in [&mut self.corrected, &mut self.direction, &mut self.image] {
            vector.clear();
            vector.resize(self.cells.len(), 0.0);
        }
    }

    /// Conjugate gradients on the chosen cells; false where there is no direction left to go.
    fn descend(&mut self, operator: &mut dyn SurfaceOperator, limits: UnilateralLimits) -> bool {
        let loaded = self.total.is_some();
        free_of_mean(&mut self.residual, loaded);
        let far_below = FAR_BELOW * limits.tolerance * self.indentation * (self.cells.len() as f64).sqrt();
        let enough = (REDUCTION * norm(&self.residual)).max(far_below.abs());
        let mut previous = f64::INFINITY;
        while self.products < limits.products {
            self.scatter(CellVector::Residual);
            operator.precondition(&self.full_in, &mut self.full_out);
            gather(&self.cells, &self.full_out, &mut self.corrected);
            free_of_mean(&mut self.corrected, loaded);
            let progress = dot(&self.corrected, &self.residual);
            let kept = progress / previous;
            previous = progress;
            for (direction, corrected) in self.direction.iter_mut().zip(&self.corrected) {
                *direction = corrected + kept * *direction;
            }
            self.scatter(CellVector::Direction);
            operator.displacement(&self.full_in, &mut self.full_out);
            self.products += 1;
            gather(&self.cells, &self.full_out, &mut self.image);
            let curvature = dot(&self.direction, &self.image);
            if !(progress > 0.0 && curvature > 0.0) {
                return false;
            }
            let step = progress / curvature;
            for cell in 0..self.cells.len() {
                self.values[cell] += step * self.direction[cell];
                self.residual[cell] -= step * self.image[cell];
            }
            free_of_mean(&mut self.residual, loaded);
            if norm(&self.residual) <= enough {
                break;
            }
        }
        true
    }

    /// Puts the values of the chosen cells back on the grid, without those that pull and with the imposed load.
    fn project(&mut self) {
        self.pressure.fill(0.0);
        for (cell, value) in self.cells.iter().zip(&self.values) {
            self.pressure[*cell] = value.max(0.0);
        }
        if let Some(total) = self.total {
            let scale = total / self.pressure.iter().sum::<f64>();
            self.pressure.iter_mut().for_each(|value| *value *= scale);
        }
    }

    fn scatter(&mut self, vector: CellVector) {
        let values = match vector {
            CellVector::Residual => &self.residual,
            CellVector::Direction => &self.direction,
        };
        self.full_in.fill(0.0);
        for (cell, value) in self.cells.iter().zip(values) {
            self.full_in[*cell] = *value;
        }
    }

    fn into_solution(
        self,
        errors: UnilateralErrors,
        converged: bool,
        iterations: usize,
    ) -> UnilateralSolution {
        UnilateralSolution {
            pressure: self.pressure,
            gap: self.gap,
            indentation: self.indentation,
            errors,
            converged,
            iterations,
            products: self.products,
        }
    }
}

/// A vector on the chosen cells that an operator is applied to.
#[derive(Clone, Copy)]
enum CellVector {
    Residual,
    Direction,
}

fn gather(cells: &[usize], full: &[f64], values: &mut [f64]) {
    for (value, cell) in values.iter_mut().zip(cells) {
        *value = full[*cell];
    }
}

/// Under an imposed load: takes the mean away, so that a direction adds no load.
fn free_of_mean(values: &mut [f64], loaded: bool) {
    if loaded {
        let mean = values.iter().sum::<f64>() / values.len() as f64;
        values.iter_mut().for_each(|value| *value -= mean);
    }
}

fn dot(left: &[f64], right: &[f64]) -> f64 {
    left.iter().zip(right).map(|(a, b)| a * b).sum()
}

fn norm(values: &[f64]) -> f64 {
    dot(values, values).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernel::sliding::SlidingOperator;
    use crate::kernel::substrate::SlidingSubstrate;
    use crate::surface::grid::SurfaceGrid;

    const NOWHERE: UnilateralStart<'static> = UnilateralStart { pressure: &[], indentation: 0.0 };

    fn elastic(grid: SurfaceGrid) -> SlidingOperator {
        SlidingOperator::new(grid, &SlidingSubstrate::elastic(), u64::MAX).unwrap()
    }

    fn paraboloid(grid: &SurfaceGrid) -> Vec<f64> {
        let (columns, rows) = (0..grid.columns, 0..grid.rows);
        rows.flat_map(|row| columns.clone().map(move |column| (column, row)))
            .map(|(column, row)| 0.5 * (grid.x(column).powi(2) + grid.y(row).powi(2)))
            .collect()
    }

    #[test]
    fn gives_the_force_of_hertz() {
        let depth: f64 = 0.01;
        let grid = SurfaceGrid::square(64, [0.0; 2], 1.2 * depth.sqrt());
        let heights = paraboloid(&grid);
        let problem = UnilateralProblem { heights: &heights, loading: Loading::Indentation(depth) };
        let limits = UnilateralLimits { tolerance: 1e-8, ..UnilateralLimits::default() };
        let solution = solve(&mut elastic(grid), &problem, NOWHERE, limits).unwrap();
        let force = solution.pressure.iter().sum::<f64>() * grid.cell_area();
        let hertz = 4.0 / 3.0 * depth.powf(1.5);
        assert!(solution.converged && solution.errors.worst() <= 1e-8, "{:?}", solution.errors);
        assert!((force / hertz - 1.0).abs() < 2e-3, "{}", force / hertz);
    }

    #[test]
    fn finds_the_depth_of_a_load() {
        let grid = SurfaceGrid::square(32, [0.0; 2], 0.12);
        let heights = paraboloid(&grid);
        let limits = UnilateralLimits { tolerance: 1e-9, ..UnilateralLimits::default() };
        let imposed = UnilateralProblem { heights: &heights, loading: Loading::Indentation(0.01) };
        let pressed = solve(&mut elastic(grid), &imposed, NOWHERE, limits).unwrap();
        let force = pressed.pressure.iter().sum::<f64>() * grid.cell_area();
        let loaded = UnilateralProblem { heights: &heights, loading: Loading::Load(force) };
        let found = solve(&mut elastic(grid), &loaded, NOWHERE, limits).unwrap();
        assert!(found.converged, "{:?}", found.errors);
        assert!((found.indentation / 0.01 - 1.0).abs() < 1e-8, "{}", found.indentation);
    }

    #[test]
    fn a_solve_cut_short_has_not_converged() {
        let grid = SurfaceGrid::square(32, [0.0; 2], 0.12);
        let heights = paraboloid(&grid);
        let problem = UnilateralProblem { heights: &heights, loading: Loading::Indentation(0.01) };
        let limits = UnilateralLimits { tolerance: 1e-8, iterations: 1, products: 4000 };
        let solution = solve(&mut elastic(grid), &problem, NOWHERE, limits).unwrap();
        assert!(!solution.converged && solution.errors.worst() > 1e-8);
    }

    #[test]
    fn refuses_an_operator_that_is_not_symmetric() {
        let grid = SurfaceGrid::square(8, [0.0; 2], 0.12);
        let mut sliding = SlidingOperator::new(grid, &SlidingSubstrate::single(10.0, 0.1), u64::MAX).unwrap();
        let heights = paraboloid(&grid);
        let problem = UnilateralProblem { heights: &heights, loading: Loading::Indentation(0.01) };
        let error = solve(&mut sliding, &problem, NOWHERE, UnilateralLimits::default());
        assert_eq!(error, Err(UnilateralError::NotSymmetric));
    }
}
