//! What is drawn: places and cells, and displacements on them.

use crate::cause::FileCause;
use crate::error::ExchangeError;
use faer::c64;
use judder_structure::element::ElementKind;
use judder_structure::freedom::{Direction, Freedom, Numbering};
use judder_structure::mesh::Mesh;
use std::collections::{BTreeMap, BTreeSet};

/// Places and the elements between them; without elements they are points.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Geometry {
    /// In m.
    pub places: Vec<[f64; 3]>,
    /// Kinds with the numbers of their places.
    pub cells: Vec<(ElementKind, Vec<usize>)>,
    /// The number of each place in files for test engineers, from 1.
    pub labels: Vec<usize>,
}

impl From<&Mesh> for Geometry {
    fn from(mesh: &Mesh) -> Self {
        let of_block = |block: &judder_structure::mesh::MeshBlock| {
            let kind = block.kind;
            block.connectivity.chunks_exact(kind.nodes()).map(|own| (kind, own.to_vec())).collect::<Vec<_>>()
        };
        Self {
            places: mesh.nodes.clone(),
            cells: mesh.blocks.iter().flat_map(of_block).collect(),
            labels: (1..=mesh.nodes.len()).collect(),
        }
    }
}

impl Geometry {
    /// The nodes of a table of freedoms as points, ascending by their numbers.
    #[must_use]
    pub fn of_freedoms(freedoms: &[Freedom]) -> Self {
        let nodes: BTreeMap<usize, [f64; 3]> = freedoms.iter().map(|own| (own.node, own.place)).collect();
        // labels are positive
        let shift = usize::from(nodes.contains_key(&0));
        Self {
            places: nodes.values().copied().collect(),
            cells: Vec::new(),
            labels: nodes.keys().map(|node| node + shift).collect(),
        }
    }

    /// Whether every place has its label and every cell its nodes.
    pub(crate) fn check(&self) -> Result<(), FileCause> {
        let said = self.places.len();
        if self.labels.len() != said {
            return Err(FileCause::WrongCount { what: "labels of places", said, found: self.labels.len() });
        }
        let wrong = |(kind, own): &&(ElementKind, Vec<usize>)| {
            own.len() != kind.nodes() || own.iter().any(|node| *node >= said)
        };
        match self.cells.iter().find(wrong) {
            Some((kind, own)) if own.len() != kind.nodes() => {
                Err(FileCause::WrongNodes { kind: *kind, needed: kind.nodes(), found: own.len() })
            }
            Some((_, own)) => {
                let node = own.iter().max().copied().unwrap_or_default();
                Err(FileCause::Unknown { what: "node", label: format!("{node} (from 0) of {said}") })
            }
            None => Ok(()),
        }
    }

    /// The lines of a drawing: all sides of plane elements, the edges of those faces of solids that belong to one only, each once,
    /// over the middles of edges where there are some. The geometry must be [whole](Self::check).
    pub(crate) fn lines(&self) -> Vec<[usize; 2]> {
        let mut faces: BTreeMap<Vec<usize>, (usize, Vec<usize>)> = BTreeMap::new();
        for (kind, own) in &self.cells {
            for side in kind.sides() {
                let nodes: Vec<usize> = side.iter().map(|k| own[*k]).collect();
                let mut sorted = nodes.clone();
                sorted.sort_unstable();
                let face = faces.entry(sorted).or_insert((0, nodes));
                face.0 += usize::from(kind.dimension() == 3);
            }
        }
        let outer = faces.into_values().filter(|(count, _)| *count < 2);
        let lines: BTreeSet<[usize; 2]> = outer.flat_map(|(_, nodes)| edges(&nodes)).collect();
        lines.into_iter().collect()
    }
}

/// The pieces of the edges of a side: a line of two or three nodes, or a face of corners and, after them, middles.
fn edges(nodes: &[usize]) -> Vec<[usize; 2]> {
    let ascending = |a: usize, b: usize| [a.min(b), a.max(b)];
    match *nodes {
        [a, b] => return vec![ascending(a, b)],
        [a, b, middle] => return vec![ascending(a, middle), ascending(middle, b)],
        _ => {}
    }
    // faces of six nodes are triangles with middles, of four quadrilaterals without
    let corners = match nodes.len() {
        6 => 3,
        length => length.min(4),
    };
    let pieces = |k: usize| {
        let (a, b) = (nodes[k], nodes[(k + 1) % corners]);
        match nodes.get(corners + k) {
            Some(middle) => vec![ascending(a, *middle), ascending(*middle, b)],
            None => vec![ascending(a, b)],
        }
    };
    (0..corners).flat_map(pieces).collect()
}

/// The displacement of every node of a mesh, from a vector over the free displacements; those that are held are zero.
///
/// # Errors
/// [`FileCause::WrongCount`] for a vector of another length.
pub fn displacements_of_nodes<T: Copy + Default>(
    numbering: &Numbering,
    nodes: usize,
    vector: &[T],
) -> Result<Vec<[T; 3]>, ExchangeError> {
    check_length(numbering.freedoms().len(), vector.len())?;
    let along = |node, direction| {
        numbering.number(node, direction).and_then(|k| vector.get(k)).copied().unwrap_or_default()
    };
    Ok((0..nodes).map(|node| Direction::ALL.map(|direction| along(node, direction))).collect())
}

/// The displacement of every node of a table of freedoms, in the order of [`Geometry::of_freedoms`].
///
/// # Errors
/// [`FileCause::WrongCount`] for a vector of another length.
pub fn displacements_of_freedoms<T: Copy + Default>(
    freedoms: &[Freedom],
    vector: &[T],
) -> Result<Vec<[T; 3]>, ExchangeError> {
    check_length(freedoms.len(), vector.len())?;
    let mut nodes: BTreeMap<usize, [T; 3]> = BTreeMap::new();
    for (freedom, value) in freedoms.iter().zip(vector) {
        nodes.entry(freedom.node).or_default()[freedom.direction as usize] = *value;
    }
    Ok(nodes.into_values().collect())
}

fn check_length(said: usize, found: usize) -> Result<(), FileCause> {
    if said == found { Ok(()) } else { Err(FileCause::WrongCount { what: "displacements", said, found }) }
}

/// Displacements at a phase of the period: Re(φ exp(iθ)), θ in rad.
#[must_use]
pub fn at_phase(shape: &[[c64; 3]], phase: f64) -> Vec<[f64; 3]> {
    let (sine, cosine) = libm::sincos(phase);
    shape.iter().map(|own| own.map(|value| value.re * cosine - value.im * sine)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use judder_structure::freedom::Supports;
    use judder_structure::grid::Grid;

    fn mesh(kind: ElementKind) -> Mesh {
        Grid { kind, size: [2.0, 1.0, 1.0], cells: [2, 1, 1] }.mesh("any", |p| p).unwrap()
    }

    #[test]
    fn drawings_have_the_outer_edges_once() {
        let lines = |kind| Geometry::from(&mesh(kind)).lines().len();
        assert_eq!(lines(ElementKind::Quad4), 7);
        assert_eq!(lines(ElementKind::Quad8), 14);
        assert_eq!(lines(ElementKind::Hexahedron8), 20);
        assert_eq!(lines(ElementKind::Hexahedron20), 40);
    }

    #[test]
    fn cells_without_their_nodes_are_refused() {
        let whole = Geometry::from(&mesh(ElementKind::Quad4));
        whole.check().unwrap();
        let mut beyond = whole.clone();
        beyond.cells[0].1[0] = 6;
        assert_eq!(beyond.check().unwrap_err().to_string(), "there is no node 6 (from 0) of 6");
        let mut short = whole.clone();
        short.cells[0].1.pop();
        assert!(matches!(short.check(), Err(FileCause::WrongNodes { needed: 4, found: 3, .. })));
        assert!(Geometry { labels: vec![1], ..whole }.check().is_err());
    }

    #[test]
    fn held_displacements_are_zero() {
        let mesh = mesh(ElementKind::Quad4);
        let supports = Supports { fixed: vec![(0, Direction::X)], ..Supports::default() };
        let numbering = Numbering::new(&mesh, 2, &supports).unwrap();
        let vector: Vec<f64> = (1..=11).map(f64::from).collect();
        let found = displacements_of_nodes(&numbering, mesh.nodes.len(), &vector).unwrap();
        assert_eq!(&found[..2], [[0.0, 1.0, 0.0], [2.0, 3.0, 0.0]]);
        assert!(displacements_of_nodes(&numbering, mesh.nodes.len(), &vector[1..]).is_err());
        let by_table = displacements_of_freedoms(numbering.freedoms(), &vector).unwrap();
        assert_eq!(by_table, found);
    }

    #[test]
    fn phases_turn_through_the_period() {
        let shape = [[c64::new(1.0, 2.0), c64::new(0.0, 0.0), c64::new(-1.0, 0.0)]];
        assert_eq!(at_phase(&shape, 0.0), [[1.0, 0.0, -1.0]]);
        let quarter = at_phase(&shape, std::f64::consts::FRAC_PI_2)[0];
        assert!((quarter[0] + 2.0).abs() < 1e-15 && quarter[2].abs() < 1e-15);
    }
}
