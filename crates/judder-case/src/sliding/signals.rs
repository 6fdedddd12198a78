//! What a march keeps of its motion: which signals, how they are sampled, which of them are left as sound.

use super::SlidingCase;
use super::march::March;
use super::motion::Axis;
use super::observe::{CONTACT_SIGNALS, PointQuantity, Signal, find_signal};
use super::problem::SlidingProblem;
use crate::cause::Cause;
use crate::document::Data;
use crate::error::Fault;
use crate::section::{Section, list, text, wrong_type};
use crate::sliding_keys::SlidingKey;
use crate::structure::lists::number;
use std::f64::consts::TAU;

/// How signals are sampled on line: low-passed, then decimated.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sampling {
    /// Up to which frequency they are kept as they are, rad/s.
    pub pass_band: f64,
    /// Samples a second, at least; more than twice the pass band in Hz.
    pub sample_rate: f64,
}

/// Which signals are left as sound.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Sound {
    /// None.
    Nothing,
    /// All accelerations that are kept, and the signal whose bursts are told.
    Accelerations,
    /// These.
    Signals(Vec<Signal>),
}

impl March {
    /// The signals that are kept: the quantities of so many observed points, those of the contact, what is told, what is heard.
    pub fn kept(&self, points: usize) -> Vec<Signal> {
        let of_point = |point: usize| {
            let all = self.quantities.iter();
            all.flat_map(move |&quantity| Axis::ALL.map(|(_, axis)| Signal::Point { point, axis, quantity }))
        };
        let mut kept: Vec<Signal> = (0..points).flat_map(of_point).collect();
        kept.extend(CONTACT_SIGNALS.map(|(_, signal)| signal));
        let heard = match &self.sound {
            Sound::Signals(signals) => &signals[..],
            Sound::Nothing | Sound::Accelerations => &[],
        };
        for signal in std::iter::once(&self.signal).chain(heard) {
            if !kept.contains(signal) {
                kept.push(*signal);
            }
        }
        kept
    }

    /// The signals that are left as sound, of so many observed points.
    pub fn heard(&self, points: usize) -> Vec<Signal> {
        let is_acceleration =
            |signal: &Signal| matches!(signal, Signal::Point { quantity: PointQuantity::Acceleration, .. });
        match &self.sound {
            Sound::Nothing => Vec::new(),
            Sound::Signals(signals) => signals.clone(),
            Sound::Accelerations => {
                let mut kept = self.kept(points);
                kept.retain(|signal| *signal == self.signal || is_acceleration(signal));
                kept
            }
        }
    }
}

/// A rate of exactly twice the pass band is none above it, however the factor 2π rounds.
const ROUNDING: f64 = 1e-9;
/// The keys of the table.
const KEYS: [&str; 3] = ["pass_band", "sample_rate", "quantities"];

/// Reads `signals`: sampling, and what of the observed points is kept, accelerations where the case does not say.
pub(super) fn read_signals(
    section: &Section<'_>,
    step: Option<f64>,
) -> Result<(Sampling, Vec<PointQuantity>), Fault> {
    let table = section.get("signals").map(|node| section.table("signals", node, &KEYS)).transpose()?;
    let quantities = match &table {
        Some(table) => read_quantities(table)?,
        None => vec![PointQuantity::Acceleration],
    };
    Ok((read_sampling((section, table.as_ref()), step)?, quantities))
}

fn read_sampling(
    (section, table): (&Section<'_>, Option<&Section<'_>>),
    step: Option<f64>,
) -> Result<Sampling, Fault> {
    let value = |key: SlidingKey| match table {
        Some(table) => number(table, key.entry()),
        None => Ok(key.entry().default.map_or(0.0, |(_, value)| value.number)),
    };
    let pass_band = value(SlidingKey::PassBand)?;
    let sample_rate = value(SlidingKey::SampleRate)? / TAU;
    let place = table.map_or(section.place, |table| table.place);
    let refuse = |reason: String| Err(SlidingProblem::SampleRate { sample_rate, reason }.at(place));
    if sample_rate <= 2.0 * pass_band / TAU * (1.0 + ROUNDING) {
        return refuse(format!("cannot carry frequencies up to {:.0} Hz", pass_band / TAU));
    }
    match step {
        Some(step) if sample_rate * step > 1.0 => refuse(format!("are more than one a step of {step:e} s")),
        _ => Ok(Sampling { pass_band, sample_rate }),
    }
}

/// The quantities in the order in which they are stored, whatever order the case has them in.
fn read_quantities(table: &Section<'_>) -> Result<Vec<PointQuantity>, Fault> {
    let Some(node) = table.get("quantities") else { return Ok(vec![PointQuantity::Acceleration]) };
    let key = table.path("quantities");
    let mut wanted = Vec::new();
    for item in list(&key, node)? {
        let name = text(&key, item)?;
        let Some((_, quantity)) = PointQuantity::ALL.iter().find(|(known, _)| *known == name) else {
            let known = PointQuantity::ALL.map(|(known, _)| known.to_owned()).to_vec();
            return Err(Cause::UnknownName { what: "quantity", name: name.to_owned(), known }.at(item.place));
        };
        wanted.push(*quantity);
    }
    let all = PointQuantity::ALL.map(|(_, quantity)| quantity);
    Ok(all.into_iter().filter(|quantity| wanted.contains(quantity)).collect())
}

/// Reads `sound`: a switch, or the signals that are to be heard.
pub(super) fn read_sound(case: &SlidingCase, section: &Section<'_>) -> Result<Sound, Fault> {
    let Some(node) = section.get("sound") else { return Ok(Sound::Accelerations) };
    match &node.data {
        Data::Boolean(true) => Ok(Sound::Accelerations),
        Data::Boolean(false) => Ok(Sound::Nothing),
        Data::List(items) => {
            let mut heard = Vec::new();
            for item in items {
                let signal = find_signal("sound", item, &case.points)?;
                if !heard.contains(&signal) {
                    heard.push(signal);
                }
            }
            Ok(Sound::Signals(heard))
        }
        _ => Err(wrong_type("sound", "true, false or a list of signals", node)),
    }
}
