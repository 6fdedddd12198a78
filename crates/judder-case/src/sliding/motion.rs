//! `[motion]`: where the slider goes, how fast, under which load, and how all of it begins.

use super::contact::check_one_node;
use super::problem::SlidingProblem;
use super::structure::SlidingStructure;
use crate::error::Fault;
use crate::section::Section;
use crate::sliding_keys::SlidingKey;
use crate::structure::lists::number;
use crate::structure::reduction::{KeptNodes, read_nodes};

/// The motion of a sliding case.
#[derive(Debug, Clone, PartialEq)]
pub struct SlidingMotion {
    /// s_0, m: rigid distance of C from the first node of the track at the start.
    pub start: f64,
    /// s_1, m: at the end; another one.
    pub end: f64,
    /// v_x, m/s, along the track: it has the sign of s_1 − s_0.
    pub velocity: f64,
    /// What presses the slider on the track.
    pub load: Load,
    /// Over which times velocity, load and friction rise, and an initial gap closes.
    pub ramps: Ramps,
    /// Damping of both structures at the start; `None` where they have their own from the start on.
    pub initial_damping: Option<InitialDamping>,
    /// A random force on C.
    pub noise: Noise,
}

/// A force on the slider.
#[derive(Debug, Clone, PartialEq)]
pub struct Load {
    /// The slider's nodes that it acts on; several must move as one.
    pub nodes: KeptNodes,
    /// Along x or y.
    pub direction: Axis,
    /// F_y, N.
    pub force: f64,
}

/// A direction of the plane.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum Axis {
    X,
    Y,
}

impl Axis {
    /// The directions with their names in a case file.
    pub const ALL: [(&'static str, Self); 2] = [("x", Self::X), ("y", Self::Y)];

    /// The name in a case file.
    pub fn name(self) -> &'static str {
        Self::ALL[self as usize].0
    }
}

/// Times over which something rises from zero, as half a cosine, s; 0 is at once.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ramps {
    /// Of the velocity.
    pub velocity: f64,
    /// Of the load.
    pub load: f64,
    /// Of the friction coefficient.
    pub friction: f64,
    /// In which the initial gap closes.
    pub gap: f64,
}

/// Damping C = α_0 M + β_0 K of both structures at the start, which gives way to their own.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InitialDamping {
    /// α_0, 1/s.
    pub alpha: f64,
    /// β_0, s.
    pub beta: f64,
    /// For how long it holds, s.
    pub hold: f64,
    /// Over which time it gives way, s.
    pub release: f64,
}

/// A random force on C across the track.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Noise {
    /// Its root mean square, N; 0 is none.
    pub force: f64,
    /// Which one.
    pub seed: u64,
}

impl SlidingMotion {
    /// When all ramps are over and the initial damping has given way, s.
    pub fn settled(&self) -> f64 {
        let Ramps { velocity, load, friction, gap } = self.ramps;
        let damping = self.initial_damping.map_or(0.0, |initial| initial.hold + initial.release);
        [velocity, load, friction, gap, damping].into_iter().fold(0.0, f64::max)
    }
}

/// The keys of `[motion]`.
const KEYS: [&str; 7] = ["start", "end", "velocity", "load", "ramps", "initial_damping", "noise"];

/// Reads `[motion]` of a slider that is the structure at `slider`.
pub(super) fn read_motion(
    root: &Section<'_>,
    structures: &[SlidingStructure; 2],
    slider: usize,
) -> Result<SlidingMotion, Fault> {
    let node = root.required("motion", "[motion] with load = { set = \"start\" }")?;
    let section = root.table("motion", node, &KEYS)?;
    let value = |key: SlidingKey| number(&section, key.entry());
    let [start, end, velocity] =
        [value(SlidingKey::Start)?, value(SlidingKey::End)?, value(SlidingKey::Velocity)?];
    let place = ["velocity", "end", "start"].iter().find_map(|key| section.get(key));
    check_course([start, end], velocity)
        .map_err(|problem| problem.at(place.map_or(section.place, |node| node.place)))?;
    Ok(SlidingMotion {
        start,
        end,
        velocity,
        load: read_load(&section, structures, slider)?,
        ramps: read_ramps(&section)?,
        initial_damping: read_initial_damping(&section)?,
        noise: read_noise(&section)?,
    })
}

/// Refuses a velocity that is zero or leads the other way.
pub(super) fn check_course([start, end]: [f64; 2], velocity: f64) -> Result<(), SlidingProblem> {
    if (end > start && velocity > 0.0) || (end < start && velocity < 0.0) {
        return Ok(());
    }
    Err(SlidingProblem::NoCourse { start, end, velocity })
}

fn read_load(
    section: &Section<'_>,
    structures: &[SlidingStructure; 2],
    slider: usize,
) -> Result<Load, Fault> {
    let example = "load = { set = \"start\", direction = \"y\", force = \"-0.2 N\" }";
    let node = section.required("load", example)?;
    let table = section.table("load", node, &["set", "nodes", "direction", "force"])?;
    let nodes = read_nodes(&table, &structures[slider].source)?;
    // the freedom of a tied set is one; of numbers nothing says that they are tied
    check_one_node(section, "load", node, &nodes)?;
    let direction = table.choice("direction", "direction", &Axis::ALL)?.unwrap_or(Axis::Y);
    Ok(Load { nodes, direction, force: number(&table, SlidingKey::LoadForce.entry())? })
}

fn read_ramps(section: &Section<'_>) -> Result<Ramps, Fault> {
    let table = section
        .get("ramps")
        .map(|node| section.table("ramps", node, &["velocity", "load", "friction", "gap"]));
    let table = table.transpose()?;
    let time = |key: SlidingKey| optional(table.as_ref(), key);
    Ok(Ramps {
        velocity: time(SlidingKey::VelocityRamp)?,
        load: time(SlidingKey::LoadRamp)?,
        friction: time(SlidingKey::FrictionRamp)?,
        gap: time(SlidingKey::GapRamp)?,
    })
}

/// A number of a table that may be left out altogether.
fn optional(table: Option<&Section<'_>>, key: SlidingKey) -> Result<f64, Fault> {
    match table {
        Some(table) => number(table, key.entry()),
        None => Ok(key.entry().default.map_or(0.0, |(_, value)| value.number)),
    }
}

fn read_initial_damping(section: &Section<'_>) -> Result<Option<InitialDamping>, Fault> {
    let Some(node) = section.get("initial_damping") else { return Ok(None) };
    let table = section.table("initial_damping", node, &["alpha", "beta", "hold", "release"])?;
    let value = |key: SlidingKey| number(&table, key.entry());
    Ok(Some(InitialDamping {
        alpha: value(SlidingKey::InitialMassProportional)?,
        beta: value(SlidingKey::InitialStiffnessProportional)?,
        hold: value(SlidingKey::InitialHold)?,
        release: value(SlidingKey::InitialRelease)?,
    }))
}

/// The seed where the case does not say.
pub const SEED: usize = 1;

fn read_noise(section: &Section<'_>) -> Result<Noise, Fault> {
    let table =
        section.get("noise").map(|node| section.table("noise", node, &["force", "seed"])).transpose()?;
    let force = optional(table.as_ref(), SlidingKey::NoiseForce)?;
    let seed = match &table {
        Some(table) => table.whole("seed", 0, usize::MAX >> 1)?.unwrap_or(SEED),
        None => SEED,
    };
    Ok(Noise { force, seed: seed as u64 })
}
