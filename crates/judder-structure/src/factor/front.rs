//! The elimination of one block of columns: P A Pᵀ = L B Lᵀ with pivots among the columns of a panel.
//!
//! J. R. Bunch and L. Kaufman, *Some stable methods for calculating inertia and solving symmetric linear systems*, Mathematics of
//! Computation 31 (1977). Work is split into pieces whose sizes do not depend on the number of threads, so neither do the results.

use crate::StructureError;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::lblt::factor::{LbltParams, cholesky_in_place, cholesky_in_place_scratch};
use faer::linalg::matmul::matmul;
use faer::linalg::triangular_solve::solve_unit_lower_triangular_in_place;
use faer::{Accum, ColMut, MatMut, MatRef, Par, Spec};
use rayon::prelude::*;

/// Columns that are eliminated together.
const PANEL: usize = 128;
/// Columns of what is left that are updated together.
const TILE: usize = 256;
/// Rows below the diagonal that are eliminated together.
const CHUNK: usize = 512;

/// The factors of a block of columns.
#[derive(Debug)]
pub(super) struct Front {
    pub(super) columns: usize,
    /// L below its diagonal of ones, the diagonal of B on it, column by column.
    lower: Vec<f64>,
    /// B beside its diagonal: an entry that is not zero begins a block of two rows.
    pub(super) subdiagonal: Vec<f64>,
    /// Which row of the panel a row of its factor was.
    pub(super) pivots: Vec<usize>,
}

/// A block that is being assembled: its columns, and what they will change in the rows below.
pub(super) struct FrontAssembly {
    rows: usize,
    columns: usize,
    lower: Vec<f64>,
    /// Lower triangle of the rows below, column by column.
    pub(super) update: Vec<f64>,
}

impl FrontAssembly {
    pub(super) fn new(columns: usize, below: usize, size: usize) -> Result<Self, StructureError> {
        let rows = columns + below;
        Ok(Self { rows, columns, lower: zeros(rows * columns, size)?, update: zeros(below * below, size)? })
    }

    pub(super) fn add(&mut self, row: usize, column: usize, value: f64) {
        self.lower[column * self.rows + row] += value;
    }

    /// Adds the update of a child, whose rows are these rows here, ascending.
    pub(super) fn add_update(&mut self, update: &[f64], places: &[usize]) {
        let (count, columns) = (places.len(), self.columns);
        for (j, column) in places.iter().enumerate() {
            let own = &update[j * count + j..(j + 1) * count];
            let (target, shift) = match column.checked_sub(columns) {
                None => (&mut self.lower[column * self.rows..(column + 1) * self.rows], 0),
                Some(below) => {
                    let rows = self.rows - columns;
                    (&mut self.update[below * rows..(below + 1) * rows], columns)
                }
            };
            for (value, row) in own.iter().zip(&places[j..]) {
                target[row - shift] += value;
            }
        }
    }

    /// Eliminates the columns; what they change in the rows below comes back.
    pub(super) fn eliminate(mut self, shared: bool) -> Result<(Front, Vec<f64>), StructureError> {
        let (rows, columns) = (self.rows, self.columns);
        let (mut subdiagonal, mut pivots) = (vec![0.0; columns], vec![0; columns]);
        // L B, which updates take beside L
        let mut weighted = zeros(rows * columns, rows)?;
        for start in (0..columns).step_by(PANEL) {
            let width = PANEL.min(columns - start);
            let (panel, rest) = self.lower[start * rows..].split_at_mut(width * rows);
            let weighted = &mut weighted[start * rows..(start + width) * rows];
            let own = start..start + width;
            panel_factor(
                panel,
                weighted,
                rows,
                start,
                &mut subdiagonal[own.clone()],
                &mut pivots[own],
                shared,
            )?;
            let (panel, weighted) = (whole(panel, rows), whole(weighted, rows));
            each_tile(rest, rows, shared, |k, tile| {
                let first = start + width + k;
                let tile = whole_mut(tile, rows).subrows_mut(first, rows - first);
                let (left, right) =
                    (panel.subrows(first, rows - first), weighted.subrows(first, tile.ncols()));
                matmul(tile, Accum::Add, left, right.transpose(), -1.0, Par::Seq);
            });
        }
        let (panel, weighted) = (whole(&self.lower, rows), whole(&weighted, rows));
        let below = rows - columns;
        each_tile(&mut self.update, below, shared, |first, tile| {
            let tile = whole_mut(tile, below).subrows_mut(first, below - first);
            let left = panel.subrows(columns + first, below - first);
            let right = weighted.subrows(columns + first, tile.ncols());
            matmul(tile, Accum::Add, left, right.transpose(), -1.0, Par::Seq);
        });
        Ok((Front { columns, lower: self.lower, subdiagonal, pivots }, self.update))
    }
}

/// Column-major values with so many rows.
fn whole(values: &[f64], rows: usize) -> MatRef<'_, f64> {
    MatRef::from_column_major_slice(values, rows, values.len() / rows.max(1))
}

fn whole_mut(values: &mut [f64], rows: usize) -> MatMut<'_, f64> {
    let columns = values.len() / rows.max(1);
    MatMut::from_column_major_slice_mut(values, rows, columns)
}

/// Works on the columns tile by tile, side by side where they are to be shared.
pub(super) fn each_tile<T: Send>(
    values: &mut [T],
    rows: usize,
    shared: bool,
    work: impl Fn(usize, &mut [T]) + Sync,
) {
    let length = (TILE * rows).max(1);
    if shared {
        values.par_chunks_mut(length).enumerate().for_each(|(k, tile)| work(k * TILE, tile));
    } else {
        values.chunks_mut(length).enumerate().for_each(|(k, tile)| work(k * TILE, tile));
    }
}

/// Factors a panel: its diagonal block, then the rows below; `weighted` takes L B of these.
fn panel_factor(
    panel: &mut [f64],
    weighted: &mut [f64],
    rows: usize,
    start: usize,
    subdiagonal: &mut [f64],
    pivots: &mut [usize],
    shared: bool,
) -> Result<(), StructureError> {
    let width = pivots.len();
    let (_, square) = whole_mut(panel, rows).split_at_row_mut(start);
    let (mut top, below) = square.split_at_row_mut(width);
    let parameters = Spec::<LbltParams, f64>::default();
    let needed = cholesky_in_place_scratch::<usize, f64>(width, Par::Seq, parameters);
    let mut memory = MemBuffer::try_new(needed).map_err(|_| StructureError::OutOfMemory { rows })?;
    let mut inverse = vec![0; width];
    cholesky_in_place(
        top.as_mut(),
        ColMut::from_slice_mut(subdiagonal).as_diagonal_mut(),
        pivots,
        &mut inverse,
        Par::Seq,
        MemStack::new(&mut memory),
        parameters,
    );
    let (top, subdiagonal, pivots) = (top.as_ref(), &*subdiagonal, &*pivots);
    let (_, weighted) = whole_mut(weighted, rows).split_at_row_mut(start + width);
    let work = |(mut below, mut weighted): (MatMut<'_, f64>, MatMut<'_, f64>)| {
        for (k, pivot) in pivots.iter().enumerate() {
            weighted.as_mut().col_mut(k).copy_from(below.as_ref().col(*pivot));
        }
        solve_unit_lower_triangular_in_place(top, weighted.as_mut().transpose_mut(), Par::Seq);
        divide(weighted.as_ref(), below.as_mut(), top, subdiagonal);
    };
    if shared {
        below.par_row_chunks_mut(CHUNK).zip(weighted.par_row_chunks_mut(CHUNK)).for_each(work);
    } else {
        work((below, weighted));
    }
    Ok(())
}

/// L = (L B) B⁻¹.
fn divide(
    weighted: MatRef<'_, f64>,
    mut quotient: MatMut<'_, f64>,
    top: MatRef<'_, f64>,
    subdiagonal: &[f64],
) {
    let mut k = 0;
    while k < subdiagonal.len() {
        let pivot = Pivot::at(top, subdiagonal, k);
        for i in 0..weighted.nrows() {
            let second = if pivot.rows() == 2 { weighted[(i, k + 1)] } else { 0.0 };
            let [first, second] = pivot.solve([weighted[(i, k)], second]);
            quotient[(i, k)] = first;
            if pivot.rows() == 2 {
                quotient[(i, k + 1)] = second;
            }
        }
        k += pivot.rows();
    }
}

/// A block of B.
pub(super) enum Pivot {
    One(f64),
    /// Both diagonal entries, and the one beside.
    Two(f64, f64, f64),
}

impl Pivot {
    pub(super) fn at(top: MatRef<'_, f64>, subdiagonal: &[f64], k: usize) -> Self {
        match subdiagonal[k] {
            0.0 => Self::One(top[(k, k)]),
            beside => Self::Two(top[(k, k)], top[(k + 1, k + 1)], beside),
        }
    }

    pub(super) fn rows(&self) -> usize {
        if matches!(self, Self::One(_)) { 1 } else { 2 }
    }

    /// Scaled by the entry beside, which is the largest.
    pub(super) fn solve(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        match *self {
            Self::One(a) => [x / a, 0.0],
            Self::Two(a, b, beside) => {
                let (a, b, x, y) = (a / beside, b / beside, x / beside, y / beside);
                let denominator = a * b - 1.0;
                [(b * x - y) / denominator, (a * y - x) / denominator]
            }
        }
    }

    fn negative(&self) -> usize {
        match *self {
            Self::One(a) => usize::from(a < 0.0),
            Self::Two(a, b, beside) => match (a / beside * (b / beside) < 1.0, a + b < 0.0) {
                (true, _) => 1,
                (false, true) => 2,
                (false, false) => 0,
            },
        }
    }
}

impl Front {
    pub(super) fn rows(&self) -> usize {
        self.lower.len() / self.columns.max(1)
    }

    /// Its panels: first column and width.
    pub(super) fn panels(&self) -> impl DoubleEndedIterator<Item = (usize, usize)> + use<> {
        let columns = self.columns;
        let panels = columns.div_ceil(PANEL);
        (0..panels).map(move |k| (k * PANEL, PANEL.min(columns - k * PANEL)))
    }

    /// A panel's diagonal block, and its rows below.
    pub(super) fn panel(&self, start: usize, width: usize) -> (MatRef<'_, f64>, MatRef<'_, f64>) {
        let columns = &self.lower[start * self.rows()..(start + width) * self.rows()];
        whole(columns, self.rows()).split_at_row(start).1.split_at_row(width)
    }

    /// Whether every pivot is a finite number other than zero.
    pub(super) fn is_regular(&self) -> bool {
        let regular = |value: f64| value.is_finite() && value != 0.0;
        self.pivots_of_all().all(|pivot| match pivot {
            Pivot::One(a) => regular(a),
            Pivot::Two(a, b, beside) => regular(a / beside * (b / beside) - 1.0),
        })
    }

    /// Negative eigenvalues of B.
    pub(super) fn negative(&self) -> usize {
        self.pivots_of_all().map(|pivot| pivot.negative()).sum()
    }

    fn pivots_of_all(&self) -> impl Iterator<Item = Pivot> + '_ {
        self.panels().flat_map(move |(start, width)| {
            let (top, _) = self.panel(start, width);
            let subdiagonal = &self.subdiagonal[start..start + width];
            let mut k = 0;
            std::iter::from_fn(move || {
                (k < width).then(|| {
                    let pivot = Pivot::at(top, subdiagonal, k);
                    k += pivot.rows();
                    pivot
                })
            })
        })
    }
}

/// One column.
pub(super) fn column_mut(values: &mut [f64]) -> MatMut<'_, f64> {
    let rows = values.len();
    MatMut::from_column_major_slice_mut(values, rows, 1)
}

/// Zeros, or the error that they do not fit.
fn zeros(length: usize, rows: usize) -> Result<Vec<f64>, StructureError> {
    let mut values = Vec::new();
    values.try_reserve_exact(length).map_err(|_| StructureError::OutOfMemory { rows })?;
    values.resize(length, 0.0);
    Ok(values)
}
