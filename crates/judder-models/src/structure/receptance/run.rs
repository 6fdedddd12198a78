//! `receptance`: each frequency solved twice, by the matrices and by their transposes.

use super::super::fields::label_shift;
use super::settings::{FreedomPlace, NotOneFreedom, ReceptanceAnalysis};
use crate::error::ModelError;
use crate::structure::build::{Structure, StructureLayout, points_of};
use crate::structure::case::StructureCase;
use crate::structure::solved_size::beside_matrices;
use crate::written::written;
use judder_exchange::ExchangeError;
use judder_exchange::geometry::Geometry;
use judder_exchange::universal::{
    Abscissa, MeasuredQuantity, Ordinates, ResponseKind, UniversalResponse, write_nodes, write_response,
    write_units,
};
use judder_keys::cause::Cause;
use judder_numerics::complex::ElementaryComplex;
use judder_store::Results;
use judder_structure::freedom::Direction;
use judder_structure::receptance::{Receptance as Found, receptances};
use judder_study::Progress;
use judder_study::outcome::{CheckRecord, Outcome};
use num_complex::Complex64;
use std::f64::consts::TAU;

/// What the backward error of the displacements may be.
const RESIDUAL_LIMIT: f64 = 1e-11;
/// What both solutions may differ by, over the largest displacement: rounding, enlarged by the condition at a resonance.
const RECIPROCITY_LIMIT: f64 = 1e-6;

/// Frequencies between two looks at whether the run shall stop.
const TOGETHER: usize = 64;

/// A degree of freedom, and the point of the layout whose it is.
#[derive(Clone, Copy)]
pub(super) struct At {
    freedom: usize,
    point: usize,
    direction: Direction,
}

/// The degree of freedom that a place under `key` names.
pub(super) fn freedom(key: &'static str, place: &FreedomPlace, structure: &Structure) -> Result<At, Cause> {
    let direction = place.direction;
    let refused = |found| Cause::from(NotOneFreedom { key, along: place.direction, found });
    let layout = structure.layout.as_ref().ok_or_else(|| refused(0))?;
    let points = points_of(&place.nodes, structure, key).map_err(|unbuilt| unbuilt.problem)?;
    let of_point = |point: &usize| {
        layout.freedoms[*point][direction as usize].map(|freedom| At { freedom, point: *point, direction })
    };
    let mut found: Vec<At> = points.iter().filter_map(of_point).collect();
    // a tied face has one freedom for all its nodes
    found.sort_by_key(|at| at.freedom);
    found.dedup_by_key(|at| at.freedom);
    match found[..] {
        [at] => Ok(at),
        _ => Err(refused(found.len())),
    }
}

/// The receptance over frequency, its largest value, and a universal file of it.
pub(super) fn run(
    case: &StructureCase,
    structure: &Structure,
    name: &str,
    asked: &ReceptanceAnalysis,
    progress: &dyn Progress,
) -> Result<Outcome, ModelError> {
    let excited = freedom("excited", &asked.excited, structure)?;
    let observed = freedom("observed", &asked.observed, structure)?;
    let problem = structure.at(case, &case.values())?;
    let frequencies = asked.frequencies();
    let memory = beside_matrices(problem.stiffness().val().len());
    let mut found = Vec::with_capacity(frequencies.len());
    for some in frequencies.chunks(TOGETHER) {
        if progress.interrupted() {
            return Err(ModelError::Interrupted);
        }
        // the last step is that of every analysis of a structure
        if !found.is_empty() {
            progress.advance();
        }
        found.extend(receptances(&problem, excited.freedom, observed.freedom, some, &memory)?);
    }
    let hertz: Vec<f64> = frequencies.iter().map(|frequency| frequency / TAU).collect();
    let values: Vec<Complex64> = found.iter().map(|own| own.value).collect();
    let missing = values.iter().filter(|value| !value.is_finite()).count();
    let files = match &structure.layout {
        Some(layout) if missing == 0 => {
            let file = written(|to| universal(to, layout, excited, observed, &hertz, &values))?;
            vec![(format!("fields/{name}.unv"), file)]
        }
        _ => Vec::new(),
    };
    Ok(Outcome {
        checks: checks(&found),
        files,
        warnings: warnings(missing),
        missing,
        ..Outcome::of(&ToldReceptance::new(hertz, values, &found))?
    })
}

/// What is told of frequencies without a receptance.
fn warnings(missing: usize) -> Vec<String> {
    let told = || {
        format!(
            "{missing} frequencies have no receptance: the structure resonates there without damping, or moves without force"
        )
    };
    (missing > 0).then(told).into_iter().collect()
}

/// What a receptance leaves.
#[derive(Results)]
#[results(along = "frequency", arrays(frequency, receptance, residual))]
pub(super) struct ToldReceptance {
    points: usize,
    /// where the receptance is largest
    peak_frequency_hz: f64,
    /// its magnitude there
    peak_m_per_n: f64,
    /// frequency of force and displacement
    #[result(hidden, unit = "Hz")]
    frequency: Vec<f64>,
    /// displacement of the observed freedom over the force at the excited one
    #[result(hidden, unit = "m/N")]
    receptance: Vec<Complex64>,
    /// backward error of the displacements
    #[result(hidden)]
    residual: Vec<f64>,
}

impl ToldReceptance {
    fn new(frequency: Vec<f64>, receptance: Vec<Complex64>, found: &[Found]) -> Self {
        let finite = frequency.iter().zip(&receptance).filter(|(_, value)| value.is_finite());
        let largest = finite.max_by(|a, b| a.1.modulus().total_cmp(&b.1.modulus()));
        let (peak_frequency_hz, peak_m_per_n) =
            largest.map_or((f64::NAN, f64::NAN), |(at, value)| (*at, value.modulus()));
        let residual = found.iter().map(|own| own.residual).collect();
        Self { points: found.len(), peak_frequency_hz, peak_m_per_n, frequency, receptance, residual }
    }
}

fn checks(found: &[Found]) -> Vec<CheckRecord> {
    let difference = |own: &Found| (own.value - own.transposed).modulus() / own.largest;
    let known = || found.iter().filter(|own| own.value.is_finite());
    vec![
        CheckRecord::new(
            "displacements satisfy (K + iωC − ω²M) u = e",
            "normalised backward error at every frequency",
            known().map(|own| own.residual).collect(),
            RESIDUAL_LIMIT,
        ),
        CheckRecord::new(
            "the transposed matrices give the same receptance",
            "difference over the largest displacement at every frequency",
            known().map(difference).collect(),
            RECIPROCITY_LIMIT,
        ),
    ]
}

/// How many steps so many frequencies are.
pub(super) fn steps(points: usize) -> usize {
    points.div_ceil(TOGETHER)
}

/// Both nodes and the response of one to the other.
fn universal(
    to: &mut dyn std::io::Write,
    layout: &StructureLayout,
    excited: At,
    observed: At,
    hertz: &[f64],
    values: &[Complex64],
) -> Result<(), ExchangeError> {
    let shift = label_shift(layout);
    let label = |at: At| layout.names[at.point] + shift;
    let mut points = vec![excited.point, observed.point];
    points.dedup();
    write_units(to)?;
    let (places, labels) =
        points.iter().map(|point| (layout.points[*point], layout.names[*point] + shift)).unzip();
    write_nodes(to, &Geometry { places, labels, cells: Vec::new() })?;
    let response = UniversalResponse {
        title: "Receptance",
        kind: ResponseKind::FrequencyResponse,
        at: (label(observed), observed.direction),
        quantity: MeasuredQuantity::Displacement,
        excited_at: Some((label(excited), excited.direction)),
        abscissa: Abscissa::Uneven(hertz),
        ordinates: Ordinates::Complex(values),
    };
    write_response(to, &response)
}
