//! A map does not depend on how it was made: threads, method.

use crate::panels::{Panel, panels};
use judder_oscillator::map::{AdaptiveMap, CoefficientPlane, DecisionMethod, StabilityMap, stability_map};
use judder_oscillator::mechanism::StabilityClass;
use std::cell::Cell;

fn with_threads(threads: usize, panel: &Panel, method: DecisionMethod) -> StabilityMap {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    pool.install(|| stability_map(&panel.contact, &panel.plane, method))
}

#[test]
fn the_number_of_threads_leaves_no_trace() {
    for panel in panels(301) {
        for method in [DecisionMethod::EveryPoint, DecisionMethod::Adaptive] {
            let (alone, together) = (with_threads(1, &panel, method), with_threads(4, &panel, method));
            assert!(alone == together, "{} {} {method:?}", panel.figure, panel.load_name());
        }
    }
}

/// Every `across`-th column and `up`-th row of a panel.
fn thinned(panel: &Panel, across: usize, up: usize) -> Panel {
    let thin = |values: &[f64], step: usize| values.iter().copied().step_by(step).collect();
    let CoefficientPlane { base, x, y } = &panel.plane;
    let plane = CoefficientPlane { base: *base, x: (x.0, thin(&x.1, across)), y: (y.0, thin(&y.1, up)) };
    Panel { plane, contact: panel.contact.clone(), ..*panel }
}

#[test]
fn both_methods_give_one_map_on_grids_of_every_shape() {
    for panel in panels(400) {
        // the last two leave a single row and a single column
        for (across, up) in [(1, 1), (1, 3), (7, 1), (13, 11), (1, 400), (400, 1)] {
            let panel = thinned(&panel, across, up);
            let brute = stability_map(&panel.contact, &panel.plane, DecisionMethod::EveryPoint);
            let adaptive = stability_map(&panel.contact, &panel.plane, DecisionMethod::Adaptive);
            assert!(
                brute.classes == adaptive.classes,
                "{} {} {across} {up}",
                panel.figure,
                panel.load_name()
            );
            assert_eq!(brute.count(StabilityClass::Unresolved), 0);
            assert!(adaptive.decisions <= brute.decisions);
        }
    }
}

#[test]
fn an_empty_plane_has_an_empty_map() {
    let mut panel = panels(10).swap_remove(0);
    panel.plane.x.1.clear();
    for method in [DecisionMethod::EveryPoint, DecisionMethod::Adaptive] {
        let map = stability_map(&panel.contact, &panel.plane, method);
        assert_eq!((map.columns, map.rows, map.decisions, map.classes.len()), (0, 10, 0, 0));
    }
}

#[test]
fn a_map_in_stages_shows_its_coarse_grid_and_ends_as_the_whole_one() {
    for panel in panels(301) {
        let whole = stability_map(&panel.contact, &panel.plane, DecisionMethod::Adaptive);
        let decided = AdaptiveMap::new(&panel.contact, &panel.plane).decide_coarse();
        let coarse = decided.coarse_map();
        assert_eq!((coarse.columns.first(), coarse.columns.last()), (Some(&0), Some(&300)));
        assert!(coarse.columns.len() < 50 && coarse.rows.len() < 50);
        let of_row = |row: &usize| -> Vec<u8> {
            coarse.columns.iter().map(|column| whole.class(*column, *row) as u8).collect()
        };
        let of_whole = coarse.rows.iter().flat_map(of_row);
        assert!(of_whole.eq(coarse.classes.iter().copied()), "{}", panel.figure);
        assert!(decided.decide_rest(&|| false) == Some(whole), "{} {}", panel.figure, panel.load_name());
    }
}

#[test]
fn a_map_is_given_up_at_any_batch_of_decisions() {
    let panel = panels(301).swap_remove(0);
    let batches = Cell::new(0);
    let stopped_at = |last: usize| {
        batches.set(0);
        let interrupted = || {
            batches.set(batches.get() + 1);
            batches.get() > last
        };
        AdaptiveMap::new(&panel.contact, &panel.plane).decide_coarse().decide_rest(&interrupted)
    };
    let whole = stopped_at(usize::MAX).unwrap();
    let all = batches.get();
    assert!(all > 10 && whole == stability_map(&panel.contact, &panel.plane, DecisionMethod::Adaptive));
    for last in [0, 1, all / 2, all - 1] {
        assert_eq!((stopped_at(last), batches.get()), (None, last + 1));
    }
}
