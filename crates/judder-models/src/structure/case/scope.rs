//! What the analyses of a structure case need to know of it.

use super::{Matrices, StructureSource};
use crate::swept_keys::ParameterKeys;
use judder_keys::error::Fault;
use judder_keys::section::Section;

/// What the analyses of a structure case need to know of it.
pub(crate) struct StructureScope {
    pub(crate) keys: ParameterKeys,
    /// Where it comes from; none where the case is wrong about that.
    pub(crate) source: Option<StructureSource>,
    /// The values of the parameters.
    pub(crate) values: Vec<f64>,
    pub(crate) has_reduction: bool,
}

impl StructureScope {
    /// The matrices, where it is given by them.
    pub(crate) fn matrices(&self) -> Option<&Matrices> {
        match &self.source {
            Some(StructureSource::Matrices(matrices)) => Some(matrices),
            Some(StructureSource::Body(_)) | None => None,
        }
    }

    /// Refuses an analysis at the case's own parameters where a factor or an entry has no value.
    pub(crate) fn check_factors(&self, section: &Section<'_>) -> Result<(), Fault> {
        let checked = self.matrices().map(|matrices| matrices.check(&self.values));
        checked.unwrap_or(Ok(())).map_err(|cause| cause.at(section.place))
    }
}
