//! Laws of different accuracies are the same law, in value and in slope.

use judder_contact::law::boundary_elements::{sample, sweep_accuracy};
use judder_contact::law::sweep::{CollapseRequest, SweepRange, collapse_sweep};
use judder_contact::law::{LawIndenter, LawMaterial};
use judder_contact::steady::MEMORY;
use judder_contact::{CollapsedLaw, ContactLaw, ContactResponse, LawPoint};

const DEPTH: f64 = 1e-2;

fn law(material: &LawMaterial, accuracy: f64) -> CollapsedLaw {
    let shares = sweep_accuracy(accuracy);
    let solver = |v: f64, y: f64| sample(material, LawIndenter::Paraboloid, v, y, shares.contacts, MEMORY);
    let request = CollapseRequest {
        material: material.clone(),
        source: "test".to_owned(),
        ln_speeds: SweepRange::all_speeds(material),
        indentation: DEPTH,
        accuracy: shares.interpolation,
        most_points: 400,
    };
    collapse_sweep(&request, &[], &solver, &()).unwrap().law
}

fn at(law: &CollapsedLaw, z: f64) -> ContactResponse {
    law.evaluate(&LawPoint::new(z * DEPTH.sqrt(), DEPTH))
}

/// d ln A/d ln v.
fn area_slope(law: &CollapsedLaw, z: f64) -> f64 {
    let area = at(law, z).area;
    area.by_velocity * z * DEPTH.sqrt() / area.value
}

#[test]
#[ignore = "expensive: run by make validate"]
fn laws_of_three_accuracies_agree_in_slope_at_low_speed() {
    let material = LawMaterial::one_time(10.0).unwrap();
    let laws = [1e-2, 5e-3, 3e-3].map(|accuracy| law(&material, accuracy));
    for z in [1e-5, 1e-4, 1e-3, 3e-3] {
        for law in &laws {
            let ratio = area_slope(law, z) / (material.slow_area_slope() * z);
            assert!((ratio - 1.0).abs() < 0.05, "z {z}: {ratio}");
        }
    }
    // from there to the dip the area falls ever faster, without a ripple
    for law in &laws {
        let slopes: Vec<f64> =
            (0..40).map(|k| area_slope(law, 1e-4 * 10_f64.powf(0.09 * f64::from(k)))).collect();
        for pair in slopes.windows(2) {
            assert!(pair[1] < pair[0] && pair[1] > 1.6 * pair[0], "{slopes:?}");
        }
    }
}

#[test]
fn contacts_between_the_knots_are_within_the_error_that_a_law_shows() {
    let material = LawMaterial::one_time(10.0).unwrap();
    let law = law(&material, 1e-2);
    let shown = law.data().errors().total();
    for z in [0.023, 0.071, 0.31, 2.7, 33.0] {
        let exact =
            sample(&material, LawIndenter::Paraboloid, z * DEPTH.sqrt(), DEPTH, 5e-4, MEMORY).unwrap();
        let found = at(&law, z);
        for (name, found, exact, shown) in [
            ("force", found.force.value, exact.force, shown.force),
            ("area", found.area.value, exact.area, shown.area),
            ("friction", found.friction.value, exact.friction, shown.friction),
        ] {
            assert!((found / exact - 1.0).abs() < shown, "{name} at z {z}: {found} {exact} {shown}");
        }
    }
}
