//! Refinement of eigenvalues and vectors on the full problem.
//!
//! Residual inverse iteration (A. Neumaier, 1985): x ← x − Q(λ)⁻¹ Q(λ) x with an approximate inverse. That of a shift, Q(σ)⁻¹,
//! converges slowly beside other eigenvalues; Keldysh's sum Q(λ)⁻¹ = Σ xⱼ zⱼᵀ/((λ − λⱼ) dⱼ) + …, dⱼ = zⱼᵀ Q′(λⱼ) xⱼ, carries the
//! known ones from σ to λ, and what is left converges as fast as the unknown eigenvalues are far.

use super::disc::Triple;
use super::shift::ShiftedFactor;
use super::vectors::{bilinear, column, length, normalise};
use crate::StructureError;
use crate::quadratic::{MatrixSide, Quadratic, entries};
use faer::{Mat, c64};
use judder_numerics::complex::ElementaryComplex;

/// Eigenvalues that are known beside each other, with the factor at a shift among them.
pub(crate) struct Neighbourhood<'a> {
    problem: &'a Quadratic,
    factor: &'a ShiftedFactor,
    triples: &'a [Triple],
    /// dⱼ of each.
    slopes: Vec<c64>,
}

/// A triple with its normalised residuals ‖Q(λ) x‖/((|λ|² ‖M‖ + |λ| ‖C‖ + ‖K‖) ‖x‖).
#[derive(Debug, Clone)]
pub(crate) struct RefinedEigenvalue {
    pub(crate) triple: Triple,
    /// Q(λ) x.
    pub(crate) rest: Vec<c64>,
    /// Q(λ)ᵀ z.
    pub(crate) left_rest: Vec<c64>,
    pub(crate) residual: f64,
    pub(crate) left_residual: f64,
    /// d = zᵀ Q′(λ) x.
    pub(crate) slope: c64,
}

/// Residuals no larger than this are rounding.
const ROUNDING: f64 = 2e-16;
/// Above this the factors of a neighbourhood have not sufficed.
const SUFFICIENT: f64 = 1e-15;
/// Steps of one refinement.
const STEPS: usize = 4;
/// Eigenvalues nearer than this share of |λ| have vectors that Keldysh's sum cannot keep apart.
const CLOSE: f64 = 1e-7;

impl<'a> Neighbourhood<'a> {
    pub(crate) fn new(problem: &'a Quadratic, factor: &'a ShiftedFactor, triples: &'a [Triple]) -> Self {
        let slope = |triple: &Triple| {
            bilinear(
                &triple.left,
                problem.slope(MatrixSide::Right, triple.value, column(&triple.right)).col(0),
            )
        };
        Self { problem, factor, triples, slopes: triples.iter().map(slope).collect() }
    }

    /// A triple of the neighbourhood, refined until its residuals are rounding or fall no more.
    pub(crate) fn refined(&self, place: usize) -> Result<RefinedEigenvalue, StructureError> {
        let mut best = self.measure(self.triples[place].clone());
        for _ in 0..STEPS {
            if best.worse() <= ROUNDING {
                break;
            }
            let next = self.measure(self.corrected(place, &best)?);
            if !next.is_better_than(&best) {
                break;
            }
            best = next;
        }
        Ok(best)
    }

    /// As [`Self::refined`], and where that does not reach rounding, beside a defective eigenvalue say, by factors at λ itself.
    pub(crate) fn refined_to_rounding(&self, place: usize) -> Result<RefinedEigenvalue, StructureError> {
        let mut best = self.refined(place)?;
        if best.worse() <= SUFFICIENT {
            return Ok(best);
        }
        let Some(factor) = ShiftedFactor::at(self.problem, best.triple.value, self.factor.memory())? else {
            return Ok(best);
        };
        for _ in 0..STEPS {
            // the nearly singular Q(λ)⁻¹ takes each vector to the other side's
            let turned = |side, from: &[c64]| -> Result<Vec<c64>, StructureError> {
                let mut block = Mat::from_fn(from.len(), 1, |row, _| from[row].conj());
                factor.solve(side, &mut block)?;
                let mut vector: Vec<c64> = entries(block.col(0)).collect();
                normalise(&mut vector);
                Ok(vector)
            };
            let right = turned(MatrixSide::Right, &best.triple.left)?;
            let left = turned(MatrixSide::Left, &right)?;
            let kept = self.measure(Triple { value: best.triple.value, right, left });
            let moved = self.measure(Triple { value: kept.newton(), ..kept.triple.clone() });
            let next = if moved.is_better_than(&kept) { moved } else { kept };
            if !next.is_better_than(&best) {
                break;
            }
            best = next;
        }
        Ok(best)
    }

    fn measure(&self, triple: Triple) -> RefinedEigenvalue {
        RefinedEigenvalue::measured(self.problem, triple)
    }

    /// One step of the iteration on both sides, then one of Newton on λ.
    fn corrected(&self, place: usize, from: &RefinedEigenvalue) -> Result<Triple, StructureError> {
        let (right, left) = self.steps(place, from)?;
        let moved = |vector: &[c64], step: &[c64]| {
            let mut moved: Vec<c64> = vector.iter().zip(step).map(|(v, s)| v - s).collect();
            normalise(&mut moved);
            moved
        };
        let triple = Triple {
            value: from.triple.value,
            right: moved(&from.triple.right, &right),
            left: moved(&from.triple.left, &left),
        };
        let value = self.measure(triple.clone()).newton();
        Ok(if value.re.is_finite() && value.im.is_finite() { Triple { value, ..triple } } else { triple })
    }

    /// What the approximate inverse makes of both residuals.
    fn steps(&self, place: usize, from: &RefinedEigenvalue) -> Result<(Vec<c64>, Vec<c64>), StructureError> {
        let value = from.triple.value;
        let solved = |side, rest: &[c64]| -> Result<Vec<c64>, StructureError> {
            let mut block = column(rest).to_owned();
            self.factor.solve(side, &mut block)?;
            Ok(entries(block.col(0)).collect())
        };
        let mut right = solved(MatrixSide::Right, &from.rest)?;
        let mut left = solved(MatrixSide::Left, &from.left_rest)?;
        for (j, (known, slope)) in self.triples.iter().zip(&self.slopes).enumerate() {
            let mut weight = -(self.factor.shift() - known.value).inv();
            let apart = value - known.value;
            if j != place && apart.modulus() > CLOSE * value.modulus() {
                weight += apart.inv();
            }
            let along = |vector: &[c64], rest: &[c64]| bilinear(vector, column(rest).col(0)) * weight / slope;
            let (of_right, of_left) = (along(&known.left, &from.rest), along(&known.right, &from.left_rest));
            add(&mut right, of_right, &known.right);
            add(&mut left, of_left, &known.left);
        }
        Ok((right, left))
    }
}

impl RefinedEigenvalue {
    /// A triple with its residuals.
    pub(crate) fn measured(problem: &Quadratic, triple: Triple) -> Self {
        let (right, left) = (column(&triple.right), column(&triple.left));
        let rest: Vec<c64> = entries(problem.image(MatrixSide::Right, triple.value, right).col(0)).collect();
        let left_rest: Vec<c64> =
            entries(problem.image(MatrixSide::Left, triple.value, left).col(0)).collect();
        let scale = problem.scale(triple.value);
        let slope = bilinear(&triple.left, problem.slope(MatrixSide::Right, triple.value, right).col(0));
        let (residual, left_residual) = (length(&rest) / scale, length(&left_rest) / scale);
        Self { triple, rest, left_rest, residual, left_residual, slope }
    }

    /// Triples with their residuals, the matrices read for several at a time.
    pub(crate) fn all_measured(problem: &Quadratic, triples: Vec<Triple>) -> Vec<Self> {
        let rows = problem.size();
        let values: Vec<c64> = triples.iter().map(|triple| triple.value).collect();
        let block = |vector: fn(&Triple) -> &Vec<c64>| {
            Mat::from_fn(rows, triples.len(), |row, k| vector(&triples[k])[row])
        };
        let right = problem.images(MatrixSide::Right, &values, block(|triple| &triple.right).as_ref());
        let left = problem.images(MatrixSide::Left, &values, block(|triple| &triple.left).as_ref());
        let of_one = |(k, triple): (usize, Triple)| {
            let (rest, left_rest): (Vec<c64>, Vec<c64>) =
                (entries(right.image.col(k)).collect(), entries(left.image.col(k)).collect());
            let scale = problem.scale(triple.value);
            let slope = bilinear(&triple.left, right.slope.col(k));
            let (residual, left_residual) = (length(&rest) / scale, length(&left_rest) / scale);
            Self { triple, rest, left_rest, residual, left_residual, slope }
        };
        triples.into_iter().enumerate().map(of_one).collect()
    }

    /// Both residuals.
    pub(crate) fn worse(&self) -> f64 {
        self.residual + self.left_residual
    }

    /// False too where a residual is not a number.
    fn is_better_than(&self, other: &Self) -> bool {
        self.worse() < other.worse()
    }

    /// λ − zᵀ Q(λ) x/d.
    fn newton(&self) -> c64 {
        self.triple.value - bilinear(&self.triple.left, column(&self.rest).col(0)) / self.slope
    }
}

/// y += a x.
fn add(y: &mut [c64], a: c64, x: &[c64]) {
    for (y, x) in y.iter_mut().zip(x) {
        *y += a * x;
    }
}
