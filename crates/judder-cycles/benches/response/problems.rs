//! What responses are computed of.

use faer::c64;
use faer::sparse::Triplet;
use judder_assembly::assembly::{Assembly, from_triplets};
use judder_assembly::contact_point::ContactPoint;
use judder_assembly::friction::Friction;
use judder_assembly::interface::{Interface, InterfaceLaw};
use judder_assembly::pressure::Pressure;
use judder_assembly::row::Row;
use judder_assembly::steady::{PointState, SteadySliding};
use judder_cycles::CyclesError;
use judder_cycles::balance::{HarmonicBalance, HarmonicForce};
use judder_cycles::forced::{ForcedResponse, ResponseSettings, StepMeasure};
use judder_cycles::path::PathRule;
use judder_cycles::series::Series;
use judder_structure::assembly::Sparse;
use std::error::Error;
use std::sync::Arc;

/// A response that is asked for.
pub(crate) struct Problem {
    assembly: Assembly,
    steady: SteadySliding,
    series: Series,
    force: HarmonicForce,
    observed: usize,
    /// Whether the peak is that of the first harmonic; of the root mean square otherwise.
    fundamental: bool,
    pub(crate) settings: ResponseSettings,
}

impl Problem {
    pub(crate) fn balance(&self) -> Result<HarmonicBalance<'_>, CyclesError> {
        let [from, to] = self.settings.between;
        let forces = std::slice::from_ref(&self.force);
        HarmonicBalance::new(&self.assembly, &self.steady, 0.5 * (from + to), self.series.clone(), forces)
    }

    /// The frequency in rad/s and the amplitude of the observed freedom where that is largest.
    pub(crate) fn peak(
        &self,
        balance: &HarmonicBalance<'_>,
        found: &ForcedResponse,
    ) -> Result<[f64; 2], CyclesError> {
        let row = balance.bodies().on_coordinates(&Row::of_freedom(self.observed));
        let mut peak = [0.0, 0.0];
        for motion in &found.motions {
            let (mean, harmonics) = balance.coordinates(&motion.unknown, motion.turning)?;
            let mean: f64 = row.iter().zip(&mean).map(|(a, b)| a * b).sum();
            let of = |own: &Vec<c64>| row.iter().zip(own).map(|(a, b)| b * *a).sum::<c64>().norm();
            let swing: f64 = harmonics.iter().map(|own| 0.5 * of(own) * of(own)).sum();
            let size = if self.fundamental { of(&harmonics[0]) } else { (mean * mean + swing).sqrt() };
            if size > peak[1] {
                peak = [motion.turning.frequency, size];
            }
        }
        Ok(peak)
    }
}

fn sparse(size: usize, entry: impl Fn(usize, usize) -> f64) -> Result<Sparse, Box<dyn Error>> {
    let all = (0..size * size).map(|k| Triplet::new(k / size, k % size, entry(k / size, k % size)));
    Ok(from_triplets(size, size, &all.filter(|own| own.val != 0.0).collect::<Vec<_>>())?)
}

fn assembled(
    matrices: [Sparse; 3],
    load: Vec<f64>,
    points: Vec<ContactPoint>,
    law: InterfaceLaw,
) -> Assembly {
    let [mass, damping, stiffness] = matrices.map(Arc::new);
    let interfaces = vec![Interface { name: "contact".to_owned(), points, law, all_closed: false }];
    Assembly { mass, damping, stiffness, gyroscopic: Vec::new(), load, interfaces }
}

/// A point on a plane with the normal y, which a freedom lifts, and one may carry along it.
fn point(lifts: Row, along: Row, speed: f64, gap: f64) -> ContactPoint {
    ContactPoint {
        place: [0.0; 3],
        normal: [0.0, 1.0, 0.0],
        velocity: [speed, 0.0, 0.0],
        rest_direction: None,
        area: 1.0,
        gap,
        relative: [along, lifts, Row::default()],
        convected: None,
        foot: None,
    }
}

fn open(freedoms: usize, points: usize, gap: f64) -> SteadySliding {
    let state = PointState { interface: 0, gap, normal_force: 0.0, friction_force: 0.0, is_closed: false };
    SteadySliding { points: vec![state; points], ..SteadySliding::untouched(freedoms) }
}

/// A stop that rises meet: the gap falls as the freedom grows.
fn stop_at(freedom: usize, gap: f64) -> ContactPoint {
    point(Row::new(vec![(freedom, -1.0)]), Row::default(), 1.0, gap)
}

fn force(size: usize, freedom: usize, amplitude: f64) -> HarmonicForce {
    let mut all = vec![c64::ZERO; size];
    all[freedom] = c64::new(amplitude, 0.0);
    HarmonicForce { harmonic: 1, amplitude: all }
}

/// NLvib's example 3, with its harmonics, samples and steps.
pub(crate) fn stop() -> Result<Problem, Box<dyn Error>> {
    let stiffness = [[1.0, -1.0], [-1.0, 2.0]];
    let matrices = [
        sparse(2, |i, j| f64::from(u8::from(i == j)))?,
        sparse(2, |i, j| 0.03 * stiffness[i][j])?,
        sparse(2, |i, j| stiffness[i][j])?,
    ];
    let law = InterfaceLaw::Compliant(Pressure::PointStiffness(100.0), Friction::Constant(0.0));
    Ok(Problem {
        assembly: assembled(matrices, vec![0.0; 2], vec![stop_at(0, 1.0)], law),
        steady: open(2, 1, 1.0),
        series: Series::new(21, 1024),
        force: force(2, 1, 0.1),
        observed: 0,
        fundamental: false,
        settings: ResponseSettings {
            rule: PathRule { steps: [0.05, 0.2, 1e-6], tolerance: 1e-7, ..PathRule::default() },
            between: [0.8, 0.5806],
            points: 5000,
            pace: StepMeasure::Fixed(1.0),
        },
    })
}

/// VM320.
pub(crate) fn damper() -> Result<Problem, Box<dyn Error>> {
    const SLIPS: f64 = 246.048;
    let stiffness = [[4.8e7, -2.4e7, 0.0], [-2.4e7, 2.4e7, 0.0], [0.0, 0.0, 1e7]];
    let matrices = [
        sparse(3, |i, j| if i + j == 0 { 944.6 } else { 0.0 })?,
        sparse(3, |i, j| if i + j == 0 { 7700.0 } else { 0.0 })?,
        sparse(3, |i, j| stiffness[i][j])?,
    ];
    let contact = ContactPoint {
        rest_direction: Some([1.0, 0.0, 0.0]),
        ..point(Row::of_freedom(2), Row::of_freedom(1), 0.0, 0.0)
    };
    let law = InterfaceLaw::Rigid(Friction::Constant(1.0));
    let state =
        PointState { interface: 0, gap: 0.0, normal_force: SLIPS, friction_force: 0.0, is_closed: true };
    Ok(Problem {
        assembly: assembled(matrices, vec![0.0, 0.0, -SLIPS], vec![contact], law),
        steady: SteadySliding { points: vec![state], ..SteadySliding::untouched(3) },
        series: Series::new(31, 1024),
        force: force(3, 0, 0.5 * SLIPS),
        observed: 0,
        fundamental: true,
        settings: ResponseSettings {
            rule: PathRule { steps: [0.01, 0.01, 1e-7], tolerance: 1e-8, ..PathRule::default() },
            between: [143.0, 271.0],
            points: 5000,
            pace: StepMeasure::Fixed(SLIPS),
        },
    })
}

/// Stiffness and mass of an Euler–Bernoulli element on displacement and slope at its ends, of E I/l³ and ρ A l/420.
fn element(length: f64) -> [[[f64; 4]; 4]; 2] {
    let l = length;
    let q = l * l;
    [
        [
            [12.0, 6.0 * l, -12.0, 6.0 * l],
            [6.0 * l, 4.0 * q, -6.0 * l, 2.0 * q],
            [-12.0, -6.0 * l, 12.0, -6.0 * l],
            [6.0 * l, 2.0 * q, -6.0 * l, 4.0 * q],
        ],
        [
            [156.0, 22.0 * l, 54.0, -13.0 * l],
            [22.0 * l, 4.0 * q, 13.0 * l, -3.0 * q],
            [54.0, 13.0 * l, 156.0, -22.0 * l],
            [-13.0 * l, -3.0 * q, -22.0 * l, 4.0 * q],
        ],
    ]
}

/// A steel cantilever, 0.6 × 0.04 × 0.005 m, over 50 stops of 200 N/m with gaps of 1 mm, driven at its tip by 0.1 N.
pub(crate) fn beam() -> Result<Problem, Box<dyn Error>> {
    const ELEMENTS: usize = 60;
    const FREEDOMS: usize = 2 * ELEMENTS;
    const FIRST: [f64; 2] = [73.1458981052, 458.397533107];
    let (length, width, height) = (0.6 / ELEMENTS as f64, 0.04, 0.005);
    let (modulus, density) = (210e9, 7800.0);
    let [stiffness, mass] = element(length);
    let bending = modulus * width * height * height * height / 12.0 / (length * length * length);
    let inertia = density * width * height * length / 420.0;
    // freedoms of the node at the start of an element are those before it; the first node is clamped
    let entry = |table: &[[f64; 4]; 4], factor: f64, i: usize, j: usize| {
        let of = |element: usize| match [i + 2, j + 2].map(|k| k.checked_sub(2 * element).filter(|k| *k < 4))
        {
            [Some(row), Some(column)] => factor * table[row][column],
            _ => 0.0,
        };
        (0..ELEMENTS).map(of).sum::<f64>()
    };
    let beta = 0.02 / (FIRST[0] + FIRST[1]);
    let alpha = beta * FIRST[0] * FIRST[1];
    let matrices = [
        sparse(FREEDOMS, |i, j| entry(&mass, inertia, i, j))?,
        sparse(FREEDOMS, |i, j| {
            alpha * entry(&mass, inertia, i, j) + beta * entry(&stiffness, bending, i, j)
        })?,
        sparse(FREEDOMS, |i, j| entry(&stiffness, bending, i, j))?,
    ];
    let points: Vec<ContactPoint> = (11..=ELEMENTS).map(|node| stop_at(2 * (node - 1), 1e-3)).collect();
    let law = InterfaceLaw::Compliant(Pressure::PointStiffness(200.0), Friction::Constant(0.0));
    let tip = 2 * (ELEMENTS - 1);
    Ok(Problem {
        steady: open(FREEDOMS, points.len(), 1e-3),
        assembly: assembled(matrices, vec![0.0; FREEDOMS], points, law),
        series: Series::new(9, 512),
        force: force(FREEDOMS, tip, 0.1),
        observed: tip,
        fundamental: false,
        settings: ResponseSettings {
            rule: PathRule { steps: [0.02, 0.1, 1e-7], tolerance: 1e-7, ..PathRule::default() },
            between: [0.85 * FIRST[0], 1.3 * FIRST[0]],
            points: 5000,
            pace: StepMeasure::Fixed(1.0),
        },
    })
}
