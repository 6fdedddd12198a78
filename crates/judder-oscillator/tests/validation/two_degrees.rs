//! Two-degree systems with closed forms.

use super::near;
use judder_numerics::root::all_roots;
use judder_oscillator::Verdict;
use judder_oscillator::characteristic::Characteristic;
use judder_oscillator::linear_system::LinearSystem;
use judder_oscillator::spectrum::{eigenvalues, growth_rate};

fn characteristic(system: &LinearSystem) -> Characteristic {
    Characteristic::new(&system.reduced().unwrap())
}

/// The friction coefficients at which the stability margin changes sign.
fn changes_of_stability(system: impl Fn(f64) -> LinearSystem) -> Vec<f64> {
    let samples: Vec<f64> = (0..=200).map(|k| f64::from(k) / 100.0).collect();
    all_roots(|friction| characteristic(&system(friction)).margin(), &samples).roots
}

/// The minimal model of mode coupling, K = [[2, 1 − 4μ/3], [1, 2]] without damping.
///
/// Source: Hoffmann, Fischer, Allgaier and Gaul, Mech. Res. Commun. 29 (2002), with its stiffnesses. λ² = −2 ± √(1 − 4μ/3): the
/// modes merge at μ = 3/4 with ω = √2, and at μ = 1 λ² = −2 ± i/√3.
#[test]
fn minimal_model_of_mode_coupling() {
    let system = |friction: f64| LinearSystem {
        mass: [[1.0, 0.0], [0.0, 1.0]],
        damping: [[0.0; 2]; 2],
        stiffness: [[2.0, 1.0 - 4.0 * friction / 3.0], [1.0, 2.0]],
    };
    let found = changes_of_stability(system);
    assert!(found.len() == 1 && near(found[0], 0.75, 1e-14), "{found:?}");
    let values = |friction| eigenvalues(&system(friction).reduced().unwrap()).unwrap();
    assert!(values(0.75).iter().all(|value| near(value.im.abs(), 2_f64.sqrt(), 1e-14) && value.re == 0.0));
    assert!((growth_rate(&values(1.0)) - 0.202_071_768_8).abs() < 5e-11);
}

/// C = diag(c1, c2), K = [[k11, k12 − k3 μ], [k12, k22]].
#[derive(Clone, Copy)]
struct Hopf {
    c: [f64; 2],
    k11: f64,
    k22: f64,
    k12: f64,
    k3: f64,
}

impl Hopf {
    fn system(self, friction: f64) -> LinearSystem {
        LinearSystem {
            mass: [[1.0, 0.0], [0.0, 1.0]],
            damping: [[self.c[0], 0.0], [0.0, self.c[1]]],
            stiffness: [[self.k11, self.k12 - self.k3 * friction], [self.k12, self.k22]],
        }
    }

    /// μ_H from H3 = 0. With s = p3 = c1 + c2 and r = p1/p3 = (c1 k22 + c2 k11)/s, H3 = p3² [r (p2 − r) − p0], so
    ///
    /// k11 k22 − k12 (k12 − k3 μ) = r (k11 + k22 + c1 c2 − r), or k12 k3 μ = k12² + r c1 c2 − (k11 − r)(k22 − r).
    ///
    /// k11 − r = c1 D/s and k22 − r = −c2 D/s with D = k11 − k22, so the last product is −c1 c2 D²/s².
    fn critical_friction(self) -> f64 {
        let Self { c: [c1, c2], k11, k22, k12, k3 } = self;
        let s = c1 + c2;
        let (r, d) = ((c1 * k22 + c2 * k11) / s, k11 - k22);
        (k12 + (c1 * c2 * d * d / (s * s) + r * c1 * c2) / k12) / k3
    }

    /// ω_H² = r, from λ = iω in the odd part of (21), −p3 ω² + p1 = 0.
    fn squared_frequency(self) -> f64 {
        (self.c[0] * self.k22 + self.c[1] * self.k11) / (self.c[0] + self.c[1])
    }

    /// Where the modes merge without damping: 4 k12 (k12 − k3 μ) + D² = 0.
    fn merging_friction(self) -> f64 {
        (self.k12 + (self.k11 - self.k22).powi(2) / (4.0 * self.k12)) / self.k3
    }
}

#[test]
fn damped_hopf_points() {
    let base = Hopf { c: [0.0; 2], k11: 2.0, k22: 2.4, k12: 1.0, k3: 4.0 / 3.0 };
    for (c, printed) in [([0.02, 0.02], 0.78066), ([0.02, 0.002], 0.759_988_264_5), ([0.002, 0.02], f64::NAN)]
    {
        let hopf = Hopf { c, ..base };
        let found = changes_of_stability(|friction| hopf.system(friction));
        assert!(found.len() == 1 && near(found[0], hopf.critical_friction(), 1e-11), "{c:?}: {found:?}");
        assert!(printed.is_nan() || near(found[0], printed, 1e-10), "{c:?}: {found:?}");
        let frequency = characteristic(&hopf.system(found[0])).hopf_frequency();
        assert!(near(frequency.powi(2), hopf.squared_frequency(), 1e-12), "{c:?}: {frequency}");
        for (friction, verdict) in
            [(0.999 * found[0], Verdict::Stable), (1.001 * found[0], Verdict::Unstable)]
        {
            assert_eq!(characteristic(&hopf.system(friction)).verdict(), verdict);
        }
    }
}

/// Ziegler's paradox: uneven damping moves the threshold below that of the undamped system, and no smaller damping heals it.
#[test]
fn uneven_damping_destabilises() {
    let even = Hopf { c: [0.02, 0.02], k11: 2.0, k22: 2.4, k12: 1.0, k3: 4.0 / 3.0 };
    assert!(near(even.merging_friction(), 0.78, 1e-15));
    assert!(even.critical_friction() > even.merging_friction());
    for factor in [1.0, 1e-2, 1e-4] {
        let uneven = Hopf { c: [0.02 * factor, 0.002 * factor], ..even };
        let found = changes_of_stability(|friction| uneven.system(friction));
        assert!(found[0] < 0.98 * even.merging_friction(), "{factor}: {found:?}");
    }
}
