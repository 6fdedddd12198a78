//! The law of a paraboloid: one curve instead of a plane.

use crate::contact_law::{ContactLaw, ValidityConcern};
use crate::law::data::LawData;
use crate::law::error::LawError;
use crate::law::knots::Knots;
use crate::law::limits::LawIndenter;
use crate::law::material::LawMaterial;
use crate::law::origin::LawOrigin;
use crate::law::quantities::{KnotValues, LawErrors, PerQuantity};
use crate::law::scaled::{LawReference, SPEED_RATES, ScaledLogarithm, ln_speed, logarithms};
use crate::law::scatter::{self, Doubt, Tabulated};
use crate::law::slow::put_theory;
use crate::law::spline::{left_out, pieces};
use crate::law::table::{check_values, combined, in_tails, speed_tails, tail_concern};
use crate::response::{ContactResponse, LawPoint};

/// Beyond ŷ = 0.1 a sphere is no longer a paraboloid: force 1 % off, area 3 %.
const DEEPEST: f64 = 0.1;

/// A law that depends on z = v̂/√ŷ = v τ/√(R δ) alone: F̃ = f(z) ŷ^{3/2}, Ã = g(z) ŷ, μ = m(z) √ŷ.
///
/// Exact for a paraboloid on a half-space with any creep spectrum: lengths measured in √(R δ) take depth and radius out of the
/// problem. f, g, m are C² splines in ln z through values at even knots; outside them each approaches its exact limit as
/// z with its exact factor, then z² ln z (slow), and as ln z/z (fast), without a jump in value, slope or curvature.
#[derive(Debug, Clone, PartialEq)]
pub struct CollapsedLaw {
    data: LawData,
    reference: LawReference,
    /// `[a][quantity]`: sums over the functions of ln z (a), as in a table's patch.
    pieces: Vec<[[f64; 4]; 4]>,
    /// A piece each.
    doubts: Option<Vec<Doubt>>,
}

impl CollapsedLaw {
    /// The law through f, g, m at even knots of ln z (at least three); `solver` are the relative errors of the values.
    ///
    /// # Errors
    /// A material that is none, too few knots, a wrong number of values, a value that is not positive and finite.
    pub fn new(
        material: LawMaterial,
        source: String,
        speeds: Knots,
        values: KnotValues,
        solver: PerQuantity<f64>,
    ) -> Result<Self, LawError> {
        let material = material.checked()?;
        check_values(&speeds, 1, &values)?;
        let reference = LawReference::new(&material, LawIndenter::Paraboloid);
        let limits = LawIndenter::Paraboloid.logarithms(1.0, &material)?;
        let mut scaled = logarithms(&reference, &speeds, 1, &values);
        let slow = put_theory(&mut scaled, &speeds, &[limits], &material);
        let tails = speed_tails(limits, &speeds, &material);
        let splines = scaled.as_ref().zip(tails).map(|(list, (low, high))| pieces(list, &speeds, low, high));
        let interpolation = scaled
            .as_ref()
            .zip(tails)
            .map(|(list, (low, high))| left_out(list, &speeds, low, high, SPEED_RATES));
        let piece = |index: usize| {
            let [force, area, friction] = splines.as_ref().map(|list| list[index]).into_array();
            [0, 1, 2, 3].map(|a| [force[a], area[a], friction[a], 0.0])
        };
        let pieces = (0..speeds.pieces()).map(piece).collect();
        let places: Vec<f64> = speeds.iter().collect();
        let doubts =
            Tabulated { speeds: &places, depths: &[], values: &scaled, stated: solver, slow: &slow }.doubts();
        let origin = LawOrigin { material, indenter: LawIndenter::Paraboloid, source };
        let errors = LawErrors { interpolation, solver };
        Ok(Self { data: LawData { origin, speeds, values, errors }, reference, pieces, doubts })
    }

    /// Whether there are knots enough to tell its errors.
    pub(super) fn knows_its_errors(&self) -> bool {
        self.doubts.is_some()
    }

    /// What it is made of: origin, knots, values, errors.
    #[must_use]
    pub fn data(&self) -> &LawData {
        &self.data
    }
}

impl ContactLaw for CollapsedLaw {
    #[inline(always)]
    fn evaluate(&self, at: &LawPoint) -> ContactResponse {
        let place = self.data.speeds.place(ln_speed(at), SPEED_RATES);
        let piece = &self.pieces[place.piece];
        let (value, slope) = (combined(piece, &place.basis), combined(piece, &place.slopes));
        let scaled =
            |k: usize| ScaledLogarithm { value: value[k], by_ln_speed: slope[k], by_ln_indentation: 0.0 };
        let scaled = PerQuantity { force: scaled(0), area: scaled(1), friction: scaled(2) };
        self.reference.response(at, scaled)
    }

    fn doubt(&self, at: &LawPoint) -> Option<ContactResponse> {
        let place = self.data.speeds.place(ln_speed(at), SPEED_RATES);
        let doubt = self.doubts.as_ref()?[place.piece];
        let doubt = in_tails(doubt, &place, self.data.speeds.count(), &self.pieces[place.piece]);
        Some(scatter::of_logarithms(at, &self.evaluate(at), doubt))
    }

    fn concern(&self, velocity: f64, indentation: f64) -> Option<ValidityConcern> {
        if indentation > DEEPEST {
            return Some(ValidityConcern::TooDeep { indentation, limit: DEEPEST });
        }
        let at = LawPoint::new(velocity, indentation);
        let place = self.data.speeds.place(ln_speed(&at), SPEED_RATES);
        let is_tail = place.piece == 0 || place.piece == self.data.speeds.count();
        // the term whose factor is known is no assumption
        let [_, w, wt, _] = place.basis;
        let [force, area, friction, _] = combined(&self.pieces[place.piece], &[0.0, w, wt, 0.0]);
        let away = PerQuantity { force, area, friction };
        is_tail.then(|| tail_concern(velocity, away, &self.data.errors)).flatten()
    }
}
