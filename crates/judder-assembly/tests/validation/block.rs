//! A block of quadrilaterals that a load presses on a moving plane.

use crate::common::undamped;
use faer::Mat;
use judder_assembly::AssemblyError;
use judder_assembly::assembly::Assembly;
use judder_assembly::compliance::Compliance;
use judder_assembly::friction::Friction;
use judder_assembly::interface::{Interface, InterfaceLaw};
use judder_assembly::linearised::{Linearised, LinearisedTerms};
use judder_assembly::pressure::Pressure;
use judder_assembly::row::Row;
use judder_assembly::search::{KeptOfFaces, Sliding, TouchingBody, Track, contact_points};
use judder_assembly::steady::{SteadySliding, steady_sliding};
use judder_dense::general::solve;
use judder_structure::assembly::assemble;
use judder_structure::complex_modes::{ComplexModeSettings, Region, complex_modes};
use judder_structure::element::ElementKind;
use judder_structure::freedom::{Direction, Numbering, Supports};
use judder_structure::grid::Grid;
use judder_structure::material::{Elastic, ElementSection};

const WIDTH: f64 = 0.01;

/// A block of 40 × 20 mm whose top is held along x and pressed by 1 kN; nothing but the plane holds it along y.
fn block(law: InterfaceLaw, speed: f64) -> Assembly {
    shaped(law, Sliding::Translation([speed, 0.0, 0.0]), |place| place)
}

/// The same in another shape, on a plane that moves so.
fn shaped(law: InterfaceLaw, sliding: Sliding, place: impl Fn([f64; 3]) -> [f64; 3]) -> Assembly {
    let grid = Grid { kind: ElementKind::Quad4, size: [0.04, 0.02, 0.0], cells: [12, 6, 0] };
    let mesh = grid.mesh("rubber", place).unwrap();
    let top = mesh.node_sets["y-max"].clone();
    let supports =
        Supports { fixed: top.iter().map(|node| (*node, Direction::X)).collect(), ..Supports::default() };
    let numbering = Numbering::new(&mesh, 2, &supports).unwrap();
    let material = Elastic::new(2e9, 0.35, 1200.0).unwrap();
    let section = ElementSection::PlaneStrain { thickness: WIDTH };
    let materials = [("rubber".to_owned(), (material, section))].into();
    let assembled = assemble(&mesh, &materials, &numbering).unwrap();
    let mut load = vec![0.0; numbering.freedoms().len()];
    for node in &top {
        load[numbering.number(*node, Direction::Y).unwrap()] = -1e3 / top.len() as f64;
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
    let found =
        contact_points(&slider, &mesh.node_sets["y-min"], &Track::Plane([0.0, 1.0, 0.0]), sliding, 1e-3)
            .unwrap();
    assert_eq!((found.points.len(), found.without_partner.len()), (13, 0));
    let area: f64 = found.points.iter().map(|point| point.area).sum();
    assert!((area - 0.04 * WIDTH).abs() < 1e-15);
    let sole = Interface { name: "sole".to_owned(), points: found.points, law, all_closed: false };
    undamped(assembled.mass, assembled.stiffness, load, vec![sole])
}

fn solved(assembly: &Assembly) -> Result<SteadySliding, AssemblyError> {
    steady_sliding(assembly, &Compliance::new(assembly)?)
}

/// The same with full matrices: K and the forces of the closed points as unknowns together.
fn by_multipliers(assembly: &Assembly, friction: f64, closed: &[bool]) -> Vec<f64> {
    let size = assembly.size();
    let framed = assembly.framed().unwrap();
    let own: Vec<_> =
        framed.iter().zip(closed).filter(|(_, closed)| **closed).map(|(point, _)| point).collect();
    let mut matrix = Mat::zeros(size + own.len(), size + own.len());
    for column in 0..size {
        let values = assembly.stiffness.row_idx_of_col(column).zip(assembly.stiffness.val_of_col(column));
        values.for_each(|(row, value)| matrix[(row, column)] = *value);
    }
    for (k, point) in own.iter().enumerate() {
        point.equilibrium(friction).entries().iter().for_each(|(i, value)| matrix[(*i, size + k)] = -value);
        point.frame.normal.entries().iter().for_each(|(i, value)| matrix[(size + k, *i)] = *value);
    }
    let mut right = Mat::from_fn(size + own.len(), 1, |i, _| assembly.load.get(i).copied().unwrap_or(0.0));
    solve(matrix, &mut right).unwrap();
    (0..own.len()).map(|k| right[(size + k, 0)]).collect()
}

#[test]
fn forces_are_those_of_multipliers_and_keep_newtons_laws() {
    for friction in [0.0, 0.3, 0.7] {
        let assembly = block(InterfaceLaw::Rigid(Friction::Constant(friction)), 1.0);
        let steady = solved(&assembly).unwrap();
        assert!(steady.residual < 1e-12, "{}", steady.residual);
        let total: f64 = steady.points.iter().map(|point| point.normal_force).sum();
        assert!((total - 1e3).abs() < 1e-8, "{total}");
        let closed: Vec<bool> = steady.points.iter().map(|point| point.is_closed).collect();
        let other = by_multipliers(&assembly, friction, &closed);
        let own = steady.points.iter().filter(|point| point.is_closed);
        for (own, other) in own.zip(&other) {
            assert!((own.normal_force - other).abs() < 1e-9 * total, "{} {other}", own.normal_force);
        }
        for point in &steady.points {
            assert!(point.gap >= -1e-18 && point.normal_force >= 0.0);
            assert!(point.is_closed || point.normal_force == 0.0);
            assert_eq!(point.friction_force, friction * point.normal_force);
        }
    }
}

#[test]
fn mirrored_velocity_mirrors_the_forces() {
    let forces = |speed| {
        let steady = solved(&block(InterfaceLaw::Rigid(Friction::Constant(0.6)), speed)).unwrap();
        steady.points.iter().map(|point| point.normal_force).collect::<Vec<_>>()
    };
    let (right, mut left) = (forces(1.0), forces(-1.0));
    left.reverse();
    for (a, b) in right.iter().zip(&left) {
        assert!((a - b).abs() < 1e-9, "{a} {b}");
    }
    // and with friction they are not their own mirror
    assert!((right[0] - right[12]).abs() > 1.0);
}

/// A block that leans and stands on cells of unlike length, and its mirror image that slides the other way.
#[test]
fn mirrored_geometry_mirrors_the_forces() {
    let leaning = |[x, y, z]: [f64; 3]| [x + 0.3 * y - 0.002 * (x / 0.04 * std::f64::consts::PI).sin(), y, z];
    let mirrored = |[x, y, z]: [f64; 3]| [0.04 - leaning([0.04 - x, y, z])[0], y, z];
    let law = || InterfaceLaw::Rigid(Friction::Constant(0.6));
    let forces = |assembly: &Assembly| {
        let steady = solved(assembly).unwrap();
        steady.points.iter().map(|point| [point.normal_force, point.friction_force]).collect::<Vec<_>>()
    };
    let own = forces(&shaped(law(), Sliding::Translation([1.0, 0.0, 0.0]), leaning));
    let mut image = forces(&shaped(law(), Sliding::Translation([-1.0, 0.0, 0.0]), mirrored));
    image.reverse();
    for (a, b) in own.iter().zip(&image) {
        assert!((a[0] - b[0]).abs() < 1e-8 && (a[1] - b[1]).abs() < 1e-8, "{a:?} {b:?}");
    }
    // sliding the same way it has other forces
    let mut other = forces(&shaped(law(), Sliding::Translation([1.0, 0.0, 0.0]), mirrored));
    other.reverse();
    assert!(own.iter().zip(&other).any(|(a, b)| (a[0] - b[0]).abs() > 1.0));
}

#[test]
fn a_stiff_interface_comes_near_a_rigid_one_with_its_stiffness() {
    let friction = 0.4;
    let rigid = solved(&block(InterfaceLaw::Rigid(Friction::Constant(friction)), 1.0)).unwrap();
    let mut last = f64::INFINITY;
    for stiffness in [1e13, 1e14, 1e15] {
        let law = InterfaceLaw::Compliant(Pressure::Stiffness(stiffness), Friction::Constant(friction));
        let soft = solved(&block(law, 1.0)).unwrap();
        assert!(soft.residual < 1e-11);
        let pairs = rigid.points.iter().zip(&soft.points);
        let off = pairs.map(|(a, b)| (a.normal_force - b.normal_force).abs()).fold(0.0, f64::max);
        assert!(off < 0.2 * last, "{off} after {last}");
        last = off;
    }
    assert!(last < 1.0, "{last}");
}

#[test]
fn without_friction_modes_neither_grow_nor_decay_and_with_it_some_lock_in() {
    let spectrum = |friction: f64| {
        let assembly = block(InterfaceLaw::Rigid(Friction::Constant(friction)), 1.0);
        let steady = solved(&assembly).unwrap();
        let about = Linearised::new(&assembly, &steady, LinearisedTerms::default()).unwrap();
        let region = Region { re: [-2e5, 2e5], im: [1.0, 5e5] };
        let found = complex_modes(&about.problem, &region, &ComplexModeSettings::default()).unwrap();
        assert!(found.complete());
        found.modes.iter().map(|mode| mode.eigenvalue).collect::<Vec<_>>()
    };
    let frictionless = spectrum(0.0);
    assert!(frictionless.len() > 4);
    assert!(frictionless.iter().all(|own| own.value.re.abs() <= own.error.max(1e-9 * own.value.im)));
    let with_friction = spectrum(0.6);
    assert!(with_friction.iter().any(|own| own.value.re > own.error), "{with_friction:?}");
}

/// A block that contacts alone hold, above the plane by more than springs would yield: it comes down and carries its load.
#[test]
fn what_is_above_the_plane_comes_down() {
    for law in [
        InterfaceLaw::Rigid(Friction::Constant(0.3)),
        InterfaceLaw::Compliant(Pressure::Stiffness(1e14), Friction::Constant(0.3)),
    ] {
        let mut assembly = block(law, 1.0);
        assembly.interfaces[0].points.iter_mut().for_each(|point| point.gap = 1e-3);
        let steady = solved(&assembly).unwrap();
        let total: f64 = steady.points.iter().map(|point| point.normal_force).sum();
        assert!((total - 1e3).abs() < 1e-6 && steady.residual < 1e-10, "{total} {}", steady.residual);
    }
}

#[test]
fn what_nothing_holds_and_what_pulls_off_are_told() {
    let mut pulled = block(InterfaceLaw::Rigid(Friction::Constant(0.2)), 1.0);
    pulled.load.iter_mut().for_each(|force| *force = -*force);
    // only the contact holds the block along y, and it does not pull
    let Err(AssemblyError::NothingCloses { interface, normal, opened, is_held, .. }) = solved(&pulled) else {
        panic!("it closes")
    };
    assert!(interface == "sole" && normal == [0.0, 1.0, 0.0] && opened > 0.0 && !is_held);
    let standing = block(InterfaceLaw::Rigid(Friction::Constant(0.2)), 0.0);
    assert!(matches!(solved(&standing), Err(AssemblyError::NoSlip { .. })));
}

/// Of the states that friction may hold on a track at rest it picks none by itself.
#[test]
fn a_track_at_rest_holds_nothing_until_it_is_asked_without_friction() {
    let resting = |friction: f64| {
        let law = InterfaceLaw::Rigid(Friction::Constant(friction));
        shaped(law, Sliding::Rest([3.0, 1.0, 0.0]), |place| place)
    };
    let rough = resting(0.3);
    let refused = |error| matches!(error, Err(AssemblyError::AtRest { interface }) if interface == "sole");
    assert!(refused(solved(&rough).map(drop)));
    let smooth = rough.without_friction_at_rest().unwrap();
    let steady = solved(&smooth).unwrap();
    assert!(refused(Linearised::new(&rough, &steady, LinearisedTerms::default()).map(drop)));
    assert!(steady.points.iter().all(|point| point.friction_force == 0.0));
    assert!((steady.points.iter().map(|point| point.normal_force).sum::<f64>() - 1e3).abs() < 1e-6);
    // without friction it does not matter whether the track moves
    let sliding = solved(&block(InterfaceLaw::Rigid(Friction::Constant(0.0)), 1.0)).unwrap();
    let resting = resting(0.0);
    assert!(resting.without_friction_at_rest().is_none());
    assert_eq!(solved(&resting).unwrap().points, sliding.points);
    let values = [(&resting, &steady), (&smooth, &steady)].map(|(assembly, steady)| {
        let about = Linearised::new(assembly, steady, LinearisedTerms::default()).unwrap();
        let region = Region { re: [-1e3, 1e3], im: [1.0, 3e5] };
        let found = complex_modes(&about.problem, &region, &ComplexModeSettings::default()).unwrap();
        found.modes.iter().map(|mode| mode.eigenvalue.value).collect::<Vec<_>>()
    });
    assert!(!values[0].is_empty() && values[0] == values[1]);
    // slip is reckoned along the contact
    let frame = resting.interfaces[0].points[0].frame("sole").unwrap();
    assert!(frame.speed == 0.0 && frame.slip.entries().len() == 1);
    let upright =
        shaped(InterfaceLaw::Rigid(Friction::Constant(0.2)), Sliding::Rest([0.0, 1.0, 0.0]), |place| place);
    assert!(matches!(solved(&upright), Err(AssemblyError::NoSlip { .. })));
}
