//! Weighted non-linear least squares with standard errors and confidence intervals.

use super::FitError;
use levenberg_marquardt::{LeastSquaresProblem, LevenbergMarquardt, TerminationReason};
use nalgebra::storage::Owned;
use nalgebra::{DMatrix, DVector, Dyn};
use statrs::distribution::{ContinuousCDF, StudentsT};

/// Probability below the upper end of a two-sided 95 % interval.
const UPPER_END: f64 = 0.975;

/// Factors of the start values that are tried; the best fit of all is taken.
const STARTS: [f64; 4] = [1.0, 0.6, 1.6, 0.3];

/// Evaluations of all residuals for each coefficient, and once more, at most.
const PATIENCE: usize = 400;

/// A value to fit, without its power of ŷ.
#[derive(Debug, Clone, Copy)]
pub(super) struct Observation {
    pub(super) log10_velocity: f64,
    pub(super) log10_indentation: f64,
    pub(super) value: f64,
    /// What its residual is multiplied by.
    pub(super) weight: f64,
}

/// One fitted function of N coefficients.
#[derive(Debug, Clone, PartialEq)]
pub struct FunctionFit<const N: usize> {
    /// In the order of appendix B.
    pub coefficients: [f64; N],
    /// Their standard errors.
    pub standard_errors: [f64; N],
    /// Their 95 % confidence intervals.
    pub intervals: [(f64, f64); N],
    /// r², coefficient of determination: 1 − Σ residual²/Σ (value − mean)².
    pub r2: f64,
    /// Fit minus sample, in the quantity that the least squares are of, in the order of the samples.
    pub residuals: Vec<f64>,
}

impl<const N: usize> FunctionFit<N> {
    /// Turns the sign of a coefficient on which the function does not depend, if it is negative.
    pub(super) fn make_positive(&mut self, index: usize) {
        if self.coefficients[index] < 0.0 {
            self.coefficients[index] = -self.coefficients[index];
            let (low, high) = self.intervals[index];
            self.intervals[index] = (-high, -low);
        }
    }

    /// Widens errors and intervals to those of `independent` samples, where all samples were interpolated between so many.
    ///
    /// With n samples, m of them independent, the information JᵀJ is m/n of what it seems, and the freedom m − N.
    pub(super) fn widen(&mut self, name: &'static str, independent: usize) -> Result<(), FitError> {
        let samples = self.residuals.len();
        let independent = independent.min(samples);
        if independent <= N {
            return Err(FitError::TooFewSamples { function: name, samples: independent, coefficients: N });
        }
        let freedom = (independent - N) as f64;
        let factor = ((samples - N) as f64 / freedom).sqrt();
        let quantile = upper_quantile(name, freedom)?;
        for n in 0..N {
            self.standard_errors[n] *= factor;
            let reach = quantile * self.standard_errors[n];
            self.intervals[n] = (self.coefficients[n] - reach, self.coefficients[n] + reach);
        }
        Ok(())
    }
}

/// How many standard errors a 95 % interval reaches to each side.
fn upper_quantile(name: &'static str, freedom: f64) -> Result<f64, FitError> {
    let student = StudentsT::new(0.0, 1.0, freedom).map_err(|_| FitError::Undetermined { function: name })?;
    Ok(student.inverse_cdf(UPPER_END))
}

/// A function with its gradient by the coefficients, at log₁₀ v̂ and log₁₀ ŷ.
pub(super) type GradientFunction<const N: usize> = fn(&[f64; N], f64, f64) -> (f64, [f64; N]);

/// The problem that the library solves; its residuals are over the largest weighted value, so that its tolerances mean digits.
#[derive(Clone)]
struct FitProblem<'a, const N: usize> {
    data: &'a [Observation],
    function: GradientFunction<N>,
    coefficients: [f64; N],
    per_scale: f64,
}

impl<const N: usize> FitProblem<'_, N> {
    fn residual_vector(&self) -> DVector<f64> {
        DVector::from_iterator(
            self.data.len(),
            self.data.iter().map(|o| {
                let (value, _) = (self.function)(&self.coefficients, o.log10_velocity, o.log10_indentation);
                (value - o.value) * o.weight * self.per_scale
            }),
        )
    }

    fn jacobian_matrix(&self) -> DMatrix<f64> {
        let mut matrix = DMatrix::zeros(self.data.len(), N);
        for (k, o) in self.data.iter().enumerate() {
            let (_, gradient) = (self.function)(&self.coefficients, o.log10_velocity, o.log10_indentation);
            for (n, slope) in gradient.into_iter().enumerate() {
                matrix[(k, n)] = slope * o.weight * self.per_scale;
            }
        }
        matrix
    }
}

impl<const N: usize> LeastSquaresProblem<f64, Dyn, Dyn> for FitProblem<'_, N> {
    type ParameterStorage = Owned<f64, Dyn>;
    type ResidualStorage = Owned<f64, Dyn>;
    type JacobianStorage = Owned<f64, Dyn, Dyn>;

    fn set_params(&mut self, x: &DVector<f64>) {
        self.coefficients.copy_from_slice(x.as_slice());
    }

    fn params(&self) -> DVector<f64> {
        DVector::from_column_slice(&self.coefficients)
    }

    fn residuals(&self) -> Option<DVector<f64>> {
        Some(self.residual_vector())
    }

    fn jacobian(&self) -> Option<DMatrix<f64>> {
        Some(self.jacobian_matrix())
    }
}

/// Fits a function, from start values made of the data and from some around them.
pub(super) fn fit_function<const N: usize>(
    name: &'static str,
    data: &[Observation],
    function: GradientFunction<N>,
    start: impl Fn(&[Observation]) -> Result<[f64; N], FitError>,
) -> Result<FunctionFit<N>, FitError> {
    if data.len() <= N {
        return Err(FitError::TooFewSamples { function: name, samples: data.len(), coefficients: N });
    }
    let start = start(data)?;
    let largest = data.iter().map(|o| (o.value * o.weight).abs()).fold(0.0, f64::max);
    let mut best: Option<(f64, FitProblem<'_, N>)> = None;
    let mut reason = String::new();
    for factor in STARTS {
        let coefficients = start.map(|value| factor * value);
        let problem = FitProblem { data, function, coefficients, per_scale: 1.0 / largest };
        let (problem, report) = LevenbergMarquardt::new().with_patience(PATIENCE).minimize(problem);
        let objective = report.objective_function;
        if !report.termination.was_successful() || !objective.is_finite() {
            reason = in_words(&report.termination);
        } else if best.as_ref().is_none_or(|(least, _)| objective < *least) {
            best = Some((objective, problem));
        }
    }
    let (_, problem) = best.ok_or(FitError::NotConverged { function: name, reason })?;
    statistics(name, &problem)
}

/// Why the method gave up.
fn in_words(reason: &TerminationReason) -> String {
    match reason {
        TerminationReason::LostPatience => {
            format!("the coefficients still move after {PATIENCE} evaluations for each of them")
        }
        TerminationReason::NoImprovementPossible(_) => "no step comes nearer to the samples".to_owned(),
        TerminationReason::Numerical(what) => format!("{what}: not finite"),
        other => format!("{other:?}"),
    }
}

/// Standard errors from s²(JᵀJ)⁻¹, intervals from Student's t, r².
fn statistics<const N: usize>(
    name: &'static str,
    problem: &FitProblem<'_, N>,
) -> Result<FunctionFit<N>, FitError> {
    let undetermined = FitError::Undetermined { function: name };
    let data = problem.data;
    let residuals = problem.residual_vector();
    let freedom = (data.len() - N) as f64;
    let variance = residuals.norm_squared() / freedom;
    // columns of length one, so that the inverse does not lose the digits of their units
    let mut jacobian = problem.jacobian_matrix();
    let lengths: Vec<f64> = jacobian.column_iter().map(|column| column.norm()).collect();
    for (mut column, length) in jacobian.column_iter_mut().zip(&lengths) {
        column /= *length;
    }
    let inverse = (jacobian.transpose() * &jacobian).cholesky().ok_or(undetermined)?.inverse();
    let quantile = upper_quantile(name, freedom)?;
    let mut standard_errors = [0.0; N];
    let mut intervals = [(0.0, 0.0); N];
    for n in 0..N {
        standard_errors[n] = (variance * inverse[(n, n)]).sqrt() / lengths[n];
        let reach = quantile * standard_errors[n];
        intervals[n] = (problem.coefficients[n] - reach, problem.coefficients[n] + reach);
    }
    let values: Vec<f64> = data.iter().map(|o| o.value * o.weight * problem.per_scale).collect();
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    let spread: f64 = values.iter().map(|value| (value - mean) * (value - mean)).sum();
    Ok(FunctionFit {
        coefficients: problem.coefficients,
        standard_errors,
        intervals,
        r2: 1.0 - residuals.norm_squared() / spread,
        residuals: residuals.iter().map(|residual| residual / problem.per_scale).collect(),
    })
}
