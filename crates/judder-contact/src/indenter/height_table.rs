//! The numbers of a height-map file before they become a map.

use super::error::IndenterError;
use super::height_map::HeightMap;

/// Steps of one coordinate, and steps along x and y, may differ by this part of themselves: files hold rounded numbers.
pub(super) const EQUAL: f64 = 1e-4;

/// A matrix of heights as a file holds it: row-major with x fastest, in the file's own length unit.
#[derive(Debug, Clone, PartialEq)]
pub struct HeightTable {
    /// Heights along x.
    pub columns: usize,
    /// Heights along y.
    pub rows: usize,
    /// The heights, `rows` × `columns`.
    pub heights: Vec<f64>,
    /// The distance of neighbouring heights where the file has coordinates, in the file's length unit.
    pub spacing: Option<f64>,
}

impl HeightTable {
    /// The map that the table describes, in m; `unit` is the length for which the file writes 1, `spacing` what the caller says
    /// of it \[m\].
    ///
    /// # Errors
    /// [`IndenterError::SpacingMissing`] and [`IndenterError::SpacingDisagrees`], and everything that
    /// [`HeightMap::new`] refuses.
    pub fn into_map(
        self,
        unit: f64,
        spacing: Option<f64>,
        periodic: bool,
    ) -> Result<HeightMap, IndenterError> {
        if !(unit > 0.0 && unit.is_finite()) {
            return Err(IndenterError::NotPositive { what: "length unit of the heights", value: unit });
        }
        let in_file = self.spacing.map(|step| step * unit);
        let spacing = match (in_file, spacing) {
            (None, None) => return Err(IndenterError::SpacingMissing),
            (Some(in_file), Some(given)) if (in_file - given).abs() > EQUAL * given.abs() => {
                return Err(IndenterError::SpacingDisagrees { in_file, given });
            }
            (_, Some(given)) => given,
            (Some(in_file), None) => in_file,
        };
        let heights = self.heights.iter().map(|height| height * unit).collect();
        HeightMap::new(heights, self.columns, self.rows, spacing, periodic)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table(spacing: Option<f64>) -> HeightTable {
        HeightTable { columns: 4, rows: 4, heights: vec![1.0; 16], spacing }
    }

    #[test]
    fn spacing_comes_from_the_file_or_the_caller() {
        assert_eq!(table(Some(3.0)).into_map(1e-6, None, false).unwrap().spacing(), 3.0 * 1e-6);
        assert_eq!(table(None).into_map(1e-6, Some(2e-6), false).unwrap().spacing(), 2e-6);
        assert_eq!(table(None).into_map(1.0, None, false), Err(IndenterError::SpacingMissing));
    }

    #[test]
    fn contradicting_spacings_are_refused() {
        let error = table(Some(3.0)).into_map(1.0, Some(2.0), false).unwrap_err();
        assert_eq!(error, IndenterError::SpacingDisagrees { in_file: 3.0, given: 2.0 });
        let unit = table(Some(3.0)).into_map(-1.0, None, false);
        assert!(matches!(unit, Err(IndenterError::NotPositive { .. })));
    }
}
