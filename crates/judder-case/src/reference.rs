//! The reference page of the book: every key and every kind of analysis, from the tables that read them.

use crate::oscillator_analysis;
use crate::two_degrees;
use crate::{FrictionLoad, KEYS, LawName, Range};

/// The page, as Markdown.
pub fn reference() -> String {
    let mut page = String::from(
        "# Case files\n\n\
         A case is a TOML file. A plain number is the paper's dimensionless group, a string carries a unit (`\"30 mm/s\"`, `\"0.2 N\"`, `\"1 MPa\"`, \
         `\"30 deg\"`). Keys left out take the values below. `judder schema` prints the JSON Schema, `judder new` a commented case. \
         A case is a file of at most 1 MiB.\n\n\
         ## Keys of an oscillator case\n\n\
         | key | symbol | a plain number is | a string is | default | allowed | what it is |\n\
         | --- | --- | --- | --- | --- | --- | --- |\n",
    );
    for key in &KEYS {
        let number = match (key.group, key.dimension.is_number()) {
            (Some(group), _) => group.to_owned(),
            (None, true) => "the number".to_owned(),
            (None, false) => "not allowed".to_owned(),
        };
        let string =
            if key.dimension.is_number() { "not allowed".to_owned() } else { key.dimension.example() };
        let default = key.default.map_or(String::new(), |(text, _)| format!("`{text}`"));
        page += &format!(
            "| `{}` | {} | {number} | {string} | {default} | {} | {} |\n",
            key.path,
            key.symbol,
            allowed(key.range),
            key.doc
        );
    }
    let laws: Vec<String> = LawName::ALL.iter().map(|(name, _)| format!("`{name}`")).collect();
    let loads: Vec<String> = FrictionLoad::ALL.iter().map(|(name, _)| format!("`{name}`")).collect();
    page += &format!(
        "\n`contact.law` is one of {}; `contact.friction_load` of {}.\n",
        laws.join(", "),
        loads.join(", ")
    );
    page += "\nThe relaxation of the substrate is given as `retardation_time` (creep), or as `relaxation_time`, or as one `prony` term \
             `[{ time = \"10 ms\", compliance = \"0.9e-6 1/Pa\" }]`, which then gives the glassy modulus too.\n";
    page += "\n## Analyses of an oscillator case\n\n";
    page += &kinds(oscillator_analysis::KINDS.iter().map(|kind| (kind.name, kind.keys, kind.doc)));
    page += "\n## Analyses of a two-degrees case\n\n\
             `[parameters]` holds numbers by name; `[matrices]` holds `mass` (identity by default), `damping` (zero by default) and `stiffness` as 2 × 2 \
             arrays of numbers or expressions of the parameters. Swept keys are `parameters.NAME`.\n\n";
    page += &kinds(two_degrees::KINDS.iter().map(|kind| (kind.name, kind.keys, kind.doc)));
    page += "\nA sweep is `{ key = \"operation.velocity\", from = 1e-8, to = 1e2, points = 21, scale = \"log\" }` (`scale` is `linear` where left out), a \
             `family` is `{ key = \"…\", values = [ … ] }`, one curve a value, and `within` is `{ from = 1e-6, to = 1e3 }`. `method` is `adaptive` (the \
             default) or `every-point`; `boundaries = false` leaves the curves out.\n";
    page
}

fn allowed(range: Range) -> String {
    match range {
        Range::Positive => "> 0".to_owned(),
        Range::NonNegative => "≥ 0".to_owned(),
        Range::Any => "any".to_owned(),
        Range::Interval { above, up_to } => format!("> {above}, ≤ {up_to}").replace('-', "−"),
    }
}

fn kinds<'a>(kinds: impl Iterator<Item = (&'a str, &'a [&'a str], &'a str)>) -> String {
    let mut table =
        String::from("| kind | keys beside `name` and `kind` | what it computes |\n| --- | --- | --- |\n");
    for (name, keys, doc) in kinds {
        let keys: Vec<String> = keys.iter().map(|key| format!("`{key}`")).collect();
        table += &format!("| `{name}` | {} | {doc} |\n", keys.join(", "));
    }
    table
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `JUDDER_BLESS=1` writes the page anew.
    #[test]
    fn the_page_of_the_book_is_this_one() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/src/case-files.md");
        if std::env::var_os("JUDDER_BLESS").is_some() {
            std::fs::write(path, reference()).unwrap();
        }
        assert_eq!(std::fs::read_to_string(path).unwrap(), reference(), "run this test with JUDDER_BLESS=1");
    }
}
