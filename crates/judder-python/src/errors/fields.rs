//! The named fields of errors, for a caller that acts on them.

use judder_contact::LawError;
use judder_contact::steady::SteadyError;
use judder_examples::ExampleError;
use judder_models::ModelError;
use judder_oscillator::OscillatorError;
use judder_sliding::SlidingError;
use judder_store::StoreError;
use judder_study::StudyError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// An error with named fields.
pub(super) trait ErrorFields {
    /// Puts them into a dictionary.
    fn put(&self, fields: &Bound<'_, PyDict>) -> PyResult<()>;
}

/// The fields of each variant by their names; those of other variants are left to their message.
macro_rules! fields {
    ($error:ident { $($variant:ident { $($field:ident),* }),* $(,)? }) => {
        impl ErrorFields for $error {
            fn put(&self, fields: &Bound<'_, PyDict>) -> PyResult<()> {
                match self {
                    $($error::$variant { $($field,)* .. } => {
                        $(fields.set_item(stringify!($field), $field)?;)*
                        Ok(())
                    })*
                    #[allow(unreachable_patterns, reason = "an enum may have all its variants listed")]
                    _ => Ok(()),
                }
            }
        }
    };
}

fields!(OscillatorError {
    InvalidGroup { name, value, requirement },
    NoEquilibrium { searched_from, searched_to },
    SeveralEquilibria { indentations },
    EquilibriumNotConverged { iterations, indentation, residual },
    NotFinite { matrix, row, column, value },
    InvalidMass { mass },
    Overflow { largest },
});

fields!(SlidingError {
    InvalidNumber { name, value, requirement },
    Length { name, found, expected },
    ShortTrack { found },
    Unordered { node, angle_deg, x, y },
    OffTrack { position, length },
    RunsOff { position, length },
    SpragSlip { position, mobility, friction },
    CutOff { cut_off_hz, lowest_hz, highest_hz },
    LocksAtOnce { position, compliance, friction },
    NoEquilibrium { position, reason },
    NoConvergence { position, iterations, residual },
    StepOverLimit { step, limit },
    OpenAtStart { gap, position },
    LiftedOff { position, gap },
    NotFinite { step, position },
    Incomplete { position, found, expected, limit_hz },
    DenseFailure { reason },
});

fields!(SteadyError {
    Accuracy { accuracy },
    TooFewCells { cells },
    HalfWidth { half_width },
    DomainTooSmall { half_width, centre_x, needed },
    BeyondIndenter { x, y },
    TooDeep { indentation, limit },
});

fields!(LawError {
    TooFewKnots { axis, count, least },
    NotAscending { axis, first, last },
    NotUniform { axis, index, found, expected },
    WrongCount { quantity, found, expected },
    InvalidValue { quantity, column, row, value },
    InvalidNumber { name, value, requirement },
    ComplianceSum { sum, expected },
    WrongFormat { found, expected },
    WrongVersion { found, understood },
    LimitsDisagree { name, found, expected },
    FailedPoints { attempted },
});

fields!(StoreError {
    NotAFolder { path },
    PathNotText { path },
    HoldsStudy { path },
    ForeignFolder { path, holds },
    NoStudy { path },
    Locked { path },
    DiskFull { path, bytes },
    NotWritable { path },
    FolderInPlace { path },
    LinkInPlace { path },
    FileSystem { action, path },
    SummaryUnreadable { path },
    Oversized { path, size, largest },
    NoManifest { path },
    ManifestDamaged { path },
    Damaged { path },
    Unreadable { path, reason },
    NotListed { path, name },
    NoDataset { path },
    DatasetUnreadable { path },
    InvalidName { what, name },
    ForeignSweep { path, expected, found },
    OtherBuild { path, expected, found },
    OtherLayout { path },
    ForeignChunk { path, expected, found },
    DamagedChunk { path },
    MissingChunk { path },
    NoSuchChunk { sweep, chunk, count },
    ChunkSize { sweep, chunk, expected, found },
    FailureOutside { sweep, chunk, index, points },
    SweepTooLarge { sweep },
});

fields!(ExampleError {
    Unknown { name, near },
    Exists { path },
    Write { path },
});

fields!(StudyError {
    UnknownAnalysis { name, known },
    OtherCase { folder, owner },
    HeldTooMuch { name, bytes, limit },
    File { path, reason },
    NoResults { folder },
});

fields!(ModelError {
    WrongModel { command, model },
    NotDone { analysis, by },
    NoMode { asked_hz, position, known },
    NotRecorded { march, signal },
    UnstableCycle { period, multiplier },
});
