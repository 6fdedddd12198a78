//! A computed or given law as one JSON file.
//!
//! Numbers are written with all their digits: what is read is what was written, to the last bit.

use crate::law::Law;
use crate::law::collapsed::CollapsedLaw;
use crate::law::error::LawError;
use crate::law::knots::Knots;
use crate::law::limits::LawIndenter;
use crate::law::material::LawMaterial;
use crate::law::origin::LawOrigin;
use crate::law::quantities::{KnotValues, LawErrors};
use crate::law::sampled;
use crate::law::scaled::{INDENTATION_AXIS, SPEED_AXIS};
use crate::law::table::TabulatedLaw;
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;
use std::sync::Arc;

/// The value of `format` in a law file.
pub const FORMAT: &str = "judder-contact-law";
/// The version that is written and read.
pub const VERSION: u32 = 1;

/// How far a file's limits may be from those of its material: they are there for other readers, rounded or not.
const LIMIT_TOLERANCE: f64 = 1e-9;

/// The first thing that is read of a file, so that a wrong one is named before its fields are.
#[derive(Deserialize)]
struct FileHead {
    #[serde(default)]
    format: String,
    #[serde(default)]
    version: u32,
}

/// The file.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct LawDocument {
    format: String,
    version: u32,
    source: String,
    indenter: LawIndenter,
    material: LawMaterial,
    knots: KnotLists,
    /// f = F̃/ŷ^{3/2}, g = Ã/ŷ, m = μ/√ŷ, speed fastest; of a cylinder f = F̃/ŷ and g = Ã/√ŷ, of the length R.
    values: KnotValues,
    errors: LawErrors,
    /// Null for a cylinder, whose limits depend on the depth.
    #[serde(deserialize_with = "Option::deserialize")]
    limits: Option<Limits>,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct KnotLists {
    /// ln z, z = v̂/√ŷ.
    ln_speeds: Vec<f64>,
    /// ln ŷ; null for a law that is a function of z alone.
    #[serde(deserialize_with = "Option::deserialize")]
    ln_indentations: Option<Vec<f64>>,
}

/// The limits of a paraboloid, to which every law goes for small ŷ.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Limits {
    /// f at rest, 4/3.
    slow_force: f64,
    /// f at infinite speed, 4/3 E∞/E0.
    fast_force: f64,
    /// g at both ends, π.
    area: f64,
    /// μ/v̂ at rest.
    slow_friction: f64,
    /// μ v̂/ŷ at infinite speed.
    fast_friction: f64,
}

impl Limits {
    fn new(material: &LawMaterial) -> Self {
        Self {
            slow_force: 4.0 / 3.0,
            fast_force: 4.0 / 3.0 * material.modulus_ratio,
            area: PI,
            slow_friction: material.slow_friction(),
            fast_friction: material.fast_friction(),
        }
    }

    fn of(indenter: LawIndenter, material: &LawMaterial) -> Option<Self> {
        (!indenter.is_line()).then(|| Self::new(material))
    }

    fn check(found: Option<&Self>, indenter: LawIndenter, material: &LawMaterial) -> Result<(), LawError> {
        let exact = Self::of(indenter, material).unwrap_or_else(Self::none);
        found.unwrap_or(&Self::none()).agrees(&exact)
    }

    /// Those of an indenter that has none.
    fn none() -> Self {
        Self { slow_force: 0.0, fast_force: 0.0, area: 0.0, slow_friction: 0.0, fast_friction: 0.0 }
    }

    fn agrees(&self, exact: &Self) -> Result<(), LawError> {
        for (name, found, expected) in [
            ("slow_force", self.slow_force, exact.slow_force),
            ("fast_force", self.fast_force, exact.fast_force),
            ("area", self.area, exact.area),
            ("slow_friction", self.slow_friction, exact.slow_friction),
            ("fast_friction", self.fast_friction, exact.fast_friction),
        ] {
            let is_close = (found - expected).abs() <= LIMIT_TOLERANCE * expected;
            if !is_close {
                return Err(LawError::LimitsDisagree { name, found, expected });
            }
        }
        Ok(())
    }
}

/// The file's text; `None` for a law that is a formula.
///
/// # Errors
/// JSON that cannot be written, which no law leads to.
pub fn to_json(law: &Law) -> Result<Option<String>, LawError> {
    if let Law::Sampled(law) = law {
        return sampled::file::to_json(law).map(Some);
    }
    let Some(data) = law.data() else { return Ok(None) };
    let (origin, values) = (data.origin(), data.values());
    let depths = match law {
        Law::Tabulated(law) => Some(law.ln_indentations()),
        _ => None,
    };
    let document = LawDocument {
        format: FORMAT.to_owned(),
        version: VERSION,
        source: origin.source.clone(),
        indenter: origin.indenter,
        material: origin.material.clone(),
        knots: KnotLists {
            ln_speeds: data.ln_speeds().iter().collect(),
            ln_indentations: depths.map(|knots| knots.iter().collect()),
        },
        values: values.clone(),
        errors: *data.errors(),
        limits: Limits::of(origin.indenter, &origin.material),
    };
    Ok(Some(serde_json::to_string_pretty(&document)?))
}

/// The law in a file's text.
///
/// # Errors
/// Another format or version; a field that lacks, or is one too many; knots that are not even; numbers that are not positive and
/// finite; limits or errors that make no sense.
pub fn from_json(text: &str) -> Result<Law, LawError> {
    let head: FileHead = serde_json::from_str(text)?;
    let understood = match head.format.as_str() {
        FORMAT => VERSION,
        sampled::file::FORMAT => sampled::file::VERSION,
        _ => return Err(LawError::WrongFormat { found: head.format, expected: FORMAT }),
    };
    if head.version != understood {
        return Err(LawError::WrongVersion { found: head.version, understood });
    }
    if head.format == sampled::file::FORMAT {
        return Ok(Law::Sampled(Arc::new(sampled::file::from_json(text)?)));
    }
    let document: LawDocument = serde_json::from_str(text)?;
    let material = document.material.checked()?;
    Limits::check(document.limits.as_ref(), document.indenter, &material)?;
    check_errors(&document.errors)?;
    let speeds = Knots::from_list(SPEED_AXIS, &document.knots.ln_speeds)?;
    let (values, errors) = (document.values, document.errors);
    match document.knots.ln_indentations {
        Some(list) => {
            let depths = Knots::from_list(INDENTATION_AXIS, &list)?;
            let origin = LawOrigin { material, indenter: document.indenter, source: document.source };
            let law = TabulatedLaw::new(origin, speeds, depths, values, errors.solver)?;
            Ok(Law::Tabulated(Arc::new(law)))
        }
        None if document.indenter == LawIndenter::Paraboloid => {
            let law = CollapsedLaw::new(material, document.source, speeds, values, errors.solver)?;
            Ok(Law::Collapsed(Arc::new(law)))
        }
        None => Err(LawError::TooFewKnots { axis: INDENTATION_AXIS, count: 0, least: 2 }),
    }
}

fn check_errors(errors: &LawErrors) -> Result<(), LawError> {
    for value in errors.interpolation.into_array().into_iter().chain(errors.solver.into_array()) {
        if !(value >= 0.0 && value.is_finite()) {
            let requirement = "finite and not negative";
            return Err(LawError::InvalidNumber { name: "error", value, requirement });
        }
    }
    Ok(())
}
