//! A box of elements of one kind: for tests, benchmarks, and whoever needs a simple body.

use crate::StructureError;
use crate::chamfer::{BoxSide, ChamferedFace};
use crate::element::ElementKind;
use crate::mesh::{Mesh, MeshBlock};
use std::collections::BTreeMap;

/// Cells along a side, as case files take them.
#[cfg(feature = "keys")]
pub const CELLS: judder_keys::declared::Whole = judder_keys::declared::Whole { from: 1, to: 100_000 };

/// A box whose cells hold one quadrilateral or brick each, two triangles, or six tetrahedra.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grid {
    /// Of the elements.
    pub kind: ElementKind,
    /// Lengths of the box in m; the third is without meaning in the plane.
    pub size: [f64; 3],
    /// Cells along each side; the third is without meaning in the plane.
    pub cells: [usize; 3],
}

/// The corners of a cell's triangles and tetrahedra, as corners of a quadrilateral or brick.
const TRIANGLES: [&[usize]; 2] = [&[0, 1, 2], &[0, 2, 3]];
const TETRAHEDRA: [&[usize]; 6] =
    [&[0, 1, 2, 6], &[0, 2, 3, 6], &[0, 3, 7, 6], &[0, 7, 4, 6], &[0, 4, 5, 6], &[0, 5, 1, 6]];

impl Grid {
    /// The mesh, with its corners moved by `place`; edges stay straight.
    ///
    /// Node sets: `x-min`, `x-max`, `y-min`, …: the sides of the box; `x-min-y-min`, …: where two of them meet.
    ///
    /// # Errors
    /// [`StructureError::InvalidNumber`] for a size or a number of cells that is not positive.
    pub fn mesh(&self, material: &str, place: impl Fn([f64; 3]) -> [f64; 3]) -> Result<Mesh, StructureError> {
        self.mesh_with(None, material, place)
    }

    /// The mesh with chamfers at the ends of a face, its corners moved by `place` afterwards.
    ///
    /// The set of the face, as `y-min`, has the nodes that the chamfers leave of it, with those on the edges between; `chamfer-x-min`, …: the nodes of a
    /// flank, with both of its edges; `y-min-whole`: the face with its flanks. The sides that meet the face are as long as the chamfers leave them.
    ///
    /// # Errors
    /// As [`Self::mesh`]; [`StructureError::NoChamfer`] for chamfers that would fold elements.
    pub fn chamfered_mesh(
        &self,
        chamfered: &ChamferedFace,
        material: &str,
        place: impl Fn([f64; 3]) -> [f64; 3],
    ) -> Result<Mesh, StructureError> {
        chamfered.check(self.kind.dimension(), self.size, self.cells)?;
        self.mesh_with(Some(chamfered), material, place)
    }

    fn mesh_with(
        &self,
        chamfered: Option<&ChamferedFace>,
        material: &str,
        place: impl Fn([f64; 3]) -> [f64; 3],
    ) -> Result<Mesh, StructureError> {
        self.check()?;
        let places = self.corners(|steps, even| {
            place(chamfered.map_or(even, |own| own.place(self.size, self.cells, steps, even)))
        });
        let mut nodes = GridNodes { places, middles: BTreeMap::new() };
        let mut connectivity = Vec::new();
        for cell in self.each_cell() {
            let corners = self.corners_of(cell);
            for own in self.elements_of_a_cell() {
                let own: Vec<usize> = own.iter().map(|k| corners[*k]).collect();
                connectivity.extend(&own);
                for [a, b] in middles(self.kind) {
                    connectivity.push(nodes.middle(own[*a], own[*b]));
                }
            }
        }
        let node_sets = self.node_sets(chamfered, &nodes);
        let blocks = vec![MeshBlock { kind: self.kind, material: material.to_owned(), connectivity }];
        Ok(Mesh { nodes: nodes.places, blocks, node_sets, ..Mesh::default() })
    }

    fn check(&self) -> Result<(), StructureError> {
        let axes = 0..self.kind.dimension();
        let sizes = axes.clone().map(|k| ("the size of the box", self.size[k]));
        let cells = axes.map(|k| ("the number of cells", self.cells[k] as f64));
        match sizes.chain(cells).find(|(_, value)| !(value.is_finite() && *value > 0.0)) {
            Some((name, value)) => {
                Err(StructureError::InvalidNumber { name, value, requirement: "positive" })
            }
            None => Ok(()),
        }
    }

    /// Layers of corners along the third axis: one in the plane.
    fn layers(&self) -> usize {
        if self.kind.dimension() == 3 { self.cells[2] + 1 } else { 1 }
    }

    fn corners(&self, place: impl Fn([usize; 3], [f64; 3]) -> [f64; 3]) -> Vec<[f64; 3]> {
        let at = |k: usize, step: usize| self.size[k] * step as f64 / self.cells[k] as f64;
        let depth = |layer: usize| if self.layers() == 1 { 0.0 } else { at(2, layer) };
        let rows = move |layer| (0..=self.cells[1]).map(move |row| (row, layer));
        (0..self.layers())
            .flat_map(rows)
            .flat_map(|(row, layer)| (0..=self.cells[0]).map(move |column| (column, row, layer)))
            .map(|(column, row, layer)| {
                place([column, row, layer], [at(0, column), at(1, row), depth(layer)])
            })
            .collect()
    }

    fn number(&self, [column, row, layer]: [usize; 3]) -> usize {
        (layer * (self.cells[1] + 1) + row) * (self.cells[0] + 1) + column
    }

    fn each_cell(&self) -> impl Iterator<Item = [usize; 3]> {
        let [columns, rows, _] = self.cells;
        let layers = (self.layers() - 1).max(1);
        (0..layers).flat_map(move |l| (0..rows).flat_map(move |r| (0..columns).map(move |c| [c, r, l])))
    }

    /// The corners of a cell, in the order of a quadrilateral or brick.
    fn corners_of(&self, [column, row, layer]: [usize; 3]) -> Vec<usize> {
        let levels = if self.kind.dimension() == 3 { 2 } else { 1 };
        (0..levels)
            .flat_map(|up| [(0, 0), (1, 0), (1, 1), (0, 1)].map(|(c, r)| [column + c, row + r, layer + up]))
            .map(|corner| self.number(corner))
            .collect()
    }

    /// The corners of a cell's elements.
    fn elements_of_a_cell(&self) -> &'static [&'static [usize]] {
        match self.kind {
            ElementKind::Quad4 | ElementKind::Quad8 => &[&[0, 1, 2, 3]],
            ElementKind::Hexahedron8 | ElementKind::Hexahedron20 => &[&[0, 1, 2, 3, 4, 5, 6, 7]],
            ElementKind::Triangle6 => &TRIANGLES,
            ElementKind::Tetrahedron10 => &TETRAHEDRA,
        }
    }

    /// The nodes on each side: corners by their place in the grid, middles whose corners are both there.
    fn node_sets(
        &self,
        chamfered: Option<&ChamferedFace>,
        nodes: &GridNodes,
    ) -> BTreeMap<String, Vec<usize>> {
        let mut sets = BTreeMap::new();
        for side in BoxSide::BY_AXIS.into_iter().take(self.kind.dimension()).flatten() {
            let is_on = |node: usize| self.is_on(side, node);
            let Some(chamfered) = chamfered.filter(|own| own.face == side) else {
                sets.insert(side.to_string(), self.set_of(nodes, is_on));
                continue;
            };
            let step = |node: usize| self.step_of(node)[chamfered.along];
            let is_flat = |node: usize| is_on(node) && chamfered.is_flat(step(node), self.cells);
            sets.insert(side.to_string(), self.set_of(nodes, is_flat));
            for (name, steps) in chamfered.flanks(self.cells) {
                let is_flank = |node: usize| is_on(node) && steps.contains(&step(node));
                sets.insert(name, self.set_of(nodes, is_flank));
            }
        }
        let mut sets = with_edges(sets);
        if let Some(own) = chamfered {
            let whole = self.set_of(nodes, |node| self.is_on(own.face, node));
            sets.insert(format!("{}-whole", own.face), whole);
        }
        sets
    }

    /// Whether a corner is on a side of the box.
    fn is_on(&self, side: BoxSide, node: usize) -> bool {
        self.step_of(node)[side.axis()] == if side.is_max() { self.cells[side.axis()] } else { 0 }
    }

    /// The corners that are somewhere, and the middles whose corners both are.
    fn set_of(&self, nodes: &GridNodes, is_on: impl Fn(usize) -> bool) -> Vec<usize> {
        let corners = self.number(self.cells_with_layers()) + 1;
        let mut set: Vec<usize> = (0..corners).filter(|node| is_on(*node)).collect();
        set.extend(nodes.middles.iter().filter(|((a, b), _)| is_on(*a) && is_on(*b)).map(|(_, n)| *n));
        set.sort_unstable();
        set
    }

    fn cells_with_layers(&self) -> [usize; 3] {
        [self.cells[0], self.cells[1], self.layers() - 1]
    }

    /// Column, row and layer of a corner.
    fn step_of(&self, corner: usize) -> [usize; 3] {
        let (columns, rows) = (self.cells[0] + 1, self.cells[1] + 1);
        [corner % columns, corner / columns % rows, corner / (columns * rows)]
    }
}

/// The sides of a box, and the nodes that two of them share.
fn with_edges(sides: BTreeMap<String, Vec<usize>>) -> BTreeMap<String, Vec<usize>> {
    let mut sets = sides.clone();
    for (first, own) in &sides {
        for (second, other) in sides.range(first.clone()..).skip(1) {
            let both: Vec<usize> =
                own.iter().filter(|node| other.binary_search(node).is_ok()).copied().collect();
            if !both.is_empty() {
                sets.insert(format!("{first}-{second}"), both);
            }
        }
    }
    sets
}

/// The corners between which a kind has nodes, in their order.
fn middles(kind: ElementKind) -> &'static [[usize; 2]] {
    match kind {
        ElementKind::Quad4 | ElementKind::Hexahedron8 => &[],
        ElementKind::Quad8 => &[[0, 1], [1, 2], [2, 3], [3, 0]],
        ElementKind::Triangle6 => &[[0, 1], [1, 2], [2, 0]],
        ElementKind::Hexahedron20 => {
            &[[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4], [0, 4], [1, 5], [2, 6], [3, 7]]
        }
        ElementKind::Tetrahedron10 => &[[0, 1], [1, 2], [2, 0], [0, 3], [1, 3], [2, 3]],
    }
}

/// Corners first, then the middles of edges as they come up.
struct GridNodes {
    places: Vec<[f64; 3]>,
    middles: BTreeMap<(usize, usize), usize>,
}

impl GridNodes {
    fn middle(&mut self, a: usize, b: usize) -> usize {
        let (first, second) = (a.min(b), a.max(b));
        *self.middles.entry((first, second)).or_insert_with(|| {
            let (p, q) = (self.places[first], self.places[second]);
            self.places.push(std::array::from_fn(|k| 0.5 * (p[k] + q[k])));
            self.places.len() - 1
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn boxes_have_the_nodes_that_they_should() {
        let grid = |kind| Grid { kind, size: [3.0, 2.0, 1.0], cells: [3, 2, 1] };
        // of corners 12 in the plane, 24 in space; then edges
        for (kind, nodes, elements, on_the_right) in [
            (ElementKind::Quad4, 12, 6, 3),
            (ElementKind::Quad8, 12 + 17, 6, 5),
            (ElementKind::Triangle6, 12 + 17 + 6, 12, 5),
            (ElementKind::Hexahedron8, 24, 6, 6),
            (ElementKind::Hexahedron20, 24 + 34 + 12, 6, 13),
            (ElementKind::Tetrahedron10, 24 + 34 + 12 + 12 + 17 + 6, 36, 15),
        ] {
            let mesh = grid(kind).mesh("steel", |p| p).unwrap();
            mesh.check().unwrap();
            assert_eq!((mesh.nodes.len(), mesh.elements()), (nodes, elements), "{kind}");
            assert_eq!(mesh.node_sets["x-max"].len(), on_the_right, "{kind}");
            assert!(mesh.node_sets["x-max"].iter().all(|node| mesh.nodes[*node][0] == 3.0));
            let is_on_edge = |node: &usize| mesh.nodes[*node][0] == 3.0 && mesh.nodes[*node][1] == 0.0;
            let on_edge: Vec<usize> = (0..nodes).filter(is_on_edge).collect();
            assert_eq!(mesh.node_sets["x-max-y-min"], on_edge);
            assert!(!mesh.node_sets.contains_key("x-max-x-min"));
        }
    }

    #[test]
    fn a_box_without_cells_is_refused() {
        let grid = Grid { kind: ElementKind::Quad4, size: [1.0; 3], cells: [1, 0, 1] };
        assert!(matches!(grid.mesh("steel", |p| p), Err(StructureError::InvalidNumber { .. })));
    }
}
