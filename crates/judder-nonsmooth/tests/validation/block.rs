//! A block of quadrilaterals that is pushed on a moving plane.

use crate::common::{IMPLICIT, assembly, settings};
use judder_assembly::assembly::Assembly;
use judder_assembly::compliance::Compliance;
use judder_assembly::friction::{FallingFriction, Friction};
use judder_assembly::interface::InterfaceLaw;
use judder_assembly::linearised::{Linearised, LinearisedTerms};
use judder_assembly::pressure::Pressure;
use judder_assembly::row::Row;
use judder_assembly::search::{KeptOfFaces, Sliding, TouchingBody, Track, contact_points};
use judder_assembly::steady::steady_sliding;
use judder_nonsmooth::growth::growth;
use judder_nonsmooth::march::NonsmoothMarch;
use judder_nonsmooth::mode_share::{ModalContent, ModeShare};
use judder_nonsmooth::scheme::ContactScheme;
use judder_structure::assembly::{assemble, displacement_load};
use judder_structure::complex_modes::{ComplexModeSettings, Region, complex_modes};
use judder_structure::element::ElementKind;
use judder_structure::freedom::{Direction, Numbering, Supports};
use judder_structure::grid::Grid;
use judder_structure::material::{Elastic, ElementSection};

const WIDTH: f64 = 0.01;

/// 40 × 20 mm in 8 × 4 cells, nine nodes on the plane; its top is held along x and pressed.
pub(crate) fn block(law: InterfaceLaw, speed: f64, damping: [f64; 2]) -> Assembly {
    made(law, speed, damping, false)
}

/// The same with its top held and pushed down by 20 µm.
pub(crate) fn block_held(law: InterfaceLaw, speed: f64, damping: [f64; 2]) -> Assembly {
    made(law, speed, damping, true)
}

fn made(law: InterfaceLaw, speed: f64, damping: [f64; 2], is_held: bool) -> Assembly {
    let grid = Grid { kind: ElementKind::Quad4, size: [0.04, 0.02, 0.0], cells: [8, 4, 0] };
    let mesh = grid.mesh("block", |place| place).unwrap();
    let top = mesh.node_sets["y-max"].clone();
    let supports = Supports {
        fixed: top
            .iter()
            .flat_map(|node| [(*node, Direction::X), (*node, Direction::Y)])
            .filter(|(_, direction)| is_held || *direction == Direction::X)
            .collect(),
        ..Supports::default()
    };
    let numbering = Numbering::new(&mesh, 2, &supports).unwrap();
    let material = Elastic::new(2e9, 0.35, 1200.0).unwrap();
    let section = ElementSection::PlaneStrain { thickness: WIDTH };
    let materials = [("block".to_owned(), (material, section))].into();
    let assembled = assemble(&mesh, &materials, &numbering).unwrap();
    let mut load = vec![0.0; numbering.freedoms().len()];
    if is_held {
        let imposed = top.iter().map(|node| ((*node, Direction::Y), -20e-6)).collect();
        load = displacement_load(&mesh, &materials, &numbering, &imposed).unwrap();
    } else {
        for node in &top {
            load[numbering.number(*node, Direction::Y).unwrap()] = -1e3 / top.len() as f64;
        }
    }
    let slider = TouchingBody {
        mesh: &mesh,
        width: WIDTH,
        displacement: &|node, direction| {
            numbering.number(node, direction).map_or_else(Row::default, Row::of_freedom)
        },
        displaced: &|_| [0.0; 3],
        kept: KeptOfFaces::default(),
    };
    let found = contact_points(
        &slider,
        &mesh.node_sets["y-min"],
        &Track::Plane([0.0, 1.0, 0.0]),
        Sliding::Translation([speed, 0.0, 0.0]),
        1e-3,
    )
    .unwrap();
    assert_eq!(found.points.len(), 9);
    let entries = |matrix: &judder_structure::assembly::Sparse, factor: f64| {
        judder_assembly::assembly::triplets(matrix)
            .map(move |mut entry| {
                entry.val *= factor;
                entry
            })
            .collect::<Vec<_>>()
    };
    let all = [entries(&assembled.mass, damping[0]), entries(&assembled.stiffness, damping[1])].concat();
    let damping = judder_assembly::assembly::from_triplets(load.len(), load.len(), &all).unwrap();
    assembly([assembled.mass, damping, assembled.stiffness], load, found.points, law)
}

/// Growth in the march is the eigenvalue's to 2e-3, by both schemes, of every mode of the band that swings clearly.
#[test]
fn modes_grow_in_the_march_as_their_eigenvalues_say() {
    let falling = FallingFriction { at_rest: 0.6, at_speed: 0.45, decay_speed: 0.5 };
    let laws = [
        InterfaceLaw::Rigid(Friction::Constant(0.5)),
        InterfaceLaw::Rigid(Friction::Falling(falling)),
        InterfaceLaw::Compliant(Pressure::Stiffness(1e12), Friction::Constant(0.5)),
    ];
    let cases = laws.iter().flat_map(|law| [block, block_held].map(|make| (law, make)));
    for (law, make) in cases {
        let case = make(law.clone(), 1.0, [100.0, 5e-8]);
        let steady = steady_sliding(&case, &Compliance::new(&case).unwrap()).unwrap();
        let about = Linearised::new(&case, &steady, LinearisedTerms::default()).unwrap();
        let region = Region { re: [-5e4, 5e4], im: [1e3, 4e5] };
        let found = complex_modes(&about.problem, &region, &ComplexModeSettings::default()).unwrap();
        let mode = found
            .modes
            .iter()
            .max_by(|a, b| a.eigenvalue.value.re.total_cmp(&b.eigenvalue.value.re))
            .unwrap();
        for (scheme, step) in [(IMPLICIT, 5e-8), (ContactScheme::ForwardIncrement, 5e-8)] {
            let told = growth(&case, &steady, &about, mode, settings(scheme, step)).unwrap();
            let off = (told.measured.re - told.predicted.re).abs() / told.predicted.re.abs();
            assert!(told.is_small);
            assert!(off < 2e-3, "{law:?} {scheme:?}: {told:?}");
            assert!((told.measured.im / told.predicted.im - 1.0).abs() < 1e-3);
        }
    }
}

/// A motion that is started in a mode has that mode alone, with its amplitude and its frequency.
#[test]
fn a_motion_in_a_mode_has_that_mode() {
    let case = block(InterfaceLaw::Rigid(Friction::Constant(0.1)), 1.0, [100.0, 5e-8]);
    let steady = steady_sliding(&case, &Compliance::new(&case).unwrap()).unwrap();
    let about = Linearised::new(&case, &steady, LinearisedTerms::default()).unwrap();
    let region = Region { re: [-5e4, 5e4], im: [1e3, 2e5] };
    let found = complex_modes(&about.problem, &region, &ComplexModeSettings::default()).unwrap();
    let step = 1e-7;
    let mut march = NonsmoothMarch::new(&case, &[], settings(IMPLICIT, step)).unwrap();
    let shares = found.modes.iter().map(|mode| {
        let (right, left) = (about.expanded(&mode.right), about.expanded_left(&mode.left));
        ModeShare::new(&march, &about, mode.eigenvalue.value, [&right, &left], &steady.displacement)
    });
    let mut content = ModalContent::new(shares.collect());
    let value = found.modes[0].eigenvalue.value;
    let (shape, size) = (about.expanded(&found.modes[0].right), 1e-9);
    let state = |factor: faer::c64, rest: &dyn Fn(usize) -> f64| -> Vec<f64> {
        (0..shape.len()).map(|k| rest(k) + size * (factor * shape[k]).re).collect()
    };
    march.start(&state(faer::c64::ONE, &|k| steady.displacement[k]), &state(value, &|_| 0.0));
    let steps = (20.0 * std::f64::consts::TAU / value.im / step) as u64;
    for _ in 0..steps {
        march.advance().unwrap();
        content.take(&march);
    }
    // the mean square of e^{σt}
    let time = steps as f64 * step;
    let grown = ((2.0 * value.re * time).exp_m1() / (2.0 * value.re * time)).sqrt();
    let [rms, turning] = content.of(0).unwrap();
    assert!((rms / (0.5 * size * grown) - 1.0).abs() < 5e-3, "{rms} {}", 0.5 * size * grown);
    assert!((turning / value.im - 1.0).abs() < 2e-3, "{turning} {}", value.im);
    for mode in 1..found.modes.len() {
        let [other, _] = content.of(mode).unwrap();
        assert!(other < 2e-2 * rms, "mode {mode}: {other} beside {rms}");
    }
}
