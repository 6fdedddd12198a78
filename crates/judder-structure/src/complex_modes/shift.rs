//! Q(σ) factored once for many solutions, with it and with its transpose.

use crate::StructureError;
use crate::quadratic::{MatrixSide, Quadratic};
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::lu::partial_pivoting::factor::PartialPivLuParams;
use faer::sparse::linalg::LuError;
use faer::sparse::linalg::lu::{LuRef, LuSymbolicParams, NumericLu, SymbolicLu, factorize_symbolic_lu};
use faer::{Conj, Mat, Par, Spec, c64};

/// P Q(σ) Pᶜ = L U.
#[derive(Debug)]
pub(crate) struct ShiftedFactor {
    shift: c64,
    symbolic: SymbolicLu<usize>,
    numeric: NumericLu<usize, c64>,
}

impl ShiftedFactor {
    /// The factors at a shift, or beside it where Q(σ) is singular: no further off than the reach times a few thousandths.
    ///
    /// # Errors
    /// [`StructureError::SingularEverywhere`], [`StructureError::OutOfMemory`].
    pub(crate) fn near(problem: &Quadratic, shift: c64, reach: f64) -> Result<Self, StructureError> {
        // steps aside by numbers that no eigenvalue is likely to stand at
        const ASIDE: [(f64, f64); 4] =
            [(0.0, 0.0), (1.37e-3, 0.91e-3), (-2.23e-3, 1.71e-3), (0.77e-3, -3.19e-3)];
        let mut tried = shift;
        for (re, im) in ASIDE {
            tried = shift + c64::new(re, im) * reach;
            if let Some(factor) = Self::at(problem, tried)? {
                return Ok(factor);
            }
        }
        Err(StructureError::SingularEverywhere { value: tried })
    }

    /// The factors at a shift; `None` where Q(σ) is singular to rounding.
    pub(crate) fn at(problem: &Quadratic, shift: c64) -> Result<Option<Self>, StructureError> {
        let rows = problem.size();
        let out_of_memory = || StructureError::OutOfMemory { rows };
        let matrix = problem.at(shift)?;
        let symbolic = match factorize_symbolic_lu(matrix.symbolic(), LuSymbolicParams::default()) {
            Ok(symbolic) => symbolic,
            Err(_) => return Err(out_of_memory()),
        };
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
        let factor = Self { shift, symbolic, numeric };
        // a zero pivot shows as what is not finite
        let mut probe = Mat::from_fn(rows, 1, |_, _| c64::new(1.0, 0.0));
        factor.solve(MatrixSide::Right, &mut probe)?;
        let finite = (0..rows).all(|row| probe[(row, 0)].re.is_finite() && probe[(row, 0)].im.is_finite());
        Ok(finite.then_some(factor))
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
        let rows = block.nrows();
        let needed = self.symbolic.solve_in_place_scratch::<c64>(block.ncols(), Par::Seq);
        let mut memory = MemBuffer::try_new(needed).map_err(|_| StructureError::OutOfMemory { rows })?;
        let (factor, stack) =
            (LuRef::new_unchecked(&self.symbolic, &self.numeric), MemStack::new(&mut memory));
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
