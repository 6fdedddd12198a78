//! The derivatives of the balance of harmonics against differences.

use crate::common::{assembly, dense, diagonal, point_on_plane};
use faer::sparse::Triplet;
use judder_assembly::assembly::{Assembly, Gyroscopic, from_triplets};
use judder_assembly::compliance::Compliance;
use judder_assembly::friction::{FallingFriction, Friction};
use judder_assembly::interface::InterfaceLaw;
use judder_assembly::pressure::Pressure;
use judder_assembly::row::Row;
use judder_assembly::steady::steady_sliding;
use judder_cycles::balance::{CycleRate, HarmonicBalance};
use judder_cycles::series::Series;
use judder_numerics::counter::uniform;
use std::sync::Arc;

/// Two masses with three freedoms each on a plane, springs between all.
fn two_masses(law: InterfaceLaw, turns: bool) -> Assembly {
    let spring =
        |i: usize, j: usize| if i == j { 5.0 + i as f64 } else { -0.5 / (1.0 + i.abs_diff(j) as f64) };
    let stiffness: Vec<Vec<f64>> = (0..6).map(|i| (0..6).map(|j| spring(i, j)).collect()).collect();
    let damping = diagonal(&[0.1, 0.2, 0.1, 0.15, 0.1, 0.3]);
    // the third is open all along
    let gaps = [(&[0, 1, 2], 0.0), (&[3, 4, 5], 0.05), (&[0, 4, 5], 9.0)];
    let mut points: Vec<_> =
        gaps.iter().map(|(freedoms, gap)| point_on_plane(*freedoms, 1.0, *gap)).collect();
    points[1].convected = Some([Row::new(vec![(3, 0.3), (4, 0.1)]), Row::default(), Row::default()]);
    let mut case = assembly(
        [diagonal(&[1.0; 6]), damping, dense(&stiffness)],
        vec![0.0, -2.0, 0.3, 0.1, -2.5, 0.0],
        points,
        law,
    );
    if turns {
        let skew = [Triplet::new(0, 2, 0.7), Triplet::new(2, 0, -0.7)];
        let matrix = Arc::new(from_triplets(6, 6, &skew).unwrap());
        case.gyroscopic = vec![Gyroscopic { body: "one".to_owned(), matrix }];
    }
    case
}

#[test]
fn derivatives_of_the_balance_are_those_of_its_differences() {
    const DIFFERENCE: f64 = 1e-6;
    let falling = Friction::Falling(FallingFriction::exponential([0.6, 0.4], 0.5));
    let laws = [
        InterfaceLaw::Rigid(falling.clone()),
        InterfaceLaw::Compliant(Pressure::PointStiffness(30.0), falling),
    ];
    let mut states = std::collections::HashSet::new();
    for (law, turns) in laws.iter().flat_map(|law| [(law, false), (law, true)]) {
        let case = two_masses(law.clone(), turns);
        let steady = steady_sliding(&case, &Compliance::new(&case).unwrap()).unwrap();
        let balance = HarmonicBalance::new(&case, &steady, 2.0, Series::new(3, 40), &[]).unwrap();
        let mut at = balance.steady(&steady);
        at.iter_mut().enumerate().for_each(|(k, own)| *own += 0.8 * (uniform(7, k as u64) - 0.5));
        let turning = CycleRate { frequency: 1.9, growth: 0.05 };
        let signals = balance.signals_at(&at, turning).unwrap();
        let projected = balance.projected(balance.series(), &signals);
        states.extend(projected.iter().map(|own| own.state as usize));
        let balanced = balance.balanced(&at, turning).unwrap();
        let moved = |column: usize, by: f64| {
            let (mut at, mut turning) = (at.clone(), turning);
            match column.checked_sub(at.len()) {
                None => at[column] += by,
                Some(0) => turning.frequency += by,
                Some(_) => turning.growth += by,
            }
            let signals = balance.signals_at(&at, turning).unwrap();
            (balance.residual(&at, turning).unwrap(), signals.motions)
        };
        for column in 0..at.len() + 2 {
            let ((more, first_more), (less, first_less)) =
                (moved(column, DIFFERENCE), moved(column, -DIFFERENCE));
            for row in 0..at.len() {
                let difference = (more[row] - less[row]) / (2.0 * DIFFERENCE);
                let found = balanced.jacobian[(row, column)];
                assert!((difference - found).abs() < 1e-6, "{law:?} {row} {column}: {difference} {found}");
            }
            for row in 0..18 {
                let of = |motions: &faer::Mat<f64>| motions[(1 + row % 2, row / 2)];
                let difference = (of(&first_more) - of(&first_less)) / (2.0 * DIFFERENCE);
                assert!((difference - balanced.first[(row, column)]).abs() < 1e-6, "{row} {column}");
            }
        }
    }
    assert_eq!(states.len(), 3, "points that stick, slide and are open");
}
