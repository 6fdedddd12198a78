//! The spectrum of a short piece of a signal.

use judder_fourier::{RealToComplex, real_forward};
use num_complex::Complex64;
use std::sync::Arc;

/// The transform of pieces of one length, with its working memory.
pub(crate) struct Transform {
    plan: Arc<dyn RealToComplex<f64>>,
    input: Vec<f64>,
    output: Vec<Complex64>,
    scratch: Vec<Complex64>,
}

impl Transform {
    /// For pieces of up to `length` samples; shorter ones are filled up with zeros.
    pub(crate) fn new(length: usize) -> Self {
        let plan = real_forward(length);
        let (input, output, scratch) =
            (plan.make_input_vec(), plan.make_output_vec(), plan.make_scratch_vec());
        Self { plan, input, output, scratch }
    }

    /// Σ_n v_n exp(−2πi k n/N) for k = 0 to N/2, of values fewer than N.
    pub(crate) fn of(&mut self, values: impl Iterator<Item = f64>) -> &[Complex64] {
        self.input.fill(0.0);
        for (entry, value) in self.input.iter_mut().zip(values) {
            *entry = value;
        }
        // The lengths are those of the plan, which is all that the transform can object to.
        let _ = self.plan.process_with_scratch(&mut self.input, &mut self.output, &mut self.scratch);
        &self.output
    }
}
