//! The samples of a march on their way into the study: on the disk while it runs, or in memory where there is no study.

use crate::error::ModelError;
use judder_store::{Dataset, StreamWriter, Variable, VariableValues};
use judder_study::kept::StudyPlace;

/// Where the samples of a march go.
pub(super) enum Samples<'a> {
    /// Into a study folder, with checkpoints.
    Streamed(StreamWriter<'a>),
    /// Into memory.
    Held(Vec<Variable>),
}

impl<'a> Samples<'a> {
    /// Takes up what an interrupted run has left in the study, or starts anew.
    pub(super) fn open(place: Option<StudyPlace<'a>>, variables: Vec<Variable>) -> Result<Self, ModelError> {
        Ok(match place {
            Some(StudyPlace { study, analysis, hash, .. }) => {
                Self::Streamed(StreamWriter::open(study, analysis, hash, &variables)?)
            }
            None => Self::Held(variables),
        })
    }

    /// What the last append said, in this run or an earlier one.
    pub(super) fn checkpoint(&self) -> Option<&[u8]> {
        match self {
            Self::Streamed(stream) => stream.checkpoint(),
            Self::Held(_) => None,
        }
    }

    pub(super) fn append(&mut self, checkpoint: &[u8], columns: &[&[f64]]) -> Result<(), ModelError> {
        match self {
            Self::Streamed(stream) => stream.append(checkpoint, columns)?,
            Self::Held(variables) => {
                for (variable, column) in variables.iter_mut().zip(columns) {
                    variable.shape = vec![variable.shape[0] + column.len()];
                    if let VariableValues::F64(values) = &mut variable.data {
                        values.extend_from_slice(column);
                    }
                }
            }
        }
        Ok(())
    }

    /// All samples of a variable; none where there is no such variable.
    pub(super) fn values(&self, name: &str) -> Result<Vec<f64>, ModelError> {
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

    /// The arrays together with others: stored already, or for the caller to store.
    pub(super) fn finish(self, rest: Dataset) -> Result<Finished, ModelError> {
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
pub(super) enum Finished {
    /// They are in the study.
    Stored,
    /// They are here.
    Whole(Box<Dataset>),
}
