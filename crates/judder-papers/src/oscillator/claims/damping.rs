//! Equivalent damping (section 4.1, Fig. 4).

use crate::claim::{MeasuredClaim, measured, short, statement};
use crate::oscillator::measures::{
    LOADS_OF_FIG_4, STRENGTHS_OF_FIG_4, equivalent_damping, log_grid, smallest_damping,
};
use judder_oscillator::Contact;

/// ξ_x of (14).
const EXTERNAL: f64 = 0.01;

pub(super) const LIMITS: MeasuredClaim<Contact> = statement(
    "§4.1, Fig. 4",
    "$ξ_{eq}$ tends to $ξ_{x}$ = 0.01 at very low and very high speed",
    |contact| {
        let off = LOADS_OF_FIG_4
            .into_iter()
            .flat_map(|load| STRENGTHS_OF_FIG_4.map(|strength| (load, strength)))
            .flat_map(|(load, strength)| [1e-16, 1e8].map(|v| equivalent_damping(contact, v, load, strength)))
            .map(|damping| (damping - EXTERNAL).abs())
            .fold(0.0, f64::max);
        measured(format!("off by {}", short(off)), off < 1e-4)
    },
    "Largest departure at $v̂_{d}$ = 10^{−16} and 10^{8}, over all loads and strengths of Fig. 4. The true friction, linear in the speed, would \
     keep $ξ_{eq}$ above $ξ_{x}$ at rest.",
);

pub(super) const LARGE_DAMPING: MeasuredClaim<Contact> = statement(
    "§4.1, Fig. 4",
    "As the speed grows, a large equivalent damping appears",
    |contact| {
        let largest = LOADS_OF_FIG_4.map(|load| {
            log_grid(1e-8, 1e2, 801)
                .into_iter()
                .map(|v| equivalent_damping(contact, v, load, 0.0))
                .fold(f64::NEG_INFINITY, f64::max)
        });
        measured(largest.map(short).join(", "), largest.iter().all(|l| *l > 10.0 * EXTERNAL))
    },
    "Largest $ξ_{eq}$ at $τ̃_{0}$ = 0, from the largest load to the smallest.",
);

pub(super) const NEGATIVE_NEAR: MeasuredClaim<Contact> = statement(
    "§4.1, Fig. 4 insets",
    "For very small $τ̃_{0}$, $ξ_{eq}$ becomes negative at $v̂_{d}$ ≈ 10^{−2}",
    |contact| {
        let crossings: Vec<Option<f64>> = LOADS_OF_FIG_4
            .iter()
            .map(|load| {
                log_grid(1e-6, 1e2, 801)
                    .into_iter()
                    .find(|v| equivalent_damping(contact, *v, *load, 0.0) < 0.0)
            })
            .collect();
        let found: Vec<f64> = crossings.iter().flatten().copied().collect();
        let typical = libm::exp(found.iter().map(|v| libm::log(*v)).sum::<f64>() / found.len() as f64);
        let shown: Vec<String> = crossings.iter().map(|v| v.map_or("never".to_owned(), short)).collect();
        // a mean of nothing is NaN, which is in no range
        measured(shown.join(", "), (0.5e-2..2e-2).contains(&typical))
    },
    "First speed with $ξ_{eq}$ < 0 at $τ̃_{0}$ = 0, from the largest load to the smallest, where it stays positive (the text says “in all the panels”); \
     judged by their geometric mean within a factor 2.",
);

pub(super) const STRENGTH_REDUCES: MeasuredClaim<Contact> = statement(
    "§4.1, Fig. 4",
    "Increasing $τ̃_{0}$ reduces $ξ_{eq}$ at intermediate speed",
    |contact| {
        let smallest: Vec<[f64; 4]> = LOADS_OF_FIG_4
            .iter()
            .map(|load| STRENGTHS_OF_FIG_4.map(|strength| smallest_damping(contact, *load, strength).0))
            .collect();
        let falls = smallest.iter().all(|by_strength| by_strength.windows(2).all(|pair| pair[1] < pair[0]));
        let shown: Vec<String> =
            smallest.iter().map(|s| format!("{} → {}", short(s[0]), short(s[3]))).collect();
        measured(shown.join("; "), falls)
    },
    "Smallest $ξ_{eq}$ over speed, at $τ̃_{0}$ = 0 → 0.1, from the largest load to the smallest.",
);

pub(super) const NEGATIVE_AT_LOW_LOAD: MeasuredClaim<Contact> = statement(
    "§4.1, Fig. 4",
    "At low load the shear strength brings $ξ_{eq}$ below zero",
    |contact| {
        let (damping, velocity) = smallest_damping(contact, LOADS_OF_FIG_4[3], 0.1);
        measured(format!("{} at $v̂_{{d}}$ = {}", short(damping), short(velocity)), damping < 0.0)
    },
    "$F̃_{n}$ = 7.5 × 10^{−5}, $τ̃_{0}$ = 0.1.",
);

pub(super) const STRENGTH_RAISES_AT_HIGH_SPEED: MeasuredClaim<Contact> = statement(
    "§4.1, Fig. 4",
    "At high speed, the higher $τ̃_{0}$ the higher $ξ_{eq}$",
    |contact| {
        /// Beyond the minimum of the area at every load of Fig. 4, for the printed axis.
        const FAST: f64 = 0.3;
        let gains = LOADS_OF_FIG_4.map(|load| {
            equivalent_damping(contact, FAST, load, 0.1) - equivalent_damping(contact, FAST, load, 0.0)
        });
        measured(
            gains.map(|gain| format!("+{}", short(gain)).replace("+−", "−")).join(", "),
            gains.iter().all(|g| *g > 0.0),
        )
    },
    "$ξ_{eq}$ at $τ̃_{0}$ = 0.1 less that at 0, at $v̂_{d}$ = 0.3, from the largest load to the smallest.",
);
