//! Closed forms.

mod piecewise;
mod sampling;
mod sensitivity;
mod signal;
