//! What `judder check` shows of a structure case.

use super::{Resolved, title};
use crate::error::StudyError;
use crate::structure::Structure;
use crate::text::{columns, short};
use judder_case::structure::analysis::{Compared, Eigen, EigenMethod, WantedModes};
use judder_case::{CaseFile, StructureAnalysis, StructureCase};
use judder_structure::affine::Term;
use serde_json::{Value, json};

/// What is known of a structure before anything is computed.
pub(super) fn resolve(file: &CaseFile, case: &StructureCase) -> Result<Resolved, StudyError> {
    let structure = Structure::new(case).map_err(|unbuilt| unbuilt.placed(file))?;
    let family = &structure.family;
    let mut text = format!("{}\n\nthe structure\n", title(&case.title));
    let mut rows = vec![vec!["degrees of freedom".to_owned(), family.size().to_string()]];
    if let Some(mesh) = structure.mesh() {
        rows.push(vec!["elements".to_owned(), mesh.elements().to_string()]);
        rows.push(vec!["nodes".to_owned(), mesh.nodes.len().to_string()]);
        let sets: Vec<String> =
            mesh.node_sets.iter().map(|(name, nodes)| format!("{name} ({})", nodes.len())).collect();
        rows.push(vec!["sets of nodes".to_owned(), sets.join(", ")]);
    }
    let sums = [("mass", family.mass()), ("damping", family.damping()), ("stiffness", family.stiffness())];
    for (name, terms) in sums {
        let shown: Vec<String> =
            terms.iter().map(|term| format!("{} ({} entries)", term.name, term.matrix.val().len())).collect();
        let shown = if shown.is_empty() { "none".to_owned() } else { shown.join(" + ") };
        rows.push(vec![name.to_owned(), shown]);
    }
    if !structure.kept.is_empty() {
        rows.push(vec!["kept freedoms".to_owned(), structure.kept.len().to_string()]);
    }
    text.push_str(&columns(&rows));
    if !case.parameters.is_empty() {
        text.push_str("\nparameters\n");
        let shown = case.parameters.iter().map(|p| vec![p.name.clone(), crate::text::number(p.value)]);
        text.push_str(&columns(&shown.collect::<Vec<_>>()));
    }
    text.push_str("\nanalyses\n");
    let asked = case.analyses.iter().map(|a| vec![a.name.clone(), asked(&a.kind)]);
    text.push_str(&columns(&asked.collect::<Vec<_>>()));
    for warning in &structure.warnings {
        text.push_str(&format!("\nwarning: {warning}\n"));
    }
    let entries = |terms: &[Term]| -> Value {
        terms.iter().map(|term| json!({ "name": term.name, "entries": term.matrix.val().len() })).collect()
    };
    let document = json!({
        "case": file.case.resolved(),
        "structure": {
            "degrees_of_freedom": family.size(),
            "elements": structure.mesh().map(judder_structure::mesh::Mesh::elements),
            "nodes": structure.mesh().map(|mesh| mesh.nodes.len()),
            "mass": entries(family.mass()), "damping": entries(family.damping()), "stiffness": entries(family.stiffness()),
            "kept_freedoms": structure.kept.len(),
        },
        "warnings": structure.warnings,
    });
    Ok(Resolved { document, text })
}

fn asked(kind: &StructureAnalysis) -> String {
    match kind {
        StructureAnalysis::Modes(settings) => match settings.wanted() {
            WantedModes::Count(count) => format!("the lowest {count} modes"),
            WantedModes::Band(from, to) => {
                let hertz = |angular: f64| short(angular / std::f64::consts::TAU);
                format!("the modes from {} to {} Hz", hertz(from), hertz(to))
            }
        },
        StructureAnalysis::Reduction(Compared { count }) => {
            format!("{count} frequencies, reduced against full")
        }
        StructureAnalysis::Eigen(Eigen { region }) => {
            format!(
                "complex modes, Re from {} to {}, Im from {} to {}",
                region.re[0], region.re[1], region.im[0], region.im[1]
            )
        }
        StructureAnalysis::EigenSweep(sweep) => {
            let values = &sweep.sweep.values;
            let method = match sweep.method {
                EigenMethod::Full => "full".to_owned(),
                EigenMethod::Projected { tolerance } => format!("projected to {tolerance:e}"),
            };
            let curves = sweep.family.as_ref().map_or_else(String::new, |family| {
                format!(" for each of {} values of {}", family.values.len(), family.path)
            });
            format!("complex modes at {} values of {}{curves}, {method}", values.len(), sweep.sweep.path)
        }
    }
}
