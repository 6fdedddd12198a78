//! A law through values that somebody gives: a measured table, another program's, a function of one's own.

mod adaptive;
mod axis;
pub mod file;

pub use adaptive::{SampleRequest, SampledAdaptively, sampled};

use crate::contact_law::{ContactLaw, ValidityConcern};
use crate::law::error::LawError;
use crate::law::quantities::{KnotValues, NAMES, PerQuantity};
use crate::law::scaled::ScaledLogarithm;
use crate::law::scatter::{Doubt, Tabulated};
use crate::law::slow::SlowErrors;
use crate::law::table::{along_speed, combined};
use crate::response::{ContactResponse, LawPoint, WithDerivatives};
use axis::KnotAxis;

/// The names of the axes in errors.
pub(crate) const AXES: [&str; 2] = ["speed v τ/R", "indentation y/R"];

/// One bicubic piece, `[a][b][quantity]`: sums over the functions of ln v̂ (a) and of ln ŷ (b); a zero stands beside the quantities.
type SampledPatch = [[[f64; 4]; 4]; 4];

/// What a sampled law is made of.
#[derive(Debug, Clone, PartialEq)]
pub struct LawSamples {
    /// Where the values come from, in words.
    pub source: String,
    /// v̂ of the knots, ascending, at least two.
    pub velocities: Vec<f64>,
    /// ŷ of the knots, ascending, at least two.
    pub indentations: Vec<f64>,
    /// F̃_k = F_k/(E0* R²), Ã = A/R², μ_visc at the knots, speed fastest.
    pub values: KnotValues,
}

/// A law over speed and depth through given values, C² in ln v̂ and ln ŷ: bicubic splines of ln(F̃_k/ŷ^{3/2}), ln(Ã/ŷ) and μ_visc.
///
/// Knots need not be even. At the ends of an axis the outer two intervals are one cubic ("not a knot"), and beyond it the law goes to
/// a limit as the distance in ln v̂ or ln ŷ grows, with value, slope and curvature of its edge: force and area go on as those of Hertz
/// (ŷ^{3/2} and ŷ), friction that grows as v̂ goes on to zero, within the error of the spline at its edge. [`concern`](ContactLaw::concern) names a point beyond.
#[derive(Debug, Clone, PartialEq)]
pub struct SampledLaw {
    samples: LawSamples,
    errors: [PerQuantity<f64>; 2],
    speeds: KnotAxis,
    depths: KnotAxis,
    patches: Vec<SampledPatch>,
    /// A patch each.
    doubts: Option<Vec<Doubt>>,
}

impl SampledLaw {
    /// The law through these values.
    ///
    /// # Errors
    /// Fewer than two knots, knots that are not positive, finite and ascending, a wrong number of values, force or area that is not
    /// positive and finite, friction that is not finite.
    pub fn new(samples: LawSamples) -> Result<Self, LawError> {
        let [speeds, depths] = [(&samples.velocities, AXES[0]), (&samples.indentations, AXES[1])];
        let (speeds, depths) = (KnotAxis::new(speeds.0, speeds.1)?, KnotAxis::new(depths.0, depths.1)?);
        check(&samples)?;
        let scaled = scaled(&samples);
        let patches = patches(&speeds, &depths, &scaled);
        let errors = left_out(&speeds, &depths, &scaled);
        // whoever gave the values states no errors: what their scatter shows is all that is known
        let (stated, slow) = (PerQuantity::uniform(0.0), SlowErrors::default());
        let (along, up) = (speeds.logarithms(), depths.logarithms());
        let doubts = Tabulated { speeds: along, depths: up, values: &scaled, stated, slow: &slow }.doubts();
        Ok(Self { samples, errors, speeds, depths, patches, doubts })
    }

    /// Whether there are knots enough to tell its errors.
    pub(super) fn knows_its_errors(&self) -> bool {
        self.doubts.is_some()
    }

    /// What it is made of.
    #[must_use]
    pub fn samples(&self) -> &LawSamples {
        &self.samples
    }

    /// The largest deviation, at knots that were left out, of the law made from the others, relative (of the friction: to its largest
    /// value): an upper estimate of its interpolation error, zero where too few knots remain.
    #[must_use]
    pub fn errors(&self) -> PerQuantity<f64> {
        let [by_speed, by_depth] = self.errors;
        by_speed.zip(by_depth).map(|(a, b)| a.max(b))
    }

    /// The same along the speed and along the depth.
    #[must_use]
    pub fn errors_by_axis(&self) -> [PerQuantity<f64>; 2] {
        self.errors
    }
}

impl ContactLaw for SampledLaw {
    #[inline]
    fn evaluate(&self, at: &LawPoint) -> ContactResponse {
        use judder_numerics::elementary::exp;
        let speed = self.speeds.place(at.ln_velocity);
        let depth = self.depths.place(at.ln_indentation);
        let patch = &self.patches[depth.piece * self.speeds.pieces() + speed.piece];
        let here = along_speed(patch, &speed.basis);
        let value = combined(&here, &depth.basis);
        let by_speed = combined(&along_speed(patch, &speed.slopes), &depth.basis);
        let by_depth = combined(&here, &depth.slopes);
        let (y, per_v, per_y) = (at.indentation, 1.0 / at.velocity, 1.0 / at.indentation);
        let power = |k: usize, scale: f64, exponent: f64| {
            let value = scale * exp(value[k]);
            WithDerivatives {
                value,
                by_velocity: value * by_speed[k] * per_v,
                by_indentation: value * (exponent + by_depth[k]) * per_y,
            }
        };
        ContactResponse {
            force: power(0, y * y.sqrt(), 1.5),
            area: power(1, y, 1.0),
            friction: WithDerivatives {
                value: value[2],
                by_velocity: by_speed[2] * per_v,
                by_indentation: by_depth[2] * per_y,
            },
        }
    }

    /// Unknown beyond the values that the law was given.
    fn doubt(&self, at: &LawPoint) -> Option<ContactResponse> {
        if self.concern(at.velocity, at.indentation).is_some() {
            return None;
        }
        let (speed, depth) = (self.speeds.place(at.ln_velocity), self.depths.place(at.ln_indentation));
        let doubt = self.doubts.as_ref()?[depth.piece * self.speeds.pieces() + speed.piece];
        let here = self.evaluate(at);
        let absolute = |doubt: ScaledLogarithm, size: f64| WithDerivatives {
            value: size * doubt.value,
            by_velocity: size * doubt.by_ln_speed / at.velocity,
            by_indentation: size * doubt.by_ln_indentation / at.indentation,
        };
        let of_logarithm = |q: WithDerivatives, doubt: ScaledLogarithm| {
            let own = absolute(doubt, q.value);
            WithDerivatives {
                by_velocity: own.by_velocity + q.by_velocity.abs() * doubt.value,
                by_indentation: own.by_indentation + q.by_indentation.abs() * doubt.value,
                ..own
            }
        };
        Some(ContactResponse {
            force: of_logarithm(here.force, doubt.force),
            area: of_logarithm(here.area, doubt.area),
            friction: absolute(doubt.friction, 1.0),
        })
    }

    fn concern(&self, velocity: f64, indentation: f64) -> Option<ValidityConcern> {
        let sides = [
            ("speed v τ/R", velocity, &self.samples.velocities),
            ("indentation y/R", indentation, &self.samples.indentations),
        ];
        sides.into_iter().find_map(|(name, value, knots)| {
            let (from, to) = (*knots.first()?, *knots.last()?);
            let is_inside = value >= from && value <= to;
            (!is_inside).then_some(ValidityConcern::BeyondSamples { name, value, from, to })
        })
    }
}

/// Refuses values that are too few or too many or make no law.
fn check(samples: &LawSamples) -> Result<(), LawError> {
    let (columns, rows) = (samples.velocities.len(), samples.indentations.len());
    let lists = samples.values.as_ref().zip(NAMES).into_array();
    for (place, (list, quantity)) in lists.into_iter().enumerate() {
        if list.len() != rows * columns {
            return Err(LawError::WrongCount { quantity, found: list.len(), expected: rows * columns });
        }
        let is_friction = place == 2;
        let holds = |value: &f64| value.is_finite() && (is_friction || *value > 0.0);
        if let Some(index) = list.iter().position(|value| !holds(value)) {
            let (row, column, value) = (index / columns, index % columns, list[index]);
            return Err(if is_friction {
                LawError::InvalidFriction { column, row, value }
            } else {
                LawError::InvalidValue { quantity, column, row, value }
            });
        }
    }
    Ok(())
}

/// ln(F̃/ŷ^{3/2}), ln(Ã/ŷ), μ.
fn scaled(samples: &LawSamples) -> KnotValues {
    let columns = samples.velocities.len();
    let depth = |index: usize| samples.indentations[index / columns];
    let over = |list: &[f64], exponent: f64| -> Vec<f64> {
        list.iter().enumerate().map(|(k, value)| libm::log(*value) - exponent * libm::log(depth(k))).collect()
    };
    PerQuantity {
        force: over(&samples.values.force, 1.5),
        area: over(&samples.values.area, 1.0),
        friction: samples.values.friction.clone(),
    }
}

/// The bicubic pieces: splines along ln v̂ in every row, then splines along ln ŷ through each of their coefficients.
fn patches(speeds: &KnotAxis, depths: &KnotAxis, scaled: &KnotValues) -> Vec<SampledPatch> {
    let (columns, mut patches) =
        (speeds.count(), vec![[[[0.0; 4]; 4]; 4]; speeds.pieces() * depths.pieces()]);
    for (quantity, list) in scaled.as_ref().into_array().into_iter().enumerate() {
        let rows: Vec<Vec<[f64; 4]>> = list.chunks(columns).map(|row| speeds.spline(row)).collect();
        for piece in 0..speeds.pieces() {
            for a in 0..4 {
                let column: Vec<f64> = rows.iter().map(|row| row[piece][a]).collect();
                for (depth, coefficients) in depths.spline(&column).into_iter().enumerate() {
                    for (b, coefficient) in coefficients.into_iter().enumerate() {
                        patches[depth * speeds.pieces() + piece][a][b][quantity] = coefficient;
                    }
                }
            }
        }
    }
    patches
}

/// The largest deviations at left-out knots, along the speed and along the depth.
fn left_out(speeds: &KnotAxis, depths: &KnotAxis, scaled: &KnotValues) -> [PerQuantity<f64>; 2] {
    let columns = speeds.count();
    let along_speed =
        scaled.as_ref().map(|list| list.chunks(columns).map(|row| speeds.left_out(row)).fold(0.0, f64::max));
    let along_depth = scaled.as_ref().map(|list| {
        let column = |k: usize| list.iter().copied().skip(k).step_by(columns).collect::<Vec<_>>();
        (0..columns).map(|k| depths.left_out(&column(k))).fold(0.0, f64::max)
    });
    let largest = scaled.friction.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
    let scale = if largest > 0.0 { 1.0 / largest } else { 0.0 };
    [along_speed, along_depth].map(|errors| PerQuantity { friction: scale * errors.friction, ..errors })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::FittedLaw;

    fn logarithmic(from: f64, to: f64, count: usize) -> Vec<f64> {
        (0..count).map(|k| from * (to / from).powf(k as f64 / (count - 1) as f64)).collect()
    }

    fn of(law: &impl ContactLaw, velocities: Vec<f64>, indentations: Vec<f64>) -> SampledLaw {
        let at = |value: fn(&ContactResponse) -> f64| {
            let depths = indentations.iter();
            depths
                .flat_map(|y| velocities.iter().map(move |v| LawPoint::new(*v, *y)))
                .map(|at| value(&law.evaluate(&at)))
                .collect()
        };
        let values = PerQuantity {
            force: at(|response| response.force.value),
            area: at(|response| response.area.value),
            friction: at(|response| response.friction.value),
        };
        SampledLaw::new(LawSamples { source: "a test".to_owned(), velocities, indentations, values }).unwrap()
    }

    #[test]
    fn it_is_the_law_it_was_sampled_from_with_its_derivatives() {
        let exact = FittedLaw::oscillator_paper();
        let law = of(&exact, logarithmic(1e-7, 1e2, 91), logarithmic(1e-6, 1e-1, 41));
        assert!(law.errors().into_array().into_iter().all(|error| error < 2e-3), "{:?}", law.errors());
        for (velocity, indentation) in [(3.3e-5, 2e-4), (0.7, 3e-2), (1.1e-3, 5.5e-6)] {
            let at = LawPoint::new(velocity, indentation);
            let (a, b) = (law.evaluate(&at), exact.evaluate(&at));
            for (a, b) in [(a.force, b.force), (a.area, b.area)] {
                assert!((a.value / b.value - 1.0).abs() < 1e-3, "{a:?} {b:?}");
                assert!((a.by_velocity - b.by_velocity).abs() * velocity < 5e-3 * b.value, "{a:?} {b:?}");
                assert!((a.by_indentation / b.by_indentation - 1.0).abs() < 5e-3, "{a:?} {b:?}");
            }
            assert!((a.friction.value - b.friction.value).abs() < 1e-3, "{:?} {:?}", a.friction, b.friction);
        }
    }

    #[test]
    fn derivatives_are_those_of_the_values_inside_and_beyond() {
        let law = of(&FittedLaw::oscillator_paper(), logarithmic(1e-5, 1.0, 7), logarithmic(1e-4, 1e-2, 4));
        for velocity in [1e-7, 1.3e-5, 2e-2, 30.0] {
            for indentation in [1e-6, 3e-4, 0.2] {
                let e = 1e-6;
                let value = |v: f64, y: f64| law.evaluate(&LawPoint::new(v, y));
                let here = value(velocity, indentation);
                let (up, down) =
                    (value(velocity * (1.0 + e), indentation), value(velocity * (1.0 - e), indentation));
                let (in_, out) =
                    (value(velocity, indentation * (1.0 + e)), value(velocity, indentation * (1.0 - e)));
                for take in [
                    |r: &ContactResponse| r.force,
                    |r: &ContactResponse| r.area,
                    |r: &ContactResponse| r.friction,
                ] {
                    let by_v = (take(&up).value - take(&down).value) / (2.0 * e * velocity);
                    let by_y = (take(&in_).value - take(&out).value) / (2.0 * e * indentation);
                    let scale = take(&here).value.abs() + 1e-9;
                    assert!((by_v - take(&here).by_velocity).abs() * velocity < 1e-6 * scale);
                    assert!((by_y - take(&here).by_indentation).abs() * indentation < 1e-6 * scale);
                }
            }
        }
    }

    #[test]
    fn friction_that_grows_with_the_speed_goes_on_to_zero_and_force_as_hertz() {
        let (velocities, indentations) = (logarithmic(1e-3, 1e-1, 9), logarithmic(1e-3, 1e-1, 5));
        let grid = || indentations.iter().flat_map(|y| velocities.iter().map(move |v| (*v, *y)));
        let values = PerQuantity {
            force: grid().map(|(_, y)| 4.0 / 3.0 * y.powf(1.5)).collect(),
            area: grid().map(|(_, y)| std::f64::consts::PI * y).collect(),
            friction: grid().map(|(v, _)| 0.9 * v).collect(),
        };
        let law = SampledLaw::new(LawSamples {
            source: String::new(),
            velocities: velocities.clone(),
            indentations: indentations.clone(),
            values,
        })
        .unwrap();
        let far = law.evaluate(&LawPoint::new(1e-7, 1e-7));
        assert!((far.force.value / (4.0 / 3.0 * 1e-7_f64.powf(1.5)) - 1.0).abs() < 1e-9);
        // to zero as far as the spline knows slope and curvature at its edge
        assert!(far.friction.value.abs() < 1e-2 * 0.09, "{:?}", far.friction);
        assert!(law.concern(1e-7, 1e-2).is_some() && law.concern(1e-2, 1e-2).is_none());
        let limit = law.evaluate(&LawPoint::new(0.0, 0.0));
        assert!(
            limit.force.value == 0.0
                && limit.friction.by_velocity.is_finite()
                && limit.area.by_indentation.is_finite()
        );
    }

    #[test]
    fn what_is_no_table_is_refused() {
        let make = |velocities: Vec<f64>, force: Vec<f64>, friction: Vec<f64>| {
            let area = vec![1.0; force.len()];
            let values = PerQuantity { force, area, friction };
            SampledLaw::new(LawSamples {
                source: String::new(),
                velocities,
                indentations: vec![1e-3, 1e-2],
                values,
            })
        };
        let four = vec![1.0; 4];
        assert!(make(vec![1e-3, 1e-2], four.clone(), four.clone()).is_ok());
        assert!(matches!(
            make(vec![1e-2, 1e-3], four.clone(), four.clone()),
            Err(LawError::KnotOrder { .. })
        ));
        assert!(matches!(make(vec![0.0, 1e-3], four.clone(), four.clone()), Err(LawError::KnotOrder { .. })));
        assert!(matches!(make(vec![1e-3], four.clone(), four.clone()), Err(LawError::TooFewKnots { .. })));
        assert!(matches!(
            make(vec![1e-3, 1e-2], vec![1.0; 3], four.clone()),
            Err(LawError::WrongCount { .. })
        ));
        assert!(matches!(
            make(vec![1e-3, 1e-2], vec![1.0, -1.0, 1.0, 1.0], four.clone()),
            Err(LawError::InvalidValue { .. })
        ));
        assert!(matches!(
            make(vec![1e-3, 1e-2], four, vec![0.0, 0.0, f64::NAN, 0.0]),
            Err(LawError::InvalidFriction { .. })
        ));
    }
}
