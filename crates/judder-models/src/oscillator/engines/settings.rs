//! `engines`: one cycle of an oscillator by three engines.

use crate::motion::settings::{
    CYCLE_TOLERANCE, DURATION, MOTION_STEPS, MotionStart, SETTLING_DURATION, STEPS, TOLERANCE, followed,
};
use judder_keys::Settings;
use judder_keys::declared::{Ladder, Scaled};
use judder_keys::dimension::Dimension;
use judder_keys::numeric_key::{Form, Value};
use judder_keys::span::Span;

/// What is compared.
#[derive(Debug, Clone, PartialEq, Settings)]
pub struct EnginesSettings {
    /// Where the motion that settles to the cycle starts.
    #[key(default = MotionStart::USUAL)]
    pub start: MotionStart,
    /// Steps of the time-stepping, with equal ratios between them.
    #[key(rule = TIME_STEP, symbol = "h", default = Span { from: 3e-4, to: 1e-1, points: 11, form: Form::Group })]
    pub time_step: Span,
    /// Widths of the smoothed sign tanh(v_rel/ε), over v_d.
    #[key(rule = WIDTH, symbol = "ε/v_d", default = Span { from: 1e-4, to: 1.0, points: 13, form: Form::Group })]
    pub width: Span,
    /// Time within which the motion settles.
    #[key(rule = DURATION, symbol = "t", default = SETTLING_DURATION)]
    pub duration: Value,
    /// Local error of a step, relative to the magnitudes of steady sliding.
    #[key(rule = TOLERANCE, symbol = "ε", default = CYCLE_TOLERANCE)]
    pub tolerance: f64,
    /// The most steps of one motion.
    #[key(rule = STEPS, default = MOTION_STEPS)]
    pub steps: usize,
}

followed!(EnginesSettings);

/// The points that a range of steps or widths may have.
const LADDER_POINTS: usize = 200;
const TIME_STEP: Ladder = Ladder { of: DURATION, usual: 11, most: LADDER_POINTS };
const WIDTH: Ladder =
    Ladder { of: Scaled::positive(Dimension::NUMBER, "ε/v_d"), usual: 13, most: LADDER_POINTS };
