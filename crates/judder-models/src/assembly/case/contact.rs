//! `[[contact]]`: a surface of one structure on a plane or on a surface of another.

use super::asperity::AsperitySettings;
use super::named_list::NamedItem;
use super::normal_law::{NormalLaw, check_law};
use super::problem::AssemblyProblem;
use super::structure::AssemblyStructure;
use super::vector::{PLACE, VECTOR, check_direction};
use crate::friction::FrictionSettings;
use crate::sliding::case::plain_name::{PlainName, find_structure};
use crate::structure::case::reduction::KeptNodes;
use judder_keys::Settings;
use judder_keys::cause::Cause;
use judder_keys::declared::{Named, Number, all, both};
use judder_keys::dimension::Dimension;
use judder_keys::error::Fault;
use judder_keys::file_reference::FileReference;
use judder_keys::problem::Placed;
use judder_keys::section::Section;
use judder_sliding::edge::Interpolation;
use judder_sliding::locus::Configuration;
use judder_structure::rotation::RotatingFrame;
use std::path::Path;

/// A contact interface: who slides on what, and what presses and drags between them.
#[derive(Debug, Clone, Settings)]
#[settings(check = ContactInterface::check)]
pub struct ContactInterface {
    /// By which keys call this contact.
    #[key(rule = "contact", example = "\"…\", by which keys call this contact")]
    pub name: PlainName,
    /// The slider, whose nodes are the contact points.
    #[key(example = "{ structure = \"…\", set = \"y-min\" }")]
    pub slider: SurfaceOf,
    /// What it slides on: a rigid plane, a surface of another structure, or a node of it that carries a plane.
    #[key(example = "{ plane = { normal = [0, 1] } } or { structure = \"…\", set = \"…\" }")]
    pub track: TrackSettings,
    /// How the track moves beside the slider.
    #[key(example = "{ velocity = \"1 m/s\", direction = [1, 0] }")]
    pub sliding: TrackMotion,
    /// The geometry about which motions are small: that of the bodies as they are meshed, or as they lie in steady sliding, where the normal turns with
    /// the track.
    #[key(default = Configuration::Undeformed)]
    pub configuration: Configuration,
    /// In a `march` the contact points travel along the track as it moves beside the slider, an edge in the plane that runs so between its nodes; where
    /// left out they stay where they are meshed, and the track is as long as it takes. All other analyses are of the places as meshed.
    #[key(omitted)]
    pub travel: Option<Interpolation>,
    /// What presses and drags.
    #[key(flatten)]
    pub forces: ContactForceSettings,
}

/// What presses and drags at a contact.
#[derive(Debug, Clone, Settings)]
pub enum ContactForceSettings {
    /// A normal law, and friction that is proportional to the normal force.
    Coulomb {
        /// What presses: `rigid`, or a pressure or a force that follows the closure.
        #[key(default = NormalLaw::Rigid)]
        normal: NormalLaw,
        /// Friction coefficient: a number, one that falls from rest and may rise again, or a table against the slip speed.
        #[key(name = "friction_coefficient", symbol = "μ")]
        friction: FrictionSettings,
        /// Whether all points stay closed whatever their force.
        #[key(default = false)]
        all_closed: bool,
    },
    /// A sphere on the substrate of the case, for one contact point, in place of normal and friction_coefficient; its keys are those of an oscillator case.
    #[key(example = "{ radius = \"10 mm\", law = \"oscillator-paper\", shear_strength = 0.01 }")]
    Asperity(AsperitySettings),
}

impl ContactForceSettings {
    /// The files of its friction coefficient and of its forces.
    pub(super) fn files(&self) -> impl Iterator<Item = &FileReference> {
        let own = match self {
            Self::Coulomb { normal: NormalLaw::File(own), friction, .. } => {
                [Some(&own.file.file), friction.file()]
            }
            Self::Coulomb { friction, .. } => [None, friction.file()],
            Self::Asperity(_) => [None, None],
        };
        own.into_iter().flatten()
    }
}

/// Nodes of a structure.
#[derive(Debug, Clone, PartialEq, Settings)]
pub struct SurfaceOf {
    /// The name of a structure.
    #[key(later)]
    pub structure: Named<usize>,
    /// The nodes.
    #[key(flatten)]
    pub nodes: KeptNodes,
}

/// What a slider slides on.
#[derive(Debug, Clone, PartialEq, Settings)]
pub enum TrackSettings {
    /// A rigid plane through the foremost node of the slider, or off it.
    Plane(PlaneSettings),
    /// A surface of another structure.
    #[key(flatten)]
    Surface(TrackOf),
}

/// A surface of another structure, or a node of it that carries a plane.
#[derive(Debug, Clone, PartialEq, Settings)]
pub struct TrackOf {
    /// The surface, or the node.
    #[key(flatten)]
    pub surface: SurfaceOf,
    /// Of a single node, which has no surface: the normal of a rigid plane that moves with it, out of it, towards the slider.
    #[key(rule = VECTOR, symbol = "n", omitted, example = "[0, 1]")]
    pub normal: Option<Vec<f64>>,
}

/// A rigid plane.
#[derive(Debug, Clone, PartialEq, Settings)]
pub struct PlaneSettings {
    /// The normal out of the plane, towards the slider, of any length.
    #[key(rule = VECTOR, symbol = "n", example = "[0, 1]")]
    pub normal: Vec<f64>,
    /// How far it lies off that node, as a stop does; below zero it presses on what is meshed.
    #[key(rule = Number::any(Dimension::LENGTH), symbol = "g_0", usual = 0.0, omitted)]
    pub gap: Option<f64>,
}

/// How the track moves beside the slider.
#[derive(Debug, Clone, PartialEq, Settings)]
pub enum TrackMotion {
    /// It moves with one velocity.
    #[key(flatten)]
    Translation(Translation),
    /// It turns about an axis.
    #[key(flatten)]
    Rotation(TrackRotation),
}

/// A track that moves with one velocity.
#[derive(Debug, Clone, PartialEq, Settings)]
pub struct Translation {
    /// The speed of the track beside the slider; nothing of a track at rest, on which bodies are driven.
    #[key(rule = Number::any(Dimension::SPEED), symbol = "V")]
    pub velocity: f64,
    /// The direction in which it moves, of any length; of a track at rest along which slip is reckoned.
    #[key(rule = VECTOR, example = "[1, 0]")]
    pub direction: Vec<f64>,
}

/// A track that turns about an axis.
#[derive(Debug, Clone, PartialEq, Settings)]
pub struct TrackRotation {
    /// The angular speed of the track beside the slider, in place of velocity and direction.
    #[key(rule = Number::any(Dimension::ANGULAR_FREQUENCY), symbol = "ω")]
    pub speed: f64,
    /// The axis about which it turns counter-clockwise, of any length.
    #[key(rule = VECTOR, example = "[0, 0, 1]")]
    pub axis: Vec<f64>,
    /// A place of the axis.
    #[key(rule = PLACE, default = vec![0.0; 3])]
    pub centre: Vec<f64>,
}

impl NamedItem for ContactInterface {
    const WHAT: &'static str = "contact";

    fn name(&self) -> &PlainName {
        &self.name
    }
}

impl ContactInterface {
    /// Refuses laws whose numbers make none.
    fn check(&mut self, section: &Section<'_>) -> Result<(), Fault> {
        match &self.forces {
            ContactForceSettings::Coulomb { normal: NormalLaw::Compliant(law), all_closed, .. } => {
                check_law(law, *all_closed, section)
            }
            // that of a file when it has been found
            ContactForceSettings::Coulomb { .. } | ContactForceSettings::Asperity(_) => Ok(()),
        }
    }

    /// Finds the structures, and refuses nodes that they cannot have, a structure that slides on itself, and vectors without a direction.
    pub(super) fn admit(
        &mut self,
        section: &Section<'_>,
        structures: &[AssemblyStructure],
        folder: &Path,
    ) -> Result<(), Fault> {
        let forces = match &mut self.forces {
            ContactForceSettings::Coulomb { normal, friction, all_closed } => {
                let friction = friction.admit(section, "friction_coefficient", folder);
                both(normal.admit(section, folder, *all_closed), friction).map(drop)
            }
            ContactForceSettings::Asperity(_) => Ok(()),
        };
        let slider = match section.inner("slider")? {
            Some(own) => self.slider.admit(&own, structures),
            None => Ok(()),
        };
        let track = match (&mut self.track, section.inner("track")?) {
            (TrackSettings::Surface(track), Some(own)) => {
                let normal =
                    track.normal.iter().map(|own| check_direction(own, section, &["track", "normal"]));
                both(track.surface.admit(&own, structures), all(normal)).map(drop)
            }
            (TrackSettings::Plane(plane), Some(own)) => {
                check_direction(&plane.normal, &own, &["plane", "normal"])
            }
            (_, None) => Ok(()),
        };
        let sliding = match &self.sliding {
            TrackMotion::Translation(own) => {
                check_direction(&own.direction, section, &["sliding", "direction"])
            }
            TrackMotion::Rotation(own) => check_direction(&own.axis, section, &["sliding", "axis"]),
        };
        both(both(slider, track), both(sliding, forces))?;
        let flat = match &self.track {
            TrackSettings::Plane(_) => Some("track.plane"),
            TrackSettings::Surface(track) => track.normal.as_ref().map(|_| "track.normal"),
        };
        if let (Some(flat), Configuration::Deformed) = (flat, self.configuration) {
            let place = section.place_of(&["configuration"]);
            return Err(Cause::Meaningless { key: "configuration", with: section.path(flat) }.at(place));
        }
        self.check_travel(section, flat)?;
        self.check_frames(section, structures)?;
        match &self.track {
            TrackSettings::Surface(track) if track.surface.structure == self.slider.structure => {
                let name = track.surface.structure.name.clone();
                Err(AssemblyProblem::SameStructure { name }.at(section.place_of(&["track"])))
            }
            _ => Ok(()),
        }
    }
}

impl ContactInterface {
    /// Refuses points that travel along what has no edge, or that do not know how far.
    fn check_travel(&self, section: &Section<'_>, flat: Option<&str>) -> Result<(), Fault> {
        let turning = matches!(self.sliding, TrackMotion::Rotation(_)).then_some("sliding.axis");
        match (self.travel, flat.or(turning)) {
            (Some(_), Some(with)) => {
                let with = section.path(with);
                Err(Cause::Meaningless { key: "travel", with }.at(section.place_of(&["travel"])))
            }
            _ => Ok(()),
        }
    }

    /// Refuses bodies whose displacements are seen from the frame that turns with them: there the other side of the contact would not stand still.
    fn check_frames(&self, section: &Section<'_>, structures: &[AssemblyStructure]) -> Result<(), Fault> {
        let track = match &self.track {
            TrackSettings::Surface(track) => Some(*track.surface.structure),
            TrackSettings::Plane(_) => None,
        };
        let rotation = |structure: usize| {
            let rotation = structures.get(structure)?.rotation.as_ref()?;
            (rotation.frame == RotatingFrame::Rotating).then(|| rotation.motion())
        };
        let turning = [("slider", rotation(*self.slider.structure)), ("track", track.and_then(rotation))];
        // both in one frame stand still beside each other
        if track.is_some() && turning[0].1 == turning[1].1 {
            return Ok(());
        }
        match turning.into_iter().find(|(_, rotation)| rotation.is_some()) {
            Some((key, _)) => {
                let reason = "in the frame that turns with this body the other side of the contact does not stand still; give its rotation \
                              frame = \"fixed\", for a body of revolution";
                Err(AssemblyProblem::Refused { reason: reason.to_owned() }.at(section.place_of(&[key])))
            }
            None => Ok(()),
        }
    }
}

impl SurfaceOf {
    /// The nodes in words.
    pub(crate) fn words(&self) -> String {
        format!("{}.{}", self.structure.name, self.nodes.words())
    }

    pub(in crate::assembly) fn admit(
        &mut self,
        section: &Section<'_>,
        structures: &[AssemblyStructure],
    ) -> Result<(), Fault> {
        find_structure(&mut self.structure, structures.iter().map(|own| &own.name), section)?;
        KeptNodes::admit(section, &structures[*self.structure].source)
    }
}
