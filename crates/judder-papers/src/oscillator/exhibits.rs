//! The figures of the paper: which case makes which panel.

use judder_keys::numeric_key::{Form, Value};
use judder_keys::span::Span;
use judder_models::contact::case::ContactCase;
use judder_models::contact::settings::{FitSettings, LawMethod, LawSettings};
use judder_models::contact::shape::ShapeSettings;
use judder_models::motion::MotionAnalysis;
use judder_models::motion::bifurcation::Bifurcation;
use judder_models::motion::history::HistoryAnalysis;
use judder_models::motion::limit_cycle::LimitCycle;
use judder_models::oscillator::case::OscillatorCase;
use judder_models::oscillator::engines::settings::EnginesSettings;
use judder_models::oscillator::keys::OscillatorKey;
use judder_models::oscillator::settings::{CriticalThresholds, DampingCurves, SpectrumCurves};
use judder_models::sweep::StabilityMapAnalysis;
use judder_study::model::Case;

/// A figure of the paper.
pub(super) struct Exhibit {
    /// File stem.
    pub(super) name: &'static str,
    /// What it shows, and the number that it has in the paper.
    pub(super) title: &'static str,
    /// What stands under it.
    pub(super) caption: &'static str,
    /// The cases that make its panels.
    pub(super) sources: &'static [PanelSource],
}

/// A panel of the paper: a case with a few keys set on top.
pub(super) struct PanelSource {
    /// Beginning of the names of its analyses.
    pub(super) name: &'static str,
    /// Name of the case.
    pub(super) case_name: &'static str,
    /// Text of the case.
    pub(super) case: &'static str,
    /// What is set on top of it.
    pub(super) overrides: &'static [&'static str],
    /// Panel heading; empty where the figure has one panel in the paper.
    pub(super) label: &'static str,
}

macro_rules! case {
    ($file:literal) => {
        include_str!(concat!("../../cases/", $file, ".toml"))
    };
}

pub(super) use case;

const fn source(name: &'static str, case: &'static str, label: &'static str) -> PanelSource {
    PanelSource { name, case_name: name, case, overrides: &[], label }
}

const fn fig_4(name: &'static str, overrides: &'static [&'static str], label: &'static str) -> PanelSource {
    PanelSource { name, case_name: "fig-4", case: case!("fig-4"), overrides, label }
}

/// The contact computation, Figs. 3, 13 and 14: names and texts of the cases. The first leaves the law that the others use.
pub(super) const CONTACT_CASES: [(&str, &str); 3] =
    [(LAW, case!("fig-3")), (MODULUS, case!("fig-13")), (FIT, case!("fig-14"))];
/// Fig. 3: the computed law.
pub(super) const LAW: &str = "fig-3";
/// Fig. 13: the material.
pub(super) const MODULUS: &str = "fig-13";
/// Fig. 14: the fit.
pub(super) const FIT: &str = "fig-14";
/// The file in the study folder in which Fig. 3 leaves its law: that of its analysis.
pub(super) const LAW_FILE: &str = "law.json";

/// Figs. 4 to 10.
pub(super) const EXHIBITS: [Exhibit; 7] = [
    Exhibit {
        name: "fig-4",
        title: "Equivalent damping over speed, the paper's Fig. 4",
        caption: "Equivalent damping $ξ_{eq}$, eq. (23), over the substrate velocity for four loads and four shear strengths. The vertical \
                  axis is logarithmic on both sides of zero.",
        sources: &[
            fig_4("fig-4a", &["operation.normal_load=7.5e-2"], "$F̃_{n}$ = 7.5 × 10^{−2}"),
            fig_4("fig-4b", &["operation.normal_load=7.5e-3"], "$F̃_{n}$ = 7.5 × 10^{−3}"),
            fig_4("fig-4c", &["operation.normal_load=7.5e-4"], "$F̃_{n}$ = 7.5 × 10^{−4}"),
            fig_4("fig-4d", &["operation.normal_load=7.5e-5"], "$F̃_{n}$ = 7.5 × 10^{−5}"),
        ],
    },
    Exhibit {
        name: "fig-5",
        title: "Eigenvalues over the shear strength, the paper's Fig. 5",
        caption: "Eigenvalues at $v̂_{d}$ = 10^{−4}, $F̃_{n}$ = 7.5 × 10^{−6}. The paper shows the system without damping (dashed).",
        sources: &[source("fig-5", case!("fig-5"), "")],
    },
    Exhibit {
        name: "fig-6",
        title: "Eigenvalues over the normal load, the paper's Fig. 6",
        caption: "Eigenvalues at $v̂_{d}$ = 1.58 × 10^{−4}, $τ̃_{0}$ = 0.01. The paper shows the system without damping (dashed).",
        sources: &[source("fig-6", case!("fig-6"), "")],
    },
    Exhibit {
        name: "fig-7",
        title: "Critical shear strength over speed, the paper's Fig. 7",
        caption: "All thresholds of the shear strength for five loads. Dashed: without damping, eq. (27) made self-consistent, as in the paper. \
                  Solid: the full, damped system.",
        sources: &[source("fig-7", case!("fig-7"), "")],
    },
    Exhibit {
        name: "fig-8",
        title: "Critical load over speed, the paper's Fig. 8",
        caption: "All thresholds of the load for three shear strengths. Dashed: without damping, eq. (28) made self-consistent, as in the \
                  paper. Solid: the full, damped system.",
        sources: &[source("fig-8", case!("fig-8"), "")],
    },
    Exhibit {
        name: "fig-9",
        title: "Stability over speed and shear strength, the paper's Fig. 9",
        caption: "Stability of steady sliding; the colour is the mechanism. Solid black: boundary of the full system. Dashed: without damping. \
                  Red: full system with $η = 0$.",
        sources: &[
            source("fig-9a", case!("fig-9a"), "9a, $F̃_{n}$ = 10^{−6}"),
            source("fig-9b", case!("fig-9b"), "9b, $F̃_{n}$ = 10^{−3}"),
        ],
    },
    Exhibit {
        name: "fig-10",
        title: "Stability over speed and load, the paper's Fig. 10",
        caption: "Stability of steady sliding; the colour is the mechanism. Solid black: boundary of the full system. Dashed: without damping. \
                  Red: full system with $η = 0$.",
        sources: &[
            source("fig-10a", case!("fig-10a"), "10a, $τ̃_{0}$ = 10^{−2}"),
            source("fig-10b", case!("fig-10b"), "10b, $τ̃_{0}$ = 10^{−1}"),
        ],
    },
];

/// Fewer points for a quick look: curves and maps keep their shape, a paraboloid's law stands for the sphere's.
pub(super) fn thin_out(case: &mut Case) {
    if let Some(case) = case.of_mut() {
        thin_out_oscillator(case);
    } else if let Some(case) = case.of_mut() {
        thin_out_contact(case);
    }
}

/// A law that is one curve, on a coarse plane.
fn thin_out_contact(case: &mut ContactCase) {
    const SPEEDS: usize = 17;
    const DEPTHS: usize = 7;
    for analysis in &mut case.analyses {
        let thin_out_law = |law: &mut LawSettings| {
            law.method = LawMethod::Collapse;
            law.velocity.points = law.velocity.points.min(SPEEDS);
            law.indentation.points = law.indentation.points.min(DEPTHS);
        };
        if let Some(law) = analysis.settings_mut() {
            thin_out_law(law);
        } else if let Some(fit) = analysis.settings_mut::<FitSettings>() {
            thin_out_law(&mut fit.law);
        } else {
            continue;
        }
        case.shape = ShapeSettings::Paraboloid;
    }
}

fn thin_out_oscillator(case: &mut OscillatorCase) {
    const CURVE: usize = 301;
    const THRESHOLDS: usize = 101;
    const MAP: usize = 400;
    const CYCLE: f64 = 2000.0;
    for analysis in &mut case.analyses {
        if let Some(DampingCurves { sweep, .. }) = analysis.settings_mut() {
            sweep.points = sweep.points.min(CURVE);
        } else if let Some(SpectrumCurves { sweep, .. }) = analysis.settings_mut() {
            sweep.points = sweep.points.min(CURVE);
        } else if let Some(CriticalThresholds { sweep, .. }) = analysis.settings_mut() {
            sweep.points = sweep.points.min(THRESHOLDS);
        } else if let Some(map) = analysis.settings_mut::<StabilityMapAnalysis<OscillatorKey>>() {
            map.x.points = map.x.points.min(MAP);
            map.y.points = map.y.points.min(MAP);
        } else if let Some(MotionAnalysis(diagram)) = analysis.settings_mut() {
            thin_out_diagram(diagram);
        } else if let Some(MotionAnalysis(history)) = analysis.settings_mut() {
            thin_out_history(history);
        } else if let Some(MotionAnalysis(LimitCycle { duration, .. })) = analysis.settings_mut() {
            duration.number = duration.number.min(CYCLE);
        } else if let Some(settings) = analysis.settings_mut() {
            thin_out_engines(settings);
        }
    }
}

/// Fewer motions, and shorter ones.
fn thin_out_diagram(Bifurcation { sweep, diagram }: &mut Bifurcation<OscillatorKey>) {
    const POINTS: usize = 14;
    const SETTLING: f64 = 1500.0;
    sweep.points = sweep.points.min(POINTS);
    shorten(&mut diagram.duration, &mut diagram.transient, SETTLING);
}

/// A shorter motion, as dense as before.
fn thin_out_history(history: &mut HistoryAnalysis) {
    const LONGEST: f64 = 1000.0;
    let longer = history.duration.number;
    shorten(&mut history.duration, &mut history.transient, LONGEST);
    history.points = (history.points as f64 * history.duration.number / longer) as usize;
}

/// A time of no more than this, in radians, and its part that averages leave out.
fn shorten(duration: &mut Value, transient: &mut Value, longest: f64) {
    if duration.form == Form::Group && duration.number > longest {
        transient.number *= longest / duration.number;
        duration.number = longest;
    }
}

/// As many steps and widths as an order takes; a tolerance that is still far below their errors.
fn thin_out_engines(settings: &mut EnginesSettings) {
    settings.tolerance = 1e-8;
    settings.time_step = Span { from: 1.25e-3, to: 5e-3, points: 3, ..settings.time_step };
    settings.width = Span { from: 2e-4, to: 2e-3, points: 3, ..settings.width };
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::oscillator::evidence::law_of;

    #[test]
    fn a_quick_run_takes_one_curve_on_a_coarse_plane() {
        for name in [LAW, FIT] {
            let (_, text) = CONTACT_CASES.into_iter().find(|(known, _)| *known == name).unwrap();
            let mut case = judder_models::parse(name, text, &[]).unwrap().case;
            let held = case.clone();
            let full = case.resolved();
            thin_out(&mut case);
            assert_ne!(case.resolved(), full, "a quick result must not pass for a full one");
            assert_eq!(held.resolved(), full, "what others hold of it stays");
            let Some(case) = case.of::<ContactCase>() else { panic!("{name}") };
            let law = law_of(&case.analyses[0]).unwrap();
            assert_eq!((&case.shape, law.method), (&ShapeSettings::Paraboloid, LawMethod::Collapse));
            assert!(law.velocity.points * law.indentation.points < 200);
        }
    }
}
