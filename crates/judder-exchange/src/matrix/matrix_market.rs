//! Matrix Market: text files of sparse and dense matrices.
//!
//! R. F. Boisvert, R. Pozo, K. Remington, *The Matrix Market Exchange Formats: Initial Design*, NISTIR 5935 (1996).

use super::{ENTRIES, ENTRY_BYTES, Matrix, Symmetry};
use crate::cause::FileCause;
use crate::door::ask;
use crate::error::ExchangeError;
use crate::quoted::quoted;
use crate::text::{check_room, count, number, text_of};
use judder_memory::MemoryBudget;
use std::io::Write;

/// Writes a matrix in coordinates: one triangle where it is symmetric or skew-symmetric by [`Matrix::symmetry`], all entries otherwise.
/// Every number reads back to its last bit.
///
/// # Errors
/// [`FileCause::Inconsistent`] where the entries have not the symmetry that the matrix says, [`FileCause::Unwritable`].
pub fn write_matrix_market(to: &mut dyn Write, matrix: &Matrix) -> Result<(), ExchangeError> {
    let (symmetry, departure) = match matrix.symmetry {
        Symmetry::General => ("general", 0.0),
        Symmetry::Symmetric => ("symmetric", matrix.asymmetry()),
        Symmetry::SkewSymmetric => ("skew-symmetric", matrix.skew_asymmetry()),
    };
    if departure != 0.0 {
        let problem = format!("it departs from {symmetry} by {departure:e} of its largest entry");
        return Err(FileCause::Inconsistent { what: "the matrix", problem }.into());
    }
    let stored = |(row, column, _): &&(usize, usize, f64)| match matrix.symmetry {
        Symmetry::General => true,
        Symmetry::Symmetric => row >= column,
        Symmetry::SkewSymmetric => row > column,
    };
    let count = matrix.entries.iter().filter(stored).count();
    writeln!(to, "%%MatrixMarket matrix coordinate real {symmetry}")?;
    writeln!(to, "{} {} {count}", matrix.rows, matrix.columns)?;
    for (row, column, value) in matrix.entries.iter().filter(stored) {
        writeln!(to, "{} {} {value:e}", row + 1, column + 1)?;
    }
    Ok(())
}

/// The header line of a file.
struct MarketHeader {
    sparse: bool,
    /// Whether the field is `integer`.
    integer: bool,
    symmetry: Symmetry,
}

/// What there is for entries: the bytes of the file and those of the memory.
#[derive(Clone, Copy)]
struct MarketRoom {
    bytes: usize,
    budget: MemoryBudget,
}

impl MarketRoom {
    /// Whether so many entries of so many bytes each can be in the file and, mirrored, in the memory.
    fn check(&self, said: usize, bytes_each: usize, symmetry: Symmetry) -> Result<(), FileCause> {
        // the last line may lack its end
        check_room(said, bytes_each, self.bytes + 1, "entries")?;
        let sides = if symmetry == Symmetry::General { 1 } else { 2 };
        ask(self.budget, ENTRIES, said as u128 * sides * ENTRY_BYTES)
    }
}

/// Lines that are no comments, with their numbers.
type NumberedLines<'a> = dyn Iterator<Item = (usize, &'a str)> + 'a;

/// Reads coordinate and array files of real and integer matrices: general, symmetric and skew-symmetric. The field is that of the entries
/// (NISTIR 5935): below `integer` an entry is written as an integer.
pub(super) fn read_matrix_market(bytes: &[u8], budget: MemoryBudget) -> Result<Matrix, ExchangeError> {
    let text = text_of(bytes)?;
    let header =
        header(text.lines().next().unwrap_or("")).map_err(|cause| ExchangeError::at_line(1, cause))?;
    let numbered = text.lines().enumerate().skip(1).map(|(k, line)| (k + 1, line.trim()));
    let mut lines = numbered.filter(|(_, line)| !line.is_empty() && !line.starts_with('%'));
    let (line, sizes) =
        lines.next().ok_or(FileCause::Cut { what: "the sizes of the matrix", needed: 3, left: 0 })?;
    let room = MarketRoom { bytes: bytes.len(), budget };
    if header.sparse {
        coordinates(&header, line, sizes, &mut lines, room)
    } else {
        array(&header, line, sizes, &mut lines, room)
    }
}

fn header(line: &str) -> Result<MarketHeader, FileCause> {
    let lower = line.to_ascii_lowercase();
    let words: Vec<&str> = lower.split_whitespace().collect();
    let ["%%matrixmarket", "matrix", format, field, symmetry] = words.as_slice() else {
        return Err(FileCause::Foreign {
            format: "Matrix Market file",
            found: format!("its first line is `{}`", quoted(line)),
            remedy: "the first line should be, say, `%%MatrixMarket matrix coordinate real general`",
        });
    };
    let unsupported = |what, found: &str, read| FileCause::Unsupported {
        what,
        found: format!("`{}`", quoted(found)),
        read,
    };
    let sparse = match *format {
        "coordinate" => true,
        "array" => false,
        other => return Err(unsupported("the format of the matrix", other, "`coordinate` or `array`")),
    };
    if !["real", "integer", "double"].contains(field) {
        let read = match *field {
            "pattern" => "`real` or `integer`; a pattern has no numbers",
            "complex" => "`real` or `integer`; write real and imaginary parts as two matrices",
            _ => "`real` or `integer`",
        };
        return Err(unsupported("the field of the matrix", field, read));
    }
    let symmetry = match *symmetry {
        "general" => Symmetry::General,
        "symmetric" => Symmetry::Symmetric,
        "skew-symmetric" => Symmetry::SkewSymmetric,
        other => {
            let read = "`general`, `symmetric` or `skew-symmetric`";
            return Err(unsupported("the symmetry of the matrix", other, read));
        }
    };
    Ok(MarketHeader { sparse, integer: *field == "integer", symmetry })
}

/// The numbers of the line of sizes, each with its name and the least that it can be.
fn sizes<const N: usize>(
    text: &str,
    expected: &'static str,
    names: [(&'static str, usize); N],
) -> Result<[usize; N], FileCause> {
    let words: Vec<&str> = text.split_whitespace().collect();
    if words.len() != N {
        return Err(FileCause::WrongEntries { what: "the line of sizes", expected, found: words.len() });
    }
    let mut sizes = [0; N];
    for (size, (word, (name, least))) in sizes.iter_mut().zip(words.into_iter().zip(names)) {
        *size = count(word, least, name)?;
    }
    Ok(sizes)
}

/// What the lines hold, one a line, as many as are said.
fn each_line<T>(
    lines: &mut NumberedLines<'_>,
    what: &'static str,
    line_of_sizes: usize,
    said: usize,
    read: impl Fn(&str) -> Result<T, FileCause>,
) -> Result<Vec<T>, ExchangeError> {
    let wrong = |found| FileCause::WrongCount { what, said, found };
    let mut entries = Vec::with_capacity(said);
    for (line, text) in lines {
        let entry = read(text).map_err(|cause| ExchangeError::at_line(line, cause))?;
        if entries.len() == said {
            return Err(ExchangeError::at_line(line, wrong(said + 1)));
        }
        entries.push(entry);
    }
    if entries.len() != said {
        return Err(ExchangeError::at_line(line_of_sizes, wrong(entries.len())));
    }
    Ok(entries)
}

fn coordinates(
    header: &MarketHeader,
    line: usize,
    text: &str,
    lines: &mut NumberedLines<'_>,
    room: MarketRoom,
) -> Result<Matrix, ExchangeError> {
    let here = |cause| ExchangeError::at_line(line, cause);
    let names = [("rows", 1), ("columns", 1), ("entries", 0)];
    let [rows, columns, said] = sizes(text, "rows, columns and entries", names).map_err(here)?;
    // the shortest line is `1 1 1` with its end
    room.check(said, 5, header.symmetry).map_err(here)?;
    let entries = each_line(lines, "entries", line, said, |text| entry(text, rows, columns, header))?;
    Matrix::from_stored(rows, columns, entries, header.symmetry)
}

fn entry(
    text: &str,
    rows: usize,
    columns: usize,
    header: &MarketHeader,
) -> Result<(usize, usize, f64), FileCause> {
    let words: Vec<&str> = text.split_whitespace().collect();
    let [row, column, value] = words.as_slice() else {
        let (what, expected) = ("an entry", "a row, a column and a number");
        return Err(FileCause::WrongEntries { what, expected, found: words.len() });
    };
    let (row, column) = (count(row, 1, "a row")?, count(column, 1, "a column")?);
    if row > rows || column > columns {
        return Err(FileCause::OutsideMatrix { row, column, rows, columns });
    }
    Ok((row - 1, column - 1, header.value(value)?))
}

impl MarketHeader {
    /// The value of an entry, in the form that the field of the matrix has. A fraction below `integer` is a wrong header or a wrong number:
    /// readers that take integers would cut it.
    fn value(&self, word: &str) -> Result<f64, FileCause> {
        let value = number(word, "an entry of the matrix")?;
        let digits = word.strip_prefix(['+', '-']).unwrap_or(word);
        if self.integer && !digits.bytes().all(|byte| byte.is_ascii_digit()) {
            return Err(FileCause::NotAnInteger { text: quoted(word) });
        }
        Ok(value)
    }
}

/// A dense matrix, column by column; of symmetric ones from the diagonal down.
fn array(
    header: &MarketHeader,
    line: usize,
    text: &str,
    lines: &mut NumberedLines<'_>,
    room: MarketRoom,
) -> Result<Matrix, ExchangeError> {
    let here = |cause| ExchangeError::at_line(line, cause);
    let [rows, columns] = sizes(text, "rows and columns", [("rows", 1), ("columns", 1)]).map_err(here)?;
    let said = dense_entries(rows, columns, header.symmetry).map_err(here)?;
    // the shortest line is `1` with its end
    room.check(said, 2, header.symmetry).map_err(here)?;
    let first = |column: usize| match header.symmetry {
        Symmetry::General => 0,
        Symmetry::Symmetric => column,
        Symmetry::SkewSymmetric => column + 1,
    };
    let what = match header.symmetry {
        Symmetry::General => "entries",
        Symmetry::Symmetric => "entries from the diagonal down",
        Symmetry::SkewSymmetric => "entries below the diagonal",
    };
    let values = each_line(lines, what, line, said, |text| header.value(text))?;
    let places = (0..columns).flat_map(|column| (first(column)..rows).map(move |row| (row, column)));
    let entries = places.zip(values).filter(|(_, value)| *value != 0.0);
    let entries = entries.map(|((row, column), value)| (row, column, value)).collect();
    Matrix::from_stored(rows, columns, entries, header.symmetry)
}

/// How many entries a dense file has.
fn dense_entries(rows: usize, columns: usize, symmetry: Symmetry) -> Result<usize, FileCause> {
    if symmetry != Symmetry::General && rows != columns {
        return Err(FileCause::NotSquare { name: String::from("the matrix"), rows, columns });
    }
    let full = rows.saturating_mul(columns);
    Ok(match symmetry {
        Symmetry::General => full,
        Symmetry::Symmetric => full.saturating_add(rows) / 2,
        Symmetry::SkewSymmetric => (full - rows) / 2,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<Matrix, ExchangeError> {
        read_matrix_market(text.as_bytes(), MemoryBudget::of_bytes(1 << 20))
    }

    #[test]
    fn storages_become_whole_matrices() {
        let general =
            read("%%MatrixMarket matrix coordinate real general\n% a\n\n2 2 3\n1 1 2\n2 1 -1e0\n1 2 3\n");
        assert_eq!(general.unwrap().entries, [(0, 0, 2.0), (0, 1, 3.0), (1, 0, -1.0)]);
        let symmetric =
            read("%%MatrixMarket matrix coordinate integer symmetric\n2 2 2\n1 1 2\n2 1 -1\n").unwrap();
        assert_eq!(symmetric.entries, [(0, 0, 2.0), (0, 1, -1.0), (1, 0, -1.0)]);
        let skew = read("%%MatrixMarket MATRIX array real skew-symmetric\n3 3\n1\n2\n3\n").unwrap();
        assert_eq!((skew.skew_asymmetry(), skew.entries[0]), (0.0, (0, 1, -1.0)));
        let dense = read("%%MatrixMarket matrix array real general\n2 1\n0\n5\n").unwrap();
        assert_eq!(dense.entries, [(1, 0, 5.0)]);
    }

    #[test]
    fn what_is_written_reads_back() {
        for symmetry in [Symmetry::General, Symmetry::Symmetric, Symmetry::SkewSymmetric] {
            let entries = vec![(1, 0, 0.1 + 0.2), (2, 0, -1e-300)];
            let matrix = Matrix::from_stored(3, 3, entries, symmetry).unwrap();
            let mut file = Vec::new();
            write_matrix_market(&mut file, &matrix).unwrap();
            assert_eq!(read_matrix_market(&file, MemoryBudget::of_bytes(1 << 20)).unwrap(), matrix);
        }
        let wrong = Matrix {
            symmetry: Symmetry::Symmetric,
            ..read("%%MatrixMarket matrix array real general\n2 2\n1\n2\n3\n4\n").unwrap()
        };
        assert!(write_matrix_market(&mut Vec::new(), &wrong).unwrap_err().to_string().contains("departs"));
    }

    #[test]
    fn entries_beyond_the_budget_are_refused_before_they_are_read() {
        let text =
            format!("%%MatrixMarket matrix coordinate real symmetric\n9 9 100\n{}", "1 1 1\n".repeat(100));
        let read = |bytes| read_matrix_market(text.as_bytes(), MemoryBudget::of_bytes(bytes));
        assert_eq!(read(7200).unwrap().entries, [(0, 0, 100.0)]);
        let message = read(7199).unwrap_err().to_string();
        assert!(message.starts_with("line 2: the entries of the matrix: 7.2 kB of memory"), "{message}");
    }

    #[test]
    fn damage_is_named_with_its_line() {
        let message = |head: &str, rest: &str| {
            read(&format!("%%MatrixMarket matrix {head}\n{rest}")).unwrap_err().to_string()
        };
        let general = "coordinate real general";
        assert_eq!(message(general, "2 2 2\n1 1 1\n"), "line 2: says 2 entries, holds 1");
        assert!(message(general, "2 2 1\n1 1 1\n1 2 1\n").starts_with("line 4: says 1 entries, holds 2"));
        assert!(message(general, "2 2 99999999999\n").contains("hold"));
        assert!(message(general, "2 2 1\n3 1 1\n").contains("row 3, column 1 (from 1) lies outside"));
        assert!(message(general, "2 2 1\n1 1 inf\n").starts_with("line 3: `inf` is no finite number"));
        assert!(
            message("coordinate complex general", "")
                .starts_with("line 1: the field of the matrix is `complex`")
        );
        assert!(message("coordinate real symmetric", "2 2 2\n1 2 1\n2 1 1\n").contains("both sides"));
        assert!(message("coordinate real symmetric", "2 3 1\n1 1 1\n").contains("2 rows and 3 columns"));
        assert!(message("coordinate real skew-symmetric", "1 1 1\n1 1 1\n").contains("on its diagonal"));
        assert!(message("array real general", "2 2\n1\n2\n3\n").contains("says 4 entries, holds 3"));
        assert!(message("array real general", "4000000000 4000000000\n1\n").contains("says 1"));
        let fraction = message("coordinate integer general", "2 2 2\n1 1 -3\n2 2 1.5\n");
        assert!(fraction.starts_with("line 4: `1.5` is no integer"), "{fraction}");
        assert!(message("array integer general", "1 1\n2e0\n").starts_with("line 3: `2e0` is no integer"));
        assert!(read("%%MatrixMarket tensor\n").unwrap_err().to_string().contains("should be, say"));
    }
}
