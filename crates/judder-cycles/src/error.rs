use judder_assembly::AssemblyError;
use judder_nonsmooth::NonsmoothError;
use thiserror::Error;

/// Why a limit cycle is not found.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum CyclesError {
    /// Newton's method ends elsewhere than in a solution.
    #[error(
        "the balance of harmonics was not solved: after {iterations} steps of Newton's method {residual:.1e} of the contact forces is left"
    )]
    NotConverged {
        /// Steps taken.
        iterations: usize,
        /// The largest residual, of the force by which it is measured.
        residual: f64,
    },
    /// A march does not come back to where it began.
    #[error(
        "shooting ends without a cycle: after {iterations} steps of Newton's method a period misses {missed:.1e} of its swing"
    )]
    NotReturned {
        /// Steps taken.
        iterations: usize,
        /// What the period misses, of the swing of the state.
        missed: f64,
    },
    /// A march comes to rest beside steady sliding.
    #[error("the march settles to steady sliding")]
    Settles,
    /// A march grows or decays still.
    #[error(
        "at the end of the march the kinetic energy still changes, by {change:.1e} of itself within an eighth of it: give it a longer `duration`"
    )]
    StillChanges {
        /// By how much, of the energy before.
        change: f64,
    },
    /// A march does not come back to where it was.
    #[error(
        "the motion that the march comes to is not periodic: within an eighth of its duration it comes no closer to where it was than {missed:.1e} of its swing"
    )]
    NotPeriodic {
        /// How close it comes, of its swing.
        missed: f64,
    },
    /// A cycle is another than that near which it was sought.
    #[error(
        "the balance of harmonics closes at another motion: it turns with {found:.4e} rad/s, that near which it was sought with {sought:.4e} rad/s"
    )]
    OtherMotion {
        /// ω in rad/s.
        found: f64,
        /// Of what it was sought near.
        sought: f64,
    },
    /// It was stopped from outside.
    #[error("it was stopped")]
    Stopped,
    /// What was found is steady sliding.
    #[error("the balance of harmonics leads back to steady sliding, which solves it too")]
    Shrunk,
    /// A linear system is singular.
    #[error("the equations of the balance of harmonics are singular")]
    Singular,
    /// A static force moves the bodies without end.
    #[error(
        "the bodies are not held: a steady force along the contact moves them without end, so that no mean place of a cycle exists"
    )]
    NotHeld,
    /// More freedoms than harmonic responses are computed of, by modes or by dense systems.
    #[error(
        "bodies with {freedoms} freedoms: periodic motions are computed of up to {most}; reduce the bodies"
    )]
    TooManyFreedoms {
        /// Freedoms.
        freedoms: usize,
        /// The most.
        most: usize,
    },
    /// There is no assembly at a value of a parameter.
    #[error("at {value} there is no assembly: {reason}")]
    NoAssembly {
        /// The value.
        value: f64,
        /// Why.
        reason: String,
    },
    /// Contact points come or go as a parameter changes.
    #[error(
        "the contact has {found} components in place of {expected}: its points come or go with the parameter"
    )]
    OtherPoints {
        /// Components now.
        found: usize,
        /// Before.
        expected: usize,
    },
    /// A motion that is known from elsewhere is one of other contact points.
    #[error(
        "the motion near which a cycle is sought has {found} components of contact forces, the assembly has {expected}: it is one of other contact points"
    )]
    ForeignPoints {
        /// Components of the motion.
        found: usize,
        /// Of the assembly.
        expected: usize,
    },
    /// There are no contact points.
    #[error("nothing touches")]
    NothingTouches,
    /// What is wrong with the contact points of an assembly.
    #[error(transparent)]
    Nonsmooth(#[from] NonsmoothError),
    /// What is wrong with an assembly.
    #[error(transparent)]
    Assembly(#[from] AssemblyError),
}

impl CyclesError {
    /// Whether it says that a motion is another than is sought or was not found, so that others may be.
    #[must_use]
    pub fn is_of_the_motion(&self) -> bool {
        matches!(
            self,
            Self::NotConverged { .. }
                | Self::NotReturned { .. }
                | Self::Settles
                | Self::StillChanges { .. }
                | Self::NotPeriodic { .. }
                | Self::OtherMotion { .. }
                | Self::Shrunk
                | Self::Singular
        )
    }
}
