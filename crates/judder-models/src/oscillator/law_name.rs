//! The names of contact laws.

/// The contact law of an oscillator case.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum LawName {
    /// The paper's fits as printed.
    OscillatorPaper,
    /// The paper's fits on the corrected velocity axis.
    OscillatorPaperCorrected,
    /// The elastic closed form.
    Hertz,
    /// Computed for the case's own substrate by the boundary-element method.
    Bem,
    /// Computed earlier, from a file.
    File,
}

impl LawName {
    /// The laws that are words, with their names in a case file.
    pub const ALL: [(&'static str, Self); 4] = [
        ("oscillator-paper", Self::OscillatorPaper),
        ("oscillator-paper-corrected", Self::OscillatorPaperCorrected),
        ("hertz", Self::Hertz),
        ("bem", Self::Bem),
    ];

    /// The same words, each with what it means.
    pub(crate) const WORDS: [(&'static str, &'static str); 4] = [
        (Self::ALL[0].0, "the paper's fits as printed"),
        (Self::ALL[1].0, "the paper's fits on the corrected velocity axis"),
        (Self::ALL[2].0, "the elastic closed form"),
        (Self::ALL[3].0, "computed for the case's own substrate"),
    ];

    /// The name in a case file; `file` for `{ file = "law.json" }`.
    pub fn name(self) -> &'static str {
        Self::ALL.get(self as usize).map_or("file", |(name, _)| name)
    }

    /// Whether the law was fitted for one retardation time and E∞/E0 = 10.
    pub fn is_fitted(self) -> bool {
        matches!(self, Self::OscillatorPaper | Self::OscillatorPaperCorrected)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_stand_at_their_index() {
        assert!(LawName::ALL.iter().all(|(name, law)| law.name() == *name));
    }
}
