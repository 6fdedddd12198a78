//! `limit-cycle`: the cycle that a motion settles to, made exact by Newton's method.

use crate::error::ModelError;
use crate::motion::history::run::{Arrays, energy_check, scalars};
use crate::motion::model::{Moving, Operating};
use crate::motion::settings::{Following, MotionStart};
use judder_oscillator::cycle::shooting::{Cycle, Shooting, from_simulation};
use judder_oscillator::motion::SlidingSystem;
use judder_oscillator::motion::attractor::Patience;
use judder_oscillator::motion::history::follow_cycle;
use judder_store::{Variable, number};
use judder_study::Progress;
use judder_study::outcome::{CheckRecord, Outcome};
use serde_json::{Map, Value, json};

/// The distance of the return from the start that is asked, over the local tolerance: what a period of steps leaves.
const RETURN: f64 = 100.0;
const NEWTON_ITERATIONS: usize = 30;
/// Points of the history over one period.
const POINTS: usize = 2049;
/// By how much the computed monodromy may fail to carry the cycle's own velocity into itself.
const TRIVIAL_LIMIT: f64 = 1e-5;

pub(crate) fn run<M: Moving<N>, const N: usize>(
    model: &M,
    start: &MotionStart,
    following: &Following,
    progress: &dyn Progress,
) -> Result<Outcome, ModelError> {
    let operating = model.operating(None)?;
    let settings = operating.settings(following);
    let time = operating.time(following.duration);
    let shooting = shooting(&operating, following);
    let patience = Patience { time, transient: 0.5 * time, ..Patience::default() };
    let stop = || progress.interrupted();
    let cycle = from_simulation(
        &operating.system,
        operating.off_rest(operating.start(start)),
        &shooting,
        &patience,
        &stop,
    )?;
    let (returns, period) = (cycle.oscillations, cycle.period());
    let history = follow_cycle(&operating.system, cycle.start, settings, returns, period, POINTS)?;
    progress.advance();
    let mut scalars = scalars::<M, N>(&operating, &history);
    scalars.extend(of_cycle(&cycle));
    let arrays = Arrays::<M, N> { operating: &operating, history: &history };
    let multipliers = Variable::new("floquet_multipliers", &["multiplier"], &[N], cycle.multipliers.clone())
        .units("1")
        .long_name("Floquet multipliers, the trivial one among them");
    let monodromy = CheckRecord::new(
        "the monodromy carries the cycle's own velocity into itself",
        "the velocity after a period, through all saltation matrices, against that before, relative",
        cycle.trivial_error.into(),
        TRIVIAL_LIMIT,
    );
    Ok(Outcome {
        scalars,
        dataset: arrays.dataset()?.with(multipliers)?.attribute("kind", "limit-cycle")?,
        table: Some(arrays.table()?),
        checks: energy_check(&history).into_iter().chain([monodromy]).collect(),
        ..Outcome::default()
    })
}

/// How the cycle is made exact.
pub(crate) fn shooting<S: SlidingSystem<N>, const N: usize>(
    operating: &Operating<S>,
    following: &Following,
) -> Shooting<N> {
    Shooting {
        settings: operating.settings(following),
        tolerance: RETURN * following.tolerance,
        iterations: NEWTON_ITERATIONS,
        longest: operating.time(following.duration),
    }
}

fn of_cycle<const N: usize>(cycle: &Cycle<N>) -> Map<String, Value> {
    let multipliers: Vec<[f64; 2]> = cycle.multipliers.iter().map(|m| [m.re, m.im]).collect();
    let pattern: Vec<String> = cycle.around.pattern.iter().map(ToString::to_string).collect();
    Map::from_iter([
        ("period".to_owned(), number(cycle.period())),
        ("repeats".to_owned(), json!(true)),
        ("oscillations".to_owned(), json!(cycle.oscillations)),
        ("floquet_multipliers".to_owned(), json!(multipliers)),
        ("stable".to_owned(), json!(cycle.is_stable())),
        ("residual".to_owned(), number(cycle.residual)),
        ("newton_iterations".to_owned(), json!(cycle.iterations)),
        ("pattern".to_owned(), json!(pattern)),
        ("start".to_owned(), json!(cycle.start.to_vec())),
    ])
}
