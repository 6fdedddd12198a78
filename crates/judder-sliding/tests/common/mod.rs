//! The pair of the beams paper, Tables 1 and 2, with the readings that its book chapter names.
#![allow(dead_code, reason = "each test binary uses its part")]

use judder_contact::friction::Friction;
use judder_sliding::body::ModalPoint;
use judder_sliding::edge::Interpolation;
use judder_sliding::motion::{InitialDamping, Motion, Noise, Ramps};
use judder_sliding::pair::{Observed, Pair, PairSide, Slider, TrackBody};
use judder_sliding::reduced::Reduced;
use judder_structure::assembly::{assemble, inertia_load};
use judder_structure::beam::Beam;
use judder_structure::craig_bampton::{CraigBampton, CutOff};
use judder_structure::freedom::{Direction, Numbering, Supports};
use judder_structure::material::{Elastic, ElementSection};
use judder_structure::mesh::Mesh;
use judder_structure::rigid::{largest_ratio, rigid_limit};
use std::collections::BTreeMap;

/// The friction coefficient of Table 2.
pub(crate) const FRICTION: f64 = 0.3;
/// The vertical force of Table 2, N.
pub(crate) const LOAD: f64 = -0.2;
/// The speed of Table 2, m/s.
pub(crate) const SPEED: f64 = 0.03;

/// Ramps as the paper has them, along the whole path.
pub(crate) fn motion() -> Motion {
    Motion {
        start: 0.010,
        end: 0.0985,
        velocity: SPEED,
        load: LOAD,
        initial_gap: 0.0,
        noise: Noise::default(),
        ramps: Ramps { velocity: 0.1, load: 0.1, friction: 0.1, gap: 0.1 },
        initial_damping: Some(InitialDamping { alpha: 40.0, beta: 4e-8, hold: 0.2, release: 0.05 }),
    }
}

/// The paper's pair.
pub(crate) fn pair() -> Pair {
    pair_with(Interpolation::Linear, Friction::Constant(FRICTION), 20)
}

/// The paper's pair with another interpolation, friction, number of fixed-interface modes.
pub(crate) fn pair_with(interpolation: Interpolation, friction: Friction, modes: usize) -> Pair {
    let (track, observed) = horizontal(modes);
    Pair::new(oblique(modes), track, interpolation, true, friction, vec![observed]).unwrap()
}

fn oblique(modes: usize) -> Slider {
    let beam = Beam {
        length: 0.075,
        thickness: 0.0015,
        elements: [75, 2],
        origin: [0.0; 2],
        angle: -30_f64.to_radians(),
    };
    let mesh = beam.mesh("m").unwrap();
    let start = mesh.node_sets["start"].clone();
    let supports = Supports {
        fixed: start.iter().map(|node| (*node, Direction::X)).collect(),
        tied: vec![(start.clone(), Direction::Y)],
    };
    let corner = mesh.node_sets["end"][0];
    let material =
        (Elastic::new(71e9, 0.33, 2770.0).unwrap(), ElementSection::PlaneStress { thickness: 0.010 });
    let wanted = [(start[0], Direction::Y), (corner, Direction::X), (corner, Direction::Y)];
    let reduced = reduce(&mesh, material, &supports, &wanted, (0.2, 4e-8), modes);
    let row = |kept| reduced.row(Some(kept)).unwrap();
    let place = [mesh.nodes[corner][0], mesh.nodes[corner][1]];
    let contact = ModalPoint { place, rows: [row(1), row(2)] };
    Slider { body: reduced.body.clone(), contact, load: row(0), inertia: reduced.inertia() }
}

fn horizontal(modes: usize) -> (TrackBody, Observed) {
    let beam = Beam { length: 0.100, thickness: 0.002, elements: [100, 2], origin: [0.0; 2], angle: 0.0 };
    let mesh = beam.mesh("m").unwrap();
    let start = mesh.node_sets["start"].clone();
    let both = [Direction::X, Direction::Y];
    let fixed = start.iter().flat_map(|node| both.map(|direction| (*node, direction))).collect();
    let supports = Supports { fixed, tied: Vec::new() };
    let material =
        (Elastic::new(2.38e9, 0.40, 1200.0).unwrap(), ElementSection::PlaneStress { thickness: 0.020 });
    let edge = mesh.node_sets["upper-corners"].clone();
    let wanted: Vec<_> = edge[1..].iter().flat_map(|node| both.map(|direction| (*node, direction))).collect();
    let reduced = reduce(&mesh, material, &supports, &wanted, (40.0, 4e-8), modes);
    let point = |(k, node): (usize, &usize)| {
        let kept = |direction: usize| (k > 0).then(|| 2 * (k - 1) + direction);
        let place = [mesh.nodes[*node][0], mesh.nodes[*node][1]];
        ModalPoint { place, rows: [0, 1].map(|direction| reduced.row(kept(direction)).unwrap()) }
    };
    let nodes: Vec<ModalPoint> = edge.iter().enumerate().map(point).collect();
    let observed = Observed { side: PairSide::Track, row: nodes[100].rows[1].clone(), rigid: 0.0 };
    (TrackBody { body: reduced.body.clone(), nodes }, observed)
}

fn reduce(
    mesh: &Mesh,
    material: (Elastic, ElementSection),
    supports: &Supports,
    wanted: &[(usize, Direction)],
    damping: (f64, f64),
    modes: usize,
) -> Reduced {
    let materials = BTreeMap::from([("m".to_owned(), material)]);
    let numbering = Numbering::new(mesh, 2, supports).unwrap();
    let assembled = assemble(mesh, &materials, &numbering).unwrap();
    let kept: Vec<usize> =
        wanted.iter().map(|(node, along)| numbering.number(*node, *along).unwrap()).collect();
    let reduced =
        CraigBampton::new(&assembled.stiffness, &assembled.mass, &kept, CutOff::Count(modes)).unwrap();
    let load = inertia_load(mesh, &materials, &numbering, [1.0, 0.0, 0.0]).unwrap();
    let rigid = rigid_limit(assembled.mass.nrows(), largest_ratio(&assembled.stiffness, &assembled.mass));
    Reduced::new(&reduced, damping.0, damping.1, rigid, &load).unwrap()
}

/// The same pair on a curved edge that bulges by so much in the middle, m; both ends stay.
pub(crate) fn bulging(pair: &Pair, height: f64) -> Pair {
    let mut track = pair.track().clone();
    for (node, position) in track.nodes.iter_mut().zip(pair.node_positions()) {
        let share = position / pair.length();
        node.place[1] += 4.0 * height * share * (1.0 - share);
    }
    let interpolation = pair.edge().interpolation;
    Pair::new(
        pair.slider().clone(),
        track,
        interpolation,
        true,
        pair.friction().clone(),
        pair.observed().to_vec(),
    )
    .unwrap()
}

/// The same pair without damping.
pub(crate) fn without_damping(pair: &Pair) -> Pair {
    let (mut slider, mut track) = (pair.slider().clone(), pair.track().clone());
    for body in [&mut slider.body, &mut track.body] {
        (body.alpha, body.beta) = (0.0, 0.0);
    }
    let interpolation = pair.edge().interpolation;
    Pair::new(slider, track, interpolation, true, pair.friction().clone(), pair.observed().to_vec()).unwrap()
}
