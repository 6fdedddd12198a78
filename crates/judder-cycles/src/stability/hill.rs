//! Floquet multipliers by the method of G. W. Hill: a second opinion, without steps.
//!
//! Small motions about a cycle are sought as e^{st} times a motion of its period. With v = ẋ their harmonics make of
//!
//! ```text
//! M δẍ + C δẋ + K δx = Pᵀ G(τ) δy,     G = (1 − ∂π/∂λ)⁻¹ ∂π/∂y
//! ```
//!
//! an eigenvalue problem, s (x, v) = H (x, v). Of the 2 n (2 H + 1) eigenvalues those of one exponent lie i ω apart, one for every shift of its vector by a harmonic; the one that the
//! harmonics know best has its harmonics about the mean: those are taken whose weighted mean harmonic Σ h |x_h|² / Σ |x_h|² is nearest zero (G. Moore, SIAM J. Numer. Anal. 42, 2005;
//! A. Lazarus, O. Thomas, C. R. Mécanique 338, 2010).

use super::doubled::sort;
use super::{CycleStability, apart, verdict};
use crate::CyclesError;
use crate::backbone::PeriodicMotion;
use crate::balance::HarmonicBalance;
use crate::path::GoOn;
use crate::point_law::ProjectedForce;
use faer::{Mat, c64};
use judder_dense::general::{PickedEigenvalues, real_eigen, solve};
use judder_nonsmooth::contact_problem::PointMotion;
use judder_numerics::complex::ElementaryComplex;
use judder_numerics::order::sort_by_numbers;
use std::f64::consts::TAU;
use thiserror::Error;

/// The multipliers of a cycle by Hill's method.
#[derive(Debug, Clone, PartialEq)]
pub struct HillMultipliers {
    /// All but the one that belongs to the phase, the largest first.
    pub values: Vec<c64>,
    /// That of the phase, which should be 1: of motions that nothing drives.
    pub phase: Option<c64>,
    /// By how much the largest differs between three quarters of the harmonics and all of them, and that of the phase from 1.
    pub error: f64,
}

/// Why Hill's method has no multipliers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
pub enum HillRefusal {
    /// The force of a point does not follow from its motion.
    #[error("contact point {} sticks, turns, or is rigid: its force does not follow smoothly from its motion", point + 1)]
    NotSmooth {
        /// The point, counted from 0.
        point: usize,
    },
    /// A coordinate has no mass.
    #[error("a coordinate has no mass")]
    NoMass,
    /// The eigenvalue problem is too large.
    #[error("the eigenvalue problem has {rows} rows: eigenvalues are computed of up to {most}")]
    TooLarge {
        /// Rows of the eigenvalue problem.
        rows: usize,
        /// The most.
        most: usize,
    },
    /// Exponents are missing among those whose harmonics lie about the mean.
    #[error("with {harmonics} harmonics {found} of {expected} exponents are found: take more harmonics")]
    FewHarmonics {
        /// H.
        harmonics: usize,
        /// Exponents found.
        found: usize,
        /// Twice the coordinates.
        expected: usize,
    },
}

/// Rows of the eigenvalue problem, which costs as their cube: some seconds.
pub const HILL_ROWS: usize = 1000;

impl HillMultipliers {
    /// What they say; nothing where another multiplier may be that of the phase, and would let them say something else.
    #[must_use]
    pub fn verdict(&self) -> CycleStability {
        verdict(&self.values, self.phase, self.error)
    }
}

/// The multipliers of a periodic motion, driven or not, whose contact forces follow smoothly from its motion, where the eigenvalue problem has no more than `most` rows.
///
/// # Errors
/// [`CyclesError::Singular`], [`CyclesError::Stopped`].
pub fn hill_multipliers(
    balance: &HarmonicBalance<'_>,
    cycle: &PeriodicMotion,
    most: usize,
    go_on: &GoOn<'_>,
) -> Result<Result<HillMultipliers, HillRefusal>, CyclesError> {
    let harmonics = balance.series().harmonics();
    // first what a smaller problem would not mend
    let slopes = match slopes_of_points(balance, cycle)? {
        Ok(slopes) => slopes,
        Err(refusal) => return Ok(Err(refusal)),
    };
    let rows = 2 * balance.bodies().coordinates() * balance.series().coefficients();
    if rows > most {
        return Ok(Err(HillRefusal::TooLarge { rows, most }));
    }
    let problem = match SmallMotions::about(balance, cycle.turning.frequency, &slopes, go_on)? {
        Ok(problem) => problem,
        Err(refusal) => return Ok(Err(refusal)),
    };
    asked(go_on)?;
    let found = match problem.exponents(harmonics)? {
        Ok(found) => found,
        Err(refusal) => return Ok(Err(refusal)),
    };
    asked(go_on)?;
    let fewer = match problem.exponents((3 * harmonics).div_ceil(4))? {
        Ok(fewer) => fewer,
        Err(refusal) => return Ok(Err(refusal)),
    };
    let (_, moving) = balance.coordinates(&cycle.unknown, cycle.turning)?;
    let told = |found: &Exponents| found.told(&problem, &moving, balance.is_driven());
    let (values, phase) = told(&found);
    let error = apart(&values, &told(&fewer).0).max(phase.map_or(0.0, |phase| (phase - 1.0).modulus()));
    Ok(Ok(HillMultipliers { values, phase, error }))
}

fn asked(go_on: &GoOn<'_>) -> Result<(), CyclesError> {
    if go_on() { Ok(()) } else { Err(CyclesError::Stopped) }
}

/// Small motions about a cycle.
struct SmallMotions {
    omega: f64,
    coordinates: usize,
    coefficients: usize,
    /// M⁻¹ C and M⁻¹ K.
    bodies: [Mat<f64>; 2],
    /// What a coefficient of a velocity (0) or of a displacement (1) gives accelerations by contact: columns of all coefficients of a coordinate.
    contact: [Mat<f64>; 2],
}

/// Exponents with their vectors.
struct Exponents {
    values: Vec<c64>,
    /// Displacements: coefficients of each coordinate, a vector an exponent.
    vectors: Vec<Vec<c64>>,
    coefficients: usize,
}

impl SmallMotions {
    fn about(
        balance: &HarmonicBalance<'_>,
        omega: f64,
        slopes: &[Mat<f64>],
        go_on: &GoOn<'_>,
    ) -> Result<Result<Self, HillRefusal>, CyclesError> {
        let (bodies, series) = (balance.bodies(), balance.series());
        let (Some(rates), Some(pushes)) = (bodies.free_rates(), bodies.mobility()) else {
            return Ok(Err(HillRefusal::NoMass));
        };
        let (coordinates, coefficients) = (bodies.coordinates(), series.coefficients());
        let dimension = balance.contact().dimension;
        let size = coordinates * coefficients;
        let mut contact = [Mat::zeros(size, size), Mat::zeros(size, size)];
        let mut block = vec![0.0; coefficients * coefficients];
        for (point, slopes) in slopes.iter().enumerate() {
            asked(go_on)?;
            let factors = series.of_factors(slopes.as_ref());
            for which in 0..dimension * dimension {
                let (row, column) = (point * dimension + which / dimension, which % dimension);
                series.multiplication(factors.col_as_slice(which), &mut block);
                let own: Vec<f64> = (0..coordinates).map(|k| pushes[(k, row)]).collect();
                for (order, motion) in bodies.seen(point * dimension + column).iter().enumerate() {
                    add_block(&mut contact[order], &own, motion, &block, coefficients);
                }
            }
        }
        Ok(Ok(Self { omega, coordinates, coefficients, bodies: rates, contact }))
    }

    /// H with so many harmonics.
    fn matrix(&self, harmonics: usize) -> Mat<f64> {
        let (all, size) = (self.coefficients, 2 * harmonics + 1);
        let half = self.coordinates * size;
        let mut matrix = Mat::zeros(2 * half, 2 * half);
        for k in 0..self.coordinates {
            for coefficient in 0..size {
                let row = k * size + coefficient;
                matrix[(row, half + row)] = 1.0;
                for l in 0..self.coordinates {
                    for (order, from) in [half, 0].into_iter().enumerate() {
                        matrix[(half + row, from + l * size + coefficient)] -= self.bodies[order][(k, l)];
                        for other in 0..size {
                            matrix[(half + row, from + l * size + other)] +=
                                self.contact[order][(k * all + coefficient, l * all + other)];
                        }
                    }
                }
            }
            for harmonic in 1..=harmonics {
                // (a cos hτ + b sin hτ)˙ = h ω (b cos hτ − a sin hτ)
                let turned = harmonic as f64 * self.omega;
                for first in [k * size, half + k * size] {
                    let (cosine, sine) = (first + 2 * harmonic - 1, first + 2 * harmonic);
                    matrix[(cosine, sine)] -= turned;
                    matrix[(sine, cosine)] += turned;
                }
            }
        }
        matrix
    }

    /// One eigenvalue of each exponent, whose harmonics lie about the mean.
    fn exponents(&self, harmonics: usize) -> Result<Result<Exponents, HillRefusal>, CyclesError> {
        /// An exponent whose vector is shifted by a harmonic has a mean harmonic beyond ½.
        const ABOUT: f64 = 0.55;
        /// Two eigenvalues so near a multiple of i ω from each other, of ω, are of one exponent.
        const SAME: f64 = 1e-4;
        let (coefficients, expected) = (2 * harmonics + 1, 2 * self.coordinates);
        let half = self.coordinates * coefficients;
        let PickedEigenvalues { values, right, .. } =
            real_eigen(&self.matrix(harmonics), &|_| true).ok_or(CyclesError::Singular)?;
        let vector = |k: usize| -> Vec<c64> { (0..half).map(|row| right[(row, k)]).collect() };
        let mut all: Vec<(f64, c64, Vec<c64>)> = (0..values.len())
            .map(|k| (mean_harmonic(&vector(k), coefficients), values[k], vector(k)))
            .filter(|own| own.0.abs() < ABOUT)
            .collect();
        sort_by_numbers(&mut all, |own| [own.0.abs(), -own.1.im]);
        let mut found = Exponents { values: Vec::new(), vectors: Vec::new(), coefficients };
        for (_, value, vector) in all {
            let is_shifted = |other: &c64| {
                let apart = (value - other) / self.omega;
                let turns = apart.im.round();
                turns != 0.0 && (apart - c64::new(0.0, turns)).modulus() < SAME
            };
            if found.values.len() < expected && !found.values.iter().any(is_shifted) {
                found.values.push(value);
                found.vectors.push(vector);
            }
        }
        let count = found.values.len();
        Ok(if count == expected {
            Ok(found)
        } else {
            Err(HillRefusal::FewHarmonics { harmonics, found: count, expected })
        })
    }
}

impl Exponents {
    /// Multipliers, that of the phase apart: its vector lies along the velocity of the cycle, of which harmonics of the coordinates are known.
    fn told(&self, problem: &SmallMotions, moving: &[Vec<c64>], is_driven: bool) -> (Vec<c64>, Option<c64>) {
        let period = TAU / problem.omega;
        let mut values: Vec<c64> = self.values.iter().map(|own| (own * period).exponential()).collect();
        let along = |vector: &[c64]| -> f64 {
            let of = |k: usize, harmonic: usize| {
                // cosine and sine of i h x_h
                let (x, first) = (moving[harmonic - 1][k], k * self.coefficients + 2 * harmonic - 1);
                harmonic as f64 * (vector[first] * -x.im - vector[first + 1] * x.re)
            };
            let harmonics = self.coefficients / 2;
            let all = (0..problem.coordinates).flat_map(|k| (1..=harmonics).map(move |h| (k, h)));
            let size: f64 = vector.iter().map(c64::norm_sqr).sum();
            all.map(|(k, harmonic)| of(k, harmonic)).sum::<c64>().modulus() / size.sqrt()
        };
        let sizes: Vec<f64> = self.vectors.iter().map(|own| along(own)).collect();
        let most = (0..sizes.len()).max_by(|a, b| sizes[*a].total_cmp(&sizes[*b]));
        let phase = most.filter(|_| !is_driven).map(|k| values.remove(k));
        sort(&mut values);
        (values, phase)
    }
}

/// Σ h |x_h|² / Σ |x_h|² over positive and negative harmonics of all coordinates.
fn mean_harmonic(vector: &[c64], coefficients: usize) -> f64 {
    let (mut first, mut all) = (0.0, 0.0);
    for own in vector.chunks_exact(coefficients) {
        all += own[0].norm_sqr();
        for (k, pair) in own[1..].chunks_exact(2).enumerate() {
            let turned = c64::new(0.0, 1.0) * pair[1];
            let [ahead, back] = [pair[0] - turned, pair[0] + turned].map(|own| 0.25 * own.norm_sqr());
            first += (k + 1) as f64 * (ahead - back);
            all += ahead + back;
        }
    }
    first / all
}

/// G of every point at all instants.
fn slopes_of_points(
    balance: &HarmonicBalance<'_>,
    cycle: &PeriodicMotion,
) -> Result<Result<Vec<Mat<f64>>, HillRefusal>, CyclesError> {
    let (series, dimension) = (balance.series(), balance.contact().dimension);
    let signals = balance.signals_at(&cycle.unknown, cycle.turning)?;
    let projected = balance.projected(series, &signals);
    let motions = series.values(signals.motions.as_ref());
    let of = |point: usize| {
        let mut slopes =
            smooth_slopes(projected.of_point(point), dimension).ok_or(HillRefusal::NotSmooth { point })?;
        place_jumps(&mut slopes, motions.col_as_slice(point * dimension));
        Ok(slopes)
    };
    Ok((0..balance.contact().points.len()).map(of).collect())
}

/// G of a point at all instants, an entry a column, row after row; `None` where it sticks, is rigid, or its slip turns from one instant to the next.
fn smooth_slopes(of_point: &[ProjectedForce], dimension: usize) -> Option<Mat<f64>> {
    let mut slopes = Mat::zeros(of_point.len(), dimension * dimension);
    for (instant, own) in of_point.iter().enumerate() {
        let next = &of_point[(instant + 1) % of_point.len()];
        let turns = (1..dimension).map(|k| own.force[k] * next.force[k]).sum::<f64>() < 0.0;
        if own.state == PointMotion::Stick || turns {
            return None;
        }
        let left =
            Mat::from_fn(dimension, dimension, |i, j| f64::from(u8::from(i == j)) - own.by_force[i][j]);
        let mut right = Mat::from_fn(dimension, dimension, |i, j| own.by_motion[i][j]);
        solve(left, &mut right)?;
        for which in 0..dimension * dimension {
            slopes[(instant, which)] = right[(which / dimension, which % dimension)];
        }
    }
    Some(slopes)
}

/// G jumps where the gap passes through zero, which sums over instants take to be midway between two of them: both get half of what is missed, so that the error is that of a kink.
fn place_jumps(slopes: &mut Mat<f64>, gaps: &[f64]) {
    for which in 0..slopes.ncols() {
        let own = slopes.col_as_slice(which).to_vec();
        let mut moved = |instant: usize, by: f64| slopes[(instant, which)] += by;
        for (instant, gap) in gaps.iter().enumerate() {
            let next = (instant + 1) % gaps.len();
            if (*gap < 0.0) != (gaps[next] < 0.0) {
                let missed = 0.5 * (0.5 - gap / (gap - gaps[next])) * (own[next] - own[instant]);
                [instant, next].into_iter().for_each(|instant| moved(instant, missed));
            }
        }
    }
}

/// Adds what a motion of a point makes of the accelerations, times a factor that is known as a block of coefficients.
fn add_block(matrix: &mut Mat<f64>, pushes: &[f64], motion: &[f64], block: &[f64], size: usize) {
    for (l, motion) in motion.iter().enumerate().filter(|(_, motion)| **motion != 0.0) {
        for (k, push) in pushes.iter().enumerate() {
            for (column, from) in block.chunks_exact(size).enumerate() {
                for (row, factor) in from.iter().enumerate() {
                    matrix[(k * size + row, l * size + column)] += push * motion * factor;
                }
            }
        }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    /// Of a mass that swings freely with half of the frequency of the cycle both exponents, ± i ω/2, are one: the multiplier −1 is twofold, and one vector of two is told.
    #[test]
    fn exponents_that_cannot_be_told_apart_are_refused() {
        let one = |value: f64| Mat::from_fn(1, 1, |_, _| value);
        let none = || Mat::zeros(7, 7);
        let at = |stiffness: f64| SmallMotions {
            omega: 2.0,
            coordinates: 1,
            coefficients: 7,
            bodies: [one(0.0), one(stiffness)],
            contact: [none(), none()],
        };
        assert_eq!(at(1.3).exponents(3).unwrap().unwrap().values.len(), 2);
        let Err(refusal) = at(1.0).exponents(3).unwrap() else { panic!("it is told") };
        assert_eq!(refusal, HillRefusal::FewHarmonics { harmonics: 3, found: 1, expected: 2 });
        assert_eq!(refusal.to_string(), "with 3 harmonics 1 of 2 exponents are found: take more harmonics");
    }
}
