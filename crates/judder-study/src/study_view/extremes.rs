//! The smallest and the largest values of bins of rows.

use judder_numerics::complex::ElementaryComplex;
use judder_store::VariableValues;
use num_complex::Complex64;
use std::cmp::Ordering;
use std::ops::Range;

/// Rows in bins, of each of which the extremes are kept, column by column.
pub(super) struct BinnedExtremes {
    rows: Range<usize>,
    bins: usize,
    width: usize,
    found: Option<FoundExtremes>,
}

/// Smallest and largest of every bin and column.
enum FoundExtremes {
    F64(Vec<Option<[f64; 2]>>),
    Complex(Vec<Option<[Complex64; 2]>>),
    I64(Vec<Option<[i64; 2]>>),
    U8(Vec<Option<[u8; 2]>>),
    Text(Vec<Option<[String; 2]>>),
}

impl BinnedExtremes {
    /// Of so many bins of about the same length, with `width` values a row.
    pub(super) fn new(rows: Range<usize>, bins: usize, width: usize) -> Self {
        Self { rows, bins: bins.max(1), width, found: None }
    }

    /// Takes the rows from `start` on; their values are of one type each time.
    pub(super) fn add(&mut self, start: usize, data: VariableValues) {
        let places = self.bins * self.width;
        let found = self.found.get_or_insert_with(|| match data {
            VariableValues::F64(_) => FoundExtremes::F64(vec![None; places]),
            VariableValues::Complex(_) => FoundExtremes::Complex(vec![None; places]),
            VariableValues::I64(_) => FoundExtremes::I64(vec![None; places]),
            VariableValues::U8(_) => FoundExtremes::U8(vec![None; places]),
            VariableValues::Text(_) => FoundExtremes::Text(vec![None; places]),
        });
        let place = |index: usize| {
            let row = start + index / self.width - self.rows.start;
            // the bins' ends are ⌊k · rows/bins⌋
            let bin = ((row + 1) * self.bins - 1) / self.rows.len();
            bin * self.width + index % self.width
        };
        match (found, data) {
            (FoundExtremes::F64(found), VariableValues::F64(values)) => {
                widen(found, values, place, of_numbers);
            }
            (FoundExtremes::Complex(found), VariableValues::Complex(values)) => {
                widen(found, values, place, |a, b| of_numbers(&a.modulus(), &b.modulus()));
            }
            (FoundExtremes::I64(found), VariableValues::I64(values)) => widen(found, values, place, Ord::cmp),
            (FoundExtremes::U8(found), VariableValues::U8(values)) => widen(found, values, place, Ord::cmp),
            // labels have no size: the first and the last stay
            (FoundExtremes::Text(found), VariableValues::Text(values)) => {
                widen(found, values, place, |_, _| Ordering::Equal);
            }
            _ => (),
        }
    }

    /// Two rows a bin, the smallest values, then the largest.
    pub(super) fn finish(self) -> VariableValues {
        let width = self.width;
        match self.found {
            Some(FoundExtremes::F64(found)) => VariableValues::F64(rows(found, width)),
            Some(FoundExtremes::Complex(found)) => VariableValues::Complex(rows(found, width)),
            Some(FoundExtremes::I64(found)) => VariableValues::I64(rows(found, width)),
            Some(FoundExtremes::U8(found)) => VariableValues::U8(rows(found, width)),
            Some(FoundExtremes::Text(found)) => VariableValues::Text(rows(found, width)),
            None => VariableValues::F64(Vec::new()),
        }
    }
}

/// Numbers by size; one that is none gives way to every other.
fn of_numbers(a: &f64, b: &f64) -> Ordering {
    a.partial_cmp(b).unwrap_or(Ordering::Equal)
}

fn widen<T: Clone + PartialEq>(
    found: &mut [Option<[T; 2]>],
    values: Vec<T>,
    place: impl Fn(usize) -> usize,
    order: impl Fn(&T, &T) -> Ordering,
) {
    // what differs from itself is not a number
    #[expect(clippy::eq_op, reason = "true of NaN alone")]
    let is_none = |value: &T| value != value;
    for (index, value) in values.into_iter().enumerate() {
        match &mut found[place(index)] {
            Some([low, high]) => {
                if is_none(low) || order(&value, low) == Ordering::Less {
                    *low = value.clone();
                }
                if is_none(high) || order(&value, high) != Ordering::Less && !is_none(&value) {
                    *high = value;
                }
            }
            unknown => *unknown = Some([value.clone(), value]),
        }
    }
}

fn rows<T: Clone>(found: Vec<Option<[T; 2]>>, width: usize) -> Vec<T> {
    let mut values = Vec::with_capacity(2 * found.len());
    for bin in found.chunks(width.max(1)) {
        for end in 0..2 {
            values.extend(bin.iter().flatten().map(|extremes| extremes[end].clone()));
        }
    }
    values
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bins_keep_their_extremes_whatever_the_parts() {
        let values: Vec<f64> = (0..1000).map(|k| (f64::from(k) * 0.7).sin()).collect();
        for (from, bins) in [(0, 7), (13, 10), (990, 3)] {
            let rows = from..1000;
            let mut expected = Vec::new();
            for bin in 0..bins {
                let end = |k: usize| from + k * rows.len() / bins;
                let of = &values[end(bin)..end(bin + 1)];
                let fold = |f: fn(f64, f64) -> f64| of.iter().copied().reduce(f).unwrap();
                expected.extend([fold(f64::min), fold(f64::max)]);
            }
            for part in [1, 64, 1000] {
                let mut extremes = BinnedExtremes::new(rows.clone(), bins, 1);
                for start in rows.clone().step_by(part) {
                    extremes
                        .add(start, VariableValues::F64(values[start..(start + part).min(1000)].to_vec()));
                }
                assert_eq!(extremes.finish(), VariableValues::F64(expected.clone()), "{from} {bins} {part}");
            }
        }
    }

    #[test]
    fn every_column_and_every_type_has_its_own() {
        let of = |data: VariableValues, width: usize| {
            let mut extremes = BinnedExtremes::new(0..4, 2, width);
            extremes.add(0, data);
            extremes.finish()
        };
        let columns = vec![1.0, 10.0, 2.0, 9.0, f64::NAN, 5.0, 4.0, 6.0];
        assert_eq!(
            of(VariableValues::F64(columns), 2),
            VariableValues::F64(vec![1.0, 9.0, 2.0, 10.0, 4.0, 5.0, 4.0, 6.0])
        );
        assert_eq!(of(VariableValues::I64(vec![3, -1, 7, 8]), 1), VariableValues::I64(vec![-1, 3, 7, 8]));
        assert_eq!(of(VariableValues::U8(vec![3, 1, 0, 2]), 1), VariableValues::U8(vec![1, 3, 0, 2]));
        let (small, large) = (Complex64::new(0.0, 1.0), Complex64::new(-2.0, 0.0));
        assert_eq!(
            of(VariableValues::Complex(vec![large, small, small, small]), 1),
            VariableValues::Complex(vec![small, large, small, small])
        );
        let labels = ["b", "a", "d", "c"].map(String::from).to_vec();
        assert_eq!(of(VariableValues::Text(labels.clone()), 1), VariableValues::Text(labels));
        let VariableValues::F64(none) = of(VariableValues::F64(vec![f64::NAN; 4]), 1) else { panic!() };
        assert!(none.len() == 4 && none.iter().all(|value| value.is_nan()));
    }
}
