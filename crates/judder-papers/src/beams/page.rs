//! The report of the beams paper.

use super::figures::{self, SIGNAL};
use super::found::StoredResults;
use super::passage::passages;
use crate::claim::{self, ClaimLine};
use crate::summary::{KEY, is_done, tally};
use judder_report::{Figure, Page, PageBlock, PageSection};
use judder_store::{Dataset, StudyFolder, Summary};
use judder_study::StudyError;
use judder_study::ledger::Keepsakes;
use judder_study::report::{
    WrittenPage, case_section, check_rows, facts, warnings, write_figure, write_page,
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
    for (heading, figures) in drawn(&Stored { store, summary })? {
        let blocks: Result<Vec<PageBlock>, StudyError> =
            figures.into_iter().map(|figure| write_figure(store, figure)).collect();
        sections.push(PageSection::new(heading, blocks?));
    }
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
    /// The arrays of an analysis that is done.
    fn dataset(&self, name: &str) -> Result<Option<Dataset>, StudyError> {
        let read = || self.store.read_dataset(name);
        Ok(is_done(self.summary, name).then(read).transpose()?)
    }

    /// The figure of one analysis alone.
    fn figure(&self, analysis: &str, name: &str, title: &str) -> Result<Option<Figure>, StudyError> {
        let Some(dataset) = self.dataset(analysis)? else { return Ok(None) };
        let drawn = judder_models::sliding::MODEL.figure(name, title, &dataset);
        Ok(drawn.map_err(|wrong| wrong.in_study(self.store.path(), analysis))?)
    }

    /// The growth analyses of a method.
    fn growths(&self, method: &str) -> Result<Vec<Dataset>, StudyError> {
        let prefix = format!("growth-{method}-");
        let names = self.summary.analyses.keys().filter(|name| name.starts_with(&prefix));
        let mut growths = Vec::new();
        for name in names {
            growths.extend(self.dataset(name)?);
        }
        Ok(growths)
    }
}

/// The figures under their headings, as far as their results are there.
fn drawn(stored: &Stored<'_>) -> Result<Vec<(&'static str, Vec<Figure>)>, StudyError> {
    let undeformed = "Locus of the pair as it lies undeformed";
    let deformed = "Locus of the pair in steady sliding, deformed by its load";
    let fig_2 = [
        stored.figure("locus", "fig-2", undeformed)?,
        stored.figure("locus-deformed", "fig-2-deformed", deformed)?,
    ];
    let [subs, film, ensubs] = [stored.dataset("subs")?, stored.dataset("film")?, stored.dataset("ensubs")?];
    let fig_3 = subs.as_ref().zip(film.as_ref()).and_then(|(subs, film)| figures::subs_and_film(subs, film));
    let spectra = stored.dataset("spectrogram-subs")?.zip(stored.dataset("spectrogram-film")?);
    let fig_4 = spectra.and_then(|(subs, film)| figures::spectrograms(&subs, &film));
    let fig_5 =
        ensubs.as_ref().zip(film.as_ref()).and_then(|(own, film)| figures::ensubs_and_film(own, film));
    drop(film);
    let fig_6 = ensubs.as_ref().and_then(figures::forces);
    let growth = [("Subs", "subs"), ("EnSubs", "ensubs")];
    let mut growths = vec![zones(stored, ensubs.as_ref())?];
    for (name, method) in growth {
        growths.push(figures::growths(name, &format!("growth-{method}"), &stored.growths(method)?));
    }
    let sloped = stored.dataset("subs-static-slope")?;
    let reason = match (&subs, &sloped, &ensubs) {
        (Some(subs), Some(sloped), Some(ensubs)) => figures::reason(subs, sloped, ensubs),
        _ => None,
    };
    drop((subs, sloped));
    let ours = stored.dataset("residual-flexibility")?;
    let residual = ours.as_ref().zip(ensubs.as_ref()).and_then(|(ours, own)| figures::residual(ours, own));
    let sections = [
        ("Fig. 2", fig_2.to_vec()),
        ("Fig. 3", vec![fig_3]),
        ("Fig. 4", vec![fig_4]),
        ("Fig. 5", vec![fig_5]),
        ("Fig. 6", vec![fig_6]),
        ("Growth: zones that are passed, and the contact held", growths),
        ("The reason, and a march of our own", vec![reason, residual]),
    ];
    let present =
        |(heading, figures): (_, Vec<Option<Figure>>)| (heading, figures.into_iter().flatten().collect());
    Ok(sections
        .map(present)
        .into_iter()
        .filter(|(_, figures): &(_, Vec<Figure>)| !figures.is_empty())
        .collect())
}

/// What the zones promise and what EnSubs makes of it.
fn zones(stored: &Stored<'_>, ensubs: Option<&Dataset>) -> Result<Option<Figure>, StudyError> {
    let Some(ensubs) = ensubs else { return Ok(None) };
    let locus = stored.dataset("locus-deformed")?;
    let zones = StoredResults::zones_of(&stored.summary.results, "ensubs", "zones");
    Ok(figures::zones(&passages(ensubs, SIGNAL, &zones, locus.as_ref())))
}

/// What the marches cover.
fn about_quick(summary: &Summary) -> &'static str {
    if summary.extra.get(KEY).and_then(|own| own.get("quick")) == Some(&Value::Bool(true)) {
        "A quick run: loci over the whole path, marches over its last quarter."
    } else {
        "Loci and marches over the whole path."
    }
}
