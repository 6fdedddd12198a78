//! What each keyword of a deck means here.

use super::deck::Keyword;
use super::model::DeckModel;
use crate::cause::FileCause;
use crate::error::ExchangeError;
use crate::quoted::quoted;

/// Takes a keyword into the model.
type Read = fn(&mut DeckModel, &Keyword<'_>) -> Result<(), ExchangeError>;

/// What is done with a keyword.
pub(super) enum Meaning {
    Read(Read),
    /// It says nothing about the mesh.
    Nothing,
    /// Without it the structure would be another one.
    Refused(&'static str),
    /// What follows up to `*END STEP` belongs to an analysis.
    Step,
    /// Noted and left out.
    PassedOver,
}

const PLACES: &str = "it makes or moves nodes and elements; write the deck with all of them as numbers";
const CONSTRAINTS: &str =
    "it ties displacements together, which is not read; remove it and tie them in the case";
const SECTIONS: &str = "these elements have no counterpart; a mesh of solid and plane elements is read";
const MATERIALS: &str = "the material is not isotropic and linear elastic";
const FILES: &str = "it takes in another file; put its lines in its place";

/// What is done with the keyword of a name in capitals.
pub(super) fn meaning(name: &str) -> Meaning {
    match name {
        "NODE" => Meaning::Read(DeckModel::read_nodes),
        "ELEMENT" => Meaning::Read(DeckModel::read_elements),
        "NSET" => Meaning::Read(DeckModel::read_node_set),
        "ELSET" => Meaning::Read(DeckModel::read_element_set),
        "SURFACE" => Meaning::Read(DeckModel::read_surface),
        "MATERIAL" => Meaning::Read(DeckModel::read_material),
        "ELASTIC" => Meaning::Read(DeckModel::read_elastic),
        "DENSITY" => Meaning::Read(DeckModel::read_density),
        "SOLID SECTION" => Meaning::Read(DeckModel::read_solid_section),
        "PART" => Meaning::Read(DeckModel::read_part),
        "INSTANCE" => Meaning::Read(DeckModel::read_instance),
        "HEADING" | "PREPRINT" | "END PART" | "END INSTANCE" | "ASSEMBLY" | "END ASSEMBLY" => {
            Meaning::Nothing
        }
        "INCLUDE" | "PARAMETER" | "MATRIX INPUT" | "MATRIX ASSEMBLE" | "SUBSTRUCTURE PROPERTY" => {
            Meaning::Refused(FILES)
        }
        "SYSTEM" | "NGEN" | "NFILL" | "NCOPY" | "NMAP" | "ELGEN" | "ELCOPY" | "NODAL THICKNESS" => {
            Meaning::Refused(PLACES)
        }
        "TRANSFORM"
        | "EQUATION"
        | "MPC"
        | "TIE"
        | "COUPLING"
        | "KINEMATIC COUPLING"
        | "DISTRIBUTING COUPLING"
        | "RIGID BODY"
        | "EMBEDDED ELEMENT"
        | "CYCLIC SYMMETRY MODEL"
        | "NETWORK MPC" => Meaning::Refused(CONSTRAINTS),
        "SHELL SECTION"
        | "SHELL GENERAL SECTION"
        | "BEAM SECTION"
        | "BEAM GENERAL SECTION"
        | "MEMBRANE SECTION"
        | "MASS"
        | "ROTARY INERTIA"
        | "NONSTRUCTURAL MASS"
        | "SPRING"
        | "SPRINGA"
        | "DASHPOT"
        | "CONNECTOR SECTION"
        | "GASKET SECTION"
        | "COHESIVE SECTION"
        | "USER ELEMENT" => Meaning::Refused(SECTIONS),
        "HYPERELASTIC" | "HYPERFOAM" | "USER MATERIAL" | "POROUS ELASTIC" | "ENGINEERING CONSTANTS" => {
            Meaning::Refused(MATERIALS)
        }
        "STEP" => Meaning::Step,
        _ => Meaning::PassedOver,
    }
}

/// Why a keyword is refused.
pub(super) fn refusal(name: &str, why: &'static str) -> FileCause {
    FileCause::Refused { keyword: quoted(name), why }
}
