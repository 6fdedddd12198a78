//! `contact`: one contact, with its fields, the grids it comes from, and friction from two sides.

use super::refined::Refined;
use crate::contact::case::ContactCase;
use crate::contact::fields::ContactFields;
use crate::contact::memory::{operator_at_once, operator_limit};
use crate::contact::settings::{ContactSettings, LoadingSettings};
use crate::contact::shape::ShapeSettings;
use crate::error::ModelError;
use crate::indenter::profile;
use crate::material::ContactScales;
use judder_contact::cylinder_on_layer::CylinderOnLayer;
use judder_contact::kernel::layer::BondedLayer;
use judder_contact::kernel::substrate::SlidingSubstrate;
use judder_contact::steady::{GridChoice, SteadyContact, SteadyError, SteadyQuestion, solve_until};
use judder_contact::unilateral::{Loading, UnilateralLimits};
use judder_store::Results;
use judder_study::Progress;
use judder_study::outcome::{CheckRecord, Outcome};

/// Cells a side where a domain is given and cells are not.
pub(crate) const CELLS_OF_A_GIVEN_DOMAIN: usize = 256;
/// What friction from the bulk may differ by from friction at the surface.
pub(crate) const DISSIPATION_LIMIT: f64 = 1e-2;
/// What pressure and gap may leave of each other, computed anew.
pub(crate) const RESIDUAL_LIMIT: f64 = 1e-5;
/// Below this v τ/√(R δ) the friction of slow sliding is as good as exact.
const SLOW: f64 = 1e-4;

/// The grid that the settings ask for.
pub(crate) fn grid(settings: &ContactSettings, scales: &ContactScales) -> GridChoice {
    match (settings.cells(), settings.domain) {
        (None, None) => GridChoice::Automatic,
        (Some(cells), None) => GridChoice::Cells(cells),
        (cells, Some(domain)) => GridChoice::Fixed {
            cells: cells.unwrap_or(CELLS_OF_A_GIVEN_DOMAIN),
            half_width: 0.5 * scales.length(domain),
            centre: [0.0, 0.0],
        },
    }
}

/// What presses the indenter down, in groups; of a cylinder per length.
pub(crate) fn loading(shape: &ShapeSettings, settings: &ContactSettings, scales: &ContactScales) -> Loading {
    pressed(shape, settings.loading(), scales)
}

/// What presses an indenter down, in groups; a cylinder per length.
pub(crate) fn pressed(shape: &ShapeSettings, loading: LoadingSettings, scales: &ContactScales) -> Loading {
    match loading {
        LoadingSettings::Indentation(depth) => Loading::Indentation(scales.length(depth)),
        LoadingSettings::Load(force) if *shape == ShapeSettings::Cylinder => {
            Loading::Load(scales.line_force(force))
        }
        LoadingSettings::Load(force) => Loading::Load(scales.force(force)),
    }
}

pub(crate) fn run(
    case: &ContactCase,
    name: &str,
    settings: &ContactSettings,
    progress: &dyn Progress,
) -> Result<Outcome, ModelError> {
    let scales = ContactScales::new(case)?;
    let velocity = scales.velocity(settings.velocity);
    let layer = case.layer(scales.scales.radius)?;
    let sliding = scales.material.sliding(velocity);
    let substrate = SlidingSubstrate { layer: layer.clone(), ..sliding };
    let profile = profile(&case.shape, scales.scales.radius)?;
    let question = SteadyQuestion {
        substrate: &substrate,
        profile: &*profile,
        loading: loading(&case.shape, settings, &scales),
        accuracy: settings.accuracy,
        grid: grid(settings, &scales),
        limits: UnilateralLimits::default(),
        memory: operator_at_once(operator_limit(settings.memory), 1),
    };
    let contact = solve_until(&question, &|| progress.interrupted()).map_err(|error| match error {
        SteadyError::Interrupted => ModelError::Interrupted,
        error => error.into(),
    })?;
    progress.advance();
    let fields = ContactFields::new(&contact.finest, &*profile);
    let refined = Refined {
        refinement: &contact.refinement,
        friction_from_dissipation: contact.friction_from_dissipation,
        friction_difference: contact.friction_difference(),
        converged: contact.converged,
        is_line: profile.is_line(),
        length: case.length,
    };
    Ok(Outcome {
        scalars: refined.told(&scales, velocity).scalars(),
        dataset: fields.dataset(&contact.refinement, &scales, settings.is_in_si())?,
        table: Some(refined.history()?),
        checks: checks(case, &contact, &question, velocity, scales.material.spectrum.contrast())?,
        files: vec![(format!("fields/{name}.vtu"), fields.vtu()?)],
        missing: usize::from(!contact.converged),
        warnings: refined
            .missed(settings.accuracy)
            .into_iter()
            .chain(deep(&contact, layer.as_ref()))
            .collect(),
        ..Outcome::default()
    })
}

/// Beyond this part of its thickness a layer is no longer linear: strains are of its order.
pub(crate) const DEEP_IN_A_LAYER: f64 = 0.1;

/// That a cylinder is pressed in by a large part of its layer, in words.
fn deep(contact: &SteadyContact, layer: Option<&BondedLayer>) -> Option<String> {
    let part = contact.refinement.indentation.value / layer?.thickness();
    (part > DEEP_IN_A_LAYER).then(|| {
        format!("the indentation is {part:.2} of the thickness of the layer: strains are of that order, and the theory is one of small ones")
    })
}

fn checks(
    case: &ContactCase,
    contact: &SteadyContact,
    question: &SteadyQuestion<'_>,
    velocity: f64,
    contrast: f64,
) -> Result<Vec<CheckRecord>, ModelError> {
    let errors = &contact.finest.solution.errors;
    let grid = contact.finest.grid;
    let size = format!("{} × {} cells", grid.columns, grid.rows);
    let mut checks = vec![
        CheckRecord::new(
            "pressure and gap exclude each other",
            format!("the smaller of p/p_max and |g|/δ, computed anew on {size}"),
            errors.complementarity.into(),
            RESIDUAL_LIMIT,
        ),
        CheckRecord::new(
            "nothing pulls and nothing penetrates",
            format!("most negative pressure over the largest, penetration over the depth, {size}"),
            [errors.largest_penetration, -errors.smallest_pressure].into_iter().collect(),
            RESIDUAL_LIMIT,
        ),
    ];
    if errors.load > 0.0 || matches!(question.loading, Loading::Load(_)) {
        let compared = "the sum of the pressures against the imposed force";
        checks.push(CheckRecord::new("the load is carried", compared, errors.load.into(), RESIDUAL_LIMIT));
    }
    if !question.substrate.terms.is_empty() && velocity > 0.0 {
        checks.push(CheckRecord::new(
            "friction at the surface is the energy dissipated in the bulk",
            "∫ p ∂h/∂x against the loss in Fourier space, relative",
            contact.friction_difference().into(),
            DISSIPATION_LIMIT,
        ));
    }
    checks.extend(limits(case, contact, question, velocity, contrast)?);
    Ok(checks)
}

/// The closed forms between and at which a paraboloid must lie, and a cylinder on a layer.
fn limits(
    case: &ContactCase,
    contact: &SteadyContact,
    question: &SteadyQuestion<'_>,
    velocity: f64,
    contrast: f64,
) -> Result<Vec<CheckRecord>, ModelError> {
    let mut checks = Vec::new();
    let r = &contact.refinement;
    let (rubbery, name, compared) = match (&case.shape, &question.substrate.layer) {
        (ShapeSettings::Paraboloid, _) => (
            4.0 / 3.0 * libm::pow(r.indentation.value, 1.5),
            "the force lies between Hertz with E0 and with E∞",
            "how far beyond the nearer of 4/3 δ^{3/2} and 4/3 (E∞/E0) δ^{3/2}, relative",
        ),
        (ShapeSettings::Cylinder, Some(layer)) => (
            CylinderOnLayer::of_indentation(layer, r.indentation.value)?.force,
            "the force lies between the elastic ones with E0 and with E∞",
            "how far beyond the nearer of the spectral solutions on a layer of E0 and of E∞, relative",
        ),
        _ => return Ok(checks),
    };
    let glassy = contrast * rubbery;
    let outside = (rubbery / r.force.value).max(r.force.value / glassy) - 1.0;
    checks.push(CheckRecord::new(name, compared, outside.into(), question.accuracy));
    let slow = velocity / r.indentation.value.sqrt();
    let moment: f64 = question.substrate.terms.iter().map(|term| term.compliance * term.length).sum();
    let longest = question.substrate.terms.iter().map(|term| term.length).fold(0.0, f64::max);
    if moment > 0.0 && slow.max(longest / r.indentation.value.sqrt()) < SLOW {
        checks.push(CheckRecord::new(
            "slow sliding has the friction of the closed form",
            "μ against Σ C_k E0 v τ_k/R, relative",
            (r.friction.value / moment - 1.0).abs().into(),
            // friction may be five times as far off as the force
            (5.0 * question.accuracy).max(1e-2),
        ));
    }
    Ok(checks)
}
