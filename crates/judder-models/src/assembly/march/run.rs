//! The motion, and what is told of it.

use super::content::{SoughtContent, ToldMode};
use super::recorded::{Recorded, Signals};
use super::settings::AssemblyMarch;
use super::start::MotionState;
use crate::assembly::AssemblySubject;
use crate::error::ModelError;
use judder_assembly::steady::SteadySliding;
use judder_nonsmooth::march::{March, Works};
use judder_nonsmooth::statistics::{PointStatistics, Statistics};
use judder_numerics::contact_state::ContactState;
use judder_numerics::signal::tone::strongest_frequency;
use judder_store::{ByName, Dataset, Results, Variable};
use judder_study::Progress;
use judder_study::outcome::{CheckRecord, Outcome};
use std::time::Instant;

/// What is told of a motion.
#[derive(Results)]
pub(super) struct ToldMotion {
    /// how the motion is integrated
    method: &'static str,
    steps: u64,
    /// the step, in s
    step_s: f64,
    /// by the clock on the wall, of the steps alone
    seconds: f64,
    /// the strongest line of the velocity along the slip of the point that moves most, in Hz; none where nothing moves
    frequency_hz: Option<f64>,
    /// all normal forces together, on average, in N
    normal_force_mean: f64,
    /// the friction on the sliders along the slip, on average, in N
    friction_force_mean: f64,
    /// what goes into the bodies, on average, in W
    power: ToldPower,
    /// by how much the energy of the bodies changed otherwise than the power says, over what was exchanged
    energy_balance: f64,
    /// the largest residual of the contact of a step: impulses beside those that it allows, over the largest of steady sliding
    contact_residual: f64,
    /// steps whose contact was not solved to its tolerance
    contact_unsolved: u64,
    /// sweeps over the contact points in a step, on average
    contact_sweeps: f64,
    /// the lowest complex modes about steady sliding, and how much of each the motion has
    modes: Vec<ToldMode>,
    /// each contact
    contacts: ByName<ToldContact>,
}

/// What goes into the bodies.
#[derive(Results)]
pub(super) struct ToldPower {
    /// from the friction forces
    friction: f64,
    /// taken by the damping
    damping: f64,
    /// taken by impacts, or held by compliant contacts
    impacts: f64,
    /// from the track's drive: of friction, with what becomes heat
    drive: f64,
    /// what becomes heat where bodies slide
    heat: f64,
    /// from stiffness that is not symmetric
    #[result(optional)]
    circulation: Option<f64>,
}

/// The points of a contact, as lists.
#[derive(Results)]
pub(super) struct ToldContact {
    /// where each lies along x, in m
    x_m: Vec<f64>,
    /// the share of the time in which it sticks
    stick_share: Vec<f64>,
    /// in which it slides
    slip_share: Vec<f64>,
    /// in which it has lifted off
    open_share: Vec<f64>,
    /// the velocity of the slider beside the track along the slip about its mean, as root mean square, in m/s
    tangential_velocity_rms: Vec<f64>,
    /// its normal force, on average, in N
    normal_force_mean: Vec<f64>,
}

/// Steps between two looks at whether the run shall stop.
const LOOK: u64 = 2000;
/// What the balance of energy may be off, over what was exchanged.
const BALANCE: f64 = 1e-6;

/// A motion that has run.
struct Marched<'a> {
    march: March<'a>,
    statistics: Statistics,
    recorded: Recorded,
    /// Works and energy when the transient was over.
    settled: (Works, f64),
    first_energy: f64,
    seconds: f64,
    /// The modes in it, or why they are not known.
    content: Result<SoughtContent, ModelError>,
}

/// Marches, and tells.
pub(super) fn run(
    of: &AssemblySubject<'_>,
    asked: &AssemblyMarch,
    progress: &dyn Progress,
) -> Result<Outcome, ModelError> {
    let steady = of.steady_or_untouched()?;
    let state = MotionState::new(of, &steady, asked.start.as_ref())?;
    let marched = march(of, asked, progress, &steady, &state)?;
    let counts = points_of(of);
    let Marched { march, statistics, mut recorded, settled, first_energy, seconds, content } = marched;
    let signals = recorded.signals();
    let points: Vec<PointStatistics> =
        (0..steady.points.len()).filter_map(|point| statistics.of(point)).collect();
    let (works, record) = (march.works(), march.record());
    let energy = march.energy();
    let gained = energy.kinetic + energy.potential - first_energy;
    let told = works.friction + works.normal + works.damping + works.circulation;
    let exchanged = [works.friction, works.normal, works.damping, works.heat, gained];
    let exchanged = exchanged.iter().fold(f64::MIN_POSITIVE, |most, own| most.max(own.abs()));
    let balance = (gained - told).abs() / exchanged;
    let time = statistics.steps() as f64 * asked.step;
    let mean = |pick: fn(&Works) -> f64| (pick(&works) - pick(&settled.0)) / time;
    let sum = |pick: fn(&PointStatistics) -> f64| points.iter().map(pick).sum::<f64>();
    let frequency = frequency(&signals, &points, counts.len(), asked.transient);
    let results = ToldMotion {
        method: asked.method.name(),
        steps: march.steps(),
        step_s: asked.step,
        seconds,
        frequency_hz: frequency,
        normal_force_mean: sum(|own| own.normal_force_mean),
        friction_force_mean: sum(|own| own.friction_force_mean),
        power: ToldPower {
            friction: mean(|own| own.friction),
            damping: mean(|own| own.damping),
            impacts: mean(|own| own.normal),
            drive: mean(|own| own.friction + own.heat),
            heat: mean(|own| own.heat),
            circulation: (works.circulation != 0.0).then(|| mean(|own| own.circulation)),
        },
        energy_balance: balance,
        contact_residual: record.residual,
        contact_unsolved: record.unsolved,
        contact_sweeps: record.iterations as f64 / march.steps().max(1) as f64,
        modes: content.as_ref().map(SoughtContent::told).unwrap_or_default(),
        contacts: contacts(of, &points),
    };
    let Outcome { scalars, .. } = Outcome::of(&results)?;
    let mut warnings = of.doubts(&steady);
    if let Err(error) = content {
        warnings.push(format!("which modes the motion contains is not known: {error}"));
    }
    if let Some((time, point)) = record.first_unsolved {
        warnings.push(format!(
            "in {} of {} steps the contact is not solved to its tolerance, first at {time} s at contact point {} with the residual {:.1e}: a \
             shorter step helps",
            record.unsolved,
            march.steps(),
            point + 1,
            record.residual,
        ));
    }
    Ok(Outcome {
        scalars,
        dataset: match frequency {
            Some(frequency) => {
                dataset(of, asked, &recorded, signals)?.attribute("frequency_hz", frequency)?
            }
            None => dataset(of, asked, &recorded, signals)?,
        },
        checks: vec![
            CheckRecord::new(
                "impulses and velocities complement each other at every contact point",
                format!("largest residual of {} steps, {} points", march.steps(), steady.points.len()),
                record.residual.into(),
                march.settings().accuracy.tolerance,
            ),
            CheckRecord::new(
                "the energy of the bodies changes by the work done on them",
                format!("difference over what was exchanged, {exchanged:.3e} J"),
                balance.into(),
                BALANCE,
            ),
        ],
        missing: usize::from(record.unsolved > 0),
        warnings,
        ..Outcome::default()
    })
}

/// Contact points of each contact.
fn points_of(of: &AssemblySubject<'_>) -> Vec<usize> {
    of.built.assembly.interfaces.iter().map(|interface| interface.points.len()).collect()
}

fn march<'a>(
    of: &AssemblySubject<'a>,
    asked: &AssemblyMarch,
    progress: &dyn Progress,
    steady: &SteadySliding,
    state: &MotionState,
) -> Result<Marched<'a>, ModelError> {
    let mut march = March::new(&of.built.assembly, &[], asked.march())?;
    let largest = steady.points.iter().map(|point| point.normal_force.abs()).fold(0.0, f64::max);
    march.set_force_scale(if largest > 0.0 { largest } else { 1.0 });
    march.start(&state.displacement, &state.velocity);
    let guess: Vec<[f64; 2]> =
        steady.points.iter().map(|point| [point.normal_force, point.friction_force]).collect();
    march.guess(&guess);
    let mut content = SoughtContent::new(of, steady, &march, asked.modes);
    let [steps, transient] = asked.steps();
    let mut recorded = Recorded::new(&march, &points_of(of), asked.sample_rate.0)?;
    let mut statistics = Statistics::new(steady.points.len());
    let first = march.energy();
    let first_energy = first.kinetic + first.potential;
    let mut settled = (march.works(), first_energy);
    progress.expect((steps / LOOK) as usize);
    let start = Instant::now();
    for taken in 1..=steps {
        march.advance()?;
        recorded.take(&march);
        if taken > transient {
            statistics.take(&march);
            if let Ok(content) = &mut content {
                content.take(&march, taken);
            }
        } else if taken == transient {
            let energy = march.energy();
            settled = (march.works(), energy.kinetic + energy.potential);
        }
        if taken.is_multiple_of(LOOK) {
            progress.go_on()?;
            progress.advance();
        }
    }
    let seconds = start.elapsed().as_secs_f64();
    Ok(Marched { march, statistics, recorded, settled, first_energy, seconds, content })
}

/// The strongest line of the velocity of the point that moves most, after the transient.
fn frequency(
    signals: &Signals,
    points: &[PointStatistics],
    interfaces: usize,
    transient: f64,
) -> Option<f64> {
    let rms = |k: &usize| points[*k].tangential_velocity_rms;
    let most = (0..points.len()).max_by(|a, b| rms(a).total_cmp(&rms(b)))?;
    let column = signals.columns.get(2 * interfaces + most)?;
    let first = signals.time.partition_point(|time| *time <= transient);
    strongest_frequency(column.get(first..)?, signals.rate)
}

fn contacts(of: &AssemblySubject<'_>, points: &[PointStatistics]) -> ByName<ToldContact> {
    let mut first = 0;
    let told = of.built.assembly.interfaces.iter().map(|interface| {
        let own = &points[first.min(points.len())..(first + interface.points.len()).min(points.len())];
        first += interface.points.len();
        let list = |pick: fn(&PointStatistics) -> f64| own.iter().map(pick).collect::<Vec<_>>();
        let contact = ToldContact {
            x_m: interface.points.iter().map(|point| point.place[0]).collect(),
            stick_share: list(|own| own.stick_share),
            slip_share: list(|own| own.slip_share),
            open_share: list(|own| own.open_share),
            tangential_velocity_rms: list(|own| own.tangential_velocity_rms),
            normal_force_mean: list(|own| own.normal_force_mean),
        };
        (interface.name.clone(), contact)
    });
    told.collect()
}

/// Signals of the contacts, states of the points over time.
fn dataset(
    of: &AssemblySubject<'_>,
    asked: &AssemblyMarch,
    recorded: &Recorded,
    mut signals: Signals,
) -> Result<Dataset, ModelError> {
    let interfaces = &of.built.assembly.interfaces;
    let places = || interfaces.iter().flat_map(|own| own.points.iter().map(move |point| (own, point)));
    let count = places().count();
    let samples = signals.time.len();
    let mut columns = std::mem::take(&mut signals.columns).into_iter();
    let time = Variable::coordinate("time", signals.time).units("s").long_name("time since the start");
    let mut dataset = Dataset::new()
        .attribute("method", asked.method.name())?
        .attribute("step_s", asked.step)?
        .attribute("transient_s", asked.transient)?
        .attribute("sample_rate_hz", signals.rate)?
        .with(time.attribute("label", "Time $t$ (s)"))?;
    for interface in interfaces {
        for (what, symbol, head, words) in [
            ("normal_force", "N", "Normal force", "normal forces"),
            ("friction_force", "T", "Friction", "friction on the slider along the slip"),
        ] {
            let name = format!("{}.{what}", interface.name);
            let values = columns.next().unwrap_or_default();
            let variable = Variable::new(&name, &["time"], &[samples], values).units("N");
            let label = format!("{head} of {}, ${symbol}$ (N)", interface.name);
            dataset = dataset.with(
                variable.long_name(&format!("{words} of {}", interface.name)).attribute("label", label),
            )?;
        }
    }
    if count == 0 {
        return Ok(dataset);
    }
    let velocities: Vec<Vec<f64>> = columns.collect();
    let by_time =
        (0..samples).flat_map(|k| velocities.iter().map(move |column| column[k])).collect::<Vec<_>>();
    let names: Vec<String> = places().map(|(interface, _)| interface.name.clone()).collect();
    let along = |axis: usize| places().map(|(_, point)| point.place[axis]).collect::<Vec<f64>>();
    let state_times = recorded.state_times();
    let (instants, numbers) = (state_times.len(), (1..=count as i64).collect::<Vec<_>>());
    dataset = dataset
        .with(Variable::coordinate("contact_point", numbers).long_name("number of the contact point"))?
        .with(
            Variable::new("contact", &["contact_point"], &[count], names).long_name("contact of the point"),
        )?
        .with(
            Variable::new("velocity", &["time", "contact_point"], &[samples, count], by_time)
                .units("m/s")
                .long_name("velocity of the slider beside the track's undisturbed place, along the slip"),
        )?
        .with(Variable::coordinate("state_time", state_times).units("s").long_name("time of the states"))?
        .with(
            Variable::classes(
                "state",
                &["state_time", "contact_point"],
                &[instants, count],
                recorded.states.clone(),
                &ContactState::CODES,
            )
            .long_name("what each contact point does"),
        )?
        .with(
            Variable::new(
                "point_normal_force",
                &["state_time", "contact_point"],
                &[instants, count],
                recorded.normal_forces.clone(),
            )
            .units("N")
            .long_name("normal force of each contact point"),
        )?;
    for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
        let place = Variable::new(name, &["contact_point"], &[count], along(axis)).units("m");
        dataset = dataset.with(place.long_name(&format!("place of the contact point along {name}")))?;
    }
    Ok(dataset)
}
