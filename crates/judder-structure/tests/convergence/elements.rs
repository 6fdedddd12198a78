//! The order of every element, by a manufactured solution on ever finer, smoothly distorted meshes.

use crate::Body;
use judder_structure::element::ElementKind;
use judder_structure::freedom::{Freedom, Supports};
use judder_structure::grid::Grid;
use judder_structure::material::{Elastic, ElementSection};
use judder_structure::statics::{Statics, product};
use std::f64::consts::PI;

const AMPLITUDE: [f64; 3] = [1.0, -0.7, 0.4];

/// u = a Π sin π xₖ, which is zero on the sides of the unit box, and its derivatives.
fn product_of_sines(place: &[f64; 3], dimension: usize, derivatives: &[usize]) -> f64 {
    (0..dimension)
        .map(|k| {
            let order = derivatives.iter().filter(|d| **d == k).count();
            let turn = PI * place[k];
            match order {
                0 => turn.sin(),
                1 => PI * turn.cos(),
                _ => -PI * PI * turn.sin(),
            }
        })
        .product()
}

/// b = −(μ ∇²u + (λ + μ) ∇ div u) along a degree of freedom.
fn body_force(freedom: &Freedom, dimension: usize, lame: f64, shear: f64) -> f64 {
    let i = freedom.direction as usize;
    let at = |derivatives: &[usize]| product_of_sines(&freedom.place, dimension, derivatives);
    let laplacian: f64 = (0..dimension).map(|k| AMPLITUDE[i] * at(&[k, k])).sum();
    let gradient: f64 = (0..dimension).map(|k| AMPLITUDE[k] * at(&[i, k])).sum();
    -(shear * laplacian + (lame + shear) * gradient)
}

/// The L² distance of the displacements from the exact ones at the nodes.
fn error(kind: ElementKind, cells: usize) -> f64 {
    let dimension = kind.dimension();
    let bulge = |p: [f64; 3]| {
        let shift = 0.06 * product_of_sines(&p, dimension, &[]);
        std::array::from_fn(|k| if k < dimension { p[k] + shift * AMPLITUDE[k] } else { 0.0 })
    };
    let (young, poisson) = (2.0, 0.3);
    let section =
        if dimension == 2 { ElementSection::PlaneStrain { thickness: 1.0 } } else { ElementSection::Solid };
    let grid = Grid { kind, size: [1.0; 3], cells: [cells; 3] };
    let body = Body {
        mesh: grid.mesh("any", bulge).unwrap(),
        material: Elastic::new(young, poisson, 1.0).unwrap(),
        section,
    };
    let sides: Vec<usize> = body.mesh.node_sets.values().flatten().copied().collect();
    let (free, whole) = (body.numbering(&body.held(&sides)), body.numbering(&Supports::default()));
    let (shear, lame) =
        (young / (2.0 * (1.0 + poisson)), young * poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson)));
    // with a density of one the mass matrix makes consistent loads of forces at the nodes
    let forces: Vec<f64> =
        whole.freedoms().iter().map(|freedom| body_force(freedom, dimension, lame, shear)).collect();
    let loads = product(&body.assembled(&whole).mass, &forces);
    let number = |freedom: &Freedom| whole.number(freedom.node, freedom.direction).unwrap();
    let mut u: Vec<f64> = free.freedoms().iter().map(|freedom| loads[number(freedom)]).collect();
    let assembled = body.assembled(&free);
    Statics::new(&assembled.stiffness).unwrap().solve(&mut u);
    for (u, freedom) in u.iter_mut().zip(free.freedoms()) {
        *u -= AMPLITUDE[freedom.direction as usize] * product_of_sines(&freedom.place, dimension, &[]);
    }
    product(&assembled.mass, &u).iter().zip(&u).map(|(m, u)| m * u).sum::<f64>().sqrt()
}

#[test]
fn displacements_converge_with_the_square_and_with_the_cube_of_the_element() {
    for (kind, cells, order) in [
        (ElementKind::Quad4, [8, 16, 32], 2.0),
        (ElementKind::Quad8, [4, 8, 16], 3.0),
        (ElementKind::Triangle6, [4, 8, 16], 3.0),
        (ElementKind::Hexahedron8, [4, 8, 12], 2.0),
        (ElementKind::Hexahedron20, [2, 4, 6], 3.0),
        (ElementKind::Tetrahedron10, [2, 4, 6], 3.0),
    ] {
        let errors = cells.map(|cells| error(kind, cells));
        let slope =
            |a: usize, b: usize| (errors[a] / errors[b]).ln() / (cells[b] as f64 / cells[a] as f64).ln();
        println!("{kind}: errors {errors:?}, orders {:.2} {:.2}", slope(0, 1), slope(1, 2));
        assert!(slope(1, 2) > order - 0.25, "{kind}: {errors:?}");
    }
}
