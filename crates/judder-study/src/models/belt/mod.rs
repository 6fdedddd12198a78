//! A mass on a belt.

pub mod case;
mod check;
pub(crate) mod reference;
pub(crate) mod resolved;
pub(crate) mod schema;

use crate::case::analysis::names;
use crate::case::file::{Case, CaseFile};
use crate::error::StudyError;
use crate::model::{Analysed, Analysis, Model, Prepared, Task};
use crate::models::belt::case::{BeltCase, BeltKey, BeltKeys};
use crate::models::motion::settings::MotionAnalysis;
use crate::models::motion::{self, check::estimate, model::BeltModel};
use crate::models::{ModelKind, drawn};
use crate::outcome::Outcome;
use crate::resolve::{Estimate, Resolved, cost};
use serde_json::{Map, Value};

impl Analysed for BeltCase {
    type Subject<'a> = BeltModel<'a>;
    /// The name of the analysis.
    type Known<'a> = &'a str;
    type Estimate = Estimate;
}

impl Analysis<BeltCase> for MotionAnalysis<BeltKey> {
    fn steps(&self) -> usize {
        motion::steps(self)
    }

    fn run(&self, of: &BeltModel<'_>, task: Task<'_>) -> Result<Outcome, StudyError> {
        motion::run_task(of, self, task)
    }

    fn estimate(&self, name: &&str) -> Result<Estimate, StudyError> {
        Ok(estimate(name, self, cost::RADIAN_ON_BELT))
    }

    fn write(&self, json: &mut Map<String, Value>) {
        self.write_table::<BeltKeys>(json);
    }
}

/// The model.
pub(crate) const MODEL: ModelKind = ModelKind {
    name: "belt",
    read: |root, _| case::read(root).map(Case::new),
    schema: schema::case,
    definitions: schema::definitions,
    reference: reference::section,
    kinds: || drawn(&case::KINDS),
};

impl Model for BeltCase {
    fn name(&self) -> &'static str {
        MODEL.name
    }

    fn analysis_names(&self) -> Vec<&str> {
        names(&self.analyses)
    }

    fn resolved(&self) -> serde_json::Value {
        resolved::case(self)
    }

    fn preflight(&self, _: &CaseFile, _: &dyn Fn(&str) -> bool) -> Result<Prepared, StudyError> {
        Ok(Prepared::NOTHING)
    }

    fn steps(&self, index: usize) -> usize {
        self.analyses[index].kind.steps()
    }

    fn run(&self, index: usize, task: Task<'_>) -> Result<Outcome, StudyError> {
        self.analyses[index].kind.run(&BeltModel::new(self), task)
    }

    fn resolve(&self, file: &CaseFile) -> Result<Resolved, StudyError> {
        check::resolve(file, self)
    }
}
