//! A disc or ring of bricks about the z-axis: brake discs, wheels, seals, without a mesh file.

use crate::StructureError;
use crate::element::ElementKind;
use crate::mesh::{Mesh, MeshBlock};
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// A ring between two radii, from z = 0 up, whose cells hold one brick each.
#[derive(Debug, Clone, PartialEq)]
pub struct Disc {
    /// Eight-node or twenty-node bricks; the nodes between the corners of the latter lie on the circles.
    pub kind: ElementKind,
    /// Where cells meet along the radius, ascending from above zero, in m.
    pub radii: Vec<f64>,
    /// Where they meet around the axis, ascending by less than a turn, in rad; from the last the ring closes to the first.
    pub angles: Vec<f64>,
    /// In m.
    pub thickness: f64,
    /// Cells through the thickness.
    pub layers: usize,
}

impl Disc {
    /// A ring of even cells: along the radius, around the axis, through the thickness.
    #[must_use]
    pub fn even(kind: ElementKind, radii: [f64; 2], thickness: f64, cells: [usize; 3]) -> Self {
        let around = cells[1].max(1);
        let angles = (0..around).map(|k| TAU * k as f64 / around as f64).collect();
        Self { kind, radii: steps(radii, cells[0].max(1)), angles, thickness, layers: cells[2] }
    }

    /// The mesh, with its nodes moved by `place`.
    ///
    /// Node sets: `r-min`, `r-max`, the inner and outer surface, `z-min`, `z-max`, the faces across the axis.
    ///
    /// # Errors
    /// [`StructureError::NoDisc`] for other elements than bricks and fewer than three cells around the axis, [`StructureError::InvalidNumber`] for radii
    /// that are not positive or do not ascend, and for what else is out of its range.
    pub fn mesh(&self, material: &str, place: impl Fn([f64; 3]) -> [f64; 3]) -> Result<Mesh, StructureError> {
        self.check()?;
        let lattice = Lattice::new(self);
        let nodes = lattice.steps.iter().map(|step| place(self.place(*step))).collect();
        let [rings, around, layers] = [self.radii.len() - 1, self.angles.len(), self.layers];
        let mut connectivity = Vec::new();
        for (layer, sector, ring) in
            (0..layers).flat_map(|l| (0..around).flat_map(move |s| (0..rings).map(move |r| (l, s, r))))
        {
            let corner = [2 * ring, 2 * sector, 2 * layer];
            connectivity.extend(self.kind.node_places().iter().map(|own| lattice.number(corner, own)));
        }
        let last = [2 * rings, 2 * layers];
        let on = |axis: usize, end: usize| -> Vec<usize> {
            (0..lattice.steps.len()).filter(|node| lattice.steps[*node][axis] == end).collect()
        };
        let node_sets = BTreeMap::from([
            ("r-min".to_owned(), on(0, 0)),
            ("r-max".to_owned(), on(0, last[0])),
            ("z-min".to_owned(), on(2, 0)),
            ("z-max".to_owned(), on(2, last[1])),
        ]);
        let blocks = vec![MeshBlock { kind: self.kind, material: material.to_owned(), connectivity }];
        Ok(Mesh { nodes, blocks, node_sets, ..Mesh::default() })
    }

    fn check(&self) -> Result<(), StructureError> {
        if !matches!(self.kind, ElementKind::Hexahedron8 | ElementKind::Hexahedron20) {
            return Err(StructureError::NoDisc { what: "its elements must be bricks" });
        }
        if self.angles.len() < 3 {
            return Err(StructureError::NoDisc { what: "it needs three cells around its axis, or more" });
        }
        if self.radii.len() < 2 || self.layers == 0 {
            return Err(StructureError::NoDisc {
                what: "it needs a cell along the radius and one through its thickness",
            });
        }
        let invalid =
            |name, value, requirement| Err(StructureError::InvalidNumber { name, value, requirement });
        let is_positive = |value: &f64| value.is_finite() && *value > 0.0;
        if let Some(radius) = self.radii.iter().find(|radius| !is_positive(radius)) {
            return invalid("a radius of a disc", *radius, "positive: a disc has a hole");
        }
        if !is_positive(&self.thickness) {
            return invalid("the thickness of a disc", self.thickness, "positive");
        }
        for (name, values) in [("a radius of a disc", &self.radii), ("an angle of a disc", &self.angles)] {
            // so too where one is not a number
            let rises = |pair: &&[f64]| pair[1] > pair[0];
            if let Some(pair) = values.windows(2).find(|pair| !rises(pair)) {
                return invalid(name, pair[1], "above the one before");
            }
        }
        let turn = self.angles[self.angles.len() - 1] - self.angles[0];
        if turn.is_nan() || turn >= TAU {
            return invalid("the last angle of a disc", turn, "less than a turn above the first");
        }
        Ok(())
    }

    /// Where a step of the lattice lies: even numbers are corners, odd ones half-way between.
    fn place(&self, [ring, sector, layer]: [usize; 3]) -> [f64; 3] {
        let middle =
            |from: f64, to: f64, step: usize| if step.is_multiple_of(2) { from } else { 0.5 * (from + to) };
        let radius = middle(self.radii[ring / 2], self.radii[ring.div_ceil(2)], ring);
        let next = match self.angles.get(sector.div_ceil(2)) {
            Some(angle) => *angle,
            None => self.angles[0] + TAU,
        };
        let (sine, cosine) = libm::sincos(middle(self.angles[sector / 2], next, sector));
        let height = 0.5 * self.thickness * layer as f64 / self.layers as f64;
        [radius * cosine, radius * sine, height]
    }
}

/// Even steps from one number to another.
#[must_use]
pub fn steps([from, to]: [f64; 2], count: usize) -> Vec<f64> {
    // the last is exact
    (0..=count).map(|k| if k == count { to } else { from + (to - from) * k as f64 / count as f64 }).collect()
}

/// The nodes of a ring: places half a cell apart of which elements have some.
struct Lattice {
    /// Half cells along the radius, around the axis and upwards, of each node.
    steps: Vec<[usize; 3]>,
    /// The node at each place of the lattice.
    numbers: BTreeMap<[usize; 3], usize>,
    around: usize,
}

impl Lattice {
    fn new(disc: &Disc) -> Self {
        let around = 2 * disc.angles.len();
        let [rings, layers] = [2 * (disc.radii.len() - 1), 2 * disc.layers];
        let is_quadratic = disc.kind == ElementKind::Hexahedron20;
        let is_node = |step: &[usize; 3]| {
            let between = step.iter().filter(|k| *k % 2 == 1).count();
            between == 0 || (is_quadratic && between == 1)
        };
        let steps: Vec<[usize; 3]> = (0..=layers)
            .flat_map(|l| (0..around).flat_map(move |s| (0..=rings).map(move |r| [r, s, l])))
            .filter(is_node)
            .collect();
        let numbers = steps.iter().enumerate().map(|(node, step)| (*step, node)).collect();
        Self { steps, numbers, around }
    }

    /// The node of an element, whose first corner this is, at a place of its own coordinates.
    fn number(&self, corner: [usize; 3], own: &[f64; 3]) -> usize {
        // −1, 0 and 1 are no, one and two half cells
        let [r, s, l]: [usize; 3] = std::array::from_fn(|k| corner[k] + (own[k] + 1.0) as usize);
        self.numbers[&[r, s % self.around, l]]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::assembly::inertia_load;
    use crate::freedom::{Numbering, Supports};
    use crate::material::{Elastic, ElementSection};

    fn volume(disc: &Disc) -> f64 {
        let mesh = disc.mesh("m", |place| place).unwrap();
        mesh.check().unwrap();
        let materials =
            BTreeMap::from([("m".to_owned(), (Elastic::new(1e9, 0.3, 1.0).unwrap(), ElementSection::Solid))]);
        let numbering = Numbering::new(&mesh, 3, &Supports::default()).unwrap();
        inertia_load(&mesh, &materials, &numbering, [1.0, 0.0, 0.0]).unwrap().iter().sum()
    }

    #[test]
    fn rings_close_and_have_their_volume_and_surfaces() {
        let exact = 0.5 * TAU * (0.09 - 0.01) * 0.02;
        for (kind, nodes, inner, top, off) in [
            (ElementKind::Hexahedron8, 3 * 24 * 3, 24 * 3, 3 * 24, 0.012),
            (
                ElementKind::Hexahedron20,
                24 * (3 * 3 + 2 * 3 + 3 * 3 + 3 * 2),
                24 * (3 + 3 + 2),
                24 * (3 + 2 + 3),
                2e-5,
            ),
        ] {
            let disc = Disc::even(kind, [0.1, 0.3], 0.02, [2, 24, 2]);
            let mesh = disc.mesh("m", |place| place).unwrap();
            assert_eq!((mesh.nodes.len(), mesh.elements()), (nodes, 2 * 24 * 2), "{kind}");
            assert_eq!(
                (mesh.node_sets["r-min"].len(), mesh.node_sets["z-max"].len()),
                (inner, top),
                "{kind}"
            );
            let radius = |node: &usize| mesh.nodes[*node][0].hypot(mesh.nodes[*node][1]);
            assert!(mesh.node_sets["r-max"].iter().all(|node| (radius(node) - 0.3).abs() < 1e-15));
            assert!((volume(&disc) / exact - 1.0).abs() < off, "{kind}: {}", volume(&disc) / exact);
        }
    }

    #[test]
    fn cells_that_are_not_even_close_too() {
        let disc = Disc {
            radii: vec![0.1, 0.2, 0.22, 0.3],
            angles: vec![-0.3, 0.0, 0.3, 1.0, 2.0, 3.0, 4.0, 5.0],
            ..Disc::even(ElementKind::Hexahedron20, [0.1, 0.3], 0.02, [1, 3, 1])
        };
        assert!((volume(&disc) / (0.5 * TAU * 0.08 * 0.02) - 1.0).abs() < 0.02);
    }

    #[test]
    fn what_is_no_disc_is_refused() {
        let refused = |disc: Disc| disc.mesh("m", |place| place).unwrap_err().to_string();
        let ring = || Disc::even(ElementKind::Hexahedron8, [0.1, 0.3], 0.02, [2, 24, 2]);
        assert!(refused(Disc { kind: ElementKind::Quad4, ..ring() }).contains("bricks"));
        assert!(refused(Disc { radii: vec![0.0, 0.3], ..ring() }).contains("a disc has a hole"));
        assert!(refused(Disc { radii: vec![0.3, 0.1], ..ring() }).contains("above the one before"));
        assert!(refused(Disc { angles: vec![0.0, 1.0, 7.0], ..ring() }).contains("less than a turn"));
        assert!(refused(Disc { angles: vec![0.0, 1.0], ..ring() }).contains("three cells"));
        assert!(refused(Disc { layers: 0, ..ring() }).contains("through its thickness"));
    }
}
