use crate::words::plain;
use thiserror::Error;

/// Why a motion cannot go on.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum MarchError {
    /// The budget of steps is spent.
    #[error(
        "the motion has used its {steps} steps at time {time}, in steps of {step}: give it more, or a shorter time",
        step = plain(*.step), time = plain(*.time),
    )]
    StepsSpent {
        /// The budget.
        steps: usize,
        /// Where the motion stands.
        time: f64,
        /// The last step's length.
        step: f64,
    },
    /// No step is short enough for the tolerance.
    #[error(
        "no step from time {time} is short enough for the tolerance, down to {step}: the field is not smooth or not finite there",
        step = plain(*.step), time = plain(*.time),
    )]
    StepTooShort {
        /// Where the motion stands.
        time: f64,
        /// The last step that was tried.
        step: f64,
    },
    /// Changes of mode pile up.
    #[error("changes of mode accumulate: {changes} of them within {interval} before time {time}", interval = plain(*.interval), time = plain(*.time))]
    Accumulation {
        /// How many.
        changes: usize,
        /// Within which time.
        interval: f64,
        /// Where the motion stands.
        time: f64,
    },
    /// The caller wants it to stop.
    #[error("the motion was interrupted at time {time}", time = plain(*.time))]
    Interrupted {
        /// Where the motion stands.
        time: f64,
    },
    /// The state that it starts from is not finite.
    #[error("component {component} of the state is not finite: {value}")]
    NotFinite {
        /// Index from 0.
        component: usize,
        /// Its value.
        value: f64,
    },
}
