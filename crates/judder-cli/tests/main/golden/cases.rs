//! What cases resolve to, and the hashes under which their results are known. The version is part of the latter: a new one has others.

use super::agreement::Numbers;
use super::generated::{COUNT, GeneratedCase, generated};
use super::{case_files, file, small_cases, workspace};
use judder_keys::error::CaseError;
use judder_models::template::{template, templates};
use judder_study::case::file::CaseFile;
use judder_study::run::identity;
use serde_json::{Map, Value, json};

/// Digits of a hash that tell results of the same name apart.
const DIGITS: usize = 16;

/// What is frozen of a case: what it resolves to, with its hashes, or why it is none.
fn frozen(case: Result<CaseFile, CaseError>) -> Value {
    let file = match case {
        Ok(file) => file,
        Err(error) => return json!({ "refused": error.to_string(), "at": error.place() }),
    };
    match identity(&file) {
        Ok(identity) => {
            let short = |(name, hash): &(String, String)| (name.clone(), json!(hash[..DIGITS]));
            let results: Map<String, Value> = identity.results.iter().map(short).collect();
            json!({ "hash": identity.case_hash, "results": results, "resolved": identity.resolved })
        }
        // matrices that are no part of judder
        Err(_) => json!({ "hash": null, "resolved": file.resolved() }),
    }
}

#[test]
fn shipped_cases_and_templates_resolve_as_before() {
    let folder = workspace("cases");
    let mut found = Map::new();
    for path in case_files(&folder) {
        let name = path.strip_prefix(&folder).unwrap().to_str().unwrap().replace('\\', "/");
        found.insert(name, frozen(judder_models::read(&path, &[])));
    }
    for name in templates() {
        let text = template(name).unwrap();
        let case = frozen(judder_models::parse("case.toml", &text, &[]));
        found.insert(format!("judder new {name}"), case);
    }
    file::check("cases.json", &Value::Object(found), Numbers::Exact);
}

#[test]
fn generated_cases_resolve_as_before() {
    let mut refused = 0;
    let mut found = Map::new();
    for index in 0..COUNT {
        let GeneratedCase { base, appended, options } = generated(index);
        let path = small_cases().join(format!("{base}.toml"));
        let text = std::fs::read_to_string(&path).unwrap() + "\n" + &appended.concat();
        let mut entry = frozen(judder_models::parse(path.to_str().unwrap(), &text, &options));
        refused += usize::from(entry.get("refused").is_some());
        entry["appended"] = json!(appended);
        entry["set"] = json!(options);
        found.insert(format!("{index:03} {base}"), entry);
    }
    assert!(refused * 6 < COUNT, "{refused} of {COUNT} cases are refused");
    file::check("generated-cases.json", &Value::Object(found), Numbers::Exact);
}
