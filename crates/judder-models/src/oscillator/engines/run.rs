//! `engines`: the cycle that a motion settles to, by events, by time-stepping and with a smoothed sign.

use super::ladder::{self, Engine, EngineLadder, ToldConvergence};
use super::reached::{BECOMES, EngineReached, LOST, PERIODS};
use crate::error::ModelError;
use crate::motion::limit_cycle::shooting;
use crate::motion::model::{Moving, Operating, OscillatorModel};
use crate::oscillator::engines::settings::EnginesSettings;
use judder_keys::numeric_key::Value as CaseValue;
use judder_numerics::parallel;
use judder_numerics::piecewise::StepSettings;
use judder_oscillator::cycle::shooting::{Cycle, from_simulation};
use judder_oscillator::motion::attractor::Patience;
use judder_oscillator::motion::laps::{LapCourse, by_time_stepping, with_smoothed_sign};
use judder_oscillator::motion::{
    ContactState, Interrupted, SlidingSystem, Smoothed, StickSlip, TimeStepping,
};
use judder_oscillator::{Contact, OscillatorError};
use judder_store::{Complex64, Dataset, Results, Table, Variable};
use judder_study::Progress;
use judder_study::outcome::Outcome;

/// How many times longer than they should take they may take.
const SLACK: f64 = 2.0;
/// ε over v_d of most codes that smooth the sign.
const TYPICAL: f64 = 0.1;

/// The cycle, and what it takes to follow it otherwise.
struct Comparison<'a> {
    contact: &'a Contact,
    system: &'a StickSlip,
    settings: StepSettings<4>,
    course: LapCourse,
}

impl Comparison<'_> {
    fn time_stepping(
        &self,
        step: f64,
        interrupted: Interrupted<'_>,
    ) -> Result<EngineReached, OscillatorError> {
        let engine = TimeStepping::new(self.contact.clone(), *self.system.coefficients(), step)?;
        // steps that cannot reach the end of the periods need not begin
        if step * self.course.steps as f64 * SLACK < self.course.longest {
            return Ok(LOST);
        }
        let laps = by_time_stepping(&engine, &self.course, interrupted);
        Ok(EngineReached::of(&laps, self.system.belt_velocity()))
    }

    /// With a sign whose width is so many times v_d.
    fn smoothed(&self, width: f64, interrupted: Interrupted<'_>) -> EngineReached {
        let velocity = self.system.belt_velocity();
        let smoothed = Smoothed::new(self.system.clone(), width * velocity);
        let laps =
            with_smoothed_sign(&smoothed, self.system.section(), self.settings, &self.course, interrupted);
        laps.map_or(LOST, |laps| EngineReached::of(&laps, velocity))
    }

    fn reached(
        &self,
        engine: Engine,
        value: f64,
        interrupted: Interrupted<'_>,
    ) -> Result<EngineReached, OscillatorError> {
        match engine {
            Engine::TimeStepping => self.time_stepping(value, interrupted),
            Engine::Smoothed => Ok(self.smoothed(value, interrupted)),
        }
    }
}

/// How many points an analysis has: both ladders and the typical width.
pub(crate) fn steps(settings: &EnginesSettings) -> usize {
    settings.time_step.points + settings.width.points + 1
}

pub(crate) fn run(
    model: &OscillatorModel<'_>,
    settings: &EnginesSettings,
    progress: &dyn Progress,
) -> Result<Outcome, ModelError> {
    let operating = model.operating(None)?;
    let cycle = stable_cycle(&operating, settings, progress)?;
    let form = settings.time_step.form;
    let time = |number: f64| operating.time(CaseValue { number, form });
    let time_steps: Vec<f64> = settings.time_step.values().into_iter().map(time).collect();
    let widths = settings.width.values();
    let comparison = Comparison {
        contact: model.contact,
        system: &operating.system,
        settings: operating.settings(&settings.following()),
        course: LapCourse {
            start: cycle.start,
            centre: operating.system.steady_sliding()[0],
            returns: cycle.oscillations,
            laps: PERIODS,
            longest: SLACK * PERIODS as f64 * cycle.period(),
            steps: settings.steps,
        },
    };
    let points: Vec<(Engine, f64)> = (time_steps.iter().map(|step| (Engine::TimeStepping, *step)))
        .chain(widths.iter().chain([&TYPICAL]).map(|width| (Engine::Smoothed, *width)))
        .collect();
    let mut reached = all(&comparison, &points, progress)?;
    let typical = reached.pop().unwrap_or(LOST);
    let smoothed = EngineLadder {
        engine: Engine::Smoothed,
        values: widths,
        reached: reached.split_off(time_steps.len()),
    };
    let ladders = [EngineLadder { engine: Engine::TimeStepping, values: time_steps, reached }, smoothed];
    outcome(&cycle, &ladders, &typical)
}

/// The cycle by events; no other engine would stay on an unstable one.
fn stable_cycle(
    operating: &Operating<StickSlip>,
    settings: &EnginesSettings,
    progress: &dyn Progress,
) -> Result<Cycle<4>, ModelError> {
    let time = operating.time(settings.duration);
    let shooting = shooting(operating, &settings.following());
    let patience = Patience { time, transient: 0.5 * time, ..Patience::default() };
    let start = operating.off_rest(operating.start(&settings.start));
    let stop = || progress.interrupted();
    let cycle = from_simulation(&operating.system, start, &shooting, &patience, &stop)?;
    if cycle.is_stable() {
        return Ok(cycle);
    }
    Err(ModelError::UnstableCycle { multiplier: cycle.largest_multiplier(), period: cycle.period() })
}

fn all(
    comparison: &Comparison<'_>,
    points: &[(Engine, f64)],
    progress: &dyn Progress,
) -> Result<Vec<EngineReached>, ModelError> {
    parallel::try_each(points, |(engine, value)| {
        let reached = comparison.reached(*engine, *value, &|| progress.interrupted())?;
        progress.advance();
        if progress.interrupted() { Err(ModelError::Interrupted) } else { Ok(reached) }
    })
}

fn outcome(
    cycle: &Cycle<4>,
    ladders: &[EngineLadder; 2],
    typical: &EngineReached,
) -> Result<Outcome, ModelError> {
    let reference = [cycle.around.measures.rms(), cycle.period()];
    let mut dataset = Dataset::new();
    let mut table = Vec::new();
    let (mut checks, mut warnings, mut missing) = (Vec::new(), Vec::new(), 0);
    for ladder in ladders {
        dataset = ladder.add_to(dataset, reference)?;
        table.extend(ladder.rows(reference));
        missing += ladder.lost();
        checks.extend(ladder.checks(reference));
        warnings.extend(ladder.warnings(reference));
    }
    let [by_steps, by_widths] = ladders;
    let told = ToldEngines {
        rms: reference[0],
        period: reference[1],
        oscillations: cycle.oscillations,
        stick_fraction: cycle.fraction(ContactState::Stick),
        lift_off_fraction: cycle.fraction(ContactState::LiftOff),
        floquet_multipliers: cycle.multipliers.clone(),
        residual: cycle.residual,
        time_stepping: ToldSteps { time_step: by_steps.values.clone(), errors: by_steps.told(reference) },
        smoothed: ToldWidths { width: by_widths.values.clone(), errors: by_widths.told(reference) },
        typical: ToldPoint {
            width: TYPICAL,
            becomes: BECOMES[usize::from(typical.becomes)].1,
            rms_error: typical.rms / reference[0] - 1.0,
            period_error: typical.period / reference[1] - 1.0,
        },
    };
    let reference = Variable::new("reference", &["quantity"], &[2], reference.to_vec())
        .units("1")
        .long_name("rms of x about its mean and period of the cycle, by events");
    let column = |pick: fn(&ladder::LadderRow) -> f64| table.iter().map(pick).collect::<Vec<f64>>();
    let words = |pick: fn(&ladder::LadderRow) -> &str| {
        table.iter().map(|row| pick(row).to_owned()).collect::<Vec<_>>()
    };
    let sheet = Table::new()
        .column("engine", "", words(|row| row.engine))?
        .column("value", "1", column(|row| row.value))?
        .column("becomes", "", words(|row| row.becomes))?
        .column("rms", "1", column(|row| row.rms))?
        .column("rms_error", "1", column(|row| row.errors[0]))?
        .column("period", "1", column(|row| row.period))?
        .column("period_error", "1", column(|row| row.errors[1]))?;
    Ok(Outcome {
        scalars: told.scalars(),
        dataset: dataset.with(reference)?.attribute("typical_width", TYPICAL)?,
        table: Some(sheet),
        checks,
        warnings,
        missing,
        ..Outcome::default()
    })
}

/// What is told of the cycle, and of what other engines find.
#[derive(Results)]
pub(super) struct ToldEngines {
    #[result(unit = "1")]
    rms: f64,
    #[result(unit = "1")]
    period: f64,
    oscillations: usize,
    stick_fraction: f64,
    lift_off_fraction: f64,
    #[result(unit = "1")]
    floquet_multipliers: Vec<Complex64>,
    #[result(unit = "1")]
    residual: f64,
    time_stepping: ToldSteps,
    smoothed: ToldWidths,
    /// a width as others take it
    typical: ToldPoint,
}

/// An engine along its steps.
#[derive(Results)]
struct ToldSteps {
    #[result(unit = "1")]
    time_step: Vec<f64>,
    #[result(flatten)]
    errors: ToldConvergence,
}

/// An engine along its widths.
#[derive(Results)]
struct ToldWidths {
    #[result(unit = "1")]
    width: Vec<f64>,
    #[result(flatten)]
    errors: ToldConvergence,
}

/// An engine with one width.
#[derive(Results)]
struct ToldPoint {
    #[result(unit = "1")]
    width: f64,
    becomes: &'static str,
    #[result(unit = "1")]
    rms_error: f64,
    #[result(unit = "1")]
    period_error: f64,
}
