//! Reading of `[[sweep]]`.

use judder_numerics::sampling::sobol::DIMENSIONS_LIMIT;
use judder_numerics::sampling::{LatinHypercube, SobolSequence};

use super::design::{POINTS_LIMIT, Sampler, kept_values};
use super::known_result;
use super::problem::SweepProblem;
use super::quantity_path::{QuantityPath, QuantitySource};
use super::read_axis::{read_axes, refuse, refuse_repeated_keys};
use super::trial::try_values;
use super::{Design, SEEDS, Sensitivity, StudySweep, SweptKey};
use crate::case::analysis::is_file_name;
use crate::case::file::{Case, CaseTree};
use judder_keys::cause::Cause;
use judder_keys::document::{Data, Node};
use judder_keys::error::{Fault, Place};
use judder_keys::numeric_key::Range;
use judder_keys::problem::Placed;
use judder_keys::section::{Section, finite_number, list, text, wrong_type};

/// The keys of a sweep.
pub(crate) const KEYS: [&str; 8] =
    ["name", "method", "points", "seed", "over", "quantities", "chunk", "sensitivity"];

/// The seed where the case does not say.
pub(crate) const SEED: usize = 1;

/// The most points of a chunk.
pub(crate) const CHUNK_LIMIT: usize = 1 << 28;

/// What a sensitivity is estimated with where the case does not say.
pub(crate) const SENSITIVITY: Sensitivity = Sensitivity { confidence: 0.95, resamples: 1000 };

/// The resamples that a bootstrap may have.
pub(crate) const RESAMPLES_LIMITS: [usize; 2] = [100, 1_000_000];

/// The confidence that intervals may have.
const CONFIDENCE: Range = Range::Interval { above: 0.0, up_to: 0.9999 };

/// Reads all sweeps of a case.
pub(crate) fn read_sweeps(node: &Node, tree: &CaseTree, case: &Case) -> Result<Vec<StudySweep>, Fault> {
    let Data::List(nodes) = &node.data else {
        return Err(wrong_type("sweep", "a list, each item headed [[sweep]]", node));
    };
    let analyses = case.analysis_names();
    let mut sweeps: Vec<StudySweep> = Vec::new();
    for node in nodes {
        let section = Section::open(node, "", "a sweep", &KEYS)?;
        let name = read_name(&section, &analyses, &sweeps)?;
        sweeps.push(read_sweep(name, &section, &analyses, (tree, case))?);
    }
    Ok(sweeps)
}

fn read_name(section: &Section<'_>, analyses: &[&str], sweeps: &[StudySweep]) -> Result<String, Fault> {
    let node = section.required("name", "name = \"…\", under which its results are kept")?;
    let name = text("name", node)?.to_owned();
    let place = node.place;
    // the store keeps its metadata under that name
    if !is_file_name(&name) || name.ends_with('.') || name == "zarr.json" {
        return Err(SweepProblem::Name { name }.at(place));
    }
    if analyses.iter().any(|other| other.eq_ignore_ascii_case(&name)) {
        return Err(SweepProblem::NameTwice { name, other: "an analysis" }.at(place));
    }
    if sweeps.iter().any(|other| other.name.eq_ignore_ascii_case(&name)) {
        return Err(SweepProblem::NameTwice { name, other: "another sweep" }.at(place));
    }
    Ok(name)
}

fn read_sweep(
    name: String,
    section: &Section<'_>,
    analyses: &[&str],
    (tree, case): (&CaseTree, &Case),
) -> Result<StudySweep, Fault> {
    let method = read_method(section)?;
    let sensitivity = read_sensitivity(section, method)?;
    let over = section.required("over", "over = [{ key = …, from = …, to = … }], the swept keys")?;
    let axes = read_axes(over, method)?;
    let sampler = read_sampler(method, axes.len(), sensitivity.is_some(), over.place)?;
    let keys: Vec<SweptKey> = axes.iter().map(|axis| axis.key.clone()).collect();
    let row = if sensitivity.is_some() { keys.len() as u64 + 2 } else { 1 };
    let shape = shape(method, &keys, row);
    let points = check_size(&shape, over.place)?;
    let quantities = read_quantities(section, analyses, case)?;
    let chunk = section.whole("chunk", 1, CHUNK_LIMIT)?;
    let cases = try_values(tree, &keys).map_err(|refusal| {
        let place = match refusal.axis {
            Some(axis) if refusal.is_of_key() => axes[axis].key_place,
            Some(axis) => axes[axis].place,
            None => over.place,
        };
        refusal.problem.at(place)
    })?;
    refuse_repeated_keys(tree, case, &axes)?;
    let quantities = quantities.into_iter().collect::<Result<_, _>>()?;
    let is_set = case.is_set_by(&keys, &cases);
    let kept_values = kept_values(method, &keys);
    Ok(StudySweep {
        name,
        method,
        axes: keys,
        quantities,
        chunk,
        sensitivity,
        is_set,
        sampler,
        kept_values,
        shape,
        points,
    })
}

fn read_method(section: &Section<'_>) -> Result<Design, Fault> {
    let names = Design::NAMES.map(|name| (name, name));
    let method = section.choice("method", "method", &names)?.unwrap_or(Design::NAMES[0]);
    let drawn = [Design::NAMES[2], Design::NAMES[3]].contains(&method);
    if !drawn {
        if let (Some(node), "grid") = (section.get("points"), method) {
            return Err(SweepProblem::PointsOfGrid.at(node.place));
        }
        let with = format!("method = \"{method}\"");
        ["points", "seed"].into_iter().try_for_each(|key| refuse(section, key, &with))?;
        return Ok(if method == Design::NAMES[0] { Design::Grid } else { Design::List });
    }
    section.required("points", "points = 4096, the number of points")?;
    let points = section.whole("points", 2, POINTS_LIMIT as usize)?.unwrap_or(2) as u64;
    let seed = section.whole("seed", SEEDS.from, SEEDS.to)?.unwrap_or(SEED) as u64;
    Ok(if method == Design::NAMES[2] {
        Design::LatinHypercube { points, seed }
    } else {
        Design::Sobol { points, seed }
    })
}

fn read_sensitivity(section: &Section<'_>, method: Design) -> Result<Option<Sensitivity>, Fault> {
    let Some(node) = section.get("sensitivity") else { return Ok(None) };
    let sensitivity = match &node.data {
        Data::Boolean(false) => return Ok(None),
        Data::Boolean(true) => SENSITIVITY,
        Data::Table(_) => {
            let table = section.table("sensitivity", node, &["confidence", "resamples"])?;
            let mut sensitivity = SENSITIVITY;
            if let Some(node) = table.get("confidence") {
                let key = table.path("confidence");
                let number = finite_number(&key, node)?;
                if !CONFIDENCE.contains(number) {
                    return Err(Cause::OutOfRange { key, number, range: CONFIDENCE }.at(node.place));
                }
                sensitivity.confidence = number;
            }
            let [from, to] = RESAMPLES_LIMITS;
            sensitivity.resamples = table.whole("resamples", from, to)?.unwrap_or(sensitivity.resamples);
            sensitivity
        }
        _ => return Err(wrong_type("sensitivity", "true, or a table { confidence, resamples }", node)),
    };
    match method {
        Design::Grid | Design::List => {
            Err(SweepProblem::SensitivityOf { method: method.name() }.at(node.place))
        }
        _ => Ok(Some(sensitivity)),
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
    let mut quantities = Vec::with_capacity(nodes.len());
    for node in nodes {
        let path = text("quantities", node)?;
        let quantity = QuantityPath::parse(path, analyses, case.operating_quantities());
        let quantity = match quantity.and_then(|quantity| known(quantity, case)) {
            Err(problem) if !problem.is_of_results() => return Err(problem.at(node.place)),
            quantity => quantity.map_err(|problem| problem.at(node.place)),
        };
        if paths.contains(&path) {
            return Err(SweepProblem::QuantityTwice { path: path.to_owned() }.at(node.place));
        }
        paths.push(path);
        quantities.push(quantity);
    }
    Ok(quantities)
}

/// The same, where the analysis has such a result.
fn known(quantity: QuantityPath, case: &Case) -> Result<QuantityPath, SweepProblem> {
    if let QuantitySource::Analysis { index, steps, .. } = &quantity.source {
        known_result::check(&quantity.text, steps, case.summary_keys(*index))?;
    }
    Ok(quantity)
}
