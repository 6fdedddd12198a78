use judder_assembly::AssemblyError;
use judder_numerics::words::plain;
use judder_sliding::SlidingError;
use judder_sliding::edge::RunOff;
use judder_structure::StructureError;
use thiserror::Error;

/// Why an assembly does not march.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum NonsmoothError {
    /// A number is out of its range.
    #[error("{name} is {value}: it must be {requirement}", value = plain(*.value))]
    InvalidNumber {
        /// Which.
        name: &'static str,
        /// Its value.
        value: f64,
        /// What it must be.
        requirement: &'static str,
    },
    /// A step with which the growth of a mode cannot be measured.
    #[error(
        "a step of {} s does not measure how a mode of {frequency:.1} Hz grows: it must lie between {} and {} s",
        plain(*.step), plain(*.least), plain(*.most)
    )]
    StepForMode {
        /// Asked for, in s.
        step: f64,
        /// The shortest, with which a measurement ends, in s.
        least: f64,
        /// The longest, which sees the mode turn, in s.
        most: f64,
        /// The frequency of the mode, in Hz.
        frequency: f64,
    },
    /// A step that lets the fastest mode grow whatever it does.
    #[error(
        "a step of {} s is too long: the fastest mode, with the contact's stiffness, allows {} s; \
         shorten the step, reduce the bodies, or take the implicit method `moreau`",
        plain(*.step), plain(*.limit)
    )]
    StepOverLimit {
        /// Asked for, in s.
        step: f64,
        /// Allowed, in s.
        limit: f64,
    },
    /// A normal law that stiffens without bound, for which no explicit step is short enough.
    #[error(
        "a cubic stiffness of a contact grows without bound, so that no step of an explicit scheme is known to be short enough; take the method `moreau`"
    )]
    UnboundedStiffness,
    /// A freedom without mass, which an explicit step cannot move.
    #[error(
        "the mass matrix is not positive definite: an explicit step needs mass at every freedom; take the method `moreau`"
    )]
    NoMass,
    /// Modes that only yield of bodies that have none apart.
    #[error(
        "a cut-off needs the modes of all bodies together, free of each other: their damping joins these, or there are too many; leave the cut-off out, or reduce the bodies"
    )]
    CutOffNeedsModes,
    /// A contact point that no impulse moves.
    #[error("contact point {point} of interface `{interface}` is held: no force at it moves the bodies")]
    HeldPoint {
        /// The interface.
        interface: String,
        /// The point, counted from 1.
        point: usize,
    },
    /// Normals that turn with the deformed track.
    #[error(
        "interface `{interface}` follows the deformed configuration, which a march does not: its normals stay those of the undeformed bodies"
    )]
    TurningNormal {
        /// The interface.
        interface: String,
    },
    /// Points that travel in space.
    #[error("contact points travel along an edge in the plane: of bodies in space they do not yet")]
    TravelInSpace,
    /// A travelling point whose track's material passes beside it.
    #[error(
        "interface `{interface}` travels along a track whose material passes by turning: give its points one of the two"
    )]
    TravelsOnTurning {
        /// The interface.
        interface: String,
    },
    /// A travelling point at the end of its track.
    #[error("contact point {point} of interface `{interface}` has {end} after {} s", plain(*.time))]
    RunOff {
        /// The interface.
        interface: String,
        /// The point, counted from 1.
        point: usize,
        /// Which end.
        end: RunOff,
        /// When, in s.
        time: f64,
    },
    /// What is wrong with an edge.
    #[error(transparent)]
    Edge(#[from] SlidingError),
    /// A quantity over time that leaves the table of its factors.
    #[error(
        "{name} is {} at {} s, outside of the table of factors, which goes from {} to {} and is not extrapolated",
        plain(*.value), plain(*.time), plain(*.first), plain(*.last)
    )]
    OutsideTable {
        /// Which.
        name: &'static str,
        /// When, in s.
        time: f64,
        /// Its value there.
        value: f64,
        /// Where the table begins.
        first: f64,
        /// Where it ends.
        last: f64,
    },
    /// A signal that swings faster than steps can follow.
    #[error(
        "a signal of up to {} Hz is too fast for steps of {} s, which show no more than {} Hz: shorten the step",
        plain(*.frequency), plain(*.step), plain(0.5 / *.step)
    )]
    SignalTooFast {
        /// Its highest frequency, in Hz.
        frequency: f64,
        /// The step, in s.
        step: f64,
    },
    /// Samples that do not last as long as the motion.
    #[error(
        "the samples of a signal go from {} to {} s, the motion from 0 to {} s: they must cover it",
        plain(*.begins), plain(*.ends), plain(*.duration)
    )]
    SignalEnds {
        /// The first, in s.
        begins: f64,
        /// The last, in s.
        ends: f64,
        /// How long the motion takes, in s.
        duration: f64,
    },
    /// Forces of a signal on another number of freedoms.
    #[error("a signal acts on {found} freedoms, the assembly has {expected}")]
    SignalFreedoms {
        /// Forces that it has.
        found: usize,
        /// Freedoms that there are.
        expected: usize,
    },
    /// A motion that leaves the numbers.
    #[error("the motion is no longer finite after {} s: it grows without bound", plain(*.time))]
    NotFinite {
        /// When, in s.
        time: f64,
    },
    /// A checkpoint of another march.
    #[error("the checkpoint is of another march: it has other coordinates or contact points")]
    ForeignCheckpoint,
    /// What is wrong with the assembly.
    #[error(transparent)]
    Assembly(#[from] AssemblyError),
    /// What is wrong with a matrix.
    #[error(transparent)]
    Structure(#[from] StructureError),
}
