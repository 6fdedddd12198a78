//! Damping matrices on the modes of a structure against ζ(ω), and the energy that they take.

use super::modes::oblique;
use judder_structure::StructureError;
use judder_structure::assembly::Sparse;
use judder_structure::damping::{ModalDamping, RayleighDamping, StructuralDamping};
use judder_structure::freedom::Supports;
use judder_structure::modes::{Mode, WantedModes, modes};
use judder_structure::statics::product;
use std::f64::consts::TAU;

fn along(matrix: &Sparse, a: &Mode, b: &Mode) -> f64 {
    product(matrix, &a.shape).iter().zip(&b.shape).map(|(force, u)| force * u).sum()
}

/// φᵀ C φ = 2 ζ ω, and C does not couple modes (T. K. Caughey, 1960).
#[test]
fn proportional_damping_has_its_ratio_at_every_mode_and_couples_none() {
    let body = oblique();
    let assembled = body.assembled(&body.numbering(&body.held(&body.mesh.node_sets["start"])));
    let found = modes(&assembled.stiffness, &assembled.mass, WantedModes::Lowest(6)).unwrap().modes;
    let [first, .., last] = &found[..] else { panic!() };
    let rayleigh =
        RayleighDamping::through((first.frequency_hz(), 0.01), (last.frequency_hz(), 0.02)).unwrap();
    let structural = StructuralDamping::new(0.03, found[2].frequency_hz()).unwrap();
    let ratio_of_rayleigh: &dyn Fn(f64) -> f64 = &|hz| rayleigh.ratio(hz);
    let damped = [
        (rayleigh.matrix(&assembled.stiffness, &assembled.mass).unwrap(), ratio_of_rayleigh),
        (structural.matrix(&assembled.stiffness), &|hz| structural.ratio(hz)),
    ];
    for (matrix, ratio) in damped {
        for a in &found {
            let omega = TAU * a.frequency_hz();
            let zeta = along(&matrix, a, a) / (2.0 * omega);
            assert!((zeta / ratio(a.frequency_hz()) - 1.0).abs() < 1e-7, "{zeta}");
            for b in found.iter().filter(|b| *b != a) {
                let omega = TAU * a.frequency_hz().max(b.frequency_hz());
                assert!((along(&matrix, a, b) / omega).abs() < 1e-9, "{}", along(&matrix, a, b));
            }
        }
    }
    assert!((rayleigh.ratio(first.frequency_hz()) - 0.01).abs() < 1e-12);
    // the energy that a harmonic motion u = φ sin ωt loses in a cycle: πω φᵀ C φ, and of hysteresis πη φᵀ K φ
    let reference = &found[2];
    let viscous = TAU
        * reference.frequency_hz()
        * along(&structural.matrix(&assembled.stiffness), reference, reference);
    let hysteretic = 0.03 * along(&assembled.stiffness, reference, reference);
    assert!((viscous / hysteretic - 1.0).abs() < 1e-9, "{viscous} {hysteretic}");
}

/// Each of the lowest modes that swing has the ratio asked of it, rigid motions and all others none, and none is coupled.
#[test]
fn modal_damping_has_its_ratios_and_leaves_the_others() {
    let body = oblique();
    let held = body.numbering(&body.held(&body.mesh.node_sets["start"]));
    let free = body.numbering(&Supports::default());
    let ratios = [0.01, 0.0, 0.03];
    let damping = ModalDamping::new(ratios.to_vec()).unwrap();
    for (numbering, rigid) in [(held, 0), (free, 3)] {
        let assembled = body.assembled(&numbering);
        let matrix = damping.matrix(&assembled.stiffness, &assembled.mass).unwrap();
        let found =
            modes(&assembled.stiffness, &assembled.mass, WantedModes::Lowest(rigid + 6)).unwrap().modes;
        let scale = TAU * found[rigid + 5].frequency_hz();
        for (k, a) in found.iter().enumerate() {
            let asked = k.checked_sub(rigid).and_then(|k| ratios.get(k)).copied().unwrap_or(0.0);
            let taken = along(&matrix, a, a);
            assert!((taken - 2.0 * asked * TAU * a.frequency_hz()).abs() < 1e-8 * scale, "{k}: {taken}");
            for b in found.iter().filter(|b| *b != a) {
                assert!(along(&matrix, a, b).abs() < 1e-8 * scale, "{k}");
            }
        }
        let many = ModalDamping::new(vec![0.01; matrix.nrows() + 1]).unwrap();
        let refused = many.matrix(&assembled.stiffness, &assembled.mass);
        assert!(matches!(refused, Err(StructureError::TooFewModes { .. })), "{refused:?}");
    }
    for wrong in [vec![], vec![-0.1], vec![f64::NAN]] {
        assert!(matches!(ModalDamping::new(wrong), Err(StructureError::InvalidNumber { .. })));
    }
}
