//! The nearest known word, for help texts.

/// The known word that `word` most likely meant: few edits away, or the last part of a dotted key.
pub(crate) fn nearest<'a>(word: &str, known: &'a [String]) -> Option<&'a str> {
    let last_part = |key: &'a str| key.rsplit('.').next().unwrap_or(key);
    let distance = |key: &'a str| {
        let whole = strsim::damerau_levenshtein(word, key);
        whole.min(1 + strsim::damerau_levenshtein(word, last_part(key)))
    };
    let (edits, key) = known.iter().map(|key| (distance(key), key.as_str())).min()?;
    (edits <= 1 + word.chars().count() / 3).then_some(key)
}

/// `did you mean …?` where a word is near, and the list of what is known.
pub(crate) fn did_you_mean(word: &str, known: &[String], what: &str) -> String {
    let list = known.join(", ");
    match nearest(word, known) {
        Some(near) => format!("did you mean `{near}`? {what}: {list}"),
        None => format!("{what}: {list}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn near_words_are_found_and_far_ones_are_not() {
        let known =
            ["operation.velocity", "operation.normal_load", "substrate.poisson_ratio"].map(String::from);
        assert_eq!(nearest("operation.velocty", &known), Some("operation.velocity"));
        assert_eq!(nearest("velocity", &known), Some("operation.velocity"));
        assert_eq!(nearest("temperature", &known), None);
        assert_eq!(nearest("", &known), None);
    }
}
