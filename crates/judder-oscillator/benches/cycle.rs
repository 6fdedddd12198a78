//! One period of the stick-slip cycle of section 5 (τ̃0 = 0.03, F_n μ) at a local tolerance of 1e-8, as one line of JSON: the Rust
//! side of `benches/compare_motion.py`.

use judder_contact::{FittedLaw, Law};
use judder_numerics::piecewise::{PiecewiseMarch, PiecewiseSmooth, StepSettings};
use judder_oscillator::cycle::shooting::{Shooting, from_simulation};
use judder_oscillator::motion::attractor::Patience;
use judder_oscillator::motion::{SlidingSystem, StickSlip};
use judder_oscillator::{Contact, FrictionLoad, Groups};
use std::error::Error;
use std::hint::black_box;
use std::time::Instant;

const SHEAR_STRENGTH: f64 = 0.03;
/// That of the peer: relative and absolute.
const TOLERANCE: f64 = 1e-8;
/// Stages of a step.
const EVALUATIONS: usize = 6;

fn main() -> Result<(), Box<dyn Error>> {
    let contact =
        Contact { law: Law::Fitted(FittedLaw::oscillator_paper()), friction_load: FrictionLoad::NormalLoad };
    let groups =
        Groups { normal_load: 7.5e-4, velocity: 4e-4, shear_strength: SHEAR_STRENGTH, ..Groups::default() };
    let system = StickSlip::new(contact, groups.coefficients()?)?;
    let rest = system.steady_sliding();
    let settings = |tolerance: f64| StepSettings {
        relative: tolerance,
        absolute: [tolerance; 4],
        longest_step: 1.0,
        steps: 10_000_000,
    };
    let shooting = Shooting { settings: settings(1e-11), tolerance: 1e-8, iterations: 20, longest: 1000.0 };
    let disturbed = [1.2 * rest[0], rest[1], rest[2], rest[3]];
    let start = from_simulation(&system, disturbed, &shooting, &Patience::default(), &|| false)?.start;
    let lap = || -> Result<_, Box<dyn Error>> {
        let mut march =
            PiecewiseMarch::new(&system, system.contact_state(&start), start, settings(TOLERANCE))?
                .with_section(system.section());
        let mut changes = 0;
        loop {
            let advance = march.advance(f64::INFINITY)?;
            changes += usize::from(advance.crossing.is_some());
            if advance.on_section {
                return Ok((march.time(), march.steps_used(), changes));
            }
        }
    };
    let (seconds, result) = least(|| black_box(lap()));
    let (period, steps, changes) = result?;
    let (floor, _) = least(|| {
        for _ in 0..EVALUATIONS * steps {
            black_box(system.field(black_box(system.contact_state(&start)), black_box(&start)));
        }
    });
    println!(
        "{{\"seconds\": {seconds}, \"floor_seconds\": {floor}, \"period\": {period}, \"steps\": {steps}, \"changes\": {changes}, \
         \"shear_strength\": {SHEAR_STRENGTH}, \"start\": {start:?}}}"
    );
    Ok(())
}

/// The least wall time of some calls, and the last result.
fn least<T>(mut work: impl FnMut() -> T) -> (f64, T) {
    let mut result = work();
    let mut best = f64::INFINITY;
    for _ in 0..20 {
        let begin = Instant::now();
        result = work();
        best = best.min(begin.elapsed().as_secs_f64());
    }
    (best, result)
}
