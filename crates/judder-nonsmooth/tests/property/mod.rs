//! What holds for every assembly.

mod random;

use crate::common::{IMPLICIT, assembly, coulomb, dense, diagonal, implicit, point_on_plane, settings};
use judder_assembly::assembly::Assembly;
use judder_assembly::friction::{FallingFriction, Friction};
use judder_assembly::interface::InterfaceLaw;
use judder_assembly::pressure::Pressure;
use judder_nonsmooth::contact_problem::{
    ContactSolution, Delassus, FrictionCondition, ImpulseProblem, NormalCondition,
};
use judder_nonsmooth::course::{Course, TimeFactor, TimeTable};
use judder_nonsmooth::excitation::{BandNoise, DrivingSignal, Excitation, FrequencySweep};
use judder_nonsmooth::gauss_seidel::{ContactAccuracy, solve};
use judder_nonsmooth::march::NonsmoothMarch;
use judder_nonsmooth::newton::newton;
use judder_nonsmooth::scheme::ContactScheme;
use proptest::prelude::*;

/// A Aᵀ + least of random numbers.
fn definite(numbers: &[f64], size: usize, least: f64) -> Vec<Vec<f64>> {
    let at = |i: usize, j: usize| numbers[(i * size + j) % numbers.len()];
    let entry = |i: usize, j: usize| (0..size).map(|k| at(i, k) * at(j, k)).sum::<f64>();
    (0..size).map(|i| (0..size).map(|j| entry(i, j) + if i == j { least } else { 0.0 }).collect()).collect()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, ..ProptestConfig::default() })]

    /// Sweeps and Newton's method find the same impulses, in the plane and in space, and these complement the velocities.
    #[test]
    fn both_solvers_agree(
        numbers in prop::collection::vec(-1.0..1.0_f64, 101),
        free in prop::collection::vec(-1.0..1.0_f64, 12),
        friction in 0.0..0.6_f64,
        dimension in 2_usize..=3,
    ) {
        let size = 12;
        let points = size / dimension;
        let matrix = definite(&numbers, size, 2.0);
        let delassus = Delassus::new(dimension, matrix.concat());
        let normal = vec![NormalCondition::Unilateral { velocity: 0.0, softness: 0.0 }; points];
        let law = Friction::Constant(friction);
        let friction = vec![FrictionCondition::Law { law: &law, factor: 1.0 }; points];
        let problem =
            ImpulseProblem { delassus: &delassus, free: &free, normal: &normal, friction: &friction, scale: 1.0 };
        let accuracy = ContactAccuracy { tolerance: 1e-12, sweeps: 10_000 };
        let mut swept = ContactSolution::none(&delassus);
        let progress = solve(&problem, accuracy, &mut swept);
        prop_assert!(progress.residual <= 1e-12, "{progress:?}");
        let mut stepped = ContactSolution::none(&delassus);
        let progress = newton(&problem, 1e-12, &mut stepped);
        prop_assert!(progress.residual <= 1e-12, "{progress:?}");
        for (a, b) in swept.impulse.iter().zip(&stepped.impulse) {
            prop_assert!((a - b).abs() < 1e-9, "{a} {b}");
        }
        for point in 0..points {
            let own = |values: &[f64], k: usize| if k < dimension { values[point * dimension + k] } else { 0.0 };
            let (n, u) = (own(&swept.impulse, 0), own(&swept.velocity, 0));
            prop_assert!(n >= 0.0 && u > -1e-9 && n * u < 1e-9);
            let size = own(&swept.impulse, 1).hypot(own(&swept.impulse, 2));
            let Friction::Constant(coefficient) = law else { unreachable!() };
            prop_assert!(size <= coefficient * n + 1e-9);
            let power = own(&swept.impulse, 1) * own(&swept.velocity, 1) + own(&swept.impulse, 2) * own(&swept.velocity, 2);
            prop_assert!(power <= 1e-9);
        }
    }
}

fn random_assembly(numbers: &[f64], friction: InterfaceLaw, space: bool) -> Assembly {
    let nodes = 4;
    let each = if space { 3 } else { 2 };
    let size = nodes * each;
    let stiffness: Vec<Vec<f64>> = definite(numbers, size, 1.0)
        .into_iter()
        .map(|row| row.into_iter().map(|value| 1e4 * value).collect())
        .collect();
    let damping: Vec<Vec<f64>> =
        stiffness.iter().map(|row| row.iter().map(|value| 2e-5 * value).collect()).collect();
    let mut load = vec![0.0; size];
    (0..nodes).for_each(|node| load[node * each + 1] = -30.0);
    let point = |node: usize| {
        let first = node * each;
        point_on_plane(&(first..first + each).collect::<Vec<_>>(), 0.2, 1e-4 * numbers[node].abs())
    };
    assembly(
        [diagonal(&vec![1.0; size]), dense(&damping), dense(&stiffness)],
        load,
        (0..3).map(point).collect(),
        friction,
    )
}

/// A track that slows down, turns round and stands, a load that rises, friction that goes up and down.
fn course() -> Course {
    let table = |values: &[f64]| {
        let times = (0..values.len()).map(|k| 0.1 * k as f64).collect();
        TimeFactor::Table(TimeTable { times, values: values.to_vec() })
    };
    Course {
        speed: table(&[1.0, -0.5, 0.0]),
        load: TimeFactor::Rise(0.15),
        friction: vec![table(&[1.0, 0.3, 1.2, 0.9]), TimeFactor::Constant(1.1)],
    }
}

/// One signal of each kind, on all freedoms.
fn excitations(size: usize) -> Vec<Excitation> {
    let samples = TimeTable { times: vec![0.0, 0.1, 0.4], values: vec![0.0, 4.0, -3.0] };
    let signals = [
        DrivingSignal::Sine { amplitude: 5.0, angular_frequency: 300.0, phase: 1.0 },
        DrivingSignal::Sweep(FrequencySweep {
            amplitude: 3.0,
            from: 20.0,
            to: 900.0,
            duration: 0.3,
            is_logarithmic: true,
        }),
        DrivingSignal::Random(BandNoise::new(2.0, [100.0, 2000.0], 5)),
        DrivingSignal::Samples(samples),
    ];
    let forces = |number: usize| (0..size).map(|k| ((number + 2 * k) as f64).sin()).collect();
    signals.into_iter().enumerate().map(|(k, signal)| Excitation { signal, forces: forces(k) }).collect()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, ..ProptestConfig::default() })]

    /// The energy of the bodies changes by what the account says, contact gives none, and no point is pressed into the track.
    #[test]
    fn the_balance_of_energy_closes(
        numbers in prop::collection::vec(-1.0..1.0_f64, 150),
        space in any::<bool>(),
        which in 0_usize..4,
        law in 0_usize..3,
        is_driven in any::<bool>(),
    ) {
        let scheme = [IMPLICIT, ContactScheme::ForwardIncrement, implicit(0.7), implicit(1.0)][which];
        let falling = FallingFriction::exponential([0.5, 0.2], 0.3);
        let law = match law {
            0 => coulomb(0.4),
            1 => InterfaceLaw::Rigid(Friction::Falling(falling)),
            _ => InterfaceLaw::Compliant(Pressure::PointStiffness(1e5), Friction::Constant(0.4)),
        };
        let is_rigid = matches!(law, InterfaceLaw::Rigid(_));
        let case = random_assembly(&numbers, law, space);
        let mut march = NonsmoothMarch::new(&case, &[], settings(scheme, 1e-4)).unwrap();
        march.set_force_scale(30.0);
        if is_driven {
            march.follow(course(), &excitations(case.size())).unwrap();
        }
        march.start(&vec![0.0; case.size()], &vec![0.0; case.size()]);
        // of the course's factors of friction
        let most = if is_driven { 1.32 } else { 1.0 };
        let first = march.energy();
        let mut exchanged = 0.0_f64;
        for _ in 0..3000 {
            march.advance().unwrap();
            let works = march.works();
            exchanged = exchanged.max(works.friction.abs()).max(works.normal.abs()).max(works.excitation.abs());
            for point in 0..3 {
                let [normal, along, across] = march.force(point);
                prop_assert!(normal >= 0.0);
                prop_assert!(along.hypot(across) <= 0.5001 * most * normal + 1e-9);
            }
        }
        prop_assert_eq!(march.record().unsolved, 0);
        let (last, works) = (march.energy(), march.works());
        let gained = last.kinetic + last.potential - first.kinetic - first.potential;
        let told: f64 = works.parts().iter().sum();
        prop_assert!((gained - told).abs() < 1e-9 * (exchanged + gained.abs()), "{gained} {told} of {exchanged}");
        prop_assert!(works.heat >= -1e-12 && works.damping <= 0.0);
        prop_assert!(if which < 2 { works.scheme == 0.0 } else { works.scheme < 0.0 }, "{}", works.scheme);
        prop_assert_eq!(works.excitation != 0.0, is_driven);
        if is_rigid && scheme != ContactScheme::ForwardIncrement {
            prop_assert!(works.normal <= 1e-12, "{}", works.normal);
        }
    }
}

/// Modes of all bodies and their whole matrices give the same motion.
#[test]
fn coordinates_do_not_matter() {
    let numbers: Vec<f64> = (0..150).map(|k| (1.7 * f64::from(k) + 0.3).sin()).collect();
    for scheme in [IMPLICIT, implicit(0.8), ContactScheme::ForwardIncrement] {
        let modal = random_assembly(&numbers, coulomb(0.4), true);
        // so little gyroscopic force that nothing feels it, but the modes are not taken then
        let mut whole = modal.clone();
        whole.gyroscopic = vec![judder_assembly::assembly::Gyroscopic {
            body: "none".to_owned(),
            matrix: diagonal(&vec![0.0; whole.size()]).into(),
        }];
        let mut marches = [&modal, &whole].map(|case| {
            let mut march = NonsmoothMarch::new(case, &[], settings(scheme, 1e-4)).unwrap();
            march.set_force_scale(30.0);
            march.follow(course(), &excitations(case.size())).unwrap();
            march.start(&vec![0.0; case.size()], &vec![0.0; case.size()]);
            march
        });
        assert!(marches[0].is_modal() && !marches[1].is_modal());
        for _ in 0..500 {
            marches.iter_mut().for_each(|march| march.advance().unwrap());
        }
        let [a, b] = marches.each_ref().map(|march| march.works().scheme);
        assert!((a - b).abs() < 1e-9 * (1e-3 + a.abs()), "{scheme:?}: {a} {b}");
        let [a, b] = marches.each_ref().map(|march| march.state()[0].clone());
        for (a, b) in a.iter().zip(&b) {
            assert!((a - b).abs() < 1e-9 * (1e-3 + a.abs()), "{scheme:?}: {a} {b}");
        }
    }
}

/// A step takes no memory.
#[test]
fn a_step_allocates_nothing() {
    let numbers: Vec<f64> = (0..150).map(|k| (1.7 * f64::from(k) + 0.3).sin()).collect();
    let case = random_assembly(&numbers, coulomb(0.4), true);
    for scheme in [IMPLICIT, ContactScheme::ForwardIncrement, ContactScheme::Smoothed] {
        let mut march = NonsmoothMarch::new(&case, &[], settings(scheme, 1e-4)).unwrap();
        march.set_force_scale(30.0);
        march.follow(course(), &excitations(case.size())).unwrap();
        march.start(&vec![0.0; case.size()], &vec![0.0; case.size()]);
        let counted = allocation_counter::measure(|| {
            (0..1000).for_each(|_| march.advance().unwrap());
        });
        assert_eq!(counted.count_total, 0, "{scheme:?}");
    }
}
