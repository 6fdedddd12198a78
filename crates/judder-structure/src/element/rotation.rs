//! What an element does as its body turns.

use super::matrices::{BlockElements, StrainPoint, strain};
use crate::StructureError;
use crate::rotation::{RotatingFrame, Rotation};

/// Matrices of an element that turns, each square and row by row as of [`ElementMatrices`](super::ElementMatrices).
pub(crate) struct RotatingElement {
    /// G in N s/m.
    pub(crate) gyroscopic: Vec<f64>,
    /// S in N/m.
    pub(crate) softening: Vec<f64>,
    /// f in N: the centrifugal force.
    pub(crate) load: Vec<f64>,
}

impl BlockElements {
    /// The inertia of turning; `element` is its number for errors.
    ///
    /// # Errors
    /// [`StructureError::NoRotation`] for elements of the plane, [`StructureError::Folded`].
    pub(crate) fn rotating(
        &self,
        element: usize,
        nodes: &[[f64; 3]],
        rotation: &Rotation,
        frame: RotatingFrame,
    ) -> Result<RotatingElement, StructureError> {
        if self.kind.dimension() != 3 {
            return Err(StructureError::NoRotation { kind: self.kind });
        }
        let count = self.kind.nodes();
        let size = 3 * count;
        let mut made = RotatingElement {
            gyroscopic: vec![0.0; size * size],
            softening: vec![0.0; size * size],
            load: vec![0.0; size],
        };
        let (across, spin) = (rotation.across(), rotation.spin());
        for (shape, (place, weight)) in &self.mass_points {
            let here = self.gradients(element, nodes, shape, place)?;
            let mass = self.density * weight * here.determinant;
            let at: [f64; 3] =
                std::array::from_fn(|k| nodes.iter().zip(&shape.values).map(|(node, n)| n * node[k]).sum());
            let velocity = rotation.velocity(at);
            let outward = rotation.outward(at);
            // N, and its change along the path of the material, (v·∇) N
            let values = &shape.values[..count];
            let carried: Vec<f64> =
                here.of_nodes[..count].iter().map(|g| (0..3).map(|k| velocity[k] * g[k]).sum()).collect();
            for a in 0..count {
                for (i, outward) in outward.iter().enumerate() {
                    made.load[3 * a + i] += mass * values[a] * outward;
                }
                for b in 0..count {
                    let (skew, of_both) =
                        (values[a] * carried[b] - carried[a] * values[b], carried[a] * carried[b]);
                    for i in 0..3 {
                        for j in 0..3 {
                            let entry = (3 * a + i) * size + 3 * b + j;
                            let (gyroscopic, softening) = match frame {
                                RotatingFrame::Fixed if i == j => (skew, of_both),
                                RotatingFrame::Fixed => continue,
                                RotatingFrame::Rotating => {
                                    let product = values[a] * values[b];
                                    (2.0 * product * spin[i][j], product * across[i][j])
                                }
                            };
                            made.gyroscopic[entry] += mass * gyroscopic;
                            made.softening[entry] += mass * softening;
                        }
                    }
                }
            }
        }
        Ok(made)
    }

    /// ∫ σ : (∇δuᵀ ∇u) dV, the stiffness by the stress of displacements of the element's nodes.
    ///
    /// # Errors
    /// [`StructureError::NoRotation`] for elements of the plane, [`StructureError::Folded`].
    pub(crate) fn stress_stiffness(
        &self,
        element: usize,
        nodes: &[[f64; 3]],
        displacement: &[f64],
    ) -> Result<Vec<f64>, StructureError> {
        if self.kind.dimension() != 3 {
            return Err(StructureError::NoRotation { kind: self.kind });
        }
        let points = self.strain_points(element, nodes)?;
        let displacement = self.with_own_modes(&points, displacement);
        let count = self.kind.nodes();
        let size = 3 * count;
        let mut stiffness = vec![0.0; size * size];
        for StrainPoint { gradients, volume } in &points {
            let stress = self.stress(gradients, &displacement);
            for a in 0..count {
                let pulled: [f64; 3] =
                    std::array::from_fn(|k| (0..3).map(|m| stress[k][m] * gradients[a][m]).sum());
                for b in a..count {
                    let share = volume * (0..3).map(|k| pulled[k] * gradients[b][k]).sum::<f64>();
                    for i in 0..3 {
                        stiffness[(3 * a + i) * size + 3 * b + i] += share;
                    }
                }
            }
        }
        for row in 0..size {
            for column in 0..row {
                stiffness[row * size + column] = stiffness[column * size + row];
            }
        }
        Ok(stiffness)
    }

    /// Displacements of the nodes, and after them those of the element's own modes, on which no force acts.
    fn with_own_modes(&self, points: &[StrainPoint], displacement: &[f64]) -> Vec<f64> {
        let (matrix, size) = self.uncondensed(points);
        let mut all = displacement.to_vec();
        for row in all.len()..size {
            let of_others: f64 = all.iter().zip(&matrix[row * size..]).map(|(u, k)| u * k).sum();
            all.push(-of_others / matrix[row * size + row]);
        }
        all
    }

    /// σ at a place, as a matrix.
    fn stress(&self, gradients: &[[f64; 3]], displacement: &[f64]) -> [[f64; 3]; 3] {
        let mut total = [0.0; 6];
        for (a, gradient) in gradients.iter().enumerate() {
            for direction in 0..3 {
                let own = strain(3, gradient, direction);
                let moved = displacement[3 * a + direction];
                total.iter_mut().zip(own).for_each(|(sum, strain)| *sum += moved * strain);
            }
        }
        let [x, y, z, xy, yz, zx]: [f64; 6] =
            std::array::from_fn(|s| (0..6).map(|t| self.elasticity[s][t] * total[t]).sum());
        [[x, xy, zx], [xy, y, yz], [zx, yz, z]]
    }
}
