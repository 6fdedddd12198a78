//! What Hill's method refuses.

use super::belt::mass_on_belt;
use crate::common::{assembly, diagonal, point_on_plane};
use judder_assembly::assembly::Assembly;
use judder_assembly::compliance::Compliance;
use judder_assembly::contact_point::ContactPoint;
use judder_assembly::friction::Friction;
use judder_assembly::interface::InterfaceLaw;
use judder_assembly::pressure::Pressure;
use judder_assembly::steady::steady_sliding;
use judder_cycles::CyclesError;
use judder_cycles::backbone::PeriodicMotion;
use judder_cycles::balance::{CycleRate, HarmonicBalance};
use judder_cycles::series::Series;
use judder_cycles::stability::{HILL_ROWS, HillMultipliers, HillRefusal, hill_multipliers};

/// Of the steady state of a case, taken for a motion at 3 rad/s with five harmonics.
fn of_steady(
    case: &Assembly,
    rows: usize,
    go_on: bool,
) -> Result<Result<HillMultipliers, HillRefusal>, CyclesError> {
    let smooth = case.without_friction_at_rest().unwrap_or_else(|| case.clone());
    let steady = steady_sliding(&smooth, &Compliance::new(&smooth).unwrap()).unwrap();
    let balance = HarmonicBalance::new(case, &steady, 3.0, Series::new(5, 80), &[]).unwrap();
    let turning = CycleRate { frequency: 3.0, growth: 0.0 };
    let motion = PeriodicMotion { amplitude: 0.0, unknown: balance.steady(&steady), turning, residual: 0.0 };
    hill_multipliers(&balance, &motion, rows, &|| go_on)
}

/// A mass of which the normal freedom has a mass of its own, at a speed of the plane.
fn yielding(normal_mass: f64, speed: f64) -> Assembly {
    let rest_direction = (speed == 0.0).then_some([1.0, 0.0, 0.0]);
    let law = InterfaceLaw::Compliant(Pressure::PointStiffness(50.0), Friction::Constant(0.3));
    assembly(
        [diagonal(&[1.0, normal_mass]), diagonal(&[0.1, 0.1]), diagonal(&[100.0, 1.0])],
        vec![0.0, -1.0],
        vec![ContactPoint { rest_direction, ..point_on_plane(&[0, 1], speed, 0.0) }],
        law,
    )
}

#[test]
fn what_does_not_follow_smoothly_or_has_no_mass_is_refused() {
    // nothing moves, and the exponents are those of the linear equations: e^{sT} of s² + 0.1 s + 100 and s² + 0.1 s + 51 decays by 0.05 in both
    let known = of_steady(&yielding(1.0, 0.4), HILL_ROWS, true).unwrap().unwrap();
    let expected = (-0.05 * std::f64::consts::TAU / 3.0).exp();
    assert!((known.values[0].norm() - expected).abs() < 1e-8, "{known:?}");

    let rigid = of_steady(&mass_on_belt(), HILL_ROWS, true).unwrap();
    assert_eq!(rigid, Err(HillRefusal::NotSmooth { point: 0 }));
    let sticks = of_steady(&yielding(1.0, 0.0), HILL_ROWS, true).unwrap();
    assert_eq!(sticks, Err(HillRefusal::NotSmooth { point: 0 }));
    let massless = of_steady(&yielding(0.0, 0.4), HILL_ROWS, true).unwrap();
    assert_eq!(massless, Err(HillRefusal::NoMass));
}

#[test]
fn problems_beyond_the_limit_are_refused_and_all_can_be_stopped() {
    let large = of_steady(&yielding(1.0, 0.4), 43, true).unwrap().unwrap_err();
    assert_eq!(large, HillRefusal::TooLarge { rows: 44, most: 43 });
    assert_eq!(large.to_string(), "the eigenvalue problem has 44 rows: eigenvalues are computed of up to 43");
    // what no other size would mend comes first
    let sticks = of_steady(&yielding(1.0, 0.0), 43, true).unwrap();
    assert_eq!(sticks, Err(HillRefusal::NotSmooth { point: 0 }));
    assert!(of_steady(&yielding(1.0, 0.4), 44, true).unwrap().is_ok());
    assert_eq!(of_steady(&yielding(1.0, 0.4), HILL_ROWS, false), Err(CyclesError::Stopped));
}
