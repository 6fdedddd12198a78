//! A semismooth Newton method for the contact of many points.
//!
//! The roots of the projections of Alart and Curnier (*A mixed formulation for frictional contact problems prone to Newton like solution
//! methods*, Comput. Methods Appl. Mech. Engrg. 92, 1991), P_N − max(0, P_N − ρ (U_N + s P_N + u)) and P_T minus P_T − ρ U_T projected on the disc
//! of radius μ P_N, with steps that are halved until their size falls. Impulses of open points follow at once and are not among the unknowns; slopes that are those of
//! the step before are not eliminated anew.

use crate::contact_problem::{
    ContactProgress, ContactSolution, Delassus, FrictionNow, ImpulseProblem, NormalCondition, length,
};
use crate::elimination::KeptElimination;
use crate::gauss_seidel::name_motions;
use serde::{Deserialize, Serialize};

/// Steps at most: a start that is near takes three to six.
const STEPS: usize = 30;
/// Halvings of a step.
const HALVINGS: usize = 12;
/// A hold on the impulses of a singular system, beside slopes of the order of one.
const HOLD: f64 = 1e-8;

/// The projections at a place, their slopes by impulse and by velocity row by row.
#[derive(Debug, Clone)]
struct Projections {
    value: Vec<f64>,
    slopes: Slopes,
}

/// ∂/∂P and ∂/∂U of each component within its point, rows of three.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Slopes {
    by_impulse: Vec<[f64; 3]>,
    by_velocity: Vec<[f64; 3]>,
}

/// What Newton's method keeps from one problem to the next.
#[derive(Debug, Clone)]
pub(crate) struct NewtonMemory {
    here: Projections,
    there: Projections,
    impulse: Vec<f64>,
    velocity: Vec<f64>,
    change: Vec<f64>,
    right: Vec<f64>,
    /// Components whose impulses are unknowns.
    unknowns: Vec<usize>,
    elimination: KeptElimination,
    /// The slopes that are eliminated,
    eliminated: Slopes,
    /// where they could be.
    is_eliminated: bool,
}

impl Slopes {
    fn new(size: usize) -> Self {
        Self { by_impulse: vec![[0.0; 3]; size], by_velocity: vec![[0.0; 3]; size] }
    }

    /// Whether an impulse does not hang on velocities or other impulses.
    fn is_known(&self, row: usize, within: usize) -> bool {
        let mut alone = [0.0; 3];
        alone[within] = 1.0;
        self.by_velocity[row] == [0.0; 3] && self.by_impulse[row] == alone
    }

    /// Whether they are those of so many components.
    pub(crate) fn are_of(&self, size: usize) -> bool {
        self.by_impulse.len() == size && self.by_velocity.len() == size
    }

    fn copy_from(&mut self, other: &Self) {
        self.by_impulse.copy_from_slice(&other.by_impulse);
        self.by_velocity.copy_from_slice(&other.by_velocity);
    }
}

impl NewtonMemory {
    pub(crate) fn new(delassus: &Delassus) -> Self {
        let size = delassus.size();
        let numbers = vec![0.0; size];
        let linearised = Projections { value: numbers.clone(), slopes: Slopes::new(size) };
        Self {
            here: linearised.clone(),
            there: linearised,
            impulse: numbers.clone(),
            velocity: numbers.clone(),
            change: numbers.clone(),
            right: numbers,
            unknowns: Vec::with_capacity(size),
            elimination: KeptElimination::new(delassus.arch(), size),
            eliminated: Slopes::new(size),
            is_eliminated: false,
        }
    }

    /// Forgets what was eliminated.
    pub(crate) fn forget(&mut self) {
        self.is_eliminated = false;
    }

    /// The slopes that are eliminated: all that goes on from one problem to the next.
    pub(crate) fn eliminated(&self) -> Option<&Slopes> {
        self.is_eliminated.then_some(&self.eliminated)
    }

    /// Eliminates these slopes, as they were.
    pub(crate) fn recall(&mut self, delassus: &Delassus, slopes: &Slopes) {
        self.here.slopes.copy_from(slopes);
        self.eliminated.copy_from(slopes);
        self.is_eliminated = self.eliminate(delassus);
    }

    /// Eliminates the slopes at a place; whether that succeeds. Points that share their freedoms leave it open who of them carries what: where it is singular
    /// every impulse holds on a little to what it was.
    fn eliminate(&mut self, delassus: &Delassus) -> bool {
        self.eliminate_held(delassus, 0.0) || self.eliminate_held(delassus, HOLD)
    }

    fn eliminate_held(&mut self, delassus: &Delassus, hold: f64) -> bool {
        let dimension = delassus.dimension();
        let slopes = &self.here.slopes;
        self.unknowns.clear();
        let rows = 0..delassus.size();
        self.unknowns.extend(rows.filter(|row| !slopes.is_known(*row, row % dimension)));
        let columns = self.elimination.columns(self.unknowns.len());
        for (component, column) in self.unknowns.iter().zip(columns) {
            let of_velocity = delassus.column(*component);
            for (row, entry) in self.unknowns.iter().zip(column) {
                let first = row - row % dimension;
                let own = &slopes.by_velocity[*row];
                *entry = (0..dimension).map(|k| own[k] * of_velocity[first + k]).sum();
                if (first..first + dimension).contains(component) {
                    *entry += slopes.by_impulse[*row][component - first];
                }
                if row == component {
                    *entry += hold;
                }
            }
        }
        self.elimination.eliminate()
    }

    /// The step of Newton's method at a place, into `change`; whether there is one.
    fn step(&mut self, problem: &ImpulseProblem<'_>) -> bool {
        if !(self.is_eliminated && self.eliminated == self.here.slopes) {
            self.is_eliminated = self.eliminate(problem.delassus);
            self.eliminated.copy_from(&self.here.slopes);
        }
        if !self.is_eliminated {
            return false;
        }
        let dimension = problem.delassus.dimension();
        // what is known moves the velocities of the unknowns
        self.change.iter_mut().zip(&self.here.value).for_each(|(change, value)| *change = -value);
        self.unknowns.iter().for_each(|row| self.change[*row] = 0.0);
        self.right.fill(0.0);
        problem.delassus.add_velocities(&self.change, &mut self.right);
        for (place, row) in self.unknowns.iter().enumerate() {
            let first = row - row % dimension;
            let Slopes { by_impulse, by_velocity } = &self.here.slopes;
            let moved: f64 = (0..dimension)
                .map(|k| {
                    by_velocity[*row][k] * self.right[first + k]
                        + by_impulse[*row][k] * self.change[first + k]
                })
                .sum();
            self.impulse[place] = -self.here.value[*row] - moved;
        }
        let count = self.unknowns.len();
        self.elimination.solve(&mut self.impulse[..count]);
        self.unknowns.iter().zip(&self.impulse).for_each(|(row, own)| self.change[*row] = *own);
        true
    }

    /// Where so much of a step leads to; the size of the projections there.
    fn look(&mut self, problem: &ImpulseProblem<'_>, impulse: &[f64], share: f64) -> f64 {
        for ((there, here), change) in self.impulse.iter_mut().zip(impulse).zip(&self.change) {
            *there = here + share * change;
        }
        problem.delassus.velocities(problem.free, &self.impulse, &mut self.velocity);
        self.there.take(problem, &self.impulse, &self.velocity);
        norm(&self.there.value)
    }

    fn go_there(&mut self, solution: &mut ContactSolution) {
        std::mem::swap(&mut self.here, &mut self.there);
        solution.impulse.copy_from_slice(&self.impulse);
        solution.velocity.copy_from_slice(&self.velocity);
    }
}

/// Improves a solution; where no step helps it is left as it was best.
pub fn newton(
    problem: &ImpulseProblem<'_>,
    tolerance: f64,
    solution: &mut ContactSolution,
) -> ContactProgress {
    let mut memory = solution.take_memory(problem.delassus);
    problem.delassus.velocities(problem.free, &solution.impulse, &mut solution.velocity);
    let mut progress = problem.residual(solution);
    memory.here.take(problem, &solution.impulse, &solution.velocity);
    for step in 1..=STEPS {
        if progress.residual <= tolerance || !memory.step(problem) {
            break;
        }
        let before = norm(&memory.here.value);
        let shares = std::iter::successors(Some(1.0), |share| Some(0.5 * share)).take(HALVINGS);
        if !shares.into_iter().any(|share| memory.look(problem, &solution.impulse, share) < before) {
            break;
        }
        memory.go_there(solution);
        progress = ContactProgress { iterations: step, ..problem.residual(solution) };
    }
    solution.memory = Some(memory);
    name_motions(problem, solution);
    progress
}

/// The solution by one step with the slopes of the problem before, where these are those of its start and the step ends there; its start are velocities
/// that follow from the impulses.
pub(crate) fn same_as_before(
    problem: &ImpulseProblem<'_>,
    tolerance: f64,
    solution: &mut ContactSolution,
) -> Option<ContactProgress> {
    let mut memory = solution.memory.take()?;
    let mut found = None;
    if memory.is_eliminated {
        memory.here.take(problem, &solution.impulse, &solution.velocity);
        if memory.here.slopes == memory.eliminated && memory.step(problem) {
            memory.look(problem, &solution.impulse, 1.0);
            let residual = problem.residual_at(&memory.impulse, &memory.velocity);
            if residual.residual <= tolerance {
                memory.go_there(solution);
                found = Some(ContactProgress { iterations: 1, ..residual });
            }
        }
    }
    solution.memory = Some(memory);
    if found.is_some() {
        name_motions(problem, solution);
    }
    found
}

fn norm(values: &[f64]) -> f64 {
    values.iter().map(|value| value * value).sum::<f64>().sqrt()
}

impl Projections {
    fn take(&mut self, problem: &ImpulseProblem<'_>, impulse: &[f64], velocity: &[f64]) {
        let dimension = problem.delassus.dimension();
        for point in 0..problem.delassus.points() {
            let own = [impulse, velocity].map(|values| problem.of_point(values, point));
            let [value, by_impulse, by_velocity] = &projections(problem, point, own);
            for k in 0..dimension {
                let row = point * dimension + k;
                self.value[row] = value[k][0];
                self.slopes.by_impulse[row] = by_impulse[k];
                self.slopes.by_velocity[row] = by_velocity[k];
            }
        }
    }
}

/// The projections of a point, in the first place of each row, and their slopes by impulse and velocity.
fn projections(problem: &ImpulseProblem<'_>, point: usize, [p, u]: [[f64; 3]; 2]) -> [[[f64; 3]; 3]; 3] {
    let block = problem.delassus.block(point);
    let (mut value, mut by_p, mut by_u) = ([[0.0; 3]; 3], [[0.0; 3]; 3], [[0.0; 3]; 3]);
    let open = |value: &mut f64, slope: &mut f64, impulse: f64| (*value, *slope) = (impulse, 1.0);
    match problem.normal[point] {
        NormalCondition::Open => open(&mut value[0][0], &mut by_p[0][0], p[0]),
        NormalCondition::Given { impulse } => open(&mut value[0][0], &mut by_p[0][0], p[0] - impulse),
        NormalCondition::Bilateral { velocity, softness } => {
            let scale = 1.0 / (block.normal() + softness);
            value[0][0] = scale * (u[0] + softness * p[0] + velocity);
            (by_p[0][0], by_u[0][0]) = (scale * softness, scale);
        }
        NormalCondition::Unilateral { velocity, softness } => {
            let scale = 1.0 / (block.normal() + softness);
            let gap = u[0] + softness * p[0] + velocity;
            if p[0] - scale * gap > 0.0 {
                (value[0][0], by_p[0][0], by_u[0][0]) = (scale * gap, scale * softness, scale);
            } else {
                open(&mut value[0][0], &mut by_p[0][0], p[0]);
            }
        }
    }
    let (at_rest, now) = match problem.friction_at(point, u) {
        FrictionNow::Coulomb { at_rest, now } => (at_rest, now),
        FrictionNow::Sliding { coefficient } => {
            value[1][0] = p[1] - coefficient * p[0].max(0.0);
            value[2][0] = p[2];
            (by_p[1][1], by_p[2][2]) = (1.0, 1.0);
            by_p[1][0] = if p[0] > 0.0 { -coefficient } else { 0.0 };
            return [value, by_p, by_u];
        }
    };
    let scale = 1.0 / block.tangential();
    let tried = [1, 2].map(|k| p[k] - scale * u[k]);
    let size = length(tried);
    let coefficient = if size <= at_rest * p[0] { at_rest } else { now };
    let bound = coefficient * p[0].max(0.0);
    for k in 1..3 {
        if size <= bound {
            (value[k][0], by_u[k][k]) = (scale * u[k], scale);
            continue;
        }
        let direction = [tried[0] / size, tried[1] / size];
        value[k][0] = p[k] - bound * direction[k - 1];
        by_p[k][k] = 1.0;
        if p[0] > 0.0 {
            by_p[k][0] = -coefficient * direction[k - 1];
        }
        for j in 1..3 {
            let along = if j == k { 1.0 } else { 0.0 } - direction[k - 1] * direction[j - 1];
            by_p[k][j] -= bound / size * along;
            by_u[k][j] = bound / size * along * scale;
        }
    }
    [value, by_p, by_u]
}
