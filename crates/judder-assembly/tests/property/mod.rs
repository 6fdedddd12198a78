//! What holds for every assembly.

use crate::common::{dense, undamped};
use faer::sparse::Triplet;
use faer::{Mat, c64};
use judder_assembly::assembly::{Assembly, from_triplets, triplets};
use judder_assembly::compliance::Compliance;
use judder_assembly::contact_point::ContactPoint;
use judder_assembly::friction::{FallingFriction, Friction};
use judder_assembly::interface::{FramedPoint, Interface, InterfaceLaw};
use judder_assembly::linearised::{Linearised, LinearisedTerms};
use judder_assembly::pressure::Pressure;
use judder_assembly::row::Row;
use judder_assembly::steady::{PointState, SteadySliding, steady_sliding};
use judder_assembly::work::growth_shares;
use judder_dense::general::{complex_eigen, real_eigenvalues};
use judder_structure::assembly::Sparse;
use judder_structure::complex_modes::{ComplexModeSettings, Region, complex_modes};
use proptest::prelude::*;

/// Nodes of either body; each moves along x and y.
const NODES: usize = 3;
const SIZE: usize = 4 * NODES;

/// Two bodies of random symmetric matrices that touch at two points; the track's place lies between two of its nodes.
fn assembly(numbers: &[f64], friction: f64, share: f64) -> Assembly {
    let half = SIZE / 2;
    let symmetric = |from: usize, least: f64| -> Sparse {
        let mut rows = vec![vec![0.0; SIZE]; SIZE];
        for body in 0..2 {
            let at = |i: usize, j: usize| numbers[from + (body * half + i) * half + j];
            for i in 0..half {
                for j in 0..half {
                    let product: f64 = (0..half).map(|k| at(i, k) * at(j, k)).sum();
                    rows[body * half + i][body * half + j] = product + if i == j { least } else { 0.0 };
                }
            }
        }
        dense(&rows.iter().map(Vec::as_slice).collect::<Vec<_>>())
    };
    let count = 2 * half * half;
    let row = |entries: Vec<(usize, f64)>| Row::new(entries);
    let point = |node: usize| {
        let along = |direction: usize| {
            let track = half + 2 * node + direction;
            row(vec![(2 * node + direction, 1.0), (track, -share), (track + 2, share - 1.0)])
        };
        ContactPoint {
            place: [node as f64, 0.0, 0.0],
            normal: [0.0, 1.0, 0.0],
            velocity: [1.0, 0.0, 0.0],
            rest_direction: None,
            area: 1.0,
            gap: 0.0,
            relative: [along(0), along(1), row(Vec::new())],
            convected: None,
            foot: None,
        }
    };
    let mut load = vec![0.0; SIZE];
    (0..NODES).for_each(|node| load[2 * node + 1] = -1.0);
    let sole = Interface {
        name: "sole".to_owned(),
        points: vec![point(0), point(1)],
        law: InterfaceLaw::Rigid(Friction::Constant(friction)),
        all_closed: true,
    };
    undamped(symmetric(0, 1.0), symmetric(count, 2.0), load, vec![sole])
}

/// The same with circulation in the stiffness of the slider, between its first node's displacements.
fn circulating(numbers: &[f64], friction: f64, share: f64, circulation: f64) -> Assembly {
    let assembly = assembly(numbers, friction, share);
    let mut entries: Vec<_> = triplets(&assembly.stiffness).collect();
    entries.extend([Triplet::new(0, 1, circulation), Triplet::new(1, 0, -circulation)]);
    let stiffness = from_triplets(SIZE, SIZE, &entries).unwrap();
    Assembly { stiffness: stiffness.into(), ..assembly }
}

/// The same with damped bodies, friction that falls, and rigid points, or points on springs.
fn damped(numbers: &[f64], friction: f64, share: f64, spring: Option<f64>) -> Assembly {
    let mut assembly = assembly(numbers, friction, share);
    let share = |of: &Sparse, factor: f64| -> Vec<_> {
        triplets(of).map(|own| Triplet::new(own.row, own.col, factor * own.val)).collect()
    };
    let entries = [share(&assembly.mass, 0.05), share(&assembly.stiffness, 0.01)].concat();
    assembly.damping = from_triplets(SIZE, SIZE, &entries).unwrap().into();
    let falling = FallingFriction::exponential([friction + 0.3, friction], 0.8);
    assembly.interfaces[0].law = match spring {
        None => InterfaceLaw::Rigid(Friction::Falling(falling)),
        Some(stiffness) => {
            InterfaceLaw::Compliant(Pressure::PointStiffness(stiffness), Friction::Falling(falling))
        }
    };
    assembly
}

/// A point as the other formulations have it: forces δN = e-wise with c δq + δN/k = 0, and the damping N μ′ tᵀt.
struct OtherPoint {
    normal: Row,
    equilibrium: Row,
    slip: Row,
    /// 1/k, zero of a rigid one.
    yielding: f64,
    /// N μ′.
    follows_speed: f64,
}

fn other_points(assembly: &Assembly, steady: &SteadySliding) -> Vec<OtherPoint> {
    let framed = assembly.framed().unwrap();
    let other = |(point, state): (&FramedPoint<'_>, &PointState)| {
        let (friction, yielding) = match point.law {
            InterfaceLaw::Rigid(friction) => (friction, 0.0),
            InterfaceLaw::Compliant(Pressure::PointStiffness(stiffness), friction) => {
                (friction, 1.0 / stiffness)
            }
            _ => panic!("no such law here"),
        };
        let friction = friction.at(point.frame.speed);
        OtherPoint {
            normal: point.frame.normal.clone(),
            equilibrium: point.equilibrium(friction.coefficient),
            slip: point.frame.slip.clone(),
            yielding,
            follows_speed: state.normal_force.max(0.0) * friction.slope,
        }
    };
    framed.iter().zip(&steady.points).map(other).collect()
}

/// C + Σ N μ′ tᵀt.
fn damping(assembly: &Assembly, points: &[OtherPoint]) -> Mat<f64> {
    let mut damping = Mat::<f64>::zeros(SIZE, SIZE);
    triplets(&assembly.damping).for_each(|own| damping[(own.row, own.col)] += own.val);
    for point in points {
        for (i, a) in point.slip.entries() {
            point.slip.entries().iter().for_each(|(j, b)| damping[(*i, *j)] += point.follows_speed * a * b);
        }
    }
    damping
}

/// λ of (λ² M + λ C + K, −e; c, 1/k) by inverting beside a shift; those at infinity come out far away.
fn by_multipliers(assembly: &Assembly, framed: &[OtherPoint]) -> Vec<c64> {
    let damping = damping(assembly, framed);
    let (size, points) = (SIZE, framed.len());
    let all = 2 * size + points;
    let (mut a, mut b) = (Mat::<f64>::zeros(all, all), Mat::<f64>::zeros(all, all));
    for k in 0..size {
        (a[(k, size + k)], b[(k, k)]) = (1.0, 1.0);
    }
    for (matrix, target, sign, column_from) in
        [(&assembly.stiffness, &mut a, -1.0, 0), (&assembly.mass, &mut b, 1.0, size)]
    {
        for column in 0..size {
            for (row, value) in matrix.row_idx_of_col(column).zip(matrix.val_of_col(column)) {
                target[(size + row, column_from + column)] = sign * value;
            }
        }
    }
    for i in 0..size {
        (0..size).for_each(|j| a[(size + i, size + j)] = -damping[(i, j)]);
    }
    for (k, point) in framed.iter().enumerate() {
        point.equilibrium.entries().iter().for_each(|(i, value)| a[(size + i, 2 * size + k)] = *value);
        point.normal.entries().iter().for_each(|(i, value)| a[(2 * size + k, *i)] = *value);
        a[(2 * size + k, 2 * size + k)] = point.yielding;
    }
    let shift = 0.37;
    let shifted = Mat::from_fn(all, all, |i, j| a[(i, j)] - shift * b[(i, j)]);
    let mut inverted = b;
    judder_dense::general::solve(shifted, &mut inverted).unwrap();
    let inverse = real_eigenvalues(&inverted).unwrap();
    inverse.into_iter().map(|theta| c64::new(shift, 0.0) + c64::new(1.0, 0.0) / theta).collect()
}

/// The smallest |eigenvalue| of c Q(λ)⁻¹ eᵀ + 1/k by its size: zero where λ is an eigenvalue.
fn by_receptances(assembly: &Assembly, framed: &[OtherPoint], value: c64) -> f64 {
    let damping = damping(assembly, framed);
    let mut matrix = Mat::from_fn(SIZE, SIZE, |i, j| value * damping[(i, j)]);
    for (own, factor) in [(&assembly.mass, value * value), (&assembly.stiffness, c64::new(1.0, 0.0))] {
        for column in 0..SIZE {
            for (row, entry) in own.row_idx_of_col(column).zip(own.val_of_col(column)) {
                matrix[(row, column)] += factor * *entry;
            }
        }
    }
    let mut moved = Mat::<c64>::zeros(SIZE, framed.len());
    for (k, point) in framed.iter().enumerate() {
        point.equilibrium.entries().iter().for_each(|(i, entry)| moved[(*i, k)] = c64::new(*entry, 0.0));
    }
    judder_dense::general::solve_complex(matrix, &mut moved).unwrap();
    let column = |k: usize| (0..SIZE).map(|i| moved[(i, k)]).collect::<Vec<_>>();
    let receptances = Mat::from_fn(framed.len(), framed.len(), |i, j| {
        framed[i].normal.of_complex(&column(j)) + if i == j { framed[i].yielding } else { 0.0 }
    });
    let (values, _) = complex_eigen(receptances.as_ref()).unwrap();
    let sizes: Vec<f64> = values.iter().map(|value| value.norm()).collect();
    sizes.iter().copied().fold(f64::INFINITY, f64::min) / sizes.iter().copied().fold(0.0, f64::max)
}

/// Whether the eigenvalues by elimination are those by multipliers and by receptances.
fn three_agree(assembly: &Assembly) -> Result<(), TestCaseError> {
    let steady = steady_sliding(assembly, &Compliance::new(assembly).unwrap()).unwrap();
    prop_assert!(steady.residual < 1e-12, "{}", steady.residual);
    let about = Linearised::new(assembly, &steady, LinearisedTerms::default()).unwrap();
    let region = Region { re: [-50.0, 50.0], im: [1e-3, 50.0] };
    let found = complex_modes(&about.problem, &region, &ComplexModeSettings::default()).unwrap();
    prop_assert!(found.complete());
    let points = other_points(assembly, &steady);
    let multipliers = by_multipliers(assembly, &points);
    for mode in &found.modes {
        let value = mode.eigenvalue.value;
        let known = 1e-10 * value.norm() + mode.eigenvalue.error;
        let nearest = multipliers.iter().map(|other| (other - value).norm()).fold(f64::INFINITY, f64::min);
        prop_assert!(
            nearest < known * 10.0,
            "{value} is off by {nearest}, condition {}",
            mode.eigenvalue.condition
        );
        let singular = by_receptances(assembly, &points, value);
        prop_assert!(singular < 1e-9 * mode.eigenvalue.condition.max(1.0), "{value}: {singular}");
    }
    Ok(())
}

fn numbers() -> impl Strategy<Value = Vec<f64>> {
    proptest::collection::vec(-1.0..1.0_f64, SIZE * SIZE)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 40, ..ProptestConfig::default() })]

    #[test]
    fn three_formulations_have_the_same_eigenvalues(
        numbers in numbers(), friction in 0.0..0.8_f64, share in 0.1..0.9_f64, circulation in prop_oneof![Just(0.0), 0.0..0.8_f64],
    ) {
        three_agree(&circulating(&numbers, friction, share, circulation))?;
    }

    #[test]
    fn three_formulations_agree_with_springs_falling_friction_and_damping(
        numbers in numbers(), friction in 0.0..0.6_f64, share in 0.1..0.9_f64, spring in prop_oneof![Just(None), (1.0..50.0_f64).prop_map(Some)],
    ) {
        three_agree(&damped(&numbers, friction, share, spring))?;
    }

    #[test]
    fn growths_sum_to_the_growth_rate(
        numbers in numbers(), friction in 0.0..0.8_f64, share in 0.1..0.9_f64, circulation in prop_oneof![Just(0.0), 0.0..0.8_f64],
    ) {
        let assembly = circulating(&numbers, friction, share, circulation);
        let steady = steady_sliding(&assembly, &Compliance::new(&assembly).unwrap()).unwrap();
        let about = Linearised::new(&assembly, &steady, LinearisedTerms::default()).unwrap();
        let region = Region { re: [-50.0, 50.0], im: [1e-3, 50.0] };
        for mode in complex_modes(&about.problem, &region, &ComplexModeSettings::default()).unwrap().modes {
            let value = mode.eigenvalue.value;
            let shares = growth_shares(&about, value, &about.expanded(&mode.right)).unwrap().unwrap();
            prop_assert!(shares.balance.abs() < 1e-8 * value.norm(), "{} of {value}", shares.balance);
        }
    }

    #[test]
    fn without_friction_every_eigenvalue_is_imaginary(numbers in numbers(), share in 0.1..0.9_f64) {
        let assembly = assembly(&numbers, 0.0, share);
        let steady = steady_sliding(&assembly, &Compliance::new(&assembly).unwrap()).unwrap();
        let about = Linearised::new(&assembly, &steady, LinearisedTerms::default()).unwrap();
        let region = Region { re: [-50.0, 50.0], im: [1e-3, 50.0] };
        let found = complex_modes(&about.problem, &region, &ComplexModeSettings::default()).unwrap();
        prop_assert_eq!(found.modes.len(), SIZE - 2);
        for mode in found.modes {
            prop_assert!(mode.eigenvalue.value.re.abs() <= mode.eigenvalue.error.max(1e-10));
        }
    }
}
