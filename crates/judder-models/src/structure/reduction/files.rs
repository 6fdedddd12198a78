//! The reduced structure as files for other programs: matrices, kept freedoms, receptances.

use super::super::fields::label_shift;
use crate::error::ModelError;
use crate::structure::build::{Structure, StructureLayout};
use crate::written::written;
use faer::Mat;
use faer::sparse::Triplet;
use judder_exchange::ExchangeError;
use judder_exchange::freedom_table::write_freedoms;
use judder_exchange::geometry::Geometry;
use judder_exchange::matrix::Matrix;
use judder_exchange::matrix_market::write_matrix_market;
use judder_exchange::universal::{
    Abscissa, MeasuredQuantity, Ordinates, ResponseKind, UniversalResponse, write_nodes, write_response,
    write_units,
};
use judder_numerics::decade::power_of_ten;
use judder_structure::StructureError;
use judder_structure::assembly::Sparse;
use judder_structure::craig_bampton::CraigBampton;
use judder_structure::freedom::{Direction, Freedom};
use judder_structure::modal_form::ModalForm;
use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::TAU;

/// Reduced freedoms beyond which full matrices in text are too large: 50 MB each.
const MOST: usize = 2000;
/// Kept freedoms whose receptance is written.
const RESPONDING: usize = 20;
/// Frequencies of a receptance, at most.
const FREQUENCIES: f64 = 500.0;

/// The reduced matrices, kept freedoms first; the table of these; their receptances up to the limit of the reduction in Hz.
pub(super) fn files(
    name: &str,
    structure: &Structure,
    reduced: &CraigBampton,
    limit: f64,
    warnings: &mut Vec<String>,
) -> Result<Vec<(String, Vec<u8>)>, ModelError> {
    let mut files = Vec::new();
    let rows = reduced.mass.nrows();
    if rows <= MOST {
        for (what, dense) in [("mass", &reduced.mass), ("stiffness", &reduced.stiffness)] {
            let matrix = Matrix::from_sparse(&sparse(dense)?);
            files
                .push((format!("fields/{name}-{what}.mtx"), written(|to| write_matrix_market(to, &matrix))?));
        }
    } else {
        warnings.push(format!("reduced matrices of {rows} freedoms are not written: more than {MOST}"));
    }
    let Some(layout) = &structure.layout else { return Ok(files) };
    let freedoms = places(&structure.kept, layout);
    files.push((format!("fields/{name}-freedoms.csv"), written(|to| write_freedoms(to, &freedoms))?));
    if let Some((step, values)) = receptances(&reduced.modal_form()?, limit) {
        let shift = label_shift(layout);
        let labelled: Vec<Freedom> =
            freedoms.iter().map(|own| Freedom { node: own.node + shift, ..*own }).collect();
        files.push((format!("fields/{name}.unv"), written(|to| universal(to, &labelled, step, &values))?));
    }
    Ok(files)
}

fn sparse(dense: &Mat<f64>) -> Result<Sparse, ModelError> {
    let (rows, columns) = (dense.nrows(), dense.ncols());
    let places = (0..columns).flat_map(|column| (0..rows).map(move |row| (row, column)));
    let entries: Vec<Triplet<usize, usize, f64>> =
        places.map(|(row, column)| Triplet::new(row, column, dense[(row, column)])).collect();
    let sparse = Sparse::try_new_from_triplets(rows, columns, &entries);
    Ok(sparse.map_err(|_| StructureError::OutOfMemory { rows })?)
}

/// Node, direction and place of each freedom; of tied nodes the first.
fn places(freedoms: &[usize], layout: &StructureLayout) -> Vec<Freedom> {
    let mut places = vec![None; freedoms.len()];
    let position: BTreeMap<usize, usize> =
        freedoms.iter().enumerate().map(|(k, freedom)| (*freedom, k)).collect();
    for (point, own) in layout.freedoms.iter().enumerate() {
        for (direction, freedom) in Direction::ALL.into_iter().zip(own) {
            if let Some(k) = freedom.and_then(|freedom| position.get(&freedom)) {
                places[*k].get_or_insert(Freedom {
                    node: layout.names[point],
                    direction,
                    place: layout.points[point],
                });
            }
        }
    }
    places.into_iter().flatten().collect()
}

/// Σ φ²/(ω_e² − ω²) of the first kept freedoms on themselves, in m/N: the step in Hz and their values at ½, 1½, 2½ … steps, up to the
/// limit or, where there is none, to the highest mode; `None` where there is nothing below it.
fn receptances(form: &ModalForm, limit: f64) -> Option<(f64, Vec<Vec<f64>>)> {
    let highest = form.frequencies_hz().last().copied().unwrap_or(0.0);
    let up_to = if limit.is_finite() { limit } else { highest };
    let step = round_step(up_to / FREQUENCIES);
    if !(step > 0.0 && step.is_finite()) {
        return None;
    }
    let count = (up_to / step).floor() as usize;
    let receptance = |freedom: usize, frequency: f64| -> f64 {
        let at = (TAU * frequency).powi(2);
        let of_modes = form.eigenvalues.iter().enumerate();
        of_modes.map(|(mode, value)| form.shapes[(freedom, mode)].powi(2) / (value - at)).sum()
    };
    let of_freedom =
        |freedom: usize| (0..count).map(|k| receptance(freedom, (k as f64 + 0.5) * step)).collect();
    Some((step, (0..form.kept.min(RESPONDING)).map(of_freedom).collect()))
}

/// The next of 1, 2, 5, 10 … times a power of ten: the file holds six digits of it.
fn round_step(least: f64) -> f64 {
    let power = power_of_ten(libm::log10(least).floor());
    [1.0, 2.0, 5.0, 10.0].map(|digit| digit * power).into_iter().find(|step| *step >= least).unwrap_or(0.0)
}

/// Kept nodes and the receptances at them.
fn universal(
    to: &mut dyn std::io::Write,
    freedoms: &[Freedom],
    step: f64,
    receptances: &[Vec<f64>],
) -> Result<(), ExchangeError> {
    write_units(to)?;
    let mut seen = BTreeSet::new();
    let nodes: Vec<&Freedom> = freedoms.iter().filter(|own| seen.insert(own.node)).collect();
    let (labels, places) = nodes.iter().map(|own| (own.node, own.place)).unzip();
    write_nodes(to, &Geometry { places, labels, cells: Vec::new() })?;
    // what stands exactly at a resonance has no receptance there
    let finite = freedoms.iter().zip(receptances).filter(|(_, values)| values.iter().all(|u| u.is_finite()));
    for (Freedom { node, direction, .. }, values) in finite {
        let response = UniversalResponse {
            title: "Receptance of the reduced structure, without damping",
            kind: ResponseKind::FrequencyResponse,
            at: (*node, *direction),
            quantity: MeasuredQuantity::Displacement,
            excited_at: Some((*node, *direction)),
            abscissa: Abscissa::Even { start: 0.5 * step, step },
            ordinates: Ordinates::Real(values),
        };
        write_response(to, &response)?;
    }
    Ok(())
}
