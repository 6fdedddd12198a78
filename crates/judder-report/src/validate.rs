//! Whether a figure can be drawn: checked once, before any picture is made, so that drawing cannot fail.

use crate::axis::{Scale, drawable};
use crate::error::{PanelError, ReportError};
use crate::figure::{Figure, Layer, Line, Panel, SecondAxis};

/// A figure is in order when its name is a file stem, its ranges can be drawn and its arrays fit together.
pub(crate) fn check(figure: &Figure) -> Result<(), ReportError> {
    let allowed = |c: char| c.is_ascii_alphanumeric() || matches!(c, '-' | '_' | '.');
    let name = &figure.name;
    if name.is_empty() || name.starts_with('.') || !name.chars().all(allowed) {
        return Err(ReportError::FigureName { name: name.clone() });
    }
    if figure.columns == 0 {
        return Err(ReportError::Columns { figure: name.clone(), columns: 0 });
    }
    for (index, panel) in figure.panels.iter().enumerate() {
        check_panel(panel).map_err(|source| ReportError::Panel {
            figure: name.clone(),
            panel: index,
            source,
        })?;
    }
    Ok(())
}

fn check_panel(panel: &Panel) -> Result<(), PanelError> {
    panel.x.check("x")?;
    panel.y.check("y")?;
    check_second(panel)?;
    for (layer, content) in panel.layers.iter().enumerate() {
        match content {
            Layer::Line(line) | Layer::Points(line) if line.x.len() != line.y.len() => {
                return Err(PanelError::Lengths { layer, x: line.x.len(), y: line.y.len() });
            }
            Layer::Line(line) | Layer::Points(line) => {
                check_swing(layer, line, panel)?;
                check_sizes(layer, line)?;
            }
            Layer::Classes(map) => {
                check_grid(layer, panel, &map.x, &map.y, map.codes.len())?;
                let classes = map.classes.len();
                let stray = map.codes.iter().enumerate().find(|(_, code)| usize::from(**code) >= classes);
                if let Some((cell, code)) = stray {
                    return Err(PanelError::Code { layer, cell, code: *code, classes });
                }
            }
            Layer::Values(map) => {
                map.bar.check("colour")?;
                check_grid(layer, panel, &map.x, &map.y, map.z.len())?;
            }
            _ => {}
        }
    }
    Ok(())
}

/// A second scale has a finite value above each of its abscissae, and turns nowhere.
fn check_second(panel: &Panel) -> Result<(), PanelError> {
    let Some(SecondAxis { x, value, .. }) = &panel.second else { return Ok(()) };
    if x.len() != value.len() {
        return Err(PanelError::SecondLengths { x: x.len(), values: value.len() });
    }
    let is_in_order = x.iter().chain(value).all(|number| number.is_finite())
        && x.is_sorted_by(|a, b| a < b)
        && (value.is_sorted() || value.is_sorted_by(|a, b| a >= b));
    if is_in_order { Ok(()) } else { Err(PanelError::SecondOrder) }
}

/// A swing has an amplitude for every point, and axes that are even: elsewhere it would not be harmonic.
fn check_swing(layer: usize, line: &Line, panel: &Panel) -> Result<(), PanelError> {
    let Some(swing) = &line.swing else { return Ok(()) };
    let parts = swing.x.iter().chain(&swing.y).map(Vec::len);
    match parts.into_iter().find(|length| *length != line.x.len()) {
        Some(length) => Err(PanelError::Lengths { layer, x: line.x.len(), y: length }),
        None if panel.x.scale != Scale::Linear || panel.y.scale != Scale::Linear => {
            Err(PanelError::SwingScale { layer })
        }
        None => Ok(()),
    }
}

/// A size for every point, none of them negative.
fn check_sizes(layer: usize, line: &Line) -> Result<(), PanelError> {
    let Some(sizes) = &line.sizes else { return Ok(()) };
    if sizes.len() != line.x.len() {
        return Err(PanelError::Lengths { layer, x: line.x.len(), y: sizes.len() });
    }
    match sizes.iter().enumerate().find(|(_, size)| !(size.is_finite() && **size >= 0.0)) {
        Some((index, value)) => Err(PanelError::Size { layer, index, value: *value }),
        None => Ok(()),
    }
}

fn check_grid(layer: usize, panel: &Panel, x: &[f64], y: &[f64], cells: usize) -> Result<(), PanelError> {
    check_coordinates(layer, "x", x, panel.x.scale)?;
    check_coordinates(layer, "y", y, panel.y.scale)?;
    if x.len().checked_mul(y.len()) == Some(cells) {
        return Ok(());
    }
    Err(PanelError::Cells { layer, cells, columns: x.len(), rows: y.len() })
}

fn check_coordinates(
    layer: usize,
    axis: &'static str,
    coordinates: &[f64],
    scale: Scale,
) -> Result<(), PanelError> {
    let mut last = f64::NEG_INFINITY;
    for (index, value) in coordinates.iter().copied().enumerate() {
        if !(value > last && drawable(scale, value)) {
            return Err(PanelError::Coordinate { layer, axis, index, value });
        }
        last = value;
    }
    Ok(())
}
