//! Wall times of converged sliding contacts and of whole laws, as JSON lines: the Rust side of `benches/compare_sliding.py`.
//!
//! `sliding contact CELLS CONTRAST Z`: one contact of a paraboloid, `CELLS` a side, all grids and kernels counted.
//! `sliding collapse ACCURACY` and `sliding sphere ACCURACY POINTS`: a law for E∞/E0 = 10, by the collapse, and on a grid of `POINTS` × `POINTS`
//! speeds and depths, those of Fig. 3, on all cores; a contact without a solution is an error.

use judder_contact::kernel::check::KernelError;
use judder_contact::kernel::sliding::SlidingOperator;
use judder_contact::kernel::substrate::SlidingSubstrate;
use judder_contact::law::boundary_elements::{SampleError, sample};
use judder_contact::law::sweep::{CollapseRequest, LawSample, SweepRange, collapse_sweep};
use judder_contact::law::{LawIndenter, LawMaterial, PerQuantity};
use judder_contact::steady::profile::Paraboloid;
use judder_contact::steady::{GridChoice, MEMORY, SteadyContact, SteadyQuestion, solve};
use judder_contact::surface::operator::SurfaceOperator;
use judder_contact::unilateral::{Loading, UnilateralLimits};
use rayon::prelude::*;
use std::time::Instant;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<String> =
        std::env::args().skip(1).filter(|argument| !argument.starts_with("--")).collect();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>().as_slice() {
        ["contact", cells, contrast, z] => contact(cells.parse()?, contrast.parse()?, z.parse()?),
        ["collapse", accuracy] => collapse(accuracy.parse()?),
        ["sphere", accuracy, points] => sphere(accuracy.parse()?, points.parse()?),
        _ => {
            println!("sliding contact CELLS CONTRAST Z | collapse ACCURACY | sphere ACCURACY POINTS");
            Ok(())
        }
    }
}

fn one_contact(cells: usize, contrast: f64, z: f64) -> Result<SteadyContact, Box<dyn std::error::Error>> {
    let substrate = SlidingSubstrate::single(contrast, z);
    Ok(solve(&SteadyQuestion {
        substrate: &substrate,
        profile: &Paraboloid,
        loading: Loading::Indentation(1.0),
        accuracy: 1e-2,
        grid: GridChoice::Cells(cells),
        limits: UnilateralLimits::default(),
        memory: MEMORY,
    })?)
}

fn contact(cells: usize, contrast: f64, z: f64) -> Result<(), Box<dyn std::error::Error>> {
    // The least of several: other work on the machine only ever adds.
    let mut seconds = f64::INFINITY;
    let mut answer = one_contact(cells, contrast, z)?;
    for _ in 0..5 {
        let start = Instant::now();
        answer = one_contact(cells, contrast, z)?;
        seconds = seconds.min(start.elapsed().as_secs_f64());
    }
    let finest = &answer.refinement.levels[answer.refinement.levels.len() - 1];
    let floor = finest.products as f64 * seconds_a_product(&answer, &SlidingSubstrate::single(contrast, z))?;
    println!(
        r#"{{"seconds": {seconds}, "floor_seconds": {floor}, "force": {}, "friction": {}, "residual": {}, "converged": {}, "products": {}, "products_finest": {}}}"#,
        finest.force,
        finest.friction,
        finest.residual,
        answer.refinement.levels.iter().all(|level| level.converged),
        answer.products,
        finest.products,
    );
    Ok(())
}

/// The least time of a product with the kernel of the finest grid.
fn seconds_a_product(answer: &SteadyContact, substrate: &SlidingSubstrate) -> Result<f64, KernelError> {
    let mut operator = SlidingOperator::new(answer.finest.grid, substrate, MEMORY)?;
    let pressure = &answer.finest.solution.pressure;
    let mut displacement = vec![0.0; pressure.len()];
    let mut least = f64::INFINITY;
    for _ in 0..5 {
        let start = Instant::now();
        operator.displacement(std::hint::black_box(pressure), &mut displacement);
        least = least.min(start.elapsed().as_secs_f64());
    }
    Ok(least)
}

fn collapse(accuracy: f64) -> Result<(), Box<dyn std::error::Error>> {
    let material = LawMaterial::one_time(10.0)?;
    let request = CollapseRequest {
        ln_speeds: SweepRange::all_speeds(&material),
        material: material.clone(),
        source: "benchmark".into(),
        indentation: 1e-3,
        accuracy: PerQuantity { force: accuracy, area: accuracy, friction: accuracy },
        most_points: 500,
    };
    let sampler = |velocity: f64, indentation: f64| {
        sample(&material, LawIndenter::Paraboloid, velocity, indentation, 0.2 * accuracy, MEMORY)
    };
    let start = Instant::now();
    let law = collapse_sweep(&request, &[], &sampler, &())?;
    println!(r#"{{"seconds": {}, "points": {}}}"#, start.elapsed().as_secs_f64(), law.points.len());
    Ok(())
}

fn sphere(accuracy: f64, points: usize) -> Result<(), Box<dyn std::error::Error>> {
    let material = LawMaterial::one_time(10.0)?;
    let even = |from: f64, to: f64, index: usize| from * (to / from).powf(index as f64 / (points - 1) as f64);
    let start = Instant::now();
    let solved: Result<Vec<LawSample>, SampleError> = (0..points * points)
        .into_par_iter()
        .map(|index| {
            let (velocity, depth) = (even(1e-4, 1e4, index % points), even(1e-4, 1e-1, index / points));
            sample(&material, LawIndenter::Sphere, velocity, depth, accuracy, MEMORY)
        })
        .collect();
    println!(r#"{{"seconds": {}, "points": {}}}"#, start.elapsed().as_secs_f64(), solved?.len());
    Ok(())
}
