//! Damping as a real matrix C: proportional to mass and stiffness, viscous in place of structural, or by ratios of modes.

use crate::StructureError;
use crate::assembly::Sparse;
use crate::modes::{Mode, WantedModes, modes};
use crate::statics::{sum, symmetric_product};
use faer::sparse::Triplet;
use std::f64::consts::TAU;

/// By how much a matrix may differ from α M + β K, as a share of its largest entry: digits of a file.
const FIT: f64 = 1e-8;

/// Rayleigh damping, C = α M + β K.
///
/// Of a mode with ω it takes the share ζ = α/(2ω) + β ω/2 of critical damping: between two frequencies at which ζ is given it is
/// smaller, beyond them larger, and of the highest frequencies of a mesh it can be overcritical.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RayleighDamping {
    alpha: f64,
    beta: f64,
}

impl RayleighDamping {
    /// α in 1/s and β in s, neither negative.
    ///
    /// # Errors
    /// [`StructureError::InvalidNumber`].
    pub fn new(alpha: f64, beta: f64) -> Result<Self, StructureError> {
        Ok(Self {
            alpha: not_negative("the damping by mass, α", alpha)?,
            beta: not_negative("the damping by stiffness, β", beta)?,
        })
    }

    /// The damping with these ratios ζ at two frequencies in Hz, each given as (frequency, ratio).
    ///
    /// β = 2 (ζ₂ω₂ − ζ₁ω₁)/(ω₂² − ω₁²), α = 2 ω₁ω₂ (ζ₁ω₂ − ζ₂ω₁)/(ω₂² − ω₁²).
    ///
    /// # Errors
    /// [`StructureError::InvalidNumber`] for a frequency or ratio that is not positive, or one frequency twice;
    /// [`StructureError::NoRayleighDamping`] for ratios further apart than the frequencies, which want a negative α or β.
    pub fn through(first: (f64, f64), second: (f64, f64)) -> Result<Self, StructureError> {
        for (frequency, ratio) in [first, second] {
            positive("the frequency of a damping ratio", frequency)?;
            not_negative("a damping ratio", ratio)?;
        }
        let ((low, at_low), (high, at_high)) =
            if first.0 < second.0 { (first, second) } else { (second, first) };
        positive("the distance of the two frequencies of damping ratios", high - low)?;
        let (w1, w2) = (TAU * low, TAU * high);
        let span = (w2 - w1) * (w2 + w1);
        let alpha = 2.0 * w1 * w2 * (at_low * w2 - at_high * w1) / span;
        let beta = 2.0 * (at_high * w2 - at_low * w1) / span;
        if alpha < 0.0 || beta < 0.0 {
            return Err(StructureError::NoRayleighDamping {
                ratios: [at_low, at_high],
                frequencies: [low, high],
            });
        }
        Self::new(alpha, beta)
    }

    /// The damping whose matrix α M + β K is this one, by least squares over all entries, each matrix over its largest one; none of a
    /// matrix without entries.
    ///
    /// # Errors
    /// [`StructureError::DifferentSizes`]; [`StructureError::NotProportional`] for a matrix that is no such sum: it couples modes;
    /// [`StructureError::NegativeDamping`].
    pub fn fitted(damping: &Sparse, mass: &Sparse, stiffness: &Sparse) -> Result<Self, StructureError> {
        for other in [mass, stiffness] {
            let [first, second] = [damping, other].map(|matrix| [matrix.nrows(), matrix.ncols()]);
            if first != second {
                return Err(StructureError::DifferentSizes { first, second });
            }
        }
        let [of_damping, of_mass, of_stiffness] = [damping, mass, stiffness].map(largest);
        if of_damping == 0.0 {
            return Ok(Self { alpha: 0.0, beta: 0.0 });
        }
        let entries: Vec<[f64; 3]> = entries([damping, mass, stiffness])
            .into_iter()
            .map(|row| [row[0] / of_damping, row[1] / of_mass, row[2] / of_stiffness])
            .collect();
        let product = |i: usize, j: usize| entries.iter().map(|row| row[i] * row[j]).sum::<f64>();
        let [mm, mk, kk] = [product(1, 1), product(1, 2), product(2, 2)];
        let [cm, ck] = [product(0, 1), product(0, 2)];
        let determinant = mm * kk - mk * mk;
        let (alpha, beta) = ((cm * kk - ck * mk) / determinant, (ck * mm - cm * mk) / determinant);
        let left = |[c, m, k]: &[f64; 3]| (c - alpha * m - beta * k).abs();
        let departure = entries
            .iter()
            .map(left)
            .fold(0.0, |most: f64, left| if left > most || left.is_nan() { left } else { most });
        if departure > FIT || departure.is_nan() {
            return Err(StructureError::NotProportional { departure, tolerance: FIT });
        }
        // what is rounding of a zero is one
        let clean = |share: f64| if share.abs() <= FIT { 0.0 } else { share };
        let (alpha, beta) = (clean(alpha) * of_damping / of_mass, clean(beta) * of_damping / of_stiffness);
        if alpha < 0.0 || beta < 0.0 {
            return Err(StructureError::NegativeDamping { alpha, beta });
        }
        Self::new(alpha, beta)
    }

    /// α in 1/s.
    #[must_use]
    pub fn alpha(&self) -> f64 {
        self.alpha
    }

    /// β in s.
    #[must_use]
    pub fn beta(&self) -> f64 {
        self.beta
    }

    /// ζ = α/(2ω) + β ω/2 of a mode with this frequency in Hz, ω = 2π times it; infinite at zero where α is not.
    #[must_use]
    pub fn ratio(&self, frequency: f64) -> f64 {
        let omega = TAU * frequency;
        let by_mass = if self.alpha == 0.0 { 0.0 } else { self.alpha / (2.0 * omega) };
        by_mass + 0.5 * self.beta * omega
    }

    /// C = α M + β K in N s/m.
    ///
    /// # Errors
    /// [`StructureError::DifferentSizes`], [`StructureError::OutOfMemory`].
    pub fn matrix(&self, stiffness: &Sparse, mass: &Sparse) -> Result<Sparse, StructureError> {
        sum(self.beta, stiffness, self.alpha, mass)
    }
}

/// Structural (hysteretic) damping, K (1 + iη), by the viscous damping that takes the same energy from a vibration with ω_ref:
/// C = η K/ω_ref.
///
/// A complex stiffness belongs to one frequency at a time: in a motion over time it is no real matrix. C takes the right energy at
/// ω_ref and ω/ω_ref times too much at ω, so it holds for η ≪ 1 and for vibrations near the reference. Where each mode has its own
/// reference the ratio of all is η/2: in a modal form with M = I that is the diagonal C with η ω.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StructuralDamping {
    loss_factor: f64,
    reference: f64,
}

impl StructuralDamping {
    /// The loss factor η, zero or positive, and the reference frequency in Hz.
    ///
    /// # Errors
    /// [`StructureError::InvalidNumber`].
    pub fn new(loss_factor: f64, reference: f64) -> Result<Self, StructureError> {
        Ok(Self {
            loss_factor: not_negative("the loss factor", loss_factor)?,
            reference: positive("the reference frequency of structural damping", reference)?,
        })
    }

    /// β = η/ω_ref in s of C = β K.
    #[must_use]
    pub fn beta(&self) -> f64 {
        self.loss_factor / (TAU * self.reference)
    }

    /// ζ = η ω/(2 ω_ref) of a mode with this frequency in Hz under C; η/2 at the reference.
    #[must_use]
    pub fn ratio(&self, frequency: f64) -> f64 {
        0.5 * self.loss_factor * frequency / self.reference
    }

    /// C = η K/ω_ref in N s/m.
    #[must_use]
    pub fn matrix(&self, stiffness: &Sparse) -> Sparse {
        let mut damping = stiffness.clone();
        for value in damping.val_mut() {
            *value *= self.beta();
        }
        damping
    }

    /// The entries of C for one mode after the other of a modal form (M = I) with these frequencies in Hz, each mode with its own
    /// reference: η ω in 1/s.
    #[must_use]
    pub fn modal(&self, frequencies: &[f64]) -> Vec<f64> {
        frequencies.iter().map(|frequency| self.loss_factor * TAU * frequency).collect()
    }
}

/// Freedoms of a body whose modes may have ratios of their own: its damping matrix is full.
pub const MOST_FREEDOMS: usize = 2000;

/// Modal damping: a damping ratio ζ_k of each of the lowest modes that swing, C = M Φ diag(2 ζ_k ω_k) Φᵀ M.
///
/// With Φᵀ M Φ = I it gives mode k the ratio ζ_k, couples no modes, and leaves rigid motions and all higher modes without damping. C is full.
///
/// R. W. Clough, J. Penzien, *Dynamics of Structures*, 2nd ed., 1993, section 12.3.
#[derive(Debug, Clone, PartialEq)]
pub struct ModalDamping {
    ratios: Vec<f64>,
}

impl ModalDamping {
    /// The ratios of the lowest modes that swing, by rising frequency; at least one, none negative.
    ///
    /// # Errors
    /// [`StructureError::InvalidNumber`].
    pub fn new(ratios: Vec<f64>) -> Result<Self, StructureError> {
        positive("the number of damping ratios", ratios.len() as f64)?;
        ratios.iter().try_for_each(|ratio| not_negative("a damping ratio", *ratio).map(drop))?;
        Ok(Self { ratios })
    }

    /// C in N s/m.
    ///
    /// # Errors
    /// [`StructureError::TooLargeForRatios`] beyond [`MOST_FREEDOMS`], [`StructureError::TooFewModes`], modes that are not found.
    pub fn matrix(&self, stiffness: &Sparse, mass: &Sparse) -> Result<Sparse, StructureError> {
        let freedoms = mass.nrows();
        if freedoms > MOST_FREEDOMS {
            return Err(StructureError::TooLargeForRatios { freedoms, most: MOST_FREEDOMS });
        }
        let mut damping = vec![0.0; freedoms * freedoms];
        for (ratio, mode) in self.ratios.iter().zip(&self.swinging(stiffness, mass)?) {
            let momentum = symmetric_product(mass, &mode.shape);
            let factor = 2.0 * ratio * mode.eigenvalue.sqrt();
            for (row, own) in momentum.iter().enumerate() {
                for (column, other) in momentum.iter().enumerate() {
                    damping[row * freedoms + column] += factor * own * other;
                }
            }
        }
        let entries = damping.iter().enumerate().filter(|(_, value)| **value != 0.0);
        let entries: Vec<_> =
            entries.map(|(k, value)| Triplet::new(k / freedoms, k % freedoms, *value)).collect();
        Sparse::try_new_from_triplets(freedoms, freedoms, &entries)
            .map_err(|_| StructureError::OutOfMemory { rows: freedoms })
    }

    /// The lowest modes that are no rigid motions, as many as there are ratios.
    fn swinging(&self, stiffness: &Sparse, mass: &Sparse) -> Result<Vec<Mode>, StructureError> {
        /// A body in space has no more; one of several pieces may.
        const RIGID: usize = 6;
        let ratios = self.ratios.len();
        if ratios > mass.nrows() {
            return Err(StructureError::TooFewModes { ratios, modes: mass.nrows() });
        }
        let mut wanted = (ratios + RIGID).min(mass.nrows());
        loop {
            let found = modes(stiffness, mass, WantedModes::Lowest(wanted))?;
            let rigid = found.rigid_modes();
            let known = found.modes.len();
            if known - rigid >= ratios {
                return Ok(found.modes.into_iter().skip(rigid).take(ratios).collect());
            }
            if known < wanted || wanted == mass.nrows() {
                return Err(StructureError::TooFewModes { ratios, modes: known - rigid });
            }
            wanted = (2 * wanted).min(mass.nrows());
        }
    }
}

/// The largest absolute entry; a number that is none counts as larger than any.
fn largest(matrix: &Sparse) -> f64 {
    let larger =
        |most: f64, value: &f64| if value.abs() > most || value.is_nan() { value.abs() } else { most };
    matrix.val().iter().fold(0.0, larger)
}

/// The entries of three matrices at every place where any has one.
fn entries(matrices: [&Sparse; 3]) -> Vec<[f64; 3]> {
    let mut all = Vec::new();
    for column in 0..matrices[0].ncols() {
        let mut rows = std::collections::BTreeMap::<usize, [f64; 3]>::new();
        for (k, matrix) in matrices.iter().enumerate() {
            for (row, value) in matrix.row_idx_of_col(column).zip(matrix.val_of_col(column)) {
                rows.entry(row).or_default()[k] += value;
            }
        }
        all.extend(rows.into_values());
    }
    all
}

fn not_negative(name: &'static str, value: f64) -> Result<f64, StructureError> {
    match value.is_finite() && value >= 0.0 {
        true => Ok(value),
        false => Err(StructureError::InvalidNumber { name, value, requirement: "zero or positive" }),
    }
}

fn positive(name: &'static str, value: f64) -> Result<f64, StructureError> {
    match value.is_finite() && value > 0.0 {
        true => Ok(value),
        false => Err(StructureError::InvalidNumber { name, value, requirement: "positive" }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ratios_are_met_at_both_frequencies_and_smaller_between_them() {
        for (first, second) in [((50.0, 0.01), (2000.0, 0.03)), ((2000.0, 0.03), (50.0, 0.01))] {
            let damping = RayleighDamping::through(first, second).unwrap();
            for (frequency, ratio) in [first, second] {
                assert!((damping.ratio(frequency) / ratio - 1.0).abs() < 1e-14);
            }
            assert!(damping.ratio(300.0) < 0.01 && damping.ratio(1e5) > 1.0 && damping.ratio(0.1) > 1.0);
        }
        let by_stiffness = RayleighDamping::through((100.0, 0.01), (200.0, 0.02)).unwrap();
        assert!(
            by_stiffness.alpha().abs() < 1e-15
                && (by_stiffness.beta() - 0.01 / (100.0 * std::f64::consts::PI)).abs() < 1e-18
        );
        assert_eq!(RayleighDamping::new(0.0, 1e-5).unwrap().ratio(0.0), 0.0);
    }

    #[test]
    fn ratios_that_no_positive_coefficients_meet_are_refused() {
        let error = RayleighDamping::through((100.0, 0.01), (200.0, 0.03)).unwrap_err();
        assert!(matches!(error, StructureError::NoRayleighDamping { .. }), "{error}");
        assert!(error.to_string().contains("0.005 and 0.02"), "{error}");
        for pairs in [
            ((1.0, 0.1), (1.0, 0.1)),
            ((0.0, 0.1), (1.0, 0.1)),
            ((1.0, f64::NAN), (2.0, 0.1)),
            ((1.0, -0.1), (2.0, 0.1)),
        ] {
            assert!(matches!(
                RayleighDamping::through(pairs.0, pairs.1),
                Err(StructureError::InvalidNumber { .. })
            ));
        }
        assert!(
            RayleighDamping::new(-1.0, 0.0).is_err() && RayleighDamping::new(0.0, f64::INFINITY).is_err()
        );
        assert!(StructuralDamping::new(-0.1, 1.0).is_err() && StructuralDamping::new(0.1, 0.0).is_err());
    }

    #[test]
    fn structural_damping_takes_half_the_loss_factor_at_its_reference() {
        let damping = StructuralDamping::new(0.02, 440.0).unwrap();
        assert!((damping.ratio(440.0) - 0.01).abs() < 1e-17);
        let [at_resonance] = damping.modal(&[440.0])[..] else { panic!() };
        assert!((at_resonance / (2.0 * 0.01 * TAU * 440.0) - 1.0).abs() < 1e-15);
    }

    fn matrix(entries: &[(usize, usize, f64)]) -> Sparse {
        let triplets: Vec<_> =
            entries.iter().map(|(i, j, value)| faer::sparse::Triplet::new(*i, *j, *value)).collect();
        Sparse::try_new_from_triplets(2, 2, &triplets).unwrap()
    }

    /// α and β of a sum come back, none of none; a dashpot between the two, a negative share and a number that is none are refused.
    #[test]
    fn proportional_damping_is_found_in_its_matrix() {
        let mass = matrix(&[(0, 0, 2.0), (1, 1, 1.0)]);
        let stiffness = matrix(&[(0, 0, 3e6), (0, 1, -1e6), (1, 0, -1e6), (1, 1, 1e6)]);
        let fitted = |damping: &Sparse| RayleighDamping::fitted(damping, &mass, &stiffness);
        let own = RayleighDamping::new(7.0, 2e-6).unwrap();
        let found = fitted(&own.matrix(&stiffness, &mass).unwrap()).unwrap();
        assert!((found.alpha() / 7.0 - 1.0).abs() < 1e-9 && (found.beta() / 2e-6 - 1.0).abs() < 1e-9);
        let structural = StructuralDamping::new(0.02, 440.0).unwrap();
        let found = fitted(&structural.matrix(&stiffness)).unwrap();
        assert!(found.alpha() == 0.0 && (found.beta() / structural.beta() - 1.0).abs() < 1e-9);
        assert_eq!(fitted(&matrix(&[])), RayleighDamping::new(0.0, 0.0));
        for dashpot in [5.0, f64::NAN] {
            let refused = fitted(&matrix(&[(0, 0, dashpot)]));
            assert!(matches!(refused, Err(StructureError::NotProportional { .. })), "{refused:?}");
        }
        let negative = fitted(&matrix(&[(0, 0, -2.0), (1, 1, -1.0)]));
        assert!(matches!(negative, Err(StructureError::NegativeDamping { .. })), "{negative:?}");
    }
}
