//! What a kernel can be computed for.

use super::substrate::SlidingSubstrate;
use crate::surface::grid::SurfaceGrid;
use judder_numerics::words::plain;
use thiserror::Error;

/// The least thickness of a layer, in cells: the product rules of the wake's kernel resolve a tenth of a cell.
pub(super) const THINNEST: f64 = 0.1;

/// Why there is no operator for a grid and a substrate.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum KernelError {
    /// The grid has no cells.
    #[error("the grid has {columns} × {rows} cells, and needs at least one each way")]
    NoCells {
        /// Cells along x.
        columns: usize,
        /// Cells along y.
        rows: usize,
    },
    /// The side of a cell is not a length.
    #[error("the side of a cell is {cell}, and must be positive and finite")]
    Cell {
        /// h.
        cell: f64,
    },
    /// The instantaneous compliance is not one.
    #[error("the instantaneous compliance E0/E∞ is {value}, and must be finite and not negative")]
    Instantaneous {
        /// E0/E∞.
        value: f64,
    },
    /// A term's compliance is not one.
    #[error("the compliance of term {term} is {value}, and must be finite and not negative")]
    Compliance {
        /// Which term, from 0.
        term: usize,
        /// C_k E0.
        value: f64,
    },
    /// A term's length is not one.
    #[error("the wake of term {term} is {value} long, and must be finite and not negative")]
    Length {
        /// Which term, from 0.
        term: usize,
        /// ℓ_k.
        value: f64,
    },
    /// The substrate does not yield at all.
    #[error("the substrate is rigid: all its compliances are zero")]
    Rigid,
    /// The operator takes more memory than allowed.
    #[error(
        "{columns} × {rows} cells take {:.2} GiB of memory, and {:.2} GiB are allowed; take fewer cells, or allow more memory",
        gibibytes(*needed), gibibytes(*allowed)
    )]
    Memory {
        /// Cells along x.
        columns: usize,
        /// Cells along y.
        rows: usize,
        /// Bytes needed.
        needed: u64,
        /// Bytes allowed.
        allowed: u64,
    },
    /// A line contact on a grid of several rows.
    #[error("a line contact has one row of cells, not {rows}")]
    Rows {
        /// Cells along y.
        rows: usize,
    },
    /// The reference distance of a line contact is not a length.
    #[error("the reference distance of a line contact is {value}, and must be positive and finite")]
    Reference {
        /// The distance.
        value: f64,
    },
    /// The thickness of a layer is not a length.
    #[error("the thickness of the layer is {value}, and must be positive and finite")]
    Thickness {
        /// h.
        value: f64,
    },
    /// No layer has this Poisson's ratio.
    #[error("Poisson's ratio of the layer is {value}, and must lie between -1 and 1/2")]
    PoissonRatio {
        /// ν.
        value: f64,
    },
    /// A layer under cells that are squares.
    #[error(
        "a layer of finite thickness is known for line contacts alone, and this one has {rows} rows of cells"
    )]
    LayerOfRows {
        /// Cells along y.
        rows: usize,
    },
    /// A line contact on a layer that is given a reference distance.
    #[error("the surface of a layer has a place at rest: its line contact takes no reference distance")]
    LayerWithReference,
    /// A layer much thinner than a cell.
    #[error(
        "the layer is {} of a cell thick, and at least {THINNEST} is needed: the contact is far wider than the layer is thick", plain(*thickness)
    )]
    ThinLayer {
        /// h over the side of a cell.
        thickness: f64,
    },
    /// Wakes reach from one period into the next.
    #[error(
        "after one period the substrate still remembers {memory} of its deformation, and at most {allowed} is allowed: the \
         longest wake v τ is {:.2} of the period; slide slower, or take a longer period", length / period, memory = plain(*.memory), allowed = plain(*.allowed),
    )]
    LongWake {
        /// L, period along x.
        period: f64,
        /// The longest of the ℓ_k.
        length: f64,
        /// Σ C_k E0 e^{−L/ℓ_k} over the relaxed compliance.
        memory: f64,
        /// The largest memory allowed.
        allowed: f64,
    },
}

/// Bytes in the unit in which messages tell memory.
pub(crate) fn gibibytes(bytes: u64) -> f64 {
    bytes as f64 / f64::from(1 << 30)
}

/// Checks that a grid and a substrate have a kernel.
///
/// # Errors
/// The first thing found that is not a number in its range.
pub(super) fn check(grid: &SurfaceGrid, substrate: &SlidingSubstrate) -> Result<(), KernelError> {
    let (columns, rows) = (grid.columns, grid.rows);
    if columns == 0 || rows == 0 {
        return Err(KernelError::NoCells { columns, rows });
    }
    if !(grid.cell > 0.0 && grid.cell.is_finite()) {
        return Err(KernelError::Cell { cell: grid.cell });
    }
    check_substrate(substrate)
}

fn check_substrate(substrate: &SlidingSubstrate) -> Result<(), KernelError> {
    let sound = |value: f64| value >= 0.0 && value.is_finite();
    if !sound(substrate.instantaneous) {
        return Err(KernelError::Instantaneous { value: substrate.instantaneous });
    }
    for (term, wake) in substrate.terms.iter().enumerate() {
        if !sound(wake.compliance) {
            return Err(KernelError::Compliance { term, value: wake.compliance });
        }
        if !sound(wake.length) {
            return Err(KernelError::Length { term, value: wake.length });
        }
    }
    if substrate.relaxed() > 0.0 { Ok(()) } else { Err(KernelError::Rigid) }
}
