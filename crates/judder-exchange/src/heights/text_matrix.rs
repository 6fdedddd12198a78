//! Matrices of numbers as text.

use super::error::HeightsError;
use super::table::HeightTable;

/// Reads one row of heights a line, separated by spaces, tabs, commas or semicolons; `#` and `%` begin a comment.
///
/// # Errors
/// What is no text, what is no finite number, an empty entry, rows of different lengths, and commas that could be decimal,
/// each with its line.
pub(super) fn read_text_matrix(bytes: &[u8]) -> Result<HeightTable, HeightsError> {
    let text =
        std::str::from_utf8(bytes).map_err(|error| HeightsError::NotText { byte: error.valid_up_to() })?;
    let mut heights = Vec::new();
    let (mut columns, mut rows) = (0, 0);
    for (index, content) in text.trim_start_matches('\u{feff}').lines().enumerate() {
        let line = index + 1;
        let content = content.split(['#', '%']).next().unwrap_or("").trim();
        if content.is_empty() {
            continue;
        }
        let before = heights.len();
        for (index, entry) in entries(content, line)?.into_iter().enumerate() {
            let entry_number = index + 1;
            if entry.is_empty() {
                return Err(HeightsError::MissingEntry { line, entry: entry_number });
            }
            match entry.parse::<f64>() {
                Ok(height) if height.is_finite() => heights.push(height),
                _ => {
                    let text = entry.to_owned();
                    return Err(HeightsError::NotANumber { line, entry: entry_number, text });
                }
            }
        }
        let found = heights.len() - before;
        if rows > 0 && found != columns {
            return Err(HeightsError::RaggedRow { line, found, expected: columns });
        }
        columns = found;
        rows += 1;
    }
    Ok(HeightTable { columns, rows, heights, spacing: None })
}

/// The entries of a line.
fn entries(content: &str, line: usize) -> Result<Vec<&str>, HeightsError> {
    let comma = content.contains(',');
    let separator = match (content.contains(';'), content.contains('\t')) {
        (true, _) if comma => return Err(HeightsError::AmbiguousComma { line, other: "semicolons" }),
        (_, true) if comma => return Err(HeightsError::AmbiguousComma { line, other: "tabs" }),
        (true, _) => ';',
        (_, true) => '\t',
        _ if comma => ',',
        _ => return Ok(content.split_whitespace().collect()),
    };
    let entries: Vec<&str> = content.split(separator).map(str::trim).collect();
    if comma && entries.iter().any(|entry| entry.contains(char::is_whitespace)) {
        return Err(HeightsError::AmbiguousComma { line, other: "spaces between numbers" });
    }
    Ok(entries)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn error(text: &str) -> HeightsError {
        read_text_matrix(text.as_bytes()).unwrap_err()
    }

    #[test]
    fn every_separator_gives_the_same_matrix() {
        for text in [
            "1 2.5  3\n4 5 -6e-1\n",
            "1,2.5,3\r\n4, 5, -0.6",
            "# heights\n1;2.5;3 % first\n\n4;5;-.6",
            "1\t2.5\t3\n4\t5\t-.6",
        ] {
            let table = read_text_matrix(text.as_bytes()).unwrap();
            assert_eq!((table.columns, table.rows), (3, 2), "{text:?}");
            assert_eq!(table.heights, [1.0, 2.5, 3.0, 4.0, 5.0, -0.6], "{text:?}");
        }
    }

    #[test]
    fn bad_lines_are_refused_with_their_place() {
        assert_eq!(error("1 2\n3 4 5"), HeightsError::RaggedRow { line: 2, found: 3, expected: 2 });
        assert_eq!(
            error("1 2\n3 x"),
            HeightsError::NotANumber { line: 2, entry: 2, text: String::from("x") }
        );
        for gap in ["nan", "inf", "1e999"] {
            let text = String::from(gap);
            assert_eq!(error(&format!("1 {gap}")), HeightsError::NotANumber { line: 1, entry: 2, text });
        }
        assert_eq!(error("1,,2"), HeightsError::MissingEntry { line: 1, entry: 2 });
        assert_eq!(error("1,5;2,5"), HeightsError::AmbiguousComma { line: 1, other: "semicolons" });
        assert_eq!(
            error("1,5 2,5"),
            HeightsError::AmbiguousComma { line: 1, other: "spaces between numbers" }
        );
        assert_eq!(read_text_matrix(&[b'1', 0xff]), Err(HeightsError::NotText { byte: 1 }));
    }
}
