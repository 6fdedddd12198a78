//! How far values and slopes of a law may be off, as its own knots show.
//!
//! A law goes through contacts that are solved one by one, and its slopes divide their errors by the distance h of the knots. Two interpolations
//! of the same values tell how large these errors are: every knot against the cubic through its four neighbours. With independent
//! errors ε of the values the difference is √(1 + 34/36) ε = 1.4 ε, of a smooth function it is h⁴ s⁗/6. The slope of a spline is
//! off by 1.8 ε/h in the middle between two knots, where it is worst, and by h³ s⁗/24: by 1.3 and by 0.25 of the difference over h. So
//! one number stands for both. What the solver states of its contacts bounds their values; it is a bound of the worst, tens of times what they scatter.

use crate::law::differences::differences;
use crate::law::knots::KnotPlace;
use crate::law::quantities::{KnotValues, PerQuantity};
use crate::law::scaled::ScaledLogarithm;
use crate::law::slow::SlowErrors;
use crate::response::{ContactResponse, LawPoint, WithDerivatives};

/// The slope may be off by so many of the largest of these differences over h. 1.8 ε/h is 0.85 of it on average over five differences of
/// independent errors; what neighbours have in common does not show. Of two laws of one rubber, of accuracies 5e-2 and 1e-2, the slopes are
/// apart by 1.9 of it at 97 of 100 places, by 3.2 at the worst.
const SAFETY: f64 = 3.0;

/// How far scaled logarithms and their derivatives may be off.
pub(crate) type Doubt = PerQuantity<ScaledLogarithm>;

/// The knots of a law, with what is tabulated there.
pub(crate) struct Tabulated<'a> {
    /// Along the speed, ascending.
    pub(crate) speeds: &'a [f64],
    /// Along the depth, ascending; none of a law that does not depend on it.
    pub(crate) depths: &'a [f64],
    /// Speed fastest.
    pub(crate) values: &'a KnotValues,
    /// What is stated of the errors of the values.
    pub(crate) stated: PerQuantity<f64>,
    /// The slowest knots that theory gives.
    pub(crate) slow: &'a SlowErrors,
}

impl Tabulated<'_> {
    /// The doubt of every piece, by depth, then speed: below the first knot, between every two, above the last. `None` where an axis has too
    /// few knots to tell.
    pub(crate) fn doubts(&self) -> Option<Vec<Doubt>> {
        let Self { values, stated, slow, .. } = self;
        let force = self.of_quantity(&values.force, stated.force, &slow.force)?;
        let area = self.of_quantity(&values.area, stated.area, &slow.area)?;
        let friction = self.of_quantity(&values.friction, stated.friction, &slow.friction)?;
        let places = 0..force.len();
        Some(places.map(|k| Doubt { force: force[k], area: area[k], friction: friction[k] }).collect())
    }

    fn of_quantity(&self, values: &[f64], stated: f64, slow: &[Vec<f64>]) -> Option<Vec<ScaledLogarithm>> {
        let (columns, rows) = (self.speeds.len(), self.depths.len().max(1));
        let along_speed: Vec<Vec<f64>> =
            values.chunks(columns).map(|row| differences(self.speeds, row)).collect::<Option<_>>()?;
        let along_depth: Vec<Vec<f64>> = match self.depths {
            [] => vec![vec![0.0]; columns],
            depths => (0..columns)
                .map(|k| {
                    differences(depths, &values.iter().copied().skip(k).step_by(columns).collect::<Vec<_>>())
                })
                .collect::<Option<_>>()?,
        };
        let is_curve = self.depths.is_empty();
        let knot = |row: usize, column: usize| {
            let (by_speed, by_depth) = (along_speed[row][column], along_depth[column][row]);
            let of_depth = if is_curve { 0.0 } else { SAFETY * by_depth / spacing(self.depths, row) };
            // an error that falls as z² has twice its size as its slope
            let of_theory = slow.get(row).and_then(|row| row.get(column)).map(|error| (*error, 2.0 * error));
            let of_scatter = (stated + by_speed, SAFETY * by_speed / spacing(self.speeds, column));
            let (value, by_ln_speed) = of_theory.unwrap_or(of_scatter);
            ScaledLogarithm { value: value + by_depth, by_ln_speed, by_ln_indentation: of_depth }
        };
        let piece = |up: usize, along: usize| {
            let ends = |piece: usize, count: usize| [piece.saturating_sub(1), piece.min(count - 1)];
            let corners = ends(up, rows).map(|row| ends(along, columns).map(|column| knot(row, column)));
            corners.into_iter().flatten().fold(ScaledLogarithm::default(), larger)
        };
        let pieces = |count: usize| 0..=count;
        Some(
            pieces(if is_curve { 0 } else { rows })
                .flat_map(|up| pieces(columns).map(move |k| (up, k)))
                .map(|(up, k)| piece(up, k))
                .collect(),
        )
    }
}

fn larger(a: ScaledLogarithm, b: ScaledLogarithm) -> ScaledLogarithm {
    ScaledLogarithm {
        value: a.value.max(b.value),
        by_ln_speed: a.by_ln_speed.max(b.by_ln_speed),
        by_ln_indentation: a.by_ln_indentation.max(b.by_ln_indentation),
    }
}

/// The smaller distance of a knot from its neighbours.
fn spacing(places: &[f64], k: usize) -> f64 {
    let step = |k: usize| places.get(k + 1).map_or(f64::INFINITY, |next| next - places[k]);
    if k == 0 { step(0) } else { step(k).min(step(k - 1)) }
}

/// The doubt in a tail with this rate: that of the edge as the tail hands it on, and all of what is assumed of the tail's form, its two last
/// coefficients.
pub(crate) fn in_tail(edge: Doubt, place: &KnotPlace, rate: f64, assumed: PerQuantity<[f64; 2]>) -> Doubt {
    let [_, w, wt, _] = place.basis;
    let [_, w_slope, wt_slope, _] = place.slopes;
    let (rate, reach) = (rate.abs(), wt.abs());
    edge.zip(assumed).map(|(edge, [alpha, beta])| ScaledLogarithm {
        value: edge.value * (w + rate * reach) + edge.by_ln_speed * reach + (alpha * w + beta * wt).abs(),
        by_ln_speed: edge.by_ln_speed * (w + rate * reach)
            + edge.value * rate * rate * reach
            + (alpha * w_slope + beta * wt_slope).abs(),
        by_ln_indentation: edge.by_ln_indentation,
    })
}

/// The doubt of F̃, Ã, μ and their derivatives, absolute, where it is that of logarithms over ln z and ln ŷ.
pub(crate) fn of_logarithms(at: &LawPoint, here: &ContactResponse, doubt: Doubt) -> ContactResponse {
    let of = |q: WithDerivatives, doubt: ScaledLogarithm| {
        let size = q.value.abs();
        let (per_v, per_y) = (1.0 / at.velocity, 1.0 / at.indentation);
        // at constant v̂, ln z falls by half of what ln ŷ gains
        let along_depth = doubt.by_ln_indentation + 0.5 * doubt.by_ln_speed;
        WithDerivatives {
            value: size * doubt.value,
            by_velocity: q.by_velocity.abs() * doubt.value + size * doubt.by_ln_speed * per_v,
            by_indentation: q.by_indentation.abs() * doubt.value + size * along_depth * per_y,
        }
    };
    ContactResponse {
        force: of(here.force, doubt.force),
        area: of(here.area, doubt.area),
        friction: of(here.friction, doubt.friction),
    }
}
