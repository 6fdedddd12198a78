//! Why a transient contact has no answer.

use crate::kernel::check::{KernelError, gibibytes};
use crate::unilateral::UnilateralError;
use thiserror::Error;

/// Why a transient contact has no answer.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum TransientError {
    /// A number that must be positive is not.
    #[error("the {what} is {value}; it must be a positive number")]
    NotPositive {
        /// What it is.
        what: &'static str,
        /// The number given.
        value: f64,
    },
    /// A number of the path is NaN or infinite.
    #[error("the {what} of the path is {value}; it must be a finite number")]
    NotFinite {
        /// What it is.
        what: &'static str,
        /// The number given.
        value: f64,
    },
    /// Sampled times and values do not make a function of time.
    #[error("sample {index} of the path, at time {time}: times must start at or before 0 and increase")]
    SampleTimes {
        /// Which sample, from 0.
        index: usize,
        /// Its time.
        time: f64,
    },
    /// There are not as many values as times, or fewer than two.
    #[error("the path has {times} times and {values} values: as many of both are needed, at least 2")]
    SampleCount {
        /// Number of times.
        times: usize,
        /// Number of values.
        values: usize,
    },
    /// The indenter never touches the substrate.
    #[error(
        "the largest {what} of the path is {value}, and so the indenter never presses on the substrate; give a positive one"
    )]
    NeverTouches {
        /// `indentation` or `load`.
        what: &'static str,
        /// The largest value on the path.
        value: f64,
    },
    /// Fields are asked for at a time outside of the run.
    #[error("fields are asked for at time {time}, outside of the run from 0 to {duration}")]
    FieldTime {
        /// The time asked for.
        time: f64,
        /// Duration of the run.
        duration: f64,
    },
    /// Too few cells to hold a contact.
    #[error("{cells} cells a side are too few; at least {least} are needed")]
    TooFewCells {
        /// Cells a side asked for.
        cells: usize,
        /// The fewest allowed.
        least: usize,
    },
    /// The strip of material that must be remembered does not fit into memory.
    #[error(
        "the path must remember a strip of {columns} × {rows} cells, which takes {:.2} GiB of memory, and {:.2} GiB are allowed; \
         shorten the path, slide slower, take fewer cells, or allow more memory", gibibytes(*needed), gibibytes(*allowed)
    )]
    Memory {
        /// Cells along x.
        columns: usize,
        /// Cells along y.
        rows: usize,
        /// Bytes needed.
        needed: u64,
        /// Bytes allowed.
        allowed: u64,
    },
    /// The path cannot be followed in the steps that are allowed.
    #[error(
        "the path takes at least {needed:.0} steps, and {allowed} are allowed; shorten it, slide slower, or take fewer cells"
    )]
    TooManySteps {
        /// Steps that the motion and the frequencies of the path need.
        needed: f64,
        /// Steps allowed.
        allowed: usize,
    },
    /// The contact reaches the edge of the window that moves with the indenter.
    #[error(
        "at time {time} the contact touches the edge of its window (half width {half_width:.4} R): a half width of \
         {needed:.4} R would do"
    )]
    WindowTooSmall {
        /// Time at which it happened.
        time: f64,
        /// Half the side of the window, in R.
        half_width: f64,
        /// Half the side that would hold the contact, in R.
        needed: f64,
    },
    /// There is no kernel for the window or the strip.
    #[error(transparent)]
    Kernel(#[from] KernelError),
    /// The contact problem of a step is ill posed or overflows.
    #[error(transparent)]
    Unilateral(#[from] UnilateralError),
}
