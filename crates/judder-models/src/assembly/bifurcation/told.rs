//! What is told and stored of limit cycles along a key.

use super::CycleDiagram;
use super::named::{KINDS, NamedBifurcation, hopf_point, named};
use crate::assembly::limit_cycle::search::is_converged;
use crate::assembly::limit_cycle::stability::{KnownStability, with_multipliers};
use crate::error::ModelError;
use judder_cycles::branch::{AssemblyCycleBranch, CycleAtKey, CycleBranchEnd};
use judder_store::{Dataset, Results, Variable};
use judder_study::labels::{SweptQuantity, any_key};
use judder_study::shown::SHOWN_UNIT;
use std::f64::consts::TAU;

/// A cycle as it is told.
pub(super) struct KnownCycle {
    pub(super) value: f64,
    /// In rad/s.
    pub(super) frequency: f64,
    /// In m/s.
    pub(super) rms: f64,
    pub(super) stick: f64,
    pub(super) open: f64,
    pub(super) left_out: f64,
    pub(super) residual: f64,
    pub(super) stability: KnownStability,
}

/// What is told of a branch.
#[derive(Results)]
pub(super) struct ToldCycleBranch {
    /// the swept key
    key: String,
    /// its unit
    unit: String,
    /// the unit in which the case has its values, in which tables and figures show them
    shown_unit: String,
    /// its value at each cycle, in the order along the branch
    value: Vec<f64>,
    /// the frequency of each cycle, in Hz
    frequency_hz: Vec<f64>,
    /// the root mean square over all contact points of the velocity along the slip about its mean
    #[result(unit = "m/s")]
    rms: Vec<f64>,
    /// the share of the period in which points stick, on average over them
    stick_share: Vec<f64>,
    /// in which they are open
    open_share: Vec<f64>,
    /// whether motions nearby are drawn to it, where that is known
    stable: Vec<Option<bool>>,
    /// values at which the branch turns, by a search between its cycles
    folds: Vec<f64>,
    /// values at which it shrinks to steady sliding, where an eigenvalue begins to grow
    hopf_points: Vec<f64>,
    /// where cycles of other branches, or other motions, come in, by name, in the order along the branch
    pub(super) bifurcations: Vec<NamedBifurcation>,
    /// how it ends on either side, in words
    ends: Vec<String>,
    /// harmonics of the cycles
    harmonics: usize,
    /// the largest share of the swing of the contact forces that harmonics leave out
    #[result(unit = "1")]
    left_out: Option<f64>,
    /// whether they leave no more than a tenth out, of each cycle
    converged: Vec<bool>,
}

fn end(branch: &AssemblyCycleBranch, hopf: &[&CycleAtKey]) -> String {
    let is_hopf = branch.cycles.last().is_some_and(|last| hopf.contains(&last));
    match &branch.end {
        CycleBranchEnd::Range => "leaves the range".to_owned(),
        CycleBranchEnd::Points => "goes on: as many cycles as were asked for".to_owned(),
        CycleBranchEnd::SteadySliding if is_hopf => "shrinks to steady sliding".to_owned(),
        CycleBranchEnd::SteadySliding => "shrinks below 2 % of its largest amplitude".to_owned(),
        CycleBranchEnd::Lost(error) => format!("lost: {error}"),
    }
}

fn quantity(asked: &CycleDiagram) -> SweptQuantity {
    SweptQuantity { name: "value".to_owned(), ..any_key(&asked.sweep.path, asked.sweep.dimension) }
}

impl ToldCycleBranch {
    /// No branch.
    pub(super) fn none(asked: &CycleDiagram) -> Self {
        Self {
            key: asked.sweep.path.clone(),
            unit: quantity(asked).unit,
            shown_unit: asked.sweep.shown_unit(),
            value: Vec::new(),
            frequency_hz: Vec::new(),
            rms: Vec::new(),
            stick_share: Vec::new(),
            open_share: Vec::new(),
            stable: Vec::new(),
            folds: Vec::new(),
            hopf_points: Vec::new(),
            bifurcations: Vec::new(),
            ends: Vec::new(),
            harmonics: asked.harmonics,
            left_out: None,
            converged: Vec::new(),
        }
    }

    pub(super) fn new(
        asked: &CycleDiagram,
        known: &[KnownCycle],
        ways: [&AssemblyCycleBranch; 2],
        fold_errors: &[Vec<f64>; 2],
        hopf: &[&CycleAtKey],
    ) -> Self {
        let all = |of: fn(&KnownCycle) -> f64| known.iter().map(of).collect::<Vec<f64>>();
        Self {
            value: all(|own| own.value),
            frequency_hz: all(|own| own.frequency / TAU),
            rms: all(|own| own.rms),
            stick_share: all(|own| own.stick),
            open_share: all(|own| own.open),
            stable: known.iter().map(|own| own.stability.is_stable()).collect(),
            folds: ways.iter().flat_map(|way| way.folds.iter().map(|(_, value)| *value)).collect(),
            hopf_points: hopf.iter().map(|own| hopf_point(own, ways)).collect(),
            bifurcations: named(known, ways, fold_errors, hopf),
            ends: ways.map(|way| end(way, hopf)).to_vec(),
            left_out: all(|own| own.left_out).into_iter().reduce(f64::max),
            converged: known.iter().map(|own| is_converged(own.left_out)).collect(),
            ..Self::none(asked)
        }
    }

    /// What is to be said of branch points that kinks make doubtful.
    pub(super) fn kinks(&self) -> Option<String> {
        let doubtful = self.bifurcations.iter().filter(|own| own.is_kink()).count();
        (doubtful > 0).then(|| {
            format!(
                "at {doubtful} places along the branch cycles of another one may cross, or points change what they do there: the determinant changes its sign in both cases"
            )
        })
    }

    /// What is to be said of folds of which it is not known what harmonics leave out.
    pub(super) fn folds_alone(&self) -> Option<String> {
        let alone = self.bifurcations.iter().filter(|own| own.is_fold() && own.error.is_none()).count();
        (alone > 0).then(|| {
            format!("what {alone} folds may be off is not known: they are not found with twice the harmonics")
        })
    }

    /// What is to be said of branches that were lost, or go on.
    pub(super) fn words(ways: [&AssemblyCycleBranch; 2]) -> Vec<String> {
        let told =
            |way: &&AssemblyCycleBranch| matches!(way.end, CycleBranchEnd::Lost(_) | CycleBranchEnd::Points);
        let sides = ["where the key falls from the first cycle", "where it rises"];
        let words = ways.iter().zip(sides).filter(|(way, _)| told(way));
        words.map(|(way, side)| format!("{side}, the branch of cycles {}", end(way, &[]))).collect()
    }
}

/// Every array.
pub(super) fn dataset(
    asked: &CycleDiagram,
    known: &[KnownCycle],
    bifurcations: &[NamedBifurcation],
) -> Result<Dataset, ModelError> {
    let quantity = quantity(asked);
    let along = |name: &str, values: Vec<f64>| Variable::new(name, &["cycle"], &[values.len()], values);
    let all = |of: fn(&KnownCycle) -> f64| known.iter().map(of).collect::<Vec<f64>>();
    let dataset = Dataset::new()
        .with(
            along("value", all(|own| own.value))
                .units(&quantity.unit)
                .long_name(&asked.sweep.path)
                .attribute("label", quantity.label.as_str())
                .attribute("scale", asked.sweep.scale.name())
                .attribute(SHOWN_UNIT, asked.sweep.shown_unit()),
        )?
        .with(
            along("rms", all(|own| own.rms))
                .units("m/s")
                .long_name(
                    "root mean square over all contact points of the velocity along the slip about its mean",
                )
                .attribute("label", "Velocity along the slip, rms (m/s)"),
        )?
        .with(
            along("frequency", all(|own| own.frequency / TAU))
                .units("Hz")
                .long_name("frequency of the cycle")
                .attribute("label", "Frequency (Hz)"),
        )?
        .with(
            along("stick_share", all(|own| own.stick))
                .units("1")
                .long_name("share of the period in which points stick, on average over them"),
        )?
        .with(
            along("open_share", all(|own| own.open))
                .units("1")
                .long_name("share of the period in which points are open, on average over them"),
        )?
        .with(
            along("left_out", all(|own| own.left_out))
                .units("1")
                .long_name("share of the swing of the contact forces that harmonics leave out"),
        )?;
    let stabilities: Vec<&KnownStability> = known.iter().map(|own| &own.stability).collect();
    with_bifurcations(with_multipliers(dataset, "cycle", &stabilities)?, bifurcations)
}

/// Where bifurcations lie in the figure.
fn with_bifurcations(dataset: Dataset, bifurcations: &[NamedBifurcation]) -> Result<Dataset, ModelError> {
    let along = |name: &str, of: &dyn Fn(&NamedBifurcation) -> f64| {
        let values: Vec<f64> = bifurcations.iter().map(of).collect();
        Variable::new(name, &["bifurcation"], &[values.len()], values)
    };
    let codes: Vec<u8> = bifurcations.iter().map(NamedBifurcation::code).collect();
    let words: Vec<String> = KINDS.iter().enumerate().map(|(code, kind)| format!("{code} {kind}")).collect();
    Ok(dataset
        .with(along("bifurcation_value", &|own| own.value).long_name("value of the key at each bifurcation"))?
        .with(along("bifurcation_rms", &|own| own.rms).units("m/s").long_name("rms of the cycle before it"))?
        .with(
            along("bifurcation_frequency", &|own| own.frequency_hz)
                .units("Hz")
                .long_name("frequency of the cycle before it"),
        )?
        .with(
            Variable::new("bifurcation_kind", &["bifurcation"], &[codes.len()], codes)
                .long_name(&words.join(", ")),
        )?)
}
