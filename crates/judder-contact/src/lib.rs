//! Contact: what an indenter that slides on a substrate feels, computed and as a law.
//!
//! In the order in which the data flows:
//!
//! - [`material`]: viscoelastic materials: creep and relaxation spectra, measured moduli, temperature.
//! - [`indenter`]: what presses on the substrate: shapes, height maps, rough surfaces.
//! - [`surface`]: the square cells of the contact computation and what its solvers ask of a surface.
//! - [`kernel`]: how the surface of the substrate yields under a pressure that slides along.
//! - [`unilateral`]: contact without tension and without penetration.
//! - [`steady`]: steady sliding: grids chosen, refined, and their errors shown.
//! - [`transient`]: an indenter on any path, the contact as a function of time.
//! - [`periodic_contact`]: a rough surface that repeats itself, pressed on the substrate or sliding over it.
//! - [`response`]: where a law is evaluated, and what it gives: F̃_k, Ã, μ_visc with their first derivatives.
//! - [`contact_law`]: what every law answers.
//! - [`friction`]: a friction coefficient against the speed, for contacts that know no more of theirs.
//! - [`table`]: values against a quantity, straight or bent between the places of a table.
//! - [`fitted`]: the three fitted functions of the oscillator paper (eqs. 34–39), as printed and with the corrected velocity axis.
//! - [`fit`]: these functions fitted to computed contacts, with confidence intervals (appendix B).
//! - [`hertz`]: the elastic contact in closed form, the test bench of everything else.
//! - [`cylinder_on_layer`]: the elastic contact of a cylinder with a layer, spectrally exact: that of line contacts.
//! - [`law`]: the laws by name, with their ranges of validity; the computed ones: tables, sweeps, files.
//!
//! Everything is dimensionless: v̂ = v τ/R and ŷ = y/R go in; F̃_k = F_k/(E0* R²), Ã = A/R² and μ_visc come out.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

pub mod contact_law;
pub mod cylinder_on_layer;
pub mod fit;
pub mod fitted;
pub mod friction;
pub mod hertz;
pub mod indenter;
pub mod kernel;
pub mod law;
pub mod material;
pub mod periodic_contact;
pub mod response;
pub mod steady;
pub mod surface;
pub mod table;
pub mod transient;
pub mod unilateral;

pub use contact_law::{ContactLaw, ValidityConcern};
pub use fitted::FittedLaw;
pub use friction::{FallingFriction, Friction};
pub use hertz::HertzLaw;
pub use law::{CollapsedLaw, Law, LawError, SampledLaw, TabulatedLaw};
pub use response::{ContactResponse, LawPoint, WithDerivatives};

/// The examples of the book's chapters on contact, which are tests like any other.
#[cfg(doctest)]
mod book {
    macro_rules! chapter {
        ($name:ident, $path:literal) => {
            #[doc = include_str!(concat!("../../../docs/src/", $path, ".md"))]
            struct $name;
        };
    }
    chapter!(Materials, "theory/materials");
    chapter!(Indenters, "theory/indenters");
    chapter!(SlidingKernel, "theory/sliding-kernel");
    chapter!(SlidingContact, "theory/sliding-contact");
    chapter!(TransientContact, "theory/transient-contact");
    chapter!(ComputedLaws, "theory/computed-laws");
    chapter!(LineContact, "theory/line-contact");
    chapter!(Figure3, "figures/figure-3");
    chapter!(Figure13, "figures/figure-13");
    chapter!(Figure14, "figures/figure-14");
}
