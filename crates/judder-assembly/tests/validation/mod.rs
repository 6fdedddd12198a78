//! Against closed forms and numbers that other programs print.

mod block;
mod third_law;
mod uniqueness;

use crate::common::{dense, diagonal, point_on_plane, rigid, undamped};
use faer::Mat;
use judder_assembly::AssemblyError;
use judder_assembly::compliance::Compliance;
use judder_assembly::friction::{FallingFriction, Friction, TableInterpolation};
use judder_assembly::interface::{Interface, InterfaceLaw};
use judder_assembly::linearised::{ContactTerm, Linearised, LinearisedTerms};
use judder_assembly::pressure::{ForceTable, Pressure};
use judder_assembly::steady::{FrictionLimit, PointState, SteadySliding, steady_sliding};
use judder_assembly::work::{Worker, growth_shares};
use judder_dense::general::solve;
use judder_structure::complex_modes::{ComplexModeSettings, Region, complex_modes};

/// ANSYS Verification Manual, VM274: a mass on a moving belt, free across the slip: friction damps it by ζ = μN/(2 v √(km)).
#[test]
fn friction_damps_a_mass_that_swings_across_the_slip() {
    let (mass, stiffness, force, friction, speed) = (8.0, 315.0, 1.0, 0.5, 10.0);
    // x along the belt is held, y presses, z is free on a spring
    let point = point_on_plane([None, Some(0), Some(1)], [speed, 0.0, 0.0]);
    let assembly = undamped(
        diagonal(&[mass, mass]),
        diagonal(&[stiffness, stiffness]),
        vec![-force, 0.0],
        vec![rigid(vec![point], friction)],
    );
    let steady = steady_sliding(&assembly, &Compliance::new(&assembly).unwrap()).unwrap();
    assert!((steady.points[0].normal_force - force).abs() < 1e-14 && steady.residual < 1e-14);
    let terms = LinearisedTerms::default();
    let about = Linearised::new(&assembly, &steady, terms).unwrap();
    let region = Region { re: [-1.0, 1.0], im: [1.0, 20.0] };
    let found = complex_modes(&about.problem, &region, &ComplexModeSettings::default()).unwrap();
    assert!(found.complete() && found.modes.len() == 1);
    let mode = &found.modes[0];
    let ratio = mode.eigenvalue.damping_ratio();
    assert!((ratio - 4.980_12e-4).abs() < 5e-10, "{ratio}");
    assert!((ratio - friction * force / (2.0 * speed * (stiffness * mass).sqrt())).abs() < 1e-12);
    // all of it is the work of the friction across the slip
    let shares = growth_shares(&about, mode.eigenvalue.value, &about.expanded(&mode.right)).unwrap().unwrap();
    let (worker, growth) = shares.shares.iter().max_by(|a, b| a.1.abs().total_cmp(&b.1.abs())).unwrap();
    assert_eq!(*worker, Worker::Contact(0, ContactTerm::FrictionAcrossSlip));
    assert!((growth - mode.eigenvalue.value.re).abs() < 1e-12);
    // steady sliding of other points and shapes on other freedoms are no panic
    let of_others = Linearised::new(&assembly, &SteadySliding::untouched(2), terms).unwrap_err();
    assert_eq!(of_others.to_string(), "the points of steady sliding: there are 0, but must be 1");
    let short = growth_shares(&about, mode.eigenvalue.value, &mode.right).unwrap_err();
    assert_eq!(short, AssemblyError::Length { name: "the freedoms of a shape", found: 1, expected: 2 });
}

/// A point that is held closed and pulls, rigid or on a spring, has the coupling of normal and friction forces, and no friction that follows speed or direction of the slip: pressed
/// as hard it has all of them.
#[test]
fn a_held_point_that_pulls_has_no_friction_that_follows_the_slip() {
    let falling = FallingFriction::exponential([0.4, 0.2], 1.0);
    let friction = Friction::Falling(falling);
    let spring = InterfaceLaw::Compliant(Pressure::PointStiffness(100.0), friction.clone());
    let terms = |law: &InterfaceLaw, load: f64| -> Vec<ContactTerm> {
        let point = point_on_plane([Some(0), Some(1), Some(2)], [1.0, 0.0, 0.0]);
        let held =
            Interface { name: "sole".to_owned(), points: vec![point], law: law.clone(), all_closed: true };
        let assembly = undamped(diagonal(&[1.0; 3]), diagonal(&[9.0; 3]), vec![0.0, load, 0.0], vec![held]);
        let steady = steady_sliding(&assembly, &Compliance::new(&assembly).unwrap()).unwrap();
        assert!(steady.points[0].is_closed && steady.points[0].normal_force * load < 0.0);
        let about = Linearised::new(&assembly, &steady, LinearisedTerms::default()).unwrap();
        about.contacts.iter().map(|contact| contact.term).collect()
    };
    let follows = [ContactTerm::FallingFriction, ContactTerm::FrictionAcrossSlip];
    let carries = [ContactTerm::NormalStiffness, ContactTerm::NormalTangentialCoupling];
    assert_eq!(terms(&InterfaceLaw::Rigid(friction.clone()), -2.0), follows);
    assert_eq!(terms(&InterfaceLaw::Rigid(friction), 2.0), []);
    assert_eq!(terms(&spring, -2.0), [carries, follows].concat());
    assert_eq!(terms(&spring, 2.0), carries);
}

/// A spring of one's own of 3 N/mm and 5 N/mm where it pulls, 2 N/mm and 6 N/mm where it is pressed, beside one of 1 N/mm: loads that bend it by whole mm.
#[test]
fn a_tabulated_spring_is_where_its_table_says() {
    let spring = ForceTable {
        closure: vec![-2e-3, -1e-3, 0.0, 1e-3, 2e-3],
        force: vec![-8.0, -3.0, 0.0, 2.0, 8.0],
        interpolation: TableInterpolation::Linear,
    };
    for (closure, force, slope) in
        [(-1.5e-3, -5.5, 5e3), (-0.5e-3, -1.5, 3e3), (0.5e-3, 1.0, 2e3), (3e-3, 14.0, 6e3)]
    {
        let point = point_on_plane([None, Some(0), None], [1.0, 0.0, 0.0]);
        let law = InterfaceLaw::Compliant(Pressure::PointTable(spring.clone()), Friction::Constant(0.0));
        let own = Interface { name: "spring".to_owned(), points: vec![point], law, all_closed: true };
        let load = -(force + 1e3 * closure);
        let assembly = undamped(diagonal(&[1.0]), diagonal(&[1e3]), vec![load], vec![own]);
        let steady = steady_sliding(&assembly, &Compliance::new(&assembly).unwrap()).unwrap();
        let PointState { normal_force, gap, .. } = steady.points[0];
        assert!(
            (normal_force - force).abs() < 1e-12 && (gap + closure).abs() < 1e-12,
            "{normal_force} {gap}"
        );
        // small motions have the slope of the piece
        let about = Linearised::new(&assembly, &steady, LinearisedTerms::default()).unwrap();
        let region = Region { re: [-1.0, 1.0], im: [1.0, 200.0] };
        let found = complex_modes(&about.problem, &region, &ComplexModeSettings::default()).unwrap();
        let frequency = found.modes[0].eigenvalue.value.im;
        assert!((frequency / f64::sqrt(1e3 + slope) - 1.0).abs() < 1e-9, "{frequency}");
    }
}

/// ANSYS Verification Manual, VM29: a block that can only move vertically is pushed down an incline of 20° by 100, μ = 0.3: N = 95.942,
/// T = 28.783.
#[test]
fn a_block_that_moves_vertically_slides_down_an_incline() {
    let (angle, friction): (f64, f64) = (20_f64.to_radians(), 0.3);
    let mut point = point_on_plane([None, Some(0), None], [0.0; 3]);
    point.normal = [angle.sin(), angle.cos(), 0.0];
    // the incline moves upwards along itself beside the block
    point.velocity = [-angle.cos(), angle.sin(), 0.0];
    let assembly =
        undamped(diagonal(&[1.0]), diagonal(&[0.0]), vec![-100.0], vec![rigid(vec![point], friction)]);
    let steady = steady_sliding(&assembly, &Compliance::new(&assembly).unwrap()).unwrap();
    let PointState { normal_force, friction_force, .. } = steady.points[0];
    assert!((normal_force - 95.942).abs() < 5e-4 && (friction_force - 28.783).abs() < 5e-4);
}

/// One point on a structure with K = (a, b; b, d): a unit normal force opens it by (a − μ b)/det K, so that sprag-slip begins at μ = a/b.
#[test]
fn sprag_slip_begins_where_friction_presses_as_hard_as_the_contact_pushes() {
    for (friction, expected) in [(0.5, 3.0), (3.0, 0.5)] {
        let assembly = undamped(
            diagonal(&[1.0, 1.0]),
            dense(&[&[3.0, 2.0], &[2.0, 5.0]]),
            vec![0.0, -1.0],
            vec![rigid(vec![point_on_plane([Some(0), Some(1), None], [1.0, 0.0, 0.0])], friction)],
        );
        let steady = steady_sliding(&assembly, &Compliance::new(&assembly).unwrap());
        match steady {
            Ok(steady) => {
                let FrictionLimit::At { friction: amount, point } = steady.friction_limit else {
                    panic!("{steady:?}")
                };
                let factor = amount.factor().unwrap();
                assert!(point == 0 && (factor - expected).abs() < 1e-12, "{factor}");
                assert!(friction == 0.5);
            }
            // beyond it no state presses: the point neither closes nor stays open
            Err(AssemblyError::NoSteadySliding {
                factor, coefficient, interface, point, digs_in, ..
            }) => {
                assert!(friction == 3.0 && (factor - expected).abs() < 1e-12, "{factor}");
                assert!((coefficient.unwrap() - 1.5).abs() < 1e-12 && point == 0 && digs_in);
                assert_eq!(interface, "sole");
            }
            Err(error) => panic!("{error}"),
        }
    }
}

/// Two points with A = I + μ F, F = (0, −2; −2, 1/2), of which loads open the first by one and press the second: N₂ = 1/(1 + μ/2), and its friction closes the first where 2 μ = 1 + μ/2.
/// Closed it would dig in: there is no state beyond μ = 2/3, although the forces are finite and no set of points becomes singular before.
#[test]
fn steady_sliding_may_end_where_a_point_closes() {
    let friction = [[0.0, -2.0], [-2.0, 0.5]];
    let compliance = |i: usize, j: usize| match (i / 2, j / 2) {
        (0, 0) if i == j => 1.0,
        (1, 1) if i == j => 10.0,
        (0, 1) | (1, 0) => friction[i % 2][j % 2],
        _ => 0.0,
    };
    let mut stiffness = Mat::from_fn(4, 4, |i, j| if i == j { 1.0 } else { 0.0 });
    solve(Mat::from_fn(4, 4, compliance), &mut stiffness).unwrap();
    let rows: Vec<Vec<f64>> = (0..4).map(|i| (0..4).map(|j| stiffness[(i, j)]).collect()).collect();
    let load: Vec<f64> = rows.iter().map(|row| row[0] - row[1]).collect();
    let matrix = dense(&rows.iter().map(Vec::as_slice).collect::<Vec<_>>());
    let points = [0, 1].map(|k| point_on_plane([Some(2 + k), Some(k), None], [1.0, 0.0, 0.0]));
    let with = |friction: f64| {
        let sole = rigid(points.to_vec(), friction);
        let assembly = undamped(diagonal(&[1.0; 4]), matrix.clone(), load.clone(), vec![sole]);
        steady_sliding(&assembly, &Compliance::new(&assembly).unwrap())
    };
    let closed =
        |steady: SteadySliding| steady.points.iter().map(|point| point.is_closed).collect::<Vec<_>>();
    assert_eq!(closed(with(0.66).unwrap()), [false, true]);
    let Err(AssemblyError::NoSteadySliding { factor, coefficient, point, digs_in, .. }) = with(0.8) else {
        panic!("there is a state")
    };
    assert!((factor - 2.0 / 2.4).abs() < 1e-8, "{factor}");
    assert!((coefficient.unwrap() - 2.0 / 3.0).abs() < 1e-8 && point == 0 && !digs_in);
}
