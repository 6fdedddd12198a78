//! A case of any model.

use super::{Model, Task};
use crate::error::StudyError;
use crate::outcome::Outcome;
use std::any::Any;
use std::ops::Deref;

/// A validated case of one of the models.
#[derive(Debug, Clone)]
pub struct Case(Box<dyn Model>);

impl Case {
    /// This case of a model.
    pub fn new(case: impl Model) -> Self {
        Self(Box::new(case))
    }

    /// The case, where it is of this model.
    pub fn of<M: Model>(&self) -> Option<&M> {
        (self.0.as_ref() as &dyn Any).downcast_ref()
    }

    /// The same, to be changed.
    pub fn of_mut<M: Model>(&mut self) -> Option<&mut M> {
        (self.0.as_mut() as &mut dyn Any).downcast_mut()
    }

    /// Runs an analysis, and names its kind in the arrays that it leaves.
    ///
    /// # Errors
    /// As of [`Model::run`].
    pub fn run(&self, index: usize, task: Task<'_>) -> Result<Outcome, StudyError> {
        let mut outcome = self.0.run(index, task)?;
        outcome.dataset = outcome.dataset.headed("kind", self.kind_name(index))?;
        Ok(outcome)
    }

    /// The name of its model in a case file.
    pub fn model(&self) -> &'static str {
        self.0.name()
    }
}

impl Deref for Case {
    type Target = dyn Model;

    fn deref(&self) -> &dyn Model {
        self.0.as_ref()
    }
}
