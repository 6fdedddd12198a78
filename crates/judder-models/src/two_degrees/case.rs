//! The two-degrees case: M, C and K as expressions of a few parameters, for benchmarks and minimal models.

use crate::REGISTRY;
use crate::entries::{Entries, EntryMatrix, Order, Scope};
use crate::parameters::{Parameter, Parameters};
use crate::sweep::{ParameterKey, Sweep};
use crate::swept_keys::ParameterKeys;
use crate::two_degrees::{KINDS, MODEL, Varying};
use judder_keys::Settings;
use judder_keys::cause::Cause;
use judder_keys::declared::{Setting, both};
use judder_keys::document::Node;
use judder_keys::error::Fault;
use judder_keys::schema::object;
use judder_oscillator::LinearSystem;
use judder_study::case::analysis::{Planned, read_analyses};
use judder_study::case::root::{document, read_root};
use serde_json::{Value as Json, json};
use std::sync::Arc;

/// A validated two-degrees case.
#[derive(Debug, Clone)]
pub struct TwoDegreesCase {
    /// The title; empty where the case gives none.
    pub title: String,
    /// The parameters in the order of the case file.
    pub parameters: Vec<Parameter>,
    /// The analyses in the order of the case file.
    pub analyses: Vec<Planned<Arc<dyn Varying>>>,
    /// M, C and K.
    matrices: Box<[EntryMatrix; 3]>,
}

impl TwoDegreesCase {
    /// The canonical form.
    pub(super) fn resolved(&self) -> Json {
        let mut json = document(MODEL.name, &self.title, &self.analyses, |kind, json| kind.write(json));
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
    pub fn matrices(&self, values: &[f64]) -> Result<LinearSystem, Cause> {
        let [mass, damping, stiffness] = &*self.matrices;
        Ok(LinearSystem {
            mass: evaluated(mass, values)?,
            damping: evaluated(damping, values)?,
            stiffness: evaluated(stiffness, values)?,
        })
    }

    /// M, C, K with these parameters set; `None` where an entry is not finite.
    pub(super) fn system(&self, set: &[(&Sweep<ParameterKey>, f64)]) -> Option<LinearSystem> {
        let mut values = self.values();
        for (sweep, value) in set {
            sweep.set(&mut values, *value);
        }
        self.matrices(&values).ok()
    }

    /// The texts of the entries of M, C and K as the case file has them, with the names of the matrices.
    pub fn expressions(&self) -> [(&'static str, [[&str; 2]; 2]); 3] {
        self.matrices
            .each_ref()
            .map(|matrix| (matrix.name, [0, 1].map(|row| [0, 1].map(|column| matrix.text(row, column)))))
    }
}

/// Two rows of two numbers where the parameters are `values`; the first entry that is not finite is the error.
fn evaluated(matrix: &EntryMatrix, values: &[f64]) -> Result<[[f64; 2]; 2], Cause> {
    let row = |row: usize| Ok::<_, Cause>([matrix.entry(row, 0, values)?, matrix.entry(row, 1, values)?]);
    Ok([row(0)?, row(1)?])
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
struct MatrixKeys {
    /// M, 2×2 numbers or expressions; the identity by default.
    #[key(rule = Order::Two)]
    mass: Option<Entries>,
    /// C; zero by default.
    #[key(rule = Order::Two)]
    damping: Option<Entries>,
    /// K.
    #[key(rule = Order::Two, example = "[[\"2\", \"1 - mu\"], [1, 2]]")]
    stiffness: Entries,
}

impl MatrixKeys {
    /// The matrices, all that is wrong with them told.
    fn compiled(self, scope: &Scope<'_>) -> Result<Box<[EntryMatrix; 3]>, Fault> {
        let mass =
            self.mass.as_ref().map_or(Ok(EntryMatrix::diagonal("mass", 2, 1.0)), |given| given.mass(scope));
        let damping = self.damping.as_ref();
        let damping = damping
            .map_or(Ok(EntryMatrix::diagonal("damping", 2, 0.0)), |given| given.matrix("damping", scope));
        let (mass, (damping, stiffness)) =
            both(mass, both(damping, self.stiffness.matrix("stiffness", scope)))?;
        Ok(Box::new([mass, damping, stiffness]))
    }
}

/// Reads a two-degrees case from the root of its tree.
pub(crate) fn read(node: &Node) -> Result<TwoDegreesCase, Fault> {
    let (root, sections) = read_root::<TwoDegreesSections>(node)?;
    let keys = ParameterKeys(Parameters::given(&root));
    let analyses = read_analyses(&root, &keys, &KINDS, REGISTRY);
    // an entry that an analysis varies is judged by the run, each where that is not known
    let swept = match &analyses {
        Ok(analyses) => analyses.iter().flat_map(|analysis| analysis.kind.swept()).collect(),
        Err(_) => (0..keys.0.len()).collect::<Vec<_>>(),
    };
    let case = sections.and_then(|(title, TwoDegreesSections { parameters, matrices })| {
        let (names, values) = (parameters.names(), parameters.values());
        let matrices = matrices.compiled(&Scope { names: &names, values: &values, swept: &swept })?;
        Ok((title, parameters.0, matrices))
    });
    let ((title, parameters, matrices), analyses) = both(case, analyses)?;
    Ok(TwoDegreesCase { title, parameters, analyses, matrices })
}
