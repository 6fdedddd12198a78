//! Reads a file of another program and writes what another one reads; the Python tests hold both against other libraries.
//!
//! usage: exchange FROM TO
//!
//! A matrix (.mtx, .mat, .npz) becomes a .mtx. A mesh (.msh, .inp) becomes a .vtu, a .pvd with its frames, or a .unv, with the shape
//! φ = (x + i y, y − i x, z) at 2 + 300 i 1/s.

use faer::c64;
use judder_exchange::ExchangeError;
use judder_exchange::geometry::Geometry;
use judder_exchange::matrix::read_matrix;
use judder_exchange::matrix_market::write_matrix_market;
use judder_exchange::mesh_file::read_mesh;
use judder_exchange::universal::{
    Abscissa, ComplexShape, MeasuredQuantity, Ordinates, RealShape, ResponseKind, UniversalResponse,
    write_complex_shape, write_lines, write_nodes, write_real_shape, write_response, write_units,
};
use judder_exchange::vtu::{Animation, FieldValues, VtuField, complex_fields, write_animation, write_vtu};
use judder_exchange::whole_file::write_file;
use judder_structure::freedom::Direction;
use std::error::Error;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::from(2)
        }
    }
}

fn run() -> Result<(), Box<dyn Error>> {
    let paths: Vec<PathBuf> = std::env::args_os().skip(1).map(PathBuf::from).collect();
    let [from, to] = paths.as_slice() else { return Err("usage: exchange FROM TO".into()) };
    if to.extension().is_some_and(|extension| extension == "mtx") {
        let matrix = read_matrix(from)?;
        return Ok(write_file(to, |out| write_matrix_market(out, &matrix))?);
    }
    let file = read_mesh(from)?;
    for warning in &file.warnings {
        eprintln!("{warning}");
    }
    let geometry = Geometry { labels: file.node_labels.clone(), ..Geometry::from(&file.mesh) };
    let shape: Vec<[c64; 3]> = geometry
        .places
        .iter()
        .map(|[x, y, z]| [c64::new(*x, *y), c64::new(*y, -x), c64::new(*z, 0.0)])
        .collect();
    write(to, &geometry, &shape, &file.node_labels)?;
    Ok(())
}

fn write(to: &Path, geometry: &Geometry, shape: &[[c64; 3]], labels: &[usize]) -> Result<(), ExchangeError> {
    let extension = to.extension().and_then(|extension| extension.to_str());
    match extension {
        Some("pvd") => {
            let name = to.file_stem().and_then(|stem| stem.to_str()).unwrap_or("shape");
            let folder = to.parent().unwrap_or(Path::new("."));
            let animation = Animation { name, shape, period: 0.02, frames: 8 };
            write_animation(folder, geometry, &animation).map(drop)
        }
        Some("unv") => write_file(to, |out| write_universal(out, geometry, shape)),
        _ => {
            let mut fields = complex_fields("shape", shape);
            let numbers = labels.iter().map(|label| *label as f64).collect();
            fields.push(VtuField { name: String::from("label"), values: FieldValues::Scalars(numbers) });
            write_file(to, |out| write_vtu(out, geometry, &fields))
        }
    }
}

fn write_universal(
    out: &mut dyn Write,
    geometry: &Geometry,
    shape: &[[c64; 3]],
) -> Result<(), ExchangeError> {
    write_units(out)?;
    write_nodes(out, geometry)?;
    write_lines(out, geometry)?;
    let eigenvalue = c64::new(2.0, 300.0);
    let real: Vec<[f64; 3]> = shape.iter().map(|own| own.map(|value| value.re)).collect();
    let mode =
        RealShape { number: 1, frequency_hz: 47.5, modal_mass: 1.0, damping_ratio: 0.01, shape: &real };
    write_real_shape(out, geometry, &mode)?;
    let modal_a = c64::new(0.5, 600.0);
    write_complex_shape(out, geometry, &ComplexShape { number: 2, eigenvalue, modal_a, shape })?;
    let history: Vec<f64> = (0..10).map(|k| (0.1 * f64::from(k)).sin()).collect();
    let response = UniversalResponse {
        title: "A history",
        kind: ResponseKind::TimeHistory,
        at: (3, Direction::Z),
        quantity: MeasuredQuantity::Acceleration,
        excited_at: None,
        abscissa: Abscissa::Even { start: 0.5, step: 0.1 },
        ordinates: Ordinates::Real(&history),
    };
    write_response(out, &response)?;
    let frequencies = [1.0, 10.0, 100.0];
    let values = [c64::new(1.0, -0.5), c64::new(-2e-7, 3e12), c64::new(0.0, 0.0)];
    let response = UniversalResponse {
        title: "A frequency response",
        kind: ResponseKind::FrequencyResponse,
        excited_at: Some((1, Direction::X)),
        quantity: MeasuredQuantity::Displacement,
        abscissa: Abscissa::Uneven(&frequencies),
        ordinates: Ordinates::Complex(&values),
        ..response
    };
    write_response(out, &response)
}
