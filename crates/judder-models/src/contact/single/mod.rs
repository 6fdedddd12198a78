//! `contact`: one contact, with its fields.

pub(crate) mod figure;
mod periodic;
mod refined;
pub(crate) mod run;

use super::check::ContactEstimate;
use super::memory::{beyond_process, bytes_with_operator, contact_bytes, memory_of_contact};
use super::size::lattice;
use super::{ContactSubject, Exciting, blame};
use crate::contact::case::ContactCase;
use crate::contact::problem::ContactProblem;
use crate::contact::settings::{ContactScope, ContactSettings};
use crate::contact::shape::ShapeSettings;
use crate::error::ModelError;
use crate::indenter::height_map;
use judder_contact::kernel::check::KernelError;
use judder_contact::kernel::periodic::{PERIODIC_MEMORY, memory_of_a_period};
use judder_contact::steady::{GridChoice, SteadyError};
use judder_contact::unilateral::Loading;
use judder_keys::declared::Settings;
use judder_store::{Declared, Results};
use judder_study::case::analysis::{Kind, Picture};
use judder_study::model::{Analysis, NeededMemory, Refusal, Task};
use judder_study::outcome::Outcome;
use judder_study::text::number;
use periodic::ToldPeriod;
use refined::ToldContact;
use run::{grid, loading};
use serde_json::{Map, Value as Json};
use std::f64::consts::TAU;
use std::sync::Arc;

/// The kind.
pub(crate) const KIND: Kind<Option<ContactScope>, Arc<dyn Exciting>> = Kind {
    name: "contact",
    doc: "one contact: force, area, friction, fields",
    declared: ContactSettings::declarations,
    read: |scope, section| Ok(Arc::new(ContactSettings::of(scope.as_ref(), section)?)),
    picture: Some(Picture {
        draw: figure::contact,
        caption: "The indenter slides to the right. Sections along $y$ = 0; the surface of the substrate is compared with the indenter. The grids: \
        how far force, area and friction of each are from the extrapolated values.",
    }),
};

/// Refuses a load under which the indenter would sink in deeper than it is high.
fn is_not_too_deep(
    settings: &ContactSettings,
    of: &ContactSubject<'_>,
) -> Result<Result<(), Refusal>, ModelError> {
    match loading(&of.case.shape, settings, of.scales) {
        Loading::Indentation(depth) => of.is_not_too_deep(depth),
        Loading::Load(force) => {
            let (profile, contrast) = (of.profile()?, of.scales.material.spectrum.contrast());
            // the glassy substrate yields least
            let (indentation, limit) = (profile.elastic_depth(force / contrast), profile.deepest());
            let is_possible = of.case.shape.is_periodic() || indentation < limit;
            let problem = ContactProblem::LoadTooLarge { indentation, limit };
            Ok(if is_possible { Ok(()) } else { Err(Refusal::keys(&["load"], problem)) })
        }
    }
}

/// Refuses a speed at which the wakes of a surface that repeats itself reach from one period into the next.
fn wakes_end(settings: &ContactSettings, of: &ContactSubject<'_>) -> Result<Result<(), Refusal>, ModelError> {
    if !of.case.shape.is_periodic() {
        return Ok(Ok(()));
    }
    let grid = height_map(&of.case.shape, of.scales.scales.radius)?.grid();
    let substrate = of.scales.material.sliding(of.scales.velocity(settings.velocity));
    let memory = memory_of_a_period(grid.columns as f64 * grid.cell, &substrate);
    let problem = ContactProblem::LongWake { memory, allowed: PERIODIC_MEMORY };
    Ok(if memory > PERIODIC_MEMORY { Err(Refusal::keys(&["velocity"], problem)) } else { Ok(()) })
}

impl Analysis<ContactCase> for ContactSettings {
    fn fits(&self, of: &ContactSubject<'_>) -> Result<Result<(), Refusal>, ModelError> {
        for fits in [is_not_too_deep, wakes_end] {
            if let Err(refusal) = fits(self, of)? {
                return Ok(Err(refusal));
            }
        }
        let chosen = !of.case.shape.is_periodic() && grid(self, of.scales) == GridChoice::Automatic;
        if chosen && of.case.shape != ShapeSettings::Cylinder {
            return Ok(Ok(()));
        }
        let lattice = lattice(of.case, self, of.scales)?;
        Ok(blame::large(lattice, contact_bytes(lattice), self.memory))
    }

    fn memory(&self, of: &ContactSubject<'_>) -> Result<NeededMemory, ModelError> {
        Ok(memory_of_contact(lattice(of.case, self, of.scales)?))
    }

    fn summary_keys(&self) -> Vec<Declared> {
        let mut keys = ToldContact::declared();
        keys.extend(Option::<ToldPeriod>::declared());
        keys
    }

    fn run(&self, of: &ContactSubject<'_>, task: Task<'_>) -> Result<Outcome, ModelError> {
        if of.case.shape.is_periodic() {
            return periodic::run(of.case, of.name, self, task.progress);
        }
        run::run(of.case, of.name, self, task.progress)
    }

    fn blame(&self, error: &ModelError) -> Option<Refusal> {
        match error {
            ModelError::Contact(SteadyError::DomainTooSmall { half_width, needed, .. })
                if self.domain.is_some() =>
            {
                let (side, needed) = (2.0 * half_width, 2.0 * needed);
                Some(Refusal::keys(&["domain"], ContactProblem::DomainTooSmall { side, needed }))
            }
            // of a grid that the case allows
            ModelError::Contact(SteadyError::Kernel(KernelError::Memory {
                columns,
                rows,
                needed,
                allowed,
            })) if bytes_with_operator(*needed) <= self.memory.bytes => {
                let [needed, allowed] = [*needed, *allowed].map(bytes_with_operator);
                beyond_process([*columns, *rows], needed, allowed)
            }
            _ => None,
        }
    }

    fn estimate(&self, of: &ContactSubject<'_>) -> Result<ContactEstimate, ModelError> {
        let velocity = of.scales.velocity(self.velocity);
        let asked = match loading(&of.case.shape, self, of.scales) {
            Loading::Indentation(depth) => format!(
                "v τ/R = {}, δ/R = {}, v τ/√(R δ) = {}",
                number(velocity),
                number(depth),
                number(velocity / depth.sqrt())
            ),
            Loading::Load(force) => {
                let group =
                    if of.case.shape == ShapeSettings::Cylinder { "F/(E0* R)" } else { "F/(E0* R²)" };
                format!("v τ/R = {}, {group} = {}", number(velocity), number(force))
            }
        };
        let lattice = lattice(of.case, self, of.scales)?;
        Ok(ContactEstimate { name: of.name.to_owned(), asked, contacts: 1, lattice })
    }

    fn write(&self, json: &mut Map<String, Json>) {
        self.write_table(json);
    }
}

impl Exciting for ContactSettings {
    fn excited(&self, of: &ContactSubject<'_>) -> Result<Vec<f64>, ModelError> {
        let (velocity, radius) = (of.scales.velocity(self.velocity), of.scales.scales.radius);
        Ok(match &of.case.shape {
            ShapeSettings::Rough(rough) => {
                [rough.roll_off(), rough.cut_off()].map(|wave| TAU * velocity * radius / wave).to_vec()
            }
            shape if shape.is_periodic() => {
                let grid = height_map(shape, radius)?.grid();
                vec![TAU * velocity / (grid.columns as f64 * grid.cell)]
            }
            shape => vec![velocity / of.half_length(loading(shape, self, of.scales))?],
        })
    }
}
