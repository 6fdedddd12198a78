//! How the contact points yield to harmonic forces.
//!
//! With forces Pᵀ λ + f at s, D(s) x = Pᵀ λ + f, D = s² M + s (C + 2 σ M) + K, and the motions y = R(s) x: gaps along the normals, slip
//! velocities s t·x − c·x along the contact, c where the track's material passes. A balance of harmonics needs bodies only through
//! Γ = R D⁻¹ Pᵀ on the contact points. σ in 1/s is a growth that is taken off all motions alike: the extended periodic motions of M. Krack,
//! *Nonlinear modal analysis of nonconservative systems*, Comput. Struct. 154 (2015).

mod at_harmonic;
mod body_step;
mod state_rates;

use crate::CyclesError;
use faer::{Mat, c64};
use judder_assembly::assembly::{Assembly, sum};
use judder_assembly::row::Row;
use judder_dense::general::solve;
use judder_dense::product::product;
use judder_nonsmooth::bodies::FreeModes;
use judder_nonsmooth::contact::ContactPoints;
use judder_structure::assembly::Sparse;
use std::sync::Arc;

pub use at_harmonic::{AtHarmonic, HarmonicSlopes};
pub(crate) use body_step::BodyStep;

/// Freedoms up to which bodies are taken: some seconds of their modes, a dense system a harmonic where their damping joins these.
pub const MOST_FREEDOMS: usize = 1200;

/// Whether periodic motions of so large an assembly are computed.
///
/// # Errors
/// [`CyclesError::TooManyFreedoms`].
pub fn check_size(assembly: &Assembly) -> Result<(), CyclesError> {
    match assembly.size() {
        freedoms if freedoms > MOST_FREEDOMS => {
            Err(CyclesError::TooManyFreedoms { freedoms, most: MOST_FREEDOMS })
        }
        _ => Ok(()),
    }
}

/// Bodies as their contact points feel them.
#[derive(Debug, Clone)]
pub struct HarmonicBodies {
    /// What they were made of: an assembly of the same needs them no second time.
    made_of: MadeOf,
    /// Components of a point.
    dimension: usize,
    kind: Arc<HarmonicMatrices>,
    /// P on the coordinates, components × coordinates.
    rows: Mat<f64>,
    /// c of the components that have one.
    convected: Vec<(usize, Vec<f64>)>,
}

/// What bodies under contact points follow from.
#[derive(Debug, Clone)]
struct MadeOf {
    matrices: Vec<Arc<Sparse>>,
    rows: Vec<Row>,
    convected: Vec<(usize, Row)>,
}

impl MadeOf {
    fn new(assembly: &Assembly, contact: &ContactPoints<'_>) -> Self {
        let own = [&assembly.mass, &assembly.damping, &assembly.stiffness];
        let matrices =
            own.into_iter().chain(assembly.gyroscopic.iter().map(|own| &own.matrix)).map(Arc::clone);
        Self { matrices: matrices.collect(), rows: contact.rows.clone(), convected: contact.convected() }
    }

    fn is(&self, other: &Self) -> bool {
        let same = |(a, b): (&Arc<Sparse>, &Arc<Sparse>)| {
            Arc::ptr_eq(a, b)
                || (a.col_ptr() == b.col_ptr() && a.row_idx() == b.row_idx() && a.val() == b.val())
        };
        self.matrices.len() == other.matrices.len()
            && self.matrices.iter().zip(&other.matrices).all(same)
            && self.rows == other.rows
            && self.convected == other.convected
    }
}

#[derive(Debug, Clone)]
enum HarmonicMatrices {
    /// z̈ + d ż + λ z = f of each mode.
    Modes(Box<FreeModes>),
    /// M, C and K of all freedoms.
    Whole(Box<[Mat<f64>; 3]>),
}

/// Steady forces: (K + ε Σ cᵀ c) x = f + Pᵀ s over the normals, with which λ = s − ε c x on them.
///
/// So the mean is known of bodies that only their contact holds.
#[derive(Debug, Clone)]
pub struct StaticResponse {
    /// D⁻¹ f and D⁻¹ Pᵀ, on the coordinates.
    of_load: Vec<f64>,
    of_forces: Mat<f64>,
    /// y of f alone, and of each s.
    pub free: Vec<f64>,
    /// y of each s: components × components.
    pub receptance: Mat<f64>,
}

impl HarmonicBodies {
    /// The bodies of an assembly under its contact points.
    ///
    /// # Errors
    /// [`CyclesError::TooManyFreedoms`], and what the assembly's matrices say.
    pub fn new(assembly: &Assembly, contact: &ContactPoints<'_>) -> Result<Self, CyclesError> {
        check_size(assembly)?;
        let kind = match FreeModes::new(assembly) {
            Some(modes) => HarmonicMatrices::Modes(Box::new(modes)),
            None => HarmonicMatrices::Whole(Box::new(whole(assembly)?)),
        };
        let kind = Arc::new(kind);
        let mut bodies = Self {
            made_of: MadeOf::new(assembly, contact),
            dimension: contact.dimension,
            kind,
            rows: Mat::zeros(contact.rows.len(), assembly.size()),
            convected: Vec::new(),
        };
        for (component, row) in contact.rows.iter().enumerate() {
            for (mode, value) in bodies.on_coordinates(row).into_iter().enumerate() {
                bodies.rows[(component, mode)] = value;
            }
        }
        bodies.convected = contact
            .convected()
            .iter()
            .map(|(component, row)| (*component, bodies.on_coordinates(row)))
            .collect();
        Ok(bodies)
    }

    /// Whether the bodies of an assembly are these.
    #[must_use]
    pub fn are_of(&self, assembly: &Assembly, contact: &ContactPoints<'_>) -> bool {
        self.made_of.is(&MadeOf::new(assembly, contact))
    }

    /// Components of all points.
    #[must_use]
    pub fn components(&self) -> usize {
        self.rows.nrows()
    }

    /// A form on the freedoms as one on the coordinates.
    #[must_use]
    pub fn on_coordinates(&self, row: &Row) -> Vec<f64> {
        match self.kind.as_ref() {
            HarmonicMatrices::Modes(modes) => {
                let of = |mode: usize| {
                    row.entries().iter().map(|(k, share)| share * modes.shapes[(*k, mode)]).sum()
                };
                (0..modes.eigenvalues.len()).map(of).collect()
            }
            HarmonicMatrices::Whole(matrices) => {
                let mut own = vec![0.0; matrices[0].nrows()];
                row.add_to(1.0, &mut own);
                own
            }
        }
    }

    /// Forces at the freedoms on the coordinates.
    #[must_use]
    pub fn forces(&self, on_freedoms: &[f64]) -> Vec<f64> {
        match self.kind.as_ref() {
            HarmonicMatrices::Modes(modes) => {
                let of = |mode: usize| {
                    on_freedoms.iter().enumerate().map(|(k, f)| f * modes.shapes[(k, mode)]).sum()
                };
                (0..modes.eigenvalues.len()).map(of).collect()
            }
            HarmonicMatrices::Whole(_) => on_freedoms.to_vec(),
        }
    }

    /// Displacements of the freedoms.
    #[must_use]
    pub fn freedoms(&self, coordinates: &[f64]) -> Vec<f64> {
        match self.kind.as_ref() {
            HarmonicMatrices::Modes(modes) => {
                let of = |k: usize| {
                    coordinates.iter().enumerate().map(|(mode, z)| z * modes.shapes[(k, mode)]).sum()
                };
                (0..modes.shapes.nrows()).map(of).collect()
            }
            HarmonicMatrices::Whole(_) => coordinates.to_vec(),
        }
    }

    /// The coordinates of displacements of the freedoms.
    #[must_use]
    pub fn to_coordinates(&self, freedoms: &[f64]) -> Vec<f64> {
        match self.kind.as_ref() {
            HarmonicMatrices::Modes(modes) => {
                let of = |mode: usize| {
                    freedoms.iter().enumerate().map(|(k, q)| q * modes.weighted[(k, mode)]).sum()
                };
                (0..modes.eigenvalues.len()).map(of).collect()
            }
            HarmonicMatrices::Whole(_) => freedoms.to_vec(),
        }
    }

    /// Whether material of the track passes under a point.
    pub(crate) fn is_passed(&self) -> bool {
        !self.convected.is_empty()
    }

    /// c x of a component: none where nothing passes.
    pub(crate) fn carries(&self, component: usize, x: &[f64]) -> f64 {
        carried(&self.convected, component, x)
    }

    /// How often a component is differentiated: slip velocities once.
    fn is_velocity(&self, component: usize) -> bool {
        !component.is_multiple_of(self.dimension)
    }

    /// What damping and stiffness that is not symmetric give on average, in W, over a harmonic with x of the coordinates and their velocities.
    pub(crate) fn power(&self, x: &[c64], velocity: &[c64]) -> [f64; 2] {
        match self.kind.as_ref() {
            HarmonicMatrices::Modes(modes) => {
                let taken =
                    velocity.iter().zip(&modes.damping).map(|(own, damping)| damping * own.norm_sqr());
                [-0.5 * taken.sum::<f64>(), 0.0]
            }
            HarmonicMatrices::Whole(matrices) => {
                let [_, damping, stiffness] = &**matrices;
                let mut power = [0.0; 2];
                for (i, own) in velocity.iter().enumerate() {
                    for (j, (other, beside)) in velocity.iter().zip(x).enumerate() {
                        power[0] -= 0.5 * damping[(i, j)] * (own.conj() * other).re;
                        let skew = 0.5 * (stiffness[(i, j)] - stiffness[(j, i)]);
                        power[1] -= 0.5 * skew * (own.conj() * beside).re;
                    }
                }
                power
            }
        }
    }

    /// P x of a component.
    pub(crate) fn displaced(&self, component: usize, x: &[c64]) -> c64 {
        x.iter().enumerate().map(|(k, own)| own * self.rows[(component, k)]).sum()
    }

    /// y = R(s) x.
    fn seen_into(&self, s: c64, x: &[c64], y: &mut Vec<c64>) {
        y.clear();
        y.resize(self.components(), c64::ZERO);
        for (k, own) in x.iter().enumerate() {
            y.iter_mut().zip(self.rows.col_as_slice(k)).for_each(|(y, share)| *y += own * *share);
        }
        for (component, own) in y.iter_mut().enumerate() {
            if self.is_velocity(component) {
                *own *= s;
            }
        }
        for (component, row) in &self.convected {
            y[*component] -= row.iter().zip(x).map(|(share, own)| own * *share).sum::<c64>();
        }
    }

    /// P x of a component, of a real x.
    pub(crate) fn displaced_by(&self, component: usize, x: &[f64]) -> f64 {
        x.iter().enumerate().map(|(k, own)| own * self.rows[(component, k)]).sum()
    }

    /// M⁻¹ Pᵀ; nothing where a freedom has no mass.
    pub(crate) fn mobility(&self) -> Option<Mat<f64>> {
        let mut pushes = self.rows.transpose().to_owned();
        match self.kind.as_ref() {
            HarmonicMatrices::Modes(_) => Some(pushes),
            HarmonicMatrices::Whole(matrices) => {
                solve(matrices[0].clone(), &mut pushes)?;
                pushes.is_all_finite().then_some(pushes)
            }
        }
    }

    /// Steady forces on the bodies, with ε of each point, and the load on the freedoms.
    ///
    /// # Errors
    /// [`CyclesError::NotHeld`].
    pub fn statics(&self, load: &[f64], stiffness: &[f64]) -> Result<StaticResponse, CyclesError> {
        let (size, coordinates) = (self.rows.nrows(), self.rows.ncols());
        let mut matrix = match self.kind.as_ref() {
            HarmonicMatrices::Modes(modes) => {
                Mat::from_fn(coordinates, coordinates, |i, j| if i == j { modes.eigenvalues[i] } else { 0.0 })
            }
            HarmonicMatrices::Whole(matrices) => matrices[2].clone(),
        };
        let normals = stiffness.len();
        let held =
            Mat::from_fn(normals, coordinates, |p, k| stiffness[p] * self.rows[(p * self.dimension, k)]);
        let normal = Mat::from_fn(coordinates, normals, |k, p| self.rows[(p * self.dimension, k)]);
        matrix += product(normal.as_ref(), held.as_ref());
        let forces = self.forces(load);
        let mut right = Mat::from_fn(coordinates, size + 1, |k, column| match column {
            0 => forces[k],
            _ => self.rows[(column - 1, k)],
        });
        solve(matrix, &mut right).ok_or(CyclesError::NotHeld)?;
        let seen = |column: usize| {
            let x: Vec<c64> = (0..coordinates).map(|k| c64::new(right[(k, column)], 0.0)).collect();
            let mut y = Vec::new();
            self.seen_into(c64::ZERO, &x, &mut y);
            y.into_iter().map(|own| own.re).collect::<Vec<f64>>()
        };
        let columns: Vec<Vec<f64>> = (1..=size).map(seen).collect();
        Ok(StaticResponse {
            free: seen(0),
            receptance: Mat::from_fn(size, size, |i, j| columns[j][i]),
            of_load: (0..coordinates).map(|k| right[(k, 0)]).collect(),
            of_forces: right.subcols(1, size).to_owned(),
        })
    }
}

/// c x of a component that has one.
fn carried(convected: &[(usize, Vec<f64>)], component: usize, x: &[f64]) -> f64 {
    let own = convected.iter().find(|(other, _)| *other == component);
    own.map_or(0.0, |(_, row)| row.iter().zip(x).map(|(share, own)| share * own).sum())
}

impl StaticResponse {
    /// x of the coordinates.
    #[must_use]
    pub fn coordinates(&self, forces: &[f64]) -> Vec<f64> {
        let mut x = self.of_load.clone();
        for (column, force) in forces.iter().enumerate() {
            x.iter_mut().enumerate().for_each(|(k, own)| *own += force * self.of_forces[(k, column)]);
        }
        x
    }
}

/// M, C with gyroscopic forces, and K.
fn whole(assembly: &Assembly) -> Result<[Mat<f64>; 3], CyclesError> {
    let damping = sum(&assembly.damping, assembly.gyroscopic.iter().map(|own| own.matrix.as_ref()))?;
    Ok([assembly.mass.to_dense(), damping.to_dense(), assembly.stiffness.to_dense()])
}
