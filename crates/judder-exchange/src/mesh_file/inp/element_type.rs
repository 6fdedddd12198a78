//! The element types of Abaqus and CalculiX that have a counterpart.

use crate::cause::FileCause;
use crate::quoted::quoted;
use judder_structure::element::ElementKind;

/// How the third direction is meant.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Formulation {
    PlaneStress,
    PlaneStrain,
    Solid,
}

/// What a type is here.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct ElementType {
    pub(super) kind: ElementKind,
    pub(super) formulation: Formulation,
    /// What differs from the type's own formulation.
    pub(super) difference: Option<&'static str>,
}

const FULL: Option<&str> = Some("is computed with full integration");
const BENDING: Option<&str> = Some("is computed with incompatible modes");

/// The counterpart of a type in capitals.
pub(super) fn element_type(name: &str) -> Result<ElementType, FileCause> {
    use ElementKind::{Hexahedron8, Hexahedron20, Quad4, Quad8, Tetrahedron10, Triangle6};
    let unsupported = || FileCause::Unsupported {
        what: "the type of elements",
        found: format!("`{}`", quoted(name)),
        read: "CPS4, CPE4 (with I or R), CPS8, CPE8, CPS8R, CPE8R, CPS6, CPE6, C3D8 (with I or R), C3D20, C3D20R, C3D10",
    };
    let (formulation, rest) =
        [("CPS", Formulation::PlaneStress), ("CPE", Formulation::PlaneStrain), ("C3D", Formulation::Solid)]
            .into_iter()
            .find_map(|(start, formulation)| Some((formulation, name.strip_prefix(start)?)))
            .ok_or_else(unsupported)?;
    let (kind, difference) = match (formulation == Formulation::Solid, rest) {
        (false, "4") => (Quad4, BENDING),
        (false, "4I") => (Quad4, None),
        (false, "4R") => (Quad4, FULL),
        (false, "8") => (Quad8, None),
        (false, "8R") => (Quad8, FULL),
        (false, "6") => (Triangle6, None),
        (true, "8") => (Hexahedron8, BENDING),
        (true, "8I") => (Hexahedron8, None),
        (true, "8R") => (Hexahedron8, FULL),
        (true, "20") => (Hexahedron20, None),
        (true, "20R") => (Hexahedron20, FULL),
        (true, "10") => (Tetrahedron10, None),
        _ => return Err(unsupported()),
    };
    Ok(ElementType { kind, formulation, difference })
}
