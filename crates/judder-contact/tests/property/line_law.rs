//! The computed law of a cylinder on a layer: the sweep, its file, its derivatives, its length.

use judder_contact::law::boundary_elements::{sample, sweep_accuracy};
use judder_contact::law::file::{from_json, to_json};
use judder_contact::law::sweep::{LawSweep, SweepRange, SweepRequest, sweep};
use judder_contact::law::{LawError, LawIndenter, LawLayer, LawMaterial, LawOrigin, TabulatedLaw};
use judder_contact::steady::MEMORY;
use judder_contact::{ContactLaw, ContactResponse, Law, LawPoint, ValidityConcern};
use std::sync::{Arc, LazyLock};

const LAYER: LawLayer = LawLayer { thickness: 0.2, poisson_ratio: 0.5 };
const DEPTHS: (f64, f64) = (1e-4, 2e-2);
const ACCURACY: f64 = 3e-2;

fn material() -> LawMaterial {
    LawMaterial::one_time(10.0).unwrap()
}

/// One law for all tests.
static COMPUTED: LazyLock<LawSweep<TabulatedLaw>> = LazyLock::new(|| {
    let (material, indenter) = (material(), LawIndenter::Cylinder(LAYER));
    let shares = sweep_accuracy(ACCURACY);
    let request = SweepRequest {
        range: SweepRange::covering_line((1e-6, 1e4), DEPTHS, &material, LAYER).unwrap(),
        origin: LawOrigin { material: material.clone(), indenter, source: "boundary elements".to_owned() },
        accuracy: shares.interpolation,
        most_points: 2000,
    };
    let solve = |v: f64, y: f64| sample(&material, indenter, v, y, shares.contacts, MEMORY);
    sweep(&request, &[], &solve, &()).unwrap()
});

fn law() -> &'static TabulatedLaw {
    &COMPUTED.law
}

/// Contacts that the law was not made from lie within its accuracy.
#[test]
fn the_law_gives_contacts_that_it_was_not_made_from() {
    println!("{} contacts, {:?}, {:?}", COMPUTED.points.len(), COMPUTED.end, law().data().errors());
    for (velocity, depth) in [(3e-3, 3e-4), (0.07, 5e-3), (0.9, 1.3e-2), (30.0, 2e-3)] {
        let exact = sample(&material(), LawIndenter::Cylinder(LAYER), velocity, depth, 1e-3, MEMORY).unwrap();
        let found = law().evaluate(&LawPoint::new(velocity, depth));
        for (found, exact, times) in [
            (found.force.value, exact.force, 1.0),
            (found.area.value, exact.area, 5.0),
            (found.friction.value, exact.friction, 5.0),
        ] {
            let error = (found / exact - 1.0).abs();
            assert!(error < times * ACCURACY, "v {velocity}, y {depth}: {found} {exact}");
        }
    }
}

#[test]
fn it_goes_to_the_elastic_contacts_at_rest_and_at_infinite_speed() {
    for depth in [2e-4, 3e-3, 1.5e-2] {
        let elastic = LawIndenter::Cylinder(LAYER).elastic(depth).unwrap();
        for (velocity, modulus) in [(1e-12, 1.0), (1e12, 10.0)] {
            let found = law().evaluate(&LawPoint::new(velocity, depth));
            let force = modulus * elastic.force * depth;
            assert!((found.force.value / force - 1.0).abs() < 3e-3, "{depth} {velocity}");
            assert!((found.area.value / (elastic.area * depth.sqrt()) - 1.0).abs() < 3e-3);
        }
        let slow = law().evaluate(&LawPoint::new(1e-9, depth)).friction.value;
        assert!((slow / 0.9e-9 - 1.0).abs() < 1e-6, "{slow}");
    }
}

fn quantities(response: &ContactResponse) -> [judder_contact::WithDerivatives; 3] {
    [response.force, response.area, response.friction]
}

#[test]
fn derivatives_are_those_of_the_values_inside_and_beyond() {
    const STEP: f64 = 1e-3;
    for velocity in [1e-9, 1e-4, 3e-2, 0.5, 20.0, 1e6] {
        for depth in [1e-6, 2e-4, 4e-3, 1.7e-2, 0.1] {
            let at = |dv: f64, dy: f64| {
                let point = LawPoint::new(velocity * (dv * STEP).exp(), depth * (dy * STEP).exp());
                quantities(&law().evaluate(&point))
            };
            for (k, q) in at(0.0, 0.0).into_iter().enumerate() {
                let slope = |dv: f64, dy: f64| {
                    let f = |n: f64| at(n * dv, n * dy)[k].value.ln();
                    (8.0 * (f(1.0) - f(-1.0)) - (f(2.0) - f(-2.0))) / (12.0 * STEP)
                };
                assert!(
                    (slope(1.0, 0.0) - q.by_velocity * velocity / q.value).abs() < 2e-6,
                    "{k} {velocity} {depth}"
                );
                assert!(
                    (slope(0.0, 1.0) - q.by_indentation * depth / q.value).abs() < 2e-6,
                    "{k} {velocity} {depth}"
                );
            }
        }
    }
}

#[test]
fn a_length_multiplies_force_and_width_and_nothing_else() {
    let at = LawPoint::new(0.1, 1e-3);
    let (one, sixty) = (law().evaluate(&at), law().clone().over_length(60.0).evaluate(&at));
    assert_eq!(sixty.force.value, 60.0 * one.force.value);
    assert!((sixty.area.by_indentation / (60.0 * one.area.by_indentation) - 1.0).abs() < 1e-14);
    assert_eq!(sixty.friction, one.friction);
}

#[test]
fn its_file_is_read_as_it_was_written() {
    let whole = Law::Tabulated(Arc::new(law().clone()));
    let text = to_json(&whole).unwrap().unwrap();
    assert_eq!(from_json(&text).unwrap(), whole);
    let as_sphere = text.replace("\"limits\": null", "\"limits\": {}");
    assert!(matches!(from_json(&as_sphere), Err(LawError::Json(_))));
}

/// Beyond its depths the law is told to be assumed, and its errors are not known.
#[test]
fn beyond_its_depths_it_is_doubted() {
    let concern = |depth: f64| law().concern(0.1, depth);
    assert!(matches!(concern(1e-5), Some(ValidityConcern::TooShallow { .. })));
    assert!(matches!(concern(0.05), Some(ValidityConcern::TooDeep { .. })));
    assert_eq!(concern(1e-3), None);
    assert!(law().doubt(&LawPoint::new(0.1, 1e-5)).is_none());
    assert!(law().doubt(&LawPoint::new(0.1, 1e-3)).is_some());
}

#[test]
fn what_is_no_layer_has_no_law() {
    for layer in [LawLayer { thickness: 0.0, ..LAYER }, LawLayer { poisson_ratio: 0.6, ..LAYER }] {
        assert!(matches!(LawIndenter::Cylinder(layer).elastic(1e-3), Err(LawError::Layer(_))));
    }
    let thin = LawLayer { thickness: 1e-4, ..LAYER };
    assert!(matches!(LawIndenter::Cylinder(thin).elastic(1e-2), Err(LawError::Cylinder(_))));
}
