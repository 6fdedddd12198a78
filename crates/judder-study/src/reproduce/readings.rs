//! The ways in which the paper can be read, side by side.

use judder_contact::{FittedLaw, Law};
use judder_oscillator::{Contact, FrictionLoad};

/// One reading: which velocity axis of the fits, which load carries the viscoelastic friction.
pub(super) struct Reading {
    /// Ending of names.
    pub(super) slug: &'static str,
    /// The law of the case file.
    pub(super) law: &'static str,
    /// The friction load of the case file.
    pub(super) friction_load: &'static str,
    /// Head of a column or a panel, in the markup of the figures.
    pub(super) label: &'static str,
    /// The same without markup.
    pub(super) plain: &'static str,
}

/// As printed with either load, then both with the corrected velocity axis.
pub(super) const READINGS: [Reading; 4] = [
    Reading {
        slug: "normal-load",
        law: "oscillator-paper",
        friction_load: "normal-load",
        label: "printed law, $F_{n} μ_{visc}$",
        plain: "printed, F_n μ",
    },
    Reading {
        slug: "contact-force",
        law: "oscillator-paper",
        friction_load: "contact-force",
        label: "printed law, $F_{k} μ_{visc}$",
        plain: "printed, F_k μ",
    },
    Reading {
        slug: "corrected-normal-load",
        law: "oscillator-paper-corrected",
        friction_load: "normal-load",
        label: "corrected axis, $F_{n} μ_{visc}$",
        plain: "corrected, F_n μ",
    },
    Reading {
        slug: "corrected-contact-force",
        law: "oscillator-paper-corrected",
        friction_load: "contact-force",
        label: "corrected axis, $F_{k} μ_{visc}$",
        plain: "corrected, F_k μ",
    },
];

impl Reading {
    /// The contact of this reading.
    pub(super) fn contact(&self) -> Contact {
        let law = if self.law == "oscillator-paper" {
            FittedLaw::oscillator_paper()
        } else {
            FittedLaw::oscillator_paper_corrected()
        };
        let friction_load = if self.friction_load == "normal-load" {
            FrictionLoad::NormalLoad
        } else {
            FrictionLoad::ContactForce
        };
        Contact { law: Law::Fitted(law), friction_load }
    }
}
