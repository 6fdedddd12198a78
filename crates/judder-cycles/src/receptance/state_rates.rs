//! Bodies as what displacements and velocities make of accelerations.

use super::{HarmonicBodies, HarmonicMatrices};
use faer::Mat;
use judder_dense::general::solve;

impl HarmonicBodies {
    /// M⁻¹ C and M⁻¹ K; nothing where a freedom has no mass.
    pub(crate) fn free_rates(&self) -> Option<[Mat<f64>; 2]> {
        match self.kind.as_ref() {
            HarmonicMatrices::Modes(modes) => {
                let diagonal =
                    |of: &[f64]| Mat::from_fn(of.len(), of.len(), |i, j| if i == j { of[i] } else { 0.0 });
                Some([diagonal(&modes.damping), diagonal(&modes.eigenvalues)])
            }
            HarmonicMatrices::Whole(matrices) => {
                let [mass, damping, stiffness] = matrices.as_ref();
                let mut rates = [damping.clone(), stiffness.clone()];
                for own in &mut rates {
                    solve(mass.clone(), own)?;
                }
                rates.iter().all(Mat::is_all_finite).then_some(rates)
            }
        }
    }

    /// y of a component by velocities and by displacements of the coordinates.
    pub(crate) fn seen(&self, component: usize) -> [Vec<f64>; 2] {
        let own: Vec<f64> = (0..self.rows.ncols()).map(|k| self.rows[(component, k)]).collect();
        if !self.is_velocity(component) {
            return [vec![0.0; own.len()], own];
        }
        let brought = self.convected.iter().find(|(other, _)| *other == component);
        let displaced = brought.map_or(vec![0.0; own.len()], |(_, row)| row.iter().map(|own| -own).collect());
        [own, displaced]
    }
}
