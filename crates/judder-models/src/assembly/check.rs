//! What `judder check` shows of an assembly case.

use super::AssemblySubject;
use super::build::{BuiltAssembly, BuiltBody, extent};
use super::quickly_found::QuicklyFound;
use crate::assembly::case::AssemblyCase;
use crate::assembly::case::joint::{SpringSettings, Tie};
use crate::error::ModelError;
use crate::estimate::{title, words_json, words_text};
use crate::structure::build::symmetric_part;
use crate::structure::undamped::MOST_OPERATIONS;
use judder_structure::StructureError;
use judder_structure::definiteness::Definiteness;
use judder_structure::modes::{WantedModes, modes};
use judder_study::case::text::CaseText;
use judder_study::model::{Analyses, estimates};
use judder_study::resolve::Resolved;
use judder_study::text::{columns, short};
use serde_json::{Value, json};

/// What is known of an assembly before anything is computed: mass, size and first frequency of every body, the points of every contact.
pub(super) fn resolve(file: &CaseText, case: &AssemblyCase, resolved: Value) -> Result<Resolved, ModelError> {
    let most = case.analyses.iter().filter_map(|own| own.kind.most_freedoms()).min();
    let built = BuiltAssembly::with_at_most(case, most).map_err(|unassembled| unassembled.placed(file))?;
    let bodies = built.bodies.iter().map(KnownBody::new).collect::<Result<Vec<_>, _>>()?;
    let mut text = format!("{}\n\nbodies\n", title(&case.title));
    let heads = ["", "freedoms", "mass (kg)", "size (m)", "first frequency (Hz)", "sets of nodes"];
    let mut rows = vec![heads.map(str::to_owned).to_vec()];
    rows.extend(bodies.iter().map(KnownBody::row));
    text.push_str(&columns(&rows));
    if !case.contacts.is_empty() {
        text.push_str("\ncontacts\n");
    }
    let contacts = built.assembly.interfaces.iter().zip(&built.spheres).map(|(interface, sphere)| {
        let (low, high) =
            interface.points.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), point| {
                (low.min(point.gap), high.max(point.gap))
            });
        let gaps = format!("gaps from {} to {} m", short(low), short(high));
        let sphere = sphere.as_deref().zip(interface.points.first()).map(|(sphere, point)| {
            let (velocity, load) = (sphere.velocity(point.slip_speed()), sphere.normal_load());
            format!("a sphere, v τ/R = {}, F_n = {} N", short(velocity), short(load))
        });
        let points = format!("{} points", interface.points.len());
        [Some(interface.name.clone()), Some(points), Some(gaps), sphere].into_iter().flatten().collect()
    });
    text.push_str(&columns(&contacts.collect::<Vec<_>>()));
    text.push_str(&joints(case));
    text.push_str("\nanalyses\n");
    let names = case.analysis_names();
    let estimates = estimates(case, file, |name| AssemblySubject { case, built: &built, name })?;
    text.push_str(&words_text(&names, &estimates));
    let doubt = match built.quickly_found() {
        // along keys that change the bodies, and of marches on tracks at rest, it may be otherwise
        QuicklyFound::Refused(reason) | QuicklyFound::Doubt(reason) => Some(reason),
        QuicklyFound::Nothing => None,
    };
    let masses = built.bodies.iter().map(indefinite_mass).collect::<Result<Vec<_>, _>>()?;
    let warnings: Vec<String> =
        built.warnings.iter().chain(doubt).cloned().chain(masses.into_iter().flatten()).collect();
    for warning in &warnings {
        text.push_str(&format!("\nwarning: {warning}\n"));
    }
    let contacts: Vec<Value> = built
        .assembly
        .interfaces
        .iter()
        .map(|interface| json!({ "name": interface.name, "points": interface.points.len() }))
        .collect();
    let document = json!({
        "case": resolved,
        "bodies": bodies.iter().map(KnownBody::json).collect::<Vec<_>>(),
        "contacts": contacts,
        "estimate": words_json(&names, &estimates),
        "warnings": warnings,
    });
    Ok(Resolved { document, text })
}

/// What has to be known of the mass of a body that was not assembled here.
fn indefinite_mass(body: &BuiltBody) -> Result<Option<String>, ModelError> {
    if body.structure.elements.is_some() {
        return Ok(None);
    }
    let found = Definiteness::of(&body.matrices.mass, MOST_OPERATIONS)?;
    let negative = found.map_or(0, |own| own.negative);
    let told = || {
        let (name, size) = (&body.name, body.size());
        format!(
            "the mass of `{name}` is indefinite, negative in {negative} of its {size} eigenvalues: it has no undamped modes, and what begins with them is refused"
        )
    };
    Ok((negative > 0).then(told))
}

/// What joins the bodies beside contacts.
fn joints(case: &AssemblyCase) -> String {
    let mut text = String::new();
    if !case.springs.is_empty() {
        let row = |own: &SpringSettings| {
            let [stiffness, damping] = [own.stiffness, own.damping].map(short);
            let ends = format!("{} to {}", own.from.words(), own.to.words());
            vec![own.name.to_string(), ends, format!("{stiffness} N/m"), format!("{damping} N s/m")]
        };
        text.push_str("\nsprings\n");
        text.push_str(&columns(&case.springs.iter().map(row).collect::<Vec<_>>()));
    }
    if !case.ties.is_empty() {
        let row =
            |own: &Tie| vec![own.name.to_string(), format!("{} on {}", own.from.words(), own.to.words())];
        text.push_str("\nties\n");
        text.push_str(&columns(&case.ties.iter().map(row).collect::<Vec<_>>()));
    }
    text
}

/// What tells whether a body is meant as it is.
struct KnownBody {
    name: String,
    freedoms: usize,
    mass: Option<f64>,
    size: Option<f64>,
    first_frequency_hz: Option<f64>,
    sets: String,
}

impl KnownBody {
    fn new(body: &BuiltBody) -> Result<Self, ModelError> {
        let (stiffness, departure) = symmetric_part(&body.matrices.stiffness)?;
        // a mass without springs of its own has no frequency, one with circulation no real one
        let has_modes = departure == 0.0 && stiffness.val().iter().any(|entry| *entry != 0.0);
        let found = match has_modes {
            true => match modes(&stiffness, &body.matrices.mass, WantedModes::Lowest(7)) {
                Ok(found) => Some(found),
                // a body that turns has been softened below zero, or the stiffness pushes; imported masses are told of apart
                Err(
                    StructureError::MissingModes { .. }
                    | StructureError::NotPositive { .. }
                    | StructureError::IndefiniteStiffness { .. }
                    | StructureError::IndefiniteMass { .. },
                ) => None,
                Err(error) => return Err(error.into()),
            },
            false => None,
        };
        let elastic = found.and_then(|found| {
            let limit = found.rigid_limit;
            found.modes.into_iter().find(|mode| mode.eigenvalue > limit)
        });
        let mesh = body.structure.mesh();
        let of_layout = body.structure.layout.as_ref().map(|layout| &layout.sets);
        let sets = mesh.map(|mesh| &mesh.node_sets).or(of_layout).into_iter().flatten();
        let sets =
            sets.map(|(name, nodes)| format!("{name} ({})", nodes.len())).collect::<Vec<_>>().join(", ");
        Ok(Self {
            name: body.name.clone(),
            freedoms: body.size(),
            mass: body.whole_mass()?,
            size: mesh.map(extent),
            first_frequency_hz: elastic.as_ref().map(judder_structure::modes::Mode::frequency_hz),
            sets,
        })
    }

    fn row(&self) -> Vec<String> {
        let number = |value: Option<f64>| value.map_or_else(|| "unknown".to_owned(), short);
        vec![
            self.name.clone(),
            self.freedoms.to_string(),
            number(self.mass),
            number(self.size),
            number(self.first_frequency_hz),
            self.sets.clone(),
        ]
    }

    fn json(&self) -> Value {
        json!({
            "name": self.name,
            "freedoms": self.freedoms,
            "mass_kg": self.mass,
            "size_m": self.size,
            "first_frequency_hz": self.first_frequency_hz,
        })
    }
}
