//! Reading of `[[sweep]]`.

use super::asked::{AskedCondition, AskedSensitivity, Method, SEED, SweepKeys, SweepName};
use super::condition::SweptCondition;
use super::design::{POINTS_LIMIT, Sampler, kept_values};
use super::known_result;
use super::problem::SweepProblem;
use super::quantity_path::{QuantityPath, QuantitySource};
use super::read_axis::{PlacedKey, read_axes, refuse, refuse_repeated_keys};
use super::trial::try_values;
use super::{Design, StudySweep, SweptKey};
use crate::case::tree::CaseTree;
use crate::model::Case;
use judder_keys::cause::Cause;
use judder_keys::declared::{all, both, read_settings};
use judder_keys::document::{Data, Node};
use judder_keys::error::{Fault, Place};
use judder_keys::problem::Placed;
use judder_keys::section::{Section, list, text, wrong_type};
use judder_numerics::sampling::sobol::DIMENSIONS_LIMIT;
use judder_numerics::sampling::{LatinHypercube, SobolSequence};

/// Reads all sweeps of a case; of one that is none, what is wrong with its sweeps alone.
pub(crate) fn read_sweeps(
    node: &Node,
    tree: &CaseTree,
    case: Option<&Case>,
) -> Result<Vec<StudySweep>, Fault> {
    let Data::List(nodes) = &node.data else {
        return Err(wrong_type("sweep", "a list, each item headed [[sweep]]", node));
    };
    let analyses = case.map_or_else(Vec::new, |case| case.analysis_names());
    let mut names: Vec<String> = Vec::new();
    let sweeps = all(nodes.iter().map(|node| {
        let section = Section::of_table(node, "", "a sweep")?;
        let keys: SweepKeys = read_settings(node, "", "a sweep")?;
        let named = refuse_repeated_name(&keys.name.0, &section, &analyses, &names);
        names.push(keys.name.0.clone());
        let swept = keys.swept(&section);
        let swept = match case {
            Some(case) => swept.and_then(|swept| swept.of_case(&section, &analyses, tree, case)).map(Some),
            None => swept.map(|_| None),
        };
        both(named, swept).map(|((), sweep)| sweep)
    }))?;
    Ok(sweeps.into_iter().flatten().collect())
}

fn refuse_repeated_name(
    name: &str,
    section: &Section<'_>,
    analyses: &[&str],
    sweeps: &[String],
) -> Result<(), Fault> {
    let other = if analyses.iter().any(|other| other.eq_ignore_ascii_case(name)) {
        "an analysis"
    } else if sweeps.iter().any(|other| other.eq_ignore_ascii_case(name)) {
        "another sweep"
    } else {
        return Ok(());
    };
    Err(SweepProblem::NameTwice { name: name.to_owned(), other }.at(section.place_of(&["name"])))
}

/// A sweep, whatever its case.
struct ReadSweep {
    asked: SweepKeys,
    method: Design,
    axes: Vec<PlacedKey>,
    keys: Vec<SweptKey>,
    sampler: Sampler,
    shape: Vec<u64>,
    points: u64,
}

impl ReadSweep {
    /// The sweep of a case.
    fn of_case(
        self,
        section: &Section<'_>,
        analyses: &[&str],
        tree: &CaseTree,
        case: &Case,
    ) -> Result<StudySweep, Fault> {
        let Self { asked, method, axes, keys, sampler, shape, points } = self;
        let quantities = read_quantities(section, analyses, case);
        let cases = try_values(tree, &keys).map_err(|refusal| {
            let place = match refusal.axis {
                Some(axis) if refusal.is_of_key() => axes[axis].key_place,
                Some(axis) => axes[axis].place,
                None => section.place_of(&["over"]),
            };
            refusal.problem.at(place)
        });
        let cases = cases.and_then(|cases| refuse_repeated_keys(tree, case, &axes).map(|()| cases));
        let (quantities, cases) = both(quantities, cases)?;
        let is_set = case.is_set_by(&keys, &cases);
        let quantities = all(quantities)?;
        let conditions = read_conditions(&asked, section, &quantities)?;
        let kept_values = kept_values(method, &keys);
        let SweepKeys { name: SweepName(name), chunk, sensitivity: AskedSensitivity(sensitivity), .. } =
            asked;
        Ok(StudySweep {
            name,
            method,
            axes: keys,
            quantities,
            chunk,
            sensitivity,
            conditions,
            is_set,
            sampler,
            kept_values,
            shape,
            points,
        })
    }
}

impl SweepKeys {
    /// The points, and the keys that vary over them.
    fn swept(self, section: &Section<'_>) -> Result<ReadSweep, Fault> {
        let method = self.design(section)?;
        let AskedSensitivity(sensitivity) = self.sensitivity;
        let sensitive = match (sensitivity, method) {
            (Some(_), Design::Grid | Design::List) => {
                let problem = SweepProblem::SensitivityOf { method: method.name() };
                Err(problem.at(section.place_of(&["sensitivity"])))
            }
            _ => Ok(()),
        };
        let place = section.place_of(&["over"]);
        let axes = section.get("over").map_or(Ok(Vec::new()), |node| read_axes(&self.over, node, method));
        let probable = match (section.get("probabilities"), method) {
            (Some(node), Design::Grid | Design::List) => {
                Err(SweepProblem::ProbabilityOf { method: method.name() }.at(node.place))
            }
            _ => Ok(()),
        };
        let ((), ((), axes)) = both(sensitive, both(probable, axes))?;
        let sampler = read_sampler(method, axes.len(), sensitivity.is_some(), place)?;
        let keys: Vec<SweptKey> = axes.iter().map(|axis| axis.key.clone()).collect();
        let row = if sensitivity.is_some() { keys.len() as u64 + 2 } else { 1 };
        let shape = shape(method, &keys, row);
        let points = check_size(&shape, place)?;
        Ok(ReadSweep { asked: self, method, axes, keys, sampler, shape, points })
    }

    /// How points are chosen, with how many are drawn; refuses keys that mean nothing to the method.
    fn design(&self, section: &Section<'_>) -> Result<Design, Fault> {
        let drawn = matches!(self.method, Method::LatinHypercube | Method::Sobol);
        if !drawn {
            if let (Some(node), Method::Grid) = (section.get("points"), self.method) {
                return Err(SweepProblem::PointsOfGrid.at(node.place));
            }
            let with = format!("method = \"{}\"", self.method.name());
            all(["points", "seed"].map(|key| refuse(section, key, &with)))?;
        }
        let points =
            self.points.ok_or_else(|| section.missing("points", "points = 4096, the number of points"));
        let seed = self.seed.unwrap_or(SEED) as u64;
        Ok(match self.method {
            Method::Grid => Design::Grid,
            Method::List => Design::List,
            Method::LatinHypercube => Design::LatinHypercube { points: points? as u64, seed },
            Method::Sobol => Design::Sobol { points: points? as u64, seed },
        })
    }
}

fn read_sampler(method: Design, keys: usize, has_sensitivity: bool, place: Place) -> Result<Sampler, Fault> {
    let dimensions = if has_sensitivity { 2 * keys } else { keys };
    let sampler = match method {
        Design::Grid | Design::List => Ok(Sampler::None),
        Design::LatinHypercube { points, seed } => {
            LatinHypercube::new(dimensions, points, seed).map(Sampler::LatinHypercube)
        }
        Design::Sobol { seed, .. } => SobolSequence::scrambled(dimensions, seed).map(Sampler::Sobol),
    };
    sampler.map_err(|_| {
        let limit = if has_sensitivity { DIMENSIONS_LIMIT / 2 } else { DIMENSIONS_LIMIT };
        SweepProblem::TooManyKeys { found: keys, limit }.at(place)
    })
}

/// The shape of the results of rows of `row` points.
fn shape(method: Design, keys: &[SweptKey], row: u64) -> Vec<u64> {
    match method {
        Design::Grid => keys.iter().filter_map(SweptKey::count).collect(),
        Design::List => keys.first().and_then(SweptKey::count).into_iter().collect(),
        Design::LatinHypercube { points, .. } | Design::Sobol { points, .. } => {
            vec![points.saturating_mul(row)]
        }
    }
}

/// The number of points, where it is within the limit.
fn check_size(shape: &[u64], place: Place) -> Result<u64, Fault> {
    let points = shape.iter().fold(1, |product: u128, count| product.saturating_mul(u128::from(*count)));
    if points <= u128::from(POINTS_LIMIT) {
        return Ok(points as u64);
    }
    let counts: Vec<_> = shape.iter().map(u64::to_string).collect();
    let product = if counts.len() > 1 { format!(" = {points}") } else { String::new() };
    let shape = counts.join(" × ") + &product;
    Err(SweepProblem::TooManyPoints { shape, points, limit: POINTS_LIMIT as f64 }.at(place))
}

/// Reads what is kept of every point. That there is no such quantity is a fault for when all else of the sweep is right.
fn read_quantities(
    section: &Section<'_>,
    analyses: &[&str],
    case: &Case,
) -> Result<Vec<Result<QuantityPath, Fault>>, Fault> {
    let expected = "quantities = [\"growth_rate\", \"ANALYSIS.PATH\"], what is kept of every point";
    let node = section.required("quantities", expected)?;
    let nodes = list("quantities", node)?;
    if nodes.is_empty() {
        return Err(Cause::EmptyList { key: "quantities".to_owned() }.at(node.place));
    }
    let mut paths: Vec<&str> = Vec::with_capacity(nodes.len());
    all(nodes.iter().map(|node| {
        let path = text("quantities", node)?;
        if paths.contains(&path) {
            return Err(SweepProblem::QuantityTwice { path: path.to_owned() }.at(node.place));
        }
        paths.push(path);
        let quantity = QuantityPath::parse(path, analyses, case.operating_quantities());
        match quantity.and_then(|quantity| known(quantity, case)) {
            Err(problem) if !problem.is_of_results() => Err(problem.at(node.place)),
            quantity => Ok(quantity.map_err(|problem| problem.at(node.place))),
        }
    }))
}

/// The conditions on what is kept.
fn read_conditions(
    asked: &SweepKeys,
    section: &Section<'_>,
    quantities: &[QuantityPath],
) -> Result<Vec<SweptCondition>, Fault> {
    let (Some(given), Some(node)) = (&asked.probabilities, section.get("probabilities")) else {
        return Ok(Vec::new());
    };
    let nodes = list("probabilities", node)?;
    let read = |(own, node): (&AskedCondition, &Node)| {
        SweptCondition::new(own, quantities).map_err(|problem| problem.at(node.place))
    };
    all(given.iter().zip(nodes).map(read))
}

/// The same with its unit, where the analysis has such a result.
fn known(mut quantity: QuantityPath, case: &Case) -> Result<QuantityPath, SweepProblem> {
    if let QuantitySource::Analysis { index, steps, unit, .. } = &mut quantity.source {
        *unit = known_result::unit(&quantity.text, steps, case.summary_keys(*index))?;
    }
    Ok(quantity)
}
