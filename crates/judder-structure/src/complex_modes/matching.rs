//! Which eigenvalues of two lists are the same.

use faer::c64;
use judder_numerics::complex::ElementaryComplex;
use judder_numerics::order::sort_by_number;

/// Pairs of places in two lists, nearest first, each place at most once and none further apart than the tolerance.
pub(crate) fn one_to_one(a: &[c64], b: &[c64], tolerance: f64) -> Vec<(usize, usize)> {
    let mut near: Vec<(f64, usize, usize)> = Vec::new();
    for (i, left) in a.iter().enumerate() {
        let within = b.iter().enumerate().map(|(j, right)| ((left - right).modulus(), i, j));
        near.extend(within.filter(|(distance, ..)| *distance <= tolerance));
    }
    sort_by_number(&mut near, |own| own.0);
    let (mut taken_a, mut taken_b) = (vec![false; a.len()], vec![false; b.len()]);
    let mut pairs = Vec::new();
    for (_, i, j) in near {
        if !taken_a[i] && !taken_b[j] {
            (taken_a[i], taken_b[j]) = (true, true);
            pairs.push((i, j));
        }
    }
    pairs
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_come_first_and_each_only_once() {
        let list = |values: &[f64]| values.iter().map(|v| c64::new(*v, 0.0)).collect::<Vec<_>>();
        let pairs = one_to_one(&list(&[1.0, 1.2, 5.0]), &list(&[1.15, 1.0, 9.0]), 0.5);
        assert_eq!(pairs, [(0, 1), (1, 0)]);
        assert!(one_to_one(&list(&[1.0]), &list(&[]), 0.5).is_empty());
    }
}
