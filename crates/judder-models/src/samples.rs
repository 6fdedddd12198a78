//! The samples of a march on their way into the study: on the disk while it runs, or in memory where there is no study.

use crate::error::ModelError;
use judder_store::{Dataset, StreamSlice, StreamWriter, Variable, VariableValues};
use judder_study::kept::StudyPlace;

/// Where the samples of a march go.
pub(crate) enum Samples<'a> {
    /// Into a study folder, with checkpoints.
    Streamed(StreamWriter<'a>),
    /// Into memory.
    Held(Vec<Variable>),
}

impl<'a> Samples<'a> {
    /// Takes up what an interrupted run has left in the study, or starts anew.
    pub(crate) fn open(place: Option<StudyPlace<'a>>, variables: Vec<Variable>) -> Result<Self, ModelError> {
        Ok(match place {
            Some(StudyPlace { study, analysis, hash, .. }) => {
                Self::Streamed(StreamWriter::open(study, analysis, hash, &variables)?)
            }
            None => Self::Held(variables),
        })
    }

    /// What the last append said, in this run or an earlier one.
    pub(crate) fn checkpoint(&self) -> Option<&[u8]> {
        match self {
            Self::Streamed(stream) => stream.checkpoint(),
            Self::Held(_) => None,
        }
    }

    /// New rows of each array, and from where to go on.
    pub(crate) fn append(&mut self, checkpoint: &[u8], slices: &[StreamSlice<'_>]) -> Result<(), ModelError> {
        match self {
            Self::Streamed(stream) => stream.append(checkpoint, slices)?,
            Self::Held(variables) => {
                for (variable, slice) in variables.iter_mut().zip(slices) {
                    let row: usize = variable.shape.iter().skip(1).product();
                    match (&mut variable.data, slice) {
                        (VariableValues::F64(values), StreamSlice::F64(own)) => values.extend_from_slice(own),
                        (VariableValues::U8(values), StreamSlice::U8(own)) => values.extend_from_slice(own),
                        _ => (),
                    }
                    if let Some(rows) = variable.shape.first_mut() {
                        *rows = variable.data.len() / row;
                    }
                }
            }
        }
        Ok(())
    }

    /// All samples of a variable; none where there is no such variable.
    pub(crate) fn values(&self, name: &str) -> Result<Vec<f64>, ModelError> {
        match self {
            Self::Streamed(stream) => Ok(stream.values(name)?),
            Self::Held(variables) => {
                let found = variables.iter().find(|variable| variable.name == name);
                Ok(match found.map(|variable| &variable.data) {
                    Some(VariableValues::F64(values)) => values.clone(),
                    _ => Vec::new(),
                })
            }
        }
    }

    /// All samples of one column of a variable of several; none where there is no such variable or column.
    pub(crate) fn column(&self, name: &str, column: usize) -> Result<Vec<f64>, ModelError> {
        match self {
            Self::Streamed(stream) => Ok(stream.column(name, column)?),
            Self::Held(variables) => {
                let found = variables.iter().find(|variable| variable.name == name);
                let row = found.map_or(1, |variable| variable.shape.iter().skip(1).product());
                Ok(match found.map(|variable| &variable.data) {
                    Some(VariableValues::F64(values)) if column < row => {
                        values.iter().skip(column).step_by(row).copied().collect()
                    }
                    _ => Vec::new(),
                })
            }
        }
    }

    /// The arrays together with others: stored already, or for the caller to store.
    pub(crate) fn finish(self, rest: Dataset) -> Result<Finished, ModelError> {
        match self {
            Self::Streamed(stream) => {
                stream.finish(rest)?;
                Ok(Finished::Stored)
            }
            Self::Held(variables) => {
                let mut dataset = Dataset::new();
                for variable in variables.into_iter().chain(rest.variables().iter().cloned()) {
                    dataset = dataset.with(variable)?;
                }
                for (name, value) in rest.attributes() {
                    dataset = dataset.attribute(name, value.clone())?;
                }
                Ok(Finished::Whole(Box::new(dataset)))
            }
        }
    }
}

/// The arrays of a march that has ended.
pub(crate) enum Finished {
    /// They are in the study.
    Stored,
    /// They are here.
    Whole(Box<Dataset>),
}
