//! Generalised minimal residuals for a large, non-symmetric system known only by its products.

use thiserror::Error;

/// How far a solve goes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GmresLimits {
    /// The residual, as a fraction of the norm of the right-hand side, at which the solve ends.
    pub tolerance: f64,
    /// The largest number of products with the operator.
    pub products: usize,
    /// The number of directions kept before the solve starts over from where it is.
    pub restart: usize,
}

/// What a solve came to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GmresOutcome {
    /// Products with the operator.
    pub products: usize,
    /// The residual ‖b − A x‖/‖b‖ as the recurrence knows it.
    pub residual: f64,
}

/// Why a solve gave nothing.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum GmresError {
    /// A product or the right-hand side is not finite.
    #[error("a product with the operator is not finite (after {products} products)")]
    NotFinite {
        /// Products made before it was seen.
        products: usize,
    },
}

/// A linear operator with a cheap approximate inverse, both acting on vectors of one length.
pub trait PreconditionedOperator {
    /// y = A x.
    fn apply(&mut self, x: &[f64], y: &mut [f64]);
    /// y ≈ A⁻¹ x.
    fn precondition(&mut self, x: &[f64], y: &mut [f64]);
}

/// Solves A x = b by restarted GMRES with right preconditioning (Saad and Schultz 1986), starting from the given x.
///
/// Right preconditioning keeps the true residual in the recurrence, so the tolerance means ‖b − A x‖/‖b‖.
/// A zero right-hand side gives x = 0. The solve ends at the limit of products without an error: the residual tells.
///
/// # Errors
/// [`GmresError::NotFinite`] when a product or the right-hand side holds NaN or an infinity.
pub fn gmres(
    operator: &mut impl PreconditionedOperator,
    right: &[f64],
    solution: &mut [f64],
    limits: GmresLimits,
) -> Result<GmresOutcome, GmresError> {
    let scale = norm(right);
    let mut products = 0;
    if !scale.is_finite() {
        return Err(GmresError::NotFinite { products });
    }
    if scale == 0.0 {
        solution.fill(0.0);
        return Ok(GmresOutcome { products, residual: 0.0 });
    }
    let mut residual = vec![0.0; right.len()];
    loop {
        let norm = true_residual(operator, right, solution, &mut residual, &mut products);
        if !norm.is_finite() {
            return Err(GmresError::NotFinite { products });
        }
        if norm <= limits.tolerance * scale || products >= limits.products {
            return Ok(GmresOutcome { products, residual: norm / scale });
        }
        let steps = limits.restart.min(limits.products - products).max(1);
        let reached =
            cycle(operator, &residual, norm, solution, limits.tolerance * scale, steps, &mut products)?;
        if reached <= limits.tolerance * scale {
            return Ok(GmresOutcome { products, residual: reached / scale });
        }
    }
}

/// b − A x and its norm; no product for x = 0.
fn true_residual(
    operator: &mut impl PreconditionedOperator,
    right: &[f64],
    solution: &[f64],
    residual: &mut [f64],
    products: &mut usize,
) -> f64 {
    if solution.iter().all(|value| *value == 0.0) {
        residual.copy_from_slice(right);
    } else {
        operator.apply(solution, residual);
        *products += 1;
        for (r, b) in residual.iter_mut().zip(right) {
            *r = b - *r;
        }
    }
    norm(residual)
}

/// One Arnoldi process of at most `steps` directions; adds the correction to the solution and gives the residual's norm.
fn cycle(
    operator: &mut impl PreconditionedOperator,
    residual: &[f64],
    start: f64,
    solution: &mut [f64],
    target: f64,
    steps: usize,
    products: &mut usize,
) -> Result<f64, GmresError> {
    let mut basis = vec![scaled(residual, 1.0 / start)];
    let mut triangle: Vec<Vec<f64>> = Vec::with_capacity(steps);
    let mut rotations: Vec<(f64, f64)> = Vec::with_capacity(steps);
    let mut projected = vec![start];
    let mut preconditioned = vec![0.0; residual.len()];
    while triangle.len() < steps && projected[triangle.len()].abs() > target {
        let mut next = vec![0.0; residual.len()];
        operator.precondition(&basis[basis.len() - 1], &mut preconditioned);
        operator.apply(&preconditioned, &mut next);
        *products += 1;
        let mut column = orthogonalise(&basis, &mut next);
        let length = norm(&next);
        if !length.is_finite() {
            return Err(GmresError::NotFinite { products: *products });
        }
        for (i, (cosine, sine)) in rotations.iter().enumerate() {
            (column[i], column[i + 1]) =
                (cosine * column[i] + sine * column[i + 1], cosine * column[i + 1] - sine * column[i]);
        }
        let last = column.len() - 1;
        let radius = libm::hypot(column[last], length);
        if radius == 0.0 {
            break;
        }
        let (cosine, sine) = (column[last] / radius, length / radius);
        column[last] = radius;
        let carried = projected[last];
        projected[last] = cosine * carried;
        projected.push(-sine * carried);
        rotations.push((cosine, sine));
        triangle.push(column);
        if length == 0.0 {
            break;
        }
        next.iter_mut().for_each(|value| *value /= length);
        basis.push(next);
    }
    let weights = back_substitute(&triangle, &projected);
    let mut direction = vec![0.0; residual.len()];
    for (vector, weight) in basis.iter().zip(&weights) {
        add_scaled(&mut direction, *weight, vector);
    }
    operator.precondition(&direction, &mut preconditioned);
    add_scaled(solution, 1.0, &preconditioned);
    Ok(projected[triangle.len()].abs())
}

/// Takes the components along the basis out of a vector, twice, and gives them.
///
/// Twice is enough (Giraud et al. 2005): classical Gram–Schmidt alone loses the basis where the operator is ill-conditioned.
fn orthogonalise(basis: &[Vec<f64>], vector: &mut [f64]) -> Vec<f64> {
    let mut components = vec![0.0; basis.len()];
    for _ in 0..2 {
        for (component, direction) in components.iter_mut().zip(basis) {
            let along = dot(direction, vector);
            *component += along;
            add_scaled(vector, -along, direction);
        }
    }
    components
}

/// Solves the triangular system whose columns grew by one entry each.
fn back_substitute(columns: &[Vec<f64>], right: &[f64]) -> Vec<f64> {
    let mut weights = right[..columns.len()].to_vec();
    for i in (0..columns.len()).rev() {
        weights[i] /= columns[i][i];
        let weight = weights[i];
        for (entry, above) in weights[..i].iter_mut().zip(&columns[i]) {
            *entry -= weight * above;
        }
    }
    weights
}

fn scaled(vector: &[f64], factor: f64) -> Vec<f64> {
    vector.iter().map(|value| value * factor).collect()
}

fn add_scaled(sum: &mut [f64], factor: f64, vector: &[f64]) {
    for (entry, value) in sum.iter_mut().zip(vector) {
        *entry += factor * value;
    }
}

/// The inner product in eight partial sums, an order of its own that does not depend on the machine.
#[must_use]
pub fn dot(left: &[f64], right: &[f64]) -> f64 {
    let mut partial = [0.0; 8];
    let (left_blocks, right_blocks) = (left.chunks_exact(8), right.chunks_exact(8));
    let tail: f64 = left_blocks.remainder().iter().zip(right_blocks.remainder()).map(|(a, b)| a * b).sum();
    for (a, b) in left_blocks.zip(right_blocks) {
        for (sum, (x, y)) in partial.iter_mut().zip(a.iter().zip(b)) {
            *sum += x * y;
        }
    }
    partial.iter().sum::<f64>() + tail
}

/// The Euclidean norm.
#[must_use]
pub fn norm(vector: &[f64]) -> f64 {
    dot(vector, vector).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A diagonal plus a shift: non-symmetric, with an inverse of the diagonal as preconditioner.
    struct Shifted {
        diagonal: Vec<f64>,
    }

    impl PreconditionedOperator for Shifted {
        fn apply(&mut self, x: &[f64], y: &mut [f64]) {
            for i in 0..x.len() {
                y[i] = self.diagonal[i] * x[i] + if i > 0 { 0.7 * x[i - 1] } else { 0.0 };
            }
        }

        fn precondition(&mut self, x: &[f64], y: &mut [f64]) {
            for i in 0..x.len() {
                y[i] = x[i] / self.diagonal[i];
            }
        }
    }

    fn problem() -> (Shifted, Vec<f64>, Vec<f64>) {
        let diagonal: Vec<f64> = (0..50).map(|i| 1.0 + 0.3 * f64::from(i)).collect();
        let exact: Vec<f64> = (0..50).map(|i| f64::from(i * 7 % 11) - 4.0).collect();
        let mut operator = Shifted { diagonal };
        let mut right = vec![0.0; 50];
        operator.apply(&exact, &mut right);
        (operator, right, exact)
    }

    #[test]
    fn the_solution_is_found_with_and_without_restarts() {
        for restart in [5, 60] {
            let (mut operator, right, exact) = problem();
            let mut solution = vec![0.0; 50];
            let limits = GmresLimits { tolerance: 1e-12, products: 400, restart };
            let outcome = gmres(&mut operator, &right, &mut solution, limits).unwrap();
            assert!(outcome.residual <= 1e-12 && outcome.products < 400, "{outcome:?}");
            for (found, wanted) in solution.iter().zip(&exact) {
                assert!((found - wanted).abs() < 1e-9, "{found} {wanted}");
            }
        }
    }

    #[test]
    fn a_solve_that_runs_out_of_products_tells_its_residual() {
        let (mut operator, right, _) = problem();
        let mut solution = vec![0.0; 50];
        let limits = GmresLimits { tolerance: 1e-14, products: 3, restart: 50 };
        let outcome = gmres(&mut operator, &right, &mut solution, limits).unwrap();
        let mut product = vec![0.0; 50];
        operator.apply(&solution, &mut product);
        let left: Vec<f64> = right.iter().zip(&product).map(|(b, y)| b - y).collect();
        assert!(outcome.residual > 1e-14);
        assert!((norm(&left) / norm(&right) - outcome.residual).abs() < 1e-12);
    }

    #[test]
    fn nothing_comes_of_nothing_and_nan_is_refused() {
        let (mut operator, _, _) = problem();
        let limits = GmresLimits { tolerance: 1e-10, products: 100, restart: 50 };
        let mut solution = vec![3.0; 50];
        gmres(&mut operator, &[0.0; 50], &mut solution, limits).unwrap();
        assert!(solution.iter().all(|value| *value == 0.0));
        assert!(gmres(&mut operator, &[f64::NAN; 50], &mut solution, limits).is_err());
    }
}
