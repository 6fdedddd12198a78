//! Declared keys by their dotted paths.

use super::{Allowed, Declaration};

/// A key by its dotted path, in which `*` stands for an item of a list or a name.
#[derive(Debug, Clone)]
pub struct Listed {
    /// The path.
    pub path: String,
    /// What is said of it.
    pub key: Declaration,
}

/// All of these keys, and those of their tables.
pub fn listed(prefix: &str, keys: &[Declaration]) -> Vec<Listed> {
    let of_key = |key: &Declaration| {
        let path = format!("{prefix}{}", key.name);
        let of_each = if matches!(key.form, Allowed::List { .. } | Allowed::Named(_)) { "*." } else { "" };
        let mut all = vec![Listed { path: path.clone(), key: key.clone() }];
        // of several tables that a key may be, the keys of each; one that more than one has is one
        for form in key.form.alternatives() {
            let below = listed(&format!("{path}.{of_each}"), form.keys());
            let is_new = |own: &Listed| !all.iter().any(|there| there.path == own.path);
            let new: Vec<Listed> = below.into_iter().filter(is_new).collect();
            all.extend(new);
        }
        all
    };
    keys.iter().flat_map(of_key).collect()
}

impl Listed {
    /// Whether it is a number, with a unit or without, that is no count.
    pub fn is_number(&self) -> bool {
        matches!(self.key.form, Allowed::Number(_) | Allowed::Scaled(_) | Allowed::Expressed(_))
    }

    /// The words that it may be, among other things.
    pub fn words(&self) -> Vec<&'static str> {
        let words = self.key.form.alternatives().iter().map(|form| match form {
            Allowed::Choice { words } => *words,
            _ => &[],
        });
        words.flatten().map(|(word, _)| *word).collect()
    }

    /// Whether it names a file.
    pub fn is_file(&self) -> bool {
        matches!(self.key.form, Allowed::File)
    }
}
