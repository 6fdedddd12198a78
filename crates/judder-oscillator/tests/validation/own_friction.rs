//! The mass on a belt with friction by a table: corners met as events, held against a smooth law, against differences and against a formula.

use judder_numerics::piecewise::{PiecewiseMarch, PiecewiseSmooth, StepSettings};
use judder_numerics::quadrature::gauss_legendre;
use judder_oscillator::cycle::return_map::{return_map, returned_state};
use judder_oscillator::cycle::shooting::{Cycle, Shooting, from_simulation, shoot};
use judder_oscillator::motion::attractor::Patience;
use judder_oscillator::motion::{BeltOscillator, ContactState, FallingFriction, Friction, SlidingSystem};

use judder_contact::table::TableInterpolation;

const SETTINGS: StepSettings<2> =
    StepSettings { relative: 1e-11, absolute: [1e-11; 2], longest_step: 1.0, steps: 1_000_000 };
const SHOOTING: Shooting<2> =
    Shooting { settings: SETTINGS, tolerance: 1e-9, iterations: 12, longest: 100.0 };

/// Friction that falls at the speed of the belt and rises beside it: the mass swings through two corners without sticking.
fn falling_between_rises(interpolation: TableInterpolation) -> BeltOscillator {
    let (speeds, coefficients) = (vec![0.0, 0.3, 0.5, 0.9], vec![0.28, 0.36, 0.33, 0.42]);
    let friction = Friction::table(speeds, coefficients, interpolation).unwrap();
    BeltOscillator::new(0.005, 1.0, 0.4, friction).unwrap()
}

fn cycle_of(system: &BeltOscillator, amplitude: f64) -> Cycle<2> {
    shoot(system, [system.steady_sliding()[0] + amplitude, 0.0], 1, &SHOOTING).unwrap()
}

/// A table that samples the exponential law of the literature at so many even steps has its stick-slip cycle; what is left falls with their square.
#[test]
fn a_table_that_samples_a_law_has_its_cycle() {
    let law = FallingFriction::exponential([1.0, 0.5], 0.5);
    let cycle = |friction: Friction| {
        let system = BeltOscillator::new(0.05, 1.0, 1.5, friction).unwrap();
        let found = from_simulation(&system, [1.0, 1.5], &SHOOTING, &Patience::default(), &|| false).unwrap();
        (found.period(), found.around.measures.rms(), found.fraction(ContactState::Stick))
    };
    let sampled = |steps: usize, interpolation| {
        let speeds: Vec<f64> = (0..=steps).map(|k| 4.0 * k as f64 / steps as f64).collect();
        let coefficients = speeds.iter().map(|speed| law.at(*speed).coefficient).collect();
        cycle(Friction::table(speeds, coefficients, interpolation).unwrap())
    };
    let exact = cycle(law.into());
    let error = |found: (f64, f64, f64)| (found.0 / exact.0 - 1.0).abs();
    let [coarse, fine] = [40, 80].map(|steps| sampled(steps, TableInterpolation::Linear));
    let order = (error(coarse) / error(fine)).log2();
    assert!((order - 2.0).abs() < 0.2, "{order}: {:e} {:e}", error(coarse), error(fine));
    assert!(
        error(fine) < 1e-3 && (fine.1 / exact.1 - 1.0).abs() < 1e-3 && (fine.2 / exact.2 - 1.0).abs() < 1e-2
    );
    let bent = sampled(40, TableInterpolation::Monotone);
    assert!(error(bent) < 0.1 * error(coarse), "{:e} {:e}", error(bent), error(coarse));
}

/// A corner at the very speed of the belt is met where x is largest: the motion returns there all the same.
#[test]
fn a_corner_at_the_speed_of_the_belt_hides_no_return() {
    let law = FallingFriction::exponential([1.0, 0.5], 0.5);
    let period = |speeds: Vec<f64>| {
        let coefficients = speeds.iter().map(|speed| law.at(*speed).coefficient).collect();
        let friction = Friction::table(speeds, coefficients, TableInterpolation::Monotone).unwrap();
        let system = BeltOscillator::new(0.05, 1.0, 1.5, friction).unwrap();
        let found = from_simulation(&system, [1.0, 1.5], &SHOOTING, &Patience::default(), &|| false).unwrap();
        assert!(found.trivial_error < 1e-6, "{:e}", found.trivial_error);
        found.period()
    };
    let even = |steps: usize| (0..=steps).map(|k| 4.5 * k as f64 / steps as f64).collect();
    // 1.5 is a speed of the first table, not of the second
    let (with, without) = (period(even(60)), period(even(61)));
    assert!((with / without - 1.0).abs() < 1e-5, "{with} {without}");
}

/// Of two states the product of the multipliers, one of which is 1, is exp ∮ −(2ξ + N μ′(|v|)) dt (N. H. Abel, J. Liouville); μ′ jumps at each
/// corner, where a step ends to the bit.
#[test]
fn the_multiplier_is_that_of_the_divergence_through_corners() {
    for (interpolation, amplitude) in
        [(TableInterpolation::Linear, 0.19), (TableInterpolation::Monotone, 0.28)]
    {
        let system = falling_between_rises(interpolation);
        let cycle = cycle_of(&system, amplitude);
        assert_eq!(cycle.around.pattern, [ContactState::SlipBehind]);
        assert_eq!(cycle.around.measures.changes, 0, "corners are no changes of the contact state");
        let mut march =
            PiecewiseMarch::new(&system, system.starting_mode(&cycle.start), cycle.start, SETTINGS).unwrap();
        let (mut divergence, mut corners) = (0.0, 0);
        while march.time() < cycle.period() {
            let advance = march.advance(cycle.period()).unwrap();
            if let Some(leg) = &advance.leg {
                for (node, weight) in gauss_legendre::<5>() {
                    divergence += weight * leg.step * system.jacobian(leg.mode, &leg.at(node))[1][1];
                }
            }
            if let Some(crossing) = advance.crossing {
                let velocities = [0.3, 0.5].map(|speed| 0.4 - speed);
                assert!(velocities.contains(&crossing.state[1]), "{crossing:?}");
                corners += 1;
            }
        }
        assert_eq!(corners, 4);
        let multiplier = cycle.largest_multiplier();
        assert!((multiplier / divergence.exp() - 1.0).abs() < 1e-6, "{multiplier} {}", divergence.exp());
        assert!(cycle.trivial_error < 1e-6, "{:e}", cycle.trivial_error);
    }
}

#[test]
fn the_derivative_of_the_return_is_that_of_differences() {
    for interpolation in [TableInterpolation::Linear, TableInterpolation::Monotone] {
        let system = falling_between_rises(interpolation);
        let start = [system.steady_sliding()[0] + 0.25, 0.0];
        let around = return_map(&system, start, 1, SETTINGS, 100.0).unwrap();
        let h = 1e-4;
        let [above, below] =
            [h, -h].map(|by| returned_state(&system, [start[0] + by, 0.0], 1, SETTINGS, 100.0).unwrap()[0]);
        let difference = (above - below) / (2.0 * h);
        assert!(
            (around.derivative[0][0] - difference).abs() < 1e-5,
            "{} {difference}",
            around.derivative[0][0]
        );
    }
}

/// Without damping and friction a mass on x + κ x³ swings with the period 4 K(m)/√(1 + κA²), m = κA²/(2(1 + κA²)), whose complete elliptic
/// integral is a mean of Gauss (Nayfeh, Mook, *Nonlinear Oscillations*, 1979, section 2.1).
#[test]
fn a_spring_that_stiffens_swings_with_the_period_of_duffing() {
    let system = BeltOscillator::new(0.0, 1.0, 1e3, Friction::Constant(0.0)).unwrap();
    for (cubic, amplitude) in [(0.0, 1.0), (0.5, 1.0), (2.0, 3.0)] {
        let system = system.clone().with_cubic_stiffness(cubic).unwrap();
        let bend: f64 = cubic * amplitude * amplitude;
        let m = 0.5 * bend / (1.0 + bend);
        let (mut a, mut b) = (1.0, (1.0 - m).sqrt());
        for _ in 0..8 {
            (a, b) = (0.5 * (a + b), f64::sqrt(a * b));
        }
        let period = 4.0 * std::f64::consts::FRAC_PI_2 / a / (1.0 + bend).sqrt();
        let around = return_map(&system, [amplitude, 0.0], 1, SETTINGS, 100.0).unwrap();
        assert!((around.time / period - 1.0).abs() < 1e-8, "{} {period}", around.time);
        assert!((around.state[0] / amplitude - 1.0).abs() < 1e-8);
    }
    assert!(system.with_cubic_stiffness(-0.1).is_err());
}

/// On a spring that stiffens friction is borne at the root of x + κ x³ = N μ(v), and the derivative of the stick-slip return is that of differences.
#[test]
fn steady_sliding_on_a_spring_that_stiffens() {
    let law = FallingFriction::exponential([1.0, 0.5], 0.5);
    let system = BeltOscillator::new(0.05, 1.0, 1.5, law).unwrap().with_cubic_stiffness(4.0).unwrap();
    let [x, _] = system.steady_sliding();
    assert!((x + 4.0 * x.powi(3) - law.at(1.5).coefficient).abs() < 1e-14);
    let start = [x + 0.3, 0.0];
    let around = return_map(&system, start, 1, SETTINGS, 100.0).unwrap();
    let moved = |by: f64| returned_state(&system, [start[0] + by, 0.0], 1, SETTINGS, 100.0).unwrap()[0];
    let difference = (moved(1e-4) - moved(-1e-4)) / 2e-4;
    assert!((around.derivative[0][0] - difference).abs() < 1e-5, "{} {difference}", around.derivative[0][0]);
}
