//! What a `[[sweep]]` says: its keys, and a sweep as they say it.

use super::design::POINTS_LIMIT;
use super::problem::SweepProblem;
use super::read_axis::SweepEntry;
use super::{Design, SEEDS, Sensitivity, StudySweep, SweptKey, SweptValues};
use crate::case::analysis::is_file_name;
use crate::case::key_sweep::AnyNumber;
use judder_keys::declared::{Allowed, Number, Setting, Settings, Several, Whole, of_nothing};
use judder_keys::dimension::Dimension;
use judder_keys::document::{Data, Node};
use judder_keys::error::Fault;
use judder_keys::problem::Placed;
use judder_keys::section::{Section, text, wrong_type};
use judder_keys::{Choice, Settings};
use serde_json::{Map, Value as Json, json};

/// The whole case at many points.
#[derive(Debug, Settings)]
#[settings(title = "a sweep")]
pub(crate) struct SweepKeys {
    /// Under which results are kept; no analysis and no other sweep has it.
    #[key(example = "\"…\", under which its results are kept")]
    pub(super) name: SweepName,
    /// How points are chosen.
    #[key(default = Method::Grid)]
    pub(super) method: Method,
    /// Of `latin-hypercube` and `sobol`: how many points; with sensitivity how many rows of k + 2 points for k keys. A power of two fills the ranges most evenly with `sobol`.
    #[key(rule = Whole { from: 2, to: POINTS_LIMIT as usize }, omitted)]
    pub(super) points: Option<usize>,
    /// Of these two: which of all such points; the same seed gives the same points.
    #[key(rule = SEEDS, usual = SEED, omitted)]
    pub(super) seed: Option<usize>,
    /// The swept keys, see below.
    #[key(rule = SOME, example = "[{ key = …, from = …, to = … }], the swept keys")]
    pub(super) over: Vec<SweepEntry>,
    /// What is kept of every point, see below: a quantity of the operating point, or ANALYSIS.PATH into the results of an analysis.
    #[key(example = "[\"growth_rate\", \"ANALYSIS.PATH\"], what is kept of every point")]
    quantities: Quantities,
    /// Points of a unit of work; chosen by the program where left out.
    #[key(rule = Whole { from: 1, to: CHUNK_LIMIT })]
    pub(super) chunk: Option<usize>,
    /// Of `latin-hypercube` and `sobol`: first-order and total Sobol' indices of every quantity, with bootstrap intervals.
    #[key(default = AskedSensitivity(None))]
    pub(super) sensitivity: AskedSensitivity,
    /// Of these two: of which conditions on the quantities the probability is told, with its 95 % interval.
    #[key(rule = CONDITIONS, example = "[{ quantity = \"ANALYSIS.PATH\", above = … }]", omitted)]
    pub(super) probabilities: Option<Vec<AskedCondition>>,
}

/// Something that holds at a point or not; without a bound and without `is`, that the quantity is so, or not zero.
#[derive(Debug, Clone, PartialEq, Settings)]
#[settings(title = "an entry of `{path}`")]
pub(crate) struct AskedCondition {
    /// One of the `quantities`; where it has no number, no bound holds.
    #[key(later)]
    pub(super) quantity: String,
    /// That it lies above this number, in the unit in which it is kept.
    #[key(rule = PLAIN, omitted)]
    pub(super) above: Option<f64>,
    /// That it lies below this number.
    #[key(rule = PLAIN, omitted)]
    pub(super) below: Option<f64>,
    /// Of a class: that it is this one.
    #[key(omitted)]
    pub(super) is: Option<String>,
}

/// How the points of a sweep are chosen.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Choice)]
#[choice(what = "method")]
pub(crate) enum Method {
    /// All combinations of the values of every key, the last key fastest.
    Grid,
    /// The first values of all keys, then the second, and so on.
    List,
    /// Each range in as many parts as there are points, one point in each part.
    LatinHypercube,
    /// A Sobol' sequence, scrambled.
    Sobol,
}

/// The name of a sweep, which is that of a folder.
#[derive(Debug)]
pub(super) struct SweepName(pub(super) String);

/// What a sweep keeps, in the words of the case.
#[derive(Debug)]
pub(super) struct Quantities(Vec<String>);

/// The sensitivity that is asked for.
#[derive(Debug, Clone, Copy)]
pub(super) struct AskedSensitivity(pub(super) Option<Sensitivity>);

/// The seed where the case does not say.
pub(super) const SEED: usize = 1;
/// The most points of a chunk.
const CHUNK_LIMIT: usize = 1 << 28;
const PLAIN: Number = Number::any(Dimension::NUMBER);
const CONDITIONS: Several<()> = SOME;
const SOME: Several<()> = Several { of: (), length: [1, usize::MAX] };

impl Setting for SweepName {
    type Rule = ();

    fn form((): &()) -> Allowed {
        let pattern = "^[A-Za-z0-9_-]([A-Za-z0-9._-]{0,98}[A-Za-z0-9_-])?$";
        let schema = json!({ "type": "string", "pattern": pattern });
        Allowed::Told { schema, words: "a name that serves as that of a folder".to_owned(), keys: Vec::new() }
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, (): &()) -> Result<Self, Fault> {
        let name = text(&section.path(key), node)?.to_owned();
        // the store keeps its metadata under that name
        if !is_file_name(&name) || name.ends_with('.') || name == "zarr.json" {
            return Err(SweepProblem::Name { name }.at(node.place));
        }
        Ok(Self(name))
    }

    fn write(&self, (): &()) -> Json {
        json!(self.0)
    }
}

/// What they mean is found when the analyses are known.
impl Setting for Quantities {
    type Rule = ();

    fn form((): &()) -> Allowed {
        let path = json!({ "type": "string", "pattern": r"^[A-Za-z0-9_-]+(\.[A-Za-z0-9_-]+)*$" });
        let schema = json!({ "type": "array", "items": path, "minItems": 1, "uniqueItems": true });
        Allowed::Told { schema, words: "a list of texts".to_owned(), keys: Vec::new() }
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, (): &()) -> Result<Self, Fault> {
        Vec::read(section, key, node, &SOME).map(Self)
    }

    fn write(&self, (): &()) -> Json {
        json!(self.0)
    }
}

impl Setting for AskedSensitivity {
    type Rule = ();

    fn form((): &()) -> Allowed {
        Allowed::Either(vec![Allowed::Flag, Sensitivity::form(&())])
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, (): &()) -> Result<Self, Fault> {
        match &node.data {
            Data::Boolean(false) => Ok(Self(None)),
            Data::Boolean(true) => Ok(Self(of_nothing())),
            Data::Table(_) => Setting::read(section, key, node, &()).map(|own| Self(Some(own))),
            _ => {
                let expected = "true, or a table { confidence, resamples }";
                Err(wrong_type(&section.path(key), expected, node))
            }
        }
    }

    fn write(&self, (): &()) -> Json {
        self.0.map_or(Json::Null, |own| own.write(&()))
    }
}

impl Design {
    fn method(self) -> Method {
        match self {
            Self::Grid => Method::Grid,
            Self::List => Method::List,
            Self::LatinHypercube { .. } => Method::LatinHypercube,
            Self::Sobol { .. } => Method::Sobol,
        }
    }

    /// The name of the method in a case file.
    pub fn name(self) -> &'static str {
        self.method().name()
    }
}

impl SweptKey {
    /// As a case says it.
    fn as_asked(&self) -> SweepEntry {
        let number = |value: f64| AnyNumber { value, dimension: self.dimension };
        let (from, to, points) = match &self.values {
            SweptValues::Listed(values) => {
                let values = Some(values.iter().map(|value| number(*value)).collect());
                return SweepEntry {
                    key: self.path.clone(),
                    values,
                    from: None,
                    to: None,
                    points: None,
                    scale: None,
                };
            }
            SweptValues::Spaced { from, to, points } => (*from, *to, Some(*points as usize)),
            SweptValues::Between { from, to } => (*from, *to, None),
        };
        let [from, to] = [from, to].map(|end| Some(number(end)));
        SweepEntry { key: self.path.clone(), from, to, points, scale: Some(self.scale), values: None }
    }
}

impl StudySweep {
    /// The sweep with every default filled in; `chunk` is null where the program chooses.
    pub fn resolved(&self) -> Json {
        let (points, seed) = match self.method {
            Design::LatinHypercube { points, seed } | Design::Sobol { points, seed } => {
                (Some(points as usize), Some(seed as usize))
            }
            Design::Grid | Design::List => (None, None),
        };
        let keys = SweepKeys {
            name: SweepName(self.name.clone()),
            method: self.method.method(),
            points,
            seed,
            over: self.axes.iter().map(SweptKey::as_asked).collect(),
            quantities: Quantities(self.quantities.iter().map(|path| path.text.clone()).collect()),
            chunk: self.chunk,
            sensitivity: AskedSensitivity(self.sensitivity),
            probabilities: (!self.conditions.is_empty())
                .then(|| self.conditions.iter().map(|own| own.as_asked(&self.quantities)).collect()),
        };
        let mut json = Map::new();
        keys.write_table(&mut json);
        if seed.is_none() {
            json.remove("sensitivity");
        }
        let mut json = Json::Object(json);
        json.sort_all_objects();
        json
    }
}
