//! Generated rough surfaces: self-affine, periodic, the same for a seed.

use super::error::IndenterError;
use super::height_map::HeightMap;
use crate::kernel::spectra::symbol;
use crate::surface::convolution::PaddedTransform;
use num_complex::Complex64;
use rand_pcg::Pcg64;
use rand_pcg::rand_core::Rng;
use std::f64::consts::PI;

/// Fewest cells a side: below, there is no band of waves to speak of.
const LEAST: usize = 8;
/// The stream of the generator; the seed is its state.
const STREAM: u128 = 0x0a02_bdbf_7bb3_c0a7_ac28_fa16_a64a_bf96;

/// The measure to which a rough surface is scaled.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Roughness {
    /// Root mean square of the heights about their mean.
    Height(f64),
    /// Root mean square of the slope |∇h|, from the spectrum.
    Slope(f64),
}

/// A self-affine surface; lengths in the problem's unit.
///
/// The power spectral density of the heights is constant for waves longer than the roll-off and falls as q^(−2−2H)
/// from there to the shortest wave; beyond there is nothing. White noise (PCG XSL RR 128/64 from the seed, uniform)
/// is multiplied by the square root of the density in Fourier space, so that the heights are nearly Gaussian, and
/// scaled to the asked roughness exactly.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RoughSurface {
    /// L, side of the square that repeats itself.
    pub period: f64,
    /// Cells along a side.
    pub cells: usize,
    /// H, Hurst exponent, in (0, 1].
    pub hurst: f64,
    /// Longest wave of the self-affine part, at most the period.
    pub roll_off: f64,
    /// Shortest wave, at least two cells.
    pub cut_off: f64,
    /// How high or steep the surface is.
    pub roughness: Roughness,
    /// The seed of the noise.
    pub seed: u64,
}

impl RoughSurface {
    /// The surface.
    ///
    /// # Errors
    /// [`IndenterError::NotPositive`], [`IndenterError::Hurst`], [`IndenterError::TooFewHeights`], and
    /// [`IndenterError::WaveLengths`] unless period ≥ roll-off > cut-off ≥ two cells.
    pub fn generate(&self) -> Result<HeightMap, IndenterError> {
        self.check()?;
        let side = self.cells;
        let noise = self.noise();
        let transform = PaddedTransform::periodic(side, side);
        let mut work = transform.workspace();
        let mut filtered = |factor: &dyn Fn(f64) -> f64| {
            let waves_a_period = |radians_a_cell: f64| radians_a_cell * side as f64 / (2.0 * PI);
            let factors = symbol(&transform, |_| Complex64::ONE, |wave| factor(waves_a_period(wave)));
            let mut field = vec![0.0; side * side];
            transform.multiply(&noise, &factors, 1.0 / transform.places(), &mut field, &mut work);
            field
        };
        let mut heights = filtered(&|wave| self.amplitude(wave));
        let scale = match self.roughness {
            Roughness::Height(height) => height / root_mean_square(&heights),
            Roughness::Slope(slope) => {
                let radians = 2.0 * PI / self.period;
                slope / root_mean_square(&filtered(&|wave| radians * wave * self.amplitude(wave)))
            }
        };
        heights.iter_mut().for_each(|height| *height *= scale);
        HeightMap::new(heights, side, side, self.period / side as f64, true)
    }

    fn check(&self) -> Result<(), IndenterError> {
        let roughness = match self.roughness {
            Roughness::Height(height) => ("root mean square of the heights", height),
            Roughness::Slope(slope) => ("root mean square of the slope", slope),
        };
        let lengths =
            [("period", self.period), ("roll-off", self.roll_off), ("cut-off", self.cut_off), roughness];
        for (what, value) in lengths {
            if !(value > 0.0 && value.is_finite()) {
                return Err(IndenterError::NotPositive { what, value });
            }
        }
        if !(self.hurst > 0.0 && self.hurst <= 1.0) {
            return Err(IndenterError::Hurst { value: self.hurst });
        }
        if self.cells < LEAST {
            return Err(IndenterError::TooFewHeights { rows: self.cells, columns: self.cells, least: LEAST });
        }
        let two_cells = 2.0 * self.period / self.cells as f64;
        // Two cells computed from a period may be a rounding longer than a cut-off that was computed so.
        let rounding = 1.0 + 1e-12;
        for (longer, from, shorter, to, right) in [
            ("period", self.period, "roll-off", self.roll_off, self.period * rounding >= self.roll_off),
            ("roll-off", self.roll_off, "cut-off", self.cut_off, self.roll_off > self.cut_off),
            ("cut-off", self.cut_off, "two cells", two_cells, self.cut_off * rounding >= two_cells),
        ] {
            if !right {
                return Err(IndenterError::WaveLengths { longer, from, shorter, to });
            }
        }
        Ok(())
    }

    /// White noise of mean zero.
    fn noise(&self) -> Vec<f64> {
        let mut generator = Pcg64::new(u128::from(self.seed), STREAM);
        // 53 bits fill a double exactly.
        let uniform = |bits: u64| (bits >> 11) as f64 / (1_u64 << 53) as f64 - 0.5;
        (0..self.cells * self.cells).map(|_| uniform(generator.next_u64())).collect()
    }

    /// √C(q) at the wave number q in waves a period, up to a factor.
    fn amplitude(&self, wave: f64) -> f64 {
        let (longest, shortest) = (self.period / self.roll_off, self.period / self.cut_off);
        let rounding = 1.0 + 1e-12;
        if wave == 0.0 || wave > shortest * rounding {
            return 0.0;
        }
        libm::pow((wave / longest).max(1.0), -1.0 - self.hurst)
    }
}

fn root_mean_square(values: &[f64]) -> f64 {
    (values.iter().map(|value| value * value).sum::<f64>() / values.len() as f64).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    const SURFACE: RoughSurface = RoughSurface {
        period: 2.0,
        cells: 64,
        hurst: 0.8,
        roll_off: 1.0,
        cut_off: 0.125,
        roughness: Roughness::Height(0.01),
        seed: 1,
    };

    #[test]
    fn a_seed_gives_the_same_bytes_and_another_seed_others() {
        let bits = |surface: RoughSurface| surface.generate().unwrap().heights()[7].to_bits();
        assert_eq!(bits(SURFACE), bits(SURFACE));
        assert_ne!(bits(SURFACE), bits(RoughSurface { seed: 2, ..SURFACE }));
    }

    #[test]
    fn contradictory_surfaces_are_refused() {
        let error = |surface: RoughSurface| surface.generate().unwrap_err();
        assert_eq!(error(RoughSurface { hurst: 1.2, ..SURFACE }), IndenterError::Hurst { value: 1.2 });
        for bad in [
            RoughSurface { roll_off: 2.5, ..SURFACE },
            RoughSurface { cut_off: 1.5, ..SURFACE },
            RoughSurface { cut_off: 0.05, ..SURFACE },
        ] {
            assert!(matches!(error(bad), IndenterError::WaveLengths { .. }));
        }
        let flat = RoughSurface { roughness: Roughness::Slope(f64::NAN), ..SURFACE };
        assert!(matches!(error(flat), IndenterError::NotPositive { .. }));
        assert!(matches!(error(RoughSurface { cells: 4, ..SURFACE }), IndenterError::TooFewHeights { .. }));
    }
}
