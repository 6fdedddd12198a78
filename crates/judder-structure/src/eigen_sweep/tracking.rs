//! Which eigenvalue of one point is which of the next: continuity of the vectors on both sides and of the eigenvalue.

use super::{PointEigenvalues, Tracked};
use crate::complex_modes::{ComplexMode, vectors::assurances};
use faer::{Mat, c64};
use judder_numerics::complex::ElementaryComplex;
use judder_numerics::order::sort_by_number;

/// Follows branches from point to point.
#[derive(Default)]
pub(super) struct SweepTracker {
    branches: Vec<SeenBranch>,
}

/// A branch as far as it was seen.
#[derive(Default)]
struct SeenBranch {
    right: Vec<c64>,
    left: Vec<c64>,
    value: c64,
    /// What the last step changed.
    step: c64,
    /// Whether the last point had it.
    alive: bool,
}

/// Vectors and values that agree worse than this are not one branch.
const STRANGER: f64 = 1.2;
/// A difference from the extrapolated λ by this share of |λ| says no more than a larger one: half as much as vectors that are orthogonal.
const JUMP: f64 = 0.05;

impl SweepTracker {
    /// Branches seen so far.
    pub(super) fn branches(&self) -> usize {
        self.branches.len()
    }

    /// Goes over a point of which the branches are known, with its modes where those of the next point are to follow them.
    pub(super) fn pass(&mut self, point: &PointEigenvalues, modes: &[ComplexMode]) {
        let before: Vec<Option<c64>> =
            self.branches.iter().map(|branch| branch.alive.then_some(branch.value)).collect();
        for branch in &mut self.branches {
            branch.alive = false;
        }
        for (k, Tracked { eigenvalue, branch }) in point.eigenvalues.iter().enumerate() {
            let value = eigenvalue.value;
            let step = before.get(*branch).copied().flatten().map_or(c64::new(0.0, 0.0), |own| value - own);
            let (right, left) =
                modes.get(k).map_or_else(Default::default, |mode| (mode.right.clone(), mode.left.clone()));
            if self.branches.len() <= *branch {
                self.branches.resize_with(branch + 1, SeenBranch::default);
            }
            self.branches[*branch] = SeenBranch { right, left, value, step, alive: true };
        }
    }

    /// The branch of each mode of the next point; one that follows none of the last point's begins a new one.
    pub(super) fn next(&mut self, modes: &[ComplexMode]) -> Vec<usize> {
        let mut candidates: Vec<(f64, usize, usize)> = Vec::new();
        let alive: Vec<(usize, &SeenBranch)> =
            self.branches.iter().enumerate().filter(|(_, branch)| branch.alive).collect();
        let (right, left) = rayon::join(
            || alike(&alive, modes, |branch| &branch.right, |mode| &mode.right),
            || alike(&alive, modes, |branch| &branch.left, |mode| &mode.left),
        );
        for (row, (number, branch)) in alive.iter().enumerate() {
            let costs = modes
                .iter()
                .enumerate()
                .map(|(k, mode)| (branch.distance(mode, right[(row, k)] * left[(row, k)]), *number, k));
            candidates.extend(costs.filter(|(cost, ..)| *cost < STRANGER));
        }
        sort_by_number(&mut candidates, |own| own.0);
        let mut of_mode: Vec<Option<usize>> = vec![None; modes.len()];
        for branch in &mut self.branches {
            branch.alive = false;
        }
        for (_, number, k) in candidates {
            if !self.branches[number].alive && of_mode[k].is_none() {
                self.branches[number].follow(&modes[k]);
                of_mode[k] = Some(number);
            }
        }
        of_mode
            .into_iter()
            .zip(modes)
            .map(|(known, mode)| {
                known.unwrap_or_else(|| {
                    self.branches.push(SeenBranch::new(mode));
                    self.branches.len() - 1
                })
            })
            .collect()
    }
}

/// How much vectors of branches and modes are alike: not at all where a key changes how many components they have, and eigenvalues alone tell.
fn alike(
    branches: &[(usize, &SeenBranch)],
    modes: &[ComplexMode],
    of_branch: fn(&SeenBranch) -> &Vec<c64>,
    of_mode: fn(&ComplexMode) -> &Vec<c64>,
) -> Mat<f64> {
    let of_branches: Vec<&[c64]> = branches.iter().map(|(_, branch)| &of_branch(branch)[..]).collect();
    let of_modes: Vec<&[c64]> = modes.iter().map(|mode| &of_mode(mode)[..]).collect();
    let mut lengths = of_branches.iter().chain(&of_modes).map(|own| own.len());
    match lengths.next().is_none_or(|first| lengths.all(|own| own == first)) {
        true => assurances(&of_branches, &of_modes),
        false => Mat::zeros(of_branches.len(), of_modes.len()),
    }
}

impl SeenBranch {
    fn new(mode: &ComplexMode) -> Self {
        Self {
            right: mode.right.clone(),
            left: mode.left.clone(),
            value: mode.eigenvalue.value,
            step: c64::new(0.0, 0.0),
            alive: true,
        }
    }

    fn follow(&mut self, mode: &ComplexMode) {
        let step = mode.eigenvalue.value - self.value;
        *self = Self { step, ..Self::new(mode) };
    }

    /// 0 for a mode that goes on as expected; its vectors are so much alike.
    fn distance(&self, mode: &ComplexMode, alike: f64) -> f64 {
        let value = mode.eigenvalue.value;
        let jump =
            (value - self.value - self.step).modulus() / (JUMP * value.modulus().max(self.value.modulus()));
        1.0 - alike.sqrt() + 0.5 * jump.min(1.0)
    }
}
