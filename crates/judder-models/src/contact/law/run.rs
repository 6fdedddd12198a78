//! `contact-law`: force, area and friction over speed and indentation, as a law that an oscillator uses.

use crate::computed_law::{ComputedLaw, KnownPoints, LawTask, compute, ending, meets};
use crate::contact::case::ContactCase;
use crate::contact::memory::operator_limit;
use crate::contact::settings::{LawMethod, LawSettings};
use crate::error::ModelError;
use crate::indenter;
use crate::material::ContactScales;
use judder_contact::fit::{FitError, FitSample, LawFit, Weighting, fit_law};
use judder_contact::law::file::to_json;
use judder_contact::law::sweep::SolvedLawPoint;
use judder_contact::law::{LawErrors, PerQuantity};
use judder_contact::steady::{GridChoice, SteadyError, SteadyQuestion, solve};
use judder_contact::unilateral::{Loading, UnilateralLimits};
use judder_contact::{ContactLaw, Law, LawPoint};
use judder_keys::numeric_key::Form;
use judder_keys::span::Span;
use judder_store::{Dataset, Results, Table, Variable};
use judder_study::Progress;
use judder_study::outcome::{CheckRecord, Disagreement, Outcome};

/// What friction from the bulk may differ by from friction at the surface.
const DISSIPATION_LIMIT: f64 = 1e-2;
/// Places on the plane, as shares of both ranges, at which a contact is solved anew.
const PROBES: [(f64, f64); 3] = [(0.31, 0.17), (0.53, 0.61), (0.74, 0.89)];

/// A law over the plane of the settings.
pub struct LawPlane {
    pub(crate) velocities: Vec<f64>,
    pub(crate) indentations: Vec<f64>,
}

impl LawPlane {
    /// The points of the settings, as v̂ and ŷ.
    pub fn new(settings: &LawSettings, scales: &ContactScales) -> Self {
        let groups = |span: &Span, unit: f64| -> Vec<f64> {
            let unit = if span.form == Form::Group { 1.0 } else { unit };
            span.values().into_iter().map(|value| value * unit).collect()
        };
        Self {
            velocities: groups(&settings.velocity, scales.time / scales.scales.radius),
            indentations: groups(&settings.indentation, 1.0 / scales.scales.radius),
        }
    }

    fn ends(values: &[f64]) -> (f64, f64) {
        (values.first().copied().unwrap_or(f64::NAN), values.last().copied().unwrap_or(f64::NAN))
    }

    /// The law that these settings ask for.
    pub(crate) fn task<'a>(
        &self,
        case: &ContactCase,
        scales: &'a ContactScales,
        settings: &LawSettings,
    ) -> Result<LawTask<'a>, ModelError> {
        Ok(LawTask {
            material: &scales.material,
            indenter: indenter::of_law(case, scales.scales.radius)?,
            method: settings.method,
            velocity: Self::ends(&self.velocities),
            indentation: Self::ends(&self.indentations),
            accuracy: settings.accuracy,
            memory: operator_limit(settings.memory),
        })
    }

    /// A quantity of the law on the plane, row by row of equal indentation.
    pub(crate) fn values(&self, law: &Law) -> PerQuantity<Vec<f64>> {
        let samples = self.samples(law);
        let of = |pick: fn(&PerQuantity<f64>) -> f64| samples.iter().map(|s| pick(&s.values)).collect();
        PerQuantity { force: of(|q| q.force), area: of(|q| q.area), friction: of(|q| q.friction) }
    }

    /// The law at every point of the plane, row by row of equal indentation: what is fitted, shown and judged.
    pub fn samples(&self, law: &Law) -> Vec<FitSample> {
        let at = |velocity: f64, indentation: f64| {
            let found = law.evaluate(&LawPoint::new(velocity, indentation));
            let (force, area, friction) = (found.force.value, found.area.value, found.friction.value);
            FitSample { velocity, indentation, values: PerQuantity { force, area, friction } }
        };
        let row = |depth: &f64| self.velocities.iter().map(|v| at(*v, *depth)).collect::<Vec<_>>();
        self.indentations.iter().flat_map(row).collect()
    }

    /// The functions of appendix B through a law on the plane, read at 10^`log10_velocity_scale` v̂; with the errors of as many samples
    /// as the law has contacts, because it is interpolated between them.
    ///
    /// # Errors
    /// As [`fit_law`].
    pub fn fit(&self, law: &Law, log10_velocity_scale: f64) -> Result<LawFit, FitError> {
        let samples = self.samples(law);
        let contacts = law.data().map_or(samples.len(), |data| data.values().force.len());
        fit_law(&samples, log10_velocity_scale, Weighting::Absolute)?.of_independent(contacts)
    }

    /// The coordinates of arrays on the plane.
    pub(crate) fn coordinates(&self) -> Result<Dataset, ModelError> {
        let coordinate = |name: &str, values: &[f64], long_name: &str, label: &str| {
            Variable::coordinate(name, values.to_vec())
                .units("1")
                .long_name(long_name)
                .attribute("label", label)
                .attribute("scale", "log")
        };
        Ok(Dataset::new()
            .with(coordinate("velocity", &self.velocities, "speed v τ/R", "Speed $v τ$/$R$ (−)"))?
            .with(coordinate(
                "indentation",
                &self.indentations,
                "indentation δ/R",
                "Indentation $δ$/$R$ (−)",
            ))?)
    }
}

pub(super) fn run(
    case: &ContactCase,
    name: &str,
    settings: &LawSettings,
    points: KnownPoints<'_>,
    progress: &dyn Progress,
) -> Result<Outcome, ModelError> {
    let scales = ContactScales::new(case)?;
    let plane = LawPlane::new(settings, &scales);
    let task = plane.task(case, &scales, settings)?;
    let computed = compute(&task, points, progress)?;
    let errors = computed.errors();
    let file = format!("{name}.json");
    let mut outcome = Outcome {
        scalars: told(&computed, &errors, settings.accuracy, &scales, &file).scalars(),
        dataset: dataset(&plane, &computed, &scales)?,
        table: Some(table(&plane, &computed.law)?),
        checks: checks(&plane, &task, &computed.law, &errors)?,
        ..Outcome::default()
    };
    if let Some(text) = to_json(&computed.law)? {
        outcome.files.push((file, text.into_bytes()));
    }
    let missed = computed.missed(settings.accuracy);
    outcome.missing = usize::from(missed.is_some());
    outcome.warnings.extend(missed);
    Ok(outcome)
}

/// What is told of a law.
#[derive(Results)]
pub(super) struct ToldLaw {
    law_file: String,
    method: &'static str,
    contacts_solved: usize,
    /// why no more contacts were solved
    ending: &'static str,
    converged: bool,
    /// E∞/E0
    #[result(unit = "1")]
    contrast: f64,
    mean_retardation_time_second: f64,
    interpolation_error: RelativeErrors,
    solver_error: RelativeErrors,
    levels: Vec<ToldLevel>,
}

/// The errors of a law, relative.
#[derive(Results)]
struct RelativeErrors {
    #[result(unit = "1")]
    force: f64,
    #[result(unit = "1")]
    area: f64,
    #[result(unit = "1")]
    friction: f64,
}

/// The knots of a law, and how far those without every second one are off.
#[derive(Results)]
struct ToldLevel {
    columns: usize,
    rows: usize,
    along_speed: RelativeErrors,
    along_indentation: RelativeErrors,
}

impl RelativeErrors {
    fn new(PerQuantity { force, area, friction }: PerQuantity<f64>) -> Self {
        Self { force, area, friction }
    }
}

fn told(
    computed: &ComputedLaw,
    errors: &LawErrors,
    accuracy: f64,
    scales: &ContactScales,
    file: &str,
) -> ToldLaw {
    let method = match computed.law {
        Law::Collapsed(_) => LawMethod::Collapse,
        _ => LawMethod::Sweep,
    };
    let levels = computed.levels.iter().map(|level| ToldLevel {
        columns: level.columns,
        rows: level.rows,
        along_speed: RelativeErrors::new(level.along_speed),
        along_indentation: RelativeErrors::new(level.along_indentation),
    });
    ToldLaw {
        law_file: file.to_owned(),
        method: method.name(),
        contacts_solved: computed.points.len(),
        ending: ending(computed.end),
        converged: meets(errors, accuracy),
        contrast: scales.material.spectrum.contrast(),
        mean_retardation_time_second: scales.time,
        interpolation_error: RelativeErrors::new(errors.interpolation),
        solver_error: RelativeErrors::new(errors.solver),
        levels: levels.collect(),
    }
}

/// The law on the plane of the settings, and the contacts that it was made from.
fn dataset(plane: &LawPlane, computed: &ComputedLaw, scales: &ContactScales) -> Result<Dataset, ModelError> {
    let shape = [plane.indentations.len(), plane.velocities.len()];
    let values = plane.values(&computed.law);
    let over_plane = |name: &str, values: Vec<f64>, long_name: &str| {
        Variable::new(name, &["indentation", "velocity"], &shape, values).units("1").long_name(long_name)
    };
    let points = &computed.points;
    let sample = |name: &str, value: fn(&SolvedLawPoint) -> f64, long_name: &str| {
        let values: Vec<f64> = points.iter().map(value).collect();
        Variable::new(name, &["sample"], &[values.len()], values).units("1").long_name(long_name)
    };
    let is_line = computed.law.data().is_some_and(|data| data.origin().indenter.is_line());
    let (force, area) = if is_line {
        ("normal force per length F/(E0* R)", "width of the contact w/R")
    } else {
        ("normal force F/(E0* R²)", "contact area A/R²")
    };
    let mut coordinates = plane.coordinates()?;
    if is_line {
        // what Hertz's closed forms are of others
        let at_rest =
            plane.indentations.iter().map(|depth| computed.law.evaluate(&LawPoint::new(0.0, *depth)));
        let (forces, widths) = at_rest.map(|found| (found.force.value, found.area.value)).unzip();
        let over_depth = |name: &str, values: Vec<f64>, long_name: &str| {
            let depths = [plane.indentations.len()];
            Variable::new(name, &["indentation"], &depths, values).units("1").long_name(long_name)
        };
        coordinates = coordinates
            .with(over_depth("rest_force", forces, "elastic force per length F/(E0* R) with E0"))?
            .with(over_depth("rest_area", widths, "elastic width w/R"))?;
    }
    Ok(coordinates
        .with(over_plane("force", values.force, force))?
        .with(over_plane("area", values.area, area))?
        .with(over_plane("friction", values.friction, "viscoelastic friction coefficient"))?
        .with(sample("sample_velocity", |p| p.velocity, "v τ/R of a solved contact"))?
        .with(sample("sample_indentation", |p| p.indentation, "δ/R of a solved contact"))?
        .with(sample("sample_force", |p| p.sample.force, "F/(E0* R²) of a solved contact"))?
        .with(sample("sample_area", |p| p.sample.area, "A/R² of a solved contact"))?
        .with(sample("sample_friction", |p| p.sample.friction, "friction of a solved contact"))?
        .with(sample("sample_force_error", |p| p.sample.force_error, "its relative error of the force"))?
        .attribute("contrast", scales.material.spectrum.contrast())?)
}

/// One row a point of the plane.
fn table(plane: &LawPlane, law: &Law) -> Result<Table, ModelError> {
    let columns = plane.velocities.len();
    let velocity: Vec<f64> = plane.indentations.iter().flat_map(|_| plane.velocities.clone()).collect();
    let indentation: Vec<f64> =
        plane.indentations.iter().flat_map(|depth| std::iter::repeat_n(*depth, columns)).collect();
    let values = plane.values(law);
    let is_line = law.data().is_some_and(|data| data.origin().indenter.is_line());
    let (force_unit, area_unit) = if is_line { ("E0* R", "R") } else { ("E0* R²", "R²") };
    Ok(Table::new()
        .column("velocity", "v τ/R", velocity)?
        .column("indentation", "R", indentation)?
        .column("force", force_unit, values.force)?
        .column("area", area_unit, values.area)?
        .column("friction", "1", values.friction)?)
}

/// Contacts solved anew between the knots, and friction from two sides.
fn checks(
    plane: &LawPlane,
    task: &LawTask<'_>,
    law: &Law,
    errors: &LawErrors,
) -> Result<Vec<CheckRecord>, ModelError> {
    let between = |values: &[f64], share: f64| {
        let (first, last) = LawPlane::ends(values);
        libm::exp(libm::log(first) + share * (libm::log(last) - libm::log(first)))
    };
    let stated = errors.total();
    let (mut off, mut difference) = (Disagreement::default(), Disagreement::default());
    for (along, down) in PROBES {
        let (velocity, depth) = (between(&plane.velocities, along), between(&plane.indentations, down));
        let contact = solve(&SteadyQuestion {
            substrate: &task
                .indenter
                .substrate(&task.material.of_law(), velocity)
                .map_err(SteadyError::from)?,
            profile: task.indenter.profile(),
            loading: Loading::Indentation(depth),
            accuracy: 0.5 * task.accuracy,
            grid: GridChoice::Automatic,
            limits: UnilateralLimits::default(),
            memory: task.memory,
        })?;
        let (found, law) = (&contact.refinement, law.evaluate(&LawPoint::new(velocity, depth)));
        for (law, found, stated) in [
            (law.force.value, found.force, stated.force),
            (law.area.value, found.area, stated.area),
            (law.friction.value, found.friction, stated.friction),
        ] {
            // an elastic substrate has no friction to be off from
            if law != 0.0 || found.value != 0.0 {
                off.add((law / found.value - 1.0).abs() / (stated + found.error));
            }
        }
        if contact.friction_from_dissipation != 0.0 {
            difference.add(contact.friction_difference());
        }
    }
    let mut checks = vec![CheckRecord::new(
        "the law gives contacts that it was not made from",
        format!(
            "force, area and friction of {} contacts solved anew: each deviation over the errors that law and contact state",
            PROBES.len()
        ),
        off,
        1.0,
    )];
    if difference.numbers() > 0 {
        checks.push(CheckRecord::new(
            "friction at the surface is the energy dissipated in the bulk",
            format!("∫ p ∂h/∂x against the loss in Fourier space, {} contacts", difference.numbers()),
            difference,
            DISSIPATION_LIMIT,
        ));
    }
    Ok(checks)
}
