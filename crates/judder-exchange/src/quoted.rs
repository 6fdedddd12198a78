//! Words of a file in messages.

/// Characters of a word that a message repeats: a damaged file can have words of any length.
const QUOTED: usize = 40;

/// A word of a file, cut where it is long.
pub(crate) fn quoted(word: &str) -> String {
    match word.char_indices().nth(QUOTED) {
        Some((end, _)) => format!("{}…", &word[..end]),
        None => word.to_owned(),
    }
}
