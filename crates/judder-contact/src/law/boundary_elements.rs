//! One point of a law from the contact of steady sliding.

use super::limits::LawIndenter;
use super::material::LawMaterial;
use super::quantities::PerQuantity;
use super::sweep::LawSample;
use crate::indenter::IndenterShape;
use crate::kernel::check::KernelError;
use crate::kernel::substrate::{SlidingSubstrate, WakeTerm};
use crate::steady::profile::{Paraboloid, Profile, Sphere};
use crate::steady::refinement::ErrorEstimate;
use crate::steady::{GridChoice, SteadyError, SteadyQuestion, solve};
use crate::unilateral::{Loading, UnilateralLimits};
use thiserror::Error;

/// The part of a law's accuracy that its single contacts may use up: less than what is left to the interpolation, because the slope
/// of the law divides their errors by the distance of the knots.
const SHARE_OF_CONTACTS: f64 = 0.2;

/// How the accuracy of a law is shared.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AccuracyShares {
    /// What is asked of a single contact, as in [`sample`].
    pub contacts: f64,
    /// What is asked of the interpolation between them.
    pub interpolation: PerQuantity<f64>,
}

/// The shares of a relative accuracy of the force; area and friction may be five times as far off.
#[must_use]
pub fn sweep_accuracy(accuracy: f64) -> AccuracyShares {
    let contacts = SHARE_OF_CONTACTS * accuracy;
    let interpolation = PerQuantity { force: accuracy - contacts, ..PerQuantity::uniform(accuracy) };
    AccuracyShares { contacts, interpolation }
}

/// Why a point of a law could not be computed.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum SampleError {
    /// The contact has no solution on any grid.
    #[error(transparent)]
    Steady(#[from] SteadyError),
    /// The finest grid does not give the accuracy.
    #[error(
        "not converged: force, area and friction are known to {force:.1e}, {area:.1e} and {friction:.1e} on {cells} cells \
         a side, with a residual of {residual:.1e}"
    )]
    NotConverged {
        /// Relative error of the force.
        force: f64,
        /// Relative error of the area.
        area: f64,
        /// Relative error of the friction.
        friction: f64,
        /// Cells a side of the finest grid.
        cells: usize,
        /// Largest residual of the unilateral conditions.
        residual: f64,
    },
}

/// Force, area and friction at one speed and depth, by the boundary-element solver on grids as fine as the accuracy asks.
///
/// `accuracy` is the relative error allowed to the force; area and friction may be five times as far off. `memory` is what the
/// finest grid may take, bytes.
///
/// # Errors
/// [`SampleError`].
pub fn sample(
    material: &LawMaterial,
    indenter: LawIndenter,
    velocity: f64,
    indentation: f64,
    accuracy: f64,
    memory: u64,
) -> Result<LawSample, SampleError> {
    let substrate = indenter.substrate(material, velocity).map_err(SteadyError::from)?;
    let contact = solve(&SteadyQuestion {
        substrate: &substrate,
        profile: indenter.profile(),
        loading: Loading::Indentation(indentation),
        accuracy,
        grid: GridChoice::Automatic,
        limits: UnilateralLimits::default(),
        memory,
    })?;
    let refinement = &contact.refinement;
    let [force, area, friction] = [refinement.force, refinement.area, refinement.friction];
    if !contact.converged {
        return Err(SampleError::NotConverged {
            force: force.error,
            area: area.error,
            friction: friction.error,
            cells: contact.finest.grid.columns,
            residual: contact.finest.solution.errors.worst(),
        });
    }
    let [(force, force_error), (area, area_error), (friction, friction_error)] =
        [force, area, friction].map(|ErrorEstimate { value, error, .. }| (value, error));
    Ok(LawSample { force, area, friction, force_error, area_error, friction_error })
}

impl LawMaterial {
    /// The material under an indenter that slides at v̂ = v τ/R; lengths in R.
    #[must_use]
    pub fn sliding(&self, velocity: f64) -> SlidingSubstrate {
        let terms = self
            .terms
            .iter()
            .map(|term| WakeTerm { compliance: term.compliance, length: velocity * term.retardation_time })
            .collect();
        SlidingSubstrate { instantaneous: 1.0 / self.modulus_ratio, terms, layer: None }
    }
}

impl LawIndenter {
    /// What it slides on at v̂ = v τ/R, lengths in R: a half-space of the material, or its layer.
    ///
    /// # Errors
    /// A layer that cannot be.
    pub fn substrate(self, material: &LawMaterial, velocity: f64) -> Result<SlidingSubstrate, KernelError> {
        let sliding = material.sliding(velocity);
        match self {
            Self::Paraboloid | Self::Sphere => Ok(sliding),
            Self::Cylinder(layer) => Ok(sliding.as_layer(layer.layer()?)),
        }
    }

    /// Its surface.
    #[must_use]
    pub fn profile(self) -> &'static dyn Profile {
        match self {
            Self::Paraboloid => &Paraboloid,
            Self::Sphere => &Sphere,
            Self::Cylinder(_) => &IndenterShape::Cylinder { radius: 1.0 },
        }
    }
}
