//! Solid sections, and the mesh of a model.

use super::deck::{Keyword, words};
use super::element_type::Formulation;
use super::model::{DeckModel, SolidSection};
use super::sets::{check_members, places};
use crate::cause::FileCause;
use crate::error::ExchangeError;
use crate::mesh_file::building::{FileElement, FileParts};
use crate::mesh_file::{FileSection, MeshFile, UNNAMED};
use crate::quoted::quoted;
use crate::text::number;
use judder_structure::material::{Elastic, ElementSection};
use judder_structure::mesh::ElementSide;
use std::collections::BTreeMap;

impl DeckModel {
    pub(super) fn read_solid_section(&mut self, keyword: &Keyword<'_>) -> Result<(), ExchangeError> {
        let here = |cause| keyword.error(cause);
        for parameter in ["COMPOSITE", "LAYUP", "STACK DIRECTION"] {
            if keyword.has(parameter) {
                let (what, found) = ("the section", String::from("made of layers"));
                return Err(here(FileCause::Unsupported { what, found, read: "one material a section" }));
            }
        }
        let set = keyword.needed("ELSET").map_err(here)?.to_owned();
        let material = keyword.needed("MATERIAL").map_err(here)?.to_owned();
        // the thickness is 1 where it is left out
        let mut thickness = 1.0;
        if let Some((line, text)) = keyword.data.first() {
            let there = |cause| ExchangeError::at_line(*line, cause);
            match words(text)[0] {
                "" => {}
                word => thickness = number(word, "a thickness").map_err(there)?,
            }
            if thickness <= 0.0 {
                let problem = format!("it is {thickness}, and must be positive");
                return Err(there(FileCause::Inconsistent { what: "a thickness", problem }));
            }
        }
        self.sections.push(SolidSection { set, material, thickness, line: keyword.line });
        Ok(())
    }

    /// The mesh with its materials and sections.
    pub(super) fn mesh_file(mut self) -> Result<MeshFile, ExchangeError> {
        self.check_materials()?;
        let of_elements = self.sections_of_elements()?;
        let (blocks, sections) = self.blocks(&of_elements)?;
        let mut parts = FileParts { warnings: std::mem::take(&mut self.warnings), ..FileParts::default() };
        for (element, block) in self.elements.iter().zip(blocks) {
            let place = |label: &usize| {
                let unknown = || FileCause::Unknown { what: "node", label: label.to_string() };
                self.node_places.get(label).copied().ok_or_else(unknown)
            };
            let nodes: Result<Vec<usize>, FileCause> = element.nodes.iter().map(place).collect();
            let nodes = nodes.map_err(|cause| ExchangeError::at_line(element.line, cause))?;
            parts.elements.push(FileElement {
                label: element.label,
                kind: element.of_type.kind,
                block,
                nodes,
            });
        }
        let things = self.nodes.len() + self.elements.len();
        let mut members = 0;
        for set in self.node_sets.iter() {
            let places = places(&set.spans, &self.node_places, "node")?;
            members += places.len();
            check_members(members, things)?;
            parts.node_sets.insert(set.name.clone(), places);
        }
        for set in self.element_sets.iter() {
            let places = places(&set.spans, &self.element_places, "element")?;
            members += places.len();
            check_members(members, things)?;
            parts.element_sets.insert(set.name.clone(), places);
        }
        parts.side_sets = self.side_sets()?;
        parts.nodes = self.nodes;
        let mut file = parts.build()?;
        file.sections = sections;
        file.materials = self.materials.into_values().collect();
        Ok(file)
    }

    fn check_materials(&self) -> Result<(), ExchangeError> {
        for (_, material) in self.materials.values() {
            let [youngs_modulus, poisson_ratio] = material.elastic.unwrap_or([1.0, 0.0]);
            Elastic::new(youngs_modulus, poisson_ratio, material.density.unwrap_or(0.0))
                .map_err(|source| FileCause::Structure { source })?;
        }
        Ok(())
    }

    /// The section of each element.
    fn sections_of_elements(&self) -> Result<Vec<Option<usize>>, ExchangeError> {
        let mut of_elements = vec![None; self.elements.len()];
        for (k, section) in self.sections.iter().enumerate() {
            let here = |cause| ExchangeError::at_line(section.line, cause);
            if !self.materials.contains_key(&section.material.to_ascii_uppercase()) {
                return Err(here(FileCause::Unknown { what: "material", label: quoted(&section.material) }));
            }
            let unknown = || here(FileCause::Unknown { what: "set", label: quoted(&section.set) });
            let set = self.element_sets.get(&section.set).ok_or_else(unknown)?;
            for element in places(&set.spans, &self.element_places, "element")? {
                if let Some(first) = of_elements[element].replace(k).filter(|first| *first != k) {
                    let label = self.elements[element].label.to_string();
                    let first = format!("by the section in line {}", self.sections[first].line);
                    return Err(here(FileCause::Twice { what: "the section of element", label, first }));
                }
            }
        }
        Ok(of_elements)
    }

    /// The name of the block of each element, and what each name means.
    #[allow(clippy::type_complexity, reason = "two lists that are made together")]
    fn blocks(
        &self,
        of_elements: &[Option<usize>],
    ) -> Result<(Vec<String>, BTreeMap<String, FileSection>), ExchangeError> {
        let mut sections: BTreeMap<String, FileSection> = BTreeMap::new();
        let mut names = Vec::with_capacity(self.elements.len());
        for (element, section) in self.elements.iter().zip(of_elements) {
            let section = section.map(|k| &self.sections[k]);
            let name = section.map(|section| &section.set).or(element.set.as_ref());
            let name = name.map_or_else(
                || UNNAMED.to_owned(),
                |name| self.element_sets.get(name).map_or_else(|| name.clone(), |set| set.name.clone()),
            );
            let thickness = section.map_or(1.0, |section| section.thickness);
            let meant = match element.of_type.formulation {
                Formulation::PlaneStress => ElementSection::PlaneStress { thickness },
                Formulation::PlaneStrain => ElementSection::PlaneStrain { thickness },
                Formulation::Solid => ElementSection::Solid,
            };
            let material = section.and_then(|section| {
                self.materials.get(&section.material.to_ascii_uppercase()).map(|(name, _)| name.clone())
            });
            let own = FileSection { material, section: meant };
            if sections.get(&name).is_some_and(|other| *other != own) {
                let problem =
                    format!("the set `{}` has elements of different sections or formulations", quoted(&name));
                let cause = FileCause::Inconsistent { what: "a section", problem };
                return Err(ExchangeError::at_line(element.line, cause));
            }
            if !sections.contains_key(&name) {
                sections.insert(name.clone(), own);
            }
            names.push(name);
        }
        Ok((names, sections))
    }

    fn side_sets(&self) -> Result<BTreeMap<String, Vec<ElementSide>>, ExchangeError> {
        let mut sets = BTreeMap::new();
        for (name, lines) in &self.surfaces {
            let mut sides = Vec::new();
            for line in lines {
                for element in places(&line.elements, &self.element_places, "element")? {
                    let kind = self.elements[element].of_type.kind;
                    if line.side >= kind.sides().len() {
                        let (side, sides) = (line.side + 1, kind.sides().len());
                        return Err(ExchangeError::at_line(
                            line.line,
                            FileCause::NoSuchSide { kind, side, sides },
                        ));
                    }
                    sides.push(ElementSide { element, side: line.side });
                }
                check_members(sides.len(), self.elements.len())?;
            }
            sets.insert(name.clone(), sides);
        }
        Ok(sets)
    }
}
