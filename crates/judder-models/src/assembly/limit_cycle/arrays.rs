//! What is stored of a cycle: the motions of the mode over their amplitude, one period of the cycle.

use super::checks::INSTANTS;
use super::search::{CycleOfMode, differentiated};
use super::stability::KnownStability;
use super::stored::{FREQUENCY, GAP, SCALED_AT, force_harmonics};
use crate::assembly::AssemblySubject;
use crate::assembly::march::arrays::contact_points;
use crate::assembly::march::recorded::named_state;
use crate::error::ModelError;
use faer::Mat;
use judder_cycles::cycle::{AssemblyCycle, PointsOverPeriod};
use judder_cycles::series::Series;
use judder_numerics::contact_state::ContactState;
use judder_store::{Dataset, Variable};
use std::f64::consts::TAU;

/// The motions of the mode, and where there is a cycle one period of it.
pub(super) fn dataset(
    of: &AssemblySubject<'_>,
    sought: &CycleOfMode<'_>,
    stability: Option<&KnownStability>,
) -> Result<Dataset, ModelError> {
    let mut dataset = Dataset::new();
    if sought.follows_a_mode() {
        dataset = motions(dataset, sought)?;
    }
    let by_steps = stability.and_then(KnownStability::multipliers);
    let by_hill = stability.and_then(KnownStability::hill_multipliers);
    let words = "Floquet multipliers, that of the phase among them, the largest first";
    for (name, all, words) in [
        ("floquet_multipliers", by_steps, words.to_owned()),
        ("hill_multipliers", by_hill, format!("{words}, by Hill's method")),
    ] {
        if let Some(all) = all {
            let variable = Variable::new(name, &["multiplier"], &[all.len()], all);
            dataset = dataset.with(variable.units("1").long_name(&words))?;
        }
    }
    match sought.cycle() {
        Some(cycle) => period(dataset, of, sought, cycle),
        None => Ok(dataset),
    }
}

/// Amplitude, growth rate and frequency of the motions.
fn motions(dataset: Dataset, sought: &CycleOfMode<'_>) -> Result<Dataset, ModelError> {
    let motions = sought.motions();
    let along = |name: &str, k: usize, factor: f64| {
        let values: Vec<f64> = motions.iter().map(|own| factor * own[k]).collect();
        Variable::new(name, &["motion"], &[values.len()], values)
    };
    let amplitude = along("amplitude", 0, 1.0)
        .units("1")
        .long_name("amplitude of a periodic motion of the mode, over that at which the contact first changes its state")
        .attribute("label", "Amplitude, of that of the first change of state (1)");
    let growth = along("growth_rate", 1, 1.0)
        .units("1/s")
        .long_name("growth rate that is taken off the motion")
        .attribute("label", "Growth rate $σ$ (1/s)");
    let frequency = along("frequency", 2, 1.0 / TAU)
        .units("Hz")
        .long_name("frequency of the motion")
        .attribute("label", "Frequency (Hz)");
    Ok(dataset.with(amplitude)?.with(growth)?.with(frequency)?)
}

/// A signal over the period.
fn signal(name: &str, unit: &str, words: &str, label: &str, values: Vec<f64>) -> Variable {
    let variable = Variable::new(name, &["phase"], &[values.len()], values).units(unit);
    variable.long_name(words).attribute("label", label)
}

fn period(
    dataset: Dataset,
    of: &AssemblySubject<'_>,
    sought: &CycleOfMode<'_>,
    cycle: &AssemblyCycle<'_>,
) -> Result<Dataset, ModelError> {
    let over = cycle.over_a_period(INSTANTS)?;
    let instants = over.forces.nrows();
    let phase: Vec<f64> = (0..instants).map(|k| k as f64 / instants as f64).collect();
    let time = phase.iter().map(|share| share * TAU / cycle.frequency()).collect();
    let mut dataset = dataset
        .attribute("cycle_amplitude", sought.amplitude())?
        .attribute(FREQUENCY, cycle.frequency() / TAU)?
        .attribute(SCALED_AT, cycle.balance.scaled_at() / TAU)?
        .attribute("attracts", cycle.attracts)?
        .with(
            Variable::coordinate("phase", phase)
                .units("1")
                .long_name("share of the period")
                .attribute("label", "Share of the period (1)"),
        )?
        .with(signal("time", "s", "time since the start of the period", "Time $t$ (s)", time))?;
    dataset = contact_points(dataset, of)?;
    let of_points = force_harmonics(cycle)?.into_iter().chain(of_points(cycle, &over));
    for variable in of_points.chain(of_contacts(of, cycle, &over)) {
        dataset = dataset.with(variable)?;
    }
    for variable in observed(of, cycle, instants)? {
        dataset = dataset.with(variable)?;
    }
    Ok(dataset)
}

/// States, forces and motions of the contact points.
fn of_points(cycle: &AssemblyCycle<'_>, over: &PointsOverPeriod) -> [Variable; 6] {
    let (instants, points) = (over.forces.nrows(), cycle.points.len());
    let (dimensions, shape) = (["phase", "contact_point"], [instants, points]);
    let width = cycle.balance.contact().dimension;
    let of = |name: &str, unit: &str, words: &str, from: &Mat<f64>, component: usize| {
        let values = (0..instants).flat_map(|k| (0..points).map(move |p| from[(k, p * width + component)]));
        Variable::new(name, &dimensions, &shape, values.collect::<Vec<f64>>()).units(unit).long_name(words)
    };
    let state = |k: usize, p: usize| named_state(over.states[k][p], over.forces[(k, p * width + 1)]).number();
    let states: Vec<u8> =
        (0..instants).flat_map(|k| (0..points).map(move |p| (k, p))).map(|(k, p)| state(k, p)).collect();
    let slip = "velocity of the slider beside the track along the slip";
    [
        Variable::classes("state", &dimensions, &shape, states, &ContactState::CODES)
            .long_name("what each contact point does"),
        of("point_normal_force", "N", "normal force of each contact point", &over.forces, 0),
        of(
            "point_friction_force",
            "N",
            "friction on the slider along the slip at each contact point",
            &over.forces,
            1,
        ),
        of(GAP, "m", "gap of each contact point", &over.motions, 0),
        of("slip_velocity", "m/s", slip, &over.motions, 1),
        of(
            "slip_displacement",
            "m",
            "displacement that belongs to it, about its mean",
            &slips(cycle, &over.motions),
            1,
        ),
    ]
}

/// Displacements along the contact about their mean, a column a component as of the motions.
fn slips(cycle: &AssemblyCycle<'_>, motions: &Mat<f64>) -> Mat<f64> {
    let series = Series::new(cycle.balance.series().harmonics(), motions.nrows());
    let velocity = series.of_values(motions.as_ref());
    let turning = |k: usize| k.div_ceil(2) as f64 * cycle.frequency();
    // the integral of a cos ωt + b sin ωt is (a sin ωt − b cos ωt)/ω
    let displacement = Mat::from_fn(velocity.nrows(), velocity.ncols(), |k, component| match k {
        0 => 0.0,
        k if k % 2 == 1 => -velocity[(k + 1, component)] / turning(k),
        k => velocity[(k - 1, component)] / turning(k),
    });
    series.values(displacement.as_ref())
}

/// N and T of each contact.
fn of_contacts(
    of: &AssemblySubject<'_>,
    cycle: &AssemblyCycle<'_>,
    over: &PointsOverPeriod,
) -> Vec<Variable> {
    let width = cycle.balance.contact().dimension;
    let mut first = 0;
    let signals = of.built.assembly.interfaces.iter().flat_map(|interface| {
        let own = first..first + interface.points.len();
        first = own.end;
        let sum = |component: usize| -> Vec<f64> {
            let at = |k: usize| own.clone().map(|p| over.forces[(k, p * width + component)]).sum();
            (0..over.forces.nrows()).map(at).collect()
        };
        let name = &interface.name;
        [
            signal(
                &format!("{name}.normal_force"),
                "N",
                &format!("normal forces of {name}"),
                &format!("Normal force of {name}, $N$ (N)"),
                sum(0),
            ),
            signal(
                &format!("{name}.friction_force"),
                "N",
                &format!("friction on the slider along the slip of {name}"),
                &format!("Friction of {name}, $T$ (N)"),
                sum(1),
            ),
        ]
    });
    signals.collect()
}

/// Acceleration, velocity and displacement of each observed point along each direction.
fn observed(
    of: &AssemblySubject<'_>,
    cycle: &AssemblyCycle<'_>,
    instants: usize,
) -> Result<Vec<Variable>, ModelError> {
    let series = Series::new(cycle.balance.series().harmonics(), instants);
    let mut all = Vec::new();
    for own in &of.built.watched {
        let name = &own.name;
        let displacement = cycle.followed(&own.row)?;
        let values = |coefficients: &[f64]| {
            let column = Mat::from_fn(coefficients.len(), 1, |k, _| coefficients[k]);
            series.values(column.as_ref()).col_as_slice(0).to_vec()
        };
        let rates = |times: usize| [vec![0.0], differentiated(cycle, &displacement, times)].concat();
        all.extend([
            signal(
                name,
                "m/s^2",
                &format!("acceleration of the observed point, {name}"),
                &format!("Acceleration {name}, $ü$ (m/s^{{2}})"),
                values(&rates(2)),
            ),
            signal(
                &format!("{name}.velocity"),
                "m/s",
                &format!("velocity of the observed point, {name}"),
                &format!("Velocity {name}, $u̇$ (m/s)"),
                values(&rates(1)),
            ),
            signal(
                &format!("{name}.displacement"),
                "m",
                &format!("displacement of the observed point from the undeformed body, {name}"),
                &format!("Displacement {name}, $u$ (m)"),
                values(&displacement),
            ),
        ]);
    }
    Ok(all)
}
