//! The dotted path of a place in the text of a case.

use super::{Data, Node, name_of, parse};
use crate::error::Place;
use std::ops::Range;

/// The dotted path of the innermost key that has these bytes of a text, items of lists by their names or else their positions, from 0; nothing where no key
/// has them, or the text is not TOML.
pub(crate) fn path_at(text: &str, bytes: &Range<usize>) -> Option<String> {
    steps(&parse(text).ok()?, bytes).map(|steps| steps.join("."))
}

/// The steps below a node, the last of them first found.
fn steps(node: &Node, bytes: &Range<usize>) -> Option<Vec<String>> {
    let below = |step: &str, node: &Node, is_here: bool| {
        let found = steps(node, bytes).or_else(|| (is_here || holds(node.place, bytes)).then(Vec::new))?;
        Some([vec![step.to_owned()], found].concat())
    };
    match &node.data {
        Data::Table(table) => {
            let mut entries = table.entries.iter();
            entries.find_map(|entry| below(&entry.key, &entry.node, holds(entry.place, bytes)))
        }
        Data::List(items) => {
            let mut numbered = items.iter().enumerate();
            numbered.find_map(|(index, item)| below(&step_to(items, index), item, false))
        }
        _ => None,
    }
}

fn holds(place: Place, bytes: &Range<usize>) -> bool {
    place.start <= bytes.start && bytes.end <= place.end
}

/// The name of an item where no other has it, and no dot is in it; else its position.
fn step_to(items: &[Node], index: usize) -> String {
    let named = items.get(index).and_then(name_of).filter(|name| !name.contains('.'));
    let is_alone = |name: &&str| items.iter().filter(|item| name_of(item) == Some(name)).count() == 1;
    named.filter(is_alone).map_or_else(|| index.to_string(), str::to_owned)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn path_of(text: &str, part: &str) -> Option<String> {
        let start = text.find(part).unwrap();
        path_at(text, &(start..start + part.len()))
    }

    #[test]
    fn places_have_the_paths_of_their_keys() {
        let text = "model = \"belt\"\n[operation]\nvelocty = -3\n[[analysis]]\nname = \"map\"\nx = { from = -1 }\n\
                    [[analysis]]\nkind = \"a\"\n[[analysis]]\nkind = \"a\"\nvalues = [1, \"two\"]\n";
        for (part, path) in [
            ("\"belt\"", "model"),
            ("elt", "model"),
            ("velocty", "operation.velocty"),
            ("-3", "operation.velocty"),
            ("-1", "analysis.map.x.from"),
            ("from", "analysis.map.x.from"),
            ("{ from = -1 }", "analysis.map.x"),
            ("\"two\"", "analysis.2.values.1"),
        ] {
            assert_eq!(path_of(text, part).as_deref(), Some(path), "{part}");
        }
        assert_eq!(path_of(text, text), None);
        assert_eq!(path_at("a = ", &(0..1)), None);
        assert_eq!(path_at("", &(0..0)), None);
        assert_eq!(path_of("operation.velocity={ a = 1 }", "1").as_deref(), Some("operation.velocity.a"));
    }
}
