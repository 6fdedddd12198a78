//! Tables of the report beside the scalars: what analyses say of themselves, what a sweep says.

mod sweep;

pub(crate) use sweep::tables as of_sweep;
pub(crate) use sweep::{interval, probabilities, short_index};

use crate::registry::TableRows;
use judder_report::page::PageTable;
use serde_json::Value;

/// Rows that a table shows; all are in the CSV file.
const ROWS: usize = 40;

/// Rows that the terminal shows of a table.
const TERMINAL_ROWS: usize = 12;

/// The first rows of the first table for the terminal, below its head where it has one; none where there is no table.
pub(crate) fn on_terminal(tables: Vec<PageTable>) -> Option<TableRows> {
    let PageTable { head, mut rows, .. } = tables.into_iter().next()?;
    let more = rows.len().saturating_sub(TERMINAL_ROWS);
    rows.truncate(TERMINAL_ROWS);
    let rest = (more > 0).then(|| vec![format!("… {more} more")]);
    Some(
        Some(head)
            .filter(|head| head.iter().any(|cell| !cell.is_empty()))
            .into_iter()
            .chain(rows)
            .chain(rest)
            .map(|row| row.iter().map(|cell| unmarked(cell)).collect())
            .collect(),
    )
}

/// A text of the report without the signs of its markup.
fn unmarked(text: &str) -> String {
    text.replace(['$', '{', '}'], "")
}

/// A table of a list, of which it shows the first rows: `row` makes one of an item and its number.
pub fn listed(
    caption: &str,
    head: &[&str],
    items: &[Value],
    row: impl Fn(usize, &Value) -> Vec<String>,
) -> PageTable {
    let more =
        if items.len() > ROWS { format!(", the first {ROWS} of {}", items.len()) } else { String::new() };
    PageTable {
        caption: format!("{caption}{more}"),
        head: head.iter().map(|word| (*word).to_owned()).collect(),
        rows: items.iter().take(ROWS).enumerate().map(|(k, item)| row(k + 1, item)).collect(),
    }
}

/// A number to six digits; a dash where there is none.
pub fn short(value: &Value) -> String {
    to_digits(value, 6)
}

/// By how much a number may be off, to two digits; a dash where that is not known.
pub fn uncertainty(value: &Value) -> String {
    to_digits(value, 2)
}

fn to_digits(value: &Value, digits: usize) -> String {
    let Some(value) = value.as_f64() else { return "–".to_owned() };
    let rounded: f64 = format!("{value:.0$e}", digits - 1).parse().unwrap_or(value);
    let plain = value == 0.0 || (1e-3..1e7).contains(&value.abs());
    if plain { format!("{rounded}") } else { format!("{rounded:e}") }.replace('-', "−")
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn errors_have_two_digits() {
        let words = [
            (json!(-1.2345678e-5), "−1.23457e−5", "−1.2e−5"),
            (json!(0.0996), "0.0996", "0.1"),
            (json!(null), "–", "–"),
        ];
        for (value, whole, error) in words {
            assert_eq!((short(&value), uncertainty(&value)), (whole.to_owned(), error.to_owned()));
        }
    }

    #[test]
    fn a_table_without_a_head_begins_with_its_rows() {
        let table = |head: &str| {
            let (head, rows) = (vec![head.to_owned()], vec![vec!["row".to_owned()]]);
            on_terminal(vec![PageTable { caption: String::new(), head, rows }]).unwrap()
        };
        assert_eq!(table("head"), [["head"], ["row"]]);
        assert_eq!(table(""), [["row"]]);
    }
}
