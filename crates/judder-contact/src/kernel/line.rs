//! Sliding of long strips, the plane-strain contact of a cylinder across the direction of sliding.

use super::check::{KernelError, THINNEST};
use super::layer::BondedLayer;
use super::recurrence::{WakeRecurrence, WakeRow};
use super::sliding::SlidingOperator;
use super::spectra::KernelSpectra;
use super::substrate::SlidingSubstrate;
use super::wake::{WakeKernel, padded};
use crate::surface::grid::SurfaceGrid;
use std::f64::consts::PI;
use std::sync::Arc;

/// Distance, in widths of a strip, beyond which the strip is seen as a line with its first corrections.
const FAR: f64 = 16.0;

/// Surface displacement at x from a unit pressure on the strip of width 1 about the origin, relative to that at the
/// distance d from the same load on a line: −(2/π) ∫ ln(|x − s|/d) ds.
///
/// Lengths in widths of the strip, displacement in widths times pressure over E0* (Johnson, Contact Mechanics, 2.5).
#[must_use]
pub fn displacement(x: f64, reference: f64) -> f64 {
    let x = x.abs();
    let mean_logarithm = if x > FAR {
        let square = 1.0 / (4.0 * x * x);
        let corrections =
            square * (1.0 / 6.0 + square * (1.0 / 20.0 + square * (1.0 / 42.0 + square / 72.0)));
        libm::log(x) - corrections
    } else {
        let side = |distance: f64| if distance == 0.0 { 0.0 } else { distance * libm::log(distance.abs()) };
        side(x + 0.5) - side(x - 0.5) - 1.0
    };
    -2.0 / PI * (mean_logarithm - libm::log(reference))
}

/// The reference distance that makes displacements relative to a point deep below the load: d = D e^{−ν/(2(1−ν))}.
///
/// A plane half-space has no absolute displacement: a load moves its surface by an amount that grows with the logarithm of
/// the distance to what is held. D is the depth of what is held, much larger than the contact (Johnson, Contact Mechanics, 5.6).
#[must_use]
pub fn reference_at_depth(depth: f64, poisson_ratio: f64) -> f64 {
    depth * libm::exp(-poisson_ratio / (2.0 * (1.0 - poisson_ratio)))
}

impl SlidingOperator {
    /// The operator of a line contact: one row of strips of width h, infinitely long across the direction of sliding.
    ///
    /// u(x) = J * W\[p\] with W\[p\] = −(2/π) ∫ p(s) ln(|x − s|/d) ds: forces are per length, in E0* times the length unit.
    /// The reference distance d moves all displacements by (2/π) ln d times the relaxed compliance times the force, for
    /// the wake of a constant is that constant; load-controlled contacts do not depend on it. An indentation
    /// means something only for d well beyond the contact and its wakes. The
    /// [self-displacement](crate::surface::operator::SurfaceOperator::self_displacement) is counted from the least one in the row, so that it is positive for any d.
    ///
    /// # Errors
    /// What [`SlidingOperator::new`] refuses, a grid of more than one row, and a reference distance that is not positive and finite.
    pub fn line(
        grid: SurfaceGrid,
        substrate: &SlidingSubstrate,
        reference: f64,
        allowed: u64,
    ) -> Result<Self, KernelError> {
        Self::check_line(&grid, substrate, allowed)?;
        if substrate.layer.is_some() {
            return Err(KernelError::LayerWithReference);
        }
        if !(reference > 0.0 && reference.is_finite()) {
            return Err(KernelError::Reference { value: reference });
        }
        let in_cells = substrate.in_cells(grid.cell);
        let shift = in_cells.collocation_shift(1.0);
        let kernel = line_kernel(grid.columns, shift, reference / grid.cell, &in_cells);
        let mut spectra = KernelSpectra::from_kernel(&kernel, shift, &in_cells);
        // Displacements may have either sign, as the reference is chosen; what solvers weigh them by may not.
        spectra.at_itself -= kernel.values.iter().copied().fold(f64::INFINITY, f64::min);
        Ok(Self::with_spectra(grid, Arc::new(spectra)))
    }

    /// The operator of a line contact on the substrate's layer, whose surface is at rest far from the contact: displacements are what they are.
    ///
    /// # Errors
    /// What [`SlidingOperator::new`] refuses of grids and materials, a grid of more than one row, a layer far thinner than a strip is wide.
    pub(crate) fn on_layer(
        grid: SurfaceGrid,
        substrate: &SlidingSubstrate,
        layer: &BondedLayer,
        allowed: u64,
    ) -> Result<Self, KernelError> {
        Self::check_line(&grid, substrate, allowed)?;
        let in_strips = layer.in_units(grid.cell);
        let thickness = in_strips.thickness();
        if thickness < THINNEST {
            return Err(KernelError::ThinLayer { thickness });
        }
        let in_cells = substrate.in_cells(grid.cell);
        let shift = in_cells.collocation_shift(1.0);
        let kernel = strip_kernel(grid.columns, shift, &in_cells, |x| in_strips.displacement(x));
        let mut spectra = KernelSpectra::from_kernel(&kernel, shift, &in_cells);
        // behind a strip a layer may bulge
        spectra.at_itself -= kernel.values.iter().copied().fold(0.0, f64::min);
        Ok(Self::with_spectra(grid, Arc::new(spectra)))
    }

    fn check_line(grid: &SurfaceGrid, substrate: &SlidingSubstrate, allowed: u64) -> Result<(), KernelError> {
        Self::check(grid, substrate, allowed)?;
        if grid.rows == 1 { Ok(()) } else { Err(KernelError::Rows { rows: grid.rows }) }
    }
}

/// The kernel of a line of strips on a half-space; lengths in strips.
#[must_use]
pub fn line_kernel(columns: usize, shift: f64, reference: f64, substrate: &SlidingSubstrate) -> WakeKernel {
    strip_kernel(columns, shift, substrate, |x| displacement(x, reference))
}

/// The kernel of strips of which one moves the surface by `displacement`, by the recurrence of [`WakeKernel::new`]; lengths in strips.
fn strip_kernel(
    columns: usize,
    shift: f64,
    substrate: &SlidingSubstrate,
    displacement: impl Fn(f64) -> f64,
) -> WakeKernel {
    let fill = |x: f64, out: &mut [f64]| {
        for (index, value) in out.iter_mut().enumerate() {
            *value = displacement(x + index as f64);
        }
    };
    let places = WakeRow::new(1.0 - columns as f64 - shift, padded(columns), 0.0, &displacement, fill);
    let mut values = vec![0.0; padded(columns)];
    places.add_kernel(substrate, &WakeRecurrence::all(substrate), &mut values);
    WakeKernel { columns, rows: 1, values }
}
