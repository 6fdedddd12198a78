//! Closed forms.

mod piecewise;
