//! Products with a translation-invariant kernel by real Fourier transforms.

use judder_fourier::{ComplexToReal, Fft, RealToComplex};
use judder_fourier::{complex_forward, complex_inverse, real_forward, real_inverse};
use num_complex::Complex64;
use std::sync::Arc;

/// Columns transformed together: their values lie side by side in memory.
const BLOCK: usize = 16;

/// Added to strides in memory that would else be powers of two, whose lines share few places of the cache.
const STAGGER: usize = 4;

/// The values of one row in the columns that are transformed together.
type TransformedLine = [Complex64; BLOCK];

/// The two-dimensional real transform of a small array that stands in the corner of a larger, empty one.
///
/// Rows that are empty, or whose result nobody asks for, are never transformed.
#[derive(Clone)]
pub struct PaddedTransform {
    columns: usize,
    rows: usize,
    wide: usize,
    high: usize,
    forward_row: Arc<dyn RealToComplex<f64>>,
    inverse_row: Arc<dyn ComplexToReal<f64>>,
    forward_column: Arc<dyn Fft<f64>>,
    inverse_column: Arc<dyn Fft<f64>>,
}

/// Memory that a product needs, kept between products.
#[derive(Clone)]
pub struct Workspace {
    row: Vec<f64>,
    row_spectrum: Vec<Complex64>,
    half: Vec<TransformedLine>,
    block: Vec<Complex64>,
    row_scratch: Vec<Complex64>,
    column_scratch: Vec<Complex64>,
}

impl PaddedTransform {
    /// The transform of `rows` × `columns` values in a periodic array of at least `high` × `wide`.
    #[must_use]
    pub fn new(columns: usize, rows: usize, wide: usize, high: usize) -> Self {
        Self::of_size(columns, rows, fast_even_length(wide.max(columns)), fast_length(high.max(rows)))
    }

    /// The transform of `rows` × `columns` values that are the whole period.
    #[must_use]
    pub fn periodic(columns: usize, rows: usize) -> Self {
        Self::of_size(columns, rows, columns.max(1), rows.max(1))
    }

    fn of_size(columns: usize, rows: usize, wide: usize, high: usize) -> Self {
        Self {
            columns: columns.max(1),
            rows,
            wide,
            high,
            forward_row: real_forward(wide),
            inverse_row: real_inverse(wide),
            forward_column: complex_forward(high),
            inverse_column: complex_inverse(high),
        }
    }

    /// Length of a row of the periodic array.
    #[must_use]
    pub fn wide(&self) -> usize {
        self.wide
    }

    /// Number of rows of the periodic array.
    #[must_use]
    pub fn high(&self) -> usize {
        self.high
    }

    /// Number of places of the periodic array.
    #[must_use]
    pub fn places(&self) -> f64 {
        self.wide as f64 * self.high as f64
    }

    /// Number of columns of the spectrum, which is stored column by column.
    #[must_use]
    pub fn spectrum_columns(&self) -> usize {
        self.wide / 2 + 1
    }

    /// Memory for products.
    #[must_use]
    pub fn workspace(&self) -> Workspace {
        let zero = Complex64::default();
        let row_scratch = self.forward_row.get_scratch_len().max(self.inverse_row.get_scratch_len());
        let column_scratch =
            self.forward_column.get_inplace_scratch_len().max(self.inverse_column.get_inplace_scratch_len());
        Workspace {
            row: vec![0.0; self.wide],
            row_spectrum: vec![zero; self.spectrum_columns().next_multiple_of(BLOCK)],
            half: vec![[zero; BLOCK]; self.spectrum_columns().div_ceil(BLOCK) * self.half_stride()],
            block: vec![zero; BLOCK * self.column_stride()],
            row_scratch: vec![zero; row_scratch],
            column_scratch: vec![zero; column_scratch],
        }
    }

    /// The spectrum, column by column, of a kernel that is even in y.
    ///
    /// `kernel` holds `rows` rows of 2·columns − 1 values, the differences 1 − columns … columns − 1 along x and 0 …
    /// rows − 1 along y, so that a product with the spectrum sums over all cells without images.
    #[must_use]
    pub fn even_spectrum(&self, kernel: &[f64]) -> Vec<Complex64> {
        let mut work = self.workspace();
        let ahead = self.columns - 1;
        for (index, values) in kernel.chunks_exact(2 * self.columns - 1).enumerate() {
            work.row.fill(0.0);
            work.row[..self.columns].copy_from_slice(&values[ahead..]);
            work.row[self.wide - ahead..].copy_from_slice(&values[..ahead]);
            self.row_forward(index, &mut work);
        }
        let mut spectrum = vec![Complex64::default(); self.spectrum_columns() * self.high];
        let halves = work.half.chunks_exact(self.half_stride());
        for (columns, half) in spectrum.chunks_mut(BLOCK * self.high).zip(halves) {
            for (lane, column) in columns.chunks_exact_mut(self.high).enumerate() {
                for (row, line) in half[..self.rows].iter().enumerate() {
                    column[row] = line[lane];
                    column[(self.high - row) % self.high] = line[lane];
                }
            }
            self.forward_column.process_with_scratch(columns, &mut work.column_scratch);
        }
        spectrum
    }

    /// out = `scale` · `wide` · `high` · the convolution of `values` with the kernel whose spectrum is given.
    pub fn multiply(
        &self,
        values: &[f64],
        factors: &[Complex64],
        scale: f64,
        out: &mut [f64],
        work: &mut Workspace,
    ) {
        for (index, row) in values.chunks_exact(self.columns).enumerate() {
            work.row[..self.columns].copy_from_slice(row);
            work.row[self.columns..].fill(0.0);
            self.row_forward(index, work);
        }
        self.columns_through(factors, work);
        self.rows_inverse(scale, out, work);
    }

    /// Transforms a row; the half-done spectrum is kept in blocks of columns, row by row within a block.
    fn row_forward(&self, index: usize, work: &mut Workspace) {
        let count = self.spectrum_columns();
        // The lengths are those of the plan, which is all that the transform can object to.
        let _ = self.forward_row.process_with_scratch(
            &mut work.row,
            &mut work.row_spectrum[..count],
            &mut work.row_scratch,
        );
        let (lines, _) = work.row_spectrum.as_chunks();
        for (half, line) in work.half.chunks_exact_mut(self.half_stride()).zip(lines) {
            half[index] = *line;
        }
    }

    /// Every column forward, times the kernel, and back.
    fn columns_through(&self, factors: &[Complex64], work: &mut Workspace) {
        let zero = Complex64::default();
        let stride = self.column_stride();
        let halves = work.half.chunks_exact_mut(self.half_stride());
        for (half, factors) in halves.zip(factors.chunks(BLOCK * self.high)) {
            let half = &mut half[..self.rows];
            for (row, line) in half.iter().enumerate() {
                for (lane, value) in line.iter().enumerate() {
                    work.block[lane * stride + row] = *value;
                }
            }
            for (column, factors) in work.block.chunks_exact_mut(stride).zip(factors.chunks_exact(self.high))
            {
                let column = &mut column[..self.high];
                column[self.rows..].fill(zero);
                self.forward_column.process_with_scratch(column, &mut work.column_scratch);
                for (value, factor) in column.iter_mut().zip(factors) {
                    *value *= factor;
                }
                self.inverse_column.process_with_scratch(column, &mut work.column_scratch);
            }
            for (row, line) in half.iter_mut().enumerate() {
                for (lane, value) in line.iter_mut().enumerate() {
                    *value = work.block[lane * stride + row];
                }
            }
        }
    }

    /// From one block of columns to the next, in lines.
    fn half_stride(&self) -> usize {
        self.rows + STAGGER
    }

    /// From one column of a block to the next.
    fn column_stride(&self) -> usize {
        self.high + STAGGER
    }

    fn rows_inverse(&self, scale: f64, out: &mut [f64], work: &mut Workspace) {
        for (index, row) in out.chunks_exact_mut(self.columns).enumerate() {
            let (lines, _) = work.row_spectrum.as_chunks_mut();
            for (line, half) in lines.iter_mut().zip(work.half.chunks_exact(self.half_stride())) {
                *line = half[index];
            }
            // A real row's first coefficient, and its last for an even length, have no imaginary part but rounding.
            work.row_spectrum[0].im = 0.0;
            if self.wide.is_multiple_of(2) {
                work.row_spectrum[self.wide / 2].im = 0.0;
            }
            let _ = self.inverse_row.process_with_scratch(
                &mut work.row_spectrum[..self.spectrum_columns()],
                &mut work.row,
                &mut work.row_scratch,
            );
            for (value, unscaled) in row.iter_mut().zip(&work.row) {
                *value = scale * unscaled;
            }
        }
    }
}

/// The smallest length of the form 2^a 3^b 5^c that is not below `least`.
#[must_use]
pub fn fast_length(least: usize) -> usize {
    (least.max(1)..).find(|length| is_smooth(*length)).unwrap_or(least)
}

/// The smallest even length of the form 2^a 3^b 5^c that is not below `least`.
#[must_use]
pub fn fast_even_length(least: usize) -> usize {
    2 * fast_length(least.div_ceil(2))
}

fn is_smooth(mut number: usize) -> bool {
    for factor in [2, 3, 5] {
        while number.is_multiple_of(factor) {
            number /= factor;
        }
    }
    number == 1
}
