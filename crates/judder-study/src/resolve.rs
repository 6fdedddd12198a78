//! What `judder check` shows: the resolved case with and without units, its stability limits, and what a run would take.

mod contact;
mod motion;
mod sliding;
mod structure;
mod sweeps;

use crate::analyses::{ONE_WAY, class_name};
use crate::bridge;
use crate::error::StudyError;
use crate::known_substrate::KnownSubstrate;
use crate::material;
use crate::measured_band::excited_at;
use crate::point;
use crate::quasi_steady::Condition;
use crate::text::{columns, list, number};
use judder_case::sweep::MAP_BYTES_PER_POINT;
use judder_case::{
    Case, CaseFile, Form, KEYS, LawName, MapMethod, OscillatorAnalysis, OscillatorCase, TwoDegreesAnalysis,
    TwoDegreesCase,
};
use judder_contact::{HertzLaw, Law};
use judder_oscillator::Contact;
use judder_oscillator::groups::Dimensional;
use serde_json::{Value, json};

/// Seconds a point on one core, measured in the release build; good to a factor of a few.
mod cost {
    /// One decision of a map, and one growth rate.
    pub(super) const DECISION: f64 = 5e-8;
    pub(super) const EIGENVALUES: f64 = 5e-6;
    /// The search for thresholds at one point.
    pub(super) const THRESHOLDS: f64 = 2e-4;
    /// Following the cycles beside a threshold back to their fold, and seeking others beyond.
    pub(super) const MARGIN: f64 = 5.0;
    /// Lines of a map along which they are followed, at most.
    pub(super) const MARGIN_LINES: usize = 30;
    /// Following the branches of an oscillator through a diagram: seconds to a minute.
    pub(super) const BRANCHES: f64 = 10.0;
    /// Following the three boundaries of a map.
    pub(super) const BOUNDARIES: f64 = 0.3;
    /// A motion over a radian of its time: of the oscillator, of a mass on a belt.
    pub(super) const RADIAN: f64 = 1e-5;
    pub(super) const RADIAN_ON_BELT: f64 = 2e-7;
    /// A step of the time-stepping.
    pub(super) const TIME_STEP: f64 = 2.5e-6;
    /// One figure as SVG and PNG.
    pub(super) const FIGURE: f64 = 0.2;
}

/// A checked case.
#[derive(Debug, Clone)]
pub struct Resolved {
    document: Value,
    text: String,
}

impl Resolved {
    /// The document of `judder check --json`.
    #[must_use]
    pub fn json(&self) -> Value {
        self.document.clone()
    }

    /// What `judder check` prints on a terminal.
    #[must_use]
    pub fn text(&self) -> String {
        self.text.clone()
    }
}

/// What an analysis would take.
struct Estimate {
    name: String,
    points: usize,
    seconds: f64,
    bytes: u128,
}

/// Resolves a case and looks at its operating point; runs no analysis.
///
/// # Errors
/// Matrices that are not finite at the case's own parameters, a sweep that a run would refuse.
pub fn resolve(file: &CaseFile) -> Result<Resolved, StudyError> {
    sweeps::added(case(file)?, file)
}

fn case(file: &CaseFile) -> Result<Resolved, StudyError> {
    match &file.case {
        Case::Oscillator(case) => oscillator(file, &bridge::with_material(case)?),
        Case::Contact(case) => contact::resolve(file, case),
        Case::Belt(case) => motion::belt_case(file, case),
        Case::TwoDegrees(case) => Ok(two_degrees(file, case)),
        Case::Structure(case) => structure::resolve(file, case),
        Case::Sliding(case) => sliding::resolve(file, case),
    }
}

/// Where nothing is known of the operating point: a law that would have to be computed first.
const LATER: &str = "the law `bem` is computed by a run, which takes seconds to minutes";

fn oscillator(file: &CaseFile, case: &OscillatorCase) -> Result<Resolved, StudyError> {
    let groups = bridge::groups(&case.inputs);
    let dimensional = groups.dimensional(&bridge::scales(&case.inputs));
    let limits = match case.law {
        LawName::Bem => Err(LATER.to_owned()),
        _ => point::point(case).map_err(|error| format!("no answer: {error}")),
    };
    let estimates: Vec<Estimate> = case.analyses.iter().map(|a| of_oscillator(&a.name, &a.kind)).collect();
    let mut text = format!(
        "{}\n\nlaw {}, friction load {}\n\n",
        title(&case.title),
        case.law.name(),
        case.friction_load.name()
    );
    text.push_str(&columns(&key_rows(case)));
    text.push_str("\ndimensionless, and with units\n");
    let rows = group_rows(&groups, &dimensional);
    text.push_str(&columns(
        &rows
            .iter()
            .map(|(name, group, unit)| vec![(*name).to_owned(), number(*group), unit.clone()])
            .collect::<Vec<_>>(),
    ));
    // without a law nothing is known of steady sliding, but of the frequency and the substrate
    let (condition, of_band) = match &limits {
        Ok(point) => (point.quasi_steady, None),
        Err(_) => {
            let substrate = KnownSubstrate::of(case)?;
            // how large the contact is an elastic one tells near enough
            let hertz = Contact {
                law: Law::Hertz(HertzLaw::default()),
                friction_load: bridge::friction_load(case.friction_load),
            };
            let excited = excited_at(&hertz, &case.inputs).filter(|_| case.law == LawName::Bem);
            (
                Condition::at(&case.inputs, None, &substrate.terms),
                substrate.band.and_then(|band| band.warning(excited)),
            )
        }
    };
    text.push_str("\nat the operating point\n");
    let document_limits = match &limits {
        Ok(point) => {
            text.push_str(&columns(&[
                vec!["steady sliding".to_owned(), point.steady.verdict_in_words()],
                vec!["growth rate".to_owned(), number(point.steady.growth_rate())],
                vec!["critical shear strength (undamped)".to_owned(), list(&point.critical_shear_strength)],
                vec!["critical load (undamped)".to_owned(), list(&point.critical_load)],
            ]));
            point.json()
        }
        Err(error) => {
            text.push_str(&format!("  {error}\n"));
            Value::Null
        }
    };
    if let Some(condition) = &condition {
        text.push_str(&columns(&condition.rows()));
    }
    text.push_str(&estimate_text(&estimates));
    let warnings: Vec<String> = limits
        .map(|point| point.warnings)
        .unwrap_or_else(|_| {
            condition.and_then(|condition| condition.warning(None)).into_iter().chain(of_band).collect()
        })
        .into_iter()
        .collect::<std::collections::BTreeSet<_>>()
        .into_iter()
        .collect();
    for warning in &warnings {
        text.push_str(&format!("\nwarning: {warning}\n"));
    }
    let document = json!({
        "case": material::with_used(&file.case, file.case.resolved())?,
        "groups": rows.iter().map(|(name, group, _)| ((*name).to_owned(), json!(group))).collect::<serde_json::Map<_, _>>(),
        "point": document_limits,
        "quasi_steady": condition.as_ref().map(Condition::json),
        "estimate": estimate_json(&estimates),
        "warnings": warnings,
    });
    Ok(Resolved { document, text })
}

fn title(title: &str) -> &str {
    if title.is_empty() { "An untitled case" } else { title }
}

fn key_rows(case: &OscillatorCase) -> Vec<Vec<String>> {
    KEYS.iter()
        .filter(|key| case.substrate.has(key.key))
        .map(|key| {
            let value = case.inputs.get(key.key);
            let unit = match value.form {
                Form::Group => key.group.map_or(String::new(), |group| format!("= {group}")),
                Form::Si => key.dimension.unit(),
            };
            vec![key.path.to_owned(), number(value.number), unit]
        })
        .collect()
}

/// Name, group, and the quantity that it stands for.
fn group_rows(
    groups: &judder_oscillator::Groups,
    dimensional: &Dimensional,
) -> Vec<(&'static str, f64, String)> {
    let with = |value: f64, unit: &str| format!("{} {unit}", number(value));
    vec![
        ("k_x/(E0* R)", groups.stiffness, with(dimensional.stiffness_x, "N/m")),
        ("ω_nx τ", groups.retardation_time, with(dimensional.retardation_time, "s")),
        ("R/x0", groups.radius(), with(dimensional.radius, "m")),
        ("v_d τ/R", groups.velocity, with(dimensional.velocity, "m/s")),
        ("F_n/(E0* R²)", groups.normal_load, with(dimensional.normal_load, "N")),
        ("τ0/E0*", groups.shear_strength, with(dimensional.shear_strength, "Pa")),
    ]
}

fn of_oscillator(name: &str, kind: &OscillatorAnalysis) -> Estimate {
    let (points, seconds) = match kind {
        OscillatorAnalysis::Motion(kind) => return motion::estimate(name, kind, cost::RADIAN),
        OscillatorAnalysis::Engines(settings) => return motion::engines(name, settings),
        OscillatorAnalysis::EquivalentDamping { sweep, family }
        | OscillatorAnalysis::Spectrum { sweep, family } => {
            let points = sweep.points * family.as_ref().map_or(1, |f| f.values.len());
            (points, points as f64 * cost::EIGENVALUES)
        }
        OscillatorAnalysis::CriticalShearStrength { sweep, family, global_margin, .. }
        | OscillatorAnalysis::CriticalLoad { sweep, family, global_margin, .. } => {
            let points = sweep.points * family.as_ref().map_or(1, |f| f.values.len());
            let margin = if *global_margin { cost::MARGIN } else { 0.0 };
            (points, points as f64 * (cost::THRESHOLDS + margin))
        }
        OscillatorAnalysis::StabilityMap(map) => {
            let points = map.x.points * map.y.points;
            let decisions = match map.method {
                MapMethod::EveryPoint => points as f64 * (cost::DECISION + cost::EIGENVALUES),
                // about two dozen decisions along each unit of the sides
                MapMethod::Adaptive => {
                    (24 * (map.x.points + map.y.points)).min(2 * points) as f64 * 2.0 * cost::DECISION
                }
            };
            let lines = map.x.points.max(map.y.points).min(cost::MARGIN_LINES);
            let margins = if map.global_margin { lines as f64 * cost::MARGIN } else { 0.0 };
            (points, decisions + margins + if map.boundaries { cost::BOUNDARIES } else { 0.0 })
        }
    };
    Estimate {
        name: name.to_owned(),
        points,
        seconds: seconds + cost::FIGURE,
        bytes: points as u128 * MAP_BYTES_PER_POINT,
    }
}

fn of_two_degrees(name: &str, kind: &TwoDegreesAnalysis) -> Estimate {
    let points = match kind {
        TwoDegreesAnalysis::Spectrum { sweep } | TwoDegreesAnalysis::Critical { sweep } => sweep.points,
        TwoDegreesAnalysis::StabilityMap(map) => map.x.points * map.y.points,
    };
    Estimate {
        name: name.to_owned(),
        points,
        seconds: points as f64 * cost::EIGENVALUES + cost::FIGURE,
        bytes: points as u128 * MAP_BYTES_PER_POINT,
    }
}

fn estimate_json(estimates: &[Estimate]) -> Value {
    estimates
        .iter()
        .map(|e| json!({ "name": e.name, "points": e.points, "seconds": e.seconds, "bytes": e.bytes as u64 }))
        .collect()
}

fn estimate_text(estimates: &[Estimate]) -> String {
    if estimates.is_empty() {
        return "\nno analyses\n".to_owned();
    }
    let rows: Vec<Vec<String>> = estimates
        .iter()
        .map(|e| {
            let memory = format!("{:.1} MB", e.bytes as f64 / 1e6);
            vec![e.name.clone(), format!("{} points", e.points), format!("about {:.1} s", e.seconds), memory]
        })
        .collect();
    format!("\nanalyses: size, time on one core, memory of the arrays\n{}", columns(&rows))
}

fn two_degrees(file: &CaseFile, case: &TwoDegreesCase) -> Resolved {
    let estimates: Vec<Estimate> = case.analyses.iter().map(|a| of_two_degrees(&a.name, &a.kind)).collect();
    let mut text = format!("{}\n\nparameters\n", title(&case.title));
    text.push_str(&columns(
        &case.parameters.iter().map(|p| vec![p.name.clone(), number(p.value)]).collect::<Vec<_>>(),
    ));
    let document_point = match analysed(case) {
        Ok((point, shown)) => {
            text.push_str(&shown);
            point
        }
        Err(reason) => {
            text.push_str(&format!("\nno answer at these parameters: {reason}\n"));
            Value::Null
        }
    };
    text.push_str(&estimate_text(&estimates));
    let document = json!({
        "case": file.case.resolved(),
        "point": document_point,
        "estimate": estimate_json(&estimates),
        "warnings": [],
    });
    Resolved { document, text }
}

/// Eigenvalues and verdict at the case's own parameters, as a document and as text.
fn analysed(case: &TwoDegreesCase) -> Result<(Value, String), String> {
    use judder_oscillator::mechanism::StabilityClass;
    let matrices = case.matrices(&case.values()).map_err(|cause| cause.to_string())?;
    let system = judder_oscillator::LinearSystem {
        mass: matrices.mass,
        damping: matrices.damping,
        stiffness: matrices.stiffness,
    };
    let reduced = system.reduced().map_err(|error| error.to_string())?;
    let values = judder_oscillator::spectrum::eigenvalues(&reduced).map_err(|error| error.to_string())?;
    let class = StabilityClass::of_system(&system).map_err(|error| error.to_string())?;
    let rows: Vec<Vec<String>> =
        values.iter().map(|l| vec![number(l.re), format!("{} i", number(l.im))]).collect();
    let text =
        format!("\nat these parameters: {}; eigenvalues\n{}", class_name(class, ONE_WAY), columns(&rows));
    let verdict = class.verdict().map_or("unresolved", judder_oscillator::Verdict::name);
    let document = json!({
        "eigenvalues": values.map(|l| [l.re, l.im]),
        "growth_rate": judder_oscillator::spectrum::growth_rate(&values),
        "verdict": verdict,
        "mechanism": if class.is_unstable() { class_name(class, ONE_WAY) } else { "none" },
    });
    Ok((document, text))
}
