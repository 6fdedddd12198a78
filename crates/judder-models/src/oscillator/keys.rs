//! The numbers of an oscillator case, each declared once.

use judder_keys::Keys;
use judder_keys::dimension::Dimension;
use judder_keys::numeric_key::{Range, Scaled};
use std::f64::consts::FRAC_PI_2;

/// A number of an oscillator case. The defaults are the oscillator paper's.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Keys)]
pub enum OscillatorKey {
    /// Modulus of the substrate under slow loading.
    #[key(section = "substrate", symbol = "E0", rule = STRESS, default = "1 MPa", typical = [1e4, 1e8])]
    RubberyModulus,
    /// Modulus of the substrate under fast loading, above the rubbery modulus.
    #[key(section = "substrate", symbol = "E∞", rule = STRESS, default = "10 MPa", typical = [1e5, 1e10])]
    GlassyModulus,
    /// Creep time of the substrate, the paper's τ.
    #[key(section = "substrate", symbol = "τ", rule = TIME, default = "10 ms", typical = [1e-6, 10.0])]
    RetardationTime,
    /// Relaxation time of the substrate, τ E0/E∞; in place of retardation_time.
    #[key(section = "substrate", symbol = "τ_r", rule = TIME, typical = [1e-6, 10.0])]
    RelaxationTime,
    /// The Poisson ratio of the substrate.
    #[key(section = "substrate", symbol = "ν", rule = Scaled::number("ν", POISSON), default = "0.5", typical = [0.0, 0.5])]
    PoissonRatio,
    /// Radius of the indenter.
    #[key(section = "indenter", symbol = "R", rule = Scaled::quantity(Dimension::LENGTH), default = "10 mm", typical = [1e-5, 1.0])]
    Radius,
    /// Interfacial shear strength.
    #[key(section = "contact", symbol = "τ0", rule = SHEAR_STRENGTH, default = "0.01", typical = [1e-4, 1.0], scaled = "τ̃_{0}")]
    ShearStrength,
    /// Damping ratio along the sliding direction.
    #[key(section = "oscillator", symbol = "ξ_x", rule = Scaled::number("ξ_x", Range::NonNegative), default = "0.01", typical = [0.0, 0.2], label = "Damping")]
    DampingX,
    /// Damping ratio normal to the surface.
    #[key(section = "oscillator", symbol = "ξ_y", rule = Scaled::number("ξ_y", Range::NonNegative), default = "0.01", typical = [0.0, 0.2], label = "Damping")]
    DampingY,
    /// Normal over tangential natural frequency, ω_ny/ω_nx.
    #[key(section = "oscillator", symbol = "Ω", rule = Scaled::number("Ω", Range::Positive), default = "1.0", typical = [0.1, 10.0])]
    FrequencyRatio,
    /// Coupling frequency ratio, ω_nxy/ω_nx; η² is k_xy/k_x.
    #[key(section = "oscillator", symbol = "η", rule = Scaled::number("η", Range::NonNegative), default = "1.0", typical = [0.0, 2.0])]
    Coupling,
    /// Inclination of the oblique spring.
    #[key(section = "oscillator", symbol = "α", rule = ANGLE, default = "45 deg", typical = [0.0, FRAC_PI_2])]
    CouplingAngle,
    /// Tangential natural frequency; 1 Hz is 2π rad/s.
    #[key(section = "oscillator", symbol = "ω_nx", rule = Scaled::quantity(Dimension::ANGULAR_FREQUENCY), default = "40 rad/s", typical = [1.0, 1e5])]
    NaturalFrequency,
    /// Tangential stiffness.
    #[key(section = "oscillator", symbol = "k_x", rule = Scaled::quantity(Dimension::STIFFNESS), default = "50 N/m", typical = [0.1, 1e7], label = "Stiffness")]
    StiffnessX,
    /// Driving speed.
    #[key(section = "operation", symbol = "v_d", rule = Scaled::positive(Dimension::SPEED, "v_d τ/R"), default = "1e-4", typical = [1e-8, 1e2], label = "Substrate velocity", scaled = "v̂_{d}")]
    Velocity,
    /// Normal load.
    #[key(section = "operation", symbol = "F_n", rule = Scaled::positive(Dimension::FORCE, "F_n/(E0* R²)"), default = "1e-6", typical = [1e-9, 1e-2], scaled = "F̃_{n}")]
    NormalLoad,
}

const STRESS: Scaled = Scaled::quantity(Dimension::STRESS);
const TIME: Scaled = Scaled::quantity(Dimension::TIME);
const ANGLE: Scaled = Scaled { range: Range::Any, ..Scaled::quantity(Dimension::ANGLE) };
const POISSON: Range = Range::Interval { above: -1.0, up_to: 0.5 };
const SHEAR_STRENGTH: Scaled =
    Scaled { range: Range::NonNegative, ..Scaled::positive(Dimension::STRESS, "τ0/E0*") };

#[cfg(test)]
mod tests {
    use super::*;
    use judder_keys::keys::Keys;
    use judder_keys::numeric_key::Form;

    #[test]
    fn axes_are_labelled_in_both_forms() {
        let velocity = OscillatorKey::Velocity.entry();
        assert_eq!([Form::Group, Form::Si].map(|form| velocity.label(form)), ["v_d τ/R", "v_d (m/s)"]);
        assert_eq!([Form::Group, Form::Si].map(|form| velocity.markup(form)), ["v̂_{d}", "v_{d}"]);
        assert_eq!(OscillatorKey::DampingX.entry().label(Form::Group), "ξ_x");
        let markup =
            [OscillatorKey::RubberyModulus, OscillatorKey::NaturalFrequency, OscillatorKey::Coupling]
                .map(|key| key.entry().markup(Form::Si));
        assert_eq!(markup, ["E_{0}", "ω_{nx}", "η"]);
    }

    #[test]
    fn defaults_are_values_of_their_keys() {
        for entry in OscillatorKey::ALL {
            assert_eq!(entry.default.is_some(), entry.usual_value().is_some(), "{}", entry.path);
            let ends = entry.typical.unwrap();
            assert!(ends[0] < ends[1] && entry.rule.range.contains(ends[1]), "{}", entry.path);
        }
    }
}
