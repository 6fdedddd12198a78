//! Springs with dampers beside them, between bodies or to the ground.

use crate::AssemblyError;
use crate::assembly::{Assembly, from_triplets, triplets};
use crate::compliance::outer;
use crate::row::Row;
use judder_structure::assembly::Sparse;
use std::sync::Arc;

/// A spring with a damper beside it: the force k s + c ṡ of its elongation s = r q + s₀ pulls its ends together.
///
/// It adds k rᵀr to the stiffness, c rᵀr to the damping and −k s₀ rᵀ to the load.
#[derive(Debug, Clone, PartialEq)]
pub struct Spring {
    /// r, on the freedoms of the assembly.
    pub elongation: Row,
    /// s₀ in m, by what displaces its ends whatever happens.
    pub imposed: f64,
    /// k in N/m.
    pub stiffness: f64,
    /// c in N s/m.
    pub damping: f64,
}

impl Assembly {
    /// The assembly with springs.
    ///
    /// # Errors
    /// [`AssemblyError::UnknownFreedom`], [`AssemblyError::Structure`] where it does not fit into memory.
    pub fn with_springs(mut self, springs: &[Spring]) -> Result<Self, AssemblyError> {
        if springs.is_empty() {
            return Ok(self);
        }
        let freedoms = self.size();
        let named = springs.iter().flat_map(|spring| spring.elongation.entries());
        if let Some((freedom, _)) = named.into_iter().find(|(freedom, _)| *freedom >= freedoms) {
            let interface = "a spring".to_owned();
            return Err(AssemblyError::UnknownFreedom { interface, freedom: *freedom, freedoms });
        }
        let added = |matrix: &Sparse, factor: fn(&Spring) -> f64| {
            let of_springs = springs.iter().filter(|spring| factor(spring) != 0.0);
            let own = of_springs.flat_map(|own| outer(factor(own), &own.elongation, &own.elongation));
            let entries: Vec<_> = triplets(matrix).chain(own).collect();
            from_triplets(freedoms, freedoms, &entries).map(Arc::new)
        };
        self.stiffness = added(&self.stiffness, |spring| spring.stiffness)?;
        self.damping = added(&self.damping, |spring| spring.damping)?;
        for spring in springs {
            spring.elongation.add_to(-spring.stiffness * spring.imposed, &mut self.load);
        }
        Ok(self)
    }
}
