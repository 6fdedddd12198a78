//! Which names may become folders of the store and columns of a notebook.

use crate::StoreError;

/// Refuses a name that could not be a file name everywhere, or that Zarr keeps for itself.
///
/// `what` says what is named with its article (`an analysis`, `a variable`), for the error.
pub(crate) fn check_name(what: &'static str, name: &str) -> Result<(), StoreError> {
    let plain = |c: char| c.is_ascii_alphanumeric() || matches!(c, '.' | '_' | '-');
    let reserved = name.starts_with('.') || name.starts_with("__") || name == "zarr.json";
    if name.is_empty() || name.len() > 200 || reserved || !name.chars().all(plain) {
        return Err(StoreError::InvalidName { what, name: name.to_owned() });
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_safe_as_file_names() {
        for good in ["map", "fig9.a", "critical-load_2", "9a"] {
            check_name("an analysis", good).unwrap();
        }
        for bad in ["", ".", "..", ".hidden", "a/b", "a b", "zarr.json", "__x", "ξ", "a\0", &"x".repeat(201)]
        {
            check_name("an analysis", bad).unwrap_err();
        }
    }
}
