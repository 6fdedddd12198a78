//! Newton's third law of an interface whose meshes do not match.

use judder_assembly::contact_point::ContactPoint;
use judder_assembly::row::Row;
use judder_assembly::search::{KeptOfFaces, Sliding, TouchingBody, Track, contact_points};
use judder_structure::element::ElementKind;
use judder_structure::freedom::Direction;
use judder_structure::grid::Grid;
use judder_structure::mesh::Mesh;

/// A track and a slider above it, whose lowest side is moved there; both have every freedom of space, the slider's behind the track's.
struct Touching {
    track: Mesh,
    slider: Mesh,
    points: Vec<ContactPoint>,
}

impl Touching {
    fn new(kind: ElementKind, cells: [[usize; 3]; 2]) -> Self {
        let (up, upper, lower) = match kind.dimension() {
            2 => (1, "y-max", "y-min"),
            _ => (2, "z-max", "z-min"),
        };
        let deep = if up == 2 { 0.02 } else { 0.0 };
        let own = |size: [f64; 3], cells: [usize; 3], from: [f64; 3]| {
            let grid = Grid { kind, size, cells };
            grid.mesh("m", |x| std::array::from_fn(|k| x[k] + from[k])).unwrap()
        };
        let track = own([0.06, 0.02, deep], cells[0], [0.0; 3]);
        let mut from = [0.0113, 0.0027, 0.0];
        from[up] = 0.02;
        let mut size = [0.031, 0.0141, deep];
        size[up] = 0.008;
        let slider = own(size, cells[1], from);
        let first = 3 * track.nodes.len();
        let [of_track, of_slider] = [0, first].map(|first| {
            move |node: usize, direction: Direction| Row::of_freedom(first + 3 * node + direction as usize)
        });
        let touching = |mesh, displacement| TouchingBody {
            mesh,
            width: 1.0,
            displacement,
            displaced: &|_| [0.0; 3],
            kept: KeptOfFaces::default(),
        };
        let found = contact_points(
            &touching(&slider, &of_slider),
            &slider.node_sets[lower],
            &Track::Body(touching(&track, &of_track), &track.node_sets[upper]),
            Sliding::Translation([1.0, if up == 2 { 0.3 } else { 0.0 }, 0.0]),
            5e-3,
        )
        .unwrap();
        assert!(found.without_partner.is_empty() && found.points.len() > 4);
        Self { points: found.points, track, slider }
    }

    /// Force and moment about the origin on the nodes of a body, whose freedoms begin there.
    fn resultant(mesh: &Mesh, forces: &[f64], first: usize) -> [f64; 6] {
        let mut sum = [0.0; 6];
        for (node, place) in mesh.nodes.iter().enumerate() {
            let force = &forces[first + 3 * node..][..3];
            for k in 0..3 {
                let (next, last) = ((k + 1) % 3, (k + 2) % 3);
                sum[k] += force[k];
                sum[3 + k] += place[next] * force[last] - place[last] * force[next];
            }
        }
        sum
    }
}

/// Normal and friction forces of all points, each another: force and moment on the slider and on the track are opposite to rounding.
#[test]
fn forces_and_moments_on_slider_and_track_are_opposite() {
    for touching in [
        Touching::new(ElementKind::Quad4, [[11, 3, 0], [7, 2, 0]]),
        Touching::new(ElementKind::Hexahedron8, [[7, 3, 2], [5, 2, 1]]),
    ] {
        let first = 3 * touching.track.nodes.len();
        let mut forces = vec![0.0; first + 3 * touching.slider.nodes.len()];
        let mut size = 0.0;
        for (k, point) in touching.points.iter().enumerate() {
            let frame = point.frame("sole").unwrap();
            let normal = 2.0 + (1.7 * k as f64).sin();
            frame.normal.add_to(normal, &mut forces);
            frame.slip.add_to(0.4 * normal, &mut forces);
            size += normal;
        }
        let on_track = Touching::resultant(&touching.track, &forces, 0);
        let on_slider = Touching::resultant(&touching.slider, &forces, first);
        for (a, b) in on_track.iter().zip(&on_slider) {
            assert!((a + b).abs() < 1e-14 * size, "{on_track:?} {on_slider:?}");
        }
        assert!(on_slider[..3].iter().map(|own| own.abs()).sum::<f64>() > 0.9 * size);
    }
}
