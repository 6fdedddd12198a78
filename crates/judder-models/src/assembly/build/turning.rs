//! What turning does to the bodies of an assembly.

use super::Unassembled;
use super::load::Imposed;
use crate::assembly::case::AssemblyCase;
use crate::assembly::case::contact::{TrackMotion, TrackSettings};
use crate::assembly::case::rotation::BodyRotation;
use crate::assembly::case::structure::AssemblyStructure;
use crate::structure::build::Structure;
use crate::structure::case::damping::Damping;
use judder_assembly::contact_point::ContactPoint;
use judder_structure::assembly::Sparse;
use judder_structure::rotation::{RotatingBody, RotatingFrame, crossed_surface};
use judder_study::text::short;

/// What of turning a body has, on its freedoms.
pub(super) struct Turning {
    pub(super) gyroscopic: Option<Sparse>,
    pub(super) softening: Option<Sparse>,
    /// The stiffness by the centrifugal stress, and the centrifugal force.
    pub(super) centrifugal: Option<(Sparse, Vec<f64>)>,
}

/// Surface that the material may cross before the fixed frame is refused, and before that is told.
const CROSSED: [f64; 2] = [0.05, 1e-3];

impl Turning {
    /// `None` of a body that does not turn.
    pub(super) fn new(
        own: &AssemblyStructure,
        structure: &Structure,
        [stiffness, mass]: [&Sparse; 2],
        imposed: &Imposed,
        warnings: &mut Vec<String>,
    ) -> Result<Option<Self>, Unassembled> {
        let (Some(rotation), Some(elements)) = (&own.rotation, &structure.elements) else { return Ok(None) };
        let path = || format!("structure.{}.rotation", own.name);
        if !imposed.is_empty() {
            let reason = "loads displace supports of this body, which turning does not know of: give forces in place of displacements";
            return Err(Unassembled::because(path(), &reason));
        }
        let motion = rotation.motion();
        if rotation.frame == RotatingFrame::Fixed {
            let crossed = crossed_surface(&elements.mesh, &motion);
            let share = short(100.0 * crossed);
            if crossed > CROSSED[0] {
                let reason = format!(
                    "`{}` is no body of revolution about this axis: as it turns, material crosses {share} % of its surface, so that it has no shape that stands \
                     still; see it from frame = \"rotating\", or give the axis and centre of its own",
                    own.name
                );
                return Err(Unassembled::because(path(), &reason));
            }
            if crossed > CROSSED[1] {
                warnings.push(format!(
                    "`{}` turns and is not quite a body of revolution: material crosses {share} % of its surface, as if that were smooth all around",
                    own.name
                ));
            }
        }
        let made = RotatingBody::new(
            &elements.mesh,
            &elements.materials,
            &elements.numbering,
            [stiffness, mass],
            (&motion, rotation.frame),
        );
        let RotatingBody { gyroscopic, softening, stress_stiffness, load, .. } =
            made.map_err(|error| Unassembled::because(path(), &error))?;
        let BodyRotation { gyroscopic: has_gyroscopic, softening: has_softening, centrifugal, .. } =
            *rotation;
        Ok(Some(Self {
            gyroscopic: has_gyroscopic.then_some(gyroscopic),
            softening: has_softening.then_some(softening),
            centrifugal: centrifugal.then_some((stress_stiffness, load)),
        }))
    }
}

/// What of bodies that turn is left out: by keys, and of tracks that contacts alone know to turn.
pub(super) fn left_out(case: &AssemblyCase) -> Vec<String> {
    let mut all = Vec::new();
    for (index, structure) in case.structures.iter().enumerate() {
        let name = &structure.name;
        match &structure.rotation {
            Some(rotation) => {
                all.extend(rotation.left_out().into_iter().map(|what| format!("{what} of `{name}`")));
                let is_damped = !matches!(structure.damping(), Damping::None);
                if rotation.frame == RotatingFrame::Fixed && is_damped {
                    all.push(format!(
                        "that the damping of `{name}` turns with it: it damps velocities as they are seen from where `{name}` does not turn"
                    ));
                }
            }
            None if is_turning_track(case, index) => {
                all.push(format!(
                    "gyroscopic forces, convective softening, centrifugal force and stiffening of `{name}`, which turns as a track and has no `rotation`"
                ));
            }
            None => {}
        }
    }
    all
}

fn is_turning_track(case: &AssemblyCase, structure: usize) -> bool {
    case.contacts.iter().any(|contact| {
        let is_track =
            matches!(&contact.track, TrackSettings::Surface(track) if *track.surface.structure == structure);
        is_track && matches!(contact.sliding, TrackMotion::Rotation(_))
    })
}

/// How far the sliding of a contact is from the turning of its bodies, where one turns and they differ.
pub(super) fn sliding_warning(
    name: &str,
    [slider, track]: [Option<&BodyRotation>; 2],
    points: &[ContactPoint],
) -> Option<String> {
    /// Differences that are told, over the speed.
    const TOLD: f64 = 1e-2;
    if slider.is_none() && track.is_none() {
        return None;
    }
    let velocity = |rotation: Option<&BodyRotation>, place| {
        rotation.map_or([0.0; 3], |own| own.motion().velocity(place))
    };
    let size = |vector: [f64; 3]| libm::hypot(libm::hypot(vector[0], vector[1]), vector[2]);
    let off = points.iter().map(|point| {
        let (of_track, of_slider) = (velocity(track, point.place), velocity(slider, point.place));
        let off = std::array::from_fn(|k| point.velocity[k] - of_track[k] + of_slider[k]);
        size(off) / size(point.velocity).max(f64::MIN_POSITIVE)
    });
    let off = off.fold(0.0, f64::max);
    (off > TOLD).then(|| {
        format!(
            "`sliding` of `{name}` is not how its bodies turn: at a contact point it differs by {} % from what their `rotation` says",
            short(100.0 * off)
        )
    })
}
