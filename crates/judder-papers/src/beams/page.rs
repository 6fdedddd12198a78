//! The report of the beams paper.

use super::figures::{self, SIGNAL};
use super::found::StoredResults;
use super::passage::passages;
use crate::claim::{self, ClaimLine};
use crate::drawn::{StoredAnalysis, block, made};
use crate::summary::{KEY, tally};
use judder_report::{Figure, Page, PageBlock, PageSection};
use judder_store::{StudyFolder, Summary};
use judder_study::StudyError;
use judder_study::ledger::Keepsakes;
use judder_study::pictures::StoredArrays;
use judder_study::report::{
    WrittenPage, case_section, check_rows, facts, figure_blocks, warnings, write_page,
};
use serde_json::Value;

/// Draws every figure of the paper and the page.
pub(crate) fn write(store: &StudyFolder, summary: &Summary) -> Result<WrittenPage, StudyError> {
    let kept = Keepsakes::of(summary);
    let lines: Vec<ClaimLine> = summary
        .extra
        .get(KEY)
        .and_then(|own| serde_json::from_value(own.get("scoreboard")?.clone()).ok())
        .unwrap_or_default();
    let board = PageBlock::Scoreboard(claim::block(&lines, &[(0, "We find")], 1));
    let mut sections =
        vec![PageSection::new("Scoreboard", vec![PageBlock::text(about_quick(summary)), board])];
    let figures = drawn(&Stored { store, summary })?;
    sections.extend(figures.into_iter().map(|(heading, blocks)| PageSection::new(heading, blocks)));
    sections.push(PageSection::new("Checks", vec![PageBlock::Checks(check_rows(&kept.checks))]));
    sections.push(PageSection::new("Warnings", vec![PageBlock::Warnings(warnings(summary))]));
    sections.push(case_section(summary, &kept));
    let page = Page {
        title: "The beams paper, recomputed".to_owned(),
        lead: format!(
            "Brunetti, D'Ambrogio and Fregolent, Dynamic substructuring with time variant coupling conditions for the analysis of friction induced \
             vibrations (2020): Figs. 2 to 6. {}",
            tally(&lines, &kept)
        ),
        facts: facts(summary),
        sections,
    };
    write_page(store, &page)
}

/// The results that figures are drawn from.
struct Stored<'a> {
    store: &'a StudyFolder,
    summary: &'a Summary,
}

impl Stored<'_> {
    /// What is stored of an analysis; `None` where it is not done.
    fn read(&self, name: &str) -> Option<StoredAnalysis> {
        StoredAnalysis::read(self.store, self.summary, name)
    }

    /// The figure of analyses that are all done.
    fn figure(
        &self,
        name: &str,
        analyses: &[Option<&StoredAnalysis>],
        draw: impl FnOnce(&[StoredArrays<'_>]) -> Option<Figure>,
    ) -> Result<Vec<PageBlock>, StudyError> {
        let Some(all) = analyses.iter().copied().collect::<Option<Vec<_>>>() else { return Ok(Vec::new()) };
        block(self.store, name, &all, draw)
    }

    /// The figure of one analysis alone.
    fn own_figure(&self, analysis: &str, name: &str, title: &str) -> Result<Vec<PageBlock>, StudyError> {
        let draw = |arrays: &[StoredArrays<'_>]| figures::own(arrays.first()?, name, title);
        self.figure(name, &[self.read(analysis).as_ref()], draw)
    }

    /// Growth with the contact held, by a method.
    fn growths(&self, name: &str, method: &str) -> Result<Vec<PageBlock>, StudyError> {
        let prefix = format!("growth-{method}-");
        let names = self.summary.analyses.keys().filter(|name| name.starts_with(&prefix));
        let held: Vec<StoredAnalysis> = names.filter_map(|name| self.read(name)).collect();
        if held.is_empty() {
            return Ok(Vec::new());
        }
        let stem = format!("growth-{method}");
        let all: Vec<&StoredAnalysis> = held.iter().collect();
        block(self.store, &stem, &all, |arrays| figures::growths(name, &stem, arrays))
    }

    /// What the zones promise and what EnSubs makes of it; nothing where it passes none that is worth it.
    fn zones(&self, ensubs: Option<&StoredAnalysis>) -> Result<Vec<PageBlock>, StudyError> {
        let Some(ensubs) = ensubs else { return Ok(Vec::new()) };
        let locus = self.read("locus-deformed");
        let analyses: Vec<&StoredAnalysis> = [ensubs].into_iter().chain(&locus).collect();
        let zones = StoredResults::zones_of(&self.summary.results, "ensubs", "zones");
        figure_blocks(self.store, "zones", || {
            let passed = made(self.store.path(), &analyses, |arrays| {
                Some(passages(arrays.first()?, SIGNAL, &zones, arrays.get(1)))
            })?;
            Ok(if passed.is_empty() { Vec::new() } else { vec![figures::zones(&passed)] })
        })
    }
}

/// The figures under their headings, as far as their results are there.
fn drawn(stored: &Stored<'_>) -> Result<Vec<(&'static str, Vec<PageBlock>)>, StudyError> {
    let undeformed = "Locus of the pair as it lies undeformed";
    let deformed = "Locus of the pair in steady sliding, deformed by its load";
    let mut fig_2 = stored.own_figure("locus", "fig-2", undeformed)?;
    fig_2.extend(stored.own_figure("locus-deformed", "fig-2-deformed", deformed)?);
    let [subs, film, ensubs] = ["subs", "film", "ensubs"].map(|march| stored.read(march));
    let [subs, ensubs] = [subs.as_ref(), ensubs.as_ref()];
    let fig_3 = stored.figure("fig-3", &[subs, film.as_ref()], figures::subs_and_film)?;
    let spectra = ["spectrogram-subs", "spectrogram-film"].map(|own| stored.read(own));
    let fig_4 = stored.figure("fig-4", &spectra.each_ref().map(Option::as_ref), figures::spectrograms)?;
    drop(spectra);
    let fig_5 = stored.figure("fig-5", &[ensubs, film.as_ref()], figures::ensubs_and_film)?;
    drop(film);
    let fig_6 = stored.figure("fig-6", &[ensubs], |arrays| figures::forces(arrays.first()?))?;
    let mut growths = stored.zones(ensubs)?;
    for (name, method) in [("Subs", "subs"), ("EnSubs", "ensubs")] {
        growths.extend(stored.growths(name, method)?);
    }
    let sloped = stored.read("subs-static-slope");
    let mut reason = stored.figure("static-slope", &[subs, sloped.as_ref(), ensubs], figures::reason)?;
    drop(sloped);
    let ours = stored.read("residual-flexibility");
    reason.extend(stored.figure("residual-flexibility", &[ours.as_ref(), ensubs], figures::residual)?);
    let sections = [
        ("Fig. 2", fig_2),
        ("Fig. 3", fig_3),
        ("Fig. 4", fig_4),
        ("Fig. 5", fig_5),
        ("Fig. 6", fig_6),
        ("Growth: zones that are passed, and the contact held", growths),
        ("The reason, and a march of our own", reason),
    ];
    Ok(sections.into_iter().filter(|(_, blocks)| !blocks.is_empty()).collect())
}

/// What the marches cover.
fn about_quick(summary: &Summary) -> &'static str {
    if summary.extra.get(KEY).and_then(|own| own.get("quick")) == Some(&Value::Bool(true)) {
        "A quick run: loci over the whole path, marches over its last quarter."
    } else {
        "Loci and marches over the whole path."
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawn::stored_by_hand::undrawn;
    use judder_store::{Dataset, Variable, VariableValues};

    /// A march of ten steps with this signal.
    fn march(signal: Variable) -> Dataset {
        let along = |name: &str| Variable::new(name, &["time"], &[10], ramp(10));
        let others = ["time", "position", "sliding_velocity", "normal_force"].map(along);
        let begun = Dataset::new().attribute("settled_s", 2.0).unwrap();
        others.into_iter().chain([signal]).fold(begun, |all, own| all.with(own).unwrap())
    }

    fn ramp(count: u32) -> Vec<f64> {
        (0..count).map(f64::from).collect()
    }

    /// A signal of another type or length takes the figures with it that show it, each with the reason, and no other.
    #[test]
    fn a_figure_of_wrong_arrays_takes_no_other_with_it() {
        let real = || Variable::new(SIGNAL, &["time"], &[10], ramp(10));
        let codes = Variable::new(SIGNAL, &["time"], &[10], VariableValues::U8(vec![0; 10]));
        let short = Variable::new(SIGNAL, &["half"], &[5], ramp(5));
        for (wrong, found) in [(codes, "codes over (time: 10)"), (short, "real numbers over (half: 5)")] {
            let folder = tempfile::tempdir().unwrap();
            let store = StudyFolder::create(folder.path()).unwrap();
            let marches = [
                ("subs", march(real())),
                ("film", march(real())),
                ("ensubs", march(wrong)),
                ("residual-flexibility", march(real())),
            ];
            let undrawn = undrawn(&store, &marches, |summary| write(&store, summary).unwrap());
            let names: Vec<&str> = undrawn.iter().map(|(name, _)| name.as_str()).collect();
            assert_eq!(names, ["fig-5", "residual-flexibility"], "{undrawn:?}");
            for (_, reason) in &undrawn {
                let told = format!("analysis `ensubs`: the array `T.y` is one of {found}");
                assert!(reason.contains(&told), "{reason}");
            }
            for drawn in ["fig-3", "fig-6"] {
                assert!(folder.path().join(format!("figures/{drawn}.svg")).is_file(), "{drawn}");
            }
        }
    }
}
