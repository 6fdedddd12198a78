//! What the page is told.

use crate::client::Served;
use judder_keys::declared::Settings;
use judder_models::motion::history::HistoryAnalysis;
use judder_models::oscillator::case::OscillatorCase;
use judder_models::template::template;
use judder_study::Silent;
use judder_study::analyses;
use serde_json::{Value, json};

const OPTIONS: [&str; 2] = ["operation.velocity=1e-3", "contact.shear_strength=20 kPa"];

fn base() -> String {
    template("oscillator").unwrap()
}

fn axis(key: &str, from: f64, to: f64, points: usize) -> Value {
    json!({ "key": key, "from": from, "to": to, "points": points, "scale": "log" })
}

fn map() -> Value {
    json!({
        "name": "map", "kind": "stability-map", "boundaries": false,
        "x": axis("operation.velocity", 1e-8, 1e2, 61), "y": axis("contact.shear_strength", 1e-4, 1.0, 51),
    })
}

/// All that the page and its styles ask this server for is there, fonts among it.
#[test]
fn what_the_page_asks_for_is_served() {
    let served = Served::new();
    let asked = |text: &str, before: &str, after: char| -> Vec<String> {
        text.split(before).skip(1).map(|rest| rest.split(after).next().unwrap().to_owned()).collect()
    };
    let index = served.get("/").text();
    let styles: Vec<String> =
        asked(&index, "href=\"", '"').into_iter().filter(|name| name.ends_with(".css")).collect();
    assert_eq!(styles.len(), 1, "{index}");
    let fonts = asked(&served.get(&styles[0]).text(), "url(", ')');
    assert_eq!(fonts.len(), 3, "{fonts:?}");
    for font in fonts {
        let answer = served.get(&font);
        assert_eq!((answer.status, answer.header("content-type")), (200, Some("font/woff2")), "{font}");
        assert!(answer.body.starts_with(b"wOF2"), "{font}");
    }
    assert_eq!(served.get("/fonts/secret.woff2").status, 404);
}

#[test]
fn the_session_has_the_case_and_its_keys() {
    let served = Served::new();
    let session = served.get("/api/session").json();
    assert_eq!(session["case"]["model"], "oscillator");
    assert_eq!(session["case"]["text"], base());
    assert_eq!(session["keys"].as_array().unwrap().len(), 16);
    assert_eq!(session["map"]["x"]["key"], "operation.velocity");
    for key in session["keys"].as_array().unwrap() {
        assert!(key["slider"]["from"].as_f64() < key["slider"]["to"].as_f64(), "{key}");
        let says_twice = key["path"] == "substrate.relaxation_time";
        assert_eq!(key["settable"], !says_twice, "{key}");
    }
}

/// The names of declared keys.
fn names(keys: &Value) -> Vec<&str> {
    keys.as_array().unwrap().iter().map(|key| key["name"].as_str().unwrap()).collect()
}

#[test]
fn the_session_has_the_declared_keys_of_each_kind_of_analysis() {
    let session = Served::new().get("/api/session").json();
    let declared: Vec<&str> = HistoryAnalysis::declarations().iter().map(|key| key.name).collect();
    let motion = &session["settings"]["motion"]["keys"];
    assert_eq!(names(motion), declared);
    let points = motion.as_array().unwrap().iter().find(|key| key["name"] == "points").unwrap();
    assert_eq!((&points["default"], &points["form"]["range"]["from"]), (&json!(4096), &json!(16)));
    let (law, friction) = (&session["choices"][0], &session["choices"][1]);
    assert_eq!(
        (&friction["path"], &friction["value"]),
        (&json!("contact.friction_load"), &json!("normal-load"))
    );
    assert_eq!(session["choices"].as_array().unwrap().len(), 2);
    assert_eq!(
        (&law["path"], &law["value"], &law["words"][2]),
        (&json!("contact.law"), &json!("oscillator-paper"), &json!("hertz"))
    );
    // an oscillator has a contact, whose memory the page does not decide on
    let contact = names(&session["settings"]["contact"]["keys"]);
    assert!(contact.contains(&"accuracy") && !contact.contains(&"memory_limit"), "{contact:?}");
}

#[test]
fn all_that_is_wrong_with_a_case_is_told() {
    let analysis = json!({ "name": "motion", "kind": "motion", "points": 1, "tolerance": 2.0 });
    let view = json!({ "set": [], "analysis": analysis });
    let frames = Served::new().post("/api/motion", &view).frames();
    let error = &frames[0].header["error"];
    let told = [&error["message"], &error["others"][0]["message"]].map(|text| text.as_str().unwrap());
    let names_both = ["points", "tolerance"].iter().all(|key| told.iter().any(|text| text.contains(key)));
    assert!(names_both && error["others"][0]["place"]["line"].is_u64(), "{error}");
}

#[test]
fn a_point_is_that_of_the_command() {
    let served = Served::new();
    let answer = served.post("/api/point", &json!({ "set": OPTIONS })).json();
    let file = judder_models::parse("oscillator.toml", &base(), &OPTIONS.map(String::from)).unwrap();
    let case = file.case.of::<OscillatorCase>().unwrap();
    let point = judder_models::point::point(case).unwrap();
    assert_eq!(answer["point"], point.json());
    let growth = point.steady.growth_rate() * 40.0;
    assert!((answer["dimensional"]["growth_rate_per_s"].as_f64().unwrap() - growth).abs() < 1e-12);
    let stress = answer["dimensional"]["shear_strength_pa"].as_f64().unwrap();
    assert!((stress - 2e4).abs() < 1e-9, "{stress}");
    for (mode, value) in answer["modes"].as_array().unwrap().iter().zip(point.steady.eigenvalues) {
        assert_eq!(mode["eigenvalue"], json!([value.re, value.im]));
    }
}

#[test]
fn keys_have_both_forms() {
    let served = Served::new();
    let answer = served.post("/api/case", &json!({ "set": OPTIONS })).json();
    let value = |path: &str| {
        let values = answer["values"].as_array().unwrap();
        values.iter().find(|value| value["path"] == path).unwrap().clone()
    };
    assert_eq!(value("operation.velocity")["group"], 1e-3);
    assert!((value("operation.velocity")["si"].as_f64().unwrap() - 1e-3).abs() < 1e-15, "R/τ is 1 m/s");
    assert_eq!(value("contact.shear_strength")["form"], "si");
    assert!((value("contact.shear_strength")["group"].as_f64().unwrap() - 0.015).abs() < 1e-15);
    assert_eq!(value("oscillator.damping_x")["si"], Value::Null);
}

#[test]
fn a_map_comes_coarse_then_exact_then_with_its_boundaries() {
    let served = Served::new();
    let answer = served
        .post("/api/map", &json!({ "set": [], "analysis": map(), "boundaries": ["conservative", "full"] }));
    let frames = answer.frames();
    let kinds: Vec<&str> = frames.iter().map(crate::client::Frame::kind).collect();
    assert_eq!(kinds, ["map", "map", "boundary", "boundary", "end"]);
    assert_eq!((&frames[0].header["stage"], &frames[1].header["stage"]), (&json!("coarse"), &json!("exact")));
    let (x, y, classes) = (frames[1].reals("x"), frames[1].reals("y"), frames[1].codes("classes"));
    assert_eq!((x.len(), y.len(), classes.len()), (61, 51, 61 * 51));
    let coarse = (frames[0].reals("x"), frames[0].reals("y"), frames[0].codes("classes"));
    for (row, value) in coarse.1.iter().enumerate() {
        let exact_row = y.iter().position(|y| y == value).unwrap();
        for (column, value) in coarse.0.iter().enumerate() {
            let exact_column = x.iter().position(|x| x == value).unwrap();
            assert_eq!(coarse.2[row * coarse.0.len() + column], classes[exact_row * 61 + exact_column]);
        }
    }
    assert_eq!(frames[2].header["name"], "conservative");
    assert!(frames[3].reals("frequency").iter().any(|frequency| *frequency > 0.5));
}

/// A computed law has errors: what they leave of the map comes after it, as a run has it.
#[test]
fn a_map_of_a_computed_law_says_where_its_errors_decide() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("case.toml");
    std::fs::write(&path, "model = \"oscillator\"\n[contact]\nlaw = { computed = true, accuracy = 0.05 }\n")
        .unwrap();
    let served = Served::of(Some(&path), None);
    let view = json!({ "set": [], "analysis": map() });
    let frames = served.post("/api/map", &view).frames();
    let frames: Vec<_> = frames.iter().filter(|frame| frame.kind() != "progress").collect();
    let kinds: Vec<&str> = frames.iter().map(|frame| frame.kind()).collect();
    assert_eq!(kinds, ["map", "map", "within-law", "end"]);
    let codes = frames[2].codes("within_law");
    let file = judder_models::parse("x.toml", &served.post("/api/export", &view).text(), &[]).unwrap();
    let run = analyses::run(&file, 0, &Silent).unwrap();
    let judder_store::VariableValues::U8(expected) = &run.dataset.variable("within_law").unwrap().data else {
        panic!()
    };
    assert!(codes == *expected && codes.contains(&1));
}

#[test]
fn the_exported_case_gives_the_same_map_to_the_command() {
    let served = Served::new();
    let view = json!({ "set": OPTIONS, "analysis": map() });
    let text = served.post("/api/export", &view).text();
    assert!(text.contains("# A case of judder"), "comments are kept");
    let file = judder_models::parse("exported.toml", &text, &[]).unwrap();
    assert_eq!(file.case.analysis_names(), ["map"]);
    let outcome = analyses::run(&file, 0, &Silent).unwrap();
    let judder_store::VariableValues::U8(codes) = &outcome.dataset.variable("stability").unwrap().data else {
        panic!()
    };
    let frames = served.post("/api/map", &view).frames();
    assert_eq!(codes, &frames[1].codes("classes"));
    assert_eq!(outcome.scalars["unstable_fraction"], frames[1].header["unstable_fraction"]);
}

#[test]
fn an_analysis_is_that_of_a_run() {
    let served = Served::new();
    let analysis =
        json!({ "name": "loci", "kind": "spectrum", "sweep": axis("contact.shear_strength", 1e-3, 0.3, 31) });
    let view = json!({ "set": OPTIONS, "analysis": analysis });
    let frames = served.post("/api/analysis", &view).frames();
    let outcome = frames.iter().find(|frame| frame.kind() == "outcome").unwrap();
    let text = served.post("/api/export", &view).text();
    let run = analyses::run(&judder_models::parse("x.toml", &text, &[]).unwrap(), 0, &Silent).unwrap();
    assert_eq!(outcome.header["scalars"], Value::Object(run.scalars));
    let names: Vec<&str> = run.dataset.variables().iter().map(|variable| variable.name.as_str()).collect();
    let told = outcome.header["arrays"].as_array().unwrap();
    assert_eq!(told.iter().map(|array| array["name"].as_str().unwrap()).collect::<Vec<_>>(), names);
}

#[test]
fn a_motion_is_shown_while_it_is_computed() {
    let served = Served::new();
    let analysis = json!({ "name": "motion", "kind": "motion", "duration": 3000.0, "points": 30_001 });
    let view = json!({ "set": ["contact.shear_strength=0.1"], "analysis": analysis });
    let frames = served.post("/api/motion", &view).frames();
    let blocks: Vec<_> = frames.iter().filter(|frame| frame.kind() == "block").collect();
    assert!(blocks.len() > 3, "{}", blocks.len());
    let outcome = frames.iter().find(|frame| frame.kind() == "outcome").unwrap();
    for name in ["time", "x", "y", "velocity_x"] {
        let shown: Vec<f64> = blocks.iter().flat_map(|block| block.reals(name)).collect();
        assert_eq!(shown, outcome.reals(name), "{name}");
    }
    for path in ["/api/motion", "/api/analysis"] {
        let refused = served.post(path, &json!({}));
        assert_eq!((refused.status, refused.error().contains("no analysis is asked for")), (400, true));
    }
    let states: Vec<u8> = blocks.iter().flat_map(|block| block.codes("contact_state")).collect();
    assert_eq!(states, outcome.codes("contact_state"));
}

#[test]
fn the_contact_of_an_oscillator_is_a_contact_case() {
    let served = Served::new();
    let analysis = json!({ "name": "modulus", "kind": "modulus" });
    let view =
        json!({ "model": "contact", "set": ["substrate.glassy_modulus=20 MPa"], "analysis": analysis });
    let frames = served.post("/api/analysis", &view).frames();
    assert_eq!(frames.last().unwrap().kind(), "end", "{:?}", frames.last());
    let text = served.post("/api/export", &view).text();
    assert!(text.contains("model = \"contact\"") && text.contains("20 MPa"), "{text}");
}

#[test]
fn a_law_is_a_surface() {
    let served = Served::new();
    let range = |from: f64, to: f64, points: usize| json!({ "from": from, "to": to, "points": points });
    let body = json!({ "velocity": range(1e-4, 1.0, 5), "indentation": range(1e-3, 1e-1, 3) });
    let frames = served.post("/api/law", &body).frames();
    let law = &frames[0];
    assert_eq!((law.reals("velocity").len(), law.reals("force").len()), (5, 15));
    assert!(law.reals("force").windows(6).all(|forces| forces[5] > forces[0]), "deeper is harder");
    assert_eq!(
        served
            .post("/api/law", &json!({ "velocity": range(0.0, 1.0, 5), "indentation": range(1.0, 2.0, 3) }))
            .status,
        400
    );
}

#[test]
fn what_is_wrong_is_told_with_its_place() {
    let served = Served::new();
    let answer = served.post("/api/point", &json!({ "set": ["operation.velocity=1 N"] }));
    assert_eq!(answer.status, 422);
    let error = &answer.json()["error"];
    assert_eq!(error["message"], "`operation.velocity` must be a speed, but this is a force");
    assert_eq!(error["place"]["text"], "1 N");
    assert!(error["help"].as_str().unwrap().contains("30 mm/s"));
    let mut analysis = map();
    analysis["x"]["key"] = json!("operation.sped");
    let frames = served.post("/api/map", &json!({ "analysis": analysis })).frames();
    assert_eq!(frames[0].kind(), "error");
    assert!(frames[0].header["error"]["message"].as_str().unwrap().contains("operation.sped"));
}

#[test]
fn a_contact_case_has_its_substrate_and_its_indenter() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("contact.toml");
    std::fs::write(&path, "model = \"contact\"\n[substrate]\nretardation_time = \"20 ms\"\n").unwrap();
    let served = Served::of(Some(&path), None);
    let session = served.get("/api/session").json();
    let settable = session["keys"].as_array().unwrap().iter().filter(|key| key["settable"] == true);
    let settable: Vec<&str> = settable.map(|key| key["path"].as_str().unwrap()).collect();
    let substrate = ["rubbery_modulus", "glassy_modulus", "retardation_time", "poisson_ratio"]
        .map(|key| format!("substrate.{key}"));
    assert_eq!(settable[..4], substrate);
    assert_eq!(settable[4..], ["indenter.radius"]);
    let answer = served.post("/api/case", &json!({ "set": ["indenter.radius=3 mm"] })).json();
    let radius =
        answer["values"].as_array().unwrap().iter().find(|value| value["path"] == "indenter.radius").unwrap();
    assert_eq!(radius["si"], 0.003);
    assert_eq!(served.post("/api/point", &json!({})).status, 400);
}

/// What a case does not have is not told of it: neither an oscillator, nor its map, nor its laws.
#[test]
fn nothing_is_told_of_an_oscillator_that_is_not_there() {
    let folder = tempfile::tempdir().unwrap();
    for name in judder_models::template::templates().into_iter().filter(|name| *name != "oscillator") {
        let path = folder.path().join(format!("{name}.toml"));
        std::fs::write(&path, template(name).unwrap()).unwrap();
        let served = Served::of(Some(&path), None);
        let session = served.get("/api/session").json();
        let own = if name == "contact" { &["substrate", "indenter"][..] } else { &[] };
        let section_of =
            |entry: &Value| entry["path"].as_str().unwrap().split('.').next().unwrap().to_owned();
        let is_own = |list: &Value| {
            list.as_array().into_iter().flatten().all(|entry| own.contains(&&*section_of(entry)))
        };
        assert!(is_own(&session["keys"]) && is_own(&session["values"]["values"]), "{name}: {session}");
        assert_eq!(session["keys"].as_array().unwrap().is_empty(), own.is_empty(), "{name}");
        assert!(session["map"].is_null() && session["choices"].as_array().unwrap().is_empty(), "{name}");
        if name == "contact" {
            let scales = served
                .post("/api/case", &json!({ "set": ["substrate.retardation_time=20 ms"] }))
                .json()["scales"]
                .clone();
            assert!(scales["natural_frequency"].is_null() && scales["length"].is_null(), "{scales}");
            assert_eq!(scales["time"], 0.02);
        }
    }
}
