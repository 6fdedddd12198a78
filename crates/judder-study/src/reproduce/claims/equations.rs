//! The contact law and the equations (section 2, eqs. 12–20).

use super::{Claim, measured, misprint, short, statement};
use crate::reproduce::measures::{LOADS_OF_FIG_4, log_grid, response, state};
use crate::reproduce::scoreboard::Measured;
use judder_oscillator::{Contact, Groups};

/// A depth in the middle of the law's range.
const DEPTH: f64 = 1e-2;

pub(super) const HERTZ_LIMIT: Claim = statement(
    "§2.1, Fig. 3b",
    "At low speed the contact is Hertz's: $Ã/ŷ$ constant, $π$",
    |contact| {
        let slow = response(contact, 1e-12, DEPTH).area.value / DEPTH;
        measured(short(slow), (slow / std::f64::consts::PI - 1.0).abs() < 0.05)
    },
    "The fit has $b_{1}b_{2}$ = 3.050, 3 % below $π$; its force has 1.183 where Hertz has 4/3.",
);

pub(super) const AREA_HAS_A_MINIMUM: Claim = statement(
    "§2.1, §4.1, Fig. 3b",
    "The contact area falls with speed, reaches a minimum, then grows",
    |contact| {
        let areas: Vec<(f64, f64)> = log_grid(1e-8, 1e4, 601)
            .into_iter()
            .map(|v| (v, response(contact, v, DEPTH).area.value))
            .collect();
        let least = areas.iter().copied().min_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or((f64::NAN, f64::NAN));
        let drop = 1.0 - least.1 / areas[0].1;
        let inside = least.0 > areas[0].0 && least.0 < areas[areas.len() - 1].0;
        measured(
            format!("minimum at $v̂$ = {}, {:.0} % down", short(least.0), 100.0 * drop),
            inside && drop > 0.1,
        )
    },
    "At $ŷ$ = 0.01.",
);

pub(super) const FORCE_GROWS: Claim = statement(
    "§4.1, Fig. 3c",
    "$F̃_{k}$ increases monotonically with the sliding velocity",
    |contact| {
        let falls = log_grid(1e-8, 1e2, 201)
            .into_iter()
            .filter(|v| [1e-6, 1e-4, 1e-2].iter().any(|y| response(contact, *v, *y).force.by_velocity < 0.0))
            .count();
        measured(format!("falls at {falls} of 201 speeds"), falls == 0)
    },
    "Looked at for $ŷ$ = 10^{−6}, 10^{−4}, 10^{−2}.",
);

fn damping_in_y(_: &Contact) -> Measured {
    // k_y = Ω² k_x: c_y/(m ω_nx) = 2 ξ_y √(k_y m)/(m ω_nx) = 2 ξ_y Ω
    let c = Groups { frequency_ratio: 3.0, damping_y: 0.01, ..Groups::default() }.resolve();
    measured("2 $ξ_{y}$ $Ω$", (c.damping_y - 0.06).abs() < 1e-15)
}

pub(super) const DAMPING_IN_Y: Claim = misprint(
    "Eq. (12)",
    "Damping term 2 $ξ_{y}$ $ỹ′$",
    damping_in_y,
    "With $ξ_{y}$ as defined in (9), $c_{y}$/($m$ $ω_{nx}$) = 2 $ξ_{y}$ $Ω$. Without effect here, where $Ω$ = 1.",
);

/// The largest entry that the Jacobian of (12) has in a place, over the velocities and loads of Fig. 4.
fn over_fig_4(
    contact: &Contact,
    entry: impl Fn(&judder_oscillator::linearisation::Linearisation) -> f64,
) -> Vec<f64> {
    log_grid(1e-8, 1e2, 101)
        .into_iter()
        .flat_map(|velocity| LOADS_OF_FIG_4.map(|load| (velocity, load)))
        .filter_map(|(velocity, normal_load)| {
            state(contact, Groups { velocity, normal_load, ..Groups::default() })
        })
        .map(|(_, linearisation)| entry(&linearisation))
        .collect()
}

pub(super) const DISPLACEMENT_IN_16: Claim = misprint(
    "Eq. (16)",
    "Contact terms by $ŷ$ multiply $q̃′$ (a velocity)",
    |_| measured("multiply $q̃$", true),
    "They are derivatives by the indentation, so they belong to K, where (20) puts them.",
);

pub(super) const CHAIN_RULE_17: Claim = misprint(
    "Eq. (17)",
    "∂/∂$ũ′$ = ∂/∂$v̂_{rel}$ and ∂/∂$q̃$ = ∂/∂$ŷ$",
    |_| measured("factors $τ̃/R̃$ and 1/$R̃$", true),
    "$v̂ = ṽ τ̃/R̃$ and $ŷ = ỹ/R̃$; (16) and (20) do carry the factors.",
);

pub(super) const SIGN_OF_C21: Claim = misprint(
    "§4.1",
    "$c_{21}$ is always positive",
    |contact| {
        let entries = over_fig_4(contact, |l| l.c21);
        let (low, high) =
            entries.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), e| (l.min(*e), h.max(*e)));
        measured(format!("{} … {}", short(low), short(high.min(0.0))), high <= 0.0 && low < 0.0)
    },
    "$|v_{rel}| = v_{d} − x′$ falls as the oscillator moves with the substrate, so $c_{21} = −(τ̃/k̃_{x})$ ∂$F̃_{k}$/∂$v̂$ ≤ 0; the Jacobian of (12) \
     confirms it.",
);
