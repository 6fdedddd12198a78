//! The points of a sweep and how they are cut into chunks.

use std::path::Path;

use serde_json::Value;

use super::points::{ChunkPoints, unravelled};
use crate::metadata::BUILD_ATTRIBUTE;
use crate::name::check_name;
use crate::{Dataset, StoreError, Variable};

/// The name of the array that holds all quantities, and of its last dimension.
pub(crate) const VALUES: &str = "values";
pub(crate) const QUANTITY: &str = "quantity";
/// How the paths of the files of chunks begin in the group of a sweep.
pub(crate) const CHUNKS: &str = "values/c.";

/// Whether a path of a study is that of a chunk.
pub(crate) fn is_chunk(path: &Path) -> bool {
    let (folder, name) = (path.parent().and_then(Path::file_name), path.file_name());
    folder.is_some_and(|folder| folder == VALUES)
        && name.is_some_and(|name| name.to_string_lossy().starts_with("c."))
}

/// No chunk is larger; a chunk is in memory as a whole.
const LARGEST_CHUNK_BYTES: usize = 1 << 30;

/// One dimension of a sweep.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SweepDimension {
    /// Its name: the dotted key that is swept, or `sample`.
    pub name: String,
    /// Points along it.
    pub length: usize,
    /// Points of a chunk along it; more than `length` is as good as `length`.
    pub chunk: usize,
}

/// One quantity that every point of a sweep has.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SweepQuantity {
    /// Its name, such as `thresholds.full.0.min`: a label of the dimension `quantity`.
    pub name: String,
    /// Unit symbol, `1` where dimensionless, empty where a unit makes no sense (classes).
    pub units: String,
    /// What it is, with its symbol.
    pub long_name: String,
    /// The codes of a class and what they mean; empty for a number.
    pub flags: Vec<(u8, String)>,
}

impl SweepQuantity {
    /// A number with its unit symbol and what it is.
    #[must_use]
    pub fn new(name: &str, units: &str, long_name: &str) -> Self {
        let (name, units, long_name) = (name.to_owned(), units.to_owned(), long_name.to_owned());
        Self { name, units, long_name, flags: Vec::new() }
    }

    /// A class: codes and what they mean.
    #[must_use]
    pub fn flags(mut self, flags: &[(u8, &str)]) -> Self {
        self.flags = flags.iter().map(|&(code, meaning)| (code, meaning.to_owned())).collect();
        self
    }
}

/// The points of a sweep, how they are cut into chunks, and which quantities each has.
///
/// It becomes one group of `results.zarr` with one array `values[dimensions…, quantity]` of real numbers, NaN where a point failed or is
/// not computed yet, and with coordinates: those that are given, and along `quantity` the names (`quantity`), `quantity_units`,
/// `quantity_long_name`, and where there are classes `quantity_flag_values` and `quantity_flag_meanings`, each a list with blanks as in the CF
/// convention.
///
/// Chunks are numbered from 0, row-major: the last dimension varies fastest; so are the points in a chunk. Those at the end of a dimension may
/// be smaller.
///
/// ```
/// use judder_store::{SweepDimension, SweepLayout, SweepQuantity, Variable};
/// let velocity = SweepDimension { name: "operation.velocity".to_owned(), length: 10, chunk: 4 };
/// let growth = SweepQuantity::new("growth_rate", "1/s", "growth rate, Re(λ)");
/// let layout = SweepLayout::new("robustness", "hash", vec![velocity], vec![growth])?
///     .with(Variable::coordinate("operation.velocity", vec![0.1; 10]).units("m/s"))?;
/// assert_eq!(layout.chunk_count(), 3);
/// let last = layout.points(2)?;
/// assert_eq!((last.count(), last.position(1)), (2, vec![9]));
/// # Ok::<(), judder_store::StoreError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct SweepLayout {
    name: String,
    hash: String,
    dimensions: Vec<SweepDimension>,
    quantities: Vec<SweepQuantity>,
    /// All variables; `values` among them has none of its values.
    dataset: Dataset,
}

impl SweepLayout {
    /// A sweep without coordinates. `hash` names all that the values depend on.
    ///
    /// # Errors
    /// [`StoreError::InvalidName`], [`StoreError::Duplicate`], [`StoreError::EmptySweep`], [`StoreError::SweepTooLarge`].
    pub fn new(
        name: &str,
        hash: &str,
        mut dimensions: Vec<SweepDimension>,
        quantities: Vec<SweepQuantity>,
    ) -> Result<Self, StoreError> {
        check_name("a sweep", name)?;
        let empty = |what: String| StoreError::EmptySweep { sweep: name.to_owned(), what };
        if dimensions.is_empty() || quantities.is_empty() {
            let what = if dimensions.is_empty() { "dimensions" } else { "quantities" };
            return Err(empty(what.to_owned()));
        }
        for dimension in &mut dimensions {
            if dimension.length == 0 || dimension.chunk == 0 {
                return Err(empty(format!("points along `{}`, or in a chunk", dimension.name)));
            }
            dimension.chunk = dimension.chunk.min(dimension.length);
        }
        check_size(name, &dimensions, quantities.len())?;
        let dataset = described(&dimensions, &quantities)?;
        Ok(Self { name: name.to_owned(), hash: hash.to_owned(), dimensions, quantities, dataset })
    }

    /// With a coordinate: the values along a dimension, or other values that label points.
    ///
    /// # Errors
    /// What a [`Dataset`] refuses.
    pub fn with(mut self, coordinate: Variable) -> Result<Self, StoreError> {
        self.dataset = self.dataset.with(coordinate.as_coordinate())?;
        Ok(self)
    }

    /// With an attribute of the whole, as JSON.
    ///
    /// # Errors
    /// What a [`Dataset`] refuses.
    pub fn attribute(mut self, name: &str, value: impl Into<Value>) -> Result<Self, StoreError> {
        self.dataset = self.dataset.attribute(name, value)?;
        Ok(self)
    }

    /// With the build that computes it: a sweep that another one has begun is [`StoreError::OtherBuild`].
    ///
    /// # Errors
    /// What a [`Dataset`] refuses.
    pub fn build(self, version: &str) -> Result<Self, StoreError> {
        self.attribute(BUILD_ATTRIBUTE, version)
    }

    /// Its name, that of its group.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// What names all that the values depend on.
    #[must_use]
    pub fn hash(&self) -> &str {
        &self.hash
    }

    /// Its dimensions, without `quantity`.
    #[must_use]
    pub fn dimensions(&self) -> &[SweepDimension] {
        &self.dimensions
    }

    /// What each point has.
    #[must_use]
    pub fn quantities(&self) -> &[SweepQuantity] {
        &self.quantities
    }

    /// How many points there are.
    #[must_use]
    pub fn point_count(&self) -> usize {
        self.dimensions.iter().map(|dimension| dimension.length).product()
    }

    /// How many chunks there are.
    #[must_use]
    pub fn chunk_count(&self) -> usize {
        self.chunk_grid().product()
    }

    /// The points of a chunk.
    ///
    /// # Errors
    /// [`StoreError::NoSuchChunk`].
    pub fn points(&self, chunk: usize) -> Result<ChunkPoints, StoreError> {
        let cell = self.cell(chunk)?;
        let along = || self.dimensions.iter().zip(&cell);
        let first: Vec<usize> = along().map(|(dimension, index)| index * dimension.chunk).collect();
        let shape = along()
            .map(|(dimension, index)| dimension.chunk.min(dimension.length - index * dimension.chunk))
            .collect();
        Ok(ChunkPoints { first, shape })
    }

    /// All variables; `values` among them has none of its values.
    pub(super) fn dataset(&self) -> &Dataset {
        &self.dataset
    }

    /// Shape of a chunk that is not at the end of a dimension, quantities last.
    pub(super) fn chunk_shape(&self) -> Vec<u64> {
        let chunks = self.dimensions.iter().map(|dimension| dimension.chunk);
        chunks.chain([self.quantities.len()]).map(|length| length as u64).collect()
    }

    /// The name of the file of a chunk in the folder of `values`.
    pub(super) fn file_name(&self, chunk: usize) -> Result<String, StoreError> {
        let cell = self.cell(chunk)?.iter().map(|index| format!("{index}.")).collect::<String>();
        Ok(format!("c.{cell}0"))
    }

    /// The chunk whose file has this name.
    pub(super) fn chunk_of_file(&self, name: &str) -> Option<usize> {
        let mut indices = name.strip_prefix("c.")?.split('.');
        let mut chunk = 0;
        for count in self.chunk_grid() {
            let index = index(indices.next()?)?;
            if index >= count {
                return None;
            }
            chunk = chunk * count + index;
        }
        (indices.next() == Some("0") && indices.next().is_none()).then_some(chunk)
    }

    /// Chunks along each dimension.
    fn chunk_grid(&self) -> impl DoubleEndedIterator<Item = usize> + ExactSizeIterator {
        self.dimensions.iter().map(|dimension| dimension.length.div_ceil(dimension.chunk))
    }

    /// Where a chunk lies among the chunks.
    fn cell(&self, chunk: usize) -> Result<Vec<usize>, StoreError> {
        if chunk >= self.chunk_count() {
            let (sweep, count) = (self.name.clone(), self.chunk_count());
            return Err(StoreError::NoSuchChunk { sweep, chunk, count });
        }
        Ok(unravelled(chunk, self.chunk_grid()))
    }
}

/// A whole number as file names of chunks have it, without leading zeros.
fn index(digits: &str) -> Option<usize> {
    let plain = digits == "0" || !digits.starts_with(['0', '+']);
    plain.then(|| digits.parse().ok()).flatten()
}

/// Refuses a sweep whose values cannot be counted, and one whose chunks fit in no memory.
fn check_size(name: &str, dimensions: &[SweepDimension], quantities: usize) -> Result<(), StoreError> {
    let bytes = |mut lengths: std::vec::IntoIter<usize>| {
        lengths.try_fold(quantities.checked_mul(size_of::<f64>())?, usize::checked_mul)
    };
    let lengths: Vec<usize> = dimensions.iter().map(|dimension| dimension.length).collect();
    let chunks: Vec<usize> = dimensions.iter().map(|dimension| dimension.chunk).collect();
    let whole = bytes(lengths.into_iter());
    let chunk = bytes(chunks.into_iter()).filter(|bytes| *bytes <= LARGEST_CHUNK_BYTES);
    match (whole, chunk) {
        (Some(_), Some(_)) => Ok(()),
        _ => Err(StoreError::SweepTooLarge { sweep: name.to_owned() }),
    }
}

/// The array of all values, and the coordinates along its quantities.
fn described(dimensions: &[SweepDimension], quantities: &[SweepQuantity]) -> Result<Dataset, StoreError> {
    for (place, quantity) in quantities.iter().enumerate() {
        if quantities.iter().take(place).any(|before| before.name == quantity.name) {
            return Err(StoreError::Duplicate { what: "quantity", name: quantity.name.clone() });
        }
    }
    let names: Vec<&str> =
        dimensions.iter().map(|dimension| dimension.name.as_str()).chain([QUANTITY]).collect();
    let shape: Vec<usize> =
        dimensions.iter().map(|dimension| dimension.length).chain([quantities.len()]).collect();
    let along_quantities = |name: &str, text: fn(&SweepQuantity) -> String| {
        let texts: Vec<String> = quantities.iter().map(text).collect();
        Variable::new(name, &[QUANTITY], &[quantities.len()], texts).as_coordinate()
    };
    let mut dataset = Dataset::new()
        .joined_by(Variable::new(VALUES, &names, &shape, Vec::<f64>::new()))?
        .with(along_quantities(QUANTITY, |quantity| quantity.name.clone()))?
        .with(along_quantities("quantity_units", |quantity| quantity.units.clone()))?
        .with(along_quantities("quantity_long_name", |quantity| quantity.long_name.clone()))?;
    if quantities.iter().any(|quantity| !quantity.flags.is_empty()) {
        dataset = dataset
            .with(along_quantities("quantity_flag_values", |quantity| {
                listed(quantity.flags.iter().map(|(code, _)| code.to_string()))
            }))?
            .with(along_quantities("quantity_flag_meanings", |quantity| {
                listed(
                    quantity
                        .flags
                        .iter()
                        .map(|(_, meaning)| meaning.split_whitespace().collect::<Vec<_>>().join("_")),
                )
            }))?;
    }
    Ok(dataset)
}

fn listed(words: impl Iterator<Item = String>) -> String {
    words.collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn layout(lengths: [usize; 2]) -> SweepLayout {
        let [a, b] = lengths;
        let dimension = |name: &str, length, chunk| SweepDimension { name: name.to_owned(), length, chunk };
        let quantities = vec![SweepQuantity::new("q", "1", "")];
        SweepLayout::new("s", "h", vec![dimension("a", a, 2), dimension("b", b, 3)], quantities).unwrap()
    }

    #[test]
    fn chunks_cover_every_point_once() {
        let layout = layout([5, 7]);
        assert_eq!((layout.chunk_count(), layout.point_count()), (9, 35));
        let mut seen = Vec::new();
        for chunk in 0..9 {
            let points = layout.points(chunk).unwrap();
            seen.extend((0..points.count()).map(|point| points.position(point)));
            let name = layout.file_name(chunk).unwrap();
            assert_eq!(layout.chunk_of_file(&name), Some(chunk), "{name}");
        }
        seen.sort();
        let all: Vec<Vec<usize>> = (0..5).flat_map(|a| (0..7).map(move |b| vec![a, b])).collect();
        assert_eq!(seen, all);
        assert!(matches!(layout.points(9), Err(StoreError::NoSuchChunk { count: 9, .. })));
    }

    #[test]
    fn other_files_are_no_chunks() {
        let layout = layout([5, 7]);
        for name in [
            "zarr.json",
            "c.0.0",
            "c.0.0.1",
            "c.0.0.0.0",
            "c.00.0.0",
            "c.+1.0.0",
            "c.3.0.0",
            "c.0.3.0",
            "c..0.0",
        ] {
            assert_eq!(layout.chunk_of_file(name), None, "{name}");
        }
    }
}
