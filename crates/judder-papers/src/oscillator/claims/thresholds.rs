//! Eigenvalues and thresholds without damping (section 4.2, Figs. 5–8).

use crate::claim::{MeasuredClaim, measured, misprint, short, statement};
use crate::oscillator::measures::{loads, log_grid, state, strengths};
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

pub(super) const OUTER_PAIR: MeasuredClaim<Contact> = misprint(
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

pub(super) const FIG_5: MeasuredClaim<Contact> = statement(
    "§4.2, Fig. 5",
    "$τ̃_{0,crit}$ ≈ 3.5 × 10^{−2}",
    |contact| {
        let found = strengths(contact, 1e-4, 7.5e-6).conservative;
        measured(short(lowest(&found)), (lowest(&found) / 3.5e-2 - 1.0).abs() < 0.06)
    },
    "At $v̂_{d}$ = 10^{−4}, $F̃_{n}$ = 7.5 × 10^{−6}, read off a figure: within 6 %.",
);

pub(super) const FIG_6: MeasuredClaim<Contact> = misprint(
    "§4.2, Fig. 6",
    "The modes merge at $F̃_{n}$ ≈ 7.5 × 10^{−7}",
    |contact| {
        let found = loads(contact, 1.58e-4, 0.01).conservative;
        let merge = found.last().copied().unwrap_or(f64::NAN);
        measured(short(merge), (merge / 7.5e-8 - 1.0).abs() < 0.1)
    },
    "At $v̂_{d}$ = 1.58 × 10^{−4}, $τ̃_{0}$ = 0.01: an exponent misprint, 7.5 × 10^{−8} is within 10 %.",
);

pub(super) const DERIVATIVES_IN_27: MeasuredClaim<Contact> = misprint(
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

pub(super) const FIG_7_GROWS: MeasuredClaim<Contact> = statement(
    "§4.2, Fig. 7",
    "$τ̃_{0,crit}$ increases with the speed and with the load",
    |contact| {
        let speeds = log_grid(1e-8, 1e2, 41);
        let table: Vec<Vec<f64>> = LOADS
            .iter()
            .map(|load| speeds.iter().map(|v| lowest(&strengths(contact, *v, *load).conservative)).collect())
            .collect();
        let by_load: Vec<Vec<f64>> =
            (0..speeds.len()).map(|k| table.iter().map(|row| row[k]).collect()).collect();
        let (in_speed, in_load) = (largest_fall(&table), largest_fall(&by_load));
        let shown =
            format!("falls by at most {:.2} % in speed, {:.2} % in load", 100.0 * in_speed, 100.0 * in_load);
        measured(shown, in_speed < 0.01 && in_load == 0.0)
    },
    "Lowest conservative threshold, 41 speeds and 5 loads, largest fall from one to the next; agreement allows 1 %, which no figure shows.",
);

/// The largest relative fall between neighbours in any row; a threshold beyond the searched range counts as larger than any.
fn largest_fall(rows: &[Vec<f64>]) -> f64 {
    let falls = rows.iter().flat_map(|row| row.windows(2).map(|pair| 1.0 - pair[1] / pair[0]));
    falls.filter(|fall| *fall > 1e-9).fold(0.0, f64::max)
}

/// The threshold of section 5 belongs to the linear analysis.
pub(super) const SECTION_5: MeasuredClaim<Contact> = statement(
    "§5",
    "At $F̃_{n}$ = 7.5 × 10^{−4} the system is stable for $τ̃_{0}$ ≲ 2 × 10^{−3}",
    |contact| {
        // the captions' ṽ_d = 5e-3: v̂_d = ṽ_d τ̃/R̃ = 4e-4
        let found = strengths(contact, 4e-4, 7.5e-4).full;
        let shown = if found.is_empty() {
            "none".to_owned()
        } else {
            found.iter().map(|t| short(*t)).collect::<Vec<_>>().join(", ")
        };
        measured(shown, found.len() == 1 && (found[0] / 2e-3 - 1.0).abs() < 0.1)
    },
    "Thresholds of the full system at the captions' $ṽ_{d}$ = 5 × 10^{−3}, that is $v̂_{d}$ = 4 × 10^{−4}.",
);

pub(super) const SPEED_OF_SECTION_5: MeasuredClaim<Contact> = misprint(
    "§5",
    "$v̂_{d}$ = 5 × 10^{−3}",
    |contact| {
        let found = strengths(contact, 5e-3, 7.5e-4).full;
        let stable = found.iter().any(|t| (1e-4..5e-2).contains(t));
        measured(if stable { "a threshold there" } else { "no threshold in 10^{−4} … 5 × 10^{−2}" }, !stable)
    },
    "The captions of Figs. 11 and 12 have $ṽ_{d}$; with $v̂_{d}$ the stability that the text tells of does not occur.",
);

pub(super) const FIG_7_EASY: MeasuredClaim<Contact> = statement(
    "§4.2, Fig. 7",
    "With realistic $τ̃_{0}$ in 0.01 … 0.1, low loads easily flutter",
    |contact| {
        let thresholds = LOADS.map(|load| lowest(&strengths(contact, 1e-8, load).conservative));
        measured(thresholds.map(short).join(", "), thresholds[0] < 0.01)
    },
    "Thresholds at $v̂_{d}$ = 10^{−8} for $F̃_{n}$ = 10^{−8} … 10^{−4}.",
);

pub(super) const FIG_8_TRENDS: MeasuredClaim<Contact> = statement(
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
