//! The nearest known word, for help texts.

/// The edits that a whole word of a longer key counts as.
const PART: usize = 2;

/// The known word that `word` most likely meant: few edits away, the last part of a dotted key, or the first or last words of a key.
pub fn nearest<'a>(word: &str, known: &'a [String]) -> Option<&'a str> {
    let last_part = |key: &'a str| key.rsplit('.').next().unwrap_or(key);
    let distance = |key: &'a str| {
        let whole = strsim::damerau_levenshtein(word, key);
        let is_part =
            |rest: Option<&str>| rest.is_some_and(|rest| rest.starts_with('_') || rest.ends_with('_'));
        let last = last_part(key);
        let part = is_part(last.strip_prefix(word)) || is_part(last.strip_suffix(word));
        let part = if part && !word.is_empty() { PART } else { usize::MAX };
        whole.min(1 + strsim::damerau_levenshtein(word, last)).min(part)
    };
    let (edits, key) = known.iter().map(|key| (distance(key), key.as_str())).min()?;
    (edits <= 1 + word.chars().count() / 3).then_some(key)
}

/// `did you mean …?` where a word is near, and the list of what is known.
pub fn did_you_mean(word: &str, known: &[String], what: &str) -> String {
    let list = known.join(", ");
    match nearest(word, known) {
        Some(near) => format!("did you mean `{near}`? {what}: {list}"),
        None if known.is_empty() => "there are none".to_owned(),
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
        assert_eq!(nearest("poisson", &known), Some("substrate.poisson_ratio"));
        assert_eq!(nearest("load", &known), Some("operation.normal_load"));
        assert_eq!(nearest("temperature", &known), None);
        assert_eq!(nearest("", &known), None);
    }
}
