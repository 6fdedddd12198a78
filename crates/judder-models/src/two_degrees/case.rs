//! The two-degrees case: M, C and K as expressions of a few parameters, for benchmarks and minimal models.

use crate::REGISTRY;
use crate::read_sweep::{Axis, SWEEP, map_declarations, read_map, write_map};
use crate::sweep::{ParameterKey, StabilityMap, Sweep};
use crate::swept_keys::ParameterKeys;
use crate::two_degrees::matrix::{Matrix, Scope, read_mass, read_matrix};
use judder_keys::cause::Cause;
use judder_keys::document::{Data, Node};
use judder_keys::error::Fault;
use judder_keys::expression::is_parameter_name;
use judder_keys::section::{Section, finite_number, wrong_type};
use judder_study::case::analysis::{Kind, Planned, read_analyses};
use serde_json::{Map, Value as Json};

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

/// A named number that expressions use and sweeps vary.
#[derive(Debug, Clone, PartialEq)]
pub struct Parameter {
    /// The name in expressions; a swept key calls it `parameters.NAME`.
    pub name: String,
    /// The value where no sweep sets it; finite.
    pub value: f64,
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

/// Reads a two-degrees case from the root of its tree.
pub(crate) fn read(root: &Node) -> Result<TwoDegreesCase, Fault> {
    let known = ["title", "model", "parameters", "matrices", "analysis", "sweep"];
    let root = Section::open(root, "", "a two-degrees case", &known)?;
    let parameters = read_parameters(&root)?;
    let keys = ParameterKeys(parameters.iter().map(|parameter| parameter.name.clone()).collect());
    let values: Vec<_> = parameters.iter().map(|parameter| parameter.value).collect();
    let node = root.required("matrices", "[matrices] with stiffness = [[…, …], […, …]]")?;
    let section = Section::open(node, "matrices", "[matrices]", &["mass", "damping", "stiffness"])?;
    section.required("stiffness", "stiffness = [[\"2\", \"1 - mu\"], [1, 2]]")?;
    let title = root.text("title")?.unwrap_or_default().to_owned();
    // before the matrices: an entry that an analysis varies is judged by the run
    let analyses = read_analyses(&root, &keys, &KINDS, REGISTRY)?;
    let swept: Vec<_> = analyses.iter().flat_map(|analysis| analysis.kind.swept()).collect();
    let scope = Scope { names: &keys.0, values: &values, swept: &swept };
    let matrices = Box::new([
        read_mass(&section, &scope)?,
        read_matrix(&section, "damping", 0.0, &scope)?,
        read_matrix(&section, "stiffness", 0.0, &scope)?,
    ]);
    Ok(TwoDegreesCase { title, parameters, analyses, matrices })
}

pub(crate) fn read_parameters(root: &Section<'_>) -> Result<Vec<Parameter>, Fault> {
    let Some(node) = root.get("parameters") else { return Ok(Vec::new()) };
    let Data::Table(table) = &node.data else { return Err(wrong_type("parameters", "a table", node)) };
    let read = table.entries.iter().map(|entry| {
        let name = entry.key.clone();
        if !is_parameter_name(&name) {
            return Err(Cause::ParameterName { name }.at(entry.place));
        }
        let value = finite_number(&format!("parameters.{name}"), &entry.node)?;
        Ok(Parameter { name, value })
    });
    read.collect()
}
