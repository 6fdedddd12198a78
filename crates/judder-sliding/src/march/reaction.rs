//! The contact's force in one step, by each method.

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

/// What the contact does in a step.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
pub enum ContactState {
    /// The slider slides along the track.
    #[default]
    Slip,
    /// It stays where it is.
    Stick,
    /// It has lifted off.
    Open,
}

/// Force on the slider along normal and tangent, N.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Reaction {
    pub(super) normal: f64,
    pub(super) tangential: f64,
    pub(super) state: ContactState,
}

const OPEN: Reaction = Reaction { normal: 0.0, tangential: 0.0, state: ContactState::Open };

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
    if compliance <= 0.0 || compliance.is_nan() {
        return Err(Locked { compliance, direction });
    }
    let normal = -approach.gap / compliance;
    if normal < 0.0 {
        return Ok(OPEN);
    }
    let tangential = -direction * approach.friction * normal;
    Ok(Reaction { normal, tangential, state: ContactState::Slip })
}

/// Sweeps after which the state of the contact must have settled.
const SWEEPS: usize = 100;

/// Forward increment Lagrange multipliers: a stick trial, then Gauss–Seidel sweeps that project the force onto Coulomb's cone.
///
/// N. J. Carpenter, R. L. Taylor, M. G. Katona, *Lagrange constraints for transient finite element surface contact*, Int. J. Numer.
/// Meth. Engng 32 (1991). Slip against the force of the stick trial is tried before the sweeps. Once two of these agree on the direction
/// of slip, the equations of that state are solved.
#[inline]
pub(super) fn projected(approach: &Approach) -> Result<Reaction, Locked> {
    if approach.gap >= 0.0 {
        return Ok(OPEN);
    }
    let [nn, nt, tn, tt] = approach.compliance;
    let Approach { gap, slip, friction, .. } = *approach;
    // the stick trial: no gap and no slip
    let determinant = nn * tt - nt * tn;
    let trial = Reaction {
        normal: (nt * slip - tt * gap) / determinant,
        tangential: (tn * gap - nn * slip) / determinant,
        state: ContactState::Stick,
    };
    if trial.normal >= 0.0 && trial.tangential.abs() <= friction * trial.normal {
        return Ok(trial);
    }
    // most often it slides against the force that stick would need; where slip is indeed that way, this is the projection
    let side = trial.tangential.signum();
    if let Ok(guess) = sliding(approach, -side)
        && guess.normal > 0.0
        && (slip + tn * guess.normal + tt * guess.tangential) * side < 0.0
    {
        return Ok(guess);
    }
    let (mut normal, mut tangential) = (-gap / nn, 0.0);
    let mut before = f64::NAN;
    for _ in 0..SWEEPS {
        tangential = (-(slip + tn * normal) / tt).clamp(-friction * normal, friction * normal);
        normal = (-(gap + nt * tangential) / nn).max(0.0);
        let side = if tangential.abs() < friction * normal { 0.0 } else { tangential.signum() };
        if side == before && side != 0.0 {
            break;
        }
        before = side;
    }
    if normal == 0.0 {
        return Ok(OPEN);
    }
    sliding(approach, -tangential.signum())
}

#[cfg(test)]
mod tests {
    use super::*;
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
            match reaction.state {
                ContactState::Stick => prop_assert!(slip.abs() < 1e-13),
                ContactState::Slip => prop_assert!(reaction.tangential * slip <= 1e-13),
                ContactState::Open => prop_assert!(reaction.normal == 0.0),
            }
        }

        /// While it slides in the known direction, both methods give the same force.
        #[test]
        fn both_agree_while_sliding(gap in -1.0..-0.01_f64, nn in 0.5..2.0_f64, nt in -0.3..0.3_f64, friction in 0.0..0.5_f64) {
            let approach = Approach { gap, slip: 5.0, compliance: [nn, nt, nt, 1.0], friction };
            prop_assert_eq!(projected(&approach).unwrap(), sliding(&approach, 1.0).unwrap());
        }
    }

    #[test]
    fn a_contact_that_cannot_open_is_locked() {
        let approach = Approach { gap: -1.0, slip: 1.0, compliance: [1.0, 0.5, 0.5, 1.0], friction: 3.0 };
        assert_eq!(sliding(&approach, 1.0), Err(Locked { compliance: -0.5, direction: 1.0 }));
    }
}
