//! The model of a deck as it grows from keyword to keyword.

use super::deck::{Keyword, words};
use super::element_type::{ElementType, element_type};
use super::sets::{NumberSpan, Sets, places};
use crate::cause::FileCause;
use crate::error::ExchangeError;
use crate::mesh_file::{FileMaterial, Warning};
use crate::quoted::quoted;
use crate::text::{count, number};
use std::collections::{BTreeMap, HashMap};

/// An element of a deck.
pub(super) struct DeckElement {
    pub(super) label: usize,
    pub(super) of_type: ElementType,
    /// Numbers of the file.
    pub(super) nodes: Vec<usize>,
    /// The set that its keyword names.
    pub(super) set: Option<String>,
    pub(super) line: usize,
}

/// A line of a surface: sides of this number of these elements.
pub(super) struct SurfaceLine {
    pub(super) elements: Vec<NumberSpan>,
    pub(super) side: usize,
    pub(super) line: usize,
}

/// `*SOLID SECTION`.
pub(super) struct SolidSection {
    pub(super) set: String,
    pub(super) material: String,
    pub(super) thickness: f64,
    pub(super) line: usize,
}

/// All that was read.
pub(super) struct DeckModel {
    pub(super) nodes: Vec<(usize, [f64; 3])>,
    pub(super) node_places: HashMap<usize, usize>,
    pub(super) elements: Vec<DeckElement>,
    pub(super) element_places: HashMap<usize, usize>,
    pub(super) node_sets: Sets,
    pub(super) element_sets: Sets,
    pub(super) surfaces: BTreeMap<String, Vec<SurfaceLine>>,
    /// By names in capitals: the name as written, and what it holds.
    pub(super) materials: BTreeMap<String, (String, FileMaterial)>,
    material: Option<String>,
    pub(super) sections: Vec<SolidSection>,
    parts: usize,
    instances: usize,
    pub(super) warnings: Vec<Warning>,
}

impl DeckModel {
    /// The model of a deck of so many bytes.
    pub(super) fn new(bytes: usize) -> Self {
        Self {
            nodes: Vec::new(),
            node_places: HashMap::new(),
            elements: Vec::new(),
            element_places: HashMap::new(),
            node_sets: Sets::new(bytes),
            element_sets: Sets::new(bytes),
            surfaces: BTreeMap::new(),
            materials: BTreeMap::new(),
            material: None,
            sections: Vec::new(),
            parts: 0,
            instances: 0,
            warnings: Vec::new(),
        }
    }

    pub(super) fn warn(&mut self, line: usize, text: String) {
        self.warnings.push(Warning { line: Some(line), text });
    }

    pub(super) fn read_nodes(&mut self, keyword: &Keyword<'_>) -> Result<(), ExchangeError> {
        self.refuse_input(keyword)?;
        if keyword.capitals("SYSTEM").is_some_and(|system| system != "R") {
            let (what, found) = ("the system of the nodes", String::from("not rectangular"));
            return Err(keyword.error(FileCause::Unsupported { what, found, read: "SYSTEM=R" }));
        }
        for (line, text) in &keyword.data {
            let here = |cause| ExchangeError::at_line(*line, cause);
            let (label, place) = node(text).map_err(here)?;
            if let Some(first) = self.node_places.insert(label, self.nodes.len()) {
                return Err(here(twice("node", label, &format!("at {:?}", self.nodes[first].1))));
            }
            self.nodes.push((label, place));
            if let Some(set) = keyword.parameters.get("NSET") {
                self.node_sets.add(set, &[NumberSpan::one(label, *line)]).map_err(here)?;
            }
        }
        Ok(())
    }

    pub(super) fn read_elements(&mut self, keyword: &Keyword<'_>) -> Result<(), ExchangeError> {
        self.refuse_input(keyword)?;
        let here = |cause| keyword.error(cause);
        let name = keyword.needed("TYPE").map_err(here)?.to_ascii_uppercase();
        let of_type = element_type(&name).map_err(here)?;
        if let Some(difference) = of_type.difference {
            self.warn(keyword.line, format!("{name} {difference}"));
        }
        let set = keyword.parameters.get("ELSET").cloned();
        let mut numbers: Vec<usize> = Vec::with_capacity(1 + of_type.kind.nodes());
        for (k, (line, text)) in keyword.data.iter().enumerate() {
            let here = |cause| ExchangeError::at_line(*line, cause);
            for word in words(text) {
                numbers.push(count(word, 1, "a number of an element or node").map_err(here)?);
            }
            if text.ends_with(',') && k + 1 < keyword.data.len() && numbers.len() <= of_type.kind.nodes() {
                continue;
            }
            self.add_element(&numbers, of_type, set.as_ref(), *line).map_err(here)?;
            numbers.clear();
        }
        Ok(())
    }

    fn add_element(
        &mut self,
        numbers: &[usize],
        of_type: ElementType,
        set: Option<&String>,
        line: usize,
    ) -> Result<(), FileCause> {
        let needed = of_type.kind.nodes();
        let (label, nodes) = match numbers.split_first() {
            Some((label, nodes)) if nodes.len() == needed => (*label, nodes.to_vec()),
            _ => {
                let nodes = numbers.len().saturating_sub(1);
                return Err(FileCause::WrongNodes { kind: of_type.kind, needed, found: nodes });
            }
        };
        if let Some(first) = self.element_places.insert(label, self.elements.len()) {
            return Err(twice("element", label, &format!("in line {}", self.elements[first].line)));
        }
        if let Some(set) = set {
            self.element_sets.add(set, &[NumberSpan::one(label, line)])?;
        }
        self.elements.push(DeckElement { label, of_type, nodes, set: set.cloned(), line });
        Ok(())
    }

    pub(super) fn read_node_set(&mut self, keyword: &Keyword<'_>) -> Result<(), ExchangeError> {
        let name = keyword.needed("NSET").map_err(|cause| keyword.error(cause))?;
        let Some(elements) = keyword.parameters.get("ELSET") else {
            return self.node_sets.read(keyword, name, "node");
        };
        let unknown = || keyword.error(FileCause::Unknown { what: "set", label: quoted(elements) });
        let set = self.element_sets.get(elements).ok_or_else(unknown)?;
        let elements = places(&set.spans, &self.element_places, "element")?;
        let mut nodes: Vec<usize> =
            elements.iter().flat_map(|element| self.elements[*element].nodes.iter().copied()).collect();
        nodes.sort_unstable();
        nodes.dedup();
        let spans: Vec<NumberSpan> =
            nodes.into_iter().map(|node| NumberSpan::one(node, keyword.line)).collect();
        self.node_sets.add(name, &spans).map_err(|cause| keyword.error(cause))
    }

    pub(super) fn read_element_set(&mut self, keyword: &Keyword<'_>) -> Result<(), ExchangeError> {
        let name = keyword.needed("ELSET").map_err(|cause| keyword.error(cause))?;
        self.element_sets.read(keyword, name, "element")
    }

    pub(super) fn read_surface(&mut self, keyword: &Keyword<'_>) -> Result<(), ExchangeError> {
        let name = keyword.needed("NAME").map_err(|cause| keyword.error(cause))?;
        match keyword.capitals("TYPE").as_deref() {
            None | Some("ELEMENT") => {}
            Some("NODE") => return self.read_node_surface(keyword, name),
            Some(other) => {
                let (what, found) = ("the type of the surface", format!("`{}`", quoted(other)));
                return Err(keyword.error(FileCause::Unsupported { what, found, read: "ELEMENT or NODE" }));
            }
        }
        let mut lines = Vec::new();
        for (line, text) in &keyword.data {
            let mut read = || {
                let words = words(text);
                let [elements, side] = words.as_slice() else {
                    let (what, expected) = ("a line of a surface", "an element or set and a side");
                    return Err(FileCause::WrongEntries { what, expected, found: words.len() });
                };
                let elements = self.element_sets.named(elements, *line, "element")?;
                self.element_sets.charge(&elements)?;
                Ok(SurfaceLine { elements, side: side_number(side)?, line: *line })
            };
            lines.push(read().map_err(|cause| ExchangeError::at_line(*line, cause))?);
        }
        if self.surfaces.insert(name.to_owned(), lines).is_some() {
            return Err(keyword.error(twice("surface", name, "in an earlier line")));
        }
        Ok(())
    }

    /// Of nodes only: a set of them.
    fn read_node_surface(&mut self, keyword: &Keyword<'_>, name: &str) -> Result<(), ExchangeError> {
        for (line, text) in &keyword.data {
            let word = words(text)[0];
            let spans = self.node_sets.named(word, *line, "node");
            let added = spans.and_then(|spans| self.node_sets.add(name, &spans));
            added.map_err(|cause| ExchangeError::at_line(*line, cause))?;
        }
        Ok(())
    }

    pub(super) fn read_material(&mut self, keyword: &Keyword<'_>) -> Result<(), ExchangeError> {
        let name = keyword.needed("NAME").map_err(|cause| keyword.error(cause))?;
        let key = name.to_ascii_uppercase();
        let new = (name.to_owned(), FileMaterial::default());
        if self.materials.insert(key.clone(), new).is_some() {
            return Err(keyword.error(twice("material", name, "in an earlier line")));
        }
        self.material = Some(key);
        Ok(())
    }

    pub(super) fn read_elastic(&mut self, keyword: &Keyword<'_>) -> Result<(), ExchangeError> {
        if keyword.capitals("TYPE").is_some_and(|kind| !kind.starts_with("ISO")) {
            let (what, found) = ("the elasticity", String::from("not isotropic"));
            return Err(keyword.error(FileCause::Unsupported { what, found, read: "TYPE=ISOTROPIC" }));
        }
        let [youngs_modulus, poisson_ratio] = constants(keyword, "Young's modulus and Poisson's ratio")?;
        self.current_material(keyword)?.elastic = Some([youngs_modulus, poisson_ratio]);
        Ok(())
    }

    pub(super) fn read_density(&mut self, keyword: &Keyword<'_>) -> Result<(), ExchangeError> {
        let [density] = constants(keyword, "a density")?;
        self.current_material(keyword)?.density = Some(density);
        Ok(())
    }

    fn current_material(&mut self, keyword: &Keyword<'_>) -> Result<&mut FileMaterial, ExchangeError> {
        let current = self.material.as_ref().and_then(|name| self.materials.get_mut(name));
        let (what, problem) = ("a property of a material", String::from("it stands before any *MATERIAL"));
        current
            .map(|(_, material)| material)
            .ok_or_else(|| keyword.error(FileCause::Inconsistent { what, problem }))
    }

    pub(super) fn read_part(&mut self, keyword: &Keyword<'_>) -> Result<(), ExchangeError> {
        self.parts += 1;
        if self.parts > 1 { Err(several(keyword)) } else { Ok(()) }
    }

    pub(super) fn read_instance(&mut self, keyword: &Keyword<'_>) -> Result<(), ExchangeError> {
        self.instances += 1;
        if self.instances > 1 || !keyword.data.is_empty() { Err(several(keyword)) } else { Ok(()) }
    }

    fn refuse_input(&self, keyword: &Keyword<'_>) -> Result<(), ExchangeError> {
        if keyword.has("INPUT") {
            let (what, found) = ("the keyword", String::from("in another file (INPUT)"));
            return Err(keyword.error(FileCause::Unsupported { what, found, read: "its lines in this one" }));
        }
        Ok(())
    }
}

fn several(keyword: &Keyword<'_>) -> ExchangeError {
    let (what, found) = ("the assembly", String::from("of several parts or instances, or one that is moved"));
    keyword.error(FileCause::Unsupported {
        what,
        found,
        read: "a flat deck, or one part in one instance at its own place",
    })
}

fn twice(what: &'static str, label: impl ToString, first: &str) -> FileCause {
    FileCause::Twice { what, label: quoted(&label.to_string()), first: first.to_owned() }
}

fn node(text: &str) -> Result<(usize, [f64; 3]), FileCause> {
    let words = words(text);
    if !(2..=4).contains(&words.len()) {
        let (what, expected) = ("a node", "its number and its place (x, y, z)");
        return Err(FileCause::WrongEntries { what, expected, found: words.len() });
    }
    let mut place = [0.0; 3];
    for (value, word) in place.iter_mut().zip(&words[1..]) {
        // an entry that is left out is zero
        *value = if word.is_empty() { 0.0 } else { number(word, "a place of a node")? };
    }
    Ok((count(words[0], 1, "a number of a node")?, place))
}

/// The place of a side `S1`, `S2`, … in the order of judder, which is that of Abaqus.
fn side_number(word: &str) -> Result<usize, FileCause> {
    let number = word.strip_prefix(['S', 's']).and_then(|number| number.parse::<usize>().ok());
    number.and_then(|number| number.checked_sub(1)).ok_or_else(|| FileCause::Unsupported {
        what: "the side of a surface",
        found: format!("`{}`", quoted(word)),
        read: "S1 to S6",
    })
}

/// The constants of a material's property: one line, not dependent on temperature.
fn constants<const N: usize>(keyword: &Keyword<'_>, what: &'static str) -> Result<[f64; N], ExchangeError> {
    let [(line, text)] = keyword.data.as_slice() else {
        return Err(keyword.error(FileCause::WrongLines { what, found: keyword.data.len() }));
    };
    let here = |cause| ExchangeError::at_line(*line, cause);
    let words = words(text);
    let mut values = [0.0; N];
    if words.len() < N {
        return Err(here(FileCause::WrongEntries {
            what: "the property",
            expected: what,
            found: words.len(),
        }));
    }
    for (value, word) in values.iter_mut().zip(&words) {
        *value = number(word, what).map_err(here)?;
    }
    Ok(values)
}
