//! Whether a motion without a period is irregular, or only has not settled.

use super::return_map::return_map;
use crate::motion::SlidingSystem;
use crate::motion::attractor::{Attractor, distance};
use judder_numerics::piecewise::StepSettings;

/// Oscillations over which nearby motions must part.
const OSCILLATIONS: usize = 256;
/// By how much: what comes slowly to a cycle, on whichever way, parts by a few at most, where the return map is far from normal.
const PARTS: f64 = 100.0;
/// Spans of oscillations in a row over which what is on its way comes ever nearer to itself, or ever less near: by chance one in 2520 does.
const SPANS: usize = 7;

/// Whether nearby motions part from one that has not settled, and it is not on its way from or to something.
///
/// A small disturbance is carried through the derivative of the return map, over 256 oscillations or `longest`, and must grow a
/// hundredfold: the largest Lyapunov exponent is then positive. A motion that leaves an unstable cycle or steady sliding parts too; its
/// returns miss each other ever more. Quasi-periodic motions do not part.
pub(super) fn wanders<const N: usize>(
    system: &impl SlidingSystem<N>,
    motion: &Attractor<N>,
    settings: StepSettings<N>,
    longest: f64,
) -> bool {
    motion.returns.len() > SPANS
        && !is_on_its_way(&motion.returns, &system.scales())
        && parting(system, motion.state, settings, longest) > libm::log(PARTS)
}

/// Whether returns, so many oscillations apart, miss each other ever more or ever less from span to span, for any number of them.
fn is_on_its_way<const N: usize>(returns: &[[f64; N]], scales: &[f64; N]) -> bool {
    let mut numbers = 1..=returns.len() / (SPANS + 1);
    numbers.any(|oscillations| {
        let misses: Vec<f64> =
            returns.iter().zip(&returns[oscillations..]).map(|(a, b)| distance(a, b, scales)).collect();
        let spans: Vec<f64> =
            misses.chunks_exact(oscillations).map(|span| span.iter().copied().fold(0.0, f64::max)).collect();
        spans.is_sorted_by(|a, b| a < b) || spans.is_sorted_by(|a, b| a > b)
    })
}

/// The logarithm of what becomes of a small disturbance; −∞ where a motion does not come back.
fn parting<const N: usize>(
    system: &impl SlidingSystem<N>,
    start: [f64; N],
    settings: StepSettings<N>,
    longest: f64,
) -> f64 {
    let scales = system.scales();
    let (mut state, mut disturbance, mut grown, mut time) = (start, scales, 0.0, 0.0);
    for _ in 0..OSCILLATIONS {
        let Ok(around) = return_map(system, state, 1, settings, longest) else { return f64::NEG_INFINITY };
        let carried: [f64; N] =
            around.derivative.map(|row| row.iter().zip(&disturbance).map(|(d, u)| d * u).sum());
        let size = distance(&carried, &[0.0; N], &scales);
        grown += libm::log(size);
        // a return that forgets every disturbance
        if size == 0.0 {
            return f64::NEG_INFINITY;
        }
        disturbance = carried.map(|component| component / size);
        state = around.state;
        time += around.time;
        if time > longest {
            break;
        }
    }
    grown
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    fn on_its_way(at: impl Fn(f64) -> [f64; 2]) -> bool {
        let returns: Vec<[f64; 2]> = (0..63).map(|ago| at(-f64::from(ago))).collect();
        is_on_its_way(&returns, &[1.0; 2])
    }

    #[test]
    fn what_drifts_or_spirals_is_on_its_way() {
        assert!(on_its_way(|k| [1.0001_f64.powf(k), 0.0]));
        assert!(on_its_way(|k| [2.0 + 0.999_f64.powf(k), 1.0]));
        // to and from a cycle of one oscillation on alternating sides, and at 3/7 of a turn and a little more
        for factor in [0.98_f64, 1.02] {
            assert!(on_its_way(|k| [factor.powf(k) * (TAU / 2.0 * k).cos(), 0.0]));
            let turn = TAU * (3.0 / 7.0 + 1e-3);
            assert!(on_its_way(|k| [factor.powf(k) * (turn * k).cos(), factor.powf(k) * (turn * k).sin()]));
        }
    }

    /// The logistic map at 4, whose exponent is ln 2 (Ulam and von Neumann, 1947), from two thousand starts.
    #[test]
    fn irregular_returns_hardly_ever_look_so() {
        let looks = (1..=2000).filter(|start| {
            let mut x = f64::from(*start) / 2013.37;
            let returns: Vec<[f64; 1]> = (0..63)
                .map(|_| {
                    x = 4.0 * x * (1.0 - x);
                    [x]
                })
                .collect();
            is_on_its_way(&returns, &[1.0])
        });
        assert!(looks.count() <= 4);
    }
}
