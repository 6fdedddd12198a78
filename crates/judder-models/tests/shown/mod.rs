//! What a page shows of a study folder: listing, parts of arrays, sounds, coupled modes at any position.

use crate::{case, number, run_into};
use judder_models::ModelError;
use judder_models::sliding_shapes::{ShapedPair, SharedPair, SlidingShapes, sliding_shapes};
use judder_store::{Dataset, Status, StoreError, StudyFolder, Variable, VariableValues};
use judder_study::case::file::CaseFile;
use judder_study::study_view::{MOST_VALUES, RowWindow, StudyView};
use judder_study::{Progress, Silent, StudyError};
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};

const PAPER: &str = "beams-paper/paper.toml";

/// A study of an oscillator case, with a long signal put beside its results.
fn study(folder: &Path) -> CaseFile {
    let text = r#"
        title = "A study to be shown"
        model = "oscillator"
        [[analysis]]
        name = "spectrum"
        kind = "spectrum"
        sweep = { key = "operation.velocity", from = 1e-6, to = 1.0, points = 100, scale = "log" }
        [[analysis]]
        kind = "motion"
        duration = 300
        points = 301
    "#;
    let file = judder_models::parse("case.toml", text, &["contact.shear_strength=0.02".to_owned()]).unwrap();
    run_into(folder, &file, &[]);
    file
}

#[test]
fn a_listing_tells_what_a_study_holds() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("mine");
    let file = study(&path);
    std::fs::write(path.join("motion-x.wav"), "RIFF").unwrap();
    let held = StudyFolder::open(&path).unwrap();
    let view = StudyView::open(judder_models::REGISTRY, &path).unwrap();
    let listing = view.listing().unwrap();
    assert_eq!((listing.name.as_str(), listing.model.as_str()), ("mine", "oscillator"));
    assert_eq!(
        (listing.title.as_str(), listing.version.as_str()),
        ("A study to be shown", env!("CARGO_PKG_VERSION"))
    );
    assert_eq!(listing.sounds, [("motion-x.wav".to_owned(), 4)]);
    assert_eq!(std::io::read_to_string(view.sound("motion-x.wav").unwrap()).unwrap(), "RIFF");
    assert!(matches!(
        view.sound("../mine/motion-x.wav"),
        Err(StudyError::Store(StoreError::OutsideFolder { .. }))
    ));
    let kinds: Vec<_> = listing.analyses.iter().map(|a| (a.name.as_str(), a.kind.as_str())).collect();
    assert_eq!(kinds, [("spectrum", "spectrum"), ("motion", "motion")]);
    for analysis in &listing.analyses {
        let stored = held.read_dataset(&analysis.name).unwrap();
        assert_eq!(analysis.status, Status::Done);
        assert_eq!(&analysis.attributes, stored.attributes());
        for (head, variable) in analysis.variables.iter().zip(stored.variables()) {
            assert_eq!(head, &Variable { data: head.data.clone(), ..variable.clone() });
            let names = std::slice::from_ref(&head.name);
            let read = view.arrays(&analysis.name, names, &RowWindow::default(), &Silent).unwrap();
            assert_eq!(bits(&read[0].data), bits(&variable.data), "{}", head.name);
        }
        // a list of a hundred stands in the arrays
        assert!(analysis.scalars.values().all(|value| value.as_array().is_none_or(|list| list.len() <= 64)));
    }
    let kept = view.case_file().unwrap();
    assert_eq!((&kept.text, &kept.overrides), (&file.text, &file.overrides));
}

/// NaN is itself here.
fn bits(data: &VariableValues) -> String {
    match data {
        VariableValues::F64(values) => {
            format!("{:?}", values.iter().map(|value| value.to_bits()).collect::<Vec<_>>())
        }
        data => format!("{data:?}"),
    }
}

#[test]
fn windows_and_extremes_are_those_of_the_whole() {
    let folder = tempfile::tempdir().unwrap();
    study(folder.path());
    let count = 2_500_000;
    let time: Vec<f64> = (0..count).map(f64::from).collect();
    let signal: Vec<f64> = time.iter().map(|t| (t * 0.37).sin() * t).collect();
    let dataset = Dataset::new()
        .with(Variable::coordinate("time", time.clone()).units("s"))
        .and_then(|d| d.with(Variable::new("signal", &["time"], &[signal.len()], signal.clone())))
        .and_then(|d| d.with(Variable::coordinate("other", vec![1.0, 2.0, 3.0])))
        .unwrap();
    StudyFolder::open(folder.path()).unwrap().write_dataset("motion", "hash", &dataset).unwrap();
    let view = StudyView::open(judder_models::REGISTRY, folder.path()).unwrap();
    let names = ["time", "signal", "other"].map(String::from);
    let window = RowWindow { from: Some(1_000_003), to: Some(2_200_000), most: Some(1000) };
    let found = view.arrays("motion", &names, &window, &Silent).unwrap();
    assert_eq!(
        found.iter().map(|variable| variable.shape.clone()).collect::<Vec<_>>(),
        [vec![1000], vec![1000], vec![3]]
    );
    let rows = 2_200_000 - 1_000_003;
    for (variable, whole) in found.iter().zip([&time, &signal]) {
        let VariableValues::F64(values) = &variable.data else { panic!() };
        for (bin, pair) in values.chunks(2).enumerate() {
            let end = |k: usize| 1_000_003 + k * rows / 500;
            let of = &whole[end(bin)..end(bin + 1)];
            let (low, high) = of.iter().fold((f64::MAX, f64::MIN), |(l, h), v| (l.min(*v), h.max(*v)));
            assert_eq!(pair, [low, high]);
        }
    }
    let few = RowWindow { from: Some(5), to: Some(8), most: Some(1000) };
    assert_eq!(
        view.arrays("motion", &names[..1], &few, &Silent).unwrap()[0].data,
        VariableValues::F64(vec![5.0, 6.0, 7.0])
    );
    let beyond = RowWindow { from: Some(usize::MAX), to: Some(3), most: Some(0) };
    assert!(view.arrays("motion", &names[..1], &beyond, &Silent).unwrap()[0].data.is_empty());
    assert!(MOST_VALUES > count as usize);
}

#[test]
fn only_what_is_listed_is_read() {
    let folder = tempfile::tempdir().unwrap();
    study(folder.path());
    let view = StudyView::open(judder_models::REGISTRY, folder.path()).unwrap();
    for analysis in ["none", "..", "../x", "spectrum/velocity", ""] {
        let refused = view.arrays(analysis, &["velocity".to_owned()], &RowWindow::default(), &Silent);
        assert!(matches!(refused, Err(StudyError::UnknownAnalysis { .. })), "{analysis}");
    }
    for variable in ["none", "..", "../motion/x", "c/0", "", "zarr.json"] {
        let refused = view.arrays("spectrum", &[variable.to_owned()], &RowWindow::default(), &Silent);
        assert!(matches!(refused, Err(StudyError::Store(_))), "{variable}: {refused:?}");
    }
    assert!(StudyView::open(judder_models::REGISTRY, &folder.path().join("figures")).is_err());
}

/// The one point at a place among some.
fn at_place(shapes: &SlidingShapes, points: std::ops::Range<usize>, place: [f64; 3]) -> usize {
    let distance = |k: &usize| shapes.points[*k].iter().zip(place).map(|(a, b)| (a - b).powi(2)).sum::<f64>();
    let nearest = points.min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap();
    assert!(distance(&nearest).sqrt() < 1e-9, "{place:?}");
    nearest
}

/// In every mode the contact stays closed: the slider's tip and the node of the track under it move alike across the track, in the
/// picture alone. The other components differ.
#[test]
fn the_contact_stays_closed_in_the_picture() {
    let pair = ShapedPair::new(&case(PAPER, &[]), &Silent).unwrap();
    for position in [0.03, 0.05] {
        let shapes = pair.at("locus", position, None, &Silent).unwrap();
        assert_eq!((shapes.shapes.len(), shapes.eigenvalues.len()), (20, 20));
        let all = shapes.points.len();
        let track = shapes.slider_points..all;
        let edge = shapes.points[track.clone()].iter().map(|p| p[1]).fold(f64::MIN, f64::max);
        let start = shapes.points[track.clone()].iter().map(|p| p[0]).fold(f64::MAX, f64::min);
        let place = [start + position, edge, 0.0];
        let (tip, node) =
            (at_place(&shapes, 0..shapes.slider_points, place), at_place(&shapes, track, place));
        let mut sliding = 0.0_f64;
        for (shape, residual) in shapes.shapes.iter().zip(&shapes.gap_residuals) {
            let moved = shape.iter().flatten().map(|u| u.norm()).fold(0.0, f64::max);
            assert!((moved - 1.0).abs() < 1e-12 && *residual < 1e-6, "{moved} {residual}");
            assert!((shape[tip][1] - shape[node][1]).norm() < 1e-6, "{:?} {:?}", shape[tip], shape[node]);
            sliding = sliding.max((shape[tip][0] - shape[node][0]).norm());
        }
        assert!(sliding > 1e-2, "{sliding}");
        assert!(shapes.lines.iter().flatten().all(|end| *end < all));
        assert!(
            shapes.lines.iter().any(|line| line[0] < shapes.slider_points)
                && shapes.lines.iter().any(|line| line[0] >= shapes.slider_points)
        );
    }
}

/// Where two modes lock in, the one that grows is not left out because the other has a frequency that is a little lower.
#[test]
fn modes_that_lock_in_are_shown_together() {
    let pair = ShapedPair::new(&case(PAPER, &[]), &Silent).unwrap();
    let found = |position: f64, count| pair.at("locus", position, Some(count), &Silent).unwrap().eigenvalues;
    // the first zone of the locus, at 6908 Hz
    let locked = found(0.016_467_4, 12);
    assert!(locked.len() == 13 && locked[11..].iter().any(|s| s.re > 0.0), "{:?}", &locked[11..]);
    assert_eq!(found(0.016_467_4, 11).len(), 11);
    assert_eq!(found(0.016_467_4, 13).len(), 13);
    assert_eq!(found(0.022, 12).len(), 12);
}

#[test]
#[ignore = "expensive: run by make validate"]
fn all_modes_are_shown_that_there_are() {
    let pair = ShapedPair::new(&case(PAPER, &[]), &Silent).unwrap();
    assert!(pair.at("locus", 0.022, Some(usize::MAX), &Silent).unwrap().eigenvalues.len() > 200);
}

/// Who stops listening after so many questions whether to go on.
struct Leaving {
    after: usize,
    asked: AtomicUsize,
}

impl Progress for Leaving {
    fn begin(&self, _name: &str, _steps: usize) {}
    fn expect(&self, _steps: usize) {}
    fn advance(&self) {}
    fn end(&self) {}

    fn interrupted(&self) -> bool {
        self.asked.fetch_add(1, Ordering::Relaxed) >= self.after
    }
}

/// Before each part of the work it is asked whether anybody still waits; who does gets all.
#[test]
fn shapes_are_given_up_where_nobody_waits_for_them() {
    let coarse = ["structure.oblique.beam.elements=[30, 1]", "structure.horizontal.beam.elements=[40, 1]"];
    let (file, leaving) = (case(PAPER, &coarse), |after| Leaving { after, asked: AtomicUsize::new(0) });
    // two structures are read, two reduced, two expanded to all their points
    for after in 0..6 {
        let left = SharedPair::new().get(&file, &leaving(after));
        assert!(matches!(left, Err(ModelError::Interrupted)), "{after}");
    }
    let shared = SharedPair::new();
    assert!(shared.get(&file, &leaving(0)).is_err(), "what was given up is not remembered");
    let pair = shared.get(&file, &leaving(6)).unwrap();
    // once before the eigenvalues, and before the shape of each
    for after in 0..4 {
        let left = pair.at("locus", 0.03, Some(3), &leaving(after));
        assert!(matches!(left, Err(ModelError::Interrupted)), "{after}");
    }
    assert_eq!(pair.at("locus", 0.03, Some(3), &leaving(4)).unwrap().shapes.len(), 3);
}

/// The shapes of a position belong to the eigenvalues that the locus has stored there; the folder alone says how to find them.
#[test]
fn shapes_come_from_the_study_folder_alone() {
    let folder = tempfile::tempdir().unwrap();
    let few = ["analysis.locus.positions.points=5"];
    let report = run_into(folder.path(), &case(PAPER, &few), &["locus"]);
    let locus = &report.summary.results["locus"];
    let view = StudyView::open(judder_models::REGISTRY, folder.path()).unwrap();
    let pair = ShapedPair::new(&view.case_file().unwrap(), &Silent).unwrap();
    for k in [1, 3] {
        let position = number(&locus["position_m"][k]);
        let shapes = pair.at("locus", position, None, &Silent).unwrap();
        let mut stored: Vec<f64> =
            locus["frequencies_hz"][k].as_array().unwrap().iter().map(number).collect();
        let mut found: Vec<f64> = shapes.eigenvalues.iter().map(|s| s.im / std::f64::consts::TAU).collect();
        stored.sort_by(f64::total_cmp);
        found.sort_by(f64::total_cmp);
        assert_eq!(stored.len(), found.len());
        for (stored, found) in stored.iter().zip(&found) {
            assert!((stored / found - 1.0).abs() < 1e-9, "{stored} {found}");
        }
    }
    assert!(matches!(
        pair.at("none", 0.03, None, &Silent),
        Err(ModelError::Study(StudyError::UnknownAnalysis { .. }))
    ));
    assert!(matches!(pair.at("locus", -0.03, None, &Silent), Err(ModelError::Sliding(_))));
    assert!(matches!(pair.at("locus", f64::NAN, None, &Silent), Err(ModelError::Sliding(_))));
    let other = judder_models::parse("case.toml", "model = \"oscillator\"", &[]).unwrap();
    assert!(matches!(sliding_shapes(&other, "locus", 0.0, None), Err(ModelError::WrongModel { .. })));
}
