//! Eigenvalues and thresholds without damping (section 4.2, Figs. 5–8).

use super::{Claim, measured, misprint, short, statement};
use crate::reproduce::measures::{loads, log_grid, state, strengths};
use judder_oscillator::conservative::{conservative_eigenvalues, critical_shear_strength};
use judder_oscillator::equilibrium::equilibrium;
use judder_oscillator::{Contact, Groups};

/// The loads of Fig. 7.
const LOADS: [f64; 5] = [1e-8, 1e-7, 1e-6, 1e-5, 1e-4];
/// The shear strengths of Fig. 8.
const STRENGTHS: [f64; 3] = [0.01, 0.05, 0.1];

/// The lowest threshold of a list.
fn lowest(thresholds: &[f64]) -> f64 {
    thresholds.first().copied().unwrap_or(f64::NAN)
}

pub(super) const OUTER_PAIR: Claim = misprint(
    "Eq. (24), §4.2",
    "$λ_{1,2}$ are purely imaginary",
    |contact| {
        let groups = Groups { velocity: 1e-4, normal_load: 7.5e-6, shear_strength: 0.1, ..Groups::default() };
        let outer = state(contact, groups)
            .map(|(_, l)| conservative_eigenvalues(&l.stiffness()))
            .map(|l| l[0].re.abs());
        let real = outer.unwrap_or(f64::NAN);
        // a law with no flutter there has nothing to show
        let fluttering = strengths(contact, 1e-4, 7.5e-6).conservative.first().is_some_and(|t| *t < 0.1);
        measured(format!("|Re $λ_{{1,2}}$| = {}", short(real)), real > 1e-3 || !fluttering)
    },
    "Once the modes have merged the radicand is complex in (24) and (25) alike; all four eigenvalues leave the axis together. Shown at the end of \
     Fig. 5.",
);

pub(super) const FIG_5: Claim = statement(
    "§4.2, Fig. 5",
    "$τ̃_{0,crit}$ ≈ 3.5 × 10^{−2}",
    |contact| {
        let found = strengths(contact, 1e-4, 7.5e-6).conservative;
        measured(short(lowest(&found)), (lowest(&found) / 3.5e-2 - 1.0).abs() < 0.06)
    },
    "At $v̂_{d}$ = 10^{−4}, $F̃_{n}$ = 7.5 × 10^{−6}, read off a figure: within 6 %.",
);

pub(super) const FIG_6: Claim = misprint(
    "§4.2, Fig. 6",
    "The modes merge at $F̃_{n}$ ≈ 7.5 × 10^{−7}",
    |contact| {
        let found = loads(contact, 1.58e-4, 0.01).conservative;
        let merge = found.last().copied().unwrap_or(f64::NAN);
        measured(short(merge), merge < 3e-7)
    },
    "At $v̂_{d}$ = 1.58 × 10^{−4}, $τ̃_{0}$ = 0.01: an exponent misprint, 7.5 × 10^{−8} would be within a few per cent.",
);

pub(super) const DERIVATIVES_IN_27: Claim = misprint(
    "Eqs. (27), (28)",
    "Derivatives by $ỹ$; thresholds explicit",
    |contact| {
        let groups = Groups { velocity: 1e-4, normal_load: 7.5e-6, ..Groups::default() };
        let exact = lowest(&strengths(contact, groups.velocity, groups.normal_load).conservative);
        let printed = |contact: &Contact| {
            let c = Groups { shear_strength: exact, ..groups }.resolve();
            let e = equilibrium(contact, &c).ok()?;
            Some(critical_shear_strength(contact.friction_load, &c, &e.response))
        };
        let off = printed(contact).map_or(f64::NAN, |value| (value / exact - 1.0).abs());
        let none = exact.is_nan();
        let shown =
            if none { "no threshold".to_owned() } else { format!("self-consistent to {}", short(off)) };
        measured(shown, none || off < 1e-8)
    },
    "They hold with derivatives by $ŷ$, and are implicit: $ŷ_{e}$ depends on the threshold. Solved together with the equilibrium, all roots.",
);

pub(super) const FIG_7_GROWS: Claim = statement(
    "§4.2, Fig. 7",
    "$τ̃_{0,crit}$ increases with the speed and with the load",
    |contact| {
        let speeds = log_grid(1e-8, 1e2, 41);
        let table: Vec<Vec<f64>> = LOADS
            .iter()
            .map(|load| speeds.iter().map(|v| lowest(&strengths(contact, *v, *load).conservative)).collect())
            .collect();
        // a threshold beyond the searched range counts as larger than any found
        let grows = |a: f64, b: f64| b.is_nan() || b >= a * (1.0 - 1e-9);
        let pairs = |rows: &[Vec<f64>]| -> (usize, usize) {
            let along = rows.iter().flat_map(|row| row.windows(2).map(|w| grows(w[0], w[1])));
            let all: Vec<bool> = along.collect();
            (all.iter().filter(|g| !**g).count(), all.len())
        };
        let by_load: Vec<Vec<f64>> =
            (0..speeds.len()).map(|k| table.iter().map(|row| row[k]).collect()).collect();
        let ((speed_falls, speed_all), (load_falls, load_all)) = (pairs(&table), pairs(&by_load));
        let shown = format!(
            "falls at {speed_falls} of {speed_all} steps in speed, {load_falls} of {load_all} in load"
        );
        let share = (speed_falls + load_falls) as f64 / (speed_all + load_all) as f64;
        measured(shown, share <= 0.12)
    },
    "Lowest conservative threshold, 41 speeds and 5 loads; agreement allows one step in eight to fall, where the area shrinks with speed.",
);

pub(super) const FIG_7_EASY: Claim = statement(
    "§4.2, Fig. 7",
    "With realistic $τ̃_{0}$ in 0.01 … 0.1, low loads easily flutter",
    |contact| {
        let thresholds = LOADS.map(|load| lowest(&strengths(contact, 1e-8, load).conservative));
        measured(thresholds.map(short).join(", "), thresholds[0] < 0.01)
    },
    "Thresholds at $v̂_{d}$ = 10^{−8} for $F̃_{n}$ = 10^{−8} … 10^{−4}.",
);

pub(super) const FIG_8_TRENDS: Claim = statement(
    "§4.2, Fig. 8",
    "$F̃_{n,crit}$ falls with the speed and grows with $τ̃_{0}$",
    |contact| {
        let highest = |v: f64, strength: f64| {
            loads(contact, v, strength).conservative.last().copied().unwrap_or(f64::NAN)
        };
        let slow = STRENGTHS.map(|strength| highest(1e-8, strength));
        let fast = STRENGTHS.map(|strength| highest(1e2, strength));
        let grows = slow.windows(2).chain(fast.windows(2)).all(|pair| pair[1] > pair[0]);
        let falls = slow.iter().zip(&fast).all(|(s, f)| f < s);
        let shown: Vec<String> =
            slow.iter().zip(fast).map(|(s, f)| format!("{} → {}", short(*s), short(f))).collect();
        measured(shown.join("; "), grows && falls)
    },
    "Highest conservative threshold at $v̂_{d}$ = 10^{−8} → 10^{2}, for $τ̃_{0}$ = 0.01, 0.05, 0.1.",
);
