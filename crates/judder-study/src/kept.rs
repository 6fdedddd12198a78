//! What an interrupted run has left of an analysis, so that the next one goes on from there.

use judder_store::StudyFolder;
use serde::Serialize;
use serde::de::DeserializeOwned;

/// The lines of an earlier run, and who keeps each new one.
#[derive(Clone, Copy)]
pub struct KeptLines<'a> {
    /// Lines of JSON.
    pub lines: &'a [String],
    /// Keeps a line; it may come from any thread.
    pub keep: &'a (dyn Fn(&str) + Sync),
    /// Where the study is; none where there is none.
    pub place: Option<StudyPlace<'a>>,
}

/// An analysis in its study folder: for those that store arrays while they run, and those that read what others have left.
#[derive(Clone, Copy)]
pub struct StudyPlace<'a> {
    /// The folder.
    pub study: &'a StudyFolder,
    /// The analysis's name.
    pub analysis: &'a str,
    /// What its result depends on.
    pub hash: &'a str,
    /// The same of all analyses of the case.
    pub all: &'a [(String, String)],
}

impl KeptLines<'_> {
    /// Nothing is known and nothing is kept.
    pub const NOTHING: KeptLines<'static> = KeptLines { lines: &[], keep: &|_| (), place: None };

    /// What is known of one type; a line that is none of it comes from elsewhere and is passed over.
    pub fn known<T: DeserializeOwned>(&self) -> Vec<T> {
        self.lines.iter().filter_map(|line| serde_json::from_str(line).ok()).collect()
    }

    /// Keeps one more result; one that cannot be kept costs a rerun, no result.
    pub fn add<T: Serialize>(&self, result: &T) {
        if let Ok(line) = serde_json::to_string(result) {
            (self.keep)(&line);
        }
    }
}
