//! Surfaces of bodies: the outer sides of elements between the nodes of a set.

use crate::AssemblyError;
use crate::vector::{Vector, along, cross, length, minus, scaled, unit};
use judder_structure::element::ElementKind;
use judder_structure::mesh::Mesh;
use std::collections::{BTreeMap, BTreeSet};

/// An outer side of an element: an edge in the plane, a triangle or a quadrilateral in space.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Face {
    /// Its corners; seen from outside they turn to the left, an edge has the body on its left.
    pub nodes: Vec<usize>,
}

/// Faces of a body.
#[derive(Debug, Clone, PartialEq)]
pub struct Surface {
    /// Their corners.
    pub faces: Vec<Face>,
}

/// A place on a face.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct OnFace {
    /// Shape functions of the corners.
    pub(crate) weights: Vec<f64>,
    pub(crate) place: Vector,
    /// The area vector: outwards, as long as the area of the surface a unit of the face's own coordinates.
    pub(crate) area: Vector,
    /// Its own coordinates on the face.
    pub(crate) own: [f64; 2],
}

impl Surface {
    /// The outer sides of elements all of whose nodes are in a set.
    ///
    /// # Errors
    /// [`AssemblyError::QuadraticFace`] for sides with nodes between their corners: a uniform pressure loads these unevenly, at corners
    /// of twenty-node bricks even the wrong way, so node by node they cannot be in contact.
    pub fn of_nodes(mesh: &Mesh, nodes: &[usize]) -> Result<Self, AssemblyError> {
        let wanted: BTreeSet<usize> = nodes.iter().copied().collect();
        // a side of two elements is inside
        let mut outer: BTreeMap<Vec<usize>, Option<(ElementKind, Vec<usize>)>> = BTreeMap::new();
        for block in &mesh.blocks {
            for element in block.connectivity.chunks(block.kind.nodes()) {
                for side in block.kind.sides() {
                    let own: Vec<usize> = side.iter().map(|k| element[*k]).collect();
                    if own.iter().all(|node| wanted.contains(node)) {
                        let mut key = own.clone();
                        key.sort_unstable();
                        outer.entry(key).and_modify(|other| *other = None).or_insert(Some((block.kind, own)));
                    }
                }
            }
        }
        let face = |(kind, nodes): (ElementKind, Vec<usize>)| match kind {
            ElementKind::Quad4 | ElementKind::Hexahedron8 => Ok(Face { nodes }),
            _ => Err(AssemblyError::QuadraticFace { kind }),
        };
        Ok(Self { faces: outer.into_values().flatten().map(face).collect::<Result<_, _>>()? })
    }

    /// The outward area vector of each node, in m² (in m in the plane): the integral of its shape functions times the normal, so that a
    /// pressure p loads it by −p times this.
    #[must_use]
    pub fn nodal_areas(&self, mesh: &Mesh) -> BTreeMap<usize, [f64; 3]> {
        let mut sums: BTreeMap<usize, Vector> = BTreeMap::new();
        for face in &self.faces {
            for (node, area) in face.nodal_areas(mesh) {
                let sum = sums.entry(node).or_insert([0.0; 3]);
                *sum = along(*sum, 1.0, area);
            }
        }
        sums
    }

    /// The outward normals of its nodes, those of the faces around each weighted by their areas.
    pub(crate) fn normals(&self, mesh: &Mesh) -> BTreeMap<usize, Vector> {
        self.nodal_areas(mesh).into_iter().filter_map(|(node, sum)| Some((node, unit(sum)?))).collect()
    }

    /// The area that each node stands for, in m² (in m in the plane): the integral of its shape functions.
    pub(crate) fn tributary(&self, mesh: &Mesh) -> BTreeMap<usize, f64> {
        let mut sums: BTreeMap<usize, f64> = BTreeMap::new();
        for face in &self.faces {
            for (node, area) in face.nodal_areas(mesh) {
                *sums.entry(node).or_default() += length(area);
            }
        }
        sums
    }
}

/// Gauss's places of two on [−1, 1].
const GAUSS: [f64; 2] = [-0.577_350_269_189_625_8, 0.577_350_269_189_625_8];

/// The corners of a quadrilateral in its own coordinates.
const CORNERS: [(f64, f64); 4] = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];

/// (1 ± x)/2.
fn half(sign: f64, x: f64) -> f64 {
    0.5 * (1.0 + sign * x)
}

impl Face {
    /// A place by the face's own coordinates: [−1, 1] on an edge, [−1, 1]² on a quadrilateral.
    pub(crate) fn at(&self, mesh: &Mesh, own: [f64; 2]) -> OnFace {
        let [x, y] = own;
        let weights: Vec<f64> = match self.nodes.len() {
            2 => vec![half(-1.0, x), half(1.0, x)],
            _ => CORNERS.iter().map(|(a, b)| half(*a, x) * half(*b, y)).collect(),
        };
        let slopes = self.slopes(own);
        // an edge of the plane stands upright on it
        let second = slopes.get(1).map_or([0.0, 0.0, 1.0], |by_y| self.sum(mesh, by_y));
        OnFace {
            place: self.sum(mesh, &weights),
            area: cross(self.sum(mesh, &slopes[0]), second),
            weights,
            own,
        }
    }

    /// The derivatives of the corners' shape functions by the face's own coordinates: one on an edge, two on a quadrilateral.
    pub(crate) fn slopes(&self, [x, y]: [f64; 2]) -> Vec<Vec<f64>> {
        match self.nodes.len() {
            2 => vec![vec![-0.5, 0.5]],
            _ => vec![
                CORNERS.iter().map(|(a, b)| 0.5 * a * half(*b, y)).collect(),
                CORNERS.iter().map(|(a, b)| 0.5 * b * half(*a, x)).collect(),
            ],
        }
    }

    /// Σ w x over the corners.
    pub(crate) fn sum(&self, mesh: &Mesh, weights: &[f64]) -> Vector {
        let corners = self.nodes.iter().zip(weights);
        corners.fold([0.0; 3], |sum, (node, weight)| along(sum, *weight, mesh.nodes[*node]))
    }

    /// The area vector that each corner stands for.
    fn nodal_areas(&self, mesh: &Mesh) -> Vec<(usize, Vector)> {
        let is_edge = self.nodes.len() == 2;
        // the weight of each of Gauss's two places is one; an edge has one coordinate
        let places: Vec<[f64; 2]> = match is_edge {
            true => GAUSS.map(|x| [x, 0.0]).to_vec(),
            false => GAUSS.iter().flat_map(|x| GAUSS.map(|y| [*x, y])).collect(),
        };
        let mut areas: Vec<(usize, Vector)> = self.nodes.iter().map(|node| (*node, [0.0; 3])).collect();
        for place in places {
            let at = self.at(mesh, place);
            for ((_, area), weight) in areas.iter_mut().zip(&at.weights) {
                *area = along(*area, *weight, at.area);
            }
        }
        areas
    }

    /// The place of the face that is nearest to a place in space, by Newton's method in the face's own coordinates, held inside.
    pub(crate) fn nearest(&self, mesh: &Mesh, place: Vector) -> OnFace {
        /// Steps; on flat faces one is enough.
        const STEPS: usize = 20;
        let mut own = [0.0; 2];
        for _ in 0..STEPS {
            let at = self.at(mesh, own);
            let off = minus(place, at.place);
            let step = self.step(mesh, own, off);
            let next = [0, 1].map(|k| (own[k] + step[k]).clamp(-1.0, 1.0));
            let moved = (next[0] - own[0]).abs().max((next[1] - own[1]).abs());
            own = next;
            if moved < 1e-14 {
                break;
            }
        }
        self.at(mesh, own)
    }

    /// The step of Gauss and Newton in the face's own coordinates towards what is off, the coordinate that is held at an end left out.
    fn step(&self, mesh: &Mesh, own: [f64; 2], off: Vector) -> [f64; 2] {
        let h = 1e-3;
        let slope = |k: usize| {
            let moved = |by: f64| {
                let mut at = own;
                at[k] += by;
                self.at(mesh, at).place
            };
            scaled(0.5 / h, minus(moved(h), moved(-h)))
        };
        let dot = crate::vector::dot;
        let a = slope(0);
        let (aa, ao) = (dot(a, a), dot(a, off));
        if self.nodes.len() == 2 {
            return [ao / aa, 0.0];
        }
        let b = slope(1);
        let (ab, bb, bo) = (dot(a, b), dot(b, b), dot(b, off));
        let determinant = aa * bb - ab * ab;
        let free = [(ao * bb - bo * ab) / determinant, (bo * aa - ao * ab) / determinant];
        let leaves = |k: usize| own[k].abs() >= 1.0 && free[k] * own[k] > 0.0;
        match (leaves(0), leaves(1)) {
            (true, false) => [0.0, bo / bb],
            (false, true) => [ao / aa, 0.0],
            (true, true) => [ao / aa, bo / bb],
            (false, false) => free,
        }
    }

    /// The corners of a box around it.
    pub(crate) fn bounds(&self, mesh: &Mesh) -> (Vector, Vector) {
        let each = |pick: fn(f64, f64) -> f64, start: f64| {
            let corners = self.nodes.iter().map(|node| mesh.nodes[*node]);
            corners.fold([start; 3], |best, corner| std::array::from_fn(|k| pick(best[k], corner[k])))
        };
        (each(f64::min, f64::INFINITY), each(f64::max, f64::NEG_INFINITY))
    }
}
