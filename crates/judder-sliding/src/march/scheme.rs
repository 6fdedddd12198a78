//! How one mode goes from step to step, and the step that keeps all of them stable.

use super::lock::first_lock;
use super::oscillators::ModalRecurrence;
use crate::SlidingError;
use crate::pair::Pair;
use std::f64::consts::TAU;

/// Time integration of the modes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Scheme {
    /// Central differences, the velocity taken backwards: equations (11) to (13).
    CentralDifferences,
    /// Exact for a force that is straight between steps, for modes up to an angular frequency; above it only their flexibility.
    Exact {
        /// rad/s.
        cut_off: f64,
    },
}

impl Scheme {
    /// Whether a mode of this λ moves, and does not only yield.
    pub(super) fn moves(self, eigenvalue: f64) -> bool {
        match self {
            Self::CentralDifferences => true,
            Self::Exact { cut_off } => eigenvalue < cut_off * cut_off,
        }
    }

    /// The recurrence of a mode with q̈ + d q̇ + λ q = f.
    pub(super) fn recurrence(self, step: f64, eigenvalue: f64, damping: f64) -> ModalRecurrence {
        match self {
            Self::CentralDifferences => ModalRecurrence {
                ahead: 2.0 - step * step * eigenvalue - step * damping,
                behind: 1.0 - step * damping,
                at_once: step * step,
                later: [0.0; 2],
            },
            Self::Exact { .. } => exact(step, eigenvalue, damping),
        }
    }

    /// The recurrence of a mode while it is damped otherwise than by its `own` damping.
    ///
    /// What a force does at once stays that under its own damping, from which it differs by a share h d: the compliance of the
    /// contact, which must agree with it, need not be computed anew. What it does in all stays right.
    pub(super) fn while_damped(self, step: f64, eigenvalue: f64, own: f64, damping: f64) -> ModalRecurrence {
        let mut recurrence = self.recurrence(step, eigenvalue, damping);
        let at_once = self.recurrence(step, eigenvalue, own).at_once;
        recurrence.later[0] += recurrence.at_once - at_once;
        recurrence.at_once = at_once;
        recurrence
    }

    /// What a unit force does to a mode at once: by its recurrence, or by its flexibility.
    pub(super) fn at_once(self, step: f64, eigenvalue: f64, damping: f64) -> f64 {
        if self.moves(eigenvalue) {
            self.recurrence(step, eigenvalue, damping).at_once
        } else {
            1.0 / eigenvalue
        }
    }

    /// What a unit force that changes its sign from step to step does to a mode: where the sum over all modes is positive between
    /// the contact's two sides, the force cannot grow from step to step.
    fn alternating(self, step: f64, eigenvalue: f64, damping: f64) -> f64 {
        if !self.moves(eigenvalue) {
            return 1.0 / eigenvalue;
        }
        let ModalRecurrence { ahead, behind, at_once, later } = self.recurrence(step, eigenvalue, damping);
        (at_once - later[0] + later[1]) / (1.0 + ahead + behind)
    }
}

/// The largest stable step, s.
///
/// Of central differences h ω ≤ 2 (√(1 + ζ²) − ζ) for every mode, with the larger of its own and the initial damping; of the exact
/// scheme the step up to which the residual flexibility holds the contact against what the moving modes do between steps, with the largest friction coefficient.
///
/// # Errors
/// [`SlidingError::CutOff`]; [`SlidingError::SpragSlip`] and [`SlidingError::LocksAtOnce`] where no step does that.
pub(super) fn step_limit(
    pair: &Pair,
    scheme: Scheme,
    initial: Option<(f64, f64)>,
    path: [f64; 2],
    friction: f64,
) -> Result<f64, SlidingError> {
    let eigenvalues = pair.eigenvalues();
    let damping: Vec<f64> = eigenvalues
        .iter()
        .zip(pair.damping())
        .map(|(value, own)| initial.map_or(own, |(alpha, beta)| own.max(alpha + beta * value)))
        .collect();
    match scheme {
        Scheme::CentralDifferences => {
            let limit = |(value, damping): (&f64, &f64)| {
                let omega = value.sqrt();
                let ratio = 0.5 * damping / omega;
                2.0 * ((1.0 + ratio * ratio).sqrt() - ratio) / omega
            };
            let moving = eigenvalues.iter().zip(&damping).filter(|(value, _)| **value > 0.0);
            Ok(moving.map(limit).fold(f64::INFINITY, f64::min))
        }
        Scheme::Exact { .. } => exact_limit(pair, scheme, path, friction),
    }
}

/// The limit of the exact scheme, by bisection.
fn exact_limit(pair: &Pair, scheme: Scheme, path: [f64; 2], friction: f64) -> Result<f64, SlidingError> {
    let eigenvalues = pair.eigenvalues();
    let swinging = eigenvalues.iter().copied().filter(|value| *value > 0.0);
    let (lowest, highest) =
        swinging.fold((f64::INFINITY, 0.0_f64), |(low, high), value| (low.min(value), high.max(value)));
    if let Scheme::Exact { cut_off } = scheme
        && (!scheme.moves(lowest) || scheme.moves(highest))
    {
        let [cut_off_hz, lowest_hz, highest_hz] =
            [cut_off, lowest.sqrt(), highest.sqrt()].map(|omega| omega / TAU);
        return Err(SlidingError::CutOff { cut_off_hz, lowest_hz, highest_hz });
    }
    // the fastest mode that moves turns by half a circle, at most
    let fastest = eigenvalues.iter().copied().filter(|value| scheme.moves(*value)).fold(0.0, f64::max);
    let (mut good, mut bad) = (0.0, 0.5 * TAU / fastest.sqrt());
    let mut first = None;
    for _ in 0..40 {
        let step = 0.5 * (good + bad);
        let modes = eigenvalues.iter().zip(pair.damping());
        let factors: Vec<f64> = modes.map(|(value, d)| scheme.alternating(step, *value, d)).collect();
        match first_lock(pair, path, friction, &factors) {
            None => good = step,
            lock => (bad, first) = (step, lock),
        }
    }
    match first {
        Some(lock) if good == 0.0 => Err(lock.error(pair)),
        _ => Ok(good),
    }
}

/// The two-term recurrence of q̈ + d q̇ + λ q = f that is exact where f is straight between steps.
///
/// With z = (q, q̇) and z₁ = E z₀ + Γ₀ f₀ + Γ₁ f₁, the theorem of Cayley and Hamilton leaves
/// q₂ = tr E q₁ − det E q₀ + Γ₁ f₂ + …, the velocities gone.
fn exact(step: f64, eigenvalue: f64, damping: f64) -> ModalRecurrence {
    // of (q, q̇ h, f h², (f₁ − f₀) h²) over one step
    let generator = [
        [0.0, 1.0, 0.0, 0.0],
        [-eigenvalue * step * step, -damping * step, 1.0, 0.0],
        [0.0, 0.0, 0.0, 1.0],
        [0.0, 0.0, 0.0, 0.0],
    ];
    let e = exponential(&generator);
    // the force f₀ + (f₁ − f₀) t/h
    let (before, now) = ([0, 1].map(|i| e[i][2] - e[i][3]), [0, 1].map(|i| e[i][3]));
    let square = step * step;
    ModalRecurrence {
        ahead: e[0][0] + e[1][1],
        behind: libm::exp(-damping * step),
        at_once: square * now[0],
        later: [
            square * (before[0] + e[0][1] * now[1] - e[1][1] * now[0]),
            square * (e[0][1] * before[1] - e[1][1] * before[0]),
        ],
    }
}

type Four = [[f64; 4]; 4];

fn product(a: &Four, b: &Four) -> Four {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..4).map(|k| a[i][k] * b[k][j]).sum()))
}

/// eᴬ by Taylor's series of a scaled matrix, squared back.
fn exponential(matrix: &Four) -> Four {
    let largest = matrix.as_flattened().iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    let halvings = if largest > 0.5 { libm::log2(2.0 * largest).ceil().max(0.0) as i32 } else { 0 };
    let scaled = matrix.map(|row| row.map(|x| x * 0.5_f64.powi(halvings)));
    let identity: Four = std::array::from_fn(|i| std::array::from_fn(|j| if i == j { 1.0 } else { 0.0 }));
    let (mut sum, mut term) = (identity, identity);
    for k in 1..=20 {
        term = product(&term, &scaled).map(|row| row.map(|x| x / f64::from(k)));
        for (sum, term) in sum.as_flattened_mut().iter_mut().zip(term.as_flattened()) {
            *sum += term;
        }
    }
    (0..halvings).fold(sum, |power, _| product(&power, &power))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// q̈ + d q̇ + λ q = a + b t from rest, in closed form, step by step; with λ = 0 too.
    #[test]
    fn the_exact_recurrence_follows_the_closed_form() {
        let step = 0.3;
        let ModalRecurrence { ahead, behind, at_once, later } = exact(step, 0.0, 0.0);
        // q = f t²/2 under a constant force
        let mut q = [0.0, 0.5 * step * step];
        for n in 2..20 {
            let next = ahead * q[1] - behind * q[0] + at_once + later[0] + later[1];
            q = [q[1], next];
            assert!((next - 0.5 * (step * f64::from(n)).powi(2)).abs() < 1e-12, "{n}");
        }
        let (value, damping) = (7.0_f64, 0.4);
        let ModalRecurrence { ahead, behind, at_once, later } = exact(step, value, damping);
        let decay = 0.5 * damping;
        let omega = (value - decay * decay).sqrt();
        // the particular solution of f = t is (t − d/λ)/λ; from rest the rest of it swings out
        let closed = |t: f64| {
            let (q0, v0) = (damping / value / value, -1.0 / value);
            let swing = q0 * (omega * t).cos() + (v0 + decay * q0) / omega * (omega * t).sin();
            (t - damping / value) / value + (-decay * t).exp() * swing
        };
        let mut q = [0.0, closed(step)];
        for n in 2..30 {
            let t = step * f64::from(n);
            let next = ahead * q[1] - behind * q[0]
                + at_once * t
                + later[0] * (t - step)
                + later[1] * (t - 2.0 * step);
            q = [q[1], next];
            assert!((next - closed(t)).abs() < 1e-13, "{n}: {next} {}", closed(t));
        }
    }

    /// Straight through several turns of a fast mode, where the matrix has to be scaled.
    #[test]
    fn the_exact_recurrence_is_exact_for_long_steps() {
        let ModalRecurrence { ahead, behind, .. } = exact(1.0, 400.0, 0.0);
        assert!((ahead - 2.0 * 20.0_f64.cos()).abs() < 1e-12 && behind == 1.0, "{ahead}");
    }
}
