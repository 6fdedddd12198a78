//! From the keys of a case to the oscillator and its contact.

use judder_case::{Form, FrictionLoad as CaseLoad, LawName, OscillatorCase, OscillatorInputs, OscillatorKey};
use judder_contact::{FittedLaw, HertzLaw, Law};
use judder_oscillator::groups::Scales;
use judder_oscillator::{Coefficients, Contact, FrictionLoad, Groups};

/// The contact that a case names.
#[must_use]
pub fn contact(case: &OscillatorCase) -> Contact {
    let law = match case.law {
        LawName::OscillatorPaper => Law::Fitted(FittedLaw::oscillator_paper()),
        LawName::OscillatorPaperCorrected => Law::Fitted(FittedLaw::oscillator_paper_corrected()),
        LawName::Hertz => Law::Hertz(HertzLaw::default()),
    };
    let friction_load = match case.friction_load {
        CaseLoad::NormalLoad => FrictionLoad::NormalLoad,
        CaseLoad::ContactForce => FrictionLoad::ContactForce,
    };
    Contact { law, friction_load }
}

/// The three scales that turn groups into quantities: E0* = E0/(1 − ν²), R, ω_nx.
#[must_use]
pub fn scales(inputs: &OscillatorInputs) -> Scales {
    let poisson_ratio = inputs.number(OscillatorKey::PoissonRatio);
    Scales {
        reduced_modulus: inputs.number(OscillatorKey::RubberyModulus) / (1.0 - poisson_ratio * poisson_ratio),
        radius: inputs.number(OscillatorKey::Radius),
        natural_frequency: inputs.number(OscillatorKey::NaturalFrequency),
    }
}

/// The dimensionless groups (11); what was given as a group stays that group, whatever scales are swept.
#[must_use]
pub fn groups(inputs: &OscillatorInputs) -> Groups {
    let Scales { reduced_modulus, radius, natural_frequency } = scales(inputs);
    let retardation_time = inputs.number(OscillatorKey::RetardationTime);
    let group = |key: OscillatorKey, per_unit: f64| {
        let value = inputs.get(key);
        match value.form {
            Form::Group => value.number,
            Form::Si => value.number * per_unit,
        }
    };
    Groups {
        stiffness: inputs.number(OscillatorKey::StiffnessX) / (reduced_modulus * radius),
        retardation_time: natural_frequency * retardation_time,
        velocity: group(OscillatorKey::Velocity, retardation_time / radius),
        normal_load: group(OscillatorKey::NormalLoad, 1.0 / (reduced_modulus * radius * radius)),
        shear_strength: group(OscillatorKey::ShearStrength, 1.0 / reduced_modulus),
        damping_x: inputs.number(OscillatorKey::DampingX),
        damping_y: inputs.number(OscillatorKey::DampingY),
        frequency_ratio: inputs.number(OscillatorKey::FrequencyRatio),
        coupling: inputs.number(OscillatorKey::Coupling),
        coupling_angle: inputs.number(OscillatorKey::CouplingAngle),
    }
}

/// The coefficients at these inputs; not a number where a group is out of range, which every solver reports as
/// unresolved.
#[must_use]
pub fn coefficients(inputs: &OscillatorInputs) -> Coefficients {
    groups(inputs).coefficients().unwrap_or(Coefficients { normal_load: f64::NAN, ..Coefficients::default() })
}

/// What a law was made for and a case departs from, in words.
#[must_use]
pub fn law_warning(case: &OscillatorCase) -> Option<String> {
    /// E∞/E0 of the substrate that the paper's fits were computed for.
    const FITTED_CONTRAST: f64 = 10.0;
    let contrast =
        case.inputs.number(OscillatorKey::GlassyModulus) / case.inputs.number(OscillatorKey::RubberyModulus);
    let departs = case.law != LawName::Hertz && (contrast / FITTED_CONTRAST - 1.0).abs() > 1e-9;
    departs.then(|| {
        format!(
            "the law `{}` was fitted for E∞/E0 = {FITTED_CONTRAST}, this substrate has E∞/E0 = {contrast:.4}: \
             the law does not know the difference",
            case.law.name()
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use judder_case::Value;

    #[test]
    fn the_default_case_is_the_papers() {
        assert_eq!(
            groups(&OscillatorInputs::default()),
            Groups { stiffness: 50.0 / (1e6 / 0.75 * 0.01), ..Groups::default() }
        );
    }

    #[test]
    fn quantities_become_groups() {
        let mut inputs = OscillatorInputs::default();
        inputs.set(OscillatorKey::Velocity, Value::si(0.03));
        inputs.set(OscillatorKey::NormalLoad, Value::si(0.1));
        inputs.set(OscillatorKey::ShearStrength, Value::si(1e4));
        let g = groups(&inputs);
        assert!((g.velocity - 0.03).abs() < 1e-16);
        assert!((g.normal_load - 0.1 / (4e6 / 3.0 * 1e-4)).abs() < 1e-16);
        assert!((g.shear_strength - 0.0075).abs() < 1e-16);
    }
}
