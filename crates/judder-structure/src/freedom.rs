//! Degrees of freedom: which displacements are free, which are one, which are held.

use crate::StructureError;
pub use crate::direction::Direction;
use crate::mesh::Mesh;

/// A degree of freedom.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Freedom {
    /// The node; of tied ones the first.
    pub node: usize,
    /// Its direction.
    pub direction: Direction,
    /// Where the node lies, in m.
    pub place: [f64; 3],
}

/// What holds a structure.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Supports {
    /// Displacements that are zero.
    pub fixed: Vec<(usize, Direction)>,
    /// Nodes that move as one in a direction.
    pub tied: Vec<(Vec<usize>, Direction)>,
}

/// The degrees of freedom of a mesh, numbered by node and then by direction.
#[derive(Debug, Clone, PartialEq)]
pub struct Numbering {
    dimension: usize,
    numbers: Vec<Option<usize>>,
    freedoms: Vec<Freedom>,
}

/// What a displacement is before it has a number.
#[derive(Clone, Copy, PartialEq)]
enum FreedomRole {
    Free,
    Fixed,
    Tied(usize),
}

impl Numbering {
    /// The degrees of freedom that supports leave to a mesh in two or three dimensions.
    ///
    /// # Errors
    /// [`StructureError::UnknownFreedom`] for a node or direction that is not there, [`StructureError::TwiceSupported`] for a
    /// displacement that is held or tied twice.
    pub fn new(mesh: &Mesh, dimension: usize, supports: &Supports) -> Result<Self, StructureError> {
        let roles = roles(mesh, dimension, supports)?;
        let mut of_ties = vec![None; supports.tied.len()];
        let (mut numbers, mut freedoms) = (Vec::with_capacity(roles.len()), Vec::new());
        for (k, role) in roles.iter().enumerate() {
            let (node, direction) = (k / dimension, Direction::ALL[k % dimension]);
            let mut next = || {
                freedoms.push(Freedom { node, direction, place: mesh.nodes[node] });
                freedoms.len() - 1
            };
            numbers.push(match role {
                FreedomRole::Fixed => None,
                FreedomRole::Free => Some(next()),
                FreedomRole::Tied(tie) => Some(*of_ties[*tie].get_or_insert_with(next)),
            });
        }
        Ok(Self { dimension, numbers, freedoms })
    }

    /// 2 in the plane, 3 in space.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// The degrees of freedom in their order.
    #[must_use]
    pub fn freedoms(&self) -> &[Freedom] {
        &self.freedoms
    }

    /// The number of a displacement; `None` where it is held or not there.
    #[must_use]
    pub fn number(&self, node: usize, direction: Direction) -> Option<usize> {
        let along = direction as usize;
        let place = (along < self.dimension).then_some(node * self.dimension + along)?;
        self.numbers.get(place).copied().flatten()
    }

    /// The numbers of an element's displacements, in the order of its matrices.
    pub(crate) fn of_element<'a>(&'a self, nodes: &'a [usize]) -> impl Iterator<Item = Option<usize>> + 'a {
        nodes.iter().flat_map(|node| self.numbers[node * self.dimension..][..self.dimension].iter().copied())
    }
}

fn roles(mesh: &Mesh, dimension: usize, supports: &Supports) -> Result<Vec<FreedomRole>, StructureError> {
    let mut roles = vec![FreedomRole::Free; mesh.nodes.len() * dimension];
    let mut give = |node: usize, direction: Direction, role: FreedomRole| {
        let along = direction as usize;
        if node >= mesh.nodes.len() || along >= dimension {
            return Err(StructureError::UnknownFreedom {
                node,
                direction,
                nodes: mesh.nodes.len(),
                dimension,
            });
        }
        let place = &mut roles[node * dimension + along];
        // to hold twice is to hold
        if *place != FreedomRole::Free && *place != role {
            return Err(StructureError::TwiceSupported { node, direction });
        }
        *place = role;
        Ok(())
    };
    for (node, direction) in &supports.fixed {
        give(*node, *direction, FreedomRole::Fixed)?;
    }
    for (tie, (nodes, direction)) in supports.tied.iter().enumerate() {
        for node in nodes {
            give(*node, *direction, FreedomRole::Tied(tie))?;
        }
    }
    Ok(roles)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn three_nodes() -> Mesh {
        Mesh { nodes: vec![[0.0; 3], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]], ..Mesh::default() }
    }

    #[test]
    fn held_displacements_have_no_number_and_tied_ones_share_one() {
        let supports = Supports {
            fixed: vec![(0, Direction::X), (0, Direction::X)],
            tied: vec![(vec![0, 2], Direction::Y)],
        };
        let numbering = Numbering::new(&three_nodes(), 2, &supports).unwrap();
        assert_eq!(numbering.number(0, Direction::X), None);
        assert_eq!(numbering.number(0, Direction::Y), numbering.number(2, Direction::Y));
        assert_eq!(numbering.freedoms().len(), 4);
        assert_eq!(numbering.number(1, Direction::Z), None);
        assert_eq!(numbering.number(9, Direction::X), None);
    }

    #[test]
    fn what_is_not_there_or_held_and_tied_is_refused() {
        let mesh = three_nodes();
        let unknown = Supports { fixed: vec![(3, Direction::X)], ..Supports::default() };
        assert!(matches!(
            Numbering::new(&mesh, 2, &unknown),
            Err(StructureError::UnknownFreedom { node: 3, .. })
        ));
        let beyond = Supports { fixed: vec![(0, Direction::Z)], ..Supports::default() };
        assert!(matches!(Numbering::new(&mesh, 2, &beyond), Err(StructureError::UnknownFreedom { .. })));
        let both = Supports { fixed: vec![(1, Direction::X)], tied: vec![(vec![0, 1], Direction::X)] };
        assert!(matches!(
            Numbering::new(&mesh, 2, &both),
            Err(StructureError::TwiceSupported { node: 1, .. })
        ));
    }
}
