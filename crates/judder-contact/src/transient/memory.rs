//! What the substrate remembers: one retarded pressure for each retardation time.
//!
//! Creep of the surface, w_k(x, t) = C_k W[p_k] with τ_k ṗ_k = p − p_k, has a memory with bounded support: p_k is zero
//! where nothing has pressed, while w_k reaches everywhere. So the fields p_k are kept, and material on which the
//! indenter will come has crept rightly before it is reached.

use super::error::TransientError;
use super::substrate::{CreepingSubstrate, CreepingTerm};
use super::weights::StepWeights;
use super::window::ContactWindow;
use crate::kernel::sliding::SlidingOperator;
use crate::kernel::substrate::SlidingSubstrate;
use crate::surface::operator::SurfaceOperator;

/// A pressure on a window of material.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Footprint {
    /// Material column at which the window begins.
    pub(super) first_column: i64,
    /// Pressure on the window, in E0*.
    pub(super) pressure: Vec<f64>,
}

impl Footprint {
    /// The same pressure on a window that begins elsewhere; nothing where the two do not overlap.
    pub(super) fn on(&self, first_column: i64, side: usize) -> Vec<f64> {
        let mut moved = vec![0.0; self.pressure.len()];
        copy_columns(&self.pressure, self.first_column, side, &mut moved, first_column, side);
        moved
    }
}

/// Copies the columns that two arrays of material share.
fn copy_columns(
    from: &[f64],
    from_first: i64,
    from_columns: usize,
    to: &mut [f64],
    first: i64,
    columns: usize,
) {
    let left = from_first.max(first);
    let right = (from_first + from_columns as i64).min(first + columns as i64);
    let Ok(shared) = usize::try_from(right - left) else {
        return;
    };
    let (source, target) = ((left - from_first) as usize, (left - first) as usize);
    for (from, to) in from.chunks_exact(from_columns).zip(to.chunks_exact_mut(columns)) {
        to[target..target + shared].copy_from_slice(&from[source..source + shared]);
    }
}

/// The retarded pressures on the strip of material that is remembered.
pub(super) struct StripMemory {
    window: ContactWindow,
    substrate: CreepingSubstrate,
    operator: SlidingOperator,
    first_column: i64,
    /// p_k, one field for each retardation time, on the strip.
    retarded: Vec<Vec<f64>>,
    source: Vec<f64>,
    displacement: Vec<f64>,
}

impl StripMemory {
    /// Material that has never been pressed on.
    pub(super) fn new(
        window: ContactWindow,
        substrate: &CreepingSubstrate,
        first_column: i64,
        allowed: u64,
    ) -> Result<Self, TransientError> {
        let cells = window.strip * window.side;
        Ok(Self {
            window,
            substrate: substrate.clone(),
            operator: SlidingOperator::new(window.strip_grid(), &SlidingSubstrate::elastic(), allowed)?,
            first_column: first_column - ((window.strip - window.side) / 2) as i64,
            retarded: vec![vec![0.0; cells]; substrate.terms.len()],
            source: vec![0.0; cells],
            displacement: vec![0.0; cells],
        })
    }

    /// The weights of a step, term by term.
    pub(super) fn weights(&self, step: f64) -> Vec<StepWeights> {
        self.substrate.terms.iter().map(|term| StepWeights::new(step / term.time)).collect()
    }

    /// Σ C_k weight_k, in 1/E0.
    pub(super) fn sum(&self, weights: &[StepWeights], which: fn(&StepWeights) -> f64) -> f64 {
        self.substrate.terms.iter().zip(weights).map(|(term, weights)| term.compliance * which(weights)).sum()
    }

    /// E0/E∞ + Σ C_k new_k: how a pressure at the end of a step moves the surface there.
    pub(super) fn compliance(&self, weights: &[StepWeights]) -> f64 {
        self.substrate.instantaneous + self.sum(weights, |weights| weights.new)
    }

    /// Moves the strip, if it must, so that it holds the columns of a window; what leaves it is forgotten.
    pub(super) fn cover(&mut self, first_column: i64) {
        let last = self.first_column + (self.window.strip - self.window.side) as i64;
        let first = if first_column < self.first_column {
            first_column
        } else if first_column > last {
            first_column - (self.window.strip - self.window.side) as i64
        } else {
            return;
        };
        for field in &mut self.retarded {
            self.source.fill(0.0);
            copy_columns(
                field,
                self.first_column,
                self.window.strip,
                &mut self.source,
                first,
                self.window.strip,
            );
            std::mem::swap(field, &mut self.source);
        }
        self.first_column = first;
    }

    /// The displacement of a window at the end of a step that all earlier pressures make.
    pub(super) fn displacement(
        &mut self,
        last: &Footprint,
        weights: &[StepWeights],
        first_column: i64,
    ) -> Vec<f64> {
        let side = self.window.side;
        let mut history = vec![0.0; side * side];
        if weights.is_empty() {
            return history;
        }
        let old = self.sum(weights, |weights| weights.old);
        self.place(last, old);
        for ((field, term), weights) in self.retarded.iter().zip(&self.substrate.terms).zip(weights) {
            let factor = term.compliance * weights.keep;
            for (source, value) in self.source.iter_mut().zip(field) {
                *source += factor * value;
            }
        }
        self.operator.displacement(&self.source, &mut self.displacement);
        copy_columns(
            &self.displacement,
            self.first_column,
            self.window.strip,
            &mut history,
            first_column,
            side,
        );
        history
    }

    /// Ends a step: the pressures at its two ends enter the memory.
    pub(super) fn remember(&mut self, last: &Footprint, next: &Footprint, weights: &[StepWeights]) {
        for (term, weights) in weights.iter().enumerate() {
            self.retarded[term].iter_mut().for_each(|value| *value *= weights.keep);
            for (footprint, factor) in [(last, weights.old), (next, weights.new)] {
                self.place(footprint, factor);
                for (value, source) in self.retarded[term].iter_mut().zip(&self.source) {
                    *value += source;
                }
            }
        }
    }

    /// A pressure under which the substrate has rested for ever.
    pub(super) fn settle(&mut self, pressure: &Footprint) {
        self.place(pressure, 1.0);
        for field in &mut self.retarded {
            field.copy_from_slice(&self.source);
        }
    }

    /// source = factor · pressure, on the strip.
    fn place(&mut self, footprint: &Footprint, factor: f64) {
        self.source.fill(0.0);
        let (side, strip) = (self.window.side, self.window.strip);
        copy_columns(
            &footprint.pressure,
            footprint.first_column,
            side,
            &mut self.source,
            self.first_column,
            strip,
        );
        self.source.iter_mut().for_each(|value| *value *= factor);
    }

    /// The energy stored in the substrate, ½ ∫ (E0/E∞ p W[p] + Σ C_k p_k W[p_k]), in E0* R³.
    pub(super) fn stored_energy(&mut self, pressure: &Footprint) -> f64 {
        self.place(pressure, 1.0);
        let instantaneous = self.substrate.instantaneous;
        let mut sum = instantaneous * self.work_of_source();
        for term in 0..self.retarded.len() {
            self.source.copy_from_slice(&self.retarded[term]);
            sum += self.substrate.terms[term].compliance * self.work_of_source();
        }
        0.5 * sum
    }

    /// The power that the substrate turns into heat, Σ C_k/τ_k ∫ (p − p_k) W[p − p_k].
    pub(super) fn dissipated_power(&mut self, pressure: &Footprint) -> f64 {
        let mut sum = 0.0;
        for term in 0..self.retarded.len() {
            self.place(pressure, 1.0);
            for (source, value) in self.source.iter_mut().zip(&self.retarded[term]) {
                *source -= value;
            }
            let CreepingTerm { compliance, time } = self.substrate.terms[term];
            sum += compliance / time * self.work_of_source();
        }
        sum
    }

    /// ∫ source W[source].
    fn work_of_source(&mut self) -> f64 {
        self.operator.displacement(&self.source, &mut self.displacement);
        let work: f64 = self.source.iter().zip(&self.displacement).map(|(p, u)| p * u).sum();
        work * self.window.cell * self.window.cell
    }
}
