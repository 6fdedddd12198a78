//! Assemblies that several tests look at.

use faer::sparse::Triplet;
use judder_assembly::assembly::Assembly;
use judder_assembly::contact_point::ContactPoint;
use judder_assembly::friction::Friction;
use judder_assembly::interface::{Interface, InterfaceLaw};
use judder_assembly::row::Row;
use judder_structure::assembly::Sparse;
use std::sync::Arc;

/// A matrix from rows of numbers.
pub(crate) fn dense(rows: &[&[f64]]) -> Sparse {
    let entries: Vec<_> = rows
        .iter()
        .enumerate()
        .flat_map(|(i, row)| row.iter().enumerate().map(move |(j, value)| Triplet::new(i, j, *value)))
        .collect();
    Sparse::try_new_from_triplets(rows.len(), rows.len(), &entries).unwrap()
}

/// A diagonal matrix.
pub(crate) fn diagonal(values: &[f64]) -> Sparse {
    let entries: Vec<_> = values.iter().enumerate().map(|(k, value)| Triplet::new(k, k, *value)).collect();
    Sparse::try_new_from_triplets(values.len(), values.len(), &entries).unwrap()
}

/// A point of the slider at freedoms of its own on a rigid plane that moves along x; its normal is y.
pub(crate) fn point_on_plane(freedoms: [Option<usize>; 3], velocity: [f64; 3]) -> ContactPoint {
    let row = |freedom: Option<usize>| Row::new(freedom.map(|freedom| (freedom, 1.0)).into_iter().collect());
    ContactPoint {
        place: [0.0; 3],
        normal: [0.0, 1.0, 0.0],
        velocity,
        rest_direction: None,
        area: 1.0,
        gap: 0.0,
        relative: freedoms.map(row),
        convected: None,
        foot: None,
    }
}

/// One interface of rigid points with one friction coefficient.
pub(crate) fn rigid(points: Vec<ContactPoint>, friction: f64) -> Interface {
    Interface {
        name: "sole".to_owned(),
        points,
        law: InterfaceLaw::Rigid(Friction::Constant(friction)),
        all_closed: false,
    }
}

/// A structure without damping.
pub(crate) fn undamped(
    mass: Sparse,
    stiffness: Sparse,
    load: Vec<f64>,
    interfaces: Vec<Interface>,
) -> Assembly {
    let none = Sparse::try_new_from_triplets(load.len(), load.len(), &[]).unwrap();
    let [mass, damping, stiffness] = [mass, none, stiffness].map(Arc::new);
    Assembly { mass, damping, stiffness, gyroscopic: Vec::new(), load, interfaces }
}
