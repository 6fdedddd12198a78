//! The curve that bounds a stability map, by continuation.
//!
//! The equilibrium has one solution at every point of the plane, so it is eliminated, and the boundary is the zero set of
//! one function of two positions: the third Hurwitz determinant (a Hopf boundary, since p0 = det K > 0), or for the
//! conservative system the discriminant of (24), (25). The curve is followed in steps of arclength. Starting points are
//! the sign changes of the stability margin on a coarse grid, so that closed loops and several branches are found.

mod continuation;
mod field;

use crate::Contact;
use crate::characteristic::Characteristic;
use crate::critical::ParameterRange;
use crate::groups::Coefficients;
use crate::linear_system::ReducedSystem;
use continuation::{BoundaryMargin, FollowedCurve, follow};
use field::{BoundaryField, grid_position, pairs_that_differ};
use judder_numerics::root::bracketed_root;

/// Which system's boundary is followed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Condition {
    /// The full, damped system: the third Hurwitz determinant vanishes.
    Full,
    /// The system without damping: its two modes merge, (26).
    Conservative,
}

/// One point of a boundary.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BoundaryPoint {
    /// Value of the first swept quantity.
    pub x: f64,
    /// Value of the second swept quantity.
    pub y: f64,
    /// ŷ_e there.
    pub indentation: f64,
    /// The frequency of the oscillation that is born there, in units of ω_nx: √(p1/p3) on a Hopf boundary, that of the
    /// merged modes √((k11 + k22)/2) on a conservative one.
    pub frequency: f64,
}

/// Where a boundary turns back.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BoundaryFold {
    /// In the first swept quantity.
    InX,
    /// In the second swept quantity.
    InY,
}

/// Why a curve has an end.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BoundaryEnd {
    /// It closed on itself.
    Closed,
    /// Both ends left the plane.
    LeftPlane,
    /// The step fell below its limit, or there was no equilibrium: the curve is incomplete.
    Stalled,
}

/// One connected piece of a boundary.
#[derive(Debug, Clone, PartialEq)]
pub struct Boundary {
    /// The points in order; a closed curve repeats its first point at the end.
    pub points: Vec<BoundaryPoint>,
    /// Indices of the points at which the curve turns back, and in which quantity.
    pub folds: Vec<(usize, BoundaryFold)>,
    /// How it ends.
    pub end: BoundaryEnd,
}

/// Grid intervals along each side among which sign changes are looked for.
const SEED_INTERVALS: usize = 160;

/// All pieces of the boundary in the rectangle `x` × `y`; `coefficients` gives the oscillator at its points.
///
/// A closed loop that fits between the lines of a 160 × 160 grid is not found; of two pieces closer than a quarter of such
/// a cell one may be taken for the other.
#[must_use]
pub fn boundaries(
    contact: &Contact,
    condition: Condition,
    x: &ParameterRange,
    y: &ParameterRange,
    coefficients: &(dyn Fn(f64, f64) -> Coefficients + Sync),
) -> Vec<Boundary> {
    let field = BoundaryField { contact, condition, x, y, coefficients };
    let curves = follow_all(&|position| field.margin(position), field.sign_changes(SEED_INTERVALS));
    curves.iter().map(|curve| field.boundary(curve)).collect()
}

/// All pieces of the stability boundary of any system with two swept quantities; `system` gives it, with unit mass matrix, at
/// their values. The indentation of the points is NaN. What can be missed is as for [`boundaries`].
#[must_use]
pub fn boundaries_of_system(
    x: &ParameterRange,
    y: &ParameterRange,
    system: &dyn Fn(f64, f64) -> Option<ReducedSystem>,
) -> Vec<Boundary> {
    let at = |position: [f64; 2]| system(x.value(position[0]), y.value(position[1]));
    let margin = |position: [f64; 2]| {
        let clamped = position.map(|s| s.clamp(0.0, 1.0));
        at(position).or_else(|| at(clamped)).map_or(f64::NAN, |system| Characteristic::new(&system).margin())
    };
    let side = SEED_INTERVALS + 1;
    let along = |k: usize| grid_position(k, SEED_INTERVALS);
    let margins: Vec<f64> =
        (0..side * side).map(|index| margin([along(index % side), along(index / side)])).collect();
    let curves = follow_all(&margin, pairs_that_differ(&margins, SEED_INTERVALS));
    let point = |position: &[f64; 2]| BoundaryPoint {
        x: x.value(position[0]),
        y: y.value(position[1]),
        indentation: f64::NAN,
        frequency: at(*position).map_or(f64::NAN, |system| Characteristic::new(&system).hopf_frequency()),
    };
    curves
        .into_iter()
        .map(|curve| Boundary {
            points: curve.positions.iter().map(point).collect(),
            folds: curve.folds,
            end: curve.end,
        })
        .collect()
}

/// The curves through all seeds, each curve once.
fn follow_all(margin: &BoundaryMargin<'_>, seeds: Vec<[[f64; 2]; 2]>) -> Vec<FollowedCurve> {
    let reach = 0.25 / SEED_INTERVALS as f64;
    let mut curves: Vec<FollowedCurve> = Vec::new();
    for [a, b] in seeds {
        let between = |share: f64| [a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])];
        let Ok(share) = bracketed_root(|share| margin(between(share)), 0.0, 1.0, 1e-12) else { continue };
        let start = between(share);
        if !curves.iter().any(|curve| passes(&curve.positions, start, reach)) {
            curves.push(follow(margin, start));
        }
    }
    curves
}

/// Whether a polyline comes within `reach` of a point.
fn passes(curve: &[[f64; 2]], point: [f64; 2], reach: f64) -> bool {
    curve.windows(2).any(|segment| {
        let along = [segment[1][0] - segment[0][0], segment[1][1] - segment[0][1]];
        let to = [point[0] - segment[0][0], point[1] - segment[0][1]];
        let length = along[0] * along[0] + along[1] * along[1];
        let share =
            if length > 0.0 { ((to[0] * along[0] + to[1] * along[1]) / length).clamp(0.0, 1.0) } else { 0.0 };
        libm::hypot(to[0] - share * along[0], to[1] - share * along[1]) < reach
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::critical::{RangeScale, thresholds};
    use crate::{FrictionLoad, Groups};
    use judder_contact::{FittedLaw, Law};

    fn paper(friction_load: FrictionLoad) -> Contact {
        Contact { law: Law::Fitted(FittedLaw::oscillator_paper()), friction_load }
    }

    fn logarithmic(from: f64, to: f64) -> ParameterRange {
        ParameterRange { from, to, scale: RangeScale::Logarithmic }
    }

    #[test]
    fn the_boundary_of_a_general_system_is_the_closed_form() {
        // K = [[2, 1 − 4μ/3], [1, 2]], C = c I: the modes merge and lose stability at μ_H = 3/4 (1 + 2 c²) for equal damping
        let linear = |from: f64, to: f64| ParameterRange { from, to, scale: RangeScale::Linear };
        let system = |friction: f64, damping: f64| {
            Some(ReducedSystem {
                damping: [[damping, 0.0], [0.0, damping]],
                stiffness: [[2.0, 1.0 - 4.0 / 3.0 * friction], [1.0, 2.0]],
            })
        };
        let curves = boundaries_of_system(&linear(0.0, 1.5), &linear(0.01, 0.3), &system);
        assert_eq!(curves.len(), 1);
        assert_eq!(curves[0].end, BoundaryEnd::LeftPlane);
        for p in &curves[0].points {
            // (c1 = c2 = c, D = 0): μ_H = (k12 + 2 c²)/k3 with r = (c1 k22 + c2 k11)/(c1 + c2) = 2
            assert!((p.x - 0.75 * (1.0 + 2.0 * p.y * p.y)).abs() < 1e-10, "{p:?}");
        }
    }

    #[test]
    fn a_straight_boundary_along_a_grid_line_is_one_curve_without_folds() {
        let linear = |from: f64, to: f64| ParameterRange { from, to, scale: RangeScale::Linear };
        let undamped = |friction: f64, _: f64| {
            let stiffness = [[2.0, 1.0 - 4.0 / 3.0 * friction], [1.0, 2.0]];
            Some(ReducedSystem { damping: [[0.0; 2]; 2], stiffness })
        };
        for to in [1.5, 1.4] {
            let curves = boundaries_of_system(&linear(0.0, to), &linear(0.0, 1.0), &undamped);
            assert_eq!(curves.len(), 1, "to {to}");
            assert_eq!((curves[0].end, curves[0].folds.len()), (BoundaryEnd::LeftPlane, 0));
            for p in &curves[0].points {
                assert!((p.x - 0.75).abs() < 1e-12 && (p.frequency - 2_f64.sqrt()).abs() < 1e-6, "{p:?}");
            }
        }
    }

    #[test]
    fn curves_that_begin_on_the_border_are_whole() {
        let (x, y) = (logarithmic(1e-8, 1e2), logarithmic(1e-9, 1e-1));
        for load in [FrictionLoad::NormalLoad, FrictionLoad::ContactForce] {
            for (coupling, shear_strength) in [(1.0, 0.01), (0.0, 0.01), (1.0, 0.1), (0.0, 0.1)] {
                let at = move |velocity, normal_load| {
                    Groups { velocity, normal_load, shear_strength, coupling, ..Groups::default() }.resolve()
                };
                let curves = boundaries(&paper(load), Condition::Full, &x, &y, &at);
                assert!(
                    curves.iter().all(|c| c.end != BoundaryEnd::Stalled && c.points.len() > 10),
                    "{load:?} {coupling}"
                );
            }
        }
    }

    fn of_fig_9(normal_load: f64) -> impl Fn(f64, f64) -> Coefficients + Sync {
        move |velocity, shear_strength| {
            Groups { velocity, shear_strength, normal_load, ..Groups::default() }.resolve()
        }
    }

    #[test]
    fn the_conservative_boundary_of_fig_9a_passes_through_the_thresholds_of_fig_7() {
        let contact = paper(FrictionLoad::NormalLoad);
        let (x, y) = (logarithmic(1e-8, 1e2), logarithmic(1e-4, 1.0));
        let at = of_fig_9(1e-6);
        let curves = boundaries(&contact, Condition::Conservative, &x, &y, &at);
        assert!(curves.iter().all(|c| c.end != BoundaryEnd::Stalled));
        for p in curves.iter().flat_map(|c| &c.points).step_by(37) {
            let found = thresholds(&contact, &logarithmic(1e-5, 10.0), 300, |s| at(p.x, s)).conservative;
            let nearest = found.iter().map(|t| (t / p.y - 1.0).abs()).fold(f64::INFINITY, f64::min);
            assert!(nearest < 1e-6, "at v̂ = {:e}: {nearest:e}", p.x);
        }
    }

    #[test]
    fn every_threshold_of_the_full_system_lies_on_a_boundary() {
        for load in [FrictionLoad::NormalLoad, FrictionLoad::ContactForce] {
            let contact = paper(load);
            let (x, y) = (logarithmic(1e-8, 1e2), logarithmic(1e-4, 1.0));
            for normal_load in [1e-6, 1e-3] {
                let at = of_fig_9(normal_load);
                let curves = boundaries(&contact, Condition::Full, &x, &y, &at);
                assert!(curves.iter().all(|c| c.end != BoundaryEnd::Stalled), "{load:?} {normal_load}");
                let positions: Vec<Vec<[f64; 2]>> = curves
                    .iter()
                    .map(|c| {
                        c.points
                            .iter()
                            .map(|p| [(p.x.log10() + 8.0) / 10.0, (p.y.log10() + 4.0) / 4.0])
                            .collect()
                    })
                    .collect();
                for k in 1..40 {
                    let position = f64::from(k) / 40.0;
                    let found =
                        thresholds(&contact, &logarithmic(1e-4, 1.0), 400, |s| at(x.value(position), s));
                    for threshold in found.full {
                        let point = [position, (threshold.log10() + 4.0) / 4.0];
                        assert!(
                            positions.iter().any(|c| passes(c, point, 1e-3)),
                            "{load:?} {normal_load} {point:?}"
                        );
                    }
                }
            }
        }
    }
}
