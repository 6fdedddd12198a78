//! MovingBodies as all their freedoms.

use super::{BodyEnergy, BodyWork, StepRule};
use crate::NonsmoothError;
use judder_assembly::assembly::{Assembly, from_triplets, is_symmetric, sum, symmetric_part, triplets};
use judder_assembly::row::Row;
use judder_structure::StructureError;
use judder_structure::assembly::Sparse;
use judder_structure::factor::SymmetricFactor;
use judder_structure::statics::{GeneralStatics, product};
use std::sync::Arc;

/// M, C with gyroscopic forces, and K, with the factor of A.
#[derive(Debug, Clone)]
pub(super) struct WholeBodies {
    rule: StepRule,
    mass: Arc<Sparse>,
    damping: Sparse,
    stiffness: Arc<Sparse>,
    /// Whether K brings circulation.
    circulates: bool,
    /// ½ (K + Kᵀ), which holds energy.
    elastic: Arc<Sparse>,
    factor: Arc<StepFactor>,
    rows: Vec<Row>,
    right: Vec<f64>,
}

#[derive(Debug)]
enum StepFactor {
    Symmetric(SymmetricFactor),
    General(Box<GeneralStatics>),
}

impl WholeBodies {
    pub(super) fn new(assembly: &Assembly, rows: &[Row], rule: StepRule) -> Result<Self, NonsmoothError> {
        let damping = sum(&assembly.damping, assembly.gyroscopic.iter().map(|own| own.matrix.as_ref()))?;
        let share = rule.step * rule.implicitness;
        let scaled = |matrix: &Sparse, factor: f64| {
            let entries: Vec<_> = triplets(matrix)
                .map(|mut entry| {
                    entry.val *= factor;
                    entry
                })
                .collect();
            from_triplets(matrix.nrows(), matrix.ncols(), &entries)
        };
        let held = sum(
            &assembly.mass,
            [scaled(&damping, share)?, scaled(&assembly.stiffness, share * share)?].iter(),
        )?;
        let factor = match is_symmetric(&held) {
            true => {
                let is_explicit = rule.implicitness == 0.0;
                let factor = SymmetricFactor::new(&held).map_err(|error| match error {
                    StructureError::Singular { .. } if is_explicit => NonsmoothError::NoMass,
                    _ => error.into(),
                })?;
                // an explicit step divides by the mass
                if is_explicit && factor.negative_eigenvalues() > 0 {
                    return Err(NonsmoothError::NoMass);
                }
                StepFactor::Symmetric(factor)
            }
            false => StepFactor::General(Box::new(GeneralStatics::new(&held)?)),
        };
        let circulates = !is_symmetric(&assembly.stiffness);
        let elastic = match circulates {
            true => Arc::new(symmetric_part(&assembly.stiffness)?),
            false => Arc::clone(&assembly.stiffness),
        };
        Ok(Self {
            rule,
            elastic,
            mass: Arc::clone(&assembly.mass),
            damping,
            stiffness: Arc::clone(&assembly.stiffness),
            circulates,
            factor: Arc::new(factor),
            rows: rows.to_vec(),
            right: vec![0.0; assembly.size()],
        })
    }

    pub(super) fn size(&self) -> usize {
        self.mass.nrows()
    }

    fn solve_right(&mut self) {
        match self.factor.as_ref() {
            StepFactor::Symmetric(factor) => factor.solve(&mut self.right),
            StepFactor::General(factor) => factor.solve(&mut self.right),
        }
    }

    pub(super) fn free(&mut self, z: &[f64], v: &[f64], load: &[f64], out: &mut [f64]) {
        let StepRule { step, implicitness, .. } = self.rule;
        self.right.copy_from_slice(load);
        add_product(&self.damping, -1.0, v, &mut self.right);
        add_product(&self.stiffness, -1.0, z, &mut self.right);
        if implicitness > 0.0 {
            add_product(&self.stiffness, -step * implicitness, v, &mut self.right);
        }
        self.solve_right();
        for (k, out) in out.iter_mut().enumerate() {
            *out = v[k] + step * self.right[k];
        }
    }

    pub(super) fn seen(&self, z: &[f64], first: usize, every: usize, out: &mut [f64]) {
        self.rows.iter().skip(first).step_by(every).zip(out).for_each(|(row, out)| *out = row.of(z));
    }

    pub(super) fn push(&mut self, impulses: &[f64], v: &mut [f64]) {
        self.right.fill(0.0);
        for (row, impulse) in self.rows.iter().zip(impulses).filter(|(_, impulse)| **impulse != 0.0) {
            row.add_to(*impulse, &mut self.right);
        }
        self.solve_right();
        v.iter_mut().zip(&self.right).for_each(|(v, push)| *v += push);
    }

    pub(super) fn energy(&self, z: &[f64], v: &[f64], load: &[f64]) -> BodyEnergy {
        let back = if self.rule.implicitness == 0.0 { self.rule.step } else { 0.0 };
        let (momentum, elastic) = (product(&self.mass, v), product(&self.elastic, z));
        let mut energy = BodyEnergy::default();
        for k in 0..z.len() {
            energy.kinetic += 0.5 * v[k] * momentum[k];
            energy.potential +=
                0.5 * elastic[k] * (z[k] - back * v[k]) - load[k] * (z[k] - 0.5 * back * v[k]);
        }
        energy
    }

    pub(super) fn work(&self, z: &[f64], before: &[f64], after: &[f64]) -> BodyWork {
        let StepRule { step, implicitness, .. } = self.rule;
        let [first, second] = self.rule.working();
        let mean = |k: usize| first * before[k] + second * after[k];
        let damped: Vec<f64> =
            (0..z.len()).map(|k| before[k] + implicitness * (after[k] - before[k])).collect();
        let forces = product(&self.damping, &damped);
        let damping = -step * (0..z.len()).map(|k| mean(k) * forces[k]).sum::<f64>();
        let circulation = if self.circulates { self.circulation(z, before, after) } else { 0.0 };
        let scheme = if implicitness > 0.5 { self.held_back(before, after) } else { 0.0 };
        BodyWork { damping, circulation, flexibility: 0.0, scheme }
    }

    /// −(θ − ½) (Δvᵀ M Δv + Δzᵀ ½ (K + Kᵀ) Δz).
    fn held_back(&self, before: &[f64], after: &[f64]) -> f64 {
        let (step, [first, second]) = (self.rule.step, self.rule.working());
        let both = || before.iter().zip(after);
        let faster: Vec<f64> = both().map(|(before, after)| after - before).collect();
        let moved: Vec<f64> =
            both().map(|(before, after)| step * (first * before + second * after)).collect();
        let square = |matrix: &Sparse, x: &[f64]| -> f64 {
            product(matrix, x).iter().zip(x).map(|(force, x)| force * x).sum()
        };
        -(second - 0.5) * (square(&self.mass, &faster) + square(&self.elastic, &moved))
    }

    /// −h v̄ᵀ ½ (K − Kᵀ) z, of which z where the forces are taken has no more: it lies off along v̄.
    fn circulation(&self, z: &[f64], before: &[f64], after: &[f64]) -> f64 {
        let (step, [first, second]) = (self.rule.step, self.rule.working());
        let mean: Vec<f64> = before.iter().zip(after).map(|(a, b)| first * a + second * b).collect();
        let taken: f64 = triplets(&self.stiffness)
            .map(|entry| entry.val * (mean[entry.row] * z[entry.col] - mean[entry.col] * z[entry.row]))
            .sum();
        -0.5 * step * taken
    }

    pub(super) fn fastest(&self) -> [f64; 2] {
        /// What a power iteration may be short of the largest.
        const SHORT: f64 = 1.1;
        const ROUNDS: usize = 60;
        let StepFactor::Symmetric(factor) = self.factor.as_ref() else { return [f64::INFINITY, 0.0] };
        if self.rule.implicitness != 0.0 {
            return [0.0, 0.0];
        }
        let largest = |matrix: &Sparse| {
            let mut x: Vec<f64> = (0..self.size()).map(|k| 1.0 + libm::sin(0.7 * k as f64)).collect();
            let mut size = 0.0;
            for _ in 0..ROUNDS {
                let mut next = product(matrix, &x);
                factor.solve(&mut next);
                size = next.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
                if size == 0.0 {
                    return 0.0;
                }
                x = next.iter().map(|value| value / size).collect();
            }
            size
        };
        [(SHORT * largest(&self.elastic)).sqrt(), SHORT * largest(&self.damping)]
    }
}

/// y += f A x.
fn add_product(matrix: &Sparse, factor: f64, x: &[f64], y: &mut [f64]) {
    for (column, value) in x.iter().enumerate().filter(|(_, value)| **value != 0.0) {
        for (row, entry) in matrix.row_idx_of_col(column).zip(matrix.val_of_col(column)) {
            y[row] += factor * value * entry;
        }
    }
}
