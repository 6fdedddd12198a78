//! A response: the observed points over the frequency.

#![deny(clippy::indexing_slicing, reason = "stored arrays may be of any length")]

use super::followed::MEASURES;
use judder_report::palette::Style;
use judder_report::runs::through;
use judder_report::{Layer, Legend, Panel, Role};
use judder_study::pictures::{StoredArrays, axis, codes, reals, wholes, words};

/// A panel for each measure that is drawn, with all observed coordinates; where the frequency turns is marked.
pub(super) fn frequency_response(dataset: &StoredArrays<'_>) -> Option<Vec<Panel>> {
    ["amplitude", "rms", "largest"].into_iter().map(|measure| panel(dataset, measure)).collect()
}

fn panel(dataset: &StoredArrays<'_>, measure: &str) -> Option<Panel> {
    let ending = format!(".{measure}");
    let (_, title, _) = MEASURES.into_iter().find(|(name, ..)| *name == measure)?;
    let across = reals(dataset, "frequency")?;
    let own = || dataset.variables().iter().filter(|own| own.name.ends_with(&ending));
    let (mut layers, mut folds) = (Vec::new(), [Vec::new(), Vec::new()]);
    let mut changes: Vec<(&str, [Vec<f64>; 2])> = Vec::new();
    for (k, variable) in own().enumerate() {
        for name in ["frequency", &variable.name, "stable"] {
            dataset.over(name, &["motion"])?;
        }
        let values = reals(dataset, &variable.name)?;
        let name = variable.name.trim_end_matches(&ending);
        match codes(dataset, "stable") {
            None => layers.push(Layer::line(name, across.to_vec(), values.to_vec(), Role::Series(k).solid())),
            Some(stable) => layers.extend(by_stability(name, k, [across, values], stable)),
        }
        for (all, marked) in [across, values].into_iter().zip(&mut folds) {
            marked.extend(turns(dataset).iter().filter_map(|at| all.get(*at)));
        }
        for (kind, at) in stability_changes(dataset) {
            let place = changes.iter().position(|(known, _)| *known == kind).unwrap_or_else(|| {
                changes.push((kind, Default::default()));
                changes.len() - 1
            });
            let marked = changes.get_mut(place).map(|(_, marked)| marked);
            for (all, marked) in [across, values].into_iter().zip(marked.into_iter().flatten()) {
                marked.extend(all.get(at));
            }
        }
    }
    let [x, y] = folds;
    if !x.is_empty() {
        layers.push(Layer::points("fold", x, y, Role::Reference));
    }
    let coordinates = own().count();
    for (k, (kind, [x, y])) in changes.into_iter().enumerate() {
        layers.push(Layer::points(kind, x, y, Role::Series(coordinates + k).solid()));
    }
    let up = axis(own().next()?);
    Some(
        Panel::new(axis(dataset.variable("frequency")?), up, layers)
            .with_legend(Legend::Below)
            .with_title(title),
    )
}

/// A coordinate whose motions are stable, unstable, or of unknown stability.
fn by_stability(name: &str, series: usize, [across, up]: [&[f64]; 2], stable: &[u8]) -> Vec<Layer> {
    let styles = [
        (1, name.to_owned(), Role::Series(series).solid()),
        (0, format!("{name}, unstable"), Role::Series(series).dashed()),
        (2, format!("{name}, of unknown stability"), Role::Reference.solid()),
    ];
    let layer = |(code, label, style): (u8, String, Style)| {
        // a stretch between unlike motions is drawn as the one after it
        let (x, y) = through(across, up, |k| stable.get(k + 1) == Some(&code));
        (!x.is_empty()).then(|| Layer::line(label, x, y, style))
    };
    styles.into_iter().filter_map(layer).collect()
}

/// How the stability changes, and the last motion before.
fn stability_changes<'a>(dataset: &StoredArrays<'a>) -> Vec<(&'a str, usize)> {
    let is_so = ["change_kind", "change_motion"]
        .iter()
        .try_for_each(|name| dataset.over(name, &["stability_change"]));
    let both = is_so.and_then(|()| words(dataset, "change_kind").zip(wholes(dataset, "change_motion")));
    let Some((kinds, motions)) = both else { return Vec::new() };
    let places = motions.iter().map(|own| usize::try_from(*own).unwrap_or(usize::MAX));
    kinds.iter().map(String::as_str).zip(places).collect()
}

/// The motions nearest to where the frequency turns.
fn turns(dataset: &StoredArrays<'_>) -> Vec<usize> {
    let motions = dataset.over("fold_motion", &["fold"]).and_then(|()| wholes(dataset, "fold_motion"));
    motions.unwrap_or_default().iter().filter_map(|own| usize::try_from(*own).ok()).collect()
}
