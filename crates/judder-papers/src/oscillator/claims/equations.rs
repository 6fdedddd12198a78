//! The contact law and the equations (section 2, eqs. 12–20).

use crate::claim::Measured;
use crate::claim::{MeasuredClaim, measured, misprint, short, statement};
use crate::oscillator::measures::{LOADS_OF_FIG_4, log_grid, response, state};
use judder_oscillator::motion::accelerations;
use judder_oscillator::{Contact, Groups};

/// A depth in the middle of the law's range.
const DEPTH: f64 = 1e-2;

pub(super) const HERTZ_LIMIT: MeasuredClaim<Contact> = statement(
    "§2.1, Fig. 3b",
    "At low speed the contact is Hertz's: $Ã/ŷ$ constant, $π$",
    |contact| {
        let slow = response(contact, 1e-12, DEPTH).area.value / DEPTH;
        measured(short(slow), (slow / std::f64::consts::PI - 1.0).abs() < 0.05)
    },
    "The fit has $b_{1}b_{2}$ = 3.050, 3 % below $π$; its force has 1.183 where Hertz has 4/3.",
);

pub(super) const AREA_HAS_A_MINIMUM: MeasuredClaim<Contact> = statement(
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

pub(super) const FRICTION_OVER_DEPTH: MeasuredClaim<Contact> = statement(
    "§2.1, Fig. 3a",
    "$μ_{visc}$ monotonically increases with the indentation",
    |contact| {
        let falls = log_grid(1e-8, 1e2, 201)
            .into_iter()
            .filter(|v| {
                log_grid(1e-6, 1e-1, 51)
                    .iter()
                    .any(|y| response(contact, *v, *y).friction.by_indentation < 0.0)
            })
            .count();
        measured(format!("falls somewhere at {falls} of 201 speeds"), falls == 0)
    },
    "The bell (38) shifts with the depth, so below its peak speed a deeper contact rubs less; $k_{12c}$ can be positive there.",
);

pub(super) const FORCE_GROWS: MeasuredClaim<Contact> = statement(
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
    // straight from the definitions: c_y/(m ω_nx) with c_y = 2 ξ_y √(k_y m), k_y = Ω² k_x, m = k_x/ω_nx²
    let (ratio, damping, stiffness, frequency) = (3.0_f64, 0.01, 50.0_f64, 40.0_f64);
    let mass = stiffness / (frequency * frequency);
    let exact = 2.0 * damping * (ratio * ratio * stiffness * mass).sqrt() / (mass * frequency);
    let c = Groups { frequency_ratio: ratio, damping_y: damping, ..Groups::default() }.resolve();
    measured("2 $ξ_{y}$ $Ω$", (c.damping_y - exact).abs() < 1e-14)
}

pub(super) const DAMPING_IN_Y: MeasuredClaim<Contact> = misprint(
    "Eq. (12)",
    "Damping term 2 $ξ_{y}$ $ỹ′$",
    damping_in_y,
    "With $ξ_{y}$ as defined in (9), $c_{y}$/($m$ $ω_{nx}$) = 2 $ξ_{y}$ $Ω$. Without effect here, where $Ω$ = 1.",
);

/// Central differences of the x-acceleration (12) by q̃′ and by q̃ at the default point, without the structure's part.
fn contact_derivatives(contact: &Contact) -> [f64; 2] {
    let c = Groups::default().resolve();
    let Some((rest, _)) = state(contact, Groups::default()) else { return [f64::NAN; 2] };
    let at = |y: f64, velocity_y: f64| accelerations(contact, &c, &[rest.x, rest.y + y, 0.0, velocity_y])[0];
    let step = 1e-5 * rest.y;
    let slope = |plus: f64, minus: f64| (plus - minus) / (2.0 * step);
    [slope(at(0.0, step), at(0.0, -step)), slope(at(step, 0.0), at(-step, 0.0)) + c.k12]
}

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

pub(super) const DISPLACEMENT_IN_16: MeasuredClaim<Contact> = misprint(
    "Eq. (16)",
    "Contact terms by $ŷ$ multiply $q̃′$ (a velocity)",
    |contact| {
        let [by_velocity, by_displacement] = contact_derivatives(contact);
        measured("multiply $q̃$", by_velocity == 0.0 && by_displacement.abs() > 0.0)
    },
    "They are derivatives by the indentation, so they belong to K, where (20) puts them.",
);

pub(super) const CHAIN_RULE_17: MeasuredClaim<Contact> = misprint(
    "Eq. (17)",
    "∂/∂$ũ′$ = ∂/∂$v̂_{rel}$ and ∂/∂$q̃$ = ∂/∂$ŷ$",
    |contact| {
        let [_, by_displacement] = contact_derivatives(contact);
        let groups = Groups::default();
        let exact = state(contact, groups).map_or(f64::NAN, |(_, l)| -l.k12c);
        measured("factors $τ̃/R̃$ and 1/$R̃$", (by_displacement / exact - 1.0).abs() < 1e-6)
    },
    "$v̂ = ṽ τ̃/R̃$ and $ŷ = ỹ/R̃$; (16) and (20) do carry the factors.",
);

pub(super) const SIGN_OF_C21: MeasuredClaim<Contact> = misprint(
    "§4.1",
    "$c_{21}$ is always positive",
    |contact| {
        let entries = over_fig_4(contact, |l| l.c21);
        let (low, high) =
            entries.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), e| (l.min(*e), h.max(*e)));
        measured(format!("{} … {}", short(low), short(high)), high <= 0.0 && low < 0.0)
    },
    "$|v_{rel}| = v_{d} − x′$ falls as the oscillator moves with the substrate, so $c_{21} = −(τ̃/k̃_{x})$ ∂$F̃_{k}$/∂$v̂$ ≤ 0; the Jacobian of (12) \
     confirms it.",
);
