//! An operator that gives up when it is told to.

use super::grid::SurfaceGrid;
use super::operator::SurfaceOperator;
use judder_numerics::stopping::Interrupted;

/// An operator whose products are not numbers once it was told to stop: so every solver ends at its next test.
pub(crate) struct Stoppable<'a> {
    operator: &'a mut dyn SurfaceOperator,
    interrupted: Interrupted<'a>,
    is_stopped: bool,
}

impl<'a> Stoppable<'a> {
    pub(crate) fn new(operator: &'a mut dyn SurfaceOperator, interrupted: Interrupted<'a>) -> Self {
        Self { operator, interrupted, is_stopped: false }
    }

    /// Whether it was told to stop: what a solver then says is not its own fault.
    pub(crate) fn is_stopped(&self) -> bool {
        self.is_stopped
    }
}

impl SurfaceOperator for Stoppable<'_> {
    fn grid(&self) -> &SurfaceGrid {
        self.operator.grid()
    }

    fn displacement(&mut self, pressure: &[f64], displacement: &mut [f64]) {
        self.is_stopped = self.is_stopped || (self.interrupted)();
        if self.is_stopped {
            displacement.fill(f64::NAN);
        } else {
            self.operator.displacement(pressure, displacement);
        }
    }

    fn precondition(&mut self, displacement: &[f64], pressure: &mut [f64]) {
        if self.is_stopped {
            pressure.fill(f64::NAN);
        } else {
            self.operator.precondition(displacement, pressure);
        }
    }

    fn is_symmetric(&self) -> bool {
        self.operator.is_symmetric()
    }

    fn self_displacement(&self) -> f64 {
        self.operator.self_displacement()
    }

    fn collocation_shift(&self) -> f64 {
        self.operator.collocation_shift()
    }
}
