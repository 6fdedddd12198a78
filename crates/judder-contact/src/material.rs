//! Linear viscoelastic materials: how a substrate yields to a load over time or frequency.
//!
//! Two forms of one material, with two kinds of time: the creep form has **retardation** times τ_k, the relaxation form
//! **relaxation** times ρ_j, and a name here always says which.
//!
//! - [`creep`]: the creep spectrum 1/E∞, (τ_k, C_k), the form in which the oscillator paper's (30) and the contact computation think.
//! - [`relaxation`]: the generalised Maxwell form E0, (ρ_j, E_j), the form in which measurements are fitted.
//! - [`conversion`]: one form into the other, without loss.
//! - [`continuous`]: a continuous creep spectrum, and few terms that stand for it.
//! - [`checks`]: what must hold for every material, computed.
//! - [`shift`]: time and temperature.
//! - [`dma`]: measured moduli and their master curve.
//! - [`nonnegative`]: least squares with coefficients that must not be negative.
//! - [`prony_fit`]: a series fitted to measured moduli.
//! - [`error`]: what a material refuses.

pub mod checks;
pub mod continuous;
pub mod conversion;
pub mod creep;
pub mod dma;
pub mod error;
pub mod nonnegative;
pub mod prony_fit;
pub mod relaxation;
pub mod shift;

pub use checks::MaterialChecks;
pub use continuous::{ContinuousSpectrum, Discretisation};
pub use creep::{CreepSpectrum, CreepTerm};
pub use dma::{DmaData, DmaMeasurement, DmaPoint, DmaSweeps};
pub use error::{DmaError, MaterialError};
pub use prony_fit::{PronyFit, PronyResidual, TermCount};
pub use relaxation::{RelaxationSpectrum, RelaxationTerm};
pub use shift::TemperatureShift;
