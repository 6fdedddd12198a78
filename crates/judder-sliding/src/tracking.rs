//! Which eigenvalue continues which, from one value of a parameter to the next.

use num_complex::Complex64;

/// For each of `foretold` the index of the eigenvalue of `found` that continues it: nearest first, each once; `None` where too few are
/// left.
///
/// At an exceptional point, where two eigenvalues meet, either may continue either: their mean and the square of their difference are
/// smooth there, they themselves are not.
pub(crate) fn continued(foretold: &[Complex64], found: &[Complex64]) -> Vec<Option<usize>> {
    let mut distances: Vec<(f64, usize, usize)> = Vec::with_capacity(foretold.len() * found.len());
    for (i, value) in foretold.iter().enumerate() {
        distances.extend(found.iter().enumerate().map(|(j, other)| ((value - other).norm_sqr(), i, j)));
    }
    distances.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)).then(a.2.cmp(&b.2)));
    let (mut continued, mut is_taken) = (vec![None; foretold.len()], vec![false; found.len()]);
    for (_, i, j) in distances {
        if continued[i].is_none() && !is_taken[j] {
            (continued[i], is_taken[j]) = (Some(j), true);
        }
    }
    continued
}

/// A branch from eigenvalue to eigenvalue, in the order of the parameter.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Tracker {
    at: f64,
    values: Vec<Complex64>,
    slopes: Vec<Complex64>,
}

impl Tracker {
    /// At the first value of the parameter.
    pub(crate) fn new(at: f64, values: Vec<Complex64>) -> Self {
        let slopes = vec![Complex64::ZERO; values.len()];
        Self { at, values, slopes }
    }

    /// The eigenvalues at the next value of the parameter, in the order of the branches; as many are needed.
    pub(crate) fn step(&mut self, at: f64, found: &[Complex64]) -> &[Complex64] {
        let ahead = at - self.at;
        let foretold: Vec<Complex64> =
            self.values.iter().zip(&self.slopes).map(|(value, slope)| value + slope * ahead).collect();
        for (k, next) in continued(&foretold, found).into_iter().enumerate() {
            let Some(next) = next.map(|j| found[j]) else { continue };
            if ahead > 0.0 {
                self.slopes[k] = (next - self.values[k]) / ahead;
            }
            self.values[k] = next;
        }
        self.at = at;
        &self.values
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two straight lines that cross keep their slopes, although at the crossing each is nearer to the other's next value.
    #[test]
    fn branches_go_straight_through_a_crossing() {
        let lines = |x: f64| [Complex64::new(-1.0, x), Complex64::new(-1.1, 3.0 - x)];
        let mut tracker = Tracker::new(0.0, lines(0.0).to_vec());
        for k in 1..=30 {
            let x = 0.1 * f64::from(k);
            let mut found = lines(x);
            found.sort_by(|a, b| a.im.total_cmp(&b.im));
            let tracked = tracker.step(x, &found);
            assert!((tracked[0] - lines(x)[0]).norm() < 1e-12, "{x}: {tracked:?}");
        }
    }

    #[test]
    fn each_eigenvalue_continues_one_branch() {
        let at = |im: f64| Complex64::new(0.0, im);
        assert_eq!(continued(&[at(1.0), at(1.1)], &[at(1.04), at(9.0)]), [Some(0), Some(1)]);
        assert_eq!(continued(&[at(1.0), at(1.1)], &[at(1.09)]), [None, Some(0)]);
    }
}
