//! `modes`: undamped modes with their shapes.

use super::super::fields::{self, ModeKind, Shape};
use super::super::shapes;
use super::super::undamped::Undamped;
use crate::error::ModelError;
use crate::structure::build::Structure;
use crate::structure::case::StructureCase;
use judder_store::{Dataset, Table, Variable, number};
use judder_structure::assembly::Sparse;
use judder_structure::modes::{Mode, Modes, WantedModes, modes};
use judder_structure::quadratic::Quadratic;
use judder_structure::statics::product;
use judder_study::outcome::{CheckRecord, Disagreement, Outcome};
use num_complex::Complex64;
use serde_json::{Map, Value, json};
use std::f64::consts::TAU;

/// What the normalised backward error of a mode may be.
const RESIDUAL_LIMIT: f64 = 1e-11;
/// What shapes may leave of each other in the inner product of the mass.
const ORTHOGONALITY_LIMIT: f64 = 1e-8;
/// The modes; beside them those of a reduction of the structure, where its eigenvalues ω², 1/s², are given.
pub(crate) fn run(
    (case, structure): (&StructureCase, &Structure),
    name: &str,
    wanted: super::Modes,
    reduced: Option<&[f64]>,
) -> Result<Outcome, ModelError> {
    let problem = structure.at(case, &case.values())?;
    let Undamped { mass, stiffness, of } = Undamped::new(case, structure)?;
    let wanted = match wanted {
        super::Modes::Count(count) => WantedModes::Lowest(count),
        super::Modes::Band([from, to]) => WantedModes::Band(from / TAU, to / TAU),
    };
    let found = modes(&stiffness, &mass, wanted)?;
    let table = ModeTable {
        frequencies: found.modes.iter().map(Mode::frequency_hz).collect(),
        residuals: found.modes.iter().map(|mode| mode.residual).collect(),
        ratios: damping_ratios(&problem, &found),
        reduced: reduced.map(|eigenvalues| Reduced::new(&found, eigenvalues)),
    };
    let rigid = found.rigid_modes();
    let mut scalars = Map::from_iter([
        ("frequencies_hz".to_owned(), json!(table.frequencies)),
        ("residuals".to_owned(), json!(table.residuals)),
        ("rigid_modes".to_owned(), json!(rigid)),
        ("counted".to_owned(), counted(&found)),
        ("degrees_of_freedom".to_owned(), json!(problem.size())),
        ("modes_of".to_owned(), json!(of.name())),
    ]);
    if let Some(ratios) = &table.ratios {
        scalars.insert("damping_ratios".to_owned(), ratios.iter().map(|ratio| number(*ratio)).collect());
    }
    if let Some(reduced) = &table.reduced {
        let numbers = |values: &[f64]| values.iter().map(|value| number(*value)).collect();
        scalars.insert("reduced_hz".to_owned(), numbers(&reduced.frequencies));
        scalars.insert("reduction_errors".to_owned(), numbers(&reduced.errors));
    }
    let mut warnings: Vec<String> = of.warning("the modes are those").into_iter().collect();
    let mut dataset = table.dataset(&found.modes)?.attribute("modes_of", of.name())?;
    if let Some(layout) = &structure.layout {
        let vectors: Vec<&[f64]> = found.modes.iter().map(|mode| &mode.shape[..]).collect();
        dataset = shapes::with_layout(dataset, layout)?;
        dataset = shapes::with_real(dataset, layout, &vectors, &mut warnings)?;
    }
    let swinging = |(k, mode): (usize, &Mode)| {
        let ratio = table.ratios.as_ref().map_or(0.0, |ratios| ratios[k]);
        swinging(k, mode, (k >= rigid).then_some(ratio))
    };
    let shapes: Vec<Shape> = found.modes.iter().enumerate().map(swinging).collect();
    let files = fields::fields(name, structure, &shapes)?;
    let checks = checks(&mass, &found, wanted);
    Ok(Outcome {
        scalars,
        dataset,
        table: Some(table.columns()?),
        checks,
        files,
        warnings,
        ..Outcome::default()
    })
}

/// How many modes a factorisation counts, and below which frequency.
fn counted(found: &Modes) -> Value {
    let (limit, modes) = found.counted;
    json!({ "below_hz": number(limit.max(0.0).sqrt() / TAU), "modes": modes })
}

/// What is told of every mode.
struct ModeTable {
    frequencies: Vec<f64>,
    residuals: Vec<f64>,
    /// Damping ratios, where there is damping.
    ratios: Option<Vec<f64>>,
    /// The same modes of the reduced structure, where there is one.
    reduced: Option<Reduced>,
}

/// Modes of a reduction, each beside that of the full structure: the n-th beside the n-th, since a reduction lies above it.
struct Reduced {
    /// Hz; NaN where the reduction has no such mode.
    frequencies: Vec<f64>,
    /// Reduced less full, over reduced; NaN for rigid motions too.
    errors: Vec<f64>,
}

impl Reduced {
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
        let errors = found.modes.iter().enumerate().map(error).collect();
        Self { frequencies, errors }
    }

    /// Name, unit, meaning and values of what is told of them.
    fn columns(&self) -> [(&'static str, &'static str, &'static str, &[f64]); 2] {
        [
            ("reduced_frequency", "Hz", "natural frequency of the reduced structure", &self.frequencies),
            ("reduction_error", "1", "reduced less full frequency, over the reduced one", &self.errors),
        ]
    }
}

impl ModeTable {
    fn numbers(&self) -> Vec<i64> {
        (1..=self.frequencies.len() as i64).collect()
    }

    fn dataset(&self, modes: &[Mode]) -> Result<Dataset, ModelError> {
        let count = self.frequencies.len();
        let modal = |name: &str, values: &[f64]| Variable::new(name, &["mode"], &[count], values.to_vec());
        let mac = Variable::new("mac", &["mode", "other_mode"], &[count, count], shapes::mac(modes));
        let dataset = Dataset::new()
            .attribute("kind", "modes")?
            .with(Variable::coordinate("mode", self.numbers()).long_name("number of the mode"))?
            .with(modal("frequency", &self.frequencies).units("Hz").long_name("natural frequency"))?
            .with(modal("residual", &self.residuals).units("1").long_name("normalised backward error"))?
            .with(mac.units("1").long_name("modal assurance criterion of two shapes"))?;
        let mut dataset = dataset;
        if let Some(ratios) = &self.ratios {
            let ratios = modal("damping_ratio", ratios).units("1").long_name("modal damping ratio ζ");
            dataset = dataset.with(ratios)?;
        }
        for (name, unit, long_name, values) in self.reduced.iter().flat_map(Reduced::columns) {
            dataset = dataset.with(modal(name, values).units(unit).long_name(long_name))?;
        }
        Ok(dataset)
    }

    fn columns(&self) -> Result<Table, ModelError> {
        let mut table = Table::new()
            .column("mode", "1", self.numbers())?
            .column("frequency", "Hz", self.frequencies.clone())?
            .column("residual", "1", self.residuals.clone())?;
        if let Some(ratios) = &self.ratios {
            table = table.column("damping_ratio", "1", ratios.clone())?;
        }
        for (name, unit, _, values) in self.reduced.iter().flat_map(Reduced::columns) {
            table = table.column(name, unit, values.to_vec())?;
        }
        Ok(table)
    }
}

/// A mode for the files of its shape, with its damping ratio; a rigid motion has none and does not swing.
fn swinging(number: usize, mode: &Mode, ratio: Option<f64>) -> Shape {
    let frequency = mode.frequency_hz();
    let name = format!("mode {} ({frequency:.6} Hz)", number + 1);
    let vector = mode.shape.iter().map(|u| Complex64::from(*u)).collect();
    let frequency = if ratio.is_some() { frequency } else { 0.0 };
    Shape { name, vector, frequency, mode: ModeKind::Real { damping_ratio: ratio.unwrap_or(0.0) } }
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
