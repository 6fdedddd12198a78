//! SVG is well-formed and repeatable whatever the texts and numbers; PNG has the size that was asked for.

use crate::samples::{HOSTILE, every_layer, one_line};
use judder_report::figure::ClassMap;
use judder_report::palette::Colour;
use judder_report::{Axis, Figure, Layer, Panel, ReportError, Role, Scale, png, svg};
use proptest::prelude::*;
use roxmltree::Document;

#[test]
fn hostile_texts_stay_texts() {
    let text = svg(&every_layer(HOSTILE)).unwrap();
    let document = Document::parse(&text).unwrap();
    assert!(document.descendants().all(|node| !node.has_tag_name("script") && !node.has_tag_name("b")));
    assert!(text.contains("&lt;/script&gt;"));
}

#[test]
fn hats_and_scripts_reach_the_drawing_in_order() {
    let mut figure = one_line(Scale::Linear, vec![0.0, 1.0], vec![0.0, 1.0]);
    figure.panels[0].x.label = "Shear strength $τ̃_{0,crit}$ (10^{−3})".to_owned();
    let text = svg(&figure).unwrap();
    let document = Document::parse(&text).unwrap();
    let said: Vec<String> = document
        .descendants()
        .filter(|node| node.has_tag_name("text"))
        .map(|node| {
            node.descendants().filter(roxmltree::Node::is_text).filter_map(|piece| piece.text()).collect()
        })
        .collect();
    assert!(said.contains(&"Shear strength τ̃0,crit (10−3)".to_owned()), "{said:?}");
}

#[test]
fn the_same_figure_gives_the_same_bytes() {
    let figure = every_layer("$F̃_{n}$");
    assert_eq!(svg(&figure), svg(&figure.clone()));
    assert_eq!(png(&figure, 1.0), png(&figure.clone(), 1.0));
}

#[test]
fn maps_are_one_picture_with_a_pixel_a_cell() {
    let axis: Vec<f64> = (0..30).map(|i| 10_f64.powf(-3.0 + 0.1 * f64::from(i))).collect();
    let codes = (0..900).map(|cell| (cell % 2) as u8).collect();
    let classes =
        [Role::Stable, Role::Flutter].map(|role| judder_report::figure::Class::new("", role)).into();
    let map = ClassMap { x: axis.clone(), y: axis, codes, classes };
    let panel = Panel::new(Axis::log(""), Axis::log(""), vec![Layer::Classes(map)]);
    let text = svg(&Figure::new("map", "", vec![panel])).unwrap();
    let document = Document::parse(&text).unwrap();
    let images: Vec<_> = document.descendants().filter(|node| node.has_tag_name("image")).collect();
    assert_eq!(images.len(), 1);
    let address = images[0].attribute("href").unwrap().strip_prefix("data:image/png;base64,").unwrap();
    let bytes = crate::data::base64_bytes(address);
    let reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().unwrap();
    assert_eq!((reader.info().width, reader.info().height), (30, 30));
    assert!(document.descendants().filter(|node| node.has_tag_name("rect")).count() < 10);
}

#[test]
fn cells_are_not_blended() {
    let classes = [Role::Stable, Role::Both].map(|role| judder_report::figure::Class::new("", role)).into();
    let map = ClassMap { x: vec![0.0, 1.0], y: vec![0.0, 1.0], codes: vec![0, 1, 1, 0], classes };
    let panel = Panel::new(Axis::linear(""), Axis::linear(""), vec![Layer::Classes(map)]);
    let bytes = png(&Figure::new("map", "", vec![panel]), 1.0).unwrap();
    let mut reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    // a row through the lower half of the frame, away from its ticks
    let row = &pixels[info.line_size * (info.height as usize * 6 / 10)..][..info.line_size];
    let samples = info.color_type.samples();
    let colours: std::collections::BTreeSet<&[u8]> =
        row.chunks(samples).skip(40).take(info.width as usize - 60).collect();
    assert!(colours.len() <= 3, "two classes and at most one seam: {colours:?}");
    for role in [Role::Stable, Role::Both] {
        let Colour(red, green, blue) = role.colour();
        assert!(colours.iter().any(|own| own[..3] == [red, green, blue]), "{role:?} among {colours:?}");
    }
}

#[test]
fn a_png_has_the_size_that_was_asked_for_and_shows_its_texts() {
    let figure = one_line(Scale::Linear, vec![0.0, 1.0], vec![0.0, 1.0]);
    let text = svg(&figure).unwrap();
    let points: f64 = Document::parse(&text)
        .unwrap()
        .root_element()
        .attribute("width")
        .and_then(|width| width.strip_suffix("pt"))
        .and_then(|width| width.parse().ok())
        .unwrap();
    let decoder = png::Decoder::new(std::io::Cursor::new(png(&figure, 2.0).unwrap()));
    let mut reader = decoder.read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    assert_eq!(info.width, (2.0 * points).round() as u32);
    // tick labels stand under the frame: there is ink in the lowest tenth of the picture
    let lowest = &pixels[pixels.len() * 9 / 10..];
    assert!(lowest.iter().filter(|byte| **byte < 80).count() > 50);
}

#[test]
fn pictures_of_no_or_too_many_pixels_are_refused() {
    let figure = one_line(Scale::Linear, vec![], vec![]);
    for scale in [0.0, -1.0, 1e6, f64::NAN, f64::INFINITY] {
        assert!(matches!(png(&figure, scale), Err(ReportError::PictureSize { .. })), "{scale}");
    }
}

#[test]
fn figures_without_data_are_drawn_empty() {
    for scale in [Scale::Linear, Scale::Log, Scale::SymmetricLog { linear: 1e-3 }] {
        for values in [
            vec![],
            vec![f64::NAN],
            vec![f64::NAN; 3],
            vec![f64::INFINITY; 2],
            vec![1.0],
            vec![0.0; 2],
            vec![-1.0; 2],
        ] {
            let text = svg(&one_line(scale, values.clone(), values)).unwrap();
            assert!(!text.contains("NaN") && !text.contains("inf"), "{text}");
        }
    }
    assert!(svg(&Figure::new("none", "", vec![])).is_ok());
    assert!(png(&Figure::new("none", "", vec![]), 1.0).is_ok());
    let map = ClassMap { x: vec![], y: vec![], codes: vec![], classes: vec![] };
    let panel = Panel::new(Axis::linear(""), Axis::linear(""), vec![Layer::Classes(map)]);
    assert!(svg(&Figure::new("map", "", vec![panel])).is_ok());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    /// Huge, tiny and mixed numbers on every axis: well-formed, without NaN, and not many labels.
    #[test]
    fn any_numbers_can_be_drawn(
        x in proptest::collection::vec(proptest::num::f64::ANY, 0..12),
        y in proptest::collection::vec(proptest::num::f64::ANY, 12),
        kind in 0..3,
        linear in 1e-300..1e300_f64,
    ) {
        let scale = [Scale::Linear, Scale::Log, Scale::SymmetricLog { linear }][kind as usize];
        let y = y[..x.len()].to_vec();
        let text = svg(&one_line(scale, x, y)).unwrap();
        prop_assert!(!text.contains("NaN") && !text.contains("inf\""), "{}", text);
        let document = Document::parse(&text).unwrap();
        let texts = document.descendants().filter(|node| node.has_tag_name("text")).count();
        prop_assert!(texts < 60, "{} texts", texts);
    }

    #[test]
    fn any_text_can_be_set(label in "\\PC*") {
        let text = svg(&every_layer(&label)).unwrap();
        prop_assert!(Document::parse(&text).is_ok());
    }
}

/// Rims of markers that crowd would hide each other.
#[test]
fn markers_that_crowd_are_small_and_have_no_rims() {
    let drawn = |style: judder_report::palette::Style| {
        let layer = Layer::points("", vec![1.0, 2.0], vec![1.0, 2.0], style);
        svg(&Figure::new("points", "", vec![Panel::new(Axis::linear(""), Axis::linear(""), vec![layer])]))
            .unwrap()
    };
    let (usual, crowded) = (drawn(Role::Series(1).into()), drawn(Role::Series(1).crowded()));
    assert!(usual.contains("h3.8v3.8") && usual.contains("stroke=\"#ffffff\" stroke-width=\"0.5\""));
    assert!(!crowded.contains("h3.8v3.8") && !crowded.contains("stroke=\"#ffffff\" stroke-width=\"0.5\""));
}
