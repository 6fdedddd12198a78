//! The two-degree-of-freedom oscillator in sliding contact with a substrate: is steady sliding stable, and why not.
//!
//! In the order in which the data flows:
//!
//! - [`groups`]: the dimensionless groups (9)–(11), (14), to and from quantities with units; the coefficients they stand for.
//! - [`friction`]: the friction force (5), with either reading of the load that carries it.
//! - [`sphere`]: the sphere in SI units, whatever carries it.
//! - [`equilibrium`]: steady sliding (15).
//! - [`linearisation`]: damping and stiffness about it (16)–(20), equivalent damping (23).
//! - [`linear_system`]: any M q̈ + C q̇ + K q = 0 of two degrees of freedom.
//! - [`characteristic`]: the characteristic polynomial (21) and Hurwitz determinants, which decide stability.
//! - [`conservative`]: the eigenvalues without damping (24), (25), their coalescence (26), the threshold of the shear strength in closed form (27).
//! - [`spectrum`]: eigenvalues and eigenvectors.
//! - [`mechanism`]: stable or not ([`Verdict`]), and why; and [`growth`]: which force feeds the growth.
//! - [`within_law`]: what the errors of the contact law leave of all that, and [`undecided`]: what of thresholds.
//! - [`block`]: the stability decision for many points at once, in vector arithmetic.
//! - [`critical`]: thresholds, all of them, over a range (Figs. 7, 8).
//! - [`map`]: stability maps, at every point or only where something changes (Figs. 9, 10).
//! - [`boundary`]: the curve that bounds a map, followed by continuation.
//! - [`motion`]: the equations of motion (12), (13) with stick, slip and lift-off, and where a motion settles.
//! - [`quasi_steady`]: the condition (3) of steady-sliding laws in motion.
//! - [`hopf`]: what grows from a threshold: the first Lyapunov coefficient.
//! - [`cycle`]: limit cycles, stable or not, and their branches along a parameter.
//!
//! Equation numbers are those of Papangelo, Putignano and Hoffmann, *Critical thresholds for mode-coupling instability in
//! viscoelastic sliding contacts*, Nonlinear Dynamics (2021), "the oscillator paper".

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

pub mod block;
pub mod boundary;
pub mod characteristic;
pub mod conservative;
pub mod critical;
pub mod cycle;
pub mod equilibrium;
mod error;
pub mod friction;
pub mod groups;
pub mod growth;
pub mod hopf;
pub mod linear_system;
pub mod linearisation;
pub mod map;
pub mod mechanism;
pub mod motion;
pub mod quasi_steady;
pub mod spectrum;
pub mod sphere;
pub mod undecided;
pub mod within_law;

pub use error::OscillatorError;
pub use friction::FrictionLoad;
pub use groups::{Coefficients, Dimensional, Groups};
pub use judder_numerics::verdict::Verdict;
pub use linear_system::LinearSystem;
pub use mechanism::Mechanism;

/// The contact: which law, and which load carries the viscoelastic friction.
#[derive(Debug, Clone, PartialEq)]
pub struct Contact {
    /// F̃_k, Ã, μ_visc over speed and depth.
    pub law: judder_contact::Law,
    /// F_n μ_visc (as printed) or F_k μ_visc.
    pub friction_load: FrictionLoad,
}

/// The examples of the book, which are tests like any other.
#[cfg(doctest)]
mod book {
    macro_rules! chapter {
        ($name:ident, $path:literal) => {
            #[doc = include_str!(concat!("../../../docs/src/", $path, ".md"))]
            struct $name;
        };
    }
    chapter!(FirstMap, "tutorials/first-map");
    chapter!(OwnRubber, "tutorials/own-rubber");
    chapter!(Oscillator, "theory/oscillator");
    chapter!(Motion, "theory/motion");
    chapter!(ContactLaws, "theory/contact-laws");
    chapter!(Checks, "theory/checks");
    chapter!(Figure4, "figures/figure-4");
    chapter!(Figure5, "figures/figure-5");
    chapter!(Figure6, "figures/figure-6");
    chapter!(Figure7, "figures/figure-7");
    chapter!(Figure8, "figures/figure-8");
    chapter!(Figure9, "figures/figure-9");
    chapter!(Figure10, "figures/figure-10");
    chapter!(Figure11, "figures/figure-11");
    chapter!(Figure12, "figures/figure-12");
}
