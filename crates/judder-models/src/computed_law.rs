//! Contact laws computed with the boundary-element solver.

use crate::contact::memory::{contacts_at_once, operator_at_once};
use crate::contact::settings::LawMethod;
use crate::contact::size::lattice_of_contacts;
use crate::error::ModelError;
use crate::made_once::MadeOnce;
use crate::material::Material;
use judder_contact::law::boundary_elements::{sample, sweep_accuracy};
use judder_contact::law::sweep::{
    CollapseRequest, SolvedLawPoint, SweepEnd, SweepLevel, SweepObserver, SweepRange, SweepRequest,
    collapse_sweep, sweep,
};
use judder_contact::law::{LawErrors, LawIndenter, LawLayer, LawOrigin};
use judder_contact::steady::MEMORY;
use judder_contact::{Law, LawError};
use judder_numerics::parallel;
use judder_study::Progress;
use std::sync::Arc;

/// How much further than the force area and friction may be off.
const SECONDARY: f64 = 5.0;
/// The most contacts that a law may take.
const MOST_POINTS: usize = 4000;
/// ŷ at which the curve of a paraboloid is computed; by the collapse any will do.
const COLLAPSE_INDENTATION: f64 = 1e-2;

/// A law to be computed.
#[derive(Debug, Clone)]
pub struct LawTask<'a> {
    /// The substrate.
    pub material: &'a Material,
    /// The indenter.
    pub indenter: LawIndenter,
    /// How the plane is covered.
    pub method: LawMethod,
    /// v̂ between which the law is wanted.
    pub velocity: (f64, f64),
    /// ŷ between which the law is wanted.
    pub indentation: (f64, f64),
    /// Relative accuracy.
    pub accuracy: f64,
    /// Bytes that the largest grid of each contact may take.
    pub memory: u64,
}

/// A computed law, and how it came about.
#[derive(Debug, Clone)]
pub struct ComputedLaw {
    /// The law that was found.
    pub law: Law,
    /// How the refinement of its plane ended.
    pub end: SweepEnd,
    /// What each refinement of the plane left.
    pub levels: Vec<SweepLevel>,
    /// The contacts that were solved.
    pub points: Vec<SolvedLawPoint>,
}

/// Tells a sweep's progress, and where solved points are kept.
struct SweepWatch<'a> {
    progress: &'a dyn Progress,
    kept: &'a (dyn Fn(&SolvedLawPoint) + Sync),
}

impl SweepObserver for SweepWatch<'_> {
    fn begins(&self, points: usize) {
        self.progress.expect(points);
    }

    fn finished(&self, point: &SolvedLawPoint, _done: usize, _planned: usize) {
        (self.kept)(point);
        self.progress.advance();
    }

    fn interrupted(&self) -> bool {
        self.progress.interrupted()
    }
}

/// Nothing is known, and nothing is kept.
pub const NO_POINTS: KnownPoints<'static> = KnownPoints { known: &[], kept: &|_| () };

/// The points that are known already, and who is handed each new one.
pub struct KnownPoints<'a> {
    /// They are not solved again.
    pub(crate) known: &'a [SolvedLawPoint],
    /// Is handed each new one.
    pub(crate) kept: &'a (dyn Fn(&SolvedLawPoint) + Sync),
}

/// Bytes of laws that are remembered while the program runs: hundreds of laws to 1e-3, more than a slider passes in an hour.
const REMEMBERED_BYTES: usize = 64 << 20;
/// Bytes that a solved contact takes in a law, at most: its solution, and the piece of the law that ends there.
const BYTES_A_CONTACT: usize = 1024;

/// Computes a law, or gives the one that was computed before: those asked for last are kept while the program runs. `known` points are not
/// solved again, and every new one is handed to `kept`.
///
/// # Errors
/// [`ModelError::Interrupted`], [`ModelError::Law`].
pub fn compute(
    task: &LawTask<'_>,
    points: KnownPoints<'_>,
    progress: &dyn Progress,
) -> Result<ComputedLaw, ModelError> {
    static KNOWN: MadeOnce<ComputedLaw> = MadeOnce::new(REMEMBERED_BYTES);
    let LawTask { material, indenter, method, velocity, indentation, accuracy, memory } = task;
    // a curve of the paraboloid knows no ranges
    let ranges = (*method == LawMethod::Sweep).then_some((velocity, indentation));
    let key = format!("{:?} {indenter:?} {method:?} {ranges:?} {accuracy} {memory}", material.of_law());
    KNOWN.get(&key, progress, || {
        let law = compute_anew(task, points, progress)?;
        let bytes = law.points.len() * BYTES_A_CONTACT;
        Ok((law, bytes))
    })
}

/// As many contacts at once as there are threads, or as the process has memory for.
fn compute_anew(
    task: &LawTask<'_>,
    points: KnownPoints<'_>,
    progress: &dyn Progress,
) -> Result<ComputedLaw, ModelError> {
    let is_line = matches!(task.indenter, LawIndenter::Cylinder(_));
    let at_once = contacts_at_once(lattice_of_contacts(is_line, sweep_accuracy(task.accuracy).contacts));
    let memory = operator_at_once(task.memory, at_once);
    let work = || compute_within(task, memory, points, progress);
    if at_once >= parallel::threads() {
        return work();
    }
    // where no threads are to be had those that there are do it
    let pool = rayon::ThreadPoolBuilder::new().num_threads(at_once).build();
    if let Ok(pool) = pool { pool.install(work) } else { work() }
}

/// With so many bytes for the operator of each contact.
fn compute_within(
    task: &LawTask<'_>,
    memory: u64,
    points: KnownPoints<'_>,
    progress: &dyn Progress,
) -> Result<ComputedLaw, ModelError> {
    let material = task.material.of_law();
    let substrate = material.clone();
    let shares = sweep_accuracy(task.accuracy);
    let solve = |velocity: f64, indentation: f64| {
        sample(&substrate, task.indenter, velocity, indentation, shares.contacts, memory)
    };
    let KnownPoints { known, kept } = points;
    let watch = SweepWatch { progress, kept };
    let source = format!("judder {}, boundary elements, steady sliding", env!("CARGO_PKG_VERSION"));
    let accuracy = shares.interpolation;
    let (law, end, levels, points) = match task.method {
        LawMethod::Collapse => {
            let request = CollapseRequest {
                ln_speeds: SweepRange::all_speeds(&material),
                material,
                source,
                indentation: COLLAPSE_INDENTATION,
                accuracy,
                most_points: MOST_POINTS,
            };
            let found = collapse_sweep(&request, known, &solve, &watch)?;
            (Law::Collapsed(Arc::new(found.law)), found.end, found.levels, found.points)
        }
        LawMethod::Sweep => {
            let (velocity, indentation) = (task.velocity, task.indentation);
            let range = match task.indenter {
                LawIndenter::Cylinder(layer) => {
                    SweepRange::covering_line(velocity, indentation, &material, layer)?
                }
                LawIndenter::Paraboloid | LawIndenter::Sphere => {
                    SweepRange::covering(velocity, indentation, &material)?
                }
            };
            let request = SweepRequest {
                range,
                origin: LawOrigin { material, indenter: task.indenter, source },
                accuracy,
                most_points: MOST_POINTS,
            };
            let found = sweep(&request, known, &solve, &watch)?;
            (Law::Tabulated(Arc::new(found.law)), found.end, found.levels, found.points)
        }
    };
    Ok(ComputedLaw { law, end, levels, points })
}

impl ComputedLaw {
    /// Its errors.
    pub(crate) fn errors(&self) -> LawErrors {
        self.law.data().map_or_else(LawErrors::default, |data| *data.errors())
    }

    /// By how much it misses an accuracy, and why; `None` where it is met.
    pub(crate) fn missed(&self, accuracy: f64) -> Option<String> {
        let errors = self.errors();
        let total = errors.total();
        (!meets(&errors, accuracy)).then(|| {
            format!(
                "the law misses its accuracy {accuracy:.0e}: interpolation and contacts leave force {:.1e}, area {:.1e}, friction {:.1e} \
                 (area and friction may have five times the accuracy); {}",
                total.force,
                total.area,
                total.friction,
                ending(self.end)
            )
        })
    }
}

/// Why a sweep ended.
pub(crate) fn ending(end: SweepEnd) -> &'static str {
    match end {
        SweepEnd::Accurate => "the interpolation is as accurate as asked",
        SweepEnd::SolverError => "the single contacts are no more accurate than that",
        SweepEnd::MostPoints => "more points would be needed than are allowed",
    }
}

/// Whether a law is as accurate as asked: interpolation and solver together, area and friction five times as far off as the
/// force at most.
pub(crate) fn meets(errors: &LawErrors, accuracy: f64) -> bool {
    let total = errors.total();
    total.force <= accuracy && total.area.max(total.friction) <= SECONDARY * accuracy
}

impl From<LawError> for ModelError {
    fn from(error: LawError) -> Self {
        match error {
            LawError::Interrupted { .. } => Self::Interrupted,
            error => Self::Law(error),
        }
    }
}

/// The law `bem` of a substrate under a paraboloid.
///
/// # Errors
/// As [`compute`].
pub fn of_paraboloid(
    material: &Material,
    accuracy: f64,
    points: KnownPoints<'_>,
    progress: &dyn Progress,
) -> Result<ComputedLaw, ModelError> {
    let task = LawTask {
        material,
        indenter: LawIndenter::Paraboloid,
        method: LawMethod::Collapse,
        velocity: (f64::MIN_POSITIVE, f64::MAX),
        indentation: (f64::MIN_POSITIVE, f64::MAX),
        accuracy,
        memory: MEMORY,
    };
    compute(&task, points, progress)
}

/// δ over the thickness of a layer down to which the law of a cylinder on it is computed: a tenth is where linear theory ends, and more is told.
const DEEPEST_IN_A_LAYER: f64 = 0.2;
/// The same of a thin layer, as δ R/h²: a contact twenty times as wide as two thicknesses.
const WIDEST_ON_A_LAYER: f64 = 60.0;
/// δ over the deepest from which it is computed.
const SHALLOWEST_IN_A_LAYER: f64 = 1e-4;

/// The law `bem` of a layer under a cylinder, of the length R.
///
/// # Errors
/// As [`compute`].
pub fn of_cylinder(
    material: &Material,
    layer: LawLayer,
    accuracy: f64,
    points: KnownPoints<'_>,
    progress: &dyn Progress,
) -> Result<ComputedLaw, ModelError> {
    let deepest = (DEEPEST_IN_A_LAYER * layer.thickness).min(WIDEST_ON_A_LAYER * layer.thickness.powi(2));
    let task = LawTask {
        material,
        indenter: LawIndenter::Cylinder(layer),
        method: LawMethod::Sweep,
        velocity: (f64::MIN_POSITIVE, f64::MAX),
        indentation: (SHALLOWEST_IN_A_LAYER * deepest, deepest),
        accuracy,
        memory: MEMORY,
    };
    compute(&task, points, progress)
}
