//! What one step asks of the contact.
//!
//! The velocities beside each other follow from impulses, U = b + W P, with components along the normal, along the slip and, in space,
//! across it. At every point
//!
//! - where it is unilateral, 0 ≤ P_N ⟂ U_N + s P_N + u ≥ 0, with s = 0 where it is rigid and u what the law of the normal asks for;
//! - |P_T| ≤ μ(0) P_N where U_T = 0, else P_T = −μ(|U_T|) P_N U_T/|U_T|.

use crate::newton::NewtonMemory;
use crate::one_point::PointDelassus;
use judder_assembly::friction::Friction;
use pulp::Arch;
use serde::{Deserialize, Serialize};

/// The most components of a point: along the normal, along the slip, across it.
pub(crate) const MOST: usize = 3;

/// What the normal of a point asks of a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum NormalCondition {
    /// It is open: no impulse.
    Open,
    /// 0 ≤ P_N ⟂ U_N + s P_N + u ≥ 0.
    Unilateral {
        /// u in m/s.
        velocity: f64,
        /// s in 1/kg.
        softness: f64,
    },
    /// U_N + s P_N + u = 0 whatever the impulse: a point that stays closed.
    Bilateral {
        /// u in m/s.
        velocity: f64,
        /// s in 1/kg.
        softness: f64,
    },
    /// The impulse is known.
    Given {
        /// P_N in N s.
        impulse: f64,
    },
}

/// The friction coefficient of a point in a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FrictionCondition<'a> {
    /// μ(|U_T|) of a law, times a factor.
    Law {
        /// The law.
        law: &'a Friction,
        /// What its coefficient is multiplied by.
        factor: f64,
    },
    /// A coefficient of its own at rest and at the speed that it has now.
    Now {
        /// μ at rest.
        at_rest: f64,
        /// μ now.
        now: f64,
    },
    /// The point slides along the slip of steady sliding whatever its velocity: T = μ N.
    Sliding {
        /// μ.
        coefficient: f64,
    },
}

/// The friction of a point at the velocity that it has.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum FrictionNow {
    /// Coulomb's, with μ at rest and at the speed.
    Coulomb { at_rest: f64, now: f64 },
    /// T = μ N along the slip of steady sliding.
    Sliding { coefficient: f64 },
}

impl FrictionCondition<'_> {
    /// μ at a speed.
    pub(crate) fn at(&self, speed: f64) -> f64 {
        match self {
            Self::Law { law, factor } => factor * law.at(speed).coefficient,
            Self::Now { now, .. } => *now,
            Self::Sliding { coefficient } => *coefficient,
        }
    }

    fn now(&self, speed: f64) -> FrictionNow {
        match self {
            Self::Law { law, factor } => FrictionNow::Coulomb {
                at_rest: factor * law.at(0.0).coefficient,
                now: factor * law.at(speed).coefficient,
            },
            Self::Now { at_rest, now } => FrictionNow::Coulomb { at_rest: *at_rest, now: *now },
            Self::Sliding { coefficient } => FrictionNow::Sliding { coefficient: *coefficient },
        }
    }
}

/// What a point does after a step.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum PointMotion {
    /// It carries no force.
    #[default]
    Open,
    /// It moves with the track.
    Stick,
    /// It slides.
    Slip,
}

/// W: how impulses at all points change the velocities there.
#[derive(Debug, Clone)]
pub struct Delassus {
    arch: Arch,
    /// Components of a point: two in the plane, three in space.
    dimension: usize,
    points: usize,
    /// Column after column, in 1/kg.
    entries: Vec<f64>,
    blocks: Vec<PointDelassus>,
}

impl Delassus {
    /// W of so many components a point, column after column, in 1/kg.
    #[must_use]
    pub fn new(dimension: usize, entries: Vec<f64>) -> Self {
        let size = entries.len().isqrt();
        let points = size / dimension.max(1);
        let blocks = (0..points).map(|point| block(&entries, dimension, point)).collect();
        Self { arch: Arch::new(), dimension, points, entries, blocks }
    }

    /// Takes other entries.
    pub(crate) fn set(&mut self, fill: impl FnOnce(&mut [f64])) {
        fill(&mut self.entries);
        for (point, own) in self.blocks.iter_mut().enumerate() {
            *own = block(&self.entries, self.dimension, point);
        }
    }

    /// Components of a point.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// Points.
    #[must_use]
    pub fn points(&self) -> usize {
        self.points
    }

    /// Components of all points.
    #[must_use]
    pub fn size(&self) -> usize {
        self.dimension * self.points
    }

    /// What a unit impulse at a component does to all.
    pub(crate) fn column(&self, component: usize) -> &[f64] {
        let size = self.size();
        &self.entries[component * size..(component + 1) * size]
    }

    /// That of one point by itself.
    pub(crate) fn block(&self, point: usize) -> &PointDelassus {
        &self.blocks[point]
    }

    /// A point that no impulse moves along its normal.
    #[must_use]
    pub fn held_point(&self) -> Option<usize> {
        self.blocks.iter().position(|block| !block.yields())
    }

    /// Vectors of this width.
    pub(crate) fn arch(&self) -> Arch {
        self.arch
    }

    #[cfg(test)]
    pub(crate) fn set_arch(&mut self, arch: Arch) {
        self.arch = arch;
    }

    /// U = b + W P.
    pub(crate) fn velocities(&self, free: &[f64], impulse: &[f64], out: &mut [f64]) {
        out.copy_from_slice(free);
        self.add_velocities(impulse, out);
    }

    /// U += W P.
    pub(crate) fn add_velocities(&self, impulse: &[f64], out: &mut [f64]) {
        for point in 0..self.points {
            let first = point * self.dimension;
            self.add_point(first, &impulse[first..first + self.dimension], out);
        }
    }

    /// U += W P of one point, whose first component this is.
    #[inline]
    pub(crate) fn add_point(&self, first: usize, change: &[f64], out: &mut [f64]) {
        if change.iter().all(|change| *change == 0.0) {
            return;
        }
        let size = self.size();
        let columns = &self.entries[first * size..(first + change.len()) * size];
        let out = &mut out[..size];
        self.arch.dispatch(
            #[inline(always)]
            || {
                let (a, rest) = columns.split_at(size);
                let (b, c) = rest.split_at(size);
                match *change {
                    [x, y, z] => {
                        let c = &c[..size];
                        for k in 0..size {
                            out[k] += x * a[k] + y * b[k] + z * c[k];
                        }
                    }
                    [x, y] => {
                        for k in 0..size {
                            out[k] += x * a[k] + y * b[k];
                        }
                    }
                    _ => {}
                }
            },
        );
    }
}

/// The entries of one point among those of all.
fn block(entries: &[f64], dimension: usize, point: usize) -> PointDelassus {
    let size = entries.len().isqrt();
    let mut own = [[0.0; MOST]; MOST];
    for (i, row) in own.iter_mut().enumerate().take(dimension) {
        for (j, entry) in row.iter_mut().enumerate().take(dimension) {
            *entry = entries[(point * dimension + j) * size + point * dimension + i];
        }
    }
    PointDelassus::new(own)
}

/// |a|: exact for a vector along an axis, as in the plane all are.
#[inline]
#[must_use]
pub fn length([a, b]: [f64; 2]) -> f64 {
    if b == 0.0 { a.abs() } else { (a * a + b * b).sqrt() }
}

/// a += f b.
#[inline]
pub(crate) fn add(a: &mut [f64], factor: f64, b: &[f64]) {
    a.iter_mut().zip(b).for_each(|(a, b)| *a += factor * b);
}

/// The contact of one step.
#[derive(Debug, Clone, Copy)]
pub struct ImpulseProblem<'a> {
    /// W.
    pub delassus: &'a Delassus,
    /// b in m/s.
    pub free: &'a [f64],
    /// Of each point.
    pub normal: &'a [NormalCondition],
    /// Of each point.
    pub friction: &'a [FrictionCondition<'a>],
    /// An impulse in N s by which residuals are measured.
    pub scale: f64,
}

/// How far a solution has come.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ContactProgress {
    /// Sweeps over all points, or steps of Newton's method.
    pub iterations: usize,
    /// The largest residual of the complementarity of a point, as a share of the scale.
    pub residual: f64,
    /// The point that has it.
    pub point: usize,
}

/// Impulses and velocities of a step, kept from one to the next as its start.
#[derive(Debug, Clone)]
pub struct ContactSolution {
    /// P in N s.
    pub impulse: Vec<f64>,
    /// U in m/s.
    pub velocity: Vec<f64>,
    /// What each point does.
    pub motion: Vec<PointMotion>,
    /// Of Newton's method.
    pub(crate) memory: Option<Box<NewtonMemory>>,
}

impl ContactSolution {
    /// No impulses.
    #[must_use]
    pub fn none(delassus: &Delassus) -> Self {
        let size = delassus.size();
        Self {
            impulse: vec![0.0; size],
            velocity: vec![0.0; size],
            motion: vec![PointMotion::Open; delassus.points()],
            memory: Some(Box::new(NewtonMemory::new(delassus))),
        }
    }

    /// Forgets what was eliminated with another W.
    pub(crate) fn forget(&mut self) {
        if let Some(memory) = &mut self.memory {
            memory.forget();
        }
    }

    pub(crate) fn take_memory(&mut self, delassus: &Delassus) -> Box<NewtonMemory> {
        self.memory.take().unwrap_or_else(|| Box::new(NewtonMemory::new(delassus)))
    }
}

impl ImpulseProblem<'_> {
    /// The components of a point of a vector on all.
    pub(crate) fn of_point(&self, values: &[f64], point: usize) -> [f64; MOST] {
        match self.delassus.dimension() {
            2 => [values[2 * point], values[2 * point + 1], 0.0],
            _ => [values[3 * point], values[3 * point + 1], values[3 * point + 2]],
        }
    }

    /// Its friction at a velocity.
    pub(crate) fn friction_at(&self, point: usize, velocity: [f64; MOST]) -> FrictionNow {
        self.friction[point].now(length([velocity[1], velocity[2]]))
    }

    /// The largest residual of a point: by how much its impulses change when they are projected on what the contact allows,
    /// P_N − max(0, P_N − U_N/W_NN) and the same of the friction on its disc, as a share of the scale.
    #[must_use]
    pub fn residual(&self, solution: &ContactSolution) -> ContactProgress {
        self.residual_at(&solution.impulse, &solution.velocity)
    }

    pub(crate) fn residual_at(&self, impulse: &[f64], velocity: &[f64]) -> ContactProgress {
        let mut worst = ContactProgress::default();
        for point in 0..self.delassus.points() {
            let own = self.residual_of(point, [impulse, velocity]);
            if own > worst.residual || own.is_nan() {
                (worst.residual, worst.point) = (own, point);
            }
        }
        worst
    }

    fn residual_of(&self, point: usize, values: [&[f64]; 2]) -> f64 {
        let [impulse, velocity] = values.map(|values| self.of_point(values, point));
        let block = self.delassus.block(point);
        let normal = match self.normal[point] {
            NormalCondition::Open => 0.0,
            NormalCondition::Given { impulse } => impulse,
            NormalCondition::Bilateral { velocity: asked, softness } => {
                impulse[0] - (velocity[0] + softness * impulse[0] + asked) / (block.normal() + softness)
            }
            NormalCondition::Unilateral { velocity: asked, softness } => {
                let gap = velocity[0] + softness * impulse[0] + asked;
                (impulse[0] - gap / (block.normal() + softness)).max(0.0)
            }
        };
        let pressed = impulse[0].max(0.0);
        let allowed = match self.friction_at(point, velocity) {
            FrictionNow::Sliding { coefficient } => [coefficient * pressed, 0.0],
            FrictionNow::Coulomb { at_rest, now } => {
                let speed = length([velocity[1], velocity[2]]);
                let tried = [1, 2].map(|k| impulse[k] - velocity[k] / block.tangential());
                let size = length(tried);
                // on a falling law a point that sticks carries more than one that slides
                let moves = speed * self.scale.recip() > f64::EPSILON * block.tangential();
                let bound = pressed * if moves { now } else { at_rest };
                let factor = if size > bound { bound / size } else { 1.0 };
                tried.map(|own| factor * own)
            }
        };
        let off = [impulse[0] - normal, impulse[1] - allowed[0], impulse[2] - allowed[1]];
        length([off[0], length([off[1], off[2]])]) / self.scale
    }
}
