//! What models find wrong.

use judder_assembly::AssemblyError;
use judder_contact::LawError;
use judder_contact::cylinder_on_layer::CylinderError;
use judder_contact::indenter::IndenterError;
use judder_contact::material::MaterialError;
use judder_contact::periodic_contact::PeriodicContactError;
use judder_contact::steady::SteadyError;
use judder_contact::transient::TransientError;
use judder_exchange::ExchangeError;
use judder_keys::cause::Cause;
use judder_keys::error::CaseError;
use judder_nonsmooth::NonsmoothError;
use judder_numerics::piecewise::MarchError;
use judder_numerics::signal::SignalError;
use judder_oscillator::OscillatorError;
use judder_oscillator::cycle::CycleError;
use judder_oscillator::motion::history::LostMotion;
use judder_sliding::SlidingError;
use judder_store::StoreError;
use judder_structure::StructureError;
use judder_study::{ModelFault, StudyError};
use std::any::Any;
use thiserror::Error;

/// Why an analysis has no result.
#[derive(Debug, Error)]
pub enum ModelError {
    /// What the engine of studies finds wrong.
    #[error(transparent)]
    Study(StudyError),
    /// The operating point has no answer.
    #[error("the operating point has no answer: {0}")]
    Oscillator(#[from] OscillatorError),
    /// There is no result, beyond what the law is known for.
    #[error("{cause}; {doubt}")]
    Doubted {
        /// Why there is none.
        cause: Box<ModelError>,
        /// What the law is not known for.
        doubt: String,
    },
    /// The command is for oscillator cases.
    #[error("`judder {command}` takes an oscillator case; this one is of model `{model}`")]
    WrongModel {
        /// The command.
        command: &'static str,
        /// The model of the case.
        model: &'static str,
    },
    /// Two structures cannot slide on each other, or their eigenvalues were not found.
    #[error(transparent)]
    Sliding(#[from] SlidingError),
    /// An assembly does not slide steadily, or its stability is not known.
    #[error(transparent)]
    Assembly(#[from] AssemblyError),
    /// An assembly does not march.
    #[error(transparent)]
    Nonsmooth(NonsmoothError),
    /// A signal of a march cannot be treated.
    #[error("the signal: {0}")]
    Signal(#[from] SignalError),
    /// A sound could not be made.
    #[error("the sound: {source}")]
    Sound {
        /// Why.
        source: ExchangeError,
    },
    /// The state from which an interrupted march would go on cannot be used.
    #[error("the state of the interrupted march cannot be read ({source}); run again with --fresh")]
    Checkpoint {
        /// Why.
        source: serde_json::Error,
    },
    /// An analysis takes the result of another, which is not there.
    #[error(
        "`{by}` takes the result of `{analysis}`, which is not there: run `{analysis}` first, or all analyses in one run"
    )]
    NotDone {
        /// The analysis without a result.
        analysis: String,
        /// Which takes it.
        by: String,
    },
    /// No mode swings near a frequency.
    #[error("no mode of the coupled pair swings near {asked_hz:.1} Hz at {position} m: {known}")]
    NoMode {
        /// The frequency that was asked for, Hz.
        asked_hz: f64,
        /// Distance of the contact point from the first node, m.
        position: f64,
        /// What modes there are.
        known: String,
    },
    /// A march has not kept a signal.
    #[error(
        "the march `{march}` keeps accelerations, contact forces and the sliding velocity, but not `{signal}`: give it signal = \"{signal}\""
    )]
    NotRecorded {
        /// The march.
        march: String,
        /// What it has not kept.
        signal: String,
    },
    /// The substrate cannot be.
    #[error("the substrate: {0}")]
    Material(#[from] MaterialError),
    /// The indenter cannot be.
    #[error("the indenter: {0}")]
    Indenter(#[from] IndenterError),
    /// A surface that repeats itself has no contact.
    #[error("the contact has no answer: {0}")]
    Periodic(#[from] PeriodicContactError),
    /// The law cannot be computed or read.
    #[error("the contact law: {0}")]
    Law(LawError),
    /// The contact cannot be followed in time.
    #[error("the transient contact: {0}")]
    Transient(#[from] TransientError),
    /// The contact has no answer.
    #[error("the contact has no answer: {0}")]
    Contact(#[from] SteadyError),
    /// The elastic contact of a cylinder with its layer cannot be.
    #[error(transparent)]
    Cylinder(#[from] CylinderError),
    /// A motion cannot be followed to its end.
    #[error("the motion cannot be followed: {0}")]
    Motion(LostMotion),
    /// There is no cycle.
    #[error("no limit cycle: {0}")]
    Cycle(CycleError),
    /// An assembly has no cycle that could be computed.
    #[error("no limit cycle: {0}")]
    AssemblyCycle(judder_cycles::CyclesError),
    /// An assembly has no response to what swings.
    #[error("no response: {0}")]
    Response(Box<judder_cycles::CyclesError>),
    /// No other engine stays on the cycle.
    #[error(
        "the cycle of period {period:.4} is unstable, with a Floquet multiplier of magnitude {multiplier:.3}: the other engines would leave it"
    )]
    UnstableCycle {
        /// Its period, ω_nx t.
        period: f64,
        /// The magnitude of the largest multiplier beside the trivial one.
        multiplier: f64,
    },
    /// The structure has no answer.
    #[error("the structure: {0}")]
    Structure(#[from] StructureError),
    /// The fields of shapes could not be written.
    #[error("the fields for ParaView: {0}")]
    Fields(String),
    /// What a key of the case says cannot be.
    #[error(transparent)]
    Key(#[from] Cause),
    /// The contact computation does not know the shape, or what presses it down.
    #[error("{0}")]
    Unsupported(String),
    /// Stopped by the user; what was done is kept.
    #[error("interrupted; what was done is kept, and the same command goes on from there")]
    Interrupted,
}

impl ModelError {
    /// What a model found wrong, behind the error of a study; `None` where the study itself found it.
    #[must_use]
    pub fn of(error: &StudyError) -> Option<&Self> {
        match error {
            StudyError::Model(fault) => (fault.as_ref() as &dyn Any).downcast_ref(),
            _ => None,
        }
    }
}

impl From<StudyError> for ModelError {
    fn from(error: StudyError) -> Self {
        match error {
            StudyError::Interrupted => Self::Interrupted,
            error => Self::Study(error),
        }
    }
}

impl From<ModelError> for StudyError {
    fn from(error: ModelError) -> Self {
        match error {
            ModelError::Study(error) => error,
            ModelError::Interrupted => Self::Interrupted,
            error => Self::Model(Box::new(error)),
        }
    }
}

impl From<CaseError> for ModelError {
    fn from(error: CaseError) -> Self {
        Self::Study(error.into())
    }
}

impl From<StoreError> for ModelError {
    fn from(error: StoreError) -> Self {
        Self::Study(error.into())
    }
}

impl From<LostMotion> for ModelError {
    fn from(lost: LostMotion) -> Self {
        match lost.source {
            MarchError::Interrupted { .. } => Self::Interrupted,
            _ => Self::Motion(lost),
        }
    }
}

impl From<NonsmoothError> for ModelError {
    fn from(error: NonsmoothError) -> Self {
        match error {
            NonsmoothError::Assembly(error) => Self::Assembly(error),
            NonsmoothError::Structure(error) => Self::Structure(error),
            _ => Self::Nonsmooth(error),
        }
    }
}

impl From<judder_cycles::CyclesError> for ModelError {
    fn from(error: judder_cycles::CyclesError) -> Self {
        match error {
            judder_cycles::CyclesError::Assembly(error) => Self::Assembly(error),
            judder_cycles::CyclesError::Nonsmooth(error) => error.into(),
            judder_cycles::CyclesError::Stopped => Self::Interrupted,
            _ => Self::AssemblyCycle(error),
        }
    }
}

/// Whether no periodic motion of a case is computed because of what it says.
fn is_of_the_case(error: &judder_cycles::CyclesError) -> bool {
    matches!(
        error,
        judder_cycles::CyclesError::NotHeld
            | judder_cycles::CyclesError::TooManyFreedoms { .. }
            | judder_cycles::CyclesError::NothingTouches
    )
}

impl From<CycleError> for ModelError {
    fn from(error: CycleError) -> Self {
        match error {
            CycleError::Motion(MarchError::Interrupted { .. }) => Self::Interrupted,
            _ => Self::Cycle(error),
        }
    }
}

impl ModelFault for ModelError {
    /// Whether the input is to blame: what the case, its files or the arguments say cannot be. Otherwise a result that could be
    /// is missing.
    fn is_wrong_input(&self) -> bool {
        match self {
            Self::WrongModel { .. }
            | Self::Material(_)
            | Self::Indenter(_)
            | Self::Cylinder(_)
            | Self::Key(_)
            | Self::Unsupported(_)
            | Self::Signal(_)
            | Self::NotRecorded { .. }
            | Self::NoMode { .. }
            | Self::Periodic(_) => true,
            Self::Study(error) => error.is_wrong_input(),
            Self::Doubted { cause, .. } => cause.is_wrong_input(),
            // a square that was chosen, not given
            Self::Contact(error) => {
                !matches!(error, SteadyError::DomainTooSmall { .. } | SteadyError::NoCells)
            }
            Self::Sliding(error) => !matches!(
                error,
                SlidingError::Incomplete { .. }
                    | SlidingError::DenseFailure { .. }
                    | SlidingError::NoConvergence { .. }
                    | SlidingError::NotFinite { .. }
                    | SlidingError::ForeignCheckpoint
                    | SlidingError::Interrupted
            ),
            Self::Assembly(error) => !matches!(
                error,
                AssemblyError::NoConvergence { .. }
                    | AssemblyError::NoSteadySliding { .. }
                    | AssemblyError::NoEigenvalues { .. }
                    | AssemblyError::Structure(_)
            ),
            Self::Nonsmooth(error) => !matches!(error, NonsmoothError::NotFinite { .. }),
            Self::AssemblyCycle(error) => is_of_the_case(error),
            Self::Response(error) => is_of_the_case(error),
            // a window that was chosen, not given
            Self::Transient(error) => !matches!(error, TransientError::WindowTooSmall { .. }),
            Self::Structure(error) => !matches!(
                error,
                StructureError::MissingModes { .. }
                    | StructureError::OutOfMemory { .. }
                    | StructureError::BeyondMemory { .. }
                    | StructureError::NoModalForm
                    | StructureError::SingularEverywhere { .. }
                    | StructureError::NoDenseEigenvalues { .. }
            ),
            Self::Law(error) => !matches!(error, LawError::FailedPoints { .. }),
            Self::Oscillator(_)
            | Self::Motion(_)
            | Self::Cycle(_)
            | Self::UnstableCycle { .. }
            | Self::Fields(_)
            | Self::Sound { .. }
            | Self::Checkpoint { .. }
            | Self::NotDone { .. }
            | Self::Interrupted => false,
        }
    }
}
