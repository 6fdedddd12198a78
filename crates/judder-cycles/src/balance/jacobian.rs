//! The derivative of the balance of harmonics.
//!
//! ∂R = (1 − T(∂π/∂λ)) ∂Λ − T(∂π/∂y) ∂Y, where T multiplies a signal with a factor and keeps H harmonics of it: a block for each point, beside
//! receptances that join the points harmonic by harmonic.

use super::{HarmonicBalance, Responses};
use crate::point_law::ProjectedForce;
use faer::{Mat, c64};

/// T of the derivatives of a point: `dimension` × `dimension` blocks of coefficients.
struct PointBlocks {
    size: usize,
    dimension: usize,
    /// 1 − T(∂π/∂λ) and −T(∂π/∂y), column after column of all components of the point.
    by_force: Vec<f64>,
    by_motion: Vec<f64>,
}

impl PointBlocks {
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
    pub(super) fn jacobian(&self, responses: &Responses, projected: &[ProjectedForce]) -> Mat<f64> {
        let (size, dimension) = (self.series.coefficients(), self.contact.dimension);
        let (unknowns, points) = (self.unknowns(), self.contact.points.len());
        let mut jacobian = Mat::zeros(unknowns, unknowns + 2);
        for point in 0..self.contact.points.len() {
            let rows = point * dimension * size..(point + 1) * dimension * size;
            if projected.iter().skip(point).step_by(points).all(ProjectedForce::is_constant) {
                self.add_open(point, &mut jacobian);
                continue;
            }
            let blocks = self.blocks(point, projected);
            for column in 0..unknowns + 2 {
                let out = &mut jacobian.col_as_slice_mut(column)[rows.clone()];
                match column.checked_sub(unknowns) {
                    None => self.add_unknown(point, [column / size, column % size], &blocks, responses, out),
                    Some(which) => self.add_turning(point, which, &blocks, responses, out),
                }
            }
        }
        jacobian
    }

    /// The rows of a point that is open all along: it has no force, whose mean is λ₀ = s₀ − ε c x₀.
    fn add_open(&self, point: usize, jacobian: &mut Mat<f64>) {
        let (size, dimension) = (self.series.coefficients(), self.contact.dimension);
        let first = point * dimension;
        (first * size..(first + dimension) * size).for_each(|row| jacobian[(row, row)] = 1.0);
        for component in 0..self.components() {
            let moved = self.statics.receptance[(first, component)];
            jacobian[(first * size, component * size)] -= self.scales[point].stiffness * moved;
        }
    }

    fn blocks(&self, point: usize, projected: &[ProjectedForce]) -> PointBlocks {
        let (size, dimension) = (self.series.coefficients(), self.contact.dimension);
        let rows = dimension * size;
        let of_point = || projected.iter().skip(point).step_by(self.contact.points.len());
        let slope = |own: &ProjectedForce, which: usize| {
            let (by_motion, place) = (which / (dimension * dimension), which % (dimension * dimension));
            let table = if by_motion == 0 { &own.by_force } else { &own.by_motion };
            table[place % dimension][place / dimension]
        };
        // most of them are zero throughout
        let mut is_present = vec![false; 2 * dimension * dimension];
        for own in of_point().filter(|own| !own.is_constant()) {
            is_present.iter_mut().enumerate().for_each(|(which, is)| *is |= slope(own, which) != 0.0);
        }
        let present: Vec<usize> = (0..is_present.len()).filter(|which| is_present[*which]).collect();
        let mut factors = Mat::zeros(self.series.samples(), present.len());
        for (column, which) in present.iter().enumerate() {
            let values = factors.col_as_slice_mut(column);
            values.iter_mut().zip(of_point()).for_each(|(value, own)| *value = slope(own, *which));
        }
        let factors = self.series.of_factors(factors.as_ref());
        let mut own = [vec![0.0; rows * rows], vec![0.0; rows * rows]];
        let mut block = vec![0.0; size * size];
        for (k, which) in present.into_iter().enumerate() {
            let (table, place) = (which / (dimension * dimension), which % (dimension * dimension));
            let (row, column) = (place % dimension, place / dimension);
            self.series.multiplication(factors.col_as_slice(k), &mut block);
            for (k, from) in block.chunks_exact(size).enumerate() {
                let first = (column * size + k) * rows + row * size;
                own[table][first..first + size].iter_mut().zip(from).for_each(|(out, from)| *out = -from);
            }
        }
        let [mut by_force, by_motion] = own;
        (0..rows).for_each(|k| by_force[k * rows + k] += 1.0);
        PointBlocks { size, dimension, by_force, by_motion }
    }

    /// By a coefficient of a force.
    fn add_unknown(
        &self,
        point: usize,
        [component, coefficient]: [usize; 2],
        blocks: &PointBlocks,
        responses: &Responses,
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
                    let g = responses.receptances[harmonic - 1][(row, component)];
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
        responses: &Responses,
        out: &mut [f64],
    ) {
        let dimension = self.contact.dimension;
        for own in 0..dimension {
            for (k, response) in responses.harmonics.iter().enumerate() {
                let slope = turned(response, which, k + 1, point * dimension + own) / self.force;
                blocks.add_motion(own, k + 1, [slope.re, -slope.im], out);
            }
        }
    }

    /// The derivatives of the first harmonics of y.
    pub(super) fn first(&self, responses: &Responses) -> Mat<f64> {
        let (size, unknowns) = (self.series.coefficients(), self.unknowns());
        let (receptance, response) = (&responses.receptances[0], &responses.harmonics[0]);
        Mat::from_fn(2 * self.components(), unknowns + 2, |row, column| {
            let (component, is_sine) = (row / 2, row % 2 == 1);
            let value = match column.checked_sub(unknowns) {
                Some(which) => turned(response, which, 1, component),
                None if column % size == 1 => self.force * receptance[(component, column / size)],
                // of a sine the amplitude is −i
                None if column % size == 2 => {
                    self.force * c64::new(0.0, -1.0) * receptance[(component, column / size)]
                }
                None => c64::ZERO,
            };
            if is_sine { -value.im } else { value.re }
        })
    }
}

/// ∂y/∂ω, s = i h ω, or ∂y/∂σ.
fn turned(response: &crate::receptance::AtHarmonic, which: usize, harmonic: usize, component: usize) -> c64 {
    match which {
        0 => c64::new(0.0, harmonic as f64) * response.by_s[component],
        _ => response.by_growth[component],
    }
}
