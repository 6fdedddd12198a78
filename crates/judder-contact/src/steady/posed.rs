//! The problem of one grid.

use crate::kernel::sliding::SlidingOperator;
use crate::unilateral::Loading;

/// The problem of one grid as a solver takes it.
pub(super) struct Posed {
    pub(super) operator: SlidingOperator,
    pub(super) loading: Loading,
    /// The depth to start from, as the operator measures depths.
    pub(super) indentation: f64,
    /// What the operator's depths are more than those that are told.
    pub(super) datum: f64,
}
