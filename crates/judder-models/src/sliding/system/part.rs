//! A structure reduced to the freedoms that contact, load and observed points need.

use super::damping::damping;
use super::{Uncoupled, alone};
use crate::sliding::case::SlidingCase;
use crate::structure::build::{Structure, symmetric_part};
use crate::structure::case::reduction::FixedModes;
use faer::Mat;
use judder_sliding::plane::PlaneVector;
use judder_sliding::reduced::Reduced;
use judder_structure::assembly::{Sparse, inertia_load};
use judder_structure::craig_bampton::{CraigBampton, CutOff};
use judder_structure::rigid::{largest_ratio, rigid_limit};
use judder_structure::statics::product;
use std::f64::consts::TAU;
use std::sync::Arc;

/// One of the two structures in modal form.
pub(crate) struct StructurePart {
    /// As it was read or assembled.
    pub(crate) structure: Arc<Structure>,
    /// The freedoms that are kept.
    pub(crate) kept: Vec<usize>,
    /// How many fixed-interface modes are kept beside them.
    pub(crate) fixed_modes: usize,
    /// Its modal form.
    pub(crate) reduced: Reduced,
    /// The direction of the inertia load; of the slider alone.
    pub(super) direction: Option<PlaneVector>,
    warnings: Vec<String>,
}

/// What is right of a structure that is to be reduced.
const REDUCIBLE: &str = "a structure has a symmetric mass with positive masses only, a symmetric stiffness, and a damping of α M + β K";
/// Departure from symmetry that is rounding.
const ROUNDING: f64 = 1e-12;

/// That a structure cannot be reduced, and why.
fn refused(case: &SlidingCase, index: usize, error: &dyn std::fmt::Display) -> Uncoupled {
    Uncoupled::because(format!("structure.{}", case.structures[index].name), error, REDUCIBLE)
}

/// A structure on its kept freedoms and fixed-interface modes, and what it was reduced from.
struct PartReduction {
    stiffness: Sparse,
    mass: Sparse,
    /// α and β.
    damping: (f64, f64),
    reduced: CraigBampton,
}

impl PartReduction {
    fn new(
        case: &SlidingCase,
        index: usize,
        structure: &Structure,
        kept: &[usize],
    ) -> Result<Self, Uncoupled> {
        let own = &case.structures[index];
        let refuse = |error: &dyn std::fmt::Display| refused(case, index, error);
        let problem = structure.at(&alone(case, index), &case.values()).map_err(|error| refuse(&error))?;
        let symmetric = |name: &str, matrix: &Sparse| {
            let (part, departure) = symmetric_part(matrix).map_err(|error| refuse(&error))?;
            if departure <= ROUNDING {
                return Ok(part);
            }
            Err(refuse(&format!(
                "the {name} is not symmetric, by {departure:.1e} of its largest entry: a reduction to modes needs a symmetric one"
            )))
        };
        let mass = symmetric("mass", problem.mass())?;
        let stiffness = symmetric("stiffness", problem.stiffness())?;
        let damping = damping(&own.damping(), problem.damping(), [&mass, &stiffness])
            .map_err(|error| refuse(&error))?;
        let cut_off = match own.reduction.modes {
            FixedModes::Count(count) => CutOff::Count(count),
            FixedModes::CutOff(limit) => CutOff::Frequency(limit / TAU),
        };
        let reduced = CraigBampton::new(&stiffness, &mass, kept, cut_off).map_err(|error| refuse(&error))?;
        Ok(Self { stiffness, mass, damping, reduced })
    }
}

impl StructurePart {
    /// Reduces a structure to kept freedoms, with the inertia load along `direction` where it moves.
    pub(super) fn new(
        case: &SlidingCase,
        index: usize,
        structure: &Arc<Structure>,
        kept: &[usize],
        direction: Option<PlaneVector>,
    ) -> Result<Self, Uncoupled> {
        let refuse = |error: &dyn std::fmt::Display| refused(case, index, error);
        let reduction = PartReduction::new(case, index, structure, kept)?;
        let PartReduction { stiffness, mass, damping, reduced } = &reduction;
        let mut warnings = Vec::new();
        let load = match direction {
            Some(direction) => {
                inertia(structure, mass, direction, &mut warnings).map_err(|error| refuse(&error))?
            }
            None => Vec::new(),
        };
        let fixed_modes = reduced.fixed_interface.len();
        let rigid = rigid_limit(mass.nrows(), largest_ratio(stiffness, mass));
        let reduced =
            Reduced::new(reduced, damping.0, damping.1, rigid, &load).map_err(|error| refuse(&error))?;
        let structure = Arc::clone(structure);
        Ok(Self { structure, kept: kept.to_vec(), fixed_modes, reduced, direction, warnings })
    }

    /// Φ on all freedoms of the structure, by the modes of its modal form: 1/√kg. The structure is reduced anew, for its basis is too large
    /// to keep where nobody looks at shapes.
    pub(crate) fn shapes(&self, case: &SlidingCase, index: usize) -> Result<Mat<f64>, Uncoupled> {
        let PartReduction { reduced, .. } = PartReduction::new(case, index, &self.structure, &self.kept)?;
        let form = reduced.modal_form().map_err(|error| refused(case, index, &error))?;
        Ok(&reduced.basis * &form.shapes)
    }

    /// The row of Φ of a freedom that is kept.
    pub(super) fn row(&self, freedom: usize) -> Result<Vec<f64>, Uncoupled> {
        let place = self.kept.iter().position(|kept| *kept == freedom);
        self.reduced
            .row(place.or(Some(self.kept.len())))
            .map_err(|error| Uncoupled::because("contact", error, REDUCIBLE))
    }

    /// The rows of Φ of a point along x and y; zeros where it is held.
    pub(super) fn rows(&self, point: usize) -> Result<[Vec<f64>; 2], Uncoupled> {
        let freedoms = self.structure.layout.as_ref().and_then(|layout| layout.freedoms.get(point).copied());
        let [x, y, _] = freedoms.unwrap_or_default();
        let row = |freedom: Option<usize>| match freedom {
            Some(freedom) => self.row(freedom),
            None => Ok(vec![0.0; self.reduced.body.modes()]),
        };
        Ok([row(x)?, row(y)?])
    }

    /// Where a point lies, m.
    pub(super) fn place(&self, point: usize) -> PlaneVector {
        place(&self.structure, point)
    }

    /// What the user has to know of it.
    pub(super) fn warnings(&self) -> impl Iterator<Item = &String> {
        self.structure.warnings.iter().chain(&self.warnings)
    }
}

/// Where a point of a structure lies, m.
pub(super) fn place(structure: &Structure, point: usize) -> PlaneVector {
    let place = structure.layout.as_ref().and_then(|layout| layout.points.get(point));
    place.map_or([0.0; 2], |[x, y, _]| [*x, *y])
}

/// The inertia load of a unit acceleration, kg: of elements with the mass that is held, of imported matrices without it.
fn inertia(
    structure: &Structure,
    mass: &Sparse,
    [x, y]: PlaneVector,
    warnings: &mut Vec<String>,
) -> Result<Vec<f64>, judder_structure::StructureError> {
    if let Some(elements) = &structure.elements {
        return inertia_load(&elements.mesh, &elements.materials, &elements.numbering, [x, y, 0.0]);
    }
    let mut moved = vec![0.0; mass.nrows()];
    for [along_x, along_y, _] in structure.layout.iter().flat_map(|layout| &layout.freedoms) {
        for (freedom, share) in [(along_x, x), (along_y, y)] {
            if let Some(freedom) = freedom {
                moved[*freedom] = share;
            }
        }
    }
    warnings.push(
        "the inertia of the moving frame is that of the matrices: mass at displacements that were held before they were exported is \
         not in it"
            .to_owned(),
    );
    Ok(product(mass, &moved))
}
