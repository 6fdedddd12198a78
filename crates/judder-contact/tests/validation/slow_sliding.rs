//! The first terms in the speed from rest, in closed form: area and friction fall as z, the force rises as z².

use crate::questions::{assert_close, on_grid};
use judder_contact::law::{LawIndenter, LawMaterial, LawTerm};
use judder_contact::steady::GridChoice;
use judder_contact::unilateral::Loading;

/// One time, a small and a large contrast, and two times of which the longer decides.
fn materials() -> [LawMaterial; 4] {
    let term = |retardation_time, compliance| LawTerm { retardation_time, compliance };
    let two = LawMaterial { modulus_ratio: 5.0, terms: vec![term(0.3, 0.5), term(1.2, 0.3)] };
    [2.0, 10.0, 100.0]
        .map(|ratio| LawMaterial::one_time(ratio).unwrap())
        .into_iter()
        .chain([two])
        .collect::<Vec<_>>()
        .try_into()
        .unwrap()
}

/// ln(g/g0), ln(m/(m0 z)), ln(f/f0) of a contact at z, over those at rest.
fn logarithms(material: &LawMaterial, indenter: LawIndenter, depth: f64, z: f64) -> [f64; 3] {
    let rest = indenter.elastic(depth).unwrap();
    let velocity = z * depth.sqrt();
    let (substrate, grid) = (material.sliding(velocity), GridChoice::Cells(256));
    let contact = on_grid(&substrate, indenter.profile(), Loading::Indentation(depth), grid, 1e-6).refinement;
    let force = contact.force.value / (4.0 / 3.0 * depth.powf(1.5) * rest.force);
    let area = contact.area.value / (std::f64::consts::PI * depth * rest.area);
    let friction = contact.friction.value / (material.slow_friction() * rest.slow_friction * velocity);
    [area.ln(), friction.ln(), force.ln()]
}

/// Slopes of area and friction over z at rest, from two speeds: what grows as z² is taken out.
fn slopes(material: &LawMaterial, indenter: LawIndenter, depth: f64) -> [f64; 2] {
    const SLOW: f64 = 0.06;
    let [slow, fast] = [1.0, 2.0].map(|factor| logarithms(material, indenter, depth, factor * SLOW));
    [0, 1].map(|k| (2.0 * slow[k] - 0.5 * fast[k]) / SLOW)
}

#[test]
fn area_and_friction_fall_with_the_speed_from_rest() {
    for material in materials() {
        let [area, friction] = slopes(&material, LawIndenter::Paraboloid, 1.0);
        // the edge is known to a tenth of a cell, 1e-3 of the radius, and z is 0.06
        assert_close(area, material.slow_area_slope(), 0.06);
        assert_close(friction, material.slow_friction_slope(), 0.02);
    }
}

#[test]
fn the_force_rises_with_the_square_of_the_speed() {
    for material in materials() {
        let square: f64 =
            material.terms.iter().map(|t| t.compliance * t.retardation_time * t.retardation_time).sum();
        let [.., force] = logarithms(&material, LawIndenter::Paraboloid, 1.0, 0.03);
        // 3/8 (2 m − s²) z²
        assert_close(force / 9e-4, 0.375 * (2.0 * square - material.slow_friction().powi(2)), 0.04);
    }
}

/// Half a radius deep both slopes of a sphere are far from those of the paraboloid.
#[test]
fn a_sphere_has_slopes_of_its_own() {
    let (material, depth) = (LawMaterial::one_time(10.0).unwrap(), 0.5);
    let rest = LawIndenter::Sphere.elastic(depth).unwrap();
    assert!((rest.area_slope - 1.0).abs() > 0.06 && (rest.friction_slope - 1.0).abs() > 0.06, "{rest:?}");
    let [area, friction] = slopes(&material, LawIndenter::Sphere, depth);
    assert_close(area, rest.area_slope * material.slow_area_slope(), 0.06);
    assert_close(friction, rest.friction_slope * material.slow_friction_slope(), 0.03);
}
