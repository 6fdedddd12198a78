//! Which eigenvalue continues which, from one value of a parameter to the next.

use judder_numerics::complex::ElementaryComplex;
use judder_numerics::order::sort_by_number;
use num_complex::Complex64;

/// For each of `foretold` the index of the eigenvalue of `found` that continues it: nearest first, each once; `None` where too few are
/// left.
///
/// At an exceptional point, where two eigenvalues meet, either may continue either: their mean and the square of their difference are
/// smooth there, they themselves are not.
pub(crate) fn continued(foretold: &[Complex64], found: &[Complex64]) -> Vec<Option<usize>> {
    matched(foretold.len(), found.len(), |i, j| (foretold[i] - found[j]).norm_sqr())
}

/// For each of `own` the one of `others` that is its match: nearest first, each once.
fn matched(own: usize, others: usize, distance: impl Fn(usize, usize) -> f64) -> Vec<Option<usize>> {
    let mut distances: Vec<(f64, usize, usize)> = Vec::with_capacity(own * others);
    for i in 0..own {
        distances.extend((0..others).map(|j| (distance(i, j), i, j)));
    }
    sort_by_number(&mut distances, |own| own.0);
    let (mut matched, mut is_taken) = (vec![None; own], vec![false; others]);
    for (_, i, j) in distances {
        if matched[i].is_none() && !is_taken[j] {
            (matched[i], is_taken[j]) = (Some(j), true);
        }
    }
    matched
}

/// How large a region about zero has to be to hold an eigenvalue: the larger of its imaginary and absolute real part.
pub(crate) fn reach(eigenvalue: Complex64) -> f64 {
    eigenvalue.im.max(eigenvalue.re.abs())
}

/// A branch at the last value of the parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
struct TrackedBranch {
    number: usize,
    value: Complex64,
    slope: Complex64,
}

/// Branches of eigenvalues from one value of a parameter to the next; at each, all eigenvalues up to a limit of their [`reach`] are known.
///
/// A branch ends where it leaves what is known, and what enters begins another. Where an oscillation becomes two decays on the real axis the
/// nearer one goes on and the other begins; where two become one oscillation again one of them ends.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Tracker {
    at: f64,
    limit: f64,
    branches: Vec<TrackedBranch>,
    /// How many branches there have been.
    begun: usize,
}

impl TrackedBranch {
    /// Where it may be so much farther on: straight on, or, where it has jumped and has no slope, where it was.
    fn foretold(&self, ahead: f64) -> [Complex64; 2] {
        [self.value + self.slope * ahead, self.value]
    }

    /// How far an eigenvalue is from where it may be, and what region holds both.
    fn apart(&self, ahead: f64, found: Complex64) -> (f64, f64) {
        let [straight, still] =
            self.foretold(ahead).map(|value| ((value - found).modulus(), reach(value).max(reach(found))));
        if straight.0 <= still.0 { straight } else { still }
    }
}

impl Tracker {
    /// Of each eigenvalue at the next value of the parameter the number of its branch.
    pub(crate) fn step(&mut self, at: f64, found: &[Complex64], limit: f64) -> Vec<usize> {
        let ahead = at - self.at;
        let known = self.limit.min(limit);
        let apart = |i: usize, j: usize| self.branches[i].apart(ahead, found[j]);
        let mut before: Vec<Option<TrackedBranch>> = vec![None; found.len()];
        let all = matched(self.branches.len(), found.len(), |i, j| apart(i, j).0);
        for (i, j) in all.into_iter().enumerate().filter_map(|(i, next)| Some((i, next?))) {
            let (distance, region) = apart(i, j);
            // where what is not known may be nearer, the one may have left and the other entered
            if region + distance <= known {
                before[j] = Some(self.branches[i]);
            }
        }
        let mut begun = self.begun;
        let mut next = |(before, value): (Option<TrackedBranch>, Complex64)| match before {
            Some(own) => TrackedBranch {
                slope: if ahead > 0.0 { (value - own.value) / ahead } else { own.slope },
                value,
                ..own
            },
            None => {
                begun += 1;
                TrackedBranch { number: begun - 1, value, slope: Complex64::ZERO }
            }
        };
        let branches = before.into_iter().zip(found.iter().copied()).map(&mut next).collect();
        *self = Self { at, limit, branches, begun };
        self.branches.iter().map(|branch| branch.number).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use judder_numerics::counter::uniform;

    /// Two straight lines that cross keep their slopes, although at the crossing each is nearer to the other's next value.
    #[test]
    fn branches_go_straight_through_a_crossing() {
        let lines = |x: f64| [Complex64::new(-1.0, x), Complex64::new(-1.1, 3.0 - x)];
        let mut tracker = Tracker::default();
        let first = tracker.step(0.0, &lines(0.0), 9.0);
        for k in 1..=30 {
            let x = 0.1 * f64::from(k);
            let mut found = lines(x);
            found.sort_by(|a, b| a.im.total_cmp(&b.im));
            let numbers = tracker.step(x, &found, 9.0);
            let own = found.iter().position(|value| *value == lines(x)[0]).unwrap();
            assert_eq!(numbers[own], first[0], "{x}: {numbers:?}");
        }
    }

    #[test]
    fn each_eigenvalue_continues_one_branch() {
        let at = |im: f64| Complex64::new(0.0, im);
        assert_eq!(continued(&[at(1.0), at(1.1)], &[at(1.04), at(9.0)]), [Some(0), Some(1)]);
        assert_eq!(continued(&[at(1.0), at(1.1)], &[at(1.09)]), [None, Some(0)]);
    }

    /// Waves that come into what is known and leave it, and a mode that turns into two decays and back: numbers never go from one wave to
    /// another, whatever else comes or goes at the same time.
    #[test]
    fn a_branch_never_goes_on_as_another() {
        const LIMIT: f64 = 10.0;
        let (mut left, mut parted) = (0, 0);
        for seed in 0..200 {
            let draw = |place: u64| uniform(seed, place);
            // each by its own mean, size, rate and phase
            let waves: Vec<[f64; 4]> = (0..8)
                .map(|k| {
                    [
                        1.5 * k as f64 + 2.0,
                        3.0 * draw(4 * k),
                        1.0 + 4.0 * draw(4 * k + 1),
                        6.3 * draw(4 * k + 2),
                    ]
                })
                .collect();
            let own = |k: usize, x: f64| {
                let [mean, size, rate, phase] = waves[k];
                Complex64::new(-0.4 * k as f64, mean + size * (rate * x + phase).sin())
            };
            let mut tracker = Tracker::default();
            let mut owner: Vec<(usize, usize)> = Vec::new();
            for step in 0..=400 {
                let x = 0.01 * f64::from(step);
                let mut found: Vec<(usize, Complex64)> = (0..8).map(|k| (k, own(k, x))).collect();
                let square = (3.0 * x).sin();
                let root = square.abs().sqrt();
                match square > 0.0 {
                    true => found.push((8, Complex64::new(-6.0, root))),
                    false => found.extend([-root, root].map(|aside| (8, Complex64::new(-6.0 + aside, 0.0)))),
                }
                found.retain(|(_, value)| reach(*value) <= LIMIT);
                found.sort_by(|a, b| a.1.im.total_cmp(&b.1.im).then(a.1.re.total_cmp(&b.1.re)));
                let values: Vec<Complex64> = found.iter().map(|(_, value)| *value).collect();
                let numbers = tracker.step(x, &values, LIMIT);
                for (number, (wave, _)) in numbers.iter().zip(&found) {
                    match owner.iter().find(|(known, _)| known == number) {
                        Some((_, known)) => assert_eq!(known, wave, "{seed}, {x}: {number} of {owner:?}"),
                        None => owner.push((*number, *wave)),
                    }
                }
            }
            left += usize::from((0..8).any(|wave| owner.iter().filter(|own| own.1 == wave).count() > 1));
            parted += usize::from(owner.iter().filter(|own| own.1 == 8).count() > 1);
        }
        // the test would say nothing if none came back
        assert!(left > 100 && parted > 100, "{left}, {parted}");
    }
}
