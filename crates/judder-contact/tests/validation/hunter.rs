//! The sliding cylinder on a half-space of one retardation time, in closed form: S. C. Hunter, "The rolling contact of a rigid cylinder
//! with a viscoelastic half space", J. Appl. Mech. 28 (1961), 611–617, for a material with an instantaneous and a relaxed modulus.

use crate::questions::assert_close;
use judder_contact::indenter::IndenterShape;
use judder_contact::kernel::layer::BondedLayer;
use judder_contact::kernel::substrate::SlidingSubstrate;
use judder_contact::steady::{GridChoice, MEMORY, SteadyContact, SteadyQuestion, solve};
use judder_contact::unilateral::{Loading, UnilateralLimits};
use std::f64::consts::PI;

/// ∫_0^end f by the rule of the midpoint, which converges faster than any power for what is flat at both ends.
fn integral(end: f64, function: impl Fn(f64) -> f64) -> f64 {
    const STEPS: usize = 4000;
    let step = end / STEPS as f64;
    (0..STEPS).map(|k| function((k as f64 + 0.5) * step)).sum::<f64>() * step
}

/// e^{−x} I_n(x).
fn bessel_i(order: f64, x: f64) -> f64 {
    integral(PI, |angle| (x * (angle.cos() - 1.0)).exp() * (order * angle).cos()) / PI
}

/// e^{x} K_n(x).
fn bessel_k(order: f64, x: f64) -> f64 {
    integral(14.0, |t| (-x * (t.cosh() - 1.0)).exp() * (order * t).cosh())
}

/// Load per length over E0* R, half width over R, and friction.
struct Hunter {
    load: f64,
    half_width: f64,
    friction: f64,
}

/// With κ = E0/E∞ and k = c/ℓ the middle of the contact of half width c is ahead of the lowest point by
/// x0 = ℓ (1 − κ) I1(k/κ) K0(k)/(I1(k/κ) K0(k) + I0(k/κ) K1(k)); F = π c²/4 + π A with A = c x0 K1(k)/(2 K0(k)), and
/// μ = x0 − κ ℓ − π c² (x0 − ℓ)/(4F). These follow from (1 − κ ℓ d/dx) p = σ, where σ is a pressure on an elastic half-space that makes
/// δ − x²/2 − ℓ d/dx (δ − x²/2) of the contact, p being zero at both ends and the surface ahead at rest.
fn hunter(contrast: f64, length: f64, half_width: f64) -> Hunter {
    let (kappa, k, c) = (1.0 / contrast, half_width / length, half_width);
    let (i0, i1) = (bessel_i(0.0, k * contrast), bessel_i(1.0, k * contrast));
    let (k0, k1) = (bessel_k(0.0, k), bessel_k(1.0, k));
    let ahead = length * (1.0 - kappa) * i1 * k0 / (i1 * k0 + i0 * k1);
    let load = 0.25 * PI * c * c + 0.5 * PI * c * ahead * k1 / k0;
    let friction = ahead - kappa * length - 0.25 * PI * c * c * (ahead - length) / load;
    Hunter { load, half_width, friction }
}

fn solved(substrate: &SlidingSubstrate, load: f64) -> SteadyContact {
    let contact = solve(&SteadyQuestion {
        substrate,
        profile: &IndenterShape::Cylinder { radius: 1.0 },
        loading: Loading::Load(load),
        accuracy: 1e-3,
        grid: GridChoice::Automatic,
        limits: UnilateralLimits { tolerance: 1e-7, ..UnilateralLimits::default() },
        memory: MEMORY,
    })
    .unwrap();
    assert!(contact.converged, "{:?}", contact.refinement);
    contact
}

/// Over five decades of the speed, friction within 3e-3 and width within 2e-3, on a half-space and on a layer a thousand times as thick
/// as the contact is wide.
#[test]
fn friction_and_width_are_those_of_hunter() {
    println!("E∞/E0   ℓ/c      F/(E0* R)    2c/R: exact, found      μ: exact, half-space, layer");
    for contrast in [3.0, 10.0, 100.0] {
        for relative in [0.03, 0.3, 1.0, 3.0, 10.0, 100.0, 1000.0] {
            let exact = hunter(contrast, 0.1 * relative, 0.1);
            let substrate = SlidingSubstrate::single(contrast, 0.1 * relative);
            let found = solved(&substrate, exact.load).refinement;
            assert_close(found.area.value, 2.0 * exact.half_width, 2e-3);
            assert_close(found.friction.value, exact.friction, 3e-3);
            let layer = substrate.as_layer(BondedLayer::new(1e3, 0.5).unwrap());
            let on_layer = solved(&layer, exact.load).refinement;
            println!(
                "{contrast:5} {relative:6} {:12.5e} {:10.6} {:10.6} {:12.6} {:12.6} {:12.6}",
                exact.load,
                2.0 * exact.half_width,
                found.area.value,
                exact.friction,
                found.friction.value,
                on_layer.friction.value
            );
            assert_close(on_layer.area.value, 2.0 * exact.half_width, 2e-3);
            assert_close(on_layer.friction.value, exact.friction, 3e-3);
        }
    }
}
