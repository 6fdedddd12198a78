//! The study folder: what lies in it is shown, what lies beside it is not.

use crate::client::Served;
use judder_study::Silent;
use judder_study::run::{RunOptions, run};
use serde_json::{Value, json};
use std::fs;
use std::io::{Read, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};
use tempfile::TempDir;

const CASE: &str = r#"
title = "A small study"
model = "oscillator"

[contact]
shear_strength = 0.05

[[analysis]]
name = "damping"
kind = "equivalent-damping"
sweep = { key = "operation.velocity", from = 1e-5, to = 1e-2, points = 7, scale = "log" }

[[analysis]]
name = "spectrum"
kind = "spectrum"
sweep = { key = "operation.velocity", from = 1e-5, to = 1e-2, points = 3, scale = "log" }
"#;

/// What the study was run with besides.
fn set() -> [String; 1] {
    ["oscillator.coupling=0.9".to_owned()]
}

/// A folder with a study in it, and a secret beside the study.
fn study_beside_a_secret() -> (TempDir, PathBuf) {
    let place = tempfile::tempdir().unwrap();
    let folder = place.path().join("study");
    let file = judder_models::parse("small.toml", CASE, &set()).unwrap();
    run(&file, &folder, &RunOptions::default(), &Silent).unwrap();
    fs::write(folder.join("tone.wav"), b"RIFF of a tone").unwrap();
    fs::write(place.path().join("secret.wav"), b"RIFF of a secret").unwrap();
    (place, folder)
}

fn served(folder: &Path) -> Served {
    Served::of(None, Some(folder))
}

#[test]
fn a_study_is_listed_and_its_case_explored() {
    let (_place, folder) = study_beside_a_secret();
    let served = served(&folder);
    let session = served.get("/api/session").json();
    assert_eq!((&session["title"], &session["study"]["name"]), (&json!("A small study"), &json!("study")));
    let study = served.get("/api/study").json();
    assert_eq!(study["analyses"][0]["kind"], "equivalent-damping");
    assert_eq!(study["sounds"], json!([{ "path": "tone.wav", "bytes": 14 }]));
    let point = served.post("/api/point", &json!({})).json();
    assert_eq!(point["point"]["groups"]["shear_strength"], 0.05);
}

#[test]
fn the_case_of_an_analysis_is_that_of_the_folder() {
    let (_place, folder) = study_beside_a_secret();
    let served = served(&folder);
    let exported = |name: &str| {
        let answer = served.post("/api/study/case", &json!({ "analysis": name }));
        judder_models::parse("exported.toml", &answer.text(), &[]).unwrap()
    };
    let whole = judder_models::parse("small.toml", CASE, &set()).unwrap();
    for (index, name) in ["damping", "spectrum"].into_iter().enumerate() {
        let (case, mut expected) = (exported(name), whole.resolved());
        expected["analysis"] = json!([expected["analysis"][index]]);
        assert_eq!(case.resolved(), expected, "{name}");
    }
    let missing = served.post("/api/study/case", &json!({ "analysis": "dampin" }));
    assert_eq!((missing.status, missing.error().contains("did you mean `damping`?")), (422, true));
    assert_eq!(served.post("/api/study/case", &json!({ "analysis": "damping", "set": [] })).status, 400);
    assert_eq!(Served::new().post("/api/study/case", &json!({ "analysis": "damping" })).status, 404);
}

#[test]
fn arrays_are_those_of_the_folder() {
    let (_place, folder) = study_beside_a_secret();
    let served = served(&folder);
    let wanted = |analysis: &str, variables: Value| json!({ "analysis": analysis, "variables": variables });
    let frames = served.post("/api/study/arrays", &wanted("damping", json!(["equivalent_damping"]))).frames();
    assert_eq!(frames[0].reals("equivalent_damping").len(), 7);
    for (analysis, variable) in [
        ("damping", "nothing"),
        ("nothing", "x"),
        ("../study/damping", "equivalent_damping"),
        ("damping", "../damping/equivalent_damping"),
        ("damping", "/etc/passwd"),
        ("", ""),
        (".", "damping"),
        ("..", "secret.wav"),
        ("damping\u{0}", "x"),
    ] {
        let frames = served.post("/api/study/arrays", &wanted(analysis, json!([variable]))).frames();
        assert_eq!(frames[0].kind(), "error", "{analysis} {variable}");
    }
    assert_eq!(served.post("/api/study/arrays", &wanted("damping", json!(vec!["x"; 33]))).status, 413);
}

#[test]
fn sounds_come_from_the_folder_alone() {
    let (place, folder) = study_beside_a_secret();
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink(place.path().join("secret.wav"), folder.join("link.wav")).unwrap();
        std::os::unix::fs::symlink(place.path(), folder.join("up")).unwrap();
    }
    let served = served(&folder);
    let tone = served.get("/api/study/sound/tone.wav");
    assert_eq!((tone.status, tone.header("content-type")), (200, Some("audio/wav")));
    assert_eq!(tone.text(), "RIFF of a tone");
    let secret = place.path().join("secret.wav").display().to_string();
    for path in [
        "../secret.wav".to_owned(),
        "..%2fsecret.wav".to_owned(),
        "%2e%2e/secret.wav".to_owned(),
        "..%5csecret.wav".to_owned(),
        "....//secret.wav".to_owned(),
        "link.wav".to_owned(),
        "up/secret.wav".to_owned(),
        "./../study/../secret.wav".to_owned(),
        secret.clone(),
        format!("%2f{}", &secret[1..]),
        "summary.json".to_owned(),
        "tone.wav%00".to_owned(),
        "tone.wav/".to_owned(),
    ] {
        let answer = served.get(&format!("/api/study/sound/{path}"));
        assert!([400, 404].contains(&answer.status), "{path}: {}", answer.status);
        assert!(
            !answer.text().contains("a secret") && !answer.text().contains(&secret),
            "{path}: {}",
            answer.text()
        );
    }
    let listed = served.get("/api/study").json();
    assert_eq!(listed["sounds"].as_array().unwrap().len(), 1, "{listed}");
}

#[test]
fn a_sound_is_handed_on_as_it_is_read() {
    let (_place, folder) = study_beside_a_secret();
    let size = 1_u64 << 40;
    fs::File::create(folder.join("long.wav")).unwrap().set_len(size).unwrap();
    let served = served(&folder);
    let mut stream = served.connect();
    let head = format!("Host: 127.0.0.1:{}\r\nCookie: {}\r\n", served.port, served.cookie());
    stream.write_all(format!("GET /api/study/sound/long.wav HTTP/1.1\r\n{head}\r\n").as_bytes()).unwrap();
    // more than any memory holds: what comes has not waited for the rest
    let mut start = vec![0; 1 << 20];
    stream.read_exact(&mut start).unwrap();
    assert!(String::from_utf8_lossy(&start[..500]).contains(&format!("content-length: {size}\r\n")));
    drop(stream);
    assert_eq!(served.get("/api/study/sound/tone.wav").text(), "RIFF of a tone");
}

/// The folder of an array of the study.
fn array_of(folder: &Path) -> PathBuf {
    folder.join("results.zarr/damping/equivalent_damping")
}

#[test]
fn what_a_chunk_unpacks_to_is_what_its_array_has() {
    let (_place, folder) = study_beside_a_secret();
    fs::remove_file(folder.join("manifest.json")).unwrap();
    let chunk = array_of(&folder).join("c/0");
    let packed = fs::read(&chunk).unwrap();
    assert!(packed.len() < 200);
    // a frame of seven values, in place of which another stands: half a gigabyte of zeros, run by run
    let run = [&[0x02, 0, 0x10][..], &[0]].concat();
    let mut bomb = vec![0x28, 0xb5, 0x2f, 0xfd, 0x00, 0x38];
    for _ in 0..4095 {
        bomb.extend_from_slice(&run);
    }
    bomb.extend_from_slice(&[0x03, 0, 0x10, 0]);
    bomb.extend_from_slice(&crc32c(&bomb).to_le_bytes());
    fs::write(&chunk, bomb).unwrap();
    let wanted = json!({ "analysis": "damping", "variables": ["equivalent_damping"] });
    let frames = served(&folder).post("/api/study/arrays", &wanted).frames();
    let told = frames[0].header["error"]["message"].to_string();
    assert!(told.contains("does not unpack to 56 bytes"), "{told}");
}

/// The checksum of a chunk (RFC 3720, appendix B.4), bit by bit.
fn crc32c(bytes: &[u8]) -> u32 {
    let of_bit = |crc: u32, _| if crc & 1 == 1 { crc >> 1 ^ 0x82f6_3b78 } else { crc >> 1 };
    !bytes.iter().fold(!0, |crc, byte| (0..8).fold(crc ^ u32::from(*byte), of_bit))
}

#[test]
fn arrays_and_summaries_beyond_the_memory_are_refused() {
    let (_place, folder) = study_beside_a_secret();
    fs::remove_file(folder.join("manifest.json")).unwrap();
    let served = served(&folder);
    let metadata = array_of(&folder).join("zarr.json");
    let mut wide: Value = serde_json::from_slice(&fs::read(&metadata).unwrap()).unwrap();
    wide["shape"] = json!([60_000_000]);
    fs::write(&metadata, wide.to_string()).unwrap();
    let wanted = json!({ "analysis": "damping", "variables": ["equivalent_damping"] });
    let frames = served.post("/api/study/arrays", &wanted).frames();
    let told = frames[0].header["error"]["message"].to_string();
    assert!(told.contains("60000000"), "{told}");
    fs::File::options().write(true).open(folder.join("summary.json")).unwrap().set_len(1 << 42).unwrap();
    let listed = served.get("/api/study");
    assert!(listed.error().contains("such a file of judder at most"), "{}", listed.error());
}

#[test]
fn without_a_study_there_is_none() {
    let served = Served::new();
    let answer = served.get("/api/study");
    assert_eq!(answer.status, 404);
    assert!(answer.error().contains("judder run"), "{}", answer.error());
    let shapes = json!({ "analysis": "locus", "at": 0.05 });
    assert_eq!(served.post("/api/study/shapes", &shapes).status, 404);
    let (_place, folder) = study_beside_a_secret();
    let frames = self::served(&folder).post("/api/study/shapes", &shapes).frames();
    assert!(frames[0].header["error"]["message"].as_str().unwrap().contains("sliding case"), "{frames:?}");
}

/// A material of measured moduli, which lie beside the case.
fn measured(points: usize) -> String {
    format!(
        "model = \"contact\"\nsubstrate = {{ dma = {{ file = \"moduli.csv\", terms = 3 }} }}\n\
         [[analysis]]\nkind = \"modulus\"\nfrequency = {{ from = 1.0, to = 1e4, points = {points} }}\n"
    )
}

#[test]
fn a_study_speaks_for_itself_where_the_given_case_reads_the_same_files() {
    let place = tempfile::tempdir().unwrap();
    let moduli = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/tutorials/rubber-dma.csv");
    fs::copy(&moduli, place.path().join("moduli.csv")).unwrap();
    let put = |name: &str, text: &str| {
        let path = place.path().join(name);
        fs::write(&path, text).unwrap();
        path
    };
    let (ran, given) = (put("ran.toml", &measured(5)), put("given.toml", &measured(9)));
    let folder = place.path().join("study");
    run(&judder_models::read(&ran, &[]).unwrap(), &folder, &RunOptions::default(), &Silent).unwrap();
    let wanted = json!({ "analysis": "modulus" });
    assert_eq!(served(&folder).post("/api/study/case", &wanted).status, 404, "its file lies elsewhere");
    // the case that was given says where the files are, not what was run
    let text = Served::of(Some(&given), Some(&folder)).post("/api/study/case", &wanted).text();
    let exported = judder_models::parse("/nowhere/exported.toml", &text, &[]).unwrap();
    assert!(text.contains("points = 5") && exported.case.files()[0].path.ends_with("moduli.csv"), "{text}");
    // one that reads other files says nothing of this study
    let other = put("other.toml", CASE);
    assert_eq!(Served::of(Some(&other), Some(&folder)).post("/api/study/case", &wanted).status, 404);
}

#[test]
fn the_case_of_a_folder_reads_no_file_outside_of_it() {
    let (place, folder) = study_beside_a_secret();
    let law = place.path().join("law.json");
    fs::write(&law, "{ \"a\": \"secret\" }").unwrap();
    let summary = folder.join("summary.json");
    let told: Value = serde_json::from_slice(&fs::read(&summary).unwrap()).unwrap();
    let outside = format!("[contact]\nlaw = {{ file = \"{}\" }}", law.display());
    let source = told.to_string().replace("[contact]", &outside.replace('\n', "\\n").replace('"', "\\\""));
    assert!(source.contains("law.json"), "the folder's case names it: {source}");
    fs::write(&summary, source).unwrap();
    // an edited summary is refused where a manifest says what it was
    let refused =
        judder_study::study_view::StudyView::open(judder_models::REGISTRY, &folder).unwrap().listing();
    assert!(refused.unwrap_err().to_string().contains("judder verify"));
    fs::remove_file(folder.join("manifest.json")).unwrap();
    let served = served(&folder);
    let session = served.get("/api/session").json();
    assert_eq!((&session["case"], &session["study"]["name"]), (&Value::Null, &json!("study")), "{session}");
    let exported = served.post("/api/study/case", &json!({ "analysis": "damping" }));
    assert_eq!((exported.status, exported.text().contains("secret")), (404, false));
    let point = served.post("/api/point", &json!({}));
    assert_eq!(point.status, 404);
    assert!(!point.text().contains("secret"));
}

/// A label of 100 kB stops a browser: whatever a folder holds, what is sent of its texts is cut.
#[test]
fn labels_are_cut_where_they_are_sent() {
    let (_place, folder) = study_beside_a_secret();
    fs::remove_file(folder.join("manifest.json")).unwrap();
    let long = "ü".repeat(100_000);
    let edit = |path: &Path, change: &dyn Fn(&mut Value)| {
        let mut told: Value = serde_json::from_slice(&fs::read(path).unwrap()).unwrap();
        change(&mut told);
        fs::write(path, told.to_string()).unwrap();
    };
    edit(&folder.join("summary.json"), &|told| {
        told["case"]["title"] = json!(long);
        told["warnings"] = json!([long]);
        told["analyses"]["damping"]["warnings"] = json!([long]);
        told["results"]["damping"]["note"] = json!({ "deep": [long] });
    });
    edit(&array_of(&folder).join("zarr.json"), &|told| {
        for key in ["long_name", "units", "note"] {
            told["attributes"][key] = json!(long);
        }
    });
    let served = served(&folder);
    let listed = served.get("/api/study");
    let title = listed.json()["title"].as_str().unwrap().to_owned();
    assert!(title.ends_with("ü…") && title.chars().count() < 5000, "{}", title.chars().count());
    let longest = |told: &Value| texts(told).into_iter().map(str::len).max().unwrap();
    assert!(longest(&listed.json()) < 10_000);
    let wanted = json!({ "analysis": "damping", "variables": ["equivalent_damping"] });
    let frames = served.post("/api/study/arrays", &wanted).frames();
    assert_eq!(frames[0].reals("equivalent_damping").len(), 7);
    assert!(longest(&frames[0].header) < 10_000);
    let reported = served.post("/api/study/report", &json!({ "analysis": "damping" })).frames();
    let figure: Value = serde_json::from_str(reported[0].header["figure"].as_str().unwrap()).unwrap();
    assert!(longest(&figure) < 10_000 && longest(&reported[0].header["tables"]) < 10_000);
}

/// All texts of a document.
fn texts(told: &Value) -> Vec<&str> {
    match told {
        Value::String(text) => vec![text],
        Value::Array(items) => items.iter().flat_map(texts).collect(),
        Value::Object(table) => {
            table.iter().flat_map(|(key, value)| [vec![key.as_str()], texts(value)].concat()).collect()
        }
        _ => Vec::new(),
    }
}

/// Many who ask for what takes long to read, and go: their work is left undone, and the next one does not wait for that.
#[test]
fn arrays_that_nobody_waits_for_are_read_no_further() {
    let (_place, folder) = study_beside_a_secret();
    fs::remove_file(folder.join("manifest.json")).unwrap();
    // one chunk under many names
    let (array, chunks) = (array_of(&folder), 1000);
    (1..chunks).for_each(|k| fs::hard_link(array.join("c/0"), array.join(format!("c/{k}"))).unwrap());
    let mut wide: Value = serde_json::from_slice(&fs::read(array.join("zarr.json")).unwrap()).unwrap();
    wide["shape"] = json!([7 * chunks]);
    fs::write(array.join("zarr.json"), wide.to_string()).unwrap();
    let served = served(&folder);
    let wanted = json!({ "analysis": "damping", "variables": ["equivalent_damping"], "most": 10 });
    let start = Instant::now();
    let frames = served.post("/api/study/arrays", &wanted).frames();
    let whole = start.elapsed();
    assert_eq!(frames[0].reals("equivalent_damping").len(), 10);
    // as many as are worked on and wait
    let asked: Vec<_> = (0..15)
        .map(|_| {
            let mut stream = served.connect();
            let request = served.request("/api/study/arrays", &wanted.to_string());
            stream.write_all(request.as_bytes()).unwrap();
            let mut start = [0; 12];
            stream.read_exact(&mut start).unwrap();
            assert!(start.ends_with(b"200"));
            stream
        })
        .collect();
    drop(asked);
    // three were being read, and would be for most of the time that one takes
    let start = Instant::now();
    let few = json!({ "analysis": "spectrum", "variables": ["velocity"] });
    let mut answer = served.post("/api/study/arrays", &few);
    while answer.status == 503 && start.elapsed() < whole {
        std::thread::sleep(Duration::from_millis(5));
        answer = served.post("/api/study/arrays", &few);
    }
    assert_eq!(answer.frames().last().unwrap().kind(), "end");
    assert!(start.elapsed() < whole / 2, "{:?}, where one takes {whole:?}", start.elapsed());
}

/// The shapes of a pair that takes a while to be reduced.
#[test]
fn shapes_that_nobody_waits_for_are_given_up() {
    let place = tempfile::tempdir().unwrap();
    let folder = place.path().join("study");
    let text = judder_models::template::template("beams-paper").unwrap();
    let text = text
        .replace("elements = [75, 2]", "elements = [40, 1]")
        .replace("elements = [100, 2]", "elements = [50, 1]");
    let file = judder_models::parse("beams.toml", &text, &[]).unwrap();
    let only = vec!["modes-horizontal".to_owned()];
    run(&file, &folder, &RunOptions { only, ..RunOptions::default() }, &Silent).unwrap();
    let served = served(&folder);
    let wanted = json!({ "analysis": "locus", "at": 0.05, "count": 1, "slot": "tab/shapes" });
    let mut older = served.connect();
    older.write_all(served.request("/api/study/shapes", &wanted.to_string()).as_bytes()).unwrap();
    let mut start = [0; 12];
    older.read_exact(&mut start).unwrap();
    let newer = served.post("/api/study/shapes", &wanted).frames();
    assert_eq!((newer[0].kind(), newer.last().unwrap().kind()), ("shapes", "end"), "{:?}", newer.last());
    let mut rest = Vec::new();
    older.read_to_end(&mut rest).unwrap();
    assert!(String::from_utf8_lossy(&rest).contains("a newer request has taken its place"));
}
