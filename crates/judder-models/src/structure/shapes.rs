//! Shapes of modes: as arrays, compared with each other.

use crate::error::ModelError;
use crate::structure::build::StructureLayout;
use judder_numerics::parallel;
use judder_store::{Dataset, Variable};
use judder_structure::modes::Mode;
use num_complex::Complex64;

/// What the shapes of an analysis may take in `results.zarr`, bytes.
const SHAPE_BYTES: usize = 128 << 20;

/// |φᵢᵀφⱼ|²/((φᵢᵀφᵢ)(φⱼᵀφⱼ)) of all pairs, row by row.
pub(super) fn mac(modes: &[Mode]) -> Vec<f64> {
    let dot = |a: &Mode, b: &Mode| a.shape.iter().zip(&b.shape).map(|(a, b)| a * b).sum::<f64>();
    let own: Vec<f64> = modes.iter().map(|mode| dot(mode, mode)).collect();
    let row = |i: usize| -> Vec<f64> {
        modes.iter().enumerate().map(|(j, other)| dot(&modes[i], other).powi(2) / (own[i] * own[j])).collect()
    };
    parallel::each_place(modes.len(), row).concat()
}

/// The same of complex shapes, |φᵢᴴφⱼ|²/((φᵢᴴφᵢ)(φⱼᴴφⱼ)).
pub(super) fn complex_mac(shapes: &[Vec<Complex64>]) -> Vec<f64> {
    let dot =
        |a: &[Complex64], b: &[Complex64]| a.iter().zip(b).map(|(a, b)| a.conj() * b).sum::<Complex64>();
    let own: Vec<f64> = shapes.iter().map(|shape| dot(shape, shape).re).collect();
    let pair = |i: usize, j: usize| dot(&shapes[i], &shapes[j]).norm_sqr() / (own[i] * own[j]);
    (0..shapes.len()).flat_map(|i| (0..shapes.len()).map(move |j| (i, j))).map(|(i, j)| pair(i, j)).collect()
}

/// Places and lines of a layout as arrays.
pub(crate) fn with_layout(dataset: Dataset, layout: &StructureLayout) -> Result<Dataset, ModelError> {
    let places: Vec<f64> = layout.points.iter().flatten().copied().collect();
    let lines: Vec<i64> = layout.lines.iter().flatten().map(|point| *point as i64).collect();
    let names: Vec<i64> = layout.names.iter().map(|name| *name as i64).collect();
    let directions = ["x", "y", "z"].map(String::from).to_vec();
    Ok(dataset
        .with(Variable::coordinate("point", names).long_name("number of the node"))?
        .with(Variable::coordinate("direction", directions).long_name("direction of displacement"))?
        .with(
            Variable::new("place", &["point", "direction"], &[layout.points.len(), 3], places)
                .units("m")
                .long_name("place of the node"),
        )?
        .with(
            Variable::new("line", &["line_number", "line_end"], &[layout.lines.len(), 2], lines)
                .long_name("lines that show the body, as indices of points"),
        )?)
}

/// How many shapes are kept, with a warning where these are not all.
pub(super) fn kept(what: &str, count: usize, bytes: usize, warnings: &mut Vec<String>) -> usize {
    let most = (SHAPE_BYTES / bytes.max(1)).max(1);
    if count > most {
        warnings.push(format!(
            "the {what} of the first {most} of {count} modes are kept: more would be too large"
        ));
    }
    count.min(most)
}

/// Real shapes at all points.
pub(super) fn with_real(
    dataset: Dataset,
    layout: &StructureLayout,
    shapes: &[&[f64]],
    warnings: &mut Vec<String>,
) -> Result<Dataset, ModelError> {
    let points = layout.points.len();
    let kept = kept("shapes", shapes.len(), 24 * points, warnings);
    let values: Vec<f64> = shapes[..kept].iter().flat_map(|shape| layout.displacements(shape)).collect();
    let variable = Variable::new("shape", &["shown_mode", "point", "direction"], &[kept, points, 3], values);
    Ok(dataset.with(variable.units("1/√kg").long_name("shape of the mode, φᵀMφ = 1"))?)
}

/// Complex shapes at all points, of largest displacement 1.
pub(super) fn with_complex(
    dataset: Dataset,
    layout: &StructureLayout,
    shapes: &[Vec<Complex64>],
    warnings: &mut Vec<String>,
) -> Result<Dataset, ModelError> {
    let points = layout.points.len();
    let kept = kept("shapes", shapes.len(), 48 * points, warnings);
    let values: Vec<Complex64> =
        shapes[..kept].iter().flat_map(|shape| layout.displacements(shape)).collect();
    let variable = Variable::new("shape", &["shown_mode", "point", "direction"], &[kept, points, 3], values);
    Ok(dataset.with(variable.units("1").long_name("shape of the mode, its largest displacement 1"))?)
}
