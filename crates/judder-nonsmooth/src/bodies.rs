//! The bodies as a step moves them.
//!
//! Every scheme here goes v⁺ = v + A⁻¹ (−h (C v + K (z + h θ v) − f) + Hᵀ P) with A = M + h θ C + h² θ² K: θ from ½ to 1 is the implicit scheme,
//! θ = 0 central differences, whose velocities lie between the steps. Where the damping leaves the modes of all bodies together free
//! of each other, z are these modes, and a step costs a pass over them; else z are the freedoms, and a step a solution with A.
//!
//! Modes above a cut-off only yield, λ z⁺ = f + Hᵀ P/h, so that they do not bound an explicit step: the residual flexibility of the beams' marches.

mod free_modes;
mod modal;
mod whole;

use crate::NonsmoothError;
use judder_assembly::assembly::Assembly;
use judder_assembly::row::Row;
use modal::ModalBodies;
use whole::WholeBodies;

pub use free_modes::FreeModes;

/// How long a step is, and how implicit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StepRule {
    /// h in s.
    pub step: f64,
    /// θ.
    pub implicitness: f64,
    /// Modes from this angular frequency on only yield, in rad/s; of explicit steps, infinite where all move.
    pub cut_off: f64,
}

/// MovingBodies with rows that are watched and pushed.
#[derive(Debug, Clone)]
pub struct MovingBodies {
    kind: BodyCoordinates,
}

#[derive(Debug, Clone)]
enum BodyCoordinates {
    Modal(Box<ModalBodies>),
    Whole(Box<WholeBodies>),
}

/// The energy of bodies in J.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct BodyEnergy {
    /// ½ vᵀ M v.
    pub kinetic: f64,
    /// ½ zᵀ K z − fᵀ z.
    pub potential: f64,
}

/// What a step took from the bodies, in J.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct BodyWork {
    /// −h v̄ᵀ C v, of the damping, with v̄ = θ v⁺ + (1 − θ) v, of explicit steps ½ (v + v⁺).
    pub damping: f64,
    /// Of the part of K that is not symmetric.
    pub circulation: f64,
    /// Of modes that only yield, which follow forces at once and do not swing on.
    pub flexibility: f64,
    /// Of an implicit step that is not of second order, −(θ − ½) (Δvᵀ M Δv + Δzᵀ K Δz) with Δz = h v̄.
    pub scheme: f64,
}

impl StepRule {
    /// The velocity that does work, as shares of those before and after.
    fn working(self) -> [f64; 2] {
        if self.implicitness == 0.0 { [0.5, 0.5] } else { [1.0 - self.implicitness, self.implicitness] }
    }
}

impl MovingBodies {
    /// The bodies of an assembly with these rows, for steps of one kind.
    ///
    /// # Errors
    /// [`NonsmoothError::NoMass`] for an explicit step, and of matrices that cannot be factored; [`NonsmoothError::CutOffNeedsModes`].
    pub fn new(assembly: &Assembly, rows: &[Row], rule: StepRule) -> Result<Self, NonsmoothError> {
        let kind = match ModalBodies::new(assembly, rows, rule) {
            Some(modal) => BodyCoordinates::Modal(Box::new(modal)),
            None if rule.cut_off.is_finite() => return Err(NonsmoothError::CutOffNeedsModes),
            None => BodyCoordinates::Whole(Box::new(WholeBodies::new(assembly, rows, rule)?)),
        };
        Ok(Self { kind })
    }

    #[cfg(test)]
    pub(crate) fn set_arch(&mut self, arch: pulp::Arch) {
        if let BodyCoordinates::Modal(own) = &mut self.kind {
            own.set_arch(arch);
        }
    }

    /// Whether the modes of all bodies together are its coordinates.
    #[must_use]
    pub fn are_modal(&self) -> bool {
        matches!(self.kind, BodyCoordinates::Modal(_))
    }

    /// Numbers of a state: coordinates, and what fills them up to whole vectors.
    #[must_use]
    pub fn size(&self) -> usize {
        match &self.kind {
            BodyCoordinates::Modal(own) => own.size(),
            BodyCoordinates::Whole(own) => own.size(),
        }
    }

    /// The coordinates of displacements, or velocities, of the freedoms.
    #[must_use]
    pub fn coordinates(&self, freedoms: &[f64]) -> Vec<f64> {
        match &self.kind {
            BodyCoordinates::Modal(own) => own.coordinates(freedoms),
            BodyCoordinates::Whole(_) => freedoms.to_vec(),
        }
    }

    /// The coordinates of forces at the freedoms.
    #[must_use]
    pub fn forces(&self, freedoms: &[f64]) -> Vec<f64> {
        match &self.kind {
            BodyCoordinates::Modal(own) => own.forces(freedoms),
            BodyCoordinates::Whole(_) => freedoms.to_vec(),
        }
    }

    /// Displacements of the freedoms.
    #[must_use]
    pub fn freedoms(&self, coordinates: &[f64]) -> Vec<f64> {
        match &self.kind {
            BodyCoordinates::Modal(own) => own.freedoms(coordinates),
            BodyCoordinates::Whole(_) => coordinates.to_vec(),
        }
    }

    /// The velocities that a step without contact ends with; `load` is f on the coordinates.
    pub fn free(&mut self, z: &[f64], v: &[f64], load: &[f64], out: &mut [f64]) {
        match &mut self.kind {
            BodyCoordinates::Modal(own) => own.free(z, v, load, out),
            BodyCoordinates::Whole(own) => own.free(z, v, load, out),
        }
    }

    /// r z of the rows from `first` on, of every so many one, as far as there is room.
    pub fn seen(&self, z: &[f64], first: usize, every: usize, out: &mut [f64]) {
        match &self.kind {
            BodyCoordinates::Modal(own) => own.seen(z, first, every, out),
            BodyCoordinates::Whole(own) => own.seen(z, first, every, out),
        }
    }

    /// v += A⁻¹ Hᵀ P, with P on the first rows.
    pub fn push(&mut self, impulses: &[f64], v: &mut [f64]) {
        match &mut self.kind {
            BodyCoordinates::Modal(own) => own.push(impulses, v),
            BodyCoordinates::Whole(own) => own.push(impulses, v),
        }
    }

    /// Kinetic and potential energy; of central differences, whose velocity lies half a step back, the potential between the two
    /// places, ½ z₀ᵀ K z₁.
    #[must_use]
    pub fn energy(&self, z: &[f64], v: &[f64], load: &[f64]) -> BodyEnergy {
        match &self.kind {
            BodyCoordinates::Modal(own) => own.energy(z, v, load),
            BodyCoordinates::Whole(own) => own.energy(z, v, load),
        }
    }

    /// What damping, circulation and the step itself took in a step from `before` to `after`, velocities both, that began at z.
    #[must_use]
    pub fn work(&self, z: &[f64], before: &[f64], after: &[f64]) -> BodyWork {
        match &self.kind {
            BodyCoordinates::Modal(own) => own.work(before, after),
            BodyCoordinates::Whole(own) => own.work(z, before, after),
        }
    }

    /// The largest angular frequency in rad/s, and the largest damping rate of a mode in 1/s; of whole bodies as a power iteration estimates them, with a margin.
    #[must_use]
    pub fn fastest(&self) -> [f64; 2] {
        match &self.kind {
            BodyCoordinates::Modal(own) => own.fastest(),
            BodyCoordinates::Whole(own) => own.fastest(),
        }
    }

    /// H A⁻¹ Hᵀ of the first rows, column after column.
    #[must_use]
    pub fn compliance(&mut self, rows: usize) -> Vec<f64> {
        let (mut pushed, mut seen) = (vec![0.0; self.size()], vec![0.0; rows]);
        let mut all = Vec::with_capacity(rows * rows);
        let mut impulse = vec![0.0; rows];
        for column in 0..rows {
            pushed.fill(0.0);
            impulse[column] = 1.0;
            self.push(&impulse, &mut pushed);
            impulse[column] = 0.0;
            self.seen(&pushed, 0, 1, &mut seen);
            all.extend_from_slice(&seen);
        }
        all
    }
}
