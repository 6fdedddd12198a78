//! Many requests, large requests, requests that nobody wants any more.

use crate::client::{Answer, Served};
use serde_json::{Value, json};
use std::io::{Read, Write};
use std::time::{Duration, Instant};

/// A map whose every point is decided: the longest map that a page may ask for.
fn map(points: u64, slot: Option<&str>) -> Value {
    json!({
        "analysis": {
            "name": "map", "kind": "stability-map",
            "x": { "key": "operation.velocity", "from": 1e-8, "to": 1e2, "points": points, "scale": "log" },
            "y": { "key": "contact.shear_strength", "from": 1e-4, "to": 1.0, "points": points, "scale": "log" },
        },
        "boundaries": ["full", "conservative", "decoupled"],
        "slot": slot,
    })
}

/// A motion that takes minutes.
fn long_motion(slot: Option<&str>) -> Value {
    json!({
        "set": ["contact.shear_strength=0.1"],
        "analysis": { "name": "motion", "kind": "motion", "duration": 1e7, "steps": 50_000_000, "points": 1_000_000 },
        "slot": slot,
    })
}

#[test]
fn a_map_of_a_thousand_million_points_is_refused() {
    let served = Served::new();
    let answer = served.post("/api/map", &map(31_623, None));
    assert_eq!(answer.status, 413);
    assert!(
        answer.error().contains("31623 × 31623 points") && answer.error().contains("judder run"),
        "{}",
        answer.error()
    );
    for analysis in [
        json!({ "name": "m", "kind": "motion", "points": 1_000_000_000 }),
        json!({ "name": "s", "kind": "spectrum", "sweep": { "key": "operation.velocity", "from": 1, "to": 2, "points": 1e12 } }),
    ] {
        assert_eq!(served.post("/api/analysis", &json!({ "analysis": analysis })).status, 413);
    }
}

#[test]
fn a_boundary_is_asked_for_once() {
    let served = Served::new();
    let mut wanted = map(40, None);
    wanted["boundaries"] = json!(vec!["full"; 5000]);
    let answer = served.post("/api/map", &wanted);
    assert_eq!(answer.status, 400);
    assert!(answer.error().contains("`full` is asked for more than once"), "{}", answer.error());
}

#[test]
fn an_analysis_has_its_part_of_the_memory() {
    let served = Served::new();
    let spectrum = |points: u64| {
        json!({ "analysis": { "name": "spectrum", "kind": "spectrum", "sweep": {
            "key": "operation.velocity", "from": 1e-6, "to": 1e-1, "points": points, "scale": "log",
        }}})
    };
    let frames = served.post("/api/analysis", &spectrum(1_000_000)).frames();
    let told = frames.last().unwrap().header["error"]["message"].to_string();
    assert!(told.contains("5.5 GB of memory are needed") && told.contains("shared among 8"), "{told}");
    assert_eq!(served.post("/api/analysis", &spectrum(100)).frames().last().unwrap().kind(), "end");
}

#[test]
fn a_motion_beyond_all_numbers_is_answered_at_once() {
    let served = Served::new();
    let fast = json!({
        "set": ["operation.velocity=1e308"],
        "analysis": { "kind": "motion", "duration": 50, "points": 51 },
    });
    let start = Instant::now();
    let answer = served.post("/api/motion", &fast);
    assert!(start.elapsed() < Duration::from_secs(10), "{:?}", start.elapsed());
    assert!(
        answer.frames().last().is_some_and(|frame| ["end", "error"].contains(&frame.kind())),
        "{answer:?}"
    );
}

#[test]
fn a_hundred_heavy_requests_leave_the_page_alive() {
    let served = Served::new();
    let request = served.request("/api/motion", &long_motion(None).to_string());
    let connections: Vec<_> = (0..100)
        .map(|_| {
            let mut stream = served.connect();
            stream.write_all(request.as_bytes()).unwrap();
            stream
        })
        .collect();
    // the page, a point, a law and a map are answered while those are at work or wait
    assert_eq!(served.get("/api/session").status, 200);
    assert_eq!(served.get("/").status, 200);
    assert_eq!(served.post("/api/point", &json!({})).status, 200);
    let range = json!({ "from": 1e-3, "to": 1.0, "points": 30 });
    let law = served.post("/api/law", &json!({ "velocity": range, "indentation": range }));
    assert_eq!(law.frames().last().unwrap().kind(), "end");
    let drawn = served.post("/api/map", &map(400, None));
    assert_eq!(drawn.frames().last().unwrap().kind(), "end");
    let (mut refused, mut streams) = (0, Vec::new());
    for mut stream in connections {
        let mut start = [0; 12];
        stream.read_exact(&mut start).unwrap();
        match &start[9..] {
            b"503" => {
                let mut rest = String::new();
                stream.read_to_string(&mut rest).unwrap();
                assert!(rest.contains("retry-after: 1\r\n"), "{rest}");
                refused += 1;
            }
            b"200" => streams.push(stream),
            other => panic!("{other:?}"),
        }
    }
    assert_eq!((refused, streams.len()), (85, 15), "three work, twelve wait, the others are told so");
    drop(streams);
    // who goes makes room
    let short = json!({ "analysis": { "name": "motion", "kind": "motion", "duration": 1.0 } });
    let answered = (0..600).any(|_| {
        std::thread::sleep(Duration::from_millis(100));
        served.post("/api/motion", &short).frames().last().is_some_and(|frame| frame.kind() == "end")
    });
    assert!(answered);
}

#[test]
fn a_newer_request_cancels_the_older_at_once() {
    let served = Served::new();
    let mut older = served.connect();
    older
        .write_all(served.request("/api/motion", &long_motion(Some("tab/motion")).to_string()).as_bytes())
        .unwrap();
    let mut start = [0; 2048];
    assert!(older.read(&mut start).unwrap() > 0, "it works");
    // another slot does not touch it
    let other = served.post("/api/map", &map(40, Some("tab/map")));
    assert_eq!(other.frames().last().unwrap().kind(), "end");
    let short =
        json!({ "analysis": { "name": "motion", "kind": "motion", "duration": 1.0 }, "slot": "tab/motion" });
    let newer = served.post("/api/motion", &short);
    assert_eq!(newer.frames().last().unwrap().kind(), "end", "{:?}", newer.frames().last());
    let mut rest = Vec::new();
    older.read_to_end(&mut rest).unwrap();
    let rest = String::from_utf8_lossy(&rest);
    assert!(rest.contains("a newer request has taken its place"), "the older stream ends, and says why");
}

#[test]
fn a_superseded_request_that_waits_never_works() {
    let served = Served::new();
    let send = |slot: String| {
        let mut stream = served.connect();
        stream
            .write_all(served.request("/api/motion", &long_motion(Some(&slot)).to_string()).as_bytes())
            .unwrap();
        let mut start = [0; 12];
        stream.read_exact(&mut start).unwrap();
        stream
    };
    let _working: Vec<_> = (0..3).map(|number| send(format!("working/{number}"))).collect();
    // twelve places, and one drag that asks forty times: each takes the place of the one before
    let waiting: Vec<_> = (0..40).map(|_| send("drag".to_owned())).collect();
    for mut stream in waiting.into_iter().take(39) {
        let answer = Answer::read(&mut stream);
        assert!(answer.body.len() < 400, "nothing was computed: {} bytes", answer.body.len());
    }
}

#[test]
fn who_does_not_read_holds_up_nobody() {
    let served = Served::new();
    let send = |slot: &str| {
        let mut stream = served.connect();
        let request = served.request("/api/motion", &long_motion(Some(slot)).to_string());
        stream.write_all(request.as_bytes()).unwrap();
        stream
    };
    let unread: Vec<_> = (0..3).map(|number| send(&format!("unread/{number}"))).collect();
    // long enough to fill every buffer on the way
    std::thread::sleep(Duration::from_secs(4));
    let drawn = served.post("/api/map", &map(40, None));
    assert_eq!(drawn.frames().last().unwrap().kind(), "end");
    let short =
        json!({ "analysis": { "name": "motion", "kind": "motion", "duration": 1.0 }, "slot": "unread/1" });
    let newer = served.post("/api/motion", &short);
    assert_eq!(
        newer.frames().last().unwrap().kind(),
        "end",
        "the newest has its slot, whoever reads the older"
    );
    drop(unread);
}

#[test]
fn a_slot_hands_its_place_over_where_there_is_no_other() {
    let served = Served::new();
    let send = |slot: &str| {
        let mut stream = served.connect();
        stream
            .write_all(served.request("/api/motion", &long_motion(Some(slot)).to_string()).as_bytes())
            .unwrap();
        let mut start = [0; 12];
        stream.read_exact(&mut start).unwrap();
        (stream, start)
    };
    let held: Vec<_> = (0..15).map(|number| send(&format!("slot/{number}"))).collect();
    assert!(held.iter().all(|(_, start)| start.ends_with(b"200")));
    assert!(send("another").1.ends_with(b"503"), "no place is left");
    for slot in ["slot/0", "slot/14", "slot/14"] {
        assert!(send(slot).1.ends_with(b"200"), "{slot} hands its own over");
    }
}

#[test]
fn a_law_that_is_computed_keeps_no_point_waiting() {
    let served = Served::new();
    let body = json!({ "set": ["contact.law=bem", "substrate.glassy_modulus=7.3 MPa"] });
    let request = served.request("/api/point", &body.to_string());
    let waiting: Vec<_> = (0..40)
        .map(|_| {
            let mut stream = served.connect();
            stream.write_all(request.as_bytes()).unwrap();
            stream
        })
        .collect();
    assert_eq!(served.post("/api/point", &json!({})).status, 200);
    for stream in &waiting {
        stream.set_nonblocking(true).unwrap();
        assert!(stream.peek(&mut [0]).is_err(), "the law is still being computed");
    }
}
