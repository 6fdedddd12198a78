//! The beams paper: Figs. 2–6 and what its text claims, from one run of its case.

mod claims;
mod figures;
mod found;
mod held;
pub(super) mod page;
mod passage;

use crate::Reproduction;
use crate::summary::KEY;
use found::StoredResults;
use judder_models::template::template;
use judder_study::Progress;
use judder_study::StudyError;
use judder_study::case::file::CaseFile;
use judder_study::maker;
use judder_study::run::{self, Computed, RunOptions};

use serde_json::json;
use std::path::Path;

/// The paper's name in a summary.
pub(super) const PAPER: &str = "beams-paper";
/// What is computed in place of the template's analyses.
const ANALYSES: &str = include_str!("beams/analyses.toml");
/// The loci, with the march that sees each of them.
const LOCI: [(&str, &str); 2] = [("locus", "subs"), ("locus-deformed", "ensubs")];
/// The marches of the path, and where a quick one starts: the last quarter.
const MARCHES: [&str; 5] = ["subs", "subs-static-slope", "ensubs", "film", "residual-flexibility"];
const QUICK_START: &str = "76 mm";

/// Recomputes Figs. 2–6 and the scoreboard into a folder; `quick` marches over the last quarter of the path.
///
/// # Errors
/// A folder that cannot be written, or [`StudyError::Interrupted`]; what was done until then is kept.
pub fn beams_paper(folder: &Path, quick: bool, progress: &dyn Progress) -> Result<Reproduction, StudyError> {
    let file = case(quick, &growth(quick, folder, progress)?)?;
    let Computed { store, mut summary, lacking, .. } =
        run::compute(&file, folder, &RunOptions::default(), progress)?;
    let scoreboard = claims::lines(&StoredResults::stored(&store, &summary)?);
    summary.extra.insert(KEY.to_owned(), json!({ "paper": PAPER, "quick": quick, "scoreboard": scoreboard }));
    store.write_summary(&summary, None)?;
    let page = page::write(&store, &summary)?;
    store.seal(maker())?;
    let columns = vec!["ours".to_owned()];
    let lacking = [lacking, page.lacking()].concat();
    Ok(Reproduction { folder: folder.to_owned(), report: page.path, columns, scoreboard, lacking })
}

/// Computes the loci, and says which growth analyses there are in their zones. The folder is free again afterwards.
fn growth(quick: bool, folder: &Path, progress: &dyn Progress) -> Result<String, StudyError> {
    let only = LOCI.map(|(locus, _)| locus.to_owned()).to_vec();
    let loci =
        run::compute(&case(quick, "")?, folder, &RunOptions { only, ..RunOptions::default() }, progress)?;
    let of = |(locus, method): &(&str, &str)| {
        held::analyses(method, StoredResults::zones_of(&loci.summary.results, locus, "unstable"))
    };
    Ok(LOCI.iter().map(of).collect())
}

/// The template's structures, contact and motion with the analyses of the reproduction and of growth with the contact held.
fn case(quick: bool, growth: &str) -> Result<CaseFile, StudyError> {
    let template = template(PAPER)?;
    let system = template.split_once("[[analysis]]").map_or(template.as_str(), |(system, _)| system);
    let text = format!("{system}{ANALYSES}{growth}");
    let start = |march: &&str| format!("analysis.{march}.from={QUICK_START}");
    let overrides: Vec<String> = if quick { MARCHES.iter().map(start).collect() } else { Vec::new() };
    Ok(judder_models::parse(PAPER, &text, &overrides)?)
}

#[cfg(test)]
mod tests {
    use super::*;
    use judder_study::Silent;

    #[test]
    fn the_case_of_the_reproduction_is_sound() {
        let zone = passage::PassedZone {
            from: 0.09,
            to: 0.0916,
            peak: 0.090_974_268_032_561_92,
            frequency: 3_523.373_683_165_756_6,
            growth: 135.4,
            nepers: f64::NAN,
        };
        let growth = held::analyses("ensubs", vec![zone]);
        let full = case(false, &growth).unwrap();
        let quick = case(true, &growth).unwrap();
        assert_ne!(full.case.resolved(), quick.case.resolved());
        let names = full.case.analysis_names();
        let loci = LOCI.iter().map(|(locus, _)| locus);
        let all = MARCHES.iter().chain(loci).chain(&["growth-ensubs-1"]);
        assert!(all.into_iter().all(|wanted| names.iter().any(|name| name == wanted)), "{names:?}");
    }

    /// Both runs work in one folder, one after the other, and the second finds the loci done: growth in four zones of each is that of the
    /// eigenvalue.
    #[test]
    fn growth_is_measured_in_the_zones_of_the_loci() {
        let folder = tempfile::tempdir().unwrap();
        let growth = growth(true, folder.path(), &Silent).unwrap();
        let file = case(true, &growth).unwrap();
        let mut only: Vec<String> = file.case.analysis_names().into_iter().map(str::to_owned).collect();
        only.retain(|name| name.starts_with("growth-") || name.starts_with("locus"));
        let computed =
            run::compute(&file, folder.path(), &RunOptions { only, ..RunOptions::default() }, &Silent)
                .unwrap();
        assert!(computed.lacking.is_empty() && computed.skipped == ["locus", "locus-deformed"]);
        let found = StoredResults::stored(&computed.store, &computed.summary).unwrap();
        for (_, method) in LOCI {
            let growths = found.growths(method);
            assert_eq!(growths.len(), 4, "{method}");
            assert!(growths.iter().all(|(own, other)| (own / other - 1.0).abs() < 1e-2), "{growths:?}");
        }
    }
}
