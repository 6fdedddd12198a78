//! A Prony series fitted to measured moduli.

use super::creep::CreepSpectrum;
use super::dma::{DmaData, DmaPoint};
use super::error::MaterialError;
use super::nonnegative::{NonNegativeSolution, non_negative_least_squares};
use super::relaxation::{RelaxationSpectrum, RelaxationTerm, maxwell};
use nalgebra::{DMatrix, DVector};

/// Largest number of relaxation times that a fit tries.
pub const MOST_TERMS: usize = 60;
/// The row of relaxation times lies within the inverse band of the data and this factor beyond it: a term further out would be
/// seen by the data as a constant or a straight line only.
const OVERHANG: f64 = 10.0;
/// Parts of the range in which the ends of the row are looked for first.
const COARSE_PARTS: usize = 6;
/// Halvings of the step with which they are moved then.
const HALVINGS: usize = 6;
/// A longer series must lower the rms deviation by this factor within [`PATIENCE`] more terms to be worth it.
const GAIN: f64 = 0.95;
/// Terms after which a series that has not gained is given up.
const PATIENCE: usize = 4;

/// How many relaxation times the fit may use. Those to which the data give no weight are dropped.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum TermCount {
    /// This many, evenly spaced in log time.
    Exactly(usize),
    /// As few as keep E′ and E″ within `deviation` (relative) at every point; if none does, the count after which more terms
    /// gain nothing, at most `most`.
    Within {
        /// Largest relative deviation at any point.
        deviation: f64,
        /// Largest number of terms.
        most: usize,
    },
}

/// How far the series is from the data at one frequency.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PronyResidual {
    /// ω [rad/s].
    pub angular_frequency: f64,
    /// (E′ of the series − E′ measured)/E′ measured.
    pub storage: f64,
    /// (E″ of the series − E″ measured)/E″ measured.
    pub loss: f64,
}

/// A Prony series for measured moduli, in both forms, with its quality.
#[derive(Debug, Clone, PartialEq)]
pub struct PronyFit {
    /// The series as fitted: E0 and (ρ_j, E_j).
    pub relaxation: RelaxationSpectrum,
    /// The same material in creep form: E∞ and (τ_k, C_k).
    pub creep: CreepSpectrum,
    /// Relaxation times offered to the fit; those without weight are not in the series.
    pub candidates: usize,
    /// r² of ln E′: 1 − Σ(ln E′ − ln Ê′)²/Σ(ln E′ − mean)².
    pub storage_r_squared: f64,
    /// r² of ln E″.
    pub loss_r_squared: f64,
    /// Largest relative deviation of E′.
    pub storage_deviation: f64,
    /// Largest relative deviation of E″.
    pub loss_deviation: f64,
    /// Root mean square of all relative deviations, which the fit makes least.
    pub rms_deviation: f64,
    /// Violation of the conditions of a minimum, see [`NonNegativeSolution::optimality`].
    pub optimality: f64,
    /// Point by point, in the order of the data.
    pub residuals: Vec<PronyResidual>,
}

impl PronyFit {
    /// Fits E(ω) = E0 + Σ E_j iωρ_j/(1 + iωρ_j), E_j ≥ 0, to the data: least squares of the relative deviations of E′ and E″.
    ///
    /// The relaxation times are evenly spaced in the logarithm. Where their row begins and ends, within the inverse band of the data
    /// and a decade beyond, is where the deviation is least: on a coarse grid, then by steps that halve. The moduli follow by
    /// non-negative least squares. Outside the measured band the series is an extrapolation: E∞ comes from the highest
    /// frequencies and E0 from the lowest, unless `rubbery_modulus` \[Pa\] gives it.
    ///
    /// # Errors
    /// [`MaterialError::Terms`]; [`MaterialError::NoPlateau`] when the fit leaves no modulus at rest;
    /// [`MaterialError::RubberyAboveData`] for a given E0 that is not below every measured E′; [`MaterialError::NotPositive`] for it
    /// or for a tolerance.
    pub fn new(
        data: &DmaData,
        terms: TermCount,
        rubbery_modulus: Option<f64>,
    ) -> Result<Self, MaterialError> {
        if let Some(rubbery) = rubbery_modulus {
            super::error::positive("the rubbery modulus E0 [Pa]", rubbery)?;
            let lowest =
                data.points().iter().map(|point| point.storage_modulus).fold(f64::INFINITY, f64::min);
            if rubbery >= lowest {
                return Err(MaterialError::RubberyAboveData { rubbery, lowest });
            }
        }
        let system = RelaxationSystem { points: data.points(), band: data.band(), rubbery_modulus };
        match terms {
            TermCount::Exactly(count) => system.fit(within_bounds(count)?),
            TermCount::Within { deviation, most } => {
                super::error::positive("the largest deviation", deviation)?;
                system.fit_within(deviation, within_bounds(most)?)
            }
        }
    }

    /// The larger of the largest deviations of E′ and E″.
    #[must_use]
    pub fn worst_deviation(&self) -> f64 {
        self.storage_deviation.max(self.loss_deviation)
    }

    /// The fit to the same data measured at frequencies `factor` times as high: all times are shorter by as much, the moduli stay.
    ///
    /// # Errors
    /// [`MaterialError::NotPositive`] for the factor, [`MaterialError::Term`] for a time that leaves the numbers.
    pub fn moved_by(mut self, factor: f64) -> Result<Self, MaterialError> {
        super::error::positive("the shift factor a_T", factor)?;
        self.creep = self.creep.with_times_multiplied(1.0 / factor)?;
        let term = |term: &RelaxationTerm| RelaxationTerm {
            relaxation_time: term.relaxation_time / factor,
            modulus: term.modulus,
        };
        let terms = self.relaxation.terms().iter().map(term).collect();
        self.relaxation = RelaxationSpectrum::new(self.relaxation.rubbery_modulus(), terms)?;
        self.residuals.iter_mut().for_each(|residual| residual.angular_frequency *= factor);
        Ok(self)
    }

    fn measured(
        points: &[DmaPoint],
        relaxation: RelaxationSpectrum,
        candidates: usize,
        optimality: f64,
    ) -> Result<Self, MaterialError> {
        let fitted: Vec<_> =
            points.iter().map(|point| relaxation.complex_modulus(point.angular_frequency)).collect();
        let pairs = || points.iter().zip(&fitted);
        let residuals: Vec<PronyResidual> = pairs()
            .map(|(point, fitted)| PronyResidual {
                angular_frequency: point.angular_frequency,
                storage: fitted.re / point.storage_modulus - 1.0,
                loss: fitted.im / point.loss_modulus - 1.0,
            })
            .collect();
        let squares = residuals.iter().map(|r| r.storage * r.storage + r.loss * r.loss).sum::<f64>();
        let largest =
            |part: fn(&PronyResidual) -> f64| residuals.iter().map(|r| part(r).abs()).fold(0.0, f64::max);
        Ok(Self {
            creep: relaxation.creep_form()?,
            storage_r_squared: r_squared(pairs().map(|(point, fitted)| (point.storage_modulus, fitted.re))),
            loss_r_squared: r_squared(pairs().map(|(point, fitted)| (point.loss_modulus, fitted.im))),
            storage_deviation: largest(|r| r.storage),
            loss_deviation: largest(|r| r.loss),
            rms_deviation: (squares / (2 * residuals.len()) as f64).sqrt(),
            relaxation,
            candidates,
            optimality,
            residuals,
        })
    }
}

fn within_bounds(terms: usize) -> Result<usize, MaterialError> {
    if (1..=MOST_TERMS).contains(&terms) {
        Ok(terms)
    } else {
        Err(MaterialError::Terms { terms, most: MOST_TERMS })
    }
}

/// 1 − Σ(ln a − ln b)²/Σ(ln a − mean)² over (measured, fitted); 1 where the measured do not vary and the fitted agree.
fn r_squared(pairs: impl Iterator<Item = (f64, f64)>) -> f64 {
    let pairs: Vec<(f64, f64)> =
        pairs.map(|(measured, fitted)| (libm::log(measured), libm::log(fitted))).collect();
    let mean = pairs.iter().map(|pair| pair.0).sum::<f64>() / pairs.len() as f64;
    let left: f64 = pairs.iter().map(|(measured, fitted)| (measured - fitted).powi(2)).sum();
    let all: f64 = pairs.iter().map(|(measured, _)| (measured - mean).powi(2)).sum();
    if left == 0.0 { 1.0 } else { 1.0 - left / all }
}

/// The least-squares problem, but for its relaxation times.
struct RelaxationSystem<'a> {
    points: &'a [DmaPoint],
    band: (f64, f64),
    rubbery_modulus: Option<f64>,
}

impl RelaxationSystem<'_> {
    fn fit_within(&self, deviation: f64, most: usize) -> Result<PronyFit, MaterialError> {
        let mut best = self.fit(1)?;
        for count in 2..=most {
            if best.worst_deviation() <= deviation || count > best.candidates + PATIENCE {
                break;
            }
            let fit = self.fit(count)?;
            if fit.worst_deviation() <= deviation || fit.rms_deviation < GAIN * best.rms_deviation {
                best = fit;
            }
        }
        Ok(best)
    }

    /// The best row of `count` relaxation times.
    fn fit(&self, count: usize) -> Result<PronyFit, MaterialError> {
        let FitAttempt { solution, ends } = self.best_row(count)?;
        let times = row(ends.0, ends.1, count);
        let offset = usize::from(self.rubbery_modulus.is_none());
        let rubbery = self.rubbery_modulus.unwrap_or(solution.coefficients[0]);
        if rubbery <= 0.0 {
            return Err(MaterialError::NoPlateau { lowest: self.band.0 });
        }
        let moduli = solution.coefficients[offset..].iter();
        let terms = times.iter().zip(moduli).filter(|(_, modulus)| **modulus > 0.0);
        let terms = terms
            .map(|(time, modulus)| RelaxationTerm { relaxation_time: *time, modulus: *modulus })
            .collect();
        let relaxation = RelaxationSpectrum::new(rubbery, terms)?;
        PronyFit::measured(self.points, relaxation, count, solution.optimality)
    }

    /// The ends of the row, as logarithms of times, that leave the least deviation.
    fn best_row(&self, count: usize) -> Result<FitAttempt, MaterialError> {
        let (shortest, longest) =
            (libm::log(1.0 / self.band.1 / OVERHANG), libm::log(OVERHANG / self.band.0));
        let attempt = |ends: (f64, f64)| -> Result<FitAttempt, MaterialError> {
            let ends = (ends.0.clamp(shortest, longest), ends.1.clamp(shortest, longest));
            let ends = (ends.0, if count == 1 { ends.0 } else { ends.1.max(ends.0) });
            Ok(FitAttempt { solution: self.moduli(&row(ends.0, ends.1, count))?, ends })
        };
        let coarse = (longest - shortest) / COARSE_PARTS as f64;
        let at = |k: usize| shortest + k as f64 * coarse;
        let mut best = attempt((shortest, longest))?;
        for first in 0..=COARSE_PARTS {
            for last in first + 1..=COARSE_PARTS {
                best = best.or_better(attempt((at(first), at(last)))?);
            }
        }
        let mut step = coarse;
        for _ in 0..HALVINGS {
            step *= 0.5;
            let (first, last) = best.ends;
            let moves = [(-step, 0.0), (step, 0.0), (0.0, -step), (0.0, step)];
            for (before, after) in moves {
                best = best.or_better(attempt((first + before, last + after))?);
            }
        }
        Ok(best)
    }

    /// The moduli for given relaxation times, E0 before them unless it is given: two rows a point, each over its measured value.
    fn moduli(&self, times: &[f64]) -> Result<NonNegativeSolution, MaterialError> {
        let count = self.points.len();
        let offset = usize::from(self.rubbery_modulus.is_none());
        let entry = |row: usize, column: usize| {
            let point = &self.points[row % count];
            let (measured, is_storage) =
                if row < count { (point.storage_modulus, true) } else { (point.loss_modulus, false) };
            if column < offset {
                return if is_storage { 1.0 / measured } else { 0.0 };
            }
            let response = maxwell(point.angular_frequency * times[column - offset]);
            if is_storage { response.re / measured } else { response.im / measured }
        };
        let matrix = DMatrix::from_fn(2 * count, times.len() + offset, entry);
        let at_rest = self.rubbery_modulus.unwrap_or(0.0);
        let right = DVector::from_fn(2 * count, |row, _| {
            if row < count { 1.0 - at_rest / self.points[row].storage_modulus } else { 1.0 }
        });
        non_negative_least_squares(&matrix, &right)
    }
}

/// A row of relaxation times, by the logarithms of its ends, with its moduli.
struct FitAttempt {
    solution: NonNegativeSolution,
    ends: (f64, f64),
}

impl FitAttempt {
    fn or_better(self, other: Self) -> Self {
        if other.solution.residual < self.solution.residual { other } else { self }
    }
}

/// `count` times, evenly spaced in the logarithm.
fn row(first: f64, last: f64, count: usize) -> Vec<f64> {
    let intervals = (count - 1).max(1) as f64;
    (0..count).map(|k| libm::exp(first + (last - first) * k as f64 / intervals)).collect()
}
