//! Closed forms.

mod piecewise;
mod signal;
