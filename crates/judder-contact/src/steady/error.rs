//! Why a steady-sliding problem has no answer.

use crate::kernel::check::KernelError;
use crate::unilateral::UnilateralError;
use judder_numerics::words::plain;
use thiserror::Error;

/// Why a steady-sliding problem has no answer.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum SteadyError {
    /// The accuracy is not a small positive fraction.
    #[error("the accuracy is {accuracy}; it must lie between 0 and 1")]
    Accuracy {
        /// The accuracy asked for.
        accuracy: f64,
    },
    /// A line contact under an imposed depth.
    #[error(
        "a line contact on a half-space takes a load per length: its indentation depends on how far away the body is held; give the \
         substrate's thickness, and it has one"
    )]
    LineIndentation,
    /// Too few cells to hold a contact.
    #[error("{cells} cells a side are too few; at least 8 are needed")]
    TooFewCells {
        /// Cells a side asked for.
        cells: usize,
    },
    /// The domain has no extent.
    #[error("half the side of the domain is {half_width} R; it must be a positive number")]
    HalfWidth {
        /// Half width asked for.
        half_width: f64,
    },
    /// There is no grid to solve on.
    #[error("there is no grid to solve on")]
    NoCells,
    /// The contact reaches the edge of the domain.
    #[error(
        "the contact touches the edge of the domain, a square of side {} R about x = {} R; a side of at least \
         {} R is needed", plain(2.0 * half_width), plain(*centre_x), plain(2.0 * needed)
    )]
    DomainTooSmall {
        /// Half the side of the domain, in R.
        half_width: f64,
        /// x of its centre, in R.
        centre_x: f64,
        /// Half the side that would hold the contact, in R.
        needed: f64,
    },
    /// The indenter ends before the contact does.
    #[error(
        "the contact reaches the edge of the indenter at x = {} R, y = {} R; press less, or give a larger height map",
        plain(*x), plain(*y)
    )]
    BeyondIndenter {
        /// x of a cell in contact beside the edge, in R.
        x: f64,
        /// y of the cell, in R.
        y: f64,
    },
    /// The indenter is not that deep.
    #[error(
        "the indentation is {indentation} R, and this indenter ends at {limit} R; give far less: a half-space stands for the \
         substrate only while contact and depth are small"
    )]
    TooDeep {
        /// y/R asked for.
        indentation: f64,
        /// The depth at which the indenter ends.
        limit: f64,
    },
    /// It was told to stop.
    #[error("interrupted")]
    Interrupted,
    /// There is no kernel for the grid or the substrate.
    #[error(transparent)]
    Kernel(#[from] KernelError),
    /// A grid's problem is ill posed or overflows.
    #[error(transparent)]
    Unilateral(#[from] UnilateralError),
}
