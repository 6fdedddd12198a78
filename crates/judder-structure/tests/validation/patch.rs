//! The patch test (B. M. Irons, 1972): a linear displacement field is exact on any mesh.

use crate::Body;
use judder_structure::element::ElementKind;
use judder_structure::freedom::{Direction, Supports};
use judder_structure::grid::Grid;
use judder_structure::material::{Elastic, ElementSection};
use judder_structure::statics::product;

/// Corners inside are moved, each another way.
fn distorted([x, y, z]: [f64; 3]) -> [f64; 3] {
    let inside = |u: f64| u > 0.01 && u < 0.99;
    let (sx, sy) = ((7.0 * x + 3.0 * y + 5.0 * z).sin(), (5.0 * x - 4.0 * y + 2.0 * z).cos());
    let shift = if inside(x) && inside(y) && (z == 0.0 || inside(z)) { 0.08 } else { 0.0 };
    [x + shift * sx, y + shift * sy, if z == 0.0 { z } else { z + shift * sx * sy }]
}

fn patch(kind: ElementKind, section: ElementSection) -> Body {
    let grid = Grid { kind, size: [1.0; 3], cells: [3; 3] };
    let material = Elastic::new(3.0, 0.3, 1.0).unwrap();
    Body { mesh: grid.mesh("any", distorted).unwrap(), material, section }
}

fn sections(kind: ElementKind) -> Vec<ElementSection> {
    match kind.dimension() {
        2 => vec![
            ElementSection::PlaneStress { thickness: 0.5 },
            ElementSection::PlaneStrain { thickness: 2.0 },
        ],
        _ => vec![ElementSection::Solid],
    }
}

#[test]
fn a_linear_displacement_leaves_no_force_on_nodes_inside() {
    for kind in ElementKind::ALL {
        for section in sections(kind) {
            let body = patch(kind, section);
            let numbering = body.numbering(&Supports::default());
            let assembled = body.assembled(&numbering);
            let gradient = [[0.3, -0.2, 0.5], [0.1, 0.4, -0.3], [-0.6, 0.2, 0.7]];
            let field: Vec<f64> = numbering
                .freedoms()
                .iter()
                .map(|f| (0..3).map(|k| gradient[f.direction as usize][k] * f.place[k]).sum())
                .collect();
            let forces = product(&assembled.stiffness, &field);
            let largest = forces.iter().fold(0.0_f64, |a, b| a.max(b.abs()));
            let is_inside =
                |place: &[f64; 3]| place[..section.dimension()].iter().all(|u| *u > 1e-9 && *u < 1.0 - 1e-9);
            let mut inside = 0;
            for (freedom, force) in numbering.freedoms().iter().zip(&forces) {
                if is_inside(&freedom.place) {
                    inside += 1;
                    assert!(force.abs() < 1e-13 * largest, "{kind} {section:?}: {force:e} of {largest:e}");
                }
            }
            assert!(inside >= 8, "{kind}");
        }
    }
}

#[test]
fn the_mass_sums_to_that_of_the_volume_in_every_direction() {
    for kind in ElementKind::ALL {
        for section in sections(kind) {
            let body = patch(kind, section);
            let numbering = body.numbering(&Supports::default());
            let assembled = body.assembled(&numbering);
            for direction in &Direction::ALL[..section.dimension()] {
                let rigid: Vec<f64> = numbering
                    .freedoms()
                    .iter()
                    .map(|f| f64::from(u8::from(f.direction == *direction)))
                    .collect();
                let momentum: f64 =
                    product(&assembled.mass, &rigid).iter().zip(&rigid).map(|(p, r)| p * r).sum();
                assert!((momentum / section.thickness() - 1.0).abs() < 1e-12, "{kind} {momentum}");
                let force = product(&assembled.stiffness, &rigid).iter().fold(0.0_f64, |a, b| a.max(b.abs()));
                assert!(force < 1e-12, "{kind} {force:e}");
            }
        }
    }
}
