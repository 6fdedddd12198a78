//! A small problem whole: all its eigenvalues from one dense matrix, and determinants as the proof that they are all.
//!
//! With w = (z − σ)/ρ the linear operator A of [`LinearisedOperator`] has det Q(z)/det Q(σ) = det(1 − w A) = Π (1 − w θⱼ) over all its
//! eigenvalues, infinite ones (θ = 0) among them. Determinants by elimination around the region are a number of their own: an eigenvalue of
//! the region that is missing, or there twice, turns the quotient of both sides once around.

use super::SearchedRegion;
use super::cover::Gap;
use super::determinant::log_determinant;
use super::disc::{Triple, biorthogonalise};
use super::linearised::LinearisedOperator;
use super::matching::one_to_one;
use super::refine::{Neighbourhood, RefinedEigenvalue};
use super::shift::ShiftedFactor;
use super::vectors::normalise;
use crate::StructureError;
use crate::quadratic::{MatrixSide, Quadratic, Region};
use faer::{Mat, c64};
use judder_dense::general::complex_eigen;
use judder_memory::HeldMemory;
use judder_numerics::complex::ElementaryComplex;
use judder_numerics::parallel;

/// Problems of at most so many freedoms are solved whole.
pub(super) const LARGEST: usize = 200;
/// Eigenvalues out to so many radii of the region are refined: those beside it make the others' refinement fast.
const SURROUNDINGS: f64 = 1.5;
/// Eigenvalues nearer to each other than this share of the radius have vectors that mix.
const CLUSTER: f64 = 1e-7;

/// Every eigenvalue of a region, refined, and whether the determinants prove that there are no others.
pub(super) fn whole(
    problem: &Quadratic,
    region: &Region,
    memory: &HeldMemory,
) -> Result<SearchedRegion, StructureError> {
    let reach = region.radius();
    let factor = ShiftedFactor::near(problem, region.centre(), reach, memory)?;
    let of = |side| LinearisedOperator { problem, factor: &factor, side, reach };
    let (right, left) = rayon::join(
        || WholeSpectrum::of(&of(MatrixSide::Right)),
        || WholeSpectrum::of(&of(MatrixSide::Left)),
    );
    let (right, left) = (right?, left?);
    let near: Vec<usize> =
        (0..right.thetas.len()).filter(|k| right.thetas[*k].modulus() * SURROUNDINGS >= 1.0).collect();
    let mut partner = vec![0; right.thetas.len()];
    for (i, j) in one_to_one(&right.thetas, &left.thetas, f64::INFINITY) {
        partner[i] = j;
    }
    let operator = of(MatrixSide::Right);
    let triple = |k: &usize| Triple {
        value: operator.value(right.thetas[*k]),
        right: right.vector(*k),
        left: left.vector(partner[*k]),
    };
    let mut triples: Vec<Triple> = near.iter().map(triple).collect();
    biorthogonalise(problem, &mut triples, CLUSTER * reach);
    let refined = refined(problem, &factor, &triples, reach)?;
    let mut thetas = right.thetas.clone();
    for (k, refined) in near.iter().zip(&refined) {
        thetas[*k] = reach / (refined.triple.value - factor.shift());
    }
    let gaps = unproved(problem, region, &operator, &thetas)?;
    Ok(SearchedRegion { refined, factors: vec![factor], gaps })
}

/// All eigenvalues θ of an operator.
struct WholeSpectrum {
    thetas: Vec<c64>,
    /// Columns (x, u).
    vectors: Mat<c64>,
    size: usize,
}

impl WholeSpectrum {
    fn of(operator: &LinearisedOperator<'_>) -> Result<Self, StructureError> {
        let rows = operator.rows();
        let matrix = operator.through(Mat::<c64>::identity(rows, rows).as_ref())?;
        let (thetas, vectors) =
            complex_eigen(matrix.as_ref()).ok_or(StructureError::NoDenseEigenvalues { rows })?;
        Ok(Self { thetas, vectors, size: operator.problem.size() })
    }

    /// x of an eigenvalue, of length one.
    fn vector(&self, k: usize) -> Vec<c64> {
        let mut vector: Vec<c64> = (0..self.size).map(|row| self.vectors[(row, k)]).collect();
        normalise(&mut vector);
        vector
    }
}

/// Every triple refined, or as it came where its refinement went to the place of another.
fn refined(
    problem: &Quadratic,
    factor: &ShiftedFactor,
    triples: &[Triple],
    reach: f64,
) -> Result<Vec<RefinedEigenvalue>, StructureError> {
    /// Eigenvalues nearer than this share of the reach are one.
    const ONE: f64 = 1e-10;
    let neighbourhood = Neighbourhood::new(problem, factor, triples);
    let own = |k: usize| {
        let others = triples.iter().enumerate().filter(|(j, _)| *j != k);
        let nearest =
            others.map(|(_, other)| (other.value - triples[k].value).modulus()).fold(f64::INFINITY, f64::min);
        (0.5 * nearest).max(ONE * reach)
    };
    let one = |k: usize| -> Result<RefinedEigenvalue, StructureError> {
        let refined = neighbourhood.refined_to_rounding(k)?;
        let stayed = (refined.triple.value - triples[k].value).modulus() <= own(k);
        Ok(if stayed { refined } else { RefinedEigenvalue::measured(problem, triples[k].clone()) })
    };
    parallel::try_each_place(triples.len(), one)
}

/// Where a determinant is not that of the eigenvalues.
fn unproved(
    problem: &Quadratic,
    region: &Region,
    operator: &LinearisedOperator<'_>,
    thetas: &[c64],
) -> Result<Vec<Gap>, StructureError> {
    /// A missing eigenvalue makes 2π of it on the way around.
    const TOLERANCE: f64 = 0.1;
    let (shift, reach) = (operator.factor.shift(), operator.reach);
    let values: Vec<c64> =
        thetas.iter().filter(|theta| theta.modulus() > 0.0).map(|theta| shift + reach / theta).collect();
    let (contour, places) = contour(region, &values);
    let found = values.iter().filter(|value| contour.contains(**value, 0.0)).count();
    let of_shift = log_determinant(problem, shift)?;
    let differs = |place: &c64| -> Result<bool, StructureError> {
        let turned = (place - shift) / reach;
        let expected: c64 =
            thetas.iter().map(|theta| (c64::new(1.0, 0.0) - turned * theta).logarithm()).sum();
        let rest = log_determinant(problem, *place)? - of_shift - expected;
        let phase = (rest.im / std::f64::consts::TAU).round().mul_add(-std::f64::consts::TAU, rest.im);
        // so too where the rest is not a number
        Ok(!(rest.re.abs() <= TOLERANCE && phase.abs() <= TOLERANCE))
    };
    let differing: Vec<bool> = parallel::try_each(&places, differs)?;
    let first = differing.iter().position(|differs| *differs);
    Ok(first.map(|k| Gap::Unproved { found, place: places[k] }).into_iter().collect())
}

/// The region a little larger, by how much its edge stays clearest of eigenvalues, and places along that edge.
fn contour(region: &Region, values: &[c64]) -> (Region, Vec<c64>) {
    const STEPS: usize = 16;
    const WIDEST: f64 = 0.1;
    const PLACES_OF_A_SIDE: usize = 16;
    let clearance = |region: &Region| {
        values.iter().map(|value| region.distance_to_edge(*value).abs()).fold(f64::INFINITY, f64::min)
    };
    let wider = (1..=STEPS).map(|step| region.widened(WIDEST * step as f64 / STEPS as f64));
    let contour = wider.max_by(|a, b| clearance(a).total_cmp(&clearance(b))).unwrap_or(*region);
    let ([left, right], [below, above]) = (contour.re, contour.im);
    let places = (0..PLACES_OF_A_SIDE).flat_map(|k| {
        let share = (k as f64 + 0.5) / PLACES_OF_A_SIDE as f64;
        let (re, im) = (left + share * (right - left), below + share * (above - below));
        [c64::new(re, below), c64::new(right, im), c64::new(re, above), c64::new(left, im)]
    });
    (contour, places.collect())
}
