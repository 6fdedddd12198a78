//! A folder of one's own in which `judder` is called.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use serde_json::Value;
use tempfile::TempDir;

/// An oscillator case with one analysis of each kind, small.
pub(crate) const CASE: &str = r#"
title = "A small case"
model = "oscillator"

[[analysis]]
name = "map"
kind = "stability-map"
x = { key = "operation.velocity", from = 1e-8, to = 1e2, points = 24, scale = "log" }
y = { key = "contact.shear_strength", from = 1e-4, to = 1.0, points = 20, scale = "log" }
boundaries = false

[[analysis]]
name = "loci"
kind = "spectrum"
sweep = { key = "contact.shear_strength", from = 1e-4, to = 1.0, points = 11, scale = "log" }

[[analysis]]
name = "damping"
kind = "equivalent-damping"
sweep = { key = "operation.velocity", from = 1e-5, to = 1e-2, points = 7, scale = "log" }

[[analysis]]
name = "strengths"
kind = "critical-shear-strength"
sweep = { key = "operation.velocity", from = 1e-5, to = 1e-2, points = 5, scale = "log" }
global_margin = false

[[analysis]]
name = "loads"
kind = "critical-load"
sweep = { key = "operation.velocity", from = 1e-5, to = 1e-2, points = 5, scale = "log" }
global_margin = false
"#;

/// The folder, removed at the end.
pub(crate) struct Desk(pub(crate) TempDir);

/// What a call of `judder` left on its streams.
pub(crate) struct Said {
    pub(crate) code: i32,
    pub(crate) stdout: String,
    pub(crate) stderr: String,
}

impl Desk {
    pub(crate) fn new() -> Self {
        Self(TempDir::new().unwrap())
    }

    /// A desk with a file `case.toml` on it.
    pub(crate) fn with_case(text: &str) -> Self {
        let desk = Self::new();
        desk.write("case.toml", text);
        desk
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    pub(crate) fn write(&self, name: &str, content: impl AsRef<[u8]>) {
        fs::write(self.path(name), content).unwrap();
    }

    /// `judder` with these arguments, with the desk as its folder and no word about colours.
    pub(crate) fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_judder"));
        command.args(arguments).current_dir(self.0.path());
        for variable in ["NO_COLOR", "CLICOLOR", "CLICOLOR_FORCE"] {
            command.env_remove(variable);
        }
        command
    }

    pub(crate) fn judder(&self, arguments: &[&str]) -> Said {
        Said::of(self.command(arguments).output().unwrap())
    }

    /// Calls `judder`, which must end well.
    pub(crate) fn succeed(&self, arguments: &[&str]) -> Said {
        let said = self.judder(arguments);
        assert_eq!(said.code, 0, "judder {arguments:?}: {}", said.stderr);
        said
    }

    /// Calls `judder`, which must refuse with exit code 2, say this, and leave the desk as it was.
    pub(crate) fn refused(&self, arguments: &[&str], message: &str, help: &str) {
        let before = self.files();
        let said = self.judder(arguments);
        assert_eq!(said.code, 2, "judder {arguments:?}: {}", said.stderr);
        assert_eq!(said.stdout, "", "judder {arguments:?}");
        said.says(message);
        said.says(help);
        assert_eq!(self.files(), before, "judder {arguments:?} must leave nothing");
    }

    /// The paths of everything on the desk, sorted.
    pub(crate) fn files(&self) -> Vec<PathBuf> {
        files_below(self.0.path())
    }

    /// A JSON file on the desk.
    pub(crate) fn read_json(&self, name: &str) -> Value {
        serde_json::from_slice(&fs::read(self.path(name)).unwrap()).unwrap()
    }
}

impl Said {
    pub(crate) fn of(output: Output) -> Self {
        Self {
            code: output.status.code().expect("judder ends by itself"),
            stdout: String::from_utf8(output.stdout).unwrap(),
            stderr: String::from_utf8(output.stderr).unwrap(),
        }
    }

    /// Checks that standard error holds these words.
    pub(crate) fn says(&self, words: &str) {
        assert!(self.stderr.contains(words), "{words:?} is not in\n{}", self.stderr);
    }

    /// The one document on standard output.
    pub(crate) fn json(&self) -> Value {
        serde_json::from_str(&self.stdout).expect("standard output is one JSON document")
    }
}

/// The paths of everything below a folder, sorted.
pub(crate) fn files_below(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files.extend(files_below(&path));
        }
        files.push(path);
    }
    files.sort();
    files
}
