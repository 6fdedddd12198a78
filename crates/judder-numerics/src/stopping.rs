//! Long computations that may be stopped.

/// Asks, between the steps of a long computation, whether it shall stop.
pub type Interrupted<'a> = &'a (dyn Fn() -> bool + Sync);
