//! Tables of degrees of freedom: what the rows of a matrix are.

use crate::cause::FileCause;
use crate::door::bytes_of;
use crate::error::ExchangeError;
use crate::text::{count, number, text_of};
use judder_memory::MemoryBudget;
use judder_structure::freedom::{Direction, Freedom};
use std::collections::BTreeMap;
use std::io::Write;
use std::path::Path;

/// Bytes of memory a byte of the file: a row of a dozen letters is a freedom in the table, and twice in what finds doubles.
const MEMORY_A_BYTE: u64 = 16;

const COLUMNS: [&str; 5] = ["node", "direction", "x", "y", "z"];

/// Reads a table of degrees of freedom, one row of it for each row of the matrices, in their order.
///
/// The file is CSV text. Its header names the columns `node` (a number), `direction` (x, y, z, or 1, 2, 3), `x`, `y` and `z` (the
/// node's place in m); they may stand in any order, with others beside them. Lines that begin with `#` are passed over.
///
/// # Errors
/// What is wrong, with its line: a missing column, a row that is too short, what is no number or direction, a freedom that is
/// there twice ([`FileCause::Twice`]), a node in two places.
pub fn read_freedoms(path: &Path) -> Result<Vec<Freedom>, ExchangeError> {
    let bytes = bytes_of(path, MEMORY_A_BYTE, MemoryBudget::of_process())?;
    read(&bytes).map_err(|error| error.in_file(path))
}

/// Writes a table as [`read_freedoms`] reads it, each row with its number, from 1.
///
/// # Errors
/// [`FileCause::Unwritable`].
pub fn write_freedoms(to: &mut dyn Write, freedoms: &[Freedom]) -> Result<(), ExchangeError> {
    writeln!(to, "row,{}", COLUMNS.join(","))?;
    for (k, Freedom { node, direction, place: [x, y, z] }) in freedoms.iter().enumerate() {
        writeln!(to, "{},{node},{direction},{x:?},{y:?},{z:?}", k + 1)?;
    }
    Ok(())
}

fn read(bytes: &[u8]) -> Result<Vec<Freedom>, ExchangeError> {
    let numbered = text_of(bytes)?.lines().enumerate().map(|(k, line)| (k + 1, line.trim()));
    let mut lines = numbered.filter(|(_, line)| !line.is_empty() && !line.starts_with('#'));
    let (line, header) = lines.next().unwrap_or((1, ""));
    let places = columns(header).map_err(|cause| ExchangeError::at_line(line, cause))?;
    let mut freedoms = Vec::new();
    let mut seen = Seen::default();
    for (line, text) in lines {
        let row = freedom(text, &places).and_then(|freedom| seen.add(freedom, line).map(|()| freedom));
        freedoms.push(row.map_err(|cause| ExchangeError::at_line(line, cause))?);
    }
    Ok(freedoms)
}

/// Where each of the needed columns stands.
fn columns(header: &str) -> Result<[usize; 5], FileCause> {
    let names: Vec<String> = entries(header).map(str::to_ascii_lowercase).collect();
    let mut places = [0; 5];
    for (place, name) in places.iter_mut().zip(COLUMNS) {
        *place =
            names.iter().position(|found| found == name).ok_or(FileCause::MissingColumn { missing: name })?;
    }
    Ok(places)
}

fn entries(line: &str) -> impl Iterator<Item = &str> {
    line.split(',').map(|entry| entry.trim().trim_matches('"'))
}

fn freedom(line: &str, places: &[usize; 5]) -> Result<Freedom, FileCause> {
    let words: Vec<&str> = entries(line).collect();
    let needed = places.iter().max().map_or(0, |last| last + 1);
    if words.len() < needed {
        let (what, expected) = ("a row", "an entry for each of node, direction, x, y and z");
        return Err(FileCause::WrongEntries { what, expected, found: words.len() });
    }
    let [node, way, x, y, z] = places.map(|place| words[place]);
    let at = |word| number(word, "a place in m");
    Ok(Freedom {
        node: count(node, 0, "a node")?,
        direction: direction(way)?,
        place: [at(x)?, at(y)?, at(z)?],
    })
}

fn direction(word: &str) -> Result<Direction, FileCause> {
    match word {
        "x" | "X" | "1" => Ok(Direction::X),
        "y" | "Y" | "2" => Ok(Direction::Y),
        "z" | "Z" | "3" => Ok(Direction::Z),
        _ => Err(FileCause::NotADirection { text: crate::quoted::quoted(word) }),
    }
}

/// Freedoms and nodes that were there already.
#[derive(Default)]
struct Seen {
    freedoms: BTreeMap<(usize, Direction), usize>,
    nodes: BTreeMap<usize, ([f64; 3], usize)>,
}

impl Seen {
    fn add(&mut self, freedom: Freedom, line: usize) -> Result<(), FileCause> {
        let Freedom { node, direction, place } = freedom;
        if let Some(first) = self.freedoms.insert((node, direction), line) {
            let (what, label) = ("the freedom", format!("{direction} of node {node}"));
            return Err(FileCause::Twice { what, label, first: format!("in line {first}") });
        }
        match self.nodes.insert(node, (place, line)) {
            Some((other, first)) if other != place => Err(FileCause::Inconsistent {
                what: "the place of a node",
                problem: format!("node {node} is at {place:?} here and at {other:?} in line {first}"),
            }),
            _ => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_may_stand_in_any_order() {
        let table = "# of a pad\nx,y,z,Direction,node,note\n0.5,0,-1e-3,x,7,a\n0.5,0,-1e-3,3,7,b\n";
        let freedoms = read(table.as_bytes()).unwrap();
        let place = [0.5, 0.0, -1e-3];
        let expected = [Direction::X, Direction::Z].map(|direction| Freedom { node: 7, direction, place });
        assert_eq!(freedoms, expected);
    }

    #[test]
    fn what_is_written_is_read() {
        let freedom = |node, direction| Freedom { node, direction, place: [0.1 + 0.2, -1e-300, 3e8] };
        let freedoms = [freedom(7, Direction::Y), freedom(1, Direction::X)];
        let mut table = Vec::new();
        write_freedoms(&mut table, &freedoms).unwrap();
        assert!(table.starts_with(b"row,node,direction,x,y,z\n1,7,y,0.30000000000000004,"));
        assert_eq!(read(&table).unwrap(), freedoms);
    }

    #[test]
    fn wrong_rows_are_named() {
        let message =
            |rows: &str| read(format!("node,direction,x,y,z\n{rows}").as_bytes()).unwrap_err().to_string();
        assert!(message("1,x,0,0").starts_with("line 2: a row takes"));
        assert!(message("1,w,0,0,0").contains("`w` is no direction"));
        assert!(message("-1,x,0,0,0").contains("`-1` is no whole number"));
        assert!(message("1,x,nan,0,0").contains("`nan` is no finite number"));
        assert!(message("1,x,0,0,0\n1,1,0,0,0").contains("x of node 1 is there twice, first in line 2"));
        assert!(message("1,x,0,0,0\n1,y,1,0,0").contains("node 1 is at"));
        assert_eq!(
            read(b"node,x,y,z").unwrap_err().to_string(),
            "line 1: the header of the table lacks the column `direction`; it needs node, direction, x, y, z"
        );
        assert!(read(b"").is_err());
    }
}
