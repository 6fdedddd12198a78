//! Keys as docs tell them: what each may be, what it is where it is left out; rows of the reference.

use super::allowed::{Allowed, Declaration, as_written, choices, must_be_given};

/// A key as docs tell it.
pub struct ToldKey<'a> {
    /// As it is declared.
    pub key: &'a Declaration,
    /// Its default as a case file says it; empty where it has none.
    pub default: String,
    /// Of a key without a default whether it must be given, in place of which keys or beside which; empty where it need not be.
    pub needed: String,
    /// The keys of its table; of several tables that it may be the keys of each, one that more than one has once.
    pub keys: Vec<ToldKey<'a>>,
}

/// The keys of a table as docs tell them.
pub fn told(keys: &[Declaration]) -> Vec<ToldKey<'_>> {
    KeyTables { one: keys, others: Vec::new() }.told()
}

/// The rows of a table, and below each those of the keys of its own table.
pub fn rows(keys: &[Declaration]) -> String {
    rows_of(&told(keys), "")
}

fn rows_of(keys: &[ToldKey<'_>], prefix: &str) -> String {
    let row = |own: &ToldKey<'_>| {
        let Declaration { name, symbol, doc, form, .. } = own.key;
        let path = format!("{prefix}{name}");
        let absent = if own.default.is_empty() { own.needed.clone() } else { format!("`{}`", own.default) };
        let inner =
            if matches!(form, Allowed::Named(_)) { format!("{path}.NAME.") } else { format!("{path}.") };
        let row = format!("| `{path}` | {symbol} | {} | {absent} | {doc} |\n", form.words());
        row + &rows_of(&own.keys, &inner)
    };
    keys.iter().map(row).collect()
}

/// A table that a key may be, and the others that it may be in its place.
struct KeyTables<'a> {
    one: &'a [Declaration],
    others: Vec<&'a [Declaration]>,
}

impl<'a> KeyTables<'a> {
    fn told(&self) -> Vec<ToldKey<'a>> {
        self.one.iter().map(|key| self.told_of(key)).collect()
    }

    fn told_of(&self, key: &'a Declaration) -> ToldKey<'a> {
        let tables: Vec<&[Declaration]> =
            key.form.alternatives().iter().map(Allowed::keys).filter(|keys| !keys.is_empty()).collect();
        let mut keys = Vec::new();
        for (number, one) in tables.iter().enumerate() {
            let others = tables.iter().enumerate().filter(|(other, _)| *other != number);
            let own = KeyTables { one, others: others.map(|(_, other)| *other).collect() };
            merge(&mut keys, own.told());
        }
        let default =
            key.default.as_ref().map(|default| key.form.line(&as_written(default))).unwrap_or_default();
        ToldKey { key, needed: self.needed(key), default, keys }
    }

    /// Of a key that must be given, in place of which keys.
    fn needed(&self, key: &Declaration) -> String {
        if key.default.is_some() || !key.is_required {
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

/// Adds the keys of one more table that a key may be.
fn merge<'a>(keys: &mut Vec<ToldKey<'a>>, others: Vec<ToldKey<'a>>) {
    for other in others {
        match keys.iter_mut().find(|own| own.key.name == other.key.name) {
            Some(own) => merge(&mut own.keys, other.keys),
            None => keys.push(other),
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

    fn absent(keys: &[Declaration]) -> Vec<String> {
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
        assert_eq!(absent(&own), expected);
        let optional =
            alternatives(vec![vec![key("count", false)], vec![key("from", true), key("to", true)]]);
        assert_eq!(absent(&optional), ["", "must be given beside `to`", "must be given beside `from`"]);
        let places = alternatives(vec![vec![key("set", true)], vec![key("nodes", true)]]);
        let amounts = alternatives(vec![vec![key("force", true)], vec![key("pressure", true)]]);
        let expected =
            ["`nodes`", "`set`", "`pressure`", "`force`"].map(|own| format!("must be given, or {own}"));
        assert_eq!(absent(&beside(vec![places, amounts])), expected);
        assert_eq!(absent(&[key("alone", true)]), ["must be given"]);
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
        assert_eq!(absent(&[law]), expected);
    }
}
