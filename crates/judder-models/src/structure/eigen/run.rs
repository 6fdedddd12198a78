//! `eigen`: all complex modes in a region, each with its error.

use super::super::fields::{self, ModeKind, Shape};
use super::super::shapes;
use super::diagnosis;
use crate::error::ModelError;
use crate::structure::build::Structure;
use crate::structure::case::StructureCase;
use crate::structure::eigen::EigenRegion;
use judder_store::{Dataset, Table, Variable, number};
use judder_structure::assembly::Sparse;
use judder_structure::complex_modes::{
    ComplexMode, ComplexModeSettings, ComplexModes, Eigenvalue, EigenvalueVerdict, Gap, Region, complex_modes,
};
use judder_structure::quadratic::Quadratic;
use judder_structure::statics::product;
use judder_study::outcome::{CheckRecord, Outcome};
use num_complex::Complex64;
use serde_json::{Map, Value, json};

/// What the normalised backward error of an eigenpair may be.
const RESIDUAL_LIMIT: f64 = 1e-12;
/// The verdicts as codes of arrays.
pub(crate) const VERDICTS: [(u8, &str); 3] = [(0, "stable"), (1, "marginal"), (2, "unstable")];

pub(crate) fn code(verdict: EigenvalueVerdict) -> u8 {
    match verdict {
        EigenvalueVerdict::Stable => 0,
        EigenvalueVerdict::Marginal => 1,
        EigenvalueVerdict::Unstable => 2,
    }
}

/// The region of a case as the engine takes it.
pub(crate) fn region(region: &EigenRegion) -> Region {
    Region { re: region.re, im: region.im }
}

pub(crate) fn run(
    (case, structure): (&StructureCase, &Structure),
    name: &str,
    sought: &EigenRegion,
) -> Result<Outcome, ModelError> {
    let problem = structure.at(case, &case.values())?;
    let mut found = complex_modes(&problem, &region(sought), &ComplexModeSettings::default())?;
    found.modes.sort_by(|a, b| in_order(&a.eigenvalue, &b.eigenvalue));
    let values: Vec<Eigenvalue> = found.modes.iter().map(|mode| mode.eigenvalue).collect();
    let unstable = values.iter().filter(|value| value.verdict() == EigenvalueVerdict::Unstable).count();
    let mut scalars = Map::from_iter([
        ("eigenvalues".to_owned(), values.iter().map(entry).collect::<Value>()),
        ("complete".to_owned(), json!(found.complete())),
        ("unstable".to_owned(), json!(unstable)),
        ("degrees_of_freedom".to_owned(), json!(problem.size())),
        ("shifts".to_owned(), json!(found.shifts.len())),
    ]);
    let mut warnings = gap_warnings(&found.gaps);
    if values.is_empty() && found.complete() {
        warnings.push("the region has no eigenvalue".to_owned());
    }
    let mut checks = checks(&found);
    if let Some(told) = diagnosis::of_growing(case, structure, sought, &found.modes)? {
        scalars.insert("diagnosis".to_owned(), told.scalars);
        warnings.extend(told.warnings);
        checks.push(told.check);
    }
    let shapes: Vec<Vec<Complex64>> = found.modes.iter().map(|mode| of_largest_one(&mode.right)).collect();
    let mut dataset = dataset(&values, sought)?.with(
        Variable::new("mac", &["mode", "other_mode"], &[values.len(); 2], shapes::complex_mac(&shapes))
            .units("1")
            .long_name("modal assurance criterion of two shapes"),
    )?;
    if let Some(layout) = &structure.layout {
        dataset = shapes::with_layout(dataset, layout)?;
        dataset = shapes::with_complex(dataset, layout, &shapes, &mut warnings)?;
    }
    let swinging = |(k, (mode, vector)): (usize, (&ComplexMode, Vec<Complex64>))| {
        let (value, frequency) = (mode.eigenvalue.value, mode.eigenvalue.frequency_hz());
        let name = format!("mode {} ({:.6} + {:.6} i 1/s)", k + 1, value.re, value.im);
        let modal_a = modal_a(&problem, mode, &vector);
        Shape { name, vector, frequency, mode: ModeKind::Complex { eigenvalue: value, modal_a } }
    };
    let shapes: Vec<Shape> = found.modes.iter().zip(shapes).enumerate().map(swinging).collect();
    Ok(Outcome {
        scalars,
        dataset,
        table: Some(table(&values)?),
        checks,
        missing: usize::from(!found.complete()),
        warnings,
        files: fields::fields(name, structure, &shapes)?,
        ..Outcome::default()
    })
}

/// By imaginary, then by real part.
pub(crate) fn in_order(a: &Eigenvalue, b: &Eigenvalue) -> std::cmp::Ordering {
    a.value.im.total_cmp(&b.value.im).then(a.value.re.total_cmp(&b.value.re))
}

/// An eigenvalue for `summary.json`.
pub(crate) fn entry(value: &Eigenvalue) -> Value {
    json!({
        "re": value.value.re, "im": value.value.im, "residual": value.residual, "left_residual": value.left_residual,
        "verdict": value.verdict().name(), "error": number(value.error), "condition": number(value.condition),
        "defective": value.defective, "frequency_hz": value.frequency_hz(), "damping_ratio": number(value.damping_ratio()),
    })
}

/// Why there may be more eigenvalues.
pub(crate) fn gap_warnings(gaps: &[Gap]) -> Vec<String> {
    const SHOWN: usize = 5;
    let mut warnings: Vec<String> =
        gaps.iter().take(SHOWN).map(|gap| format!("eigenvalues may be missing: {gap}")).collect();
    if gaps.len() > SHOWN {
        warnings.push(format!("eigenvalues may be missing at {} more places", gaps.len() - SHOWN));
    }
    warnings
}

/// A shape whose largest entry has magnitude 1; its phase stays as it is.
fn of_largest_one(vector: &[Complex64]) -> Vec<Complex64> {
    let largest = vector.iter().map(|entry| entry.norm()).fold(0.0, f64::max);
    if largest == 0.0 { vector.to_vec() } else { vector.iter().map(|entry| entry / largest).collect() }
}

/// a = ψᴴ(2λM + C)φ of a shape φ. The left vector ψ is scaled to ψ̄ = φ at the largest entry of φ, so that the receptance there is
/// φ²/(a (iω − λ)) by this mode, and that of symmetric matrices is φ̄; where ψ vanishes there, it has length one.
fn modal_a(problem: &Quadratic, mode: &ComplexMode, shape: &[Complex64]) -> Complex64 {
    /// Of length one: below this an entry is rounding.
    const ROUNDING: f64 = 1e-12;
    let [re, im]: [Vec<f64>; 2] =
        [shape.iter().map(|u| u.re).collect(), shape.iter().map(|u| u.im).collect()];
    let work = |matrix: &Sparse| -> Complex64 {
        let images = product(matrix, &re).into_iter().zip(product(matrix, &im));
        images.zip(&mode.left).map(|((re, im), left)| left.conj() * Complex64::new(re, im)).sum()
    };
    let a = 2.0 * mode.eigenvalue.value * work(problem.mass()) + work(problem.damping());
    let largest = shape.iter().zip(&mode.left).max_by(|a, b| a.0.norm().total_cmp(&b.0.norm()));
    match largest {
        Some((right, left)) if left.norm() > ROUNDING => a * right / left.conj(),
        _ => a,
    }
}

fn dataset(values: &[Eigenvalue], sought: &EigenRegion) -> Result<Dataset, ModelError> {
    let count = values.len();
    let numbers: Vec<i64> = (1..=count as i64).collect();
    let of = |pick: &dyn Fn(&Eigenvalue) -> f64| -> Vec<f64> { values.iter().map(pick).collect() };
    let modal = |name: &str, values: Vec<f64>| Variable::new(name, &["mode"], &[count], values);
    let eigenvalues: Vec<Complex64> = values.iter().map(|value| value.value).collect();
    let verdicts: Vec<u8> = values.iter().map(|value| code(value.verdict())).collect();
    Ok(Dataset::new()
        .attribute("kind", "eigen")?
        .attribute("region", json!({ "re": sought.re, "im": sought.im }))?
        .with(Variable::coordinate("mode", numbers).long_name("number of the mode, by rising frequency"))?
        .with(
            Variable::new("eigenvalue", &["mode"], &[count], eigenvalues)
                .units("1/s")
                .long_name("eigenvalue λ, growth rate + i angular frequency"),
        )?
        .with(modal("error", of(&|v| v.error)).units("1/s").long_name("how far the true eigenvalue may be"))?
        .with(modal("residual", of(&|v| v.residual)).units("1").long_name("normalised backward error"))?
        .with(modal("condition", of(&|v| v.condition)).units("1").long_name("condition number"))?
        .with(
            modal("damping_ratio", of(&Eigenvalue::damping_ratio))
                .units("1")
                .long_name("damping ratio ζ = −Re λ/|λ|"),
        )?
        .with(Variable::classes("verdict", &["mode"], &[count], verdicts, &VERDICTS).long_name("verdict"))?)
}

fn table(values: &[Eigenvalue]) -> Result<Table, ModelError> {
    let of = |pick: &dyn Fn(&Eigenvalue) -> f64| -> Vec<f64> { values.iter().map(pick).collect() };
    let words: Vec<String> = values.iter().map(|value| value.verdict().name().to_owned()).collect();
    Ok(Table::new()
        .column("mode", "1", (1..=values.len() as i64).collect::<Vec<_>>())?
        .column("re", "1/s", of(&|v| v.value.re))?
        .column("im", "1/s", of(&|v| v.value.im))?
        .column("frequency", "Hz", of(&Eigenvalue::frequency_hz))?
        .column("damping_ratio", "1", of(&Eigenvalue::damping_ratio))?
        .column("error", "1/s", of(&|v| v.error))?
        .column("residual", "1", of(&|v| v.residual))?
        .column("condition", "1", of(&|v| v.condition))?
        .column("verdict", "1", words)?)
}

fn checks(found: &ComplexModes) -> Vec<CheckRecord> {
    let count = found.modes.len();
    let errors =
        found.modes.iter().flat_map(|mode| [mode.eigenvalue.residual, mode.eigenvalue.left_residual]);
    let mut checks = vec![CheckRecord::new(
        "no eigenvalue is missing",
        format!(
            "parts of the region where nothing proves that all were found, after {} factorisations",
            found.shifts.len()
        ),
        (found.gaps.len() as f64).into(),
        0.0,
    )];
    // a region may have no eigenvalues
    if count > 0 {
        checks.push(CheckRecord::new(
            "eigenpairs satisfy (λ² M + λ C + K) x = 0",
            format!("normalised backward error of right and left vectors, {count} modes"),
            errors.collect(),
            RESIDUAL_LIMIT,
        ));
    }
    checks
}
