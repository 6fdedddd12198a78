//! The report of the reproduction.

use super::claims::CLAIMS;
use super::claims::motion::MOTION_CLAIMS;
use super::exhibits::{CONTACT_CASES, EXHIBITS, Exhibit, PanelSource};
use super::motion_exhibits::{MOTION_CASES, WAYS};
use super::readings::{READINGS, Reading};
use super::{analysis_name, by_law, computed_for, contact_figures, motion_figures};
use crate::claim::{self, ClaimLine};
use crate::drawn::{StoredAnalysis, block};
use crate::summary::{KEY, tally};
use judder_models::oscillator::MODEL as OSCILLATOR;
use judder_report::page::{Code, Details, PageTable};
use judder_report::{Figure, Legend, Page, PageBlock, PageSection, Panel};
use judder_store::{StudyFolder, Summary};
use judder_study::StudyError;
use judder_study::ledger::Keepsakes;
use judder_study::report::{WrittenPage, check_rows, facts, warnings, write_page};
use rayon::prelude::*;
use serde_json::Value;

/// The figures of each law in the order of the readings: what is added to names and titles.
const LAWS: [(&str, &str); 3] = [
    ("", ""),
    ("-corrected", ", with the corrected velocity axis"),
    ("-computed", ", with the computed law"),
];
/// The readings that a verdict is about: both friction loads, with the printed law.
const FRICTION_LOADS: usize = 2;
/// The columns of the contact computation, which knows no friction load.
const BY_LAW: [(usize, &str); 3] = [(0, "as printed"), (2, "corrected axis"), (4, "computed")];

/// Draws every figure of the paper and the page.
pub(crate) fn write(store: &StudyFolder, summary: &Summary) -> Result<WrittenPage, StudyError> {
    let lines: Vec<ClaimLine> = summary
        .extra
        .get(KEY)
        .and_then(|kept| serde_json::from_value(kept.get("scoreboard")?.clone()).ok())
        .unwrap_or_default();
    let kept = Keepsakes::of(summary);
    let mut sections = vec![PageSection::new("Scoreboard", boards(&lines, computed_for(summary)))];
    let ((contact, exhibits), (motion, law)) = rayon::join(
        || rayon::join(|| contact_figures::sections(store, summary), || exhibits(store, summary)),
        || rayon::join(|| motion_figures::sections(store, summary), || by_law::section(store, summary)),
    );
    sections.extend(contact?);
    sections.extend(exhibits?);
    sections.extend(motion?);
    sections.push(law?);
    sections.push(PageSection::new("Areas of the maps", vec![PageBlock::Table(areas(summary))]));
    sections.push(PageSection::new("Checks", vec![PageBlock::Checks(check_rows(&kept.checks))]));
    sections.push(PageSection::new("Warnings", vec![PageBlock::Warnings(warnings(summary))]));
    sections.push(PageSection::new("Cases", cases()));
    let page = Page {
        title: "The oscillator paper, recomputed".to_owned(),
        lead: format!(
            "Papangelo, Putignano and Hoffmann, Critical thresholds for mode-coupling instability in viscoelastic sliding contacts, Nonlinear \
             Dynamics (2021): Figs. 3 to 14. {}",
            tally(&lines, &kept)
        ),
        facts: facts(summary),
        sections,
    };
    write_page(store, &page)
}

/// The sections of Figs. 4 to 10.
fn exhibits(store: &StudyFolder, summary: &Summary) -> Result<Vec<PageSection>, StudyError> {
    let section = |exhibit: &Exhibit| {
        let heading = exhibit.name.replace("fig-", "Fig. ");
        Ok(PageSection::new(heading, exhibit_blocks(store, summary, exhibit)?))
    };
    EXHIBITS.par_iter().map(section).collect()
}

/// The scoreboard in three parts: with every reading, with every way to read section 5, and by law alone.
fn boards(lines: &[ClaimLine], computed_for: &str) -> Vec<PageBlock> {
    let (sections, further) = lines.split_at(CLAIMS.len().min(lines.len()));
    let (motions, contact) = further.split_at(MOTION_CLAIMS.len().min(further.len()));
    let readings: Vec<(usize, &str)> = READINGS.iter().map(|reading| reading.label).enumerate().collect();
    let ways: Vec<(usize, &str)> = WAYS.iter().map(|way| way.label).enumerate().collect();
    vec![
        PageBlock::text(format!(
            "Every number and claim of sections 2 to 4, and what section 5 says of the threshold, measured with both readings of the viscoelastic friction: with the velocity axis of the fits \
             as printed and corrected, and with the law computed for {computed_for}. A verdict is about the printed law; the other readings show what the \
             correction and the computation do to it."
        )),
        PageBlock::Scoreboard(claim::block(sections, &readings, FRICTION_LOADS)),
        PageBlock::Heading("Motion".to_owned()),
        PageBlock::text(motion_figures::decision(motions)),
        PageBlock::Scoreboard(claim::block(motions, &ways, FRICTION_LOADS)),
        PageBlock::Heading("The contact computation".to_owned()),
        PageBlock::text(
            "Appendices A and B, from contacts that were computed anew. A verdict is about the number that the paper prints.",
        ),
        PageBlock::Scoreboard(claim::block(contact, &BY_LAW, BY_LAW.len())),
    ]
}

/// The figures with the printed law, with the corrected axis, with the computed law.
fn exhibit_blocks(
    store: &StudyFolder,
    summary: &Summary,
    exhibit: &Exhibit,
) -> Result<Vec<PageBlock>, StudyError> {
    let mut blocks = Vec::new();
    for ((ending, addition), readings) in LAWS.into_iter().zip(READINGS.chunks(FRICTION_LOADS)) {
        let all = exhibit.sources.iter().flat_map(|source| readings.iter().map(move |own| (source, own)));
        let analyses: Vec<(String, StoredAnalysis)> = all
            .filter_map(|(source, reading)| {
                let name = analysis_name(source, reading);
                Some((panel_title(source, reading), StoredAnalysis::read(store, summary, &name)?))
            })
            .collect();
        if analyses.is_empty() {
            continue;
        }
        let (titles, analyses): (Vec<&String>, Vec<&StoredAnalysis>) =
            analyses.iter().map(|(title, own)| (title, own)).unzip();
        let stem = format!("{}{ending}", exhibit.name);
        blocks.extend(block(store, &stem, &analyses, |arrays| {
            let mut panels = Vec::new();
            for (title, arrays) in titles.iter().zip(arrays) {
                let drawn = Some(OSCILLATOR.panels_of(arrays)).filter(|drawn| !drawn.is_empty())?;
                let named = |panel: Panel| panel.with_title(title.as_str()).with_legend(Legend::Below);
                panels.extend(drawn.into_iter().map(named));
            }
            let title = format!("{}{addition}", exhibit.title);
            Some(Figure::new(stem.clone(), title, panels).with_caption(exhibit.caption))
        })?);
    }
    Ok(blocks)
}

/// What stands over the panels of a case with a reading.
fn panel_title(source: &PanelSource, reading: &Reading) -> String {
    if source.label.is_empty() {
        reading.label.to_owned()
    } else {
        format!("{}; {}", source.label, reading.label)
    }
}

/// The shares of every mechanism in every map.
fn areas(summary: &Summary) -> PageTable {
    const CLASSES: [&str; 6] =
        ["stable", "flutter", "negative-damping", "both", "normal-force-coupling", "destabilised-by-damping"];
    let mut rows = Vec::new();
    for source in EXHIBITS.iter().flat_map(|exhibit| exhibit.sources) {
        for reading in &READINGS {
            let fractions = summary
                .results
                .get(&analysis_name(source, reading))
                .and_then(|result| result.get("fractions"))
                .and_then(Value::as_object);
            let Some(fractions) = fractions else { continue };
            let share = |class: &str| fractions.get(class).and_then(Value::as_f64).unwrap_or(f64::NAN);
            let mut row = vec![source.name.replace("fig-", "Fig. "), reading.label.to_owned()];
            row.extend(CLASSES.map(|class| format!("{:.1}", 100.0 * share(class))));
            let unstable: f64 = CLASSES[1..].iter().map(|class| share(class)).sum();
            let neither: f64 = CLASSES[4..].iter().map(|class| share(class)).sum();
            row.push(format!("{:.1}", 100.0 * neither / unstable));
            rows.push(row);
        }
    }
    let shares = CLASSES.into_iter().chain(["neither, of the unstable"]);
    let shares = shares.map(|share| format!("{} (%)", share.replace('-', " ")));
    PageTable {
        caption: "Shares of the maps, by mechanism; the last column is the part of the unstable area that is neither flutter nor \
                  negative damping."
            .to_owned(),
        head: ["map", "reading"].map(str::to_owned).into_iter().chain(shares).collect(),
        rows,
    }
}

/// The case files, behind a line each.
fn cases() -> Vec<PageBlock> {
    let sources = EXHIBITS.iter().flat_map(|exhibit| exhibit.sources);
    let mut cases: Vec<(&str, &str)> = CONTACT_CASES
        .into_iter()
        .chain(sources.map(|source| (source.case_name, source.case)))
        .chain(MOTION_CASES)
        .collect();
    cases.dedup_by_key(|(name, _)| *name);
    let block = |(name, text): (&str, &str)| {
        let caption = format!("cases/oscillator-paper/{name}.toml");
        let code = PageBlock::Code(Code { caption: caption.clone(), text: text.to_owned() });
        PageBlock::Details(Details { summary: caption, blocks: vec![code] })
    };
    cases.into_iter().map(block).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawn::stored_by_hand::undrawn;
    use judder_store::{Dataset, Variable, VariableValues};

    #[test]
    fn shares_of_maps_have_their_unit_in_the_head() {
        let table = areas(&Summary::default());
        assert!(
            table.head.len() == 9 && table.head[2..].iter().all(|head| head.ends_with(" (%)")),
            "{table:?}"
        );
    }

    /// Two by three points.
    fn plane(kind: &str, [y, x]: [&str; 2], arrays: Vec<Variable>) -> Dataset {
        let begun = Dataset::new().attribute("kind", kind).unwrap();
        let coordinates =
            [Variable::coordinate(y, vec![0.1, 1.0]), Variable::coordinate(x, vec![0.1, 1.0, 10.0])];
        coordinates.into_iter().chain(arrays).fold(begun, |all, own| all.with(own).unwrap())
    }

    fn contact(kind: &str, wrong: Option<&str>) -> Dataset {
        let values = || (1..=6).map(|k| 0.1 * f64::from(k)).collect::<Vec<f64>>();
        let along = |name: &str| match wrong {
            Some(wrong) if wrong == name => {
                Variable::new(name, &["velocity", "indentation"], &[3, 2], values())
            }
            _ => Variable::new(name, &["indentation", "velocity"], &[2, 3], values()),
        };
        let samples = ["sample_velocity", "sample_indentation"]
            .map(|name| Variable::new(name, &["sample"], &[1], vec![0.5]));
        let arrays = ["force", "area", "friction"].map(along).into_iter().chain(samples).collect();
        plane(kind, ["indentation", "velocity"], arrays)
    }

    fn map(stability: VariableValues) -> Dataset {
        let dimensions = ["contact.shear_strength", "operation.velocity"];
        plane("stability-map", dimensions, vec![Variable::new("stability", &dimensions, &[2, 3], stability)])
    }

    /// What is stored of one analysis and is not what judder writes is told in the place of each figure that shows it; all others are drawn.
    #[test]
    fn a_figure_of_wrong_arrays_takes_no_other_with_it() {
        let folder = tempfile::tempdir().unwrap();
        let store = StudyFolder::create(folder.path()).unwrap();
        let sound = || map(VariableValues::U8(vec![0; 6]));
        let analyses = [
            ("fig-3", contact("contact-law", None)),
            ("fig-14", contact("fit", Some("area"))),
            ("fig-9a-normal-load", sound()),
            ("fig-9a-corrected-normal-load", sound()),
            ("fig-9a-computed-normal-load", map(VariableValues::F64(vec![0.0; 6]))),
            ("fig-9b-normal-load", sound()),
            ("fig-9b-corrected-normal-load", sound()),
            ("fig-9b-computed-normal-load", sound()),
            ("engines", Dataset::new()),
        ];
        let undrawn = undrawn(&store, &analyses, |summary| write(&store, summary).unwrap());
        let expected = [
            (
                "fig-3",
                "analysis `fig-14`: the array `area` is one of real numbers over (velocity: 3, indentation: 2)",
            ),
            ("fig-14", "analysis `fig-14`: the array `area` is"),
            (
                "fig-9-computed",
                "analysis `fig-9a-computed-normal-load`: the array `stability` is one of real numbers",
            ),
            ("engines", "what it shows is not among what is stored of `engines`"),
            ("fig-9a in maps-by-law", "analysis `fig-9a-computed-normal-load`: the array `stability` is"),
        ];
        for ((name, reason), (figure, told)) in undrawn.iter().zip(expected) {
            assert!(name == figure && reason.contains(told), "{name}: {reason}");
        }
        assert_eq!(undrawn.len(), expected.len(), "{undrawn:?}");
        for drawn in ["fig-3-maps", "fig-9", "fig-9-corrected", "maps-by-law"] {
            assert!(folder.path().join(format!("figures/{drawn}.svg")).is_file(), "{drawn}");
        }
    }
}
