//! From the keys of a case to the oscillator and its contact.

use crate::computed_law::{self, KnownPoints, NO_POINTS};
use crate::error::ModelError;
use crate::material::Material;
use crate::oscillator::case::OscillatorCase;
use crate::oscillator::inputs::OscillatorInputs;
use crate::oscillator::keys::OscillatorKey;
use crate::oscillator::law_name::LawName;
use crate::within_law::unknown_errors;
use judder_contact::law::file::from_json;
use judder_contact::law::material::{LawMaterial, LawTerm};
use judder_contact::law::{LawIndenter, LawLayer};
use judder_contact::{FittedLaw, HertzLaw, Law};
use judder_keys::numeric_key::Form;
use judder_numerics::order::sort_by_number;
use judder_numerics::words::plain;
use judder_oscillator::groups::Scales;
use judder_oscillator::{Coefficients, Contact, Groups};
use judder_study::{Progress, Silent, input_file};

/// The contact of a case, and what makes its law doubtful there.
#[derive(Debug, Clone)]
pub struct CaseContact {
    /// The contact.
    pub contact: Contact,
    /// What makes its law doubtful there, a sentence each.
    pub warnings: Vec<String>,
}

/// The law of this name where it is a formula.
#[must_use]
pub fn formula(name: LawName) -> Option<Law> {
    match name {
        LawName::OscillatorPaper => Some(Law::Fitted(FittedLaw::oscillator_paper())),
        LawName::OscillatorPaperCorrected => Some(Law::Fitted(FittedLaw::oscillator_paper_corrected())),
        LawName::Hertz => Some(Law::Hertz(HertzLaw::default())),
        LawName::Bem | LawName::File => None,
    }
}

/// The contact that a case names. The law `bem` is computed at its first use and remembered while the program runs.
///
/// # Errors
/// A law that cannot be computed or read, [`ModelError::Interrupted`].
pub fn contact_of(case: &OscillatorCase, progress: &dyn Progress) -> Result<CaseContact, ModelError> {
    contact(case, NO_POINTS, progress)
}

/// The contact that a case names; none where its law would have to be computed first.
///
/// # Errors
/// A law that cannot be read or is not one of the case's indenter.
pub(crate) fn known_contact(case: &OscillatorCase) -> Result<Option<CaseContact>, ModelError> {
    if case.law == LawName::Bem { Ok(None) } else { contact_of(case, &Silent).map(Some) }
}

/// The contact that a case names. The law `bem` is computed at its first use, from the `points` that are known, and remembered while
/// the program runs.
///
/// # Errors
/// A law that cannot be computed or read, [`ModelError::Interrupted`].
pub(crate) fn contact(
    case: &OscillatorCase,
    points: KnownPoints<'_>,
    progress: &dyn Progress,
) -> Result<CaseContact, ModelError> {
    let mut missed = None;
    let law = match (formula(case.law), case.law) {
        (Some(law), _) => law,
        (None, LawName::Bem) => {
            let material = Material::new(&case.substrate, &case.inputs)?;
            let computed = match line_of(case) {
                Some(line) => {
                    computed_law::of_cylinder(&material, line.layer, case.law_accuracy, points, progress)?
                }
                None => computed_law::of_paraboloid(&material, case.law_accuracy, points, progress)?,
            };
            missed = computed.missed(case.law_accuracy);
            computed.law
        }
        (None, _) => read_law(case)?,
    };
    let CaseContact { contact, warnings } = with_law(case, law)?;
    Ok(CaseContact { contact, warnings: missed.into_iter().chain(warnings).collect() })
}

/// The contact of a case with this law in place of its own.
///
/// # Errors
/// A substrate that cannot be.
pub fn with_law(case: &OscillatorCase, law: Law) -> Result<CaseContact, ModelError> {
    let of_origin = shape_warning(case, &law)?.into_iter().chain(law_warning(case, &law)?);
    let warnings = of_origin.chain(unknown_errors(&law)).collect();
    let law = match line_of(case) {
        Some(line) => law.over_length(line.length),
        None => law,
    };
    Ok(CaseContact { contact: Contact { law, friction_load: case.friction_load }, warnings })
}

/// A cylinder on its layer, over its radius.
struct LineOfCase {
    layer: LawLayer,
    /// L/R.
    length: f64,
}

/// The cylinder of a case that has one.
fn line_of(case: &OscillatorCase) -> Option<LineOfCase> {
    let [radius, poisson_ratio] =
        [OscillatorKey::Radius, OscillatorKey::PoissonRatio].map(|key| case.inputs.number(key));
    let (length, thickness) = case.length.zip(case.substrate.thickness)?;
    let layer = LawLayer { thickness: thickness / radius, poisson_ratio };
    Some(LineOfCase { layer, length: length / radius })
}

/// That a law was computed for another indenter than that of an oscillator, in words.
///
/// # Errors
/// A law per length for a paraboloid, another for a cylinder.
fn shape_warning(case: &OscillatorCase, law: &Law) -> Result<Option<String>, ModelError> {
    /// What thickness and Poisson's ratio of one layer may differ by in the last digits.
    const SAME: f64 = 1e-9;
    let Some(data) = law.data() else { return Ok(None) };
    let shape = match (data.origin().indenter, line_of(case)) {
        (LawIndenter::Paraboloid, None) => return Ok(None),
        (LawIndenter::Sphere, None) => "a sphere",
        (LawIndenter::Cylinder(made_for), Some(line)) => {
            let own = line.layer;
            let differs = (made_for.thickness / own.thickness - 1.0).abs() > SAME
                || (made_for.poisson_ratio - own.poisson_ratio).abs() > SAME;
            return Ok(differs.then(|| {
                format!(
                    "the law `{}` was computed for a layer of h/R = {} with ν = {}, this one has {} and {}: the law does not know the difference",
                    case.law.name(),
                    plain(made_for.thickness),
                    made_for.poisson_ratio,
                    plain(own.thickness),
                    own.poisson_ratio
                )
            }));
        }
        (LawIndenter::Cylinder(_), None) => {
            return Err(ModelError::Unsupported(format!(
                "the law `{}` is that of a cylinder, per length: set indenter.shape = \"cylinder\" with `length`, and substrate.thickness",
                case.law.name()
            )));
        }
        (LawIndenter::Paraboloid | LawIndenter::Sphere, Some(_)) => {
            return Err(ModelError::Unsupported(format!(
                "the law `{}` was not computed for a cylinder: leave indenter.shape out, or compute it, law = \"bem\"",
                case.law.name()
            )));
        }
    };
    Ok(Some(format!(
        "the law `{}` was computed for {shape}, an oscillator case says a radius alone, that of a paraboloid: at a tenth of the radius the two differ by 1 % in \
         force, 3 % in area",
        case.law.name()
    )))
}

fn read_law(case: &OscillatorCase) -> Result<Law, ModelError> {
    let path = case.law_file.as_ref().map(|file| file.path.clone()).unwrap_or_default();
    Ok(from_json(&input_file::text(&path)?).map_err(|error| input_file::unusable(&path, &error))?)
}

/// The case with the moduli and the time that its series, data and temperature say.
///
/// # Errors
/// Data that cannot be read or fitted.
pub fn with_material(case: &OscillatorCase) -> Result<OscillatorCase, ModelError> {
    let plain = case.substrate.decided_by().is_none();
    let inputs =
        if plain { case.inputs } else { Material::new(&case.substrate, &case.inputs)?.told_to(&case.inputs) };
    Ok(OscillatorCase { inputs, ..case.clone() })
}

/// The dimensionless groups (11); what was given as a group stays that group, whatever scales are swept.
#[must_use]
pub fn groups(inputs: &OscillatorInputs) -> Groups {
    let Scales { reduced_modulus, radius, natural_frequency } = inputs.scales();
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

/// What substrate a law was made for and a case departs from, in words: E∞/E0, then the times τ_k/τ with their compliances.
///
/// # Errors
/// A substrate that cannot be.
fn law_warning(case: &OscillatorCase, law: &Law) -> Result<Option<String>, ModelError> {
    /// E∞/E0 of the substrate that the paper's fits were computed for.
    const FITTED_CONTRAST: f64 = 10.0;
    let made_for = match law {
        // the law `bem` is computed for the substrate of the case
        _ if case.law == LawName::Bem => return Ok(None),
        Law::Hertz(_) | Law::Sampled(_) => return Ok(None),
        Law::Fitted(_) => LawMaterial::one_time(FITTED_CONTRAST)?,
        Law::Collapsed(law) => law.data().origin().material.clone(),
        Law::Tabulated(law) => law.data().origin().material.clone(),
    };
    let contrast =
        case.inputs.number(OscillatorKey::GlassyModulus) / case.inputs.number(OscillatorKey::RubberyModulus);
    let (made, has) = if (contrast / made_for.modulus_ratio - 1.0).abs() > 1e-9 {
        (format!("E∞/E0 = {}", made_for.modulus_ratio), format!("E∞/E0 = {contrast:.4}"))
    } else {
        let own = Material::new(&case.substrate, &case.inputs)?.of_law();
        let Some(difference) = difference_of_terms(&made_for, &own) else { return Ok(None) };
        difference
    };
    let verb = if case.law.is_fitted() { "fitted" } else { "computed" };
    Ok(Some(format!(
        "the law `{}` was {verb} for {made}, this substrate has {has}: the law does not know the difference",
        case.law.name()
    )))
}

/// The number of retardation times of two materials, or the first time that differs; `None` where they are the same.
fn difference_of_terms(made_for: &LawMaterial, own: &LawMaterial) -> Option<(String, String)> {
    /// What two fits to the same data on different machines may differ by.
    const SAME: f64 = 1e-6;
    let ascending = |material: &LawMaterial| {
        let mut terms = material.terms.clone();
        sort_by_number(&mut terms, |own| own.retardation_time);
        terms
    };
    let (made_for, own) = (ascending(made_for), ascending(own));
    if made_for.len() != own.len() {
        let count = |terms: &[LawTerm]| match terms.len() {
            1 => "1 retardation time".to_owned(),
            many => format!("{many} retardation times"),
        };
        return Some((count(&made_for), count(&own)));
    }
    let same = |a: f64, b: f64| (a / b - 1.0).abs() <= SAME;
    let place = made_for.iter().zip(&own).position(|(a, b)| {
        !same(a.retardation_time, b.retardation_time) || !same(a.compliance, b.compliance)
    })?;
    let shown = |term: &LawTerm| {
        let (time, compliance) = (term.retardation_time, term.compliance);
        format!("τ_{0}/τ = {time:.4e} with C_{0} E0 = {compliance:.4e}", place + 1)
    };
    Some((shown(&made_for[place]), shown(&own[place])))
}

#[cfg(test)]
mod tests {
    use super::*;
    use judder_keys::numeric_key::Value;

    #[test]
    fn the_default_case_is_the_papers() {
        assert_eq!(
            groups(&OscillatorInputs::default()),
            Groups { stiffness: 50.0 / (1e6 / 0.75 * 0.01), ..Groups::default() }
        );
    }

    #[test]
    fn materials_of_one_contrast_are_told_apart_by_their_times() {
        let of = |terms: &[(f64, f64)]| LawMaterial {
            modulus_ratio: 10.0,
            terms: terms
                .iter()
                .map(|(retardation_time, compliance)| LawTerm {
                    retardation_time: *retardation_time,
                    compliance: *compliance,
                })
                .collect(),
        };
        let (one, two) = (of(&[(1.0, 0.9)]), of(&[(0.5, 0.6), (2.0, 0.3)]));
        assert_eq!(difference_of_terms(&two, &of(&[(2.0, 0.3), (0.5, 0.6)])), None);
        let (made, has) = difference_of_terms(&one, &two).unwrap();
        assert_eq!((made.as_str(), has.as_str()), ("1 retardation time", "2 retardation times"));
        let (made, has) = difference_of_terms(&two, &of(&[(0.5, 0.6), (2.1, 0.3)])).unwrap();
        assert_eq!(made, "τ_2/τ = 2.0000e0 with C_2 E0 = 3.0000e-1");
        assert_eq!(has, "τ_2/τ = 2.1000e0 with C_2 E0 = 3.0000e-1");
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
