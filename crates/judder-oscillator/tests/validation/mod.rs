//! What others have printed: the oscillator paper's figures and text, and closed forms of the literature.
//!
//! "The text" is Papangelo, Putignano and Hoffmann, Nonlinear Dynamics (2021). Numbers of ours are pinned beside the printed ones.

pub(crate) mod belt;
mod equivalent_damping;
mod exploration;
mod least_period;
pub(crate) mod limit_cycles;
mod motion;
mod on_the_edge;
mod own_friction;
mod stability_maps;
mod thresholds;
mod two_degrees;

/// Whether two numbers agree to a relative difference.
fn near(value: f64, expected: f64, tolerance: f64) -> bool {
    (value / expected - 1.0).abs() <= tolerance
}
