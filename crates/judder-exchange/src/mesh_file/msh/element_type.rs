//! The element types of Gmsh.

use judder_structure::element::ElementKind;

/// A type of Gmsh.
#[derive(Debug, Clone, Copy)]
pub(super) struct GmshType {
    pub(super) dimension: usize,
    pub(super) nodes: usize,
    /// Its counterpart.
    pub(super) kind: Option<ElementKind>,
}

/// Gmsh's edges of a twenty-node brick run 01 03 04 12 15 23 26 37 45 47 56 67.
const BRICK: [usize; 20] = [0, 1, 2, 3, 4, 5, 6, 7, 8, 11, 13, 9, 16, 18, 19, 17, 10, 12, 14, 15];
/// Gmsh has the middle of the edge 23 before that of 13.
const TETRAHEDRON: [usize; 10] = [0, 1, 2, 3, 4, 5, 6, 7, 9, 8];

/// What elements of the second order that are read look like.
pub(super) const READ: &str = "lines, four- and eight-node quadrilaterals, six-node triangles, eight- and twenty-node bricks, ten-node \
     tetrahedra; set Mesh.ElementOrder = 2 and Mesh.SecondOrderIncomplete = 1";

/// The type of a number; none where Gmsh has it and nothing of it is needed here.
pub(super) fn gmsh_type(number: i64) -> Option<GmshType> {
    use ElementKind::{Hexahedron8, Hexahedron20, Quad4, Quad8, Tetrahedron10, Triangle6};
    let (dimension, nodes, kind) = match number {
        15 => (0, 1, None),
        1 => (1, 2, None),
        8 => (1, 3, None),
        2 => (2, 3, None),
        3 => (2, 4, Some(Quad4)),
        9 => (2, 6, Some(Triangle6)),
        10 => (2, 9, None),
        16 => (2, 8, Some(Quad8)),
        4 => (3, 4, None),
        5 => (3, 8, Some(Hexahedron8)),
        6 => (3, 6, None),
        7 => (3, 5, None),
        11 => (3, 10, Some(Tetrahedron10)),
        12 => (3, 27, None),
        13 => (3, 18, None),
        14 => (3, 14, None),
        17 => (3, 20, Some(Hexahedron20)),
        18 => (3, 15, None),
        19 => (3, 13, None),
        _ => return None,
    };
    Some(GmshType { dimension, nodes, kind })
}

/// For each node of a kind its place in Gmsh's order.
pub(super) fn order(kind: ElementKind, nodes: &[usize]) -> Vec<usize> {
    match kind {
        ElementKind::Hexahedron20 => BRICK.iter().map(|k| nodes[*k]).collect(),
        ElementKind::Tetrahedron10 => TETRAHEDRON.iter().map(|k| nodes[*k]).collect(),
        _ => nodes.to_vec(),
    }
}

/// The corners of a side, sorted: what tells it.
pub(super) fn corners(nodes: &[usize]) -> [usize; 4] {
    let corners = match nodes.len() {
        2 | 3 => 2,
        6 => 3,
        _ => 4,
    };
    let mut told = [usize::MAX; 4];
    for (place, node) in told.iter_mut().zip(&nodes[..corners.min(nodes.len())]) {
        *place = *node;
    }
    told.sort_unstable();
    told
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Edges by their corners, as the reference manual draws them.
    #[test]
    fn edges_of_gmsh_become_ours() {
        let gmsh_brick =
            [[0, 1], [0, 3], [0, 4], [1, 2], [1, 5], [2, 3], [2, 6], [3, 7], [4, 5], [4, 7], [5, 6], [6, 7]];
        let gmsh_tetrahedron = [[0, 1], [1, 2], [2, 0], [0, 3], [2, 3], [1, 3]];
        let check = |kind: ElementKind, edges: &[[usize; 2]], corners: usize| {
            let places = kind.node_places();
            for (k, from) in order(kind, &(0..kind.nodes()).collect::<Vec<_>>()).into_iter().enumerate() {
                let [a, b] = if from < corners { [from, from] } else { edges[from - corners] };
                let middle = std::array::from_fn(|axis| 0.5 * (places[a][axis] + places[b][axis]));
                assert_eq!(places[k], middle, "{kind} {k}");
            }
        };
        check(ElementKind::Hexahedron20, &gmsh_brick, 8);
        check(ElementKind::Tetrahedron10, &gmsh_tetrahedron, 4);
    }
}
