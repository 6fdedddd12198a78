//! A sampled law as one JSON file: its knots and values, with all their digits.

use super::{LawSamples, SampledLaw};
use crate::law::error::LawError;
use crate::law::quantities::KnotValues;
use serde::{Deserialize, Serialize};

/// The value of `format` in the file of a sampled law.
pub const FORMAT: &str = "judder-sampled-law";
/// The version that is written and read.
pub const VERSION: u32 = 1;

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct SampledDocument {
    format: String,
    version: u32,
    source: String,
    /// v̂ = v τ/R.
    velocities: Vec<f64>,
    /// ŷ = y/R.
    indentations: Vec<f64>,
    /// F̃_k = F_k/(E0* R²), Ã = A/R², μ_visc, speed fastest.
    values: KnotValues,
}

/// The file's text.
pub(crate) fn to_json(law: &SampledLaw) -> Result<String, LawError> {
    let LawSamples { source, velocities, indentations, values } = law.samples().clone();
    let document = SampledDocument {
        format: FORMAT.to_owned(),
        version: VERSION,
        source,
        velocities,
        indentations,
        values,
    };
    Ok(serde_json::to_string_pretty(&document)?)
}

/// The law in a file's text whose format and version are known.
pub(crate) fn from_json(text: &str) -> Result<SampledLaw, LawError> {
    let SampledDocument { source, velocities, indentations, values, .. } = serde_json::from_str(text)?;
    SampledLaw::new(LawSamples { source, velocities, indentations, values })
}
