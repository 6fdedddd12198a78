//! Sliding over a surface that repeats itself.

use super::check::KernelError;
use super::sliding::SlidingOperator;
use super::spectra::{Filter, KernelSpectra, inverse_symbol, symbol};
use super::substrate::SlidingSubstrate;
use crate::surface::convolution::PaddedTransform;
use crate::surface::grid::SurfaceGrid;
use std::sync::Arc;

/// The largest share of its deformation that the substrate may remember from one period to the next.
///
/// A surface that truly repeats itself slides over its own history, whatever the wakes; an indenter that does not must end its
/// wakes within a period. At this limit the drag of a Hertzian pressure of radius a is off by 1 % in a period of 17.6 a, by
/// 3 % in 8.8 a and by 10 % in 4.4 a.
pub const PERIODIC_MEMORY: f64 = 1e-3;

/// Σ C_k E0 e^{−L/ℓ_k} over the relaxed compliance: what is left of a deformation when the next period arrives.
#[must_use]
pub fn memory_of_a_period(period: f64, substrate: &SlidingSubstrate) -> f64 {
    let kept: f64 =
        substrate.terms.iter().map(|term| term.compliance * libm::exp(-period / term.length)).sum();
    kept / substrate.relaxed()
}

impl SlidingOperator {
    /// The operator of a surface with the grid as its period: û(q) = 2 J(q_x)/|q| p̂(q), eq. (30) at ω = −q_x v.
    ///
    /// The mean displacement is free and comes out as zero: only differences of height mean anything, so the contact
    /// is controlled by its load. Valid where wakes end within a period, v τ ≪ L.
    ///
    /// # Errors
    /// What [`SlidingOperator::new`] refuses, and [`KernelError::LongWake`] where [`memory_of_a_period`] exceeds [`PERIODIC_MEMORY`].
    pub fn periodic(
        grid: SurfaceGrid,
        substrate: &SlidingSubstrate,
        allowed: u64,
    ) -> Result<Self, KernelError> {
        Self::check_half_space(&grid, substrate, allowed)?;
        let period = grid.columns as f64 * grid.cell;
        let memory = memory_of_a_period(period, substrate);
        if memory > PERIODIC_MEMORY {
            let length = substrate.terms.iter().map(|term| term.length).fold(0.0, f64::max);
            return Err(KernelError::LongWake { period, length, memory, allowed: PERIODIC_MEMORY });
        }
        Ok(Self::with_spectra(
            grid,
            Arc::new(periodic_spectra(grid.columns, grid.rows, &substrate.in_cells(grid.cell))),
        ))
    }
}

/// The symbol at the modes of the grid itself; lengths in cells.
fn periodic_spectra(columns: usize, rows: usize, substrate: &SlidingSubstrate) -> KernelSpectra {
    let shift = substrate.collocation_shift(1.0);
    let transform = PaddedTransform::periodic(columns, rows);
    let factors = symbol(
        &transform,
        |along| 2.0 * substrate.compliance(along) * judder_numerics::complex::from_polar(1.0, -along * shift),
        |wave| if wave > 0.0 { 1.0 / wave } else { 0.0 },
    );
    let inverse = inverse_symbol(transform.clone(), shift, substrate);
    let (mut unit, mut answer) = (vec![0.0; columns * rows], vec![0.0; columns * rows]);
    unit[0] = 1.0;
    transform.multiply(&unit, &factors, 1.0 / transform.places(), &mut answer, &mut transform.workspace());
    let product = Filter { transform, factors };
    KernelSpectra { product, inverse, shift, symmetric: substrate.terms.is_empty(), at_itself: answer[0] }
}
