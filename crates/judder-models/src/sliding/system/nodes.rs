//! The nodes that a sliding case names, and the freedoms that each structure has to keep for them.

use super::Uncoupled;
use crate::sliding::case::SlidingCase;
use crate::sliding::case::observe::PointNode;
use crate::sliding::case::problem::SlidingProblem;
use crate::structure::build::{Structure, freedoms_of, points_of};
use crate::structure::case::reduction::KeptNodes;
use judder_sliding::march::most_observed;
use judder_sliding::pair::PairSide;

/// Points of the structures' layouts, and freedoms.
pub(super) struct SystemNodes {
    /// C, of the slider.
    pub(super) contact: usize,
    /// The nodes of the track in the order of their set.
    pub(super) track: Vec<usize>,
    /// The freedom of the slider on which the load acts.
    pub(super) load: usize,
    /// The observed points, each of its structure.
    pub(super) observed: Vec<usize>,
    /// For each structure the freedoms that are kept, each once.
    pub(super) freedoms: [Vec<usize>; 2],
}

impl SystemNodes {
    /// Looks all of them up.
    pub(super) fn new(case: &SlidingCase, structures: [&Structure; 2]) -> Result<Self, Uncoupled> {
        let [slider, track] = [*case.contact.slider.structure, *case.contact.track.structure];
        let contact = one(
            points_of(&case.contact.slider.nodes, structures[slider], "contact.slider")?,
            "contact.slider",
        )?;
        let edge = points_of(&case.contact.track.nodes, structures[track], "contact.track")?;
        let load = loaded(case, structures[slider])?;
        let observed = case.points.iter().map(|point| {
            let path = format!("observe.points.{}", point.name);
            let structure = structures[*point.structure];
            match &point.node {
                PointNode::At(place) => nearest(structure, *place, &path),
                PointNode::Kept(nodes) => one(points_of(nodes, structure, &path)?, &path),
            }
        });
        let observed = observed.collect::<Result<Vec<usize>, Uncoupled>>()?;
        check_count(case)?;
        if plane(structures[slider], contact).is_empty() {
            return Err(Uncoupled::because(
                "contact.slider",
                "C is held along x and y: it can neither be pressed on the track nor leave it",
                "name a node of the slider that is free",
            ));
        }
        let mut freedoms = [vec![], vec![]];
        freedoms[slider].push(load);
        freedoms[slider].extend(plane(structures[slider], contact));
        freedoms[track].extend(edge.iter().flat_map(|point| plane(structures[track], *point)));
        for (point, at) in case.points.iter().zip(&observed) {
            let structure = *point.structure;
            freedoms[structure].extend(plane(structures[structure], *at));
        }
        for (index, own) in case.structures.iter().enumerate() {
            let more = freedoms_of(&own.reduction, structures[index])
                .map_err(|unbuilt| unbuilt.of_structure(&own.name))?;
            freedoms[index].extend(more);
        }
        let freedoms = freedoms.map(each_once);
        Ok(Self { contact, track: edge, load, observed, freedoms })
    }
}

/// The free displacements of a point along x and y.
fn plane(structure: &Structure, point: usize) -> Vec<usize> {
    let of = |point: &[Option<usize>; 3]| point[..2].iter().copied().flatten().collect();
    structure.layout.as_ref().and_then(|layout| layout.freedoms.get(point)).map(of).unwrap_or_default()
}

fn each_once(freedoms: Vec<usize>) -> Vec<usize> {
    let mut seen = std::collections::BTreeSet::new();
    freedoms.into_iter().filter(|freedom| seen.insert(*freedom)).collect()
}

fn one(points: Vec<usize>, path: &str) -> Result<usize, Uncoupled> {
    match points[..] {
        [point] => Ok(point),
        _ => {
            let problem = SlidingProblem::NotOneNode { key: path.to_owned(), found: points.len() };
            Err(Uncoupled::new(path, problem))
        }
    }
}

/// The node nearest to a place in the plane; it may be as far away as a twentieth of the structure's size, which no slip of a unit is.
fn nearest(structure: &Structure, place: [f64; 2], path: &str) -> Result<usize, Uncoupled> {
    let points = structure.layout.as_ref().map_or(&[][..], |layout| &layout.points);
    let apart = |a: &[f64; 3], b: [f64; 2]| libm::hypot(a[0] - b[0], a[1] - b[1]);
    let nearest = points.iter().enumerate().min_by(|a, b| apart(a.1, place).total_cmp(&apart(b.1, place)));
    let Some((number, at)) = nearest else {
        let (reason, advice) = ("has no places of nodes", "name the node by nodes = [17]");
        return Err(Uncoupled::because(path, format!("the structure {reason}"), advice));
    };
    let nearest = [at[0], at[1]];
    let size = points.iter().map(|point| apart(point, nearest)).fold(0.0, f64::max);
    if apart(at, place) <= 0.05 * size {
        return Ok(number);
    }
    let problem = SlidingProblem::NoNodeThere { key: format!("{path}.at"), place, nearest };
    Err(Uncoupled::new(format!("{path}.at"), problem))
}

/// Refuses more points than a march watches.
fn check_count(case: &SlidingCase) -> Result<(), Uncoupled> {
    let interpolation = case.contact.interpolation;
    for (index, structure) in case.structures.iter().enumerate() {
        let side = if index == *case.contact.slider.structure { PairSide::Slider } else { PairSide::Track };
        let limit = most_observed(side, interpolation) / 2;
        let found = case.points.iter().filter(|point| *point.structure == index).count();
        if found > limit {
            let problem =
                SlidingProblem::TooManyPoints { structure: structure.name.to_string(), found, limit };
            return Err(Uncoupled::new("observe.points", problem));
        }
    }
    Ok(())
}

/// The one freedom that all loaded nodes share.
fn loaded(case: &SlidingCase, slider: &Structure) -> Result<usize, Uncoupled> {
    let load = &case.motion.load;
    let points = points_of(&load.nodes, slider, "motion.load")?;
    let axis = load.direction as usize;
    let freedoms = slider
        .layout
        .as_ref()
        .map(|layout| points.iter().filter_map(|point| layout.freedoms[*point][axis]).collect::<Vec<_>>());
    let freedoms = each_once(freedoms.unwrap_or_default());
    let (name, along) = (name(&load.nodes), load.direction.name());
    match freedoms[..] {
        [freedom] => Ok(freedom),
        [] => Err(Uncoupled::because(
            "motion.load",
            format!("`{name}` is held along {along}: a load there moves nothing"),
            "free it, or load another set",
        )),
        _ => Err(Uncoupled::because(
            "motion.load",
            format!(
                "the {} nodes of `{name}` move along {along} each on its own, but one load acts on one freedom",
                freedoms.len()
            ),
            "tie them along the load, as start = \"guided\" of a beam does, or name a set of one node",
        )),
    }
}

/// Nodes as a case has them.
pub(super) fn name(nodes: &KeptNodes) -> String {
    match nodes {
        KeptNodes::Set(set) => set.clone(),
        KeptNodes::Numbers(numbers) => numbers.iter().map(usize::to_string).collect::<Vec<_>>().join(", "),
    }
}
