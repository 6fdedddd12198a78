//! From the nodes and elements of a file to a mesh: unused nodes go, elements of one kind and name stand together.

use super::{MeshFile, Warning};
use crate::cause::FileCause;
use judder_structure::element::ElementKind;
use judder_structure::mesh::{ElementSide, Mesh, MeshBlock};
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

/// An element of a file.
pub(super) struct FileElement {
    pub(super) label: usize,
    pub(super) kind: ElementKind,
    /// The name of its block.
    pub(super) block: String,
    /// Places in the list of nodes, in the order of [`ElementKind`].
    pub(super) nodes: Vec<usize>,
}

/// What a file holds; sets name places in its lists of nodes and elements.
#[derive(Default)]
pub(super) struct FileParts {
    /// Numbers and places.
    pub(super) nodes: Vec<(usize, [f64; 3])>,
    pub(super) elements: Vec<FileElement>,
    pub(super) node_sets: BTreeMap<String, Vec<usize>>,
    pub(super) element_sets: BTreeMap<String, Vec<usize>>,
    pub(super) side_sets: BTreeMap<String, Vec<ElementSide>>,
    pub(super) warnings: Vec<Warning>,
}

/// Beyond this share of the mesh's size a place is off the plane.
const OFF_PLANE: f64 = 1e-9;

impl FileParts {
    /// The mesh, without materials and sections.
    pub(super) fn build(mut self) -> Result<MeshFile, FileCause> {
        self.check_dimension()?;
        let kept = self.kept_nodes();
        self.warn_of_unused(&kept);
        self.warn_of_elements();
        let (blocks, numbers) = blocks(&self.elements, &kept);
        let node_sets = self.node_sets.iter().map(|(name, set)| {
            (name.clone(), distinct(set.iter().filter_map(|node| kept[*node]), self.nodes.len()))
        });
        let element_sets = self.element_sets.iter().map(|(name, set)| {
            (name.clone(), distinct(set.iter().map(|element| numbers[*element]), self.elements.len()))
        });
        let moved = |side: &ElementSide| ElementSide { element: numbers[side.element], ..*side };
        let side_sets =
            self.side_sets.iter().map(|(name, set)| (name.clone(), set.iter().map(moved).collect()));
        let used = || self.nodes.iter().zip(&kept).filter(|(_, kept)| kept.is_some()).map(|(node, _)| node);
        let mesh = Mesh {
            nodes: used().map(|(_, place)| *place).collect(),
            blocks,
            node_sets: node_sets.collect(),
            element_sets: element_sets.collect(),
            side_sets: side_sets.collect(),
        };
        mesh.check().map_err(|source| FileCause::Structure { source })?;
        let mut element_labels = vec![0; self.elements.len()];
        for (element, number) in self.elements.iter().zip(&numbers) {
            element_labels[*number] = element.label;
        }
        let node_labels = used().map(|(label, _)| *label).collect();
        let warnings = self.warnings;
        Ok(MeshFile { mesh, node_labels, element_labels, warnings, ..MeshFile::default() })
    }

    fn check_dimension(&self) -> Result<(), FileCause> {
        let Some(first) = self.elements.first() else {
            return Err(FileCause::NoElements);
        };
        let dimension = first.kind.dimension();
        if let Some(other) = self.elements.iter().find(|element| element.kind.dimension() != dimension) {
            return Err(FileCause::MixedDimensions { first: first.label, other: other.label });
        }
        if dimension == 3 {
            return Ok(());
        }
        let places = || self.elements.iter().flat_map(|element| &element.nodes).map(|node| self.nodes[*node]);
        let size = places().flat_map(|(_, [x, y, _])| [x.abs(), y.abs()]).fold(0.0, f64::max);
        match places().find(|(_, place)| place[2].abs() > OFF_PLANE * size) {
            Some((node, place)) => Err(FileCause::OffPlane { node, z: place[2] }),
            None => Ok(()),
        }
    }

    /// The number in the mesh of each node that an element uses.
    fn kept_nodes(&self) -> Vec<Option<usize>> {
        let mut used = vec![false; self.nodes.len()];
        for node in self.elements.iter().flat_map(|element| &element.nodes) {
            used[*node] = true;
        }
        let mut next = 0;
        let mut number = |used: bool| {
            next += usize::from(used);
            used.then(|| next - 1)
        };
        used.into_iter().map(&mut number).collect()
    }

    fn warn_of_unused(&mut self, kept: &[Option<usize>]) {
        let unused = kept.iter().filter(|kept| kept.is_none()).count();
        if let Some(first) = kept.iter().position(Option::is_none) {
            let text = format!(
                "{unused} nodes belong to no element and are left out, the first is {}",
                self.nodes[first].0
            );
            self.warnings.push(Warning { line: None, text });
        }
        let lost = self.node_sets.iter().filter(|(_, set)| set.iter().any(|node| kept[*node].is_none()));
        let texts: Vec<String> =
            lost.map(|(name, _)| format!("the set `{name}` loses nodes that belong to no element")).collect();
        self.warnings.extend(texts.into_iter().map(|text| Warning { line: None, text }));
    }
}

impl FileParts {
    /// Elements that name a node twice, and elements of the same nodes.
    fn warn_of_elements(&mut self) {
        let (mut collapsed, mut twice) = (Vec::new(), Vec::new());
        let mut seen: BTreeMap<Vec<usize>, usize> = BTreeMap::new();
        for element in &self.elements {
            let mut nodes = element.nodes.clone();
            nodes.sort_unstable();
            if let Some(pair) = nodes.windows(2).find(|pair| pair[0] == pair[1]) {
                collapsed.push((element.label, self.nodes[pair[0]].0));
            }
            match seen.entry(nodes) {
                Entry::Occupied(first) => twice.push((*first.get(), element.label)),
                Entry::Vacant(place) => drop(place.insert(element.label)),
            }
        }
        let elements =
            |count: usize| if count == 1 { "element".to_owned() } else { format!("{count} elements") };
        let texts = [
            collapsed.first().map(|(element, node)| {
                let count = elements(collapsed.len());
                format!("{count} with a node that is named twice, the first is {element} with node {node}: it has lost a side")
            }),
            twice.first().map(|(first, again)| {
                let count = elements(twice.len());
                format!(
                    "{count} given twice, the first is {again} with the nodes of {first}: mass and stiffness count twice there"
                )
            }),
        ];
        self.warnings.extend(texts.into_iter().flatten().map(|text| Warning { line: None, text }));
    }
}

/// The first of each, in their order.
fn distinct(numbers: impl Iterator<Item = usize>, below: usize) -> Vec<usize> {
    let mut seen = vec![false; below];
    numbers.filter(|number| !std::mem::replace(&mut seen[*number], true)).collect()
}

/// Elements of one kind and name together, in the order in which these come up, and the new number of each element.
fn blocks(elements: &[FileElement], kept: &[Option<usize>]) -> (Vec<MeshBlock>, Vec<usize>) {
    let mut places: BTreeMap<(ElementKind, &str), usize> = BTreeMap::new();
    let mut members: Vec<Vec<usize>> = Vec::new();
    for (k, element) in elements.iter().enumerate() {
        let place = *places.entry((element.kind, &element.block)).or_insert(members.len());
        if place == members.len() {
            members.push(Vec::new());
        }
        members[place].push(k);
    }
    let mut numbers = vec![0; elements.len()];
    for (number, k) in members.iter().flatten().enumerate() {
        numbers[*k] = number;
    }
    let block = |own: &Vec<usize>| {
        let first = &elements[own[0]];
        let nodes = own.iter().flat_map(|k| &elements[*k].nodes).filter_map(|node| kept[*node]);
        MeshBlock { kind: first.kind, material: first.block.clone(), connectivity: nodes.collect() }
    };
    (members.iter().map(block).collect(), numbers)
}

/// The kind and the nodes of each element of a mesh.
pub(super) fn elements_of(mesh: &Mesh) -> Vec<(ElementKind, &[usize])> {
    let of_block = |block: &'_ MeshBlock| block.kind.nodes();
    mesh.blocks
        .iter()
        .flat_map(|block| block.connectivity.chunks_exact(of_block(block)).map(|own| (block.kind, own)))
        .collect()
}
