//! Stiffness and consistent mass of one element.

use super::kind::ElementKind;
use super::quadrature::{IntegrationPoint, points};
use super::shape::{MOST_NODES, ShapeFunctions};
use crate::StructureError;
use crate::material::{Elastic, ElementSection};

/// Stiffness and mass of an element, each square and row by row; freedom `d·a + i` is direction i of node a, d the dimension.
#[derive(Debug, Clone, PartialEq)]
pub struct ElementMatrices {
    /// Rows of each.
    pub size: usize,
    /// K in N/m.
    pub stiffness: Vec<f64>,
    /// M in kg.
    pub mass: Vec<f64>,
}

/// Longest over shortest direction of an element from which on its stiffness, which has their squares, is all rounding: their ratio is 1e14 then.
const STRETCH_LIMIT: f64 = 1e7;

/// Elements of one kind, material and section, ready to be computed.
#[derive(Debug, Clone)]
pub struct BlockElements {
    pub(super) kind: ElementKind,
    pub(super) density: f64,
    thickness: f64,
    pub(super) elasticity: [[f64; 6]; 6],
    stiffness_points: Vec<(ShapeFunctions, IntegrationPoint)>,
    pub(super) mass_points: Vec<(ShapeFunctions, IntegrationPoint)>,
    centre: ShapeFunctions,
}

/// Gradients of shape functions by x, y, z at a place.
pub(super) struct Gradients {
    pub(super) of_nodes: [[f64; 3]; MOST_NODES],
    /// The inverse of the Jacobian matrix, ∂ξ/∂x.
    inverse: [[f64; 3]; 3],
    pub(super) determinant: f64,
}

/// A place of the stiffness: gradients of shape functions and of the element's own modes there, and its volume.
pub(super) struct StrainPoint {
    pub(super) gradients: Vec<[f64; 3]>,
    pub(super) volume: f64,
}

impl BlockElements {
    /// Elements of a kind.
    ///
    /// # Errors
    /// [`StructureError::WrongSection`] where kind and section differ in their dimension.
    pub fn new(
        kind: ElementKind,
        material: &Elastic,
        section: ElementSection,
    ) -> Result<Self, StructureError> {
        let (dimension, of_section) = (kind.dimension(), section.dimension());
        if dimension != of_section {
            return Err(StructureError::WrongSection { kind, dimension, section: of_section });
        }
        let with_shapes = |points: Vec<IntegrationPoint>| {
            points.into_iter().map(|point| (ShapeFunctions::at(kind, &point.0), point)).collect::<Vec<_>>()
        };
        let (stiffness, mass) = points(kind);
        Ok(Self {
            kind,
            density: material.density,
            thickness: section.thickness(),
            elasticity: material.stiffness(section),
            stiffness_points: with_shapes(stiffness),
            mass_points: with_shapes(mass),
            centre: ShapeFunctions::at(kind, &[0.0; 3]),
        })
    }

    /// Their shape.
    #[must_use]
    pub fn kind(&self) -> ElementKind {
        self.kind
    }

    /// K = ∫ Bᵀ D B t dA and M = ∫ ρ Nᵀ N t dA of an element at these places of its nodes; `element` is its number for errors.
    ///
    /// Four-node quadrilaterals and eight-node bricks carry incompatible modes (E. L. Wilson et al., 1973) with the gradients of
    /// R. L. Taylor, P. J. Beresford and E. L. Wilson (1976), which pass the patch test; they are condensed.
    ///
    /// # Errors
    /// [`StructureError::Folded`] where the Jacobian determinant is not positive, [`StructureError::Stretched`].
    pub fn matrices(&self, element: usize, nodes: &[[f64; 3]]) -> Result<ElementMatrices, StructureError> {
        let count = self.kind.nodes();
        let size = self.kind.dimension() * count;
        let mut mass = vec![0.0; size * size];
        for (shape, (place, weight)) in &self.mass_points {
            let determinant = self.gradients(element, nodes, shape, place)?.determinant;
            self.add_mass(&mut mass, shape, self.density * self.thickness * weight * determinant);
        }
        Ok(ElementMatrices { size, stiffness: self.stiffness(element, nodes)?, mass })
    }

    fn stiffness(&self, element: usize, nodes: &[[f64; 3]]) -> Result<Vec<f64>, StructureError> {
        let (matrix, size) = self.uncondensed(&self.strain_points(element, nodes)?);
        let kept = self.kind.dimension() * self.kind.nodes();
        Ok((0..kept).flat_map(|row| matrix[row * size..row * size + kept].to_vec()).collect())
    }

    /// The stiffness with the freedoms of the element's own modes eliminated: rows of nodes are condensed, below them each mode by what is before it. And its
    /// size.
    pub(super) fn uncondensed(&self, points: &[StrainPoint]) -> (Vec<f64>, usize) {
        let functions = points.first().map_or(0, |point| point.gradients.len());
        let size = self.kind.dimension() * functions;
        let mut stiffness = vec![0.0; size * size];
        for point in points {
            self.add_stiffness(&mut stiffness, &point.gradients, point.volume);
        }
        eliminate(&mut stiffness, size, self.kind.dimension() * self.kind.nodes());
        (stiffness, size)
    }

    /// The places of the stiffness.
    pub(super) fn strain_points(
        &self,
        element: usize,
        nodes: &[[f64; 3]],
    ) -> Result<Vec<StrainPoint>, StructureError> {
        let (count, dimension) = (self.kind.nodes(), self.kind.dimension());
        let modes = if self.kind.has_incompatible_modes() { dimension } else { 0 };
        let centre = self.gradients(element, nodes, &self.centre, &[0.0; 3])?;
        let point = |(shape, (place, weight)): &(ShapeFunctions, IntegrationPoint)| {
            let here = self.gradients(element, nodes, shape, place)?;
            let of_modes = (0..modes).map(|mode| {
                // −2ξ by the Jacobian at the centre, so that its mean over the element is zero
                let slope = -2.0 * place[mode] * centre.determinant / here.determinant;
                centre.inverse[mode].map(|along| slope * along)
            });
            let gradients = here.of_nodes[..count].iter().copied().chain(of_modes).collect();
            Ok(StrainPoint { gradients, volume: self.thickness * weight * here.determinant })
        };
        self.stiffness_points.iter().map(point).collect()
    }

    pub(super) fn gradients(
        &self,
        element: usize,
        nodes: &[[f64; 3]],
        shape: &ShapeFunctions,
        place: &[f64; 3],
    ) -> Result<Gradients, StructureError> {
        let (count, dimension) = (self.kind.nodes(), self.kind.dimension());
        // ∂x/∂ξ, with a unit third direction in the plane
        let mut jacobian = [[0.0, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, 1.0]];
        if dimension == 3 {
            jacobian[2][2] = 0.0;
        }
        for (node, gradient) in nodes.iter().zip(&shape.gradients[..count]) {
            for i in 0..dimension {
                for k in 0..dimension {
                    jacobian[i][k] += node[i] * gradient[k];
                }
            }
        }
        let (determinant, inverse) = inverse(&jacobian);
        if determinant.is_nan() || determinant <= 0.0 {
            return Err(StructureError::Folded { element, kind: self.kind, place: *place, determinant });
        }
        let ratio = length_of(&jacobian, dimension) * length_of(&inverse, dimension);
        if ratio > STRETCH_LIMIT {
            return Err(StructureError::Stretched { element, kind: self.kind, ratio, limit: STRETCH_LIMIT });
        }
        let mut of_nodes = [[0.0; 3]; MOST_NODES];
        for (to, from) in of_nodes.iter_mut().zip(&shape.gradients[..count]) {
            for k in 0..dimension {
                to[k] = (0..dimension).map(|m| from[m] * inverse[m][k]).sum();
            }
        }
        Ok(Gradients { of_nodes, inverse, determinant })
    }

    /// Adds Bᵀ D B times a volume.
    fn add_stiffness(&self, stiffness: &mut [f64], gradients: &[[f64; 3]], volume: f64) {
        let dimension = self.kind.dimension();
        let size = dimension * gradients.len();
        for (b, gradient) in gradients.iter().enumerate() {
            for j in 0..dimension {
                let strain = strain(dimension, gradient, j);
                let stress: [f64; 6] = std::array::from_fn(|s| {
                    volume * (0..6).map(|t| self.elasticity[s][t] * strain[t]).sum::<f64>()
                });
                for (a, other) in gradients.iter().enumerate() {
                    for i in 0..dimension {
                        let work = force(dimension, other, i, &stress);
                        stiffness[(dimension * a + i) * size + dimension * b + j] += work;
                    }
                }
            }
        }
    }

    fn add_mass(&self, mass: &mut [f64], shape: &ShapeFunctions, weight: f64) {
        let (count, dimension) = (self.kind.nodes(), self.kind.dimension());
        let size = dimension * count;
        for a in 0..count {
            for b in 0..count {
                let share = weight * shape.values[a] * shape.values[b];
                for i in 0..dimension {
                    mass[(dimension * a + i) * size + dimension * b + i] += share;
                }
            }
        }
    }
}

/// The strain of a unit displacement of a function along `direction`, in the order of [`Elastic::stiffness`].
pub(super) fn strain(dimension: usize, gradient: &[f64; 3], direction: usize) -> [f64; 6] {
    let [x, y, z] = *gradient;
    match (dimension, direction) {
        (2, 0) => [x, 0.0, y, 0.0, 0.0, 0.0],
        (2, _) => [0.0, y, x, 0.0, 0.0, 0.0],
        (_, 0) => [x, 0.0, 0.0, y, 0.0, z],
        (_, 1) => [0.0, y, 0.0, x, z, 0.0],
        (_, _) => [0.0, 0.0, z, 0.0, y, x],
    }
}

/// The work of a stress on a unit displacement of a function along `direction`.
fn force(dimension: usize, gradient: &[f64; 3], direction: usize, stress: &[f64; 6]) -> f64 {
    strain(dimension, gradient, direction).iter().zip(stress).map(|(e, s)| e * s).sum()
}

/// Determinant and inverse of a 3 × 3 matrix; the inverse is not finite where the determinant is zero.
fn inverse(m: &[[f64; 3]; 3]) -> (f64, [[f64; 3]; 3]) {
    let minor = |i: usize, j: usize| {
        let (a, b) = ((i + 1) % 3, (i + 2) % 3);
        let (c, d) = ((j + 1) % 3, (j + 2) % 3);
        m[a][c] * m[b][d] - m[a][d] * m[b][c]
    };
    let determinant = (0..3).map(|j| m[0][j] * minor(0, j)).sum::<f64>();
    (determinant, std::array::from_fn(|i| std::array::from_fn(|j| minor(j, i) / determinant)))
}

/// The largest length of the columns of the part of a matrix that has this dimension.
fn length_of(m: &[[f64; 3]; 3], dimension: usize) -> f64 {
    let column = |k: usize| (0..dimension).map(|i| m[i][k] * m[i][k]).sum::<f64>();
    (0..dimension).map(column).fold(0.0, f64::max).sqrt()
}

/// Gaussian elimination from the last row on, of all but the first `kept`: where no force acts on the others, the rows of these are what is left, and each
/// row below gives its freedom by those before it.
fn eliminate(matrix: &mut [f64], size: usize, kept: usize) {
    for pivot in (kept..size).rev() {
        for row in 0..pivot {
            let share = matrix[row * size + pivot] / matrix[pivot * size + pivot];
            for column in 0..pivot {
                matrix[row * size + column] -= share * matrix[pivot * size + column];
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn steel() -> Elastic {
        Elastic::new(210e9, 0.3, 7800.0).unwrap()
    }

    fn section(kind: ElementKind) -> ElementSection {
        if kind.dimension() == 2 {
            ElementSection::PlaneStress { thickness: 0.01 }
        } else {
            ElementSection::Solid
        }
    }

    /// The nodes of an element whose corners are moved a little; edges stay straight.
    fn distorted(kind: ElementKind) -> Vec<[f64; 3]> {
        let places = kind.node_places();
        let moved = |p: &[f64; 3]| {
            let flat = if kind.dimension() == 2 { 0.0 } else { 1.0 };
            [
                p[0] + 0.1 * p[1] + 0.05 * p[0] * p[1],
                1.2 * p[1] - 0.07 * p[0] * p[1] + 0.1 * p[2],
                flat * (0.9 * p[2] + 0.1 * p[0]),
            ]
        };
        places.iter().map(moved).collect()
    }

    #[test]
    fn they_are_symmetric_and_rigid_motions_cost_nothing() {
        for kind in ElementKind::ALL {
            let elements = BlockElements::new(kind, &steel(), section(kind)).unwrap();
            let nodes = distorted(kind);
            let m = elements.matrices(0, &nodes).unwrap();
            let largest = m.stiffness.iter().fold(0.0_f64, |a, b| a.max(b.abs()));
            for i in 0..m.size {
                for j in 0..m.size {
                    let difference = m.stiffness[i * m.size + j] - m.stiffness[j * m.size + i];
                    assert!(difference.abs() < 1e-12 * largest, "{kind}");
                    assert!((m.mass[i * m.size + j] - m.mass[j * m.size + i]).abs() < 1e-12);
                }
            }
            let dimension = kind.dimension();
            type Motion = fn(&[f64; 3]) -> [f64; 3];
            let motions: [Motion; 3] = [|_| [1.0, 0.0, 0.0], |_| [0.0, 1.0, 0.0], |p| [-p[1], p[0], 0.0]];
            for motion in motions {
                let u: Vec<f64> = nodes.iter().flat_map(|p| motion(p)[..dimension].to_vec()).collect();
                for row in m.stiffness.chunks(m.size) {
                    let force: f64 = row.iter().zip(&u).map(|(k, u)| k * u).sum();
                    assert!(force.abs() < 1e-11 * largest, "{kind}: {force:e}");
                }
            }
        }
    }

    #[test]
    fn the_mass_is_density_times_volume() {
        for kind in ElementKind::ALL {
            let elements = BlockElements::new(kind, &steel(), section(kind)).unwrap();
            let scale = [2.0, 3.0, 0.5];
            let nodes: Vec<[f64; 3]> =
                kind.node_places().iter().map(|p| std::array::from_fn(|k| scale[k] * p[k])).collect();
            let m = elements.matrices(0, &nodes).unwrap();
            let dimension = kind.dimension();
            let along_x: f64 = (0..m.size)
                .step_by(dimension)
                .flat_map(|i| (0..m.size).step_by(dimension).map(move |j| (i, j)))
                .map(|(i, j)| m.mass[i * m.size + j])
                .sum();
            let own = match kind {
                ElementKind::Quad4 | ElementKind::Quad8 => 4.0,
                ElementKind::Triangle6 => 0.5,
                ElementKind::Hexahedron8 | ElementKind::Hexahedron20 => 8.0,
                ElementKind::Tetrahedron10 => 1.0 / 6.0,
            };
            let volume = own * scale[..dimension].iter().product::<f64>() * section(kind).thickness();
            assert!((along_x / (7800.0 * volume) - 1.0).abs() < 1e-13, "{kind}");
        }
    }

    #[test]
    fn an_element_is_refused_that_is_too_thin_to_bend() {
        for kind in ElementKind::ALL {
            let elements = BlockElements::new(kind, &steel(), section(kind)).unwrap();
            let of = |length: f64| {
                let stretched = kind.node_places().iter().map(|[x, y, z]| [length * x, *y, *z]);
                elements.matrices(3, &stretched.collect::<Vec<_>>())
            };
            assert!(of(1e6).is_ok(), "{kind}");
            let error = of(1e9).unwrap_err();
            let ratio = 0.9e9..1e10;
            assert!(
                matches!(error, StructureError::Stretched { element: 3, ratio: own, .. } if ratio.contains(&own)),
                "{kind}: {error}"
            );
        }
    }

    #[test]
    fn a_folded_element_is_refused_with_its_place() {
        let elements =
            BlockElements::new(ElementKind::Quad4, &steel(), ElementSection::PlaneStress { thickness: 1.0 })
                .unwrap();
        let clockwise = [[0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0], [1.0, 0.0, 0.0]];
        let error = elements.matrices(7, &clockwise).unwrap_err();
        assert!(matches!(error, StructureError::Folded { element: 7, determinant, .. } if determinant < 0.0));
    }
}
