//! The papers that judder knows.

use crate::{Reproduction, beams_paper, oscillator_paper};
use judder_study::{Progress, StudyError};
use std::path::{Path, PathBuf};

/// A paper that can be recomputed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Paper {
    /// A sphere on rubber with two degrees of freedom.
    Oscillator,
    /// Two beams in sliding contact.
    Beams,
}

impl Paper {
    /// All of them.
    pub const ALL: [Self; 2] = [Self::Oscillator, Self::Beams];

    /// What it is called.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Oscillator => "oscillator-paper",
            Self::Beams => "beams-paper",
        }
    }

    /// Its title and year.
    #[must_use]
    pub fn title(self) -> &'static str {
        match self {
            Self::Oscillator => {
                "Critical thresholds for mode-coupling instability in viscoelastic sliding contacts (2021)"
            }
            Self::Beams => "Dynamic substructuring with time variant coupling conditions (2020)",
        }
    }

    /// Where it goes if nobody says otherwise.
    #[must_use]
    pub fn usual_folder(self) -> PathBuf {
        Path::new("out/reproduce").join(self.name())
    }

    /// Recomputes its figures and its scoreboard into a folder; `quick` takes seconds in place of minutes.
    ///
    /// # Errors
    /// A folder that cannot be written, or [`StudyError::Interrupted`]; what was done until then is kept.
    pub fn reproduce(
        self,
        folder: &Path,
        quick: bool,
        progress: &dyn Progress,
    ) -> Result<Reproduction, StudyError> {
        match self {
            Self::Oscillator => oscillator_paper(folder, quick, progress),
            Self::Beams => beams_paper(folder, quick, progress),
        }
    }
}
