//! Input decks of Abaqus and CalculiX: nodes, elements, sets, surfaces, materials, solid sections.
//!
//! *Abaqus Analysis User's Guide*, Input syntax rules; G. Dhondt, *CalculiX CrunchiX USER'S MANUAL*.

mod deck;
mod element_type;
mod meaning;
mod model;
mod sets;
mod solid_section;

use super::MeshFile;
use crate::error::ExchangeError;
use crate::text::text_of;
use meaning::{Meaning, meaning};
use model::DeckModel;

/// Reads the model of a deck; what belongs to steps is passed over.
pub(super) fn read_inp(bytes: &[u8]) -> Result<MeshFile, ExchangeError> {
    let mut model = DeckModel::new(bytes.len());
    let mut in_step = false;
    for keyword in deck::keywords(text_of(bytes)?)? {
        if in_step {
            in_step = keyword.name != "END STEP";
            continue;
        }
        match meaning(&keyword.name) {
            Meaning::Read(read) => read(&mut model, &keyword)?,
            Meaning::Nothing => {}
            Meaning::Refused(why) => return Err(keyword.error(meaning::refusal(&keyword.name, why))),
            Meaning::Step => {
                in_step = true;
                model.warn(
                    keyword.line,
                    String::from("*STEP is passed over: supports, loads and analyses are those of the case"),
                );
            }
            Meaning::PassedOver => {
                let text = format!("*{} is passed over", crate::quoted::quoted(&keyword.name));
                model.warn(keyword.line, text);
            }
        }
    }
    model.mesh_file()
}
