//! The friction coefficient against the slip speed, and what tables of this crate must be.

use crate::AssemblyError;
pub use judder_contact::friction::{FallingFriction, Friction, FrictionAt, TableInterpolation, ValueTable};
use judder_contact::table::{TableFault, check_places};

/// The number of the piece of a table at a place; a corner belongs to the piece above it.
pub(crate) fn piece_of(places: &[f64], at: f64) -> usize {
    places.partition_point(|place| *place <= at)
}

/// Whether a table has as many values as places, and these ascend; the first name is that of the places.
///
/// # Errors
/// [`AssemblyError::Length`], [`AssemblyError::InvalidNumber`].
pub fn check_table(
    [name, of_values]: [&'static str; 2],
    places: &[f64],
    values: usize,
) -> Result<(), AssemblyError> {
    check_places(places, values).map_err(|fault| match fault {
        TableFault::Lengths { places, values } => {
            AssemblyError::Length { name: of_values, found: values, expected: places.max(1) }
        }
        TableFault::NotFinite(value) => AssemblyError::InvalidNumber { name, value, requirement: "finite" },
        TableFault::NotAscending { place, .. } => {
            AssemblyError::InvalidNumber { name, value: place, requirement: "above the one before" }
        }
    })
}
