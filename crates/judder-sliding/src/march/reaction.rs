//! The contact's force in one step, by each method.

use judder_numerics::contact_state::ContactState;

/// What the contact is about to do, along its normal and tangent.
#[derive(Debug, Clone, Copy)]
pub(super) struct Approach {
    /// Gap that there would be without a force, less the one that there should be, m.
    pub(super) gap: f64,
    /// Slip in this step that there would be without a force, m.
    pub(super) slip: f64,
    /// What unit forces along normal and tangent open, m/N: nn, nt, tn, tt.
    pub(super) compliance: [f64; 4],
    /// μ.
    pub(super) friction: f64,
}

/// What the contact does in a step, whichever way it slides.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Grip {
    /// The slider slides along the track.
    Slip,
    /// It stays where it is.
    Stick,
    /// It has lifted off.
    Open,
}

impl Grip {
    /// The state of a contact that slides so fast along the path: against it is ahead.
    #[inline]
    pub(super) fn state(self, along: f64) -> ContactState {
        match self {
            Self::Stick => ContactState::Stick,
            Self::Open => ContactState::LiftOff,
            Self::Slip if along < 0.0 => ContactState::SlipAhead,
            Self::Slip => ContactState::SlipBehind,
        }
    }
}

/// Force on the slider along normal and tangent, N.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Reaction {
    pub(super) normal: f64,
    pub(super) tangential: f64,
    pub(super) grip: Grip,
}

const OPEN: Reaction = Reaction { normal: 0.0, tangential: 0.0, grip: Grip::Open };

/// The slider locks: what a unit normal force with its friction opens at once is not positive.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Locked {
    /// Of that, m/N.
    pub(super) compliance: f64,
    /// σ, in which it would slide.
    pub(super) direction: f64,
}

/// Steady sliding in a direction σ that is known: N = −gap/(c·e), T = −σ μ N; equation (15). A contact does not pull.
#[inline]
pub(super) fn sliding(approach: &Approach, direction: f64) -> Result<Reaction, Locked> {
    let [nn, nt, _, _] = approach.compliance;
    let compliance = nn - direction * approach.friction * nt;
    let normal = -approach.gap / compliance;
    // a number that is none locks as well
    if !(compliance > 0.0 && normal.is_finite()) {
        return Err(Locked { compliance, direction });
    }
    if normal < 0.0 {
        return Ok(OPEN);
    }
    let tangential = -direction * approach.friction * normal;
    Ok(Reaction { normal, tangential, grip: Grip::Slip })
}

/// Forward increment Lagrange multipliers: the force that obeys Signorini's and Coulomb's laws at the end of the step, where Gauss–Seidel
/// sweeps onto Coulomb's cone come to rest.
///
/// N. J. Carpenter, R. L. Taylor, M. G. Katona, *Lagrange constraints for transient finite element surface contact*, Int. J. Numer.
/// Meth. Engng 32 (1991). One contact in the plane needs no sweeps: its three states can be told beforehand. Without penetration it is open.
/// With it N > 0 closes the gap; under T = τ N with |τ| ≤ μ, N = −gap/(nn + nt τ), and the slip becomes f(τ)/(nn + nt τ) with
/// f(τ) = (nn slip − tn gap) + (nt slip − tt gap) τ. Where nn > μ |nt|, its derivative −gap (nn tt − nt tn)/(nn + nt τ)² is not negative,
/// since the compliance is symmetric and not negative either. So just one of these holds: f(−μ) ≥ 0, and it slides on; f(μ) ≤ 0, and it
/// slides back; f has its root between, and it sticks.
///
/// Where sliding one way locks (nn ≤ μ |nt|), a contact that stick holds back from going that way is [`Locked`].
#[inline]
pub(super) fn projected(approach: &Approach) -> Result<Reaction, Locked> {
    if approach.gap >= 0.0 {
        return Ok(OPEN);
    }
    let [nn, nt, tn, tt] = approach.compliance;
    let Approach { gap, slip, friction, .. } = *approach;
    let (fixed, rising) = (nn * slip - tn * gap, nt * slip - tt * gap);
    let opened = |share: f64| nn + nt * share;
    for direction in [1.0, -1.0] {
        if direction * fixed >= friction * rising && opened(-direction * friction) > 0.0 {
            return sliding(approach, direction);
        }
    }
    let share = -fixed / rising;
    let normal = -gap / opened(share);
    let is_held = share.abs() <= friction && normal > 0.0 && normal.is_finite();
    if is_held && opened(friction.copysign(share)) > 0.0 {
        return Ok(Reaction { normal, tangential: share * normal, grip: Grip::Stick });
    }
    Err(Locked { compliance: nn - friction * nt.abs(), direction: nt.signum() })
}

#[cfg(test)]
mod tests {
    use super::*;
    use judder_numerics::counter::uniform;
    use proptest::prelude::*;

    fn gap_and_slip(approach: &Approach, reaction: &Reaction) -> (f64, f64) {
        let [nn, nt, tn, tt] = approach.compliance;
        (
            approach.gap + nn * reaction.normal + nt * reaction.tangential,
            approach.slip + tn * reaction.normal + tt * reaction.tangential,
        )
    }

    proptest! {
        /// Signorini and Coulomb hold after every solve: N ≥ 0, gap ≥ 0, N gap = 0, |T| ≤ μ N, T opposes slip, and no slip inside the cone.
        #[test]
        fn the_force_obeys_signorini_and_coulomb(
            gap in -1.0..0.2_f64, slip in -1.0..1.0_f64, nn in 0.5..2.0_f64, tt in 0.5..2.0_f64,
            coupling in -0.9..0.9_f64, friction in 0.0..0.5_f64,
        ) {
            let nt = coupling * (nn * tt).sqrt();
            let approach = Approach { gap, slip, compliance: [nn, nt, nt, tt], friction };
            // beyond, the slider may lock
            prop_assume!(friction * nt.abs() < nn);
            let reaction = projected(&approach).unwrap();
            let (gap, slip) = gap_and_slip(&approach, &reaction);
            prop_assert!(reaction.normal >= 0.0 && gap >= -1e-14);
            prop_assert!((reaction.normal * gap).abs() < 1e-13);
            prop_assert!(reaction.tangential.abs() <= friction * reaction.normal * (1.0 + 1e-14));
            match reaction.grip {
                Grip::Stick => prop_assert!(slip.abs() < 1e-13),
                Grip::Slip => prop_assert!(reaction.tangential * slip <= 1e-13),
                Grip::Open => prop_assert!(reaction.normal == 0.0),
            }
        }

        /// While it slides in the known direction, both methods give the same force.
        #[test]
        fn both_agree_while_sliding(gap in -1.0..-0.01_f64, nn in 0.5..2.0_f64, nt in -0.3..0.3_f64, friction in 0.0..0.5_f64) {
            let approach = Approach { gap, slip: 5.0, compliance: [nn, nt, nt, 1.0], friction };
            prop_assert_eq!(projected(&approach).unwrap(), sliding(&approach, 1.0).unwrap());
        }
    }

    /// A plain Gauss–Seidel projection: the tangential force onto the cone, the normal force onto what does not pull, until neither changes.
    fn swept(approach: &Approach) -> (f64, f64) {
        let [nn, nt, tn, tt] = approach.compliance;
        let (mut normal, mut tangential) = (0.0, 0.0);
        for _ in 0..10_000 {
            let before = (normal, tangential);
            normal = (-(approach.gap + nt * tangential) / nn).max(0.0);
            let bound = approach.friction * normal;
            tangential = (-(approach.slip + tn * normal) / tt).clamp(-bound, bound);
            if (normal, tangential) == before {
                break;
            }
        }
        (normal, tangential)
    }

    /// Random approaches of any state: the cases give the force on which the sweeps come to rest.
    #[test]
    fn the_cases_are_the_limit_of_the_sweeps() {
        let mut counts = [0_u32; 4];
        for draw in 0..100_000_u64 {
            let drawn = |k: u64, from: f64, to: f64| from + (to - from) * uniform(17, 8 * draw + k);
            let (nn, tt) = (drawn(0, 0.5, 2.0), drawn(1, 0.5, 2.0));
            let nt = drawn(2, -0.9, 0.9) * f64::sqrt(nn * tt);
            let friction = drawn(3, 0.0, 1.5).min(0.9 * nn / nt.abs());
            let (gap, slip) = (drawn(4, -1.0, 0.3), drawn(5, -1.5, 1.5));
            let approach = Approach { gap, slip, compliance: [nn, nt, nt, tt], friction };
            let Reaction { normal, tangential, grip } = projected(&approach).unwrap();
            let (n, t) = swept(&approach);
            let difference = (normal - n).abs().max((tangential - t).abs());
            assert!(difference < 1e-10 * n.max(1.0), "{approach:?}: {normal} {tangential}, {n} {t}");
            counts[match grip {
                Grip::Open => 0,
                Grip::Stick => 1,
                Grip::Slip if tangential <= 0.0 => 2,
                Grip::Slip => 3,
            }] += 1;
        }
        assert!(counts.iter().all(|count| *count > 10_000), "{counts:?}");
    }

    /// Whatever finite numbers come, there is a force within the cone or the slider locks: nothing panics, no force is NaN.
    #[test]
    fn no_approach_is_beyond_the_cases() {
        let values = [0.0, -0.0, 1.0, -1.0, 1e-300, -1e-300, 5e-324, 0.3, -0.3, 1e20];
        let frictions = [0.0, 5e-324, 0.3, 30.0];
        let of = |number: usize, place: u32| values[number / values.len().pow(place) % values.len()];
        for number in 0..values.len().pow(5) {
            let compliance = [of(number, 0), of(number, 1), of(number, 1), of(number, 2)];
            for friction in frictions {
                let approach = Approach { gap: of(number, 3), slip: of(number, 4), compliance, friction };
                if let Ok(Reaction { normal, tangential, .. }) = projected(&approach) {
                    let is_within = tangential.abs() <= friction * normal * (1.0 + 1e-14) + f64::MIN_POSITIVE;
                    assert!(normal >= 0.0 && is_within, "{approach:?}: {normal} {tangential}");
                }
            }
        }
    }

    /// Where it cannot slide on, it slides back or sticks with a force that pulls it on; held back by stick it is locked.
    #[test]
    fn a_contact_that_locks_one_way_slides_the_other() {
        let of = |slip: f64| {
            projected(&Approach { gap: -1.0, slip, compliance: [1.0, 0.5, 0.5, 1.0], friction: 3.0 })
        };
        let back = of(-2.0).unwrap();
        assert_eq!((back.grip, back.normal, back.tangential), (Grip::Slip, 0.4, 3.0 * 0.4));
        assert_eq!(of(-1.0).map(|held| held.grip), Ok(Grip::Stick));
        assert_eq!(of(1.0), Err(Locked { compliance: -0.5, direction: 1.0 }));
    }

    #[test]
    fn a_contact_that_cannot_open_is_locked() {
        let approach = Approach { gap: -1.0, slip: 1.0, compliance: [1.0, 0.5, 0.5, 1.0], friction: 3.0 };
        assert_eq!(sliding(&approach, 1.0), Err(Locked { compliance: -0.5, direction: 1.0 }));
    }
}
