//! The text of a case that is edited: values set at dotted paths as [`document`](crate::document) grafts them, comments kept.

use serde_json::{Map, Value as Json};
use toml::de::DeValue;
use toml_edit::{Array, InlineTable, Item, Table, TableLike, Value};

use crate::cause::Cause;
use crate::document::{NAMING, item_index, read_option};
use crate::error::{Fault, Place};

/// The keys that stand first in a table made from JSON, which has no order.
const FIRST: [&str; 7] = ["name", "kind", "key", "from", "to", "points", "scale"];

/// Writes the `number`-th option `key=value` into the text.
pub fn apply_option(root: &mut Item, number: usize, option: &str) -> Result<(), Fault> {
    let parts = read_option(number, option)?;
    let steps: Vec<&str> = parts.steps.iter().map(|(step, _)| *step).collect();
    let place = Place { source: number, start: 0, end: option.len() };
    set(root, &steps, value_of_option(&option[parts.value]))
        .ok_or_else(|| Cause::OverrideForm { option: option.to_owned() }.at(place))
}

/// The value of an option: TOML, else a bare string, in its own spelling where that can be kept.
fn value_of_option(text: &str) -> Value {
    match (DeValue::parse(text), text.parse::<Value>()) {
        (Ok(_), Ok(mut value)) => {
            value.decor_mut().clear();
            value
        }
        // an integer that is beyond 64 bits
        (Ok(parsed), Err(_)) => parsed
            .get_ref()
            .as_integer()
            .map_or_else(|| text.into(), |integer| number(integer.as_str().parse().unwrap_or(f64::NAN))),
        (Err(_), _) => text.into(),
    }
}

/// Walks down `steps`, making tables where there are none, and puts `leaf` at the end; `None` where the path leads nowhere.
pub fn set(item: &mut Item, steps: &[&str], leaf: Value) -> Option<()> {
    let [step, rest @ ..] = steps else {
        put(item, leaf);
        return Some(());
    };
    if let Some(tables) = item.as_array_of_tables_mut() {
        let index = item_index(names(&tables.iter().map(|table| name_of(table)).collect::<Vec<_>>()), step)?;
        if rest.is_empty() && !leaf.is_inline_table() {
            // a list of tables alone cannot hold it
            let list = std::mem::take(tables).into_array();
            *item = Item::Value(Value::Array(list));
            return set(item, steps, leaf);
        }
        return set_in_table(tables.get_mut(index)?, rest, leaf);
    }
    if let Some(list) = item.as_array_mut() {
        return set_in_list(list, step, rest, leaf);
    }
    set_below(item.as_table_like_mut()?, step, rest, leaf)
}

fn names<'a>(names: &'a [Option<&'a str>]) -> impl ExactSizeIterator<Item = Option<&'a str>> {
    names.iter().copied()
}

fn name_of(table: &dyn TableLike) -> Option<&str> {
    NAMING.iter().find_map(|key| table.get(key))?.as_str()
}

fn set_in_table(table: &mut Table, steps: &[&str], leaf: Value) -> Option<()> {
    match (steps, leaf) {
        ([step, rest @ ..], leaf) => set_below(table, step, rest, leaf),
        ([], Value::InlineTable(leaf)) => {
            let (decor, position) = (table.decor().clone(), table.position());
            *table = leaf.into_table();
            *table.decor_mut() = decor;
            table.set_position(position);
            Some(())
        }
        ([], _) => None,
    }
}

fn set_in_list(list: &mut Array, step: &str, rest: &[&str], leaf: Value) -> Option<()> {
    let of_value =
        |value: &'_ Value| value.as_inline_table().and_then(|table| name_of(table)).map(str::to_owned);
    let owned: Vec<Option<String>> = list.iter().map(of_value).collect();
    let index = item_index(owned.iter().map(Option::as_deref), step)?;
    let value = list.get_mut(index)?;
    let mut item = Item::Value(value.clone());
    set(&mut item, rest, leaf)?;
    *value = item.into_value().ok()?;
    Some(())
}

fn set_below(table: &mut dyn TableLike, step: &str, rest: &[&str], leaf: Value) -> Option<()> {
    if table.get(step).is_none_or(Item::is_none) {
        if rest.is_empty() {
            table.insert(step, Item::Value(leaf));
            return Some(());
        }
        let mut fresh = Table::new();
        // without values of its own it needs no header
        fresh.set_implicit(true);
        fresh.set_dotted(table.is_dotted());
        table.insert(step, Item::Table(fresh));
    }
    set(table.get_mut(step)?, rest, leaf)
}

/// Keeps the items of a list whose flag is set; a list that has none left goes.
pub fn keep(root: &mut Table, list: &str, kept: &[bool]) {
    let mut flags = kept.iter().copied();
    let mut stays = || flags.next().unwrap_or(false);
    let left = match root.get_mut(list) {
        Some(Item::ArrayOfTables(tables)) => {
            tables.retain(|_| stays());
            tables.len()
        }
        Some(Item::Value(Value::Array(values))) => {
            values.retain(|_| stays());
            values.len()
        }
        _ => return,
    };
    if left == 0 {
        root.remove(list);
    }
}

/// Replaces a value, and keeps the comment behind it.
pub fn put(item: &mut Item, mut leaf: Value) {
    if let Item::Value(old) = item {
        *leaf.decor_mut() = old.decor().clone();
    }
    *item = Item::Value(leaf);
}

/// A table of a list of tables.
pub fn table_of(map: &Map<String, Json>) -> Table {
    let mut table = Table::new();
    table.decor_mut().set_prefix("\n");
    for (key, value) in in_order(map) {
        table.insert(key, Item::Value(value));
    }
    table
}

fn in_order(map: &Map<String, Json>) -> Vec<(&str, Value)> {
    let mut entries: Vec<_> =
        map.iter().filter_map(|(key, value)| Some((key.as_str(), value_of(value)?))).collect();
    entries.sort_by_key(|(key, _)| FIRST.iter().position(|first| first == key).unwrap_or(FIRST.len()));
    entries
}

/// The TOML of a JSON value; none of `null`.
fn value_of(json: &Json) -> Option<Value> {
    Some(match json {
        Json::Null => return None,
        Json::Bool(value) => (*value).into(),
        Json::Number(value) => match value.as_i64() {
            Some(whole) => whole.into(),
            None => number(value.as_f64().unwrap_or(f64::NAN)),
        },
        Json::String(text) => text.as_str().into(),
        Json::Array(values) => Value::Array(values.iter().filter_map(value_of).collect()),
        Json::Object(map) => {
            let mut table = InlineTable::new();
            for (key, value) in in_order(map) {
                table.insert(key, value);
            }
            Value::InlineTable(table)
        }
    })
}

/// A number as one writes it: 0.01, but 1e-8.
fn number(value: f64) -> Value {
    let short = format!("{value:e}");
    let exponent = short.split_once('e').and_then(|(_, exponent)| exponent.parse::<i32>().ok());
    match exponent {
        Some(-3..=5) | None => value.into(),
        Some(_) => short.parse().unwrap_or_else(|_| value.into()),
    }
}
