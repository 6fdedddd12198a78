//! Names for content.

/// The BLAKE3 hash of some bytes, as 64 lower-case hexadecimal digits.
///
/// Same bytes, same hash, on every machine: for the hash of a case ([`Summary::case_hash`](crate::Summary::case_hash))
/// and of an analysis ([`AnalysisRecord::hash`](crate::AnalysisRecord::hash)). Hash a canonical form, so that a comment
/// or a change of order in the case file does not force a recomputation.
#[must_use]
pub fn content_hash(bytes: &[u8]) -> String {
    blake3::hash(bytes).to_hex().to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_hash_of_nothing_is_the_published_one() {
        assert_eq!(content_hash(b""), "af1349b9f5f9a1a6a0404dea36dcc9499bcb25c9adc112b7cc9a93cae41f3262");
    }
}
