//! Plans of Fourier transforms of `f64`.
//!
//! The planner of rustfft is generic: a crate that calls it compiles every algorithm of every processor anew, which takes longer than
//! all else in it. Here they are compiled once; what comes out are objects. Of vector instructions AVX and NEON alone are compiled in, and
//! chosen at run time.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

pub use realfft::{ComplexToReal, RealToComplex};
pub use rustfft::Fft;
use std::sync::Arc;

/// Real values to the first half of their spectrum.
#[must_use]
pub fn real_forward(length: usize) -> Arc<dyn RealToComplex<f64>> {
    realfft::RealFftPlanner::new().plan_fft_forward(length)
}

/// The first half of a spectrum to real values, `length` times as large.
#[must_use]
pub fn real_inverse(length: usize) -> Arc<dyn ComplexToReal<f64>> {
    realfft::RealFftPlanner::new().plan_fft_inverse(length)
}

/// Complex values to their spectrum.
#[must_use]
pub fn complex_forward(length: usize) -> Arc<dyn Fft<f64>> {
    rustfft::FftPlanner::new().plan_fft_forward(length)
}

/// A spectrum to complex values, `length` times as large.
#[must_use]
pub fn complex_inverse(length: usize) -> Arc<dyn Fft<f64>> {
    rustfft::FftPlanner::new().plan_fft_inverse(length)
}
