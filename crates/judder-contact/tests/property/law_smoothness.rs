//! Computed laws: derivatives, continuity, limits, tails.

use crate::synthetic::{RATIO, collapsed, contact, tabulated};
use judder_contact::law::LawIndenter::{self, Paraboloid, Sphere};
use judder_contact::{ContactLaw, ContactResponse, HertzLaw, LawPoint, ValidityConcern, WithDerivatives};
use proptest::prelude::*;
use std::f64::consts::PI;

fn quantities(r: &ContactResponse) -> [WithDerivatives; 3] {
    [r.force, r.area, r.friction]
}

fn at(law: &dyn ContactLaw, v: f64, y: f64) -> [WithDerivatives; 3] {
    quantities(&law.evaluate(&LawPoint::new(v, y)))
}

/// The derivatives by ln v̂ and ln ŷ.
fn logarithmic(q: &WithDerivatives, v: f64, y: f64) -> [f64; 2] {
    [q.by_velocity * v / q.value, q.by_indentation * y / q.value]
}

fn laws() -> Vec<(&'static str, Box<dyn ContactLaw>)> {
    vec![
        ("collapsed", Box::new(collapsed(33))),
        ("paraboloid", Box::new(tabulated(Paraboloid, 33, 3))),
        ("sphere", Box::new(tabulated(Sphere, 33, 9))),
    ]
}

proptest! {
    #[test]
    fn derivatives_are_those_of_the_values(ln_z in -12.0..14.0_f64, ln_y in -14.0..0.5_f64) {
        // a fourth-order difference; its own error is h⁴ of a fifth derivative, plus rounding over h
        const STEP: f64 = 1e-3;
        let y = ln_y.exp();
        let v = ln_z.exp() * y.sqrt();
        for (name, law) in laws() {
            let logs = |dv: f64, dy: f64| at(&*law, v * (dv * STEP).exp(), y * (dy * STEP).exp()).map(|q| q.value.ln());
            for (k, q) in at(&*law, v, y).iter().enumerate() {
                let exact = logarithmic(q, v, y);
                for (axis, (dv, dy)) in [(1.0, 0.0), (0.0, 1.0)].into_iter().enumerate() {
                    let f = |n: f64| logs(n * dv, n * dy)[k];
                    let difference = (8.0 * (f(1.0) - f(-1.0)) - (f(2.0) - f(-2.0))) / (12.0 * STEP);
                    // across a knot the third derivative jumps: STEP² of it remains
                    prop_assert!((difference - exact[axis]).abs() < 2e-6, "{name} {k} {axis}: {difference} {exact:?}");
                }
            }
        }
    }

    #[test]
    fn finite_everywhere(lv in -300.0..300.0_f64, ly in -300.0..100.0_f64) {
        for (name, law) in laws() {
            for q in at(&*law, 10_f64.powf(lv), 10_f64.powf(ly)) {
                prop_assert!(q.value.is_finite() && q.by_velocity.is_finite() && q.by_indentation.is_finite(), "{name} {q:?}");
            }
        }
    }
}

/// Second derivatives by one-sided differences of the exact first ones, on both sides of a place.
fn curvatures(law: &dyn ContactLaw, z: f64, y: f64, along_depth: bool) -> [[f64; 2]; 3] {
    const STEP: f64 = 1e-5;
    let slopes = |n: f64| {
        let (ln_z, ln_y) =
            if along_depth { (z.ln(), y.ln() + n * STEP) } else { (z.ln() + n * STEP, y.ln()) };
        let y = ln_y.exp();
        let v = (ln_z + 0.5 * ln_y).exp();
        at(law, v, y).map(|q| {
            let [by_v, by_y] = logarithmic(&q, v, y);
            if along_depth { by_y + 0.5 * by_v } else { by_v }
        })
    };
    let (before, here, after) = (slopes(-1.0), slopes(0.0), slopes(1.0));
    [0, 1, 2].map(|k| [(here[k] - before[k]) / STEP, (after[k] - here[k]) / STEP])
}

#[test]
fn curvature_is_continuous_across_knots_and_edges() {
    let law = tabulated(Sphere, 33, 5);
    let (speeds, depths) = (*law.data().ln_speeds(), *law.ln_indentations());
    for (ln_z, ln_y) in speeds.iter().flat_map(|z| depths.iter().map(move |y| (z, y))) {
        for along_depth in [false, true] {
            // off the knots of the other axis, where nothing but this knot could jump
            let (z, y) =
                if along_depth { ((ln_z + 0.1).exp(), ln_y.exp()) } else { (ln_z.exp(), (ln_y + 0.1).exp()) };
            for [left, right] in curvatures(&law, z, y, along_depth) {
                assert!((left - right).abs() < 2e-4, "ln z {ln_z} ln y {ln_y} {along_depth}: {left} {right}");
            }
        }
    }
}

#[test]
fn at_rest_and_at_infinite_speed_it_is_hertz() {
    for (name, law) in laws() {
        for y in [1e-12, 1e-5] {
            let [force, area, friction] = at(&*law, 0.0, y);
            let [rubbery, ..] = at(&HertzLaw::default(), 0.0, y);
            // between the knots of ln ŷ the sphere's own limit is interpolated; here both are shallow
            assert!(
                (force.value / rubbery.value - 1.0).abs() < 2e-5,
                "{name} {}",
                force.value / rubbery.value
            );
            assert!((area.value / (PI * y) - 1.0).abs() < 1e-4, "{name}");
            assert!(friction.value < 1e-290 && (friction.by_velocity / 0.9 - 1.0).abs() < 1e-4, "{name}");
            assert_eq!(force.by_velocity, 0.0);
            let [force, area, friction] = at(&*law, 1e12, y);
            assert!((force.value / (RATIO * rubbery.value) - 1.0).abs() < 2e-5, "{name}");
            assert!((area.value / (PI * y) - 1.0).abs() < 1e-4, "{name}");
            // 0.8 (E∞/E0 − 1) δ/(v τ)
            assert!((friction.value / (7.2 * y / 1e12) - 1.0).abs() < 1e-4, "{name}");
        }
    }
}

#[test]
fn tails_are_monotone() {
    for (name, law) in laws() {
        for y in [1e-6_f64, 1e-2, 0.29] {
            let along = |range: (f64, f64)| -> Vec<[f64; 3]> {
                (0..200)
                    .map(|k| range.0 + (range.1 - range.0) * k as f64 / 199.0)
                    .map(|ln_z| at(&*law, ln_z.exp() * y.sqrt(), y).map(|q| q.value))
                    .collect()
            };
            for pair in along((-25.0, 0.01_f64.ln())).windows(2) {
                assert!(pair[1][0] >= pair[0][0] && pair[1][1] <= pair[0][1] * (1.0 + 1e-12), "{name} {y}");
                assert!(pair[1][2] > pair[0][2], "{name} {y}");
            }
            for pair in along((1000.0_f64.ln(), 25.0)).windows(2) {
                assert!(pair[1][0] >= pair[0][0] * (1.0 - 1e-12), "{name} {y}");
                assert!(pair[1][1] >= pair[0][1] * (1.0 - 1e-12) && pair[1][2] < pair[0][2], "{name} {y}");
            }
        }
    }
}

/// The largest relative deviation from the closed form, inside the table, in both tails, and below the shallowest knot.
fn deviation(law: &dyn ContactLaw, indenter: LawIndenter, ln_z: (f64, f64), ln_y: (f64, f64)) -> f64 {
    let mut worst = 0.0_f64;
    for k in 0..60 {
        for j in 0..20 {
            let y = (ln_y.0 + (ln_y.1 - ln_y.0) * (j as f64 + 0.3) / 20.0).exp();
            let v = (ln_z.0 + (ln_z.1 - ln_z.0) * (k as f64 + 0.3) / 60.0).exp() * y.sqrt();
            let exact = contact(indenter, v, y).into_array();
            for (q, exact) in at(law, v, y).iter().zip(exact) {
                worst = worst.max((q.value / exact - 1.0).abs());
            }
        }
    }
    worst
}

#[test]
fn the_closed_form_comes_back_within_the_stated_error_inside_and_outside() {
    let law = tabulated(Sphere, 65, 9);
    let stated = law.data().errors().interpolation.into_array().into_iter().fold(0.0, f64::max);
    let inside = deviation(&law, Sphere, (-4.6, 6.9), (-6.9, -1.21));
    assert!(inside < stated && stated < 0.02, "{inside} {stated}");
    let slow = deviation(&law, Sphere, (-14.0, -4.6), (-6.9, -1.21));
    let fast = deviation(&law, Sphere, (6.9, 16.0), (-6.9, -1.21));
    let shallow = deviation(&law, Sphere, (-4.6, 6.9), (-20.0, -6.9));
    assert!(slow.max(fast).max(shallow) < stated, "{slow} {fast} {shallow}");
}

#[test]
fn a_paraboloids_table_is_its_curve() {
    let (curve, table) = (collapsed(33), tabulated(Paraboloid, 33, 5));
    for (v, y) in [(1e-6, 1e-9), (1e-3, 1e-2), (0.3, 0.02), (1e4, 0.3), (1e-4, 10.0)] {
        for (a, b) in at(&curve, v, y).iter().zip(at(&table, v, y)) {
            assert!((a.value / b.value - 1.0).abs() < 1e-12, "{v} {y}");
            assert!((a.by_velocity - b.by_velocity).abs() * v <= 1e-11 * a.value);
            assert!((a.by_indentation - b.by_indentation).abs() * y <= 1e-11 * a.value);
        }
    }
}

#[test]
fn concerns_name_the_side_that_is_left() {
    let law = tabulated(Sphere, 65, 5);
    assert_eq!(law.concern(0.01, 0.01), None);
    assert!(matches!(law.concern(0.01, 0.31), Some(ValidityConcern::TooDeep { .. })));
    // shallow: the collapse; very slow and very fast: the limits themselves
    assert_eq!(law.concern(1e-4, 1e-6), None);
    assert_eq!(law.concern(1e-12, 0.01), None);
    assert_eq!(law.concern(1e9, 0.01), None);
    // a table that ends where friction is far from its limit
    let short = collapsed(65);
    assert_eq!(short.concern(1e-9, 0.01), None);
    let z = 1001.0 * 0.1;
    let concern = short.concern(z, 0.01);
    let away = short.data().errors().total().friction;
    assert_eq!(concern.is_some(), away < 5e-4, "{concern:?} {away}");
}
