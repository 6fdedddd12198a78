//! From the keys of a sliding case to a slider on its track.
//!
//! - `part`: a structure reduced to the freedoms that contact, load and observed points need.
//! - `nodes`: which nodes and freedoms those are.
//! - `damping`: α and β of a structure.
//! - `edge`: the order of the track's nodes, and on which side of it the slider lies.
//! - `step`: methods and steps of marches.

mod damping;
mod edge;
mod nodes;
mod part;
mod step;

pub(crate) use part::StructurePart;
pub(crate) use step::{MarchStep, step};

use crate::error::ModelError;
use crate::sliding::case::SlidingCase;
use crate::sliding::case::motion::PlaneAxis;
use crate::sliding::case::problem::SlidingProblem;
use crate::sliding::march::settings::MarchAnalysis;
use crate::structure::build::{self, Structure};
use crate::structure::case::StructureCase;
use edge::TrackEdge;
use judder_sliding::SlidingError;
use judder_sliding::body::ModalPoint;
use judder_sliding::edge::{Interpolation, STENCIL};
use judder_sliding::motion::Motion;
use judder_sliding::pair::{Observed, Pair, PairSide, Slider, TrackBody};
use judder_sliding::plane::PlaneVector;
use judder_study::case::text::CaseText;
use judder_study::{Progress, Silent};
use nodes::SystemNodes;
use std::sync::Arc;

/// The two structures of a case, reduced, and the pair that they make.
pub(crate) struct ReducedPair {
    /// The pair.
    pub(crate) pair: Pair,
    /// What is prescribed along the whole path of the case.
    pub(crate) motion: Motion,
    /// The structures in the order of the case.
    pub(crate) parts: [Arc<StructurePart>; 2],
    /// By how much the slider is moved so that C touches the track where the motion starts, m.
    pub(crate) moved: PlaneVector,
    /// What the user has to know of it.
    pub(crate) warnings: Vec<String>,
}

/// Why a case has no pair, and where in its file.
#[derive(Debug)]
pub(crate) enum Uncoupled {
    /// One of the structures cannot be.
    Structure(build::Unbuilt),
    /// They cannot slide on each other.
    Pair {
        /// The dotted path that is to blame.
        path: String,
        /// What is wrong.
        problem: SlidingProblem,
    },
    /// Nobody wants it any more.
    Interrupted,
}

impl Uncoupled {
    fn new(path: impl Into<String>, problem: SlidingProblem) -> Self {
        Self::Pair { path: path.into(), problem }
    }

    /// With a reason in words, and what would be right.
    fn because(path: impl Into<String>, reason: impl ToString, advice: &'static str) -> Self {
        Self::new(path, SlidingProblem::Unbuilt { reason: reason.to_string(), advice })
    }

    /// As an error at its place in the case file.
    pub(crate) fn placed(self, file: &CaseText) -> ModelError {
        match self {
            Self::Structure(unbuilt) => unbuilt.placed(file),
            Self::Pair { path, problem } => file.error(&path, problem).into(),
            Self::Interrupted => ModelError::Interrupted,
        }
    }
}

impl From<build::Unbuilt> for Uncoupled {
    fn from(unbuilt: build::Unbuilt) -> Self {
        Self::Structure(unbuilt)
    }
}

impl From<Uncoupled> for ModelError {
    fn from(uncoupled: Uncoupled) -> Self {
        match uncoupled {
            Uncoupled::Structure(unbuilt) => unbuilt.into(),
            Uncoupled::Pair { problem, .. } => Self::Unsupported(problem.to_string()),
            Uncoupled::Interrupted => Self::Interrupted,
        }
    }
}

impl ReducedPair {
    /// Reads, assembles, reduces and couples what a case describes.
    pub(crate) fn new(case: &SlidingCase) -> Result<Self, Uncoupled> {
        Self::until(case, &Silent)
    }

    /// The same, unless the one who asked has gone: each structure is read, then each reduced, in one go.
    pub(crate) fn until(case: &SlidingCase, progress: &dyn Progress) -> Result<Self, Uncoupled> {
        Self::with(case, [None, None], progress)
    }

    /// The system of a case that differs from this one's by the values of these swept keys alone: structures that they do not concern are
    /// not made again.
    pub(crate) fn swept(&self, case: &SlidingCase, keys: &[&str]) -> Result<Self, Uncoupled> {
        let known = |index: usize| {
            let (own, numbered) =
                (format!("structure.{}.", case.structures[index].name), format!("structure.{index}."));
            let concerns = |key: &&str| {
                key.starts_with(&own) || key.starts_with(&numbered) || key.starts_with("parameters.")
            };
            (!keys.iter().any(concerns)).then(|| Arc::clone(&self.parts[index]))
        };
        Self::with(case, [known(0), known(1)], &Silent)
    }

    fn with(
        case: &SlidingCase,
        known: [Option<Arc<StructurePart>>; 2],
        progress: &dyn Progress,
    ) -> Result<Self, Uncoupled> {
        let go_on = || progress.go_on().map_err(|_| Uncoupled::Interrupted);
        let structure = |index: usize| match &known[index] {
            Some(part) => Ok(Arc::clone(&part.structure)),
            None => go_on().and_then(|()| built(case, index)).map(Arc::new),
        };
        let structures = [structure(0)?, structure(1)?];
        let nodes = SystemNodes::new(case, [&structures[0], &structures[1]])?;
        let [slider, track] = [*case.contact.slider.structure, *case.contact.track.structure];
        let edge = TrackEdge::new([&structures[slider], &structures[track]], &nodes)?;
        let part = |index: usize| -> Result<Arc<StructurePart>, Uncoupled> {
            match &known[index] {
                // the inertia load goes with the direction of the track
                Some(part) if index == track || part.direction == Some(edge.direction) => {
                    Ok(Arc::clone(part))
                }
                _ => {
                    go_on()?;
                    let direction = (index == slider).then_some(edge.direction);
                    StructurePart::new(case, index, &structures[index], &nodes.freedoms[index], direction)
                        .map(Arc::new)
                }
            }
        };
        let parts = [part(0)?, part(1)?];
        let pair = coupled(case, [&parts[slider], &parts[track]], &nodes, &edge)?;
        let motion = motion(case);
        on_track(&pair, &motion)?;
        let c = parts[slider].place(nodes.contact);
        let start = pair.rigid_place(motion.start);
        let mut warnings = edge.warnings;
        for (part, own) in parts.iter().zip(&case.structures[..]) {
            warnings.extend(part.warnings().map(|warning| format!("`{}`: {warning}", own.name)));
        }
        Ok(Self { pair, motion, parts, moved: [start[0] - c[0], start[1] - c[1]], warnings })
    }

    /// That the case's speed lies beyond its table of friction.
    pub(crate) fn beyond_friction(&self) -> Option<String> {
        beyond_friction(&self.pair, &self.motion)
    }

    /// What a march prescribes.
    pub(crate) fn along(&self, march: &MarchAnalysis) -> Motion {
        Motion { start: march.from, end: march.to, ..self.motion }
    }

    /// The place among the pair's observed displacements of that of a point of the case along an axis.
    pub(crate) fn observed(point: usize, axis: PlaneAxis) -> usize {
        2 * point + axis as usize
    }
}

/// One of the structures as a case of its own, without a reduction.
pub(crate) fn alone(case: &SlidingCase, index: usize) -> StructureCase {
    let own = &case.structures[index];
    StructureCase::alone(&case.title, &case.parameters, &own.source, own.damping())
}

fn built(case: &SlidingCase, index: usize) -> Result<Structure, Uncoupled> {
    let name = &case.structures[index].name;
    Structure::new(&alone(case, index)).map_err(|unbuilt| unbuilt.of_structure(name).into())
}

/// The pair of two reduced structures.
fn coupled(
    case: &SlidingCase,
    [slider, track]: [&StructurePart; 2],
    nodes: &SystemNodes,
    edge: &TrackEdge,
) -> Result<Pair, Uncoupled> {
    let point = |part: &StructurePart, point: usize| -> Result<ModalPoint, Uncoupled> {
        Ok(ModalPoint { place: part.place(point), rows: part.rows(point)? })
    };
    let mut observed = Vec::new();
    for (number, (own, at)) in case.points.iter().zip(&nodes.observed).enumerate() {
        let is_slider = own.structure == case.contact.slider.structure;
        let (side, part) = if is_slider { (PairSide::Slider, slider) } else { (PairSide::Track, track) };
        for (axis, row) in [PlaneAxis::X, PlaneAxis::Y].into_iter().zip(part.rows(*at)?) {
            debug_assert_eq!(observed.len(), ReducedPair::observed(number, axis));
            let rigid = if is_slider { edge.direction[axis as usize] } else { 0.0 };
            observed.push(Observed { side, row, rigid });
        }
    }
    let slider = Slider {
        body: slider.reduced.body.clone(),
        contact: point(slider, nodes.contact)?,
        load: slider.row(nodes.load)?,
        inertia: slider.reduced.inertia(),
    };
    let points = edge.points.iter().map(|at| point(track, *at)).collect::<Result<_, _>>()?;
    let track = TrackBody { body: track.reduced.body.clone(), nodes: points };
    let interpolation = case.contact.interpolation;
    if interpolation == Interpolation::Hermite && edge.points.len() < STENCIL {
        let nodes = edge.points.len();
        let reason =
            format!("`hermite` interpolation takes {STENCIL} nodes of the track, this one has {nodes}");
        return Err(Uncoupled::because("contact.interpolation", reason, SMOOTH));
    }
    let friction = case.contact.friction.friction().map_err(|error| {
        let advice = "give friction coefficients of zero or more";
        Uncoupled::because("contact.friction_coefficient", error, advice)
    })?;
    Pair::new(slider, track, interpolation, edge.is_left, friction, observed)
        .map_err(|error| refused(case, &error))
}

/// What is right of an interpolation.
const SMOOTH: &str = "give the track more nodes, or leave contact.interpolation out for the linear one";
/// What is right of a pair.
const PAIR: &str = "let C be a free node of the slider, and the track an edge of the other structure whose nodes follow each other";

fn refused(case: &SlidingCase, error: &SlidingError) -> Uncoupled {
    match error {
        SlidingError::ShortTrack { .. } | SlidingError::Unordered { .. } => {
            let name = nodes::name(&case.contact.track.nodes);
            Uncoupled::new(
                "contact.track",
                SlidingProblem::Track { name, reason: format!("is no edge: {error}") },
            )
        }
        _ => Uncoupled::because("contact", error, PAIR),
    }
}

/// Refuses a path that leaves the track.
fn on_track(pair: &Pair, motion: &Motion) -> Result<(), Uncoupled> {
    for (key, position) in [("motion.start", motion.start), ("motion.end", motion.end)] {
        if let Err(SlidingError::OffTrack { position, length }) = pair.edge_point(position) {
            let problem = SlidingProblem::OffTrack { key: key.to_owned(), position, length };
            return Err(Uncoupled::new(key, problem));
        }
    }
    Ok(())
}

/// That a speed of sliding lies beyond the table of friction.
pub(crate) fn beyond_friction(pair: &Pair, motion: &Motion) -> Option<String> {
    pair.friction().beyond(motion.velocity.abs()).map(|beyond| beyond.text("m/s"))
}

/// What a case prescribes.
fn motion(case: &SlidingCase) -> Motion {
    let own = &case.motion;
    Motion {
        start: own.start,
        end: own.end,
        velocity: own.velocity,
        load: own.load.force,
        initial_gap: case.contact.initial_gap,
        ramps: own.ramps,
        initial_damping: own.initial_damping,
        noise: own.noise,
    }
}
