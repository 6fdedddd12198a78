//! `modes`: undamped modes with their shapes.

use super::super::fields::{self, ModeKind, NamedShape};
use super::super::shapes;
use super::super::undamped::Undamped;
use crate::error::ModelError;
use crate::structure::build::Structure;
use crate::structure::case::StructureCase;
use judder_store::{GridValues, Results};
use judder_structure::assembly::Sparse;
use judder_structure::modes::{Mode, Modes, WantedModes, modes};
use judder_structure::quadratic::Quadratic;
use judder_structure::statics::product;
use judder_study::outcome::{CheckRecord, Disagreement, Outcome};
use num_complex::Complex64;
use std::f64::consts::TAU;

/// What the normalised backward error of a mode may be.
const RESIDUAL_LIMIT: f64 = 1e-11;
/// What shapes may leave of each other in the inner product of the mass.
const ORTHOGONALITY_LIMIT: f64 = 1e-8;

/// The modes; beside them those of a reduction of the structure, where its eigenvalues ω², 1/s², are given.
pub(crate) fn run(
    case: &StructureCase,
    structure: &Structure,
    name: &str,
    wanted: super::ModesAnalysis,
    reduced: Option<&[f64]>,
) -> Result<Outcome, ModelError> {
    let problem = structure.at(case, &case.values())?;
    let Undamped { mass, stiffness, of } = Undamped::new(case, structure)?;
    let wanted = wanted.wanted();
    let found = modes(&stiffness, &mass, wanted)?;
    let frequency: Vec<f64> = found.modes.iter().map(Mode::frequency_hz).collect();
    let (count, rigid, ratios) = (frequency.len(), found.rigid_modes(), damping_ratios(&problem, &found));
    let (limit, counted) = found.counted;
    let told = ToldModes {
        mode: (1..=count as i64).collect(),
        residual: found.modes.iter().map(|mode| mode.residual).collect(),
        mac: GridValues { shape: vec![count; 2], values: shapes::mac(&found.modes) },
        rigid_modes: rigid,
        counted: Counted { below_hz: limit.max(0.0).sqrt() / TAU, modes: counted },
        degrees_of_freedom: problem.size(),
        modes_of: of.name(),
        damping_ratio: ratios.clone(),
        reduced: reduced.map(|eigenvalues| ReducedModes::new(&found, eigenvalues)),
        frequency,
    };
    let Outcome { scalars, mut dataset, table, .. } = Outcome::of(&told)?;
    let fewer = match wanted {
        WantedModes::Lowest(asked) => fewer(count, asked, problem.size()),
        WantedModes::Band(..) => None,
    };
    let mut warnings: Vec<String> = of.warning("the modes are those").into_iter().chain(fewer).collect();
    if let Some(layout) = &structure.layout {
        let vectors: Vec<&[f64]> = found.modes.iter().map(|mode| &mode.shape[..]).collect();
        dataset = shapes::with_layout(dataset, layout)?;
        dataset = shapes::with_real(dataset, layout, &vectors, &mut warnings)?;
    }
    let swinging = |(k, mode): (usize, &Mode)| {
        let ratio = ratios.as_ref().map_or(0.0, |ratios| ratios[k]);
        swinging(k, mode, (k >= rigid).then_some(ratio))
    };
    let shapes: Vec<NamedShape> = found.modes.iter().enumerate().map(swinging).collect();
    let files = fields::fields(name, structure.layout.as_ref(), structure.mesh(), &shapes)?;
    let checks = checks(&mass, &found, wanted);
    Ok(Outcome { scalars, dataset, table, checks, files, warnings, ..Outcome::default() })
}

/// That there are fewer modes than are asked for.
fn fewer(found: usize, asked: usize, freedoms: usize) -> Option<String> {
    let reason = match freedoms < asked {
        true => format!("the structure has {freedoms} degrees of freedom"),
        false => format!("the mass is singular: of {freedoms} degrees of freedom {found} have modes"),
    };
    (found < asked).then(|| format!("{asked} modes are asked for, and there are {found}: {reason}"))
}

/// What is told of the modes.
#[derive(Results)]
#[results(
    along = "mode",
    arrays(mode, frequency, residual, mac, damping_ratio, reduced),
    columns(mode, frequency, residual, damping_ratio, reduced)
)]
pub(crate) struct ToldModes {
    /// number of the mode
    #[result(hidden)]
    mode: Vec<i64>,
    /// natural frequency
    #[result(summary = "frequencies_hz", unit = "Hz")]
    frequency: Vec<f64>,
    /// normalised backward error
    #[result(summary = "residuals")]
    residual: Vec<f64>,
    /// modal assurance criterion of two shapes
    #[result(hidden, along = "mode other_mode")]
    mac: GridValues<f64>,
    rigid_modes: usize,
    /// how many modes a factorisation counts
    counted: Counted,
    degrees_of_freedom: usize,
    /// of what matrices the modes are
    #[result(attribute)]
    modes_of: &'static str,
    /// modal damping ratio ζ
    #[result(summary = "damping_ratios", optional)]
    damping_ratio: Option<Vec<f64>>,
    #[result(flatten)]
    reduced: Option<ReducedModes>,
}

/// How many modes there are below a frequency.
#[derive(Results)]
struct Counted {
    below_hz: f64,
    modes: usize,
}

/// Modes of a reduction, each beside that of the full structure: the n-th beside the n-th, since a reduction lies above it.
#[derive(Results)]
#[results(
    along = "mode",
    arrays(reduced_frequency, reduction_error),
    columns(reduced_frequency, reduction_error)
)]
struct ReducedModes {
    /// natural frequency of the reduced structure
    #[result(summary = "reduced_hz", unit = "Hz")]
    reduced_frequency: Vec<f64>,
    /// reduced less full frequency, over the reduced one
    #[result(summary = "reduction_errors")]
    reduction_error: Vec<f64>,
}

impl ReducedModes {
    /// Frequencies are not numbers where the reduction has no such mode, errors are none of rigid motions either.
    fn new(found: &Modes, eigenvalues: &[f64]) -> Self {
        let first = found.counted_from.1;
        let frequency =
            |k: usize| eigenvalues.get(first + k).map_or(f64::NAN, |own| own.max(0.0).sqrt() / TAU);
        let frequencies: Vec<f64> = (0..found.modes.len()).map(frequency).collect();
        let rigid = found.rigid_modes();
        let error = |(k, mode): (usize, &Mode)| {
            let reduced = frequencies[k];
            if k < rigid { f64::NAN } else { (reduced - mode.frequency_hz()) / reduced }
        };
        let reduction_error = found.modes.iter().enumerate().map(error).collect();
        Self { reduced_frequency: frequencies, reduction_error }
    }
}

/// A mode for the files of its shape, with its damping ratio; a rigid motion has none and does not swing.
fn swinging(number: usize, mode: &Mode, ratio: Option<f64>) -> NamedShape {
    let frequency = mode.frequency_hz();
    let name = format!("mode {} ({frequency:.6} Hz)", number + 1);
    let vector = mode.shape.iter().map(|u| Complex64::from(*u)).collect();
    let frequency = if ratio.is_some() { frequency } else { 0.0 };
    NamedShape { name, vector, frequency, mode: ModeKind::Real { damping_ratio: ratio.unwrap_or(0.0) } }
}

/// ζ = φᵀCφ/(2ω) of mass-normalised shapes, NaN for rigid motions; `None` without damping.
fn damping_ratios(problem: &Quadratic, found: &Modes) -> Option<Vec<f64>> {
    if problem.damping().val().iter().all(|value| *value == 0.0) {
        return None;
    }
    let rigid = found.rigid_modes();
    let ratio = |(k, mode): (usize, &Mode)| {
        let image = product(problem.damping(), &mode.shape);
        let work: f64 = mode.shape.iter().zip(&image).map(|(a, b)| a * b).sum();
        if k < rigid { f64::NAN } else { work / (2.0 * TAU * mode.frequency_hz()) }
    };
    Some(found.modes.iter().enumerate().map(ratio).collect())
}

fn checks(mass: &Sparse, found: &Modes, wanted: WantedModes) -> Vec<CheckRecord> {
    let modes = &found.modes;
    let counted = found.counted.1 - found.counted_from.1.min(found.counted.1);
    let expected = match wanted {
        WantedModes::Lowest(count) => counted.min(count),
        WantedModes::Band(..) => counted,
    };
    let mut checks = vec![CheckRecord::new(
        "no mode is missing",
        format!("modes found against {counted} that factorisations count"),
        (expected.abs_diff(modes.len()) as f64).into(),
        0.0,
    )];
    // a band may have no modes
    if !modes.is_empty() {
        checks.push(CheckRecord::new(
            "modes satisfy K φ = ω² M φ",
            format!("normalised backward error of {} modes", modes.len()),
            modes.iter().map(|mode| mode.residual).collect(),
            RESIDUAL_LIMIT,
        ));
        checks.push(CheckRecord::new(
            "shapes are orthogonal",
            "largest entry of Φᵀ M Φ − I",
            departure_from_orthogonality(mass, modes),
            ORTHOGONALITY_LIMIT,
        ));
    }
    checks
}

fn departure_from_orthogonality(mass: &Sparse, modes: &[Mode]) -> Disagreement {
    let mut departure = Disagreement::default();
    for (i, mode) in modes.iter().enumerate() {
        let image = product(mass, &mode.shape);
        for (j, other) in modes.iter().enumerate().take(i + 1) {
            let entry: f64 = image.iter().zip(&other.shape).map(|(a, b)| a * b).sum();
            departure.add((entry - f64::from(u8::from(i == j))).abs());
        }
    }
    departure
}
