//! What the command says of inputs that it refuses, to the letter. The golden file holds the inputs too: a new one is added there by hand, with
//! `"said": []`, and written.

use super::agreement::Numbers;
use super::file;
use crate::desk::Desk;
use serde_json::{Value, json};

const FILE: &str = "messages.json";

/// A text of the golden file: a list of its lines.
fn joined(lines: &Value) -> String {
    let lines: Vec<&str> = lines.as_array().unwrap().iter().map(|line| line.as_str().unwrap()).collect();
    lines.join("\n")
}

/// Calls the command as an entry says, on a desk with its files.
fn replayed(entry: &Value) -> Value {
    let desk = Desk::new();
    for (name, lines) in entry["files"].as_object().unwrap() {
        let path = desk.path(name);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        desk.write(name, joined(lines));
    }
    let arguments: Vec<&str> =
        entry["arguments"].as_array().unwrap().iter().map(|word| word.as_str().unwrap()).collect();
    let said = desk.judder(&arguments);
    let lines = |text: &str| json!(text.split('\n').collect::<Vec<_>>());
    let mut replayed = entry.clone();
    replayed["exit"] = json!(said.code);
    replayed["said"] = lines(&said.stderr);
    if !said.stdout.is_empty() {
        replayed["printed"] = lines(&said.stdout);
    }
    replayed
}

#[test]
fn messages_say_what_they_said() {
    let entries = file::read(FILE);
    let replayed: Vec<Value> = entries.as_array().unwrap().iter().map(replayed).collect();
    file::check(FILE, &Value::Array(replayed), Numbers::Exact);
}
