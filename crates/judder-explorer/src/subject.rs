//! What is explored: the base case with the laws of its views, and the study folder with the pair that slides in it.

use crate::error::ExplorerError;
use crate::refusal::RequestRefusal;
use judder_keys::file_reference::FileReference;
use judder_models::law_cache::LawCache;
use judder_models::sliding::case::SlidingCase;
use judder_models::sliding_shapes::{SharedPair, SlidingShapes};
use judder_models::template::template;
use judder_study::Progress;
use judder_study::case::file::CaseFile;
use judder_study::study_view::StudyView;
use std::fmt;
use std::path::Path;

/// The base case, which views change, and what was run before.
#[derive(Debug)]
pub struct ViewedCase {
    /// The case; a study whose case cannot be read any more is looked at without one.
    base: Option<CaseFile>,
    /// The laws of the views that were looked at last.
    pub(crate) laws: LawCache,
    /// The study folder.
    pub(crate) study: Option<Studied>,
}

/// A study folder, and the pair of its case, made when its shapes are first asked for.
pub(crate) struct Studied {
    pub(crate) view: StudyView,
    case: Option<CaseFile>,
    pair: SharedPair,
}

impl fmt::Debug for Studied {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_struct("Studied").field("view", &self.view).finish_non_exhaustive()
    }
}

impl ViewedCase {
    /// Reads the case and looks into the study folder. Without a case, that of the study is explored; without either, the template of an
    /// oscillator.
    ///
    /// # Errors
    /// A case that is wrong, a folder without a study.
    pub fn open(case: Option<&Path>, study: Option<&Path>) -> Result<Self, ExplorerError> {
        Self::of(case.map(|path| judder_models::read(path, &[])).transpose()?, study)
    }

    /// The same with a case that was read.
    ///
    /// # Errors
    /// A folder without a study.
    pub fn of(given: Option<CaseFile>, study: Option<&Path>) -> Result<Self, ExplorerError> {
        let study = study.map(|folder| Studied::open(folder, given.as_ref())).transpose()?;
        let base = match (given, &study) {
            (Some(given), _) => Some(given),
            (None, Some(study)) => study.case.clone(),
            (None, None) => Some(judder_models::parse("oscillator.toml", &template("oscillator")?, &[])?),
        };
        Ok(Self { base, laws: LawCache::new(), study })
    }

    /// The base case, where there is one.
    pub(crate) fn base(&self) -> Option<&CaseFile> {
        self.base.as_ref()
    }

    /// The base case with these options.
    ///
    /// # Errors
    /// What is wrong with them, or no case to set them on.
    pub(crate) fn with(&self, options: &[String]) -> Result<CaseFile, RequestRefusal> {
        let base = self.needed()?;
        Ok(judder_models::parse(&base.origin, &base.text, &[&base.overrides, options].concat())?)
    }

    /// The base case.
    ///
    /// # Errors
    /// There is none.
    pub(crate) fn needed(&self) -> Result<&CaseFile, RequestRefusal> {
        let none = "the study that is looked at has no case that can be read; give its case file to `judder explore`, with `--study`";
        self.base().ok_or_else(|| RequestRefusal::missing(none))
    }
}

impl Studied {
    fn open(folder: &Path, given: Option<&CaseFile>) -> Result<Self, ExplorerError> {
        let view = StudyView::open(judder_models::REGISTRY, folder)?;
        view.listing()?;
        // a folder may come from anybody: its case reads what lies in it, or what the case that was given reads, and no other file
        let is_own = |case: &CaseFile| case.case.files().iter().all(|file| file.lies_in(folder));
        let kept = view.case_file().ok().filter(is_own);
        let case = kept.or_else(|| given.and_then(|given| beside(&view, given)));
        Ok(Self { view, case, pair: SharedPair::new() })
    }

    /// The case that the folder keeps, its files those of the folder, else those of the case that was given.
    ///
    /// # Errors
    /// It keeps none that can be read so.
    pub(crate) fn case(&self) -> Result<&CaseFile, RequestRefusal> {
        self.case.as_ref().ok_or_else(|| {
            RequestRefusal::missing("the study keeps no case that can be read; give the case file that it was run from to `judder explore`, with `--study`")
        })
    }

    /// The shapes in which the pair of the study swings at a position.
    ///
    /// # Errors
    /// A study of no pair, a position off the track, eigenvalues that are not found; that it was interrupted.
    pub(crate) fn shapes(
        &self,
        analysis: &str,
        position: f64,
        count: usize,
        progress: &dyn Progress,
    ) -> Result<SlidingShapes, RequestRefusal> {
        let case = self.case()?;
        if case.case.of::<SlidingCase>().is_none() {
            let model = case.case.model();
            return Err(RequestRefusal::wrong(format!(
                "coupled shapes are those of a sliding case; the case of this study is of model `{model}`"
            )));
        }
        Ok(self.pair.get(case, progress)?.at(analysis, position, Some(count), progress)?)
    }
}

/// The case that the folder keeps, where the given one lies, of no other files than that one.
fn beside(view: &StudyView, given: &CaseFile) -> Option<CaseFile> {
    let known = given.case.files();
    let is_known = |file: &&FileReference| known.iter().any(|known| file.lies_in(&known.path));
    view.case_file_at(&given.origin).ok().filter(|case| case.case.files().iter().all(is_known))
}
