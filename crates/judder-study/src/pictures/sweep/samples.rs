//! Lists and samples: every quantity over every key, point by point.

use super::column::{KeyColumn, PointColumn};
use super::grid::strip;
use super::{Drawn, DrawnSweep, PANELS, left_out, part};
use judder_numerics::order::sort_by_number;
use judder_report::{Axis, Layer, Panel, Role, Style};

/// Keys that stand beside each other.
const KEYS: usize = 4;
/// From so many points on they crowd.
const FEW: usize = 200;

pub(super) fn panels(sweep: &DrawnSweep<'_>) -> Drawn {
    let keys = shown_keys(sweep);
    let per_quantity = keys.len().max(1);
    let (numbers, classes): (Vec<&PointColumn>, Vec<&PointColumn>) =
        sweep.columns.iter().partition(|column| column.is_number());
    let shown: Vec<&&PointColumn> = numbers.iter().take(PANELS / per_quantity).collect();
    let mut panels: Vec<Panel> =
        shown.iter().flat_map(|column| keys.iter().map(|key| scatter(key, column))).collect();
    panels.extend(classes.iter().filter_map(|column| match keys[..] {
        [] => None,
        [key] => Some(strip(key.axis(), &key.values, column)),
        [x, y, ..] => Some(plane(x, y, column)),
    }));
    let columns = if shown.is_empty() { panels.len().clamp(1, 2) } else { per_quantity };
    let caption = format!(
        "Every quantity over every swept key, a point a marker.{}{}",
        left_out(shown.len(), numbers.len(), "quantities"),
        match keys.len() < sweep.keys.len() {
            true => format!(" {} of {} keys: {}.", keys.len(), sweep.keys.len(), why(sweep)),
            false => String::new(),
        }
    );
    (panels, columns, caption)
}

fn why(sweep: &DrawnSweep<'_>) -> &'static str {
    if sweep.sensitivity.is_some() { "those with the largest total index" } else { "the first" }
}

/// The keys that are drawn: all where there are few, else those that matter most where that is known.
fn shown_keys<'a>(sweep: &'a DrawnSweep<'_>) -> Vec<&'a KeyColumn> {
    let total = |key: &KeyColumn| {
        let of = |index: &serde_json::Value| part(index, &["total", &key.path, "value"]).as_f64();
        let indices = sweep.sensitivity.into_iter().flat_map(|all| all.values());
        indices.filter_map(of).fold(0.0, f64::max)
    };
    let mut order: Vec<(usize, &KeyColumn)> = sweep.keys.iter().enumerate().collect();
    sort_by_number(&mut order, |own| -total(own.1));
    order.truncate(KEYS);
    order.sort_by_key(|(k, _)| *k);
    order.into_iter().map(|(_, key)| key).collect()
}

fn style(role: Role, points: usize) -> Style {
    if points > FEW { role.crowded() } else { role.into() }
}

fn scatter(key: &KeyColumn, column: &PointColumn) -> Panel {
    let mut layers = Vec::new();
    if column.has_both_signs() {
        layers.push(Layer::horizontal_rule(0.0, ""));
    }
    let style = style(Role::Series(0), column.values.len());
    layers.push(Layer::points("", key.values.clone(), column.values.clone(), style));
    Panel::new(key.axis(), column.axis(), layers)
}

/// The classes of the points over two keys.
fn plane(x: &KeyColumn, y: &KeyColumn, column: &PointColumn) -> Panel {
    let points = |code: usize| -> (Vec<f64>, Vec<f64>) {
        let of = (0..column.values.len()).filter(|point| column.class_at(*point) == code);
        of.filter_map(|point| Some((*x.values.get(point)?, *y.values.get(point)?))).unzip()
    };
    let mut layers = Vec::new();
    for (code, class) in column.classes.iter().enumerate() {
        let (across, up) = points(code);
        if !across.is_empty() {
            layers.push(Layer::points(
                &class.label,
                across,
                up,
                style(point_role(class.role), column.values.len()),
            ));
        }
    }
    let (across, up) = points(column.classes.len());
    if !across.is_empty() {
        layers.push(Layer::points("no answer", across, up, style(Role::Unresolved, column.values.len())));
    }
    Panel::new(x.axis(), Axis { range: None, ..y.axis() }, layers).with_title(&column.name)
}

/// The colour of a point of a class: that of its area, where it can be seen on white.
fn point_role(role: Role) -> Role {
    if role == Role::Stable { Role::Reference } else { role }
}
