//! The kernel of a surface and its approximate inverse, as factors of Fourier modes.

use super::substrate::SlidingSubstrate;
use super::wake::{WakeKernel, padded};
use crate::surface::convolution::{PaddedTransform, fast_even_length, fast_length};
use num_complex::Complex64;
use std::f64::consts::PI;

/// What an operator needs to know of its surface, with the side of a cell as unit of length.
///
/// It depends on the cells' numbers and on the ratios ℓ/h alone, so operators can share it.
#[derive(Clone)]
pub struct KernelSpectra {
    pub(crate) product: Filter,
    pub(crate) inverse: Filter,
    /// Where displacements are taken upstream of the centres, in cells.
    pub(crate) shift: f64,
    pub(crate) symmetric: bool,
    /// The displacement that a unit pressure on a cell makes at the cell's own collocation point.
    pub(crate) at_itself: f64,
}

/// A transform with the factors that it multiplies by.
#[derive(Clone)]
pub(crate) struct Filter {
    pub(crate) transform: PaddedTransform,
    pub(crate) factors: Vec<Complex64>,
}

impl KernelSpectra {
    /// Cells that slide over an unbounded surface; lengths of the substrate in cells.
    #[must_use]
    pub fn unbounded(columns: usize, rows: usize, substrate: &SlidingSubstrate) -> Self {
        let shift = substrate.collocation_shift(1.0);
        let kernel = WakeKernel::new(columns, rows, shift, substrate);
        Self::from_kernel(&kernel, shift, substrate)
    }

    /// The spectra of a kernel without images.
    pub(crate) fn from_kernel(kernel: &WakeKernel, shift: f64, substrate: &SlidingSubstrate) -> Self {
        let (columns, rows) = (kernel.columns, kernel.rows);
        let transform = PaddedTransform::new(columns, rows, padded(columns), padded(rows));
        let factors = transform.even_spectrum(&kernel.values);
        Self {
            product: Filter { transform, factors },
            inverse: inverse_symbol(PaddedTransform::new(columns, rows, columns, rows), shift, substrate),
            shift,
            symmetric: substrate.terms.is_empty(),
            at_itself: kernel.at_itself(),
        }
    }

    /// Bytes that the spectra of a grid take, without the memory of each operator.
    #[must_use]
    pub fn memory_bytes(columns: usize, rows: usize) -> u64 {
        let product = spectrum_bytes(fast_even_length(padded(columns)), fast_length(padded(rows)));
        product.saturating_add(spectrum_bytes(fast_even_length(columns), fast_length(rows)))
    }
}

fn spectrum_bytes(wide: usize, high: usize) -> u64 {
    let modes = (wide as u64 / 2 + 1).saturating_mul(high as u64);
    modes.saturating_mul(size_of::<Complex64>() as u64)
}

/// |q|/(2 J(q_x)) e^{i q_x s}, over f(q h) of a layer, the inverse symbol on the grid taken as periodic; its mean takes half the lowest wave.
pub(crate) fn inverse_symbol(transform: PaddedTransform, shift: f64, substrate: &SlidingSubstrate) -> Filter {
    let lowest = PI / transform.wide().max(transform.high()) as f64;
    let factors = symbol(
        &transform,
        |along| judder_numerics::complex::from_polar(0.5, along * shift) / substrate.compliance(along),
        |wave| {
            let wave = wave.max(lowest);
            wave / substrate.transfer(wave)
        },
    );
    Filter { transform, factors }
}

/// A function of q_x times one of |q|, in 1/cells, at the modes of a transform, column by column.
pub(crate) fn symbol(
    transform: &PaddedTransform,
    of_along: impl Fn(f64) -> Complex64,
    of_wave: impl Fn(f64) -> f64,
) -> Vec<Complex64> {
    let (wide, high) = (transform.wide(), transform.high());
    let wave = |index: usize, length: usize| {
        let signed = if 2 * index > length { index as f64 - length as f64 } else { index as f64 };
        2.0 * PI * signed / length as f64
    };
    let across_squared: Vec<f64> = (0..high).map(|row| wave(row, high).powi(2)).collect();
    let mut factors = Vec::with_capacity(transform.spectrum_columns() * high);
    for column in 0..transform.spectrum_columns() {
        let along = wave(column, wide);
        let factor = of_along(along);
        factors
            .extend(across_squared.iter().map(|squared| factor * of_wave((along * along + squared).sqrt())));
    }
    factors
}
