//! A mass on a belt.

pub mod case;
mod check;
pub mod inputs;
pub mod problem;

use crate::belt::case::{BeltCase, BeltKey, BeltKeys, BeltSections};
use crate::error::ModelError;
use crate::estimate::{Estimate, cost};
use crate::friction::FrictionCurve;
use crate::motion::counted::CountedMotions;
use crate::motion::model::{BeltModel, Moving};
use crate::motion::settings::MotionKinds;
use crate::motion::{MotionCase, MotionOf, tables};
use crate::swept_tables::key_head;
use judder_keys::declared::Settings;
use judder_keys::file_reference::FileReference;
use judder_keys::keys::{Keys, lines};
use judder_study::StudyError;
use judder_study::case::analysis::Planned;
use judder_study::case::text::CaseText;
use judder_study::model::{Analysed, Analysis, Case, Model, Prepared, Task, admit};
use judder_study::outcome::Outcome;
use judder_study::registry::{KindTables, ModelKind, Template};
use judder_study::resolve::Resolved;
use std::sync::Arc;

impl Analysed for BeltCase {
    const NAME: &'static str = MODEL.name;

    type Asked = dyn Analysis<Self>;
    type Subject<'a> = BeltModel<'a>;
    type Known<'a> = BeltModel<'a>;
    type Estimate = Estimate;
    type Error = ModelError;

    fn analyses(&self) -> &[Planned<Arc<Self::Asked>>] {
        &self.analyses
    }
}

impl MotionCase for BeltCase {
    type Keys = BeltKeys;

    const STEP: f64 = cost::STEP_ON_BELT;

    fn name<'a>(known: &'a BeltModel<'_>) -> &'a str {
        known.name()
    }

    fn second(known: &BeltModel<'_>) -> Option<f64> {
        known.second()
    }

    fn counted<A: MotionOf<BeltKeys>>(asked: &A, known: &BeltModel<'_>) -> Option<CountedMotions> {
        asked.probed().counted(known)
    }

    fn follow<A: MotionOf<BeltKeys>>(
        asked: &A,
        of: &BeltModel<'_>,
        task: Task<'_>,
    ) -> Result<Outcome, ModelError> {
        asked.run(of, task)
    }
}

/// What stands at the head of works.
const ENERGY: &str = "energy (−)";

/// The model.
pub const MODEL: ModelKind = ModelKind {
    name: "belt",
    read: |root, folder| case::read(root, folder).map(Case::new),
    doc: "one mass on a moving belt, friction against the speed of sliding",
    declared: BeltSections::declarations,
    swept: BeltKey::paths,
    prose: include_str!("reference.md"),
    template: Template {
        name: "belt",
        text: include_str!("template.toml"),
        lines: |section| lines(section, |_: BeltKey| 1.0),
    },
    kinds: || case::KINDS.entries(),
    operating_quantities: &[],
    tables: &[
        KindTables::new(MotionKinds::<BeltKeys>::HISTORY.name, |told| tables::motion(told, ENERGY)),
        KindTables::new(MotionKinds::<BeltKeys>::LIMIT_CYCLE.name, |told| tables::motion(told, ENERGY)),
        KindTables::new(MotionKinds::<BeltKeys>::BIFURCATION.name, |told| {
            tables::diagram(told, &key_head::<BeltKey>(&told.asked["sweep"]))
        }),
        KindTables::new(MotionKinds::<BeltKeys>::BASIN.name, tables::fates),
    ],
};

impl Model for BeltCase {
    fn resolved(&self) -> serde_json::Value {
        BeltCase::resolved(self)
    }

    fn files(&self) -> Vec<&FileReference> {
        self.curve.iter().filter_map(FrictionCurve::file).collect()
    }

    fn run(&self, index: usize, task: Task<'_>) -> Result<Outcome, StudyError> {
        let asked = &self.analyses[index];
        Ok(asked.kind.run(&BeltModel::new(self, &asked.name), task)?)
    }

    fn preflight(&self, file: &CaseText, is_wanted: &dyn Fn(&str) -> bool) -> Result<Prepared, StudyError> {
        admit(self, file, is_wanted, |name| BeltModel::new(self, name))?;
        self.prepared()
    }

    fn resolve(&self, file: &CaseText, resolved: serde_json::Value) -> Result<Resolved, StudyError> {
        Ok(check::resolve(file, self, resolved)?)
    }
}
