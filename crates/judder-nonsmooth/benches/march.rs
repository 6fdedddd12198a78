//! Steps of a slider in its modes on a moving plane, as a line of JSON: the Rust side of `benches/compare_march.py`.
//!
//! - without arguments: microseconds a step of several sizes;
//! - `steps COUNT`: seconds of so many steps, from the first, of 200 modes with 50 points;
//! - `problem POINTS DIMENSION FOLDER`: one of them, whose matrices, and forces of the first steps, are written to the folder as f64;
//! - `forces POINTS DIMENSION FOLDER TOLERANCE`: these alone, with the contact solved to another tolerance.
//!
//! The slider is a bar in its modes, whose shapes along the contact are cosines turned by drawn angles between normal and slip, so that rigid
//! Coulomb friction couples them; it flutters, and every point sticks and slides in turn.

use faer::sparse::Triplet;
use judder_assembly::assembly::{Assembly, from_triplets};
use judder_assembly::contact_point::ContactPoint;
use judder_assembly::friction::Friction;
use judder_assembly::interface::{Interface, InterfaceLaw};
use judder_assembly::row::Row;
use judder_nonsmooth::bodies::{MovingBodies, StepRule};
use judder_nonsmooth::gauss_seidel::ContactAccuracy;
use judder_nonsmooth::march::{NonsmoothMarch, NonsmoothSettings};
use judder_nonsmooth::scheme::ContactScheme;
use judder_nonsmooth::statistics::Statistics;
use judder_numerics::counter::uniform;
use serde_json::{Value, json};
use std::error::Error;
use std::f64::consts::{PI, TAU};
use std::path::Path;
use std::sync::Arc;
use std::time::Instant;

/// Coulomb's coefficient, the speed of the plane in m/s, the load of the slider in N, its lowest frequency in Hz.
const FRICTION: f64 = 1.0;
const SPEED: f64 = 0.02;
const LOAD: f64 = 1000.0;
const LOWEST: f64 = 500.0;
/// The damping ratio of every mode.
const DAMPING: f64 = 0.002;
/// h in s.
const STEP: f64 = 1e-6;
/// Steps before the first that is timed, and those.
const TRANSIENT: u64 = 10_000;
const TIMED: u64 = 10_000;
/// Runs of which the least time counts.
const REPEATS: usize = 2;
/// Steps whose forces are compared with a peer's.
const COMPARED: usize = 1000;
/// A place below the plane at which all points begin: to touch does not hang on rounding then.
const GAP: f64 = -1e-12;

/// So many modes, points, components of a point.
#[derive(Debug, Clone, Copy)]
struct Size {
    modes: usize,
    points: usize,
    dimension: usize,
}

impl Size {
    fn new(points: usize, dimension: usize) -> Self {
        // more modes than components, or points could not move by themselves
        Self { modes: if points * dimension > 100 { 400 } else { 200 }, points, dimension }
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    // Cargo adds `--bench`.
    let arguments: Vec<String> = std::env::args().skip(1).filter(|argument| argument != "--bench").collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match arguments.as_slice() {
        [] => {
            for (points, dimension) in [(9, 2), (50, 2), (100, 2), (100, 3)] {
                println!("{}", timed(Size::new(points, dimension))?);
            }
        }
        ["steps", count] => println!("{}", whole(Size::new(50, 2), count.parse()?)?),
        ["problem", points, dimension, folder] => {
            let size = Size::new(points.parse()?, dimension.parse()?);
            let first = written(size, Path::new(folder), ContactAccuracy::default())?;
            let mut told = timed(size)?;
            told["first_microseconds"] = json!(first);
            println!("{told}");
        }
        ["forces", points, dimension, folder, tolerance] => {
            let size = Size::new(points.parse()?, dimension.parse()?);
            let accuracy = ContactAccuracy { tolerance: tolerance.parse()?, ..ContactAccuracy::default() };
            written(size, Path::new(folder), accuracy)?;
        }
        _ => eprintln!(
            "SKIPPED: nothing, steps COUNT, problem POINTS DIMENSION FOLDER, or forces POINTS DIMENSION FOLDER TOLERANCE"
        ),
    }
    Ok(())
}

/// What a mode moves at a place along the contact: a cosine turned by angles of its own.
fn shape(mode: usize, place: [f64; 2], dimension: usize) -> [f64; 3] {
    let order = (mode / dimension) as f64;
    let drawn = |stream: u64| uniform(stream, mode as u64);
    let (turn, tilt) = (TAU * drawn(1), if dimension == 3 { PI * drawn(2) } else { 0.0 });
    // waves along the contact; in space also across it
    let across = if dimension == 3 { (4.0 * drawn(3)).floor() * PI * place[1] } else { 0.0 };
    let wave = (order * PI * place[0]).cos() * across.cos();
    [turn.cos(), turn.sin() * tilt.cos(), turn.sin() * tilt.sin()].map(|part| wave * part)
}

fn places(size: Size) -> Vec<[f64; 2]> {
    let columns = if size.dimension == 3 { size.points / 4 } else { size.points };
    let rows = size.points / columns;
    (0..size.points)
        .map(|point| {
            let (column, row) = (point % columns, point / columns);
            [(column as f64 + 0.5) / columns as f64, (row as f64 + 0.5) / rows as f64]
        })
        .collect()
}

fn slider(size: Size) -> Result<Assembly, Box<dyn Error>> {
    let Size { modes, points, dimension } = size;
    let diagonal = |of: &dyn Fn(usize) -> f64| {
        let entries: Vec<_> = (0..modes).map(|mode| Triplet::new(mode, mode, of(mode))).collect();
        from_triplets(modes, modes, &entries)
    };
    let omega =
        |mode: usize| TAU * LOWEST * (1.0 + (mode / dimension) as f64 + 0.3 * uniform(4, mode as u64));
    let places = places(size);
    let point = |place: &[f64; 2]| {
        let row =
            |k: usize| Row::new((0..modes).map(|mode| (mode, shape(mode, *place, dimension)[k])).collect());
        ContactPoint {
            place: [place[0], 0.0, place[1]],
            normal: [0.0, 1.0, 0.0],
            velocity: [SPEED, 0.0, 0.0],
            rest_direction: None,
            area: 1.0,
            gap: GAP,
            relative: [row(1), row(0), if dimension == 3 { row(2) } else { Row::default() }],
            convected: None,
            foot: None,
        }
    };
    // the same pressure on every point
    let load = (0..modes)
        .map(|mode| {
            let all: f64 = places.iter().map(|place| shape(mode, *place, dimension)[0]).sum();
            -LOAD / points as f64 * all
        })
        .collect();
    let interface = Interface {
        name: "sole".to_owned(),
        points: places.iter().map(point).collect(),
        law: InterfaceLaw::Rigid(Friction::Constant(FRICTION)),
        all_closed: false,
    };
    Ok(Assembly {
        mass: Arc::new(diagonal(&|_| 1.0)?),
        damping: Arc::new(diagonal(&|mode| 2.0 * DAMPING * omega(mode))?),
        stiffness: Arc::new(diagonal(&|mode| omega(mode).powi(2))?),
        gyroscopic: Vec::new(),
        load,
        interfaces: vec![interface],
    })
}

fn march(
    assembly: &Assembly,
    size: Size,
    accuracy: ContactAccuracy,
) -> Result<NonsmoothMarch<'_>, Box<dyn Error>> {
    let scheme = ContactScheme::MoreauJean { restitution: 0.0, implicitness: 0.5 };
    let settings = NonsmoothSettings { scheme, step: STEP, accuracy, cut_off: None };
    let mut march = NonsmoothMarch::new(assembly, &[], settings)?;
    march.set_force_scale(LOAD / size.points as f64);
    Ok(march)
}

/// A march from its first step on.
fn whole(size: Size, steps: u64) -> Result<Value, Box<dyn Error>> {
    let assembly = slider(size)?;
    let mut march = march(&assembly, size, ContactAccuracy::default())?;
    let start = Instant::now();
    for _ in 0..steps {
        march.advance()?;
    }
    let seconds = start.elapsed().as_secs_f64();
    let record = march.record();
    Ok(json!({
        "modes": size.modes, "points": size.points, "steps": steps, "seconds": seconds,
        "residual": record.residual, "unsolved": record.unsolved,
    }))
}

fn timed(size: Size) -> Result<Value, Box<dyn Error>> {
    let assembly = slider(size)?;
    let mut march = march(&assembly, size, ContactAccuracy::default())?;
    for _ in 0..TRANSIENT {
        march.advance()?;
    }
    let (mut least, mut statistics) = (f64::INFINITY, Statistics::new(size.points));
    let before = march.record();
    for _ in 0..REPEATS {
        let start = Instant::now();
        for _ in 0..TIMED {
            march.advance()?;
        }
        least = least.min(start.elapsed().as_secs_f64());
    }
    let after = march.record();
    for _ in 0..TIMED {
        march.advance()?;
        statistics.take(&march);
    }
    let points: Vec<_> = (0..size.points).filter_map(|point| statistics.of(point)).collect();
    let mean = |of: &dyn Fn(&judder_nonsmooth::statistics::PointStatistics) -> f64| {
        points.iter().map(of).sum::<f64>() / size.points as f64
    };
    Ok(json!({
        "modes": size.modes, "points": size.points, "dimension": size.dimension,
        "microseconds": 1e6 * least / TIMED as f64,
        "floor_microseconds": 1e6 * floor(&assembly, &march)?,
        "sweeps": (after.iterations - before.iterations) as f64 / (TIMED * REPEATS as u64) as f64,
        "residual": after.residual, "unsolved": after.unsolved,
        "stick_share": mean(&|own| own.stick_share), "slip_share": mean(&|own| own.slip_share),
        "open_share": mean(&|own| own.open_share),
    }))
}

/// Seconds of what no step can do without: the modes moved on, seen at all points and pushed there.
fn floor(assembly: &Assembly, march: &NonsmoothMarch<'_>) -> Result<f64, Box<dyn Error>> {
    let rows = &march.contact().rows;
    let mut bodies = MovingBodies::new(
        assembly,
        rows,
        StepRule { step: STEP, implicitness: 0.5, cut_off: f64::INFINITY },
    )?;
    let (z, v, load) = (vec![1e-6; bodies.size()], vec![1e-3; bodies.size()], vec![1.0; bodies.size()]);
    let (mut next, mut seen, impulse) = (v.clone(), vec![0.0; rows.len()], vec![1e-6; rows.len()]);
    let mut least = f64::INFINITY;
    for _ in 0..REPEATS {
        let start = Instant::now();
        for _ in 0..TIMED {
            bodies.free(&z, &v, &load, &mut next);
            bodies.seen(&next, 0, 1, &mut seen);
            bodies.push(&impulse, &mut next);
            std::hint::black_box((&mut next, &mut seen));
        }
        least = least.min(start.elapsed().as_secs_f64());
    }
    Ok(least / TIMED as f64)
}

/// Writes what a peer needs to march the same, and the forces of the first steps; microseconds that one of these takes.
fn written(size: Size, folder: &Path, accuracy: ContactAccuracy) -> Result<f64, Box<dyn Error>> {
    let assembly = slider(size)?;
    let mut march = march(&assembly, size, accuracy)?;
    let write = |name: &str, values: &[f64]| {
        let bytes: Vec<u8> = values.iter().flat_map(|value| value.to_le_bytes()).collect();
        std::fs::write(folder.join(format!("{name}.f64")), bytes)
    };
    let diagonal = |matrix: &judder_structure::assembly::Sparse| -> Vec<f64> {
        (0..size.modes).map(|mode| matrix.get(mode, mode).copied().unwrap_or(0.0)).collect()
    };
    write("damping", &diagonal(&assembly.damping))?;
    write("stiffness", &diagonal(&assembly.stiffness))?;
    write("load", &assembly.load)?;
    let rows: Vec<f64> = march
        .contact()
        .rows
        .iter()
        .flat_map(|row| {
            let mut full = vec![0.0; size.modes];
            row.add_to(1.0, &mut full);
            full
        })
        .collect();
    write("rows", &rows)?;
    let tolerance = march.settings().accuracy.tolerance;
    let scale = LOAD / size.points as f64;
    write("numbers", &[STEP, FRICTION, SPEED, GAP, scale, tolerance, size.dimension as f64])?;
    let mut forces = Vec::with_capacity(COMPARED * size.points * size.dimension);
    let start = Instant::now();
    for _ in 0..COMPARED {
        march.advance()?;
        for point in 0..size.points {
            forces.extend_from_slice(&march.force(point)[..size.dimension]);
        }
    }
    let seconds = start.elapsed().as_secs_f64();
    write("forces", &forces)?;
    Ok(1e6 * seconds / COMPARED as f64)
}
