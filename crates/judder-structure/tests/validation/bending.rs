//! Bending: Cook's membrane, and thin beams that must not lock.

use crate::Body;
use judder_structure::element::ElementKind;
use judder_structure::freedom::{Direction, Numbering};
use judder_structure::grid::Grid;
use judder_structure::material::{Elastic, ElementSection};
use judder_structure::statics::Statics;

/// Shares of a uniform load along a straight edge of equal elements: those of linear or of quadratic shape functions.
fn along_edge(body: &Body, set: &str, axis: usize) -> Vec<(usize, f64)> {
    let mut nodes = body.mesh.node_sets[set].clone();
    nodes.sort_by(|a, b| body.mesh.nodes[*a][axis].total_cmp(&body.mesh.nodes[*b][axis]));
    let is_linear = body.mesh.blocks[0].kind.has_incompatible_modes();
    let pieces = if is_linear { nodes.len() - 1 } else { (nodes.len() - 1) / 2 };
    let shares: &[f64] = if is_linear { &[0.5, 0.5] } else { &[1.0 / 6.0, 4.0 / 6.0, 1.0 / 6.0] };
    let stride = shares.len() - 1;
    (0..pieces)
        .flat_map(|piece| {
            shares.iter().enumerate().map(move |(k, share)| (stride * piece + k, share / pieces as f64))
        })
        .map(|(place, share)| (nodes[place], share))
        .collect()
}

fn displaced(body: &Body, held: &str, loads: &[(usize, Direction, f64)]) -> (Numbering, Vec<f64>) {
    let numbering = body.numbering(&body.held(&body.mesh.node_sets[held]));
    let assembled = body.assembled(&numbering);
    let mut load = vec![0.0; numbering.freedoms().len()];
    for (node, direction, force) in loads {
        load[numbering.number(*node, *direction).unwrap()] += force;
    }
    Statics::new(&assembled.stiffness).unwrap().solve(&mut load);
    (numbering, load)
}

/// R. D. Cook, *Improved two-dimensional finite element*, J. Struct. Div. ASCE 100 (1974): E = 1, ν = 1/3, plane stress, a unit
/// load along the right edge; its middle rises by 23.96 on fine meshes.
#[test]
fn cooks_membrane() {
    for (kind, cells, accuracy) in
        [(ElementKind::Quad4, 16, 4e-3), (ElementKind::Quad8, 32, 5e-4), (ElementKind::Triangle6, 32, 1e-3)]
    {
        let grid = Grid { kind, size: [1.0; 3], cells: [cells, cells, 1] };
        let tapered = |[s, t, _]: [f64; 3]| [48.0 * s, 44.0 * s + t * (44.0 - 28.0 * s), 0.0];
        let body = Body {
            mesh: grid.mesh("any", tapered).unwrap(),
            material: Elastic::new(1.0, 1.0 / 3.0, 1.0).unwrap(),
            section: ElementSection::PlaneStress { thickness: 1.0 },
        };
        let loads: Vec<_> =
            along_edge(&body, "x-max", 1).into_iter().map(|(n, f)| (n, Direction::Y, f)).collect();
        let (numbering, u) = displaced(&body, "x-min", &loads);
        let middle = body.mesh.node_sets["x-max"]
            .iter()
            .copied()
            .find(|n| (body.mesh.nodes[*n][1] - 52.0).abs() < 1e-9);
        let rise = u[numbering.number(middle.unwrap(), Direction::Y).unwrap()];
        println!("{kind}: {rise}");
        assert!((rise / 23.96 - 1.0).abs() < accuracy, "{kind}: {rise}");
    }
}

/// Timoshenko: w = F l³/(3 E I) + 6 F l/(5 G A), at a slenderness of 100 and with one element across the thickness.
#[test]
fn thin_beams_bend_without_locking() {
    let (length, width) = (100.0, 2.0);
    for kind in ElementKind::ALL {
        let solid = kind.dimension() == 3;
        let grid = Grid { kind, size: [length, 1.0, width], cells: [50, 1, 1] };
        let section =
            if solid { ElementSection::Solid } else { ElementSection::PlaneStress { thickness: width } };
        let material = Elastic::new(1e6, 0.0, 1.0).unwrap();
        let body = Body { mesh: grid.mesh("any", |p| p).unwrap(), material, section };
        let end = &body.mesh.node_sets["x-max"];
        let loads: Vec<_> = end.iter().map(|node| (*node, Direction::Y, 1.0 / end.len() as f64)).collect();
        let (numbering, u) = displaced(&body, "x-min", &loads);
        let tip = u[numbering.number(end[0], Direction::Y).unwrap()];
        let expected = length.powi(3) / (3.0 * 1e6 * width / 12.0) + 1.2 * length / (0.5e6 * width);
        println!("{kind}: {}", tip / expected);
        assert!((tip / expected - 1.0).abs() < 0.01, "{kind}: {}", tip / expected);
    }
}
