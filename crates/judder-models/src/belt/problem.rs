//! What can be wrong with a belt case, beyond types, units and ranges.

use judder_keys::problem::Problem;
use thiserror::Error;

/// What is wrong, with what a caller needs in order to act.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum BeltProblem {
    /// A quantity with a unit where the case has none.
    #[error("`{key}` has a unit, but the case is in units of its mass and its natural frequency")]
    WithoutUnits {
        /// The key.
        key: &'static str,
    },
    /// A plain number where the case is in SI.
    #[error("`{key}` needs a unit, as `oscillator.mass` and `oscillator.stiffness` have one")]
    NeedsUnit {
        /// The key.
        key: &'static str,
        /// Such as it would be.
        example: String,
    },
    /// One of mass and stiffness alone.
    #[error("the case gives one of `oscillator.mass` and `oscillator.stiffness` alone")]
    HalfUnits,
}

/// What makes a case one in SI.
pub(super) const GIVE_UNITS: &str =
    "give both: mass = \"1 kg\", stiffness = \"100 N/m\"; then every key of the case has its unit";

impl Problem for BeltProblem {
    fn kind(&self) -> &'static str {
        "Belt"
    }

    fn label(&self) -> &'static str {
        match self {
            Self::WithoutUnits { .. } => "with a unit",
            Self::NeedsUnit { .. } => "without a unit",
            Self::HalfUnits => "here",
        }
    }

    fn help(&self) -> Option<String> {
        Some(match self {
            Self::WithoutUnits { .. } | Self::HalfUnits => GIVE_UNITS.to_owned(),
            Self::NeedsUnit { key, example } => {
                let name = key.rsplit_once('.').map_or(*key, |(_, name)| name);
                format!("write {name} = \"{example}\"")
            }
        })
    }

    fn key(&self) -> Option<&str> {
        match self {
            Self::WithoutUnits { key } | Self::NeedsUnit { key, .. } => Some(key),
            Self::HalfUnits => None,
        }
    }
}
