//! `contact-law`: force, area and friction over speed and indentation.

pub(super) mod figure;
mod run;

pub use run::LawPlane;

use super::check::ContactEstimate;
use super::memory::{contact_bytes, memory_of_contacts};
use super::size::lattice_of_law;
use super::{ContactSubject, Exciting, blame, usual_contacts};
use crate::computed_law::KnownPoints;
use crate::contact::case::ContactCase;
use crate::contact::settings::{ContactScope, LawSettings};
use crate::error::ModelError;
use judder_contact::law::sweep::SolvedLawPoint;
use judder_keys::declared::Settings;
use judder_store::{Declared, Results};
use judder_study::case::analysis::{Kind, Picture};
use judder_study::model::{Analysis, NeededMemory, Refusal, Task};
use judder_study::outcome::Outcome;
use run::ToldLaw;
use serde_json::{Map, Value as Json};
use std::sync::Arc;

/// Bytes of a point of speed and indentation: what the law holds of it, and its arrays, tables and figures. Measured of 1000² and 2000² points: 180 and 170.
const KNOT_BYTES: u128 = 175;

/// The kind.
pub(crate) const KIND: Kind<Option<ContactScope>, Arc<dyn Exciting>> = Kind {
    name: "contact-law",
    doc: "force, area and friction over speed and indentation, as a law for an oscillator",
    declared: LawSettings::declarations,
    read: |scope, section| Ok(Arc::new(LawSettings::of("contact-law", scope.as_ref(), section)?)),
    picture: Some(Picture {
        draw: figure::contact_law,
        caption: "Force, area and friction over speed for several indentations (left; dashed: elastic with $E_{0}$ and with $E_{∞}$) and over speed and \
        indentation (right).",
    }),
};

impl Analysis<ContactCase> for LawSettings {
    /// It announces them itself, level by level.
    fn steps(&self) -> usize {
        0
    }

    fn fits(&self, of: &ContactSubject<'_>) -> Result<Result<(), Refusal>, ModelError> {
        if let Err(refusal) = of.is_not_too_deep(of.scales.length_of_span(&self.indentation))? {
            return Ok(Err(refusal));
        }
        let lattice = lattice_of_law(&of.case.shape, self);
        Ok(blame::large(lattice, contact_bytes(lattice), self.memory))
    }

    fn memory(&self, of: &ContactSubject<'_>) -> Result<NeededMemory, ModelError> {
        let of_contacts = memory_of_contacts(lattice_of_law(&of.case.shape, self));
        let points = [self.velocity.points, self.indentation.points];
        let of_table = points.map(|count| count as u128).iter().product::<u128>().saturating_mul(KNOT_BYTES);
        if of_table <= of_contacts.beside {
            return Ok(NeededMemory { beside: of_contacts.beside.saturating_add(of_table), ..of_contacts });
        }
        Ok(NeededMemory {
            beside: of_contacts.beside.saturating_add(of_table),
            what: format!("a law at {} × {} points", points[0], points[1]).into(),
            keys: &["velocity.points", "indentation.points"],
            advice: "take fewer points",
            ..of_contacts
        })
    }

    fn summary_keys(&self) -> Vec<Declared> {
        ToldLaw::declared()
    }

    fn run(&self, of: &ContactSubject<'_>, task: Task<'_>) -> Result<Outcome, ModelError> {
        let known: Vec<SolvedLawPoint> = task.own.known();
        let keep = |point: &SolvedLawPoint| task.own.add(point);
        run::run(of.case, of.name, self, KnownPoints { known: &known, kept: &keep }, task.progress)
    }

    fn estimate(&self, of: &ContactSubject<'_>) -> Result<ContactEstimate, ModelError> {
        let (method, accuracy) = (self.method.name(), self.accuracy);
        let points = [self.velocity.points, self.indentation.points];
        let asked = format!("{method}, {} × {} points, accuracy {accuracy:e}", points[0], points[1]);
        let (contacts, lattice) = (usual_contacts(self.method), lattice_of_law(&of.case.shape, self));
        Ok(ContactEstimate { name: of.name.to_owned(), asked, contacts, lattice })
    }

    fn write(&self, json: &mut Map<String, Json>) {
        self.write_table(json);
    }
}

impl Exciting for LawSettings {
    fn excited(&self, of: &ContactSubject<'_>) -> Result<Vec<f64>, ModelError> {
        let plane = LawPlane::new(self, of.scales);
        let ends = |values: &[f64]| -> Vec<f64> {
            [values.first().copied(), values.last().copied()].into_iter().flatten().collect()
        };
        let depths = ends(&plane.indentations);
        let along = |v: f64| depths.iter().map(move |y| v / y.sqrt());
        Ok(ends(&plane.velocities).into_iter().flat_map(along).collect())
    }
}
