//! `modulus`: storage and loss modulus and loss tangent.

mod figure;
mod run;

use super::check::ContactEstimate;
use super::{Exciting, Subject};
use crate::error::StudyError;
use crate::model::{Analysis, Pictured, Task};
use crate::models::contact::case::ContactCase;
use crate::models::contact::settings::ModulusSettings;
use crate::outcome::Outcome;

/// The figure.
pub(crate) const PICTURED: Pictured = Pictured {
    kind: "modulus",
    draw: figure::modulus,
    caption: "Storage and loss modulus and loss tangent over angular frequency.",
};

impl Analysis<ContactCase> for ModulusSettings {
    fn run(&self, of: &Subject<'_>, _: Task<'_>) -> Result<Outcome, StudyError> {
        run::run(of.case, self.frequency.as_ref())
    }

    fn estimate(&self, of: &Subject<'_>) -> Result<ContactEstimate, StudyError> {
        let (name, asked) = (of.name.to_owned(), "E(ω)".to_owned());
        Ok(ContactEstimate { name, asked, contacts: 0, lattice: [0; 2] })
    }
}

impl Exciting for ModulusSettings {
    fn excited(&self, _: &Subject<'_>) -> Result<Vec<f64>, StudyError> {
        Ok(Vec::new())
    }
}
