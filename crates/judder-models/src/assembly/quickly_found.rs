//! What is found out about steady sliding where that takes less than a second.

use super::AssemblySubject;
use super::build::BuiltAssembly;
use crate::error::ModelError;
use judder_assembly::AssemblyError;
use judder_assembly::compliance::Compliance;
use judder_assembly::steady::steady_sliding;

/// Freedoms and contact points up to which steady sliding takes less than a second.
const MOST_FREEDOMS: usize = 20_000;
const MOST_POINTS: usize = 200;

/// What is quickly found out about steady sliding.
pub(super) enum QuicklyFound {
    /// Nothing that has to be told, or it takes longer.
    Nothing,
    /// The loads bring no contact point together.
    Doubt(String),
    /// There is none: something can move that nothing holds.
    Refused(String),
}

impl QuicklyFound {
    pub(super) fn of(built: &BuiltAssembly) -> Self {
        let assembly = &built.assembly;
        let points: usize = assembly.interfaces.iter().map(|interface| interface.points.len()).sum();
        let has_laws = built.spheres.iter().all(Option::is_none);
        if points == 0 || points > MOST_POINTS || assembly.size() > MOST_FREEDOMS || !has_laws {
            return Self::Nothing;
        }
        match Compliance::new(assembly).and_then(|compliance| steady_sliding(assembly, &compliance)) {
            Err(error @ AssemblyError::NothingCloses { .. }) => {
                Self::Doubt(format!("contact is never made: {error}"))
            }
            Err(error @ (AssemblyError::RigidMotion { .. } | AssemblyError::PushedOn { .. })) => {
                Self::Refused(built.told(error).to_string())
            }
            _ => Self::Nothing,
        }
    }
}

impl AssemblySubject<'_> {
    /// Refuses, for `judder check`, what begins in steady sliding of the case as it is where there is none.
    pub(super) fn admit_steady(&self) -> Result<(), ModelError> {
        match self.built.quickly_found() {
            QuicklyFound::Refused(reason) => Err(ModelError::Unsupported(reason.clone())),
            QuicklyFound::Doubt(_) | QuicklyFound::Nothing => Ok(()),
        }
    }
}
