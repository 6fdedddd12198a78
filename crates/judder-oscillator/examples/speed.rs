use judder_contact::*;
use judder_oscillator::map::*;
use judder_oscillator::*;
fn main() {
    let n = 1000;
    let log = |a: f64, b: f64| -> Vec<f64> {
        (0..n).map(|k| 10f64.powf(a + (b - a) * k as f64 / (n - 1) as f64)).collect()
    };
    for load in [FrictionLoad::NormalLoad, FrictionLoad::ContactForce] {
        for (f, y) in [(1e-6, None), (1e-3, None), (0., Some(1e-2)), (0., Some(1e-1))] {
            let mut g = Groups::default();
            let ysw = match y {
                None => {
                    g.normal_load = f;
                    (SweptCoefficient::ShearStrength, log(-4., 0.))
                }
                Some(t) => {
                    g.shear_strength = t;
                    (SweptCoefficient::NormalLoad, log(-8., -1.))
                }
            };
            let plane = CoefficientPlane {
                base: g.coefficients().unwrap(),
                x: (SweptCoefficient::Velocity, log(-8., 2.)),
                y: ysw,
            };
            let c = Contact { law: Law::Fitted(FittedLaw::oscillator_paper()), friction_load: load };
            let mut best = f64::MAX;
            let mut m = every_point(&c, &plane);
            for _ in 0..3 {
                let t = std::time::Instant::now();
                m = every_point(&c, &plane);
                best = best.min(t.elapsed().as_secs_f64());
            }
            let mut ba = f64::MAX;
            let mut a = adaptive(&c, &plane);
            for _ in 0..5 {
                let t = std::time::Instant::now();
                a = adaptive(&c, &plane);
                ba = ba.min(t.elapsed().as_secs_f64());
            }
            let diff = a.classes.iter().zip(&m.classes).filter(|(x, y)| x != y).count();
            println!(
                "{load:?} {f} {y:?} brute {best:.4}s unstable {:.4} counts {:?} | adaptive {ba:.5}s ratio {:.1} decisions {} diff {diff}",
                m.unstable_fraction(),
                mechanism::StabilityClass::ALL.map(|c| m.count(c)),
                best / ba,
                a.decisions
            );
        }
    }
}
