//! A law on a plane of speed and depth.

use crate::contact_law::{ContactLaw, ValidityConcern};
use crate::law::data::LawData;
use crate::law::error::LawError;
use crate::law::knots::{KnotPlace, Knots};
use crate::law::limits::SpeedLimits;
use crate::law::material::LawMaterial;
use crate::law::origin::LawOrigin;
use crate::law::quantities::{KnotValues, LawErrors, NAMES, PerQuantity};
use crate::law::scaled::{LawReference, SPEED_RATES, ScaledLogarithm, ln_speed, logarithms};
use crate::law::scatter::{self, Doubt, Tabulated};
use crate::law::slow::put_theory;
use crate::law::spline::{Tail, left_out, pieces};
use crate::response::{ContactResponse, LawPoint};

/// How the law leaves the table along ln ŷ: what depends on the depth shrinks as ŷ below it, and saturates above it.
const INDENTATION_RATES: (f64, f64) = (1.0, -1.0);
const INDENTATION_TAILS: (Tail, Tail) = (Tail::Relaxing { rate: 1.0 }, Tail::Levelling);

/// The smallest number of knots along the speed.
const FEWEST_SPEEDS: usize = 3;

/// The tails of each quantity below the first and above the last knot.
pub(crate) type RowTails = PerQuantity<(Tail, Tail)>;

/// The tails to the exact limits at rest and at infinite speed.
///
/// The slope at rest holds where z is small for the longest time; a table that begins later has nothing to do with it.
pub(crate) fn speed_tails(
    limits: PerQuantity<SpeedLimits>,
    speeds: &Knots,
    material: &LawMaterial,
) -> RowTails {
    let longest = material.time_span().map_or(1.0, |(_, longest)| longest);
    let first = libm::exp(speeds.first());
    let reach = first / (1.0 + (longest * first).powi(4));
    limits.map(|limits| {
        let low = Tail::ToLimit { rate: SPEED_RATES.0, limit: limits.rest, half: limits.slope * reach };
        (low, Tail::ToLimit { rate: SPEED_RATES.1, limit: limits.infinite, half: 0.0 })
    })
}

/// Refuses values that are too few or too many, or not positive and finite.
pub(crate) fn check_values(speeds: &Knots, rows: usize, values: &KnotValues) -> Result<(), LawError> {
    let columns = speeds.count();
    if columns < FEWEST_SPEEDS {
        let axis = crate::law::scaled::SPEED_AXIS;
        return Err(LawError::TooFewKnots { axis, count: columns, least: FEWEST_SPEEDS });
    }
    for (list, quantity) in values.as_ref().zip(NAMES).into_array() {
        if list.len() != rows * columns {
            return Err(LawError::WrongCount { quantity, found: list.len(), expected: rows * columns });
        }
        if let Some(index) = list.iter().position(|value| !(*value > 0.0 && value.is_finite())) {
            let (row, column) = (index / columns, index % columns);
            return Err(LawError::InvalidValue { quantity, column, row, value: list[index] });
        }
    }
    Ok(())
}

/// Names a tail that is further from its limit than the law's own error.
pub(crate) fn tail_concern(
    velocity: f64,
    away: PerQuantity<f64>,
    errors: &LawErrors,
) -> Option<ValidityConcern> {
    let worst = away
        .zip(errors.total())
        .into_array()
        .into_iter()
        .filter(|(distance, error)| distance.abs() > *error)
        .map(|(distance, _)| distance.abs())
        .reduce(f64::max)?;
    Some(ValidityConcern::SpeedBeyondTable { velocity, distance: worst })
}

/// One bicubic piece, `[a][b][quantity]`: sums over the functions of ln z (a) and of ln ŷ (b).
///
/// The quantities (and one zero) stand together, so that the sums over a and b are made for all of them by one vector instruction.
type TablePatch = [[[f64; 4]; 4]; 4];

/// Σ_a w_a c_a, entry by entry.
#[inline(always)]
pub(crate) fn combined(c: &[[f64; 4]; 4], weights: &[f64; 4]) -> [f64; 4] {
    let mut sum = [0.0; 4];
    for k in 0..4 {
        sum[k] =
            (c[0][k] * weights[0] + c[1][k] * weights[1]) + (c[2][k] * weights[2] + c[3][k] * weights[3]);
    }
    sum
}

/// [`combined`] over the functions of ln z, for each function of ln ŷ.
#[inline(always)]
pub(crate) fn along_speed(patch: &TablePatch, weights: &[f64; 4]) -> [[f64; 4]; 4] {
    let [c0, c1, c2, c3] = patch;
    let mut sums = [[0.0; 4]; 4];
    for b in 0..4 {
        for k in 0..4 {
            sums[b][k] = (c0[b][k] * weights[0] + c1[b][k] * weights[1])
                + (c2[b][k] * weights[2] + c3[b][k] * weights[3]);
        }
    }
    sums
}

/// A law over speed and depth as a C² table in ln z and ln ŷ, z = v̂/√ŷ = v τ/√(R δ), of the logarithms of f = F̃/ŷ^{3/2}, g = Ã/ŷ and
/// m = μ/√ŷ; of a cylinder on a layer of f = F̃/ŷ and g = Ã/√ŷ, per length R or for the one of [`over_length`](Self::over_length).
///
/// In these coordinates a paraboloid's law is a function of ln z alone, and a sphere's nearly so; few knots along ln ŷ suffice.
/// Outside the table the law is still C²:
///
/// - slow and fast: the exact limits ([`LawIndenter::elastic`](crate::law::limits::LawIndenter::elastic): Hertz with E0 and with E∞, friction
///   ∝ v and ∝ 1/v), approached as z, with its exact factor, then z² ln z, and as ln z/z;
/// - shallow: the collapse on z, approached as ŷ; a cylinder's levels off, which [`concern`](ContactLaw::concern) says;
/// - deep: f, g, m level off; [`concern`](ContactLaw::concern) says so.
#[derive(Debug, Clone, PartialEq)]
pub struct TabulatedLaw {
    data: LawData,
    indentations: Knots,
    reference: LawReference,
    patches: Vec<TablePatch>,
    /// A patch each.
    doubts: Option<Vec<Doubt>>,
    /// The largest deviations at left-out knots, along the speed and along the depth.
    errors_by_axis: [PerQuantity<f64>; 2],
}

impl TabulatedLaw {
    /// The law through f, g, m at even knots of ln z (at least three) and ln ŷ (at least two), speed fastest; `solver` are the relative
    /// errors of the values.
    ///
    /// # Errors
    /// A material that is none, too few knots, a wrong number of values, a value that is not positive and finite, a sphere
    /// deeper than its radius.
    pub fn new(
        origin: LawOrigin,
        speeds: Knots,
        indentations: Knots,
        values: KnotValues,
        solver: PerQuantity<f64>,
    ) -> Result<Self, LawError> {
        let origin = LawOrigin { material: origin.material.checked()?, ..origin };
        check_values(&speeds, indentations.count(), &values)?;
        let reference = LawReference::new(&origin.material, origin.indenter);
        let limits = row_limits(&origin, &indentations)?;
        let mut scaled = logarithms(&reference, &speeds, indentations.count(), &values);
        let slow = put_theory(&mut scaled, &speeds, &limits, &origin.material);
        let tails: Vec<RowTails> =
            limits.iter().map(|limits| speed_tails(*limits, &speeds, &origin.material)).collect();
        let patches = patches(&speeds, &indentations, &scaled, &tails);
        let errors_by_axis = left_out_by_axis(&speeds, &indentations, &scaled, &tails);
        let [along_speed, along_depth] = errors_by_axis;
        let interpolation = along_speed.zip(along_depth).map(|(a, b)| f64::max(a, b));
        let errors = LawErrors { interpolation, solver };
        let [places, depths]: [Vec<f64>; 2] = [speeds.iter().collect(), indentations.iter().collect()];
        let doubts =
            Tabulated { speeds: &places, depths: &depths, values: &scaled, stated: solver, slow: &slow }
                .doubts();
        let data = LawData { origin, speeds, values, errors };
        Ok(Self { data, indentations, reference, patches, doubts, errors_by_axis })
    }

    /// The law for a length L/R across the sliding, where it is one per length (the length R); any other as it is.
    #[must_use]
    pub fn over_length(self, length: f64) -> Self {
        let is_line = self.data.origin.indenter.is_line();
        let reference = if is_line { self.reference.over(length) } else { self.reference };
        Self { reference, ..self }
    }

    /// Half the length along the sliding, over R, of a contact of this Ã.
    pub(super) fn half_length(&self, area: f64) -> f64 {
        self.reference.half_length(area)
    }

    /// Whether there are knots enough to tell its errors.
    pub(super) fn knows_its_errors(&self) -> bool {
        self.doubts.is_some()
    }

    /// What it is made of: origin, knots along the speed, values, errors.
    #[must_use]
    pub fn data(&self) -> &LawData {
        &self.data
    }

    /// The knots of ln ŷ.
    #[must_use]
    pub fn ln_indentations(&self) -> &Knots {
        &self.indentations
    }

    /// The largest interpolation error along the speed and along the depth, from the knots left out along each.
    pub(crate) fn errors_by_axis(&self) -> [PerQuantity<f64>; 2] {
        self.errors_by_axis
    }

    /// Whether a depth is above the shallowest knot of a cylinder, whose law has no limit there but a logarithm.
    fn is_too_shallow(&self, at: &LawPoint) -> bool {
        self.data.origin.indenter.is_line() && at.ln_indentation < self.indentations.first()
    }

    #[inline(always)]
    fn places(&self, at: &LawPoint) -> (KnotPlace, KnotPlace, &TablePatch) {
        let speed = self.data.speeds.place(ln_speed(at), SPEED_RATES);
        let depth = self.indentations.place(at.ln_indentation, INDENTATION_RATES);
        let patch = &self.patches[depth.piece * self.data.speeds.pieces() + speed.piece];
        (speed, depth, patch)
    }
}

impl ContactLaw for TabulatedLaw {
    #[inline(always)]
    fn evaluate(&self, at: &LawPoint) -> ContactResponse {
        let (speed, depth, patch) = self.places(at);
        let here = along_speed(patch, &speed.basis);
        let value = combined(&here, &depth.basis);
        let by_ln_speed = combined(&along_speed(patch, &speed.slopes), &depth.basis);
        let by_ln_indentation = combined(&here, &depth.slopes);
        let scaled = |k: usize| ScaledLogarithm {
            value: value[k],
            by_ln_speed: by_ln_speed[k],
            by_ln_indentation: by_ln_indentation[k],
        };
        let scaled = PerQuantity { force: scaled(0), area: scaled(1), friction: scaled(2) };
        self.reference.response(at, scaled)
    }

    /// Unknown below the deepest knot, where the law levels off by assumption, and of a cylinder above the shallowest.
    fn doubt(&self, at: &LawPoint) -> Option<ContactResponse> {
        if at.ln_indentation > self.indentations.last() || self.is_too_shallow(at) {
            return None;
        }
        let (speed, depth, patch) = self.places(at);
        let doubt = self.doubts.as_ref()?[depth.piece * self.data.speeds.pieces() + speed.piece];
        let along = patch.map(|functions| combined(&functions, &depth.basis));
        let doubt = in_tails(doubt, &speed, self.data.speeds.count(), &along);
        Some(scatter::of_logarithms(at, &self.evaluate(at), doubt))
    }

    fn concern(&self, velocity: f64, indentation: f64) -> Option<ValidityConcern> {
        let at = LawPoint::new(velocity, indentation);
        let (speed, depth, patch) = self.places(&at);
        if depth.piece == self.indentations.count() && at.ln_indentation > self.indentations.last() {
            return Some(ValidityConcern::TooDeep {
                indentation,
                limit: libm::exp(self.indentations.last()),
            });
        }
        if self.is_too_shallow(&at) {
            return Some(ValidityConcern::TooShallow {
                indentation,
                limit: libm::exp(self.indentations.first()),
            });
        }
        let is_tail = speed.piece == 0 || speed.piece == self.data.speeds.count();
        // the term whose factor is known is no assumption
        let [_, w, wt, _] = speed.basis;
        let [force, area, friction, _] = combined(&along_speed(patch, &[0.0, w, wt, 0.0]), &depth.basis);
        let away = PerQuantity { force, area, friction };
        is_tail.then(|| tail_concern(velocity, away, &self.data.errors)).flatten()
    }
}

/// The limits of every row along the speed.
fn row_limits(origin: &LawOrigin, indentations: &Knots) -> Result<Vec<PerQuantity<SpeedLimits>>, LawError> {
    indentations
        .iter()
        .map(|ln_indentation| origin.indenter.logarithms(libm::exp(ln_indentation), &origin.material))
        .collect()
}

/// The doubt at a place along the speed, where `piece` is summed over: that of the piece, and in a tail what the tail makes of it.
pub(crate) fn in_tails(doubt: Doubt, place: &KnotPlace, count: usize, piece: &[[f64; 4]; 4]) -> Doubt {
    let rate = match place.piece {
        0 => SPEED_RATES.0,
        last if last == count => SPEED_RATES.1,
        _ => return doubt,
    };
    // the term whose factor is known is no assumption
    let assumed = |quantity: usize| [piece[1][quantity], piece[2][quantity]];
    let assumed = PerQuantity { force: assumed(0), area: assumed(1), friction: assumed(2) };
    scatter::in_tail(doubt, place, rate, assumed)
}

/// The bicubic pieces: splines along ln z in every row, then splines along ln ŷ through each of their coefficients.
///
/// Both steps are linear, so what holds in every row (the way to the limits, the continuity at the knots) holds between them.
fn patches(speeds: &Knots, indentations: &Knots, scaled: &KnotValues, tails: &[RowTails]) -> Vec<TablePatch> {
    let columns = speeds.count();
    let rows: Vec<PerQuantity<Vec<[f64; 4]>>> = tails
        .iter()
        .enumerate()
        .map(|(row, tails)| {
            scaled.as_ref().zip(*tails).map(|(list, (low, high))| {
                pieces(&list[row * columns..(row + 1) * columns], speeds, low, high)
            })
        })
        .collect();
    let mut patches = vec![[[[0.0; 4]; 4]; 4]; speeds.pieces() * indentations.pieces()];
    let (low, high) = INDENTATION_TAILS;
    for piece in 0..speeds.pieces() {
        for a in 0..4 {
            let column = |row: &PerQuantity<Vec<[f64; 4]>>| row.as_ref().map(|list| list[piece][a]);
            let column: Vec<PerQuantity<f64>> = rows.iter().map(column).collect();
            let along = |select: fn(&PerQuantity<f64>) -> f64| {
                pieces(&column.iter().map(select).collect::<Vec<_>>(), indentations, low, high)
            };
            let (force, area, friction) = (along(|q| q.force), along(|q| q.area), along(|q| q.friction));
            for depth in 0..indentations.pieces() {
                let patch = &mut patches[depth * speeds.pieces() + piece];
                for b in 0..4 {
                    patch[a][b] = [force[depth][b], area[depth][b], friction[depth][b], 0.0];
                }
            }
        }
    }
    patches
}

/// The largest deviations at left-out knots, along the speed and along the depth.
fn left_out_by_axis(
    speeds: &Knots,
    indentations: &Knots,
    scaled: &KnotValues,
    tails: &[RowTails],
) -> [PerQuantity<f64>; 2] {
    let columns = speeds.count();
    let mut worst = [PerQuantity::uniform(0.0_f64); 2];
    for (row, tails) in tails.iter().enumerate() {
        let here = scaled.as_ref().zip(*tails).map(|(list, (low, high))| {
            left_out(&list[row * columns..(row + 1) * columns], speeds, low, high, SPEED_RATES)
        });
        worst[0] = worst[0].zip(here).map(|(a, b)| a.max(b));
    }
    for column in 0..columns {
        let here = scaled.as_ref().map(|list| {
            let along: Vec<f64> = list.iter().copied().skip(column).step_by(columns).collect();
            let (low, high) = INDENTATION_TAILS;
            left_out(&along, indentations, low, high, INDENTATION_RATES)
        });
        worst[1] = worst[1].zip(here).map(|(a, b)| a.max(b));
    }
    worst
}
