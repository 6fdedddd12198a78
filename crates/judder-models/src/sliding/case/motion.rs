//! `[motion]`: where the slider goes, how fast, under which load, and how all of it begins.

use super::contact::check_one_node;
use super::problem::SlidingProblem;
use super::structure::SlidingStructure;
use crate::structure::case::reduction::KeptNodes;
use judder_keys::declared::Number;
use judder_keys::dimension::Dimension;
use judder_keys::error::Fault;
use judder_keys::problem::Placed;
use judder_keys::section::Section;
use judder_keys::{Choice, Settings};
use judder_sliding::motion::{InitialDamping, Noise, Ramps};

/// Path, velocity and load of the slider.
#[derive(Debug, Clone, PartialEq, Settings)]
#[settings(check = SliderMotion::leads)]
pub struct SliderMotion {
    /// Rigid distance of C from the first node of the track when the motion starts.
    #[key(rule = POSITION, symbol = "s_0", default = 0.01)]
    pub start: f64,
    /// Where it ends.
    #[key(rule = POSITION, symbol = "s_1", default = 0.0985)]
    pub end: f64,
    /// Velocity of the slider along the track; below zero towards the first node.
    #[key(rule = Number::any(Dimension::SPEED), symbol = "v_x", default = 0.03)]
    pub velocity: f64,
    /// What presses the slider on the track.
    #[key(example = "{ set = \"start\", direction = \"y\", force = \"-0.2 N\" }")]
    pub load: SliderLoad,
    /// Times of half a cosine from zero; 0 is at once.
    #[key(default)]
    pub ramps: Ramps,
    /// Damping of both structures at the start, which then gives way to their own; left out, they have their own from the start on.
    pub initial_damping: Option<InitialDamping>,
    /// A random force on C.
    #[key(default)]
    pub noise: Noise,
}

/// The force on the slider.
#[derive(Debug, Clone, PartialEq, Settings)]
pub struct SliderLoad {
    /// The slider's nodes that it acts on; several must move as one.
    #[key(flatten)]
    pub nodes: KeptNodes,
    /// Its direction.
    #[key(default = PlaneAxis::Y)]
    pub direction: PlaneAxis,
    /// Force on the slider.
    #[key(rule = Number::any(Dimension::FORCE), symbol = "F_y", default = -0.2)]
    pub force: f64,
}

/// A direction of the plane.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Choice)]
#[choice(what = "direction")]
#[allow(missing_docs)]
pub enum PlaneAxis {
    X,
    Y,
}

const POSITION: Number = Number::non_negative(Dimension::LENGTH);

impl SliderMotion {
    /// When all ramps are over and the initial damping has given way, s.
    pub fn settled(&self) -> f64 {
        let Ramps { velocity, load, friction, gap } = self.ramps;
        let damping = self.initial_damping.map_or(0.0, |initial| initial.hold + initial.release);
        [velocity, load, friction, gap, damping].into_iter().fold(0.0, f64::max)
    }

    fn leads(&mut self, section: &Section<'_>) -> Result<(), Fault> {
        check_course([self.start, self.end], self.velocity)
            .map_err(|problem| problem.at(section.place_of(&["velocity", "end", "start"])))
    }

    /// Refuses a load on nodes that the slider cannot have, and on several that need not move as one.
    pub(super) fn admit(&self, section: &Section<'_>, slider: &SlidingStructure) -> Result<(), Fault> {
        let Some(load) = section.inner("load")? else { return Ok(()) };
        KeptNodes::admit(&load, &slider.source)?;
        // the freedom of a tied set is one; of numbers nothing says that they are tied
        check_one_node(load.own_path(), &self.load.nodes).map_err(|problem| problem.at(load.place))
    }
}

/// Refuses a velocity that is zero or leads the other way.
pub(crate) fn check_course([start, end]: [f64; 2], velocity: f64) -> Result<(), SlidingProblem> {
    if (end > start && velocity > 0.0) || (end < start && velocity < 0.0) {
        return Ok(());
    }
    Err(SlidingProblem::NoCourse { start, end, velocity })
}
