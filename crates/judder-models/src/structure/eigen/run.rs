//! `eigen`: all complex modes in a region, each with its error.

use super::super::fields::{self, ModeKind, NamedShape};
use super::super::shapes;
use super::super::vectors::{ImportedFreedoms, ModeVectors, ToldShape};
use super::diagnosis::{self, Diagnosed};
use crate::error::ModelError;
use crate::structure::build::{Structure, StructureLayout};
use crate::structure::case::StructureCase;
use crate::structure::solved_size::complex_mode_settings;
use judder_numerics::complex::ElementaryComplex;
use judder_store::{Results, Variable};
use judder_structure::asked_region::AskedRegion;
use judder_structure::assembly::Sparse;
use judder_structure::complex_modes::{
    ComplexMode, ComplexModes, Eigenvalue, Gap, Region, Verdict, complex_modes,
};
use judder_structure::mesh::Mesh;
use judder_structure::quadratic::Quadratic;
use judder_structure::statics::product;
use judder_study::outcome::{CheckRecord, Outcome};
use num_complex::Complex64;
use serde_json::json;

/// What the normalised backward error of an eigenpair may be.
const RESIDUAL_LIMIT: f64 = 1e-12;
/// The verdicts as codes of arrays.
pub(crate) const VERDICTS: [(u8, &str); 3] = [(0, "stable"), (1, "marginal"), (2, "unstable")];

pub(crate) fn code(verdict: Verdict) -> u8 {
    match verdict {
        Verdict::Stable => 0,
        Verdict::Marginal => 1,
        Verdict::Unstable => 2,
    }
}

pub(crate) fn run(
    case: &StructureCase,
    structure: &Structure,
    name: &str,
    asked: &AskedRegion,
) -> Result<Outcome, ModelError> {
    let problem = structure.at(case, &case.values())?;
    let sought = asked.rectangle();
    let found = asked_of(found(&problem, &sought)?, asked);
    let diagnosis = diagnosis::of_growing(case, structure, &sought, &found.modes)?;
    let (told, checked) = match diagnosis {
        Some(own) => (Some(own.modes), Some((own.check, own.warnings))),
        None => (None, None),
    };
    let shown = ShownModes {
        problem: &problem,
        sought: &sought,
        found: &found,
        layout: structure.layout.as_ref(),
        mesh: structure.mesh(),
        freedoms: match structure.mesh() {
            Some(_) => ImportedFreedoms::default(),
            None => ImportedFreedoms::of_structure(problem.size(), structure.layout.as_ref()),
        },
        expanded: &<[Complex64]>::to_vec,
        expanded_left: &<[Complex64]>::to_vec,
    };
    let mut outcome = shown.outcome(name, told)?;
    if let Some((check, warnings)) = checked {
        outcome.checks.push(check);
        outcome.warnings.extend(warnings);
    }
    Ok(outcome)
}

/// The complex modes of a region, by imaginary, then by real part.
pub(crate) fn found(problem: &Quadratic, sought: &Region) -> Result<ComplexModes, ModelError> {
    let mut found = complex_modes(problem, sought, &complex_mode_settings(problem.stiffness().val().len()))?;
    found.modes.sort_by(|a, b| in_order(&a.eigenvalue, &b.eigenvalue));
    Ok(found)
}

/// Of the modes of a rectangle those that are asked for.
pub(crate) fn asked_of(found: ComplexModes, asked: &AskedRegion) -> ComplexModes {
    let modes = found.modes.into_iter().filter(|mode| asked.has(&mode.eigenvalue)).collect();
    ComplexModes { modes, ..found }
}

/// Complex modes, and the body or bodies that swing in them.
pub(crate) struct ShownModes<'a> {
    pub(crate) problem: &'a Quadratic,
    pub(crate) sought: &'a Region,
    pub(crate) found: &'a ComplexModes,
    pub(crate) layout: Option<&'a StructureLayout>,
    pub(crate) mesh: Option<&'a Mesh>,
    /// Those of imported matrices, whose vectors are stored.
    pub(crate) freedoms: ImportedFreedoms,
    /// A shape on the freedoms of the layout from one of the problem,
    pub(crate) expanded: &'a dyn Fn(&[Complex64]) -> Vec<Complex64>,
    /// and a left one.
    pub(crate) expanded_left: &'a dyn Fn(&[Complex64]) -> Vec<Complex64>,
}

impl ShownModes<'_> {
    /// What is told, stored and drawn of them.
    pub(crate) fn outcome(
        &self,
        name: &str,
        diagnosis: Option<Vec<Diagnosed>>,
    ) -> Result<Outcome, ModelError> {
        let Self { problem, sought, found, .. } = self;
        let values: Vec<Eigenvalue> = found.modes.iter().map(|mode| mode.eigenvalue).collect();
        let mut warnings = gap_warnings(&found.gaps);
        if values.is_empty() && found.complete() {
            warnings.push("the region has no eigenvalue".to_owned());
        }
        let shapes: Vec<SwingingShape> = found.modes.iter().map(|mode| self.shape(mode)).collect();
        let vectors = self.vectors(&shapes);
        let told = ToldRegion {
            eigenvalues: (1..).zip(&values).map(|(mode, value)| ToldMode::new(mode, value)).collect(),
            complete: found.complete(),
            unstable: values.iter().filter(|value| value.verdict() == Verdict::Unstable).count(),
            degrees_of_freedom: problem.size(),
            shifts: found.shifts.len(),
            diagnosis,
            shapes: match self.layout.is_some_and(StructureLayout::has_places) {
                true => None,
                false => self.freedoms.told(&vectors),
            },
        };
        let all: Vec<Vec<Complex64>> = shapes.iter().map(|shape| shape.vector.clone()).collect();
        let (count, codes) = (values.len(), values.iter().map(|value| code(value.verdict())).collect());
        let Outcome { scalars, dataset, table, .. } = Outcome::of(&told)?;
        let mut dataset = dataset
            .attribute("region", json!({ "re": sought.re, "im": sought.im }))?
            .with(Variable::classes("verdict", &["mode"], &[count], codes, &VERDICTS).long_name("verdict"))?
            .with(
                Variable::new("mac", &["mode", "other_mode"], &[count; 2], shapes::complex_mac(&all))
                    .units("1")
                    .long_name("modal assurance criterion of two shapes"),
            )?;
        if let Some(layout) = self.layout {
            dataset = shapes::with_layout(dataset, layout)?;
            dataset = shapes::with_complex(dataset, layout, &all, &mut warnings)?;
        }
        dataset = self.freedoms.with_vectors(dataset, &vectors, &mut warnings)?;
        let swinging = |(k, (mode, shape)): (usize, (&ComplexMode, SwingingShape))| {
            let (value, frequency) = (mode.eigenvalue.value, mode.eigenvalue.frequency_hz());
            let name = format!("mode {} ({:.6} + {:.6} i 1/s)", k + 1, value.re, value.im);
            let SwingingShape { vector, modal_a, .. } = shape;
            NamedShape { name, vector, frequency, mode: ModeKind::Complex { eigenvalue: value, modal_a } }
        };
        let shapes: Vec<NamedShape> = found.modes.iter().zip(shapes).enumerate().map(swinging).collect();
        Ok(Outcome {
            scalars,
            dataset,
            table,
            checks: checks(found),
            missing: usize::from(!found.complete()),
            warnings,
            files: fields::fields(name, self.layout, self.mesh, &shapes)?,
            ..Outcome::default()
        })
    }

    /// The shape of a mode on the freedoms of the layout, its largest entry of magnitude 1, its phase as it is.
    fn shape(&self, mode: &ComplexMode) -> SwingingShape {
        let all = (self.expanded)(&mode.right);
        let largest = all.iter().map(|entry| entry.modulus()).fold(0.0, f64::max);
        let size = if largest == 0.0 { 1.0 } else { largest };
        let scaled = |shape: &[Complex64]| shape.iter().map(|entry| entry / size).collect::<Vec<_>>();
        let right = scaled(&mode.right);
        let a = bilinear(self.problem, mode, &right);
        SwingingShape { modal_a: modal_a(mode, &right, a), bilinear: a, vector: scaled(&all) }
    }

    /// The right and left vectors of all modes, where freedoms are named.
    fn vectors(&self, shapes: &[SwingingShape]) -> Vec<ModeVectors> {
        let of = |(k, (mode, shape)): (usize, (&ComplexMode, &SwingingShape))| ModeVectors {
            mode: k + 1,
            eigenvalue: mode.eigenvalue.value,
            frequency_hz: mode.eigenvalue.frequency_hz(),
            right: shape.vector.clone(),
            left: (self.expanded_left)(&mode.left)
                .into_iter()
                .map(|entry| entry / shape.bilinear.conj())
                .collect(),
        };
        match self.freedoms.is_empty() {
            true => Vec::new(),
            false => self.found.modes.iter().zip(shapes).enumerate().map(of).collect(),
        }
    }
}

/// A shape and the ψᴴ(2λM + C)φ that belongs to its size.
struct SwingingShape {
    vector: Vec<Complex64>,
    /// That of the left vector of length one,
    bilinear: Complex64,
    /// and that of the left vector that is scaled as test engineers have it.
    modal_a: Complex64,
}

/// By imaginary, then by real part.
pub(crate) fn in_order(a: &Eigenvalue, b: &Eigenvalue) -> std::cmp::Ordering {
    a.value.im.total_cmp(&b.value.im).then(a.value.re.total_cmp(&b.value.re))
}

/// What is told of the modes of a region.
#[derive(Results)]
#[results(arrays(eigenvalues), columns(eigenvalues))]
pub(crate) struct ToldRegion {
    /// the eigenvalues, by rising frequency
    #[result(rows)]
    eigenvalues: Vec<ToldMode>,
    /// whether it is proven that there are no more
    complete: bool,
    /// how many grow
    unstable: usize,
    degrees_of_freedom: usize,
    shifts: usize,
    /// why modes grow
    #[result(optional)]
    diagnosis: Option<Vec<Diagnosed>>,
    /// the shapes of the fastest growing modes, of matrices whose freedoms have no places
    #[result(optional)]
    shapes: Option<Vec<ToldShape>>,
}

/// An eigenvalue, and what is known of it.
#[derive(Clone, Results)]
#[results(
    rows = "mode",
    arrays(mode, eigenvalue, error, residual, condition, damping_ratio),
    columns(mode, re, im, frequency, damping_ratio, error, residual, condition, verdict)
)]
pub(crate) struct ToldMode {
    /// number of the mode, by rising frequency
    #[result(hidden)]
    mode: i64,
    /// eigenvalue λ, growth rate + i angular frequency
    #[result(hidden, unit = "1/s")]
    eigenvalue: Complex64,
    /// growth rate
    #[result(unit = "1/s")]
    re: f64,
    /// angular frequency
    #[result(unit = "1/s")]
    im: f64,
    /// normalised backward error
    residual: f64,
    /// that of the left vector
    #[result(unit = "1")]
    left_residual: f64,
    verdict: &'static str,
    /// how far the true eigenvalue may be
    #[result(unit = "1/s")]
    error: f64,
    /// condition number
    condition: f64,
    /// whether another eigenvalue has the same vector
    defective: bool,
    /// frequency
    #[result(summary = "frequency_hz", unit = "Hz")]
    frequency: f64,
    /// damping ratio ζ = −Re λ/|λ|
    damping_ratio: f64,
}

impl ToldMode {
    pub(crate) fn new(mode: i64, own: &Eigenvalue) -> Self {
        let Eigenvalue { value, residual, left_residual, condition, error, defective } = *own;
        Self {
            mode,
            eigenvalue: value,
            re: value.re,
            im: value.im,
            residual,
            left_residual,
            verdict: own.verdict().name(),
            error,
            condition,
            defective,
            frequency: own.frequency_hz(),
            damping_ratio: own.damping_ratio(),
        }
    }
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

/// ψᴴ(2λM + C)φ of a shape φ, whose left vector ψ has length one.
fn bilinear(problem: &Quadratic, mode: &ComplexMode, shape: &[Complex64]) -> Complex64 {
    let [re, im]: [Vec<f64>; 2] =
        [shape.iter().map(|u| u.re).collect(), shape.iter().map(|u| u.im).collect()];
    let work = |matrix: &Sparse| -> Complex64 {
        let images = product(matrix, &re).into_iter().zip(product(matrix, &im));
        images.zip(&mode.left).map(|((re, im), left)| left.conj() * Complex64::new(re, im)).sum()
    };
    2.0 * mode.eigenvalue.value * work(problem.mass()) + work(problem.damping())
}

/// That of a shape φ, which is `a` where the left vector has length one. The left vector ψ is scaled to ψ̄ = φ at the largest entry of φ, so that the receptance there is
/// φ²/(a (iω − λ)) by this mode, and that of symmetric matrices is φ̄; where ψ vanishes there, it has length one.
fn modal_a(mode: &ComplexMode, shape: &[Complex64], a: Complex64) -> Complex64 {
    /// Of length one: below this an entry is rounding.
    const ROUNDING: f64 = 1e-12;
    let largest = shape.iter().zip(&mode.left).max_by(|a, b| a.0.modulus().total_cmp(&b.0.modulus()));
    match largest {
        Some((right, left)) if left.modulus() > ROUNDING => a * right / left.conj(),
        _ => a,
    }
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
