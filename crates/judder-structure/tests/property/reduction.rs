//! The limit of a reduction against all modes of the full structure.

use crate::Body;
use judder_numerics::counter::uniform;
use judder_structure::craig_bampton::{CraigBampton, CutOff};
use judder_structure::element::ElementKind;
use judder_structure::grid::Grid;
use judder_structure::material::{Elastic, ElementSection};
use judder_structure::modes::{Mode, WantedModes, modes};

/// A plate of random size and mesh, held along one side, and freedoms of it that are kept: some along another side, or anywhere.
fn random(seed: u64) -> (Body, &'static str, Vec<f64>) {
    let drawn: Vec<f64> = (0..40).map(|k| uniform(seed, k)).collect();
    let kind = if drawn[0] < 0.5 { ElementKind::Quad4 } else { ElementKind::Triangle6 };
    let cells = [2 + (5.0 * drawn[1]) as usize, 1 + (3.0 * drawn[2]) as usize, 1];
    let grid = Grid { kind, size: [1.0, 0.1 + drawn[3], 1.0], cells };
    let body = Body {
        mesh: grid.mesh("any", |p| p).unwrap(),
        material: Elastic::new(70e9, 0.45 * drawn[4], 2700.0).unwrap(),
        section: ElementSection::PlaneStress { thickness: 0.01 },
    };
    (body, if drawn[5] < 0.7 { "x-min" } else { "y-min" }, drawn[6..].to_vec())
}

/// Below the limit every frequency of either structure has its counterpart within the tolerance, and none is missing: structures, freedoms
/// that are kept, counts of modes and tolerances at random, each against all modes of the full structure.
#[test]
fn below_the_limit_of_a_reduction_both_structures_agree() {
    let (mut judged, mut sharp) = (0, 0);
    for seed in 0..200 {
        let (body, held, drawn) = random(seed);
        let assembled = body.assembled(&body.numbering(&body.held(&body.mesh.node_sets[held])));
        let size = assembled.mass.nrows();
        let share = 0.05 + 0.4 * drawn[0];
        let kept: Vec<usize> = (0..size).filter(|k| uniform(seed + 1000, *k as u64) < share).collect();
        let count = (drawn[1] * 0.7 * (size - kept.len()) as f64) as usize;
        let reduced =
            CraigBampton::new(&assembled.stiffness, &assembled.mass, &kept, CutOff::Count(count)).unwrap();
        let error = reduced.error().unwrap();
        let full = modes(&assembled.stiffness, &assembled.mass, WantedModes::Lowest(size)).unwrap().modes;
        let full: Vec<f64> = full.iter().map(Mode::frequency_hz).collect();
        let of_reduced = error.frequencies_hz();
        let off = |k: usize| of_reduced.get(k).map_or(f64::INFINITY, |own| (own - full[k]) / own);
        for tolerance in [1e-1, 1e-2, 1e-4] {
            let limit = error.limit_hz(tolerance);
            // a limit may be a frequency itself: that of a mode that was left out and does not move the interface
            let below = full.iter().take_while(|hz| **hz < limit * (1.0 - 1e-9)).count();
            let wrong = (0..below).find(|k| off(*k) > tolerance + 1e-9);
            assert!(
                wrong.is_none(),
                "{seed} {tolerance}: {limit} {:?}",
                wrong.map(|k| (full[k], of_reduced.get(k)))
            );
            // the reduced structure has none below it that the full one has not
            assert!(
                of_reduced.iter().take_while(|hz| **hz < limit * (1.0 - 1e-8)).count() <= below,
                "{seed}"
            );
            let Some(first) = (0..size).find(|k| off(*k) > tolerance) else { continue };
            judged += 1;
            sharp += usize::from(limit > 0.9 * full[first]);
        }
    }
    println!("{sharp} of {judged} limits within a tenth of the first frequency that is further off");
    assert!(judged > 400 && 2 * sharp > judged, "{sharp} {judged}");
}
