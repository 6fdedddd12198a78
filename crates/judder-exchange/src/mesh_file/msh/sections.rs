//! The sections of a `.msh` file.

use super::element_type::{GmshType, READ, gmsh_type};
use super::source::MshSource;
use crate::cause::FileCause;
use crate::error::ExchangeError;
use crate::mesh_file::building::FileParts;
use crate::quoted::quoted;
use crate::text::{check_room, count};
use std::collections::{BTreeMap, HashMap, HashSet};

/// Elements of one type on one entity.
pub(super) struct ElementBlock {
    pub(super) of_type: GmshType,
    pub(super) dimension: usize,
    pub(super) entity: i64,
    pub(super) labels: Vec<usize>,
    /// Places of nodes, in Gmsh's order.
    pub(super) nodes: Vec<usize>,
    /// Gmsh's number of the type.
    pub(super) number: i64,
}

/// What the sections hold.
#[derive(Default)]
pub(super) struct Sections {
    /// Names by dimension and number of the physical group.
    pub(super) names: BTreeMap<(usize, i64), String>,
    /// Physical groups by dimension and number of the entity.
    pub(super) groups: BTreeMap<(usize, i64), Vec<i64>>,
    pub(super) blocks: Vec<ElementBlock>,
    pub(super) places: HashMap<usize, usize>,
    pub(super) parts: FileParts,
}

impl Sections {
    /// `$PhysicalNames`, a text in binary files as well: dimension, number and name in quotes.
    pub(super) fn read_names(&mut self, source: &mut MshSource<'_>) -> Result<(), ExchangeError> {
        let line = source.line()?.unwrap_or("");
        let said = count(line, 0, "physical names").map_err(|cause| source.error(cause))?;
        for found in 0..said {
            let line = source.line()?.unwrap_or("$");
            if line.starts_with('$') {
                return Err(source.error(FileCause::WrongCount { what: "physical names", said, found }));
            }
            let (dimension, number, name) = physical_name(line).map_err(|cause| source.error(cause))?;
            if let Some(first) = self.names.insert((dimension, number), name) {
                let label = format!("{number} of dimension {dimension}");
                let first = format!("as `{}`", quoted(&first));
                return Err(source.error(FileCause::Twice { what: "physical group", label, first }));
            }
        }
        Ok(())
    }

    /// `$Entities`: which physical groups each point, curve, surface and volume is in.
    pub(super) fn read_entities(&mut self, source: &mut MshSource<'_>) -> Result<(), ExchangeError> {
        source.begin_numbers();
        let what = "entities";
        let counts = [source.size(what)?, source.size(what)?, source.size(what)?, source.size(what)?];
        for (dimension, said) in counts.into_iter().enumerate() {
            check_room(said, 5, source.left_bytes(), what).map_err(|cause| source.error(cause))?;
            // a point has its place, all others the corners of their box
            let places = if dimension == 0 { 3 } else { 6 };
            for _ in 0..said {
                let entity = source.int(what)?;
                for _ in 0..places {
                    source.double("the box of an entity")?;
                }
                let groups = source.number_of(1, "physical groups")?;
                let groups =
                    (0..groups).map(|_| source.int("a physical group")).collect::<Result<Vec<i64>, _>>()?;
                if dimension > 0 {
                    for _ in 0..source.number_of(1, "bounding entities")? {
                        source.int("a bounding entity")?;
                    }
                }
                // the sign tells an orientation
                self.groups
                    .insert((dimension, entity), groups.into_iter().map(i64::saturating_abs).collect());
            }
        }
        Ok(())
    }

    /// `$Nodes`: blocks of numbers, then of places.
    pub(super) fn read_nodes(&mut self, source: &mut MshSource<'_>) -> Result<(), ExchangeError> {
        source.begin_numbers();
        let blocks = source.number_of(4, "blocks of nodes")?;
        let said = source.number_of(4, "nodes")?;
        source.size("the smallest number of a node")?;
        source.size("the largest number of a node")?;
        for _ in 0..blocks {
            let dimension = source.int("the dimension of an entity")?.clamp(0, 3) as usize;
            source.int("an entity")?;
            let parameters = if source.int("whether places have parameters")? == 0 { 0 } else { dimension };
            let own = source.number_of(4, "nodes")?;
            let mut labels = Vec::with_capacity(own);
            for _ in 0..own {
                let label = source.size("a number of a node")?;
                if let Some(place) = self.places.insert(label, self.parts.nodes.len() + labels.len()) {
                    let first = format!("as number {} of the list", place + 1);
                    return Err(source.error(FileCause::Twice {
                        what: "node",
                        label: label.to_string(),
                        first,
                    }));
                }
                labels.push(label);
            }
            for label in labels {
                let what = "a place of a node";
                let place = [source.double(what)?, source.double(what)?, source.double(what)?];
                for _ in 0..parameters {
                    source.double("a parameter of a node")?;
                }
                self.parts.nodes.push((label, place));
            }
        }
        let found = self.parts.nodes.len();
        if found == said {
            Ok(())
        } else {
            Err(source.error(FileCause::WrongCount { what: "nodes", said, found }))
        }
    }

    /// `$Elements`: blocks of numbers with their nodes.
    pub(super) fn read_elements(&mut self, source: &mut MshSource<'_>) -> Result<(), ExchangeError> {
        source.begin_numbers();
        let blocks = source.number_of(4, "blocks of elements")?;
        let said = source.number_of(2, "elements")?;
        source.size("the smallest number of an element")?;
        source.size("the largest number of an element")?;
        let (mut found, mut seen) = (0, HashSet::new());
        for _ in 0..blocks {
            let block = self.read_block(source)?;
            found += block.labels.len();
            if let Some(label) = block.labels.iter().find(|label| !seen.insert(**label)) {
                let (label, first) = (label.to_string(), String::from("before in the list"));
                return Err(source.error(FileCause::Twice { what: "element", label, first }));
            }
            self.blocks.push(block);
        }
        if found == said {
            Ok(())
        } else {
            Err(source.error(FileCause::WrongCount { what: "elements", said, found }))
        }
    }

    fn read_block(&self, source: &mut MshSource<'_>) -> Result<ElementBlock, ExchangeError> {
        let dimension = source.int("the dimension of an entity")?;
        let entity = source.int("an entity")?;
        let number = source.int("a type of elements")?;
        let of_type = gmsh_type(number).ok_or_else(|| source.error(unsupported(number)))?;
        let dimension =
            usize::try_from(dimension).ok().filter(|own| *own == of_type.dimension).ok_or_else(|| {
                let problem =
                    format!("type {number} has {} dimensions, its entity {dimension}", of_type.dimension);
                source.error(FileCause::Inconsistent { what: "a block of elements", problem })
            })?;
        let count = source.number_of(1 + of_type.nodes, "elements")?;
        let mut labels = Vec::with_capacity(count);
        let mut nodes = Vec::with_capacity(count * of_type.nodes);
        for _ in 0..count {
            labels.push(source.size("a number of an element")?);
            for _ in 0..of_type.nodes {
                let label = source.size("a node of an element")?;
                let unknown = || source.error(FileCause::Unknown { what: "node", label: label.to_string() });
                nodes.push(*self.places.get(&label).ok_or_else(unknown)?);
            }
        }
        Ok(ElementBlock { of_type, dimension, entity, labels, nodes, number })
    }
}

/// Elements of a type that has no counterpart.
pub(super) fn unsupported(number: i64) -> FileCause {
    FileCause::Unsupported { what: "the type of elements", found: number.to_string(), read: READ }
}

fn physical_name(line: &str) -> Result<(usize, i64, String), FileCause> {
    let (numbers, name) = line.split_once('"').unwrap_or((line, ""));
    let words: Vec<&str> = numbers.split_whitespace().collect();
    let ([dimension, number], Some(name)) = (words.as_slice(), name.strip_suffix('"')) else {
        let (what, expected) = ("a physical name", "a dimension, a number and a name in quotes");
        return Err(FileCause::WrongEntries { what, expected, found: line.split_whitespace().count() });
    };
    let dimension = count(dimension, 0, "a dimension")?;
    let number = count(number, 0, "a number of a physical group")?;
    Ok((dimension, i64::try_from(number).unwrap_or(i64::MAX), name.to_owned()))
}
