//! Orders of convergence, shown.

mod grids;
mod transient_steps;
