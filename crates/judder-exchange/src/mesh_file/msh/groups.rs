//! Physical groups as sets of nodes, sides and elements.

use super::element_type::{corners, order};
use super::sections::{ElementBlock, Sections, unsupported};
use crate::cause::FileCause;
use crate::mesh_file::building::{FileElement, FileParts};
use crate::mesh_file::{UNNAMED, Warning};
use judder_structure::element::ElementKind;
use judder_structure::mesh::ElementSide;
use std::collections::BTreeMap;

const DIMENSIONS: [&str; 4] = ["point", "curve", "surface", "volume"];

/// Sides of elements by their corners, sorted.
struct SortedSides(Vec<([usize; 4], ElementSide)>);

impl Sections {
    /// Elements of the highest dimension, and every physical group as a set of nodes; those of the highest dimension also as
    /// sets of elements, those one below as sets of sides.
    pub(super) fn into_parts(mut self) -> Result<FileParts, FileCause> {
        let blocks = std::mem::take(&mut self.blocks);
        let highest = blocks.iter().map(|block| block.dimension).max().filter(|dimension| *dimension >= 2);
        let highest = highest.ok_or(FileCause::NoElements)?;
        for block in blocks.iter().filter(|block| block.dimension == highest) {
            self.add_elements(block)?;
        }
        let sides = SortedSides::of(&self.parts.elements);
        let mut curves: BTreeMap<String, Vec<[usize; 2]>> = BTreeMap::new();
        let mut lost: BTreeMap<String, usize> = BTreeMap::new();
        for block in &blocks {
            for name in self.names_of(block) {
                self.parts.node_sets.entry(name.clone()).or_default().extend(&block.nodes);
                if block.dimension == 1 {
                    let ends = block.nodes.chunks_exact(block.of_type.nodes).flat_map(pieces);
                    curves.entry(name.clone()).or_default().extend(ends);
                }
                if block.dimension + 1 == highest {
                    let set = self.parts.side_sets.entry(name.clone()).or_default();
                    for nodes in block.nodes.chunks_exact(block.of_type.nodes) {
                        match sides.of_corners(corners(nodes)) {
                            [(_, side)] => set.push(*side),
                            _ => *lost.entry(name.clone()).or_default() += 1,
                        }
                    }
                }
            }
        }
        self.parts.side_sets.retain(|_, sides| !sides.is_empty());
        self.order_sets(curves);
        self.parts.warnings.extend(lost.into_iter().map(|(name, count)| Warning {
            line: None,
            text: format!("{count} pieces of `{name}` are not the side of just one element: they are a set of nodes only"),
        }));
        Ok(self.parts)
    }

    fn add_elements(&mut self, block: &ElementBlock) -> Result<(), FileCause> {
        let kind = block.of_type.kind.ok_or_else(|| unsupported(block.number))?;
        let names = self.names_of(block);
        let parts = &mut self.parts;
        for (label, nodes) in block.labels.iter().zip(block.nodes.chunks_exact(block.of_type.nodes)) {
            let nodes = to_the_left(kind, order(kind, nodes), &parts.nodes);
            let name = names.first().map_or(UNNAMED, String::as_str).to_owned();
            for name in &names {
                parts.element_sets.entry(name.clone()).or_default().push(parts.elements.len());
            }
            parts.elements.push(FileElement { label: *label, kind, block: name, nodes });
        }
        Ok(())
    }

    /// The names of the physical groups of a block; one without a name is called by its dimension and number.
    fn names_of(&self, block: &ElementBlock) -> Vec<String> {
        let groups = self.groups.get(&(block.dimension, block.entity)).map_or(&[][..], Vec::as_slice);
        let name = |group: &i64| match self.names.get(&(block.dimension, *group)) {
            Some(name) => name.clone(),
            None => format!("{}-{group}", DIMENSIONS[block.dimension.min(3)]),
        };
        groups.iter().map(name).collect()
    }

    /// Nodes of one curve in their order along it, all others ascending.
    fn order_sets(&mut self, mut curves: BTreeMap<String, Vec<[usize; 2]>>) {
        for (name, set) in &mut self.parts.node_sets {
            set.sort_unstable();
            set.dedup();
            if let Some(along) = curves.remove(name).and_then(|pieces| chain(&pieces))
                && along.len() == set.len()
            {
                *set = along;
            }
        }
    }
}

impl SortedSides {
    fn of(elements: &[FileElement]) -> Self {
        let sides_of = |(element, own): (usize, &FileElement)| {
            let nodes = own.nodes.clone();
            let told = move |(side, places): (usize, &&[usize])| {
                let nodes: Vec<usize> = places.iter().map(|k| nodes[*k]).collect();
                (corners(&nodes), ElementSide { element, side })
            };
            own.kind.sides().iter().enumerate().map(told)
        };
        let mut sides: Vec<_> = elements.iter().enumerate().flat_map(sides_of).collect();
        sides.sort_by_key(|(corners, side)| (*corners, side.element, side.side));
        Self(sides)
    }

    fn of_corners(&self, corners: [usize; 4]) -> &[([usize; 4], ElementSide)] {
        let first = self.0.partition_point(|(own, _)| *own < corners);
        let count = self.0[first..].iter().take_while(|(own, _)| *own == corners).count();
        &self.0[first..first + count]
    }
}

/// The straight pieces of a line of two or three nodes; the third lies in the middle.
fn pieces(nodes: &[usize]) -> Vec<[usize; 2]> {
    match *nodes {
        [a, b, middle] => vec![[a, middle], [middle, b]],
        [a, b] => vec![[a, b]],
        _ => Vec::new(),
    }
}

/// The nodes of pieces that make one open line: from the end that the pieces name first. None for a fork, a ring, or several
/// lines.
fn chain(pieces: &[[usize; 2]]) -> Option<Vec<usize>> {
    let mut neighbours: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for [a, b] in pieces {
        neighbours.entry(*a).or_default().push(*b);
        neighbours.entry(*b).or_default().push(*a);
    }
    let is_end = |node: &usize| neighbours.get(node).is_some_and(|others| others.len() == 1);
    let start = *pieces.iter().flatten().find(|node| is_end(node))?;
    let mut along = vec![start];
    let (mut before, mut here) = (None, start);
    while let Some(next) = neighbours.get(&here)?.iter().find(|node| Some(**node) != before) {
        (before, here) = (Some(here), *next);
        along.push(here);
        if along.len() > neighbours.len() {
            return None;
        }
    }
    (along.len() == neighbours.len()).then_some(along)
}

/// The nodes of an element of the plane so that they turn to the left.
fn to_the_left(kind: ElementKind, nodes: Vec<usize>, places: &[(usize, [f64; 3])]) -> Vec<usize> {
    let turned: &[usize] = match kind {
        ElementKind::Quad4 => &[0, 3, 2, 1],
        ElementKind::Quad8 => &[0, 3, 2, 1, 7, 6, 5, 4],
        ElementKind::Triangle6 => &[0, 2, 1, 5, 4, 3],
        ElementKind::Hexahedron8 | ElementKind::Hexahedron20 | ElementKind::Tetrahedron10 => return nodes,
    };
    let corners = if kind == ElementKind::Triangle6 { 3 } else { 4 };
    let place = |k: usize| places[nodes[k % corners]].1;
    let cross = |k: usize| place(k)[0] * place(k + 1)[1] - place(k + 1)[0] * place(k)[1];
    let twice_the_area: f64 = (0..corners).map(cross).sum();
    if twice_the_area < 0.0 { turned.iter().map(|k| nodes[*k]).collect() } else { nodes }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pieces_of_one_line_are_put_in_order() {
        assert_eq!(chain(&[[3, 7], [5, 3], [7, 9]]), Some(vec![5, 3, 7, 9]));
        assert_eq!(chain(&[[1, 2], [2, 3], [3, 1]]), None);
        assert_eq!(chain(&[[1, 2], [2, 3], [2, 4]]), None);
        assert_eq!(chain(&[[1, 2], [3, 4]]), None);
        assert_eq!(chain(&[]), None);
    }

    #[test]
    fn elements_of_the_plane_are_turned_to_the_left() {
        let places = [[0.0, 0.0], [0.0, 1.0], [1.0, 0.0], [0.0, 0.5], [0.5, 0.5], [0.5, 0.0]];
        let places = places.map(|[x, y]| (0, [x, y, 0.0]));
        let turned = to_the_left(ElementKind::Triangle6, vec![0, 1, 2, 3, 4, 5], &places);
        assert_eq!(turned, [0, 2, 1, 5, 4, 3]);
        assert_eq!(to_the_left(ElementKind::Triangle6, turned.clone(), &places), turned);
    }
}
