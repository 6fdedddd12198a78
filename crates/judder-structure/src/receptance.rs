//! Receptances: the displacement of one degree of freedom under a harmonic force on another.

use crate::StructureError;
use crate::complex_modes::{ShiftedFactor, shifts_at_once};
use crate::quadratic::{MatrixSide, Quadratic};
use faer::{Mat, c64};
use judder_memory::HeldMemory;
use judder_numerics::parallel;

/// The receptance at one frequency, found twice.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Receptance {
    /// α, m/N; not a number where the structure resonates without damping, or has no such freedom.
    pub value: c64,
    /// The same by the transposed matrices: the displacement of the excited freedom when they are loaded at the observed one.
    pub transposed: c64,
    /// The largest displacement of any freedom by either force, m/N: what differences of the two are measured by.
    pub largest: f64,
    /// |Q(iω) u − e| over (‖Q(iω)‖ |u| + 1): the backward error of the displacements.
    pub residual: f64,
}

/// α(ω) = eᵀ_observed (K + iω C − ω² M)⁻¹ e_excited at angular frequencies, rad/s, in their order.
///
/// The matrices need be neither symmetric nor damped: each frequency is one factorisation of Q(iω), whatever the modes; each thread holds the factors of one, or fewer where the memory has no room. The second value
/// of each is by Q(iω)ᵀ, as eᵀ A⁻¹ e' = e'ᵀ A⁻ᵀ e.
///
/// # Errors
/// [`StructureError::BeyondMemory`], [`StructureError::OutOfMemory`].
pub fn receptances(
    problem: &Quadratic,
    excited: usize,
    observed: usize,
    frequencies: &[f64],
    memory: &HeldMemory,
) -> Result<Vec<Receptance>, StructureError> {
    let mut found = Vec::with_capacity(frequencies.len());
    for some in frequencies.chunks(shifts_at_once(problem, memory)?.min(parallel::threads())) {
        found.extend(parallel::try_each(some, |frequency| {
            at(problem, [excited, observed], *frequency, memory)
        })?);
    }
    Ok(found)
}

fn at(
    problem: &Quadratic,
    [excited, observed]: [usize; 2],
    frequency: f64,
    memory: &HeldMemory,
) -> Result<Receptance, StructureError> {
    let shift = c64::new(0.0, frequency);
    let has_both = excited.max(observed) < problem.size();
    let factor = if has_both { ShiftedFactor::at(problem, shift, memory)? } else { None };
    let Some(factor) = factor else {
        let none = c64::new(f64::NAN, f64::NAN);
        return Ok(Receptance { value: none, transposed: none, largest: f64::NAN, residual: f64::INFINITY });
    };
    let unit =
        |row: usize| Mat::from_fn(problem.size(), 1, |k, _| c64::new(f64::from(u8::from(k == row)), 0.0));
    let (mut moved, mut back) = (unit(excited), unit(observed));
    factor.solve(MatrixSide::Right, &mut moved)?;
    factor.solve(MatrixSide::Left, &mut back)?;
    let left = problem.image(MatrixSide::Right, shift, moved.as_ref()) - unit(excited);
    let residual = left.norm_max() / (problem.scale(shift) * moved.norm_max() + 1.0);
    let largest = moved.norm_max().max(back.norm_max());
    Ok(Receptance { value: moved[(observed, 0)], transposed: back[(excited, 0)], largest, residual })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::assembly::Sparse;
    use faer::sparse::Triplet;
    use judder_memory::MemoryBudget;

    fn unlimited() -> HeldMemory {
        HeldMemory::of(MemoryBudget::unlimited())
    }

    fn matrix(rows: [[f64; 2]; 2]) -> Sparse {
        let places = (0..2).flat_map(|row| (0..2).map(move |column| (row, column)));
        let entries: Vec<_> =
            places.map(|(row, column)| Triplet::new(row, column, rows[row][column])).collect();
        Sparse::try_new_from_triplets(2, 2, &entries).unwrap()
    }

    /// The inverse of a matrix of two rows is known: [[a, b], [c, d]]⁻¹ = [[d, −b], [−c, a]]/(a d − b c).
    #[test]
    fn a_receptance_is_an_entry_of_the_inverse() {
        let (m, c, k) = ([[2.0, 0.1], [0.1, 1.0]], [[0.3, -0.2], [0.4, 0.1]], [[50.0, -30.0], [10.0, 40.0]]);
        let problem = Quadratic::new(matrix(m), matrix(c), matrix(k)).unwrap();
        for frequency in [0.0, 1.0, 5.5, 40.0] {
            let entry =
                |i: usize, j: usize| c64::new(k[i][j] - frequency * frequency * m[i][j], frequency * c[i][j]);
            let determinant = entry(0, 0) * entry(1, 1) - entry(0, 1) * entry(1, 0);
            for (excited, observed, expected) in
                [(0, 0, entry(1, 1)), (1, 1, entry(0, 0)), (1, 0, -entry(0, 1)), (0, 1, -entry(1, 0))]
            {
                let expected = expected / determinant;
                let found = receptances(&problem, excited, observed, &[frequency], &unlimited()).unwrap()[0];
                assert!((found.value - expected).norm() < 1e-14 * expected.norm(), "{frequency} {found:?}");
                assert!((found.transposed - expected).norm() < 1e-14 * expected.norm(), "{frequency}");
                assert!(found.residual < 1e-15, "{found:?}");
            }
        }
    }

    /// An oscillator without damping has none at its own frequency.
    #[test]
    fn at_a_resonance_without_damping_there_is_none() {
        let none = matrix([[0.0; 2]; 2]);
        let problem =
            Quadratic::new(matrix([[1.0, 0.0], [0.0, 1.0]]), none, matrix([[4.0, 0.0], [0.0, 9.0]])).unwrap();
        let found = receptances(&problem, 0, 0, &[1.0, 2.0, 3.0], &unlimited()).unwrap();
        assert!((found[0].value.re - 1.0 / 3.0).abs() < 1e-15);
        // freedoms that nothing joins: no displacement, measured by that of the freedom which moves, 1/3 or 1/8
        let apart = receptances(&problem, 0, 1, &[1.0], &unlimited()).unwrap()[0];
        assert_eq!((apart.value.norm(), apart.transposed.norm()), (0.0, 0.0));
        assert!((apart.largest - 1.0 / 3.0).abs() < 1e-15, "{apart:?}");
        assert!(found[1].value.re.is_nan() && found[2].value.re.is_nan());
        assert!(receptances(&problem, 0, 2, &[1.0], &unlimited()).unwrap()[0].value.re.is_nan());
    }
}
