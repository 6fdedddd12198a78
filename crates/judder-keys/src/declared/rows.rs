//! Rows of the reference of keys: what each may be, and what it is where it is left out.

use super::allowed::{Allowed, Declaration, as_written, choices, must_be_given};

/// The rows of a table, and below each those of the keys of its own table.
pub fn rows(keys: &[Declaration]) -> String {
    KeyTables { one: keys, others: Vec::new() }.rows("")
}

/// A table that a key may be, and the others that it may be in its place.
struct KeyTables<'a> {
    one: &'a [Declaration],
    others: Vec<&'a [Declaration]>,
}

impl KeyTables<'_> {
    fn rows(&self, prefix: &str) -> String {
        self.one.iter().map(|key| self.rows_of(key, prefix)).collect()
    }

    fn rows_of(&self, key: &Declaration, prefix: &str) -> String {
        let Declaration { name, symbol, doc, form, .. } = key;
        let path = format!("{prefix}{name}");
        let row = format!("| `{path}` | {symbol} | {} | {} | {doc} |\n", form.words(), self.left_out(key));
        let inner =
            if matches!(form, Allowed::Named(_)) { format!("{path}.NAME.") } else { format!("{path}.") };
        let mut rows = vec![row];
        let tables: Vec<&[Declaration]> =
            form.alternatives().iter().map(Allowed::keys).filter(|keys| !keys.is_empty()).collect();
        // of several tables that a key may be, the keys of each; one that more than one has is one
        for (number, one) in tables.iter().enumerate() {
            let others = tables.iter().enumerate().filter(|(other, _)| *other != number);
            let own = KeyTables { one, others: others.map(|(_, other)| *other).collect() };
            for row in own.rows(&inner).split_inclusive('\n') {
                let is_same = |above: &String| above.split('|').nth(1) == row.split('|').nth(1);
                if !rows.iter().any(is_same) {
                    rows.push(row.to_owned());
                }
            }
        }
        rows.concat()
    }

    /// What a key is where it is left out; of one that must be given, in place of which keys.
    fn left_out(&self, key: &Declaration) -> String {
        if let Some(default) = &key.default {
            return format!("`{}`", key.form.line(&as_written(default)));
        }
        if !key.is_required {
            return String::new();
        }
        let own = match &key.alternative {
            Some(own) => choices(self.one).swap_remove(own.choice),
            None => Vec::new(),
        };
        let is_own = |keys: &&Vec<&Declaration>| keys.iter().any(|other| other.name == key.name);
        let (same, others): (Vec<_>, Vec<_>) = own.iter().partition(is_own);
        if own.first().is_some_and(|first| !must_be_given(first)) {
            // nothing need be given: the first alternative is meant then
            let beside =
                same.into_iter().flatten().filter(|other| other.is_required && other.name != key.name);
            return listed("must be given beside ", beside.map(|other| other.name));
        }
        let is_beside =
            |key: &&Declaration| same.iter().any(|own| own.iter().any(|own| own.name == key.name));
        let of_others = others.into_iter().filter_map(|keys| {
            let apart: Vec<_> = keys.iter().copied().filter(|key| !is_beside(key)).collect();
            lead(&apart)
        });
        let of_tables = self.others.iter().flat_map(|table| ways(table));
        let instead = of_others.chain(of_tables);
        match listed("", instead.filter(|other| *other != key.name)) {
            none if none.is_empty() => "must be given".to_owned(),
            instead => format!("must be given, or {instead}"),
        }
    }
}

/// By which key each way to fill a table in is known.
fn ways(table: &[Declaration]) -> Vec<&'static str> {
    match choices(table).first() {
        None => lead(&table.iter().collect::<Vec<_>>()).into_iter().collect(),
        Some(ways) => ways.iter().filter_map(|keys| lead(keys)).collect(),
    }
}

/// The key by which an alternative is known: one that must be given, else its first.
fn lead(keys: &[&Declaration]) -> Option<&'static str> {
    keys.iter().find(|key| key.is_required).or(keys.first()).map(|key| key.name)
}

/// Names one after the other, each once; nothing where there are none.
fn listed(before: &str, names: impl Iterator<Item = &'static str>) -> String {
    let mut all: Vec<String> = Vec::new();
    for name in names.map(|name| format!("`{name}`")) {
        if !all.contains(&name) {
            all.push(name);
        }
    }
    if all.is_empty() { String::new() } else { format!("{before}{}", all.join(", ")) }
}

#[cfg(test)]
mod tests {
    use super::super::{alternatives, beside};
    use super::*;

    fn key(name: &'static str, is_required: bool) -> Declaration {
        let form = Allowed::Flag;
        Declaration { name, doc: "", symbol: "", default: None, is_required, alternative: None, form }
    }

    fn told(keys: &[Declaration]) -> Vec<String> {
        rows(keys).lines().map(|row| row.split('|').nth(4).unwrap().trim().to_owned()).collect()
    }

    #[test]
    fn alternatives_say_in_place_of_what_they_must_be_given() {
        let nested = alternatives(vec![vec![key("set", true)], vec![key("nodes", true)]]);
        let surface = [vec![key("structure", true), key("normal", false)], nested].concat();
        let own = alternatives(vec![vec![key("plane", true)], surface]);
        let expected = [
            "must be given, or `structure`",
            "must be given, or `plane`",
            "",
            "must be given, or `plane`, `nodes`",
            "must be given, or `plane`, `set`",
        ];
        assert_eq!(told(&own), expected);
        let optional =
            alternatives(vec![vec![key("count", false)], vec![key("from", true), key("to", true)]]);
        assert_eq!(told(&optional), ["", "must be given beside `to`", "must be given beside `from`"]);
        let places = alternatives(vec![vec![key("set", true)], vec![key("nodes", true)]]);
        let amounts = alternatives(vec![vec![key("force", true)], vec![key("pressure", true)]]);
        let expected =
            ["`nodes`", "`set`", "`pressure`", "`force`"].map(|own| format!("must be given, or {own}"));
        assert_eq!(told(&beside(vec![places, amounts])), expected);
        assert_eq!(told(&[key("alone", true)]), ["must be given"]);
    }

    #[test]
    fn tables_in_the_place_of_each_other_name_the_other() {
        let table = |keys| Allowed::Table { doc: "", keys };
        let [lists, file] = [
            table(alternatives(vec![vec![key("stiffness", true)], vec![key("cubic", true)]])),
            table(vec![key("file", true), key("interpolation", false)]),
        ];
        let law =
            Declaration { form: Allowed::Either(vec![Allowed::Text, lists, file]), ..key("normal", true) };
        let expected = [
            "must be given",
            "must be given, or `cubic`, `file`",
            "must be given, or `stiffness`, `file`",
            "must be given, or `stiffness`, `cubic`",
            "",
        ];
        assert_eq!(told(&[law]), expected);
    }
}
