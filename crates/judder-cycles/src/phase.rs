//! The phase of a motion that nothing drives: where its period begins is free.

use crate::balance::HarmonicBalance;
use faer::Mat;

/// Σ ε² (r_c y_s − r_s y_c) = 0 over the first harmonics of all components: no part of the motion runs ahead of or behind a reference.
#[derive(Debug, Clone)]
pub(crate) struct Phase {
    /// r: cosine and sine of each component, of length one once multiplied with ε.
    reference: Vec<f64>,
    /// ε of each component.
    scales: Vec<f64>,
    /// What amounts are measured by, in N.
    force: f64,
    /// The amplitude of the reference, in N.
    amplitude: f64,
}

impl Phase {
    /// Beside the first harmonics of a motion: cosine and sine of each component.
    pub(crate) fn new(balance: &HarmonicBalance<'_>, reference: Vec<f64>) -> Self {
        let dimension = balance.contact().dimension;
        let of_component = |component: usize| {
            let own = balance.scales()[component / dimension];
            if component.is_multiple_of(dimension) { own.stiffness } else { own.viscosity }
        };
        let scales = (0..balance.components()).map(of_component).collect();
        let mut phase = Self { reference: Vec::new(), scales, force: balance.force_scale(), amplitude: 0.0 };
        phase.set(reference);
        phase
    }

    fn set(&mut self, mut reference: Vec<f64>) {
        let length = self.length(&reference);
        self.amplitude = length;
        if length > 0.0 {
            reference.iter_mut().for_each(|own| *own /= length);
        }
        self.reference = reference;
    }

    fn length(&self, first: &[f64]) -> f64 {
        let scaled = |k: usize| first[k] * self.scales[k / 2];
        (0..first.len()).map(|k| scaled(k) * scaled(k)).sum::<f64>().sqrt()
    }

    /// First harmonics among the coefficients of y.
    fn first(&self, motions: &Mat<f64>) -> Vec<f64> {
        (0..2 * self.scales.len()).map(|k| motions[(1 + k % 2, k / 2)]).collect()
    }

    /// The root of Σ |ε y₁|², in N.
    pub(crate) fn amplitude(&self, motions: &Mat<f64>) -> f64 {
        self.length(&self.first(motions))
    }

    /// Whether a motion is one of the kind of the reference: not steady sliding, which solves the same equations, nor one beyond it, half a period off.
    pub(crate) fn moves(&self, motions: &Mat<f64>) -> bool {
        /// Of the amplitude of the reference: what shrinks to steady sliding comes by larger ones.
        const NOTHING: f64 = 0.1;
        let first = self.first(motions);
        let along = |k: usize| self.reference[k] * first[k] * self.scales[k / 2] * self.scales[k / 2];
        (0..first.len()).map(along).sum::<f64>() > NOTHING * self.amplitude
    }

    /// The reference becomes a motion.
    pub(crate) fn follow(&mut self, motions: &Mat<f64>) {
        self.set(self.first(motions));
    }

    /// What cosine and sine of each component are multiplied by in it.
    pub(crate) fn factors(&self) -> Vec<f64> {
        let factor = |k: usize| {
            let scale = self.scales[k / 2] * self.scales[k / 2] / self.force;
            if k.is_multiple_of(2) { -scale * self.reference[k + 1] } else { scale * self.reference[k - 1] }
        };
        (0..self.reference.len()).map(factor).collect()
    }

    /// What is to be zero.
    pub(crate) fn of(&self, motions: &Mat<f64>) -> f64 {
        self.factors().iter().zip(self.first(motions)).map(|(factor, own)| factor * own).sum()
    }
}
