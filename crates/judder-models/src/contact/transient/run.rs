//! `transient`: a contact that is followed in time.

use crate::contact::case::ContactCase;
use crate::contact::in_si;
use crate::contact::memory::{operator_at_once, operator_limit};
use crate::contact::single::run::RESIDUAL_LIMIT;
use crate::contact::transient::asked::AskedTransient;
use crate::contact::transient::settings::{IndenterMotion, TransientSettings};
use crate::error::ModelError;
use crate::indenter::profile;
use crate::material::ContactScales;
use judder_contact::steady::profile::Profile;
use judder_contact::steady::{GridChoice, SteadyQuestion, solve};
use judder_contact::transient::{TransientHistory, TransientQuestion, TransientSample, run as follow};
use judder_contact::unilateral::{Loading, UnilateralLimits};
use judder_store::{Dataset, Results, Table, Variable};
use judder_study::Progress;
use judder_study::outcome::{CheckRecord, Outcome};
use std::f64::consts::PI;
use std::ops::ControlFlow;

/// What the energies may leave of the work: the cells' error.
const ENERGY_LIMIT: f64 = 2e-2;
/// What the end of a start may differ by from steady sliding.
const STEADY_LIMIT: f64 = 2e-2;
/// Accuracy of the steady contact that a start is compared with.
const STEADY_ACCURACY: f64 = 3e-3;
/// A start has become steady after this many of the longest retardation times and of the contact's radii.
const SETTLING: f64 = 5.0;
/// The last part of a start, over which the ripple of the cells is averaged.
const LAST_PART: f64 = 0.1;

pub(super) fn run(
    case: &ContactCase,
    settings: &TransientSettings,
    progress: &dyn Progress,
) -> Result<Outcome, ModelError> {
    let scales = ContactScales::new(case)?;
    let asked = AskedTransient::new(&case.shape, settings, &scales);
    let substrate = scales.creeping();
    let profile = profile(&case.shape, scales.scales.radius)?;
    let question = asked.question(&substrate, &*profile, settings);
    let mut interrupted = false;
    let history = follow(&question, &mut |_| {
        interrupted = progress.interrupted();
        if interrupted { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    })?;
    let Some(last) = history.last().copied().filter(|_| !interrupted) else {
        return Err(ModelError::Interrupted);
    };
    let mut outcome = Outcome {
        dataset: dataset(&history, settings, &scales)?,
        table: Some(table(&history)?),
        checks: checks(&history, &last, &question),
        ..Outcome::default()
    };
    let mut steady = None;
    if let (Some(velocity), None) = (asked.velocity, asked.depth_frequency) {
        let memory = operator_at_once(operator_limit(settings.memory), 1);
        let steady = steady.insert(Steady::new(&scales, &*profile, velocity, asked.loading, memory)?);
        let slid = velocity * asked.duration;
        let settled = asked.duration >= SETTLING * substrate.longest_time()
            && slid >= SETTLING * (last.area / PI).sqrt();
        if settled {
            outcome.checks.push(steady.check(&history, asked.duration));
        }
    }
    outcome.scalars = told(&history, &last, &asked, &scales, steady.as_ref()).scalars();
    progress.advance();
    if !(history.converged && history.completed) {
        outcome.missing = 1;
        outcome.warnings.push(missed(&history, last.time, asked.duration));
    }
    if asked.period.is_some_and(|period| period > asked.duration) {
        outcome.warnings.push("the run is shorter than a period: there is no work of a cycle".to_owned());
    }
    Ok(outcome)
}

fn missed(history: &TransientHistory, end: f64, duration: f64) -> String {
    match history.completed {
        true => "the contact of a step was not solved, or its error is beyond the tolerance".to_owned(),
        false => format!(
            "the run ended at t/τ = {end:.4} of {duration:.4}: it took {} steps",
            history.samples.len() + history.rejected
        ),
    }
}

/// Force and friction coefficient of steady sliding.
struct Steady {
    force: f64,
    friction: f64,
}

impl Steady {
    fn new(
        scales: &ContactScales,
        profile: &dyn Profile,
        velocity: f64,
        loading: Loading,
        memory: u64,
    ) -> Result<Self, ModelError> {
        let contact = solve(&SteadyQuestion {
            substrate: &scales.material.sliding(velocity),
            profile,
            loading,
            accuracy: STEADY_ACCURACY,
            grid: GridChoice::Automatic,
            limits: UnilateralLimits::default(),
            memory,
        })?;
        Ok(Self { force: contact.refinement.force.value, friction: contact.refinement.friction.value })
    }

    /// The last part of a start against this.
    fn check(&self, history: &TransientHistory, duration: f64) -> CheckRecord {
        let mean = |quantity: fn(&TransientSample) -> f64| {
            history.mean((1.0 - LAST_PART) * duration, duration, quantity)
        };
        let force = mean(|sample| sample.force);
        let friction = mean(|sample| sample.friction_force) / force;
        CheckRecord::new(
            "the end of the start is steady sliding",
            "mean force (relative) and friction of the last tenth against the steady contact",
            [(force / self.force - 1.0).abs(), (friction - self.friction).abs()].into_iter().collect(),
            STEADY_LIMIT,
        )
    }
}

/// What is told of a contact in time.
#[derive(Results)]
pub(super) struct ToldHistory {
    converged: bool,
    completed: bool,
    #[result(unit = "1")]
    force: f64,
    #[result(unit = "1")]
    friction_force: f64,
    #[result(unit = "1")]
    area: f64,
    #[result(unit = "1")]
    indentation: f64,
    force_newton: f64,
    friction_force_newton: f64,
    work: f64,
    duration_second: f64,
    steps: usize,
    rejected_steps: usize,
    products: usize,
    cell: f64,
    #[result(flatten)]
    cycles: ToldCycles,
    #[result(flatten)]
    steady: Option<ToldSteady>,
}

/// What is told of whole periods.
#[derive(Default, Results)]
struct ToldCycles {
    #[result(optional)]
    work_per_cycle: Option<f64>,
    #[result(optional)]
    work_per_cycle_joule: Option<f64>,
    /// of the work of the last cycle from that of the one before
    #[result(unit = "1", optional)]
    cycle_change: Option<f64>,
    /// of an oscillating depth
    #[result(optional)]
    stiffness: Option<f64>,
    #[result(optional)]
    c_y: Option<f64>,
    #[result(optional)]
    c_y_newton_second_per_metre: Option<f64>,
}

/// What is told of steady sliding at the same speed.
#[derive(Results)]
struct ToldSteady {
    steady_force: f64,
    steady_friction: f64,
}

impl ToldCycles {
    fn new(history: &TransientHistory, asked: &AskedTransient, scales: &ContactScales) -> Self {
        let Some(period) = asked.period else { return Self::default() };
        let works = history.work_by_period(period);
        let radius = scales.scales.radius;
        let mut told = Self::default();
        if let [.., cycle] = works[..] {
            told.work_per_cycle = Some(cycle);
            told.work_per_cycle_joule = Some(cycle * scales.force_unit() * radius);
        }
        if let [.., before, cycle] = works[..] {
            told.cycle_change = Some((cycle / before - 1.0).abs());
        }
        if let (Some(frequency), false) = (asked.depth_frequency, works.is_empty()) {
            let end = works.len() as f64 * period;
            let wave = |quantity: fn(&TransientSample) -> f64| {
                history.harmonic(end - period, end, frequency, quantity)
            };
            let stiffness = wave(|sample| sample.force) / wave(|sample| sample.indentation);
            let damper = stiffness.im / frequency;
            let unit = scales.force_unit() * scales.time / radius;
            told.stiffness = Some(stiffness.re);
            told.c_y = Some(damper);
            told.c_y_newton_second_per_metre = Some(damper * unit);
        }
        told
    }
}

fn told(
    history: &TransientHistory,
    last: &TransientSample,
    asked: &AskedTransient,
    scales: &ContactScales,
    steady: Option<&Steady>,
) -> ToldHistory {
    ToldHistory {
        converged: history.converged,
        completed: history.completed,
        force: last.force,
        friction_force: last.friction_force,
        area: last.area,
        indentation: last.indentation,
        force_newton: last.force * scales.force_unit(),
        friction_force_newton: last.friction_force * scales.force_unit(),
        work: last.work(),
        duration_second: last.time * scales.time,
        steps: history.samples.len().saturating_sub(1),
        rejected_steps: history.rejected,
        products: history.products,
        cell: history.cell,
        cycles: ToldCycles::new(history, asked, scales),
        steady: steady
            .map(|steady| ToldSteady { steady_force: steady.force, steady_friction: steady.friction }),
    }
}

fn checks(
    history: &TransientHistory,
    last: &TransientSample,
    question: &TransientQuestion<'_>,
) -> Vec<CheckRecord> {
    let mut checks = vec![CheckRecord::new(
        "the conditions of contact hold at every step",
        format!("largest error of {} contacts, displacement over the largest depth", history.samples.len()),
        history.samples.iter().map(|sample| sample.residual).collect(),
        RESIDUAL_LIMIT.max(question.limits.tolerance),
    )];
    let first = history.samples.first().and_then(|sample| sample.energy);
    if let (Some(first), Some(energy)) = (first, last.energy) {
        let stored = energy.stored - first.stored;
        let scale = energy.dissipated.abs().max(energy.stored).max(last.work().abs());
        checks.push(CheckRecord::new(
            "the work is stored or dissipated",
            "work at the indenter against the energies in the substrate, over the largest of them",
            ((last.work() - stored - energy.dissipated).abs() / scale).into(),
            ENERGY_LIMIT,
        ));
    }
    checks
}

/// A quantity of a history: name, unit of the table, long name, value.
type HistoryQuantity = (&'static str, &'static str, &'static str, fn(&TransientSample) -> f64);

/// What is kept of every step.
const QUANTITIES: [HistoryQuantity; 6] = [
    ("position", "R", "x/R of the indenter", |sample| sample.position),
    ("indentation", "R", "δ/R", |sample| sample.indentation),
    ("force", "E0* R²", "F/(E0* R²)", |sample| sample.force),
    ("friction_force", "E0* R²", "force that resists a motion to +x, over E0* R²", |s| s.friction_force),
    ("area", "R²", "A/R²", |sample| sample.area),
    ("work", "E0* R³", "work done since the start, over E0* R³", TransientSample::work),
];

fn column(history: &TransientHistory, value: fn(&TransientSample) -> f64) -> Vec<f64> {
    history.samples.iter().map(value).collect()
}

fn dataset(
    history: &TransientHistory,
    settings: &TransientSettings,
    scales: &ContactScales,
) -> Result<Dataset, ModelError> {
    let time = Variable::coordinate("time", column(history, |sample| sample.time))
        .units("1")
        .long_name("t/τ")
        .attribute("label", "Time $t$/$τ$ (−)");
    let mut dataset = Dataset::new().with(time)?;
    for (name, _, long_name, value) in QUANTITIES {
        let values = column(history, value);
        dataset = dataset
            .with(Variable::new(name, &["time"], &[values.len()], values).units("1").long_name(long_name))?;
    }
    let loop_over = match (settings.motion(), settings.oscillation) {
        (IndenterMotion::Reciprocation(_), _) => "position",
        (_, Some(_)) => "indentation",
        _ => "",
    };
    if settings.is_in_si() {
        dataset = in_si::history(dataset, scales)?;
    }
    Ok(dataset.attribute("loop_over", loop_over)?)
}

fn table(history: &TransientHistory) -> Result<Table, ModelError> {
    let mut table = Table::new().column("time", "τ", column(history, |sample| sample.time))?;
    for (name, unit, _, value) in QUANTITIES {
        table = table.column(name, unit, column(history, value))?;
    }
    Ok(table)
}
