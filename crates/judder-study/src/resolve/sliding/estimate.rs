//! What the analyses of a sliding case would take.

use crate::resolve::{Estimate, cost};
use crate::sliding::{self, Size, SlidingSystem};
use judder_case::sliding::locus::Along;
use judder_case::sliding::march::{March, MarchMethod};
use judder_case::{SlidingAnalysis, SlidingCase};
use judder_sliding::march::Method;
use judder_sliding::motion::Motion;

/// Seconds on one core, measured on the beams paper's pair of 243 modes in the release build; good to a factor of a few.
mod per {
    /// One step of a march and one mode.
    pub(super) const STEP_AND_MODE: f64 = 1.5e-9;
    /// One value of a locus, one branch and one mode, with the search for zones beside it.
    pub(super) const VALUE: f64 = 4e-7;
    /// A structure read, assembled and reduced, a degree of freedom.
    pub(super) const FREEDOM: f64 = 1e-4;
    /// Two eigenproblems with full matrices, over the cube of the modes.
    pub(super) const DENSE: f64 = 1e-7;
    /// Periods of a mode that a growth is measured over, at most.
    pub(super) const PERIODS: f64 = 600.0;
}

/// Steps, values or modes of an analysis, its time and its memory.
pub(super) fn estimate(
    case: &SlidingCase,
    system: &SlidingSystem,
    name: &str,
    kind: &SlidingAnalysis,
) -> Estimate {
    let modes = system.pair.modes() as f64;
    let freedoms = |index: usize| system.parts[index].structure.family.size() as f64;
    let (points, seconds, numbers) = match kind {
        SlidingAnalysis::Modes { structure, .. } => (1, per::FREEDOM * freedoms(*structure), 0.0),
        SlidingAnalysis::Locus(locus) => {
            let (points, again) = match &locus.along {
                Along::Positions(positions) => (positions.points, 0.0),
                Along::Key { sweep, .. } => {
                    let concerned = (0..2).filter(|index| {
                        let own = format!("structure.{}.", case.structures[*index].name);
                        sweep.path.starts_with(&own) || sweep.path.starts_with("parameters.")
                    });
                    (sweep.values.len(), concerned.map(freedoms).sum::<f64>() * per::FREEDOM)
                }
            };
            let value = per::VALUE * modes * locus.count as f64 + again;
            let doubt = 3.0 * per::DENSE * modes.powi(3);
            (points, points as f64 * value + doubt, points as f64 * (2.0 * locus.count as f64 + 3.0))
        }
        SlidingAnalysis::Growth(growth) => {
            let motion = system.motion.held(growth.position);
            let step = step_of(system, growth.method(), growth.step, motion);
            let time = per::PERIODS * std::f64::consts::TAU / growth.frequency;
            let steps = time / step;
            (steps as usize, steps * modes * per::STEP_AND_MODE, 0.0)
        }
        SlidingAnalysis::March(march) => of_march(system, march, modes),
        SlidingAnalysis::Spectrogram(asked) => {
            // the whole march is read
            let read =
                case.analyses.iter().find(|own| own.name == asked.of).and_then(|own| match &own.kind {
                    SlidingAnalysis::March(march) => Size::of(system, march),
                    _ => None,
                });
            (1, 1.0, read.map_or(0.0, |size| size.stored() / 8.0))
        }
    };
    let seconds = seconds + cost::FIGURE;
    Estimate { name: name.to_owned(), points, seconds, bytes: (8.0 * numbers) as u128 }
}

/// A march holds the samples between two checkpoints; bursts, sound and report look at all of them when it is over.
fn of_march(system: &SlidingSystem, march: &March, modes: f64) -> (usize, f64, f64) {
    let motion = Motion { start: march.from, end: march.to, ..system.motion };
    let step = step_of(system, march.method, march.step, motion);
    let steps = motion.duration() / step;
    let numbers = Size::new(system, march, step).memory() / 8.0;
    (steps as usize, steps * modes * per::STEP_AND_MODE, numbers)
}

/// The step that is given, or chosen; where it is refused, the one asked for.
fn step_of(system: &SlidingSystem, method: MarchMethod, given: Option<f64>, motion: Motion) -> f64 {
    let own: Method = sliding::method(method);
    match sliding::step(&system.pair, own, given, motion) {
        Ok(step) => step.step,
        Err(_) => given.unwrap_or(f64::INFINITY),
    }
}
