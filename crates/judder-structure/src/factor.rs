//! The sparse factorisation of a symmetric matrix that need not be positive, and how many of its eigenvalues are negative.

use crate::StructureError;
use crate::assembly::Sparse;
use faer::dyn_stack::{MemBuffer, MemStack, StackReq};
use faer::linalg::cholesky::lblt::factor::LbltParams;
use faer::perm::PermRef;
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::supernodal::SupernodalIntranodeLbltRef;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, IntranodeLbltRef, SymbolicCholesky, SymbolicCholeskyRaw, SymmetricOrdering,
    factorize_symbolic_cholesky,
};
use faer::{Conj, MatMut, Par, Side, Spec};

/// P A Pᵀ = L B Lᵀ with blocks of one and two rows in B.
#[derive(Debug)]
pub struct SymmetricFactor {
    symbolic: SymbolicCholesky<usize>,
    values: Vec<f64>,
    subdiagonal: Vec<f64>,
    forward: Vec<usize>,
    inverse: Vec<usize>,
}

impl SymmetricFactor {
    /// The factors of a symmetric matrix; its lower triangle is read.
    ///
    /// # Errors
    /// [`StructureError::OutOfMemory`].
    pub fn new(matrix: &Sparse) -> Result<Self, StructureError> {
        let rows = matrix.nrows();
        let out_of_memory = || StructureError::OutOfMemory { rows };
        let parameters = CholeskySymbolicParams {
            supernodal_flop_ratio_threshold: SupernodalThreshold::FORCE_SUPERNODAL,
            ..CholeskySymbolicParams::default()
        };
        let symbolic =
            factorize_symbolic_cholesky(matrix.symbolic(), Side::Lower, SymmetricOrdering::Amd, parameters)
                .map_err(|_| out_of_memory())?;
        let mut values = vec![0.0; symbolic.len_val()];
        let mut subdiagonal = vec![0.0; rows];
        let (mut forward, mut inverse) = (vec![0; rows], vec![0; rows]);
        let parameters = Spec::<LbltParams, f64>::default();
        let mut memory =
            buffer(symbolic.factorize_numeric_intranode_lblt_scratch::<f64>(Par::Seq, parameters), rows)?;
        symbolic.factorize_numeric_intranode_lblt(
            &mut values,
            &mut subdiagonal,
            &mut forward,
            &mut inverse,
            matrix.as_ref(),
            Side::Lower,
            Par::Seq,
            MemStack::new(&mut memory),
            parameters,
        );
        Ok(Self { symbolic, values, subdiagonal, forward, inverse })
    }

    fn permutation(&self) -> PermRef<'_, usize> {
        PermRef::new_checked(&self.forward, &self.inverse, self.forward.len())
    }

    /// How many eigenvalues are negative (Sylvester's law of inertia).
    ///
    /// # Errors
    /// [`StructureError::NoInertia`] where the factors are of a kind that does not tell.
    pub fn negative_eigenvalues(&self) -> Result<usize, StructureError> {
        let SymbolicCholeskyRaw::Supernodal(symbolic) = self.symbolic.raw() else {
            return Err(StructureError::NoInertia);
        };
        let factor =
            SupernodalIntranodeLbltRef::new(symbolic, &self.values, &self.subdiagonal, self.permutation());
        Ok((0..symbolic.n_supernodes())
            .map(|s| {
                let node = factor.supernode(s);
                let block = node.val();
                let diagonal = |k: usize| block[(k, k)];
                negative_in(&self.subdiagonal[node.start()..node.start() + block.ncols()], diagonal)
            })
            .sum())
    }

    /// x with A x = b, in place of b.
    ///
    /// # Errors
    /// [`StructureError::OutOfMemory`].
    pub fn solve(&self, right: &mut [f64]) -> Result<(), StructureError> {
        let rows = right.len();
        let factor =
            IntranodeLbltRef::new(&self.symbolic, &self.values, &self.subdiagonal, self.permutation());
        let mut memory = buffer(self.symbolic.solve_in_place_scratch::<f64>(1, Par::Seq), rows)?;
        let right = MatMut::from_column_major_slice_mut(right, rows, 1);
        factor.solve_in_place_with_conj(Conj::No, right, Par::Seq, MemStack::new(&mut memory));
        Ok(())
    }
}

fn buffer(needed: StackReq, rows: usize) -> Result<MemBuffer, StructureError> {
    MemBuffer::try_new(needed).map_err(|_| StructureError::OutOfMemory { rows })
}

/// Negative eigenvalues of a block diagonal: a row with a subdiagonal entry begins a block of two rows.
fn negative_in(subdiagonal: &[f64], diagonal: impl Fn(usize) -> f64) -> usize {
    let (mut negative, mut row) = (0, 0);
    while row < subdiagonal.len() {
        let beside = subdiagonal[row];
        if beside == 0.0 {
            negative += usize::from(diagonal(row) < 0.0);
            row += 1;
            continue;
        }
        let (a, b) = (diagonal(row), diagonal(row + 1));
        negative += match (a * b - beside * beside < 0.0, a + b < 0.0) {
            (true, _) => 1,
            (false, true) => 2,
            (false, false) => 0,
        };
        row += 2;
    }
    negative
}
