//! The resolved case as canonical JSON: every key with the value in use, keys sorted, the same bytes each time.

use crate::case::file::CaseFile;
use crate::case::study_sweep::StudySweep;
use crate::model::Case;
use serde_json::Value as Json;

impl Case {
    /// The case with every default filled in, for the hash of a study and for its report.
    ///
    /// A group is a number; a quantity is `{"value": …, "unit": …}` in SI units.
    pub fn resolved(&self) -> Json {
        let mut json = (**self).resolved();
        // another crate of the build may have switched serde_json to insertion order
        json.sort_all_objects();
        json
    }
}

impl CaseFile {
    /// [`Case::resolved`](crate::model::Case::resolved) with the sweeps of the case under `sweep`, where it has any.
    pub fn resolved(&self) -> Json {
        let mut json = self.case.resolved();
        if !self.sweeps.is_empty() {
            json["sweep"] = self.sweeps.iter().map(StudySweep::resolved).collect();
        }
        json.sort_all_objects();
        json
    }
}
