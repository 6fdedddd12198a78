//! Friction of a periodic contact from the energy that the substrate dissipates.

use crate::kernel::spectra::symbol;
use crate::kernel::substrate::SlidingSubstrate;
use crate::surface::convolution::PaddedTransform;
use crate::surface::grid::SurfaceGrid;
use num_complex::Complex64;

/// The shear stress over E0*, averaged over the period, from the dissipation in the bulk.
///
/// A wave p̂ e^{iqx} of the pressure moves the surface by 2 J(q_x)/|q| p̂ e^{iqx}. In steady sliding the power of friction,
/// −⟨p ∂u/∂x⟩ v, is what the substrate dissipates:
/// σ_x = Σ_q q_x · 2 Im J(q_x)/|q| · |p̂(q)|². On a period the sum over its waves is the whole of it (Persson 2001, without a mean
/// over surfaces). It is computed as ⟨p w⟩ with w the pressure times that factor, wave by wave.
pub(super) fn shear_from_dissipation(
    grid: &SurfaceGrid,
    pressure: &[f64],
    substrate: &SlidingSubstrate,
) -> f64 {
    let in_cells = substrate.in_cells(grid.cell);
    let transform = PaddedTransform::periodic(grid.columns, grid.rows);
    let factors = symbol(
        &transform,
        |along| Complex64::from(2.0 * along * in_cells.compliance(along).im),
        |wave| if wave > 0.0 { 1.0 / wave } else { 0.0 },
    );
    let mut resisted = vec![0.0; grid.len()];
    let scale = 1.0 / transform.places();
    transform.multiply(pressure, &factors, scale, &mut resisted, &mut transform.workspace());
    pressure.iter().zip(&resisted).map(|(pressure, resisted)| pressure * resisted).sum::<f64>()
        / grid.len() as f64
}
