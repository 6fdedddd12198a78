//! Stability maps (section 4.3, Figs. 9, 10).

use crate::claim::{MeasuredClaim, measured, misprint, short, statement};
use crate::oscillator::measures::{PaperPanel, SIDE, loads, log_grid, strengths};
use judder_oscillator::Contact;
use judder_oscillator::conservative::discriminant;
use judder_oscillator::equilibrium::equilibrium;
use judder_oscillator::linearisation::Linearisation;
use judder_oscillator::map::{OperatingPlane, StabilityMap, every_point};
use judder_oscillator::mechanism::StabilityClass;

/// Share of the grid points of a panel that satisfy a condition on (full system unstable, undamped system unstable).
fn share(contact: &Contact, panel: PaperPanel, condition: impl Fn(bool, bool) -> bool) -> f64 {
    let plane = panel.plane(SIDE, 1.0);
    let map = panel.map(contact);
    let holds = (0..SIDE * SIDE).filter(|index| {
        let (column, row) = (index % SIDE, index / SIDE);
        let c = plane.coefficients(column, row);
        let flutters = equilibrium(contact, &c).is_ok_and(|e| {
            discriminant(&Linearisation::new(contact.friction_load, &c, &e.response).stiffness()) < 0.0
        });
        condition(map.class(column, row).is_unstable(), flutters)
    });
    holds.count() as f64 / (SIDE * SIDE) as f64
}

/// How many points are unstable and neither flutter nor of ξ_eq < 0.
fn neither(map: &StabilityMap) -> usize {
    map.count(StabilityClass::NormalForceCoupling) + map.count(StabilityClass::DestabilisedByDamping)
}

fn per_cent(share: f64) -> String {
    format!("{:.1} %", 100.0 * share)
}

/// Speeds at which the lowest thresholds of the full and the conservative system differ by more than 10 %, or one is missing.
fn disagreement(contact: &Contact, normal_load: f64) -> Vec<f64> {
    let visible = |thresholds: &[f64]| thresholds.first().copied().filter(|t| (1e-4..=1.0).contains(t));
    log_grid(1e-8, 1e2, 101)
        .into_iter()
        .filter(|velocity| {
            let found = strengths(contact, *velocity, normal_load);
            match (visible(&found.full), visible(&found.conservative)) {
                (Some(full), Some(conservative)) => libm::log(full / conservative).abs() > 0.1,
                (None, None) => false,
                _ => true,
            }
        })
        .collect()
}

fn range(velocities: &[f64]) -> String {
    match (velocities.first(), velocities.last()) {
        (Some(first), Some(last)) => format!("{} … {}", short(*first), short(*last)),
        _ => "nowhere".to_owned(),
    }
}

pub(super) const FIG_9A_AGREEMENT: MeasuredClaim<Contact> = statement(
    "§4.3, Fig. 9a",
    "At $F̃_{n}$ = 10^{−6}, (27) is good except for $v̂_{d}$ ≈ 10^{−6} … 10^{−4}",
    |contact| {
        let off = disagreement(contact, 1e-6);
        let within = off.iter().filter(|v| (1e-7..=1e-3).contains(*v)).count();
        let holds = !off.is_empty() && within as f64 >= 0.8 * off.len() as f64;
        measured(format!("off for {}", range(&off)), holds)
    },
    "Speeds at which the lowest thresholds of the two systems differ by more than 10 %; agreement asks for four fifths of them within a decade of the \
     paper's range.",
);

pub(super) const WORSE_AT_LARGER_LOAD: MeasuredClaim<Contact> = statement(
    "§4.3, Fig. 9",
    "The agreement worsens for the larger load",
    |contact| {
        let differs = |panel| share(contact, panel, |full, undamped| full != undamped);
        let (a, b) = (differs(PaperPanel::NineA), differs(PaperPanel::NineB));
        measured(format!("{} → {}", per_cent(a), per_cent(b)), b > a)
    },
    "Share of the map in which the full and the undamped system decide differently, Fig. 9a → 9b.",
);

pub(super) const FIG_9B_ENDS: MeasuredClaim<Contact> = statement(
    "§4.3, Fig. 9b",
    "(27) is accurate at both ends of the speed, and overestimates the stable range between",
    |contact| {
        let ratio = |velocity: f64| {
            let found = strengths(contact, velocity, 1e-3);
            match (found.full.first(), found.conservative.first()) {
                (Some(full), Some(conservative)) => full / conservative,
                _ => f64::NAN,
            }
        };
        let (slow, fast) = (ratio(1e-8), ratio(1e2));
        let overestimated = share(contact, PaperPanel::NineB, |full, undamped| full && !undamped);
        let accurate = |ratio: f64| (ratio - 1.0).abs() < 0.1;
        let shown = format!(
            "ratio {} at 10^{{−8}}, {} at 10^{{2}}; {} unstable though (27) says stable",
            short(slow),
            short(fast),
            per_cent(overestimated)
        );
        measured(shown, accurate(slow) && accurate(fast) && overestimated > 0.05)
    },
    "Lowest threshold of the full system over that of (27) at $F̃_{n}$ = 10^{−3}.",
);

pub(super) const LARGER_REGION: MeasuredClaim<Contact> = statement(
    "§4.3, Fig. 9",
    "The full system has a larger unstable region than the undamped one",
    |contact| {
        let areas =
            |panel| (share(contact, panel, |full, _| full), share(contact, panel, |_, undamped| undamped));
        let (a, b) = (areas(PaperPanel::NineA), areas(PaperPanel::NineB));
        let shown = format!(
            "{} against {}; {} against {}",
            per_cent(a.0),
            per_cent(a.1),
            per_cent(b.0),
            per_cent(b.1)
        );
        measured(shown, a.0 > a.1 && b.0 > b.1)
    },
    "Unstable share of the map, full against undamped, Fig. 9a; 9b.",
);

pub(super) const PREVAILING: MeasuredClaim<Contact> = statement(
    "§4.3, Figs. 9, 10",
    "At intermediate speed negative damping (Stribeck) prevails",
    |contact| {
        let shares =
            [PaperPanel::NineA, PaperPanel::NineB, PaperPanel::TenA, PaperPanel::TenB].map(|panel| {
                let map = panel.map(contact);
                let falling = map.count(StabilityClass::NegativeDamping) + map.count(StabilityClass::Both);
                falling as f64 / (map.unstable_fraction() * (SIDE * SIDE) as f64)
            });
        let third = [PaperPanel::NineA, PaperPanel::NineB, PaperPanel::TenA, PaperPanel::TenB].map(|panel| {
            let map = panel.map(contact);
            neither(&map) as f64 / (map.unstable_fraction() * (SIDE * SIDE) as f64)
        });
        let shown =
            format!("{}; neither: {}", shares.map(per_cent).join(", "), third.map(per_cent).join(", "));
        measured(shown, shares.iter().all(|s| *s > 0.5))
    },
    "Share of the unstable area with $ξ_{eq}$ < 0, Figs. 9a, 9b, 10a, 10b; and the share that is neither that nor flutter: a velocity-dependent normal \
     force or unequal damping, which the paper does not name.",
);

pub(super) const DECOUPLED: MeasuredClaim<Contact> = misprint(
    "§4.3",
    "For $η$ = 0 the two modes are decoupled",
    |contact| {
        let shares = [PaperPanel::NineA, PaperPanel::NineB].map(|panel| {
            let map = every_point(contact, &panel.plane(SIDE, 0.0));
            let without = neither(&map);
            (map.unstable_fraction(), without as f64 / (map.unstable_fraction() * (SIDE * SIDE) as f64))
        });
        let shown = shares.map(|(unstable, without): (f64, f64)| {
            format!("{} unstable, {} of it with $ξ_{{eq}}$ > 0", per_cent(unstable), per_cent(without))
        });
        measured(shown.join("; "), shares.iter().all(|(_, without)| *without > 0.01))
    },
    "$k_{12c}$ and $c_{21}$ stay, and couple them through $p_{1}$; the equilibrium moves too. Unstable share with $η$ = 0, Fig. 9a; 9b.",
);

pub(super) const FIG_10_ENDS: MeasuredClaim<Contact> = statement(
    "§4.3, Fig. 10",
    "(28) matches the full boundary only at low and high speed",
    |contact| {
        let ratio = |velocity: f64| {
            let found = loads(contact, velocity, 0.01);
            match (found.full.last(), found.conservative.last()) {
                (Some(full), Some(conservative)) => full / conservative,
                _ => f64::NAN,
            }
        };
        let [slow, middle, fast] = [1e-8, 1e-4, 1e2].map(ratio);
        let close = |ratio: f64| (ratio - 1.0).abs() < 0.1;
        measured([slow, middle, fast].map(short).join(", "), close(slow) && close(fast) && !close(middle))
    },
    "Highest threshold of the full system over that of (28) at $v̂_{d}$ = 10^{−8}, 10^{−4}, 10^{2}, $τ̃_{0}$ = 0.01.",
);

pub(super) const FIG_10_ENLARGES: MeasuredClaim<Contact> = statement(
    "§4.3, Fig. 10",
    "The unstable region grows with the shear strength",
    |contact| {
        let (a, b) = (
            PaperPanel::TenA.map(contact).unstable_fraction(),
            PaperPanel::TenB.map(contact).unstable_fraction(),
        );
        measured(format!("{} → {}", per_cent(a), per_cent(b)), b > a)
    },
    "Unstable share of Fig. 10a → 10b, for $F̃_{n}$ from 10^{−9} to 10^{−1}.",
);
