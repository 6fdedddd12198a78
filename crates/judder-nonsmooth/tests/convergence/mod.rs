//! Orders of the schemes.

use crate::common::block::block;
use crate::common::{
    IMPLICIT, assembly, coulomb, diagonal, implicit, mass_on_plane, point_on_plane, settings,
};
use judder_assembly::compliance::Compliance;
use judder_assembly::friction::{FallingFriction, Friction};
use judder_assembly::interface::InterfaceLaw;
use judder_assembly::linearised::{Linearised, LinearisedTerms};
use judder_assembly::pressure::Pressure;
use judder_assembly::steady::steady_sliding;
use judder_nonsmooth::growth::growth;
use judder_nonsmooth::march::NonsmoothMarch;
use judder_nonsmooth::scheme::ContactScheme;
use judder_structure::complex_modes::{ComplexMode, ComplexModeSettings, Region, complex_modes};

/// Where the motion is smooth, what the march measures of a mode comes to its eigenvalue with the square of the step; the
/// explicit scheme takes the damping at velocities half a step back, and is of first order in it; the implicit one is of first order where forces are not taken amid the step.
#[test]
fn smooth_motion_is_of_second_order() {
    let rigid = || InterfaceLaw::Rigid(Friction::Constant(0.5));
    let compliant = || InterfaceLaw::Compliant(Pressure::PointStiffness(1e8), Friction::Constant(0.5));
    let (damped, second, first) = ([100.0, 5e-8], 3.5..4.5, 1.8..2.6);
    for (scheme, law, damping, ratios) in [
        (IMPLICIT, rigid(), damped, &second),
        (IMPLICIT, compliant(), damped, &second),
        (implicit(0.75), rigid(), damped, &first),
        (implicit(0.75), compliant(), damped, &first),
        (ContactScheme::ForwardIncrement, rigid(), [0.0; 2], &second),
        (ContactScheme::ForwardIncrement, rigid(), damped, &first),
    ] {
        let case = block(law, 1.0, damping);
        let steady = steady_sliding(&case, &Compliance::new(&case).unwrap()).unwrap();
        let about = Linearised::new(&case, &steady, LinearisedTerms::default()).unwrap();
        let region = Region { re: [-5e4, 5e4], im: [1e3, 4e5] };
        let found = complex_modes(&about.problem, &region, &ComplexModeSettings::default()).unwrap();
        let by_growth =
            |a: &&ComplexMode, b: &&ComplexMode| a.eigenvalue.value.re.total_cmp(&b.eigenvalue.value.re);
        let fastest = found.modes.iter().max_by(by_growth).unwrap();
        let off = [2e-7, 1e-7, 5e-8].map(|step| {
            let told = growth(&case, &steady, &about, fastest, settings(scheme, step)).unwrap();
            assert!(told.is_small);
            [(told.measured.re - told.predicted.re).abs(), (told.measured.im - told.predicted.im).abs()]
        });
        // in frequency the terms of both orders are of one size at these steps
        let parts = if scheme == implicit(0.75) { 0..1 } else { 0..2 };
        for part in parts {
            for pair in off.windows(2) {
                let ratio = pair[0][part] / pair[1][part];
                assert!(ratios.contains(&ratio), "{scheme:?} {damping:?}: {off:?}");
            }
        }
    }
}

/// A ball that bounces: the step does not know when within it the ball met the plane, and its place afterwards is off with the step.
#[test]
fn motion_with_impacts_is_of_first_order() {
    let (gravity, restitution, end) = (10.0, 0.5, 0.2);
    // the worst of many heights: when within a step it meets is as good as drawn
    let worst = |step: f64| {
        (0..40)
            .map(|k| {
                let height = 0.1 + 1e-3 * f64::from(k);
                let case = assembly(
                    [diagonal(&[1.0; 2]), diagonal(&[0.0; 2]), diagonal(&[0.0; 2])],
                    vec![0.0, -gravity],
                    vec![point_on_plane(&[0, 1], 1e-12, height)],
                    coulomb(0.0),
                );
                let scheme = ContactScheme::MoreauJean { restitution, implicitness: 0.5 };
                let mut march = NonsmoothMarch::new(&case, &[], settings(scheme, step)).unwrap();
                march.set_force_scale(gravity);
                (0..(end / step).round() as u64).for_each(|_| march.advance().unwrap());
                let met = (2.0 * height / gravity).sqrt();
                let on = end - met;
                (march.gap(0) - (restitution * gravity * met * on - 0.5 * gravity * on * on)).abs()
            })
            .fold(0.0, f64::max)
    };
    let off = [4e-4, 2e-4, 1e-4, 5e-5].map(worst);
    for pair in off.windows(2) {
        assert!((1.6..2.5).contains(&(pair[0] / pair[1])), "{off:?}");
    }
}

/// Stick and slip on a law that falls: the heat of some cycles comes at least with the step to that of a step that is much shorter, by both schemes to the same.
#[test]
fn stick_and_slip_come_to_the_same_heat() {
    let falling = FallingFriction::exponential([0.6, 0.3], 0.1);
    let mut case = mass_on_plane(1.0, 100.0, [0.0, -10.0], 0.0, 0.1);
    case.interfaces[0].law = InterfaceLaw::Rigid(Friction::Falling(falling));
    let heat = |scheme: ContactScheme, step: f64| {
        let mut march = NonsmoothMarch::new(&case, &[], settings(scheme, step)).unwrap();
        march.set_force_scale(10.0);
        (0..(4.0 / step).round() as u64).for_each(|_| march.advance().unwrap());
        march.works().heat
    };
    let exact = heat(IMPLICIT, 2e-6);
    for scheme in [IMPLICIT, ContactScheme::ForwardIncrement] {
        let off = [8e-4, 2e-4, 5e-5].map(|step| (heat(scheme, step) / exact - 1.0).abs());
        assert!(off[2] < 1e-3, "{scheme:?}: {off:?}");
        // a quarter of the step, at most a quarter of what is off, but for where in a step a point sticks
        assert!(off[1] < 0.4 * off[0] && off[2] < 0.4 * off[1], "{scheme:?}: {off:?}");
    }
}
