//! Of which modes a cycle is made up, as it is told and stored.

use crate::error::ModelError;
use judder_cycles::contributions::{ModeContribution, ModeContributions};
use judder_store::{Dataset, Results, Variable};

/// The arrays.
pub(super) const FREQUENCIES: &str = "mode_frequency";
pub(super) const SHARES: &str = "mode_contribution";
/// The attribute.
pub(super) const LEFT_OVER: &str = "contributions_left_over";

/// A mode of frictionless contact in a cycle.
#[derive(Clone, Results)]
pub(super) struct ToldContribution {
    /// its frequency, in Hz
    frequency_hz: f64,
    /// its share in the kinetic energy of the swing
    #[result(unit = "1")]
    share: f64,
}

impl From<&ModeContribution> for ToldContribution {
    fn from(own: &ModeContribution) -> Self {
        Self { frequency_hz: own.frequency_hz, share: own.share }
    }
}

/// Adds their arrays, where there are any, and what is left over.
pub(super) fn with_contributions(
    dataset: Dataset,
    ModeContributions { modes, left_over }: &ModeContributions,
) -> Result<Dataset, ModelError> {
    let dataset = dataset.attribute(LEFT_OVER, *left_over)?;
    if modes.is_empty() {
        return Ok(dataset);
    }
    let along = |name: &str, of: fn(&ModeContribution) -> f64| {
        let values: Vec<f64> = modes.iter().map(of).collect();
        Variable::new(name, &["mode"], &[values.len()], values)
    };
    let frequencies = along(FREQUENCIES, |own| own.frequency_hz)
        .units("Hz")
        .long_name("frequency of a mode of frictionless contact, of those with the largest shares")
        .attribute("label", "Frequency of the mode (Hz)");
    let shares = along(SHARES, |own| own.share)
        .units("1")
        .long_name("its share in the kinetic energy of the swing of the cycle")
        .attribute("label", "Share in the kinetic energy (1)");
    Ok(dataset.with(frequencies)?.with(shares)?)
}
