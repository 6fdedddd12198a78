//! MovingBodies as the modes of all of them together, which their damping leaves free of each other.

use super::free_modes::FreeModes;
use super::{BodyEnergy, BodyWork, StepRule};
use faer::Mat;
use judder_assembly::assembly::Assembly;
use judder_assembly::row::Row;
use pulp::Arch;

/// Numbers that are worked together, whatever the machine: sums are in the same order on all.
const LANES: usize = 8;

/// z̈ + d ż + λ z = f of each mode, with vectors filled up to whole groups of lanes.
#[derive(Debug, Clone)]
pub(super) struct ModalBodies {
    arch: Arch,
    rule: StepRule,
    /// Modes, filled up.
    size: usize,
    /// λ in rad²/s².
    eigenvalues: Vec<f64>,
    /// One of each mode that moves, zero of each that only yields.
    moving: Vec<f64>,
    /// d in 1/s; none of those that only yield.
    damping: Vec<f64>,
    /// 1/(1 + h θ d + h² θ² λ); of those that only yield 1/(h² λ).
    inverse: Vec<f64>,
    /// H Φ row after row, and the same times the inverse.
    rows: Vec<f64>,
    pushes: Vec<f64>,
    /// Φ and M Φ, freedoms × modes.
    shapes: Mat<f64>,
    weighted: Mat<f64>,
}

impl ModalBodies {
    /// `None` where the modes are too many, their damping joins them, or a matrix is not symmetric.
    pub(super) fn new(assembly: &Assembly, rows: &[Row], rule: StepRule) -> Option<Self> {
        let FreeModes { eigenvalues: values, damping, shapes, weighted } = FreeModes::new(assembly)?;
        let freedoms = values.len();
        let size = freedoms.next_multiple_of(LANES);
        let filled = |values: &[f64]| [values, &vec![0.0; size - freedoms]].concat();
        let StepRule { step, implicitness, cut_off } = rule;
        let moves = |value: &f64| *value < cut_off * cut_off;
        let eigenvalues = filled(&values);
        let moving: Vec<f64> = eigenvalues.iter().map(|value| f64::from(u8::from(moves(value)))).collect();
        let damping: Vec<f64> =
            filled(&damping).iter().zip(&moving).map(|(own, moves)| own * moves).collect();
        let share = step * implicitness;
        let inverse: Vec<f64> = eigenvalues
            .iter()
            .zip(&damping)
            .map(|(l, d)| match moves(l) {
                true => 1.0 / (1.0 + share * d + share * share * l),
                false => 1.0 / (step * step * l),
            })
            .collect();
        let mut on_modes = vec![0.0; rows.len() * size];
        for (row, own) in rows.iter().zip(on_modes.chunks_exact_mut(size)) {
            for (mode, value) in own.iter_mut().enumerate().take(freedoms) {
                *value = row.entries().iter().map(|(freedom, share)| share * shapes[(*freedom, mode)]).sum();
            }
        }
        let pushes = on_modes
            .chunks_exact(size)
            .flat_map(|own| own.iter().zip(&inverse).map(|(value, inverse)| value * inverse))
            .collect();
        Some(Self {
            arch: Arch::new(),
            rule,
            size,
            eigenvalues,
            moving,
            damping,
            inverse,
            rows: on_modes,
            pushes,
            shapes,
            weighted,
        })
    }

    #[cfg(test)]
    pub(super) fn set_arch(&mut self, arch: Arch) {
        self.arch = arch;
    }

    pub(super) fn size(&self) -> usize {
        self.size
    }

    pub(super) fn coordinates(&self, freedoms: &[f64]) -> Vec<f64> {
        self.projected(&self.weighted, freedoms)
    }

    pub(super) fn forces(&self, freedoms: &[f64]) -> Vec<f64> {
        self.projected(&self.shapes, freedoms)
    }

    fn projected(&self, basis: &Mat<f64>, freedoms: &[f64]) -> Vec<f64> {
        let of = |mode: usize| freedoms.iter().enumerate().map(|(k, value)| basis[(k, mode)] * value).sum();
        let mut own: Vec<f64> = (0..basis.ncols()).map(of).collect();
        own.resize(self.size, 0.0);
        own
    }

    pub(super) fn freedoms(&self, z: &[f64]) -> Vec<f64> {
        let of = |freedom: usize| {
            (0..self.shapes.ncols()).map(|mode| self.shapes[(freedom, mode)] * z[mode]).sum()
        };
        (0..self.shapes.nrows()).map(of).collect()
    }

    pub(super) fn free(&self, z: &[f64], v: &[f64], load: &[f64], out: &mut [f64]) {
        let StepRule { step, implicitness, .. } = self.rule;
        let ahead = step * implicitness;
        let (z, v, load, out) = (&z[..self.size], &v[..self.size], &load[..self.size], &mut out[..self.size]);
        let (eigenvalues, damping) = (&self.eigenvalues[..self.size], &self.damping[..self.size]);
        let (inverse, moving) = (&self.inverse[..self.size], &self.moving[..self.size]);
        self.arch.dispatch(
            #[inline(always)]
            || {
                for k in 0..out.len() {
                    let force = damping[k] * v[k] + eigenvalues[k] * (z[k] + ahead * v[k]) - load[k];
                    out[k] = moving[k] * v[k] - step * force * inverse[k];
                }
            },
        );
    }

    pub(super) fn seen(&self, z: &[f64], first: usize, every: usize, out: &mut [f64]) {
        let z = &z[..self.size];
        let rows = self.rows.chunks_exact(self.size.max(1)).skip(first).step_by(every);
        self.arch.dispatch(
            #[inline(always)]
            || {
                for (row, out) in rows.zip(out) {
                    *out = dot(row, z);
                }
            },
        );
    }

    pub(super) fn push(&self, impulses: &[f64], v: &mut [f64]) {
        let v = &mut v[..self.size];
        self.arch.dispatch(
            #[inline(always)]
            || {
                for (row, impulse) in self.pushes.chunks_exact(self.size).zip(impulses) {
                    if *impulse != 0.0 {
                        v.iter_mut().zip(row).for_each(|(v, push)| *v += impulse * push);
                    }
                }
            },
        );
    }

    pub(super) fn energy(&self, z: &[f64], v: &[f64], load: &[f64]) -> BodyEnergy {
        let back = if self.rule.implicitness == 0.0 { self.rule.step } else { 0.0 };
        let mut energy = BodyEnergy::default();
        for k in 0..self.size {
            energy.kinetic += 0.5 * self.moving[k] * v[k] * v[k];
            energy.potential += 0.5 * self.eigenvalues[k] * z[k] * (z[k] - back * v[k])
                - load[k] * (z[k] - 0.5 * back * v[k]);
        }
        energy
    }

    pub(super) fn work(&self, before: &[f64], after: &[f64]) -> BodyWork {
        let (share, [earlier, later]) = (self.rule.implicitness, self.rule.working());
        let (before, after, damping) =
            (&before[..self.size], &after[..self.size], &self.damping[..self.size]);
        let taken = self.arch.dispatch(
            #[inline(always)]
            || {
                let mut sums = [0.0; LANES];
                for first in (0..before.len()).step_by(LANES) {
                    for (lane, sum) in sums.iter_mut().enumerate() {
                        let k = first + lane;
                        let damped = before[k] + share * (after[k] - before[k]);
                        *sum += damping[k] * damped * (earlier * before[k] + later * after[k]);
                    }
                }
                total(sums)
            },
        );
        BodyWork {
            damping: -self.rule.step * taken,
            circulation: 0.0,
            flexibility: if self.rule.cut_off.is_finite() { self.yielded(before, after) } else { 0.0 },
            scheme: if share > 0.5 { self.held_back(before, after) } else { 0.0 },
        }
    }

    /// −(θ − ½) (|Δv|² + Δzᵀ λ Δz).
    fn held_back(&self, before: &[f64], after: &[f64]) -> f64 {
        let (step, [first, second]) = (self.rule.step, self.rule.working());
        let of = |k: usize| {
            let (faster, moved) = (after[k] - before[k], step * (first * before[k] + second * after[k]));
            faster * faster + self.eigenvalues[k] * moved * moved
        };
        -(second - 0.5) * (0..self.size).map(of).sum::<f64>()
    }

    /// What modes that only yield take of the impulses' work: −½ (p⁺ − p)·(v + v⁺) of each, whose impulse p⁺ − p = h² λ v⁺ has changed.
    fn yielded(&self, before: &[f64], after: &[f64]) -> f64 {
        let square = self.rule.step * self.rule.step;
        let of = |k: usize| (1.0 - self.moving[k]) * self.eigenvalues[k] * after[k] * (before[k] + after[k]);
        -0.5 * square * (0..self.size).map(of).sum::<f64>()
    }

    pub(super) fn fastest(&self) -> [f64; 2] {
        let largest = |values: &[f64]| {
            values.iter().zip(&self.moving).map(|(value, moves)| value * moves).fold(0.0, f64::max)
        };
        [largest(&self.eigenvalues).sqrt(), largest(&self.damping)]
    }
}

/// a·b of whole groups of lanes.
#[inline(always)]
fn dot(a: &[f64], b: &[f64]) -> f64 {
    let mut sums = [0.0; LANES];
    for (a, b) in a.as_chunks::<LANES>().0.iter().zip(b.as_chunks::<LANES>().0) {
        for lane in 0..LANES {
            sums[lane] += a[lane] * b[lane];
        }
    }
    total(sums)
}

#[inline(always)]
fn total(sums: [f64; LANES]) -> f64 {
    ((sums[0] + sums[4]) + (sums[2] + sums[6])) + ((sums[1] + sums[5]) + (sums[3] + sums[7]))
}
