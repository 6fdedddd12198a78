//! Undamped modes: K φ = λ M φ, the lowest or those of a band, with a count that shows whether one is missing.

mod lanczos;
mod start;

use crate::StructureError;
use crate::assembly::Sparse;
use crate::definiteness::admit_mass;
use crate::factor::{FactorPattern, SymmetricFactor};
use crate::statics::{dot, sum, symmetric_product};
use faer::Mat;
use judder_dense::symmetric::{Eigen, generalised};
use lanczos::{APART, Lanczos, LanczosModes, combined};
use start::{ShiftedStart, admit_start, upper_edge};
use std::f64::consts::TAU;

/// Which modes are wanted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum WantedModes {
    /// So many, from the lowest on; where freedoms have no mass, no more than have one.
    Lowest(usize),
    /// All between two frequencies in Hz, both included. From zero, or a number below, it takes all below the second frequency; from
    /// a number above zero no rigid motion, and the search begins at it: modes below are counted, not searched.
    Band(f64, f64),
}

/// A mode.
#[derive(Debug, Clone, PartialEq)]
pub struct Mode {
    /// λ = ω² in 1/s²; of a rigid motion zero but for rounding.
    pub eigenvalue: f64,
    /// φ with φᵀ M φ = 1, in 1/√kg.
    pub shape: Vec<f64>,
    /// ‖K φ − λ M φ‖/((‖K‖ + |λ| ‖M‖) ‖φ‖), the normalised backward error.
    pub residual: f64,
}

impl Mode {
    /// ω/2π in Hz; of a rigid motion zero.
    #[must_use]
    pub fn frequency_hz(&self) -> f64 {
        self.eigenvalue.max(0.0).sqrt() / TAU
    }
}

/// Modes by rising frequency.
#[derive(Debug, Clone, PartialEq)]
pub struct Modes {
    /// The modes.
    pub modes: Vec<Mode>,
    /// An eigenvalue above the last mode and how many modes lie below it, counted by the signs of a factorisation.
    pub counted: (f64, usize),
    /// A value below the first mode and how many modes lie below it, counted in the same way: none is missing where as many were found
    /// as lie between the two counts. Of the lowest modes, and of a band from zero, it is below all.
    pub counted_from: (f64, usize),
    /// The eigenvalue up to which modes are rigid motions, in 1/s²; see [`rigid_limit`](crate::rigid::rigid_limit).
    pub rigid_limit: f64,
}

impl Modes {
    /// How many of the modes are rigid motions: they are the first.
    #[must_use]
    pub fn rigid_modes(&self) -> usize {
        self.modes.iter().take_while(|mode| mode.eigenvalue <= self.rigid_limit).count()
    }
}

/// Rounds of the search before it gives up on modes that the count knows of.
const ROUNDS: usize = 20;
/// Residuals that one more inverse iteration is spent on.
const ROUGH: f64 = 1e-14;

/// The modes of a structure by shift-invert Lanczos in the inner product of the mass (T. Ericsson and A. Ruhe, 1980).
///
/// Both matrices are symmetric and hold both triangles; the mass is positive, or zero in some motions. A shift below zero lets rigid motions come out as what they are; a band above
/// zero has its shift at its lower end, or a little below where an eigenvalue lies there. Sylvester's law of inertia counts the
/// eigenvalues below a value above the last mode and below the shift; while there are more than were found, the search goes on from a
/// start of its own.
///
/// # Errors
/// Those of [`admit`] with any number of multiplications; [`StructureError::MissingModes`] where the count is not reached.
pub fn modes(stiffness: &Sparse, mass: &Sparse, wanted: WantedModes) -> Result<Modes, StructureError> {
    admit_mass(mass, f64::INFINITY)?;
    let pencil = Pencil { stiffness, mass };
    let start = ShiftedStart::new(&pencil, wanted)?;
    let below = |value: f64| start.pattern.negative_eigenvalues(&pencil.shifted(value)?);
    let counted = |limit| Ok::<_, StructureError>((limit, below(limit)?));
    let whole = |modes, counted| Modes {
        modes,
        counted,
        counted_from: start.counted,
        rigid_limit: start.rigid_limit,
    };
    let (aim, upper) = match wanted {
        WantedModes::Lowest(count) => (count.min(stiffness.nrows()), None),
        WantedModes::Band(_, to) => {
            let upper = counted(upper_edge(to).max(start.counted.0))?;
            if upper.1 <= start.counted.1 {
                return Ok(whole(Vec::new(), upper));
            }
            (upper.1 - start.below, Some(upper))
        }
    };
    let mut search = Lanczos::new(&start.factor, mass, start.shift);
    let mut target = aim;
    for _ in 0..ROUNDS {
        let found = search.converged(target)?;
        if found.is_whole {
            // freedoms without mass have no modes
            target = target.min(found.values.len());
        }
        let (limit, count) = match upper {
            Some(upper) => upper,
            None => counted(limit_above(&found, target))?,
        };
        let known = found.values.partition_point(|value| *value < limit);
        if known + start.below >= count {
            drop(search);
            let last = if upper.is_some() { known } else { aim.min(known) };
            let modes = pencil.polished(&start.factor, start.shift, found.shapes)?;
            let wanted = modes.into_iter().take(last).skip(start.counted.1 - start.below);
            return Ok(whole(wanted.collect(), (limit, count)));
        }
        if found.is_whole {
            break;
        }
        target = target.max(count - start.below);
        search.start_anew();
    }
    Err(StructureError::MissingModes { wanted: aim })
}

/// Refuses what [`modes`] would refuse before it searches, as far as factorisations of no more multiplications than so many tell.
///
/// # Errors
/// [`StructureError::IndefiniteMass`], [`StructureError::NotPositive`] for sums that are not, [`StructureError::IndefiniteStiffness`] where modes are wanted from the
/// lowest on, [`StructureError::Singular`] where stiffness and mass are zero in one motion, [`StructureError::InvalidNumber`] for a band that does not rise,
/// [`StructureError::OutOfMemory`].
pub fn admit(
    stiffness: &Sparse,
    mass: &Sparse,
    wanted: WantedModes,
    most_operations: f64,
) -> Result<(), StructureError> {
    admit_mass(mass, most_operations)?;
    admit_start(&Pencil { stiffness, mass }, wanted, most_operations)
}

/// Refuses sums of the diagonals that tell no scale of eigenvalues: a part of [`admit`] for matrices of elements, which are positive.
///
/// # Errors
/// [`StructureError::NotPositive`].
pub fn admit_sums(stiffness: &Sparse, mass: &Sparse) -> Result<(), StructureError> {
    shift_scale(stiffness, mass).map(drop)
}

/// K − λ M.
struct Pencil<'a> {
    stiffness: &'a Sparse,
    mass: &'a Sparse,
}

impl Pencil<'_> {
    /// K − σ M.
    fn shifted(&self, shift: f64) -> Result<Sparse, StructureError> {
        sum(1.0, self.stiffness, -shift, self.mass)
    }

    /// The modes within the space of what was found; where residuals are rough, of what the operator makes of it, which has less
    /// of the high modes in it.
    fn polished(
        &self,
        factor: &SymmetricFactor,
        shift: f64,
        shapes: Vec<Vec<f64>>,
    ) -> Result<Vec<Mode>, StructureError> {
        let modes = self.rayleigh_ritz(shapes)?;
        if modes.iter().all(|mode| mode.residual <= ROUGH) {
            return Ok(modes);
        }
        let mut shapes: Vec<Vec<f64>> =
            modes.iter().map(|mode| symmetric_product(self.mass, &mode.shape)).collect();
        for pair in shapes.chunks_mut(2) {
            match pair {
                [one, other] => factor.solve_together([one, other]),
                others => others.iter_mut().for_each(|shape| factor.solve(shape)),
            }
        }
        for (shape, mode) in shapes.iter_mut().zip(&modes) {
            // back to a length near one; the space is what counts
            for value in shape {
                *value *= mode.eigenvalue - shift;
            }
        }
        self.rayleigh_ritz(shapes)
    }

    /// The modes within the space of shapes: what a factorisation near a rigid motion mixed comes apart.
    fn rayleigh_ritz(&self, shapes: Vec<Vec<f64>>) -> Result<Vec<Mode>, StructureError> {
        let wanted = shapes.len();
        if wanted == 0 {
            return Ok(Vec::new());
        }
        let projected = |matrix: &Sparse| {
            let images: Vec<Vec<f64>> = shapes.iter().map(|shape| symmetric_product(matrix, shape)).collect();
            Mat::from_fn(wanted, wanted, |i, j| dot(&shapes[i], &images[j]))
        };
        let Eigen { values, vectors } = generalised(projected(self.stiffness), &projected(self.mass))
            .ok_or(StructureError::MissingModes { wanted })?;
        let norms = [norm_of(self.stiffness), norm_of(self.mass)];
        let mode = |(k, value)| self.mode(value, combined(&shapes, |i| vectors[(i, k)]), norms);
        Ok(values.into_iter().enumerate().map(mode).collect())
    }

    fn mode(&self, eigenvalue: f64, shape: Vec<f64>, [of_stiffness, of_mass]: [f64; 2]) -> Mode {
        let elastic = symmetric_product(self.stiffness, &shape);
        let inertial = symmetric_product(self.mass, &shape);
        let norm = |v: &[f64]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
        let rest: Vec<f64> = elastic.iter().zip(&inertial).map(|(k, m)| k - eigenvalue * m).collect();
        let scale = (of_stiffness + eigenvalue.abs() * of_mass) * norm(&shape);
        Mode { eigenvalue, shape, residual: norm(&rest) / scale }
    }
}

/// A value between the last wanted eigenvalue and the next: halfway, where the two stand apart.
fn limit_above(found: &LanczosModes, target: usize) -> f64 {
    let last = target.checked_sub(1).and_then(|k| found.values.get(k)).copied().unwrap_or(0.0);
    match found.values.get(target).copied().or(found.next) {
        Some(next) if next - last > APART * next.abs() => 0.5 * (last + next),
        _ => last * (1.0 + APART) + f64::MIN_POSITIVE,
    }
}

/// How many eigenvalues lie below a value.
///
/// # Errors
/// [`StructureError::OutOfMemory`], [`StructureError::Singular`] where the value is an eigenvalue.
pub fn below(stiffness: &Sparse, mass: &Sparse, value: f64) -> Result<usize, StructureError> {
    let matrix = Pencil { stiffness, mass }.shifted(value)?;
    FactorPattern::new(&matrix)?.negative_eigenvalues(&matrix)
}

/// A small positive eigenvalue for shifts: far below the mean of all, far above what rounding makes of zero.
fn shift_scale(stiffness: &Sparse, mass: &Sparse) -> Result<f64, StructureError> {
    const SHARE: f64 = 1e-8;
    let trace =
        |matrix: &Sparse| (0..matrix.nrows()).map(|k| matrix.get(k, k).copied().unwrap_or(0.0)).sum::<f64>();
    let (of_stiffness, of_mass) = (trace(stiffness), trace(mass));
    for (name, value) in [("the trace of the stiffness", of_stiffness), ("the trace of the mass", of_mass)] {
        if !(value.is_finite() && value > 0.0) {
            return Err(StructureError::NotPositive { name, value });
        }
    }
    Ok(SHARE * of_stiffness / of_mass)
}

/// The largest sum of magnitudes of a column.
fn norm_of(matrix: &Sparse) -> f64 {
    let sum = |column: usize| matrix.val_of_col(column).iter().map(|value| value.abs()).sum::<f64>();
    (0..matrix.ncols()).map(sum).fold(0.0, f64::max)
}
