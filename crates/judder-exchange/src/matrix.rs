//! Sparse matrices of other programs.

mod coordinate_text;
mod mat_file;
mod mat_hdf5;
mod mat_matrix;
pub mod matrix_market;
mod npz;

pub use crate::triangle::Triangle;

use crate::cause::FileCause;
use crate::door::bytes_of;
use crate::error::ExchangeError;
use faer::sparse::{SparseColMat, Triplet};
use judder_memory::MemoryBudget;
use judder_structure::assembly::Sparse;
use std::path::Path;

/// A sparse real matrix as it was read.
#[derive(Debug, Clone, PartialEq)]
pub struct Matrix {
    /// Rows.
    pub rows: usize,
    /// Columns.
    pub columns: usize,
    /// Row and column from 0 and the entry: sorted by row, then column; each place once, several entries of a file at one place
    /// are summed.
    pub entries: Vec<(usize, usize, f64)>,
    /// What the storage of the file said; the entries are those of the whole matrix.
    pub symmetry: Symmetry,
}

/// What the storage of a matrix says about its entries.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Symmetry {
    /// Every entry stands in the file.
    General,
    /// A = Aᵀ: one triangle stood in the file.
    Symmetric,
    /// A = −Aᵀ: one triangle stood in the file.
    SkewSymmetric,
}

/// The most rows and columns: far beyond what is solved here, and its column pointers still fit into memory.
const MOST_ROWS: usize = 1 << 26;

/// Bytes that an entry takes while a matrix is read: row, column and value, and half as much while they are sorted.
const ENTRY_BYTES: u128 = 36;

/// What they are called where there is no room for them.
const ENTRIES: &str = "the entries of the matrix";

const EXTENSIONS: &str = ".mtx (Matrix Market, coordinates of Abaqus), .mat (MATLAB), .npz (scipy.sparse)";

/// Reads a whole matrix; the extension of the file tells the format.
///
/// - `.mtx`: Matrix Market, coordinate or array, real or integer, general, symmetric or skew-symmetric; without its header line the
///   coordinates of Abaqus (`*MATRIX OUTPUT, FORMAT=COORDINATE`): row, column and entry a line.
/// - `.mat`: MATLAB v5 to v7 and v7.3 (HDF5), one real matrix, sparse or full.
/// - `.npz`: `scipy.sparse.save_npz` of CSR, CSC, BSR, COO or DIA.
///
/// # Errors
/// What is wrong with the file and where; [`FileCause::OneTriangle`] for a square matrix that is said to be whole and has entries
/// on one side of its diagonal only: read those by [`read_stored_matrix`].
pub fn read_matrix(path: &Path) -> Result<Matrix, ExchangeError> {
    let matrix = read_stored_matrix(path)?;
    matrix.check_whole().map_err(|error| error.in_file(path))?;
    Ok(matrix)
}

/// Reads a matrix as [`read_matrix`] does, with whatever is stored: for matrices that are triangular, and for triangles of
/// symmetric ones, to be [mirrored](Matrix::mirrored).
///
/// # Errors
/// What is wrong with the file and where.
pub fn read_stored_matrix(path: &Path) -> Result<Matrix, ExchangeError> {
    let extension =
        path.extension().and_then(|extension| extension.to_str()).unwrap_or("").to_ascii_lowercase();
    let read: fn(&[u8], MemoryBudget) -> Result<Matrix, ExchangeError> = match extension.as_str() {
        "mtx" => read_mtx,
        "mat" => mat_file::read_mat,
        "npz" => npz::read_npz,
        _ => {
            let cause = FileCause::UnknownExtension { found: extension, known: EXTENSIONS };
            return Err(ExchangeError::from(cause).in_file(path));
        }
    };
    let budget = MemoryBudget::of_process();
    let bytes = bytes_of(path, 1, budget)?;
    read(&bytes, budget).map_err(|error| error.in_file(path))
}

fn read_mtx(bytes: &[u8], budget: MemoryBudget) -> Result<Matrix, ExchangeError> {
    let bytes = bytes.strip_prefix(BYTE_ORDER_MARK).unwrap_or(bytes);
    if bytes.get(..2).is_some_and(|start| start == b"%%") {
        matrix_market::read_matrix_market(bytes, budget)
    } else {
        coordinate_text::read_coordinates(bytes, budget)
    }
}

/// What some editors put before text in UTF-8.
const BYTE_ORDER_MARK: &[u8] = "\u{feff}".as_bytes();

impl Matrix {
    /// The whole matrix of the entries of a file, which are finite and within its size.
    pub(crate) fn from_stored(
        rows: usize,
        columns: usize,
        mut entries: Vec<(usize, usize, f64)>,
        symmetry: Symmetry,
    ) -> Result<Self, ExchangeError> {
        if rows.max(columns) > MOST_ROWS {
            return Err(FileCause::TooLarge { rows, columns, most: MOST_ROWS }.into());
        }
        if symmetry != Symmetry::General {
            expand(rows, columns, &mut entries, symmetry)?;
        }
        // stable: entries at one place are summed in their order
        entries.sort_by_key(|(row, column, _)| (*row, *column));
        entries.dedup_by(|next, kept| {
            let same = (next.0, next.1) == (kept.0, kept.1);
            if same {
                kept.2 += next.2;
            }
            same
        });
        match entries.iter().find(|(_, _, value)| !value.is_finite()) {
            Some((row, column, value)) => Err(FileCause::Inconsistent {
                what: "the entries at one place",
                problem: format!("those at row {}, column {} (from 1) sum to {value}", row + 1, column + 1),
            }
            .into()),
            None => Ok(Self { rows, columns, entries, symmetry }),
        }
    }

    /// A matrix of judder, with its symmetry as its entries have it to the last bit.
    #[must_use]
    pub fn from_sparse(sparse: &Sparse) -> Self {
        let mut entries: Vec<(usize, usize, f64)> =
            sparse.triplet_iter().map(|entry| (entry.row, entry.col, *entry.val)).collect();
        entries.sort_by_key(|(row, column, _)| (*row, *column));
        let symmetry = Symmetry::General;
        let mut matrix = Self { rows: sparse.nrows(), columns: sparse.ncols(), entries, symmetry };
        if matrix.asymmetry() == 0.0 {
            matrix.symmetry = Symmetry::Symmetric;
        } else if matrix.skew_asymmetry() == 0.0 {
            matrix.symmetry = Symmetry::SkewSymmetric;
        }
        matrix
    }

    /// The triangle that has all the entries beside the diagonal; none where both have some, or neither, or the matrix is not
    /// square.
    #[must_use]
    pub fn triangle(&self) -> Option<Triangle> {
        let below = self.beside(Triangle::Lower).count();
        let above = self.beside(Triangle::Upper).count();
        match (self.rows == self.columns, below, above) {
            (true, 1.., 0) => Some(Triangle::Lower),
            (true, 0, 1..) => Some(Triangle::Upper),
            _ => None,
        }
    }

    /// The symmetric matrix of which this one holds the named triangle: entries beside the diagonal are repeated on the other
    /// side.
    ///
    /// # Errors
    /// [`FileCause::NotSquare`], and [`FileCause::NotThatTriangle`] where the other side is not empty.
    pub fn mirrored(self, triangle: Triangle) -> Result<Self, ExchangeError> {
        let other = if triangle == Triangle::Lower { Triangle::Upper } else { Triangle::Lower };
        if let Some((row, column, _)) = self.beside(other).next() {
            return Err(FileCause::NotThatTriangle { triangle, row: row + 1, column: column + 1 }.into());
        }
        Self::from_stored(self.rows, self.columns, self.entries, Symmetry::Symmetric)
    }

    /// max |A − Aᵀ| / max |A|: zero for a symmetric matrix, 2 for a skew-symmetric one; of a matrix that is not square infinite.
    #[must_use]
    pub fn asymmetry(&self) -> f64 {
        self.departure(1.0)
    }

    /// max |A + Aᵀ| / max |A|: zero for a skew-symmetric matrix, 2 for a symmetric one; of a matrix that is not square infinite.
    #[must_use]
    pub fn skew_asymmetry(&self) -> f64 {
        self.departure(-1.0)
    }

    /// The matrix as the structures have it.
    ///
    /// # Errors
    /// [`FileCause::OutsideMatrix`] for an entry that was put outside.
    pub fn to_sparse(&self) -> Result<Sparse, ExchangeError> {
        let (rows, columns) = (self.rows, self.columns);
        if let Some((row, column, _)) = self.entries.iter().find(|(i, j, _)| *i >= rows || *j >= columns) {
            return Err(FileCause::OutsideMatrix { row: row + 1, column: column + 1, rows, columns }.into());
        }
        let triplets: Vec<Triplet<usize, usize, f64>> =
            self.entries.iter().map(|(row, column, value)| Triplet::new(*row, *column, *value)).collect();
        SparseColMat::try_new_from_triplets(rows, columns, &triplets).map_err(|error| {
            FileCause::Inconsistent { what: "the matrix", problem: error.to_string() }.into()
        })
    }

    fn check_whole(&self) -> Result<(), ExchangeError> {
        match self.triangle() {
            Some(triangle) if self.symmetry == Symmetry::General => {
                Err(FileCause::OneTriangle { triangle, entries: self.beside(triangle).count() }.into())
            }
            _ => Ok(()),
        }
    }

    /// The entries of one side that are not zero.
    fn beside(&self, triangle: Triangle) -> impl Iterator<Item = &(usize, usize, f64)> {
        self.entries.iter().filter(move |(row, column, value)| {
            *value != 0.0 && if triangle == Triangle::Lower { row > column } else { column > row }
        })
    }

    fn at(&self, row: usize, column: usize) -> f64 {
        let found = self.entries.binary_search_by_key(&(row, column), |(i, j, _)| (*i, *j));
        found.map_or(0.0, |place| self.entries[place].2)
    }

    fn departure(&self, sign: f64) -> f64 {
        if self.rows != self.columns {
            return f64::INFINITY;
        }
        let largest = self.entries.iter().map(|(_, _, value)| value.abs()).fold(0.0, f64::max);
        let departures = self.entries.iter().map(|(i, j, value)| (value - sign * self.at(*j, *i)).abs());
        if largest == 0.0 { 0.0 } else { departures.fold(0.0, f64::max) / largest }
    }
}

/// Adds the other side of a matrix that is stored as one triangle.
fn expand(
    rows: usize,
    columns: usize,
    entries: &mut Vec<(usize, usize, f64)>,
    symmetry: Symmetry,
) -> Result<(), FileCause> {
    if rows != columns {
        return Err(FileCause::NotSquare { name: String::from("the matrix"), rows, columns });
    }
    let (name, sign) =
        if symmetry == Symmetry::Symmetric { ("symmetric", 1.0) } else { ("skew-symmetric", -1.0) };
    let mut beside = entries.iter().filter(|(row, column, _)| row != column);
    if let Some((row, column, _)) = beside.next()
        && let Some((i, j, _)) = beside.find(|(i, j, _)| (i > j) != (row > column))
    {
        return Err(FileCause::BothTriangles { symmetry: name, row: i + 1, column: j + 1 });
    }
    if symmetry == Symmetry::SkewSymmetric
        && let Some((row, _, value)) = entries.iter().find(|(i, j, value)| i == j && *value != 0.0)
    {
        return Err(FileCause::SkewDiagonal { row: row + 1, value: *value });
    }
    let mirrored =
        |(row, column, value): &(usize, usize, f64)| (row != column).then_some((*column, *row, sign * value));
    let other: Vec<_> = entries.iter().filter_map(mirrored).collect();
    entries.extend(other);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn general(entries: &[(usize, usize, f64)]) -> Matrix {
        Matrix::from_stored(2, 2, entries.to_vec(), Symmetry::General).unwrap()
    }

    #[test]
    fn entries_at_one_place_are_summed() {
        let matrix = general(&[(1, 0, 1.0), (0, 0, 2.0), (1, 0, 3.0)]);
        assert_eq!(matrix.entries, [(0, 0, 2.0), (1, 0, 4.0)]);
        let too_large = Matrix::from_stored(1, 1, vec![(0, 0, f64::MAX); 2], Symmetry::General);
        assert!(matches!(too_large.unwrap_err().cause(), FileCause::Inconsistent { .. }));
    }

    #[test]
    fn one_triangle_is_told_and_mirrored() {
        let lower = general(&[(0, 0, 2.0), (1, 0, 1.0), (1, 1, 3.0)]);
        assert_eq!(lower.triangle(), Some(Triangle::Lower));
        let message = lower.check_whole().unwrap_err().to_string();
        assert!(message.contains("triangle = \"lower\""), "{message}");
        let wrong = lower.clone().mirrored(Triangle::Upper).unwrap_err();
        assert!(matches!(wrong.cause(), FileCause::NotThatTriangle { row: 2, column: 1, .. }));
        let whole = lower.mirrored(Triangle::Lower).unwrap();
        assert_eq!(whole.entries, [(0, 0, 2.0), (0, 1, 1.0), (1, 0, 1.0), (1, 1, 3.0)]);
        assert_eq!((whole.triangle(), whole.asymmetry(), whole.skew_asymmetry()), (None, 0.0, 2.0));
        general(&[(0, 0, 1.0), (1, 1, 1.0)]).check_whole().unwrap();
    }

    #[test]
    fn sparse_matrices_have_the_entries() {
        let sparse = general(&[(0, 1, -1.0), (1, 0, 1.0)]).to_sparse().unwrap();
        assert_eq!(Matrix::from_sparse(&sparse).symmetry, Symmetry::SkewSymmetric);
        assert_eq!((sparse.get(0, 1), sparse.get(1, 0), sparse.get(0, 0)), (Some(&-1.0), Some(&1.0), None));
    }
}
