//! Whether steady sliding is the only one, against closed forms of few points.

use crate::common::{dense, diagonal, point_on_plane, rigid, undamped};
use judder_assembly::assembly::Assembly;
use judder_assembly::compliance::Compliance;
use judder_assembly::friction::Friction;
use judder_assembly::interface::InterfaceLaw;
use judder_assembly::pressure::{Pressure, PressureTable};
use judder_assembly::steady::{FrictionAmount, steady_sliding};
use judder_assembly::uniqueness::{Uniqueness, UniquenessProof, UniquenessVerdict, uniqueness};
use judder_structure::assembly::Sparse;

fn told(assembly: &Assembly) -> Uniqueness {
    let compliance = Compliance::new(assembly).unwrap();
    let steady = steady_sliding(assembly, &compliance).unwrap();
    uniqueness(assembly, &compliance, &steady).unwrap()
}

/// One point on K or M = (a, b; b, d): it digs in and locks at μ = a/b.
#[test]
fn one_point_digs_in_by_its_stiffness_and_locks_by_its_inertia() {
    let (friction, stiffness, mass) = (0.5, [[3.0, 2.0], [2.0, 5.0]], [[4.0, 1.0], [1.0, 2.0]]);
    let matrix = |of: [[f64; 2]; 2]| dense(&[&of[0], &of[1]]);
    let point = point_on_plane([Some(0), Some(1), None], [1.0, 0.0, 0.0]);
    let assembly =
        undamped(matrix(mass), matrix(stiffness), vec![0.0, -1.0], vec![rigid(vec![point], friction)]);
    let Uniqueness { verdict, onsets } = told(&assembly);
    assert_eq!(verdict, UniquenessVerdict::Unique(UniquenessProof::Minors));
    let near = |found: Option<judder_assembly::uniqueness::FrictionOnset>, coefficient: f64| {
        let found = found.unwrap();
        assert!(
            found.point == 0 && (friction * found.friction.factor().unwrap() - coefficient).abs() < 1e-12,
            "{found:?}"
        );
    };
    near(onsets.one_point, 1.5);
    near(onsets.any_set, 1.5);
    near(onsets.one_point_inertia, 4.0);
    assert!(onsets.one_point_known && onsets.all_sets_known && onsets.inertia_known);
    let mut assembly = assembly;
    // without friction no factor makes any: it is a coefficient that is told
    assembly.interfaces[0].law = InterfaceLaw::Rigid(Friction::Constant(0.0));
    let onsets = told(&assembly).onsets;
    let found = [onsets.one_point, onsets.any_set, onsets.one_point_inertia].map(|own| own.unwrap().friction);
    for (found, expected) in found.into_iter().zip([1.5, 1.5, 4.0]) {
        let FrictionAmount::Coefficient(own) = found else { panic!("{found:?}") };
        assert!((own - expected).abs() < 1e-12, "{own}");
    }
    // on a spring it digs in later, and does not lock at once
    let law = Pressure::PointStiffness(11.0);
    assembly.interfaces[0].law = InterfaceLaw::Compliant(law, Friction::Constant(friction));
    let onsets = told(&assembly).onsets;
    near(onsets.one_point, 2.0);
    assert_eq!((onsets.inertia_known, onsets.one_point_inertia), (true, None));
}

/// Two points, each of which the friction of the other presses: A = (1, μ; μ, 1) by K⁻¹ with unit compliance along y, 2 along x, `sign` between x of one and y of the other.
fn two_points(friction: f64, sign: f64, law: Option<Pressure>) -> Assembly {
    let b = -sign;
    let stiffness: Sparse =
        dense(&[&[1.0, 0.0, 0.0, b], &[0.0, 2.0, b, 0.0], &[0.0, b, 1.0, 0.0], &[b, 0.0, 0.0, 2.0]]);
    let points = [0, 2].map(|first| point_on_plane([Some(first), Some(first + 1), None], [1.0, 0.0, 0.0]));
    let mut interface = rigid(points.to_vec(), friction);
    if let Some(law) = law {
        interface.law = InterfaceLaw::Compliant(law, Friction::Constant(friction));
    }
    undamped(diagonal(&[1.0; 4]), stiffness, vec![0.0, -1.0, 0.0, -1.0], vec![interface])
}

/// Each by itself never digs in, both together do at μ = 1: beyond it either may carry all, and three states are there.
#[test]
fn two_points_that_press_each_other_apart_have_three_states() {
    let below = told(&two_points(0.8, 1.0, None));
    assert_eq!(below.verdict, UniquenessVerdict::Unique(UniquenessProof::Minors));
    assert!((0.8 * below.onsets.any_set.unwrap().friction.factor().unwrap() - 1.0).abs() < 1e-12);
    assert_eq!((below.onsets.one_point, below.onsets.one_point_inertia), (None, None));
    let beyond = told(&two_points(1.5, 1.0, None));
    let UniquenessVerdict::Several { states, other } = beyond.verdict else { panic!("{beyond:?}") };
    assert!(states == 3 && [vec![0], vec![1], vec![0, 1]].contains(&other), "{other:?}");
    // springs between add their compliance to each point: A = (1 + 1/k, μ; μ, 1 + 1/k)
    let soft = |stiffness: f64| told(&two_points(1.5, 1.0, Some(Pressure::PointStiffness(stiffness))));
    let [more, less] = [soft(1.0), soft(4.0)];
    assert_eq!(more.verdict, UniquenessVerdict::Unique(UniquenessProof::Minors));
    assert!((1.5 * more.onsets.any_set.unwrap().friction.factor().unwrap() - 2.0).abs() < 1e-12);
    assert!(matches!(less.verdict, UniquenessVerdict::Several { states: 3, .. }), "{less:?}");
    // those springs as a table: of it the compliance is not in A, and nothing is said where that ends; springs let no point lock at once
    let table = PressureTable { closure: vec![0.0, 1.0], pressure: vec![0.0, 4.0] };
    let rising = told(&two_points(1.5, 1.0, Some(Pressure::Table(table))));
    assert_eq!(rising.verdict, UniquenessVerdict::NotProved);
    assert!(!rising.onsets.all_sets_known && !rising.onsets.one_point_known);
    assert!(rising.onsets.inertia_known && rising.onsets.one_point_inertia.is_none());
}

/// Two points carry what nothing else holds, bodies by themselves or joined by a spring: other loads would lift them off, these do not.
#[test]
fn what_contacts_alone_hold_has_one_state_for_its_loads() {
    let points = [0, 1].map(|freedom| point_on_plane([None, Some(freedom), None], [1.0, 0.0, 0.0]));
    for stiffness in [dense(&[&[0.0, 0.0], &[0.0, 0.0]]), dense(&[&[1.0, -1.0], &[-1.0, 1.0]])] {
        let sole = rigid(points.to_vec(), 0.3);
        let assembly = undamped(diagonal(&[1.0; 2]), stiffness, vec![-1.0, -2.0], vec![sole]);
        let told = told(&assembly);
        assert_eq!(told.verdict, UniquenessVerdict::UniqueForLoads(UniquenessProof::Definite));
        assert!(!told.onsets.one_point_known && told.onsets.inertia_known);
    }
}

/// Of one interface of so many points, each by itself, with friction that the next one feels weakly: beyond twenty points by definiteness.
#[test]
fn many_points_are_shown_to_have_one_state_by_definiteness() {
    const COUNT: usize = 24;
    let size = 2 * COUNT;
    let mut rows = vec![vec![0.0; size]; size];
    for k in 0..COUNT {
        (rows[2 * k][2 * k], rows[2 * k + 1][2 * k + 1]) = (2.0, 3.0);
        let next = (2 * k + 3) % size;
        (rows[2 * k][next], rows[next][2 * k]) = (0.3, 0.3);
    }
    let rows: Vec<&[f64]> = rows.iter().map(Vec::as_slice).collect();
    let point = |k: usize| point_on_plane([Some(2 * k), Some(2 * k + 1), None], [1.0, 0.0, 0.0]);
    let load = (0..size).map(|k| if k % 2 == 1 { -1.0 } else { 0.0 }).collect();
    let interface = rigid((0..COUNT).map(point).collect(), 0.5);
    let assembly = undamped(diagonal(&vec![1.0; size]), dense(&rows), load, vec![interface]);
    let told = told(&assembly);
    assert_eq!(told.verdict, UniquenessVerdict::Unique(UniquenessProof::Definite));
    assert!(!told.onsets.all_sets_known);
}

/// Pairs of points of which the friction of one weighs much on the other, and not the other way round: not definite, but dominant once scaled.
#[test]
fn many_points_are_shown_to_have_one_state_by_dominance() {
    const COUNT: usize = 24;
    let size = 2 * COUNT;
    // x of one point is tied to y of the other
    let mut rows = vec![vec![0.0; size]; size];
    for k in 0..COUNT {
        (rows[2 * k][2 * k], rows[2 * k + 1][2 * k + 1]) = (1.0, if k % 2 == 0 { 1.0 } else { 100.0 });
        if k % 2 == 0 {
            (rows[2 * k][2 * k + 3], rows[2 * k + 3][2 * k]) = (9.9, 9.9);
        }
    }
    let rows: Vec<&[f64]> = rows.iter().map(Vec::as_slice).collect();
    let point = |k: usize| point_on_plane([Some(2 * k), Some(2 * k + 1), None], [1.0, 0.0, 0.0]);
    let load = (0..size).map(|k| if k % 2 == 1 { -1.0 } else { 0.0 }).collect();
    let interface = rigid((0..COUNT).map(point).collect(), 0.5);
    let assembly = undamped(diagonal(&vec![1.0; size]), dense(&rows), load, vec![interface]);
    assert_eq!(told(&assembly).verdict, UniquenessVerdict::Unique(UniquenessProof::Dominant));
}
