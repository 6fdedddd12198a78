//! Folders that cannot take or do not hold a study.

use std::fs;

use crate::desk::{CASE, Desk, Said};

#[test]
fn an_output_folder_that_is_a_file() {
    let desk = Desk::with_case(CASE);
    desk.write("taken", "precious");
    let message = "a study needs a folder, and this is a file";
    desk.refused(&["run", "case.toml", "-o", "taken"], message, "name another place with -o");
    desk.refused(&["run", "case.toml", "-o", "taken/inner"], message, "name another place with -o");
    desk.refused(&["reproduce", "--quick", "-o", "taken"], message, "name another place with -o");
    desk.refused(&["report", "taken"], message, "");
    assert_eq!(fs::read_to_string(desk.path("taken")).unwrap(), "precious");
}

#[test]
fn a_folder_with_files_of_others() {
    let desk = Desk::with_case(CASE);
    let message = "not a study and not empty (it holds `case.toml`)";
    desk.refused(&["run", "case.toml", "-o", "."], message, "so that nothing of yours is overwritten");
}

#[test]
fn a_folder_that_is_no_study() {
    let desk = Desk::with_case(CASE);
    fs::create_dir(desk.path("empty")).unwrap();
    for folder in ["empty", "nowhere"] {
        desk.refused(&["report", folder], "no study here", "`judder run` makes one");
    }
}

#[test]
fn a_summary_of_something_else() {
    let desk = Desk::with_case(CASE);
    fs::create_dir(desk.path("other")).unwrap();
    desk.write("other/summary.json", "{\"by\": \"someone else\"}");
    let said = desk.judder(&["report", "other"]);
    assert_eq!(said.code, 2);
    said.says("not a summary of judder");
    said.says("--fresh");
}

/// In a file system of 128 KiB that lives only as long as the shell which mounted it.
#[cfg(target_os = "linux")]
#[test]
fn a_full_disk() {
    use std::process::Command;

    const SCRIPT: &str = "mount -t tmpfs -o size=128k none disk && touch mounted && \
        \"$JUDDER\" run case.toml -o disk/study; code=$?; find disk -mindepth 1 > left; \
        cat disk/study/summary.json > summary.json; exit $code";
    // the first analysis fits, the second does not
    let desk = Desk::with_case(
        "model = \"oscillator\"\n[[analysis]]\nname = \"small\"\nkind = \"equivalent-damping\"\n\
         sweep = { key = \"operation.velocity\", from = 1e-3, to = 1, points = 5 }\n\
         [[analysis]]\nname = \"large\"\nkind = \"spectrum\"\n\
         sweep = { key = \"operation.velocity\", from = 1e-3, to = 1, points = 20000 }\n",
    );
    fs::create_dir(desk.path("disk")).unwrap();
    let output = Command::new("unshare")
        .args(["--user", "--map-root-user", "--mount", "sh", "-c", SCRIPT])
        .env("JUDDER", env!("CARGO_BIN_EXE_judder"))
        .current_dir(desk.path("."))
        .output();
    if !desk.path("mounted").exists() {
        eprintln!("SKIPPED: a_full_disk needs `unshare` and leave to mount: {output:?}");
        return;
    }
    let said = Said::of(output.unwrap());
    assert_eq!(said.code, 1, "{}", said.stderr);
    said.says("no room for ");
    said.says("what is done is kept");
    let left = fs::read_to_string(desk.path("left")).unwrap();
    assert!(!left.contains(".tmp") && !left.contains("staging"), "{left}");
    let summary = desk.read_json("summary.json");
    assert_eq!(summary["analyses"]["small"]["status"], "done");
    assert!(summary["results"]["large"].is_null());
}

/// A limit of the shell, whose signal would end the process without a word.
#[cfg(unix)]
#[test]
fn a_limit_on_the_size_of_files() {
    let desk = Desk::with_case(CASE);
    let mut command = std::process::Command::new("sh");
    command.args(["-c", "ulimit -f 20; exec \"$JUDDER\" run case.toml --json"]);
    command.env("JUDDER", env!("CARGO_BIN_EXE_judder")).current_dir(desk.path("."));
    let said = Said::of(command.output().unwrap());
    assert_eq!(said.code, 1, "{}", said.stderr);
    let error = &said.json()["error"];
    assert!(error["message"].as_str().unwrap().starts_with("out/case/"), "{error}");
    said.says("File too large");
    said.says("help: let larger files be written (`ulimit -f`)");
    desk.succeed(&["run", "case.toml"]).says("done before: map");
}

/// Two case files of one name in different folders, both of which would go to `out/case`.
#[test]
fn a_folder_with_the_study_of_another_case_file() {
    let desk = Desk::new();
    for (place, load) in [("a", "1 mN"), ("b", "2 mN")] {
        fs::create_dir(desk.path(place)).unwrap();
        desk.write(&format!("{place}/case.toml"), quick(place, load));
    }
    desk.succeed(&["run", "a/case.toml"]);
    let message = "out/case: holds the study of a/case.toml, another case file of this name";
    desk.refused(&["run", "b/case.toml"], message, "name another folder with -o");
    desk.refused(&["run", "b/case.toml"], message, "--fresh");
    // a folder of its own, and the first one goes on where it was, from wherever it is called
    desk.succeed(&["run", "b/case.toml", "-o", "out/b"]);
    desk.succeed(&["run", "./b/../a/case.toml"]).says("done before: damping\n");
    let title = |desk: &Desk| desk.read_json("out/case/summary.json")["case"]["title"].clone();
    assert_eq!(title(&desk), "a");
    desk.succeed(&["run", "b/case.toml", "--fresh"]);
    assert_eq!(title(&desk), "b");
    desk.refused(&["run", "a/case.toml"], "holds the study of b/case.toml", "");
    // whose file is gone is nobody's any more, and what is lost is named
    fs::remove_file(desk.path("b/case.toml")).unwrap();
    desk.succeed(&["run", "a/case.toml"]).says("forgotten, since what they depend on has changed: damping\n");
}

#[test]
fn a_study_may_be_moved_with_its_case_file() {
    let desk = Desk::new();
    fs::create_dir_all(desk.path("here")).unwrap();
    desk.write("here/case.toml", quick("here", "1 mN"));
    let run = |place: &str| {
        Said::of(desk.command(&["run", "case.toml"]).current_dir(desk.path(place)).output().unwrap())
    };
    assert_eq!(run("here").code, 0);
    assert_eq!(desk.read_json("here/out/case/summary.json")["study"]["file"], "../../case.toml");
    fs::rename(desk.path("here"), desk.path("there")).unwrap();
    run("there").says("done before: damping\n");
}

/// A case with one quick analysis.
fn quick(title: &str, load: &str) -> String {
    format!(
        "title = \"{title}\"\nmodel = \"oscillator\"\noperation.normal_load = \"{load}\"\n\
         [[analysis]]\nname = \"damping\"\nkind = \"equivalent-damping\"\n\
         sweep = {{ key = \"operation.velocity\", from = 1e-5, to = 1e-2, points = 5 }}\n"
    )
}

#[cfg(target_os = "linux")]
#[test]
fn a_path_that_is_no_text() {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt;

    let desk = Desk::with_case(CASE);
    let odd = OsStr::from_bytes(b"a\xffb");
    let call =
        |arguments: &[&str], last: &OsStr| Said::of(desk.command(arguments).arg(last).output().unwrap());
    let before = desk.files();
    let said = call(&["run", "case.toml", "--json", "-o"], odd);
    assert_eq!(said.code, 2, "{}", said.stderr);
    said.says("not text in UTF-8");
    said.says("name another place with -o");
    assert_eq!(desk.files(), before, "nothing is written");
    // what needs no arrays goes there
    let said = call(&["examples", "python/own-rubber-to-map", "--json", "-o"], odd);
    assert_eq!(said.code, 0, "{}", said.stderr);
    assert!(said.json()["path"].is_string());
    fs::copy(desk.path("case.toml"), desk.0.path().join(odd).join("case.toml")).unwrap();
    let case = desk.0.path().join(odd).join("case.toml");
    assert_eq!(call(&["run", "--only", "damping", "-o", "out/odd"], case.as_os_str()).code, 0);
    let said = call(&["report", "out/odd", "--json", "-o"], OsStr::from_bytes(b"r\xff"));
    assert_eq!(said.code, 2, "{}", said.stderr);
}

#[test]
fn a_report_elsewhere_leaves_the_study_alone() {
    let desk = Desk::with_case(&quick("one", "1 mN"));
    desk.succeed(&["run", "case.toml"]);
    let page = fs::read(desk.path("out/case/report.html")).unwrap();
    for file in ["report.html", "figures/damping.svg"] {
        fs::remove_file(desk.path("out/case").join(file)).unwrap();
    }
    fs::remove_file(desk.path("out/case/.judder.lock")).unwrap();
    let before = crate::desk::files_below(&desk.path("out"));
    for _ in 0..2 {
        let said = desk.succeed(&["report", "out/case", "-o", "elsewhere", "--json"]);
        assert_eq!(said.json(), serde_json::json!({ "report": "elsewhere/report.html" }));
    }
    assert_eq!(crate::desk::files_below(&desk.path("out")), before);
    assert_eq!(fs::read(desk.path("elsewhere/report.html")).unwrap(), page);
    assert!(desk.path("elsewhere/figures/damping.svg").is_file());
    // neither another study nor somebody's files
    desk.refused(&["report", "out/case", "-o", "out/case"], "holds a study", "name a new");
    desk.write("taken.txt", "precious");
    desk.refused(&["report", "out/case", "-o", "."], "not a study and not empty", "-o");
}

#[test]
fn a_figure_that_fails_leaves_the_others() {
    let desk = Desk::with_case(CASE);
    desk.succeed(&["run", "case.toml", "--only", "loci", "--only", "damping"]);
    fs::remove_file(desk.path("out/case/report.html")).unwrap();
    let metadata = desk.path("out/case/results.zarr/damping/zarr.json");
    let text = fs::read_to_string(&metadata).unwrap();
    fs::write(&metadata, text.replace("judder", "jodder")).unwrap();
    let said = desk.judder(&["report", "out/case", "-q", "--json"]);
    assert_eq!(said.code, 1, "{}", said.stderr);
    said.says("a requested result is missing: damping: no figure: ");
    assert!(said.json()["lacking"][0].as_str().unwrap().starts_with("damping: no figure: "));
    let page = fs::read_to_string(desk.path("out/case/report.html")).unwrap();
    assert!(page.contains("id=\"figure-loci\"") && !page.contains("id=\"figure-damping\""));
    assert!(page.contains("no figure</span> damping: "));
}

/// Somebody's folder has the name of a figure: it stays, and the page is drawn without that figure.
#[test]
fn a_figure_that_cannot_be_written_leaves_the_others() {
    let desk = Desk::with_case(CASE);
    desk.succeed(&["run", "case.toml", "--only", "loci", "--only", "damping"]);
    fs::remove_file(desk.path("out/case/figures/damping.svg")).unwrap();
    fs::create_dir(desk.path("out/case/figures/damping.svg")).unwrap();
    desk.write("out/case/figures/damping.svg/precious.txt", "mine");
    let said = desk.judder(&["report", "out/case", "-q"]);
    assert_eq!(said.code, 1, "{}", said.stderr);
    said.says("a folder stands in the place of a file of the study; move it away");
    let page = fs::read_to_string(desk.path("out/case/report.html")).unwrap();
    assert!(page.contains("id=\"figure-loci\"") && !page.contains("id=\"figure-damping\""));
    assert!(desk.path("out/case/figures/damping.svg/precious.txt").is_file());
    // nor does a run from nothing take it
    assert_eq!(desk.judder(&["run", "case.toml", "--only", "damping", "--fresh", "-q"]).code, 1);
    assert!(desk.path("out/case/figures/damping.svg/precious.txt").is_file());
    let table = desk.path("out/case/damping.csv");
    fs::remove_file(&table).unwrap();
    fs::create_dir(&table).unwrap();
    desk.write("out/case/damping.csv/precious.txt", "mine");
    let said = desk.judder(&["run", "case.toml", "--only", "damping", "--fresh", "-q"]);
    assert_eq!(said.code, 1, "{}", said.stderr);
    said.says("damping.csv: a folder stands in the place of a file of the study");
    assert!(table.join("precious.txt").is_file());
}
