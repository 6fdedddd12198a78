//! A cylinder on a layer: Hertz, the spectral solution of the elastic contact, both ends of the speed, and energy.

use crate::questions::assert_close;
use judder_contact::cylinder_on_layer::CylinderOnLayer;
use judder_contact::indenter::IndenterShape;
use judder_contact::kernel::layer::BondedLayer;
use judder_contact::kernel::substrate::SlidingSubstrate;
use judder_contact::law::{LawIndenter, LawLayer, LawMaterial};
use judder_contact::steady::{GridChoice, MEMORY, SteadyContact, SteadyQuestion, solve};
use judder_contact::unilateral::{Loading, UnilateralLimits};
use std::f64::consts::PI;

const CYLINDER: IndenterShape = IndenterShape::Cylinder { radius: 1.0 };

fn on_layer(
    material: SlidingSubstrate,
    layer: &BondedLayer,
    loading: Loading,
    grid: GridChoice,
) -> SteadyContact {
    solve(&SteadyQuestion {
        substrate: &material.as_layer(layer.clone()),
        profile: &CYLINDER,
        loading,
        accuracy: 1e-3,
        grid,
        limits: UnilateralLimits { tolerance: 1e-7, ..UnilateralLimits::default() },
        memory: MEMORY,
    })
    .unwrap()
}

fn pressed(material: SlidingSubstrate, layer: &BondedLayer, depth: f64) -> SteadyContact {
    let contact = on_layer(material, layer, Loading::Indentation(depth), GridChoice::Automatic);
    assert!(contact.converged, "{layer:?} {depth}: {:?}", contact.refinement);
    contact
}

/// Hertz: a² = 4F R/(π E0*), p0 = 2F/(π a).
#[test]
fn on_a_thick_layer_the_cylinder_is_that_of_hertz() {
    let load: f64 = 0.01;
    let half = (4.0 * load / PI).sqrt();
    for nu in [0.3, 0.5] {
        let layer = BondedLayer::new(200.0 * half, nu).unwrap();
        let loading = Loading::Load(load);
        let found = on_layer(SlidingSubstrate::elastic(), &layer, loading, GridChoice::Automatic).refinement;
        assert_close(found.area.value, 2.0 * half, 1e-3);
        assert_close(found.peak_pressure.value, 2.0 * load / (PI * half), 1e-3);
        let exact = CylinderOnLayer::of_half_width(&layer, half).unwrap();
        assert_close(found.indentation.value, exact.indentation, 1e-3);
    }
}

/// Boundary elements against polynomials, from contacts thirty times narrower than the layer to ones ten times wider.
#[test]
fn elastic_contacts_are_those_of_the_polynomials() {
    for nu in [0.0, 0.3, 0.49, 0.5] {
        for (thickness, depth) in [(3.0, 0.01), (0.3, 0.03), (0.1, 0.02), (0.01, 1e-3), (0.01, 3e-3)] {
            let layer = BondedLayer::new(thickness, nu).unwrap();
            let exact = CylinderOnLayer::of_indentation(&layer, depth).unwrap();
            let found = pressed(SlidingSubstrate::elastic(), &layer, depth).refinement;
            assert_close(found.force.value, exact.force, 1e-3);
            assert_close(found.area.value, 2.0 * exact.half_width, 5e-3);
            assert!(found.friction.value.abs() < 1e-12);
        }
    }
}

/// Slow sliding lags by (1 − E0/E∞) v τ on any layer; fast sliding creeps under the glassy pressure: μ = Σ C_k E∞/ℓ_k ∫p u/F.
#[test]
fn slow_and_fast_sliding_have_the_friction_of_their_closed_forms() {
    let contrast = 10.0;
    for nu in [0.3, 0.5] {
        for (thickness, depth) in [(1.0, 0.01), (0.05, 0.01)] {
            let layer = BondedLayer::new(thickness, nu).unwrap();
            let slow = pressed(SlidingSubstrate::single(contrast, 1e-5), &layer, depth).refinement;
            assert_close(slow.friction.value, 0.9e-5, 5e-3);
            let glassy = CylinderOnLayer::of_indentation(&layer, depth).unwrap();
            let fast = pressed(SlidingSubstrate::single(contrast, 1e5), &layer, depth).refinement;
            assert_close(fast.force.value, contrast * glassy.force, 2e-3);
            let creep = (contrast - 1.0) / 1e5 * glassy.twice_the_work / glassy.force;
            assert_close(fast.friction.value, creep, 5e-3);
        }
    }
}

/// Friction times speed is what the layer dissipates, at every speed, thick or thin.
#[test]
fn friction_is_the_energy_that_the_layer_dissipates() {
    for nu in [0.3, 0.5] {
        for (thickness, depth) in [(1.0, 0.01_f64), (0.1, 0.01), (0.02, 0.002)] {
            let layer = BondedLayer::new(thickness, nu).unwrap();
            for exponent in -2..=3 {
                let length = 10.0_f64.powi(exponent) * depth.sqrt();
                let contact = pressed(SlidingSubstrate::single(10.0, length), &layer, depth);
                let difference = contact.friction_difference();
                assert!(difference < 5e-3, "ν {nu}, h {thickness}, ℓ {length}: {difference}");
            }
        }
    }
}

/// Against the polynomials the force gains more than an order with every halving of the strips.
#[test]
fn the_force_on_a_layer_converges_faster_than_linearly() {
    for nu in [0.3, 0.5] {
        let (layer, depth) = (BondedLayer::new(0.1, nu).unwrap(), 0.01);
        let exact = CylinderOnLayer::of_indentation(&layer, depth).unwrap().force;
        let loading = Loading::Indentation(depth);
        let contact = on_layer(SlidingSubstrate::elastic(), &layer, loading, GridChoice::Cells(1024));
        let errors: Vec<f64> =
            contact.refinement.levels.iter().map(|level| (level.force / exact - 1.0).abs()).collect();
        let order = (errors[0] / errors[errors.len() - 1]).log2() / (errors.len() - 1) as f64;
        println!("ν {nu}: {errors:.1?}, order {order:.2}");
        assert!(order > 1.3, "{order} from {errors:?}");
    }
}

/// The first terms in the speed: the width falls by the shift of the trailing edge, the friction by the singularity there.
#[test]
fn width_and_friction_fall_with_the_speed_from_rest() {
    let material = LawMaterial::one_time(10.0).unwrap();
    for (thickness, poisson_ratio, depth) in [(1.0, 0.5, 0.01), (0.05, 0.3, 0.01), (0.1, 0.5, 0.01)] {
        let indenter = LawIndenter::Cylinder(LawLayer { thickness, poisson_ratio });
        let rest = indenter.elastic(depth).unwrap();
        let layer = BondedLayer::new(thickness, poisson_ratio).unwrap();
        let at = |z: f64| {
            let velocity = z * depth.sqrt();
            let (loading, grid) = (Loading::Indentation(depth), GridChoice::Cells(2048));
            let found = on_layer(material.sliding(velocity), &layer, loading, grid).refinement;
            let width = found.area.value / (rest.area * depth.sqrt());
            [width.ln(), (found.friction.value / (material.slow_friction() * velocity)).ln()]
        };
        const SLOW: f64 = 0.03;
        let (slow, fast) = (at(SLOW), at(2.0 * SLOW));
        // what grows as z² is taken out
        let [width, friction] = [0, 1].map(|k| (2.0 * slow[k] - 0.5 * fast[k]) / SLOW);
        assert_close(width, rest.area_slope * material.slow_area_slope(), 0.1);
        assert_close(friction, rest.friction_slope * material.slow_friction_slope(), 0.05);
    }
}
