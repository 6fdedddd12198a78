//! What a transient contact leaves behind.

use crate::surface::grid::SurfaceGrid;
use num_complex::Complex64;

/// The contact at one moment; lengths in R, forces in E0* R², energies in E0* R³.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TransientSample {
    /// t.
    pub time: f64,
    /// x of the indenter's lowest point.
    pub position: f64,
    /// δ, depth of the lowest point; what was imposed, or found under an imposed load.
    pub indentation: f64,
    /// F, normal force.
    pub force: f64,
    /// ∫ p ∂h/∂x, the force that resists a motion to +x.
    pub friction_force: f64,
    /// A.
    pub area: f64,
    /// ∫ F dδ since the start.
    pub normal_work: f64,
    /// ∫ friction force dx since the start.
    pub sliding_work: f64,
    /// Energies, where they were asked for.
    pub energy: Option<TransientEnergy>,
    /// Estimated error of the step that led here: displacement over the largest depth.
    pub step_error: f64,
    /// Largest error of the unilateral conditions: displacement over the largest depth.
    pub residual: f64,
}

impl TransientSample {
    /// Work done by the indenter since the start.
    #[must_use]
    pub fn work(&self) -> f64 {
        self.normal_work + self.sliding_work
    }
}

/// Where the work has gone, computed from pressures in the substrate alone.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TransientEnergy {
    /// ½ ∫ (E0/E∞ p W\[p\] + Σ C_k p_k W\[p_k\]), what the substrate could give back.
    pub stored: f64,
    /// Σ C_k/τ_k ∫∫ (p − p_k) W[p − p_k] dt since the start, what has become heat.
    pub dissipated: f64,
}

/// The fields at one moment.
#[derive(Debug, Clone, PartialEq)]
pub struct TransientFields {
    /// t.
    pub time: f64,
    /// x of the indenter's lowest point; the grid's x are of the material.
    pub position: f64,
    /// The cells.
    pub grid: SurfaceGrid,
    /// p in E0*, row-major.
    pub pressure: Vec<f64>,
    /// Gap in R, row-major.
    pub gap: Vec<f64>,
}

/// The contact over time.
#[derive(Debug, Clone, PartialEq)]
pub struct TransientHistory {
    /// The ends of all steps, the start first.
    pub samples: Vec<TransientSample>,
    /// The fields at the times asked for.
    pub fields: Vec<TransientFields>,
    /// h, side of a cell, in R.
    pub cell: f64,
    /// Columns and rows of the strip of material that is remembered.
    pub strip: [usize; 2],
    /// Steps tried and rejected.
    pub rejected: usize,
    /// Products with the kernel of the window.
    pub products: usize,
    /// Whether every step's contact was solved and its error within the tolerance.
    pub converged: bool,
    /// Whether the path was followed to its end.
    pub completed: bool,
}

impl TransientHistory {
    /// The last moment.
    #[must_use]
    pub fn last(&self) -> Option<&TransientSample> {
        self.samples.last()
    }

    /// A quantity's mean over an interval of time, its samples joined by straight lines.
    #[must_use]
    pub fn mean(&self, from: f64, to: f64, quantity: impl Fn(&TransientSample) -> f64) -> f64 {
        let mut sum = 0.0;
        for pair in self.samples.windows(2) {
            let (left, right) = (pair[0].time.max(from), pair[1].time.min(to));
            if right > left {
                let values = [quantity(&pair[0]), quantity(&pair[1])];
                let slope = (values[1] - values[0]) / (pair[1].time - pair[0].time);
                sum += (right - left) * (values[0] + slope * (0.5 * (left + right) - pair[0].time));
            }
        }
        sum / (to - from)
    }

    /// (2/T) ∫ quantity e^{−iωt} dt over an interval T of whole periods: a sin ωt + b cos ωt gives b − i a.
    ///
    /// The ratio of two of them, of force and indentation say, is a complex stiffness.
    #[must_use]
    pub fn harmonic(
        &self,
        from: f64,
        to: f64,
        angular_frequency: f64,
        quantity: impl Fn(&TransientSample) -> f64,
    ) -> Complex64 {
        let wave = |sample: &TransientSample| libm::sincos(angular_frequency * sample.time);
        let even = self.mean(from, to, |sample| quantity(sample) * wave(sample).1);
        let odd = self.mean(from, to, |sample| quantity(sample) * wave(sample).0);
        2.0 * Complex64::new(even, -odd)
    }

    /// Work done in each whole period since the start: once the cycles repeat, what one of them dissipates.
    #[must_use]
    pub fn work_by_period(&self, period: f64) -> Vec<f64> {
        let Some(end) = self.last().map(|sample| sample.time) else {
            return Vec::new();
        };
        let count = (end / period * (1.0 + 1e-9)).floor().max(0.0) as usize;
        let at: Vec<f64> = (0..=count).map(|cycle| self.work_at(cycle as f64 * period)).collect();
        at.windows(2).map(|pair| pair[1] - pair[0]).collect()
    }

    fn work_at(&self, time: f64) -> f64 {
        let next = self.samples.partition_point(|sample| sample.time < time);
        match (next.checked_sub(1).and_then(|before| self.samples.get(before)), self.samples.get(next)) {
            (Some(before), Some(after)) => {
                let part = (time - before.time) / (after.time - before.time);
                before.work() + part * (after.work() - before.work())
            }
            (None, Some(sample)) | (Some(sample), None) => sample.work(),
            (None, None) => 0.0,
        }
    }
}
