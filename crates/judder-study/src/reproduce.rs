//! The oscillator paper.
use crate::error::StudyError;
use judder_store::{StudyFolder, Summary};
use std::path::PathBuf;
/// k
pub(crate) const KEY: &str = "reproduction";
pub(crate) fn write_report(_: &StudyFolder, _: &Summary) -> Result<PathBuf, StudyError> {
    Err(StudyError::Interrupted)
}
