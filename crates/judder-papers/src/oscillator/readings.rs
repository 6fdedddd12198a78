//! The ways in which the paper can be read, side by side, and the law computed anew.

use judder_contact::{FittedLaw, Law};
use judder_oscillator::{Contact, FrictionLoad};

/// The contact law of a reading.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum ReadLaw {
    /// The fits as printed.
    Printed,
    /// The fits with the corrected velocity axis.
    Corrected,
    /// That of Fig. 3, computed for the paper's sphere.
    Computed,
}

impl ReadLaw {
    /// The law of a case file; a computed one is put in place of the case's own.
    pub(super) fn key(self) -> &'static str {
        match self {
            Self::Printed => "oscillator-paper",
            Self::Corrected => "oscillator-paper-corrected",
            Self::Computed => "bem",
        }
    }
}

/// One reading: which contact law, which load carries the viscoelastic friction.
pub(super) struct Reading {
    /// Ending of names.
    pub(super) slug: &'static str,
    /// The contact law.
    pub(super) law: ReadLaw,
    /// The friction load of the case file.
    pub(super) friction_load: &'static str,
    /// Head of a column or a panel, in the markup of the figures.
    pub(super) label: &'static str,
    /// The same without markup.
    pub(super) plain: &'static str,
}

/// As printed with either load, then both with the corrected velocity axis, then both with the computed law.
pub(super) const READINGS: [Reading; 6] = [
    Reading {
        slug: "normal-load",
        law: ReadLaw::Printed,
        friction_load: "normal-load",
        label: "printed law, $F_{n} μ_{visc}$",
        plain: "printed, F_n μ",
    },
    Reading {
        slug: "contact-force",
        law: ReadLaw::Printed,
        friction_load: "contact-force",
        label: "printed law, $F_{k} μ_{visc}$",
        plain: "printed, F_k μ",
    },
    Reading {
        slug: "corrected-normal-load",
        law: ReadLaw::Corrected,
        friction_load: "normal-load",
        label: "corrected axis, $F_{n} μ_{visc}$",
        plain: "corrected, F_n μ",
    },
    Reading {
        slug: "corrected-contact-force",
        law: ReadLaw::Corrected,
        friction_load: "contact-force",
        label: "corrected axis, $F_{k} μ_{visc}$",
        plain: "corrected, F_k μ",
    },
    Reading {
        slug: "computed-normal-load",
        law: ReadLaw::Computed,
        friction_load: "normal-load",
        label: "computed law, $F_{n} μ_{visc}$",
        plain: "computed, F_n μ",
    },
    Reading {
        slug: "computed-contact-force",
        law: ReadLaw::Computed,
        friction_load: "contact-force",
        label: "computed law, $F_{k} μ_{visc}$",
        plain: "computed, F_k μ",
    },
];

impl Reading {
    /// The contact of this reading.
    pub(super) fn contact(&self, computed: &Law) -> Contact {
        let law = match self.law {
            ReadLaw::Printed => Law::Fitted(FittedLaw::oscillator_paper()),
            ReadLaw::Corrected => Law::Fitted(FittedLaw::oscillator_paper_corrected()),
            ReadLaw::Computed => computed.clone(),
        };
        let friction_load = if self.friction_load == "normal-load" {
            FrictionLoad::NormalLoad
        } else {
            FrictionLoad::ContactForce
        };
        Contact { law, friction_load }
    }
}
