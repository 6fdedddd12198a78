//! A block of quadrilaterals that is pushed on a moving plane.

use crate::common::block::{block, block_held};
use crate::common::{IMPLICIT, settings};
use judder_assembly::compliance::Compliance;
use judder_assembly::friction::{FallingFriction, Friction};
use judder_assembly::interface::InterfaceLaw;
use judder_assembly::linearised::{Linearised, LinearisedTerms};
use judder_assembly::pressure::Pressure;
use judder_assembly::steady::steady_sliding;
use judder_nonsmooth::growth::growth;
use judder_nonsmooth::march::NonsmoothMarch;
use judder_nonsmooth::mode_share::{ModalContent, ModeShare};
use judder_nonsmooth::scheme::ContactScheme;
use judder_structure::complex_modes::{ComplexModeSettings, Region, complex_modes};

/// Growth in the march is the eigenvalue's to 2e-3, by both schemes, of every mode of the band that swings clearly.
#[test]
fn modes_grow_in_the_march_as_their_eigenvalues_say() {
    let falling = FallingFriction::exponential([0.6, 0.45], 0.5);
    let laws = [
        InterfaceLaw::Rigid(Friction::Constant(0.5)),
        InterfaceLaw::Rigid(Friction::Falling(falling)),
        InterfaceLaw::Compliant(Pressure::Stiffness(1e12), Friction::Constant(0.5)),
    ];
    let cases = laws.iter().flat_map(|law| [block, block_held].map(|make| (law, make)));
    for (law, make) in cases {
        let case = make(law.clone(), 1.0, [100.0, 5e-8]);
        let steady = steady_sliding(&case, &Compliance::new(&case).unwrap()).unwrap();
        let about = Linearised::new(&case, &steady, LinearisedTerms::default()).unwrap();
        let region = Region { re: [-5e4, 5e4], im: [1e3, 4e5] };
        let found = complex_modes(&about.problem, &region, &ComplexModeSettings::default()).unwrap();
        let mode = found
            .modes
            .iter()
            .max_by(|a, b| a.eigenvalue.value.re.total_cmp(&b.eigenvalue.value.re))
            .unwrap();
        for (scheme, step) in [(IMPLICIT, 5e-8), (ContactScheme::ForwardIncrement, 5e-8)] {
            let told = growth(&case, &steady, &about, mode, settings(scheme, step)).unwrap();
            let off = (told.measured.re - told.predicted.re).abs() / told.predicted.re.abs();
            assert!(told.is_small);
            assert!(off < 2e-3, "{law:?} {scheme:?}: {told:?}");
            assert!((told.measured.im / told.predicted.im - 1.0).abs() < 1e-3);
        }
    }
}

/// A motion that is started in a mode has that mode alone, with its amplitude and its frequency.
#[test]
fn a_motion_in_a_mode_has_that_mode() {
    let case = block(InterfaceLaw::Rigid(Friction::Constant(0.1)), 1.0, [100.0, 5e-8]);
    let steady = steady_sliding(&case, &Compliance::new(&case).unwrap()).unwrap();
    let about = Linearised::new(&case, &steady, LinearisedTerms::default()).unwrap();
    let region = Region { re: [-5e4, 5e4], im: [1e3, 2e5] };
    let found = complex_modes(&about.problem, &region, &ComplexModeSettings::default()).unwrap();
    let step = 1e-7;
    let mut march = NonsmoothMarch::new(&case, &[], settings(IMPLICIT, step)).unwrap();
    let shares = found.modes.iter().map(|mode| {
        let (right, left) = (about.expanded(&mode.right), about.expanded_left(&mode.left));
        ModeShare::new(&march, &about, mode.eigenvalue.value, [&right, &left], &steady.displacement)
    });
    let mut content = ModalContent::new(shares.collect());
    let value = found.modes[0].eigenvalue.value;
    let (shape, size) = (about.expanded(&found.modes[0].right), 1e-9);
    let state = |factor: faer::c64, rest: &dyn Fn(usize) -> f64| -> Vec<f64> {
        (0..shape.len()).map(|k| rest(k) + size * (factor * shape[k]).re).collect()
    };
    march.start(&state(faer::c64::ONE, &|k| steady.displacement[k]), &state(value, &|_| 0.0));
    let steps = (20.0 * std::f64::consts::TAU / value.im / step) as u64;
    for _ in 0..steps {
        march.advance().unwrap();
        content.take(&march);
    }
    // the mean square of e^{σt}
    let time = steps as f64 * step;
    let grown = ((2.0 * value.re * time).exp_m1() / (2.0 * value.re * time)).sqrt();
    let [rms, turning] = content.of(0).unwrap();
    assert!((rms / (0.5 * size * grown) - 1.0).abs() < 5e-3, "{rms} {}", 0.5 * size * grown);
    assert!((turning / value.im - 1.0).abs() < 2e-3, "{turning} {}", value.im);
    for mode in 1..found.modes.len() {
        let [other, _] = content.of(mode).unwrap();
        assert!(other < 2e-2 * rms, "mode {mode}: {other} beside {rms}");
    }
}
