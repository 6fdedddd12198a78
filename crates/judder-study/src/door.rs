//! What is refused of a case before anything runs, and where its file is to blame for what a run finds.

use crate::analyses::Prepared;
use crate::analyses::contact::{Asked, cells_of_law, grid, lattice, loading};
use crate::bridge;
use crate::error::StudyError;
use crate::indenter::profile;
use crate::material::ContactScales;
use crate::sliding::{self, SlidingSystem};
use crate::structure::Structure;
use judder_case::{Case, CaseFile, ContactAnalysis, ContactCase, ContactProblem, Memory, Shape, SlidingCase};
use judder_contact::kernel::check::KernelError;
use judder_contact::kernel::sliding::SlidingOperator;
use judder_contact::periodic_contact::PeriodicContactError;
use judder_contact::steady::profile::Profile;
use judder_contact::steady::{GridChoice, SteadyError};
use judder_contact::transient::TransientError;
use judder_contact::unilateral::Loading;
use std::sync::Arc;

/// Looks at the data of a substrate; reads and assembles a structure, which the analyses share; of a contact case at all files, and at depth and memory of each of its analyses that is
/// wanted; of a sliding case at what its marches keep.
///
/// # Errors
/// What cannot be read or be, [`StudyError::Case`] with its place for an analysis.
pub(crate) fn check(file: &CaseFile, is_wanted: impl Fn(&str) -> bool) -> Result<Prepared, StudyError> {
    let case = match &file.case {
        Case::Contact(case) => case,
        Case::Oscillator(case) => return bridge::with_material(case).map(|_| Prepared::Nothing),
        Case::Structure(case) => {
            let structure = Structure::new(case).map_err(|unbuilt| unbuilt.placed(file))?;
            return Ok(Prepared::Structure(Arc::new(structure)));
        }
        Case::Sliding(case) => {
            let system = SlidingSystem::new(case).map_err(|uncoupled| uncoupled.placed(file))?;
            return fitting((file, case), system, is_wanted);
        }
        Case::Belt(_) | Case::TwoDegrees(_) => return Ok(Prepared::Nothing),
    };
    let scales = ContactScales::new(case)?;
    let profile = profile(&case.shape, scales.scales.radius)?;
    for (index, analysis) in case.analyses.iter().enumerate().filter(|(_, a)| is_wanted(&a.name)) {
        let refuse = |(keys, problem): Refusal| file.analysis_error(index, keys, problem);
        depth(case, &analysis.kind, &scales, &*profile).map_err(refuse)?;
        memory(case, &analysis.kind, &scales, &*profile)?.map_err(refuse)?;
    }
    Ok(Prepared::Nothing)
}

/// The same for a case that differs from that of which `known` is prepared by the values of these swept keys alone: what they do not
/// concern is not made again.
///
/// # Errors
/// As of [`check`].
pub(crate) fn check_at(
    file: &CaseFile,
    is_wanted: impl Fn(&str) -> bool,
    (known, keys): (&Prepared, &[&str]),
) -> Result<Prepared, StudyError> {
    match (&file.case, known) {
        (Case::Sliding(case), Prepared::Sliding(system)) => {
            let system = system.swept(case, keys).map_err(|uncoupled| uncoupled.placed(file))?;
            fitting((file, case), system, is_wanted)
        }
        (Case::Structure(_), Prepared::Structure(structure))
            if keys.iter().all(|key| key.starts_with("analysis.")) =>
        {
            Ok(Prepared::Structure(Arc::clone(structure)))
        }
        _ => check(file, is_wanted),
    }
}

/// The pair of a sliding case, where what its wanted marches keep fits.
fn fitting(
    (file, case): (&CaseFile, &SlidingCase),
    system: SlidingSystem,
    is_wanted: impl Fn(&str) -> bool,
) -> Result<Prepared, StudyError> {
    for (index, _) in case.analyses.iter().enumerate().filter(|(_, a)| is_wanted(&a.name)) {
        sliding::fits((file, case, &system), index)?;
    }
    Ok(Prepared::Sliding(Box::new(system)))
}

/// The keys that are to blame, the first that the analysis has, and why.
type Refusal = (&'static [&'static str], ContactProblem);

/// Refuses a depth at which the indenter has ended.
fn depth(
    case: &ContactCase,
    kind: &ContactAnalysis,
    scales: &ContactScales,
    profile: &dyn Profile,
) -> Result<(), Refusal> {
    let limit = profile.deepest();
    let indentation = match kind {
        ContactAnalysis::Contact(settings) => match loading(&case.shape, settings, scales) {
            Loading::Indentation(depth) => depth,
            Loading::Load(force) => {
                // the glassy substrate yields least
                let indentation = profile.elastic_depth(force / scales.material.spectrum.contrast());
                let is_possible = case.shape.is_periodic() || indentation < limit;
                let problem = ContactProblem::LoadTooLarge { indentation, limit };
                return if is_possible { Ok(()) } else { Err((&["load"], problem)) };
            }
        },
        ContactAnalysis::ContactLaw(law) | ContactAnalysis::Fit { law, .. } => {
            scales.length_of_span(&law.indentation)
        }
        ContactAnalysis::Transient(settings) => Asked::new(&case.shape, settings, scales).largest_depth(),
        ContactAnalysis::Modulus { .. } => return Ok(()),
    };
    if indentation < limit {
        return Ok(());
    }
    Err((&["indentation"], ContactProblem::TooDeep { indentation, limit }))
}

/// Refuses grids that are known beforehand to take more memory than allowed.
fn memory(
    case: &ContactCase,
    kind: &ContactAnalysis,
    scales: &ContactScales,
    profile: &dyn Profile,
) -> Result<Result<(), Refusal>, StudyError> {
    let ([columns, rows], needed, limit) = match kind {
        ContactAnalysis::Contact(settings) => {
            let chosen = !case.shape.is_periodic() && grid(settings, scales) == GridChoice::Automatic;
            if chosen && case.shape != Shape::Cylinder {
                return Ok(Ok(()));
            }
            let lattice = lattice(case, settings, scales)?;
            (lattice, SlidingOperator::memory_bytes(lattice[0], lattice[1]), settings.memory)
        }
        ContactAnalysis::ContactLaw(law) | ContactAnalysis::Fit { law, .. } => {
            let cells = cells_of_law(law);
            ([cells; 2], SlidingOperator::memory_bytes(cells, cells), law.memory)
        }
        ContactAnalysis::Transient(settings) => {
            let asked = Asked::new(&case.shape, settings, scales);
            match asked.question(&scales.creeping(), profile, settings).needs() {
                Err(TransientError::TooManySteps { needed, allowed }) => {
                    return Ok(Err((&["duration"], ContactProblem::TooManySteps { needed, allowed })));
                }
                needs => {
                    let (strip, needed) = needs?;
                    (strip, needed, settings.memory)
                }
            }
        }
        ContactAnalysis::Modulus { .. } => return Ok(Ok(())),
    };
    Ok(if needed <= limit.bytes { Ok(()) } else { Err(beyond(columns, rows, needed, limit.bytes)) })
}

fn beyond(columns: usize, rows: usize, needed: u64, limit: u64) -> Refusal {
    let (needed, limit) = (Memory { bytes: needed }, Memory { bytes: limit });
    (&["cells", "memory_limit"], ContactProblem::Memory { columns, rows, needed, limit })
}

/// What a run found wrong with an analysis, at its place in the case file where it has one.
pub(crate) fn placed(error: StudyError, file: &CaseFile, index: usize) -> StudyError {
    if let Case::Sliding(case) = &file.case {
        return sliding::placed(&error, (file, case), index).map_or(error, StudyError::from);
    }
    match blame(&error, &file.case, index) {
        Some((keys, problem)) => file.analysis_error(index, keys, problem).into(),
        None => error,
    }
}

fn blame(error: &StudyError, case: &Case, index: usize) -> Option<Refusal> {
    match error {
        StudyError::Contact(SteadyError::DomainTooSmall { half_width, needed, .. })
            if has_domain(case, index) =>
        {
            let (side, needed) = (2.0 * half_width, 2.0 * needed);
            Some((&["domain"], ContactProblem::DomainTooSmall { side, needed }))
        }
        StudyError::Contact(SteadyError::TooDeep { indentation, limit }) => {
            let (indentation, limit) = (*indentation, *limit);
            Some((&["indentation"], ContactProblem::TooDeep { indentation, limit }))
        }
        StudyError::Contact(SteadyError::BeyondIndenter { x, y }) => {
            Some((&["indentation", "load"], ContactProblem::BeyondHeights { x: *x, y: *y }))
        }
        StudyError::Periodic(PeriodicContactError::Kernel(KernelError::LongWake {
            memory, allowed, ..
        })) => {
            let (memory, allowed) = (*memory, *allowed);
            Some((&["velocity"], ContactProblem::LongWake { memory, allowed }))
        }
        StudyError::Contact(SteadyError::Kernel(KernelError::Memory { columns, rows, needed, allowed }))
        | StudyError::Periodic(PeriodicContactError::Kernel(KernelError::Memory {
            columns,
            rows,
            needed,
            allowed,
        }))
        | StudyError::Transient(TransientError::Memory { columns, rows, needed, allowed }) => {
            Some(beyond(*columns, *rows, *needed, *allowed))
        }
        _ => None,
    }
}

/// Whether the case says how large the computed square is.
fn has_domain(case: &Case, index: usize) -> bool {
    let Case::Contact(case) = case else { return false };
    let kind = case.analyses.get(index).map(|analysis| &analysis.kind);
    matches!(kind, Some(ContactAnalysis::Contact(settings)) if settings.domain.is_some())
}
