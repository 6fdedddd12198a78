//! The secret of a session: who knows it may come in.

use crate::error::ExplorerError;
use std::fmt;
use subtle::ConstantTimeEq;

/// Bytes of a secret: nobody guesses 256 bits.
const BYTES: usize = 32;

/// A random word, compared in constant time, and never printed by accident.
#[derive(Clone)]
pub(crate) struct Secret(String);

impl fmt::Debug for Secret {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str("Secret(…)")
    }
}

impl Secret {
    /// A new secret, in hexadecimal digits, from the system's source of randomness.
    pub(crate) fn new() -> Result<Self, ExplorerError> {
        let mut bytes = [0; BYTES];
        getrandom::fill(&mut bytes)
            .map_err(|source| ExplorerError::NoRandomness { reason: source.to_string() })?;
        Ok(Self(bytes.iter().map(|byte| format!("{byte:02x}")).collect()))
    }

    /// The word.
    pub(crate) fn word(&self) -> &str {
        &self.0
    }

    /// Whether somebody knows it.
    pub(crate) fn is(&self, word: &str) -> bool {
        self.0.as_bytes().ct_eq(word.as_bytes()).into()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn secrets_differ_and_know_themselves() {
        let (one, other) = (Secret::new().unwrap(), Secret::new().unwrap());
        assert!(one.is(one.word()) && !one.is(other.word()));
        assert!(!one.is("") && !one.is(&one.word()[1..]) && !one.is(&format!("{}0", one.word())));
        assert_eq!(one.word().len(), 2 * BYTES);
        assert_eq!(format!("{one:?}"), "Secret(…)");
    }
}
