use crate::edge::RunOff;
use judder_contact::friction::FrictionError;
use judder_numerics::words::plain;
use thiserror::Error;

/// Why two structures cannot slide, or a march cannot go on.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum SlidingError {
    /// A number is out of its range.
    #[error("{name} is {value}: it must be {requirement}", value = plain(*.value))]
    InvalidNumber {
        /// Which.
        name: String,
        /// Its value.
        value: f64,
        /// What it must be.
        requirement: &'static str,
    },
    /// A list has another length than what it belongs to.
    #[error("{name} has {found} entries, but must have {expected}")]
    Length {
        /// Which.
        name: String,
        /// What it has.
        found: usize,
        /// What it must have.
        expected: usize,
    },
    /// Numbers that make no friction coefficient.
    #[error(transparent)]
    Friction(#[from] FrictionError),
    /// A track of fewer than two nodes.
    #[error("a track needs two nodes at least, this one has {found}")]
    ShortTrack {
        /// How many it has.
        found: usize,
    },
    /// Nodes of a track that do not follow each other.
    #[error(
        "the track is not ordered: from node {node} to the next it turns back by {angle_deg:.0}° at ({}, {}) m; its nodes must follow each other along the edge",
        plain(*x), plain(*y)
    )]
    Unordered {
        /// The node, from 0.
        node: usize,
        /// By how much it turns there, in degrees.
        angle_deg: f64,
        /// Where it lies, m.
        x: f64,
        /// Where it lies, m.
        y: f64,
    },
    /// A contact point beside the track.
    #[error(
        "the contact point is off the track: {} m from its first node, the track is {} m long",
        plain(*position), plain(*length)
    )]
    OffTrack {
        /// Distance from the first node along the track, m.
        position: f64,
        /// Length of the track, m.
        length: f64,
    },
    /// A contact that is held so near to an end of the track that it swings beyond it.
    #[error(
        "held at {} m the contact has {end}, on a track of {} m: hold it farther from the end; where that does not help, the mode that it \
         starts with hardly presses on the contact, and swings it that far",
        plain(*position), plain(*length)
    )]
    RunsOff {
        /// Distance of the contact point from the first node, m.
        position: f64,
        /// Length of the track, m.
        length: f64,
        /// Beyond which end.
        end: RunOff,
    },
    /// The normal force that closes the contact has no bound: the slider locks.
    #[error(
        "sprag-slip at {} m: c·M⁻¹e is {} 1/kg, friction pushes the slider into the track harder than the contact can push it out; a smaller friction coefficient than {friction:.4} slides",
        plain(*position), plain(*mobility)
    )]
    SpragSlip {
        /// Distance of the contact point from the first node, m.
        position: f64,
        /// c·M⁻¹e, 1/kg.
        mobility: f64,
        /// The friction coefficient.
        friction: f64,
    },
    /// A cut-off below which nothing swings, or above which nothing is left to yield.
    #[error(
        "a cut-off at {} Hz has all modes that swing on one side of it: they go from {} to {} Hz, give a frequency between",
        plain(*cut_off_hz), plain(*lowest_hz), plain(*highest_hz)
    )]
    CutOff {
        /// Hz.
        cut_off_hz: f64,
        /// The lowest frequency of the two bodies that is not zero, Hz.
        lowest_hz: f64,
        /// Their highest, Hz.
        highest_hz: f64,
    },
    /// A contact that would open by c·M⁻¹e, but locks in what yields at once in a march with residual flexibility.
    #[error(
        "at {} m the slider locks in the modes above the cut-off: a unit normal force with its friction opens {} m/N at once, and the modes below would be late; a smaller friction coefficient than {friction:.4} slides, or another cut-off that leaves more modes on either side",
        plain(*position), plain(*compliance)
    )]
    LocksAtOnce {
        /// Distance of the contact point from the first node, m.
        position: f64,
        /// What a unit normal force with its friction opens at once, m/N.
        compliance: f64,
        /// The friction coefficient.
        friction: f64,
    },
    /// There is no state of rest under the load.
    #[error(
        "nothing holds the pair at rest at {} m: {reason}",
        plain(*position)
    )]
    NoEquilibrium {
        /// Distance of the contact point from the first node, m.
        position: f64,
        /// Why not.
        reason: &'static str,
    },
    /// The iteration for the deformed state has not ended.
    #[error(
        "the deformed state at {} m was not found: after {iterations} iterations the contact still moves by {} m",
        plain(*position), plain(*residual)
    )]
    NoConvergence {
        /// Distance of the contact point from the first node, m.
        position: f64,
        /// How many were done.
        iterations: usize,
        /// By how much the contact point moved in the last, m.
        residual: f64,
    },
    /// A step beyond what is stable.
    #[error(
        "the step of {} s is over its limit of {} s: the fastest mode would grow without bound",
        plain(*step), plain(*limit)
    )]
    StepOverLimit {
        /// The step, s.
        step: f64,
        /// Its limit, s.
        limit: f64,
    },
    /// A gap or penetration at the start that nothing closes smoothly.
    #[error(
        "at the start, {} m, C is {} m from the track ({}): closed in one step it would be a kick; give the gap a ramp or put C on the track",
        plain(*position), plain(*gap), if *gap > 0.0 { "a gap" } else { "a penetration" }
    )]
    OpenAtStart {
        /// n·(x_C − P), m.
        gap: f64,
        /// Distance of the contact point from the first node, m.
        position: f64,
    },
    /// A checkpoint of another march.
    #[error("the checkpoint is of another march: it has other modes or observed displacements")]
    ForeignCheckpoint,
    /// A contact that is open and farther from the track than that is long.
    #[error(
        "the slider has lifted off at {} m and flown away: it is {} m from the track, farther than any contact comes back from; a load that presses it on keeps it there",
        plain(*position), plain(*gap)
    )]
    LiftedOff {
        /// Distance of the contact point from the first node without deformation, m.
        position: f64,
        /// n·(x_C − P), m.
        gap: f64,
    },
    /// A march has grown beyond all bounds.
    #[error(
        "the march is not finite any more at step {step}, {} m: a mode has grown without bound",
        plain(*position)
    )]
    NotFinite {
        /// The step.
        step: u64,
        /// Distance of the contact point from the first node, m.
        position: f64,
    },
    /// Eigenvalues that were not found.
    #[error(
        "at {} m {found} of {expected} eigenvalues were found up to {} Hz",
        plain(*position), plain(*limit_hz)
    )]
    Incomplete {
        /// Distance of the contact point from the first node, m.
        position: f64,
        /// How many were found.
        found: usize,
        /// How many there are.
        expected: usize,
        /// Up to which frequency, Hz.
        limit_hz: f64,
    },
    /// Somebody asked for the end.
    #[error("interrupted")]
    Interrupted,
    /// An eigenproblem with full matrices that did not come out.
    #[error("the eigenvalues of the full matrices were not found: {reason}")]
    DenseFailure {
        /// Why not.
        reason: &'static str,
    },
}
