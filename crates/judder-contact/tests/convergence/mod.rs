//! Orders of convergence, shown.

mod computed_law;
mod grids;
mod transient_steps;
