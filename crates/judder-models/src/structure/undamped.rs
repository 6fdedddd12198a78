//! The structure whose real modes are shown: without damping, and without friction where the sums of matrices tell which part that is.

use crate::error::ModelError;
use crate::structure::build::{Structure, factors, symmetric_part};
use crate::structure::case::matrices::MatrixTerm;
use crate::structure::case::{Matrices, StructureCase, StructureSource};
use judder_structure::StructureError;
use judder_structure::affine::Term;
use judder_structure::assembly::Sparse;
use judder_structure::modes::{WantedModes, admit, admit_sums};
use judder_study::text::short;

/// Departure from symmetry that is rounding.
const ROUNDING: f64 = 1e-12;

/// Multiplications of a factorisation up to which `judder check` looks at matrices: all looks together take about a second.
pub(crate) const MOST_OPERATIONS: f64 = 1e9;

/// Symmetric M and K at the case's own parameters, and of what they are.
pub(super) struct Undamped {
    pub(super) mass: Sparse,
    pub(super) stiffness: Sparse,
    pub(super) of: ModesOf,
}

/// Of what real modes are.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum ModesOf {
    /// M and K as they are, which are symmetric.
    Structure,
    /// M and K without the matrices of these names, which are not symmetric and whose factors parameters set: friction at μ = 0.
    Frictionless(Vec<String>),
    /// The symmetric parts of matrices that are not symmetric, of which nothing tells what in them is friction: they have half of it.
    SymmetricPart {
        /// Which matrices, in words, and ‖A − Aᵀ‖/‖A‖ of each.
        departures: Vec<String>,
    },
}

/// Of what undamped modes are, where they are not those of the matrices as they are.
pub(super) fn words_of(name: Option<&str>) -> &'static str {
    match name {
        Some("frictionless") => " without friction",
        Some("symmetric-part") => " of the symmetric part",
        _ => "",
    }
}

impl ModesOf {
    /// As summaries and attributes have it.
    pub(super) fn name(&self) -> &'static str {
        match self {
            Self::Structure => "structure",
            Self::Frictionless(_) => "frictionless",
            Self::SymmetricPart { .. } => "symmetric-part",
        }
    }

    /// What has to be said of `what`, which is taken of them: modes, a reduction.
    pub(super) fn warning(&self, what: &str) -> Option<String> {
        match self {
            Self::Structure => None,
            Self::Frictionless(names) => Some(format!(
                "the matrices are not symmetric: {what} without friction, that is without {}, whose factors parameters set",
                names.join(", ")
            )),
            Self::SymmetricPart { departures } => Some(format!(
                "{}, and no factor with a parameter tells which part of it is friction: {what} of the symmetric part, which has half of the friction in it",
                departures.join(" and ")
            )),
        }
    }
}

impl Undamped {
    pub(super) fn new(case: &StructureCase, structure: &Structure) -> Result<Self, ModelError> {
        let mut at = factors(case, &case.values())?;
        let whole = structure.family.at(&at)?;
        let parts = [symmetric_part(whole.mass())?, symmetric_part(whole.stiffness())?];
        if parts.iter().all(|(_, departure)| *departure <= ROUNDING) {
            let [(mass, _), (stiffness, _)] = parts;
            return Ok(Self { mass, stiffness, of: ModesOf::Structure });
        }
        let mut left_out = Vec::new();
        if let StructureSource::Matrices(Matrices::Files(sums)) = &case.source {
            let count = case.parameters.len();
            let family = &structure.family;
            left_out.extend(without(&sums.mass, family.mass(), &mut at.mass, count)?);
            left_out.extend(without(&sums.stiffness, family.stiffness(), &mut at.stiffness, count)?);
        }
        let rest = match structure.family.at(&at) {
            Ok(rest) => rest,
            // nothing else is there
            Err(StructureError::EmptyMatrix { .. }) => return Ok(Self::symmetric(parts)),
            Err(error) => return Err(error.into()),
        };
        let of_rest = [symmetric_part(rest.mass())?, symmetric_part(rest.stiffness())?];
        if left_out.is_empty() || of_rest.iter().any(|(_, departure)| *departure > ROUNDING) {
            return Ok(Self::symmetric(parts));
        }
        let [(mass, _), (stiffness, _)] = of_rest;
        Ok(Self { mass, stiffness, of: ModesOf::Frictionless(left_out) })
    }

    /// Refuses, for `judder check`, what a search for modes would refuse before it begins.
    pub(super) fn admit(
        case: &StructureCase,
        structure: &Structure,
        wanted: WantedModes,
    ) -> Result<(), ModelError> {
        if let (StructureSource::Body(_), [mass], [stiffness]) =
            (&case.source, structure.family.mass(), structure.family.stiffness())
        {
            return Ok(admit_sums(&stiffness.matrix, &mass.matrix)?);
        }
        let Self { mass, stiffness, .. } = Self::new(case, structure)?;
        Ok(admit(&stiffness, &mass, wanted, MOST_OPERATIONS)?)
    }

    fn symmetric([(mass, of_mass), (stiffness, of_stiffness)]: [(Sparse, f64); 2]) -> Self {
        let departures = [("the mass", of_mass), ("the stiffness", of_stiffness)]
            .into_iter()
            .filter(|(_, departure)| *departure > ROUNDING)
            .map(|(name, departure)| {
                format!("{name} is not symmetric ({} of its largest entry)", short(departure))
            })
            .collect();
        Self { mass, stiffness, of: ModesOf::SymmetricPart { departures } }
    }
}

/// Takes the matrices of a sum out that are not symmetric and whose factors parameters set; their names.
fn without(
    terms: &[MatrixTerm],
    matrices: &[Term],
    factors: &mut [f64],
    parameters: usize,
) -> Result<Vec<String>, ModelError> {
    let mut names = Vec::new();
    for ((term, matrix), factor) in terms.iter().zip(matrices).zip(factors) {
        let is_set = (0..parameters).any(|index| term.factor.depends_on(index));
        if is_set && symmetric_part(&matrix.matrix)?.1 > ROUNDING {
            *factor = 0.0;
            names.push(format!("`{}`", matrix.name));
        }
    }
    Ok(names)
}
