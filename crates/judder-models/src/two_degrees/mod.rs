//! Any M, C, K of two degrees of freedom, as expressions of parameters.
//!
//! Decided by the closed forms that the oscillator has anyway: at a point of a map they cost next to nothing beside a search of eigenvalues,
//! and tell the mechanism by what remains when a part is removed. Assemblies of one body have the same eigenvalues, critical values and
//! verdicts, as their tests hold.
//!
//! - `check`: what `judder check` shows.
//! - A folder each: `spectrum`, `stability_map`, `critical`.

pub mod case;
mod check;
pub mod critical;
pub mod spectrum;
pub mod stability_map;

use crate::error::ModelError;
use crate::estimate::Estimate;
use crate::oscillator::curves::SpectrumLabels;
use crate::oscillator::operating_points::{LINEAR_QUANTITIES, linear_values};
use crate::oscillator::spectrum::tables::unstable_ranges;
use crate::oscillator::stability_map::tables as map_tables;
use crate::swept_keys::ParameterKeys;
use crate::swept_tables::parameter_head;
use crate::two_degrees::case::{TwoDegreesCase, TwoDegreesSections};
use judder_keys::declared::Settings;
use judder_study::Progress;
use judder_study::StudyError;
use judder_study::case::analysis::{Kinds, Planned};
use judder_study::case::text::CaseText;
use judder_study::model::{Analysed, Analysis, Case, Model, OperatingQuantity, Prepared, Task, admit};
use judder_study::outcome::Outcome;
use judder_study::registry::{KindTables, ModelKind, Template};
use judder_study::resolve::Resolved;
use std::sync::Arc;

impl Analysed for TwoDegreesCase {
    const NAME: &'static str = MODEL.name;
    const OPERATING_QUANTITIES: &'static [OperatingQuantity] = MODEL.operating_quantities;

    type Asked = dyn Varying;
    type Subject<'a> = &'a TwoDegreesCase;
    /// The name of the analysis.
    type Known<'a> = &'a str;
    type Estimate = Estimate;
    type Error = ModelError;

    fn analyses(&self) -> &[Planned<Arc<Self::Asked>>] {
        &self.analyses
    }
}

/// An analysis that varies parameters.
pub trait Varying: Analysis<TwoDegreesCase> {
    /// Their positions.
    fn swept(&self) -> Vec<usize>;
}

/// The kinds of analyses.
pub(crate) static KINDS: Kinds<ParameterKeys, Arc<dyn Varying>> =
    Kinds::new(&[spectrum::KIND, stability_map::KIND, critical::KIND]);

/// What stands at axes and heads: matrices have the units that the user gives them.
pub(crate) const LABELS: SpectrumLabels = SpectrumLabels {
    growth: "Growth rate Re $λ$ (per unit of time)",
    frequency: "Frequency Im $λ$ (rad per unit of time)",
};

/// The model.
pub const MODEL: ModelKind = ModelKind {
    name: "two-degrees",
    read: |root, _| case::read(root).map(Case::new),
    doc: "two degrees of freedom with given matrices",
    declared: TwoDegreesSections::declarations,
    swept: Vec::new,
    prose: include_str!("reference.md"),
    template: Template { name: "two-degrees", text: include_str!("template.toml"), lines: |_| String::new() },
    kinds: || KINDS.entries(),
    operating_quantities: &LINEAR_QUANTITIES,
    tables: &[
        KindTables::new(spectrum::KIND.name, |told| {
            unstable_ranges(told, &parameter_head(&told.asked["sweep"]), &LABELS)
        }),
        KindTables::new(stability_map::KIND.name, |told| map_tables::report(told, LABELS.frequency)),
        KindTables::new(critical::KIND.name, critical::tables::report),
    ],
};

impl Model for TwoDegreesCase {
    fn resolved(&self) -> serde_json::Value {
        TwoDegreesCase::resolved(self)
    }

    fn run(&self, index: usize, task: Task<'_>) -> Result<Outcome, StudyError> {
        Ok(self.analyses[index].kind.run(&self, task)?)
    }

    fn operating_point(
        &self,
        wanted: &[OperatingQuantity],
        _: &dyn Progress,
    ) -> Result<(Vec<f64>, Vec<String>), StudyError> {
        let system = self.matrices(&self.values()).map_err(ModelError::from)?;
        let values = linear_values(&system, wanted).map_err(ModelError::from)?;
        Ok((values, Vec::new()))
    }

    fn preflight(&self, file: &CaseText, is_wanted: &dyn Fn(&str) -> bool) -> Result<Prepared, StudyError> {
        admit(self, file, is_wanted, |name| name)?;
        self.prepared()
    }

    fn resolve(&self, file: &CaseText, resolved: serde_json::Value) -> Result<Resolved, StudyError> {
        Ok(check::resolve(file, self, resolved)?)
    }
}
