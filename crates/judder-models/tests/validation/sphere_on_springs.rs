//! The oscillator paper's model, carried by an assembly: a mass on its springs, whose sphere slides on the substrate of the case.

use judder_models::bridge::groups;
use judder_models::oscillator::case::OscillatorCase;
use judder_models::point::point;
use judder_oscillator::linearisation::Linearisation;
use judder_oscillator::spectrum::eigenvalues;
use judder_oscillator::{Coefficients, Dimensional};
use judder_study::Silent;
use judder_study::analyses::run;
use num_complex::Complex64;
use serde_json::Value;

/// A sphere and how it slides, as both models write it.
#[derive(Debug, Clone, Copy)]
struct Sliding {
    law: &'static str,
    friction_load: &'static str,
    /// v_d τ/R.
    velocity: f64,
    /// F_n/(E0* R²).
    load: f64,
    /// τ0/E0*.
    shear_strength: f64,
}

/// Whether the sphere has its load of its own, or one of the case presses it.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Pressed {
    ByItself,
    ByTheCase,
}

/// The spring along the sliding direction: straight, or one that has half of its stiffness at rest and as much force where the sphere slides at this x in m.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Suspension {
    Straight,
    Cubic { x: f64 },
}

impl Suspension {
    /// The spring as a contact without friction that stays closed, N = k x/2 + (k/(2 x_e²)) x³.
    fn contact(self, stiffness: f64) -> String {
        let Self::Cubic { x } = self else { return String::new() };
        let (half, cubic) = (0.5 * stiffness, 0.5 * stiffness / (x * x));
        format!(
            "[[contact]]\nname = \"suspension\"\nslider = {{ structure = \"oscillator\", set = \"mass\" }}\n\
             track = {{ plane = {{ normal = [-1, 0] }} }}\nsliding = {{ velocity = \"1 m/s\", direction = [0, 1] }}\n\
             normal = {{ point_cubic = {{ stiffness = \"{half:e} N/m\", cubic_stiffness = \"{cubic:e} N/m^3\" }} }}\n\
             friction_coefficient = 0\nall_closed = true\n"
        )
    }
}

/// R and τ of the paper.
const RADIUS: f64 = 0.01;
const TIME: f64 = 0.01;

impl Sliding {
    fn oscillator(&self) -> OscillatorCase {
        let Self { law, friction_load, velocity, load, shear_strength } = self;
        let text = format!(
            "model = \"oscillator\"\n[contact]\nlaw = \"{law}\"\nfriction_load = \"{friction_load}\"\nshear_strength = {shear_strength:e}\n\
             [oscillator]\ndamping_y = 0.02\nfrequency_ratio = 1.2\ncoupling_angle = \"40 deg\"\n\
             [operation]\nvelocity = {velocity:e}\nnormal_load = {load:e}\n"
        );
        let file = judder_models::parse("oscillator.toml", &text, &[]).unwrap();
        file.case.of::<OscillatorCase>().unwrap().clone()
    }

    /// The eigenvalues of the assembly up to a size, 1/s.
    fn of_assembly(&self, pressed: Pressed, suspension: Suspension, largest: f64) -> Vec<Complex64> {
        let oscillator = self.oscillator();
        let groups = groups(&oscillator.inputs);
        let dimensional = groups.dimensional(&oscillator.inputs.scales());
        let matrices = matrices(&groups.coefficients().unwrap(), &dimensional, suspension);
        let suspension = suspension.contact(dimensional.stiffness_x);
        let Self { law, friction_load, velocity, load, shear_strength } = self;
        let (own, of_case) = match pressed {
            Pressed::ByItself => (format!(", normal_load = {load:e}"), String::new()),
            Pressed::ByTheCase => {
                let force = -dimensional.normal_load;
                let table = "[[load]]\nstructure = \"oscillator\"\nset = \"mass\"\ndirection = \"y\"\n";
                (String::new(), format!("{table}force = \"{force:e} N\"\n"))
            }
        };
        let speed = velocity * RADIUS / TIME;
        let text = format!(
            "model = \"assembly\"\n[substrate]\nretardation_time = \"10 ms\"\n\
             [[structure]]\nname = \"oscillator\"\nmatrices = {{ {matrices}, freedoms = [[\"mass\", \"x\"], [\"mass\", \"y\"]] }}\n\
             [[contact]]\nname = \"tip\"\nslider = {{ structure = \"oscillator\", set = \"mass\" }}\ntrack = {{ plane = {{ normal = [0, 1] }} }}\n\
             sliding = {{ velocity = \"{speed:e} m/s\", direction = [1, 0] }}\n\
             asperity = {{ radius = \"10 mm\", law = \"{law}\", friction_load = \"{friction_load}\", shear_strength = {shear_strength:e}{own} }}\n\
             {suspension}{of_case}[[analysis]]\nname = \"modes\"\nkind = \"eigen\"\n\
             region = {{ re = [-{largest:e}, {largest:e}], im = [-{largest:e}, {largest:e}] }}\n"
        );
        let file = judder_models::parse("assembly.toml", &text, &[]).unwrap();
        let outcome = run(&file, 0, &Silent).unwrap();
        let number = |told: &Value, key: &str| told[key].as_f64().unwrap();
        let values = outcome.scalars["eigenvalues"].as_array().unwrap().iter();
        values.map(|told| Complex64::new(number(told, "re"), number(told, "im"))).collect()
    }
}

/// M, C and K of (12) in SI units; the y of the paper points into the substrate, that of the assembly out of it.
fn matrices(c: &Coefficients, d: &Dimensional, suspension: Suspension) -> String {
    let k = d.stiffness_x;
    let k11 = if suspension == Suspension::Straight { c.k11 } else { c.k11 - 1.0 };
    let damping = k / d.natural_frequency;
    let matrices = [
        ("mass", [d.mass(), 0.0, d.mass()]),
        ("damping", [damping * c.damping_x, 0.0, damping * c.damping_y]),
        ("stiffness", [k * k11, -k * c.k12, k * c.k22]),
    ];
    let text = matrices.map(|(name, [xx, xy, yy])| format!("{name} = [[{xx:e}, {xy:e}], [{xy:e}, {yy:e}]]"));
    text.join(", ")
}

/// How far the eigenvalues of the assembly are from those of the oscillator, over each of these.
fn farthest(sliding: &Sliding, pressed: Pressed) -> f64 {
    let expected = point(&sliding.oscillator()).unwrap().steady.eigenvalues;
    farthest_from(expected, sliding, pressed, Suspension::Straight)
}

/// The same of eigenvalues over ω_nx.
fn farthest_from(
    expected: [Complex64; 4],
    sliding: &Sliding,
    pressed: Pressed,
    suspension: Suspension,
) -> f64 {
    let frequency = sliding.oscillator().inputs.scales().natural_frequency;
    let expected = expected.map(|value| frequency * value);
    let largest = expected.iter().map(|value| value.norm()).fold(0.0, f64::max);
    let own = sliding.of_assembly(pressed, suspension, 1.5 * largest);
    assert_eq!(own.len(), expected.len(), "{sliding:?}");
    let off = expected.map(|value| {
        let distance = own.iter().map(|other| (other - value).norm());
        distance.fold(f64::INFINITY, f64::min) / value.norm()
    });
    off.into_iter().fold(0.0, f64::max)
}

/// A suspension that stiffens: N(x_e) is that of the straight spring, so the sphere slides where that of the oscillator does, and k/2 + 3 k/2 = 2 k holds it there:
/// (20) with k11 + 1.
#[test]
fn a_mass_on_a_cubic_spring_has_the_eigenvalues_of_the_oscillator_with_its_slope() {
    for (velocity, load, shear_strength) in [(1e-4, 1e-6, 0.01), (3e-3, 1e-4, 0.03), (0.1, 1e-2, 0.001)] {
        let law = "oscillator-paper-corrected";
        let sliding = Sliding { law, friction_load: "contact-force", velocity, load, shear_strength };
        let case = sliding.oscillator();
        let steady = point(&case).unwrap().steady;
        let dimensional = steady.groups.dimensional(&case.inputs.scales());
        let x = steady.equilibrium.x * dimensional.normal_load / dimensional.stiffness_x;
        let stiffened = Linearisation { k11: steady.linearisation.k11 + 1.0, ..steady.linearisation };
        let expected = eigenvalues(&stiffened.system().reduced().unwrap()).unwrap();
        let straight = steady.eigenvalues;
        assert!(straight.iter().zip(&expected).any(|(one, other)| (one - other).norm() > 0.05), "{x}");
        for pressed in [Pressed::ByItself, Pressed::ByTheCase] {
            let off = farthest_from(expected, &sliding, pressed, Suspension::Cubic { x });
            assert!(off < 1e-9, "{sliding:?}, pressed {pressed:?}: {off:e}");
        }
    }
}

#[test]
fn a_mass_on_springs_has_the_eigenvalues_of_the_oscillator() {
    let mut compared = 0;
    for law in ["oscillator-paper", "oscillator-paper-corrected", "hertz"] {
        for friction_load in ["normal-load", "contact-force"] {
            for velocity in [1e-6, 1e-4, 3e-3, 0.1] {
                for (load, shear_strength) in [(1e-7, 0.1), (1e-6, 0.01), (1e-4, 0.03), (1e-2, 0.001)] {
                    let sliding = Sliding { law, friction_load, velocity, load, shear_strength };
                    for pressed in [Pressed::ByItself, Pressed::ByTheCase] {
                        let off = farthest(&sliding, pressed);
                        assert!(off < 1e-12, "{sliding:?}, pressed {pressed:?}: {off:e}");
                        compared += 1;
                    }
                }
            }
        }
    }
    assert_eq!(compared, 192);
}
