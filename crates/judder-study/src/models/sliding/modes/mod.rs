//! `modes`: undamped modes of one of the structures, as it is held, without contact.

use super::system::alone;
use super::{Subject, cost};
use crate::error::StudyError;
use crate::model::{Analysis, Task};
use crate::models::sliding::case::SlidingCase;
use crate::models::sliding::case::analysis::PartModes;
use crate::models::structure::modes;
use crate::outcome::Outcome;
use crate::resolve::{Estimate, cost::FIGURE};

impl Analysis<SlidingCase> for PartModes {
    fn run(&self, of: &Subject<'_>, task: Task<'_>) -> Result<Outcome, StudyError> {
        let part = &of.system.parts[*self.structure];
        let own = (&alone(of.case, *self.structure), &*part.structure);
        let reduced = Some(&part.reduced.body.eigenvalues[..]);
        let outcome = modes::run(own, of.name, self.modes, reduced)?;
        task.progress.advance();
        Ok(outcome)
    }

    fn estimate(&self, of: &Subject<'_>) -> Result<Estimate, StudyError> {
        let seconds = cost::FREEDOM * cost::freedoms(of.system, *self.structure) + FIGURE;
        Ok(Estimate { name: of.name.to_owned(), points: 1, seconds, bytes: 0 })
    }
}
