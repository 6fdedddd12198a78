//! Assemblies that several tests march.

pub(crate) mod block;

use faer::sparse::Triplet;
use judder_assembly::assembly::{Assembly, from_triplets};
use judder_assembly::contact_point::ContactPoint;
use judder_assembly::friction::Friction;
use judder_assembly::interface::{Interface, InterfaceLaw};
use judder_assembly::row::Row;
use judder_nonsmooth::gauss_seidel::ContactAccuracy;
use judder_nonsmooth::march::NonsmoothSettings;
use judder_nonsmooth::scheme::ContactScheme;
use judder_structure::assembly::Sparse;
use std::sync::Arc;

pub(crate) const IMPLICIT: ContactScheme = ContactScheme::MoreauJean { restitution: 0.0, implicitness: 0.5 };

/// The implicit scheme without restitution.
pub(crate) fn implicit(implicitness: f64) -> ContactScheme {
    ContactScheme::MoreauJean { restitution: 0.0, implicitness }
}

pub(crate) fn diagonal(values: &[f64]) -> Sparse {
    let entries: Vec<_> = values.iter().enumerate().map(|(k, value)| Triplet::new(k, k, *value)).collect();
    from_triplets(values.len(), values.len(), &entries).unwrap()
}

pub(crate) fn dense(rows: &[Vec<f64>]) -> Sparse {
    let entries: Vec<_> = rows
        .iter()
        .enumerate()
        .flat_map(|(i, row)| row.iter().enumerate().map(move |(j, value)| Triplet::new(i, j, *value)))
        .collect();
    from_triplets(rows.len(), rows.len(), &entries).unwrap()
}

/// A point of the slider at freedoms of its own, along x and y or x, y and z, on a rigid plane that moves along x; its normal is y.
pub(crate) fn point_on_plane(freedoms: &[usize], speed: f64, gap: f64) -> ContactPoint {
    let row = |k: usize| Row::new(freedoms.get(k).map(|freedom| (*freedom, 1.0)).into_iter().collect());
    ContactPoint {
        place: [0.0; 3],
        normal: [0.0, 1.0, 0.0],
        velocity: [speed, 0.0, 0.0],
        rest_direction: None,
        area: 1.0,
        gap,
        relative: [0, 1, 2].map(row),
        convected: None,
        foot: None,
    }
}

pub(crate) fn assembly(
    [mass, damping, stiffness]: [Sparse; 3],
    load: Vec<f64>,
    points: Vec<ContactPoint>,
    law: InterfaceLaw,
) -> Assembly {
    let [mass, damping, stiffness] = [mass, damping, stiffness].map(Arc::new);
    let interfaces = vec![Interface { name: "sole".to_owned(), points, law, all_closed: false }];
    Assembly { mass, damping, stiffness, gyroscopic: Vec::new(), load, interfaces }
}

pub(crate) fn coulomb(coefficient: f64) -> InterfaceLaw {
    InterfaceLaw::Rigid(Friction::Constant(coefficient))
}

/// A mass with freedoms along x and y on the plane, a spring along x, pressed by a force.
pub(crate) fn mass_on_plane(mass: f64, spring: f64, force: [f64; 2], friction: f64, speed: f64) -> Assembly {
    assembly(
        [diagonal(&[mass; 2]), diagonal(&[0.0; 2]), diagonal(&[spring, 0.0])],
        force.to_vec(),
        vec![point_on_plane(&[0, 1], speed, 0.0)],
        coulomb(friction),
    )
}

pub(crate) fn settings(scheme: ContactScheme, step: f64) -> NonsmoothSettings {
    NonsmoothSettings { scheme, step, accuracy: ContactAccuracy::default(), cut_off: None }
}
