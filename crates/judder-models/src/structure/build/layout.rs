//! Where freedoms lie, and the lines that show a shape.

use judder_structure::element::ElementKind;
use judder_structure::freedom::{Direction, Freedom, Numbering};
use judder_structure::mesh::Mesh;
use std::collections::BTreeMap;

/// Places, which freedoms they have, and lines between them.
pub(crate) struct StructureLayout {
    /// Where the points lie, m.
    pub(crate) points: Vec<[f64; 3]>,
    /// What the points are called: numbers of nodes.
    pub(crate) names: Vec<usize>,
    /// The freedom of each point along x, y, z; `None` where it is held or there is none.
    pub(crate) freedoms: Vec<[Option<usize>; 3]>,
    /// Lines that show the body: pairs of points.
    pub(crate) lines: Vec<[usize; 2]>,
    /// Sets of points by name, where there is no mesh that has them.
    pub(crate) sets: BTreeMap<String, Vec<usize>>,
}

/// Faces meet in an edge of the body where the cosine between their normals is below this: about 30°.
const EDGE: f64 = 0.87;

impl StructureLayout {
    /// The nodes of a mesh, with the outline of its surface.
    pub(crate) fn of_mesh(mesh: &Mesh, numbering: &Numbering) -> Self {
        let freedoms = (0..mesh.nodes.len())
            .map(|node| Direction::ALL.map(|direction| numbering.number(node, direction)))
            .collect();
        let names = (0..mesh.nodes.len()).collect();
        let (points, lines) = (mesh.nodes.clone(), outline(mesh));
        Self { points, names, freedoms, lines, sets: BTreeMap::new() }
    }

    /// The nodes of a table of freedoms.
    pub(crate) fn of_table(table: &[Freedom]) -> Self {
        let mut numbers: BTreeMap<usize, usize> = BTreeMap::new();
        let (mut points, mut names, mut freedoms) = (Vec::new(), Vec::new(), Vec::new());
        for (freedom, entry) in table.iter().enumerate() {
            let point = *numbers.entry(entry.node).or_insert_with(|| {
                points.push(entry.place);
                names.push(entry.node);
                freedoms.push([None; 3]);
                points.len() - 1
            });
            freedoms[point][entry.direction as usize] = Some(freedom);
        }
        Self { points, names, freedoms, lines: Vec::new(), sets: BTreeMap::new() }
    }

    /// Whether points lie apart, so that a shape is a picture.
    pub(crate) fn has_places(&self) -> bool {
        self.points.iter().any(|place| *place != self.points[0])
    }

    /// A point in words: by the name of its set where that has no other, else by its number.
    pub(crate) fn word(&self, point: usize) -> String {
        let own = self.sets.iter().find(|(_, points)| points[..] == [point]);
        own.map_or_else(|| format!("node {}", self.names[point]), |(name, _)| format!("`{name}`"))
    }

    /// The displacements of all points, x, y, z of one after the other, of a vector of all freedoms.
    pub(crate) fn displacements<T: Copy + Default>(&self, vector: &[T]) -> Vec<T> {
        let of = |freedom: &Option<usize>| freedom.and_then(|k| vector.get(k).copied()).unwrap_or_default();
        self.freedoms.iter().flatten().map(of).collect()
    }
}

/// An edge of the surface: its node in the middle, where it has one, and the normals of its faces.
struct SurfaceEdge {
    middle: Option<usize>,
    normals: Vec<[f64; 3]>,
}

/// The sides that only one element has: free edges in the plane; in space the edges in which free faces of different directions
/// meet.
fn outline(mesh: &Mesh) -> Vec<[usize; 2]> {
    let free = free_sides(mesh);
    if is_plane(mesh) {
        return free.iter().flat_map(|side| side_in_plane(side)).collect();
    }
    let dot = |a: &[f64; 3], b: &[f64; 3]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let is_edge = |normals: &[[f64; 3]]| match normals {
        [a, b] => dot(a, b) < EDGE,
        _ => true,
    };
    surface_edges(mesh, &free)
        .iter()
        .filter(|(_, edge)| is_edge(&edge.normals))
        .flat_map(|([a, b], edge)| along(*a, edge.middle, *b))
        .collect()
}

/// The sides of all elements in the plane, in space the edges of all free faces: how a body is meshed.
pub(crate) fn mesh_lines(mesh: &Mesh) -> Vec<[usize; 2]> {
    if is_plane(mesh) {
        return sides(mesh).iter().flat_map(|(_, side)| side_in_plane(side)).collect();
    }
    let edges = surface_edges(mesh, &free_sides(mesh));
    edges.iter().flat_map(|([a, b], edge)| along(*a, edge.middle, *b)).collect()
}

fn is_plane(mesh: &Mesh) -> bool {
    mesh.blocks.iter().all(|block| block.kind.dimension() == 2)
}

fn side_in_plane(side: &[usize]) -> Vec<[usize; 2]> {
    along(side[0], side.get(2).copied(), side[1])
}

/// The edges of free faces, by their corners.
fn surface_edges(mesh: &Mesh, free: &[Vec<usize>]) -> BTreeMap<[usize; 2], SurfaceEdge> {
    let mut edges: BTreeMap<[usize; 2], SurfaceEdge> = BTreeMap::new();
    for side in free {
        let corners = corners_of_face(side.len());
        let normal = normal(mesh, &side[..corners]);
        for k in 0..corners {
            let (a, b) = (side[k], side[(k + 1) % corners]);
            let middle = middle_of_edge(mesh, side, corners, [a, b]);
            let edge =
                edges.entry([a.min(b), a.max(b)]).or_insert(SurfaceEdge { middle, normals: Vec::new() });
            edge.normals.push(normal);
        }
    }
    edges
}

/// A line from one corner to the next, by the middle where there is one.
fn along(a: usize, middle: Option<usize>, b: usize) -> Vec<[usize; 2]> {
    match middle {
        Some(middle) => vec![[a, middle], [middle, b]],
        None => vec![[a, b]],
    }
}

/// The nodes of the sides that belong to one element alone.
fn free_sides(mesh: &Mesh) -> Vec<Vec<usize>> {
    sides(mesh).into_iter().filter(|(count, _)| *count == 1).map(|(_, nodes)| nodes).collect()
}

/// The nodes of all sides, each once, and how many elements have it.
fn sides(mesh: &Mesh) -> Vec<(usize, Vec<usize>)> {
    let mut sides: BTreeMap<Vec<usize>, (usize, Vec<usize>)> = BTreeMap::new();
    for block in &mesh.blocks {
        for nodes in block.connectivity.chunks_exact(block.kind.nodes()) {
            for side in block.kind.sides() {
                let own: Vec<usize> = side.iter().map(|k| nodes[*k]).collect();
                let mut key = own[..corners_of_side(block.kind, own.len())].to_vec();
                key.sort_unstable();
                sides.entry(key).or_insert((0, own)).0 += 1;
            }
        }
    }
    sides.into_values().collect()
}

fn corners_of_side(kind: ElementKind, nodes: usize) -> usize {
    if kind.dimension() == 2 { 2 } else { corners_of_face(nodes) }
}

/// Corners of a face of so many nodes: quadratic faces have as many middles.
fn corners_of_face(nodes: usize) -> usize {
    match nodes {
        3 | 6 => 3,
        _ => 4,
    }
}

/// The node in the middle of a quadratic face's edge: the one nearest to halfway between its corners.
fn middle_of_edge(mesh: &Mesh, side: &[usize], corners: usize, [a, b]: [usize; 2]) -> Option<usize> {
    let halfway: [f64; 3] = std::array::from_fn(|k| 0.5 * (mesh.nodes[a][k] + mesh.nodes[b][k]));
    let distance =
        |node: &usize| mesh.nodes[*node].iter().zip(&halfway).map(|(p, q)| (p - q).powi(2)).sum::<f64>();
    side[corners..].iter().copied().min_by(|p, q| distance(p).total_cmp(&distance(q)))
}

/// The unit normal of a face by its corners.
fn normal(mesh: &Mesh, corners: &[usize]) -> [f64; 3] {
    let place = |k: usize| mesh.nodes[corners[k]];
    let (o, p, q) = (place(0), place(1), place(corners.len() - 1));
    let [u, v]: [[f64; 3]; 2] = [p, q].map(|end| std::array::from_fn(|k| end[k] - o[k]));
    let cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    let length = cross.iter().map(|x| x * x).sum::<f64>().sqrt();
    cross.map(|x| x / length)
}

#[cfg(test)]
mod tests {
    use super::*;
    use judder_structure::grid::Grid;

    /// A box has twelve edges; of two cells along x and quadratic elements its four long edges have four pieces each, the others two.
    #[test]
    fn a_box_is_shown_by_its_edges() {
        for (kind, pieces) in
            [(ElementKind::Hexahedron20, 4 * 4 + 8 * 2), (ElementKind::Hexahedron8, 4 * 2 + 8)]
        {
            let grid = Grid { kind, size: [2.0, 1.0, 1.0], cells: [2, 1, 1] };
            let mesh = grid.mesh("any", |p| p).unwrap();
            let lines = outline(&mesh);
            assert_eq!(lines.len(), pieces, "{kind}");
            let along_axes = |[a, b]: &[usize; 2]| {
                (0..3).filter(|k| mesh.nodes[*a][*k] != mesh.nodes[*b][*k]).count() == 1
            };
            assert!(lines.iter().all(along_axes));
        }
    }

    #[test]
    fn a_plate_is_shown_by_its_rim() {
        let grid = Grid { kind: ElementKind::Quad8, size: [2.0, 1.0, 0.0], cells: [2, 1, 0] };
        assert_eq!(outline(&grid.mesh("any", |p| p).unwrap()).len(), 2 * 6);
    }

    /// Two quadratic cells share a side of two pieces; two cubes have the edges of their box and four where they meet.
    #[test]
    fn a_mesh_is_shown_by_its_sides() {
        let plate = Grid { kind: ElementKind::Quad8, size: [2.0, 1.0, 0.0], cells: [2, 1, 0] };
        assert_eq!(mesh_lines(&plate.mesh("any", |p| p).unwrap()).len(), 2 * 7);
        let cubes = Grid { kind: ElementKind::Hexahedron8, size: [2.0, 1.0, 1.0], cells: [2, 1, 1] };
        assert_eq!(mesh_lines(&cubes.mesh("any", |p| p).unwrap()).len(), 4 * 2 + 8 + 4);
    }
}
