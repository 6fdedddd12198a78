//! Q(σ) factored once for many solutions, with it and with its transpose.

use crate::StructureError;
use crate::assembly::Sparse;
use crate::factor::general::GeneralFactor;
use crate::factor::{FactorPattern, likely_entries};
use crate::quadratic::{MatrixSide, Quadratic};
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::lu::partial_pivoting::factor::PartialPivLuParams;
use faer::sparse::SparseColMat;
use faer::sparse::linalg::LuError;
use faer::sparse::linalg::lu::{LuRef, LuSymbolicParams, NumericLu, SymbolicLu, factorize_symbolic_lu};
use faer::{Conj, Mat, Par, Spec, c64};
use judder_memory::{HeldMemory, TakenMemory};
use judder_numerics::complex::ElementaryComplex;

/// Q(σ) = L U up to the orders of rows and columns.
#[derive(Debug)]
pub(crate) struct ShiftedFactor {
    shift: c64,
    factors: ShiftedFactors,
    taken: TakenMemory,
}

#[derive(Debug)]
enum ShiftedFactors {
    /// On the pattern of Q + Qᵀ, with pivots among the rows of a block.
    OfBlocks(GeneralFactor),
    /// With pivots among all rows.
    OfRows { symbolic: Box<SymbolicLu<usize>>, numeric: Box<NumericLu<usize, c64>> },
}

/// Problems of fewer freedoms are factored with pivots among all rows.
const LARGE: usize = 500;
/// Pivots among the rows of a block have sufficed where they leave no more of a right side, over all that it is made of.
const SUFFICIENT: f64 = 1e-12;
/// Bytes that an entry of a symmetric factor on the same pattern takes here: in L and in U, both complex.
const HELD_BYTES: f64 = 32.0;
/// The same while they are made, with what waits to be added to blocks.
const MAKING_BYTES: f64 = 44.0;

/// Bytes that the factors at one shift take while they are made.
fn making_bytes(pattern: &FactorPattern) -> u64 {
    (MAKING_BYTES * pattern.entries() as f64) as u64
}

/// How many of these factors fit into what is left at once; one at least.
///
/// # Errors
/// [`StructureError::OutOfMemory`].
pub(crate) fn shifts_at_once(problem: &Quadratic, memory: &HeldMemory) -> Result<usize, StructureError> {
    if problem.size() < LARGE { Ok(usize::MAX) } else { Ok(memory.fit(making_bytes(&problem.pattern()?))) }
}

/// Bytes that the factors at one shift are likely to take at most, from the fullest of the matrices: before an order of elimination is sought.
#[must_use]
pub fn likely_bytes_of_shift(fullest: &Sparse) -> f64 {
    MAKING_BYTES * likely_entries(fullest)
}

impl ShiftedFactor {
    /// The factors at a shift, or beside it where Q(σ) is singular: no further off than the reach times a few thousandths.
    ///
    /// # Errors
    /// [`StructureError::SingularEverywhere`], [`StructureError::BeyondMemory`], [`StructureError::OutOfMemory`].
    pub(crate) fn near(
        problem: &Quadratic,
        shift: c64,
        reach: f64,
        memory: &HeldMemory,
    ) -> Result<Self, StructureError> {
        // steps aside by numbers that no eigenvalue is likely to stand at
        const ASIDE: [(f64, f64); 4] =
            [(0.0, 0.0), (1.37e-3, 0.91e-3), (-2.23e-3, 1.71e-3), (0.77e-3, -3.19e-3)];
        let mut tried = shift;
        for (re, im) in ASIDE {
            tried = shift + c64::new(re, im) * reach;
            if let Some(factor) = Self::at(problem, tried, memory)? {
                return Ok(factor);
            }
        }
        Err(StructureError::SingularEverywhere { value: tried })
    }

    /// The factors at a shift; `None` where Q(σ) is singular to rounding.
    ///
    /// # Errors
    /// [`StructureError::BeyondMemory`], [`StructureError::OutOfMemory`].
    pub(crate) fn at(
        problem: &Quadratic,
        shift: c64,
        memory: &HeldMemory,
    ) -> Result<Option<Self>, StructureError> {
        let matrix = problem.at(shift)?;
        let mut taken = memory.take(0)?;
        if problem.size() >= LARGE {
            let pattern = problem.pattern()?;
            taken.take(making_bytes(&pattern))?;
            if let Some(factor) = GeneralFactor::new(&pattern, &matrix)? {
                taken.keep((HELD_BYTES * pattern.entries() as f64) as u64);
                let factor = Self { shift, factors: ShiftedFactors::OfBlocks(factor), taken };
                if factor.left_of_ones(&matrix)? <= SUFFICIENT {
                    return Ok(Some(factor));
                }
                taken = factor.taken;
            }
        }
        let Some(factors) = ShiftedFactors::of_rows(&matrix)? else { return Ok(None) };
        let factor = Self { shift, factors, taken };
        // a zero pivot shows as what is not finite
        Ok(factor.left_of_ones(&matrix)?.is_finite().then_some(factor))
    }

    /// ‖Q x − b‖/(‖Q‖ ‖x‖ + ‖b‖) of the solution x for a b of ones, in the norm of the largest; not a number where that is not.
    fn left_of_ones(&self, matrix: &SparseColMat<usize, c64>) -> Result<f64, StructureError> {
        let rows = matrix.nrows();
        let one = c64::new(1.0, 0.0);
        let mut x = Mat::from_fn(rows, 1, |_, _| one);
        self.solve(MatrixSide::Right, &mut x)?;
        let (mut left, mut sizes) = (vec![-one; rows], vec![1.0; rows]);
        for column in 0..rows {
            for (row, value) in matrix.row_idx_of_col(column).zip(matrix.val_of_col(column)) {
                let product = value * x[(column, 0)];
                left[row] += product;
                sizes[row] += product.modulus();
            }
        }
        let norm =
            |values: &mut dyn Iterator<Item = f64>| values.map(|value| value * value).sum::<f64>().sqrt();
        Ok(norm(&mut left.iter().map(|value| value.modulus())) / norm(&mut sizes.iter().copied()))
    }

    /// What its memory is held of.
    pub(crate) fn memory(&self) -> &HeldMemory {
        self.taken.of()
    }

    /// Takes more of it, for what belongs to this shift.
    ///
    /// # Errors
    /// [`StructureError::BeyondMemory`].
    pub(crate) fn take(&mut self, bytes: usize) -> Result<(), StructureError> {
        Ok(self.taken.take(bytes as u64)?)
    }

    /// σ.
    pub(crate) fn shift(&self) -> c64 {
        self.shift
    }

    /// X with Q(σ) X = B, or with the transpose, in place of B.
    ///
    /// # Errors
    /// [`StructureError::OutOfMemory`].
    pub(crate) fn solve(&self, side: MatrixSide, block: &mut Mat<c64>) -> Result<(), StructureError> {
        let (symbolic, numeric) = match (&self.factors, side) {
            (ShiftedFactors::OfBlocks(factor), MatrixSide::Right) => {
                factor.solve(block);
                return Ok(());
            }
            (ShiftedFactors::OfBlocks(factor), MatrixSide::Left) => {
                factor.solve_transposed(block);
                return Ok(());
            }
            (ShiftedFactors::OfRows { symbolic, numeric }, _) => (symbolic, numeric),
        };
        let rows = block.nrows();
        let needed = symbolic.solve_in_place_scratch::<c64>(block.ncols(), Par::Seq);
        let mut memory = MemBuffer::try_new(needed).map_err(|_| StructureError::OutOfMemory { rows })?;
        let (factor, stack) = (LuRef::new_unchecked(symbolic, numeric), MemStack::new(&mut memory));
        match side {
            MatrixSide::Right => {
                factor.solve_in_place_with_conj(Conj::No, block.as_mut(), Par::Seq, stack);
            }
            MatrixSide::Left => {
                factor.solve_transpose_in_place_with_conj(Conj::No, block.as_mut(), Par::Seq, stack);
            }
        }
        Ok(())
    }
}

impl ShiftedFactors {
    /// `None` where the pattern alone is singular.
    fn of_rows(matrix: &SparseColMat<usize, c64>) -> Result<Option<Self>, StructureError> {
        let out_of_memory = || StructureError::OutOfMemory { rows: matrix.nrows() };
        let symbolic = factorize_symbolic_lu(matrix.symbolic(), LuSymbolicParams::default())
            .map_err(|_| out_of_memory())?;
        let parameters = Spec::<PartialPivLuParams, c64>::default();
        let needed = symbolic.factorize_numeric_lu_scratch::<c64>(Par::Seq, parameters);
        let mut memory = MemBuffer::try_new(needed).map_err(|_| out_of_memory())?;
        let mut numeric = NumericLu::new();
        let stack = MemStack::new(&mut memory);
        match symbolic.factorize_numeric_lu(&mut numeric, matrix.as_ref(), Par::Seq, stack, parameters) {
            Ok(_) => {}
            Err(LuError::SymbolicSingular { .. }) => return Ok(None),
            Err(LuError::Generic(_)) => return Err(out_of_memory()),
        }
        Ok(Some(Self::OfRows { symbolic: Box::new(symbolic), numeric: Box::new(numeric) }))
    }
}
