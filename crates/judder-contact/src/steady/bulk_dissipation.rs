//! Friction from the energy that the substrate dissipates, computed in Fourier space.

use crate::kernel::substrate::SlidingSubstrate;
use crate::surface::grid::SurfaceGrid;
use judder_numerics::gmres::dot;
use judder_numerics::quadrature::gauss_legendre;
use std::f64::consts::PI;

/// Largest number of cells a side for which the transform is taken; finer pressures are gathered in blocks first.
const LARGEST_SIDE: usize = 256;
/// The same for the one row of a line contact.
const LARGEST_ROW: usize = 2048;
/// How often half a wave over the contact is halved for the first panel.
const HALVINGS: i32 = 16;
/// Nodes of a panel, which spans half a wave over the contact once the waves are short.
const NODES: usize = 4;

/// The friction force, in E0* times the square of the length unit, from the dissipation in the bulk.
///
/// In steady sliding the power of friction is what the substrate dissipates:
/// F_x = (1/4π²) ∫ q_x · 2 Im[J(q_x)]/|q| · |P(q)|² d²q, with P the transform of the pressure and J(q_x) = E0/E(ω) the compliance
/// at ω = q_x v (Persson 2001 in the form of eqs. 30–32). The transform is taken at the nodes of a quadrature graded
/// towards q = 0, where 1/|q| and the wake put their weight; a uniform sum over FFT modes is tens of per cent off
/// there. Waves shorter than four cells are not resolved: their part is extrapolated from the last octave that is,
/// with the |P|² ∝ q⁻⁴ of a pressure that ends like a square root. Valid for any pressure on a bounded contact.
#[must_use]
pub fn friction_from_dissipation(grid: &SurfaceGrid, pressure: &[f64], substrate: &SlidingSubstrate) -> f64 {
    let Some(patch) = LoadedPatch::of(grid, pressure, LARGEST_SIDE) else {
        return 0.0;
    };
    let shortest = 0.5 * PI / patch.cell;
    let along = wave_numbers(patch.width(), patch.cell, HALVINGS);
    let across = wave_numbers(patch.height(), patch.cell, HALVINGS);
    let (mut resolved, mut last_octave) = (0.0, 0.0);
    let across: Vec<Across> = across.into_iter().map(|(wave, weight)| patch.across(wave, weight)).collect();
    let mut rows = FoldedRows::new(patch.rows);
    for (wave_x, weight_x) in along {
        patch.transform_rows(wave_x, &mut rows);
        let damping = weight_x / patch.sinc(wave_x).powi(2) * wave_x * substrate.compliance(wave_x).im;
        for wave_y in &across {
            let wave = (wave_x * wave_x + wave_y.wave * wave_y.wave).sqrt();
            if wave > shortest {
                break;
            }
            let part = damping * wave_y.weight * 2.0 / wave * wave_y.power(&rows);
            resolved += part;
            if wave > 0.5 * shortest {
                last_octave += part;
            }
        }
    }
    (resolved + last_octave * beyond_the_last_octave(substrate, shortest)) / (2.0 * PI * PI)
}

/// The friction force per length of a line contact, in E0* times the length unit, from the dissipation in the bulk.
///
/// F_x = (1/2π) ∫ q · 2 Im[J(q)] f(q h)/|q| · |P(q)|² dq, f = 1 on a half-space, as [`friction_from_dissipation`] with all waves along x. Without the
/// waves across, long ones weigh more: the quadrature begins where the longest wake is passed in a small part of a wave.
#[must_use]
pub fn friction_of_a_line(grid: &SurfaceGrid, pressure: &[f64], substrate: &SlidingSubstrate) -> f64 {
    let Some(patch) = LoadedPatch::of(grid, pressure, LARGEST_ROW) else {
        return 0.0;
    };
    let shortest = 0.5 * PI / patch.cell;
    let longest = substrate.terms.iter().map(|term| term.length).fold(0.0, f64::max);
    let beyond = libm::log2(longest / patch.width()).clamp(0.0, 100.0).ceil() as i32;
    let (mut resolved, mut last_octave) = (0.0, 0.0);
    let mut rows = FoldedRows::new(1);
    for (wave, weight) in wave_numbers(patch.width(), patch.cell, HALVINGS + beyond) {
        patch.transform_rows(wave, &mut rows);
        let power = (rows.even_re[0].powi(2) + rows.even_im[0].powi(2)) / patch.sinc(wave).powi(2);
        let part = weight * substrate.compliance(wave).im * substrate.transfer(wave) * power;
        resolved += part;
        if wave > 0.5 * shortest {
            last_octave += part;
        }
    }
    // Forces were taken as on squares: P is h times what it is on strips.
    let strip = grid.cell * grid.cell;
    (resolved + last_octave * beyond_the_last_octave(substrate, shortest)) * 2.0 / (PI * strip)
}

/// ∫ q⁻³ Im J(q) dq over all waves that are not resolved, over that of the octave before.
fn beyond_the_last_octave(substrate: &SlidingSubstrate, shortest: f64) -> f64 {
    let octave = |from: f64| -> f64 {
        let steps = 16;
        (0..steps)
            .map(|step| from * libm::pow(2.0_f64, (f64::from(step) + 0.5) / f64::from(steps)))
            .map(|wave| substrate.compliance(wave).im / (wave * wave))
            .sum()
    };
    let last = octave(0.5 * shortest);
    if last > 0.0 {
        (0..30).map(|power| octave(shortest * 2.0_f64.powi(power))).sum::<f64>() / last
    } else {
        0.0
    }
}

/// Nodes and weights on (0, q_max): panels that double up to half a wave over the contact, equal panels from there.
fn wave_numbers(extent: f64, cell: f64, halvings: i32) -> Vec<(f64, f64)> {
    let half_wave = PI / extent;
    let largest = 0.5 * PI / cell;
    let mut edges: Vec<f64> = (0..=halvings).rev().map(|halving| half_wave * 0.5_f64.powi(halving)).collect();
    edges.insert(0, 0.0);
    let equal = ((largest - half_wave) / half_wave).ceil().max(0.0) as usize;
    edges.extend((1..=equal).map(|panel| half_wave * (1 + panel) as f64));
    let rule = gauss_legendre::<NODES>();
    edges
        .windows(2)
        .flat_map(|edge| {
            let (from, width) = (edge[0], edge[1] - edge[0]);
            rule.map(move |(node, weight)| (from + width * node, width * weight))
        })
        .collect()
}

/// The loaded part of the surface as forces at the centres of (possibly gathered) cells.
struct LoadedPatch {
    columns: usize,
    rows: usize,
    cell: f64,
    forces: Vec<f64>,
}

impl LoadedPatch {
    fn of(grid: &SurfaceGrid, pressure: &[f64], largest_side: usize) -> Option<Self> {
        let loaded = |column: usize, row: usize| pressure[row * grid.columns + column] != 0.0;
        let rows: Vec<usize> =
            (0..grid.rows).filter(|row| (0..grid.columns).any(|c| loaded(c, *row))).collect();
        let columns: Vec<usize> =
            (0..grid.columns).filter(|c| (0..grid.rows).any(|row| loaded(*c, row))).collect();
        let (top, bottom) = (*rows.first()?, *rows.last()?);
        let (left, right) = (*columns.first()?, *columns.last()?);
        let block = (bottom + 1 - top).max(right + 1 - left).div_ceil(largest_side);
        let (wide, high) = ((right + 1 - left).div_ceil(block), (bottom + 1 - top).div_ceil(block));
        let mut forces = vec![0.0; wide * high];
        for row in top..=bottom {
            for column in left..=right {
                forces[(row - top) / block * wide + (column - left) / block] +=
                    pressure[row * grid.columns + column] * grid.cell_area();
            }
        }
        Some(Self { columns: wide, rows: high, cell: grid.cell * block as f64, forces })
    }

    fn width(&self) -> f64 {
        self.columns as f64 * self.cell
    }

    fn height(&self) -> f64 {
        self.rows as f64 * self.cell
    }

    /// What the mean over a cell leaves of a wave; dividing by it gives the wave itself.
    fn sinc(&self, wave: f64) -> f64 {
        let phase = 0.5 * wave * self.cell;
        if phase < 1e-6 { 1.0 } else { libm::sin(phase) / phase }
    }

    /// Σ over x of force · e^{−i q_x x} of every row, the sums and differences of opposite rows.
    fn transform_rows(&self, wave: f64, rows: &mut FoldedRows) {
        let (cosines, sines): (Vec<f64>, Vec<f64>) =
            (0..self.columns).map(|c| libm::sincos(wave * self.cell * c as f64)).map(|(s, c)| (c, s)).unzip();
        let row = |index: usize| {
            let forces = &self.forces[index * self.columns..(index + 1) * self.columns];
            (dot(forces, &cosines), -dot(forces, &sines))
        };
        for index in 0..rows.even_re.len() {
            let opposite = self.rows - 1 - index;
            let ((re, im), (other_re, other_im)) =
                (row(index), if opposite == index { (0.0, 0.0) } else { row(opposite) });
            (rows.even_re[index], rows.even_im[index]) = (re + other_re, im + other_im);
            (rows.odd_re[index], rows.odd_im[index]) = (re - other_re, im - other_im);
        }
    }

    /// A wave across the sliding direction, about the middle of the patch.
    fn across(&self, wave: f64, weight: f64) -> Across {
        let middle = 0.5 * (self.rows as f64 - 1.0);
        let (sines, cosines) = (0..self.rows.div_ceil(2))
            .map(|row| libm::sincos(wave * self.cell * (middle - row as f64)))
            .unzip();
        Across { wave, weight: weight / self.sinc(wave).powi(2), cosines, sines }
    }
}

/// The sums and the differences of the transforms of rows that lie opposite each other about the middle.
struct FoldedRows {
    even_re: Vec<f64>,
    even_im: Vec<f64>,
    odd_re: Vec<f64>,
    odd_im: Vec<f64>,
}

impl FoldedRows {
    fn new(rows: usize) -> Self {
        let half = vec![0.0; rows.div_ceil(2)];
        Self { even_re: half.clone(), even_im: half.clone(), odd_re: half.clone(), odd_im: half }
    }
}

/// A wave number q_y > 0 with its weight and its turns at the rows of the first half.
struct Across {
    wave: f64,
    weight: f64,
    cosines: Vec<f64>,
    sines: Vec<f64>,
}

impl Across {
    /// |P(q_x, q_y)|² + |P(q_x, −q_y)|² of the transformed rows.
    fn power(&self, rows: &FoldedRows) -> f64 {
        let (even_re, even_im) = (dot(&rows.even_re, &self.cosines), dot(&rows.even_im, &self.cosines));
        let (odd_re, odd_im) = (dot(&rows.odd_re, &self.sines), dot(&rows.odd_im, &self.sines));
        // |E ± iO|² summed: the cross terms cancel.
        2.0 * (even_re * even_re + even_im * even_im + odd_re * odd_re + odd_im * odd_im)
    }
}
