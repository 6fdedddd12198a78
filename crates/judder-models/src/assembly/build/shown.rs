//! All bodies as one, for pictures and files.

use super::BuiltBody;
use crate::error::ModelError;
use crate::structure::build::{StructureLayout, mesh_lines};
use judder_store::{Dataset, Variable};
use judder_structure::freedom::Direction;
use judder_structure::mesh::{Mesh, MeshBlock};
use std::collections::BTreeMap;

/// The points, lines and elements of all bodies.
pub(crate) struct ShownBodies {
    pub(crate) layout: StructureLayout,
    pub(crate) mesh: Mesh,
    /// Where the points of each body begin.
    pub(crate) first_point: Vec<usize>,
    /// The name of the body to which each point belongs.
    body: Vec<String>,
    /// How the bodies are meshed: pairs of points.
    mesh_lines: Vec<[usize; 2]>,
}

impl ShownBodies {
    /// The bodies one after the other; points are numbered anew, from one on.
    pub(crate) fn new(bodies: &[BuiltBody]) -> Self {
        let mut layout = StructureLayout {
            points: Vec::new(),
            names: Vec::new(),
            freedoms: Vec::new(),
            lines: Vec::new(),
            sets: BTreeMap::new(),
        };
        let (mut mesh, mut first_point) = (Mesh::default(), Vec::new());
        let (mut names, mut sides) = (Vec::new(), Vec::new());
        for body in bodies {
            let first = layout.points.len();
            first_point.push(first);
            let Some(own) = &body.structure.layout else { continue };
            layout.points.extend(&own.points);
            names.extend(own.points.iter().map(|_| body.name.clone()));
            let moved = |freedom: Option<usize>| freedom.map(|freedom| body.first_freedom + freedom);
            layout.freedoms.extend(own.freedoms.iter().map(|freedoms| freedoms.map(moved)));
            layout.lines.extend(own.lines.iter().map(|line| line.map(|point| first + point)));
            let own_sides = body.structure.mesh().into_iter().flat_map(mesh_lines);
            sides.extend(own_sides.map(|line| line.map(|point| first + point)));
            let blocks = body.structure.mesh().into_iter().flat_map(|mesh| &mesh.blocks);
            mesh.blocks.extend(blocks.map(|block| MeshBlock {
                connectivity: block.connectivity.iter().map(|node| first + node).collect(),
                ..block.clone()
            }));
        }
        layout.names = (1..=layout.points.len()).collect();
        mesh.nodes.clone_from(&layout.points);
        Self { layout, mesh, first_point, body: names, mesh_lines: sides }
    }

    /// Which points are of which body and how the bodies are meshed, beside the places in a dataset.
    pub(crate) fn with_bodies(self, dataset: Dataset) -> Result<Dataset, ModelError> {
        let body = Variable::new("body", &["point"], &[self.body.len()], self.body);
        let sides: Vec<i64> = self.mesh_lines.iter().flatten().map(|point| *point as i64).collect();
        let mesh =
            Variable::new("mesh_line", &["mesh_line_number", "line_end"], &[self.mesh_lines.len(), 2], sides);
        let dataset = dataset.with(body.long_name("body to which the node belongs"))?;
        Ok(dataset.with(mesh.long_name("sides of elements that are seen, as indices of points"))?)
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
