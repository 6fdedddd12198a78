//! Contact laws: what an indenter that slides on a substrate feels.
//!
//! - [`response`]: where a law is evaluated, and what it gives: F̃_k, Ã, μ_visc with their first derivatives.
//! - [`fitted`]: the three fitted functions of the oscillator paper (eqs. 34–39), as printed and with the corrected velocity axis.
//! - [`hertz`]: the elastic contact in closed form, the test bench of everything else.
//! - [`law`]: the laws by name, with their ranges of validity.
//!
//! Everything is dimensionless: v̂ = v τ/R and ŷ = y/R go in; F̃_k = F_k/(E0* R²), Ã = A/R² and μ_visc come out.

pub mod fitted;
pub mod hertz;
pub mod law;
pub mod response;

pub use fitted::FittedLaw;
pub use hertz::HertzLaw;
pub use law::{ContactLaw, Law, ValidityConcern};
pub use response::{ContactPoint, ContactResponse, WithDerivatives};
