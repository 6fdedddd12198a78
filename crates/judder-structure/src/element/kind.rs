//! The shapes of elements, with their nodes and sides.

use std::fmt;

/// The shape of an element; its nodes stand in the order of VTK and Abaqus: corners first, then the middles of edges.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[cfg_attr(feature = "keys", derive(judder_keys::Choice), choice(what = "element", list = WORDS))]
pub enum ElementKind {
    /// Four-node quadrilateral with incompatible modes.
    Quad4,
    /// Eight-node serendipity quadrilateral.
    Quad8,
    /// Six-node triangle.
    Triangle6,
    /// Eight-node brick with incompatible modes.
    Hexahedron8,
    /// Twenty-node serendipity brick.
    Hexahedron20,
    /// Ten-node tetrahedron.
    Tetrahedron10,
}

/// What the shape functions of a kind are made of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum ShapeFamily {
    /// Products of linear functions on [−1, 1]ᵈ.
    Linear,
    /// Quadratic on [−1, 1]ᵈ, without nodes inside faces.
    Serendipity,
    /// Quadratic on the simplex.
    Simplex,
}

const O: f64 = 0.0;
const M: f64 = -1.0;
const P: f64 = 1.0;
const H: f64 = 0.5;

const SQUARE: [[f64; 3]; 8] =
    [[M, M, O], [P, M, O], [P, P, O], [M, P, O], [O, M, O], [P, O, O], [O, P, O], [M, O, O]];
const CUBE: [[f64; 3]; 20] = [
    [M, M, M],
    [P, M, M],
    [P, P, M],
    [M, P, M],
    [M, M, P],
    [P, M, P],
    [P, P, P],
    [M, P, P],
    [O, M, M],
    [P, O, M],
    [O, P, M],
    [M, O, M],
    [O, M, P],
    [P, O, P],
    [O, P, P],
    [M, O, P],
    [M, M, O],
    [P, M, O],
    [P, P, O],
    [M, P, O],
];
const TRIANGLE: [[f64; 3]; 6] = [[O, O, O], [P, O, O], [O, P, O], [H, O, O], [H, H, O], [O, H, O]];
const TETRAHEDRON: [[f64; 3]; 10] = [
    [O, O, O],
    [P, O, O],
    [O, P, O],
    [O, O, P],
    [H, O, O],
    [H, H, O],
    [O, H, O],
    [O, O, H],
    [H, O, H],
    [O, H, H],
];

impl ElementKind {
    /// All of them.
    pub const ALL: [Self; 6] = [
        Self::Quad4,
        Self::Quad8,
        Self::Triangle6,
        Self::Hexahedron8,
        Self::Hexahedron20,
        Self::Tetrahedron10,
    ];

    /// Nodes of an element.
    #[must_use]
    pub fn nodes(self) -> usize {
        self.node_places().len()
    }

    /// 2 in the plane, 3 in space.
    #[must_use]
    pub fn dimension(self) -> usize {
        match self {
            Self::Quad4 | Self::Quad8 | Self::Triangle6 => 2,
            Self::Hexahedron8 | Self::Hexahedron20 | Self::Tetrahedron10 => 3,
        }
    }

    /// Where the nodes lie in the element's own coordinates: [−1, 1]ᵈ, or the simplex with its corners at the origin and the
    /// unit vectors.
    #[must_use]
    pub fn node_places(self) -> &'static [[f64; 3]] {
        match self {
            Self::Quad4 => &SQUARE[..4],
            Self::Quad8 => &SQUARE,
            Self::Triangle6 => &TRIANGLE,
            Self::Hexahedron8 => &CUBE[..8],
            Self::Hexahedron20 => &CUBE,
            Self::Tetrahedron10 => &TETRAHEDRON,
        }
    }

    /// The nodes of each side (edges in the plane, faces in space), corners first; seen from outside they turn to the left.
    #[must_use]
    pub fn sides(self) -> &'static [&'static [usize]] {
        match self {
            Self::Quad4 => &[&[0, 1], &[1, 2], &[2, 3], &[3, 0]],
            Self::Quad8 => &[&[0, 1, 4], &[1, 2, 5], &[2, 3, 6], &[3, 0, 7]],
            Self::Triangle6 => &[&[0, 1, 3], &[1, 2, 4], &[2, 0, 5]],
            Self::Hexahedron8 => {
                &[&[0, 3, 2, 1], &[4, 5, 6, 7], &[0, 1, 5, 4], &[1, 2, 6, 5], &[2, 3, 7, 6], &[3, 0, 4, 7]]
            }
            Self::Hexahedron20 => &[
                &[0, 3, 2, 1, 11, 10, 9, 8],
                &[4, 5, 6, 7, 12, 13, 14, 15],
                &[0, 1, 5, 4, 8, 17, 12, 16],
                &[1, 2, 6, 5, 9, 18, 13, 17],
                &[2, 3, 7, 6, 10, 19, 14, 18],
                &[3, 0, 4, 7, 11, 16, 15, 19],
            ],
            Self::Tetrahedron10 => {
                &[&[0, 2, 1, 6, 5, 4], &[0, 1, 3, 4, 8, 7], &[1, 2, 3, 5, 9, 8], &[2, 0, 3, 6, 7, 9]]
            }
        }
    }

    /// Whether displacements −½(1 − ξₖ²) of its own, which no neighbour shares, let it bend without locking.
    #[must_use]
    pub fn has_incompatible_modes(self) -> bool {
        self.family() == ShapeFamily::Linear
    }

    pub(super) fn family(self) -> ShapeFamily {
        match self {
            Self::Quad4 | Self::Hexahedron8 => ShapeFamily::Linear,
            Self::Quad8 | Self::Hexahedron20 => ShapeFamily::Serendipity,
            Self::Triangle6 | Self::Tetrahedron10 => ShapeFamily::Simplex,
        }
    }
}

impl fmt::Display for ElementKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Quad4 => "four-node quadrilateral",
            Self::Quad8 => "eight-node quadrilateral",
            Self::Triangle6 => "six-node triangle",
            Self::Hexahedron8 => "eight-node brick",
            Self::Hexahedron20 => "twenty-node brick",
            Self::Tetrahedron10 => "ten-node tetrahedron",
        })
    }
}
