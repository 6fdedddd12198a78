//! The Python that follows from the declarations, compared with what stands in the package: the classes of the models, a method a kind of analysis, and
//! the keys of an oscillator. `JUDDER_GOLDEN=write` writes it anew.

mod annotation;
mod key;
mod keys;
mod model;

use super::workspace;

/// The package.
const PACKAGE: &str = "python/judder";

/// Compares a module of the package with what it should be, or writes it.
fn check(module: &str, wanted: &str) {
    let path = workspace(PACKAGE).join(module);
    if std::env::var("JUDDER_GOLDEN").is_ok_and(|mode| mode == "write") {
        std::fs::write(&path, wanted).unwrap();
    }
    let found = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(
        found == wanted,
        "{PACKAGE}/{module} is not what the declarations say: JUDDER_GOLDEN=write writes it"
    );
}

#[test]
fn the_models_of_the_python_package() {
    check("models.py", &model::module());
}

#[test]
fn the_keys_of_the_python_package() {
    check("_keys.py", &keys::module());
}
