//! Why modes grow: what feeds them, which undamped modes take part, what would change them.

use super::super::undamped::Undamped;
use crate::error::ModelError;
use crate::structure::build::{Structure, factors};
use crate::structure::case::StructureCase;
use crate::structure::solved_size::complex_mode_settings;
use judder_numerics::order::sort_by_number;
use judder_store::Results;
use judder_structure::StructureError;
use judder_structure::affine::Factors;
use judder_structure::assembly::Sparse;
use judder_structure::complex_modes::{ComplexMode, Region, Verdict, complex_modes};
use judder_structure::diagnosis::{Diagnosis, EnergySign, Influence, MatrixSum, diagnosis, participations};
use judder_structure::modes::{Mode, WantedModes, modes};
use judder_structure::quadratic::Quadratic;
use judder_structure::statics::product;
use judder_study::outcome::{CheckRecord, Disagreement};
use judder_study::text::short;
use num_complex::Complex64;
use std::f64::consts::TAU;

/// Modes that are looked at, the fastest growing first.
const MODES: usize = 10;
/// Undamped modes that are told of each.
const COMPONENTS: usize = 5;
/// Undamped modes are sought up to so much more than the highest frequency of the region.
const REACH: f64 = 1.5;
/// Relative step of the derivatives of factors.
const STEP: f64 = 1e-6;
/// What the powers of all matrices may leave of the growth rate times the energy, over |λ| and the parts of the energy.
const BALANCE_LIMIT: f64 = 1e-9;
/// A relative error of growths that is told.
const INEXACT: f64 = 1e-6;

/// What is told of the modes that grow.
pub(super) struct GrowingModes {
    pub(super) modes: Vec<Diagnosed>,
    pub(super) warnings: Vec<String>,
    pub(super) check: CheckRecord,
}

/// Why a mode grows.
#[derive(Results)]
pub(crate) struct Diagnosed {
    /// what each matrix adds to the growth rate
    matrices: Vec<Fed>,
    /// all of it together
    #[result(unit = "1/s")]
    sum: Option<f64>,
    /// whether the energy of the mode is positive
    positive_energy: bool,
    /// the energy by which what matrices add is divided
    energy: ModeEnergy,
    mode: usize,
    #[result(unit = "1/s")]
    growth_rate: f64,
    frequency_hz: f64,
    /// the undamped modes with the largest shares
    component_modes: Vec<TakingPart>,
    /// of what matrices those are
    component_modes_of: &'static str,
    /// what parameters change
    parameters: Vec<MovedModes>,
}

/// What a matrix adds to a growth rate.
#[derive(Results)]
struct Fed {
    /// mass, damping or stiffness
    part: &'static str,
    name: String,
    #[result(unit = "1")]
    factor: f64,
    /// what it adds
    #[result(unit = "1/s")]
    growth: Option<f64>,
    /// ∂λ/∂(its factor)
    sensitivity: Complex64,
}

/// The energy of a mode.
#[derive(Results)]
struct ModeEnergy {
    sign: &'static str,
    /// what is left of its parts
    #[result(unit = "1")]
    share: f64,
    /// how far that may be off
    error: f64,
    /// what that makes of the growths
    #[result(unit = "1/s")]
    growth_error: Option<f64>,
}

/// An undamped mode that takes part in a complex one.
#[derive(Results)]
struct TakingPart {
    mode: usize,
    frequency_hz: f64,
    /// its share of the kinetic energy
    #[result(unit = "1")]
    share: f64,
    /// modal assurance criterion of both
    #[result(unit = "1")]
    mac: f64,
}

/// What a parameter changes.
#[derive(Results)]
struct MovedModes {
    name: String,
    /// ∂λ/∂(the parameter)
    sensitivity: Complex64,
}

/// Looks at the unstable modes of a region; `None` where there are none.
pub(super) fn of_growing(
    case: &StructureCase,
    structure: &Structure,
    sought: &Region,
    found: &[ComplexMode],
) -> Result<Option<GrowingModes>, ModelError> {
    let mut growing: Vec<(usize, &ComplexMode)> =
        found.iter().enumerate().filter(|(_, mode)| mode.eigenvalue.verdict() == Verdict::Unstable).collect();
    if growing.is_empty() {
        return Ok(None);
    }
    sort_by_number(&mut growing, |own| -own.1.eigenvalue.value.re);
    growing.truncate(MODES);
    let at = factors(case, &case.values())?;
    let undamped = Undamped::new(case, structure)?;
    let highest = sought.im[1].abs().max(sought.im[0].abs()) * REACH;
    let mut warnings = Vec::new();
    let components = match components(&undamped, highest) {
        Ok(components) => components,
        Err(error) => {
            warnings.push(format!("no undamped modes to compare with: {error}"));
            Vec::new()
        }
    };
    warnings.extend(undamped.of.warning("the component modes are those"));
    let (mut entries, mut balance) = (Vec::new(), Disagreement::default());
    let (mut idle, mut faint) = (Vec::new(), Vec::new());
    for (number, mode) in &growing {
        let told = diagnosis(&structure.family, &at, mode)?;
        let value = mode.eigenvalue.value;
        balance.add(told.balance);
        match (told.energy.sign(), told.energy.growth_error()) {
            (EnergySign::None, _) => idle.push((named(number + 1, mode), told.energy.error)),
            (_, Some(relative)) if relative > INEXACT => {
                faint.push((named(number + 1, mode), told.energy.share.abs(), relative));
            }
            _ => (),
        }
        let paradoxes = told.influences.iter().filter(|influence| influence.is_paradox());
        warnings.extend(paradoxes.map(|influence| {
            format!(
                "mode {} at {} Hz: the damping {} takes energy out of it, but more of it lets it grow faster (damping paradox)",
                number + 1,
                short(mode.eigenvalue.frequency_hz()),
                influence.name
            )
        }));
        entries.push(Diagnosed {
            matrices: told.influences.iter().map(Fed::new).collect(),
            sum: told.influences.iter().map(|influence| influence.growth).sum(),
            positive_energy: told.energy.sign() == EnergySign::Positive,
            energy: ModeEnergy {
                sign: told.energy.sign().name(),
                share: told.energy.share,
                error: told.energy.error,
                growth_error: told.energy.growth_error(),
            },
            mode: number + 1,
            growth_rate: value.re,
            frequency_hz: mode.eigenvalue.frequency_hz(),
            component_modes: taking_part(&undamped, &components, mode),
            component_modes_of: undamped.of.name(),
            parameters: by_parameters(case, &told, &at)?,
        });
    }
    warnings.extend(of_no_energy(&idle));
    warnings.extend(of_little_energy(&faint));
    let check = CheckRecord::new(
        "the work of all matrices is the growth rate",
        format!(
            "their power against Re λ times the energy, over |λ| and the parts of the energy, of {} unstable modes",
            growing.len()
        ),
        balance,
        BALANCE_LIMIT,
    );
    Ok(Some(GrowingModes { modes: entries, warnings, check }))
}

/// A mode by its number and frequency.
fn named(number: usize, mode: &ComplexMode) -> String {
    format!("{number} at {} Hz", short(mode.eigenvalue.frequency_hz().abs()))
}

/// What has to be said of modes whose energies are zero within their errors.
fn of_no_energy(modes: &[(String, f64)]) -> Option<String> {
    let error = modes.iter().map(|(_, error)| *error).fold(0.0, f64::max);
    let names: Vec<&str> = modes.iter().map(|(name, _)| &**name).collect();
    let (mode, grows, its, it) = match modes.len() {
        0 => return None,
        1 => ("mode", "grows", "its energy is", "it"),
        _ => ("modes", "grow", "their energies are", "them"),
    };
    Some(format!(
        "{mode} {} {grows} without work: {its} zero within {error:.0e} of the parts, no matrix feeds {it}, and sensitivities alone say \
         what would change {it}; so grows what is conservative (divergence, gyroscopic flutter without damping)",
        names.join(", ")
    ))
}

/// What has to be said of modes that have almost no energy, by which their growths are divided: the share of it and the relative error.
fn of_little_energy(modes: &[(String, f64, f64)]) -> Option<String> {
    let share = modes.iter().map(|(_, share, _)| *share).fold(f64::INFINITY, f64::min);
    let relative = modes.iter().map(|(_, _, relative)| *relative).fold(0.0, f64::max);
    let names: Vec<&str> = modes.iter().map(|(name, _, _)| &**name).collect();
    let (mode, has, its) = match modes.len() {
        0 => return None,
        1 => ("mode", "has", "its"),
        _ => ("modes", "have", "their"),
    };
    Some(format!(
        "{mode} {} {has} almost no energy, down to {share:.0e} of {its} parts: what each matrix adds to {its} growth is known to a relative \
         {relative:.0e} alone",
        names.join(", ")
    ))
}

/// The undamped modes up to an angular frequency. Where a stiffness that is no more than symmetric lets the search for real modes
/// fail, the engine of complex modes finds them on the imaginary axis.
fn components(undamped: &Undamped, highest: f64) -> Result<Vec<Mode>, ModelError> {
    /// Half the width of the strip about the axis, over its height.
    const STRIP: f64 = 1e-3;
    let Undamped { mass, stiffness, .. } = undamped;
    match modes(stiffness, mass, WantedModes::Band(0.0, highest / TAU)) {
        Ok(found) => return Ok(found.modes),
        Err(StructureError::MissingModes { .. } | StructureError::IndefiniteStiffness { .. }) => (),
        Err(error) => return Err(error.into()),
    }
    let rows = mass.nrows();
    let none =
        Sparse::try_new_from_triplets(rows, rows, &[]).map_err(|_| StructureError::OutOfMemory { rows })?;
    let problem = Quadratic::new(mass.clone(), none, stiffness.clone())?;
    let strip = Region { re: [-STRIP * highest, STRIP * highest], im: [0.0, highest] };
    let found = complex_modes(&problem, &strip, &complex_mode_settings(stiffness.val().len()))?;
    Ok(found.modes.iter().map(|mode| real(mass, mode)).collect())
}

/// A mode on the imaginary axis as a real one: its vector has its largest entry real, so that all are.
fn real(mass: &Sparse, mode: &ComplexMode) -> Mode {
    let shape: Vec<f64> = mode.right.iter().map(|entry| entry.re).collect();
    let image = product(mass, &shape);
    let length = shape.iter().zip(&image).map(|(a, b)| a * b).sum::<f64>().sqrt();
    Mode {
        eigenvalue: mode.eigenvalue.value.norm_sqr(),
        shape: shape.iter().map(|entry| entry / length).collect(),
        residual: mode.eigenvalue.residual,
    }
}

impl Fed {
    fn new(own: &Influence) -> Self {
        let Influence { part, name, factor, growth, sensitivity, .. } = own;
        Self {
            part: part.name(),
            name: name.clone(),
            factor: *factor,
            growth: *growth,
            sensitivity: *sensitivity,
        }
    }
}

/// The undamped modes with the largest shares.
fn taking_part(undamped: &Undamped, components: &[Mode], mode: &ComplexMode) -> Vec<TakingPart> {
    let mut shares = participations(&undamped.mass, components, mode);
    sort_by_number(&mut shares, |own| -own.share);
    let entry = |own: &judder_structure::diagnosis::Participation| TakingPart {
        mode: own.component + 1,
        frequency_hz: components[own.component].frequency_hz(),
        share: own.share,
        mac: own.assurance,
    };
    shares.iter().take(COMPONENTS).map(entry).collect()
}

/// ∂λ/∂p of every parameter: Σ ∂λ/∂fᵢ dfᵢ/dp, the factors' derivatives by central differences.
fn by_parameters(
    case: &StructureCase,
    told: &Diagnosis,
    at: &Factors,
) -> Result<Vec<MovedModes>, ModelError> {
    let mut entries = Vec::new();
    for (index, parameter) in case.parameters.iter().enumerate() {
        let step = STEP * if parameter.value == 0.0 { 1.0 } else { parameter.value.abs() };
        let moved = |by: f64| {
            let mut values = case.values();
            values[index] += by;
            factors(case, &values)
        };
        // at the edge of where factors have values there is no derivative
        let (Ok(plus), Ok(minus)) = (moved(step), moved(-step)) else { continue };
        let slope = |part: MatrixSum, k: usize| {
            let of = |factors: &Factors| match part {
                MatrixSum::Mass => factors.mass[k],
                MatrixSum::Damping => factors.damping[k],
                MatrixSum::Stiffness => factors.stiffness[k],
            };
            (of(&plus) - of(&minus)) / (2.0 * step)
        };
        let places = [
            (MatrixSum::Mass, at.mass.len()),
            (MatrixSum::Damping, at.damping.len()),
            (MatrixSum::Stiffness, at.stiffness.len()),
        ];
        let slopes = places.into_iter().flat_map(|(part, count)| (0..count).map(move |k| (part, k)));
        let sensitivity = told
            .influences
            .iter()
            .zip(slopes)
            .map(|(influence, (part, k))| influence.sensitivity * slope(part, k))
            .sum();
        entries.push(MovedModes { name: parameter.name.clone(), sensitivity });
    }
    Ok(entries)
}
