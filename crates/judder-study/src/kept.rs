//! What an interrupted run has left of an analysis, so that the next one goes on from there.

use judder_store::StudyFolder;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use std::borrow::Cow;
use std::collections::BTreeMap;

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

/// The results of one part of an analysis, by their places: those of an earlier run are known, and each new one is kept.
pub struct KeptResults<'a, T> {
    /// Which part.
    of: Cow<'static, str>,
    kept: KeptLines<'a>,
    known: BTreeMap<u64, T>,
}

/// A line of it.
#[derive(Serialize, Deserialize)]
struct KeptResult<O, T> {
    of: O,
    place: u64,
    result: T,
}

impl<'a, T: Serialize + DeserializeOwned> KeptResults<'a, T> {
    /// Those that are known of a part; a line that is none of it is passed over.
    pub fn of(of: impl Into<Cow<'static, str>>, kept: KeptLines<'a>) -> Self {
        let of = of.into();
        let own = kept.known::<KeptResult<String, T>>().into_iter().filter(|own| own.of == of);
        let known = own.map(|own| (own.place, own.result)).collect();
        Self { of, kept, known }
    }

    /// What is known at a place.
    pub fn known(&self, place: u64) -> Option<&T> {
        self.known.get(&place)
    }

    /// Keeps one more.
    pub fn keep(&self, place: u64, result: &T) {
        self.kept.add(&KeptResult { of: &*self.of, place, result });
    }

    /// The result at a place: the known one, or what `solve` gives, which is kept.
    ///
    /// # Errors
    /// That of `solve`.
    pub fn at<E>(&self, place: u64, solve: impl FnOnce() -> Result<T, E>) -> Result<T, E>
    where
        T: Clone,
    {
        if let Some(known) = self.known(place) {
            return Ok(known.clone());
        }
        let result = solve()?;
        self.keep(place, &result);
        Ok(result)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::Mutex;

    #[test]
    fn results_come_back_by_part_and_place() {
        let lines: Mutex<Vec<String>> = Mutex::default();
        let keep = |line: &str| lines.lock().unwrap().push(line.to_owned());
        let first = KeptResults::<f64>::of("one", KeptLines { keep: &keep, ..KeptLines::NOTHING });
        assert_eq!(first.at(3, || Err("not solved")), Err("not solved"));
        assert_eq!(first.at(u64::MAX, || Ok::<_, ()>(0.1 + 0.2)), Ok(0.1 + 0.2));
        // a number that no line can tell is computed again
        first.keep(4, &f64::NAN);
        let known = lines.lock().unwrap().clone();
        assert_eq!(known.len(), 2);
        let kept = KeptLines { lines: &known, ..KeptLines::NOTHING };
        let again = KeptResults::<f64>::of("one", kept);
        assert_eq!(again.known(u64::MAX).map(|own| own.to_bits()), Some((0.1_f64 + 0.2).to_bits()));
        assert_eq!((again.known(3), again.known(4)), (None, None));
        assert!(KeptResults::<f64>::of("other", kept).known(u64::MAX).is_none());
        assert!(KeptResults::<String>::of("one", kept).known(u64::MAX).is_none());
    }
}
