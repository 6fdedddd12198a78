//! What a sequence of grids says about the error of the finest.

use super::level::Level;

/// How much further than the force area and friction may be off.
const SECONDARY: f64 = 5.0;
/// A friction below this is as good as none: its relative error is not asked about.
const NO_FRICTION: f64 = 1e-12;
/// What a step of the friction must have shrunk to before it is believed: the part of the step before, as of two orders.
const BELIEVED: f64 = 0.25;
/// How much further off a grid may be whose cells are as long as a wake: there convergence has not begun.
const UNRESOLVED_WAKE: f64 = 2.0;

/// One grid in the table of refinement.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LevelSummary {
    /// Cells a side.
    pub cells: usize,
    /// h/R, side of a cell.
    pub cell: f64,
    /// F/(E0* R²).
    pub force: f64,
    /// A/R².
    pub area: f64,
    /// μ.
    pub friction: f64,
    /// y/R.
    pub indentation: f64,
    /// Largest pressure over E0*.
    pub peak_pressure: f64,
    /// Changes of the contact set.
    pub iterations: usize,
    /// Products with the kernel.
    pub products: usize,
    /// Largest recomputed error of the unilateral conditions.
    pub residual: f64,
    /// Whether the grid's problem was solved.
    pub converged: bool,
}

impl LevelSummary {
    /// The row of one grid.
    #[must_use]
    pub fn of(level: &Level) -> Self {
        Self {
            cells: level.grid.columns,
            cell: level.grid.cell,
            force: level.force,
            area: level.area,
            friction: level.friction,
            indentation: level.solution.indentation,
            peak_pressure: level.solution.pressure.iter().copied().fold(0.0, f64::max),
            iterations: level.solution.iterations,
            products: level.solution.products,
            residual: level.solution.errors.worst(),
            converged: level.solution.converged,
        }
    }
}

/// A value from a sequence of grids.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ErrorEstimate {
    /// The value; of force and depth extrapolated to a vanishing cell where the last three grids agree on an order.
    pub value: f64,
    /// Estimated relative error of the value; infinite from too few grids.
    pub error: f64,
    /// The observed order of convergence, where three grids show one.
    pub order: Option<f64>,
}

/// The results of a sequence of grids, coarse to fine.
#[derive(Debug, Clone, PartialEq)]
pub struct Refinement {
    /// F/(E0* R²).
    pub force: ErrorEstimate,
    /// A/R².
    pub area: ErrorEstimate,
    /// μ.
    pub friction: ErrorEstimate,
    /// y/R.
    pub indentation: ErrorEstimate,
    /// Largest pressure over E0*; no accuracy is asked of it.
    pub peak_pressure: ErrorEstimate,
    /// The grids.
    pub levels: Vec<LevelSummary>,
}

impl Refinement {
    /// The estimates from a sequence of grids, each with half the cell of the one before; `unresolved` says that a wake is
    /// about as long as a cell of the finest.
    ///
    /// Edges fall between cells as they please, so area and friction jump: two grids may agree by chance where both are off.
    /// Their errors are infinite below three grids. That of the area is the sum of the last two steps, that of the friction the last
    /// step or a quarter of the one before; twice the sum of both where a wake is not resolved.
    #[must_use]
    pub fn of(levels: &[LevelSummary], unresolved: bool) -> Self {
        let values = |value: fn(&LevelSummary) -> f64| -> Vec<f64> { levels.iter().map(value).collect() };
        let estimate = |value| ErrorEstimate::of(&values(value));
        let (area, friction) = (values(|level| level.area), values(|level| level.friction));
        let wide = |[earlier, later]: [f64; 2]| UNRESOLVED_WAKE * (earlier + later);
        let (area, friction) = if unresolved {
            (ErrorEstimate::jumping(&area, wide), ErrorEstimate::jumping(&friction, wide))
        } else {
            (
                ErrorEstimate::jumping(&area, |[earlier, later]| earlier + later),
                ErrorEstimate::jumping(&friction, |[earlier, later]| later.max(BELIEVED * earlier)),
            )
        };
        Self {
            force: estimate(|level| level.force),
            area,
            friction,
            indentation: estimate(|level| level.indentation),
            peak_pressure: ErrorEstimate::last_of(&values(|level| level.peak_pressure)),
            levels: levels.to_vec(),
        }
    }

    /// The same for a line contact, which has two edges alone.
    ///
    /// Where they fall within their strips changes from grid to grid and moves width and friction: no order to extrapolate by,
    /// and no round edge over whose rows it would be averaged.
    #[must_use]
    pub fn of_line(levels: &[LevelSummary]) -> Self {
        let jumping = |value: fn(&LevelSummary) -> f64| {
            let values: Vec<f64> = levels.iter().map(value).collect();
            ErrorEstimate::jumping(&values, |[earlier, later]| earlier.max(later))
        };
        Self {
            area: jumping(|level| level.area),
            friction: jumping(|level| level.friction),
            ..Self::of(levels, false)
        }
    }

    /// Counts the relative difference of friction from the surface and from the bulk as an error of the friction.
    #[must_use]
    pub fn with_friction_difference(mut self, difference: f64) -> Self {
        if self.friction.value.abs() >= NO_FRICTION {
            self.friction.error = self.friction.error.max(difference);
        }
        self
    }

    /// Whether force (or depth), area and friction are known to the accuracy.
    #[must_use]
    pub fn meets(&self, accuracy: f64) -> bool {
        let friction_known =
            self.friction.value.abs() < NO_FRICTION || self.friction.error <= SECONDARY * accuracy;
        self.force.error.max(self.indentation.error) <= accuracy
            && self.area.error <= SECONDARY * accuracy
            && friction_known
    }
}

impl ErrorEstimate {
    /// Richardson's extrapolation of a sequence in which the cell is halved each time.
    ///
    /// From three values with differences d₁, d₂ the order is log₂(d₁/d₂). Between 1/2 and 3 it is believed: the last
    /// value is corrected by d₂/(2^order − 1), and the larger of correction and d₂ is the error. Otherwise
    /// the last value stands, with d₂ as its error.
    #[must_use]
    pub fn of(values: &[f64]) -> Self {
        let plain = Self::last_of(values);
        let [.., earlier, previous, last] = *values else {
            return plain;
        };
        let step = last - previous;
        let ratio = (previous - earlier) / step;
        if !ratio.is_finite() || !(std::f64::consts::SQRT_2..=8.0).contains(&ratio) {
            return plain;
        }
        let correction = step / (ratio - 1.0);
        let error = relative(correction, last).max(plain.error);
        Self { value: last + correction, error, order: Some(libm::log2(ratio)) }
    }

    /// The last value of a sequence that jumps, with what `error` makes of the sizes of its last two steps, the earlier first.
    #[must_use]
    pub fn jumping(values: &[f64], error: impl Fn([f64; 2]) -> f64) -> Self {
        match *values {
            [.., earlier, previous, last] => {
                let steps = [(previous - earlier).abs(), (last - previous).abs()];
                Self { value: last, error: relative(error(steps), last), order: None }
            }
            _ => Self { error: f64::INFINITY, ..Self::last_of(values) },
        }
    }

    /// The last value of a sequence, with its difference from the one before as its error.
    #[must_use]
    pub fn last_of(values: &[f64]) -> Self {
        match *values {
            [] => Self { value: f64::NAN, error: f64::INFINITY, order: None },
            [only] => Self { value: only, error: f64::INFINITY, order: None },
            [.., previous, last] => Self { value: last, error: relative(last - previous, last), order: None },
        }
    }
}

fn relative(difference: f64, to: f64) -> f64 {
    if difference == 0.0 { 0.0 } else { (difference / to).abs() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sequence_of_known_order_is_extrapolated_to_its_limit() {
        let values: Vec<f64> = (0..4).map(|k| 2.0 + 0.3 * 0.5_f64.powf(1.5 * f64::from(k))).collect();
        let estimate = ErrorEstimate::of(&values);
        assert!((estimate.value - 2.0).abs() < 1e-12);
        assert!((estimate.order.unwrap() - 1.5).abs() < 1e-9);
        assert!(estimate.error >= (values[3] - 2.0).abs() / 2.0 * 0.99);
    }

    #[test]
    fn a_sequence_without_an_order_keeps_its_last_difference_as_error() {
        let estimate = ErrorEstimate::of(&[1.0, 1.1, 1.05]);
        assert_eq!((estimate.value, estimate.order), (1.05, None));
        assert!((estimate.error - 0.05 / 1.05).abs() < 1e-12);
        assert_eq!(ErrorEstimate::of(&[1.0]).error, f64::INFINITY);
    }

    #[test]
    fn two_values_that_agree_are_not_believed() {
        let sum = |[earlier, later]: [f64; 2]| earlier + later;
        assert!((ErrorEstimate::jumping(&[1.0, 1.1, 1.05], sum).error - 0.15 / 1.05).abs() < 1e-12);
        assert_eq!(ErrorEstimate::jumping(&[1.0, 1.0], sum).error, f64::INFINITY);
    }
}
