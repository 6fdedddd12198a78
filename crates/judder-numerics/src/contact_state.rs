//! Stick, slip and lift-off: one set of states with one set of numbers, of every model and in every result.

use serde::{Deserialize, Serialize};
use std::fmt;

/// What a body does on the one along which it slides.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum ContactState {
    /// It moves with the other.
    Stick,
    /// It slides as in steady sliding; an indenter lags behind its substrate, v_rel < 0.
    SlipBehind,
    /// It slides the other way; an indenter runs ahead of its substrate, v_rel > 0.
    SlipAhead,
    /// It has left the other.
    LiftOff,
}

impl ContactState {
    /// All of them, in the order of their numbers in stored results.
    pub const ALL: [Self; 4] = [Self::Stick, Self::SlipBehind, Self::SlipAhead, Self::LiftOff];

    /// Their numbers in stored results, each with its name.
    pub const CODES: [(u8, &'static str); 4] = {
        let mut codes = [(0, ""); 4];
        let mut place = 0;
        while place < codes.len() {
            codes[place] = (Self::ALL[place].number(), Self::ALL[place].name());
            place += 1;
        }
        codes
    };

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

    /// Its name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Stick => "stick",
            Self::SlipBehind => "slip",
            Self::SlipAhead => "slip ahead",
            Self::LiftOff => "lift-off",
        }
    }

    /// The place in [`ContactState::ALL`].
    #[must_use]
    pub const fn number(self) -> u8 {
        self as u8
    }
}

impl fmt::Display for ContactState {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
