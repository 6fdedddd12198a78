//! Where the search for modes begins: the shift, and what lies below it.

use super::lanczos::nearest;
use super::{Pencil, WantedModes, shift_scale};
use crate::StructureError;
use crate::factor::{FactorPattern, SymmetricFactor};
use crate::rigid::{largest_ratio, rigid_limit};
use std::f64::consts::TAU;

/// A mode this share of λ beside an edge of the band is in it: frequencies that are those of modes are told with rounding.
const EDGE: f64 = 1e-9;
/// Share of the band within which no eigenvalue may lie beside the shift: the operator's range would leave the others no digits.
const NEAR: f64 = 1e-6;
/// Share of the band by which a shift that is too near an eigenvalue moves down.
const STEP: f64 = 1e-3;
/// Shifts that are tried.
const TRIES: usize = 8;

/// A shift σ with the factors of K − σ M. The modes above it are searched.
pub(super) struct ShiftedStart {
    pub(super) shift: f64,
    pub(super) factor: SymmetricFactor,
    pub(super) pattern: FactorPattern,
    /// Eigenvalues below the shift.
    pub(super) below: usize,
    /// A value below the first wanted mode and how many eigenvalues lie below it.
    pub(super) counted: (f64, usize),
    /// Up to where eigenvalues are those of rigid motions.
    pub(super) rigid_limit: f64,
}

impl ShiftedStart {
    pub(super) fn new(pencil: &Pencil<'_>, wanted: WantedModes) -> Result<Self, StructureError> {
        let FirstShift { shift: from, band, rigid_limit } = FirstShift::new(pencil, wanted)?;
        let at_shift = pencil.shifted(from)?;
        let pattern = FactorPattern::new(&at_shift)?;
        let factor = SymmetricFactor::with_pattern(&pattern, &at_shift)?;
        let below = factor.negative_eigenvalues();
        if band.is_none() {
            admit_below(below, pencil)?;
        }
        let mut start = Self { shift: from, factor, pattern, below, counted: (from, below), rigid_limit };
        let Some(band) = band else { return Ok(start) };
        for _ in 0..TRIES {
            if nearest(&start.factor, pencil.mass) > NEAR * band {
                break;
            }
            start.shift -= STEP * band;
            start.factor = SymmetricFactor::with_pattern(&start.pattern, &pencil.shifted(start.shift)?)?;
            start.below = start.factor.negative_eigenvalues();
        }
        Ok(start)
    }
}

/// The first shift that is tried.
struct FirstShift {
    shift: f64,
    /// How wide the band above it is, where modes below are passed over; none from zero on.
    band: Option<f64>,
    rigid_limit: f64,
}

impl FirstShift {
    fn new(pencil: &Pencil<'_>, wanted: WantedModes) -> Result<Self, StructureError> {
        let scale = shift_scale(pencil.stiffness, pencil.mass)?;
        let largest = largest_ratio(pencil.stiffness, pencil.mass);
        let rigid_limit = rigid_limit(pencil.stiffness.nrows(), largest);
        if let WantedModes::Band(from, to) = wanted {
            let (name, requirement) = ("the band's end in Hz", "finite and above its start");
            if !(to.is_finite() && from < to) {
                return Err(StructureError::InvalidNumber { name, value: to, requirement });
            }
        }
        let (shift, band) = match wanted {
            WantedModes::Band(from, to) if from > 0.0 => {
                // above what rounding makes of zero: rigid motions have no frequency
                let from = ((1.0 - EDGE) * (TAU * from).powi(2)).max(rigid_limit);
                (from, Some((upper_edge(to) - from).max(0.0)))
            }
            _ => (-scale, None),
        };
        Ok(Self { shift, band, rigid_limit })
    }
}

/// Refuses what a search from zero would pass over: eigenvalues below the shift, so many.
fn admit_below(negative: usize, pencil: &Pencil<'_>) -> Result<(), StructureError> {
    match negative {
        0 => Ok(()),
        negative => Err(StructureError::IndefiniteStiffness { negative, size: pencil.stiffness.nrows() }),
    }
}

/// Refuses what [`ShiftedStart::new`] would refuse, as far as a factorisation of no more multiplications than so many tells.
pub(super) fn admit_start(
    pencil: &Pencil<'_>,
    wanted: WantedModes,
    most_operations: f64,
) -> Result<(), StructureError> {
    let FirstShift { shift, band, .. } = FirstShift::new(pencil, wanted)?;
    let at_shift = pencil.shifted(shift)?;
    let pattern = FactorPattern::new(&at_shift)?;
    if pattern.operations() > most_operations {
        return Ok(());
    }
    let below = pattern.negative_eigenvalues(&at_shift)?;
    if band.is_none() { admit_below(below, pencil) } else { Ok(()) }
}

/// The eigenvalue up to which modes are in a band that ends at a frequency in Hz.
pub(super) fn upper_edge(to: f64) -> f64 {
    (1.0 + EDGE) * (TAU * to).powi(2)
}
