//! The fit of appendix B: the three functions (34), (36), (38) through computed contacts.
//!
//! - `functions`: the functions and their exact gradients by the coefficients.
//! - `least_squares`: Levenberg–Marquardt, standard errors, confidence intervals.
//! - `start`: start values from the data alone.

mod functions;
mod least_squares;
mod start;

pub use least_squares::FunctionFit;

use crate::fitted::FittedLaw;
use crate::law::PerQuantity;
use functions::{area, force, friction};
use least_squares::{Observation, fit_function};
use thiserror::Error;

/// A computed contact to fit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FitSample {
    /// v̂ = v τ/R.
    pub velocity: f64,
    /// ŷ = δ/R.
    pub indentation: f64,
    /// F̃, Ã, μ.
    pub values: PerQuantity<f64>,
}

/// What the least squares are of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Weighting {
    /// F̃, Ã, μ themselves: deep contacts count most. What a fit without weights does.
    #[default]
    Absolute,
    /// F̃/ŷ^{3/2}, Ã/ŷ, μ/ŷ^{1/2}: all depths count alike.
    Scaled,
}

/// Why there is no fit.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum FitError {
    /// A sample is not a contact.
    #[error("sample {index}: {name} = {value} must be {requirement}")]
    InvalidSample {
        /// The sample, from 0.
        index: usize,
        /// Which of its numbers.
        name: &'static str,
        /// The number.
        value: f64,
        /// What it must be.
        requirement: &'static str,
    },
    /// The factor of the speed is not a number.
    #[error("velocity scale 10^{log10_velocity_scale} must be finite")]
    InvalidVelocityScale {
        /// Its logarithm.
        log10_velocity_scale: f64,
    },
    /// Not more samples than coefficients.
    #[error("{function}: {samples} samples for {coefficients} coefficients; at least one more is needed")]
    TooFewSamples {
        /// Which of the functions.
        function: &'static str,
        /// Samples given.
        samples: usize,
        /// Coefficients sought.
        coefficients: usize,
    },
    /// The samples do not determine the coefficients: one speed or one depth alone, or values that are all the same.
    #[error("{function}: the samples do not determine the coefficients; they must span speeds and depths")]
    Undetermined {
        /// Which of the functions.
        function: &'static str,
    },
    /// Levenberg–Marquardt did not settle from any start.
    #[error(
        "{function}: the fit did not converge: {reason}; the function may follow a narrower range of depths and speeds"
    )]
    NotConverged {
        /// Which of the functions.
        function: &'static str,
        /// Why the method gave up.
        reason: String,
    },
}

/// The three fitted functions.
#[derive(Debug, Clone, PartialEq)]
pub struct LawFit {
    /// (34): a₁ … a₅.
    pub force: FunctionFit<5>,
    /// (36): b₁ … b₅.
    pub area: FunctionFit<5>,
    /// (38): c₁ … c₄.
    pub friction: FunctionFit<4>,
    /// log₁₀ of the factor of v̂ at which the functions read it.
    pub log10_velocity_scale: f64,
}

/// One coefficient beside that of another fit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CoefficientComparison {
    /// `"a1"` … `"c4"`.
    pub name: &'static str,
    /// The fitted value.
    pub value: f64,
    /// Its standard error.
    pub standard_error: f64,
    /// Its 95 % confidence interval.
    pub interval: (f64, f64),
    /// The other fit's value.
    pub reference: f64,
}

impl CoefficientComparison {
    /// Fitted minus reference.
    #[must_use]
    pub fn deviation(&self) -> f64 {
        self.value - self.reference
    }

    /// The same, over the magnitude of the reference.
    #[must_use]
    pub fn relative_deviation(&self) -> f64 {
        self.deviation() / self.reference.abs()
    }
}

/// The names of the coefficients in appendix B.
const NAMES: [&str; 14] =
    ["a1", "a2", "a3", "a4", "a5", "b1", "b2", "b3", "b4", "b5", "c1", "c2", "c3", "c4"];

/// The functions, as errors name them.
const FUNCTIONS: [&str; 3] = ["force (34)", "area (36)", "friction (38)"];

impl LawFit {
    /// The same fit with the errors of `independent` samples: for samples that were interpolated between so many contacts.
    ///
    /// Standard errors become √((n − p)/(m − p)) times as large, n samples, m of them independent, p coefficients; the
    /// intervals take m − p degrees of freedom. More than n are taken for n.
    ///
    /// # Errors
    /// Not more independent samples than coefficients.
    pub fn of_independent(mut self, independent: usize) -> Result<Self, FitError> {
        self.force.widen(FUNCTIONS[0], independent)?;
        self.area.widen(FUNCTIONS[1], independent)?;
        self.friction.widen(FUNCTIONS[2], independent)?;
        Ok(self)
    }

    /// The fit as a law.
    #[must_use]
    pub fn law(&self) -> FittedLaw {
        FittedLaw {
            force: self.force.coefficients,
            area: self.area.coefficients,
            friction: self.friction.coefficients,
            log10_velocity_scale: self.log10_velocity_scale,
        }
    }

    /// All fourteen coefficients beside those of another law read at the same scale of the speed.
    #[must_use]
    pub fn beside(&self, reference: &FittedLaw) -> Vec<CoefficientComparison> {
        let of = |numbers: [&[f64]; 3]| -> Vec<f64> { numbers.concat() };
        let intervals = [&self.force.intervals[..], &self.area.intervals, &self.friction.intervals].concat();
        let values = of([&self.force.coefficients, &self.area.coefficients, &self.friction.coefficients]);
        let errors =
            of([&self.force.standard_errors, &self.area.standard_errors, &self.friction.standard_errors]);
        let references = of([&reference.force, &reference.area, &reference.friction]);
        let numbers = values.into_iter().zip(errors).zip(intervals).zip(references);
        NAMES
            .into_iter()
            .zip(numbers)
            .map(|(name, (((value, standard_error), interval), reference))| CoefficientComparison {
                name,
                value,
                standard_error,
                interval,
                reference,
            })
            .collect()
    }
}

/// Fits (34), (36), (38) to computed contacts, with log₁₀ v̂ shifted by `log10_velocity_scale` before it enters (−2: the axis on
/// which the coefficients of the paper agree with computation).
///
/// Start values come from the samples. Standard errors are those of the linearised least squares, s²(JᵀJ)⁻¹, with s² the
/// residual variance; the 95 % intervals take Student's t with as many degrees of freedom as samples exceed coefficients.
/// They say how well the samples determine the coefficients, not how well the functions describe the contact: where the
/// residuals are the functions' own, they are not independent. Samples of an interpolated law are as many as the contacts
/// that it was made from: [`LawFit::of_independent`].
///
/// # Errors
/// Samples that are not finite, speeds or depths that are not positive; samples too few or too alike; no convergence.
pub fn fit_law(
    samples: &[FitSample],
    log10_velocity_scale: f64,
    weighting: Weighting,
) -> Result<LawFit, FitError> {
    if !log10_velocity_scale.is_finite() {
        return Err(FitError::InvalidVelocityScale { log10_velocity_scale });
    }
    check(samples)?;
    let observations = |power: f64, select: fn(&PerQuantity<f64>) -> f64| -> Vec<Observation> {
        samples
            .iter()
            .map(|sample| {
                let scale = libm::pow(sample.indentation, power);
                Observation {
                    log10_velocity: libm::log10(sample.velocity) + log10_velocity_scale,
                    log10_indentation: libm::log10(sample.indentation),
                    value: select(&sample.values) / scale,
                    weight: if weighting == Weighting::Absolute { scale } else { 1.0 },
                }
            })
            .collect()
    };
    let forces = observations(1.5, |values| values.force);
    let areas = observations(1.0, |values| values.area);
    let frictions = observations(0.5, |values| values.friction);
    let [of_force, of_area, of_friction] = FUNCTIONS;
    let mut fit = LawFit {
        force: fit_function(of_force, &forces, force, |data| start::force(of_force, data))?,
        area: fit_function(of_area, &areas, area, |data| start::area(of_area, data))?,
        friction: fit_function(of_friction, &frictions, friction, |data| start::friction(of_friction, data))?,
        log10_velocity_scale,
    };
    // the functions are even in the widths
    fit.area.make_positive(4);
    fit.friction.make_positive(3);
    Ok(fit)
}

fn check(samples: &[FitSample]) -> Result<(), FitError> {
    for (index, sample) in samples.iter().enumerate() {
        for (name, value) in [("velocity v τ/R", sample.velocity), ("indentation δ/R", sample.indentation)]
        {
            if !(value > 0.0 && value.is_finite()) {
                let requirement = "positive and finite";
                return Err(FitError::InvalidSample { index, name, value, requirement });
            }
        }
        let PerQuantity { force, area, friction } = sample.values;
        for (name, value) in [("force", force), ("area", area), ("friction", friction)] {
            if !value.is_finite() {
                return Err(FitError::InvalidSample { index, name, value, requirement: "finite" });
            }
        }
    }
    Ok(())
}
