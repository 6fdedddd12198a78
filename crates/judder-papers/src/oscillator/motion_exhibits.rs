//! Section 5: the motions of Figs. 11 and 12, with both speeds that the paper gives and both loads that friction can act on,
//! and one cycle by three engines.

use super::exhibits::case;
use judder_contact::{FittedLaw, Law};
use judder_oscillator::{Contact, FrictionLoad};

/// F̃_n of section 5.
pub(super) const LOAD: f64 = 7.5e-4;
/// τ̃0 of the two motions of Fig. 12.
pub(super) const STRENGTHS: [f64; 2] = [1e-4, 5e-2];

/// One way to read section 5: a speed and a friction load, with the printed law.
pub(super) struct ReadingWay {
    /// Ending of names.
    pub(super) slug: &'static str,
    /// v̂_d.
    pub(super) velocity: f64,
    /// What is set on top of a case.
    overrides: [&'static str; 2],
    /// The load that carries the viscoelastic friction.
    friction_load: FrictionLoad,
    /// Head of a column or a panel, in the markup of the figures.
    pub(super) label: &'static str,
    /// The same without markup.
    pub(super) plain: &'static str,
}

/// The captions' ṽ_d = 5e-3, which is v̂_d = ṽ_d τ̃/R̃ = 4e-4, with either load; then the text's v̂_d = 5e-3.
pub(super) const WAYS: [ReadingWay; 4] = [
    ReadingWay {
        slug: "captions-normal-load",
        velocity: 4e-4,
        overrides: ["operation.velocity=4e-4", "contact.friction_load=normal-load"],
        friction_load: FrictionLoad::NormalLoad,
        label: "$ṽ_{d}$ = 5 × 10^{−3}, $F_{n} μ_{visc}$",
        plain: "ṽ_d = 5e-3, F_n μ",
    },
    ReadingWay {
        slug: "captions-contact-force",
        velocity: 4e-4,
        overrides: ["operation.velocity=4e-4", "contact.friction_load=contact-force"],
        friction_load: FrictionLoad::ContactForce,
        label: "$ṽ_{d}$ = 5 × 10^{−3}, $F_{k} μ_{visc}$",
        plain: "ṽ_d = 5e-3, F_k μ",
    },
    ReadingWay {
        slug: "text-normal-load",
        velocity: 5e-3,
        overrides: ["operation.velocity=5e-3", "contact.friction_load=normal-load"],
        friction_load: FrictionLoad::NormalLoad,
        label: "$v̂_{d}$ = 5 × 10^{−3}, $F_{n} μ_{visc}$",
        plain: "v̂_d = 5e-3, F_n μ",
    },
    ReadingWay {
        slug: "text-contact-force",
        velocity: 5e-3,
        overrides: ["operation.velocity=5e-3", "contact.friction_load=contact-force"],
        friction_load: FrictionLoad::ContactForce,
        label: "$v̂_{d}$ = 5 × 10^{−3}, $F_{k} μ_{visc}$",
        plain: "v̂_d = 5e-3, F_k μ",
    },
];
/// The ways with the captions' speed stand first.
pub(super) const OF_CAPTIONS: usize = 2;

impl ReadingWay {
    /// The contact of this way.
    pub(super) fn contact(&self) -> Contact {
        Contact { law: Law::Fitted(FittedLaw::oscillator_paper()), friction_load: self.friction_load }
    }
}

/// What is computed with a way.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum ComputedPart {
    /// Fig. 11.
    Diagram,
    /// Fig. 12 at τ̃0 = 1e-4.
    Weak,
    /// Fig. 12 at τ̃0 = 5e-2.
    Strong,
    /// The cycle beside the motion of τ̃0 = 5e-2.
    Cycle,
}

impl ComputedPart {
    const ALL: [Self; 4] = [Self::Diagram, Self::Weak, Self::Strong, Self::Cycle];

    /// Beginning of names; case, its analysis, and what is set on top of it.
    fn source(self) -> (&'static str, &'static str, usize, &'static [&'static str]) {
        match self {
            Self::Diagram => ("fig-11", "fig-11", 0, &[]),
            Self::Weak => ("fig-12-weak", "fig-12", 0, &["contact.shear_strength=1e-4"]),
            Self::Strong => ("fig-12-strong", "fig-12", 0, &["contact.shear_strength=5e-2"]),
            Self::Cycle => ("fig-12-cycle", "fig-12", 1, &["contact.shear_strength=5e-2"]),
        }
    }

    /// The name of what is kept of it.
    pub(super) fn name(self, way: &ReadingWay) -> String {
        format!("{}-{}", self.source().0, way.slug)
    }
}

/// The comparison of the engines.
pub(super) const ENGINES: &str = "engines";

/// The cases of section 5.
pub(super) const MOTION_CASES: [(&str, &str); 3] =
    [("fig-11", case!("fig-11")), ("fig-12", case!("fig-12")), (ENGINES, case!("engines"))];

/// A case to run: its name and text, which of its analyses, under which name, and what is set on top of it.
pub(super) struct MotionRun {
    pub(super) name: String,
    pub(super) case_name: &'static str,
    pub(super) case: &'static str,
    pub(super) analysis: usize,
    pub(super) overrides: Vec<String>,
}

/// Everything that section 5 takes. Cycles are sought with the captions' speed only.
pub(super) fn runs() -> Vec<MotionRun> {
    let mut runs = Vec::new();
    for (case_name, case) in MOTION_CASES {
        for (index, way) in WAYS.iter().enumerate() {
            for part in ComputedPart::ALL.into_iter().filter(|part| part.source().1 == case_name) {
                if part == ComputedPart::Cycle && index >= OF_CAPTIONS {
                    continue;
                }
                let (_, _, analysis, on_top) = part.source();
                let overrides = on_top.iter().chain(&way.overrides).map(|o| (*o).to_owned()).collect();
                runs.push(MotionRun { name: part.name(way), case_name, case, analysis, overrides });
            }
        }
        if case_name == ENGINES {
            let (name, overrides) = (ENGINES.to_owned(), Vec::new());
            runs.push(MotionRun { name, case_name, case, analysis: 0, overrides });
        }
    }
    runs
}
