//! How much of a complex mode a motion has.

use crate::NonsmoothError;
use crate::march::NonsmoothMarch;
use faer::c64;
use judder_assembly::assembly::triplets;
use judder_assembly::linearised::Linearised;
use judder_structure::assembly::Sparse;
use serde::{Deserialize, Serialize};

/// The amplitude of a mode in a deviation from steady sliding: a = yᴴ ((λ M + C) q + M q̇)/(yᴴ (2 λ M + C) x), with all damping, that of the
/// contacts too.
///
/// Of a motion a e^{λt} x it is a e^{λt}, of its real part half of that, and zero of every other mode; what belongs to closed rigid points drops out with y.
#[derive(Debug, Clone)]
pub struct ModeShare {
    /// Of the displacements, real and imaginary part, on the coordinates of a march.
    on_displacement: [Vec<f64>; 2],
    on_velocity: [Vec<f64>; 2],
    /// What steady sliding has of it.
    steady: c64,
}

impl ModeShare {
    /// That of a mode with the eigenvalue λ and these vectors on all freedoms about a steady state, in a march.
    #[must_use]
    pub fn new(
        march: &NonsmoothMarch<'_>,
        about: &Linearised,
        value: c64,
        [right, left]: [&[c64]; 2],
        steady: &[f64],
    ) -> Self {
        let [mass, damping, _] = &about.structures;
        let by_mass = transposed(mass, left);
        let mut by_damping = transposed(damping, left);
        let of_contacts = about.contacts.iter().filter(|own| !own.term.is_stiffness());
        let others = about.gyroscopic.iter().map(AsRef::as_ref).chain(of_contacts.map(|own| &own.matrix));
        for matrix in others {
            by_damping.iter_mut().zip(transposed(matrix, left)).for_each(|(sum, own)| *sum += own);
        }
        let pairs = || by_mass.iter().zip(&by_damping);
        let scale: c64 = pairs().zip(right).map(|((m, c), x)| (2.0 * value * m + c) * x).sum();
        let displacement: Vec<c64> = pairs().map(|(m, c)| (value * m + c) / scale).collect();
        let velocity: Vec<c64> = by_mass.iter().map(|m| m / scale).collect();
        let steady = displacement.iter().zip(steady).map(|(own, q)| own * *q).sum();
        let parts = |values: &[c64]| {
            [|value: &c64| value.re, |value: &c64| value.im]
                .map(|part| march.functional(&values.iter().map(part).collect::<Vec<_>>()))
        };
        Self { on_displacement: parts(&displacement), on_velocity: parts(&velocity), steady }
    }

    /// The amplitude at the beginning of the last step of the march.
    #[must_use]
    pub fn of(&self, march: &NonsmoothMarch<'_>) -> c64 {
        let part = |k: usize| march.middle(&self.on_displacement[k], &self.on_velocity[k]);
        c64::new(part(0), part(1)) - self.steady
    }
}

/// yᴴ A.
fn transposed(matrix: &Sparse, left: &[c64]) -> Vec<c64> {
    let mut sums = vec![c64::ZERO; matrix.ncols()];
    triplets(matrix).for_each(|entry| sums[entry.col] += left[entry.row].conj() * entry.val);
    sums
}

/// How much of each of some modes a motion has on average, about its mean, and how fast that turns.
#[derive(Debug, Clone)]
pub struct ModalContent {
    shares: Vec<ModeShare>,
    so_far: ModalSums,
}

/// What the samples of a [`ModalContent`] add up to.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ModalSums {
    of_modes: Vec<ModeSums>,
    samples: u64,
    /// When the last sample was taken, and how long after the one before, in s.
    last: f64,
    apart: f64,
}

#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
struct ModeSums {
    /// About the first amplitude, so that a small swing about a large mean keeps its digits.
    #[serde(with = "parts")]
    origin: c64,
    #[serde(with = "parts")]
    sum: c64,
    squared: f64,
    #[serde(with = "parts")]
    last: c64,
    /// Σ |aₖ − aₖ₋₁|².
    changed: f64,
}

impl ModalContent {
    /// Of these modes, before the first step.
    #[must_use]
    pub fn new(shares: Vec<ModeShare>) -> Self {
        let of_modes = vec![ModeSums::default(); shares.len()];
        Self { shares, so_far: ModalSums { of_modes, samples: 0, last: 0.0, apart: 0.0 } }
    }

    /// What the samples so far add up to.
    #[must_use]
    pub fn so_far(&self) -> &ModalSums {
        &self.so_far
    }

    /// Goes on with the sums of an earlier run.
    ///
    /// # Errors
    /// [`NonsmoothError::ForeignCheckpoint`] where they are those of other modes.
    pub fn resume(&mut self, kept: &ModalSums) -> Result<(), NonsmoothError> {
        if kept.of_modes.len() != self.shares.len() {
            return Err(NonsmoothError::ForeignCheckpoint);
        }
        self.so_far.clone_from(kept);
        Ok(())
    }

    /// Takes the step that a march is at; evenly apart, several in every half period of each mode.
    pub fn take(&mut self, march: &NonsmoothMarch<'_>) {
        let (time, so_far) = (march.time(), &mut self.so_far);
        for (share, sums) in self.shares.iter().zip(&mut so_far.of_modes) {
            let amplitude = share.of(march);
            if so_far.samples == 0 {
                (sums.origin, sums.last) = (amplitude, amplitude);
            }
            let deviation = amplitude - sums.origin;
            sums.sum += deviation;
            sums.squared += deviation.norm_sqr();
            sums.changed += (amplitude - sums.last).norm_sqr();
            sums.last = amplitude;
        }
        (so_far.apart, so_far.last) = (time - so_far.last, time);
        so_far.samples += 1;
    }

    /// The root mean square of |a| of a mode about its mean, and the angular frequency with which it turned, in rad/s: that of an even turn
    /// which changes as much from sample to sample. Of no samples nothing.
    #[must_use]
    pub fn of(&self, mode: usize) -> Option<[f64; 2]> {
        let ModalSums { of_modes, samples, apart, .. } = &self.so_far;
        let sums = of_modes.get(mode).filter(|_| *samples > 1)?;
        let count = *samples as f64;
        let variance = (sums.squared / count - (sums.sum / count).norm_sqr()).max(0.0);
        if variance == 0.0 {
            return Some([0.0, 0.0]);
        }
        let half_chord = 0.5 * (sums.changed / (count - 1.0) / variance).sqrt();
        Some([variance.sqrt(), 2.0 * libm::asin(half_chord.min(1.0)) / apart])
    }
}

/// A complex number as its real and its imaginary part.
mod parts {
    use faer::c64;
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    pub(super) fn serialize<S: Serializer>(value: &c64, serializer: S) -> Result<S::Ok, S::Error> {
        [value.re, value.im].serialize(serializer)
    }

    pub(super) fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<c64, D::Error> {
        <[f64; 2]>::deserialize(deserializer).map(|[re, im]| c64::new(re, im))
    }
}
