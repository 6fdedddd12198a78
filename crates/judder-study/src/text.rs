//! Aligned columns for the terminal.

/// Rows of cells as lines, every column as wide as its widest cell; two blanks between.
pub fn columns(rows: &[Vec<String>]) -> String {
    let width = |column: usize| {
        rows.iter().filter_map(|row| row.get(column)).map(|cell| cell.chars().count()).max().unwrap_or(0)
    };
    let count = rows.iter().map(Vec::len).max().unwrap_or(0);
    let widths: Vec<usize> = (0..count).map(width).collect();
    let mut text = String::new();
    for row in rows {
        let mut line = String::from("  ");
        for (cell, width) in row.iter().zip(&widths) {
            line.push_str(cell);
            line.extend(std::iter::repeat_n(' ', width - cell.chars().count() + 2));
        }
        text.push_str(line.trim_end());
        text.push('\n');
    }
    text
}

/// A number to seven digits: as it is in the middle of the scale, as a power of ten at its ends.
pub fn number(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    if (1e-3..1e5).contains(&value.abs()) { format!("{value:.7}") } else { format!("{value:.6e}") }
}

/// A number to four digits, for sentences.
pub fn short(value: f64) -> String {
    let rounded = four_digits(value);
    let plain = rounded == 0.0 || (1e-3..1e5).contains(&rounded.abs());
    if plain { format!("{rounded}") } else { format!("{rounded:e}") }
}

/// The number of four digits that is nearest.
pub(crate) fn four_digits(value: f64) -> f64 {
    format!("{value:.3e}").parse().unwrap_or(value)
}

/// Numbers in a row, or a word where there are none.
pub fn list(values: &[f64]) -> String {
    if values.is_empty() {
        return "none".to_owned();
    }
    values.iter().map(|value| number(*value)).collect::<Vec<_>>().join(", ")
}
