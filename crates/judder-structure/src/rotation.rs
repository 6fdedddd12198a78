//! Bodies that turn about an axis with a speed that stays: what turning does to small motions, in the frame that turns with the body, or in the one that
//! stands still.
//!
//! With the displacement u from where turning alone would carry the material, and v = ω × (x − centre), the material's acceleration is
//!
//! - in the frame that turns, along whose axes u is taken: ü + 2 ω × u̇ + ω × (ω × u) − the centrifugal one;
//! - in the frame that stands still, for a body of revolution, whose shape stays where it is while the material passes: ü + 2 (v·∇) u̇ + (v·∇)² u −
//!   the centrifugal one. Integrated by parts once, since v is free of sources and leaves the surface alone, its last part is −∫ ρ (v·∇)δu · (v·∇)u.
//!
//! So M ü + G u̇ + (K + K_σ − S) u = f, with the centrifugal force f = ∫ ρ δu · (ω² − ω ω·)(x − centre) and the stiffness K_σ = ∫ σ : (∇δuᵀ ∇u) by the stress σ
//! that it causes (O. C. Zienkiewicz and R. L. Taylor, *The Finite Element Method*, vol. 2, on initial stress; G. Genta, *Dynamics of Rotating Systems*, 2005, on
//! both frames). A wave with n waves around the axis that has the frequency f in the frame that turns has f ± n ω/2π in the one that stands still.

mod axis;
mod revolution;

pub use axis::{RotatingFrame, Rotation};
pub use revolution::crossed_surface;

use crate::StructureError;
use crate::assembly::{OneElement, Sparse, assembled_of};
use crate::element::RotatingElement;
use crate::factor::SymmetricFactor;
use crate::freedom::{Direction, Numbering};
use crate::material::{Elastic, ElementSection};
use crate::mesh::Mesh;
use crate::rigid::{largest_ratio, rigid_limit};
use crate::statics::{product, sum};
use std::collections::BTreeMap;

/// What turning does to a body, on its free displacements.
#[derive(Debug, Clone)]
pub struct RotatingBody {
    /// G in N s/m, skew: it does no work.
    pub gyroscopic: Sparse,
    /// S in N/m: what the stiffness loses, in the frame that turns by the centrifugal force that grows outwards, in the one that stands still by all of
    /// the convective acceleration.
    pub softening: Sparse,
    /// K_σ in N/m: what the stress of the centrifugal force adds to the stiffness.
    pub stress_stiffness: Sparse,
    /// f in N: the centrifugal force.
    pub load: Vec<f64>,
    /// u in m: what it moves, which causes the stress.
    pub displacement: Vec<f64>,
}

impl RotatingBody {
    /// What turning does to a mesh with this stiffness and mass on its free displacements.
    ///
    /// # Errors
    /// [`StructureError::NoRotation`] for elements of the plane, [`StructureError::Unbalanced`] for a body that the centrifugal force moves as a whole, as of
    /// [`assemble`](crate::assembly::assemble), [`StructureError::OutOfMemory`].
    pub fn new(
        mesh: &Mesh,
        materials: &BTreeMap<String, (Elastic, ElementSection)>,
        numbering: &Numbering,
        [stiffness, mass]: [&Sparse; 2],
        (rotation, frame): (&Rotation, RotatingFrame),
    ) -> Result<Self, StructureError> {
        let turning = |one: &OneElement<'_>| one.elements.rotating(one.number, &one.places, rotation, frame);
        let matrices = |one: &OneElement<'_>| turning(one).map(|own| [own.gyroscopic, own.softening]);
        let [gyroscopic, softening] = assembled_of(mesh, materials, numbering, matrices)?;
        let load = load(mesh, materials, numbering, rotation)?;
        let displacement = displaced(stiffness, mass, &load)?;
        let by_stress = |one: &OneElement<'_>| {
            let directions = one.nodes.iter().flat_map(|node| Direction::ALL.map(|along| (*node, along)));
            let moved = directions
                .map(|(node, along)| numbering.number(node, along).map_or(0.0, |k| displacement[k]));
            let moved: Vec<f64> = moved.collect();
            Ok([one.elements.stress_stiffness(one.number, &one.places, &moved)?])
        };
        let [stress_stiffness] = assembled_of(mesh, materials, numbering, by_stress)?;
        Ok(Self { gyroscopic, softening, stress_stiffness, load, displacement })
    }
}

/// The centrifugal force on the free displacements.
fn load(
    mesh: &Mesh,
    materials: &BTreeMap<String, (Elastic, ElementSection)>,
    numbering: &Numbering,
    rotation: &Rotation,
) -> Result<Vec<f64>, StructureError> {
    let mut load = vec![0.0; numbering.freedoms().len()];
    crate::assembly::each_element(mesh, materials, |one| {
        let RotatingElement { load: own, .. } =
            one.elements.rotating(one.number, &one.places, rotation, RotatingFrame::Rotating)?;
        for (freedom, force) in numbering.of_element(one.nodes).zip(own) {
            if let Some(freedom) = freedom {
                load[freedom] += force;
            }
        }
        Ok(())
    })?;
    Ok(load)
}

/// How much of the force the stress must take up.
const BALANCE: f64 = 1e-7;

/// u with K u = f, where f moves no body as a whole; of motions that nothing holds as little as it takes.
fn displaced(stiffness: &Sparse, mass: &Sparse, load: &[f64]) -> Result<Vec<f64>, StructureError> {
    /// The shift that holds what nothing holds, over the eigenvalues that are zero but for rounding.
    const SHIFT: f64 = 1e4;
    const REFINEMENTS: usize = 30;
    let shift = SHIFT * rigid_limit(stiffness.nrows(), largest_ratio(stiffness, mass));
    let factor = SymmetricFactor::new(&sum(1.0, stiffness, shift, mass)?)?;
    let size = |vector: &[f64]| vector.iter().map(|x| x * x).sum::<f64>().sqrt();
    let all = size(load);
    let mut moved = vec![0.0; load.len()];
    let mut share = 1.0;
    for _ in 0..REFINEMENTS {
        let pushed = product(stiffness, &moved);
        let mut left: Vec<f64> = load.iter().zip(&pushed).map(|(f, k)| f - k).collect();
        let now = if all > 0.0 { size(&left) / all } else { 0.0 };
        // below this rounding is all that is left
        let is_done = now < 1e-3 * BALANCE || (now < BALANCE && now > 0.5 * share);
        share = now;
        if is_done {
            break;
        }
        factor.solve(&mut left);
        moved.iter_mut().zip(&left).for_each(|(u, more)| *u += more);
    }
    // so too where it is not a number
    if share < BALANCE { Ok(moved) } else { Err(StructureError::Unbalanced { share }) }
}
