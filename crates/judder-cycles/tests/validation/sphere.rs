//! A sphere on rubber that two springs carry, as an assembly: its cycles against those of the engine of the oscillator.

use super::own_engine::{Known, known, off_nearest, order, settled, shooting, told, worst};
use crate::common::{assembly, dense, diagonal, point_on_plane};
use faer::c64;
use judder_assembly::assembly::Assembly;
use judder_assembly::compliance::Compliance;
use judder_assembly::interface::{Asperity, ForceAt, InterfaceLaw, PointForces};
use judder_assembly::linearised::{Linearised, LinearisedTerms};
use judder_assembly::steady::{SteadySliding, steady_sliding};
use judder_contact::{FittedLaw, Law};
use judder_cycles::cycle::{AssemblyCycle, CycleSettings, HarmonicCount, limit_cycles};
use judder_cycles::shooting::{ShootingSettings, shoot};
use judder_cycles::stability::{
    HILL_ROWS, HillMultipliers, floquet_multipliers, hill_multipliers, shot_multipliers,
};
use judder_oscillator::critical::{ParameterRange, RangeScale, thresholds};
use judder_oscillator::cycle::{BranchPoint, Continuation, global_margin};
use judder_oscillator::motion::{ContactState, SlidingSystem, StickSlip};
use judder_oscillator::sphere::{SlidingSphere, SphereForce};
use judder_oscillator::{Coefficients, Contact, FrictionLoad, Groups};
use judder_structure::complex_modes::{ComplexModeSettings, Region, complex_modes};
use std::f64::consts::TAU;
use std::sync::Arc;

#[derive(Debug)]
struct OnRubber(SlidingSphere);

impl Asperity for OnRubber {
    fn forces(&self, closure: f64, speed: f64) -> PointForces {
        let own = self.0.forces(closure, speed);
        let at =
            |own: SphereForce| ForceAt { value: own.value, by_closure: own.by_depth, by_speed: own.by_speed };
        PointForces { normal: at(own.normal), friction: at(own.friction) }
    }
}

fn contact() -> Contact {
    Contact { law: Law::Fitted(FittedLaw::oscillator_paper()), friction_load: FrictionLoad::ContactForce }
}

/// A load and a speed, and the shear strength at which steady sliding loses its stability.
struct Operation {
    groups: Groups,
    threshold: f64,
}

impl Operation {
    fn at(normal_load: f64, velocity: f64) -> Self {
        let groups = Groups { normal_load, velocity, ..Groups::default() };
        let range = ParameterRange { from: 1e-4, to: 1.0, scale: RangeScale::Logarithmic };
        let of = |shear_strength| Groups { shear_strength, ..groups }.resolve();
        Self { groups, threshold: thresholds(&contact(), &range, 200, of).full[0] }
    }

    fn oscillator(&self, shear_strength: f64) -> StickSlip {
        StickSlip::new(contact(), Groups { shear_strength, ..self.groups }.resolve()).unwrap()
    }
}

/// (12) in its own units, with the height −ỹ of the sphere as the second freedom.
fn carried(c: &Coefficients) -> Assembly {
    let radius = c.radius();
    let sphere = SlidingSphere {
        contact: contact(),
        // so that F_n is one
        reduced_modulus: 1.0 / (c.normal_load * radius * radius),
        radius,
        retardation_time: c.retardation_time,
        normal_load: c.normal_load,
        shear_strength: c.shear_strength,
    };
    let stiffness = dense(&[vec![c.k11, -c.k12], vec![-c.k12, c.k22]]);
    assembly(
        [diagonal(&[1.0; 2]), diagonal(&[c.damping_x, c.damping_y]), stiffness],
        vec![0.0, -1.0],
        vec![point_on_plane(&[0, 1], c.belt_velocity(), 0.0)],
        InterfaceLaw::Asperity(Arc::new(OnRubber(sphere))),
    )
}

/// Steady sliding, and the eigenvalue about it that turns most slowly.
fn slowest(case: &Assembly) -> (SteadySliding, c64) {
    let steady = steady_sliding(case, &Compliance::new(case).unwrap()).unwrap();
    let about = Linearised::new(case, &steady, LinearisedTerms::default()).unwrap();
    let region = Region { re: [-1.0, 1.0], im: [0.1, 10.0] };
    let found = complex_modes(&about.problem, &region, &ComplexModeSettings::default()).unwrap();
    let values = found.modes.iter().map(|mode| mode.eigenvalue.value);
    let slowest = values.min_by(|a, b| a.im.total_cmp(&b.im)).unwrap();
    (steady, c64::new(slowest.re, slowest.im))
}

fn with<'a>(
    case: &'a Assembly,
    (steady, eigenvalue): &(SteadySliding, c64),
    harmonics: usize,
    samples: usize,
) -> AssemblyCycle<'a> {
    let settings =
        CycleSettings { harmonics: HarmonicCount::Fixed(harmonics), samples, ..CycleSettings::default() };
    let found = limit_cycles(case, steady, *eigenvalue, &settings, &|| true).unwrap();
    let cycle = found.cycles.into_iter().next().unwrap();
    assert!(cycle.held_back.is_none() && cycle.balance.series().harmonics() == harmonics);
    cycle
}

/// Errors of the period, of x and of y, of so many harmonics and samples a harmonic.
fn errors(case: &Assembly, expected: &Known, counts: &[[usize; 2]]) -> Vec<Vec<f64>> {
    let mode = slowest(case);
    let of = |&[harmonics, samples]: &[usize; 2]| {
        let errors = expected.errors(&with(case, &mode, harmonics, samples));
        println!("{harmonics} × {samples}: {}", told(&errors));
        errors
    };
    counts.iter().map(of).collect()
}

/// By how much the multipliers of Hill's method, that of the phase among them, are off those of the engine.
fn off_engine(hill: &HillMultipliers, expected: &[c64]) -> f64 {
    let all: Vec<c64> = hill.phase.iter().chain(&hill.values).copied().collect();
    off_nearest(expected, &all)
}

/// Where the sphere neither sticks nor lifts off its forces are analytic, and the error falls exponentially.
#[test]
fn a_sphere_that_slides_on_has_the_cycle_of_the_oscillator_to_all_digits() {
    let operation = Operation::at(7.5e-4, 4e-4);
    let system = operation.oscillator(1.1 * operation.threshold);
    let mut start = system.steady_sliding();
    start[0] *= 1.05;
    let own = settled(&system, start);
    assert_eq!(own.around.pattern, [ContactState::SlipBehind]);
    let case = carried(system.coefficients());
    let found = errors(&case, &known(&system, &own), &[[4, 16], [8, 16], [12, 16], [16, 16], [20, 16]]);
    let worst: Vec<f64> = found.iter().map(|own| worst(own)).collect();
    assert!(worst[1] < 5e-6 && worst[2] < 1e-6 && worst[4] < 1e-11, "{worst:?}");
    assert!(worst.windows(2).all(|pair| pair[1] < 0.1 * pair[0]), "{worst:?}");
}

/// Hill's method, whose error falls exponentially too.
#[test]
fn a_sphere_that_slides_on_has_the_multipliers_of_the_oscillator_by_hills_method() {
    let operation = Operation::at(7.5e-4, 4e-4);
    let system = operation.oscillator(1.1 * operation.threshold);
    let mut start = system.steady_sliding();
    start[0] *= 1.05;
    let own = settled(&system, start);
    let case = carried(system.coefficients());
    let mode = slowest(&case);
    let off = [8, 12, 16, 20].map(|harmonics| {
        let cycle = with(&case, &mode, harmonics, 16);
        let hill = hill_multipliers(&cycle.balance, &cycle.motion, HILL_ROWS, &|| true).unwrap().unwrap();
        off_engine(&hill, &own.multipliers)
    });
    assert!(off[3] < 1e-8, "{off:?}");
    assert!(off[1] < 0.1 * off[0] && off[2] < 0.1 * off[1], "{off:?}");
}

/// A cycle of the branch from the threshold that is in the air for a third of the time.
fn lifting(operation: &Operation) -> BranchPoint<4> {
    let options = Continuation {
        shooting: shooting(&operation.oscillator(operation.threshold)),
        range: (1e-3, 1.0),
        steps: (0.01, 0.2),
        points: 100,
        parameter_scale: operation.threshold,
    };
    let at = |shear_strength: f64| Ok(operation.oscillator(shear_strength));
    let branch = global_margin(&at, operation.threshold, -1.0, &options).unwrap().branch.unwrap();
    branch.points.into_iter().find(|point| point.cycle.fraction(ContactState::LiftOff) > 0.3).unwrap()
}

/// Slopes jump where it lifts off, which sums over instants place between two of them.
#[test]
fn a_sphere_that_lifts_off_has_nearly_the_multipliers_of_the_oscillator_by_hills_method() {
    let operation = Operation::at(1e-6, 1e-2);
    let lifts = lifting(&operation);
    let case = carried(operation.oscillator(lifts.parameter).coefficients());
    let mode = slowest(&case);
    for (samples, enough) in [(16, 5e-3), (64, 1e-3), (256, 5e-4)] {
        let cycle = with(&case, &mode, 20, samples);
        let hill = hill_multipliers(&cycle.balance, &cycle.motion, HILL_ROWS, &|| true).unwrap().unwrap();
        let off = off_engine(&hill, &lifts.cycle.multipliers);
        assert!(off < enough && off < 1.5 * hill.error, "{samples}: {off:e} {hill:?}");
    }
}

/// By how much the multipliers of the sphere that lifts off are off those of the oscillator with so many harmonics, by steps that are parted where it lifts off and
/// comes back and whose error of second order is taken off: what is left is that of the cycle, which falls as H⁻⁴.
fn off_by_parted_steps<const N: usize>(counts: [usize; N]) -> [f64; N] {
    let operation = Operation::at(1e-6, 1e-2);
    let lifts = lifting(&operation);
    let case = carried(operation.oscillator(lifts.parameter).coefficients());
    let mode = slowest(&case);
    let off = counts.map(|harmonics| {
        let cycle = with(&case, &mode, harmonics, 16384 / harmonics);
        let found = floquet_multipliers(&cycle.balance, &cycle.motion, &|| true).unwrap().unwrap();
        let all: Vec<c64> = found.phase.iter().chain(&found.values).copied().collect();
        let off = off_nearest(&lifts.cycle.multipliers, &all);
        println!("{harmonics}: {off:.1e} in {} steps, told {:.1e}", found.steps, found.error);
        assert!(off < 1.5 * found.error, "{harmonics}: {off:e} {found:?}");
        off
    });
    let found = order([(counts[0], off[0]), (counts[N - 1], off[N - 1])]);
    println!("order from {} to {} harmonics: {found:.2}", counts[0], counts[N - 1]);
    assert!((3.0..5.0).contains(&found), "{off:?}");
    off
}

#[test]
fn a_sphere_that_lifts_off_has_the_multipliers_of_the_oscillator_by_steps() {
    let off = off_by_parted_steps([7, 14]);
    assert!(off[1] < 5e-5, "{off:?}");
}

#[test]
#[ignore = "expensive: forty harmonics at sixteen thousand instants"]
fn a_sphere_that_lifts_off_has_the_multipliers_of_the_oscillator_to_six_digits() {
    let off = off_by_parted_steps([10, 20, 40]);
    assert!(off[2] < 1e-6, "{off:?}");
}

/// Where it lifts off its normal force goes with y^{3/2} and its friction with its area, with y: friction has a kink. Its harmonics fall as h⁻², those of what
/// the motion makes of a force as h⁻³, so that what H harmonics leave out falls as H⁻⁴; sums over N instants have the error of a kink, N⁻².
#[test]
fn a_sphere_that_lifts_off_has_the_cycle_of_the_oscillator_with_enough_instants() {
    let operation = Operation::at(1e-6, 1e-2);
    let lifts = lifting(&operation);
    assert_eq!(lifts.cycle.fraction(ContactState::Stick), 0.0);
    let system = operation.oscillator(lifts.parameter);
    let expected = known(&system, &lifts.cycle);
    let case = carried(system.coefficients());
    const MANY: usize = 16384;
    let counts = [4, 5, 7, 10, 14];
    let found = errors(&case, &expected, &counts.map(|harmonics| [harmonics, MANY / harmonics]));
    let of: Vec<f64> = found.iter().map(|own| worst(own)).collect();
    assert!(of[3] < 1e-6 && of[4] < 5e-7, "{of:?}");
    let found = order([(counts[1], of[1]), (counts[4], of[4])]);
    println!("order from {} to {} harmonics: {found:.2}", counts[1], counts[4]);
    assert!((3.5..4.5).contains(&found), "{of:?}");
    let counts = [[20, 16], [20, 32], [20, 64], [20, 128], [20, 256]];
    for ([harmonics, samples], own) in counts.iter().zip(errors(&case, &expected, &counts)) {
        let instants = (harmonics * samples) as f64;
        assert!(worst(&own) < 40.0 / (instants * instants), "{samples}: {own:?}");
    }
}

/// Where it sticks friction jumps as it is caught, and its velocity has a kink, of which H harmonics leave H^{−3/2} out in the mean square. The march that comes back
/// is off by so much a step, of first order, so that two of them tell what is left without steps.
#[test]
fn a_sphere_that_sticks_has_the_cycle_of_the_oscillator_by_a_march() {
    let operation = Operation::at(7.5e-4, 4e-4);
    let system = operation.oscillator(1.3 * operation.threshold);
    let mut start = system.steady_sliding();
    start[0] *= 1.05;
    let own = settled(&system, start);
    assert!(own.fraction(ContactState::Stick) > 0.2, "{:?}", own.around.pattern);
    let expected = known(&system, &own);
    let case = carried(system.coefficients());
    let counts = [10, 20, 40, 80, 160];
    let found = errors(&case, &expected, &counts.map(|harmonics| [harmonics, 32]));
    for (harmonics, own) in counts.into_iter().zip(&found) {
        assert!(worst(own) < 1.5 * (harmonics as f64).powf(-1.5), "{harmonics}: {own:?}");
    }
    let near = with(&case, &slowest(&case), 40, 16);
    let [few, many] = [8192, 16384].map(|steps| {
        let settings = ShootingSettings { steps, ..ShootingSettings::default() };
        let shot = shoot(&case, &near.balance, &near.motion, &settings, &|| true).unwrap();
        let velocity = shot.statistics.of(0).unwrap().tangential_velocity_rms;
        [TAU / shot.frequency / expected.period - 1.0, velocity / expected.rms[2] - 1.0]
    });
    let left = [0, 1].map(|k| 2.0 * many[k] - few[k]);
    println!("march: {}", told(&[few, many, left].concat()));
    assert!([0, 1].iter().all(|k| (few[*k] / many[*k] - 2.0).abs() < 0.01), "{few:?} {many:?}");
    assert!(worst(&left) < 1e-6, "{left:?}");
}

/// By how much the multipliers of the same cycle along the march are off with so many steps, of which those of half and a quarter are taken: what is left falls with their square.
/// One of them is that of the phase, and one is none, as whatever differs is caught.
fn off_along_the_march<const N: usize>(counts: [usize; N]) -> [f64; N] {
    let operation = Operation::at(7.5e-4, 4e-4);
    let system = operation.oscillator(1.3 * operation.threshold);
    let mut start = system.steady_sliding();
    start[0] *= 1.05;
    let own = settled(&system, start);
    let case = carried(system.coefficients());
    let near = with(&case, &slowest(&case), 40, 16);
    let off = counts.map(|steps| {
        let settings = ShootingSettings { steps, tolerance: 1e-9, ..ShootingSettings::default() };
        let shot = shoot(&case, &near.balance, &near.motion, &settings, &|| true).unwrap();
        let of = ((&near.balance, &near.motion), (&shot, &settings));
        let found = shot_multipliers(&case, of.0, of.1, &|| true).unwrap().unwrap();
        let all: Vec<c64> = found.phase.iter().chain(&found.values).copied().collect();
        let off = off_nearest(&own.multipliers, &all);
        println!("{steps}: {off:.1e}, told {:.1e}", found.error);
        assert!(off < found.error && found.values[2].norm() < 1e-12, "{off:e} {found:?}");
        off
    });
    let found = order([(counts[0], off[0]), (counts[N - 1], off[N - 1])]);
    println!("order from {} to {} steps: {found:.2}", counts[0], counts[N - 1]);
    assert!((1.5..2.5).contains(&found), "{off:?}");
    off
}

#[test]
fn a_sphere_that_sticks_has_the_multipliers_of_the_oscillator_by_a_march() {
    let off = off_along_the_march([2048, 8192]);
    assert!(off[1] < 1e-4, "{off:?}");
}

#[test]
#[ignore = "expensive: sixty thousand steps"]
fn a_sphere_that_sticks_has_the_multipliers_of_the_oscillator_by_a_long_march() {
    let off = off_along_the_march([8192, 16384, 32768, 65536]);
    assert!(off[3] < 1e-6, "{off:?}");
}
