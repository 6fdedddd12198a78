//! What `judder check` shows, as document and as text.

use serde_json::Value;

/// A checked case.
#[derive(Debug, Clone)]
pub struct Resolved {
    /// The document of `judder check --json`.
    pub document: Value,
    /// What `judder check` prints on a terminal.
    pub text: String,
}

impl Resolved {
    /// The document of `judder check --json`.
    #[must_use]
    pub fn json(&self) -> Value {
        self.document.clone()
    }

    /// What `judder check` prints on a terminal.
    #[must_use]
    pub fn text(&self) -> String {
        self.text.clone()
    }
}
