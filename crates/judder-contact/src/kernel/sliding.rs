//! Operators of steady sliding.

use super::cache::KernelCache;
use super::check::{KernelError, check};
use super::spectra::KernelSpectra;
use super::substrate::SlidingSubstrate;
use crate::surface::convolution::Workspace;
use crate::surface::grid::SurfaceGrid;
use crate::surface::operator::SurfaceOperator;
use std::sync::Arc;

/// Products with the kernel of steady sliding, and with the inverse of its symbol.
#[derive(Clone)]
pub struct SlidingOperator {
    grid: SurfaceGrid,
    spectra: Arc<KernelSpectra>,
    product_work: Workspace,
    inverse_work: Workspace,
}

impl SlidingOperator {
    /// The operator of a grid on a sliding substrate without images; terms' lengths are in the grid's length unit.
    ///
    /// # Errors
    /// [`KernelError`]: a grid or a substrate that has no kernel, and more memory than `allowed` bytes.
    pub fn new(grid: SurfaceGrid, substrate: &SlidingSubstrate, allowed: u64) -> Result<Self, KernelError> {
        Self::check_half_space(&grid, substrate, allowed)?;
        let spectra = KernelSpectra::unbounded(grid.columns, grid.rows, &substrate.in_cells(grid.cell));
        Ok(Self::with_spectra(grid, Arc::new(spectra)))
    }

    /// As [`new`](Self::new), from a kernel that has been computed before where there is one. The result is the same to
    /// the last bit.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn cached(
        grid: SurfaceGrid,
        substrate: &SlidingSubstrate,
        allowed: u64,
        cache: &KernelCache,
    ) -> Result<Self, KernelError> {
        Self::check_half_space(&grid, substrate, allowed)?;
        let spectra = cache.spectra(grid.columns, grid.rows, &substrate.in_cells(grid.cell));
        Ok(Self::with_spectra(grid, spectra))
    }

    /// As [`check`](Self::check), for squares, under which no layer is known.
    pub(super) fn check_half_space(
        grid: &SurfaceGrid,
        substrate: &SlidingSubstrate,
        allowed: u64,
    ) -> Result<(), KernelError> {
        if substrate.layer.is_some() {
            return Err(KernelError::LayerOfRows { rows: grid.rows });
        }
        Self::check(grid, substrate, allowed)
    }

    /// Checks a grid and a substrate before an operator is made of them that may take `allowed` bytes.
    pub(super) fn check(
        grid: &SurfaceGrid,
        substrate: &SlidingSubstrate,
        allowed: u64,
    ) -> Result<(), KernelError> {
        check(grid, substrate)?;
        let (columns, rows) = (grid.columns, grid.rows);
        let needed = Self::memory_bytes(columns, rows);
        if needed > allowed {
            return Err(KernelError::Memory { columns, rows, needed, allowed });
        }
        Ok(())
    }

    pub(super) fn with_spectra(grid: SurfaceGrid, spectra: Arc<KernelSpectra>) -> Self {
        let product_work = spectra.product.transform.workspace();
        let inverse_work = spectra.inverse.transform.workspace();
        Self { grid, spectra, product_work, inverse_work }
    }

    /// Bytes that an operator on such a grid takes at most, its making included: ask before allocating.
    #[must_use]
    pub fn memory_bytes(columns: usize, rows: usize) -> u64 {
        let cells = (columns as u64).saturating_mul(rows as u64);
        // While the operator is made, the kernel's two numbers a cell and two of half-done rows; then three of half-done
        // rows. Six leave room for lengths that are padded further. Plans and single rows are small.
        let working = cells.saturating_mul(6 * size_of::<f64>() as u64).saturating_add(1 << 20);
        KernelSpectra::memory_bytes(columns, rows).saturating_add(working)
    }
}

impl SurfaceOperator for SlidingOperator {
    fn grid(&self) -> &SurfaceGrid {
        &self.grid
    }

    fn displacement(&mut self, pressure: &[f64], displacement: &mut [f64]) {
        let filter = &self.spectra.product;
        let scale = self.grid.cell / filter.transform.places();
        filter.transform.multiply(pressure, &filter.factors, scale, displacement, &mut self.product_work);
    }

    fn precondition(&mut self, displacement: &[f64], pressure: &mut [f64]) {
        let filter = &self.spectra.inverse;
        let scale = 1.0 / (self.grid.cell * filter.transform.places());
        filter.transform.multiply(displacement, &filter.factors, scale, pressure, &mut self.inverse_work);
    }

    fn is_symmetric(&self) -> bool {
        self.spectra.symmetric
    }

    fn self_displacement(&self) -> f64 {
        self.spectra.at_itself * self.grid.cell
    }

    fn collocation_shift(&self) -> f64 {
        self.spectra.shift * self.grid.cell
    }
}
