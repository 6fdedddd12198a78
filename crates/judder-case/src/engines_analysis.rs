//! `engines`: one cycle of an oscillator by three engines.

use crate::dimension::Dimension;
use crate::error::Fault;
use crate::keys::{Key, Range, number};
use crate::motion_analysis::{
    Following, MotionKind, MotionStart, SETTLING_DURATION, read_following, read_start,
};
use crate::section::Section;
use crate::span::{Span, read_span};
use crate::swept_keys::OscillatorKeys;

/// What is compared.
#[derive(Debug, Clone, PartialEq)]
pub struct EnginesSettings {
    /// Where the motion that settles to the cycle starts.
    pub start: MotionStart,
    /// How it is followed: at most for its duration.
    pub following: Following,
    /// Steps of the time-stepping, as ω_nx t or in s.
    pub time_step: Span,
    /// Widths ε of the smoothed sign, over v_d.
    pub width: Span,
}

/// A number of the kind `engines`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct EnginesKey;

/// The default steps, ω_nx t.
pub(crate) const TIME_STEPS: (f64, f64, usize) = (3e-4, 1e-1, 11);
/// The default widths, over v_d.
pub(crate) const WIDTHS: (f64, f64, usize) = (1e-4, 1.0, 13);
/// The points that a range of steps or widths may have.
pub(crate) const LADDER_POINTS: usize = 200;

/// The step of the time-stepping.
pub(crate) static TIME_STEP: Key<EnginesKey> = Key {
    dimension: Dimension::TIME,
    group: Some("ω_nx t"),
    default: None,
    ..number(EnginesKey, "time_step", "h", Range::Positive, ("", 0.0), "step of the time-stepping")
};

/// The width of the smoothed sign.
pub(crate) static WIDTH: Key<EnginesKey> = Key {
    default: None,
    ..number(EnginesKey, "width", "ε/v_d", Range::Positive, ("", 0.0), "width of the smoothed sign")
};

pub(crate) const ENGINES: MotionKind = MotionKind {
    name: "engines",
    keys: &["start", "time_step", "width", "duration", "tolerance", "steps"],
    doc: "the cycle that a motion settles to, by events, by time-stepping and with a smoothed sign",
    tolerance: 1e-10,
    duration: SETTLING_DURATION,
};

pub(crate) fn read(section: &Section<'_>) -> Result<EnginesSettings, Fault> {
    let range =
        |key: &Key<EnginesKey>, default: (f64, f64, usize)| read_span(section, key, default, LADDER_POINTS);
    Ok(EnginesSettings {
        start: read_start::<OscillatorKeys>(section)?,
        following: read_following::<OscillatorKeys>(section, &ENGINES)?,
        time_step: range(&TIME_STEP, TIME_STEPS)?,
        width: range(&WIDTH, WIDTHS)?,
    })
}
