//! A sweep at some of its points, from its group alone: for drawing, without the case that it belongs to.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;

use zarrs::filesystem::FilesystemStore;

use super::layout::{QUANTITY, VALUES};
use super::points::unravelled;
use crate::array::{self, ReadFailure};
use crate::zarr;
use crate::{Dataset, FileDamage, StoreError, Variable, VariableValues};

/// The chosen positions along each dimension of a sweep.
type Chosen = Vec<(String, Vec<usize>)>;

/// Reads the group of a sweep at the points that `choose` picks from names and lengths of its dimensions; a chunk with a damage is refused.
pub(crate) fn read_points(
    group: &Path,
    choose: impl FnOnce(&[(String, usize)]) -> Vec<Vec<usize>>,
    damage_of: &dyn Fn(&Path) -> Option<FileDamage>,
) -> Result<Dataset, StoreError> {
    let lengths = lengths(group).map_err(|source| StoreError::of_array(&group.join(VALUES), source))?;
    let mut picked = choose(&lengths).into_iter();
    let chosen: Chosen = lengths
        .into_iter()
        .map(|(name, length)| {
            let mut positions = picked.next().unwrap_or_default();
            positions.retain(|position| *position < length);
            (name, positions)
        })
        .collect();
    zarr::read_group_by(group, |store, name| match name {
        VALUES => values(store, &chosen, damage_of),
        _ => Ok(thinned(zarr::read_variable(store, name)?, &chosen)),
    })
}

/// Names and lengths of the dimensions of a sweep, without that of its quantities.
fn lengths(group: &Path) -> Result<Vec<(String, usize)>, ReadFailure> {
    let array = array::open(&Arc::new(FilesystemStore::new(group)?), VALUES)?;
    let names = array.dimension_names().clone().ok_or("its dimensions have no names")?;
    let mut lengths = Vec::new();
    for (name, length) in names.into_iter().zip(array.shape()) {
        lengths.push((name.ok_or("one of its dimensions has no name")?, usize::try_from(*length)?));
    }
    lengths.pop();
    Ok(lengths)
}

/// The values of all quantities at the chosen points.
fn values(
    store: &Arc<FilesystemStore>,
    chosen: &Chosen,
    damage_of: &dyn Fn(&Path) -> Option<FileDamage>,
) -> Result<Variable, ReadFailure> {
    let array = array::open(store, VALUES)?;
    let quantities = array.shape().last().copied().unwrap_or(0) as usize;
    zarr::check_chunk_size(&array)?;
    let chunk = array.chunk_shape(&vec![0; array.dimensionality()])?;
    let chunk: Vec<usize> = chunk.iter().map(|length| length.get() as usize).collect();
    let shape: Vec<usize> = chosen.iter().map(|(_, positions)| positions.len()).collect();
    let mut found = vec![f64::NAN; shape.iter().product::<usize>() * quantities];
    for (cell, places) in by_chunk(chosen, &shape, &chunk) {
        let file = store.key_to_fspath(&array.chunk_key(&cell));
        if !file.is_file() {
            return Err(format!("a part is missing: {}", file.display()).into());
        }
        if let Some(damage) = damage_of(&file) {
            return Err(StoreError::of_damage(file, damage).into());
        }
        let stored: Vec<f64> = array.retrieve_chunk(&cell)?;
        for (to, from) in places {
            let row = stored.get(from * quantities..(from + 1) * quantities).ok_or("a part is too short")?;
            let place = found.get_mut(to * quantities..(to + 1) * quantities);
            place.ok_or("a part is too long")?.copy_from_slice(row);
        }
    }
    let names: Vec<&str> = chosen.iter().map(|(name, _)| name.as_str()).chain([QUANTITY]).collect();
    let shape: Vec<usize> = shape.into_iter().chain([quantities]).collect();
    Ok(Variable::new(VALUES, &names, &shape, found))
}

/// The chosen points by the chunk in which they lie: each with its number among the chosen ones and among those of a whole chunk.
fn by_chunk(chosen: &Chosen, shape: &[usize], chunk: &[usize]) -> BTreeMap<Vec<u64>, Vec<(usize, usize)>> {
    let mut places: BTreeMap<Vec<u64>, Vec<(usize, usize)>> = BTreeMap::new();
    for to in 0..shape.iter().product() {
        let (mut cell, mut from) = (Vec::with_capacity(chunk.len()), 0);
        let at = unravelled(to, shape.iter().copied());
        for ((picked, (_, positions)), chunk) in at.iter().zip(chosen).zip(chunk) {
            let position = positions.get(*picked).copied().unwrap_or_default();
            cell.push((position / chunk) as u64);
            from = from * chunk + position % chunk;
        }
        // all quantities are in one chunk
        cell.push(0);
        places.entry(cell).or_default().push((to, from));
    }
    places
}

/// A coordinate at the chosen positions of its dimension; anything else as it is.
fn thinned(mut variable: Variable, chosen: &Chosen) -> Variable {
    let [dimension] = variable.dimensions.as_slice() else { return variable };
    let Some((_, positions)) = chosen.iter().find(|(name, _)| name == dimension) else { return variable };
    variable.data = match &variable.data {
        VariableValues::F64(values) => VariableValues::F64(at(values, positions)),
        VariableValues::Complex(values) => VariableValues::Complex(at(values, positions)),
        VariableValues::I64(values) => VariableValues::I64(at(values, positions)),
        VariableValues::U8(values) => VariableValues::U8(at(values, positions)),
        VariableValues::Text(values) => VariableValues::Text(at(values, positions)),
    };
    variable.shape = vec![variable.data.len()];
    variable
}

fn at<T: Clone>(values: &[T], positions: &[usize]) -> Vec<T> {
    positions.iter().filter_map(|position| values.get(*position).cloned()).collect()
}
