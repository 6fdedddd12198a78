//! How a block lies in space.

use super::problem::StructureProblem;
use judder_keys::Settings;
use judder_keys::declared::{Number, Several};
use judder_keys::dimension::Dimension;
use judder_keys::error::Fault;
use judder_keys::problem::Placed;
use judder_keys::section::Section;

/// How a block is turned.
#[derive(Debug, Clone, PartialEq, Settings)]
pub struct Orientation {
    /// By how much, counter-clockwise.
    #[key(rule = Number::any(Dimension::ANGLE), symbol = "ϑ")]
    pub angle: f64,
    /// About which axis of space, of any length; in the plane it is z.
    #[key(rule = AXIS, default = vec![0.0, 0.0, 1.0], example = "[0, 1, 0]")]
    pub axis: Vec<f64>,
}

impl Orientation {
    /// Refuses an axis without a direction, and one that leads a block out of its plane.
    pub(super) fn fits(&self, is_plane: bool, section: &Section<'_>) -> Result<(), Fault> {
        let own = section.inner("orientation")?;
        let place = own.map_or(section.place, |own| own.place_of(&["axis"]));
        let key = section.path("orientation.axis");
        let [x, y, z] = self.about();
        if [x, y, z].iter().all(|part| *part == 0.0) {
            return Err(StructureProblem::NoAxis { key }.at(place));
        }
        match is_plane && (x != 0.0 || y != 0.0) {
            true => Err(StructureProblem::OutOfPlane { key }.at(place)),
            false => Ok(()),
        }
    }

    fn about(&self) -> [f64; 3] {
        std::array::from_fn(|k| self.axis.get(k).copied().unwrap_or(0.0))
    }

    /// A place where the block is turned, by Rodrigues' formula.
    pub(crate) fn turned(&self, place: [f64; 3]) -> [f64; 3] {
        let about = self.about();
        let length = about.iter().map(|part| part * part).sum::<f64>().sqrt();
        let axis = about.map(|part| part / length);
        let (sine, cosine) = libm::sincos(self.angle);
        let along: f64 = axis.iter().zip(place).map(|(own, x)| own * x).sum();
        std::array::from_fn(|k| {
            let (next, last) = ((k + 1) % 3, (k + 2) % 3);
            let across = axis[next] * place[last] - axis[last] * place[next];
            cosine * place[k] + sine * across + (1.0 - cosine) * along * axis[k]
        })
    }
}

const AXIS: Several<Number> = Several { of: Number::any(Dimension::NUMBER), length: [3, 3] };

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{FRAC_PI_2, TAU};

    #[test]
    fn blocks_turn_counter_clockwise_about_their_axis() {
        let turned = |angle, axis: [f64; 3], place| Orientation { angle, axis: axis.to_vec() }.turned(place);
        let near = |found: [f64; 3], to: [f64; 3]| found.iter().zip(to).all(|(a, b)| (a - b).abs() < 1e-14);
        assert!(near(turned(FRAC_PI_2, [0.0, 0.0, 2.0], [1.0, 0.0, 3.0]), [0.0, 1.0, 3.0]));
        assert!(near(turned(FRAC_PI_2, [0.0, 1.0, 0.0], [0.0, 5.0, 1.0]), [1.0, 5.0, 0.0]));
        // a third of a turn about a diagonal exchanges the axes in turn
        assert!(near(turned(TAU / 3.0, [1.0, 1.0, 1.0], [1.0, 2.0, 3.0]), [3.0, 1.0, 2.0]));
    }
}
