//! Linear forms on the freedoms of an assembly.

use faer::c64;

/// A linear form: what it takes of each freedom, the freedoms ascending; of those that it does not name, nothing.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Row {
    entries: Vec<(usize, f64)>,
}

impl Row {
    /// The form with these entries; those of one freedom are added.
    #[must_use]
    pub fn new(mut entries: Vec<(usize, f64)>) -> Self {
        entries.sort_by_key(|(freedom, _)| *freedom);
        let mut merged: Vec<(usize, f64)> = Vec::with_capacity(entries.len());
        for (freedom, value) in entries {
            match merged.last_mut() {
                Some(last) if last.0 == freedom => last.1 += value,
                _ => merged.push((freedom, value)),
            }
        }
        merged.retain(|(_, value)| *value != 0.0);
        Self { entries: merged }
    }

    /// A freedom itself.
    #[must_use]
    pub fn of_freedom(freedom: usize) -> Self {
        Self { entries: vec![(freedom, 1.0)] }
    }

    /// Σ fᵢ rᵢ.
    #[must_use]
    pub fn sum<'a>(parts: impl IntoIterator<Item = (f64, &'a Self)>) -> Self {
        let scaled = |(factor, row): (f64, &'a Self)| {
            row.entries.iter().map(move |(freedom, value)| (*freedom, factor * value))
        };
        Self::new(parts.into_iter().flat_map(scaled).collect())
    }

    /// Freedoms and what is taken of them.
    #[must_use]
    pub fn entries(&self) -> &[(usize, f64)] {
        &self.entries
    }

    /// Whether it takes nothing.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }

    /// r q.
    #[must_use]
    pub fn of(&self, q: &[f64]) -> f64 {
        self.entries.iter().map(|(freedom, value)| value * q[*freedom]).sum()
    }

    /// r q of a complex shape.
    #[must_use]
    pub fn of_complex(&self, q: &[c64]) -> c64 {
        self.entries.iter().map(|(freedom, value)| q[*freedom] * *value).sum()
    }

    /// Adds f rᵀ to a vector.
    pub fn add_to(&self, factor: f64, vector: &mut [f64]) {
        for (freedom, value) in &self.entries {
            vector[*freedom] += factor * value;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn entries_of_one_freedom_are_added_and_zeros_go() {
        let row = Row::new(vec![(3, 1.0), (0, 2.0), (3, -1.0), (1, 0.5)]);
        assert_eq!(row.entries(), [(0, 2.0), (1, 0.5)]);
        let doubled = Row::sum([(2.0, &row), (1.0, &Row::new(vec![(1, -1.0)]))]);
        assert_eq!(doubled.entries(), [(0, 4.0)]);
        assert_eq!(row.of(&[1.0, 2.0, 9.0, 9.0]), 3.0);
    }
}
