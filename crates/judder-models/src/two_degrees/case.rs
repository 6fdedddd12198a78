//! The two-degrees case: M, C and K as expressions of a few parameters, for benchmarks and minimal models.

use crate::REGISTRY;
use crate::parameters::{Parameter, Parameters};
use crate::read_sweep::{Axis, SWEEP, map_declarations, read_map, write_map};
use crate::sweep::{ParameterKey, StabilityMap, Sweep};
use crate::swept_keys::ParameterKeys;
use crate::two_degrees::MODEL;
use crate::two_degrees::matrix::{Entries, Matrix, Scope};
use judder_keys::Settings;
use judder_keys::cause::Cause;
use judder_keys::declared::{Setting, both};
use judder_keys::document::Node;
use judder_keys::error::Fault;
use judder_keys::schema::object;
use judder_study::case::analysis::{Kind, Planned, read_analyses};
use judder_study::case::root::{document, read_root};
use judder_study::model::Analysis;
use serde_json::{Map, Value as Json, json};

/// A validated two-degrees case.
#[derive(Debug, Clone)]
pub struct TwoDegreesCase {
    /// The title; empty where the case gives none.
    pub title: String,
    /// The parameters in the order of the case file.
    pub parameters: Vec<Parameter>,
    /// The analyses in the order of the case file.
    pub analyses: Vec<Planned<TwoDegreesAnalysis>>,
    /// M, C and K.
    matrices: Box<[Matrix; 3]>,
}

/// The matrices at one point, row-major, every entry finite.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TwoDegreesMatrices {
    /// M; the identity where the case gives none.
    pub mass: [[f64; 2]; 2],
    /// C; zero where the case gives none.
    pub damping: [[f64; 2]; 2],
    /// K.
    pub stiffness: [[f64; 2]; 2],
}

/// What an analysis of a two-degrees case computes.
#[derive(Debug, Clone, PartialEq)]
pub enum TwoDegreesAnalysis {
    /// `spectrum`: the eigenvalues along one parameter.
    Spectrum(ParameterSpectrum),
    /// `stability-map`: the verdict over two parameters.
    StabilityMap(StabilityMap<ParameterKey>),
    /// `critical`: the values of one parameter at which stability changes.
    Critical(ParameterThresholds),
}

/// The eigenvalues along one parameter.
#[derive(Debug, Clone, PartialEq)]
pub struct ParameterSpectrum {
    /// The swept parameter.
    pub sweep: Sweep<ParameterKey>,
}

/// The values of one parameter at which stability changes.
#[derive(Debug, Clone, PartialEq)]
pub struct ParameterThresholds {
    /// The parameter, the range in which changes are sought, and the samples of the search.
    pub sweep: Sweep<ParameterKey>,
}

impl TwoDegreesAnalysis {
    /// The positions of the parameters that the analysis varies.
    fn swept(&self) -> Vec<usize> {
        match self {
            Self::Spectrum(ParameterSpectrum { sweep }) | Self::Critical(ParameterThresholds { sweep }) => {
                vec![sweep.key.index()]
            }
            Self::StabilityMap(map) => vec![map.x.key.index(), map.y.key.index()],
        }
    }

    /// Puts the settings into a canonical form.
    pub(crate) fn write_table(&self, json: &mut Map<String, Json>) {
        match self {
            Self::Spectrum(ParameterSpectrum { sweep }) => SWEEP.write::<ParameterKeys>(sweep, json),
            Self::StabilityMap(map) => write_map::<ParameterKeys>(map, json),
            Self::Critical(ParameterThresholds { sweep }) => SAMPLES.write::<ParameterKeys>(sweep, json),
        }
    }
}

/// Where `critical` seeks changes.
const SAMPLES: Axis = SWEEP.of_points(400);

/// The kinds of a two-degrees case.
pub(crate) static KINDS: [Kind<ParameterKeys, TwoDegreesAnalysis>; 3] = [
    Kind {
        name: "spectrum",
        doc: "the eigenvalues along one parameter",
        declared: || vec![SWEEP.declaration::<ParameterKeys>()],
        read: |keys, section| {
            let sweep = SWEEP.read_alone(keys, section)?;
            Ok(TwoDegreesAnalysis::Spectrum(ParameterSpectrum { sweep }))
        },
        picture: None,
    },
    Kind {
        name: "stability-map",
        doc: "stable and unstable points over two parameters",
        declared: map_declarations::<ParameterKeys>,
        read: |keys, section| read_map(keys, section).map(TwoDegreesAnalysis::StabilityMap),
        picture: None,
    },
    Kind {
        name: "critical",
        doc: "the values of a parameter at which stability changes",
        declared: || vec![SAMPLES.declaration::<ParameterKeys>()],
        read: |keys, section| {
            let sweep = SAMPLES.read_alone(keys, section)?;
            Ok(TwoDegreesAnalysis::Critical(ParameterThresholds { sweep }))
        },
        picture: None,
    },
];

impl TwoDegreesCase {
    /// The canonical form.
    pub(super) fn resolved(&self) -> Json {
        let mut json = document(MODEL.name, &self.title, &self.analyses, Analysis::write);
        let matrices = self.expressions().map(|(name, texts)| (name, json!(texts)));
        json.insert("parameters".to_owned(), Parameters(self.parameters.clone()).write(&()));
        json.insert("matrices".to_owned(), Json::Object(object(matrices)));
        Json::Object(json)
    }

    /// The values of all parameters, in their order: what a sweep starts from.
    pub fn values(&self) -> Vec<f64> {
        self.parameters.iter().map(|parameter| parameter.value).collect()
    }

    /// The matrices where the parameters are `values`, in the order of [`TwoDegreesCase::parameters`].
    ///
    /// # Errors
    /// [`Cause::NotFiniteEntry`] names the first entry that is NaN or infinite, as it is where `values` is too short.
    pub fn matrices(&self, values: &[f64]) -> Result<TwoDegreesMatrices, Cause> {
        let [mass, damping, stiffness] = &*self.matrices;
        Ok(TwoDegreesMatrices {
            mass: mass.evaluate(values)?,
            damping: damping.evaluate(values)?,
            stiffness: stiffness.evaluate(values)?,
        })
    }

    /// The texts of the entries of M, C and K as the case file has them, with the names of the matrices.
    pub fn expressions(&self) -> [(&'static str, [[&str; 2]; 2]); 3] {
        self.matrices.each_ref().map(|matrix| (matrix.name, matrix.texts()))
    }
}

/// What a case says beside its analyses.
#[derive(Debug, Settings)]
#[settings(title = "a two-degrees case")]
pub(crate) struct TwoDegreesSections {
    /// Numbers that expressions use and sweeps vary.
    parameters: Parameters,
    /// M, C and K.
    #[key(example = "[matrices] with stiffness = [[…, …], […, …]]")]
    matrices: MatrixKeys,
}

/// `[matrices]`.
#[derive(Debug, Settings)]
#[settings(title = "[{path}]")]
struct MatrixKeys {
    /// M, 2×2 numbers or expressions; the identity by default.
    mass: Option<Entries>,
    /// C; zero by default.
    damping: Option<Entries>,
    /// K.
    #[key(example = "[[\"2\", \"1 - mu\"], [1, 2]]")]
    stiffness: Entries,
}

impl MatrixKeys {
    /// The matrices, all that is wrong with them told.
    fn compiled(self, scope: &Scope<'_>) -> Result<Box<[Matrix; 3]>, Fault> {
        let mass = self.mass.as_ref().map_or(Ok(Matrix::diagonal("mass", 1.0)), |given| given.mass(scope));
        let damping = self.damping.as_ref();
        let damping =
            damping.map_or(Ok(Matrix::diagonal("damping", 0.0)), |given| given.matrix("damping", scope));
        let (mass, (damping, stiffness)) =
            both(mass, both(damping, self.stiffness.matrix("stiffness", scope)))?;
        Ok(Box::new([mass, damping, stiffness]))
    }
}

/// Reads a two-degrees case from the root of its tree.
pub(crate) fn read(node: &Node) -> Result<TwoDegreesCase, Fault> {
    let (root, sections) = read_root::<TwoDegreesSections>(node)?;
    let (parameters, sections) = match (Parameters::of(&root), sections) {
        (Ok(parameters), sections) => (parameters, sections),
        (Err(_), Err(all)) => return Err(all),
        (Err(fault), Ok(_)) => return Err(fault),
    };
    let keys = ParameterKeys(parameters.names());
    let values: Vec<_> = parameters.0.iter().map(|parameter| parameter.value).collect();
    let analyses = read_analyses(&root, &keys, &KINDS, REGISTRY);
    // an entry that an analysis varies is judged by the run, each where that is not known
    let swept = match &analyses {
        Ok(analyses) => analyses.iter().flat_map(|analysis| analysis.kind.swept()).collect(),
        Err(_) => (0..values.len()).collect::<Vec<_>>(),
    };
    let scope = Scope { names: &keys.0, values: &values, swept: &swept };
    let case =
        sections.and_then(|(title, own)| own.matrices.compiled(&scope).map(|matrices| (title, matrices)));
    let ((title, matrices), analyses) = both(case, analyses)?;
    Ok(TwoDegreesCase { title, parameters: parameters.0, analyses, matrices })
}
