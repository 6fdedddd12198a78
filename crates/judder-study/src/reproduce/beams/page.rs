//! The report of the beams paper.

use crate::error::StudyError;
use crate::pictures;
use crate::report::{case_section, check_rows, facts, warnings, write_figure, write_page};
use crate::reproduce::scoreboard::{self, ClaimLine};
use crate::reproduce::{KEY, is_done};
use crate::run::Keepsakes;
use judder_report::{Block, Page, Section};
use judder_store::{StudyFolder, Summary};
use serde_json::Value;
use std::path::PathBuf;

/// A figure of the paper by an analysis: heading, name of the figure, title, analysis.
struct Exhibit {
    heading: &'static str,
    name: &'static str,
    title: &'static str,
    analysis: &'static str,
}

const EXHIBITS: [Exhibit; 9] = [
    Exhibit {
        heading: "Fig. 2",
        name: "fig-2",
        title: "Locus of the pair as it lies undeformed",
        analysis: "locus",
    },
    Exhibit {
        heading: "",
        name: "fig-2-deformed",
        title: "Locus of the pair in steady sliding, deformed by its load",
        analysis: "locus-deformed",
    },
    Exhibit { heading: "Figs. 3 and 4", name: "fig-3-subs", title: "Subs", analysis: "subs" },
    Exhibit { heading: "", name: "fig-3-film", title: "FiLM", analysis: "film" },
    Exhibit { heading: "", name: "fig-4-subs", title: "Spectrogram of Subs", analysis: "spectrogram-subs" },
    Exhibit { heading: "", name: "fig-4-film", title: "Spectrogram of FiLM", analysis: "spectrogram-film" },
    Exhibit { heading: "Figs. 5 and 6", name: "fig-5", title: "EnSubs", analysis: "ensubs" },
    Exhibit {
        heading: "The reason, and a march of our own",
        name: "subs-static-slope",
        title: "Subs with the static slope put in",
        analysis: "subs-static-slope",
    },
    Exhibit {
        heading: "",
        name: "residual-flexibility",
        title: "The march with residual flexibility",
        analysis: "residual-flexibility",
    },
];

/// Draws every figure of the paper and the page.
pub(super) fn write(store: &StudyFolder, summary: &Summary) -> Result<PathBuf, StudyError> {
    let kept = Keepsakes::of(summary);
    let lines: Vec<ClaimLine> = summary
        .extra
        .get(KEY)
        .and_then(|own| serde_json::from_value(own.get("scoreboard")?.clone()).ok())
        .unwrap_or_default();
    let board = Block::Scoreboard(scoreboard::block(&lines, &[(0, "ours")]));
    let mut sections = vec![Section::new("Scoreboard", vec![Block::text(about_quick(summary)), board])];
    for exhibit in &EXHIBITS {
        if !is_done(summary, exhibit.analysis) {
            continue;
        }
        let dataset = store.read_dataset(exhibit.analysis)?;
        let Some(figure) = pictures::figure(exhibit.name, exhibit.title, &dataset) else { continue };
        let block = write_figure(store, figure)?;
        match sections.last_mut() {
            Some(section) if exhibit.heading.is_empty() => section.blocks.push(block),
            _ => sections.push(Section::new(exhibit.heading, vec![block])),
        }
    }
    sections.push(Section::new("Checks", vec![Block::Checks(check_rows(&kept.checks))]));
    sections.push(Section::new("Warnings", vec![Block::Warnings(warnings(summary))]));
    sections.push(case_section(summary, &kept));
    let page = Page {
        title: "The beams paper, recomputed".to_owned(),
        lead: lead(&lines, &kept),
        facts: facts(summary),
        sections,
    };
    write_page(store, &page)
}

/// What the marches cover.
fn about_quick(summary: &Summary) -> &'static str {
    if summary.extra.get(KEY).and_then(|own| own.get("quick")) == Some(&Value::Bool(true)) {
        "A quick run: loci over the whole path, marches over its last quarter."
    } else {
        "Loci and marches over the whole path."
    }
}

fn lead(lines: &[ClaimLine], kept: &Keepsakes) -> String {
    let count = |verdict: &str| lines.iter().filter(|line| line.verdict == verdict).count();
    let checks = kept.checks.values().flatten().count();
    let passed = kept.checks.values().flatten().filter(|check| check.passed()).count();
    format!(
        "Brunetti, D'Ambrogio and Fregolent, Dynamic substructuring with time variant coupling conditions for the analysis of friction induced \
         vibrations (2020): Figs. 2 to 6. Of {} claims {} agree, {} are open. {passed} of {checks} checks are within their limits.",
        lines.len(),
        count("agrees"),
        count("open")
    )
}
