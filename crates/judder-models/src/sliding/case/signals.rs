//! What a march keeps of its motion: which signals, how they are sampled, which of them are left as sound.

use super::observe::{ObservedPoint, PointQuantity, Signal};
use super::problem::SlidingProblem;
use judder_keys::Settings;
use judder_keys::declared::{Allowed, Named, Number, Setting, Several, all};
use judder_keys::dimension::Dimension;
use judder_keys::document::{Data, Node};
use judder_keys::error::Fault;
use judder_keys::section::{Section, wrong_type};
use serde_json::{Value as Json, json};
use std::f64::consts::TAU;

/// How signals are sampled on line, low-passed, then decimated, and what is kept of the observed points.
#[derive(Debug, Clone, PartialEq, Settings)]
#[settings(check = Sampling::sort)]
pub struct Sampling {
    /// Up to which sampled signals are kept as they are.
    #[key(rule = FREQUENCY, symbol = "ω", default = 50e3 * TAU)]
    pub pass_band: f64,
    /// Samples per time at least: the steps between samples are a whole number; every step where steps are longer.
    #[key(symbol = "2π f_s", default = Hertz(400e3))]
    pub sample_rate: Hertz,
    /// What is kept of the motion of every observed point, along x and y.
    #[key(rule = QUANTITIES, default = vec![PointQuantity::Acceleration])]
    pub quantities: Vec<PointQuantity>,
}

/// A frequency whose number is in Hz.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hertz(pub f64);

/// Which signals are left as sound.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum SoundSignals {
    /// None.
    Nothing,
    /// All accelerations that are kept, and the signal whose bursts are told.
    Accelerations,
    /// These.
    Signals(Vec<Named<Signal>>),
}

const QUANTITIES: Several<()> = Several { of: (), length: [0, usize::MAX] };
const FREQUENCY: Number = Number::positive(Dimension::ANGULAR_FREQUENCY);
/// A rate of exactly twice the pass band is none above it, however the factor 2π rounds.
const ROUNDING: f64 = 1e-9;

impl Sampling {
    /// The quantities in the order in which they are stored, whatever order the case has them in.
    fn sort(&mut self, _: &Section<'_>) -> Result<(), Fault> {
        let all = PointQuantity::ALL.into_iter().map(|(_, quantity)| quantity);
        self.quantities = all.filter(|quantity| self.quantities.contains(quantity)).collect();
        Ok(())
    }

    /// Refuses a rate that does not carry the pass band, or that steps of `step` seconds do not reach.
    pub(crate) fn check(&self, step: Option<f64>) -> Result<(), SlidingProblem> {
        let (Hertz(sample_rate), pass_band) = (self.sample_rate, self.pass_band / TAU);
        let refuse = |reason: String| Err(SlidingProblem::SampleRate { sample_rate, reason });
        if sample_rate <= 2.0 * pass_band * (1.0 + ROUNDING) {
            return refuse(format!("cannot carry frequencies up to {pass_band:.0} Hz"));
        }
        match step {
            Some(step) if sample_rate * step > 1.0 => {
                refuse(format!("are more than one a step of {step:e} s"))
            }
            _ => Ok(()),
        }
    }
}

impl Setting for Hertz {
    type Rule = ();

    fn form((): &()) -> Allowed {
        Allowed::Number(FREQUENCY)
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, (): &()) -> Result<Self, Fault> {
        Ok(Self(f64::read(section, key, node, &FREQUENCY)? / TAU))
    }

    fn write(&self, (): &()) -> Json {
        (self.0 * TAU).write(&FREQUENCY)
    }
}

impl SoundSignals {
    /// Finds the signals, each once, that are heard.
    pub(crate) fn admit(&mut self, node: Option<&Node>, points: &[ObservedPoint]) -> Result<(), Fault> {
        let (Self::Signals(heard), Some(Node { data: Data::List(items), .. })) = (self, node) else {
            return Ok(());
        };
        heard.clear();
        for found in all(items.iter().map(|item| Signal::read("sound", item, points)))? {
            if heard.iter().all(|other| **other != found) {
                heard.push(Named { name: found.name(points), found });
            }
        }
        Ok(())
    }
}

impl Setting for SoundSignals {
    type Rule = ();

    fn form((): &()) -> Allowed {
        let signals = Allowed::List { of: Box::new(Allowed::Text), length: [0, usize::MAX] };
        Allowed::Either(vec![Allowed::Flag, signals])
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, (): &()) -> Result<Self, Fault> {
        match node.data {
            Data::Boolean(true) => Ok(Self::Accelerations),
            Data::Boolean(false) => Ok(Self::Nothing),
            // found when the points are known
            Data::List(_) => Ok(Self::Signals(Vec::new())),
            _ => Err(wrong_type(&section.path(key), "true, false or a list of signals", node)),
        }
    }

    fn write(&self, (): &()) -> Json {
        match self {
            Self::Nothing => json!(false),
            Self::Accelerations => json!(true),
            Self::Signals(heard) => heard.iter().map(|signal| signal.write(&())).collect(),
        }
    }
}
