//! The oscillator with laws that are tables.

use crate::computed::computed_laws;
use judder_oscillator::block::{LANES, PointBlock};
use judder_oscillator::characteristic::Characteristic;
use judder_oscillator::equilibrium::equilibrium;
use judder_oscillator::linearisation::Linearisation;
use judder_oscillator::{Coefficients, Contact, FrictionLoad, Groups, mechanism::StabilityClass};
use proptest::prelude::*;

proptest! {
    #[test]
    fn the_vector_path_is_the_scalar_path(
        logs in prop::collection::vec((-8.0..2.0_f64, -9.0..-1.0_f64, -4.0..0.0_f64), LANES),
        contact_force: bool,
        guess in -1.0..1.0_f64,
    ) {
        let friction_load = if contact_force { FrictionLoad::ContactForce } else { FrictionLoad::NormalLoad };
        for law in computed_laws() {
            let contact = Contact { law, friction_load };
            let points: Vec<Coefficients> = logs.iter().map(|(v, f, t)| Groups {
                velocity: 10_f64.powf(*v), normal_load: 10_f64.powf(*f), shear_strength: 10_f64.powf(*t), ..Groups::default()
            }.coefficients().unwrap()).collect();
            let mut block = PointBlock::default();
            for (lane, c) in points.iter().enumerate() {
                block.set(lane, c, equilibrium(&contact, c).unwrap().ln_indentation + guess);
            }
            block.decide(&contact, LANES);
            block.measure_margins(&contact);
            for (lane, c) in points.iter().enumerate() {
                let e = equilibrium(&contact, c).unwrap();
                prop_assert!((block.ln_indentation[lane] - e.ln_indentation).abs() <= 1e-12);
                let system = Linearisation::new(contact.friction_load, c, &e.response).system().reduced().unwrap();
                let margin = Characteristic::new(&system).margin();
                prop_assert!((block.margin[lane] - margin).abs() <= 1e-9, "{} {}", block.margin[lane], margin);
                if StabilityClass::clearance(&system) > 1e-8 {
                    prop_assert_eq!(block.class(lane), StabilityClass::of(&system));
                }
            }
        }
    }
}
