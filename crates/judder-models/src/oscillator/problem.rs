//! What can be wrong with the law of an oscillator case, beyond types, units and ranges.

use crate::oscillator::law_name::LawName;
use judder_keys::problem::Problem;
use thiserror::Error;

/// What is wrong, with what a caller needs in order to act.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum OscillatorProblem {
    /// A law that is a table whose keys do not fit each other.
    #[error("`{key}` of `{table}` must be {requirement}")]
    LawTable {
        /// The table.
        table: String,
        /// The key.
        key: &'static str,
        /// What it must be.
        requirement: &'static str,
    },
    /// A series or measured data with a law that was fitted for one retardation time.
    #[error("the law `{}` knows one retardation time only, this substrate has several", law.name())]
    SeveralTimes {
        /// The law in use.
        law: LawName,
    },
    /// A cylinder on a half-space.
    #[error(
        "a cylinder needs `substrate.thickness`: on a half-space its depth depends on how far away it is measured"
    )]
    LineOnHalfSpace,
    /// A law that was made for another indenter than a cylinder.
    #[error("the law `{}` is not one of a cylinder", law.name())]
    LawOfLine {
        /// The law in use.
        law: LawName,
    },
    /// Prony compliances that leave no positive glassy modulus: 1/E∞ = 1/E0 − compliance.
    #[error("the prony compliance {compliance:e} 1/Pa is not below 1/E0 = {limit:e} 1/Pa")]
    PronyCompliance {
        /// The sum of the compliances, 1/Pa.
        compliance: f64,
        /// 1/E0, 1/Pa.
        limit: f64,
    },
    /// E∞ < E0, or E∞ = E0 with a law that needs relaxation.
    #[error("the glassy modulus {glassy:e} Pa is not above the rubbery modulus {rubbery:e} Pa")]
    GlassyBelowRubbery {
        /// E0, Pa.
        rubbery: f64,
        /// E∞, Pa.
        glassy: f64,
        /// The law in use.
        law: LawName,
    },
}

impl Problem for OscillatorProblem {
    fn kind(&self) -> &'static str {
        match self {
            Self::LawTable { .. } => "LawTable",
            Self::SeveralTimes { .. } => "SeveralTimes",
            Self::LineOnHalfSpace => "LineOnHalfSpace",
            Self::LawOfLine { .. } => "LawOfLine",
            Self::PronyCompliance { .. } => "PronyCompliance",
            Self::GlassyBelowRubbery { .. } => "GlassyBelowRubbery",
        }
    }

    fn label(&self) -> &'static str {
        "here"
    }

    fn help(&self) -> Option<String> {
        let help = match self {
            Self::LawTable { .. } => return None,
            Self::SeveralTimes { .. } => {
                "give one term, or compute the law for this substrate: law = \"bem\""
            }
            Self::LineOnHalfSpace => "give the thickness of the layer, which a rigid base holds",
            Self::LawOfLine { .. } => "compute it on the layer of the case: law = \"bem\"",
            Self::PronyCompliance { .. } => "1/E∞ = 1/E0 − compliance must be positive",
            Self::GlassyBelowRubbery { law: LawName::Hertz, .. } => {
                "E∞ must be above E0, or equal to it for an elastic substrate"
            }
            Self::GlassyBelowRubbery { .. } => "E∞ must be above E0; only the law \"hertz\" takes E∞ = E0",
        };
        Some(help.to_owned())
    }

    fn key(&self) -> Option<&str> {
        match self {
            Self::LawTable { key, .. } => Some(key),
            _ => None,
        }
    }
}
