//! Right and left vectors of modes on the freedoms of imported matrices: as arrays, and of the fastest growing modes in words.

use super::build::StructureLayout;
use super::shapes::kept;
use crate::error::ModelError;
use judder_numerics::complex::ElementaryComplex;
use judder_numerics::order::sort_by_number;
use judder_store::{Dataset, Results, Variable};
use judder_structure::freedom::Direction;
use num_complex::Complex64;

/// Modes whose shapes are told.
const TOLD_MODES: usize = 4;
/// Freedoms that are told of a shape: the largest.
const TOLD_FREEDOMS: usize = 12;

/// Freedoms by their names.
#[derive(Default)]
pub(crate) struct ImportedFreedoms {
    /// Which they are among those of the vectors,
    indices: Vec<usize>,
    /// and what they are called.
    names: Vec<String>,
}

/// A mode as two vectors: (λ²M + λC + K) x = 0, yᴴ (λ²M + λC + K) = 0.
pub(crate) struct ModeVectors {
    /// Its number, from one on.
    pub(crate) mode: usize,
    pub(crate) eigenvalue: Complex64,
    pub(crate) frequency_hz: f64,
    /// x, its largest entry of magnitude 1.
    pub(crate) right: Vec<Complex64>,
    /// y, yᴴ (2λM + C) x = 1.
    pub(crate) left: Vec<Complex64>,
}

/// What is told of a shape: its largest displacements.
#[derive(Clone, Results)]
pub(crate) struct ToldShape {
    /// number of the mode, by rising frequency
    mode: usize,
    /// its frequency, in Hz
    frequency_hz: f64,
    /// the freedoms that move most
    freedoms: Vec<String>,
    /// by how much they move, over the largest displacement
    #[result(unit = "1")]
    modulus: Vec<f64>,
    /// and with which phase, in degrees
    phase_deg: Vec<f64>,
}

impl ImportedFreedoms {
    /// All freedoms of a structure: by node and direction where that is known, else by their number.
    pub(crate) fn of_structure(count: usize, layout: Option<&StructureLayout>) -> Self {
        let mut all = Self::default();
        all.add("", 0, count, layout);
        all
    }

    /// Adds those of a body, the first of which has this place in the vectors.
    pub(crate) fn add(&mut self, body: &str, first: usize, count: usize, layout: Option<&StructureLayout>) {
        let mut names: Vec<String> = (1..=count).map(|number| format!("freedom {number}")).collect();
        for (point, freedoms) in layout.iter().flat_map(|layout| layout.freedoms.iter().enumerate()) {
            for (freedom, direction) in freedoms.iter().zip(Direction::ALL) {
                if let (Some(layout), Some(name)) = (layout, freedom.and_then(|k| names.get_mut(k))) {
                    *name = format!("{} {}", layout.word(point).replace('`', ""), direction);
                }
            }
        }
        let before = if body.is_empty() { String::new() } else { format!("{body}: ") };
        self.names.extend(names.into_iter().map(|name| format!("{before}{name}")));
        self.indices.extend(first..first + count);
    }

    /// Whether there are none.
    pub(crate) fn is_empty(&self) -> bool {
        self.indices.is_empty()
    }

    fn of<'a>(&'a self, vector: &'a [Complex64]) -> impl Iterator<Item = Complex64> + 'a {
        self.indices.iter().map(|index| vector.get(*index).copied().unwrap_or_default())
    }

    /// The vectors as arrays; nothing where there are no freedoms.
    pub(crate) fn with_vectors(
        &self,
        dataset: Dataset,
        modes: &[ModeVectors],
        warnings: &mut Vec<String>,
    ) -> Result<Dataset, ModelError> {
        let count = self.indices.len();
        if count == 0 {
            return Ok(dataset);
        }
        let kept = kept("vectors", modes.len(), 32 * count, warnings);
        let vectors = |name: &str, of: fn(&ModeVectors) -> &[Complex64], unit: &str, long_name: &str| {
            let values: Vec<Complex64> = modes[..kept].iter().flat_map(|mode| self.of(of(mode))).collect();
            Variable::new(name, &["stored_mode", "freedom"], &[kept, count], values)
                .units(unit)
                .long_name(long_name)
        };
        let names = Variable::new("freedom", &["freedom"], &[count], self.names.clone());
        let (right, left) = (
            "right vector x of the mode, (λ²M + λC + K) x = 0, its largest entry of magnitude 1",
            "left vector y of the mode, yᴴ (λ²M + λC + K) = 0, yᴴ (2λM + C) x = 1",
        );
        Ok(dataset
            .with(names.long_name("degree of freedom of the matrices"))?
            .with(vectors("right_vector", |mode| &mode.right, "1", right))?
            .with(vectors("left_vector", |mode| &mode.left, "s/kg", left))?)
    }

    /// The shapes of the fastest growing modes in words, for those that no picture shows.
    pub(crate) fn told(&self, modes: &[ModeVectors]) -> Option<Vec<ToldShape>> {
        let mut order: Vec<&ModeVectors> = modes.iter().collect();
        sort_by_number(&mut order, |own| -own.eigenvalue.re);
        let told = order.into_iter().take(TOLD_MODES).map(|mode| self.told_of(mode));
        (!modes.is_empty() && !self.indices.is_empty()).then(|| told.collect())
    }

    fn told_of(&self, mode: &ModeVectors) -> ToldShape {
        let values: Vec<Complex64> = self.of(&mode.right).collect();
        let mut places: Vec<usize> = (0..values.len()).collect();
        sort_by_number(&mut places, |own| -values[*own].modulus());
        places.truncate(TOLD_FREEDOMS);
        places.sort_unstable();
        ToldShape {
            mode: mode.mode,
            frequency_hz: mode.frequency_hz,
            freedoms: places.iter().map(|k| self.names[*k].clone()).collect(),
            modulus: places.iter().map(|k| values[*k].modulus()).collect(),
            phase_deg: places.iter().map(|k| phase(values[*k])).collect(),
        }
    }
}

/// The phase in degrees, above −180; zero of what does not move.
fn phase(value: Complex64) -> f64 {
    if value.modulus() == 0.0 { 0.0 } else { value.argument().to_degrees() }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mode(re: f64, right: &[Complex64]) -> ModeVectors {
        let eigenvalue = Complex64::new(re, 3.0);
        ModeVectors { mode: 1, eigenvalue, frequency_hz: 0.5, right: right.to_vec(), left: right.to_vec() }
    }

    #[test]
    fn the_largest_displacements_are_told_in_the_order_of_the_freedoms() {
        let freedoms = ImportedFreedoms::of_structure(20, None);
        let vector: Vec<Complex64> =
            (0..20).map(|k| Complex64::from_polar(f64::from(k) / 19.0, 0.5)).collect();
        let told = freedoms.told(&[mode(-1.0, &vector), mode(2.0, &vector[1..])]).unwrap();
        assert_eq!(told.len(), 2);
        assert_eq!(told[1].freedoms.len(), TOLD_FREEDOMS);
        assert_eq!(
            (told[1].freedoms[0].as_str(), told[1].freedoms[11].as_str()),
            ("freedom 9", "freedom 20")
        );
        assert_eq!(told[1].modulus[11], 1.0);
        assert!((told[1].phase_deg[3] - 0.5_f64.to_degrees()).abs() < 1e-12);
        assert!(ImportedFreedoms::default().told(&[mode(1.0, &vector)]).is_none());
    }
}
