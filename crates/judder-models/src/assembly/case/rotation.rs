//! `rotation` of a structure: a body that turns.

use super::problem::AssemblyProblem;
use super::vector::{PLACE, VECTOR, check_direction};
use crate::structure::case::StructureSource;
use crate::structure::case::body::{BodyGeometry, BodySettings};
use judder_keys::Settings;
use judder_keys::cause::Cause;
use judder_keys::declared::{Number, both};
use judder_keys::dimension::Dimension;
use judder_keys::error::Fault;
use judder_keys::problem::Placed;
use judder_keys::section::Section;
use judder_structure::rotation::{RotatingFrame, Rotation};

/// A body that turns about an axis with a speed that stays.
#[derive(Debug, Clone, PartialEq, Settings)]
pub struct BodyRotation {
    /// The angular speed of a body that turns, counter-clockwise about the axis.
    #[key(rule = Number::any(Dimension::ANGULAR_FREQUENCY), symbol = "ω")]
    pub speed: f64,
    /// The axis about which it turns, of any length.
    #[key(rule = VECTOR, default = vec![0.0, 0.0, 1.0])]
    pub axis: Vec<f64>,
    /// A place of the axis.
    #[key(rule = PLACE, default = vec![0.0; 3])]
    pub centre: Vec<f64>,
    /// Where displacements are seen from: `fixed`, where what touches a body of revolution stands still; `rotating`, with the body.
    #[key(default = RotatingFrame::Fixed)]
    pub frame: RotatingFrame,
    /// Whether the forces that follow the velocities are there: Coriolis' in the frame that turns, those of convection in the fixed one.
    #[key(default = true)]
    pub gyroscopic: bool,
    /// Whether the centrifugal force grows as the body moves outwards; in the fixed frame this is part of all that convection takes of the stiffness.
    #[key(default = true)]
    pub softening: bool,
    /// Whether the centrifugal force is there, with the stiffness by its stress.
    #[key(default = true)]
    pub centrifugal: bool,
}

impl BodyRotation {
    /// Refuses an axis without a direction, and bodies that cannot turn; `section` is that of the structure.
    pub(super) fn admit(&self, section: &Section<'_>, source: &StructureSource) -> Result<(), Fault> {
        let refused = |reason: &str| {
            Err(AssemblyProblem::Refused { reason: reason.to_owned() }.at(section.place_of(&["rotation"])))
        };
        let body = match source {
            StructureSource::Matrices(_) => refused(
                "a body of matrices cannot turn here: what turning does to it is not in them; have it in the matrices",
            ),
            StructureSource::Body(BodySettings { geometry: BodyGeometry::Beam(_), .. }) => refused(
                "a beam is a body of the plane, which cannot turn: gyroscopic and centrifugal terms are those of elements of space",
            ),
            StructureSource::Body(body)
                if !body.is_solid() && !matches!(body.geometry, BodyGeometry::Mesh(_)) =>
            {
                refused(
                    "a body of the plane cannot turn: gyroscopic and centrifugal terms are those of elements of space",
                )
            }
            StructureSource::Body(_) => Ok(()),
        };
        let masses = match section.get("masses") {
            Some(node) => {
                Err(Cause::Meaningless { key: "masses", with: section.path("rotation") }.at(node.place))
            }
            None => Ok(()),
        };
        let axis = match section.inner("rotation")? {
            Some(own) => check_direction(&self.axis, &own, &["axis"]),
            None => Ok(()),
        };
        both(both(axis, body), masses).map(drop)
    }

    /// As the physics has it.
    pub(crate) fn motion(&self) -> Rotation {
        let place = |vector: &[f64]| std::array::from_fn(|k| vector.get(k).copied().unwrap_or(0.0));
        let axis: [f64; 3] = place(&self.axis);
        let length = axis.iter().map(|part| part * part).sum::<f64>().sqrt();
        Rotation {
            angular_velocity: axis.map(|part| self.speed * part / length),
            centre: place(&self.centre),
        }
    }

    /// Whether its material passes beneath what stands still.
    pub(crate) fn passes(&self) -> bool {
        self.frame == RotatingFrame::Fixed && self.gyroscopic
    }

    /// What is left out of it, in words.
    pub(crate) fn left_out(&self) -> Vec<&'static str> {
        let terms = [
            (self.gyroscopic, "gyroscopic forces"),
            (
                self.softening,
                match self.frame {
                    RotatingFrame::Fixed => "convective softening",
                    RotatingFrame::Rotating => "spin softening",
                },
            ),
            (self.centrifugal, "centrifugal force and stiffening"),
        ];
        terms.into_iter().filter(|(is_there, _)| !is_there).map(|(_, name)| name).collect()
    }
}
