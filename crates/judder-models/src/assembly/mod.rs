//! Bodies that touch at many points.
//!
//! - `build`: from the keys of a case to bodies with their contact points.
//! - `check`: what `judder check` shows. `quickly_found`: what it finds out about steady sliding.
//! - `interface_error`: what interface modes cost.
//! - `swept`: steady sliding and small motions about it at any values of keys.
//! - `meant_mode`: which mode about steady sliding an analysis means.
//! - `periodic`: what has periodic motions that can be computed, and what memory they need. `linear_size`: what steady sliding and modes need.
//! - `cycles_along_key`: the first cycle of a mode along a key, and the branch through it.
//! - `doubts`: what is to be said of steady sliding before anything is concluded from it.
//! - `branch_checks`: what is checked of such a branch.
//! - A folder each: `steady_sliding`, `eigen`, `eigen_sweep`, `stability_map`, `growth`, `march`, `spectrogram`, `limit_cycle`, `squeal`, `bifurcation`, `frequency_response`.

pub mod bifurcation;
mod branch_checks;
pub(crate) mod build;
pub mod case;
mod check;
mod cycles_along_key;
mod doubts;
pub mod eigen;
pub mod eigen_sweep;
pub mod frequency_response;
pub mod growth;
mod interface_error;
pub mod limit_cycle;
mod linear_size;
pub mod march;
mod meant_mode;
mod periodic;
mod quickly_found;
pub mod spectrogram;
pub mod squeal;
pub mod stability_map;
pub mod steady_sliding;
mod swept;

use crate::assembly::case::AssemblyCase;
use crate::assembly::case::problem::AssemblyProblem;
use crate::error::ModelError;
use crate::material::with_used;
use crate::measured_growth;
use crate::told_quantities::quantities;
use build::BuiltAssembly;
use judder_assembly::assembly::Assembly;
use judder_assembly::compliance::Compliance;
use judder_assembly::interface::InterfaceLaw;
use judder_assembly::steady::{PointState, SteadySliding, steady_sliding as slide};
use judder_keys::file_reference::FileReference;
use judder_nonsmooth::course::Course;
use judder_study::case::analysis::{Kinds, Planned};
use judder_study::case::text::CaseText;
use judder_study::model::{Analysed, Analysis, Case, Model, Prepared, Refusal, Task, admit, wanted};
use judder_study::outcome::Outcome;
use judder_study::registry::{KindTables, ModelKind, Template, TerminalTable};
use judder_study::resolve::Resolved;
use judder_study::{Silent, StudyError};
use std::sync::Arc;

/// The kinds of analyses.
pub(crate) static KINDS: Kinds<Option<AssemblyCase>, Arc<dyn Analysis<AssemblyCase>>> = Kinds::new(&[
    steady_sliding::KIND,
    eigen::KIND,
    eigen_sweep::KIND,
    stability_map::KIND,
    growth::KIND,
    march::KIND,
    spectrogram::KIND,
    limit_cycle::KIND,
    squeal::KIND,
    bifurcation::KIND,
    frequency_response::KIND,
]);

/// An assembly, and the name under which an analysis of it leaves files.
pub struct AssemblySubject<'a> {
    case: &'a AssemblyCase,
    built: &'a BuiltAssembly,
    name: &'a str,
}

impl AssemblySubject<'_> {
    /// Steady sliding; bodies that touch nowhere are at rest.
    fn steady_or_untouched(&self) -> Result<SteadySliding, ModelError> {
        if self.built.assembly.interfaces.is_empty() {
            return Ok(SteadySliding::untouched(self.built.assembly.size()));
        }
        self.steady(&self.compliance()?)
    }

    /// How the contact points yield.
    fn compliance(&self) -> Result<Compliance, ModelError> {
        Compliance::new(&self.built.assembly).map_err(|error| self.built.told(error))
    }

    /// Steady sliding on the compliance of the contact points.
    fn steady(&self, compliance: &Compliance) -> Result<SteadySliding, ModelError> {
        self.built.find_laws(&Silent)?;
        slide(&self.built.assembly, compliance).map_err(|error| self.built.told(error))
    }

    /// Steady sliding from which a march can begin: a rigid point that is held closed and pulls has friction there that it has in no motion. On tracks at rest the
    /// bodies lie as they do without friction there, and as they are meshed where no load moves them.
    fn steady_to_march(&self) -> Result<SteadySliding, ModelError> {
        let assembly = &self.built.assembly;
        let Some(smooth) = assembly.without_friction_at_rest() else {
            return self.admitted(self.steady_or_untouched()?);
        };
        match assembly.load.iter().all(|force| *force == 0.0) {
            true => Ok(SteadySliding::as_meshed(assembly)),
            false => self.admitted(self.slid(&smooth)?),
        }
    }

    /// Steady sliding of these bodies under other loads or friction.
    fn slid(&self, assembly: &Assembly) -> Result<SteadySliding, ModelError> {
        let told = |error| self.built.told(error);
        slide(assembly, &Compliance::new(assembly).map_err(told)?).map_err(told)
    }

    /// Refuses an analysis of steady sliding where a track rests with friction.
    fn slides(&self) -> Result<(), Refusal> {
        let interfaces = &self.built.assembly.interfaces;
        match interfaces.iter().find(|own| own.rests_with_friction()) {
            Some(own) => Err(Refusal::key("", AssemblyProblem::AtRest { contact: own.name.clone() })),
            None => Ok(()),
        }
    }

    /// Refuses an analysis of contact where nothing touches.
    fn touches(&self) -> Result<(), Refusal> {
        match self.case.contacts.is_empty() {
            true => Err(Refusal::key("", AssemblyProblem::NothingTouches)),
            false => Ok(()),
        }
    }

    /// The same with what a course starts with.
    fn steady_at_first(&self, course: &Course) -> Result<SteadySliding, ModelError> {
        let first = course.first(&self.built.assembly);
        // without loads the bodies lie as they are meshed
        if first.interfaces.is_empty() || first.load.iter().all(|force| *force == 0.0) {
            return Ok(SteadySliding::untouched(first.size()));
        }
        let smooth = first.without_friction_at_rest();
        self.admitted(self.slid(smooth.as_ref().unwrap_or(&first))?)
    }

    /// Refuses steady sliding from which no march can begin.
    fn admitted(&self, steady: SteadySliding) -> Result<SteadySliding, ModelError> {
        let interfaces = &self.built.assembly.interfaces;
        let pulls = |point: &&PointState| {
            point.normal_force < 0.0 && matches!(interfaces[point.interface].law, InterfaceLaw::Rigid(_))
        };
        match steady.points.iter().find(pulls) {
            None => Ok(steady),
            Some(point) => Err(ModelError::Unsupported(format!(
                "a point of `{}` is held closed although it pulls with {:.4e} N: no motion goes on from there; with `all_closed = false` it opens",
                interfaces[point.interface].name, -point.normal_force,
            ))),
        }
    }
}

impl Analysed for AssemblyCase {
    const NAME: &'static str = MODEL.name;

    type Asked = dyn Analysis<Self>;
    type Subject<'a> = AssemblySubject<'a>;
    type Known<'a> = AssemblySubject<'a>;
    /// What is asked, in words.
    type Estimate = String;
    type Error = ModelError;

    fn analyses(&self) -> &[Planned<Arc<Self::Asked>>] {
        &self.analyses
    }
}

/// The model.
pub(crate) const MODEL: ModelKind = ModelKind {
    name: "assembly",
    read: |root, folder| case::read(root, folder).map(Case::new),
    doc: "bodies that touch at many points",
    declared: case::declared,
    swept: Vec::new,
    prose: include_str!("reference.md"),
    template: Template { name: "assembly", text: include_str!("template.toml"), lines: |_| String::new() },
    kinds: || KINDS.entries(),
    tables: &[
        KindTables::new(steady_sliding::KIND.name, |told| steady_sliding::tables::report(told.results)),
        KindTables::new(eigen::KIND.name, |told| eigen::tables::report(told.results)),
        KindTables::new(march::KIND.name, |told| march::tables::report(told.results)),
        KindTables::new(growth::KIND.name, |told| {
            quantities("Growth of the mode", told.results, measured_growth::TOLD)
        }),
        KindTables::new(spectrogram::KIND.name, |told| {
            quantities("The loudest", told.results, crate::spectrogram::TOLD)
        }),
        KindTables::new(bifurcation::KIND.name, |told| bifurcation::tables::report(told.results)),
        KindTables {
            kind: squeal::KIND.name,
            report: |told| squeal::tables::report(told.results),
            terminal: TerminalTable::FirstAndLines(|told| squeal::tables::lines(told.results)),
        },
        KindTables::new(frequency_response::KIND.name, |told| {
            frequency_response::tables::report(told.results)
        }),
        KindTables::new(limit_cycle::KIND.name, |told| limit_cycle::tables::report(told.results)),
        KindTables::new(eigen_sweep::KIND.name, |told| {
            crate::structure::eigen_sweep::tables::report(told.results)
        }),
    ],
    operating_quantities: &[],
};

impl Model for AssemblyCase {
    fn files(&self) -> Vec<&FileReference> {
        AssemblyCase::files(self)
    }

    fn resolved(&self) -> serde_json::Value {
        AssemblyCase::resolved(self)
    }

    fn with_used(&self, resolved: serde_json::Value) -> Result<serde_json::Value, StudyError> {
        match &self.substrate {
            Some(own) => Ok(with_used(&own.substrate, &own.inputs, resolved)?),
            None => Ok(resolved),
        }
    }

    fn prepared(&self) -> Result<Prepared, StudyError> {
        let made = BuiltAssembly::new(self).map_err(ModelError::from)?;
        Ok(Prepared::new(Arc::new(made)))
    }

    fn preflight(&self, file: &CaseText, is_wanted: &dyn Fn(&str) -> bool) -> Result<Prepared, StudyError> {
        let most = wanted(self, file, is_wanted).filter_map(|(_, asked)| asked.most_freedoms()).min();
        let built =
            BuiltAssembly::with_at_most(self, most).map_err(|unassembled| unassembled.placed(file))?;
        admit(self, file, is_wanted, |name| AssemblySubject { case: self, built: &built, name })?;
        Ok(Prepared::new(Arc::new(built)))
    }

    fn run(&self, index: usize, task: Task<'_>) -> Result<Outcome, StudyError> {
        if task.progress.interrupted() {
            return Err(StudyError::Interrupted);
        }
        let own = &self.analyses[index];
        let built = match task.prepared.get::<BuiltAssembly>() {
            Some(built) => built,
            None => Arc::new(BuiltAssembly::new(self).map_err(ModelError::from)?),
        };
        let progress = task.progress;
        built.find_laws(progress)?;
        let subject = AssemblySubject { case: self, built: &built, name: &own.name };
        let mut outcome = own.kind.run(&subject, task)?;
        progress.advance();
        outcome.warnings.extend(built.warnings.iter().cloned());
        Ok(outcome)
    }

    fn resolve(&self, file: &CaseText, resolved: serde_json::Value) -> Result<Resolved, StudyError> {
        Ok(check::resolve(file, self, resolved)?)
    }
}
