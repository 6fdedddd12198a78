//! Directions and places of a case.

use super::problem::AssemblyProblem;
use judder_keys::cause::Cause;
use judder_keys::declared::{Number, Several};
use judder_keys::dimension::Dimension;
use judder_keys::error::Fault;
use judder_keys::problem::Placed;
use judder_keys::section::Section;

pub(super) const VECTOR: Several<Number> = Several { of: Number::any(Dimension::NUMBER), length: [2, 3] };
pub(super) const PLACE: Several<Number> = Several { of: Number::any(Dimension::LENGTH), length: [2, 3] };

/// Refuses a vector of another length than two or three, and one of zeros, under these keys of a section.
pub(super) fn check_direction(vector: &[f64], section: &Section<'_>, keys: &[&str]) -> Result<(), Fault> {
    let (place, key) = (section.place_of(keys), section.path(&keys.join(".")));
    if !(2..=3).contains(&vector.len()) {
        return Err(Cause::Length { key, expected: "two or three numbers", found: vector.len() }.at(place));
    }
    match vector.iter().all(|part| *part == 0.0) {
        true => Err(AssemblyProblem::NoDirection { key }.at(place)),
        false => Ok(()),
    }
}
