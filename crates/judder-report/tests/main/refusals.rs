//! What cannot be drawn is refused with the place, the value and what would be right.

use judder_report::figure::{Class, ClassMap};
use judder_report::{Axis, Figure, Layer, Panel, Role, Scale, SecondAxis, Swing, json, png, svg};

fn refusal(figure: &Figure) -> String {
    let error = svg(figure).unwrap_err().to_string();
    assert_eq!(json(figure).unwrap_err().to_string(), error);
    assert_eq!(png(figure, 1.0).unwrap_err().to_string(), error);
    error
}

fn with_layer(layer: Layer) -> Figure {
    Figure::new("f", "", vec![Panel::new(Axis::log("x"), Axis::linear("y"), vec![layer])])
}

fn map(x: Vec<f64>, codes: Vec<u8>) -> Figure {
    let classes = vec![Class::new("stable", Role::Stable)];
    with_layer(Layer::Classes(ClassMap { x, y: vec![1.0, 2.0], codes, classes }))
}

#[test]
fn names_that_are_no_file_stems() {
    for name in ["", "a/b", "..", "a b", "\u{3c4}"] {
        assert!(refusal(&Figure::new(name, "", vec![])).contains("file stem"), "{name}");
    }
}

#[test]
fn second_axes_out_of_order() {
    for (x, value, words) in [
        (vec![0.0, 1.0], vec![0.0], "2 abscissae but 1 values"),
        (vec![0.0, 0.0], vec![0.0, 1.0], "out of order"),
        (vec![0.0, 1.0, 2.0], vec![0.0, 2.0, 1.0], "out of order"),
        (vec![0.0, 1.0], vec![0.0, f64::NAN], "out of order"),
    ] {
        let panel = Panel::new(Axis::linear("x"), Axis::linear("y"), Vec::new());
        let panel = panel.with_second_axis(SecondAxis { label: String::new(), x, value });
        let text = refusal(&Figure::new("f", "", vec![panel]));
        assert!(text.contains(words), "{text}");
    }
}

#[test]
fn ranges_that_cannot_be_drawn() {
    let ranges = [(1.0, 1.0), (2.0, 1.0), (f64::NAN, 1.0), (0.0, 1.0), (-1.0, 1.0), (1.0, f64::INFINITY)];
    for (from, to) in ranges {
        let panel = Panel::new(Axis::log("x").with_range(from, to), Axis::linear("y"), vec![]);
        let text = refusal(&Figure::new("f", "", vec![panel]));
        assert!(text.contains("panel 0") && text.contains("of the x axis"), "{text}");
    }
    let y = Axis { scale: Scale::SymmetricLog { linear: 0.0 }, ..Axis::linear("") };
    let text = refusal(&Figure::new("f", "", vec![Panel::new(Axis::log("x"), y, vec![])]));
    assert!(text.contains("linear part 0 of the y axis"), "{text}");
}

#[test]
fn arrays_that_do_not_fit_together() {
    let line = with_layer(Layer::line("", vec![1.0], vec![], Role::Series(0)));
    assert!(refusal(&line).contains("layer 0: 1 abscissae but 0 ordinates"));
    assert!(
        refusal(&map(vec![1.0, 2.0], vec![0; 3])).contains("3 cells for 2 columns and 2 rows: 4 are needed")
    );
    assert!(
        refusal(&map(vec![1.0, 2.0], vec![0, 0, 0, 7]))
            .contains("cell 3 has the code 7, but there are 1 classes")
    );
    for x in [[2.0, 1.0], [1.0, 1.0], [0.0, 1.0], [1.0, f64::NAN]] {
        assert!(refusal(&map(x.to_vec(), vec![0; 4])).contains("along x is"));
    }
}

#[test]
fn no_columns() {
    assert!(refusal(&Figure::new("f", "", vec![]).with_columns(0)).contains("at least 1"));
}

#[test]
fn swings_and_sizes_that_do_not_fit() {
    let swing =
        |points: usize| Swing { x: [vec![0.0; points], vec![0.0; points]], y: [vec![0.0; 2], vec![0.0; 2]] };
    let line = |swing| Layer::swinging("", vec![1.0, 2.0], vec![1.0, 2.0], swing, Role::Series(0));
    assert!(refusal(&with_layer(line(swing(1)))).contains("2 abscissae but 1 ordinates"));
    assert!(refusal(&with_layer(line(swing(2)))).contains("swinging lines need linear axes"));
    for (sizes, message) in [
        (vec![1.0], "2 abscissae but 1"),
        (vec![f64::NAN, 1.0], "marker 0 is NaN"),
        (vec![1.0, -1.0], "marker 1 is -1"),
    ] {
        let bubbles = Layer::bubbles("", vec![1.0, 2.0], vec![1.0, 2.0], sizes, Role::Series(0));
        assert!(refusal(&with_layer(bubbles)).contains(message), "{message}");
    }
}
