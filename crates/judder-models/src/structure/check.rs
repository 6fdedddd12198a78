//! What `judder check` shows of a structure case.

use super::StructureSubject;
use crate::error::ModelError;
use crate::estimate::{title, words_json, words_text};
use crate::structure::build::Structure;
use crate::structure::case::{StructureCase, StructureSource};
use crate::structure::undamped::{MOST_OPERATIONS, Undamped};
use judder_structure::affine::Term;
use judder_structure::definiteness::Definiteness;
use judder_study::case::text::CaseText;
use judder_study::model::{Analyses, estimates};
use judder_study::resolve::Resolved;
use judder_study::text::columns;
use serde_json::{Value, json};

/// What is known of a structure before anything is computed.
pub(super) fn resolve(
    file: &CaseText,
    case: &StructureCase,
    resolved: Value,
) -> Result<Resolved, ModelError> {
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
        let shown = case.parameters.iter().map(|p| vec![p.name.clone(), judder_study::text::number(p.value)]);
        text.push_str(&columns(&shown.collect::<Vec<_>>()));
    }
    text.push_str("\nanalyses\n");
    let names = case.analysis_names();
    let estimates = estimates(case, file, |name| StructureSubject { case, structure: &structure, name })?;
    text.push_str(&words_text(&names, &estimates));
    let warnings: Vec<String> =
        structure.warnings.iter().cloned().chain(of_matrices(case, &structure)?).collect();
    for warning in &warnings {
        text.push_str(&format!("\nwarning: {warning}\n"));
    }
    let entries = |terms: &[Term]| -> Value {
        terms.iter().map(|term| json!({ "name": term.name, "entries": term.matrix.val().len() })).collect()
    };
    let document = json!({
        "case": resolved,
        "structure": {
            "degrees_of_freedom": family.size(),
            "elements": structure.mesh().map(judder_structure::mesh::Mesh::elements),
            "nodes": structure.mesh().map(|mesh| mesh.nodes.len()),
            "mass": entries(family.mass()), "damping": entries(family.damping()), "stiffness": entries(family.stiffness()),
            "kept_freedoms": structure.kept.len(),
        },
        "estimate": words_json(&names, &estimates),
        "warnings": warnings,
    });
    Ok(Resolved { document, text })
}

/// What has to be known of mass and stiffness that were not assembled here: of elements both are positive, or show their rigid motions.
fn of_matrices(case: &StructureCase, structure: &Structure) -> Result<Vec<String>, ModelError> {
    if !matches!(case.source, StructureSource::Matrices(_)) {
        return Ok(Vec::new());
    }
    let Undamped { mass, stiffness, .. } = Undamped::new(case, structure)?;
    let of_mass = Definiteness::of(&mass, MOST_OPERATIONS)?.map(|own| {
        warnings(
            own,
            "mass",
            "there are no undamped modes",
            "there are so many modes less, and eigenvalues at infinity",
        )
    });
    let of_stiffness = Definiteness::of(&stiffness, MOST_OPERATIONS)?.map(|own| {
        warnings(
            own,
            "stiffness",
            "so many motions grow without friction and damping",
            "so many motions are rigid, or mechanisms",
        )
    });
    Ok(of_mass.into_iter().chain(of_stiffness).flatten().collect())
}

/// What has to be known of a matrix of this name in words.
fn warnings(of: Definiteness, name: &str, of_negative: &str, of_zero: &str) -> Vec<String> {
    let Definiteness { negative, zero, size } = of;
    let told = |count: usize, are: &str, what: &str| {
        (count > 0).then(|| format!("the {name} is {are} of its {size} eigenvalues: {what}"))
    };
    let indefinite = told(negative, &format!("indefinite, negative in {negative}"), of_negative);
    let singular = told(zero, &format!("singular, zero to rounding in {zero}"), of_zero);
    indefinite.into_iter().chain(singular).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_not_positive_is_told_in_words() {
        let words = warnings(Definiteness { negative: 1, zero: 1, size: 3 }, "mass", "so", "thus");
        assert_eq!(words[0], "the mass is indefinite, negative in 1 of its 3 eigenvalues: so");
        assert_eq!(words[1], "the mass is singular, zero to rounding in 1 of its 3 eigenvalues: thus");
        assert_eq!(warnings(Definiteness { negative: 0, zero: 0, size: 3 }, "mass", "so", "thus"), [""; 0]);
    }
}
