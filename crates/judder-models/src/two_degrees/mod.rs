//! Any M, C, K of two degrees of freedom, as expressions of parameters.

pub mod case;
mod check;
pub mod mass;
mod matrix;
mod run;

use crate::error::ModelError;
use crate::estimate::{Estimate, cost};
use crate::oscillator::operating_points::{LINEAR_QUANTITIES, linear_values};
use crate::two_degrees::case::{
    ParameterSpectrum, ParameterThresholds, TwoDegreesAnalysis, TwoDegreesCase, TwoDegreesSections,
};
use judder_keys::declared::Settings;
use judder_oscillator::LinearSystem;
use judder_store::Declared;
use judder_study::Progress;
use judder_study::StudyError;
use judder_study::case::analysis::names;
use judder_study::case::file::{Case, CaseFile};
use judder_study::case::reference::section;
use judder_study::case::root::schema;
use judder_study::model::{Analysed, Analysis, Model, OperatingQuantity, Prepared, Task};
use judder_study::outcome::Outcome;
use judder_study::registry::{ModelKind, entries};
use judder_study::resolve::Resolved;
use serde_json::{Map, Value};

impl Analysed for TwoDegreesCase {
    type Subject<'a> = &'a TwoDegreesCase;
    /// The name of the analysis.
    type Known<'a> = &'a str;
    type Estimate = Estimate;
    type Error = ModelError;
}

impl Analysis<TwoDegreesCase> for TwoDegreesAnalysis {
    fn summary_keys(&self) -> Vec<Declared> {
        run::summary_keys(self)
    }

    fn run(&self, of: &&TwoDegreesCase, task: Task<'_>) -> Result<Outcome, ModelError> {
        run::run(of, self, task.progress)
    }

    fn estimate(&self, name: &&str) -> Result<Estimate, ModelError> {
        let points = match self {
            Self::Spectrum(ParameterSpectrum { sweep }) | Self::Critical(ParameterThresholds { sweep }) => {
                sweep.points
            }
            Self::StabilityMap(map) => map.x.points * map.y.points,
        };
        Ok(Estimate::of_points(name, points, points as f64 * cost::EIGENVALUES))
    }

    fn write(&self, json: &mut Map<String, Value>) {
        self.write_table(json);
    }
}

/// The model.
pub(crate) const MODEL: ModelKind = ModelKind {
    name: "two-degrees",
    read: |root, _| case::read(root).map(Case::new),
    declared: TwoDegreesSections::declarations,
    swept: Vec::new,
    schema: || {
        schema(
            "two-degrees",
            "two degrees of freedom with given matrices",
            &TwoDegreesSections::declarations(),
            &case::KINDS,
        )
    },
    reference: || section(include_str!("reference.md"), &TwoDegreesSections::declarations(), &case::KINDS),
    kinds: || entries(&case::KINDS),
    operating_quantities: &LINEAR_QUANTITIES,
};

impl Model for TwoDegreesCase {
    fn name(&self) -> &'static str {
        MODEL.name
    }

    fn analysis_names(&self) -> Vec<&str> {
        names(&self.analyses)
    }

    fn summary_keys(&self, index: usize) -> Vec<Declared> {
        self.analyses[index].kind.summary_keys()
    }

    fn resolved(&self) -> serde_json::Value {
        TwoDegreesCase::resolved(self)
    }

    fn preflight(&self, _: &CaseFile, _: &dyn Fn(&str) -> bool) -> Result<Prepared, StudyError> {
        Ok(Prepared::NOTHING)
    }

    fn steps(&self, index: usize) -> usize {
        self.analyses[index].kind.steps()
    }

    fn run(&self, index: usize, task: Task<'_>) -> Result<Outcome, StudyError> {
        Ok(self.analyses[index].kind.run(&self, task)?)
    }

    fn operating_quantities(&self) -> &'static [OperatingQuantity] {
        MODEL.operating_quantities
    }

    fn operating_point(
        &self,
        wanted: &[OperatingQuantity],
        _: &dyn Progress,
    ) -> Result<(Vec<f64>, Vec<String>), StudyError> {
        let matrices = self.matrices(&self.values());
        let matrices = matrices.map_err(|cause| ModelError::Unsupported(cause.to_string()))?;
        let (mass, damping, stiffness) = (matrices.mass, matrices.damping, matrices.stiffness);
        let system = LinearSystem { mass, damping, stiffness };
        let values = linear_values(&system, wanted).map_err(ModelError::from)?;
        Ok((values, Vec::new()))
    }

    fn resolve(&self, file: &CaseFile) -> Result<Resolved, StudyError> {
        Ok(check::resolve(file, self)?)
    }
}
