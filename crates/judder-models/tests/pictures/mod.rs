//! No segment of a figure joins rows that do not follow one another: of other branches, beyond gaps, of other loops. Held against every kind of
//! figure, over planted rows, many times.

mod planted;

use judder_models::{REGISTRY, oscillator};
use judder_report::{Layer, Panel};
use planted::{PLANTED, Planted, Point};
use std::collections::BTreeSet;

/// Figures of each kind that are looked at.
const SEEDS: u64 = 40;

type Segment = (String, String);

/// Both ends in the same digits, in one order.
fn segment(a: Point, b: Point) -> Option<Segment> {
    let is_whole = [a.0, a.1, b.0, b.1].iter().all(|value| value.is_finite());
    // zero has no sign here
    let place = |(x, y): Point| format!("{:.8e} {:.8e}", x + 0.0, y + 0.0);
    is_whole.then(|| if place(a) < place(b) { (place(a), place(b)) } else { (place(b), place(a)) })
}

fn segments(points: &[Point]) -> impl Iterator<Item = Segment> + '_ {
    points.windows(2).filter_map(|ends| segment(ends[0], ends[1]))
}

/// The segments of the lines that show rows: not of those that swing, nor of what is told to be another shape.
fn drawn(panels: &[Panel], planted: &Planted) -> BTreeSet<Segment> {
    let rows = panels.iter().filter(|panel| !planted.shapes.contains(&panel.title.as_str()));
    let lines = rows.flat_map(|panel| &panel.layers).filter_map(|layer| match layer {
        Layer::Line(line) if line.swing.is_none() && !planted.shapes.contains(&line.label.as_str()) => {
            Some(line)
        }
        _ => None,
    });
    lines
        .flat_map(|line| {
            let points: Vec<Point> = line.x.iter().copied().zip(line.y.iter().copied()).collect();
            segments(&points).collect::<Vec<_>>()
        })
        .collect()
}

#[test]
fn every_kind_of_figure_has_planted_rows() {
    let planted: BTreeSet<_> = PLANTED.iter().map(|(model, kind, _)| (*model, *kind)).collect();
    let drawn = REGISTRY.models().iter().flat_map(|model| {
        let kinds = (model.kinds)().into_iter().filter(|kind| kind.picture.is_some());
        kinds.map(|kind| (model.name, kind.name))
    });
    assert_eq!(planted, drawn.collect());
}

#[test]
fn only_neighbours_of_one_run_are_joined_and_all_of_them_are() {
    for (model, kind, plant) in PLANTED {
        let model = REGISTRY.models().iter().find(|own| own.name == model).unwrap();
        for seed in 0..SEEDS {
            for planted in plant(seed) {
                let dataset = planted.dataset.clone().attribute("kind", kind).unwrap();
                let panels = model.panels(&dataset).unwrap();
                assert!(!panels.is_empty(), "{} {kind}: no figure", model.name);
                let allowed: BTreeSet<Segment> = planted.runs.iter().flat_map(|run| segments(run)).collect();
                let drawn = drawn(&panels, &planted);
                let wrong: Vec<_> = drawn.difference(&allowed).take(3).collect();
                let missing: Vec<_> = allowed.difference(&drawn).take(3).collect();
                assert!(
                    wrong.is_empty() && missing.is_empty(),
                    "{} {kind}, seed {seed}: wrong {wrong:?}, missing {missing:?}",
                    model.name
                );
            }
        }
    }
}

/// Solid lines are of what is stable, from end to end.
#[test]
fn stable_branches_are_stable_from_end_to_end() {
    for seed in 0..SEEDS {
        let (dataset, stable) = planted::diagram(seed);
        let panels = oscillator::MODEL.panels(&dataset).unwrap();
        let lines = panels[0].layers.iter().filter_map(|layer| match layer {
            Layer::Line(line) if line.label == "stable cycles" => Some(line),
            _ => None,
        });
        for (x, y) in lines.flat_map(|line| line.x.iter().zip(&line.y)).filter(|(x, y)| (*x + *y).is_finite())
        {
            assert!(stable.contains(&(*x, *y)), "seed {seed}: ({x}, {y})");
        }
    }
}
