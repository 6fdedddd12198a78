//! Figures that are put together from what is stored of several analyses. One that cannot be read or drawn says why in its place, and takes no
//! other with it.

use crate::summary::is_done;
use judder_report::{Figure, PageBlock};
use judder_store::{Dataset, StudyFolder, Summary};
use judder_study::StudyError;
use judder_study::pictures::StoredArrays;
use judder_study::report::figure_blocks;
use std::path::Path;

/// What is stored of an analysis that is done.
pub(crate) struct StoredAnalysis {
    name: String,
    /// Its arrays, or why they cannot be read.
    arrays: Result<Dataset, String>,
}

impl StoredAnalysis {
    /// That of an analysis; `None` where it is not done.
    pub(crate) fn read(store: &StudyFolder, summary: &Summary, name: &str) -> Option<Self> {
        let read = || store.read_dataset(name).map_err(|error| error.to_string());
        is_done(summary, name).then(|| Self { name: name.to_owned(), arrays: read() })
    }
}

/// What is made of all these analyses; why nothing is, in words, where one cannot be read, or holds arrays that are not what judder writes.
pub(crate) fn made<T>(
    study: &Path,
    analyses: &[&StoredAnalysis],
    make: impl FnOnce(&[StoredArrays<'_>]) -> Option<T>,
) -> Result<T, String> {
    let mut arrays = Vec::with_capacity(analyses.len());
    for own in analyses {
        arrays.push(StoredArrays::of(own.arrays.as_ref().map_err(Clone::clone)?));
    }
    let made = make(&arrays);
    for (own, arrays) in analyses.iter().zip(&arrays) {
        arrays.settled(()).map_err(|wrong| wrong.in_study(study, &own.name).to_string())?;
    }
    let names = || analyses.iter().map(|own| format!("`{}`", own.name)).collect::<Vec<_>>().join(", ");
    made.ok_or_else(|| {
        format!(
            "{}: what it shows is not among what is stored of {}; `judder run --fresh` computes it anew",
            study.display(),
            names()
        )
    })
}

/// A figure that is drawn from all these analyses, as a block of the page.
///
/// # Errors
/// A folder that cannot be written.
pub(crate) fn block(
    store: &StudyFolder,
    name: &str,
    analyses: &[&StoredAnalysis],
    draw: impl FnOnce(&[StoredArrays<'_>]) -> Option<Figure>,
) -> Result<Vec<PageBlock>, StudyError> {
    figure_blocks(store, name, || Ok(vec![made(store.path(), analyses, draw)?]))
}

#[cfg(test)]
pub(crate) mod stored_by_hand {
    //! Studies of papers whose arrays are put there by hand.

    use judder_store::{AnalysisRecord, Dataset, Status, StudyFolder, Summary};
    use judder_study::report::WrittenPage;

    /// A study in which these analyses are done, and what of its page is not drawn: the name of each figure and why.
    pub(crate) fn undrawn(
        store: &StudyFolder,
        analyses: &[(&str, Dataset)],
        write: impl FnOnce(&Summary) -> WrittenPage,
    ) -> Vec<(String, String)> {
        let mut summary = Summary::default();
        for (name, arrays) in analyses {
            store.write_dataset(name, "h", arrays).unwrap();
            let record = AnalysisRecord {
                hash: "h".to_owned(),
                status: Status::Done,
                wall_time_s: 0.0,
                warnings: Vec::new(),
            };
            summary.analyses.insert((*name).to_owned(), record);
        }
        write(&summary).undrawn.into_iter().map(|figure| (figure.name, figure.reason)).collect()
    }
}
