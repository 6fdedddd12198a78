//! The Python that follows from the declarations, compared with what stands in the package: the types of the models, and the keys of an oscillator.
//! `JUDDER_GOLDEN=write` writes it anew.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod keys;
mod models;
#[path = "../../src/signatures/mod.rs"]
mod signatures;

use serde_json::Value;
use std::path::Path;

/// Compares a module of the package with what it should be, or writes it.
fn check(module: &str, wanted: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../python/judder").join(module);
    if std::env::var("JUDDER_GOLDEN").is_ok_and(|mode| mode == "write") {
        std::fs::write(&path, wanted).unwrap();
    }
    let found = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(found == wanted, "{module} is not what the declarations say: JUDDER_GOLDEN=write writes it");
}

#[test]
fn the_golden_types_of_the_models_are_these() {
    check("models.pyi", &models::stub());
}

#[test]
fn what_python_is_told_has_every_key_with_its_words() {
    for class in signatures::classes() {
        let told = class.document();
        let methods = told["methods"].as_array().unwrap();
        for (own, told) in std::iter::once((&class, &told)).chain(class.methods.iter().zip(methods)) {
            let doc = told["doc"].as_str().unwrap();
            assert_eq!((doc, &told["of"]), (own.doc.as_str(), &Value::from(own.of.as_str())));
            for (parameter, told) in own.parameters.iter().zip(told["parameters"].as_array().unwrap()) {
                let is_told =
                    doc.lines().any(|line| line.trim_start().starts_with(&format!("{}: ", parameter.name)));
                assert!(is_told && told[1] == parameter.key.as_str(), "{}: {}", own.of, parameter.name);
            }
        }
    }
}

#[test]
fn the_golden_keys_of_an_oscillator_are_these() {
    check("_keys.py", &keys::module());
}
