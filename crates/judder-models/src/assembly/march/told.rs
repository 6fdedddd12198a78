//! What is told of a motion.

use super::blocks::{MotionStop, OngoingMotion};
use super::content::{ModeInMotion, SoughtContent};
use super::levels::OctaveLevels;
use super::settings::{AssemblyMarch, SchemeWord};
use crate::assembly::AssemblySubject;
use crate::error::ModelError;
use crate::sliding::march::sound::ToldSound;
use judder_nonsmooth::march::Works;
use judder_nonsmooth::statistics::{PointStatistics, StatisticErrors, standard_error};
use judder_numerics::signal::tone::strongest_frequency;
use judder_store::{ByName, Results};
use judder_study::outcome::CheckRecord;

/// What is told of a motion.
#[derive(Results)]
pub(super) struct ToldAssemblyMotion {
    /// how the motion is integrated
    method: &'static str,
    steps: u64,
    /// the step, in s
    step_s: f64,
    /// by the clock on the wall, of the steps alone
    seconds: f64,
    /// the strongest line of the velocity along the slip of the point that moves most, in Hz; none where nothing moves
    pub(super) frequency_hz: Option<f64>,
    /// its standard error, by the strongest lines of twenty stretches, in Hz; none where a stretch has fewer than ten periods, or no line
    frequency_error_hz: Option<f64>,
    /// all normal forces together, on average
    #[result(unit = "N")]
    normal_force_mean: f64,
    /// its standard error by batch means, as of all errors below; none of fewer than twenty steps
    #[result(unit = "N")]
    normal_force_mean_error: Option<f64>,
    /// the friction on the sliders along the slip, on average
    #[result(unit = "N")]
    friction_force_mean: f64,
    #[result(unit = "N")]
    friction_force_mean_error: Option<f64>,
    /// what goes into the bodies, on average, in W
    power: ToldPower,
    /// by how much the energy of the bodies changed otherwise than the power says, over the largest of works and energies
    #[result(unit = "1")]
    energy_balance: f64,
    /// the largest residual of the contact of a step: impulses beside those that it allows, over the largest of steady sliding; none where no
    /// contact is solved
    #[result(unit = "1")]
    contact_residual: Option<f64>,
    /// steps whose contact was not solved to its tolerance
    contact_unsolved: u64,
    /// sweeps over the contact points in a step, on average
    #[result(unit = "1")]
    contact_sweeps: f64,
    /// the lowest complex modes about steady sliding, and how much of each the motion has
    modes: Vec<ModeInMotion>,
    /// each contact
    contacts: ByName<ContactInMotion>,
    /// accelerations of the observed points after the transient, in octave bands
    levels: ByName<OctaveLevels>,
    /// accelerations of the observed points as sound
    sound: Vec<ToldSound>,
    /// why it ended before its duration
    #[result(optional)]
    ended: Option<ToldStop>,
}

/// When and why a motion ended before its duration.
#[derive(Results)]
struct ToldStop {
    /// the last step that it took, in s
    time_s: f64,
    reason: String,
}

/// What goes into the bodies.
#[derive(Results)]
pub(super) struct ToldPower {
    /// from the friction forces
    #[result(unit = "W")]
    friction: f64,
    /// taken by the damping
    #[result(unit = "W")]
    damping: f64,
    /// taken by impacts, or held by compliant contacts
    #[result(unit = "W")]
    impacts: f64,
    /// from the track's drive: of friction, with what becomes heat, and where points travel of the slope
    #[result(unit = "W")]
    drive: f64,
    /// what becomes heat where bodies slide
    #[result(unit = "W")]
    heat: f64,
    /// from normal forces on the slope of a track along which points travel
    #[result(unit = "W", optional)]
    slope: Option<f64>,
    /// from excitations, and from what a course adds to the loads
    #[result(unit = "W", optional)]
    excitation: Option<f64>,
    /// from stiffness that is not symmetric
    #[result(unit = "W", optional)]
    circulation: Option<f64>,
    /// from modes above the cut-off, which follow forces at once and do not swing on
    #[result(unit = "W", optional)]
    flexibility: Option<f64>,
    /// taken by the scheme itself, with an `implicitness` above 0.5
    #[result(unit = "W", optional)]
    scheme: Option<f64>,
}

/// The points of a contact, as lists.
#[derive(Results)]
pub(super) struct ContactInMotion {
    /// where each lies along x, in m
    x_m: Vec<f64>,
    /// the share of the time in which it sticks
    stick_share: Vec<f64>,
    /// in which it slides
    slip_share: Vec<f64>,
    /// in which it has lifted off
    open_share: Vec<f64>,
    /// the velocity of the slider beside the track along the slip about its mean, as root mean square
    #[result(unit = "m/s")]
    tangential_velocity_rms: Vec<f64>,
    /// its normal force, on average
    #[result(unit = "N")]
    normal_force_mean: Vec<f64>,
    /// the standard errors of these
    #[result(unit = "1")]
    stick_share_error: Vec<Option<f64>>,
    #[result(unit = "1")]
    slip_share_error: Vec<Option<f64>>,
    #[result(unit = "1")]
    open_share_error: Vec<Option<f64>>,
    /// in m/s
    #[result(unit = "m/s")]
    tangential_velocity_rms_error: Vec<Option<f64>>,
    /// in N
    #[result(unit = "N")]
    normal_force_mean_error: Vec<Option<f64>>,
}

/// What rigid contact may give, over the largest of works.
const GIVEN: f64 = 1e-2;
/// What the balance of energy may be off, over the largest of works and energies.
const BALANCE: f64 = 1e-6;

impl OngoingMotion<'_, '_> {
    /// What each point did after the transient.
    fn points(&self) -> Vec<PointStatistics> {
        (0..self.march.contact().points.len()).filter_map(|point| self.statistics.of(point)).collect()
    }

    /// By how much the energy of the bodies changed otherwise than by the work done on them, in J, and the largest of the works and energies that it is made of.
    fn balance(&self) -> [f64; 2] {
        let (works, energy) = (self.march.works(), self.march.energy());
        let gained = energy.kinetic + energy.potential - self.first_energy;
        let parts = works.parts();
        let told: f64 = parts.iter().sum();
        let sizes = parts.iter().chain([&energy.kinetic, &energy.potential]);
        let exchanged = sizes.fold(f64::MIN_POSITIVE, |most, own| most.max(own.abs()));
        [(gained - told).abs(), exchanged]
    }

    /// The largest residual of a step's contact; none where none is solved.
    fn contact_residual(&self, asked: &AssemblyMarch) -> Option<f64> {
        let solves = asked.method != SchemeWord::Smoothed && !self.march.contact().points.is_empty();
        solves.then(|| self.march.record().residual)
    }

    /// All that is told.
    pub(super) fn told(
        &self,
        of: &AssemblySubject<'_>,
        asked: &AssemblyMarch,
        sound: Vec<ToldSound>,
        levels: Vec<(String, OctaveLevels)>,
    ) -> Result<ToldAssemblyMotion, ModelError> {
        let (points, works, record) = (self.points(), self.march.works(), self.march.record());
        let [off, exchanged] = self.balance();
        let time = self.statistics.steps() as f64 * asked.step;
        let mean = |pick: fn(&Works) -> f64| (pick(&works) - pick(&self.settled)) / time;
        let sum = |pick: fn(&PointStatistics) -> f64| points.iter().map(pick).sum::<f64>();
        // of a march that ended before its averages begin nothing is known
        let known = |value: f64| if self.statistics.steps() > 0 { value } else { f64::NAN };
        let frequency = self.frequency(&points, asked.transient)?;
        let errors = self.statistics.force_errors();
        Ok(ToldAssemblyMotion {
            method: asked.method.name(),
            steps: self.march.steps(),
            step_s: asked.step,
            seconds: self.seconds,
            frequency_hz: frequency.value,
            frequency_error_hz: frequency.error,
            normal_force_mean: known(sum(|own| own.normal_force_mean)),
            normal_force_mean_error: errors.map(|[normal, _]| normal),
            friction_force_mean: known(sum(|own| own.friction_force_mean)),
            friction_force_mean_error: errors.map(|[_, friction]| friction),
            power: ToldPower {
                friction: mean(|own| own.friction),
                damping: mean(|own| own.damping),
                impacts: mean(|own| own.normal - own.slope),
                drive: mean(|own| own.friction + own.heat + own.slope),
                heat: mean(|own| own.heat),
                slope: (!of.built.travelling.is_empty()).then(|| mean(|own| own.slope)),
                excitation: (works.excitation != 0.0 || asked.driven.is_driven())
                    .then(|| mean(|own| own.excitation)),
                circulation: (works.circulation != 0.0).then(|| mean(|own| own.circulation)),
                flexibility: asked.cut_off.map(|_| mean(|own| own.flexibility)),
                scheme: asked.implicitness.map(|_| mean(|own| own.scheme)),
            },
            energy_balance: off / exchanged,
            contact_residual: self.contact_residual(asked),
            contact_unsolved: record.unsolved,
            contact_sweeps: record.iterations as f64 / self.march.steps().max(1) as f64,
            modes: self.content.as_ref().map(SoughtContent::told).unwrap_or_default(),
            contacts: contacts(of, &points),
            levels: levels.into_iter().collect(),
            sound,
            ended: self
                .ended
                .as_ref()
                .map(|ended| ToldStop { time_s: ended.time, reason: ended.reason.clone() }),
        })
    }

    /// The strongest line of the velocity of the point that moves most, after the transient.
    fn frequency(&self, points: &[PointStatistics], transient: f64) -> Result<MotionFrequency, ModelError> {
        let rms = |k: &usize| points[*k].tangential_velocity_rms;
        let Some(most) = (0..points.len()).max_by(|a, b| rms(a).total_cmp(&rms(b))) else {
            return Ok(MotionFrequency::default());
        };
        let (time, velocity) = (self.samples.values("time")?, self.samples.column("velocity", most)?);
        let first = time.partition_point(|time| *time <= transient);
        Ok(MotionFrequency::of(velocity.get(first..).unwrap_or_default(), self.recorded.rate()))
    }

    /// What rigid contact gave to the bodies, over the largest of works; none where its normal forces may hold energy, or nothing is solved.
    fn given_by_contact(&self, asked: &AssemblyMarch) -> Option<f64> {
        let contact = self.march.contact();
        let is_rigid = (0..contact.points.len()).all(|point| !contact.is_compliant(point));
        self.contact_residual(asked).filter(|_| is_rigid)?;
        let works = self.march.works();
        let sizes = [works.friction, works.normal, works.slope, works.damping, works.excitation];
        let most = sizes.iter().fold(f64::MIN_POSITIVE, |most, own| most.max(own.abs()));
        Some((works.normal - works.slope).max(0.0) / most)
    }

    /// The contact of every step, and the balance of energy.
    pub(super) fn checks(&self, asked: &AssemblyMarch) -> Vec<CheckRecord> {
        let (steps, points) = (self.march.steps(), self.march.contact().points.len());
        let [off, exchanged] = self.balance();
        let contact = self.contact_residual(asked).map(|residual| {
            CheckRecord::new(
                "impulses and velocities complement each other at every contact point",
                format!("largest residual of {steps} steps, {points} points"),
                residual.into(),
                self.march.settings().accuracy.tolerance,
            )
        });
        let energy = CheckRecord::new(
            "the energy of the bodies changes by the work done on them",
            format!("difference over the largest of works and energies, {exchanged:.3e} J"),
            (off / exchanged).into(),
            BALANCE,
        );
        let known = (asked.method == SchemeWord::Ensubs).then(|| {
            CheckRecord::new(
                "points slide as is known beforehand",
                format!("share of {steps} steps in which a pressed point does not"),
                (self.march.record().against as f64 / steps.max(1) as f64).into(),
                0.0,
            )
        });
        let given = self.given_by_contact(asked).map(|given| {
            CheckRecord::new(
                "rigid contact takes energy and gives none",
                "what normal impulses gave, over the largest of works".to_owned(),
                given.into(),
                GIVEN,
            )
        });
        contact.into_iter().chain(known).chain(given).chain([energy]).collect()
    }

    /// What to know before the numbers are trusted.
    pub(super) fn warnings(&self, asked: &AssemblyMarch, travels: bool) -> Vec<String> {
        let mut warnings = Vec::new();
        if let Some(MotionStop { time, reason }) = &self.ended {
            warnings.push(format!(
                "the march ended at {time:.6} s, before its duration: {reason}; what it had computed until then is kept"
            ));
        }
        if travels && self.content.is_ok() {
            warnings.push("the modes that are looked for in the motion are those of the places where the points begin to travel".to_owned());
        }
        if let Err(error) = &self.content {
            warnings.push(format!("which modes the motion contains is not known: {error}"));
        }
        if self.given_by_contact(asked).is_some_and(|given| given > GIVEN) {
            warnings.push("rigid contact gives energy to bodies that swing within a step: a shorter step takes that away, or by `moreau` an `implicitness` near 1".to_owned());
        }
        let record = self.march.record();
        if let Some((time, point)) = record.first_against {
            warnings.push(format!(
                "in {} of {} steps a point does not slide as `ensubs` takes it to, first at {time} s contact point {}: it would stick or turn, and friction drives it; \
                 take `film` or `moreau`",
                record.against,
                self.march.steps(),
                point + 1,
            ));
        }
        if let Some((time, point)) = record.first_unsolved {
            warnings.push(format!(
                "in {} of {} steps the contact is not solved to its tolerance, first at {time} s at contact point {}, at worst with the residual \
                 {:.1e}: a shorter step helps",
                record.unsolved,
                self.march.steps(),
                point + 1,
                record.residual,
            ));
        }
        warnings
    }
}

/// Stretches of which a frequency has its error, and the periods that each has at least.
const STRETCHES: (usize, f64) = (20, 10.0);

/// The strongest line of a signal in Hz, and its standard error.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
struct MotionFrequency {
    value: Option<f64>,
    error: Option<f64>,
}

impl MotionFrequency {
    fn of(signal: &[f64], rate: f64) -> Self {
        let value = strongest_frequency(signal, rate);
        let (count, periods) = STRETCHES;
        let length = signal.len() / count;
        let is_long = value.is_some_and(|value| length as f64 * value >= periods * rate);
        let stretches = signal.chunks_exact(length.max(1)).take(count);
        let lines = || stretches.map(|stretch| strongest_frequency(stretch, rate)).collect();
        let lines: Option<Vec<f64>> = if is_long { lines() } else { None };
        Self { value, error: lines.and_then(|lines| standard_error(&lines)) }
    }
}

fn contacts(of: &AssemblySubject<'_>, points: &[PointStatistics]) -> ByName<ContactInMotion> {
    let mut first = 0;
    let told = of.built.assembly.interfaces.iter().map(|interface| {
        let own = &points[first.min(points.len())..(first + interface.points.len()).min(points.len())];
        first += interface.points.len();
        let list = |pick: fn(&PointStatistics) -> f64| own.iter().map(pick).collect::<Vec<_>>();
        let errors = |pick: fn(&StatisticErrors) -> f64| {
            own.iter().map(|own| own.errors.as_ref().map(pick)).collect::<Vec<_>>()
        };
        let contact = ContactInMotion {
            x_m: interface.points.iter().map(|point| point.place[0]).collect(),
            stick_share: list(|own| own.stick_share),
            slip_share: list(|own| own.slip_share),
            open_share: list(|own| own.open_share),
            tangential_velocity_rms: list(|own| own.tangential_velocity_rms),
            normal_force_mean: list(|own| own.normal_force_mean),
            stick_share_error: errors(|own| own.stick_share),
            slip_share_error: errors(|own| own.slip_share),
            open_share_error: errors(|own| own.open_share),
            tangential_velocity_rms_error: errors(|own| own.tangential_velocity_rms),
            normal_force_mean_error: errors(|own| own.normal_force_mean),
        };
        (interface.name.clone(), contact)
    });
    told.collect()
}
