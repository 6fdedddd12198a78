//! Multipliers with more and more steps of a period.

use super::monodromy::{Monodromy, monodromy};
use super::{FLOQUET_STEPS, FloquetMultipliers, beginning};
use crate::CyclesError;
use crate::backbone::PeriodicMotion;
use crate::balance::HarmonicBalance;
use crate::path::GoOn;
use faer::{Mat, c64};
use judder_dense::general::{PickedEigenvalues, real_eigen};
use judder_numerics::complex::ElementaryComplex;
use judder_numerics::order::sort_by_numbers;

/// Multipliers of a motion, with by how much they changed as its steps were doubled last for an error.
pub(super) struct DoubledSteps<'s, 'a> {
    balance: &'s HarmonicBalance<'a>,
    cycle: &'s PeriodicMotion,
    last: Monodromy,
    pub(super) found: FloquetMultipliers,
}

impl<'s, 'a> DoubledSteps<'s, 'a> {
    /// With so many steps at first, of which no error is known.
    pub(super) fn new(
        balance: &'s HarmonicBalance<'a>,
        cycle: &'s PeriodicMotion,
        steps: usize,
        go_on: &GoOn<'_>,
    ) -> Result<Self, CyclesError> {
        let last = monodromy(balance, cycle, steps, go_on)?;
        let found = multipliers_of(balance, cycle, &last.matrix, steps)?;
        Ok(Self { balance, cycle, last, found })
    }

    /// With twice as many.
    pub(super) fn double(&mut self, go_on: &GoOn<'_>) -> Result<(), CyclesError> {
        let steps = 2 * self.found.steps;
        let fine = monodromy(self.balance, self.cycle, steps, go_on)?;
        let mut found = multipliers_of(self.balance, self.cycle, &fine.beyond(&self.last), steps)?;
        let of_largest = (found.largest() - self.found.largest()).abs();
        found.error = match (found.phase, self.found.phase) {
            (Some(fine), Some(coarse)) => of_largest.max((fine - coarse).modulus()),
            _ => of_largest,
        };
        (self.found, self.last) = (found, fine);
        Ok(())
    }

    /// Whether no point sticks or turns.
    pub(super) fn slides(&self) -> bool {
        self.last.slides
    }

    /// Whether they changed by so little, or by however much with as many steps as there ever are.
    pub(super) fn is_known_to(&self, enough: f64) -> bool {
        self.found.error < enough || self.found.steps >= FLOQUET_STEPS[1]
    }
}

/// The multipliers of what so many steps make of a period.
pub(super) fn multipliers_of(
    balance: &HarmonicBalance<'_>,
    cycle: &PeriodicMotion,
    matrix: &Mat<f64>,
    steps: usize,
) -> Result<FloquetMultipliers, CyclesError> {
    let PickedEigenvalues { mut values, right, .. } =
        real_eigen(matrix, &|_| true).ok_or(CyclesError::Singular)?;
    let phase = match balance.is_driven() {
        true => None,
        false => {
            let (_, direction, _) = beginning(balance, cycle)?;
            let along = |k: usize| -> f64 {
                direction.iter().enumerate().map(|(row, own)| right[(row, k)] * *own).sum::<c64>().modulus()
            };
            let most = (0..values.len()).max_by(|a, b| along(*a).total_cmp(&along(*b)));
            most.map(|k| values.remove(k))
        }
    };
    sort(&mut values);
    Ok(FloquetMultipliers { values, phase, steps, error: f64::INFINITY })
}

/// The largest first.
pub(super) fn sort(values: &mut [c64]) {
    sort_by_numbers(values, |own| [-own.modulus(), own.im]);
}
