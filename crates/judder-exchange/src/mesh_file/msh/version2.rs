//! The format 2.2: nodes with their places, elements with their tags, one after the other.
//!
//! *Gmsh Reference Manual*, MSH file format, version 2 (legacy). An element that is in several physical groups stands there once for each,
//! with a number of its own every time: it is one element of the mesh.

use super::element_type::{GmshType, gmsh_type};
use super::sections::{ElementBlock, Sections, unsupported};
use super::source::MshSource;
use crate::cause::FileCause;
use crate::error::ExchangeError;
use crate::text::{check_room, count};
use std::collections::{BTreeMap, HashMap, HashSet};

/// An element with the physical groups in which it was found.
struct TaggedElement {
    label: usize,
    number: i64,
    of_type: GmshType,
    groups: Vec<i64>,
    /// Places of nodes, in Gmsh's order.
    nodes: Vec<usize>,
}

/// What tells that an element stands there once more: its type, its elementary entity and its nodes, sorted.
type ElementKey = (i64, i64, Vec<usize>);

/// The elements of a file and where each of them is among them.
#[derive(Default)]
struct TaggedElements {
    elements: Vec<TaggedElement>,
    found: HashMap<ElementKey, usize>,
}

/// How elements that follow each other are headed: one in a text, many in a binary file.
struct ElementHeader {
    number: i64,
    of_type: GmshType,
    tags: usize,
}

/// The number of things in a section, a line of text in binary files as well.
fn said(source: &mut MshSource<'_>, bytes_each: usize, what: &'static str) -> Result<usize, ExchangeError> {
    let line = source.line()?.unwrap_or("");
    let said = count(line, 0, what).map_err(|cause| source.error(cause))?;
    // the last word of a text may lack its end
    check_room(said, bytes_each, source.left_bytes() + 1, what).map_err(|cause| source.error(cause))?;
    source.begin_numbers();
    Ok(said)
}

impl Sections {
    /// `$Nodes`: a number and a place each.
    pub(super) fn read_nodes_of_2(&mut self, source: &mut MshSource<'_>) -> Result<(), ExchangeError> {
        // a number and three places, of a digit and a space each
        let said = said(source, 8, "nodes")?;
        for _ in 0..said {
            let label = source.whole("a number of a node")?;
            let what = "a place of a node";
            let place = [source.double(what)?, source.double(what)?, source.double(what)?];
            if let Some(place) = self.places.insert(label, self.parts.nodes.len()) {
                let (label, first) = (label.to_string(), format!("as number {} of the list", place + 1));
                return Err(source.error(FileCause::Twice { what: "node", label, first }));
            }
            self.parts.nodes.push((label, place));
        }
        Ok(())
    }

    /// `$Elements`: a number, tags (the physical group, the elementary entity, what else there is) and nodes each.
    pub(super) fn read_elements_of_2(&mut self, source: &mut MshSource<'_>) -> Result<(), ExchangeError> {
        // a number, a type, the number of tags and a node, of a digit and a space each
        let said = said(source, 8, "elements")?;
        let (mut all, mut labels) = (TaggedElements::default(), HashSet::new());
        let mut found = 0;
        while found < said {
            let (header, follow, number) = if source.is_text() {
                let number = source.whole("a number of an element")?;
                (self::header(source)?, 1, Some(number))
            } else {
                let (header, follow) = binary_header(source)?;
                (header, follow, None)
            };
            found += follow;
            if found > said {
                return Err(source.error(FileCause::WrongCount { what: "elements", said, found }));
            }
            for _ in 0..follow {
                let number = match number {
                    Some(number) => number,
                    None => source.whole("a number of an element")?,
                };
                if !labels.insert(number) {
                    let (label, first) = (number.to_string(), String::from("before in the list"));
                    return Err(source.error(FileCause::Twice { what: "element", label, first }));
                }
                self.read_element(source, &header, number, &mut all)?;
            }
        }
        self.add_blocks(all.elements);
        Ok(())
    }

    /// Tags and nodes.
    fn read_element(
        &self,
        source: &mut MshSource<'_>,
        header: &ElementHeader,
        label: usize,
        all: &mut TaggedElements,
    ) -> Result<(), ExchangeError> {
        let mut tags = [0; 2];
        for k in 0..header.tags {
            let tag = source.int("a tag of an element")?;
            if let Some(kept) = tags.get_mut(k) {
                *kept = tag;
            }
        }
        let mut nodes = Vec::with_capacity(header.of_type.nodes);
        for _ in 0..header.of_type.nodes {
            let node = source.whole("a node of an element")?;
            let unknown = || source.error(FileCause::Unknown { what: "node", label: node.to_string() });
            nodes.push(*self.places.get(&node).ok_or_else(unknown)?);
        }
        // the sign tells an orientation, zero no group
        let [group, entity] = [tags[0].saturating_abs(), tags[1]];
        let groups: Vec<i64> = Some(group).filter(|group| *group > 0).into_iter().collect();
        let element = TaggedElement { label, number: header.number, of_type: header.of_type, groups, nodes };
        all.add(entity, element);
        Ok(())
    }

    /// Elements of one type in the same physical groups are a block; what is called its entity is the number of the block.
    fn add_blocks(&mut self, elements: Vec<TaggedElement>) {
        let mut places: BTreeMap<(i64, Vec<i64>), usize> = BTreeMap::new();
        let first = self.blocks.len();
        for element in elements {
            let TaggedElement { label, number, of_type, groups, nodes } = element;
            let next = self.blocks.len();
            let place = *places.entry((number, groups)).or_insert_with_key(|(_, groups)| {
                let (dimension, entity) = (of_type.dimension, (next - first) as i64);
                self.groups.insert((dimension, entity), groups.clone());
                let (labels, nodes) = (Vec::new(), Vec::new());
                self.blocks.push(ElementBlock { of_type, dimension, entity, labels, nodes, number });
                next
            });
            self.blocks[place].labels.push(label);
            self.blocks[place].nodes.extend(nodes);
        }
    }
}

impl TaggedElements {
    /// One more, or one more group of an element that is there. Twice in the same group it is two, as the file says.
    fn add(&mut self, entity: i64, element: TaggedElement) {
        let mut sorted = element.nodes.clone();
        sorted.sort_unstable();
        let next = self.elements.len();
        let place = *self.found.entry((element.number, entity, sorted)).or_insert(next);
        match self.elements.get_mut(place) {
            Some(there) if !element.groups.iter().any(|group| there.groups.contains(group)) => {
                there.groups.extend(element.groups);
            }
            _ => self.elements.push(element),
        }
    }
}

fn header(source: &mut MshSource<'_>) -> Result<ElementHeader, ExchangeError> {
    let number = source.int("a type of elements")?;
    let of_type = gmsh_type(number).ok_or_else(|| source.error(unsupported(number)))?;
    Ok(ElementHeader { number, of_type, tags: source.int_count(1, "tags")? })
}

/// The type, how many elements follow and the tags that each of them has.
fn binary_header(source: &mut MshSource<'_>) -> Result<(ElementHeader, usize), ExchangeError> {
    let number = source.int("a type of elements")?;
    let of_type = gmsh_type(number).ok_or_else(|| source.error(unsupported(number)))?;
    let follow = source.int_count(1 + of_type.nodes, "elements")?;
    if follow == 0 {
        let problem = String::from("it has no elements");
        return Err(source.error(FileCause::Inconsistent { what: "a block of elements", problem }));
    }
    Ok((ElementHeader { number, of_type, tags: source.int_count(follow, "tags")? }, follow))
}

#[cfg(test)]
mod tests {
    use crate::mesh_file::msh::read_msh;

    /// Two quadrilaterals; the first stands there for each of its two groups, as Gmsh writes it, turned in the second.
    fn text(second: &str) -> String {
        format!(
            "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n2 1 \"all\"\n2 2 \"left\"\n$EndPhysicalNames\n$Nodes\n6\n\
             1 0 0 0\n2 1 0 0\n3 2 0 0\n4 0 1 0\n5 1 1 0\n6 2 1 0\n$EndNodes\n$Elements\n3\n1 3 2 1 7 1 2 5 4\n{second}\n\
             3 3 2 1 8 2 3 6 5\n$EndElements\n"
        )
    }

    #[test]
    fn an_element_of_two_groups_is_one_element() {
        let file = read_msh(text("2 3 2 -2 7 1 4 5 2").as_bytes()).unwrap();
        assert_eq!(file.mesh.elements(), 2);
        assert_eq!(file.mesh.element_sets["all"].len(), 2);
        assert_eq!(file.mesh.element_sets["left"], [0]);
        assert_eq!(file.element_labels, [1, 3]);
    }

    /// As in the format 4.1, where it stands.
    #[test]
    fn what_is_twice_in_one_group_stays_twice() {
        let file = read_msh(text("2 3 2 1 7 1 2 5 4").as_bytes()).unwrap();
        assert_eq!(file.mesh.elements(), 3);
    }

    #[test]
    fn damage_is_named_with_its_line() {
        let message = |from: &str, to: &str| {
            let damaged = text("2 3 2 2 7 1 2 5 4").replacen(from, to, 1);
            read_msh(damaged.as_bytes()).unwrap_err().to_string()
        };
        assert!(message("$Nodes\n6", "$Nodes\n600000000").starts_with("line 10: says 600000000 nodes"));
        assert!(message("$Elements\n3", "$Elements\n4").starts_with("line 23: `$EndElements` is no whole"));
        assert!(message("1 3 2 1 7 1", "1 3 20000000 1 7 1").contains("says 20000000 tags"));
        assert!(message("1 2 5 4", "1 2 5 9").starts_with("line 20: there is no node 9"));
        assert!(message("3 3 2 1 8", "1 3 2 1 8").contains("element 1 is there twice"));
        assert!(message("6 2 1 0\n", "5 2 1 0\n").contains("node 5 is there twice"));
        assert!(message("1 3 2 1 7", "1 99 2 1 7").contains("the type of elements is 99"));
        assert!(message("2.2", "2.0").contains("its version is 2.0"));
    }
}
