//! The reference page of the book: every key and every kind of analysis, from the tables that read them.

use crate::case::analysis::KindEntry;
use crate::case::study_sweep::asked::SweepKeys;
use crate::case::study_sweep::design::POINTS_LIMIT;
use crate::case::study_sweep::quantity_path::ListReduction;
use crate::registry::{ModelKind, Registry};
use judder_keys::declared::Settings;
use judder_keys::reference::{settings, table, without_repetition};
use judder_numerics::sampling::sobol::DIMENSIONS_LIMIT;

/// The page, as Markdown; `within` tells of the sweeps within analyses.
pub fn reference(registry: Registry, within: &str) -> String {
    let mut page = String::from(
        "# Case files\n\n\
         A case is a TOML file. A plain number is the paper's dimensionless group, a string carries a unit (`\"30 mm/s\"`, `\"0.2 N\"`, `\"1 MPa\"`, \
         `\"30 deg\"`). Keys left out take the values below; the keys of a table, as `sweep.from`, stand where it comes first. `judder schema` prints the JSON Schema, `judder new` a commented case. \
         A case is a file of at most 1 MiB.\n\n",
    );
    for model in registry.models() {
        page += &section(model);
    }
    page + "\n" + within + &sweeps()
}

/// The section on sweeps of the whole case.
fn sweeps() -> String {
    let reductions = ListReduction::ALL.map(|(name, _)| format!("`{name}`")).join(", ");
    include_str!("reference/sweeps.md")
        .replace("{keys}", table(&SweepKeys::declarations()).trim_end())
        .replace("{dimensions}", &DIMENSIONS_LIMIT.to_string())
        .replace("{points}", &format!("{POINTS_LIMIT:e}"))
        .replace("{reductions}", &reductions)
}

/// The section on a model: its prose, in which `{keys}` stands for what its cases say and `{analyses}` for its kinds.
fn section(model: &ModelKind) -> String {
    let (keys, kinds) = (table(&(model.declared)()), kinds(&(model.kinds)()));
    model.prose.replace("{keys}", keys.trim_end()).replace("{analyses}", kinds.trim_end())
}

/// The kinds of a model, and their keys.
fn kinds(kinds: &[KindEntry]) -> String {
    let mut list =
        String::from("| kind | keys beside `name` and `kind` | what it computes |\n| --- | --- | --- |\n");
    for kind in kinds {
        let KindEntry { name, doc, declared, .. } = kind;
        let keys: Vec<String> = declared().iter().map(|key| format!("`{}`", key.name)).collect();
        list += &format!("| `{name}` | {} | {doc} |\n", keys.join(", "));
    }
    let declared = kinds.iter().map(|kind| settings(kind.name, &(kind.declared)()));
    without_repetition(&declared.fold(list, |page, own| page + &own))
}
