//! The numbers of a height file.

use super::error::HeightsError;

/// Steps of one coordinate, and steps along x and y, may differ by this part of themselves: files hold rounded numbers.
pub(super) const EQUAL: f64 = 1e-4;

/// A matrix of heights as a file holds it: row-major with x fastest, in the file's own length unit.
#[derive(Debug, Clone, PartialEq)]
pub struct HeightTable {
    /// Heights along x.
    pub columns: usize,
    /// Heights along y.
    pub rows: usize,
    /// The heights, `rows` × `columns`; NaN where one is masked.
    pub heights: Vec<f64>,
    /// The distance of neighbouring heights where the file has coordinates, in the file's length unit.
    pub spacing: Option<f64>,
}

impl HeightTable {
    /// The distance of neighbouring heights \[m\]; `unit` is the length for which the file writes 1 \[m\], `given` what the caller
    /// says of the distance \[m\].
    ///
    /// # Errors
    /// [`HeightsError::SpacingMissing`], [`HeightsError::SpacingDisagrees`], [`HeightsError::Unit`] for a unit that is not
    /// positive and finite.
    pub fn spacing_in_metres(&self, unit: f64, given: Option<f64>) -> Result<f64, HeightsError> {
        if !(unit > 0.0 && unit.is_finite()) {
            return Err(HeightsError::Unit { value: unit });
        }
        match (self.spacing.map(|step| step * unit), given) {
            (None, None) => Err(HeightsError::SpacingMissing),
            (Some(in_file), Some(given)) if (in_file - given).abs() > EQUAL * given.abs() => {
                Err(HeightsError::SpacingDisagrees { in_file, given })
            }
            (_, Some(spacing)) | (Some(spacing), None) => Ok(spacing),
        }
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
        assert_eq!(table(Some(3.0)).spacing_in_metres(1e-6, None), Ok(3.0 * 1e-6));
        assert_eq!(table(None).spacing_in_metres(1e-6, Some(2e-6)), Ok(2e-6));
        assert_eq!(table(None).spacing_in_metres(1.0, None), Err(HeightsError::SpacingMissing));
    }

    #[test]
    fn contradicting_spacings_are_refused() {
        let error = table(Some(3.0)).spacing_in_metres(1.0, Some(2.0)).unwrap_err();
        assert_eq!(error, HeightsError::SpacingDisagrees { in_file: 3.0, given: 2.0 });
        assert_eq!(table(Some(3.0)).spacing_in_metres(-1.0, None), Err(HeightsError::Unit { value: -1.0 }));
    }
}
