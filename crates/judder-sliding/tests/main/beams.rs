//! The pair of the beams paper at rest.
use crate::common;
use judder_sliding::coupling::SteadyFriction;
use judder_sliding::statics::PairEquilibrium;
use std::f64::consts::TAU;

/// 243 degrees of freedom, as the paper counts them; the cantilever's frequencies by beam theory, λ = 1.8751, 4.6941 with
/// f = λ²/(2π l²) √(EI/ρA), to 0.2 % (shear).
#[test]
fn the_pair_of_the_paper_has_243_modes() {
    let pair = common::pair();
    assert_eq!(pair.modes(), 243);
    assert_eq!(pair.eigenvalues()[0], 0.0);
    let track = &pair.track().body.eigenvalues;
    let stiffness = (2.38e9_f64 * 0.002_f64.powi(2) / (12.0 * 1200.0)).sqrt();
    for (mode, wave) in [1.875_104_f64, 4.694_091].into_iter().enumerate() {
        let expected = wave.powi(2) / (TAU * 0.01) * stiffness;
        let found = track[mode].sqrt() / TAU;
        assert!((found / expected - 1.0).abs() < 2e-3, "{found} {expected}");
    }
}

/// At rest the contact is closed, K q = f + e N holds, and the slope of the track is that of a cantilever under N.
#[test]
fn the_deformed_state_is_in_balance() {
    let pair = common::pair();
    let sliding = SteadyFriction::at(pair.friction(), common::SPEED);
    for position in [0.01, 0.0405, 0.074, 0.098] {
        let rest = PairEquilibrium::new(&pair, position, common::LOAD, sliding).unwrap();
        assert!(rest.touch.gap.abs() < 1e-16, "{position}: {}", rest.touch.gap);
        let coupling = rest.coupling(&pair, sliding);
        let of_load = |k: usize| pair.slider().load.get(k).map_or(0.0, |row| row * common::LOAD);
        for (k, value) in pair.eigenvalues().iter().enumerate() {
            let left = value * rest.state[k];
            let right = of_load(k) + coupling.equilibrium[k] * rest.normal_force;
            assert!((left - right).abs() < 1e-10 * right.abs().max(1.0), "{position} {k}: {left} {right}");
        }
        let inertia = 0.020 * 0.002_f64.powi(3) / 12.0;
        // the friction acts at the upper edge, half a thickness above the axis
        let moment = 0.5 * position.powi(2) + common::FRICTION * 0.001 * position;
        let expected = -rest.normal_force * moment / (2.38e9 * inertia);
        let slope = rest.touch.tangent[1] / rest.touch.tangent[0];
        assert!((slope / expected - 1.0).abs() < 0.02, "{position}: {slope} {expected}");
    }
}
