//! The derivative of the balance of harmonics.
//!
//! ∂R = (1 − T(∂π/∂λ)) ∂Λ − T(∂π/∂y) ∂Y, where T multiplies a signal with a factor and keeps H harmonics of it: a block for each point, beside
//! receptances that join the points harmonic by harmonic.

use super::{HarmonicBalance, ProjectedForces};
use crate::point_law::ProjectedForce;
use crate::receptance::HarmonicSlopes;
use crate::series::sized;
use faer::{Mat, MatMut, c64};

/// T of the derivatives of a point: `dimension` × `dimension` blocks of coefficients.
struct PointBlocks {
    size: usize,
    dimension: usize,
    /// 1 − T(∂π/∂λ) and −T(∂π/∂y), column after column of all components of the point.
    by_force: Vec<f64>,
    by_motion: Vec<f64>,
    /// What it works in: values and coefficients of factors, a block of them.
    values: Mat<f64>,
    factors: Mat<f64>,
    block: Vec<f64>,
}

impl PointBlocks {
    fn new(dimension: usize, size: usize) -> Self {
        let rows = dimension * size;
        let [by_force, by_motion] = [(); 2].map(|()| vec![0.0; rows * rows]);
        let block = vec![0.0; size * size];
        Self { size, dimension, by_force, by_motion, values: Mat::new(), factors: Mat::new(), block }
    }

    /// out += f times a column of a block.
    fn add(&self, block: &[f64], [component, coefficient]: [usize; 2], factor: f64, out: &mut [f64]) {
        if factor == 0.0 {
            return;
        }
        let rows = self.dimension * self.size;
        let column = component * self.size + coefficient;
        let own = &block[column * rows..(column + 1) * rows];
        out.iter_mut().zip(own).for_each(|(out, own)| *out += factor * own);
    }

    /// out += −T(∂π/∂y) of the cosine and sine of a harmonic of a component.
    fn add_motion(&self, component: usize, harmonic: usize, [cosine, sine]: [f64; 2], out: &mut [f64]) {
        self.add(&self.by_motion, [component, 2 * harmonic - 1], cosine, out);
        self.add(&self.by_motion, [component, 2 * harmonic], sine, out);
    }
}

impl HarmonicBalance<'_> {
    /// In place of what the matrix has; by ω and σ as far as it has columns for them.
    pub(super) fn jacobian(
        &self,
        slopes: &[HarmonicSlopes],
        projected: &ProjectedForces,
        mut out: MatMut<'_, f64>,
    ) {
        let (size, unknowns) = (self.series.coefficients(), self.unknowns());
        let rows = self.contact.dimension * size;
        out.fill(0.0);
        let mut blocks = PointBlocks::new(self.contact.dimension, size);
        for point in 0..self.contact.points.len() {
            let own = projected.of_point(point);
            if own.iter().all(ProjectedForce::is_constant) {
                self.add_open(point, out.as_mut());
                continue;
            }
            self.set(&mut blocks, own);
            for column in 0..out.ncols() {
                let column_of = out.as_mut().subrows_mut(point * rows, rows).col_mut(column);
                let Some(out) = column_of.try_as_col_major_mut() else { continue };
                let out = out.as_slice_mut();
                match column.checked_sub(unknowns) {
                    None => self.add_unknown(point, [column / size, column % size], &blocks, slopes, out),
                    Some(which) => self.add_turning(point, which, &blocks, slopes, out),
                }
            }
        }
    }

    /// The rows of a point that is open all along: it has no force, whose mean is λ₀ = s₀ − ε c x₀.
    fn add_open(&self, point: usize, mut jacobian: MatMut<'_, f64>) {
        let (size, dimension) = (self.series.coefficients(), self.contact.dimension);
        let first = point * dimension;
        (first * size..(first + dimension) * size).for_each(|row| jacobian[(row, row)] = 1.0);
        for component in 0..self.components() {
            let moved = self.statics.receptance[(first, component)];
            jacobian[(first * size, component * size)] -= self.scales[point].stiffness * moved;
        }
    }

    /// The blocks of a point, from its laws at all instants.
    fn set(&self, blocks: &mut PointBlocks, of_point: &[ProjectedForce]) {
        let (size, dimension) = (self.series.coefficients(), self.contact.dimension);
        let rows = dimension * size;
        let slope = |own: &ProjectedForce, which: usize| {
            let (by_motion, place) = (which / (dimension * dimension), which % (dimension * dimension));
            let table = if by_motion == 0 { &own.by_force } else { &own.by_motion };
            table[place % dimension][place / dimension]
        };
        // most of them are zero throughout
        let mut sizes = ProjectedForce::default();
        of_point.iter().filter(|own| !own.is_constant()).for_each(|own| sizes.add_sizes_of_slopes(own));
        let present: Vec<usize> =
            (0..2 * dimension * dimension).filter(|which| slope(&sizes, *which) != 0.0).collect();
        let PointBlocks { by_force, by_motion, values, factors, block, .. } = blocks;
        sized(values, self.series.samples(), present.len());
        for (column, which) in present.iter().enumerate() {
            let values = values.col_as_slice_mut(column);
            values.iter_mut().zip(of_point).for_each(|(value, own)| *value = slope(own, *which));
        }
        self.series.of_factors_into(values.as_ref(), factors);
        by_force.fill(0.0);
        by_motion.fill(0.0);
        for (k, which) in present.into_iter().enumerate() {
            let (table, place) = (which / (dimension * dimension), which % (dimension * dimension));
            let (row, column) = (place % dimension, place / dimension);
            self.series.multiplication(factors.col_as_slice(k), block);
            let own = if table == 0 { &mut *by_force } else { &mut *by_motion };
            for (k, from) in block.chunks_exact(size).enumerate() {
                let first = (column * size + k) * rows + row * size;
                own[first..first + size].iter_mut().zip(from).for_each(|(out, from)| *out = -from);
            }
        }
        (0..rows).for_each(|k| by_force[k * rows + k] += 1.0);
    }

    /// By a coefficient of a force.
    fn add_unknown(
        &self,
        point: usize,
        [component, coefficient]: [usize; 2],
        blocks: &PointBlocks,
        slopes: &[HarmonicSlopes],
        out: &mut [f64],
    ) {
        let dimension = self.contact.dimension;
        let is_own = component / dimension == point;
        if is_own {
            blocks.add(&blocks.by_force, [component % dimension, coefficient], 1.0, out);
        }
        // all is measured by the force scale: λ is a share of it, motions follow from so many newtons
        for own in 0..dimension {
            let row = point * dimension + own;
            match coefficient {
                0 => {
                    let moved = self.statics.receptance[(row, component)];
                    if own == 0 {
                        let less = -self.scales[point].stiffness * moved;
                        blocks.add(&blocks.by_force, [own, 0], less, out);
                    }
                    blocks.add(&blocks.by_motion, [own, 0], moved, out);
                }
                _ => {
                    let harmonic = coefficient.div_ceil(2);
                    let g = slopes[harmonic - 1].receptance[(row, component)];
                    let parts = if coefficient % 2 == 1 { [g.re, -g.im] } else { [g.im, g.re] };
                    blocks.add_motion(own, harmonic, parts, out);
                }
            }
        }
    }

    /// By ω or σ, of forces that are measured by their scale.
    fn add_turning(
        &self,
        point: usize,
        which: usize,
        blocks: &PointBlocks,
        slopes: &[HarmonicSlopes],
        out: &mut [f64],
    ) {
        let dimension = self.contact.dimension;
        for own in 0..dimension {
            for (k, slopes) in slopes.iter().enumerate() {
                let slope = turned(slopes, which, k + 1, point * dimension + own) / self.force;
                blocks.add_motion(own, k + 1, [slope.re, -slope.im], out);
            }
        }
    }

    /// What a sum of the first harmonics of y, cosine and sine of each component times a factor, has for derivatives: of every column that is not zero.
    pub(crate) fn slopes_of_first(
        &self,
        slopes: &[HarmonicSlopes],
        factors: &[f64],
        tell: &mut dyn FnMut(usize, f64),
    ) {
        let (size, unknowns) = (self.series.coefficients(), self.unknowns());
        let first = &slopes[0];
        // cosine and sine are Re y and −Im y
        let sum = |of: &dyn Fn(usize) -> c64| -> f64 {
            let pairs = factors.chunks_exact(2).enumerate();
            pairs.map(|(component, pair)| (pair[0] * of(component).re) - pair[1] * of(component).im).sum()
        };
        for component in 0..self.components() {
            let receptance = |row: usize| self.force * first.receptance[(row, component)];
            tell(component * size + 1, sum(&receptance));
            // of a sine the amplitude is −i
            tell(component * size + 2, sum(&|row| c64::new(0.0, -1.0) * receptance(row)));
        }
        (0..2).for_each(|which| tell(unknowns + which, sum(&|row| turned(first, which, 1, row))));
    }
}

/// ∂y/∂ω, s = i h ω, or ∂y/∂σ.
fn turned(slopes: &HarmonicSlopes, which: usize, harmonic: usize, component: usize) -> c64 {
    match which {
        0 => c64::new(0.0, harmonic as f64) * slopes.by_s[component],
        _ => slopes.by_growth[component],
    }
}
