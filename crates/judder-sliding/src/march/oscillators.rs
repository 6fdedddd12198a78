//! The modes of one body in a march: the two-term recurrence, and what rows see of it, in one pass over memory.
//!
//! The hot loop of a march. Modes stand in chunks of eight, whatever the machine; the widest vector instructions are chosen at run
//! time, and no operation differs between them, so neither do the results.

use multiversion::multiversion;

/// Modes in a chunk.
pub(super) const LANES: usize = 8;
/// Rows that a body can have: eight of a stencil, the rest observed.
pub(super) const ROWS: usize = 16;

type Chunk = [f64; LANES];

/// How a mode goes on: q_{n+1} = p + g f_{n+1} and then p = A q_{n+1} − B q_n + g₀ f_{n+1} + g₁ f_n + push.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Recurrence {
    /// A.
    pub(super) ahead: f64,
    /// B.
    pub(super) behind: f64,
    /// g, what the force of the new time does at once.
    pub(super) at_once: f64,
    /// g₀ and g₁, what the forces of this and the last time do to the next.
    pub(super) later: [f64; 2],
}

/// Modal coordinates of one body with their recurrence and the rows that are watched.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Oscillators {
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

/// Row counts for which the pass is compiled.
const COMPILED: [usize; 8] = [2, 3, 4, 5, 6, 8, 10, ROWS];

impl Oscillators {
    /// Modes at rest, watched through so many rows.
    pub(super) fn new(recurrences: &[Recurrence], rows: usize) -> Self {
        let modes = recurrences.len();
        let rows = COMPILED.into_iter().find(|compiled| *compiled >= rows).unwrap_or(ROWS);
        let zeros = vec![[0.0; LANES]; modes.div_ceil(LANES)];
        let mut oscillators = Self {
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

    pub(super) fn set_recurrence(&mut self, mode: usize, recurrence: Recurrence) {
        let (chunk, lane) = (mode / LANES, mode % LANES);
        self.ahead[chunk][lane] = recurrence.ahead;
        self.behind[chunk][lane] = recurrence.behind;
        self.at_once[chunk][lane] = recurrence.at_once;
        for (later, value) in self.later.iter_mut().zip(recurrence.later) {
            later[chunk][lane] = value;
        }
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

    /// Sets this time's and the last time's coordinates and predicts the next without contact.
    pub(super) fn set_state(&mut self, now: &[f64], before: &[f64]) {
        for mode in 0..self.modes {
            let (chunk, lane) = (mode / LANES, mode % LANES);
            self.state[chunk][lane] = now[mode];
            self.force[chunk][lane] = 0.0;
            self.predicted[chunk][lane] = self.ahead[chunk][lane] * now[mode]
                - self.behind[chunk][lane] * before[mode]
                + self.push[chunk][lane];
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

    /// Takes up what [`Self::memory`] gave; `false` where it is of other modes.
    pub(super) fn recall(&mut self, memory: &[Vec<f64>; 3]) -> bool {
        if memory.iter().any(|values| values.len() != self.modes) {
            return false;
        }
        for (chunks, values) in
            [&mut self.state, &mut self.predicted, &mut self.force].into_iter().zip(memory)
        {
            chunks.as_flattened_mut()[..self.modes].copy_from_slice(values);
        }
        true
    }

    /// What the rows see of the coordinates now, and of their prediction.
    pub(super) fn seen(&self) -> [[f64; ROWS]; 2] {
        let mut seen = [[0.0; ROWS]; 2];
        for (seen, chunks) in seen.iter_mut().zip([&self.state, &self.predicted]) {
            for (row, seen) in seen.iter_mut().enumerate().take(self.rows) {
                let sum = |sum: Chunk, (k, q): (usize, &Chunk)| {
                    let row = &self.row_chunks[k * self.rows + row];
                    std::array::from_fn(|lane| sum[lane] + row[lane] * q[lane])
                };
                *seen = total(&chunks.iter().enumerate().fold([0.0; LANES], sum));
            }
        }
        seen
    }

    /// Goes on by one step under forces at the rows, and tells what the rows see of the next prediction.
    #[inline]
    pub(super) fn advance(&mut self, forces: &[f64; ROWS]) -> [f64; ROWS] {
        advance(self, forces)
    }
}

#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl", "x86_64+avx2", "aarch64+neon"))]
fn advance(o: &mut Oscillators, forces: &[f64; ROWS]) -> [f64; ROWS] {
    if o.remembers {
        match o.rows {
            2 => pass::<2, true>(o, forces),
            3 => pass::<3, true>(o, forces),
            4 => pass::<4, true>(o, forces),
            5 => pass::<5, true>(o, forces),
            6 => pass::<6, true>(o, forces),
            8 => pass::<8, true>(o, forces),
            10 => pass::<10, true>(o, forces),
            _ => pass::<ROWS, true>(o, forces),
        }
    } else {
        match o.rows {
            2 => pass::<2, false>(o, forces),
            3 => pass::<3, false>(o, forces),
            4 => pass::<4, false>(o, forces),
            5 => pass::<5, false>(o, forces),
            6 => pass::<6, false>(o, forces),
            8 => pass::<8, false>(o, forces),
            10 => pass::<10, false>(o, forces),
            _ => pass::<ROWS, false>(o, forces),
        }
    }
}

#[inline(always)]
fn pass<const N: usize, const REMEMBERS: bool>(o: &mut Oscillators, forces: &[f64; ROWS]) -> [f64; ROWS] {
    let mut sums = [[0.0; LANES]; N];
    let (all_rows, _) = o.row_chunks.as_chunks::<N>();
    let own = o.state.iter_mut().zip(&mut o.predicted).zip(&mut o.force);
    let coefficients = o.ahead.iter().zip(&o.behind).zip(&o.at_once).zip(&o.push);
    let later = o.later[0].iter().zip(&o.later[1]);
    for ((((state, predicted), old), (((ahead, behind), at_once), push)), (rows, later)) in
        own.zip(coefficients).zip(all_rows.iter().zip(later))
    {
        let mut force = [0.0; LANES];
        for r in 0..N {
            for lane in 0..LANES {
                force[lane] += forces[r] * rows[r][lane];
            }
        }
        let mut next = [0.0; LANES];
        for lane in 0..LANES {
            let now = predicted[lane] + at_once[lane] * force[lane];
            next[lane] = ahead[lane] * now - behind[lane] * state[lane] + push[lane];
            state[lane] = now;
            if REMEMBERS {
                next[lane] += later.0[lane] * force[lane] + later.1[lane] * old[lane];
                old[lane] = force[lane];
            }
            predicted[lane] = next[lane];
        }
        for r in 0..N {
            for lane in 0..LANES {
                sums[r][lane] += rows[r][lane] * next[lane];
            }
        }
    }
    std::array::from_fn(|r| if r < N { total(&sums[r]) } else { 0.0 })
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
        let own = |k: usize| Recurrence {
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
        oscillators.set_state(&now, &now);
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
        assert!(second.recall(&first.memory()));
        assert_eq!(first.advance(&forces), second.advance(&forces));
        assert_eq!(first, second);
        assert!(!second.recall(&[vec![0.0], vec![0.0], vec![0.0]]));
    }
}
