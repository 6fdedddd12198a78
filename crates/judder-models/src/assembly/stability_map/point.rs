//! A point of a map: its verdict, and what feeds the fastest growing mode.

use crate::assembly::swept::{SlidingState, SweptAssembly};
use crate::error::ModelError;
use judder_assembly::linearised::ContactTerm;
use judder_assembly::work::{GrowthShares, Worker, growth_shares};
use judder_report::Role;
use judder_structure::complex_modes::{ComplexMode, Verdict};
use judder_structure::onset::StabilityAt;
use judder_structure::quadratic::Region;

/// What a point of a map is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum PointVerdict {
    Stable,
    Marginal,
    Coupling,
    FallingFriction,
    SpeedCoupling,
    Structures,
    Divergence,
    Unresolved,
    TurningNormal,
    ConvectedSlip,
    AcrossSlip,
    UnknownGrowth,
}

impl PointVerdict {
    pub(super) const ALL: [Self; 12] = [
        Self::Stable,
        Self::Marginal,
        Self::Coupling,
        Self::FallingFriction,
        Self::SpeedCoupling,
        Self::Structures,
        Self::Divergence,
        Self::Unresolved,
        Self::TurningNormal,
        Self::ConvectedSlip,
        Self::AcrossSlip,
        Self::UnknownGrowth,
    ];

    /// Its code in arrays.
    pub(super) fn code(self) -> u8 {
        Self::ALL.iter().position(|own| *own == self).unwrap_or_default() as u8
    }

    /// Its words in legends.
    pub(super) fn words(self) -> &'static str {
        match self {
            Self::Stable => "stable",
            Self::Marginal => "marginal",
            Self::Coupling => "unstable, fed by the coupling of normal and friction forces",
            Self::FallingFriction => "unstable, fed by falling friction",
            Self::SpeedCoupling => "unstable, fed by normal forces that follow the speed",
            Self::Structures => "unstable, fed by the structures",
            Self::TurningNormal => "unstable, fed by forces that turn with the deformed track",
            Self::ConvectedSlip => "unstable, fed by friction that follows the passing material",
            Self::AcrossSlip => "unstable, fed by friction across the slip",
            Self::UnknownGrowth => "unstable, what feeds it is not known",
            Self::Divergence => "divergence",
            Self::Unresolved => "not known",
        }
    }

    /// Its colour.
    pub(super) fn role(self) -> Role {
        match self {
            Self::Stable => Role::Stable,
            Self::Marginal => Role::Reference,
            Self::Coupling => Role::Flutter,
            Self::FallingFriction => Role::NegativeDamping,
            Self::SpeedCoupling => Role::NormalForceCoupling,
            Self::Structures => Role::DestabilisedByDamping,
            Self::TurningNormal => Role::TurningNormal,
            Self::ConvectedSlip => Role::ConvectedSlip,
            Self::AcrossSlip => Role::AcrossSlip,
            Self::UnknownGrowth => Role::UnknownGrowth,
            Self::Divergence => Role::Both,
            Self::Unresolved => Role::Unresolved,
        }
    }

    /// Whether a mode grows.
    pub(super) fn is_unstable(self) -> bool {
        !matches!(self, Self::Stable | Self::Marginal | Self::Unresolved)
    }
}

/// What is known at a point.
#[derive(Debug, Clone)]
pub(super) struct MapPoint {
    pub(super) verdict: PointVerdict,
    /// Of the fastest growing or slowest decaying mode, in 1/s, and its frequency in Hz; NaN where there is none.
    pub(super) growth: f64,
    pub(super) frequency: f64,
    /// Whether that mode grows and is too fast for the law of a sphere.
    pub(super) is_beyond_laws: bool,
    /// The first that is to be said of its steady sliding.
    pub(super) doubt: Option<String>,
    /// For onsets between it and its neighbours; `None` where there is no steady sliding.
    pub(super) stability: Option<StabilityAt>,
}

impl MapPoint {
    /// A point of which nothing is known.
    pub(super) const UNKNOWN: Self = Self {
        verdict: PointVerdict::Unresolved,
        growth: f64::NAN,
        frequency: f64::NAN,
        is_beyond_laws: false,
        doubt: None,
        stability: None,
    };

    pub(super) fn new(
        family: &SweptAssembly<'_>,
        state: &SlidingState,
        region: &Region,
    ) -> Result<Self, ModelError> {
        let solved = family.solved_alone(state, region)?;
        let fastest =
            solved.modes.iter().max_by(|a, b| a.eigenvalue.value.re.total_cmp(&b.eigenvalue.value.re));
        let grows = fastest.map(|mode| mode.eigenvalue.verdict());
        let verdict = match (fastest, grows) {
            (Some(mode), Some(Verdict::Unstable)) => fed_by(family, state, mode)?,
            // growing modes may be among those that are missing
            _ if !solved.gaps.is_empty() => PointVerdict::Unresolved,
            (_, Some(Verdict::Marginal)) => PointVerdict::Marginal,
            _ => PointVerdict::Stable,
        };
        Ok(Self {
            verdict,
            growth: fastest.map_or(f64::NAN, |mode| mode.eigenvalue.value.re),
            frequency: fastest.map_or(f64::NAN, |mode| mode.eigenvalue.frequency_hz()),
            is_beyond_laws: verdict.is_unstable()
                && fastest.is_some_and(|mode| state.is_beyond_laws(&mode.eigenvalue)),
            doubt: state.doubts.first().cloned(),
            stability: Some(solved.stability(state.pieces.clone())),
        })
    }
}

/// What adds most to the growth rate of a mode.
fn fed_by(
    family: &SweptAssembly<'_>,
    state: &SlidingState,
    mode: &ComplexMode,
) -> Result<PointVerdict, ModelError> {
    if mode.eigenvalue.frequency_hz() == 0.0 {
        return Ok(PointVerdict::Divergence);
    }
    let about = family.about(state)?;
    let value = mode.eigenvalue.value;
    Ok(PointVerdict::fed_by(growth_shares(&about, value, &about.expanded(&mode.right))?))
}

impl PointVerdict {
    /// By what adds most to a growth rate: not known where nothing does, or where more than that is missing.
    fn fed_by(shares: Option<GrowthShares>) -> Self {
        let Some(GrowthShares { shares, balance }) = shares else { return Self::UnknownGrowth };
        let largest = shares.into_iter().max_by(|a, b| a.1.total_cmp(&b.1));
        match largest.filter(|(_, growth)| *growth > balance.abs()) {
            Some((Worker::MaterialDamping | Worker::Circulation, _)) => Self::Structures,
            Some((Worker::Contact(_, term), _)) => match term {
                ContactTerm::NormalTangentialCoupling => Self::Coupling,
                ContactTerm::FallingFriction => Self::FallingFriction,
                ContactTerm::SpeedNormalCoupling => Self::SpeedCoupling,
                ContactTerm::TurningNormal => Self::TurningNormal,
                ContactTerm::ConvectedSlip => Self::ConvectedSlip,
                ContactTerm::FrictionAcrossSlip => Self::AcrossSlip,
                // symmetric: it does no work
                ContactTerm::NormalStiffness => Self::UnknownGrowth,
            },
            // neither does what is skew
            Some((Worker::Gyroscopic(_), _)) | None => Self::UnknownGrowth,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fed_by(shares: &[(Worker, f64)], balance: f64) -> PointVerdict {
        PointVerdict::fed_by(Some(GrowthShares { shares: shares.to_vec(), balance }))
    }

    #[test]
    fn growth_is_told_of_what_feeds_it_and_of_nothing_else() {
        let damped = (Worker::MaterialDamping, -3.0);
        for (term, expected) in [
            (ContactTerm::NormalTangentialCoupling, PointVerdict::Coupling),
            (ContactTerm::FallingFriction, PointVerdict::FallingFriction),
            (ContactTerm::SpeedNormalCoupling, PointVerdict::SpeedCoupling),
            (ContactTerm::TurningNormal, PointVerdict::TurningNormal),
            (ContactTerm::ConvectedSlip, PointVerdict::ConvectedSlip),
            (ContactTerm::FrictionAcrossSlip, PointVerdict::AcrossSlip),
        ] {
            assert_eq!(fed_by(&[damped, (Worker::Contact(0, term), 5.0)], 1e-9), expected);
        }
        assert_eq!(fed_by(&[(Worker::Circulation, 2.0)], 0.0), PointVerdict::Structures);
        // of a mode without energy, and of one whose shares are its error
        assert_eq!(PointVerdict::fed_by(None), PointVerdict::UnknownGrowth);
        assert_eq!(fed_by(&[(Worker::Circulation, 2.0)], 3.0), PointVerdict::UnknownGrowth);
        assert_eq!(fed_by(&[damped], 4.0), PointVerdict::UnknownGrowth);
        let codes = PointVerdict::ALL.map(PointVerdict::code);
        assert!(codes.iter().enumerate().all(|(k, code)| usize::from(*code) == k));
    }
}
