//! What a solver asks of a surface that yields under pressure.

use super::grid::SurfaceGrid;

/// The linear map from pressures to displacements on a grid, with a cheap approximate inverse.
///
/// Pressures are in E0*, uniform over each cell; displacements are positive into the substrate and taken at
/// (x − [`collocation_shift`](Self::collocation_shift), y) for the centre (x, y) of each cell.
pub trait SurfaceOperator {
    /// The cells.
    fn grid(&self) -> &SurfaceGrid;

    /// u = K p.
    fn displacement(&mut self, pressure: &[f64], displacement: &mut [f64]);

    /// p ≈ K⁻¹ u, from the operator's symbol.
    fn precondition(&mut self, displacement: &[f64], pressure: &mut [f64]);

    /// Whether K is symmetric: the substrate is elastic.
    fn is_symmetric(&self) -> bool;

    /// The displacement that a unit pressure on a cell makes at the cell's own collocation point.
    fn self_displacement(&self) -> f64;

    /// How far upstream of the cells' centres displacements and heights are compared.
    fn collocation_shift(&self) -> f64 {
        0.0
    }
}
