//! The faces of sliders between their contact points, and the nodes that have no partner.

use crate::assembly::AssemblySubject;
use crate::assembly::case::contact::ContactInterface;
use crate::error::ModelError;
use crate::structure::build::points_of;
use judder_assembly::surface::Surface;
use judder_store::{Dataset, Variable};
use std::collections::BTreeMap;

/// Corners of a face in space.
pub(super) const CORNERS: usize = 4;

/// What lies between contact points.
#[derive(Default)]
struct SliderFaces {
    /// Corners by the numbers of contact points, after them those of nodes without a partner.
    faces: Vec<[i64; CORNERS]>,
    /// The contact of each node without a partner, and its place in m.
    lone: Vec<(String, [f64; 3])>,
}

/// Faces in space and nodes without a partner as arrays, where there are some.
pub(super) fn with_faces(dataset: Dataset, of: &AssemblySubject<'_>) -> Result<Dataset, ModelError> {
    let points: usize = of.built.nodes.iter().map(Vec::len).sum();
    let (mut found, mut first) = (SliderFaces::default(), 0);
    for (contact, nodes) in of.case.contacts.iter().zip(&of.built.nodes) {
        found.add(of, contact, nodes, first, points);
        first += nodes.len();
    }
    let SliderFaces { faces, lone } = found;
    let mut dataset = dataset;
    if !faces.is_empty() {
        let corners: Vec<i64> = faces.iter().flatten().copied().collect();
        dataset = dataset.with(
            Variable::new("face", &["contact_face", "corner"], &[faces.len(), CORNERS], corners)
                .long_name("corners of the slider's faces, as indices of contact points, then of nodes without a partner"),
        )?;
    }
    if !lone.is_empty() {
        let places: Vec<f64> = lone.iter().flat_map(|(_, place)| *place).collect();
        let contacts: Vec<String> = lone.iter().map(|(contact, _)| contact.clone()).collect();
        dataset = dataset
            .with(
                Variable::new("lone_place", &["lone_node", "direction"], &[lone.len(), 3], places)
                    .units("m")
                    .long_name("place of a node of a slider that has no partner on its track"),
            )?
            .with(
                Variable::new("lone_contact", &["lone_node"], &[lone.len()], contacts)
                    .long_name("contact to which it belongs"),
            )?;
    }
    Ok(dataset)
}

impl SliderFaces {
    /// Those of one contact, whose points begin at `first` among so many of all contacts.
    fn add(
        &mut self,
        of: &AssemblySubject<'_>,
        contact: &ContactInterface,
        nodes: &[usize],
        first: usize,
        points: usize,
    ) {
        let structure = &of.built.bodies[*contact.slider.structure].structure;
        let Some(mesh) = structure.mesh() else { return };
        // found before, when the assembly was built
        let Ok(all) = points_of(&contact.slider.nodes, structure, "") else { return };
        let mut numbers: BTreeMap<usize, i64> =
            nodes.iter().enumerate().map(|(k, node)| (*node, (first + k) as i64)).collect();
        for node in &all {
            numbers.entry(*node).or_insert_with(|| {
                self.lone.push((contact.name.to_string(), mesh.nodes[*node]));
                (points + self.lone.len() - 1) as i64
            });
        }
        let Ok(surface) = Surface::of_nodes(mesh, &all) else { return };
        for face in &surface.faces {
            let corners: Option<Vec<i64>> =
                face.nodes.iter().map(|node| numbers.get(node).copied()).collect();
            let corners: Option<[i64; CORNERS]> = corners.and_then(|corners| corners.try_into().ok());
            // of a face that touches nowhere nothing is told
            self.faces.extend(corners.filter(|own| own.iter().any(|corner| *corner < points as i64)));
        }
    }
}
