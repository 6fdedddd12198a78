//! `growth`: the motion with the contact held, against the eigenvalue there.

use crate::sliding::march::settings::{CUT_OFF, MarchWord, refuse_with};
use judder_keys::Settings;
use judder_keys::declared::Number;
use judder_keys::dimension::Dimension;
use judder_keys::error::Fault;
use judder_keys::section::Section;
use judder_sliding::march::ContactMethod;

/// A march with the contact held, against the eigenvalue there.
#[derive(Debug, Clone, PartialEq, Settings)]
#[settings(check = GrowthAnalysis::complete)]
pub struct GrowthAnalysis {
    /// How the coupled structures are integrated; `subs` means the undeformed configuration, the others the deformed one.
    #[key(name = "method")]
    pub word: MarchWord,
    /// Where the contact is held.
    #[key(rule = Number::non_negative(Dimension::LENGTH), symbol = "s")]
    pub position: f64,
    /// Frequency near which the mode lies that is meant.
    #[key(rule = Number::positive(Dimension::ANGULAR_FREQUENCY), symbol = "ω")]
    pub frequency: f64,
    /// Time step; where left out, 3e-7 s or 0.9 of the limit of stability, of `residual-flexibility` 3e-6 s or 0.75 of it, whichever is smaller.
    #[key(rule = Number::positive(Dimension::TIME), symbol = "h")]
    pub step: Option<f64>,
    /// Of `residual-flexibility`: modes above are replaced by their flexibility.
    #[key(rule = Number::positive(Dimension::ANGULAR_FREQUENCY), symbol = "ω_c", usual = CUT_OFF, omitted)]
    pub cut_off: Option<f64>,
}

impl GrowthAnalysis {
    /// Refuses a cut-off that means nothing to the method, and fills in the one that is left out.
    fn complete(&mut self, section: &Section<'_>) -> Result<(), Fault> {
        if self.word == MarchWord::ResidualFlexibility {
            self.cut_off.get_or_insert(CUT_OFF);
            return Ok(());
        }
        refuse_with(section, "cut_off", self.word)
    }

    /// How it integrates.
    pub fn method(&self) -> ContactMethod {
        self.word.method(self.cut_off)
    }
}
