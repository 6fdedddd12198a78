//! `limit-cycle`: the cycle that a motion settles to, made exact by Newton's method.

use crate::error::ModelError;
use crate::motion::doubts;
use crate::motion::history::run::{Arrays, ToldMotion, energy_check, told};
use crate::motion::model::{Moving, Operating};
use crate::motion::settings::{Following, MotionStart};
use judder_oscillator::cycle::shooting::{Cycle, Shooting, from_simulation};
use judder_oscillator::motion::SlidingSystem;
use judder_oscillator::motion::attractor::Patience;
use judder_oscillator::motion::history::follow_cycle;
use judder_store::{Complex64, Declared, Results, Variable};
use judder_study::Progress;
use judder_study::outcome::{CheckRecord, Outcome};

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
    )
    .map_err(|error| doubts::doubted::<M, N>(&operating, error.into()))?;
    let (returns, period) = (cycle.oscillations, cycle.period());
    let history = follow_cycle(&operating.system, cycle.start, settings, returns, period, POINTS)?;
    progress.advance();
    let mut told = told::<M, N>(&operating, &history);
    told.period = Some(cycle.period());
    told.repeats = true;
    told.oscillations = cycle.oscillations;
    told.tell_si(operating.si);
    let mut scalars = told.scalars();
    let start_si = operating.si.map(|units| {
        M::COORDINATES.iter().zip(cycle.start).map(|(own, value)| units.coordinate(own.name, value)).collect()
    });
    scalars.extend(ToldCycle { start_si, ..ToldCycle::new(&cycle) }.scalars());
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
    let doubts = [doubts::beyond_law::<M, N>(&operating, &history.samples), doubts::neutral(&cycle)];
    Ok(Outcome {
        scalars,
        warnings: doubts.into_iter().flatten().collect(),
        dataset: arrays.in_si(arrays.dataset()?.with(multipliers)?)?,
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

/// What is told of a cycle besides.
#[derive(Results)]
struct ToldCycle {
    #[result(unit = "1")]
    floquet_multipliers: Vec<Complex64>,
    /// unknown where a multiplier is one but for what is known of it
    stable: Option<bool>,
    /// of the return
    #[result(unit = "1")]
    residual: f64,
    newton_iterations: usize,
    /// the contact states one after the other
    pattern: Vec<String>,
    /// a state on it
    #[result(unit = "1")]
    start: Vec<f64>,
    /// that state in m and m/s
    #[result(optional)]
    start_si: Option<Vec<f64>>,
}

/// The keys of the summary.
pub(crate) fn summary_keys() -> Vec<Declared> {
    [ToldMotion::declared(), ToldCycle::declared()].concat()
}

impl ToldCycle {
    fn new<const N: usize>(cycle: &Cycle<N>) -> Self {
        Self {
            floquet_multipliers: cycle.multipliers.clone(),
            stable: (!cycle.is_neutral()).then(|| cycle.is_stable()),
            residual: cycle.residual,
            newton_iterations: cycle.iterations,
            pattern: cycle.around.pattern.iter().map(ToString::to_string).collect(),
            start: cycle.start.to_vec(),
            start_si: None,
        }
    }
}
