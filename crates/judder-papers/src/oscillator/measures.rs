//! What the claims are measured with.

use judder_contact::ContactLaw;
use judder_contact::LawPoint;
use judder_oscillator::critical::{ParameterRange, RangeScale, Thresholds, thresholds};
use judder_oscillator::equilibrium::{Equilibrium, equilibrium};
use judder_oscillator::linearisation::Linearisation;
use judder_oscillator::map::{CoefficientPlane, StabilityMap, SweptCoefficient, every_point};
use judder_oscillator::{Contact, Groups};

/// The loads of Fig. 4, from the largest.
pub(super) const LOADS_OF_FIG_4: [f64; 4] = [7.5e-2, 7.5e-3, 7.5e-4, 7.5e-5];
/// The shear strengths of Fig. 4.
pub(super) const STRENGTHS_OF_FIG_4: [f64; 4] = [0.0, 0.01, 0.05, 0.1];

/// Points from `from` to `to`, evenly in the logarithm, both ends among them.
pub(super) fn log_grid(from: f64, to: f64, points: usize) -> Vec<f64> {
    let range = ParameterRange { from, to, scale: RangeScale::Logarithmic };
    (0..points).map(|k| range.value(k as f64 / (points - 1) as f64)).collect()
}

/// Steady sliding and its linearisation; `None` without an equilibrium.
pub(super) fn state(contact: &Contact, groups: Groups) -> Option<(Equilibrium, Linearisation)> {
    let c = groups.coefficients().ok()?;
    let e = equilibrium(contact, &c).ok()?;
    Some((e, Linearisation::new(contact.friction_load, &c, &e.response)))
}

/// ξ_eq, NaN without an equilibrium.
pub(super) fn equivalent_damping(
    contact: &Contact,
    velocity: f64,
    normal_load: f64,
    shear_strength: f64,
) -> f64 {
    state(contact, Groups { velocity, normal_load, shear_strength, ..Groups::default() })
        .map_or(f64::NAN, |(_, linearisation)| linearisation.equivalent_damping())
}

/// The smallest ξ_eq over the speeds of Fig. 4, and where it is.
pub(super) fn smallest_damping(contact: &Contact, normal_load: f64, shear_strength: f64) -> (f64, f64) {
    log_grid(1e-8, 1e2, 801)
        .into_iter()
        .map(|velocity| (equivalent_damping(contact, velocity, normal_load, shear_strength), velocity))
        .fold((f64::INFINITY, f64::NAN), |least, here| if here.0 < least.0 { here } else { least })
}

/// All thresholds of the shear strength, as in Fig. 7.
pub(super) fn strengths(contact: &Contact, velocity: f64, normal_load: f64) -> Thresholds {
    let range = ParameterRange { from: 1e-6, to: 1e3, scale: RangeScale::Logarithmic };
    thresholds(contact, &range, 361, |shear_strength| {
        Groups { velocity, normal_load, shear_strength, ..Groups::default() }.resolve()
    })
}

/// All thresholds of the load, as in Fig. 8.
pub(super) fn loads(contact: &Contact, velocity: f64, shear_strength: f64) -> Thresholds {
    let range = ParameterRange { from: 1e-12, to: 1.0, scale: RangeScale::Logarithmic };
    thresholds(contact, &range, 481, |normal_load| {
        Groups { velocity, normal_load, shear_strength, ..Groups::default() }.resolve()
    })
}

/// A panel of Figs. 9 and 10.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum PaperPanel {
    /// F̃_n = 1e-6.
    NineA,
    /// F̃_n = 1e-3.
    NineB,
    /// τ̃0 = 1e-2.
    TenA,
    /// τ̃0 = 1e-1.
    TenB,
}

impl PaperPanel {
    /// The plane of a panel on a grid of `side` × `side` points, with the coupling η.
    pub(super) fn plane(self, side: usize, coupling: f64) -> CoefficientPlane {
        let velocities = log_grid(1e-8, 1e2, side);
        let of_fig_9 = || (SweptCoefficient::ShearStrength, log_grid(1e-4, 1.0, side));
        let of_fig_10 = || (SweptCoefficient::NormalLoad, log_grid(1e-9, 1e-1, side));
        let base = Groups { coupling, ..Groups::default() };
        let (groups, y) = match self {
            Self::NineA => (Groups { normal_load: 1e-6, ..base }, of_fig_9()),
            Self::NineB => (Groups { normal_load: 1e-3, ..base }, of_fig_9()),
            Self::TenA => (Groups { shear_strength: 1e-2, ..base }, of_fig_10()),
            Self::TenB => (Groups { shear_strength: 1e-1, ..base }, of_fig_10()),
        };
        CoefficientPlane { base: groups.resolve(), x: (SweptCoefficient::Velocity, velocities), y }
    }

    /// The map of a panel, every point decided.
    pub(super) fn map(self, contact: &Contact) -> StabilityMap {
        every_point(contact, &self.plane(SIDE, 1.0))
    }
}

/// Points along each side of the maps that claims are measured on.
pub(super) const SIDE: usize = 200;

/// The law's response at a point.
pub(super) fn response(
    contact: &Contact,
    velocity: f64,
    indentation: f64,
) -> judder_contact::ContactResponse {
    contact.law.evaluate(&LawPoint::new(velocity, indentation))
}
