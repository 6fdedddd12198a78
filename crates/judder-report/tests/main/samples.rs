//! Figures to try things on.

use judder_report::figure::{Class, ClassMap, ShadedRegion, ValueMap};
use judder_report::palette::ColourMap;
use judder_report::{Axis, Figure, Layer, Panel, Role, Scale, SecondAxis};

/// What tries to break out of attributes, elements, scripts and markup.
pub(crate) const HOSTILE: &str = "<b>&\"quoted\"'</script><!-- ]]> _{a^{b} $x\u{0}$ {{ }} %{x}";

/// A figure with a layer of every kind, all texts the same.
pub(crate) fn every_layer(text: &str) -> Figure {
    let map = ClassMap {
        x: vec![1.0, 10.0, 100.0],
        y: vec![0.0, 1.0],
        codes: vec![0, 1, 2, 2, 1, 0],
        classes: vec![
            Class::new(text, Role::Stable),
            Class::new("flutter", Role::Flutter),
            Class::new("unresolved", Role::Unresolved),
        ],
    };
    let values = ValueMap {
        x: vec![1.0, 10.0, 100.0],
        y: vec![0.0, 1.0],
        z: vec![1.0, 2.0, 3.0, f64::NAN, 1e-3, 6.0],
        bar: Axis::log(text),
        colours: ColourMap::Sequential,
    };
    let curves = vec![
        Layer::Region(ShadedRegion {
            label: text.to_owned(),
            x: Some((2.0, 5.0)),
            y: None,
            role: Role::Stable,
        }),
        Layer::line(text, vec![1.0, 2.0, f64::NAN, 4.0], vec![-1.0, 0.5, 1.0, 2.0], Role::Series(1)),
        Layer::points(text, vec![1.0, 3.0], vec![1.0, 1.5], Role::Mode(4)),
        Layer::vertical_rule(2.0, text),
        Layer::horizontal_rule(1.0, text),
        Layer::note(1.5, 0.0, text),
        Layer::key(text, Role::ConservativeBoundary),
    ];
    let second = SecondAxis { label: text.to_owned(), x: vec![1.0, 5.0], value: vec![10.0, 90.0] };
    let panels = vec![
        Panel::new(Axis::log(text), Axis::linear(text), vec![Layer::Classes(map)]).with_title(text),
        Panel::new(Axis::log(text), Axis::linear(text), vec![Layer::Values(values)]).with_title(text),
        Panel::new(Axis::linear(text), Axis::symmetric_log(text, 0.1), curves)
            .with_title(text)
            .with_second_axis(second),
    ];
    Figure::new("every-layer", text, panels).with_caption(text)
}

/// One panel with one line on axes of this scale.
pub(crate) fn one_line(scale: Scale, x: Vec<f64>, y: Vec<f64>) -> Figure {
    let axis = || Axis { scale, ..Axis::linear("$x$") };
    Figure::new(
        "line",
        "A line",
        vec![Panel::new(axis(), axis(), vec![Layer::line("line", x, y, Role::Series(0))])],
    )
}
