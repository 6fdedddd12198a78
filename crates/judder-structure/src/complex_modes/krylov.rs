//! Block Arnoldi on the problem shifted and inverted: the eigenvalues nearest to a shift.
//!
//! A space grown from b random vectors holds at most b copies of an eigenvalue, however large it grows, and from either side alike. So
//! it is grown from more than the largest crowd of eigenvalues in it: as long as a crowd is not outnumbered, random vectors are added.

use super::linearised::LinearisedOperator;
use crate::StructureError;
use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, MatRef, Par, c64};
use judder_dense::general::complex_eigen;
use judder_memory::TakenMemory;
use judder_numerics::complex::ElementaryComplex;
use judder_numerics::counter::uniform;
use judder_numerics::order::sort_by_number;

/// Vectors that are taken through the operator together: solving for four costs little more than for one.
const WIDTH: usize = 4;
/// Steps between looks at the eigenvalues, and vectors for each step more: a look takes as long as many steps where there are many vectors.
const STRIDE: usize = 4;
const VECTORS_OF_A_STEP: usize = 32;
/// Vectors before a search gives up on more than it has.
const LARGEST: usize = 256;
/// By half of them a search has to reach so much of its part, or it gives up: the vectors that it takes grow at least as its reach.
const HOPELESS: f64 = 0.3;
/// Random vectors before a search gives up on a crowd.
const MOST_STARTS: usize = 64;
/// So many more for each random one after the first.
const STEPS_OF_A_START: usize = 12;
/// Eigenvalues nearer to the next than this share of the reach are a crowd: equal ones, and the cube roots to which rounding scatters a
/// defective one, which a space resolves late or never.
const CROWD: f64 = 1e-3;
/// θ counts as converged where its residual over |θ| is below it.
const TOLERANCE: f64 = 1e-11;
/// A new vector shorter than this share of what it was made of lies in the basis.
const INVARIANT: f64 = 1e-11;

/// An eigenvalue with its right vector, of length one.
#[derive(Debug, Clone)]
pub(super) struct EigenPair {
    pub(super) value: c64,
    pub(super) vector: Vec<c64>,
}

/// What a search around a shift has found: all eigenvalues within a radius.
#[derive(Debug, Clone)]
pub(super) struct FoundAroundShift {
    /// By rising distance from the shift.
    pub(super) pairs: Vec<EigenPair>,
    /// Every eigenvalue nearer to the shift has converged.
    pub(super) radius: f64,
    /// Some are too many in one place: there may be more of them.
    pub(super) crowded: bool,
}

/// All eigenvalues within the operator's reach of its shift, or as far out as the largest basis holds.
pub(super) fn search(
    operator: &LinearisedOperator<'_>,
    seed: u64,
) -> Result<FoundAroundShift, StructureError> {
    let asked = operator.reach;
    let mut basis = Basis::start(operator, seed)?;
    let mut seen = None;
    loop {
        for _ in 0..STRIDE.max(basis.filled / VECTORS_OF_A_STEP) {
            basis.grow()?;
        }
        let ritz = basis.ritz()?;
        if basis.whole {
            return Ok(basis.found(&ritz, f64::INFINITY));
        }
        let crowd = ritz.largest_crowd(ritz.radius.min(asked));
        let outnumbered = crowd >= basis.starts;
        // a value that comes late shows within one more look
        let settled = ritz.radius >= asked && seen == Some(ritz.inside(asked));
        let beyond_counting = outnumbered && crowd >= MOST_STARTS;
        let hopeless = basis.filled >= LARGEST / 2 && ritz.radius < HOPELESS * asked;
        if (settled && !outnumbered) || basis.is_full() || beyond_counting || hopeless {
            return Ok(FoundAroundShift { crowded: outnumbered, ..basis.found(&ritz, ritz.radius) });
        }
        seen = (ritz.radius >= asked).then(|| ritz.inside(asked));
        if outnumbered {
            seen = None;
            basis.start_anew(WIDTH.max(crowd + 1 - basis.starts))?;
        }
    }
}

/// An orthonormal basis and the operator on it.
struct Basis<'a> {
    operator: &'a LinearisedOperator<'a>,
    seed: u64,
    /// Random vectors that it was grown from.
    starts: usize,
    /// Columns (x, u), 2n long; those beyond `filled` are room.
    vectors: Mat<c64>,
    filled: usize,
    /// Of the memory that these vectors take.
    taken: TakenMemory,
    /// The newest block: columns from here on have not been through the operator.
    fresh: usize,
    /// The operator between the vectors: a column for each that has been through.
    projected: Mat<c64>,
    /// Nothing lies outside of it that the operator does not take to zero.
    whole: bool,
}

/// Eigenvalues of the operator on the basis by falling |θ|, and how many of the first have converged.
struct RitzPair {
    values: Vec<c64>,
    vectors: Mat<c64>,
    order: Vec<usize>,
    converged: usize,
    /// The distance within which all have converged.
    radius: f64,
    reach: f64,
}

impl<'a> Basis<'a> {
    fn start(operator: &'a LinearisedOperator<'a>, seed: u64) -> Result<Self, StructureError> {
        let rows = operator.rows();
        // only room: a column is written when the basis comes to it
        let mut vectors = Mat::new();
        vectors.try_reserve(rows, LARGEST + WIDTH).map_err(|_| StructureError::OutOfMemory { rows })?;
        let mut basis = Self {
            operator,
            seed,
            starts: 0,
            vectors,
            filled: 0,
            taken: operator.factor.memory().take(0)?,
            fresh: 0,
            projected: Mat::zeros(LARGEST + WIDTH, LARGEST + WIDTH),
            whole: false,
        };
        basis.start_anew(WIDTH)?;
        Ok(basis)
    }

    /// Takes in random vectors that the basis was not grown from.
    fn start_anew(&mut self, count: usize) -> Result<(), StructureError> {
        let rows = self.operator.rows();
        let random = |row: usize, column: usize| {
            let at = (2 * ((self.starts + column) * rows + row)) as u64;
            c64::new(uniform(self.seed, at) - 0.5, uniform(self.seed, at + 1) - 0.5)
        };
        // once through the operator: nothing is left that has no mass
        let block = self.operator.through(Mat::from_fn(rows, count, random).as_ref())?;
        self.starts += count;
        self.take_in(block)?;
        Ok(())
    }

    /// Whether it holds as many vectors as it is worth.
    fn is_full(&self) -> bool {
        self.filled + WIDTH > LARGEST + STEPS_OF_A_START * (self.starts - WIDTH)
    }

    /// One more block, random where the space is invariant without it.
    fn grow(&mut self) -> Result<(), StructureError> {
        if self.whole || self.is_full() {
            return Ok(());
        }
        let (from, width) = (self.fresh, self.filled - self.fresh);
        if width == 0 {
            self.start_anew(WIDTH)?;
            self.whole = self.filled == from;
            return Ok(());
        }
        let image = self.operator.through(self.vectors.subcols(from, width))?;
        self.fresh = self.filled;
        let shares = self.take_in(image)?;
        for (k, shares) in shares.iter().enumerate() {
            for (row, share) in shares.iter().enumerate() {
                self.projected[(row, from + k)] = *share;
            }
        }
        Ok(())
    }

    /// Makes a block orthonormal and a part of the basis; gives the coordinates of each of its vectors.
    fn take_in(&mut self, mut block: Mat<c64>) -> Result<Vec<Vec<c64>>, StructureError> {
        let lengths: Vec<f64> = (0..block.ncols()).map(|k| block.col(k).norm_l2()).collect();
        let (before, rows) = (self.filled, block.nrows());
        self.taken.take((block.ncols() * rows * size_of::<c64>()) as u64)?;
        let columns = before + block.ncols();
        self.vectors.resize_with(rows, columns, |_, _| c64::new(0.0, 0.0));
        let room = columns.max(self.projected.nrows());
        self.projected.resize_with(room, room, |_, _| c64::new(0.0, 0.0));
        let mut shares = Mat::zeros(before, block.ncols());
        // twice is enough (W. Kahan, B. N. Parlett)
        for _ in 0..2 {
            shares += project_out(self.vectors.subcols(0, before), &mut block);
        }
        let mut coordinates = Vec::new();
        for (k, length) in lengths.iter().enumerate() {
            let mut column: Vec<c64> = (0..before).map(|row| shares[(row, k)]).collect();
            let mut vector = Mat::from_fn(rows, 1, |row, _| block[(row, k)]);
            let mut within = Mat::zeros(self.filled - before, 1);
            for _ in 0..2 {
                within += project_out(self.vectors.subcols(before, self.filled - before), &mut vector);
            }
            column.extend((0..self.filled - before).map(|row| within[(row, 0)]));
            let left = vector.norm_l2();
            if left > INVARIANT * length && self.filled < rows {
                column.push(c64::new(left, 0.0));
                for row in 0..rows {
                    self.vectors[(row, self.filled)] = vector[(row, 0)] / left;
                }
                self.filled += 1;
            }
            coordinates.push(column);
        }
        Ok(coordinates)
    }

    fn ritz(&self) -> Result<RitzPair, StructureError> {
        let reach = self.operator.reach;
        let done = self.fresh;
        let (values, vectors) = complex_eigen(self.projected.submatrix(0, 0, done, done))
            .ok_or(StructureError::NoDenseEigenvalues { rows: done })?;
        let mut order: Vec<usize> = (0..done).collect();
        sort_by_number(&mut order, |own| -values[*own].modulus());
        let open = self.projected.submatrix(done, 0, self.filled - done, done);
        let mut rests = Mat::zeros(open.nrows(), done);
        matmul(rests.as_mut(), Accum::Replace, open, vectors.as_ref(), c64::new(1.0, 0.0), Par::Seq);
        let residual = |k: usize| rests.col(k).norm_l2() / vectors.col(k).norm_l2();
        let has_converged = |k: &&usize| residual(**k) <= TOLERANCE * values[**k].modulus();
        let converged = order.iter().take_while(has_converged).count();
        let distance = |k: usize| reach / values[k].modulus();
        let radius = match (order.get(converged), converged) {
            // what has not converged may lie as much nearer as it is far
            (Some(k), _) => 0.9 * distance(*k),
            (None, 0) => 0.0,
            (None, _) => reach,
        };
        Ok(RitzPair { values, vectors, order, converged, radius, reach })
    }

    fn found(&self, ritz: &RitzPair, radius: f64) -> FoundAroundShift {
        let (size, done) = (self.operator.problem.size(), self.fresh);
        let pairs = ritz.finite().map(|k| {
            let mut vector = Mat::zeros(size, 1);
            let (basis, shares) = (self.vectors.submatrix(0, 0, size, done), ritz.vectors.subcols(k, 1));
            matmul(vector.as_mut(), Accum::Replace, basis, shares, c64::new(1.0, 0.0), Par::Seq);
            let length = vector.norm_l2();
            EigenPair {
                value: self.operator.value(ritz.values[k]),
                vector: (0..size).map(|row| vector[(row, 0)] / length).collect(),
            }
        });
        FoundAroundShift { pairs: pairs.collect(), radius, crowded: false }
    }
}

impl RitzPair {
    /// The converged eigenvalues that are not infinite.
    fn finite(&self) -> impl Iterator<Item = usize> + '_ {
        const INFINITE: f64 = 1e-8;
        self.order[..self.converged].iter().copied().filter(|k| self.values[*k].modulus() > INFINITE)
    }

    /// How many lie within a distance of the shift.
    fn inside(&self, distance: f64) -> usize {
        self.within(distance).len()
    }

    /// λ − σ of those within a distance of the shift.
    fn within(&self, distance: f64) -> Vec<c64> {
        let apart = self.finite().map(|k| self.reach / self.values[k]);
        apart.filter(|apart| apart.modulus() <= distance).collect()
    }

    /// The most eigenvalues within a distance of the shift of which each has a next that is near.
    fn largest_crowd(&self, distance: f64) -> usize {
        let mut left = self.within(distance);
        let mut largest = 0;
        while let Some(first) = left.pop() {
            let (mut crowd, mut seen) = (vec![first], 0);
            while let Some(member) = crowd.get(seen).copied() {
                let near = |other: &mut c64| (*other - member).modulus() <= CROWD * self.reach;
                crowd.extend(left.extract_if(.., near));
                seen += 1;
            }
            largest = largest.max(crowd.len());
        }
        largest
    }
}

/// B ← B − V Vᴴ B; gives Vᴴ B.
fn project_out(basis: MatRef<'_, c64>, block: &mut Mat<c64>) -> Mat<c64> {
    let mut shares = Mat::zeros(basis.ncols(), block.ncols());
    matmul(shares.as_mut(), Accum::Replace, basis.adjoint(), block.as_ref(), c64::new(1.0, 0.0), Par::Seq);
    matmul(block.as_mut(), Accum::Add, basis, shares.as_ref(), c64::new(-1.0, 0.0), Par::Seq);
    shares
}
