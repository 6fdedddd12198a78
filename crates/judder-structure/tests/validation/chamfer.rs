//! Chamfered boxes against their closed forms.

use crate::Body;
use judder_structure::StructureError;
use judder_structure::chamfer::{BoxSide, Chamfer, ChamferedFace};
use judder_structure::element::ElementKind;
use judder_structure::freedom::{Direction, Supports};
use judder_structure::grid::Grid;
use judder_structure::material::{Elastic, ElementSection};
use judder_structure::mesh::Mesh;
use judder_structure::statics::product;
use std::collections::BTreeSet;

const SIZE: [f64; 3] = [5.0, 2.0, 3.0];
const CELLS: [usize; 3] = [7, 4, 4];

fn cut(length: f64, depth: f64, cells: usize) -> Option<Chamfer> {
    Some(Chamfer { length, depth, cells })
}

fn grid(kind: ElementKind) -> Grid {
    Grid { kind, size: SIZE, cells: CELLS }
}

fn mesh(kind: ElementKind, chamfered: &ChamferedFace) -> Mesh {
    grid(kind).chamfered_mesh(chamfered, "any", |place| place).unwrap()
}

/// Faces and the axes along which they are cut, of a plane and of space.
fn ways(dimension: usize) -> Vec<(BoxSide, usize)> {
    let faces = BoxSide::BY_AXIS.into_iter().take(dimension).flatten();
    faces
        .flat_map(|face| {
            (0..dimension).filter(move |axis| *axis != face.axis()).map(move |axis| (face, axis))
        })
        .collect()
}

/// ∫ 1 dV and ∫ x dV of what is left: the box less two triangular prisms, with their own centres.
fn volume_and_moment(chamfered: &ChamferedFace, dimension: usize) -> (f64, [f64; 3]) {
    let (across, along) = (chamfered.face.axis(), chamfered.along);
    let size: [f64; 3] = std::array::from_fn(|axis| if axis < dimension { SIZE[axis] } else { 1.0 });
    let mut volume = size.iter().product::<f64>();
    let mut moment = size.map(|side| 0.5 * side * volume);
    for (own, is_max) in
        chamfered.cuts.iter().zip([false, true]).filter_map(|(cut, end)| Some(((*cut)?, end)))
    {
        let lost = 0.5 * own.length * own.depth * size[3 - across - along];
        let from = |is_max: bool, axis: usize, reach: f64| {
            if is_max { size[axis] - reach / 3.0 } else { reach / 3.0 }
        };
        let mut centre = size.map(|side| 0.5 * side);
        centre[along] = from(is_max, along, own.length);
        centre[across] = from(chamfered.face.is_max(), across, own.depth);
        volume -= lost;
        moment.iter_mut().zip(centre).for_each(|(sum, place)| *sum -= lost * place);
    }
    (volume, moment)
}

#[test]
fn mass_and_centre_are_those_of_the_box_without_its_chamfers() {
    for kind in ElementKind::ALL {
        let dimension = kind.dimension();
        for (face, along) in ways(dimension) {
            for cuts in
                [[cut(0.9, 0.6, 2), cut(0.4, 1.1, 1)], [None, cut(1.2, 0.3, 1)], [cut(0.2, 1.9, 1), None]]
            {
                let chamfered = ChamferedFace { face, along, cuts };
                let section = match dimension {
                    2 => ElementSection::PlaneStress { thickness: 1.0 },
                    _ => ElementSection::Solid,
                };
                let mesh = mesh(kind, &chamfered);
                let body = Body { mesh, material: Elastic::new(3.0, 0.3, 1.0).unwrap(), section };
                let numbering = body.numbering(&Supports::default());
                let mass = body.assembled(&numbering).mass;
                let along_x = |of: &dyn Fn([f64; 3]) -> f64| -> Vec<f64> {
                    let of = |own: &judder_structure::freedom::Freedom| {
                        if own.direction == Direction::X { of(own.place) } else { 0.0 }
                    };
                    numbering.freedoms().iter().map(of).collect()
                };
                let pushed = product(&mass, &along_x(&|_| 1.0));
                let with = |values: Vec<f64>| values.iter().zip(&pushed).map(|(a, b)| a * b).sum::<f64>();
                let (volume, moment) = volume_and_moment(&chamfered, dimension);
                assert!((with(along_x(&|_| 1.0)) / volume - 1.0).abs() < 1e-13, "{kind} {chamfered:?}");
                for axis in 0..dimension {
                    let found = with(along_x(&|place| place[axis]));
                    assert!((found / moment[axis] - 1.0).abs() < 1e-13, "{kind} {chamfered:?} {axis}");
                }
            }
        }
    }
}

#[test]
fn sets_of_a_face_are_what_its_chamfers_leave_and_their_flanks() {
    for kind in ElementKind::ALL {
        let chamfered =
            ChamferedFace { face: BoxSide::YMin, along: 0, cuts: [cut(0.9, 0.6, 2), cut(0.4, 1.1, 1)] };
        let (cut, whole) = (mesh(kind, &chamfered), grid(kind).mesh("any", |place| place).unwrap());
        cut.check().unwrap();
        assert_eq!(cut.blocks, whole.blocks);
        // on the line from (x, y) to (X, Y), by how far
        let beside = |[x, y, _]: [f64; 3], [from, to]: [[f64; 2]; 2]| {
            ((to[0] - from[0]) * (y - from[1]) - (to[1] - from[1]) * (x - from[0])).abs()
        };
        let within = |x: f64, from: f64, to: f64| x > from - 1e-12 && x < to + 1e-12;
        let [w, h] = [SIZE[0], SIZE[1]];
        for (set, line) in [
            ("y-min", [[0.9, 0.0], [w - 0.4, 0.0]]),
            ("chamfer-x-min", [[0.0, 0.6], [0.9, 0.0]]),
            ("chamfer-x-max", [[w - 0.4, 0.0], [w, 1.1]]),
            ("x-min", [[0.0, 0.6], [0.0, h]]),
            ("x-max", [[w, 1.1], [w, h]]),
            ("y-max", [[0.0, h], [w, h]]),
        ] {
            let there: Vec<usize> = (0..cut.nodes.len())
                .filter(|node| {
                    let place = cut.nodes[*node];
                    beside(place, line) < 1e-12
                        && within(place[0], line[0][0], line[1][0])
                        && within(place[1], line[0][1].min(line[1][1]), line[0][1].max(line[1][1]))
                })
                .collect();
            assert_eq!(cut.node_sets[set], there, "{kind} {set}");
        }
        let parts =
            ["y-min", "chamfer-x-min", "chamfer-x-max"].into_iter().flat_map(|set| &cut.node_sets[set]);
        let parts: BTreeSet<usize> = parts.copied().collect();
        assert!(parts.iter().eq(&cut.node_sets["y-min-whole"]), "{kind}");
        // nothing is left where the face and the sides met
        assert!(!cut.node_sets.contains_key("x-min-y-min") && cut.node_sets.contains_key("x-min-y-max"));
        let edge = &cut.node_sets["chamfer-x-min-y-min"];
        assert!(!edge.is_empty() && edge.iter().all(|node| (cut.nodes[*node][0] - 0.9).abs() < 1e-15));
    }
}

/// Nodes move with lengths and depths as those of a fixed topology do: along straight lines.
#[test]
fn nodes_follow_a_chamfer_linearly() {
    let at = |length: f64, depth: f64| {
        let cuts = [cut(length, depth, 2), None];
        mesh(ElementKind::Quad8, &ChamferedFace { face: BoxSide::YMin, along: 0, cuts }).nodes
    };
    let (from, to) = (at(0.1, 0.2), at(1.3, 1.7));
    let [longer, deeper] = [at(1.3, 0.2), at(0.1, 1.7)];
    for node in 0..from.len() {
        for axis in 0..2 {
            let moved = |own: &Vec<[f64; 3]>| own[node][axis] - from[node][axis];
            let middle = at(0.7, 0.2);
            assert!((2.0 * moved(&middle) - moved(&longer)).abs() < 1e-12);
            // length moves nodes along the face, depth across it
            let own = if axis == 0 { &longer } else { &deeper };
            assert!((moved(&to) - moved(own)).abs() < 1e-12);
        }
    }
}

#[test]
fn chamfers_that_would_fold_elements_are_refused() {
    let refused = |face, along, cuts| {
        let chamfered = ChamferedFace { face, along, cuts };
        match grid(ElementKind::Quad4).chamfered_mesh(&chamfered, "any", |place| place) {
            Err(StructureError::NoChamfer { what }) => what,
            other => panic!("{other:?}"),
        }
    };
    for (face, along, cuts, what) in [
        (BoxSide::YMin, 0, [cut(1.0, 2.0, 1), None], "less deep"),
        (BoxSide::YMin, 0, [cut(3.0, 0.5, 1), cut(2.0, 0.5, 1)], "some of the length"),
        (BoxSide::YMin, 0, [cut(1.0, 0.5, 4), cut(1.0, 0.5, 3)], "a cell"),
        (BoxSide::YMin, 0, [cut(1.0, 0.5, usize::MAX), cut(1.0, 0.5, 3)], "a cell"),
        (BoxSide::YMin, 0, [cut(f64::NAN, 0.5, 1), None], "positive"),
        (BoxSide::YMin, 0, [cut(1.0, 0.0, 1), None], "positive"),
        (BoxSide::YMin, 0, [None, cut(1.0, 0.1, 0)], "positive"),
        (BoxSide::YMin, 1, [cut(1.0, 0.5, 1), None], "lies in it"),
        (BoxSide::YMin, 2, [cut(1.0, 0.5, 1), None], "lies in it"),
        (BoxSide::ZMin, 0, [cut(1.0, 0.5, 1), None], "lies in it"),
        (BoxSide::YMin, 0, [cut(1.0, 1.99, 1), None], "slivers"),
        (BoxSide::YMin, 0, [cut(1e-3, 0.5, 1), None], "slivers"),
    ] {
        assert!(refused(face, along, cuts).contains(what), "{cuts:?}");
    }
}
