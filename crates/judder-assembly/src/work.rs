//! Why a mode of an assembly grows: the work of damping and of each interface.

use crate::AssemblyError;
use crate::error::check_length;
use crate::linearised::{ContactTerm, Linearised};
use faer::{Mat, c64};
use judder_dense::general::solve;
use judder_structure::assembly::Sparse;
use std::collections::BTreeMap;

/// What does work on a mode.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Worker {
    /// The damping of the structures.
    MaterialDamping,
    /// The unsymmetric part of the stiffness that the structures bring.
    Circulation,
    /// The forces that follow the velocities of a body that turns, by its place among those: they do no work, and say so.
    Gyroscopic(usize),
    /// A term of an interface, by its place in the assembly.
    Contact(usize, ContactTerm),
}

/// What of a growth rate each worker brings.
#[derive(Debug, Clone, PartialEq)]
pub struct GrowthShares {
    /// In 1/s, negative where energy is taken out: they sum to the growth rate.
    pub shares: Vec<(Worker, f64)>,
    /// What they lack of the growth rate, in 1/s: zero but for rounding and the error of the mode.
    pub balance: f64,
}

/// An energy below so much of its parts is none.
const NO_ENERGY: f64 = 1e-9;

/// The work of every term on a mode x e^(λt), λ = σ + iω, of all freedoms.
///
/// The power balance Re(λ̄ xᴴ(λ² M + λ C + K) x) = Re(λ̄ Σ δN xᴴ eᵀ), where δN are the force changes of rigid points, gives σ = Σ of
/// −|λ|² Re xᴴ C x/E for every damping, −ω Im xᴴ K x/E for every stiffness, ω Im(Σ δN xᴴ eᵀ)/E for rigid interfaces, with
/// E = |λ|² xᴴ M x + Re xᴴ K x − Re Σ δN xᴴ eᵀ: symmetric stiffness does no work, and skew G none either. Of a body that turns, seen from where it does not, a
/// wave that turns against it more slowly than the body has a negative E: what takes energy out makes it grow.
///
/// `None` where E is zero but for rounding, as of a divergence without damping: nothing does work on it.
///
/// # Errors
/// [`AssemblyError::Length`] for a shape on other freedoms, [`AssemblyError::Undetermined`] where the forces of rigid points do not follow from the motion.
pub fn growth_shares(
    about: &Linearised,
    value: c64,
    shape: &[c64],
) -> Result<Option<GrowthShares>, AssemblyError> {
    let [mass, damping, stiffness] = &about.structures;
    check_length("the freedoms of a shape", shape.len(), mass.ncols())?;
    let (size, omega) = (value.norm_sqr(), value.im);
    let form = |matrix: &Sparse| hermitian(matrix, shape);
    let mut energy = size * form(mass).re;
    let mut powers: BTreeMap<Worker, f64> = BTreeMap::new();
    *powers.entry(Worker::MaterialDamping).or_default() -= size * form(damping).re;
    let own = form(stiffness);
    energy += own.re;
    *powers.entry(Worker::Circulation).or_default() -= omega * own.im;
    for (body, gyroscopic) in about.gyroscopic.iter().enumerate() {
        powers.insert(Worker::Gyroscopic(body), -size * form(gyroscopic).re);
    }
    for contact in &about.contacts {
        let own = form(&contact.matrix);
        let power = if contact.term.is_stiffness() {
            energy += own.re;
            omega * own.im
        } else {
            size * own.re
        };
        *powers.entry(Worker::Contact(contact.interface, contact.term)).or_default() -= power;
    }
    for (held, force) in about.held.iter().zip(reactions(about, value, shape)?) {
        let work = force * held.equilibrium.of_complex(shape).conj();
        energy -= work.re;
        let worker = Worker::Contact(held.interface, ContactTerm::NormalTangentialCoupling);
        *powers.entry(worker).or_default() += omega * work.im;
    }
    let magnitude = size * form(mass).re.abs() + own.re.abs();
    if energy.abs() <= NO_ENERGY * magnitude {
        return Ok(None);
    }
    let shares: Vec<(Worker, f64)> =
        powers.into_iter().map(|(worker, power)| (worker, power / energy)).collect();
    let balance = value.re - shares.iter().map(|(_, growth)| growth).sum::<f64>();
    Ok(Some(GrowthShares { shares, balance }))
}

/// δN of the rigid points: the least squares of E δN = (λ² M + λ C + K) x, exact but for rounding.
fn reactions(about: &Linearised, value: c64, shape: &[c64]) -> Result<Vec<c64>, AssemblyError> {
    let held = &about.held;
    if held.is_empty() {
        return Ok(Vec::new());
    }
    let [mass, damping, stiffness] = &about.structures;
    let mut unbalanced = vec![c64::new(0.0, 0.0); shape.len()];
    add_product(mass, value * value, shape, &mut unbalanced);
    add_product(damping, value, shape, &mut unbalanced);
    add_product(stiffness, c64::new(1.0, 0.0), shape, &mut unbalanced);
    about.gyroscopic.iter().for_each(|own| add_product(own, value, shape, &mut unbalanced));
    for contact in &about.contacts {
        let factor = if contact.term.is_stiffness() { c64::new(1.0, 0.0) } else { value };
        add_product(&contact.matrix, factor, shape, &mut unbalanced);
    }
    let mut dense = vec![0.0; shape.len()];
    let mut gram = Mat::zeros(held.len(), held.len());
    for (j, of_column) in held.iter().enumerate() {
        of_column.equilibrium.add_to(1.0, &mut dense);
        for (i, of_row) in held.iter().enumerate() {
            gram[(i, j)] = of_row.equilibrium.of(&dense);
        }
        for (freedom, _) in of_column.equilibrium.entries() {
            dense[*freedom] = 0.0;
        }
    }
    let projected: Vec<c64> = held.iter().map(|point| point.equilibrium.of_complex(&unbalanced)).collect();
    let mut right =
        Mat::from_fn(held.len(), 2, |i, k| if k == 0 { projected[i].re } else { projected[i].im });
    solve(gram, &mut right).ok_or(AssemblyError::Undetermined { closed: held.len(), open: 0 })?;
    Ok((0..held.len()).map(|i| c64::new(right[(i, 0)], right[(i, 1)])).collect())
}

/// y += f A x.
fn add_product(matrix: &Sparse, factor: c64, x: &[c64], y: &mut [c64]) {
    for (column, x) in x.iter().enumerate() {
        let share = x * factor;
        for (row, value) in matrix.row_idx_of_col(column).zip(matrix.val_of_col(column)) {
            y[row] += share * *value;
        }
    }
}

/// xᴴ A x.
fn hermitian(matrix: &Sparse, x: &[c64]) -> c64 {
    let mut sum = c64::new(0.0, 0.0);
    for column in 0..matrix.ncols() {
        for (row, value) in matrix.row_idx_of_col(column).zip(matrix.val_of_col(column)) {
            sum += x[row].conj() * x[column] * *value;
        }
    }
    sum
}
