//! `motion`: the history of one motion.

use super::sound::{ToldSounds, sound};
use super::watched::Blocks;
use crate::error::ModelError;
use crate::motion::amplitude_spectrum::amplitude_spectrum;
use crate::motion::doubts;
use crate::motion::history::HistoryAnalysis;
use crate::motion::model::{ContactMemory, Coordinate, Moving, Operating};
use crate::motion::si::{EnergyFlow, MotionInSi, SiUnits};
use judder_oscillator::motion::attractor::{distance, repetition};
use judder_oscillator::motion::history::{
    MotionHistory, Oscillation, StateSample, TimeWindow, follow, follow_watched,
};
use judder_oscillator::motion::{ContactState, SlidingSystem};
use judder_store::{Dataset, Declared, Results, Table, Variable};
use judder_study::Progress;
use judder_study::model::SampleBlock;
use judder_study::outcome::{CheckRecord, Outcome};

/// What the works may leave of the change of energy, over the largest of them.
const ENERGY_LIMIT: f64 = 1e-4;
/// Distance of two returns, over their distance from steady sliding, below which the motion repeats itself.
const SAME: f64 = 1e-4;
/// rms, over the magnitude of steady sliding, below which a motion is rounding about it.
const AT_REST: f64 = 1e-12;
/// The most oscillations in a period.
const OSCILLATIONS: usize = 8;

pub(crate) fn run<M: Moving<N>, const N: usize>(
    model: &M,
    asked: &HistoryAnalysis,
    progress: &dyn Progress,
    watch: Option<&mut dyn FnMut(SampleBlock)>,
) -> Result<Outcome, ModelError> {
    let operating = model.operating(None)?;
    let [duration, transient] = [asked.duration, asked.transient].map(|time| operating.time(time));
    let window = TimeWindow { duration, transient, points: asked.points };
    let (start, settings) = (operating.start(&asked.start), operating.settings(&asked.following()));
    let (system, interrupted) = (&operating.system, || progress.interrupted());
    let history = match watch {
        None => follow(system, start, settings, &window, &interrupted)?,
        Some(watch) => {
            let mut blocks = Blocks::<M, N>::new(watch);
            let history = follow_watched(system, start, settings, &window, &interrupted, |news| {
                blocks.add(news.samples);
            })?;
            blocks.show();
            history
        }
    };
    progress.advance();
    let mut told = told::<M, N>(&operating, &history);
    told.tell_si(operating.si);
    let mut scalars = told.scalars();
    let [duration_s, transient_s] =
        [duration, transient].map(|time| operating.si.map(|units| units.second * time));
    scalars.extend(ToldWindow { duration, transient, duration_s, transient_s }.scalars());
    // a case without seconds that asks for a sound is not read
    let heard = operating.si.filter(|_| asked.sound == Some(true));
    let sound = heard.map(|units| sound(model.name(), units, &history, &window)).transpose()?;
    scalars.extend(sound.as_ref().map(|own| own.told.scalars()).into_iter().flatten());
    let arrays = Arrays::<M, N> { operating: &operating, history: &history };
    Ok(Outcome {
        scalars,
        dataset: arrays.in_si(arrays.with_spectrum(arrays.dataset()?, &window)?)?,
        table: Some(arrays.table()?),
        checks: energy_check(&history).into_iter().collect(),
        warnings: doubts::beyond_law::<M, N>(&operating, &history.samples).into_iter().collect(),
        files: sound.into_iter().map(|own| (own.name, own.bytes)).collect(),
        ..Outcome::default()
    })
}

/// Whether there is a motion to speak of.
fn moves<const N: usize>(system: &impl SlidingSystem<N>, history: &MotionHistory<N>) -> bool {
    history.measures.rms() > AT_REST * system.scales()[0]
}

/// What is told of a motion.
#[derive(Results)]
pub(crate) struct ToldMotion {
    #[result(unit = "1")]
    rms: f64,
    #[result(unit = "1")]
    mean: f64,
    /// of a cycle; the mean time of an oscillation where there is none
    #[result(unit = "1")]
    pub(crate) period: Option<f64>,
    pub(crate) repeats: bool,
    stick_fraction: f64,
    slip_ahead_fraction: f64,
    lift_off_fraction: f64,
    pub(crate) oscillations: usize,
    /// of the contact state
    changes: usize,
    steps: usize,
    energy: EnergyBalance,
    #[result(optional)]
    quasi_steady: Option<ToldMemory>,
    #[result(flatten)]
    si: Option<MotionInSi>,
}

impl ToldMotion {
    /// Tells rms, mean, period and energies in SI as well.
    pub(crate) fn tell_si(&mut self, units: Option<SiUnits>) {
        self.si = units.map(|units| units.motion([self.rms, self.mean], self.period, self.energy.flow));
    }
}

/// Where energy came from and went, in units of k_x x0², of a belt of its stiffness times 1 m²; what is left over the largest of them.
#[derive(Results)]
struct EnergyBalance {
    #[result(flatten)]
    flow: EnergyFlow,
    #[result(unit = "1")]
    residual: f64,
}

/// The paper's condition for its law: its largest magnitude, and the shares of the time in which it is above 0.1 and 1.
#[derive(Results)]
struct ToldMemory {
    #[result(unit = "1")]
    largest: f64,
    #[result(unit = "1", summary = "above_0.1")]
    above_tenth: f64,
    #[result(unit = "1")]
    above_1: f64,
}

/// What is told of the time over which a motion was followed.
#[derive(Results)]
struct ToldWindow {
    #[result(unit = "1")]
    duration: f64,
    #[result(unit = "1")]
    transient: f64,
    #[result(optional, unit = "s")]
    duration_s: Option<f64>,
    #[result(optional, unit = "s")]
    transient_s: Option<f64>,
}

/// The keys of the summary of a motion.
pub(crate) fn summary_keys(has_sound: bool) -> Vec<Declared> {
    let sounds = if has_sound { ToldSounds::declared() } else { Vec::new() };
    [ToldMotion::declared(), ToldWindow::declared(), sounds].concat()
}

/// What `summary.json` shows of a history.
pub(crate) fn told<M: Moving<N>, const N: usize>(
    operating: &Operating<M::System>,
    history: &MotionHistory<N>,
) -> ToldMotion {
    let measures = &history.measures;
    let oscillations = if moves(&operating.system, history) { history.oscillations.as_slice() } else { &[] };
    let period = period(&operating.system, oscillations);
    ToldMotion {
        rms: measures.rms(),
        mean: operating.system.steady_sliding()[0] + measures.mean(),
        period: period.map(|(period, _)| period),
        repeats: period.is_some_and(|(_, repeats)| repeats),
        stick_fraction: measures.fraction(ContactState::Stick),
        slip_ahead_fraction: measures.fraction(ContactState::SlipAhead),
        lift_off_fraction: measures.fraction(ContactState::LiftOff),
        oscillations: oscillations.len(),
        changes: measures.changes,
        steps: history.steps,
        energy: energy(history),
        quasi_steady: M::memory(&operating.system).map(|memory| quasi_steady(&memory, oscillations)),
        si: None,
    }
}

/// The period, and whether the motion repeats itself in it; else the mean time of an oscillation. `None` without any.
fn period<const N: usize>(
    system: &impl SlidingSystem<N>,
    oscillations: &[Oscillation<N>],
) -> Option<(f64, bool)> {
    let last = oscillations.last()?;
    let returns = oscillations.iter().rev().take(3 * OSCILLATIONS).map(|o| (o.time, o.state)).collect();
    let scales = system.scales();
    let allowed = SAME * distance(&last.state, &system.steady_sliding(), &scales);
    let time = |count: usize| oscillations.iter().rev().take(count).map(|o| o.period).sum::<f64>();
    Some(match repetition(&returns, &scales, allowed, OSCILLATIONS) {
        Some(count) => (time(count), true),
        None => (time(oscillations.len()) / oscillations.len() as f64, false),
    })
}

fn energy<const N: usize>(history: &MotionHistory<N>) -> EnergyBalance {
    let work = &history.measures.work;
    let flow = EnergyFlow {
        substrate: work.substrate,
        sliding: work.friction - work.substrate,
        friction: work.friction,
        normal: work.normal,
        damping: work.damping,
        change: history.energy_change,
    };
    EnergyBalance { flow, residual: history.energy_residual() }
}

/// That of the work; `None` where so little moved that the steps do not resolve it.
pub(crate) fn energy_check<const N: usize>(history: &MotionHistory<N>) -> Option<CheckRecord> {
    let work = &history.measures.work;
    let parts = [work.friction, work.normal, work.damping, history.energy_change];
    parts.iter().any(|part| part.abs() > history.energy_resolution).then(|| {
        CheckRecord::new(
            "the work is stored or dissipated",
            "works of friction, normal force and dampers against the change of energy, beyond what the steps resolve, over the largest of them",
            history.energy_residual().into(),
            ENERGY_LIMIT,
        )
    })
}

fn condition<const N: usize>(memory: &ContactMemory, oscillation: &Oscillation<N>) -> f64 {
    oscillation.quasi_steady_condition(memory.belt_velocity, memory.retardation_time)
}

fn quasi_steady<const N: usize>(memory: &ContactMemory, oscillations: &[Oscillation<N>]) -> ToldMemory {
    let time: f64 = oscillations.iter().map(|o| o.period).sum();
    let above = |limit: f64| {
        let beyond = oscillations.iter().filter(|o| condition(memory, o).abs() > limit);
        // an empty sum of `sum` is −0
        beyond.fold(0.0, |sum, o| sum + o.period) / time
    };
    let largest = oscillations.iter().map(|o| condition(memory, o).abs()).fold(f64::NAN, f64::max);
    ToldMemory { largest, above_tenth: above(0.1), above_1: above(1.0) }
}

/// A history as arrays.
pub(crate) struct Arrays<'a, M: Moving<N>, const N: usize> {
    pub(crate) operating: &'a Operating<M::System>,
    pub(crate) history: &'a MotionHistory<N>,
}

impl<M: Moving<N>, const N: usize> Arrays<'_, M, N> {
    /// Every quantity on the grid of time.
    fn along_time(&self) -> Vec<(Coordinate, Vec<f64>)> {
        let samples = &self.history.samples;
        let mut further: Vec<Vec<f64>> = vec![Vec::with_capacity(samples.len()); M::FURTHER.len()];
        for sample in samples {
            for (values, value) in further.iter_mut().zip(M::further(&self.operating.system, sample)) {
                values.push(value);
            }
        }
        let coordinates = M::COORDINATES.into_iter().enumerate();
        coordinates
            .map(|(k, coordinate)| (coordinate, samples.iter().map(|s| s.state[k]).collect()))
            .chain(M::FURTHER.iter().copied().zip(further))
            .collect()
    }

    pub(crate) fn dataset(&self) -> Result<Dataset, ModelError> {
        let samples = &self.history.samples;
        let count = samples.len();
        let times: Vec<f64> = samples.iter().map(|s| s.time).collect();
        let time = Variable::coordinate("time", times).units("1").long_name(M::CLOCK.time);
        let mut dataset =
            Dataset::new().with(time.attribute("label", format!("Time ${}$ (−)", M::CLOCK.symbol)))?;
        for (coordinate, values) in self.along_time() {
            dataset = dataset.with(
                Variable::new(coordinate.name, &["time"], &[count], values)
                    .units("1")
                    .long_name(coordinate.long_name)
                    .attribute("label", coordinate.label),
            )?;
        }
        let states = samples.iter().map(|s| s.contact_state.number()).collect();
        let states = Variable::classes("contact_state", &["time"], &[count], states, &ContactState::CODES)
            .long_name("contact state");
        self.with_oscillations(self.with_path(self.with_events(dataset.with(states)?)?)?)
    }

    /// A dataset that says what its arrays are in SI, where the case is written in SI.
    pub(crate) fn in_si(&self, dataset: Dataset) -> Result<Dataset, ModelError> {
        match self.operating.si {
            Some(units) => units.told_in(dataset),
            None => Ok(dataset),
        }
    }

    fn with_events(&self, dataset: Dataset) -> Result<Dataset, ModelError> {
        let events = &self.history.events;
        let count = events.len();
        let times: Vec<f64> = events.iter().map(|e| e.time).collect();
        let mut dataset = dataset.with(
            Variable::new("event_time", &["event"], &[count], times)
                .units("1")
                .long_name(&format!("time {} of a change of the contact state", M::CLOCK.symbol)),
        )?;
        let states = |name: &str, long_name: &str, codes: Vec<u8>| {
            Variable::classes(name, &["event"], &[count], codes, &ContactState::CODES).long_name(long_name)
        };
        let (from, to) = (
            events.iter().map(|e| e.from.number()).collect(),
            events.iter().map(|e| e.to.number()).collect(),
        );
        dataset = dataset.with(states("event_from", "contact state that ends", from))?.with(states(
            "event_to",
            "contact state that begins",
            to,
        ))?;
        for (k, coordinate) in M::COORDINATES.into_iter().enumerate() {
            let values: Vec<f64> = events.iter().map(|e| e.state[k]).collect();
            let name = format!("event_{}", coordinate.name);
            dataset = dataset.with(
                Variable::new(&name, &["event"], &[count], values).units("1").long_name(coordinate.long_name),
            )?;
        }
        Ok(dataset)
    }

    fn with_path(&self, mut dataset: Dataset) -> Result<Dataset, ModelError> {
        let path = &self.history.path;
        let over = |name: &str, long_name: &str, value: &dyn Fn(&StateSample<N>) -> f64| {
            let values: Vec<f64> = path.iter().map(value).collect();
            Variable::new(name, &["step"], &[values.len()], values).units("1").long_name(long_name)
        };
        let end = format!("end of a step that does not end in stick, {}", M::CLOCK.symbol);
        dataset = dataset.with(over("path_time", &end, &|s| s.time))?;
        for (k, coordinate) in M::COORDINATES.into_iter().enumerate() {
            let name = format!("path_{}", coordinate.name);
            dataset = dataset.with(over(&name, coordinate.long_name, &|s| s.state[k]))?;
        }
        Ok(dataset)
    }

    fn with_oscillations(&self, dataset: Dataset) -> Result<Dataset, ModelError> {
        let oscillations = &self.history.oscillations;
        let over = |name: &str, long_name: &str, value: &dyn Fn(&Oscillation<N>) -> f64| {
            let values: Vec<f64> = oscillations.iter().map(value).collect();
            Variable::new(name, &["oscillation"], &[values.len()], values).units("1").long_name(long_name)
        };
        let mut dataset = dataset
            .with(over("oscillation_time", "end of an oscillation, where x is largest", &|o| o.time))?
            .with(over("oscillation_period", "time of an oscillation", &|o| o.period))?
            .with(over("oscillation_amplitude", "half the range of x", &|o| o.amplitude))?;
        for (k, coordinate) in M::COORDINATES.into_iter().enumerate().filter(|(k, _)| *k != N / 2) {
            let name = format!("section_{}", coordinate.name);
            let variable = over(&name, coordinate.long_name, &|o| o.state[k]);
            dataset = dataset.with(variable.attribute("label", coordinate.label))?;
        }
        match M::memory(&self.operating.system) {
            Some(memory) => Ok(dataset.with(over(
                "quasi_steady_condition",
                "(ω − v_d/A_x) τ of an oscillation, eq. (3)",
                &|o| condition(&memory, o),
            ))?),
            None => Ok(dataset),
        }
    }

    /// With the spectrum of x after the transient.
    fn with_spectrum(&self, dataset: Dataset, window: &TimeWindow) -> Result<Dataset, ModelError> {
        let late = |sample: &&StateSample<N>| sample.time >= window.transient;
        let values: Vec<f64> = self.history.samples.iter().filter(late).map(|s| s.state[0]).collect();
        let step = window.duration / (window.points - 1) as f64;
        let (frequency, amplitude) = amplitude_spectrum(&values, step);
        let count = frequency.len();
        Ok(dataset
            .with(Variable::coordinate("frequency", frequency).units("1").long_name(M::CLOCK.frequency))?
            .with(
                Variable::new("amplitude", &["frequency"], &[count], amplitude)
                    .units("1")
                    .long_name("amplitude of x about its mean, after the transient"),
            )?)
    }

    pub(crate) fn table(&self) -> Result<Table, ModelError> {
        let samples = &self.history.samples;
        let times: Vec<f64> = samples.iter().map(|s| s.time).collect();
        let mut table = Table::new().column("time", "1", times.clone())?;
        let all = self.along_time();
        for (coordinate, values) in &all {
            table = table.column(coordinate.name, "1", values.clone())?;
        }
        if let Some(units) = self.operating.si {
            table = units.add_column(table, "time", &times)?;
            for (coordinate, values) in &all {
                table = units.add_column(table, coordinate.name, values)?;
            }
        }
        let words: Vec<String> = samples.iter().map(|s| s.contact_state.to_string()).collect();
        Ok(table.column("contact_state", "", words)?)
    }
}
