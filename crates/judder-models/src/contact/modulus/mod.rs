//! `modulus`: storage and loss modulus and loss tangent.

mod figure;
mod run;

use super::check::ContactEstimate;
use super::{ContactSubject, Exciting};
use crate::contact::case::ContactCase;
use crate::contact::settings::{ContactScope, ModulusSettings};
use crate::error::ModelError;
use judder_keys::declared::Settings;
use judder_store::{Declared, Results};
use judder_study::case::analysis::{Kind, Picture};
use judder_study::model::{Analysis, Task};
use judder_study::outcome::Outcome;
use run::ToldModulus;
use serde_json::{Map, Value as Json};
use std::sync::Arc;

/// The kind.
pub(crate) const KIND: Kind<Option<ContactScope>, Arc<dyn Exciting>> = Kind {
    name: "modulus",
    doc: "storage and loss modulus and loss tangent over frequency",
    declared: ModulusSettings::declarations,
    read: |_, section| Ok(Arc::new(ModulusSettings::read_table(section)?)),
    picture: Some(Picture {
        draw: figure::modulus,
        caption: "Storage and loss modulus and loss tangent over angular frequency.",
    }),
};

impl Analysis<ContactCase> for ModulusSettings {
    fn summary_keys(&self) -> Vec<Declared> {
        ToldModulus::declared()
    }

    fn run(&self, of: &ContactSubject<'_>, _: Task<'_>) -> Result<Outcome, ModelError> {
        run::run(of.case, self.frequency.as_ref())
    }

    fn estimate(&self, of: &ContactSubject<'_>) -> Result<ContactEstimate, ModelError> {
        let (name, asked) = (of.name.to_owned(), "E(ω)".to_owned());
        Ok(ContactEstimate { name, asked, contacts: 0, lattice: [0; 2] })
    }

    fn write(&self, json: &mut Map<String, Json>) {
        self.write_table(json);
    }
}

impl Exciting for ModulusSettings {
    fn excited(&self, _: &ContactSubject<'_>) -> Result<Vec<f64>, ModelError> {
        Ok(Vec::new())
    }
}
