//! A straight beam as a mesh of eight-node quadrilaterals: the structures of the beams paper.

use crate::StructureError;
use crate::element::ElementKind;
use crate::mesh::{ElementSide, Mesh, MeshBlock};
use std::collections::BTreeMap;

/// A straight beam in the plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Beam {
    /// From end to end, in m.
    pub length: f64,
    /// In its plane, in m.
    pub thickness: f64,
    /// Elements along and across.
    pub elements: [usize; 2],
    /// Where the middle of its start lies, in m.
    pub origin: [f64; 2],
    /// From the x-axis to its own axis, counter-clockwise, in rad.
    pub angle: f64,
}

impl Beam {
    /// The mesh, all of one `material`.
    ///
    /// Node sets: `start`, `end` (the end faces, upwards), `lower`, `upper` (the edges from start to end), each with the nodes in
    /// the middles of elements, and `lower-corners`, `upper-corners` without them; the corners of the beam, one node each:
    /// `start-lower`, `start-upper`, `end-lower`, `end-upper`, `start-middle`, `end-middle`. Side sets: `start`, `end`, `lower`, `upper`.
    ///
    /// # Errors
    /// [`StructureError::InvalidNumber`] for a length, thickness or number of elements that is not positive.
    pub fn mesh(&self, material: &str) -> Result<Mesh, StructureError> {
        self.check()?;
        let [along, across] = self.elements;
        let (mut nodes, mut numbers) = (Vec::new(), BTreeMap::new());
        // in half elements; there is none in the middle of an element
        for column in 0..=2 * along {
            for row in (0..=2 * across).filter(|row| column % 2 == 0 || row % 2 == 0) {
                numbers.insert((column, row), nodes.len());
                nodes.push(self.place(column, row));
            }
        }
        let mut connectivity = Vec::with_capacity(8 * along * across);
        for (column, row) in (0..along).flat_map(|c| (0..across).map(move |r| (2 * c, 2 * r))) {
            let own = [(0, 0), (2, 0), (2, 2), (0, 2), (1, 0), (2, 1), (1, 2), (0, 1)];
            connectivity.extend(own.map(|(c, r)| numbers[&(column + c, row + r)]));
        }
        let line = |columns: Vec<usize>, rows: Vec<usize>| -> Vec<usize> {
            columns.iter().flat_map(|c| rows.iter().filter_map(|r| numbers.get(&(*c, *r)).copied())).collect()
        };
        let whole = |count: usize| (0..=2 * count).collect::<Vec<_>>();
        let corners = |count: usize| (0..=2 * count).step_by(2).collect::<Vec<_>>();
        let node_sets = [
            ("start", line(vec![0], whole(across))),
            ("end", line(vec![2 * along], whole(across))),
            ("lower", line(whole(along), vec![0])),
            ("upper", line(whole(along), vec![2 * across])),
            ("lower-corners", line(corners(along), vec![0])),
            ("upper-corners", line(corners(along), vec![2 * across])),
            ("start-lower", line(vec![0], vec![0])),
            ("start-upper", line(vec![0], vec![2 * across])),
            ("end-lower", line(vec![2 * along], vec![0])),
            ("end-upper", line(vec![2 * along], vec![2 * across])),
            // on the axis, where both ends have a node
            ("start-middle", line(vec![0], vec![across])),
            ("end-middle", line(vec![2 * along], vec![across])),
        ];
        let blocks =
            vec![MeshBlock { kind: ElementKind::Quad8, material: material.to_owned(), connectivity }];
        let node_sets = node_sets.map(|(name, nodes)| (name.to_owned(), nodes)).into();
        Ok(Mesh { nodes, blocks, node_sets, element_sets: BTreeMap::new(), side_sets: self.side_sets() })
    }

    fn check(&self) -> Result<(), StructureError> {
        let [along, across] = self.elements;
        let numbers = [
            ("the beam's length", self.length),
            ("the beam's thickness", self.thickness),
            ("the number of elements along the beam", along as f64),
            ("the number of elements across the beam", across as f64),
        ];
        match numbers.into_iter().find(|(_, value)| !(value.is_finite() && *value > 0.0)) {
            Some((name, value)) => {
                Err(StructureError::InvalidNumber { name, value, requirement: "positive" })
            }
            None => Ok(()),
        }
    }

    /// Where a node lies that is so many half elements from the start and from the lower edge.
    fn place(&self, column: usize, row: usize) -> [f64; 3] {
        let [along, across] = self.elements;
        let x = self.length * column as f64 / (2 * along) as f64;
        let y = self.thickness * (row as f64 / (2 * across) as f64 - 0.5);
        let (sine, cosine) = libm::sincos(self.angle);
        [self.origin[0] + cosine * x - sine * y, self.origin[1] + sine * x + cosine * y, 0.0]
    }

    fn side_sets(&self) -> BTreeMap<String, Vec<ElementSide>> {
        let [along, across] = self.elements;
        let element = |column: usize, row: usize| column * across + row;
        let sides = |side: usize, elements: Vec<usize>| -> Vec<ElementSide> {
            elements.into_iter().map(|element| ElementSide { element, side }).collect()
        };
        [
            ("lower", sides(0, (0..along).map(|c| element(c, 0)).collect())),
            ("end", sides(1, (0..across).map(|r| element(along - 1, r)).collect())),
            ("upper", sides(2, (0..along).map(|c| element(c, across - 1)).collect())),
            ("start", sides(3, (0..across).map(|r| element(0, r)).collect())),
        ]
        .map(|(name, sides)| (name.to_owned(), sides))
        .into()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn beam() -> Beam {
        Beam {
            length: 0.1,
            thickness: 0.002,
            elements: [100, 2],
            origin: [0.0, 0.0],
            angle: std::f64::consts::FRAC_PI_6,
        }
    }

    #[test]
    fn its_edges_are_ordered_and_its_corners_a_pitch_apart() {
        let mesh = beam().mesh("rubber").unwrap();
        mesh.check().unwrap();
        assert_eq!((mesh.elements(), mesh.nodes.len()), (200, 805));
        let corners = &mesh.node_sets["upper-corners"];
        assert_eq!(
            (corners.len(), mesh.node_sets["upper"].len(), mesh.node_sets["end"].len()),
            (101, 201, 5)
        );
        for pair in corners.windows(2) {
            let [a, b] = [mesh.nodes[pair[0]], mesh.nodes[pair[1]]];
            let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
            assert!((dx.hypot(dy) - 1e-3).abs() < 1e-15 && (dy.atan2(dx) - beam().angle).abs() < 1e-10);
        }
    }

    #[test]
    fn its_corners_are_the_ends_of_its_edges() {
        let sets = beam().mesh("rubber").unwrap().node_sets;
        for (edge, corners) in
            [("lower", ["start-lower", "end-lower"]), ("upper", ["start-upper", "end-upper"])]
        {
            let [first, last] = corners.map(|name| sets[name].clone());
            assert_eq!((first, last), (vec![sets[edge][0]], vec![*sets[edge].last().unwrap()]), "{edge}");
        }
    }

    #[test]
    fn its_sides_lie_on_its_edges() {
        let mesh = beam().mesh("rubber").unwrap();
        for (name, sides) in &mesh.side_sets {
            let nodes = &mesh.node_sets[name];
            for side in sides {
                let own = &mesh.blocks[0].connectivity[8 * side.element..][..8];
                assert!(
                    ElementKind::Quad8.sides()[side.side].iter().all(|k| nodes.contains(&own[*k])),
                    "{name}"
                );
            }
        }
    }

    #[test]
    fn a_beam_of_no_length_or_without_elements_is_refused() {
        for wrong in [
            Beam { length: 0.0, ..beam() },
            Beam { elements: [0, 2], ..beam() },
            Beam { thickness: f64::NAN, ..beam() },
        ] {
            assert!(matches!(wrong.mesh("rubber"), Err(StructureError::InvalidNumber { .. })));
        }
    }
}
