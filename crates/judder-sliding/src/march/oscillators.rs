//! The modes of one body in a march: the two-term recurrence, and what rows see of it, in one pass over memory.
//!
//! The hot loop of a march. Modes stand in chunks of eight, whatever the machine; the widest vector instructions are chosen at run
//! time, and no operation differs between them, so neither do the results.

use pulp::{Arch, Simd, WithSimd};

/// Modes in a chunk.
pub(super) const LANES: usize = 8;
/// Rows that a body can have: eight of a stencil, the rest observed.
pub(super) const ROWS: usize = 16;

type Chunk = [f64; LANES];

/// How a mode goes on: q_{n+1} = p + g f_{n+1} and then p = A q_{n+1} − B q_n + g₀ f_{n+1} + g₁ f_n + push.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct ModalRecurrence {
    /// A.
    pub(super) ahead: f64,
    /// B.
    pub(super) behind: f64,
    /// g, what the force of the new time does at once.
    pub(super) at_once: f64,
    /// g₀ and g₁, what the forces of this and the last time do to the next.
    pub(super) later: [f64; 2],
}

impl ModalRecurrence {
    /// What a force that stays does in a step.
    pub(super) fn on_steady_force(&self) -> f64 {
        self.at_once + self.later[0] + self.later[1]
    }
}

/// Modal coordinates of one body with their recurrence and the rows that are watched.
#[derive(Debug, Clone)]
pub(super) struct Oscillators {
    /// The vector instructions that are used; any give the same bits.
    pub(super) arch: Arch,
    modes: usize,
    rows: usize,
    /// Whether forces act later than at once.
    remembers: bool,
    ahead: Vec<Chunk>,
    behind: Vec<Chunk>,
    at_once: Vec<Chunk>,
    later: [Vec<Chunk>; 2],
    push: Vec<Chunk>,
    state: Vec<Chunk>,
    predicted: Vec<Chunk>,
    force: Vec<Chunk>,
    /// Chunk after chunk, the rows of each one after the other.
    row_chunks: Vec<Chunk>,
}

/// One pass over the modes, under forces at the rows.
struct Pass<'a> {
    oscillators: &'a mut Oscillators,
    forces: &'a [f64; ROWS],
}

/// Row counts for which the pass is compiled.
const COMPILED: [usize; 8] = [2, 3, 4, 5, 6, 8, 10, ROWS];

impl Oscillators {
    /// Modes at rest, watched through so many rows.
    pub(super) fn new(recurrences: &[ModalRecurrence], rows: usize) -> Self {
        let modes = recurrences.len();
        let rows = COMPILED.into_iter().find(|compiled| *compiled >= rows).unwrap_or(ROWS);
        let zeros = vec![[0.0; LANES]; modes.div_ceil(LANES)];
        let mut oscillators = Self {
            arch: Arch::new(),
            modes,
            rows,
            remembers: false,
            ahead: zeros.clone(),
            behind: zeros.clone(),
            at_once: zeros.clone(),
            later: [zeros.clone(), zeros.clone()],
            push: zeros.clone(),
            state: zeros.clone(),
            predicted: zeros.clone(),
            force: zeros.clone(),
            row_chunks: vec![[0.0; LANES]; rows * zeros.len()],
        };
        oscillators.remembers = recurrences.iter().any(|r| r.later != [0.0; 2]);
        for (mode, recurrence) in recurrences.iter().enumerate() {
            oscillators.set_recurrence(mode, *recurrence);
        }
        oscillators
    }

    pub(super) fn set_recurrence(&mut self, mode: usize, recurrence: ModalRecurrence) {
        let (chunk, lane) = (mode / LANES, mode % LANES);
        self.ahead[chunk][lane] = recurrence.ahead;
        self.behind[chunk][lane] = recurrence.behind;
        self.at_once[chunk][lane] = recurrence.at_once;
        for (later, value) in self.later.iter_mut().zip(recurrence.later) {
            later[chunk][lane] = value;
        }
    }

    pub(super) fn recurrence(&self, mode: usize) -> ModalRecurrence {
        let (chunk, lane) = (mode / LANES, mode % LANES);
        ModalRecurrence {
            ahead: self.ahead[chunk][lane],
            behind: self.behind[chunk][lane],
            at_once: self.at_once[chunk][lane],
            later: [self.later[0][chunk][lane], self.later[1][chunk][lane]],
        }
    }

    /// How many modes move.
    pub(super) fn modes(&self) -> usize {
        self.modes
    }

    /// What pushes each mode from one prediction to the next.
    pub(super) fn set_push(&mut self, push: impl Fn(usize) -> f64) {
        for mode in 0..self.modes {
            self.push[mode / LANES][mode % LANES] = push(mode);
        }
    }

    /// Watches the modes through another row in this place; `row` has at least the modes' length.
    pub(super) fn set_row(&mut self, place: usize, row: &[f64]) {
        for (mode, value) in row.iter().take(self.modes).enumerate() {
            self.row_chunks[mode / LANES * self.rows + place][mode % LANES] = *value;
        }
    }

    /// Sets coordinates and forces at the rows, each of this time and of the last, and predicts the next without contact.
    pub(super) fn set_state(&mut self, [now, before]: [&[f64]; 2], [force, force_before]: [&[f64; ROWS]; 2]) {
        for mode in 0..self.modes {
            let (chunk, lane) = (mode / LANES, mode % LANES);
            let of_mode = |forces: &[f64; ROWS]| -> f64 {
                let rows = &self.row_chunks[chunk * self.rows..(chunk + 1) * self.rows];
                rows.iter().zip(forces).map(|(row, force)| row[lane] * force).sum()
            };
            let (of_now, of_before) = (of_mode(force), of_mode(force_before));
            self.predicted[chunk][lane] = self.ahead[chunk][lane] * now[mode]
                - self.behind[chunk][lane] * before[mode]
                + self.push[chunk][lane]
                + self.later[0][chunk][lane] * of_now
                + self.later[1][chunk][lane] * of_before;
            self.state[chunk][lane] = now[mode];
            self.force[chunk][lane] = of_now;
        }
    }

    /// Coordinates now.
    pub(super) fn state(&self) -> Vec<f64> {
        self.state.as_flattened()[..self.modes].to_vec()
    }

    /// All that a continued march needs: coordinates now, their prediction, forces.
    pub(super) fn memory(&self) -> [Vec<f64>; 3] {
        [&self.state, &self.predicted, &self.force].map(|chunks| chunks.as_flattened()[..self.modes].to_vec())
    }

    /// Whether a memory is of as many modes.
    pub(super) fn fits(&self, memory: &[Vec<f64>; 3]) -> bool {
        memory.iter().all(|values| values.len() == self.modes)
    }

    /// Takes up what [`Self::memory`] gave, of a memory that fits.
    pub(super) fn recall(&mut self, memory: &[Vec<f64>; 3]) {
        for (chunks, values) in
            [&mut self.state, &mut self.predicted, &mut self.force].into_iter().zip(memory)
        {
            chunks.as_flattened_mut()[..self.modes].copy_from_slice(values);
        }
    }

    /// What the rows see of the coordinates now, and of their prediction: the same bits as [`Self::advance`] tells.
    pub(super) fn seen(&self) -> [[f64; ROWS]; 2] {
        [&self.state, &self.predicted].map(|chunks| self.arch.dispatch(Sight { oscillators: self, chunks }))
    }

    /// Goes on by one step under forces at the rows, and tells what the rows see of the next prediction.
    #[inline]
    pub(super) fn advance(&mut self, forces: &[f64; ROWS]) -> [f64; ROWS] {
        self.arch.dispatch(Pass { oscillators: self, forces })
    }
}

impl WithSimd for Pass<'_> {
    type Output = [f64; ROWS];

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> [f64; ROWS] {
        match LANES / S::F64_LANES {
            1 => self.with_rows::<S, 1>(simd),
            2 => self.with_rows::<S, 2>(simd),
            4 => self.with_rows::<S, 4>(simd),
            _ => self.with_rows::<S, 8>(simd),
        }
    }
}

impl Pass<'_> {
    #[inline(always)]
    fn with_rows<S: Simd, const K: usize>(self, simd: S) -> [f64; ROWS] {
        match (self.oscillators.rows, self.oscillators.remembers) {
            (2, false) => self.run::<S, K, 2, false>(simd),
            (3, false) => self.run::<S, K, 3, false>(simd),
            (4, false) => self.run::<S, K, 4, false>(simd),
            (5, false) => self.run::<S, K, 5, false>(simd),
            (6, false) => self.run::<S, K, 6, false>(simd),
            (8, false) => self.run::<S, K, 8, false>(simd),
            (10, false) => self.run::<S, K, 10, false>(simd),
            (_, false) => self.run::<S, K, ROWS, false>(simd),
            (2, true) => self.run::<S, K, 2, true>(simd),
            (3, true) => self.run::<S, K, 3, true>(simd),
            (4, true) => self.run::<S, K, 4, true>(simd),
            (5, true) => self.run::<S, K, 5, true>(simd),
            (6, true) => self.run::<S, K, 6, true>(simd),
            (8, true) => self.run::<S, K, 8, true>(simd),
            (10, true) => self.run::<S, K, 10, true>(simd),
            (_, true) => self.run::<S, K, ROWS, true>(simd),
        }
    }

    /// K vectors make a chunk.
    #[inline(always)]
    fn run<S: Simd, const K: usize, const N: usize, const REMEMBERS: bool>(self, simd: S) -> [f64; ROWS] {
        let o = self.oscillators;
        // loops, since closures would not be compiled for the machine's vectors
        let mut forces = [simd.splat_f64s(0.0); N];
        for (splat, force) in forces.iter_mut().zip(self.forces) {
            *splat = simd.splat_f64s(*force);
        }
        let mut sums = [[simd.splat_f64s(0.0); K]; N];
        let (all_rows, _) = vectors::<S, K>(&o.row_chunks).as_chunks::<N>();
        let own = vectors_mut::<S, K>(&mut o.state).iter_mut();
        let own = own.zip(vectors_mut::<S, K>(&mut o.predicted)).zip(vectors_mut::<S, K>(&mut o.force));
        let coefficients = vectors::<S, K>(&o.ahead).iter().zip(vectors::<S, K>(&o.behind));
        let coefficients = coefficients.zip(vectors::<S, K>(&o.at_once)).zip(vectors::<S, K>(&o.push));
        let later = vectors::<S, K>(&o.later[0]).iter().zip(vectors::<S, K>(&o.later[1]));
        for ((((state, predicted), old), (((ahead, behind), at_once), push)), (rows, later)) in
            own.zip(coefficients).zip(all_rows.iter().zip(later))
        {
            for k in 0..K {
                let mut force = simd.splat_f64s(0.0);
                for r in 0..N {
                    force = simd.mul_add_f64s(forces[r], rows[r][k], force);
                }
                let now = simd.mul_add_f64s(at_once[k], force, predicted[k]);
                let back = simd.mul_add_f64s(behind[k], state[k], simd.neg_f64s(push[k]));
                let mut next = simd.mul_add_f64s(ahead[k], now, simd.neg_f64s(back));
                if REMEMBERS {
                    next = simd.mul_add_f64s(later.0[k], force, next);
                    next = simd.mul_add_f64s(later.1[k], old[k], next);
                    old[k] = force;
                }
                for r in 0..N {
                    sums[r][k] = simd.mul_add_f64s(rows[r][k], next, sums[r][k]);
                }
                state[k] = now;
                predicted[k] = next;
            }
        }
        let mut seen = [0.0; ROWS];
        for (seen, sum) in seen.iter_mut().zip(&sums) {
            *seen = total(&lanes::<S, K>(sum));
        }
        seen
    }
}

/// What the rows see of coordinates.
struct Sight<'a> {
    oscillators: &'a Oscillators,
    chunks: &'a [Chunk],
}

impl WithSimd for Sight<'_> {
    type Output = [f64; ROWS];

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> [f64; ROWS] {
        let rows = self.oscillators.rows;
        let mut seen = [0.0; ROWS];
        for (place, seen) in seen.iter_mut().enumerate().take(rows) {
            let mut sum = [0.0; LANES];
            for (own, chunk) in self.oscillators.row_chunks.chunks_exact(rows).zip(self.chunks) {
                let row = S::as_simd_f64s(&own[place]).0;
                let sums = S::as_mut_simd_f64s(&mut sum).0.iter_mut();
                for ((sum, row), q) in sums.zip(row).zip(S::as_simd_f64s(chunk).0) {
                    *sum = simd.mul_add_f64s(*row, *q, *sum);
                }
            }
            *seen = total(&sum);
        }
        seen
    }
}

/// Chunks as vectors of the machine.
#[inline(always)]
fn vectors<S: Simd, const K: usize>(chunks: &[Chunk]) -> &[[S::f64s; K]] {
    S::as_simd_f64s(chunks.as_flattened()).0.as_chunks().0
}

#[inline(always)]
fn vectors_mut<S: Simd, const K: usize>(chunks: &mut [Chunk]) -> &mut [[S::f64s; K]] {
    S::as_mut_simd_f64s(chunks.as_flattened_mut()).0.as_chunks_mut().0
}

/// Vectors that make a chunk as its lanes.
#[inline(always)]
fn lanes<S: Simd, const K: usize>(sum: &[S::f64s; K]) -> Chunk {
    let mut lanes = [0.0; LANES];
    S::as_mut_simd_f64s(&mut lanes).0.copy_from_slice(sum);
    lanes
}

/// The lanes' sum, in one order on every machine.
#[inline(always)]
fn total(x: &Chunk) -> f64 {
    ((x[0] + x[4]) + (x[2] + x[6])) + ((x[1] + x[5]) + (x[3] + x[7]))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn oscillators(rows: usize) -> Oscillators {
        let own = |k: usize| ModalRecurrence {
            ahead: 1.9 - 0.01 * k as f64,
            behind: 0.99,
            at_once: 1.0 + 0.1 * k as f64,
            later: [0.2, 0.01 * k as f64],
        };
        let mut oscillators = Oscillators::new(&(0..19).map(own).collect::<Vec<_>>(), rows);
        for place in 0..rows {
            let row: Vec<f64> = (0..19).map(|k| ((k * (place + 1)) as f64).sin()).collect();
            oscillators.set_row(place, &row);
        }
        oscillators.set_push(|k| 0.01 * k as f64);
        let now: Vec<f64> = (0..19).map(|k| (k as f64).cos()).collect();
        oscillators.set_state([&now, &now], [&[0.0; ROWS]; 2]);
        oscillators
    }

    /// The pass does what the recurrence says, mode by mode.
    #[test]
    fn the_pass_is_the_recurrence() {
        for rows in [1, 2, 5, 7, 13] {
            let mut oscillators = oscillators(rows);
            let before = oscillators.clone();
            let forces = std::array::from_fn(|r| if r < rows { 0.3 - 0.1 * r as f64 } else { 0.0 });
            let seen = oscillators.advance(&forces);
            for mode in 0..19 {
                let force: f64 = (0..rows).map(|r| forces[r] * ((mode * (r + 1)) as f64).sin()).sum();
                let k = mode as f64;
                let now = before.predicted[mode / LANES][mode % LANES] + (1.0 + 0.1 * k) * force;
                let next = (1.9 - 0.01 * k) * now - 0.99 * k.cos() + 0.01 * k + 0.2 * force;
                assert!((oscillators.state()[mode] - now).abs() < 1e-13);
                assert!((oscillators.predicted[mode / LANES][mode % LANES] - next).abs() < 1e-13);
            }
            assert_eq!(seen, oscillators.seen()[1], "{rows} rows");
        }
    }

    #[test]
    fn memory_brings_back_the_same_bits() {
        let mut first = oscillators(5);
        let forces = [0.1; ROWS];
        first.advance(&forces);
        let mut second = oscillators(5);
        second.recall(&first.memory());
        assert_eq!(first.advance(&forces), second.advance(&forces));
        assert_eq!(first.memory(), second.memory());
        assert!(!second.fits(&[vec![0.0], vec![0.0], vec![0.0]]));
    }
}
