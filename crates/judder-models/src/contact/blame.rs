//! Which key of a contact case is to blame, and what would be right.

use crate::contact::memory::bytes_with_operator;
use crate::contact::problem::ContactProblem;
use crate::error::ModelError;
use judder_contact::LawError;
use judder_contact::cylinder_on_layer::CylinderError;
use judder_contact::kernel::check::KernelError;
use judder_contact::periodic_contact::PeriodicContactError;
use judder_contact::steady::SteadyError;
use judder_contact::transient::TransientError;
use judder_keys::memory::Memory;
use judder_study::model::Refusal;

/// Refuses a depth, over R, at which the indenter has ended, or the layer that it presses on.
pub(super) fn deep(indentation: f64, limit: f64, thickness: Option<f64>) -> Result<(), Refusal> {
    let refused = |problem| Err(Refusal::keys(&["indentation"], problem));
    match thickness {
        _ if indentation >= limit => refused(ContactProblem::TooDeep { indentation, limit }),
        Some(thickness) if indentation >= thickness => {
            refused(ContactProblem::ThroughLayer { indentation, thickness })
        }
        _ => Ok(()),
    }
}

/// Refuses a grid that takes more memory than allowed.
pub(super) fn large([columns, rows]: [usize; 2], needed: u64, limit: Memory) -> Result<(), Refusal> {
    if needed <= limit.bytes { Ok(()) } else { Err(beyond(columns, rows, needed, limit.bytes)) }
}

fn beyond(columns: usize, rows: usize, needed: u64, limit: u64) -> Refusal {
    let (needed, limit) = (Memory { bytes: needed }, Memory { bytes: limit });
    Refusal::keys(&["cells", "memory_limit"], ContactProblem::Memory { columns, rows, needed, limit })
}

/// What is to blame whatever the kind of analysis; `None` where no key is.
pub(super) fn blame(error: &ModelError) -> Option<Refusal> {
    match error {
        ModelError::Contact(SteadyError::TooDeep { indentation, limit }) => {
            let (indentation, limit) = (*indentation, *limit);
            Some(Refusal::keys(&["indentation"], ContactProblem::TooDeep { indentation, limit }))
        }
        ModelError::Contact(SteadyError::BeyondIndenter { x, y }) => {
            Some(Refusal::keys(&["indentation", "load"], ContactProblem::BeyondHeights { x: *x, y: *y }))
        }
        ModelError::Cylinder(CylinderError::TooWide { indentation, thickness })
        | ModelError::Law(LawError::Cylinder(CylinderError::TooWide { indentation, thickness })) => {
            let (indentation, thickness) = (*indentation, *thickness);
            Some(Refusal::keys(
                &["indentation", "load"],
                ContactProblem::WiderThanLayer { indentation, thickness },
            ))
        }
        ModelError::Periodic(PeriodicContactError::Kernel(KernelError::LongWake {
            memory, allowed, ..
        })) => {
            let (memory, allowed) = (*memory, *allowed);
            Some(Refusal::keys(&["velocity"], ContactProblem::LongWake { memory, allowed }))
        }
        ModelError::Contact(SteadyError::Kernel(KernelError::Memory { columns, rows, needed, allowed }))
        | ModelError::Periodic(PeriodicContactError::Kernel(KernelError::Memory {
            columns,
            rows,
            needed,
            allowed,
        })) => {
            let [needed, allowed] = [*needed, *allowed].map(bytes_with_operator);
            Some(beyond(*columns, *rows, needed, allowed))
        }
        ModelError::Transient(TransientError::Memory { columns, rows, needed, allowed }) => {
            Some(beyond(*columns, *rows, *needed, *allowed))
        }
        _ => None,
    }
}
