//! Freedoms that are left where linear forms are held at zero.

use crate::AssemblyError;
use crate::assembly::{from_triplets, triplets};
use crate::row::Row;
use faer::c64;
use faer::sparse::Triplet;
use judder_structure::assembly::Sparse;
use std::collections::BTreeMap;

/// All q with r q = 0 for a number of forms r, as q = B z with z the freedoms that do not follow from others.
#[derive(Debug, Clone)]
pub(crate) struct NullBasis {
    /// What each freedom takes of z.
    rows: Vec<Row>,
    size: usize,
    /// The freedom that follows from the others, of each form.
    pub(crate) dependent: Vec<usize>,
}

/// Entries below so much of the largest are rounding of eliminations.
const ROUNDING: f64 = 1e-10;
/// A wanted freedom is taken as the dependent one if its entry is not smaller than so much of the largest.
const WANTED: f64 = 0.3;

impl NullBasis {
    /// Eliminates one freedom a form, that of the largest entry, or the one that is wanted for it.
    ///
    /// The error is the number of the first form that follows from those before it.
    pub(crate) fn new(freedoms: usize, forms: &[Row], wanted: Option<&[usize]>) -> Result<Self, usize> {
        // what a dependent freedom is, in the order in which they were found: of freedoms that may become dependent later
        let mut follows: Vec<(usize, Row)> = Vec::with_capacity(forms.len());
        let mut place: BTreeMap<usize, usize> = BTreeMap::new();
        for (number, form) in forms.iter().enumerate() {
            let size = form.entries().iter().map(|(_, value)| value.abs()).fold(0.0, f64::max);
            let left = substituted(form.clone(), &follows, &place);
            let largest = left.entries().iter().fold((0, 0.0_f64), |best, (freedom, value)| {
                if value.abs() > best.1.abs() { (*freedom, *value) } else { best }
            });
            if largest.1.abs() <= ROUNDING * size {
                return Err(number);
            }
            let wanted = wanted
                .and_then(|wanted| left.entries().iter().find(|(freedom, _)| *freedom == wanted[number]));
            let (dependent, pivot) = match wanted {
                Some((freedom, value)) if value.abs() >= WANTED * largest.1.abs() => (*freedom, *value),
                _ => largest,
            };
            let others = left.entries().iter().filter(|(freedom, _)| *freedom != dependent);
            let expression = Row::new(others.map(|(freedom, value)| (*freedom, -value / pivot)).collect());
            place.insert(dependent, follows.len());
            follows.push((dependent, expression));
        }
        let mut next = 0;
        let numbers: Vec<usize> = (0..freedoms)
            .map(|freedom| {
                let own = next;
                next += usize::from(!place.contains_key(&freedom));
                own
            })
            .collect();
        let on_independent = |row: &Row| {
            Row::new(row.entries().iter().map(|(freedom, value)| (numbers[*freedom], *value)).collect())
        };
        let rows = (0..freedoms).map(|freedom| match place.get(&freedom) {
            None => Row::new(vec![(numbers[freedom], 1.0)]),
            Some(k) => on_independent(&substituted(follows[*k].1.clone(), &follows, &place)),
        });
        let dependent = follows.iter().map(|(freedom, _)| *freedom).collect();
        Ok(Self { rows: rows.collect(), size: next, dependent })
    }

    /// q = B z.
    pub(crate) fn expanded(&self, z: &[c64]) -> Vec<c64> {
        self.rows.iter().map(|row| row.of_complex(z)).collect()
    }

    /// The same of a real z.
    pub(crate) fn expanded_real(&self, z: &[f64]) -> Vec<f64> {
        self.rows.iter().map(|row| row.of(z)).collect()
    }

    /// Bᵀ f.
    pub(crate) fn transposed(&self, load: &[f64]) -> Vec<f64> {
        let mut on_left = vec![0.0; self.size];
        for (row, force) in self.rows.iter().zip(load) {
            row.add_to(*force, &mut on_left);
        }
        on_left
    }

    /// r B.
    pub(crate) fn form(&self, row: &Row) -> Row {
        Row::sum(row.entries().iter().map(|(freedom, value)| (*value, &self.rows[*freedom])))
    }

    /// The freedom that the component `z` is.
    pub(crate) fn freedom(&self, z: usize) -> usize {
        let own = |row: &Row| row.entries() == [(z, 1.0)];
        let is_dependent = |freedom: &usize| self.dependent.contains(freedom);
        let mut all = (0..self.rows.len()).filter(|freedom| own(&self.rows[*freedom]));
        all.find(|freedom| !is_dependent(freedom)).unwrap_or(z)
    }

    /// Lᵀ A R of two bases of the same freedoms.
    pub(crate) fn projected(left: &Self, matrix: &Sparse, right: &Self) -> Result<Sparse, AssemblyError> {
        if left.dependent.is_empty() && right.dependent.is_empty() {
            return Ok(matrix.clone());
        }
        let mut entries = Vec::new();
        for Triplet { row, col, val } in triplets(matrix) {
            for (a, by_left) in left.rows[row].entries() {
                for (b, by_right) in right.rows[col].entries() {
                    entries.push(Triplet::new(*a, *b, by_left * val * by_right));
                }
            }
        }
        from_triplets(left.size, right.size, &entries)
    }
}

/// A form without dependent freedoms.
fn substituted(mut form: Row, follows: &[(usize, Row)], place: &BTreeMap<usize, usize>) -> Row {
    // an expression names only freedoms that are independent, or became dependent after it
    while let Some((k, value)) = form
        .entries()
        .iter()
        .filter_map(|(freedom, value)| place.get(freedom).map(|k| (*k, *value)))
        .min_by_key(|(k, _)| *k)
    {
        let (dependent, expression) = &follows[k];
        let without = Row::new(vec![(*dependent, value)]);
        form = Row::sum([(1.0, &form), (-1.0, &without), (value, expression)]);
    }
    form
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_combination_of_the_basis_meets_every_form() {
        let forms = [
            Row::new(vec![(0, 1.0), (3, -0.5), (4, -0.5)]),
            Row::new(vec![(3, 1.0), (4, 0.2), (1, 0.1)]),
            Row::new(vec![(4, 0.3), (0, 2.0), (2, 1.0)]),
        ];
        let basis = NullBasis::new(6, &forms, None).unwrap();
        assert_eq!((basis.size, basis.dependent.len()), (3, 3));
        for k in 0..basis.size {
            let z: Vec<c64> = (0..basis.size).map(|j| c64::new(f64::from(u8::from(j == k)), 0.0)).collect();
            let q = basis.expanded(&z);
            assert!(forms.iter().all(|form| form.of_complex(&q).norm() < 1e-15));
        }
    }

    #[test]
    fn a_form_that_follows_from_others_is_named() {
        let first = Row::new(vec![(0, 1.0), (1, -1.0)]);
        let second = Row::new(vec![(1, 1.0), (2, -1.0)]);
        let third = Row::sum([(1.0, &first), (1.0, &second)]);
        assert_eq!(NullBasis::new(3, &[first, second, third], None).unwrap_err(), 2);
    }
}
