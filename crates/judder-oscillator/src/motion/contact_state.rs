//! Stick, slip and lift-off.

use std::fmt;

/// What the indenter does on the substrate.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ContactState {
    /// It moves with the substrate.
    Stick,
    /// It slides and lags behind the substrate (v_rel < 0), as in steady sliding.
    SlipBehind,
    /// It slides ahead of the substrate (v_rel > 0).
    SlipAhead,
    /// It has left the substrate.
    LiftOff,
}

impl ContactState {
    /// All of them, in the order of their numbers in stored results.
    pub const ALL: [Self; 4] = [Self::Stick, Self::SlipBehind, Self::SlipAhead, Self::LiftOff];

    /// The sign of v_rel: −1 behind, 1 ahead, 0 where nothing slides.
    #[inline(always)]
    #[must_use]
    pub fn direction(self) -> f64 {
        match self {
            Self::SlipBehind => -1.0,
            Self::SlipAhead => 1.0,
            Self::Stick | Self::LiftOff => 0.0,
        }
    }

    /// The place in [`ContactState::ALL`].
    #[must_use]
    pub fn number(self) -> u8 {
        self as u8
    }
}

impl fmt::Display for ContactState {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Stick => "stick",
            Self::SlipBehind => "slip",
            Self::SlipAhead => "slip ahead",
            Self::LiftOff => "lift-off",
        })
    }
}
