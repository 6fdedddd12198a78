//! What the resolution of a map leaves unchanged.

use crate::panels::panels;
use judder_oscillator::map::{StabilityMap, adaptive, every_point};

/// The connected regions of a map (four neighbours, one class): a point and the size of each.
fn regions(map: &StabilityMap) -> Vec<(usize, usize)> {
    let mut seen = vec![false; map.classes.len()];
    let mut found = Vec::new();
    for start in 0..map.classes.len() {
        if seen[start] {
            continue;
        }
        seen[start] = true;
        let (mut open, mut size) = (vec![start], 0);
        while let Some(point) = open.pop() {
            size += 1;
            let (column, row) = (point % map.columns, point / map.columns);
            let neighbours = [
                (column > 0).then(|| point - 1),
                (column + 1 < map.columns).then_some(point + 1),
                (row > 0).then(|| point - map.columns),
                (row + 1 < map.rows).then_some(point + map.columns),
            ];
            for next in neighbours.into_iter().flatten() {
                if !seen[next] && map.classes[next] == map.classes[start] {
                    seen[next] = true;
                    open.push(next);
                }
            }
        }
        found.push((start, size));
    }
    found
}

/// Every region that the brute-force 1000 × 1000 map of Figs. 9 and 10 shows is in the adaptive one, to the last point.
#[test]
fn the_adaptive_map_finds_every_region_of_the_brute_force_map() {
    for panel in panels(1000) {
        let brute = every_point(&panel.contact, &panel.plane);
        let fast = adaptive(&panel.contact, &panel.plane);
        let name = format!("{} {}", panel.figure, panel.load_name());
        for (point, size) in regions(&brute) {
            assert_eq!(brute.classes[point], fast.classes[point], "{name}: region of {size} at {point}");
        }
        assert!(brute.classes == fast.classes, "{name}");
        assert!(fast.decisions < brute.decisions / 50, "{name}: {} decisions", fast.decisions);
    }
}

/// The unstable share settles as the grid is refined: a boundary of finite length costs one layer of cells.
#[test]
fn the_unstable_share_settles_with_the_resolution() {
    for (coarse, fine) in panels(501).iter().zip(panels(2001)) {
        let share = |panel: &crate::panels::Panel| adaptive(&panel.contact, &panel.plane).unstable_fraction();
        let difference = (share(coarse) - share(&fine)).abs();
        assert!(difference < 1.0 / 501.0, "{} {}: {difference}", coarse.figure, coarse.load_name());
    }
}
