//! The mass on a belt with falling friction of the literature: μ = 0.5 + 0.5 e^{−v/0.5}, ξ = 0.05, N = 1.

use judder_numerics::piecewise::{PiecewiseMarch, StepSettings};
use judder_oscillator::cycle::shooting::Shooting;
use judder_oscillator::cycle::{Continuation, global_margin};
use judder_oscillator::motion::{BeltOscillator, ContactState, FallingFriction, SlidingSystem};

pub(crate) fn belt(velocity: f64) -> BeltOscillator {
    BeltOscillator::new(0.05, 1.0, velocity, FallingFriction::exponential([1.0, 0.5], 0.5)).unwrap()
}

fn settings(tolerance: f64) -> StepSettings<2> {
    StepSettings { relative: tolerance, absolute: [tolerance; 2], longest_step: 1.0, steps: 1_000_000 }
}

/// Whether a motion that starts with a stick still sticks after a long time.
fn keeps_sticking(velocity: f64) -> bool {
    let oscillator = belt(velocity);
    let start = [1.0, velocity];
    let mut march =
        PiecewiseMarch::new(&oscillator, oscillator.starting_mode(&start), start, settings(1e-10)).unwrap();
    let mut last_stick = 0.0;
    while march.time() < 400.0 {
        let advance = march.advance(400.0).unwrap();
        if advance.crossing.is_some_and(|c| c.to.contact_state == ContactState::Stick) {
            last_stick = march.time();
        }
    }
    last_stick > 390.0
}

#[test]
fn steady_sliding_loses_stability_at_half_the_logarithm_of_ten() {
    let hopf = 0.5 * 10.0_f64.ln();
    assert!(belt(hopf).equivalent_damping().abs() < 1e-15);
}

#[test]
fn the_stick_slip_cycle_exists_up_to_1_8366() {
    let (mut lower, mut upper) = (1.5, 2.5);
    assert!(keeps_sticking(lower) && !keeps_sticking(upper));
    while upper - lower > 2e-6 {
        let middle = 0.5 * (lower + upper);
        if keeps_sticking(middle) { lower = middle } else { upper = middle }
    }
    assert!((lower - 1.83660).abs() < 1e-4, "{lower}");
}

/// The unstable branch from the subcritical Hopf point turns where it touches the belt's speed, at the end of the cycle.
#[test]
fn the_branch_from_the_hopf_point_turns_where_the_stick_slip_cycle_ends() {
    let hopf = 0.5 * 10.0_f64.ln();
    let shooting = Shooting { settings: settings(1e-11), tolerance: 1e-9, iterations: 12, longest: 100.0 };
    let options =
        Continuation { shooting, range: (1.0, 2.5), steps: (0.01, 0.05), points: 120, parameter_scale: 1.0 };
    let margin = global_margin(&|velocity| Ok(belt(velocity)), hopf, 1.0, &options).unwrap();
    let branch = margin.branch.as_ref().unwrap();
    for p in &branch.points {
        println!(
            "{:.6} {:.5} {:.6} {:?} {:.4}",
            p.parameter,
            p.cycle.period(),
            p.cycle.largest_multiplier(),
            p.cycle.around.pattern,
            p.slope
        );
    }
    println!("{:?} {:?}", branch.end, branch.folds);
    assert!(margin.hopf.is_subcritical());
    assert!((margin.fold.unwrap() - 1.83660).abs() < 1e-4, "{:?}", margin.fold);
    assert!(!branch.folds[0].is_smooth);
    let (first, last) = (branch.points.first().unwrap(), branch.points.last().unwrap());
    assert!(!first.cycle.is_stable() && last.cycle.is_stable());
}
