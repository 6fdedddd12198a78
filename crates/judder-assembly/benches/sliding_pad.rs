//! A pad that slides on a strip, both elastic, as a line of JSON: one Rust side of `benches/compare_assemblies.py`.
//!
//! - `modes FOLDER`: all modes of a band about steady sliding, 20 000 freedoms and 400 contact points; M, C and K are written to the
//!   folder, as `NAME-starts.i64`, `NAME-rows.i64`, `NAME-values.f64` of their columns.
//! - `steady`: steady sliding of 2000 rigid contact points, and the factorisation alone.

use faer::sparse::Triplet;
use judder_assembly::assembly::{Assembly, from_triplets, triplets};
use judder_assembly::compliance::Compliance;
use judder_assembly::friction::Friction;
use judder_assembly::interface::{Interface, InterfaceLaw};
use judder_assembly::linearised::{Linearised, LinearisedTerms};
use judder_assembly::pressure::Pressure;
use judder_assembly::row::Row;
use judder_assembly::search::{
    FoundPoints, KeptOfFaces, Sliding, TouchingBody, Track, contact_points, usual_reach,
};
use judder_assembly::steady::steady_sliding;
use judder_assembly::surface::Surface;
use judder_structure::assembly::{Assembled, Sparse, assemble};
use judder_structure::complex_modes::{ComplexModeSettings, Region, complex_modes};
use judder_structure::damping::RayleighDamping;
use judder_structure::element::ElementKind;
use judder_structure::factor::SymmetricFactor;
use judder_structure::freedom::{Direction, Numbering, Supports};
use judder_structure::grid::Grid;
use judder_structure::material::{Elastic, ElementSection};
use judder_structure::mesh::Mesh;
use judder_structure::quadratic::Quadratic;
use judder_structure::receptance::receptances;
use serde_json::{Value, json};
use std::error::Error;
use std::f64::consts::TAU;
use std::path::Path;
use std::sync::Arc;
use std::time::Instant;

/// Runs of the modes, of judder as of its peers.
const REPEATS: usize = 1;
/// Runs of steady sliding and of the factorisation beneath it, the least of which count.
const SHORT_REPEATS: usize = 3;
/// The band of the modes, in Hz, and the growth rates it holds, over its upper end.
const BAND: [f64; 2] = [1e3, 2e4];
const STEEPNESS: f64 = 0.5;

fn main() -> Result<(), Box<dyn Error>> {
    // Cargo adds `--bench`.
    let arguments: Vec<String> = std::env::args().skip(1).filter(|argument| argument != "--bench").collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let told = match arguments.as_slice() {
        ["modes", folder] => modes(Path::new(folder))?,
        ["steady"] => steady()?,
        _ => {
            eprintln!(
                "SKIPPED: benches/compare_assemblies.py runs this with what it wants: modes FOLDER, or steady"
            );
            return Ok(());
        }
    };
    println!("{told}");
    Ok(())
}

/// The least wall time of some calls, in seconds, and the last result.
fn least<T>(
    repeats: usize,
    mut work: impl FnMut() -> Result<T, Box<dyn Error>>,
) -> Result<(f64, T), Box<dyn Error>> {
    let mut best = f64::INFINITY;
    let mut last = None;
    for _ in 0..repeats {
        let start = Instant::now();
        let result = work()?;
        best = best.min(start.elapsed().as_secs_f64());
        last = Some(result);
    }
    Ok((best, last.ok_or("no run")?))
}

/// A body of bricks.
struct Body {
    mesh: Mesh,
    numbering: Numbering,
    assembled: Assembled,
    damping: Sparse,
}

impl Body {
    fn new(
        [origin, size]: [[f64; 3]; 2],
        cells: [usize; 3],
        material: Elastic,
        held: &[(&str, &[Direction])],
    ) -> Result<Self, Box<dyn Error>> {
        let moved = |place: [f64; 3]| std::array::from_fn(|k| origin[k] + place[k]);
        let mesh = Grid { kind: ElementKind::Hexahedron8, size, cells }.mesh("own", moved)?;
        let nodes = |set: &str| mesh.node_sets[set].clone();
        let fixed = held.iter().flat_map(|(set, directions)| {
            nodes(set).into_iter().flat_map(|node| directions.iter().map(move |direction| (node, *direction)))
        });
        let supports = Supports { fixed: fixed.collect(), ..Supports::default() };
        let numbering = Numbering::new(&mesh, 3, &supports)?;
        let materials = [("own".to_owned(), (material, ElementSection::Solid))].into();
        let assembled = assemble(&mesh, &materials, &numbering)?;
        let damping = RayleighDamping::new(10.0, 1e-8)?.matrix(&assembled.stiffness, &assembled.mass)?;
        Ok(Self { mesh, numbering, assembled, damping })
    }

    fn size(&self) -> usize {
        self.numbering.freedoms().len()
    }
}

/// The pad on the strip.
fn machine(pad: [usize; 3], strip: [usize; 3], law: InterfaceLaw) -> Result<Assembly, Box<dyn Error>> {
    let all = &Direction::ALL[..];
    let cast_iron = Elastic::new(1.1e11, 0.28, 7200.0)?;
    let strip =
        Body::new([[0.0; 3], [0.16, 0.08, 0.008]], strip, cast_iron, &[("x-min", all), ("x-max", all)])?;
    let lining = Elastic::new(8e9, 0.3, 2500.0)?;
    let held: [(&str, &[Direction]); 2] = [("x-max", &[Direction::X]), ("y-min", &[Direction::Y])];
    let pad = Body::new([[0.05, 0.01, 0.008], [0.06, 0.06, 0.012]], pad, lining, &held)?;
    let bodies = [&strip, &pad];
    let stacked =
        |pick: fn(&Body) -> &Sparse| judder_assembly::assembly::stacked(&bodies.map(pick)).map(Arc::new);
    let mut load = vec![0.0; strip.size() + pad.size()];
    let top = Surface::of_nodes(&pad.mesh, &pad.mesh.node_sets["z-max"])?;
    for (node, area) in top.nodal_areas(&pad.mesh) {
        if let Some(freedom) = pad.numbering.number(node, Direction::Z) {
            load[strip.size() + freedom] -= 1e6 * area[2];
        }
    }
    let points = found(&pad, &strip)?;
    let lining = Interface { name: "lining".to_owned(), points: points.points, law, all_closed: false };
    Ok(Assembly {
        mass: stacked(|body| &body.assembled.mass)?,
        damping: stacked(|body| &body.damping)?,
        stiffness: stacked(|body| &body.assembled.stiffness)?,
        gyroscopic: Vec::new(),
        load,
        interfaces: vec![lining],
    })
}

/// The contact points of the pad on the strip, whose freedoms come first.
fn found(pad: &Body, strip: &Body) -> Result<FoundPoints, Box<dyn Error>> {
    let row = |freedom: Option<usize>| freedom.map_or_else(Row::default, Row::of_freedom);
    let on_pad =
        |node, direction| row(pad.numbering.number(node, direction).map(|freedom| strip.size() + freedom));
    let on_strip = |node, direction| row(strip.numbering.number(node, direction));
    let still = |_| [0.0; 3];
    let touching = |mesh, displacement| TouchingBody {
        mesh,
        width: 1.0,
        displacement,
        displaced: &still,
        kept: KeptOfFaces::default(),
    };
    let slider = touching(&pad.mesh, &on_pad as &dyn Fn(usize, Direction) -> Row);
    let (under, over) = (&pad.mesh.node_sets["z-min"], &strip.mesh.node_sets["z-max"]);
    let reach = usual_reach(&strip.mesh, &Surface::of_nodes(&strip.mesh, over)?);
    let track = Track::Body(touching(&strip.mesh, &on_strip), over);
    Ok(contact_points(&slider, under, &track, Sliding::Translation([2.0, 0.0, 0.0]), reach)?)
}

/// 20 000 freedoms and 400 contact points whose interface yields.
fn modes(folder: &Path) -> Result<Value, Box<dyn Error>> {
    let law = InterfaceLaw::Compliant(Pressure::Stiffness(2e12), Friction::Constant(0.5));
    let assembly = machine([19, 19, 5], [42, 26, 3], law)?;
    let steady = steady_sliding(&assembly, &Compliance::new(&assembly)?)?;
    let about = Linearised::new(&assembly, &steady, LinearisedTerms::default())?;
    let problem = &about.problem;
    for (name, matrix) in
        [("mass", problem.mass()), ("damping", problem.damping()), ("stiffness", problem.stiffness())]
    {
        write(folder, name, matrix)?;
    }
    let [from, to] = BAND.map(|frequency| TAU * frequency);
    let region = Region { re: [-STEEPNESS * to, STEEPNESS * to], im: [from, to] };
    // anew each time: a problem keeps the order of elimination
    let anew =
        || Quadratic::new(problem.mass().clone(), problem.damping().clone(), problem.stiffness().clone());
    let (seconds, found) =
        least(REPEATS, || Ok(complex_modes(&anew()?, &region, &ComplexModeSettings::default())?))?;
    let shifts: Vec<f64> = found.shifts.iter().map(|shift| shift.im).collect();
    // of each frequency one factorisation and two solutions
    let (floor, _) =
        least(REPEATS, || Ok(receptances(&anew()?, 0, 0, &shifts, &ComplexModeSettings::default().memory)?))?;
    let values: Vec<[f64; 2]> =
        found.modes.iter().map(|mode| [mode.eigenvalue.value.re, mode.eigenvalue.value.im]).collect();
    Ok(json!({
        "freedoms": problem.size(), "points": steady.points.len(), "seconds": seconds, "floor_seconds": floor, "complete": found.complete(),
        "re": region.re, "im": region.im, "shifts": shifts, "eigenvalues": values,
        "closed": steady.points.iter().filter(|point| point.is_closed).count(),
    }))
}

/// 2000 rigid contact points.
fn steady() -> Result<Value, Box<dyn Error>> {
    let assembly = machine([49, 39, 2], [40, 26, 2], InterfaceLaw::Rigid(Friction::Constant(0.4)))?;
    let (seconds, found) =
        least(SHORT_REPEATS, || Ok(steady_sliding(&assembly, &Compliance::new(&assembly)?)?))?;
    let floor = factorisation(&assembly)?;
    Ok(json!({
        "freedoms": assembly.size(), "points": found.points.len(), "seconds": seconds, "floor_seconds": floor,
        "closed": found.points.iter().filter(|point| point.is_closed).count(),
        "iterations": found.iterations, "residual": found.residual,
    }))
}

/// Seconds to order and to factor the stiffness with springs at the contact points, which hold the pad: what any way to steady sliding takes.
fn factorisation(assembly: &Assembly) -> Result<f64, Box<dyn Error>> {
    let mut entries: Vec<_> = triplets(&assembly.stiffness).collect();
    for point in assembly.framed()? {
        let normal = point.frame.normal.entries();
        for (row, a) in normal {
            entries.extend(normal.iter().map(|(column, b)| Triplet::new(*row, *column, 1e9 * a * b)));
        }
    }
    let held = from_triplets(assembly.size(), assembly.size(), &entries)?;
    Ok(least(SHORT_REPEATS, || Ok(SymmetricFactor::new(&held)?))?.0)
}

fn write(folder: &Path, name: &str, matrix: &Sparse) -> Result<(), Box<dyn Error>> {
    let numbers =
        |numbers: &[usize]| numbers.iter().flat_map(|n| (*n as u64).to_le_bytes()).collect::<Vec<_>>();
    std::fs::write(folder.join(format!("{name}-starts.i64")), numbers(matrix.col_ptr()))?;
    std::fs::write(folder.join(format!("{name}-rows.i64")), numbers(matrix.row_idx()))?;
    let values: Vec<u8> = matrix.val().iter().flat_map(|value| value.to_le_bytes()).collect();
    Ok(std::fs::write(folder.join(format!("{name}-values.f64")), values)?)
}
