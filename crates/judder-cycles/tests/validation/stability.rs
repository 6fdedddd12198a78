//! Floquet multipliers against closed forms.

use crate::common::{assembly, diagonal, point_on_plane};
use crate::growing;
use judder_assembly::friction::{Friction, FrictionTable};
use judder_assembly::interface::InterfaceLaw;
use judder_cycles::cycle::{CycleSettings, HarmonicCount, limit_cycles};
use judder_cycles::stability::{CycleStability, floquet_multipliers};
use std::f64::consts::TAU;

/// Friction that falls at the speed of the belt and rises beside it: the mass swings without sticking. Of two states the product of the multipliers, one of which is 1, is
/// exp ∮ −(c + N μ′(|v|))/m dt (N. H. Abel, J. Liouville).
#[test]
fn the_multiplier_of_one_freedom_is_that_of_its_divergence() {
    const DAMPING: f64 = 0.01;
    let table =
        FrictionTable { velocity: vec![0.0, 0.3, 0.5, 0.9], coefficient: vec![0.28, 0.36, 0.33, 0.42] };
    let friction = Friction::Table(table);
    let case = assembly(
        [diagonal(&[1.0; 2]), diagonal(&[DAMPING, 0.0]), diagonal(&[100.0, 0.0])],
        vec![0.0, -1.0],
        vec![point_on_plane(&[0, 1], 0.4, 0.0)],
        InterfaceLaw::Rigid(friction.clone()),
    );
    let (steady, values) = growing(&case, [5.0, 20.0]);
    let settings =
        CycleSettings { harmonics: HarmonicCount::Fixed(20), samples: 32, ..CycleSettings::default() };
    let found = limit_cycles(&case, &steady, values[0], &settings, &|| true).unwrap();
    let cycle = &found.cycles[0];
    assert_eq!(cycle.points[0].shares, [0.0, 1.0, 0.0]);
    let over = cycle.over_a_period(4096).unwrap();
    let divergence = |instant: usize| -(DAMPING + friction.at(over.motions[(instant, 1)].abs()).slope);
    let mean = (0..4096).map(divergence).sum::<f64>() / 4096.0;
    let expected = (mean * TAU / cycle.frequency()).exp();
    let found = floquet_multipliers(&cycle.balance, &cycle.motion, &|| true).unwrap().unwrap();
    assert!(expected < 0.95, "{expected}");
    assert!((found.phase.unwrap() - 1.0).norm() < 1e-3, "{found:?}");
    assert!(
        (found.values[0].re - expected).abs() < 1e-3 && found.values[0].im == 0.0,
        "{found:?} {expected}"
    );
    // the normal is held: nothing is left of it
    assert!(found.values[1..].iter().all(|own| own.norm() < 1e-6), "{found:?}");
    assert_eq!(found.verdict(), CycleStability::Stable);
}
