//! All bodies as one, for pictures and files.

use super::BuiltBody;
use crate::structure::build::Layout;
use judder_structure::freedom::Direction;
use judder_structure::mesh::{Mesh, MeshBlock};
use std::collections::BTreeMap;

/// The points, lines and elements of all bodies.
pub(crate) struct Shown {
    pub(crate) layout: Layout,
    pub(crate) mesh: Mesh,
    /// Where the points of each body begin.
    pub(crate) first_point: Vec<usize>,
}

impl Shown {
    /// The bodies one after the other; points are numbered anew, from one on.
    pub(crate) fn new(bodies: &[BuiltBody]) -> Self {
        let mut layout = Layout {
            points: Vec::new(),
            names: Vec::new(),
            freedoms: Vec::new(),
            lines: Vec::new(),
            sets: BTreeMap::new(),
        };
        let (mut mesh, mut first_point) = (Mesh::default(), Vec::new());
        for body in bodies {
            let first = layout.points.len();
            first_point.push(first);
            let Some(own) = &body.structure.layout else { continue };
            layout.points.extend(&own.points);
            let moved = |freedom: Option<usize>| freedom.map(|freedom| body.first_freedom + freedom);
            layout.freedoms.extend(own.freedoms.iter().map(|freedoms| freedoms.map(moved)));
            layout.lines.extend(own.lines.iter().map(|line| line.map(|point| first + point)));
            let blocks = body.structure.mesh().into_iter().flat_map(|mesh| &mesh.blocks);
            mesh.blocks.extend(blocks.map(|block| MeshBlock {
                connectivity: block.connectivity.iter().map(|node| first + node).collect(),
                ..block.clone()
            }));
        }
        layout.names = (1..=layout.points.len()).collect();
        mesh.nodes.clone_from(&layout.points);
        Self { layout, mesh, first_point }
    }

    /// Held displacements that loads impose, by point.
    pub(crate) fn imposed<'a>(
        &'a self,
        bodies: &'a [BuiltBody],
    ) -> impl Iterator<Item = ((usize, Direction), f64)> + 'a {
        let of_body = |(first, body): (&'a usize, &'a BuiltBody)| {
            body.imposed.iter().map(move |((point, direction), by)| ((first + point, *direction), *by))
        };
        self.first_point.iter().zip(bodies).flat_map(of_body)
    }
}
