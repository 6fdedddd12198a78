//! The reference page of the book: every key and every kind of analysis, from the tables that read them.

mod sweep;

use crate::case::analysis::Kind;
use crate::registry::Registry;
use judder_keys::declared::Declaration;
use judder_keys::reference::{settings, table, without_repetition};

/// The page, as Markdown.
pub fn reference(registry: Registry) -> String {
    let mut page = String::from(
        "# Case files\n\n\
         A case is a TOML file. A plain number is the paper's dimensionless group, a string carries a unit (`\"30 mm/s\"`, `\"0.2 N\"`, `\"1 MPa\"`, \
         `\"30 deg\"`). Keys left out take the values below; the keys of a table, as `sweep.from`, stand where it comes first. `judder schema` prints the JSON Schema, `judder new` a commented case. \
         A case is a file of at most 1 MiB.\n\n",
    );
    for model in registry.models() {
        page += &(model.reference)();
    }
    page += "\nA sweep within an analysis is `{ key = \"operation.velocity\", from = 1e-8, to = 1e2, points = 21, scale = \"log\" }` (`scale` is `linear` where left out), a \
             `family` is `{ key = \"…\", values = [ … ] }`, one curve a value, and `within` is `{ from = 1e-6, to = 1e3 }`. `method` is `adaptive` (the \
             default) or `every-point`; `boundaries = false` leaves the curves out.\n";
    page + &sweep::section()
}

/// The section on a model: its prose, in which `{keys}` stands for what its cases say and `{analyses}` for its kinds.
pub fn section<S, T>(prose: &str, keys: &[Declaration], own: &[Kind<S, T>]) -> String {
    prose.replace("{keys}", table(keys).trim_end()).replace("{analyses}", kinds(own).trim_end())
}

/// The kinds of a model, and their keys.
pub fn kinds<S, T>(kinds: &[Kind<S, T>]) -> String {
    let mut list =
        String::from("| kind | keys beside `name` and `kind` | what it computes |\n| --- | --- | --- |\n");
    for kind in kinds {
        let Kind { name, doc, .. } = kind;
        let keys: Vec<String> = kind.keys().iter().map(|key| format!("`{key}`")).collect();
        list += &format!("| `{name}` | {} | {doc} |\n", keys.join(", "));
    }
    let declared = kinds.iter().map(|kind| settings(kind.name, &(kind.declared)()));
    without_repetition(&declared.fold(list, |page, own| page + &own))
}
