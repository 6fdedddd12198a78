//! Grids: lines over one key, maps over two, of more keys those over the two longest.

use super::column::PointColumn;
use super::{DRAWN_POINTS, Drawn, DrawnSweep, PANELS, evenly, left_out};
use crate::labels::short_number;
use crate::pictures::{DRAWN_SIDE, ascending_order, at, axis, picked, reals, text};
use judder_numerics::order::sort_by_number;
use judder_report::figure::{Class, ClassMap, ValueMap};
use judder_report::palette::ColourMap;
use judder_report::{Axis, Layer, Legend, Panel, Role};
use judder_store::Variable;

/// Values of a key that are drawn as lines rather than as rows of a map.
const FEW_LINES: usize = 6;
/// Points of a line that are marked.
const FEW_POINTS: usize = 60;

/// The points of a grid that are drawn: evenly along the dimensions that are axes, at the middle of the others.
pub(super) fn drawn_points(lengths: &[usize]) -> Vec<Vec<usize>> {
    let axes = axes(lengths);
    let side = if axes.len() > 1 { DRAWN_SIDE } else { DRAWN_POINTS };
    let along = |(k, length): (usize, &usize)| match axes.contains(&k) {
        true => evenly(*length, side),
        false => vec![length / 2],
    };
    lengths.iter().enumerate().map(along).collect()
}

/// The dimensions that are axes of the figure: the two longest, in their order; those of one point are none.
fn axes(lengths: &[usize]) -> Vec<usize> {
    let mut order: Vec<(usize, usize)> =
        lengths.iter().copied().enumerate().filter(|(_, length)| *length > 1).collect();
    order.sort_by_key(|(_, length)| std::cmp::Reverse(*length));
    order.truncate(2);
    order.sort_unstable();
    order.into_iter().map(|(k, _)| k).collect()
}

pub(super) fn panels(sweep: &DrawnSweep<'_>) -> Drawn {
    let shown: Vec<&PointColumn> = sweep.columns.iter().take(PANELS).collect();
    let coordinate = |k: usize| sweep.dataset.variable(&sweep.keys.get(k)?.path);
    let panels: Option<Vec<Panel>> = match axes(&sweep.lengths)[..] {
        [k] => coordinate(k).and_then(|x| shown.iter().map(|column| over_one(sweep, column, x)).collect()),
        [k, l] => coordinate(k)
            .zip(coordinate(l))
            .and_then(|(x, y)| shown.iter().map(|column| over_two(sweep, column, x, y)).collect()),
        _ => None,
    };
    let panels = panels.unwrap_or_default();
    let columns = panels.len().clamp(1, 2);
    let caption = format!("{}{}", fixed(sweep), left_out(shown.len(), sweep.columns.len(), "quantities"));
    (panels, columns, caption)
}

/// Which keys stand still in the figure, and where.
fn fixed(sweep: &DrawnSweep<'_>) -> String {
    let axes = axes(&sweep.lengths);
    let at = |(k, key): (usize, &super::KeyColumn)| {
        let value = reals(&sweep.dataset, &key.path)?.first().copied()?;
        let units = &sweep.dataset.variable(&key.path)?.units;
        let unit = if units == "1" { String::new() } else { format!(" {units}") };
        (!axes.contains(&k)).then(|| format!("{} = {}{unit}", key.path, short_number(value)))
    };
    let fixed: Vec<String> = sweep.keys.iter().enumerate().filter_map(at).collect();
    match fixed.is_empty() {
        true => "Every quantity over the swept keys.".to_owned(),
        false => format!("Every quantity over the longest of the swept keys, at {}.", fixed.join(", ")),
    }
}

/// A number as a line, classes as a strip.
fn over_one(sweep: &DrawnSweep<'_>, column: &PointColumn, x: &Variable) -> Option<Panel> {
    let values = reals(&sweep.dataset, &x.name)?;
    if !column.is_number() {
        return Some(strip(axis(x), values, column));
    }
    let mut layers: Vec<Layer> = zero(column).into_iter().collect();
    layers.extend(curve("", values, column.values.clone(), Role::Series(0)));
    Some(Panel::new(axis(x), column.axis(), layers))
}

/// A line at zero, where the values have both signs.
fn zero(column: &PointColumn) -> Option<Layer> {
    column.has_both_signs().then(|| Layer::horizontal_rule(0.0, ""))
}

/// A line through ascending abscissae, whichever way they were swept; with its points where they are few.
fn curve(label: &str, x: &[f64], y: Vec<f64>, role: Role) -> Vec<Layer> {
    let mut points: Vec<(f64, f64)> = x.iter().copied().zip(y).collect();
    sort_by_number(&mut points, |own| own.0);
    let (x, y): (Vec<f64>, Vec<f64>) = points.into_iter().unzip();
    let points = (x.len() <= FEW_POINTS).then(|| Layer::points("", x.clone(), y.clone(), role));
    std::iter::once(Layer::line(label, x, y, role.solid())).chain(points).collect()
}

/// A number over one key, a line for each value of the other.
fn family(
    sweep: &DrawnSweep<'_>,
    column: &PointColumn,
    x: &Variable,
    of: &Variable,
    x_is_first: bool,
) -> Option<Panel> {
    let (along, values) = (reals(&sweep.dataset, &x.name)?, reals(&sweep.dataset, &of.name)?);
    let mut layers: Vec<Layer> = zero(column).into_iter().collect();
    let unit = if of.units == "1" { String::new() } else { format!(" {}", of.units) };
    let symbol = text(of, "symbol").unwrap_or(&of.name);
    for (place, own) in ascending_order(values).into_iter().enumerate() {
        let point = |k: usize| if x_is_first { k * values.len() + own } else { own * along.len() + k };
        let y = (0..along.len()).map(|k| column.values.get(point(k)).copied().unwrap_or(f64::NAN)).collect();
        let role = Role::Graded { index: place, count: values.len() };
        let label = format!("{symbol} = {}{unit}", short_number(at(values, own)));
        layers.extend(curve(&label, along, y, role));
    }
    Some(Panel::new(axis(x), column.axis(), layers))
}

/// The classes of points along one axis.
pub(super) fn strip(x: Axis, places: &[f64], column: &PointColumn) -> Panel {
    let mut order: Vec<(usize, f64)> =
        places.iter().copied().enumerate().filter(|(_, place)| place.is_finite()).collect();
    sort_by_number(&mut order, |own| own.1);
    order.dedup_by(|b, a| b.1 <= a.1);
    let (codes, classes) = drawn_classes(column, order.iter().map(|(point, _)| *point));
    let map = ClassMap { x: order.iter().map(|(_, place)| *place).collect(), y: vec![0.0], codes, classes };
    Panel::new(x, Axis::named("", [column.name.clone()]), vec![Layer::Classes(map)])
}

/// The classes that occur at these points, and the place of each point among them.
fn drawn_classes(column: &PointColumn, points: impl Iterator<Item = usize>) -> (Vec<u8>, Vec<Class>) {
    let at: Vec<usize> = points.map(|point| column.class_at(point)).collect();
    let all = column.classes.iter().cloned().chain([Class::new("no answer", Role::Unresolved)]);
    let occurring: Vec<(usize, Class)> = all.enumerate().filter(|(code, _)| at.contains(code)).collect();
    let place = |code: &usize| occurring.iter().position(|(own, _)| own == code).unwrap_or(0) as u8;
    let codes = at.iter().map(place).collect();
    (codes, occurring.into_iter().map(|(_, class)| class).collect())
}

/// A map, or lines where one of the keys has few values: of numbers by the sequential colours, or from blue to red where they have both signs.
fn over_two(sweep: &DrawnSweep<'_>, column: &PointColumn, x: &Variable, y: &Variable) -> Option<Panel> {
    let (along, up) = (reals(&sweep.dataset, &x.name)?, reals(&sweep.dataset, &y.name)?);
    if column.is_number() && along.len().min(up.len()) <= FEW_LINES {
        return match along.len() >= up.len() {
            true => family(sweep, column, x, y, true),
            false => family(sweep, column, y, x, false),
        };
    }
    let (across, upward) = (ascending_order(along), ascending_order(up));
    // the first key stands along the horizontal axis, and varies slowest in the array
    let points = || upward.iter().flat_map(|row| across.iter().map(move |k| k * up.len() + row));
    let (drawn_x, drawn_y) = (picked(along, &across), picked(up, &upward));
    let layer = if column.is_number() {
        let z = points().map(|point| column.values.get(point).copied().unwrap_or(f64::NAN)).collect();
        let colours = if column.has_both_signs() { ColourMap::Diverging } else { ColourMap::Sequential };
        Layer::Values(ValueMap { x: drawn_x, y: drawn_y, z, bar: column.axis(), colours })
    } else {
        let (codes, classes) = drawn_classes(column, points());
        Layer::Classes(ClassMap { x: drawn_x, y: drawn_y, codes, classes })
    };
    let title = if column.is_number() { String::new() } else { column.name.clone() };
    Some(Panel::new(axis(x), axis(y), vec![layer]).with_title(title).with_legend(Legend::Below))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_are_the_longest_dimensions_in_their_order() {
        assert_eq!(axes(&[5, 1, 9, 7]), [2, 3]);
        assert_eq!(axes(&[9, 1, 5]), [0, 2]);
        assert_eq!(axes(&[1, 4]), [1]);
        assert_eq!(axes(&[3, 3, 3]), [0, 1]);
        assert!(axes(&[1, 1]).is_empty());
    }
}
